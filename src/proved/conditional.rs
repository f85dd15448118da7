//! What is open behind a proof.
//!
//! **In:** the steps of a derivation, each decided by itself. **Out:** for each claim the claims that it follows from, through all steps,
//! which are not proved themselves, and what they assume that is not assumed on the way: what is proved is proved given these.

use std::collections::HashMap;

use crate::derivation::{Claim, Derivation, Written};
use crate::expr::FastSet;
use crate::findings::standing::{Decision, Given, MOST_TOLD};
use crate::findings::{AloneAccount, ClaimAccount};
use crate::latex::Statement;
use crate::step::chooses;

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
    // For each claim what is open among all that it follows from, the nearest first.
    let mut open: Vec<Vec<usize>> = vec![Vec::new(); derivation.claims.len()];
    let gathered = |open: &[Vec<usize>], of: &[usize], own: usize| -> Vec<usize> {
        // In a circle nothing is proved.
        let is_open = |at: usize| at == own || decisions[at] != Some(Decision::Proved);
        let direct = of.iter().copied().filter(|&at| is_open(at));
        told(direct.chain(of.iter().flat_map(|&at| open[at].iter().copied())))
    };
    let follows = follows(derivation);
    for own in premises_first(follows.len(), |k| follows[k].clone()) {
        open[own] = gathered(&open, &follows[own], own);
    }
    let mut at_times: Vec<&[String]> = vec![&[]; derivation.claims.len()];
    for account in known.iter().chain(claims.iter()) {
        if let (Some(at), Some(identity)) = (at(account), &account.identity) {
            at_times[at] = &identity.assumed_at_times;
        }
    }
    let assumptions = Assumptions::of(derivation, &follows, &at_times, None);
    for account in claims {
        let own = at(account);
        let (Some(own), Some(identity)) = (own, account.identity.as_mut()) else { continue };
        let mut out: Vec<Given> = Vec::new();
        if identity.finding.is_proved_in_part() || !identity.parts.is_empty() {
            let inherited = assumptions.presupposed[own].iter().map(|&n| assumptions.text(n));
            let inherited: Vec<String> = inherited.filter(|text| !identity.presupposed.contains(text)).collect();
            identity.presupposed.extend(inherited);
        }
        if identity.finding.is_proved_in_part() {
            for at in gathered(&open, &derivation.claims_among(&identity.from).collect::<Vec<_>>(), own) {
                let standing = match at == own {
                    true => Some("itself what is to be proved"),
                    false => decisions.get(at).and_then(|d| d.map(Decision::word)),
                };
                let claim = derivation.claims.get(at);
                let postulated = claim.and_then(AloneAccount::of).is_some_and(|alone| alone.postulated);
                let name = claim.map_or_else(|| format!("more than {MOST_TOLD} claims"), Claim::name);
                out.push(Given { name, standing, postulated });
            }
            // What stands for the rest is the last.
            let told = out.len().min(MOST_TOLD);
            out[..told].sort_by(|a, b| a.name.cmp(&b.name));
        }
        identity.conditional_on = out;
    }
}

/// For each claim those that it follows from.
fn follows(derivation: &Derivation) -> Vec<Vec<usize>> {
    derivation.claims.iter().map(|c| derivation.claims_among(&c.follows_from).collect()).collect()
}

/// So many claims, each after its premises, but in circles.
pub fn premises_first(count: usize, premises: impl Fn(usize) -> Vec<usize>) -> Vec<usize> {
    let mut out = Vec::with_capacity(count);
    let mut seen = vec![false; count];
    for first in 0..count {
        // What is open, with its premises that are still to be seen.
        let mut open: Vec<(usize, Vec<usize>)> = Vec::new();
        if !std::mem::replace(&mut seen[first], true) {
            open.push((first, premises(first)));
        }
        while let Some((k, left)) = open.last_mut() {
            match left.pop() {
                Some(next) if !std::mem::replace(&mut seen[next], true) => open.push((next, premises(next))),
                Some(_) => {}
                None => {
                    out.push(*k);
                    open.pop();
                }
            }
        }
    }
    out
}

/// Stands for what is open or presupposed beyond [`MOST_TOLD`]: no claim, and no assumption, has this number.
const MORE: usize = usize::MAX;

/// Numbers, each once, as they come: so many that what is told of each claim of a long derivation is bounded.
fn told(all: impl Iterator<Item = usize>) -> Vec<usize> {
    let (mut out, mut seen, mut more) = (Vec::new(), FastSet::<usize>::default(), false);
    for one in all {
        if one == MORE || out.len() == MOST_TOLD && !seen.contains(&one) {
            more = true;
        } else if seen.insert(one) {
            out.push(one);
        }
        if more && out.len() == MOST_TOLD {
            break;
        }
    }
    out.extend(more.then_some(MORE));
    out
}

