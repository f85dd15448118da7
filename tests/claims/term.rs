//! Terms of random claims: how they are written in LaTeX, and what they are, exactly, as functions of t.
//!
//! In every scene y is 2, a is 3/2, and x is one of a few [`Motion`]s, so that a term is a function of one variable whose zeros
//! and holes are known.

use super::line::{Irrational, Line, Polynomial, Q, Value, fraction, root, sign_of, whole};

/// Functions of one variable of which the domain and the sign are known, but which are no rational functions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Function {
    Root,
    Logarithm,
    Exponential,
    ArcTangent,
    HyperbolicTangent,
    HyperbolicSine,
    ArcSine,
    ArcCosine,
    /// e^{0.3}
    Power,
    /// e^{-0.5}
    InversePower,
    /// agm(e, 1)
    Mean,
    /// atan2(e, 0)
    Angle,
}

pub const FUNCTIONS: [Function; 12] = [
    Function::Root,
    Function::Logarithm,
    Function::Exponential,
    Function::ArcTangent,
    Function::HyperbolicTangent,
    Function::HyperbolicSine,
    Function::ArcSine,
    Function::ArcCosine,
    Function::Power,
    Function::InversePower,
    Function::Mean,
    Function::Angle,
];

#[derive(Clone, Debug, PartialEq)]
pub enum Term {
    Number(Q),
    X,
    Y,
    A,
    /// The time.
    T,
    /// An unknown of `exists`, which stands for a number that is put in for it.
    U,
    Neg(Box<Term>),
    Add(Box<Term>, Box<Term>),
    Sub(Box<Term>, Box<Term>),
    Mul(Box<Term>, Box<Term>),
    Div(Box<Term>, Box<Term>),
    Power(Box<Term>, i32),
    Abs(Box<Term>),
    Of(Function, Box<Term>),
    Rate(Box<Term>),
    /// A value at a time.
    At(Box<Term>, Q),
    /// ±, and ∓ if the flag is false.
    Signed(bool, Box<Term>),
    /// A symbol `k` that stands for a term.
    Named(Box<Term>),
}

use Term::{A, Abs, Add, At, Div, Mul, Named, Neg, Number, Of, Power, Rate, Signed, Sub, T, U, X, Y};

pub fn number(n: i64) -> Term {
    Number(whole(n))
}

pub fn add(a: Term, b: Term) -> Term {
    Add(Box::new(a), Box::new(b))
}

pub fn sub(a: Term, b: Term) -> Term {
    Sub(Box::new(a), Box::new(b))
}

pub fn mul(a: Term, b: Term) -> Term {
    Mul(Box::new(a), Box::new(b))
}

pub fn div(a: Term, b: Term) -> Term {
    Div(Box::new(a), Box::new(b))
}

pub fn power(a: Term, n: i32) -> Term {
    Power(Box::new(a), n)
}

pub fn abs(a: Term) -> Term {
    Abs(Box::new(a))
}

pub fn of(f: Function, a: Term) -> Term {
    Of(f, Box::new(a))
}

pub fn rate(a: Term) -> Term {
    Rate(Box::new(a))
}

pub fn signed(upper: bool, a: Term) -> Term {
    Signed(upper, Box::new(a))
}

/// A number as LaTeX.
pub fn latex_number(q: &Q) -> String {
    let (n, d) = (q.numerator().to_string(), q.denominator().to_string());
    match (d.as_str(), n.strip_prefix('-')) {
        ("1", _) => n,
        (_, Some(n)) => format!(r"-\frac{{{n}}}{{{d}}}"),
        (_, None) => format!(r"\frac{{{n}}}{{{d}}}"),
    }
}

/// A number of a TOML file that stands for itself: a quoted formula.
pub fn toml_number(q: &Q) -> String {
    if q.denominator().to_string() == "1" { q.to_string() } else { format!("'{}'", latex_number(q)) }
}

