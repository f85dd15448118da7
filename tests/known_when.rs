//! Facts that are known at some times, or in some case, and claims about others: nothing here may be proved, but for what is said to be.
//!
//! Beside each line stands a motion that satisfies what is given, and not the claim.

use assert_cmd::Command;

use crate::premises::{of_file, standing};

fn word(arguments: &[&str]) -> String {
    let mut command = Command::cargo_bin("rederive").expect("the program is built");
    let output = command.current_dir(env!("CARGO_MANIFEST_DIR")).arg("prove").args(arguments).output();
    let output = output.expect("the program runs");
    let text = String::from_utf8(output.stdout).expect("text");
    // What the prover finds, and the checker does not replay, is told apart from what it does not find.
    match text.contains("the prover finds a proof") {
        true => "unreplayed".to_owned(),
        false => text.lines().next().unwrap_or_default().to_owned(),
    }
}

/// A claim, the symbols, what is given.
pub type Line<'a> = (&'a str, &'a [&'a str], &'a [&'a str]);

pub fn asked(line: &Line) -> String {
    let (claim, symbols, given) = *line;
    let mut arguments = vec![claim];
    arguments.extend(symbols.iter().flat_map(|s| ["--symbol", s]));
    arguments.extend(given.iter().flat_map(|g| ["--given", g]));
    word(&arguments)
}

/// Whether the prover finds a proof, whether the checker replays it or not.
fn is_found(word: &str) -> bool {
    ["proved", "proved unreplayed", "unreplayed"].contains(&word)
}

fn never_proved(lines: &[Line]) {
    let wrong: Vec<&Line> = lines.iter().filter(|line| asked(line) == "proved").collect();
    assert!(wrong.is_empty(), "proved, and false: {wrong:#?}");
}

/// What a motion shows to be false is refuted.
fn refuted(lines: &[Line]) {
    for line in lines {
        assert_eq!(asked(line), "refuted", "{line:?}");
    }
}

/// No motion that is continuous does what a point would need: what has a sign at all times keeps it, and what is smallest has no rate.
#[test]
fn points_at_several_times_are_no_motion() {
    const X: &[&str] = &["x, y: state"];
    let lines: [Line; 14] = [
        ("|x(1)-x(0)|=x(1)-x(0)", X, &[r"\dot x>0", r"t^2\ge0"]),
        ("|x(0)x(1)|=x(0)x(1)", X, &[r"x\ne0", r"t^2\ge0"]),
        (r"\dot x(0)\dot x(1)=|\dot x(0)\dot x(1)|", X, &[r"\dot x\ne0", r"t^2\ge0"]),
        ("|x(0)x(1)|=x(0)x(1)", X, &["x^2>0"]),
        ("|x(0)x(1)|=x(0)x(1)", X, &[r"xy\ne0"]),
        ("|x(0)x(1)|=x(0)x(1)", X, &["|x|+|y|>|y|"]),
        ("|x(0)x(1)|=x(0)x(1)", X, &[r"\ln|x|\ne7"]),
        ("|x(0)+x(1)|=|x(0)|+|x(1)|", X, &["x^2>0"]),
        ("|x(0)(x(1)+1)|=x(0)(x(1)+1)", X, &[r"x+t\ne0"]),
        ("|x(0)(x(1)-1)|=x(0)(x(1)-1)", X, &[r"(x-t)^2\ge1"]),
        ("|x-t|=x-t", X, &[r"x\ne t", "x(0)=1"]),
        ("|x|=x", X, &[r"x^2\ge1+t^2", "x(0)>0"]),
        (r"\dot x(0)\cdot x(1)x(-1)=0", X, &[r"x\ge t^2", "x(0)=0"]),
        (r"x(0)\cdot(1+x(1)^2+x(-1)^2)=0", X, &[r"tx\ge0"]),
    ];
    let wrong: Vec<&Line> = lines.iter().filter(|line| asked(line) == "refuted").collect();
    assert!(wrong.is_empty(), "refuted, and true: {wrong:#?}");
    refuted(&[
        ("x(1)=x(0)", X, &["x>0"]),
        ("x(1)x(0)=1", X, &[r"x^2\ge1"]),
        ("|x|=x+t", X, &["x>0"]),
        ("x(1)=2x(0)", X, &[r"x\ne0", "y>x"]),
    ]);
}

