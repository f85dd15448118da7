//! Truncated Taylor series.
//!
//! **In:** the coefficients of the arguments. **Out:** those of the result, from the differential equation or the product
//! rule that defines each operation; the recurrences are in `series`.
//!
//! **Guaranteed:** coefficient 0 is what the base type computes, bit for bit. A coefficient k costs O(k) and uses only
//! coefficients 0 … k of the arguments, so a tape can be run once for all orders, or once per order by an integrator that
//! learns coefficient k + 1 of a state from coefficient k of its rate.
//!
//! **Why lengths:** a series knows after which coefficient it is zero. Constants then cost no convolution, and "the argument
//! is constant" can be told from "its derivative happens to be needed at a branch point".

use super::{NoValue, Scalar};

/// Which coefficients an operation computes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Orders {
    from: usize,
    to: usize,
    degree: usize,
}

impl Orders {
    /// All coefficients 0 … `degree`.
    pub fn all(degree: usize) -> Orders {
        Orders { from: 0, to: degree, degree }
    }

    /// Only coefficient `k` (at most `degree`) of series that have room for `degree`; lower ones must be there already.
    pub fn only(k: usize, degree: usize) -> Orders {
        Orders { from: k.min(degree), to: k.min(degree), degree }
    }

    /// The lowest coefficient to compute.
    pub fn from(&self) -> usize {
        self.from
    }

    /// The highest coefficient to compute.
    pub fn to(&self) -> usize {
        self.to
    }

    /// The highest coefficient there is room for.
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// The order k ≥ 1 to compute, if it is only one: the case of an integrator, which deserves the shortest path.
    #[inline(always)]
    pub(super) fn single(&self) -> Option<usize> {
        (self.from == self.to && self.to > 0).then_some(self.to)
    }

    /// The orders to compute by recurrence: all but 0, which the base type computes.
    #[inline(always)]
    pub(super) fn recurrent(&self) -> std::ops::Range<usize> {
        self.from.max(1)..self.to + 1
    }
}

/// A truncated Taylor series x₀ + x₁h + … + x_d hᵈ with normalised coefficients xₖ = x⁽ᵏ⁾/k!.
///
/// As a [`Number`](super::Number) its context is [`Orders`]. At the branch points of √, arccos, arcsin, |·| and of powers
/// coefficient 0 exists; higher ones are [`NoValue::Indeterminate`] unless the argument is constant.
#[derive(Clone, Debug)]
pub struct Jet<B> {
    /// Room for all coefficients; those from `length` on are not read.
    pub(super) series: Vec<B>,
    /// 1 + the highest order whose coefficient is known and not zero, at least 1.
    pub(super) length: usize,
    /// Series that the recurrence of an operation needs beside its result (the cosine of a sine), one after the other.
    pub(super) companions: Vec<B>,
}

impl<B: Scalar> Jet<B> {
    /// A series that is constantly `value`.
    pub fn constant(value: B, orders: &Orders) -> Jet<B> {
        let mut series = vec![B::ZERO; orders.degree + 1];
        series[0] = value;
        Jet { series, length: 1, companions: Vec::new() }
    }

    /// The series `value` + `slope`·h.
    pub fn variable(value: B, slope: B, orders: &Orders) -> Jet<B> {
        let mut jet = Jet::constant(value, orders);
        if orders.degree > 0 {
            jet.set_coefficient(1, slope);
        }
        jet
    }

    /// The highest order there is room for.
    pub fn degree(&self) -> usize {
        self.series.len() - 1
    }

    /// The coefficient of hᵏ; 0 beyond those that are known.
    #[inline(always)]
    pub fn coefficient(&self, k: usize) -> B {
        if k < self.length { self.series[k] } else { B::ZERO }
    }

    /// The coefficients up to the last that is not zero.
    #[inline(always)]
    pub fn coefficients(&self) -> &[B] {
        &self.series[..self.length]
    }

    /// Coefficients 0 … k, if all of them are known.
    #[inline(always)]
    pub(super) fn upto(&self, k: usize) -> Option<&[B]> {
        if k < self.length { self.series.get(..=k) } else { None }
    }

    /// Whether all coefficients but the first are zero, as far as they are known.
    #[inline(always)]
    pub fn is_constant(&self) -> bool {
        self.length == 1
    }

    /// Sets a coefficient and forgets all higher ones; `k` beyond the degree is ignored.
    pub fn set_coefficient(&mut self, k: usize, value: B) {
        if k >= self.series.len() {
            return;
        }
        if k >= self.length {
            self.series[self.length..k].fill(B::ZERO);
        }
        self.series[k] = value;
        self.length = if k > 0 && value.is_zero() { self.length.min(k) } else { k + 1 };
    }

    /// The value of the polynomial at h, by Horner's rule; unchecked.
    pub fn at(&self, h: B) -> B {
        self.coefficients().iter().rev().copied().reduce(|sum, c| sum * h + c).unwrap_or(B::ZERO)
    }

    /// The value of the derivative of the polynomial at h; unchecked.
    pub fn slope_at(&self, h: B) -> B {
        let mut sum = B::ZERO;
        for k in (1..self.length).rev() {
            sum = sum * h + B::integer(k as i32) * self.series[k];
        }
        sum
    }

    /// The series of the derivative, (k + 1)·xₖ₊₁; its last coefficient is unknown and set to 0.
    pub fn derivative(&self) -> Jet<B> {
        let mut series = vec![B::ZERO; self.series.len()];
        for k in 1..self.length {
            series[k - 1] = B::integer(k as i32) * self.series[k];
        }
        Jet { series, length: self.length.max(2) - 1, companions: Vec::new() }
    }

    /// Order 0, from the base type.
    #[inline(always)]
    pub(super) fn start(
        &mut self,
        orders: &Orders,
        base: impl FnOnce(&mut B) -> Result<(), NoValue>,
    ) -> Result<(), NoValue> {
        if orders.from == 0 {
            self.length = 1;
            base(&mut self.series[0])?;
        }
        Ok(())
    }

    /// Writes the next coefficient of a result.
    #[inline(always)]
    pub(super) fn put(&mut self, k: usize, coefficient: B) -> Result<(), NoValue> {
        let c = coefficient.checked()?;
        self.series[k] = c;
        self.length = if c.is_zero() { self.length } else { k + 1 };
        Ok(())
    }

    /// Makes room for `n` companion series. They are allocated once in the life of a slot.
    #[inline(always)]
    pub(super) fn reserve(&mut self, n: usize) {
        let need = n * self.series.len();
        if self.companions.len() < need {
            self.companions.resize(need, B::ZERO);
        }
    }
}

/// Equality of the known coefficients.
impl<B: Scalar + PartialEq> PartialEq for Jet<B> {
    fn eq(&self, other: &Jet<B>) -> bool {
        self.coefficients() == other.coefficients()
    }
}
