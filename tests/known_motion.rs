//! Nothing is proved of what may never be so; and a value at one time says nothing of another one.
//!
//! Beside each line stands why no motion, or no field, is as it says.

use crate::premises::of_file;
use crate::unreplayed::{Line, word};

const FIELDS: &[&str] = &[
    "t: time",
    "q, r: state",
    "x, y: coordinate",
    "f(x), g(x): field",
    "u(x,t): field",
    "w(x,y): field",
    "h(t): field",
];
const PLANE: &[&str] = &["t: time", "x, y, z: state", r"\theta: observable, angle = \operatorname{atan2}(y,x)"];
const ARC: &[&str] = &["t: time", "x, y: state", r"\chi: observable, angle = \arccos x"];

/// A continued angle is the angle of its formula, but for whole turns.
#[test]
fn an_angle_has_no_other_value_than_its_formula() {
    let lines: [Line; 6] = [
        (r"\sin\theta=\sin1", PLANE, &[r"\theta=1", "y=0"]),
        ("z=z", PLANE, &[r"\theta=1", "x=0", "y=1"]),
        ("z=z", PLANE, &[r"\theta=x", "y=0", "x=1"]),
        ("z=z", PLANE, &[r"\theta=1", "y=x"]),
        ("y=y", ARC, &[r"\chi=4"]),
        ("y=y", ARC, &[r"\chi=-1"]),
    ];
    for line in &lines {
        assert_eq!(word(line).0, "undecided", "{line:?}");
    }
    let lines: [Line; 2] = [(r"\sin\theta=0", PLANE, &["y=0"]), (r"\sin\theta=\sin1", PLANE, &[r"\theta=1"])];
    for line in &lines {
        assert_eq!(word(line).0, "proved", "{line:?}");
    }
}

/// A law is so at all places: also a component of it in which nothing but coordinates is left. And fields have one value at one place, in
/// the places of others, too.
#[test]
fn a_law_is_so_at_all_places() {
    const S: &[&str] = &[
        "t: time",
        "x, z: state",
        "a, b: parameter",
        "s, c: coordinate",
        "f(s), g(s): field",
        "k(s,c): field",
        "u(s,t): field",
        "v: 2, state",
        "m: complex, parameter",
        "H: observable = s",
    ];
    let lines: [Line; 21] = [
        ("z=z", S, &["f=is"]),
        ("f'=0", S, &["f=e^{is}"]),
        ("f'=0", S, &["f=1+i(s-2)"]),
        ("f'=0", S, &["(f,s)=(1,2)"]),
        ("f(1)=0", S, &["(f,s)=(0,1)"]),
        ("z=z", S, &["u_t=is"]),
        ("z=z", S, &["k=s+ic"]),
        ("z=z", S, &["k=f+ic", "f=s"]),
        ("x=1", S, &["x=1+is"]),
        ("x=1", S, &["(x,s)=(1,2)"]),
        ("z=z", S, &[r"\dot x=1+is"]),
        ("z=z", S, &["v=(1,is)"]),
        ("f'=0", S, &["(f,H)=(1,2)"]),
        // a = b.
        ("f(g(a))=f(g(b))", S, &["a^3=b^3"]),
        ("f(f(a))=f(f(2))", S, &["a^3=8"]),
        ("f(g(a))=f(2)", S, &["g=s", "a^3=8"]),
        ("f(g(x))=f(g(1))", S, &["e^x=e"]),
        (r"f(\sin(g(x)))=f(\sin(g(z)))", S, &["x^3=z^3"]),
        ("f(u(a,0))=f(u(b,0))", S, &["a^3=b^3"]),
        (r"f(g(\lfloor a\rfloor))=f(g(a))", S, &["a=3"]),
        ("f(g(f(a)))=f(g(f(b)))", S, &["a^3=b^3"]),
    ];
    for line in &lines {
        assert_eq!(word(line).0, "undecided", "{line:?}");
    }
    let lines: [(&str, Line); 5] = [
        ("proved", ("f'=1", S, &["f=s"])),
        ("proved unreplayed", ("f(g(a))=a", S, &["g=s", "f=s"])),
        ("refuted", ("f(g(a))=f(g(b))", S, &[])),
        ("refuted", ("f(g(a))=f(g(b))", S, &["a^2=b^2"])),
        ("refuted", ("f(g(x))=f(1)", S, &[])),
    ];
    for (wanted, line) in &lines {
        assert_eq!(word(line).0, *wanted, "{line:?}");
    }
}

