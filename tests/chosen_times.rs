//! What is known at the times, or places, that a claim chooses, and what may be concluded of others: wrong proofs that were found once.

use crate::premises::{of_file, standing};

fn step(id: &str, given: &str, says: &str) -> String {
    format!("[[claim]]\nid = '{id}'\nsays = 'test'\ntrajectories = []\n{given}\n{says}\n")
}

fn states(names: &[&str]) -> String {
    names.iter().map(|name| format!("'{name}' = {{ role = 'state' }}\n")).collect()
}

fn system(id: &str, states: &[&str], equations: &[&str]) -> String {
    format!(
        "[system.{id}]\nstates = {states:?}\nequations = [{}]\n",
        equations.iter().map(|e| format!("'{e}',")).collect::<String>()
    )
}

#[test]
fn what_goes_on_is_determined_by_systems() {
    // x = t² before 0 and −t² behind it are one motion: where the factor of a rate vanishes, nothing is determined.
    let singular = states(&["x", "y"]) + &system("s", &["x", "y"], &[r"t\dot x=2x", r"\dot y=y"]);
    let claim = step("c", "follows-from = ['s']\nassuming = ['t>0', 'x=t^2']", "always = ['x(-1)=1']");
    assert_ne!(standing(&of_file(&(singular + &claim)), "c"), "proved");
    // A state that no equation determines may be anything.
    let open = states(&["x", "y", "u"]) + &system("s", &["x", "y"], &[r"\dot x=u", r"\dot y=y"]);
    let claim = step("c", "follows-from = ['s']\nassuming = ['x>0', 'x=t']", "always = ['x(-1)=-1']");
    assert_ne!(standing(&of_file(&(open + &claim)), "c"), "proved");
    // A smooth function need not be analytic.
    let field = "'s' = { role = 'coordinate' }\n'f(s)' = { role = 'field' }\n";
    let smooth = states(&["x", "y"]) + field + &system("s", &["x", "y"], &[r"\dot x=1", r"\dot y=f(x)"]);
    let claim = step("c", "follows-from = ['s']\nassuming = ['x>0', 'y=0']", "always = ['y(-1)=0']");
    assert_ne!(standing(&of_file(&(smooth + &claim)), "c"), "proved");
    // One that is determined goes on, also where the rates are solved for together and a denominator is never 0.
    let polar = system("s", &["r", "f"], &[r"\dot r\cos f-r\dot f\sin f=\frac1r", r"\dot r\sin f+r\dot f\cos f=0"]);
    let polar = states(&["r", "f"]) + &polar;
    let claim = step("c", "follows-from = ['s']\nassuming = ['r>2', 'f=0']", "first-integral = ['f']");
    assert_eq!(standing(&of_file(&(polar + &claim)), "c"), "proved");
}

#[test]
fn a_constant_that_may_vanish_is_an_exception_of_a_solution() {
    let free =
        "'a' = { role = 'parameter' }\n'k' = { role = 'parameter', positive = true }\n".to_owned() + &states(&["q"]);
    let solution = r"always = ['q=q(0)\cos t+\dot q(0)\sin t']";
    let any = system("s", &["q"], &[r"a\ddot q=-aq"]) + &step("c", "follows-from = ['s']", solution);
    assert_eq!(standing(&of_file(&(free.clone() + &any)), "c"), "proved except");
    let positive = system("s", &["q"], &[r"k\ddot q=-kq"]) + &step("c", "follows-from = ['s']", solution);
    assert_eq!(standing(&of_file(&(free + &positive)), "c"), "proved");
}

