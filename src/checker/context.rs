//! The reading of terms: names become symbols of a graph, and definitions are put in.
//!
//! **In:** a [`Sequent`]. **Out:** [`Context`]: its graph, in which every expression of a proof is a node, and what is given, as
//! relations of nodes. **Guaranteed:** no defined symbol is left in an expression, so that what is asked of an expression (whether it
//! has a value, is continuous, leaps) is asked of the definitions, too; a fixed time is one of the sequent, since T need not contain
//! any other; a rate is one that the symbol has.
//!
//! The rate of a defined symbol is the derivative of its formula, restricted to where the formula has a value and nothing in it
//! touches an edge, see [`derivative`](super::derivative).

use super::derivative::{By, rate_of};
use super::needs::frozen;
use super::sequent::{ConstantSign, Sequent, SymbolKind};
use super::term::{LARGEST_TERM, Relation, Sense, Term, TermNode, operation, rational};
use super::when::Instant;
use expr::{Expr, Graph, Leaf, Node, Op, Shape, Symbol};
use std::collections::BTreeMap;

/// Most fixed times, which may stand in each other.
const MOST_INSTANTS: usize = 200;

/// A relation between nodes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Says {
    pub(crate) left: Expr,
    pub(crate) sense: Sense,
    pub(crate) right: Expr,
}

impl Says {
    pub(crate) fn sides(self) -> [Expr; 2] {
        [self.left, self.right]
    }

    /// Whether both are the same, but for the order of the sides where it means nothing.
    pub(crate) fn is(self, other: Says) -> bool {
        let turned = Says { left: self.right, sense: self.sense, right: self.left };
        let symmetric = match self.sense {
            Sense::Equal | Sense::NotEqual => true,
            Sense::Less | Sense::LessOrEqual => false,
        };
        self == other || symmetric && turned == other
    }
}

/// Another claim, read.
#[derive(Clone, Debug)]
pub(crate) struct ClaimedSays {
    pub(crate) selectors: Vec<Says>,
    pub(crate) hypotheses: Vec<Says>,
    pub(crate) says: Says,
}

/// A sequent, read.
#[derive(Clone, Debug)]
pub(crate) struct Context {
    pub(crate) graph: Graph,
    /// The node 0.
    pub(crate) zero: Expr,
    kinds: Vec<SymbolKind>,
    names: BTreeMap<String, Symbol>,
    definitions: Vec<(Symbol, u16, Expr)>,
    pub(crate) instants: Vec<Expr>,
    pub(crate) systems: Vec<Says>,
    pub(crate) premises: Vec<Says>,
    pub(crate) claims: Vec<ClaimedSays>,
    pub(crate) selectors: Vec<Says>,
    pub(crate) assumed: Vec<Says>,
    pub(crate) claim: Says,
    /// Whether formulas are read as they are written, to be printed: definitions are not put in.
    as_written: bool,
}

/// The order of a derivative.
pub(crate) fn order(leaf: Leaf) -> u32 {
    u32::from(leaf.rate) + leaf.partials.order()
}

impl Context {
    /// Reads a sequent.
    pub(crate) fn new(sequent: &Sequent) -> Result<Context, String> {
        Context::of(sequent, false)
    }

    /// Reads the symbols of a sequent, to print its formulas as they are written.
    pub(crate) fn as_written(sequent: &Sequent) -> Result<Context, String> {
        let bare = Sequent::of(sequent.symbols.clone(), Relation::equal(Term::integer(0), Term::integer(0)));
        Context::of(&bare, true)
    }