/// What a field is said to be depends on nothing on which the field does not depend; and where it is put in, all that moves does.
#[test]
fn a_field_depends_on_its_coordinates_alone() {
    let lines: [Line; 22] = [
        ("f'=0", FIELDS, &["f=t"]),
        ("xf'=f", FIELDS, &["f=xt"]),
        ("f=f", FIELDS, &["f=g+t"]),
        ("f=f", FIELDS, &["f=y"]),
        ("q(0)=q(1)", FIELDS, &["f=q", r"\dot q=1"]),
        (r"\dot q=1", FIELDS, &["f=x+q", r"\dot q=1"]),
        ("u=u", FIELDS, &["u=y"]),
        ("w=w", FIELDS, &["w=t"]),
        ("h=h", FIELDS, &["h=x"]),
        ("u=u", FIELDS, &["u=f", "u=t"]),
        // u depends on the time by q.
        ("u_t=0", FIELDS, &["u=q", r"\dot q=1", "u_t=0"]),
        (r"\dot q=1", FIELDS, &["h=q", r"\dot q=1", r"\dot h=0"]),
        ("q=q", FIELDS, &["u=q+t", r"\dot q=1", "u_t=1"]),
        ("q=q", FIELDS, &["h=q", r"\dot q=1", "h(2t)=h(t)"]),
        // What becomes an equation of coordinates alone is to be so at all places.
        ("x=2", FIELDS, &["q=1", "xq=2"]),
        ("x=0", FIELDS, &["f=0", "f(q)=x"]),
        ("q=q", FIELDS, &["f=x", "f(-x)=x"]),
        ("q=q", FIELDS, &["f=x", "f(2x)=x^2"]),
        ("q=q", FIELDS, &["u=0", "u=xt"]),
        ("u_{xt}=1", FIELDS, &["u=q", "u_t=x"]),
        ("q=q", FIELDS, &["q=1", r"\sin x=q"]),
        ("q=q", FIELDS, &[r"\dot q=0", "q=3", "x=q"]),
    ];
    for line in &lines {
        assert_eq!(word(line).0, "undecided", "{line:?}");
    }
    let lines: [Line; 4] = [
        ("f''=2", FIELDS, &["f=x^2"]),
        ("u_{tt}=u_{xx}", FIELDS, &[r"u=\sin(x-t)"]),
        ("w_x=y", FIELDS, &["w=xy"]),
        ("u_t=2t", FIELDS, &["u=x+t^2"]),
    ];
    for line in &lines {
        assert_eq!(word(line).0, "proved", "{line:?}");
    }
}

/// A point counts against a proof only where it belongs to its case for certain: these ended as defects.
#[test]
fn a_point_beside_its_case_is_no_defect() {
    let f = r"\left|y\right|=\sin(\left|x+y(1)\right|)";
    let lines: [Line; 6] = [
        (
            r"x=\lfloor|x|\rfloor",
            &["t: time", "x: state", "a: parameter"],
            &[r"(\dot x-2)(x-\lfloor|x|\rfloor)=0", r"\dot x=a"],
        ),
        (r"x=\left|\arctan(y)\right|", MOTION, &[r"(x(0)-2)\cdot(x-\left|\arctan(y)\right|)=0", r"\dot x\ne0"]),
        (f, MOTION, &[r"(\dot x-2)(\left|y\right|-\sin(\left|x+y(1)\right|))=0", r"y\ne1", r"\dot y^2=\dot y"]),
        (
            r"x=\cos(x)",
            MOTION,
            &[r"(\dot x(0)-\left|x\right|)\cdot x=(\dot x(0)-\left|x\right|)\cdot\cos(x)", r"\left|x\right|\ne2"],
        ),
        (
            r"\left|x\right|=e^{\left|x+\left|x\right|\right|}",
            MOTION,
            &[r"(\left|x\right|-2)\left|x\right|=(\left|x\right|-2)e^{\left|x+\left|x\right|\right|}"],
        ),
        (r"x=\sin(\left|x\right|)+2", MOTION, &[r"(\left|x\right|-2)x=(\left|x\right|-2)(\sin(\left|x\right|)+2)"]),
    ];
    for line in &lines {
        assert_ne!(word(line).0, "proved", "{line:?}");
    }
}

