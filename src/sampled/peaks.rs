//! Exponentials and high powers between the samples.
//!
//! A motion is sampled so densely that its states are seen; a formula of the states may still hide a peak between two
//! samples: e^u is 0 for a reader wherever u is far below 0, and a quadratic u may touch 0 for a moment. What can be seen at
//! the samples is u itself. Where it is largest or smallest among its neighbours, and differs from them by much, the extremum
//! is looked for, and the claim is tried at every time on the way there.
//!
//! **In:** a claim that holds at all samples. **Out:** the times on the way to the extrema of the exponents.

use crate::course::{Course, Trial};
use crate::expr::tape::{Slots, Tape};
use crate::flow::Sample;
use crate::number::Bounded;

/// An exponent that changes by less than this from one sample to the next hides nothing.
const STEEP: f64 = 8.0;
/// Steps of the search for an extremum: beyond the last digit of the time.
const STEPS: usize = 80;
/// Most extrema that are looked for.
const MOST: usize = 32;
/// The golden section.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// Evaluates the exponents at times.
struct Exponents<'a> {
    course: &'a Course<'a>,
    tape: Tape,
    places: Vec<Option<usize>>,
    slots: Slots<Bounded>,
}

impl Exponents<'_> {
    fn at(&mut self, point: Sample) -> Vec<Option<f64>> {
        let value = |place: &Option<usize>| match place {
            Some(at) => point.get(*at),
            // The sign of ±.
            None => Ok(Bounded::exact(1.0)),
        };
        let inputs: Vec<_> = self.places.iter().map(value).collect();
        self.tape.evaluate(&(), &inputs, &mut self.slots).into_iter().map(|x| x.ok().map(|x| x.value)).collect()
    }

    /// The times on the way to the largest value of ±u between two times.
    fn climb(&mut self, which: usize, sign: f64, (mut a, mut b): (f64, f64), times: &mut Vec<f64>) {
        let mut height = |t: f64| {
            let point = self.course.values(t);
            self.at(Sample::Alone(&point))[which].map_or(f64::NEG_INFINITY, |u| sign * u)
        };
        let (mut x, mut y) = (b - GOLDEN * (b - a), a + GOLDEN * (b - a));
        let (mut at_x, mut at_y) = (height(x), height(y));
        for _ in 0..STEPS {
            if !(a < x && x < y && y < b) {
                break;
            }
            times.extend([x, y]);
            if at_x >= at_y {
                (b, y, at_y) = (y, x, at_x);
                x = b - GOLDEN * (b - a);
                at_x = height(x);
            } else {
                (a, x, at_x) = (x, y, at_y);
                y = a + GOLDEN * (b - a);
                at_y = height(y);
            }
        }
    }
}

/// Times on the way to the extrema of the exponents of a claim, increasing; `None` where there are too many extrema.
pub(super) fn times(trial: &Trial) -> Option<Vec<f64>> {
    let Trial { graph, program, course, .. } = *trial;
    let mut out = Vec::new();
    if program.steep.is_empty() {
        return Some(out);
    }
    let leaves = graph.leaves(program.steep.iter().copied());
    let Ok(tape) = Tape::compile(graph, &leaves, &program.steep) else { return Some(out) };
    let places = leaves.iter().map(|leaf| course.leaves.binary_search(leaf).ok()).collect();
    let slots = tape.slots::<Bounded>(&());
    let mut exponents = Exponents { course, tape, places, slots };
    let values: Vec<Vec<Option<f64>>> = course.points.samples().map(|point| exponents.at(point)).collect();
    let last = course.times.len().checked_sub(1)?;
    let mut found = 0;
    for (which, i) in (0..program.steep.len()).flat_map(|which| (0..=last).map(move |i| (which, i))) {
        let (before, after) = (i.saturating_sub(1), (i + 1).min(last));
        let (Some(u), Some(p), Some(q)) = (values[i][which], values[before][which], values[after][which]) else {
            continue;
        };
        if (u - p).abs().max((u - q).abs()) <= STEEP {
            continue;
        }
        for sign in [1.0, -1.0] {
            // Of several equal neighbours the first.
            if sign * (u - p) < 0.0 || sign * (u - q) < 0.0 || (i > before && u == p) {
                continue;
            }
            found += 1;
            if found > MOST {
                return None;
            }
            exponents.climb(which, sign, (course.times[before], course.times[after]), &mut out);
        }
    }
    out.sort_by(f64::total_cmp);
    out.dedup();
    Some(out)
}
