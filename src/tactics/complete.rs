//! Completion: multiples of facts that sum to what is to vanish.
//!
//! **In:** what is to vanish, and facts that nothing is solved for. **Out:** steps: facts that are sums of multiples of two others, as far as they are needed, and the claim by division by them; or nothing.
//! **Why steps and no cofactors:** written out over the given facts the cofactors may have thousands of terms, where each step has few. **How far:** first with facts that name nothing new, then with those
//! that name no further fixed time, then with all that are connected. What is known not to be 0 may stand before what is to vanish.

use crate::buchberger::{Completion, MOST_TERMS, MOST_WORK, Multiple, Origin, Remainder};
use crate::fraction::fraction;
use crate::prove::Attempt;
use crate::ring::{Polynomial, Ring, add};
use crate::vanish::{Open, order};
use checker::{FactId, Relation, Sense, Term};
use expr::{Expr, Leaf};
use std::collections::{BTreeMap, BTreeSet};

/// Most products of terms that are expanded to begin with.
const MOST_EXPANDED: usize = 120_000;
/// Most facts.
const MOST_INPUTS: usize = 40;
/// A pair of polynomials is looked at up to so many degrees above those that are given.
const FURTHER_DEGREES: u8 = 3;
/// Counted work for each term that is looked at.
const NANOSECONDS: u64 = 400;
/// Most factors that are tried before what is to vanish, and the largest one, in nodes.
const MOST_FACTORS: usize = 4;
const LARGEST_FACTOR: usize = 40;

/// A fact that is not solved, its numerator and its denominator.
type Input = (FactId, Expr, Expr);

