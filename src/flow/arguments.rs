//! The arguments of exponentials, powers and quotients, behind which something may hide.
//!
//! A series at one time knows nothing of what is smaller than the last digit there: of the peak of e^{−u²} far from it, of a step of
//! tanh u, of 10⁻²⁴/u near a zero of u. All its coefficients may be below rounding, and it would be accepted on a stretch on which it
//! is wrong. What hides must pass through an exponential, a power, or a quotient, and there the *argument* is seen: on a stretch on
//! which e^u changes by a moderate factor, nothing that is below rounding in the middle is far above it at the ends. Nor does a series
//! know of what lies behind a kink of |u|.
//!
//! **In:** the tape of an expression, and its series around a time. **Out:** whether all such arguments move moderately up to a
//! distance. **Guaranteed:** nothing that decides is made here, only more places to look at.

use std::collections::BTreeMap;

use super::polynomial::{scale, shift};
use expr::domain::{Change, Edge, Nature, Place, Row, Term, row};
use expr::tape::Tape;
use expr::{Expr, FastSet, Graph, Leaf, Node};
use number::Op;

/// An exponent that changes by less than this hides nothing.
const STEEP: f64 = 8.0;
/// What is divided by may change by up to this share of its size: the nearest singularity is farther away than the ends.
const MODERATE: f64 = 0.75;
/// Powers from this one on are taken for exponentials.
const HIGH: i32 = 16;
/// Exponentials below this power of e are 0, and none above its negative has a value.
const NOTHING: f64 = -746.0;
/// The shortest part of a stretch that is looked at for a change of sign.
const SHORTEST: f64 = 1e-12;
/// Most parts that are looked at: a polynomial that takes more is none of the stretch.
const MOST_PARTS: usize = 256;
/// What is below its error times this may be 0.
const NOISE: f64 = 4.0;

/// An argument that may hide something, by the slots of a tape.
#[derive(Clone, Copy, Debug)]
pub(super) enum Argument {
    /// u in e^u, sinh u, cosh u, tanh u; below the one number, and above the other, nothing varies, or nothing has a value.
    Exponent(usize, f64, f64),
    /// u in uⁿ.
    Base(usize, f64),
    /// u and v in u^v.
    Power(usize, usize),
    /// u in what is singular where u = 0.
    Singular(usize),
    /// u in what is singular where cos u = 0.
    Cosine(usize),
    /// u in what is singular where u² = 1.
    Unit(usize),
    /// y and x in atan2(y, x).
    Plane(usize, usize),
    /// u in |u|.
    Kink(usize),
}

/// A number on a stretch.
#[derive(Clone, Copy, Debug)]
pub(super) struct Moves {
    /// In the middle.
    pub(super) value: f64,
    /// How far it moves at most.
    pub(super) by: f64,
    /// How well it is known.
    pub(super) error: f64,
}

/// What varies with an argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// An exponential, or a high power: errors are no larger where it varies.
    Exponential,
    /// What is singular, or has a kink, where the argument vanishes.
    Singular,
}

/// How what has a series moves up to a radius.
pub(super) fn moves(mut coefficients: impl Iterator<Item = f64>, radius: f64, error: f64) -> Moves {
    let (value, mut power) = (coefficients.next().unwrap_or(0.0), 1.0);
    let term = |c: f64| {
        power *= radius;
        c.abs() * power
    };
    Moves { value, by: coefficients.map(term).sum(), error }
}

/// Whether a polynomial may change its sign up to a radius, by more than NOISE times an error.
pub(super) fn changes_sign(coefficients: &[f64], radius: f64, error: f64) -> bool {
    let mut scaled = coefficients.to_vec();
    scale(&mut scaled, radius);
    let (mut stack, mut local) = (vec![(0.0, 1.0)], Vec::with_capacity(scaled.len()));
    let (mut seen, mut parts) = ([false; 2], 0);
    while let Some((middle, half)) = stack.pop() {
        parts += 1;
        if parts > MOST_PARTS {
            return true;
        }
        shift(&scaled, middle, half, &mut local);
        let Moves { value, by, .. } = moves(local.iter().copied(), 1.0, error);
        if value.abs() + by <= NOISE * error || half < SHORTEST {
            continue;
        }
        if by < value.abs() {
            seen[usize::from(value > 0.0)] = true;
        } else if value.is_finite() && by.is_finite() {
            stack.extend([(middle - 0.5 * half, 0.5 * half), (middle + 0.5 * half, 0.5 * half)]);
        } else {
            return true;
        }
        if seen == [true, true] {
            return true;
        }
    }
    false
}

/// An operation of one number, the same on every machine; NaN where there is no value.
fn at(op: Op, x: f64) -> f64 {
    let mut out = 0.0;
    op.apply(&(), &mut out, &x, &x).map_or(f64::NAN, |()| out)
}

