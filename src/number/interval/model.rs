//! Taylor models in one variable: polynomials with a bound for what they leave out.
//!
//! **In:** models that contain the arguments. **Out:** a model that contains the result. A quantity q(s), −1 ≤ s ≤ 1, is
//! *contained* in a model (c, r) if |q(s) − Σₖ cₖsᵏ| ≤ r for all s. The coefficients are numbers, not intervals: that is
//! what makes models many times cheaper than series over intervals, which they replace where a formula is to be bounded
//! over a stretch of time.
//!
//! **Guaranteed:** if an operation yields a model, then it is defined and continuous for all arguments in the models, and
//! the result is contained, rounding included. [`NoValue::OutOfDomain`] means that the operation has no value at any s.
//!
//! **Theorems.** Sums and products of models contain those of what they contain ([Makino & Berz 2003, Theorem 2.4]): terms
//! beyond the last order and products with remainders are bounded by sums of absolute values. For a function f of one
//! argument c₀ + u, f(c₀ + u) = Σₖ≤ₙ fₖ(c₀)uᵏ + fₙ₊₁(ξ)uⁿ⁺¹ (Taylor, Lagrange); the coefficients come from the series of
//! intervals, at c₀ and over all arguments. Quotients and roots are guessed and then corrected by their defect: a/b − q =
//! (a − qb)/b, √a − x = (a − x²)/(√a + x). An angle is turned to the first coefficients of its sides, where
//! atan2(y, x) = atan2(y₀, x₀) + arctan((x₀y − y₀x)/(x₀x + y₀y)) as long as the divisor is positive and the cut is not met.
//!
//! **Rounding.** All sums here have fewer than 64 terms, and every operation rounds to nearest; by [Higham 2002, §3.1] the
//! error of a sum of n products is below nu·Σ|aᵢbᵢ|/(1 − nu). These bounds go into r, which is itself rounded up.
//!
//! [Makino & Berz 2003, Theorem 2.4]: https://www.bmtdynamics.org/pub/papers/TMIJPAM03/
//! [Higham 2002, §3.1]: https://doi.org/10.1137/1.9780898718027

mod functions;

use super::{Interval, U, faults, round};
use crate::{NoValue, Scalar};

/// Number of coefficients.
const ROOM: usize = 14;
/// Bounds are sums of fewer than 200 terms that are not negative; rounded to nearest, times this, they are not too small.
const GROW: f64 = 1.0 + 256.0 * U;
/// More than what underflow may lose in one operation.
const TINY: f64 = 1e-290;
/// Last coefficients below this part of the sum of all are added to the remainder: they would only cost time.
const NEGLIGIBLE: f64 = 1e-19;

/// Most coefficients of a polynomial that becomes a model.
pub(super) const MOST_TERMS: usize = 27;
/// 0, 1, 2 …
const ORDERS: [f64; ROOM] = {
    let mut orders = [0.0; ROOM];
    let mut k = 0;
    while k < ROOM {
        orders[k] = k as f64;
        k += 1;
    }
    orders
};
/// The coefficients of ((1 + s)/2)ᵏ: binomial coefficients over powers of two, which binary64 holds exactly.
pub(super) const POWERS: [[f64; MOST_TERMS + 1]; MOST_TERMS + 1] = {
    let mut powers = [[0.0; MOST_TERMS + 1]; MOST_TERMS + 1];
    powers[0][0] = 1.0;
    let mut k = 1;
    while k <= MOST_TERMS {
        powers[k][0] = 0.5 * powers[k - 1][0];
        let mut j = 1;
        while j <= k {
            powers[k][j] = 0.5 * powers[k - 1][j] + 0.5 * powers[k - 1][j - 1];
            j += 1;
        }
        k += 1;
    }
    powers
};

/// Number of places that [`TaylorModel::through`] takes values at.
pub const NODES: usize = 8;

/// Those places: near the zeros of a Chebyshev polynomial.
const PLACES: [f64; NODES] = [-0.98, -0.83, -0.555, -0.195, 0.195, 0.555, 0.83, 0.98];

/// Coefficients of the polynomials that are 1 at one place and 0 at the others.
const LAGRANGE: [[f64; NODES]; NODES] = {
    let mut all = [[0.0; NODES]; NODES];
    let mut j = 0;
    while j < NODES {
        let mut product = [0.0; NODES];
        product[0] = 1.0;
        let (mut m, mut degree) = (0, 0);
        while m < NODES {
            if m != j {
                let scale = PLACES[j] - PLACES[m];
                let mut k = degree + 1;
                while k > 0 {
                    product[k] = (product[k - 1] - PLACES[m] * product[k]) / scale;
                    k -= 1;
                }
                product[0] = -PLACES[m] * product[0] / scale;
                degree += 1;
            }
            m += 1;
        }
        all[j] = product;
        j += 1;
    }
    all
};

