//! All variants of a claim as one program.
//!
//! **In:** [`ClaimVariants`]. **Out:** a [`Battery`]: one tape whose outputs are the residuals of the formulas and of their
//! variants. What a variant has in common with the print, and with other variants, is computed once.

use super::generate::ClaimVariants;
use crate::expr::tape::{Slots, Tape};
use crate::expr::{Expr, Graph, Leaf};
use crate::number::{Bounded, BoundedLanes, NoValue};

/// Points that are evaluated at once.
pub(super) const LANES: usize = 4;

/// A number with its error bound, or the reason why there is none.
pub(super) type Value = Result<Bounded, NoValue>;

/// The residuals of a claim's formulas and of chosen variants of them.
#[derive(Clone, Debug)]
pub(super) struct Battery {
    tape: Tape,
    /// The variants: positions among those of the claim.
    pub chosen: Vec<usize>,
    /// For each formula, the output of its first part.
    own: Vec<usize>,
    /// For each formula and part, the output of its magnitude.
    sizes: Vec<Vec<Option<usize>>>,
    /// For each chosen variant, the output of its first altered part.
    altered: Vec<usize>,
    /// The place of ± among the inputs.
    sign: Option<usize>,
}

/// The outputs of a battery at one point.
pub(super) struct Outputs<'a> {
    battery: &'a Battery,
    values: Vec<Value>,
}

impl Battery {
    /// Compiles the formulas and the chosen variants for one initial time.
    pub fn new(graph: &Graph, claim: &ClaimVariants, start: usize, chosen: Vec<usize>, sign: Leaf) -> Option<Battery> {
        let mut roots: Vec<Expr> = Vec::new();
        let (mut own, mut sizes, mut altered) = (Vec::new(), Vec::new(), Vec::new());
        for formula in &claim.formulas {
            own.push(roots.len());
            roots.extend(formula.parts.iter().map(|p| p.difference[start]));
            let mut of = Vec::new();
            for size in &formula.magnitudes {
                of.push(size.map(|_| roots.len()));
                roots.extend(*size);
            }
            sizes.push(of);
        }
        for &v in &chosen {
            altered.push(roots.len());
            roots.extend(claim.variants[v].altered.iter().map(|(_, p)| p.difference[start]));
        }
        let leaves = graph.leaves(roots.iter().copied());
        let tape = Tape::compile(graph, &leaves, &roots).ok()?;
        let sign = leaves.iter().position(|l| *l == sign);
        Some(Battery { tape, chosen, own, sizes, altered, sign })
    }

    /// The same for those of the chosen variants that are kept, which are fewer; inputs stay as they are.
    pub fn part(&self, claim: &ClaimVariants, keep: impl Fn(usize) -> bool) -> Battery {
        let first = self.altered.first().copied().unwrap_or(self.tape.output_count());
        let mut outputs: Vec<usize> = (0..first).collect();
        let (mut chosen, mut altered) = (Vec::new(), Vec::new());
        for (&v, &at) in self.chosen.iter().zip(&self.altered).filter(|(v, _)| keep(**v)) {
            chosen.push(v);
            altered.push(outputs.len());
            outputs.extend(at..at + claim.variants[v].altered.len());
        }
        let (own, sizes) = (self.own.clone(), self.sizes.clone());
        Battery { tape: self.tape.part(&outputs), chosen, own, sizes, altered, sign: self.sign }
    }

    /// What must be known, in the order of the inputs; the sign of ± among them.
    pub fn leaves(&self) -> &[Leaf] {
        self.tape.inputs()
    }

    /// The formulas, and how many parts each has.
    pub fn formulas(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        self.sizes.iter().enumerate().map(|(f, s)| (f, s.len()))
    }

    /// Whether a ± occurs.
    pub fn has_sign(&self) -> bool {
        self.sign.is_some()
    }

    /// The memory for evaluations.
    pub fn slots(&self) -> Slots<Bounded> {
        self.tape.slots(&())
    }

