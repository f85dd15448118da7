//! Comparisons: what every form of claim becomes.
//!
//! **In:** the two sides of a relation. **Out:** scalar [`Comparison`]s, gathered in [`Group`]s with what they must be together
//! (all components of one equation share one sign of ±), and what is known of a comparison at one point.
//!
//! **The rule.** With v = left − right and b its propagated error bound, an equation is *false* when |v| > κ·b,
//! *true* when |v| ≤ b and b is small against the size of the terms (b ≤ precision · scale), and *open*
//! otherwise: a loose bound can excuse a wrong formula, so it never makes a claim hold. κ = [`GUARD`] leaves room between
//! the two, because the error of a trajectory is an estimate.

use crate::expr::domain::row;
use crate::expr::{Expr, Graph, Leaf, Node, Op, Rational};
use crate::latex::{RelationKind, Role, Scope};
use crate::mute::Told;
use crate::number::Bounded;
use crate::verdict::{Possible, Proposition, Quantifier, Truth};

/// A residual refutes an equation only beyond this many error bounds.
pub const GUARD: f64 = 10.0;

/// One scalar comparison of a claim.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// How a report names it: the formula, with the component where there are several.
    pub label: String,
    /// What is claimed of the two sides.
    pub kind: RelationKind,
    /// The left side.
    pub left: Expr,
    /// The right side.
    pub right: Expr,
    /// Sum of the sizes of the terms of both sides: what "small" is measured by.
    pub magnitude: Expr,
    /// What vanishes where an inequality can change between two samples, for each sign of ±: left − right; of |u| and a positive
    /// number c u − c and u + c, which are smooth where u is 0. Empty for equations, and for what does not move.
    pub boundaries: Vec<Expr>,
    /// What vanishes where an equation that is one of several alternatives is true, perhaps at a single time: left − right.
    pub meetings: Vec<Expr>,
    /// Its terms, for the question whether it says anything.
    pub told: Told,
    /// y and x of every atan2(y, x) in it. What is continued along a motion has no cut.
    pub cuts: Vec<[Expr; 2]>,
}

impl Comparison {
    /// A comparison with its magnitude, for which observables are traced back to what they are computed from.
    pub fn new(
        graph: &mut Graph,
        scope: &Scope,
        label: String,
        kind: RelationKind,
        left: Expr,
        right: Expr,
    ) -> Comparison {
        let magnitude = magnitude_of(graph, scope, left, right);
        let boundaries = if kind == RelationKind::Equal { Vec::new() } else { boundaries(graph, scope, left, right) };
        let cuts = cuts(graph, scope, [left, right]);
        let meetings = Vec::new();
        Comparison { label, kind, left, right, magnitude, boundaries, meetings, told: Told::default(), cuts }
    }

    /// A comparison of `node` that is measured by other means than its formulas.
    pub fn measured(label: String, kind: RelationKind, node: Expr) -> Comparison {
        let (boundaries, meetings, cuts) = (Vec::new(), Vec::new(), Vec::new());
        let told = Told::default();
        Comparison { label, kind, left: node, right: node, magnitude: node, boundaries, meetings, told, cuts }
    }
}

/// The size of the terms of both sides, observables traced back to what they are computed from.
pub fn magnitude_of(graph: &mut Graph, scope: &Scope, left: Expr, right: Expr) -> Expr {
    let (mut l, mut r) = (traced(graph, scope, left), traced(graph, scope, right));
    if graph.is_zero(l) || graph.is_zero(r) {
        // That the rate of an observable vanishes: its terms cancel, so that its own size is none.
        [l, r] = [l, r].map(|e| {
            let e = behind_rates(graph, scope, e);
            traced(graph, scope, e)
        });
    }
    let (a, b) = (magnitude(graph, l), magnitude(graph, r));
    graph.add(a, b)
}

