//! What is read more generally than it is meant: ∇ where no coordinates are printed, and unit vectors.
//!
//! **In:** the sides of a step, its names. **Out:** the coordinates of space for ∇; whether a name may be any vector, or any field. **Guaranteed:** what is
//! proved then holds of what is meant, too; that a point refutes it says nothing of that.

use std::collections::BTreeSet;

use paper::{PaperName, PrintedSide};

use super::notation::Evidence;

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
    name.has_hat && name.is_bold && !evidence.is_quantum()
}
