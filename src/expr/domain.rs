//! Where an operation has a value, and where it changes its nature: one row for each operation.
//!
//! **In:** an operation, or a node of a graph. **Out:** a [`Row`]: what the operation *needs* of its arguments, its *edges*,
//! its range, and the sign of its slopes; for a node, the same as expressions of the graph. **Guaranteed:** the operation has
//! a value exactly where its arguments have one and all needs are met; it is analytic wherever, beside that, no edge is
//! touched. There is no other place that says so: `defined`, the conditions of proofs, ranges, searches between samples,
//! integration and the page on the grammar read this table.
//!
//! **Why terms:** a need is the sign of an expression and an edge is its zero. So they can be searched, enclosed, proved and
//! printed like everything else. Needs are a conjunction; where an operation asks for one thing *or* another, as a power of 0
//! does, the row has a term that says both ([`Term::Support`]).
//!
//! A new operation does not compile without its row. (Values at complex arguments, cuts and the side that they belong to, get
//! a column of their own here.)

mod placed;
mod stretch;
mod words;

pub use stretch::{Stretch, rises, stretches};
pub use words::line;

use number::{Bounded, Scalar};
use serde::{Deserialize, Serialize};

use super::{Expr, FastMap, FastSet, Graph, Leaf, Node, Op, Rational, Symbol};

/// What is asked of a term.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Sign {
    /// > 0
    Positive,
    /// ≥ 0
    NotNegative,
    /// ≠ 0
    NotZero,
}

impl Sign {
    /// Whether a number is what is asked.
    pub fn is_of(self, number: &Rational) -> bool {
        match self {
            Sign::Positive => *number > Rational::ZERO,
            Sign::NotNegative => *number >= Rational::ZERO,
            Sign::NotZero => *number != Rational::ZERO,
        }
    }

    /// Whether all numbers of a ball are what is asked.
    pub fn is_certain_of(self, ball: Bounded) -> bool {
        match self {
            Sign::Positive => ball.value > ball.error,
            Sign::NotNegative => ball.value >= ball.error,
            Sign::NotZero => ball.value.abs() > ball.error,
        }
    }
}

/// An expression in the arguments a and b of an operation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Term {
    /// a
    First,
    /// b
    Second,
    /// −b
    Opposite,
    /// cos a
    Cosine,
    /// sin a
    Sine,
    /// 1 − a²
    Unit,
    /// a − 1
    Excess,
    /// a·b
    Product,
    /// a² + b²
    Squares,
    /// a + b + |b|: where a ≥ 0, it is positive if and only if a > 0 or b > 0.
    Support,
}

/// How an operation behaves at an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Change {
    /// It grows like the term to the power −order.
    Pole(Order, Sides),
    /// It grows like the logarithm of the term.
    Log,
    /// It jumps by so many half turns (π); at the edge it has the value from where the term is positive.
    Jump(u8),
    /// Its slope jumps, and stays finite.
    Kink,
    /// Its slope, or a later derivative, grows without bound.
    Steep,
}

/// The order of a pole.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// A whole number.
    Whole(u32),
    /// −b, for the exponent b.
    Exponent,
}

/// Where the values beside a pole go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sides {
    /// To opposite infinities.
    Opposite,
    /// To the same infinity.
    Alike,
    /// There is one side only.
    One,
}

/// Where an edge is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// Where a term vanishes.
    Zero(Term),
    /// Where a term vanishes while another one is positive.
    ZeroWhile(Term, Term),
    /// Where the argument passes from one infinity to the other: the limits differ.
    Infinity,
}

/// An edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Edge {
    /// Where it is.
    pub place: Place,
    /// What happens there.
    pub change: Change,
}

/// An end of a range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bound {
    /// Its whole part.
    pub whole: i8,
    /// How many times π/2 is to be added.
    pub quarter_turns: i8,
    /// Whether it is a value, or only a limit of values.
    pub attained: bool,
}

/// The values of an operation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Range {
    /// The lower end, if there is one.
    pub low: Option<Bound>,
    /// The upper end, if there is one.
    pub high: Option<Bound>,
}

