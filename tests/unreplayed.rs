//! What the prover finds and the checker does not replay; points that nearly satisfy what is given.
//!
//! Beside each line that is false stands what shows it.

use crate::premises::of_file;
use rederive::check::{Proposition, prove};
use rederive::derivation::Derivation;

/// A claim, its symbols, what is given.
pub(crate) type Line<'a> = (&'a str, &'a [&'a str], &'a [&'a str]);

const MOTION: &[&str] = &["t: time", "x, y, z: state"];

pub(crate) fn word(&(formula, symbols, given): &Line) -> (&'static str, &'static str) {
    let mut derivation = Derivation::blank();
    let symbols: Vec<(String, String)> = symbols.iter().map(|s| ((*s).to_owned(), (*s).to_owned())).collect();
    derivation.declare_typed(&symbols).unwrap_or_else(|e| panic!("{formula}: {e:?}"));
    let given = given.iter().map(|g| (*g).to_owned()).collect();
    let proposition = Proposition { formula: formula.to_owned(), given, throughout: false };
    let account = prove(&mut derivation, &proposition).unwrap_or_else(|e| panic!("{formula}: {e:?}"));
    (account.standing(), account.verdict())
}

/// A fact that is known at some times, used at others.
#[test]
fn what_may_hold_at_some_times_alone_is_not_proved_by_the_prover_alone() {
    let lines: [Line; 8] = [
        // x leaves its value while y < 0.
        ("x=x(1)", MOTION, &[r"\dot x=\sqrt y-\sqrt y", r"y(\frac12)=-1", "y(0)=1", "y(1)=1"]),
        ("x=x(0)", MOTION, &[r"\frac{\dot x}{y}=0", r"y(\frac12)=0"]),
        // x = e^{−1/t²} before 0, and 0 behind it.
        ("x=x(-1)", MOTION, &[r"\frac{\dot x}{|t|+t}=0"]),
        // x = y = t.
        (r"\dot x=0", MOTION, &[r"x^2+\sqrt{-y^2}=0"]),
        (r"\dot x=0", MOTION, &[r"x+0\cdot\sqrt{-t^2}=0"]),
        // x = t, y = −t².
        (r"\dot x=0", MOTION, &[r"x=\sqrt y-\sqrt y"]),
        // x = t, y = −t.
        (r"\dot x=\dot y", MOTION, &[r"\sqrt[3]x=\sqrt[3]y"]),
        ("y=y(0)", MOTION, &[r"x^{-4}\dot y=0", "x(1)=0"]),
    ];
    for line in &lines {
        assert_eq!(word(line), ("undecided", "undecided"), "{line:?}");
    }
}

/// A formula with holes does not say what a field is at other places: f may be e^{1/x} for x < 0.
#[test]
fn a_field_is_not_known_at_other_places_by_the_prover_alone() {
    const F: &[&str] = &["x: coordinate", "f(x): field"];
    for claim in ["f(-x)=f(x)", "f(-x^2)=0"] {
        let found = word(&(claim, F, &[r"f=\sqrt x-\sqrt x"]));
        assert!(!found.0.starts_with("proved") || found.0 == "proved except", "{claim}: {found:?}");
    }
}

/// The same of assumptions, one of which has no value on a stretch.
#[test]
fn an_assumption_without_values_on_a_stretch_chooses_the_times() {
    // y = t² − 1, and x goes from one number to another within |t| < 1.
    for hole in [r"\sqrt y=\sqrt y", r"y^{3/2}-y^{3/2}=0", r"\ln(y^2)=2\ln y", r"z=\ln y"] {
        for says in ["first-integral = ['x']", "always = ['x=x(2)']"] {
            let states = ["x", "y", "z"].map(|s| format!("'{s}' = {{ role = 'state' }}\n")).concat();
            let claim = format!("[[claim]]\nid = 'c'\nsays = 'c'\nassuming = ['\\dot x=0', '{hole}']\n{says}\n");
            let account = of_file(&(states + &claim));
            let word = account.claims[0].identity.as_ref().map_or("none", |i| i.standing());
            assert!(!word.starts_with("proved"), "{hole}: {says}: {word}");
        }
    }
}

