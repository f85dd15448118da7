//! What a text says: relations between tensors of expressions.

use std::ops::Range;

use super::syntax::RelationKind;
use expr::{Expr, Tensor};

/// Where a limit goes.
#[derive(Clone, Debug, PartialEq)]
pub enum LimitPoint {
    /// To a time.
    Finite(Expr),
    /// To +∞.
    PlusInfinity,
    /// To −∞.
    MinusInfinity,
}

/// A limit along the time.
#[derive(Clone, Debug, PartialEq)]
pub struct Limit {
    /// Where the time goes.
    pub approaches: LimitPoint,
}

/// Two sides and what is claimed of them.
#[derive(Clone, Debug, PartialEq)]
pub struct Relation {
    /// What is claimed.
    pub kind: RelationKind,
    /// The left side; what the limit is taken of, where there is one.
    pub left: Tensor,
    /// The right side, of the same shape.
    pub right: Tensor,
    /// The left side is a limit.
    pub limit: Option<Limit>,
    /// Names of the free indices, one for each axis; empty for index-free notation.
    pub indices: Vec<String>,
    /// Whether ± occurs: then the sides depend on [`Scope::branch_sign`](super::Scope::branch_sign).
    pub has_branches: bool,
    /// Its bytes.
    pub span: Range<usize>,
}

impl Relation {
    /// Whether it is meant for one of the signs of ±: `l \ne \pm r` says of both that they do not make the sides equal.
    pub fn chooses_sign(&self) -> bool {
        self.has_branches && self.kind != RelationKind::NotEqual
    }
}

/// A chain of relations, `a = b = c`.
#[derive(Clone, Debug, PartialEq)]
pub struct Statement {
    /// One relation for each sign of the chain.
    pub relations: Vec<Relation>,
    /// Its bytes.
    pub span: Range<usize>,
}

impl Statement {
    /// Whether two statements of one graph are the same, wherever they stand.
    pub fn says_the_same(&self, other: &Statement) -> bool {
        let same = |(a, b): (&Relation, &Relation)| {
            (a.kind, &a.left, &a.right, &a.limit, a.has_branches)
                == (b.kind, &b.left, &b.right, &b.limit, b.has_branches)
        };
        self.relations.len() == other.relations.len() && self.relations.iter().zip(&other.relations).all(same)
    }
}
