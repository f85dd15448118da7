//! Models of twice the precision contain what they should, to the last of their digits, and the comparison that says so
//! notices every mistake they could rest on.

use super::faults::{EXACT_PAIRS, LOST_LOW, NO_LAGRANGE, NO_TAIL};
use super::{Interval, Precise, PreciseModel, TaylorModel};
use crate::{DoubleDouble, Draws, NoValue, Number, Op, Rational, Scalar};
use dashu_float::{FBig, round::mode::HalfEven};
use std::cell::Cell;
use std::thread::LocalKey;

type Exact = FBig<HalfEven, 2>;

/// Bits of what models are compared with.
const BITS: usize = 400;

fn exact(x: f64) -> Exact {
    Exact::try_from(x).expect("finite").with_precision(BITS).value()
}

fn pair(x: DoubleDouble) -> Exact {
    exact(x.high()) + exact(x.low())
}

/// From −1 to 1.
fn signed(draws: &mut Draws) -> f64 {
    2.0 * ((draws.bits() >> 11) as f64 / (1_u64 << 53) as f64) - 1.0
}

/// Σ cₖsᵏ
fn polynomial(coefficients: &[DoubleDouble], s: f64) -> Exact {
    coefficients.iter().rev().fold(exact(0.0), |sum, &c| sum * exact(s) + pair(c))
}

/// A polynomial around a centre, with coefficients of twice the precision of binary64, and how far a quantity may be away
/// from it.
struct Quantity {
    coefficients: Vec<DoubleDouble>,
    rest: f64,
}

impl Quantity {
    fn random(draws: &mut Draws, centre: f64, spread: f64, rest: f64) -> Quantity {
        let mut number = |size: f64| DoubleDouble::new(size * signed(draws), 1e-17 * size * signed(draws));
        let mut coefficients = vec![DoubleDouble::point(centre) + number(1e-3)];
        let count = (1e6 * number(1.0).high().abs()) as usize % 23;
        let mut size = spread;
        for _ in 0..count {
            coefficients.push(number(size));
            size *= 0.4;
        }
        Quantity { coefficients, rest }
    }

    /// Made of sums and products of models, so that what is tested makes its own input.
    fn model(&self) -> PreciseModel {
        let s = PreciseModel::variable(&Precise::new(DoubleDouble::ZERO, 0.0), 1.0);
        let mut sum = PreciseModel::ZERO;
        for &c in self.coefficients.iter().rev() {
            let mut product = PreciseModel::ZERO;
            product.mul(&(), &sum, &s).expect("finite");
            sum.add(&(), &product, &PreciseModel::constant(&Precise::new(c, 0.0))).expect("finite");
        }
        let wide = sum;
        sum.add(&(), &wide, &PreciseModel::constant(&Precise::new(DoubleDouble::ZERO, self.rest))).expect("finite");
        sum
    }

    /// With the part `of` of the rest.
    fn at(&self, s: f64, of: f64) -> Exact {
        polynomial(&self.coefficients, s) + exact(self.rest) * exact(of)
    }
}

/// Whether a quantity is where its model says, at s.
fn fits(model: &PreciseModel, s: f64, truth: &Exact) -> bool {
    let (coefficients, rest) = model.parts();
    let off = truth.clone() - polynomial(&coefficients, s);
    let off = if off < exact(0.0) { -off } else { off };
    off <= exact(rest) + exact(f64::from_bits((1023 - 340) << 52))
}

