//! What becomes of the cases of a problem, and what a proof of all of them leaves out.

use super::Examination;
use crate::field::{Bound, sum_log2};
use crate::outcome::{Proof, Reason, Refutation};
use crate::polynomial::factors;
use crate::solve::{Resolved, unmarked};
use expr::{Expr, Node, Op};

/// What becomes of one case.
pub(super) enum Outcome {
    Holds(Box<Proof>),
    Refuted(Box<Refutation>),
    Open(Reason),
    /// The premises rule the case out, or it was not reached.
    Empty(Reason),
    /// Some formula has no value wherever the premises hold.
    Void(Bound),
}

/// Why a list of cases does not amount to a proof.
pub(super) enum Stop {
    Refuted(Box<Refutation>),
    /// No case is possible, where the pivots of these are not 0.
    Empty(Reason, Vec<Resolved>),
    Undecided(Reason),
}

impl From<Reason> for Stop {
    fn from(reason: Reason) -> Stop {
        Stop::Undecided(reason)
    }
}

/// One proof from all cases, with the resolutions it rests on.
pub(super) fn merge(outcomes: Vec<(Resolved, Outcome)>) -> Result<(Proof, Vec<Resolved>), Stop> {
    let mut proof: Option<Proof> = None;
    let (mut open, mut resolved) = (None, Vec::new());
    let (mut void, mut empty): (Option<Bound>, Option<Reason>) = (None, None);
    for (mut case, outcome) in outcomes {
        match outcome {
            Outcome::Refuted(refutation) => return Err(Stop::Refuted(refutation)),
            Outcome::Open(reason) => drop(open.get_or_insert(reason)),
            Outcome::Empty(reason) => {
                // Only where all cases contradict themselves the premises do.
                let weight = |r: &Reason| match r {
                    Reason::Contradiction => 0,
                    Reason::NoValue => 1,
                    _ => 2,
                };
                if empty.as_ref().is_none_or(|e| weight(e) < weight(&reason)) {
                    empty = Some(reason);
                }
                case.empty = true;
                resolved.push(case);
            }
            Outcome::Void(bound) => {
                case.empty = true;
                resolved.push(case);
                match &mut void {
                    None => void = Some(bound),
                    Some(all) => all.absorb(bound),
                }
            }
            Outcome::Holds(one) => {
                resolved.push(case);
                match &mut proof {
                    None => proof = Some(*one),
                    Some(all) => all.absorb(*one),
                }
            }
        }
    }
    match (open, proof) {
        (Some(reason), _) => Err(Stop::Undecided(reason)),
        (None, Some(mut proof)) => {
            if let Some(bound) = void {
                proof.log2_error = sum_log2(proof.log2_error, bound.log2_error);
                proof.degree_bound = proof.degree_bound.max(bound.degree);
                proof.height_bound = proof.height_bound.max(bound.height);
                proof.primes.extend(bound.primes);
            }
            Ok((proof, resolved))
        }
        (None, None) => {
            let reason = match (empty, void) {
                (Some(Reason::Degenerate), _) => Reason::Degenerate,
                (_, Some(_)) => Reason::NoValue,
                (empty, None) => empty.unwrap_or(Reason::Contradiction),
            };
            Err(Stop::Empty(reason, resolved))
        }
    }
}

impl Proof {
    /// Both proofs together.
    pub fn absorb(&mut self, other: Proof) {
        self.log2_error = sum_log2(self.log2_error, other.log2_error);
        self.degree_bound = self.degree_bound.max(other.degree_bound);
        self.height_bound = self.height_bound.max(other.height_bound);
        self.trials = self.trials.max(other.trials);
        self.primes.extend(other.primes);
        self.signs = self.signs.max(other.signs);
        self.cases += other.cases;
        for condition in other.conditions {
            if !self.conditions.contains(&condition) {
                self.conditions.push(condition);
            }
        }
        self.example = self.example.take().or(other.example);
    }
}

/// What was divided by, and which of it a special case has dealt with.
pub(super) struct Pivots {
    pub(super) list: Vec<Expr>,
    /// Those that stood under a root.
    pub(super) rooted: Vec<Expr>,
    /// The pivots of the proof for the case that this one vanishes; `None` when there is no such proof.
    pub(super) nested: Vec<Option<Vec<Expr>>>,
}

impl Pivots {
    /// The factors of the pivots that are not known to be ≠ 0.
    pub(super) fn of(examination: &mut Examination<'_>, cases: &[Resolved]) -> Pivots {
        let Examination { graph, lowered, .. } = examination;
        let mut list: Vec<Expr> = Vec::new();
        let claim = lowered.claim.iter().flat_map(|&(l, r)| [l, r]);
        let roots: Vec<Expr> = claim.chain(lowered.assumed.iter().copied()).collect();
        let mut rooted: Vec<Expr> = Vec::new();
        let all: Vec<Expr> = cases.iter().flat_map(|c| c.pivots_for(graph, roots.iter().copied())).collect();
        for pivot in all {
            for (mut base, _) in factors(graph, pivot).1 {
                // A root vanishes where its radicand does.
                while let Node::Unary(Op::Sqrt, radicand) = *graph.node(base) {
                    base = unmarked(graph, &lowered.generators, radicand).unwrap_or(radicand);
                    rooted.push(base);
                }
                if !lowered.facts.sign(graph, &lowered.generators, base).nonzero && !list.contains(&base) {
                    list.push(base);
                }
            }
        }
        let nested = vec![None; list.len()];
        Pivots { list, nested, rooted }
    }

    /// Pivots that must not vanish: all but those whose special case is proved from the remaining ones.
    pub(super) fn needed(&self) -> Vec<Expr> {
        let mut needed = self.list.clone();
        let mut relied_on: Vec<Expr> = Vec::new();
        for (pivot, nested) in self.list.iter().zip(&self.nested) {
            let Some(nested) = nested else { continue };
            if !relied_on.contains(pivot) && nested.iter().all(|n| n != pivot && needed.contains(n)) {
                needed.retain(|n| n != pivot);
                relied_on.extend(nested);
            }
        }
        needed
    }
}