impl Argument {
    /// The slots that it is in.
    pub(super) fn slots(&self) -> impl Iterator<Item = usize> + use<> {
        let (first, second) = match *self {
            Argument::Exponent(u, ..) | Argument::Base(u, _) => (u, None),
            Argument::Singular(u) | Argument::Cosine(u) | Argument::Unit(u) | Argument::Kink(u) => (u, None),
            Argument::Power(u, v) | Argument::Plane(u, v) => (u, Some(v)),
        };
        [first].into_iter().chain(second)
    }

    /// What varies by much with it; nothing where it moves moderately. `of` says how the number in a slot moves, if it has a value;
    /// `turns`, whether it may change its sign, by more than its error.
    pub(super) fn varies(&self, of: impl Fn(usize) -> Option<Moves>, turns: impl Fn(usize) -> bool) -> Option<Kind> {
        let unless = |moderate: bool, kind: Kind| (!moderate).then_some(kind);
        match *self {
            Argument::Exponent(u, low, high) => {
                let Moves { value: u, by, .. } = of(u)?;
                unless(u + by < low || u - by > high || by <= STEEP, Kind::Exponential)
            }
            Argument::Base(u, n) => {
                let Moves { value: u, by, .. } = of(u)?;
                let u = u.abs();
                let vanishes = n * at(Op::Ln, u + by) < NOTHING || u > by && n * at(Op::Ln, u - by) > -NOTHING;
                unless(vanishes || n * by <= STEEP * u, Kind::Exponential)
            }
            Argument::Singular(u) => {
                let Moves { value: u, by, .. } = of(u)?;
                unless(by <= MODERATE * u.abs(), Kind::Singular)
            }
            Argument::Kink(slot) => {
                let Moves { value: u, by, error } = of(slot)?;
                // What is 0 within its error all along has no kink that could be seen, nor has what only touches 0.
                unless(by <= u.abs() || u.abs() + by <= NOISE * error || !turns(slot), Kind::Singular)
            }
            Argument::Cosine(u) => {
                let Moves { value: u, by, .. } = of(u)?;
                unless(by <= MODERATE * at(Op::Cos, u).abs(), Kind::Singular)
            }
            Argument::Unit(u) => {
                let Moves { value: u, by, .. } = of(u)?;
                unless(by <= MODERATE * (1.0 - u.abs()).abs(), Kind::Singular)
            }
            Argument::Power(u, v) => {
                let (Moves { value: u, by, .. }, Moves { value: v, by: along, .. }) = (of(u)?, of(v)?);
                let u = u.abs();
                let vanishes = v > along && (v - along) * at(Op::Ln, u + by) < NOTHING
                    || v < -along && u > by && (v + along) * at(Op::Ln, u - by) < NOTHING;
                if vanishes {
                    return None;
                }
                let turns_slowly = along == 0.0 || along * at(Op::Ln, u).abs() <= STEEP;
                let slow = by * v.abs() <= STEEP * u && turns_slowly;
                unless(by <= MODERATE * u, Kind::Singular).or(unless(slow, Kind::Exponential))
            }
            Argument::Plane(y, x) => {
                let (Moves { value: y, by: up, .. }, Moves { value: x, by: along, .. }) = (of(y)?, of(x)?);
                unless(up + along <= MODERATE * at(Op::Sqrt, y * y + x * x), Kind::Singular)
            }
        }
    }

    /// Whether what is singular with it is so all along a stretch, within how well the argument is known: no value of it is known
    /// anywhere there.
    pub(super) fn is_lost(&self, of: impl Fn(usize) -> Option<Moves>) -> bool {
        let within = |u: usize, from: &dyn Fn(f64) -> f64| {
            of(u).is_some_and(|Moves { value, by, error }| from(value).abs() + by <= error)
        };
        match *self {
            Argument::Singular(u) | Argument::Kink(u) => within(u, &|u| u),
            Argument::Cosine(u) => within(u, &|u| at(Op::Cos, u)),
            Argument::Unit(u) => within(u, &|u| 1.0 - u.abs()),
            Argument::Plane(y, x) => within(y, &|y| y) && within(x, &|x| x),
            Argument::Exponent(..) | Argument::Base(..) | Argument::Power(..) => false,
        }
    }
}

/// The arguments of an operation that may hide something: what is below rounding for one value of them may be seen for another, where
/// the operation grows without bound, or comes to rest. `a` and `b` are their slots, `moving` says which of them move.
fn hiding(op: Op, (a, b): (usize, usize), moving: [bool; 2]) -> impl Iterator<Item = Argument> {
    let [first, second] = moving;
    let mut found = Vec::new();
    if op == Op::Pow {
        found.extend((first || second).then_some(Argument::Power(a, b)));
        return found.into_iter();
    }
    let Row { needs, edges, nature, .. } = row(op);
    if let Op::Powi(n) = op
        && n.saturating_abs() >= HIGH
    {
        found.extend(first.then_some(Argument::Base(a, f64::from(n.saturating_abs()))));
    }
    if let Nature::Transcendental { exponential: Some([low, high]), .. } = nature {
        found.extend(first.then_some(Argument::Exponent(a, low, high)));
    }
    let vanishing = edges.iter().filter_map(|edge| match edge.place {
        Place::Zero(term) => Some(term),
        // Where it jumps, it is seen to.
        Place::ZeroWhile(..) | Place::Infinity => None,
    });
    let mut terms: Vec<Term> = needs.iter().map(|(term, _)| *term).collect();
    terms.extend(vanishing.filter(|term| !needs.iter().any(|(other, _)| other == term)));
    for term in terms {
        let bends = edges.contains(&Edge { place: Place::Zero(term), change: Change::Kink });
        let (moves, argument) = match term {
            Term::First if bends => (first, Argument::Kink(a)),
            Term::First | Term::Excess | Term::Sine => (first, Argument::Singular(a)),
            Term::Second | Term::Opposite => (second, Argument::Singular(b)),
            Term::Cosine => (first, Argument::Cosine(a)),
            Term::Unit => (first, Argument::Unit(a)),
            Term::Product | Term::Squares | Term::Support => (first || second, Argument::Plane(a, b)),
        };
        found.extend(moves.then_some(argument));
    }
    found.into_iter()
}

