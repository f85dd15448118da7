//! Definitions: what a relation defines, and of which names it is no choice any more what they are.
//!
//! **In:** a relation, or its name. **Out:** whether it is defined, derived or given before; the definitions that are noted. **Guaranteed:**
//! what was not read defines nothing, and takes back what was said before.

use std::collections::BTreeSet;

use paper::{Call, PrintedRelation, PrintedSide, names};

use super::desk::{Desk, Given};
use super::facts::Reach;
use super::judge::Judge;
use super::lone::{lone_name, unprimed};
use super::nearest::WrongStep;
use super::primes::is_elsewhere;
use super::refusal::NotRead;
use super::relation::free_indices;
use super::sentence::is_supposed;
use super::signs::EQUALS;
use super::standing::Standing;
use super::step::{IN_SENTENCE, Place};

impl Judge<'_> {
    /// Whether an equation before, in this section, has a name in it, or the definition of another name that it is said to be made of.
    pub(super) fn is_stated(&self, name: Option<&paper::PaperName>, right: &PrintedSide, at: usize) -> bool {
        let Some(key) = name.map(paper::PaperName::key) else { return false };
        let is_of = |g: &&Given| !g.is_rate && g.section == self.section && g.relation + IN_SENTENCE >= at;
        let is_solved = |of: String| {
            let latest = self.facts.given.of(&of).rev().find(|g| !g.is_rate).filter(is_of);
            of != key && latest.is_some_and(|g| names(&g.right).iter().any(|n| n.key() == key))
        };
        self.facts.is_stated(self.section, &key) || names(right).iter().any(|n| is_solved(n.key()))
    }

    /// The relation that defines a name just so, in this section.
    pub(super) fn same_definition(&self, name: Option<&paper::PaperName>, right: &PrintedSide) -> Option<usize> {
        let print = right.print();
        let name = name?;
        let same =
            |g: &&Given| !g.is_rate && g.section == self.section && g.right.print() == print && !is_elsewhere(g, name);
        self.facts.given.of(&name.key()).rev().find(same).map(|g| g.relation)
    }

    /// The latest definition of a name, which is none of its rates.
    pub(super) fn latest_definition(&self, name: &paper::PaperName) -> Option<&Given> {
        self.facts.given.of(&name.key()).rev().find(|g| !g.is_rate && !is_elsewhere(g, name))
    }

    /// Whether what is wrong is that a name is said to be something else than in its definition, and the sentence names no equation.
    pub(super) fn contradicts_definition(
        &self,
        name: Option<&paper::PaperName>,
        wrong: &WrongStep,
        place: &Place,
    ) -> bool {
        let is_plain = |n: &&paper::PaperName| n.dots == 0 && n.primes == 0 && n.derived_by.is_none();
        let before = name.filter(is_plain).and_then(|n| self.latest_definition(n));
        place.named.is_empty() && before.is_some_and(|g| wrong.with.iter().all(|with| *with == g.relation))
    }

    /// Whether a name is a derivative: with a dot, in a quotient, or with a prime behind what is defined.
    pub(super) fn is_rate(&self, name: Option<&paper::PaperName>) -> bool {
        name.is_some_and(|n| {
            n.dots > 0
                || n.derived_by.is_some()
                || n.primes > 0 && self.facts.given.of(&unprimed(n).key()).next().is_some()
        })
    }

    /// Whether a side has a derivative of what this section defines by a formula, and no other name: what it is is no choice any more.
    pub(super) fn is_derived(&self, side: &PrintedSide) -> bool {
        let all = lone_name(side).map_or_else(|| names(side), |name| vec![name]);
        let mut derived =
            all.iter().filter(|n| !n.is_variable && (n.primes > 0 || n.dots > 0 || n.derived_by.is_some()));
        let Some(name) = derived.next().filter(|_| derived.next().is_none()) else { return false };
        let is_it = |g: &Given| !g.is_rate && g.section == self.section;
        all.iter().filter(|n| !n.is_variable).count() == 1 && self.facts.given.of(&unprimed(name).key()).any(is_it)
    }

    /// Whether no item of a list begins between the definition of a name and a relation: a list may be one of cases.
    pub(super) fn is_the_same_case(&self, name: Option<&paper::PaperName>, at: usize) -> bool {
        let Some(before) = name.and_then(|n| self.facts.given.of(&n.key()).next_back()) else { return true };
        let place = |k: usize| self.paper.locate(&self.paper.printed[k].span());
        let ((file, from), (other, to)) = (place(before.relation), place(at));
        std::sync::Arc::ptr_eq(file, other)
            && file.text.get(from.end..to.start).is_some_and(|between| !between.contains(r"\item"))
    }

    pub(super) fn has_rates(&self) -> bool {
        self.facts.given.has_rates()
    }

    /// Whether places behind a name may be those of its definition: one without a digit; or several different variables, where the paper
    /// prints no other places behind it, and no rate of it, which could be one along a motion.
    fn is_at_its_own(&self, key: &str, places: &[String]) -> bool {
        if let [one] = places {
            return !one.chars().any(|c| c.is_ascii_digit());
        }
        let evidence = &self.evidence;
        let mut known = evidence.calls.get(key).into_iter().flat_map(|calls| calls.keys().flatten());
        places.iter().all(|p| paper::is_variable(p))
            && places.iter().collect::<BTreeSet<_>>().len() == places.len()
            && known.all(|other| other == places)
            && !evidence.derived.contains_key(key)
            && !evidence.dotted.contains(key)
    }

    /// Notes what a relation defines.
    pub(super) fn define(&mut self, relation: &PrintedRelation, at: usize) {
        let Some(name) = lone_name(&relation.sides[0]) else { return };
        let is_equal = relation.signs.first().is_some_and(|s| EQUALS.contains(&s.as_str()));
        if !is_equal
            || self.standings[at] != Standing::Stated
            || relation.display.is_none() && is_supposed(self.paper, relation)
        {
            return;
        }
        let right = &relation.sides[1];
        let key = name.key();
        let is_rate = name.dots == 1 || name.derived_by.is_some() && !name.is_partial;
        if self.is_no_premise(relation) {
            return;
        }
        if name.dots > 1 || name.is_partial || right.is_list || right.text.is_empty() {
            return;
        }
        let own = names(right);
        // A value is a condition, and what stands on both sides is an equation.
        let is_matrix = right.text.contains("matrix}");
        if own.is_empty() && !is_matrix
            || own.iter().any(|n| n.key() == key && (!is_rate || n.dots > 0 || n.derived_by.is_some()))
        {
            return;
        }
        if matches!(&name.call, Call::Places(places) if !self.is_at_its_own(&key, places)) {
            return;
        }
        let free = free_indices(relation);
        let print = right.print();
        let rival = |g: &Given| g.is_rate == is_rate && g.section == self.parts[at] && g.right.print() != print;
        // Of two definitions of which one is of another case it is not known which is meant.
        if self.facts.given.of(&key).any(rival) && self.is_of_another_case(relation, at) {
            self.facts.given.forget(&key, is_rate);
            return;
        }
        if relation.unread.is_some() || self.readable(&relation.sides[0], right, &free).is_err() {
            // What was defined before is defined no more: by what, was not read.
            self.facts.given.forget(&key, is_rate);
            return;
        }
        // What its derivatives were is no more.
        if !is_rate && name.primes == 0 {
            for primes in ["'", "''"] {
                self.facts.given.forget(&format!("{key}{primes}"), false);
            }
        }
        let given = Given {
            key,
            left: relation.sides[0].clone(),
            right: right.clone(),
            relation: at,
            is_rate,
            section: self.parts[at],
        };
        self.facts.given.push(given);
    }

    pub(super) fn readable(
        &self,
        left: &PrintedSide,
        right: &PrintedSide,
        free: &BTreeSet<char>,
    ) -> Result<(), NotRead> {
        let read = |given: &[Given]| {
            let list: Vec<&Given> = given.iter().collect();
            let mut desk = Desk::new(&[left, right], &list, &self.evidence, free)?;
            desk.pairs([left, right], &self.evidence).map(|_| ())
        };
        // A derivative by a rate needs the formula that is derived.
        read(&[])
            .or_else(|found| match self.facts.definitions(&[left, right], Reach::Paper, false) {
                given if given.is_empty() => Err(found),
                given => read(&given).map_err(|_| found),
            })
            // `\lambda_\pm=-p\pm q` says what two names are.
            .or_else(|found| match left.branch_signs().min(right.branch_signs()) {
                0 => Err(found),
                _ => self.readable(&left.branch(true), &right.branch(true), free).map_err(|_| found),
            })
    }
}
