//! The setting of a relation: what its words do with it, which case it is of, what was compared or supposed before it.
//!
//! **In:** relations by their numbers. **Out:** whether something is to be kept from being used, or from being called wrong. **Guaranteed:** a
//! setting makes nothing hold.

use std::collections::BTreeSet;

use paper::{Call, Opening, PaperName, PrintedRelation, PrintedSide, names, squeezed};

use super::cases::{Cases, Stance, stance};
use super::desk::Given;
use super::facts::{NEAR, Stated};
use super::judge::{Judge, MOST_EXPLAINED};
use super::lone::lone_name;
use super::question::{Positive, Rests};
use super::standing::{Standing, is_equation};

/// Relations on both sides of a step in which a name of it may be said to be zero.
pub(super) const BESIDE: usize = 6;

/// Words beside a formula of a display that deny it.
const DENIES: &[&str] = &["wrong", "false", "incorrect", "not true", "contradiction", "absurd"];

/// A relation that compares, or supposes, with its names.
pub(super) struct Noted {
    pub section: usize,
    pub relation: usize,
    pub names: BTreeSet<String>,
}

/// The keys of the names of some sides.
pub(super) fn keys(sides: [&PrintedSide; 2]) -> BTreeSet<String> {
    sides.into_iter().flat_map(names).map(|n| n.key()).collect()
}

