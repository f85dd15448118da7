//! Laws: identities of functions, a closed list.
//!
//! **In:** a law and the expressions that it is about. **Out:** an equation that is true wherever both sides have values and the conditions that stand beside the
//! law hold. **Guaranteed:** every row is an identity of real functions with principal values, and is tried on numbers by a test. Conditions that only
//! make sides have values are not written: the needs of both sides say them.
//!
//! **Traps.** ln(eˣ) = x always, but arcsin(sin x) = x on [−π/2, π/2] only; √(x²) = |x|, not x; ln(xy) = ln x + ln y, where x and y are positive (the right side says so); eᵘ = u^… with a
//! written whole exponent is another operation than u^v = e^{v ln u}, which is for u > 0.

use super::context::Says;
use super::draft::{Draft, Made};
use super::needs::Need;
use super::rules::{made, needs_of};
use super::term::{Sense, Term};
use super::when::When;
use expr::domain::Sign;
use expr::{Expr, Graph, Op, Rational};
use serde::{Deserialize, Serialize};

macro_rules! laws {
    ($( $name:ident $arity:literal $words:literal; )*) => {
        /// A law, for expressions u, v, w.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
        #[serde(rename_all = "kebab-case")]
        pub enum Law {
            $( #[doc = $words] $name, )*
        }

        impl Law {
            /// Every law.
            pub const ALL: &'static [Law] = &[ $( Law::$name, )* ];

            /// The number of expressions that it is about.
            pub fn arity(self) -> usize {
                match self { $( Law::$name => $arity, )* }
            }

            /// The law in words.
            pub fn words(self) -> &'static str {
                match self { $( Law::$name => $words, )* }
            }
        }
    };
}

laws! {
    Pythagoras 1 "sin²u + cos²u = 1";
    SineOfSum 2 "sin(u+v) = sin u cos v + cos u sin v";
    CosineOfSum 2 "cos(u+v) = cos u cos v − sin u sin v";
    SineOfOpposite 1 "sin(−u) = −sin u";
    CosineOfOpposite 1 "cos(−u) = cos u";
    Tangent 1 "tan u = sin u / cos u";
    SineOfPi 0 "sin π = 0";
    CosineOfPi 0 "cos π = −1";
    SineOfQuarter 0 "sin(π/2) = 1";
    CosineOfQuarter 0 "cos(π/2) = 0";
    ExponentialOfSum 2 "exp(u+v) = exp u · exp v";
    ExponentialOfOpposite 1 "exp(−u) = 1/exp u";
    HyperbolicSine 1 "sinh u = (exp u − exp(−u))/2";
    HyperbolicCosine 1 "cosh u = (exp u + exp(−u))/2";
    HyperbolicTangent 1 "tanh u = sinh u / cosh u";
    ExponentialOfLogarithm 1 "exp(ln u) = u";
    LogarithmOfExponential 1 "ln(exp u) = u";
    LogarithmOfProduct 2 "ln(uv) = ln u + ln v";
    LogarithmOfPower 2 "ln(u^v) = v ln u, for u > 0";
    Power 2 "u^v = exp(v ln u), for u > 0";
    PowerOfSum 3 "u^(v+w) = u^v · u^w, for u > 0";
    PowerOfPower 3 "u^(vw) = (u^v)^w, for a whole number w, and u > 0 unless v and w are numbers above 0";
    SquareOfRoot 1 "(√u)² = u";
    RootOfSquare 1 "√(u²) = |u|";
    RootOfProduct 2 "√(uv) = √u √v";
    RootOfQuotient 2 "√(u/v) = √u/√v";
    LogarithmOfQuotient 2 "ln(u/v) = ln u − ln v";
    SquareOfAbsolute 1 "|u|² = u²";
    AbsoluteOfPositive 1 "|u| = u, for u ≥ 0";
    AbsoluteOfNegative 1 "|u| = −u, for −u ≥ 0";
    AbsoluteOfProduct 2 "|uv| = |u| |v|";
    SineOfArcsine 1 "sin(arcsin u) = u";
    CosineOfArcsine 1 "cos(arcsin u) = √(1−u²)";
    CosineOfArccosine 1 "cos(arccos u) = u";
    SineOfArccosine 1 "sin(arccos u) = √(1−u²)";
    TangentOfArctangent 1 "tan(arctan u) = u";
    SineOfArctangent 1 "sin(arctan u) √(1+u²) = u";
    CosineOfArctangent 1 "cos(arctan u) √(1+u²) = 1";
    ArcsineOfSine 1 "arcsin(sin u) = u, for π/2 + u ≥ 0 and π/2 − u ≥ 0";
    ArccosineOfCosine 1 "arccos(cos u) = u, for u ≥ 0 and π − u ≥ 0";
    ArctangentOfTangent 1 "arctan(tan u) = u, for π/2 + u > 0 and π/2 − u > 0";
    ArcsineAndArccosine 1 "arcsin u + arccos u = π/2";
    CosineOfAngle 2 "cos(atan2(v,u)) √(u²+v²) = u";
    SineOfAngle 2 "sin(atan2(v,u)) √(u²+v²) = v";
    AngleOnRight 2 "atan2(v,u) = arctan(v/u), for u > 0";
    DirectionCosine 2 "(u/√(u²+v²)) √(u²+v²) = u";
    MeanOfEquals 1 "agm(u,u) = u";
}

