//! The table of operations: the one place where an operation is declared.
//!
//! From each row follow a variant of [`Op`], a method of every [`Number`], the arm of the evaluation loop, how the operation is read
//! and written in formulas, and the row of the grammar page. To add an operation: add a row here, then say what the compiler asks
//! for: its values where a number type cannot have them from another one, its derivatives, and in `expr` its row in the table of
//! domains.

use super::{NoValue, Rational};

/// One step of a program: `values[out] := op(values[a], values[b])`, with b = a for operations of one argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Instruction {
    /// The operation.
    pub op: Op,
    /// Slot of the first argument.
    pub a: u32,
    /// Slot of the second argument; equal to `a` when there is none.
    pub b: u32,
    /// Slot of the result; larger than `a` and `b`.
    pub out: u32,
}

/// How one step is carried out.
pub(super) trait Apply<N> {
    /// Whether [`Apply::sin_cos`] and [`Apply::directions`] are there.
    const PAIRS: bool = false;

    /// `out` := `op` of `a` and `b`.
    fn apply(&self, op: Op, out: &mut N, a: &N, b: &N) -> Result<(), NoValue>;

    /// `sin` and `cos` of `a` at once; `false` where each is to be made by itself.
    #[inline(always)]
    fn sin_cos(&self, _sin: &mut N, _cos: &mut N, _a: &N) -> bool {
        false
    }

    /// The direction cosines of (a, b) and of (b, a) at once; `false` where each is to be made by itself.
    #[inline(always)]
    fn directions(&self, _first: &mut N, _second: &mut N, _a: &N, _b: &N) -> bool {
        false
    }
}

/// As the number type does it.
pub(super) struct Plain<'c, C>(pub(super) &'c C);

impl<N: Number> Apply<N> for Plain<'_, N::Context> {
    #[inline(always)]
    fn apply(&self, op: Op, out: &mut N, a: &N, b: &N) -> Result<(), NoValue> {
        op.apply(self.0, out, a, b)
    }
}

/// Why there is no result where an argument is missing: for the reason of the first one that is. What is restricted to where
/// something else has a value is *unknown* where that has one: a formula for a rate may miss what its function has.
fn absent(op: Op, a: Option<NoValue>, b: Option<NoValue>) -> Option<NoValue> {
    match (op == Op::Restrict, a, b) {
        (true, Some(_), None) => Some(NoValue::Indeterminate),
        (true, _, Some(of)) => Some(of),
        (_, a, b) => a.or(b),
    }
}

/// Two steps that are made at once.
#[derive(Clone, Copy)]
enum Pair {
    SineFirst,
    CosineFirst,
    Directions,
}

#[inline(always)]
fn pair(step: &Instruction, next: &Instruction) -> Option<Pair> {
    match (step.op, next.op) {
        (Op::Sin, Op::Cos) if step.a == next.a => Some(Pair::SineFirst),
        (Op::Cos, Op::Sin) if step.a == next.a => Some(Pair::CosineFirst),
        (Op::DirectionCosine, Op::DirectionCosine) if (step.a, step.b) == (next.b, next.a) => Some(Pair::Directions),
        _ => None,
    }
}

/// The evaluation loop: the steps in their order. An argument without a value is the reason why a result has none.
#[inline(always)]
pub(super) fn run_each<N, A: Apply<N>>(
    values: &mut [N],
    missing: &mut [Option<NoValue>],
    mut steps: &[Instruction],
    how: A,
) {
    while let [step, after @ ..] = steps {
        let Instruction { op, a, b, out } = *step;
        let (a, b, out) = (a as usize, b as usize, out as usize);
        // Arguments lie before the result, so the borrow can be split there.
        if A::PAIRS
            && let [next, after @ ..] = after
            && let Some(pair) = pair(step, next)
            && missing[a].is_none()
            && missing[b].is_none()
        {
            let (before, rest) = values.split_at_mut(next.out as usize);
            let (before, first) = before.split_at_mut(out);
            let (first, second) = (&mut first[0], &mut rest[0]);
            let made = match pair {
                Pair::SineFirst => how.sin_cos(first, second, &before[a]),
                Pair::CosineFirst => how.sin_cos(second, first, &before[a]),
                Pair::Directions => how.directions(first, second, &before[a], &before[b]),
            };
            if made {
                (missing[out], missing[next.out as usize]) = (None, None);
                steps = after;
                continue;
            }
        }
        let reason = missing[a].or(missing[b]);
        missing[out] = if reason.is_some() {
            absent(op, missing[a], missing[b])
        } else {
            let (before, rest) = values.split_at_mut(out);
            how.apply(op, &mut rest[0], &before[a], &before[b]).err()
        };
        steps = after;
    }
}

