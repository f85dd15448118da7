//! A first derivation file from a paper: what can be copied is copied, what is guessed is marked.
//!
//! **In:** a [`Paper`]. **Out:** a [`Draft`]: a derivation file that loads. **Guaranteed:** every printed formula is in it: as a claim, or in a
//! comment with the reason. Each is read by itself first, with the guesses that it needs; what it needs otherwise than the rest of
//! the file stands in its own claim, so that no formula is lost because of another one, or read otherwise. It decides nothing, since
//! it has no motions: every guess waits for a person.

mod average;
mod declared;
mod formula;
mod guess;
mod index;
mod obstacle;
mod places;
mod readings;
mod settle;
mod spelling;
mod system;
mod write;

use std::collections::BTreeMap;

use super::Paper;
use super::names::{Evidence, Notation};
use formula::{Formula, Printed};
use guess::{Place, Reading};
use settle::Settled;

/// The draft of a derivation file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Draft {
    /// Its text.
    pub text: String,
    /// How many equations the paper displays.
    pub equations: usize,
    /// How many formulas it has: relations between two sides.
    pub formulas: usize,
    /// How many more stand in comments, because they cannot be read.
    pub refused: usize,
    /// How many expressions the paper displays that relate nothing; they stand in comments, too.
    pub expressions: usize,
    /// How many symbols were guessed.
    pub symbols: usize,
    /// Each guess in one line: the symbol, what it is taken for, and why.
    pub guesses: Vec<String>,
}

impl Draft {
    /// How much was found, and what is to be done with it.
    pub fn summary(&self) -> String {
        let Draft { equations, formulas, refused, expressions, symbols, .. } = self;
        format!(
            "{equations} equations, {formulas} formulas, {refused} more that cannot be read yet, {expressions} expressions that relate nothing, \
             {symbols} symbols guessed\nLook for `confirm` in it: the symbols, the system and the motion are guesses."
        )
    }
}

/// The most rounds of loading: each takes back a guess, or puts formulas into comments.
const MOST_ROUNDS: usize = 200;

/// A derivation file for a paper, to be confirmed and completed. `name` is what the paper's file is called in it.
pub fn draft(paper: &Paper, name: &str) -> Draft {
    let evidence = Evidence::of(paper);
    let notation = Notation::of(paper);
    let is_of_indices = index::is_of_indices(&paper.printed, &evidence);
    let mut all = formula::displays(paper);
    let mut known: BTreeMap<(String, Place), Result<Vec<Reading>, String>> = BTreeMap::new();
    for printed in &mut all {
        printed.read(&notation, &mut |sides, text, place| {
            let found = known.entry((text.to_owned(), place));
            found.or_insert_with(|| formula::alone(sides, text, (&evidence, &notation), is_of_indices, place)).clone()
        });
    }
    let mut settled = Settled::of(&mut all);
    let head = write::Head { paper, name };
    let mut text = String::new();
    for round in 0..=MOST_ROUNDS {
        text = write::written(&head, &settled, &mut all, None);
        let Err(found) = formula::load(&text) else { break };
        let problem = round == MOST_ROUNDS || !settled.taken_back(&found, &mut all);
        if problem && formulas(&mut all).all(|f| f.refused.is_some()) {
            // Nothing is left that could be taken back: a file that is too long, for instance.
            break;
        }
        if problem {
            // A problem that belongs to no formula and to no guess: nothing is kept that could be wrong.
            formulas(&mut all).for_each(|f| {
                f.refused.get_or_insert_with(|| "the file could not be loaded with it".to_owned());
            });
            settled = Settled::default();
        }
    }
    // The motion, where the file loads with it.
    if let Some(system) = system::System::of(&all, &settled) {
        let with = write::written(&head, &settled, &mut all, Some(&system));
        if formula::load(&with).is_ok() {
            text = with;
        }
    }
    let read = |is_read: bool| -> usize {
        let all = all.iter().flat_map(|p| &p.formulas).filter(|f| f.refused.is_none() == is_read);
        all.map(|f| f.steps).sum()
    };
    Draft {
        equations: paper.equations.len(),
        formulas: read(true),
        refused: read(false),
        expressions: all.iter().map(|p| p.expressions.len()).sum(),
        symbols: text.lines().filter(|l| l.contains("role = \"")).count(),
        guesses: write::guesses(&text),
        text,
    }
}

fn formulas(all: &mut [Printed]) -> impl Iterator<Item = &mut Formula> {
    all.iter_mut().flat_map(|p| &mut p.formulas)
}
