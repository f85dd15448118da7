//! The second route: certificates over the rationals, and agreement with the random test.

#![cfg(feature = "certificates")]

mod comment;
mod infix;

use infix::Reader;
use rederive::check::identity::{Effort, Identity, NoCertificate, Options, certify, identity_test};

#[test]
fn the_comment_has_certificates() {
    let mut without = Vec::new();
    // `REDERIVE_THOROUGH=1` for all that can be had; `REDERIVE_CERTIFICATES=folder` writes the SymPy lines there.
    let effort = if std::env::var_os("REDERIVE_THOROUGH").is_some() { Effort::THOROUGH } else { Effort::QUICK };
    for step in comment::steps() {
        let mut r = Reader::default();
        let equations = r.equations(&step.claim);
        let given = r.premises(&step.premises, &step.moving);
        let start = std::time::Instant::now();
        match certify(&mut r.graph, &equations, &given, effort) {
            Ok(all) => {
                assert_eq!(all.len(), equations.len());
                let longest = all.iter().map(|c| c.sympy().len()).max().unwrap_or(0);
                println!("{:32} certified, {longest} characters, {:?}", step.id, start.elapsed());
                if let Ok(path) = std::env::var("REDERIVE_CERTIFICATES") {
                    for c in &all {
                        std::fs::write(
                            format!("{path}/{}-{}.py", step.id.replace(['/', ' '], "_"), c.equation),
                            c.sympy(),
                        )
                        .unwrap();
                    }
                }
            }
            Err(reason) => {
                println!("{:32} {reason:?} {:?}", step.id, start.elapsed());
                assert_eq!(reason, NoCertificate::TooLarge);
                without.push(step.id);
            }
        }
    }
    let expected = if effort == Effort::THOROUGH { 3 } else { 6 };
    assert!(without.len() <= expected, "{without:?}");
}

#[test]
fn what_is_false_has_no_certificate() {
    for (claim, premises) in [
        ("sqrt(x^2) = x", ""),
        ("x = 2", "x^2 = 4"),
        ("x = 1", "x*y = y"),
        ("sin(x)^2 + cos(x)^2 = 2", ""),
        ("(x - x)/(y - y) = 0", ""),
    ] {
        let mut r = Reader::default();
        let equations = r.equations(claim);
        let given = r.premises(premises, "");
        assert!(certify(&mut r.graph, &equations, &given, Effort::THOROUGH).is_err(), "{claim}");
    }
}

#[test]
fn the_two_routes_agree() {
    for (claim, premises) in [
        ("sin(x)^2 + cos(x)^2 = 1", ""),
        ("cos(3*x) = 4*cos(x)^3 - 3*cos(x)", ""),
        ("tan(x/2) = sin(x)/(1+cos(x))", ""),
        ("1/(sqrt(x+1) - sqrt(x)) = sqrt(x+1) + sqrt(x)", ""),
        ("x = 2*y", "x + y = 3*y"),
        ("x^2 + y^2 = 5", "x + y = 3; x*y = 2"),
        ("y = 3", "x*y = 3*x; x != 0"),
    ] {
        let mut r = Reader::default();
        let equations = r.equations(claim);
        let given = r.premises(premises, "");
        let one = identity_test(&mut r.graph, &equations, &given, &Options::default());
        let two: Result<_, NoCertificate> = certify(&mut r.graph, &equations, &given, Effort::QUICK);
        assert!(matches!(one, Identity::Proved(_)) && two.is_ok(), "{claim}: {one:?} {two:?}");
    }
}
