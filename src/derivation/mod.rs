//! Derivation files.

mod model;

pub use model::{
    Claim, Derivation, Form, FormKind, Formula, Measure, Motion, SymbolEntry, System, Trajectory, Written,
};