/// The sign of the derivative by one argument, off the edges. A *monotone piece* is a set of arguments on which it is the
/// same, without pole or jump.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Slope {
    /// The operation does not depend on the argument.
    Flat,
    /// Positive, or 0 at single arguments.
    Rising,
    /// Negative, or 0 at single arguments.
    Falling,
    /// That of a term.
    Of(Term),
    /// Opposite to that of a term.
    Against(Term),
}

/// How an operation goes with the sign of its argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parity {
    /// The same.
    Even,
    /// Its sign changes, too.
    Odd,
    /// In no such way.
    Neither,
}

/// What kind of function an operation is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Nature {
    /// An algebraic one, and its degree in each argument, where it is a polynomial in that; 0 in one that it has not.
    Algebraic([Option<u32>; 2]),
    /// Another one.
    Transcendental {
        /// Of an operation of one argument.
        parity: Parity,
        /// Where it grows, or comes to rest, like an exponential: between which arguments it varies, as far as binary64 can tell.
        exponential: Option<[f64; 2]>,
    },
}

/// What is said of one operation.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// It has a value where all of these hold.
    pub needs: Vec<(Term, Sign)>,
    /// Elsewhere it is analytic.
    pub edges: Vec<Edge>,
    /// Its values.
    pub range: Range,
    /// By the first argument and, if there is one, by the second.
    pub slopes: [Slope; 2],
    /// What kind of function it is.
    pub nature: Nature,
}

/// A need of a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Need {
    /// The operation that has it.
    pub op: Op,
    /// Its first argument.
    pub first: Expr,
    /// Which of its terms is meant.
    pub term: Term,
    /// The term.
    pub value: Expr,
    /// What is asked of it.
    pub sign: Sign,
    /// Whether there is no value where it is not met. Otherwise nothing is known there: it belongs to the formula for a rate,
    /// and not to the function that the rate is of.
    pub certain: bool,
}

/// An edge of a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EdgeOf {
    /// What vanishes there; nothing for an argument that passes through infinity.
    pub vanishing: Option<Expr>,
    /// What must be positive there, if anything.
    pub whilst: Option<Expr>,
    /// What happens.
    pub change: Change,
}

const REAL: Range = Range { low: None, high: None };

/// In binary64, exponentials of less than −FAR are 0, and of more than FAR have no value.
const FAR: f64 = 746.0;

const fn end(whole: i8, quarter_turns: i8, attained: bool) -> Option<Bound> {
    Some(Bound { whole, quarter_turns, attained })
}

const fn edge(term: Term, change: Change) -> Edge {
    Edge { place: Place::Zero(term), change }
}

