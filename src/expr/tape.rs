//! Expressions as straight-line programs.
//!
//! **In:** roots of a [`Graph`]. **Out:** a [`Tape`]: inputs, constants and one instruction per shared node, in an order in
//! which every argument comes before its use, sine and cosine of one angle side by side; and **the one** loop that evaluates it over
//! any [`Number`].
//!
//! **Guaranteed:** an instruction without a value poisons what depends on it and nothing else; each output says by itself
//! whether it has a value. The same tape and the same inputs give the same bits.
//!
//! **Why no reuse of slots:** series are computed order by order, with every intermediate series still there.

use crate::FastMap;
use crate::{Expr, Graph, Leaf, Node};
pub use number::Instruction;
use number::{Bounded, NoValue, Number, Op, Rational};
use std::collections::hash_map::Entry;

/// The counted work of writing a constant.
const OF_A_PRESET: u64 = 20;

/// What fills a slot before the instructions run.
#[derive(Clone, Debug, PartialEq)]
enum Preset {
    Rational(Rational),
    Pi,
}

/// A straight-line program. Slots are numbered: inputs first, then constants, then results.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tape {
    inputs: Vec<Leaf>,
    presets: Vec<Preset>,
    instructions: Vec<Instruction>,
    outputs: Vec<u32>,
}

/// What some outputs of a tape need.
#[derive(Clone, Debug, PartialEq)]
pub struct Needed {
    /// The inputs, by their positions.
    pub inputs: Vec<usize>,
    /// The instructions, in their order.
    pub instructions: Vec<Instruction>,
    /// Those of them that depend on an input that changes, in their order.
    pub varying: Vec<Instruction>,
}

/// The first thing without a value on the way to an output.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// An input was given without a value: its position.
    Input(usize),
    /// A constant that the number type cannot hold.
    Constant,
    /// An operation outside its domain; its arguments have values.
    Instruction(Instruction),
}

/// The memory of one evaluation, reused from one to the next.
#[derive(Clone, Debug)]
pub struct Slots<N> {
    values: Vec<N>,
    missing: Vec<Option<NoValue>>,
}

impl Tape {
    /// All that it computes, as a text: what its inputs are called apart.
    pub fn content(&self) -> String {
        let preset = |preset: &Preset| match preset {
            Preset::Rational(r) => r.to_string(),
            Preset::Pi => "π".to_owned(),
        };
        let presets: Vec<String> = self.presets.iter().map(preset).collect();
        format!("{} {presets:?} {:?} {:?}", self.inputs.len(), self.instructions, self.outputs)
    }

    /// Compiles the roots. Inputs are `inputs`, in this order, whether used or not; every leaf of the roots must be there.
    ///
    /// # Errors
    /// The first leaf that the roots need and `inputs` does not have.
    pub fn compile(graph: &Graph, inputs: &[Leaf], roots: &[Expr]) -> Result<Tape, Leaf> {
        let place: FastMap<Leaf, u32> = inputs.iter().enumerate().map(|(i, &leaf)| (leaf, i as u32)).collect();
        let order = graph.reachable(roots.iter().copied());
        let mut slot: FastMap<Expr, u32> = FastMap::with_capacity_and_hasher(order.len(), Default::default());
        let mut presets = Vec::new();
        for &e in &order {
            match graph.node(e) {
                Node::Leaf(leaf) => {
                    slot.insert(e, *place.get(leaf).ok_or(*leaf)?);
                }
                Node::Constant(_) | Node::Pi => {
                    slot.insert(e, (inputs.len() + presets.len()) as u32);
                    presets.push(match graph.node(e) {
                        Node::Constant(r) => Preset::Rational((**r).clone()),
                        _ => Preset::Pi,
                    });
                }
                Node::Unary(..) | Node::Binary(..) => {}
            }
        }
        let first = (inputs.len() + presets.len()) as u32;
        // The cosine of an angle stands beside its sine: lanes make both at once.
        let wave = |&e: &Expr| match *graph.node(e) {
            Node::Unary(op @ (Op::Sin | Op::Cos), a) => Some((op, a, a)),
            Node::Binary(op @ Op::DirectionCosine, a, b) => Some((op, a, b)),
            _ => None,
        };
        let waves: FastMap<(Op, Expr, Expr), Expr> = order.iter().filter_map(|e| Some((wave(e)?, *e))).collect();
        let mut instructions = Vec::new();
        for &e in &order {
            let beside = wave(&e).and_then(|(op, a, b)| {
                let other = match op {
                    Op::Sin => Op::Cos,
                    Op::Cos => Op::Sin,
                    other => other,
                };
                waves.get(&(other, b, a)).copied()
            });
            for e in [Some(e), beside].into_iter().flatten() {
                let (op, a, b) = match *graph.node(e) {
                    Node::Unary(op, a) => (op, a, a),
                    Node::Binary(op, a, b) => (op, a, b),
                    _ => continue,
                };
                if let Entry::Vacant(place) = slot.entry(e) {
                    let out = first + instructions.len() as u32;
                    place.insert(out);
                    instructions.push(Instruction { op, a: slot[&a], b: slot[&b], out });
                }
            }
        }
        let outputs = roots.iter().map(|e| slot[e]).collect();
        Ok(Tape { inputs: inputs.to_vec(), presets, instructions, outputs })
    }

