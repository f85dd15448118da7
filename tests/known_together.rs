//! What is so at different times of a motion need not be so together; and what is said over a box says nothing beyond.

use crate::premises::of_file;

/// What is found of the claim c in a file with the motion z = t from −1 to 1, w = 2, x = 5.
fn standing(rest: &str) -> &'static str {
    let states = ["x", "y", "z", "w"].map(|s| format!("'{s}' = {{ role = 'state' }}\n")).concat();
    let observables = [("V", "z"), ("U", "-z"), ("S", r"\sqrt{z-0.5}"), ("R", r"\sqrt{-z-0.5}")]
        .map(|(s, formula)| format!("'{s}' = {{ role = 'observable', formula = '{formula}' }}\n"))
        .concat();
    let motion = "[[trajectory]]\nid = 'm'\nformula = { z = 't', x = '5', y = '0', w = '2' }\nspan = [-1, 1]\n";
    let account = of_file(&format!("{states}{observables}{motion}{rest}"));
    let claim = account.claims.iter().find(|c| c.id == "c").expect("it is there");
    claim.identity.as_ref().map_or("none", |i| i.standing())
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