/// At a point at which premises touch, what rounding leaves is no motion.
#[test]
fn points_at_which_premises_touch_do_not_refute() {
    let lines: [Line; 14] = [
        (r"\dot x=0", MOTION, &[r"x^2-2\sqrt2x+2=0"]),
        (r"\dot x=0", MOTION, &["x^2+2x+1+e^z=e^z"]),
        (r"\dot x=\dot y", MOTION, &[r"\cos(x-y)=1"]),
        (r"\dot x=\dot y", MOTION, &[r"\sin x\sin y+\cos x\cos y=1"]),
        (r"\dot x=\dot y", MOTION, &["x^2+y^2+e^z=2xy+e^z"]),
        (r"\dot x=0", MOTION, &[r"\cosh x+e^z=1+e^z"]),
        (r"\ddot x=0", MOTION, &[r"\dot x^2+2\dot x+1+e^z=e^z"]),
        ("f'=1", &["x: coordinate", "f(x): field"], &[r"\cos(f-x)=1"]),
        ("|y|=y", &["x, y"], &[r"\cos x=1-10^{-15}y"]),
        ("|y|=y", &["x, y"], &[r"\cosh x=1+10^{-18}y"]),
        ("|y|=y", &["x, y"], &[r"e^x+e^{-x}=2+10^{-34}y"]),
        ("x=5", &["x, z"], &["x^2+2x+1+e^z+10^{-18}=e^z"]),
        ("y=1", &["x, y, z"], &["x^2+2x+1+e^z+10^{-18}=e^z", "y=1"]),
        (r"\dot y=2", MOTION, &["x^2+2x+1+e^z+10^{-18}=e^z"]),
    ];
    for line in &lines {
        assert_eq!(word(line).0, "undecided", "{line:?}");
    }
    // Where they cross they do, and where the point is exact.
    for line in [
        ("x=2", &["x"][..], &["x^2=4"][..]),
        (r"\dot x=0", MOTION, &[r"\cos(x-y)=\frac12"]),
        ("z=1", &["x, y, z"], &[r"\sin x+\sin y=2", r"z\cos x=\cos x"]),
    ] {
        assert_eq!(word(&line).0, "refuted", "{line:?}");
    }
}

/// What is wrong by less than binary64 shows is wrong: no point satisfies it.
#[test]
fn what_holds_within_rounding_alone_does_not_refute() {
    let (numbers, pair) = (&["x, y"][..], &["a"][..]);
    let lines: [Line; 12] = [
        ("a=1", pair, &[r"(a-1)(\pi-3.14159265358979323846)=0"]),
        ("a=1", pair, &[r"(a-1)(\ln2-0.69314718055994530942)=0"]),
        ("y=0", numbers, &[r"y\ln x=0", "x=1+10^{-30}"]),
        ("y=2", numbers, &[r"(y-2)(\sin^2x+\cos^2x)=(y-2)(1+10^{-20})"]),
        ("y=2", numbers, &[r"(y-2)\ln(e^x)=(y-2)(x+10^{-25})"]),
        ("y=2", numbers, &[r"(y-2)(\arcsin x+\arccos x)=(y-2)(\frac\pi2-10^{-18})"]),
        ("y=2", numbers, &[r"(y-2)\arctan1=(y-2)(\frac\pi4+10^{-17})"]),
        ("x=2", numbers, &[r"\arcsin x+10^{17}\pi=10^{17}\pi+5"]),
        ("y=0", numbers, &[r"y\sin x=0", "x=3.14159265358979323846"]),
        ("y=0", numbers, &[r"y(e^x-2)=0", "x=0.69314718055994530942"]),
        ("y=0", numbers, &[r"y\sqrt{x^2+10^{-40}}=yx", "x=1"]),
        (r"\dot y=0", MOTION, &[r"\dot y\cdot(\pi-3.14159265358979323846)=0"]),
    ];
    for line in &lines {
        assert!(["undecided", "proved", "proved except", "proved unreplayed"].contains(&word(line).0), "{line:?}");
    }
    // Points that satisfy what is given for certain, though no decimals show it.
    let lines: [Line; 12] = [
        ("y=0", numbers, &[r"y\ln x=0", "x=1"]),
        ("a=1", pair, &[r"(a-1)(\sin^2a+\cos^2a-1)=0"]),
        ("x=2", numbers, &["x^2=2"]),
        ("x=1", numbers, &["x^2+x=1"]),
        ("x=y", numbers, &[r"\cos x=\frac12", r"\cos y=\frac12"]),
        ("x=y", numbers, &[r"\sin x+\sin y=0"]),
        ("x=1", numbers, &["e^x=2", "y=x"]),
        ("y=1", numbers, &[r"\ln x=3", r"y=\ln(x^2)"]),
        ("x=y", numbers, &[r"\sqrt x+\sqrt y=2"]),
        ("y=0", numbers, &[r"y\sin x=0", r"x=\pi"]),
        (r"\ddot x=x", MOTION, &[r"\ddot x=-\sin x", r"\dot x=2\cos\frac x2"]),
        (r"\dot x=y", MOTION, &[r"x=\cos z", r"\dot z=1", r"y=\sin z"]),
    ];
    for line in &lines {
        assert_eq!(word(line).0, "refuted", "{line:?}");
    }
}

