//! Models contain what they should, and the comparison that says so notices every mistake they could rest on.

use super::faults::{NEAREST, NO_LAGRANGE, NO_TAIL};
use super::model::TaylorModel;
use super::{Interval, Scalar};
use crate::{Draws, NoValue, Number, Op, Rational};

fn unit(draws: &mut Draws) -> f64 {
    (draws.bits() >> 11) as f64 / (1_u64 << 53) as f64
}

/// From −1 to 1.
fn signed(draws: &mut Draws) -> f64 {
    2.0 * unit(draws) - 1.0
}

/// A polynomial around a centre, and how far a quantity may be away from it.
struct Quantity {
    coefficients: Vec<f64>,
    rest: f64,
}

impl Quantity {
    fn random(draws: &mut Draws, centre: f64, spread: f64, rest: f64) -> Quantity {
        let mut coefficients = vec![centre];
        let (count, mut size) = (draws.bits() % 15, spread);
        for _ in 0..count {
            coefficients.push(size * signed(draws));
            size *= 0.6;
        }
        Quantity { coefficients, rest }
    }

    /// Made of sums and products of models, so that what is tested makes its own input.
    fn model(&self) -> TaylorModel {
        let s = TaylorModel::variable(Interval::ZERO, 1.0);
        let mut sum = TaylorModel::ZERO;
        for &c in self.coefficients.iter().rev() {
            let mut product = TaylorModel::ZERO;
            product.mul(&(), &sum, &s).expect("finite");
            sum.add(&(), &product, &TaylorModel::constant(Interval::point(c))).expect("finite");
        }
        let wide = sum;
        sum.add(&(), &wide, &TaylorModel::constant(Interval::ball(0.0, self.rest))).expect("finite");
        sum
    }

    /// Exactly, with the part `of` of the rest.
    fn exact(&self, s: f64, of: f64) -> Rational {
        let number = |x: f64| Rational::try_from(x).expect("finite");
        let sum = self.coefficients.iter().rev().fold(Rational::ZERO, |sum, &c| sum * number(s) + number(c));
        sum + number(self.rest) * number(of)
    }

    fn at(&self, s: f64, of: f64) -> Interval {
        let point = Interval::point;
        let sum = self.coefficients.iter().rev().fold(Interval::ZERO, |sum, &c| sum * point(s) + point(c));
        sum + point(self.rest) * point(of)
    }
}

/// Whether a rational number lies in an interval.
fn inside(x: &Rational, of: Interval) -> bool {
    let number = |x: f64| Rational::try_from(x).expect("finite");
    number(of.lo()) <= *x && *x <= number(of.hi())
}

/// How often + − × ÷ of models miss the exact result, and how many were compared.
fn misses_of_arithmetic() -> (usize, usize) {
    let (mut draws, mut missed, mut compared) = (Draws::new(3), 0, 0);
    for round in 0..600 {
        let rest = if round % 3 == 0 { 0.01 * unit(&mut draws) } else { 0.0 };
        let spread = if round % 2 == 0 { 1.0 } else { 1e-3 };
        let (x, y) = (signed(&mut draws), 3.0 + unit(&mut draws));
        let a = Quantity::random(&mut draws, x, spread, rest);
        let b = Quantity::random(&mut draws, y, spread, rest);
        let (p, q) = (a.model(), b.model());
        for op in [Op::Add, Op::Sub, Op::Mul, Op::Div] {
            let mut model = TaylorModel::ZERO;
            if op.apply(&(), &mut model, &p, &q).is_err() {
                continue;
            }
            for _ in 0..4 {
                let (s, of) = (signed(&mut draws), signed(&mut draws));
                let (x, y) = (a.exact(s, of), b.exact(s, -of));
                let truth = match op {
                    Op::Add => x + y,
                    Op::Sub => x - y,
                    Op::Mul => x * y,
                    _ => x / y,
                };
                compared += 1;
                let fits = inside(&truth, model.range()) && inside(&truth, model.at(Interval::point(s)));
                missed += usize::from(!fits);
            }
        }
    }
    (missed, compared)
}

