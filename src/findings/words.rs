//! Words of accounts that are read back: each is one of those that the program says.
//!
//! **In:** what a record of an earlier check holds. **Out:** the word, or an error where it is none.

use serde::de::{Deserialize, Deserializer, Error};

/// One of the words that the program says.
pub type Word = &'static str;

/// The words for how a claim stands on a motion.
const OUTCOMES: [&str; 4] = ["holds", "fails", "not-applicable", "undecided"];
/// The words for how a claim stands for all values.
const STANDINGS: [&str; 5] = ["proved", "proved except", "proved given", "refuted", "undecided"];
/// The words for where a motion is from.
const SOURCES: [&str; 3] = ["integrated", "formula", "derived"];

fn one_of<'de, D: Deserializer<'de>>(word: &str, known: &[&'static str]) -> Result<&'static str, D::Error> {
    known.iter().find(|k| **k == word).copied().ok_or_else(|| D::Error::custom(format!("`{word}` is no word for this")))
}

fn perhaps<'de, D: Deserializer<'de>>(from: D, known: &[&'static str]) -> Result<Option<&'static str>, D::Error> {
    Option::<String>::deserialize(from)?.map(|word| one_of::<D>(&word, known)).transpose()
}

/// What a file expects of a claim.
pub fn expected<'de, D: Deserializer<'de>>(from: D) -> Result<Option<&'static str>, D::Error> {
    perhaps(from, &OUTCOMES)
}

/// How a premise stands.
pub fn standing<'de, D: Deserializer<'de>>(from: D) -> Result<Option<&'static str>, D::Error> {
    perhaps(from, &STANDINGS)
}

/// Where a motion is from.
pub fn source<'de, D: Deserializer<'de>>(from: D) -> Result<&'static str, D::Error> {
    one_of::<D>(&String::deserialize(from)?, &SOURCES)
}
