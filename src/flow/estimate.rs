//! How far a trajectory may be from the truth, from neighbours of it that go the same steps.
//!
//! **In:** a field whose right sides are polynomials, and a finished branch of a trajectory. **Out:** an estimate of the error of
//! every state up to the end of every step; nothing where this way does not lead to one.
//!
//! **Why it may be done so.** What is integrated differs from the truth for three reasons: the start and the constants are known
//! within bounds only; each step leaves out the end of a series; and each is rounded. To first order the difference e obeys the
//! equation of a neighbour: from step to step it is carried along by the derivative of the flow, and each step adds its own. So
//! [`LANES`] differences are carried along, by the flow itself: a neighbour starts at the state plus a multiple of the difference
//! that is small against the state and large against its rounding, and goes one step by a short series. Relative to the difference,
//! the ends of the series of neighbours h·0.135ᵏ/k!, at most, do not matter. What a step adds is a bound where one is cheap:
//!
//! * rounding: the error bounds of the rates at the start of the step, from arithmetic with error bounds, for states with the low
//!   part that a series leaves out, times the length of the step; and the rounding of the sum over the series;
//! * the end of the series: its last term, and how far the slope of the polynomial is from the rate at the end of the step, times
//!   its length. That is where the polynomial is worst: its defect grows with the power of time that the order is.
//!
//! Each of the differences adds these with another pattern of signs: all alike, as errors do that have a cause in common; by the
//! number of the state; and two that change from step to step. The error of start and constants is treated likewise, by corners of
//! their box. The largest difference so far, times a safety factor, is the error: errors of one size and other signs would have
//! to conspire to be larger in every one of them.
//!
//! **Where not:** where a neighbour would have to be farther off than the flow is linear, where a rate has no error bound, where right
//! sides have kinks, depend on the time from outside, or are no polynomials, so that a step may miss what is between its ends:
//! there the motion is integrated again, see the module `trajectory`.

use super::taylor::Flow;
use super::trajectory::{Branch, ORDER, Plan};
use expr::tape::Slots;
use number::{Bounded, BoundedLanes, Growth, Lanes, Work, widely};

/// How the errors of a motion are estimated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Estimation {
    /// By further integrations beside it.
    Companions,
    /// From the steps of the motion itself where its right sides let that be done, by companions where they do not: bounds are
    /// wider, and the work is less.
    Steps,
}

/// Differences that are carried along beside each other.
const LANES: usize = 4;
/// Branches of which the differences are carried along beside each other: one step of the recurrences costs little more for all.
const BRANCHES: usize = 4;
const TOGETHER: usize = BRANCHES * LANES;
/// Order of the series of neighbours.
const SHORT: usize = 6;
/// What the largest of the differences is multiplied with.
const SAFETY: f64 = 8.0;
/// What a step adds by rounding, as a part of its bound: on average it is a quarter, of each operation, and never all of it at once.
const TYPICAL: f64 = 0.5;
/// A neighbour is as far off as this share of the size of a state; as soon as it is nearer or farther than the limits, the
/// multiple of the difference is chosen anew.
const AWAY: i32 = -27;
const NEAREST: f64 = 1.0 / (1_u64 << 36) as f64;
const FARTHEST: f64 = 1.0 / (1_u64 << 20) as f64;
/// Steps of which the rounding is found together.
const BLOCK: usize = 8;

/// The sign with which the error of a state is added on a step, in one of the differences.
fn sign(lane: usize, state: usize, step: usize) -> f64 {
    let negative = match lane {
        0 => false,
        1 => !(state * state + state / 2).is_multiple_of(3),
        // Without a short period.
        _ => (mixed((step * 64 + state * 2 + lane) as u64) & 1) == 1,
    };
    if negative { -1.0 } else { 1.0 }
}

/// The bits of a number, mixed (the finalizer of MurmurHash3).
fn mixed(mut x: u64) -> u64 {
    x = (x ^ (x >> 33)).wrapping_mul(0xff51_afd7_ed55_8ccd);
    x = (x ^ (x >> 33)).wrapping_mul(0xc4ce_b9fe_1a85_ec53);
    x ^ (x >> 33)
}

