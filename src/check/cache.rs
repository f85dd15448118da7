//! Verdicts kept from one state of a file to the next.
//!
//! A verdict on a claim depends on the symbols, systems, motions and conventions of the file, on the claim's own table, and on
//! the claims that it follows from, directly or through others: they are premises of its proof, and a motion on which they
//! hold and it does not refutes the step. Nothing else of the file is looked at for it. So after a change
//!
//! - outside of all claims, everything is checked again;
//! - in some claims, these and all that follow from them are checked again, together with their premises.
//!
//! What is compared is content: comments, spaces and the order of keys change nothing.

use std::collections::BTreeSet;

use super::{Account, CheckError, Options, check};
use crate::derivation::Derivation;

/// The verdicts on one file, and the content that they are of.
#[derive(Debug, Default)]
pub struct Cache {
    known: Option<Known>,
}

#[derive(Debug)]
struct Known {
    /// Everything but claims.
    base: String,
    /// Id and content of every claim.
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
        let account = match known {
            Some(known) if known.base == base => {
                let is_new = |id: &String| {
                    let here = claims.iter().find(|(i, _)| i == id);
                    here != known.claims.iter().find(|(i, _)| i == id)
                };
                checked = affected(derivation, checked.into_iter().filter(is_new).collect());
                if checked.is_empty() {
                    ordered(derivation, &known.account, None)
                } else {
                    let options = Options { claims: checked.clone(), ..Options::default() };
                    let fresh = check(derivation, &options, &|_, _| {})?;
                    ordered(derivation, &known.account, Some(&fresh))
                }
            }
            _ => check(derivation, &Options::default(), &|_, _| {})?,
        };
        self.known = Some(Known { base, claims, account: account.clone() });
        Ok((account, checked))
    }
}

/// The content of everything but claims, and that of each claim.
fn contents(derivation: &Derivation) -> Option<(String, Vec<(String, String)>)> {
    let mut root: toml::Table = toml::from_str(&derivation.file.text).ok()?;
    let claims = match root.remove("claim") {
        Some(toml::Value::Array(claims)) => claims,
        _ => Vec::new(),
    };
    let one = |claim: toml::Value| Some((claim.get("id")?.as_str()?.to_owned(), claim.to_string()));
    Some((root.to_string(), claims.into_iter().map(one).collect::<Option<_>>()?))
}

fn ids(derivation: &Derivation) -> Vec<String> {
    let mut out: Vec<String> = derivation.claims.iter().map(|c| c.id.clone()).collect();
    out.dedup();
    out
}

/// The changed claims, all that follow from them, and the premises of all of these, in the order of the file.
fn affected(derivation: &Derivation, changed: BTreeSet<String>) -> Vec<String> {
    let follows = |of: &str, from: &str| {
        let base = |name: &str| name.split('/').next().unwrap_or(name) == from;
        derivation.claims.iter().any(|c| c.id == of && c.follows_from.iter().any(|f| base(f)))
    };
    let all = ids(derivation);
    let mut out = changed;
    let mut grow = |reaches: &dyn Fn(&String, &String) -> bool| {
        loop {
            let more: Vec<String> =
                all.iter().filter(|id| !out.contains(*id) && out.iter().any(|o| reaches(id, o))).cloned().collect();
            if more.is_empty() {
                return;
            }
            out.extend(more);
        }
    };
    grow(&|id, known| follows(id, known));
    grow(&|id, known| follows(known, id));
    all.into_iter().filter(|id| out.contains(id)).collect()
}

/// The claims of the file in its order: the fresh accounts where there are some, the known ones elsewhere.
fn ordered(derivation: &Derivation, known: &Account, fresh: Option<&Account>) -> Account {
    let find = |account: &Account, id: &str, reading: &Option<String>| {
        account.claims.iter().find(|c| c.id == id && c.reading == *reading).cloned()
    };
    let one = |c: &crate::derivation::Claim| {
        let fresh = fresh.and_then(|f| find(f, &c.id, &c.reading));
        fresh.or_else(|| find(known, &c.id, &c.reading))
    };
    Account { claims: derivation.claims.iter().filter_map(one).collect(), ..known.clone() }
}
