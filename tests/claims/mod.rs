//! Random claims with known truth, the oracle of that truth, and the judgement of the program's verdicts.

pub mod claim;
pub mod draw;
pub mod judge;
pub mod line;
pub mod term;
pub mod truth;