#[test]
fn limits_want_sides_that_do_not_leap() {
    const N: &[&str] = &["x,y: state", r"N: observable = \lfloor x\rfloor"];
    refuted(&[
        // x = 2 − t², y = t
        ("N=1", N, &["tN=t"]),
        ("N=1", N, &["yN=y", r"\dot y=1"]),
        ("N=1", N, &["t^3N=t^3"]),
        ("2N=2", N, &["tN=t"]),
        ("N=1", &["x: state", r"N: observable = \lceil x\rceil"], &[r"N\sqrt t=\sqrt t"]),
        ("K=2", &["x: state", r"N: observable = \lfloor x\rfloor", "K: observable = N+1"], &["tK=2t"]),
    ]);
    never_proved(&[
        ("N=1", N, &[r"N\sin t=\sin t"]),
        (r"P=0", &["x: state", r"P: observable = \operatorname{atan2}(x,-1)+\pi"], &["tP=0"]),
    ]);
}

#[test]
fn a_start_with_an_open_need_shows_nothing() {
    refuted(&[
        // x = −t²
        (r"\operatorname{atan2}(0,x)=0", &["x: state"], &["x(0)^2=x(0)", r"x(0)\dot x=0"]),
        (r"\operatorname{atan2}(0,x)=0", &["x: state"], &["x(0)^3=x(0)^2", r"x(0)\dot x=0"]),
        // x = −sin t, y = 0
        ("x(1)=W(1)", &["x,y: state", r"W: observable = \frac{x}{|x|}"], &["x(0)x=x(0)", r"y(0)=\ddot x(0)"]),
        (r"\frac{x}{|x|}=1", &["x: state"], &["x(0)^2=x(0)", r"x(0)\dot x=0"]),
    ]);
}

#[test]
fn nothing_follows_from_what_no_motion_satisfies() {
    never_proved(&[
        ("x=5", &["x: state"], &["x=5+t", "x=5"]),
        ("x=5", &["x: state"], &["x=5+t^2", "x=5"]),
        ("c=x", &["x: state", "c"], &[r"\dot x=c", "x=e^t"]),
        ("a=t", &["a", "y: state"], &["at=t^2"]),
        ("u=0", &["x: coordinate", "u(x): field"], &["u=x", "u=2x"]),
        ("x=x(0)", &["x,y: state"], &[r"x\dot x=0", "y=0", "y(0)=1"]),
        // What is given at one time and at another.
        ("x(0)=x(1)", &["x: state"], &["x(0)=1", "x(1)=2", r"\dot x=0"]),
        ("x=x(0)", &["x: state"], &["x(0)>0", "x(1)<0", r"\dot x=0"]),
        ("x=1", &["x: state"], &["x(0)=1", "x(1)=-1", "x^2=1"]),
    ]);
    assert_eq!(asked(&("x=1", &["x: state"], &["x(0)=1", "x(1)>0", r"\dot x=0"])), "proved");
}

