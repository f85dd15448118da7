//! `never`, `eventually` and `\ne`: what is proved of the equations that they deny is shown of them, for all values and on motions.

use rederive::check::{Account, Outcome};

use crate::premises::{of_file, standing};

const HEAD: &str = r"
'x' = { role = 'state' }
'y' = { role = 'state' }
'r' = { role = 'observable', formula = '\sqrt{x}' }
[system.s]
states = ['x', 'y']
equations = ['\dot x=y', '\dot y=-x']
[[trajectory]]
id = 'm'
system = 's'
initial = { 'x' = 0.3, 'y' = 0.7 }
span = [0.1, 5]
[[claim]]
id = 'law'
says = 'test'
always = ['x^2+y^2=x(0.1)^2+y(0.1)^2']
follows-from = ['s']
";

fn file(claims: &[(&str, &str)]) -> Account {
    let claim = |(id, body): &(&str, &str)| format!("[[claim]]\nid = '{id}'\nsays = 'test'\n{body}\n");
    of_file(&(HEAD.to_owned() + &claims.iter().map(claim).collect::<String>()))
}

/// What a claim came to on its motion.
fn on_motion(account: &Account, id: &str) -> (&'static str, &'static str) {
    let claim = account.claims.iter().find(|c| c.id == id).unwrap_or_else(|| panic!("no claim {id}"));
    let outcome: Outcome = claim.results.first().map_or(Outcome::Undecided, |p| p.verdict.outcome());
    (outcome.word(), outcome.strength().unwrap_or("none"))
}

#[test]
fn a_proof_of_what_is_denied_decides_every_negation() {
    let law = r"x^2+y^2=x(0.1)^2+y(0.1)^2";
    let differs = law.replace('=', r"\ne ");
    let account = file(&[
        ("identity", r"never = ['\sin^2x+\cos^2x=1']"),
        ("by-a-law", &format!("never = ['{law}']\nfollows-from = ['law']")),
        ("later", &format!("assuming = ['t>1']\nnever = ['{law}']\nfollows-from = ['law']")),
        ("differs", &format!("always = ['{differs}']\nfollows-from = ['s']")),
        // What the file says that it follows from is not all that the motion obeys.
        (
            "vector",
            r"never = ['(x^2+y^2,\dot x)=(x(0.1)^2+y(0.1)^2,y)']
assuming = ['t>1']
follows-from = ['law']",
        ),
        ("a-hole", r"never = ['\frac{x^2}{x}=x']"),
        ("a-root", "never = ['r^2=x']"),
        ("vectors", r"always = ['(x,y)\ne(x,\dot x)']"),
        ("mixed", r"always = ['\dot x=y', 'x-y\ne x-\dot x']"),
    ]);
    for claim in ["identity", "by-a-law", "later", "differs", "vector", "a-hole", "a-root", "vectors", "mixed"] {
        assert_eq!(on_motion(&account, claim), ("fails", "proved"), "{claim}");
    }
    let refuted = ["identity", "by-a-law", "later", "differs", "a-hole", "a-root", "vectors", "mixed"];
    assert!(refuted.iter().all(|claim| standing(&account, claim) == "refuted"));
    assert_eq!(standing(&account, "vector"), "undecided", "of what it names it does not follow");
    let account = file(&[("happens", &format!("eventually = ['{law}']\nfollows-from = ['s']"))]);
    assert_eq!((standing(&account, "happens"), on_motion(&account, "happens")), ("proved", ("holds", "proved")));
}

#[test]
fn what_contradicts_what_is_given_never_happens() {
    let account = file(&[
        ("never", "never = ['x^2+y^2=-1']"),
        ("vectors", r"always = ['(x,y)\ne(x+1,y)']"),
        ("given", "assuming = ['y=2x']\nalways = ['y-x\\ne x+1']\ntrajectories = []"),
        ("happens", "eventually = ['x^2+1=0']"),
        // Nothing satisfies what is given: nothing is said.
        ("nothing", "assuming = ['x^2=-1']\nnever = ['y=x']\ntrajectories = []"),
    ]);
    let standings = ["never", "vectors", "given", "happens", "nothing"].map(|claim| standing(&account, claim));
    assert_eq!(standings, ["proved", "proved", "proved", "refuted", "undecided"]);
    assert_eq!(on_motion(&account, "never"), ("holds", "proved"));
    assert_eq!(on_motion(&account, "vectors"), ("holds", "proved"));
    assert_eq!(on_motion(&account, "happens").0, "fails");
}

#[test]
fn a_point_at_which_it_is_false_says_nothing_of_other_times() {
    let account = file(&[
        ("never", "never = ['x=0.31']\ntrajectories = []"),
        ("happens", "eventually = ['x=0.31']\ntrajectories = []"),
        ("one-of-two", r"never = ['x=0.31', '\sin^2x+\cos^2x=1']"),
        (
            "both",
            r"eventually = ['x=0.31', '\sin^2x+\cos^2x=1']
trajectories = []",
        ),
    ]);
    assert_eq!(standing(&account, "never"), "undecided");
    assert_eq!(standing(&account, "happens"), "undecided");
    assert_eq!(standing(&account, "one-of-two"), "refuted");
    assert_eq!(standing(&account, "both"), "undecided");
}

#[test]
fn where_no_time_counts_nothing_is_said_on_the_motion() {
    let account = file(&[
        ("no-time", "assuming = ['t>7']\nnever = ['\\dot x^2+x^2=x^2+y^2']\nfollows-from = ['s']"),
        ("not-met", "assuming = ['x=y']\nnever = ['y=x']"),
        ("no-value", r"never = ['\sqrt{-1-x^2}=\sqrt{-1-x^2}+0']"),
    ]);
    for claim in ["no-time", "not-met", "no-value"] {
        assert_eq!(on_motion(&account, claim).0, "not-applicable", "{claim}");
    }
}
