//! One step of a Taylor method on the system's own tape.
//!
//! With the coefficients x₀ … xₖ of every state in the slots, one run of the tape at order k gives the coefficient
//! fₖ of every rate, and xₖ₊₁ = fₖ/(k + 1). The step follows Jorba & Zou (2005), "A software package for the
//! numerical integration of ODEs by means of high-order Taylor methods", Experimental Mathematics 14, §3: with the radius
//! ρ = min over the last two orders of (‖x₀‖/‖xₖ‖)^(1/k), the step ρ·e⁻²·exp(−0.7/(p − 1)) makes the last term about
//! e⁻²ᵖ of the first.

mod arrival;
mod start;
mod sums;

use std::ops::Range;

use super::kinks::{Edges, Kinks, Series};
use super::narrow::Narrow;
use expr::Leaf;
use expr::tape::{Slots, Tape};
use number::{Bounded, Growth, Instruction, Interval, Jet, NoValue, Orders, Recurrences, Scalar, widely};
pub(super) use sums::Moved;
use sums::Sums;

/// A field compiled for numbers: inputs are the time, the states, and the constants.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Flow {
    pub(super) tape: Tape,
    pub(super) dimension: usize,
    pub(super) names: Vec<String>,
    /// States of one symbol and one rate share a scale: group number of every state, and their count.
    groups: Vec<usize>,
    group_count: usize,
    /// The same as stretches of states: the group of each, and its states.
    stretches: Vec<(usize, Range<usize>)>,
    /// Where the right sides are not smooth.
    pub(super) edges: Edges,
    /// Whether the right sides name the time.
    driven: bool,
    /// The recurrences of what moves, and the instructions for what does not.
    pub(super) recurrences: Recurrences,
    still: Vec<Instruction>,
    /// Whether the right sides are polynomials in what moves.
    polynomial: bool,
}

/// Order and caution of one integration.
#[derive(Clone, Copy, Debug)]
pub(super) struct Control {
    /// Order of the Taylor polynomials.
    pub(super) order: usize,
    /// Factor on the step size, at most 1.
    pub(super) caution: f64,
}

/// Longest step, as a part of the span.
const LONGEST: f64 = 0.125;
/// Longest step where the time enters the right sides, as a part of the span.
const LONGEST_DRIVEN: f64 = 1.0 / 2048.0;

/// An edge that is nearer than this share of the span is met at a kink.
const NEAR: f64 = 1e-6;
/// Two times within a step that are apart by less than this share of the way may be one.
const SAME: f64 = 1e-6;
/// A step that is to end before a jump ends at this share of the way.
const BEFORE: f64 = 1.0 - 1e-9;
/// Most kinks that a motion may cross: one that slides along a kink crosses it without end.
const MOST_KINKS: usize = 4_000;
/// Units of work that a step takes beside its series: its size, its edges, its sums.
const OF_A_STEP: u64 = 2_500;
/// Components that are summed side by side.
const ABREAST: usize = 4;

/// Why a step cannot be made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Stop {
    /// The step size is below the resolution of the time.
    Collapsed,
    /// A rate has no value; the number of the state.
    NoRate(usize, NoValue),
    /// A right side jumps, or its slope is infinite: several motions may go on from there, or none.
    Undetermined,
}

