//! What was found of a claim, or of a measure, on a family: counts, and the members that tell most.
//!
//! **In:** a [`Tally`] or a [`Distribution`], and the members that it names, tried again. **Out:** a [`FamilyAccount`] or a
//! [`MeasureAccount`]. **Guaranteed:** a member is shown
//! only as what it was counted as, so that a tally that was made elsewhere, by another program or of another file, is seen.

use super::confidence::{CONFIDENCE, failing_share};
use super::distribution::Distribution;
use super::map::{Boundary, FamilyMap, Scale};
use super::slope::SlopeAccount;
use super::tally::{Counts, Ranked, Tally, deviation, gap};
use crate::check::separation::Explanation;
use crate::derivation::{Derivation, Family, Measure};
use crate::verdict::{Evidence, Finding, Outcome, Possible, Verdict};

/// A member that a reader wants to see.
#[derive(Clone, Debug, PartialEq)]
pub struct MemberAccount {
    /// Its number, the first of which is 1.
    pub number: u64,
    /// What varies, in LaTeX, with its values.
    pub values: Vec<(String, f64)>,
    /// The verdict on it.
    pub verdict: Verdict,
    /// The member as a `[[trajectory]]` of a derivation file.
    pub toml: String,
}

/// An upper bound for the share of members that fail.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FailingShare {
    /// At most so many of all members that could be drawn, and to which the claim applies, fail.
    pub at_most: f64,
    /// With this confidence.
    pub confidence: f64,
    /// How many of those that were drawn fail, or may fail since they are undecided.
    pub failures: u64,
    /// To how many of those that were drawn the claim applies, or may apply.
    pub draws: u64,
}

/// A fresh member on which a condition says something else than what is so.
#[derive(Clone, Debug, PartialEq)]
pub struct Exception {
    /// What varies, in LaTeX, with its values.
    pub values: Vec<(String, f64)>,
    /// Whether the claim holds on it.
    pub holds: bool,
    /// It as a `[[trajectory]]` of a derivation file.
    pub toml: String,
}

/// What separates the members on which a claim holds from those on which it fails.
#[derive(Clone, Debug, PartialEq)]
pub struct FamilySeparation {
    /// The simplest condition that was found; `None` where none of those that were tried separates them.
    pub explanation: Option<Explanation>,
    /// On how many of the members that were looked at it holds, and on how many it fails.
    pub sides: (usize, usize),
    /// On how many fresh members the condition is met just where the claim holds.
    pub right: usize,
    /// On how many it is met where the claim fails, or the other way round.
    pub wrong: usize,
    /// On how many one of the two is undecided, or does not apply.
    pub open: usize,
    /// The first on which it is wrong.
    pub exception: Option<Exception>,
}

/// One claim on one family.
#[derive(Clone, Debug, PartialEq)]
pub struct FamilyAccount {
    /// Id of the family.
    pub family: String,
    /// Its title.
    pub title: String,
    /// The verdict on all members together, at most *sampled*.
    pub verdict: Verdict,
    /// The word that the derivation file expects, if it expects one.
    pub expected: Option<&'static str>,
    /// How many members there are to be, before constraints.
    pub size: u64,
    /// On how many members it holds, fails, does not apply, is undecided.
    pub counts: Counts,
    /// The failing member with the smallest number.
    pub first_failing: Option<MemberAccount>,
    /// The failing member whose sides are furthest apart, in units of the error bound of their difference.
    pub clearest_failing: Option<MemberAccount>,
    /// Of the members on which an inequality holds, the one whose sides come closest, against the size of their terms.
    pub closest_call: Option<MemberAccount>,
    /// How close they come: the difference of the sides, in units of the size of their terms.
    pub closest_gap: Option<f64>,
    /// The undecided member with the smallest number.
    pub first_undecided: Option<MemberAccount>,
    /// What the counts say of members that were not drawn; `None` where members are no sample.
    pub failing_share: Option<FailingShare>,
    /// Why not all members were tried.
    pub stopped: Option<String>,
    /// Where it holds and where it fails, over two of the symbols that vary.
    pub map: Option<FamilyMap>,
    /// Which condition separates the members on which it holds from those on which it fails.
    pub separation: Option<FamilySeparation>,
    /// The slope of a scaling law over all members.
    pub slope: Option<SlopeAccount>,
}

