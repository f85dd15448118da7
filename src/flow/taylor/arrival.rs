//! Whether a step that was tried is made: what its end tells of the times in between.
//!
//! **In:** a step, the series at its start, and the rates at its end. **Out:** whether a rate jumps, hides something, or arrives with
//! another slope than the polynomial has. What the rounding of states and rates explains counts as nothing.

use super::super::narrow::FINE;
use super::Walker;
use number::Bounded;

/// A rate that changes by more than this share of itself at a kink jumps there.
const JUMP: f64 = 1e-6;
/// A rate that grows from a kink on is as far from what it is there as twice its coefficient of the next order tells, times some room
/// for where the kink is.
const GROWTH: f64 = 8.0;
/// Slopes that differ by so many rounding errors of a rate are one.
const ROUNDING: f64 = 4.0;
/// Units of work that it takes to find these.
const OF_A_ROUNDING: u64 = 500;

impl Walker<'_> {
    /// Whether a rate is another one, at a time behind a kink, than before it, and not only on its way from what it is at the kink.
    pub(super) fn jumps_over(&self, late: f64) -> bool {
        let n = self.flow.dimension;
        (0..n).any(|i| {
            let before = self.slopes[i];
            let behind = self.next[n + i];
            // A rate that vanishes at the kink is compared with what moves the state as far as its size.
            let usual = self.scale[self.flow.groups[i]].max(self.next_state[i].abs()) / self.length;
            let moved = GROWTH * self.next[2 * n + i].abs() * late;
            (before - behind).abs()
                > moved + JUMP * before.abs().max(behind.abs()).max(self.now[n + i].abs()).max(usual)
        })
    }

    /// Whether a rate may do within a step what its ends do not show.
    pub(super) fn hides(&mut self, (target, h): (f64, f64)) -> bool {
        let Some(mut narrow) = self.narrow.take() else { return false };
        // The step ends at the kink.
        let mut resolved = self.kinks.are_near(&self.flow.edges, self.control.order, h);
        if !resolved {
            let mut resolves = |of: &Self, rounding: Option<&[f64]>| {
                let scale = |i: usize| {
                    let rests = rounding.map_or(0.0, |rounding| ROUNDING * rounding[i] * h.abs() / FINE);
                    of.scale[of.flow.groups[i]].max(of.next_state[i].abs()) + rests
                };
                narrow.resolves(&of.flow.tape, (of.time, h), &of.now, scale)
            };
            // A state that rests moves by the rounding of its rate alone, which no step is short enough to resolve.
            resolved = resolves(self, None) || {
                let rounding = self.rounding(target);
                resolves(self, Some(&rounding))
            };
        }
        self.narrow = Some(narrow);
        !resolved
    }

    /// The step went on for a time behind a kink, at the rates before it.
    pub(super) fn add_late(&mut self, behind: f64) {
        let n = self.flow.dimension;
        for (i, late) in self.late.iter_mut().enumerate() {
            *late += (self.slopes[i] - self.next[n + i]).abs() * behind;
        }
    }

    /// Whether the polynomial of this step arrives with the slope that the field has there: a guard against series whose
    /// last terms are small by accident. What the rounding of the states and of the rates explains is no difference: a state
    /// that rests moves by that alone, and no step is short enough to follow it.
    pub(super) fn continues(&mut self, target: f64, h: f64) -> bool {
        for (defect, (slope, found)) in
            self.defects.iter_mut().zip(self.slopes.iter().zip(&self.next[self.flow.dimension..]))
        {
            *defect = (slope - found).abs();
        }
        let mut rounding: Option<Vec<f64>> = None;
        (0..self.flow.dimension).all(|i| {
            let found = self.next[self.flow.dimension + i];
            let scale = self.scale[self.flow.groups[i]].max(self.next_state[i].abs());
            let off = self.defects[i];
            off * h.abs() <= 1e-11 * scale + 1e-12 * found.abs() * h.abs() + f64::MIN_POSITIVE
                || off <= ROUNDING * rounding.get_or_insert_with(|| self.rounding(target))[i]
        })
    }

    /// How far the rates at the next state may be off by its rounding and their own; 0 where it is not known.
    fn rounding(&mut self, time: f64) -> Vec<f64> {
        let n = self.flow.dimension;
        meter::charge(OF_A_ROUNDING);
        // Where states nearly cancel, as masses between springs at rest do, their rounding is all that a rate shows.
        let rounded = |&x: &f64| Bounded { value: x, error: 0.5 * f64::EPSILON * x.abs() };
        let state: Vec<Bounded> = self.next_state.iter().map(rounded).collect();
        let mut rates = vec![Bounded::exact(0.0); 2 * n];
        let (flow, constants) = (self.flow, &self.constants);
        // A stiff motion asks at every step.
        let slots = self.rounding.get_or_insert_with(|| {
            let constants: Vec<Bounded> = constants.iter().map(|&c| Bounded::exact(c)).collect();
            flow.slots(1, &constants)
        });
        match flow.expand(slots, 1, Bounded::exact(time), &state, &mut rates) {
            Ok(()) => rates.chunks(2).map(|c| c[1].error).collect(),
            Err(_) => vec![0.0; n],
        }
    }
}
