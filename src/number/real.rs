//! binary64: the plain real numbers of the machine.
//!
//! Basic operations and √ are those of IEEE 754; elementary functions are those of [`elementary`](super::elementary), powers come
//! from `pxfm`: every machine computes the same bits. A result that is not finite is not a value.
//!
//! One table has them for a number alone and for many in registers, so that both are the same function.

use super::elementary::{
    Arccos, Arcsin, Arctan, Arctan2, Cos, Cosh, Exp, Function, Ln, Sin, Sinh, Tan, Tanh, each, one,
};
use super::register::Register;
use super::{NoValue, Number, Op, Rational};
use pulp::Simd;

/// Checks that a result is a number: anything else is an overflow, as domains are checked before.
#[inline]
fn finite(x: f64) -> Result<f64, NoValue> {
    if x.is_finite() { Ok(x) } else { Err(NoValue::Indeterminate) }
}

/// Checks the domain of a function before it is evaluated.
#[inline]
fn domain(inside: bool) -> Result<(), NoValue> {
    if inside { Ok(()) } else { Err(NoValue::OutOfDomain) }
}

/// aⁿ by repeated squaring; every number type that needs the value of a power uses this order of operations.
#[inline]
pub(super) fn powi(a: f64, n: i32) -> f64 {
    let (mut base, mut e, mut acc) = (a, n.unsigned_abs(), 1.0);
    while e > 0 {
        if e & 1 == 1 {
            acc *= base;
        }
        base *= base;
        e >>= 1;
    }
    // The reciprocal of an overflow is not 0 but unknown.
    if n >= 0 {
        acc
    } else if acc.is_infinite() {
        f64::NAN
    } else {
        1.0 / acc
    }
}

/// More iterations of the arithmetic–geometric mean than any two numbers need: one per halving of the exponent of their
/// ratio, at most 11, and about five more until they agree.
pub(super) const AGM_ITERATIONS: u32 = 32;

/// The arithmetic–geometric mean of two positive numbers; 0 when one of them is 0.
pub(super) fn agm(a: f64, b: f64) -> f64 {
    if a == 0.0 || b == 0.0 {
        return 0.0;
    }
    let (mut a, mut b) = (a, b);
    for _ in 0..AGM_ITERATIONS {
        if (a - b).abs() <= 4.0 * f64::EPSILON * a.abs() {
            break;
        }
        let product = a * b;
        // Outside this range the product has lost digits, or overflowed.
        let in_range = (1e-290..=f64::MAX).contains(&product);
        let geometric = if in_range { product.sqrt() } else { a.sqrt() * b.sqrt() };
        (a, b) = (0.5 * a + 0.5 * b, geometric);
    }
    0.5 * a + 0.5 * b
}

/// Operations that fit any numbers.
macro_rules! basic {
    ($($Name:ident |$($x:ident),*| $value:expr;)*) => {$(
        #[derive(Clone, Copy)]
        struct $Name;

        impl Function<{ [$(stringify!($x)),*].len() }, 1> for $Name {
            #[inline(always)]
            fn wide<S: Simd>(self, [$($x),*]: [Register<S>; [$(stringify!($x)),*].len()]) -> [Register<S>; 1] {
                [$value.finite()]
            }
        }
    )*};
}

basic! {
    Neg |a| -a;
    Sqrt |a| a.sqrt();
    Abs |a| a.abs();
    Add |a, b| a + b;
    Sub |a, b| a - b;
    Mul |a, b| a * b;
    Div |a, b| a / b;
    Restrict |a, b| a.or(b.is(b), f64::NAN);
}

/// The cosine of the direction of (a, b), scaled by a power of two so that squares stay in range.
#[derive(Clone, Copy)]
pub(super) struct DirectionCosine;

impl Function<2, 1> for DirectionCosine {
    #[inline(always)]
    fn wide<S: Simd>(self, [a, b]: [Register<S>; 2]) -> [Register<S>; 1] {
        let [first, _] = DirectionCosines.wide([a, b]);
        [first]
    }
}

/// The same of (a, b) and of (b, a).
#[derive(Clone, Copy)]
pub(super) struct DirectionCosines;

impl Function<2, 2> for DirectionCosines {
    #[inline(always)]
    fn wide<S: Simd>(self, [a, b]: [Register<S>; 2]) -> [Register<S>; 2] {
        let s = a.scale(b);
        let (a, b) = (a * s, b * s);
        let radius = (a * a + b * b).sqrt().finite();
        [(a / radius).finite(), (b / radius).finite()]
    }
}

/// aⁿ by repeated squaring, in the order of [`powi`]; a point without a value has no zeroth power either.
#[derive(Clone, Copy)]
struct Power(i32);

