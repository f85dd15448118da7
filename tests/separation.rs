//! Which condition separates, on motions made for it: what is found, what must not be said.

use std::path::Path;

use rederive::check::separation::{ConditionsAccount, Join, Need};
use rederive::check::{Account, Options, Rigor, check};
use rederive::derivation::parse;
use rederive::diag::{Source, render};

const OSCILLATOR: &str = r"
[derivation]
title = 'A damped oscillator'
concerns = 'test'
[symbols]
't' = { role = 'time' }
'x' = { role = 'state' }
'v' = { role = 'state' }
'a' = { role = 'parameter' }
'b' = { role = 'parameter' }
'E' = { role = 'observable', formula = '\frac12v^2+\frac12x^2' }
[system.s]
states = ['x', 'v']
equations = ['\dot x=v', '\dot v=-x-av']
[[trajectory]]
id = 'free'
system = 's'
parameters = { 'a' = 0, 'b' = 1 }
initial = { 'x' = 1, 'v' = 0 }
span = [0, 5]
[[trajectory]]
id = 'free-fast'
system = 's'
parameters = { 'a' = 0, 'b' = 3 }
initial = { 'x' = 0.3, 'v' = 1.5 }
span = [0, 5]
[[trajectory]]
id = 'damped'
system = 's'
parameters = { 'a' = 0.2, 'b' = 1 }
initial = { 'x' = 1, 'v' = 0 }
span = [0, 5]
[[trajectory]]
id = 'driven'
system = 's'
parameters = { 'a' = -0.3, 'b' = 2 }
initial = { 'x' = 0.4, 'v' = 0.7 }
span = [0, 5]
";

fn account(more: &str) -> Account {
    checked(format!("{OSCILLATOR}{more}"))
}

