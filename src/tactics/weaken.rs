//! The end of a proof: the fact at the times of the claim, with as few needs as can be.
//!
//! **In:** a fact that says the claim. **Out:** the same where the claim has a value, without the needs that are known to hold: since the claim, a system or an assumption has a value, by an inequality that is assumed,
//! or since what must not be 0 is, by facts, what is known not to be.

use crate::prove::Attempt;
use crate::vanish::Open;
use checker::{CaseId, FactId, Given, Relation, Sense, Step, Term, When};
use expr::{Expr, Node, Op};

/// Most expressions that must not be 0, and most that are not, which are compared.
const MOST_NEEDED: usize = 3;
const MOST_KNOWN: usize = 4;

/// Whether an operation is a power with an exponent above 0.
fn is_power(op: Op) -> bool {
    if let Op::Powi(n) = op { n > 0 } else { false }
}

impl Attempt<'_> {
    /// The fact at the times at which the claim has a value, with as few needs as can be.
    pub(crate) fn weaken(&mut self, fact: FactId) -> Option<FactId> {
        let within = When::Chosen.within(CaseId::CLAIM);
        let fact = self.search.push(Step::Restrict { fact, to: within, because: vec![] })?;
        let mut because = self.assumptions.clone();
        because.extend(self.values_throughout());
        for need in 0..self.search.draft.claim_needs().len() as u32 {
            because.extend(self.search.push(Step::ClaimHasValue { need, within: When::Chosen }));
        }
        for at in 0..self.sequent.assumed.len() as u32 {
            because.extend(self.values_of(Given::Assumed(at)));
        }
        let best = self.discharged(fact, &because);
        if self.search.draft.needs(best).is_empty() {
            return Some(best);
        }
        let equal = self.known_by_equals(best);
        because.extend(equal);
        // What these need themselves would be needed in place of what they show.
        let free = |this: &Self, id: FactId| this.search.draft.needs(id).is_empty();
        let known: Vec<FactId> = because.iter().copied().filter(|&id| free(self, id)).collect();
        let open: Vec<FactId> = because.into_iter().filter(|&id| !free(self, id)).collect();
        let freed: Vec<FactId> = open.into_iter().map(|id| self.discharged(id, &known)).collect();
        let because = known.into_iter().chain(freed).collect::<Vec<_>>();
        let free: Vec<FactId> = because.iter().copied().filter(|&id| free(self, id)).collect();
        let best = self.discharged(best, &because);
        let best = self.discharged(best, &free);
        if self.search.draft.needs(best).is_empty() {
            return Some(best);
        }
        let mut known: Vec<FactId> = free.into_iter().filter(|&id| self.search.equation(id).is_none()).collect();
        let best = self.without_needed(best, &known);
        if self.search.draft.needs(best).is_empty() {
            return Some(best);
        }
        // What laws say of them may need what is needed, and comes last.
        for fact in known.clone() {
            let by_laws = self.by_laws(fact);
            known.extend(by_laws.map(|told| self.discharged(told, &known)));
        }
        Some(self.without_needed(best, &known))
    }

    /// A fact without what the rules of signs show of its needs.
    fn without_needed(&mut self, fact: FactId, known: &[FactId]) -> FactId {
        let needed = self.needed(&[fact], known);
        self.discharged(fact, &[&needed[..], known].concat())
    }

    /// A fact without what others show of its needs, each alone and all together.
    fn discharged(&mut self, fact: FactId, because: &[FactId]) -> FactId {
        let mut best = fact;
        let each = because.iter().map(|&each| vec![each]).chain([because.to_vec()]);
        for because in each.collect::<Vec<_>>() {
            let fewer = self.search.push(Step::Discharge { fact: best, because });
            let count = |id: FactId| self.search.draft.needs(id).len();
            if let Some(fewer) = fewer.filter(|&fewer| count(fewer) < count(best)) {
                best = fewer;
            }
        }
        best
    }

    /// What a fact needs not to be 0 and facts say to be equal to what is known not to be.
    fn known_by_equals(&mut self, fact: FactId) -> Vec<FactId> {
        let mut needed: Vec<Expr> = Vec::new();
        for need in self.search.draft.needs(fact) {
            if let Some((l, r)) = self.search.reader.sides(&need).filter(|_| need.sense == Sense::NotEqual)
                && self.search.reader.graph.is_zero(r)
            {
                needed.extend(self.parts(l, false));
            }
        }
        let mut known = self.known_not_zero();
        known.extend(self.positive_sides());
        let mut rest: Vec<Open> = Vec::new();
        for &fact in &self.facts.clone() {
            let Some((l, r)) = self.search.equation(fact) else { continue };
            rest.push(Open { fact, e: self.search.reader.graph.sub(l, r) });
        }
        self.search.solved.clear();
        let mut out = Vec::new();
        for v in needed.into_iter().take(MOST_NEEDED) {
            let found = known.iter().take(MOST_KNOWN).find_map(|&(w, known)| self.not_zero_like(v, w, known, &rest));
            out.extend(found);
        }
        out
    }

    /// v ≠ 0, since w ≠ 0 and v = w.
    fn not_zero_like(&mut self, v: Expr, w: Expr, known: FactId, rest: &[Open]) -> Option<FactId> {
        let difference = self.search.reader.graph.sub(w, v);
        let says = self.search.reader.equation(w, v)?;
        let equal = self.complete(&says, difference, rest)?;
        let says = Relation { left: self.search.reader.term(v)?, sense: Sense::NotEqual, right: Term::integer(0) };
        self.search.push(Step::Congruence { says, from: Some(known), equal: vec![equal] })
    }

    /// What assumptions say not to be 0, with the facts that say so.
    fn known_not_zero(&mut self) -> Vec<(Expr, FactId)> {
        let mut out: Vec<(Expr, FactId)> = Vec::new();
        for fact in self.assumptions.clone() {
            let says = self.search.draft.says(fact).filter(|says| says.sense == Sense::NotEqual);
            let Some((l, r)) = says.and_then(|says| self.search.reader.sides(&says)) else { continue };
            if !self.search.reader.graph.is_zero(r) {
                continue;
            }
            for part in self.parts(l, true) {
                let Some(left) = self.search.reader.term(part) else { continue };
                let says = Relation { left, sense: Sense::NotEqual, right: Term::integer(0) };
                let made = self.search.push(Step::Sign { says, from: vec![fact] });
                out.extend(made.map(|made| (part, made)));
            }
        }
        out
    }

    /// Sides of equations that are positive by what is declared: √(x² + y²) = r says that the root is not 0.
    fn positive_sides(&mut self) -> Vec<(Expr, FactId)> {
        let mut out: Vec<(Expr, FactId)> = Vec::new();
        for fact in self.facts.clone() {
            let Some((l, r)) = self.search.equation(fact) else { continue };
            for side in [l, r] {
                let is_constant = self.search.reader.graph.as_constant(side).is_some();
                if is_constant || !self.is_positive(side) || out.iter().any(|(known, _)| *known == side) {
                    continue;
                }
                let Some(left) = self.search.reader.term(side) else { continue };
                let says = Relation { left, sense: Sense::NotEqual, right: Term::integer(0) };
                out.extend(self.search.push(Step::Sign { says, from: vec![] }).map(|made| (side, made)));
            }
        }
        out
    }

    /// The factors of what is not 0, those that are not numbers or constants of a sign; with those below roots.
    fn parts(&self, e: Expr, below_roots: bool) -> Vec<Expr> {
        let (mut open, mut out) = (vec![e], Vec::new());
        while let Some(e) = open.pop() {
            let node = self.search.reader.graph.node(e);
            if let Node::Binary(Op::Mul, a, b) = *node {
                open.extend([b, a]);
                continue;
            }
            let mut inner = None;
            if let Node::Binary(Op::Div, a, _) | Node::Unary(Op::Neg, a) = *node {
                inner = Some(a);
            }
            if let Node::Unary(op, a) = *node
                && (op == Op::Sqrt && below_roots || is_power(op))
            {
                inner = Some(a);
            }
            match inner {
                Some(inner) => open.push(inner),
                None if !self.is_positive(e) && !out.contains(&e) => out.push(e),
                None => {}
            }
        }
        out
    }
}
