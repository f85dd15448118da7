//! Integrations of one field side by side.
//!
//! **In:** walkers of one field, each with its own constants, order, state, span and steps. **Out:** the same steps that each makes
//! alone. **Guaranteed:** bit for bit so, however many there are and whichever are side by side: the series of a lane are grown by
//! the same operations in the same order as those of one motion (see `Lanes`), each walker chooses its steps from its own series,
//! and a lane without a value is grown again alone, which says why. Nothing can depend on the grouping.
//!
//! **Why:** to read an instruction of the tape costs as much as a short sum of products; so it is read once for all lanes, whose
//! sums fill the registers. The integrations from which the error of a motion is estimated are lanes beside it. A walker that has
//! arrived makes room for the next.

use super::kinks::{Lane, Series};
use super::taylor::{Flow, Stop, Walker};
use expr::tape::Slots;
use number::{Jet, Lanes, NoValue, Orders, Scalar};

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

/// A runner in a lane, and whether it has its first series.
#[derive(Clone, Copy)]
struct Seat {
    runner: usize,
    started: bool,
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
    let mut alone = Alone { flow, order, slots: None };
    let mut seats: [Option<Seat>; N] = [None; N];
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
                *seat = Some(Seat { runner, started: false });
            }
        }
        match seats.iter().flatten().count() {
            0 => return true,
            // The last one need not pay for the lanes that are empty.
            1 => {
                for seat in &mut seats {
                    let Some(Seat { runner, mut started }) = seat.take() else { continue };
                    let runner = &mut runners[runner];
                    while alone.advance(runner, started) {
                        started = true;
                        if stopped() {
                            return false;
                        }
                    }
                }
            }
            _ => {
                let grown = together.grow(&seats, runners);
                for (lane, seat) in seats.iter_mut().enumerate() {
                    let Some(Seat { runner, started }) = *seat else { continue };
                    let runner = &mut runners[runner];
                    let goes_on = match grown && together.hand_over(lane, runner.walker()) {
                        true => tell(runner, &Lane { slots: &together.slots, lane }, Ok(()), started),
                        // Why there is no value is known for one motion alone.
                        false => alone.advance(runner, started),
                    };
                    *seat = goes_on.then_some(Seat { started: true, ..seat.unwrap_or(Seat { runner: 0, started }) });
                }
            }
        }
    }
}

/// Tells a runner the series that its walker asked for; whether it goes on.
fn tell<'a, R: Runner<'a>>(
    runner: &mut R,
    series: &impl Series,
    grown: Result<(), (usize, NoValue)>,
    started: bool,
) -> bool {
    let walker = runner.walker();
    let event = if started {
        match walker.judge(series, grown) {
            // Another try.
            Ok(false) => return true,
            Ok(true) => Event::Stepped,
            Err(stop) => Event::Stopped(stop),
        }
    } else {
        walker.begin(series, grown).map_or_else(Event::Stopped, |()| Event::Started)
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

/// The series of one motion.
struct Alone<'a> {
    flow: &'a Flow,
    order: usize,
    slots: Option<Slots<Jet<f64>>>,
}

impl Alone<'_> {
    /// Grows what a walker asks for, and tells; whether it goes on.
    fn advance<'a, R: Runner<'a>>(&mut self, runner: &mut R, started: bool) -> bool {
        let Alone { flow, order, slots } = self;
        let walker = runner.walker();
        let slots = slots.get_or_insert_with(|| flow.slots(*order, &[]));
        let orders = Orders::all(*order);
        for (i, &c) in walker.constants().iter().enumerate() {
            *slots.value_mut(1 + flow.dimension + i) = Jet::constant(c, &orders);
        }
        let wanted = walker.order();
        let (time, state, room) = walker.asks();
        let grown = flow.expand(slots, wanted, time, state, room);
        room.iter_mut().for_each(|c| *c = positive_zero(*c));
        tell(runner, slots, grown, started)
    }
}

/// The series of several motions.
struct Together<'a, const N: usize> {
    flow: &'a Flow,
    order: usize,
    slots: Slots<Jet<Lanes<N>>>,
    time: Lanes<N>,
    state: Vec<Lanes<N>>,
    /// `order + 1` coefficients for every state.
    out: Vec<Lanes<N>>,
}

impl<'a, const N: usize> Together<'a, N> {
    fn new(flow: &'a Flow, order: usize) -> Together<'a, N> {
        let n = flow.dimension;
        Together {
            flow,
            order,
            slots: flow.slots(order, &[]),
            time: Lanes::ZERO,
            state: vec![Lanes::ZERO; n],
            out: vec![Lanes::ZERO; n * (order + 1)],
        }
    }

    /// Gives a lane to a walker.
    fn enter(&mut self, lane: usize, walker: &Walker) {
        for (i, &c) in walker.constants().iter().enumerate() {
            let slot = self.slots.value_mut(1 + self.flow.dimension + i);
            let mut all = slot.coefficient(0);
            all.0[lane] = c;
            slot.set_coefficient(0, all);
        }
    }

    /// Grows what all walkers ask for; whether that could be done.
    fn grow<'w, R: Runner<'w>>(&mut self, seats: &[Option<Seat>; N], runners: &mut [R]) -> bool {
        for (lane, seat) in seats.iter().enumerate() {
            let Some(seat) = seat else { continue };
            let (time, state, _) = runners[seat.runner].walker().asks();
            self.time.0[lane] = time;
            self.state.iter_mut().zip(state).for_each(|(all, &x)| all.0[lane] = x);
        }
        self.flow.expand(&mut self.slots, self.order, self.time, &self.state, &mut self.out).is_ok()
    }

    /// Gives a walker its series; `false` if some coefficient has no value.
    fn hand_over(&self, lane: usize, walker: &mut Walker) -> bool {
        let wanted = walker.order() + 1;
        let (_, _, room) = walker.asks();
        let mut sum = 0.0;
        for (to, from) in room.chunks_exact_mut(wanted).zip(self.out.chunks_exact(self.order + 1)) {
            for (to, from) in to.iter_mut().zip(from) {
                *to = positive_zero(from.0[lane]);
                sum += *to * 0.0;
            }
        }
        // What has no value is NaN.
        sum == 0.0
    }
}

/// 0 without a sign: that of a sum of zeros depends on how many were added.
fn positive_zero(x: f64) -> f64 {
    x + 0.0
}
