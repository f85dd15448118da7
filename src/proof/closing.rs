//! Premises closed under differentiation by time, and the points through which motions pass.
//!
//! **In:** equations that hold at all times, and what is asked about. **Out:** [`Dynamics`]: derivatives of the equations, as
//! many as are needed; and a test whether a point that satisfies all of them belongs to a motion.
//!
//! # Why a point is not enough
//!
//! ẋ² = 0 has the derivative 2ẋẍ = 0, which the point ẋ = 0, ẍ = 1 satisfies; but no motion passes through it. So a point refutes
//! what is claimed of motions only if a motion passes through it, which is shown in one of three ways:
//!
//! 1. No equation ties what moves: polynomials have any values and rates.
//! 2. *Rest*: all rates vanish at the point, and no equation names the time. Then the motion that stays there satisfies them.
//! 3. *Regular points.* Let σᵢⱼ be the highest rate of variable j in equation i. Choose cⱼ, dᵢ ≥ 0 with cⱼ − dᵢ ≥ σᵢⱼ, and equality
//!    along an assignment of a variable to each equation. If all derivatives of equation i up to order dᵢ hold at the point, and
//!    the matrix ∂(equation i)/∂(rate cⱼ − dᵢ of variable j) has as many independent columns there as there are equations, then a
//!    motion passes through the point: the variables of these columns are determined by the others, which may be polynomials
//!    (Pryce, *BIT* 41 (2001) 364, theorem 4.2; it is the implicit function theorem and the theorem of Picard and Lindelöf).
//!    The numbers c and d are the least that also reach every rate that is asked about.
//!
//! The derivatives that 3. asks for are also the premises of proofs: they contain the hidden constraints. Before, what vanishes as a
//! sum of squares is replaced by its terms, and a power by its base, since everything is real.

use super::known::Known;
use super::linear::Combinations;
use super::outcome::{Point, Reason};
use super::witness::{Values, decimals, values_at};
use expr::{Expr, FastMap, Graph, Leaf, Node, Op, Rational, Symbol};
use number::{Bounded, Number};

/// A component of something that moves.
type Variable = (Symbol, u16);

/// Derivatives of higher order are not formed.
const HIGHEST: u8 = 7;
/// Rounds in which the orders are raised.
const ROUNDS: usize = 24;
/// More equations are not examined for the motions through a point.
const MOST_EQUATIONS: usize = 48;

/// Equations of motion with their derivatives.
#[derive(Clone, Debug, Default)]
pub(super) struct Dynamics {
    /// The equations that name what moves, taken apart.
    pub(super) parts: Vec<Known>,
    /// Their derivatives, known when they are.
    pub(super) derived: Vec<Known>,
    /// Whether an equation names the time.
    timely: bool,
    /// Whether something that moves is named at a fixed time.
    fixed: bool,
    /// Whether an equation is about the time alone, which no motion can help.
    pub(super) impossible: bool,
    /// Whether there are more equations than variables to solve them for.
    pub(super) overdetermined: bool,
    /// For each equation, what it contributes to the columns; `None` where the assignment does not reach all equations.
    matrix: Option<Vec<Vec<(usize, Expr)>>>,
}

/// Whether everything has the same value at all times that a point names.
fn stays(point: &Point) -> bool {
    point.values.iter().all(|(a, value)| {
        let again = |b: &Leaf| b != a && b.rate == 0 && (b.symbol, b.component) == (a.symbol, a.component);
        let mut others = point.values.iter().filter(|(b, _)| again(b));
        a.rate > 0 || others.all(|(_, other)| other.exact.is_some() && other.exact == value.exact)
    })
}

/// Whether an expression is one of some symbols.
fn is_one_of(graph: &Graph, e: Expr, symbols: &[Symbol]) -> bool {
    matches!(graph.node(e), Node::Leaf(leaf) if leaf.instant.is_none() && symbols.contains(&leaf.symbol))
}

