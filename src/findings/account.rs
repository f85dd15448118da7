//! What a check hands to the reports: every number that a report shows, computed.

use crate::alone::AloneAccount;
use crate::conditions::ConditionsAccount;
use crate::family::{FamilyAccount, MeasureAccount};
use crate::identity::IdentityEvidence;
use crate::picture::PictureAccount;
use crate::recorded::{Grounds, Recorded};
use crate::region::RegionAccount;
use crate::search::DrawnAccount;
use crate::standing::{Decision, Exception, Finding, Given};
use crate::variant::{Discrimination, VariantAccount};
use crate::words::{self, Word};
use derivation::Claim;
use reason::{Decided, Premises, Proviso, Reach, Reason, Refuting, Term, Unproved, Way};
use serde::{Deserialize, Serialize};
use units::UnitsAccount;
use verdict::{Outcome, PartShown, Strength, Verdict};

use std::collections::HashMap;
use std::sync::Arc;

/// A trajectory as it was computed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TrajectoryAccount {
    /// Its id in the derivation file.
    pub id: String,
    /// Its title; the id where none is given.
    pub title: String,
    /// First and last time.
    pub span: (f64, f64),
    /// `integrated`, `formula` or `derived`.
    #[serde(deserialize_with = "words::source")]
    pub source: Word,
    /// Parameters and initial values: LaTeX name, values in order of components.
    pub given: Vec<(String, Vec<f64>)>,
    /// Steps of the integrator, 0 for closed formulas.
    pub steps: usize,
    /// Largest error estimate of a state component over the span.
    pub error: f64,
    /// Why the trajectory ends early or could not be computed.
    pub problem: Option<String>,
}

/// A measured quantity on one trajectory: one entry for each time at which it was taken.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Measurement {
    /// Id of the measure.
    pub measure: String,
    /// Id of the trajectory.
    pub trajectory: String,
    /// (time, value, error bound).
    pub values: Vec<(f64, f64, f64)>,
    /// Why there is none, or not all.
    pub reason: Option<Reason>,
}

/// One claim on one trajectory.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PairAccount {
    /// Id of the trajectory.
    pub trajectory: String,
    /// The verdict.
    pub verdict: Verdict,
    /// The word that the derivation file expects, if it expects one.
    #[serde(deserialize_with = "words::expected")]
    pub expected: Option<Word>,
    /// How many altered formulas the same evidence rejects, where the claim holds.
    pub discrimination: Option<Discrimination>,
}

impl PairAccount {
    /// Whether the verdict differs from what the file expects; without an expectation, whether the claim fails. Where the
    /// file expects that samples leave it open, an enclosure may decide.
    pub fn is_unexpected(&self) -> bool {
        let enclosed =
            matches!(self.verdict.outcome(), Outcome::Holds(s) | Outcome::Fails(s) if s == Strength::Enclosed);
        match self.expected {
            Some("undecided") if enclosed => false,
            Some(word) => word != self.verdict.outcome().word(),
            None => matches!(self.verdict.outcome(), Outcome::Fails(_)),
        }
    }
}

impl RegionAccount {
    /// Whether the verdict differs from what the file expects; without an expectation, whether the claim fails.
    pub fn is_unexpected(&self) -> bool {
        match self.expected {
            Some(word) => word != self.verdict.outcome().word(),
            None => matches!(self.verdict.outcome(), Outcome::Fails(_)),
        }
    }
}

/// One verdict on a claim: on a trajectory, on the members of a family, or over its ranges.
#[derive(Clone, Copy, Debug)]
pub struct Judged<'a> {
    /// Id of the trajectory; `None` for a family and for ranges.
    pub trajectory: Option<&'a str>,
    /// The family.
    pub family: Option<&'a FamilyAccount>,
    /// The verdict.
    pub verdict: &'a Verdict,
    /// The word that the derivation file expects, if it expects one.
    pub expected: Option<&'static str>,
    /// Whether it differs from what is expected.
    pub unexpected: bool,
}

impl Judged<'_> {
    /// What it was tried on, in a word.
    pub fn on(&self) -> &str {
        self.trajectory.or(self.family.map(|f| f.family.as_str())).unwrap_or("its ranges")
    }
}

/// The results on each trajectory, by its id: the positions of the claim and of the result. To look for each would take the square of
/// their number.
pub fn by_trajectory(claims: &[ClaimAccount]) -> HashMap<&str, Vec<(usize, usize)>> {
    let mut out: HashMap<&str, Vec<(usize, usize)>> = HashMap::new();
    for (k, claim) in claims.iter().enumerate() {
        for (at, pair) in claim.results.iter().enumerate() {
            out.entry(&pair.trajectory).or_default().push((k, at));
        }
    }
    out
}

