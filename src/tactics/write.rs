//! Writing and reading terms: expressions of a file's graph with unique names, and back.
//!
//! **In:** expressions, or terms of the checker. **Out:** terms, or expressions. **Guaranteed:** two symbols have two names, whatever the file calls
//! them.

use crate::sequent::Scalar;
use checker::{ConstantSign, Declared, Relation, Sense, SymbolKind, Term, TermNode};
use expr::{Expr, Graph, Leaf, Shape, Symbol};
use latex::Role;
use std::collections::BTreeMap;

/// The names of symbols, and what they are.
pub(crate) struct Writer<'a> {
    graph: &'a Graph,
    names: BTreeMap<Symbol, String>,
    declared: Vec<Declared>,
}

impl<'a> Writer<'a> {
    pub(crate) fn new(graph: &'a Graph) -> Writer<'a> {
        Writer { graph, names: BTreeMap::new(), declared: Vec::new() }
    }

    /// Declares a symbol of which a rate of this order is written.
    pub(crate) fn declare(
        &mut self,
        symbol: Symbol,
        role: Option<Role>,
        defined: bool,
        order: u8,
        positive: bool,
    ) -> Result<(), String> {
        let mut name = self.graph.name(symbol).to_owned();
        while self.declared.iter().any(|d| d.name == name) {
            name.push('\u{2032}');
        }
        let sign = if positive { ConstantSign::Positive } else { ConstantSign::Any };
        let kind = match role {
            _ if defined => SymbolKind::Defined,
            Some(Role::Time) => SymbolKind::Time,
            Some(Role::Parameter | Role::Argument) => SymbolKind::Constant(sign),
            Some(Role::State | Role::Observable) if self.graph.is_field(symbol) => SymbolKind::Field(order),
            Some(Role::State | Role::Observable) => SymbolKind::Moves(order),
            Some(Role::Coordinate) => SymbolKind::Coordinate,
            Some(Role::Field) => SymbolKind::Field(order),
            Some(Role::Abbreviation) | None => {
                return Err(format!("`{name}` is no function of time"));
            }
        };
        let components = u16::try_from(self.graph.component_count(symbol)).map_err(|_| "too many components")?;
        self.declared.push(Declared { name: name.clone(), components, kind });
        self.names.insert(symbol, name);
        Ok(())
    }

    pub(crate) fn declared(&self) -> Vec<Declared> {
        self.declared.clone()
    }

    pub(crate) fn name(&self, symbol: Symbol) -> Result<String, String> {
        self.names.get(&symbol).cloned().ok_or_else(|| "a symbol without a name".to_owned())
    }

    pub(crate) fn term(&self, e: Expr) -> Result<Term, String> {
        Term::of(self.graph, e, |symbol| self.names.get(&symbol).cloned())
    }

    pub(crate) fn relation(&self, scalar: Scalar) -> Result<Relation, String> {
        let Scalar { left, sense, right } = scalar;
        Ok(Relation { left: self.term(left)?, sense, right: self.term(right)? })
    }

    /// The fixed times that occur below expressions, in the order of the graph, so that each stands after those that it names.
    pub(crate) fn instants(&self, roots: &[Expr]) -> Vec<Expr> {
        let (mut out, mut open): (Vec<Expr>, Vec<Expr>) = (Vec::new(), roots.to_vec());
        while !open.is_empty() {
            let found = self.graph.leaves(open.drain(..)).into_iter().filter_map(|leaf| leaf.instant);
            let new: Vec<Expr> = found.filter(|c| !out.contains(c)).collect();
            out.extend(&new);
            open = new;
        }
        out.sort_unstable();
        out.dedup();
        out
    }
}

/// A graph for the terms of a proof.
pub(crate) struct Reader {
    pub(crate) graph: Graph,
    names: BTreeMap<String, Symbol>,
}

impl Reader {
    pub(crate) fn new(declared: &[Declared]) -> Reader {
        let (mut graph, mut names) = (Graph::new(), BTreeMap::new());
        for one in declared {
            let shape = if one.components == 1 { Shape::scalar() } else { Shape::vector(one.components) };
            let symbol = graph.declare(&one.name, shape, false);
            if one.kind == SymbolKind::Coordinate {
                for component in 0..one.components {
                    graph.add_coordinate(symbol, component);
                }
            }
            names.insert(one.name.clone(), symbol);
        }
        Reader { graph, names }
    }

    /// A term of the checker, as an expression.
    pub(crate) fn read(&mut self, term: &Term) -> Option<Expr> {
        meter::charge(100 * term.0.len() as u64);
        let mut made: Vec<Expr> = Vec::with_capacity(term.0.len());
        for node in &term.0 {
            let e = match node {
                TermNode::Number(text) => {
                    let value = text.parse().ok()?;
                    self.graph.constant(value)
                }
                TermNode::Pi => self.graph.pi(),
                TermNode::Leaf { name, component, rate, at } => {
                    let symbol = *self.names.get(name)?;
                    let instant = match at {
                        Some(at) => Some(*made.get(*at as usize)?),
                        None => None,
                    };
                    self.graph.leaf(Leaf { rate: *rate, instant, ..Leaf::now(symbol, *component) })
                }
                TermNode::Partial { name, component, rate, by } => {
                    let mut leaf = Leaf { rate: *rate, ..Leaf::now(*self.names.get(name)?, *component) };
                    for (coordinate, of, order) in by {
                        let coordinate = Leaf::now(*self.names.get(coordinate)?, *of);
                        let Some(at) = self.graph.coordinate(coordinate) else {
                            // The time.
                            leaf.rate = leaf.rate.checked_add(*order)?;
                            continue;
                        };
                        for _ in 0..*order {
                            leaf.partials = leaf.partials.raised(at)?;
                        }
                    }
                    self.graph.leaf(leaf)
                }
                TermNode::Apply(name, arguments) => {
                    let op = checker::operation(name, arguments.len())?;
                    let a = *made.get(*arguments.first()? as usize)?;
                    match arguments.get(1) {
                        None => self.graph.unary(op, a),
                        Some(b) => {
                            let b = *made.get(*b as usize)?;
                            self.graph.rebuilt(op, a, b)
                        }
                    }
                }
            };
            made.push(e);
        }
        made.last().copied()
    }

    pub(crate) fn term(&self, e: Expr) -> Option<Term> {
        Term::of(&self.graph, e, |symbol| Some(self.graph.name(symbol).to_owned())).ok()
    }

    pub(crate) fn equation(&self, left: Expr, right: Expr) -> Option<Relation> {
        Some(Relation { left: self.term(left)?, sense: Sense::Equal, right: self.term(right)? })
    }

    /// The sides of a relation.
    pub(crate) fn sides(&mut self, relation: &Relation) -> Option<(Expr, Expr)> {
        Some((self.read(&relation.left)?, self.read(&relation.right)?))
    }
}
