//! Verdicts kept from one state of a file to the next.
//!
//! A verdict on a claim depends on the symbols, systems, motions and conditions of the file, on the claim's own table, and on
//! the claims that it follows from, directly or through others: they are premises of its proof, and a motion on which they
//! hold and it does not refutes the step. Nothing else of the file is looked at for it. So after a change
//!
//! - of words, places, labels and expectations, nothing is checked again: they are only written beside the verdicts;
//! - in some claims, or where claims come or go, these are checked again, beside what is known of their premises; conditions and
//!   proofs that do not depend on the change are not computed again, see [`super::memory`]. All that follow from them are proved
//!   again, see [`super::follow`](mod@super::follow);
//! - in some motions, everything is checked again, but what others gave is known;
//! - in symbols (those of a claim, too), systems, conditions and measures, everything is computed again.
//!
//! What is compared is content: comments, spaces and the order of keys change nothing.

use std::collections::BTreeSet;

use toml::de::{DeTable, DeValue};

use super::follow::{Followed, follow, strengthen_all};
use super::memory::{Contents, Known as Recalled, Memory, Names};
use super::{check, check_beside, check_recalling, drawn};
use crate::derivation::{Derivation, Family, Motion};
use crate::expr::FastMap;
use claim::error::{CANCELLED, CheckError};
use claim::limits::{Cancel, Limits};
use claim::options::Options;
use findings::{Account, AloneAccount, ClaimAccount, Premises};
use verdict::Outcome;

/// The verdicts on one file, and the content that they are of.
#[derive(Debug, Default)]
pub struct Cache {
    known: Option<Known>,
    memory: Memory,
}

#[derive(Clone, Debug)]
struct Known {
    contents: Contents,
    account: Account,
}

impl Cache {
    /// The account of the whole file, and the ids of the claims that were checked for it; `cancel` ends the check from another thread.
    ///
    /// # Errors
    /// Those of [`check()`]; what was known is forgotten then, unless the check was cancelled.
    pub fn check(
        &mut self,
        derivation: &Derivation,
        cancel: Option<&Cancel>,
    ) -> Result<(Account, Vec<String>), CheckError> {
        let known = self.known.take();
        let before = cancel.and_then(|_| known.clone());
        let found = self.check_from(derivation, known, cancel);
        // Whatever it says: it was not finished.
        if cancel.is_some_and(Cancel::is_raised) {
            self.known = before;
            return Err(CheckError::Defect(CANCELLED.to_owned()));
        }
        found
    }

    fn check_from(
        &mut self,
        derivation: &Derivation,
        known: Option<Known>,
        cancel: Option<&Cancel>,
    ) -> Result<(Account, Vec<String>), CheckError> {
        let options = Options { limits: Limits { cancel: cancel.cloned(), ..Limits::default() }, ..Options::default() };
        let Some(contents) = contents(derivation) else {
            let account = check(derivation, &options, &|_, _| {})?;
            let all = ids(derivation);
            return Ok((account, all));
        };
        if known.as_ref().is_none_or(|known| known.contents.base != contents.base) {
            self.memory = Memory::default();
        }
        self.memory.grow_older(cancel);
        let fresh = self.memory.is_new();
        let names = Names::of(&contents);
        let recall = Recalled::new(&self.memory, &names);
        let mut checked = ids(derivation);
        let mut account = match known {
            Some(known) if known.contents.base == contents.base && known.contents.motions == contents.motions => {
                let mut changed = changed(&known.contents.claims, &contents.claims);
                changed.extend(corrected_otherwise(&known, &contents));
                checked = affected(derivation, changed.clone());
                let mut account = known.account;
                if !checked.is_empty() {
                    let (others, before): (Vec<_>, Vec<_>) =
                        account.claims.into_iter().partition(|c| !checked.contains(&c.id));
                    account.claims = others;
                    checked_again((derivation, &options), &mut account, (&checked, &changed), &before, recall)?;
                    drawn::add(derivation, &mut account, &options, recall)?;
                }
                account
            }
            _ => check_recalling(derivation, &options, recall, None, &|_, _| {})?,
        };
        if self.memory.is_misled() && !fresh {
            self.memory = Memory::default();
            checked = ids(derivation);
            self.memory.grow_older(cancel);
            account = check_recalling(derivation, &options, Recalled::new(&self.memory, &names), None, &|_, _| {})?;
        }
        describe(derivation, &mut account);
        self.known = Some(Known { contents, account: account.clone() });
        Ok((account, checked))
    }
}