#[test]
fn at_single_times_and_places_nothing_is_known_of_derivatives() {
    // y = t on the motion x = t²: the claim chooses t = 0 alone, where y = 0.
    let file = states(&["x", "y", "z"]) + &system("s", &["x", "y", "z"], &[r"\dot x=2t", r"\dot y=z", r"\dot z=0"]);
    let single = [r"x\le0", r"-|x|\ge0", r"\sqrt{-x}>-1", r"\sqrt{-x}\ne5", r"t^2\le0", r"\lfloor x\rfloor>-1"];
    let claims = single.iter().enumerate().map(|(i, chooses)| {
        step(&format!("c{i}"), &format!("follows-from = ['s']\nassuming = ['{chooses}', 'y=0']"), "always = ['z=0']")
    });
    let open = step("open", "follows-from = ['s']\nassuming = ['x<1', 'y=0']", "always = ['z=0']");
    let account = of_file(&(file + &claims.collect::<String>() + &open));
    for (i, chooses) in single.iter().enumerate() {
        assert!(["undecided", "refuted"].contains(&standing(&account, &format!("c{i}"))), "{chooses}");
    }
    assert_eq!(standing(&account, "open"), "proved");
    // u = x at the place x = 0.
    let field = "'x' = { role = 'coordinate' }\n'c' = { role = 'parameter' }\n'u(x,t)' = { role = 'field' }\n";
    let claim = |id: &str, given: &str| {
        format!("[[claim]]\nid = '{id}'\nsays = 'test'\nassuming = ['u=0', {given}]\nalways = ['u_x=0']\n")
    };
    let all = [claim("square", r"'x^2\le0'"), claim("both", r"'x\le c', 'x\ge c'"), claim("region", "'x>c'")];
    let account = of_file(&(field.to_owned() + &all.concat()));
    assert_eq!(["square", "both"].map(|id| standing(&account, id)), ["undecided"; 2]);
    assert_eq!(standing(&account, "region"), "proved");
}

#[test]
fn what_must_not_vanish_may_vanish_for_a_while() {
    // w = t − 1, and y = 0 before t = 1, (t − 1)² behind it.
    let bent = states(&["w", "y"]) + &system("s", &["w", "y"], &[r"\dot w=1", r"\dot y=|w|+w"]);
    let claim = step(
        "c",
        r"follows-from = ['s']
assuming = ['|w|-w\ne0']",
        "always = ['y=y(2)']",
    );
    assert_ne!(standing(&of_file(&(bent + &claim)), "c"), "proved");
    let free = states(&["x", "y"]);
    let claims = [
        step("product", r"assuming = ['x\ne0', 'xy=0']", "always = ['y(2)=0']"),
        step("rate", r"assuming = ['x\ne0', 'x\dot y=0']", "always = ['y=y(0)']"),
        step("now", r"assuming = ['x\ne0', 'xy=0']", "always = ['y=0']"),
        step("of-time", r"assuming = ['t\ne0', 't\dot y=0']", "always = ['y=y(1)']"),
    ];
    let account = of_file(&(free + &claims.concat()));
    assert_eq!(["product", "rate"].map(|id| standing(&account, id)), ["refuted"; 2]);
    assert_eq!(["now", "of-time"].map(|id| standing(&account, id)), ["proved"; 2]);
}

#[test]
fn what_is_assumed_of_fewer_times_is_another_assumption() {
    // y = |x| − x is 0 for x > 0, and not before.
    let file = states(&["x", "w"])
        + "'y' = { role = 'observable', formula = '|x|-x' }\n"
        + &system("s", &["x", "w"], &[r"\dot x=1", r"\dot w=y"]);
    let claims = [
        step("throughout", "follows-from = ['s']\nassuming = ['y=0']", "always = ['w=w(0)']"),
        step("for-a-while", "follows-from = ['throughout']\nassuming = ['x>0', 'y=0']", "always = ['w=w(0)']"),
        step("again", "follows-from = ['throughout']\nassuming = ['y=0']", "always = ['2w=2w(0)']"),
    ];
    let account = of_file(&(file + &claims.concat()));
    assert_eq!(standing(&account, "throughout"), "proved");
    assert_ne!(standing(&account, "for-a-while"), "proved");
    // The checker does not replay what it follows from.
    assert_eq!(standing(&account, "again"), "proved given");
}

#[test]
fn systems_join_in_whatever_else_is_given() {
    let file = states(&["x", "y"]) + &system("s", &["x", "y"], &[r"\dot x=y", r"\dot y=-x"]);
    let claims = [
        step("rate", "follows-from = ['s']\nassuming = ['\\dot x=y']", r"always = ['\ddot x=-x']"),
        step("energy", "follows-from = ['s']\nassuming = ['\\dot x=y']", "first-integral = ['x^2+y^2']"),
    ];
    let account = of_file(&(file + &claims.concat()));
    assert_eq!(["rate", "energy"].map(|id| standing(&account, id)), ["proved"; 2]);
    // Two systems that move one state.
    let file = states(&["x", "y", "z"])
        + &system("a", &["x", "y"], &[r"\dot x=y", r"\dot y=0"])
        + &system("b", &["x", "z"], &[r"\dot x=z", r"\dot z=0"]);
    let claims = [
        step("now", "follows-from = ['a', 'b']", "always = ['y=z']"),
        step("then", "follows-from = ['a', 'b']", "always = ['y(1)=z(1)']"),
        step("wrong", "follows-from = ['a', 'b']", "always = ['y=2z']"),
    ];
    let account = of_file(&(file + &claims.concat()));
    assert_eq!(["now", "then"].map(|id| standing(&account, id)), ["proved"; 2]);
    assert_ne!(standing(&account, "wrong"), "proved");
}