/// Whether an operation has arguments that may hide something, if those move that `moving` says.
pub fn may_hide(op: Op, moving: [bool; 2]) -> bool {
    hiding(op, (0, 1), moving).next().is_some()
}

/// The arguments in some expressions that may hide something: each of its expressions once, and for each expression given the
/// arguments in it, by the positions of theirs. `moves` says which leaves do.
pub(super) struct Within {
    /// What the slots of the arguments stand for.
    pub(super) slots: Vec<Expr>,
    /// The arguments of all, each once.
    pub(super) arguments: Vec<Argument>,
    /// For each of the expressions, its arguments.
    pub(super) of: Vec<Vec<usize>>,
}

impl Within {
    /// Those of some expressions.
    pub(super) fn new(graph: &Graph, roots: &[Expr], moves: impl Fn(&Leaf) -> bool) -> Within {
        let mut out = Within { slots: Vec::new(), arguments: Vec::new(), of: Vec::new() };
        let mut moving: FastSet<Expr> = FastSet::default();
        let mut slots: BTreeMap<Expr, usize> = BTreeMap::new();
        let mut at: BTreeMap<Expr, Vec<usize>> = BTreeMap::new();
        for e in graph.reachable(roots.iter().copied()) {
            let node = graph.node(e);
            let moved =
                node.children().any(|child| moving.contains(&child)) || matches!(node, Node::Leaf(leaf) if moves(leaf));
            moving.extend(moved.then_some(e));
            let (op, a, b) = match *node {
                Node::Unary(op, a) => (op, a, a),
                Node::Binary(op, a, b) => (op, a, b),
                Node::Constant(_) | Node::Pi | Node::Leaf(_) => continue,
            };
            let mut slot = |e: Expr| {
                *slots.entry(e).or_insert_with(|| {
                    out.slots.push(e);
                    out.slots.len() - 1
                })
            };
            let does = [a, b].map(|e| moving.contains(&e));
            if may_hide(op, does) {
                let places = (slot(a), slot(b));
                for argument in hiding(op, places, does) {
                    at.entry(e).or_default().push(out.arguments.len());
                    out.arguments.push(argument);
                }
            }
        }
        let of = |&root: &Expr| graph.reachable([root]).iter().filter_map(|e| at.get(e)).flatten().copied().collect();
        out.of = roots.iter().map(of).collect();
        out
    }
}

/// The arguments in a tape that may hide something.
#[derive(Clone, Debug, Default)]
pub(super) struct Arguments(Vec<Argument>);

impl Arguments {
    /// Those of a tape that move; `moves` says which of its inputs do.
    pub(super) fn of(tape: &Tape, moves: &[bool]) -> Arguments {
        let mut moving = vec![false; tape.slot_count()];
        moving[..moves.len()].copy_from_slice(moves);
        let mut out = Vec::new();
        for step in tape.instructions() {
            let (a, b) = (step.a as usize, step.b as usize);
            let does = [moving[a], step.op.arity() == 2 && moving[b]];
            moving[step.out as usize] = does.contains(&true);
            out.extend(hiding(step.op, (a, b), does));
        }
        Arguments(out)
    }

    /// Whether all move moderately; `of` and `turns` as for [`Argument::varies`].
    pub(super) fn are_moderate(&self, of: impl Fn(usize) -> Option<Moves>, turns: impl Fn(usize) -> bool) -> bool {
        self.0.iter().all(|argument| argument.varies(&of, &turns).is_none())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Where an argument is looked at for what vanishes at another place, nothing would be seen.
    #[test]
    fn what_vanishes_where_an_operation_is_singular_is_looked_at() {
        for &op in Op::EVERY.iter().filter(|op| **op != Op::Pow) {
            let Row { needs, edges, .. } = row(op);
            let of = |term: Term| {
                needs.iter().any(|(t, _)| *t == term) || edges.iter().any(|e| e.place == Place::Zero(term))
            };
            assert!(![Term::Excess, Term::Sine, Term::Product, Term::Support].into_iter().any(of), "{op:?}");
        }
    }
}
