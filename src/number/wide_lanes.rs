//! The operations of [`Lanes`] and [`DualLanes`] in the widest registers of the processor.
//!
//! **In:** the steps of a program over lanes. **Out:** their results. **Guaranteed:** each lane is, bit for bit, what `f64` (or a
//! dual number over it) computes, on every processor; what is not finite becomes NaN.
//!
//! **Why so:** all steps of a program run in one function that has the instruction set, so that values stay in registers within an
//! operation and nothing is asked of the processor twice. Sine and cosine of one angle, next to each other on a tape, are one
//! evaluation.

use super::elementary::{Arctan2, Function, SinCos, each};
use super::operation::{Apply, run_each};
use super::real::DirectionCosines;
use super::register::Register;
use super::slope::slope;
use super::{DualLanes, Instruction, Lanes, NoValue, Op, Scalar, real};
use num_dual::Dual64;
use pulp::{Simd, WithSimd};

/// Operations of two numbers with derivatives: (a, a′, b, b′) in, value and derivative out.
macro_rules! dual_operations {
    ($($Name:ident |$a:ident, $da:ident, $b:ident, $db:ident| $value:expr;)*) => {$(
        #[derive(Clone, Copy)]
        struct $Name;

        impl Function<4, 2> for $Name {
            #[inline(always)]
            fn wide<S: Simd>(self, [$a, $da, $b, $db]: [Register<S>; 4]) -> [Register<S>; 2] {
                both($value)
            }
        }
    )*};
}

/// Value and derivative where both are finite, else neither.
#[inline(always)]
fn both<S: Simd>([value, tangent]: [Register<S>; 2]) -> [Register<S>; 2] {
    let simd = value.simd;
    let finite = simd.and_m64s(value.abs().upto(f64::MAX), tangent.abs().upto(f64::MAX));
    [value.or(finite, f64::NAN), tangent.or(finite, f64::NAN)]
}

dual_operations! {
    DualAdd |a, da, b, db| [a + b, da + db];
    DualSub |a, da, b, db| [a - b, da - db];
    DualMul |a, da, b, db| [a * b, da * b + db * a];
    DualDiv |a, da, b, db| {
        let v = a / b;
        [v, (da - v * db) / b]
    };
    DualRestrict |a, da, b, _db| [a.or(b.is(b), f64::NAN), da];
}

/// θ′ = (x·y′ − y·x′)/(x² + y²).
#[derive(Clone, Copy)]
struct DualArctan2;

impl Function<4, 2> for DualArctan2 {
    #[inline(always)]
    fn fits<S: Simd>(self, [y, _, x, _]: [Register<S>; 4]) -> S::m64s {
        Arctan2.fits([y, x])
    }
    #[inline(always)]
    fn wide<S: Simd>(self, [y, dy, x, dx]: [Register<S>; 4]) -> [Register<S>; 2] {
        let [angle] = Arctan2.wide([y, x]);
        let s = y.scale(x);
        let (sy, sx) = (y * s, x * s);
        both([angle, (sx * dy - sy * dx) / (sy * sy + sx * sx) * s])
    }
    fn rare(self, [y, dy, x, dx]: [f64; 4]) -> [f64; 2] {
        point(Op::Arctan2, [y, dy], [x, dx])
    }
}

/// (cos θ)′ = −sin θ·θ′.
#[derive(Clone, Copy)]
struct DualDirectionCosine;

impl Function<4, 2> for DualDirectionCosine {
    #[inline(always)]
    fn wide<S: Simd>(self, [a, da, b, db]: [Register<S>; 4]) -> [Register<S>; 2] {
        let [cosine, sine] = DirectionCosines.wide([a, b]);
        let s = b.scale(a);
        let (sb, sa) = (b * s, a * s);
        both([cosine, sine * ((sb * da - sa * db) / (sb * sb + sa * sa) * s)])
    }
}

/// An operation on one point with its derivative.
fn point(op: Op, a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    let mut out = Dual64::new(0.0, 0.0);
    match op.apply(&(), &mut out, &Dual64::new(a[0], a[1]), &Dual64::new(b[0], b[1])) {
        Ok(()) => [out.re, out.eps],
        Err(_) => [f64::NAN; 2],
    }
}

