//! Polynomials and rational functions of the time, with rational coefficients.
//!
//! **In:** rational numbers. **Out:** [`Polynomial`], [`Fraction`], and the zeros of a polynomial in an interval, where all of them are
//! rational. **Guaranteed:** everything is exact; what grows beyond a bound is given up.

use crate::expr::Rational;
use dashu_int::ops::BitTest;

/// The highest degree that is looked at.
const MOST_DEGREE: usize = 16;
/// Most bits of a number in a product.
const MOST_BITS: usize = 100_000;
/// Halvings by which a zero is isolated before the simplest number near it is tried.
const HALVINGS: usize = 14;

/// Coefficients, that of 1 first; the last one is not 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Polynomial(Vec<Rational>);

impl Polynomial {
    pub(super) fn new(mut coefficients: Vec<Rational>) -> Polynomial {
        while coefficients.last().is_some_and(|c| *c == Rational::ZERO) {
            coefficients.pop();
        }
        Polynomial(coefficients)
    }

    pub(super) fn constant(value: Rational) -> Polynomial {
        Polynomial::new(vec![value])
    }

    pub(super) fn integers(coefficients: &[i64]) -> Polynomial {
        Polynomial::new(coefficients.iter().map(|&c| Rational::from(c)).collect())
    }

    pub(super) fn coefficients(&self) -> &[Rational] {
        &self.0
    }

    pub(super) fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// Its value, if it does not depend on the time.
    pub(super) fn as_constant(&self) -> Option<Rational> {
        match self.0.as_slice() {
            [] => Some(Rational::ZERO),
            [only] => Some(only.clone()),
            _ => None,
        }
    }

    fn leading(&self) -> Rational {
        self.0.last().cloned().unwrap_or(Rational::ZERO)
    }

    pub(super) fn add(&self, other: &Polynomial) -> Polynomial {
        let length = self.0.len().max(other.0.len());
        let of = |p: &Polynomial, n: usize| p.0.get(n).cloned().unwrap_or(Rational::ZERO);
        Polynomial::new((0..length).map(|n| of(self, n) + of(other, n)).collect())
    }

    pub(super) fn scaled(&self, by: &Rational) -> Polynomial {
        Polynomial::new(self.0.iter().map(|c| c * by).collect())
    }

    pub(super) fn sub(&self, other: &Polynomial) -> Polynomial {
        self.add(&other.scaled(&Rational::NEG_ONE))
    }

    /// The product; `None` beyond the highest degree.
    pub(super) fn mul(&self, other: &Polynomial) -> Option<Polynomial> {
        if self.is_zero() || other.is_zero() {
            return Some(Polynomial(Vec::new()));
        }
        let length = self.0.len() + other.0.len() - 1;
        if length > MOST_DEGREE + 1 || self.bits() + other.bits() > MOST_BITS {
            return None;
        }
        let mut out = vec![Rational::ZERO; length];
        for (i, a) in self.0.iter().enumerate() {
            for (j, b) in other.0.iter().enumerate() {
                out[i + j] += a * b;
            }
        }
        Some(Polynomial::new(out))
    }

    /// The bits of its longest number.
    fn bits(&self) -> usize {
        let of = |c: &Rational| c.numerator().bit_len().max(c.denominator().bit_len());
        self.0.iter().map(of).max().unwrap_or(0)
    }

    pub(super) fn at(&self, t: &Rational) -> Rational {
        self.0.iter().rev().fold(Rational::ZERO, |sum, c| sum * t + c)
    }

    pub(super) fn derivative(&self) -> Polynomial {
        let of = |(n, c): (usize, &Rational)| c * Rational::from(n as u64);
        Polynomial::new(self.0.iter().enumerate().skip(1).map(of).collect())
    }

    /// An antiderivative, which is 0 at time 0.
    pub(super) fn integral(&self) -> Polynomial {
        let of = |(n, c): (usize, &Rational)| c / Rational::from(n as u64 + 1);
        Polynomial::new(std::iter::once(Rational::ZERO).chain(self.0.iter().enumerate().map(of)).collect())
    }

    /// Quotient and remainder; the divisor is not 0.
    fn divided(&self, by: &Polynomial) -> (Polynomial, Polynomial) {
        let (mut rest, mut quotient) = (self.clone(), Vec::new());
        while !rest.is_zero() && rest.0.len() >= by.0.len() && !by.is_zero() {
            let shift = rest.0.len() - by.0.len();
            let factor = rest.leading() / by.leading();
            if quotient.len() <= shift {
                quotient.resize(shift + 1, Rational::ZERO);
            }
            for (n, c) in by.0.iter().enumerate() {
                rest.0[shift + n] -= &factor * c;
            }
            quotient[shift] = factor;
            rest = Polynomial::new(rest.0);
        }
        (Polynomial::new(quotient), rest)
    }

