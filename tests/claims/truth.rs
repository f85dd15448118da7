//! What a random claim is: true, false or void. Written from `docs/semantics.md` alone, with none of the program's code.
//!
//! Where the page leaves two meanings open, both are computed, and a verdict that fits either is no wrong one.

use super::claim::{Claim, Form, Kind, Scene, Shaped, Statement, Text, text_has_sign};
use super::line::{Irrational, Line, Q, Value};
use super::logic::{
    Truth,
    Truth::{False, True, Void},
    all, and, assert, given, not, or, some,
};
use super::term::{Setting, Term, difference};

type Truths = Line<Truth>;
type Found<T> = Result<T, Irrational>;

/// The meanings that the page allows.
#[derive(Clone, Copy, Debug)]
struct Reading {
    /// Components and links are quantified one by one, not together.
    parts: bool,
    /// A motion by formulas is known outside of its span, too.
    beyond: bool,
    /// Among assumptions with ±, and pointwise: the sign of a hypothesis may change with time.
    changing: bool,
}

/// The values that a claim can have by the page; one, but where the page is open.
pub fn truth(claim: &Claim) -> Found<Vec<Truth>> {
    let mut found = Vec::new();
    for i in 0..8 {
        let reading = Reading { parts: i & 1 == 1, beyond: i & 2 == 2, changing: i & 4 == 4 };
        let t = Scope::new(claim, reading).claim()?;
        if !found.contains(&t) {
            found.push(t);
        }
    }
    Ok(found)
}

struct Scope<'a> {
    claim: &'a Claim,
    reading: Reading,
    /// Points that are asked about; without it all real numbers.
    range: Option<(Q, Q)>,
    /// Points at which something is known.
    known: Option<(Q, Q)>,
}

/// Points that count, for each sign: + and −.
type Counting = [Line<bool>; 2];

const SIGNS: [i8; 2] = [1, -1];

fn every(truths: &Truths, s: &Line<bool>, range: &Option<(Q, Q)>) -> Truth {
    let line = truths.zip(s, |t, s| if *s { *t } else { Void });
    all(line.cut(&ends(range)).pick(range))
}

fn any(truths: &Truths, s: &Line<bool>, range: &Option<(Q, Q)>) -> Truth {
    not(every(&truths.map(|t| not(*t)), s, range))
}

fn ends(range: &Option<(Q, Q)>) -> Vec<Q> {
    range.iter().flat_map(|(a, b)| [a.clone(), b.clone()]).collect()
}

impl Truths {
    fn pick(&self, range: &Option<(Q, Q)>) -> Vec<Truth> {
        self.within(range).into_iter().map(|i| self.pieces[i]).collect()
    }
}

