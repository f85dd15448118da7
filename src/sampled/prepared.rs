//! A claim with everything that is compiled for it.

use crate::derivation::Claim;
use crate::independence::Gradients;
use claim::program::Program;

/// A claim with everything that is compiled for it.
pub struct Prepared<'a> {
    pub claim: &'a Claim,
    pub program: Program,
    pub gradients: Option<Result<Gradients, String>>,
}
