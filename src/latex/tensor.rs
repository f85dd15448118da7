//! Products and other operations on tensors of expressions.
//!
//! Structural zeros (off the diagonal of a diagonal matrix, say) make no terms; any other 0 is a factor, see [`Graph::term`].
//! Every operation is written once, for real and for complex entries: see [`Entry`].

use std::ops::Range;

use super::complex::Pair;
use super::refusal::refuse_at as refuse;
use diag::Problem;
use expr::{Expr, Graph, Leaf, Part, Shape, Tensor};

type Elaborated<T> = Result<T, Box<Problem>>;

/// What stands at a place of an array: a real expression, or a complex number.
trait Entry: Copy {
    /// The entries of a tensor.
    fn entries(graph: &mut Graph, t: &Tensor) -> Vec<Self>;
    /// A tensor of these entries; the shape is that of real numbers.
    fn tensor(shape: Shape, entries: Vec<Self>) -> Tensor;
    fn whole(graph: &mut Graph, n: i64) -> Self;
    /// The structural zero.
    fn absent(graph: &mut Graph) -> Self;
    fn is_absent(self, graph: &Graph) -> bool;
    /// Whether it is 0, structural or not.
    fn is_zero(self, graph: &Graph) -> bool;
    fn plus(self, graph: &mut Graph, other: Self) -> Self;
    fn minus(self, graph: &mut Graph, other: Self) -> Self;
    fn negated(self, graph: &mut Graph) -> Self;
    /// A term of a sum over components: where one factor is 0, the other is kept only if it may lack a value.
    fn times(self, graph: &mut Graph, other: Self) -> Self;
    /// A product of numbers as it is written: the factors of a 0 are kept.
    fn by(self, graph: &mut Graph, other: Self) -> Self;
    fn over(self, graph: &mut Graph, below: Self) -> Self;
}

impl Entry for Expr {
    fn entries(_: &mut Graph, t: &Tensor) -> Vec<Expr> {
        t.components.clone()
    }
    fn tensor(shape: Shape, entries: Vec<Expr>) -> Tensor {
        Tensor { shape, components: entries }
    }
    fn whole(graph: &mut Graph, n: i64) -> Expr {
        graph.integer(n)
    }
    fn absent(graph: &mut Graph) -> Expr {
        graph.absent()
    }
    fn is_absent(self, graph: &Graph) -> bool {
        graph.is_absent(self)
    }
    fn is_zero(self, graph: &Graph) -> bool {
        graph.is_zero(self)
    }
    fn plus(self, graph: &mut Graph, other: Expr) -> Expr {
        graph.add(self, other)
    }
    fn minus(self, graph: &mut Graph, other: Expr) -> Expr {
        graph.sub(self, other)
    }
    fn negated(self, graph: &mut Graph) -> Expr {
        graph.neg(self)
    }
    fn times(self, graph: &mut Graph, other: Expr) -> Expr {
        graph.term(self, other)
    }
    fn by(self, graph: &mut Graph, other: Expr) -> Expr {
        graph.mul(self, other)
    }
    fn over(self, graph: &mut Graph, below: Expr) -> Expr {
        graph.div(self, below)
    }
}

impl Entry for Pair {
    fn entries(graph: &mut Graph, t: &Tensor) -> Vec<Pair> {
        if t.shape.is_complex() {
            return t.components.as_chunks().0.iter().map(|&[re, im]| Pair { re, im }).collect();
        }
        t.components.iter().map(|&re| Pair::real(graph, re)).collect()
    }
    fn tensor(shape: Shape, entries: Vec<Pair>) -> Tensor {
        let components = entries.into_iter().flat_map(|p| [Part::Real, Part::Imaginary].map(|part| p.part(part)));
        Tensor { shape: shape.complexified(), components: components.collect() }
    }
    fn whole(graph: &mut Graph, n: i64) -> Pair {
        Pair::whole(graph, n)
    }
    fn absent(graph: &mut Graph) -> Pair {
        Pair { re: graph.absent(), im: graph.absent() }
    }
    fn is_absent(self, graph: &Graph) -> bool {
        graph.is_absent(self.re) && graph.is_absent(self.im)
    }
    fn is_zero(self, graph: &Graph) -> bool {
        graph.is_zero(self.re) && graph.is_zero(self.im)
    }
    fn plus(self, graph: &mut Graph, other: Pair) -> Pair {
        Pair::plus(self, graph, other)
    }
    fn minus(self, graph: &mut Graph, other: Pair) -> Pair {
        Pair::minus(self, graph, other)
    }
    fn negated(self, graph: &mut Graph) -> Pair {
        Pair::negated(self, graph)
    }
    fn times(self, graph: &mut Graph, other: Pair) -> Pair {
        Pair::times(self, graph, other)
    }
    fn by(self, graph: &mut Graph, other: Pair) -> Pair {
        self.times_by(graph, other, Graph::mul)
    }
    fn over(self, graph: &mut Graph, below: Pair) -> Pair {
        Pair::over(self, graph, below)
    }
}