    fn of(sequent: &Sequent, as_written: bool) -> Result<Context, String> {
        let mut graph = Graph::new();
        let zero = graph.integer(0);
        let nothing = Says { left: zero, sense: Sense::Equal, right: zero };
        let mut context = Context {
            graph,
            zero,
            kinds: Vec::new(),
            names: BTreeMap::new(),
            definitions: Vec::new(),
            instants: Vec::new(),
            systems: Vec::new(),
            premises: Vec::new(),
            claims: Vec::new(),
            selectors: Vec::new(),
            assumed: Vec::new(),
            claim: nothing,
            as_written,
        };
        for declared in &sequent.symbols {
            let shape = if declared.components == 1 { Shape::scalar() } else { Shape::vector(declared.components) };
            let symbol = context.graph.declare(&declared.name, shape, false);
            if declared.components == 0 || context.names.insert(declared.name.clone(), symbol).is_some() {
                return Err(format!("the symbol {} is declared twice, or has no component", declared.name));
            }
            context.kinds.push(declared.kind);
            if declared.kind == SymbolKind::Coordinate {
                for component in 0..declared.components {
                    context.graph.add_coordinate(symbol, component).ok_or("too many coordinates")?;
                }
            }
        }
        if context.has_fields() && !sequent.instants.is_empty() {
            return Err("fields have no fixed times".to_owned());
        }
        if sequent.instants.len() > MOST_INSTANTS {
            return Err(format!("more than {MOST_INSTANTS} fixed times"));
        }
        // Fixed times may name values at those before them, x(t₁(0)).
        for instant in &sequent.instants {
            let e = context.read(instant)?;
            if context.moves(e) {
                return Err("a fixed time moves".to_owned());
            }
            context.instants.push(e);
        }
        for definition in &sequent.definitions {
            let formula = context.read(&definition.formula)?;
            let symbol = context.symbol(&definition.name)?;
            let known = context.definitions.iter().any(|d| (d.0, d.1) == (symbol, definition.component));
            if known || !matches!(context.kinds[symbol.index()], SymbolKind::Defined) {
                return Err(format!("{} is defined twice, or is no defined symbol", definition.name));
            }
            context.definitions.push((symbol, definition.component, formula));
        }
        context.systems = context.read_all(&sequent.systems)?;
        context.premises = context.read_all(&sequent.premises)?;
        for claimed in &sequent.claims {
            let (selectors, hypotheses) =
                (context.read_all(&claimed.selectors)?, context.read_all(&claimed.hypotheses)?);
            let says = context.relation(&claimed.says)?;
            context.claims.push(ClaimedSays { selectors, hypotheses, says });
        }
        context.selectors = context.read_all(&sequent.selectors)?;
        context.assumed = context.read_all(&sequent.assumed)?;
        context.claim = context.relation(&sequent.claim)?;
        Ok(context)
    }

    fn read_all(&mut self, relations: &[Relation]) -> Result<Vec<Says>, String> {
        relations.iter().map(|r| self.relation(r)).collect()
    }

    /// A relation, read.
    pub(crate) fn relation(&mut self, relation: &Relation) -> Result<Says, String> {
        let (left, right) = (self.read(&relation.left)?, self.read(&relation.right)?);
        Ok(Says { left, sense: relation.sense, right })
    }

    /// A term, read.
    pub(crate) fn read(&mut self, term: &Term) -> Result<Expr, String> {
        if term.0.len() > LARGEST_TERM {
            return Err(format!("a term has {} nodes, more than {LARGEST_TERM}", term.0.len()));
        }
        let mut made: Vec<Expr> = Vec::with_capacity(term.0.len());
        for node in &term.0 {
            let e = match node {
                TermNode::Number(text) => {
                    let value = rational(text)?;
                    self.graph.constant(value)
                }
                TermNode::Pi => self.graph.pi(),
                TermNode::Leaf { name, component, rate, at } => {
                    let at = at.map(|at| made.get(at as usize).copied().ok_or("no such node")).transpose()?;
                    self.leaf(name, *component, *rate, at)?
                }
                TermNode::Partial { name, component, rate, by } => self.partial(name, *component, *rate, by)?,
                TermNode::Apply(name, arguments) => {
                    let op = operation(name, arguments.len()).ok_or_else(|| format!("no operation {name}"))?;
                    let argument = |at: usize| {
                        let at = arguments.get(at).copied().ok_or("an argument is missing")?;
                        made.get(at as usize).copied().ok_or("no such node")
                    };
                    match op.arity() {
                        1 => {
                            let a = argument(0)?;
                            self.graph.unary(op, a)
                        }
                        _ => {
                            let (a, b) = (argument(0)?, argument(1)?);
                            self.graph.rebuilt(op, a, b)
                        }
                    }
                }
            };
            made.push(e);
        }
        made.last().copied().ok_or_else(|| "an empty term".to_owned())
    }

