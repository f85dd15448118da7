//! Taylor models with coefficients of twice the precision of binary64.
//!
//! **In:** models that contain the arguments. **Out:** a model that contains the result, in the sense of
//! [`TaylorModel`]: a quantity q(s), −1 ≤ s ≤ 1, is *contained* in a model (c, r) if |q(s) − Σₖ cₖsᵏ| ≤ r for all s. Here
//! the cₖ are sums of two binary64 numbers, and the remainders of sums and products are near 10⁻²⁹ instead of 10⁻¹⁶.
//!
//! **Guaranteed:** as for [`TaylorModel`]. Operations without a more precise form (see below) are those of `TaylorModel`,
//! with its remainders.
//!
//! **Why:** how far a polynomial is from a motion is the difference of two nearly equal quantities. In binary64 that is no
//! less than a rounding at every step, however good the polynomial is, and a motion near a separatrix amplifies each of them a
//! million times. The same holds for decimal constants.
//!
//! **Theorems.** Sums, products, quotients and roots as in [`TaylorModel`]. sin(c + u) = sin c · cos u + cos c · sin u and
//! exp(c + u) = exp c · exp u (and sinh and cosh from it), with the Taylor series of sin u, cos u, exp u and Lagrange's remainder; c itself is first made
//! small by half turns (π is known to 3·10⁻³³) or by halving (and squaring).
//!
//! **Rounding.** Every coefficient satisfies |low| ≤ u|high|, u = 2⁻⁵³, since it comes from an error-free sum. A sum of
//! N ≤ 28 products (x + x′)(y + y′) is formed like this: the product p of the first numbers and its error e are exact
//! ([Dekker 1971]); p is added to s with the exact error t ([Knuth 1969, §4.2.2]); t + (e + (xy′ + x′y)) is added to c, to
//! nearest. What is lost is x′y′ ≤ u²|xy|, and at most N + 4 roundings of each of the small terms, whose absolute values
//! add up to at most (N + 3)u·Σ|xy|: together less than ((N + 4)(N + 3)·1.01 + 1)u²·Σ|xy| < 2⁻⁹⁶·Σ|xy| (this is the
//! argument of [Ogita, Rump & Oishi 2005, Prop. 5.5]). Sums and quotients by numbers lose at most 12u² of their terms.
//! `ROUND` is more than each of these.
//!
//! [Dekker 1971]: https://doi.org/10.1007/BF01397083
//! [Knuth 1969, §4.2.2]: https://www-cs-faculty.stanford.edu/~knuth/taocp.html
//! [Ogita, Rump & Oishi 2005, Prop. 5.5]: https://doi.org/10.1137/030601818

mod functions;
#[cfg(test)]
mod tests;

use super::model::{MOST_TERMS, POWERS};
use super::{Interval, TaylorModel, faults};
use crate::double_double::{two_product, two_sum};
use crate::{DoubleDouble, NoValue, Number, Op, Scalar};

/// Number of coefficients.
const ROOM: usize = 23;
/// More than what is lost in a sum of up to 28 products, as a part of the sum of their sizes: 2⁻⁹⁵.
const ROUND: f64 = 2.524_354_896_707_238e-29;
/// Bounds are sums of fewer than 200 terms that are not negative; rounded to nearest, times this, they are not too small.
/// It also covers the second numbers of coefficients whose first numbers are added up.
const GROW: f64 = 1.0 + 256.0 * f64::EPSILON;
/// More than what underflow may lose in one operation.
const TINY: f64 = 1e-290;
/// Last coefficients below this part of the sum of all are added to the remainder: they would only cost time.
const NEGLIGIBLE: f64 = 1e-28;

/// ROUND, or nothing in tests of what happens without.
#[inline(always)]
fn unit() -> f64 {
    if faults::nearest() || faults::exact_pairs() { 0.0 } else { ROUND }
}