/// The table.
pub fn row(op: Op) -> Row {
    use Parity::{Even, Neither, Odd};
    use Slope::{Against, Falling, Flat, Of, Rising};
    use Term::{Cosine, Excess, First, Opposite, Product, Second, Sine, Squares, Support, Unit};
    let smooth =
        |range: Range, slopes: [Slope; 2], nature: Nature| Row { needs: vec![], edges: vec![], range, slopes, nature };
    // In the one argument that there is.
    let degree = |degree: Option<u32>| Nature::Algebraic([degree, Some(0)]);
    let not_algebraic = |parity: Parity| Nature::Transcendental { parity, exponential: None };
    let exponential =
        |parity: Parity, low: f64, high: f64| Nature::Transcendental { parity, exponential: Some([low, high]) };
    let linear = Nature::Algebraic([Some(1); 2]);
    let from_zero = Range { low: end(0, 0, true), high: None };
    let pole = |order: u32| {
        Change::Pole(Order::Whole(order), if order.is_multiple_of(2) { Sides::Alike } else { Sides::Opposite })
    };
    match op {
        Op::Neg => smooth(REAL, [Falling, Flat], degree(Some(1))),
        Op::Sqrt => Row {
            needs: vec![(First, Sign::NotNegative)],
            edges: vec![edge(First, Change::Steep)],
            range: from_zero,
            slopes: [Rising, Flat],
            nature: degree(None),
        },
        Op::Exp => smooth(Range { low: end(0, 0, false), high: None }, [Rising, Flat], exponential(Neither, -FAR, FAR)),
        Op::Ln => Row {
            needs: vec![(First, Sign::Positive)],
            edges: vec![edge(First, Change::Log)],
            range: REAL,
            slopes: [Rising, Flat],
            nature: not_algebraic(Neither),
        },
        Op::Sin => {
            smooth(Range { low: end(-1, 0, true), high: end(1, 0, true) }, [Of(Cosine), Flat], not_algebraic(Odd))
        }
        Op::Cos => {
            smooth(Range { low: end(-1, 0, true), high: end(1, 0, true) }, [Against(Sine), Flat], not_algebraic(Even))
        }
        Op::Tan => Row {
            needs: vec![(Cosine, Sign::NotZero)],
            edges: vec![edge(Cosine, pole(1))],
            range: REAL,
            slopes: [Rising, Flat],
            nature: not_algebraic(Odd),
        },
        Op::Arcsin => Row {
            needs: vec![(Unit, Sign::NotNegative)],
            edges: vec![edge(Unit, Change::Steep)],
            range: Range { low: end(0, -1, true), high: end(0, 1, true) },
            slopes: [Rising, Flat],
            nature: not_algebraic(Odd),
        },
        Op::Arccos => Row {
            needs: vec![(Unit, Sign::NotNegative)],
            edges: vec![edge(Unit, Change::Steep)],
            range: Range { low: end(0, 0, true), high: end(0, 2, true) },
            slopes: [Falling, Flat],
            nature: not_algebraic(Neither),
        },
        Op::Arctan => Row {
            needs: vec![],
            edges: vec![Edge { place: Place::Infinity, change: Change::Jump(1) }],
            range: Range { low: end(0, -1, false), high: end(0, 1, false) },
            slopes: [Rising, Flat],
            nature: not_algebraic(Odd),
        },
        Op::Sinh => smooth(REAL, [Rising, Flat], exponential(Odd, -FAR, FAR)),
        Op::Cosh => smooth(Range { low: end(1, 0, true), high: None }, [Of(First), Flat], exponential(Even, -FAR, FAR)),
        // The limits at the two infinities differ, too; but its formula goes on as one and the same function of exponentials.
        Op::Tanh => smooth(
            Range { low: end(-1, 0, false), high: end(1, 0, false) },
            [Rising, Flat],
            exponential(Odd, -20.0, 20.0),
        ),
        Op::Abs => Row {
            needs: vec![],
            edges: vec![edge(First, Change::Kink)],
            range: from_zero,
            slopes: [Of(First), Flat],
            nature: degree(None),
        },
        Op::Add => smooth(REAL, [Rising, Rising], linear),
        Op::Sub => smooth(REAL, [Rising, Falling], linear),
        Op::Mul => smooth(REAL, [Of(Second), Of(First)], linear),
        Op::Div => Row {
            needs: vec![(Second, Sign::NotZero)],
            edges: vec![edge(Second, pole(1))],
            range: REAL,
            slopes: [Of(Second), Against(First)],
            nature: Nature::Algebraic([Some(1), None]),
        },
        Op::Pow => Row {
            needs: vec![(First, Sign::NotNegative), (Support, Sign::Positive)],
            edges: vec![
                Edge { place: Place::ZeroWhile(First, Opposite), change: Change::Pole(Order::Exponent, Sides::One) },
                edge(First, Change::Steep),
            ],
            range: from_zero,
            slopes: [Of(Second), Of(Excess)],
            nature: not_algebraic(Neither),
        },
        Op::Arctan2 => Row {
            needs: vec![(Squares, Sign::NotZero)],
            edges: vec![Edge { place: Place::ZeroWhile(First, Opposite), change: Change::Jump(2) }],
            range: Range { low: end(0, -2, false), high: end(0, 2, true) },
            slopes: [Of(Second), Against(First)],
            nature: not_algebraic(Neither),
        },
        Op::Agm => Row {
            needs: vec![(First, Sign::NotNegative), (Second, Sign::NotNegative)],
            edges: vec![edge(First, Change::Steep), edge(Second, Change::Steep)],
            range: from_zero,
            slopes: [Rising, Rising],
            nature: not_algebraic(Neither),
        },
        // That of the angle, which has a cut where this has none.
        Op::DirectionCosine => Row {
            needs: vec![(Squares, Sign::NotZero)],
            edges: vec![],
            range: Range { low: end(-1, 0, true), high: end(1, 0, true) },
            slopes: [Rising, Against(Product)],
            nature: Nature::Algebraic([None, None]),
        },
        // Its own domain is that of its arguments.
        Op::Restrict => smooth(REAL, [Rising, Flat], degree(Some(1))),
        Op::Powi(n) => {
            let (even, falls) = (n % 2 == 0, n < 0);
            Row {
                needs: if falls { vec![(First, Sign::NotZero)] } else { vec![] },
                edges: if falls { vec![edge(First, pole(n.unsigned_abs()))] } else { vec![] },
                range: match (n, even, falls) {
                    (0, ..) => Range { low: end(1, 0, true), high: end(1, 0, true) },
                    (_, true, _) => Range { low: end(0, 0, !falls), high: None },
                    (_, false, _) => REAL,
                },
                slopes: match (n, even, falls) {
                    (0, ..) => [Flat, Flat],
                    (_, true, false) => [Of(First), Flat],
                    (_, true, true) => [Against(First), Flat],
                    (_, false, false) => [Rising, Flat],
                    (_, false, true) => [Falling, Flat],
                },
                nature: degree(u32::try_from(n).ok()),
            }
        }
    }
}

