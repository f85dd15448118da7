//! What is needed to enclose.

use super::super::limits::Limits;
use super::super::prepared::Prepared;
use super::super::stage::{Fields, Stage};
use crate::derivation::Derivation;

/// What is needed to enclose.
pub(in super::super) struct Request<'a> {
    pub derivation: &'a Derivation,
    pub fields: &'a Fields,
    pub stage: &'a Stage,
    pub prepared: &'a [Vec<Prepared<'a>>],
    pub start_of: &'a [usize],
    pub tried: &'a [usize],
    pub limits: &'a Limits,
}