/// The largest whole exponent of [`Law::PowerOfPower`].
const MOST_POWER: u32 = 64;

/// Both sides, and the conditions.
struct Row {
    left: Expr,
    right: Expr,
    conditions: Vec<Need>,
}

/// An identity of the list.
pub(crate) fn law(draft: &mut Draft, law: Law, of: &[Term]) -> Result<Made, String> {
    if of.len() != law.arity() {
        return Err("the law is about another number of expressions".to_owned());
    }
    let of: Vec<Expr> = of.iter().map(|term| draft.context.read(term)).collect::<Result<_, _>>()?;
    let zero = draft.context.graph.integer(0);
    let at = |i: usize| of.get(i).copied().unwrap_or(zero);
    let Row { left, right, conditions } = row(&mut draft.context.graph, law, [at(0), at(1), at(2)]);
    let says = Says { left, sense: Sense::Equal, right };
    let mut needs = needs_of(draft, says);
    for condition in conditions {
        needs.extend(super::needs::needs(&mut draft.context, condition.value));
        needs.insert(condition);
    }
    Ok(made("law", vec![], says, When::Always, needs))
}

/// Sides of a law, and its conditions.
type Sides = (Expr, Expr);

fn row(g: &mut Graph, law: Law, [u, v, w]: [Expr; 3]) -> Row {
    let mut conditions = Vec::new();
    let found = circular(g, law, [u, v], &mut conditions)
        .or_else(|| exponential(g, law, [u, v, w], &mut conditions))
        .or_else(|| root(g, law, [u, v], &mut conditions))
        .or_else(|| inverse(g, law, u, &mut conditions));
    // A law that no list has says nothing; a test sees that there is none.
    let (left, right) = found.unwrap_or((u, u));
    Row { left, right, conditions }
}

fn f(g: &mut Graph, op: Op, e: Expr) -> Expr {
    g.unary(op, e)
}

/// π/2
fn quarter_turn(g: &mut Graph) -> Expr {
    let (half, pi) = (g.constant(Rational::ONE / Rational::from(2)), g.pi());
    g.mul(half, pi)
}

/// Laws of sine, cosine, tangent and angles.
fn circular(g: &mut Graph, law: Law, [u, v]: [Expr; 2], conditions: &mut Vec<Need>) -> Option<Sides> {
    let one = g.integer(1);
    let pi = g.pi();
    let quarter = quarter_turn(g);
    let sin = g.unary(Op::Sin, u);
    let cos = g.unary(Op::Cos, u);
    let minus = g.neg(u);
    let mut asks = |value: Expr, sign: Sign| conditions.push(Need { value, sign });
    // √(u²+v²)
    let length = |g: &mut Graph| {
        let (uu, vv) = (g.powi(u, 2), g.powi(v, 2));
        let sum = g.add(uu, vv);
        g.unary(Op::Sqrt, sum)
    };
    Some(match law {
        Law::Pythagoras => {
            let (a, b) = (g.powi(sin, 2), g.powi(cos, 2));
            (g.add(a, b), one)
        }
        Law::SineOfSum | Law::CosineOfSum => {
            let (s, c, both) = (f(g, Op::Sin, v), f(g, Op::Cos, v), g.add(u, v));
            if law == Law::SineOfSum {
                let (a, b) = (g.mul(sin, c), g.mul(cos, s));
                (f(g, Op::Sin, both), g.add(a, b))
            } else {
                let (a, b) = (g.mul(cos, c), g.mul(sin, s));
                (f(g, Op::Cos, both), g.sub(a, b))
            }
        }
        Law::SineOfOpposite => (f(g, Op::Sin, minus), g.neg(sin)),
        Law::CosineOfOpposite => (f(g, Op::Cos, minus), cos),
        Law::Tangent => (f(g, Op::Tan, u), g.div(sin, cos)),
        Law::SineOfPi => (f(g, Op::Sin, pi), g.integer(0)),
        Law::CosineOfPi => (f(g, Op::Cos, pi), g.integer(-1)),
        Law::SineOfQuarter => (f(g, Op::Sin, quarter), one),
        Law::CosineOfQuarter => (f(g, Op::Cos, quarter), g.integer(0)),
        Law::CosineOfAngle | Law::SineOfAngle => {
            let (angle, r) = (g.binary(Op::Arctan2, v, u), length(g));
            let (op, side) = if law == Law::CosineOfAngle { (Op::Cos, u) } else { (Op::Sin, v) };
            let turned = f(g, op, angle);
            (g.mul(turned, r), side)
        }
        Law::AngleOnRight => {
            asks(u, Sign::Positive);
            let slope = g.div(v, u);
            (g.binary(Op::Arctan2, v, u), f(g, Op::Arctan, slope))
        }
        Law::DirectionCosine => {
            let (direction, r) = (g.binary(Op::DirectionCosine, u, v), length(g));
            (g.mul(direction, r), u)
        }
        _ => return None,
    })
}

