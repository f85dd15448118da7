//! How the variables of a certificate are called, and its polynomials written.
//!
//! **In:** symbols of formulas, and the variables that lowering made. **Out:** names that are words in Python and in Lean, each once,
//! and polynomials as both languages write them. **Guaranteed:** no name is one that the text of a certificate uses itself.

use super::generators::Generator;
use super::lowering::Lowered;
use super::ring::Poly;
use expr::{Expr, Graph, Leaf, Node, Op};
use num_bigint::BigInt;
use num_traits::{One, Zero};

/// A polynomial with integer coefficients, as Python writes it.
pub(super) fn python(p: &Poly, names: &[String]) -> String {
    let mut out = String::new();
    for (m, c) in &p.terms {
        let coefficient = c.big().numer().clone();
        let negative = coefficient < BigInt::zero();
        out.push_str(match (out.is_empty(), negative) {
            (true, false) => "",
            (true, true) => "-",
            (false, false) => " + ",
            (false, true) => " - ",
        });
        let size = if negative { -coefficient } else { coefficient };
        let mut parts = Vec::new();
        for (name, &k) in names.iter().zip(m.exps()).filter(|(_, k)| **k > 0) {
            parts.push(if k == 1 { name.clone() } else { format!("{name}**{k}") });
        }
        if !size.is_one() || parts.is_empty() {
            parts.insert(0, size.to_string());
        }
        out.push_str(&parts.join("*"));
    }
    if out.is_empty() { "0".to_owned() } else { out }
}

/// Words that are no names in Python or in Lean, and names that the texts use.
const TAKEN: &[&str] = &[
    "False",
    "None",
    "True",
    "and",
    "as",
    "assert",
    "async",
    "await",
    "break",
    "class",
    "continue",
    "def",
    "del",
    "elif",
    "else",
    "except",
    "finally",
    "for",
    "from",
    "global",
    "if",
    "import",
    "in",
    "is",
    "lambda",
    "nonlocal",
    "not",
    "or",
    "pass",
    "raise",
    "return",
    "try",
    "while",
    "with",
    "yield",
    "print",
    "expand",
    "symbols",
    "d",
    "N",
    "D",
    "sqrt",
    "Abs",
    "sin",
    "cos",
    "tan",
    "exp",
    "log",
    "sinh",
    "cosh",
    "tanh",
    "asin",
    "acos",
    "atan",
    "atan2",
    "agm",
    "power",
    "pi",
    "at",
    "by",
    "do",
    "end",
    "fun",
    "have",
    "let",
    "match",
    "open",
    "show",
    "then",
    "where",
    "theorem",
    "def",
    "example",
    "axiom",
    "variable",
    "section",
    "namespace",
    "instance",
    "structure",
    "universe",
    "local",
    "macro",
    "mutual",
    "partial",
    "private",
    "protected",
    "unsafe",
    "notation",
    "prefix",
    "infix",
    "syntax",
    "calc",
    "suffices",
    "obtain",
    "key",
    "top",
    "same",
    "set_option",
    "deriving",
    "extends",
    "include",
    "omit",
    "attribute",
    "noncomputable",
    "opaque",
    "abbrev",
];

/// Names that Python and Lean accept, one for each variable.
pub(super) fn names_of(graph: &Graph, lowered: &Lowered, variables: &[Expr]) -> Vec<String> {
    let mut list: Vec<String> = Vec::new();
    for &e in variables {
        let wish = match *graph.node(e) {
            Node::Leaf(leaf) => match lowered.generators.get(leaf) {
                Some(Generator::Cosine(a)) => format!("cos{}", argument(graph, *a)),
                Some(Generator::Sine(a)) => format!("sin{}", argument(graph, *a)),
                Some(Generator::Exponential(a)) => format!("exp{}", argument(graph, *a)),
                Some(_) => "f".to_owned(),
                None => leaf_name(graph, leaf),
            },
            Node::Unary(Op::Sqrt, _) => "root".to_owned(),
            _ => "absolute".to_owned(),
        };
        let name = free(wish, &list);
        list.push(name);
    }
    list
}

/// A name that is not taken, as near to this one as there is.
pub(super) fn free(wish: String, list: &[String]) -> String {
    // A certificate's text has relations p1, p2 …, cofactors q1, q2 …, and parts of long texts e1, e2 …, f1, f2 …
    let numbered = |name: &str| {
        let rest = name.strip_prefix(['p', 'q', 'e', 'f', 'h']);
        rest.is_some_and(|n| !n.is_empty() && n.bytes().all(|b| b.is_ascii_digit()))
    };
    let is_free = |name: &String| !list.contains(name) && !TAKEN.contains(&name.as_str()) && !numbered(name);
    match is_free(&wish) {
        true => wish,
        false => (2..).map(|n| format!("{wish}_{n}")).find(is_free).unwrap_or(wish),
    }
}

fn argument(graph: &Graph, e: Expr) -> String {
    match *graph.node(e) {
        Node::Leaf(leaf) => format!("_{}", leaf_name(graph, leaf)),
        _ => String::new(),
    }
}

/// The letters and digits of a leaf's LaTeX name, without the commands for its typeface.
pub(super) fn leaf_name(graph: &Graph, leaf: Leaf) -> String {
    let mut text = graph.name(leaf.symbol).to_owned();
    for face in [r"\boldsymbol", r"\mathbf", r"\mathrm", r"\mathcal", r"\vec", r"\bf", r"\rm"] {
        text = text.replace(face, "");
    }
    let mut out: String = text.chars().filter(char::is_ascii_alphanumeric).collect();
    if !out.starts_with(|c: char| c.is_ascii_alphabetic()) {
        out.insert(0, 'x');
    }
    out.extend(graph.component_indices(leaf.symbol, leaf.component).iter().map(u16::to_string));
    out.push_str(match leaf.rate {
        0 => "",
        1 => "_dot",
        2 => "_ddot",
        _ => "_rate",
    });
    for coordinate in graph.coordinates().zip(leaf.partials.orders()).filter(|(_, n)| *n > 0) {
        let (by, n) = coordinate;
        out.push_str(&format!("_d{}{}", leaf_name(graph, by), if n > 1 { n.to_string() } else { String::new() }));
    }
    if leaf.instant.is_some() {
        out.push_str("_then");
    }
    out
}