const MOTION: &[&str] = &["t: time", "x, y: state"];

fn system(states: &str, equations: &str, motion: &str, assumed: &str, says: &str) -> &'static str {
    let states_said = ["x", "y", "z"].map(|s| format!("'{s}' = {{ role = 'state' }}\n")).concat();
    let system = format!("[system.s]\nstates = [{states}]\nequations = [{equations}]\n");
    let claim =
        format!("[[claim]]\nid = 'c'\nsays = 'c'\nfollows-from = ['s']\nassuming = [{assumed}]\nalways = ['{says}']\n");
    let account = of_file(&(states_said + &system + &claim + motion));
    account.claims[0].identity.as_ref().map_or("none", |i| i.standing())
}

/// What is given of one fixed time is connected with another one by rates: a point with both refutes nothing.
#[test]
fn a_start_at_one_time_is_no_value_at_another() {
    for (equation, assumed, says) in [
        (r"'\dot x=1'", "'x(0)=1'", "x(1)=2"),
        (r"'\dot x=t'", "'x(0)=0'", r"x(1)=\frac12"),
        (r"'\dot x=x'", "'x(0)=1'", "x(1)=e"),
        (r"'\dot x=-x^2'", r"'x(1)=\frac12'", "x(0)=1"),
        (r"'\dot x=1'", "'x(0)=1', 'x(2)=3'", "x(1)=2"),
        (r"'\dot x=x^2'", "'x(0)=1'", "x(2)=-1"),
    ] {
        assert_eq!(system("'x'", equation, "", assumed, says), "undecided", "{equation}: {says}");
    }
    // At the same time, or of all times, it is one.
    for (assumed, says) in [("", "x(1)=2"), ("'x(1)=1'", "x(1)=2"), ("'x(0)=1'", "x=2")] {
        assert_eq!(system("'x'", r"'\dot x=1'", "", assumed, says), "refuted", "{assumed}: {says}");
    }
}

/// A motion of the file shows that there is one only if it moves by the system, and goes through all times that are named.
#[test]
fn a_motion_of_a_file_goes_through_the_times_that_are_named() {
    let motion = |of: &str| format!("[[trajectory]]\nid = 'm'\n{of}\nspan = [0, 1]\n");
    let integrated = motion("system = 's'\ninitial = { 'x' = '0', 'z' = '1' }");
    let by_formula = motion(r"formula = { 'x' = '\tan t', 'z' = '1' }");
    let none = motion("formula = { 'x' = 't', 'z' = '1' }");
    let equations = r"'\dot x=1+x^2', '\dot z=0'";
    let of = |motion: &str, says: &str| system("'x', 'z'", equations, motion, "", says);
    for motion in [&integrated, &by_formula, &none] {
        assert_eq!(of(motion, "z(0)=z(4)"), "undecided", "{motion}");
    }
    assert_eq!(of(&integrated, "z(0)=z(1)"), "proved");
    assert_eq!(of(&by_formula, "z(0)=z(1)"), "undecided");
}