/// Laws of exponentials, logarithms and powers.
fn exponential(g: &mut Graph, law: Law, [u, v, w]: [Expr; 3], conditions: &mut Vec<Need>) -> Option<Sides> {
    let one = g.integer(1);
    let half = g.constant(Rational::ONE / Rational::from(2));
    let minus = g.neg(u);
    let mut asks = |value: Expr, sign: Sign| conditions.push(Need { value, sign });
    Some(match law {
        Law::ExponentialOfSum => {
            let (a, b, both) = (f(g, Op::Exp, u), f(g, Op::Exp, v), g.add(u, v));
            (f(g, Op::Exp, both), g.mul(a, b))
        }
        Law::ExponentialOfOpposite => {
            let a = f(g, Op::Exp, u);
            (f(g, Op::Exp, minus), g.div(one, a))
        }
        Law::HyperbolicSine | Law::HyperbolicCosine => {
            let (a, b) = (f(g, Op::Exp, u), f(g, Op::Exp, minus));
            let sine = law == Law::HyperbolicSine;
            let both = if sine { g.sub(a, b) } else { g.add(a, b) };
            (f(g, if sine { Op::Sinh } else { Op::Cosh }, u), g.mul(half, both))
        }
        Law::HyperbolicTangent => {
            let (a, b) = (f(g, Op::Sinh, u), f(g, Op::Cosh, u));
            (f(g, Op::Tanh, u), g.div(a, b))
        }
        Law::ExponentialOfLogarithm => {
            let a = f(g, Op::Ln, u);
            (f(g, Op::Exp, a), u)
        }
        Law::LogarithmOfExponential => {
            let a = f(g, Op::Exp, u);
            (f(g, Op::Ln, a), u)
        }
        Law::LogarithmOfProduct => {
            let (a, b, both) = (f(g, Op::Ln, u), f(g, Op::Ln, v), g.mul(u, v));
            (f(g, Op::Ln, both), g.add(a, b))
        }
        Law::LogarithmOfQuotient => {
            let (a, b, ratio) = (f(g, Op::Ln, u), f(g, Op::Ln, v), g.div(u, v));
            (f(g, Op::Ln, ratio), g.sub(a, b))
        }
        Law::LogarithmOfPower | Law::Power => {
            asks(u, Sign::Positive);
            let (power, log) = (g.binary(Op::Pow, u, v), f(g, Op::Ln, u));
            let product = g.mul(v, log);
            match law {
                Law::Power => (power, f(g, Op::Exp, product)),
                _ => (f(g, Op::Ln, power), product),
            }
        }
        Law::PowerOfSum => {
            asks(u, Sign::Positive);
            let both = g.add(v, w);
            let (a, b) = (g.binary(Op::Pow, u, v), g.binary(Op::Pow, u, w));
            (g.binary(Op::Pow, u, both), g.mul(a, b))
        }
        Law::PowerOfPower => {
            // Of another w it says nothing. 0 to a power above 0 is 0.
            let whole = g.as_constant(w).and_then(|w| i32::try_from(w.clone()).ok())?;
            let is_above = whole > 0 && g.as_constant(v).is_some_and(|v| *v > Rational::ZERO);
            if !is_above {
                asks(u, Sign::Positive);
            }
            if whole.unsigned_abs() > MOST_POWER {
                return None;
            }
            let (both, inner) = (g.mul(v, w), g.binary(Op::Pow, u, v));
            (g.binary(Op::Pow, u, both), g.powi(inner, whole))
        }
        _ => return None,
    })
}