/// See the module.
#[derive(Clone, Copy, Debug, serde::Serialize, serde::Deserialize)]
#[serde(into = "Vec<f64>", from = "Vec<f64>")]
pub struct TaylorModel {
    /// Those from `length` on are 0.
    coefficients: [f64; ROOM],
    rest: f64,
    /// At least 1.
    length: usize,
}

impl From<TaylorModel> for Vec<f64> {
    fn from(model: TaylorModel) -> Vec<f64> {
        let mut packed = Vec::with_capacity(model.length + 1);
        model.pack(&mut packed);
        packed
    }
}

impl From<Vec<f64>> for TaylorModel {
    fn from(packed: Vec<f64>) -> TaylorModel {
        TaylorModel::unpack(&packed)
    }
}

/// U, or nothing in tests of what happens without.
#[inline(always)]
fn unit() -> f64 {
    if faults::nearest() { 0.0 } else { U }
}

impl TaylorModel {
    /// Degree of the polynomials.
    pub const DEGREE: usize = ROOM - 1;

    /// 0, exactly.
    pub const ZERO: TaylorModel = TaylorModel { coefficients: [0.0; ROOM], rest: 0.0, length: 1 };

    /// A quantity of which only bounds are known.
    pub fn constant(value: Interval) -> TaylorModel {
        let mut new = TaylorModel::ZERO;
        new.coefficients[0] = value.mid();
        new.rest = value.radius();
        new
    }

    /// m + h·s for all m in an interval.
    pub fn variable(middle: Interval, half: f64) -> TaylorModel {
        let mut new = TaylorModel::constant(middle);
        new.coefficients[1] = half;
        new.length = 2;
        new
    }

    /// A polynomial, of which coefficients that there is no room for count as unknown, and what else is not known.
    pub(super) fn from_parts(coefficients: impl Iterator<Item = f64>, rest: f64) -> TaylorModel {
        let mut new = TaylorModel::ZERO;
        let mut beyond = rest;
        for (k, c) in coefficients.enumerate() {
            if k < ROOM {
                new.coefficients[k] = c;
                new.length = if c != 0.0 { k + 1 } else { new.length };
            } else {
                beyond += c.abs();
            }
        }
        new.rest = beyond * GROW;
        new
    }

    /// The coefficients up to the last that is not zero.
    pub(super) fn coefficients(&self) -> &[f64] {
        &self.coefficients[..self.length]
    }

    /// Appends it to a list of numbers: the coefficients in use, then what is not known. How many numbers that are.
    pub fn pack(&self, into: &mut Vec<f64>) -> usize {
        into.extend_from_slice(self.coefficients());
        into.push(self.rest);
        self.length + 1
    }

    /// What [`TaylorModel::pack`] appended; 0 for an empty list.
    pub fn unpack(packed: &[f64]) -> TaylorModel {
        let mut new = TaylorModel::ZERO;
        if let Some((rest, coefficients)) = packed.split_last() {
            let length = coefficients.len().min(ROOM);
            new.coefficients[..length].copy_from_slice(&coefficients[..length]);
            new.length = length.max(1);
            new.rest = *rest;
        }
        new
    }

    /// Whether it is one number.
    #[inline(always)]
    fn is_point(&self) -> bool {
        self.length == 1 && self.rest == 0.0
    }

    #[inline(always)]
    fn is_zero(&self) -> bool {
        self.is_point() && self.coefficients[0] == 0.0
    }

    /// The polynomial, without what is not known of the quantity.
    pub fn polynomial(&self) -> TaylorModel {
        TaylorModel { rest: 0.0, ..*self }
    }

    /// A polynomial without a remainder, close to given values at the [`NODES`] places of [`TaylorModel::at_node`]. How close
    /// is not said.
    ///
    /// # Errors
    /// [`NoValue::Indeterminate`] when a coefficient is not finite.
    pub fn through(values: &[f64; NODES]) -> Result<TaylorModel, NoValue> {
        let mut new = TaylorModel::ZERO;
        for (basis, &value) in LAGRANGE.iter().zip(values) {
            new.coefficients.iter_mut().zip(basis).for_each(|(c, b)| *c += b * value);
        }
        new.length = NODES;
        if new.norm(0) < f64::MAX { Ok(new) } else { Err(NoValue::Indeterminate) }
    }

    /// The polynomial at one of the places of [`TaylorModel::through`], to nearest.
    pub fn at_node(&self, node: usize) -> f64 {
        self.coefficients[..self.length].iter().rev().fold(0.0, |sum, c| sum * PLACES[node] + c)
    }