#[test]
fn rates_of_functions_with_edges_exist_off_the_edges_only() {
    const R: &[&str] = &["x,y,w: state", r"r: observable = \sqrt{x^2+y^2}"];
    const G: &[&str] = &["x,y: state", r"G: observable = \sqrt x"];
    const V: &[&str] = &["x,y: state", "V: observable = |x|"];
    refuted(&[
        // x = y = 0, w = t
        (r"\dot w=0", R, &["rw=r"]),
        (r"\dot w=0", R, &["r^2w=r^2"]),
        (r"\ddot w=1", R, &["rw=r"]),
        (r"\dot w=0", R, &[r"w\sqrt{x^2+y^2}=\sqrt{x^2+y^2}"]),
        // x = 0, y = t, G = 0
        (r"\dot y=0", G, &["xy=x", r"G\ge0"]),
        (r"\dot y=0", G, &["Gy=G"]),
        (r"\dot y=0", V, &["Vy=V"]),
        (r"\dot y=0", &["x,y: state"], &[r"y\left|x\right|=\left|x\right|"]),
        (r"\dot y=0", &["x,y: state"], &[r"y\sqrt x=\sqrt x"]),
        (r"y=\ddot x(0)", G, &[r"xy=x\ddot x(0)", "G=G(1)"]),
        (r"\dot y=0", &["x,y: state", "B: observable = x^{\\frac32}"], &["By=B"]),
    ]);
    never_proved(&[(r"\dot y=0", &["x,y: state"], &[r"y\arcsin(1+x)=\arcsin(1+x)", r"xy=x", r"x\le0"])]);
}

#[test]
fn what_vanishes_at_one_time_need_not_do_so_for_a_while() {
    refuted(&[
        // x = t, y = 5
        ("y(0)=1", &["x,y: state"], &["x(0)y(0)=x(0)", r"\dot x=1"]),
        ("y(1)=1", &["x,y: state"], &["x(1)y(1)=x(1)", r"\dot x=1"]),
        ("y(0)=1", &["x,y: state"], &["x(0)^2y(0)=x(0)^2", r"\dot x=1"]),
        // x = 0 and v = 1 at time 0
        ("v(0)=2", &["x,v: state"], &["x(0)v(0)=2x(0)", r"\dot x=v", r"v\ge1"]),
        ("y(0)=1", &["x,y: state", "g: parameter, positive"], &["x(0)y(0)=x(0)", r"\ddot x=-g"]),
        // x = t²
        (r"\dot x(0)=\ddot x(0)", &["x: state"], &[r"x(0)\dot x(0)=x(0)\ddot x(0)", r"x\ge0"]),
    ]);
}

#[test]
fn a_motion_that_refutes_satisfies_all_that_is_given() {
    // Each has a motion that satisfies all but one thing that is given.
    let true_claims: &[Line] = &[
        ("N=1", &["x: state", r"N: observable = \lfloor x\rfloor"], &["tN=t", r"x\ge1", "x<2"]),
        (r"\dot y=0", &["x,y: state", "V: observable = |x|"], &["Vy=V", "V>0"]),
        ("y(0)=1", &["x,y: state"], &["x(0)y(0)=x(0)", "x(0)=3"]),
        (r"\ddot x=0", &["x: state"], &[r"\dot x^2=4"]),
        ("x(1)=x(0)+1", &["x: state"], &[r"\dot x=1"]),
    ];
    for line in true_claims {
        assert_ne!(asked(line), "refuted", "{line:?}");
    }
    // A state has the rates that are named: x = |t| has none at 0.
    assert_ne!(asked(&(r"x\dot x=0", &["x: state"], &[r"\dot x^2=x^2", r"x(0)=0"])), "refuted");
}

/// What is said of fixed times alone is asked of these: a time at which it is false is none of them.
#[test]
fn a_sign_at_a_fixed_time_is_known_there() {
    const X: &[&str] = &["x, y: state"];
    let known: [Line; 6] = [
        ("|x(0)|=x(0)", X, &["x(0)>0"]),
        ("x(0)=y(0)", X, &[r"x(0)\le y(0)", r"y(0)\le x(0)"]),
        ("|x(0)-x(1)|=x(0)-x(1)", X, &["x(0)>x(1)"]),
        (r"\sqrt{x(0)^2}=x(0)", X, &[r"x(0)\ge0"]),
        ("|x(0)y(0)|=x(0)|y(0)|", X, &[r"x(0)\ge0"]),
        (r"|\dot x(0)|=\dot x(0)", X, &[r"\dot x(0)>0"]),
    ];
    for line in known {
        assert!(is_found(&asked(&line)), "{line:?}");
    }
    for line in [("x(0)=0", X, &[r"x(0)\ge0", r"x(0)\le0"][..]), (r"x=0", X, &[r"\sqrt{-x^2}=\sqrt{-x^2}"][..])] {
        assert_ne!(asked(&line), "refuted", "{line:?}");
    }
    refuted(&[("|x(1)|=x(1)", X, &["x(0)>0"]), ("x(1)=x(0)", X, &["x(0)>0"])]);
}