/// A derivative from the slope; the derivative of a constant is 0 also where the function has none.
#[derive(Clone, Copy)]
struct Chain;

impl Function<3, 2> for Chain {
    #[inline(always)]
    fn wide<S: Simd>(self, [value, slope, tangent]: [Register<S>; 3]) -> [Register<S>; 2] {
        both([value, value.all(0.0).or(tangent.is(0.0), slope * tangent)])
    }
}

/// An operation in all lanes, with derivatives.
#[inline(always)]
pub(super) fn apply_dual<S: Simd, const N: usize>(
    simd: S,
    op: Op,
    out: &mut DualLanes<N>,
    a: &DualLanes<N>,
    b: &DualLanes<N>,
) {
    macro_rules! with {
        ($f:expr) => {{
            let arguments = [&a.value.0, &a.tangent.0, &b.value.0, &b.tangent.0];
            each(simd, $f, [&mut out.value.0, &mut out.tangent.0], arguments)
        }};
    }
    match op {
        Op::Add => with!(DualAdd),
        Op::Sub => with!(DualSub),
        Op::Mul => with!(DualMul),
        Op::Div => with!(DualDiv),
        Op::Arctan2 => with!(DualArctan2),
        Op::DirectionCosine => with!(DualDirectionCosine),
        Op::Restrict => with!(DualRestrict),
        Op::Sin | Op::Cos => {
            let (mut sin, mut cos) = (Lanes::ZERO, Lanes::ZERO);
            each(simd, SinCos, [&mut sin.0, &mut cos.0], [&a.value.0]);
            let (value, slope) = if op == Op::Sin { (&sin, cos) } else { (&cos, -sin) };
            chain(simd, out, value, &slope, a);
        }
        _ if op.arity() == 1 => {
            let mut value = Lanes::ZERO;
            real::apply(simd, op, &mut value.0, &a.value.0, &a.value.0);
            chain(simd, out, &value, &slope(op, a.value, value), a);
        }
        _ => {
            for i in 0..N {
                let [x, y] = [a, b].map(|x| [x.value.0[i], x.tangent.0[i]]);
                [out.value.0[i], out.tangent.0[i]] = point(op, x, y);
            }
        }
    }
}

/// By the chain rule.
#[inline(always)]
fn chain<S: Simd, const N: usize>(
    simd: S,
    out: &mut DualLanes<N>,
    value: &Lanes<N>,
    slope: &Lanes<N>,
    a: &DualLanes<N>,
) {
    each(simd, Chain, [&mut out.value.0, &mut out.tangent.0], [&value.0, &slope.0, &a.tangent.0]);
}

/// One operation, to be made with some instruction set.
pub(super) struct One<'s, L> {
    pub(super) op: Op,
    pub(super) out: &'s mut L,
    pub(super) a: &'s L,
    pub(super) b: &'s L,
}

/// Steps over lanes, to be run with some instruction set.
pub(super) struct Steps<'s, L> {
    pub(super) values: &'s mut [L],
    pub(super) missing: &'s mut [Option<NoValue>],
    pub(super) steps: &'s [Instruction],
}

/// An operation in all lanes.
#[inline(always)]
fn apply<S: Simd, const N: usize>(simd: S, op: Op, out: &mut Lanes<N>, a: &Lanes<N>, b: &Lanes<N>) {
    real::apply(simd, op, &mut out.0, &a.0, &b.0);
}

/// All lanes together.
struct Together<S>(S);

