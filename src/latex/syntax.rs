//! The syntax tree of a formula: what was written, before it means anything.

use std::cmp::Ordering;
use std::ops::Range;

use expr::Rational;

/// Most primes that are derivatives: as many as there are commands for dots.
pub const MOST_PRIMES: usize = 4;

pub use super::write::to_latex;

/// A node of the tree with its bytes in the formula.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Node {
    /// What it is.
    pub kind: NodeKind,
    /// Where it was written.
    pub span: Range<usize>,
}

/// A symbol's name: base, style and primes, in one canonical spelling (`bf:m` for `{\bf m}`, `I'`, `hat:\Omega`).
pub type Name = String;

/// One item of a subscript.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum SubItem {
    /// A letter (Latin or Greek) or another name.
    Name(Name),
    /// A digit.
    Digit(u16),
    /// Anything else, such as `(`, `-`, `)`; a comma tells labels apart, `A_{1,12}` and `A_{11,2}`.
    Other(char),
}

/// A subscript that names components, without the commas between its indices: `R_{1,2}` is `R_{12}`. Where a comma does not stand between
/// each two it stays, and is no index.
pub(super) fn indices(items: &[SubItem]) -> Vec<SubItem> {
    let comma = SubItem::Other(',');
    let items = items.strip_prefix(std::slice::from_ref(&comma)).unwrap_or(items);
    let are_apart = items.split(|item| *item == comma).all(|one| one.len() == 1);
    items.iter().filter(|item| !are_apart || **item != comma).cloned().collect()
}

/// A symbol with what is attached to it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SymbolNode {
    /// Its name.
    pub name: Name,
    /// Number of dots, or of primes that are derivatives.
    pub dots: u8,
    /// Whether these are primes.
    pub primed: bool,
    /// Its subscript.
    pub sub: Option<Vec<SubItem>>,
    /// Its superscript.
    pub sup: Option<Box<Node>>,
    /// Whether the superscript was written first (`I^{-1}_k`).
    pub sup_first: bool,
    /// Arguments in parentheses: a time, or what a function is applied to.
    pub arguments: Option<Vec<Node>>,
    /// Canonical spelling of the arguments.
    pub arguments_text: String,
}

/// The sign before a term.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// `+`, or none.
    Plus,
    /// `-`.
    Minus,
    /// `\pm`.
    PlusMinus,
    /// `\mp`.
    MinusPlus,
}

/// How a group is bracketed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bracket {
    /// `( )`.
    Round,
    /// `[ ]`.
    Square,
    /// `\{ \}`.
    Curly,
}

