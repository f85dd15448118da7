//! How an integration begins.
//!
//! **In:** the series at the initial time, or why there is none. **Out:** whether the motion begins. At a kink there are rates and no
//! series: the motion begins behind it.

use super::super::kinks::Series;
use super::{Stop, Walker};
use number::NoValue;

impl Walker<'_> {
    /// Whether it has the series at its initial time.
    pub(crate) fn has_begun(&self) -> bool {
        self.begun
    }

    /// Takes the series at the initial time: whether the motion begins. If not, another series is asked for.
    ///
    /// # Errors
    /// Why no motion begins here.
    pub(crate) fn begin(&mut self, series: &impl Series, grown: Result<(), (usize, NoValue)>) -> Result<bool, Stop> {
        if let Err((i, reason)) = grown {
            return if self.leaves_a_kink() { Ok(false) } else { Err(Stop::NoRate(i, reason)) };
        }
        let moment = (self.trial.target - self.time).abs();
        if moment > 0.0 && self.jumps_over(moment) {
            return Err(Stop::Undetermined);
        }
        self.begun = true;
        std::mem::swap(&mut self.now, &mut self.next);
        // What is given at the start is what it is there.
        self.now[..self.flow.dimension].copy_from_slice(&self.state);
        self.kinks.keep(self.flow, series, self.control.order);
        if self.flow.edges.is_met(series) { Err(Stop::Undetermined) } else { Ok(true) }
    }

    /// At a kink a motion has rates, but no series. It begins behind it, as closely as time can tell, with the rates that it has there;
    /// `false` where it has none, or was moved already.
    fn leaves_a_kink(&mut self) -> bool {
        if self.flow.edges.slots.is_empty() || self.trial.target != self.time {
            return false;
        }
        let n = self.flow.dimension;
        let mut rates = vec![0.0; 2 * n];
        let mut slots = self.flow.slots(1, &self.constants);
        if self.flow.expand(&mut slots, 1, self.time, &self.state, &mut rates).is_err() {
            return false;
        }
        let (direction, moment) = (self.direction(), self.smallest());
        self.trial.target = self.time + direction * moment;
        for (i, rate) in rates.chunks(2).map(|c| c[1]).enumerate() {
            self.next_state[i] = self.state[i] + direction * moment * rate;
            self.late[i] += moment * rate.abs();
            self.slopes[i] = rate;
        }
        true
    }
}