    /// The symbol of a name.
    pub(crate) fn symbol(&self, name: &str) -> Result<Symbol, String> {
        self.names.get(name).copied().ok_or_else(|| format!("no symbol {name}"))
    }

    fn leaf(&mut self, name: &str, component: u16, rate: u8, at: Option<Expr>) -> Result<Expr, String> {
        let symbol = self.symbol(name)?;
        if usize::from(component) >= self.graph.component_count(symbol) {
            return Err(format!("{name} has no component {component}"));
        }
        if self.as_written {
            return Ok(self.graph.leaf(Leaf { rate, instant: at, ..Leaf::now(symbol, component) }));
        }
        if let Some(at) = at
            && !self.instants.contains(&at)
        {
            return Err("a fixed time that the sequent does not name".to_owned());
        }
        match (self.kinds[symbol.index()], rate, at) {
            (SymbolKind::Constant(_), 0, None) | (SymbolKind::Time, 0, None) => {
                Ok(self.graph.component(symbol, component))
            }
            (SymbolKind::Time, 0, Some(at)) => Ok(at),
            (SymbolKind::Moves(orders), _, _) if rate <= orders => {
                let leaf = Leaf { rate, instant: at, ..Leaf::now(symbol, component) };
                Ok(self.graph.leaf(leaf))
            }
            (SymbolKind::Coordinate, 0, None) => Ok(self.graph.component(symbol, component)),
            (SymbolKind::Field(_), _, None) => self.partial(name, component, rate, &[]),
            (SymbolKind::Defined, _, _) => {
                let known = self.definitions.iter().find(|d| (d.0, d.1) == (symbol, component));
                let mut e = known.map(|d| d.2).ok_or_else(|| format!("{name} is used before it is defined"))?;
                for _ in 0..rate {
                    e = rate_of(self, e, By::Time)?;
                }
                Ok(match at {
                    Some(at) => frozen(self, e, at),
                    None => e,
                })
            }
            _ => Err(format!("{name} has no such rate, or no value at a time")),
        }
    }

    /// A derivative of a field, or of what is defined by fields.
    fn partial(&mut self, name: &str, component: u16, rate: u8, by: &[(String, u16, u8)]) -> Result<Expr, String> {
        let symbol = self.symbol(name)?;
        if usize::from(component) >= self.graph.component_count(symbol) {
            return Err(format!("{name} has no component {component}"));
        }
        let mut leaf = Leaf { rate, ..Leaf::now(symbol, component) };
        let mut along = vec![By::Time; usize::from(rate)];
        for (coordinate, of, order) in by {
            let coordinate = Leaf::now(self.symbol(coordinate)?, *of);
            if self.kind(coordinate) == SymbolKind::Time {
                leaf.rate = leaf.rate.checked_add(*order).ok_or("a derivative of too high an order")?;
                along.extend(vec![By::Time; usize::from(*order)]);
                continue;
            }
            let at = self.graph.coordinate(coordinate).ok_or("no such coordinate")?;
            for _ in 0..*order {
                leaf.partials = leaf.partials.raised(at).ok_or("a derivative of too high an order")?;
                along.push(By::Coordinate(at));
            }
        }
        match self.kinds[symbol.index()] {
            _ if self.as_written => Ok(self.graph.leaf(leaf)),
            SymbolKind::Field(orders) if order(leaf) <= u32::from(orders) => Ok(self.graph.leaf(leaf)),
            SymbolKind::Defined => {
                let known = self.definitions.iter().find(|d| (d.0, d.1) == (symbol, component));
                let mut e = known.map(|d| d.2).ok_or_else(|| format!("{name} is used before it is defined"))?;
                for by in along {
                    e = rate_of(self, e, by)?;
                }
                Ok(e)
            }
            _ => Err(format!("{name} has no such derivative")),
        }
    }