/// A field is continuous, too: a sign that it has at all places ties its values at several, and a point whose values have signs of
/// their own refutes nothing.
#[test]
fn points_at_several_places_are_no_field() {
    const F: &[&str] = &["x: coordinate", "f(x): field"];
    const U: &[&str] = &["x: coordinate", "t: time", "u(x,t): field"];
    let lines: [Line; 7] = [
        ("|f(0)f(1)|=f(0)f(1)", F, &[r"f\ne0"]),
        ("|f(0)f(1)|=f(0)f(1)", F, &["f^2>0"]),
        ("|f(x)f(0)|=f(x)f(0)", F, &[r"f\ne0"]),
        ("f(0)=0", F, &[r"xf\ge0"]),
        ("|u(0,t)u(1,t)|=u(0,t)u(1,t)", U, &[r"u\ne0"]),
        ("u(0,t)=0", U, &[r"xu\ge0"]),
        ("|u(0,t)u(x,0)|=u(0,t)u(x,0)", U, &[r"u\ne0"]),
    ];
    let wrong: Vec<&Line> = lines.iter().filter(|line| asked(line) == "refuted").collect();
    assert!(wrong.is_empty(), "refuted, and true: {wrong:#?}");
    // At the places that are named, a sign is known that is known at all.
    let known: [Line; 7] = [
        ("|f(0)|=f(0)", F, &["f>0"]),
        ("|f'(0)|=f'(0)", F, &["f'>0"]),
        ("|u(0,t)|=u(0,t)", U, &["u>0"]),
        ("|u(0,0)|=u(0,0)", U, &["u(0,t)>0"]),
        ("f(f(x))=f(x)", F, &["f=x"]),
        ("f(f(0))=f(1)", F, &["f(0)=1"]),
        ("f(f(x))=f(f(x)^2)", F, &["f=1"]),
    ];
    for line in known {
        assert!(is_found(&asked(&line)), "{line:?}");
    }
    refuted(&[("f(1)=f(0)", F, &[]), ("f=f(0)", F, &["x>0"]), ("f=1", F, &["f>0"])]);
}

fn states(names: &[&str]) -> String {
    names.iter().map(|name| format!("'{name}' = {{ role = 'state' }}\n")).collect()
}

fn step(id: &str, assuming: &[&str], from: &str, says: &str) -> String {
    let assuming: String = assuming.iter().map(|a| format!("'{a}',")).collect();
    format!(
        "[[claim]]\nid = '{id}'\nsays = 'test'\ntrajectories = []\nassuming = [{assuming}]\n{from}\nalways = ['{says}']\n"
    )
}

fn none_is_proved(head: &str, claims: &[(&[&str], &str, &str)]) {
    let text: String = claims
        .iter()
        .enumerate()
        .map(|(at, (assuming, from, says))| step(&format!("c{at}"), assuming, from, says))
        .collect();
    // Fields have no motions that could be left out.
    let text = if head.contains("'field'") { text.replace("trajectories = []\n", "") } else { text };
    let account = of_file(&(head.to_owned() + &text));
    for (at, claim) in claims.iter().enumerate() {
        let standing = standing(&account, &format!("c{at}"));
        assert!(!matches!(standing, "proved" | "proved given"), "{standing}, and false: {claim:?}");
    }
}

