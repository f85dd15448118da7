//! Where an expression varies faster than its series, or its samples, tell.
//!
//! A series at one time knows nothing of what is smaller than the last digit there: of the peak of e^{−u²} far from it, of a step of
//! tanh u, of 10⁻²⁴/u near a zero of u. All its coefficients may be below rounding, and it is accepted on a stretch on which it is
//! wrong. What hides must pass through an exponential, a power, or a quotient, and there the *argument* is seen: on a stretch on
//! which e^u changes by a moderate factor, nothing that is below rounding in the middle is above it at the ends.
//!
//! **In:** the tape of an expression, and its series around a time. **Out:** whether a radius is moderate for all such arguments
//! ([`Arguments::are_moderate`]); and times between the samples of a motion at which the expression is to be looked at
//! ([`Rapid`]).
//!
//! **Guaranteed:** nothing that decides is made here, only more places to look at.

use super::core::Core;
use super::cover::Explorer;
use super::program::Program;
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
/// Degree of the polynomials of arguments.
const DEGREE: usize = 12;
/// Most times that are added.
const MOST: usize = 20_000;

/// An argument that may hide something, by the slots of a tape.
#[derive(Clone, Copy, Debug)]
enum Argument {
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

impl Argument {
    /// Whether it is one of an exponential: the others are singular somewhere.
    fn is_exponential(&self) -> bool {
        match self {
            Argument::Exponent(..) | Argument::Base(..) => true,
            Argument::Power(..) | Argument::Singular(_) | Argument::Cosine(_) | Argument::Unit(_) => false,
            Argument::Plane(..) => false,
        }
    }

    /// The slots that it is in.
    fn slots(&self) -> impl Iterator<Item = usize> + use<> {
        let (first, second) = match *self {
            Argument::Exponent(u, ..) | Argument::Base(u, _) => (u, None),
            Argument::Singular(u) | Argument::Cosine(u) | Argument::Unit(u) => (u, None),
            Argument::Power(u, v) | Argument::Plane(u, v) => (u, Some(v)),
        };
        [first].into_iter().chain(second)
    }

    /// Whether it moves moderately; `of` says how the number in a slot moves, if it has a value.
    fn is_moderate(&self, of: impl Fn(usize) -> Option<Moves>) -> bool {
        let single = |slot: usize, moderate: &dyn Fn(f64, f64) -> bool| of(slot).is_none_or(|(u, by)| moderate(u, by));
        match *self {
            Argument::Exponent(u, low, high) => single(u, &|u, by| u + by < low || u - by > high || by <= STEEP),
            Argument::Base(u, n) => single(u, &|u, by| n * (u.abs() + by).ln() < NOTHING || n * by <= STEEP * u.abs()),
            Argument::Singular(u) => single(u, &|u, by| by <= MODERATE * u.abs()),
            Argument::Cosine(u) => single(u, &|u, by| by <= MODERATE * u.cos().abs()),
            Argument::Unit(u) => single(u, &|u, by| by <= MODERATE * (1.0 - u.abs()).abs()),
            Argument::Power(u, v) => match (of(u), of(v)) {
                (Some((u, by)), Some((v, along))) => {
                    let u = u.abs();
                    by <= MODERATE * u && by * v.abs() <= STEEP * u && along * u.ln().abs() <= STEEP
                }
                (None, _) | (_, None) => true,
            },
            Argument::Plane(y, x) => match (of(y), of(x)) {
                (Some((y, up)), Some((x, along))) => up + along <= MODERATE * y.hypot(x),
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

    /// Whether there are any.
    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The slots that they are in, increasing.
    fn slots(&self) -> Vec<usize> {
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

/// Times between samples at which an expression is to be looked at.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rapid {
    /// Where an exponential, or a high power, changes by a large factor from one sample to the next.
    pub times: Vec<f64>,
    /// Where only what is divided by, or has a root, does: there errors may be larger than anything that is to be seen.
    pub singular: Vec<f64>,
    /// A stretch on which an exponential has more such times than can be looked at.
    pub unresolved: Option<(f64, f64)>,
}

/// Cuts a stretch in halves until all arguments move moderately on each, or it is as short as times can be told: whether that took
/// no more times than can be looked at. The expression itself need not have a value.
fn resolve(explorer: &mut Explorer, whole: (f64, f64), times: &mut Vec<f64>) -> bool {
    let mut stack = vec![whole];
    while let Some((start, end)) = stack.pop() {
        let middle = start + 0.5 * (end - start);
        let smallest = 1e-12 * (whole.1 - whole.0) + 2.0 * f64::EPSILON * start.abs().max(end.abs());
        if explorer.is_moderate(middle, 0.5 * (end - start)) || end - start <= smallest {
            times.extend([start, middle]);
        } else {
            stack.extend([(middle, end), (start, middle)]);
        }
        if times.len() + stack.len() > MOST {
            return false;
        }
    }
    true
}

/// Looks between the samples of a motion at which an expression varies rapidly.
pub(super) fn rapid(core: &Core, program: &Program, samples: &[f64]) -> Rapid {
    let mut out = Rapid::default();
    let arguments = program.arguments();
    if arguments.is_empty() {
        return out;
    }
    let mut explorer = Explorer::new(core, program, DEGREE);
    let slots = arguments.slots();
    let here: Vec<Vec<Option<f64>>> = samples.iter().map(|&t| explorer.plain_values(t, &slots)).collect();
    let value = |k: usize, slot: usize| here[k][slots.binary_search(&slot).ok()?];
    // From sample to sample, and from those beside them: a peak between two that are alike shows in its neighbours.
    let moved = |argument: &Argument, i: usize| {
        let beside = i.saturating_sub(1)..(i + 2).min(samples.len() - 1);
        let step = |k: usize, slot: usize| Some((value(k + 1, slot)? - value(k, slot)?).abs());
        let by = |slot: usize| beside.clone().filter_map(|k| step(k, slot)).fold(0.0, f64::max);
        !(i..i + 2).all(|k| argument.is_moderate(|slot| value(k, slot).map(|u| (u, by(slot)))))
    };
    for i in 0..samples.len().saturating_sub(1) {
        let (mut exponential, mut singular) = (false, false);
        for argument in arguments.0.iter().filter(|a| moved(a, i)) {
            match argument.is_exponential() {
                true => exponential = true,
                false => singular = true,
            }
        }
        if !exponential && !singular {
            continue;
        }
        let into = if exponential { &mut out.times } else { &mut out.singular };
        let resolved = resolve(&mut explorer, (samples[i], samples[i + 1]), into);
        if exponential && !resolved {
            out.unresolved.get_or_insert((samples[i], samples[i + 1]));
        }
    }
    for times in [&mut out.times, &mut out.singular] {
        times.sort_by(f64::total_cmp);
        times.dedup();
        times.retain(|t| samples.binary_search_by(|x| x.total_cmp(t)).is_err());
    }
    out
}
