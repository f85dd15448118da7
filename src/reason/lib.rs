//! Why a verdict is as it is: reasons as plain data, and their words.
//!
//! **In:** what an engine found: names, formulas as they are printed, times, bounds, counts. **Out:** a [`Reason`], which is kept
//! beside a verdict, compared, written into records, and taken to columns by a report; and its words, by [`Display`].
//!
//! **Guaranteed.** Every number of a sentence is a field of its reason. The words of all engines are made here and nowhere else,
//! when somebody reads them: of the million members of a family nobody does.
//!
//! **Why beside each variant:** a sentence that stands next to the data that it says is changed together with them
//! (`thiserror`, as errors have it). Sentences without data are a table, [`Plain`].
//!
//! [`Display`]: std::fmt::Display

#![forbid(unsafe_code)]

mod enclosed;
mod identity;
mod plain;
mod proved;
mod ranges;
mod sampled;
mod shape;
mod signs;
mod single_motion;

pub use enclosed::{Compared, Enclosing, Refutation};
pub use identity::{Decided, Premises, Reach, Term, Unproved, Way};
pub use plain::Plain;
pub use proved::{Bounded, Coordinate, Point, Proving, Proviso, Refuting};
pub use ranges::{Ranges, Shares};
pub use sampled::{Fate, Sampling, Search};
pub use shape::{Gap, Instant, Place, Sides, short};
pub use signs::{Sign, SignRun, SignsAlong, SignsProved};
pub use single_motion::Alone;

use meter::Ended;
use number::NoValue;
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use thiserror::Error;

/// Why a verdict is as it is: not applicable, undecided, or, as a remark, something else.
#[derive(Clone, Debug, PartialEq, Error, Serialize, Deserialize)]
pub enum Reason {
    #[error("{0}")]
    Plain(Plain),
    /// What a floor below the engines says of itself: a motion that ends, a formula that cannot be derived.
    #[error("{0}")]
    Quoted(Arc<str>),
    #[error("{0}")]
    NoValue(NoValue),
    #[error("{0}")]
    Sampling(Sampling),
    #[error("{0}")]
    Enclosing(Enclosing),
    #[error("{0}")]
    Proving(Proving),
    #[error("{0}")]
    Ranges(Ranges),
    #[error("{0}")]
    Decided(Arc<Decided>),
}

impl Reason {
    /// Whether it is that something has no value at a time.
    pub fn is_no_value(&self) -> bool {
        match self {
            Reason::NoValue(_) | Reason::Sampling(Sampling::NoValue(..) | Sampling::OperationHasNoValue { .. }) => true,
            Reason::Sampling(Sampling::MoreStretches { first: why, .. } | Sampling::At(_, why)) => why.is_no_value(),
            _ => false,
        }
    }

    /// In words, with at most so many values of a point.
    pub fn brief(&self, most: usize) -> String {
        match self {
            Reason::Ranges(of) => of.brief(most),
            other => other.to_string(),
        }
    }

    /// In the words of a lower floor.
    pub fn quoted(said: impl std::fmt::Display) -> Reason {
        Reason::Quoted(said.to_string().into())
    }
}

macro_rules! of {
    ($($part:ident($from:ty)),*) => {
        $(impl From<$from> for Reason {
            fn from(of: $from) -> Reason {
                Reason::$part(of)
            }
        })*
    };
}
of!(
    Plain(Plain),
    NoValue(NoValue),
    Sampling(Sampling),
    Enclosing(Enclosing),
    Proving(Proving),
    Ranges(Ranges),
    Decided(Arc<Decided>)
);

/// What ended a piece of work, as the reason of what is undecided for it.
impl From<Ended> for Reason {
    fn from(ended: Ended) -> Reason {
        match ended {
            Ended::Time => Plain::TimeOver.into(),
            Ended::Memory => Plain::MemoryUsedUp.into(),
            Ended::Cancelled => Plain::Cancelled.into(),
            Ended::Work(..) | Ended::Bytes(..) | Ended::File(..) | Ended::Defect(_) => Reason::quoted(ended),
        }
    }
}