/// Where angles atan2(y, x) have their cuts: y and x. Observables are written out, but for those that are continued along a motion.
pub fn cuts(graph: &mut Graph, scope: &Scope, of: impl IntoIterator<Item = Expr>) -> Vec<[Expr; 2]> {
    let written: Vec<Expr> = of.into_iter().map(|e| traced_without_angles(graph, scope, e)).collect();
    graph.arctan2s(written)
}

/// left − right for each sign of ±, unless it does not move.
pub(super) fn boundaries(graph: &mut Graph, scope: &Scope, left: Expr, right: Expr) -> Vec<Expr> {
    let sign = scope.branch_sign();
    let leaves = graph.leaves_within([left, right]);
    let moves = |l: &Leaf| *l != sign && l.instant.is_none() && scope.role(l.symbol) != Some(Role::Parameter);
    if !leaves.iter().any(moves) {
        return Vec::new();
    }
    let difference = graph.sub(left, right);
    if !leaves.contains(&sign) {
        return match inside_size(graph, left, right).or_else(|| inside_size(graph, right, left)) {
            Some((u, c)) => vec![graph.sub(u, c), graph.add(u, c)],
            None => vec![difference],
        };
    }
    [1, -1].map(|n| graph.rewrite(difference, |g, l| (l == sign).then(|| g.integer(n)))).to_vec()
}

/// u and c, where one side is |u| and the other a positive number c.
fn inside_size(graph: &Graph, size: Expr, other: Expr) -> Option<(Expr, Expr)> {
    let Node::Unary(Op::Abs, u) = graph.node(size) else { return None };
    graph.as_constant(other).is_some_and(|c| *c > Rational::ZERO).then_some((*u, other))
}

/// Comparisons at one time, and what they must be together.
#[derive(Clone, Debug)]
pub struct Group {
    /// The comparisons.
    pub comparisons: Vec<Comparison>,
    /// What is said of them; that all are true, where there is none.
    pub formula: Option<Proposition>,
    /// Whether a ± occurs.
    pub branching: bool,
    /// For how many signs of ± it must be so.
    pub signs: Quantifier,
    /// Whether one sign of ± must serve the whole motion.
    pub throughout: bool,
    /// Whether it says that the left sides have values: what has none is false, not void. Its equations say nothing else.
    pub asserted: bool,
    /// Whether the comparisons are the opposites of what is written, which must not be.
    pub denied: bool,
    /// What leaves one comparison without a value and not another, or for one sign of ±: where it vanishes, the sign that serves
    /// elsewhere may not count, and the other is false.
    pub one_sided: Vec<Expr>,
}

impl Default for Group {
    fn default() -> Group {
        Group {
            comparisons: Vec::new(),
            formula: None,
            branching: false,
            signs: Quantifier::Some,
            throughout: false,
            asserted: false,
            denied: false,
            one_sided: Vec::new(),
        }
    }
}

impl Group {
    /// Whether an angle in it may leap: what is so on both sides of a leap need not be so at it.
    pub fn leaps(&self) -> bool {
        self.comparisons.iter().any(|c| !c.cuts.is_empty())
    }

    /// Whether at each time some sign of ± serves, not the same at all of them.
    pub fn chooses(&self) -> bool {
        self.branching && !self.throughout && self.signs == Quantifier::Some
    }

    /// What the group is, where `comparison` tells what is known of each comparison, for one sign of ±.
    pub fn value(&self, mut comparison: impl FnMut(usize) -> Possible) -> Possible {
        let mut one = |n: usize| match self.asserted {
            true => comparison(n).asserted(),
            false => comparison(n),
        };
        match &self.formula {
            Some(formula) => formula.value(&mut one),
            None => (0..self.comparisons.len()).fold(Possible::TRUE, |value, n| value.and(one(n))),
        }
    }

