//! What a program computes, compiled, and evaluated at the points of a motion.
//!
//! **In:** expressions, and points. **Out:** their values with error bounds, at one point or at several at once.
//!
//! Points are evaluated in blocks. What does not change from point to point is computed once for all of them: about a third
//! of what claims name are parameters and values at the start. **Guaranteed:** every value is, bit for bit, what the point
//! alone yields.

use std::ops::Range;

use crate::expr::{Expr, Graph, Leaf};
use crate::flow::{Points, Sample};
use crate::number::{Bounded, BoundedLanes};
use crate::tape::{Instruction, Slots, Tape};

/// Points that are evaluated at once.
pub(super) const BLOCK: usize = 8;

/// A block of points.
pub(super) type Block = BoundedLanes<BLOCK>;

/// Expressions, compiled.
#[derive(Clone, Debug)]
pub(super) struct Part {
    tape: Tape,
    /// Where the inputs of the tape stand among the leaves of a point; the sign of ± comes after them.
    inputs: Vec<usize>,
}

impl Part {
    /// Compiles expressions. `known` are the leaves of a point, sorted; `sign` stands for that of ±.
    ///
    /// # Errors
    /// A leaf that is needed, and is not among those of a point.
    pub fn new(graph: &Graph, known: &[Leaf], sign: Leaf, roots: &[Expr]) -> Result<Part, Leaf> {
        // Only what is needed is copied from a point.
        let mut needed = graph.leaves(roots.iter().copied());
        needed.retain(|&l| l != sign);
        let place = |leaf: &Leaf| known.binary_search(leaf).map_err(|_| *leaf);
        let inputs = needed.iter().map(place).collect::<Result<_, _>>()?;
        needed.push(sign);
        Ok(Part { tape: Tape::compile(graph, &needed, roots)?, inputs })
    }

    /// The tape; its outputs are the expressions, in their order.
    pub fn tape(&self) -> &Tape {
        &self.tape
    }

    /// Where its inputs stand among the leaves of a point, the sign of ± apart.
    pub fn inputs(&self) -> &[usize] {
        &self.inputs
    }

    /// Evaluates everything at a point, for one sign of ±; what was found stays in the slots.
    pub fn run<'s>(&self, values: Sample, sign: f64, slots: &'s mut Option<Slots<Bounded>>) -> &'s Slots<Bounded> {
        let slots = slots.get_or_insert_with(|| self.tape.slots(&()));
        for (i, &at) in self.inputs.iter().enumerate() {
            slots.set(i, values.get(at));
        }
        slots.set(self.inputs.len(), Ok(Bounded::exact(sign)));
        self.tape.run(&(), slots);
        slots
    }
}

/// A part at many points, for one sign of ±.
pub(super) struct Evaluation<'a> {
    part: &'a Part,
    points: &'a Points,
    sign: f64,
    /// The outputs that are asked for.
    outputs: Range<usize>,
    /// The instructions that they need.
    needed: Vec<Instruction>,
    /// The inputs that are not the same at all points.
    changing: Vec<usize>,
    /// The instructions that depend on them.
    varying: Vec<Instruction>,
    /// For every output, whether something that it depends on has no value at any of the points.
    never: Vec<bool>,
    block: Option<Slots<Block>>,
    single: Option<Slots<Bounded>>,
}

impl<'a> Evaluation<'a> {
    /// Some outputs, to be evaluated.
    pub fn new(part: &'a Part, points: &'a Points, sign: f64, outputs: Range<usize>) -> Evaluation<'a> {
        let Part { tape, inputs } = part;
        let absent: Vec<bool> = inputs.iter().map(|&at| points.absent(at).is_some()).collect();
        let never = tape.depends(&absent);
        let changes: Vec<bool> = inputs.iter().map(|&at| !points.is_constant(at)).collect();
        let changing = (0..inputs.len()).filter(|&i| changes[i]).collect();
        let (needed, varying) = tape.needed(outputs.clone(), &changes);
        Evaluation { part, points, sign, outputs, needed, changing, varying, never, block: None, single: None }
    }

    /// Evaluates at a point.
    pub fn at(&mut self, at: usize) -> &Slots<Bounded> {
        let Part { tape, inputs } = self.part;
        let sample = self.points.sample(at);
        match &mut self.single {
            Some(slots) => {
                for &i in &self.changing {
                    slots.set(i, sample.get(inputs[i]));
                }
                tape.run_some(&(), slots, &self.varying);
                slots
            }
            none => {
                let mut slots = tape.slots(&());
                for (i, &at) in inputs.iter().enumerate() {
                    slots.set(i, sample.get(at));
                }
                slots.set(inputs.len(), Ok(Bounded::exact(self.sign)));
                tape.run_some(&(), &mut slots, &self.needed);
                none.insert(slots)
            }
        }
    }

    /// Evaluates at several points; `None` where something has a value at some of them only.
    pub fn at_all(&mut self, at: [usize; BLOCK]) -> Option<&Slots<Block>> {
        let Part { tape, inputs } = self.part;
        let lanes = |i: usize| match self.points.absent(inputs[i]) {
            Some(reason) => Some(Err(reason)),
            None => self.points.lanes_at(at, inputs[i]).map(Ok),
        };
        match &mut self.block {
            Some(slots) => {
                for &i in &self.changing {
                    slots.set(i, lanes(i)?);
                }
                tape.run_some(&(), slots, &self.varying);
            }
            none => {
                let mut slots = tape.slots::<Block>(&());
                for i in 0..inputs.len() {
                    slots.set(i, lanes(i)?);
                }
                slots.set(inputs.len(), Ok(Block::splat(Bounded::exact(self.sign))));
                tape.run_some(&(), &mut slots, &self.needed);
                *none = Some(slots);
            }
        }
        let slots = self.block.as_ref()?;
        let valued = |o: usize| self.never[o] || tape.output(o, slots).is_ok();
        self.outputs.clone().all(valued).then_some(slots)
    }
}
