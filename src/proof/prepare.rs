//! Premises before lowering: derivatives by time, explicit definitions.

mod signs;

use super::closing::Dynamics;
use super::insertion::put_in;
use super::jets::Jets;
use super::known::{Known, When};
use super::linear::Combinations;
use super::outcome::{Point, Premises, Reason, Vanishes};
use super::witness::{decimals, values_at};
use expr::domain::{Sign, row};
use expr::{Expr, Graph, Leaf, Node, Op, Rational, Symbol};
use expr::{FastMap, FastSet};
use signs::Signs;

/// An equation among the premises.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Premise {
    pub(super) left: Expr,
    pub(super) right: Expr,
    /// A derivative of a given one: used to solve for rates, and for nothing else as long as others are left.
    pub(super) derived: bool,
    /// Whether it names a rate that may have no value though the claim, and what is given, have one.
    pub(super) partial: bool,
}

impl Premise {
    fn of((left, right): (Expr, Expr), derived: bool) -> Premise {
        Premise { left, right, derived, partial: false }
    }
}

/// The solutions of the premises: which points belong to one.
#[derive(Clone, Debug, Default)]
pub(super) struct Solutions {
    dynamics: Dynamics,
    jets: Jets,
    /// These are positive at a point that refutes: what is given holds around it then, not at it alone.
    inside: Vec<Expr>,
    /// Whether something that moves is tied to a place: then no theorem says that there is a solution.
    tied: bool,
    /// For each two places at which one field is taken, what must not all be 0: values at different places are free of each
    /// other (there is a polynomial with any derivatives at finitely many points), at one place they are the same.
    apart: Vec<Vec<Expr>>,
    /// Fields of which something is given: their values are not free where only the place of another field depends on them.
    given: FastSet<Symbol>,
    /// What is known of signs at all times, of what moves.
    signs: Signs,
}

/// Values of what is free where only the place of a field depends on it.
const ELSEWHERE: [f64; 7] = [0.7109375, 1.3203125, -0.4140625, 2.6171875, -1.8203125, 3.1640625, 0.2265625];

impl Solutions {
    /// Whether derivatives beyond those that are asked for may tell more: there are more equations of motion than variables.
    pub(super) fn may_hide_constraints(&self) -> bool {
        self.dynamics.overdetermined || self.dynamics.impossible || self.jets.several
    }

    /// Whether motions, and fields, pass through a point at which the premises and their derivatives hold.
    pub(super) fn extend(&self, graph: &Graph, point: &Point) -> bool {
        let inside = decimals(graph, &self.inside, &values_at(point));
        !self.tied
            && inside.into_iter().all(|v| v.is_some_and(|v| v.value > v.error))
            && self.are_apart(graph, point)
            && self.signs.allow(graph, point)
            && self.dynamics.extends(graph, point)
            && self.jets.extends(graph, point)
    }

    /// Whether no two places at which one field is taken are the same at a point, for certain.
    fn are_apart(&self, graph: &Graph, point: &Point) -> bool {
        let mut values = values_at(point);
        let free = graph.leaves(self.apart.iter().flatten().copied());
        let is_free = |leaf: &Leaf| !self.given.contains(&graph.field_of(leaf.symbol));
        for (leaf, value) in free.into_iter().filter(is_free).zip(ELSEWHERE.into_iter().cycle()) {
            values.entry(leaf).or_insert(number::Bounded::exact(value));
        }
        self.apart.iter().all(|differences| {
            decimals(graph, differences, &values).into_iter().flatten().any(|v| v.value.abs() > v.error)
        })
    }
}