    /// The same for all signs of ± together, where one sign need not serve the whole motion.
    pub fn over_signs(&self, signs: impl Iterator<Item = Possible>) -> Possible {
        let mut silent = false;
        let joined = signs.inspect(|s| silent |= s.may_be(Truth::Void)).reduce(|a, b| self.signs.join(a, b));
        match joined {
            // The sign that serves throughout may be one that says nothing here.
            Some(Possible::FALSE) if silent && self.throughout => Possible::ANY,
            Some(joined) => joined,
            None => Possible::ANY,
        }
    }

    /// Whether agreement to within an allowance may count as equality of a comparison: in a conjunction that is said, for some
    /// sign; not where it must not be, or where it says that something has a value.
    pub fn allows(&self) -> bool {
        !(self.denied || self.asserted) && self.formula.is_none() && self.signs == Quantifier::Some
    }
}

/// `e` with observables replaced by their definitions, at fixed times too; rates stay.
pub fn traced(graph: &mut Graph, scope: &Scope, e: Expr) -> Expr {
    written_out(graph, scope, e, |_| true)
}

/// `e` with observables replaced by their definitions, down to states, parameters and time; rates and values at fixed
/// times stay.
pub fn traced_now(graph: &mut Graph, scope: &Scope, e: Expr) -> Expr {
    written_out(graph, scope, e, |leaf| leaf.instant.is_none())
}

/// The same, but for angles that are continued along a motion: these are not what their formulas are.
pub fn traced_without_angles(graph: &mut Graph, scope: &Scope, e: Expr) -> Expr {
    written_out(graph, scope, e, |leaf| leaf.instant.is_none() && !scope.is_angle(leaf.symbol))
}

/// What has a value exactly where `e` has one: `e` behind rates and traced, at fixed times, too, but for angles that are continued;
/// and the formulas of these angles.
pub fn presupposed(graph: &mut Graph, scope: &Scope, e: Expr) -> Vec<Expr> {
    let written = |graph: &mut Graph, e: Expr| {
        let e = behind_rates(graph, scope, e);
        written_out(graph, scope, e, |leaf| !scope.is_angle(leaf.symbol))
    };
    let mut out = vec![written(graph, e)];
    let mut next = 0;
    while let Some(&e) = out.get(next) {
        next += 1;
        for leaf in graph.leaves_within([e]).into_iter().filter(|l| l.rate == 0 && scope.is_angle(l.symbol)) {
            let definition = scope.definition(leaf.symbol);
            let Some(&value) = definition.and_then(|d| d.components.get(usize::from(leaf.component))) else { continue };
            let value = match leaf.instant {
                Some(instant) => at_instant(graph, scope, value, instant),
                None => value,
            };
            let value = written(graph, value);
            if !out.contains(&value) {
                out.push(value);
            }
        }
    }
    out
}

/// Whether the value of a formula may leap along a motion: an operation needs something, or has an edge, at which it may end or leap.
pub fn may_leap(graph: &Graph, e: Expr) -> bool {
    graph.reachable([e]).into_iter().any(|e| match *graph.node(e) {
        Node::Unary(op, _) | Node::Binary(op, ..) => !row(op).needs.is_empty() || !row(op).edges.is_empty(),
        Node::Constant(_) | Node::Pi | Node::Leaf(_) => false,
    })
}

/// Whether an angle with this formula is not the formula itself: this may leap, or something in it that is defined may, or is an angle that
/// is continued, too.
pub fn is_continued(graph: &mut Graph, scope: &Scope, formula: Expr) -> bool {
    let (leaps, written) = leaps_behind(graph, scope, formula);
    leaps || graph.leaves_within([written]).iter().any(|leaf| scope.is_angle(leaf.symbol))
}

/// The same of a formula with what is defined, but for angles that are continued; with the formula written out.
pub fn leaps_behind(graph: &mut Graph, scope: &Scope, formula: Expr) -> (bool, Expr) {
    let written = behind_rates(graph, scope, formula);
    let written = traced_without_angles(graph, scope, written);
    let is_open = |leaf: &Leaf| leaf.rate > 0 && scope.definition(leaf.symbol).is_some();
    (may_leap(graph, written) || graph.leaves_within([written]).iter().any(is_open), written)
}

