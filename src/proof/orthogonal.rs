//! Orthogonal matrices among the premises, parametrised.
//!
//! **In:** lowered residuals that vanish. **Out:** definitions entry := rational function of free numbers.
//!
//! XᵀX = 1 (or XXᵀ = 1) solved entry by entry divides by entries that may be 0, and takes roots. It is recognised instead by
//! what it says: n vectors of n variables, each of length 1, pairwise orthogonal, n = 2 or 3. Equations are compared as
//! expanded polynomials with rational coefficients, so recognition is exact. Then
//!
//! * n = 3: X = σ·Q(a, b, c, d)/(a² + b² + c² + d²) with the rotation matrix Q of a quaternion (Euler 1770, Rodrigues 1840),
//! * n = 2: X = (c, −σs; s, σc) with c + is = (a + ib)²/(a² + b²),
//!
//! for a sign σ = det X, or its value where a premise gives it. Every orthogonal matrix is of this form, real or complex
//! (a² + b² + c² + d² ≠ 0), so that nothing is left out and no pivot is needed. Where the rates of all entries occur,
//! Ẋ = X·W with a free antisymmetric W: all that the derivative of XᵀX = 1 says.

use super::generators::{Generator, Generators};
use super::linear::{Combination, Combinations};
use expr::{Expr, FastSet, Graph, Leaf, Node, Rational};

/// Matrices found, as definitions of their entries.
#[derive(Clone, Debug, Default)]
pub(super) struct Orthogonal {
    /// Entry (or its rate) := expression in free numbers.
    pub(super) definitions: Vec<(Leaf, Expr)>,
    /// Sums of squares that are divided by: not 0.
    pub(super) norms: Vec<Expr>,
}

/// n entries of length 1, with the equations that pair them with others.
type Row = Vec<Leaf>;

/// Finds the orthogonal matrices that residuals describe; `occurring` are the leaves of the whole problem, and `combinations` what
/// is known of the graph.
pub(super) fn orthogonal(
    graph: &mut Graph,
    generators: &mut Generators,
    combinations: &mut Combinations,
    residuals: &[Expr],
    occurring: &[Leaf],
) -> Orthogonal {
    let polynomials = reduced(graph, combinations, residuals);
    let mut out = Orthogonal::default();
    let mut taken: FastSet<Leaf> = FastSet::default();
    for size in [3, 2] {
        let units: Vec<Row> = polynomials.iter().filter_map(|p| unit(graph, p, size)).collect();
        let pairings: Vec<Vec<(Leaf, Leaf)>> = polynomials.iter().filter_map(|p| pairing(graph, p, size)).collect();
        for first in &units {
            let Some(matrix) = complete(first, &units, &pairings) else { continue };
            if matrix.iter().flatten().any(|l| taken.contains(l)) {
                continue;
            }
            taken.extend(matrix.iter().flatten());
            let determinant = known_determinant(graph, &matrix, &polynomials);
            parametrise(graph, generators, &matrix, determinant, occurring, &mut out);
        }
    }
    out
}

/// The residuals as polynomials, those that are sums or differences of two others reduced by them.
fn reduced(graph: &Graph, combinations: &mut Combinations, residuals: &[Expr]) -> Vec<Combination> {
    let mut all: Vec<Combination> = residuals.iter().map(|&e| combinations.of(graph, e)).collect();
    all.retain(|p| p.len() > 1);
    let own = |p: &Combination| (2..=3).any(|n| unit(graph, p, n).is_some() || pairing(graph, p, n).is_some());
    let known: Vec<Combination> = all.iter().filter(|p| own(p)).cloned().collect();
    if known.is_empty() {
        return all;
    }
    for p in all.iter_mut().filter(|p| !own(p)) {
        for k in &known {
            let Some((lead, q)) = k.iter().find(|(m, _)| !m.is_empty()) else { continue };
            let Some(factor) = p.get(lead).map(|c| c / q) else { continue };
            for (m, q) in k {
                let rest = p.remove(m).unwrap_or(Rational::ZERO) - q * &factor;
                if rest != Rational::ZERO {
                    p.insert(m.clone(), rest);
                }
            }
        }
    }
    all
}