impl Term {
    /// As LaTeX, with parentheses wherever they could be wanted.
    pub fn latex(&self) -> String {
        match self {
            Number(q) => latex_number(q),
            X => "x".to_owned(),
            Y => "y".to_owned(),
            A => "a".to_owned(),
            T => "t".to_owned(),
            U => "u".to_owned(),
            Neg(e) => format!("-{}", e.factor()),
            Add(e, f) => match &**f {
                Signed(true, g) => format!(r"{}\pm {}", e.latex(), g.factor()),
                Signed(false, g) => format!(r"{}\mp {}", e.latex(), g.factor()),
                _ => format!("{}+{}", e.latex(), f.factor()),
            },
            Sub(e, f) => format!("{}-{}", e.latex(), f.factor()),
            Mul(e, f) => format!(r"{}\cdot {}", e.factor(), f.factor()),
            Div(e, f) => format!(r"\frac{{{}}}{{{}}}", e.latex(), f.latex()),
            Power(e, n) => format!("{}^{{{n}}}", e.factor()),
            Abs(e) => format!(r"\left|{}\right|", e.latex()),
            Of(f, e) => f.latex(&e.latex()),
            Rate(e) => match &**e {
                X => r"\dot x".to_owned(),
                e => format!(r"\frac{{d}}{{dt}}\left({}\right)", e.latex()),
            },
            At(e, c) => match &**e {
                X => format!("x({})", latex_number(c)),
                Rate(e) if **e == X => format!(r"\frac{{dx}}{{dt}}({})", latex_number(c)),
                e if c.denominator().to_string() == "1" => format!(r"\left({}\right)({})", e.latex(), latex_number(c)),
                e => format!(r"\left.{}\right|_{{t={}}}", e.factor(), latex_number(c)),
            },
            Named(_) => "k".to_owned(),
            Signed(true, e) => format!(r"\pm {}", e.factor()),
            Signed(false, e) => format!(r"\mp {}", e.factor()),
        }
    }

    /// As a factor of a product.
    fn factor(&self) -> String {
        match self {
            Number(q) if sign_of(q) >= 0 => self.latex(),
            X | Y | A | T | U | Named(_) | Abs(_) | Of(..) | Div(..) => self.latex(),
            Number(_) | Neg(_) | Add(..) | Sub(..) | Mul(..) | Power(..) | Rate(_) | At(..) | Signed(..) => {
                format!(r"\left({}\right)", self.latex())
            }
        }
    }

    /// Whether ± or ∓ occurs.
    pub fn has_sign(&self) -> bool {
        matches!(self, Signed(..)) || self.parts().iter().any(|p| p.has_sign())
    }

    /// Whether it depends on the time.
    pub fn moves(&self) -> bool {
        matches!(self, X | T) || self.parts().iter().any(|p| p.moves())
    }

    /// What `k` stands for in it.
    pub fn named(&self) -> Option<&Term> {
        match self {
            Named(e) => Some(e),
            e => e.parts().into_iter().find_map(Term::named),
        }
    }

    /// The same with each part replaced, from the inside out.
    pub fn map(&self, f: &dyn Fn(Term) -> Term) -> Term {
        let of = |e: &Term| Box::new(e.map(f));
        f(match self {
            Number(_) | X | Y | A | T | U => self.clone(),
            Neg(e) => Neg(of(e)),
            Power(e, n) => Power(of(e), *n),
            Abs(e) => Abs(of(e)),
            Of(g, e) => Of(*g, of(e)),
            Rate(e) => Rate(of(e)),
            At(e, c) => At(of(e), c.clone()),
            Signed(upper, e) => Signed(*upper, of(e)),
            Named(e) => Named(of(e)),
            Add(e, g) => Add(of(e), of(g)),
            Sub(e, g) => Sub(of(e), of(g)),
            Mul(e, g) => Mul(of(e), of(g)),
            Div(e, g) => Div(of(e), of(g)),
        })
    }

    /// The terms that it is made of.
    pub fn parts(&self) -> Vec<&Term> {
        match self {
            Number(_) | X | Y | A | T | U => Vec::new(),
            Neg(e) | Power(e, _) | Abs(e) | Of(_, e) | Rate(e) | At(e, _) | Signed(_, e) | Named(e) => vec![e],
            Add(e, f) | Sub(e, f) | Mul(e, f) | Div(e, f) => vec![e, f],
        }
    }

