//! What the whole paper shows of its names.

use std::collections::{BTreeMap, BTreeSet};

use super::super::Paper;
use super::super::printed::PrintedRelation;
use super::{Call, names};

/// Longest side, in bytes, that is looked at.
const LONGEST: usize = 20_000;

/// What the whole paper shows of its names.
#[derive(Clone, Debug, Default)]
pub struct Evidence {
    /// Keys with a dot or a derivative by time somewhere.
    pub moving: BTreeSet<String>,
    /// What the names are derived by, not partially.
    pub derived: BTreeMap<String, BTreeSet<String>>,
    /// What they are derived by partially.
    pub partial: BTreeMap<String, BTreeSet<String>>,
    /// For each name what stands in parentheses behind it, and how often; with `None` how often nothing does.
    pub calls: BTreeMap<String, BTreeMap<Option<Vec<String>>, usize>>,
    /// Letters that are used as operators: with a hat.
    pub hats: BTreeSet<String>,
    /// Whether a letter is printed in bold somewhere.
    pub bold: BTreeSet<String>,
    /// Letters, without backslash, with a place in parentheses behind them somewhere.
    pub functions: BTreeSet<String>,
    /// Subscripts of each letter.
    pub subscripts: BTreeMap<String, BTreeSet<String>>,
}

impl Evidence {
    /// The evidence of a paper.
    pub fn of(paper: &Paper) -> Evidence {
        let mut out = Evidence::default();
        for relation in &paper.printed {
            out.note(relation);
        }
        out
    }

    /// Whether a letter, however it is styled and whatever stands below it, is printed with a place in parentheses behind it: it may be
    /// a function.
    pub fn may_be_function(&self, letter: &str) -> bool {
        self.functions.contains(letter)
    }

    /// Whether the subscripts of a letter are indices of its components: all could be, and one is a letter that is used so.
    pub fn has_indices(&self, letter: &str) -> bool {
        let Some(all) = self.subscripts.get(letter) else { return false };
        let could = |s: &String| (1..=2).contains(&s.chars().count()) && s.chars().all(|c| "ijklmnpqrs123".contains(c));
        let is = |s: &String| s.chars().any(|c| "ijkl".contains(c));
        all.iter().all(could) && all.iter().any(is)
    }

    fn note(&mut self, relation: &PrintedRelation) {
        for name in relation.sides.iter().filter(|s| s.text.len() <= LONGEST).flat_map(names) {
            let key = name.key();
            if name.dots > 0 || name.derived_by.as_deref() == Some("t") && !name.is_partial {
                self.moving.insert(key.clone());
            }
            if let Some(by) = &name.derived_by {
                let seen = if name.is_partial { &mut self.partial } else { &mut self.derived };
                seen.entry(key.clone()).or_default().insert(by.clone());
            }
            let call = match &name.call {
                Call::Places(places) => Some(Some(places.clone())),
                Call::None => Some(None),
                Call::Other => None,
            };
            if let Some(call) = call {
                *self.calls.entry(key).or_default().entry(call).or_default() += 1;
            }
            if let Call::Places(places) = &name.call
                && places.iter().any(|p| !p.chars().all(|c| c.is_ascii_digit()))
            {
                self.functions.insert(name.letter.trim_start_matches('\\').to_owned());
            }
            if name.has_hat {
                self.hats.insert(name.letter.clone());
            }
            if name.is_bold {
                self.bold.insert(name.letter.clone());
            }
            if let Some(sub) = &name.subscript {
                self.subscripts.entry(name.letter.clone()).or_default().insert(sub.clone());
            }
        }
    }
}