#[test]
fn both_routes_take_further_derivatives() {
    let file = states(&["x", "v"]) + &system("free", &["x", "v"], &[r"\dot x=v", r"\dot v=0"]);
    let claims = [
        step("rest", "follows-from = ['free']\nassuming = ['\\dot x=2x']", "always = ['v=0']"),
        step("wrong", "follows-from = ['free']\nassuming = ['\\dot x=2x']", "always = ['v=1']"),
    ];
    let account = of_file(&(file + &claims.concat()));
    assert_eq!(["rest", "wrong"].map(|id| standing(&account, id)), ["proved", "refuted"]);
}

#[test]
fn an_angle_is_not_carried_through_the_point_where_it_has_none() {
    // x = t − 1, y = 0: the angle is π before t = 1 and 0 behind it.
    let head = states(&["x", "y"])
        + "'\\varphi' = { role = 'observable', angle = true, formula = '\\operatorname{atan2}(y,x)' }\n";
    let line = head.clone() + &system("s", &["x", "y"], &[r"\dot x=1", r"\dot y=0"]);
    let claims = [
        step("angle", "follows-from = ['s']\nassuming = ['y=0']", r"always = ['\varphi=\varphi(0)']"),
        step("cosine", "follows-from = ['s']\nassuming = ['y=0']", r"always = ['\cos\varphi=\cos\varphi(0)']"),
        step("twice", "follows-from = ['s']\nassuming = ['y=0']", r"always = ['\dot\varphi=0']"),
    ];
    let account = of_file(&(line + &claims.concat()));
    assert_ne!(standing(&account, "angle"), "proved");
    assert_ne!(standing(&account, "cosine"), "proved");
    assert_eq!(standing(&account, "twice"), "proved");
    // A system that divides by the distance does not come there.
    let away = head + &system("s", &["x", "y"], &[r"\dot x=\frac{x}{x^2+y^2}", r"\dot y=\frac{y}{x^2+y^2}"]);
    let account = of_file(&(away + &step("angle", "follows-from = ['s']", r"always = ['\varphi=\varphi(0)']")));
    assert_eq!(standing(&account, "angle"), "proved");
}

#[test]
fn inequalities_of_premises_hold_at_all_times() {
    // Lotka (1920): the first integral of two populations that live.
    let parameters: String =
        ["a", "b", "c", "d"].iter().map(|p| format!("'{p}' = {{ role = 'parameter', positive = true }}\n")).collect();
    let file = parameters + &states(&["N", "P"]) + &system("s", &["N", "P"], &[r"\dot N=aN-bNP", r"\dot P=-cP+dNP"]);
    let integral = r"first-integral = ['dN-c\ln N+bP-a\ln P']";
    let claims = [
        step("alive", "", "always = ['N>0', 'P>0']"),
        step("here", "assuming = ['N<1']", "always = ['P>0']"),
        step("integral", "follows-from = ['s', 'alive']", integral),
        step("without", "follows-from = ['s']", integral),
        step("for-a-while", "follows-from = ['s', 'here']", integral),
        step("wrong", "follows-from = ['s', 'alive']", r"first-integral = ['dN-c\ln N+bP-2a\ln P']"),
        step("values", "follows-from = ['alive']", r"always = ['\sqrt{N(1)^2}=N(1)']"),
    ];
    let account = of_file(&(file + &claims.concat()));
    let found = ["integral", "without", "wrong", "values"].map(|id| standing(&account, id));
    // The checker does not replay the first two, which are undecided then.
    assert_eq!(found, ["proved", "proved except", "refuted", "proved given"]);
    assert_ne!(standing(&account, "for-a-while"), "proved");
    assert_ne!(standing(&account, "for-a-while"), "proved given");
}
