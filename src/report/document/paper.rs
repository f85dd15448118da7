//! The comparison with the paper. Its path is not in it.

use super::objects;
use crate::paper::line;
use ::paper::{Comparison, Coverage, Difference, UnknownLabel};

objects! {
    /// What the derivation file says against what the paper prints.
    Paper<'a> of (of: &'a Comparison) {
        /// SHA-256 of the paper's source.
        sha256: &'a str = &of.sha256,
        /// Formulas that were compared.
        compared: usize = of.compared,
        /// Formulas that are not printed so.
        differences: Vec<Printed<'a>> = of.differences.iter().map(|d| Printed::of(of, d)).collect(),
        /// Labels that the paper does not have.
        unknown_labels: Vec<Unknown<'a>> = of.unknown.iter().map(Unknown::of).collect(),
        /// The displayed equations.
        equations: Vec<Displayed<'a>> = of.equations.iter().map(|e| Displayed::of(of, e)).collect(),
        /// How much of the paper the derivation file has.
        coverage: Covered = Covered::of(of),
    }

    /// A formula that is printed in another way.
    Printed<'a> of (all: &Comparison, of: &'a Difference) {
        /// Who has the formula.
        claim: &'a str = &of.owner,
        /// The label that it names.
        label: &'a str = &of.label,
        /// As the derivation file has it.
        formula: &'a str = &of.formula,
        /// What the paper prints.
        printed: &'a str = &of.printed,
        /// Line of the paper.
        line: usize = line(all, &of.there),
    }

    /// A label that the paper does not have.
    Unknown<'a> of (of: &'a UnknownLabel) {
        /// Who names it.
        claim: &'a str = &of.owner,
        /// The label.
        label: &'a str = &of.label,
    }

    /// A displayed equation of the paper.
    Displayed<'a> of (all: &Comparison, of: &'a Coverage) {
        /// Its label.
        label: Option<&'a str> = of.label.as_deref(),
        /// Line of the paper.
        line: usize = line(all, &of.span),
        /// How many parts it has.
        parts: usize = of.parts,
        /// How many of them the derivation file has as printed.
        printed: usize = of.printed,
        /// Claims and systems that are about it.
        claims: &'a [String] = &of.by,
    }

    /// How much of a paper a derivation file has.
    Covered of (of: &Comparison) let (all, as_printed) = of.covered(); {
        /// Displayed equations.
        equations: usize = of.equations.len(),
        /// Of these, covered.
        covered: usize = all,
        /// Parts of the displayed equations.
        parts: usize = of.parts(),
        /// Of these, in the derivation file as printed.
        printed: usize = as_printed,
        /// Relations of the running text.
        relations: usize = of.relations.len(),
        /// Of these, in the derivation file word for word.
        found: usize = of.found(),
    }
}
