//! Verdicts kept from one state of a file to the next.
//!
//! A verdict on a claim depends on the symbols, systems, motions and conditions of the file, on the claim's own table, and on
//! the claims that it follows from, directly or through others: they are premises of its proof, and a motion on which they
//! hold and it does not refutes the step. Nothing else of the file is looked at for it. So after a change
//!
//! - of words, places, labels and expectations, nothing is checked again: they are only written beside the verdicts;
//! - in some claims, these and all that follow from them are checked again, beside what is known of their premises;
//! - outside of all claims, in the symbols of a claim, or in the order of the claims, everything is checked again.
//!
//! What is compared is content: comments, spaces and the order of keys change nothing.

use std::collections::BTreeSet;

use super::{Account, CheckError, ClaimAccount, Options, check, check_beside, units};
use crate::derivation::Derivation;

/// The verdicts on one file, and the content that they are of.
#[derive(Debug, Default)]
pub struct Cache {
    known: Option<Known>,
}

#[derive(Debug)]
struct Known {
    /// Everything but claims and words.
    base: String,
    /// Id and content of every claim, without words.
    claims: Vec<(String, String)>,
    account: Account,
}

impl Cache {
    /// The account of the whole file, and the ids of the claims that were checked for it.
    ///
    /// # Errors
    /// Those of [`check`]; what was known is forgotten then.
    pub fn check(&mut self, derivation: &mut Derivation) -> Result<(Account, Vec<String>), CheckError> {
        let known = self.known.take();
        let Some((base, claims)) = contents(derivation) else {
            let account = check(derivation, &Options::default(), &|_, _| {})?;
            let all = ids(derivation);
            return Ok((account, all));
        };
        let mut checked = ids(derivation);
        let order = |claims: &[(String, String)]| claims.iter().map(|(id, _)| id.clone()).collect::<Vec<_>>();
        let mut account = match known {
            // Where claims come or go, those that stay may be premises of others, or may be taken apart from them.
            Some(known) if known.base == base && order(&known.claims) == order(&claims) => {
                let changed = claims.iter().zip(&known.claims).filter(|(here, then)| here != then);
                checked = affected(derivation, changed.map(|((id, _), _)| id.clone()).collect());
                let mut account = known.account;
                if !checked.is_empty() {
                    let options = Options { claims: checked.clone(), ..Options::default() };
                    account.claims.retain(|c| !checked.contains(&c.id));
                    let fresh = check_beside(derivation, &options, &account.claims)?;
                    account.claims.extend(fresh);
                }
                account
            }
            _ => check(derivation, &Options::default(), &|_, _| {})?,
        };
        describe(derivation, &mut account);
        self.known = Some(Known { base, claims, account: account.clone() });
        Ok((account, checked))
    }
}

/// The words of a claim and of its readings: they are shown, and no verdict depends on them.
const WORDS: [&str; 7] = ["says", "place", "label", "printed", "remark", "expect", "expect-units"];

/// The content of everything but claims, and that of each claim, both without words.
fn contents(derivation: &Derivation) -> Option<(String, Vec<(String, String)>)> {
    let mut root: toml::Table = toml::from_str(&derivation.file.text).ok()?;
    let claims = match root.remove("claim") {
        Some(toml::Value::Array(claims)) => claims,
        _ => Vec::new(),
    };
    root.remove("derivation");
    root.remove("conventions");
    let mut symbols = String::new();
    let mut one = |mut claim: toml::Value| {
        symbols.push_str(&taken_apart(claim.as_table_mut()?));
        for reading in claim.get_mut("reading").and_then(toml::Value::as_array_mut).into_iter().flatten() {
            symbols.push_str(&taken_apart(reading.as_table_mut()?));
        }
        Some((claim.get("id")?.as_str()?.to_owned(), claim.to_string()))
    };
    let claims = claims.into_iter().map(&mut one).collect::<Option<_>>()?;
    Some((root.to_string() + &symbols, claims))
}

/// Takes the words and the symbols out of a claim; the symbols are returned, since motions know the observables of all claims.
fn taken_apart(claim: &mut toml::Table) -> String {
    for key in WORDS {
        claim.remove(key);
    }
    claim.remove("symbols").map_or(String::new(), |symbols| format!("{symbols}\n"))
}

fn ids(derivation: &Derivation) -> Vec<String> {
    let mut out: Vec<String> = derivation.claims.iter().map(|c| c.id.clone()).collect();
    out.dedup();
    out
}

/// The changed claims, and all that follow from them, in the order of the file.
fn affected(derivation: &Derivation, changed: BTreeSet<String>) -> Vec<String> {
    let follows = |of: &str, from: &str| {
        let base = |name: &str| name.split('/').next().unwrap_or(name) == from;
        derivation.claims.iter().any(|c| c.id == of && c.follows_from.iter().any(|f| base(f)))
    };
    let all = ids(derivation);
    let mut out = changed;
    loop {
        let next = |id: &&String| !out.contains(*id) && out.iter().any(|known| follows(id, known));
        let more: Vec<String> = all.iter().filter(next).cloned().collect();
        if more.is_empty() {
            return all.into_iter().filter(|id| out.contains(id)).collect();
        }
        out.extend(more);
    }
}

/// Brings an account into the order of the file, with its words, expectations and units.
fn describe(derivation: &Derivation, account: &mut Account) {
    let mut known: Vec<ClaimAccount> = std::mem::take(&mut account.claims);
    for claim in &derivation.claims {
        let Some(at) = known.iter().position(|c| c.id == claim.id && c.reading == claim.reading) else { continue };
        let mut found = known.swap_remove(at);
        found.says.clone_from(&claim.says);
        found.place.clone_from(&claim.place);
        found.remark.clone_from(&claim.remark);
        for pair in &mut found.results {
            let tried = claim.trajectories.iter().zip(&claim.expect);
            let expected = tried.filter(|(t, _)| derivation.trajectories[**t].id == pair.trajectory);
            pair.expected = expected.map(|(_, e)| *e).next().flatten();
        }
        if let (Some(found), Some(declared)) = (&mut found.region, &claim.region) {
            found.expected = declared.expect;
        }
        account.claims.push(found);
    }
    account.units = units::units(derivation);
}