/// How often operations miss the truth, how many results were compared, and the largest remainder of those that began
/// without any.
fn misses(ops: &[Op]) -> (usize, usize, f64) {
    let (mut draws, mut missed, mut compared, mut largest) = (Draws::new(9), 0, 0, 0.0_f64);
    for &op in ops {
        for round in 0..120 {
            let rest = if round % 3 == 0 { 1e-20 * (1.0 + signed(&mut draws)) } else { 0.0 };
            let spread = [0.0, 1e-3, 0.1][round % 3];
            let centre = if matches!(op, Op::Sqrt | Op::Pow) { 2.0 } else { 1.0 } + signed(&mut draws);
            let scale = if round % 7 == 0 && matches!(op, Op::Sin | Op::Cos | Op::Exp) { 40.0 } else { 1.0 };
            let a = Quantity::random(&mut draws, scale * centre, spread, rest);
            let y = 3.0 + signed(&mut draws);
            let mut b = Quantity::random(&mut draws, y, spread, rest);
            if op == Op::Pow {
                b = Quantity { coefficients: vec![DoubleDouble::point(-1.5)], rest: 0.0 };
            }
            let mut model = PreciseModel::ZERO;
            if op.apply(&(), &mut model, &a.model(), &b.model()).is_err() {
                continue;
            }
            if rest == 0.0 && scale == 1.0 {
                largest = largest.max(model.parts().1);
            }
            for _ in 0..4 {
                let (s, of) = (signed(&mut draws), signed(&mut draws));
                let (x, y) = (a.at(s, of), b.at(s, -of));
                let truth = match op {
                    Op::Add => x + y,
                    Op::Sub => x - y,
                    Op::Mul => x * y,
                    Op::Div => x / y,
                    Op::Powi(3) => x.clone() * x.clone() * x,
                    Op::Sqrt => x.sqrt(),
                    Op::Exp => x.exp(),
                    Op::Sin => x.sin(),
                    Op::Cos => x.cos(),
                    Op::Sinh => (x.clone().exp() - (-x).exp()) / exact(2.0),
                    Op::Cosh => (x.clone().exp() + (-x).exp()) / exact(2.0),
                    Op::Pow => exact(1.0) / (x.clone() * x.sqrt()),
                    _ => x.clone().sin() / x.cos(),
                };
                compared += 1;
                missed += usize::from(!fits(&model, s, &truth));
            }
        }
    }
    (missed, compared, largest)
}

const ARITHMETIC: [Op; 5] = [Op::Add, Op::Sub, Op::Mul, Op::Div, Op::Powi(3)];
const FUNCTIONS: [Op; 6] = [Op::Sqrt, Op::Exp, Op::Sin, Op::Cos, Op::Sinh, Op::Cosh];

/// The same with a mistake.
fn misses_with(mistake: &'static LocalKey<Cell<bool>>, ops: &[Op]) -> usize {
    mistake.set(true);
    let (missed, _, _) = misses(ops);
    mistake.set(false);
    missed
}

#[test]
fn results_are_contained() {
    let (missed, compared, largest) = misses(&ARITHMETIC);
    println!("{compared} compared, largest remainder {largest:e}");
    assert!(missed == 0 && compared > 2_000, "{missed} of {compared}");
    let (missed, compared, _) = misses(&FUNCTIONS);
    assert!(missed == 0 && compared > 1_500, "{missed} of {compared}");
    let (missed, compared, _) = misses(&[Op::Tan, Op::Pow]);
    assert!(missed == 0 && compared > 300, "{missed} of {compared}");
}

#[test]
fn remainders_are_small() {
    let s = PreciseModel::variable(&Precise::new(DoubleDouble::new(0.7, 1e-17), 0.0), 0.02);
    let b = PreciseModel::constant(&Precise::new(DoubleDouble::point(-1.5), 0.0));
    let mut power = PreciseModel::ZERO;
    power.pow(&(), &s, &b).expect("defined");
    assert!(power.parts().1 < 1e-26, "{:e}", power.parts().1);
    for op in [Op::Mul, Op::Div, Op::Sqrt, Op::Exp, Op::Sin, Op::Cos, Op::Tan, Op::Sinh, Op::Cosh] {
        let mut out = PreciseModel::ZERO;
        op.apply(&(), &mut out, &s, &s).expect("defined");
        assert!(out.parts().1 < 1e-26, "{op:?}: {:e}", out.parts().1);
    }
}

#[test]
fn rounding_that_is_taken_for_exact_is_noticed() {
    let missed = misses_with(&EXACT_PAIRS, &ARITHMETIC);
    assert!(missed > 100, "{missed}");
}

#[test]
fn lost_terms_of_products_are_noticed() {
    let missed = misses_with(&NO_TAIL, &[Op::Mul, Op::Powi(3)]);
    assert!(missed > 20, "{missed}");
}

/// The remainders of the series are far below rounding, so that both must be left out.
#[test]
fn lost_remainders_of_functions_are_noticed() {
    EXACT_PAIRS.set(true);
    let missed = misses_with(&NO_LAGRANGE, &[Op::Exp, Op::Sin, Op::Cos]);
    EXACT_PAIRS.set(false);
    assert!(missed > 20, "{missed}");
}

/// What becomes a model of binary64 keeps what there is no room for as a remainder.
#[test]
fn second_numbers_become_remainders() {
    let lost = || {
        let mut draws = Draws::new(4);
        let mut lost = 0;
        for _ in 0..200 {
            let a = Quantity::random(&mut draws, 1.0, 0.1, 0.0);
            let back = PreciseModel::of(&a.model().rounded());
            let s = signed(&mut draws);
            lost += usize::from(!fits(&back, s, &a.at(s, 0.0)));
        }
        lost
    };
    assert_eq!(lost(), 0);
    LOST_LOW.set(true);
    let found = lost();
    LOST_LOW.set(false);
    assert!(found > 100, "{found}");
}

