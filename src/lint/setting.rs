//! The setting of a relation: what its words do with it, which case it is of, what was compared or supposed before it.
//!
//! **In:** relations by their numbers. **Out:** whether something is to be kept from being used, or from being called wrong. **Guaranteed:** a
//! setting makes nothing hold.

use std::collections::BTreeSet;

use paper::{PrintedRelation, PrintedSide, names, squeezed};

use super::cases::{Cases, Stance, stance};
use super::desk::lone_name;
use super::facts::NEAR;
use super::judge::{Judge, MOST_EXPLAINED};

/// Relations on both sides of a step in which a name of it may be said to be zero.
const BESIDE: usize = 6;

/// A relation that compares, or supposes, with its names.
pub(super) struct Noted {
    pub section: usize,
    pub relation: usize,
    pub names: BTreeSet<String>,
}

/// The keys of the names of some sides.
fn keys(sides: [&PrintedSide; 2]) -> BTreeSet<String> {
    sides.into_iter().flat_map(names).map(|n| n.key()).collect()
}

impl Judge<'_> {
    /// What the words of its sentence do with a relation.
    pub(super) fn stance(&self, relation: &PrintedRelation) -> Stance {
        let remark = relation.remark.as_deref().unwrap_or_default().to_lowercase();
        if ["wrong", "false", "incorrect", "not true"].iter().any(|w| remark.contains(w)) {
            return Stance::Denied;
        }
        let (file, span) = self.paper.locate(&relation.span());
        stance(&file.text, span.start, span.end)
    }

    /// Whether a relation stands in a display with "or" between its formulas.
    pub(super) fn is_alternative(&self, at: usize) -> bool {
        let has_or = |r: &PrintedRelation| {
            r.remark.as_deref().is_some_and(|words| words.split(|c: char| !c.is_alphabetic()).any(|w| w == "or"))
        };
        let all = &self.paper.printed;
        let relation = &all[at];
        let same = |r: &&PrintedRelation| r.display == relation.display;
        let before = all[..at].iter().rev().take_while(same).take(MOST_EXPLAINED);
        let here = before.chain(all[at..].iter().take_while(same).take(MOST_EXPLAINED));
        relation.display.is_some() && relation.sides.len() == 2 && here.into_iter().any(has_or)
    }

    /// Whether what one relation says may be of another case than a later one.
    pub(super) fn are_parted(&mut self, before: usize, at: usize, is_sure: bool) -> bool {
        let place = |k: usize| self.paper.locate(&self.paper.printed[k].span());
        let ((file, from), (other, to)) = (place(before), place(at));
        if !std::sync::Arc::ptr_eq(file, other) || before >= at {
            return false;
        }
        let known = self.cases.iter().position(|(f, _)| std::sync::Arc::ptr_eq(f, file));
        let known = known.unwrap_or_else(|| {
            self.cases.push((file.clone(), Cases::of(&file.text)));
            self.cases.len() - 1
        });
        self.cases[known].1.parted(from.start, to.start, is_sure)
    }

    /// Whether an equation between the names of some sides is supposed before, in this section: the sides may be equal just then.
    pub(super) fn is_supposed_of(&self, sides: [&PrintedSide; 2], at: usize) -> bool {
        let own = keys(sides);
        self.near(&self.supposed, at).any(|all| all.len() > 1 && all.is_subset(&own))
    }

    /// Whether a name of some sides is said to be zero near them, before or behind, or is cancelled in print.
    pub(super) fn has_vanishing(&self, sides: [&PrintedSide; 2], at: usize) -> bool {
        let own = keys(sides);
        let is_zero = |r: &PrintedRelation| match r.sides.as_slice() {
            [left, right] => {
                r.signs[0] == "="
                    && squeezed(&right.text) == "0"
                    && lone_name(left).is_some_and(|n| own.contains(&n.key()))
            }
            _ => false,
        };
        let relation = &self.paper.printed[at];
        let (from, to) = (at.saturating_sub(BESIDE), (at + BESIDE + 1).min(self.paper.printed.len()));
        let near = &self.paper.printed[from..to];
        let (file, span) = self.paper.locate(&relation.span());
        let source = file.text.get(span).unwrap_or_default();
        let crossed = [r"\cancel", "=0}", "= 0}", r"\xcancel", r"\sout", r"\not{"].iter().any(|w| source.contains(w));
        crossed || near.iter().filter(|r| r.section == relation.section).any(is_zero)
    }

    /// The display of a relation.
    pub(super) fn display_of(&self, at: usize) -> Option<usize> {
        self.paper.printed[at].display
    }

    /// Whether a comparison before, in this section, is about a name of some sides.
    pub(super) fn is_compared(&self, sides: [&PrintedSide; 2], at: usize) -> bool {
        let own = keys(sides);
        self.near(&self.compared, at).any(|all| !all.is_disjoint(&own))
    }

    /// The names of what was noted near before a relation, in this section.
    fn near<'n>(&self, noted: &'n [Noted], at: usize) -> impl Iterator<Item = &'n BTreeSet<String>> {
        let section = self.section;
        let is_near = move |n: &&Noted| n.section == section && n.relation < at && n.relation + NEAR >= at;
        noted.iter().filter(is_near).map(|n| &n.names)
    }
}