/// The assumptions of all claims, each numbered once, and what the claims presuppose.
struct Assumptions<'d> {
    texts: Vec<&'d str>,
    /// Those of each claim.
    own: Vec<Vec<usize>>,
    /// Of these the ones by which times are chosen.
    choosing: Vec<Vec<usize>>,
    /// Of these the equations that are known at these times only.
    at_times: Vec<Vec<usize>>,
    /// For each claim those of what it follows from, through all steps, that are not made on the way.
    presupposed: Vec<Vec<usize>>,
}

impl<'d> Assumptions<'d> {
    /// Those of a derivation, in which claims follow from claims, and of a claim that is not in it.
    /// `at_times`: of each claim what it assumes at some times only; what is typed is assumed of all.
    fn of(
        derivation: &'d Derivation,
        follows: &[Vec<usize>],
        at_times: &[&[String]],
        typed: Option<&'d Claim>,
    ) -> Assumptions<'d> {
        let mut numbers = Numbers::default();
        let graph = &derivation.graph;
        let (mut own, mut choosing): (Vec<Vec<usize>>, Vec<Vec<usize>>) = Default::default();
        for claim in derivation.claims.iter().chain(typed) {
            own.push(claim.assuming.iter().map(|w| numbers.of(w)).collect());
            let chooses = |w: &&Written<Statement>| w.value.relations.iter().any(|r| chooses(graph, &claim.scope, r));
            choosing.push(claim.assuming.iter().filter(chooses).map(|w| numbers.of(w)).collect());
        }
        let presupposed = vec![Vec::new(); derivation.claims.len()];
        let texts: Vec<&str> = numbers.all.iter().map(|w| w.text.as_str()).collect();
        let numbered = |of: &[String]| (0..texts.len()).filter(|&n| of.iter().any(|text| text == texts[n])).collect();
        let at_times = at_times.iter().map(|of| numbered(of)).chain(typed.map(|_| Vec::new())).collect();
        let mut out = Assumptions { texts, own, choosing, at_times, presupposed };
        for at in premises_first(follows.len(), |k| follows[k].clone()) {
            out.presupposed[at] = out.inherited(&follows[at], at);
        }
        out
    }

    /// What the premises of a claim assume, and what they presuppose, but for what the claim assumes itself. What is assumed at the times
    /// that it chooses is no such assumption of a premise that is about more.
    fn inherited(&self, premises: &[usize], of: usize) -> Vec<usize> {
        let (own, at_times) = (&self.own[of], &self.at_times[of]);
        let all = premises.iter().flat_map(|&at| {
            let as_often = self.choosing[of].iter().all(|c| self.own[at].contains(c));
            let direct = self.own[at].iter().map(move |&one| (one, as_often));
            direct.chain(self.presupposed[at].iter().map(|&one| (one, false)))
        });
        let assumed = |one: usize, as_often: bool| own.contains(&one) && (as_often || !at_times.contains(&one));
        told(all.filter(|&(one, as_often)| !assumed(one, as_often)).map(|(one, _)| one))
    }

    fn text(&self, number: usize) -> String {
        self.texts.get(number).map_or_else(|| format!("more than {MOST_TOLD} assumptions"), |text| (*text).to_owned())
    }
}

/// Assumptions that are told apart by what they say: a name may mean something else in each claim.
#[derive(Default)]
struct Numbers<'d> {
    all: Vec<&'d Written<Statement>>,
    by_text: HashMap<&'d str, Vec<usize>>,
}

impl<'d> Numbers<'d> {
    fn of(&mut self, one: &'d Written<Statement>) -> usize {
        let alike = self.by_text.entry(&one.text).or_default();
        if let Some(&known) = alike.iter().find(|&&n| self.all[n].value.says_the_same(&one.value)) {
            return known;
        }
        alike.push(self.all.len());
        self.all.push(one);
        self.all.len() - 1
    }
}

/// What a claim presupposes that is not one of the file: assumptions of what it follows from.
pub(crate) fn presupposed(derivation: &Derivation, claim: &Claim) -> Vec<String> {
    let follows = follows(derivation);
    let all = Assumptions::of(derivation, &follows, &vec![&[][..]; derivation.claims.len()], Some(claim));
    let named: Vec<usize> = derivation.claims_among(&claim.follows_from).collect();
    all.inherited(&named, all.own.len() - 1).into_iter().map(|n| all.text(n)).collect()
}
