//! Quantities that are measured, not judged.
//!
//! **In:** a measure, and a motion. **Out:** its values, each with its time and an error bound, and why there are none, or others.
//!
//! **Guaranteed:** a value between two events is one only where the search for the first event is complete from there to the second:
//! else another time might be meant. How far an event may be off is part of the error.

use crate::derivation::{Derivation, Event, Since};
use crate::describe::incomplete;
use crate::events;
use crate::events::Events;
use crate::expr::{Expr, Graph, Leaf};
use crate::findings::Measurement;
use crate::flow::Rapid;
use crate::number::{Bounded, NoValue};
use crate::stage::Searched;
use crate::trace::Trace;
use claim::comparison::cuts;
use claim::denote::{at_event, rapid};
use claim::quantity::Quantity;
use reason::{Plain, Reason, Sampling, Search};

/// Most values that are kept of one measure on one motion.
const MOST: usize = 200;

/// A measure, compiled.
pub struct Compiled {
    index: usize,
    formula: Expr,
    /// What vanishes at the events at which it is taken.
    at: Option<Expr>,
    /// What vanishes at those from which on it is taken.
    since: Option<Expr>,
    /// Where angles in it have their cuts.
    cuts: Vec<[Expr; 2]>,
    /// What of it may vary more rapidly than a motion is sampled.
    rapid: Vec<Expr>,
    quantity: Option<Quantity>,
}

/// Compiles the measures of a file.
pub fn compile(graph: &mut Graph, derivation: &Derivation) -> Vec<Compiled> {
    let one = |(index, m): (usize, &derivation::Measure)| {
        let formula = m.formula.value.as_scalar()?;
        let at = m.at.as_ref().and_then(|at| at_event(graph, &at.equation.value));
        let since = m.since.as_ref().and_then(|(since, _)| at_event(graph, &since.equation.value));
        let cuts = cuts(graph, &derivation.scope, [formula]);
        // Only a mean depends on what is between events.
        let meant = m.since.as_ref().is_some_and(|(_, take)| *take == Since::Mean);
        let rapid = if meant { rapid(graph, &derivation.scope, vec![formula]) } else { Vec::new() };
        Some(Compiled { index, formula, at, since, cuts, rapid, quantity: None })
    };
    derivation.measures.iter().enumerate().filter_map(one).collect()
}

impl Compiled {
    /// The leaves that must be known.
    pub fn leaves(&self, graph: &Graph) -> Vec<Leaf> {
        let cuts = self.cuts.iter().flatten().copied();
        graph.leaves([self.formula].into_iter().chain(self.events()).chain(cuts))
    }

    /// What vanishes at its events.
    pub fn events(&self) -> impl Iterator<Item = Expr> {
        self.at.into_iter().chain(self.since)
    }

    /// Whether it is asked for on a motion.
    fn is_taken_on(&self, derivation: &Derivation, trajectory: usize) -> bool {
        derivation.measures.get(self.index).is_some_and(|m| m.trajectories.binary_search(&trajectory).is_ok())
    }

    /// Makes ready for points with the values of these leaves.
    pub fn on(mut self, graph: &Graph, known: &[Leaf]) -> Compiled {
        self.quantity = Quantity::new(graph, known, self.formula, &self.cuts);
        self
    }

