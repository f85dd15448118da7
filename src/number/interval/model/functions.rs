//! The operations on models: of each, a model, or bounds where these are narrower. The theorems are those of the module above.

use super::super::{Continuity, Interval, faults};
use super::{GROW, ROOM, TINY, TaylorModel, unit};
use crate::{Jet, NoValue, Number, Op, Orders, Rational, Scalar};

impl TaylorModel {
    /// The value over all arguments, as bounds alone.
    fn plain(&mut self, range: Result<Interval, NoValue>) -> Result<(), NoValue> {
        *self = TaylorModel::constant(range?);
        if self.rest < f64::MAX { Ok(()) } else { Err(NoValue::Indeterminate) }
    }

    /// What is better known: the model, or bounds.
    fn or_plain(&mut self, found: Option<TaylorModel>, range: Interval) -> Result<(), NoValue> {
        match found {
            Some(model) if model.rest < range.radius() => {
                *self = model;
                Ok(())
            }
            _ => self.plain(Ok(range)),
        }
    }

    /// A function of one argument, and perhaps of a number; `first` says that the number comes first.
    fn function(&mut self, op: Op, a: &TaylorModel, number: Option<(f64, bool)>) -> Result<(), NoValue> {
        fn apply<N: Number>(op: Op, cx: &N::Context, a: &N, number: Option<(N, bool)>) -> Result<N, NoValue> {
            let mut out = N::blank(cx);
            match &number {
                None => op.apply(cx, &mut out, a, a),
                Some((n, true)) => op.apply(cx, &mut out, n, a),
                Some((n, false)) => op.apply(cx, &mut out, a, n),
            }
            .map(|()| out)
        }
        let over = a.range();
        let range = apply(op, &(), &over, number.map(|(n, first)| (Interval::point(n), first)))?;
        if a.is_point() {
            return self.plain(Ok(range));
        }
        let centre = Interval::point(a.coefficients[0]);
        let series = |at: Interval, degree: usize| {
            let orders = Orders::all(degree);
            let number = number.map(|(n, first)| (Jet::constant(Interval::point(n), &orders), first));
            apply(op, &orders, &Jet::variable(at, Interval::point(1.0), &orders), number).ok()
        };
        // The values and the first coefficient: all that lies between is among the arguments of f.
        let all = over.hull(centre);
        let spread = a.spread();
        let found = series(all, ROOM).and_then(|wide| {
            // The first order whose remainder is too small to matter, or the last.
            let size = range.magnitude().max(wide.coefficient(1).magnitude() * spread);
            let mut power = spread;
            let mut order = 0;
            while order + 1 < ROOM && wide.coefficient(order + 1).magnitude() * power > 1e-18 * size {
                order += 1;
                power *= spread;
            }
            let narrow = series(centre, order)?;
            let mut u = *a;
            u.coefficients[0] = 0.0;
            let mut sum = TaylorModel::constant(narrow.coefficient(order));
            for k in (0..order).rev() {
                let mut next = TaylorModel::ZERO;
                next.product(&sum, &u).ok()?;
                sum.combine(&next, &TaylorModel::constant(narrow.coefficient(k)), |x, y| x + y).ok()?;
            }
            if !faults::no_lagrange() {
                sum.rest = (sum.rest + wide.coefficient(order + 1).magnitude() * power) * GROW;
            }
            Some(sum)
        });
        self.or_plain(found, range)
    }

    fn quotient(&mut self, a: &TaylorModel, b: &TaylorModel) -> Result<(), NoValue> {
        if b.is_point() {
            let b = b.coefficients[0];
            if b == 0.0 {
                return Err(NoValue::OutOfDomain);
            }
            if a.is_zero() {
                *self = TaylorModel::ZERO;
                return Ok(());
            }
            let mut size = 0.0;
            for k in 0..ROOM {
                let c = a.coefficients[k] / b;
                self.coefficients[k] = c;
                size += c.abs();
            }
            self.length = a.length;
            self.rest = a.rest / b.abs() + unit() * size + TINY;
            return self.finish(size);
        }
        let over = b.range();
        let mut range = Interval::ZERO;
        range.div(&(), &a.range(), &over)?;
        let mut guess = TaylorModel::ZERO;
        for k in 0..ROOM {
            let known: f64 = (1..=k).map(|j| b.coefficients[j] * guess.coefficients[k - j]).sum();
            guess.coefficients[k] = (a.coefficients[k] - known) / b.coefficients[0];
        }
        guess.length = ROOM;
        let found = guess.corrected(|guess| {
            let (mut back, mut defect) = (TaylorModel::ZERO, TaylorModel::ZERO);
            back.product(guess, b)?;
            defect.combine(a, &back, |x, y| x - y)?;
            Ok((defect, over.mignitude()))
        });
        self.or_plain(found, range)
    }

