//! What many reasons have in common: where, by how much.

use number::{NoValue, six};
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// A number with as many digits as a reader compares.
pub fn short(x: &f64) -> String {
    six(*x)
}

/// A time, or the direction in which it goes on.
#[derive(Clone, Copy, Debug, PartialEq, Error, Serialize, Deserialize)]
pub enum Instant {
    #[error("t = {}", six(*.0))]
    Time(f64),
    #[error("∞")]
    Infinity,
    #[error("−∞")]
    MinusInfinity,
}

/// Where something stays open.
#[derive(Clone, Copy, Debug, PartialEq, Error, Serialize, Deserialize)]
pub enum Place {
    /// A stretch that is not halved any more.
    #[error(", on [{}, {}]", six(*.0), six(*.1))]
    Stretch(f64, f64),
    /// A time that no shorter stretch could help.
    #[error(", at t = {}, where the enclosure is too wide", six(*.0))]
    Time(f64),
    /// An event, which lies between two times.
    #[error(", at the event at t = {}", six(*.middle))]
    Event { middle: f64, from: f64, to: f64 },
}

impl Place {
    /// Its first and its last time.
    pub fn ends(&self) -> (f64, f64) {
        match *self {
            Place::Stretch(from, to) | Place::Event { from, to, .. } => (from, to),
            Place::Time(t) => (t, t),
        }
    }
}

/// Both sides of a relation at a time, and the error bound of their difference.
#[derive(Clone, Copy, Debug, PartialEq, Error, Serialize, Deserialize)]
#[error("at t = {} its sides are {} and {} (error bound {bound:.1e})", short(.t), short(.left), short(.right))]
pub struct Sides {
    pub t: f64,
    pub left: f64,
    pub right: f64,
    pub bound: f64,
}

/// Why a search for zeros on a stretch of time is incomplete.
#[derive(Clone, Copy, Debug, PartialEq, Error, Serialize, Deserialize)]
pub enum Gap {
    #[error("on [{}, {}] there is no value ({why})", short(.from), short(.to))]
    NoValue { from: f64, to: f64, why: NoValue },
    #[error("on [{}, {}] it stays within its error of 0", short(.0), short(.1))]
    Vanishing(f64, f64),
    #[error("[{}, {}] could not be resolved", short(.0), short(.1))]
    Unresolved(f64, f64),
}

/// What follows, after a mark; nothing where there is nothing.
pub(super) fn after<T: std::fmt::Display>(mark: &str, of: &Option<T>) -> String {
    of.as_ref().map_or_else(String::new, |of| format!("{mark}{of}"))
}
