//! Functions of one real variable that are known exactly: cut at rational points, a rational function on each piece.
//!
//! In: polynomials with rational coefficients and the operations of `term.rs`. Out: for each open interval between two cuts,
//! and for each cut, the value: none, an exact rational function, or, of what is no rational function, the sign.
//! Guaranteed: every zero and every hole is a cut, found exactly; what has a zero that is not rational is refused
//! ([`Irrational`]), never rounded. No code of the program is used here: this is what its verdicts are compared with.

use dashu_ratio::RBig;

/// A rational number.
pub type Q = RBig;

/// The truth could not be computed exactly: the draw is dropped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Irrational;

/// A whole number.
pub fn whole(n: i64) -> Q {
    Q::from(n)
}

/// A fraction.
pub fn fraction(n: i64, d: i64) -> Q {
    Q::from(n) / Q::from(d)
}

/// −1, 0 or 1.
pub fn sign_of(q: &Q) -> i8 {
    match q.cmp(&Q::ZERO) {
        std::cmp::Ordering::Less => -1,
        std::cmp::Ordering::Equal => 0,
        std::cmp::Ordering::Greater => 1,
    }
}

/// A polynomial, lowest coefficient first, without zeros at the end.
#[derive(Clone, Debug, PartialEq)]
pub struct Polynomial(Vec<Q>);

impl Polynomial {
    pub fn new(mut c: Vec<Q>) -> Polynomial {
        while c.last().is_some_and(Q::is_zero) {
            c.pop();
        }
        Polynomial(c)
    }

    pub fn constant(q: Q) -> Polynomial {
        Polynomial::new(vec![q])
    }

    pub fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    fn degree(&self) -> usize {
        self.0.len().saturating_sub(1)
    }

    fn leading(&self) -> Q {
        self.0.last().cloned().unwrap_or(Q::ZERO)
    }

    pub fn add(&self, other: &Polynomial) -> Polynomial {
        let n = self.0.len().max(other.0.len());
        let of = |p: &Polynomial, i: usize| p.0.get(i).cloned().unwrap_or(Q::ZERO);
        Polynomial::new((0..n).map(|i| of(self, i) + of(other, i)).collect())
    }

    pub fn times(&self, other: &Polynomial) -> Polynomial {
        if self.is_zero() || other.is_zero() {
            return Polynomial(Vec::new());
        }
        let mut c = vec![Q::ZERO; self.0.len() + other.0.len() - 1];
        for (i, a) in self.0.iter().enumerate() {
            for (j, b) in other.0.iter().enumerate() {
                c[i + j] += a * b;
            }
        }
        Polynomial::new(c)
    }

    pub fn scaled(&self, q: &Q) -> Polynomial {
        Polynomial::new(self.0.iter().map(|a| a * q).collect())
    }

    pub fn at(&self, x: &Q) -> Q {
        self.0.iter().rev().fold(Q::ZERO, |v, c| v * x + c)
    }

    fn rate(&self) -> Polynomial {
        Polynomial::new(self.0.iter().enumerate().skip(1).map(|(i, c)| c * whole(i as i64)).collect())
    }

    /// The quotient by x − r, where r is a zero.
    fn without(&self, r: &Q) -> Polynomial {
        let mut c = vec![Q::ZERO; self.degree()];
        let mut carry = Q::ZERO;
        for i in (0..self.degree()).rev() {
            carry = &self.0[i + 1] + &carry * r;
            c[i] = carry.clone();
        }
        Polynomial::new(c)
    }

    /// All real zeros, each once; refused where one is not rational, or cannot be seen to be.
    pub fn zeros(&self) -> Result<Vec<Q>, Irrational> {
        let mut rest = self.clone();
        let mut found = Vec::new();
        let mut cut = |r: Q, rest: &mut Polynomial| {
            while rest.degree() > 0 && rest.at(&r).is_zero() {
                *rest = rest.without(&r);
                if !found.contains(&r) {
                    found.push(r.clone());
                }
            }
        };
        // Zeros are drawn from these fractions; what is left is solved if it has degree 1 or 2.
        for d in [1, 2, 3, 5, 10, 7] {
            for n in -12 * d..=12 * d {
                if rest.degree() <= 2 {
                    break;
                }
                cut(fraction(n, d), &mut rest);
            }
        }
        let two = whole(2);
        match rest.degree() {
            0 => {}
            1 => cut(-&rest.0[0] / &rest.0[1], &mut rest),
            2 => {
                let (a, b, c) = (&rest.0[2], &rest.0[1], &rest.0[0]);
                let discriminant = b * b - whole(4) * a * c;
                if sign_of(&discriminant) >= 0 {
                    let root = root(&discriminant).ok_or(Irrational)?;
                    let (low, high) = ((-b - &root) / (&two * a), (-b + &root) / (&two * a));
                    cut(low, &mut rest);
                    cut(high, &mut rest);
                }
            }
            _ => return Err(Irrational),
        }
        Ok(found)
    }
}

