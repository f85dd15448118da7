//! Motions that nobody wrote down, for claims that hold on all that the file has.
//!
//! **In:** a derivation and its account, complete. **Out:** in the account of each claim that holds on every motion it is tried on, and is not
//! proved: how it fares on others, and the first of these on which it fails. **Guaranteed:** no verdict is changed by it: it is about
//! motions of the file, and those are others. What is found fails when its text is put into the file. A file has the same draws every time;
//! the seed is part of the account.
//!
//! **How:** claims are tried together on the same drafts ([`draft`](super::draft)) of these, at samples. Only
//! integrated motions are drawn from: they obey their equations with any numbers, while a formula may solve them for its own alone.
//! The work of it is counted for itself, and is a small share of what a file may take. What that does not suffice for is not tried; nor is
//! anything where work cannot end ([`meter::CAN_END`]).

use std::collections::BTreeMap;

use super::draft::{Draft, draw};
use super::memory::{Known, Question, compares_motions};
use super::on_drafts::{Asked, verdicts};
use super::search::fresh_id;
use crate::derivation::{Claim, Derivation};
use crate::verdict::{Outcome, Strength, Verdict};
use claim::error::CheckError;
use claim::limits::Limits;
use claim::options::Options;
use findings::search::{DrawnAccount, FailingMotion, Tries};
use findings::{Account, ClaimAccount};

/// Motions that a claim is tried on, beside those that it does not apply to.
const ENOUGH: usize = 24;
/// Most motions that are drawn for that.
const MOST: usize = 96;
/// Of more claims than that none is tried: their file is read with every few motions.
const MOST_CLAIMS: usize = 60;
/// The longest stretch of time that they are tried on.
const LONGEST: f64 = 20.0;
/// So many of them are tried together: one that takes much work leaves none for those beside it, but for the others.
const TOGETHER: usize = 4;
/// The seed of the draws.
const SEED: u64 = 1;
/// All of them may take one of so many parts of the work of a file, beside the file: that may be used up.
const PARTS: u64 = 80;
/// Those that are tried together may take one of so many.
const PARTS_TOGETHER: u64 = 600;
/// The number of a draft, and a verdict on it; nothing where it is no motion.
type Tried = (usize, Option<Verdict>);

/// Adds to the accounts of claims what is found on motions that are drawn. What was found before is known.
///
/// # Errors
/// The program contradicts itself.
pub(super) fn add(
    derivation: &Derivation,
    account: &mut Account,
    options: &Options,
    recall: Known,
) -> Result<(), CheckError> {
    account.claims.iter_mut().for_each(|found| found.drawn = None);
    let places: BTreeMap<_, usize> =
        account.claims.iter().enumerate().map(|(at, c)| ((c.id.as_str(), c.reading.as_deref()), at)).collect();
    // In the order of the file: the claims, and the positions of their accounts.
    let of = |claim: &'_ Claim| places.get(&(claim.id.as_str(), claim.reading.as_deref())).copied();
    let asked = derivation.claims.iter().filter_map(|claim| Some((claim, of(claim)?)));
    let (claims, at): (Vec<&Claim>, Vec<usize>) =
        asked.filter(|(claim, at)| is_asked(claim, &account.claims[*at])).unzip();
    let families = derivation.trajectories.iter().filter_map(|t| Draft::of(derivation, t));
    let families = families.filter(|family| family.system.is_some() && family.is_free());
    let families: Vec<Draft> = families.map(|family| family.up_to(LONGEST)).collect();
    let is_possible = meter::CAN_END && options.limits.reached().is_none();
    if claims.is_empty() || claims.len() > MOST_CLAIMS || families.is_empty() || !is_possible {
        return Ok(());
    }
    // How far the work goes depends on all of the claims.
    let found = match recall.known(derivation, Question::Drawn(&claims)) {
        Some(known) => known,
        None => {
            let found = on_drafts(derivation, &families, &claims, &options.limits)?;
            recall.keep(derivation, Question::Drawn(&claims), &found);
            found
        }
    };
    for (at, drawn) in at.into_iter().zip(found) {
        account.claims[at].drawn = Some(drawn);
    }
    Ok(())
}

/// Whether a claim is tried on other motions: it holds on all that it applies to, and nothing says that it must on others. What names its
/// motions is said of these.
fn is_asked(claim: &Claim, found: &ClaimAccount) -> bool {
    let holds = |v: &Verdict| matches!(v.outcome(), Outcome::Holds(_) | Outcome::NotApplicable(_));
    let is_open = |v: &Verdict| matches!(v.outcome(), Outcome::Holds(strength) if strength < Strength::Proved);
    let is_proved = found.identity.as_ref().is_some_and(|i| i.finding.is_proved_in_part());
    !claim.names_trajectories
        && !is_proved
        && !compares_motions(claim)
        && found.verdicts().all(|j| holds(j.verdict))
        && found.results.iter().any(|pair| is_open(&pair.verdict))
}

