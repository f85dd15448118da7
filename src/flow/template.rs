//! Motions of the same formulas with other numbers: what does not depend on the numbers is made once.
//!
//! **In:** a motion of a system that was set up, integrated and prepared, and what was searched for along it; then the parameters and
//! initial values of another one. **Out:** what [`Draft::new`], [`Draft::finish`], [`Motion::prepare`] and [`Motion::searches`] make of
//! these, with the programs of the first. **Guaranteed:** the same numbers, bit for bit: constants are evaluated by the same tapes in
//! the same order, angles are followed anew. What could come out otherwise is not made here: nothing is returned, and the long way says
//! what it is, or why it is none.
//!
//! **Why it may be done so:** a parameter is a constant of its own in every formula (see `core`), whatever its value, so that no program
//! of a motion knows a number.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::angle::Angle;
use super::core::{Constant, Core, Origin};
use super::definitions::Definitions;
use super::error::FlowError;
use super::field::VectorField;
use super::motion::{Draft, Motion, shared};
use super::rapid::RapidSearch;
use super::sampler::Sampler;
use super::search::Search;
use super::setup::Begun;
use super::trajectory::Plan;
use expr::{Expr, Graph, Leaf};
use number::{Bounded, NoValue};

/// A motion, as the pattern of others.
#[derive(Debug)]
pub struct Template {
    motion: Motion,
    searches: Vec<Arc<Search>>,
    rapid: Arc<RapidSearch>,
    /// Its parameters: the first of its constants.
    parameters: Vec<Leaf>,
    /// Which of them share what stands for them.
    shared: Vec<usize>,
    /// The values of what it is given by, as far as these are numbers: most of it is the same in all motions.
    numbers: BTreeMap<Expr, Result<Bounded, NoValue>>,
}

/// The searches along a motion: for zeros, and for what varies rapidly.
pub type Sought = (Vec<Arc<Search>>, Arc<RapidSearch>);

/// The parameters of a motion, and its initial values.
pub type Given<'g> = (&'g [(Leaf, Expr)], &'g [(Leaf, Expr)]);

impl Template {
    /// The pattern that an integrated motion is, with what was searched for along it, all at once. The graph in which others are given
    /// goes on from the one in which it was made.
    ///
    /// Nothing where equations determine initial values, or states leap.
    pub fn of(motion: Motion, (searches, rapid): Sought, graph: &Graph, given: Given) -> Option<Template> {
        let (parameters, initial) = given;
        let core = &motion.core;
        let first = |n: usize| matches!(core.constants.get(n).map(|c| &c.origin), Some(Origin::Given));
        let later = core.constants.iter().skip(parameters.len()).all(|c| !matches!(c.origin, Origin::Given));
        let plain = core.orbit.is_some() && core.cuts.is_empty() && later && (0..parameters.len()).all(first);
        let closed = parameters.iter().chain(initial).map(|(_, e)| *e).filter(|e| graph.leaves([*e]).is_empty());
        let numbers = closed.map(|e| (e, core.constant_value(graph, e))).collect();
        let shared = shared(graph, parameters);
        let parameters = parameters.iter().map(|(leaf, _)| *leaf).collect();
        plain.then_some(Template { motion, searches, rapid, parameters, shared, numbers })
    }

    /// What finds the leaves of such motions, where that takes their formulas alone.
    pub fn sampler(&self) -> Option<Sampler> {
        Sampler::of(&self.motion)
    }

    /// Another motion, set up; nothing where that is to be done the long way.
    pub fn draft(&self, graph: &mut Graph, field: &VectorField, (parameters, initial): Given) -> Option<Draft> {
        let of = &self.motion.core;
        let same =
            parameters.iter().map(|(leaf, _)| leaf).eq(&self.parameters) && shared(graph, parameters) == self.shared;
        let integrand = &of.orbit.as_ref().filter(|_| same)?.field;
        let mut core = of.without_values();
        for ((_, e), constant) in parameters.iter().zip(&of.constants) {
            let value = match self.numbers.get(e) {
                Some(value) => *value,
                None => {
                    let resolved = core.resolve(graph, *e).ok()?;
                    core.constant_value(graph, resolved)
                }
            };
            core.constants.push(Constant { value, ..constant.clone() });
        }
        for constant in &of.constants[parameters.len()..] {
            let Origin::Formula(formula) = &constant.origin else { break };
            let value = core.formula_value(formula);
            core.constants.push(Constant { value, ..constant.clone() });
        }
        let known = |leaf: &Leaf| core.constants.iter().find(|c| c.leaf == *leaf)?.value.ok();
        let constants = integrand.used.iter().map(known).collect::<Option<Vec<Bounded>>>()?;
        let mut state = Vec::with_capacity(field.states().len());
        for leaf in field.states() {
            let (_, e) = initial.iter().find(|(l, _)| l == leaf)?;
            state.push(match self.numbers.get(e) {
                Some(value) => (*value).ok()?,
                None => core.initial_value(graph, field, initial, *leaf).ok()?,
            });
        }
        let (initial_time, span) = (core.initial_time, core.span);
        let plan = Plan { constants, initial_time, state, span, max_steps: field.most_steps() };
        Some(Draft::of(core, Begun::of(Arc::clone(integrand), plan)))
    }