macro_rules! operations {
    (
        unary { $( $U:ident $u:ident $uspell:literal $uunits:literal; )* }
        binary { $( $B:ident $b:ident $bspell:literal $bunits:literal; )* }
        made { $( $M:ident $m:ident $mspell:literal $munits:literal $mdoc:literal; )* }
    ) => {
        /// An operation of the table. `Powi` carries its integer exponent and is unary.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum Op {
            $( #[doc = concat!("`", $uspell, "`.")] $U, )*
            $( #[doc = concat!("`", $bspell, "`.")] $B, )*
            $( #[doc = $mdoc] $M, )*
            /// Integer power xⁿ; x ≠ 0 where n < 0; x⁰ = 1.
            Powi(i32),
            /// a, where b has a value. No formula is written with it: it makes a rate (a) have no value where its function (b)
            /// has none. Where b has a value and a has none, nothing is known.
            Restrict,
        }

        impl Op {
            /// Every operation that formulas are written with; two exponents stand for all integer powers.
            pub const ALL: &'static [Op] = &[ $( Op::$U, )* $( Op::$B, )* Op::Powi(3), Op::Powi(-2) ];

            /// The same, and those that stand in programs only, but for restriction, which has no function of its own.
            pub const EVERY: &'static [Op] =
                &[ $( Op::$U, )* $( Op::$B, )* $( Op::$M, )* Op::Powi(3), Op::Powi(-2) ];

            /// Number of arguments.
            pub fn arity(self) -> usize {
                match self { $( Op::$U => 1, )* $( Op::$B => 2, )* $( Op::$M => 2, )* Op::Powi(_) => 1, Op::Restrict => 2 }
            }

            /// How the operation is written in a formula.
            pub fn spelling(self) -> &'static str {
                match self { $( Op::$U => $uspell, )* $( Op::$B => $bspell, )* $( Op::$M => $mspell, )* Op::Powi(_) => "^", Op::Restrict => r"\restriction" }
            }

            /// Largest relative error granted to its values in binary64, in units of 2⁻⁵²: see `elementary`. Where the errors of
            /// + − × ÷ √ are the rule, nothing is to be read here.
            pub(super) const fn units(self) -> f64 {
                match self { $( Op::$U => $uunits, )* $( Op::$B => $bunits, )* $( Op::$M => $munits, )* Op::Powi(_) | Op::Restrict => 1.0 }
            }

            /// `out` := this operation of `args`; `args.len()` is [`Op::arity`].
            ///
            /// # Errors
            /// The reason of the number type when there is no value; `out` is then unspecified.
            #[inline]
            pub fn apply<N: Number>(self, cx: &N::Context, out: &mut N, a: &N, b: &N) -> Result<(), NoValue> {
                match self {
                    $( Op::$U => out.$u(cx, a), )*
                    $( Op::$B => out.$b(cx, a, b), )*
                    $( Op::$M => out.$m(cx, a, b), )*
                    Op::Powi(n) => out.powi(cx, a, n),
                    Op::Restrict => out.restrict(cx, a, b),
                }
            }
        }

        /// An arithmetic in which formulas can be evaluated.
        ///
        /// Every method overwrites `self` with the result. No operation has a default: a new number type decides each
        /// operation, and a new operation is decided by each number type, or by the rule of one that is [`Uniform`].
        pub trait Number: Clone {
            /// What the arithmetic needs to know beside its arguments (the orders of a series, the prime of a field).
            type Context;

            /// The counted work of one operation: a number is as much work as it is large, about.
            fn work(_: &Self::Context) -> u64 {
                2 + size_of::<Self>() as u64 / 4
            }
            /// A value to be overwritten.
            fn blank(cx: &Self::Context) -> Self;
            /// `self` := the number that stands for an exact rational.
            fn rational(&mut self, cx: &Self::Context, r: &Rational) -> Result<(), NoValue>;
            /// `self` := π.
            fn pi(&mut self, cx: &Self::Context) -> Result<(), NoValue>;
            /// `self` := a, where b has a value: see [`Op::Restrict`].
            fn restrict(&mut self, cx: &Self::Context, a: &Self, b: &Self) -> Result<(), NoValue>;
            /// `self` := aⁿ.
            fn powi(&mut self, cx: &Self::Context, a: &Self, n: i32) -> Result<(), NoValue>;
            $( #[doc = concat!("`self` := `", $uspell, "` of `a`.")]
               fn $u(&mut self, cx: &Self::Context, a: &Self) -> Result<(), NoValue>; )*
            $( #[doc = concat!("`self` := `a` `", $bspell, "` `b`.")]
               fn $b(&mut self, cx: &Self::Context, a: &Self, b: &Self) -> Result<(), NoValue>; )*
            $( #[doc = concat!("See [`Op::", stringify!($M), "`].")]
               fn $m(&mut self, cx: &Self::Context, a: &Self, b: &Self) -> Result<(), NoValue>; )*

            /// Carries out the steps of a program. A type whose operations want wider registers than every processor has
            /// chooses them here, once for all steps; results are those of [`Op::apply`], bit for bit.
            // In one place, so that the operations become part of the loop.
            #[inline(never)]
            fn run(cx: &Self::Context, values: &mut [Self], missing: &mut [Option<NoValue>], steps: &[Instruction]) {
                run_each(values, missing, steps, Plain(cx));
            }
        }

        /// An arithmetic that carries out all operations by one rule, but for those that it knows better: these are written out.
        ///
        /// The rule is right for whatever operation the table may get. It has the result from another number type, or it says
        /// that there is none.
        pub trait Uniform: Clone {
            /// See [`Number::Context`].
            type Context;

            /// The rule: `self` := `op` of `a` and `b`, with b = a for operations of one argument.
            fn rule(&mut self, cx: &Self::Context, op: Op, a: &Self, b: &Self) -> Result<(), NoValue>;
            /// See [`Number::blank`].
            fn blank(cx: &Self::Context) -> Self;
            /// See [`Number::rational`].
            fn rational(&mut self, cx: &Self::Context, r: &Rational) -> Result<(), NoValue>;
            /// See [`Number::pi`].
            fn pi(&mut self, cx: &Self::Context) -> Result<(), NoValue>;
            /// See [`Number::restrict`].
            #[inline(always)]
            fn restrict(&mut self, cx: &Self::Context, a: &Self, b: &Self) -> Result<(), NoValue> {
                self.rule(cx, Op::Restrict, a, b)
            }
            /// See [`Number::powi`].
            #[inline(always)]
            fn powi(&mut self, cx: &Self::Context, a: &Self, n: i32) -> Result<(), NoValue> {
                self.rule(cx, Op::Powi(n), a, a)
            }
            $( #[doc = concat!("See [`Number::", stringify!($u), "`].")]
               #[inline(always)]
               fn $u(&mut self, cx: &Self::Context, a: &Self) -> Result<(), NoValue> { self.rule(cx, Op::$U, a, a) } )*
            $( #[doc = concat!("See [`Number::", stringify!($b), "`].")]
               #[inline(always)]
               fn $b(&mut self, cx: &Self::Context, a: &Self, b: &Self) -> Result<(), NoValue> { self.rule(cx, Op::$B, a, b) } )*
            $( #[doc = concat!("See [`Op::", stringify!($M), "`].")]
               #[inline(always)]
               fn $m(&mut self, cx: &Self::Context, a: &Self, b: &Self) -> Result<(), NoValue> { self.rule(cx, Op::$M, a, b) } )*
            /// See [`Number::run`].
            #[inline(never)]
            fn run(cx: &Self::Context, values: &mut [Self], missing: &mut [Option<NoValue>], steps: &[Instruction]) {
                run_each(values, missing, steps, Plain(cx));
            }
        }

        /// Each operation as the type knows it, or by its rule.
        impl<T: Uniform> Number for T {
            type Context = <T as Uniform>::Context;

            #[inline(always)]
            fn blank(cx: &Self::Context) -> Self { <T as Uniform>::blank(cx) }
            #[inline(always)]
            fn rational(&mut self, cx: &Self::Context, r: &Rational) -> Result<(), NoValue> { Uniform::rational(self, cx, r) }
            #[inline(always)]
            fn pi(&mut self, cx: &Self::Context) -> Result<(), NoValue> { Uniform::pi(self, cx) }
            #[inline(always)]
            fn restrict(&mut self, cx: &Self::Context, a: &Self, b: &Self) -> Result<(), NoValue> {
                Uniform::restrict(self, cx, a, b)
            }
            #[inline(always)]
            fn powi(&mut self, cx: &Self::Context, a: &Self, n: i32) -> Result<(), NoValue> { Uniform::powi(self, cx, a, n) }
            $( #[inline(always)]
               fn $u(&mut self, cx: &Self::Context, a: &Self) -> Result<(), NoValue> { Uniform::$u(self, cx, a) } )*
            $( #[inline(always)]
               fn $b(&mut self, cx: &Self::Context, a: &Self, b: &Self) -> Result<(), NoValue> { Uniform::$b(self, cx, a, b) } )*
            $( #[inline(always)]
               fn $m(&mut self, cx: &Self::Context, a: &Self, b: &Self) -> Result<(), NoValue> { Uniform::$m(self, cx, a, b) } )*
            #[inline(always)]
            fn run(cx: &Self::Context, values: &mut [Self], missing: &mut [Option<NoValue>], steps: &[Instruction]) {
                <T as Uniform>::run(cx, values, missing, steps);
            }
        }
    };
}

// Name, method, spelling, and the error of values in binary64.
operations! {
    unary {
        Neg neg "-" 1.0;
        Sqrt sqrt r"\sqrt" 1.0;
        Exp exp r"\exp" 1.0;
        Ln ln r"\ln" 1.0;
        Sin sin r"\sin" 1.0;
        Cos cos r"\cos" 1.0;
        Tan tan r"\tan" 3.0;
        Arcsin arcsin r"\arcsin" 2.0;
        Arccos arccos r"\arccos" 2.0;
        Arctan arctan r"\arctan" 3.0;
        Sinh sinh r"\sinh" 3.0;
        Cosh cosh r"\cosh" 2.0;
        Tanh tanh r"\tanh" 3.0;
        Abs abs r"|\cdot|" 1.0;
    }
    binary {
        Add add "+" 1.0;
        Sub sub "-" 1.0;
        Mul mul r"\cdot" 1.0;
        Div div r"\frac" 1.0;
        Pow pow "^" 1.0;
        Arctan2 arctan2 r"\operatorname{atan2}" 3.0;
        Agm agm r"\operatorname{agm}" 1.0;
    }
    made {
        DirectionCosine direction_cosine r"\cos\operatorname{atan2}" 2.0
            "a/√(a² + b²), the cosine of the angle between (a, b) and the first axis: cos atan2(b, a), and sin atan2(a, b). No formula \
             is written with it; it stands where one takes the sine or cosine of an angle, and has no cut.";
    }
}
