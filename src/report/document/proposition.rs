//! The answer to a proposition.

use super::Tool;
use super::claim::{AssumptionsUsed, RecordedProof, Trials};
use super::value::{Named, StepStanding, StepVerdict, objects};
use crate::certificates::{certificate_text, is_certified};
use findings::{Counterexample, IdentityAccount, Place, Proposition};

objects! {
    /// What `rederive prove` prints.
    Answer<'a> of (asked: &'a Proposition, of: &'a IdentityAccount) let evidence = &of.evidence; {
        /// The version of this contract.
        schema: u32 = 1,
        /// What answers.
        tool: Tool = Tool::of(()),
        /// Equations, in LaTeX.
        formula: &'a str = &asked.formula,
        /// Premises, in LaTeX.
        given: &'a [String] = &asked.given,
        /// For ±: whether one sign must serve all points.
        branches: &'static str = if asked.throughout { "throughout" } else { "pointwise" },
        /// What was decided.
        verdict: StepVerdict = StepVerdict(of.verdict()),
        /// The same in full.
        standing: StepStanding = StepStanding(of.standing()),
        /// log2 of the bound for the probability that a proof is wrong.
        log2_error: Option<f64> = of.log2_error,
        /// The field in which it was tried.
        field: Option<&'static str> = evidence.trials.as_ref().map(|_| "GF(p^2)"),
        /// The random test, where it proved.
        trials: Option<Trials<'a>> = evidence.trials.as_ref().map(Trials::of),
        /// For ±: the sign it holds for.
        branch: Option<String> = evidence.branch.as_ref().map(ToString::to_string),
        /// What has to hold for the formulas to have values.
        conditions: Vec<String> = of.conditions.iter().map(ToString::to_string).collect(),
        /// What the proof does not reach.
        exceptions: Vec<String> = of.exceptions.iter().map(ToString::to_string).collect(),
        /// Where alone the premises can hold, special cases aside.
        given_only_where: Vec<String> = of.given_only_where.iter().map(ToString::to_string).collect(),
        /// Which premises the proof needs, where that was looked at.
        assumptions: Option<AssumptionsUsed<'a>> = of.assumptions.as_ref().map(AssumptionsUsed::of),
        /// Assumptions of the premises.
        presupposed: &'a [String] = &of.presupposed,
        /// Whether the proof leaves out special cases.
        generic: bool = of.generic,
        /// Why undecided; a remark on a proof.
        reason: Option<String> = of.reason.as_ref().map(ToString::to_string),
        /// Whether the premises cannot hold together.
        contradiction: bool = evidence.contradiction,
        /// A point that refutes.
        witness: Option<RefutingPoint<'a>> = evidence.counterexample.as_ref().map(RefutingPoint::of),
        /// The exact proof, as a program.
        certificate: Option<String> = is_certified(of)
            .then(|| certificate_text(&asked.formula, &asked.given, &evidence.certificates)),
        /// Why there is none, where one was looked for.
        no_certificate: Option<&'a str> = evidence.no_certificate.as_deref(),
        /// Whether the proof is recorded as steps; there where it was looked for.
        #[serde(skip_serializing_if = "Option::is_none")]
        recorded: Option<RecordedProof<'a>> = of.recorded.as_ref().map(RecordedProof::of),
        /// The sequent and the steps, as they stand in proofs.json of a report.
        #[serde(skip_serializing_if = "Option::is_none")]
        proof: Option<serde_json::Value> = of.recorded.as_ref()
            .and_then(|recorded| serde_json::from_str(recorded.replayed()?.json()).ok()),
    }

    /// A point at which the premises hold, and an equation does not.
    RefutingPoint<'a> of (of: &'a Counterexample) let first = Point::of(&of.first); {
        /// Number of the equation.
        equation: usize = of.equation,
        /// Value of its left side.
        left: &'a str = first.left,
        /// Value of its right side.
        right: &'a str = first.right,
        /// Values of all that occurs.
        point: Named<'a, &'a str> = first.point,
        /// Another point, with another difference of the sides: the premises do not fix it.
        second: Option<Point<'a>> = of.second.as_ref().map(Point::of),
    }

    /// A point, and the sides of an equation there.
    Point<'a> of (of: &'a Place) {
        /// Value of its left side.
        left: &'a str = &of.left,
        /// Value of its right side.
        right: &'a str = &of.right,
        /// Values of all that occurs.
        point: Named<'a, &'a str> =
            Named(of.point.iter().chain(&of.beyond).map(|(name, value)| (name.as_str(), value.as_str())).collect()),
    }
}