    /// What it is known of the quantity beside the polynomial.
    pub fn remainder(&self) -> f64 {
        self.rest
    }

    /// Σ|cₖ|, from order `from` on, to nearest.
    #[inline(always)]
    fn norm(&self, from: usize) -> f64 {
        self.coefficients[from..].iter().map(|c| c.abs()).sum()
    }

    /// Σ k|cₖ|, to nearest.
    #[inline(always)]
    fn weighted(&self) -> f64 {
        self.coefficients.iter().zip(&ORDERS).map(|(c, k)| c.abs() * k).sum()
    }

    /// At least the distance of any value from the first coefficient.
    fn spread(&self) -> f64 {
        (self.norm(1) + self.rest) * GROW
    }

    /// All values.
    pub fn range(&self) -> Interval {
        let c = &self.coefficients;
        let (mut lo, mut hi, mut slopes) = (0.0, 0.0, 0.0);
        for (k, &x) in c.iter().enumerate().take(self.length).skip(1) {
            // sᵏ lies in [−1, 1], or in [0, 1].
            let size = x.abs();
            lo -= if k % 2 == 1 || x < 0.0 { size } else { 0.0 };
            hi += if k % 2 == 1 || x > 0.0 { size } else { 0.0 };
            slopes += k as f64 * size;
        }
        if self.length > 2 && 2.0 * c[1].abs() > slopes * GROW {
            // The polynomial is monotone: its extremes are at the ends.
            let (mut even, mut odd) = (0.0, 0.0);
            for (k, &x) in c.iter().enumerate().take(self.length).skip(1) {
                if k % 2 == 1 { odd += x } else { even += x }
            }
            let (a, b) = (even - odd, even + odd);
            (lo, hi) = (lo.max(a.min(b)), hi.min(a.max(b)));
        }
        let room = self.rest + 40.0 * unit() * self.norm(1) * GROW;
        let room = room * GROW;
        Interval {
            lo: round::add_down(round::add_down(c[0], lo), -room),
            hi: round::add_up(round::add_up(c[0], hi), room),
        }
    }

    /// A polynomial without a remainder, close to Σₖ cₖ·σᵏ for σ from 0 to h, where s = −1 is σ = 0. How close is not said.
    /// At most 28 coefficients are taken.
    ///
    /// # Errors
    /// [`NoValue::Indeterminate`] when a coefficient is not finite, or there are too many.
    pub fn close_to(coefficients: &[f64], h: f64) -> Result<TaylorModel, NoValue> {
        if coefficients.len() > MOST_TERMS + 1 {
            return Err(NoValue::Indeterminate);
        }
        let mut scaled = [0.0; MOST_TERMS + 1];
        let mut power = 1.0;
        for (d, &c) in scaled.iter_mut().zip(coefficients) {
            *d = c * power;
            power *= h;
        }
        let mut new = TaylorModel::ZERO;
        for (d, weights) in scaled.iter().zip(&POWERS).rev() {
            for (sum, w) in new.coefficients.iter_mut().zip(weights) {
                *sum += d * w;
            }
        }
        new.length = ROOM;
        let size = new.norm(0);
        new.finish(size)?;
        new.rest = 0.0;
        if size < f64::MAX { Ok(new) } else { Err(NoValue::Indeterminate) }
    }

    /// What is contained, as a function of what another model contains.
    ///
    /// # Errors
    /// [`NoValue::Indeterminate`] when a bound is not finite.
    pub fn after(&self, s: &TaylorModel) -> Result<TaylorModel, NoValue> {
        let (mut sum, mut product) = (TaylorModel::ZERO, TaylorModel::ZERO);
        for &c in self.coefficients[..self.length].iter().rev() {
            product.product(&sum, s)?;
            sum.combine(&product, &TaylorModel::constant(Interval::point(c)), |x, y| x + y)?;
        }
        Ok(sum.widened(self.rest))
    }

    /// ∫ from −1 to s, times `half`: the integral over time from the start of a stretch on.
    pub fn integral(&self, half: f64) -> TaylorModel {
        let mut new = TaylorModel::ZERO;
        let (mut start, mut size, mut slips) = (0.0_f64, 0.0, 0.0);
        for k in (0..ROOM).rev() {
            let c = self.coefficients[k] * half / (k + 1) as f64;
            if k + 1 < ROOM {
                new.coefficients[k + 1] = c;
                // The value at −1.
                start += if k % 2 == 0 { -c } else { c };
                slips += start.abs();
                size += c.abs();
            } else {
                new.rest += 2.0 * c.abs();
            }
        }
        new.coefficients[0] = -start;
        new.length = (self.length + 1).min(ROOM);
        // Two roundings in each coefficient, which is used twice; in the first there is one.
        let slips = slips + 4.0 * size - 2.0 * new.coefficients[1].abs();
        new.rest = (new.rest + 2.0 * half.abs() * self.rest + unit() * slips + TINY) * GROW;
        new
    }