/// An integration under way: the state at the present time, its expansion there, and the step that is tried.
///
/// A walker does not grow series itself: it says at which time and state it needs one ([`Walker::asks`]), and is told
/// ([`Walker::begin`], [`Walker::judge`]). So several of them can have their series grown together, and none can tell.
pub(super) struct Walker<'a> {
    flow: &'a Flow,
    control: Control,
    constants: Vec<f64>,
    /// Present time, direction and end.
    pub(super) time: f64,
    pub(super) end: f64,
    length: f64,
    begun: bool,
    /// State and the part of it that binary64 cannot hold.
    pub(super) state: Vec<f64>,
    low: Vec<f64>,
    /// Coefficients around the present time: all of order 0, then those of order 1, up to the order.
    now: Vec<f64>,
    next: Vec<f64>,
    next_state: Vec<f64>,
    next_low: Vec<f64>,
    /// c₁ + c₂h + … of each component at the end of the step that is tried, and c₁ + 2c₂h + …, its slope.
    sums: Vec<f64>,
    slopes: Vec<f64>,
    /// How far the slopes are from the rates at the end of the step.
    defects: Vec<f64>,
    scale: Vec<f64>,
    top: Vec<f64>,
    /// The step as a part of the radius that is seen in a series.
    factor: f64,
    last_step: f64,
    kinks: Kinks,
    narrow: Option<Narrow>,
    /// Room for the rounding of the rates, once it was asked for.
    rounding: Option<Slots<Jet<Bounded>>>,
    /// What the states may be off for steps that end a little behind a kink.
    pub(super) late: Vec<f64>,
    trial: Trial,
}

/// A step that is tried.
#[derive(Clone, Copy)]
struct Trial {
    /// Where it ends, and how far that is.
    target: f64,
    h: f64,
    /// Its size, the smallest that there is, and what is left of the span.
    size: f64,
    smallest: f64,
    remaining: f64,
    /// A kink within it: how far, and which argument.
    kink: Option<(f64, usize)>,
    /// How far behind a kink it ends.
    behind: f64,
    /// Why the last try was none.
    why: Stop,
}

/// A finished step, as far as its owner wants to keep it.
pub(super) struct Step<'w> {
    /// Coefficients around the time before the step, order by order.
    pub(super) coefficients: &'w [f64],
    /// Low parts of the zeroth coefficients.
    pub(super) low: &'w [f64],
    /// How far the slopes of the polynomials are from the rates at the end of the step.
    pub(super) defects: &'w [f64],
}

impl Flow {
    pub(super) fn new(tape: Tape, states: &[Leaf], names: Vec<String>) -> Flow {
        let mut kinds: Vec<(usize, u8)> = Vec::new();
        let groups: Vec<usize> = states
            .iter()
            .map(|l| {
                let kind = (l.symbol.index(), l.rate);
                kinds.iter().position(|&k| k == kind).unwrap_or_else(|| {
                    kinds.push(kind);
                    kinds.len() - 1
                })
            })
            .collect();
        let mut stretches: Vec<(usize, Range<usize>)> = Vec::new();
        for (i, &group) in groups.iter().enumerate() {
            match stretches.last_mut() {
                Some((last, states)) if *last == group => states.end = i + 1,
                _ => stretches.push((group, i..i + 1)),
            }
        }
        let driven = tape.instructions().iter().any(|i| i.a == 0 || i.b == 0);
        let (dimension, group_count, edges) = (states.len(), kinds.len(), Edges::default());
        let (recurrences, still, polynomial) = (Recurrences::default(), Vec::new(), false);
        let flow = Flow {
            tape,
            dimension,
            names,
            groups,
            group_count,
            stretches,
            edges,
            driven,
            recurrences,
            still,
            polynomial,
        };
        let moves = flow.moving(true);
        let steps = flow.tape.instructions();
        let rates = (0..dimension).map(|i| flow.tape.output_slot(i)).collect();
        let recurrences = Recurrences::new(steps, &moves, rates);
        let still = steps.iter().copied().filter(|step| !moves[step.out as usize]).collect();
        let polynomial = Narrow::hides_nothing(&flow.tape, &moves);
        Flow { edges: Edges::of(&flow), recurrences, still, polynomial, ..flow }
    }

    /// All that it computes, as a text; the rest follows from that.
    pub(super) fn content(&self) -> String {
        format!("{} {:?} {:?}", self.tape.content(), self.names, self.groups)
    }

