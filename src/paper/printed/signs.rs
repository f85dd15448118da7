//! Commands and characters of displays, by what they do: they relate, part statements, go on, print words, or space.

use super::super::token::{Kind, Token};

/// Signs that relate two sides.
pub(super) const RELATIONS: &[&str] = &[
    "equiv",
    "approx",
    "simeq",
    "sim",
    "cong",
    "propto",
    "ll",
    "gg",
    "le",
    "leq",
    "leqslant",
    "ge",
    "geq",
    "geqslant",
    "ne",
    "neq",
    "lesssim",
    "gtrsim",
    "to",
    "rightarrow",
    "longrightarrow",
    "mapsto",
    "longmapsto",
    "in",
    "notin",
    "subset",
    "subseteq",
    "doteq",
    "triangleq",
    "coloneqq",
    "coloneq",
    "eqqcolon",
    "asymp",
    "lt",
    "gt",
    "leftarrow",
    "perp",
    "parallel",
    "rightleftharpoons",
    "leftrightarrow",
    "xrightarrow",
    "eqsim",
    "approxeq",
    "thickapprox",
    "thicksim",
    "prec",
    "succ",
];

/// Signs between statements.
pub(super) const BETWEEN_STATEMENTS: &[&str] = &[
    "Rightarrow",
    "implies",
    "Longrightarrow",
    "iff",
    "Leftrightarrow",
    "Longleftrightarrow",
    "therefore",
    "because",
    "impliedby",
    "Leftarrow",
    "Longleftarrow",
];

/// Signs with which a formula goes on.
pub(super) const OPERATORS: &[&str] =
    &["+", "-", "/", "*", "·", "×", "−", "pm", "mp", "times", "cdot", "div", "wedge", "otimes", "oplus", "ast"];

/// Commands that print words.
pub(super) const WORDS: &[&str] = &[
    "text",
    "mbox",
    "hbox",
    "textrm",
    "textit",
    "textbf",
    "textnormal",
    "intertext",
    "shortintertext",
    "qq",
    "qqtext",
];

/// Words of the package physics, between wide spaces: `\\qand`, `\\qif`.
pub(super) const WIDE_WORDS: &[&str] = &[
    "if",
    "then",
    "else",
    "otherwise",
    "unless",
    "given",
    "using",
    "assume",
    "since",
    "let",
    "for",
    "all",
    "and",
    "or",
    "as",
];

/// Spaces.
pub(super) const SPACES: &[&str] = &[
    ",",
    ";",
    ":",
    ">",
    "!",
    " ",
    "\n",
    "\t",
    "thinspace",
    "medspace",
    "thickspace",
    "negthinspace",
    "enspace",
    "nonumber",
    "notag",
    "hfill",
    "hfil",
    "allowbreak",
    "noindent",
    "par",
    "break",
    "linebreak",
    "pagebreak",
    "allowdisplaybreaks",
    "relax",
    "protect",
    "strut",
    "displaystyle",
    "textstyle",
    "displaybreak",
    "quad",
    "qquad",
    "/",
    "centering",
    "nobreak",
    "null",
    "smallskip",
    "medskip",
];

pub fn is_space(token: &Token) -> bool {
    token.kind == Kind::Space
        || token.is_char("~")
        || token.kind == Kind::Command && SPACES.contains(&token.text.as_str())
}

pub fn is_wide(token: &Token) -> bool {
    token.is("quad") || token.is("qquad")
}

pub fn is_operator(token: &Token) -> bool {
    matches!(token.kind, Kind::Command | Kind::Other) && OPERATORS.contains(&token.text.as_str())
}

/// Whether a sign of relation says that both sides are the same, or nearly.
pub fn is_equality(token: &Token) -> bool {
    let signs =
        ["=", "≈", "≡", "∼", "equiv", "approx", "simeq", "sim", "cong", "doteq", "triangleq", "coloneqq", "coloneq"];
    signs.contains(&token.text.as_str())
}

pub fn is_relation(token: &Token) -> bool {
    match token.kind {
        Kind::Other => {
            matches!(token.text.as_str(), "=" | "<" | ">" | "≈" | "≤" | "≥" | "≠" | "≡" | "∼" | "∝" | "≪" | "≫")
        }
        Kind::Command => RELATIONS.contains(&token.text.as_str()),
        _ => false,
    }
}