/// A time or a place without a value says nothing: what names it has none.
#[test]
fn a_time_or_a_place_has_a_value() {
    const T: &[&str] = &[
        "t: time",
        "q, r: state",
        "t_0, t_1, a: parameter",
        "k: positive, parameter",
        "x: coordinate",
        "f(x): field",
        "u(x,t): field",
        "J(x): field = 1",
    ];
    // Each is so wherever what is given has a value, or has no value at all.
    let lines: [Line; 12] = [
        (r"|t_0|=t_0", T, &[r"q(\sqrt{t_0})=1"]),
        (r"|t_0|=t_0", T, &[r"\dot q(\ln t_0)=1"]),
        (r"|t_0|=t_0", T, &["u=x", r"u(x,\sqrt{t_0})=x"]),
        (r"q(\sqrt{t_0})=|t_0|", T, &[r"q(\sqrt{t_0})=t_0"]),
        (r"t_0=0", T, &[r"q(\sqrt{-t_0^2})=1"]),
        (r"|r|=r", T, &["f=1", r"f(\ln r)=1"]),
        (r"|r|=r", T, &["f=x", r"f'(\ln r)=1"]),
        (r"|r|=r", T, &[r"J(\ln r)=1"]),
        (r"q(\sqrt{-1})=2", T, &[]),
        (r"q(\ln(-k))=1", T, &[]),
        (r"f(\sqrt{-1-q^2})=2", T, &[]),
        (r"f(\ln q)=2", T, &["q=-1"]),
    ];
    for line in &lines {
        assert_ne!(word(line).0, "refuted", "{line:?}");
    }
    // Nothing is as it says.
    let lines: [Line; 10] = [
        ("r=r", T, &[r"q(\sqrt{-1})=1"]),
        ("r=r", T, &["t_0=-1", r"q(\ln t_0)=1"]),
        (r"q=q(\arcsin2)", T, &[r"\dot q=0"]),
        ("q=q", T, &[r"f(\sqrt{-1-q^2})=0"]),
        ("q=q", T, &[r"f(\frac1{\dot q})=0", r"\dot q=0"]),
        ("q=q", T, &["f=1", r"f(\sqrt{-1-x^2})=1"]),
        (r"J(\ln(-k))=1", T, &[]),
        // Two names of one time.
        (r"\ln(q(t_0)-q(t_1))=\ln(q(t_0)-q(t_1))", T, &["t_0=t_1"]),
        (r"\frac{q(t_0)-q(t_1)}{q(t_0)-q(t_1)}=1", T, &["e^{t_0}=e^{t_1}"]),
        (r"\ln(f(|k|)-f(k))=\ln(f(|k|)-f(k))", T, &[]),
    ];
    for line in &lines {
        assert!(!word(line).0.starts_with("proved"), "{line:?}: {}", word(line).0);
    }
    let lines: [Line; 5] = [
        (r"q(\sqrt2)=q(1)", T, &[r"\dot q=0"]),
        ("q(t_0)=q(t_1)", T, &[r"\dot q=0"]),
        (r"q(\frac\pi k)=q(0)", T, &[r"\dot q=0"]),
        (r"|t_0|=t_0", T, &[r"q(\sqrt{t_0})=1", "t_0>0"]),
        (r"J(2r)=1", T, &[]),
    ];
    for line in &lines {
        assert_eq!(word(line).0, "proved", "{line:?}");
    }
}

fn steps(premise: &str, says: &str, motion: &str) -> &'static str {
    let states = ["x", "y", "z"].map(|s| format!("'{s}' = {{ role = 'state' }}\n")).concat();
    let premise = format!("[[claim]]\nid = 'p'\nsays = 'p'\nalways = ['{premise}']\n");
    let claim = format!("[[claim]]\nid = 'c'\nsays = 'c'\nalways = ['{says}']\nfollows-from = ['p']\n");
    let motion = format!("[[trajectory]]\nid = 'm'\n{motion}\n");
    let account = of_file(&(states + &premise + &claim + &motion));
    account.claims[1].identity.as_ref().map_or("none", |i| i.standing())
}