/// `e` with the rates of observables replaced by those of their definitions; a rate that cannot be formed stays, and so do
/// observables themselves.
pub fn behind_rates(graph: &mut Graph, scope: &Scope, e: Expr) -> Expr {
    let Some(time) = scope.time() else { return e };
    let moves = |leaf: Leaf| scope.moves(&leaf);
    let mut form = |graph: &mut Graph, leaf: Leaf| {
        let definition = scope.definition(leaf.symbol).filter(|_| leaf.rate > 0 && leaf.instant.is_none())?;
        let mut value = definition.components.get(usize::from(leaf.component)).copied()?;
        // The rate of an angle that is continued is not that of its formula where this leaps.
        value = traced_without_angles(graph, scope, value);
        for _ in 0..leaf.rate {
            let mut rate = graph.time_derivative(value, time, moves).ok()?;
            if scope.is_angle(leaf.symbol) {
                rate = graph.continued(value, rate);
            }
            value = graph.rate_of(value, rate, |_| false);
        }
        Some(value)
    };
    // Definitions are acyclic, and so are those of the rates of angles.
    let mut e = e;
    loop {
        let formed = graph.substitute(e, &mut form);
        if formed == e {
            return e;
        }
        e = formed;
    }
}

fn written_out(graph: &mut Graph, scope: &Scope, e: Expr, put: impl Fn(Leaf) -> bool) -> Expr {
    let mut e = e;
    // Definitions are acyclic: each is written in terms of earlier symbols.
    loop {
        let mut changed = false;
        e = graph.substitute(e, |graph, leaf| {
            let definition = scope.definition(leaf.symbol).filter(|_| leaf.rate == 0 && put(leaf))?;
            let component = definition.components.get(usize::from(leaf.component)).copied()?;
            changed = true;
            Some(match leaf.instant {
                Some(instant) => at_instant(graph, scope, component, instant),
                None => component,
            })
        });
        if !changed {
            return e;
        }
    }
}

/// `e` at a fixed time: every leaf that can move is replaced by its value then.
pub fn at_instant(graph: &mut Graph, scope: &Scope, e: Expr, instant: Expr) -> Expr {
    let time = scope.time();
    graph.substitute(e, |graph, leaf| {
        if Some(leaf) == time {
            return Some(instant);
        }
        let moves = scope.moves(&leaf);
        (moves && leaf.instant.is_none()).then(|| graph.leaf(Leaf { instant: Some(instant), ..leaf }))
    })
}

/// The size of the terms that an expression is made of: sums do not cancel, everything else as it is.
///
/// For a residual like `[A − B cos²ψ] sin²θ` it is (|A| + |B| cos²ψ) sin²θ, which stays of the size of what was computed
/// even where the bracket vanishes.
fn magnitude(graph: &mut Graph, e: Expr) -> Expr {
    let mut image = std::collections::HashMap::new();
    for node in graph.reachable([e]) {
        let m = match graph.node(node).clone() {
            Node::Pi => node,
            Node::Constant(_) | Node::Leaf(_) => graph.unary(Op::Abs, node),
            Node::Unary(Op::Neg, a) => image[&a],
            Node::Unary(Op::Sqrt, a) => graph.unary(Op::Sqrt, image[&a]),
            Node::Unary(Op::Powi(n), a) if n >= 0 => graph.powi(image[&a], n),
            Node::Binary(Op::Add | Op::Sub, a, b) => graph.add(image[&a], image[&b]),
            Node::Binary(Op::Mul, a, b) => graph.mul(image[&a], image[&b]),
            Node::Binary(Op::Restrict, a, _) => image[&a],
            Node::Binary(Op::Div, a, b) => {
                let under = graph.unary(Op::Abs, b);
                graph.div(image[&a], under)
            }
            // Bounded functions and angles are of the size 1, also where they happen to vanish.
            Node::Unary(op, _) | Node::Binary(op, ..) if row(op).is_bounded() => graph.integer(1),
            Node::Unary(..) | Node::Binary(..) => graph.unary(Op::Abs, node),
        };
        image.insert(node, m);
    }
    image[&e]
}

