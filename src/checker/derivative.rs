//! The checker's own derivative by time.
//!
//! **In:** an expression. **Out:** its derivative, written with rates one higher, or a refusal. **Guaranteed** (the chain rule): at
//! each time at which everything that [`needs::smooth`](super::needs::smooth) asks of the expression holds, it has values on a
//! neighbourhood in T, is continuously differentiable at that time, and its derivative is the value of the result, which has one.
//!
//! **Traps.** A leaf has only the rates that its symbol has. Terms that a derivative drops (those that do not move) may lack a value:
//! `smooth` asks for them. At an edge (|x| at 0, √x at 0, atan2 on its cut) the formula may have a value though the function has no
//! derivative, or the other way round: `smooth` excludes edges. The mean agm has no derivative among the operations.

use super::context::{Context, order};
use super::needs::edges;
use super::sequent::SymbolKind;
use expr::{Expr, Graph, Leaf, Node, Op};
use std::collections::BTreeMap;

/// What is derived by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum By {
    /// The time.
    Time,
    /// A coordinate, by its position; what is no field does not depend on it.
    Coordinate(usize),
}

/// de/dt.
pub(crate) fn derivative(context: &mut Context, e: Expr) -> Result<Expr, String> {
    derivative_by(context, e, By::Time)
}

/// The derivative by the time or a coordinate, the others held fixed.
pub(crate) fn derivative_by(context: &mut Context, e: Expr, by: By) -> Result<Expr, String> {
    let zero = context.graph.integer(0);
    let mut known: BTreeMap<Expr, Expr> = BTreeMap::new();
    for node in context.graph.reachable([e]) {
        let d = match *context.graph.node(node) {
            Node::Constant(_) | Node::Pi => zero,
            Node::Leaf(leaf) => rate_of_leaf(context, leaf, by)?,
            Node::Unary(op, a) => {
                let da = known[&a];
                if da == zero { zero } else { unary(&mut context.graph, op, node, a, da)? }
            }
            Node::Binary(op, a, b) => {
                let (da, db) = (known[&a], known[&b]);
                if da == zero && db == zero { zero } else { binary(&mut context.graph, op, node, [a, b], [da, db])? }
            }
        };
        known.insert(node, d);
    }
    Ok(known[&e])
}

/// The rate of a function that is given by a formula: the derivative, where the function has a value and touches no edge. Where the
/// function has a value and this has none, it is not known whether the function has a rate.
pub(crate) fn rate_of(context: &mut Context, formula: Expr, by: By) -> Result<Expr, String> {
    let mut d = derivative_by(context, formula, by)?;
    let zero = context.graph.integer(0);
    for edge in edges(context, formula, |_| true) {
        let guard = context.graph.div(zero, edge);
        d = context.graph.binary(Op::Add, d, guard);
    }
    Ok(context.graph.binary(Op::Restrict, d, formula))
}

fn rate_of_leaf(context: &mut Context, leaf: Leaf, by: By) -> Result<Expr, String> {
    if !context.leaf_moves(leaf) {
        return Ok(context.graph.integer(0));
    }
    match (context.kind(leaf), by) {
        (SymbolKind::Time, By::Time) => Ok(context.graph.integer(1)),
        (SymbolKind::Coordinate, By::Coordinate(at)) => {
            let same = context.graph.coordinate(leaf) == Some(at);
            Ok(context.graph.integer(i64::from(same)))
        }
        (SymbolKind::Coordinate, By::Time) | (SymbolKind::Time | SymbolKind::Moves(_), By::Coordinate(_)) => {
            Ok(context.graph.integer(0))
        }
        (SymbolKind::Moves(orders), By::Time) if leaf.rate < orders => {
            Ok(context.graph.leaf(Leaf { rate: leaf.rate + 1, ..leaf }))
        }
        (SymbolKind::Field(orders), _) if order(leaf) < u32::from(orders) => {
            let further = match by {
                By::Time => Leaf { rate: leaf.rate + 1, ..leaf },
                By::Coordinate(at) => {
                    Leaf { partials: leaf.partials.raised(at).ok_or("a derivative of too high an order")?, ..leaf }
                }
            };
            Ok(context.graph.leaf(further))
        }
        (SymbolKind::Moves(_) | SymbolKind::Field(_) | SymbolKind::Constant(_) | SymbolKind::Defined, _) => {
            Err(format!("{} has no further rate", context.graph.leaf_latex(leaf)))
        }
    }
}

