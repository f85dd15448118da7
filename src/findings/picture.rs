//! Pictures of motions: lines in the plane of the drawing.

use serde::{Deserialize, Serialize};

/// What a line of a picture is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum LineKind {
    /// A quantity that is shown, by its position; for curves and spheres the motion itself.
    Shown(usize),
    /// The motion on the far side of a sphere.
    Hidden,
    /// A level set.
    Level,
    /// A level set through a saddle.
    Separatrix,
    /// A claimed slope, by its position.
    Slope(usize),
    /// Where an axis of a sphere comes out on the near side, by its position, and whether it is the positive end.
    Axis(usize, bool),
}

/// A line in the plane of the drawing.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Line {
    /// What it is.
    pub kind: LineKind,
    /// Its points. On a sphere in units of its radius, to the right and up.
    pub points: Vec<(f64, f64)>,
}

/// One picture of one motion.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PictureAccount {
    /// Id of the picture.
    pub picture: String,
    /// Id of the trajectory.
    pub trajectory: String,
    /// Its lines, those in front last; none where there is nothing to draw.
    pub lines: Vec<Line>,
    /// Why there is nothing to draw.
    pub reason: Option<reason::Reason>,
}
