//! A claim, compiled: the proposition that it denotes, as comparisons that can be measured at points, and what may be spent on it.
//!
//! **In:** a claim of a derivation, and what its user asks for. **Out:** a [`Program`](program::Program): parts, each of them a group of
//! [comparisons](comparison), measured at points of whatever kind: of a motion, of a box, of an altered formula.
//!
//! **Guaranteed:** forms of claims are read for their meaning in [`denote`] and nowhere else; of motions no more is known than which rates
//! they may lack; no verdict is made.

#![forbid(unsafe_code)]

use ::{derivation, expr, flow, latex, number, verdict};

mod block;
pub mod comparison;
pub mod denial;
pub mod denote;
pub mod error;
mod label;
pub mod limits;
pub mod mute;
pub mod options;
pub mod program;
pub mod quantity;
pub mod screen;
pub mod sides;
pub mod surroundings;
pub mod system;
