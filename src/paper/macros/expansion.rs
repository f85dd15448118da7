//! Names that are put together, and tokens that TeX expands before others: `\csname x\endcsname`, `\expandafter`.
//!
//! **In:** these commands, and what follows. **Out:** what they leave. **Guaranteed:** a name that cannot be told stays as it is written.

use super::super::note::PaperNote;
use super::super::token::{Kind, Token};
use super::rest::MOST_NAME;
use super::{DEEPEST, Endless, Expander};

/// The command that stands where a name cannot be told; no text has it.
const UNKNOWN_NAME: &str = "unknown name";

/// The most `\expandafter` and `\csname` that wait for each other.
const MOST_WAITING: usize = 30;

impl Expander<'_, '_> {
    /// Takes a command that makes names, or that expands what follows; whether it was one.
    pub(super) fn expand_names(&mut self, token: &Token, depth: usize) -> Result<bool, Endless> {
        match token.text.as_str() {
            "csname" => {
                self.calls += 1;
                self.make_name(token, depth, 0)?;
                Ok(true)
            }
            "expandafter" => {
                self.calls += 1;
                self.expand_after(0)?;
                Ok(true)
            }
            _ => Ok(false),
        }
    }

    /// At `\csname`: puts the command of that name there; a name that cannot be told is no other one, and that is noted.
    fn make_name(&mut self, token: &Token, depth: usize, waiting: usize) -> Result<(), Endless> {
        let mut name = Some(String::new());
        let mut left = MOST_NAME;
        while left > 0
            && let Some((next, its_depth)) = self.rest.pop()
        {
            left -= 1;
            match next.kind {
                Kind::Command if next.is("endcsname") => break,
                Kind::Command if next.is("expandafter") && waiting < MOST_WAITING => self.expand_after(waiting + 1)?,
                Kind::Command if next.is("csname") && waiting < MOST_WAITING => {
                    self.make_name(&next, its_depth, waiting + 1)?;
                }
                Kind::Command if self.is_known_macro(&next.text) && its_depth < DEEPEST => {
                    self.call_macro(next, its_depth)?;
                }
                Kind::Other | Kind::Space => {
                    if let Some(name) = &mut name {
                        name.push_str(&next.text);
                    }
                }
                _ => name = None,
            }
        }
        if left == 0 {
            name = None;
        }
        if name.is_none() && self.defined.packages == 0 {
            let message = "this name is put together in a way that is not read: what is defined under it is not known";
            self.notes.push(PaperNote { message: message.to_owned(), span: token.span.clone() });
        }
        let text = name.map_or(UNKNOWN_NAME.to_owned(), |name| name.trim().to_owned());
        self.rest.push((Token { kind: Kind::Command, text: text.into(), span: token.span.clone() }, depth));
        Ok(())
    }

    /// Whether a name is that of a macro of which it is known what it prints.
    fn is_known_macro(&self, name: &str) -> bool {
        self.defined.macro_of(name).is_some() && !self.defined.is_doubted(name)
    }

    /// At `\expandafter`: expands what stands behind the next token, once.
    fn expand_after(&mut self, waiting: usize) -> Result<(), Endless> {
        let Some(first) = self.rest.pop() else { return Ok(()) };
        if let Some((next, its_depth)) = self.rest.pop() {
            if next.is("expandafter") && waiting < MOST_WAITING {
                self.expand_after(waiting + 1)?;
            } else if next.is("csname") && waiting < MOST_WAITING {
                self.make_name(&next, its_depth, waiting + 1)?;
            } else if next.kind == Kind::Command && its_depth < DEEPEST && self.is_known_macro(&next.text) {
                self.call_macro(next, its_depth)?;
            } else {
                self.rest.push((next, its_depth));
            }
        }
        self.rest.push(first);
        Ok(())
    }
}