    /// A guess whose error is a defect divided by something of at least a certain size.
    fn corrected(
        mut self,
        defect: impl Fn(&TaylorModel) -> Result<(TaylorModel, f64), NoValue>,
    ) -> Option<TaylorModel> {
        self.finish(self.norm(0)).ok()?;
        // What `finish` has left out of the polynomial is part of the guess no more, and of its defect.
        self.rest = 0.0;
        let (defect, least) = defect(&self).ok().filter(|d| d.1 > 0.0)?;
        self.rest = (defect.norm(0) + defect.rest) * GROW / least * GROW + TINY;
        Some(self)
    }

    fn root(&mut self, a: &TaylorModel) -> Result<(), NoValue> {
        let over = a.range();
        let mut range = Interval::ZERO;
        range.sqrt(&(), &over)?;
        let first = a.coefficients[0].sqrt();
        if a.is_point() || first.is_nan() || first == 0.0 {
            return self.plain(Ok(range));
        }
        let mut guess = TaylorModel::ZERO;
        guess.coefficients[0] = first;
        for k in 1..ROOM {
            let known: f64 = (1..k).map(|j| guess.coefficients[j] * guess.coefficients[k - j]).sum();
            guess.coefficients[k] = (a.coefficients[k] - known) / (2.0 * first);
        }
        guess.length = ROOM;
        let found = guess.corrected(|guess| {
            let (mut square, mut defect) = (TaylorModel::ZERO, TaylorModel::ZERO);
            square.product(guess, guess)?;
            defect.combine(a, &square, |x, y| x - y)?;
            Ok((defect, (range + guess.range()).lo()))
        });
        self.or_plain(found, range)
    }
}

impl crate::Uniform for TaylorModel {
    type Context = ();

