//! GF(p²) = GF(p)(i) with a prime p ≡ 3 (mod 4) chosen at run time: the arithmetic of identity tests.
//!
//! **In:** a prime of 61 or 62 bits. **Out:** [`Finite`], a [`Number`] with exact +, −, ·, ÷, integer powers and square roots.
//!
//! **Guaranteed:** results are exact. For p ≡ 3 (mod 4), −1 is not a square in GF(p), so i² = −1 defines a field of p²
//! elements; every element of GF(p) has a square root in it, and half of the elements of GF(p²) have one. Which of the two
//! roots [`Number::sqrt`] yields has no meaning: there is no order, hence no positive root. Transcendental functions, π and
//! |·| are [`NoValue::Unsupported`].
//!
//! **Why p is chosen at run time:** a false identity whose numerator is divisible by a fixed p passes every test modulo p.
//!
//! Residues are kept in Montgomery form x·2⁶⁴ mod p ([Montgomery 1985]); a product in GF(p²) costs four word products and
//! two reductions, since a sum of two products stays below 2p² < 2¹²⁵.
//!
//! [Montgomery 1985]: https://doi.org/10.1090/S0025-5718-1985-0777282-X

use super::{Draws, NoValue, Op, Rational};

/// A prime field GF(p) and its extension by i: the context of [`Finite`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FiniteField {
    p: u64,
    /// −p⁻¹ mod 2⁶⁴.
    neg_inverse: u64,
    /// 2¹²⁸ mod p.
    r2: u64,
    /// 2⁶⁴ mod p: the residue 1.
    one: u64,
}

/// An element a + b·i of GF(p²). Only meaningful together with its [`FiniteField`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub struct Finite {
    re: u64,
    im: u64,
}

impl Finite {
    /// Whether this is 0.
    pub fn is_zero(self) -> bool {
        self.re == 0 && self.im == 0
    }

    /// Whether this lies in GF(p).
    pub fn is_in_prime_field(self) -> bool {
        self.im == 0
    }
}

/// Whether n is prime: Miller–Rabin with the first twelve primes as bases, a proof for all n < 3.3·10²⁴
/// ([Sorenson & Webster 2017]).
///
/// [Sorenson & Webster 2017]: https://doi.org/10.1090/mcom/3134
pub fn is_prime(n: u64) -> bool {
    const BASES: [u64; 12] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37];
    if n < 2 {
        return false;
    }
    for q in BASES {
        if n.is_multiple_of(q) {
            return n == q;
        }
    }
    if n < 1 << 62 {
        // n is odd, and nothing else is asked of it: products in Montgomery's form take a tenth of the time.
        let ring = FiniteField::of_prime(n);
        let base = |a: u64| ring.times(a, ring.r2);
        return is_probable(n, BASES.map(base), ring.one, |a, b| ring.times(a, b));
    }
    is_probable(n, BASES, 1, |a, b| (u128::from(a) * u128::from(b) % u128::from(n)) as u64)
}

/// Whether an odd n passes the test of Miller and Rabin for all bases, none of them a multiple of n; residues may be written
/// in any way in which `one` is 1 and n − `one` is −1.
fn is_probable<const K: usize>(n: u64, bases: [u64; K], one: u64, times: impl Fn(u64, u64) -> u64) -> bool {
    let shift = (n - 1).trailing_zeros();
    let odd = (n - 1) >> shift;
    'bases: for a in bases {
        let (mut x, mut base, mut e) = (one, a, odd);
        while e > 0 {
            if e & 1 == 1 {
                x = times(x, base);
            }
            base = times(base, base);
            e >>= 1;
        }
        if x == one || x == n - one {
            continue;
        }
        for _ in 1..shift {
            x = times(x, x);
            if x == n - one {
                continue 'bases;
            }
        }
        return false;
    }
    true
}

impl FiniteField {
    /// log₂ of a lower bound for the number of primes that [`FiniteField::draw`] draws from.
    ///
    /// The primes q ≡ 3 (mod 4) with 2⁶¹ < q < 2⁶²: Σ ln q over them is at least 2⁶⁰·(1 − 0.01), as θ(x; 4, 3) differs from
    /// x/2 by less than 0.0023·x/2 for x ≥ 10¹⁰ ([Ramaré & Rumely 1996], table 1), and ln q < 43; hence more than 2⁵⁴ primes.
    ///
    /// [Ramaré & Rumely 1996]: https://doi.org/10.1090/S0025-5718-96-00669-2
    pub const LOG2_PRIMES: f64 = 54.0;

    /// log₂ of a lower bound for p.
    pub const LOG2_P: f64 = 61.0;

    /// The field for a prime p ≡ 3 (mod 4) with 2⁶⁰ < p < 2⁶²; `None` for any other number.
    pub fn new(p: u64) -> Option<FiniteField> {
        (p & 3 == 3 && p > 1 << 60 && p < 1 << 62 && is_prime(p)).then(|| FiniteField::of_prime(p))
    }

