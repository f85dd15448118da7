//! Whether the formulas are consistent in their units.

use super::{UnitsVerdict, objects};
use findings::units::{Term, UnitAccount, UnitVerdict, UnitsAccount};

objects! {
    /// The units of a derivation.
    Units<'a> of (of: &'a UnitsAccount) {
        /// Formulas that are consistent.
        consistent: usize = of.count("consistent"),
        /// Formulas that are not.
        inconsistent: usize = of.count("inconsistent"),
        /// Formulas without enough units.
        not_checked: usize = of.count("not-checked"),
        /// Of the inconsistent ones, not expected; and expected ones that are consistent.
        unexpected: usize = of.unexpected(),
        /// Claims that were expected to be inconsistent, and are not.
        missed: &'a [String] = &of.missed,
        /// Every formula, in the order of the file; none where no symbol has a unit.
        formulas: Vec<UnitsOfFormula<'a>> = of.formulas.iter().map(UnitsOfFormula::of).collect(),
    }

    /// The units of a formula.
    UnitsOfFormula<'a> of (of: &'a UnitAccount) let (difference, why) = found(&of.verdict); {
        /// Claim, system, definition, …
        r#where: &'static str = of.kind,
        /// Its id or name.
        of: &'a str = &of.of,
        /// As written.
        formula: &'a str = &of.formula,
        /// Whether they agree.
        verdict: UnitsVerdict = UnitsVerdict(of.verdict.word()),
        /// Whether the verdict is as expected.
        expected: bool = of.expected,
        /// What does not agree.
        relation: Option<&'a str> = difference.map(|(relation, _)| relation),
        /// The two terms that do not.
        terms: Option<[UnitsOfTerm<'a>; 2]> = difference.map(|(_, terms)| terms.each_ref().map(UnitsOfTerm::of)),
        /// Why it was not checked.
        reason: Option<&'a str> = why,
    }

    /// The unit of a term.
    UnitsOfTerm<'a> of (of: &'a Term) {
        /// A term.
        latex: &'a str = &of.latex,
        /// Its unit.
        unit: &'a str = &of.unit,
    }
}

/// What two terms have to do with one another, and the two.
type Difference<'a> = (&'a str, &'a [Term; 2]);

fn found(of: &UnitVerdict) -> (Option<Difference<'_>>, Option<&str>) {
    match of {
        UnitVerdict::Consistent => (None, None),
        UnitVerdict::Inconsistent { relation, terms } => (Some((relation, terms)), None),
        UnitVerdict::NotChecked { reason } => (None, Some(reason)),
    }
}