impl Attempt<'_> {
    /// The claim `says`, where `e` is what is left of it, as a sum of multiples of facts.
    pub(crate) fn complete(&mut self, says: &Relation, e: Expr, rest: &[Open]) -> Option<FactId> {
        self.complete_within(says, e, rest, MOST_WORK)
    }

    /// The same, with so many terms looked at for each set of facts.
    pub(crate) fn complete_within(&mut self, says: &Relation, e: Expr, rest: &[Open], effort: usize) -> Option<FactId> {
        if self.search.multiples == 0 {
            return None;
        }
        let all = self.numerators(e, rest);
        let leaves: BTreeSet<Leaf> = self.search.reader.graph.leaves([e]).into_iter().collect();
        let instants: BTreeSet<Option<Expr>> = leaves.iter().map(|leaf| leaf.instant).chain([None]).collect();
        let named = |this: &Self, top: Expr| this.search.reader.graph.leaves([top]);
        let mut before = usize::MAX;
        for reach in 0..3 {
            let is_within = |leaf: &Leaf| match reach {
                0 => leaves.contains(leaf),
                1 => instants.contains(&leaf.instant),
                _ => true,
            };
            let inputs: Vec<Input> =
                all.iter().filter(|(_, top, _)| named(self, *top).iter().all(is_within)).copied().collect();
            if inputs.len() == before {
                continue;
            }
            before = inputs.len();
            let found = self.by_multiples(says, e, &inputs, effort);
            if found.is_some() {
                return found;
            }
        }
        None
    }

    fn by_multiples(&mut self, says: &Relation, e: Expr, inputs: &[Input], effort: usize) -> Option<FactId> {
        let question = (e, inputs.iter().map(|(_, top, _)| *top).collect::<Vec<Expr>>());
        if !self.search.completed.insert(question) {
            return None;
        }
        let goal = fraction(&mut self.search.reader.graph, e)?;
        let under = goal.denominator(&mut self.search.reader.graph);
        let mut factors = self.factors(e);
        factors.extend(self.cofactors(goal.numerator, inputs));
        let allowed = effort.min(self.search.multiples);
        let (mut completion, mut targets) = self.begin(goal.numerator, &factors, inputs, allowed)?;
        let found = completion.search(&mut targets);
        let spent = allowed.saturating_sub(completion.work);
        self.search.multiples -= spent;
        meter::charge(NANOSECONDS * spent as u64);
        let at = found?;
        let (target, factor) = (targets.get(at)?, *factors.get(at)?);
        let mut known = BTreeMap::new();
        let used: BTreeSet<usize> = target.taken.iter().map(|(at, ..)| *at).collect();
        let facts: Option<Vec<FactId>> = used.iter().map(|&at| self.written(&completion, at, &mut known)).collect();
        let facts = facts?;
        let plain = self.search.zero(says.clone(), Some(factor), &[], &facts);
        plain.or_else(|| {
            let multiplier = self.search.reader.graph.mul(factor, under);
            let terms = self.multiples(&completion, &target.taken, &known);
            self.search.zero(says.clone(), Some(multiplier), &terms, &[])
        })
    }

    /// What is known not to be 0, and stands before what is to vanish, perhaps: 1, what assumptions say so of, and its square.
    fn factors(&mut self, e: Expr) -> Vec<Expr> {
        let mut out = vec![self.search.reader.graph.integer(1)];
        let leaves = self.search.reader.graph.leaves([e]);
        for fact in self.assumptions.clone() {
            let says = self.search.draft.says(fact).filter(|says| says.sense == Sense::NotEqual);
            let Some((l, r)) = says.and_then(|says| self.search.reader.sides(&says)) else { continue };
            let graph = &mut self.search.reader.graph;
            let difference = graph.sub(l, r);
            let Some(whole) = fraction(graph, difference).map(|f| f.numerator) else { continue };
            let concerns = graph.leaves([whole]).iter().any(|leaf| leaves.contains(leaf));
            if concerns && graph.reachable([whole]).len() <= LARGEST_FACTOR && !out.contains(&whole) {
                let square = graph.powi(whole, 2);
                out.extend([whole, square]);
            }
        }
        out.truncate(1 + 2 * MOST_FACTORS);
        out
    }

    /// What is known not to be 0, and is before what is to vanish in a fact: x + 2 in x² − 4, where x > 0.
    fn cofactors(&mut self, goal: Expr, inputs: &[Input]) -> Vec<Expr> {
        let mut out = Vec::new();
        for &(_, top, _) in inputs.iter().take(MOST_INPUTS) {
            let graph = &mut self.search.reader.graph;
            let mut work = MOST_EXPANDED / MOST_INPUTS;
            let Some(ring) = Ring::of(graph, &[top, goal]) else { continue };
            let polynomials = ring.read(graph, top, &mut work).zip(ring.read(graph, goal, &mut work));
            let quotient = polynomials.and_then(|(p, goal)| ring.quotient(p, &goal, &mut work));
            let Some(terms) = quotient.filter(|q| q.keys().any(|m| ring.degree(m) > 0)) else { continue };
            let factor = ring.write(graph, &terms.into_iter().collect::<Vec<_>>());
            let known = self.of_known_sign();
            if self.signed(factor, Sense::NotEqual, &known).is_some() {
                out.push(factor);
            }
        }
        out.truncate(MOST_FACTORS);
        out
    }

    /// A ring with what is to vanish, before each factor, and facts.
    fn begin(
        &mut self,
        goal: Expr,
        factors: &[Expr],
        inputs: &[Input],
        work: usize,
    ) -> Option<(Completion, Vec<Remainder>)> {
        let graph = &mut self.search.reader.graph;
        let inputs = &inputs[..inputs.len().min(MOST_INPUTS)];
        let products: Vec<Expr> = factors.iter().map(|&factor| graph.mul(factor, goal)).collect();
        let roots: Vec<Expr> = inputs.iter().map(|(_, top, _)| *top).chain(products.iter().copied()).collect();
        let ring = Ring::of(graph, &roots)?;
        let mut expanded = MOST_EXPANDED;
        let mut targets = Vec::new();
        for product in products {
            targets.push(ring.read(graph, product, &mut expanded)?);
        }
        let degree = |ring: &Ring, p: &Polynomial| p.keys().map(|m| ring.degree(m)).max().unwrap_or(0);
        let mut highest = targets.first().map_or(0, |goal| degree(&ring, goal));
        let mut polynomials = Vec::new();
        for &(fact, top, under) in inputs {
            let p = ring.read(graph, top, &mut expanded).filter(|p| !p.is_empty() && p.len() <= MOST_TERMS);
            let Some(p) = p else { continue };
            highest = highest.max(degree(&ring, &p));
            polynomials.push((degree(&ring, &p), p, fact, under));
        }
        polynomials.sort_by_key(|(degree, p, ..)| (*degree, p.len()));
        let mut completion = Completion::new(ring, highest.saturating_add(FURTHER_DEGREES), work);
        for (_, p, fact, under) in polynomials {
            completion.give(p, fact, under)?;
        }
        Some((completion, targets.into_iter().map(Remainder::of).collect()))
    }

    /// Of the facts that concern an expression, or those that do: numerators and denominators. What is known of any time is left out where it does not name it.
    fn numerators(&mut self, e: Expr, rest: &[Open]) -> Vec<Input> {
        let graph = &self.search.reader.graph;
        let mut known: BTreeSet<Expr> = graph.reachable([e]).into_iter().collect();
        let is_any_time = |e: Expr| {
            let instants = graph.leaves([e]).into_iter().filter_map(|leaf| leaf.instant);
            instants.filter(|c| !graph.leaves([*c]).is_empty()).collect::<BTreeSet<Expr>>()
        };
        let named = is_any_time(e);
        let laws = self.laws(e);
        let mut open: Vec<(FactId, Expr)> = Vec::new();
        for fact in laws {
            if let Some((l, r)) = self.search.equation(fact) {
                open.push((fact, self.search.reader.graph.sub(l, r)));
            }
        }
        let graph = &self.search.reader.graph;
        // A rate higher than those that are to vanish says nothing of them.
        let highest = |e: Expr| graph.leaves([e]).into_iter().map(order).max().unwrap_or(0);
        let named_rate = highest(e);
        let usable = |o: &&Open| {
            !graph.is_zero(o.e) && highest(o.e) <= named_rate && {
                let instants = graph.leaves([o.e]).into_iter().filter_map(|leaf| leaf.instant);
                instants.filter(|c| !graph.leaves([*c]).is_empty()).all(|c| named.contains(&c))
            }
        };
        open.extend(rest.iter().filter(usable).map(|o| (o.fact, o.e)));
        let mut out = Vec::new();
        loop {
            let graph = &mut self.search.reader.graph;
            let leaves: BTreeSet<_> = graph.leaves(known.iter().copied()).into_iter().collect();
            let (near, far): (Vec<_>, Vec<_>) =
                open.into_iter().partition(|(_, e)| graph.leaves([*e]).iter().any(|leaf| leaves.contains(leaf)));
            open = far;
            if near.is_empty() {
                return out;
            }
            for (fact, e) in near {
                known.extend(graph.reachable([e]));
                if let Some(f) = fraction(graph, e) {
                    let under = f.denominator(graph);
                    out.push((fact, f.numerator, under));
                }
            }
        }
    }

    /// An element as a fact.
    fn written(&mut self, completion: &Completion, at: usize, known: &mut BTreeMap<usize, FactId>) -> Option<FactId> {
        if let Some(fact) = known.get(&at) {
            return Some(*fact);
        }
        let element = &completion.elements[at];
        let left = completion.ring.write(&mut self.search.reader.graph, &element.terms);
        let says = Relation::equal(self.search.reader.term(left)?, Term::integer(0));
        let fact = match &element.origin {
            Origin::Fact(fact, under, number) => {
                let graph = &mut self.search.reader.graph;
                let number = graph.constant(number.clone());
                let factor = graph.mul(number, *under);
                self.search.zero(says, None, &[(*fact, factor)], &[])?
            }
            Origin::Sum(multiples) => {
                for (other, ..) in multiples {
                    self.written(completion, *other, known)?;
                }
                let terms = self.multiples(completion, multiples, known);
                let before = std::mem::take(&mut self.search.solved);
                let found = self.search.zero(says, None, &terms, &[]);
                self.search.solved = before;
                found?
            }
        };
        known.insert(at, fact);
        Some(fact)
    }

    /// Multiples of elements as multiples of facts.
    fn multiples(
        &mut self,
        completion: &Completion,
        multiples: &[Multiple],
        known: &BTreeMap<usize, FactId>,
    ) -> Vec<(FactId, Expr)> {
        let mut factors: BTreeMap<usize, Polynomial> = BTreeMap::new();
        for (at, m, r) in multiples {
            add(factors.entry(*at).or_default(), *m, r.clone());
        }
        let graph = &mut self.search.reader.graph;
        let each = factors.into_iter().filter_map(|(at, p)| {
            let terms: Vec<_> = p.into_iter().collect();
            Some((*known.get(&at)?, completion.ring.write(graph, &terms)))
        });
        each.collect()
    }
}
