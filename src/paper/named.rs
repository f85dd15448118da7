//! Commands that name files: what they name, and how it counts.
//!
//! **In:** –. **Out:** a table. **Why:** macros, chapters and inputs share it.

use std::ops::Range;

use super::token::Token;

/// Commands that name a file whose text stands in their place.
pub(super) const COMMANDS_OF_TEXT: &[&str] = &["input", "include", "subfile", "subfileinclude"];
/// Commands that name packages and classes.
pub(super) const PACKAGES: &[(&str, Named)] = &[
    ("usepackage", Named::Package),
    ("RequirePackage", Named::Package),
    ("documentclass", Named::Class),
    ("LoadClass", Named::Class),
];

/// The kind of a file that a document names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Named {
    /// A part of its text.
    Text,
    /// A package, of which only the definitions count.
    Package,
    /// A class, likewise.
    Class,
}

/// Gives the tokens of a file that the document names, if it may be read.
pub(super) type Input<'i> = dyn FnMut(&str, Named, &Range<usize>) -> Vec<Token> + 'i;
