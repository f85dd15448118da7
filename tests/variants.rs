//! Variants of claims: what the evidence is worth, and what a wrong formula should have been.

use rederive::check::{Account, ClaimAccount, Correction, Options, check};
use rederive::derivation::{Derivation, parse};
use rederive::diag::{Source, render};

fn derivation(text: &str) -> Derivation {
    let source = Source { path: "derivations/altered.toml".into(), text: text.into() };
    parse(source, "altered").unwrap_or_else(|e| panic!("{}", render(&e, false)))
}

fn checked(text: &str, claims: &[&str], trajectories: &[&str]) -> Account {
    let list = |l: &[&str]| l.iter().map(|s| (*s).to_owned()).collect();
    let options = Options { claims: list(claims), trajectories: list(trajectories), ..Options::default() };
    check(&derivation(text), &options, &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"))
}

fn comment() -> String {
    std::fs::read_to_string("derivations/deriglazov-comment.toml").expect("the file of the Comment")
}

fn corrections(claim: &ClaimAccount) -> &[Correction] {
    let erratum = claim.variants.as_ref().and_then(|v| v.erratum.as_ref());
    erratum.map_or(&[], |e| e.corrections.as_slice())
}

/// The first correction of the only claim checked, after one formula was altered.
fn first_correction(claim: &str, printed: &str, wrong: &str, trajectories: &[&str]) -> Option<Correction> {
    let text = comment();
    let at = text.find(&format!("id = \"{claim}\"")).expect("the claim");
    let from = at + text[at..].find(&format!("['{printed}'")).expect("the formula");
    let mut altered = text.clone();
    altered.replace_range(from..from + printed.len() + 3, &format!("['{wrong}'"));
    let account = checked(&altered, &[claim], trajectories);
    corrections(&account.claims[0]).first().cloned()
}

#[test]
fn a_wrong_sign_in_t9_is_corrected() {
    let printed =
        r"\dot\psi=-(\frac{m_3}{I_1}\sin^2\psi+\frac{m_3}{I_2}\cos^2\psi)\cos\theta+\frac{m_3}{I_3}\cos\theta";
    let wrong = r"\dot\psi=-(\frac{m_3}{I_1}\sin^2\psi-\frac{m_3}{I_2}\cos^2\psi)\cos\theta+\frac{m_3}{I_3}\cos\theta";
    let found = first_correction("t9-psi", printed, wrong, &["racket-out", "psi-rotating", "i3-largest", "t8-stable"]);
    let found = found.expect("a correction");
    assert_eq!(found.formula, printed);
    assert_eq!(found.holds_on, 3, "t8-stable is none of the motions to which it applies");
    assert!(found.difference.contains("[---]{+++}"), "{}", found.difference);
}

#[test]
fn a_wrong_index_in_t3_is_corrected() {
    let printed = r"\dot R_{ij}=-I_k^{-1}\epsilon_{jkp}(m_1R_{1k}+m_2R_{2k}+m_3R_{3k}) R_{ip}";
    let wrong = r"\dot R_{ij}=-I_k^{-1}\epsilon_{jkp}(m_1R_{1k}+m_2R_{3k}+m_3R_{3k}) R_{ip}";
    let found = first_correction("t3-attitude", printed, wrong, &["unit-generic", "generic-generic", "racket-out"]);
    let found = found.expect("a correction");
    assert_eq!(found.formula.replace(' ', ""), printed.replace(' ', ""));
    assert_eq!(found.holds_on, 3);
}

#[test]
fn a_wrong_factor_in_t15_is_corrected() {
    let printed = r"\cos\theta(t)=\frac{1-ce^{2kt}}{1+ce^{2kt}}";
    let wrong = r"\cos\theta(t)=\frac{1-ce^{2kt}}{1+ce^{kt}}";
    let found = first_correction("t15-theta", printed, wrong, &["t15-plus", "t15-minus", "t15-racket"]);
    assert_eq!(found.expect("a correction").formula, printed);
}

/// A small file: a body that is thrown, and one that lies still.
const THROWN: &str = r"
[derivation]
title = 'Thrown'
concerns = 'Any textbook'
[symbols]
't' = { role = 'time' }
'g' = { role = 'parameter', positive = true }
'z' = { role = 'state' }
'w' = { role = 'state' }
[system.fall]
states = ['z', 'w']
equations = ['\dot z=w, \quad \dot w=-g']
[system.rest]
states = ['z', 'w']
equations = ['\dot z=0, \quad \dot w=0']
[[trajectory]]
id = 'up'
system = 'fall'
parameters = { 'g' = 9.81 }
initial = { 'z' = 0.7, 'w' = 5.3 }
span = [0, 1]
[[trajectory]]
id = 'moon'
system = 'fall'
parameters = { 'g' = 1.62 }
initial = { 'z' = -0.4, 'w' = 3.1 }
span = [0, 2]
[[trajectory]]
id = 'still'
system = 'rest'
parameters = { 'g' = 9.81 }
initial = { 'z' = 0, 'w' = 0 }
span = [0, 1]
[[claim]]
id = 'speed'
says = 'The speed at each height'
always = ['FORMULA']
trajectories = TRAJECTORIES
";

fn thrown(formula: &str, trajectories: &str) -> Account {
    checked(&THROWN.replace("FORMULA", formula).replace("TRAJECTORIES", trajectories), &[], &[])
}

#[test]
fn a_motion_that_rests_rejects_nothing_and_one_that_moves_all() {
    let account = thrown(r"\dot z=w", "['up', 'still']");
    let claim = &account.claims[0];
    let of = |id: &str| {
        let pair = claim.results.iter().find(|p| p.trajectory == id).expect("the pair");
        pair.discrimination.clone().expect("it was tried")
    };
    let (up, still) = (of("up"), of("still"));
    assert_eq!(up.rejected, up.of, "{claim:#?}");
    assert!(up.of >= 4 && !up.is_weak());
    // An inverse has no value where everything is 0; nothing else is noticed.
    assert_eq!(still.rejected, 2, "{claim:#?}");
    assert!(still.is_weak());
    let variants = claim.variants.as_ref().expect("variants");
    assert_eq!(variants.cover, ["up"]);
    assert!(variants.cover_is_least);
    assert!(account.discriminating_less_than(1.0).is_empty());
    let weak = thrown(r"\dot z=w", "['still']");
    assert_eq!(weak.discriminating_less_than(0.5).len(), 1);
}

#[test]
fn every_edit_is_counted_once() {
    let account = thrown(r"w^2=w(0)^2-2g(z-z(0))", "['up', 'moon']");
    for claim in &account.claims {
        let variants = claim.variants.as_ref().expect("variants");
        for c in &variants.classes {
            assert_eq!(c.generated, c.meaningless + c.repeated + c.equivalent + c.empty + c.kept, "{c:?}");
        }
        assert!(variants.kept() >= 10, "{variants:#?}");
        // None of the survivors is the print in another form.
        assert_eq!(variants.together(), Some((variants.kept(), variants.kept())), "{variants:#?}");
    }
}

#[test]
fn what_is_the_same_equation_is_no_variant() {
    // 2·0 = 0, −x = 0 and (x)² say what x = 0 says; the others do not.
    let account = thrown(r"\dot z-w=0", "['up']");
    let variants = account.claims[0].variants.as_ref().expect("variants");
    assert!(variants.classes.iter().map(|c| c.equivalent + c.repeated).sum::<usize>() > 0, "{variants:#?}");
    assert_eq!(variants.together().map(|(r, of)| of - r), Some(0), "{variants:#?}");
}

#[test]
fn a_missing_term_is_found_and_nothing_is_made_up() {
    let first = |formula: &str| {
        let account = thrown(formula, "['up', 'moon']");
        let claim = account.claims[0].clone();
        (corrections(&claim).first().map(|c| c.formula.clone()), claim.variants.and_then(|v| v.erratum))
    };
    // A term left out, a factor too many, two slips at once.
    assert_eq!(first(r"w^2=w(0)^2-2gz").0.as_deref(), Some(r"w^2=w(0)^2-2gz+2gz(0)"));
    assert_eq!(first(r"w=w(0)-2gt").0.as_deref(), Some(r"w=w(0)-gt"));
    assert_eq!(first(r"z=z(0)-w(0)t-gt^2").0.as_deref(), Some(r"z=z(0)+w(0)t-\frac{1}{2}gt^2"));
    // Far from anything true.
    let (none, erratum) = first(r"\sin w=e^{z}\cos t+w");
    assert_eq!(none, None);
    let erratum = erratum.expect("it was looked for");
    assert!(erratum.tried.0 > 0 && erratum.tried.2 > 0 && erratum.remark.is_some(), "{erratum:?}");
}

#[test]
fn a_formula_that_says_nothing_is_no_correction() {
    let account = thrown(r"z+w=z-w", "['up', 'moon']");
    for correction in corrections(&account.claims[0]) {
        let (left, right) = correction.formula.split_once('=').expect("an equation");
        assert_ne!(left, right, "{correction:?}");
        assert_ne!(left.trim_start_matches('-'), right.trim_start_matches('-'), "{correction:?}");
    }
}

#[test]
fn a_claim_that_holds_needs_no_correction() {
    let account = thrown(r"w=w(0)-gt", "['up', 'moon']");
    assert!(account.claims[0].variants.as_ref().is_some_and(|v| v.erratum.is_none()));
}

#[test]
fn what_was_made_to_be_constant_is_no_correction() {
    // z − z does not change, and says nothing.
    let text =
        THROWN.replace("always = ['FORMULA']", "first-integral = ['z']").replace("TRAJECTORIES", "['up', 'moon']");
    let account = checked(&text, &[], &[]);
    for correction in corrections(&account.claims[0]) {
        assert!(correction.formula.contains('w'), "{correction:?}");
    }
}

#[test]
fn a_parameter_that_the_formula_does_not_have_is_found() {
    let account = thrown(r"w=w(0)-t", "['up', 'moon']");
    assert_eq!(corrections(&account.claims[0]).first().map(|c| c.formula.as_str()), Some("w=w(0)-gt"));
}

#[test]
fn what_is_the_same_given_the_assumptions_is_no_variant() {
    let kept = |assuming: &str| {
        let text = THROWN.replace("FORMULA", "w=w(0)-gt").replace("TRAJECTORIES", "['up', 'moon']");
        let text = text.replace("always =", &format!("assuming = [{assuming}]\nalways ="));
        let account = checked(&text, &[], &[]);
        account.claims[0].variants.as_ref().expect("variants").kept()
    };
    let free = kept("");
    // With z(0) = w(0) one may stand for the other; with z(0) = 2w(0), z(0) may not, and an inequality says nothing.
    assert!(kept("'z(0)=w(0)'") < free);
    assert_eq!(kept("'z(0)>w(0)'"), free);
    // There it is 2w(0) for which z(0) stands: two variants say the same.
    assert_eq!(kept("'z(0)=2w(0)'"), free - 1);
}

#[test]
fn a_power_of_an_equation_and_what_another_formula_says_are_no_variants() {
    let survivors = |formulas: &str| {
        let text = THROWN.replace("['FORMULA']", formulas).replace("TRAJECTORIES", "['still']");
        let account = checked(&text, &[], &[]);
        let variants = account.claims[0].variants.clone().expect("variants");
        variants.survivors.iter().map(|s| s.formula.clone()).collect::<Vec<_>>()
    };
    let one = survivors("['z=0']");
    assert!(one.contains(&"w=0".to_owned()), "{one:?}");
    assert!(!one.iter().any(|f| f.contains("z^2") || f.contains("z^{2}")), "{one:?}");
    let two = survivors("['z=0', 'w=0']");
    assert!(!two.contains(&"w=0".to_owned()) && !two.contains(&"z=0".to_owned()), "{two:?}");
}

#[test]
fn a_formula_without_a_value_is_corrected() {
    // √(−…) has no value on either motion, and is stated to hold.
    let text = THROWN.replace("FORMULA", r"w=\sqrt{-w^2}").replace("TRAJECTORIES", "['quick']");
    let text = text.replace("id = 'up'", "id = 'quick'").replace("span = [0, 1]", "span = [0, 0.5]");
    let account = checked(&format!("{text}expect = 'holds'\n"), &[], &[]);
    let found: Vec<&str> = corrections(&account.claims[0]).iter().map(|c| c.formula.as_str()).collect();
    assert!(found.contains(&r"w=\sqrt{w^2}"), "{:#?}", account.claims[0].variants);
}

#[test]
fn what_one_motion_alone_could_have_decided() {
    let account = thrown(r"w=w(0)-gt", "['up', 'still']");
    let alone = account.alone();
    assert_eq!(alone.iter().map(|a| a.trajectory.as_str()).collect::<Vec<_>>(), ["up", "moon", "still"]);
    // It fails where nothing falls: who looks at the thrown body alone does not learn that.
    assert_eq!((alone[0].holds, alone[0].misleading.as_slice()), (1, &["speed".to_owned()][..]));
    assert_eq!((alone[2].holds, alone[2].of), (0, 0));
    let account = thrown(r"\dot z=w", "['up', 'still']");
    let poorest = account.poor().into_iter().next().expect("a motion");
    assert_eq!((poorest.trajectory.as_str(), poorest.rejected), ("still", 2));
    assert!(poorest.to_string().contains("would have held as well"), "{poorest}");
}

/// The first correction that the program offers on the command line for a copy of the Comment's file with one formula altered.
fn offered(claim: &str, printed: &str, wrong: &str, trajectories: &[&str]) -> Option<String> {
    let text = comment();
    let at = text.find(&format!("id = \"{claim}\"")).expect("the claim");
    let from = at + text[at..].find(&format!("['{printed}'")).expect("the formula");
    let mut altered = text.clone();
    altered.replace_range(from..from + printed.len() + 3, &format!("['{wrong}'"));
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("copy.toml");
    std::fs::write(&path, altered).expect("written");
    let mut command = assert_cmd::Command::cargo_bin("rederive").expect("built");
    command.args(["check", "--no-reports", "--format", "json", "--claim", claim]).arg(&path);
    for trajectory in trajectories {
        command.args(["--trajectory", trajectory]);
    }
    let run = command.assert().code(1);
    let report: serde_json::Value = serde_json::from_slice(&run.get_output().stdout).expect("a report");
    let report = if report.is_array() { report[0].clone() } else { report };
    let first = &report["claims"][0]["variants"]["erratum"]["corrections"][0]["formula"];
    first.as_str().map(str::to_owned)
}

/// Whether what is offered is what was printed.
fn restores(claim: &str, printed: &str, wrong: &str, trajectories: &[&str]) {
    let found =
        offered(claim, printed, wrong, trajectories).unwrap_or_else(|| panic!("nothing is offered for {wrong}"));
    let file = derivation(&comment());
    let position = file.claims.iter().position(|c| c.id == claim).expect("the claim");
    let constant = claim == "t15-integral";
    let same = rederive::check::says_the_same(&file, position, printed, &found, constant);
    assert_eq!(same, Some(rederive::check::Sameness::Defined), "{wrong}\n{found}");
}

#[test]
fn one_sign_in_t9() {
    let on = ["racket-out", "psi-rotating", "i3-largest"];
    let theta = r"\dot\theta=m_3 I_{(1-2)}\sin\theta\sin\psi\cos\psi";
    restores("t9-theta", theta, r"\dot\theta=-m_3 I_{(1-2)}\sin\theta\sin\psi\cos\psi", &on);
    let phi = r"\dot\varphi=\frac{m_3}{I_1}\sin^2\psi+\frac{m_3}{I_2}\cos^2\psi";
    restores("t9-phi", phi, r"\dot\varphi=\frac{m_3}{I_1}\sin^2\psi-\frac{m_3}{I_2}\cos^2\psi", &on);
    restores("t9-phi", phi, r"\dot\varphi=-\frac{m_3}{I_1}\sin^2\psi+\frac{m_3}{I_2}\cos^2\psi", &on);
    let psi = r"\dot\psi=-(\frac{m_3}{I_1}\sin^2\psi+\frac{m_3}{I_2}\cos^2\psi)\cos\theta+\frac{m_3}{I_3}\cos\theta";
    let signs = [
        r"\dot\psi=(\frac{m_3}{I_1}\sin^2\psi+\frac{m_3}{I_2}\cos^2\psi)\cos\theta+\frac{m_3}{I_3}\cos\theta",
        r"\dot\psi=-(\frac{m_3}{I_1}\sin^2\psi-\frac{m_3}{I_2}\cos^2\psi)\cos\theta+\frac{m_3}{I_3}\cos\theta",
        r"\dot\psi=-(\frac{m_3}{I_1}\sin^2\psi+\frac{m_3}{I_2}\cos^2\psi)\cos\theta-\frac{m_3}{I_3}\cos\theta",
    ];
    signs.iter().for_each(|wrong| restores("t9-psi", psi, wrong, &on));
}

#[test]
fn one_index_in_t3() {
    let on = ["unit-generic", "generic-generic", "racket-out"];
    let printed = r"\dot R_{ij}=-I_k^{-1}\epsilon_{jkp}(m_1R_{1k}+m_2R_{2k}+m_3R_{3k}) R_{ip}";
    let indices = [
        r"\dot R_{ij}=-I_k^{-1}\epsilon_{jkp}(m_1R_{1k}+m_1R_{2k}+m_3R_{3k}) R_{ip}",
        r"\dot R_{ij}=-I_k^{-1}\epsilon_{jkp}(m_1R_{k1}+m_2R_{2k}+m_3R_{3k}) R_{ip}",
        r"\dot R_{ij}=-I_k^{-1}\epsilon_{jkp}(m_1R_{1k}+m_2R_{2k}+m_3R_{2k}) R_{ip}",
        r"\dot R_{ij}=-I_k^{-1}\epsilon_{jkp}(m_1R_{1k}+m_2R_{2k}+m_3R_{3k}) R_{pi}",
        r"\dot R_{ij}=-I_p^{-1}\epsilon_{jkp}(m_1R_{1k}+m_2R_{2k}+m_3R_{3k}) R_{ip}",
    ];
    indices.iter().for_each(|wrong| restores("t3-attitude", printed, wrong, &on));
}

#[test]
fn one_factor_in_t15() {
    let on = ["t15-plus", "t15-minus", "t15-racket"];
    let theta = r"\cos\theta(t)=\frac{1-ce^{2kt}}{1+ce^{2kt}}";
    restores("t15-theta", theta, r"\cos\theta(t)=\frac{1-ce^{kt}}{1+ce^{2kt}}", &on);
    restores("t15-theta", theta, r"\cos\theta(t)=\frac{1-ce^{2kt}}{1+2ce^{2kt}}", &on);
    let phi = r"\varphi=\frac{m_3}{I_3}t+\varphi_0";
    restores("t15-phi", phi, r"\varphi=\frac{2m_3}{I_3}t+\varphi_0", &on);
    restores("t15-phi", phi, r"\varphi=\frac{m_3}{I_3}t+\frac12\varphi_0", &on);
    restores("t15-psi", r"\psi=\psi_0", r"\psi=2\psi_0", &on);
}
