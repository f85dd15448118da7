//! Blame: of which steps *wrong* may be said, by the place and the words in which they stand.
//!
//! **In:** a step of a relation, and what its sentence says. **Out:** a [`Blame`], and how sure it is that something is claimed.
//! **Guaranteed:** of a definition, and of what is doubted ([`super::doubt`]), nothing is.

use std::cell::OnceCell;

use paper::{PrintedRelation, PrintedSide, names, squeezed};

use super::judge::Judge;
use super::nearest::Sureness;
use super::relation::{
    are_multiples, are_two_places, has_constant_of_integration, has_dimensions, is_congruence, is_evaluated, is_of_any,
    is_of_units,
};
use super::sentence::{Sentence, ends_inside, is_supposed, window};
use super::signs::{DEFINES, is_one_of};
use super::step::Blame;

/// The longest text before an equation between numbers that is looked at, and behind it.
const AROUND: usize = 240;

/// Words near an equation between numbers that may be no claim, or one of other numbers.
const NOT_RECKONED: &[&str] = &[
    "if ",
    "suppose",
    "proposition",
    "statement",
    "false",
    "true",
    "wrong",
    "mistake",
    "mod",
    "base",
    "binar",
    "octal",
    "hexa",
    "clock",
    "ring",
    "group",
    "field",
    "parity",
    "xor",
    "boolean",
    "logic",
    "implies",
    "implic",
    "absurd",
    "contradict",
    "enunciat",
    "vero",
    "falso",
    "faux",
    "vrai",
    "falsch",
    "wahr",
    "aussage",
    "se ",
    "si ",
    "wenn",
    "falls",
    "approx",
    "round",
    "joke",
    "percent",
    "concat",
    "string",
    "calculator",
    "spreadsheet",
    "in c,",
    "python",
    "apl",
    "precedence",
    "dial",
];

/// A step of a relation, and what is known of it.
pub(super) struct OfStep<'a> {
    pub(super) relation: &'a PrintedRelation,
    /// The number of its later side.
    pub(super) k: usize,
    pub(super) sentence: &'a Sentence,
    /// Whether it defines a name.
    pub(super) defining: bool,
    /// Whether it says what the derivative is of what was defined.
    pub(super) derived: bool,
    /// Whether what it defines is solved for.
    pub(super) solved: bool,
    /// Whether it is all of the relation, and of what is no lone name that was defined.
    pub(super) alone: bool,
    /// Whether an integral stands in a side before it.
    pub(super) integrated: bool,
    /// What the relation is as a whole.
    pub(super) whole: &'a Whole,
}

/// What a relation is as a whole: it is asked once, and not for each of its steps.
pub(super) struct Whole {
    is_evaluated: bool,
    has_dimensions: bool,
    is_doubted: OnceCell<bool>,
}

impl Whole {
    pub(super) fn of(relation: &PrintedRelation) -> Whole {
        Whole {
            is_evaluated: is_evaluated(relation),
            has_dimensions: has_dimensions(relation),
            is_doubted: OnceCell::new(),
        }
    }
}

