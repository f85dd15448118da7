//! What one motion alone could have decided.
//!
//! **In:** an [`Account`] with the discrimination of its pairs. **Out:** for each motion what would be known without the others:
//! how many claims do not apply to it, which hold on it and fail elsewhere, and how many of the altered formulas of those that
//! hold would hold as well.

use crate::{Account, ClaimAccount, PairAccount, WEAK};
use verdict::Outcome;

/// What one motion alone could have decided.
#[derive(Clone, Debug, PartialEq, Eq)]
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

    /// In one sentence.
    pub fn sentence(&self) -> String {
        let Alone { trajectory, tried, not_applicable, holds, misleading, weak, rejected, of } = self;
        let claims = |n: usize| if n == 1 { "one claim".to_owned() } else { format!("{n} claims") };
        let fail = match misleading.len() {
            0 => "none of them fails elsewhere".to_owned(),
            1 => format!("one of them fails elsewhere (`{}`)", misleading[0]),
            n => format!("{n} of them fail elsewhere"),
        };
        format!(
            "`{trajectory}` alone: of {}, {not_applicable} do not apply to it, and {holds} hold; {fail}, and {weak} hold \
             weakly. Of {of} altered formulas of these claims, {} would have held as well.",
            claims(*tried),
            of - rejected
        )
    }
}

fn name(claim: &ClaimAccount) -> String {
    match &claim.reading {
        Some(reading) => format!("{}/{reading}", claim.id),
        None => claim.id.clone(),
    }
}

impl Account {
    /// What each motion alone could have decided, in the order of the motions; empty where no variants were tried.
    pub fn alone(&self) -> Vec<Alone> {
        if self.claims.iter().all(|c| c.variants.is_none()) {
            return Vec::new();
        }
        self.trajectories.iter().map(|t| self.of_one(&t.id)).collect()
    }

    fn of_one(&self, trajectory: &str) -> Alone {
        let mut out = Alone {
            trajectory: trajectory.to_owned(),
            tried: 0,
            not_applicable: 0,
            holds: 0,
            misleading: Vec::new(),
            weak: 0,
            rejected: 0,
            of: 0,
        };
        for claim in &self.claims {
            let Some(pair) = claim.on(trajectory) else { continue };
            out.tried += 1;
            match pair.verdict.outcome() {
                Outcome::NotApplicable(_) => out.not_applicable += 1,
                Outcome::Holds(_) => {
                    out.holds += 1;
                    let fails = |p: &PairAccount| matches!(p.verdict.outcome(), Outcome::Fails(_));
                    if claim.results.iter().any(fails) {
                        out.misleading.push(name(claim));
                    }
                    if let Some(d) = &pair.discrimination {
                        out.weak += usize::from(d.is_weak());
                        out.rejected += d.rejected;
                        out.of += d.of;
                    }
                }
                Outcome::Fails(_) | Outcome::Undecided => {}
            }
        }
        out
    }

    /// The motions that decide little by themselves, the poorest first: those that reject so few of the altered formulas that a
    /// single verdict would be called weak, and the poorest in any case. Empty where there is only one motion, or no altered
    /// formula.
    pub fn poor(&self) -> Vec<Alone> {
        let mut all = self.alone();
        if all.len() < 2 {
            return Vec::new();
        }
        all.retain(|a| a.of > 0);
        all.sort_by(|a, b| a.share().total_cmp(&b.share()));
        let poor = all.iter().take_while(|a| a.share() < WEAK).count();
        all.truncate(poor.max(1));
        all
    }
}
