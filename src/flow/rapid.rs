//! Where an expression varies more rapidly than the samples of a motion, or a series around one time, tell.
//!
//! **In:** an expression along a motion, and the samples. **Out:** the times between them at which it is to be looked at, see
//! [`arguments`](super::arguments) for why.

use super::arguments::Argument;
use super::core::Core;
use super::cover::Explorer;
use super::program::Program;

/// Degree of the polynomials of arguments.
const DEGREE: usize = 12;
/// Most times that are added.
const MOST: usize = 20_000;

/// Times between samples at which an expression is to be looked at.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rapid {
    /// Where an exponential, or a high power, changes by a large factor from one sample to the next.
    pub times: Vec<f64>,
    /// Where only what is divided by, or has a root, does: there errors may be larger than anything that is to be seen.
    pub singular: Vec<f64>,
    /// A stretch on which an exponential has more such times than can be looked at.
    pub unresolved: Option<(f64, f64)>,
}

/// Cuts a stretch in halves until all arguments move moderately on each, or it is as short as times can be told: whether that took
/// no more times than can be looked at. The expression itself need not have a value.
fn resolve(explorer: &mut Explorer, whole: (f64, f64), times: &mut Vec<f64>) -> bool {
    let mut stack = vec![whole];
    while let Some((start, end)) = stack.pop() {
        let middle = start + 0.5 * (end - start);
        let smallest = 1e-12 * (whole.1 - whole.0) + 2.0 * f64::EPSILON * start.abs().max(end.abs());
        if explorer.is_moderate(middle, 0.5 * (end - start)) || end - start <= smallest {
            times.extend([start, middle]);
        } else {
            stack.extend([(middle, end), (start, middle)]);
        }
        if times.len() + stack.len() > MOST {
            return false;
        }
    }
    true
}

/// Looks between the samples of a motion at which an expression varies rapidly.
pub(super) fn rapid(core: &Core, program: &Program, samples: &[f64]) -> Rapid {
    let mut out = Rapid::default();
    let arguments = program.arguments();
    if arguments.is_empty() {
        return out;
    }
    let mut explorer = Explorer::new(core, program, DEGREE);
    let slots = arguments.slots();
    let here: Vec<Vec<Option<f64>>> = samples.iter().map(|&t| explorer.plain_values(t, &slots)).collect();
    let value = |k: usize, slot: usize| here[k][slots.binary_search(&slot).ok()?];
    // From sample to sample, and from those beside them: a peak between two that are alike shows in its neighbours.
    let moved = |argument: &Argument, i: usize| {
        let beside = i.saturating_sub(1)..(i + 2).min(samples.len() - 1);
        let step = |k: usize, slot: usize| Some((value(k + 1, slot)? - value(k, slot)?).abs());
        let by = |slot: usize| beside.clone().filter_map(|k| step(k, slot)).fold(0.0, f64::max);
        !(i..i + 2).all(|k| argument.is_moderate(|slot| value(k, slot).map(|u| (u, by(slot)))))
    };
    for i in 0..samples.len().saturating_sub(1) {
        let (mut exponential, mut singular) = (false, false);
        for argument in arguments.iter().filter(|a| moved(a, i)) {
            match argument.is_exponential() {
                true => exponential = true,
                false => singular = true,
            }
        }
        if !exponential && !singular {
            continue;
        }
        let into = if exponential { &mut out.times } else { &mut out.singular };
        let resolved = resolve(&mut explorer, (samples[i], samples[i + 1]), into);
        if exponential && !resolved {
            out.unresolved.get_or_insert((samples[i], samples[i + 1]));
        }
    }
    for times in [&mut out.times, &mut out.singular] {
        times.sort_by(f64::total_cmp);
        times.dedup();
        times.retain(|t| samples.binary_search_by(|x| x.total_cmp(t)).is_err());
    }
    out
}
