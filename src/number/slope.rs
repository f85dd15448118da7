//! First and second derivatives of the operations of one argument and of powers: the one table that all dual numbers use.
//!
//! Results are unchecked. Where a function has no derivative they are not finite or invalid.

use super::{Op, Scalar, scalar::value};

/// (1 − x)(1 + x), which keeps the digits of 1 − x near 1.
#[inline(always)]
fn one_minus_square<B: Scalar>(x: B) -> B {
    (B::integer(1) - x) * (B::integer(1) + x)
}

/// f′(a), where v = f(a).
#[inline(always)]
pub(super) fn slope<B: Scalar>(op: Op, a: B, v: B) -> B {
    let one = B::integer(1);
    match op {
        Op::Neg => -one,
        Op::Sqrt => one / (v + v),
        Op::Exp => v,
        Op::Ln => one / a,
        Op::Sin => value(B::cos, a),
        Op::Cos => -value(B::sin, a),
        Op::Tan => one + v * v,
        Op::Arcsin => one / value(B::sqrt, one_minus_square(a)),
        Op::Arccos => -one / value(B::sqrt, one_minus_square(a)),
        Op::Arctan => one / (one + a * a).checked().unwrap_or(B::INVALID),
        Op::Sinh => value(B::cosh, a),
        Op::Cosh => value(B::sinh, a),
        Op::Tanh => a.flatness(v),
        Op::Abs => a.sign(),
        Op::Powi(0) => B::ZERO,
        Op::Powi(n) if n < 0 => B::integer(n) * v / a,
        Op::Powi(n) => B::integer(n) * value(|out: &mut B, cx, a| out.powi(cx, a, n - 1), a),
        Op::Add
        | Op::Sub
        | Op::Mul
        | Op::Div
        | Op::Pow
        | Op::Arctan2
        | Op::Agm
        | Op::DirectionCosine
        | Op::Restrict => B::INVALID,
    }
}

/// f″(a), where v = f(a) and s = f′(a).
#[inline(always)]
pub(super) fn curvature<B: Scalar>(op: Op, a: B, v: B, s: B) -> B {
    match op {
        Op::Neg | Op::Powi(0 | 1) => B::ZERO,
        Op::Sqrt => -s / (a + a),
        Op::Exp | Op::Sinh | Op::Cosh => v,
        Op::Ln => -s / a,
        Op::Sin | Op::Cos => -v,
        Op::Tan => (v + v) * s,
        Op::Arcsin | Op::Arccos => a * s * s * s,
        Op::Arctan => -(a + a) * s * s,
        Op::Tanh => -(v + v) * s,
        // 0 where there is a slope at all.
        Op::Abs => s + -s,
        Op::Powi(n) if n < 0 => (B::integer(n) - B::integer(1)) * s / a,
        Op::Powi(n) => {
            let factor = B::integer(n) * B::integer(n - 1);
            factor * value(|out: &mut B, cx, a| out.powi(cx, a, n - 2), a)
        }
        Op::Add
        | Op::Sub
        | Op::Mul
        | Op::Div
        | Op::Pow
        | Op::Arctan2
        | Op::Agm
        | Op::DirectionCosine
        | Op::Restrict => B::INVALID,
    }
}

/// a^b for an exponent that is a difference, as in derivatives of powers.
#[inline(always)]
pub(super) fn power<B: Scalar>(a: B, b: B) -> B {
    value(|out: &mut B, cx, a| out.pow(cx, a, &b), a)
}
