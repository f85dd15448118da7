//! The shared graph of expressions.
//!
//! **In:** constants, leaves (components of symbols, their rates, their values at fixed times) and operations.
//! **Out:** [`Graph`], in which equal expressions are one node; [`Tensor`], an array of nodes; exact derivatives and
//! substitutions; LaTeX; [`tape::Tape`], the program that evaluates them.
//!
//! **Guaranteed:** the constructors never enlarge the domain of what they build: `0·x`, `x − x` and `x/x` are kept as they
//! are, since x may have no value. A child is always older than its parent, so every walk is a loop, never a recursion.
//!
//! **Why scalar nodes:** a formula with indices means one scalar equation per index value. Resolving indices and shapes
//! while reading leaves nothing for later rooms to misunderstand.

#![forbid(unsafe_code)]

mod calculus;
mod direction;
pub mod domain;
mod field;
mod graph;
mod hash;
mod marks;
mod place;
mod print;
pub mod tape;
mod tensor;
mod zero;

pub use calculus::NoDerivative;
pub use field::{HIGHEST_ORDER, MOST_COORDINATES, Partials};
pub use graph::{Expr, Graph, Leaf, Node, Symbol, combines, raised};
pub use hash::{FastHasher, FastMap, FastSet};
pub use number::{Op, Rational};
pub use place::{DEEPEST_PLACE, Place};
pub use tensor::{Part, Shape, Tensor};
