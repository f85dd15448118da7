//! How far values of sine, cosine and arctan2 move over a ball, in as many places as a register has.
//!
//! **In:** centres and errors. **Out:** bounds of the deviation, rounding included, and with them the operations on
//! [`Bounded`](super::Bounded) of one point or of lanes. **Guaranteed:** one formula for both, hence the same bits.

use super::Op;
use super::bounded::{DOWN, TINY, ULP, UP};
use super::elementary::{Arctan2, Function, Sin, sin_cos};
use super::real::DirectionCosine;
use super::register::Register;
use pulp::Simd;
use std::f64::consts::PI;

/// The smaller one; neither is NaN.
#[inline(always)]
fn least<S: Simd>(a: Register<S>, b: Register<S>) -> Register<S> {
    a.or(a.below(b), b)
}

/// At least |sin x − sin c| (or cosine) over |x − c| ≤ e, where v is the value at c: the slope √(1 − v²) at the centre plus
/// at most e²/2, and never more than e.
#[inline(always)]
pub(super) fn wave<S: Simd>([value, error]: [Register<S>; 2]) -> Register<S> {
    let v = least(value.abs(), value.all(1.0));
    let slope = ((1.0 - v + ULP) * (1.0 + v) * UP).sqrt();
    let bent = slope * error + 0.5 * error * error;
    least(least(bent, error), error.all(2.0)) * UP
}

/// At least the change of the angle of (x, y) when both move within their errors: arcsin(ρ/r), where the point moves by ρ and r is
/// its distance from the origin. Beyond that distance the ball of the error may go around the origin although the box does not.
#[inline(always)]
pub(super) fn turn<S: Simd>([y, y_error]: [Register<S>; 2], [x, x_error]: [Register<S>; 2]) -> Register<S> {
    let s = y.scale(x);
    let (sy, sx) = (y * s, x * s);
    let radius = (sy * sy + sx * sx).sqrt() * DOWN;
    let (ey, ex) = ((y_error * s + TINY) * UP, (x_error * s + TINY) * UP);
    let still = y.simd.and_m64s(y_error.is(0.0), x_error.is(0.0));
    // Squares of small errors underflow: these are scaled, too.
    let t = ey.scale(ex);
    let (ty, tx) = (ey * t, ex * t);
    let moved = y.all(0.0).or(still, (ty * ty + tx * tx).sqrt() / t * UP + TINY);
    let sine = moved / radius * UP;
    // arcsin s = s + s³·(1/6 + 3s²/40 + …), and the sum in brackets is at most its value at 1, which is π/2 − 1.
    let angle = sine * (1.0 + 0.5708 * sine * sine) * UP;
    angle.or(sine.below(1.0), PI)
}

/// The error of a value, and whether it is known exactly.
#[inline(always)]
fn error<S: Simd>(op: Op, value: Register<S>, deviation: Register<S>, exact: S::m64s) -> Register<S> {
    value.all(0.0).or(exact, (deviation + op.units() * ULP * value.abs()) * UP + TINY)
}

/// At least the change of the cosine of the direction of (a, b) when both move within their errors; `cosine` is its value.
#[inline(always)]
pub(super) fn turned_cosine<S: Simd>(cosine: Register<S>, a: [Register<S>; 2], b: [Register<S>; 2]) -> Register<S> {
    // A computed cosine may be off by a unit more than a computed sine.
    wave([cosine * (1.0 - ULP), turn(b, a)])
}

/// Where 0 is exact: |value| + error is 0 only then, since no sum underflows.
#[inline(always)]
fn exact_zero<S: Simd>(value: Register<S>, error: Register<S>) -> S::m64s {
    (value.abs() + error).is(0.0)
}

/// Sine and cosine of balls: value and error of both.
#[derive(Clone, Copy)]
pub(super) struct Waves;

