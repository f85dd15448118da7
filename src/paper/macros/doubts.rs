//! Places of which it is not known whether they are printed, or as what.
//!
//! **In:** tokens of branches of conditions that are not known, and calls of macros that are defined in such. **Out:** for a place, why it is in doubt.

use std::collections::BTreeMap;
use std::ops::Range;

use super::super::short::Short;
use super::super::token::Token;
use diag::escape::in_one_line;

/// Why what is printed is not known.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Doubt {
    command: Short,
    is_condition: bool,
    /// Where that is told.
    pub span: Range<usize>,
}

impl Doubt {
    /// The reason, in few words.
    pub fn why(&self) -> String {
        match self.is_condition {
            true => "which branch is printed is not known".to_owned(),
            false => format!("what \\{} stands for is not known", in_one_line(&self.command)),
        }
    }

    /// The same in a sentence, without its stop.
    pub fn message(&self) -> String {
        let name = in_one_line(&self.command);
        match self.is_condition {
            true => {
                format!("which branch of `\\{name}` is printed is not known: the formulas in its branches are not read")
            }
            false => format!(
                "what `\\{name}` stands for is not known: it is defined where a branch, or an `\\edef`, is not read; nor are formulas with it"
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
}

/// What may lie between two tokens of one branch: a comment, a definition.
const NEAR: usize = 100;

impl Doubts {
    /// A condition of which it is not known whether it holds: its number.
    pub(super) fn of_condition(&mut self, command: &Token, span: &Range<usize>) -> usize {
        self.all.push(Doubt { command: command.text.clone(), is_condition: true, span: span.clone() });
        self.all.len() - 1
    }

    /// A call of a macro of which the meaning is in doubt.
    pub(super) fn note_meaning(&mut self, token: &Token) {
        let next = self.all.len();
        let doubt = *self.of_macros.entry(token.text.as_str().to_owned()).or_insert(next);
        if doubt == next {
            self.all.push(Doubt { command: token.text.clone(), is_condition: false, span: token.span.clone() });
        }
        self.note(&token.span, doubt);
    }

    /// Notes a place that is in doubt.
    pub(super) fn note(&mut self, span: &Range<usize>, doubt: usize) {
        match self.places.last_mut() {
            Some((last, same)) if *same == doubt && last.start <= span.start && span.start <= last.end + NEAR => {
                last.end = last.end.max(span.end);
            }
            _ => self.places.push((span.clone(), doubt)),
        }
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
