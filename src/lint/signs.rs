//! Signs between the sides of a printed relation, by what they say.

/// Signs that say that two sides are equal.
pub const EQUALS: &[&str] = &["=", r"\equiv", ":=", "=:", r"\coloneqq", r"\triangleq", r"\doteq", "≡"];
/// Signs that say that they are about equal.
pub const ABOUT: &[&str] = &[
    r"\approx",
    r"\sim",
    r"\simeq",
    r"\propto",
    r"\cong",
    r"\asymp",
    r"\approxeq",
    r"\eqsim",
    "≈",
    "∼",
    "∝",
    r"\ll",
    r"\gg",
    "≪",
    "≫",
    r"\lesssim",
    r"\gtrsim",
    r"\thickapprox",
    r"\thicksim",
];
/// Signs that compare.
pub const COMPARES: &[&str] = &[
    "<",
    ">",
    r"\le",
    r"\leq",
    r"\ge",
    r"\geq",
    r"\ne",
    r"\neq",
    r"\lt",
    r"\gt",
    r"\leqslant",
    r"\geqslant",
    r"\in",
    r"\notin",
    "≤",
    "≥",
    "≠",
    r"\not=",
    r"\subset",
    r"\subseteq",
];

/// Whether a sign is one of a kind.
pub fn is_one_of(kind: &[&str], sign: &str) -> bool {
    kind.contains(&sign)
}
