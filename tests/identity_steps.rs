//! Steps of a derivation, from the file to the verdict for all values.

use crate::checked::said_by_prover;
use rederive::check::{Account, IdentityAccount, Options, check};
use rederive::derivation::load;
use rederive::diag::render;
use rederive::reason::{Bounded, Proviso};
use std::path::Path;

fn account(path: &Path, trajectories: &[&str]) -> Account {
    let derivation = load(path).unwrap_or_else(|found| panic!("{}", render(&found, false)));
    let trajectories = trajectories.iter().map(|&t| t.to_owned()).collect();
    let options = Options { trajectories, ..Options::default() };
    check(&derivation, &options, &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"))
}

/// A derivation about a point on the line, with these claims.
fn with_claims(name: &str, claims: &str) -> Account {
    let head = r#"
[derivation]
title = "Steps"
concerns = "nothing"
[symbols]
't' = { role = "time" }
'a' = { role = "parameter", positive = true }
'b' = { role = "parameter", positive = true }
'x' = { role = "state" }
'v' = { role = "state" }
'f' = { role = "observable", formula = 'x^2+v^2' }
'g' = { role = "observable", formula = 'x-v' }
[system.swing]
states = ['x', 'v']
equations = ['\dot x=v', '\dot v=-x']
[[trajectory]]
id = "one"
system = "swing"
parameters = { 'a' = 2, 'b' = 3 }
initial = { 'x' = 1, 'v' = 0.5 }
span = [0, 3]
"#;
    let folder = std::env::temp_dir().join(format!("rederive-steps-{}-{name}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a temporary folder");
    let path = folder.join("steps.toml");
    std::fs::write(&path, format!("{head}{claims}")).expect("a temporary file");
    let found = account(&path, &[]);
    std::fs::remove_dir_all(&folder).expect("a temporary folder");
    found
}

fn identity<'a>(account: &'a Account, id: &str) -> &'a IdentityAccount {
    let claim = account.claims.iter().find(|c| c.id == id).unwrap_or_else(|| panic!("no claim {id}"));
    claim.identity.as_ref().unwrap_or_else(|| panic!("{id} has no identity"))
}

fn verdict(account: &Account, id: &str) -> &'static str {
    identity(account, id).verdict()
}

/// What is given says nothing where it has no value: the proof is one for x ≥ 0, and the motion, which goes on, refutes the claim.
#[test]
fn beyond_the_domain_of_what_is_given() {
    let found = with_claims(
        "beyond",
        r#"
[[claim]]
id = "root"
says = "it says nothing where x is negative"
always = ['(\sqrt x)^2=x']
[[claim]]
id = "size"
says = "what follows for x that is not negative"
follows-from = ["root"]
always = ['\sqrt{x^2}=x']
"#,
    );
    assert_eq!(
        (verdict(&found, "size"), &identity(&found, "size").conditions[..]),
        ("proved", &[Proviso::Where { formula: "x".into(), is: Bounded::NotNegative }][..])
    );
    let on = |id: &str| found.claims.iter().find(|c| c.id == id).map(|c| c.results[0].verdict.outcome().word());
    assert_eq!((on("root"), on("size")), (Some("holds"), Some("fails")));
}

