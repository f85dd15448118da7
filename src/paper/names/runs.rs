//! Capital letters side by side that may be one name: `OPL`, an optical path length.
//!
//! **In:** the sides of a paper. **Out:** the runs of three capitals and more of which a letter is printed nowhere else, though the run is printed
//! again. **Guaranteed:** where each of its letters stands by itself somewhere, a run is a product.

use std::collections::{BTreeMap, BTreeSet};

use super::super::PrintedSide;
use super::super::mark::{self, Mark};

/// The fewest letters of such a name.
const SHORTEST: usize = 3;

/// The runs of a side: capitals with nothing between them and no style.
fn runs(side: &PrintedSide) -> (Vec<String>, Vec<String>) {
    let marks = mark::marks(&side.tokens);
    let is_capital = |m: &Mark| m.text.len() == 1 && m.text.bytes().all(|b| b.is_ascii_uppercase());
    let (mut long, mut single) = (Vec::new(), Vec::new());
    let mut run = String::new();
    for part in marks.iter().map(Some).chain([None]) {
        match part.filter(|m| is_capital(m)) {
            Some(letter) => run.push_str(&letter.text),
            None if run.len() >= SHORTEST => long.push(std::mem::take(&mut run)),
            None => single.extend(std::mem::take(&mut run).chars().map(String::from)),
        }
    }
    (long, single)
}

/// What the runs of a paper show.
#[derive(Clone, Debug, Default)]
pub struct Runs {
    long: BTreeMap<String, usize>,
    single: BTreeSet<String>,
}

impl Runs {
    /// Takes note of a side.
    pub(super) fn note(&mut self, side: &PrintedSide) {
        let (long, single) = runs(side);
        long.into_iter().for_each(|run| *self.long.entry(run).or_default() += 1);
        self.single.extend(single);
    }

    /// A run of a side that may be a name.
    pub fn name_in(&self, side: &PrintedSide) -> Option<String> {
        let is_elsewhere = |c: char, run: &str| {
            self.single.contains(c.to_string().as_str())
                || self.long.keys().any(|other| other != run && other.contains(c))
        };
        let is_repeated = |run: &str| self.long.get(run).is_some_and(|n| *n > 1);
        runs(side).0.into_iter().find(|run| is_repeated(run) && run.chars().any(|c| !is_elsewhere(c, run)))
    }
}
