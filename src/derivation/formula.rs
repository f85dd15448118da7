//! Formulas as they are written, with what they mean.

use std::ops::Range;

use expr::{Expr, Leaf};

/// A formula as written, where it stands, and what it means.
#[derive(Clone, Debug)]
pub struct Written<T> {
    /// The formula as the file has it, without what surrounds it.
    pub text: String,
    /// Its place in the file: `source.text[span]` is `text`.
    pub span: Range<usize>,
    /// What it means.
    pub value: T,
}

/// One component of a symbol, and the values that it has in a claim over ranges.
#[derive(Clone, Debug)]
pub struct Ranged {
    /// The component, at the present time.
    pub leaf: Leaf,
    /// Its values.
    pub values: Values,
    /// The formula as written, of a value that depends on others.
    pub formula: Option<String>,
    /// The unit of the symbol as written.
    pub unit: Option<String>,
    /// Where the values stand in the file.
    pub span: Range<usize>,
}

/// The values of a component.
#[derive(Clone, Debug)]
pub enum Values {
    /// All numbers from the first to the last, both included: expressions without leaves.
    Between(Expr, Expr),
    /// One value, which may depend on those that are given before it.
    One(Expr),
}