    /// Whether the right sides are polynomials, by nothing but the states: a motion has nothing between the ends of a step that
    /// its series does not tell.
    pub(super) fn is_plain(&self) -> bool {
        self.polynomial && !self.driven && self.edges.is_empty()
    }

    /// The size of the states of each kind on a step of length h, from their series, order by order.
    pub(super) fn reach(&self, series: &[f64], h: f64, out: &mut Vec<f64>) {
        out.clear();
        out.resize(self.group_count, 0.0);
        let (first, rest) = series.split_at(self.dimension);
        let (second, third) = rest.split_at(self.dimension);
        for (group, states) in &self.stretches {
            let [first, second, third] = [first, second, third].map(|of| &of[states.clone()]);
            let size = |i: usize| larger(larger(first[i].abs(), (second[i] * h).abs()), (third[i] * h * h).abs());
            out[*group] = larger(out[*group], largest(first.len(), size));
        }
    }

    /// The kind of every state.
    pub(super) fn kinds(&self) -> &[usize] {
        &self.groups
    }

    /// Sets the constants of lanes.
    pub(super) fn enter<const N: usize>(&self, growth: &mut Growth<N>, lanes: Range<usize>, constants: &[f64]) {
        for (slot, x) in self.still(constants).into_iter().enumerate() {
            growth.start_mut(slot).0[lanes.clone()].fill(x);
        }
    }

    /// What every slot that does not move holds, for some constants; NaN where it has no value. What moves is 0.
    fn still(&self, constants: &[f64]) -> Vec<f64> {
        let mut slots = self.tape.slots::<f64>(&());
        for (i, &c) in constants.iter().enumerate() {
            slots.set(1 + self.dimension + i, Ok(c));
        }
        self.tape.run_some(&(), &mut slots, &self.still);
        let value = |slot: usize| if slots.missing(slot).is_some() { f64::NAN } else { *slots.value(slot) };
        (0..self.tape.slot_count()).map(value).collect()
    }

    /// Slots for series up to `order`, with constants in place.
    pub(super) fn slots<B: Scalar>(&self, order: usize, constants: &[B]) -> Slots<Jet<B>> {
        let orders = Orders::all(order);
        let mut slots = self.tape.slots::<Jet<B>>(&orders);
        for (i, &c) in constants.iter().enumerate() {
            slots.set(1 + self.dimension + i, Ok(Jet::constant(c, &orders)));
        }
        slots
    }

    /// Expands the motion through (`time`, `state`) up to `order`; `out` has `order + 1` coefficients for every state.
    ///
    /// # Errors
    /// The first state whose rate has no value.
    pub(super) fn expand<B: Scalar>(
        &self,
        slots: &mut Slots<Jet<B>>,
        order: usize,
        time: B,
        state: &[B],
        out: &mut [B],
    ) -> Result<(), (usize, NoValue)> {
        let row = order + 1;
        slots.value_mut(0).set_coefficient(0, time);
        slots.value_mut(0).set_coefficient(1, B::integer(1));
        for (i, &x) in state.iter().enumerate() {
            out[i * row] = x;
            slots.value_mut(1 + i).set_coefficient(0, x);
        }
        for k in 0..order {
            self.tape.run(&Orders::only(k, order), slots);
            let divisor = B::integer(k as i32 + 1);
            for i in 0..self.dimension {
                let slot = self.tape.output_slot(i);
                if let Some(reason) = slots.missing(slot) {
                    return Err((i, reason));
                }
                let c = (slots.value(slot).coefficient(k) / divisor).checked().map_err(|reason| (i, reason))?;
                out[i * row + k + 1] = c;
                slots.value_mut(1 + i).set_coefficient(k + 1, c);
            }
        }
        Ok(())
    }
}

impl Flow {
    /// The slots that depend on a state, or, if asked for, on the time.
    pub(super) fn moving(&self, with_time: bool) -> Vec<bool> {
        let mut out = vec![false; self.tape.slot_count()];
        out[0] = with_time;
        out[1..=self.dimension].fill(true);
        for step in self.tape.instructions() {
            out[step.out as usize] = out[step.a as usize] || out[step.b as usize];
        }
        out
    }
}