    fn of_prime(p: u64) -> FiniteField {
        // Newton: each step doubles the number of correct bits of p⁻¹ mod 2⁶⁴.
        let mut inverse = p;
        for _ in 0..5 {
            inverse = inverse.wrapping_mul(2u64.wrapping_sub(p.wrapping_mul(inverse)));
        }
        let one = ((1u128 << 64) % u128::from(p)) as u64;
        let r2 = (u128::from(one) * u128::from(one) % u128::from(p)) as u64;
        FiniteField { p, neg_inverse: inverse.wrapping_neg(), r2, one }
    }

    /// A field whose prime is uniform among the primes p ≡ 3 (mod 4) with 2⁶¹ < p < 2⁶².
    pub fn draw(draws: &mut Draws) -> FiniteField {
        loop {
            let p = (1 << 61) | (draws.bits() & ((1 << 61) - 1)) | 3;
            if is_prime(p) {
                return FiniteField::of_prime(p);
            }
        }
    }

    /// The prime.
    pub fn prime(&self) -> u64 {
        self.p
    }

    /// t·2⁻⁶⁴ mod p for t < 2¹²⁶.
    #[inline]
    fn reduce(&self, t: u128) -> u64 {
        let m = (t as u64).wrapping_mul(self.neg_inverse);
        let r = ((t + u128::from(m) * u128::from(self.p)) >> 64) as u64;
        // t < 2p², p < 2⁶² ⇒ r < p·(2p/2⁶⁴ + 1) < 2p.
        if r >= self.p { r - self.p } else { r }
    }
    #[inline]
    fn times(&self, a: u64, b: u64) -> u64 {
        self.reduce(u128::from(a) * u128::from(b))
    }
    #[inline]
    fn plus(&self, a: u64, b: u64) -> u64 {
        let s = a + b;
        if s >= self.p { s - self.p } else { s }
    }
    #[inline]
    fn minus(&self, a: u64, b: u64) -> u64 {
        if a >= b { a - b } else { a + self.p - b }
    }
    #[inline]
    fn negative(&self, a: u64) -> u64 {
        if a == 0 { 0 } else { self.p - a }
    }
    fn power(&self, a: u64, mut e: u64) -> u64 {
        let (mut base, mut acc) = (a, self.one);
        while e > 0 {
            if e & 1 == 1 {
                acc = self.times(acc, base);
            }
            base = self.times(base, base);
            e >>= 1;
        }
        acc
    }
    /// 1/a in GF(p) for a ≠ 0, by Euclid's algorithm: half the time of the power a^(p−2).
    ///
    /// The cofactors alternate in sign and stay at most p, so that 64 bits hold their magnitudes. As a stands for a·2⁻⁶⁴, two
    /// products with 2¹²⁸ bring the inverse back into Montgomery's form.
    fn reciprocal(&self, a: u64) -> u64 {
        let (mut r, mut next) = (self.p, a);
        let (mut cofactor, mut following) = (0u64, 1u64);
        let mut negative = true;
        while next != 0 {
            let q = r / next;
            (r, next) = (next, r - q * next);
            (cofactor, following) = (following, cofactor + q * following);
            negative = !negative;
        }
        let inverse = if negative { self.p - cofactor } else { cofactor };
        self.times(self.times(inverse, self.r2), self.r2)
    }
    /// √a in GF(p): a^((p+1)/4), if its square is a.
    fn prime_root(&self, a: u64) -> Option<u64> {
        let r = self.power(a, (self.p + 1) >> 2);
        (self.times(r, r) == a).then_some(r)
    }

    /// The element n mod p.
    pub fn integer(&self, n: i64) -> Finite {
        let residue = self.times(n.unsigned_abs() % self.p, self.r2);
        Finite { re: if n < 0 { self.negative(residue) } else { residue }, im: 0 }
    }

    /// The residue 0 ≤ n < p of an element of GF(p), and the coefficient of i.
    pub fn residues(&self, a: Finite) -> (u64, u64) {
        (self.reduce(u128::from(a.re)), self.reduce(u128::from(a.im)))
    }

    /// The element i.
    pub fn imaginary_unit(&self) -> Finite {
        Finite { re: 0, im: self.one }
    }

    /// A uniform element of GF(p).
    pub fn draw_element(&self, draws: &mut Draws) -> Finite {
        // Montgomery form is a bijection, so a uniform representation is a uniform element.
        Finite { re: draws.below(self.p), im: 0 }
    }

    /// a + b.
    #[inline]
    pub fn sum(&self, a: Finite, b: Finite) -> Finite {
        Finite { re: self.plus(a.re, b.re), im: self.plus(a.im, b.im) }
    }

