//! Two motions compared, state by state, at the same times.

use std::sync::Arc;

use crate::derivation::{Derivation, Form};
use crate::describe::{Describer, Left};
use crate::expr::{Leaf, Node, Symbol};
use crate::flow::{Points, Sample};
use crate::latex::RelationKind;
use crate::number::{Bounded, NoValue};
use crate::pointwise::Tried;
use crate::stage;
use crate::trace::Trial;
use crate::verdict::Finding;
use crate::weigh::weigh;
use claim::comparison::{Comparison, Group};
use claim::program::What;
use claim::sides::{Measured, MeasuredGroup, Series, Sizes};
use reason::Plain;

/// The leaves that the comparisons of motions need.
pub fn leaves(derivation: &Derivation) -> Vec<Leaf> {
    let forms = derivation.claims.iter().flat_map(|c| &c.forms);
    let of = forms.filter_map(|form| match form {
        Form::SameMotion { of, .. } => Some(of),
        _ => None,
    });
    of.flatten().flat_map(|&s| components(derivation, s)).collect()
}

fn components(derivation: &Derivation, symbol: Symbol) -> Vec<Leaf> {
    let count = derivation.graph.component_count(symbol);
    (0..count).map(|component| Leaf::now(symbol, component as u16)).collect()
}

/// The times at which a claim that compares its motion with others is tried: those of all of them, since each may do something
/// where another does not. Nothing, where the claim compares none, or is tried at events.
pub fn times_of_both(trial: &Trial) -> Option<(Vec<f64>, Arc<Points>)> {
    let Trial { program, trace, .. } = *trial;
    let others = program.parts.iter().filter_map(|part| match part.what {
        What::SameMotion(other, _) => trace.stage.motion(other),
        What::Every
        | What::Denied
        | What::Defined
        | What::Constant
        | What::Value
        | What::Limit(_)
        | What::Independent
        | What::Across
        | What::Unread(_) => None,
    });
    let (from, to) = trace.stage.span(trace.trajectory);
    let theirs: Vec<f64> = others.flat_map(stage::sample_times).filter(|t| (from..=to).contains(t)).collect();
    if theirs.is_empty() || program.at.is_some() {
        return None;
    }
    let mut times: Vec<f64> = trace.times.iter().copied().chain(theirs).collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    let points = Arc::new(times.iter().map(|&t| trace.values(t)).collect());
    Some((times, points))
}

/// Compares the states `of` of a motion with those of another.
pub(super) fn try_on(derivation: &Derivation, trial: &Trial, tried: &Tried, other: usize, of: &[Symbol]) -> Finding {
    let trace = trial.trace;
    let (from, to) = trace.stage.motion(other).map_or((f64::INFINITY, f64::NEG_INFINITY), |m| m.span());
    let theirs: Vec<Option<Vec<Result<Bounded, NoValue>>>> =
        tried.times.iter().map(|&t| (from <= t && t <= to).then(|| trace.stage.values(other, t))).collect();
    let mut comparisons = Vec::new();
    let (mut series, mut sizes): (Vec<Series>, Vec<Vec<f64>>) = Default::default();
    for leaf in of.iter().flat_map(|&s| components(derivation, s)) {
        let Some(at) = trace.leaves.iter().position(|&l| l == leaf) else { continue };
        let Some(node) = derivation.graph.find(&Node::Leaf(leaf)) else { continue };
        let label = format!("{} of both motions", derivation.graph.leaf_latex(leaf));
        comparisons.push(Comparison::measured(label, RelationKind::Equal, node));
        let compare = |(ours, theirs): (Sample, &Option<Vec<_>>)| {
            let theirs: &Vec<Result<Bounded, NoValue>> = theirs.as_ref().ok_or(NoValue::OutOfDomain)?;
            let (left, right): (Bounded, Bounded) = (ours.get(at)?, theirs[at]?);
            let difference = left - right;
            Ok(Measured { left: left.value, right: right.value, difference })
        };
        let mut of = Series::with_capacity(tried.times.len());
        tried.points.samples().zip(&theirs).map(compare).for_each(|m| of.push(m));
        let size = |i: usize| of.get(i).map_or(0.0, |m| m.left.abs() + m.right.abs());
        sizes.push((0..of.len()).map(size).collect());
        series.push(of);
    }
    if comparisons.is_empty() {
        return Finding::open(Plain::NoStateInCommon);
    }
    // Both are known on a stretch of which no sample counts: an end of it may, as a single time.
    let both = |i: usize| tried.left[i] == Left::In && theirs[i].is_some();
    let (own_from, own_to) = trace.stage.span(trace.trajectory);
    if tried.left.contains(&Left::In) && !(0..theirs.len()).any(both) && from <= own_to && own_from <= to {
        return Finding::open(Plain::NoCommonSample);
    }
    let group = Group { comparisons, ..Group::default() };
    let measured = MeasuredGroup::new(&group, vec![series], (vec![Sizes::Known(sizes.into())], 0));
    let describer = Describer::new(trial, tried.times, tried.points);
    weigh(describer.setting(tried.left.clone()), &measured)
}