#[test]
fn a_single_time_is_no_limit() {
    // y = 1 − t², z = 0; the last: x = −t².
    let system = "[system.s]\nstates = ['y', 'z']\nequations = ['\\dot y=-2t', '\\dot z=0']\n";
    none_is_proved(
        &(states(&["x", "y", "z"]) + system),
        &[
            (&[r"y\ge1", "tz=t"], "", "z=1"),
            (&[r"y\ge1", "tz=t"], "follows-from = ['s']", "z=1"),
            (&[r"y\ge1", "t^2z=t^2"], "", "z=1"),
            (&[r"-|y-1|\ge0", "tz=t"], "", "z=1"),
            (&[r"\sqrt x=0", "tz=t"], "", "z=1"),
            (&[r"tz\sqrt x=t\sqrt x", "z=z(1)"], "", r"z\sqrt x=\sqrt x+x"),
        ],
    );
}

#[test]
fn what_is_assumed_at_chosen_times_is_not_known_at_others() {
    // x = t, z = 2 + (|1 − t| + 1 − t)³
    let formula = r"'W' = { role = 'observable', formula = '\frac{x}{|x|}' }";
    none_is_proved(
        &format!("{}{formula}\n", states(&["x", "y", "z"])),
        &[
            (&["x>1", "z=2"], "", r"\dot z(0)=0"),
            (&["x>1", r"\dot z=0"], "", r"\ddot z(0)=0"),
            (&["x>1", "z=2"], "", r"z(0)=2"),
            (&["x>1", "z=2"], "", r"\dot z=\dot z(0)"),
            (&[r"x\ne1", "z=2"], "", r"\dot z(1)=0"),
            // y = 0 before 0, e^{−1/t} behind it
            (&[r"y\le0", r"y\dot y=y\dot y(1)"], "", r"\dot y=\dot y(1)"),
            (&[r"y\le0", r"y\ddot y=y\ddot y(1)"], "", r"\ddot y=\ddot y(1)"),
            (&["x<0", "y=0"], "", r"\dot y(1)=0"),
            // x = sin t, z = 1: what W needs at the present says nothing of time 0.
            (&[r"x\ne0", "x(0)W=x(0)z(0)"], "", "W=z(0)"),
        ],
    );
}

#[test]
fn what_is_assumed_at_chosen_places_is_not_known_at_others() {
    // v = h(−x − t), u = h(x + t), with h = 0 before 0 and e^{−1/s} behind it.
    let head = "'x' = { role = 'coordinate' }\n'u(x,t)' = { role = 'field' }\n'v(x,t)' = { role = 'field' }\n\
                [system.d]\nfields = ['v']\nequations = ['v_t=v_x']\n";
    let d = "follows-from = ['d']";
    none_is_proved(
        head,
        &[
            (&[r"u\ne0", "v=0"], d, "v(-1,t)=0"),
            (&[r"u\ne0", "v=0"], d, "v_x(-1,t)=0"),
            (&["u>0", "v=0"], d, "v(-1,t)=0"),
            (&["u>0", "v=0"], d, "v(x,0)=0"),
            (&["u>1", "v=2"], d, "v(-1,t)=2"),
            (&["u>0", "v_x=0"], d, "v_t(-1,t)=0"),
        ],
    );
}

#[test]
fn what_holds_wherever_it_has_a_value_says_nothing_of_other_times() {
    // The lemma has no value while y is 0, and x moves then.
    let lemma = |says: &str| format!("[[claim]]\nid = 'p'\nsays = 'test'\ntrajectories = []\nalways = ['{says}']\n");
    let p = "follows-from = ['p']";
    for says in [r"\frac{\dot x}{y}=0", r"\dot x\ln y=0", r"\dot x\sqrt{-y^2}=0"] {
        let head = states(&["x", "y"]) + &lemma(says);
        none_is_proved(&head, &[(&[], p, "x=x(0)")]);
    }
}

