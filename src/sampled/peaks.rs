//! What varies between the samples more rapidly than they are dense.
//!
//! A motion is sampled so densely that its states are seen; a formula of the states may still hide a peak, or a step, between two
//! samples: e^u is 0 for a reader wherever u is far below 0, tanh u is 1 wherever it is far above, and 10⁻²⁴/u is 0 unless u is. What
//! can be seen at the samples is u itself ([`flow::Rapid`]): where it moves by much, the claim is tried in between.
//!
//! **In:** a claim that holds at all samples. **Out:** the times in between.

use crate::course::Trial;
use crate::flow::Rapid;

/// Times between the samples at which a claim is to be tried.
pub(super) fn times(trial: &Trial) -> Rapid {
    let mut out = Rapid::default();
    for &side in &trial.program.rapid {
        let Some(found) = trial.course.rapid(side) else { continue };
        out.times.extend(&found.times);
        out.singular.extend(&found.singular);
        out.unresolved = out.unresolved.or(found.unresolved);
    }
    for times in [&mut out.times, &mut out.singular] {
        times.sort_by(f64::total_cmp);
        times.dedup();
    }
    out
}
