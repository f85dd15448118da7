//! Verdicts. Their fields are private: only this room can make one.

use std::sync::Arc;

use super::series::Residuals;

/// How strong the evidence is; ordered, weakest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Strength {
    /// At finitely many times, residual against its error bound.
    Sampled,
    /// For every time in the span, with rounding accounted for (a `fails` of this strength is called certified).
    Enclosed,
    /// An identity, for all parameter values.
    Proved,
}

/// What was found for one claim on one trajectory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// The claim holds, with this strength.
    Holds(Strength),
    /// The claim fails, with this strength; a witness is always given.
    Fails(Strength),
    /// An assumption is unmet, or a formula has no real value there; a reason is always given.
    NotApplicable,
    /// The evidence does not settle it; a reason is always given.
    Undecided,
}

impl Outcome {
    /// The word of the report contract.
    pub fn word(self) -> &'static str {
        match self {
            Outcome::Holds(_) => "holds",
            Outcome::Fails(_) => "fails",
            Outcome::NotApplicable => "not-applicable",
            Outcome::Undecided => "undecided",
        }
    }

    /// The strength in the words of the report contract, for `holds` and `fails`.
    pub fn strength(self) -> Option<&'static str> {
        match self {
            Outcome::Holds(Strength::Sampled) | Outcome::Fails(Strength::Sampled) => Some("sampled"),
            Outcome::Holds(Strength::Enclosed) => Some("enclosed"),
            Outcome::Fails(Strength::Enclosed) => Some("certified"),
            Outcome::Holds(Strength::Proved) | Outcome::Fails(Strength::Proved) => Some("proved"),
            Outcome::NotApplicable | Outcome::Undecided => None,
        }
    }
}

/// The worst point of a comparison: where |left − right| is largest in units of what it is compared with.
#[derive(Clone, Debug, PartialEq)]
pub struct Residual {
    /// |left − right| at that point.
    pub max: f64,
    /// Its propagated error bound there.
    pub bound: f64,
    /// The time.
    pub at: f64,
}

/// A point that a reader can check by hand.
#[derive(Clone, Debug, PartialEq)]
pub struct Witness {
    /// The time.
    pub t: f64,
    /// The formula that is compared, as written, with its component: `t9[1]`, `\dot R_{12}`.
    pub formula: String,
    /// Value of the left side; not a number where it has none.
    pub left: f64,
    /// Value of the right side; not a number where it has none.
    pub right: f64,
    /// Error bound of their difference.
    pub bound: f64,
    /// Values that the two sides depend on: LaTeX name, value.
    pub values: Vec<(String, f64)>,
}

impl Witness {
    /// How far the sides are apart: |left − right|, of the very numbers that are shown.
    pub fn difference(&self) -> f64 {
        (self.left - self.right).abs()
    }
}

/// A stretch of time that was left out, and why.
#[derive(Clone, Debug, PartialEq)]
pub struct Exclusion {
    /// First excluded sample.
    pub from: f64,
    /// Last excluded sample.
    pub to: f64,
    /// Why, in words.
    pub reason: String,
}

/// What a verdict rests on.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Evidence {
    /// Number of times at which the claim was compared.
    pub samples: usize,
    /// The worst point, where something was compared.
    pub residual: Option<Residual>,
    /// The refuting point of a `fails`, the found point of an `eventually`.
    pub witness: Option<Witness>,
    /// Why not applicable or undecided; a remark on a `holds`.
    pub reason: Option<String>,
    /// Times left out.
    pub excluded: Vec<Exclusion>,
    /// For a claim with ±: which sign, `+`, `-`, or `either`, and where it changes.
    pub branch: Option<String>,
    /// The deciding comparison along the motion, thinned for drawing.
    pub series: Option<Arc<Residuals>>,
}

/// The verdict of one claim (in one reading) on one trajectory.
#[derive(Clone, Debug, PartialEq)]
pub struct Verdict {
    outcome: Outcome,
    evidence: Evidence,
}

impl Verdict {
    /// Makes a verdict; the invariants of [`Outcome`] are checked here, once.
    pub(super) fn new(outcome: Outcome, evidence: Evidence) -> Verdict {
        let complete = match outcome {
            Outcome::Holds(_) => evidence.samples > 0,
            Outcome::Fails(_) => evidence.witness.is_some(),
            Outcome::NotApplicable | Outcome::Undecided => evidence.reason.is_some(),
        };
        if complete {
            return Verdict { outcome, evidence };
        }
        let reason = format!("a verdict `{}` was reached without its evidence", outcome.word());
        Verdict { outcome: Outcome::Undecided, evidence: Evidence { reason: Some(reason), ..evidence } }
    }

    /// The verdict on a claim over ranges; `samples` is the number of cells that were judged. The witness of a `fails` is in the
    /// account of the region, since it has no time.
    pub(super) fn of_region(outcome: Outcome, reason: String, samples: usize) -> Verdict {
        Verdict { outcome, evidence: Evidence { samples, reason: Some(reason), ..Evidence::default() } }
    }

    /// The same verdict with its witness completed, and another curve where one is given: what it shows, not what it means.
    pub(super) fn show(&mut self, witness: Witness, series: Option<Arc<Residuals>>) {
        if self.evidence.witness.is_some() {
            self.evidence.witness = Some(witness);
            self.evidence.series = series.or(self.evidence.series.take());
        }
    }

    /// The same verdict with a proof behind it.
    pub(super) fn proved(&mut self) {
        match self.outcome {
            Outcome::Holds(_) => self.outcome = Outcome::Holds(Strength::Proved),
            // What samples left open is settled where there was something to compare.
            Outcome::Undecided if self.evidence.samples > 0 => {
                self.outcome = Outcome::Holds(Strength::Proved);
                self.evidence.reason = None;
            }
            Outcome::Undecided | Outcome::Fails(_) | Outcome::NotApplicable => {}
        }
    }

    /// What was found.
    pub fn outcome(&self) -> Outcome {
        self.outcome
    }

    /// What it rests on.
    pub fn evidence(&self) -> &Evidence {
        &self.evidence
    }
}