impl Dynamics {
    /// Differentiates as far as the rates in `asked` ask for; equations for which no variable is left, `further` times at least. What
    /// they say beside the others may only come out in their derivatives: r = R leaves of ṙ = p, ṗ = f(r) that p = 0, and, once more,
    /// that f(R) = 0.
    ///
    /// # Errors
    /// [`Reason::NoDerivative`] where a derivative cannot be written.
    pub(super) fn of(
        graph: &mut Graph,
        equations: &[Known],
        asked: &[Expr],
        (time, angles): (Leaf, &[Symbol]),
        moves: &impl Fn(Leaf) -> bool,
        further: u8,
    ) -> Result<Dynamics, Reason> {
        let mut out = Dynamics::default();
        let named = equations.iter().flat_map(|k| [k.left, k.right]).chain(asked.iter().copied());
        out.fixed = graph.leaves_within(named).into_iter().any(|leaf| leaf.instant.is_some());
        for known in equations {
            let (l, r) = known.sides();
            let leaves = graph.leaves_within([l, r]);
            let moving = leaves.iter().any(|&leaf| leaf.instant.is_none() && moves(leaf));
            out.timely |= leaves.contains(&time);
            if moving {
                for pair in taken_apart(graph, l, r) {
                    let part = known.with(pair);
                    if !out.parts.contains(&part) {
                        out.parts.push(part);
                    }
                }
            } else if leaves.contains(&time) {
                out.impossible = true;
                // It says the same of later times.
                let mut pair = (l, r);
                for _ in 0..further {
                    let mut rate = |e: Expr| graph.time_derivative(e, time, moves).map_err(|_| Reason::NoDerivative);
                    pair = (rate(pair.0)?, rate(pair.1)?);
                    out.derived.push(known.with(pair));
                }
            }
        }
        let mut variables: Vec<Variable> = Vec::new();
        let mut orders: Vec<FastMap<usize, u8>> = Vec::new();
        for part in &out.parts {
            let (l, r) = part.sides();
            let mut row = FastMap::default();
            for leaf in graph.leaves_within([l, r]).into_iter().filter(|l| l.instant.is_none() && moves(*l)) {
                let variable = (leaf.symbol, leaf.component);
                let at = variables.iter().position(|v| *v == variable).unwrap_or_else(|| {
                    variables.push(variable);
                    variables.len() - 1
                });
                let order: &mut u8 = row.entry(at).or_insert(0);
                *order = (*order).max(leaf.rate);
            }
            orders.push(row);
        }
        let of = assigned(&orders, variables.len());
        out.overdetermined = of.contains(&None);
        // Everything that is asked about, at whatever time.
        let mut reach = vec![0_u8; variables.len()];
        for leaf in graph.leaves_within(asked.iter().copied()).into_iter().filter(|l| moves(*l)) {
            if let Some(at) = variables.iter().position(|v| *v == (leaf.symbol, leaf.component)) {
                reach[at] = reach[at].max(leaf.rate);
            }
        }
        for (row, _) in orders.iter().zip(&of).filter(|(_, of)| of.is_none()) {
            for (&j, &order) in row {
                reach[j] = reach[j].max(order.saturating_add(further)).min(HIGHEST);
            }
        }
        let mut depth = vec![0_u8; orders.len()];
        let mut settled = false;
        for _ in 0..ROUNDS {
            let before = (reach.clone(), depth.clone());
            for (row, &d) in orders.iter().zip(&depth) {
                for (&j, &order) in row {
                    reach[j] = reach[j].max(order.saturating_add(d)).min(HIGHEST);
                }
            }
            for (i, row) in orders.iter().enumerate() {
                depth[i] = match of[i] {
                    Some(j) => reach[j].saturating_sub(row[&j]),
                    // Without a variable of its own, as far as nothing new comes in.
                    None => row.iter().map(|(&j, &order)| reach[j].saturating_sub(order)).min().unwrap_or(0),
                };
            }
            if before == (reach.clone(), depth.clone()) {
                settled = true;
                break;
            }
        }
        for (part, &d) in out.parts.iter().zip(&depth) {
            let (mut l, mut r) = part.sides();
            for _ in 0..d {
                let continued = [l, r].iter().any(|&e| is_one_of(graph, e, angles));
                let mut rate = |e: Expr| -> Result<Expr, Reason> {
                    let rate = graph.time_derivative(e, time, moves).map_err(|_| Reason::NoDerivative)?;
                    Ok(if continued { graph.continued(e, rate) } else { rate })
                };
                (l, r) = (rate(l)?, rate(r)?);
                if l != r {
                    out.derived.push(part.with((l, r)));
                }
            }
        }
        let bounded = reach.iter().all(|&c| c < HIGHEST) && orders.len() <= MOST_EQUATIONS;
        if settled && bounded && of.iter().all(Option::is_some) {
            let mut rows = Vec::new();
            for (i, part) in out.parts.iter().enumerate() {
                let residual = graph.sub(part.left, part.right);
                let mut row = Vec::new();
                for (&j, &order) in &orders[i] {
                    if reach[j].checked_sub(depth[i]) == Some(order) {
                        let (symbol, component) = variables[j];
                        let leaf = Leaf { rate: order, ..Leaf::now(symbol, component) };
                        let slope = graph.slope(residual, leaf).map_err(|_| Reason::NoDerivative)?;
                        row.push((j, slope));
                    }
                }
                row.sort_unstable();
                rows.push(row);
            }
            out.matrix = Some(rows);
        }
        Ok(out)
    }

