//! The needs of a step that are known to be met: what systems need, what they divide by, and what was found out.
//!
//! **In:** nothing. **Out:** [`Valued`], which belongs to one gathering of what is given. **Guaranteed:** what was found is kept for the signs
//! that it was found with.

use crate::expr::domain::Sign;
use crate::expr::{Expr, FastMap};
use proof::When;

/// Needs, with when they are met: by them it is told when something has a value.
pub(super) struct Valued {
    /// What systems need: their motions have it.
    pub(super) needed: Vec<(Expr, Sign)>,
    /// What they divide by.
    pub(super) divided: Vec<Expr>,
    /// What was found out.
    pub(super) found: FastMap<(Expr, Sign), When>,
}
