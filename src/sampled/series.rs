//! Both sides of the deciding comparison along a motion, thinned for drawing.
//!
//! **In:** the judged comparisons of a claim. **Out:** [`Residuals`]: some of the samples at which the verdict was reached,
//! unchanged. Nothing is judged here, and nothing is computed but which samples are kept.

use std::sync::Arc;

use crate::describe::{Left, Setting};
use crate::pointwise::Pointwise;
use crate::verdict::{ResidualPoint, Residuals};

/// Most samples that are kept of a pair, the worst one apart.
const MOST: usize = 60;

/// The comparison `chosen` (comparison, time) at evenly spaced samples among those that count, and at that time.
///
/// For ± the sign that does best at each time is shown. Cost: a few hundred operations for a pair.
pub(super) fn residuals(
    setting: &Setting,
    judged: &Pointwise,
    chosen: Option<(usize, usize)>,
    sought: bool,
) -> Option<Arc<Residuals>> {
    let (comparison, at) = chosen?;
    if judged.measured.group.asserted || !setting.shown {
        return None;
    }
    let described = judged.measured.group.comparisons.get(comparison)?;
    let counted: Vec<usize> = (0..setting.times.len()).filter(|&i| setting.left[i] == Left::In).collect();
    let step = counted.len().div_ceil(MOST).max(1);
    let mut kept: Vec<usize> = counted.iter().copied().step_by(step).chain(counted.last().copied()).collect();
    kept.push(at);
    kept.sort_unstable();
    kept.dedup();
    let point = |(i, m, scale): (usize, claim::sides::Measured, f64)| ResidualPoint {
        t: setting.times[i],
        left: m.left,
        right: m.right,
        residual: m.difference.value.abs(),
        bound: m.difference.error,
        limit: setting.precision * scale,
    };
    Some(Arc::new(Residuals {
        formula: described.label.clone(),
        equation: described.kind == latex::RelationKind::Equal,
        sought,
        of: counted.len(),
        points: judged.shown(comparison, &kept).into_iter().map(point).collect(),
    }))
}