impl Function<2, 4> for Waves {
    #[inline(always)]
    fn fits<S: Simd>(self, [a, error]: [Register<S>; 2]) -> S::m64s {
        a.simd.and_m64s(Sin.fits([a]), error.upto(f64::MAX))
    }
    #[inline(always)]
    fn wide<S: Simd>(self, [a, e]: [Register<S>; 2]) -> [Register<S>; 4] {
        let [sin, cos] = sin_cos(a);
        let never = a.below(a);
        let errors =
            [error(Op::Sin, sin, wave([sin, e]), exact_zero(a, e)), error(Op::Cos, cos, wave([cos, e]), never)];
        [sin, errors[0], cos, errors[1]]
    }
}

/// The angle of a point in a box, where it does not contain the origin.
#[derive(Clone, Copy)]
pub(super) struct Turns;

impl Function<4, 2> for Turns {
    #[inline(always)]
    fn fits<S: Simd>(self, [y, y_error, x, x_error]: [Register<S>; 4]) -> S::m64s {
        let simd = y.simd;
        let known = simd.and_m64s(y_error.upto(f64::MAX), x_error.upto(f64::MAX));
        let away = simd.or_m64s(y_error.below(y.abs()), x_error.below(x.abs()));
        simd.and_m64s(Arctan2.fits([y, x]), simd.and_m64s(known, away))
    }
    #[inline(always)]
    fn wide<S: Simd>(self, [y, y_error, x, x_error]: [Register<S>; 4]) -> [Register<S>; 2] {
        let [value] = Arctan2.wide([y, x]);
        let exact = y.simd.and_m64s(exact_zero(y, y_error), x.all(0.0).below(x));
        [value, error(Op::Arctan2, value, turn([y, y_error], [x, x_error]), exact)]
    }
}

/// The cosine of the direction of a point in a box, where it does not contain the origin.
#[derive(Clone, Copy)]
pub(super) struct Directions;

impl Function<4, 2> for Directions {
    #[inline(always)]
    fn fits<S: Simd>(self, [a, a_error, b, b_error]: [Register<S>; 4]) -> S::m64s {
        let simd = a.simd;
        let finite = |x: Register<S>| x.abs().upto(f64::MAX);
        let known = simd.and_m64s(finite(a_error), finite(b_error));
        let away = simd.or_m64s(a_error.below(a.abs()), b_error.below(b.abs()));
        simd.and_m64s(simd.and_m64s(finite(a), finite(b)), simd.and_m64s(known, away))
    }
    #[inline(always)]
    fn wide<S: Simd>(self, [a, a_error, b, b_error]: [Register<S>; 4]) -> [Register<S>; 2] {
        let [value] = DirectionCosine.wide([a, b]);
        let on_axis = a.simd.or_m64s(exact_zero(a, a_error), exact_zero(b, b_error));
        let deviation = turned_cosine(value, [a, a_error], [b, b_error]);
        [value, error(Op::DirectionCosine, value, deviation, on_axis)]
    }
}

#[cfg(test)]
mod tests {
    use crate::{Bounded, Op};

    /// The squares of such errors are 0.
    #[test]
    fn a_small_ball_far_from_the_origin_turns_by_its_size() {
        for (size, part) in [(1e-300, 1e-3), (1e-200, 0.5), (1e-160, 1e-9), (1e-8, 1e-3)] {
            for (op, across) in [(Op::Arctan2, true), (Op::DirectionCosine, true), (Op::Arctan2, false)] {
                let ball = Bounded::new(size, part * size);
                let (y, x) = if across { (ball, Bounded::exact(1.0)) } else { (Bounded::exact(-1.0), ball) };
                let mut angle = Bounded::exact(0.0);
                op.apply(&(), &mut angle, &y, &x).expect("a value");
                assert!(angle.error >= 0.999 * ball.error, "{op:?} of {y:?} and {x:?}: {angle:?}");
                let most = 1.001 * ball.error + 4.0 * f64::EPSILON * angle.value.abs() + 1e-307;
                assert!(angle.error <= most, "{op:?} of {y:?} and {x:?}: {angle:?}");
            }
        }
    }
}