impl<'a> Walker<'a> {
    /// An integration from `time` to `end` that has not begun.
    pub(super) fn new(
        flow: &'a Flow,
        control: Control,
        constants: &[f64],
        (time, end): (f64, f64),
        state: &[f64],
    ) -> Walker<'a> {
        let n = flow.dimension;
        let row = control.order + 1;
        let why = Stop::Collapsed;
        Walker {
            flow,
            control,
            constants: constants.to_vec(),
            time,
            end,
            length: (end - time).abs(),
            begun: false,
            state: state.to_vec(),
            low: vec![0.0; n],
            now: vec![0.0; n * row],
            next: vec![0.0; n * row],
            next_state: state.to_vec(),
            next_low: vec![0.0; n],
            sums: vec![0.0; n],
            slopes: vec![0.0; n],
            defects: vec![0.0; n],
            scale: vec![0.0; flow.group_count],
            top: vec![0.0; flow.group_count],
            factor: control.caution * pxfm::f_exp(-2.0 - 0.7 / (control.order as f64 - 1.0)),
            last_step: 0.0,
            kinks: Kinks::default(),
            narrow: Narrow::new(flow.polynomial, flow.dimension, |order| {
                let constants: Vec<Interval> = constants.iter().map(|&c| Interval::point(c)).collect();
                flow.slots(order, &constants)
            }),
            rounding: None,
            late: vec![0.0; n],
            trial: Trial {
                target: time,
                h: 0.0,
                size: 0.0,
                smallest: 0.0,
                remaining: 0.0,
                kink: None,
                behind: 0.0,
                why,
            },
        }
    }

    pub(super) fn finished(&self) -> bool {
        self.time == self.end
    }

    /// 1 forwards in time, −1 backwards.
    fn direction(&self) -> f64 {
        if self.end > self.time { 1.0 } else { -1.0 }
    }

    /// The shortest step: as closely as time can tell.
    fn smallest(&self) -> f64 {
        (4.0 * f64::EPSILON * self.time.abs()).max(1e-18 * self.length)
    }

    /// The constants of the field.
    pub(super) fn constants(&self) -> &[f64] {
        &self.constants
    }

    /// The order up to which series are wanted.
    pub(super) fn order(&self) -> usize {
        self.control.order
    }

    /// Where a series is wanted: time and state; with room for it, the coefficients of all states order by order.
    pub(super) fn asks(&mut self) -> (f64, &[f64], &mut [f64]) {
        (self.trial.target, &self.next_state, &mut self.next)
    }

    /// The last step that was made.
    pub(super) fn made(&self) -> Step<'_> {
        Step { coefficients: &self.next, low: &self.next_low, defects: &self.defects }
    }

    /// Chooses the next step, not beyond the end; `series` is that at the present time.
    ///
    /// # Errors
    /// Why there is none.
    pub(super) fn propose(&mut self, series: &impl Series) -> Result<(), Stop> {
        // Its size, its error and what errors become of it, beside the series.
        let order = self.control.order as u64;
        meter::charge(self.flow.tape.instructions().len() as u64 * order * order / 2 + OF_A_STEP);
        let direction = self.direction();
        let remaining = (self.end - self.time).abs();
        // What moves a state from outside may come as a pulse that no expansion before it sees: short steps, each of which
        // starts with a look at the time.
        let longest = if self.flow.driven { LONGEST_DRIVEN } else { LONGEST };
        let mut size = self.step_size().min(longest * self.length);
        // Never leave a last step that is a sliver.
        if size > 0.6 * remaining {
            size = if size >= remaining { remaining } else { 0.6 * remaining };
        }
        let smallest = self.smallest();
        let edges = &self.flow.edges;
        if edges.is_near_steep(series, 4.0 * smallest) {
            return Err(Stop::Undetermined);
        }
        // A step that meets a kink ends behind it, as closely as time can tell.
        let mut kink = self.kinks.first(edges, self.control.order, size, direction).filter(|&(at, _)| at < size);
        let end = self.kinks.end(edges, self.control.order, size, direction).filter(|end| end.at < size);
        let behind = smallest;
        let mut is_hole = false;
        // Short enough of it for rounding not to come out on the other side.
        let short_of = |at: f64| (at * BEFORE).min(at - 8.0 * smallest);
        if let Some(end) = end {
            let (before, behind) = (1.0 - SAME, 1.0 + SAME);
            match kink {
                // What is said of the time behind a kink is another function.
                Some((at, _)) if end.at > at * behind => {}
                Some((at, _)) if end.at >= at * before => is_hole = end.is_hole,
                // A step up to the end; then no more.
                _ if end.at <= 16.0 * smallest => return Err(Stop::NoRate(end.rate, NoValue::OutOfDomain)),
                _ => (kink, size) = (None, short_of(end.at)),
            }
        }
        if let Some((at, argument)) = kink
            && (is_hole || edges.jumps(argument))
        {
            // A step up to the jump; then no more.
            if at <= 16.0 * smallest {
                return Err(Stop::Undetermined);
            }
            (kink, size) = (None, short_of(at));
        }
        if let Some((at, _)) = kink {
            self.kinks.crossed += 1;
            if self.kinks.crossed > MOST_KINKS {
                return Err(Stop::Collapsed);
            }
            size = (at + behind).min(size);
        }
        let (target, h, why) = (self.time, 0.0, Stop::Collapsed);
        self.trial = Trial { target, h, size, smallest, remaining, kink, behind, why };
        self.aim()
    }

    /// The state at the end of the step that is tried.
    fn aim(&mut self) -> Result<(), Stop> {
        let Trial { size, smallest, remaining, kink, why, .. } = self.trial;
        if size <= smallest && size < remaining && kink.is_none() {
            return Err(why);
        }
        let direction = self.direction();
        let target = if size >= remaining { self.end } else { self.time + direction * size };
        let h = target - self.time;
        let n = self.flow.dimension;
        widely(Sums { orders: &self.now, h, sums: &mut self.sums, slopes: &mut self.slopes });
        for (i, &x) in self.now[..n].iter().enumerate() {
            let y = self.low[i] + h * self.sums[i];
            let s = x + y;
            let virtual_part = s - x;
            self.next_state[i] = s;
            self.next_low[i] = (x - (s - virtual_part)) + (y - virtual_part);
        }
        (self.trial.target, self.trial.h) = (target, h);
        Ok(())
    }

    /// Takes the series at the end of the step that is tried: whether the step is made. If not, another one is tried.
    ///
    /// # Errors
    /// Why there is no step.
    pub(super) fn judge(&mut self, series: &impl Series, grown: Result<(), (usize, NoValue)>) -> Result<bool, Stop> {
        let row = self.control.order + 1;
        let Trial { target, h, size, smallest, remaining, kink, .. } = self.trial;
        if let Some((at, argument)) = kink {
            let sign = |x: f64| if x > 0.0 { 1 } else { -i32::from(x < 0.0) };
            let now = sign(self.kinks.series[argument * row]);
            let then = || sign(series.coefficient(self.flow.edges.slots[argument], 0));
            if grown.is_err() || then() != -now && now != 0 {
                // Not behind it yet.
                self.trial.behind *= 4.0;
                let behind = self.trial.behind;
                if behind > 1e-9 * self.length || at + behind >= remaining {
                    (self.trial.kink, self.trial.size) = (None, if at > 0.0 { at } else { 0.5 * size });
                } else {
                    self.trial.size = at + behind;
                }
                return self.aim().map(|()| false);
            }
            if self.jumps_over((size - at).abs() + smallest)
                || self.flow.edges.is_near_steep(series, NEAR * self.length)
            {
                if at <= 16.0 * smallest {
                    return Err(Stop::Undetermined);
                }
                (self.trial.kink, self.trial.size) = (None, at * BEFORE);
                return self.aim().map(|()| false);
            }
        }
        match grown {
            Err((i, reason)) => self.trial.why = Stop::NoRate(i, reason),
            // Halved until nothing can hide between its ends.
            Ok(()) if kink.is_none() && self.hides((target, h)) => {}
            // Behind a kink the slope may be another one.
            Ok(()) if kink.is_some() || self.continues(target, h) => {
                if let Some((at, _)) = kink {
                    self.add_late((size - at).abs() + smallest);
                }
                self.kinks.keep(self.flow, series, self.control.order);
                std::mem::swap(&mut self.now, &mut self.next);
                std::mem::swap(&mut self.state, &mut self.next_state);
                std::mem::swap(&mut self.low, &mut self.next_low);
                self.time = target;
                self.last_step = size;
                return Ok(true);
            }
            Ok(()) => {}
        }
        self.trial.size *= 0.5;
        self.aim().map(|()| false)
    }

    /// The step that Jorba & Zou propose, infinite when the series ends.
    fn step_size(&mut self) -> f64 {
        let p = self.control.order;
        let n = self.flow.dimension;
        let factor = self.factor;
        let mut guess = if self.last_step > 0.0 { self.last_step } else { self.length };
        // The scale of a state near 0 is what it becomes within the step, so the guess is improved once or twice.
        for _ in 0..if self.last_step > 0.0 { 1 } else { 3 } {
            self.flow.reach(&self.now, guess, &mut self.scale);
            let mut radius = f64::INFINITY;
            let mut seen = 0;
            for k in (p / 2..=p).rev() {
                self.top.fill(0.0);
                let row = &self.now[k * n..(k + 1) * n];
                for (group, states) in &self.flow.stretches {
                    let row = &row[states.clone()];
                    self.top[*group] = larger(self.top[*group], largest(row.len(), |i| row[i].abs()));
                }
                let mut any = false;
                for (&top, &scale) in self.top.iter().zip(&self.scale) {
                    if top > 1e-280 && scale > 1e-280 {
                        any = true;
                        radius = radius.min((log2_rough(scale) - log2_rough(top)) / k as f64);
                    }
                }
                seen += usize::from(any);
                if seen >= 2 || (any && k + 1 < p) {
                    break;
                }
            }
            if radius.is_infinite() {
                return f64::INFINITY;
            }
            guess = factor * exp2_rough(radius);
        }
        guess
    }
}

/// The larger of two numbers, the first of which is no NaN; a NaN is not larger than anything.
#[inline(always)]
fn larger(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}

/// The largest of some sizes; 0 for none. Several are compared side by side.
#[inline(always)]
fn largest(count: usize, size: impl Fn(usize) -> f64) -> f64 {
    let mut most = [0.0; ABREAST];
    let whole = count / ABREAST * ABREAST;
    for from in (0..whole).step_by(ABREAST) {
        for (i, most) in most.iter_mut().enumerate() {
            *most = larger(*most, size(from + i));
        }
    }
    let rest = (whole..count).fold(0.0, |most, i| larger(most, size(i)));
    most.into_iter().fold(rest, larger)
}

/// Base-2 logarithm of a positive normal number, to 0.09: enough for a 20th root, and the same bits everywhere.
fn log2_rough(x: f64) -> f64 {
    (x.to_bits() as f64) / (1_u64 << 52) as f64 - 1023.0
}

/// Inverse of [`log2_rough`].
fn exp2_rough(x: f64) -> f64 {
    let clamped = x.clamp(-1000.0, 1000.0);
    f64::from_bits(((clamped + 1023.0) * (1_u64 << 52) as f64) as u64)
}
