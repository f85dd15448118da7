//! The cases that a proof leaves out: those that are empty, or in which it holds, too.
//!
//! **In:** a proof, with what it divided by. **Out:** the proof without such conditions; or the refutation that one of them holds. A
//! function with several branches leaps where it is left out: of what goes along a motion those are named.

use super::definitions::Definitions;
use super::gather::Gathered;
use super::{Pairs, Step, has_exceptions, without_exceptions};
use crate::derivation::Form;
use crate::expr::{Expr, Leaf, Node, Op};
use proof::{Condition, Identity, Options, Reason};

/// Most exceptions of a proof that are looked at by themselves.
const MOST_EXCEPTIONS: usize = 6;

impl Step<'_> {
    /// A proof without those of its exceptions that are empty, or in which the claim is proved, too; or the refutation that one
    /// of them holds.
    ///
    /// What is claimed holds where what was divided by is not 0. Along a motion it holds at the limits of such times, too, since both
    /// sides are continuous; what is left is that it is 0 on an interval, with all its derivatives: a premise like others.
    pub(super) fn without_empty_cases(
        &mut self,
        identity: Identity,
        gathered: &Gathered,
        equations: &Pairs,
        refutes: bool,
    ) -> Identity {
        let Identity::Proved(mut proof) = identity else { return identity };
        let roots: Vec<Expr> = equations.iter().flat_map(|&(l, r)| [l, r]).collect();
        let leaps =
            self.graph.reachable(roots).iter().any(|&e| matches!(self.graph.node(e), Node::Binary(Op::Arctan2, ..)));
        let zero = self.graph.integer(0);
        let pivots = proof.conditions.iter().filter_map(|c| match *c {
            Condition::Pivot(e) => Some(e),
            _ => None,
        });
        let pivots: Vec<Expr> = pivots.take(MOST_EXCEPTIONS).collect();
        for pivot in pivots {
            // Auxiliary numbers are no part of the question.
            let leaves = self.graph.leaves_within([pivot]);
            let scope = &self.claim.scope;
            if leaves.iter().any(|l| scope.role(l.symbol).is_none()) {
                continue;
            }
            let moves = leaves.iter().any(|l| l.instant.is_none() && scope.moves(l));
            if moves && leaps {
                continue;
            }
            // What depends on the time alone vanishes at single times only, and both sides are continuous there.
            if !leaps && !leaves.is_empty() && leaves.iter().all(|&l| Some(l) == scope.time()) {
                proof.conditions.retain(|c| *c != Condition::Pivot(pivot));
                continue;
            }
            let mut premises = self.premises(gathered, equations, Definitions::All);
            if moves {
                // It may vanish for a while, and not at the times that are named.
                premises = self.of_one_time(premises);
            }
            premises.equations.insert(0, (pivot, zero));
            let found = self.test_only(&premises, equations, &Options::default());
            let discharged = match found {
                Identity::Proved(case) => {
                    let clean = !has_exceptions(&case);
                    if clean {
                        proof.log2_error = proof.log2_error.max(case.log2_error) + 1.0;
                        // Perhaps what is given can hold in this case only.
                        proof.example = proof.example.take().or(case.example);
                    }
                    clean
                }
                Identity::Undecided(Reason::Contradiction) => true,
                Identity::Refuted(refutation) if refutes && gathered.complete && !self.loosened => {
                    self.settled = None;
                    return Identity::Refuted(refutation);
                }
                Identity::Refuted(_) | Identity::Undecided(_) => {
                    let mut case = gathered.clone();
                    case.premises.equations.insert(0, (pivot, zero));
                    if refutes
                        && gathered.complete
                        && !self.loosened
                        && let Some(refuted) = self.at_rest(&case, equations)
                    {
                        self.settled = None;
                        return refuted;
                    }
                    false
                }
            };
            if discharged {
                proof.conditions.retain(|c| *c != Condition::Pivot(pivot));
            }
        }
        Identity::Proved(proof)
    }

    /// Whether an operation may come from one of its branches to another, whatever has its sign at all times. What passes a pole may
    /// have the other sign beyond, without a zero between.
    pub(super) fn may_reach_edge(&mut self, e: Expr, gathered: &Gathered) -> bool {
        let edges = self.graph.edges(e);
        edges.into_iter().filter(|edge| !edge.is_pole()).any(|edge| {
            let Some(vanishing) = edge.vanishing else { return true };
            let mut within = vec![vanishing];
            self.add_definitions(&mut within);
            let mut excluded = self.poles(within);
            excluded.push(vanishing);
            excluded.into_iter().any(|v| self.moves(v) && !self.never_vanishes(v, gathered))
        })
    }

    /// The functions with several branches in what goes along a motion, but those whose arguments are constant.
    pub(super) fn leaping(&mut self, gathered: &Gathered, equations: &Pairs, moved: bool) -> Vec<Expr> {
        let integral = self.claim.forms.iter().any(|form| matches!(form, Form::FirstIntegral(_)));
        let (true, Some(time)) = (moved || integral, self.claim.scope.time()) else { return Vec::new() };
        let scope = &self.claim.scope;
        let moves = |leaf: Leaf| scope.moves(&leaf);
        let mut out = self.leaps(equations);
        out.retain(|&e| self.may_reach_edge(e, gathered));
        let (proved_at, settled) = (self.proved_at, self.settled.take());
        out.retain(|&e| {
            let arguments: Vec<Expr> = self.graph.node(e).children().collect();
            let zero = self.graph.integer(0);
            let rates: Option<Pairs> = arguments
                .into_iter()
                .map(|a| self.graph.time_derivative(a, time, moves).ok().map(|rate| (rate, zero)))
                .collect();
            !rates.is_some_and(|rates| without_exceptions(&self.levels(gathered, &rates, false)))
        });
        (self.proved_at, self.settled) = (proved_at, settled);
        out
    }
}
