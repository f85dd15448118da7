//! Fields of one coordinate as motions along it: a field by a polynomial refutes what is claimed of several places.
//!
//! Each claim is true of every field on which what is given holds, by construction, or of none: it is one that follows, with a number added.

use crate::known_when::{Line, asked};
use crate::prove_traps::all;

const SYMBOLS: &[&str] = &["x: coordinate", "f(x): field", "g(x): field"];

/// What is given, and both sides of what follows.
fn made(rng: &mut impl FnMut(i64) -> i64) -> (Vec<String>, String, String) {
    let (a, b, c, k) = (rng(4) - 1, rng(4) - 1, rng(4) - 1, rng(5) - 2);
    let derived = |n: u8| if n == 1 { r"\frac{df}{dx}" } else { r"\frac{d^2f}{dx^2}" };
    let at = |field: &str, place: i64| format!("{field}({place})");
    match rng(7) {
        0 => {
            let right = format!("({})f({a})+({})f({b})", b - c, c - a);
            (vec![format!("{}=0", derived(2))], format!("({})f({c})", b - a), right)
        }
        1 => (vec![format!("{}={k}", derived(1))], at("f", b), format!("f({a})+({})", k * (b - a))),
        2 => (vec![format!("f=g+{k}x")], at("f", a), format!("g({a})+({})", k * a)),
        3 => (vec![format!("f({a})f=f({a})^2")], format!("f({a})f({b})"), format!("f({a})^2")),
        4 => (vec!["f^2=g^2".to_owned(), format!("f({b})=g({b})")], format!("f({a})^2"), format!("g({a})^2")),
        5 => (vec!["f>0".to_owned()], format!("|f({a})|+f({b})"), format!("f({a})+|f({b})|")),
        _ => {
            let given = vec![format!("{}=g", derived(1)), format!(r"\frac{{dg}}{{dx}}={k}")];
            (given, format!("2f({b})-2f({a})-{}g({a})", 2 * (b - a)), format!("{}", k * (b - a) * (b - a)))
        }
    }
}

#[test]
fn what_follows_is_not_refuted_and_what_is_false_is_not_proved() {
    let mut seed = 7_u64;
    let mut rng = |n: i64| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 33) as i64 % n
    };
    let mut refuted = 0;
    for _ in 0..60 {
        let (given, left, right) = made(&mut rng);
        let given: Vec<&str> = given.iter().map(String::as_str).collect();
        let apart = format!("{right}+{}", rng(3) + 1);
        let ask = |right: &str| asked(&(format!("{left}={right}").as_str(), SYMBOLS, given.as_slice()));
        let (follows, fails) = (ask(&right), ask(&apart));
        assert_ne!(follows, "refuted", "{left}={right}, given {given:?}");
        assert!(!fails.starts_with("proved"), "{fails}: {left}={apart}, given {given:?}");
        refuted += usize::from(fails == "refuted");
    }
    assert!(refuted > 50, "{refuted} of what is false");
}

#[test]
fn a_field_refutes_what_is_claimed_of_several_places() {
    let of = "x: coordinate; f(x): field; g(x): field";
    all(&[
        ("refuted", "f(1)=f(0)", of, "f>0"),
        ("refuted", "f=f(0)", of, "f>0"),
        ("refuted", "f=1", of, "f(0)f=f; f(0)=1"),
        ("refuted", "f=g", of, "f^2=g^2; f(0)=g(0)"),
        ("refuted", "f(1)=g(1)", of, r"f\ge g; f(0)=g(0)"),
        ("refuted", "f(2)=2f(1)", of, r"\frac{d^2f}{dx^2}=0"),
        ("refuted", "f(2)=f(1)", of, "f(0)f=0"),
        ("unrefuted", "f(2)=2f(1)", of, r"\frac{d^2f}{dx^2}=0; f(0)=0"),
        ("unrefuted", r"f=g", of, "xf=xg"),
        ("unrefuted", r"f(1)=f(-1)", of, "f(x)=f(-x)"),
        // Fields of several coordinates, and beside motions, are none.
        ("unrefuted", "u=u(0,y)", "x,y: coordinate; u(x,y): field", r"\frac{\partial u}{\partial x}=0"),
        ("unrefuted", "f=f(0)", "x: coordinate; f(x): field; z: state", r"\frac{df}{dx}=z-z"),
    ]);
}

#[test]
fn places_at_which_premises_contradict_each_other() {
    let lines: &[Line] = &[
        ("f=0", SYMBOLS, &["f(0)f=0", "f(0)=1"]),
        ("f(1)=0", SYMBOLS, &["f(0)f=0", "f(0)=1"]),
        ("f(1)=1", SYMBOLS, &["f(0)f=f", "f(0)=2", "f(1)=1"]),
        ("g=g(0)", SYMBOLS, &["f(1)f=-1", "g=g(0)"]),
        ("x=0", &["x: state"], &[r"\dot x^2=-x^2", "x(0)=1"]),
        ("x=0", &["x: state"], &["tx=0", "x(0)=1"]),
        ("x(1)=0", &["x: state"], &[r"\dot x^2=-x^2", "x(0)=1"]),
    ];
    for line in lines {
        assert_eq!(asked(line), "undecided", "{line:?}");
    }
}
