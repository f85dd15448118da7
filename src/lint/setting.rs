//! The setting of a relation: what its words do with it, which case it is of, what was compared or supposed before it.
//!
//! **In:** relations by their numbers. **Out:** whether something is to be kept from being used, or from being called wrong. **Guaranteed:** a
//! setting makes nothing hold.

use std::collections::BTreeSet;

use paper::{Opening, PrintedRelation, PrintedSide, names, squeezed};

use super::cases::{Cases, Stance, stance};
use super::desk::Given;
use super::facts::{NEAR, Stated};
use super::judge::{Judge, MOST_EXPLAINED};
use super::lone::lone_name;
use super::question::{Positive, Rests};
use super::standing::{Standing, is_equation};
use super::step::Place;

/// Relations on both sides of a step in which a name of it may be said to be zero.
const BESIDE: usize = 6;

/// Values that are tried.
const MOST_VALUES: usize = 4;
/// Letters that stand for whole numbers.
const WHOLE: &[&str] = &["m", "n", "k", "l", "j", "N", "p", "q", r"\ell"];

/// An equation that no relation of the paper says.
fn stated(text: &str, at: usize) -> Option<Stated> {
    let paper = paper::parse_pasted("value", text).ok()?;
    let [left, right] = paper.printed.first()?.sides.as_slice() else { return None };
    let (left, right) = (left.clone(), right.clone());
    let names = keys([&left, &right]);
    Some(Stated { left, right, relation: at, section: 0, names, in_text: true })
}

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

/// The names that stand between bars in some sides, as they are printed.
fn between_bars(sides: [&PrintedSide; 2]) -> Vec<String> {
    let mut out = Vec::new();
    for side in sides {
        let plain = [r"\left", r"\right", r"\lvert", r"\rvert"];
        let text =
            plain.iter().fold(side.text.clone(), |t, c| t.replace(c, if c.ends_with("vert") { "|" } else { "" }));
        out.extend(text.split('|').skip(1).step_by(2).map(|t| t.trim().to_owned()));
    }
    out.retain(|t| !t.is_empty() && !t.contains(['+', '-', '=']));
    out.sort();
    out.dedup();
    out.truncate(MOST_VALUES);
    out
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
            && squeezed(&before.sides[0].text) == squeezed(&relation.sides[0].text)
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
                && squeezed(&g.right.text) != squeezed(&given.right.text)
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

    /// Whether two definitions stand in one paragraph.
    fn is_one_paragraph(&self, one: &Given, other: &Given) -> bool {
        let place = |g: &Given| self.paper.locate(&self.paper.printed[g.relation].span());
        let ((file, a), (of, b)) = (place(one), place(other));
        let (from, to) = (a.end.min(b.end), a.start.max(b.start));
        std::sync::Arc::ptr_eq(file, of) && file.text.get(from..to).is_none_or(|between| !between.contains("\n\n"))
    }

    /// Whether the same left side, which is more than a name, is said to be something else near an equation: they are of two cases.
    pub(super) fn is_stated_otherwise(&self, one: &Stated) -> bool {
        let left = squeezed(&one.left.text);
        let near = self.facts.stated.iter().rev().take_while(|s| s.relation + NEAR >= one.relation);
        let mut other = near.filter(|s| s.relation != one.relation && s.section == one.section);
        lone_name(&one.left).is_none()
            && other.any(|s| squeezed(&s.left.text) == left && squeezed(&s.right.text) != squeezed(&one.right.text))
    }

    /// Whether a name has one value before an equation, and another one between it and a later relation.
    pub(super) fn has_other_value(&self, before: usize, at: usize) -> bool {
        let all = &self.paper.printed;
        let value = |k: usize| match all[k].sides.as_slice() {
            [left, right] if all[k].display.is_none() && all[k].signs[0] == "=" && names(right).is_empty() => {
                lone_name(left).map(|n| (n.key(), squeezed(&right.text)))
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

    /// Whether a step that is refuted holds with the values that are said near it, before or behind, or for every whole number that a letter
    /// for one may be, beside π.
    pub(super) fn is_excused(&mut self, sides: [&PrintedSide; 2], rests: &Rests, place: &Place) -> bool {
        let own = keys(sides);
        let near = self.values_near(place.at, &own);
        let mut tries: Vec<Vec<Stated>> = near.iter().cloned().map(|one| vec![one]).collect();
        if near.len() > 1 {
            tries.push(near);
        }
        // What stands between bars may be negative.
        tries.extend(
            between_bars(sides).iter().filter_map(|of| Some(vec![stated(&format!("|{of}|=-{of}"), place.at)?])),
        );
        if tries.into_iter().any(|more| self.holds_with(sides, rests, more, place)) {
            return true;
        }
        let beside_pi = sides.iter().any(|s| s.text.contains(r"\pi"));
        let mut whole = own.iter().filter(|key| beside_pi && WHOLE.contains(&key.as_str()));
        whole.any(|key| {
            let equals = |value: &str| stated(&format!("{key}={value}"), place.at);
            let values: Option<Vec<Stated>> = ["1", "2", "3"].into_iter().map(equals).collect();
            values.is_some_and(|all| all.into_iter().all(|one| self.holds_with(sides, rests, vec![one], place)))
        })
    }

    /// The relations near one that give a name of it a value, or say that it is another one.
    fn values_near(&self, at: usize, own: &BTreeSet<String>) -> Vec<Stated> {
        let all = &self.paper.printed;
        let (from, to) = (at.saturating_sub(BESIDE), (at + BESIDE + 1).min(all.len()));
        let mut out = Vec::new();
        for k in (from..to).filter(|&k| k != at && all[k].section == all[at].section) {
            let [left, right] = all[k].sides.as_slice() else { continue };
            let name = lone_name(left).filter(|n| own.contains(&n.key()) && all[k].signs[0] == "=");
            let is_number = names(right).is_empty() && right.text.chars().any(|c| c.is_ascii_digit());
            let is_other = lone_name(right).is_some_and(|n| own.contains(&n.key()));
            let is_case = all[k].opening == Some(Opening::Case) && is_equation(&all[k]);
            if is_case || name.is_some() && (is_number || is_other && all[k].display.is_none()) {
                let (left, right) = (left.clone(), right.clone());
                let names = keys([&left, &right]);
                out.push(Stated { left, right, relation: k, section: self.section, names, in_text: true });
            }
        }
        out.truncate(MOST_VALUES);
        out
    }

    fn holds_with(&mut self, sides: [&PrintedSide; 2], rests: &Rests, more: Vec<Stated>, place: &Place) -> bool {
        let stated = rests.stated.iter().cloned().chain(more).collect();
        let rests = Rests { stated, ..rests.clone() };
        self.ask(sides, &rests, place.free).is_ok_and(|answer| answer.is_proved() || answer.is_vacuous)
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
