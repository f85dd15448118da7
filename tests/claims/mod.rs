//! Random claims with known truth, the oracle of that truth, and the judgement of the program's verdicts.

pub mod claim;
pub mod draw;
pub mod draw_terms;
pub mod judge;
pub mod line;
pub mod logic;
pub mod metamorphic;
mod oracle;
mod refused;
mod said_alike;
pub mod term;
pub mod truth;
