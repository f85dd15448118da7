//! Places behind names: by what a prime derives, and where a definition is one.
//!
//! **In:** a name of a step, what is defined, and the [`Evidence`] of the paper. **Out:** a variable, where there is one. **Guaranteed:** what is
//! printed behind the name, there or where it is defined, is the variable; what the paper prints behind it elsewhere counts only without that.

use std::collections::{BTreeMap, BTreeSet};

use paper::{Call, PaperName, is_variable, names};

use super::desk::Given;
use super::lone::{lone_name, unprimed};
use super::notation::Evidence;

/// Whether a name stands at another place than where it is defined: `U(0)=k` says nothing of `U(\theta)=k\cos\theta` again.
pub(super) fn is_elsewhere(given: &Given, name: &PaperName) -> bool {
    match (lone_name(&given.left).map(|n| n.call), &name.call) {
        (Some(Call::Places(one)), Call::Places(other)) => one != *other,
        _ => false,
    }
}

/// The variable that stands behind a name where it is defined: `x` of `f(x)=x^2`.
pub(super) fn place_of_definition(key: &str, given: &[&Given]) -> Option<String> {
    let definition = given.iter().rev().find(|g| g.key == key && !g.is_rate)?;
    names(&definition.left).iter().find(|n| n.key() == key).and_then(own_place)
}

/// The variable that alone stands behind a name.
fn own_place(name: &PaperName) -> Option<String> {
    match &name.call {
        Call::Places(places) => Some(places.first()?.clone()).filter(|p| places.len() == 1 && is_variable(p)),
        Call::None | Call::Other => None,
    }
}

/// The variable by which a prime derives: that which stands behind the name, there or where it is defined; or that of which the paper prints
/// the name as a function, or by which it derives it; or else the one letter of the formula that defines it.
pub(super) fn primed_by(name: &PaperName, all: &[PaperName], given: &[&Given], evidence: &Evidence) -> Option<String> {
    if name.primes == 0 {
        return None;
    }
    let key = unprimed(name).key();
    if let Some(by) = own_place(name).or_else(|| place_of_definition(&key, given)) {
        return Some(by);
    }
    let mut seen: BTreeMap<&str, usize> = BTreeMap::new();
    for (places, n) in evidence.calls.get(&key).into_iter().flatten() {
        if let Some([one]) = places.as_deref() {
            *seen.entry(one).or_default() += n;
        }
    }
    let primed = evidence.primed_places.get(&key).into_iter().flatten().map(|(by, n)| (by.as_str(), *n));
    let derived = evidence.derived.get(&key).into_iter().flatten().map(|by| (by.as_str(), 1));
    for (by, n) in primed.chain(derived) {
        *seen.entry(by).or_default() += n;
    }
    // Of a derivative of what stands in brackets, `\frac{d}{dx}[\cosh x]`, the variable is inside.
    seen.retain(|v, _| *v != key && v.chars().count() == 1 && v.chars().all(char::is_alphabetic));
    let here: Vec<&str> = seen.keys().copied().filter(|v| all.iter().any(|n| n.key() == *v)).collect();
    match here.as_slice() {
        [one] => Some((*one).to_owned()),
        [] => match seen.into_iter().max_by_key(|(v, n)| (*n, std::cmp::Reverse(*v))) {
            Some((by, _)) => Some(by.to_owned()),
            None => only_letter(&key, given, evidence),
        },
        _ => None,
    }
}

/// The letter of a definition that has just one, where the paper prints it with no prime, which would be that of other axes, and neither it nor
/// the name that is defined with a dot.
fn only_letter(key: &str, given: &[&Given], evidence: &Evidence) -> Option<String> {
    let of = |key: &str| given.iter().find(|g| g.key == key && !g.is_rate);
    let letters: BTreeSet<String> = names(&of(key)?.right).iter().map(PaperName::key).collect();
    let [letter] = Vec::from_iter(letters).try_into().ok()?;
    let is_plain = letter != key
        && letter.chars().count() == 1
        && !evidence.primes.contains_key(&letter)
        && of(&letter).is_none()
        && ![key, &letter].iter().any(|k| evidence.dotted.contains(*k));
    is_plain.then_some(letter)
}
