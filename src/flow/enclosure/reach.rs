//! Expressions along an enclosed motion, compiled, and their ranges over stretches of time.

use std::cell::{OnceCell, RefCell};

use super::Enclosure;
use super::sharpen::Known;
use crate::definitions::Definitions;
use crate::error::{FlowError, leaf_name};
use expr::tape::{Slots, Tape};
use expr::{Expr, Graph, Leaf};
use number::{Interval, NoValue, Number, TaylorModel};

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
    /// Memory of evaluations over stretches and at times: nothing is allocated twice.
    models: RefCell<Option<Slots<TaylorModel>>>,
    values: RefCell<Option<Slots<Interval>>>,
}

impl Compiled {
    /// Number of operations of one evaluation: a measure of work that is the same on every machine.
    pub fn operations(&self) -> usize {
        self.tape.instructions().len()
    }

    /// Number of roots.
    pub fn outputs(&self) -> usize {
        self.tape.output_count()
    }

    /// The same for some of the roots, in the order of `roots`.
    pub fn part(&self, roots: &[usize]) -> Compiled {
        let (models, values) = Default::default();
        Compiled { tape: self.tape.part(roots), inputs: self.inputs.clone(), moving: self.moving, models, values }
    }
}

/// What a quantity does over a stretch of time: a polynomial with a remainder, see [`TaylorModel`].
#[derive(Clone, Copy, Debug)]
pub struct Reach {
    stretch: Interval,
    middle: f64,
    half: f64,
    model: TaylorModel,
    range: Interval,
}

/// What many quantities do over one stretch of time, in as little memory as it takes: most are constant, or nearly so.
#[derive(Clone, Debug)]
pub struct Reaches {
    stretch: Interval,
    middle: f64,
    half: f64,
    /// For each quantity where its numbers begin, and how many coefficients there are; or why it has no value.
    places: Vec<Result<(u32, u8), NoValue>>,
    /// The ends of a range, and a packed model, one quantity after the other.
    numbers: Vec<f64>,
}

impl Reaches {
    fn pack(stretch: &Stretch, all: &[Result<Reach, NoValue>]) -> Reaches {
        let mut numbers = Vec::with_capacity(8 * all.len());
        let pack = |reach: &Result<Reach, NoValue>| {
            let reach = reach.as_ref().map_err(|&reason| reason)?;
            let begin = numbers.len() as u32;
            numbers.extend([reach.range.lo(), reach.range.hi()]);
            Ok((begin, reach.model.pack(&mut numbers) as u8))
        };
        let places = all.iter().map(pack).collect();
        numbers.shrink_to_fit();
        let Stretch { time, middle, half, .. } = *stretch;
        Reaches { stretch: time, middle, half, places, numbers }
    }

    /// One of the quantities.
    ///
    /// # Errors
    /// Why it has no value at some of the times, or may have none.
    pub fn get(&self, at: usize) -> Result<Reach, NoValue> {
        let place = *self.places.get(at).unwrap_or(&Err(NoValue::Unsupported));
        let (begin, length) = place.map(|(begin, length)| (begin as usize, usize::from(length)))?;
        let (stretch, middle, half) = (self.stretch, self.middle, self.half);
        match &self.numbers[begin..begin + 2 + length] {
            [lo, hi, model @ ..] => {
                let range = Interval::new(*lo, *hi).map_err(|_| NoValue::Indeterminate)?;
                Ok(Reach { stretch, middle, half, model: TaylorModel::unpack(model), range })
            }
            _ => Err(NoValue::Indeterminate),
        }
    }
}

/// The states over a stretch of time, for any number of calls of [`Enclosure::over`].
#[derive(Clone, Debug)]
pub struct Stretch {
    time: Interval,
    middle: f64,
    half: f64,
    models: Result<Vec<TaylorModel>, NoValue>,
    plain: OnceCell<Result<Vec<Interval>, NoValue>>,
    known: OnceCell<Option<Known>>,
    at_middle: OnceCell<Result<Vec<Interval>, NoValue>>,
}

impl Stretch {
    /// The times.
    pub fn time(&self) -> Interval {
        self.time
    }

    pub(super) fn models(&self) -> &Result<Vec<TaylorModel>, NoValue> {
        &self.models
    }

    /// What is known of first integrals, found once.
    pub(super) fn known(&self, find: impl FnOnce() -> Option<Known>) -> Option<&Known> {
        self.known.get_or_init(find).as_ref()
    }
}