impl FamilyAccount {
    /// Whether the verdict differs from what the file expects; without an expectation, whether the claim fails.
    pub fn is_unexpected(&self) -> bool {
        match self.expected {
            Some(word) => word != self.verdict.outcome().word(),
            None => matches!(self.verdict.outcome(), Outcome::Fails(_)),
        }
    }
}

/// A member with a value of a measure.
#[derive(Clone, Debug, PartialEq)]
pub struct ExtremeAccount {
    /// Its number.
    pub number: u64,
    /// What varies, in LaTeX, with its values.
    pub values: Vec<(String, f64)>,
    /// The value of the measure.
    pub value: f64,
    /// The member as a `[[trajectory]]` of a derivation file.
    pub toml: String,
}

/// One measure over one family.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasureAccount {
    /// Id of the measure.
    pub measure: String,
    /// Id of the family.
    pub family: String,
    /// How its values are distributed.
    pub distribution: Distribution,
    /// The least value.
    pub least: Option<ExtremeAccount>,
    /// The greatest value.
    pub greatest: Option<ExtremeAccount>,
    /// Why not all members were tried.
    pub stopped: Option<String>,
}

/// A value that was measured: its time, the value, its error bound.
type Taken = (f64, f64, f64);

/// What is known of a measure over a family, from which its account is made.
pub(super) struct Spreading<'a> {
    pub measure: &'a Measure,
    pub distribution: &'a Distribution,
    /// Why the members that are left were not tried.
    pub stopped: Option<&'a str>,
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
            stopped: self.stopped.map(str::to_owned),
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
    pub stopped: Option<&'a str>,
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
            let defect = again(number).and_then(|(_, verdict)| verdict.defect()).unwrap_or("it has no verdict");
            let defect = format!("member {number}: {defect}");
            let mut verdict = Verdict::of(Finding::open(defect.clone()));
            verdict.contradict(defect);
            return verdict;
        }
        let samples = usize::try_from(tally.counts.members).unwrap_or(usize::MAX);
        let open = |reason: String| Evidence { samples, ..Evidence::because(reason) };
        let of = tally.counts.members;
        let finding = match (tally.counts.fails, tally.counts.undecided, self.stopped, tally.counts.holds) {
            (1.., ..) => {
                let clearest = tally.clearest_failing.and_then(|c| again(c.number));
                let witness = clearest.and_then(|(_, verdict)| verdict.evidence().witness.clone());
                let reason = format!("it fails on {} of {of} members", tally.counts.fails);
                Finding::sampled(Possible::FALSE, Evidence { witness, ..open(reason) })
            }
            (0, _, Some(stopped), _) => {
                Finding::sampled(Possible::ANY, open(format!("{of} of {} members were tried: {stopped}", self.size)))
            }
            (0, 1.., None, _) => {
                let reason = format!("it is undecided on {} of {of} members", tally.counts.undecided);
                Finding::sampled(Possible::ANY, open(reason))
            }
            (0, 0, None, 1..) => Finding::sampled(Possible::TRUE, Evidence { samples, ..Evidence::default() }),
            (0, 0, None, 0) => Finding::sampled(Possible::VOID, open(format!("it applies to none of {of} members"))),
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
            stopped: self.stopped.map(str::to_owned),
            map: self.scales.map(|[across, up]| FamilyMap {
                across: across.axis.clone(),
                up: up.axis.clone(),
                cells: tally.map.clone(),
                boundary: self.boundary.cloned(),
            }),
            separation: self.separation.cloned(),
            slope: self.law.and_then(|(scale, power, to)| {
                tally.slopes.account(&scale.axis.name, &scale.axis.middles(), (power, to))
            }),
        })
    }
}
