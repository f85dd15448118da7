//! Pairs of edits.

use super::generate::{ClaimVariants, Formula, Variant};
use super::ranked::Made;
use super::sites::Sites;
use super::vocabulary::Vocabulary;

/// Pairs of edits of a formula: every edit of every variant of it, thinned evenly where there are too many.
pub(super) struct Pairs<'a> {
    formulas: &'a [Formula],
    vocabulary: &'a Vocabulary,
    /// The variants that are left.
    of: std::vec::IntoIter<&'a Variant>,
    /// Pairs that may still be made of them.
    room: usize,
    /// Those of one variant.
    made: std::vec::IntoIter<Made>,
}

impl<'a> Pairs<'a> {
    /// Those of the variants of a formula, at most so many.
    pub fn new(variants: &'a ClaimVariants, f: usize, vocabulary: &'a Vocabulary, room: usize) -> Pairs<'a> {
        let of: Vec<&Variant> = variants.variants.iter().filter(|v| v.formula == f).collect();
        Pairs { formulas: &variants.formulas, vocabulary, of: of.into_iter(), room, made: Vec::new().into_iter() }
    }
}

impl Iterator for Pairs<'_> {
    type Item = Made;

    fn next(&mut self) -> Option<Made> {
        loop {
            if let Some(made) = self.made.next() {
                return Some(made);
            }
            // The same share of each variant's edits.
            let share = self.room / self.of.len().max(1);
            let variant = self.of.next()?;
            let tree = variant.tree(self.formulas);
            let sites = Sites::new(&tree, self.vocabulary);
            let step = sites.count().div_ceil(share.max(1)).max(1);
            let edits = sites.at(&mut (0..sites.count()).step_by(step).take(self.room));
            self.room -= edits.len();
            let made = edits.into_iter().map(|edit| (vec![variant.class, edit.class], edit.apply(&tree)));
            self.made = made.collect::<Vec<Made>>().into_iter();
        }
    }
}