fn as_leaf(graph: &Graph, e: Expr) -> Option<Leaf> {
    match graph.node(e) {
        Node::Leaf(leaf) if leaf.rate == 0 => Some(*leaf),
        _ => None,
    }
}

/// Σ aᵢ² = 1: the aᵢ.
fn unit(graph: &Graph, p: &Combination, size: usize) -> Option<Row> {
    if p.len() != size + 1 {
        return None;
    }
    let constant = p.get(&Vec::new())?;
    let mut row = Row::new();
    for (m, q) in p.iter().filter(|(m, _)| !m.is_empty()) {
        match m.as_slice() {
            &[(base, 2)] if *q == -constant.clone() => row.push(as_leaf(graph, base)?),
            _ => return None,
        }
    }
    Some(row)
}

/// Σ aᵢbᵢ = 0: the pairs.
fn pairing(graph: &Graph, p: &Combination, size: usize) -> Option<Vec<(Leaf, Leaf)>> {
    let first = p.values().next()?;
    if p.len() != size || p.values().any(|q| q != first) {
        return None;
    }
    let pair = |m: &Vec<(Expr, i32)>| match m.as_slice() {
        &[(a, 1), (b, 1)] => Some((as_leaf(graph, a)?, as_leaf(graph, b)?)),
        _ => None,
    };
    p.keys().map(pair).collect()
}

/// The other rows of a matrix with this first row, their entries in the same order.
fn complete(first: &Row, units: &[Row], pairings: &[Vec<(Leaf, Leaf)>]) -> Option<Vec<Row>> {
    let mut matrix = vec![first.clone()];
    for pairs in pairings {
        let partner =
            |l: &Leaf| pairs.iter().find_map(|&(a, b)| if a == *l { Some(b) } else { (b == *l).then_some(a) });
        let Some(row) = first.iter().map(partner).collect::<Option<Row>>() else { continue };
        let same = |u: &Row| u.iter().all(|l| row.contains(l));
        if units.iter().any(same) && !matrix.iter().flatten().any(|l| row.contains(l)) {
            matrix.push(row);
        }
    }
    if matrix.len() < first.len() {
        return None;
    }
    matrix.truncate(first.len());
    // The other rows must be orthogonal to each other as well, entry by entry.
    let orthogonal = |a: &Row, b: &Row| {
        pairings.iter().any(|pairs| a.iter().zip(b).all(|(&x, &y)| pairs.contains(&(x, y)) || pairs.contains(&(y, x))))
    };
    let paired = |i: usize| (i + 1..matrix.len()).all(|j| orthogonal(&matrix[i], &matrix[j]));
    (0..matrix.len()).all(paired).then_some(matrix)
}

/// det X as a polynomial in the entries, by the formula for n = 2 or 3.
fn determinant(graph: &mut Graph, m: &[Row]) -> Expr {
    let minor = |graph: &mut Graph, (i, j): (usize, usize), (k, l): (usize, usize)| {
        let entries = [m[i][k], m[j][l], m[i][l], m[j][k]].map(|x| graph.leaf(x));
        let (p, q) = (graph.mul(entries[0], entries[1]), graph.mul(entries[2], entries[3]));
        graph.sub(p, q)
    };
    if m.len() == 2 {
        return minor(graph, (0, 1), (0, 1));
    }
    let mut sum = graph.integer(0);
    for (k, columns) in [(0, (1, 2)), (1, (2, 0)), (2, (0, 1))] {
        let factor = minor(graph, (1, 2), columns);
        let entry = graph.leaf(m[0][k]);
        let term = graph.mul(entry, factor);
        sum = graph.add(sum, term);
    }
    sum
}

/// det X where a premise gives it: 1 or −1.
fn known_determinant(graph: &mut Graph, matrix: &[Row], polynomials: &[Combination]) -> Option<i64> {
    let d = determinant(graph, matrix);
    let d = Combinations::default().of(graph, d);
    polynomials.iter().find_map(|p| {
        let constant = p.get(&Vec::new())?;
        let (lead, q) = d.iter().next()?;
        let scale = p.get(lead)? / q;
        let same = p.len() == d.len() + 1 && d.iter().all(|(m, q)| p.get(m) == Some(&(q * &scale)));
        let value = -(constant / scale);
        match () {
            () if !same => None,
            () if value == Rational::ONE => Some(1),
            () if value == -Rational::ONE => Some(-1),
            () => None,
        }
    })
}