/// All numbers within a distance of a sum of two binary64 numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Precise {
    centre: DoubleDouble,
    error: f64,
}

impl Precise {
    /// The numbers within `error` of `centre`.
    pub const fn new(centre: DoubleDouble, error: f64) -> Precise {
        Precise { centre, error }
    }

    /// The number that is known.
    pub fn centre(&self) -> DoubleDouble {
        self.centre
    }

    /// How far the others may be from it.
    pub fn error(&self) -> f64 {
        self.error
    }

    /// The numbers of an interval.
    pub fn enclosing(interval: Interval) -> Precise {
        Precise { centre: DoubleDouble::point(interval.mid()), error: interval.radius() }
    }

    /// An interval that contains the numbers.
    pub fn interval(&self) -> Interval {
        Interval::point(self.centre.high()) + Interval::ball(self.centre.low(), self.error)
    }

    /// All sums with the numbers of another.
    pub fn plus(&self, other: &Precise) -> Precise {
        let centre = self.centre + other.centre;
        let rounding = unit() * (self.centre.high().abs() + other.centre.high().abs());
        Precise { centre, error: (self.error + other.error + rounding) * GROW }
    }

    /// The centre alone, and what is then left of the numbers.
    pub fn split(&self) -> (DoubleDouble, Interval) {
        (self.centre, Interval::ball(0.0, self.error))
    }
}

/// See the module.
#[derive(Clone, Copy, Debug)]
pub struct PreciseModel {
    /// Those from `length` on are 0.
    high: [f64; ROOM],
    low: [f64; ROOM],
    rest: f64,
    /// At least 1.
    length: usize,
}

impl PreciseModel {
    /// Degree of the polynomials.
    pub const DEGREE: usize = ROOM - 1;

    /// 0, exactly.
    pub const ZERO: PreciseModel = PreciseModel { high: [0.0; ROOM], low: [0.0; ROOM], rest: 0.0, length: 1 };

    /// A quantity of which only a centre and a distance from it are known.
    pub fn constant(value: &Precise) -> PreciseModel {
        let mut new = PreciseModel::ZERO;
        (new.high[0], new.low[0]) = (value.centre.high(), value.centre.low());
        new.rest = value.error;
        new
    }

    fn number(x: DoubleDouble) -> PreciseModel {
        PreciseModel::constant(&Precise::new(x, 0.0))
    }

    fn point(x: f64) -> PreciseModel {
        PreciseModel::number(DoubleDouble::point(x))
    }

    /// m + h·s for all m of a ball.
    pub fn variable(middle: &Precise, half: f64) -> PreciseModel {
        let mut new = PreciseModel::constant(middle);
        new.high[1] = half;
        new.length = 2;
        new
    }

    /// A model that contains what another one does.
    pub fn of(model: &TaylorModel) -> PreciseModel {
        let mut new = PreciseModel::ZERO;
        let known = model.coefficients();
        new.high[..known.len()].copy_from_slice(known);
        new.length = known.len();
        new.rest = model.remainder();
        new
    }

    /// The same quantities with the precision of binary64.
    pub fn rounded(&self) -> TaylorModel {
        let left: f64 = self.low.iter().map(|x| x.abs()).sum();
        let left = if faults::lost_low() { 0.0 } else { left };
        TaylorModel::from_parts(self.high[..self.length].iter().copied(), (self.rest + left) * GROW)
    }

    /// Coefficients and remainder.
    #[cfg(test)]
    pub(super) fn parts(&self) -> (Vec<DoubleDouble>, f64) {
        ((0..self.length).map(|k| self.coefficient(k)).collect(), self.rest)
    }

    /// What it contains, when that does not depend on s.
    pub fn value(&self) -> Precise {
        let rest = (self.norm(1) + self.rest) * GROW;
        Precise::new(DoubleDouble::new(self.high[0], self.low[0]), rest)
    }

    #[inline(always)]
    fn coefficient(&self, k: usize) -> DoubleDouble {
        DoubleDouble::new(self.high[k], self.low[k])
    }

