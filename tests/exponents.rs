//! Powers of powers: exponents that are too large to be computed are never taken for one another.
//!
//! The law is that two towers over one base are equal only if their exponents are, however large these grow.

use crate::prove_traps::{all, unproved};

/// A base to the power of nᵏ.
fn tower(base: &str, n: u32, k: usize) -> String {
    format!("{}{base}{}", "(".repeat(k), format!(")^{{{n}}}").repeat(k))
}

#[test]
fn towers_of_different_heights_are_not_equal() {
    let around: [fn(&str) -> String; 7] = [
        |t| format!(r"\sin({t})"),
        |t| format!(r"e^{{{t}}}"),
        |t| format!(r"\arctan(2y+{t})"),
        |t| format!(r"\sin\frac{{y}}{{{t}}}"),
        |t| format!(r"\sqrt{{{t}}}"),
        |t| format!(r"\ln({t}y)"),
        |t| format!(r"\cos(\frac{{1}}{{x}}+{t})"),
    ];
    for (n, k) in [(64, 5), (64, 6), (3, 19), (3, 20), (2, 30), (2, 31), (1000, 3), (1000, 4)] {
        for around in around {
            let [low, high] = [k, k + 1].map(|k| around(&tower("x", n, k)));
            unproved(&format!("{low}={high}"), "x,y");
        }
    }
}

#[test]
fn exponents_beyond_the_numbers_of_the_machine_are_exponents() {
    for n in ["2147483647", "-2147483648", "2147483648", "-3000000000", "9000000000000000000"] {
        unproved(&format!(r"\ln(\frac{{y}}{{x^{{{n}}}}})=\ln(\frac{{y}}{{x^2}})"), "x,y");
        unproved(&format!(r"\left|(\frac{{x}}{{y}})^{{{n}}}\right|=\left|xy\right|"), "x,y");
        all(&[("proved", r"x^{3000000000}=(x^{1000000})^{3000}", "x", "")]);
    }
}

#[test]
fn a_zero_power_and_what_is_divided_by_twice_are_plain_arguments() {
    all(&[
        ("proved", r"\exp(b^0)=e", "b", ""),
        ("refuted", r"\exp(b^0)=e^2", "b", ""),
        ("proved", r"\sin(b^0x)=\sin x", "b,x", ""),
        ("proved", r"\cos((b+x)^0)=\cos1", "b,x", ""),
        ("proved", r"\cos(\frac{1}{(b+1)^{-1}}-b)=\cos1", "b", ""),
        ("proved", r"\cos(\frac{1}{(b+1)^{-2}})=\cos((b+1)^2)", "b", ""),
        ("proved", r"e^{\frac{x}{(b+1)^{-1}(x+1)^{-1}}}=e^{x(b+1)(x+1)}", "b,x", ""),
        ("refuted", r"\cos(\frac{1}{(b+1)^{-2}})=\cos((b+1)^3)", "b", ""),
    ]);
}
