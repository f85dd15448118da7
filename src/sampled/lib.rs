//! Claims along motions, from samples: what is known of each part of a claim at the times at which a motion was computed.
//!
//! **In:** a compiled claim, and the trajectories of a derivation. **Out:** a verdict of the strength *sampled*, with its evidence.
//!
//! The order of work: [`stage`] turns trajectories into motions, [`trace`] samples them; [`trial`] measures the comparisons of a claim at
//! the samples, `pointwise` says what is known at each, `weigh` what that adds up to; `between`, `weakening`, `stretches` and `peaks` look for what
//! samples may have missed. Parts that compare motions or times have files of their own: [`same_motion`], `across`, [`independence`],
//! `limit`.
//!
//! **Guaranteed:** a residual is judged against its own propagated error bound, never against a tolerance alone; values
//! computed with dual numbers must lie within the bounds that were propagated separately, or that is told.

#![forbid(unsafe_code)]

use ::{derivation, diag, expr, findings, flow, latex, number, verdict};

mod across;
mod between;
pub mod claim_program;
mod describe;
pub mod events;
pub mod extrapolate;
pub mod independence;
mod limit;
pub mod measure;
pub mod pattern;
mod peaks;
mod pointwise;
pub mod recall;
pub mod same_motion;
pub mod screen;
pub mod selection;
mod series;
pub mod setup;
pub mod stage;
mod stretches;
pub mod systems;
pub mod trace;
pub mod trial;
mod weakening;
mod weigh;
pub mod witness;