/// Adds to the accounts of the other claims those of the `checked`, of which some are `changed` and the rest follow from these;
/// `before` are their accounts in an earlier state of the file.
///
/// # Errors
/// Those of [`check()`].
fn checked_again(
    (derivation, options): (&Derivation, &Options),
    account: &mut Account,
    (checked, changed): (&[String], &BTreeSet<String>),
    before: &[ClaimAccount],
    recall: Recalled,
) -> Result<(), CheckError> {
    let check_some = |derivation: &Derivation, account: &mut Account, some: Vec<String>| {
        if !some.is_empty() {
            let found =
                check_beside(derivation, &Options { claims: some, ..options.clone() }, &account.claims, recall)?;
            account.claims.extend(found);
        }
        Ok(())
    };
    let (first, rest): (Vec<String>, Vec<String>) = checked.iter().cloned().partition(|id| changed.contains(id));
    // What follows comes second, so nothing that is changed may follow from it.
    let from = |name: &String| rest.iter().any(|id| name.split('/').next() == Some(id.as_str()));
    let circular = derivation.claims.iter().any(|c| changed.contains(&c.id) && c.follows_from.iter().any(from));
    if circular || rest.is_empty() {
        return check_some(derivation, account, checked.to_vec());
    }
    check_some(derivation, account, first)?;
    let following: Vec<usize> =
        (0..derivation.claims.len()).filter(|&c| rest.contains(&derivation.claims[c].id)).collect();
    let others = account.claims.len();
    let Followed { mut claims, rest } =
        follow(derivation, &following, &account.claims, before, (&options.limits, recall));
    // What the rest follows from has its strength before.
    strengthen_all(derivation, &mut claims, &account.claims, (&options.limits, recall));
    account.claims.extend(claims);
    check_some(derivation, account, rest)?;
    let mut late = account.claims.split_off(others);
    strengthen_all(derivation, &mut late, &account.claims, (&options.limits, recall));
    account.claims.extend(late);
    Ok(())
}

/// The ids of the claims that are new or other than before, and of those that are gone: a name that others follow from may mean
/// something else without them.
fn changed(then: &[(String, String)], now: &[(String, String)]) -> BTreeSet<String> {
    let missing = |of: &[(String, String)], among: &[(String, String)]| -> Vec<String> {
        let among: BTreeSet<&(String, String)> = among.iter().collect();
        of.iter().filter(|claim| !among.contains(claim)).map(|(id, _)| id.clone()).collect()
    };
    missing(now, then).into_iter().chain(missing(then, now)).collect()
}

/// The claims that do not hold everywhere, and of which the file expects something else than before: where a correction must hold is said
/// by that.
fn corrected_otherwise(known: &Known, now: &Contents) -> Vec<String> {
    let holds = |c: &ClaimAccount| c.results.iter().all(|p| matches!(p.verdict.outcome(), Outcome::Holds(_)));
    let failing: BTreeSet<&str> = known.account.claims.iter().filter(|c| !holds(c)).map(|c| c.id.as_str()).collect();
    let then: BTreeSet<&(String, String)> = known.contents.expected.iter().collect();
    let other = now.expected.iter().filter(|of| !then.contains(of) && failing.contains(of.0.as_str()));
    other.map(|(id, _)| id.clone()).collect()
}

/// The words of a claim and of its readings: they are shown, and no verdict depends on them.
const WORDS: [&str; 7] = ["says", "place", "label", "printed", "remark", "expect", "expect-units"];

/// The content of everything but claims, that of each motion, and that of each claim, all without words.
pub(super) fn contents(derivation: &Derivation) -> Option<Contents> {
    let toml::Value::Table(mut root) =
        as_written(&DeValue::Table(DeTable::parse(&derivation.file.text).ok()?.into_inner()))
    else {
        return None;
    };
    let mut list = |key: &str| match root.remove(key) {
        Some(toml::Value::Array(list)) => list,
        _ => Vec::new(),
    };
    let (claims, motions) = (list("claim"), list("trajectory"));
    root.remove("derivation");
    // Of the conventions, the texts are only shown; these say what a formula means.
    let meant = |name: &str| root.get("conventions")?.get(name)?.as_str().map(str::to_owned);
    let conventions = format!("{:?}\n", ["log", "i", "units", "signature"].map(meant));
    root.remove("conventions");
    let id = |table: &toml::Value| Some(table.get("id")?.as_str()?.to_owned());
    let (mut symbols, mut expected) = (String::new(), Vec::new());
    let mut one = |mut claim: toml::Value| {
        let name = id(&claim)?;
        let readings = claim.get("reading").and_then(toml::Value::as_array).into_iter().flatten();
        let says: Vec<_> = std::iter::once(&claim).chain(readings).map(|of| of.get("expect")).collect();
        expected.push((name.clone(), format!("{says:?}")));
        taken_apart(claim.as_table_mut()?, &name, &mut symbols);
        for reading in claim.get_mut("reading").and_then(toml::Value::as_array_mut).into_iter().flatten() {
            let name = format!("{name}/{}", id(reading)?);
            taken_apart(reading.as_table_mut()?, &name, &mut symbols);
        }
        Some((name, claim.to_string()))
    };
    let claims = claims.into_iter().map(&mut one).collect::<Option<_>>()?;
    let motions = motions.iter().map(|m| Some((id(m)?, m.to_string()))).collect::<Option<_>>()?;
    // Values that are solved for are symbols, too: with others, those that are declared after them have other numbers.
    let all = derivation.trajectories.iter().map(|t| &t.motion).chain(derivation.families.iter().map(Family::motion));
    let unknowns = all.filter_map(Motion::start).flat_map(|start| &start.unknowns);
    let unknowns: Vec<usize> = unknowns.map(|u| u.leaf.symbol.index()).collect();
    Some(Contents { base: format!("{conventions}{root}{symbols}{unknowns:?}"), motions, claims, expected })
}