/// An array of entries of one kind; its shape is that of real numbers.
struct Array<E> {
    shape: Shape,
    entries: Vec<E>,
}

impl<E: Entry> Array<E> {
    fn of(graph: &mut Graph, t: &Tensor) -> Array<E> {
        Array { shape: t.shape.real(), entries: E::entries(graph, t) }
    }
    fn scalar(e: E) -> Array<E> {
        Array { shape: Shape::scalar(), entries: vec![e] }
    }
    fn as_scalar(&self) -> Option<E> {
        if self.shape.rank() == 0 { self.entries.first().copied() } else { None }
    }
    fn tensor(self) -> Tensor {
        E::tensor(self.shape, self.entries)
    }
}

/// The same tensor of complex numbers.
pub(super) fn complexified(graph: &mut Graph, t: &Tensor) -> Tensor {
    Array::<Pair>::of(graph, t).tensor()
}

/// A tensor of these numbers, real if all of them are.
pub(super) fn of_numbers(graph: &mut Graph, shape: Shape, numbers: &[Tensor]) -> Tensor {
    if numbers.iter().any(|t| t.shape.is_complex()) {
        let entries = numbers.iter().flat_map(|t| Pair::entries(graph, t)).collect();
        return Pair::tensor(shape, entries);
    }
    Tensor { shape, components: numbers.iter().filter_map(Tensor::as_scalar).collect() }
}

/// Every component divided by a number.
pub(super) fn quotient(graph: &mut Graph, above: &Tensor, below: Pair) -> Tensor {
    let mut array = Array::<Pair>::of(graph, above);
    array.entries = array.entries.into_iter().map(|p| p.over(graph, below)).collect();
    array.tensor()
}

/// Every complex number of a tensor, each part with a value only where both have one; see [`Pair::joined`].
pub(super) fn joined(graph: &mut Graph, t: Tensor, partial: impl Fn(Leaf) -> bool) -> Tensor {
    if !t.shape.is_complex() {
        return t;
    }
    let mut array = Array::<Pair>::of(graph, &t);
    array.entries = array.entries.into_iter().map(|p| p.joined(graph, &partial)).collect();
    array.tensor()
}

/// The tensor with the complex conjugates.
pub(super) fn conjugate(graph: &mut Graph, t: &Tensor) -> Tensor {
    let mut array = Array::<Pair>::of(graph, t);
    array.entries = array.entries.into_iter().map(|p| p.conjugate(graph)).collect();
    array.tensor()
}

/// The real or imaginary parts.
pub(super) fn part(graph: &mut Graph, t: &Tensor, part: Part) -> Tensor {
    let array = Array::<Pair>::of(graph, t);
    // The imaginary part of something real is a number, 0.
    let of = |p: Pair| if p.is_absent(graph) { p.re } else { graph.settled(p.part(part)) };
    Tensor { shape: array.shape, components: array.entries.into_iter().map(of).collect() }
}

/// The same with numbers only: 0 where something is not there.
pub(super) fn settled(graph: &mut Graph, mut t: Tensor) -> Tensor {
    t.components.iter_mut().for_each(|e| *e = graph.settled(*e));
    t
}

/// The same where a 0 is not there.
pub(super) fn sparse(graph: &mut Graph, mut t: Tensor) -> Tensor {
    let absent = graph.absent();
    t.components.iter_mut().filter(|e| graph.is_zero(**e)).for_each(|e| *e = absent);
    t
}

/// The squares of the sizes of all components, added.
pub(super) fn square_of_length(graph: &mut Graph, t: &Tensor) -> Expr {
    let squares: Vec<(Expr, Expr)> = t.components.iter().map(|&e| (e, e)).collect();
    inner(graph, squares.into_iter())
}