macro_rules! runs {
    (
        $($Lanes:ident $apply:ident |$simd:ident, $out:ident, $next:ident, $a:ident, $b:ident| $pair:expr, $directions:expr;)*
    ) => {$(
        impl<const N: usize> WithSimd for One<'_, $Lanes<N>> {
            type Output = ();
            #[inline(always)]
            fn with_simd<S: Simd>(self, simd: S) {
                $apply(simd, self.op, self.out, self.a, self.b);
            }
        }

        impl<const N: usize> WithSimd for Steps<'_, $Lanes<N>> {
            type Output = ();
            #[inline(always)]
            fn with_simd<S: Simd>(self, simd: S) {
                run_each(self.values, self.missing, self.steps, Together(simd));
            }
        }

        impl<S: Simd, const N: usize> Apply<$Lanes<N>> for Together<S> {
            const PAIRS: bool = true;
            #[inline(always)]
            fn apply(&self, op: Op, out: &mut $Lanes<N>, a: &$Lanes<N>, b: &$Lanes<N>) -> Result<(), NoValue> {
                $apply(self.0, op, out, a, b);
                Ok(())
            }
            #[inline(always)]
            fn sin_cos(&self, $out: &mut $Lanes<N>, $next: &mut $Lanes<N>, $a: &$Lanes<N>) -> bool {
                let $simd = self.0;
                $pair;
                true
            }
            #[inline(always)]
            fn directions(
                &self,
                $out: &mut $Lanes<N>,
                $next: &mut $Lanes<N>,
                $a: &$Lanes<N>,
                $b: &$Lanes<N>,
            ) -> bool {
                let $simd = self.0;
                $directions
            }
        }
    )*};
}

runs! {
    Lanes apply |simd, sin, cos, a, b| each(simd, SinCos, [&mut sin.0, &mut cos.0], [&a.0]), {
        each(simd, DirectionCosines, [&mut sin.0, &mut cos.0], [&a.0, &b.0]);
        true
    };
    DualLanes apply_dual |simd, sin, cos, a, _b| {
        let (mut s, mut c) = (Lanes::ZERO, Lanes::ZERO);
        each(simd, SinCos, [&mut s.0, &mut c.0], [&a.value.0]);
        chain(simd, sin, &s, &c, a);
        chain(simd, cos, &c, &-s, a);
    }, {
        let _ = (simd, sin, cos, a);
        false
    };
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Bounded, BoundedLanes, Draws, Number};

    /// Sine and cosine of slot 0, in both orders, side by side and not.
    fn waves<L: Number<Context = ()>>(a: L) -> Vec<L> {
        let step = |op, out| Instruction { op, a: 0, b: 0, out };
        let steps = [(Op::Sin, 1), (Op::Cos, 2), (Op::Cos, 3), (Op::Sin, 4), (Op::Sin, 5), (Op::Abs, 6), (Op::Cos, 7)];
        let mut values = vec![a; 8];
        let mut missing = vec![Some(NoValue::Indeterminate); 8];
        missing[0] = None;
        L::run(&(), &mut values, &mut missing, &steps.map(|(op, out)| step(op, out)));
        assert!(missing.iter().all(Option::is_none));
        values
    }

    #[test]
    fn sine_and_cosine_at_once_are_what_they_are_alone() {
        let mut draws = Draws::new(3);
        for round in 0..200 {
            // Huge angles do not fit.
            let mut x = || draws.below(1 << 20) as f64 / 65536.0 - 8.0 + if round % 8 == 0 { 1e7 } else { 0.0 };
            let (a, da) = (Lanes::<16>(std::array::from_fn(|_| x())), Lanes(std::array::from_fn(|_| x())));
            let plain = waves(a);
            assert!(plain[1] == plain[5] && plain[4] == plain[5] && plain[2] == plain[7] && plain[3] == plain[7]);
            let dual = waves(DualLanes { value: a, tangent: da });
            assert!(dual[1] == dual[5] && dual[4] == dual[5] && dual[2] == dual[7] && dual[3] == dual[7]);
            assert!(dual[1].value == plain[1] && dual[2].value == plain[2] && plain[1] != plain[2]);
            let bounded = waves(BoundedLanes::of(a.0.map(|x| Bounded::new(x, 1e-9))));
            assert!(bounded[1] == bounded[5] && bounded[4] == bounded[5]);
            assert!(bounded[2] == bounded[7] && bounded[3] == bounded[7]);
            assert!(bounded[1].values() == &plain[1].0 && bounded[2].values() == &plain[2].0);
        }
    }
}
