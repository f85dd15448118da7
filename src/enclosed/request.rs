//! What is needed to enclose.

use crate::derivation::Derivation;
use claim::limits::Limits;
use sampled::prepared::Prepared;
use sampled::selection::Selection;
use sampled::stage::Stage;
use sampled::systems::Fields;

/// What is needed to enclose.
pub struct Request<'a> {
    pub derivation: &'a Derivation,
    pub fields: &'a Fields,
    pub stage: &'a Stage,
    pub prepared: &'a [Vec<Prepared<'a>>],
    pub selection: &'a Selection,
    pub limits: &'a Limits,
}
