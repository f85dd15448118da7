//! Quantities that are measured, not judged.

use super::account::Measurement;
use super::program::at_event;
use super::trial::Course;
use crate::derivation::Derivation;
use crate::expr::{Expr, Graph, Leaf};
use crate::tape::Tape;

/// Most values that are kept of one measure on one motion.
const MOST: usize = 200;

/// A measure, compiled.
pub(super) struct Compiled {
    index: usize,
    formula: Expr,
    at: Option<Expr>,
    tape: Option<Tape>,
}

/// Compiles all measures; none when only some claims are asked for.
pub(super) fn compile(derivation: &mut Derivation, wanted: bool) -> Vec<Compiled> {
    let Derivation { graph, measures, .. } = derivation;
    if !wanted {
        return Vec::new();
    }
    let one = |(index, m): (usize, &crate::derivation::Measure)| {
        let formula = m.formula.value.as_scalar()?;
        let at = m.at.as_ref().and_then(|w| at_event(graph, &w.value));
        Some(Compiled { index, formula, at, tape: None })
    };
    measures.iter().enumerate().filter_map(one).collect()
}

impl Compiled {
    /// The leaves that must be known.
    pub fn leaves(&self, graph: &Graph) -> Vec<Leaf> {
        graph.leaves([self.formula].into_iter().chain(self.at))
    }

    /// Makes the tape.
    pub fn tape(mut self, graph: &mut Graph, known: &[Leaf]) -> Compiled {
        self.tape = Tape::compile(graph, known, &[self.formula]).ok();
        self
    }

    /// Takes the measure on a motion; `None` when it is not asked for there.
    pub fn take(&self, derivation: &Derivation, course: &Course, trajectory: usize) -> Option<Measurement> {
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
            None => vec![derivation.trajectories[trajectory].initial_time],
            Some(at) => {
                let zeros = course.motion.zeros(&derivation.graph, at);
                out.reason = zeros.incomplete.as_ref().map(|p| format!("the search for events is incomplete: {p}"));
                if zeros.times.is_empty() && out.reason.is_none() {
                    let text = measure.at.as_ref().map_or("", |w| w.text.as_str());
                    out.reason = Some(format!("`{text}` does not happen on this motion"));
                }
                zeros.times
            }
        };
        let Some(tape) = &self.tape else {
            out.reason = Some("the measure depends on something that motions do not have".to_owned());
            return Some(out);
        };
        let mut slots = tape.slots(&());
        for &t in times.iter().take(MOST) {
            let values = tape.evaluate(&(), &course.motion.at(t).values, &mut slots);
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