fn checked(text: String) -> Account {
    let source = Source { path: "test.toml".into(), text };
    let derivation = parse(source, "test").unwrap_or_else(|found| panic!("{}", render(&found, false)));
    let claims = derivation.claims.len();
    let account = check(&derivation, &Options::default(), &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"));
    assert_eq!((derivation.claims.len(), account.claims.len()), (claims, claims), "nothing made on the way is left");
    account
}

fn conditions(more: &str) -> ConditionsAccount {
    account(more).claims.remove(0).conditions
}

/// The explanation as text.
fn explained(more: &str) -> Option<String> {
    let separation = conditions(more).separation.expect("the claim is split");
    separation.explanation.map(|e| {
        let name = |c: &rederive::check::separation::ConditionName| {
            let not = if c.negated { "not " } else { "" };
            format!("{not}{}", c.id.clone().unwrap_or_else(|| c.formula.clone()))
        };
        let parts: Vec<String> = e.conditions.iter().map(name).collect();
        parts.join(match e.join {
            Join::And => " and ",
            Join::Or => " or ",
        })
    })
}

const ENERGY: &str = "[[claim]]\nid = 'c'\nsays = 'c'\nalways = ['\\dot E=0']\n";

#[test]
fn the_condition_of_the_file_is_found() {
    let more = format!("{ENERGY}[[condition]]\nid = 'undamped'\nsays = 'no damping'\nholds = ['a=0']\n");
    assert_eq!(explained(&more).as_deref(), Some("undamped"));
}

#[test]
fn one_built_from_the_symbols_is_found() {
    // b never separates: it is 1, 3 where the energy is kept, and 1, 2 where it is not.
    assert_eq!(explained(ENERGY).as_deref(), Some("a=0"));
}

#[test]
fn the_opposite_of_a_condition_is_one() {
    let more = "[[claim]]\nid = 'c'\nsays = 'c'\nalways = ['|\\dot E|>\\frac{v^2}{10}']\nassuming = ['v\\ne 0']\n\
                [[condition]]\nid = 'undamped'\nsays = 'no damping'\nholds = ['a=0']\n";
    assert_eq!(explained(more).as_deref(), Some("not undamped"));
}

#[test]
fn the_weaker_of_two_is_named() {
    // Alike where the claim applies, but `wide` is met on `damped`, too, to which it does not apply.
    let more = "[[claim]]\nid = 'c'\nsays = 'c'\nassuming = ['a\\le 0']\nalways = ['\\dot E=0']\n\
                [[condition]]\nid = 'narrow'\nsays = 'n'\nholds = ['a=0']\n\
                [[condition]]\nid = 'wide'\nsays = 'w'\nholds = ['a\\ge 0']\n";
    let separation = conditions(more).separation.expect("split");
    assert_eq!(explained(more).as_deref(), Some("wide"));
    let narrow = separation.rivals.iter().find(|r| r.explanation.conditions[0].id.as_deref() == Some("narrow"));
    assert_eq!(narrow.expect("a rival").differ_on, ["damped"]);
}

#[test]
fn two_conditions_together() {
    let more = "[[claim]]\nid = 'c'\nsays = 'c'\nalways = ['x^2+v^2=1', 'b=1']\n\
                [[condition]]\nid = 'undamped'\nsays = 'no damping'\nholds = ['a=0']\n\
                [[condition]]\nid = 'at-one'\nsays = 'starts at 1'\nholds = ['x(0)=1']\n";
    assert_eq!(explained(more).as_deref(), Some("undamped and at-one"));
    let more = "[[claim]]\nid = 'c'\nsays = 'c'\nalways = ['a(x(0)-1)=0']\n\
                [[condition]]\nid = 'undamped'\nsays = 'no damping'\nholds = ['a=0']\n\
                [[condition]]\nid = 'at-one'\nsays = 'starts at 1'\nholds = ['x(0)=1']\n";
    assert_eq!(explained(more).as_deref(), Some("undamped or at-one"));
}

#[test]
fn an_undecided_condition_explains_nothing() {
    // It would be met exactly where the claim holds, but has no value at x = 0, which free motions reach.
    let more = "[[claim]]\nid = 'c'\nsays = 'c'\nalways = ['\\dot E=0']\n\
                [[condition]]\nid = 'void'\nsays = 'has no value'\nholds = ['a\\sqrt{x}=0']\n";
    let separation = conditions(more).separation.expect("split");
    let named = separation.explanation.iter().chain(separation.rivals.iter().map(|r| &r.explanation));
    assert!(named.flat_map(|e| &e.conditions).all(|c| c.id.as_deref() != Some("void")));
    assert!(separation.undecided > 0);
}

#[test]
fn a_claim_is_not_its_own_reason() {
    // In other words, the condition says what the claim says.
    let more = "[[claim]]\nid = 'c'\nsays = 'c'\nalways = ['a=0']\n\
                [[condition]]\nid = 'same'\nsays = 'the same'\nholds = ['{a}=0']\n";
    // Nothing else is asked, either: where it holds is what it says.
    assert_eq!(conditions(more).separation, None);
}

#[test]
fn what_nothing_separates_is_said_to_be_so() {
    // Only a third motion shows that no condition of the file is right; none is built from matrices.
    let more = "[[claim]]\nid = 'c'\nsays = 'c'\nalways = ['(x(0)-1)(x(0)-\\frac{4}{10})(a-\\frac{3}{10})=0']\n\
                trajectories = ['free', 'free-fast', 'driven']\n";
    let separation = conditions(more).separation.expect("split");
    if separation.explanation.is_none() {
        assert!(!separation.sufficient.is_empty() || !separation.necessary.is_empty());
    }
    assert_eq!((separation.holds.len(), separation.fails.len()), (2, 1));
}

#[test]
fn assumptions_are_weighed() {
    let needs = |assuming: &str, always: &str| -> Vec<(String, Need)> {
        let more = format!("[[claim]]\nid = 'c'\nsays = 'c'\nassuming = [{assuming}]\nalways = ['{always}']\n");
        conditions(&more).assumptions.into_iter().map(|a| (a.text, a.need)).collect()
    };
    let words = |found: Vec<(String, Need)>| found.into_iter().map(|(_, n)| n.word()).collect::<Vec<_>>();
    assert_eq!(words(needs("'a=0'", r"\dot E=0")), ["needed"]);
    // b = 1 leaves out `free-fast`, where the energy is kept all the same.
    assert_eq!(words(needs("'a=0', 'b=1'", r"\dot E=0")), ["needed", "not-needed"]);
    // Every motion meets it.
    assert_eq!(words(needs("'a=0', 'b>0'", r"\dot E=0")), ["needed", "untested"]);
    // The other way: what holds without it is not needed.
    assert_eq!(words(needs("'a=0'", r"\dot x=v")), ["not-needed"]);
    // An inequality that leaves out only some times.
    assert_eq!(words(needs("'x>0'", r"\left|x\right|=x")), ["needed"]);
    assert_eq!(words(needs("'x>0'", r"\dot x=v")), ["not-needed"]);
    // One that holds throughout, exactly, hides nothing of the other.
    assert_eq!(words(needs("'x>0', 'b>0'", r"\left|x\right|=x")), ["needed", "untested"]);
}

#[test]
fn a_condition_is_met_where_every_part_has_a_value() {
    // On the second motion the root has no value before t = 1.
    let text = r"
[derivation]
title = 't'
concerns = 't'
[symbols]
't' = { role = 'time' }
'x' = { role = 'state' }
'k' = { role = 'parameter' }
[[trajectory]]
id = 'up'
parameters = { 'k' = 1 }
formula = { 'x' = '1+\frac{t}{2}' }
span = [0, 2]
[[trajectory]]
id = 'through'
parameters = { 'k' = 2 }
formula = { 'x' = 't-1' }
span = [0, 2]
[[trajectory]]
id = 'down'
parameters = { 'k' = -1 }
formula = { 'x' = '1+t' }
span = [0, 2]
[[condition]]
id = 'two'
says = 'two'
holds = ['\sqrt{x}>-1', 'k>0']
[[claim]]
id = 'c'
says = 'c'
always = ['k^3>-\frac12']
";
    let account = checked(text.to_owned());
    let separation = account.claims[0].conditions.separation.as_ref().expect("split");
    let named = separation.explanation.iter().chain(separation.rivals.iter().map(|r| &r.explanation));
    assert!(named.flat_map(|e| &e.conditions).all(|c| c.id.as_deref() != Some("two")), "{separation:?}");
}

#[test]
fn what_is_shown_of_a_claim_that_holds_is_of_what_it_says() {
    let more = "[[claim]]\nid = 'c'\nsays = 'c'\nassuming = ['x>0', 'b>0']\nalways = ['\\sqrt{x^2}=x']\n\
                trajectories = ['free']\n";
    let account = account(more);
    let evidence = account.claims[0].results[0].verdict.evidence();
    // That b is 1 and not 0 is no residual of the claim, and does not hide where x > 0 is not so.
    assert!(evidence.residual.as_ref().expect("there").max < 1e-9, "{evidence:?}");
    assert!(!evidence.excluded.is_empty(), "{evidence:?}");
}

#[test]
fn a_claim_that_fails_where_it_applies_says_nothing_of_its_assumptions() {
    let more = "[[claim]]\nid = 'c'\nsays = 'c'\nassuming = ['b=1']\nalways = ['a=0']\n";
    assert!(conditions(more).assumptions.is_empty());
}

#[test]
fn the_comment_leaves_unsaid() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("derivations/deriglazov-comment.toml");
    let text = std::fs::read_to_string(path).expect("the file is there");
    let derivation = parse(Source { path: "comment.toml".into(), text }, "comment").expect("read");
    let claims = ["psi0-formula", "k-nonzero", "t8", "t8-outside"].map(str::to_owned).to_vec();
    let options = Options { claims, ..Options::default() };
    let account = check(&derivation, &options, &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"));
    let explained = |id: &str, reading: Option<&str>| {
        let claim = account.claims.iter().find(|c| c.id == id && c.reading.as_deref() == reading).expect("there");
        let explanation = claim.conditions.separation.as_ref().and_then(|s| s.explanation.clone()).expect("explained");
        explanation.conditions.iter().filter_map(|c| c.id.clone()).collect::<Vec<_>>().join("+")
    };
    // Which moments make ψ0 real is not in the paper. Where k is 0 to rounding, samples leave open whether it is 0.
    assert_eq!(explained("psi0-formula", Some("real")), "third-between");
    let nonzero = account.claims.iter().find(|c| c.id == "k-nonzero" && c.reading.as_deref() == Some("as-printed"));
    assert!(nonzero.expect("there").conditions.separation.is_none());
    assert_eq!(explained("t8", Some("as-printed")), "unit-start");
    // A motion only touches the axis, which numbers cannot tell from a near miss; of another they leave the verdict open.
    let touching = account.claims.iter().find(|c| c.reading.as_deref() == Some("angles-exist")).expect("there");
    let possible = touching.conditions.separation.as_ref().map(|s| s.possible.clone()).unwrap_or_default();
    let first = possible.first().and_then(|(c, on)| c.id.clone().map(|id| (id, on.clone())));
    assert_eq!(first, Some(("axis-off-z".to_owned(), vec!["commuting-start".to_owned()])));
}

#[test]
fn what_separates_is_asked_of_final_verdicts() {
    // k and j of the first motion are nearer to one another than binary64 tells: only an enclosure tells them apart.
    let motion = |id: &str, k: &str, j: &str, x: &str| {
        format!(
            "[[trajectory]]\nid = '{id}'\nsystem = 's'\nparameters = {{ 'k' = {k}, 'j' = {j} }}\ninitial = {{ 'x' = {x} }}\n\
             span = [0, 1]\n"
        )
    };
    let text = format!(
        "{}{}{}{}{}",
        r"
[derivation]
title = 'near'
concerns = 'test'
[symbols]
't' = { role = 'time' }
'k' = { role = 'parameter' }
'j' = { role = 'parameter' }
'x' = { role = 'state' }
[system.s]
states = ['x']
equations = ['\dot x=0']
",
        motion("near", "1", "1.00000000000000001", "3"),
        motion("equal", "2", "2", "3"),
        motion("apart", "2", "1", "-1"),
        r"
[[condition]]
id = 'alike'
says = 'k and j are equal'
holds = ['j=k']
[[claim]]
id = 'same'
says = 'equal'
always = ['k=j']
[[claim]]
id = 'cubes'
says = 'cubes'
always = ['k^3=j^3']
[[claim]]
id = 'twice'
says = 'no correction holds on both'
always = ['k=2j']
trajectories = ['near', 'equal']
",
    );
    let source = Source { path: "test.toml".into(), text };
    let derivation = parse(source, "test").unwrap_or_else(|found| panic!("{}", render(&found, false)));
    let of = |rigor: Rigor| {
        let options = Options { rigor, ..Options::default() };
        let account = check(&derivation, &options, &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"));
        let separation = account.claims[1].conditions.separation.clone();
        let failing = separation.as_ref().map(|s| s.fails.clone()).unwrap_or_default();
        let explained = separation.and_then(|s| Some(s.explanation?.conditions.first()?.formula.clone()));
        let erratum = account.claims[2].variants.clone().and_then(|v| v.erratum);
        let offered = erratum.map_or_else(Vec::new, |e| e.corrections.iter().map(|c| c.formula.clone()).collect());
        (failing, explained, offered)
    };
    let (failing, explained, offered): (Vec<String>, Option<String>, Vec<String>) = of(Rigor::Enclosed);
    assert_eq!(failing, ["near", "apart"]);
    // On `near` cubes fail, and k = j fails: what samples say of either would make x > 0 a condition, and k = j a correction.
    assert_eq!(explained.as_deref(), Some("j=k"));
    assert!(offered.iter().all(|formula| formula != "k=j"), "{offered:?}");
}