impl Row {
    /// Whether all values lie between two numbers.
    pub fn is_bounded(&self) -> bool {
        self.range.low.is_some() && self.range.high.is_some()
    }
}

impl EdgeOf {
    /// What passes 0 where the edge is reached: what vanishes there, or, where that is 0 all along, what must be positive there.
    pub fn passing(&self) -> impl Iterator<Item = Expr> + use<> {
        [self.vanishing, self.whilst].into_iter().flatten()
    }

    /// Whether it is a pole with two sides: what passes it goes through infinity.
    pub fn is_pole(&self) -> bool {
        matches!(self.change, Change::Pole(_, Sides::Opposite | Sides::Alike))
    }
}

impl Term {
    /// Whether the term vanishes for certain, as far as it is one of a single argument: that of steep edges.
    pub fn vanishes<B: Scalar>(self, x: B) -> bool {
        match self {
            Term::Unit => {
                let one = B::integer(1);
                (one - x).is_zero() || (one + x).is_zero()
            }
            Term::Excess => (x - B::integer(1)).is_zero(),
            Term::First => x.is_zero(),
            Term::Second
            | Term::Opposite
            | Term::Cosine
            | Term::Sine
            | Term::Product
            | Term::Squares
            | Term::Support => false,
        }
    }

    /// Whether the term names the first argument, and the second.
    fn names(self) -> [bool; 2] {
        match self {
            Term::First | Term::Cosine | Term::Sine | Term::Unit | Term::Excess => [true, false],
            Term::Second | Term::Opposite => [false, true],
            Term::Product | Term::Squares | Term::Support => [true, true],
        }
    }

    /// The term, for the arguments of a node.
    fn of(self, graph: &mut Graph, a: Expr, b: Expr) -> Expr {
        let one = graph.integer(1);
        match self {
            Term::First => a,
            Term::Second => b,
            Term::Opposite => graph.neg(b),
            Term::Cosine => graph.unary(Op::Cos, a),
            Term::Sine => graph.unary(Op::Sin, a),
            Term::Unit => {
                let square = graph.powi(a, 2);
                graph.sub(one, square)
            }
            Term::Excess => graph.sub(a, one),
            Term::Product => graph.mul(a, b),
            Term::Squares => {
                let (aa, bb) = (graph.powi(a, 2), graph.powi(b, 2));
                graph.add(aa, bb)
            }
            Term::Support => {
                let size = graph.unary(Op::Abs, b);
                let twice = graph.add(b, size);
                graph.add(a, twice)
            }
        }
    }
}

/// Operation and arguments of a node, the second one being the first where there is none.
pub(super) fn operation(graph: &Graph, node: Expr) -> Option<(Op, Expr, Expr)> {
    match *graph.node(node) {
        Node::Unary(op, a) => Some((op, a, a)),
        Node::Binary(op, a, b) => Some((op, a, b)),
        Node::Constant(_) | Node::Pi | Node::Leaf(_) => None,
    }
}

