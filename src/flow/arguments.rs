//! The arguments of exponentials, powers and quotients, behind which something may hide.
//!
//! A series at one time knows nothing of what is smaller than the last digit there: of the peak of e^{−u²} far from it, of a step of
//! tanh u, of 10⁻²⁴/u near a zero of u. All its coefficients may be below rounding, and it would be accepted on a stretch on which it
//! is wrong. What hides must pass through an exponential, a power, or a quotient, and there the *argument* is seen: on a stretch on
//! which e^u changes by a moderate factor, nothing that is below rounding in the middle is far above it at the ends.
//!
//! **In:** the tape of an expression, and its series around a time. **Out:** whether all such arguments move moderately up to a
//! distance. **Guaranteed:** nothing that decides is made here, only more places to look at.

use expr::tape::Tape;
use number::Op;

/// An exponent that changes by less than this hides nothing.
const STEEP: f64 = 8.0;
/// What is divided by may change by up to this share of its size: the nearest singularity is farther away than the ends.
const MODERATE: f64 = 0.75;
/// Powers from this one on are taken for exponentials.
const HIGH: i32 = 16;
/// Exponentials below this power of e are 0.
const NOTHING: f64 = -746.0;
/// Beyond this argument tanh is ±1.
const SATURATED: f64 = 20.0;

/// An argument that may hide something, by the slots of a tape.
#[derive(Clone, Copy, Debug)]
pub(super) enum Argument {
    /// u in e^u, sinh u, cosh u, tanh u; below the one number, and above the other, nothing varies.
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
}

/// A number, and how far it moves on a stretch at most.
type Moves = (f64, f64);

/// An operation of one number, the same on every machine; NaN where there is no value.
fn at(op: Op, x: f64) -> f64 {
    let mut out = 0.0;
    op.apply(&(), &mut out, &x, &x).map_or(f64::NAN, |()| out)
}

impl Argument {
    /// Whether it is one of an exponential: the others are singular somewhere.
    pub(super) fn is_exponential(&self) -> bool {
        match self {
            Argument::Exponent(..) | Argument::Base(..) => true,
            Argument::Power(..) | Argument::Singular(_) | Argument::Cosine(_) | Argument::Unit(_) => false,
            Argument::Plane(..) => false,
        }
    }

    /// The slots that it is in.
    pub(super) fn slots(&self) -> impl Iterator<Item = usize> + use<> {
        let (first, second) = match *self {
            Argument::Exponent(u, ..) | Argument::Base(u, _) => (u, None),
            Argument::Singular(u) | Argument::Cosine(u) | Argument::Unit(u) => (u, None),
            Argument::Power(u, v) | Argument::Plane(u, v) => (u, Some(v)),
        };
        [first].into_iter().chain(second)
    }

    /// Whether it moves moderately; `of` says how the number in a slot moves, if it has a value.
    pub(super) fn is_moderate(&self, of: impl Fn(usize) -> Option<Moves>) -> bool {
        let single = |slot: usize, moderate: &dyn Fn(f64, f64) -> bool| of(slot).is_none_or(|(u, by)| moderate(u, by));
        match *self {
            Argument::Exponent(u, low, high) => single(u, &|u, by| u + by < low || u - by > high || by <= STEEP),
            Argument::Base(u, n) => {
                single(u, &|u, by| n * at(Op::Ln, u.abs() + by) < NOTHING || n * by <= STEEP * u.abs())
            }
            Argument::Singular(u) => single(u, &|u, by| by <= MODERATE * u.abs()),
            Argument::Cosine(u) => single(u, &|u, by| by <= MODERATE * at(Op::Cos, u).abs()),
            Argument::Unit(u) => single(u, &|u, by| by <= MODERATE * (1.0 - u.abs()).abs()),
            Argument::Power(u, v) => match (of(u), of(v)) {
                (Some((u, by)), Some((v, along))) => {
                    let u = u.abs();
                    by <= MODERATE * u && by * v.abs() <= STEEP * u && along * at(Op::Ln, u).abs() <= STEEP
                }
                (None, _) | (_, None) => true,
            },
            Argument::Plane(y, x) => match (of(y), of(x)) {
                (Some((y, up)), Some((x, along))) => up + along <= MODERATE * at(Op::Sqrt, y * y + x * x),
                (None, _) | (_, None) => true,
            },
        }
    }
}

/// For each argument of an operation, whether what is below rounding for one value of it may be seen for another: where the
/// operation grows without bound, or comes to rest.
pub fn may_hide(op: Op) -> [bool; 2] {
    match op {
        Op::Exp | Op::Sinh | Op::Cosh | Op::Tanh | Op::Sqrt | Op::Ln | Op::Tan | Op::Arcsin | Op::Arccos => {
            [true, false]
        }
        Op::Powi(n) => [!(0..HIGH).contains(&n), false],
        Op::Div => [false, true],
        Op::Pow | Op::Arctan2 | Op::Agm => [true, true],
        Op::Neg | Op::Add | Op::Sub | Op::Mul | Op::Sin | Op::Cos | Op::Arctan | Op::Abs | Op::Restrict => {
            [false, false]
        }
    }
}

/// The arguments in an expression that may hide something.
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
            let second = step.op.arity() == 2;
            moving[step.out as usize] = moving[a] || second && moving[b];
            if !matches!(may_hide(step.op), [first, second] if first && moving[a] || second && moving[b]) {
                continue;
            }
            let endless = f64::INFINITY;
            match step.op {
                Op::Exp => out.push(Argument::Exponent(a, NOTHING, endless)),
                Op::Sinh | Op::Cosh => out.push(Argument::Exponent(a, -endless, endless)),
                Op::Tanh => out.push(Argument::Exponent(a, -SATURATED, SATURATED)),
                Op::Powi(n) => {
                    let high = Argument::Base(a, f64::from(n.saturating_abs()));
                    out.extend((n.saturating_abs() >= HIGH).then_some(high));
                    out.extend((n < 0).then_some(Argument::Singular(a)));
                }
                Op::Sqrt | Op::Ln => out.push(Argument::Singular(a)),
                Op::Tan => out.push(Argument::Cosine(a)),
                Op::Arcsin | Op::Arccos => out.push(Argument::Unit(a)),
                Op::Div => out.push(Argument::Singular(b)),
                Op::Pow => out.push(Argument::Power(a, b)),
                Op::Arctan2 => out.push(Argument::Plane(a, b)),
                Op::Agm => out.extend([a, b].into_iter().filter(|&s| moving[s]).map(Argument::Singular)),
                Op::Neg | Op::Add | Op::Sub | Op::Mul | Op::Sin | Op::Cos | Op::Arctan | Op::Abs | Op::Restrict => {}
            }
        }
        Arguments(out)
    }

    /// Each.
    pub(super) fn iter(&self) -> impl Iterator<Item = &Argument> {
        self.0.iter()
    }

    /// Whether there are any.
    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The slots that they are in, increasing.
    pub(super) fn slots(&self) -> Vec<usize> {
        let mut out: Vec<usize> = self.0.iter().flat_map(|argument| argument.slots()).collect();
        out.sort_unstable();
        out.dedup();
        out
    }

    /// Whether all move moderately; `of` says how the number in a slot moves, if it has a value.
    pub(super) fn are_moderate(&self, of: impl Fn(usize) -> Option<Moves>) -> bool {
        self.0.iter().all(|argument| argument.is_moderate(&of))
    }
}
