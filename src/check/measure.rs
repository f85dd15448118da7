//! Quantities that are measured, not judged.

use super::account::Measurement;
use super::denote::at_event;
use super::describe::incomplete;
use super::occasion;
use super::trial::Course;
use crate::derivation::{Derivation, Event};
use crate::expr::tape::Tape;
use crate::expr::{Expr, Graph, Leaf};

/// Most values that are kept of one measure on one motion.
const MOST: usize = 200;

/// A measure, compiled.
pub(super) struct Compiled {
    index: usize,
    formula: Expr,
    /// What vanishes at the events at which it is taken.
    pub at: Option<Expr>,
    tape: Option<Tape>,
}

/// Compiles all measures; none when only some claims are asked for.
pub(super) fn compile(derivation: &mut Derivation, wanted: bool) -> Vec<Compiled> {
    let Derivation { graph, measures, .. } = derivation;
    if !wanted {
        return Vec::new();
    }
    let one = |(index, m): (usize, &derivation::Measure)| {
        let formula = m.formula.value.as_scalar()?;
        let at = m.at.as_ref().and_then(|at| at_event(graph, &at.equation.value));
        Some(Compiled { index, formula, at, tape: None })
    };
    measures.iter().enumerate().filter_map(one).collect()
}

impl Compiled {
    /// The leaves that must be known.
    pub fn leaves(&self, graph: &Graph) -> Vec<Leaf> {
        graph.leaves([self.formula].into_iter().chain(self.at))
    }

    /// Whether it is asked for on a motion.
    pub fn is_taken_on(&self, derivation: &Derivation, trajectory: usize) -> bool {
        derivation.measures.get(self.index).is_some_and(|m| m.trajectories.contains(&trajectory))
    }

    /// Makes the tape.
    pub fn tape(mut self, graph: &mut Graph, known: &[Leaf]) -> Compiled {
        self.tape = Tape::compile(graph, known, &[self.formula]).ok();
        self
    }

    /// Takes the measure on a motion; `None` when it is not asked for there.
    pub fn take(&self, derivation: &Derivation, course: &Course) -> Option<Measurement> {
        let trajectory = course.trajectory;
        let measure = derivation.measures.get(self.index)?;
        if !measure.trajectories.contains(&trajectory) {
            return None;
        }
        let mut out = Measurement {
            measure: measure.id.clone(),
            trajectory: derivation.trajectories[trajectory].id.clone(),
            values: Vec::new(),
            reason: None,
        };
        let times = match self.at {
            None => vec![(derivation.trajectories[trajectory].initial_time, None)],
            Some(_) => {
                let text = measure.at.as_ref().map_or("", |at| at.equation.text.as_str());
                let event = measure.at.as_ref().zip(self.at);
                match event.and_then(|(at, e)| occasion::of_event(&derivation.graph, at, e, course)) {
                    Some(found) => {
                        let zeros = &found.zeros;
                        let partial = zeros.incomplete.first();
                        out.reason =
                            partial.map(|p| format!("the search for `{text}` is incomplete: {}", incomplete(p)));
                        if let (true, Some(t)) = (zeros.times.is_empty(), zeros.touching.first()) {
                            out.reason = Some(format!("the sides of `{text}` only touch, near t = {t:.6}"));
                        }
                        if found.doubt.is_some() {
                            out.reason.clone_from(&found.doubt);
                        }
                        if zeros.times.is_empty() && out.reason.is_none() {
                            let event = measure.at.as_ref().map(Event::says).unwrap_or_default();
                            out.reason = Some(format!("{event} does not happen on this motion"));
                        }
                        zeros.times.iter().copied().zip(zeros.slack.iter().copied().map(Some)).collect()
                    }
                    None => {
                        out.reason = Some(format!("`{text}` has no meaning on this motion"));
                        Vec::new()
                    }
                }
            }
        };
        let Some(tape) = &self.tape else {
            out.reason = Some("the measure depends on something that motions do not have".to_owned());
            return Some(out);
        };
        let mut slots = tape.slots(&());
        for &(t, slack) in times.iter().take(MOST) {
            let point = match slack {
                Some(slack) => course.values_at_event(t, slack),
                None => course.values(t),
            };
            let values = tape.evaluate(&(), &point, &mut slots);
            match values.first() {
                Some(Ok(v)) => out.values.push((t, v.value, v.error)),
                Some(Err(reason)) => out.reason = Some(format!("no value at t = {t:.6}: {reason}")),
                None => {}
            }
        }
        if times.len() > MOST {
            out.reason = Some(format!("{} further events are not listed", times.len() - MOST));
        }
        Some(out)
    }
}
