//! What is told of a paper beside what was read.
//!
//! **In:** a place that some room of the reader passes over. **Out:** a note with it.

use std::ops::Range;

/// Something of a paper that was not read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PaperNote {
    /// What, in a sentence without a full stop.
    pub message: String,
    /// Where.
    pub span: Range<usize>,
}