impl ClaimAccount {
    /// What was found on each trajectory, by its id: where all are asked for.
    pub fn on_each(&self) -> HashMap<&str, &PairAccount> {
        self.results.iter().map(|pair| (pair.trajectory.as_str(), pair)).collect()
    }

    /// What was found on a trajectory.
    pub fn on(&self, trajectory: &str) -> Option<&PairAccount> {
        self.results.iter().find(|pair| pair.trajectory == trajectory)
    }

    /// Every verdict on the claim: those on trajectories and families, or the one over its ranges.
    pub fn verdicts(&self) -> impl Iterator<Item = Judged<'_>> {
        let pairs = self.results.iter().map(|p| Judged {
            trajectory: Some(&p.trajectory),
            family: None,
            verdict: &p.verdict,
            expected: p.expected,
            unexpected: p.is_unexpected(),
        });
        let families = self.families.iter().map(|f| Judged {
            trajectory: None,
            family: Some(f),
            verdict: &f.verdict,
            expected: f.expected,
            unexpected: f.is_unexpected(),
        });
        pairs.chain(families).chain(self.region.iter().map(|r| Judged {
            trajectory: None,
            family: None,
            verdict: &r.verdict,
            expected: r.expected,
            unexpected: r.is_unexpected(),
        }))
    }
}

/// Which assumptions of a claim its proof uses.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct AssumptionsUsed {
    /// Without these it fails, or leaves something out.
    pub used: Vec<String>,
    /// It holds without these.
    pub unused: Vec<String>,
}

/// A claim as a step of the derivation: whether it holds for every value of every symbol, given what it follows from.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct IdentityAccount {
    /// What was decided, and of what: only `Finding::weigh` makes one.
    pub finding: Finding,
    /// Claims that it follows from, through all steps, which are not proved themselves; assumptions of those that it does not
    /// make. What is proved is proved given these.
    pub conditional_on: Vec<Given>,
    /// log₂ of the bound for the probability that a proof is wrong.
    pub log2_error: Option<f64>,
    /// What was given beside definitions and assumptions: ids of claims and systems.
    pub from: Vec<String>,
    /// What has to hold for the formulas to have values.
    pub conditions: Vec<Proviso>,
    /// What the proof does not reach: special cases, and what it takes for granted of motions.
    pub exceptions: Vec<Proviso>,
    /// Where alone what is given can hold, special cases aside.
    pub given_only_where: Vec<Proviso>,
    /// Of the claim's assumptions, those that the proof uses; `None` where that was not looked at.
    pub assumptions: Option<AssumptionsUsed>,
    /// Assumptions of what is given, which this claim does not make itself.
    pub presupposed: Vec<String>,
    /// Equations that the claim assumes at the times that it chooses, and that are not known at others.
    pub assumed_at_times: Vec<String>,
    /// Whether the proof leaves out special cases of what is given.
    pub generic: bool,
    /// Why undecided; a remark on a proof.
    pub reason: Option<Reason>,
    /// Parts of the claim that state or deny equations, by their positions, with what is shown of them.
    pub parts: Vec<(usize, PartShown)>,
    /// What that follows from: what is given, and for motions the system that they are integrated from.
    pub parts_from: Vec<String>,
    /// Whether that is a defect: the program contradicts itself, or stopped in the middle of the proof.
    pub is_defect: bool,
    /// A point at which everything given holds and the claim does not.
    pub witness: Option<Refuting>,
    /// What the verdict rests on: trials, certificates, numbers.
    pub evidence: IdentityEvidence,
    /// The proof as steps that anybody can replay, or why there is none; nothing where none was looked for.
    pub recorded: Option<Recorded>,
}