/// Kinds of nodes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NodeKind {
    /// A decimal number, exact.
    Number(Rational),
    /// π.
    Pi,
    /// Euler's number by itself.
    Euler {
        /// Written `\mathrm{e}`.
        upright: bool,
    },
    /// The identity matrix.
    Identity,
    /// A symbol.
    Symbol(SymbolNode),
    /// Something in brackets of its own.
    Group(Box<Node>, Bracket),
    /// Something other than a symbol, with scripts: subscript, superscript, and which came first.
    Scripted {
        /// What the scripts belong to.
        base: Box<Node>,
        /// Its subscript.
        sub: Option<Vec<SubItem>>,
        /// Its superscript.
        sup: Option<Box<Node>>,
        /// Whether the superscript was written first.
        sup_first: bool,
    },
    /// Signed terms.
    Sum(Vec<(Sign, Node)>),
    /// Juxtaposed factors.
    Product(Vec<Node>),
    /// Factors joined by `\cdot`.
    Dot(Vec<Node>),
    /// A vector product.
    Cross {
        /// The first factor.
        left: Box<Node>,
        /// The second factor.
        right: Box<Node>,
        /// Written `[a,b]`, not with `\times`.
        bracket: bool,
    },
    /// A Poisson bracket, `\{f,g\}`.
    Poisson(Box<Node>, Box<Node>),
    /// A quotient.
    Quotient {
        /// The numerator.
        top: Box<Node>,
        /// The denominator.
        bottom: Box<Node>,
        /// Written with `/`, not as a fraction.
        slash: bool,
    },
    /// A root: radicand, degree.
    Root(Box<Node>, u16),
    /// Euler's e to a power.
    Exponential {
        /// The power.
        exponent: Box<Node>,
        /// Written `\mathrm{e}`.
        upright: bool,
    },
    /// A named function, its power as in `\sin^2`, its arguments.
    Function(String, Option<i32>, Vec<Node>),
    /// The complex conjugate, written with a bar over more than a name.
    Conjugate(Box<Node>),
    /// In the place of a superscript: the complex conjugate of what stands before it.
    Conjugation {
        /// `\dagger`: transposed as well, not `*`.
        transposed: bool,
    },
    /// An absolute value or norm.
    Absolute(Box<Node>),
    /// A derivative `d^n of / d by^n`.
    Derivative {
        /// What is derived.
        of: Box<Node>,
        /// By what.
        by: Box<Node>,
        /// How often.
        order: u8,
        /// Written `\frac{d}{dt}` before what is derived.
        operator: bool,
        /// Written `\mathrm{d}`.
        upright: bool,
    },
    /// A partial derivative.
    Partial {
        /// What is derived.
        of: Box<Node>,
        /// By what, each as often as it is; symbols.
        by: Vec<Node>,
        /// How it is written.
        form: PartialForm,
    },
    /// A variational derivative.
    Variation {
        /// The density that is varied.
        of: Box<Node>,
        /// What is varied in it.
        by: Box<Node>,
    },
    /// An operator of vector analysis before something.
    Nabla {
        /// What it acts on.
        of: Box<Node>,
        /// What it does.
        action: Nabla,
    },
    /// A differential that is not part of a fraction, as in `dW=F\,dx`: along a motion, the rate.
    Differential {
        /// Of what.
        of: Box<Node>,
        /// Written `\mathrm{d}`.
        upright: bool,
    },
    /// The value of something at a time: `(x+y)(0)`, `\left.\dot x\right|_{t=0}`. Of a symbol, the time stands among its
    /// arguments.
    At {
        /// What is taken there.
        of: Box<Node>,
        /// When.
        time: Box<Node>,
        /// The name of the time, where it is written behind a bar.
        bar: Option<Name>,
    },
    /// The factorial of a whole number.
    Factorial(Box<Node>),
    /// A vector, by components.
    Tuple(Vec<Node>),
    /// A matrix, by rows.
    Matrix(Vec<Vec<Node>>),
    /// A limit: what, and where time goes.
    Limit(Box<Node>, Target),
}

/// How a partial derivative is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PartialForm {
    /// `\frac{\partial u}{\partial x}`.
    Fraction,
    /// `\frac{\partial}{\partial x}u`.
    Operator,
    /// `\partial_xu`.
    Subscript,
}

/// What ∇ does.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Nabla {
    /// `\nabla f`.
    Gradient,
    /// `\nabla\cdot{\bf A}`.
    Divergence,
    /// `\nabla\times{\bf A}`.
    Curl,
    /// `\nabla^2f`.
    Laplacian {
        /// Written `\Delta f`.
        delta: bool,
    },
    /// `({\bf v}\cdot\nabla)f`: along a direction.
    Along(Box<Node>),
    /// `\Box f`: the operator of waves.
    Wave,
    /// `\frac{Df}{Dt}`: following the flow.
    Following {
        /// Written `\frac{Df}{Dt}`, not `\frac{D}{Dt}f`.
        fraction: bool,
    },
}

/// Where time goes in a limit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Target {
    /// To a finite time.
    Finite(Box<Node>),
    /// To +∞.
    PlusInfinity,
    /// To −∞.
    MinusInfinity,
}

/// What is claimed of two sides.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum RelationKind {
    /// `=` or `\equiv`.
    Equal,
    /// `\ne`.
    NotEqual,
    /// `<`.
    Less,
    /// `\le`.
    LessEqual,
    /// `>`.
    Greater,
    /// `\ge`.
    GreaterEqual,
}

impl RelationKind {
    /// Whether it is so of two sides in this order.
    pub fn holds(self, order: Ordering) -> bool {
        match self {
            RelationKind::Equal => order.is_eq(),
            RelationKind::NotEqual => order.is_ne(),
            RelationKind::Less => order.is_lt(),
            RelationKind::LessEqual => order.is_le(),
            RelationKind::Greater => order.is_gt(),
            RelationKind::GreaterEqual => order.is_ge(),
        }
    }
}

/// A chain of relations: one more side than relations.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Chain {
    /// The sides.
    pub sides: Vec<Node>,
    /// The relations between neighbours.
    pub relations: Vec<RelationKind>,
    /// Its bytes.
    pub span: Range<usize>,
    /// The name of the time, which a limit goes along.
    pub time: Option<Name>,
}

impl Node {
    /// A node at a place.
    pub fn new(kind: NodeKind, span: Range<usize>) -> Node {
        Node { kind, span }
    }

