//! The report as data: the contract that `report.json` keeps and `rederive schema report` describes.
//!
//! **In:** a [`Derivation`] and its [`Account`], for [`Report`]. **Out:** types that serde writes in the order of their fields, and of which
//! schemars makes the JSON Schema.
//!
//! A field is written once, in `objects!`: what it means, which is its description in the schema, its name, its type, and where it comes
//! from. The types are not those of `findings`: these may be renamed and put together in another way, while within one value of `schema`
//! fields are only added here.
//!
//! **Guaranteed:** what is written has all fields of the schema, and no others. A number that is none (JSON has no infinity) is `null`,
//! and the schema says so of every number but a [`Finite`](value::Finite) one.

mod claim;
mod conditions;
mod family;
mod paper;
mod proposition;
mod region;
mod steps;
mod units;
mod value;
mod variants;

use super::recorded::by_grounds;
use ::paper::Comparison;
use claim::Claim;
use derivation::Derivation;
use family::Distribution;
use findings::{Account, Grounds};
use paper::Paper;
pub(super) use proposition::Answer;
use steps::{Digest, Graph};
use units::Units;
use value::{Named, Origin, objects};
use variants::Alone;

objects! {
    #[schemars(title = "A report of rederive")]
    Report<'a> of (derivation: &'a Derivation, account: &'a Account, paper: Option<&'a Comparison>) {
        /// The version of this contract: within it fields are only added.
        #[schemars(extend("const" = 1))]
        schema: u32 = 1,
        /// What wrote the report.
        tool: Tool = Tool::of(()),
        /// The derivation file.
        derivation: File<'a> = File::of(derivation),
        /// The trajectories, in the order of the file.
        trajectories: Vec<Trajectory<'a>> = account.trajectories.iter().map(Trajectory::of).collect(),
        /// Claims and readings, in the order of the file.
        claims: Vec<Claim<'a>> = account.claims.iter().map(|c| Claim::of(derivation, c)).collect(),
        /// What follows from what.
        graph: Graph = Graph::of(derivation, account),
        /// What became of each claim as a whole, and what hangs on it.
        digest: Digest = Digest::of(derivation, account),
        /// Measured quantities, in the order of the file.
        measurements: Vec<Measurement<'a>> = account.measurements.iter().map(Measurement::of).collect(),
        /// Whether the formulas are consistent in their units.
        units: Units<'a> = Units::of(&account.units),
        /// What each motion alone could have decided; empty where no variants were tried.
        alone: Vec<Alone> = account.alone().into_iter().map(Alone::of).collect(),
        /// Counts over all verdicts.
        summary: Summary = Summary::of(account.summary()),
        /// What proofs rest on; there where steps were looked for.
        #[serde(skip_serializing_if = "Option::is_none")]
        proofs: Option<ProofsByGrounds> = (!by_grounds(account, |_| true).is_empty()).then(|| ProofsByGrounds::of(account)),
        /// What was measured over families.
        #[serde(skip_serializing_if = "Vec::is_empty")]
        distributions: Vec<Distribution<'a>> = account.distributions.iter().map(Distribution::of).collect(),
        /// The comparison with the paper, there if `--source` was given.
        #[serde(skip_serializing_if = "Option::is_none")]
        #[schemars(with = "Paper")]
        paper: Option<Paper<'a>> = paper.map(Paper::of),
    }

    /// The program.
    Tool of (_program: ()) {
        /// Its name.
        name: &'static str = crate::PROGRAM,
        /// Its version.
        version: &'static str = env!("CARGO_PKG_VERSION"),
    }

    /// A derivation file.
    File<'a> of (of: &'a Derivation) {
        /// Short name.
        id: &'a str = &of.id,
        /// Title.
        title: &'a str = &of.title,
        /// SHA-256 of the derivation file.
        sha256: &'a str = &of.sha256,
        /// The citation of what is checked.
        concerns: &'a str = &of.concerns,
        /// Where the paper can be found.
        source: Option<&'a str> = of.source.as_deref(),
        /// What a reader should know.
        remark: Option<&'a str> = of.remark.as_deref(),
        /// Who wrote the file.
        encoded_by: Option<&'a str> = of.encoded_by.as_deref(),
        /// Texts of the file, by their names.
        conventions: Named<'a, &'a str> = Named::of(&of.conventions, String::as_str),
    }

    /// A motion.
    Trajectory<'a> of (of: &'a findings::TrajectoryAccount) {
        /// Its id.
        id: &'a str = &of.id,
        /// Its title; the id where none is given.
        title: &'a str = &of.title,
        /// First and last time.
        span: [f64; 2] = of.span.into(),
        /// How it comes about.
        source: Origin = Origin(of.source),
        /// Parameters and initial values, each with its components.
        given: Named<'a, &'a [f64]> = Named::of(&of.given, Vec::as_slice),
        /// Steps of the integrator, 0 for formulas.
        steps: usize = of.steps,
        /// Largest error estimate of a state component over the span.
        error: f64 = of.error,
        /// Why it ends early or could not be computed.
        problem: Option<&'a str> = of.problem.as_deref(),
    }

    /// A measured quantity on one trajectory.
    Measurement<'a> of (of: &'a findings::Measurement) {
        /// Id of the measure.
        measure: &'a str = &of.measure,
        /// Id of the trajectory.
        trajectory: &'a str = &of.trajectory,
        /// One entry for each time at which it was taken.
        values: Vec<Measured> = of.values.iter().map(Measured::of).collect(),
        /// Why there is none, or not all.
        reason: Option<String> = of.reason.as_ref().map(ToString::to_string),
    }

    /// Claims that are proved, by what the word rests on.
    ProofsByGrounds of (of: &Account) {
        /// All steps were made again by the checker.
        replayed: Vec<String> = by_grounds(of, |grounds| grounds == Grounds::Checker),
        /// The same, but for cases.
        replayed_in_part: Vec<String> = by_grounds(of, |grounds| matches!(grounds, Grounds::CheckerBut(_))),
        /// They rest on the prover alone.
        prover_alone: Vec<String> = by_grounds(of, |grounds| grounds == Grounds::Prover),
    }

    /// A value at a time.
    Measured of (of: &(f64, f64, f64)) {
        /// The time.
        t: f64 = of.0,
        /// The value.
        value: f64 = of.1,
        /// Its error bound.
        bound: f64 = of.2,
    }

    /// Counts over all pairs of a claim and what it was tried on.
    Summary of (of: findings::Summary) {
        /// Pairs that hold, and claims that are tried on nothing and do.
        holds: usize = of.holds,
        /// Pairs that fail, and claims that are tried on nothing and do.
        fails: usize = of.fails,
        /// Pairs to which the claim does not apply.
        not_applicable: usize = of.not_applicable,
        /// Pairs that stay undecided, and claims that are tried on nothing and do.
        undecided: usize = of.undecided,
        /// Pairs that are not as expected.
        unexpected: usize = of.unexpected,
    }
}