/// The premises' equations, followed by their derivatives by time as far as the claim and hidden constraints ask for, see
/// [`Dynamics`], `further` times more where there are more equations than variables, and by coordinates, see [`Jets`]; and those by time at the fixed times at which rates occur. `is_zero` tests whether something is 0 by the premises.
pub(super) fn with_rates(
    graph: &mut Graph,
    premises: &Premises,
    equations: &[(Expr, Expr)],
    is_zero: Vanishes,
    further: u8,
) -> Result<(Vec<Premise>, Solutions), Reason> {
    let on_intervals: Vec<Known> = premises.equations.iter().filter(|k| k.when.is_on_intervals()).copied().collect();
    let pointwise = premises.equations.iter().filter(|k| !k.when.is_on_intervals());
    let pointwise: Vec<Premise> = pointwise.map(|k| Premise::of(k.sides(), false)).collect();
    let mut all: Vec<Premise> = on_intervals.iter().map(|k| Premise::of(k.sides(), false)).collect();
    let moves = |leaf: Leaf| premises.moving.contains(&leaf.symbol);
    let facts = premises.signs();
    let now = pointwise.iter().flat_map(|p| [p.left, p.right]);
    let asked: Vec<Expr> = equations.iter().flat_map(|&(l, r)| [l, r]).chain(now).chain(facts).collect();
    let inside = strictly(graph, premises, &moves);
    let named: Vec<Expr> = asked.iter().copied().chain(premises.sides()).collect();
    let apart = graph.differences_of_places(named.clone());
    let given = graph.leaves_within(premises.sides().chain(premises.signs())).into_iter();
    let given: FastSet<Symbol> = given.filter(|l| graph.is_field(l.symbol)).map(|l| graph.field_of(l.symbol)).collect();
    all.extend(at_one_place(graph, named.iter().copied()));
    let jets = Jets::of(graph, premises, &asked, is_zero, further)?;
    all.extend(jets.derived.iter().map(|&pair| Premise::of(pair, true)));
    let Some(time) = premises.time else {
        all.extend(pointwise);
        return Ok((all, Solutions { jets, inside, apart, given, ..Solutions::default() }));
    };
    let place = |graph: &Graph, leaf: Leaf| leaf != time && graph.coordinate(leaf).is_some();
    let is_tied = |graph: &Graph, &(l, r): &(Expr, Expr)| {
        let leaves = graph.leaves_within([l, r]);
        leaves.iter().any(|&l| moves(l)) && leaves.iter().any(|&l| place(graph, l))
    };
    let tied = premises.pairs().any(|pair| is_tied(graph, &pair));
    // A field at a moving place moves with it.
    let here =
        |graph: &Graph, &(l, r): &(Expr, Expr)| graph.fields([l, r]).iter().any(|l| graph.place(l.symbol).is_none());
    let of_motions = on_intervals.iter().filter(|k| !here(graph, &k.sides()) && !is_tied(graph, &k.sides()));
    let of_motions: Vec<Known> = of_motions.copied().collect();
    let dynamics = Dynamics::of(graph, &of_motions, &asked, (time, &premises.angles), &moves, further)?;
    for part in &dynamics.parts {
        if !premises.says(part.sides()) {
            all.push(Premise::of(part.sides(), false));
        }
    }
    all.extend(dynamics.derived.iter().map(|k| Premise::of(k.sides(), true)));
    // At the fixed times at which rates occur everything holds that is known always, too.
    let everywhere = |k: &&Known| k.when == When::Always;
    let of_jets = on_intervals.iter().all(|k| everywhere(&k)).then_some(&jets.derived);
    let mut always: Vec<Premise> =
        on_intervals.iter().filter(everywhere).map(|k| Premise::of(k.sides(), false)).collect();
    always.extend(of_jets.into_iter().flatten().map(|&pair| Premise::of(pair, true)));
    always.extend(dynamics.parts.iter().filter(everywhere).map(|k| Premise::of(k.sides(), false)));
    always.extend(dynamics.derived.iter().filter(everywhere).map(|k| Premise::of(k.sides(), true)));
    // Of squares whose sum is 0 each one is, whatever is asked.
    let mut plain: Vec<Premise> =
        dynamics.parts.iter().filter(everywhere).map(|k| Premise::of(k.sides(), false)).collect();
    plain.retain(|p| {
        !premises.says((p.left, p.right)) && graph.leaves_within([p.left, p.right]).iter().all(|l| l.rate == 0)
    });
    let named = graph.leaves_within(named);
    let mut instants: Vec<Expr> = named.iter().filter_map(|l| l.instant).collect();
    instants.sort_unstable();
    instants.dedup();
    for instant in instants {
        let of_rates = named.iter().any(|l| l.rate > 0 && l.instant == Some(instant));
        let known = if of_rates { &always } else { &plain };
        for &Premise { left, right, derived, .. } in known {
            let then = [left, right].map(|e| {
                graph.substitute(e, |graph, leaf| match leaf {
                    leaf if leaf == time => Some(instant),
                    leaf if leaf.instant.is_none() && moves(leaf) => {
                        Some(graph.leaf(Leaf { instant: Some(instant), ..leaf }))
                    }
                    _ => None,
                })
            });
            let one = Premise::of((then[0], then[1]), derived);
            if then[0] != then[1] && !all.iter().any(|p| (p.left, p.right) == (one.left, one.right)) {
                all.push(one);
            }
        }
    }
    all.extend(pointwise);
    let signs = Signs::of(graph, premises, time, &moves);
    Ok((all, Solutions { dynamics, jets, inside, tied, apart, given, signs }))
}