    /// The same for some of the outputs, in the order of `outputs`: only what they need is computed. Inputs stay as they are.
    pub fn part(&self, outputs: &[usize]) -> Tape {
        meter::charge(2 * self.slot_count() as u64);
        let constants = self.inputs.len();
        let mut needed = vec![false; self.slot_count()];
        outputs.iter().for_each(|&o| needed[self.outputs[o] as usize] = true);
        for step in self.instructions.iter().rev() {
            if needed[step.out as usize] {
                needed[step.a as usize] = true;
                needed[step.b as usize] = true;
            }
        }
        let mut slot: Vec<u32> = (0..self.slot_count() as u32).collect();
        let mut presets = Vec::new();
        for (i, preset) in self.presets.iter().enumerate().filter(|(i, _)| needed[constants + i]) {
            slot[constants + i] = (constants + presets.len()) as u32;
            presets.push(preset.clone());
        }
        let first_result = constants + presets.len();
        let mut instructions = Vec::new();
        for step in self.instructions.iter().filter(|step| needed[step.out as usize]) {
            let out = (first_result + instructions.len()) as u32;
            slot[step.out as usize] = out;
            let (a, b) = (slot[step.a as usize], slot[step.b as usize]);
            instructions.push(Instruction { op: step.op, a, b, out });
        }
        let outputs = outputs.iter().map(|&o| slot[self.outputs[o] as usize]).collect();
        Tape { inputs: self.inputs.clone(), presets, instructions, outputs }
    }

    /// The leaves that must be given, in order.
    pub fn inputs(&self) -> &[Leaf] {
        &self.inputs
    }

    /// The instructions in order.
    pub fn instructions(&self) -> &[Instruction] {
        &self.instructions
    }

    /// For every output, whether it depends on one of the inputs that are marked.
    pub fn depends(&self, marked: &[bool]) -> Vec<bool> {
        let mut depends = marked.to_vec();
        depends.resize(self.slot_count(), false);
        for step in &self.instructions {
            depends[step.out as usize] = depends[step.a as usize] || depends[step.b as usize];
        }
        self.outputs.iter().map(|&o| depends[o as usize]).collect()
    }

