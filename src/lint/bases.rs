//! Steps with `\log` of which nobody says what it is: `\log(ab)=\log a+\log b` holds in every base.
//!
//! **In:** a step that is not read because the base is not known. **Out:** its word, where it is the same in each base. **Guaranteed:** each base
//! that `\log` may have was asked; a paper that means several of them at once is not judged by one.

use latex::Logarithm;

use super::judge::Judge;
use super::step::Step;

impl Judge<'_> {
    /// A step, decided in each base if it does not say in which.
    pub(super) fn in_either_base(&mut self, mut step: impl FnMut(&mut Self) -> Step) -> Step {
        let plain = step(self);
        if !matches!(&plain, Step::NotRead(found) if found.is_of_base()) {
            return plain;
        }
        let mut all = Logarithm::ALL.iter().map(|(.., base)| {
            self.evidence.assume_logarithm(Some(*base));
            step(self)
        });
        let first = all.next();
        let mut found = all.fold(first, |one, other| match (one?, other) {
            (Step::Follows(one), Step::Follows(other)) => Some(Step::Follows(one.and(other))),
            (Step::Wrong(one), Step::Wrong(other)) if one.instead == other.instead => Some(Step::Wrong(one)),
            (Step::Open(names), Step::Open(_)) => Some(Step::Open(names)),
            _ => None,
        });
        self.evidence.assume_logarithm(None);
        if let Some(Step::Wrong(wrong)) = &mut found {
            // The numbers of a point are those of one base.
            wrong.witness.values.push((r"\log".to_owned(), r"\ln".to_owned()));
        }
        found.unwrap_or(plain)
    }
}
