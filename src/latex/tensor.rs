//! Products and other operations on tensors of expressions.
//!
//! Structural zeros (off the diagonal of a diagonal matrix, say) make no terms.

use std::ops::Range;

use super::elaborate::refuse;
use diag::Problem;
use expr::{Expr, Graph, Shape, Tensor};

type Elaborated<T> = Result<T, Box<Problem>>;

/// Σ of products, without the terms that have a structural zero.
fn inner(graph: &mut Graph, pairs: impl Iterator<Item = (Expr, Expr)>) -> Expr {
    let mut sum: Option<Expr> = None;
    for (a, b) in pairs {
        let term = graph.mul_structural(a, b);
        if !graph.is_zero(term) {
            sum = Some(match sum {
                Some(s) => graph.add(s, term),
                None => term,
            });
        }
    }
    sum.unwrap_or_else(|| graph.integer(0))
}

/// a·b for vectors.
pub(super) fn dot(graph: &mut Graph, a: &Tensor, b: &Tensor, span: &Range<usize>) -> Elaborated<Tensor> {
    if a.shape != b.shape || a.shape.rank() != 1 {
        return refuse("latex::shape", format!("no scalar product of a {} and a {}", a.shape, b.shape), span, "");
    }
    let pairs: Vec<(Expr, Expr)> = a.components.iter().copied().zip(b.components.iter().copied()).collect();
    Ok(Tensor::scalar(inner(graph, pairs.into_iter())))
}

/// a × b for vectors of three components.
pub(super) fn cross(graph: &mut Graph, a: &Tensor, b: &Tensor, span: &Range<usize>) -> Elaborated<Tensor> {
    if a.shape != Shape::vector(3) || b.shape != Shape::vector(3) {
        let message = format!("a vector product needs two vectors of 3, these are a {} and a {}", a.shape, b.shape);
        return refuse("latex::shape", message, span, r"for numbers write `\cdot`");
    }
    let components = (0..3)
        .map(|i| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            let left = graph.mul_structural(a.components[j], b.components[k]);
            let right = graph.mul_structural(a.components[k], b.components[j]);
            graph.sub(left, right)
        })
        .collect();
    Ok(Tensor { shape: Shape::vector(3), components })
}

/// Juxtaposed factors: scalars, matrices, and at most one vector at the end (a row vector at the beginning). With
/// `written_zero` a factor 0 was written by hand; the other factors then stay, since they may have no value.
pub(super) fn product(
    graph: &mut Graph,
    factors: Vec<(Tensor, Range<usize>)>,
    written_zero: bool,
    span: &Range<usize>,
) -> Elaborated<Tensor> {
    let times = |g: &mut Graph, a: Expr, b: Expr| if written_zero { g.mul(a, b) } else { g.mul_structural(a, b) };
    let mut scalar: Option<Expr> = None;
    let mut chain: Vec<(Tensor, Range<usize>)> = Vec::new();
    for (t, at) in factors {
        match t.as_scalar() {
            Some(e) => {
                scalar = Some(match scalar {
                    Some(s) => times(graph, s, e),
                    None => e,
                });
            }
            None => chain.push((t, at)),
        }
    }
    // From the right, so that a matrix chain that ends in a vector only makes vectors.
    let mut acc: Option<Tensor> = None;
    while let Some((t, at)) = chain.pop() {
        acc = Some(match acc {
            None => t,
            Some(right) => multiply(graph, &t, &right, &(at.start..span.end))?,
        });
    }
    match (scalar, acc) {
        (Some(s), Some(t)) => {
            let components = t.components.into_iter().map(|e| times(graph, s, e)).collect();
            Ok(Tensor { shape: t.shape, components })
        }
        (Some(s), None) => Ok(Tensor::scalar(s)),
        (None, Some(t)) => Ok(t),
        (None, None) => refuse("latex::empty", "an empty product", span, ""),
    }
}

fn multiply(graph: &mut Graph, a: &Tensor, b: &Tensor, span: &Range<usize>) -> Elaborated<Tensor> {
    if let Some(e) = b.as_scalar() {
        let components = a.components.iter().map(|&x| graph.mul_structural(x, e)).collect();
        return Ok(Tensor { shape: a.shape.clone(), components });
    }
    let mismatch = || {
        let hint = if a.shape.rank() == 1 && b.shape.rank() == 1 { r"write `\cdot`, `\times` or `^T`" } else { "" };
        refuse("latex::shape", format!("no product of a {} and a {}", a.shape, b.shape), span, hint)
    };
    match (a.shape.extents(), b.shape.extents()) {
        (&[n, m], &[k]) if m == k => {
            let components: Vec<Expr> = (0..n as usize)
                .map(|i| {
                    let row = &a.components[i * m as usize..(i + 1) * m as usize];
                    inner(graph, row.iter().copied().zip(b.components.iter().copied()))
                })
                .collect();
            // A row times a column is a number.
            if n == 1 {
                return Ok(Tensor { shape: Shape::scalar(), components });
            }
            Ok(Tensor { shape: Shape::vector(n), components })
        }
        (&[n, m], &[k, l]) if m == k => {
            let mut components = Vec::new();
            for i in 0..n as usize {
                for j in 0..l as usize {
                    let pairs: Vec<(Expr, Expr)> = (0..m as usize)
                        .map(|p| (a.components[i * m as usize + p], b.components[p * l as usize + j]))
                        .collect();
                    components.push(inner(graph, pairs.into_iter()));
                }
            }
            Ok(Tensor { shape: Shape::matrix(n, l), components })
        }
        // A column times a row is a matrix.
        (&[n], &[1, l]) => {
            let mut components = Vec::new();
            for i in 0..n as usize {
                for j in 0..l as usize {
                    components.push(graph.mul_structural(a.components[i], b.components[j]));
                }
            }
            Ok(Tensor { shape: Shape::matrix(n, l), components })
        }
        _ => mismatch(),
    }
}