/// The memory of estimates for one field.
pub(super) struct Estimate<'a> {
    flow: &'a Flow,
    growth: Growth<TOGETHER>,
    bounded: Slots<BoundedLanes<BLOCK>>,
    /// The sizes of the states of each kind on the step that is looked at.
    scale: Vec<f64>,
    /// The signs with which the error of each state is added on that step.
    signs: Vec<Lanes<LANES>>,
}

/// A branch on its way: the differences carried along it, so far.
struct Carried<'b> {
    plan: &'b Plan,
    branch: &'b Branch,
    rounding: Vec<f64>,
    differences: Vec<Lanes<LANES>>,
    constants: Vec<Lanes<LANES>>,
    largest: Vec<f64>,
    /// How large each of the differences is now.
    sizes: Vec<f64>,
    /// What differences are multiplied with, and how often that was chosen.
    multiple: f64,
    multiples: usize,
    /// The errors; nothing where this way does not lead to them.
    found: Option<Vec<f64>>,
}

impl<'a> Estimate<'a> {
    /// Memory for a field; nothing where its right sides are not of the kind for which this is done.
    pub(super) fn new(flow: &'a Flow) -> Option<Estimate<'a>> {
        let growth = Growth::new(&flow.recurrences, SHORT);
        let (scale, signs) = (Vec::new(), Vec::new());
        flow.is_plain().then(|| Estimate { flow, growth, bounded: flow.tape.slots(&()), scale, signs })
    }

    /// The error of every state up to the end of every step, not yet growing, of several branches. Each is what it is alone, bit for
    /// bit: what does not fit side by side comes after it.
    pub(super) fn of(&mut self, branches: &[(&Plan, &Branch)]) -> Vec<Option<Vec<f64>>> {
        let mut out = Vec::with_capacity(branches.len());
        for some in branches.chunks(BRANCHES) {
            let mut carried: Vec<Carried> = some.iter().map(|of| self.begin(*of)).collect();
            let steps = some.iter().map(|(_, branch)| branch.times.len() - 1).max().unwrap_or(0);
            for step in 0..steps {
                let goes_on = |of: &Carried| of.found.is_some() && step + 1 < of.branch.times.len();
                for (seat, of) in carried.iter_mut().enumerate().filter(|(_, of)| goes_on(of)) {
                    self.depart(seat, of, step);
                }
                self.growth.grow(&self.flow.recurrences, SHORT);
                self.signs.clear();
                let signs = |i: usize| Lanes(std::array::from_fn(|lane| sign(lane, i, step)));
                self.signs.extend((0..self.flow.dimension).map(signs));
                for (seat, of) in carried.iter_mut().enumerate().filter(|(_, of)| goes_on(of)) {
                    self.arrive(seat, of, step);
                }
            }
            out.extend(carried.into_iter().map(|of| of.found));
        }
        out
    }

    /// The differences at the start of a branch.
    fn begin<'b>(&mut self, (plan, branch): (&'b Plan, &'b Branch)) -> Carried<'b> {
        let each = |bounds: &[Bounded]| -> Vec<Lanes<LANES>> {
            let of = |(i, x): (usize, &Bounded)| Lanes(std::array::from_fn(|lane| sign(lane, i, 0) * x.error));
            bounds.iter().enumerate().map(of).collect()
        };
        let (differences, constants) = (each(&plan.state), each(&plan.constants));
        let largest: Vec<f64> = differences.iter().map(size).collect();
        let sizes = largest.clone();
        let rounding = self.rounding(plan, branch);
        let found = rounding.is_some().then(|| Vec::with_capacity((branch.times.len() - 1) * self.flow.dimension));
        let rounding = rounding.unwrap_or_default();
        let (multiple, multiples) = (0.0, 0);
        Carried { plan, branch, rounding, differences, constants, largest, sizes, multiple, multiples, found }
    }

    /// Lets the neighbours of a branch start a step.
    fn depart(&mut self, seat: usize, of: &mut Carried, step: usize) {
        let (flow, n) = (self.flow, self.flow.dimension);
        let Carried { plan, branch, .. } = *of;
        let h = branch.times[step + 1] - branch.times[step];
        let series = branch.series(n, step);
        flow.reach(series, h, &mut self.scale);
        let farthest = farthest(&of.sizes, flow.kinds(), &self.scale).max(farthest_constant(plan));
        if farthest * of.multiple > FARTHEST || farthest * of.multiple < NEAREST || of.multiple == 0.0 {
            of.multiple = power_of_two(AWAY) / power_of_two(exponent(farthest.max(f64::EPSILON * f64::EPSILON)));
            // An error that is not small is none of a linear equation.
            if of.multiple.is_nan() || of.multiple < 4.0 {
                of.found = None;
                return;
            }
            self.enter(seat, of);
            of.multiples += 1;
        }
        let first = seat * LANES;
        let by = Lanes::splat(of.multiple);
        self.growth.start_mut(0).0[first..first + LANES].fill(branch.times[step]);
        for (i, (&x, &difference)) in series[..n].iter().zip(&of.differences).enumerate() {
            let start = Lanes::<LANES>::splat(x) + difference * by;
            self.growth.start_mut(1 + i).0[first..first + LANES].copy_from_slice(&start.0);
        }
    }

    /// Sets the constants of the neighbours of a branch. Those that are known exactly are set once.
    fn enter(&mut self, seat: usize, of: &Carried) {
        let exact = of.plan.constants.iter().all(|c| c.error == 0.0);
        if exact && of.multiples > 0 {
            return;
        }
        for lane in 0..LANES {
            let shifted = |(c, by): (&Bounded, &Lanes<LANES>)| c.value + of.multiple * by.0[lane];
            let values: Vec<f64> = of.plan.constants.iter().zip(&of.constants).map(shifted).collect();
            let lanes =
                if exact { seat * LANES..(seat + 1) * LANES } else { seat * LANES + lane..seat * LANES + lane + 1 };
            self.flow.enter(&mut self.growth, lanes, &values);
            if exact {
                break;
            }
        }
    }

    /// What the differences are at the end of a step.
    fn arrive(&mut self, seat: usize, of: &mut Carried, step: usize) {
        let n = self.flow.dimension;
        let Carried { branch, ref rounding, ref mut differences, multiple, ref mut found, .. } = *of;
        let (Some(out), sizes, largest) = (found.as_mut(), &mut of.sizes, &mut of.largest) else { return };
        let h = branch.times[step + 1] - branch.times[step];
        let series = branch.series(n, step);
        let (rounding, defects) = (&rounding[step * n..(step + 1) * n], &branch.defects[step * n..(step + 1) * n]);
        let (growth, signs) = (&self.growth, &self.signs);
        let by = 1.0 / multiple;
        widely(Arrival { growth, seat, series, h, by, signs, rounding, defects, differences, sizes: &mut *sizes });
        for (largest, &now) in largest.iter_mut().zip(&*sizes) {
            *largest = largest.max(now);
            out.push(SAFETY * *largest);
        }
        if !sizes.iter().all(|now| now.is_finite()) {
            *found = None;
        }
    }

    /// Bounds of the rounding of the rates at the start of every step.
    fn rounding(&mut self, plan: &Plan, branch: &Branch) -> Option<Vec<f64>> {
        let Estimate { flow, ref mut bounded, .. } = *self;
        let n = flow.dimension;
        let steps = branch.times.len() - 1;
        let mut out = vec![0.0; steps * n];
        for (i, c) in plan.constants.iter().enumerate() {
            bounded.set(1 + n + i, Ok(BoundedLanes::splat(Bounded::exact(c.value))));
        }
        for first in (0..steps).step_by(BLOCK) {
            // What is left of the last block is its last step again.
            let step = |lane: usize| (first + lane).min(steps - 1);
            let times = std::array::from_fn(|lane| Bounded::exact(branch.times[step(lane)]));
            bounded.set(0, Ok(BoundedLanes::of(times)));
            for i in 0..n {
                let state = std::array::from_fn(|lane| {
                    let value = branch.coefficients[step(lane) * n * (ORDER + 1) + i];
                    Bounded::new(value, branch.low[step(lane) * n + i].abs())
                });
                bounded.set(1 + i, Ok(BoundedLanes::of(state)));
            }
            flow.tape.run(&(), bounded);
            for i in 0..n {
                let rate = flow.tape.output(i, bounded).ok()?;
                for lane in 0..BLOCK {
                    out[step(lane) * n + i] = rate.lane(lane).error;
                }
            }
        }
        Some(out)
    }
}

/// The end of a step of a branch.
struct Arrival<'s> {
    /// The series of the neighbours, those of the branch in the lanes of its seat.
    growth: &'s Growth<TOGETHER>,
    seat: usize,
    /// Those of the branch, its step, and 1 / the multiple of the differences that its neighbours were off.
    series: &'s [f64],
    h: f64,
    by: f64,
    /// Of every state.
    signs: &'s [Lanes<LANES>],
    rounding: &'s [f64],
    defects: &'s [f64],
    /// What the differences are here, and how large the largest of each state is.
    differences: &'s mut [Lanes<LANES>],
    sizes: &'s mut [f64],
}

