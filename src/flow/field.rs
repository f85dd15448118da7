//! Systems of equations, solved for their rates.

use std::collections::BTreeMap;

use super::error::{FlowError, leaf_name};
use expr::{Expr, Graph, Leaf, Node, Op, Symbol};

/// A system ẋ = f(x, t): the ordered state leaves and the expression of each one's rate.
///
/// The rates depend on `time`, on the states and on leaves that stay constant ([`VectorField::parameters`]).
#[derive(Clone, Debug, PartialEq)]
pub struct VectorField {
    time: Option<Leaf>,
    states: Vec<Leaf>,
    rates: Vec<Expr>,
    parameters: Vec<Leaf>,
    most_steps: usize,
}

/// Largest number of steps of a trajectory in each direction.
const MAX_STEPS: usize = 40_000;

/// An expression as Σ coefficient · unknown + rest. A rest of `None` is a structural zero.
#[derive(Clone, Debug, Default)]
struct Affine {
    coefficients: BTreeMap<usize, Expr>,
    rest: Option<Expr>,
}

impl VectorField {
    /// The same with a limit of the steps of a motion, in each direction; there is one in any case.
    ///
    /// A motion keeps what it needs of every step: many of them in one file must share the memory.
    pub fn with_most_steps(self, most_steps: usize) -> VectorField {
        VectorField { most_steps: most_steps.min(MAX_STEPS), ..self }
    }

    /// Largest number of steps of a motion in each direction.
    pub fn most_steps(&self) -> usize {
        self.most_steps
    }

    /// Solves equations, which may be implicit in the rates, for the highest rate of every state.
    ///
    /// A state symbol whose highest rate in the equations is n contributes x, ẋ … x⁽ⁿ⁻¹⁾ to the state. Equations whose two
    /// sides are both the constant 0 (entries outside the diagonal of a diagonal matrix) are skipped. An equation that is
    /// explicit stays as it is written. The others are put in block triangular form; a block of up to 4 rates is solved by
    /// Cramer's rule, so that the only divisor is its determinant, a larger one by elimination.
    ///
    /// # Shapes
    /// `equations`: pairs (left side, right side) of scalar expressions. States are ordered by symbol as in `states`, then
    /// by rate, then by component.
    ///
    /// # Errors
    /// [`FlowError::Nonlinear`], [`FlowError::Constraint`], [`FlowError::NoEquation`], [`FlowError::Undetermined`],
    /// [`FlowError::OverDetermined`]. A determinant that is 0 only in numbers is found when the field is evaluated.
    pub fn solve(
        graph: &mut Graph,
        time: Option<Leaf>,
        states: &[Symbol],
        equations: &[(Expr, Expr)],
    ) -> Result<VectorField, FlowError> {
        let all = graph.leaves(equations.iter().flat_map(|&(l, r)| [l, r]));
        let mut unknowns: Vec<Leaf> = Vec::new();
        let mut state_leaves: Vec<Leaf> = Vec::new();
        for &symbol in states {
            let present = |l: &&Leaf| l.symbol == symbol && l.instant.is_none();
            let order = all.iter().filter(present).map(|l| l.rate).max().unwrap_or(0);
            if order == 0 {
                return Err(FlowError::NoEquation { state: graph.name(symbol).to_owned() });
            }
            let leaves = |rate| {
                let components = 0..graph.component_count(symbol) as u16;
                components.map(move |component| Leaf { rate, ..Leaf::now(symbol, component) })
            };
            state_leaves.extend((0..order).flat_map(leaves));
            unknowns.extend(leaves(order));
        }

        let place: BTreeMap<Leaf, usize> = unknowns.iter().enumerate().map(|(i, &l)| (l, i)).collect();
        let mut rows: Vec<(usize, Affine)> = Vec::new();
        let mut solution: Vec<Option<Expr>> = vec![None; unknowns.len()];
        for (number, &(left, right)) in equations.iter().enumerate() {
            if graph.is_zero(left) && graph.is_zero(right) {
                continue;
            }
            let l = affine(graph, left, &place).map_err(|u| nonlinear(graph, number, unknowns[u]))?;
            let r = affine(graph, right, &place).map_err(|u| nonlinear(graph, number, unknowns[u]))?;
            let mut row = subtract(graph, l, r);
            row.coefficients.retain(|_, c| !graph.vanishes(*c));
            if row.coefficients.is_empty() && row.rest.is_none_or(|rest| graph.vanishes(rest)) {
                // 0 = 0 wherever both sides have values.
                continue;
            }
            if row.coefficients.is_empty() {
                return Err(FlowError::Constraint { equation: number });
            }
            rows.push((number, row));
        }

        let matched = matching(&rows, unknowns.len());
        let found = rows.len();
        let needed = unknowns.len();
        let row_of = |u: usize| matched.iter().position(|&m| m == Some(u));
        if let Some(u) = (0..needed).find(|&u| row_of(u).is_none()) {
            return Err(FlowError::Undetermined { rate: leaf_name(graph, unknowns[u]), found, needed });
        }
        if let Some(row) = matched.iter().position(Option::is_none) {
            return Err(FlowError::OverDetermined { equation: rows[row].0, found, needed });
        }
        let row_of: Vec<usize> = (0..needed).filter_map(row_of).collect();

        for block in blocks(&rows, &row_of) {
            solve_block(graph, &rows, &row_of, &block, &mut solution, equations, &unknowns);
        }

        let mut rates = Vec::with_capacity(state_leaves.len());
        for &leaf in &state_leaves {
            let up = Leaf { rate: leaf.rate + 1, ..leaf };
            rates.push(match place.get(&up).and_then(|&u| solution[u]) {
                Some(rate) => rate,
                None => graph.leaf(up),
            });
        }
        Ok(VectorField::explicit(graph, time, state_leaves, rates))
    }