impl IdentityAccount {
    /// The word of the report contract: `proved`, `refuted` or `undecided`. A proof that leaves a case out is `proved` here: see
    /// [`IdentityAccount::standing`].
    pub fn verdict(&self) -> &'static str {
        self.finding.decision().contract_word()
    }

    /// Whether it is proved for all values: no case is left out, nothing that it follows from is open, and nothing is assumed there
    /// that is not assumed here.
    pub fn is_proved(&self) -> bool {
        self.finding.decision() == Decision::Proved && self.conditional_on.is_empty() && self.presupposed.is_empty()
    }

    /// The same, as the prover says at least.
    pub fn is_shown(&self) -> bool {
        self.finding.is_whole()
            && self.exceptions.is_empty()
            && self.conditional_on.is_empty()
            && self.presupposed.is_empty()
    }

    /// Whether it is proved for all values, by the prover at least, given postulates alone: what is left out, assumed on the way, or not proved itself, is open.
    pub(crate) fn is_proved_by_postulates(&self) -> bool {
        let is_shown = |given: &Given| given.postulated || given.standing == Some(Decision::Unreplayed.word());
        let postulated = self.conditional_on.iter().all(is_shown);
        self.finding.is_whole() && self.exceptions.is_empty() && postulated && self.presupposed.is_empty()
    }

    /// The account, once the checker has replayed the proof, or has not.
    #[must_use]
    pub fn replayed(mut self, recorded: Recorded) -> IdentityAccount {
        self.finding = std::mem::take(&mut self.finding).replayed(&recorded);
        if self.finding.exceptions().is_empty() {
            self.exceptions.extend(recorded.left_out_words().map(|words| Proviso::Written(words.into())));
        }
        self.recorded = Some(recorded);
        self
    }

    /// The account, with the claim left undecided, for a reason, and what the proof that does not count leaves out.
    #[must_use]
    pub fn left_open(self, reason: Reason) -> IdentityAccount {
        let IdentityAccount { from, assumed_at_times, exceptions, presupposed, .. } = self;
        IdentityAccount {
            from,
            assumed_at_times,
            exceptions,
            presupposed,
            reason: Some(reason),
            ..IdentityAccount::default()
        }
    }

    /// Whether the claim holds on every motion on which what it follows from holds exactly, as the prover says at least. What is said of poles and of
    /// denominators is no exception on integrated motions, which are analytic.
    pub fn holds_on_motions(&self) -> bool {
        let analytic = |e: &Exception| matches!(e, Exception::Divides(_));
        let finding = &self.finding;
        finding.is_proved_in_part() && finding.exceptions().iter().all(analytic) && self.presupposed.is_empty()
    }

    /// The same, as the checker says.
    pub fn lends_strength(&self) -> bool {
        let is_replayed = self.recorded.as_ref().is_some_and(|recorded| recorded.grounds() == Grounds::Checker);
        is_replayed && self.holds_on_motions()
    }

    /// Whether what is shown of its parts holds on every motion on which what it follows from holds exactly.
    pub fn lends_parts(&self) -> bool {
        !self.parts.is_empty() && self.presupposed.is_empty()
    }

    /// The verdict in full: `proved`, `proved except`, `proved given`, each of them `unreplayed` where the prover alone says so; `refuted`, `undecided`.
    pub fn standing(&self) -> &'static str {
        match self.finding.decision() {
            Decision::Proved if !self.is_proved() => "proved given",
            Decision::Unreplayed if !self.finding.is_whole() => "proved except unreplayed",
            Decision::Unreplayed if !self.is_shown() => "proved given unreplayed",
            decision => decision.word(),
        }
    }

    /// What a proof needs and leaves out: each list that is not empty.
    pub fn terms(&self) -> Vec<(Term, Vec<Proviso>)> {
        let written = |all: &[String]| all.iter().map(|text| Proviso::Written(text.as_str().into())).collect();
        let mut out = vec![
            (Term::Condition, self.conditions.clone()),
            (Term::Exception, self.exceptions.clone()),
            (Term::GivenOnlyWhere, self.given_only_where.clone()),
            (Term::Presupposed, written(&self.presupposed)),
        ];
        if let Some(AssumptionsUsed { used, unused }) = &self.assumptions {
            out.push((Term::Used, written(used)));
            out.push((Term::Unused, written(unused)));
        }
        out.retain(|(_, lines)| !lines.is_empty());
        out
    }

    /// The verdict with what it rests on; its words are one sentence.
    pub fn decided(&self) -> Decided {
        let given = Premises(self.from.clone());
        let assumed = self.presupposed.iter().map(|text| Unproved::Assumed(text.clone()));
        let open = self.conditional_on.iter().map(|g| match g.standing {
            None => Unproved::NotAsked(g.name.clone()),
            Some(word) => Unproved::Standing(g.name.clone(), word.to_owned()),
        });
        let open = open.chain(assumed);
        let way = match self.log2_error {
            Some(_) if self.evidence.trials.is_none() => Way::Algebraic,
            Some(bound) => Way::Random(bound),
            None => Way::Signs,
        };
        match self.finding.decision() {
            Decision::Proved => Decided::Proved { reach: Reach::Whole, open: open.collect(), way, given },
            Decision::ProvedExcept => Decided::Proved { reach: Reach::Except, open: open.collect(), way, given },
            Decision::Unreplayed => Decided::Proved { reach: Reach::Unreplayed, open: open.collect(), way, given },
            Decision::Refuted => Decided::Refuted(given),
            Decision::Undecided => Decided::Undecided { given, reason: self.reason.clone().map(Arc::new) },
        }
    }
}

