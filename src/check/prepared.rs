//! A claim with everything that is compiled for it.

use super::independence::Gradients;
use super::program::Program;
use crate::derivation::Claim;

/// A claim with everything that is compiled for it.
pub(super) struct Prepared<'a> {
    pub claim: &'a Claim,
    pub program: Program,
    pub gradients: Option<Result<Gradients, String>>,
}
