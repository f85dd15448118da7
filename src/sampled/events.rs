//! Which of the zeros of an event are meant: those at which the sides pass each other in a direction, and the n-th of them.
//!
//! **In:** the zeros of left − right that a complete search found, and what the file says under `at`. **Out:** [`Events`]: the times
//! that are meant, and why others may be.
//!
//! **Guaranteed.** A zero is counted as one change of sign only if left − right is in proportion to the distance from it, on both
//! sides, from the error of its time up to where it is far above all errors: three zeros that lie close together are not.
//! The n-th is named only if nothing before it is open: no place where the sides may only touch, no stretch that was not resolved,
//! no zero that may lie before the start. What comes after it does not matter.

use std::borrow::Cow;

use crate::derivation::{Direction, Event, Occasion};
use crate::describe::incomplete;
use crate::expr::tape::Tape;
use crate::expr::{Expr, Graph};
use crate::flow::{Incomplete, Zeros};
use crate::number::{Bounded, NoValue};
use crate::trace::Trace;
use claim::program::Program;
use reason::{Reason, Sampling, Search};

/// How far beside a zero left − right is followed: until it is this share of its largest size on that side.
const FAR: f64 = 1e-8;
/// Or until the distance is this share of the span: beside a pole the largest size is no measure.
const LONG: f64 = 1e-3;
/// Each distance is so many times the one before.
const STEP: f64 = 4.0;
/// Fewest distances.
const FEWEST: usize = 4;
/// Most distances.
const STEPS: usize = 40;
/// The ratio of left − right to the distance varies by at most this factor where it passes 0 once, with a speed.
const PROPORTION: f64 = 3.0;

/// The times of an event that are meant.
pub struct Events<'a> {
    /// These times, and what the search leaves open of them.
    pub zeros: Cow<'a, Zeros>,
    /// Why others may be meant as well, or instead, where the search itself leaves nothing open.
    pub doubt: Option<Reason>,
    /// Whether the times themselves are in doubt, and not only whether there are others.
    pub all: bool,
}

/// The times of a claim's event on a motion; `None` where it has no event, or the event has no meaning on the motion.
pub fn of_claim<'a>(
    graph: &Graph,
    (claim, program): (&crate::derivation::Claim, &Program),
    trace: &'a Trace,
) -> Option<Events<'a>> {
    of_event(graph, claim.at.as_ref()?, program.at?, trace)
}

/// The same for an event with what vanishes at it.
pub fn of_event<'a>(graph: &Graph, event: &Event, e: Expr, trace: &'a Trace) -> Option<Events<'a>> {
    let zeros = trace.zeros(e)?;
    if event.occasion.is_any() {
        return Some(Events { zeros: Cow::Borrowed(zeros), doubt: None, all: false });
    }
    let Some(sides) = Sides::new(graph, e, trace, zeros) else {
        let doubt = Some(Sampling::DirectionUnknown(event.equation.text.as_str().into()).into());
        return Some(Events { zeros: Cow::Owned(Zeros::default()), doubt, all: true });
    };
    Some(meant(&sides, event.occasion))
}

/// What a zero is to an event.
enum Zero {
    /// The sides pass, in this direction.
    Passes(Direction),
    /// They meet at the end of the span, for certain: it is not seen whether they pass.
    AtEnd,
    /// It is none of those that are meant.
    Other,
    /// It cannot be told.
    Open(Sampling),
}

/// Takes those that are meant from all zeros.
fn meant<'a>(sides: &Sides<'a>, Occasion { direction, count }: Occasion) -> Events<'a> {
    let zeros = sides.zeros;
    let mut out = Zeros { peaks: zeros.peaks.clone(), ..Zeros::default() };
    let (mut doubt, mut passed) = (None, 0);
    for (&t, &slack) in zeros.times.iter().zip(&zeros.slack) {
        let is_meant = match (sides.zero(t, slack), direction) {
            (Zero::Passes(way), Some(wanted)) => way == wanted,
            (Zero::Passes(_) | Zero::AtEnd, None) => true,
            (Zero::AtEnd, Some(_)) | (Zero::Other, _) => false,
            (Zero::Open(reason), _) => {
                doubt.get_or_insert(reason.into());
                if count.is_some() {
                    break;
                }
                false
            }
        };
        if !is_meant {
            continue;
        }
        passed += 1;
        if count.is_none_or(|n| n == passed) {
            out.times.push(t);
            out.slack.push(slack);
        }
        if count == Some(passed) {
            break;
        }
    }
    let last = out.times.last().zip(out.slack.last()).map(|(t, slack)| t + slack);
    match (count, last) {
        // Which is the n-th hangs on all that comes before it.
        (Some(_), Some(until)) => {
            doubt = doubt.or(sides.open_before(until));
        }
        (None, _) | (Some(_), None) => {
            out.touching.clone_from(&zeros.touching);
            out.cut_off.clone_from(&zeros.cut_off);
            out.incomplete.clone_from(&zeros.incomplete);
        }
    }
    let all = count.is_some() && doubt.is_some();
    if all {
        (out.times, out.slack) = Default::default();
    }
    Events { zeros: Cow::Owned(out), doubt, all }
}

/// left − right of an event along a motion.
struct Sides<'a> {
    trace: &'a Trace<'a>,
    zeros: &'a Zeros,
    tape: Tape,
    /// The positions of its leaves among those of the motion.
    leaves: Vec<usize>,
    span: (f64, f64),
}