    /// The function of t that it is.
    pub fn line(&self, setting: &Setting) -> Result<Line<Value>, Irrational> {
        let of = |e: &Term| e.line(setting);
        Ok(match self {
            Number(q) => Line::constant(Value::number(q.clone())),
            Y => Line::constant(Value::number(whole(2))),
            A => Line::constant(Value::number(fraction(3, 2))),
            U => return Err(Irrational),
            T => restricted(time(), &setting.known),
            X => setting.motion.term().line(setting)?,
            Named(e) => of(e)?,
            Neg(e) => product(&minus_one(), &of(e)?)?,
            Signed(upper, e) => {
                let s = whole(i64::from(if *upper { setting.sign } else { -setting.sign }));
                product(&Line::constant(Value::number(s)), &of(e)?)?
            }
            Add(e, f) => sum(&of(e)?, &of(f)?)?,
            Sub(e, f) => difference(&of(e)?, &of(f)?)?,
            Mul(e, f) => product(&of(e)?, &of(f)?)?,
            Div(e, f) => product(&of(e)?, &inverse(&of(f)?)?)?,
            Power(e, n) => {
                let e = of(e)?;
                let base = if *n < 0 { inverse(&e)? } else { e };
                (1..n.unsigned_abs()).try_fold(base.clone(), |p, _| product(&p, &base))?
            }
            Abs(e) => of(e)?.by_sign(|v, s| match v {
                Value::Quotient(n, d) if s == Some(-1) => Value::Quotient(n.scaled(&whole(-1)), d.clone()),
                Value::Quotient(..) | Value::Nothing => v.clone(),
                Value::Sign(s) => Value::Sign(s.abs()),
            })?,
            Of(Function::Root, e) if matches!(&**e, Power(_, 2)) => {
                let Power(base, _) = &**e else { return Err(Irrational) };
                Abs(base.clone()).line(setting)?
            }
            Of(f, e) => f.line(&of(e)?)?,
            Rate(e) => match &**e {
                // Where these have a value they are smooth, with rational rates.
                Of(f @ (Function::Logarithm | Function::ArcTangent), e) => {
                    let inner = of(e)?;
                    let below = match f {
                        Function::Logarithm => {
                            inner.by_sign(|v, s| if s == Some(1) { v.clone() } else { Value::Nothing })?
                        }
                        _ => sum(&product(&inner, &inner)?, &Line::constant(Value::number(whole(1))))?,
                    };
                    product(&inner.rate()?, &inverse(&below)?)?
                }
                e => of(e)?.rate()?,
            },
            At(e, c) => {
                let line = of(e)?.cut(std::slice::from_ref(c));
                let at = line.cuts.iter().position(|k| k == c).ok_or(Irrational)?;
                Line::constant(line.pieces[2 * at + 1].clone())
            }
        })
    }
}

/// What x is as a function of t.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Motion {
    /// t
    Forward,
    /// 1 − t
    Backward,
    /// t²
    Turning,
    /// |t − 1|
    Bent,
    /// 2t
    Fast,
    /// (1 − t²)/(1 + t²), the cosine of a motion around the circle
    Around,
}

pub const MOTIONS: [Motion; 6] =
    [Motion::Forward, Motion::Backward, Motion::Turning, Motion::Bent, Motion::Fast, Motion::Around];

impl Motion {
    pub fn term(self) -> Term {
        match self {
            Motion::Forward => T,
            Motion::Backward => sub(number(1), T),
            Motion::Turning => power(T, 2),
            Motion::Bent => abs(sub(T, number(1))),
            Motion::Fast => mul(number(2), T),
            Motion::Around => div(sub(number(1), power(T, 2)), add(number(1), power(T, 2))),
        }
    }