    #[inline(always)]
    fn is_zero(&self) -> bool {
        self.length == 1 && self.rest == 0.0 && self.high[0] == 0.0
    }

    /// Σ|cₖ|, from order `from` on, to nearest and without the second numbers.
    #[inline(always)]
    fn norm(&self, from: usize) -> f64 {
        self.high[from..].iter().map(|c| c.abs()).sum()
    }

    /// At least the size of all values.
    pub fn bound(&self) -> f64 {
        (self.norm(0) + self.rest) * GROW
    }

    /// What lies within a distance of what is contained.
    fn widened(mut self, by: f64) -> PreciseModel {
        self.rest = (self.rest + by) * GROW;
        self
    }

    /// A polynomial without a remainder, close to Σₖ cₖ·σᵏ for σ from 0 to h, where s = −1 is σ = 0. How close is not said.
    /// At most 28 coefficients are taken.
    ///
    /// # Errors
    /// [`NoValue::Indeterminate`] when a coefficient is not finite, or there are too many.
    pub fn close_to(coefficients: &[DoubleDouble], h: f64) -> Result<PreciseModel, NoValue> {
        if coefficients.len() > MOST_TERMS + 1 {
            return Err(NoValue::Indeterminate);
        }
        let mut scaled = [DoubleDouble::ZERO; MOST_TERMS + 1];
        let (mut power, length) = (DoubleDouble::point(1.0), DoubleDouble::point(h));
        for (d, &c) in scaled.iter_mut().zip(coefficients) {
            *d = c * power;
            power = power * length;
        }
        let mut new = PreciseModel::ZERO;
        let mut small = [0.0; ROOM];
        for (d, weights) in scaled.iter().zip(&POWERS).rev() {
            for ((sum, left), &w) in new.high.iter_mut().zip(&mut small).zip(weights) {
                let (p, e) = two_product(d.high(), w);
                let (s, t) = two_sum(*sum, p);
                *sum = s;
                *left += t + (e + d.low() * w);
            }
        }
        new.length = ROOM;
        new.settle(&small);
        new.finish()?;
        new.rest = 0.0;
        Ok(new)
    }

    /// Adds second numbers to sums, without error.
    #[inline(always)]
    fn settle(&mut self, small: &[f64; ROOM]) {
        for ((high, low), &x) in self.high.iter_mut().zip(&mut self.low).zip(small) {
            (*high, *low) = two_sum(*high, x);
        }
    }

    /// Checks, and leaves out what is negligible.
    #[inline(always)]
    fn finish(&mut self) -> Result<(), NoValue> {
        let size = self.norm(0);
        while self.length > 1 && self.high[self.length - 1].abs() <= NEGLIGIBLE * size {
            self.length -= 1;
            self.rest += self.high[self.length].abs();
            (self.high[self.length], self.low[self.length]) = (0.0, 0.0);
        }
        self.rest *= GROW;
        // Second numbers that are not finite make the first so.
        if self.rest + size < f64::MAX { Ok(()) } else { Err(NoValue::Indeterminate) }
    }

    #[inline(always)]
    fn combine(&mut self, a: &PreciseModel, b: &PreciseModel, sign: f64) -> Result<(), NoValue> {
        let mut small = [0.0; ROOM];
        for (k, left) in small.iter_mut().enumerate() {
            let (s, e) = two_sum(a.high[k], sign * b.high[k]);
            self.high[k] = s;
            *left = e + (a.low[k] + sign * b.low[k]);
        }
        self.settle(&small);
        self.length = a.length.max(b.length);
        self.rest = a.rest + b.rest + unit() * (a.norm(0) + b.norm(0));
        self.finish()
    }