/// What is denied is refuted by a proof that counts, as what is claimed is proved.
#[test]
fn what_is_denied_is_refuted_by_what_is_replayed() {
    // x leaves its value while y < 0, so that it may be another one.
    let given: &[&str] = &[r"\dot x=\sqrt y-\sqrt y", r"y(\frac12)=-1", "y(0)=1", "y(1)=1", "x(0)=2"];
    assert_eq!(word(&(r"x(1)\ne2", MOTION, given)).0, "undecided");
    assert_eq!(word(&(r"x(1)\ne2", MOTION, &[r"\dot x=0", "x(0)=2"])).0, "refuted");
}

/// Where no motion satisfies what is given, nothing is refuted: neither what is denied, nor what is claimed.
#[test]
fn nothing_is_refuted_where_no_motion_is_known() {
    let symbols: &[&str] = &["t: time", "x, y, z: state", "a"];
    let lines: [Line; 11] = [
        (r"x\ne2", symbols, &["x=2", r"\dot y=1", "y(0)=0", "y(1)=2"]),
        (r"a\ne3", symbols, &["a=3", r"\dot y=\ddot y", r"\dot y=t"]),
        (r"a\ne3", symbols, &["a=3", "y=|z|", r"\dot y=1", "z(0)=0"]),
        (r"x(2)\ne2", symbols, &["x=2", r"\dot y=y^2", "y(0)=1"]),
        (r"a\ne3", symbols, &["a=3", r"z\ne0", "z(0)+z(1)=0"]),
        (r"y\ne y", symbols, &[r"\dot y=y", "y(0)=1", "y(1)=-1"]),
        // Between two times lies one that is excluded.
        ("a=3", symbols, &[r"t\ne0", "x(-1)=1", "x(1)=1"]),
        ("a=3", symbols, &["|t|>1", "x(-2)=1", "x(2)=1"]),
        ("x(2)=x(-2)", symbols, &[r"t\ne0"]),
        ("a=3", symbols, &[r"\sin t>0", "x(1)=1", "x(7)=1"]),
        ("a=3", symbols, &[r"\ln t\ne0", r"x(\frac12)=1", "x(2)=1"]),
    ];
    for line in &lines {
        assert_eq!(word(line).0, "undecided", "{line:?}");
    }
    for line in [
        (r"x\ne2", symbols, &["x=2", r"\dot y=1"][..]),
        (r"\ddot x\ne-x", symbols, &[r"\ddot x=-x"]),
        ("a=3", symbols, &["t>0", "x(1)=1"]),
    ] {
        assert_eq!(word(&line).0, "refuted", "{line:?}");
    }
    // An exponent that is 0 at a fixed time.
    assert_eq!(word(&("x=x(0)", symbols, &[r"t^t\dot x=0"])).0, "undecided");
}

