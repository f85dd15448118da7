//! What a proof shows, on a motion and for all values, and why there is none. Formulas are as they are shown.

use number::six;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::sync::Arc;
use thiserror::Error;

/// What is proved of a claim, and why it is not.
#[derive(Clone, Debug, PartialEq, Error, Serialize, Deserialize)]
pub enum Proving {
    #[error("whether there is a value near t = {} is open: a rate may have none", six(*.0))]
    RateOpen(f64),
    #[error("by the initial values, at t = {0} exactly")]
    ByStart(f64),
    #[error("with the formulas of the motion put in, it divides by 0 at t = {0} exactly")]
    DividesByZero(f64),
    /// Both sides, which differ by less than numbers of binary64 show where that is said.
    #[error("with the formulas of the motion put in it is an {} in time alone, whose sides differ for certain at t = {}{}", if *.equation { "equation" } else { "inequality" }, six(*.t), if *.unseen { ", by less than binary64 shows" } else { "" })]
    Differ { equation: bool, t: f64, unseen: bool },
    #[error("what is given holds at most where {formula} = 0,{} which was not decided", if *.base { " the base of a power," } else { "" })]
    OnlyWhere { formula: Arc<str>, base: bool },
    #[error("{0} and {1} contradict each other: nothing satisfies both, and nothing follows from them")]
    Contradict(Arc<str>, Arc<str>),
    /// Of a claim that follows from nothing: the systems of its motions.
    #[error(
        "its motions are of several systems, {}, and none of these is given: `follows-from = [\"{}\"]` gives one, and `trajectories = \
         […]` may name the motions of one alone", listed(.0), .0.first().map_or("…", |system| system)
    )]
    SeveralSystems(Vec<Arc<str>>),
    #[error("a premise could not be solved for any of its unknowns: {0} = 0")]
    Unsolved(Arc<str>),
    #[error(
        "both sides agree at one time and have the same rates, but `{0}` may leap to another of its values between"
    )]
    MayLeap(Arc<str>),
}

/// Names, as a sentence counts them.
fn listed(names: &[Arc<str>]) -> String {
    let named: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    match named.as_slice() {
        [others @ .., last] if !others.is_empty() => format!("{} and {last}", others.join(", ")),
        all => all.concat(),
    }
}

/// What a proof needs, or leaves out. Formulas are as they are shown.
#[derive(Clone, Debug, PartialEq, Eq, Error, Serialize, Deserialize)]
pub enum Proviso {
    #[error("{}", .is.of(.formula))]
    Where { formula: Arc<str>, is: Bounded },
    /// For which orders of the sizes of parameters what is needed is so.
    #[error("{0}")]
    Orders(Arc<str>),
    #[error("beyond a time at which {0} leaps or has an edge")]
    Leap(Arc<str>),
    #[error("beyond a time at which {0} = 0, unless the motion is analytic there")]
    Pole(Arc<str>),
    /// What is assumed not to vanish may also have no value between times.
    #[error("beyond a time at which {0} = 0 or has no value")]
    Hole(Arc<str>),
    #[error("where some of it has no value: the other sign counts there")]
    OtherSign,
    /// A relation of the file.
    #[error("{0}")]
    Written(Arc<str>),
}

/// How a formula is bounded.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Bounded {
    NotZero,
    Zero,
    NotNegative,
    Positive,
    Negative,
    NotPositive,
    /// Its absolute value is at most 1.
    ByOne,
}

impl Bounded {
    /// What is bounded, of a formula, and what follows it.
    pub fn parts(self, formula: &str) -> (Cow<'_, str>, &'static str) {
        match self {
            Bounded::NotZero => (formula.into(), " ≠ 0"),
            Bounded::Zero => (formula.into(), " = 0"),
            Bounded::NotNegative => (formula.into(), " ≥ 0"),
            Bounded::Positive => (formula.into(), " > 0"),
            Bounded::Negative => (formula.into(), " < 0"),
            Bounded::NotPositive => (formula.into(), " ≤ 0"),
            Bounded::ByOne => (format!("|{formula}|").into(), " ≤ 1"),
        }
    }

