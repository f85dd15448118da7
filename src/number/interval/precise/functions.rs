//! Exponentials and waves, roots and powers of models of twice the precision: what [`Number`] asks for.

use super::{GROW, Precise, PreciseModel, TINY, faults};
use crate::double_double::PI;
use crate::{DoubleDouble, NoValue, Number, Op, Rational, Scalar};

impl PreciseModel {
    /// Σ uᵏ/k! over every order from `first` on in steps of `by`, with alternating signs if `by` is 2; |u| ≤ 1.
    fn exponential_series(u: &PreciseModel, first: usize, by: usize) -> Result<PreciseModel, NoValue> {
        let size = u.bound();
        // The last order, and at least the sum of the absolute values of the terms beyond it.
        let (mut last, mut left) = (first, 2.0);
        for k in 1..=first + 32 {
            left *= size / k as f64 * GROW;
            last = k;
            if left < 1e-36 && k > first {
                break;
            }
        }
        while !(last - first).is_multiple_of(by) {
            last += 1;
        }
        let (one, mut step) = (PreciseModel::point(1.0), *u);
        if by == 2 {
            step.product(u, u)?;
        }
        let mut sum = one;
        let mut k = last;
        while k > first {
            let mut next = PreciseModel::ZERO;
            next.product(&step, &sum)?;
            let over = if by == 2 { -((k * (k - 1)) as f64) } else { k as f64 };
            sum.combine(&one, &next.scaled(1.0, over), 1.0)?;
            k -= by;
        }
        if first == 1 {
            let mut all = PreciseModel::ZERO;
            all.product(u, &sum)?;
            sum = all;
        }
        Ok(sum.widened(if faults::no_lagrange() { 0.0 } else { left }))
    }

    /// sin u and cos u, for |u| ≤ 1.
    fn small_waves(u: &PreciseModel) -> Result<(PreciseModel, PreciseModel), NoValue> {
        Ok((PreciseModel::exponential_series(u, 1, 2)?, PreciseModel::exponential_series(u, 0, 2)?))
    }

    /// The model without its first coefficient, if all its values are then at most 1.
    fn without_first(&self) -> Option<PreciseModel> {
        let mut u = *self;
        (u.high[0], u.low[0]) = (0.0, 0.0);
        (u.bound() <= 1.0).then_some(u)
    }

    /// sin a and cos a; nothing where the less precise models do as well.
    fn waves(&self) -> Option<(PreciseModel, PreciseModel)> {
        let u = self.without_first()?;
        let turns = (self.high[0] / std::f64::consts::FRAC_PI_2).round();
        // Beyond, the error of π is no longer small.
        if turns.is_nan() || turns.abs() > 1e6 {
            return None;
        }
        let found = || -> Result<(PreciseModel, PreciseModel), NoValue> {
            let (mut quarter, mut turned, mut left) = (PreciseModel::ZERO, PreciseModel::ZERO, PreciseModel::ZERO);
            quarter.pi(&())?;
            turned.product(&quarter.scaled(0.5, 1.0), &PreciseModel::point(turns))?;
            left.combine(&PreciseModel::number(self.coefficient(0)), &turned, -1.0)?;
            let (s, c) = PreciseModel::small_waves(&left)?;
            let (s0, c0) = match (turns as i64).rem_euclid(4) {
                0 => (s, c),
                1 => (c, s.scaled(-1.0, 1.0)),
                2 => (s.scaled(-1.0, 1.0), c.scaled(-1.0, 1.0)),
                _ => (c.scaled(-1.0, 1.0), s),
            };
            let (su, cu) = PreciseModel::small_waves(&u)?;
            let mut sums = [PreciseModel::ZERO; 2];
            for (sum, (p, q, sign)) in sums.iter_mut().zip([(&s0, &c0, 1.0), (&c0, &s0, -1.0)]) {
                let (mut x, mut y) = (PreciseModel::ZERO, PreciseModel::ZERO);
                x.product(p, &cu)?;
                y.product(q, &su)?;
                sum.combine(&x, &y, sign)?;
            }
            Ok((sums[0], sums[1]))
        };
        found().ok()
    }

