//! Values on a piece of time: rational functions times powers of π, and sines and cosines of turns.
//!
//! **In:** an operation and the values of its arguments, on an open piece of time or at one time. **Out:** its value there; that it has
//! none; that the piece must be parted first, since something changes its sign within; or that this is not known here. **Guaranteed:** a
//! value is exact on the whole piece.

use super::polynomial::{Fraction, Polynomial};
use crate::expr::{Op, Rational};

/// A function on a piece of time.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Value {
    /// f·πᵏ; where f is 0, k is 0.
    Plain(Fraction, i32),
    /// f·πᵏ·√u, with a polynomial u that is positive on the piece, and no square.
    Root(Fraction, i32, Polynomial),
    /// ± the sine, or the cosine, of π·f.
    Wave { cosine: bool, negative: bool, of: Fraction },
}

/// Why there is no value to work with.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Stop {
    /// There is none: an operation needs something that is not so.
    Void,
    /// It is not known here.
    Unknown,
    /// Something vanishes at this time.
    Part(Rational),
}

pub(super) type Found = Result<Value, Stop>;

/// A piece of time: open, or one time.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Cell {
    Open(Rational, Rational),
    At(Rational),
}

impl Cell {
    /// A time of it.
    pub(super) fn inside(&self) -> Rational {
        match self {
            Cell::Open(low, high) => (low + high) / Rational::from(2),
            Cell::At(t) => t.clone(),
        }
    }

    /// The sign of a fraction on all of it.
    pub(super) fn sign(&self, f: &Fraction) -> Result<std::cmp::Ordering, Stop> {
        if f.is_zero() {
            return Ok(std::cmp::Ordering::Equal);
        }
        if let Cell::Open(low, high) = self {
            for p in [&f.top, &f.under] {
                if let Some(first) = p.zeros(low, high).ok_or(Stop::Unknown)?.into_iter().next() {
                    return Err(Stop::Part(first));
                }
            }
        }
        let value = f.at(&self.inside()).ok_or(Stop::Void)?;
        Ok(value.cmp(&Rational::ZERO))
    }
}

pub(super) fn plain(f: Fraction) -> Value {
    Value::Plain(f, 0)
}

fn number(value: i64) -> Value {
    plain(Fraction::constant(Rational::from(value)))
}

fn times_pi(f: Fraction) -> Value {
    let turns = i32::from(!f.is_zero());
    Value::Plain(f, turns)
}

fn ratio(top: i64, under: i64) -> Rational {
    Rational::from(top) / Rational::from(under)
}

/// ± sin πf or cos πf; a number where 2f is whole.
fn wave(cosine: bool, negative: bool, of: Fraction) -> Value {
    let Some(c) = of.as_constant() else { return Value::Wave { cosine, negative, of } };
    // In twelfths of half a turn, counted as a sine.
    let shifted = if cosine { c + ratio(1, 2) } else { c };
    let sixths = shifted * Rational::from(6);
    let twelve = Rational::from(12);
    let rest = &sixths - Rational::from((&sixths / &twelve).floor()) * &twelve;
    // Those of which sine and cosine are both rational: an angle is made of both.
    let exact = [0, 3, 6, 9].into_iter().find(|&n| rest == Rational::from(n));
    let value = match exact {
        Some(0 | 6) => Rational::ZERO,
        Some(3) => Rational::ONE,
        Some(9) => Rational::NEG_ONE,
        _ => return Value::Wave { cosine, negative, of },
    };
    plain(Fraction::constant(if negative { -value } else { value }))
}

/// The angle of a point of the unit circle, in units of π: in (−1, 1].
fn reduced(of: Fraction, cell: &Cell) -> Found {
    let polynomial = of.as_polynomial().ok_or(Stop::Unknown)?;
    let (one, two) = (Rational::ONE, Rational::from(2));
    let turns = Rational::from(((polynomial.at(&cell.inside()) - &one) / &two).ceil());
    let inner = polynomial.sub(&Polynomial::constant(turns * two));
    if let Cell::Open(low, high) = cell {
        for end in [Rational::ONE, Rational::NEG_ONE] {
            let beyond = inner.sub(&Polynomial::constant(end));
            if let Some(first) = beyond.zeros(low, high).ok_or(Stop::Unknown)?.into_iter().next() {
                return Err(Stop::Part(first));
            }
        }
    }
    Ok(times_pi(Fraction::of(inner)))
}

