//! How many arguments commands take.
//!
//! **In:** a command, and the tokens behind it. **Out:** which of these are its arguments. **Guaranteed:** of a command that is not known all groups
//! right behind it are.

use super::token::{Kind, Token};

/// Macros of LaTeX, and how many arguments each has.
pub(super) const TAKES: &[(&str, usize)] = &[
    ("frac", 2),
    ("dfrac", 2),
    ("tfrac", 2),
    ("cfrac", 2),
    ("nicefrac", 2),
    ("sfrac", 2),
    ("binom", 2),
    ("dbinom", 2),
    ("tbinom", 2),
    ("stackrel", 2),
    ("overset", 2),
    ("underset", 2),
    ("mathrm", 1),
    ("mathbf", 1),
    ("mathit", 1),
    ("mathsf", 1),
    ("mathcal", 1),
    ("mathbb", 1),
    ("mathfrak", 1),
    ("mathscr", 1),
    ("boldsymbol", 1),
    ("bm", 1),
    ("text", 1),
    ("textrm", 1),
    ("mbox", 1),
    ("operatorname", 1),
    ("overbrace", 1),
    ("underbrace", 1),
    ("boxed", 1),
];

/// Accents: of TeX they take the first token of a macro, of amsmath all of it.
pub(super) const ACCENTS: &[&str] = &[
    "hat",
    "check",
    "breve",
    "acute",
    "grave",
    "tilde",
    "bar",
    "vec",
    "dot",
    "ddot",
    "dddot",
    "widehat",
    "widetilde",
    "mathring",
    "overline",
    "underline",
];

/// Derivatives of packages: what stands behind their first argument is the next one, in braces or not.
const DERIVATIVES: &[&str] = &["dv", "pdv", "odv", "fdv", "derivative", "partialderivative", "functionalderivative"];

/// Whether a command says how large the delimiter behind it is.
fn is_size(command: &str) -> bool {
    let size = command.strip_prefix("big").or_else(|| command.strip_prefix("Big"));
    matches!(command, "left" | "right" | "middle")
        || size.is_some_and(|s| matches!(s, "" | "g" | "l" | "r" | "m" | "gl" | "gr" | "gm"))
}

/// How many arguments are still to come where a command of a formula stands.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Wanted {
    #[default]
    Nothing,
    /// So many tokens, or groups.
    Units(usize),
    /// All groups right behind it.
    Groups,
    /// The same, whatever stands between them.
    Any,
}

impl Wanted {
    /// What a token takes.
    pub fn by(token: &Token) -> Wanted {
        if token.kind != Kind::Command {
            return if token.is_char("_") || token.is_char("^") { Wanted::Units(1) } else { Wanted::Nothing };
        }
        let name = token.text.as_str();
        let is_letters = name.starts_with(|c: char| c.is_ascii_alphabetic());
        match TAKES.iter().find(|(known, _)| *known == name) {
            Some((_, count)) => Wanted::Units(*count),
            None if ACCENTS.contains(&name) || name == "sqrt" => Wanted::Units(1),
            None if DERIVATIVES.contains(&name) => Wanted::Any,
            None if !is_letters || latex::is_letter_command(name) || is_size(name) => Wanted::Nothing,
            None => Wanted::Groups,
        }
    }

    /// Whether a group that comes next is an argument.
    pub fn takes_group(self) -> bool {
        self != Wanted::Nothing
    }

    /// What is wanted behind one argument more, that is a group or not.
    pub fn less_one(self, is_group: bool) -> Wanted {
        match self {
            Wanted::Units(count) if count > 1 => Wanted::Units(count - 1),
            Wanted::Groups if is_group => Wanted::Groups,
            Wanted::Any => Wanted::Any,
            _ => Wanted::Nothing,
        }
    }
}
