//! Problems in what a user wrote.

use std::ops::Range;

/// A problem at a place in one text (a formula): the rooms that read formulas know nothing of files.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// Stable name, `room::kind`, for instance `latex::unknown-symbol`.
    pub code: &'static str,
    /// What is wrong, in one sentence without a full stop.
    pub message: String,
    /// Byte range in the text.
    pub span: Range<usize>,
    /// How to write it.
    pub hint: Option<String>,
}
