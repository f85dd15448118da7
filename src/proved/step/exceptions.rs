//! The cases that a proof leaves out: those that are empty, or in which it holds, too.
//!
//! **In:** a proof, with what it divided by. **Out:** the proof without such conditions; or the refutation that one of them holds. A
//! function with several branches leaps where it is left out: of what goes along a motion those are named.

use super::definitions::Definitions;
use super::gather::Gathered;
use super::{Pairs, Step, has_exceptions, without_exceptions};
use crate::expr::domain::{Change, Sign};
use crate::expr::{Expr, FastMap, Graph, Leaf, Node, Op};
use proof::{Identity, Known, Options, Premises, Reason, Wanted, When};

/// Most exceptions of a proof that are looked at by themselves.
const MOST_EXCEPTIONS: usize = 6;

impl Step<'_> {
    /// A proof without those of its exceptions that are empty, or in which the claim is proved, too; or the refutation that one
    /// of them holds.
    ///
    /// What is claimed holds where what was divided by is not 0. Two rules look at where it is. *At a time*: that it is 0 is one more
    /// premise, known at the present alone. *For a while*: a time at which it is 0 is a limit of others, at which the claim holds, and then
    /// it holds there, see [`holds_at_limits`](Step::holds_at_limits); or it is 0 on an interval, with all its derivatives.
    pub(super) fn without_empty_cases(
        &mut self,
        identity: Identity,
        gathered: &Gathered,
        equations: &Pairs,
        refutes: bool,
    ) -> Identity {
        let Identity::Proved(mut proof) = identity else { return identity };
        let limits = self.holds_at_limits(gathered, equations);
        let zero = self.graph.integer(0);
        let left_out: Vec<Expr> =
            proof.conditions.iter().filter_map(|c| c.leaves_out()).take(MOST_EXCEPTIONS).collect();
        for pivot in left_out {
            // Auxiliary numbers are no part of the question.
            let leaves = self.graph.leaves_within([pivot]);
            let scope = &self.claim.scope;
            if leaves.iter().any(|l| scope.role(l.symbol).is_none()) {
                continue;
            }
            let time = scope.time();
            let of_time = !leaves.is_empty() && leaves.iter().all(|&l| Some(l) == time);
            let analytic = time.is_some_and(|time| self.graph.is_analytic_in(pivot, time));
            // What is an analytic function of the time alone vanishes at single times only.
            if limits && of_time && analytic {
                proof.conditions.retain(|c| c.leaves_out() != Some(pivot));
                continue;
            }
            let when = match (self.depends(pivot), limits) {
                (false, _) => When::Always,
                (true, true) => When::ChosenOpen,
                (true, false) => When::Chosen,
            };
            let mut premises = self.premises(gathered, equations, Definitions::All);
            if when == When::ChosenOpen {
                self.put_zero(pivot, &mut premises);
            }
            premises.equations.insert(0, Known::of((pivot, zero), when));
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
                Identity::Refuted(refutation) if refutes && gathered.complete && self.in_part.is_empty() => {
                    self.settled = None;
                    return Identity::Refuted(refutation);
                }
                Identity::Refuted(_) | Identity::Undecided(_) => {
                    let mut case = gathered.clone();
                    case.premises.equations.insert(0, Known::of((pivot, zero), When::Always));
                    if refutes
                        && gathered.complete
                        && self.in_part.is_empty()
                        && let Some(refuted) = self.at_rest(&case, equations)
                    {
                        self.settled = None;
                        return refuted;
                    }
                    false
                }
            };
            if discharged {
                proof.conditions.retain(|c| c.leaves_out() != Some(pivot));
            }
        }
        Identity::Proved(proof)
    }

    /// Whether equations that hold at all times of the present but some hold at these, too, if they are limits of others: each time of the
    /// present has a neighbourhood of such; both sides, their definitions put in, have values around it, and do not leap.
    fn holds_at_limits(&mut self, gathered: &Gathered, equations: &Pairs) -> bool {
        if !gathered.premises.present.is_on_intervals() {
            return false;
        }
        let sides: Vec<Expr> = equations.iter().flat_map(|&(l, r)| [l, r]).collect();
        let named = self.graph.leaves_within(sides.iter().copied());
        let mut roots = sides;
        for &leaf in &named {
            let own = self.claim.scope.definition(leaf.symbol).is_some();
            let value = Leaf { rate: 0, instant: None, ..leaf };
            roots.extend(self.definition(value, Definitions::All).filter(|_| !own));
        }
        self.add_definitions(&mut roots);
        for e in self.graph.reachable(roots.iter().copied()) {
            let jumps = self.graph.edges(e).into_iter().filter(|edge| matches!(edge.change, Change::Jump(_)));
            if jumps.flat_map(|edge| edge.passing()).collect::<Vec<_>>().into_iter().any(|v| self.depends(v)) {
                return false;
            }
        }
        // The rate of a function with an edge need not be continuous where it exists.
        for leaf in named.into_iter().filter(|l| l.rate > 0) {
            let mut formula = vec![self.graph.leaf(Leaf { rate: 0, instant: None, ..leaf })];
            self.add_definitions(&mut formula);
            if !self.edges_below(formula).is_empty() {
                return false;
            }
        }
        // So it is where the rate of √x is named at x = 0.
        let of_rates: Vec<Expr> =
            self.graph.needs_below(roots.iter().copied()).into_iter().filter(|n| !n.certain).map(|n| n.value).collect();
        if of_rates.into_iter().any(|e| self.depends(e)) {
            return false;
        }
        let of_systems = self.sides_of_systems();
        let needed: Vec<Expr> = self.graph.implied_below(of_systems).iter().map(|n| n.value).collect();
        let ends: Vec<Expr> = self
            .graph
            .needs_below(roots)
            .into_iter()
            .filter(|n| n.sign == Sign::NotNegative)
            .map(|n| n.value)
            .collect();
        ends.into_iter().all(|e| !self.depends(e) || needed.contains(&e) || self.is_met(e, Sign::NotNegative, gathered))
    }

    /// Premises where something is 0 for a while: roots and sizes of it are 0, and smooth.
    fn put_zero(&mut self, pivot: Expr, premises: &mut Premises) {
        let zero = self.graph.integer(0);
        let vanishes = |graph: &Graph, e: Expr| e == pivot || graph.root_of_zeros(e) == pivot;
        premises.edges.retain(|&(_, edge)| !vanishes(&self.graph, edge));
        let mut image: FastMap<Expr, Expr> = FastMap::default();
        let roots: Vec<Expr> = premises.sides().collect();
        for node in self.graph.reachable(roots) {
            let new = match *self.graph.node(node) {
                Node::Unary(Op::Sqrt | Op::Abs, a) if vanishes(&self.graph, a) => zero,
                Node::Unary(op, a) => {
                    if image[&a] == a {
                        node
                    } else {
                        self.graph.unary(op, image[&a])
                    }
                }
                Node::Binary(op, a, b) => {
                    if (image[&a], image[&b]) == (a, b) {
                        node
                    } else {
                        self.graph.binary(op, image[&a], image[&b])
                    }
                }
                Node::Constant(_) | Node::Pi | Node::Leaf(_) => node,
            };
            image.insert(node, new);
        }
        for known in &mut premises.equations {
            *known = known.with((image[&known.left], image[&known.right]));
        }
    }

    /// Whether an operation may come from one of its branches to another, whatever has its sign at all times. What passes a pole may
    /// have the other sign beyond, without a zero between.
    pub(super) fn may_reach_edge(&mut self, e: Expr, gathered: &Gathered) -> bool {
        let edges = self.graph.edges(e);
        edges.into_iter().filter(|edge| !edge.is_pole()).any(|edge| {
            let Some(vanishing) = edge.vanishing else { return true };
            let mut within = vec![vanishing];
            self.add_definitions(&mut within);
            let passes = |this: &mut Self, v: Expr| this.moves(v) && !this.never_vanishes(v, gathered);
            self.poles(within).into_iter().any(|v| passes(self, v))
                || edge.passing().any(|v| passes(self, v)) && !self.never_vanishes(vanishing, gathered)
        })
    }

    /// The functions with several branches in what goes along a motion, but those whose arguments are constant.
    pub(super) fn leaping(&mut self, gathered: &Gathered, equations: &Pairs, moved: bool) -> Vec<Expr> {
        let integral = self.claim.states_integral();
        let (true, Some(time)) = (moved || integral, self.claim.scope.time()) else { return Vec::new() };
        let scope = &self.claim.scope;
        let moves = |leaf: Leaf| scope.moves(&leaf);
        let mut out = self.leaps(equations);
        let Some(gathered) = &self.between_times(gathered) else { return out };
        out.retain(|&e| self.may_reach_edge(e, gathered));
        let (proved_at, settled) = (self.proved_at, self.settled.take());
        out.retain(|&e| {
            let arguments: Vec<Expr> = self.graph.node(e).children().collect();
            let zero = self.graph.integer(0);
            let rates: Option<Pairs> = arguments
                .into_iter()
                .map(|a| self.graph.time_derivative(a, time, moves).ok().map(|rate| (rate, zero)))
                .collect();
            !rates.is_some_and(|rates| without_exceptions(&self.levels(gathered, &rates, false, Wanted::Proof)))
        });
        (self.proved_at, self.settled) = (proved_at, settled);
        out
    }
}
