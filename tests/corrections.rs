//! What a claim that fails should have said: the simplest right form first, and nothing that says nothing.

use rederive::check::{Account, Correction, Options, check};
use rederive::derivation::parse;
use rederive::diag::{Source, render};
use rederive::report;
use rederive::verdict::Strength;

fn checked(text: &str, claims: &[&str], trajectories: &[&str]) -> Account {
    let source = Source { path: "derivations/wrong.toml".into(), text: text.into() };
    let derivation = parse(source, "wrong").unwrap_or_else(|e| panic!("{}", render(&e, false)));
    let list = |l: &[&str]| l.iter().map(|s| (*s).to_owned()).collect();
    let options = Options { claims: list(claims), trajectories: list(trajectories), ..Options::default() };
    check(&derivation, &options, &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"))
}

fn corrections(account: &Account) -> Vec<Correction> {
    let erratum = account.claims[0].variants.as_ref().and_then(|v| v.erratum.as_ref());
    erratum.map_or(Vec::new(), |e| e.corrections.clone())
}

/// The first correction of a file's only claim, with its strength.
fn first(text: &str) -> Option<(String, Strength)> {
    corrections(&checked(text, &[], &[])).first().map(|c| (c.formula.clone(), c.strength))
}

const DAMPED: &str = r"
[derivation]
title = 'Damped'
concerns = 'Any textbook'
[symbols]
't' = { role = 'time' }
'\gamma' = { role = 'parameter', positive = true }
'\omega' = { role = 'parameter', positive = true }
'x' = { role = 'state' }
'v' = { role = 'state' }
'E' = { role = 'observable', formula = '\frac12\dot x^2+\frac12\omega^2x^2' }
[system.damped]
states = ['x', 'v']
equations = ['\dot x=v, \quad \dot v=-2\gamma v-\omega^2x']
[[trajectory]]
id = 'one'
system = 'damped'
parameters = { '\gamma' = 0.1, '\omega' = 1.3 }
initial = { 'x' = 0.7, 'v' = 0.3 }
span = [0, 5]
[[trajectory]]
id = 'two'
system = 'damped'
parameters = { '\gamma' = 0.3, '\omega' = 0.9 }
initial = { 'x' = -0.4, 'v' = 1.1 }
span = [0, 5]
[[claim]]
id = 'wrong'
says = 'The energy'
FORM
";

fn damped(form: &str) -> String {
    DAMPED.replace("FORM", form)
}

#[test]
fn a_rate_that_stands_alone_stays_alone() {
    let found = first(&damped(r"always = ['\dot E=-\gamma\dot x^2']"));
    assert_eq!(found, Some((r"\dot E=-2\gamma\dot x^2".to_owned(), Strength::Proved)));
    let found = first(&damped(r"always = ['E=\dot x^2+\frac12\omega^2x^2']"));
    assert_eq!(found, Some((r"E=\frac{1}{2}\dot x^2+\frac{1}{2}\omega^2x^2".to_owned(), Strength::Proved)));
}

#[test]
fn of_an_energy_that_drifts_the_rate_is_told() {
    for (form, says) in
        [("E", r"\dot E=-2\gamma\dot x^2"), (r"v^2+\omega^2x^2", r"\frac{d}{dt}(v^2+\omega^2x^2)=-4\gamma v^2")]
    {
        let text = damped(&format!("first-integral = ['{form}']"));
        let account = checked(&text, &[], &[]);
        // E − E is constant, too, and says nothing.
        assert_eq!(corrections(&account), [], "{form}");
        let rate = account.claims[0].variants.as_ref().and_then(|v| v.erratum.as_ref()).and_then(|e| e.rate.clone());
        assert_eq!(rate.as_deref(), Some(says));
        let source = Source { path: "derivations/wrong.toml".into(), text };
        let derivation = parse(source, "wrong").expect("it was read");
        let told = report::summary(&derivation, &account, false, false);
        assert!(told.contains("its rate: "), "{told}");
    }
}

const ORBIT: &str = r"
[derivation]
title = 'Orbit'
concerns = 'Any textbook'
[symbols]
't' = { role = 'time' }
'\mu' = { role = 'parameter', positive = true }
'L' = { role = 'parameter', positive = true }
'r' = { role = 'state' }
'p' = { role = 'state' }
'h' = { role = 'observable', formula = '\frac12p^2+\frac{L^2}{2r^2}-\frac{\mu}{r}' }
'a' = { role = 'observable', formula = '\frac{1}{\frac{2}{r}-\frac{p^2+L^2/r^2}{\mu}}' }
[system.orbit]
states = ['r', 'p']
equations = ['\dot r=p, \quad \dot p=\frac{L^2}{r^3}-\frac{\mu}{r^2}']
[[trajectory]]
id = 'one'
system = 'orbit'
parameters = { '\mu' = 1.2, 'L' = 1.1 }
initial = { 'r' = 1.0, 'p' = 0.1 }
span = [0, 5]
[[trajectory]]
id = 'two'
system = 'orbit'
parameters = { '\mu' = 0.8, 'L' = 0.7 }
initial = { 'r' = 1.1, 'p' = 0.2 }
span = [0, 5]
[[claim]]
id = 'vis-viva'
says = 'The energy of an orbit'
always = ['h=-\frac{a}{2\mu}']
";

#[test]
fn two_symbols_of_different_kinds_change_places() {
    assert_eq!(first(ORBIT), Some((r"h=-\frac{\mu}{2a}".to_owned(), Strength::Proved)));
    for correction in corrections(&checked(ORBIT, &[], &[])) {
        // What h is, is not said by h.
        let (_, right) = correction.formula.split_once('=').expect("an equation");
        assert!(!right.contains('h'), "{correction:?}");
    }
}

#[test]
fn a_term_that_vanishes_is_left_out() {
    let text = damped(r"always = ['v=\dot x+7(\gamma-\omega)']");
    for correction in corrections(&checked(&text, &[], &[])) {
        assert!(!correction.formula.contains(r"\omega-\omega") && !correction.formula.contains(r"\gamma-\gamma"));
    }
    assert_eq!(first(&text).map(|(formula, _)| formula).as_deref(), Some(r"v=\dot x"));
}

/// A body that runs away to infinity in a finite time.
const AWAY: &str = r"
[derivation]
title = 'Away'
concerns = 'Any textbook'
[symbols]
't' = { role = 'time' }
'x' = { role = 'state' }
'v' = { role = 'state' }
[system.away]
states = ['x', 'v']
equations = ['\dot x=v, \quad \dot v=x^3-\frac12v']
[[trajectory]]
id = 'one'
system = 'away'
initial = { 'x' = 1, 'v' = 1 }
span = [0, SPAN]
[[claim]]
id = 'law'
says = 'The law'
always = ['\ddot x=2x^3-\frac12\dot x']
";

#[test]
fn a_motion_that_runs_away_is_judged_where_it_is_known() {
    for span in ["1.1", "1.74"] {
        let found = first(&AWAY.replace("SPAN", span));
        assert_eq!(found, Some((r"\ddot x=x^3-\frac{1}{2}\dot x".to_owned(), Strength::Proved)), "{span}");
    }
}

#[test]
fn a_proved_factor_comes_before_another_symbol() {
    let comment = std::fs::read_to_string("derivations/deriglazov-comment.toml").expect("the file of the Comment");
    let on = ["unit-generic", "generic-generic", "racket-out"];
    let of = |printed: &str, wrong: &str| {
        let text = comment.replacen(printed, wrong, 1);
        assert_ne!(text, comment);
        corrections(&checked(&text, &["t3-energy"], &on)).first().map(|c| (c.formula.clone(), c.strength))
    };
    let found = of(r"'E=\frac12 I_i\Omega_i^2({\bf m})'", r"'E=I_i\Omega_i^2({\bf m})'");
    assert_eq!(found, Some((r"E=\frac{1}{2}I_i\Omega_i^2({\bf m})".to_owned(), Strength::Proved)));
    // The same slip in what E is defined to be.
    let found = of(r"formula = '\frac12 I_i\Omega_i^2'", r"formula = 'I_i\Omega_i^2'");
    assert_eq!(found, Some((r"E=I_i\Omega_i^2({\bf m})".to_owned(), Strength::Proved)));
}
