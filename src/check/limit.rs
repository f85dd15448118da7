//! Limits along the time, tried along times that approach the point.

use super::comparison::Comparison;
use super::describe::{Describer, short};
use super::program::Program;
use super::trial::{Course, Values, measure};
use super::verdict::{Evidence, Outcome, Residual, Strength, Verdict};
use super::weigh::{Left, Measured, Series, Setting, witness};
use crate::derivation::Claim;
use crate::expr::Graph;
use crate::latex::{LimitPoint, RelationKind};
use crate::number::NoValue;

/// Steps towards a limit point; the last few must agree with the limit within their bounds.
const APPROACH: usize = 12;

/// A claim about a limit, tried along times that approach the point.
pub(super) fn limit(
    graph: &Graph,
    claim: &Claim,
    program: &Program,
    position: usize,
    course: &Course,
    point: &LimitPoint,
) -> Verdict {
    let (from, to) = course.stage.span(course.trajectory);
    let undecided =
        |reason: String| Verdict::new(Outcome::Undecided, Evidence { reason: Some(reason), ..Evidence::default() });
    let (target, times): (String, Vec<f64>) = match point {
        LimitPoint::Finite(e) => {
            let Some(t0) = course.stage.constant(graph, course.trajectory, *e) else {
                return undecided("the point of the limit has no value on this motion".to_owned());
            };
            let t0 = t0.value;
            if t0 < from || t0 > to {
                return undecided(format!("t = {} lies outside the span [{from}, {to}]", short(t0)));
            }
            let reach = (t0 - from).max(to - t0);
            let direction = if to - t0 >= t0 - from { 1.0 } else { -1.0 };
            let tenth = |k: usize| (0..k).fold(1.0, |x, _| x / 10.0);
            let steps = (0..=3 * APPROACH).map(|k| t0 + direction * reach * tenth(k / 3 + 1));
            (format!("t → {}", short(t0)), steps.chain([t0]).collect())
        }
        LimitPoint::PlusInfinity | LimitPoint::MinusInfinity => {
            let end = if matches!(point, LimitPoint::PlusInfinity) { to } else { from };
            let start = if matches!(point, LimitPoint::PlusInfinity) { from } else { to };
            let times =
                (0..=3 * APPROACH).map(|k| start + (end - start) * k as f64 / (3.0 * APPROACH as f64)).collect();
            ("t → ±∞".to_owned(), times)
        }
    };
    let points: Vec<Values> = times.iter().map(|&t| course.values(t)).collect();
    let measured = measure(program, &points);
    let (_, group) = &program.groups[position];
    let series: Vec<&Series> = measured.groups[position].iter().flatten().collect();
    let describer = Describer::new(graph, program, course, &times, &points);
    let mut evidence = Evidence::default();
    for (comparison, series) in group.comparisons.iter().zip(series) {
        let valid: Vec<(usize, _)> =
            series.iter().enumerate().filter_map(|(i, m)| Some((i, m.as_ref().ok()?))).collect();
        let Some(&(i, last)) = valid.last() else {
            return undecided(format!("no value near the limit {target}"));
        };
        evidence.samples += valid.len();
        let size = last.difference.value.abs();
        if !matches!(comparison.kind, RelationKind::Equal | RelationKind::NotEqual) {
            return undecided("only `=` and `\\ne` can be tried of a limit".to_owned());
        }
        let claims_equal = comparison.kind == RelationKind::Equal;
        let settled = size <= last.difference.error.max(claim.precision * last.magnitude.max(f64::MIN_POSITIVE));
        let finite = matches!(point, LimitPoint::Finite(_));
        let reached = settled || (finite && vanishes(&valid, &times));
        if (claims_equal && reached) || (!claims_equal && finite && !reached) {
            evidence.residual = Some(Residual { max: size, bound: last.difference.error, at: times[i] });
            continue;
        }
        if (claims_equal && finite) || (!claims_equal && reached) {
            let setting = Setting {
                times: &times,
                left: vec![Left::In; times.len()],
                precision: claim.precision,
                one_sign_throughout: false,
                values: &|c: &Comparison, i: usize| describer.values(c, i),
                fault: &|c: &Comparison, i: usize, r: NoValue| describer.fault(c, i, r),
            };
            evidence.witness = Some(witness(&setting, comparison, i, last));
            evidence.reason = Some(format!("the difference tends to {} as {target}", short(last.difference.value)));
            return Verdict::new(Outcome::Fails(Strength::Sampled), evidence);
        }
        return undecided(format!(
            "{} away from the limit at t = {}; a limit at infinity needs a bound for all later times",
            short(size),
            short(times[i])
        ));
    }
    evidence.reason = Some(format!("followed towards {target}"));
    Verdict::new(Outcome::Holds(Strength::Sampled), evidence)
}

/// Whether differences shrink in proportion to the distance (or faster) as a finite point is approached.
fn vanishes(valid: &[(usize, &Measured)], times: &[f64]) -> bool {
    let Some(&t0) = times.last() else { return false };
    let near: Vec<(f64, f64)> = valid
        .iter()
        .map(|(i, m)| ((times[*i] - t0).abs(), (m.difference.value.abs() - m.difference.error).max(0.0)))
        .filter(|(distance, _)| *distance > 0.0)
        .collect();
    let (Some(first), Some(last)) = (near.first(), near.last()) else { return false };
    // |difference| ≤ C·√distance with the C of the first point: continuous with a margin for square-root behaviour.
    last.0 < 1e-6 * first.0 && last.1 <= 10.0 * first.1 * (last.0 / first.0).sqrt()
}
