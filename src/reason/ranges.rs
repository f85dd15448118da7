//! What is known of a claim over ranges of values. Formulas stand between dollars.

use super::{Reason, Refuting};
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use thiserror::Error;

/// What is known of a claim over ranges, and of a point of them.
#[derive(Clone, Debug, PartialEq, Error, Serialize, Deserialize)]
pub enum Ranges {
    #[error("{what}{}", divided(.what, .shares, *.cells))]
    Divided { what: Arc<Reason>, shares: Shares, cells: usize },
    #[error("{}{says}", at(.values))]
    Point { values: Vec<(String, f64)>, says: Arc<Reason> },
    #[error("${formula}${} has the sides {left} and {right}", component.as_ref().map_or_else(String::new, |c| format!(", component {c},")))]
    Sides { formula: Arc<str>, component: Option<Arc<str>>, left: f64, right: f64 },
    #[error("${0}$ has no value")]
    NoValue(Arc<str>),
    /// How many there are at least, and where the first ones lie.
    #[error("there are at least {count} solutions, at {}", .first.iter().map(|of| equations(of)).collect::<Vec<_>>().join(" and at "))]
    Solutions { count: usize, first: Vec<Vec<(String, f64)>> },
    #[error("{0} parts of the box are left, in which there may be solutions")]
    PartsLeft(usize),
    #[error("${formula}$ {} by random evaluation with an error probability of at most 2^{bound}", if *.given { "follows from what is assumed and from the signs of the ranges," } else { "is an identity," })]
    Identity { formula: Arc<str>, given: bool, bound: f64 },
    #[error("${0}$ is an identity between algebraic numbers, compared exactly")]
    Algebraic(Arc<str>),
    #[error(
        "${0}$ was not shown to be an identity; intervals refute an equation, but prove it only where both sides are one number"
    )]
    NoIdentity(Arc<str>),
    // Of fields, whatever they are.
    #[error("what it follows from assumes {}, and it does not say so itself", .0.iter().map(|text| format!("${text}$")).collect::<Vec<_>>().join(", "))]
    Presupposes(Vec<String>),
    #[error("{}{}", CONTRADICTED, .0.marked())]
    Contradicted(Arc<Refuting>),
    #[error("for all fields{}", fields(.given, .assumed))]
    AllFields { given: bool, assumed: bool },
}

/// The shares of a box.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Shares {
    pub proved: f64,
    pub refuted: f64,
    pub not_applicable: f64,
    pub undecided: f64,
}

impl std::fmt::Display for Shares {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let parts = [
            (self.proved, "proved"),
            (self.refuted, "refuted"),
            (self.not_applicable, "outside of what it applies to"),
            (self.undecided, "undecided"),
        ];
        let there = parts.iter().filter(|(share, _)| *share > 0.0);
        let whole = there.clone().count() == 1;
        let said: Vec<String> = there.map(|(share, word)| format!("{} {word}", percent(*share, whole))).collect();
        f.write_str(&said.join(", "))
    }
}

/// What became of the ranges beside what is said. Where a point refutes the claim and nothing else is decided, that does not make it undecided.
fn divided(what: &Reason, shares: &Shares, cells: usize) -> String {
    let parts = if cells > 1 { format!(" (the ranges divided into {cells} parts)") } else { String::new() };
    match what {
        Reason::Ranges(Ranges::Point { .. }) if shares.undecided >= 1.0 => {
            format!("; whether it fails elsewhere is not decided{parts}")
        }
        _ => format!(": {shares}{parts}"),
    }
}

fn percent(share: f64, whole: bool) -> String {
    match 100.0 * share {
        p if share > 0.0 && p < 0.1 => "less than 0.1 %".to_owned(),
        p if !whole && p > 99.9 => "more than 99.9 %".to_owned(),
        p => format!("{} %", (10.0 * p).round() / 10.0),
    }
}

fn equations(values: &[(String, f64)]) -> String {
    values.iter().map(|(name, x)| format!("${name}={x}$")).collect::<Vec<_>>().join(", ")
}

/// What stands before the point of a solution that contradicts a claim.
const CONTRADICTED: &str = "a solution near a point contradicts it: ";

impl Ranges {
    /// In words, with at most so many values of a point.
    pub fn brief(&self, most: usize) -> String {
        match self {
            Ranges::Divided { what, shares, cells } => format!("{}{}", what.brief(most), divided(what, shares, *cells)),
            Ranges::Contradicted(point) => format!("{CONTRADICTED}{}", point.marked_within(most)),
            Ranges::Point { values, says } if values.len() > most => {
                let more = more_values(values.len() - most).map(|more| format!(", {more}")).unwrap_or_default();
                format!("at {}{more}: {}", equations(&values[..most]), says.brief(most))
            }
            other => other.to_string(),
        }
    }
}

/// That there are more values than those that are shown.
pub(super) fn more_values(n: usize) -> Option<String> {
    match n {
        0 => None,
        1 => Some("1 more value".to_owned()),
        n => Some(format!("{n} more values")),
    }
}

fn at(values: &[(String, f64)]) -> String {
    if values.is_empty() { String::new() } else { format!("at {}: ", equations(values)) }
}

fn fields(given: &bool, assumed: &bool) -> &'static str {
    match (given, assumed) {
        (false, false) => "",
        (true, false) => " that satisfy what it follows from",
        (false, true) => " that satisfy what it assumes",
        (true, true) => " that satisfy what it follows from and what it assumes",
    }
}
