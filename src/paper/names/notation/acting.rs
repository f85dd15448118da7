//! Names that are called operators, chapter by chapter.
//!
//! **In:** a paper. **Out:** whether a side has a name that acts on what follows. **Guaranteed:** in the chapter that calls it an operator a
//! name is one, but for sections that do not call it so and print it below a fraction, where no operator stands; in another it is none
//! only where that chapter shows it as a factor with nothing behind it, and derives nothing there.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use super::super::super::mark;
use super::super::super::printed::terms;
use super::super::super::token::{self, Kind, Token};
use super::super::super::{Paper, PrintedRelation, PrintedSide};
use super::super::letters::FRACTIONS;
use super::super::{Call, names_apart, names_of};
use super::words::named_beside;
use super::{LONGEST, files, squeezed};

/// Words beside a lone name that say that it acts on what follows.
const WORDS: &[&str] = &["operator", "operators", "functional", "Operator"];
/// What an operator that is defined has beside it.
const DERIVATIVES: &[&str] = &[r"\partial", r"\nabla", r"\frac{d", r"\mathrm{d}", r"\frac{\mathrm", r"\hat", r"\int"];

/// Names that are called operators.
#[derive(Clone, Debug, Default)]
pub(super) struct Acting {
    /// The chapters that call them so.
    said: BTreeMap<String, BTreeSet<usize>>,
    /// The sections that call them so.
    said_in: BTreeSet<(usize, String)>,
    /// Sections, and the names that are printed in a denominator there.
    below: BTreeSet<(usize, String)>,
    /// Chapters, and the names that are factors there.
    factors: BTreeSet<(usize, String)>,
    /// The chapter and the section of each relation, by where it begins.
    places: BTreeMap<usize, (usize, usize)>,
}

impl Acting {
    /// The operators of a paper. One of quanta has them wherever it wants.
    pub fn of(paper: &Paper, is_quantum: bool) -> Acting {
        let places = paper.printed.iter().map(|r| (r.span().start, (r.chapter, r.section))).collect();
        let mut out = Acting { places, ..Acting::default() };
        for file in files(paper) {
            let mut inside: Vec<(usize, (usize, usize))> = Vec::new();
            for relation in &paper.printed {
                let (of, place) = paper.locate(&relation.span());
                if Arc::ptr_eq(of, &file) {
                    inside.push((place.start, (relation.chapter, relation.section)));
                }
            }
            inside.sort_unstable();
            for named in named_beside(&file.text, WORDS) {
                // A word between two chapters may be of either.
                let next = inside.partition_point(|(start, _)| *start <= named.at);
                let around = [next.checked_sub(1), Some(next)].into_iter().flatten();
                for (_, (chapter, section)) in around.filter_map(|i| inside.get(i)) {
                    out.said.entry(named.key.clone()).or_default().insert(*chapter);
                    out.said_in.insert((*section, named.key.clone()));
                }
            }
        }
        for relation in paper.printed.iter().filter(|_| !is_quantum && !out.said.is_empty()) {
            let sides = relation.sides.iter().filter(|s| s.text.len() <= LONGEST);
            out.below.extend(sides.flat_map(denominators).map(|key| (relation.section, key)));
        }
        for relation in paper.printed.iter().filter(|r| !is_quantum && !out.said.is_empty() && derives_nothing(r)) {
            for term in relation.sides.iter().filter(|s| s.text.len() <= LONGEST).flat_map(|s| terms(&s.tokens)) {
                if let Some(key) = last_factor(&term)
                    && out.said.contains_key(&key)
                {
                    out.factors.insert((relation.chapter, key));
                }
            }
        }
        out
    }

    /// Whether a side has a name that acts on what follows.
    pub fn acts_in(&self, side: &PrintedSide) -> bool {
        if self.said.is_empty() {
            return false;
        }
        let place = self.places.range(..=side.span.start).next_back();
        let (chapter, section) = place.map_or((0, 0), |(_, place)| *place);
        names_apart(side).iter().map(|n| squeezed(&n.key())).any(|key| {
            let said = self.said.get(&key);
            let own = (section, key.clone());
            let is_factor = self.below.contains(&own) && !self.said_in.contains(&own);
            !is_factor && said.is_some_and(|said| said.contains(&chapter) || !self.factors.contains(&(chapter, key)))
        })
    }
}

fn derives_nothing(relation: &PrintedRelation) -> bool {
    !relation.sides.iter().any(|s| DERIVATIVES.iter().any(|d| s.text.contains(d)))
}

/// The names that are printed in denominators of a side, but for those of derivatives.
fn denominators(side: &PrintedSide) -> Vec<String> {
    let marks = mark::marks(&side.tokens);
    let text = |i: usize| marks.get(i).map_or("", |m| m.text.as_str());
    let is_fraction = |i: &usize| text(*i).strip_prefix('\\').is_some_and(|c| FRACTIONS.contains(&c));
    let below = (0..marks.len()).filter(is_fraction).flat_map(|at| {
        let middle = mark::unit(&marks, at + 1);
        let inside: Vec<&str> =
            (middle..mark::unit(&marks, middle)).map(text).filter(|t| !matches!(*t, "{" | "}")).collect();
        let derives = inside.iter().any(|t| matches!(*t, "d" | r"\partial" | r"\mathrm" | r"\dd"));
        if derives { Vec::new() } else { names_of(&token::tokens(&inside.join(" "))) }
    });
    below.map(|n| squeezed(&n.key())).collect()
}

/// The letter with which a term ends, with nothing behind it on which it could act.
fn last_factor(term: &[Token]) -> Option<String> {
    let name = names_of(term).pop().filter(|n| n.call == Call::None && n.subscript.is_none() && n.primes == 0)?;
    let last = term.iter().rev().find(|t| !matches!(t.kind, Kind::Space | Kind::Close))?;
    let letter = name.letter.strip_prefix('\\').unwrap_or(&name.letter);
    (last.text == letter).then(|| squeezed(&name.key()))
}