impl Reach {
    pub(super) fn new(stretch: &Stretch, model: TaylorModel) -> Reach {
        let Stretch { time, middle, half, .. } = *stretch;
        Reach { stretch: time, middle, half, model, range: model.range() }
    }

    /// Both bounds of the same quantity hold: the polynomial is that of `self`.
    pub fn and(&self, other: &Reach) -> Reach {
        Reach { range: self.range.intersection(other.range).unwrap_or(self.range), ..*self }
    }

    /// The quantity as a polynomial with a remainder.
    pub fn model(&self) -> &TaylorModel {
        &self.model
    }

    /// The times.
    pub fn stretch(&self) -> Interval {
        self.stretch
    }

    /// All values at a time of the stretch.
    pub fn at(&self, time: f64) -> Interval {
        let s = match self.half > 0.0 {
            true => (Interval::point(time) - Interval::point(self.middle)) / Interval::point(self.half),
            false => Interval::point(0.0),
        };
        let found = Interval::new(-1.0, 1.0).ok().and_then(|all| all.intersection(s)).map(|s| self.model.at(s));
        found.and_then(|f| f.intersection(self.range)).unwrap_or(self.range)
    }

    /// All values over the stretch.
    pub fn range(&self) -> Interval {
        self.range
    }

    /// All values of the difference to what another quantity does over the same stretch.
    ///
    /// # Errors
    /// [`NoValue::Indeterminate`] for another stretch, or a bound that is not finite.
    pub fn minus(&self, other: &Reach) -> Result<Interval, NoValue> {
        if (self.stretch, self.middle, self.half) != (other.stretch, other.middle, other.half) {
            return Err(NoValue::Indeterminate);
        }
        let mut difference = TaylorModel::ZERO;
        difference.sub(&(), &self.model, &other.model)?;
        let plain = self.range - other.range;
        Ok(difference.range().intersection(plain).unwrap_or(plain))
    }

