//! The second route: certificates over the rationals, and agreement with the random test on all that there is.
//!
//! `REDERIVE_THOROUGH=1` looks for all certificates that can be had; `REDERIVE_CERTIFICATES=folder` writes the lines for SymPy
//! there; `REDERIVE_CASES=10000` for a long run with random identities.

#![cfg(feature = "certificates")]

use crate::infix::Reader;
use rederive::check::agree;
use rederive::check::identity::{
    Certificate, Effort, Identity, NoCertificate, Options, Origin, certify, identity_test,
};
use rederive::number::Draws;

type Found = Result<Vec<Certificate>, NoCertificate>;

/// Both routes; they may not contradict each other.
#[track_caller]
fn both(claim: &str, premises: &str, moving: &str, effort: Effort) -> (Identity, Found) {
    let mut r = Reader::default();
    let equations = r.equations(claim);
    let given = r.premises(premises, moving);
    let one = identity_test(&mut r.graph, &equations, &given, &Options::default());
    let two = certify(&mut r.graph, &equations, &given, effort);
    if let Err(contradiction) = agree(&one, &two) {
        panic!("`{claim}` given `{premises}`: {contradiction}");
    }
    if let Ok(all) = &two {
        assert_eq!(all.len(), equations.len());
    }
    (one, two)
}

#[test]
fn the_comment_has_certificates() {
    let thorough = std::env::var_os("REDERIVE_THOROUGH").is_some();
    let effort = if thorough { Effort::THOROUGH } else { Effort::QUICK };
    let mut without = Vec::new();
    for step in crate::comment::steps() {
        let start = std::time::Instant::now();
        let (one, two) = both(&step.claim, &step.premises, &step.moving, effort);
        assert!(matches!(one, Identity::Proved(_)), "{}", step.id);
        match two {
            Ok(all) => {
                let longest = all.iter().map(|c| c.sympy().len()).max().unwrap_or(0);
                println!("{:32} certified, {longest} characters, {:?}", step.id, start.elapsed());
                if let Ok(path) = std::env::var("REDERIVE_CERTIFICATES") {
                    for c in &all {
                        let name = format!("{path}/{}-{}.py", step.id.replace(['/', ' '], "_"), c.equation);
                        std::fs::write(name, c.sympy()).expect("written");
                    }
                }
            }
            Err(reason) => {
                println!("{:32} {reason:?} {:?}", step.id, start.elapsed());
                assert_eq!(reason, NoCertificate::TooLarge, "{}", step.id);
                without.push(step.id);
            }
        }
    }
    let most = if thorough { 3 } else { 6 };
    assert!(without.len() <= most, "{without:?}");
}

#[test]
fn what_is_false_has_no_certificate() {
    for (claim, premises) in [
        ("sqrt(x^2) = x", ""),
        ("x = 2", "x^2 = 4"),
        ("x = 1", "x*y = y"),
        ("x = y", "x^2 = y^2"),
        ("abs(x) = x", ""),
        ("sin(x/2) = sin(x)/2", ""),
        ("sin(x)^2 + cos(x)^2 = 2", ""),
        ("exp(x+y) = exp(x) + exp(y)", ""),
        ("sqrt(a^2 + b^2) = a + b", ""),
        ("(x - x)/(y - y) = 0", ""),
        ("x/(y - y) = x/(y - y)", ""),
        ("2305843009213693952*x = x", ""),
        ("x^2 + 2305843009213693951*x*y = x^2", ""),
    ] {
        let (one, two) = both(claim, premises, "", Effort::THOROUGH);
        assert!(!matches!(one, Identity::Proved(_)) && two.is_err(), "{claim}: {one:?} {two:?}");
    }
}

/// Without premises, roots and |·| the second route refutes by itself.
#[test]
fn the_exact_normal_form_refutes() {
    for claim in [
        "x^2 = 2*x",
        "sin(x)^2 + cos(x)^2 = 2",
        "sin(2*x) = 2*sin(x)",
        "exp(x)*exp(x) = exp(3*x)",
        "1/x + 1/y = 2/(x + y)",
        "2305843009213693952*x = x",
    ] {
        let (one, two) = both(claim, "", "", Effort::QUICK);
        assert!(matches!(one, Identity::Refuted(_)), "{claim}: {one:?}");
        assert_eq!(two, Err(NoCertificate::Refuted { equation: 0 }), "{claim}");
    }
    // Where there is more, not being found means nothing: these are true.
    for (claim, premises) in [("sqrt(x^2) = x", "x > 0"), ("x = 0", "x^2 + y^2 = 0"), ("abs(x^2) = x^2", "")] {
        let (_, two) = both(claim, premises, "", Effort::THOROUGH);
        assert!(!matches!(two, Err(NoCertificate::Refuted { .. })), "{claim}: {two:?}");
    }
}

