//! The definitions of what a step names, as premises.
//!
//! **In:** the equations of a step, and how much of the definitions is used. **Out:** the definitions of the observables that occur, at the
//! present and at fixed times, and the systems that are given where something moves.

use super::gather::sides;
use super::{Pairs, Step};
use crate::derivation::Premise;
use crate::expr::domain::Sign;
use crate::expr::{Expr, FastSet, Graph, Leaf, Node, Op};
use claim::comparison::{at_instant, is_continued};
use proof::{Premises, When, is_never_negative};

/// Which definitions of observables are used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Definitions {
    /// None: an observable is what the premises say of it.
    None,
    /// Those of symbols that are declared for a claim.
    OfClaims,
    /// Those, and all at the fixed times that occur.
    Then,
    /// All, at the present time.
    Now,
    /// All, also at the fixed times that occur.
    All,
    /// All, and the systems that are given where no rate occurs, but an equation ties what moves. Only such a point can refute.
    Everything,
}

impl Definitions {
    /// In the order of trying: all but the last leave something out.
    pub(super) const LEVELS: [Definitions; 6] = [
        Definitions::None,
        Definitions::OfClaims,
        Definitions::Then,
        Definitions::Now,
        Definitions::All,
        Definitions::Everything,
    ];
}

/// What an angle has of its formula.
enum Continued {
    /// It is its formula.
    No,
    /// It has its rate.
    Rate(Expr),
    /// That cannot be said.
    Unknown,
}