    /// Whether this is the number 0.
    pub fn is_zero(&self) -> bool {
        matches!(&self.kind, NodeKind::Number(r) if *r == Rational::ZERO)
    }

    /// Whether this is a symbol of this name.
    pub(super) fn is_named(&self, name: &str) -> bool {
        matches!(&self.kind, NodeKind::Symbol(s) if s.name == name)
    }

    /// Whether digits are printed first.
    pub fn begins_with_number(&self) -> bool {
        match &self.kind {
            NodeKind::Number(_) => true,
            NodeKind::Scripted { base: first, .. }
            | NodeKind::Factorial(first)
            | NodeKind::At { of: first, bar: None, .. } => first.begins_with_number(),
            NodeKind::Product(parts) | NodeKind::Dot(parts) => parts.first().is_some_and(Node::begins_with_number),
            NodeKind::Quotient { top, slash: true, .. } => top.begins_with_number(),
            _ => false,
        }
    }

    /// Whether this is made of numbers alone.
    pub fn is_numeric(&self) -> bool {
        match &self.kind {
            NodeKind::Symbol(_)
            | NodeKind::Identity
            | NodeKind::Matrix(_)
            | NodeKind::Tuple(_)
            | NodeKind::Conjugation { .. } => false,
            _ => self.children().into_iter().all(Node::is_numeric),
        }
    }

    /// The parts of a node, in the order in which they are written.
    pub fn children(&self) -> Vec<&Node> {
        match &self.kind {
            NodeKind::Number(_)
            | NodeKind::Pi
            | NodeKind::Euler { .. }
            | NodeKind::Identity
            | NodeKind::Conjugation { .. } => Vec::new(),
            NodeKind::Symbol(s) => s.sup.as_deref().into_iter().chain(s.arguments.iter().flatten()).collect(),
            NodeKind::Scripted { base, sup, .. } => std::iter::once(&**base).chain(sup.as_deref()).collect(),
            NodeKind::Sum(terms) => terms.iter().map(|(_, n)| n).collect(),
            NodeKind::Product(parts) | NodeKind::Dot(parts) | NodeKind::Tuple(parts) => parts.iter().collect(),
            NodeKind::Function(_, _, arguments) => arguments.iter().collect(),
            NodeKind::Cross { left, right, .. } | NodeKind::Poisson(left, right) => vec![left, right],
            NodeKind::Quotient { top, bottom, .. } => vec![top, bottom],
            NodeKind::Derivative { of, by, .. } | NodeKind::Variation { of, by } => vec![of, by],
            NodeKind::Partial { of, by, .. } => std::iter::once(&**of).chain(by).collect(),
            NodeKind::Nabla { of, action: Nabla::Along(direction) } => vec![direction, of],
            NodeKind::Nabla { of, .. } => vec![of],
            NodeKind::At { of, time, .. } => vec![of, time],
            NodeKind::Factorial(a)
            | NodeKind::Differential { of: a, .. }
            | NodeKind::Group(a, _)
            | NodeKind::Root(a, _)
            | NodeKind::Absolute(a)
            | NodeKind::Conjugate(a) => vec![a],
            NodeKind::Exponential { exponent, .. } => vec![exponent],
            NodeKind::Matrix(rows) => rows.iter().flatten().collect(),
            NodeKind::Limit(body, target) => match target {
                Target::Finite(at) => vec![at, body],
                Target::PlusInfinity | Target::MinusInfinity => vec![body],
            },
        }
    }
}

/// What may stand at a place without parentheses; from loose to tight.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Least {
    /// Anything.
    Sum,
    /// What is tighter than a sum.
    Dot,
    /// What is tighter than a scalar product.
    Cross,
    /// What is tighter than a vector product.
    Product,
    /// Only what is one factor.
    Factor,
    /// Nothing: there are parentheses.
    Never,
}

/// How tightly a formula holds together: what it may stand beside without parentheses. Every writer of formulas asks here.
pub fn tightness(node: &Node) -> Least {
    match &node.kind {
        NodeKind::Sum(_) | NodeKind::Limit(..) => Least::Sum,
        NodeKind::Number(r) if *r < Rational::ZERO => Least::Sum,
        NodeKind::Dot(_) => Least::Dot,
        NodeKind::Cross { bracket: false, .. } => Least::Cross,
        NodeKind::Product(_) | NodeKind::Quotient { slash: true, .. } => Least::Product,
        _ => Least::Factor,
    }
}