impl Judge<'_> {
    /// Of what *wrong* may be said in a step.
    pub(super) fn blame(&self, step: &OfStep, at: usize) -> Blame {
        let &OfStep { relation, k, sentence, defining, derived, solved, alone, integrated, whole } = step;
        let (left, right) = (&relation.sides[k - 1], &relation.sides[k]);
        let inline = relation.display.is_none();
        if self.evidence.is_algebra(left)
            || integrated && has_constant_of_integration(left, right)
            || whole.is_evaluated && [left, right].iter().any(|s| !names(s).is_empty())
            || whole.has_dimensions
            || is_congruence(&relation.signs[k - 1])
            || is_one_of(DEFINES, &relation.signs[k - 1])
            || alone && are_multiples(left, right)
            || self.is_quoted(relation)
            || are_two_places(left, right)
            || is_of_units(relation)
        {
            return Blame::Nothing;
        }
        let found = match inline {
            _ if self.is_inexact(step, at) => Blame::Nothing,
            _ if derived && sentence.fixes => Blame::Nothing,
            _ if derived => Blame::Steps,
            true if defining && !solved => Blame::Nothing,
            true if solved => Blame::Steps,
            true => Blame::Identities,
            false if defining && !self.has_rates() && !solved => Blame::Nothing,
            false => Blame::Steps,
        };
        let is_doubted = || *whole.is_doubted.get_or_init(|| self.is_doubted(relation, at, sentence));
        if found != Blame::Nothing && is_doubted() { Blame::Nothing } else { found }
    }

    /// Whether a step need not be exact, or holds in a case: nothing is concluded with it.
    pub(super) fn is_inexact(&self, step: &OfStep, at: usize) -> bool {
        let &OfStep { relation, k, sentence, alone, .. } = step;
        let is_last = k + 1 == relation.sides.len();
        let is_first_of_text = relation.display.is_none() && k == 1;
        sentence.loosens
            || sentence.solves && alone
            || is_last && is_of_any(relation)
            || self.has_case_beside(at)
            || is_first_of_text && !step.derived && is_supposed(self.paper, relation)
    }

    /// Whether a relation stands in a quotation, or is one of several answers: "(b)" stands before it.
    fn is_quoted(&self, relation: &PrintedRelation) -> bool {
        let (file, span) = self.paper.locate(&relation.span());
        let before = window(&file.text, span.start.saturating_sub(AROUND), span.start);
        let opened = before.trim_end_matches(|c: char| c.is_whitespace() || matches!(c, '$' | '(' | '\\'));
        let is_answer = opened.trim_end_matches(']').strip_suffix(')').is_some_and(|rest| {
            let mut letters = rest.chars().rev();
            letters.next().is_some_and(|c| c.is_ascii_alphabetic()) && letters.next() == Some('(')
        });
        ends_inside(before, "quot") || relation.display.is_none() && is_answer
    }

    /// How sure it is that a step claims something.
    pub(super) fn sureness(&self, step: &OfStep, concludes: bool) -> Sureness {
        if step.derived {
            Sureness::Derives
        } else if concludes {
            if step.solved { Sureness::Solves } else { Sureness::Concludes }
        } else if step.k > 1 || step.alone && self.is_reckoned(step.relation) {
            Sureness::Chain
        } else {
            Sureness::Stands
        }
    }

    /// Whether an equation between numbers reckons: no word near says that it is supposed, or of numbers of another kind.
    fn is_reckoned(&self, relation: &PrintedRelation) -> bool {
        let is_plain = |side: &PrintedSide| {
            names(side).is_empty() && !side.text.contains([',', '[', '|']) && !side.text.contains("matrix}")
        };
        let digits: Vec<char> =
            relation.sides.iter().flat_map(|s| s.text.chars()).filter(char::is_ascii_digit).collect();
        // `1+1=0` is one of bits, and `10+1=11` may be one.
        if !relation.sides.iter().all(is_plain)
            || digits.iter().all(|d| matches!(d, '0' | '1'))
            || self.evidence.has_modulus()
        {
            return false;
        }
        if relation.sides.iter().any(|s| squeezed(&s.text) == "0") {
            return false;
        }
        // One sum in the running text may be one of another arithmetic, or be rounded to what can be counted.
        let operations = |s: &PrintedSide| {
            let signs = s.text.chars().filter(|c| "+-*/^".contains(*c)).count();
            let powers = s.text.matches('^').count();
            signs
                + powers
                + [r"\cdot", r"\times", r"\frac", r"\sqrt"].iter().map(|c| s.text.matches(c).count()).sum::<usize>()
        };
        let has_decimals = relation.sides.iter().any(|s| s.text.contains('.'));
        if relation.display.is_none() && !has_decimals && relation.sides.iter().map(operations).sum::<usize>() < 2 {
            return false;
        }
        let (file, span) = self.paper.locate(&relation.span());
        let words = window(&file.text, span.start.saturating_sub(AROUND), span.end + AROUND).to_lowercase();
        !NOT_RECKONED.iter().any(|w| words.contains(w))
    }
}
