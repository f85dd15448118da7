//! How much work the families of a file may take.
//!
//! **Guaranteed:** no limit depends on the machine, so that what is counted before one is reached is the same everywhere.

use reason::Plain;

/// So many numbers are looked at between two looks at the limits. It does not depend on the machine.
pub(super) const WAVE: u64 = 256;
/// So many members are integrated together.
pub(super) const TOGETHER: usize = 8;
/// The most members of the families of a file that are tried.
pub(super) const MOST_MEMBERS: u64 = 1_000_000;
/// The most numbers of members that are looked at, rejected ones counted.
const MOST_NUMBERS: u64 = 100_000_000;
/// The most motions that are tried to find the boundaries on the map of one family.
pub(super) const MOST_BETWEEN: u64 = 100_000;
/// The most steps of integration of all members of the families of a file.
const MOST_STEPS: u64 = 300_000_000;

/// What is left of the work that the families of a file may take.
pub(super) struct Budget {
    pub members: u64,
    pub numbers: u64,
    pub steps: u64,
}

impl Default for Budget {
    fn default() -> Budget {
        Budget { members: MOST_MEMBERS, numbers: MOST_NUMBERS, steps: MOST_STEPS }
    }
}

impl Budget {
    /// Why no more is begun.
    pub fn reached(&self) -> Option<Plain> {
        match (self.members, self.numbers, self.steps) {
            (0, ..) => Some(Plain::MembersTried),
            (_, 0, _) => Some(Plain::MembersRejected),
            (.., 0) => Some(Plain::StepsTaken),
            _ => None,
        }
    }
}
