//! Limits along the time.
//!
//! At a finite time an expression that has a value there has its limit there: what is written is continuous wherever it is
//! defined, jumps of angles apart, and motions are continuous. Where there is no value (0/0), or the time goes to infinity,
//! points nearby do not tell what the limit is, and the verdict is `undecided`.

use super::comparison::Comparison;
use super::describe::{Describer, short};
use super::program::Program;
use super::trial::{Course, measure};
use super::verdict::{Evidence, Outcome, Verdict};
use super::weigh::{Left, MeasuredGroup, Setting, weigh};
use crate::derivation::Claim;
use crate::expr::Graph;
use crate::latex::LimitPoint;
use crate::number::NoValue;

/// A claim about a limit.
pub(super) fn limit(
    graph: &Graph,
    claim: &Claim,
    program: &Program,
    position: usize,
    course: &Course,
    point: &LimitPoint,
) -> Verdict {
    let undecided =
        |reason: String| Verdict::new(Outcome::Undecided, Evidence { reason: Some(reason), ..Evidence::default() });
    let LimitPoint::Finite(e) = point else {
        return undecided(
            "a motion of finite length does not tell a limit at infinity; a bound for all later times would".to_owned(),
        );
    };
    let Some(t0) = course.stage.constant(graph, course.trajectory, *e) else {
        return undecided("the point of the limit has no value on this motion".to_owned());
    };
    let (from, to) = course.stage.span(course.trajectory);
    let t0 = t0.value;
    if t0 < from || t0 > to {
        return undecided(format!("t = {} lies outside the span [{from}, {to}]", short(t0)));
    }
    let (times, points) = ([t0], [course.values(t0)]);
    let mut measured = measure(program, &points);
    let signs = measured.groups.swap_remove(position);
    let group = MeasuredGroup { group: &program.groups[position].1, signs, definedness: false };
    let describer = Describer::new(graph, program, course, &times, &points);
    let values = |c: &Comparison, i: usize| describer.values(c, i);
    let fault = |c: &Comparison, i: usize, reason: NoValue| describer.fault(c, i, reason);
    let setting = Setting {
        times: &times,
        left: vec![Left::In],
        precision: claim.precision,
        one_sign_throughout: false,
        values: &values,
        fault: &fault,
    };
    let verdict = weigh(setting, &[group]);
    if verdict.outcome() == Outcome::NotApplicable {
        let why = verdict.evidence().reason.clone().unwrap_or_default();
        return undecided(format!(
            "there is no value at t = {} itself ({why}), and points nearby do not decide",
            short(t0)
        ));
    }
    verdict
}