impl Judge<'_> {
    /// What the words of its sentence do with a relation.
    pub(super) fn stance(&self, relation: &PrintedRelation, at: usize) -> Stance {
        let denies = |r: &PrintedRelation| {
            let remark = r.remark.as_deref().unwrap_or_default().to_lowercase();
            DENIES.iter().any(|w| remark.contains(w))
        };
        // What is led to something false, in the same display, is supposed.
        let leads = |r: &PrintedRelation| r.remark.as_deref().is_some_and(|words| words.contains('⇒'));
        let same = |r: &&PrintedRelation| r.display.is_some() && r.display == relation.display;
        let behind = self.paper.printed[at + 1..].iter().take_while(same).take(MOST_EXPLAINED);
        if denies(relation) || behind.into_iter().take_while(|r| leads(r)).any(denies) {
            return Stance::Denied;
        }
        let (file, span) = self.paper.locate(&relation.span());
        stance(&file.text, span.start, span.end)
    }

    /// Forgets what the names were that a quantifier binds, `\exists y\in R`: there they stand for another thing.
    pub(super) fn unbind(&mut self, relation: &PrintedRelation) {
        let is_set = relation.signs.first().is_some_and(|sign| sign == r"\in");
        let binds = |s: &&PrintedSide| [r"\exists", r"\forall"].iter().any(|q| s.text.trim_start().starts_with(q));
        let bound = relation.sides.first().filter(|s| is_set && binds(s));
        let keys: BTreeSet<String> = bound.into_iter().flat_map(names).map(|n| n.key()).collect();
        keys.iter().for_each(|key| self.facts.given.forget(key, false));
        if !keys.is_empty() {
            self.facts.stated.retain(|s| s.names.is_disjoint(&keys));
        }
    }

    /// Notes the names of an equation that is supposed.
    pub(super) fn suppose(&mut self, relation: &PrintedRelation, at: usize) {
        if is_equation(relation) {
            let names = relation.sides.iter().flat_map(names).map(|n| n.key()).collect();
            self.supposed.push(Noted { section: self.section, relation: at, names });
        }
    }

    /// Whether names may not be positive where they stand.
    pub(super) fn may_be_negative<'k>(&self, mut keys: impl Iterator<Item = &'k String>) -> bool {
        self.unsigned.get(&self.section).is_some_and(|found| keys.any(|key| found.not_positive.contains(key)))
    }

    /// Whether names may not be real where they stand.
    pub(super) fn may_be_complex<'k>(&self, mut keys: impl Iterator<Item = &'k String>) -> bool {
        self.unsigned.get(&self.section).is_some_and(|found| keys.any(|key| found.not_real.contains(key)))
    }

    /// Notes names that are said to be positive.
    pub(super) fn note_signs(&mut self, relation: &PrintedRelation, at: usize) {
        for (k, sign) in relation.signs.iter().enumerate() {
            let (left, right) = (&relation.sides[k], &relation.sides[k + 1]);
            let larger = match sign.as_str() {
                ">" | r"\gt" if right.text.trim() == "0" => left,
                "<" | r"\lt" if left.text.trim() == "0" => right,
                _ => continue,
            };
            let all = names(larger);
            let lone = lone_name(larger).into_iter().map(|n| n.key()).collect::<Vec<_>>();
            let keys = if larger.is_list { all.iter().map(|n| n.key()).collect() } else { lone };
            self.facts.be_positive(self.parts[at], keys);
        }
    }

    /// Whether "or" stands alone between a relation and the one before it, which has the same left side.
    fn is_offered(&self, at: usize) -> bool {
        let Some(before) = at.checked_sub(1).map(|k| &self.paper.printed[k]) else { return false };
        let relation = &self.paper.printed[at];
        let ((file, from), (other, to)) = (self.paper.locate(&before.span()), self.paper.locate(&relation.span()));
        if !std::sync::Arc::ptr_eq(file, other) || from.end > to.start || to.start - from.end > 80 {
            return false;
        }
        let between = file.text.get(from.end..to.start).unwrap_or_default();
        let mut words = between
            .split(|c: char| c.is_whitespace() || matches!(c, '$' | ',' | '.' | '~'))
            .filter(|w| !w.is_empty() && !w.starts_with('\\') && !w.starts_with('&'));
        let is_or = |w: &str| matches!(w, "or" | "oder" | "ou" | "oppure" | "o");
        words.next().is_some_and(is_or)
            && words.next().is_none()
            && before.sides[0].print() == relation.sides[0].print()
    }

    /// Whether a relation stands in a display with "or" between its formulas, or is offered beside another one.
    pub(super) fn is_alternative(&self, at: usize) -> bool {
        if self.is_offered(at) {
            return true;
        }
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
        self.cases[known].1.parted(from.start, to.start, is_sure) || is_sure && self.has_other_value(before, at)
    }

    /// Whether the display of a definition, or its sentence in the running text, has another one of the same name, which says something else.
    pub(super) fn is_defined_beside(&mut self, given: &Given, free: &BTreeSet<char>) -> bool {
        let display = self.display_of(given.relation);
        let other = |g: &Given| {
            g.relation != given.relation
                && g.is_rate == given.is_rate
                && self.display_of(g.relation) == display
                && (display.is_some() || g.relation.abs_diff(given.relation) <= 2 && self.is_one_paragraph(g, given))
                && g.right.print() != given.right.print()
        };
        let others: Vec<PrintedSide> =
            self.facts.given.of(&given.key).filter(|g| other(g)).map(|g| g.right.clone()).collect();
        let rests = Rests { given: Vec::new(), stated: Vec::new(), positive: Positive::Named(BTreeSet::new()) };
        others.iter().any(|right| !self.ask([&given.right, right], &rests, free).is_ok_and(|a| a.is_proved()))
    }

    /// Whether a definition and a relation of the same name follow from two equations of one display, `x=a \\Rightarrow y=b`: they are of two cases.
    pub(super) fn is_implied_beside(&self, given: &Given, at: usize) -> bool {
        let implied = |k: usize| self.paper.printed[k].remark.as_deref().is_some_and(|r| r.contains('⇒'));
        let names_it = || lone_name(&self.paper.printed[at].sides[0]).is_some_and(|n| n.key() == given.key);
        let display = self.display_of(at);
        given.relation != at
            && display.is_some()
            && display == self.display_of(given.relation)
            && implied(given.relation)
            && implied(at)
            && names_it()
    }

    /// Whether an equation follows from one premise of a display, and a relation from another one that stands right before it: `a=0 \\Rightarrow
    /// x=y, b=0 \\Rightarrow x=z` are two cases.
    pub(super) fn is_implied_otherwise(&self, before: usize, at: usize) -> bool {
        let all = &self.paper.printed;
        let implied = |k: usize| all[k].remark.as_deref().is_some_and(|r| r.contains('⇒'));
        let is_premise = |k: usize| match all[k].sides.as_slice() {
            [left, right] => !implied(k) && lone_name(left).is_some() && names(right).is_empty(),
            _ => false,
        };
        before < at
            && all[at].display.is_some()
            && all[at].display == all[before].display
            && implied(before)
            && implied(at)
            && (before + 1..at).any(is_premise)
    }

    /// Whether a name of an equation, or what a name of it is a function of, is defined anew between it and a later relation: it is of what was
    /// meant before.
    pub(super) fn is_of_former(&self, one: &Stated, at: usize) -> bool {
        let letters = |side: &PrintedSide| -> Vec<String> {
            let places = |n: &PaperName| match &n.call {
                Call::Places(places) => places.clone(),
                _ => Vec::new(),
            };
            names(side).iter().flat_map(|n| std::iter::once(n.key()).chain(places(n))).collect()
        };
        let own: BTreeSet<String> = [&one.left, &one.right].into_iter().flat_map(letters).collect();
        own.iter().any(|key| {
            let all: Vec<&Given> = self.facts.given.of(key).filter(|g| !g.is_rate && g.relation < at).collect();
            let before = all.iter().rev().find(|g| g.relation <= one.relation);
            let later = all.iter().find(|g| g.relation > one.relation);
            before.zip(later).is_some_and(|(b, l)| b.right.print() != l.right.print())
        })
    }

    /// Whether two definitions stand in one paragraph.
    fn is_one_paragraph(&self, one: &Given, other: &Given) -> bool {
        let place = |g: &Given| self.paper.locate(&self.paper.printed[g.relation].span());
        let ((file, a), (of, b)) = (place(one), place(other));
        let (from, to) = (a.end.min(b.end), a.start.max(b.start));
        std::sync::Arc::ptr_eq(file, of) && file.text.get(from..to).is_none_or(|between| !between.contains("\n\n"))
    }

    /// Whether the same left side, which is more than a name, is said to be something else near an equation: they are of two cases.
    pub(super) fn is_stated_otherwise(&self, one: &Stated) -> bool {
        let (left, right) = (one.left.print(), one.right.print());
        let near = self.facts.stated.iter().rev().take_while(|s| s.relation + NEAR >= one.relation);
        let mut other = near.filter(|s| s.relation != one.relation && s.section == one.section);
        lone_name(&one.left).is_none() && other.any(|s| s.left.print() == left && s.right.print() != right)
    }

    /// Whether a name has one value before an equation, and another one between it and a later relation.
    pub(super) fn has_other_value(&self, before: usize, at: usize) -> bool {
        let all = &self.paper.printed;
        let value = |k: usize| match all[k].sides.as_slice() {
            [left, right] if all[k].display.is_none() && all[k].signs[0] == "=" && names(right).is_empty() => {
                lone_name(left).map(|n| (n.key(), right.print()))
            }
            _ => None,
        };
        let earlier: Vec<(String, String)> = (before.saturating_sub(BESIDE)..before).filter_map(value).collect();
        let later = (before + 1..at).filter_map(value);
        let is_other = |(key, value): (String, String)| {
            earlier.iter().rev().find(|(k, _)| *k == key).is_some_and(|(_, v)| *v != value)
        };
        !earlier.is_empty() && at - before <= NEAR && later.into_iter().any(is_other)
    }

    /// Whether an equation between the names of some sides is supposed before, in this section: the sides may be equal just then.
    pub(super) fn is_supposed_of(&self, sides: [&PrintedSide; 2], at: usize) -> bool {
        let own = keys(sides);
        self.near(&self.supposed, at).any(|all| all.len() > 1 && all.is_subset(&own))
    }

    /// Whether a name of some sides is said to be zero near them, before or behind.
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
        self.paper.printed[from..to].iter().filter(|r| r.section == relation.section).any(is_zero)
    }

    /// Whether something in a relation is cancelled in print, or said to be 0 there.
    pub(super) fn is_crossed(&self, at: usize) -> bool {
        let (file, span) = self.paper.locate(&self.paper.printed[at].span());
        let source = file.text.get(span).unwrap_or_default();
        [r"\cancel", "=0}", "= 0}", r"\xcancel", r"\sout", r"\not{"].iter().any(|w| source.contains(w))
    }

    /// Whether a relation of a display stands beside a case in it, and holds only there.
    pub(super) fn has_case_beside(&self, at: usize) -> bool {
        let display = self.paper.printed[at].display;
        let beside = |k: usize| {
            k != at
                && self.paper.printed.get(k).is_some_and(|r| r.display == display && r.opening == Some(Opening::Case))
        };
        let (from, to) = (at.saturating_sub(MOST_EXPLAINED), at + MOST_EXPLAINED);
        display.is_some() && self.standings[at] == Standing::Conditional && (from..to).any(beside)
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
        let is_near = move |n: &&Noted| n.section == section && n.relation < at;
        // They are in the order of the paper.
        noted.iter().rev().take_while(move |n| n.relation + NEAR >= at).filter(is_near).map(|n| &n.names)
    }
}
