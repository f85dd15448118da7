//! What was found of a claim, or of a measure, on a family: counts, and the members that tell most.
//!
//! **In:** a [`Tally`] or a [`Distribution`], and the members that it names, tried again. **Out:** a [`FamilyAccount`] or a
//! [`MeasureAccount`]. **Guaranteed:** a member is shown
//! only as what it was counted as, so that a tally that was made elsewhere, by another program or of another file, is seen.

use super::confidence::{CONFIDENCE, failing_share};
use super::map::Scale;
use crate::derivation::{Derivation, Family, Measure};
use crate::findings::family::{
    Boundary, Distribution, ExtremeAccount, FailingShare, FamilyAccount, FamilyMap, FamilySeparation, MeasureAccount,
    MemberAccount, Ranked, Tally, deviation, gap,
};
use crate::verdict::{Evidence, Finding, Outcome, Possible, Verdict};
use reason::{Fate, Plain, Reason, Sampling};
use std::sync::Arc;

/// A value that was measured: its time, the value, its error bound.
type Taken = (f64, f64, f64);

/// What is known of a measure over a family, from which its account is made.
pub(super) struct Spreading<'a> {
    pub measure: &'a Measure,
    pub distribution: &'a Distribution,
    /// Why the members that are left were not tried.
    pub stopped: Option<&'a Reason>,
}

impl Spreading<'_> {
    /// The account of it.
    ///
    /// # Errors
    /// A member that is not what it was counted as.
    pub fn account<'m>(
        &self,
        derivation: &Derivation,
        family: &Family,
        again: &dyn Fn(u64) -> Option<(&'m [f64], &'m [Taken])>,
    ) -> Result<MeasureAccount, Otherwise> {
        let told = |of: Ranked| {
            let has = |taken: &[Taken]| taken.iter().any(|(_, value, _)| *value == of.measure);
            let (values, _) = again(of.number).filter(|(_, taken)| has(taken)).ok_or(Otherwise(of.number))?;
            Ok(ExtremeAccount {
                number: of.number,
                values: family.vary.iter().map(|v| v.name.clone()).zip(values.iter().copied()).collect(),
                value: of.measure,
                toml: family.toml(&family.member_id(of.number, |id| is_taken(derivation, id)), of.number, values),
            })
        };
        Ok(MeasureAccount {
            measure: self.measure.id.clone(),
            family: family.id.clone(),
            distribution: self.distribution.clone(),
            least: self.distribution.least.map(told).transpose()?,
            greatest: self.distribution.greatest.map(told).transpose()?,
            stopped: self.stopped.cloned(),
        })
    }
}

/// Whether a trajectory or a family has an id.
fn is_taken(derivation: &Derivation, id: &str) -> bool {
    derivation.trajectories.iter().any(|t| t.id == id) || derivation.families.iter().any(|f| f.id == id)
}

/// What is known of a claim on a family, from which its account is made.
pub(super) struct Counted<'a> {
    /// How many members there are to be, before constraints.
    pub size: u64,
    /// What the claim asks for.
    pub precision: f64,
    pub tally: &'a Tally,
    /// The scales of the map, across and up.
    pub scales: Option<&'a [Scale; 2]>,
    /// The boundary on it.
    pub boundary: Option<&'a Boundary>,
    /// Why the members that are left were not tried.
    pub stopped: Option<&'a Reason>,
    /// What separates them.
    pub separation: Option<&'a FamilySeparation>,
    /// The scale of what a scaling law is along, the power, and how far it may be off.
    pub law: Option<(&'a Scale, f64, f64)>,
}

/// A member that was tried again, and turned out otherwise than it was counted.
pub(super) struct Otherwise(pub u64);

/// The values and the verdict of a member, by its number.
pub(super) type Again<'a> = &'a dyn Fn(u64) -> Option<(&'a [f64], &'a Verdict)>;