#[test]
fn premises_and_definitions() {
    let found = with_claims(
        "premises",
        r#"
[[claim]]
id = "conserved"
says = "f does not change"
first-integral = ['f']
[[claim]]
id = "value"
says = "f is what it is at the start"
always = ['x^2+v^2=f(0)']
follows-from = ["conserved"]
[[claim]]
id = "definition-does-not-matter"
says = "what is said of g alone"
assuming = ['g=a']
always = ['g^2=a^2']
follows-from = ["value"]
[[claim]]
id = "uses-one"
says = "one of two assumptions is used"
assuming = ['g=a', 'x=b']
always = ['v=b-a']
follows-from = ["value"]
[[claim]]
id = "contradiction"
says = "premises that cannot hold together"
assuming = ['x=a', 'x=-b']
always = ['v=1']
follows-from = ["value"]
[[claim]]
id = "open"
says = "what the premises leave open"
always = ['v=a']
follows-from = ["definition-does-not-matter"]
[[claim]]
id = "between-times"
says = "the solution of the differential equation"
always = ['x=x(0)\cos t+v(0)\sin t']
[[claim]]
id = "other-times"
says = "no solution of it"
always = ['x=x(0)\cos t-v(0)\sin t']
trajectories = []
follows-from = ["swing"]
[[claim]]
id = "by-rate"
says = "the same at the start and the same rate"
always = ['x=x(0)+at']
assuming = ['v=a']
follows-from = ["swing"]
[[claim]]
id = "by-rate-alone"
says = "the same rate, and another value at the start"
always = ['x=2x(0)+at']
assuming = ['v=a']
follows-from = ["swing"]
"#,
    );
    for id in ["conserved", "value", "definition-does-not-matter", "uses-one", "between-times"] {
        assert_eq!(verdict(&found, id), "proved", "{id}: {:?}", identity(&found, id));
    }
    let used = identity(&found, "uses-one").assumptions.clone().expect("it has assumptions");
    assert!(used.unused.is_empty() && !used.used.is_empty(), "{used:?}");
    let contradiction = identity(&found, "contradiction");
    assert_eq!(contradiction.verdict(), "undecided");
    assert!(contradiction.reason.as_ref().is_some_and(|r| r.to_string().contains("contradict")), "{contradiction:?}");
    let open = identity(&found, "open");
    assert_eq!(open.verdict(), "refuted", "{open:?}");
    let between = identity(&found, "other-times");
    assert!(between.reason.as_ref().is_some_and(|r| r.to_string().contains("different times")), "{between:?}");
    assert_ne!(verdict(&found, "by-rate-alone"), "proved");
}

#[test]
fn products_along_a_motion() {
    let found = with_claims(
        "products",
        r#"
[[claim]]
id = "one-factor-vanishes"
says = "x is one of two constants throughout"
assuming = ['(x-a)(x-b)=0']
always = ['x=x(0)']
follows-from = ["g"]
[[claim]]
id = "needs-both"
says = "a factor that can vanish leaves the other free"
assuming = ['(x-a)(v-b)=0']
always = ['x=x(0)']
follows-from = ["g"]
"#,
    );
    assert_eq!(verdict(&found, "one-factor-vanishes"), "proved", "{:?}", identity(&found, "one-factor-vanishes"));
    assert_ne!(verdict(&found, "needs-both"), "proved");
}

#[test]
fn claims_that_are_no_premises_for_all_times() {
    let found = with_claims(
        "events",
        r#"
[[claim]]
id = "at-an-event"
says = "only where v vanishes"
at = 'v=0'
always = ['f=x^2']
[[claim]]
id = "from-an-event"
says = "the event's equation at all times"
always = ['v^2=0']
follows-from = ["at-an-event"]
[[claim]]
id = "either-sign"
says = "with one of the signs"
always = ['x=\pm\sqrt{f-v^2}']
branches = "pointwise"
[[claim]]
id = "from-either-sign"
says = "squared it holds"
always = ['x^2=f-v^2']
follows-from = ["either-sign"]
[[claim]]
id = "plus-from-either-sign"
says = "the sign is not always plus"
always = ['x=\sqrt{f-v^2}']
follows-from = ["either-sign"]
[[claim]]
id = "order"
says = "a − b has one sign in the order b < a"
assuming = ['a>b']
always = ['a^2>ab']
[[claim]]
id = "no-order"
says = "and in no other"
always = ['a^2>ab']
"#,
    );
    assert_ne!(verdict(&found, "from-an-event"), "proved");
    assert_eq!(verdict(&found, "from-either-sign"), "proved");
    assert_ne!(verdict(&found, "plus-from-either-sign"), "proved");
    assert_eq!(verdict(&found, "order"), "proved");
    let not = identity(&found, "no-order");
    assert_eq!(not.verdict(), "refuted", "{not:?}");
    assert!(not.conditions[0].to_string().contains("exactly when b < a"), "{not:?}");
}

