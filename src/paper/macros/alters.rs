//! Commands that are not read and may give a name another meaning.
//!
//! **In:** a command that is printed as it stands, and what follows it. **Out:** doubt of the name that it is told. **Why:** packages have hundreds of
//! commands that define, patch and set; of one that is not known it is only known that what it names may mean something else from there on.

use super::super::displays::is_display;
use super::super::token::{Kind, Token};
use super::Expander;
use super::behind::is_known;
use super::define::name_of;
use super::defined::Definitions;
use super::rest::{MOST_NAME, Rest, argument, next_is};

/// Parts of the names of commands that give names a meaning.
const PARTS: &[&str] = &[
    "def", "let", "set", "new", "provide", "declare", "command", "cmd", "appto", "preto", "addto", "append", "prepend",
    "patch", "robust", "swap", "count", "store", "save", "eval", "macro", "copy", "font", "foreach", "read", "chardef",
];

/// Whether the name of a command says that it gives names a meaning.
fn says_so(command: &str) -> bool {
    let small = command.to_lowercase();
    PARTS.iter().any(|part| small.contains(part))
}

/// Whether the name of a command says that it takes names without their backslash.
fn takes_written_names(command: &str) -> bool {
    command.starts_with("cs") || command.starts_with('@') || command.contains("name") || command.contains("cs")
}

/// The name that comes next, and whether it stands in braces alone.
enum Told {
    Bare(String),
    Braced(String),
    Written(Vec<Token>),
    Nothing,
}

fn told(rest: &Rest) -> Told {
    let is_passed = |t: &&Token| t.kind == Kind::Space || t.is_char("*");
    let mut next = rest.iter().rev().map(|(t, _)| t).skip_while(is_passed);
    match next.next() {
        Some(t) if t.kind == Kind::Command => Told::Bare(t.text.to_string()),
        Some(t) if t.kind == Kind::Open => {
            let inside: Vec<&Token> = next.by_ref().take(MOST_NAME).take_while(|t| t.kind != Kind::Close).collect();
            match inside.iter().filter(|t| t.kind != Kind::Space).collect::<Vec<_>>().as_slice() {
                [one] if one.kind == Kind::Command => Told::Braced(one.text.to_string()),
                _ => Told::Written(inside.into_iter().cloned().collect()),
            }
        }
        _ => Told::Nothing,
    }
}

/// Whether a name is one of the two commands of a display: what is put before or behind them changes how it looks.
fn is_of_display(name: &str) -> bool {
    is_display(name.strip_prefix("end").unwrap_or(name)) || name == "[" || name == "]"
}

/// Parts of the names of commands that put something before or behind what a name does, or exchange a part of it.
const PATCHES: &[&str] = &["pre", "app", "patch", "addto"];

impl Expander<'_, '_> {
    /// Puts the name in doubt that a command, which is printed as it stands, may give another meaning; the name itself is taken. In a formula none does.
    pub(super) fn doubt_altered(&mut self, token: &Token) {
        let command = token.text.as_str();
        if self.definitions == Definitions::OfTheWhole || is_known(command) || self.defined.is_in_formula() {
            return;
        }
        let says_so = says_so(command);
        let name = match told(&self.rest) {
            Told::Bare(name) | Told::Braced(name) if says_so => Some(name),
            // In the preamble nothing is printed.
            Told::Braced(name) if self.at_begin.is_some() => Some(name).filter(|name| self.defined.is_own(name)),
            Told::Written(name) if says_so && takes_written_names(command) => name_of(&name, &self.defined),
            _ => None,
        };
        let Some(name) = name else { return };
        if says_so {
            next_is(&mut self.rest, "*");
            argument(&mut self.rest);
        }
        let is_patch = PATCHES.iter().any(|part| command.to_lowercase().contains(part));
        if self.defined.packages > 0 && !self.defined.is_own(&name) || is_patch && is_of_display(&name) {
            return;
        }
        let is_global = std::mem::replace(&mut self.defined.is_global, true);
        self.defined.doubt(&name);
        self.defined.is_global = is_global;
    }
}
