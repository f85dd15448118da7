//! Doubt: what keeps *wrong* from being said of a relation, whatever its formula is.
//!
//! **In:** a relation, its row and its display, and the words around them. **Out:** whether it may be a condition, a supposition or a denial, or hold
//! in a case only. **Guaranteed:** in one place; nothing is proved with it.
//!
//! Words take back what stands beside them ([`super::words`]). Of what is printed in the same row, anything that relates something else is a
//! case, and so is what is not read and has a sign of a limit, a set, a quantifier or an equation. What leads to a conclusion, or is one of a
//! system in braces, is an equation to be solved.

use std::collections::BTreeSet;
use std::ops::Range;

use paper::{Opening, PaperName, PrintedRelation, PrintedSide, names};

use super::desk::Given;
use super::judge::{Judge, MOST_EXPLAINED};
use super::sentence::{Sentence, is_aside, window};
use super::setting::keys;
use super::signs::{COMPARES, EQUALS, has_sign, is_one_of};
use super::step::Place;
use super::words::{Taken, asserts, goes_on, of_several, only_reckons, take_back_in_row, taken};

/// The longest text between a definition and a step that may speak of another thing.
const SEVERAL: usize = 300;
/// The longest text between two formulas between the same dollars, and before a row of a system.
const BETWEEN: usize = 120;
const BEFORE: usize = 1_500;
/// The most environments there whose beginnings are looked at.
const MOST_ENVIRONMENTS: usize = 40;

/// Signs in a piece that is not read, with which it restricts what stands beside it, beside those that compare.
const RESTRICT: &[&str] = &[
    "=",
    "≈",
    "≪",
    "≫",
    "∈",
    "∀",
    "∃",
    "⊥",
    "?",
    r"\ll",
    r"\gg",
    r"\to",
    r"\rightarrow",
    r"\longrightarrow",
    r"\approx",
    r"\sim",
    r"\simeq",
    r"\perp",
    r"\forall",
    r"\exists",
    r"\equiv",
    r"\propto",
    "mod",
    r"\not",
];
/// Signs of statements from right to left.
const BACKWARDS: &[&str] = &[r"\because", r"\Leftarrow", r"\Longleftarrow", r"\impliedby", "∵", "⇐", "⟸"];
/// Environments whose rows are a system, behind a brace and alone.
const ROWS: &[&str] = &["array", "aligned", "alignedat", "gathered", "matrix", "split", "align", "cases"];
const SYSTEMS: &[&str] = &["cases", "dcases", "rcases", "drcases", "numcases", "subnumcases", "sistema", "systeme"];

