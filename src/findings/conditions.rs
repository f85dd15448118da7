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

/// The fewest trajectories on each side that tell a condition: on fewer nearly everything that varies separates them.
const FEWEST_ON_A_SIDE: usize = 3;
/// The most conditions, of those that were tried, that may separate the trajectories by accident, on the average.
const MOST_BY_ACCIDENT: f64 = 0.05;

impl Separation {
    /// The explanation, where it is more than an accident: its conditions are named in the file, or there are enough trajectories on
    /// both sides.
    ///
    /// A condition that has nothing to do with the claim, and is met on as many of n trajectories as the claim holds on, is met on just
    /// these h with the chance 1 : C(n, h). So many are tried, alone or put together, that this must be small beside their number.
    pub fn told(&self) -> Option<&Explanation> {
        let is_named = |e: &&Explanation| e.conditions.iter().all(|c| c.id.is_some());
        self.explanation.as_ref().filter(|e| is_named(e) || self.by_accident(e.conditions.len()) <= MOST_BY_ACCIDENT)
    }

    /// How many conditions, so many put together, are expected to separate these trajectories by accident; infinite where one side has
    /// too few.
    fn by_accident(&self, joined: usize) -> f64 {
        let (holds, fails) = (self.holds.len(), self.fails.len());
        if holds.min(fails) < FEWEST_ON_A_SIDE {
            return f64::INFINITY;
        }
        let choices: f64 = (1..=holds.min(fails)).map(|k| (holds.max(fails) + k) as f64 / k as f64).product();
        (0..joined).map(|_| self.tried as f64).product::<f64>() / choices
    }
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

#[cfg(test)]
mod tests {
    use super::*;

    fn separation(holds: usize, fails: usize, tried: usize, id: Option<&str>) -> Separation {
        let name = |id: Option<&str>| ConditionName {
            id: id.map(str::to_owned),
            formula: "a>0".to_owned(),
            says: None,
            negated: false,
        };
        Separation {
            holds: (0..holds).map(|n| format!("h{n}")).collect(),
            fails: (0..fails).map(|n| format!("f{n}")).collect(),
            explanation: Some(Explanation { conditions: vec![name(id)], join: Join::And }),
            rivals: Vec::new(),
            more_rivals: 0,
            sufficient: Vec::new(),
            necessary: Vec::new(),
            possible: Vec::new(),
            tried,
            undecided: 0,
        }
    }

    #[test]
    fn what_separates_few_motions_is_told_only_where_the_file_names_it() {
        for (holds, fails, tried, told) in [
            (1, 1, 2, false),
            (4, 1, 40, false),
            (2, 40, 1, false),
            (3, 3, 16, false),
            (5, 5, 10, true),
            (27, 8, 196, true),
        ] {
            assert_eq!(separation(holds, fails, tried, None).told().is_some(), told, "{holds} {fails}");
            assert!(separation(holds, fails, tried, Some("named")).told().is_some());
        }
        // Of several together more are tried.
        let mut two = separation(5, 5, 10, None);
        let conditions = &mut two.explanation.as_mut().expect("it is there").conditions;
        conditions.push(conditions[0].clone());
        assert!(two.told().is_none());
    }
}