    fn product(&mut self, a: &PreciseModel, b: &PreciseModel) -> Result<(), NoValue> {
        if a.is_zero() || b.is_zero() {
            *self = PreciseModel::ZERO;
            return Ok(());
        }
        let (a, b) = if a.length <= b.length { (a, b) } else { (b, a) };
        let (mut high, mut low) = ([0.0; 2 * ROOM], [0.0; 2 * ROOM]);
        high[ROOM..].copy_from_slice(&b.high);
        low[ROOM..].copy_from_slice(&b.low);
        let (mut sums, mut small) = ([0.0; ROOM], [0.0; ROOM]);
        for (i, (&x, &left)) in a.high[..a.length].iter().zip(&a.low).enumerate() {
            let (high, low) = (&high[ROOM - i..2 * ROOM - i], &low[ROOM - i..2 * ROOM - i]);
            for k in 0..ROOM {
                let (p, e) = two_product(x, high[k]);
                let (s, t) = two_sum(sums[k], p);
                sums[k] = s;
                small[k] += t + (e + (x * low[k] + left * high[k]));
            }
        }
        let (na, nb) = (a.norm(0), b.norm(0));
        let mut beyond = 0.0;
        if a.length + b.length > ROOM + 1 {
            // Σ |aᵢ||bⱼ| over i + j ≥ ROOM.
            let mut tail = 0.0;
            for (i, x) in a.high.iter().enumerate().skip(1) {
                tail += b.high[ROOM - i].abs();
                beyond += x.abs() * tail;
            }
        }
        if faults::no_tail() {
            beyond = 0.0;
        }
        let rest = na * b.rest + nb * a.rest + a.rest * b.rest + beyond * GROW + unit() * na * nb + TINY;
        self.high = sums;
        self.length = (a.length + b.length - 1).min(ROOM);
        self.settle(&small);
        self.rest = rest * GROW;
        self.finish()
    }

    /// The model times a number, over an integer.
    fn scaled(&self, by: f64, over: f64) -> PreciseModel {
        let mut new =
            PreciseModel { rest: self.rest * by.abs() / over.abs(), length: self.length, ..PreciseModel::ZERO };
        for k in 0..self.length {
            (new.high[k], new.low[k]) = times_over(self.high[k], self.low[k], by, over);
        }
        new.rest = (new.rest + unit() * new.norm(0) + TINY) * GROW;
        new
    }

    /// ∫ from −1 to s, times `half`: the integral over time from the start of a stretch on.
    pub fn integral(&self, half: f64) -> PreciseModel {
        let mut new = PreciseModel::ZERO;
        let (mut start, mut small, mut size, mut beyond) = (0.0, 0.0, 0.0, 0.0);
        for k in 0..self.length {
            let (high, low) = times_over(self.high[k], self.low[k], half, (k + 1) as f64);
            if k + 1 == ROOM {
                beyond = 2.0 * high.abs();
                break;
            }
            (new.high[k + 1], new.low[k + 1]) = (high, low);
            // The value at −1.
            let sign = if k % 2 == 0 { -1.0 } else { 1.0 };
            let (s, t) = two_sum(start, sign * high);
            start = s;
            small += t + sign * low;
            size += high.abs();
        }
        (new.high[0], new.low[0]) = two_sum(-start, -small);
        new.length = (self.length + 1).min(ROOM);
        new.rest = (beyond * GROW + 2.0 * half.abs() * self.rest + 4.0 * unit() * size + TINY) * GROW;
        new
    }

    /// All values at s = 1.
    pub fn at_end(&self) -> Precise {
        let (mut sum, mut small) = (0.0, 0.0);
        for k in 0..self.length {
            let (s, t) = two_sum(sum, self.high[k]);
            sum = s;
            small += t + self.low[k];
        }
        let error = (self.rest + 2.0 * unit() * self.norm(0)) * GROW;
        Precise::new(DoubleDouble::new(sum, small), error)
    }

