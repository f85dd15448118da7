//! The values of leaves along many motions of the same formulas, one block of times after the other.
//!
//! **In:** motions that were made after one pattern, and times. **Out:** the leaves at these times, with error bounds; they are there
//! until the next block. **Guaranteed:** they are, bit for bit, those of [`Motion::along`]. Where it takes more than numbers put into
//! formulas (rates, angles that are followed, a value that is not there), nothing is said.
//!
//! **Why:** of most members of a family nothing is kept but whether a claim holds. To have memory given out for the values of each of
//! them costs more than the values.

use std::sync::Arc;

use super::cover::BLOCK;
use super::motion::Motion;
use super::program::{Input, Program};
use expr::tape::Slots;
use number::{Bounded, BoundedLanes, Instruction, Scalar};

/// The leaves of motions at several times.
#[derive(Clone, Debug)]
pub struct Sampler {
    program: Arc<Program>,
    /// The slot of every leaf.
    leaves: Vec<usize>,
    /// What is computed once for a motion, and what at every time.
    still: Vec<Instruction>,
    varying: Vec<Instruction>,
    slots: Slots<BoundedLanes<BLOCK>>,
}

impl Sampler {
    /// For motions with the formulas of this one; nothing where these ask for more than is done here.
    pub fn of(motion: &Motion) -> Option<Sampler> {
        let program = motion.direct()?;
        let tape = &program.tape;
        let changes = |input: &Input| !matches!(input, Input::Constant(_) | Input::Unused);
        let changes: Vec<bool> = program.inputs.iter().map(changes).collect();
        let needed = tape.needed(0..tape.output_count(), &changes);
        let is_still = |step: &&Instruction| !needed.varying.iter().any(|other| other.out == step.out);
        let still = needed.instructions.iter().filter(is_still).copied().collect();
        let leaves = motion.outputs().map(|output| tape.output_slot(output)).collect();
        Some(Sampler { program: Arc::clone(program), leaves, still, varying: needed.varying, slots: tape.slots(&()) })
    }

    /// Begins with a motion; `false` where its formulas are others.
    pub fn enter(&mut self, motion: &Motion) -> bool {
        let Some(program) = motion.direct().filter(|program| Arc::ptr_eq(program, &self.program)) else { return false };
        for (at, input) in program.inputs.iter().enumerate() {
            if let Input::Constant(constant) = input {
                self.slots.set(at, motion.constant(*constant).map(BoundedLanes::splat));
            }
        }
        program.tape.run_some(&(), &mut self.slots, &self.still);
        true
    }

    /// Finds the leaves of the motion at some times, increasing; `false` where there is none of some leaf.
    pub fn run(&mut self, motion: &Motion, times: &[f64; BLOCK]) -> bool {
        let Sampler { program, slots, .. } = self;
        let Some(trajectory) = motion.trajectory() else { return false };
        let (from, to) = trajectory.reach();
        let places = trajectory.places(times);
        let mut known = times.iter().all(|t| (from..=to).contains(t));
        trajectory.bounded_values(&places, &program.needs, |state, x| {
            let x = BoundedLanes::of(x);
            known &= x.checked().is_ok();
            let at = program.inputs.iter().position(|input| *input == Input::State(state));
            at.into_iter().for_each(|at| slots.set(at, Ok(x)));
        });
        for (at, _) in program.inputs.iter().enumerate().filter(|(_, input)| **input == Input::Time) {
            slots.set(at, Ok(BoundedLanes::of(times.map(Bounded::exact))));
        }
        program.tape.run_some(&(), slots, &self.varying);
        known && self.leaves.iter().all(|slot| slots.missing(*slot).is_none())
    }

    /// A leaf at the times of the block that was found.
    #[inline]
    pub fn leaf(&self, leaf: usize) -> &BoundedLanes<BLOCK> {
        self.slots.value(self.leaves[leaf])
    }
}
