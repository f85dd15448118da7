//! How a point refutes a claim: the sides differ there, they are the same where the claim denies it, or there is no value.
//!
//! **In:** a witness. **Out:** words that every kind of report shares. "Left 1, right 1" shows nothing by itself, and what has no value
//! has no sides.

use super::numbers::{both, size};
use super::wording::label;
use derivation::FormKind;
use findings::{ClaimAccount, Witness};

/// How a point refutes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Refutes {
    /// The sides differ by more than their error bound.
    Apart,
    /// The sides are the same, within their error bound: the claim says that they are not.
    Same,
    /// Neither side has a value: the formula has none.
    NoValue,
}

impl Refutes {
    /// That of a witness.
    pub fn of(witness: &Witness) -> Refutes {
        match () {
            () if witness.left.is_nan() && witness.right.is_nan() => Refutes::NoValue,
            () if (witness.left - witness.right).abs() <= witness.bound.max(0.0) => Refutes::Same,
            () => Refutes::Apart,
        }
    }
}

/// The values of a witness in words, its strong ones given to `strong`: `left 1, right −1, error bound 0`.
pub(super) fn values(claim: &ClaimAccount, kind: FormKind, w: &Witness, strong: &dyn Fn(&str) -> String) -> String {
    let bound = if w.bound > 0.0 { format!(", error bound {}", size(w.bound)) } else { String::new() };
    values_with(claim, kind, w, &bound, strong)
}

/// The same without the error bound, for what has no room.
pub(super) fn bare_values(
    claim: &ClaimAccount,
    kind: FormKind,
    w: &Witness,
    strong: &dyn Fn(&str) -> String,
) -> String {
    values_with(claim, kind, w, "", strong)
}

fn values_with(
    claim: &ClaimAccount,
    kind: FormKind,
    w: &Witness,
    bound: &str,
    strong: &dyn Fn(&str) -> String,
) -> String {
    let (left, right) = both(w.left, w.right);
    match Refutes::of(w) {
        Refutes::NoValue => format!("{} there", strong("no value")),
        // What shall never be, and is, is so in every component.
        Refutes::Same if kind == FormKind::Never && label(&w.formula).component.is_some() => {
            format!("both sides are the same in every component, here {}{bound}", strong(&left))
        }
        Refutes::Same if kind == FormKind::Eventually && is_one_of_several(claim, w) => {
            format!("both sides are {} here, and apart in another component{bound}", strong(&left))
        }
        Refutes::Same => format!("both sides are {}{bound}", strong(&left)),
        Refutes::Apart => format!("left {}, right {}{bound}", strong(&left), strong(&right)),
    }
}

/// Whether the witness is of one of several components, or of one of several formulas.
fn is_one_of_several(claim: &ClaimAccount, w: &Witness) -> bool {
    label(&w.formula).component.is_some() || claim.formulas.len() > 1
}

#[cfg(all(test, debug_assertions))]
mod tests {
    use super::*;

    fn witness(left: f64, right: f64, bound: f64) -> Witness {
        Witness { t: 0.0, formula: r"R=1   [1, 1]".to_owned(), left, right, bound, values: Vec::new() }
    }

    #[test]
    fn a_point_says_how_it_refutes() {
        assert_eq!(Refutes::of(&witness(1.0, -1.0, 1e-15)), Refutes::Apart);
        assert_eq!(Refutes::of(&witness(1.0, 1.0, -0.0)), Refutes::Same);
        assert_eq!(Refutes::of(&witness(1.0, 1.0 + 1e-16, 1e-15)), Refutes::Same);
        assert_eq!(Refutes::of(&witness(f64::NAN, f64::NAN, 0.0)), Refutes::NoValue);
        let claim = findings::sample::account().claims.swap_remove(0);
        let says = |w: &Witness, kind| values(&claim, kind, w, &|text| format!("<{text}>"));
        assert_eq!(says(&witness(-1.0, 1.0, 0.0), FormKind::Always), "left <−1>, right <1>");
        assert_eq!(says(&witness(0.0, 0.0, 1e-15), FormKind::Always), "both sides are <0>, error bound 10⁻¹⁵");
        assert_eq!(
            says(&witness(1.0, 1.0, 0.0), FormKind::Never),
            "both sides are the same in every component, here <1>"
        );
        assert_eq!(says(&witness(f64::NAN, f64::NAN, 1.0), FormKind::Defined), "<no value> there");
    }
}