/// Judges `left kind right`, where `difference` is left − right with its error bound.
///
/// `scale` is the size of the terms, see `magnitude`; `precision` what the claim asks for, relative to it.
pub fn judge(kind: RelationKind, difference: Bounded, scale: f64, precision: f64) -> Possible {
    let (v, b) = (difference.value, difference.error);
    let tight = b <= precision * scale;
    let (zero, apart) = (v.abs() <= b, v.abs() > GUARD * b);
    let decide = |satisfied: bool, violated: bool| match (satisfied, violated) {
        (true, _) => Possible::TRUE,
        (_, true) => Possible::FALSE,
        _ => Possible::OPEN,
    };
    match kind {
        RelationKind::Equal => decide(zero && tight, apart),
        RelationKind::NotEqual => decide(apart, zero && tight),
        RelationKind::Less => decide(apart && v < 0.0, (apart && v > 0.0) || (zero && tight)),
        RelationKind::LessEqual => decide((apart && v < 0.0) || (zero && tight), apart && v > 0.0),
        RelationKind::Greater => decide(apart && v > 0.0, (apart && v < 0.0) || (zero && tight)),
        RelationKind::GreaterEqual => decide((apart && v > 0.0) || (zero && tight), apart && v < 0.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(value: f64, error: f64) -> Bounded {
        Bounded { value, error }
    }

    #[test]
    fn a_loose_bound_never_makes_an_equation_hold() {
        assert_eq!(judge(RelationKind::Equal, at(1e-14, 1e-13), 1.0, 1e-9), Possible::TRUE);
        assert_eq!(judge(RelationKind::Equal, at(1e-14, 1e-6), 1.0, 1e-9), Possible::OPEN);
        assert_eq!(judge(RelationKind::Equal, at(0.0, 0.0), 1.0, 1e-9), Possible::TRUE);
    }

    #[test]
    fn beyond_the_guarded_bound_an_equation_is_violated_and_between_it_is_open() {
        assert_eq!(judge(RelationKind::Equal, at(1.1e-12, 1e-13), 1.0, 1e-9), Possible::FALSE);
        assert_eq!(judge(RelationKind::Equal, at(5e-13, 1e-13), 1.0, 1e-9), Possible::OPEN);
        assert_eq!(judge(RelationKind::Equal, at(1.0, 0.01), 1.0, 1e-9), Possible::FALSE);
    }

    #[test]
    fn strict_relations_exclude_equality_and_weak_ones_admit_it() {
        let zero = at(1e-16, 1e-15);
        assert_eq!(judge(RelationKind::Less, zero, 1.0, 1e-9), Possible::FALSE);
        assert_eq!(judge(RelationKind::LessEqual, zero, 1.0, 1e-9), Possible::TRUE);
        assert_eq!(judge(RelationKind::Greater, zero, 1.0, 1e-9), Possible::FALSE);
        assert_eq!(judge(RelationKind::GreaterEqual, zero, 1.0, 1e-9), Possible::TRUE);
        assert_eq!(judge(RelationKind::NotEqual, zero, 1.0, 1e-9), Possible::FALSE);
        let below = at(-0.5, 1e-15);
        assert_eq!(judge(RelationKind::Less, below, 1.0, 1e-9), Possible::TRUE);
        assert_eq!(judge(RelationKind::LessEqual, below, 1.0, 1e-9), Possible::TRUE);
        assert_eq!(judge(RelationKind::Greater, below, 1.0, 1e-9), Possible::FALSE);
        assert_eq!(judge(RelationKind::GreaterEqual, below, 1.0, 1e-9), Possible::FALSE);
        assert_eq!(judge(RelationKind::NotEqual, below, 1.0, 1e-9), Possible::TRUE);
    }
}