/// The root of a square of a rational number.
pub fn root(q: &Q) -> Option<Q> {
    if sign_of(q) < 0 {
        return None;
    }
    let whole_root = |n: i128| -> Option<i128> {
        let r = (n as f64).sqrt().round() as i128;
        (r.checked_mul(r)? == n).then_some(r)
    };
    let n = whole_root(i128::try_from(q.numerator().clone()).ok()?)?;
    let d = whole_root(i128::try_from(q.denominator().clone()).ok()?)?;
    Some(Q::from(n) / Q::from(d))
}

/// What a function is on one piece.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// It has none.
    Nothing,
    /// A quotient of polynomials, whose denominator has no zero on the piece.
    Quotient(Polynomial, Polynomial),
    /// No rational function, with this sign on the whole piece.
    Sign(i8),
}

impl Value {
    pub fn number(q: Q) -> Value {
        Value::Quotient(Polynomial::constant(q), Polynomial::constant(Q::ONE))
    }

    /// The sign at a point inside of a piece on which it does not change.
    pub fn sign(&self, inside: &Q) -> Option<i8> {
        match self {
            Value::Nothing => None,
            Value::Quotient(n, d) => Some(sign_of(&n.at(inside)) * sign_of(&d.at(inside))),
            Value::Sign(s) => Some(*s),
        }
    }

    /// The number that it is at all points of the piece, if it is one.
    pub fn same_number(&self, inside: &Q) -> Result<Option<Q>, Irrational> {
        match self {
            Value::Nothing => Ok(None),
            Value::Sign(0) => Ok(Some(Q::ZERO)),
            Value::Sign(_) => Err(Irrational),
            Value::Quotient(n, d) => {
                let q = n.at(inside) / d.at(inside);
                Ok(n.add(&d.scaled(&-&q)).is_zero().then_some(q))
            }
        }
    }

    /// The limit at a point of the piece's edge: `None` if it has no finite one.
    pub fn limit(&self, at: &Q) -> Result<Option<Q>, Irrational> {
        match self {
            Value::Nothing | Value::Sign(_) => Err(Irrational),
            Value::Quotient(n, d) => {
                let (n, d) = reduced(n, d, at);
                Ok((!d.at(at).is_zero()).then(|| n.at(at) / d.at(at)))
            }
        }
    }

    /// The limit at infinity.
    pub fn limit_at_infinity(&self) -> Result<Option<Q>, Irrational> {
        match self {
            Value::Nothing | Value::Sign(_) => Err(Irrational),
            Value::Quotient(n, _) if n.is_zero() => Ok(Some(Q::ZERO)),
            Value::Quotient(n, d) => Ok(match n.degree().cmp(&d.degree()) {
                std::cmp::Ordering::Less => Some(Q::ZERO),
                std::cmp::Ordering::Equal => Some(n.leading() / d.leading()),
                std::cmp::Ordering::Greater => None,
            }),
        }
    }

    /// The rate on an open piece.
    pub fn rate(&self) -> Result<Value, Irrational> {
        match self {
            Value::Nothing => Ok(Value::Nothing),
            Value::Sign(0) => Ok(Value::number(Q::ZERO)),
            Value::Sign(_) => Err(Irrational),
            Value::Quotient(n, d) => {
                let above = n.rate().times(d).add(&n.times(&d.rate()).scaled(&whole(-1)));
                Ok(Value::Quotient(above, d.times(d)))
            }
        }
    }
}

/// A quotient without the common factors x − at.
fn reduced(n: &Polynomial, d: &Polynomial, at: &Q) -> (Polynomial, Polynomial) {
    let (mut n, mut d) = (n.clone(), d.clone());
    while !n.is_zero() && n.at(at).is_zero() && d.at(at).is_zero() {
        (n, d) = (n.without(at), d.without(at));
    }
    if n.is_zero() {
        d = Polynomial::constant(Q::ONE);
    }
    (n, d)
}

/// What a piece holds.
pub trait Piece: Clone {
    /// Of an open piece, what it is at one of its points.
    fn at(&self, point: &Q) -> Self;
}

impl Piece for Value {
    fn at(&self, point: &Q) -> Value {
        match self {
            Value::Quotient(n, d) => Value::number(n.at(point) / d.at(point)),
            Value::Nothing | Value::Sign(_) => self.clone(),
        }
    }
}

impl Piece for bool {
    fn at(&self, _: &Q) -> bool {
        *self
    }
}

/// The real line, cut: open pieces and cuts in turn, `pieces[2i + 1]` being the cut `cuts[i]`.
#[derive(Clone, Debug, PartialEq)]
pub struct Line<P> {
    pub cuts: Vec<Q>,
    pub pieces: Vec<P>,
}