    /// What some outputs need; inputs that change from one evaluation to the next are marked. Takes no longer than what is needed is large.
    pub fn needed(&self, outputs: impl Iterator<Item = usize>, changing: &[bool]) -> Needed {
        let first = self.inputs.len() + self.presets.len();
        // Results stand in the order of their instructions, after what they are computed from.
        let step = |slot: u32| (slot as usize).checked_sub(first).map(|k| self.instructions[k]);
        let mut needed: FastMap<u32, bool> = FastMap::default();
        let mut open: Vec<u32> = outputs.map(|o| self.outputs[o]).collect();
        while let Some(slot) = open.pop() {
            if let Entry::Vacant(place) = needed.entry(slot) {
                place.insert(changing.get(slot as usize).copied().unwrap_or(false));
                open.extend(step(slot).iter().flat_map(|step| [step.a, step.b]));
            }
        }
        let mut slots: Vec<u32> = needed.keys().copied().collect();
        slots.sort_unstable();
        let instructions: Vec<Instruction> = slots.iter().filter_map(|&slot| step(slot)).collect();
        let mut varying = Vec::with_capacity(instructions.len());
        for step in &instructions {
            if needed[&step.a] || needed[&step.b] {
                needed.insert(step.out, true);
                varying.push(*step);
            }
        }
        let inputs = slots.into_iter().map(|slot| slot as usize).filter(|&slot| slot < self.inputs.len()).collect();
        Needed { inputs, instructions, varying }
    }

    /// Number of slots: inputs, constants and results.
    pub fn slot_count(&self) -> usize {
        self.inputs.len() + self.presets.len() + self.instructions.len()
    }

    /// Number of outputs.
    pub fn output_count(&self) -> usize {
        self.outputs.len()
    }

    /// The slot in which an output is found.
    pub fn output_slot(&self, output: usize) -> usize {
        self.outputs[output] as usize
    }

    /// Memory for evaluations of this tape, with its constants in place.
    pub fn slots<N: Number>(&self, cx: &N::Context) -> Slots<N> {
        let n = self.inputs.len() + self.presets.len() + self.instructions.len();
        let mut slots = Slots { values: vec![N::blank(cx); n], missing: vec![None; n] };
        self.load_constants(cx, &mut slots);
        slots
    }

    /// The same in memory that another tape has used: fresh memory has to be given out by the system first.
    pub fn prepare<N: Number>(&self, cx: &N::Context, slots: &mut Slots<N>) {
        let n = self.slot_count();
        slots.values.resize(n, N::blank(cx));
        slots.missing.clear();
        slots.missing.resize(n, None);
        self.load_constants(cx, slots);
    }

    /// Writes the constants again, for a number type whose constants depend on the context.
    pub fn load_constants<N: Number>(&self, cx: &N::Context, slots: &mut Slots<N>) {
        meter::charge(OF_A_PRESET * self.presets.len() as u64 + (slots.values.len() * size_of::<N>()) as u64 / 8);
        for (i, preset) in self.presets.iter().enumerate() {
            let at = self.inputs.len() + i;
            let written = match preset {
                Preset::Rational(r) => slots.values[at].rational(cx, r),
                Preset::Pi => slots.values[at].pi(cx),
            };
            slots.missing[at] = written.err();
        }
    }

    /// Runs all instructions: the one evaluation loop. Inputs are taken from the slots, see [`Slots::set`].
    pub fn run<N: Number>(&self, cx: &N::Context, slots: &mut Slots<N>) {
        self.run_some(cx, slots, &self.instructions);
    }

    /// Runs some of the instructions, where the others have their results from before: those that depend on inputs which
    /// have changed since, in an order in which every argument comes before its use.
    pub fn run_some<N: Number>(&self, cx: &N::Context, slots: &mut Slots<N>, instructions: &[Instruction]) {
        meter::charge(instructions.len() as u64 * N::work(cx));
        N::run(cx, &mut slots.values, &mut slots.missing, instructions);
    }

