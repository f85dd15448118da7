//! Names that are put together, and tokens that TeX expands before others: `\csname x\endcsname`, `\expandafter`.
//!
//! **In:** these commands, and what follows. **Out:** what they leave. **Guaranteed:** a name that cannot be told stays as it is written.

use super::super::token::{Kind, Token};
use super::define::name_of;
use super::rest::MOST_NAME;
use super::{DEEPEST, Endless, Expander};

/// The most `\expandafter` that wait for each other.
const MOST_WAITING: usize = 30;

impl Expander<'_, '_> {
    /// Takes a command that makes names, or that expands what follows; whether it was one.
    pub(super) fn expand_names(&mut self, token: &Token, depth: usize) -> Result<bool, Endless> {
        match token.text.as_str() {
            "csname" => Ok(self.make_name(token, depth)),
            "expandafter" => {
                self.calls += 1;
                self.expand_after(0)?;
                Ok(true)
            }
            _ => Ok(false),
        }
    }

    /// At `\csname`: puts the command of that name there.
    fn make_name(&mut self, token: &Token, depth: usize) -> bool {
        let ahead = self.rest.iter().rev().take(MOST_NAME);
        let Some(count) = ahead.map(|(t, _)| t).position(|t| t.is("endcsname")) else { return false };
        let from = self.rest.len() - count;
        let written: Vec<Token> = self.rest[from..].iter().rev().map(|(t, _)| t.clone()).collect();
        let Some(name) = name_of(&written, &self.defined) else { return false };
        self.rest.truncate(from - 1);
        self.rest.push((Token { kind: Kind::Command, text: name.into(), span: token.span.clone() }, depth));
        true
    }

    /// At `\expandafter`: expands what stands behind the next token, once.
    fn expand_after(&mut self, waiting: usize) -> Result<(), Endless> {
        let Some(first) = self.rest.pop() else { return Ok(()) };
        if let Some((next, its_depth)) = self.rest.pop() {
            let command = next.text.as_str();
            if next.is("expandafter") && waiting < MOST_WAITING {
                self.expand_after(waiting + 1)?;
            } else if next.is("csname") && self.make_name(&next, its_depth) {
                // That name stands there.
            } else if next.kind == Kind::Command
                && its_depth < DEEPEST
                && !self.defined.is_doubted(command)
                && self.defined.macro_of(command).is_some()
            {
                self.call_macro(next, its_depth)?;
            } else {
                self.rest.push((next, its_depth));
            }
        }
        self.rest.push(first);
        Ok(())
    }
}