    /// a − b.
    #[inline]
    pub fn difference(&self, a: Finite, b: Finite) -> Finite {
        Finite { re: self.minus(a.re, b.re), im: self.minus(a.im, b.im) }
    }

    /// a · b.
    #[inline]
    pub fn product(&self, a: Finite, b: Finite) -> Finite {
        if a.im | b.im == 0 {
            return Finite { re: self.times(a.re, b.re), im: 0 };
        }
        let wide = |x: u64, y: u64| u128::from(x) * u128::from(y);
        Finite {
            re: self.reduce(wide(a.re, b.re) + wide(self.negative(a.im), b.im)),
            im: self.reduce(wide(a.re, b.im) + wide(a.im, b.re)),
        }
    }

    /// 1/a; `None` for 0. In GF(p²), 1/(x + yi) = (x − yi)/(x² + y²).
    pub fn inverse(&self, a: Finite) -> Option<Finite> {
        if a.is_zero() {
            return None;
        }
        if a.im == 0 {
            return Some(Finite { re: self.reciprocal(a.re), im: 0 });
        }
        let norm = self.plus(self.times(a.re, a.re), self.times(a.im, a.im));
        let n = self.reciprocal(norm);
        Some(Finite { re: self.times(a.re, n), im: self.times(self.negative(a.im), n) })
    }

    /// Replaces every element by its inverse with one inversion (Montgomery's trick); false, and nothing changed, if one
    /// of them is 0.
    pub fn invert_all(&self, elements: &mut [Finite]) -> bool {
        let mut before = Vec::with_capacity(elements.len());
        let mut running = Finite { re: self.one, im: 0 };
        for &e in elements.iter() {
            before.push(running);
            running = self.product(running, e);
        }
        let Some(mut inverse) = self.inverse(running) else { return false };
        for (e, &b) in elements.iter_mut().zip(&before).rev() {
            let value = self.product(inverse, b);
            inverse = self.product(inverse, *e);
            *e = value;
        }
        true
    }

    /// A square root of a in GF(p²), if there is one. Every element of GF(p) has one.
    ///
    /// For a = x + yi with y ≠ 0: a is a square exactly when its norm x² + y² is a square s² in GF(p); then one of
    /// (x ± s)/2 is a square u² there, and the root is u + (y/2u)·i.
    pub fn square_root(&self, a: Finite) -> Option<Finite> {
        if a.im == 0 {
            return Some(match self.prime_root(a.re) {
                Some(r) => Finite { re: r, im: 0 },
                None => Finite { re: 0, im: self.prime_root(self.negative(a.re))? },
            });
        }
        let norm = self.plus(self.times(a.re, a.re), self.times(a.im, a.im));
        let s = self.prime_root(norm)?;
        let half = self.reciprocal(self.plus(self.one, self.one));
        let u = match self.prime_root(self.times(self.plus(a.re, s), half)) {
            Some(u) => u,
            None => self.prime_root(self.times(self.minus(a.re, s), half))?,
        };
        let v = self.times(self.times(a.im, half), self.reciprocal(u));
        let root = Finite { re: u, im: v };
        (self.product(root, root) == a).then_some(root)
    }

    /// The element that stands for a rational; `None` when p divides the denominator.
    pub fn of_rational(&self, r: &Rational) -> Option<Finite> {
        let p = dashu_int::UBig::from(self.p);
        let residue = |n: &dashu_int::UBig| -> Finite {
            let word = u64::try_from(n % &p).unwrap_or(0);
            Finite { re: self.times(word, self.r2), im: 0 }
        };
        let (sign, magnitude) = r.numerator().clone().into_parts();
        let top = residue(&magnitude);
        let top = if sign == dashu_int::Sign::Negative { self.difference(Finite::default(), top) } else { top };
        let under = residue(r.denominator());
        if self.residues(under).0 == 1 { Some(top) } else { Some(self.product(top, self.inverse(under)?)) }
    }
}

impl super::Uniform for Finite {
    type Context = FiniteField;