/// What is conserved has at one time the value that it has at another, where it has a rate on all times between them.
#[test]
fn what_is_conserved_is_known_at_other_times() {
    let circle: &[&str] = &[r"\dot x=y", r"\dot y=-x", "x(0)=1", "y(0)=0"];
    let lines: [Line; 5] = [
        ("x(1)=2", MOTION, &[r"\dot x=0", "x(0)=2"]),
        ("x(1)=x(0)", MOTION, &[r"\dot x=0"]),
        ("x(1)^2=x(0)^2", MOTION, &[r"x\dot x=0"]),
        ("x(1)=y(1)", MOTION, &[r"\dot x=\dot y", "x(0)=y(0)"]),
        ("x(1)^2+y(1)^2=1", MOTION, circle),
    ];
    for line in &lines {
        assert_eq!(word(line).0, "proved", "{line:?}");
    }
    assert_eq!(word(&("x(2)=3", MOTION, &[r"\dot x=0", "x(0)=2"])).0, "refuted");
    // x leaves its value where y < 0.
    for between in [r"\dot x=\sqrt y-\sqrt y", r"\dot x\ln y=0", r"\frac{\dot x}{\sqrt y}=0"] {
        let line: Line = ("x(1)=2", MOTION, &[between, r"y(\frac12)=-1", "y(0)=1", "y(1)=1", "x(0)=2"]);
        assert_eq!(word(&line).0, "undecided", "{line:?}");
    }
}

/// Where values at several fixed times are named, what is given must be so on a motion that is known: else it may be that nothing is claimed.
#[test]
fn between_fixed_times_a_motion_must_be_known() {
    let lines: [Line; 9] = [
        // y goes from 0 to 1 in the time 1, not to 2.
        ("a=3", &["a", "y: state"], &["a=3", r"\dot y=1", "y(0)=0", "y(1)=2"]),
        ("a=3", &["a", "y: state"], &["a=3", r"\dot y=t", "y(0)=0", "y(2)=1"]),
        ("a=3", &["a", "x, y: state"], &["a=3", r"\dot y=x", r"\dot x=0", "y(0)=0", "y(1)=1", "y(2)=3"]),
        // The exceptions are all times between those that are named.
        ("x(-1)=x(2)", MOTION, &["y(0)=0", r"\ln(\ln(y-2))\cdot2x\dot x=0", "x(-2)=3", r"\dot y=1"]),
        ("x(1)=x(2)", MOTION, &["y(0)=0", r"\ln(y-5)x\dot x=0", r"\dot y=1"]),
        ("x(1)=x(0)", MOTION, &[r"\frac{\dot x}{\sqrt{y-5}}=0", r"\dot y=1", "y(0)=0"]),
        // Time passes from −2 to 2 through 0.
        ("x(2)=x(-2)", MOTION, &["t^2>1", r"\dot x=0"]),
        ("x(2)=x(-2)", MOTION, &[r"t\ne0", r"\dot x=0"]),
        ("x(2)=x(-2)", MOTION, &[r"y\ne0", "y(-2)=-1", "y(2)=1", r"\dot x=0"]),
    ];
    for line in &lines {
        assert_eq!(word(line).0, "undecided", "{line:?}");
    }
    let known: [Line; 4] = [
        ("a=3", &["a", "y: state"], &["a=3", r"\dot y=1", "y(0)=0", "y(1)=1"]),
        ("x(2)=x(-2)", MOTION, &["t^2<9", r"\dot x=0"]),
        ("x(2)=x(-2)", MOTION, &[r"y\ne0", "y(-2)=1", "y(2)=1", r"\dot x=0"]),
        ("x(1)=3", MOTION, &[r"\dot x=0", "x(0)=3", "x(2)=3"]),
    ];
    for line in &known {
        assert_eq!(word(line).0, "proved", "{line:?}");
    }
}