    /// Takes the measure on a motion; `None` when it is not asked for there.
    pub fn take(&self, derivation: &Derivation, trace: &Trace) -> Option<Measurement> {
        let trajectory = trace.trajectory;
        let measure = derivation.measures.get(self.index)?;
        if measure.trajectories.binary_search(&trajectory).is_err() {
            return None;
        }
        let mut out = Measurement {
            measure: measure.id.clone(),
            trajectory: derivation.trajectories[trajectory].id.clone(),
            values: Vec::new(),
            reason: None,
        };
        let Some(quantity) = &self.quantity else {
            out.reason = Some(Plain::MeasureUnknown.into());
            return Some(out);
        };
        let Some((at, second_event)) = measure.at.as_ref().zip(self.at) else {
            self.at_time(derivation.trajectories[trajectory].initial_time, trace, quantity, &mut out);
            return Some(out);
        };
        let none = |event: &Event| Sampling::NoMeaning(event.equation.text.as_str().into()).into();
        let Some(found) = events::of_event(&derivation.graph, at, second_event, trace) else {
            out.reason = Some(none(at));
            return Some(out);
        };
        out.reason = missing(at, &found);
        let times = found.zeros.times.iter().copied().zip(found.zeros.slack.iter().copied());
        let events: Vec<Known> = times.map(|(t, slack)| Known { t, slack }).collect();
        let (shown, left_out) = events.split_at(events.len().min(MOST));
        match measure.since.as_ref().zip(self.since) {
            None => shown.iter().for_each(|event| self.at_event(*event, trace, quantity, &mut out)),
            Some(((since, take), e)) => match events::of_event(&derivation.graph, since, e, trace) {
                None => out.reason = Some(none(since)),
                Some(first) => {
                    for &second in shown {
                        match before(second, since, &first, e == second_event) {
                            Ok(first) => self.between(first, second, *take, (trace, quantity), &mut out),
                            Err(reason) => out.reason = Some(reason),
                        }
                    }
                }
            },
        }
        if !left_out.is_empty() {
            out.reason = Some(Sampling::MoreEvents(left_out.len()).into());
        }
        Some(out)
    }

    /// Takes the quantity at a time.
    fn at_time(&self, t: f64, trace: &Trace, quantity: &Quantity, out: &mut Measurement) {
        note(t, quantity.value(&trace.values(t)), out);
    }

    /// Takes the quantity at an event.
    fn at_event(&self, Known { t, slack }: Known, trace: &Trace, quantity: &Quantity, out: &mut Measurement) {
        note(t, quantity.value(&trace.values_at_event(t, slack)), out);
    }

    /// Takes what is asked for between two events.
    fn between(
        &self,
        first: Known,
        second: Known,
        take: Since,
        (trace, quantity): (&Trace, &Quantity),
        out: &mut Measurement,
    ) {
        let at = |of: Known| quantity.value(&trace.values_at_event(of.t, of.slack));
        let ends = at(first).and_then(|a| Ok((a, at(second)?)));
        let found = ends.and_then(|(a, b)| match take {
            Since::Change => Ok(b - a),
            Since::Mean => mean(trace, (quantity, &self.rapid), (first, a), (second, b)),
        });
        note(second.t, found, out);
    }
}

/// What is searched for on a motion on which some of these are taken.
pub fn searched(measures: &[Compiled], derivation: &Derivation, trajectory: usize) -> Searched {
    let taken = || measures.iter().filter(|m| m.is_taken_on(derivation, trajectory));
    Searched {
        zeros: taken().flat_map(Compiled::events).collect(),
        rapid: taken().flat_map(|m| &m.rapid).copied().collect(),
    }
}

/// An event of a motion, and how far its time may be off.
#[derive(Clone, Copy)]
struct Known {
    t: f64,
    slack: f64,
}

/// Why an event may have other times than those that were found, or has none.
fn missing(event: &Event, found: &Events) -> Option<Reason> {
    let (zeros, text) = (&found.zeros, || event.equation.text.as_str().into());
    if found.doubt.is_some() {
        return found.doubt.clone();
    }
    if let (true, Some(t)) = (zeros.times.is_empty(), zeros.touching.first()) {
        return Some(Sampling::OnlyTouches { event: text(), t: *t }.into());
    }
    if let Some(partial) = zeros.incomplete.first() {
        return Some(Sampling::Incomplete { search: Search::Event(text()), gap: incomplete(partial) }.into());
    }
    zeros.times.is_empty().then(|| Sampling::NeverHappens(event.says().into()).into())
}