    fn of(self, formula: &str) -> String {
        let (left, rest) = self.parts(formula);
        format!("{left}{rest}")
    }
}

/// What refutes a step.
#[derive(Clone, Debug, PartialEq, Error, Serialize, Deserialize)]
pub enum Refuting {
    /// A point; or two, of which each alone leaves the difference open.
    #[error("{first}{}", .second.as_ref().map_or_else(String::new, |second| format!(" — and {second}: what is given leaves the difference open")))]
    Point { first: Point, second: Option<Point> },
    /// Where one sign should serve for a whole motion: where the upper one does not, and where the lower one does not.
    #[error("upper sign: {upper}; lower sign: {lower}")]
    Signs { upper: Point, lower: Point },
    #[error("left {}, right {} on {trajectory} at t = {}", six(*.left), six(*.right), six(*.t))]
    OnMotion { left: f64, right: f64, trajectory: Arc<str>, t: f64 },
    #[error("it does not hold for {}", joined(.0, false))]
    Sizes(Vec<Coordinate>),
}

/// Both sides at a point; numbers as they are shown.
#[derive(Clone, Debug, PartialEq, Error, Serialize, Deserialize)]
#[error("{}", self.shown(false))]
pub struct Point {
    pub left: String,
    pub right: String,
    pub at: Vec<Coordinate>,
}

/// What is put in.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Coordinate {
    Value(String, String),
    /// An angle, by its cosine and sine.
    Circle(String, String, String),
    /// So many more, by which what is given holds.
    Beyond(usize),
}

impl Coordinate {
    /// In words; with the name between dollars where that is asked for.
    pub fn shown(&self, marked: bool) -> String {
        let mark = if marked { "$" } else { "" };
        match self {
            Coordinate::Value(name, value) => format!("{mark}{name}{mark} = {value}"),
            Coordinate::Circle(name, cos, sin) => format!("{mark}cos {name}{mark} = {cos}, sin {name} = {sin}"),
            Coordinate::Beyond(n) => format!("{n} more values, by which what is given holds"),
        }
    }
}

fn joined(coordinates: &[Coordinate], marked: bool) -> String {
    joined_within(coordinates, marked, usize::MAX)
}

/// The first ones, and how many more there are.
fn joined_within(coordinates: &[Coordinate], marked: bool, most: usize) -> String {
    let shown = &coordinates[..coordinates.len().min(most)];
    let more = super::ranges::more_values(coordinates.len() - shown.len());
    shown.iter().map(|c| c.shown(marked)).chain(more).collect::<Vec<_>>().join("; ")
}

impl Point {
    /// In words, with names between dollars where that is asked for.
    fn shown(&self, marked: bool) -> String {
        self.shown_within(marked, usize::MAX)
    }

    /// The same with at most so many of its coordinates.
    fn shown_within(&self, marked: bool, most: usize) -> String {
        format!("left {}, right {} at {}", self.left, self.right, joined_within(&self.at, marked, most))
    }
}

impl Refuting {
    /// In words, with the names of a point between dollars.
    pub fn marked(&self) -> String {
        self.marked_within(usize::MAX)
    }

    /// The same with at most so many coordinates of each point.
    pub fn marked_within(&self, most: usize) -> String {
        let shown = |of: &Point| of.shown_within(true, most);
        match self {
            Refuting::Point { first, second } => {
                let second =
                    second.as_ref().map(|p| format!(" — and {}: what is given leaves the difference open", shown(p)));
                format!("{}{}", shown(first), second.unwrap_or_default())
            }
            Refuting::Signs { upper, lower } => {
                format!("upper sign: {}; lower sign: {}", shown(upper), shown(lower))
            }
            Refuting::OnMotion { .. } | Refuting::Sizes(_) => self.to_string(),
        }
    }
}
