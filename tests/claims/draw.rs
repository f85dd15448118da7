//! Draws of random claims: a profile says which forms are combined, the rest is chance from a seed.

use super::claim::{Claim, Form, KINDS, Kind, SCENES, SHAPES, Scene, Shape, Shaped, Statement, Text};
use super::line::{Q, fraction, whole};
use super::term::{FUNCTIONS, Function, Term, abs, add, div, mul, number, of, power, rate, signed, sub};

/// Numbers from a seed (SplitMix64): the same on every machine.
pub struct Chance(u64);

impl Chance {
    pub fn new(seed: u64) -> Chance {
        Chance(seed)
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    pub fn below(&mut self, n: usize) -> usize {
        (self.next() % n as u64) as usize
    }

    pub fn one<T: Clone>(&mut self, of: &[T]) -> T {
        of[self.below(of.len())].clone()
    }

    pub fn once_in(&mut self, n: usize) -> bool {
        self.below(n) == 0
    }
}

/// Values of what is combined: places in the lists of each dimension.
pub type Profile = [usize; 7];

pub const RELATIONS: [&str; 9] = ["=", "!=", "<", "<=", ">", ">=", "chain", "defined", "limit"];
pub const SIGNS: [&str; 5] = ["no sign", "one sign", "both signs", "sign assumed", "sign shared"];
pub const FORMS: [&str; 9] =
    ["always", "never", "eventually", "first-integral", "defined", "solves", "same-motion", "independent", "exists"];
pub const RESTRICTIONS: [&str; 5] = ["none", "at", "selector", "hypothesis", "limit hypothesis"];
pub const DEFINED: [&str; 6] = ["everywhere", "holes", "a part", "nowhere", "not at the start", "not at the events"];

/// Numbers of values: relation, shape, sign, form, restriction, scene, definedness.
pub const SIZES: Profile =
    [RELATIONS.len(), SHAPES.len(), SIGNS.len(), FORMS.len(), RESTRICTIONS.len(), SCENES.len(), DEFINED.len()];

/// Any values.
pub fn profile(chance: &mut Chance) -> Profile {
    SIZES.map(|n| chance.below(n))
}

/// Values as they are met: mostly relations at all times or at some, mostly with values.
pub fn usual_profile(chance: &mut Chance) -> Profile {
    let mut p = profile(chance);
    if chance.below(3) > 0 {
        p[3] = chance.below(3);
    }
    if chance.below(2) > 0 {
        p[6] = chance.below(3);
    }
    if chance.below(2) > 0 {
        p[2] = 0;
    }
    p
}

struct Draw<'a> {
    chance: &'a mut Chance,
    scene: Scene,
    span: usize,
    range: (Q, Q),
    /// Events, once they are chosen.
    events: Vec<Q>,
}

/// A claim of this profile, if there is one.
pub fn claim(profile: &Profile, chance: &mut Chance) -> Option<Claim> {
    let [relation, shape, sign, form, restriction, scene, defined] = *profile;
    let span = chance.below(3);
    let mut claim =
        Claim { scene: SCENES[scene], span, forms: Vec::new(), assuming: Vec::new(), at: None, throughout: false };
    let range = claim.range();
    let mut draw = Draw { chance, scene: SCENES[scene], span, range, events: Vec::new() };
    let moving = draw.moving();
    match RESTRICTIONS[restriction] {
        "none" => {}
        "at" if moving => claim.at = Some(draw.event(sign == 3 || sign == 4)),
        "selector" => {
            for _ in 0..=draw.chance.below(2) {
                let s = draw.selector(sign >= 3);
                claim.assuming.push(vec![s]);
            }
        }
        "hypothesis" => {
            let s = draw.hypothesis(sign >= 3);
            claim.assuming.push(vec![s]);
            if draw.chance.once_in(3) {
                let s = draw.selector(false);
                if draw.chance.once_in(2) { claim.assuming[0].push(s) } else { claim.assuming.push(vec![s]) }
            }
        }
        "limit hypothesis" if moving => {
            let s = draw.limit();
            claim.assuming.push(vec![s]);
        }
        _ => return None,
    }
    if (sign == 3 || sign == 4) && restriction == 0 {
        return None;
    }
    let assumed_sign = claim.assuming.iter().flatten().any(Statement::has_sign)
        || claim.at.iter().any(|(l, r)| l.has_sign() || r.has_sign());
    if (sign == 3 || sign == 4) && !assumed_sign {
        return None;
    }
    let signs = [0, 1, 2, 0, 1][sign];
    claim.throughout = moving && sign != 0 && draw.chance.once_in(3);
    let form = draw.form(FORMS[form], relation, SHAPES[shape], signs, defined)?;
    // A second form, where ± allows it.
    if sign == 0 && draw.chance.once_in(6) && !matches!(form, Form::Exists { .. }) {
        let other = if moving { draw.chance.one(&["always", "never", "eventually", "defined"]) } else { "always" };
        let relation = draw.chance.below(6);
        let second = draw.form(other, if other == "defined" { 7 } else { relation }, Shape::Scalar, 0, 0)?;
        if std::mem::discriminant(&second) != std::mem::discriminant(&form) && draw.scene != Scene::All {
            claim.forms.push(second);
        }
    }
    claim.forms.insert(0, form);
    if claim.scene == Scene::All {
        let single =
            matches!(&claim.forms[..], [Form::Always(t)] if t.len() == 1 && t[0].len() == 1 && t[0][0].is_equation());
        return single.then_some(claim);
    }
    Some(claim)
}

