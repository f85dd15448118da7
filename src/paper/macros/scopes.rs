//! Where definitions begin and end to hold: groups, formulas, environments, cells.
//!
//! **In:** the tokens of a document, aliases resolved. **Out:** the scopes of [`Defined`](super::defined::Defined). **Guaranteed:** what ends nothing
//! that has begun ends nothing.

use super::super::displays::has_cells;
use super::super::token::{Kind, Token};
use super::Expander;
use super::defined::{DefinitionScope, Definitions};
use super::rest::name_ahead;

impl Expander<'_, '_> {
    /// Begins or ends what definitions stand in.
    pub(super) fn scope(&mut self, token: &Token) {
        if self.definitions == Definitions::OfTheWhole {
            return;
        }
        match token.kind {
            Kind::Open => {
                let scope = if self.behind.is_unknown() { DefinitionScope::Argument } else { DefinitionScope::Braces };
                self.defined.begin(scope);
            }
            Kind::Close => self.defined.end(&DefinitionScope::Braces),
            // A formula of the running text ends with its paragraph.
            Kind::Space
                if token.text.contains('\n') && self.defined.innermost() == Some(&DefinitionScope::Formula("$")) =>
            {
                self.defined.end(&DefinitionScope::Formula("$"));
            }
            Kind::Dollar => self.dollar(token),
            Kind::Other if token.text == "&" => self.next_cell(),
            Kind::Command => self.scope_of(token),
            _ => {}
        }
    }

    fn scope_of(&mut self, token: &Token) {
        let defined = &mut self.defined;
        match token.text.as_str() {
            "begingroup" | "bgroup" => defined.begin(DefinitionScope::Group),
            "endgroup" | "egroup" => defined.end(&DefinitionScope::Group),
            "[" => defined.begin(DefinitionScope::Formula("[")),
            "(" => defined.begin(DefinitionScope::Formula("(")),
            "left" => defined.begin(DefinitionScope::Formula("left")),
            "right" => defined.end(&DefinitionScope::Formula("left")),
            "]" => defined.end(&DefinitionScope::Formula("[")),
            ")" => defined.end(&DefinitionScope::Formula("(")),
            "\\" | "cr" | "tabularnewline" => self.next_cell(),
            "begin" => {
                let name = name_ahead(&self.rest);
                if name != "document" {
                    self.begin_environment(name);
                }
            }
            "end" => {
                let name = name_ahead(&self.rest);
                // What the end of an own environment does stands in it, too.
                if !defined.has_environment(&name) {
                    defined.end(&DefinitionScope::Environment(name));
                }
            }
            _ => {}
        }
    }

    /// An environment begins, and its first cell.
    pub(super) fn begin_environment(&mut self, name: String) {
        let has_cells = has_cells(&name) && !self.defined.has_environment(&name);
        self.defined.begin(DefinitionScope::Environment(name));
        if has_cells {
            self.defined.begin(DefinitionScope::Cell);
        }
    }

    /// A cell ends, and the next one begins.
    fn next_cell(&mut self) {
        if self.defined.innermost() == Some(&DefinitionScope::Cell) {
            self.defined.end(&DefinitionScope::Cell);
            self.defined.begin(DefinitionScope::Cell);
        }
    }

    /// Begins or ends a formula at a dollar, or at the first of two.
    fn dollar(&mut self, token: &Token) {
        let is_doubled = token.is_doubled_by(self.rest.last().map(|(t, _)| t));
        let defined = &mut self.defined;
        match defined.innermost() {
            Some(DefinitionScope::Formula("$")) => defined.end(&DefinitionScope::Formula("$")),
            // The second of two ends nothing: it stands alone between the two that count.
            Some(DefinitionScope::Formula("$$")) if is_doubled => {
                defined.end(&DefinitionScope::Formula("$$"));
                defined.begin(DefinitionScope::Formula("second"));
            }
            Some(DefinitionScope::Formula("second")) => defined.end(&DefinitionScope::Formula("second")),
            Some(DefinitionScope::Formula("$$")) => {}
            _ if is_doubled => defined.begin(DefinitionScope::Formula("$$")),
            _ => defined.begin(DefinitionScope::Formula("$")),
        }
    }
}
