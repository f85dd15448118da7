//! What was found of a claim on a family: counts, and the members that tell most.

use super::confidence::{CONFIDENCE, failing_share};
use crate::derivation::{Derivation, Family};
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
    /// How many members were tried.
    pub members: u64,
    /// How many points of a grid, or draws, did not satisfy the constraints.
    pub rejected: u64,
    /// On how many it holds.
    pub holds: u64,
    /// On how many it fails.
    pub fails: u64,
    /// To how many it does not apply.
    pub not_applicable: u64,
    /// On how many it is undecided.
    pub undecided: u64,
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

/// A member that is kept until all are known.
struct Kept {
    number: u64,
    values: Vec<f64>,
    verdict: Verdict,
    measure: f64,
}

/// The counts of one claim, member by member.
pub(super) struct Tally {
    size: u64,
    /// What the claim asks for.
    precision: f64,
    pub members: u64,
    pub rejected: u64,
    holds: u64,
    fails: u64,
    not_applicable: u64,
    undecided: u64,
    first_failing: Option<Kept>,
    clearest: Option<Kept>,
    closest: Option<Kept>,
    first_undecided: Option<Kept>,
    defect: Option<String>,
    /// Why the members that are left were not tried.
    pub stopped: Option<String>,
}

/// How far the sides of a refuting point are apart, in units of the error bound of their difference. Rounding alone is an error.
fn deviation(verdict: &Verdict) -> f64 {
    let Some(w) = &verdict.evidence().witness else { return -1.0 };
    let rounding = f64::EPSILON * (w.left.abs() + w.right.abs());
    let found = w.difference() / w.bound.max(rounding).max(f64::MIN_POSITIVE);
    if found.is_nan() { 0.0 } else { found }
}

/// How close the sides of an inequality come, in units of the size of their terms, at the samples that are kept.
fn gap(verdict: &Verdict, precision: f64) -> Option<f64> {
    let series = verdict.evidence().series.as_ref().filter(|s| !s.equation && !s.sought)?;
    let gaps = series.points.iter().filter(|p| p.limit > 0.0).map(|p| p.residual / (p.limit / precision));
    gaps.reduce(f64::min).filter(|gap| gap.is_finite())
}

impl Tally {
    pub fn new(size: u64, precision: f64) -> Tally {
        Tally {
            size,
            precision,
            members: 0,
            rejected: 0,
            holds: 0,
            fails: 0,
            not_applicable: 0,
            undecided: 0,
            first_failing: None,
            clearest: None,
            closest: None,
            first_undecided: None,
            defect: None,
            stopped: None,
        }
    }

    /// Counts a member; members come in the order of their numbers, and of equals the first is kept.
    pub fn count(&mut self, number: u64, values: &[f64], verdict: Verdict) {
        self.members += 1;
        if let (None, Some(defect)) = (&self.defect, verdict.defect()) {
            self.defect = Some(format!("member {number}: {defect}"));
        }
        let kept = |measure: f64, verdict: Verdict| Kept { number, values: values.to_vec(), verdict, measure };
        match verdict.outcome() {
            Outcome::Holds(_) => {
                self.holds += 1;
                let gap = gap(&verdict, self.precision);
                if let Some(gap) = gap.filter(|gap| self.closest.as_ref().is_none_or(|c| *gap < c.measure)) {
                    self.closest = Some(kept(gap, verdict));
                }
            }
            Outcome::Fails(_) => {
                self.fails += 1;
                let far = deviation(&verdict);
                if self.first_failing.is_none() {
                    self.first_failing = Some(kept(far, verdict.clone()));
                }
                if self.clearest.as_ref().is_none_or(|c| far > c.measure) {
                    self.clearest = Some(kept(far, verdict));
                }
            }
            Outcome::NotApplicable(_) => self.not_applicable += 1,
            Outcome::Undecided => {
                self.undecided += 1;
                if self.first_undecided.is_none() {
                    self.first_undecided = Some(kept(0.0, verdict));
                }
            }
        }
    }

    /// What is known of all members together. It fails where it fails on one; it holds where it holds on all to which it applies.
    fn verdict(&self) -> Verdict {
        if let Some(defect) = &self.defect {
            let mut verdict = Verdict::of(Finding::open(defect.clone()));
            verdict.contradict(defect.clone());
            return verdict;
        }
        let samples = usize::try_from(self.members).unwrap_or(usize::MAX);
        let open = |reason: String| Evidence { samples, ..Evidence::because(reason) };
        let of = self.members;
        let finding = match (self.fails, self.undecided, &self.stopped, self.holds) {
            (1.., ..) => {
                let witness = self.clearest.as_ref().and_then(|c| c.verdict.evidence().witness.clone());
                let reason = format!("it fails on {} of {of} members", self.fails);
                Finding::sampled(Possible::FALSE, Evidence { witness, ..open(reason) })
            }
            (0, _, Some(stopped), _) => {
                Finding::sampled(Possible::ANY, open(format!("{of} of {} members were tried: {stopped}", self.size)))
            }
            (0, 1.., None, _) => {
                let reason = format!("it is undecided on {} of {of} members", self.undecided);
                Finding::sampled(Possible::ANY, open(reason))
            }
            (0, 0, None, 1..) => Finding::sampled(Possible::TRUE, Evidence { samples, ..Evidence::default() }),
            (0, 0, None, 0) => Finding::sampled(Possible::VOID, open(format!("it applies to none of {of} members"))),
        };
        Verdict::of(finding)
    }

    /// The account of it.
    pub fn account(self, derivation: &Derivation, family: &Family, expected: Option<&'static str>) -> FamilyAccount {
        let is_taken = |id: &str| {
            derivation.trajectories.iter().any(|t| t.id == id) || derivation.families.iter().any(|f| f.id == id)
        };
        let verdict = self.verdict();
        let told = |kept: Kept| MemberAccount {
            number: kept.number,
            values: family.vary.iter().map(|v| v.name.clone()).zip(kept.values.iter().copied()).collect(),
            verdict: kept.verdict,
            toml: family.toml(&family.member_id(kept.number, is_taken), kept.number, &kept.values),
        };
        let (failures, draws) = (self.fails + self.undecided, self.members - self.not_applicable);
        let is_sample = family.is_drawn() && self.stopped.is_none() && self.defect.is_none() && draws > 0;
        let share =
            || FailingShare { at_most: failing_share(failures, draws), confidence: CONFIDENCE, failures, draws };
        FamilyAccount {
            family: family.id.clone(),
            title: family.title.clone(),
            verdict,
            expected,
            size: self.size,
            members: self.members,
            rejected: self.rejected,
            holds: self.holds,
            fails: self.fails,
            not_applicable: self.not_applicable,
            undecided: self.undecided,
            closest_gap: self.closest.as_ref().map(|c| c.measure),
            first_failing: self.first_failing.map(told),
            clearest_failing: self.clearest.map(told),
            closest_call: self.closest.map(told),
            first_undecided: self.first_undecided.map(told),
            failing_share: is_sample.then(share),
            stopped: self.stopped,
        }
    }
}