    /// A field that is given as it is: `rates[i]` is the rate of `states[i]`.
    pub fn explicit(graph: &Graph, time: Option<Leaf>, states: Vec<Leaf>, rates: Vec<Expr>) -> VectorField {
        let parameters = graph
            .leaves(rates.iter().copied())
            .into_iter()
            .filter(|l| Some(*l) != time && !states.contains(l))
            .collect();
        VectorField { time, states, rates, parameters, most_steps: MAX_STEPS }
    }

    /// The time leaf the field may depend on.
    pub fn time(&self) -> Option<Leaf> {
        self.time
    }

    /// The state variables, in order.
    pub fn states(&self) -> &[Leaf] {
        &self.states
    }

    /// The rate of every state variable, in the order of [`VectorField::states`].
    pub fn rates(&self) -> &[Expr] {
        &self.rates
    }

    /// The leaves of the rates that are neither time nor state.
    pub fn parameters(&self) -> &[Leaf] {
        &self.parameters
    }

    /// The rate of a state variable.
    pub fn rate(&self, state: Leaf) -> Option<Expr> {
        self.states.iter().position(|&l| l == state).map(|i| self.rates[i])
    }
}

fn nonlinear(graph: &Graph, equation: usize, rate: Leaf) -> FlowError {
    FlowError::Nonlinear { equation, rate: leaf_name(graph, rate) }
}