impl<P: Piece> Line<P> {
    pub fn constant(p: P) -> Line<P> {
        Line { cuts: Vec::new(), pieces: vec![p] }
    }

    /// A point of each piece.
    pub fn inside(&self, i: usize) -> Q {
        let (n, k) = (self.cuts.len(), i / 2);
        if i % 2 == 1 {
            return self.cuts[k].clone();
        }
        match (k.checked_sub(1).map(|j| &self.cuts[j]), (k < n).then(|| &self.cuts[k])) {
            (None, None) => Q::ZERO,
            (Some(a), None) => a + whole(1),
            (None, Some(b)) => b - whole(1),
            (Some(a), Some(b)) => (a + b) / whole(2),
        }
    }

    /// The same with further cuts.
    pub fn cut(&self, more: &[Q]) -> Line<P> {
        let mut cuts: Vec<Q> = self.cuts.iter().chain(more).cloned().collect();
        cuts.sort();
        cuts.dedup();
        let mut pieces = Vec::with_capacity(2 * cuts.len() + 1);
        let mut old = 0;
        for c in &cuts {
            pieces.push(self.pieces[2 * old].clone());
            if self.cuts.get(old) == Some(c) {
                pieces.push(self.pieces[2 * old + 1].clone());
                old += 1;
            } else {
                pieces.push(self.pieces[2 * old].at(c));
            }
        }
        pieces.push(self.pieces[2 * old].clone());
        Line { cuts, pieces }
    }

    pub fn zip<R: Piece, S>(&self, other: &Line<R>, f: impl Fn(&P, &R) -> S) -> Line<S> {
        let (a, b) = (self.cut(&other.cuts), other.cut(&self.cuts));
        let pieces = a.pieces.iter().zip(&b.pieces).map(|(p, r)| f(p, r)).collect();
        Line { cuts: a.cuts, pieces }
    }

    pub fn map<S>(&self, f: impl Fn(&P) -> S) -> Line<S> {
        Line { cuts: self.cuts.clone(), pieces: self.pieces.iter().map(f).collect() }
    }

    /// The pieces that lie in a closed range, by their places.
    pub fn within(&self, range: &Option<(Q, Q)>) -> Vec<usize> {
        let inside = |i: &usize| range.as_ref().is_none_or(|(a, b)| *a <= self.inside(*i) && self.inside(*i) <= *b);
        (0..self.pieces.len()).filter(inside).collect()
    }
}

impl Line<Value> {
    /// Cut at all zeros, too.
    pub fn cut_at_zeros(&self) -> Result<Line<Value>, Irrational> {
        let mut cuts = Vec::new();
        for (i, p) in self.pieces.iter().enumerate().step_by(2) {
            if let Value::Quotient(n, _) = p {
                let (low, high) = (i.checked_sub(2).map(|j| &self.cuts[j / 2]), self.cuts.get(i / 2));
                let here = |q: &Q| low.is_none_or(|l| l < q) && high.is_none_or(|h| q < h);
                cuts.extend(n.zeros()?.into_iter().filter(here));
            }
        }
        Ok(self.cut(&cuts))
    }

    /// Each piece by its sign.
    pub fn by_sign(&self, f: impl Fn(&Value, Option<i8>) -> Value) -> Result<Line<Value>, Irrational> {
        let line = self.cut_at_zeros()?;
        let pieces = (0..line.pieces.len()).map(|i| f(&line.pieces[i], line.pieces[i].sign(&line.inside(i)))).collect();
        Ok(Line { cuts: line.cuts, pieces })
    }

    /// The rate: at a cut from the sides that have values, which must agree with the value and with each other.
    pub fn rate(&self) -> Result<Line<Value>, Irrational> {
        let mut pieces = Vec::new();
        for (i, p) in self.pieces.iter().enumerate() {
            if i % 2 == 0 {
                pieces.push(p.rate()?);
                continue;
            }
            let at = &self.cuts[i / 2];
            let Some(value) = p.same_number(at)? else {
                pieces.push(Value::Nothing);
                continue;
            };
            let mut rates = Vec::new();
            for side in [&self.pieces[i - 1], &self.pieces[i + 1]] {
                if *side != Value::Nothing {
                    let continuous = side.limit(at)? == Some(value.clone());
                    rates.push(if continuous { side.rate()?.limit(at)? } else { None });
                }
            }
            let first = rates.first().cloned().flatten();
            let agree = rates.iter().all(|r| r.is_some() && *r == first);
            pieces.push(first.filter(|_| agree).map_or(Value::Nothing, Value::number));
        }
        Ok(Line { cuts: self.cuts.clone(), pieces })
    }
}