    /// How much of the range is not known to be a polynomial in time.
    pub fn remainder(&self) -> f64 {
        self.model.remainder()
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

    /// Compiles expressions that are resolved.
    ///
    /// # Errors
    /// [`FlowError::UnknownLeaf`].
    pub fn compile_resolved(&self, graph: &Graph, roots: &[Expr]) -> Result<Compiled, FlowError> {
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
        let (models, values) = Default::default();
        Ok(Compiled { tape, inputs, moving, models, values })
    }

    /// Runs a tape over one number type.
    fn evaluate<N: Number<Context = ()>>(
        &self,
        compiled: &Compiled,
        memory: &RefCell<Option<Slots<N>>>,
        of: Interval,
        (time, states): (N, &Result<Vec<N>, NoValue>),
        constant: impl Fn(Interval) -> N,
    ) -> Vec<Result<N, NoValue>> {
        let mut memory = memory.borrow_mut();
        let slots = memory.get_or_insert_with(|| compiled.tape.slots(&()));
        for (at, input) in compiled.inputs.iter().enumerate() {
            let value = match *input {
                Input::Time => Ok(time.clone()),
                Input::Constant(i) => self.constants[i].1.map(&constant),
                Input::Turns(i) => self.angles[i].turns(of).map(|(turns, _)| constant(turns)),
                Input::Side(i) => self.angles[i].turns(of).map(|(_, side)| constant(side)),
                Input::State(i) => states.as_ref().map_err(|&reason| reason).map(|all| all[i].clone()),
            };
            slots.set(at, value);
        }
        compiled.tape.run(&(), slots);
        (0..compiled.tape.output_count()).map(|i| compiled.tape.output(i, slots).cloned()).collect()
    }

    /// The states over an interval of times, for a tape that needs them.
    fn states(&self, time: Interval) -> Result<Vec<Interval>, NoValue> {
        match self.tube {
            Some(_) => self.state(time).ok_or(NoValue::Indeterminate),
            None => Ok(Vec::new()),
        }
    }

    /// All values of the roots over an interval of times.
    pub fn value(&self, compiled: &Compiled, time: Interval) -> Vec<Result<Interval, NoValue>> {
        let states = if compiled.moving { self.states(time) } else { Ok(Vec::new()) };
        self.evaluate(compiled, &compiled.values, time, (time, &states), |c| c)
    }

    /// All values of the roots at the middle of a stretch.
    pub fn value_at_middle(&self, compiled: &Compiled, stretch: &Stretch) -> Vec<Result<Interval, NoValue>> {
        let middle = Interval::point(stretch.middle);
        let states = stretch.at_middle.get_or_init(|| self.states(middle));
        self.evaluate(compiled, &compiled.values, stretch.time, (middle, states), |c| c)
    }

    /// The states over a stretch of time.
    pub fn stretch(&self, time: Interval) -> Stretch {
        let middle = time.mid();
        let half = if time.is_point() { 0.0 } else { time.radius() };
        let models = match self.tube.as_deref() {
            None => Ok(Vec::new()),
            Some(_) if time.is_point() => {
                self.states(time).map(|all| all.into_iter().map(TaylorModel::constant).collect())
            }
            Some(tube) => match tube.step(time) {
                Some(piece) => piece.models(middle, half),
                // It reaches over several steps.
                None => self.states(time).map(|all| all.into_iter().map(TaylorModel::constant).collect()),
            },
        };
        let (plain, at_middle, known) = Default::default();
        Stretch { time, middle, half, models, plain, at_middle, known }
    }

    /// The roots over a stretch of time, for given models of the states.
    pub(super) fn models(
        &self,
        compiled: &Compiled,
        stretch: &Stretch,
        states: &Result<Vec<TaylorModel>, NoValue>,
    ) -> Vec<Result<TaylorModel, NoValue>> {
        let now = TaylorModel::variable(Interval::point(stretch.middle), stretch.half);
        self.evaluate(compiled, &compiled.models, stretch.time, (now, states), TaylorModel::constant)
    }

    /// What the roots do over a stretch of time, to be kept.
    pub fn packed(&self, compiled: &Compiled, stretch: &Stretch) -> Reaches {
        Reaches::pack(stretch, &self.over(compiled, stretch))
    }

    /// What the roots do over a stretch of time.
    ///
    /// # Errors
    /// For each root, why it has no value at some of the times, or may have none.
    pub fn over(&self, compiled: &Compiled, stretch: &Stretch) -> Vec<Result<Reach, NoValue>> {
        let Stretch { time, middle, half, .. } = *stretch;
        let now = TaylorModel::variable(Interval::point(middle), half);
        let found = self.evaluate(compiled, &compiled.models, time, (now, &stretch.models), TaylorModel::constant);
        // Bounds without polynomials know that squares are not negative.
        let plain = found.iter().any(Result::is_err).then(|| {
            let states = stretch.plain.get_or_init(|| self.states(time));
            self.evaluate(compiled, &compiled.values, time, (time, states), |c| c)
        });
        let all = found.into_iter().enumerate();
        all.map(|(i, model)| {
            let model = match (model, &plain) {
                (Err(_), Some(plain)) => TaylorModel::constant(plain[i]?),
                (model, _) => model?,
            };
            Ok(Reach { stretch: time, middle, half, model, range: model.range() })
        })
        .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_kept_is_what_was_found() {
        let time = Interval::new(0.5, 0.75).unwrap();
        let (plain, at_middle, known) = Default::default();
        let (middle, half, models) = (0.625, 0.125, Ok(Vec::new()));
        let stretch = Stretch { time, middle, half, models, plain, at_middle, known };
        let now = TaylorModel::variable(Interval::point(middle), half);
        let mut power = now;
        let mut all = vec![Err(NoValue::OutOfDomain), Ok(Reach::new(&stretch, TaylorModel::ZERO))];
        for _ in 0..20 {
            all.push(Ok(Reach::new(&stretch, power)));
            let mut next = TaylorModel::ZERO;
            next.mul(&(), &power, &now).unwrap();
            power = next;
        }
        all.push(Err(NoValue::Indeterminate));
        let wide = Reach { range: Interval::new(-3.0, 5.0).unwrap(), ..Reach::new(&stretch, now) };
        all.extend([Ok(wide), Ok(Reach::new(&stretch, TaylorModel::constant(time)))]);
        let kept = Reaches::pack(&stretch, &all);
        for (i, reach) in all.iter().enumerate() {
            // Every digit, and what is not written.
            assert_eq!(format!("{:?}", kept.get(i)), format!("{reach:?}"), "{i}");
        }
        assert!(kept.get(all.len()).is_err());
        assert!(kept.numbers.len() < 16 * all.len());
    }
}