    /// exp a; nothing where the less precise models do as well.
    fn power_of_e(&self) -> Option<PreciseModel> {
        let u = self.without_first()?;
        let first = self.coefficient(0);
        if first.high().is_nan() || first.high().abs() > 300.0 {
            return None;
        }
        let mut halvings = 0;
        let mut factor = 1.0;
        while first.high().abs() * factor > 0.5 {
            factor *= 0.5;
            halvings += 1;
        }
        let found = || -> Result<PreciseModel, NoValue> {
            let mut power = PreciseModel::exponential_series(&PreciseModel::number(first).scaled(factor, 1.0), 0, 1)?;
            for _ in 0..halvings {
                let half = power;
                power.product(&half, &half)?;
            }
            let mut out = PreciseModel::ZERO;
            out.product(&power, &PreciseModel::exponential_series(&u, 0, 1)?)?;
            Ok(out)
        };
        found().ok()
    }

    /// (exp a ± exp(−a))/2; nothing where the less precise models do as well.
    fn half_sum_of_powers(&self, sign: f64) -> Option<PreciseModel> {
        let power = self.power_of_e()?;
        let (mut inverse, mut sum) = (PreciseModel::ZERO, PreciseModel::ZERO);
        inverse.quotient(&PreciseModel::point(1.0), &power).ok()?;
        sum.combine(&power, &inverse, sign).ok()?;
        Some(sum.scaled(0.5, 1.0))
    }

    /// What is better known: a result, or that of the less precise models.
    fn or_through(&mut self, found: Option<PreciseModel>, op: Op, a: &PreciseModel) -> Result<(), NoValue> {
        self.through(op, a, a)?;
        if let Some(found) = found.filter(|f| f.rest < self.rest) {
            *self = found;
        }
        Ok(())
    }
}

impl crate::Uniform for PreciseModel {
    type Context = ();