/// How often functions of models miss the result at a point, by more than its own bounds; and how many were compared, and
/// how many of the models say more than that the result lies in a range.
fn misses_of_functions() -> (usize, usize, usize) {
    let (mut draws, mut missed, mut compared, mut sharp) = (Draws::new(5), 0, 0, 0);
    for &op in Op::EVERY {
        for round in 0..150 {
            let rest = if round % 3 == 0 { 1e-3 * unit(&mut draws) } else { 0.0 };
            let spread = if round % 2 == 0 { 0.5 } else { 0.05 };
            let centre = match op {
                Op::Arcsin | Op::Arccos => 0.9 * signed(&mut draws),
                Op::Sqrt | Op::Ln | Op::Pow | Op::Agm => 0.5 + 2.0 * unit(&mut draws),
                _ => 3.0 * signed(&mut draws),
            };
            let a = Quantity::random(&mut draws, centre, spread, rest);
            let other = if op == Op::Arctan2 { -1.0 } else { 1.5 + unit(&mut draws) };
            let mut b = Quantity::random(&mut draws, other, spread, rest);
            if round % 5 == 0 {
                b = Quantity { coefficients: vec![1.25], rest: 0.0 };
            }
            let mut model = TaylorModel::ZERO;
            if op.apply(&(), &mut model, &a.model(), &b.model()).is_err() {
                continue;
            }
            sharp += usize::from(model.remainder() < 0.5 * model.range().width());
            for _ in 0..6 {
                let (s, of) = (signed(&mut draws), signed(&mut draws));
                let mut truth = Interval::ZERO;
                op.apply(&(), &mut truth, &a.at(s, of), &b.at(s, -of)).expect("the model has a value everywhere");
                compared += 1;
                let found = model.at(Interval::point(s));
                missed +=
                    usize::from(found.intersection(truth).is_none() || model.range().intersection(truth).is_none());
            }
        }
    }
    (missed, compared, sharp)
}

#[test]
fn sums_and_products_contain_exact_results() {
    let (missed, compared) = misses_of_arithmetic();
    assert!(missed == 0 && compared > 5_000, "{missed} of {compared}");
}

#[test]
fn functions_contain_results() {
    let (missed, compared, sharp) = misses_of_functions();
    assert!(missed == 0 && compared > 10_000 && sharp > 1_500, "{missed} of {compared}, {sharp} sharp");
}

#[test]
fn rounding_to_nearest_is_noticed() {
    NEAREST.set(true);
    let (missed, _) = misses_of_arithmetic();
    NEAREST.set(false);
    assert!(missed > 50, "{missed}");
}

#[test]
fn lost_terms_of_products_are_noticed() {
    NO_TAIL.set(true);
    let ((missed, _), (functions, _, _)) = (misses_of_arithmetic(), misses_of_functions());
    NO_TAIL.set(false);
    assert!(missed > 50 && functions > 50, "{missed} {functions}");
}

#[test]
fn lost_remainders_of_functions_are_noticed() {
    NO_LAGRANGE.set(true);
    let (missed, _, _) = misses_of_functions();
    NO_LAGRANGE.set(false);
    assert!(missed > 20, "{missed}");
}

/// A value that exists only on a part is refused, and a box outside of the domain is told from one that may be outside.
#[test]
fn domains_are_those_of_intervals() {
    let s = TaylorModel::variable(Interval::ZERO, 1.0);
    let shifted = |by: f64| {
        let mut sum = TaylorModel::ZERO;
        sum.add(&(), &s, &TaylorModel::constant(Interval::point(by))).expect("finite");
        sum
    };
    let mut out = TaylorModel::ZERO;
    assert_eq!(out.sqrt(&(), &s), Err(NoValue::Indeterminate));
    assert_eq!(out.sqrt(&(), &shifted(-2.0)), Err(NoValue::OutOfDomain));
    assert_eq!(out.ln(&(), &shifted(1.0)), Err(NoValue::Indeterminate));
    assert_eq!(out.div(&(), &shifted(3.0), &s), Err(NoValue::Indeterminate));
    assert_eq!(out.arccos(&(), &shifted(3.0)), Err(NoValue::OutOfDomain));
    // (x, y) = (−1, s) meets the cut.
    assert_eq!(out.arctan2(&(), &s, &TaylorModel::constant(Interval::point(-1.0))), Err(NoValue::Indeterminate));
    // Next to a branch point there is a value, and hardly a polynomial.
    assert!(out.sqrt(&(), &shifted(1.0 + 1e-9)).is_ok());
    assert!(out.range().lo() < 1e-4 && out.range().hi() >= 2.0_f64.sqrt());
    // A huge number is refused, not passed on.
    let huge = TaylorModel::constant(Interval::point(1e200));
    assert_eq!(out.mul(&(), &huge, &huge), Err(NoValue::Indeterminate));
}
