//! What was decided of an equation for all values, with what it rests on.

use super::Reason;
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use thiserror::Error;

/// What is given beside definitions and assumptions, by name.
#[derive(Clone, Debug, PartialEq, Eq, Error, Serialize, Deserialize)]
#[error("{}", if .0.is_empty() { "the definitions and assumptions".to_owned() } else { format!("the definitions, the assumptions and {}", .0.join(", ")) })]
pub struct Premises(pub Vec<String>);

/// Something that a proof is given, and that is not proved itself: its name, and how it stands.
#[derive(Clone, Debug, PartialEq, Eq, Error, Serialize, Deserialize)]
pub enum Unproved {
    #[error("`{0}`, which is not decided for all values")]
    NotAsked(String),
    #[error("`{name}`, {}", standing(.1), name = .0)]
    Standing(String, String),
    #[error("`{0}`, which is assumed by what is given, and not here")]
    Assumed(String),
}

/// How what is given stands. What a point refutes is no identity, and may hold all the same where it is given.
fn standing(word: &str) -> String {
    match word {
        "refuted" => "which does not hold for all values: where it does not, this says nothing".to_owned(),
        word => format!("which is {word}"),
    }
}

/// How something is proved for all values.
#[derive(Clone, Copy, Debug, PartialEq, Error, Serialize, Deserialize)]
pub enum Way {
    #[error("both sides are algebraic numbers, compared exactly")]
    Algebraic,
    /// log₂ of the bound for the probability of an error.
    #[error("proved by random evaluation, with an error probability of at most 2^{}", .0.ceil())]
    Random(f64),
    #[error("proved by signs, for every order of the sizes")]
    Signs,
}

/// How far a proof reaches.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Reach {
    /// To all values.
    Whole,
    /// To all but special cases.
    Except,
    /// As far as the prover says: the checker has not replayed it.
    Unreplayed,
}

/// The decision on an equation.
#[derive(Clone, Debug, PartialEq, Error, Serialize, Deserialize)]
pub enum Decided {
    #[error("{}: {way}.", head(*.reach, .open, *.way, .given))]
    Proved { reach: Reach, open: Vec<Unproved>, way: Way, given: Premises },
    #[error("Not an identity, given {0}: a point refutes it.")]
    Refuted(Premises),
    #[error("Whether it is an identity, given {given}, is undecided: {}.", .reason.as_ref().map_or_else(|| "no reason is known".to_owned(), ToString::to_string))]
    Undecided { given: Premises, reason: Option<Arc<Reason>> },
}

fn head(reach: Reach, open: &[Unproved], way: Way, given: &Premises) -> String {
    let named = open.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
    match (reach, open.is_empty(), way) {
        (Reach::Except, true, _) => format!("Proved except in special cases, given {given}"),
        (Reach::Except, false, _) => format!("Proved except in special cases, and only given {named}, from {given}"),
        (Reach::Unreplayed, true, _) => {
            format!("Proved by the prover alone, which the checker did not replay, given {given}")
        }
        (Reach::Unreplayed, false, _) => {
            format!(
                "Proved by the prover alone, which the checker did not replay, and only given {named}, from {given}"
            )
        }
        (Reach::Whole, false, _) => format!("Proved only given {named}, from {given}"),
        (Reach::Whole, true, Way::Algebraic | Way::Random(_)) => format!("An identity, given {given}"),
        (Reach::Whole, true, Way::Signs) => format!("True for all values, given {given}"),
    }
}

/// What a list of what a proof needs or leaves out is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum Term {
    #[error("It holds where")]
    Condition,
    #[error("The proof does not reach")]
    Exception,
    #[error("What is given holds, special cases aside, only where")]
    GivenOnlyWhere,
    #[error("What is given assumes")]
    Presupposed,
    #[error("Of the assumptions it uses")]
    Used,
    #[error("Of the assumptions it does not use")]
    Unused,
}