    fn blank(_: &()) -> TaylorModel {
        TaylorModel::ZERO
    }
    /// By the remainder of Taylor's theorem; of two arguments that both move, bounds alone.
    fn rule(&mut self, _: &(), op: Op, a: &TaylorModel, b: &TaylorModel) -> Result<(), NoValue> {
        if op.arity() == 1 {
            return self.function(op, a, None);
        }
        if b.is_point() {
            return self.function(op, a, Some((b.coefficients[0], false)));
        }
        if a.is_point() {
            return self.function(op, b, Some((a.coefficients[0], true)));
        }
        let mut range = Interval::ZERO;
        op.apply(&(), &mut range, &a.range(), &b.range())?;
        self.plain(Ok(range))
    }
    fn rational(&mut self, _: &(), r: &Rational) -> Result<(), NoValue> {
        let mut value = Interval::ZERO;
        let found = value.rational(&(), r);
        self.plain(found.map(|()| value))
    }
    fn pi(&mut self, _: &()) -> Result<(), NoValue> {
        let mut value = Interval::ZERO;
        let found = value.pi(&());
        self.plain(found.map(|()| value))
    }
    fn restrict(&mut self, _: &(), a: &TaylorModel, _: &TaylorModel) -> Result<(), NoValue> {
        self.clone_from(a);
        Ok(())
    }
    fn powi(&mut self, _: &(), a: &TaylorModel, n: i32) -> Result<(), NoValue> {
        let one = TaylorModel::constant(Interval::point(1.0));
        let (mut left, mut base) = (n.unsigned_abs(), *a);
        if n < 0 {
            base.quotient(&one, a)?;
        }
        let mut power: Option<TaylorModel> = None;
        while left > 0 {
            if left % 2 == 1 {
                power = Some(match power {
                    None => base,
                    Some(p) => {
                        let mut next = TaylorModel::ZERO;
                        next.product(&p, &base)?;
                        next
                    }
                });
            }
            left /= 2;
            if left > 0 {
                let mut next = TaylorModel::ZERO;
                next.product(&base, &base)?;
                base = next;
            }
        }
        *self = power.unwrap_or(one);
        Ok(())
    }
    fn neg(&mut self, _: &(), a: &TaylorModel) -> Result<(), NoValue> {
        *self = *a;
        self.coefficients.iter_mut().for_each(|c| *c = -*c);
        Ok(())
    }
    fn sqrt(&mut self, _: &(), a: &TaylorModel) -> Result<(), NoValue> {
        self.root(a)
    }
    fn abs(&mut self, cx: &(), a: &TaylorModel) -> Result<(), NoValue> {
        let over = a.range();
        if over.lo >= 0.0 {
            *self = *a;
            return Ok(());
        }
        if over.hi <= 0.0 {
            return Number::neg(self, cx, a);
        }
        let mut range = Interval::ZERO;
        range.abs(&(), &over)?;
        self.plain(Ok(range))
    }
    fn add(&mut self, _: &(), a: &TaylorModel, b: &TaylorModel) -> Result<(), NoValue> {
        self.combine(a, b, |x, y| x + y)
    }
    fn sub(&mut self, _: &(), a: &TaylorModel, b: &TaylorModel) -> Result<(), NoValue> {
        self.combine(a, b, |x, y| x - y)
    }
    fn mul(&mut self, _: &(), a: &TaylorModel, b: &TaylorModel) -> Result<(), NoValue> {
        self.product(a, b)
    }
    fn div(&mut self, _: &(), a: &TaylorModel, b: &TaylorModel) -> Result<(), NoValue> {
        self.quotient(a, b)
    }
    fn pow(&mut self, _: &(), a: &TaylorModel, b: &TaylorModel) -> Result<(), NoValue> {
        if b.is_point() {
            return self.function(Op::Pow, a, Some((b.coefficients[0], false)));
        }
        if a.is_point() {
            return self.function(Op::Pow, b, Some((a.coefficients[0], true)));
        }
        let (mut range, over) = (Interval::ZERO, a.range());
        range.pow(&(), &over, &b.range())?;
        if over.lo <= 0.0 {
            return self.plain(Ok(range));
        }
        let (mut logarithm, mut exponent, mut power) = (TaylorModel::ZERO, TaylorModel::ZERO, TaylorModel::ZERO);
        let found = logarithm.function(Op::Ln, a, None).and_then(|()| exponent.product(b, &logarithm));
        let found = found.and_then(|()| power.function(Op::Exp, &exponent, None)).ok().map(|()| power);
        self.or_plain(found, range)
    }
    fn arctan2(&mut self, _: &(), y: &TaylorModel, x: &TaylorModel) -> Result<(), NoValue> {
        let range = match Interval::principal_angle(y.range(), x.range())? {
            (angle, Continuity::Everywhere) => angle,
            (_, Continuity::Broken) => return Err(NoValue::Indeterminate),
        };
        if y.is_point() && x.is_point() {
            return self.plain(Ok(range));
        }
        let (y0, x0) = (y.coefficients[0], x.coefficients[0]);
        let turned = || -> Result<TaylorModel, NoValue> {
            let mut terms = [TaylorModel::ZERO; 4];
            for (term, (number, model)) in terms.iter_mut().zip([(x0, x), (y0, y), (x0, y), (y0, x)]) {
                term.scaled(number, model)?;
            }
            let (mut along, mut across) = (TaylorModel::ZERO, TaylorModel::ZERO);
            along.combine(&terms[0], &terms[1], |x, y| x + y)?;
            across.combine(&terms[2], &terms[3], |x, y| x - y)?;
            if along.range().lo <= 0.0 {
                return Err(NoValue::Indeterminate);
            }
            let (mut ratio, mut angle, mut sum) = (TaylorModel::ZERO, TaylorModel::ZERO, TaylorModel::ZERO);
            ratio.quotient(&across, &along)?;
            angle.function(Op::Arctan, &ratio, None)?;
            // The first coefficients are values at s = 0 of contained quantities, so that the cut is not met there either.
            let mut first = Interval::ZERO;
            first.arctan2(&(), &Interval::point(y0), &Interval::point(x0))?;
            sum.combine(&angle, &TaylorModel::constant(first), |x, y| x + y)?;
            Ok(sum)
        };
        self.or_plain(turned().ok(), range)
    }
    /// a/√(a² + b²), times a power of two above and below.
    fn direction_cosine(&mut self, cx: &(), a: &TaylorModel, b: &TaylorModel) -> Result<(), NoValue> {
        let mut range = Interval::ZERO;
        range.direction_cosine(cx, &a.range(), &b.range())?;
        if a.is_point() && b.is_point() {
            return self.plain(Ok(range));
        }
        let s = a.range().magnitude().scale(b.range().magnitude());
        let found = || -> Result<TaylorModel, NoValue> {
            let [mut x, mut y, mut square, mut sum, mut radius, mut cosine] = [TaylorModel::ZERO; 6];
            x.scaled(s, a)?;
            y.scaled(s, b)?;
            square.product(&x, &x)?;
            sum.product(&y, &y)?;
            let other = sum;
            sum.combine(&square, &other, |x, y| x + y)?;
            radius.root(&sum)?;
            cosine.quotient(&x, &radius)?;
            Ok(cosine)
        };
        self.or_plain(found().ok(), range)
    }
}