    /// What lies within a distance of what is contained.
    pub fn widened(&self, by: f64) -> TaylorModel {
        TaylorModel { rest: (self.rest + by) * GROW, ..*self }
    }

    /// At least the size of all values.
    pub fn bound(&self) -> f64 {
        (self.norm(0) + self.rest) * GROW
    }

    /// All values at some s in [−1, 1]; those of the polynomial alone, if there is no remainder, also elsewhere.
    pub fn at(&self, s: Interval) -> Interval {
        let mut sum = Interval::ZERO;
        for &c in self.coefficients[..self.length].iter().rev() {
            sum = sum * s + Interval::point(c);
        }
        sum + Interval::ball(0.0, self.rest)
    }

    /// All values at s = 1.
    pub fn at_end(&self) -> Interval {
        let sum: f64 = self.coefficients.iter().sum();
        Interval::ball(sum, (self.rest + ROOM as f64 * unit() * self.norm(0)) * GROW)
    }

    /// Checks, and leaves out what is negligible.
    #[inline(always)]
    fn finish(&mut self, size: f64) -> Result<(), NoValue> {
        while self.length > 1 && self.coefficients[self.length - 1].abs() <= NEGLIGIBLE * size {
            self.length -= 1;
            self.rest += self.coefficients[self.length].abs();
            self.coefficients[self.length] = 0.0;
        }
        self.rest *= GROW;
        // Coefficients that are not finite make the remainder so.
        if self.rest < f64::MAX { Ok(()) } else { Err(NoValue::Indeterminate) }
    }

    #[inline(always)]
    fn combine(&mut self, a: &TaylorModel, b: &TaylorModel, add: impl Fn(f64, f64) -> f64) -> Result<(), NoValue> {
        let mut size = 0.0;
        for k in 0..ROOM {
            let c = add(a.coefficients[k], b.coefficients[k]);
            self.coefficients[k] = c;
            size += c.abs();
        }
        self.length = a.length.max(b.length);
        self.rest = a.rest + b.rest + unit() * size;
        self.finish(size)
    }

    /// The model times a number.
    fn scaled(&mut self, a: f64, b: &TaylorModel) -> Result<(), NoValue> {
        if a == 0.0 || b.is_zero() {
            *self = TaylorModel::ZERO;
            return Ok(());
        }
        let mut size = 0.0;
        for k in 0..ROOM {
            let c = a * b.coefficients[k];
            self.coefficients[k] = c;
            size += c.abs();
        }
        self.length = b.length;
        self.rest = a.abs() * b.rest + unit() * size + TINY;
        self.finish(size)
    }

    fn product(&mut self, a: &TaylorModel, b: &TaylorModel) -> Result<(), NoValue> {
        if a.is_point() {
            return self.scaled(a.coefficients[0], b);
        }
        if b.is_point() {
            return self.scaled(b.coefficients[0], a);
        }
        let (a, b) = if a.length <= b.length { (a, b) } else { (b, a) };
        let mut padded = [0.0; 2 * ROOM];
        padded[ROOM..].copy_from_slice(&b.coefficients);
        let mut out = [0.0; ROOM];
        for (i, &x) in a.coefficients[..a.length].iter().enumerate() {
            let shifted = &padded[ROOM - i..2 * ROOM - i];
            for (sum, &y) in out.iter_mut().zip(shifted) {
                *sum += x * y;
            }
        }
        let (na, nb) = (a.norm(0), b.norm(0));
        let mut beyond = 0.0;
        if a.length + b.length > ROOM + 1 {
            // Σ |aᵢ||bⱼ| over i + j ≥ ROOM.
            let mut tail = 0.0;
            for (i, x) in a.coefficients.iter().enumerate().skip(1) {
                tail += b.coefficients[ROOM - i].abs();
                beyond += x.abs() * tail;
            }
        }
        if faults::no_tail() {
            beyond = 0.0;
        }
        self.coefficients = out;
        self.length = (a.length + b.length - 1).min(ROOM);
        let size = na * nb;
        // Coefficient k is the sum of k + 1 products, which are rounded at most k + 1 times:
        // Σ (k + 1)|aᵢ||bₖ₋ᵢ| = Σ (i + j + 1)|aᵢ||bⱼ|.
        let rounding = unit() * (size + a.weighted() * nb + na * b.weighted());
        self.rest = na * b.rest + nb * a.rest + a.rest * b.rest + beyond + rounding + TINY;
        self.finish(size)
    }
}