/// A value of the file with its numbers as they are written, in place of their nearest numbers in binary: a number has exactly the
/// value of its digits.
fn as_written(value: &DeValue) -> toml::Value {
    match value {
        // The mark keeps them from being texts.
        DeValue::Integer(i) => toml::Value::String(format!("\u{1}{}:{}", i.radix(), i.as_str())),
        DeValue::Float(f) => toml::Value::String(format!("\u{1}{}", f.as_str())),
        DeValue::String(text) => toml::Value::String(text.to_string()),
        DeValue::Boolean(b) => toml::Value::Boolean(*b),
        DeValue::Datetime(date) => toml::Value::Datetime(*date),
        DeValue::Array(list) => toml::Value::Array(list.iter().map(|v| as_written(v.get_ref())).collect()),
        DeValue::Table(table) => {
            toml::Value::Table(table.iter().map(|(k, v)| (k.get_ref().to_string(), as_written(v.get_ref()))).collect())
        }
    }
}

/// Takes the words and the symbols out of a claim, or a reading. The symbols are kept with its name, since motions know the
/// observables of all claims, and a name may mean something else in each of them.
fn taken_apart(claim: &mut toml::Table, name: &str, symbols: &mut String) {
    for key in WORDS {
        claim.remove(key);
    }
    if let Some(own) = claim.remove("symbols") {
        symbols.push_str(&format!("{name}: {own}\n"));
    }
}

fn ids(derivation: &Derivation) -> Vec<String> {
    let mut out: Vec<String> = derivation.claims.iter().map(|c| c.id.clone()).collect();
    out.dedup();
    out
}

/// The changed claims, and all that follow from them, in the order of the file.
fn affected(derivation: &Derivation, changed: BTreeSet<String>) -> Vec<String> {
    let mut following: FastMap<&str, Vec<&str>> = FastMap::default();
    for claim in &derivation.claims {
        for name in &claim.follows_from {
            following.entry(name.split('/').next().unwrap_or(name)).or_default().push(&claim.id);
        }
    }
    let mut todo: Vec<&str> = changed.iter().map(String::as_str).collect();
    let mut out: BTreeSet<&str> = todo.iter().copied().collect();
    while let Some(id) = todo.pop() {
        todo.extend(following.get(id).into_iter().flatten().copied().filter(|next| out.insert(next)));
    }
    ids(derivation).into_iter().filter(|id| out.contains(id.as_str())).collect()
}

/// Brings an account into the order of the file, with its words, expectations and units.
pub(super) fn describe(derivation: &Derivation, account: &mut Account) {
    let known = std::mem::take(&mut account.claims).into_iter().map(|of| ((of.id.clone(), of.reading.clone()), of));
    let mut known: FastMap<(String, Option<String>), ClaimAccount> = known.collect();
    let premises = Premises::of(derivation);
    for (position, claim) in derivation.claims.iter().enumerate() {
        let Some(mut found) = known.remove(&(claim.id.clone(), claim.reading.clone())) else { continue };
        found.says.clone_from(&claim.says);
        found.place.clone_from(&claim.place);
        found.remark.clone_from(&claim.remark);
        let tried = claim.trajectories.iter().map(|&t| derivation.trajectories[t].id.as_str());
        let expected: FastMap<&str, Option<&'static str>> = tried.zip(claim.expect.iter().copied()).collect();
        for pair in &mut found.results {
            pair.expected = expected.get(pair.trajectory.as_str()).copied().flatten();
        }
        for of in &mut found.families {
            let tried = claim.families.iter().zip(&claim.expect_of_families);
            let expected = tried.filter(|(f, _)| derivation.families[**f].id == of.family);
            of.expected = expected.map(|(_, e)| *e).next().flatten();
        }
        found.alone = AloneAccount::within(derivation, &premises, position);
        if let (Some(found), Some(declared)) = (&mut found.region, &claim.region) {
            found.expected = declared.expect;
        }
        account.claims.push(found);
    }
    account.units = units::units(derivation);
}