/// Derivative of `node` = op(a), where a has the derivative `da`.
fn unary(g: &mut Graph, op: Op, node: Expr, a: Expr, da: Expr) -> Result<Expr, String> {
    let one = g.integer(1);
    let outer = match op {
        Op::Neg => g.integer(-1),
        Op::Sqrt => {
            let two = g.integer(2);
            let twice = g.mul(two, node);
            g.div(one, twice)
        }
        Op::Exp => node,
        Op::Ln => g.div(one, a),
        Op::Sin => g.unary(Op::Cos, a),
        Op::Cos => {
            let sine = g.unary(Op::Sin, a);
            g.neg(sine)
        }
        Op::Tan => {
            let square = g.powi(node, 2);
            g.add(one, square)
        }
        Op::Arcsin | Op::Arccos => {
            let square = g.powi(a, 2);
            let under = g.sub(one, square);
            let root = g.unary(Op::Sqrt, under);
            let sign = g.integer(if op == Op::Arcsin { 1 } else { -1 });
            g.div(sign, root)
        }
        Op::Arctan => {
            let square = g.powi(a, 2);
            let under = g.add(one, square);
            g.div(one, under)
        }
        Op::Sinh => g.unary(Op::Cosh, a),
        Op::Cosh => g.unary(Op::Sinh, a),
        Op::Tanh => {
            let square = g.powi(node, 2);
            g.sub(one, square)
        }
        Op::Abs => g.div(a, node),
        Op::Powi(0) => g.integer(0),
        Op::Powi(n) => {
            let (factor, power) =
                (g.integer(i64::from(n)), g.powi(a, n.checked_sub(1).ok_or("an exponent is too large")?));
            g.mul(factor, power)
        }
        Op::Add
        | Op::Sub
        | Op::Mul
        | Op::Div
        | Op::Pow
        | Op::Arctan2
        | Op::Agm
        | Op::DirectionCosine
        | Op::Restrict => {
            return Err("an operation of two arguments has one".to_owned());
        }
    };
    Ok(g.mul(outer, da))
}

/// Derivative of `node` = op(a, b), where not both derivatives are 0.
fn binary(g: &mut Graph, op: Op, node: Expr, [a, b]: [Expr; 2], [da, db]: [Expr; 2]) -> Result<Expr, String> {
    // x·a′ − y·b′, without what is 0 since it does not move.
    let cross = |g: &mut Graph, x: Expr, da: Expr, y: Expr, db: Expr| {
        let (left, right) = (g.mul_structural(x, da), g.mul_structural(y, db));
        g.sub(left, right)
    };
    // The rate of the angle of (x, y), (x·y′ − y·x′)/(x² + y²).
    let turn = |g: &mut Graph, [y, x]: [Expr; 2], [dy, dx]: [Expr; 2]| {
        let top = cross(g, x, dy, y, dx);
        let (yy, xx) = (g.powi(y, 2), g.powi(x, 2));
        let under = g.add(yy, xx);
        g.div(top, under)
    };
    Ok(match op {
        Op::Add => g.add(da, db),
        Op::Sub => g.sub(da, db),
        Op::Mul => {
            let (left, right) = (g.mul_structural(da, b), g.mul_structural(a, db));
            g.add(left, right)
        }
        Op::Div => {
            // (a′ − (a/b)·b′)/b
            let moved = g.mul_structural(node, db);
            let top = g.sub(da, moved);
            g.div(top, b)
        }
        Op::Pow => {
            // a^b·(b′·ln a + b·a′/a)
            let (log, slope) = (g.unary(Op::Ln, a), g.div(da, a));
            let (left, right) = (g.mul_structural(db, log), g.mul_structural(b, slope));
            let sum = g.add(left, right);
            g.mul(node, sum)
        }
        Op::Arctan2 => turn(g, [a, b], [da, db]),
        // cos atan2(b, a), and so (a/r)′ = −sin atan2(b, a) · atan2(b, a)′
        Op::DirectionCosine => {
            let (sine, turned) = (g.binary(Op::DirectionCosine, b, a), turn(g, [b, a], [db, da]));
            let product = g.mul(sine, turned);
            g.neg(product)
        }
        Op::Restrict => da,
        Op::Agm => return Err("the mean agm has no derivative among the operations".to_owned()),
        Op::Neg
        | Op::Sqrt
        | Op::Exp
        | Op::Ln
        | Op::Sin
        | Op::Cos
        | Op::Tan
        | Op::Arcsin
        | Op::Arccos
        | Op::Arctan
        | Op::Sinh
        | Op::Cosh
        | Op::Tanh
        | Op::Abs
        | Op::Powi(_) => return Err("an operation of one argument has two".to_owned()),
    })
}