impl<'a> Sides<'a> {
    fn new(graph: &Graph, e: Expr, trace: &'a Trace<'a>, zeros: &'a Zeros) -> Option<Sides<'a>> {
        let own = graph.leaves([e]);
        let leaves = own.iter().map(|leaf| trace.leaves.binary_search(leaf).ok()).collect::<Option<Vec<_>>>()?;
        let tape = Tape::compile(graph, &own, &[e]).ok()?;
        Some(Sides { trace, zeros, tape, leaves, span: trace.stage.span(trace.trajectory) })
    }

    /// left − right at times.
    fn at(&self, times: &[f64]) -> Vec<Result<Bounded, NoValue>> {
        let points = self.trace.stage.points(self.trace.trajectory, times, &self.leaves);
        let mut slots = self.tape.slots::<Bounded>(&());
        let mut value = |i: usize| {
            let row = points.row(i);
            let inputs: Vec<_> = self.leaves.iter().map(|&leaf| row[leaf]).collect();
            self.tape.evaluate(&(), &inputs, &mut slots).pop().unwrap_or(Err(NoValue::OutOfDomain))
        };
        (0..times.len()).map(&mut value).collect()
    }

    /// What a zero is. That it lies at an end of the span is known only if left − right is 0 there without any error.
    fn zero(&self, t: f64, slack: f64) -> Zero {
        let (from, to) = self.span;
        let at_start = t - 2.0 * slack <= from;
        let at_end = t + 2.0 * slack >= to;
        let exactly = || matches!(self.at(&[t]).first(), Some(Ok(x)) if x.value == 0.0 && x.error == 0.0);
        if (at_start || at_end) && !((t == from || t == to) && exactly()) {
            return Zero::Open(Sampling::EventInsideSpan(t));
        }
        let sides = [(!at_start).then(|| self.side(t, slack, -1.0)), (!at_end).then(|| self.side(t, slack, 1.0))];
        match sides {
            [Some(Some(before)), Some(Some(after))] if before != after => {
                Zero::Passes(if after { Direction::Up } else { Direction::Down })
            }
            [None, Some(Some(_))] => Zero::Other,
            [Some(Some(_)), None] => Zero::AtEnd,
            _ => Zero::Open(Sampling::PassOnce(t)),
        }
    }

    /// Whether left − right is positive on one side of a zero, before (−1) or after it (1); `None` unless it grows there in
    /// proportion to the distance, from the error of the time on.
    fn side(&self, t: f64, slack: f64, sign: f64) -> Option<bool> {
        let (from, to) = self.span;
        let end = if sign < 0.0 { from } else { to };
        let beyond = |x: &&f64| sign * (**x - t) > 2.0 * slack;
        let nearest = |times: &[f64]| times.iter().filter(beyond).map(|x| (x - t).abs()).fold(f64::INFINITY, f64::min);
        // As far as the next zero, and not into it.
        let room = (end - t).abs().min(0.5 * nearest(&self.zeros.times)).min(0.5 * nearest(&self.zeros.touching));
        let next = self.zeros.times.iter().filter(beyond).map(|x| (x - t).abs()).fold(f64::INFINITY, f64::min);
        let peaks: Vec<f64> =
            self.zeros.peaks.iter().filter(beyond).filter(|x| (**x - t).abs() < next).copied().collect();
        let most = self.at(&peaks).iter().filter_map(|x| x.as_ref().ok()).map(|x| x.value.abs()).fold(0.0, f64::max);
        let least = (8.0 * slack).max(16.0 * f64::EPSILON * t.abs()).max(1e-15 * (to - from));
        let distances = std::iter::successors(Some(least), |d| Some(STEP * d)).take(STEPS);
        let distances: Vec<f64> = distances.take_while(|d| *d <= room).collect();
        let times: Vec<f64> = distances.iter().map(|d| t + sign * d).collect();
        let (mut lowest, mut highest, mut positive, mut seen) = (f64::INFINITY, 0.0_f64, None, 0);
        for (distance, value) in distances.iter().zip(self.at(&times)) {
            let value = value.ok().filter(|x| !x.contains_zero())?;
            if *positive.get_or_insert(value.value > 0.0) != (value.value > 0.0) {
                return None;
            }
            let ratio = value.value.abs() / distance;
            (lowest, highest) = (lowest.min(ratio), highest.max(ratio));
            if highest > PROPORTION * lowest {
                return None;
            }
            seen += 1;
            let far = value.value.abs() >= FAR * most || *distance >= LONG * (to - from);
            if seen >= FEWEST && most > 0.0 && far {
                return positive;
            }
        }
        None
    }

    /// Why there may be other zeros up to a time.
    fn open_before(&self, until: f64) -> Option<Reason> {
        if let Some(&t) = self.zeros.touching.iter().find(|t| **t <= until) {
            return Some(Sampling::MayMeet(t).into());
        }
        // Where there is no value, the sides do not meet.
        let open = |gap: &&Incomplete| match gap {
            Incomplete::NoValue { reason: NoValue::OutOfDomain, .. } => false,
            Incomplete::NoValue { .. } | Incomplete::Vanishing { .. } | Incomplete::Unresolved { .. } => {
                gap.stretch().0 <= until
            }
        };
        let gap = self.zeros.incomplete.iter().find(open)?;
        Some(Sampling::Incomplete { search: Search::Before, gap: incomplete(gap) }.into())
    }
}