/// The last time of an event before another event.
fn before(second: Known, since: &Event, found: &Events, is_same: bool) -> Result<Known, Reason> {
    let zeros = &found.zeros;
    let mut all = zeros.times.iter().zip(&zeros.slack).map(|(t, slack)| Known { t: *t, slack: *slack });
    let is_near = |of: &Known| (of.t - second.t).abs() <= of.slack + second.slack;
    // Where both sides are one, the second event is among those of the first.
    if let Some(near) = all.clone().find(|of| is_near(of) && !(is_same && of.t == second.t)) {
        return Err(Sampling::WhichFirst(near.t).into());
    }
    let earlier = all.rfind(|of| of.t < second.t && !is_near(of));
    // Without an earlier one, everything before counts.
    let from = earlier.map_or(f64::NEG_INFINITY, |first| first.t);
    let gap = |stretch: (f64, f64)| stretch.1 >= from && stretch.0 <= second.t;
    let open = zeros.touching.iter().any(|t| gap((*t, *t)))
        || zeros.incomplete.iter().any(|i| gap(i.stretch()))
        || zeros.cut_off.iter().any(|t| gap((*t, *t)));
    match (&found.doubt, earlier) {
        (Some(doubt), _) => Err(doubt.clone()),
        (None, _) if open => Err(Sampling::MayHappenBefore { event: since.says().into(), t: second.t }.into()),
        (None, None) => Err(Sampling::NotBefore { event: since.says().into(), t: second.t }.into()),
        (None, Some(first)) => Ok(first),
    }
}

/// Writes down a value, or why there is none.
fn note(t: f64, found: Result<Bounded, NoValue>, out: &mut Measurement) {
    match found {
        Ok(x) => out.values.push((t, x.value, x.error)),
        Err(why) => out.reason = Some(Sampling::NoValueAt { t, why }.into()),
    }
}

/// The nodes of the rule of Gauss and Kronrod with 15 points, from the middle outwards, with their weights; the second weight is that
/// of the rule of Gauss with 7 points, which has every second node.
const NODES: [(f64, f64, f64); 8] = [
    (0.0, 0.209_482_141_084_727_82, 0.417_959_183_673_469_4),
    (0.207_784_955_007_898_48, 0.204_432_940_075_298_89, 0.0),
    (0.405_845_151_377_397_2, 0.190_350_578_064_785_42, 0.381_830_050_505_118_9),
    (0.586_087_235_467_691_1, 0.169_004_726_639_267_9, 0.0),
    (0.741_531_185_599_394_5, 0.140_653_259_715_525_92, 0.279_705_391_489_276_64),
    (0.864_864_423_359_769_1, 0.104_790_010_322_250_19, 0.0),
    (0.949_107_912_342_758_5, 0.063_092_092_629_978_56, 0.129_484_966_168_869_7),
    (0.991_455_371_120_812_6, 0.022_935_322_010_529_224, 0.0),
];

/// Stretches are halved until the two rules differ by less than this share of the integral of the size of the quantity.
const AGREED: f64 = 1e-12;

/// Stretches beside kinks and leaps are not cut shorter than this share of all.
const CLOSEST: f64 = 1e-9;

/// The better rule is off by at most so many times what the two differ by, at a kink, too.
const OFF: f64 = 16.0;

/// A larger share of it that the errors of values leave open is too much.
const TOLD: f64 = 1e-6;

/// What is left after so many halvings is where the quantity has no integral, as at a pole.
const HALVINGS: u32 = 50;

/// More stretches are not looked at.
const STRETCHES: usize = 100_000;

/// A stretch with what two rules say of the integral over it.
#[derive(Clone, Copy)]
struct Stretch {
    ends: (f64, f64),
    halvings: u32,
    integral: f64,
    /// How far the rules differ.
    apart: f64,
    /// How far the values may be off.
    off: f64,
    /// The integral of the size.
    size: f64,
}

/// Quadrature over some stretches of time, none with a value missing.
fn quadrature(trace: &Trace, quantity: &Quantity, ends: &[((f64, f64), u32)]) -> Result<Vec<Stretch>, NoValue> {
    let sides = [-1.0, 1.0];
    let nodes = || NODES.iter().flat_map(|node| sides.iter().map(move |side| (side * node.0, node))).skip(1);
    let leaves: Vec<usize> = (0..trace.leaves.len()).collect();
    let mut out = Vec::with_capacity(ends.len());
    // A few stretches at a time: memory does not grow with the span.
    for some in ends.chunks(64) {
        let places = some.iter().flat_map(|((a, b), _)| nodes().map(move |(x, _)| 0.5 * (a + b) + 0.5 * (b - a) * x));
        let points = trace.stage.points(trace.trajectory, &places.collect::<Vec<_>>(), &leaves);
        let mut at = 0;
        for &(ends, halvings) in some {
            let half = 0.5 * (ends.1 - ends.0);
            let mut of = Stretch { ends, halvings, integral: 0.0, apart: 0.0, off: 0.0, size: 0.0 };
            let mut coarse = 0.0;
            for (_, (_, weight, of_gauss)) in nodes() {
                let x = quantity.beside_leaps(&points.row(at))?;
                at += 1;
                of.integral += half * weight * x.value;
                coarse += half * of_gauss * x.value;
                of.size += half * weight * x.value.abs();
                of.off += half * weight * (x.error + 4.0 * f64::EPSILON * x.value.abs());
            }
            of.apart = (of.integral - coarse).abs();
            out.push(of);
        }
    }
    Ok(out)
}

