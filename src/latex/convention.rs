//! Conventions of print: names that a reader takes for functions, functionals or operators.
//!
//! **In:** a name. **Out:** what it prints as before brackets. **Used by:** the parser, which refuses what could be a call, and the writer, which never
//! prints one that is none.

use super::name;

/// Names that print as functions before parentheses, whatever stands in these.
pub(crate) const FUNCTIONS: &[&str] = &["f", r"\Gamma", r"\delta", r"\Theta", r"\zeta", r"\wp", "B", "rm:B"];

/// Names of a function of two arguments.
pub(crate) const BETA: &[&str] = &["B", "rm:B"];

/// Names that print as functions where one term with a sign stands in the parentheses: `g(-x)`.
pub(crate) const EVEN_OR_ODD: &[&str] = &["g", "h", "F", "G", "H"];

/// Names that print as functionals before square brackets, also where these hold several terms: `S[q+\eta]`, `E[X+Y]`.
pub(crate) const FUNCTIONALS: &[&str] =
    &["S", "E", "J", "P", "bb:E", "rm:E", "cal:S", "cal:L", "cal:F", "cal:H", "cal:A"];

/// Names that are numbers to every reader, and no functions: what stands in parentheses behind them is a factor.
pub(crate) const NUMBERS: &[&str] = &[r"\hbar"];

/// Of functions that everybody knows: what they are called.
pub(crate) fn known_function(name: &str) -> Option<&'static str> {
    Some(match name {
        r"\Gamma" => "the gamma function",
        r"\delta" => "Dirac's δ",
        r"\Theta" => "a step",
        r"\zeta" => "the zeta function",
        r"\wp" => "Weierstraß's function",
        "B" | "rm:B" => "the beta function",
        _ => return None,
    })
}

/// The name without primes, accents, a style that marks a vector, and a label above.
pub(crate) fn base(mut name: &str) -> &str {
    while let (Some(style), bare) = name::split(name)
        && (name::marks_tensor(style) || name::is_accent(style))
    {
        name = bare;
    }
    name::labelled(name).map_or(name, |(bare, _)| bare).trim_end_matches('\'')
}

/// Whether a name before brackets could be taken for a function or a functional, whatever stands in them.
pub(crate) fn prints_as_function(name: &str) -> bool {
    [FUNCTIONS, EVEN_OR_ODD, FUNCTIONALS].iter().any(|names| names.contains(&base(name)))
}

/// Whether a name before a function could be an operator that acts on it.
pub(crate) fn prints_as_operator(name: &str) -> bool {
    matches!(name, r"\Delta" | r"\delta")
}
