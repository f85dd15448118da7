//! What altered formulas say of the evidence, and what a claim that fails should have said.

use super::value::{Strength, objects};
use findings::SEED;

objects! {
    /// How many altered formulas the evidence of a verdict rejects.
    Discrimination of (of: &findings::Discrimination) {
        /// Variants of the claim that the same evidence rejects.
        rejected: usize = of.rejected,
        /// Variants that were tried.
        of: usize = of.of,
        /// Whether so few are rejected that the verdict says little.
        weak: bool = of.is_weak(),
        /// Numbers in `variants.survivors`, in ranges, such as 0-3,7.
        survivors: String = ranges(&of.survivors),
    }

    /// What single edits of a claim's formulas say of the evidence, and what it should have said.
    Variants<'a> of (of: &'a findings::VariantAccount) {
        /// The start of the generator of points.
        seed: u64 = SEED,
        /// How many variants all motions together reject.
        together: Option<Share> = of.together().map(Share::of),
        /// The fewest motions that reject as many.
        smallest_set: SmallestSet<'a> = SmallestSet::of(of),
        /// Counts, by what was edited.
        classes: Vec<Class> = of.classes.iter().map(Class::of).collect(),
        /// Formulas without variants.
        skipped: Vec<Skipped<'a>> = of.skipped.iter().map(Skipped::of).collect(),
        /// Variants that some motion does not reject.
        survivors: Vec<Survivor<'a>> = of.survivors.iter().map(Survivor::of).collect(),
        /// What the claim should have said, where it fails.
        erratum: Option<Erratum<'a>> = of.erratum.as_ref().map(Erratum::of),
    }

    /// A part of the variants.
    Share of (of: (usize, usize)) {
        /// Rejected by some motion.
        rejected: usize = of.0,
        /// Variants.
        of: usize = of.1,
    }

    /// Motions that suffice.
    SmallestSet<'a> of (of: &'a findings::VariantAccount) {
        /// Their ids.
        trajectories: &'a [String] = &of.cover,
        /// Whether no smaller set does.
        least: bool = of.cover_is_least,
    }

    /// What became of the edits of one class.
    Class of (of: &findings::ClassCount) {
        /// What was edited.
        class: &'static str = of.class.word(),
        /// Edits.
        generated: usize = of.generated,
        /// Of these, without a meaning.
        meaningless: usize = of.meaningless,
        /// Of these, the same as one before.
        repeated: usize = of.repeated,
        /// Of these, the same as the print.
        equivalent: usize = of.equivalent,
        /// Of these, saying nothing.
        empty: usize = of.empty,
        /// Of these, tried.
        kept: usize = of.kept,
    }

    /// A formula without variants.
    Skipped<'a> of (of: &'a (String, String)) {
        /// As written.
        formula: &'a str = &of.0,
        /// Why.
        reason: &'a str = &of.1,
    }

    /// A variant that some motion does not tell from the claim.
    Survivor<'a> of (of: &'a findings::Survivor) {
        /// What was edited.
        class: &'static str = of.class.word(),
        /// In LaTeX.
        formula: &'a str = &of.formula,
        /// Whether no motion rejects it.
        everywhere: bool = of.everywhere,
    }

    /// What a claim should have said, as far as one or two edits reach.
    Erratum<'a> of (of: &'a findings::Erratum) {
        /// Formulas that hold instead, the closest to the print first.
        corrections: Vec<Correction<'a>> = of.corrections.iter().map(Correction::of).collect(),
        /// How many altered formulas were tried.
        tried: Tried = Tried::of(of.tried),
        /// Why there is none, or not all were tried.
        remark: Option<&'a str> = of.remark.as_deref(),
        /// Of a quantity that is said to be constant and is not: an equation that says its rate by one term, which is proved.
        rate: Option<&'a str> = of.rate.as_deref(),
    }

    /// A formula that holds where the printed one does not.
    Correction<'a> of (of: &'a findings::Correction) {
        /// The formula as printed.
        printed: &'a str = &of.printed,
        /// The formula as it would hold.
        formula: &'a str = &of.formula,
        /// Both in one: what goes, what comes.
        difference: &'a str = &of.difference,
        /// What was edited.
        classes: Vec<&'static str> = of.classes.iter().map(|c| c.word()).collect(),
        /// Whether it was proved for all values.
        proved: bool = of.strength == verdict::Strength::Proved,
        /// The weakest strength with which it holds on one of them.
        strength: Option<Strength> = verdict::Outcome::Holds(of.strength).strength().map(Strength),
        /// Trajectories on which it holds; 0 where it holds over ranges or for all fields.
        holds_on: usize = of.holds_on,
    }

    /// Altered formulas that were tried.
    Tried of (of: (usize, usize, usize)) {
        /// Single edits.
        single: usize = of.0,
        /// Missing factors and terms.
        completions: usize = of.1,
        /// Pairs of edits.
        pairs: usize = of.2,
    }

    /// What one motion alone could have decided.
    Alone of (of: reason::Alone) let sentence = of.to_string(); {
        /// Its id.
        trajectory: String = of.trajectory,
        /// Claims that were tried on it.
        tried: usize = of.tried,
        /// Claims that do not apply to it.
        not_applicable: usize = of.not_applicable,
        /// Claims that hold on it.
        holds: usize = of.holds,
        /// Claims that hold on it and fail on others.
        misleading: Vec<String> = of.misleading,
        /// Claims that hold on it weakly.
        weak: usize = of.weak,
        /// Altered formulas of the claims that hold on it which it rejects.
        rejected: usize = of.rejected,
        /// Altered formulas of the claims that hold on it.
        of: usize = of.of,
        /// The same in words.
        sentence: String = sentence,
    }
}

/// Increasing numbers as ranges: `0-3,7`.
fn ranges(numbers: &[usize]) -> String {
    let mut out: Vec<String> = Vec::new();
    let mut at = 0;
    while let Some(&from) = numbers.get(at) {
        let mut to = from;
        while numbers.get(at + 1) == Some(&(to + 1)) {
            to += 1;
            at += 1;
        }
        out.push(if from == to { from.to_string() } else { format!("{from}-{to}") });
        at += 1;
    }
    out.join(",")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_in_ranges() {
        assert_eq!(ranges(&[]), "");
        assert_eq!(ranges(&[4]), "4");
        assert_eq!(ranges(&[0, 1, 2, 5, 7, 8]), "0-2,5,7-8");
    }
}
