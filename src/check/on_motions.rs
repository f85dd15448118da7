//! The claims, tried on every motion.
//!
//! **In:** what was compiled, and the motions. **Out:** what each motion says ([`OnMotion`]), put together in the order of the file
//! ([`Found`]).
//!
//! **How:** motions are independent of one another, and are tried in parallel; of each the values are forgotten that nobody will ask for.
//! **Guaranteed:** what is found does not depend on the number of threads. That a claim failed elsewhere only spares questions whose
//! answers would not be used.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use super::compilation::Compiled;
use super::memory::Question;
use super::premises::Column;
use super::run::Run;
use super::{picture, pieces};
use claim::error::{CANCELLED, CheckError};
use derivation::Derivation;
use findings::{Account, AloneAccount, ClaimAccount, Measurement, PairAccount, PictureAccount, Premises};
use flow::Motion;
use meter::{Ended, Limits, Task};
use sampled::claim_program::Prepared;
use sampled::same_motion;
use sampled::selection::Selection;
use sampled::stage::Stage;
use sampled::trace::{Trace, Trial};
use sampled::trial::try_claim;
use verdict::{Outcome, Verdict};
use weight::separation::{Motions, OneMotion};
use weight::variant::{self, Altered, Weighed};

/// What is needed to try claims on motions.
pub(super) struct OnMotions<'a, 'r> {
    pub run: &'r Run<'r>,
    pub selection: &'r Selection,
    pub altered: Option<&'r Altered>,
    pub compiled: &'a Compiled<'a>,
    pub stage: &'a Stage,
}

/// What was found on one motion.
#[derive(Default)]
struct OnMotion<'a> {
    verdicts: Column,
    /// Whether the claims were tried on it: its work may have ended before.
    is_tried: bool,
    /// The verdicts without each assumption.
    without: Vec<Option<Verdict>>,
    /// What it says of the altered formulas.
    weighed: Option<Weighed>,
    measurements: Vec<Measurement>,
    pictures: Vec<PictureAccount>,
    /// The motion, where it is asked again.
    trace: Option<Trace<'a>>,
}

/// What was found on all motions, in the order of the file.
#[derive(Default)]
pub(super) struct Found<'a> {
    pub columns: Vec<Column>,
    /// Motions that the claims were not tried on, since their work ended: of these there is nothing but verdicts.
    pub untried: usize,
    pub without: Vec<Vec<Option<Verdict>>>,
    pub weighed: Vec<Weighed>,
    pub traces: Vec<Trace<'a>>,
    measurements: Vec<Measurement>,
    pictures: Vec<PictureAccount>,
}