#[test]
fn what_is_known_always_is_known_at_fixed_times_and_with_its_rates() {
    let proved: &[Line] = &[
        (r"\dot x(0)=0", &["x: state"], &[r"\dot x=0"]),
        (r"\ddot z(1)=0", &["z: state"], &["z=2"]),
        (r"\dot x=\dot y", &["x,y: state"], &[r"x\ge y", r"x\le y"]),
        (r"\dot r=\frac{x\dot x+y\dot y}{r}", &["x,y: state", r"r: observable = \sqrt{x^2+y^2}"], &["r>0"]),
        (r"r\dot r=x\dot x+y\dot y", &["x,y: state", r"r: observable = \sqrt{x^2+y^2}"], &["r>0"]),
        ("E(2)=E(0)", &["x: state", r"E: observable = \dot x^2+x^2"], &[r"\ddot x=-x"]),
    ];
    for line in proved {
        assert!(is_found(&asked(line)), "{line:?}");
    }
    let head = states(&["x", "z"]) + "[system.s]\nstates = ['x', 'z']\nequations = ['\\dot x=1', '\\dot z=0']\n";
    let account = of_file(
        &(head
            + &step("open", &["x<1", "z=0"], "", r"\dot z=0")
            + &step("on", &["x>1", "z=2"], "follows-from = ['s']", r"\dot z(0)=0")),
    );
    assert_eq!([standing(&account, "open"), standing(&account, "on")], ["proved"; 2]);
}

/// What is so of all values chooses no times.
#[test]
fn what_is_always_so_leaves_no_time_out() {
    let head = states(&["x", "z"]) + "'W' = { role = 'observable', formula = '\\sqrt{x}' }\n";
    let cases: &[(&[&str], bool)] = &[
        (&[r"t^2\ge0", "z=2"], true),
        (&[r"0\le x^2+z^2", "z=2"], true),
        (&[r"|x|\ge0", "z=2"], true),
        // Not at x < 0, at x = 0, at negative x.
        (&[r"W^2\ge0", "z=2"], false),
        (&[r"\sqrt{x}\ge0", "z=2"], false),
        (&[r"x^2\le0", "z=2"], false),
        (&[r"x\ge0", "z=2"], false),
        (&[r"x^2\ge z^2", "z=2"], false),
    ];
    for (assumed, is_proved) in cases {
        let account = of_file(&(head.clone() + &step("c", assumed, "", "z(1)=2")));
        assert_eq!(standing(&account, "c") == "proved", *is_proved, "{assumed:?}");
    }
}

#[test]
fn an_operation_says_where_it_ends() {
    // y = 0: the mean has a value there alone.
    let head = states(&["y"]);
    for says in [r"\operatorname{agm}(-y^2,1)+1>0", r"\sqrt{-y^2}+1>0", r"(-y^2)^{\frac12}+1>0", r"\arccos(1+y^2)+1>0"]
    {
        let lemma = format!("[[claim]]\nid = 'p'\nsays = 'test'\nalways = ['{says}']\n");
        let account = of_file(&(head.clone() + &lemma + &step("c", &[], "follows-from = ['p']", r"\dot y=0")));
        assert_ne!(standing(&account, "c"), "refuted", "{says}");
    }
}

