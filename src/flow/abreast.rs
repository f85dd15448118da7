//! Integrations of one field side by side.
//!
//! **In:** walkers of one field, each with its own constants, order, state, span and steps. **Out:** the same steps that each makes
//! alone. **Guaranteed:** bit for bit so, however many there are and whichever are side by side: the series of a lane are grown by
//! the same operations in the same order as those of one motion (see [`Growth`]), each walker chooses its steps from its own series,
//! and a lane without a value is grown again alone, which says why. Nothing can depend on the grouping.
//!
//! **Why:** to read an instruction of the tape costs as much as a short sum of products; so it is read once for all lanes, whose
//! sums fill the registers. The integrations from which the error of a motion is estimated are lanes beside it. A walker that has
//! arrived makes room for the next.

use super::kinks::{Lane, Series};
use super::taylor::{Flow, Stop, Walker};
use expr::tape::Slots;
use number::{Growth, Jet, NoValue, Orders, Work, widely};

/// Whether to stop, although there is more to do: asked between steps.
pub type Halt<'h> = &'h (dyn Fn() -> bool + Sync);

/// What happens to a walker.
pub(super) enum Event {
    /// It has the series at its initial time.
    Started,
    /// It made a step.
    Stepped,
    /// It cannot go on.
    Stopped(Stop),
}

/// An integration with its record.
pub(super) trait Runner<'a> {
    /// What integrates.
    fn walker(&mut self) -> &mut Walker<'a>;
    /// Takes note of what happened; whether to go on.
    fn note(&mut self, event: Event) -> bool;
}

/// Lets all of them run until none goes on; `false` if they were stopped before.
pub(super) fn run<'a, R: Runner<'a>>(flow: &'a Flow, runners: &mut [R], halt: Halt) -> bool {
    match runners.len() {
        0 => true,
        1 => run_in::<1, R>(flow, runners, halt),
        2..=4 => run_in::<4, R>(flow, runners, halt),
        _ => run_in::<8, R>(flow, runners, halt),
    }
}

/// So many steps are made between two looks at whether to stop.
const PATIENCE: usize = 64;

/// In so many lanes.
fn run_in<'a, const N: usize, R: Runner<'a>>(flow: &'a Flow, runners: &mut [R], halt: Halt) -> bool {
    let order = runners.iter_mut().map(|r| r.walker().order()).max().unwrap_or(0);
    let mut together = Together::<N>::new(flow, order);
    // The runner in each lane.
    let mut seats: [Option<usize>; N] = [None; N];
    let mut waiting = 0..runners.len();
    let mut grown = 0_usize;
    let mut stopped = || {
        grown += 1;
        grown.is_multiple_of(PATIENCE) && halt()
    };
    loop {
        if stopped() {
            return false;
        }
        for (lane, seat) in seats.iter_mut().enumerate().filter(|(_, seat)| seat.is_none()) {
            if let Some(runner) = waiting.next() {
                together.enter(lane, runners[runner].walker());
                *seat = Some(runner);
            }
        }
        match seats.iter().flatten().count() {
            0 => return true,
            // The last one need not pay for the lanes that are empty.
            1 if N > 1 => {
                for runner in seats.iter_mut().filter_map(Option::take) {
                    let mut alone = Together::<1>::new(flow, runners[runner].walker().order());
                    alone.enter(0, runners[runner].walker());
                    loop {
                        alone.grow(&[Some(runner)], runners);
                        if !alone.told(0, &mut runners[runner]) {
                            break;
                        }
                        if stopped() {
                            return false;
                        }
                    }
                }
            }
            _ => {
                together.grow(&seats, runners);
                for (lane, seat) in seats.iter_mut().enumerate() {
                    *seat = seat.filter(|&runner| together.told(lane, &mut runners[runner]));
                }
            }
        }
    }
}