impl Work for Arrival<'_> {
    type Output = ();
    #[inline(always)]
    fn work(self) {
        let Arrival { growth, seat, series, h, by, signs, rounding, defects, differences, sizes } = self;
        let n = signs.len();
        let power = (0..ORDER).fold(1.0, |power, _| power * h);
        // Of each order the coefficients of all states; slices of one length need no look at it again.
        let mut rows = [&series[..n]; SHORT + 1];
        for (k, row) in rows.iter_mut().enumerate() {
            *row = &series[k * n..][..n];
        }
        let (last, rounding, defects) = (&series[ORDER * n..][..n], &rounding[..n], &defects[..n]);
        let (differences, sizes) = (&mut differences[..n], &mut sizes[..n]);
        for i in 0..n {
            let Some(neighbour) = growth.coefficients(1 + i).first_chunk::<{ SHORT + 1 }>() else { return };
            let mut moved = Lanes::<LANES>::splat(0.0);
            for k in (1..=SHORT).rev() {
                let of_seat = Lanes(neighbour[k].0.as_chunks().0[seat]);
                moved = (moved + of_seat - Lanes::splat(rows[k][i])) * Lanes::splat(h);
            }
            let last = (last[i] * power).abs();
            let sum = (4.0 * f64::EPSILON * rows[1][i]).abs();
            let own = TYPICAL * h.abs() * (rounding[i] + defects[i] + sum) + last;
            differences[i] = differences[i] + moved * Lanes::splat(by) + signs[i] * Lanes::splat(own);
            sizes[i] = size(&differences[i]);
        }
    }
}