impl Judge<'_> {
    /// Whether *wrong* is to be said of no step of a relation.
    pub(super) fn is_doubted(&self, relation: &PrintedRelation, at: usize, sentence: &Sentence) -> bool {
        sentence.loosens || self.taken(relation).loosely || self.is_taken_back(relation, at)
    }

    /// Whether a relation may be denied, supposed, posed, or hold in a case only.
    pub(super) fn is_taken_back(&self, relation: &PrintedRelation, at: usize) -> bool {
        self.has_case_beside(at)
            || self.is_taken_back_in_row(relation, at)
            || self.is_restricted_in_row(relation, at)
            || self.is_antecedent(at)
            || self.is_of_system(at)
            || self.taken(relation).back
    }

    /// Whether a relation is no premise: its words deny it, or it stands in a footnote, a figure or another place beside the text.
    pub(super) fn is_no_premise(&self, relation: &PrintedRelation) -> bool {
        let (file, span) = self.paper.locate(&relation.span());
        relation.display.is_some() && is_aside(&file.text, span.start) || self.taken(relation).denied
    }

    /// Whether it is not sure that a relation is said of what the text is about: of two that say of a name what it is, another may be meant.
    pub(super) fn is_of_another_case(&self, relation: &PrintedRelation, at: usize) -> bool {
        let has_words = relation.remark.as_deref().is_some_and(|words| words.chars().any(char::is_alphabetic));
        has_words || self.taken(relation).loosely || self.is_taken_back(relation, at)
    }

    /// Whether the words before a display say the first formula that stands in it.
    pub(super) fn is_asserted(&self, relation: &PrintedRelation, at: usize) -> bool {
        let is_first = at.checked_sub(1).is_none_or(|k| self.paper.printed[k].display != relation.display);
        let (file, span) = self.paper.locate(&relation.span());
        relation.display.is_none() || !is_first || asserts(&file.text, span.start)
    }

    /// Whether a step may be about another thing than a definition that it rests on: words between speak of several, or of another one; it says
    /// of the defined name again what it is, in a sentence about something else; or it stands in the same display in a row with a label.
    pub(super) fn is_of_another(&self, sides: [&PrintedSide; 2], given: &Given, place: &Place) -> bool {
        let all = &self.paper.printed;
        let (own, before) = (&all[place.at], &all[given.relation]);
        let has_label =
            |r: &PrintedRelation| r.remark.as_deref().is_some_and(|words| words.chars().any(char::is_alphabetic));
        let is_labelled =
            own.display.is_some() && own.display == before.display && (has_label(own) || has_label(before));
        let is_again = place.is_first && names(sides[0]).iter().any(|n| n.key() == given.key);
        is_labelled
            || self.speaks_of_several(given.relation, place.at)
            || is_again && self.words_between(given.relation, place.at).is_some_and(|words| !goes_on(words))
    }

    /// The text between two relations of one file.
    pub(super) fn text_between(&self, first: usize, second: usize) -> Option<&str> {
        let place = |k: usize| self.paper.locate(&self.paper.printed[k].span());
        let ((file, from), (other, to)) = (place(first), place(second));
        file.text.get(from.end..to.start).filter(|_| std::sync::Arc::ptr_eq(file, other))
    }

    /// Whether all words between two relations reckon and conclude, and those of formulas between them are formulas: "As buses are whole, we get"
    /// and "Halfway down" say more.
    pub(super) fn only_reckons(&self, first: usize, second: usize) -> bool {
        let parts: Option<Vec<&str>> = (first..second).map(|k| self.text_between(k, k + 1)).collect();
        parts.is_some_and(|parts| only_reckons(&parts.join(" x ")))
    }

    /// The text from a relation to one behind it in the same file, or the end of it.
    fn words_between(&self, from: usize, at: usize) -> Option<&str> {
        let place = |k: usize| self.paper.locate(&self.paper.printed[k].span());
        let ((file, before), (other, own)) = (place(from), place(at));
        let is_one = from < at && std::sync::Arc::ptr_eq(file, other) && own.start >= before.end;
        let between =
            is_one.then(|| window(&file.text, before.end.max(own.start.saturating_sub(SEVERAL)), own.start))?;
        // What stands up to the end of the definition's own sentence, and the beginning of one that is cut, is not looked at.
        let ends = [". ", ".\n", r".\]", ".$", "$$", r"\]"]
            .iter()
            .filter_map(|end| between.find(end).map(|at| at + end.len()));
        let environment = between.find(r"\end{").and_then(|at| Some(at + between[at..].find('}')? + 1));
        let begin = ends.chain(environment).min();
        Some(between[begin.unwrap_or(between.len())..].trim_start_matches(['$', '.']))
    }

    /// Whether words between a definition and a step near it speak of several things, or of another one: "two in parallel", "with R→2R".
    pub(super) fn speaks_of_several(&self, from: usize, at: usize) -> bool {
        let place = |k: usize| self.paper.locate(&self.paper.printed[k].span());
        let ((file, before), (other, own)) = (place(from), place(at));
        if from >= at || !std::sync::Arc::ptr_eq(file, other) || own.start < before.end {
            return false;
        }
        let between = window(&file.text, before.end.max(own.start.saturating_sub(SEVERAL)), own.start);
        let between = between.rsplit("\n\n").next().unwrap_or_default();
        has_sign(between, &[r"\to", r"\mapsto", r"\rightarrow", "→"]) || of_several(between)
    }

    /// What the words around a relation of the running text, or around its display, do with it.
    fn taken(&self, relation: &PrintedRelation) -> Taken {
        let (file, own) = self.paper.locate(&relation.span());
        let place = match &self.display {
            Some(known) if Some(known.number) == relation.display => known.place.clone(),
            _ => own,
        };
        taken(&file.text, &place, relation.display.is_some())
    }

    /// The place of a display from its first to its last formula, in the file of one of them.
    pub(super) fn place_of_display(&self, at: usize) -> Range<usize> {
        let all = &self.paper.printed;
        let (file, mut place) = self.paper.locate(&all[at].span());
        for other in all[at..].iter().take_while(|r| r.display == all[at].display) {
            let (of, span) = self.paper.locate(&other.span());
            if std::sync::Arc::ptr_eq(file, of) && !span.is_empty() {
                place = place.start.min(span.start)..place.end.max(span.end);
            }
        }
        place
    }

    /// The text between two relations that follow each other, where both stand in one formula or display.
    fn between_in_formula(&self, first: usize, second: usize) -> Option<&str> {
        let all = &self.paper.printed;
        let (one, other) = (all.get(first)?, all.get(second)?);
        let ((file, from), (of, to)) = (self.paper.locate(&one.span()), self.paper.locate(&other.span()));
        let between =
            file.text.get(from.end..to.start).filter(|_| std::sync::Arc::ptr_eq(file, of)).unwrap_or_default();
        let closes = between.len() > BETWEEN || ["$", r"\(", r"\)", "\n\n", "`"].iter().any(|c| between.contains(c));
        match (one.display, other.display) {
            (Some(a), Some(b)) => (a == b).then_some(between),
            (None, None) => (!closes && from.end <= to.start && std::sync::Arc::ptr_eq(file, of)).then_some(between),
            _ => None,
        }
    }

    /// The relations that stand in a row with one.
    fn row_of(&self, at: usize) -> Range<usize> {
        let all = &self.paper.printed;
        let is_beside = |k: usize| match all[at].display {
            // A chain ends in a later row than what stands beside its beginning.
            Some(_) if k < at => all[k].row == all[at].row,
            Some(_) => all[k].row <= all[at].row,
            None => true,
        };
        let (mut from, mut to) = (at, at + 1);
        while from > 0 && at - from < MOST_EXPLAINED && self.between_in_formula(from - 1, from).is_some() {
            if !is_beside(from - 1) {
                break;
            }
            from -= 1;
        }
        while to < all.len() && to - at < MOST_EXPLAINED && self.between_in_formula(to - 1, to).is_some() {
            if !is_beside(to) {
                break;
            }
            to += 1;
        }
        from..to
    }

    /// Whether words that are printed in its row, or right above it, take a relation back.
    fn is_taken_back_in_row(&self, relation: &PrintedRelation, at: usize) -> bool {
        let all = &self.paper.printed;
        let says = |r: &PrintedRelation| r.remark.as_deref().is_some_and(take_back_in_row);
        // Words before a formula are told of what stands before it.
        let above = at.checked_sub(1).filter(|k| relation.display.is_some() && all[*k].display == relation.display);
        self.row_of(at).any(|k| says(&all[k])) || above.is_some_and(|k| says(&all[k]))
    }

    /// Whether something else in the row of a relation may say when it holds.
    fn is_restricted_in_row(&self, relation: &PrintedRelation, at: usize) -> bool {
        let all = &self.paper.printed;
        let own: BTreeSet<String> = relation.sides.iter().flat_map(names).map(|n: PaperName| n.key()).collect();
        let concludes = is_implied(relation);
        let may_restrict = |k: usize| {
            let other = &all[k];
            let ends_as_label = other.sides.last().is_some_and(|s| s.text.trim_end().ends_with(':'));
            if ends_as_label {
                return true;
            }
            match other.sides.as_slice() {
                [one] => {
                    let is_of_place = matches!(other.opening, Some(Opening::Remark | Opening::Case));
                    !one.text.is_empty() && (is_of_place || restricts(&one.text))
                }
                // What a relation concludes from is no case of it, and neither is what is said of another derivative: `\dot x=\ldots,\ \dot p=\ldots`.
                _ if concludes && k < at || are_of_derivatives([relation, other]) => false,
                sides => {
                    let shares = || sides.iter().any(|s| !keys([s, s]).is_disjoint(&own));
                    let is_plain = |s: &String| is_one_of(EQUALS, s) || is_one_of(COMPARES, s) && !s.contains("in");
                    !other.signs.iter().all(is_plain) || shares()
                }
            }
        };
        let row = self.row_of(at);
        row.clone().filter(|k| *k != at).any(may_restrict)
            || self.is_given_as_reason(at)
            || relation.display.is_none() && self.is_restricted_in_formula(row)
    }

    /// Whether something in a formula of the running text before its first relation, or behind its last one, may say when they hold: what relates
    /// nothing is no formula of the text by itself.
    fn is_restricted_in_formula(&self, row: Range<usize>) -> bool {
        let all = &self.paper.printed;
        let (Some(first), Some(last)) = (all.get(row.start), all.get(row.end.saturating_sub(1))) else { return false };
        let ((file, from), (other, to)) = (self.paper.locate(&first.span()), self.paper.locate(&last.span()));
        if !std::sync::Arc::ptr_eq(file, other) {
            return false;
        }
        let near = |at: usize| diag::next_character(&file.text, at.min(file.text.len()));
        let before = file.text.get(near(from.start.saturating_sub(BETWEEN))..from.start).unwrap_or_default();
        let behind = file.text.get(to.end..near(to.end + BETWEEN)).unwrap_or_default();
        let opened = ["$", r"\("].iter().filter_map(|open| before.rfind(open).map(|i| i + open.len())).max();
        let closed = ["$", r"\)"].iter().filter_map(|close| behind.find(close)).min();
        let restrict = |text: &str| restricts(text) || text.contains(r"\text") && take_back_in_row(text);
        opened.is_some_and(|i| restrict(&before[i..]) || before[i..].contains(':'))
            || closed.is_some_and(|i| restrict(&behind[..i]))
    }

    /// Whether a sign of a reason stands before a relation, `\because x=y`.
    fn is_given_as_reason(&self, at: usize) -> bool {
        let before = at.checked_sub(1).and_then(|k| self.between_in_formula(k, at));
        before.is_some_and(|text| has_sign(text, BACKWARDS))
    }

    /// Whether a relation leads to the next one, and follows from none: an equation that is solved.
    fn is_antecedent(&self, at: usize) -> bool {
        let all = &self.paper.printed;
        let leads = all.get(at + 1).is_some_and(is_implied) && self.between_in_formula(at, at + 1).is_some();
        leads && !is_implied(&all[at])
    }

    /// Whether a relation is a row of a system behind a brace.
    fn is_of_system(&self, at: usize) -> bool {
        let (file, span) = self.paper.locate(&self.paper.printed[at].span());
        let from = diag::next_character(&file.text, span.start.saturating_sub(BEFORE));
        let before = file.text.get(from..span.start).unwrap_or_default();
        // In the running text, and behind a blank line, nothing goes on.
        let before = before.rsplit("\n\n").next().unwrap_or_default();
        let begins = before.rmatch_indices(r"\begin{").take(MOST_ENVIRONMENTS).filter_map(|(i, command)| {
            let name = before[i + command.len()..].split('}').next()?.trim_end_matches('*');
            let is_open = !before[i..].contains(&format!(r"\end{{{name}"));
            is_open.then_some((i, name))
        });
        begins.take(MOST_EXPLAINED).any(|(i, name)| {
            let opened = before[..i].trim_end();
            let braced = [r"\{", r"\lbrace", r"\Bigg\{", r"\left\{"].iter().any(|brace| opened.ends_with(brace));
            let stands_alone = !opened.ends_with('=') && !opened.ends_with(['}', ')']);
            SYSTEMS.contains(&name) && stands_alone || braced && ROWS.contains(&name)
        })
    }
}

/// Whether a piece of a formula may say when what stands beside it holds.
fn restricts(text: &str) -> bool {
    has_sign(text, RESTRICT) || has_sign(text, COMPARES)
}

/// Whether two relations say what two derivatives are, by formulas.
fn are_of_derivatives(relations: [&PrintedRelation; 2]) -> bool {
    let is_derivative = |n: &PaperName| n.dots > 0 || n.derived_by.is_some();
    let says = |r: &PrintedRelation| {
        r.signs.iter().all(|s| is_one_of(EQUALS, s))
            && r.sides.first().is_some_and(|s| names(s).iter().any(is_derivative))
            && r.sides.last().is_some_and(|s| names(s).len() > 1)
    };
    relations.into_iter().all(says) && relations[0].sides[0].print() != relations[1].sides[0].print()
}

/// Whether an arrow stands before a relation.
fn is_implied(relation: &PrintedRelation) -> bool {
    relation.remark.as_deref().is_some_and(|words| words.contains('⇒'))
}