/// A first integral, and an inequality, say something where they have a value: on the other side of a time at which they have none, they
/// may say something else.
#[test]
fn what_has_no_value_between_two_times_ties_nothing() {
    let head = states(&["x", "y", "z"]);
    let cases: &[(&str, &[&str], &str)] = &[
        // x = t − 1, y = |1 − t| + 1 − t.
        (r"first-integral = ['y\sqrt{x}']", &[], "y^2x=y(0)^2x(0)"),
        (r"first-integral = ['\frac{y}{x}']", &[], "yx(0)=xy(0)"),
        // x = −t², y = t: a value at one time alone.
        (r"first-integral = ['y+x\sqrt{x}']", &[], r"\dot y+\frac32\sqrt{x}\dot x=0"),
        (r"first-integral = ['\sqrt{x}']", &[], "x=x(1)"),
        // x = t − 1, y = 2t − 1.
        (r"always = ['y>\sqrt{x}']", &[], "|y(0)|=y(0)"),
        (r"always = ['y>\sqrt{x}']", &[], r"\frac{y}{|y|}=\frac{y(0)}{|y(0)|}"),
        (r"always = ['\frac{y}{x}\ne 0']", &["yz=y"], "z(0)=1"),
        (r"always = ['\frac{y}{x}>0']", &["yz=y"], "z(0)=1"),
    ];
    for (says, assumed, claim) in cases {
        let lemma = format!("[[claim]]\nid = 'p'\nsays = 'test'\ntrajectories = []\n{says}\n");
        let account = of_file(&(head.clone() + &lemma + &step("c", assumed, "follows-from = ['p']", claim)));
        assert!(!standing(&account, "c").starts_with("proved given"), "{says}: {claim}");
        assert_ne!(standing(&account, "c"), "proved", "{says}: {claim}");
    }
    // With a value at all times they do.
    let given: &[(&str, &[&str], &str)] = &[
        (r"first-integral = ['y\sqrt{1+x^2}']", &[], "y^2(1+x^2)=y(0)^2(1+x(0)^2)"),
        (r"always = ['y>\sqrt{x^2}']", &[], "|y(0)|=y(0)"),
    ];
    for (says, assumed, claim) in given {
        let lemma = format!("[[claim]]\nid = 'p'\nsays = 'test'\ntrajectories = []\n{says}\n");
        let account = of_file(&(head.clone() + &lemma + &step("c", assumed, "follows-from = ['p']", claim)));
        assert_eq!(standing(&account, "c"), "proved given", "{says}: {claim}");
    }
}

/// What ends at a closed edge may be known at single times: no rate there is free for that, so that no point refutes. Where it is
/// positive at the times that count, it is known around them.
#[test]
fn a_closed_edge_refutes_nothing() {
    let head = states(&["x", "y"])
        + "'a' = { role = 'parameter' }\n'\\xi' = { role = 'coordinate' }\n'u(\\xi,t)' = { role = 'field' }\n\
           'v(\\xi,t)' = { role = 'field' }\n";
    let cases: &[(&[&str], &str, bool)] = &[
        (&[r"\sqrt{x}=y"], r"\dot x=2y\dot y", false),
        (&["x>0", r"\sqrt{x}=y"], r"\dot x=2y\dot y", true),
        (&["a>0", r"\sqrt{x}=a"], r"\dot x=0", false),
        (&["x>0", r"y=x^{\frac32}"], r"2x\dot y=3y\dot x", true),
        (&[r"x=\sqrt{a^2-y^2}", "x>0"], r"\dot x=-\frac{y\dot y}{x}", false),
        (&[r"\sqrt{x}=y"], "(x(0)+|x(0)|)(y(0)^2-x(0))=0", false),
        (&[r"\sqrt{u}=v"], "u_t=2v\\,v_t", false),
        (&["u>0", r"\sqrt{u}=v"], r"u_\xi=2v\,v_\xi", true),
    ];
    for (assumed, claim, is_proved) in cases {
        // Fields have no motions that could be left out.
        let text = step("c", assumed, "", claim);
        let text = if claim.starts_with("u_") { text.replace("trajectories = []\n", "") } else { text };
        let account = of_file(&(head.clone() + &text));
        let wanted = if *is_proved { "proved" } else { "undecided" };
        assert_eq!(standing(&account, "c"), wanted, "{assumed:?}: {claim}");
    }
    // What is of one time is refuted as before.
    let account = of_file(&(head + &step("c", &[r"\sqrt{x}=y"], "", "x=2y^2")));
    assert_eq!(standing(&account, "c"), "refuted");
}
