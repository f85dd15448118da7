//! The last side of a relation, while rows may still be added to it.
//!
//! **In:** tokens, row by row. **Out:** the side. **Why this way:** a side that goes on over thousands of rows is made once, at its end, and is not
//! looked at anew for each of them.

use super::super::token::{Kind, Token};
use super::side::{side_of, with_plain_spaces};
use super::{Nesting, PrintedSide, is_operator, is_space};

/// Tokens of a side that may go on.
#[derive(Default)]
pub(super) struct Last {
    tokens: Vec<Token>,
    /// How deep the end lies in brackets.
    pub nesting: Nesting,
    is_list: bool,
}

impl Last {
    /// Adds what stands in a row, up to its end or to a sign of relation.
    pub fn add(&mut self, tokens: &[Token]) {
        self.tokens.extend(with_plain_spaces(tokens));
        while self.tokens.last().is_some_and(|t| t.kind == Kind::Space) {
            self.tokens.pop();
        }
    }

    /// Adds a comma: what follows is another formula in the same place.
    pub fn begin_another(&mut self) {
        let end = self.tokens.last().map_or(0, |t| t.span.end);
        self.tokens.push(Token { kind: Kind::Other, text: ",".into(), span: end..end });
        self.is_list = true;
    }

    /// Whether it is not yet complete: nothing is there, it ends with a sign, or in an open bracket.
    pub fn waits(&self) -> bool {
        let printed = self.tokens.iter().rev().find(|t| !is_space(t));
        printed.is_none_or(is_operator) || self.nesting.brackets > 0
    }

    /// The side, and nothing is left.
    pub fn side(&mut self) -> PrintedSide {
        let Last { tokens, is_list, .. } = std::mem::take(self);
        let mut side = side_of(&tokens);
        side.is_list |= is_list;
        side
    }
}