/// Values at a fixed time that premises name: present values must belong to the same motion.
#[test]
fn values_at_fixed_times_in_premises() {
    let found = with_claims(
        "fixed-times",
        r#"
[[claim]]
id = "stays"
says = "x does not move, and is 1 at the start"
assuming = ['x(0)=1', 'v=0']
always = ['x=1']
follows-from = ["swing"]
[[claim]]
id = "circle"
says = "the circle on which it starts"
assuming = ['x(0)=a', 'v(0)=0']
always = ['x^2+v^2=a^2']
follows-from = ["swing"]
[[claim]]
id = "side"
says = "it does not leap to the other side"
assuming = ['x(0)=a', 'x^2=a^2']
always = ['x=a']
follows-from = ["g"]
[[claim]]
id = "solution"
says = "true by the solution: one motion goes through each state"
assuming = ['x(0)=a', 'v(0)=0']
always = ['x=a\cos t']
follows-from = ["swing"]
[[claim]]
id = "bound-to-start"
says = "true of the motion through this state"
assuming = ['x(0)=0', 'v(0)=0']
always = ['x=0']
follows-from = ["swing"]
[[claim]]
id = "false-at-the-start"
says = "wrong already at the start"
assuming = ['x(0)=a']
always = ['x=2a']
follows-from = ["swing"]
"#,
    );
    for id in ["circle", "side", "solution", "bound-to-start"] {
        assert_eq!(verdict(&found, id), "proved", "{id}: {:?}", identity(&found, id));
    }
    // There is no such motion: where v = 0 throughout, x = 0.
    assert_eq!(verdict(&found, "stays"), "undecided", "{:?}", identity(&found, "stays"));
    // What is wrong at the start is not refuted yet: that would need a motion through the refuting point.
    let id = "false-at-the-start";
    assert_eq!(verdict(&found, id), "undecided", "{:?}", identity(&found, id));
}

/// What is constant on either side of a singularity may be another constant there.
#[test]
fn constants_that_jump() {
    let found = with_claims(
        "jumps",
        r#"
[[claim]]
id = "arctan"
says = "the angle, but for steps of pi"
always = ['\arctan\frac{v}{x}=\arctan\frac{v(0)}{x(0)}-t']
follows-from = ["swing"]
trajectories = []
[[claim]]
id = "inverse"
says = "plus or minus a right angle"
first-integral = ['\arctan x+\arctan\frac{1}{x}']
trajectories = []
[[claim]]
id = "root"
says = "the sign of x"
first-integral = ['\frac{\sqrt{x^2}}{x}']
trajectories = []
[[claim]]
id = "sign"
says = "the sign of x, by another name"
symbols = { 's' = { role = "observable", formula = '\frac{|x|}{x}' } }
always = ['s=s(0)']
follows-from = ["s"]
trajectories = []
[[claim]]
id = "smooth"
says = "no branches"
always = ['x^2+v^2=x(0)^2+v(0)^2']
follows-from = ["swing"]
trajectories = []
"#,
    );
    for id in ["arctan", "inverse", "root", "sign"] {
        let found = identity(&found, id);
        assert!(found.verdict() != "proved" || found.generic, "{id}: {found:?}");
    }
    let smooth = identity(&found, "smooth");
    assert!(smooth.verdict() == "proved" && !smooth.generic, "{smooth:?}");
}