    /// The motion, prepared, and the searches along it, of which what lies in its span is kept as `within` says.
    ///
    /// # Errors
    /// [`FlowError::Singular`].
    pub fn finish(&self, draft: Draft, within: impl Fn(&Motion) -> (f64, f64)) -> Result<(Motion, Sought), FlowError> {
        let motion = self.motion.again(self.motion.core.again(&draft.integrated()?));
        let span = within(&motion);
        let along = Arc::new(self.rapid.core().again(&motion.core));
        let searches = self.searches.iter().map(|s| Arc::new(s.again(Arc::clone(&along), span))).collect();
        Ok((motion, (searches, Arc::new(self.rapid.again(along)))))
    }
}

impl Core {
    /// The same formulas, of which nothing has a value yet.
    fn without_values(&self) -> Core {
        Core {
            time: self.time,
            initial_time: self.initial_time,
            span: self.span,
            orbit: None,
            resolution: self.resolution.clone(),
            constants: Vec::with_capacity(self.constants.len()),
            angles: Vec::new(),
            continued: self.continued.clone(),
            cuts: self.cuts.clone(),
            definitions: self.definitions.clone(),
        }
    }

    /// The same formulas with other numbers: `known` has the first of them, and the trajectory.
    pub(super) fn again(&self, known: &Core) -> Core {
        let mut core = self.without_values();
        core.orbit.clone_from(&known.orbit);
        core.constants.extend_from_slice(&known.constants);
        core.angles.extend_from_slice(&known.angles);
        for constant in &self.constants[known.constants.len()..] {
            core.follow(&self.angles[..constant.angles]);
            let value = match &constant.origin {
                Origin::Given => constant.value,
                Origin::Formula(formula) => core.formula_value(formula),
                Origin::At(instant) => core.instant_value(instant),
            };
            core.constants.push(Constant { value, ..constant.clone() });
        }
        core.follow(&self.angles);
        core
    }

