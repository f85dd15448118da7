//! Steps that are known from before.
//!
//! **In:** a field, where its motions begin and when they end. **Out:** the validated steps: those that are known, or those that are found.
//!
//! **Guaranteed:** steps are named by all that they are computed from, bit by bit, and their work is counted whether they are known or
//! not: what is known saves time, and changes nothing else.

use super::step::{Field, Piece, Stop};
use meter::Task;
use number::Precise;
use serde::{Deserialize, Serialize};

/// What was found before.
pub trait KnownSteps: Sync {
    /// The steps with a name, if they are known.
    fn steps(&self, _: &str) -> Option<Steps> {
        None
    }

    /// Keeps steps by their name.
    fn keep_steps(&self, _: &str, _: &Steps) {}

    /// Whether anything is kept.
    fn is_known(&self) -> bool {
        false
    }
}

/// Nothing is known.
pub(super) struct Nothing;

impl KnownSteps for Nothing {}

/// The validated steps of a motion.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Steps {
    /// Forward from the initial time, and back from it.
    pub(super) forward: Vec<Piece>,
    pub(super) backward: Vec<Piece>,
    /// Why they end before the span does.
    pub(super) stops: [Option<Stop>; 2],
    /// The counted work of finding them.
    work: u64,
}

impl Steps {
    /// The steps of a field from a set of states at a time to the ends of a span.
    pub(super) fn of(
        field: &Field,
        initial: &[Precise],
        (time, span): (f64, (f64, f64)),
        known: &dyn KnownSteps,
    ) -> Steps {
        let find = || {
            let (forward, ahead) = field.integrate(time, initial, span.1);
            let (backward, behind) = field.integrate(time, initial, span.0);
            Steps { forward, backward, stops: [ahead, behind], work: 0 }
        };
        if !known.is_known() {
            return find();
        }
        let name = format!("{} {initial:?} {time:?} {span:?}", field.content());
        if let Some(mut steps) = known.steps(&name) {
            meter::charge(steps.work);
            [&mut steps.forward, &mut steps.backward].into_iter().for_each(|some| field.complete(some));
            return steps;
        }
        match meter::counted(Task::Enclosing, find) {
            (Ok(steps), work) => {
                let steps = Steps { work, ..steps };
                known.keep_steps(&name, &steps);
                steps
            }
            (Err(ended), _) => {
                let words = ended.to_string();
                meter::unwind(ended, &words)
            }
        }
    }
}