    fn blank(_: &FiniteField) -> Finite {
        Finite::default()
    }
    /// A field has the operations that are written out, and no other.
    fn rule(&mut self, _: &FiniteField, _: Op, _: &Finite, _: &Finite) -> Result<(), NoValue> {
        Err(NoValue::Unsupported)
    }
    fn rational(&mut self, f: &FiniteField, r: &Rational) -> Result<(), NoValue> {
        // A denominator divisible by p: another prime may do.
        *self = f.of_rational(r).ok_or(NoValue::Indeterminate)?;
        Ok(())
    }
    fn pi(&mut self, _: &FiniteField) -> Result<(), NoValue> {
        Err(NoValue::Unsupported)
    }
    fn restrict(&mut self, _: &FiniteField, a: &Finite, _: &Finite) -> Result<(), NoValue> {
        self.clone_from(a);
        Ok(())
    }
    fn powi(&mut self, f: &FiniteField, a: &Finite, n: i32) -> Result<(), NoValue> {
        let mut base = if n < 0 { f.inverse(*a).ok_or(NoValue::OutOfDomain)? } else { *a };
        let (mut e, mut acc) = (n.unsigned_abs(), f.integer(1));
        while e > 0 {
            if e & 1 == 1 {
                acc = f.product(acc, base);
            }
            base = f.product(base, base);
            e >>= 1;
        }
        *self = acc;
        Ok(())
    }
    fn neg(&mut self, f: &FiniteField, a: &Finite) -> Result<(), NoValue> {
        *self = f.difference(Finite::default(), *a);
        Ok(())
    }
    fn sqrt(&mut self, f: &FiniteField, a: &Finite) -> Result<(), NoValue> {
        // No root in GF(p²): at another point there may be one.
        *self = f.square_root(*a).ok_or(NoValue::Indeterminate)?;
        Ok(())
    }
    fn add(&mut self, f: &FiniteField, a: &Finite, b: &Finite) -> Result<(), NoValue> {
        *self = f.sum(*a, *b);
        Ok(())
    }
    fn sub(&mut self, f: &FiniteField, a: &Finite, b: &Finite) -> Result<(), NoValue> {
        *self = f.difference(*a, *b);
        Ok(())
    }
    fn mul(&mut self, f: &FiniteField, a: &Finite, b: &Finite) -> Result<(), NoValue> {
        *self = f.product(*a, *b);
        Ok(())
    }
    fn div(&mut self, f: &FiniteField, a: &Finite, b: &Finite) -> Result<(), NoValue> {
        *self = f.product(*a, f.inverse(*b).ok_or(NoValue::OutOfDomain)?);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn field_laws_at_random() {
        let mut draws = Draws::new(7);
        let mut fields = vec![FiniteField::new((1 << 61) - 1).unwrap()];
        fields.extend((0..8).map(|_| FiniteField::draw(&mut draws)));
        for f in &fields {
            assert!(is_prime(f.prime()) && f.prime() & 3 == 3);
            assert_eq!(f.product(f.imaginary_unit(), f.imaginary_unit()), f.integer(-1));
            let mut roots = 0;
            for _ in 0..200 {
                let pair = |d: &mut Draws| f.sum(f.draw_element(d), f.product(f.imaginary_unit(), f.draw_element(d)));
                let (a, b, c) = (pair(&mut draws), pair(&mut draws), pair(&mut draws));
                let left = f.product(a, f.sum(b, c));
                assert_eq!(left, f.sum(f.product(a, b), f.product(a, c)));
                assert_eq!(f.product(a, f.product(b, c)), f.product(f.product(a, b), c));
                assert_eq!(f.product(a, f.inverse(a).unwrap()), f.integer(1));
                let own = f.draw_element(&mut draws);
                assert_eq!(f.reciprocal(own.re), f.power(own.re, f.prime() - 2));
                if let Some(r) = f.square_root(a) {
                    assert_eq!(f.product(r, r), a);
                    roots += 1;
                }
                let square = f.product(a, a);
                let r = f.square_root(square).unwrap();
                assert!(r == a || r == f.difference(Finite::default(), a));
                let real = f.draw_element(&mut draws);
                let r = f.square_root(real).unwrap();
                assert_eq!(f.product(r, r), real);
                let mut many = [a, b, c];
                assert!(f.invert_all(&mut many));
                assert_eq!(many[1], f.inverse(b).unwrap());
            }
            assert!((60..140).contains(&roots), "about half of GF(p²) are squares, saw {roots} of 200");
        }
        // Both ways of computing agree.
        for n in (1 << 61..(1 << 61) + 4000).step_by(2).map(|n: u64| n | 1).chain((41..2000).step_by(2)) {
            let plain = (3..2000).step_by(2).take_while(|d| d * d <= n).all(|d| n % d != 0);
            let times = |a: u64, b: u64| (u128::from(a) * u128::from(b) % u128::from(n)) as u64;
            let wide = plain && is_probable(n, [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37], 1, times);
            assert_eq!(is_prime(n), wide, "{n}");
        }
        assert!(is_prime(2) && is_prime(37) && !is_prime(1) && !is_prime(3_215_031_751) && is_prime((1 << 61) - 1));
    }

    #[test]
    fn rationals() {
        let f = FiniteField::new((1 << 61) - 1).unwrap();
        let r = Rational::from(-7) / Rational::from(3);
        let e = f.of_rational(&r).unwrap();
        assert_eq!(f.product(e, f.integer(3)), f.integer(-7));
        assert!(f.of_rational(&(Rational::ONE / Rational::from((1u64 << 61) - 1))).is_none());
    }
}
