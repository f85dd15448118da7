//! Members of a family as one pattern with other numbers.
//!
//! **In:** a trajectory, with what is asked of its motion, made once; then trajectories that differ from it in the numbers that they are
//! given by. **Out:** their motions. **Guaranteed:** each is what [`Stage`](crate::stage::Stage) makes of it alone: what cannot be made
//! after the pattern is made the long way.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::derivation::{Derivation, Motion as Given};
use crate::expr::{Expr, Graph, Leaf, Symbol};
use crate::flow::{Draft, FlowError, Motion, Sampler, Template};
use crate::number::Bounded;
use crate::setup::{initial_values, parameters, setup};
use crate::stage::{Built, Requests, closed_values, prepare};
use crate::systems::Fields;

/// A trajectory, made as the pattern of others.
pub struct Pattern {
    template: Template,
    system: usize,
    known: Vec<Symbol>,
    asked: Vec<Leaf>,
    places: Vec<Option<usize>>,
    /// What is searched for, in the order of the searches.
    searched: Vec<Expr>,
    /// What may vary rapidly, in the order of that search.
    rapid: Vec<Expr>,
    /// The values of parameters that other motions have, too.
    given: BTreeMap<Vec<Expr>, Vec<Bounded>>,
}

impl Pattern {
    /// The pattern that a trajectory is. Those made after it have the graph, or what it becomes later.
    pub fn of(
        derivation: &Derivation,
        fields: &Fields,
        requests: &Requests,
        trajectory: usize,
        graph: &mut Graph,
    ) -> Option<Pattern> {
        let of = &derivation.trajectories[trajectory];
        let Given::Integrated { system, initial, start: None } = &of.motion else { return None };
        let (setup, known) = setup(derivation, fields, graph, of, None, false, requests.idle);
        let motion = Motion::new(graph, setup).ok()?;
        let built = prepare(derivation, requests, graph, trajectory, motion, known).ok()?;
        let Built { motion, known, asked, places, searches, rapid, given, .. } = built;
        let written = of.parameters.iter().map(|(_, w)| w.value.clone());
        let given = written.zip(given).map(|(written, (_, values))| (written, values)).collect();
        let motion = Arc::into_inner(motion)?;
        let (searched, searches): (Vec<Expr>, Vec<_>) = searches.into_iter().unzip();
        let (parameters, initial) = (parameters(graph, of, false), initial_values(graph, initial));
        let template = Template::of(motion, (searches, rapid.1), graph, (&parameters, &initial))?;
        Some(Pattern { template, system: *system, known, asked, places, searched, rapid: rapid.0, given })
    }

    /// The position of every wanted leaf in a point of such a motion.
    pub(crate) fn places(&self) -> &[Option<usize>] {
        &self.places
    }

    /// What finds the leaves of such motions.
    pub(crate) fn sampler(&self) -> Option<Sampler> {
        self.template.sampler()
    }

    /// A motion after the pattern, set up; nothing where that is to be done the long way.
    pub(crate) fn draft(
        &self,
        derivation: &Derivation,
        fields: &Fields,
        graph: &mut Graph,
        trajectory: usize,
    ) -> Option<Draft> {
        let of = &derivation.trajectories[trajectory];
        let Given::Integrated { system, initial, start: None } = &of.motion else { return None };
        let field = fields.fields.get(*system).filter(|_| *system == self.system)?;
        let (parameters, initial) = (parameters(graph, of, false), initial_values(graph, initial));
        self.template.draft(graph, field, (&parameters, &initial))
    }

    /// The motion with everything that is asked of it.
    pub(crate) fn finish(
        &self,
        derivation: &Derivation,
        graph: &Graph,
        trajectory: usize,
        draft: Draft,
    ) -> Result<Built, FlowError> {
        let of = &derivation.trajectories[trajectory];
        let within = |motion: &Motion| {
            let reached = motion.span();
            (reached.0.max(of.span.0), reached.1.min(of.span.1))
        };
        let (motion, (searches, rapid)) = self.template.finish(draft, within)?;
        let given = |e: &Vec<Expr>| self.given.get(e).cloned().unwrap_or_else(|| closed_values(graph, e));
        let searches: BTreeMap<_, _> = self.searched.iter().copied().zip(searches).collect();
        Ok(Built {
            span: within(&motion),
            motion: Arc::new(motion),
            known: self.known.clone(),
            asked: self.asked.clone(),
            places: self.places.clone(),
            initial_time: of.initial_time,
            given: of.parameters.iter().map(|(s, w)| (*s, given(&w.value))).collect(),
            searches,
            rapid: (self.rapid.clone(), rapid),
            samples: Arc::default(),
        })
    }
}
