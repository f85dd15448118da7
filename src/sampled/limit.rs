//! Limits along the time.
//!
//! At a finite time an expression that has a value there has its limit there: what is written is continuous wherever it is
//! defined, jumps of angles apart, and motions are continuous. Where there is no value (0/0), or the time goes to infinity,
//! points nearby do not tell what the limit is, and the verdict is `undecided`.

use std::sync::Arc;

use crate::describe::{Describer, Left};
use crate::flow::Points;
use crate::latex::LimitPoint;
use crate::number::{Bounded, NoValue};
use crate::trace::Trial;
use crate::verdict::{Finding, Possible, Strength};
use crate::weigh::weigh;
use claim::sides::{MeasuredGroup, Measurements, measure};
use reason::{Plain, Sampling};

/// Values at neighbouring times that differ by more than this share leap between them.
const LEAP: f64 = 1e-6;
/// How far beside the time of a limit, as a share of the span, something that leaps there is looked at.
const BESIDE: f64 = 1e-12;

/// A time, what is found at it, and the differences of the sides.
type Found = (f64, Finding, Vec<Option<Bounded>>);

/// Whether values at neighbouring times may be those of something continuous.
fn are_close(a: Option<Bounded>, b: Option<Bounded>) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => (a.value - b.value).abs() <= a.error + b.error + LEAP * (a.value.abs() + b.value.abs()),
        (None, None) => true,
        _ => false,
    }
}

/// Whether an angle may be on both sides of its cut at times close to one another: what is compared may be large against the leap.
fn leaps(trial: &Trial, times: &[f64]) -> bool {
    let points: Points = times.iter().map(|&t| trial.trace.values(t)).collect();
    let at: Vec<Vec<[Option<Bounded>; 2]>> = points.samples().map(|point| trial.program.angles(point)).collect();
    let count = at.first().map_or(0, Vec::len);
    (0..count).any(|cut| {
        let each = || {
            at.iter().filter_map(|angles| {
                let [y, x] = angles[cut];
                y.zip(x)
            })
        };
        let behind = each().any(|(_, x)| x.value - x.error <= 0.0);
        let side = |y: Bounded| if y.contains_zero() { 0.0 } else { y.value.signum() };
        let mut sides: Vec<f64> = each().map(|(y, _)| side(y)).collect();
        sides.dedup();
        let still = each().all(|(y, _)| y == Bounded::exact(0.0));
        behind && (sides.len() > 1 || sides.contains(&0.0) && !still)
    })
}

/// What is known of a limit: of the group that `group` finds among what is measured.
pub(super) fn limit(
    trial: &Trial,
    group: &dyn for<'m, 'p> Fn(&'m Measurements<'p>) -> &'m MeasuredGroup<'p>,
    point: &LimitPoint,
) -> Finding {
    let Trial { graph, program, trace, .. } = *trial;
    let LimitPoint::Finite(e) = point else {
        return Finding::open(Plain::LimitAtInfinity);
    };
    let Some(t0) = trace.stage.constant(graph, trace.trajectory, *e) else {
        return Finding::open(Plain::NoPointOfLimit);
    };
    let (from, to) = trace.stage.span(trace.trajectory);
    let (t0, exact) = (t0.value, t0.error == 0.0);
    if t0 < from || t0 > to {
        return Finding::open(Sampling::OutsideSpan { t: t0, from, to });
    }
    // A time that is no number of binary64 lies between two of them: a quotient that is 0/0 there has other values beside it.
    // What leaps at it shows that farther away only, and an angle at its cut has the value of one side at an exact time, too.
    let far = BESIDE * (to - from);
    let beside = [t0, t0.next_down(), t0.next_up(), t0 - far, t0 + far];
    let alone = exact && program.cuts().next().is_none();
    let beside = if alone { &beside[..1] } else { &beside[..] };
    let times: Vec<f64> = beside.iter().copied().filter(|t| (from..=to).contains(t)).collect();
    if !alone && leaps(trial, &times) {
        return Finding::open(Sampling::OtherBeside { t: t0, exact });
    }
    let found: Vec<Found> = times
        .iter()
        .map(|&t| {
            let (times, points) = ([t], Arc::new([trace.values(t)].into_iter().collect()));
            let measured = measure(program, &points, None);
            let describer = Describer::new(trial, &times, &points);
            let group = group(&measured);
            let differences = group.signs.iter().flatten().map(|series| series.difference(0).ok()).collect();
            (t, weigh(describer.setting(vec![Left::In]), group), differences)
        })
        .collect();
    let decided = |f: &Finding| f.known(Strength::Sampled);
    // Each with each: a bound that is wide at the time itself hides that the sides of it differ.
    let agree = |a: &Found, b: &Found| {
        let near = [a, b].iter().all(|f| (f.0 - t0).abs() < far);
        (!near || decided(&a.1) == decided(&b.1)) && a.2.iter().zip(&b.2).all(|(a, b)| are_close(*a, *b))
    };
    let together = found.iter().enumerate().all(|(i, a)| found[..i].iter().all(|b| agree(a, b)));
    let Some((_, finding, _)) = found.first().cloned().filter(|_| together) else {
        return Finding::open(Sampling::OtherBeside { t: t0, exact });
    };
    if finding.known(Strength::Sampled) == Some(Possible::VOID) {
        let why = finding.evidence().reason.clone().unwrap_or(NoValue::OutOfDomain.into());
        return Finding::open(Sampling::NoValueItself { t: t0, why: Arc::new(why) });
    }
    finding
}
