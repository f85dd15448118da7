//! What samples show, and what they leave open.

use super::shape::{after, short};
use super::{Gap, Reason, Sides};
use number::{NoValue, six};
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use thiserror::Error;

/// What samples show of a claim, and what they leave open.
#[derive(Clone, Debug, PartialEq, Error, Serialize, Deserialize)]
pub enum Sampling {
    #[error("the assumption `{text}` is not met{sides}", sides = after(": ", .sides))]
    NotMet { text: Arc<str>, sides: Option<Sides> },
    #[error("the assumption `{text}` cannot be decided{why}", why = after(": ", .why))]
    AssumptionOpen { text: Arc<str>, why: Option<Arc<Reason>> },
    /// A parameter that is not given there, a state of another system, or what needs one of them.
    #[error("{0} is not known on this motion")]
    NotKnown(Arc<str>),
    #[error("{0} has no value ({1})")]
    NoValue(Arc<str>, NoValue),
    #[error("`{operation}` has no value at {} ({why})", .second.map_or_else(|| short(.first), |second| format!("({}, {})", short(.first), short(&second))))]
    OperationHasNoValue { operation: Arc<str>, first: f64, second: Option<f64>, why: NoValue },
    #[error("{count} more stretches, the first because {first}")]
    MoreStretches { count: usize, first: Arc<Reason> },
    /// Error bounds are too large; `lost`: a term of the formula is below what can be seen.
    #[error("the error bound is too large to tell at {count} of {of} times: {example}; {} would decide", if *.lost { "a formula whose large terms do not cancel" } else { "a more accurate motion or a lower precision" })]
    TooLarge { count: usize, of: usize, example: Arc<Reason>, lost: bool },
    #[error("at {0} further times the error bound is too large to tell")]
    TooLargeElsewhere(usize),
    #[error("at t = {t}, {1}", t = six(*.0))]
    At(f64, Arc<Reason>),
    #[error("at t = {t} it does not hold, and {1}", t = six(*.0))]
    FalseAt(f64, Arc<Reason>),
    #[error("at t = {t:.6} the two sides differ by {difference:.2e}, with an error bound of {bound:.2e}{}", if *.lost { ", below which a term of the formula is lost" } else { "" })]
    Differ { t: f64, difference: f64, bound: f64, lost: bool },
    #[error("first seen at the sample t = {}", six(*.0))]
    FirstSeen(f64),
    #[error("happens first at t = {}", six(*.0))]
    HappensFirst(f64),
    #[error("not seen {}between t = {} and t = {}, the span of the motion{why}", .samples.map_or_else(String::new, |n| format!("at {n} samples ")), six(*.from), six(*.to), why = after(": ", .why))]
    NotSeen { samples: Option<usize>, from: f64, to: f64, why: Option<Arc<Reason>> },
    #[error("{0} does not happen between t = {t} and t = {end}", t = six(*.1), end = six(*.2))]
    NoEvent(Arc<str>, f64, f64),
    #[error("{}{gap}", .search.to_string())]
    Incomplete { search: Search, gap: Gap },
    #[error("{0}")]
    Gap(Gap),
    // At a time that nothing shows exactly.
    #[error("near t = {} it may have a value at a single time", six(*.0))]
    SingleValue(f64),
    #[error("near t = {} some of it may have no value with one sign of ±, and be false with the other", six(*.0))]
    OneSided(f64),
    #[error("near t = {} the motion may leap, and whether `{event}` happens there cannot be told", six(*.t))]
    MotionLeaps { t: f64, event: Arc<str> },
    #[error("an angle or a whole part in `{0}` leaps, and whether the sides meet there cannot be told")]
    EventLeaps(Arc<str>),
    #[error("the sides of `{event}` touch near t = {} without crossing: whether they meet there cannot be told", six(*.t))]
    EventTouches { t: f64, event: Arc<str> },
    #[error("the sides touch near t = {}: whether they meet there cannot be told", six(*.0))]
    Touches(f64),
    #[error("the sides may meet near t = {}, and which time is meant cannot be told", six(*.0))]
    MayMeet(f64),
    #[error("whether the event near t = {} lies in the span cannot be told", six(*.0))]
    EventInSpan(f64),
    #[error("whether the event near t = {} lies inside the span cannot be told", six(*.0))]
    EventInsideSpan(f64),
    #[error("whether the sides pass each other near t = {}, and once, cannot be told", six(*.0))]
    PassOnce(f64),
    #[error("whether the sides meet in the span, near t = {}, cannot be told", six(*.0))]
    MeetInSpan(f64),
    #[error("at t = {}, between two samples, it may be true or false", six(*.0))]
    ValueBetween(f64),
    #[error("near t = {}, between two samples, the error bound is too large to tell", six(*.0))]
    TooLargeBetween(f64),
    #[error("the assumption `{text}` is met at most near single times such as t = {}: whether it is cannot be told", six(*.t))]
    MetAtMostNear { text: Arc<str>, t: f64 },
    #[error("the assumptions may be met at t = {} alone", six(*.0))]
    MetAlone(f64),
    #[error("the assumptions are met on stretches between the samples")]
    MetBetween,
    #[error("the assumptions are met on more than {0} short stretches")]
    MetTooOften(usize),
    #[error("which way the sides of `{0}` pass is not known")]
    DirectionUnknown(Arc<str>),
    #[error("it was tried at {0} events, but {1}")]
    TriedAtEvents(usize, Arc<Reason>),
    #[error("{} the formulas of the motion have no value ({why})", near(.from, .to))]
    MotionHasNoValue { from: f64, to: f64, why: NoValue },
    #[error("{} the formulas of the motion do more than samples can show; a part of the span by itself may decide", near(.from, .to))]
    MotionUnresolved { from: f64, to: f64 },
    // Limits.
    #[error("t = {} lies outside the span [{from}, {to}]", six(*.t))]
    OutsideSpan { t: f64, from: f64, to: f64 },
    #[error("t = {}{} beside it other values are taken", six(*.t), if *.exact { ":" } else { " is known to rounding only, and" })]
    OtherBeside { t: f64, exact: bool },
    #[error("there is no value at t = {} itself ({why}), and points nearby do not decide", six(*.t))]
    NoValueItself { t: f64, why: Arc<Reason> },
    // Independence.
    #[error("only {rank} of the {of} functions are independent there")]
    Dependent { rank: usize, of: usize },
    #[error("dependent at {count} of {of} samples only: independence is generic at best")]
    SometimesDependent { count: usize, of: usize },
    #[error("the rank is unclear at t = {}: a singular value of {size:.1e}", six(*.t))]
    RankUnclear { t: f64, size: f64 },
    #[error("the rank is {rank} of {of} as far as samples tell, whose precision does not tell what is small from 0")]
    RankBelowPrecision { rank: usize, of: usize },
    #[error("near t = {}, between two samples, a singular value falls to {size:.1e}", six(*.t))]
    RankFalls { t: f64, size: f64 },
    #[error("smallest singular value that counts as nonzero: {0:.2e}")]
    SmallestSingularValue(f64),
    #[error("a function names a rate of order {0} that the system does not give")]
    NoRate(u32),
    // Members of a family, side by side.
    #[error("no other member comes after it along ${0}$, or it is the one that others are compared with")]
    LastMember(Arc<str>),
    #[error("it lies where ${0}$ tends to, or beyond")]
    BeyondLimit(Arc<str>),
    #[error("`{0}` has no value on one of the members that are compared")]
    NoValueOnMember(Arc<str>),
    #[error("from ${name}$ = {} on, {why}", six(*.from))]
    FromOn { name: Arc<str>, from: f64, why: Arc<Reason> },
    #[error("the motion with ${name}$ = {} is not where the sequence before it tends to", short(.at))]
    OffSequence { name: Arc<str>, at: f64 },
    #[error("{left} and {right}, up to {bound:.1e}, cannot be told apart")]
    NotApart { left: f64, right: f64, bound: f64 },
    // Measures.
    #[error("`{0}` has no meaning on this motion")]
    NoMeaning(Arc<str>),
    #[error("the sides of `{event}` only touch, near t = {}", six(*.t))]
    OnlyTouches { event: Arc<str>, t: f64 },
    #[error("{0} does not happen on this motion")]
    NeverHappens(Arc<str>),
    #[error("which event comes first near t = {} cannot be told", six(*.0))]
    WhichFirst(f64),
    #[error("{event} may happen at another time before t = {}", six(*.t))]
    MayHappenBefore { event: Arc<str>, t: f64 },
    #[error("{event} does not happen before t = {}", six(*.t))]
    NotBefore { event: Arc<str>, t: f64 },
    #[error("{0} further events are not listed")]
    MoreEvents(usize),
    #[error("no value at t = {}: {why}", six(*.t))]
    NoValueAt { t: f64, why: NoValue },
    /// By dual numbers, and by series with their error bound.
    #[error("{name} at t = {t}: {dual} by dual numbers, {} ± {:e} by series", .series.0, .series.1)]
    TwoRoutesDiffer { name: Arc<str>, t: f64, dual: f64, series: (f64, f64) },
    // Pictures.
    #[error("their length is not constant: it goes from {0:.4} to {1:.4}")]
    LengthVaries(f64, f64),
    // Families, counted.
    #[error("{0} on {1} of {2} members")]
    OnMembers(Fate, u64, u64),
    #[error("it applies to none of {0} members")]
    OnNoMember(u64),
    #[error("{tried} of {of} members were tried: {why}")]
    NotAllTried { tried: u64, of: u64, why: Arc<Reason> },
    #[error("member {number}: {what}")]
    OnMember { number: u64, what: Arc<Reason> },
}

/// What was searched, incompletely.
#[derive(Clone, Debug, PartialEq, Error, Serialize, Deserialize)]
pub enum Search {
    #[error("the search for `{0}` is incomplete: ")]
    Event(Arc<str>),
    #[error("the search between the samples is incomplete: ")]
    Between,
    #[error("the search is incomplete before it: ")]
    Before,
    #[error("when `{0}` is met is not known: ")]
    Assumption(Arc<str>),
}

/// What a claim does on members of a family.
#[derive(Clone, Copy, Debug, PartialEq, Error, Serialize, Deserialize)]
pub enum Fate {
    #[error("it fails")]
    Fails,
    #[error("it is undecided")]
    Undecided,
}

fn near(from: &f64, to: &f64) -> String {
    let (from, to) = (short(from), short(to));
    if from == to { format!("near t = {from}") } else { format!("between t = {from} and t = {to}") }
}