/// A definition may name the rate of another one; and the rate of what has no value has none, whatever is left of it.
#[test]
fn a_rate_is_that_of_its_formula() {
    const V: &[&str] = &["t: time", "x, y, z: state", "V: observable = x^2", r"U: observable = \dot V"];
    const SECOND: &[&str] = &["t: time", "x, y, z: state", "V: observable = x", r"U: observable = \ddot V+V"];
    const THIRD: &[&str] =
        &["t: time", "x, z: state", r"V: observable = \dot x", "W: observable = V^2+x^2", r"U: observable = \dot W"];
    const FIXED: &[&str] = &["t: time", "x, z: state", "V: observable = x^2", r"U: observable = \dot V(0)"];
    const VECTOR: &[&str] = &["t: time", "z: state", "v: 2, state", "l: observable = |v|^2", r"L: observable = \dot l"];
    const ANGLE: &[&str] =
        &["t: time", "x, z: state", r"\chi: angle = \operatorname{atan2}(x,1)", r"U: observable = \dot\chi"];
    const ROOT: &[&str] = &["t: time", "x, y, z: state", r"U: observable = \sqrt x", "p: parameter, positive"];
    const UNIT: &[&str] = &["t: time", "z: state", "v: 2, state", r"n: 2, observable = \frac{v}{|v|}"];
    let lines: [Line; 23] = [
        // U is 0.
        ("z=z", V, &[r"\dot x=0", "U(0)=1"]),
        ("x=x(0)", V, &["x=2", "U(0)=1"]),
        ("z=z", V, &[r"\dot x=1", "x(0)=3", "U(0)=100"]),
        ("z=z", V, &[r"\dot x=0", r"y=\frac1U"]),
        (r"\frac zU=\frac{2z}{2U}", V, &[r"\dot x=0"]),
        (r"\ln(U(0))=\ln(U(0))", V, &[r"\dot x=0"]),
        (r"\sqrt{-1-U}^2=-1-U", V, &[r"\dot x=0"]),
        ("z=z", SECOND, &[r"\ddot x=-x", "U(0)=1"]),
        ("z=z", THIRD, &[r"\dot x=-x", "x(0)=0", "U(0)=1"]),
        ("z=z", FIXED, &[r"\dot x=0", "U=1"]),
        ("z=z", VECTOR, &[r"\dot v=0", "L=1"]),
        ("z=z", ANGLE, &[r"\dot x=0", "U(0)=1"]),
        // √(−1) has no rate.
        ("z=z", ROOT, &["x=-1", r"\dot U=0"]),
        ("z=z", ROOT, &["x=-1", r"\dot U(0)=0"]),
        ("z=z", ROOT, &["x=-1", r"\dot U=y", "y=0"]),
        ("z=z", ROOT, &["x=-1", r"\dot U\dot y=0"]),
        ("z=z", ROOT, &["x=-1", r"\ddot U=0"]),
        ("z=z", ROOT, &["x=-1", r"\dot U=\dot U"]),
        ("z=z", ROOT, &["x=-p", r"\dot U=y", "y=0"]),
        ("z=z", UNIT, &["v=(0,0)", r"\dot n=0"]),
        ("z=z", ANGLE, &[r"\dot x=0", "U=1"]),
        ("z=z", FIXED, &["x=2", "U=1"]),
        ("z=z", SECOND, &["x=0", "U=1"]),
    ];
    for line in &lines {
        assert_eq!(word(line).0, "undecided", "{line:?}");
    }
    let lines: [Line; 4] = [
        ("U=4x", V, &[r"\dot x=2"]),
        ("U(0)=2", V, &[r"\dot x=1", "x(0)=1"]),
        ("z=z", ROOT, &["x=1", r"\dot U=0"]),
        ("U=0", SECOND, &[r"\ddot x=-x"]),
    ];
    for line in &lines {
        assert_eq!(word(line).0, "proved", "{line:?}");
    }
}

