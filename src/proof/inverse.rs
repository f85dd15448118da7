//! Premises that give the value of a function at something unknown: √u = 2 says that u = 4.
//!
//! **In:** premises. **Out:** the same, where f(u) = w with a number w is written u = f⁻¹(w), e^u = e^v as u = v, and a ≤ b ≤ a as a = b.
//! **Guaranteed:** the premises hold at the same points as before: f is one to one, and w is a value of f, which is shown by bounds of w. A
//! number that is none contradicts the premise, and is written so. What is not shown stays as it was.

use super::outcome::Premises;
use super::witness::{Values, decimals};
use expr::domain::{Range, row};
use expr::{Expr, Graph, Node, Op, Rational};
use number::Bounded;

/// Writes premises as what they say of the arguments of functions.
pub fn solve_for_arguments(graph: &mut Graph, given: &mut Premises) {
    for known in &mut given.equations {
        *known = known.with(for_argument(graph, known.sides()).unwrap_or(known.sides()));
    }
    let both = given.not_negative.iter().filter_map(|&e| match *graph.node(e) {
        Node::Binary(Op::Sub, a, b) => Some((a, b)),
        Node::Unary(..) | Node::Binary(..) | Node::Constant(_) | Node::Pi | Node::Leaf(_) => None,
    });
    let both: Vec<(Expr, Expr)> = both.collect();
    // Of a ≤ b and b ≤ a the one that comes first is written as an equation.
    let twice = |&(at, &(a, b)): &(usize, &(Expr, Expr))| both[..at].contains(&(b, a));
    let equal: Vec<(Expr, Expr)> = both.iter().enumerate().filter(twice).map(|(_, &pair)| pair).collect();
    given.give(equal, given.present);
}

/// f(u) = w as u = f⁻¹(w), and what contradicts itself as 0 = 1.
fn for_argument(graph: &mut Graph, (left, right): (Expr, Expr)) -> Option<(Expr, Expr)> {
    let is_number = |graph: &Graph, e: Expr| graph.leaves([e]).is_empty();
    let (mut u, mut w) = match (is_number(graph, left), is_number(graph, right)) {
        (false, true) => (left, right),
        (true, false) => (right, left),
        (true, true) => return None,
        (false, false) => return of_equal_values(graph, (left, right)),
    };
    let mut reached = None;
    loop {
        let next = match *graph.node(u) {
            Node::Unary(op, a) => match inverse(graph, op, w) {
                Some((Some(true), value)) => Some((a, value)),
                Some((Some(false), _)) => return Some((graph.integer(0), graph.integer(1))),
                Some((None, _)) | None => None,
            },
            Node::Binary(op, a, b) => match (is_number(graph, a), is_number(graph, b)) {
                (false, true) => after(graph, op, b, w).map(|w| (a, w)),
                (true, false) => before(graph, op, a, w).map(|w| (b, w)),
                (true, true) | (false, false) => None,
            },
            Node::Leaf(_) | Node::Constant(_) | Node::Pi => None,
        };
        let Some(next) = next else { return reached };
        let is_function = !matches!(graph.node(u), Node::Unary(Op::Neg, _) | Node::Binary(..));
        (u, w) = next;
        if is_function {
            reached = Some(next);
        }
    }
}

/// f(u) = f(v) as u = v, for a function that is one to one and has a value everywhere: else the premise says more.
fn of_equal_values(graph: &Graph, (mut u, mut v): (Expr, Expr)) -> Option<(Expr, Expr)> {
    let mut changed = false;
    while let (&Node::Unary(f, a), &Node::Unary(g, b)) = (graph.node(u), graph.node(v)) {
        if f != g || !TOTAL.contains(&f) {
            break;
        }
        changed |= f != Op::Neg;
        (u, v) = (a, b);
    }
    changed.then_some((u, v))
}

fn bounds(graph: &Graph, w: Expr) -> Option<Bounded> {
    decimals(graph, &[w], &Values::default()).pop().flatten()
}

/// Whether a number is positive.
fn is_positive(graph: &Graph, w: Expr) -> Option<bool> {
    if graph.is_zero(w) {
        return Some(false);
    }
    let value = bounds(graph, w)?;
    (!value.contains_zero()).then_some(value.value > 0.0)
}

/// Whether a number is one of a range.
fn is_in(graph: &mut Graph, w: Expr, range: Range) -> Option<bool> {
    let mut inside = Some(true);
    for (bound, is_low) in [(range.low, true), (range.high, false)] {
        let Some(bound) = bound else { continue };
        let (half, pi) = (graph.constant(Rational::from(bound.quarter_turns) / Rational::from(2)), graph.pi());
        let (whole, turns) = (graph.integer(bound.whole.into()), graph.mul_structural(half, pi));
        let end = graph.add(whole, turns);
        let room = if is_low { graph.sub(w, end) } else { graph.sub(end, w) };
        match if graph.is_zero(room) { Some(bound.attained) } else { is_positive(graph, room) } {
            Some(true) => {}
            Some(false) => return Some(false),
            None => inside = None,
        }
    }
    inside
}