impl Counted<'_> {
    /// What is known of all members together. It fails where it fails on one; it holds where it holds on all to which it applies.
    fn verdict(&self, again: Again) -> Verdict {
        let tally = self.tally;
        if let Some(number) = tally.first_defect {
            let what = again(number).and_then(|(_, verdict)| verdict.defect().cloned());
            let what = Arc::new(what.unwrap_or(Plain::NoVerdict.into()));
            let mut verdict = Verdict::of(Finding::open(Plain::NoVerdict));
            verdict.contradict(Sampling::OnMember { number, what }.into());
            return verdict;
        }
        let samples = usize::try_from(tally.counts.members).unwrap_or(usize::MAX);
        let open = |reason: Sampling| Evidence { samples, ..Evidence::because(reason) };
        let of = tally.counts.members;
        let finding = match (tally.counts.fails, tally.counts.undecided, self.stopped, tally.counts.holds) {
            (1.., ..) => {
                let clearest = tally.clearest_failing.and_then(|c| again(c.number));
                let witness = clearest.and_then(|(_, verdict)| verdict.evidence().witness.clone());
                let reason = Sampling::OnMembers(Fate::Fails, tally.counts.fails, of);
                Finding::sampled(Possible::FALSE, Evidence { witness, ..open(reason) })
            }
            (0, _, Some(stopped), _) => {
                let why = Arc::new(stopped.clone());
                Finding::sampled(Possible::ANY, open(Sampling::NotAllTried { tried: of, of: self.size, why }))
            }
            (0, 1.., None, _) => {
                let reason = Sampling::OnMembers(Fate::Undecided, tally.counts.undecided, of);
                Finding::sampled(Possible::ANY, open(reason))
            }
            (0, 0, None, 1..) => Finding::sampled(Possible::TRUE, Evidence { samples, ..Evidence::default() }),
            (0, 0, None, 0) => Finding::sampled(Possible::VOID, open(Sampling::OnNoMember(of))),
        };
        Verdict::of(finding)
    }

    /// The account of it.
    ///
    /// # Errors
    /// A member that is not what it was counted as.
    pub fn account(
        &self,
        derivation: &Derivation,
        family: &Family,
        expected: Option<&'static str>,
        again: Again,
    ) -> Result<FamilyAccount, Otherwise> {
        let tally = self.tally;
        let told = |number: u64, is_so: &dyn Fn(&Verdict) -> bool| {
            let (values, verdict) = again(number).filter(|(_, verdict)| is_so(verdict)).ok_or(Otherwise(number))?;
            Ok(MemberAccount {
                number,
                values: family.vary.iter().map(|v| v.name.clone()).zip(values.iter().copied()).collect(),
                verdict: verdict.clone(),
                toml: family.toml(&family.member_id(number, |id| is_taken(derivation, id)), number, values),
            })
        };
        let fails = |verdict: &Verdict| matches!(verdict.outcome(), Outcome::Fails(_));
        let holds = |verdict: &Verdict| matches!(verdict.outcome(), Outcome::Holds(_));
        let open = |verdict: &Verdict| verdict.outcome() == Outcome::Undecided;
        let clearest = |r: Ranked| told(r.number, &|v| fails(v) && deviation(v) == r.measure);
        let closest = |r: Ranked| told(r.number, &|v| holds(v) && gap(v, self.precision) == Some(r.measure));
        if let Some(number) = tally.first_defect {
            told(number, &|verdict| verdict.defect().is_some())?;
        }
        let (failures, draws) =
            (tally.counts.fails + tally.counts.undecided, tally.counts.members - tally.counts.not_applicable);
        let is_sample = family.is_sample() && self.stopped.is_none() && tally.first_defect.is_none() && draws > 0;
        let share =
            || FailingShare { at_most: failing_share(failures, draws), confidence: CONFIDENCE, failures, draws };
        Ok(FamilyAccount {
            family: family.id.clone(),
            title: family.title.clone(),
            verdict: self.verdict(again),
            expected,
            size: self.size,
            counts: tally.counts,
            closest_gap: tally.closest_call.map(|c| c.measure),
            first_failing: tally.first_failing.map(|n| told(n, &fails)).transpose()?,
            clearest_failing: tally.clearest_failing.map(clearest).transpose()?,
            closest_call: tally.closest_call.map(closest).transpose()?,
            first_undecided: tally.first_undecided.map(|n| told(n, &open)).transpose()?,
            failing_share: is_sample.then(share),
            stopped: self.stopped.cloned(),
            map: self.scales.map(|[across, up]| FamilyMap {
                across: across.axis.clone(),
                up: up.axis.clone(),
                cells: tally.map.clone(),
                boundary: self.boundary.cloned(),
            }),
            separation: self.separation.cloned(),
            slope: self
                .law
                .and_then(|(scale, power, to)| tally.slopes.account(&scale.axis.name, &scale.middles(), (power, to))),
        })
    }
}