/// A motion has all rates that are named, by however many names: x = |z| z³ has no fourth one at 0.
#[test]
fn a_motion_is_as_smooth_as_rates_of_rates_ask() {
    const RATES: &[&str] = &[
        "t: time",
        "x, y, z, w: state",
        "a: parameter",
        r"B: observable = \dot x",
        r"C: observable = \dot B",
        r"D: observable = \dot C",
        r"E: observable = y\dot D",
    ];
    let lines: [Line; 6] = [
        (r"y\dot D=0", RATES, &["x=|y|y^3", "y(0)=0", "y=at"]),
        (r"w\dot D=2\dot D", RATES, &["z=t", "x=|z|z^3", "z(0)=0", "w=2"]),
        (r"\dot D=\dot D", RATES, &["z=t", r"x=\lfloor z\rfloor z^4", "z(0)=0"]),
        (r"w\dot D=5\dot D", RATES, &["z=t", "x=|z|z^3", "z(0)=0", "w=2"]),
        (r"w\dot E=2\dot E", RATES, &["z=t", "x=|z|z^4", "z(0)=0", "w=2", "y=1"]),
        (r"w\dot D=2\dot D", RATES, &["z=t^2", "x=|z-1|(z-1)^3", "z(1)=1", "w=2"]),
    ];
    for line in &lines {
        assert_eq!(word(line).0, "undecided", "{line:?}");
    }
    let line: Line = (r"w\dot D=2\dot D", RATES, &["z=t", "x=|z|z^5", "z(0)=0", "w=2"]);
    assert_eq!(word(&line).0, "proved", "{line:?}");
}

/// A motion refutes a step only if it goes through the times that are named, is smooth, and what is given is so on it, and not only as far
/// as numbers show.
#[test]
fn a_motion_refutes_what_follows_from_what_is_so_on_it() {
    for (premise, says, motion) in [
        // Beyond its span it does not rest.
        (r"\dot x=0", "x(3)=x(0)", "formula = { x = 't+|t-2|' }\nspan = [0, 1]"),
        (r"\dot x=1", "x=x(0)+t", "formula = { x = '|t-2|' }\nspan = [3, 4]"),
        // It has a kink.
        (r"\ddot x=0", r"\dot x=\dot x(0)", "formula = { x = '|t-2|' }\nspan = [0, 4]"),
        // sin x is not x.
        (r"\sin x=x", "x=0", r"formula = { x = '10^{-9}\sin t' }"),
        ("e^x=1+x", "x=0", r"formula = { x = '10^{-9}\sin t' }"),
        // eˣ ≤ 1 means x ≤ 0.
        (r"e^x\le1", "|x|=-x", "formula = { x = '10^{-25}' }"),
        (r"10^{14}+e^x\le10^{14}+1", "|x|=-x", "formula = { x = '10^{-4}' }"),
    ] {
        let motion = if motion.contains("span") { motion.to_owned() } else { format!("{motion}\nspan = [0, 4]") };
        assert_ne!(steps(premise, says, &motion), "refuted", "{premise}: {says}: {motion}");
    }
    assert_eq!(steps(r"\dot x=y", "x=1", "formula = { x = 't', y = '1' }\nspan = [0, 1]"), "refuted");
}

/// A premise may call something else by a name of its own.
#[test]
fn a_premise_with_names_of_its_own_is_not_looked_through() {
    let states = ["x", "y"].map(|s| format!("'{s}' = {{ role = 'state' }}\n")).concat();
    let premise = "[[claim]]\nid = 'p'\nsays = 'p'\nsymbols = { 'h' = { role = 'observable', formula = '\\sin x' } }\n\
                   always = ['h=1+e^y']\n[[claim]]\nid = 'c'\nsays = 'c'\nalways = ['x=x']\nfollows-from = ['p']\n";
    let account = of_file(&(states + premise));
    let word = account.claims[1].identity.as_ref().map_or("none", |i| i.standing());
    assert!(!word.starts_with("proved"), "{word}");
}