fn parametrise(
    graph: &mut Graph,
    generators: &mut Generators,
    matrix: &[Row],
    determinant: Option<i64>,
    occurring: &[Leaf],
    out: &mut Orthogonal,
) {
    let free = |graph: &mut Graph, generators: &mut Generators, kind: Generator| {
        generators.add(kind).map(|leaf| graph.leaf(leaf))
    };
    let sign = match determinant {
        Some(value) => Some(graph.integer(value)),
        None => free(graph, generators, Generator::Sign),
    };
    let n = matrix.len();
    let count = if n == 3 { 4 } else { 2 };
    let numbers: Option<Vec<Expr>> = (0..count).map(|_| free(graph, generators, Generator::Free)).collect();
    let (Some(sign), Some(numbers)) = (sign, numbers) else { return };
    let squares: Vec<Expr> = numbers.iter().map(|&x| graph.powi(x, 2)).collect();
    let norm = squares[1..].iter().fold(squares[0], |sum, &x| graph.add(sum, x));
    let mut entries: Vec<Vec<Expr>> = Vec::new();
    if let [a, b, c, d] = *numbers.as_slice() {
        let two = graph.integer(2);
        let twice = |graph: &mut Graph, (x, y): (Expr, Expr), (z, w): (Expr, Expr), minus: bool| {
            let (p, q) = (graph.mul(x, y), graph.mul(z, w));
            let sum = if minus { graph.sub(p, q) } else { graph.add(p, q) };
            graph.mul(two, sum)
        };
        let diagonal = |graph: &mut Graph, i: usize| {
            let (mut plus, mut minus) = (squares[0], graph.integer(0));
            for (k, &square) in squares.iter().enumerate().skip(1) {
                if k == i + 1 {
                    plus = graph.add(plus, square);
                } else {
                    minus = graph.add(minus, square);
                }
            }
            graph.sub(plus, minus)
        };
        entries.push(vec![diagonal(graph, 0), twice(graph, (b, c), (a, d), true), twice(graph, (b, d), (a, c), false)]);
        entries.push(vec![twice(graph, (b, c), (a, d), false), diagonal(graph, 1), twice(graph, (c, d), (a, b), true)]);
        entries.push(vec![twice(graph, (b, d), (a, c), true), twice(graph, (c, d), (a, b), false), diagonal(graph, 2)]);
        for entry in entries.iter_mut().flatten() {
            *entry = graph.mul(sign, *entry);
        }
    } else if let [a, b] = *numbers.as_slice() {
        let two = graph.integer(2);
        let (cosine, product) = (graph.sub(squares[0], squares[1]), graph.mul(a, b));
        let sine = graph.mul(two, product);
        let (other_cosine, other_sine) = (graph.mul(sign, cosine), graph.mul(sign, sine));
        entries.push(vec![cosine, graph.neg(other_sine)]);
        entries.push(vec![sine, other_cosine]);
    }
    out.norms.push(norm);
    let mut definitions = Vec::new();
    for (row, values) in matrix.iter().zip(&entries) {
        for (&leaf, &value) in row.iter().zip(values) {
            let value = graph.div(value, norm);
            definitions.push((leaf, value));
        }
    }
    let rate = |leaf: Leaf| Leaf { rate: 1, ..leaf };
    if matrix.iter().flatten().all(|&l| occurring.contains(&rate(l))) {
        let pairs: &[(usize, usize)] = if n == 3 { &[(2, 1), (0, 2), (1, 0)] } else { &[(1, 0)] };
        let mut w = vec![vec![graph.integer(0); n]; n];
        for &(i, j) in pairs {
            let Some(x) = free(graph, generators, Generator::Free) else { continue };
            w[i][j] = x;
            w[j][i] = graph.neg(x);
        }
        for row in matrix {
            for (j, &leaf) in row.iter().enumerate() {
                let mut sum = graph.integer(0);
                for (k, &entry) in row.iter().enumerate() {
                    let entry = graph.leaf(entry);
                    let term = graph.mul(entry, w[k][j]);
                    sum = graph.add(sum, term);
                }
                // Rates first: they contain the entries.
                out.definitions.push((rate(leaf), sum));
            }
        }
    }
    out.definitions.extend(definitions);
}