/// Σ of products.
fn inner<E: Entry>(graph: &mut Graph, pairs: impl Iterator<Item = (E, E)>) -> E {
    let absent = E::absent(graph);
    pairs.fold(absent, |sum, (a, b)| {
        let term = a.times(graph, b);
        sum.plus(graph, term)
    })
}

/// a·b for vectors.
pub(super) fn dot(graph: &mut Graph, a: &Tensor, b: &Tensor, span: &Range<usize>) -> Elaborated<Tensor> {
    if a.shape.real() != b.shape.real() || a.shape.real_extents().len() != 1 {
        return refuse("latex::shape", format!("no scalar product of a {} and a {}", a.shape, b.shape), span, "");
    }
    Ok(if a.shape.is_complex() || b.shape.is_complex() {
        dot_of::<Pair>(graph, a, b)
    } else {
        dot_of::<Expr>(graph, a, b)
    })
}

fn dot_of<E: Entry>(graph: &mut Graph, a: &Tensor, b: &Tensor) -> Tensor {
    let (a, b) = (E::entries(graph, a), E::entries(graph, b));
    Array::scalar(inner(graph, a.into_iter().zip(b))).tensor()
}

/// a × b for vectors of three components.
pub(super) fn cross(graph: &mut Graph, a: &Tensor, b: &Tensor, span: &Range<usize>) -> Elaborated<Tensor> {
    if a.shape.real() != Shape::vector(3) || b.shape.real() != Shape::vector(3) {
        let message = format!("a vector product needs two vectors of 3, these are a {} and a {}", a.shape, b.shape);
        let hint = match a.shape.real_extents().len().max(b.shape.real_extents().len()) {
            0 => r"for numbers write `\cdot`",
            2.. => "`[A,B]` is the commutator of two square matrices of one size",
            1 => "",
        };
        return refuse("latex::shape", message, span, hint);
    }
    Ok(if a.shape.is_complex() || b.shape.is_complex() {
        cross_of::<Pair>(graph, a, b)
    } else {
        cross_of::<Expr>(graph, a, b)
    })
}

fn cross_of<E: Entry>(graph: &mut Graph, a: &Tensor, b: &Tensor) -> Tensor {
    let (a, b) = (E::entries(graph, a), E::entries(graph, b));
    let entries = (0..3)
        .map(|i| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            let left = a[j].times(graph, b[k]);
            let right = a[k].times(graph, b[j]);
            left.minus(graph, right)
        })
        .collect();
    Array { shape: Shape::vector(3), entries }.tensor()
}

/// Juxtaposed factors: scalars, matrices, and at most one vector at the end (a row vector at the beginning).
pub(super) fn product(
    graph: &mut Graph,
    factors: Vec<(Tensor, Range<usize>)>,
    span: &Range<usize>,
) -> Elaborated<Tensor> {
    if factors.iter().any(|(t, _)| t.shape.is_complex()) {
        product_of::<Pair>(graph, factors, span)
    } else {
        product_of::<Expr>(graph, factors, span)
    }
}

fn product_of<E: Entry>(
    graph: &mut Graph,
    factors: Vec<(Tensor, Range<usize>)>,
    span: &Range<usize>,
) -> Elaborated<Tensor> {
    let mut scalar: Option<E> = None;
    let mut chain: Vec<(Array<E>, Range<usize>)> = Vec::new();
    for (t, at) in factors {
        let array = Array::<E>::of(graph, &t);
        match array.as_scalar() {
            Some(e) => {
                scalar = Some(match scalar {
                    Some(s) => s.by(graph, e),
                    None => e,
                });
            }
            None => chain.push((array, at)),
        }
    }
    // From the right, so that a matrix chain that ends in a vector only makes vectors.
    let mut acc: Option<Array<E>> = None;
    while let Some((t, at)) = chain.pop() {
        acc = Some(match acc {
            None => t,
            Some(right) => multiply(graph, &t, &right, &(at.start..span.end))?,
        });
    }
    match (scalar, acc) {
        (Some(s), Some(t)) => {
            let times = if s.is_zero(graph) { E::by } else { E::times };
            let entries = t.entries.into_iter().map(|e| times(s, graph, e)).collect();
            Ok(Array { shape: t.shape, entries }.tensor())
        }
        (Some(s), None) => Ok(Array::scalar(s).tensor()),
        (None, Some(t)) => Ok(t.tensor()),
        (None, None) => refuse("latex::empty", "an empty product", span, ""),
    }
}

