//! Formula text → expressions.
//!
//! **In:** LaTeX as a paper prints it, and a [`Scope`] of declared symbols. **Out:** [`Statement`]s (relations between
//! tensors of expressions) or a single [`Tensor`].
//!
//! **Guaranteed:** a text is consumed whole, with one meaning, or refused with [`Problem`]s that name the place and how to
//! write it. The reader never panics and never recurses without a limit. Nothing is guessed: an undeclared symbol, a
//! product that could be a function value, a denominator that could be longer are refused.
//!
//! **Path:** characters → tokens → syntax tree (`parse`) → meaning (`elaborate`). The page `docs/grammar.md` is the
//! reference of the language, and its examples are tests.

#![forbid(unsafe_code)]

mod alike;
mod complex;
mod convention;
mod elaborate;
mod expand;
mod feature;
mod invisible;
mod lexer;
mod macros;
mod name;
mod parse;
mod refusal;
mod scope;
mod statement;
pub mod syntax;
mod tensor;
mod typeset;
mod unicode;
mod write;

pub use feature::{Feature, feature, feature_of};
pub use name::{is_letter_command, sets_words};
pub use parse::{is_function, sign_of_nabla, whole_part};
pub use scope::{Declaration, DeclareError, Logarithm, NO_BASE, REFUSED, Role, Scope, Signature};
pub use statement::{Limit, LimitPoint, Relation, Statement};
pub use syntax::RelationKind;
pub use typeset::printed;
pub use unicode::{script as raised_or_lowered, spelled};

use diag::Problem;
use elaborate::Elaborator;
use expr::{Graph, Tensor};

/// Reads relations; several may stand in one text, separated by commas, `\\` or `\cr`.
///
/// # Errors
/// Everything that is wrong with the text.
pub fn read(text: &str, scope: &Scope, graph: &mut Graph) -> Result<Vec<Statement>, Vec<Problem>> {
    let chains = parse::chains(text, scope)?;
    let mut statements = Vec::new();
    let mut problems = Vec::new();
    for chain in &chains {
        match Elaborator::new(scope, graph).statement(chain) {
            Ok(statement) => statements.push(statement),
            Err(problem) => problems.push(*problem),
        }
    }
    if problems.is_empty() { Ok(statements) } else { Err(problems) }
}

/// The syntax trees of the relations of a text, for printing variants of them: see [`syntax::to_latex`].
///
/// # Errors
/// What is wrong with the text before its meaning is looked at.
pub fn parse(text: &str, scope: &Scope) -> Result<Vec<syntax::Chain>, Vec<Problem>> {
    parse::chains(text, scope)
}

/// The meaning of a syntax tree that was altered: what [`read`] would make of it, if it could be written so.
///
/// # Errors
/// What is wrong with it; places are those of the tree that it was made from.
pub fn elaborate(chain: &syntax::Chain, scope: &Scope, graph: &mut Graph) -> Result<Statement, Problem> {
    Elaborator::new(scope, graph).statement(chain).map_err(|problem| *problem)
}

/// The same for an expression.
///
/// # Errors
/// As for [`elaborate`].
pub fn elaborate_expression(node: &syntax::Node, scope: &Scope, graph: &mut Graph) -> Result<Tensor, Problem> {
    Elaborator::new(scope, graph).closed_expression(node).map_err(|problem| *problem)
}

/// Reads one expression that stands for one value: ± is refused, with its place. What is defined, given or measured is
/// read so.
///
/// # Errors
/// Everything that is wrong with the text.
pub fn read_quantity(text: &str, scope: &Scope, graph: &mut Graph) -> Result<Tensor, Vec<Problem>> {
    Elaborator::new(scope, graph).quantity(text)
}

/// Reads one expression.
///
/// # Errors
/// Everything that is wrong with the text.
pub fn read_expression(text: &str, scope: &Scope, graph: &mut Graph) -> Result<Tensor, Vec<Problem>> {
    Elaborator::new(scope, graph).expression(text)
}
