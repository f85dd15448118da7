//! What holds at one time and does not change: a step by its rates.
//!
//! **In:** equations, and what is given. **Out:** the same equations at a fixed time that is named, with their derivatives; and whether
//! these follow. Then the equations hold at every time at which they are differentiable. What decays like an exponential is divided
//! by it first: the quotient does not change.

use super::gather::Gathered;
use super::{Pairs, Step};
use crate::expr::domain::Sign;
use crate::expr::{Expr, Leaf, Node, Op};
use claim::comparison::{at_instant, traced};
use proof::{Identity, Wanted, When};

impl Step<'_> {
    /// Whether both sides agree at a fixed time that the equations or the premises name, and their rates always: of the
    /// equations, or of the same in another form, see [`without_growth`](Step::without_growth).
    pub(super) fn by_rate(&mut self, gathered: &Gathered, equations: &Pairs) -> Option<(Identity, Pairs)> {
        let gathered = &self.between_times(gathered)?;
        let all = self.start_and_rates(gathered, equations)?;
        let proved = |i: &Identity| matches!(i, Identity::Proved(_));
        for split in [false, true] {
            let found = self.levels(gathered, &all, split, Wanted::Proof);
            if proved(&found) {
                return Some((found, equations.clone()));
            }
        }
        if let Some(even) = self.without_growth(equations)
            && let Some(all) = self.start_and_rates(gathered, &even)
            && let found = self.levels(gathered, &all, false, Wanted::Proof)
            && proved(&found)
        {
            return Some((found, even));
        }
        self.by_uniqueness(gathered, equations).map(|found| (found, equations.clone()))
    }

    /// What may be used of the times between others: what is known always; and what is known for a while, where motions are analytic, since
    /// what is shown of rates then goes on.
    pub(super) fn between_times(&mut self, gathered: &Gathered) -> Option<Gathered> {
        let mut out = if gathered.lasting == When::Always { gathered.clone() } else { self.gather_throughout()? };
        let for_a_while = out.premises.equations.iter().any(|k| k.when == When::ChosenOpen);
        let goes_on = for_a_while && self.motions_are_analytic(self.claim);
        out.premises.equations.retain(|k| match k.when {
            When::Always => true,
            When::ChosenOpen => goes_on,
            When::Chosen | When::At(_) => false,
        });
        out.complete &= out.premises.equations.len() == gathered.premises.equations.len();
        Some(out)
    }

    /// What must not vanish so that equations have values at the time at which their proof along motions begins: what neither the claim
    /// asks for nor what is given tells. Where they have none, the proof says nothing; `None` where they may have none for other reasons.
    pub(super) fn open_at_start(&mut self, gathered: &Gathered, equations: &Pairs) -> Option<Vec<Expr>> {
        let Some(start) = self.start else { return Some(Vec::new()) };
        let roots: Vec<Expr> = equations.iter().flat_map(|&(l, r)| [l, r]).collect();
        let claim = self.claim;
        let written = |this: &mut Self, e: Expr| traced(&mut this.graph, &claim.scope, e);
        let own: Vec<Expr> = self.equations(claim).unwrap_or_default().into_iter().flat_map(|(l, r)| [l, r]).collect();
        let own: Vec<Expr> = own.into_iter().map(|e| written(self, e)).collect();
        let own: Vec<(Expr, Sign)> = self.graph.implied_below(own).iter().map(|n| (n.value, n.sign)).collect();
        let then: Vec<Expr> = roots.into_iter().map(|e| at_instant(&mut self.graph, &claim.scope, e, start)).collect();
        let then: Vec<Expr> = then.into_iter().map(|e| written(self, e)).collect();
        let mut out = Vec::new();
        for need in self.graph.needs_below(then) {
            if own.contains(&(need.value, need.sign)) || out.contains(&need.value) {
                continue;
            }
            if !self.is_met(need.value, need.sign, gathered) {
                (need.sign == Sign::NotZero).then(|| out.push(need.value))?;
            }
        }
        Some(out)
    }

    /// What is given without what is assumed of some times, if that may be used of all times.
    pub(super) fn gather_throughout(&mut self) -> Option<Gathered> {
        let some = self.assumed_for_a_while();
        let gathered = Gathered { complete: false, ..self.gather(Some(&some)) };
        (gathered.lasting == When::Always).then_some(gathered)
    }

    /// The equations, both sides divided by an exponential in time that one of them has: what decays like it is then constant.
    /// An exponential is never 0, and has a value wherever a side has one that it is part of. `None` where there is none.
    fn without_growth(&mut self, equations: &Pairs) -> Option<Pairs> {
        let scope = &self.claim.scope;
        let time = scope.time()?;
        let mut found = false;
        let mut even = Pairs::new();
        for &(l, r) in equations {
            let exponent = self.graph.reachable([l, r]).into_iter().find_map(|e| match *self.graph.node(e) {
                Node::Unary(Op::Exp, exponent) => {
                    let leaves = self.graph.leaves([exponent]);
                    let moves = |leaf: &Leaf| scope.moves(leaf);
                    let in_time = leaves.contains(&time) && leaves.iter().all(|l| l.instant.is_some() || !moves(l));
                    in_time.then_some(exponent)
                }
                Node::Constant(_) | Node::Pi | Node::Leaf(_) | Node::Unary(..) | Node::Binary(..) => None,
            });
            let Some(exponent) = exponent else {
                even.push((l, r));
                continue;
            };
            found = true;
            let opposite = self.graph.neg(exponent);
            let inverse = self.graph.unary(Op::Exp, opposite);
            even.push((self.graph.mul(l, inverse), self.graph.mul(r, inverse)));
        }
        found.then_some(even)
    }

    /// The equations at a fixed time, and their rates; `None` where there is no such time.
    pub(super) fn start_and_rates(&mut self, gathered: &Gathered, equations: &Pairs) -> Option<Pairs> {
        let time = self.claim.scope.time()?;
        let roots: Vec<Expr> = equations.iter().flat_map(|&(l, r)| [l, r]).collect();
        let leaves = self.graph.leaves_within(roots);
        if leaves.contains(&self.claim.scope.branch_sign()) {
            return None;
        }
        let given: Vec<Expr> = gathered.premises.sides().collect();
        let of_premises = self.graph.leaves_within(given);
        let start = leaves.iter().chain(&of_premises).find_map(|l| l.instant)?;
        self.start = Some(start);
        let scope = &self.claim.scope;
        let moves = |leaf: Leaf| scope.moves(&leaf);
        let mut all = Pairs::new();
        for &(l, r) in equations {
            let then = [l, r].map(|e| at_instant(&mut self.graph, scope, e, start));
            let rates = [l, r].map(|e| self.graph.time_derivative(e, time, moves));
            let [Ok(left), Ok(right)] = rates else { return None };
            all.extend([(then[0], then[1]), (left, right)]);
        }
        all.retain(|(l, r)| l != r);
        Some(all)
    }
}