/// Values of one field at places that are the same, though they are written otherwise: x − ct and −tc + x.
fn at_one_place(graph: &mut Graph, roots: impl Iterator<Item = Expr>) -> Vec<Premise> {
    let fields = graph.fields(roots.collect::<Vec<_>>());
    let placed: Vec<Leaf> = fields.into_iter().filter(|l| graph.place(l.symbol).is_some()).collect();
    let mut out = Vec::new();
    for (i, &a) in placed.iter().enumerate() {
        for &b in &placed[i + 1..] {
            let (Some(p), Some(q)) = (graph.place(a.symbol).cloned(), graph.place(b.symbol).cloned()) else { continue };
            if a.symbol == b.symbol || p.field != q.field || (a.component, a.partials) != (b.component, b.partials) {
                continue;
            }
            let same = p.at.iter().zip(&q.at).all(|(&(_, x), &(_, y))| {
                let difference = graph.sub(x, y);
                Combinations::default().of(graph, difference).is_empty()
            });
            if same {
                out.push(Premise::of((graph.leaf(b), graph.leaf(a)), true));
            }
        }
    }
    out
}

/// What must be positive at a point so that what is given besides equations holds around it, as far as it is about the time, what moves,
/// coordinates, or fields: 0 ≤ u and u ≤ 0 hold at many points, and for one field.
fn strictly(graph: &mut Graph, premises: &Premises, moves: &impl Fn(Leaf) -> bool) -> Vec<Expr> {
    let changes = |graph: &Graph, e: Expr| {
        let goes_on = |l: &Leaf| Some(*l) == premises.time || graph.coordinate(*l).is_some();
        let leaves = graph.leaves([e]);
        leaves.iter().any(|l| l.instant.is_none() && moves(*l) || graph.is_field(l.symbol) || goes_on(l))
    };
    let mut out: Vec<Expr> = premises.not_negative.iter().copied().filter(|&e| changes(graph, e)).collect();
    let facts = premises.not_negative.iter().chain(&premises.positive).chain(&premises.nonzero);
    let facts: Vec<Expr> = facts.copied().filter(|&e| changes(graph, e)).collect();
    // What has a value at the point has one around it, if what may end there is positive.
    let sides = premises.sides().filter(|&e| changes(graph, e)).collect::<Vec<_>>();
    for need in graph.needs_below(facts.into_iter().chain(sides)) {
        let squares = is_never_negative(graph, need.value);
        match need.sign {
            Sign::NotZero => {}
            Sign::NotNegative if squares => {}
            Sign::NotNegative | Sign::Positive => out.push(need.value),
        }
    }
    out
}

/// Whether something is never negative where it has a value, by its structure.
pub fn is_never_negative(graph: &Graph, e: Expr) -> bool {
    let not_negative = |op: Op| {
        let low = row(op).range.low;
        low.is_some_and(|low| low.whole >= 0 && low.quarter_turns >= 0)
    };
    match *graph.node(e) {
        Node::Constant(_) => graph.as_constant(e).is_some_and(|r| *r >= Rational::ZERO),
        Node::Pi => true,
        Node::Leaf(_) => false,
        Node::Unary(op, _) | Node::Binary(op, ..) if not_negative(op) => true,
        Node::Unary(Op::Powi(_), a) => is_never_negative(graph, a),
        Node::Binary(Op::Restrict, a, _) => is_never_negative(graph, a),
        Node::Binary(Op::Mul, a, b) if a == b => true,
        Node::Binary(Op::Add | Op::Mul | Op::Div, a, b) => is_never_negative(graph, a) && is_never_negative(graph, b),
        Node::Unary(..) | Node::Binary(..) => false,
    }
}

/// Leaves that stand in arguments of transcendental functions.
pub(super) fn argument_leaves(graph: &Graph, roots: impl IntoIterator<Item = Expr>) -> FastSet<Leaf> {
    let roots: Vec<Expr> = roots.into_iter().collect();
    // Below cosine and sine, inverse functions are algebraic.
    let mut outside: FastSet<Expr> = FastSet::default();
    let mut open = roots.clone();
    while let Some(e) = open.pop() {
        if outside.insert(e) && !matches!(graph.node(e), Node::Unary(Op::Sin | Op::Cos | Op::Tan, _)) {
            open.extend(graph.node(e).children());
        }
    }
    let mut arguments = Vec::new();
    for e in graph.reachable(roots) {
        match *graph.node(e) {
            Node::Unary(Op::Arcsin | Op::Arccos | Op::Arctan, _) | Node::Binary(Op::Arctan2, ..)
                if !outside.contains(&e) => {}
            Node::Unary(op, a) => match op {
                Op::Neg | Op::Sqrt | Op::Abs | Op::Powi(_) => {}
                // Their argument is known by its sum of angles.
                Op::Sin | Op::Cos | Op::Tan if is_inverse(graph, a) => {}
                _ => arguments.push(a),
            },
            Node::Binary(Op::Pow | Op::Arctan2 | Op::Agm, a, b) => arguments.extend([a, b]),
            _ => {}
        }
    }
    graph.leaves(arguments).into_iter().collect()
}