impl Graph {
    /// What a node needs to have a value where its arguments have one. An exponent that is a number is taken into account.
    pub fn needs(&mut self, node: Expr) -> Vec<Need> {
        let Some((op, a, b)) = operation(self, node) else { return Vec::new() };
        let mut needs = row(op).needs;
        if op == Op::Pow
            && let Some(exponent) = self.as_constant(b)
        {
            let sign = if *exponent > Rational::ZERO { Sign::NotNegative } else { Sign::Positive };
            needs = vec![(Term::First, sign)];
        }
        let need =
            |(term, sign): (Term, Sign)| Need { op, first: a, term, value: term.of(self, a, b), sign, certain: true };
        needs.into_iter().map(need).collect()
    }

    /// What everything that the roots depend on needs: they have values where all of it holds, and the leaves have values.
    pub fn needs_below(&mut self, roots: impl IntoIterator<Item = Expr>) -> Vec<Need> {
        let mut roots: Vec<Expr> = roots.into_iter().collect();
        let placed = self.placed_below(roots.iter().copied());
        roots.extend(self.places_below(roots.iter().copied()).into_iter().chain(placed));
        let asked = self.asked(&roots);
        let mut out = Vec::new();
        for node in self.reachable(roots) {
            let certain = asked.contains(&node);
            out.extend(self.needs(node).into_iter().map(|need| Need { certain, ..need }));
        }
        out
    }

    /// What is so wherever the roots have values: of [`Graph::needs_below`] what is certain.
    pub fn implied_below(&mut self, roots: impl IntoIterator<Item = Expr>) -> Vec<Need> {
        let mut needs = self.needs_below(roots);
        needs.retain(|need| need.certain);
        needs
    }

    /// What is 0 where an expression is, and changes its sign there sooner: |x|, xⁿ and √x are 0 where x is.
    pub fn root_of_zeros(&self, e: Expr) -> Expr {
        let mut root = e;
        loop {
            match *self.node(root) {
                Node::Unary(Op::Abs | Op::Sqrt, a) => root = a,
                Node::Unary(Op::Powi(n), a) if n > 0 => root = a,
                Node::Constant(_) | Node::Pi | Node::Leaf(_) | Node::Unary(..) | Node::Binary(..) => return root,
            }
        }
    }

    /// The nodes without whose values the roots have none: all, but what stands in a formula for a rate only.
    pub fn asked(&self, roots: &[Expr]) -> FastSet<Expr> {
        let (mut seen, mut open) = (FastSet::default(), roots.to_vec());
        while let Some(e) = open.pop() {
            if seen.insert(e) {
                match *self.node(e) {
                    Node::Binary(Op::Restrict, _, of) => open.push(of),
                    Node::Constant(_) | Node::Pi | Node::Leaf(_) | Node::Unary(..) | Node::Binary(..) => {
                        open.extend(self.node(e).children());
                    }
                }
            }
        }
        seen
    }

    /// The rate `formula` of `function`, with the domain that a rate has: no value where the function has none; unknown where
    /// the function has a value and the formula none, as at a kink or where a slope grows without bound. `partial` says of a
    /// leaf whether it may lack a value.
    ///
    /// A derivative drops terms that do not change (ln of a constant, x⁰), and with them what they need.
    pub fn rate_of(&mut self, function: Expr, formula: Expr, partial: impl Fn(Leaf) -> bool) -> Expr {
        // What a rate of a rate needs is as little known to be needed as what the first one needs.
        let asked = |graph: &mut Graph, e: Expr| -> FastSet<(Expr, Sign, bool)> {
            let needs = graph.needs_below([e]);
            let open = needs.into_iter().filter(|need| !graph.is_met(need));
            open.map(|need| (need.value, need.sign, need.certain)).collect()
        };
        let same_needs = asked(self, function) == asked(self, formula);
        let kept: FastSet<Symbol> = self.leaves([formula]).into_iter().map(|leaf| leaf.symbol).collect();
        let same_leaves = self.leaves([function]).into_iter().all(|leaf| !partial(leaf) || kept.contains(&leaf.symbol));
        if same_needs && same_leaves { formula } else { self.binary(Op::Restrict, formula, function) }
    }