    fn common(&self, other: &Polynomial) -> Polynomial {
        let (mut a, mut b) = (self.clone(), other.clone());
        while !b.is_zero() {
            let (_, rest) = a.divided(&b);
            (a, b) = (b, rest);
        }
        match a.is_zero() {
            true => a,
            false => a.scaled(&(Rational::ONE / a.leading())),
        }
    }

    /// A polynomial whose square it is.
    pub(super) fn root(&self) -> Option<Polynomial> {
        if self.is_zero() {
            return Some(self.clone());
        }
        if self.0.len().is_multiple_of(2) {
            return None;
        }
        let degree = self.0.len() / 2;
        let first = proof::exact::rational_root(&self.leading())?;
        let twice = &first + &first;
        let mut root = vec![Rational::ZERO; degree + 1];
        root[degree] = first;
        // From the highest coefficient on, each is determined by those before.
        for n in (0..degree).rev() {
            let known = Polynomial::new(root.clone());
            let rest = self.sub(&known.mul(&known)?);
            let wanted = rest.0.get(degree + n).cloned().unwrap_or(Rational::ZERO);
            root[n] = wanted / &twice;
        }
        let root = Polynomial::new(root);
        (root.mul(&root).as_ref() == Some(self)).then_some(root)
    }

    /// The zeros between two numbers; `None` if one of them is not rational.
    pub(super) fn zeros(&self, low: &Rational, high: &Rational) -> Option<Vec<Rational>> {
        let mut out = Vec::new();
        if self.0.len() <= 1 {
            return Some(out);
        }
        if let [c, b] = self.0.as_slice() {
            let zero = -c / b;
            out.extend((zero > *low && zero < *high).then_some(zero));
            return Some(out);
        }
        let (simple, _) = self.divided(&self.common(&self.derivative()));
        let mut chain = vec![simple.clone(), simple.derivative()];
        while let [.., a, b] = chain.as_slice() {
            if b.is_zero() {
                break;
            }
            let (_, rest) = a.divided(b);
            chain.push(rest.scaled(&Rational::NEG_ONE));
        }
        let changes = |t: &Rational| {
            let values = chain.iter().map(|p| p.at(t)).filter(|v| *v != Rational::ZERO);
            let signs: Vec<bool> = values.map(|v| v > Rational::ZERO).collect();
            signs.windows(2).filter(|w| w[0] != w[1]).count()
        };
        // Zeros above the first number and not above the second.
        let count = |a: &Rational, b: &Rational| changes(a).saturating_sub(changes(b));
        let mut open = vec![(low.clone(), high.clone(), 0)];
        while let Some((a, b, depth)) = open.pop() {
            let inside = count(&a, &b);
            if inside == 0 {
                continue;
            }
            if inside > 1 || depth < HALVINGS {
                if depth > 4 * HALVINGS {
                    return None;
                }
                let middle = (&a + &b) / Rational::from(2);
                open.extend([(a, middle.clone(), depth + 1), (middle, b, depth + 1)]);
                continue;
            }
            let zero = if simple.at(&b) == Rational::ZERO { b } else { simplest(&a, &b) };
            if simple.at(&zero) != Rational::ZERO {
                return None;
            }
            out.extend((zero > *low && zero < *high).then_some(zero));
        }
        out.sort();
        Some(out)
    }

    /// It as a formula of the time, which has this name.
    pub(super) fn shown(&self, time: &str) -> String {
        let mut out = String::new();
        for (n, c) in self.0.iter().enumerate().filter(|(_, c)| **c != Rational::ZERO) {
            let negative = *c < Rational::ZERO;
            let size = if negative { -c.clone() } else { c.clone() };
            let sign = match (out.is_empty(), negative) {
                (true, true) => "-",
                (true, false) => "",
                (false, true) => " - ",
                (false, false) => " + ",
            };
            out.push_str(sign);
            let power = match n {
                0 => String::new(),
                1 => time.to_owned(),
                _ => format!("{time}^{n}"),
            };
            match (n, size == Rational::ONE) {
                (0, _) => out.push_str(&size.to_string()),
                (_, true) => out.push_str(&power),
                (_, false) if size.denominator().is_one() => out.push_str(&format!("{size} {power}")),
                (_, false) => out.push_str(&format!("({size}) {power}")),
            }
        }
        if out.is_empty() { "0".to_owned() } else { out }
    }
}

/// The number with the smallest denominator between two others.
fn simplest(low: &Rational, high: &Rational) -> Rational {
    let whole = Rational::from(low.floor());
    let above = &whole + Rational::ONE;
    if above < *high {
        return above;
    }
    if whole == *low {
        // Between a whole number and the next.
        let part = Rational::ONE / (high - &whole);
        return whole + Rational::ONE / (Rational::from(part.floor()) + Rational::ONE);
    }
    let (a, b) = (low - &whole, high - &whole);
    whole + Rational::ONE / simplest(&(Rational::ONE / b), &(Rational::ONE / a))
}