/// Fixed times that are parameters may be one: what has two values then is no motion.
#[test]
fn a_point_has_one_value_at_one_time() {
    let symbols: &[&str] = &["x, y: state", "t_0, t_1, a"];
    let lines: [Line; 7] = [
        ("ax(t_0)=ax(t_1)", symbols, &["at_0=at_1"]),
        ("x(t_0)=x(0)", symbols, &[r"t_0\cdot(x(t_0)-x(0))=0"]),
        ("x(t_0)=x(t_1)", symbols, &["(t_0-t_1)(x(t_0)-x(t_1))=0"]),
        ("x(t_0)=1", symbols, &["t_0^2=1", "x(1)=1", "x(-1)=1"]),
        ("x(t_0)=1", symbols, &["|t_0|=1", "x(1)=1", "x(-1)=1"]),
        ("x(1)=2", symbols, &["t_0=y(0)", "y(0)=1", "x(t_0)=2"]),
        ("x(t_0)=x(t_1)", symbols, &["(t_0-t_1)^2+y(0)^2=0"]),
    ];
    for line in &lines {
        assert_ne!(word(line).0, "refuted", "{line:?}");
    }
    assert_eq!(word(&("x(t_0)=x(t_1)", symbols, &["t_0=2t_1", "t_1=1"])).0, "refuted");
}

/// Where a premise about what moves has no value at some times, nothing is given at these, and the prover does not speak alone.
#[test]
fn what_moves_and_has_no_value_at_some_times_is_not_given_there() {
    let lines: [Line; 5] = [
        ("|y|-y=0", &["y: state"], &[r"\sqrt y\ge0", "y=t"]),
        ("|t|-t=0", &["y: state"], &[r"\sqrt t\ge0"]),
        ("|y|-y=0", &["y: state"], &[r"\sqrt y=\sqrt y"]),
        (r"\sin z=\sin x", &["x, y, z: state"], &[r"\frac{z-x}{y}=0"]),
        (r"z=\sin y", &["y, z: state"], &[r"\arcsin z=y"]),
    ];
    for line in &lines {
        assert!(!["proved", "proved unreplayed"].contains(&word(line).0), "{line:?}: {:?}", word(line));
    }
    // A case that was divided by is another one.
    assert_ne!(word(&("|y|+y=0", &["y: state", "b"], &["b(|y|+y)=0", "b(t-1)=0"])).0, "proved");
}

/// Of a fact that is a product, a factor of a known sign is divided by.
#[test]
fn a_factor_of_a_known_sign_is_divided_by() {
    let lines: [Line; 4] = [
        ("x=2", &["x"], &["x^2=4", "x>0"]),
        ("x=a", &["x, a"], &["x^2=a^2", "x>0", "a>0"]),
        ("x=1", &["x"], &["x^2+x=2", "x>0"]),
        (r"v=\sqrt{2gh}", &["v, g, h"], &["v^2=2gh", "v>0"]),
    ];
    for line in &lines {
        assert_eq!(word(line), ("proved", "proved"), "{line:?}");
    }
    for premises in [&["x^2=4"][..], &["x^2=4", "x<3"], &["x^2=4", r"x\ne2"], &["x^2+x=2", "x>-3"]] {
        assert_eq!(word(&("x=2", &["x"], premises)).0, "refuted", "{premises:?}");
    }
}

/// At one fixed place all moves with time alone; what crosses it, and other places, do not follow.
#[test]
fn at_one_place_a_field_moves_with_time_alone() {
    let symbols: &[&str] = &["u(x,t): field"];
    assert_eq!(word(&("u_t(0,t)=0", symbols, &["u(0,t)=0"])).0, "proved unreplayed");
    for claim in ["u_x(0,t)=0", "u(1,t)=0", "u_t(1,t)=0", "u=0", "u_t=0", "u_{xt}(0,t)=0"] {
        assert_eq!(word(&(claim, symbols, &["u(0,t)=0"])).0, "undecided", "{claim}");
    }
    assert_eq!(word(&("u_t(0,t)=0", symbols, &["u(0,t)=0", "u(1,t)=t"])).0, "undecided");
}

/// What is about one time, and what nothing is given to, the prover may say alone; it is told apart.
#[test]
fn of_one_time_the_prover_may_speak_alone() {
    let lines: [Line; 3] = [
        (r"\sqrt{x^3}=|x|^{3/2}", &["x"], &[]),
        (r"\arcsin x=\frac13", &["x"], &[r"x=\sin\frac13"]),
        (r"\left|\ln(|x|^2)+1\right|=\left|2\ln|x|+1\right|", &["x"], &[]),
    ];
    for line in &lines {
        assert_eq!(word(line), ("proved unreplayed", "proved"), "{line:?}");
    }
    assert_eq!(word(&(r"\sqrt{x^2}=|x|", &["x"], &[])), ("proved", "proved"));
    // A case that the steps leave out is an exception, and is named.
    let (standing, _) = word(&(r"\frac{d}{dx}|x|^3=3x|x|", &["x"], &[]));
    assert_eq!(standing, "proved except");
}