    /// Its rate, by hand.
    pub fn rate(self) -> Term {
        match self {
            Motion::Forward => number(1),
            Motion::Backward => number(-1),
            Motion::Turning => mul(number(2), T),
            Motion::Bent => div(sub(T, number(1)), abs(sub(T, number(1)))),
            Motion::Fast => number(2),
            Motion::Around => div(mul(number(-4), T), power(add(number(1), power(T, 2)), 2)),
        }
    }

    pub fn at(self, t: &Q) -> Q {
        match self {
            Motion::Forward => t.clone(),
            Motion::Backward => whole(1) - t,
            Motion::Turning => t * t,
            Motion::Bent if *t < whole(1) => whole(1) - t,
            Motion::Bent => t - whole(1),
            Motion::Fast => whole(2) * t,
            Motion::Around => (whole(1) - t * t) / (whole(1) + t * t),
        }
    }
}

/// What terms depend on.
#[derive(Clone, Debug)]
pub struct Setting {
    /// The upper sign: 1 or −1.
    pub sign: i8,
    pub motion: Motion,
    /// The times at which the motion is known; elsewhere nothing that moves has a value.
    pub known: Option<(Q, Q)>,
}

fn time() -> Line<Value> {
    Line::constant(Value::Quotient(Polynomial::new(vec![Q::ZERO, Q::ONE]), Polynomial::constant(Q::ONE)))
}

/// Nothing outside of the times that are known.
fn restricted(line: Line<Value>, known: &Option<(Q, Q)>) -> Line<Value> {
    let Some((a, b)) = known else { return line };
    let mut line = line.cut(&[a.clone(), b.clone()]);
    let inside = line.within(known);
    for i in 0..line.pieces.len() {
        if !inside.contains(&i) {
            line.pieces[i] = Value::Nothing;
        }
    }
    line
}

impl Function {
    fn latex(self, e: &str) -> String {
        match self {
            Function::Root => format!(r"\sqrt{{{e}}}"),
            Function::Logarithm => format!(r"\ln\left({e}\right)"),
            Function::Exponential => format!(r"\exp\left({e}\right)"),
            Function::ArcTangent => format!(r"\arctan\left({e}\right)"),
            Function::HyperbolicTangent => format!(r"\tanh\left({e}\right)"),
            Function::HyperbolicSine => format!(r"\sinh\left({e}\right)"),
            Function::ArcSine => format!(r"\arcsin\left({e}\right)"),
            Function::ArcCosine => format!(r"\arccos\left({e}\right)"),
            Function::Power => format!(r"\left(\left({e}\right)^{{0.3}}\right)"),
            Function::InversePower => format!(r"\left(\left({e}\right)^{{-0.5}}\right)"),
            Function::Mean => format!(r"\operatorname{{agm}}({e},1)"),
            Function::Angle => format!(r"\operatorname{{atan2}}({e},0)"),
        }
    }

    /// By the table of domains: needs and sign of each function.
    fn line(self, e: &Line<Value>) -> Result<Line<Value>, Irrational> {
        let shift = |q: Q| sum(e, &Line::constant(Value::number(q)));
        let by = |line: &Line<Value>, f: fn(i8) -> Option<i8>| line.by_sign(|_, s| signed_value(s.and_then(f)));
        match self {
            Function::Root => e.by_sign(|v, s| match (s, v) {
                (Some(1), Value::Quotient(n, d)) => match (constant(n), constant(d)) {
                    (Some(n), Some(d)) => root(&(n / d)).map_or(Value::Sign(1), Value::number),
                    _ => Value::Sign(1),
                },
                (s, _) => signed_value(s.filter(|&s| s >= 0)),
            }),
            Function::Power | Function::Mean => by(e, |s| (s >= 0).then_some(s)),
            Function::InversePower => by(e, |s| (s > 0).then_some(1)),
            Function::Exponential => by(e, |_| Some(1)),
            Function::ArcTangent | Function::HyperbolicTangent | Function::HyperbolicSine => by(e, Some),
            Function::Angle => by(e, |s| (s != 0).then_some(s)),
            Function::Logarithm => {
                let positive = e.by_sign(|v, s| if s == Some(1) { v.clone() } else { Value::Nothing })?;
                by(&sum(&positive, &Line::constant(Value::number(whole(-1))))?, Some)
            }
            Function::ArcSine | Function::ArcCosine => {
                let below = shift(whole(-1))?.by_sign(|v, s| if s > Some(0) { Value::Nothing } else { v.clone() })?;
                let above = shift(whole(1))?.by_sign(|v, s| if s == Some(-1) { Value::Nothing } else { v.clone() })?;
                let e = if self == Function::ArcSine { e.clone() } else { product(&minus_one(), &below)? };
                let inside = below.zip(&above, |b, a| *b != Value::Nothing && *a != Value::Nothing);
                let value = if self == Function::ArcSine { by(&e, Some)? } else { by(&e, |s| Some(s.max(0)))? };
                Ok(value.zip(&inside, |v, i| if *i { v.clone() } else { Value::Nothing }))
            }
        }
    }
}

