//! Signs of functions on ranges: what is given of an argument decides whether |f| is f, and a range that reaches a little farther does not.
//!
//! The law is that of the table of stretches (`src/expr/domain/stretch.rs`), asked from outside: every function on every stretch, with arguments scaled and
//! moved, ends included and not.

use crate::prove_traps::{all, one};
use std::process::Command;

/// A function, a stretch of its argument as text, and whether it is positive there.
const STRETCHES: &[(&str, &str, &str, bool)] = &[
    (r"\sin", "0", r"\pi", true),
    (r"\sin", r"-\pi", "0", false),
    (r"\sin", r"\pi", r"2\pi", false),
    (r"\cos", r"-\frac{\pi}{2}", r"\frac{\pi}{2}", true),
    (r"\cos", r"\frac{\pi}{2}", r"\frac{3\pi}{2}", false),
    (r"\tan", "0", r"\frac{\pi}{2}", true),
    (r"\tan", r"-\frac{\pi}{2}", "0", false),
    (r"\ln", "1", "", true),
    (r"\ln", "0", "1", false),
    (r"\sinh", "0", "", true),
    (r"\sinh", "", "0", false),
    (r"\tanh", "0", "", true),
    (r"\arctan", "", "0", false),
    (r"\arcsin", "0", "1", true),
];

fn given(argument: &str, low: &str, high: &str, relation: &str) -> String {
    let above = (!low.is_empty()).then(|| format!("{low}{relation}{argument}"));
    let below = (!high.is_empty()).then(|| format!("{argument}{relation}{high}"));
    above.into_iter().chain(below).collect::<Vec<_>>().join("; ")
}

#[test]
fn a_function_has_its_sign_on_a_stretch() {
    for &(f, low, high, is_positive) in STRETCHES {
        for relation in ["<", r"\le "] {
            // A logarithm has no value at 0: it is the same claim.
            let premises = given("x", low, high, relation);
            let size = format!("{}{f}(x)", if is_positive { "" } else { "-" });
            one(("proved", &format!(r"\left|{f}(x)\right|={size}"), "x", &premises));
            one(("proved", &format!(r"\sqrt{{{f}^2(x)}}={size}"), "x", &premises));
            // The other sign is wrong.
            let other = format!("{}{f}(x)", if is_positive { "-" } else { "" });
            unproved_given(&format!(r"\left|{f}(x)\right|={other}"), &premises);
        }
    }
}

#[test]
fn arguments_are_scaled_and_moved() {
    for &(f, low, high, is_positive) in STRETCHES {
        for argument in ["2x", r"\frac{x}{3}", "x+1", "1-x"] {
            let premises = given(argument, low, high, "<");
            let size = format!(r"{}{f}\left({argument}\right)", if is_positive { "" } else { "-" });
            one(("proved", &format!(r"\left|{f}\left({argument}\right)\right|={size}"), "x", &premises));
        }
    }
}

#[test]
fn a_range_that_reaches_beyond_a_stretch_shows_nothing() {
    for &(f, low, high, is_positive) in STRETCHES {
        let size = format!("{}{f}(x)", if is_positive { "" } else { "-" });
        let claim = format!(r"\left|{f}(x)\right|={size}");
        let by = r"\frac{1}{100}";
        // The ends at which the function goes on, and changes its sign.
        let ends =
            [(!low.is_empty() && !(f == r"\ln" && low == "0"), true), (!high.is_empty() && f != r"\arcsin", false)];
        for (_, is_low) in ends.into_iter().filter(|(is_end, _)| *is_end) {
            let (low, high) = if is_low {
                (format!("{low}-{by}"), high.to_owned())
            } else {
                (low.to_owned(), format!("{high}+{by}"))
            };
            unproved_given(&claim, &given("x", &low, &high, "<"));
            // One end alone does not do, either.
            let alone = if is_low { given("x", "", &high, "<") } else { given("x", &low, "", "<") };
            unproved_given(&claim, &alone);
        }
    }
}