    /// An output after [`Tape::run`].
    ///
    /// # Errors
    /// Why this output has no value.
    pub fn output<'s, N>(&self, output: usize, slots: &'s Slots<N>) -> Result<&'s N, NoValue> {
        let at = self.outputs[output] as usize;
        match slots.missing[at] {
            Some(reason) => Err(reason),
            None => Ok(&slots.values[at]),
        }
    }

    /// Where the reason lies that an output has no value after [`Tape::run`]; `None` where it has one.
    pub fn fault<N>(&self, output: usize, slots: &Slots<N>) -> Option<Fault> {
        let mut at = self.outputs[output] as usize;
        slots.missing[at]?;
        let first = self.inputs.len() + self.presets.len();
        loop {
            if at < self.inputs.len() {
                return Some(Fault::Input(at));
            }
            // A constant without a value is too large for the number type.
            let Some(&step) = at.checked_sub(first).and_then(|i| self.instructions.get(i)) else {
                return Some(Fault::Constant);
            };
            match (slots.missing[step.a as usize], slots.missing[step.b as usize]) {
                (Some(_), _) => at = step.a as usize,
                (None, Some(_)) => at = step.b as usize,
                (None, None) => return Some(Fault::Instruction(step)),
            }
        }
    }

    /// Whether, in the last run, an angle may have been on either side of its cut: the error of a value near π or −π says nothing of
    /// the other.
    pub fn straddles_cut(&self, slots: &Slots<Bounded>) -> bool {
        let value = |slot: u32| slots.missing(slot as usize).is_none().then(|| slots.value(slot as usize));
        let sides = |i: &Instruction| value(i.a).zip(value(i.b));
        let mut angles = self.instructions.iter().filter(|i| i.op == Op::Arctan2);
        angles.any(|i| sides(i).is_some_and(|(y, x)| y.straddles_cut(x)))
    }

    /// The outputs; none has a value where an angle may be on either side of its cut.
    pub fn determined(&self, inputs: &[Result<Bounded, NoValue>]) -> Vec<Result<Bounded, NoValue>> {
        let mut slots = self.slots(&());
        let mut outputs = self.evaluate(&(), inputs, &mut slots);
        if self.straddles_cut(&slots) {
            outputs.iter_mut().filter(|x| x.is_ok()).for_each(|x| *x = Err(NoValue::Indeterminate));
        }
        outputs
    }

    /// Sets the inputs, runs, and copies the outputs.
    pub fn evaluate<N: Number>(
        &self,
        cx: &N::Context,
        inputs: &[Result<N, NoValue>],
        slots: &mut Slots<N>,
    ) -> Vec<Result<N, NoValue>> {
        for (i, value) in inputs.iter().enumerate() {
            slots.set(i, value.clone());
        }
        self.run(cx, slots);
        (0..self.outputs.len()).map(|i| self.output(i, slots).cloned()).collect()
    }
}

impl<N> Default for Slots<N> {
    /// No memory yet: see [`Tape::prepare`].
    fn default() -> Slots<N> {
        Slots { values: Vec::new(), missing: Vec::new() }
    }
}

impl Graph {
    /// A number that is written as a formula, without symbols, as the binary64 number that is nearest to it as far as it is computed; nothing where it has no
    /// finite value, or names a symbol.
    pub fn number(&self, e: Expr) -> Option<f64> {
        let tape = Tape::compile(self, &[], &[e]).ok()?;
        let mut slots: Slots<Bounded> = tape.slots(&());
        tape.run(&(), &mut slots);
        let value = tape.output(0, &slots).ok()?.value;
        value.is_finite().then_some(value)
    }
}

impl<N> Slots<N> {
    /// Gives an input its value, or the reason why it has none.
    pub fn set(&mut self, input: usize, value: Result<N, NoValue>) {
        match value {
            Ok(v) => {
                self.values[input] = v;
                self.missing[input] = None;
            }
            Err(reason) => self.missing[input] = Some(reason),
        }
    }

    /// A slot, whether it holds a valid value or not.
    pub fn value(&self, slot: usize) -> &N {
        &self.values[slot]
    }

    /// A slot to be written in place.
    pub fn value_mut(&mut self, slot: usize) -> &mut N {
        &mut self.values[slot]
    }

    /// Why a slot has no value.
    pub fn missing(&self, slot: usize) -> Option<NoValue> {
        self.missing[slot]
    }
}
