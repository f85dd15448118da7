//! Thin stand-in for the formula reader, replaced when that room is merged: it knows symbols and numbers only.

use std::ops::Range;

use crate::diag::Problem;
use crate::expr::{Expr, Graph, Shape, Symbol, Tensor};

/// What a symbol is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    Time,
    State,
    Parameter,
    Observable,
    Abbreviation,
    Argument,
}

/// How a symbol is declared.
pub struct Declaration<'a> {
    pub role: Role,
    pub shape: Option<Shape>,
    pub diagonal: bool,
    pub formula: Option<&'a str>,
    pub arguments: &'a [&'a str],
}

/// Why a declaration is refused.
pub enum DeclareError {
    Key(Problem),
    Formula(Vec<Problem>),
}

/// The declared symbols.
#[derive(Clone, Debug, Default)]
pub struct Scope(Vec<(String, Symbol, Role, Option<Tensor>)>);

impl Scope {
    pub fn new(_: &mut Graph) -> Scope {
        Scope::default()
    }
    pub fn declare(&mut self, graph: &mut Graph, key: &str, d: Declaration<'_>) -> Result<Symbol, DeclareError> {
        let definition = match d.formula {
            Some(text) => Some(read_expression(text, self, graph).map_err(DeclareError::Formula)?),
            None => None,
        };
        let shape = d.shape.or(definition.as_ref().map(|t| t.shape.clone())).unwrap_or_default();
        let symbol = graph.declare(key, shape, d.diagonal);
        self.0.push((key.to_owned(), symbol, d.role, definition));
        Ok(symbol)
    }
    fn entry(&self, symbol: Symbol) -> Option<&(String, Symbol, Role, Option<Tensor>)> {
        self.0.iter().rev().find(|e| e.1 == symbol)
    }
    pub fn symbol(&self, key: &str) -> Option<Symbol> {
        self.0.iter().rev().find(|e| e.0 == key).map(|e| e.1)
    }
    pub fn role(&self, symbol: Symbol) -> Option<Role> {
        self.entry(symbol).map(|e| e.2)
    }
    pub fn definition(&self, symbol: Symbol) -> Option<&Tensor> {
        self.entry(symbol).and_then(|e| e.3.as_ref())
    }
    pub fn time(&self) -> Option<Symbol> {
        self.0.iter().find(|e| e.2 == Role::Time).map(|e| e.1)
    }
}

/// Kind of a relation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RelationKind {
    Equal,
    NotEqual,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
}

/// Where a limit is taken.
#[derive(Clone, Debug)]
pub struct Limit {
    pub to: Expr,
}

/// A relation.
#[derive(Clone, Debug)]
pub struct Relation {
    pub kind: RelationKind,
    pub left: Tensor,
    pub right: Tensor,
    pub limit: Option<Limit>,
    pub indices: Vec<String>,
    pub has_branches: bool,
    pub span: Range<usize>,
}

/// Relations that belong together.
#[derive(Clone, Debug)]
pub struct Statement {
    pub relations: Vec<Relation>,
    pub span: Range<usize>,
}

/// Reads `a = b`, separated by commas.
pub fn read(text: &str, scope: &Scope, graph: &mut Graph) -> Result<Vec<Statement>, Vec<Problem>> {
    let mut out = Vec::new();
    let mut start = 0;
    for part in text.split(',') {
        let span = start..start + part.len();
        let (kind, (left, right)) = match part.split_once('=') {
            Some(sides) => (RelationKind::Equal, sides),
            None => match part.split_once('>') {
                Some(sides) => (RelationKind::Greater, sides),
                None => return Err(vec![problem("latex::no-relation", "a relation is expected", span)]),
            },
        };
        let shift = |mut p: Vec<Problem>, by: usize| {
            p.iter_mut().for_each(|p| p.span = p.span.start + by..p.span.end + by);
            p
        };
        let l = read_expression(left, scope, graph).map_err(|p| shift(p, start))?;
        let r = read_expression(right, scope, graph).map_err(|p| shift(p, start + left.len() + 1))?;
        let relation =
            Relation { kind, left: l, right: r, limit: None, indices: vec![], has_branches: false, span: span.clone() };
        out.push(Statement { relations: vec![relation], span });
        start += part.len() + 1;
    }
    Ok(out)
}

fn problem(code: &'static str, message: &str, span: Range<usize>) -> Problem {
    Problem { code, message: message.into(), span, hint: None }
}

/// Reads one symbol, one integer, or a sum of them.
pub fn read_expression(text: &str, scope: &Scope, graph: &mut Graph) -> Result<Tensor, Vec<Problem>> {
    let trimmed = text.trim();
    let start = text.len() - text.trim_start().len();
    let span = start..start + trimmed.len();
    if let Ok(n) = trimmed.parse::<i64>() {
        return Ok(Tensor::scalar(graph.integer(n)));
    }
    let (dot, name) = match trimmed.strip_prefix(r"\dot ") {
        Some(rest) => (1, rest),
        None => (0, trimmed),
    };
    let (minus, name) = name.strip_prefix('-').map_or((false, name), |n| (true, n));
    let Some(symbol) = scope.symbol(name) else {
        return Err(vec![problem("latex::unknown-symbol", &format!("`{name}` is not declared"), span)]);
    };
    let shape = graph.shape(symbol).clone();
    let components = (0..graph.component_count(symbol))
        .map(|c| {
            let leaf = crate::expr::Leaf { symbol, component: c as u16, rate: dot, instant: None };
            let e = graph.leaf(leaf);
            if minus { graph.neg(e) } else { e }
        })
        .collect();
    Ok(Tensor { shape, components })
}