/// What is found of claims on drafts of some families.
fn on_drafts(
    derivation: &Derivation,
    families: &[Draft],
    claims: &[&Claim],
    limits: &Limits,
) -> Result<Vec<DrawnAccount>, CheckError> {
    let id = fresh_id(derivation, "all", None, SEED);
    let draft = |number: usize| Some((format!("{id}-{number}"), draw(families, SEED, number)?));
    let drafts: Vec<(String, Draft)> = (0..MOST).filter_map(draft).collect();
    let all = limits.of_part(PARTS);
    let mut found: Vec<Vec<Tried>> = vec![Vec::new(); claims.len()];
    for (k, some) in drafts.chunks(TOGETHER).enumerate() {
        if all.total.left() == 0 || found.iter().all(|tried| is_enough(tried)) {
            break;
        }
        let limits = limits.of_part(PARTS_TOGETHER);
        let asked = |claim: &&Claim| Asked { name: claim.name(), on: (0..some.len()).collect() };
        let asked: Vec<Asked> = claims.iter().map(asked).collect();
        let of_some = verdicts(derivation, some, &asked, (|run| run.sampled(), &limits))?;
        all.total.spend(limits.total.used());
        // What the work did not suffice for was not tried.
        let is_over = limits.total.left() == 0;
        let is_open = |v: &Option<Verdict>| v.as_ref().is_none_or(|v| matches!(v.outcome(), Outcome::Undecided));
        // Of a claim that was tried enough no more is said, whatever is tried beside it.
        for (tried, some) in found.iter_mut().zip(of_some).filter(|(tried, _)| !is_enough(tried)) {
            let some = some.into_iter().enumerate().map(|(i, verdict)| (k * TOGETHER + i, verdict));
            tried.extend(some.filter(|(_, verdict)| !(is_over && is_open(verdict))));
        }
    }
    let one = |(claim, found): (&&Claim, Vec<_>)| one(derivation, claim, (families, &drafts, &found), limits);
    claims.iter().zip(found).map(one).collect()
}

/// Whether no more is to be tried of a claim: it applies to enough motions, or fails on one.
fn is_enough(tried: &[Tried]) -> bool {
    let outcomes = || tried.iter().filter_map(|(_, verdict)| verdict.as_ref().map(Verdict::outcome));
    outcomes().filter(|outcome| !matches!(outcome, Outcome::NotApplicable(_))).count() >= ENOUGH
        || outcomes().any(|outcome| matches!(outcome, Outcome::Fails(_)))
}

/// What is found of a claim, from its verdicts on drafts.
fn one(
    derivation: &Derivation,
    claim: &Claim,
    (families, drafts, found): (&[Draft], &[(String, Draft)], &[Tried]),
    limits: &Limits,
) -> Result<DrawnAccount, CheckError> {
    let mut out = DrawnAccount { seed: SEED, tries: Tries::default(), found: None };
    for (number, verdict) in found {
        let Some((_, draft)) = drafts.get(*number) else { continue };
        match verdict.as_ref().map(Verdict::outcome) {
            None => out.tries.impossible += 1,
            Some(Outcome::Holds(_)) => out.tries.holds += 1,
            Some(Outcome::NotApplicable(_)) => out.tries.not_applicable += 1,
            Some(Outcome::Undecided) => out.tries.undecided += 1,
            Some(Outcome::Fails(_)) if out.found.is_some() => out.tries.fails += 1,
            Some(Outcome::Fails(_)) => match alone(derivation, claim, (*number, draft, families), limits)? {
                Some(motion) => {
                    out.tries.fails += 1;
                    out.found = Some(Box::new(motion));
                }
                None => out.tries.undecided += 1,
            },
        }
    }
    Ok(out)
}

/// The motion of a draft, with the verdict of the claim alone: what else a motion is asked for moves the last places of error bounds.
fn alone(
    derivation: &Derivation,
    claim: &Claim,
    (number, draft, families): (usize, &Draft, &[Draft]),
    limits: &Limits,
) -> Result<Option<FailingMotion>, CheckError> {
    let (name, id) = (claim.name(), fresh_id(derivation, &claim.name(), None, SEED));
    let asked = [Asked { name: name.clone(), on: vec![0] }];
    let limits = limits.of_part(PARTS);
    let mut found = verdicts(derivation, &[(id.clone(), draft.clone())], &asked, (|run| run.sampled(), &limits))?;
    let verdict = found.pop().and_then(|mut of| of.pop().flatten());
    let family = families.iter().find(|f| f.from == draft.from).unwrap_or(draft);
    Ok(verdict.filter(|v| matches!(v.outcome(), Outcome::Fails(_))).map(|verdict| FailingMotion {
        number,
        claim: name,
        from: draft.from.clone(),
        table: draft.table(&id),
        id,
        changed: draft.changed(family),
        verdict,
        listed: false,
    }))
}