fn angle(y: &Value, x: &Value, cell: &Cell) -> Found {
    use std::cmp::Ordering::{Equal, Greater, Less};
    let half = || Fraction::constant(ratio(1, 2));
    let (y, x) = match (y, x) {
        (Value::Wave { cosine: false, negative: down, of }, Value::Wave { cosine: true, negative: back, of: same })
            if of == same =>
        {
            let forward = if down == back { of.clone() } else { of.neg() };
            let one = Fraction::constant(Rational::ONE);
            let turned = if *back { forward.add(&one).ok_or(Stop::Unknown)? } else { forward };
            return reduced(turned, cell);
        }
        (Value::Plain(y, k), Value::Plain(x, l)) if k == l || y.is_zero() || x.is_zero() => (y, x),
        _ => return Err(Stop::Unknown),
    };
    match (cell.sign(y)?, cell.sign(x)?) {
        (Equal, Equal) => Err(Stop::Void),
        (Equal, Greater) => Ok(number(0)),
        (Equal, Less) => Ok(times_pi(Fraction::constant(Rational::ONE))),
        (Greater, Equal) => Ok(times_pi(half())),
        (Less, Equal) => Ok(times_pi(half().neg())),
        (up, right) if *y == *x || *y == x.neg() => {
            let quarters = match (up, right) {
                (Greater, Greater) => 1,
                (Greater, _) => 3,
                (_, Greater) => -1,
                (_, _) => -3,
            };
            Ok(times_pi(Fraction::constant(ratio(quarters, 4))))
        }
        _ => Err(Stop::Unknown),
    }
}

/// The value of an inverse function at a few numbers.
fn at_number(f: &Fraction, table: &[(Rational, Rational)]) -> Found {
    let c = f.as_constant().ok_or(Stop::Unknown)?;
    let found = table.iter().find(|(at, _)| *at == c).ok_or(Stop::Unknown)?;
    Ok(times_pi(Fraction::constant(found.1.clone())))
}

fn power(f: &Fraction, k: i32, n: i32, cell: &Cell) -> Found {
    if n < 0 && cell.sign(f)?.is_eq() {
        return Err(Stop::Void);
    }
    if n.unsigned_abs() > 16 {
        return Err(Stop::Unknown);
    }
    let base = if n < 0 { f.inverse().ok_or(Stop::Void)? } else { f.clone() };
    let mut out = Fraction::constant(Rational::ONE);
    for _ in 0..n.unsigned_abs() {
        out = out.mul(&base).ok_or(Stop::Unknown)?;
    }
    let turns = if out.is_zero() { 0 } else { k * n };
    Ok(Value::Plain(out, turns))
}

fn root(f: &Fraction, cell: &Cell) -> Found {
    if cell.sign(f)?.is_lt() {
        return Err(Stop::Void);
    }
    let square = f.top.mul(&f.under).ok_or(Stop::Unknown)?;
    let positive = |e: Fraction| Ok(if cell.sign(&e)?.is_lt() { e.neg() } else { e });
    match square.root() {
        Some(root) => Ok(plain(positive(Fraction::new(root, f.under.clone()).ok_or(Stop::Unknown)?)?)),
        None => {
            let one = Polynomial::constant(Rational::ONE);
            Ok(Value::Root(positive(Fraction::new(one, f.under.clone()).ok_or(Stop::Unknown)?)?, 0, square))
        }
    }
}

