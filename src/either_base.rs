//! Logarithms without a base: an equation is decided with each base that `\log` may mean, and answered where the answers are one.
//!
//! **In:** a question of a session that does not say what `\log` is. **Out:** its answer, with the remark that the base does not matter; or
//! nothing. **Guaranteed:** each base was asked, and each gave the same verdict. **Why this way:** `\log(ab)=\log a+\log b` is true whatever
//! the base, and a paper need not say which.

use crate::latex::{Logarithm, NO_BASE};
use crate::session::{Answer, Failure, Question, Session};

/// What is said of such a verdict.
const REMARK: &str = r"either base that `\log` may have, e or 10, gives this verdict; numbers are those of base e";

impl Failure {
    /// Whether all that is not understood is which base `\log` has.
    pub(crate) fn is_of_base(&self) -> bool {
        matches!(self, Failure::Problems(found) if !found.is_empty() && found.iter().all(|d| d.code == NO_BASE))
    }
}

impl Session {
    /// The answer that is the same in each base; nothing where they differ, or where one is no answer.
    pub(crate) fn in_either_base(&self, question: &Question) -> Option<Answer> {
        let asked = Logarithm::ALL.iter().map(|(.., base)| self.with_base(*base).decide(question).ok());
        let answers: Vec<Answer> = asked.collect::<Option<_>>()?;
        let verdict = answers.first()?.standing();
        let is_one = verdict != "undecided" && answers.iter().all(|a| a.standing() == verdict);
        is_one.then(|| answers.into_iter().next())?.map(|first| first.with_remark(REMARK))
    }
}