    /// Evaluates at a point: the values of the leaves, and the sign of ±.
    pub fn at(&self, values: impl Iterator<Item = Value>, sign: f64, slots: &mut Slots<Bounded>) -> Outputs<'_> {
        for (i, value) in values.enumerate() {
            slots.set(i, value);
        }
        if let Some(place) = self.sign {
            slots.set(place, Ok(Bounded::exact(sign)));
        }
        self.tape.run(&(), slots);
        let values = (0..self.tape.output_count()).map(|i| self.tape.output(i, slots).copied()).collect();
        Outputs { battery: self, values }
    }

    /// Evaluates at several points at once, with what [`Battery::at`] gives for each of them: `value` is that of an input at
    /// a point.
    pub fn at_each(
        &self,
        count: usize,
        value: impl Fn(usize, usize) -> Value,
        sign: f64,
        memory: &mut Memory,
    ) -> Vec<Outputs<'_>> {
        let Memory { lanes: slots, single } = memory;
        self.tape.prepare(&(), slots);
        // The outputs that had no value in a block, and the program for them alone.
        let mut part: Option<(Vec<usize>, Tape)> = None;
        let mut out: Vec<Outputs> = Vec::with_capacity(count);
        let mut first = 0;
        while first < count {
            let here = (count - first).min(LANES);
            // A block that is not full has its last point several times.
            let point = |lane: usize| first + lane.min(here - 1);
            for i in 0..self.leaves().len() {
                let mut lanes = BoundedLanes::splat(Bounded::exact(sign));
                let mut missing = None;
                for lane in (0..LANES).filter(|_| self.sign != Some(i)) {
                    match value(i, point(lane)) {
                        Ok(x) => lanes.set_lane(lane, x),
                        Err(reason) => missing = Some(reason),
                    }
                }
                slots.set(i, missing.map_or(Ok(lanes), Err));
            }
            self.tape.run(&(), slots);
            let outputs = || (0..self.tape.output_count()).map(|o| self.tape.output(o, slots));
            for lane in 0..here {
                let values = outputs().map(|o| o.map(|lanes| lanes.lane(lane))).collect();
                out.push(Outputs { battery: self, values });
            }
            // Where a lane has no value, the block has none: its points are looked at one by one.
            let missing: Vec<usize> = outputs().enumerate().filter(|(_, o)| o.is_err()).map(|(at, _)| at).collect();
            if !missing.is_empty() {
                if part.as_ref().is_none_or(|(of, _)| *of != missing) {
                    let tape = self.tape.part(&missing);
                    tape.prepare(&(), single);
                    part = Some((missing.clone(), tape));
                }
                let Some((_, tape)) = &part else { return out };
                for (lane, outputs) in out[first..].iter_mut().enumerate() {
                    for i in 0..self.leaves().len() {
                        let exact = (self.sign == Some(i)).then(|| Ok(Bounded::exact(sign)));
                        single.set(i, exact.unwrap_or_else(|| value(i, first + lane)));
                    }
                    tape.run(&(), single);
                    for (k, &at) in missing.iter().enumerate() {
                        outputs.values[at] = tape.output(k, single).copied();
                    }
                }
            }
            first += here;
        }
        out
    }

    /// Makes memory of other evaluations that of this battery, for [`Battery::at`].
    pub fn prepare<'m>(&self, memory: &'m mut Memory) -> &'m mut Slots<Bounded> {
        self.tape.prepare(&(), &mut memory.single);
        &mut memory.single
    }
}

/// Memory for evaluations of one battery after the other.
#[derive(Default)]
pub(super) struct Memory {
    lanes: Slots<BoundedLanes<LANES>>,
    single: Slots<Bounded>,
}

impl Outputs<'_> {
    fn value(&self, at: usize) -> Value {
        self.values.get(at).copied().unwrap_or(Err(NoValue::Indeterminate))
    }

    /// A residual of a formula as printed.
    pub fn own(&self, formula: usize, part: usize) -> Value {
        self.value(self.battery.own[formula] + part)
    }

    /// The size of the terms of a part of a formula; 1 where no judgement needs it.
    pub fn size(&self, formula: usize, part: usize) -> f64 {
        let at = self.battery.sizes[formula].get(part).copied().flatten();
        at.and_then(|at| self.value(at).ok()).map_or(1.0, |b| b.value)
    }

    /// A residual of the chosen variant at a position: that of its n-th altered part.
    pub fn altered(&self, position: usize, n: usize) -> Value {
        self.value(self.battery.altered[position] + n)
    }
}