/// A case that a proof leaves out may be the one that an assumption excludes.
#[test]
fn assumptions_that_exclude_a_case_are_used() {
    let found = with_claims(
        "needed",
        r#"
[[claim]]
id = "needed"
says = "false for x = 1, v = 0"
assuming = ['\dot x^2+x^2=1', '\dot x\ne 0']
always = ['\ddot x=-x']
follows-from = ["g"]
trajectories = []
"#,
    );
    let used = identity(&found, "needed").assumptions.clone().expect("it has assumptions");
    assert!(used.unused.is_empty(), "{used:?}");
}

/// Steps of the Comment that must be proved, and claims that must not.
#[test]
fn the_comment() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("derivations/deriglazov-comment.toml");
    let found = account(&path, &["t8-upside-down", "racket-out", "unit-generic", "dzhanibekov-mz", "t8-turned"]);
    let name = |c: &rederive::check::ClaimAccount| match &c.reading {
        Some(reading) => format!("{}/{reading}", c.id),
        None => c.id.clone(),
    };
    let proved: Vec<String> = found
        .claims
        .iter()
        .filter(|c| c.identity.as_ref().is_some_and(|i| said_by_prover(i).starts_with("proved")))
        .map(name)
        .collect();
    for wanted in [
        "attitude-products",
        "orthogonality",
        "orientation",
        "energy",
        "momentum",
        "euler-from-momentum/with-the-attitude",
        "euler-from-momentum/equations",
        "omega-of-m",
        "t3-attitude",
        "t3-energy",
        "energy-relation/given-unit-start",
        "unit-start/rigid-without-it",
        "unit-start/turned-copy",
        "omega-chosen",
        "t7.1",
        "t8-solves",
        "not-reducible/after-the-turn",
        "body-axes-along-laboratory/turned-tensor",
        "tensor-after-turning/laboratory-and-body-axes",
        "t9-theta",
        "t9-phi",
        "t9-psi",
        "t7.1-from-t9",
        "t10",
        "t11/squared",
        "t11/either-sign",
        "t11/sign-rule",
        "t11/without-root",
        "letter-equation/same-right-side",
        "letter-equation/along-the-motion",
        "relation-in-t10/given-the-relation",
        "psi0-formula/where-psi-is-constant",
        "psi0-formula/real-when-between",
        "psi0-formula/real-only-when-between",
        "psi0-in-t11/for-any-energy",
        "psi0-in-t9",
        "reduced-theta/given-the-relation",
        "reduced-phi/given-the-relation",
        "t15-integral",
        "t15-theta",
        "t15-phi",
        "t15-psi",
        "t15-solves-t9",
        "k-nonzero/from-the-moments",
    ] {
        assert!(proved.iter().any(|p| p == wanted), "{wanted} is not proved");
    }
    for wrong in [
        "very-special-start/together",
        "t1-euler/other-sign",
        "start-is-a-rotation",
        "energy-relation/for-every-motion",
        "energy-relation/implies-unit-start",
        "chosen-momentum",
        "t8/as-printed",
        "t8/third-axis-along-z",
        "omega-rate/momentum-along-z",
        "t8-no-racket/momentum-along-z",
        "axes-at-the-start",
        "body-axes-along-laboratory/diagonal-tensor",
        "tensor-after-turning/laboratory-only",
        "t11/one-sign",
        "relation-in-t10/for-every-body",
        "psi-constant/for-every-body",
        "psi0-formula/real",
        "psi0-in-t11/it-is-a-motion",
        "reduced-theta/for-every-body",
        "reduced-phi/for-every-body",
    ] {
        assert!(!proved.iter().any(|p| p == wrong), "{wrong} is proved");
    }
    let real = found.claims.iter().find(|c| c.reading.as_deref() == Some("real")).and_then(|c| c.identity.as_ref());
    let conditions = real.map(|i| format!("{:?}", i.conditions)).unwrap_or_default();
    assert!(conditions.contains("I_3 lies between I_1 and I_2 or is equal to one of them"), "{conditions}");
}