/// Tells a runner the series that its walker asked for; whether it goes on.
fn tell<'a, R: Runner<'a>>(runner: &mut R, series: &impl Series, grown: Result<(), (usize, NoValue)>) -> bool {
    let walker = runner.walker();
    let event = if walker.has_begun() {
        match walker.judge(series, grown) {
            // Another try.
            Ok(false) => return true,
            Ok(true) => Event::Stepped,
            Err(stop) => Event::Stopped(stop),
        }
    } else {
        match walker.begin(series, grown) {
            Ok(false) => return true,
            Ok(true) => Event::Started,
            Err(stop) => Event::Stopped(stop),
        }
    };
    let stopped = matches!(event, Event::Stopped(_));
    if !runner.note(event) || stopped {
        return false;
    }
    match runner.walker().propose(series) {
        Ok(()) => true,
        Err(stop) => {
            runner.note(Event::Stopped(stop));
            false
        }
    }
}

/// The series of several motions, each in a lane.
struct Together<'a, const N: usize> {
    flow: &'a Flow,
    order: usize,
    growth: Growth<N>,
    /// Memory for a motion whose series have no values, once there is one.
    jets: Option<Slots<Jet<f64>>>,
}

impl<'a, const N: usize> Together<'a, N> {
    fn new(flow: &'a Flow, order: usize) -> Together<'a, N> {
        Together { flow, order, growth: Growth::new(&flow.recurrences, order), jets: None }
    }

    /// Gives a lane to a walker.
    fn enter(&mut self, lane: usize, walker: &Walker) {
        self.flow.enter(&mut self.growth, lane..lane + 1, walker.constants());
    }

    /// Grows what all walkers ask for.
    fn grow<'w, R: Runner<'w>>(&mut self, seats: &[Option<usize>; N], runners: &mut [R]) {
        for (lane, seat) in seats.iter().enumerate() {
            let Some(runner) = *seat else { continue };
            let (time, state, _) = runners[runner].walker().asks();
            self.growth.start_mut(0).0[lane] = time;
            state.iter().enumerate().for_each(|(i, &x)| self.growth.start_mut(1 + i).0[lane] = x);
        }
        self.growth.grow(&self.flow.recurrences, self.order);
    }

    /// Tells the runner in a lane its series; whether it goes on.
    fn told<'w, R: Runner<'w>>(&mut self, lane: usize, runner: &mut R) -> bool {
        if self.hand_over(lane, runner.walker()) {
            return tell(runner, &Lane { growth: &self.growth, lane }, Ok(()));
        }
        // Why there is no value is known of the series of one motion; it may also be that there is one after all.
        let Together { flow, order, ref mut jets, .. } = *self;
        let slots = jets.get_or_insert_with(|| flow.slots(order, &[]));
        let grown = by_jets(flow, slots, runner.walker());
        tell(runner, slots, grown)
    }

    /// Gives a walker its series; `false` if some coefficient has no value.
    fn hand_over(&self, lane: usize, walker: &mut Walker) -> bool {
        let (n, (_, _, room)) = (self.flow.dimension, walker.asks());
        for i in 0..n {
            let of_state = room[i..].iter_mut().step_by(n).zip(self.growth.coefficients(1 + i));
            of_state.for_each(|(to, from)| *to = from.0[lane]);
        }
        // What has no value is NaN.
        widely(HaveValues(&*room))
    }
}

/// Whether none of some numbers is NaN.
struct HaveValues<'n>(&'n [f64]);

impl Work for HaveValues<'_> {
    type Output = bool;
    #[inline(always)]
    fn work(self) -> bool {
        !self.0.iter().fold(false, |missing, x| missing | x.is_nan())
    }
}

/// Grows what a walker asks for as the series of one motion.
fn by_jets(flow: &Flow, slots: &mut Slots<Jet<f64>>, walker: &mut Walker) -> Result<(), (usize, NoValue)> {
    let (n, order) = (flow.dimension, walker.order());
    let orders = Orders::all(order);
    for (i, &c) in walker.constants().iter().enumerate() {
        *slots.value_mut(1 + n + i) = Jet::constant(c, &orders);
    }
    let (time, state, room) = walker.asks();
    let mut rows = vec![0.0; n * (order + 1)];
    let grown = flow.expand(slots, order, time, state, &mut rows);
    for (i, row) in rows.chunks_exact(order + 1).enumerate() {
        row.iter().enumerate().for_each(|(k, &c)| room[k * n + i] = c);
    }
    grown
}