#[test]
fn what_is_true_has_one() {
    for (claim, premises) in [
        ("sin(x)^2 + cos(x)^2 = 1", ""),
        ("cos(3*x) = 4*cos(x)^3 - 3*cos(x)", ""),
        ("tan(x/2) = sin(x)/(1+cos(x))", ""),
        ("1/(sqrt(x+1) - sqrt(x)) = sqrt(x+1) + sqrt(x)", ""),
        ("cosh(x)^2 - sinh(x)^2 = 1", ""),
        ("x = 2*y", "x + y = 3*y"),
        ("x^2 + y^2 = 5", "x + y = 3; x*y = 2"),
        ("y = 3", "x*y = 3*x; x != 0"),
        ("x/2 = y/3", "x = 2*a/7; y = 3*a/7"),
    ] {
        let (one, two) = both(claim, premises, "", Effort::QUICK);
        assert!(matches!(one, Identity::Proved(_)) && two.is_ok(), "{claim}: {one:?} {two:?}");
    }
}

/// What a reader gets: names that Python takes, whole numbers, the meaning of everything.
#[test]
fn certificates_can_be_read() {
    let read = |claim: &str, premises: &str| -> Certificate {
        let (_, two) = both(claim, premises, "", Effort::QUICK);
        two.unwrap_or_else(|e| panic!("{claim}: {e:?}")).remove(0)
    };
    let c = read("lambda*x/3 = d/5", "3*d = 5*lambda*x; p1 = 2");
    let names: Vec<&str> = c.variables.iter().map(|(n, _)| n.as_str()).collect();
    assert!(names.iter().all(|n| *n != "lambda" && *n != "d" && *n != "p1"), "{names:?}");
    assert!(!c.sympy().contains('/') && !c.sympy().contains('^'), "{}", c.sympy());
    let c = read("tan(x)*cos(x) = sin(x)", "");
    assert!(c.terms.is_empty() || c.terms.iter().all(|t| t.origin == Origin::Circle), "{c:?}");
    let c = read("sin(x)^2 = 1 - cos(x)^2", "");
    assert_eq!(c.variables.iter().map(|v| v.1.as_str()).collect::<Vec<_>>(), [r"\sin(x)", r"\cos(x)"]);
    assert_eq!((c.multiplier.as_str(), c.terms.len()), ("1", 1));
    let c = read("y = 3", "x*y = 3*x; x != 0");
    assert_eq!((c.multiplier.as_str(), c.not_zero.as_slice()), ("x", &["x".to_owned()][..]));
    assert_eq!(c.terms[0].origin, Origin::Premise(r"x\cdot y = 3\cdot x".to_owned()));
}

/// The same outcome whatever else happens: work is counted, not timed.
#[test]
fn the_work_is_bounded_and_counted() {
    let text = "x^5 + y^5 + z^5 = 7*u";
    let premises = "x + y + z = u; x^2 + y^2 + z^2 = u^3 + 1; x*y*z = u^2 - x";
    let outcomes: Vec<Found> = [10, 10_000, 10_000]
        .map(|work| both(text, premises, "", Effort { work, ..Effort::QUICK }).1)
        .into_iter()
        .collect();
    assert_eq!(outcomes[0], Err(NoCertificate::TooLarge));
    assert_eq!(outcomes[1], outcomes[2]);
}

/// A random expression, as text: polynomials, quotients, circular and exponential functions.
fn expression(draws: &mut Draws, depth: u32) -> String {
    let variable = |draws: &mut Draws| ["x", "y", "z"][draws.below(3) as usize].to_owned();
    if depth == 0 {
        return if draws.below(4) == 0 { (draws.below(5) + 1).to_string() } else { variable(draws) };
    }
    let (a, b) = (expression(draws, depth - 1), expression(draws, depth - 1));
    match draws.below(8) {
        0 | 1 => format!("({a} + {b})"),
        2 => format!("({a} - {b})"),
        3 | 4 => format!("({a})*({b})"),
        5 => format!("({a})/(1 + ({b})^2)"),
        6 => format!("{}({})", ["sin", "cos", "exp"][draws.below(3) as usize], variable(draws)),
        _ => format!("({a})^2"),
    }
}

/// Another form of an expression, equal to it where both have a value, given `z = x + 2*y`.
fn rewritten(draws: &mut Draws, e: &str, given: bool) -> String {
    let w = expression(draws, 1);
    match draws.below(if given { 8 } else { 7 }) {
        0 => format!("({e} + {w}) - {w}"),
        1 => format!("{e}*(sin({w})^2 + cos({w})^2)"),
        2 => format!("({e}*(2 + cos(y)))/(2 + cos(y))"),
        3 => format!("(({e} + ({w}))^2 - ({e} - ({w}))^2)/(4*({w}))"),
        4 => format!("{e}*exp({w})*exp(0 - ({w}))"),
        5 => format!("({e} + sin(2*x)) - 2*sin(x)*cos(x)"),
        6 => format!("({e})*(cosh(y)^2 - sinh(y)^2)"),
        _ => format!("({e}) + (z - x)*(z + x) - 4*y*(x + y)"),
    }
}