/// The transpose; of a vector, a matrix of one row.
pub(super) fn transpose(t: &Tensor, span: &Range<usize>) -> Elaborated<Tensor> {
    match *t.shape.extents() {
        [n] => Ok(Tensor { shape: Shape::matrix(1, n), components: t.components.clone() }),
        [n, m] => {
            let mut components = Vec::new();
            for j in 0..m as usize {
                for i in 0..n as usize {
                    components.push(t.components[i * m as usize + j]);
                }
            }
            Ok(Tensor { shape: Shape::matrix(m, n), components })
        }
        _ => refuse("latex::shape", format!("a {} has no transpose", t.shape), span, ""),
    }
}

/// The matrix with this diagonal.
pub(super) fn diagonal(graph: &mut Graph, entries: &[Expr]) -> Tensor {
    let (n, zero) = (entries.len(), graph.integer(0));
    let components = (0..n * n).map(|p| if p / n == p % n { entries[p / n] } else { zero }).collect();
    Tensor { shape: Shape::matrix(n as u16, n as u16), components }
}

fn square(t: &Tensor, what: &str, span: &Range<usize>) -> Elaborated<usize> {
    match *t.shape.extents() {
        [n, m] if n == m => Ok(n as usize),
        _ => refuse("latex::shape", format!("a {what} needs a square matrix, this is a {}", t.shape), span, ""),
    }
}

/// The trace.
pub(super) fn trace(graph: &mut Graph, t: &Tensor, span: &Range<usize>) -> Elaborated<Tensor> {
    let n = square(t, "trace", span)?;
    let mut sum = graph.integer(0);
    for i in 0..n {
        sum = graph.add(sum, t.components[i * (n + 1)]);
    }
    Ok(Tensor::scalar(sum))
}

/// Largest matrix whose determinant is written out.
const LARGEST: usize = 4;

/// The determinant, by expansion along the first row.
pub(super) fn determinant(graph: &mut Graph, t: &Tensor, span: &Range<usize>) -> Elaborated<Tensor> {
    let n = square(t, "determinant", span)?;
    if n > LARGEST {
        return refuse("latex::shape", format!("a determinant of more than {LARGEST} rows"), span, "");
    }
    let all: Vec<usize> = (0..n).collect();
    Ok(Tensor::scalar(minor(graph, t, n, &all, &all)))
}

fn minor(graph: &mut Graph, t: &Tensor, n: usize, rows: &[usize], columns: &[usize]) -> Expr {
    let Some((&row, rest)) = rows.split_first() else { return graph.integer(1) };
    let mut sum = graph.integer(0);
    for (k, &column) in columns.iter().enumerate() {
        let entry = t.components[row * n + column];
        if graph.is_zero(entry) {
            continue;
        }
        let others: Vec<usize> = columns.iter().copied().filter(|&c| c != column).collect();
        let below = minor(graph, t, n, rest, &others);
        let term = graph.mul_structural(entry, below);
        sum = if k % 2 == 0 { graph.add(sum, term) } else { graph.sub(sum, term) };
    }
    sum
}

/// The inverse: entry by entry for a diagonal matrix, by minors otherwise.
pub(super) fn inverse(graph: &mut Graph, t: &Tensor, span: &Range<usize>) -> Elaborated<Tensor> {
    let n = square(t, "inverse", span)?;
    let one = graph.integer(1);
    if (0..n * n).all(|p| p / n == p % n || graph.is_zero(t.components[p])) {
        let entries: Vec<Expr> = (0..n).map(|i| graph.div(one, t.components[i * (n + 1)])).collect();
        return Ok(diagonal(graph, &entries));
    }
    if n > LARGEST {
        return refuse("latex::shape", format!("the inverse of a matrix of more than {LARGEST} rows"), span, "");
    }
    let all: Vec<usize> = (0..n).collect();
    let det = minor(graph, t, n, &all, &all);
    let mut components = Vec::new();
    for i in 0..n {
        for j in 0..n {
            let rows: Vec<usize> = all.iter().copied().filter(|&r| r != j).collect();
            let columns: Vec<usize> = all.iter().copied().filter(|&c| c != i).collect();
            let m = minor(graph, t, n, &rows, &columns);
            let cofactor = if (i + j) % 2 == 0 { m } else { graph.neg(m) };
            components.push(if graph.is_zero(cofactor) { cofactor } else { graph.div(cofactor, det) });
        }
    }
    Ok(Tensor { shape: t.shape.clone(), components })
}
