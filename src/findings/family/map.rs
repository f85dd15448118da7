//! The map of a family: where, over two of the symbols that vary, a claim holds and where it fails.

use reason::Reason;
use serde::{Deserialize, Serialize};

/// One of the two symbols of a map.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Axis {
    /// Its name, in LaTeX.
    pub name: String,
    /// The least and the greatest value of each cell, increasing. The two are the same where a cell has one value; of what is
    /// normally distributed the outermost cells have all that lies beyond, too.
    pub cells: Vec<(f64, f64)>,
}

/// Two members of a map, next to one another along one axis, between which the verdict changes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Crossing {
    /// Along which axis they lie: 0 to the right, 1 upwards.
    pub along: usize,
    /// What is to the right on both; the same number twice where they lie above one another.
    pub across: (f64, f64),
    /// What is upwards on both.
    pub up: (f64, f64),
    /// Whether the claim holds on the first and fails on the second, and not the other way round.
    pub first_holds: bool,
    /// Whether they are as near as was asked for.
    pub is_narrow: bool,
}

/// The edge of where a claim holds on a map.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Boundary {
    /// How near the two ends of a crossing shall be, to the right and upwards.
    pub widths: [Option<f64>; 2],
    /// Where the verdict changes.
    pub crossings: Vec<Crossing>,
    /// How many motions were tried to find it: they are no members of the family.
    pub members: u64,
    /// Why no more were.
    pub stopped: Option<Reason>,
}

/// A map, with what was found.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FamilyMap {
    /// What changes to the right.
    pub across: Axis,
    /// What changes upwards.
    pub up: Axis,
    /// On how many members of each cell the claim holds, fails, does not apply, is undecided: row by row from below.
    pub cells: Vec<[u64; 4]>,
    /// The edge of where it holds, where it was looked for.
    pub boundary: Option<Boundary>,
}
