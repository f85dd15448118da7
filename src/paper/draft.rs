//! A first derivation file from a paper.

use super::Paper;

/// The text of a derivation file.
pub fn draft(paper: &Paper) -> String {
    let _ = paper;
    String::new()
}