impl Step<'_> {
    /// The definition of a component, as far as definitions are used.
    pub(super) fn definition(&self, leaf: Leaf, which: Definitions) -> Option<Expr> {
        let of_file = self.derivation.scope.definition(leaf.symbol);
        let definition = match which {
            Definitions::None => None,
            Definitions::Now | Definitions::All | Definitions::Everything => self.derivation.definition(leaf.symbol),
            _ => self.derivation.definition(leaf.symbol).filter(|_| of_file.is_none()),
        };
        definition?.components.get(usize::from(leaf.component)).copied()
    }

    /// Whether systems that are given may tie states by what they say of rates: several may name one rate, and one that does not determine
    /// its rates may say something else.
    fn systems_tie_states(&mut self) -> bool {
        let given = Step::given(self.derivation, self.claim);
        let systems = given.iter().filter(|name| matches!(self.derivation.premise(name), Premise::System(_))).count();
        systems > 1 || systems == 1 && self.rates_of_systems().is_none()
    }

    /// Whether motions of the systems that are given are where something has one sign: where right sides have values, or where a sign is
    /// given of what moves. A point elsewhere is on none, and what leads from the given place to another is the system.
    fn leads_through_a_region(&mut self, systems: &[(Expr, Expr)], premises: &Premises) -> bool {
        let signed = self.graph.leaves_within(premises.signs()).iter().any(|l| self.claim.scope.moves(l));
        let needs = self.graph.needs_below(sides(systems));
        !systems.is_empty() && (signed || needs.iter().any(|need| need.sign != Sign::NotZero))
    }

    /// The definitions of the observables that occur, of those in these, and so on; where rates occur, the systems that
    /// are given join in. What does not occur is left out: a premise less can only lose a proof. Where a point may refute, the
    /// systems join in, too, where an equation that is given ties what moves, or a sign; where their sides have values in a part
    /// of space only; or where they have one without a rate: with the rates of that they may say more.
    pub(super) fn definitions(
        &mut self,
        equations: &Pairs,
        systems: &[(Expr, Expr)],
        which: Definitions,
        premises: &mut Premises,
    ) {
        let mut seen: Vec<Leaf> = Vec::new();
        let tied = |graph: &Graph, &(l, r): &(Expr, Expr)| {
            graph.leaves_within([l, r]).iter().any(|l| l.instant.is_none() && self.claim.scope.moves(l))
        };
        let constraint =
            |graph: &Graph, &(l, r): &(Expr, Expr)| graph.leaves_within([l, r]).iter().all(|l| l.rate == 0);
        let mut moving = which == Definitions::Everything
            && (premises.pairs().any(|pair| tied(&self.graph, &pair))
                || systems.iter().any(|pair| constraint(&self.graph, pair))
                || self.leads_through_a_region(systems, premises)
                || self.systems_tie_states());
        let roots: Vec<Expr> = sides(equations).chain(premises.sides()).chain(premises.signs()).collect();
        let mut open = self.graph.leaves_within(roots);
        let mut joined = false;
        loop {
            while let Some(leaf) = open.pop() {
                moving |= leaf.rate > 0 || self.graph.is_field(leaf.symbol);
                let value = Leaf { rate: 0, ..leaf };
                if value.instant.is_some() || seen.contains(&value) {
                    continue;
                }
                seen.push(value);
                if let Some(e) = self.definition(value, which) {
                    match self.continued(value, e, equations, premises) {
                        Continued::No => {
                            let node = self.graph.leaf(value);
                            let when = self.when_it_has_a_value(e);
                            premises.give([(node, e)], when);
                        }
                        // Whole turns may lie between it and its formula: only its rate is that of the formula.
                        Continued::Rate(rate) => {
                            let node = self.graph.leaf(Leaf { rate: 1, ..value });
                            premises.give([(node, rate)], When::Always);
                            moving = true;
                            self.in_part.push(value);
                        }
                        Continued::Unknown => self.in_part.push(value),
                    }
                    open.extend(self.graph.leaves_within([e]));
                }
            }
            if !moving || systems.is_empty() || std::mem::replace(&mut joined, true) {
                return;
            }
            let new: Pairs = systems.iter().filter(|&&p| !premises.says(p)).copied().collect();
            premises.give(new, When::Always);
            open.extend(self.graph.leaves_within(sides(systems)));
        }
    }

    /// When a formula has a value: a symbol is what it stands for there alone.
    fn when_it_has_a_value(&mut self, e: Expr) -> When {
        let needs = self.graph.needs_below([e]);
        let open = needs.into_iter().any(|need| {
            let met = need.sign == Sign::NotNegative && is_never_negative(&self.graph, need.value);
            !met && self.depends(need.value)
        });
        if open { When::ChosenOpen } else { When::Always }
    }

    /// What an angle that is continued along motions has of its formula, where more of it occurs than its sine and cosine.
    fn continued(&mut self, leaf: Leaf, e: Expr, equations: &Pairs, premises: &Premises) -> Continued {
        if !self.derivation.is_angle(leaf.symbol) || !is_continued(&mut self.graph, &self.claim.scope, e) {
            return Continued::No;
        }
        let node = self.graph.leaf(leaf);
        let roots = sides(equations).chain(premises.sides()).chain(premises.signs());
        let bare = self.tells_turns(roots, node);
        let scope = &self.claim.scope;
        let (true, Some(time)) = (bare, scope.time()) else { return Continued::No };
        let moves = |leaf: Leaf| scope.moves(&leaf);
        match self.graph.time_derivative(e, time, moves) {
            Ok(rate) => Continued::Rate(self.graph.continued(e, rate)),
            Err(_) => Continued::Unknown,
        }
    }

    /// Whether whole turns of an angle change a formula: it stands elsewhere than in sums and whole multiples below a sine, a
    /// cosine or a tangent.
    fn tells_turns(&self, roots: impl Iterator<Item = Expr>, angle: Expr) -> bool {
        let whole = |e: Expr| self.graph.as_constant(e).is_some_and(|r| r.denominator().is_one());
        let mut seen: FastSet<(Expr, bool)> = FastSet::default();
        let mut open: Vec<(Expr, bool)> = roots.map(|e| (e, false)).collect();
        while let Some((e, periodic)) = open.pop() {
            if !seen.insert((e, periodic)) {
                continue;
            }
            if e == angle && !periodic {
                return true;
            }
            match *self.graph.node(e) {
                Node::Unary(Op::Sin | Op::Cos | Op::Tan, a) => open.push((a, true)),
                Node::Unary(Op::Neg, a) => open.push((a, periodic)),
                Node::Binary(Op::Add | Op::Sub, a, b) => open.extend([(a, periodic), (b, periodic)]),
                Node::Binary(Op::Mul, a, b) => open.extend([(a, periodic && whole(b)), (b, periodic && whole(a))]),
                Node::Unary(..) | Node::Binary(..) | Node::Constant(_) | Node::Pi | Node::Leaf(_) => {
                    open.extend(self.graph.node(e).children().map(|child| (child, false)));
                }
            }
        }
        false
    }

    /// The values at fixed times that occur obey the definitions at these times.
    pub(super) fn definitions_at_instants(&mut self, equations: &Pairs, which: Definitions, premises: &mut Premises) {
        let roots: Vec<Expr> = sides(equations).chain(premises.sides()).chain(premises.signs()).collect();
        let which = match which {
            Definitions::Now => return,
            Definitions::Then => Definitions::All,
            other => other,
        };
        let scope = &self.claim.scope;
        let mut open: Vec<Leaf> = self.graph.leaves_within(roots);
        open.retain(|l| l.instant.is_some());
        let mut seen: Vec<Leaf> = Vec::new();
        while let Some(leaf) = open.pop() {
            let (Some(instant), false) = (leaf.instant, seen.contains(&leaf)) else { continue };
            seen.push(leaf);
            if leaf.rate > 0 {
                continue;
            }
            if let Some(e) = self.definition(Leaf { instant: None, ..leaf }, which) {
                if self.derivation.is_angle(leaf.symbol) && is_continued(&mut self.graph, scope, e) {
                    self.in_part.push(leaf);
                    continue;
                }
                let then = at_instant(&mut self.graph, scope, e, instant);
                open.extend(self.graph.leaves_within([then]));
                let node = self.graph.leaf(leaf);
                premises.give([(node, then)], When::Always);
            }
        }
    }
}
