//! A claim over ranges of values.

use super::value::{Named, RangesStrength, Verdict, objects};
use findings::region::{Part, Patch, RangeAccount, RegionAccount, RegionMap, RegionWitness, Shares as Parts};

objects! {
    /// A claim over ranges of values.
    Region<'a> of (of: &'a RegionAccount) let outcome = of.verdict.outcome(); {
        /// What became of it.
        verdict: Verdict = Verdict(outcome.word()),
        /// How strong the evidence is.
        strength: Option<RangesStrength> = outcome.strength().map(RangesStrength),
        /// What the derivation file expects.
        expected: Option<Verdict> = of.expected.map(Verdict),
        /// Whether the verdict is not as expected.
        unexpected: bool = of.is_unexpected(),
        /// How it came about.
        reason: Option<String> = of.verdict.evidence().reason.as_ref().map(ToString::to_string),
        /// The ranges, and values that do not vary.
        ranges: Vec<Range<'a>> = of.ranges.iter().map(Range::of).collect(),
        /// How many of the ranges vary; they come first.
        varying: usize = of.varying,
        /// What is looked for, each with where.
        unknowns: Vec<Range<'a>> = of.unknowns.iter().map(Range::of).collect(),
        /// Whether one solution only was asked for.
        unique: bool = of.unique,
        /// The parts of the volume; they add up to 1.
        shares: Shares = Shares::of(&of.shares),
        /// Cells that were judged.
        cells: usize = of.cells,
        /// Most bisections of a cell that is undecided.
        depth: u32 = of.depth,
        /// A point at which it fails.
        witness: Option<Refutation<'a>> = of.witness.as_ref().map(Refutation::of),
        /// The solutions that were found: what encloses each unknown.
        solutions: Vec<Named<'a, [f64; 2]>> = of.solutions.iter()
            .map(|s| Named(s.values.iter().map(|(name, low, high)| (name.as_str(), [*low, *high])).collect())).collect(),
        /// What else is to be known.
        remarks: Vec<String> = of.remarks.iter().map(ToString::to_string).collect(),
        /// The picture of two of the ranges.
        map: Option<Board> = of.map.as_ref().map(Board::of),
        /// Formulas that are identities by random evaluation.
        #[serde(skip_serializing_if = "Vec::is_empty")]
        identities: Vec<RandomIdentity<'a>> = of.identities.iter().map(RandomIdentity::of).collect(),
    }

    /// A formula that is an identity by random evaluation.
    RandomIdentity<'a> of (of: &'a (String, f64)) {
        /// As written.
        formula: &'a str = &of.0,
        /// log2 of the bound for the probability of an error.
        log2_error: f64 = of.1,
    }

    /// A symbol with its range or value.
    Range<'a> of (of: &'a RangeAccount) {
        /// In LaTeX.
        name: &'a str = &of.name,
        /// Its unit.
        unit: Option<&'a str> = of.unit.as_deref(),
        /// First value.
        from: Option<f64> = of.values.map(|v| v.0),
        /// Last value, the same for a single value.
        to: Option<f64> = of.values.map(|v| v.1),
        /// Its formula, for a value that depends on others.
        formula: Option<&'a str> = of.formula.as_deref(),
    }

    /// Parts of the volume.
    Shares of (of: &Parts) {
        /// Part of the volume on which the claim holds wherever it applies.
        proved: f64 = of.proved,
        /// Part on which it fails at every point.
        refuted: f64 = of.refuted,
        /// Part on which it applies nowhere.
        not_applicable: f64 = of.not_applicable,
        /// Part that is not known.
        undecided: f64 = of.undecided,
    }

    /// A point at which a claim over ranges fails.
    Refutation<'a> of (of: &'a RegionWitness) {
        /// Values of the ranges.
        values: Named<'a, f64> = Named::of(&of.values, |x| *x),
        /// What fails, as written.
        formula: Option<&'a str> = of.formula.as_deref(),
        /// What encloses its left side.
        left: Option<[f64; 2]> = of.sides.map(|(left, _)| left.into()),
        /// What encloses its right side.
        right: Option<[f64; 2]> = of.sides.map(|(_, right)| right.into()),
        /// What is wrong there.
        says: String = of.says.to_string(),
    }

    /// A picture over two of the ranges.
    Board of (of: &RegionMap) {
        /// Position among `ranges` of what goes to the right.
        across: usize = of.axes.0,
        /// Position among `ranges` of what goes up.
        up: usize = of.axes.1,
        /// Squares along each side of the board.
        squares: u32 = of.squares,
        /// p proved, b proved where it applies, r refuted, n not applicable, u undecided; column, row, width, height.
        patches: Vec<String> = of.patches.iter().map(patch).collect(),
    }
}

fn patch(of: &Patch) -> String {
    let letter = match of.part {
        Part::Proved => "p",
        Part::Border => "b",
        Part::Refuted => "r",
        Part::NotApplicable => "n",
        Part::Undecided => "u",
    };
    format!("{letter} {} {} {} {}", of.column, of.row, of.width, of.height)
}
