//! Verdicts for every time of a span, with rounding accounted for.
//!
//! **In:** the verdicts that samples gave, and the derivation. **Out:** the same verdicts, of which some are stronger:
//! `holds` becomes *enclosed*, `fails` becomes *certified*, and `undecided` is decided where only an enclosure could. A verdict
//! that stays as it was says why.
//!
//! **Guaranteed.** The motion is enclosed by validated integration, with the numbers of the file as they are written (not
//! rounded). What is then shown is:
//!
//! | claim | *enclosed* means: at every time of the span at which the assumptions hold and the formula has a value |
//! |---|---|
//! | left = right | \|left − right\| ≤ precision · scale, and no stretch of time is found on which left ≠ right for certain |
//! | <, >, ≠ | the relation holds |
//! | ≤, ≥ | the relation holds, or is missed by at most precision · scale |
//! | `never` | the relation does not hold |
//! | `eventually` | there is a time at which it holds (by the intermediate value theorem for an equation) |
//! | `defined` | every operation has a value |
//!
//! `scale` is the median size of the terms along the motion. Equations among the assumptions must themselves be enclosed.
//! *Certified* means that there is a time, in the span, at which the assumptions hold and the relation does not.
//!
//! **An enclosure never contradicts a sample.** If it did, one of the two would be wrong, and the run stops as defective.

mod claim;
mod cover;

use super::stage::{Fields, Stage, setup};
use super::{Column, Prepared};
use crate::derivation::{Derivation, Motion as Given};
use crate::expr::Graph;
use crate::flow::Enclosure;
use cover::Along;
use rayon::prelude::*;

/// How much is asked of a verdict.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Rigor {
    /// At finitely many times.
    #[default]
    Sampled,
    /// At every time, where it is possible.
    Enclosed,
}

/// What is needed to enclose.
pub(super) struct Request<'a> {
    pub derivation: &'a Derivation,
    pub fields: &'a Fields,
    pub stage: &'a Stage,
    pub prepared: &'a [Vec<Prepared<'a>>],
    pub start_of: &'a [usize],
    pub tried: &'a [usize],
}

/// Strengthens the verdicts of all columns.
///
/// # Errors
/// A description of an enclosure that contradicts a sampled verdict.
pub(super) fn strengthen(request: &Request, columns: &mut [Column]) -> Result<(), String> {
    let pairs: Vec<(&mut Column, usize)> = columns.iter_mut().zip(request.tried.iter().copied()).collect();
    pairs.into_par_iter().try_for_each(|(column, t)| one_motion(request, t, column))
}

/// The enclosure of a motion, and of those that it comes from.
fn enclosure(request: &Request, graph: &mut Graph, t: usize) -> Result<Enclosure, String> {
    let trajectory = &request.derivation.trajectories[t];
    let (from, source) = match trajectory.motion {
        Given::Derived { from, .. } => (Some(enclosure(request, graph, from)?), request.stage.source(from)),
        _ => (None, None),
    };
    let (setup, _) = setup(request.derivation, request.fields, graph, trajectory, source, true);
    Enclosure::new(graph, &setup, from.as_ref()).map_err(|e| e.to_string())
}

fn one_motion(request: &Request, t: usize, column: &mut Column) -> Result<(), String> {
    let trajectory = &request.derivation.trajectories[t];
    let mut graph = request.derivation.graph.clone();
    let mut along = match enclosure(request, &mut graph, t) {
        Ok(enclosure) => Along::new(enclosure, graph, trajectory.span),
        Err(reason) => {
            column.0.iter_mut().flatten().for_each(|v| claim::remark(v, &reason));
            return Ok(());
        }
    };
    for (k, verdict) in column.0.iter_mut().enumerate() {
        let Some(verdict) = verdict else { continue };
        let prepared = &request.prepared[k][request.start_of[t]];
        claim::strengthen(prepared.claim, &prepared.program, &mut along, verdict)
            .map_err(|e| format!("{} on {}: {e}", prepared.claim.name(), trajectory.id))?;
    }
    Ok(())
}