impl<'a> Scope<'a> {
    fn new(claim: &'a Claim, reading: Reading) -> Scope<'a> {
        let range = (claim.scene != Scene::All).then(|| claim.range());
        let known = match claim.scene {
            Scene::Integrated => range.clone(),
            Scene::Formula | Scene::Derived => range.clone().filter(|_| !reading.beyond),
            Scene::Box | Scene::All => None,
        };
        Scope { claim, reading, range, known }
    }

    fn line(&self, term: &Term, sign: i8) -> Found<Line<Value>> {
        term.line(&Setting { sign, motion: self.claim.motion, known: self.known.clone() })
    }

    /// One relation between numbers.
    fn atom(&self, l: &Line<Value>, kind: Kind, r: &Line<Value>) -> Found<Truths> {
        let d = difference(l, r)?.cut_at_zeros()?;
        let pieces = (0..d.pieces.len()).map(|i| {
            d.pieces[i].sign(&d.inside(i)).map_or(Void, |s| {
                let holds = match kind {
                    Kind::Equal => s == 0,
                    Kind::Different => s != 0,
                    Kind::Less => s < 0,
                    Kind::AtMost => s <= 0,
                    Kind::Greater => s > 0,
                    Kind::AtLeast => s >= 0,
                };
                if holds { True } else { False }
            })
        });
        Ok(Line { pieces: pieces.collect(), cuts: d.cuts })
    }

    /// Links of a chain, each by its components: what is ∧ together.
    fn links(&self, statement: &Statement, sign: i8, selected: &Line<bool>) -> Found<Vec<Truths>> {
        match statement {
            Statement::Relation { sides, kinds, .. } => {
                let mut found = Vec::new();
                for (pair, kind) in sides.windows(2).zip(kinds) {
                    let mut components = Vec::new();
                    for (l, r) in pair[0].iter().zip(&pair[1]) {
                        // u ≠ v is ¬(u = v): some component differs.
                        components.push(self.atom(&self.line(l, sign)?, *kind, &self.line(r, sign)?)?);
                    }
                    if *kind == Kind::Different {
                        let either = components.into_iter().reduce(|a, b| a.zip(&b, |p, q| or(*p, *q)));
                        found.extend(either);
                    } else {
                        found.extend(components);
                    }
                }
                Ok(found)
            }
            Statement::Limit { of, at, kind, value } => {
                // What does not move is known at all times, as one may see it.
                let known = if self.reading.beyond && !of.moves() { None } else { self.known.clone() };
                // A limit goes through the times that the selectors leave; `at` selects none.
                let all = self.valued(&self.selected()?)?;
                let everywhere = selected.pieces.iter().all(|s| *s);
                let selected = match (&self.claim.at, everywhere) {
                    (Some(_), false) => &all[usize::from(sign < 0)],
                    (None, _) | (Some(_), true) => selected,
                };
                let limit = self.limit(&self.line(of, sign)?, &known, at, *kind, value, selected)?;
                Ok(vec![Line::constant(limit)])
            }
        }
    }

    fn limit(
        &self,
        of: &Line<Value>,
        known: &Option<(Q, Q)>,
        at: &Option<Q>,
        kind: Kind,
        value: &Q,
        selected: &Line<bool>,
    ) -> Found<Truth> {
        let line = of.zip(selected, |v, s| if *s { v.clone() } else { Value::Nothing });
        let line = line.cut(at.as_slice()).cut(&ends(known));
        let inside = line.within(known);
        let mut limits = Vec::new();
        match at {
            None => {
                let last = line.pieces.len() - 1;
                if inside.contains(&last) && line.pieces[last] != Value::Nothing {
                    limits.push(line.pieces[last].limit_at_infinity()?);
                }
            }
            Some(c) => {
                let i = 2 * line.cuts.iter().position(|k| k == c).ok_or(Irrational)? + 1;
                for side in [i - 1, i + 1] {
                    if inside.contains(&side) && line.pieces[side] != Value::Nothing {
                        limits.push(line.pieces[side].limit(c)?);
                    }
                }
            }
        }
        let Some(first) = limits.first().cloned() else { return Ok(Void) };
        let Some(limit) = first.filter(|f| limits.iter().all(|l| l.as_ref() == Some(f))) else { return Ok(False) };
        let truth =
            self.atom(&Line::constant(Value::number(limit)), kind, &Line::constant(Value::number(value.clone())))?;
        Ok(truth.pieces[0])
    }

    fn together(&self, statement: &Statement, sign: i8, selected: &Line<bool>) -> Found<Truths> {
        let links = self.links(statement, sign, selected)?;
        Ok(links.into_iter().reduce(|a, b| a.zip(&b, |p, q| and(*p, *q))).unwrap_or(Line::constant(True)))
    }

    fn text(&self, text: &Text, sign: i8, selected: &Line<bool>) -> Found<Truths> {
        let mut found = Line::constant(True);
        for s in text {
            found = found.zip(&self.together(s, sign, selected)?, |p, q| and(*p, *q));
        }
        Ok(found)
    }

    fn is_selector(&self, s: &Statement) -> bool {
        match s {
            Statement::Limit { .. } => false,
            Statement::Relation { kinds, .. } => {
                self.claim.scene == Scene::Box
                    || self.claim.scene == Scene::All
                    || kinds.iter().any(|k| *k != Kind::Equal)
            }
        }
    }

    /// Whether ± stands in what is claimed.
    fn claimed_sign(&self) -> bool {
        self.claim.forms.iter().any(form_has_sign)
    }

    /// Points that the selectors leave, before events.
    fn selected(&self) -> Found<Counting> {
        let nothing_known = Line::constant(true);
        let mut found = Vec::new();
        for sign in SIGNS {
            let mut s = Line::constant(true);
            for statement in self.claim.assuming.iter().flatten().filter(|s| self.is_selector(s)) {
                let t = if statement.has_sign() && is_different(statement) {
                    self.neither(statement, &nothing_known)?
                } else {
                    self.together(statement, sign, &nothing_known)?
                };
                s = s.zip(&t, |s, t| *s && *t == True);
            }
            found.push(s);
        }
        self.joined(found)
    }

    /// Of these the points at which assumed equations have values.
    fn valued(&self, selected: &Counting) -> Found<Counting> {
        let mut found = Vec::new();
        for (k, sign) in SIGNS.into_iter().enumerate() {
            let mut s = selected[k].clone();
            for statement in self.claim.assuming.iter().flatten().filter(|s| !self.is_selector(s)) {
                let Statement::Relation { .. } = statement else { continue };
                let t = self.together(statement, sign, &Line::constant(true))?;
                s = s.zip(&t, |s, t| *s && *t != Void);
            }
            found.push(s);
        }
        self.joined(found)
    }

    /// With ± in assumptions alone, some sign serves.
    fn joined(&self, mut found: Vec<Line<bool>>) -> Found<Counting> {
        let minus = found.pop().ok_or(Irrational)?;
        let plus = found.pop().ok_or(Irrational)?;
        if self.claimed_sign() {
            return Ok([plus, minus]);
        }
        let either = plus.zip(&minus, |p, q| *p || *q);
        Ok([either.clone(), either])
    }

    fn counting(&self, selected: &Counting) -> Found<Counting> {
        let Some((l, r)) = &self.claim.at else { return Ok(selected.clone()) };
        let mut found = Vec::new();
        for (sign, s) in SIGNS.into_iter().zip(selected) {
            let event = self.atom(&self.line(l, sign)?, Kind::Equal, &self.line(r, sign)?)?;
            found.push(s.zip(&event, |s, t| *s && *t == True));
        }
        self.joined(found)
    }

    /// Hypotheses on the motion, for each sign.
    fn hypotheses(&self, selected: &Counting) -> Found<[Truth; 2]> {
        let everywhere = Line::constant(true);
        let mut found = [True, True];
        for (k, sign) in SIGNS.into_iter().enumerate() {
            for statement in self.claim.assuming.iter().flatten().filter(|s| !self.is_selector(s)) {
                let t = match statement {
                    Statement::Limit { .. } => self.together(statement, sign, &everywhere)?.pieces[0],
                    Statement::Relation { .. } => {
                        let links = self.links(statement, sign, &everywhere)?;
                        let links = if self.reading.parts {
                            links
                        } else {
                            vec![self.together(statement, sign, &everywhere)?]
                        };
                        links.iter().map(|t| every(t, &selected[k], &self.range)).fold(True, and)
                    }
                };
                found[k] = and(found[k], t);
            }
        }
        Ok(found)
    }

    /// As [`Scope::hypotheses`], where the sign may change with time.
    fn changing_hypothesis(&self, selected: &Counting) -> Found<Truth> {
        let everywhere = Line::constant(true);
        let mut signs = Vec::new();
        for sign in SIGNS {
            let mut line = Line::constant(True);
            for statement in self.claim.assuming.iter().flatten().filter(|s| !self.is_selector(s)) {
                line = line.zip(&self.together(statement, sign, &everywhere)?, |p, q| and(*p, *q));
            }
            signs.push(line);
        }
        let either = signs[0].zip(&signs[1], |p, q| or_counted(*p, *q));
        Ok(every(&either, &selected[0], &self.range))
    }

    fn claim(&self) -> Found<Truth> {
        let selected = self.selected()?;
        let hypotheses = self.hypotheses(&selected)?;
        let selected = self.valued(&selected)?;
        let counting = self.counting(&selected)?;
        if self.claimed_sign() {
            let shared = self.claim.assuming.iter().any(text_has_sign)
                || self.claim.at.iter().any(|(l, r)| l.has_sign() || r.has_sign());
            if shared {
                // Upper with upper: ∀± (P given C).
                let hypothetical = self.claim.assuming.iter().flatten().any(|s| !self.is_selector(s) && s.has_sign());
                if hypothetical && self.reading.changing && !self.claim.throughout {
                    return self.shared_pointwise(&counting, &selected);
                }
                let mut found = Vec::new();
                for (k, sign) in SIGNS.into_iter().enumerate() {
                    found.push(given(self.with_sign(sign, &counting[k])?, hypotheses[k]));
                }
                return Ok(all(found));
            }
            return Ok(given(self.forms(&counting)?, hypotheses[0]));
        }
        let signed = self.claim.assuming.iter().flatten().any(|s| !self.is_selector(s) && s.has_sign());
        let hypothesis =
            if signed && self.reading.changing { self.changing_hypothesis(&selected)? } else { some(hypotheses) };
        Ok(given(self.forms(&counting)?, hypothesis))
    }

    /// ∀t ∀± (P given C).
    fn shared_pointwise(&self, counting: &Counting, selected: &Counting) -> Found<Truth> {
        let mut found = Vec::new();
        for (k, sign) in SIGNS.into_iter().enumerate() {
            let mut c = selected[k].clone();
            for s in self.claim.assuming.iter().flatten().filter(|s| !self.is_selector(s)) {
                c = c.zip(&self.together(s, sign, &Line::constant(true))?, |c, t| *c && *t == True);
            }
            let c = c.zip(&counting[k], |a, b| *a && *b);
            found.push(self.with_sign(sign, &c)?);
        }
        Ok(all(found))
    }

    /// All forms with one sign put in.
    fn with_sign(&self, sign: i8, s: &Line<bool>) -> Found<Truth> {
        let mut found = True;
        for form in &self.claim.forms {
            found = and(found, self.form(form, sign, s)?);
        }
        Ok(found)
    }

    /// All forms where ± stands in what is claimed alone, or nowhere.
    fn forms(&self, counting: &Counting) -> Found<Truth> {
        let s = &counting[0];
        let mut found = True;
        // All relations of `always` and `defined` with ± together.
        let mut together: [Vec<Truths>; 2] = [Vec::new(), Vec::new()];
        for form in &self.claim.forms {
            match form {
                Form::Always(texts) => {
                    for text in texts {
                        for statement in text {
                            if statement.has_sign() && is_different(statement) {
                                let t = self.signed_different(statement, s)?;
                                found = and(found, t);
                            } else if statement.has_sign() {
                                for (k, sign) in SIGNS.into_iter().enumerate() {
                                    together[k].push(self.together(statement, sign, s)?);
                                }
                            } else {
                                found = and(found, self.relation(statement, 1, s)?);
                            }
                        }
                    }
                }
                Form::Defined(shaped) if form_has_sign(form) => {
                    for (_, components) in shaped {
                        for (k, sign) in SIGNS.into_iter().enumerate() {
                            for c in components {
                                together[k]
                                    .push(self.line(c, sign)?.map(|v| if *v == Value::Nothing { False } else { True }));
                            }
                        }
                    }
                }
                Form::Never(texts) | Form::Eventually(texts) if form_has_sign(form) => {
                    for text in texts {
                        let p = self.text(text, 1, s)?;
                        let mut either = p.zip(&self.text(text, -1, s)?, |p, q| or_counted(*p, *q));
                        if let Some(different) = text.iter().find(|s| s.has_sign() && is_different(s)) {
                            either = self.neither(different, s)?;
                        }
                        let t = any(&either, s, &self.range);
                        found = and(found, if matches!(form, Form::Never(_)) { not(t) } else { t });
                    }
                }
                Form::FirstIntegral(_) if form_has_sign(form) => {
                    let signs = [self.form(form, 1, s)?, self.form(form, -1, s)?];
                    found = and(found, some(signs));
                }
                Form::Never(_)
                | Form::Eventually(_)
                | Form::FirstIntegral(_)
                | Form::Defined(_)
                | Form::Solves(..)
                | Form::SameMotion(..)
                | Form::Independent(_)
                | Form::Exists { .. } => found = and(found, self.form(form, 1, s)?),
            }
        }
        if !together[0].is_empty() {
            let line = |k: usize| {
                let parts = together[k].iter();
                parts.fold(Line::constant(True), |a: Truths, b| a.zip(b, |p, q| and(*p, *q)))
            };
            let (plus, minus) = (line(0), line(1));
            let t = if self.claim.throughout {
                some([every(&plus, s, &self.range), every(&minus, s, &self.range)])
            } else {
                every(&plus.zip(&minus, |p, q| or_counted(*p, *q)), s, &self.range)
            };
            found = and(found, t);
        }
        Ok(found)
    }

    /// l ≠ r with ± says that neither sign makes them equal.
    fn signed_different(&self, statement: &Statement, s: &Line<bool>) -> Found<Truth> {
        Ok(every(&self.neither(statement, s)?, s, &self.range))
    }

    fn neither(&self, statement: &Statement, s: &Line<bool>) -> Found<Truths> {
        let p = self.together(statement, 1, s)?.map(|t| not(*t));
        let q = self.together(statement, -1, s)?.map(|t| not(*t));
        Ok(p.zip(&q, |p, q| not(or_counted(*p, *q))))
    }

    /// ∀t. R of `always`.
    fn relation(&self, statement: &Statement, sign: i8, s: &Line<bool>) -> Found<Truth> {
        if self.reading.parts {
            let links = self.links(statement, sign, s)?;
            return Ok(links.iter().map(|t| every(t, s, &self.range)).fold(True, and));
        }
        Ok(every(&self.together(statement, sign, s)?, s, &self.range))
    }

    fn form(&self, form: &Form, sign: i8, s: &Line<bool>) -> Found<Truth> {
        let range = &self.range;
        let mut found = True;
        match form {
            Form::Always(texts) => {
                for statement in texts.iter().flatten() {
                    found = and(found, self.relation(statement, sign, s)?);
                }
            }
            Form::Never(texts) => {
                for text in texts {
                    found = and(found, not(any(&self.text(text, sign, s)?, s, range)));
                }
            }
            Form::Eventually(texts) => {
                for text in texts {
                    found = and(found, any(&self.text(text, sign, s)?, s, range));
                }
            }
            Form::FirstIntegral(shaped) => {
                for e in shaped {
                    found = and(found, self.constant(e, sign, s)?);
                }
            }
            Form::Defined(shaped) => {
                for c in shaped.iter().flat_map(|(_, c)| c) {
                    let has = self.line(c, sign)?.map(|v| if *v == Value::Nothing { False } else { True });
                    found = and(found, every(&has, s, range));
                }
            }
            Form::Solves(p, q) => {
                for (state, rate) in [(Term::X, p), (Term::Y, q)] {
                    let l = self.line(&super::term::rate(state), sign)?;
                    let t = self.atom(&l, Kind::Equal, &self.line(rate, sign)?)?.map(|t| assert(*t));
                    found = and(found, every(&t, s, range));
                }
            }
            Form::SameMotion(x, other) => {
                let l = self.line(&Term::X, sign)?;
                let t =
                    self.atom(&l, Kind::Equal, &x.line(&Setting { sign, motion: self.claim.motion, known: None })?)?;
                let Some((a, b)) = range else { return Err(Irrational) };
                let common = (a.max(&other.0).clone(), b.min(&other.1).clone());
                found = every(&t, s, &Some(common));
            }
            Form::Independent(Some(b)) => {
                let determinant = super::term::sub(Term::X, Term::Number(b.clone()));
                let zero = Line::constant(Value::number(Q::ZERO));
                found = every(&self.atom(&self.line(&determinant, sign)?, Kind::Different, &zero)?, s, range);
            }
            Form::Independent(None) => found = every(&Line::constant(False), s, range),
            Form::Exists { .. } => found = every(&self.exists(form)?, s, range),
        }
        Ok(found)
    }

    /// ∀t,t' that count: equal, wherever both have values.
    fn constant(&self, (_, components): &Shaped, sign: i8, s: &Line<bool>) -> Found<Truth> {
        let mut each = Vec::new();
        let mut all_have = Line::constant(true);
        for c in components {
            let line =
                self.line(c, sign)?.zip(s, |v, s| if *s { v.clone() } else { Value::Nothing }).cut(&ends(&self.range));
            let mut first: Option<Q> = None;
            let mut t = Void;
            for i in line.within(&self.range) {
                if line.pieces[i] == Value::Nothing {
                    continue;
                }
                let same = line.pieces[i].same_number(&line.inside(i))?;
                let differs = same.is_none() || first.as_ref().is_some_and(|f| same.as_ref() != Some(f));
                t = if differs || t == False { False } else { True };
                first = first.or(same);
            }
            all_have = all_have.zip(&line, |a, v| *a && *v != Value::Nothing);
            each.push(t);
        }
        let found = each.into_iter().fold(True, and);
        if found == False || self.reading.parts {
            return Ok(found);
        }
        let at_once = all_have.map(|h| if *h { True } else { Void });
        Ok(every(&at_once, s, &self.range))
    }

    /// Where a solution u exists: u enters linearly, or through two factors, see `draw.rs`.
    fn exists(&self, form: &Form) -> Found<Truths> {
        let Form::Exists { range: (low, high), equation: (l, r), also, unique } = form else { return Err(Irrational) };
        // (u − g)(u − h) w = 0: the roots are lines; w decides where there is a value.
        let roots = roots(l).ok_or(Irrational)?;
        if *r != super::term::number(0) {
            return Err(Irrational);
        }
        let hole = weight(l).map(|w| self.line(w, 1)).transpose()?;
        let mut serve: Vec<(Line<Value>, Truths)> = Vec::new();
        for root in roots {
            let u = self.line(root, 1)?;
            let inside = |a: &Q, k: Kind| self.atom(&u, k, &Line::constant(Value::number(a.clone())));
            let mut t = inside(low, Kind::AtLeast)?.zip(&inside(high, Kind::AtMost)?, |p, q| and(*p, *q));
            if let Some((_, kind, bound)) = also.as_deref() {
                let other = self.atom(&u, *kind, &self.line(bound, 1)?)?;
                t = t.zip(&other, |p, q| and(*p, *q));
            }
            if let Some(h) = &hole {
                t = t.zip(h, |t, v| if *v == Value::Nothing { False } else { *t });
            }
            serve.push((u, t.map(|t| assert(*t))));
        }
        let one = serve.iter().fold(Line::constant(False), |a: Truths, (_, t)| a.zip(t, |p, q| or(*p, *q)));
        if !*unique || serve.len() < 2 {
            return Ok(one);
        }
        let same = self.atom(&serve[0].0, Kind::Equal, &serve[1].0)?;
        let both = serve[0].1.zip(&serve[1].1, |p, q| and(*p, *q)).zip(&same, |b, s| and(*b, not(*s)));
        Ok(one.zip(&both, |o, b| and(*o, not(*b))))
    }
}

/// Quantifier over signs at one point: what is void is not counted.
fn or_counted(p: Truth, q: Truth) -> Truth {
    some([p, q])
}

fn is_different(statement: &Statement) -> bool {
    matches!(statement, Statement::Relation { kinds, .. } if kinds.as_slice() == [Kind::Different])
}

/// The roots g of factors u − g, of a product.
fn roots(term: &Term) -> Option<Vec<&Term>> {
    match term {
        Term::Sub(u, g) if **u == Term::U => Some(vec![g]),
        Term::Mul(e, f) => {
            let (mut e, f) = (roots(e)?, roots(f).unwrap_or_default());
            e.extend(f);
            Some(e)
        }
        _ => None,
    }
}

/// The last factor without the unknown: positive where it has a value.
fn weight(term: &Term) -> Option<&Term> {
    match term {
        Term::Mul(_, f) if roots(f).is_none() => Some(f),
        _ => None,
    }
}

pub fn form_has_sign(form: &Form) -> bool {
    let shaped = |e: &[Shaped]| e.iter().flat_map(|(_, c)| c).any(Term::has_sign);
    match form {
        Form::Always(t) | Form::Never(t) | Form::Eventually(t) => t.iter().any(text_has_sign),
        Form::FirstIntegral(e) | Form::Defined(e) => shaped(e),
        Form::Solves(..) | Form::SameMotion(..) | Form::Independent(_) | Form::Exists { .. } => false,
    }
}