/// Whether a number is certainly not 0.
fn is_not_zero(graph: &Graph, w: Expr) -> bool {
    bounds(graph, w).is_some_and(|value| !value.contains_zero())
}

/// Functions that are one to one, and their inverse where they have values.
const INVERSES: [(Op, Op); 7] = [
    (Op::Neg, Op::Neg),
    (Op::Sqrt, Op::Powi(2)),
    (Op::Exp, Op::Ln),
    (Op::Ln, Op::Exp),
    (Op::Arcsin, Op::Sin),
    (Op::Arccos, Op::Cos),
    (Op::Arctan, Op::Tan),
];

/// Functions that are one to one and have a value everywhere.
const TOTAL: [Op; 5] = [Op::Neg, Op::Exp, Op::Sinh, Op::Tanh, Op::Arctan];

/// u of f(u) = w for a function that is one to one, and whether there is one; `None` for other functions.
fn inverse(graph: &mut Graph, op: Op, w: Expr) -> Option<(Option<bool>, Expr)> {
    let (_, inverse) = INVERSES.into_iter().find(|(function, _)| *function == op)?;
    Some((is_in(graph, w, row(op).range), graph.unary(inverse, w)))
}

/// u of u ∘ n = w, for a number n.
fn after(graph: &mut Graph, op: Op, n: Expr, w: Expr) -> Option<Expr> {
    if op == Op::Add {
        Some(graph.sub(w, n))
    } else if op == Op::Sub {
        Some(graph.add(w, n))
    } else if op == Op::Mul {
        is_not_zero(graph, n).then(|| graph.div(w, n))
    } else {
        (op == Op::Div).then(|| graph.mul(w, n))
    }
}

/// u of n ∘ u = w, for a number n.
fn before(graph: &mut Graph, op: Op, n: Expr, w: Expr) -> Option<Expr> {
    if op == Op::Sub {
        Some(graph.sub(n, w))
    } else if op == Op::Div {
        (is_not_zero(graph, n) && is_not_zero(graph, w)).then(|| graph.div(n, w))
    } else {
        matches!(op, Op::Add | Op::Mul).then(|| after(graph, op, n, w))?
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use expr::{Leaf, Shape};

    #[test]
    fn a_number_that_is_no_value_contradicts() {
        let mut g = Graph::new();
        let x = g.declare("x", Shape::scalar(), false);
        let x = g.leaf(Leaf::now(x, 0));
        let (zero, one, two) = (g.integer(0), g.integer(1), g.integer(2));
        let minus = g.neg(two);
        for (op, bad, good) in
            [(Op::Sqrt, minus, two), (Op::Exp, zero, one), (Op::Arctan, two, one), (Op::Arcsin, two, one)]
        {
            let f = g.unary(op, x);
            let thrice = g.integer(3);
            let scaled = g.mul(thrice, f);
            let (bad, good) = (g.mul(thrice, bad), g.mul(thrice, good));
            assert_eq!(for_argument(&mut g, (scaled, bad)), Some((zero, one)));
            let solved = for_argument(&mut g, (good, scaled)).unwrap();
            assert_eq!(solved.0, x);
        }
        let sine = g.unary(Op::Sin, x);
        assert_eq!(for_argument(&mut g, (sine, one)), None);
    }

    #[test]
    fn equal_values_are_of_equal_arguments_where_a_function_is_one_to_one_and_total() {
        let mut g = Graph::new();
        let [x, y] = ["x", "y"].map(|name| {
            let symbol = g.declare(name, Shape::scalar(), false);
            g.leaf(Leaf::now(symbol, 0))
        });
        for op in [Op::Exp, Op::Sinh, Op::Tanh, Op::Arctan] {
            let pair = (g.unary(op, x), g.unary(op, y));
            assert_eq!(for_argument(&mut g, pair), Some((x, y)));
        }
        // Not one to one; or more is said: √x = √y only where both have values.
        for op in [Op::Cos, Op::Sin, Op::Abs, Op::Cosh, Op::Powi(2), Op::Sqrt, Op::Ln, Op::Arcsin] {
            let pair = (g.unary(op, x), g.unary(op, y));
            assert_eq!(for_argument(&mut g, pair), None);
        }
        let other = (g.unary(Op::Exp, x), g.unary(Op::Sinh, y));
        assert_eq!(for_argument(&mut g, other), None);
    }
}
