//! The signs of differences, `\Delta` and `\delta`: whether a paper uses them for names only.
//!
//! **In:** the formulas of a paper. **Out:** the signs that make one name with what stands behind them. **Guaranteed:** a sign that is a factor, an
//! operator or a function anywhere in the paper makes no name.

use std::collections::BTreeSet;

use super::names::letters::{BOLD, DOTS, FRACTIONS, HATS, SIGNS_OF_DIFFERENCES as SIGNS, STYLES, is_letter_command};
use super::token::{Kind, Token};

/// The signs that a paper uses otherwise than before a name.
#[derive(Clone, Debug, Default)]
pub struct DifferenceSigns {
    otherwise: BTreeSet<&'static str>,
}

impl DifferenceSigns {
    /// Whether a sign and the name behind it are one name in this paper.
    pub fn makes_names(&self, sign: &str) -> bool {
        !self.otherwise.contains(sign)
    }

    /// Looks at a formula, whether it relates something or not.
    pub(crate) fn note(&mut self, tokens: &[Token]) {
        let printed: Vec<&Token> = tokens.iter().filter(|t| t.kind != Kind::Space).collect();
        for (at, token) in printed.iter().enumerate().filter(|(_, t)| t.kind == Kind::Command) {
            let Some(sign) = SIGNS.iter().find(|s| s.strip_prefix('\\') == Some(token.text.as_str())) else { continue };
            let before = at.checked_sub(1).map(|k| printed[k]);
            // A label is no factor, nor is a name that has one: `x_\Delta`, `\Delta_r H`.
            let is_label = before.is_some_and(|t| t.is_char("_"));
            let has_label = *sign == r"\Delta" && printed.get(at + 1).is_some_and(|t| t.is_char("_"));
            let is_argument = before.is_some_and(|t| t.is_char("^") || is_wanting(t));
            let next = printed[at + 1..].iter().find(|t| t.kind != Kind::Open);
            let is_applied = *sign == r"\Delta" && is_group(&printed[at + 1..]);
            if is_argument || !is_label && !has_label && !is_applied && !next.is_some_and(|t| begins_name(t)) {
                self.otherwise.insert(*sign);
            }
        }
    }
}

/// Whether a group begins here of which a difference is taken, `\Delta(mv)`: not a name alone, which would be a place, `\Delta(x)`.
fn is_group(printed: &[&Token]) -> bool {
    let is_size =
        |t: &Token| t.kind == Kind::Command && matches!(t.text.as_str(), "left" | "big" | "Big" | "bigl" | "Bigl");
    let from = usize::from(printed.first().is_some_and(|t| is_size(t)));
    if !printed.get(from).is_some_and(|t| t.is_char("(") || t.is_char("[")) {
        return false;
    }
    let inside = printed[from + 1..].iter().take_while(|t| !t.is_char(")") && !t.is_char("]") && !t.is("right"));
    let letters = inside.clone().filter(|t| begins_name(t)).count();
    letters > 1 && !inside.clone().any(|t| t.is_char(","))
}

/// Whether a command takes what stands behind it as its argument.
fn is_wanting(token: &Token) -> bool {
    let command = token.text.as_str();
    token.kind == Kind::Command
        && (matches!(command, "sqrt" | "partial" | "nabla" | "operatorname")
            || FRACTIONS.contains(&command)
            || BOLD.contains(&command)
            || HATS.contains(&command)
            || STYLES.contains(&command)
            || DOTS.iter().any(|(d, _)| *d == command))
}

/// Whether a name begins here, which is not the sign of another difference.
fn begins_name(token: &Token) -> bool {
    let command = token.text.as_str();
    match token.kind {
        Kind::Other => token.text.chars().all(char::is_alphabetic),
        Kind::Command => {
            is_letter_command(command) && !matches!(command, "Delta" | "delta" | "pi")
                || is_wanting(token) && command != "sqrt"
        }
        _ => false,
    }
}
