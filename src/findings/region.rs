//! What was found for a claim over ranges.

use crate::words::{self, Word};
use reason::Reason;
use serde::{Deserialize, Serialize};
use verdict::Verdict;

/// Squares along each side of a board.
pub const SQUARES: usize = 24;
/// Arrows along each side of a board.
pub const ARROWS: usize = 12;
/// What is known of a claim on a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Part {
    /// It holds at every point.
    Proved,
    /// It holds at every point at which it applies; not known where that is.
    Border,
    /// It fails at every point.
    Refuted,
    /// It applies at no point.
    NotApplicable,
    /// Not known.
    Undecided,
}

/// A symbol with its range or value.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RangeAccount {
    /// Name, in LaTeX.
    pub name: String,
    /// Unit as written.
    pub unit: Option<String>,
    /// First and last value, to the nearest binary64 number; equal for a single value. `None` for a value that depends on
    /// others.
    pub values: Option<(f64, f64)>,
    /// For a value that depends on others: its formula.
    pub formula: Option<String>,
}

impl RangeAccount {
    /// Whether a formula is put in for a field: a name with its arguments.
    pub fn is_field(&self) -> bool {
        self.formula.is_some() && self.name.trim_end().ends_with(')')
    }
}

/// Parts of the volume; they add up to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Shares {
    /// The claim holds wherever it applies.
    pub proved: f64,
    /// It fails at every point.
    pub refuted: f64,
    /// It applies nowhere.
    pub not_applicable: f64,
    /// Not known.
    pub undecided: f64,
}

/// A point at which a claim over ranges fails.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RegionWitness {
    /// Names and values of the ranges.
    pub values: Vec<(String, f64)>,
    /// The formula that fails, as written; `None` where the failure is not that of one formula.
    pub formula: Option<String>,
    /// What encloses its left and its right side there; `None` for a formula without a value.
    pub sides: Option<((f64, f64), (f64, f64))>,
    /// What is wrong there.
    pub says: Reason,
}

/// A solution: each unknown with what encloses it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SolutionAccount {
    /// Name, lower and upper end.
    pub values: Vec<(String, f64, f64)>,
}

/// One claim over ranges.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RegionAccount {
    /// The verdict.
    pub verdict: Verdict,
    /// The word that the derivation file expects, if it expects one.
    #[serde(deserialize_with = "words::expected")]
    pub expected: Option<Word>,
    /// The ranges, in the order of the file; those that vary, then single values.
    pub ranges: Vec<RangeAccount>,
    /// How many of them vary.
    pub varying: usize,
    /// For `exists`: the unknowns, each with the range in which a solution is looked for.
    pub unknowns: Vec<RangeAccount>,
    /// For `exists`: whether there is to be one solution only.
    pub unique: bool,
    /// The parts of the box.
    pub shares: Shares,
    /// Number of cells that were judged.
    pub cells: usize,
    /// Most bisections of an undecided cell that is left; 0 where none is.
    pub depth: u32,
    /// A point at which the claim fails.
    pub witness: Option<RegionWitness>,
    /// For `exists`: the solutions that were found, if the ranges were not taken apart for them.
    pub solutions: Vec<SolutionAccount>,
    /// Formulas that are identities by random evaluation: each with log₂ of the bound for the probability of an error.
    pub identities: Vec<(String, f64)>,
    /// What else is to be known.
    pub remarks: Vec<Reason>,
    /// The picture of the first two ranges.
    pub map: Option<RegionMap>,
    /// Pictures of its fields over them.
    pub portraits: Vec<Portrait>,
}

impl RegionAccount {
    /// Whether this is about fields, whatever they are.
    pub fn is_of_fields(&self) -> bool {
        self.ranges.is_empty() && self.unknowns.is_empty()
    }
}

/// Squares of the board that are known in the same way, as a rectangle: column and row from the lower left, width, height.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Patch {
    /// What is known.
    pub part: Part,
    /// The first column.
    pub column: u32,
    /// The first row, from below.
    pub row: u32,
    /// Number of columns.
    pub width: u32,
    /// Number of rows.
    pub height: u32,
}

/// The picture.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct RegionMap {
    /// Positions among the ranges that vary: across, up.
    pub axes: (usize, usize),
    /// Squares along each side.
    pub squares: u32,
    /// The rectangles; they cover the board.
    pub patches: Vec<Patch>,
}

/// What is drawn, row by row from below; `None` where there is no value.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Drawn {
    /// A number for each of [`SQUARES`]² squares.
    Shades(Vec<Option<f64>>),
    /// A vector for each of [`ARROWS`]² squares: across, up.
    Arrows(Vec<Option<(f64, f64)>>),
}

/// One picture.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Portrait {
    /// What is drawn, in LaTeX.
    pub shows: String,
    /// Whether this is the difference of the sides of an equation.
    pub residual: bool,
    /// What is drawn.
    pub drawn: Drawn,
}