/// Splits `e` into coefficients and rest; the error is an unknown that enters in another way.
fn affine(graph: &mut Graph, e: Expr, unknowns: &BTreeMap<Leaf, usize>) -> Result<Affine, usize> {
    let mut done: BTreeMap<Expr, Affine> = BTreeMap::new();
    let one = graph.integer(1);
    for node in graph.reachable([e]) {
        let free = |a: &Affine| a.coefficients.is_empty();
        let first = |a: &Affine| a.coefficients.keys().next().copied().unwrap_or(0);
        let value = match graph.node(node).clone() {
            Node::Leaf(leaf) if unknowns.contains_key(&leaf) => {
                Affine { coefficients: [(unknowns[&leaf], one)].into(), rest: None }
            }
            Node::Constant(_) | Node::Pi | Node::Leaf(_) => Affine { rest: Some(node), ..Affine::default() },
            Node::Unary(op, a) => match (op, &done[&a]) {
                (_, x) if free(x) => Affine { rest: Some(node), ..Affine::default() },
                (Op::Neg, x) => {
                    let x = x.clone();
                    map(graph, x, |g, c| g.neg(c))
                }
                (_, x) => return Err(first(x)),
            },
            Node::Binary(op, a, b) => match (op, &done[&a], &done[&b]) {
                (_, x, y) if free(x) && free(y) => Affine { rest: Some(node), ..Affine::default() },
                (Op::Add, x, y) => {
                    let (x, y) = (x.clone(), y.clone());
                    let y = map(graph, y, |g, c| g.neg(c));
                    subtract(graph, x, y)
                }
                (Op::Sub, x, y) => {
                    let (x, y) = (x.clone(), y.clone());
                    subtract(graph, x, y)
                }
                (Op::Mul, x, y) if free(x) => {
                    let y = y.clone();
                    map(graph, y, |g, c| g.mul(a, c))
                }
                (Op::Mul, x, y) if free(y) => {
                    let x = x.clone();
                    map(graph, x, |g, c| g.mul(c, b))
                }
                (Op::Div, x, y) if free(y) => {
                    let x = x.clone();
                    map(graph, x, |g, c| g.div(c, b))
                }
                // A sum has a value only where each of its terms has one.
                (Op::Restrict, x, y) if free(y) => {
                    let x = x.clone();
                    map(graph, x, |g, c| g.binary(Op::Restrict, c, b))
                }
                (_, x, y) => return Err(if free(y) { first(x) } else { first(y) }),
            },
        };
        done.insert(node, value);
    }
    Ok(done.remove(&e).unwrap_or_default())
}

fn map(graph: &mut Graph, a: Affine, f: impl Fn(&mut Graph, Expr) -> Expr) -> Affine {
    Affine {
        coefficients: a.coefficients.into_iter().map(|(u, c)| (u, f(graph, c))).collect(),
        rest: a.rest.map(|r| f(graph, r)),
    }
}

/// a − b; terms that cancel exactly as written disappear.
fn subtract(graph: &mut Graph, a: Affine, b: Affine) -> Affine {
    let mut out = a;
    for (u, c) in b.coefficients {
        let d = match out.coefficients.get(&u) {
            Some(&x) if x == c => {
                out.coefficients.remove(&u);
                continue;
            }
            Some(&x) => graph.sub(x, c),
            None => graph.neg(c),
        };
        if graph.is_zero(d) {
            out.coefficients.remove(&u);
        } else {
            out.coefficients.insert(u, d);
        }
    }
    out.rest = difference(graph, out.rest, b.rest);
    out
}

fn difference(graph: &mut Graph, a: Option<Expr>, b: Option<Expr>) -> Option<Expr> {
    let zero = |e: &Expr| !graph.is_zero(*e);
    match (a.filter(zero), b.filter(zero)) {
        (a, None) => a,
        (None, Some(b)) => Some(graph.neg(b)),
        (Some(a), Some(b)) => match graph.node(b).clone() {
            Node::Unary(Op::Neg, inner) => Some(graph.add(a, inner)),
            _ => Some(graph.sub(a, b)),
        },
    }
}

/// A maximum matching of equations with unknowns (augmenting paths, searched in order: deterministic).
fn matching(rows: &[(usize, Affine)], unknowns: usize) -> Vec<Option<usize>> {
    let mut row_of: Vec<Option<usize>> = vec![None; unknowns];
    for start in 0..rows.len() {
        // Breadth-first search for an augmenting path from `start`.
        let mut came_from: Vec<Option<usize>> = vec![None; unknowns];
        let mut queue = std::collections::VecDeque::from([start]);
        let mut free = None;
        'search: while let Some(row) = queue.pop_front() {
            for &u in rows[row].1.coefficients.keys() {
                if came_from[u].is_none() {
                    came_from[u] = Some(row);
                    match row_of[u] {
                        None => {
                            free = Some(u);
                            break 'search;
                        }
                        Some(next) => queue.push_back(next),
                    }
                }
            }
        }
        while let Some(u) = free {
            let Some(row) = came_from[u] else { break };
            free = if row == start { None } else { row_of.iter().position(|&r| r == Some(row)) };
            row_of[u] = Some(row);
        }
    }
    let mut matched = vec![None; rows.len()];
    for (u, row) in row_of.iter().enumerate() {
        if let Some(row) = row {
            matched[*row] = Some(u);
        }
    }
    matched
}

