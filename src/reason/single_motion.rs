//! What one motion alone could have decided.

use thiserror::Error;

/// What would be known without the other motions.
#[derive(Clone, Debug, Default, PartialEq, Eq, Error)]
#[error(
    "`{trajectory}` alone: of {}, {not_applicable} do not apply to it, and {holds} hold; {}, and {weak} hold weakly. Of {of} altered \
     formulas of these claims, {} would have held as well.",
    claims(*.tried),
    fail(.misleading),
    .of - .rejected
)]
pub struct Alone {
    /// Its id.
    pub trajectory: String,
    /// Claims that were tried on it.
    pub tried: usize,
    /// Claims that do not apply to it.
    pub not_applicable: usize,
    /// Claims that hold on it.
    pub holds: usize,
    /// Claims that hold on it and fail on others: names.
    pub misleading: Vec<String>,
    /// Claims that hold on it, but weakly.
    pub weak: usize,
    /// Altered formulas of the claims that hold on it which it rejects.
    pub rejected: usize,
    /// Altered formulas of the claims that hold on it.
    pub of: usize,
}

impl Alone {
    /// The share of the altered formulas that is rejected; 1 where there are none.
    pub fn share(&self) -> f64 {
        if self.of == 0 { 1.0 } else { self.rejected as f64 / self.of as f64 }
    }
}

fn claims(n: usize) -> String {
    if n == 1 { "one claim".to_owned() } else { format!("{n} claims") }
}

fn fail(misleading: &[String]) -> String {
    match misleading {
        [] => "none of them fails elsewhere".to_owned(),
        [one] => format!("one of them fails elsewhere (`{one}`)"),
        many => format!("{} of them fail elsewhere", many.len()),
    }
}