impl Function<1, 1> for Power {
    #[inline(always)]
    fn wide<S: Simd>(self, [a]: [Register<S>; 1]) -> [Register<S>; 1] {
        let (mut base, mut e, mut acc) = (a, self.0.unsigned_abs(), a.all(1.0));
        while e > 0 {
            if e & 1 == 1 {
                acc = acc * base;
            }
            base = base * base;
            e >>= 1;
        }
        // The reciprocal of an overflow is not 0 but unknown.
        let power = if self.0 >= 0 { acc } else { 1.0 / acc.finite() };
        [power.or(a.is(a), f64::NAN).finite()]
    }
}

/// The operations but those that have no method of their own kind: with what arguments they have a value, and the function, in
/// registers or of one number alone. Where arguments have no value of the operation, that of the function is NaN.
macro_rules! table {
    (
        unary { $( $Op:ident $op:ident |$x:ident| $inside:expr, $function:expr; )* }
        binary { $( $Two:ident $two:ident |$y:ident, $z:ident| $both_inside:expr, $of_both:expr; )* }
        alone { $( $Slow:ident $slow:ident |$p:ident, $q:ident| $slow_inside:expr, $slow_function:expr; )* }
    ) => {
        impl Number for f64 {
            type Context = ();

            fn blank(_: &()) -> f64 {
                0.0
            }
            fn rational(&mut self, _: &(), r: &Rational) -> Result<(), NoValue> {
                *self = finite(r.to_f64().value())?;
                Ok(())
            }
            fn pi(&mut self, _: &()) -> Result<(), NoValue> {
                *self = std::f64::consts::PI;
                Ok(())
            }
            fn restrict(&mut self, _: &(), a: &f64, _: &f64) -> Result<(), NoValue> {
                self.clone_from(a);
                Ok(())
            }
            fn powi(&mut self, _: &(), a: &f64, n: i32) -> Result<(), NoValue> {
                domain((n >= 0 || *a != 0.0) && !a.is_nan())?;
                *self = finite(powi(*a, n))?;
                Ok(())
            }
            $( fn $op(&mut self, _: &(), &$x: &f64) -> Result<(), NoValue> {
                domain($inside)?;
                *self = finite(one($function, [$x])[0])?;
                Ok(())
            } )*
            $( fn $two(&mut self, _: &(), &$y: &f64, &$z: &f64) -> Result<(), NoValue> {
                domain($both_inside)?;
                *self = finite(one($of_both, [$y, $z])[0])?;
                Ok(())
            } )*
            $( fn $slow(&mut self, _: &(), &$p: &f64, &$q: &f64) -> Result<(), NoValue> {
                domain($slow_inside)?;
                *self = finite($slow_function($p, $q))?;
                Ok(())
            } )*
        }

        /// An operation in all lanes: bit for bit what it is for each alone, and NaN where that is none.
        #[inline(always)]
        pub(super) fn apply<S: Simd, const N: usize>(simd: S, op: Op, out: &mut [f64; N], a: &[f64; N], b: &[f64; N]) {
            match op {
                $( Op::$Op => each(simd, $function, [out], [a]), )*
                $( Op::$Two => each(simd, $of_both, [out], [a, b]), )*
                Op::Powi(n) => each(simd, Power(n), [out], [a]),
                Op::Restrict => each(simd, Restrict, [out], [a, b]),
                $( Op::$Slow )|* => by_points(op, out, a, b),
            }
        }
    };
}

table! {
    unary {
        Neg neg |a| true, Neg;
        Sqrt sqrt |a| a >= 0.0, Sqrt;
        Exp exp |a| true, Exp;
        Ln ln |a| a > 0.0, Ln;
        Sin sin |a| true, Sin;
        Cos cos |a| true, Cos;
        Tan tan |a| true, Tan;
        Arcsin arcsin |a| a.abs() <= 1.0, Arcsin;
        Arccos arccos |a| a.abs() <= 1.0, Arccos;
        Arctan arctan |a| true, Arctan;
        Sinh sinh |a| true, Sinh;
        Cosh cosh |a| true, Cosh;
        Tanh tanh |a| true, Tanh;
        Abs abs |a| true, Abs;
    }
    binary {
        Add add |a, b| true, Add;
        Sub sub |a, b| true, Sub;
        Mul mul |a, b| true, Mul;
        Div div |a, b| b != 0.0, Div;
        Arctan2 arctan2 |y, x| y != 0.0 || x != 0.0, Arctan2;
        DirectionCosine direction_cosine |a, b| a != 0.0 || b != 0.0, DirectionCosine;
    }
    alone {
        Pow pow |a, b| (a > 0.0 || (a == 0.0 && b > 0.0)) && !b.is_nan(), pxfm::f_pow;
        Agm agm |a, b| a >= 0.0 && b >= 0.0, agm;
    }
}

/// Lane by lane.
#[inline(never)]
fn by_points<const N: usize>(op: Op, out: &mut [f64; N], a: &[f64; N], b: &[f64; N]) {
    for i in 0..N {
        let mut x = 0.0;
        out[i] = if op.apply(&(), &mut x, &a[i], &b[i]).is_ok() { x } else { f64::NAN };
    }
}