/// Strongly connected blocks of unknowns, each after those it depends on (Tarjan, with the stack on the heap).
fn blocks(rows: &[(usize, Affine)], row_of: &[usize]) -> Vec<Vec<usize>> {
    let n = row_of.len();
    let needs: Vec<Vec<usize>> =
        (0..n).map(|u| rows[row_of[u]].1.coefficients.keys().copied().filter(|&v| v != u).collect()).collect();
    let (mut index, mut low) = (vec![usize::MAX; n], vec![0; n]);
    let (mut on_stack, mut stack) = (vec![false; n], Vec::new());
    let (mut counter, mut out) = (0, Vec::new());
    for root in 0..n {
        if index[root] != usize::MAX {
            continue;
        }
        let mut work = vec![(root, 0)];
        while let Some((u, at)) = work.pop() {
            if at == 0 {
                index[u] = counter;
                low[u] = counter;
                counter += 1;
                stack.push(u);
                on_stack[u] = true;
            } else {
                low[u] = low[u].min(low[needs[u][at - 1]]);
            }
            let mut next = at;
            while let Some(&v) = needs[u].get(next) {
                next += 1;
                if index[v] == usize::MAX {
                    work.push((u, next));
                    work.push((v, 0));
                    next = usize::MAX;
                    break;
                } else if on_stack[v] {
                    low[u] = low[u].min(index[v]);
                }
            }
            if next != usize::MAX && low[u] == index[u] {
                let mut block = Vec::new();
                while let Some(v) = stack.pop() {
                    on_stack[v] = false;
                    block.push(v);
                    if v == u {
                        break;
                    }
                }
                block.sort_unstable();
                out.push(block);
            }
        }
    }
    out
}

/// Solves one block; the unknowns it depends on are solved already.
fn solve_block(
    graph: &mut Graph,
    rows: &[(usize, Affine)],
    row_of: &[usize],
    block: &[usize],
    solution: &mut [Option<Expr>],
    equations: &[(Expr, Expr)],
    unknowns: &[Leaf],
) {
    if let [u] = *block {
        let (number, row) = &rows[row_of[u]];
        let (left, right) = equations[*number];
        let itself = graph.leaf(unknowns[u]);
        if row.coefficients.len() == 1 && (left == itself || right == itself) {
            solution[u] = Some(if left == itself { right } else { left });
            return;
        }
    }
    let n = block.len();
    let mut matrix: Vec<Vec<Option<Expr>>> = Vec::with_capacity(n);
    let mut right: Vec<Option<Expr>> = Vec::with_capacity(n);
    for &u in block {
        let row = &rows[row_of[u]].1;
        matrix.push(block.iter().map(|v| row.coefficients.get(v).copied()).collect());
        // Σ a·u + rest = 0, so the right side is −rest − Σ over the unknowns that are known already.
        let mut b = difference(graph, None, row.rest);
        for (v, &c) in &row.coefficients {
            if let (false, Some(known)) = (block.contains(v), solution[*v]) {
                let term = graph.mul_structural(c, known);
                b = difference(graph, b, Some(term));
            }
        }
        right.push(b);
    }
    let zero = graph.integer(0);
    let found: Vec<Option<Expr>> =
        if n <= 4 { cramer(graph, &matrix, &right) } else { eliminate(graph, matrix, right) };
    for (&u, value) in block.iter().zip(found) {
        solution[u] = Some(value.unwrap_or(zero));
    }
}

fn product(graph: &mut Graph, a: Option<Expr>, b: Option<Expr>) -> Option<Expr> {
    Some(graph.mul(a?, b?))
}

