//! What is so at different times of a motion need not be so together; and what is said over a box says nothing beyond.

use crate::premises::of_file;
use rederive::verdict::Outcome;

/// What is found of the claim c in a file with the motion z = t from −1 to 1, w = 2, x = 5.
fn standing(rest: &str) -> &'static str {
    let account = account(rest);
    let claim = account.claims.iter().find(|c| c.id == "c").expect("it is there");
    claim.identity.as_ref().map_or("none", |i| i.standing())
}

fn account(rest: &str) -> rederive::findings::Account {
    let states = ["x", "y", "z", "w"].map(|s| format!("'{s}' = {{ role = 'state' }}\n")).concat();
    let leap = r"\lfloor\frac{1}{1+10^{18}(z-\frac1{10})^2}+\frac12\rfloor";
    let observables =
        [("V", "z"), ("U", "-z"), ("S", r"\sqrt{z-0.5}"), ("R", r"\sqrt{-z-0.5}"), ("A", "|z|"), ("Q", leap)]
            .map(|(s, formula)| format!("'{s}' = {{ role = 'observable', formula = '{formula}' }}\n"))
            .concat();
    let motion = "[[trajectory]]\nid = 'm'\nformula = { z = 't', x = '5', y = '0', w = '2' }\nspan = [-1, 1]\n";
    of_file(&format!("{states}{observables}{motion}{rest}"))
}

fn claim(id: &str, says: &str, more: &str) -> String {
    format!("[[claim]]\nid = '{id}'\nsays = '{id}'\nalways = ['{says}']\n{more}\n")
}

/// At no time is z above ½ and below −½, whatever chooses these times: a name, the domain of a formula, or a claim further back.
#[test]
fn what_is_given_is_so_at_some_time() {
    let names = |formula: &str| format!("symbols = {{ 'h' = {{ role = 'observable', formula = '{formula}' }} }}");
    let above = format!("{}\nassuming = ['h>0.5']", names("z"));
    let below = format!("{}\nassuming = ['h>0.5']", names("-z"));
    let from = "follows-from = ['p']";
    let files = [
        claim("p", "w=2", &below) + &claim("c", "w^2=2w", &format!("{from}\n{above}")),
        claim("p", "x=5", &below) + &claim("q", "w=2", &above) + &claim("c", "w+x=7", "follows-from = ['p', 'q']"),
        claim("p", "w+S=2+S", "") + &claim("c", "w+R=2+R", from),
        claim("p", "w+S=2+S", "") + &claim("c", "w=2", &format!("{from}\nassuming = ['U>0.5']")),
        claim("p", "w+S=2+S", "") + &claim("c", "w=2", &format!("{from}\nassuming = ['R=R']")),
        claim("p", "x+S=5+S", "") + &claim("q", "w+R=2+R", "") + &claim("c", "w+x=7", "follows-from = ['p', 'q']"),
        claim("p", "w=2", "assuming = ['U>0.5']") + &claim("c", r"w\sqrt V=2\sqrt V", from),
        claim("p", "w=2", "assuming = ['U>0.5']") + &claim("c", "w+S=2+S", from),
        claim("q", "w=2", "assuming = ['U>0.5']")
            + &claim("p", "w^2=4", "follows-from = ['q']")
            + &claim("c", "w^2+S=4+S", from),
    ];
    for file in &files {
        let found = standing(file);
        assert!(!found.starts_with("proved"), "{file}: {found}");
    }
    for file in [
        claim("p", "w+S=2+S", "") + &claim("c", "w^2+S=4+S", from),
        claim("p", "w=2", "assuming = ['U>0.5']") + &claim("c", "w+R=2+R", from),
    ] {
        let found = standing(&file);
        assert!(found.starts_with("proved"), "{file}: {found}");
    }
}

