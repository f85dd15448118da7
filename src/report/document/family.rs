//! Claims and measures over families of motions.

use super::claim::Witness;
use super::conditions::Explanation;
use super::value::{Decided, FamilyStrength, Finite, Named, Strength, Verdict, objects};
use findings::FamilyAccount;
use findings::family::{self, SHARES};

/// What is counted in each cell of a map.
const COUNTS: [&str; 4] = ["holds", "fails", "not_applicable", "undecided"];

objects! {
    /// A claim on a family of motions.
    Family<'a> of (of: &'a FamilyAccount)
    let outcome = of.verdict.outcome(); let member = |m: &'a Option<family::MemberAccount>| m.as_ref().map(Member::of); {
        /// Its id.
        family: &'a str = &of.family,
        /// What became of it.
        verdict: Verdict = Verdict(outcome.word()),
        /// How strong the evidence is.
        strength: Option<FamilyStrength> = outcome.strength().map(FamilyStrength),
        /// What the derivation file expects.
        expected: Option<Verdict> = of.expected.map(Verdict),
        /// Whether the verdict is not as expected.
        unexpected: bool = of.is_unexpected(),
        /// How it came about.
        reason: Option<String> = of.verdict.evidence().reason.as_ref().map(ToString::to_string),
        /// Members before constraints.
        size: u64 = of.size,
        /// Members that were tried.
        members: u64 = of.counts.members,
        /// Points of a grid, or draws, that did not satisfy the constraints.
        rejected: u64 = of.counts.rejected,
        /// Members on which it holds.
        holds: u64 = of.counts.holds,
        /// Members on which it fails.
        fails: u64 = of.counts.fails,
        /// Members to which it does not apply.
        not_applicable: u64 = of.counts.not_applicable,
        /// Members on which it is undecided.
        undecided: u64 = of.counts.undecided,
        /// Why not all members were tried.
        stopped: Option<String> = of.stopped.as_ref().map(ToString::to_string),
        /// What the counts say of members that were not drawn; null where members are no sample.
        failing_share: Option<FailingShare> = of.failing_share.as_ref().map(FailingShare::of),
        /// The failing member with the smallest number.
        first_failing: Option<Member<'a>> = member(&of.first_failing),
        /// The failing member whose sides are furthest apart.
        clearest_failing: Option<Member<'a>> = member(&of.clearest_failing),
        /// The undecided member with the smallest number.
        first_undecided: Option<Member<'a>> = member(&of.first_undecided),
        /// Of the members on which an inequality holds, the one whose sides come closest.
        closest_call: Option<Member<'a>> = member(&of.closest_call),
        /// How near the sides of an inequality come in it, against the size of their terms.
        closest_gap: Option<f64> = of.closest_gap,
        /// Where it holds and where it fails, over two of the symbols that vary.
        #[serde(skip_serializing_if = "Option::is_none")]
        #[schemars(with = "Map")]
        map: Option<Map<'a>> = of.map.as_ref().map(Map::of),
        /// Which condition separates the members on which it holds from those on which it fails.
        #[serde(skip_serializing_if = "Option::is_none")]
        #[schemars(with = "FamilySeparation")]
        separation: Option<FamilySeparation<'a>> = of.separation.as_ref().map(FamilySeparation::of),
        /// The slope of a scaling law over all members.
        #[serde(skip_serializing_if = "Option::is_none")]
        #[schemars(with = "Slope")]
        slope: Option<Slope<'a>> = of.slope.as_ref().map(Slope::of),
    }

    /// An upper bound for the share of members that fail.
    FailingShare of (of: &family::FailingShare) {
        /// At most this share of all members that could be drawn, and to which the claim applies, fails.
        at_most: f64 = of.at_most,
        /// With this confidence.
        confidence: f64 = of.confidence,
        /// Of those that were drawn, how many fail or are undecided.
        failures: u64 = of.failures,
        /// To how many of those that were drawn the claim applies, or may apply.
        draws: u64 = of.draws,
    }

    /// A member of a family.
    Member<'a> of (of: &'a family::MemberAccount)
    let (outcome, evidence) = (of.verdict.outcome(), of.verdict.evidence()); {
        /// Its number, the first of which is 1.
        number: u64 = of.number,
        /// Values of what varies.
        values: Named<'a, f64> = Named::of(&of.values, |x| *x),
        /// What became of the claim on it.
        verdict: Verdict = Verdict(outcome.word()),
        /// How strong the evidence is.
        strength: Option<Strength> = outcome.strength().map(Strength),
        /// Why it is undecided.
        reason: Option<String> = evidence.reason.as_ref().map(ToString::to_string),
        /// A point that can be checked by hand, where it fails.
        witness: Option<Witness<'a>> = evidence.witness.as_ref().map(Witness::of),
        /// The member as a [[trajectory]] of a derivation file.
        trajectory: &'a str = &of.toml,
    }

    /// Where a claim holds and where it fails, over two of the symbols that vary.
    Map<'a> of (of: &'a family::FamilyMap) {
        /// What changes to the right.
        across: Axis<'a> = Axis::of(&of.across),
        /// What changes upwards.
        up: Axis<'a> = Axis::of(&of.up),
        /// What is counted in each cell.
        #[schemars(extend("const" = COUNTS))]
        counts: [&'static str; 4] = COUNTS,
        /// The counts, row by row from below.
        rows: Vec<&'a [[u64; 4]]> = of.cells.chunks(of.across.cells.len().max(1)).collect(),
        /// The edge of where it holds, where it was looked for.
        #[serde(skip_serializing_if = "Option::is_none")]
        #[schemars(with = "Boundary")]
        boundary: Option<Boundary> = of.boundary.as_ref().map(Boundary::of),
    }

    /// An axis of a map.
    Axis<'a> of (of: &'a family::Axis) {
        /// The symbol that varies.
        name: &'a str = &of.name,
        /// The least and the greatest value of each cell.
        cells: Vec<[Finite; 2]> = of.cells.iter().map(pair).collect(),
    }

    /// The edge of where a claim holds on a map: at the ends of each crossing are motions that were tried.
    Boundary of (of: &family::Boundary) {
        /// How near the two ends of a crossing shall be.
        widths: Widths = Widths::of(of.widths),
        /// Where the verdict changes.
        crossings: Vec<Crossing> = of.crossings.iter().map(Crossing::of).collect(),
        /// Motions that were tried to find it, which are no members of the family.
        members: u64 = of.members,
        /// Why no more were tried.
        stopped: Option<String> = of.stopped.as_ref().map(ToString::to_string),
    }

    /// Widths along the axes of a map.
    Widths of (of: [Option<f64>; 2]) {
        /// To the right.
        across: Option<f64> = of[0],
        /// Upwards.
        up: Option<f64> = of[1],
    }

    /// Two motions between which the verdict changes.
    Crossing of (of: &family::Crossing) {
        /// What is to the right on both.
        across: [Finite; 2] = pair(&of.across),
        /// What is upwards on both.
        up: [Finite; 2] = pair(&of.up),
        /// The verdict at the first end; the other is at the second.
        first: Decided = Decided(if of.first_holds { "holds" } else { "fails" }),
        /// Whether the ends are as near as was asked for.
        narrow: bool = of.is_narrow,
    }

    /// What separates the members of a family.
    FamilySeparation<'a> of (of: &'a family::FamilySeparation) {
        /// The simplest condition that was found.
        explanation: Option<Explanation<'a>> = of.explanation.as_ref().map(Explanation::of),
        /// Members that were looked at on which the claim holds.
        holds: usize = of.sides.0,
        /// Members that were looked at on which it fails.
        fails: usize = of.sides.1,
        /// What fresh members say of the condition.
        fresh: Fresh = Fresh::of(of),
        /// The first on which it is wrong.
        exception: Option<Exception<'a>> = of.exception.as_ref().map(Exception::of),
    }

    /// A condition on fresh members.
    Fresh of (of: &family::FamilySeparation) {
        /// Fresh members on which the condition is met just where the claim holds.
        right: usize = of.right,
        /// Fresh members on which it is not so.
        wrong: usize = of.wrong,
        /// Fresh members on which one of the two is undecided.
        undecided: usize = of.open,
    }

    /// A fresh member on which a condition says something else than what is so.
    Exception<'a> of (of: &'a family::Exception) {
        /// Values of what varies.
        values: Named<'a, f64> = Named::of(&of.values, |x| *x),
        /// Whether the claim holds on it.
        holds: bool = of.holds,
        /// It as a [[trajectory]] of a derivation file.
        trajectory: &'a str = &of.toml,
    }

    /// The slope of a scaling law over a family.
    Slope<'a> of (of: &'a family::SlopeAccount) {
        /// What varies.
        with: &'a str = &of.with,
        /// Pairs of members that follow one another.
        pairs: u64 = of.pairs,
        /// The slope of the logarithms that fits all pairs best, by least squares.
        slope: f64 = of.slope,
        /// Its standard error; null of one pair.
        standard_error: Option<f64> = of.standard_error,
        /// By how much errors of the quantities may have moved it.
        bound: f64 = of.bound,
        /// The least slope of a pair.
        least: f64 = of.least,
        /// The greatest slope of a pair.
        greatest: f64 = of.greatest,
        /// The power that is claimed.
        power: f64 = of.power,
        /// How far it may be off.
        to: f64 = of.to,
        /// Whether the claimed power is nearer than two standard errors and the bound.
        contains_power: bool = of.contains,
        /// What varies, in the middle of a cell, and the least and the greatest slope of pairs that begin there.
        cells: Vec<[Finite; 3]> = of.cells.iter().map(|c| [c.value, c.least, c.greatest].map(Finite)).collect(),
    }

    /// A measure over a family.
    Distribution<'a> of (of: &'a family::MeasureAccount) let found = &of.distribution; {
        /// Id of the measure.
        measure: &'a str = &of.measure,
        /// Id of the family.
        family: &'a str = &of.family,
        /// Members on which it was taken.
        members: u64 = found.members,
        /// Of these, how many have no value.
        without: u64 = found.without,
        /// How many may have others than those that were found.
        partial: u64 = found.partial,
        /// How many values there are.
        values: u64 = found.values(),
        /// The largest error bound of a value.
        bound: f64 = found.bound,
        /// The least value.
        least: Option<Extreme<'a>> = of.least.as_ref().map(Extreme::of),
        /// The greatest value.
        greatest: Option<Extreme<'a>> = of.greatest.as_ref().map(Extreme::of),
        /// Quantiles of the values.
        quantiles: Vec<Quantile> =
            SHARES.into_iter().filter_map(|share| Some(Quantile::of(share, found.quantile(share)?))).collect(),
        /// Why not all members were tried.
        stopped: Option<String> = of.stopped.as_ref().map(ToString::to_string),
    }

    /// A member with a value of a measure.
    Extreme<'a> of (of: &'a family::ExtremeAccount) {
        /// The number of the member.
        number: u64 = of.number,
        /// Values of what varies.
        values: Named<'a, f64> = Named::of(&of.values, |x| *x),
        /// The value.
        value: f64 = of.value,
        /// The member as a [[trajectory]] of a derivation file.
        trajectory: &'a str = &of.toml,
    }

    /// A quantile.
    Quantile of (part: f64, ends: (f64, f64)) {
        /// So much of all values is at most the quantile.
        share: f64 = part,
        /// It is at least this.
        from: f64 = ends.0,
        /// It is at most this.
        to: f64 = ends.1,
    }
}

fn pair(ends: &(f64, f64)) -> [Finite; 2] {
    [ends.0, ends.1].map(Finite)
}