/// An angle whose formula names something that leaps is no less continued than one with the formula written out.
#[test]
fn an_angle_is_continued_whatever_its_formula_is_called() {
    const A: &[&str] = &[
        "t: time",
        "x, y: state",
        r"V: observable = \operatorname{atan2}(y,x)",
        "U: observable = V",
        r"W: observable = 5\lfloor x\rfloor",
        r"\xi: observable, angle = V",
        r"\zeta: observable, angle = U",
        r"\nu: observable, angle = W",
        r"\theta: observable, angle = \operatorname{atan2}(y,x)",
        r"\eta: observable, angle = 2\theta",
        r"\mu: observable, angle = \theta+V",
    ];
    // x = cos t, y = sin t at t = 4: the angle is 4, and its formula 4 − 2π.
    let circle: &[&str] = &[r"x=\cos t", r"y=\sin t"];
    for claim in [
        r"\xi=V",
        r"\xi(4)=V(4)",
        r"\xi\ne V+2\pi",
        r"e^\xi=e^V",
        r"\zeta=V",
        r"\mu=\theta+V",
        r"\eta=2\theta",
        r"\nu=W",
    ] {
        for given in [&[], circle] {
            let found = word(&(claim, A, given)).0;
            assert!(!found.starts_with("proved"), "{claim}: {given:?}: {found}");
        }
    }
    assert_eq!(word(&(r"\cos\xi=\cos V", A, &[])).0, "proved");
}

/// What a family says of its members is not known before they are tried; a kink is no motion of what names the rate that is not there; what
/// is so at different times of a motion need not be so together.
#[test]
fn a_motion_shows_what_is_so_on_it_together() {
    let states = ["x", "y", "z", "w"].map(|s| format!("'{s}' = {{ role = 'state' }}\n")).concat();
    let head = states + "'a' = { role = 'parameter' }\n";
    let standing = |rest: &str| {
        let account = of_file(&format!("{head}{rest}"));
        let claim = account.claims.iter().find(|c| c.id == "c").expect("it is there");
        claim.identity.as_ref().map_or("none", |i| i.standing())
    };
    let claim = |more: &str| format!("[[claim]]\nid = 'c'\nsays = 'c'\nalways = ['w^2=1']\n{more}\n");
    let premise = |id: &str, more: &str| format!("[[claim]]\nid = '{id}'\nsays = '{id}'\n{more}\n");
    // x < 2 and x = 5 at some time.
    let family = "[[trajectory]]\nid = 'm'\nformula = { x = 't', w = '1' }\nspan = [0, 1]\n[[family]]\nid = 'f'\nof = 'm'\n\
                  vary = { 'a' = { values = [1, 2] } }\n";
    let of_family = premise("p", "eventually = ['x=5']\nfamilies = ['f']\ntrajectories = []")
        + &premise("q", "always = ['x<2']\nfamilies = ['f']\ntrajectories = []")
        + &claim("assuming = ['w=1']\nfollows-from = ['p', 'q']\nfamilies = ['f']\ntrajectories = []");
    let found = standing(&(family.replace("formula = {", "parameters = { 'a' = 1 }\nformula = {") + &of_family));
    assert!(!found.starts_with("proved"), "{found}");
    // ÿ is 0 or 2, and continuous: it is constant.
    let kink = "[system.s]\nstates = ['y', 'w']\nequations = ['\\dot y=|t-1|+t-1', '\\dot w=0']\n[[trajectory]]\nid = 'm'\nsystem = 's'\n\
                initial = { y = '0', w = '1' }\nspan = [0, 3]\n";
    let of_kink = premise("p", r"always = ['\ddot y(\ddot y-2)=0']")
        + &premise("q", r"eventually = ['\ddot y<0.1']")
        + &premise("r", r"eventually = ['\ddot y>1.9']")
        + &claim("assuming = ['w=1']\nfollows-from = ['p', 'q', 'r']");
    let found = standing(&(kink.to_owned() + &of_kink));
    assert!(!found.starts_with("proved"), "{found}");
    // At no time z is above ½ and below −½.
    let line = "[[trajectory]]\nid = 'm'\nformula = { z = 't', x = '5', y = '0', w = '2' }\nspan = [-1, 1]\n";
    let of_line = premise("p", "assuming = ['z>0.5']\nalways = ['x>1']")
        + &premise("q", "assuming = ['z<-0.5']\nalways = ['y=0', 'w=2']")
        + &claim("follows-from = ['p', 'q']").replace("w^2=1", "w^2=2w");
    let found = standing(&(line.to_owned() + &of_line));
    assert!(!found.starts_with("proved"), "{found}");
}