/// The largest of the lanes by its size; NaN where one of them is not finite.
#[inline(always)]
fn size(x: &Lanes<LANES>) -> f64 {
    let larger = |a: f64, b: f64| if b > a { b } else { a };
    let [a, b, c, d] = x.0.map(f64::abs);
    // 0·x is NaN where x is not finite; a comparison would lose it.
    let [p, q, r, s] = (*x * Lanes::splat(0.0)).0;
    larger(larger(a, b), larger(c, d)) + ((p + q) + (r + s))
}

/// The largest difference relative to the size of its state.
fn farthest(sizes: &[f64], kinds: &[usize], scale: &[f64]) -> f64 {
    let each = sizes.iter().zip(kinds).filter(|(d, _)| **d > 0.0);
    each.fold(0.0, |most: f64, (d, &kind)| most.max(d / scale[kind]))
}

/// The largest error of a constant relative to it.
fn farthest_constant(plan: &Plan) -> f64 {
    let uncertain = plan.constants.iter().filter(|c| c.error > 0.0);
    uncertain.fold(0.0, |most: f64, c| most.max(c.error / c.value.abs()))
}

/// The exponent of a positive normal number.
fn exponent(x: f64) -> i32 {
    ((x.to_bits() >> 52) & 0x7ff) as i32 - 1023
}

/// 2ⁿ for the exponent of a normal number.
fn power_of_two(n: i32) -> f64 {
    f64::from_bits(((n.clamp(-1022, 1023) + 1023) as u64) << 52)
}

#[cfg(test)]
mod tests;