    /// Follows the angles of another motion that are not followed yet.
    fn follow(&mut self, angles: &[Arc<Angle>]) {
        while let Some(angle) = angles.get(self.angles.len()) {
            let followed = Angle::follow(self, angle.turns, angle.raw.clone());
            self.angles.push(Arc::new(followed));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::estimate::Estimation;
    use super::super::motion::{Setup, Source};
    use super::*;
    use crate::flow_support::World;

    /// What motions of one kind are given by, as text: parameters, and initial values in these.
    type Numbers<'n> = ([(&'n str, &'n str); 2], [(&'n str, &'n str); 2]);

    /// The same, read.
    type Pairs = Vec<(Leaf, Expr)>;

    const WANTED: [&str; 9] = ["x", "y'", "w", "e", "e@0", "e@1", "phi", "phi'", "phi@2"];
    const TIMES: [f64; 7] = [0.0, 0.3, 1.0, 2.0, 3.7, 4.99, 5.0];

    fn of(w: &mut World, (parameters, initial): Numbers) -> (Pairs, Pairs) {
        (w.pairs(&parameters), w.pairs(&initial))
    }

    /// The motion and the searches along it, made the long way.
    fn alone(w: &mut World, field: &VectorField, numbers: Numbers) -> (Motion, Sought) {
        let (parameters, initial) = of(w, numbers);
        let setup = Setup {
            time: w.leaf("t"),
            span: (0.0, 5.0),
            initial_time: 0.0,
            parameters,
            source: Source::Integrated { field, initial, start: Default::default() },
            observables: w.observables(&[("e", "x^2+y^2+k*x^4/2"), ("phi~", "atan2(y,x)")]),
        };
        let mut motion = Motion::new(&mut w.graph, setup).unwrap();
        w.prepare(&mut motion, &WANTED);
        let sought = ["x", "e-e@0+x*y", "phi-3"].map(|e| w.e(e));
        let rapid = ["exp(9*x*y)", "y/(x-2)"].map(|e| w.e(e));
        let searches = motion.searches(&mut w.graph, (&sought, &rapid), (0.0, 5.0)).unwrap();
        (motion, (searches.zeros.into_iter().map(Result::unwrap).collect(), searches.rapid))
    }

    /// All that is seen of a motion, to the last bit.
    fn seen((motion, (searches, rapid)): &(Motion, Sought)) -> String {
        let at = TIMES.map(|t| motion.at(t));
        let along: Vec<_> = (0..TIMES.len()).map(|i| motion.along(&TIMES).row(i)).collect();
        let zeros: Vec<_> = searches.iter().map(|search| search.zeros()).collect();
        let duals = TIMES.map(|t| motion.dual_at(t));
        let rapid = rapid.rapid([0, 1], &TIMES);
        format!(
            "{at:?} {along:?} {zeros:?} {rapid:?} {duals:?} {:?} {:?} {}",
            motion.error(),
            motion.span(),
            motion.steps()
        )
    }

    #[test]
    fn what_is_made_after_a_pattern_is_what_it_is_alone() {
        let mut w = World::default();
        // What the parameters make up by themselves is a constant, too.
        let field = w.field(&["x", "y"], &["x' = w*y", "y' = 0-sqrt(w^2+k)*x*(1+k*x^2)"]).unwrap();
        let numbers = |w, k, x, y| ([("w", w), ("k", k)], [("x", x), ("y", y)]);
        let first = numbers("1", "0.5", "1", "w/2");
        let (motion, sought) = alone(&mut w, &field, first);
        let (parameters, initial) = of(&mut w, first);
        let template = Template::of(motion, sought, &w.graph, (&parameters, &initial)).unwrap();
        let mut all = Vec::new();
        for (one, two, x, y) in [
            ("1", "0.5", "1", "w/2"),
            ("1.7", "0.5", "1", "w/2"),
            ("1", "0.1", "0.3", "w/2+k"),
            ("0.2", "3", "0-2/3", "sqrt(w)"),
        ] {
            let numbers = numbers(one, two, x, y);
            let (parameters, initial) = of(&mut w, numbers);
            let mut graph = w.graph.clone();
            let mut draft = template.draft(&mut graph, &field, (&parameters, &initial)).unwrap();
            assert!(Draft::integrate([&mut draft], Estimation::Companions, &|| false));
            let made = seen(&template.finish(draft, |_| (0.0, 5.0)).unwrap());
            assert!(made == seen(&alone(&mut w, &field, numbers)), "{one} {two} {x} {y}");
            all.push(made);
        }
        all.dedup();
        assert_eq!(all.len(), 4, "each motion is another one");
    }

    #[test]
    fn what_may_come_out_otherwise_is_not_made() {
        let mut w = World::default();
        let field = w.field(&["x", "y"], &["x' = w*y", "y' = 0-w*x*(1+k*x^2)"]).unwrap();
        let first = ([("w", "1"), ("k", "0.5")], [("x", "1"), ("y", "1/k")]);
        let (motion, sought) = alone(&mut w, &field, first);
        let (parameters, initial) = of(&mut w, first);
        let template = Template::of(motion, sought, &w.graph, (&parameters, &initial)).unwrap();
        let draft = |(parameters, initial): (Pairs, Pairs)| {
            let mut graph = w.graph.clone();
            template.draft(&mut graph, &field, (&parameters, &initial)).is_some()
        };
        assert!(draft((parameters.clone(), initial.clone())));
        let (swapped, fewer) = ([parameters[1], parameters[0]].to_vec(), parameters[..1].to_vec());
        assert!(!draft((swapped, initial.clone())), "the constants have another order");
        assert!(!draft((fewer, initial.clone())), "a parameter has no value");
        assert!(!draft((parameters.clone(), initial[..1].to_vec())), "a state has no value");
        let none = of(&mut w, ([("w", "1"), ("k", "0")], [("x", "1"), ("y", "1/k")]));
        let mut graph = w.graph.clone();
        assert!(template.draft(&mut graph, &field, (&none.0, &none.1)).is_none(), "1/0");
    }
}
