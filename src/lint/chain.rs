//! Chains: a word for each of their steps; what stands behind a slip.
//!
//! **In:** a chain with a step that is wrong. **Out:** the [`Slip`], at the side that was altered; whether the next step goes on rightly. **Guaranteed:**
//! a step behind a slip follows from the side with the slip, or from the one before it, which is proved in both cases.

use std::ops::Range;

use paper::PrintedRelation;

use super::judge::Judge;
use super::nearest::WrongStep;
use super::step::{Place, Step};
use super::{LintStep, Word};

/// A step that is wrong, and where.
pub(super) struct Slip {
    pub(super) wrong: WrongStep,
    /// The number of the later side of the step.
    pub(super) k: usize,
    /// Whether the step behind it goes on from the side before the slip.
    pub(super) is_taken_back: bool,
}

impl Slip {
    /// The number of the side that was altered: the later one, unless that goes on rightly, nothing proved stands before the earlier one, and
    /// it is the earlier one of which a slip is known.
    pub(super) fn side(&self, chain: &[LintStep]) -> usize {
        let follows = |step: Option<&LintStep>| step.is_some_and(|step| step.word == Word::Follows);
        let before = self.k.checked_sub(2).and_then(|at| chain.get(at));
        let is_earlier =
            self.wrong.is_of_earlier && !self.is_taken_back && follows(chain.get(self.k)) && !follows(before);
        if is_earlier { self.k - 1 } else { self.k }
    }

    /// What is wrong, with what should stand there: behind a side that is proved it is that side, where the later one is a copy of it with a
    /// slip, or where only a slip of the proved one is known.
    pub(super) fn told(self, relation: &PrintedRelation, chain: &[LintStep]) -> WrongStep {
        let before = self.k.checked_sub(2).and_then(|at| chain.get(at));
        let is_behind_proved = before.is_some_and(|step| step.word == Word::Follows);
        let mut wrong = self.wrong;
        if is_behind_proved && (wrong.is_of_earlier || wrong.is_copy) {
            wrong.instead.clone_from(&relation.sides[self.k - 1].text);
        }
        wrong
    }
}

impl Judge<'_> {
    /// A step behind a slip, which may go on from the side before that.
    pub(super) fn behind_slip(
        &mut self,
        relation: &PrintedRelation,
        slip: &mut Slip,
        k: usize,
        place: &Place,
    ) -> Option<Step> {
        if slip.k + 1 != k {
            return None;
        }
        let found = self.step([&relation.sides[k - 2], &relation.sides[k]], place);
        slip.is_taken_back = matches!(found, Step::Follows(_));
        slip.is_taken_back.then_some(found)
    }
}

/// A step of a chain with its word.
pub(super) fn said(span: Range<usize>, word: Word) -> LintStep {
    LintStep { span, word }
}
