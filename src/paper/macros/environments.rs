//! Environments: `\begin{x}` does `\x` in a group, `\end{x}` does `\endx`.
//!
//! **In:** `\begin` and `\end`, and commands such as `\align` that begin an environment of LaTeX without a group. **Out:** what is printed.
//! **Guaranteed:** what stands in an environment that is not understood is in doubt.

use super::super::displays::is_display;
use super::super::token::{Kind, Token};
use super::branches::BranchForm;
use super::defined::DefinitionScope;
use super::rest::{argument, name_ahead};
use super::{END_OF_ENVIRONMENT, Endless, Expander, begins_group};

impl Expander<'_, '_> {
    /// Takes `\begin` or `\end`.
    pub(super) fn environment(&mut self, token: Token, depth: usize) -> Result<(), Endless> {
        let begins = token.is("begin");
        if begins && begins_group(&self.rest, "document") && self.at_begin.is_some() {
            argument(&mut self.rest);
            self.begin_document();
            self.print_name("begin", "document", &token);
            return Ok(());
        }
        let name = name_ahead(&self.rest);
        if !self.defined.has_environment(&name) {
            self.print(token);
            if !begins {
                self.end_doubt(&BranchForm::Environment(name));
            }
            return Ok(());
        }
        argument(&mut self.rest);
        if begins && self.defined.is_doubted(&name) {
            let named = Token { kind: Kind::Command, text: name.as_str().into(), span: token.span.clone() };
            let doubt = self.doubts.of_meaning(&named);
            self.open(BranchForm::Environment(name.clone()), Some(doubt));
        }
        let does = if begins { name.clone() } else { format!("end{name}") };
        if !begins {
            self.put_behind(&format!("{END_OF_ENVIRONMENT}{name}"), token.span.clone(), depth);
        }
        let does = Token { kind: Kind::Command, text: does.into(), span: token.span };
        if self.defined.macro_of(&does.text).is_some() {
            self.call_macro(does, depth)
        } else {
            if self.defined.alias(&does.text).is_some() {
                self.rest.push((does, depth + 1));
            } else if is_display(&name) {
                // What was done to it is not understood, or to its other half alone: it is a display.
                self.print_environment(if begins { "begin" } else { "end" }, &name, &does);
            }
            Ok(())
        }
    }

    /// Prints the beginning or the end of a display that a command begins or ends.
    pub(super) fn print_environment(&mut self, which: &str, name: &str, token: &Token) {
        match which {
            "begin" => self.begin_environment(name.to_owned()),
            _ => self.defined.end(&DefinitionScope::Environment(name.to_owned())),
        }
        self.print_name(which, name, token);
    }

    fn print_name(&mut self, which: &str, name: &str, token: &Token) {
        let piece = |kind, text: &str| Token { kind, text: text.into(), span: token.span.clone() };
        self.print(piece(Kind::Command, which));
        self.print(piece(Kind::Open, "{"));
        for c in name.chars() {
            self.print(piece(Kind::Other, c.encode_utf8(&mut [0; 4])));
        }
        self.print(piece(Kind::Close, "}"));
    }
}
