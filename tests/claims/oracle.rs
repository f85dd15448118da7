//! The oracle itself: examples by hand, and its functions against plain evaluation at points.

use super::claim::{Claim, Form, Kind, Scene, Shape, Statement};
use super::draw::{Chance, Draw};
use super::line::{Q, Value, fraction, sign_of, whole};
use super::logic::Truth;
use super::term::{Function, Motion, Setting, Term, abs, add, div, mul, number, of, power, rate, signed, sub};
use super::truth::truth;

fn relation(l: Term, kind: Kind, r: Term) -> Statement {
    Statement::Relation { shape: Shape::Scalar, sides: vec![vec![l], vec![r]], kinds: vec![kind] }
}

fn pair(l: [Term; 3], kind: Kind, r: [Term; 3]) -> Statement {
    Statement::Relation { shape: Shape::Three, sides: vec![l.to_vec(), r.to_vec()], kinds: vec![kind] }
}

/// x = t on [−1, 2] by formula, y = 2.
fn on_the_line(form: Form) -> Claim {
    Claim {
        scene: Scene::Formula,
        span: 1,
        motion: Motion::Forward,
        forms: vec![form],
        assuming: Vec::new(),
        at: None,
        throughout: false,
        role: "abbreviation",
        later: 0,
    }
}

fn root(e: Term) -> Term {
    of(Function::Root, e)
}

#[test]
fn examples_of_the_page() {
    use Kind::{Different, Equal, Less};
    let x = || Term::X;
    let n = number;
    let always = |s: Statement| on_the_line(Form::Always(vec![vec![s]]));
    let assuming = |s: Statement, c: Claim| Claim { assuming: vec![vec![s]], ..c };
    let chain = Statement::Relation {
        shape: Shape::Scalar,
        sides: vec![vec![n(3)], vec![Term::Y], vec![add(x(), mul(n(0), root(x())))]],
        kinds: vec![Less, Less],
    };
    let void = || relation(mul(n(0), root(sub(x(), n(10)))), Equal, x());
    let rows: Vec<(&str, Claim, Truth)> = vec![
        ("F∧V = F", always(chain), Truth::False),
        ("V∧T = V", on_the_line(Form::Always(vec![vec![void()], vec![relation(Term::Y, Equal, n(2))]])), Truth::Void),
        ("never of what has no value", on_the_line(Form::Never(vec![vec![void()]])), Truth::Void),
        ("eventually of what has no value", on_the_line(Form::Eventually(vec![vec![void()]])), Truth::Void),
        ("some component differs", always(pair([x(), n(0), n(1)], Different, [n(5), n(0), n(1)])), Truth::True),
        (
            "never different",
            on_the_line(Form::Never(vec![vec![pair([x(), n(0), n(1)], Different, [n(5), n(0), n(1)])]])),
            Truth::False,
        ),
        ("one sign at each time", always(relation(abs(x()), Equal, signed(true, x()))), Truth::True),
        (
            "no sign throughout",
            Claim { throughout: true, ..always(relation(abs(x()), Equal, signed(true, x()))) },
            Truth::False,
        ),
        ("neither sign", always(relation(x(), Different, signed(true, n(1)))), Truth::False),
        (
            "upper with upper",
            assuming(
                relation(x(), Less, signed(true, n(0))),
                on_the_line(Form::Always(vec![vec![relation(signed(true, n(1)), Less, n(0))]])),
            ),
            Truth::False,
        ),
        (
            "constant where it counts",
            assuming(
                relation(x(), Less, n(0)),
                on_the_line(Form::FirstIntegral(vec![(Shape::Scalar, vec![add(abs(x()), x())])])),
            ),
            Truth::True,
        ),
        (
            "not constant across a gap",
            on_the_line(Form::FirstIntegral(vec![(Shape::Scalar, vec![div(x(), abs(x()))])])),
            Truth::False,
        ),
        (
            "a rate at no kink",
            on_the_line(Form::Defined(vec![(Shape::Scalar, vec![rate(mul(x(), abs(x())))])])),
            Truth::True,
        ),
        ("no rate at a kink", on_the_line(Form::Defined(vec![(Shape::Scalar, vec![rate(abs(x()))])])), Truth::False),
        ("a hole in a right side", on_the_line(Form::Solves(add(n(1), mul(n(0), power(x(), -1))), n(0))), Truth::False),
        ("no event", Claim { at: Some((x(), n(3))), ..always(relation(x(), Equal, n(7))) }, Truth::Void),
        (
            "an assumption that is not met",
            assuming(relation(Term::Y, Equal, n(7)), always(relation(x(), Equal, n(7)))),
            Truth::Void,
        ),
        (
            "a limit is no value",
            assuming(
                Statement::Limit { of: x(), at: Some(whole(1)), kind: Equal, value: whole(1) },
                always(relation(x(), Equal, n(1))),
            ),
            Truth::False,
        ),
        (
            "two sides, no limit",
            on_the_line(Form::Eventually(vec![vec![Statement::Limit {
                of: div(x(), abs(x())),
                at: Some(whole(0)),
                kind: Equal,
                value: whole(1),
            }]])),
            Truth::False,
        ),
    ];
    for (name, claim, expected) in rows {
        assert_eq!(truth(&claim), Ok(vec![expected]), "{name}:\n{}", claim.toml("c"));
    }
}