    /// At least |q(1) − q(s)| of the polynomial, for 1 − s ≤ `gap` ≤ 2.
    pub fn change_before_end(&self, gap: f64) -> f64 {
        let slopes: f64 = self.high.iter().enumerate().map(|(k, c)| k as f64 * c.abs()).sum();
        slopes * GROW * gap * GROW
    }

    /// An operation of the less precise models.
    fn through(&mut self, op: Op, a: &PreciseModel, b: &PreciseModel) -> Result<(), NoValue> {
        let mut out = TaylorModel::ZERO;
        op.apply(&(), &mut out, &a.rounded(), &b.rounded())?;
        *self = PreciseModel::of(&out);
        Ok(())
    }

    /// A guess whose error is a defect divided by something of at least a certain size; `self` stays what it is if that
    /// is not better.
    fn corrected(
        &mut self,
        mut guess: PreciseModel,
        least: f64,
        defect: impl Fn(&PreciseModel) -> Result<PreciseModel, NoValue>,
    ) {
        guess.length = ROOM;
        if guess.finish().is_err() {
            return;
        }
        // What `finish` has left out of the polynomial is part of the guess no more, and of its defect.
        guess.rest = 0.0;
        if let Ok(defect) = defect(&guess)
            && least > 0.0
        {
            guess.rest = defect.bound() / least * GROW + TINY;
            if guess.rest < self.rest {
                *self = guess;
            }
        }
    }

    /// a/b − q = (a − qb)/b
    fn quotient(&mut self, a: &PreciseModel, b: &PreciseModel) -> Result<(), NoValue> {
        self.through(Op::Div, a, b)?;
        let divisor = b.coefficient(0);
        let mut guess = PreciseModel::ZERO;
        for k in 0..ROOM {
            let known = (1..=k).fold(DoubleDouble::ZERO, |sum, j| sum + b.coefficient(j) * guess.coefficient(k - j));
            let q = (a.coefficient(k) - known) / divisor;
            (guess.high[k], guess.low[k]) = (q.high(), q.low());
            if b.length == 1 && k + 1 == a.length {
                break;
            }
        }
        self.corrected(guess, b.rounded().range().mignitude(), |guess| {
            let (mut back, mut defect) = (PreciseModel::ZERO, PreciseModel::ZERO);
            back.product(guess, b)?;
            defect.combine(a, &back, -1.0)?;
            Ok(defect)
        });
        Ok(())
    }

    /// √a − x = (a − x²)/(√a + x)
    fn root(&mut self, a: &PreciseModel) -> Result<(), NoValue> {
        self.through(Op::Sqrt, a, a)?;
        let mut first = DoubleDouble::ZERO;
        if first.sqrt(&(), &a.coefficient(0)).is_err() || first.high() == 0.0 {
            return Ok(());
        }
        let mut guess = PreciseModel::ZERO;
        (guess.high[0], guess.low[0]) = (first.high(), first.low());
        for k in 1..if a.length == 1 { 1 } else { ROOM } {
            let known = (1..k).fold(DoubleDouble::ZERO, |sum, j| sum + guess.coefficient(j) * guess.coefficient(k - j));
            let x = (a.coefficient(k) - known) / (first + first);
            (guess.high[k], guess.low[k]) = (x.high(), x.low());
        }
        // The root is not negative.
        let least = guess.rounded().range().lo();
        self.corrected(guess, least, |guess| {
            let (mut square, mut defect) = (PreciseModel::ZERO, PreciseModel::ZERO);
            square.product(guess, guess)?;
            defect.combine(a, &square, -1.0)?;
            Ok(defect)
        });
        Ok(())
    }
}

/// (high + low)·by/over, but for at most 12u² of it, for an integer `over`.
#[inline(always)]
fn times_over(high: f64, low: f64, by: f64, over: f64) -> (f64, f64) {
    let (p, e) = two_product(high, by);
    let small = e + low * by;
    let q = p / over;
    let (back, e) = two_product(q, over);
    two_sum(q, (((p - back) - e) + small) / over)
}
