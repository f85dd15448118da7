//! Roots: a value of an unknown, or another equation for it, that does not follow from the equation right before it.
//!
//! **In:** a relation that its words conclude from the one before, both of one unknown. **Out:** what is wrong, with the value that holds.
//! **Guaranteed:** the equation before has that value as its only solution, which is proved, and at it the relation fails.

use std::collections::BTreeSet;

use paper::{PrintedRelation, PrintedSide, names};
use proof::Identity;

use super::LintWitness;
use super::cases::Stance;
use super::excuse::stated;
use super::facts::Stated;
use super::judge::Judge;
use super::lone::lone_name;
use super::nearest::WrongStep;
use super::numbers::as_fraction;
use super::question::{Positive, Rests};
use super::sentence::{Sentence, is_supposed};
use super::setting::keys;
use super::standing::Standing;

/// Relative difference between a value and the one that holds which rounding may make.
const ROUNDED: f64 = 0.02;

/// Words that conclude from the formula right before them.
const CONCLUDING: &[&str] =
    &["so", "so that", "hence", "thus", "therefore", "which gives", "which implies", "gives", "implies", "yields"];

impl Judge<'_> {
    /// The error of a relation that concludes from an equation in one unknown, if it does not hold at the only solution of that.
    pub(super) fn misses_root(
        &mut self,
        relation: &PrintedRelation,
        at: usize,
        sentence: &Sentence,
    ) -> Option<WrongStep> {
        let premise = at.checked_sub(1).filter(|&k| self.concludes_from(relation, k, at, sentence))?;
        let [left, right] = relation.sides.as_slice() else { return None };
        let [before, after] = self.paper.printed[premise].sides.as_slice() else { return None };
        let (before, after) = (before.clone(), after.clone());
        let unknown = keys([&before, &after]);
        let [key] = unknown.iter().map(String::as_str).collect::<Vec<_>>()[..] else { return None };
        // A value that is known is no equation.
        let is_value = |s: &PrintedSide, other: &PrintedSide| lone_name(s).is_some() && names(other).is_empty();
        if unknown != keys([left, right]) || is_value(&before, &after) || is_value(&after, &before) {
            return None;
        }
        let given = Stated {
            left: before,
            right: after,
            relation: premise,
            section: self.section,
            names: unknown.clone(),
            in_text: false,
        };
        let rests = Rests { given: Vec::new(), stated: vec![given], positive: Positive::Named(BTreeSet::new()) };
        let free = BTreeSet::new();
        let asked = self.ask([left, right], &rests, &free).ok()?;
        let Identity::Refuted(refutation) = &asked.identity else { return None };
        if asked.is_vacuous || asked.desk.is_complex {
            return None;
        }
        let (l, r) = (refutation.left.decimal, refutation.right.decimal);
        if (l - r).abs() < ROUNDED * l.abs().max(r.abs()) {
            return None;
        }
        let [(_, found)] = refutation.point.values.as_slice() else { return None };
        let value = found.exact.as_ref()?.to_string();
        let root = stated(&format!("{key}={}", as_fraction(&value)), at)?;
        let only = self.ask([&root.left, &root.right], &rests, &free).ok()?;
        if !only.is_proved() || only.is_vacuous {
            return None;
        }
        let witness = LintWitness { values: vec![(key.to_owned(), value)], left: l, right: r };
        let instead = format!("{} = {}", root.left.text, root.right.text);
        Some(WrongStep { witness, instead, picture: None, with: vec![premise], is_of_earlier: false, is_copy: false })
    }

    /// Whether a relation stands right behind an equation, in its display or formula, or in the next display, and its words conclude from that.
    fn concludes_from(&mut self, relation: &PrintedRelation, premise: usize, at: usize, sentence: &Sentence) -> bool {
        let paper = self.paper;
        let before = &paper.printed[premise];
        let is_plain =
            |r: &PrintedRelation| r.sides.len() == 2 && r.signs[0] == "=" && !r.sides.iter().any(|s| s.is_list);
        let implied = relation.remark.as_deref() == Some("⇒");
        let has_words = |r: &PrintedRelation| r.remark.as_deref().is_some_and(|words| words != "⇒");
        let concludes = match relation.display == before.display {
            true if relation.display.is_none() => {
                let between = self.text_between(premise, at);
                match implied {
                    true => between.is_some_and(|text| !text.contains(['$', '.', '(', ')'])),
                    false => between.is_some_and(concludes_alone),
                }
            }
            true => implied,
            false => {
                before.display.is_some()
                    && self.only_reckons(premise, at)
                    && sentence.concludes
                    && !sentence.changes
                    && relation.display == before.display.map(|d| d + 1)
            }
        };
        let is_last_word = || {
            let next = paper.printed.get(at + 1).filter(|r| r.display == relation.display);
            next.is_none_or(|r| r.sides[0].print() != relation.sides[0].print())
        };
        concludes
            && is_plain(relation)
            && is_plain(before)
            && !has_words(relation)
            && !has_words(before)
            && !(sentence.loosens || sentence.aims || sentence.solves)
            && is_last_word()
            && [premise, at].iter().all(|&k| self.standings[k] == Standing::Stated)
            && !self.evidence.has_modulus()
            && !self.evidence.is_algebra(&relation.sides[1])
            && !is_supposed(paper, relation)
            && self.stance(before, premise) == Stance::Said
            && !self.is_alternative(premise)
            && !self.are_parted(premise, at, true)
            && !self.is_taken_back(relation, at)
    }
}

/// Whether nothing stands between two formulas of the running text but a word that concludes: `$3x=6$ so $x=2$`.
fn concludes_alone(between: &str) -> bool {
    let words = between.split(|c: char| !c.is_alphabetic()).filter(|w| !w.is_empty()).collect::<Vec<_>>().join(" ");
    between.contains(['$', ')']) && !between.contains('.') && CONCLUDING.contains(&words.trim_start_matches("and "))
}
