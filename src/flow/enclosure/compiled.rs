//! Expressions along an enclosed motion, compiled, and their ranges over stretches of time.

use std::cell::RefCell;

use super::Enclosure;
use crate::expr::{Expr, Graph, Leaf};
use crate::flow::error::{FlowError, leaf_name};
use crate::number::{Interval, Jet, NoValue, Orders, Scalar};
use crate::tape::{Slots, Tape};

/// Where an input comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Input {
    Time,
    State(usize),
    Constant(usize),
    Turns(usize),
    Side(usize),
}

/// Expressions as one tape.
#[derive(Clone, Debug)]
pub struct Compiled {
    tape: Tape,
    inputs: Vec<Input>,
    moving: bool,
    /// For every degree that was asked for, the memory of its evaluations: nothing is allocated twice.
    memory: RefCell<Vec<(usize, Slots<Jet<Interval>>)>>,
}

impl Compiled {
    /// Number of operations of one evaluation: a measure of work that is the same on every machine.
    pub fn operations(&self) -> usize {
        self.tape.instructions().len()
    }
}

/// What a quantity does over a stretch of time: a polynomial with a remainder.
///
/// By Taylor's theorem with Lagrange's remainder, f(t) = Σₖ≤ₘ fₖ(τ)·(t − τ)ᵏ + fₘ₊₁(ξ)·(t − τ)ᵐ⁺¹, where fₖ are the normalised
/// derivatives along the motion: the coefficients at the middle τ are narrow, since the states there are; only the last one
/// is taken over the whole stretch.
#[derive(Clone, Debug)]
pub struct Reach {
    stretch: Interval,
    middle: f64,
    narrow: Vec<Interval>,
    /// Coefficients over the stretch; those from `narrow.len()` on are used.
    wide: Vec<Interval>,
}

/// The states over a stretch of time, expanded: around its middle, and over all of it.
#[derive(Clone, Debug)]
pub struct Stretch {
    time: Interval,
    degree: usize,
    wide: Result<Vec<Interval>, NoValue>,
    narrow: Result<Vec<Interval>, NoValue>,
    plain: Result<Vec<Interval>, NoValue>,
}

impl Stretch {
    /// The times.
    pub fn time(&self) -> Interval {
        self.time
    }
}

impl Reach {
    /// The times.
    pub fn stretch(&self) -> Interval {
        self.stretch
    }

    /// All values over the part of the stretch that `time` is.
    pub fn at(&self, time: Interval) -> Interval {
        let Some(direct) = self.wide.first().copied() else { return Interval::INVALID };
        let s = time - Interval::point(self.middle);
        let m = self.narrow.len();
        let Some(&last) = self.wide.get(m).filter(|_| m > 0) else { return direct };
        let found = self.narrow.iter().rev().fold(last, |sum, &c| sum * s + c);
        // First order alone: where a quantity is monotone, its ends are.
        found.intersection(direct).unwrap_or(direct)
    }

    /// All values over the stretch.
    pub fn range(&self) -> Interval {
        self.at(self.stretch)
    }

    /// All values of the derivative of order n over a part of the stretch; `None` where too few orders are known.
    pub fn derivative(&self, n: usize, time: Interval) -> Option<Interval> {
        let weight = |k: usize| (k + 1 - n..=k).fold(Interval::point(1.0), |w, j| w * Interval::integer(j as i32));
        let direct = self.wide.get(n).copied()? * weight(n);
        let m = self.narrow.len();
        if n >= m {
            return Some(direct);
        }
        let s = time - Interval::point(self.middle);
        let last = self.wide.get(m).copied()? * weight(m);
        let found = (n..m).rev().fold(last, |sum, k| sum * s + self.narrow[k] * weight(k));
        Some(found.intersection(direct).unwrap_or(direct))
    }
}

impl Enclosure {
    /// Compiles expressions in the leaves of the motion: values now and at fixed times, and rates of any order.
    ///
    /// # Errors
    /// [`FlowError::UnknownLeaf`], [`FlowError::NoDerivative`].
    pub fn compile(&mut self, graph: &mut Graph, roots: &[Expr]) -> Result<Compiled, FlowError> {
        let mut resolved = Vec::new();
        for &e in roots {
            resolved.push(self.resolve(graph, e)?);
        }
        self.compile_resolved(graph, &resolved)
    }

    pub(super) fn compile_resolved(&self, graph: &Graph, roots: &[Expr]) -> Result<Compiled, FlowError> {
        let leaves = graph.leaves(roots.iter().copied());
        let input = |&leaf: &Leaf| {
            if leaf == self.time {
                return Ok(Input::Time);
            }
            let state = self.tube.as_deref().and_then(|t| t.states.iter().position(|&l| l == leaf));
            let constant = || self.constants.iter().position(|c| c.0 == leaf);
            let turns = || self.angles.iter().position(|a| a.turns == leaf);
            let side = || self.angles.iter().position(|a| a.side == leaf);
            state
                .map(Input::State)
                .or_else(|| constant().map(Input::Constant))
                .or_else(|| turns().map(Input::Turns))
                .or_else(|| side().map(Input::Side))
                .ok_or_else(|| FlowError::UnknownLeaf { leaf: leaf_name(graph, leaf) })
        };
        let inputs: Vec<Input> = leaves.iter().map(input).collect::<Result<_, _>>()?;
        let moving = inputs.iter().any(|i| matches!(i, Input::State(_)));
        let tape = Tape::compile(graph, &leaves, roots)
            .map_err(|leaf| FlowError::UnknownLeaf { leaf: leaf_name(graph, leaf) })?;
        Ok(Compiled { tape, inputs, moving, memory: RefCell::default() })
    }