fn minus_one() -> Line<Value> {
    Line::constant(Value::number(whole(-1)))
}

fn constant(p: &Polynomial) -> Option<Q> {
    let q = p.at(&Q::ZERO);
    (*p == Polynomial::constant(q.clone())).then_some(q)
}

fn signed_value(sign: Option<i8>) -> Value {
    match sign {
        None => Value::Nothing,
        Some(0) => Value::number(Q::ZERO),
        Some(s) => Value::Sign(s),
    }
}

/// On pieces that are cut at the zeros, if one factor is known by its sign only.
fn product(a: &Line<Value>, b: &Line<Value>) -> Result<Line<Value>, Irrational> {
    let opaque = |l: &Line<Value>| l.pieces.iter().any(|p| matches!(p, Value::Sign(_)));
    let (a, b) = if opaque(a) || opaque(b) { (a.cut_at_zeros()?, b.cut_at_zeros()?) } else { (a.clone(), b.clone()) };
    let (a, b) = (a.cut(&b.cuts), b.cut(&a.cuts));
    let pieces = (0..a.pieces.len()).map(|i| match (&a.pieces[i], &b.pieces[i]) {
        (Value::Quotient(n, d), Value::Quotient(m, e)) => Value::Quotient(n.times(m), d.times(e)),
        (p, q) => signed_value(p.sign(&a.inside(i)).zip(q.sign(&b.inside(i))).map(|(s, r)| s * r)),
    });
    Ok(Line { cuts: a.cuts.clone(), pieces: pieces.collect() })
}

fn sum(a: &Line<Value>, b: &Line<Value>) -> Result<Line<Value>, Irrational> {
    let line = a.zip(b, |p, q| match (p, q) {
        (Value::Nothing, _) | (_, Value::Nothing) => Some(Value::Nothing),
        (Value::Quotient(n, d), Value::Quotient(m, e)) if d == e => Some(Value::Quotient(n.add(m), d.clone())),
        (Value::Quotient(n, d), Value::Quotient(m, e)) => {
            Some(Value::Quotient(n.times(e).add(&m.times(d)), d.times(e)))
        }
        (Value::Sign(s), Value::Quotient(n, _)) | (Value::Quotient(n, _), Value::Sign(s)) if n.is_zero() => {
            Some(Value::Sign(*s))
        }
        (Value::Sign(s), Value::Sign(r)) if s == r => Some(Value::Sign(*s)),
        (Value::Sign(_), _) | (_, Value::Sign(_)) => None,
    });
    let pieces: Option<Vec<Value>> = line.pieces.into_iter().collect();
    Ok(Line { cuts: line.cuts, pieces: pieces.ok_or(Irrational)? })
}

/// The difference; used for relations, too.
pub fn difference(a: &Line<Value>, b: &Line<Value>) -> Result<Line<Value>, Irrational> {
    sum(a, &product(&minus_one(), b)?)
}

fn inverse(a: &Line<Value>) -> Result<Line<Value>, Irrational> {
    a.by_sign(|v, s| match (s, v) {
        (None | Some(0), _) => Value::Nothing,
        (Some(_), Value::Quotient(n, d)) => Value::Quotient(d.clone(), n.clone()),
        (Some(s), _) => Value::Sign(s),
    })
}