fn multiply<E: Entry>(graph: &mut Graph, a: &Array<E>, b: &Array<E>, span: &Range<usize>) -> Elaborated<Array<E>> {
    if let Some(e) = b.as_scalar() {
        let entries = a.entries.iter().map(|&x| x.times(graph, e)).collect();
        return Ok(Array { shape: a.shape.clone(), entries });
    }
    let mismatch = || {
        let hint = if a.shape.rank() == 1 && b.shape.rank() == 1 { r"write `\cdot`, `\times` or `^T`" } else { "" };
        refuse("latex::shape", format!("no product of a {} and a {}", a.shape, b.shape), span, hint)
    };
    match (a.shape.extents(), b.shape.extents()) {
        (&[n, m], &[k]) if m == k => {
            let entries: Vec<E> = (0..n as usize)
                .map(|i| {
                    let row = &a.entries[i * m as usize..(i + 1) * m as usize];
                    inner(graph, row.iter().copied().zip(b.entries.iter().copied()))
                })
                .collect();
            // A row times a column is a number.
            let shape = if n == 1 { Shape::scalar() } else { Shape::vector(n) };
            Ok(Array { shape, entries })
        }
        (&[n, m], &[k, l]) if m == k => {
            let mut entries = Vec::new();
            for i in 0..n as usize {
                for j in 0..l as usize {
                    let pairs: Vec<(E, E)> = (0..m as usize)
                        .map(|p| (a.entries[i * m as usize + p], b.entries[p * l as usize + j]))
                        .collect();
                    entries.push(inner(graph, pairs.into_iter()));
                }
            }
            Ok(Array { shape: Shape::matrix(n, l), entries })
        }
        // A column times a row is a matrix.
        (&[n], &[1, l]) => {
            let mut entries = Vec::new();
            for i in 0..n as usize {
                for j in 0..l as usize {
                    entries.push(a.entries[i].times(graph, b.entries[j]));
                }
            }
            Ok(Array { shape: Shape::matrix(n, l), entries })
        }
        _ => mismatch(),
    }
}

/// The transpose; of a vector, a matrix of one row.
pub(super) fn transpose(graph: &mut Graph, t: &Tensor, span: &Range<usize>) -> Elaborated<Tensor> {
    if t.shape.is_complex() { transpose_of::<Pair>(graph, t, span) } else { transpose_of::<Expr>(graph, t, span) }
}

fn transpose_of<E: Entry>(graph: &mut Graph, t: &Tensor, span: &Range<usize>) -> Elaborated<Tensor> {
    let array = Array::<E>::of(graph, t);
    match *array.shape.extents() {
        [n] => Ok(Array { shape: Shape::matrix(1, n), entries: array.entries }.tensor()),
        [n, m] => {
            let mut entries = Vec::new();
            for j in 0..m as usize {
                for i in 0..n as usize {
                    entries.push(array.entries[i * m as usize + j]);
                }
            }
            Ok(Array { shape: Shape::matrix(m, n), entries }.tensor())
        }
        _ => refuse("latex::shape", format!("a {} has no transpose", t.shape), span, ""),
    }
}

/// The matrix with this diagonal, and nothing beside it.
pub(super) fn diagonal(graph: &mut Graph, entries: &[Expr]) -> Tensor {
    let (n, absent) = (entries.len(), graph.absent());
    let components = (0..n * n).map(|p| if p / n == p % n { entries[p / n] } else { absent }).collect();
    Tensor { shape: Shape::matrix(n as u16, n as u16), components }
}

fn square(t: &Tensor, what: &str, span: &Range<usize>) -> Elaborated<usize> {
    match *t.shape.real_extents() {
        [n, m] if n == m => Ok(n as usize),
        _ => refuse("latex::shape", format!("a {what} needs a square matrix, this is a {}", t.shape), span, ""),
    }
}

/// The trace.
pub(super) fn trace(graph: &mut Graph, t: &Tensor, span: &Range<usize>) -> Elaborated<Tensor> {
    let n = square(t, "trace", span)?;
    Ok(if t.shape.is_complex() { trace_of::<Pair>(graph, t, n) } else { trace_of::<Expr>(graph, t, n) })
}