    /// Whether a motion passes through a point at which the equations and their derivatives hold.
    pub(super) fn extends(&self, graph: &Graph, point: &Point) -> bool {
        if self.impossible {
            return false;
        }
        if self.parts.is_empty() {
            return true;
        }
        let still = |(leaf, value): &(Leaf, super::outcome::PointValue)| {
            leaf.rate == 0 || value.exact.as_ref().is_some_and(|r| *r == Rational::ZERO)
        };
        if !self.timely && point.values.iter().all(still) {
            return stays(point);
        }
        // A motion leads from one time to another: values at several of them cannot be chosen.
        if self.fixed {
            return false;
        }
        let Some(matrix) = &self.matrix else { return false };
        let values = values_at(point);
        independent(graph, matrix, &values)
    }
}

/// Whether the rows of a matrix are linearly independent for certain.
fn independent(graph: &Graph, matrix: &[Vec<(usize, Expr)>], values: &Values) -> bool {
    let entries: Vec<Expr> = matrix.iter().flatten().map(|&(_, e)| e).collect();
    let mut known = decimals(graph, &entries, values).into_iter();
    let mut rows: Vec<FastMap<usize, Bounded>> = Vec::new();
    for row in matrix {
        let mut out = FastMap::default();
        for &(j, _) in row {
            match known.next().flatten() {
                Some(v) => out.insert(j, v),
                None => return false,
            };
        }
        rows.push(out);
    }
    while !rows.is_empty() {
        // The largest entry that is not 0 for certain.
        let mut best: Option<(usize, usize, f64)> = None;
        for (i, row) in rows.iter().enumerate() {
            for (&j, v) in row {
                let size = v.value.abs() - v.error;
                let better = best.is_none_or(|(bi, bj, b)| size > b || size == b && (i, j) < (bi, bj));
                if size > 0.0 && size.is_finite() && better {
                    best = Some((i, j, size));
                }
            }
        }
        let Some((i, j, _)) = best else { return false };
        let pivot = rows.swap_remove(i);
        let Some(&by) = pivot.get(&j) else { return false };
        for row in &mut rows {
            let Some(top) = row.remove(&j) else { continue };
            for (&k, v) in pivot.iter().filter(|(k, _)| **k != j) {
                let zero = Bounded::exact(0.0);
                let old = row.get(&k).copied().unwrap_or(zero);
                let Some(new) = eliminated(old, top, by, *v) else { return false };
                row.insert(k, new);
            }
        }
    }
    true
}

/// old − top/by·v.
fn eliminated(old: Bounded, top: Bounded, by: Bounded, v: Bounded) -> Option<Bounded> {
    let mut factor = Bounded::exact(0.0);
    Number::div(&mut factor, &(), &top, &by).ok()?;
    let mut product = Bounded::exact(0.0);
    Number::mul(&mut product, &(), &factor, &v).ok()?;
    let mut out = Bounded::exact(0.0);
    Number::sub(&mut out, &(), &old, &product).ok()?;
    Some(out)
}

/// A variable for each equation, all different, such that the sum of their orders is largest; `None` for equations that are left
/// over (the assignment problem, by shortest augmenting paths).
fn assigned(orders: &[FastMap<usize, u8>], variables: usize) -> Vec<Option<usize>> {
    const NONE: i64 = 10_000;
    const LEFT_OVER: i64 = 1_000;
    let n = orders.len();
    // One column for each variable, and one for each equation that is left over.
    let m = variables + n;
    let cost = |i: usize, j: usize| match (j < variables).then(|| orders[i].get(&j)) {
        None if j - variables == i => LEFT_OVER,
        None => NONE,
        Some(Some(&order)) => 16 - i64::from(order),
        Some(None) => NONE,
    };
    let (mut u, mut v) = (vec![0_i64; n + 1], vec![0_i64; m + 1]);
    let mut row_of = vec![0_usize; m + 1];
    for i in 1..=n {
        row_of[0] = i;
        let mut at = 0;
        let (mut least, mut used, mut way) = (vec![i64::MAX; m + 1], vec![false; m + 1], vec![0_usize; m + 1]);
        loop {
            used[at] = true;
            let row = row_of[at];
            let (mut delta, mut next) = (i64::MAX, 0);
            for j in 1..=m {
                if used[j] {
                    continue;
                }
                let reduced = cost(row - 1, j - 1) - u[row] - v[j];
                if reduced < least[j] {
                    (least[j], way[j]) = (reduced, at);
                }
                if least[j] < delta {
                    (delta, next) = (least[j], j);
                }
            }
            for j in 0..=m {
                if used[j] {
                    u[row_of[j]] += delta;
                    v[j] -= delta;
                } else {
                    least[j] = least[j].saturating_sub(delta);
                }
            }
            at = next;
            if row_of[at] == 0 {
                break;
            }
        }
        while at != 0 {
            row_of[at] = row_of[way[at]];
            at = way[at];
        }
    }
    let mut out = vec![None; n];
    for j in 1..=variables {
        if row_of[j] > 0 && orders[row_of[j] - 1].contains_key(&(j - 1)) {
            out[row_of[j] - 1] = Some(j - 1);
        }
    }
    out
}

