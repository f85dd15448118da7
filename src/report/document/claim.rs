//! A claim, its step for all values, and its verdicts on trajectories.

use super::conditions::Conditions;
use super::family::Family;
use super::region::Region;
use super::value::{Named, StepStanding, StepVerdict, Strength, Verdict, is_false, objects};
use super::variants::{Discrimination, Variants};
use crate::certificates::file_name;
use crate::tally::declared;
use crate::wording::slack;
use derivation::{ClaimRole, Derivation};
use findings::standing::{self, MOST_TOLD};

objects! {
    /// A claim, or one reading of it.
    Claim<'a> of (derivation: &'a Derivation, of: &'a findings::ClaimAccount) let declared = declared(derivation, of); {
        /// Its id.
        id: &'a str = &of.id,
        /// Id of the reading.
        reading: Option<&'a str> = of.reading.as_deref(),
        /// The claim in words.
        says: &'a str = &of.says,
        /// As written.
        formulas: &'a [String] = &of.formulas,
        /// What is said by each of them, such as `always`.
        kinds: Option<Vec<&'static str>> = declared.map(|d| d.formulas.iter().map(|f| f.kind.key()).collect()),
        /// What it is to the paper.
        #[schemars(extend("enum" = ClaimRole::ALL.map(ClaimRole::word)))]
        role: &'static str = declared.map(|d| d.role).unwrap_or_default().word(),
        /// Whether the paper does not say it: it was added for comparison.
        added: bool = declared.is_some_and(|d| d.role == ClaimRole::Added),
        /// Whether the paper concludes it.
        conclusion: bool = declared.is_some_and(|d| d.conclusion),
        /// Claims on which the paper's argument for it rests.
        rests_on: &'a [String] = declared.map(|d| d.rests_on.as_slice()).unwrap_or_default(),
        /// Where it stands in the paper.
        place: Option<&'a str> = of.place.as_deref(),
        /// The label of its equation.
        label: Option<&'a str> = declared.and_then(|d| d.label.as_deref()),
        /// As written.
        assumptions: &'a [String] = &of.assumptions,
        /// Claims, systems and symbols from which it follows.
        follows_from: Option<&'a [String]> = declared.map(|d| d.follows_from.as_slice()),
        /// The relative precision that was asked for.
        precision: Option<f64> = declared.map(|d| d.precision),
        /// What a reader should know.
        remark: Option<&'a str> = of.remark.as_deref(),
        /// Whether it holds for all values, where it is a claim of that kind.
        identity: Option<Identity<'a>> = of.identity.as_ref().map(|i| Identity::of(of, i)),
        /// What single edits of its formulas say of the evidence, where they were tried.
        variants: Option<Variants<'a>> = of.variants.as_ref().map(Variants::of),
        /// Under which condition it holds, and which of its assumptions it needs.
        conditions: Conditions<'a> = Conditions::of(&of.conditions),
        /// For a claim over ranges: its verdict.
        region: Option<Region<'a>> = of.region.as_ref().map(Region::of),
        /// For a claim of which the step is the verdict, as it is of one that is tried on nothing and is no postulate.
        #[serde(skip_serializing_if = "Option::is_none")]
        #[schemars(with = "Alone")]
        alone: Option<Alone> = of.verdict_alone().map(|_| Alone::of(of)),
        /// One entry for each trajectory on which it is tried.
        results: Vec<TrajectoryResult<'a>> = of.results.iter().map(TrajectoryResult::of).collect(),
        /// How a claim that holds on every motion of the file, and is not proved, fares on motions that were drawn beside these.
        #[serde(skip_serializing_if = "Option::is_none")]
        #[schemars(with = "Drawn")]
        drawn: Option<Drawn<'a>> = of.drawn.as_ref().map(Drawn::of),
        /// One entry for each family on which it is tried.
        #[serde(skip_serializing_if = "Vec::is_empty")]
        families: Vec<Family<'a>> = of.families.iter().map(Family::of).collect(),
    }

    /// How a claim fares on motions that are not in the file: no verdict depends on it.
    Drawn<'a> of (of: &'a findings::search::DrawnAccount) {
        /// The seed of all draws.
        seed: u64 = of.seed,
        /// On how many it holds.
        holds: usize = of.tries.holds,
        /// On how many it fails.
        fails: usize = of.tries.fails,
        /// To how many it does not apply.
        not_applicable: usize = of.tries.not_applicable,
        /// On how many it is undecided.
        undecided: usize = of.tries.undecided,
        /// How many draws are no motions.
        impossible: usize = of.tries.impossible,
        /// The first on which it fails.
        #[serde(skip_serializing_if = "Option::is_none")]
        #[schemars(with = "DrawnMotion")]
        found: Option<DrawnMotion<'a>> = of.found.as_deref().map(DrawnMotion::of),
    }

    /// A motion on which such a claim fails.
    DrawnMotion<'a> of (of: &'a findings::search::FailingMotion) {
        /// The trajectory of the file that it was made from.
        from: &'a str = &of.from,
        /// The numbers that are other than there.
        changed: Vec<ChangedNumber<'a>> = of.changed.iter().map(ChangedNumber::of).collect(),
        /// The motion as a table of the file.
        toml: &'a str = &of.table,
        /// Whether the claim names its trajectories: the id of the table must then be added there.
        listed: bool = of.listed,
        /// A point that can be checked by hand.
        witness: Option<Witness<'a>> = of.verdict.evidence().witness.as_ref().map(Witness::of),
    }

    /// A number that is other than in the trajectory that a motion was made from.
    ChangedNumber<'a> of (of: &'a findings::search::ChangedNumber) {
        /// LaTeX of what has this value.
        name: &'a str = &of.name,
        /// What it is.
        now: f64 = of.now,
        /// What it is there.
        then: f64 = of.then,
    }

    /// The verdict on a claim of which the step is the verdict.
    Alone of (of: &findings::ClaimAccount) {
        /// What became of it.
        verdict: Verdict = Verdict(of.verdict_alone().unwrap_or("undecided")),
        /// What the derivation file expects.
        expected: Option<Verdict> = of.alone.and_then(|alone| alone.expected).map(Verdict),
        /// Whether the verdict is not as expected.
        unexpected: bool = of.is_unexpected_alone(),
    }

    /// Whether a claim holds for all values, given what it follows from.
    Identity<'a> of (claim: &'a findings::ClaimAccount, of: &'a findings::IdentityAccount) {
        /// What became of it.
        verdict: StepVerdict = StepVerdict(of.verdict()),
        /// The verdict in full: whether a proof leaves cases out, or follows from what is not proved.
        standing: StepStanding = StepStanding(of.standing()),
        /// Claims that it follows from, through all steps, and that are not proved.
        conditional_on: Vec<Given<'a>> = of.conditional_on.iter().take(MOST_TOLD).map(Given::of).collect(),
        /// There, and true, if there are more such claims than are told.
        #[serde(skip_serializing_if = "is_false")]
        conditional_on_more: bool = of.conditional_on.len() > MOST_TOLD,
        /// log2 of the bound for the probability that a proof is wrong.
        log2_error: Option<f64> = of.log2_error,
        /// What was given: ids of claims and systems.
        from: &'a [String] = &of.from,
        /// What has to hold for the formulas to have values.
        conditions: Vec<String> = of.conditions.iter().map(ToString::to_string).collect(),
        /// What the proof does not reach.
        exceptions: Vec<String> = of.exceptions.iter().map(ToString::to_string).collect(),
        /// Where alone what is given can hold, special cases aside.
        given_only_where: Vec<String> = of.given_only_where.iter().map(ToString::to_string).collect(),
        /// Which of the claim's assumptions the proof needs, where that was looked at.
        assumptions: Option<AssumptionsUsed<'a>> = of.assumptions.as_ref().map(AssumptionsUsed::of),
        /// Assumptions of what is given that the claim does not make itself.
        presupposed: &'a [String] = &of.presupposed,
        /// Whether the proof leaves out special cases of what is given.
        generic: bool = of.generic,
        /// Why undecided; a remark on a proof.
        reason: Option<String> = of.reason.as_ref().map(ToString::to_string),
        /// A point at which everything given holds and the claim does not.
        witness: Option<String> = of.witness.as_ref().map(ToString::to_string),
        /// For ±: the sign it holds for.
        branch: Option<String> = of.evidence.branch.as_ref().map(ToString::to_string),
        /// The random test, where it proved.
        trials: Option<Trials<'a>> = of.evidence.trials.as_ref().map(Trials::of),
        /// The file in `certificates` that proves it exactly.
        certificate: Option<String> = file_name(claim),
        /// Why there is none, where one was looked for.
        no_certificate: Option<&'a str> = of.evidence.no_certificate.as_deref(),
        /// Whether the proof is recorded as steps; there where it was looked for.
        #[serde(skip_serializing_if = "Option::is_none")]
        recorded: Option<RecordedProof<'a>> = of.recorded.as_ref().map(RecordedProof::of),
    }

    /// Whether a proof is recorded as steps that the checker replays.
    RecordedProof<'a> of (of: &'a findings::Recorded) {
        /// What the word *proved* rests on: `replayed`, `replayed in part`, `prover alone`.
        grounds: &'static str = of.grounds().word(),
        /// The number of steps; null where none are recorded, and the proof rests on the prover alone.
        steps: Option<usize> = of.steps(),
        /// The number of cases that the steps leave out.
        leaves_out: usize = of.left_out(),
        /// Why none are recorded.
        why_not: Option<&'a str> = of.why_not(),
    }

    /// A claim that a proof is given.
    Given<'a> of (of: &'a standing::Given) {
        /// Its id.
        id: &'a str = &of.name,
        /// What that claim's own step came to; null where it is no question for all values.
        standing: Option<&'static str> = of.standing,
    }

    /// The assumptions of a claim, as its proof sees them.
    AssumptionsUsed<'a> of (of: &'a findings::AssumptionsUsed) {
        /// Those that the proof needs.
        used: &'a [String] = &of.used,
        /// Those that it does not need.
        unused: &'a [String] = &of.unused,
    }

    /// The random test of an identity.
    Trials<'a> of (of: &'a findings::Trials) {
        /// Independent trials.
        count: usize = of.count,
        /// The primes p; the points are from GF(p²).
        primes: &'a [u64] = &of.primes,
        /// Bound for the degree of what was tested.
        degree: f64 = of.degree,
        /// Bound for log2 of the coefficients.
        height: f64 = of.height,
        /// Independent signs of roots.
        signs: usize = of.signs,
        /// Cases into which premises were split.
        cases: usize = of.cases,
    }

    /// A claim on a trajectory.
    TrajectoryResult<'a> of (of: &'a findings::PairAccount)
    let (outcome, evidence) = (of.verdict.outcome(), of.verdict.evidence()); {
        /// Id of the trajectory.
        trajectory: &'a str = &of.trajectory,
        /// What became of it.
        verdict: Verdict = Verdict(outcome.word()),
        /// How strong the evidence is.
        strength: Option<Strength> = outcome.strength().map(Strength),
        /// What the derivation file expects.
        expected: Option<Verdict> = of.expected.map(Verdict),
        /// Whether the verdict is not as expected.
        unexpected: bool = of.is_unexpected(),
        /// The worst point of a comparison.
        residual: Option<Residual> = evidence.residual.as_ref().map(Residual::of),
        /// By how much a weak inequality may be violated at samples: the largest error bound at which its sides agree.
        #[serde(skip_serializing_if = "Option::is_none")]
        slack: Option<f64> = slack(of),
        /// Times at which the claim was compared.
        samples: usize = evidence.samples,
        /// Why not applicable or undecided; a remark otherwise.
        reason: Option<String> = evidence.reason.as_ref().map(ToString::to_string),
        /// For ±: which sign.
        branch: Option<String> = evidence.branch.as_ref().map(ToString::to_string),
        /// Stretches of time that were left out.
        excluded: Vec<Exclusion> = evidence.excluded.iter().map(Exclusion::of).collect(),
        /// How many altered formulas the same evidence rejects, where the claim holds.
        discrimination: Option<Discrimination> = of.discrimination.as_ref().map(Discrimination::of),
        /// A point that can be checked by hand, for a claim that fails.
        witness: Option<Witness<'a>> = evidence.witness.as_ref().map(Witness::of),
        /// What an enclosure found, where it decided.
        #[serde(skip_serializing_if = "Option::is_none")]
        #[schemars(with = "Enclosed")]
        enclosed: Option<Enclosed> = evidence.enclosed.as_ref().map(Enclosed::of),
        /// A point at which an assumption is not met, where the claim does not apply.
        #[serde(skip_serializing_if = "Option::is_none")]
        #[schemars(with = "Witness")]
        unmet: Option<Witness<'a>> = evidence.unmet.as_ref().map(Witness::of),
        /// Where an enclosure did not decide.
        #[serde(skip_serializing_if = "Option::is_none")]
        #[schemars(with = "Obstacle")]
        obstacle: Option<Obstacle> = evidence.obstacle.as_ref().map(Obstacle::of),
    }

    /// What an enclosure found on all stretches of a span.
    Enclosed of (of: &findings::Enclosed) {
        /// How many stretches were looked at, or events.
        places: usize = of.places,
        /// For equations: |left − right| is at most this everywhere; for weak inequalities, by how much the wrong side may be the
        /// larger one; 0 where neither was decided.
        gap: f64 = of.gap,
        /// The size of the terms that the gap is small against.
        scale: f64 = of.scale,
    }

    /// Where an enclosure is too wide to decide.
    Obstacle of (of: &findings::Obstacle) {
        /// First time.
        from: f64 = of.from,
        /// Last time, which may be the first.
        to: f64 = of.to,
        /// What encloses the difference of the two sides there, where both have a value.
        difference: Option<[f64; 2]> = of.difference.map(<[f64; 2]>::from),
    }

    /// The worst point of a comparison.
    Residual of (of: &findings::Residual) {
        /// |left − right| at the worst point.
        max: f64 = of.max,
        /// Its error bound there.
        bound: f64 = of.bound,
        /// The time.
        at: f64 = of.at,
    }

    /// A stretch of time that was left out.
    Exclusion of (of: &findings::Exclusion) {
        /// First time left out.
        from: f64 = of.from,
        /// Last time left out.
        to: f64 = of.to,
        /// Why.
        reason: String = of.reason.to_string(),
    }

    /// A point that can be checked by hand.
    Witness<'a> of (of: &'a findings::Witness) {
        /// The time.
        t: f64 = of.t,
        /// What is compared.
        formula: &'a str = &of.formula,
        /// Value of the left side; null where it has none.
        left: f64 = of.left,
        /// Value of the right side; null where it has none.
        right: f64 = of.right,
        /// |left − right|, of these numbers.
        difference: f64 = of.difference(),
        /// Error bound of their difference.
        bound: f64 = of.bound,
        /// What the sides depend on.
        values: Named<'a, f64> = Named::of(&of.values, |x| *x),
    }
}