impl Draw<'_> {
    fn moving(&self) -> bool {
        !matches!(self.scene, Scene::Box | Scene::All)
    }

    /// A point: on a grid that samples meet, or off it; mostly inside of the range.
    fn point(&mut self) -> Q {
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
    fn linear(&mut self) -> Term {
        let p = self.point();
        if self.chance.once_in(5) { sub(Term::Number(p), Term::X) } else { self.distance(p) }
    }

    fn distance(&mut self, p: Q) -> Term {
        sub(Term::X, Term::Number(p))
    }

    fn constant(&mut self) -> Term {
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
    fn plain(&mut self) -> Term {
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
    fn functional(&mut self) -> Term {
        let f = self.chance.one(&FUNCTIONS);
        let e = if self.chance.once_in(3) { mul(self.linear(), self.linear()) } else { self.linear() };
        of(f, e)
    }

    fn difference(&mut self) -> Term {
        match self.chance.below(8) {
            0 => self.functional(),
            1 => div(self.plain(), self.linear()),
            2 if self.moving() => rate(self.plain()),
            3 if self.moving() && self.chance.once_in(3) => rate(rate(self.plain())),
            _ => self.plain(),
        }
    }

    /// What is 0 where it has a value, and has none in the wanted places.
    fn hole(&mut self, defined: usize) -> Option<Term> {
        let (a, b) = self.range.clone();
        match DEFINED[defined] {
            "everywhere" => None,
            "holes" => {
                let p = self.point();
                Some(self.hole_at(p))
            }
            "not at the start" => {
                let p = if self.chance.once_in(4) { b } else { a };
                Some(self.hole_at(p))
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
                    0 => sub(Term::X, Term::Number(b + whole(1))),
                    1 => sub(Term::Number(a - whole(1)), Term::X),
                    _ => sub(number(-1), power(Term::X, 2)),
                };
                let f = self.chance.one(&[Function::Root, Function::Logarithm, Function::Mean, Function::Power]);
                Some(if self.chance.once_in(4) { div(number(1), mul(number(0), Term::X)) } else { of(f, e) })
            }
        }
    }

    /// What has no value at one point.
    fn hole_at(&mut self, p: Q) -> Term {
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

    fn with_hole(&mut self, e: Term, defined: usize) -> Term {
        match self.hole(defined) {
            None => e,
            Some(h) => {
                let zero = if self.chance.once_in(3) { sub(h.clone(), h) } else { mul(number(0), h) };
                if self.chance.once_in(2) { add(e, zero) } else { add(zero, e) }
            }
        }
    }

    /// Two terms that are equal, at least where both have values.
    fn equal(&mut self) -> (Term, Term) {
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
            7 => (rate(Term::X), number(1)),
            8 => (rate(power(e.clone(), 2)), mul(number(2), e)),
            9 => (mul(rate(abs(e.clone())), abs(e.clone())), e),
            10 => (rate(mul(e.clone(), abs(e.clone()))), mul(mul(number(2), abs(e.clone())), rate(e))),
            _ => {
                let (a, b) = super::claim::SPANS[self.span];
                let c = a + self.chance.below((b - a + 1) as usize) as i64;
                (Term::At(Box::new(Term::X), whole(c)), number(c))
            }
        }
    }

    /// Sides of one relation between numbers.
    fn sides(&mut self, kind: Kind, signs: usize, defined: usize) -> (Term, Term) {
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

    fn signed_sides(&mut self, signs: usize) -> (Term, Term) {
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

    fn statement(&mut self, relation: usize, shape: Shape, signs: usize, defined: usize) -> Option<Statement> {
        match RELATIONS[relation] {
            "limit" => (self.moving() && signs == 0).then(|| self.limit()),
            "defined" => None,
            "chain" => {
                let mut sides = vec![vec![self.plain()], vec![self.plain()], vec![self.constant()]];
                if signs > 0 {
                    sides[1] = vec![self.signed_sides(signs).0];
                }
                let place = self.chance.below(3);
                let e = sides[place].remove(0);
                let e = self.with_hole(e, defined);
                sides[place].push(e);
                // Chains mean what they say in one direction.
                let up = self.chance.once_in(2);
                let allowed: &[Kind] = if up {
                    &[Kind::Less, Kind::AtMost, Kind::Equal]
                } else {
                    &[Kind::Greater, Kind::AtLeast, Kind::Equal]
                };
                let kinds = vec![self.chance.one(allowed), self.chance.one(allowed)];
                (shape == Shape::Scalar).then_some(Statement::Relation { shape, sides, kinds })
            }
            _ => {
                let kind = KINDS[relation];
                let ordered = kind != Kind::Equal && kind != Kind::Different;
                if ordered && shape != Shape::Scalar {
                    return None;
                }
                let n = shape.components();
                let place = self.chance.below(n);
                let (mut left, mut right) = (Vec::new(), Vec::new());
                for i in 0..n {
                    let (l, r) = if i == place {
                        self.sides(kind, signs, defined)
                    } else if self.chance.once_in(3) {
                        let c = self.constant();
                        (c.clone(), c)
                    } else {
                        self.sides(kind, 0, 0)
                    };
                    left.push(l);
                    right.push(r);
                }
                Some(Statement::Relation { shape, sides: vec![left, right], kinds: vec![kind] })
            }
        }
    }

    fn limit(&mut self) -> Statement {
        let (a, b) = super::claim::SPANS[self.span];
        let p = self.point();
        let of = match self.chance.below(5) {
            0 => div(sub(power(Term::X, 2), Term::Number(&p * &p)), sub(Term::X, Term::Number(p.clone()))),
            1 => div(self.linear(), sub(Term::X, Term::Number(p.clone()))),
            2 => div(sub(Term::X, Term::Number(p.clone())), abs(sub(Term::X, Term::Number(p.clone())))),
            3 => div(self.constant(), add(power(Term::X, 2), number(1))),
            _ => self.plain(),
        };
        let at = match self.chance.below(6) {
            0 => None,
            1 => Some(whole(a)),
            2 => Some(whole(b)),
            3 => Some(self.point()),
            _ => Some(p.clone()),
        };
        let value = match self.chance.below(4) {
            0 => &p * whole(2),
            1 => whole(1),
            2 => whole(0),
            _ => at.clone().unwrap_or(whole(1)),
        };
        let kind = if self.chance.once_in(2) { Kind::Equal } else { self.chance.one(&KINDS) };
        Statement::Limit { of, at, kind, value }
    }

    fn event(&mut self, sign: bool) -> (Term, Term) {
        if sign {
            let c = self.constant();
            return (Term::X, signed(true, c));
        }
        let (p, q) = (self.point(), self.point());
        self.events = vec![p.clone(), q.clone()];
        let (e, f) = (sub(Term::X, Term::Number(p.clone())), sub(Term::X, Term::Number(q)));
        match self.chance.below(5) {
            0 => (Term::X, Term::Number(p)),
            1 => (abs(e), number(0)),
            2 => (mul(e, f), number(0)),
            3 => (mul(e, power(f, 2)), number(0)),
            _ => {
                // An event at the edge of where it has a value.
                (of(Function::Root, e), number(0))
            }
        }
    }

    fn selector(&mut self, sign: bool) -> Statement {
        let signs = usize::from(sign);
        let relation = 1 + self.chance.below(5);
        let shape = if relation == 1 && !sign { self.chance.one(&SHAPES) } else { Shape::Scalar };
        let defined = if self.chance.once_in(4) { self.chance.below(3) } else { 0 };
        if !sign && self.chance.once_in(2) {
            let p = self.point();
            self.events = vec![p.clone()];
            let kind = KINDS[relation];
            return Statement::Relation {
                shape: Shape::Scalar,
                sides: vec![vec![Term::X], vec![Term::Number(p)]],
                kinds: vec![kind],
            };
        }
        self.statement(relation, shape, signs, defined).unwrap_or_else(|| self.limit())
    }

    fn hypothesis(&mut self, sign: bool) -> Statement {
        let shape = self.chance.one(&SHAPES);
        let signs = usize::from(sign);
        let defined = if self.chance.once_in(4) { self.chance.below(3) } else { 0 };
        if !sign && self.chance.once_in(2) {
            let (l, r) = self.equal();
            let l = self.with_hole(l, defined);
            return Statement::Relation {
                shape: Shape::Scalar,
                sides: vec![vec![l], vec![r]],
                kinds: vec![Kind::Equal],
            };
        }
        self.statement(0, shape, signs, defined).unwrap_or_else(|| self.limit())
    }

    fn shaped(&mut self, shape: Shape, signs: usize, defined: usize, make: impl Fn(&mut Self) -> Term) -> Shaped {
        let n = shape.components();
        let place = self.chance.below(n);
        let mut components = Vec::new();
        for i in 0..n {
            let mut e = make(self);
            if i == place {
                if signs > 0 {
                    let (l, r) = self.signed_sides(signs);
                    e = sub(l, r);
                }
                e = self.with_hole(e, defined);
            }
            components.push(e);
        }
        (shape, components)
    }

    fn texts(&mut self, relation: usize, shape: Shape, signs: usize, defined: usize) -> Option<Vec<Text>> {
        let first = self.statement(relation, shape, signs, defined)?;
        let mut texts = vec![vec![first]];
        // ≠ with ± stands alone.
        if self.chance.once_in(4) && !(signs > 0 && relation == 1) && self.scene != Scene::All {
            let relation = self.chance.below(6);
            let second = self.statement(relation, Shape::Scalar, 0, 0)?;
            if self.chance.once_in(2) { texts[0].push(second) } else { texts.push(vec![second]) }
        }
        Some(texts)
    }

    fn form(&mut self, form: &str, relation: usize, shape: Shape, signs: usize, defined: usize) -> Option<Form> {
        let moving = self.moving();
        Some(match form {
            "always" => Form::Always(self.texts(relation, shape, signs, defined)?),
            "never" if moving => Form::Never(self.texts(relation, shape, signs, defined)?),
            "eventually" if moving => Form::Eventually(self.texts(relation, shape, signs, defined)?),
            "first-integral" if moving => {
                let e = self.shaped(shape, signs, defined, |d| {
                    let (l, r) = if d.chance.once_in(3) { (d.plain(), number(0)) } else { d.equal() };
                    sub(l, r)
                });
                Form::FirstIntegral(vec![e])
            }
            "defined" if RELATIONS[relation] == "defined" && self.scene != Scene::All => Form::Defined(vec![
                self.shaped(shape, signs, defined, |d| if d.chance.once_in(6) { d.difference() } else { d.plain() }),
            ]),
            "solves" if moving && signs == 0 => {
                let p = if self.chance.once_in(3) { self.difference() } else { number(1) };
                let p = self.with_hole(p, defined);
                let q = if self.chance.once_in(4) { self.plain() } else { number(0) };
                Form::Solves(p, q)
            }
            "same-motion" if moving && signs == 0 => {
                let x = match self.chance.below(4) {
                    0 => Term::X,
                    1 => {
                        let p = self.point();
                        add(abs(sub(Term::X, Term::Number(p.clone()))), Term::Number(p))
                    }
                    2 => add(Term::X, mul(self.linear(), self.linear())),
                    _ => Term::X,
                };
                let x = if DEFINED[defined] == "holes" {
                    let p = self.point();
                    let e = sub(Term::X, Term::Number(p));
                    mul(x, div(e.clone(), e))
                } else {
                    x
                };
                let (a, b) = super::claim::SPANS[self.chance.below(3)];
                let (from, to) = self.range.clone();
                let common = from.max(whole(a)) < to.min(whole(b));
                if !common {
                    return None;
                }
                Form::SameMotion(x, (whole(a), whole(b)))
            }
            "independent" if moving && signs == 0 => {
                Form::Independent(if self.chance.once_in(4) { None } else { Some(self.point()) })
            }
            "exists" if self.scene == Scene::Box && signs == 0 => {
                let root = |d: &mut Self| match d.chance.below(4) {
                    0 => Term::X,
                    1 => d.linear(),
                    2 => d.constant(),
                    _ => mul(Term::Number(fraction(1, 2)), d.linear()),
                };
                let factor = |d: &mut Self| sub(Term::U, root(d));
                let mut e = factor(self);
                if self.chance.once_in(2) {
                    e = mul(e, factor(self));
                }
                if let Some(h) = self.hole(defined) {
                    e = mul(e, add(number(1), mul(number(0), h)));
                }
                let low = -3 + self.chance.below(5) as i64;
                let high = low + 1 + self.chance.below(6) as i64;
                let also = self.chance.once_in(4).then(|| (Term::U, self.chance.one(&KINDS[1..]), self.constant()));
                let unique = self.chance.once_in(2);
                Form::Exists { range: (whole(low), whole(high)), equation: (e, number(0)), also, unique }
            }
            _ => return None,
        })
    }
}

/// Whether a function occurs that is no rational function, so that only its sign is known.
fn has_function(e: &Term) -> bool {
    matches!(e, Term::Of(..)) || e.parts().iter().any(|p| has_function(p))
}