/// The integral from −1, its value at 1, and what the polynomial changes near there.
#[test]
fn integrals_are_contained() {
    let outside = || {
        let (mut draws, mut outside) = (Draws::new(6), 0);
        for _ in 0..200 {
            let a = Quantity::random(&mut draws, 1.0, 0.5, 1e-25);
            let half = 0.3 * signed(&mut draws);
            let integral = a.model().integral(half);
            let antiderivative = |s: f64, of: f64| {
                let terms = a.coefficients.iter().enumerate().rev();
                let sum = terms.fold(exact(0.0), |sum, (k, &c)| (sum + pair(c) / exact((k + 1) as f64)) * exact(s));
                exact(half) * (sum + exact(a.rest) * exact(of) * exact(s))
            };
            let (s, of) = (signed(&mut draws), signed(&mut draws));
            let truth = antiderivative(s, of) - antiderivative(-1.0, of);
            outside += usize::from(!fits(&integral, s, &truth));
            let end = integral.at_end();
            let off = antiderivative(1.0, of) - antiderivative(-1.0, of) - pair(end.centre());
            outside += usize::from(off > exact(end.error()) || -off > exact(end.error()));
            let (gap, model) = (1e-3, a.model());
            let change = polynomial(&model.parts().0, 1.0) - polynomial(&model.parts().0, 1.0 - gap);
            let most = exact(model.change_before_end(gap));
            outside += usize::from(change > most || -change > most);
        }
        outside
    };
    assert_eq!(outside(), 0);
}

#[test]
fn constants_are_contained() {
    let rational = |text: &str| {
        let r: Rational = text.parse().expect("a number");
        let mut x = PreciseModel::ZERO;
        x.rational(&(), &r).expect("finite");
        (r, x.value())
    };
    for text in ["1/10", "-22/7", "3/8", "1000000000000000000000000000001/3", "0"] {
        let (r, x) = rational(text);
        let number = |x: f64| Rational::try_from(x).expect("finite");
        let off = r.clone() - number(x.centre().high()) - number(x.centre().low());
        let most = number(x.error());
        assert!(off <= most && -off <= most, "{text}");
        assert!(x.error() <= 1e-31 * x.centre().high().abs(), "{text}");
        assert!(x.interval().width() <= 2.0 * f64::EPSILON * x.centre().high().abs(), "{text}");
    }
    assert_eq!(rational("3/8").1.error(), 0.0);
    let mut pi = PreciseModel::ZERO;
    pi.pi(&()).expect("known");
    // The first 50 digits.
    let digits: Rational =
        "31415926535897932384626433832795028841971693993751/10000000000000000000000000000000000000000000000000"
            .parse()
            .expect("a number");
    let number = |x: f64| Rational::try_from(x).expect("finite");
    let off = digits - number(pi.value().centre().high()) - number(pi.value().centre().low());
    assert!(off.to_f64().value().abs() < 0.9 * pi.value().error());
    // Sums of such numbers.
    let (a, b) = (rational("1/3"), rational("-1/7"));
    let sum = a.1.plus(&b.1);
    let off = (a.0 + b.0 - number(sum.centre().high()) - number(sum.centre().low())).to_f64().value();
    assert!(off.abs() <= sum.error() && sum.error() < 1e-28);
}

#[test]
fn domains_are_those_of_intervals() {
    let s = PreciseModel::variable(&Precise::new(DoubleDouble::ZERO, 0.0), 1.0);
    let mut out = PreciseModel::ZERO;
    assert_eq!(out.sqrt(&(), &s), Err(NoValue::Indeterminate));
    assert_eq!(out.div(&(), &s, &s), Err(NoValue::Indeterminate));
    assert_eq!(out.div(&(), &s, &PreciseModel::ZERO), Err(NoValue::OutOfDomain));
    assert_eq!(out.ln(&(), &s), Err(NoValue::Indeterminate));
    let huge = PreciseModel::of(&TaylorModel::constant(Interval::point(1e200)));
    assert_eq!(out.mul(&(), &huge, &huge), Err(NoValue::Indeterminate));
    assert!(out.exp(&(), &PreciseModel::of(&TaylorModel::constant(Interval::point(1e4)))).is_err());
}