/// The mean of the quantity between two events, at which it has these values: quadrature over the stretches between the samples of
/// the motion, and the times at which the quantity may vary more rapidly than these tell; they are halved where it bends or leaps. Where
/// it is smooth the two rules differ by far more than the better one is off; where it is not, by no less than a part of it.
fn mean(
    trace: &Trace,
    (quantity, rapid): (&Quantity, &[Expr]),
    (first, at_first): (Known, Bounded),
    (second, at_second): (Known, Bounded),
) -> Result<Bounded, NoValue> {
    let Rapid { times, singular, unresolved } = trace.rapid(rapid);
    if unresolved.is_some_and(|(from, to)| to >= first.t && from <= second.t) {
        return Err(NoValue::Indeterminate);
    }
    // Closer to a kink or a leap than this, a stretch adds nothing that is seen; and values are not known there.
    let closest = CLOSEST * (second.t - first.t);
    let mut last = f64::NEG_INFINITY;
    let apart = |t: &f64| {
        let is_apart = *t - last >= closest;
        last = if is_apart { *t } else { last };
        is_apart
    };
    let singular: Vec<f64> = singular.into_iter().filter(apart).collect();
    let inner = trace.times.iter().copied().chain(times).chain(singular).filter(|t| first.t < *t && *t < second.t);
    let mut ends: Vec<f64> = [first.t, second.t].into_iter().chain(inner).collect();
    ends.sort_by(f64::total_cmp);
    ends.dedup();
    let whole: Vec<_> = ends.windows(2).map(|w| ((w[0], w[1]), 0)).collect();
    let mut found = quadrature(trace, quantity, &whole)?;
    let size: f64 = found.iter().map(|s| s.size).sum();
    let (mut sum, mut error, mut open, mut looked) = (0.0, 0.0, 0.0, found.len());
    loop {
        let mut halves = Vec::new();
        for s in found {
            let (a, b) = s.ends;
            // So narrow a stretch has one value, as far as numbers of binary64 tell: what it adds must be nothing.
            let narrow = b - a <= 64.0 * f64::EPSILON * a.abs().max(b.abs());
            if narrow && s.size > AGREED * size {
                return Err(NoValue::Indeterminate);
            }
            if narrow || s.apart <= s.off.max(AGREED * size) {
                sum += s.integral;
                error += OFF * s.apart + s.off + if narrow { s.size } else { 0.0 };
                // What values do not tell may hide a pole.
                open += if s.apart > AGREED * size { s.apart } else { 0.0 };
                continue;
            }
            if s.halvings == HALVINGS {
                return Err(NoValue::Indeterminate);
            }
            let middle = a + 0.5 * (b - a);
            halves.extend([((a, middle), s.halvings + 1), ((middle, b), s.halvings + 1)]);
        }
        looked += halves.len();
        if halves.is_empty() {
            break;
        }
        if looked > STRETCHES {
            return Err(NoValue::Indeterminate);
        }
        found = quadrature(trace, quantity, &halves)?;
    }
    if open > TOLD * size {
        return Err(NoValue::Indeterminate);
    }
    let duration = second.t - first.t;
    let mean = sum / duration;
    // How the mean moves with its ends.
    let end = |of: Known, x: Bounded| of.slack * (x.value.abs() + x.error + mean.abs());
    let rounding = 4.0 * f64::EPSILON * looked as f64 * size / duration;
    let error = (error + end(first, at_first) + end(second, at_second)) / (duration - first.slack - second.slack);
    Ok(Bounded { value: mean, error: error + rounding })
}