/// One claim, or one reading of it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ClaimAccount {
    /// Id of the claim.
    pub id: String,
    /// Id of the reading, for claims that have several.
    pub reading: Option<String>,
    /// What it says, in the file's words.
    pub says: String,
    /// Where it stands in the paper.
    pub place: Option<String>,
    /// Its formulas as written.
    pub formulas: Vec<String>,
    /// Its assumptions as written.
    pub assumptions: Vec<String>,
    /// The remark of the file on it: what a reader should know.
    pub remark: Option<String>,
    /// Whether it holds for all values, where it is a claim of that kind.
    pub identity: Option<IdentityAccount>,
    /// Under which condition it holds, and which of its assumptions it needs.
    pub conditions: ConditionsAccount,
    /// One entry per trajectory, in the order of the file.
    pub results: Vec<PairAccount>,
    /// One entry for each family on which it is tried, in the order of the file.
    pub families: Vec<FamilyAccount>,
    /// For a claim over ranges, which has no trajectories: its verdict.
    pub region: Option<RegionAccount>,
    /// When what its step came to is its verdict; `None` for claims over ranges.
    pub alone: Option<AloneAccount>,
    /// What single edits of its formulas say of the evidence, where they were tried.
    pub variants: Option<VariantAccount>,
    /// For a claim that holds on every motion of the file and is not proved: how it fares on others.
    pub drawn: Option<DrawnAccount>,
}

/// Everything that was found for one derivation file.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Account {
    /// The trajectories, in the order of the file.
    pub trajectories: Vec<TrajectoryAccount>,
    /// Claims and readings, in the order of the file.
    pub claims: Vec<ClaimAccount>,
    /// Measurements, in the order of the file.
    pub measurements: Vec<Measurement>,
    /// What was measured over families, family by family.
    pub distributions: Vec<MeasureAccount>,
    /// Whether the formulas are consistent in their units.
    #[serde(skip)]
    pub units: UnitsAccount,
    /// Pictures, in the order of the file: for each, those of the trajectories.
    pub pictures: Vec<PictureAccount>,
}

/// Counts over all pairs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Summary {
    /// Pairs that hold, and claims that are decided by their steps and do.
    pub holds: usize,
    /// Pairs that fail, and claims that are decided by their steps and do.
    pub fails: usize,
    /// Pairs to which the claim does not apply.
    pub not_applicable: usize,
    /// Pairs that stay undecided, and claims that are tried on nothing and do.
    pub undecided: usize,
    /// Pairs that stay undecided although the file does not say so: it expects nothing of them.
    pub open: usize,
    /// Pairs that differ from what the file expects, and claims that are tried on nothing and do.
    pub unexpected: usize,
}

impl Account {
    /// The claims that have no verdict because the program contradicts itself: name, what it was tried on, why.
    pub fn defects(&self) -> impl Iterator<Item = (String, String, &Reason)> {
        self.claims.iter().flat_map(|claim| {
            let name = claim.reading.as_ref().map_or(claim.id.clone(), |r| format!("{}/{r}", claim.id));
            let step = claim.identity.iter().filter(|step| step.is_defect);
            let step = step.filter_map(|step| step.reason.as_ref()).map(|why| ("all values".to_owned(), why));
            let tried = claim.verdicts().filter_map(|j| Some((j.on().to_owned(), j.verdict.defect()?)));
            step.chain(tried).map(move |(on, why)| (name.clone(), on, why))
        })
    }

    /// The counts.
    pub fn summary(&self) -> Summary {
        let mut s = Summary::default();
        for pair in self.claims.iter().flat_map(ClaimAccount::verdicts) {
            match pair.verdict.outcome() {
                Outcome::Holds(_) => s.holds += 1,
                Outcome::Fails(_) => s.fails += 1,
                Outcome::NotApplicable(_) => s.not_applicable += 1,
                Outcome::Undecided => {
                    s.undecided += 1;
                    s.open += usize::from(pair.expected.is_none());
                }
            }
            s.unexpected += usize::from(pair.unexpected);
        }
        for claim in &self.claims {
            match claim.verdict_alone() {
                Some("holds") => s.holds += 1,
                Some("fails") => s.fails += 1,
                Some(_) => s.undecided += 1,
                None => {}
            }
            s.unexpected += usize::from(claim.is_unexpected_alone());
        }
        s
    }
}

impl ClaimAccount {
    /// What a file says of a claim, with its verdicts on trajectories.
    pub fn of(claim: &Claim, results: Vec<PairAccount>) -> ClaimAccount {
        ClaimAccount {
            id: claim.id.clone(),
            reading: claim.reading.clone(),
            says: claim.says.clone(),
            place: claim.place.clone(),
            formulas: claim.formulas.iter().map(|f| f.text.clone()).collect(),
            assumptions: claim.assuming.iter().map(|w| w.text.clone()).collect(),
            remark: claim.remark.clone(),
            identity: None,
            conditions: Default::default(),
            results,
            families: Vec::new(),
            region: None,
            alone: None,
            variants: None,
            drawn: None,
        }
    }
}