/// Equations that together say what l = r says of real numbers: the terms of a sum of squares, the base of a power.
fn taken_apart(graph: &mut Graph, l: Expr, r: Expr) -> Vec<(Expr, Expr)> {
    let residual = graph.sub(l, r);
    let mut terms = Vec::new();
    let whole = [residual, graph.neg(residual)];
    let found = whole.into_iter().any(|e| {
        terms.clear();
        vanishing_terms(graph, e, &mut terms)
    });
    if !found {
        terms = squares(graph, residual);
    }
    if terms.is_empty() {
        return vec![(l, r)];
    }
    let zero = graph.integer(0);
    let mut out = Vec::new();
    for e in terms {
        match graph.as_constant(e) {
            Some(_) => out.push((e, zero)),
            None if graph.reachable([e]).len() < graph.reachable([residual]).len() => {
                out.extend(taken_apart(graph, e, zero));
            }
            None => out.push((e, zero)),
        }
    }
    out
}

/// What vanishes where an expression does, if it is by its structure a sum of terms that are not negative.
fn vanishing_terms(graph: &Graph, e: Expr, out: &mut Vec<Expr>) -> bool {
    let positive = |e: Expr| graph.as_constant(e).is_some_and(|r| *r > Rational::ZERO);
    match *graph.node(e) {
        Node::Unary(Op::Powi(n), a) if n > 0 && n % 2 == 0 => out.push(a),
        Node::Unary(Op::Abs | Op::Sqrt, a) => out.push(a),
        Node::Binary(Op::Add, a, b) => return vanishing_terms(graph, a, out) && vanishing_terms(graph, b, out),
        Node::Binary(Op::Mul, a, b) if a == b => out.push(a),
        Node::Binary(Op::Mul, a, b) if positive(a) => return vanishing_terms(graph, b, out),
        Node::Binary(Op::Mul | Op::Div, a, b) if positive(b) => return vanishing_terms(graph, a, out),
        _ => return false,
    }
    true
}

/// The bases of a sum of even powers with coefficients of one sign, after expansion; of a single odd power, its base.
fn squares(graph: &mut Graph, e: Expr) -> Vec<Expr> {
    if let Node::Unary(Op::Powi(n), a) = *graph.node(e)
        && n > 0
    {
        return vec![a];
    }
    let combination = Combinations::default().of(graph, e);
    let positive = combination.values().filter(|q| **q > Rational::ZERO).count();
    let even = combination.keys().all(|m| !m.is_empty() && m.iter().all(|&(_, k)| k > 0 && k % 2 == 0));
    if combination.is_empty() || !even || positive != 0 && positive != combination.len() {
        return Vec::new();
    }
    let monomials: Vec<_> = combination.into_keys().collect();
    monomials
        .into_iter()
        .map(|m| {
            let mut product = graph.integer(1);
            for (base, k) in m {
                let power = graph.powi(base, k / 2);
                product = graph.mul(product, power);
            }
            product
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn orders(rows: &[&[(usize, u8)]]) -> Vec<FastMap<usize, u8>> {
        rows.iter().map(|row| row.iter().copied().collect()).collect()
    }

    #[test]
    fn assignments_have_the_largest_sum() {
        // ẋ = y, ẏ = −x
        assert_eq!(assigned(&orders(&[&[(0, 1), (1, 0)], &[(1, 1), (0, 0)]]), 2), [Some(0), Some(1)]);
        // The pendulum in a plane: ẍ = λx, ÿ = λy − g, x² + y² = l²
        let pendulum = orders(&[&[(0, 2), (2, 0)], &[(1, 2), (2, 0)], &[(0, 0), (1, 0)]]);
        let found = assigned(&pendulum, 3);
        let sum: u8 = found.iter().enumerate().map(|(i, j)| pendulum[i][&j.expect("assigned")]).sum();
        assert_eq!(sum, 2);
        // Three equations for two unknowns.
        let found = assigned(&orders(&[&[(0, 1)], &[(0, 0), (1, 0)], &[(0, 0), (1, 0)]]), 2);
        assert_eq!(found.iter().filter(|f| f.is_none()).count(), 1);
    }
}
