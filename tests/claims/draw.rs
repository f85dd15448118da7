//! Draws of random claims: a profile says which forms are combined, the rest is chance from a seed.

use super::claim::{Claim, Form, KINDS, Kind, SCENES, SHAPES, Scene, Shape, Shaped, Statement, Text};
use super::line::{Q, fraction, whole};
use super::term::{Function, MOTIONS, Motion, Term, abs, add, div, mul, number, of, power, signed, sub};

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

/// What is drawn for, and from.
pub struct Draw<'a> {
    pub chance: &'a mut Chance,
    pub scene: Scene,
    pub span: usize,
    pub motion: Motion,
    /// Events, once they are chosen.
    pub events: Vec<Q>,
    /// Some numbers differ by little: no place for equations, of which may be said that they hold to within a bound.
    pub near: bool,
}

/// A claim of this profile, if there is one.
pub fn claim(profile: &Profile, chance: &mut Chance) -> Option<Claim> {
    let [relation, shape, sign, form, restriction, scene, defined] = *profile;
    let span = chance.below(3);
    let scene = SCENES[scene];
    let motion = match scene {
        Scene::Box | Scene::All => Motion::Forward,
        // No kink in a right side: that is a matter of its own.
        Scene::Integrated => chance.one(&[
            Motion::Forward,
            Motion::Forward,
            Motion::Backward,
            Motion::Turning,
            Motion::Fast,
            Motion::Around,
        ]),
        Scene::Formula | Scene::Derived => chance.one(&MOTIONS),
    };
    let mut claim = Claim {
        scene,
        span,
        motion,
        forms: Vec::new(),
        assuming: Vec::new(),
        at: None,
        throughout: false,
        role: "abbreviation",
        later: 0,
    };
    let mut draw = Draw { chance, scene, span, motion, events: Vec::new(), near: false };
    let moving = draw.moving();
    match RESTRICTIONS[restriction] {
        "none" => {}
        "at" if moving => claim.at = Some(draw.event(sign == 3 || sign == 4)),
        "selector" => {
            let several = draw.chance.once_in(2);
            for _ in 0..=usize::from(several) {
                let s = draw.selector(sign >= 3, sign == 4 || several);
                claim.assuming.push(vec![s]);
            }
        }
        "hypothesis" => {
            let s = draw.hypothesis(sign >= 3);
            claim.assuming.push(vec![s]);
            if draw.chance.once_in(3) {
                let s = draw.selector(false, false);
                if draw.chance.once_in(2) { claim.assuming[0].push(s) } else { claim.assuming.push(vec![s]) }
            }
        }
        "limit hypothesis" if moving => {
            let s = draw.limit();
            claim.assuming.push(vec![s]);
        }
        _ => return None,
    }
    // ≠ with ± stands alone.
    let different = sign == 4 && relation == 1;
    if different || ((sign == 3 || sign == 4) && restriction == 0) {
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
    if draw.near && has_allowance(&claim) {
        return None;
    }
    if claim.scene == Scene::All {
        let single =
            matches!(&claim.forms[..], [Form::Always(t)] if t.len() == 1 && t[0].len() == 1 && t[0][0].is_equation());
        return single.then_some(claim);
    }
    Some(claim)
}

impl Draw<'_> {
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
        let t = self.time();
        let p = self.motion.at(&t);
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
            3 => Some(self.time()),
            _ => Some(t),
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

    fn selector(&mut self, sign: bool, shared: bool) -> Statement {
        let signs = usize::from(sign);
        let relation = if shared { 2 + self.chance.below(4) } else { 1 + self.chance.below(5) };
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
                let p = if self.chance.once_in(3) { self.difference() } else { self.motion.rate() };
                let p = self.with_hole(p, defined);
                let q = if self.chance.once_in(4) { self.plain() } else { number(0) };
                Form::Solves(p, q)
            }
            "same-motion" if moving && signs == 0 => {
                let x = self.motion.term();
                let e = sub(Term::T, Term::Number(self.time()));
                let x = match self.chance.below(4) {
                    0 => add(x, sub(abs(e.clone()), e.clone())),
                    1 => add(x, power(e.clone(), 2)),
                    _ => x,
                };
                let x = if DEFINED[defined] == "holes" { mul(x, div(e.clone(), e)) } else { x };
                let (a, b) = super::claim::SPANS[self.chance.below(3)];
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
                let also = self.chance.once_in(4);
                let also = also.then(|| Box::new((Term::U, self.chance.one(&KINDS[1..]), self.constant())));
                let unique = self.chance.once_in(2);
                Form::Exists { range: (whole(low), whole(high)), equation: (e, number(0)), also, unique }
            }
            _ => return None,
        })
    }
}

/// Whether it says what may hold to within a bound: equations, and inequalities at their border, at all times.
fn has_allowance(claim: &Claim) -> bool {
    let allowed = |s: &Statement| match s {
        Statement::Relation { kinds, .. } => {
            kinds.iter().any(|k| matches!(k, Kind::Equal | Kind::AtMost | Kind::AtLeast))
        }
        Statement::Limit { .. } => true,
    };
    let hypothesis = claim.assuming.iter().flatten().any(|s| s.is_equation() || matches!(s, Statement::Limit { .. }));
    hypothesis
        || claim.forms.iter().any(|f| match f {
            Form::Always(t) => t.iter().flatten().any(allowed),
            // What is never unequal is always equal.
            Form::Never(t) => t.iter().flatten().any(|s| match s {
                Statement::Relation { kinds, .. } => kinds.contains(&Kind::Different),
                Statement::Limit { .. } => true,
            }),
            Form::Eventually(t) => t.iter().flatten().any(|s| matches!(s, Statement::Limit { .. })),
            Form::FirstIntegral(_) | Form::Solves(..) | Form::SameMotion(..) => true,
            Form::Defined(_) | Form::Independent(_) | Form::Exists { .. } => false,
        })
}
