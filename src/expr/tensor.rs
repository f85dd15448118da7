//! Shapes, and arrays of expressions.

use super::Expr;

/// Extents of a tensor: `[]` scalar, `[3]` vector, `[3, 3]` matrix, more for abbreviations with several indices.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Default)]
pub struct Shape(Vec<u16>);

impl Shape {
    /// A scalar.
    pub fn scalar() -> Shape {
        Shape(Vec::new())
    }
    /// A vector of n components.
    pub fn vector(n: u16) -> Shape {
        Shape(vec![n])
    }
    /// A matrix of `rows` × `columns`.
    pub fn matrix(rows: u16, columns: u16) -> Shape {
        Shape(vec![rows, columns])
    }
    /// Any extents.
    pub fn of(extents: Vec<u16>) -> Shape {
        Shape(extents)
    }
    /// The extents, outermost first.
    pub fn extents(&self) -> &[u16] {
        &self.0
    }
    /// Number of indices.
    pub fn rank(&self) -> usize {
        self.0.len()
    }
    /// Number of components: the product of the extents, 1 for a scalar.
    #[expect(clippy::len_without_is_empty, reason = "a shape is never empty: a scalar has one component")]
    pub fn len(&self) -> usize {
        self.0.iter().map(|&n| n as usize).product()
    }
    /// Indices, counted from 1, of a row-major position.
    pub fn indices(&self, mut position: usize) -> Vec<u16> {
        let mut out = vec![0; self.0.len()];
        for (slot, &n) in out.iter_mut().zip(&self.0).rev() {
            *slot = (position % n as usize) as u16 + 1;
            position /= n as usize;
        }
        out
    }
    /// Row-major position of indices counted from 1, or `None` outside the extents.
    pub fn position(&self, indices: &[u16]) -> Option<usize> {
        if indices.len() != self.0.len() {
            return None;
        }
        let mut position = 0;
        for (&i, &n) in indices.iter().zip(&self.0) {
            if i == 0 || i > n {
                return None;
            }
            position = position * n as usize + (i as usize - 1);
        }
        Some(position)
    }
}

impl std::fmt::Display for Shape {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.0.as_slice() {
            [] => f.write_str("scalar"),
            [n] => write!(f, "vector of {n}"),
            more => {
                let parts: Vec<String> = more.iter().map(u16::to_string).collect();
                write!(f, "{} matrix", parts.join("×"))
            }
        }
    }
}

/// An array of expressions, row-major.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Tensor {
    /// The extents.
    pub shape: Shape,
    /// `shape.len()` components, last index fastest.
    pub components: Vec<Expr>,
}

impl Tensor {
    /// A single expression.
    pub fn scalar(e: Expr) -> Tensor {
        Tensor { shape: Shape::scalar(), components: vec![e] }
    }

    /// The expression of a scalar, `None` for any other shape.
    pub fn as_scalar(&self) -> Option<Expr> {
        if self.shape.rank() == 0 { self.components.first().copied() } else { None }
    }
}
