//! Claims that hold beyond any doubt on motions that are made after one pattern.
//!
//! **In:** the claims of a family, compiled, and its pattern; then one motion after the other. **Out:** that all of them hold, or
//! nothing. **Guaranteed:** a claim that is said to hold is found to hold by [`try_claim`](crate::trial::try_claim), with errors that
//! are estimated otherwise, too: see [`claim::screen`].

use claim::program::{Program, What};
use claim::screen::{Margins, Screen};
use reason::Plain;

use crate::derivation::Claim;
use crate::expr::{Graph, Leaf};
use crate::flow::Sampler;
use crate::pattern::Pattern;
use crate::pointwise::ROUNDING;
use crate::stage::Stage;
use crate::trace::near;
use crate::verdict::{Evidence, Finding, Possible, Verdict};

/// Claims, ready to be tried on the motions of a pattern.
#[derive(Clone)]
pub struct Screens {
    sampler: Sampler,
    /// Each with its verdict where it holds: of such a motion nothing else is kept.
    claims: Vec<(Screen, Verdict)>,
}

impl Screens {
    /// The claims of a family, each with its programs, the first of which is that of its members. Sides must be well within their
    /// error bound: `within` is the largest share of it. Nothing where one of the claims is of another kind.
    pub fn of<'p>(
        graph: &Graph,
        pattern: &Pattern,
        claims: impl IntoIterator<Item = (&'p Claim, &'p [Program])>,
        wanted: &[Leaf],
        within: f64,
    ) -> Option<Screens> {
        let sampler = pattern.sampler()?;
        let one = |(claim, programs): (&Claim, &[Program])| {
            let [program] = programs else { return None };
            let margins = Margins { precision: claim.precision, rounding: ROUNDING, within };
            let screen = Screen::of(program, graph, (wanted, pattern.places()), margins)?;
            let finding = |what: &What| match what {
                What::Value => Finding::open(Plain::NothingByItself),
                _ => Finding::sampled(Possible::TRUE, Evidence { samples: 1, ..Evidence::default() }),
            };
            let findings = program.parts.iter().map(|part| finding(&part.what)).collect();
            let verdict = Verdict::decide(program.claim.clone(), findings);
            (verdict.defect().is_none() && verdict.outcome().truth() == Some(true)).then_some((screen, verdict))
        };
        let claims = claims.into_iter().map(one).collect::<Option<Vec<_>>>()?;
        Some(Screens { sampler, claims })
    }

    /// The verdicts on a motion, if all claims hold on it beyond any doubt.
    pub fn verdicts(&mut self, stage: &Stage, trajectory: usize) -> Option<Vec<Verdict>> {
        let built = stage.built(trajectory)?;
        let motion = built.motion.as_ref();
        let whole = motion.problem().is_none() && motion.unresolved().is_empty() && motion.corners().is_empty();
        if !whole || motion.leaps() || !motion.is_by_steps() || built.samples.get().is_some() {
            return None;
        }
        let times = built.sample_times();
        let mut holds = |(screen, _): &mut (Screen, Verdict)| {
            screen.holds(&mut self.sampler, (motion, built.initial_time), &times, |at| near(&times, at))
        };
        self.claims.iter_mut().all(&mut holds).then(|| self.claims.iter().map(|(_, verdict)| verdict.clone()).collect())
    }
}
