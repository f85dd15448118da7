//! What an enclosure shows, and why it does not decide.

use super::shape::after;
use super::{Instant, Place, Proving, Reason};
use number::{NoValue, six};
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use thiserror::Error;

/// What an enclosure shows of a claim, and why it does not decide one.
#[derive(Clone, Debug, PartialEq, Error, Serialize, Deserialize)]
pub enum Enclosing {
    /// How many stretches the span was cut into; how far off the sides may be at most, and the size of their terms.
    #[error("for every t of the span: in {stretches} stretches{}", .within.map_or_else(String::new, |(gap, scale)| format!(", within {gap:.1e} where terms are {scale:.1e}")))]
    EveryTime { stretches: usize, within: Option<(f64, f64)> },
    #[error("for every t of both spans: in {stretches} stretches, within {gap:.1e}")]
    EveryCommonTime { stretches: usize, gap: f64 },
    #[error("excluded {0}")]
    Excluded(Arc<Reason>),
    #[error("{0}, wherever it says something")]
    WhereverItSays(Arc<Reason>),
    #[error("at all {0} events in the span")]
    AllEvents(usize),
    #[error("at none of the {0} events in the span does it have a value")]
    NoEventHasValue(usize),
    #[error("certified{0}")]
    Certified(Refutation),
    /// Of something that was never to happen.
    #[error("certain{0}")]
    Certain(Refutation),
    #[error("{0}; certified")]
    AlsoCertified(Arc<Reason>),
    #[error("an assumption is not met: {0}")]
    Unmet(Arc<Reason>),
    #[error("at t = {} the limit is another one", six(*.0))]
    AnotherLimit(f64),
    #[error("at t = {t} the limits of the sides are at most {1:.1e} apart", t = six(*.0))]
    LimitsAgree(f64, f64),
    #[error("certain of the limit at t = {}", six(*.0))]
    LimitCertain(f64),
    #[error("by the laws of limits at {0}{gap}", gap = after(": the limits of the sides are at most ", &.1.map(|gap| format!("{gap:.1e} apart"))))]
    LawsOfLimits(Instant, Option<f64>),
    #[error("no time near t = {} counts", six(*.0))]
    NoTimeNear(f64),
    /// What the enclosure does not settle, beside what was known before.
    #[error("{}not enclosed: {why}", .before.as_ref().map_or_else(String::new, |before| format!("{before}; ")))]
    NotEnclosed { before: Option<Arc<Reason>>, why: Arc<Reason> },
    #[error("whether there is a value everywhere is open: {0}")]
    ValueOpen(Arc<Reason>),
    #[error("samples do not decide it, and the enclosure does not: {0}")]
    Undecided(Arc<Reason>),
    #[error("{what}{place}")]
    Placed { what: Arc<Reason>, place: Place },
    #[error("the sides of `{label}` cannot be told apart: their difference lies in [{from:.2e}, {to:.2e}]")]
    NotApart { label: Arc<str>, from: f64, to: f64 },
    #[error("{name}: the difference lies in [{from:.2e}, {to:.2e}]")]
    StateNotApart { name: Arc<str>, from: f64, to: f64 },
    #[error("{0}: {1}")]
    StateHasNoValue(Arc<str>, NoValue),
    #[error("`{0}` has no value: {1}")]
    NoValue(Arc<str>, NoValue),
    #[error("whether there is a value cannot be told: {0}")]
    ValueUnknown(NoValue),
    #[error("its values are known only to within {0:.1e}")]
    KnownWithin(f64),
    #[error("near t = {} the sides differ", six(*.0))]
    DifferNear(f64),
    #[error("at {0} the {1} differ by something in [{2:.2e}, {3:.2e}]")]
    DifferBy(Instant, Compared, f64, f64),
    #[error("that the assumptions hold near t = {} is not certain", six(*.0))]
    AssumedNear(f64),
    #[error("whether the assumptions hold at t = {} is not certain", six(*.0))]
    AssumedAt(f64),
    #[error("near t = {t} the quantity is {1}", t = six(*.0))]
    NoLimit(f64, NoValue),
    #[error("after some time the quantity is {0}")]
    NoTail(NoValue),
    #[error("whether there is a limit at {0} is not seen from the formula")]
    LimitUnknown(Instant),
    #[error("at t = {} the enclosures of the two motions overlap", six(*.0))]
    MotionsOverlap(f64),
    #[error("at t = {} the enclosure does not exclude it{why}", six(*.0), why = after(": ", .1))]
    NotExcluded(f64, Option<Arc<Reason>>),
    #[error("at the event at t = {} the enclosure does not exclude it", six(*.0))]
    NotExcludedAtEvent(f64),
    #[error("whether there is an event at an end of [{0:.6}, {1:.6}] cannot be told")]
    EventAtEnd(f64, f64),
    #[error("which way the event at t = {} is passed is not certain", six(*.0))]
    DirectionOpen(f64),
    #[error("whether the event at t = {} counts is not certain", six(*.0))]
    EventCounts(f64),
    #[error("the work limit of {operations} operations was reached at t = {}", six(*.at))]
    WorkLimit { operations: usize, at: f64 },
    #[error("the sampled motion is withdrawn: {0}")]
    Withdrawn(Arc<Reason>),
    /// How far the sides are apart on the motion that samples see, with the error bound; and on the enclosed one.
    #[error("at t = {t} the sides differ by {} ± {:.1e} on the sampled motion, and by {} ± {:.1e} on the enclosed one", .sampled.0, .sampled.1, .enclosed.0, .enclosed.1)]
    Contradiction { t: f64, sampled: (f64, f64), enclosed: (f64, f64) },
    /// A state of the motion that samples see, with its error bound; and of the enclosed one, with its width.
    #[error("at t = {t} a state is {} ± {:.1e} on the sampled motion, and {}, known up to {:.1e}, on the enclosed one", .sampled.0, .sampled.1, .enclosed.0, .enclosed.1)]
    StateApart { t: f64, sampled: (f64, f64), enclosed: (f64, f64) },
    #[error("at t = {t} the sides differ by {difference:e} ± {bound:.1e} on the sampled motion{}", if *.excluded { ", and the enclosed one excludes it" } else { "" })]
    SampledApart { t: f64, difference: f64, bound: f64, excluded: bool },
}