    /// Whether a need is met whatever the leaves are: a positive number and squares.
    pub(super) fn is_met(&self, need: &Need) -> bool {
        let Node::Binary(Op::Add, a, b) = *self.node(need.value) else {
            return self.as_constant(need.value).is_some_and(|r| need.sign.is_of(r));
        };
        let positive = |e: Expr| self.as_constant(e).is_some_and(|r| *r > Rational::ZERO);
        let square = |e: Expr| {
            matches!(self.node(e), Node::Unary(Op::Powi(n), _) if n % 2 == 0 && *n >= 0)
                || matches!(self.node(e), Node::Binary(Op::Mul, a, b) if a == b)
        };
        let both = square(a) && square(b) && need.sign == Sign::NotNegative;
        both || positive(a) && square(b) || positive(b) && square(a)
    }

    /// A formula without what restricts it: equal to it wherever that has a value.
    pub fn unrestricted(&mut self, e: Expr) -> Expr {
        self.lifted(e, |_| true)
    }

    /// A formula without the restrictions to where something has a value of which `lifts` says so.
    pub(super) fn lifted(&mut self, e: Expr, lifts: impl Fn(Expr) -> bool) -> Expr {
        let order = self.reachable([e]);
        let is_lifted = |node: &Expr| matches!(*self.node(*node), Node::Binary(Op::Restrict, _, of) if lifts(of));
        if !order.iter().any(is_lifted) {
            return e;
        }
        let mut image: FastMap<Expr, Expr> = FastMap::default();
        for node in order {
            let new = match *self.node(node) {
                Node::Binary(Op::Restrict, a, of) if lifts(of) => image[&a],
                Node::Unary(op, a) => self.unary(op, image[&a]),
                Node::Binary(op, a, b) => self.rebuilt(op, image[&a], image[&b]),
                Node::Constant(_) | Node::Pi | Node::Leaf(_) => node,
            };
            image.insert(node, new);
        }
        image[&e]
    }

    /// Whether a formula is analytic in a leaf, wherever everything in it that depends on the leaf has a value: nothing
    /// that moves with the leaf may touch an edge. (An argument that passes through infinity does so at an edge of its own.)
    pub fn is_analytic_in(&self, e: Expr, leaf: Leaf) -> bool {
        let mut moving: FastSet<Expr> = FastSet::default();
        for node in self.reachable([e]) {
            if matches!(self.node(node), Node::Leaf(l) if *l == leaf) {
                moving.insert(node);
            }
            let Some((op, a, b)) = operation(self, node) else { continue };
            let moves = [moving.contains(&a), moving.contains(&b)];
            let moving_term = |term: Term| term.names().iter().zip(moves).any(|(named, moves)| *named && moves);
            let touches = |edge: &Edge| match (edge.place, edge.change) {
                // What vanishes may be 0 all along: the function leaps where the other one passes 0.
                (Place::ZeroWhile(term, other), Change::Jump(_)) => moving_term(term) || moving_term(other),
                (Place::Zero(term) | Place::ZeroWhile(term, _), _) => moving_term(term),
                (Place::Infinity, _) => false,
            };
            if row(op).edges.iter().any(touches) {
                return false;
            }
            if moves.contains(&true) {
                moving.insert(node);
            }
        }
        true
    }

    /// Whether a node is smooth wherever it has a value, if its arguments are.
    pub(super) fn is_smooth(&self, node: Expr) -> bool {
        let ends = |edge: &Edge| matches!(edge.change, Change::Pole(..) | Change::Log);
        operation(self, node).is_none_or(|(op, ..)| row(op).edges.iter().all(ends))
    }

    /// The edges of a node: where it is not analytic though its arguments are.
    pub fn edges(&mut self, node: Expr) -> Vec<EdgeOf> {
        let Some((op, a, b)) = operation(self, node) else { return Vec::new() };
        let edge = |Edge { place, change }: Edge| match place {
            Place::Zero(term) => EdgeOf { vanishing: Some(term.of(self, a, b)), whilst: None, change },
            Place::ZeroWhile(term, other) => {
                EdgeOf { vanishing: Some(term.of(self, a, b)), whilst: Some(other.of(self, a, b)), change }
            }
            Place::Infinity => EdgeOf { vanishing: None, whilst: None, change },
        };
        row(op).edges.into_iter().map(edge).collect()
    }
}
