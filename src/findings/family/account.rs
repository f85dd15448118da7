//! What was found of a claim, or of a measure, on a family: counts, and the members that tell most.

use super::distribution::Distribution;
use super::map::FamilyMap;
use super::slope::SlopeAccount;
use super::tally::Counts;
use crate::account::Measurement;
use crate::conditions::Explanation;
use crate::words::{self, Word};
use reason::Reason;
use serde::{Deserialize, Serialize};
use verdict::{Outcome, Verdict};

/// A member that a reader wants to see.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
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
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
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
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Exception {
    /// What varies, in LaTeX, with its values.
    pub values: Vec<(String, f64)>,
    /// Whether the claim holds on it.
    pub holds: bool,
    /// It as a `[[trajectory]]` of a derivation file.
    pub toml: String,
}

/// What separates the members on which a claim holds from those on which it fails.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
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
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FamilyAccount {
    /// Id of the family.
    pub family: String,
    /// Its title.
    pub title: String,
    /// The verdict on all members together, at most *sampled*.
    pub verdict: Verdict,
    /// The word that the derivation file expects, if it expects one.
    #[serde(deserialize_with = "words::expected")]
    pub expected: Option<Word>,
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
    pub stopped: Option<Reason>,
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
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
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
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
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
    pub stopped: Option<Reason>,
}

/// A member that was tried.
pub struct Row<'a> {
    /// Its number.
    pub number: u64,
    /// The values of what varies.
    pub values: &'a [f64],
    /// The verdicts, in the order of the claims.
    pub verdicts: &'a [Verdict],
    /// What was measured, in the order of the measures.
    pub measured: &'a [Measurement],
}
