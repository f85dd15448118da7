//! What is open behind a proof.
//!
//! **In:** the steps of a derivation, each decided by itself. **Out:** for each claim the claims that it follows from, through all steps,
//! which are not proved themselves, and what they assume that is not assumed on the way: what is proved is proved given these.

use std::collections::{BTreeSet, HashMap};

use crate::derivation::{Claim, Derivation, Premise, Written};
use crate::findings::ClaimAccount;
use crate::findings::standing::{Decision, Given};
use crate::latex::Statement;

/// For each claim what its proof is conditional on: the claims that it follows from, through all steps, whose own steps are not
/// proved. Of a claim with several readings a name without one means the first.
pub fn conditional(derivation: &Derivation, claims: &mut [ClaimAccount], known: &[ClaimAccount]) {
    let names: HashMap<(&str, Option<&str>), usize> =
        derivation.claims.iter().enumerate().map(|(at, c)| ((c.id.as_str(), c.reading.as_deref()), at)).collect();
    let at = |a: &ClaimAccount| names.get(&(a.id.as_str(), a.reading.as_deref())).copied();
    let mut decisions: Vec<Option<&'static str>> = vec![None; derivation.claims.len()];
    for account in known.iter().chain(claims.iter()) {
        if let (Some(at), Some(identity)) = (at(account), &account.identity) {
            decisions[at] = Some(identity.finding.decision().word());
        }
    }
    // For each claim what is open among all that it follows from.
    let mut open: Vec<BTreeSet<usize>> = vec![BTreeSet::new(); derivation.claims.len()];
    let gathered = |open: &[BTreeSet<usize>], of: &[usize], own: usize| -> BTreeSet<usize> {
        let mut out = BTreeSet::new();
        for &at in of {
            // In a circle nothing is proved.
            if at == own || decisions[at] != Some(Decision::Proved.word()) {
                out.insert(at);
            }
            out.extend(&open[at]);
        }
        out
    };
    for own in premises_first(derivation) {
        open[own] = gathered(&open, &premises(derivation, &derivation.claims[own].follows_from), own);
    }
    let assumed = assumed(derivation);
    for account in claims {
        let own = at(account);
        let (Some(own), Some(identity)) = (own, account.identity.as_mut()) else { continue };
        let mut out: Vec<Given> = Vec::new();
        if identity.finding.is_proved_in_part() {
            let inherited = assumed[own].iter().map(|w| &w.text).filter(|text| !identity.presupposed.contains(text));
            let inherited: Vec<String> = inherited.cloned().collect();
            identity.presupposed.extend(inherited);
            for at in gathered(&open, &premises(derivation, &identity.from), own) {
                let standing = match at == own {
                    true => Some("itself what is to be proved"),
                    false => decisions[at],
                };
                out.push(Given { name: derivation.claims[at].name(), standing });
            }
            out.sort_by(|a, b| a.name.cmp(&b.name));
        }
        identity.conditional_on = out;
    }
}

/// The claims among what is named.
fn premises(derivation: &Derivation, names: &[String]) -> Vec<usize> {
    let of = |name: &String| match derivation.premise(name) {
        Premise::Claim(at) => Some(at),
        Premise::System(_) | Premise::Definition => None,
    };
    names.iter().filter_map(of).collect()
}

/// All claims, each after what it follows from, but in circles.
fn premises_first(derivation: &Derivation) -> Vec<usize> {
    let mut entered = vec![false; derivation.claims.len()];
    let mut left = entered.clone();
    let mut out = Vec::with_capacity(entered.len());
    for first in 0..derivation.claims.len() {
        let mut stack = vec![first];
        while let Some(&own) = stack.last() {
            if !left[own] && !std::mem::replace(&mut entered[own], true) {
                let of = premises(derivation, &derivation.claims[own].follows_from);
                stack.extend(of.into_iter().filter(|&at| !entered[at]));
                continue;
            }
            stack.pop();
            if !std::mem::replace(&mut left[own], true) {
                out.push(own);
            }
        }
    }
    out
}

/// For each claim what it presupposes: the assumptions of what it follows from, through all steps, that are not made on the way.
fn assumed(derivation: &Derivation) -> Vec<Vec<&Written<Statement>>> {
    let mut out = vec![Vec::new(); derivation.claims.len()];
    for own in premises_first(derivation) {
        out[own] = inherited(derivation, &derivation.claims[own], &out);
    }
    out
}

/// What the premises of a claim assume, and what they presuppose, but for what the claim assumes itself.
fn inherited<'d>(
    derivation: &'d Derivation,
    claim: &Claim,
    presupposed: &[Vec<&'d Written<Statement>>],
) -> Vec<&'d Written<Statement>> {
    let mut out: Vec<&Written<Statement>> = Vec::new();
    for at in premises(derivation, &claim.follows_from) {
        for one in derivation.claims[at].assuming.iter().chain(presupposed[at].iter().copied()) {
            // A name may mean something else in each claim.
            let known = |w: &Written<Statement>| w.value.says_the_same(&one.value);
            if !claim.assuming.iter().any(known) && !out.iter().any(|w| known(w)) {
                out.push(one);
            }
        }
    }
    out
}

/// What a claim presupposes that is not one of the file: assumptions of what it follows from, and the ranges of that.
pub(crate) fn presupposed(derivation: &Derivation, claim: &Claim) -> Vec<String> {
    let assumed = inherited(derivation, claim, &assumed(derivation));
    let mut out: Vec<String> = assumed.into_iter().map(|w| w.text.clone()).collect();
    let (mut open, mut seen) = (premises(derivation, &claim.follows_from), BTreeSet::new());
    while let Some(at) = open.pop() {
        let of = &derivation.claims[at];
        if seen.insert(at) {
            out.extend(of.region.as_ref().map(|_| format!("the ranges of {}", of.name())));
            open.extend(premises(derivation, &of.follows_from));
        }
    }
    out
}
