//! When a claim is tried, or a measure is taken: at the times at which two sides are equal, at those at which one of them passes
//! the other in a direction, or at the n-th of these.
//!
//! **In:** the value of `at`: a formula, or a table with `when`, `direction` and `count`. **Out:** an [`Event`].

use super::form::FormKind;
use super::formula::Written;
use super::keys;
use super::load::{Loader, is_equation};
use super::model::Claim;
use super::table::{Literal, Table, text_of};
use latex::{Relation, Scope, Statement};
use toml::de::DeValue;

/// Which way the left side of an equation passes the right one, as time grows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// From below the right side to above it.
    Up,
    /// From above it to below.
    Down,
}

/// Which of the times at which an equation holds are meant.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Occasion {
    /// Those at which left − right changes its sign in this direction, inside the span. Without it any.
    pub direction: Option<Direction>,
    /// Of these the n-th after the start of the span, n ≥ 1. Without it all.
    pub count: Option<u64>,
}

impl Occasion {
    /// Whether all times are meant at which the equation holds.
    pub fn is_any(&self) -> bool {
        *self == Occasion::default()
    }

    /// What is said after the equation: nothing, ` upwards`, ` for the 2nd time`, or both.
    pub fn words(&self) -> String {
        let direction = match self.direction {
            None => "",
            Some(Direction::Up) => " upwards",
            Some(Direction::Down) => " downwards",
        };
        let ending = |n: u64| match (n % 10, n % 100) {
            (1, h) if h != 11 => "st",
            (2, h) if h != 12 => "nd",
            (3, h) if h != 13 => "rd",
            _ => "th",
        };
        let count = self.count.map(|n| format!(" for the {n}{} time", ending(n))).unwrap_or_default();
        format!("{direction}{count}")
    }
}

/// What a measure takes of a quantity between two events.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Since {
    /// Its value at the second less that at the first.
    Change,
    /// Its average over the time between them.
    Mean,
}

impl Since {
    /// What is said before the quantity.
    pub fn words(self) -> &'static str {
        match self {
            Since::Change => "change",
            Since::Mean => "mean",
        }
    }
}

/// When a claim is tried, or a measure is taken.
#[derive(Clone, Debug)]
pub struct Event {
    /// A relation between scalars, `=`.
    pub equation: Written<Statement>,
    /// Which of the times at which it holds.
    pub occasion: Occasion,
}

impl Event {
    /// The equation in its quotes, and which of its times, for messages.
    pub fn says(&self) -> String {
        format!("`{}`{}", self.equation.text, self.occasion.words())
    }
}

impl Loader<'_> {
    /// What a measure takes between two events, if it does.
    pub(super) fn since(&mut self, table: &Table<'_, '_>, scope: &Scope) -> Option<(Event, Since)> {
        let take = table.get("take").map(|value| match text_of(&mut self.problems, value, "take")? {
            "change" => Some(Since::Change),
            "mean" => Some(Since::Mean),
            word => {
                self.problems.unknown("derivation::unknown-key", value.span(), "take", word, ["change", "mean"]);
                None
            }
        });
        let needed = if table.get("since").is_some() { "at" } else { "since" };
        if (table.get("since").is_some() || take.is_some()) && table.get(needed).is_none() {
            let message = format!("what is taken between two events needs `{needed}`");
            self.problems
                .note("derivation::missing-key", table.span.clone(), message)
                .hint("`since` is the first event, `at` the second; both may be the same equation");
            return None;
        }
        let event = self.event(table, "since", scope)?;
        Some((event, said(take)?.unwrap_or(Since::Change)))
    }

    /// The event under `at`, if there is one.
    pub(super) fn at(&mut self, table: &Table<'_, '_>, scope: &Scope) -> Option<Event> {
        self.event(table, "at", scope)
    }

    /// The event under a key, if there is one.
    fn event(&mut self, table: &Table<'_, '_>, key: &str, scope: &Scope) -> Option<Event> {
        let value = table.get(key)?;
        if !matches!(value.get_ref(), DeValue::Table(_)) {
            let formula = table.formula(&mut self.problems, key)?;
            return Some(Event { equation: self.equation(&formula, scope)?, occasion: Occasion::default() });
        }
        let what = if key == "since" { "`since`" } else { "`at`" };
        let table = Table::open(&mut self.problems, value, what, keys::AT)?;
        if table.get("when").is_none() {
            table.missing(&mut self.problems, "when");
        }
        let direction = table.get("direction").map(|value| match text_of(&mut self.problems, value, "direction")? {
            "up" => Some(Direction::Up),
            "down" => Some(Direction::Down),
            word => {
                self.problems.unknown("derivation::unknown-key", value.span(), "direction", word, ["up", "down"]);
                None
            }
        });
        let count = table.get("count").map(|value| {
            let count = self.whole(value, "count")?;
            if count == 0 {
                self.problems
                    .note("derivation::bad-number", value.span(), "times are counted from 1")
                    .hint("count = 1 is the first after the start of the span");
                return None;
            }
            Some(count)
        });
        let formula = table.formula(&mut self.problems, "when")?;
        let equation = self.equation(&formula, scope)?;
        // What was said wrongly is noted, and nothing else is meant instead.
        let (direction, count) = (said(direction)?, said(count)?);
        let occasion = Occasion { direction, count };
        if !occasion.is_any() && equation.value.relations.iter().any(|r| r.left.components.len() != 1) {
            self.problems
                .note("derivation::not-an-event", formula.span.clone(), "complex numbers do not pass one another")
                .hint("compare a real quantity, for instance an argument");
            return None;
        }
        Some(Event { equation, occasion })
    }

    /// One `=` between scalars.
    fn equation(&mut self, formula: &Literal<'_>, scope: &Scope) -> Option<Written<Statement>> {
        let mut statements = self.statements(formula, scope);
        let statement = statements.pop()?;
        let plain = |r: &Relation| is_equation(r) && r.left.shape.rank() == 0 && r.right.shape.rank() == 0;
        let single = statements.is_empty() && statement.value.relations.len() == 1;
        if !single || !statement.value.relations.iter().all(plain) {
            let message = "an event is one equation between scalars";
            self.problems
                .note("derivation::not-an-event", formula.span.clone(), message)
                .hint(r"for instance '\theta=0'");
            return None;
        }
        Some(statement)
    }

    /// A claim that compares times has more than one of them.
    pub(super) fn refuse_a_single_time(&mut self, claim: &Claim) {
        let Some(at) = claim.at.as_ref().filter(|at| at.occasion.count.is_some()) else { return };
        if claim.forms.iter().any(|form| form.kind() == FormKind::FirstIntegral) {
            let message = "`first-integral` compares times, and `count` leaves one";
            self.problems
                .note("derivation::not-an-event", at.equation.span.clone(), message)
                .hint("leave `count` out, or compare with a value at a time: always = ['E=E(0)']");
        }
    }
}

/// A value that may be absent, but not wrong.
fn said<T>(value: Option<Option<T>>) -> Option<Option<T>> {
    match value {
        None => Some(None),
        Some(value) => value.map(Some),
    }
}