    /// The series of the states around all times of an interval.
    fn states(&self, time: Interval, degree: usize) -> Result<Vec<Interval>, NoValue> {
        let Some(tube) = self.tube.as_deref() else { return Ok(Vec::new()) };
        let state = self.state(time).ok_or(NoValue::Indeterminate)?;
        if degree == 0 {
            return Ok(state);
        }
        let mut coefficients = vec![Interval::ZERO; state.len() * (degree + 1)];
        let flow = &tube.field.flow;
        let mut field = flow.slots(degree, &tube.field.constants);
        flow.expand(&mut field, degree, time, &state, &mut coefficients).map_err(|(_, reason)| reason)?;
        Ok(coefficients)
    }

    /// The series of all roots around the times of an interval, of which `of` is the stretch that decides on angles.
    fn series(
        &self,
        compiled: &Compiled,
        time: Interval,
        degree: usize,
        of: Interval,
        states: &Result<Vec<Interval>, NoValue>,
    ) -> Vec<Result<Vec<Interval>, NoValue>> {
        let orders = Orders::all(degree);
        let row = degree + 1;
        let mut memory = compiled.memory.borrow_mut();
        let known = memory.iter().position(|m| m.0 == degree);
        let at = known.unwrap_or_else(|| {
            memory.push((degree, compiled.tape.slots(&orders)));
            memory.len() - 1
        });
        let slots = &mut memory[at].1;
        for (at, input) in compiled.inputs.iter().enumerate() {
            let value = match *input {
                Input::Time => Ok(Jet::variable(time, Interval::point(1.0), &orders)),
                Input::Constant(i) => self.constants[i].1.map(|c| Jet::constant(c, &orders)),
                Input::Turns(i) => self.angles[i].turns(of).map(|(turns, _)| Jet::constant(turns, &orders)),
                Input::Side(i) => self.angles[i].turns(of).map(|(_, side)| Jet::constant(side, &orders)),
                Input::State(i) => states.as_ref().map_err(|&reason| reason).map(|coefficients| {
                    let mut jet = Jet::constant(coefficients[i * row], &orders);
                    (1..row).for_each(|k| jet.set_coefficient(k, coefficients[i * row + k]));
                    jet
                }),
            };
            slots.set(at, value);
        }
        compiled.tape.run(&orders, slots);
        let output = |i: usize| {
            let jet = compiled.tape.output(i, slots)?;
            Ok((0..row).map(|k| jet.coefficient(k)).collect())
        };
        (0..compiled.tape.output_count()).map(output).collect()
    }

    /// All values of the roots over an interval of times.
    pub fn value(&self, compiled: &Compiled, time: Interval) -> Vec<Result<Interval, NoValue>> {
        let states = if compiled.moving { self.states(time, 0) } else { Ok(Vec::new()) };
        self.series(compiled, time, 0, time, &states).into_iter().map(|s| s.map(|s| s[0])).collect()
    }

    /// All values of the roots at the middle of a stretch, by what is known of the states there.
    pub fn value_at_middle(&self, compiled: &Compiled, stretch: &Stretch) -> Vec<Result<Interval, NoValue>> {
        let middle = Interval::point(stretch.time.mid());
        let Ok(narrow) = &stretch.narrow else { return self.value(compiled, middle) };
        let states = Ok(narrow.iter().step_by(stretch.degree + 1).copied().collect());
        self.series(compiled, middle, 0, stretch.time, &states).into_iter().map(|s| s.map(|s| s[0])).collect()
    }

    /// The states over a stretch of time, for any number of calls of [`Enclosure::over`], by polynomials of a degree.
    pub fn stretch(&self, time: Interval, degree: usize) -> Stretch {
        let middle = Interval::point(time.mid());
        let (wide, narrow) = (self.states(time, degree + 1), self.states(middle, degree));
        Stretch { time, degree, wide, narrow, plain: self.states(time, 0) }
    }

    /// What the roots do over a stretch of time.
    ///
    /// # Errors
    /// For each root, why it has no value at some of the times, or may have none.
    pub fn over(&self, compiled: &Compiled, stretch: &Stretch) -> Vec<Result<Reach, NoValue>> {
        let Stretch { time, degree, .. } = *stretch;
        let middle = time.mid();
        let wide = self.series(compiled, time, degree + 1, time, &stretch.wide);
        let narrow = self.series(compiled, Interval::point(middle), degree, time, &stretch.narrow);
        // A value exists also where a derivative does not.
        let failed = wide.iter().chain(&narrow).any(Result::is_err);
        let plain = failed.then(|| self.series(compiled, time, 0, time, &stretch.plain));
        let all = wide.into_iter().zip(narrow).enumerate();
        all.map(|(i, (wide, narrow))| match (wide, narrow) {
            (Ok(wide), Ok(narrow)) => Ok(Reach { stretch: time, middle, narrow, wide }),
            (wide, _) => {
                let fallback = plain.as_ref().map_or(wide, |p| p[i].clone());
                fallback.map(|wide| Reach { stretch: time, middle, narrow: Vec::new(), wide })
            }
        })
        .collect()
    }
}
