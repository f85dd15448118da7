//! Why a check could not be made.

use diag::Diagnostic;

/// Why a check could not be made.
#[derive(Clone, Debug, PartialEq)]
pub enum CheckError {
    /// Problems in the derivation file.
    Problems(Vec<Diagnostic>),
    /// The program contradicts itself: a defect to be reported.
    Defect(String),
}

/// What a run ends with once its flag is raised: nobody sees it who raised the flag.
pub const CANCELLED: &str = "the run was cancelled";
