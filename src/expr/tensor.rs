//! Shapes, and arrays of expressions.

use super::Expr;

/// Extents of a tensor: `[]` scalar, `[3]` vector, `[3, 3]` matrix, more for abbreviations with several indices.
///
/// A complex number is a pair of real ones: a complex shape has one more axis, the last, of extent 2, for the real and the
/// imaginary part. Whoever knows nothing of complex numbers sees the pair.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Default)]
pub struct Shape {
    extents: Vec<u16>,
    complex: bool,
}

/// Which part of a complex number a component is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Part {
    /// Its real part.
    Real,
    /// Its imaginary part.
    Imaginary,
}

impl Part {
    /// How a formula writes the part of something.
    pub fn of(self, text: &str) -> String {
        match self {
            Part::Real => format!(r"\operatorname{{Re}}({text})"),
            Part::Imaginary => format!(r"\operatorname{{Im}}({text})"),
        }
    }
}

impl Shape {
    /// A scalar.
    pub fn scalar() -> Shape {
        Shape::of(Vec::new())
    }
    /// A vector of n components.
    pub fn vector(n: u16) -> Shape {
        Shape::of(vec![n])
    }
    /// A matrix of `rows` × `columns`.
    pub fn matrix(rows: u16, columns: u16) -> Shape {
        Shape::of(vec![rows, columns])
    }
    /// Any extents.
    pub fn of(extents: Vec<u16>) -> Shape {
        Shape { extents, complex: false }
    }
    /// The same of complex numbers.
    pub fn complexified(&self) -> Shape {
        let mut extents = self.real_extents().to_vec();
        extents.push(2);
        Shape { extents, complex: true }
    }
    /// The same of real numbers.
    pub fn real(&self) -> Shape {
        Shape::of(self.real_extents().to_vec())
    }
    /// Whether its components are parts of complex numbers.
    pub fn is_complex(&self) -> bool {
        self.complex
    }
    /// The extents without the axis of the two parts.
    pub fn real_extents(&self) -> &[u16] {
        &self.extents[..self.extents.len() - usize::from(self.complex)]
    }
    /// The part of a complex number that stands at a row-major position.
    pub fn part(&self, position: usize) -> Option<Part> {
        self.complex.then_some(if position.is_multiple_of(2) { Part::Real } else { Part::Imaginary })
    }
    /// Indices, counted from 1, of what stands at a row-major position, without that of the part.
    pub fn real_indices(&self, position: usize) -> Vec<u16> {
        let mut indices = self.indices(position);
        if self.complex {
            indices.pop();
        }
        indices
    }
    /// The extents, outermost first.
    pub fn extents(&self) -> &[u16] {
        &self.extents
    }
    /// Number of indices.
    pub fn rank(&self) -> usize {
        self.extents.len()
    }
    /// Number of components: the product of the extents, 1 for a scalar.
    #[expect(clippy::len_without_is_empty, reason = "a shape is never empty: a scalar has one component")]
    pub fn len(&self) -> usize {
        self.extents.iter().map(|&n| n as usize).product()
    }
    /// Indices, counted from 1, of a row-major position.
    pub fn indices(&self, mut position: usize) -> Vec<u16> {
        let mut out = vec![0; self.extents.len()];
        for (slot, &n) in out.iter_mut().zip(&self.extents).rev() {
            *slot = (position % n as usize) as u16 + 1;
            position /= n as usize;
        }
        out
    }
    /// Row-major position of indices counted from 1, or `None` outside the extents.
    pub fn position(&self, indices: &[u16]) -> Option<usize> {
        if indices.len() != self.extents.len() {
            return None;
        }
        let mut position = 0;
        for (&i, &n) in indices.iter().zip(&self.extents) {
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
        let extents = self.real_extents();
        if self.complex {
            f.write_str("complex ")?;
        }
        match extents {
            [] if self.complex => f.write_str("number"),
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