/// What differs.
#[derive(Clone, Copy, Debug, PartialEq, Error, Serialize, Deserialize)]
pub enum Compared {
    #[error("sides")]
    Sides,
    #[error("limits")]
    Limits,
}

/// How something is false for certain.
#[derive(Clone, Copy, Debug, PartialEq, Error, Serialize, Deserialize)]
pub enum Refutation {
    #[error(" at t = {}", six(*.0))]
    At(f64),
    #[error(" at t = {}: no value exists there", six(*.0))]
    NoValue(f64),
    #[error(", the enclosures of the two {} lie apart: at t = {}", if *.motions { "motions" } else { "sides" }, six(*.t))]
    Apart { motions: bool, t: f64 },
    #[error(", at the event at t = {}", six(*.0))]
    AtEvent(f64),
    #[error(": it takes different values at t = {} and t = {}", six(*.0), six(*.1))]
    TwoValues(f64, f64),
    #[error(" in exact arithmetic: at t = {} only {rank} of the {of} functions are independent", six(*.t))]
    Dependent { t: f64, rank: usize, of: usize },
    #[error(" by the laws of limits: at {0} the sides differ by {t}", t = six(*.1))]
    LimitsDiffer(Instant, f64),
    #[error(" by the laws of limits: at {at} the difference goes to {}∞, beyond all bounds", if *.up { "" } else { "−" })]
    Unbounded { at: Instant, up: bool },
}

impl From<Refutation> for Reason {
    fn from(refutation: Refutation) -> Reason {
        Enclosing::Certified(refutation).into()
    }
}

impl Reason {
    /// The same, where it is open.
    pub fn placed(self, place: Place) -> Reason {
        Enclosing::Placed { what: Arc::new(self), place }.into()
    }

    /// Where a verdict stays open, and what encloses the difference of two sides that it cannot tell apart.
    pub fn obstacle(&self) -> Option<(Place, Option<(f64, f64)>)> {
        let of = match self {
            Reason::Enclosing(of) => of,
            Reason::Proving(Proving::RateOpen(t)) => return Some((Place::Time(*t), None)),
            _ => return None,
        };
        match of {
            Enclosing::NotEnclosed { why, .. } | Enclosing::ValueOpen(why) | Enclosing::Undecided(why) => {
                why.obstacle()
            }
            Enclosing::Placed { what, place } => {
                let difference = match **what {
                    Reason::Enclosing(
                        Enclosing::NotApart { from, to, .. } | Enclosing::StateNotApart { from, to, .. },
                    ) => Some((from, to)),
                    _ => None,
                };
                Some((*place, difference))
            }
            _ => None,
        }
    }
}
