//! What a program computes, compiled, and evaluated at the points of a motion.
//!
//! **In:** expressions, and points. **Out:** their values with error bounds, at one point or at several at once.
//!
//! Points are evaluated in blocks. What does not change from point to point is computed once for all of them: about a third
//! of what claims name are parameters and values at the start. **Guaranteed:** every value is, bit for bit, what the point
//! alone yields.

use std::ops::Range;

use crate::expr::tape::{Needed, Slots, Tape};
use crate::expr::{Expr, Graph, Leaf};
use crate::flow::{Points, Sample};
use crate::number::{Bounded, BoundedLanes};

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
    /// What they need.
    needed: Needed,
    /// The inputs among that that are not the same at all points.
    changing: Vec<usize>,
    /// For every output, whether something that it depends on has no value at any of the points.
    never: Vec<bool>,
    /// The memory of blocks, and whether what does not change stands in it.
    block: (Option<Slots<Block>>, bool),
    single: Option<Slots<Bounded>>,
}

impl<'a> Evaluation<'a> {
    /// Some outputs, to be evaluated.
    pub fn new(part: &'a Part, points: &'a Points, sign: f64, outputs: Range<usize>) -> Evaluation<'a> {
        let Part { tape, inputs } = part;
        let absent: Vec<bool> = inputs.iter().map(|&at| points.absent(at).is_some()).collect();
        let never = if absent.contains(&true) { tape.depends(&absent) } else { Vec::new() };
        let changes: Vec<bool> = inputs.iter().map(|&at| !points.is_constant(at)).collect();
        let mut needed = tape.needed(outputs.clone(), &changes);
        // The sign of ± is set by itself.
        needed.inputs.retain(|&i| i < inputs.len());
        let changing = needed.inputs.iter().copied().filter(|&i| changes[i]).collect();
        Evaluation { part, points, sign, outputs, needed, changing, never, block: (None, false), single: None }
    }

    /// The same in the memory of another evaluation of the part: fresh memory is for all outputs, whatever is asked for.
    pub fn in_memory(self, memory: Option<Slots<Block>>) -> Evaluation<'a> {
        Evaluation { block: (memory, false), ..self }
    }

    /// The memory, for another evaluation.
    pub fn into_memory(self) -> Option<Slots<Block>> {
        self.block.0
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
                tape.run_some(&(), slots, &self.needed.varying);
                slots
            }
            none => {
                let mut slots = tape.slots(&());
                for &i in &self.needed.inputs {
                    slots.set(i, sample.get(inputs[i]));
                }
                slots.set(inputs.len(), Ok(Bounded::exact(self.sign)));
                tape.run_some(&(), &mut slots, &self.needed.instructions);
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
        let (memory, is_begun) = &mut self.block;
        let slots = memory.get_or_insert_with(|| tape.slots::<Block>(&()));
        if *is_begun {
            for &i in &self.changing {
                slots.set(i, lanes(i)?);
            }
            tape.run_some(&(), slots, &self.needed.varying);
        } else {
            for &i in &self.needed.inputs {
                slots.set(i, lanes(i)?);
            }
            slots.set(inputs.len(), Ok(Block::splat(Bounded::exact(self.sign))));
            tape.run_some(&(), slots, &self.needed.instructions);
            *is_begun = true;
        }
        let slots = &*slots;
        let valued = |o: usize| self.never.get(o) == Some(&true) || tape.output(o, slots).is_ok();
        self.outputs.clone().all(valued).then_some(slots)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::{Op, Shape};
    use crate::number::NoValue;

    /// A graph with the leaves a, b, c, d and the sign, and some expressions of them.
    fn expressions() -> (Graph, Vec<Leaf>, Leaf, Vec<Expr>) {
        let mut graph = Graph::default();
        let mut leaf = |name: &str| {
            let symbol = graph.declare(name, Shape::scalar(), false);
            Leaf::now(symbol, 0)
        };
        let leaves: Vec<Leaf> = ["a", "b", "c", "d"].map(&mut leaf).to_vec();
        let sign = leaf("s");
        let [a, b, c, d, s] = [0, 1, 2, 3, 4].map(|i| graph.leaf(*leaves.get(i).unwrap_or(&sign)));
        let constant = graph.unary(Op::Sqrt, a);
        let moving = graph.mul(constant, b);
        let branch = graph.mul(s, moving);
        let partial = graph.div(moving, c);
        let sum = graph.add(partial, branch);
        let never = graph.add(d, moving);
        (graph, leaves, sign, vec![constant, moving, branch, partial, sum, never])
    }

    /// a is constant, b changes, c has no value at one time, and vanishes at another; d never has one.
    fn points() -> Points {
        let value = |x: f64| Ok(Bounded::new(x, 1e-15 * x.abs()));
        let partial = |i: usize| match i {
            5 => Err(NoValue::OutOfDomain),
            21 => value(0.0),
            _ => value(0.5 + i as f64),
        };
        let row = |i: usize| vec![value(2.0), value((i * i % 17) as f64 - 8.0), partial(i), Err(NoValue::OutOfDomain)];
        (0..27).map(row).collect()
    }

    #[test]
    fn blocks_and_parts_yield_what_the_point_alone_yields() {
        let (graph, leaves, sign, roots) = expressions();
        let points = points();
        let part = Part::new(&graph, &leaves, sign, &roots).unwrap();
        let value = |x: Result<&Bounded, NoValue>| x.map(|x| (x.value.to_bits(), x.error.to_bits()));
        for outputs in [0..roots.len(), 0..3, 3..4, 4..6] {
            let mut evaluation = Evaluation::new(&part, &points, -1.0, outputs.clone());
            let mut blocks = 0;
            for from in [0, 8, 2, 16, 19] {
                // A block in order, and one in another order.
                for at in [std::array::from_fn(|i| from + i), std::array::from_fn(|i| (from + 5 * i) % 27)] {
                    let alone = |i: usize, o: usize| {
                        let mut slots = None;
                        let slots = part.run(points.sample(at[i]), -1.0, &mut slots);
                        value(part.tape().output(o, slots))
                    };
                    match evaluation.at_all(at) {
                        Some(slots) => {
                            blocks += 1;
                            for (o, i) in outputs.clone().flat_map(|o| (0..BLOCK).map(move |i| (o, i))) {
                                let found = part.tape().output(o, slots).map(|x| x.lane(i));
                                assert_eq!(value(found.as_ref().map_err(|e| *e)), alone(i, o), "{o} at {}", at[i]);
                            }
                        }
                        None => assert!(outputs.clone().any(|o| (0..BLOCK).any(|i| alone(i, o).is_err()))),
                    }
                    for (i, &time) in at.iter().enumerate() {
                        let slots = evaluation.at(time);
                        for o in outputs.clone() {
                            assert_eq!(value(part.tape().output(o, slots)), alone(i, o), "{o} at {time}");
                        }
                    }
                }
            }
            assert!(blocks >= 2, "{outputs:?}: {blocks}");
        }
    }

    #[test]
    fn what_does_not_change_is_computed_once() {
        let (graph, leaves, sign, roots) = expressions();
        let part = Part::new(&graph, &leaves, sign, &roots).unwrap();
        let points = points();
        let evaluation = Evaluation::new(&part, &points, 1.0, 0..roots.len());
        let needed = &evaluation.needed;
        assert_eq!(needed.instructions.len(), part.tape().instructions().len());
        // √a alone is the same at all times.
        assert_eq!(needed.varying.len(), needed.instructions.len() - 1);
        let constant = Evaluation::new(&part, &points, 1.0, 0..1).needed;
        assert_eq!((constant.inputs.len(), constant.instructions.len(), constant.varying.len()), (1, 1, 0));
    }
}
