//! What is kept of a declaration.

use super::super::name;
use super::super::syntax::{Name, SubItem, indices};
use expr::{Expr, Leaf, Shape, Symbol, Tensor};

/// What a symbol is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Role {
    /// The independent variable of motions.
    Time,
    /// Moved by a system, or given by a formula of a motion.
    State,
    /// Given by a number for each motion.
    Parameter,
    /// Computed from states; has a value and rates of its own along a motion.
    Observable,
    /// Short for its formula.
    Abbreviation,
    /// Stands for what a function is applied to.
    Argument,
    /// An independent variable of fields.
    Coordinate,
    /// Depends on coordinates: any smooth function of them, or given by a formula.
    Field,
}

/// One item of a subscript in a key.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Pattern {
    Literal(SubItem),
    Index,
}

/// What stands in parentheses in a key.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Arguments {
    None,
    /// Declared symbols: part of the name.
    Literal(String),
    /// Formal arguments of a function.
    Formal(Vec<(Symbol, Shape)>),
    /// The coordinates of a field, as they are written; they may be left out. Of a function of anything else, `L(q,\dot q,t)`, they are
    /// coordinates that nothing names.
    Coordinates(String, Vec<Leaf>),
}

#[derive(Clone, Debug)]
pub(super) struct Entry {
    pub key: String,
    pub name: Name,
    pub sub: Vec<Pattern>,
    pub arguments: Arguments,
    pub symbol: Symbol,
    pub role: Role,
    pub definition: Option<Tensor>,
    pub moving: bool,
    pub rank: usize,
    pub complex: bool,
    pub angle: bool,
    pub labelled: bool,
    /// Of a coordinate that is not Cartesian.
    pub scale: Option<Expr>,
    /// Of a function of what is no coordinate: where it is taken, where nothing else is written.
    pub place: Vec<Expr>,
}

/// Whether what stands in the parentheses makes two names one.
pub(super) fn same_kind(a: &Arguments, b: &Arguments) -> bool {
    match (a, b) {
        (Arguments::Formal(_), Arguments::Formal(_)) => true,
        _ => a == b,
    }
}

/// How many indices of components a subscript has, where it could be such.
pub(super) fn like_indices(sub: &[Pattern]) -> Option<usize> {
    let is_index = |item: &SubItem| match item {
        // Components are counted from 1: `B_0` is none of a vector `{\bf B}`.
        SubItem::Digit(digit) => *digit > 0,
        SubItem::Name(letter) => name::is_index(letter),
        SubItem::Other(_) => false,
    };
    let all = indices(&labels(sub)?);
    (!all.is_empty() && all.iter().all(is_index)).then_some(all.len())
}

/// The labels of a subscript that has no indices.
pub(super) fn labels(pattern: &[Pattern]) -> Option<Vec<SubItem>> {
    let label = |p: &Pattern| if let Pattern::Literal(item) = p { Some(item.clone()) } else { None };
    pattern.iter().map(label).collect()
}