/// The value at a point, where only rational operations, |·| and squares under roots occur.
fn plain(e: &Term, t: &Q) -> Option<Option<Q>> {
    let both = |e: &Term, f: &Term| Some((plain(e, t)?, plain(f, t)?));
    let with = |p: (Option<Q>, Option<Q>), f: fn(Q, Q) -> Q| p.0.zip(p.1).map(|(a, b)| f(a, b));
    Some(match e {
        Term::Number(q) => Some(q.clone()),
        Term::T | Term::X => Some(t.clone()),
        Term::Y => Some(whole(2)),
        Term::A => Some(fraction(3, 2)),
        Term::Neg(e) => plain(e, t)?.map(|v| -v),
        Term::Signed(upper, e) => plain(e, t)?.map(|v| if *upper { v } else { -v }),
        Term::Add(e, f) => with(both(e, f)?, |a, b| a + b),
        Term::Sub(e, f) => with(both(e, f)?, |a, b| a - b),
        Term::Mul(e, f) => with(both(e, f)?, |a, b| a * b),
        Term::Div(e, f) => {
            let (a, b) = both(e, f)?;
            a.zip(b.filter(|b| !b.is_zero())).map(|(a, b)| a / b)
        }
        Term::Abs(e) => plain(e, t)?.map(|v| if sign_of(&v) < 0 { -v } else { v }),
        Term::Power(e, n) => plain(e, t)?.filter(|v| *n > 0 || !v.is_zero()).map(|v| {
            let p = (0..n.unsigned_abs()).fold(whole(1), |p, _| p * &v);
            if *n < 0 { whole(1) / p } else { p }
        }),
        Term::Named(e) => plain(e, t)?,
        Term::U | Term::Of(..) | Term::Rate(_) | Term::At(..) => return None,
    })
}

#[test]
fn functions_agree_with_plain_evaluation() {
    let mut chance = Chance::new(11);
    let mut compared = 0;
    let setting = Setting { sign: 1, motion: Motion::Forward, known: None };
    for _ in 0..400 {
        let mut draw = Draw {
            chance: &mut chance,
            scene: Scene::Formula,
            span: 2,
            motion: Motion::Forward,
            events: Vec::new(),
            near: false,
        };
        let term = draw.difference();
        let Ok(line) = term.line(&setting) else { continue };
        for n in -60..=60 {
            let t = fraction(n, 10);
            let Some(value) = plain(&term, &t) else { break };
            let at = line.cut(std::slice::from_ref(&t));
            let i = 2 * at.cuts.iter().position(|c| *c == t).expect("it was cut there") + 1;
            let found = match &at.pieces[i] {
                Value::Nothing => None,
                piece => Some(piece.same_number(&t).expect("a number").expect("one number at one point")),
            };
            assert_eq!(found, value, "{} at {t}", term.latex());
            compared += 1;
        }
    }
    assert!(compared > 10_000, "{compared}");
}
