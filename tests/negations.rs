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

/// Sides that agree by construction, or differ by a number that no sample sees.
fn close_sides(rng: &mut impl FnMut(u64) -> u64) -> (String, bool) {
    let left = match rng(12) {
        0 => r"\sqrt2^2".to_owned(),
        1 => format!("{}", rng(9) + 1),
        2 => format!("{}.{}", rng(9), rng(99) + 1),
        3 => r"\frac{22}{7}".to_owned(),
        4 => r"\sqrt{3}\sqrt{12}".to_owned(),
        5 => r"\sin^2x+\cos^2x".to_owned(),
        6 => "x".to_owned(),
        7 => "xy-yx".to_owned(),
        8 => r"\dot x".to_owned(),
        9 => "tx".to_owned(),
        10 => r"(x+1)^2-x^2-2x".to_owned(),
        _ => "r^2".to_owned(),
    };
    let same = match left.as_str() {
        r"\sqrt2^2" => "2",
        r"\sqrt{3}\sqrt{12}" => "6",
        r"\sin^2x+\cos^2x" | "(x+1)^2-x^2-2x" => "1",
        "xy-yx" => "0",
        r"\dot x" => "y",
        "r^2" => "x",
        own => own,
    };
    let apart = rng(3) > 0;
    let beyond = if apart { format!("+10^{{-{}}}", rng(28) + 3) } else { String::new() };
    (format!("{left}={same}{beyond}"), apart)
}

/// What a claim says of every time, and what it denies of every time, are not both so: of sides that differ by less than samples and
/// enclosures tell, too.
#[test]
fn always_and_never_do_not_both_hold() {
    let mut seed = 20_u64;
    let mut rng = |n: u64| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 33) % n
    };
    let motion = "[[trajectory]]\nid = 'f'\nformula = { 'x' = '2+t', 'y' = '1' }\nspan = [0.1, 5]\n";
    let mut text = HEAD.replace("[[claim]]", &format!("{motion}[[claim]]")) + "trajectories = ['m']\n";
    let mut made = Vec::new();
    for at in 0..40 {
        let (relation, apart) = close_sides(&mut rng);
        let assuming = ["", "assuming = ['t>1']\n", "assuming = ['x>0']\n"][rng(3) as usize];
        let from = ["", "follows-from = ['s']\n"][rng(2) as usize];
        for form in ["always", "never"] {
            let id = format!("{form}{at}");
            text += &format!("[[claim]]\nid = '{id}'\nsays = 'test'\n{assuming}{from}{form} = ['{relation}']\n");
        }
        made.push((relation, apart));
    }
    let account = of_file(&text);
    let outcomes = |id: &str| -> Vec<Outcome> {
        let claim = account.claims.iter().find(|c| c.id == id).unwrap_or_else(|| panic!("no claim {id}"));
        claim.results.iter().map(|p| p.verdict.outcome()).collect()
    };
    let mut excluded = 0;
    for (at, (relation, apart)) in made.iter().enumerate() {
        let (always, never) = (outcomes(&format!("always{at}")), outcomes(&format!("never{at}")));
        for (always, never) in always.iter().zip(&never) {
            let both = matches!(always, Outcome::Holds(_)) && matches!(never, Outcome::Holds(_));
            assert!(!both, "{relation}: always {always:?}, never {never:?}");
            match apart {
                true => assert!(!matches!(never, Outcome::Fails(_)), "{relation}: never {never:?}"),
                false => assert!(!matches!(always, Outcome::Fails(_)), "{relation}: always {always:?}"),
            }
            excluded += usize::from(matches!(never, Outcome::Holds(_)) && *apart);
        }
    }
    assert!(excluded > 20, "{excluded}: little is shown of what differs");
}

#[test]
fn numbers_are_what_is_written_on_every_motion() {
    let motion = "[[trajectory]]\nid = 'f'\nformula = { 'x' = 't', 'y' = '1' }\nspan = [0.1, 5]\n";
    let claims = "trajectories = ['m']\n[[claim]]\nid = 'always'\nsays = 'test'\nalways = ['\\sqrt2^2=2.0000000000000004']\n\
                  [[claim]]\nid = 'never'\nsays = 'test'\nnever = ['\\sqrt2^2=2.0000000000000004']\n";
    let account = of_file(&(HEAD.replace("[[claim]]", &format!("{motion}[[claim]]")) + claims));
    for (id, word) in [("always", "fails"), ("never", "holds")] {
        let claim = account.claims.iter().find(|c| c.id == id).expect("a claim");
        let found: Vec<_> =
            claim.results.iter().map(|p| p.verdict.outcome()).map(|o| (o.word(), o.strength())).collect();
        assert_eq!(found, [(word, Some("proved")); 2], "{id}");
    }
}
