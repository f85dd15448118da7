//! What is read otherwise than it may be meant: ∇ where no coordinates are printed, unit vectors, and letters that a derivative holds fixed.
//!
//! **In:** the sides of a step, its names. **Out:** the coordinates of space for ∇; whether a name may be any vector, or any field. **Guaranteed:** what is
//! proved then holds of what is meant, too, or says where; that a point refutes it says nothing of that.

use std::collections::BTreeSet;

use paper::{Paper, PaperName, PrintedSide, names, squeezed};

use super::notation::Evidence;

/// What is read more generally than it is meant.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct General {
    /// All names are fields, since ∇ has no coordinates.
    pub fields: bool,
    /// Hats are over vectors of any length.
    pub vectors: bool,
    /// Letters in a formula that is derived are held fixed, since the paper says of none that it varies.
    pub constants: bool,
}

impl General {
    /// Whether anything is.
    pub fn is_some(self) -> bool {
        self.fields || self.vectors || self.constants
    }

    /// What one or the other reads so.
    pub fn or(self, other: General) -> General {
        General {
            fields: self.fields || other.fields,
            vectors: self.vectors || other.vectors,
            constants: self.constants || other.constants,
        }
    }

    /// What a proof is one for.
    pub fn words(self) -> Option<String> {
        let fields = self.fields.then_some("for any fields of x, y and z under ∇");
        let vectors = self.vectors.then_some("for vectors of any length under hats");
        let constants = self.constants.then_some("where nothing but the variable varies");
        let all: Vec<&str> = fields.into_iter().chain(vectors).chain(constants).collect();
        (!all.is_empty()).then(|| all.join("; "))
    }
}

/// Cartesian coordinates: whatever the paper uses, ∇ is the same.
const COORDINATES: [&str; 3] = ["x", "y", "z"];
/// Commands that print ∇, or what is made with it.
const NABLAS: &[&str] = &[r"\nabla", r"\grad", r"\curl", r"\laplacian"];

/// Whether ∇ stands in one of these sides.
pub(super) fn has_nabla<'s>(sides: impl IntoIterator<Item = &'s PrintedSide>) -> bool {
    sides.into_iter().any(|side| NABLAS.iter().any(|command| side.text.contains(command)))
}

/// The coordinates that ∇ of some sides needs, beside those by which something is derived in them: none where it has its own, or where something is
/// derived as a whole, along a path that is not known.
pub(super) fn coordinates_for<'s>(
    sides: impl IntoIterator<Item = &'s PrintedSide>,
    derived_by: &BTreeSet<String>,
    time: Option<&str>,
) -> &'static [&'static str] {
    let are_none = derived_by.iter().all(|by| by == "t");
    if time.is_none() && are_none && has_nabla(sides) { &COORDINATES } else { &[] }
}

/// Whether a name with a hat is read: in bold it is a vector, unless it may be an operator.
pub(super) fn is_vector_with_hat(name: &PaperName, evidence: &Evidence) -> bool {
    name.has_hat && name.is_bold && !evidence.has_operators_with_hats()
}

/// Whether hats may be those of operators among quanta: one stands over a letter that is not bold, or in a commutator.
pub(super) fn prints_operators(paper: &Paper) -> bool {
    let sides = || paper.printed.iter().flat_map(|relation| &relation.sides);
    let in_commutator = |side: &PrintedSide| {
        let text = squeezed(&side.text).replace(r"\left", "");
        [r"[\hat", r"[\mathbf\hat", r"[\boldsymbol\hat", r"[\widehat"].iter().any(|begin| text.contains(begin))
    };
    sides().any(in_commutator) || sides().flat_map(names).any(|n| n.has_hat && !n.is_bold)
}