/// A time has one name, whatever defined names it is written with.
#[test]
fn a_fixed_time_may_be_a_constant() {
    const B: &[&str] = &["x: state", r"A: constant=\pi", r"C: constant=\pi", "B: constant=2"];
    for claim in ["x(B)=x(2)", r"x(C)=x(\pi)", r"x(2A)=x(2\pi)", "x(C)=x(A)"] {
        assert_eq!(word(&(claim, B, &[])).0, "proved", "{claim}");
    }
    assert_eq!(word(&("x(B)=4", B, &["x(2)=4"])).0, "proved");
    assert_eq!(word(&("x(B)=x(3)", B, &[])).0, "refuted");
}

/// In a file, too: what a claim assumes is to be so on an interval of a motion.
#[test]
fn what_a_claim_assumes_is_so_on_a_motion() {
    let file = |rate: &str, assumed: &str, says: &str| {
        let states = ["x", "y", "z"].map(|s| format!("'{s}' = {{ role = 'state' }}\n")).concat();
        let system = format!("[system.s]\nstates = ['x']\nequations = ['\\dot x={rate}']\n");
        let claim = format!(
            "[[claim]]\nid = 'c'\nsays = 'c'\nfollows-from = ['s']\nassuming = [{assumed}]\nalways = ['{says}']\n"
        );
        of_file(&(states + &system + &claim))
    };
    let lines = [
        ("3x", "'x=-t-1'", "x^2=(t+1)^2"),
        ("x", "'x=t'", "x=t"),
        ("1", r"'t\ge0', 'x=0'", r"\dot x=1"),
        ("1", r"'x\ge1', 'x=1'", r"\dot x=1"),
        ("x", "'x^2=t+2'", r"\dot x=x"),
        ("1+x^2", r"'\dot z=0'", "z(10)=z(0)"),
    ];
    for (rate, assumed, says) in lines {
        let account = file(rate, assumed, says);
        let word = account.claims[0].identity.as_ref().map_or("none", |i| i.standing());
        assert!(!word.starts_with("proved"), "{rate}: {assumed}: {word}");
    }
    for (rate, assumed, says) in
        [("1", "'x>1'", r"\dot x=1"), ("3x", r"'\dot z=0'", "z(1)=z(0)"), ("1", "'x=t'", "x=t")]
    {
        let account = file(rate, assumed, says);
        let word = account.claims[0].identity.as_ref().map_or("none", |i| i.standing());
        assert_eq!(word, "proved", "{rate}: {assumed}");
    }
}

/// A factor that is 0 is another case: a point of it does not contradict what is proved of the others.
#[test]
fn a_point_of_another_factor_refutes() {
    let vanishing = [r"(|z|+z)(\ln x-\sqrt x)t=0", r"\lfloor z\rfloor(\ln x-\sqrt x)t=0", r"(|z|-z)(\ln x-\sqrt x)t=0"];
    for given in vanishing {
        assert_eq!(word(&(r"\ln x=\sqrt x", MOTION, &[given])).0, "refuted", "{given}");
    }
}

