//! Draws of terms: with chosen zeros, holes, signs and kinks.

use super::claim::{Kind, Scene};
use super::draw::{DEFINED, Draw};
use super::line::{Q, fraction, whole};
use super::term::{FUNCTIONS, Function, Term, abs, add, div, mul, number, of, power, rate, signed, sub};

impl Draw<'_> {
    pub fn moving(&self) -> bool {
        !matches!(self.scene, Scene::Box | Scene::All)
    }

    /// A value of x.
    pub fn point(&mut self) -> Q {
        let t = self.time();
        let p = self.motion.at(&t);
        if !self.chance.once_in(12) {
            return p;
        }
        // Beside it by little.
        self.near = true;
        let digits = self.chance.one(&[4, 7, 10, 13, 17]);
        let little = (0..digits).fold(whole(1), |q, _| q / whole(10));
        if self.chance.once_in(2) { p + little } else { p - little }
    }

    /// A time: on a grid that samples meet, or off it; mostly inside of the span.
    pub fn time(&mut self) -> Q {
        let (a, b) = super::claim::SPANS[self.span];
        match self.chance.below(10) {
            0 => whole(a),
            1 => whole(b),
            2 => whole(a - 1),
            3 => whole(b + 1),
            4 | 5 => whole(a + 1 + self.chance.below((b - a - 1) as usize) as i64),
            6 => fraction(2 * a + 1 + 2 * self.chance.below((b - a) as usize) as i64, 2),
            7 => fraction(3 * a + 1 + self.chance.below(3 * (b - a) as usize - 1) as i64, 3),
            8 => fraction(10 * a + 1 + self.chance.below(10 * (b - a) as usize - 1) as i64, 10),
            _ => fraction(7 * a + 1 + self.chance.below(7 * (b - a) as usize - 1) as i64, 7),
        }
    }

    /// x − p, or p − x.
    pub fn linear(&mut self) -> Term {
        let p = self.point();
        if self.chance.once_in(5) { sub(Term::Number(p), Term::X) } else { self.distance(p) }
    }

    pub fn distance(&mut self, p: Q) -> Term {
        sub(Term::X, Term::Number(p))
    }

    pub fn constant(&mut self) -> Term {
        match self.chance.below(6) {
            0 => Term::Y,
            1 => Term::A,
            2 => number(1),
            3 => number(-1),
            4 => Term::Number(fraction(1, 2)),
            _ => number(2 + self.chance.below(3) as i64),
        }
    }

    /// A difference of sides: its zeros, holes and signs are those of its linear factors.
    pub fn plain(&mut self) -> Term {
        if self.moving() && self.chance.once_in(8) {
            let e = sub(Term::T, Term::Number(self.time()));
            return if self.chance.once_in(2) { mul(e, self.linear()) } else { e };
        }
        match self.chance.below(14) {
            0 | 1 => self.linear(),
            2 => mul(self.linear(), self.linear()),
            3 => power(self.linear(), 2),
            4 => abs(self.linear()),
            5 => self.constant(),
            6 => {
                let e = self.linear();
                mul(e.clone(), abs(e))
            }
            7 => div(self.linear(), add(power(Term::X, 2), number(1))),
            8 => {
                let (e, f) = (self.linear(), self.linear());
                // The smaller or the larger of two.
                let d = abs(sub(e.clone(), f.clone()));
                let both = add(e, f);
                let both = if self.chance.once_in(2) { sub(both, d) } else { add(both, d) };
                div(both, number(2))
            }
            9 => {
                let e = self.linear();
                sub(abs(e.clone()), e)
            }
            10 => add(abs(self.linear()), self.constant()),
            11 => mul(self.constant(), power(self.linear(), 3)),
            12 => sub(power(Term::X, 2), Term::X),
            _ => mul(number(0), self.linear()),
        }
    }

    /// One with a function of which the sign is known: to be compared with 0.
    pub fn functional(&mut self) -> Term {
        let f = self.chance.one(&FUNCTIONS);
        let e = if self.chance.once_in(3) { mul(self.linear(), self.linear()) } else { self.linear() };
        of(f, e)
    }

    pub fn difference(&mut self) -> Term {
        match self.chance.below(8) {
            0 => self.functional(),
            1 => div(self.plain(), self.linear()),
            2 if self.moving() && self.chance.once_in(3) => {
                let f = self.chance.one(&[Function::Logarithm, Function::ArcTangent]);
                rate(of(f, self.linear()))
            }
            2 if self.moving() => rate(self.plain()),
            3 if self.moving() && self.chance.once_in(3) => rate(rate(self.plain())),
            _ => self.plain(),
        }
    }

    /// What is 0 where it has a value, and has none in the wanted places.
    pub fn hole(&mut self, defined: usize) -> Option<Term> {
        let (a, b) = super::claim::SPANS[self.span];
        match DEFINED[defined] {
            "everywhere" => None,
            "holes" => {
                let p = self.point();
                Some(self.hole_at(p))
            }
            "not at the start" => {
                let t = whole(if self.chance.once_in(4) { b } else { a });
                Some(self.hole_at(self.motion.at(&t)))
            }
            "not at the events" => {
                let p = self.events.first().cloned()?;
                Some(self.hole_at(p))
            }
            "a part" => {
                let e = match self.chance.below(5) {
                    0 => mul(self.linear(), self.linear()),
                    1 => Term::Neg(Box::new(power(self.linear(), 2))),
                    2 => Term::Neg(Box::new(abs(self.linear()))),
                    _ => self.linear(),
                };
                let f = self.chance.one(&[
                    Function::Root,
                    Function::Logarithm,
                    Function::Mean,
                    Function::Power,
                    Function::InversePower,
                    Function::ArcSine,
                    Function::ArcCosine,
                ]);
                Some(of(f, e))
            }
            _ => {
                let e = match self.chance.below(3) {
                    0 => sub(Term::X, number(17)),
                    1 => sub(number(-10), Term::X),
                    _ => sub(number(-1), power(Term::X, 2)),
                };
                let f = self.chance.one(&[Function::Root, Function::Logarithm, Function::Mean, Function::Power]);
                Some(if self.chance.once_in(4) { div(number(1), mul(number(0), Term::X)) } else { of(f, e) })
            }
        }
    }

    /// What has no value at one point.
    pub fn hole_at(&mut self, p: Q) -> Term {
        let e = self.distance(p);
        match self.chance.below(9) {
            0 => power(e, -1),
            1 => power(e, -2),
            2 => of(Function::Angle, e),
            3 => of(Function::Logarithm, power(e, 2)),
            4 => of(Function::InversePower, power(e, 2)),
            5 => div(e.clone(), abs(e)),
            6 if self.moving() => rate(abs(e)),
            7 => div(e.clone(), e),
            _ => div(number(1), e),
        }
    }

    pub fn with_hole(&mut self, e: Term, defined: usize) -> Term {
        match self.hole(defined) {
            None => e,
            Some(h) => {
                let zero = if self.chance.once_in(3) { sub(h.clone(), h) } else { mul(number(0), h) };
                if self.chance.once_in(2) { add(e, zero) } else { add(zero, e) }
            }
        }
    }

    /// Two terms that are equal, at least where both have values.
    pub fn equal(&mut self) -> (Term, Term) {
        let p = self.point();
        let e = self.linear();
        match self.chance.below(if self.moving() { 12 } else { 7 }) {
            0 => (
                mul(sub(Term::X, Term::Number(p.clone())), add(Term::X, Term::Number(p.clone()))),
                sub(power(Term::X, 2), Term::Number(&p * &p)),
            ),
            1 => (power(abs(e.clone()), 2), power(e, 2)),
            2 => (of(Function::Root, power(e.clone(), 2)), abs(e)),
            3 => (add(Term::Y, number(1)), mul(number(2), Term::A)),
            4 => (mul(Term::X, add(e.clone(), number(1))), add(mul(Term::X, e), Term::X)),
            5 => (div(e.clone(), e), number(1)),
            6 => (abs(e.clone()), abs(sub(number(0), e))),
            7 => (rate(Term::X), self.motion.rate()),
            8 => (rate(power(e.clone(), 2)), mul(mul(number(2), e.clone()), rate(e))),
            9 => (mul(rate(abs(e.clone())), abs(e.clone())), mul(e.clone(), rate(e))),
            10 => (rate(mul(e.clone(), abs(e.clone()))), mul(mul(number(2), abs(e.clone())), rate(e))),
            _ => {
                let (a, b) = super::claim::SPANS[self.span];
                let c = whole(a + self.chance.below((b - a + 1) as usize) as i64);
                let x = self.motion.at(&c);
                let at = |e: Term| Term::At(Box::new(e), c.clone());
                match self.chance.below(4) {
                    0 => (at(add(Term::X, Term::Y)), Term::Number(x + whole(2))),
                    1 => (at(rate(Term::X)), self.motion.rate()),
                    2 => (at(power(Term::X, 2)), Term::Number(&x * &x)),
                    _ => (at(Term::X), Term::Number(x)),
                }
            }
        }
    }

    /// Sides of one relation between numbers.
    pub fn sides(&mut self, kind: Kind, signs: usize, defined: usize) -> (Term, Term) {
        let (mut l, mut r) = if signs > 0 {
            self.signed_sides(signs)
        } else if (kind == Kind::Equal && self.chance.once_in(2)) || self.chance.once_in(10) {
            self.equal()
        } else {
            let d = self.difference();
            let opaque = has_function(&d);
            let r = match self.chance.below(5) {
                _ if opaque => number(0),
                0 => number(0),
                1 => Term::X,
                2 => self.constant(),
                3 => power(Term::X, 2),
                _ => number(0),
            };
            if r == number(0) { (d, r) } else { (add(d, r.clone()), r) }
        };
        l = self.with_hole(l, defined);
        if self.chance.once_in(4) {
            std::mem::swap(&mut l, &mut r);
        }
        (l, r)
    }

    pub fn signed_sides(&mut self, signs: usize) -> (Term, Term) {
        let s = |e: Term| signed(true, e);
        let opposite = |e: Term| signed(false, e);
        let (e, f, c) = (self.linear(), self.plain(), self.constant());
        if signs == 2 {
            return match self.chance.below(4) {
                0 => (add(e, s(c)), opposite(f)),
                1 => (s(e), opposite(c)),
                2 => (mul(add(Term::X, s(c.clone())), add(Term::X, opposite(c))), f),
                _ => (add(s(e.clone()), opposite(f)), number(0)),
            };
        }
        match self.chance.below(6) {
            0 => (Term::X, s(c)),
            1 => (abs(e.clone()), s(e)),
            2 => (add(f, s(c)), number(0)),
            3 => (add(e.clone(), s(f)), self.constant()),
            4 => (s(e), c),
            _ => (s(f), number(0)),
        }
    }
}

/// Whether a function occurs that is no rational function, so that only its sign is known.
fn has_function(e: &Term) -> bool {
    match e {
        // A rate of a logarithm or an arc tangent is a rational function.
        Term::Rate(f) => f.parts().iter().any(|p| has_function(p)),
        Term::Of(..) => true,
        e => e.parts().iter().any(|p| has_function(p)),
    }
}
