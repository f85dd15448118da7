//! What is said of conditions.

use serde::{Deserialize, Serialize};

/// A condition as a reader sees it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ConditionName {
    /// Its id in the derivation file; `None` for one that is built from the symbols.
    pub id: Option<String>,
    /// Its formula, or, for a quantity that does not change, that quantity.
    pub formula: String,
    /// In words: those of the file, or `constant`.
    pub says: Option<String>,
    /// Whether its opposite is meant: it is not met throughout.
    pub negated: bool,
}

/// How several conditions are put together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Join {
    /// All of them.
    And,
    /// At least one of them.
    Or,
}

impl Join {
    /// The word.
    pub fn word(self) -> &'static str {
        match self {
            Join::And => "and",
            Join::Or => "or",
        }
    }

    /// All of several, or one of them; `None` where that is open.
    pub fn of(self, parts: impl IntoIterator<Item = Option<bool>>) -> Option<bool> {
        let settles = self == Join::Or;
        let mut open = false;
        for part in parts {
            match part {
                Some(value) if value == settles => return Some(settles),
                Some(_) => {}
                None => open = true,
            }
        }
        (!open).then_some(!settles)
    }
}

/// One condition, or several together, met exactly where a claim holds.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Explanation {
    /// The conditions.
    pub conditions: Vec<ConditionName>,
    /// How they are put together.
    pub join: Join,
}

/// Another explanation, as good on the trajectories to which the claim applies.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Rival {
    /// The explanation.
    pub explanation: Explanation,
    /// Trajectories on which exactly one of the two is met; the claim does not apply to them as they are.
    pub differ_on: Vec<String>,
}

/// What separates the trajectories on which a claim holds from those on which it fails.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Separation {
    /// Where it holds.
    pub holds: Vec<String>,
    /// Where it fails.
    pub fails: Vec<String>,
    /// The weakest that is met exactly where it holds.
    pub explanation: Option<Explanation>,
    /// Others, equally good on these trajectories.
    pub rivals: Vec<Rival>,
    /// How many more rivals there are.
    pub more_rivals: usize,
    /// Without an explanation: conditions that are met only where it holds, and on how many of those trajectories.
    pub sufficient: Vec<(ConditionName, usize)>,
    /// Without an explanation: conditions that are met wherever it holds, and on how many trajectories they are although it fails.
    pub necessary: Vec<(ConditionName, usize)>,
    /// Without an explanation: conditions that may be one, and the few trajectories on which they are undecided.
    pub possible: Vec<(ConditionName, Vec<String>)>,
    /// Conditions that were tried.
    pub tried: usize,
    /// Conditions that may explain something as far as they are decided, but are undecided on one of these trajectories.
    pub undecided: usize,
}

/// Whether a claim needs an assumption, as far as the trajectories show.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Need {
    /// Without it the claim fails on some trajectory.
    Needed,
    /// Without it the claim applies to more, and holds there too.
    NotNeeded,
    /// Without it the claim applies to more, and is undecided on some of that.
    Undecided,
    /// No trajectory meets the other assumptions and not this one.
    Untested,
}

impl Need {
    /// The word of the reports.
    pub fn word(self) -> &'static str {
        match self {
            Need::Needed => "needed",
            Need::NotNeeded => "not-needed",
            Need::Undecided => "undecided",
            Need::Untested => "untested",
        }
    }
}

/// One assumption of a claim.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct AssumptionAccount {
    /// As written.
    pub text: String,
    /// Whether it is needed.
    pub need: Need,
    /// Trajectories that show it: where the claim fails without it, or holds though it is unmet.
    pub on: Vec<String>,
}

/// What was found of the conditions of a claim.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct ConditionsAccount {
    /// Where the claim holds on some trajectories and fails on others.
    pub separation: Option<Separation>,
    /// One entry for each assumption.
    pub assumptions: Vec<AssumptionAccount>,
}
