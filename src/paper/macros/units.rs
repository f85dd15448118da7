//! Arguments of the macros of LaTeX: `\\frac1\\xx` prints all of `\\xx` below.
//!
//! **In:** the tokens that are printed, one by one. **Out:** whether an argument of such a macro comes next. **Guaranteed:** what TeX itself takes, behind
//! `^`, `_` or `\\sqrt` without an option, is no such argument: there a macro is expanded first. Of accents packages decide that.

use super::super::takes::{ACCENTS, TAKES};
use super::super::token::{Kind, Token};
use super::rest::Macro;

/// Where arguments are still to come.
#[derive(Default)]
pub(super) struct Units {
    /// The accent that stands last.
    accent: Option<Token>,
    /// In the option of a root: how many brackets are open, in which braces.
    option: Option<(usize, usize)>,
    /// How deep it is in braces.
    depth: usize,
    /// For each macro that waits: how deep it stands, and how many arguments it has not yet.
    waiting: Vec<(usize, usize)>,
}

/// Whether an argument that is this macro has to be put in braces: it needs no argument, and prints more than one token.
pub(super) fn needs_braces(found: &Macro) -> bool {
    let is_alone = found.arguments == usize::from(found.default.is_some()) && found.pattern.is_empty();
    is_alone && found.body.iter().filter(|t| t.kind != Kind::Space).nth(1).is_some()
}

impl Units {
    /// Whether an argument comes next.
    pub fn waits(&self) -> bool {
        self.waiting.last().is_some_and(|(depth, _)| *depth == self.depth)
    }

    /// The accent over what comes next.
    pub fn accent(&self) -> Option<&Token> {
        self.accent.as_ref()
    }

    /// Takes a token that is printed; a root may have an option.
    pub fn take(&mut self, token: &Token, has_option: bool) {
        if token.kind == Kind::Space {
            return;
        }
        self.accent = (token.kind == Kind::Command && ACCENTS.contains(&token.text.as_str())).then(|| token.clone());
        if has_option {
            self.option = Some((0, self.depth));
            return;
        }
        if let Some((brackets, depth)) = self.option {
            let step = usize::from(token.is_char("["));
            let open =
                if token.is_char("]") && depth == self.depth { brackets.saturating_sub(1) } else { brackets + step };
            self.option = (open > 0).then_some((open, depth));
            if open == 0 {
                self.waiting.push((self.depth, 1));
                return;
            }
        }
        match token.kind {
            Kind::Open => {
                self.depth += 1;
                return;
            }
            Kind::Close => {
                self.depth = self.depth.saturating_sub(1);
                while self.waiting.last().is_some_and(|(depth, _)| *depth > self.depth) {
                    self.waiting.pop();
                }
            }
            // `\\cfrac[l]`
            _ if token.is_char("[") && self.waits() => {
                self.waiting.pop();
            }
            _ => {}
        }
        if self.waits()
            && let Some((_, left)) = self.waiting.last_mut()
        {
            *left -= 1;
            if *left == 0 {
                self.waiting.pop();
            }
        }
        if token.kind == Kind::Command
            && let Some((_, count)) = TAKES.iter().find(|(name, _)| *name == token.text)
        {
            self.waiting.push((self.depth, *count));
        }
    }
}