/// The same where a claim further back assumes more than is told of it.
#[test]
fn what_is_not_told_of_a_long_derivation_counts() {
    let many = (0..64).map(|k| format!("'w\\ne{}'", 100 + k)).collect::<Vec<_>>().join(", ");
    let from = |ids: &str| format!("follows-from = [{ids}]");
    let file = claim("q0", "w=2", &format!("assuming = [{many}]"))
        + &claim("q", "w^2=4", &from("'q0'"))
        + &claim("r0", "x=5", "assuming = ['U>0.5']")
        + &claim("r", "x^2=25", &from("'r0'"))
        + &claim("c", "w^2+x^2=29", &format!("{}\nassuming = ['V>0.5']", from("'q', 'r'")));
    let found = standing(&file);
    assert!(!found.starts_with("proved"), "{found}");
}

/// A motion that comes from another leaps, or has kinks, where an observable in its map has: x = |z| is no smooth motion, and no motion of
/// ẋ = 0 stays what it is where x = ⌊…⌋.
#[test]
fn a_map_is_as_smooth_as_what_it_names() {
    let derived = |map: &str| format!("[[trajectory]]\nid = 'd'\nfrom = 'm'\nmap = {{ x = '{map}' }}\n");
    let on_d = |id: &str, says: &str, more: &str| claim(id, says, &format!("{more}\ntrajectories = ['d']"));
    let kink = derived("A")
        + &on_d("p", "x^2=z^2", "")
        + &on_d("q", "z=t, w=2", "")
        + &on_d("c", r"(x(1)+x(-1))\dot x=0", "follows-from = ['p', 'q']");
    assert_eq!(standing(&kink), "undecided");
    let empty = derived("A")
        + &on_d("p", "x=|z|", "")
        + &on_d("q", r"z(0)=0, \dot z=1, w=2", "")
        + &on_d("c", r"w\dot x=2\dot x", "follows-from = ['p', 'q']");
    assert!(!standing(&empty).starts_with("proved"));
    let leap = derived(r"Q") + &on_d("p", r"\dot x=0", "") + &on_d("c", "x=x(0)", "follows-from = ['p']");
    let account = account(&leap);
    let found = &account.claims.iter().find(|c| c.id == "c").expect("it is there").results[0].verdict;
    assert!(!matches!(found.outcome(), Outcome::Holds(_)), "{found:?}");
}

/// That x is constant is known within errors only, whatever else is said beside it: x = 1 + 10⁻²⁰ t refutes nothing.
#[test]
fn what_is_within_errors_refutes_nothing() {
    let motion =
        "[[trajectory]]\nid = 'n'\nformula = { z = 't', x = '1+10^{-20}t', y = '0', w = '2' }\nspan = [-1, 1]\n";
    for says in ["always = ['w>1']", "eventually = ['w>1']", "never = ['w<1']"] {
        let file = format!("{motion}[[claim]]\nid = 'p'\nsays = 'p'\nfirst-integral = ['x']\n{says}\n")
            + &claim("c", r"\dot x=0", "follows-from = ['p']\ntrajectories = ['n']");
        assert_ne!(standing(&file), "refuted", "{says}");
    }
}

/// For x = 1 and y = 2 the sum is 3; for other numbers nothing is said.
#[test]
fn what_is_said_over_a_box_says_nothing_beyond() {
    let from = "follows-from = ['p']";
    for (says, ranges) in [
        ("2x+2y=6", "'x' = 1, 'y' = 2"),
        (r"\dot x+\dot y=0", "'x' = 1, 'y' = 2"),
        ("x+y=3", "'x' = [0, 1], 'y' = '3-x'"),
    ] {
        let file = claim("p", "x+y=3", &format!("ranges = {{ {ranges} }}\npostulate = true")) + &claim("c", says, from);
        let found = standing(&file);
        assert!(!found.starts_with("proved"), "{file}: {found}");
    }
    let found = standing(&(claim("p", "x+y=3", "postulate = true") + &claim("c", "2x+2y=6", from)));
    assert!(found.starts_with("proved"), "{found}");
}