/// An operation in which roots take part.
fn with_roots(op: Op, a: &Value, b: &Value) -> Found {
    let parts = |v: &Value| match v {
        Value::Plain(f, k) => Ok((f.clone(), *k, None)),
        Value::Root(f, k, u) => Ok((f.clone(), *k, Some(u.clone()))),
        Value::Wave { .. } => Err(Stop::Unknown),
    };
    let ((f, k, u), (g, l, v)) = (parts(a)?, parts(b)?);
    let made = |f: Option<Fraction>, k: i32, u: Option<Polynomial>| {
        let f = f.ok_or(Stop::Unknown)?;
        Ok(match (f.is_zero(), u) {
            (true, _) => number(0),
            (false, None) => Value::Plain(f, k),
            (false, Some(u)) => Value::Root(f, k, u),
        })
    };
    match op {
        Op::Add | Op::Sub => {
            let (g, same) = (if op == Op::Sub { g.neg() } else { g }, u == v && k == l);
            match (f.is_zero(), g.is_zero()) {
                (_, true) => made(Some(f), k, u),
                (true, false) => made(Some(g), l, v),
                (false, false) if same => made(f.add(&g), k, u),
                (false, false) => Err(Stop::Unknown),
            }
        }
        Op::Mul => match (u, v) {
            (Some(u), Some(v)) if u == v => made(f.mul(&g).and_then(|fg| fg.mul(&Fraction::of(u))), k + l, None),
            (Some(_), Some(_)) => Err(Stop::Unknown),
            (u, v) => made(f.mul(&g), k + l, u.or(v)),
        },
        Op::Div => match (u, v) {
            (Some(u), Some(v)) if u == v => made(g.inverse().and_then(|g| f.mul(&g)), k - l, None),
            (Some(_), Some(_)) => Err(Stop::Unknown),
            (u, None) => made(g.inverse().and_then(|g| f.mul(&g)), k - l, u),
            (None, Some(v)) => {
                let under = g.mul(&Fraction::of(v.clone())).and_then(|g| g.inverse());
                made(under.and_then(|g| f.mul(&g)), k - l, Some(v))
            }
        },
        Op::Pow | Op::Arctan2 | Op::Agm | Op::DirectionCosine | Op::Restrict | Op::Powi(_) | Op::Neg | Op::Sqrt => {
            Err(Stop::Unknown)
        }
        Op::Exp | Op::Ln | Op::Sin | Op::Cos | Op::Tan | Op::Arcsin | Op::Arccos | Op::Arctan => Err(Stop::Unknown),
        Op::Sinh | Op::Cosh | Op::Tanh | Op::Abs => Err(Stop::Unknown),
    }
}

fn of_one(op: Op, value: &Value, cell: &Cell) -> Found {
    let (f, k) = match (op, value) {
        (Op::Neg, Value::Wave { cosine, negative, of }) => return Ok(wave(*cosine, !negative, of.clone())),
        (Op::Neg, Value::Root(f, k, u)) => return Ok(Value::Root(f.neg(), *k, u.clone())),
        (Op::Abs, Value::Root(f, k, u)) => {
            let f = if cell.sign(f)?.is_lt() { f.neg() } else { f.clone() };
            return Ok(Value::Root(f, *k, u.clone()));
        }
        (Op::Powi(2), root @ Value::Root(..)) => return with_roots(Op::Mul, root, root),
        (_, Value::Wave { .. } | Value::Root(..)) => return Err(Stop::Unknown),
        (_, Value::Plain(f, k)) => (f, *k),
    };
    let is = |r: Rational| k == 0 && f.as_constant() == Some(r);
    match op {
        Op::Neg => Ok(Value::Plain(f.neg(), k)),
        Op::Abs => Ok(Value::Plain(if cell.sign(f)?.is_lt() { f.neg() } else { f.clone() }, k)),
        Op::Powi(n) => power(f, k, n, cell),
        Op::Sqrt if k == 0 => root(f, cell),
        Op::Sqrt if cell.sign(f)?.is_lt() => Err(Stop::Void),
        Op::Exp | Op::Cosh if f.is_zero() => Ok(number(1)),
        Op::Sinh | Op::Tanh | Op::Tan | Op::Arctan | Op::Arcsin if f.is_zero() => Ok(number(0)),
        Op::Ln if cell.sign(f)?.is_le() => Err(Stop::Void),
        Op::Ln if is(Rational::ONE) => Ok(number(0)),
        Op::Sin | Op::Cos if k == 1 || f.is_zero() => Ok(wave(op == Op::Cos, false, f.clone())),
        Op::Arctan if k == 0 => at_number(f, &[(Rational::ONE, ratio(1, 4)), (Rational::NEG_ONE, ratio(-1, 4))]),
        Op::Arcsin if k == 0 => at_number(f, &[(Rational::ONE, ratio(1, 2)), (Rational::NEG_ONE, ratio(-1, 2))]),
        Op::Arccos if k == 0 => at_number(
            f,
            &[(Rational::ONE, Rational::ZERO), (Rational::ZERO, ratio(1, 2)), (Rational::NEG_ONE, Rational::ONE)],
        ),
        Op::Sqrt | Op::Exp | Op::Ln | Op::Sin | Op::Cos | Op::Tan | Op::Arcsin | Op::Arccos | Op::Arctan => {
            Err(Stop::Unknown)
        }
        Op::Sinh | Op::Cosh | Op::Tanh => Err(Stop::Unknown),
        Op::Add
        | Op::Sub
        | Op::Mul
        | Op::Div
        | Op::Pow
        | Op::Arctan2
        | Op::Agm
        | Op::DirectionCosine
        | Op::Restrict => Err(Stop::Unknown),
    }
}