#[test]
fn both_routes_agree_on_random_identities() {
    let cases: u64 = std::env::var("REDERIVE_CASES").ok().and_then(|v| v.parse().ok()).unwrap_or(150);
    let (mut certified, mut proved, mut refuted_exactly, mut refuted, mut wrong) = (0, 0, 0, 0, 0);
    for seed in 0..cases {
        let mut draws = Draws::new(seed);
        let given = draws.below(3) == 0;
        let premises = if given { "z = x + 2*y" } else { "" };
        let depth = 1 + draws.below(2) as u32;
        let e = expression(&mut draws, depth);
        let other = rewritten(&mut draws, &e, given);
        let (one, two) = both(&format!("{e} = {other}"), premises, "", Effort::QUICK);
        match one {
            Identity::Proved(_) => proved += 1,
            Identity::Refuted(r) => panic!("seed {seed}: {e} = {other} is true, and refuted: {r:?}"),
            Identity::Undecided(_) => {}
        }
        certified += u64::from(two.is_ok());
        // A near miss: one term more, small or of high degree.
        let extra = ["1", "x", "y^7/1000", "sin(x)", "x*y", "exp(y)"][draws.below(6) as usize];
        let (one, two) = both(&format!("{e} = {other} + {extra}"), premises, "", Effort::QUICK);
        match one {
            Identity::Proved(_) => panic!("seed {seed}: {e} = {other} + {extra} is false, and proved"),
            Identity::Refuted(_) => refuted += 1,
            Identity::Undecided(_) => {}
        }
        assert!(two.is_err(), "seed {seed}: {e} = {other} + {extra} is false, and has a certificate");
        refuted_exactly += u64::from(matches!(two, Err(NoCertificate::Refuted { .. })));
        wrong += 1;
    }
    println!(
        "true: {proved} proved, {certified} certified of {cases}; \
         false: {refuted} refuted, {refuted_exactly} exactly, of {wrong}"
    );
    assert!(
        proved * 20 >= cases * 19 && certified * 10 >= cases * 9,
        "{proved} proved, {certified} certified of {cases}"
    );
    assert!(refuted * 20 >= wrong * 19 && refuted_exactly * 10 >= wrong * 5, "{refuted}, {refuted_exactly} of {wrong}");
}

/// One edit in every step of the Comment: no route may say the opposite of the other.
#[test]
fn both_routes_agree_on_edited_steps() {
    let edits = [("sin(", "cos("), ("^2", ""), (" + ", " - "), ("I1", "I2"), ("R31", "R32"), ("m3", "(2*m3)")];
    let (mut tried, mut certified) = (0, Vec::new());
    for step in crate::comment::steps() {
        let first = step.claim.split(';').next().unwrap_or_default().trim().to_owned();
        for (from, to) in edits {
            let Some(at) = first.find(from) else { continue };
            let edited = format!("{}{to}{}", &first[..at], &first[at + from.len()..]);
            let (one, two) = both(&edited, &step.premises, &step.moving, Effort::QUICK);
            tried += 1;
            if two.is_ok() && !matches!(one, Identity::Proved(_)) {
                certified.push(format!("{}: {edited}: {}", step.id, one.word()));
            }
        }
    }
    assert!(tried > 40, "{tried}");
    assert!(certified.is_empty(), "a certificate without a proof: {certified:#?}");
}

/// `check` runs both routes on every identity of every derivation of the repository, and stops at a contradiction.
#[test]
fn both_routes_agree_on_all_derivations() {
    use rederive::check::{Options, check};
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut identities = 0;
    for folder in ["derivations", "tests/corpus"] {
        let mut files: Vec<_> =
            std::fs::read_dir(root.join(folder)).expect("listed").map(|e| e.expect("entry").path()).collect();
        files.retain(|file| file.extension().is_some_and(|e| e == "toml"));
        files.sort();
        for file in files {
            let derivation = rederive::derivation::load(&file).expect("a derivation");
            // Motions take most of the time and are not needed here.
            let none = Options { trajectories: vec!["none".into()], ..Options::default() };
            let account = check(&derivation, &none, &|_, _| {}).unwrap_or_else(|e| panic!("{}: {e:?}", file.display()));
            for claim in &account.claims {
                let Some(identity) = &claim.identity else { continue };
                identities += 1;
                let certificates = &identity.evidence.certificates;
                // What denies a relation is refuted by a proof of it.
                let mut declared = derivation.claims.iter();
                let denies = declared.any(|d| d.id == claim.id && rederive::claim::denial::denies(d));
                assert!(certificates.is_empty() || identity.verdict() != "refuted" || denies, "{}", claim.id);
            }
        }
    }
    assert!(identities > 80, "{identities}");
}
