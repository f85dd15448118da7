//! When an equation is known: a set of times, or of places.
//!
//! **In:** what somebody gives. **Out:** [`Known`], an equation with the times at which it holds. **Guaranteed:** the engine derives, and
//! takes products apart "for a while", only what is known on intervals; it uses at a fixed time only what is known always; what is known
//! at the present alone is used there alone.
//!
//! | rule | from | to | because |
//! |---|---|---|---|
//! | given | the file | what it is quantified over | it says so |
//! | restrict | always | chosen, at c | fewer times |
//! | rate | on intervals | the same | a derivative looks at a neighbourhood; it has a value only where the function has no edge: that need is told, see [`Condition::Rate`](super::Condition::Rate) |
//! | case | any | the same | a·b = 0 at a time: a = 0 or b = 0 there |
//! | case for a while | on intervals | on intervals | where a continuous function is 0 and not limit of times at which it is not, it is 0 around |
//!
//! Nothing leads from single times to intervals, or from the times that a claim chooses to others.

use expr::Expr;

/// A set of times, or of places of fields: each is contained in the next.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum When {
    /// One fixed time, which is the present of the question.
    At(Expr),
    /// The times that a claim chooses; some may be single.
    #[default]
    Chosen,
    /// The same, where each has a neighbourhood of such.
    ChosenOpen,
    /// All times; both sides have values at all of them.
    Always,
}

impl When {
    /// Whether each of the times has a neighbourhood of such: what is known there is known with its derivatives.
    pub fn is_on_intervals(self) -> bool {
        match self {
            When::At(_) | When::Chosen => false,
            When::ChosenOpen | When::Always => true,
        }
    }

    /// The times that are among both.
    #[must_use]
    pub fn and(self, other: When) -> When {
        match (self, other) {
            (at @ When::At(_), _) | (_, at @ When::At(_)) => at,
            (When::Chosen, _) | (_, When::Chosen) => When::Chosen,
            (When::ChosenOpen, _) | (_, When::ChosenOpen) => When::ChosenOpen,
            (When::Always, When::Always) => When::Always,
        }
    }
}

/// An equation that is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Known {
    /// Its left side.
    pub left: Expr,
    /// Its right side.
    pub right: Expr,
    /// The times at which both are equal.
    pub when: When,
}

impl Known {
    /// An equation that holds at some times.
    pub fn of((left, right): (Expr, Expr), when: When) -> Known {
        Known { left, right, when }
    }

    /// Both sides.
    pub fn sides(&self) -> (Expr, Expr) {
        (self.left, self.right)
    }

    /// The same times, other sides.
    #[must_use]
    pub fn with(&self, (left, right): (Expr, Expr)) -> Known {
        Known { left, right, when: self.when }
    }
}
