//! Other ways to say the same: what may not change a verdict, nor whether it is rigorous.

use super::claim::{Claim, Form, Kind, Scene, Shape, Statement, Text, later, text_has_sign};
use super::line::whole;
use super::term::{Term, add, mul, number, power};

/// What must become of a verdict.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kept {
    /// It stays, and stays rigorous or sampled.
    Same,
    /// What held fails, and what failed holds.
    Opposite,
    /// What was decided fails.
    Fails,
    /// Holds never becomes fails, nor fails holds; the rest may change.
    Agreement,
}

pub type Rule = (&'static str, Kept, fn(&Claim) -> Option<Claim>);

pub const RULES: &[Rule] = &[
    ("sides are swapped", Kept::Same, swapped),
    ("texts are split", Kept::Same, split),
    ("texts are joined", Kept::Same, joined),
    ("texts and assumptions are reordered", Kept::Same, reordered),
    ("always different becomes never equal", Kept::Same, never_equal),
    ("never becomes eventually", Kept::Opposite, eventually),
    ("scalars become vectors", Kept::Same, vectors),
    ("vectors become their components", Kept::Same, components),
    ("a term becomes an abbreviation", Kept::Same, abbreviated),
    ("a term becomes an observable", Kept::Same, observed),
    ("all happens later", Kept::Same, shifted),
    ("a true assumption is added", Kept::Same, assumed),
    ("plus-minus becomes minus-plus", Kept::Same, renamed_sign),
    ("a true conjunct is added", Kept::Same, true_conjunct),
    ("a false conjunct is added", Kept::Fails, false_conjunct),
    ("squares become products", Kept::Same, products),
    ("zero is added to a side", Kept::Same, padded),
    ("the motion is given by its formula", Kept::Agreement, formula),
    ("the motion is derived", Kept::Agreement, derived),
];

fn changed(claim: &Claim, to: Claim) -> Option<Claim> {
    (to != *claim).then_some(to)
}

fn with_texts(claim: &Claim, f: impl Fn(&[Text]) -> Vec<Text>) -> Claim {
    let mut c = claim.clone();
    c.assuming = f(&c.assuming);
    for form in &mut c.forms {
        if let Form::Always(t) = form {
            *t = f(t);
        }
    }
    c
}

fn each_statement(claim: &Claim, f: impl Fn(&mut Statement)) -> Claim {
    let mut c = claim.clone();
    c.assuming.iter_mut().flatten().for_each(&f);
    for form in &mut c.forms {
        if let Form::Always(t) | Form::Never(t) | Form::Eventually(t) = form {
            t.iter_mut().flatten().for_each(&f);
        }
    }
    c
}

fn swapped(claim: &Claim) -> Option<Claim> {
    let mut c = each_statement(claim, |s| {
        if let Statement::Relation { sides, kinds, .. } = s {
            sides.reverse();
            kinds.reverse();
            for k in kinds {
                *k = match *k {
                    Kind::Equal => Kind::Equal,
                    Kind::Different => Kind::Different,
                    Kind::Less => Kind::Greater,
                    Kind::AtMost => Kind::AtLeast,
                    Kind::Greater => Kind::Less,
                    Kind::AtLeast => Kind::AtMost,
                };
            }
        }
    });
    c.at = c.at.map(|(l, r)| (r, l));
    changed(claim, c)
}

fn split(claim: &Claim) -> Option<Claim> {
    changed(claim, with_texts(claim, |t| t.iter().flatten().map(|s| vec![s.clone()]).collect()))
}

fn joined(claim: &Claim) -> Option<Claim> {
    let join = |t: &[Text]| if t.is_empty() { Vec::new() } else { vec![t.iter().flatten().cloned().collect()] };
    changed(claim, with_texts(claim, join))
}

fn reordered(claim: &Claim) -> Option<Claim> {
    let mut c = with_texts(claim, |t| t.iter().rev().map(|s| s.iter().rev().cloned().collect()).collect());
    c.forms.reverse();
    changed(claim, c)
}

/// The one relation of a claim that says no more.
fn single(texts: &[Text]) -> Option<(Shape, &Vec<Vec<Term>>, Kind)> {
    match texts {
        [text] => match &text[..] {
            [Statement::Relation { shape, sides, kinds }] if kinds.len() == 1 => Some((*shape, sides, kinds[0])),
            _ => None,
        },
        _ => None,
    }
}

fn never_equal(claim: &Claim) -> Option<Claim> {
    let [Form::Always(texts)] = &claim.forms[..] else { return None };
    let (shape, sides, Kind::Different) = single(texts)? else { return None };
    if claim.scene == Scene::Box {
        return None;
    }
    let equal = Statement::Relation { shape, sides: sides.clone(), kinds: vec![Kind::Equal] };
    Some(Claim { forms: vec![Form::Never(vec![vec![equal]])], ..claim.clone() })
}

fn eventually(claim: &Claim) -> Option<Claim> {
    let [Form::Never(texts)] = &claim.forms[..] else { return None };
    let shared = texts.iter().chain(&claim.assuming).any(text_has_sign);
    (texts.len() == 1 && !shared).then(|| Claim { forms: vec![Form::Eventually(texts.clone())], ..claim.clone() })
}

fn vectors(claim: &Claim) -> Option<Claim> {
    let mut c = each_statement(claim, |s| {
        if let Statement::Relation { shape, kinds, .. } = s
            && *shape == Shape::Scalar
            && kinds.iter().all(|k| matches!(k, Kind::Equal | Kind::Different))
        {
            *shape = Shape::One;
        }
    });
    for form in &mut c.forms {
        if let Form::FirstIntegral(e) | Form::Defined(e) = form {
            for (shape, _) in e.iter_mut().filter(|(s, _)| *s == Shape::Scalar) {
                *shape = Shape::One;
            }
        }
    }
    changed(claim, c)
}

fn components(claim: &Claim) -> Option<Claim> {
    let apart = |t: &[Text]| -> Vec<Text> {
        let one = |s: &Statement| match s {
            Statement::Relation { sides, kinds, .. } if kinds.as_slice() == [Kind::Equal] => (0..sides[0].len())
                .map(|i| Statement::Relation {
                    shape: Shape::Scalar,
                    sides: sides.iter().map(|s| vec![s[i].clone()]).collect(),
                    kinds: kinds.clone(),
                })
                .collect(),
            s => vec![s.clone()],
        };
        t.iter().map(|text| text.iter().flat_map(one).collect()).collect()
    };
    let mut c = with_texts(claim, apart);
    for form in &mut c.forms {
        if let Form::FirstIntegral(e) | Form::Defined(e) = form {
            *e = e.iter().flat_map(|(_, c)| c.iter().map(|t| (Shape::Scalar, vec![t.clone()]))).collect();
        }
    }
    changed(claim, c)
}

/// The first term that is more than a name, named.
fn named(claim: &Claim, role: &'static str) -> Option<Claim> {
    let mut c = Claim { role, ..claim.clone() };
    let mut done = false;
    c.for_each_term(&mut |t| {
        if !done && t.parts().len() > 1 && !t.has_sign() {
            *t = Term::Named(Box::new(t.clone()));
            done = true;
        }
    });
    (done && claim.scene != Scene::All).then_some(c)
}

fn abbreviated(claim: &Claim) -> Option<Claim> {
    named(claim, "abbreviation")
}

fn observed(claim: &Claim) -> Option<Claim> {
    named(claim, "observable").filter(|c| c.scene != Scene::Box)
}

fn shifted(claim: &Claim) -> Option<Claim> {
    if matches!(claim.scene, Scene::Box | Scene::All) {
        return None;
    }
    let n = 5;
    let mut c = Claim { later: n, ..claim.clone() };
    c.for_each_term(&mut |t| *t = later(t, n));
    c = each_statement(&c, |s| {
        if let Statement::Limit { at: Some(at), .. } = s {
            *at = &*at + whole(n);
        }
    });
    for form in &mut c.forms {
        if let Form::SameMotion(x, (a, b)) = form {
            *x = later(x, n);
            *a = &*a + whole(n);
            *b = &*b + whole(n);
        }
    }
    Some(c)
}

fn positive() -> Statement {
    let l = add(power(Term::X, 2), number(1));
    Statement::Relation { shape: Shape::Scalar, sides: vec![vec![l], vec![number(0)]], kinds: vec![Kind::Greater] }
}

fn assumed(claim: &Claim) -> Option<Claim> {
    let mut c = claim.clone();
    c.assuming.push(vec![positive()]);
    Some(c)
}

fn renamed_sign(claim: &Claim) -> Option<Claim> {
    let mut c = claim.clone();
    c.for_each_term(&mut |t| {
        *t = t.map(&|t| match t {
            Term::Signed(upper, e) => Term::Signed(!upper, e),
            t => t,
        });
    });
    changed(claim, c)
}

fn with_conjunct(claim: &Claim, s: Statement) -> Option<Claim> {
    let mut c = claim.clone();
    match c.forms.iter_mut().find_map(|f| if let Form::Always(t) = f { Some(t) } else { None }) {
        Some(texts) => texts.push(vec![s]),
        None if c.scene == Scene::Box => return None,
        None => c.forms.push(Form::Always(vec![vec![s]])),
    }
    (c.scene != Scene::All).then_some(c)
}

fn true_conjunct(claim: &Claim) -> Option<Claim> {
    with_conjunct(claim, positive())
}

fn false_conjunct(claim: &Claim) -> Option<Claim> {
    let one = Statement::Relation {
        shape: Shape::Scalar,
        sides: vec![vec![Term::Y], vec![number(3)]],
        kinds: vec![Kind::Equal],
    };
    with_conjunct(claim, one)
}

fn products(claim: &Claim) -> Option<Claim> {
    let mut c = claim.clone();
    c.for_each_term(&mut |t| {
        *t = t.map(&|t| match t {
            Term::Power(e, 2) => mul((*e).clone(), *e),
            t => t,
        });
    });
    changed(claim, c)
}

fn padded(claim: &Claim) -> Option<Claim> {
    let c = each_statement(claim, |s| {
        if let Statement::Relation { sides, .. } = s {
            let side = &mut sides[0][0];
            *side = add(side.clone(), number(0));
        }
    });
    changed(claim, c)
}

fn formula(claim: &Claim) -> Option<Claim> {
    (claim.scene == Scene::Integrated).then(|| Claim { scene: Scene::Formula, ..claim.clone() })
}

fn derived(claim: &Claim) -> Option<Claim> {
    (claim.scene == Scene::Formula).then(|| Claim { scene: Scene::Derived, ..claim.clone() })
}