/// A quotient of polynomials without a common factor; the divisor begins with 1.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Fraction {
    pub(super) top: Polynomial,
    pub(super) under: Polynomial,
}

impl Fraction {
    /// A quotient; `None` if the divisor is 0.
    pub(super) fn new(top: Polynomial, under: Polynomial) -> Option<Fraction> {
        if under.is_zero() {
            return None;
        }
        if under.as_constant().is_some() {
            let top = top.scaled(&(Rational::ONE / under.leading()));
            return Some(Fraction::of(top));
        }
        let common = top.common(&under);
        let (top, under) = match common.is_zero() {
            true => (top, under),
            false => (top.divided(&common).0, under.divided(&common).0),
        };
        let by = Rational::ONE / under.leading();
        Some(Fraction { top: top.scaled(&by), under: under.scaled(&by) })
    }

    pub(super) fn of(top: Polynomial) -> Fraction {
        Fraction { top, under: Polynomial::constant(Rational::ONE) }
    }

    pub(super) fn constant(value: Rational) -> Fraction {
        Fraction::of(Polynomial::constant(value))
    }

    pub(super) fn is_zero(&self) -> bool {
        self.top.is_zero()
    }

    pub(super) fn as_constant(&self) -> Option<Rational> {
        self.top.as_constant().filter(|_| self.under.as_constant().is_some())
    }

    pub(super) fn as_polynomial(&self) -> Option<&Polynomial> {
        self.under.as_constant().is_some().then_some(&self.top)
    }

    pub(super) fn neg(&self) -> Fraction {
        Fraction { top: self.top.scaled(&Rational::NEG_ONE), under: self.under.clone() }
    }

    pub(super) fn add(&self, other: &Fraction) -> Option<Fraction> {
        if self.under == other.under {
            return Fraction::new(self.top.add(&other.top), self.under.clone());
        }
        let top = self.top.mul(&other.under)?.add(&other.top.mul(&self.under)?);
        Fraction::new(top, self.under.mul(&other.under)?)
    }

    pub(super) fn mul(&self, other: &Fraction) -> Option<Fraction> {
        Fraction::new(self.top.mul(&other.top)?, self.under.mul(&other.under)?)
    }

    /// The reciprocal; `None` of 0.
    pub(super) fn inverse(&self) -> Option<Fraction> {
        Fraction::new(self.under.clone(), self.top.clone())
    }

    pub(super) fn derivative(&self) -> Option<Fraction> {
        let top = self.top.derivative().mul(&self.under)?.sub(&self.top.mul(&self.under.derivative())?);
        Fraction::new(top, self.under.mul(&self.under)?)
    }

    /// Its value; `None` at a pole.
    pub(super) fn at(&self, t: &Rational) -> Option<Rational> {
        let under = self.under.at(t);
        (under != Rational::ZERO).then(|| self.top.at(t) / under)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(coefficients: &[i64]) -> Polynomial {
        Polynomial::integers(coefficients)
    }

    #[test]
    fn zeros_between_two_numbers() {
        let [low, high] = [-3, 3].map(Rational::from);
        // (2t − 1)²(t + 2)(t² + 1)
        let square =
            of(&[-1, 2]).mul(&of(&[-1, 2])).and_then(|p| p.mul(&of(&[2, 1]))).and_then(|p| p.mul(&of(&[1, 0, 1])));
        let half = Rational::ONE / Rational::from(2);
        let zeros = square.and_then(|p| p.zeros(&low, &high));
        assert_eq!(zeros, Some(vec![Rational::from(-2), half.clone()]));
        assert_eq!(of(&[-2, 0, 1]).zeros(&low, &high), None, "the root of 2 is no rational number");
        assert_eq!(of(&[-2, 0, 1]).zeros(&low, &Rational::from(-2)), Some(vec![]));
        // The ends do not count.
        assert_eq!(of(&[0, -1, 1]).zeros(&Rational::ZERO, &Rational::ONE), Some(vec![]));
        let third = Rational::ONE / Rational::from(3);
        let cubic = of(&[-1, 3]).mul(&of(&[1, 1, 1]));
        assert_eq!(cubic.and_then(|p| p.zeros(&low, &high)), Some(vec![third]));
    }

    #[test]
    fn roots_and_fractions() {
        let p = of(&[1, -3, 2]);
        let square = p.mul(&p).unwrap_or_else(|| of(&[]));
        let root = square.root();
        assert!(root == Some(p.clone()) || root == Some(p.scaled(&Rational::NEG_ONE)));
        assert_eq!(of(&[1, 0, 1]).root(), None);
        let (q, r) = (Fraction::new(of(&[-1, 0, 1]), of(&[-2, 2])), Fraction::of(of(&[1, 1])));
        let half = Fraction::constant(Rational::ONE / Rational::from(2));
        assert_eq!(q, r.mul(&half), "a common factor goes");
        assert_eq!(p.shown("t"), "1 - 3 t + 2 t^2");
    }
}