/// From what is so on no motion, anything would follow: nothing is proved from it.
#[test]
fn what_no_motion_satisfies_proves_nothing() {
    const E: &[&str] = &["t: time", "x: state", r"E: observable=\frac12\dot x^2+\frac12x^2"];
    const PI: &[&str] = &["a", r"C: constant=\pi"];
    let lines: [Line; 56] = [
        // Rates of what is defined are no numbers of their own, and constants have values.
        ("x=x", E, &[r"\dot E(0)=1", r"\ddot x=-x"]),
        ("x=x", E, &[r"\dot E(0)=1", "x=1"]),
        ("x=x", E, &[r"\ddot E(0)=1", r"\dot x=x", "x(0)=1"]),
        ("a=a", PI, &["C=3"]),
        ("a=a", PI, &["C<3"]),
        ("a=a", PI, &[r"\sqrt{3-C}=a"]),
        // The claim has no value: x is 0.
        (r"\frac xx=1", MOTION, &[r"y=-2\dot x", r"\ddot x=-y", r"\ddot x=x"]),
        (r"\frac xx=1", MOTION, &["tx=0"]),
        (r"\frac xx=1", MOTION, &[r"(e^t-1)x=0"]),
        (r"\frac xx=1", MOTION, &[r"x=\dot y", "y^2=4"]),
        (r"\frac uu=1", &["x: coordinate", "u(x): field"], &["xu=0"]),
        (r"\ell-\ell=0", &["x: state", r"\ell: observable=\ln(-x^2)"], &[]),
        (r"\frac\ell\ell=1", &["x: state", r"\ell: observable=\sqrt{-1-x^2}"], &[]),
        // What cancels has values where it is written.
        ("y=y", MOTION, &[r"\dot x=1", r"\frac{\dot x}x=\frac{\dot x}x", "x(0)=0"]),
        ("y=y", MOTION, &[r"\dot x=1", r"\dot x\ln x=\dot x\ln x", "x(0)=-1"]),
        ("y=y", MOTION, &[r"\dot x=1", r"\dot x\ln(-1-x^2)=\dot x\ln(-1-x^2)"]),
        // What moves is the same at all places.
        ("q=q", &["x: coordinate", "q: state"], &["q=x"]),
        ("q=q", &["x: coordinate", "q: state"], &[r"\dot q=x"]),
        ("x=x", MOTION, &[r"\dot x\ln x=0", "x=-1"]),
        ("x=x", E, &[r"\dot E(0)=1", "x(0)=0", r"\dot x(0)=0"]),
        // Motions of 1 + x² are shorter than π.
        ("y(10)=y(0)", MOTION, &[r"\dot x=1+x^2", r"\dot y=0"]),
        ("y(10)=y(-10)", MOTION, &[r"\ddot x=6x^2+1", r"\dot y=0"]),
        // There is one time at which it has a value.
        (r"y+\sqrt{-t^2}=2y", MOTION, &[r"y=\sqrt{-t^2}"]),
        ("x=5", MOTION, &[r"y=\sqrt{-t^2}"]),
        ("x=5", MOTION, &[r"y=\arcsin(1+t^2)"]),
        ("x=x", MOTION, &[r"\dot y=\sqrt t+\sqrt{-t}"]),
        ("x=5", MOTION, &[r"t\le0", r"t\ge0"]),
        ("x=x", MOTION, &[r"t^2\le0"]),
        // The claim has a value on no such motion.
        (r"\frac xx=1", MOTION, &[r"\dot x=0", "x(0)=0"]),
        (r"\ln x=\ln y", MOTION, &["x=y", r"\dot x=-x", "x(0)=-1"]),
        (r"\frac1x=\frac1y", MOTION, &["x=y", r"\dot x=x", "x(0)=0"]),
        (r"\sqrt x-\sqrt x=0", MOTION, &[r"\dot x=0", "x(0)=-1"]),
        (r"\ln(x(3))=\ln(y(3))", MOTION, &["x=y", r"\dot x=-x^3", "x(0)=-2"]),
        (r"\frac1{x^2+y^2-1}=\frac1{y^2+x^2-1}", MOTION, &[r"\dot x=y", r"\dot y=-x", "x(0)=1", "y(0)=0"]),
        (r"\dot x=3x^2", MOTION, &[r"\dot x=3x^2", r"x(0)=-\frac12", r"\ddot x(0)=\frac94"]),
        ("x=7", MOTION, &["x(0)=7", r"\dot x=0", "y>0", "y(0)=-1", r"\dot y=1"]),
        ("y=2t", MOTION, &[r"\dot x=y", r"\dot y=-x", "x=t^2"]),
        (r"\dot x=x", MOTION, &[r"\dot x=x", "x^2=t+2"]),
        (r"\dot x=x", MOTION, &[r"\dot x=x", "x^2=t^2+1"]),
        ("x(0)=0", MOTION, &["t(x-1)=0", "x(0)=0"]),
        ("z=z(0)", MOTION, &[r"x\le x(0)", r"\dot x=1", r"\dot z=0"]),
        ("x(0)=1", MOTION, &[r"x\ge1", "x(0)=1", r"\dot x=y", "y>0"]),
        (r"\cos t=t", MOTION, &[r"\cos t=t"]),
        (r"\dot x(0)^2=4", MOTION, &[r"x\dot x=t", "x(0)=0", r"\dot x(0)=2"]),
        ("x=5", MOTION, &["x=t^2", r"\dot x=1"]),
        ("z=1", MOTION, &[r"z\ge1+t^2", r"z\le1"]),
        ("x=7", MOTION, &["x(0)=7", r"\dot x=0", "y^2=-1-t^2"]),
        ("x=7", MOTION, &["x(0)=7", r"\dot x=0", r"y=\sqrt{-1-t^2}"]),
        // It has no value at the time that is named.
        ("x=7", MOTION, &["x(0)=7", r"\dot x=0", r"y=\sqrt{t-1}"]),
        ("x=7", MOTION, &["x(0)=7", r"\dot x=0", r"y\dot y=1", "y(0)=0"]),
        ("x=7", MOTION, &["x(0)=7", r"\dot x=0", r"\dot y=\sqrt y", "y(0)=-1"]),
        // The third rate follows from the system: it is 0.
        ("x=7", MOTION, &["x(0)=7", r"\dot x=0", r"\ddot y=-\sin y", "y(0)=1", r"\dot y(0)=0", r"\dddot y(0)=1"]),
        ("x=7", MOTION, &["x(0)=7", r"\dot x=0", "y=z+1", "z=y-1", "y(0)=0", "z(0)=0"]),
        ("x=7", MOTION, &["x(0)=7", r"\dot x=0", "y=|t|", r"\dot y(0)=1"]),
        ("u=3", &["x: coordinate", "u(x): field"], &[r"u^2\le0", r"\partial_xu=1"]),
        ("f(0)=1", &["s: coordinate", "f(s): field"], &["f=1", "f^2=s+1"]),
    ];
    for line in &lines {
        assert_eq!(word(line).0, "undecided", "{line:?}");
    }
    // One motion is enough, of each reason that there is.
    let lines: [Line; 15] = [
        (r"\dot x(5)^2+x(5)^2=1", MOTION, &[r"\ddot x=-x", "x(0)=1", r"\dot x(0)=0"]),
        (r"\frac{\dot x}x=-2", MOTION, &[r"\dot x=-2x", "x>0", "x(0)=1"]),
        (r"\dot x=3x^2", MOTION, &[r"\dot x=3x^2", r"x(0)=-\frac12", r"\ddot x(0)=-\frac94"]),
        ("x=7", MOTION, &["x(0)=7", r"\dot x=0", "y>0", "y(0)=1", r"\dot y=1"]),
        ("x=x(0)", MOTION, &[r"\dot x=0"]),
        ("x^2+y^2=1", MOTION, &[r"\dot x=y", r"\dot y=-x", "x(0)=1", "y(0)=0"]),
        ("x=7", MOTION, &["x(0)=7", r"\dot x=0", r"\dot y=\sqrt y", "y(0)=1"]),
        ("x=7", MOTION, &["x(0)=7", r"\dot x=0", r"\ddot y=-\sin y", "y(0)=1", r"\dot y(0)=0"]),
        ("x=7", MOTION, &["x(0)=7", r"\dot x=0", "y=z+1", "z=y-1"]),
        (r"\dot x=1", MOTION, &["x=t+2"]),
        (r"x\dot x=-y\dot y", MOTION, &["x^2+y^2=1"]),
        (r"\dot x=\dot y", MOTION, &["x=y"]),
        ("x=2", MOTION, &["x^2=4", "x>0"]),
        (r"\partial_xu=2x", &["x, y: coordinate", "s: coordinate", "f(s): field", "u(x,y): field"], &["u=x^2+f(y)"]),
        ("u_x=0", &["x, y: coordinate", "u(x,y): field"], &["u_x=u_y", "u_y=0"]),
    ];
    for line in &lines {
        assert!(["proved", "proved unreplayed"].contains(&word(line).0), "{line:?}");
    }
}