/// The value of an operation on a piece.
pub(super) fn apply(op: Op, a: &Value, b: Option<&Value>, cell: &Cell) -> Found {
    let Some(b) = b else { return of_one(op, a, cell) };
    if op == Op::Arctan2 {
        return angle(a, b, cell);
    }
    if op == Op::Restrict {
        return Ok(a.clone());
    }
    let (Value::Plain(f, k), Value::Plain(g, l)) = (a, b) else {
        return match (op, b) {
            (Op::Div, Value::Plain(g, _)) if cell.sign(g)?.is_eq() => Err(Stop::Void),
            (..) => with_roots(op, a, b),
        };
    };
    let made = |f: Option<Fraction>, k: i32| {
        let f = f.ok_or(Stop::Unknown)?;
        let turns = if f.is_zero() { 0 } else { k };
        Ok(Value::Plain(f, turns))
    };
    match op {
        Op::Add | Op::Sub if k == l || f.is_zero() || g.is_zero() => {
            let other = if op == Op::Sub { g.neg() } else { g.clone() };
            made(f.add(&other), if f.is_zero() { *l } else { *k })
        }
        Op::Mul => made(f.mul(g), k + l),
        Op::Div if cell.sign(g)?.is_eq() => Err(Stop::Void),
        Op::Div => made(f.mul(&g.inverse().ok_or(Stop::Void)?), k - l),
        Op::Pow if cell.sign(f)?.is_lt() => Err(Stop::Void),
        Op::Pow if *l == 0 => {
            let exponent = g.as_constant().ok_or(Stop::Unknown)?;
            if f.is_zero() {
                return if exponent > Rational::ZERO { Ok(number(0)) } else { Err(Stop::Void) };
            }
            if exponent == ratio(1, 2) && *k == 0 {
                return root(f, cell);
            }
            let whole = i32::try_from(exponent.numerator()).map_err(|_| Stop::Unknown)?;
            if exponent.denominator().is_one() { power(f, *k, whole, cell) } else { Err(Stop::Unknown) }
        }
        Op::Agm if cell.sign(f)?.is_lt() || cell.sign(g)?.is_lt() => Err(Stop::Void),
        Op::Agm if f == g && k == l => Ok(a.clone()),
        Op::Agm if f.is_zero() || g.is_zero() => Ok(number(0)),
        Op::Add | Op::Sub | Op::Pow | Op::Agm | Op::Arctan2 | Op::DirectionCosine | Op::Restrict => Err(Stop::Unknown),
        Op::Neg | Op::Sqrt | Op::Abs | Op::Powi(_) | Op::Exp | Op::Ln | Op::Sin | Op::Cos => Err(Stop::Unknown),
        Op::Tan | Op::Arcsin | Op::Arccos | Op::Arctan | Op::Sinh | Op::Cosh | Op::Tanh => Err(Stop::Unknown),
    }
}

/// What remains of left − right, as a fraction with the same zeros; `None` where both are one function.
pub(super) fn difference(left: &Value, right: &Value) -> Result<Option<Fraction>, Stop> {
    if left == right {
        return Ok(None);
    }
    match (left, right) {
        (Value::Plain(f, k), Value::Plain(g, l)) if k == l || f.is_zero() || g.is_zero() => {
            f.add(&g.neg()).ok_or(Stop::Unknown).map(Some)
        }
        (Value::Root(f, k, u), Value::Root(g, l, v)) if k == l && u == v => {
            f.add(&g.neg()).ok_or(Stop::Unknown).map(Some)
        }
        // A root is not 0: it is positive where its factor is.
        (Value::Root(f, ..), Value::Plain(g, _)) if g.is_zero() => Ok(Some(f.clone())),
        (Value::Plain(f, _), Value::Root(g, ..)) if f.is_zero() => Ok(Some(g.neg())),
        _ => Err(Stop::Unknown),
    }
}

impl Value {
    /// It at a time of its piece, in words.
    pub(super) fn shown(&self, t: &Rational) -> Option<String> {
        let (f, k, root) = match self {
            Value::Plain(f, k) => (f, k, String::new()),
            Value::Root(f, k, u) => (f, k, format!(" √({})", u.at(t))),
            Value::Wave { .. } => return None,
        };
        let c = f.at(t)?;
        if !root.is_empty() {
            let turns = if *k == 0 { String::new() } else { format!(" π^{k}") };
            return Some(format!("({c}){turns}{root}"));
        }
        Some(match (*k, c == Rational::ONE) {
            (0, _) => c.to_string(),
            (1, true) => "π".to_owned(),
            (1, false) => format!("({c}) π"),
            (k, _) => format!("({c}) π^{k}"),
        })
    }
}
