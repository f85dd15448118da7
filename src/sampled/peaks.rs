//! What varies between the samples more rapidly than they are dense.
//!
//! A motion is sampled so densely that its states are seen; a formula of the states may still hide a peak, or a step, between two
//! samples: e^u is 0 for a reader wherever u is far below 0, tanh u is 1 wherever it is far above, and 10⁻²⁴/u is 0 unless u is. What
//! can be seen at the samples is u itself ([`flow::Rapid`]): where it moves by much, the claim is tried in between.
//!
//! **In:** what is known of parts of a claim from all samples. **Out:** what is known of them with the times in between, which are
//! found once, and only if something holds at all samples.

use std::cell::OnceCell;
use std::sync::Arc;

use crate::describe::{Describer, Left};
use crate::flow::{Points, Rapid};
use crate::pointwise::selected;
use crate::trace::Trial;
use crate::verdict::{Evidence, Finding, Possible, Truth};
use crate::weakening::{known, reopened};
use crate::weigh::weigh;
use claim::sides::{MeasuredGroup, Measurements, measure};
use reason::Plain;

/// Which of the measured groups is meant.
pub(super) type Of<'a> = &'a dyn for<'m, 'p> Fn(&'m Measurements<'p>) -> &'m MeasuredGroup<'p>;

/// A claim, measured at further times.
pub(super) struct Further<'a> {
    times: Vec<f64>,
    points: Arc<Points>,
    measured: Measurements<'a>,
    left: Vec<Left>,
}

impl<'a> Further<'a> {
    /// Measures a claim at further times, which was measured `along` the samples; `None` where none of them counts.
    pub(super) fn new(
        trial: &Trial<'a>,
        along: &Measurements,
        times: Vec<f64>,
        points: Arc<Points>,
    ) -> Option<Further<'a>> {
        let measured = measure(trial.program, &points, Some(along));
        let left = selected(trial, &measured, &Describer::new(trial, &times, &points));
        left.contains(&Left::In).then_some(Further { times, points, measured, left })
    }

    /// What is known of a part, or of an assumption, at these times.
    pub(super) fn weigh(&self, trial: &Trial, of: Of) -> Finding {
        let describer = Describer::new(trial, &self.times, &self.points);
        weigh(describer.setting(self.left.clone()), of(&self.measured))
    }
}

/// What a claim is at times in between.
struct Found<'a> {
    times: Option<Further<'a>>,
    singular: Option<Further<'a>>,
    unresolved: bool,
}

/// A claim on a motion, measured `along` the samples, of which peaks are looked for between them.
pub(super) struct Peaks<'a, 't> {
    trial: &'t Trial<'a>,
    pub(super) along: &'t Measurements<'a>,
    found: OnceCell<Found<'a>>,
}

impl<'a, 't> Peaks<'a, 't> {
    /// Nothing is looked for yet.
    pub(super) fn new(trial: &'t Trial<'a>, along: &'t Measurements<'a>) -> Peaks<'a, 't> {
        Peaks { trial, along, found: OnceCell::new() }
    }

    fn found(&self) -> &Found<'a> {
        self.found.get_or_init(|| {
            let Peaks { trial, along, .. } = *self;
            let Rapid { times, singular, unresolved } = trial.trace.rapid(&trial.program.rapid);
            let further = |times: Vec<f64>| {
                let points = (!times.is_empty()).then(|| trial.trace.points_between(trial.program, &times))?;
                Further::new(trial, along, times, points)
            };
            let [times, singular] = [times, singular].map(further);
            Found { times, singular, unresolved: unresolved.is_some() }
        })
    }

    /// Tries a part, or an assumption, at further times, where it may vary rapidly between the samples.
    pub(super) fn look(&self, of: Of, finding: Finding) -> Finding {
        let holds = match known(&finding).decided() {
            Some(Truth::True) => true,
            None => false,
            Some(Truth::False | Truth::Void) => return finding,
        };
        let found = self.found();
        let at = |further: &Option<Further>| further.as_ref().map(|further| further.weigh(self.trial, of));
        // Near what is divided by 0, errors may be larger than what is asked for: what is false there for certain counts.
        if let Some(closer) = at(&found.singular).filter(|closer| known(closer) == Possible::FALSE) {
            return closer;
        }
        let closer = at(&found.times);
        let seen = closer.as_ref().and_then(|closer| known(closer).decided());
        if holds && found.unresolved && seen != Some(Truth::False) {
            return reopened(finding, Possible::OPEN, Plain::TooManyPeaks);
        }
        let Some(closer) = closer else { return finding };
        match seen {
            Some(Truth::False) => closer,
            None if holds => closer,
            Some(Truth::True) if holds => {
                let samples = finding.evidence().samples + closer.evidence().samples;
                let within = finding.evidence().within.max(closer.evidence().within);
                Finding::sampled(Possible::TRUE, Evidence { samples, within, ..finding.evidence().clone() })
            }
            _ => finding,
        }
    }
}
