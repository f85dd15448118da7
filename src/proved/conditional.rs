//! What is open behind a proof.
//!
//! **In:** the steps of a derivation, each decided by itself. **Out:** for each claim the claims that it follows from, through all steps,
//! which are not proved themselves: what is proved is proved given these.

use std::collections::{BTreeSet, HashMap};

use crate::derivation::{Derivation, Premise};
use crate::findings::ClaimAccount;
use crate::findings::standing::{Decision, Given};

/// For each claim what its proof is conditional on: the claims that it follows from, through all steps, whose own steps are not
/// proved. Of a claim with several readings a name without one means the first.
pub fn conditional(derivation: &Derivation, claims: &mut [ClaimAccount], known: &[ClaimAccount]) {
    let names: HashMap<(&str, Option<&str>), usize> =
        derivation.claims.iter().enumerate().map(|(at, c)| ((c.id.as_str(), c.reading.as_deref()), at)).collect();
    let at = |a: &ClaimAccount| names.get(&(a.id.as_str(), a.reading.as_deref())).copied();
    let mut decisions: Vec<Option<Decision>> = vec![None; derivation.claims.len()];
    for account in known.iter().chain(claims.iter()) {
        if let (Some(at), Some(identity)) = (at(account), &account.identity) {
            decisions[at] = Some(identity.finding.decision());
        }
    }
    let premises = |names: &[String]| -> Vec<usize> {
        let of = |name: &String| match derivation.premise(name) {
            Premise::Claim(at) => Some(at),
            Premise::System(_) | Premise::Definition => None,
        };
        names.iter().filter_map(of).collect()
    };
    // For each claim what is open among all that it follows from: each claim after its premises.
    let mut open: Vec<Option<BTreeSet<usize>>> = vec![None; derivation.claims.len()];
    let mut entered = vec![false; derivation.claims.len()];
    let gathered = |open: &[Option<BTreeSet<usize>>], of: &[usize], own: usize| -> BTreeSet<usize> {
        let mut out = BTreeSet::new();
        for &at in of {
            // In a circle nothing is proved.
            if at == own || decisions[at] != Some(Decision::Proved) {
                out.insert(at);
            }
            out.extend(open[at].iter().flatten());
        }
        out
    };
    for first in 0..derivation.claims.len() {
        let mut stack = vec![first];
        while let Some(&own) = stack.last() {
            if open[own].is_some() {
                stack.pop();
                continue;
            }
            let of = premises(&derivation.claims[own].follows_from);
            if !std::mem::replace(&mut entered[own], true) {
                stack.extend(of.iter().copied().filter(|&at| open[at].is_none() && !entered[at]));
                continue;
            }
            open[own] = Some(gathered(&open, &of, own));
            stack.pop();
        }
    }
    for account in claims {
        let own = at(account);
        let (Some(own), Some(identity)) = (own, account.identity.as_mut()) else { continue };
        let mut out: Vec<Given> = Vec::new();
        if identity.finding.is_proved_in_part() {
            for at in gathered(&open, &premises(&identity.from), own) {
                let standing = match at == own {
                    true => Some("itself what is to be proved"),
                    false => decisions[at].map(Decision::word),
                };
                out.push(Given { name: derivation.claims[at].name(), standing });
            }
            out.sort_by(|a, b| a.name.cmp(&b.name));
        }
        identity.conditional_on = out;
    }
}
