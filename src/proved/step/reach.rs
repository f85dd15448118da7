//! How far a proof reaches that goes along a motion: where something has no value, or leaps, the motion is another one beyond.
//!
//! **In:** what was proved, and the formulas of the claim and of what it is given. **Out:** what a proof does not reach, and
//! where what is given has no value.

use super::gather::Gathered;
use super::{Pairs, Step, pairs};
use crate::derivation::{Form, Premise};
use crate::expr::domain::{Change, EdgeOf};
use crate::expr::{Expr, Graph, Leaf, Node, Op, Rational, Symbol};
use crate::findings::IdentityEvidence;
use crate::findings::standing::Exception;
use crate::latex::Role;
use proof::Identity;

impl Step<'_> {
    /// What a proof that goes along a motion does not reach.
    pub(super) fn continuation(
        &mut self,
        gathered: &Gathered,
        equations: &Pairs,
        moved: bool,
        leaping: &[Expr],
    ) -> Vec<Exception> {
        let integral = self.claim.states_integral();
        if !(moved || integral) {
            return Vec::new();
        }
        let mut out: Vec<Exception> = leaping.iter().map(|&e| Exception::Leaps(e)).collect();
        let divided = self.divided_by_systems();
        let mut roots = self.along(equations);
        self.add_definitions(&mut roots);
        let mut beside = gathered.clone();
        beside.throughout.nonzero.extend(&divided);
        for (angle, hole) in self.holes(&roots) {
            if self.moves(hole) && !self.never_vanishes(hole, &beside) {
                out.push(Exception::Leaps(angle));
            }
        }
        for under in self.poles(roots) {
            let mut base = under;
            while let Node::Unary(Op::Powi(_) | Op::Sqrt | Op::Abs, a) = *self.graph.node(base) {
                base = a;
            }
            let passed = divided.contains(&under) || divided.contains(&base) || !self.moves(base);
            if passed || self.never_vanishes(base, gathered) {
                continue;
            }
            let one = Exception::Divides(base);
            if !out.contains(&one) {
                out.push(one);
            }
        }
        out
    }

    /// Whether equations with ±, of which one sign is proved, have values at the same points with either sign, all together. Where
    /// some has none and another is false with the other sign, the claim is false: a sign for which it has no value does not
    /// count.
    pub(super) fn has_values_together(
        &mut self,
        equations: &Pairs,
        identity: &Identity,
        evidence: &IdentityEvidence,
    ) -> bool {
        let Identity::Proved(proof) = identity else { return true };
        let sign = self.claim.scope.branch_sign();
        let roots: Vec<Expr> = equations.iter().flat_map(|&(l, r)| [l, r]).collect();
        let free = self.claim.branches_throughout || evidence.branch == Some(reason::SignsProved::Either);
        if free || !self.graph.leaves_within(roots).contains(&sign) {
            return true;
        }
        // Sides that are one expression are no equation, and have no value where it has none.
        let same: Pairs = self.claim.stated().flat_map(pairs).filter(|(l, r)| l == r).collect();
        let depends = |graph: &mut Graph, e: Expr| {
            graph.needs_below([e]).iter().any(|n| !graph.leaves_within([n.value]).is_empty())
        };
        if proof.conditions.is_empty() && !same.iter().any(|&(l, _)| depends(&mut self.graph, l)) {
            return true;
        }
        let mut both = [1, -1].map(|value| self.branch(equations, value));
        both[0].extend(same);
        let mut needs = both.iter().flatten().map(|&(l, r)| {
            let mut needs: Vec<_> = self.graph.needs_below([l, r]).iter().map(|n| (n.value, n.sign)).collect();
            needs.sort_unstable();
            needs.dedup();
            needs
        });
        let first = needs.next();
        needs.all(|n| Some(n) == first)
    }

    /// What is claimed along a motion.
    pub(super) fn along(&self, equations: &Pairs) -> Vec<Expr> {
        let integrals = self.claim.forms.iter().filter_map(|form| match form {
            Form::FirstIntegral(w) => Some(w.value.components.clone()),
            _ => None,
        });
        integrals.flatten().chain(equations.iter().flat_map(|&(l, r)| [l, r])).collect()
    }

    /// The functions with several branches in what is claimed along a motion.
    pub(super) fn leaps(&mut self, equations: &Pairs) -> Vec<Expr> {
        let mut roots = self.along(equations);
        self.add_definitions(&mut roots);
        let divided = self.divided_by_systems();
        let mut out = self.graph.reachable(roots);
        out.retain(|&e| {
            // A motion of a system that divides by a root does not pass its zero.
            let root = matches!(self.graph.node(e), Node::Unary(Op::Sqrt, _)) && divided.contains(&e);
            !root && self.is_branching(e)
        });
        out
    }

    /// Whether an operation passes from one of its branches to another, if its arguments move so: at an edge that is no pole.
    pub(super) fn is_branching(&mut self, e: Expr) -> bool {
        let arguments: Vec<Expr> = self.graph.node(e).children().collect();
        self.graph.edges(e).into_iter().any(|edge| match edge.change {
            // Both sides of a pole belong to the same function; a pole with one side comes with the base of a power.
            Change::Pole(..) => false,
            Change::Log | Change::Jump(_) | Change::Kink | Change::Steep => match edge.vanishing {
                Some(_) => arguments.iter().any(|&a| self.moves(a)),
                None => arguments.iter().any(|&a| self.has_poles(a)),
            },
        })
    }

    /// What vanishes where something below that moves has an edge, and a value.
    pub(super) fn edges_below(&mut self, roots: Vec<Expr>) -> Vec<Expr> {
        let mut out = Vec::new();
        for e in self.graph.reachable(roots) {
            for edge in self.graph.edges(e) {
                let has_value = match edge.change {
                    Change::Jump(_) | Change::Kink | Change::Steep => true,
                    Change::Pole(..) | Change::Log => false,
                };
                let passing = edge.passing().find(|&v| self.moves(v));
                out.extend(passing.filter(|v| has_value && !out.contains(v)));
            }
        }
        out
    }

    /// What vanishes where something below is infinite.
    pub(super) fn poles(&mut self, roots: Vec<Expr>) -> Vec<Expr> {
        let nodes = self.graph.reachable(roots);
        self.poles_of(nodes)
    }

    fn poles_of(&mut self, nodes: Vec<Expr>) -> Vec<Expr> {
        let mut out = Vec::new();
        for e in nodes {
            let poles = self.graph.edges(e).into_iter().filter(EdgeOf::is_pole);
            out.extend(poles.filter_map(|edge| edge.vanishing));
        }
        out
    }

    /// The sides of the equations of the systems among the premises.
    pub(super) fn sides_of_systems(&self) -> Vec<Expr> {
        self.equations_of_systems().into_iter().flat_map(|(l, r)| [l, r]).collect()
    }

    /// The equations of the systems among the premises.
    pub(super) fn equations_of_systems(&self) -> Pairs {
        let given = Step::given(self.derivation, self.claim);
        let systems = given.iter().filter_map(|name| match self.derivation.premise(name) {
            Premise::System(system) => Some(system),
            Premise::Claim(_) | Premise::Definition => None,
        });
        systems.flat_map(|system| self.equations_of(system)).collect()
    }

    /// The equations of a system, but for components that say 0 = 0 of all motions.
    pub(super) fn equations_of(&self, system: usize) -> Pairs {
        let equations = &self.derivation.systems[system].equations;
        let graph = &self.derivation.graph;
        let says = |(l, r): &(Expr, Expr)| !graph.vanishes(*l) || !graph.vanishes(*r);
        equations.iter().flat_map(|w| &w.value.relations).flat_map(pairs).filter(says).collect()
    }

    /// Everything that the systems among the premises divide by, as it stands and by its definition.
    pub(super) fn divided_by_systems(&mut self) -> Vec<Expr> {
        let equations = self.equations_of_systems();
        self.divided_by(&equations)
    }

    /// Everything that equations divide by: what is not 0 where they have values. A rate may be without what its formula divides by.
    pub(super) fn divided_by(&mut self, equations: &Pairs) -> Vec<Expr> {
        let mut roots: Vec<Expr> = equations.iter().flat_map(|&(l, r)| [l, r]).collect();
        self.add_definitions(&mut roots);
        let asked = self.graph.asked(&roots);
        let nodes = self.graph.reachable(roots).into_iter().filter(|e| asked.contains(e)).collect();
        let mut open = self.poles_of(nodes);
        let mut out = Vec::new();
        while let Some(e) = open.pop() {
            if out.contains(&e) {
                continue;
            }
            out.push(e);
            match *self.graph.node(e) {
                Node::Unary(Op::Powi(_), a) => open.push(a),
                Node::Binary(Op::Mul, a, b) => open.extend([a, b]),
                Node::Leaf(leaf) if leaf.rate == 0 && leaf.instant.is_none() => {
                    let definition = self.claim.scope.definition(leaf.symbol);
                    open.extend(definition.and_then(|d| d.components.get(usize::from(leaf.component)).copied()));
                }
                _ => {}
            }
        }
        out
    }

    /// Adds the definitions of the observables that occur; of angles, which are continued along the motion, without the
    /// leaps by whole turns that the continuation heals.
    pub(super) fn add_definitions(&self, roots: &mut Vec<Expr>) {
        let mut seen: Vec<Symbol> = Vec::new();
        let mut open = roots.clone();
        while !open.is_empty() {
            let mut found: Vec<Expr> = Vec::new();
            for leaf in self.graph.leaves_within(open) {
                if seen.contains(&leaf.symbol) {
                    continue;
                }
                seen.push(leaf.symbol);
                let definition = self.claim.scope.definition(leaf.symbol);
                for &e in definition.into_iter().flat_map(|d| &d.components) {
                    match self.derivation.is_angle(leaf.symbol) {
                        true => self.healed(e, &mut found),
                        false => found.push(e),
                    }
                }
            }
            roots.extend(&found);
            open = found;
        }
    }

    /// The angles of points in some formulas, with the sums of squares that vanish where they have no value: beyond, such an angle is
    /// another by half a turn, which is not healed.
    fn holes(&mut self, roots: &[Expr]) -> Vec<(Expr, Expr)> {
        let mut symbols: Vec<Symbol> =
            self.graph.leaves_within(roots.iter().copied()).iter().map(|l| l.symbol).collect();
        symbols.retain(|&s| self.derivation.is_angle(s));
        symbols.sort_unstable();
        symbols.dedup();
        let mut open: Vec<Expr> = Vec::new();
        for symbol in symbols {
            open.extend(self.claim.scope.definition(symbol).into_iter().flat_map(|d| &d.components));
        }
        let mut out = Vec::new();
        while let Some(e) = open.pop() {
            let even =
                |e: Expr| self.graph.as_constant(e).is_some_and(|r| (r / &Rational::from(2)).denominator().is_one());
            match *self.graph.node(e) {
                Node::Binary(Op::Arctan2, y, x) => {
                    let squares = [y, x].map(|e| self.graph.powi(e, 2));
                    out.push((e, self.graph.add(squares[0], squares[1])));
                }
                Node::Unary(Op::Neg, a) => open.push(a),
                Node::Binary(Op::Add | Op::Sub, a, b) => open.extend([a, b]),
                Node::Binary(Op::Mul, a, b) if even(a) || even(b) => {}
                Node::Binary(Op::Mul, a, b) => open.extend([a, b]),
                Node::Constant(_) | Node::Pi | Node::Leaf(_) | Node::Unary(..) | Node::Binary(..) => {}
            }
        }
        out
    }

    /// What an angle is made of, but arguments in place of atan2 that stands in it with a whole factor: its leaps by 2π are
    /// healed.
    fn healed(&self, e: Expr, out: &mut Vec<Expr>) {
        let whole = |e: Expr| self.graph.as_constant(e).is_some_and(|r| r.denominator().is_one());
        match *self.graph.node(e) {
            Node::Binary(Op::Arctan2, y, x) => out.extend([y, x]),
            Node::Unary(Op::Neg, a) => self.healed(a, out),
            Node::Binary(Op::Add | Op::Sub, a, b) => {
                self.healed(a, out);
                self.healed(b, out);
            }
            Node::Binary(Op::Mul, a, b) if whole(a) => self.healed(b, out),
            Node::Binary(Op::Mul, a, b) if whole(b) => self.healed(a, out),
            _ => out.push(e),
        }
    }

    /// Whether something changes along a motion.
    pub(super) fn moves(&self, e: Expr) -> bool {
        let scope = &self.claim.scope;
        let moves = |l: &Leaf| {
            let role = scope.role(l.symbol);
            l.instant.is_none() && matches!(role, Some(Role::State | Role::Observable)) || Some(*l) == scope.time()
        };
        self.graph.leaves_within([e]).iter().any(moves)
    }

    /// Whether something may be infinite at some time.
    fn has_poles(&mut self, e: Expr) -> bool {
        let mut roots = vec![e];
        self.add_definitions(&mut roots);
        self.poles(roots).into_iter().any(|under| self.moves(under))
    }
}