    fn blank(_: &()) -> PreciseModel {
        PreciseModel::ZERO
    }
    /// As the less precise models have it.
    fn rule(&mut self, _: &(), op: Op, a: &PreciseModel, b: &PreciseModel) -> Result<(), NoValue> {
        self.through(op, a, b)
    }
    fn rational(&mut self, _: &(), r: &Rational) -> Result<(), NoValue> {
        let exact = |x: f64| Rational::try_from(x).map_err(|_| NoValue::Indeterminate);
        let high = r.to_f64().value();
        let rest = r - exact(high)?;
        let low = rest.to_f64().value();
        let error = if exact(low)? == rest { 0.0 } else { 2.0 * f64::EPSILON * low.abs() + TINY };
        *self = PreciseModel::constant(&Precise::new(DoubleDouble::new(high, low), error));
        Ok(())
    }
    fn pi(&mut self, _: &()) -> Result<(), NoValue> {
        *self = PreciseModel::constant(&Precise::new(PI, 4e-33));
        Ok(())
    }
    fn restrict(&mut self, _: &(), a: &PreciseModel, _: &PreciseModel) -> Result<(), NoValue> {
        self.clone_from(a);
        Ok(())
    }
    fn powi(&mut self, _: &(), a: &PreciseModel, n: i32) -> Result<(), NoValue> {
        let (one, mut left, mut base) = (PreciseModel::point(1.0), n.unsigned_abs(), *a);
        if n < 0 {
            base.quotient(&one, a)?;
        }
        let mut power: Option<PreciseModel> = None;
        while left > 0 {
            if left % 2 == 1 {
                let mut next = base;
                if let Some(p) = power {
                    next.product(&p, &base)?;
                }
                power = Some(next);
            }
            left /= 2;
            if left > 0 {
                let root = base;
                base.product(&root, &root)?;
            }
        }
        *self = power.unwrap_or(one);
        Ok(())
    }
    fn neg(&mut self, _: &(), a: &PreciseModel) -> Result<(), NoValue> {
        *self = *a;
        self.high.iter_mut().chain(&mut self.low).for_each(|c| *c = -*c);
        Ok(())
    }
    fn sqrt(&mut self, _: &(), a: &PreciseModel) -> Result<(), NoValue> {
        self.root(a)
    }
    fn exp(&mut self, _: &(), a: &PreciseModel) -> Result<(), NoValue> {
        self.or_through(a.power_of_e(), Op::Exp, a)
    }
    fn sin(&mut self, _: &(), a: &PreciseModel) -> Result<(), NoValue> {
        self.or_through(a.waves().map(|w| w.0), Op::Sin, a)
    }
    fn cos(&mut self, _: &(), a: &PreciseModel) -> Result<(), NoValue> {
        self.or_through(a.waves().map(|w| w.1), Op::Cos, a)
    }
    fn tan(&mut self, _: &(), a: &PreciseModel) -> Result<(), NoValue> {
        let found = a.waves().and_then(|(s, c)| {
            let mut out = PreciseModel::ZERO;
            out.quotient(&s, &c).ok().map(|()| out)
        });
        self.or_through(found, Op::Tan, a)
    }
    fn sinh(&mut self, _: &(), a: &PreciseModel) -> Result<(), NoValue> {
        self.or_through(a.half_sum_of_powers(-1.0), Op::Sinh, a)
    }
    fn cosh(&mut self, _: &(), a: &PreciseModel) -> Result<(), NoValue> {
        self.or_through(a.half_sum_of_powers(1.0), Op::Cosh, a)
    }
    fn abs(&mut self, cx: &(), a: &PreciseModel) -> Result<(), NoValue> {
        let over = a.rounded().range();
        if over.lo() >= 0.0 {
            *self = *a;
            return Ok(());
        }
        if over.hi() <= 0.0 {
            return Number::neg(self, cx, a);
        }
        self.through(Op::Abs, a, a)
    }
    fn add(&mut self, _: &(), a: &PreciseModel, b: &PreciseModel) -> Result<(), NoValue> {
        self.combine(a, b, 1.0)
    }
    fn sub(&mut self, _: &(), a: &PreciseModel, b: &PreciseModel) -> Result<(), NoValue> {
        self.combine(a, b, -1.0)
    }
    fn mul(&mut self, _: &(), a: &PreciseModel, b: &PreciseModel) -> Result<(), NoValue> {
        self.product(a, b)
    }
    fn div(&mut self, _: &(), a: &PreciseModel, b: &PreciseModel) -> Result<(), NoValue> {
        self.quotient(a, b)
    }
    fn direction_cosine(&mut self, _: &(), a: &PreciseModel, b: &PreciseModel) -> Result<(), NoValue> {
        self.through(Op::DirectionCosine, a, b)?;
        let s = a.rounded().range().magnitude().scale(b.rounded().range().magnitude());
        let (x, y) = (a.scaled(s, 1.0), b.scaled(s, 1.0));
        let found = || -> Result<PreciseModel, NoValue> {
            let [mut square, mut other, mut sum, mut radius, mut cosine] = [PreciseModel::ZERO; 5];
            square.product(&x, &x)?;
            other.product(&y, &y)?;
            sum.combine(&square, &other, 1.0)?;
            radius.root(&sum)?;
            cosine.quotient(&x, &radius)?;
            Ok(cosine)
        };
        if let Some(found) = found().ok().filter(|f| f.rest < self.rest) {
            *self = found;
        }
        Ok(())
    }
    fn pow(&mut self, cx: &(), a: &PreciseModel, b: &PreciseModel) -> Result<(), NoValue> {
        self.through(Op::Pow, a, b)?;
        // Powers of roots.
        let halves = 2.0 * b.high[0];
        let known = b.length == 1 && b.rest == 0.0 && b.low[0] == 0.0;
        if known && halves.abs() <= 64.0 && halves == halves.round() {
            let (mut root, mut power) = (PreciseModel::ZERO, PreciseModel::ZERO);
            let found = root.root(a).and_then(|()| Number::powi(&mut power, cx, &root, halves as i32));
            if found.is_ok() && power.rest < self.rest {
                *self = power;
            }
        }
        Ok(())
    }
}
