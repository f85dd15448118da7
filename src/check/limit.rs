//! Limits along the time.
//!
//! At a finite time an expression that has a value there has its limit there: what is written is continuous wherever it is
//! defined, jumps of angles apart, and motions are continuous. Where there is no value (0/0), or the time goes to infinity,
//! points nearby do not tell what the limit is, and the verdict is `undecided`.

use std::sync::Arc;

use super::describe::{Describer, short};
use super::measured::measure;
use super::trial::Trial;
use super::verdict::{Evidence, Outcome, Verdict};
use super::weigh::{Left, weigh};
use crate::latex::LimitPoint;

/// A claim about a limit: the group of the program at `position`.
pub(super) fn limit(trial: &Trial, position: usize, point: &LimitPoint) -> Verdict {
    let Trial { graph, program, course, .. } = *trial;
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
    let (times, points) = ([t0], Arc::new([course.values(t0)].into_iter().collect()));
    let measured = measure(program, &points, None);
    let describer = Describer::new(trial, &times, &points);
    let verdict = weigh(describer.setting(vec![Left::In]), &measured.groups[position]);
    if verdict.outcome() == Outcome::NotApplicable {
        let why = verdict.evidence().reason.clone().unwrap_or_default();
        return undecided(format!(
            "there is no value at t = {} itself ({why}), and points nearby do not decide",
            short(t0)
        ));
    }
    verdict
}
