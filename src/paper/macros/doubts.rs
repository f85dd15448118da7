//! Places of which it is not known whether they are printed, or as what.
//!
//! **In:** tokens of branches of conditions that are not known, and calls of macros that are defined in such. **Out:** for a place, why it is in doubt.

use std::collections::BTreeMap;
use std::ops::Range;

use super::super::short::Short;
use super::super::token::Token;
use diag::escape::in_one_line;

/// What is not known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Unknown {
    /// Which branch of a condition is printed.
    Branch,
    /// What a name stands for.
    Meaning,
    /// How much of a macro behind it a command takes.
    Reach,
}

/// Why what is printed is not known.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Doubt {
    command: Short,
    what: Unknown,
    /// Where that is told.
    pub span: Range<usize>,
}

impl Doubt {
    /// The reason, in few words.
    pub fn why(&self) -> String {
        match self.what {
            Unknown::Branch => "which branch is printed is not known".to_owned(),
            Unknown::Meaning => format!("what \\{} stands for is not known", in_one_line(&self.command)),
            Unknown::Reach => format!("how far \\{} reaches is not known", in_one_line(&self.command)),
        }
    }

    /// The same in a sentence, without its stop.
    pub fn message(&self) -> String {
        let name = in_one_line(&self.command);
        match self.what {
            Unknown::Branch => {
                format!("which branch of `\\{name}` is printed is not known: the formulas in its branches are not read")
            }
            Unknown::Meaning => format!(
                "what `\\{name}` stands for is not known: it is defined in a way, or in a place, that is not read; nor are formulas with it"
            ),
            Unknown::Reach => format!(
                "how far `\\{name}` reaches depends on packages, where a macro stands behind it: with braces around that the formula is read"
            ),
        }
    }
}

/// Places in doubt.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Doubts {
    all: Vec<Doubt>,
    /// The doubt of each macro of which the meaning is in doubt.
    of_macros: BTreeMap<String, usize>,
    places: Vec<(Range<usize>, usize)>,
    /// What is printed behind the last of them is not in doubt.
    is_apart: bool,
}

/// What may lie between two tokens of one branch: a comment, a definition.
const NEAR: usize = 100;

impl Doubts {
    /// A condition of which it is not known whether it holds: its number.
    pub(super) fn of_condition(&mut self, command: &Token, span: &Range<usize>) -> usize {
        self.add(command, Unknown::Branch, span)
    }

    /// A command of which it is not known how much of the macro behind it it takes: its number.
    pub(super) fn of_reach(&mut self, command: &Token) -> usize {
        self.add(command, Unknown::Reach, &command.span)
    }

    fn add(&mut self, command: &Token, what: Unknown, span: &Range<usize>) -> usize {
        self.all.push(Doubt { command: command.text.clone(), what, span: span.clone() });
        self.all.len() - 1
    }

    /// A name of which the meaning is in doubt: its number.
    pub(super) fn of_meaning(&mut self, token: &Token) -> usize {
        if let Some(doubt) = self.of_macros.get(token.text.as_str()) {
            return *doubt;
        }
        let doubt = self.add(token, Unknown::Meaning, &token.span);
        self.of_macros.insert(token.text.as_str().to_owned(), doubt);
        doubt
    }

    /// Notes a place that is in doubt.
    pub(super) fn note(&mut self, span: &Range<usize>, doubt: usize) {
        match self.places.last_mut() {
            Some((last, same))
                if *same == doubt && !self.is_apart && last.start <= span.start && span.start <= last.end + NEAR =>
            {
                last.end = last.end.max(span.end);
            }
            _ => self.places.push((span.clone(), doubt)),
        }
        self.is_apart = false;
    }

    /// Passes a place that is printed without a doubt.
    pub(super) fn pass(&mut self, span: &Range<usize>) {
        self.is_apart |= self.places.last().is_some_and(|(last, _)| last.end <= span.start || span.end <= last.start);
    }

    /// The same, in the order of places.
    pub(super) fn in_order(mut self) -> Doubts {
        self.places.sort_by_key(|(span, doubt)| (span.start, span.end, *doubt));
        // What ends before another that began earlier is a part of that one.
        let mut end = 0;
        self.places.retain(|(span, _)| {
            let is_new = span.end > end;
            end = end.max(span.end);
            is_new
        });
        self
    }

    /// The doubts of what names stand for, each with its number; the end of an environment is told with its beginning.
    pub fn of_names(&self) -> impl Iterator<Item = (usize, &Doubt)> {
        let is_name = |doubt: &Doubt| doubt.what == Unknown::Meaning && !doubt.command.starts_with("end");
        self.all.iter().enumerate().filter(move |(_, doubt)| is_name(doubt))
    }

    /// Why a place is in doubt, and which doubt that is.
    pub fn of(&self, span: &Range<usize>) -> Option<(usize, &Doubt)> {
        let at = self.places.partition_point(|(place, _)| place.end <= span.start);
        let (place, doubt) = self.places.get(at)?;
        if place.start >= span.end {
            return None;
        }
        self.all.get(*doubt).map(|found| (*doubt, found))
    }
}