/// x / d, with the signs of constants −1 taken out of the way. A structural zero stays one where d is a number; else it is 0 where d is not: where d is 0 the
/// equations leave the rate open.
fn quotient(graph: &mut Graph, x: Option<Expr>, d: Expr) -> Option<Expr> {
    let Some(x) = x else {
        if graph.as_constant(d).is_some() {
            return None;
        }
        let (zero, one) = (graph.integer(0), graph.integer(1));
        let inverse = graph.div(one, d);
        return Some(graph.binary(Op::Restrict, zero, inverse));
    };
    match graph.node(d).clone() {
        Node::Unary(Op::Neg, inner) => {
            let minus = graph.neg(x);
            Some(graph.div(minus, inner))
        }
        _ => Some(graph.div(x, d)),
    }
}

/// Determinant by expansion along the rows; `None` is a structural zero.
fn determinant(graph: &mut Graph, matrix: &[Vec<Option<Expr>>], columns: &[usize]) -> Option<Expr> {
    let (row, below) = matrix.split_first()?;
    if below.is_empty() {
        return row[columns[0]];
    }
    let mut sum = None;
    for (k, &column) in columns.iter().enumerate() {
        if row[column].is_none() {
            continue;
        }
        let rest: Vec<usize> = columns.iter().copied().filter(|&c| c != column).collect();
        let minor = determinant(graph, below, &rest);
        let mut term = product(graph, row[column], minor);
        if k % 2 == 0 {
            term = difference(graph, None, term);
        }
        sum = difference(graph, sum, term);
    }
    sum
}

fn cramer(graph: &mut Graph, matrix: &[Vec<Option<Expr>>], right: &[Option<Expr>]) -> Vec<Option<Expr>> {
    let n = matrix.len();
    let columns: Vec<usize> = (0..n).collect();
    let zero = graph.integer(0);
    let det = determinant(graph, matrix, &columns).unwrap_or(zero);
    (0..n)
        .map(|u| {
            let mut replaced = matrix.to_vec();
            for (row, &b) in replaced.iter_mut().zip(right) {
                row[u] = b;
            }
            let top = determinant(graph, &replaced, &columns);
            quotient(graph, top, det)
        })
        .collect()
}

/// Gaussian elimination with back substitution; the pivot of a column is the entry that is simplest as it is written.
fn eliminate(graph: &mut Graph, mut matrix: Vec<Vec<Option<Expr>>>, mut right: Vec<Option<Expr>>) -> Vec<Option<Expr>> {
    let n = matrix.len();
    let zero = graph.integer(0);
    for column in 0..n {
        let weight = |row: &Vec<Option<Expr>>| match row[column] {
            None => usize::MAX,
            Some(e) if graph.as_constant(e).is_some() => 0,
            Some(e) => graph.reachable([e]).len() + row.iter().flatten().count(),
        };
        let best = (column..n).min_by_key(|&r| weight(&matrix[r])).unwrap_or(column);
        matrix.swap(column, best);
        right.swap(column, best);
        let pivot = matrix[column][column].unwrap_or(zero);
        for row in column + 1..n {
            let Some(entry) = matrix[row][column] else { continue };
            let factor = Some(graph.div(entry, pivot));
            matrix[row][column] = None;
            let above = matrix[column].clone();
            for (entry, over) in matrix[row].iter_mut().zip(above).skip(column + 1) {
                let moved = product(graph, factor, over);
                *entry = difference(graph, *entry, moved);
            }
            let moved = product(graph, factor, right[column]);
            right[row] = difference(graph, right[row], moved);
        }
    }
    let mut found: Vec<Option<Expr>> = vec![None; n];
    for row in (0..n).rev() {
        let mut top = right[row];
        for k in row + 1..n {
            let term = product(graph, matrix[row][k], found[k]);
            top = difference(graph, top, term);
        }
        let pivot = matrix[row][row].unwrap_or(zero);
        found[row] = quotient(graph, top, pivot);
    }
    found
}