    /// Whether there are places, and not times alone.
    pub(crate) fn has_fields(&self) -> bool {
        self.kinds.iter().any(|kind| matches!(kind, SymbolKind::Coordinate | SymbolKind::Field(_)))
    }

    /// Refuses a theorem about intervals of times where there are places.
    pub(crate) fn is_of_times(&self) -> Result<(), String> {
        if self.has_fields() { Err("fields are no functions of the time alone".to_owned()) } else { Ok(()) }
    }

    /// A fixed time.
    pub(crate) fn instant(&self, instant: Instant) -> Result<Expr, String> {
        self.instants.get(instant.0 as usize).copied().ok_or_else(|| "no such fixed time".to_owned())
    }

    /// The kind of the symbol of a leaf.
    pub(crate) fn kind(&self, leaf: Leaf) -> SymbolKind {
        self.kinds[leaf.symbol.index()]
    }

    /// The sign of a constant.
    pub(crate) fn constant_sign(&self, leaf: Leaf) -> ConstantSign {
        match self.kind(leaf) {
            SymbolKind::Constant(sign) => sign,
            SymbolKind::Time
            | SymbolKind::Moves(_)
            | SymbolKind::Coordinate
            | SymbolKind::Field(_)
            | SymbolKind::Defined => ConstantSign::Any,
        }
    }

    /// Whether a leaf moves: a state now, or the time.
    pub(crate) fn leaf_moves(&self, leaf: Leaf) -> bool {
        match self.kind(leaf) {
            SymbolKind::Time | SymbolKind::Coordinate | SymbolKind::Field(_) => true,
            SymbolKind::Moves(_) | SymbolKind::Defined => leaf.instant.is_none(),
            SymbolKind::Constant(_) => false,
        }
    }

    /// Whether an expression depends on the present time.
    pub(crate) fn moves(&self, e: Expr) -> bool {
        self.graph.leaves([e]).into_iter().any(|leaf| self.leaf_moves(leaf))
    }

    /// Gives a symbol a further continuous rate.
    pub(crate) fn add_order(&mut self, symbol: Symbol) {
        if let SymbolKind::Moves(orders) = &mut self.kinds[symbol.index()] {
            *orders = orders.saturating_add(1);
        }
    }

    /// left − right.
    pub(crate) fn difference(&mut self, says: Says) -> Expr {
        self.graph.sub(says.left, says.right)
    }

    /// A relation as a recorded proof holds it.
    pub(crate) fn written(&self, says: Says) -> Result<Relation, String> {
        let term = |e: Expr| Term::of(&self.graph, e, |symbol| Some(self.graph.name(symbol).to_owned()));
        Ok(Relation { left: term(says.left)?, sense: says.sense, right: term(says.right)? })
    }

    /// A relation in LaTeX.
    pub(crate) fn latex(&self, says: Says) -> String {
        let sense = match says.sense {
            Sense::Equal => "=",
            Sense::NotEqual => r"\ne ",
            Sense::Less => "<",
            Sense::LessOrEqual => r"\le ",
        };
        format!("{}{sense}{}", self.graph.to_latex(says.left), self.graph.to_latex(says.right))
    }

    /// The factors of a product that is 0 exactly where one of them is.
    pub(crate) fn factors(&self, e: Expr) -> Vec<Expr> {
        let (mut open, mut out) = (vec![e], Vec::new());
        while let Some(e) = open.pop() {
            match *self.graph.node(e) {
                Node::Binary(Op::Mul, a, b) => open.extend([b, a]),
                Node::Binary(Op::Div, a, _) | Node::Unary(Op::Neg, a) => open.push(a),
                Node::Unary(Op::Powi(n), a) if n > 0 => open.push(a),
                Node::Constant(_) | Node::Pi | Node::Leaf(_) | Node::Unary(..) | Node::Binary(..) => out.push(e),
            }
        }
        out
    }
}