#[test]
fn differences_of_rising_functions_have_the_sign_of_the_difference() {
    for f in [r"\exp", r"\ln", r"\sinh", r"\arctan", r"\tanh", r"\arcsin"] {
        let size = format!(r"\left|{f}(x)-{f}(y)\right|={f}(x)-{f}(y)");
        one(("proved", &size, "x,y", "y<x"));
        one(("proved", &size, "x,y", r"x\ge y"));
        unproved_given(&size, "x<y");
        unproved_given(&size, "x<2y");
    }
    // Sine, cosine and tangent do not rise throughout.
    for f in [r"\sin", r"\cos", r"\tan"] {
        unproved_given(&format!(r"\left|{f}(x)-{f}(y)\right|={f}(x)-{f}(y)"), "y<x");
    }
    all(&[
        ("proved", r"|e^x-1|=e^x-1", "x", "x>0"),
        ("proved", r"|1-e^{-2x}|=1-e^{-2x}", "x", "x>0"),
        ("proved", r"\sqrt{\cosh^2x-1}=\sinh x", "x", "x>0"),
        ("proved", r"\sqrt{1-\cos x}=\sqrt2\sin\frac{x}{2}", "x", r"0<x; x<2\pi"),
        ("proved", r"|\ln(\ln x)|=\ln(\ln x)", "x", "x>3"),
        ("proved", "|x|=x", "x", "x^3>0"),
        ("proved", "|x|=x", "x", "x^{-5}>0"),
        ("proved", r"\sqrt{x^3}=|x|^{3/2}", "x", ""),
    ]);
    unproved_given(r"|e^x-1|=e^x-1", "x>-1");
    unproved_given("|x|=x", "x^2>0");
    unproved_given("|x|=x", "x^4>0");
    unproved_given(r"\sqrt{1-\cos x}=\sqrt2\sin\frac{x}{2}", r"0<x; x<3\pi");
}

#[track_caller]
fn unproved_given(claim: &str, premises: &str) {
    one(("unproved", claim, "x,y", premises));
}

/// What was found by ranges, or by powers of roots, has a proof that the checker replays.
#[test]
fn what_ranges_and_roots_show_is_replayed() {
    for (formula, symbols, given) in [
        (r"|\sin x|=\sin x", "x", r"0<x; x<\pi"),
        (r"\sqrt{\cos^2\frac{x}{2}}=\cos\frac{x}{2}", "x", r"-\pi<x; x<\pi"),
        (r"|\ln x|=\ln x", "x", "x>1"),
        ("|e^x-1|=e^x-1", "x", "x>0"),
        (r"x^3=2", "x", r"x=\sqrt[3]2"),
        (r"(\sqrt[5]{x^2+1})^5=x^2+1", "x", ""),
        (r"a^{2/3}a^{1/3}=a", "a: positive", ""),
        (r"(M^{7/11})^{11}=M^7", "M: positive", ""),
        (r"(ab)^{x(c+d)}=(ab)^{xc}(ab)^{xd}", "a, b: positive; c, d, x", ""),
    ] {
        let list = |text: &str| text.split("; ").filter(|t| !t.is_empty()).map(str::to_owned).collect::<Vec<_>>();
        let mut arguments = vec!["prove".to_owned(), formula.to_owned()];
        arguments.extend(list(symbols).into_iter().flat_map(|s| ["--symbol".to_owned(), s]));
        arguments.extend(list(given).into_iter().flat_map(|g| ["--given".to_owned(), g]));
        let out =
            Command::new(env!("CARGO_BIN_EXE_rederive")).args(&arguments).args(["--format", "json"]).output().unwrap();
        let found: serde_json::Value = serde_json::from_slice(&out.stdout).unwrap();
        assert_eq!(found["standing"], "proved", "{formula}");
        assert_eq!(found["recorded"]["grounds"], "replayed", "{formula}: {}", found["recorded"]["why_not"]);
    }
}