/// Whether an argument is an angle given by its cosine and sine, or a multiple of one.
fn is_inverse(graph: &Graph, e: Expr) -> bool {
    match *graph.node(e) {
        Node::Unary(Op::Arcsin | Op::Arccos | Op::Arctan, _) | Node::Binary(Op::Arctan2, ..) => true,
        Node::Unary(Op::Neg, a) => is_inverse(graph, a),
        Node::Binary(Op::Mul, a, b) => {
            graph.as_constant(a).is_some() && is_inverse(graph, b)
                || graph.as_constant(b).is_some() && is_inverse(graph, a)
        }
        Node::Binary(Op::Div, a, b) => graph.as_constant(b).is_some() && is_inverse(graph, a),
        _ => false,
    }
}

/// Equations solved as they are written.
pub(super) struct Explicit {
    /// Leaf := expression without any of the defined leaves.
    pub(super) definitions: FastMap<Leaf, Expr>,
    /// What is left, with the definitions inserted.
    pub(super) rest: Vec<Premise>,
    /// Divided by.
    pub(super) pivots: Vec<Expr>,
}

/// Takes `leaf = expression` as definitions, and solves for leaves in arguments of sin, exp … that occur linearly outside.
pub(super) fn explicit(
    graph: &mut Graph,
    equations: &[Premise],
    conclusions: &[(Expr, Expr)],
    premises: &Premises,
) -> Explicit {
    let mut out = Explicit { definitions: FastMap::default(), rest: equations.to_vec(), pivots: Vec::new() };
    loop {
        let mut found = None;
        for (at, p) in out.rest.iter().enumerate() {
            if let Some(definition) = as_definition(graph, p.left, p.right, premises) {
                found = Some((at, definition));
                break;
            }
        }
        if found.is_none() {
            let sides = out.rest.iter().map(|p| (p.left, p.right)).chain(conclusions.iter().copied());
            let sides = sides.flat_map(|(l, r)| [l, r]);
            let arguments = argument_leaves(graph, sides);
            found = linear_argument(graph, &mut out, &arguments, premises);
        }
        let Some((at, (leaf, value))) = found else { return out };
        out.rest.remove(at);
        let rest = out.rest.iter_mut().flat_map(|p| [&mut p.left, &mut p.right]);
        put_in(graph, out.definitions.values_mut().chain(rest), leaf, value);
        out.definitions.insert(leaf, value);
    }
}

fn as_definition(graph: &Graph, left: Expr, right: Expr, premises: &Premises) -> Option<(Leaf, Expr)> {
    let leaf = |e: Expr| match graph.node(e) {
        Node::Leaf(leaf) if premises.time != Some(*leaf) => Some(*leaf),
        _ => None,
    };
    let free = |leaf: Leaf, e: Expr| !graph.leaves([e]).contains(&leaf);
    let forward = leaf(left).filter(|&l| free(l, right)).map(|l| (l, right));
    let backward = leaf(right).filter(|&l| free(l, left)).map(|l| (l, left));
    match (forward, backward) {
        // Of two leaves the parameter stays.
        (Some((l, _)), Some(back)) if premises.parameters.contains(&l) => Some(back),
        (Some(forward), _) => Some(forward),
        // A parameter on the right of an equation is not what the equation defines.
        (None, back) => back.filter(|(l, _)| !premises.parameters.contains(l)),
    }
}

fn linear_argument(
    graph: &mut Graph,
    out: &mut Explicit,
    arguments: &FastSet<Leaf>,
    premises: &Premises,
) -> Option<(usize, (Leaf, Expr))> {
    for (at, Premise { left, right, derived, .. }) in out.rest.clone().into_iter().enumerate() {
        if derived {
            continue;
        }
        let mut unknowns = graph.leaves([left, right]);
        unknowns.retain(|l| arguments.contains(l) && premises.time != Some(*l) && !premises.parameters.contains(l));
        for unknown in unknowns {
            let residual = graph.sub(left, right);
            let Ok(slope) = graph.slope(residual, unknown) else { continue };
            if graph.is_zero(slope) || graph.leaves([slope]).contains(&unknown) {
                continue;
            }
            let zero = graph.integer(0);
            let rest = graph.replaced(residual, |_, l| (l == unknown).then_some(zero));
            if graph.as_constant(slope).is_none() {
                out.pivots.push(slope);
            }
            let quotient = graph.div(rest, slope);
            let value = graph.neg(quotient);
            return Some((at, (unknown, value)));
        }
    }
    None
}