impl<'a> OnMotions<'a, '_> {
    /// Tries all claims on all motions.
    ///
    /// # Errors
    /// The run was cancelled; the program contradicts itself.
    pub fn all(&self) -> Result<Found<'a>, CheckError> {
        let tried = &self.selection.tried;
        let wanted = &self.compiled.wanted;
        let same_motion = same_motion::leaves(&self.compiled.derivation);
        let mut kept: Vec<usize> = self.compiled.probes.asked_later().collect();
        kept.extend(same_motion.into_iter().filter_map(|leaf| wanted.binary_search(&leaf).ok()));
        kept.sort_unstable();
        kept.dedup();
        let done = AtomicUsize::new(0);
        let failed: Vec<AtomicBool> = self.compiled.prepared.iter().map(|_| AtomicBool::new(false)).collect();
        // Long motions first: what is left at the end is short.
        let mut order: Vec<usize> = (0..tried.len()).collect();
        order.sort_by_key(|&at| std::cmp::Reverse(self.stage.motion(tried[at]).map_or(0, Motion::steps)));
        let one = |&at: &usize, limits: &Limits| (at, self.one(tried[at], limits, &kept, (&failed, &done)));
        let mut found = meter::each(&self.run.options.limits, &order, one);
        found.sort_by_key(|(at, _)| *at);
        let mut out = Found::default();
        for (_, one) in found {
            let OnMotion { verdicts, is_tried, without, weighed, measurements, pictures, trace } =
                one.map_err(CheckError::Defect)?;
            out.untried += usize::from(!is_tried);
            out.columns.push(verdicts);
            out.without.push(without);
            out.weighed.extend(weighed);
            out.traces.extend(trace);
            out.measurements.extend(measurements);
            out.pictures.extend(pictures);
        }
        Ok(out)
    }

    /// Tries all claims on the motion of a trajectory. `kept` are the leaves whose values are asked for later, by their positions;
    /// `failed` marks the claims that have failed on some motion.
    fn one(
        &self,
        t: usize,
        limits: &Limits,
        kept: &[usize],
        (failed, done): (&[AtomicBool], &AtomicUsize),
    ) -> Result<OnMotion<'a>, String> {
        let Compiled { derivation, prepared, probes, measures, pictures, wanted, .. } = self.compiled;
        let recall = &self.run.recall;
        let start = self.selection.start_of[t];
        if limits.is_cancelled() {
            return Err(CANCELLED.to_owned());
        }
        let open = |ended: Ended| {
            let is_open = |c: &usize| derivation.claims[*c].trajectories.binary_search(&t).is_ok();
            let open = |(c, of): (&usize, &Vec<Prepared>)| {
                is_open(c).then(|| pieces::undecided(|why| of[start].program.open(why), ended.clone()))
            };
            let verdicts = self.selection.claims.iter().zip(prepared).map(open).collect();
            Ok(OnMotion { verdicts, ..OnMotion::default() })
        };
        let ended = || self.stage.ended(t).cloned().or_else(|| limits.reached());
        if let Some(ended) = ended().filter(|_| self.stage.motion(t).is_none()) {
            return open(ended);
        }
        // Where the two routes to the values of a motion disagree, no claim has a verdict on it; the others have theirs.
        let sample = || {
            let trace = self.stage.sampled(t, wanted)?;
            let compare = || self.stage.contradiction(&derivation.graph, &trace);
            let contradiction = recall.answer(derivation, Question::Contradiction(t), compare);
            Ok::<_, String>((trace, contradiction))
        };
        let (mut trace, contradiction) = match meter::piece(Task::Motion, limits, sample) {
            Ok(trace) => trace?,
            Err(ended) => return open(ended),
        };
        let verdict = |of: &Vec<Prepared>| {
            let Prepared { claim, program, gradients } = &of[start];
            claim.trajectories.binary_search(&t).is_ok().then(|| {
                if let Some(reached) = limits.reached() {
                    return pieces::undecided(|why| program.open(why), reached);
                }
                let trial = Trial { graph: &derivation.graph, claim, program, trace: &trace, shown: true };
                let sampled = Question::Sampled { claim, whole: &claim.name(), without: None, motion: t };
                let mut verdict = recall.answer(derivation, sampled, || {
                    pieces::verdict(
                        Task::Sampling,
                        limits,
                        |why| program.open(why),
                        || try_claim(derivation, &trial, gradients.as_ref()),
                    )
                });
                if let Some(contradiction) = &contradiction {
                    verdict.contradict(contradiction.clone());
                }
                verdict
            })
        };
        let verdicts: Column = prepared.iter().map(verdict).collect();
        let fails = |v: &Option<Verdict>| v.as_ref().is_some_and(|v| matches!(v.outcome(), Outcome::Fails(_)));
        verdicts.iter().zip(failed).filter(|(v, _)| fails(v)).for_each(|(_, f)| f.store(true, Ordering::Relaxed));
        // The motion is at hand now. Whether it is asked depends on the others, too: most claims that fail do so on the first.
        let motion = OneMotion { prepared, start, trace: &trace, verdicts: &verdicts, failed };
        let without = meter::piece(Task::Weighing, limits, || probes.without_each(derivation, &motion, recall));
        let weighed = self.altered.map(|altered| {
            let late = limits.reached().is_some();
            let claims = prepared.iter().zip(&verdicts).map(|(of, verdict)| {
                let Prepared { claim, program, .. } = &of[start];
                verdict.clone().filter(|_| !late).map(|verdict| variant::Found { claim, program, verdict })
            });
            let claims: Vec<_> = claims.collect();
            let weigh = |claims: &[_]| altered.weigh(&derivation.graph, start, &trace, claims);
            let nothing = || claims.iter().map(|_| None).collect::<Vec<_>>();
            meter::piece(Task::Weighing, limits, || weigh(&claims)).unwrap_or_else(|_| weigh(&nothing()))
        });
        let take = || measures.iter().filter_map(|m| m.take(derivation, &trace)).collect();
        let measurements = meter::piece(Task::Sampling, limits, take).unwrap_or_default();
        let draw = || picture::draw(derivation, &trace);
        let drawn = (!pictures.is_empty()).then(|| meter::piece(Task::Sampling, limits, draw));
        let pictures = drawn.and_then(Result::ok).unwrap_or_default();
        let without = without.unwrap_or_else(|_| probes.without_none());
        // One that is tried once more is not one more.
        let count = self.selection.tried.len();
        (self.run.progress)(count.min(done.fetch_add(1, Ordering::Relaxed) + 1), count);
        // What is asked later needs few of the leaves; those of all motions at once take much memory.
        trace.keep(kept);
        let trace = (!probes.is_empty() || self.altered.is_some()).then_some(trace);
        Ok(OnMotion { verdicts, is_tried: true, without, weighed, measurements, pictures, trace })
    }
}

impl Found<'_> {
    /// The motions that are asked what separates them.
    pub fn motions<'f>(&'f self, selection: &'f Selection) -> Motions<'f> {
        Motions { without: &self.without, traces: &self.traces, start_of: &selection.start_of }
    }

    /// The account: the verdicts by claim, with what was measured and drawn, which is taken out.
    pub fn account(&mut self, derivation: &Derivation, selection: &Selection, stage: &Stage) -> Account {
        let mut claims = Vec::with_capacity(selection.claims.len());
        let premises = Premises::of(derivation);
        for (k, &c) in selection.claims.iter().enumerate() {
            let claim = &derivation.claims[c];
            let pair = |(column, &t): (&Column, &usize)| {
                let verdict = column[k].clone()?;
                let expected = claim.trajectories.binary_search(&t).ok().and_then(|i| claim.expect[i]);
                let trajectory = derivation.trajectories[t].id.clone();
                Some(PairAccount { trajectory, verdict, expected, discrimination: None })
            };
            let mut results: Vec<PairAccount> = self.columns.iter().zip(&selection.tried).filter_map(pair).collect();
            results.shrink_to_fit();
            let alone = AloneAccount::within(derivation, &premises, c);
            claims.push(ClaimAccount { alone, ..ClaimAccount::of(claim, results) });
        }
        let trajectories = selection.tried.iter().filter_map(|&t| stage.account(derivation, t)).collect();
        let mut measurements = std::mem::take(&mut self.measurements);
        measurements.sort_by_key(|m| derivation.measures.iter().position(|x| x.id == m.measure));
        let pictures = std::mem::take(&mut self.pictures);
        Account { trajectories, claims, measurements, pictures, ..Account::default() }
    }
}