/// Laws of roots, absolute values and means.
fn root(g: &mut Graph, law: Law, [u, v]: [Expr; 2], conditions: &mut Vec<Need>) -> Option<Sides> {
    let minus = g.neg(u);
    let mut asks = |value: Expr, sign: Sign| conditions.push(Need { value, sign });
    Some(match law {
        Law::SquareOfRoot => {
            let a = f(g, Op::Sqrt, u);
            (g.powi(a, 2), u)
        }
        Law::RootOfSquare => {
            let a = g.powi(u, 2);
            (f(g, Op::Sqrt, a), f(g, Op::Abs, u))
        }
        Law::RootOfProduct | Law::AbsoluteOfProduct => {
            let op = if law == Law::RootOfProduct { Op::Sqrt } else { Op::Abs };
            let (a, b, both) = (f(g, op, u), f(g, op, v), g.mul(u, v));
            (f(g, op, both), g.mul(a, b))
        }
        Law::RootOfQuotient => {
            let (a, b, ratio) = (f(g, Op::Sqrt, u), f(g, Op::Sqrt, v), g.div(u, v));
            (f(g, Op::Sqrt, ratio), g.div(a, b))
        }
        Law::SquareOfAbsolute => {
            let a = f(g, Op::Abs, u);
            (g.powi(a, 2), g.powi(u, 2))
        }
        Law::AbsoluteOfPositive => {
            asks(u, Sign::NotNegative);
            (f(g, Op::Abs, u), u)
        }
        Law::AbsoluteOfNegative => {
            asks(minus, Sign::NotNegative);
            (f(g, Op::Abs, u), minus)
        }
        Law::MeanOfEquals => (g.binary(Op::Agm, u, u), u),

        _ => return None,
    })
}

/// Laws of the inverse functions of sine, cosine and tangent.
fn inverse(g: &mut Graph, law: Law, u: Expr, conditions: &mut Vec<Need>) -> Option<Sides> {
    let pi = g.pi();
    let quarter = quarter_turn(g);
    let sin = g.unary(Op::Sin, u);
    let cos = g.unary(Op::Cos, u);
    let mut asks = |value: Expr, sign: Sign| conditions.push(Need { value, sign });
    // √(1−u²)
    let unit = |g: &mut Graph| {
        let square = g.powi(u, 2);
        let (one, op) = (g.integer(1), Op::Sqrt);
        let under = g.sub(one, square);
        g.unary(op, under)
    };
    Some(match law {
        Law::SineOfArcsine | Law::CosineOfArcsine => {
            let a = f(g, Op::Arcsin, u);
            if law == Law::SineOfArcsine { (f(g, Op::Sin, a), u) } else { (f(g, Op::Cos, a), unit(g)) }
        }
        Law::CosineOfArccosine | Law::SineOfArccosine => {
            let a = f(g, Op::Arccos, u);
            if law == Law::CosineOfArccosine { (f(g, Op::Cos, a), u) } else { (f(g, Op::Sin, a), unit(g)) }
        }
        Law::TangentOfArctangent => {
            let a = f(g, Op::Arctan, u);
            (f(g, Op::Tan, a), u)
        }
        Law::SineOfArctangent | Law::CosineOfArctangent => {
            let (one, square, a) = (g.integer(1), g.powi(u, 2), f(g, Op::Arctan, u));
            let under = g.add(one, square);
            let (op, side) = if law == Law::SineOfArctangent { (Op::Sin, u) } else { (Op::Cos, one) };
            let (turned, root) = (f(g, op, a), f(g, Op::Sqrt, under));
            (g.mul(turned, root), side)
        }
        Law::ArcsineOfSine | Law::ArctangentOfTangent => {
            let (above, below) = (g.add(quarter, u), g.sub(quarter, u));
            let sine = law == Law::ArcsineOfSine;
            let sign = if sine { Sign::NotNegative } else { Sign::Positive };
            asks(above, sign);
            asks(below, sign);
            let inner = if sine { sin } else { f(g, Op::Tan, u) };
            (f(g, if sine { Op::Arcsin } else { Op::Arctan }, inner), u)
        }
        Law::ArccosineOfCosine => {
            asks(u, Sign::NotNegative);
            let below = g.sub(pi, u);
            asks(below, Sign::NotNegative);
            (f(g, Op::Arccos, cos), u)
        }
        Law::ArcsineAndArccosine => {
            let (a, b) = (f(g, Op::Arcsin, u), f(g, Op::Arccos, u));
            (g.add(a, b), quarter)
        }
        _ => return None,
    })
}
