//! What a comparison needs of a `report.json`, and nothing else of it: what else is in a file takes no memory.
//!
//! **In:** a text that a stranger may have written, or its value. **Out:** ids and verdicts.

use diag::values::{MOST_VALUES, bounded};
use serde::Deserialize;
use serde_json::Value;
use std::sync::Arc;

/// The longest id or word, in bytes. Ids are much shorter; they are told again with each verdict.
const LONGEST: usize = 300;

/// An id, or a word.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Deserialize)]
#[serde(try_from = "String")]
pub(super) struct Name(pub Arc<str>);

impl TryFrom<String> for Name {
    type Error = String;

    fn try_from(text: String) -> Result<Name, String> {
        match text.len() {
            ..=LONGEST => Ok(Name(text.into())),
            n => Err(format!("an id or a word has {n} bytes, more than {LONGEST}")),
        }
    }
}

/// The version of the layout.
#[derive(Deserialize)]
struct Head {
    schema: Option<u64>,
}

/// A report as it was written.
#[derive(Deserialize)]
pub(super) struct Former {
    pub derivation: FormerDerivation,
    pub claims: Vec<FormerClaim>,
}

#[derive(Deserialize)]
pub(super) struct FormerDerivation {
    pub id: Name,
}

#[derive(Deserialize)]
pub(super) struct FormerClaim {
    pub id: Name,
    pub reading: Option<Name>,
    pub identity: Option<Box<FormerVerdict>>,
    pub results: Option<Vec<FormerVerdict>>,
    pub families: Option<Vec<FormerVerdict>>,
    pub region: Option<Box<FormerVerdict>>,
}

#[derive(Deserialize)]
pub(super) struct FormerVerdict {
    pub verdict: Name,
    pub strength: Option<Name>,
    #[serde(default)]
    pub unexpected: bool,
    /// The trajectory, or the family.
    #[serde(alias = "trajectory", alias = "family")]
    pub on: Option<Name>,
}

impl Former {
    /// The report in a text.
    ///
    /// # Errors
    /// A sentence: what the text lacks to be one.
    pub(super) fn read(text: &[u8]) -> Result<Former, String> {
        bounded(text, MOST_VALUES)?;
        let head = serde_json::from_slice(text).map_err(|e| format!("it is not a report in JSON: {e}"))?;
        is_known(&head)?;
        serde_json::from_slice(text).map_err(not_whole)
    }

    /// The report in a value.
    ///
    /// # Errors
    /// The same.
    pub(super) fn of(value: &Value) -> Result<Former, String> {
        is_known(&Head::deserialize(value).map_err(not_whole)?)?;
        Former::deserialize(value).map_err(not_whole)
    }
}

fn not_whole(error: serde_json::Error) -> String {
    format!("it is not a whole report: {error}")
}

fn is_known(head: &Head) -> Result<(), String> {
    match head.schema {
        Some(1) => Ok(()),
        Some(n) => Err(format!("it has schema {n}, this version reads schema 1")),
        None => Err("it is not a report: it has no `schema`".to_owned()),
    }
}