fn trace_of<E: Entry>(graph: &mut Graph, t: &Tensor, n: usize) -> Tensor {
    let entries = E::entries(graph, t);
    let mut sum = E::absent(graph);
    for i in 0..n {
        sum = sum.plus(graph, entries[i * (n + 1)]);
    }
    Array::scalar(sum).tensor()
}

/// Largest matrix whose determinant is written out.
const LARGEST: usize = 4;

/// The determinant, by expansion along the first row.
pub(super) fn determinant(graph: &mut Graph, t: &Tensor, span: &Range<usize>) -> Elaborated<Tensor> {
    let n = square(t, "determinant", span)?;
    if n > LARGEST {
        return refuse("latex::shape", format!("a determinant of more than {LARGEST} rows"), span, "");
    }
    Ok(if t.shape.is_complex() { determinant_of::<Pair>(graph, t, n) } else { determinant_of::<Expr>(graph, t, n) })
}

fn determinant_of<E: Entry>(graph: &mut Graph, t: &Tensor, n: usize) -> Tensor {
    let entries = E::entries(graph, t);
    let all: Vec<usize> = (0..n).collect();
    Array::scalar(minor(graph, &entries, n, &all, &all)).tensor()
}

fn minor<E: Entry>(graph: &mut Graph, entries: &[E], n: usize, rows: &[usize], columns: &[usize]) -> E {
    let Some((&row, rest)) = rows.split_first() else { return E::whole(graph, 1) };
    let mut sum = E::absent(graph);
    for (k, &column) in columns.iter().enumerate() {
        let entry = entries[row * n + column];
        if entry.is_absent(graph) {
            continue;
        }
        let others: Vec<usize> = columns.iter().copied().filter(|&c| c != column).collect();
        let below = minor(graph, entries, n, rest, &others);
        let term = entry.times(graph, below);
        sum = if k % 2 == 0 { sum.plus(graph, term) } else { sum.minus(graph, term) };
    }
    sum
}

/// The inverse: entry by entry for a diagonal matrix, by minors otherwise.
pub(super) fn inverse(graph: &mut Graph, t: &Tensor, span: &Range<usize>) -> Elaborated<Tensor> {
    let n = square(t, "inverse", span)?;
    if t.shape.is_complex() { inverse_of::<Pair>(graph, t, n, span) } else { inverse_of::<Expr>(graph, t, n, span) }
}

fn inverse_of<E: Entry>(graph: &mut Graph, t: &Tensor, n: usize, span: &Range<usize>) -> Elaborated<Tensor> {
    let given = E::entries(graph, t);
    let one = E::whole(graph, 1);
    if (0..n * n).all(|p| p / n == p % n || given[p].is_zero(graph)) {
        let diagonal: Vec<E> = (0..n).map(|i| one.over(graph, given[i * (n + 1)])).collect();
        let mut entries = Vec::with_capacity(n * n);
        for (p, zero) in given.into_iter().enumerate() {
            let (i, j) = (p / n, p % n);
            // A 0 that is written is a factor, as it is where the inverse is written out.
            entries.push(if i == j { diagonal[i] } else { zero.times(graph, diagonal[i]).times(graph, diagonal[j]) });
        }
        return Ok(Array { shape: Shape::matrix(n as u16, n as u16), entries }.tensor());
    }
    if n > LARGEST {
        return refuse("latex::shape", format!("the inverse of a matrix of more than {LARGEST} rows"), span, "");
    }
    let all: Vec<usize> = (0..n).collect();
    let det = minor(graph, &given, n, &all, &all);
    let mut entries = Vec::new();
    for i in 0..n {
        for j in 0..n {
            let rows: Vec<usize> = all.iter().copied().filter(|&r| r != j).collect();
            let columns: Vec<usize> = all.iter().copied().filter(|&c| c != i).collect();
            let m = minor(graph, &given, n, &rows, &columns);
            let cofactor = if (i + j) % 2 == 0 { m } else { m.negated(graph) };
            entries.push(if cofactor.is_absent(graph) { cofactor } else { cofactor.over(graph, det) });
        }
    }
    Ok(Array { shape: Shape::matrix(n as u16, n as u16), entries }.tensor())
}
