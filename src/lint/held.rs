//! What is held fixed in a derivative: names that a formula has beside the variable.
//!
//! **In:** the sides of a step, definitions, what the paper shows of its names. **Out:** the names that may depend on the variable, and those that
//! are constants. **Guaranteed:** where a name may depend on the variable in a second way, nothing is said; what is taken for granted is told.

use std::collections::BTreeSet;

use paper::{PaperName, PrintedSide, names};

use super::desk::{Given, derived_by, inside, names_variable};
use super::lone::unprimed;
use super::notation::Evidence;
use super::obstacle::is_place;

/// Some sides, and what definitions say.
pub(super) fn with_given<'s>(sides: &[&'s PrintedSide], given: &'s [Given]) -> Vec<&'s PrintedSide> {
    sides.iter().copied().chain(given.iter().map(|g| &g.right)).collect()
}

/// Takes the definitions away of what a partial derivative holds fixed: what depends on its variable, and stands in the formula that is
/// derived and shows the variable. `L=T-V` shows none: its terms are derived. Beside the total derivative nothing is held fixed, and nothing
/// is known.
pub(super) fn hold(sides: &[&PrintedSide], given: &mut Vec<Given>) {
    let all = with_given(sides, given);
    let Some(Held { by, fixed, .. }) = held_fixed(&all, given, true).filter(|held| held.is_shown) else { return };
    let is_total =
        all.iter().flat_map(|side| names(side)).any(|n| derived_by(&n, false).is_some_and(|v| by.contains(v)));
    given.retain(|g| !is_total && !fixed.contains(&g.key));
}

/// A derivative of a defined name, where something in it depends on the variable in a second way: what is held fixed is not said then.
pub(super) struct Held {
    /// The names that are derived.
    pub(super) of: BTreeSet<String>,
    /// The variables.
    pub(super) by: BTreeSet<String>,
    /// The names in their formulas that depend on these.
    pub(super) fixed: BTreeSet<String>,
    /// Whether a formula that is derived shows its variable.
    pub(super) is_shown: bool,
}

/// Where a derivative, partial or total, is taken of what is defined, and another definition depends on its variable, too. As a whole by the time
/// everything is derived.
pub(super) fn held_fixed(sides: &[&PrintedSide], given: &[Given], is_partial: bool) -> Option<Held> {
    let (mut of, mut by, mut within) = (BTreeSet::new(), BTreeSet::new(), Vec::new());
    let all: Vec<paper::PaperName> = sides.iter().flat_map(|side| names(side)).collect();
    // `\frac{\partial(xt)}{\partial t}`: what stands in the parentheses is the formula.
    let in_formula = |n: &paper::PaperName| is_partial && n.is_in_group;
    let is_in_its_own = |n: &paper::PaperName| in_formula(n) && n.derived_by.as_ref() == Some(&n.key());
    for name in &all {
        let key = unprimed(name).key();
        let place = |n: &paper::PaperName| match &n.call {
            paper::Call::Places(places) if places.len() == 1 => places.first().cloned(),
            _ => None,
        };
        let of_definition =
            || given.iter().filter(|g| g.key == key).find_map(|g| names(&g.left).first().and_then(place));
        let variable = match (&name.derived_by, is_partial) {
            (Some(by), partial) => (name.is_partial == partial).then(|| by.clone()),
            (None, false) if name.primes > 0 => place(name).or_else(of_definition),
            (None, _) => None,
        };
        if let Some(variable) = variable.filter(|v| is_partial || v != "t") {
            let is_own = |n: &paper::PaperName| is_in_its_own(n) && n.derived_by.as_ref() == Some(&variable);
            if in_formula(name) && all.iter().any(is_own) {
                within.push(key);
            } else {
                of.insert(key);
            }
            by.insert(variable);
        }
    }
    let list: Vec<&Given> = given.iter().collect();
    let names_it = |g: &Given| names(&g.right).iter().any(|n| by.contains(&n.key()));
    let is_shown = !within.is_empty() || given.iter().any(|g| of.contains(&g.key) && names_it(g));
    within.extend(of.iter().cloned());
    within.extend(inside(&within, &list));
    let is_within = |g: &Given| !of.contains(&g.key) && (within.contains(&g.key) || !is_partial);
    let depends = |g: &&&Given| !g.is_rate && is_within(g) && names_it(g);
    let fixed: BTreeSet<String> = list.iter().filter(depends).map(|g| g.key.clone()).collect();
    (!fixed.is_empty()).then_some(Held { of, by, fixed, is_shown })
}

/// Whether a partial derivative is taken of what is defined, and a question does not rest on the definition.
pub(super) fn leaves_derivative_free(sides: [&PrintedSide; 2], defined: &[Given], given: &[Given]) -> bool {
    let has = |all: &[Given], key: &str| all.iter().any(|g| g.key == key && !g.is_rate);
    sides.into_iter().flat_map(names).filter(|n| n.is_partial).any(|n| {
        let key = unprimed(&n).key();
        has(defined, &key) && !has(given, &key)
    })
}

/// Whether a derivative is taken of what is defined by a name that its definition does not have, nor what that names.
pub(super) fn lacks_variable(sides: [&PrintedSide; 2], given: &[Given]) -> bool {
    let given: Vec<&Given> = given.iter().collect();
    sides.into_iter().flat_map(names).any(|n| {
        let key = unprimed(&n).key();
        let by = n.derived_by.as_ref().filter(|by| *by != "t" && **by != key && !n.is_in_group);
        let is_defined = given.iter().any(|g| g.key == key && !g.is_rate);
        by.is_some_and(|by| is_defined && !names_variable(&key, by, &given))
    })
}

/// Whether `\frac{d}{dx}` stands before a factor without parentheses, and a sum goes on behind it: it may reach to its end.
pub(super) fn has_open_derivative(text: &str) -> bool {
    let squeezed: String = text.chars().filter(|c| !c.is_whitespace()).collect();
    squeezed.match_indices(r"\frac{d}{d").chain(squeezed.match_indices(r"\frac{\partial}{\partial")).any(
        |(at, found)| {
            let Some((_, rest)) = squeezed[at + found.len()..].split_once('}') else { return false };
            let grouped = rest.starts_with(['(', '[', '{']) || rest.starts_with(r"\left") || rest.starts_with(r"\big");
            !grouped && has_sum(rest)
        },
    ) || [r"\over\partial", r"\overd", r"\over\mathrm{d}"].iter().any(|w| squeezed.contains(w))
}

/// Whether a plus or a minus stands in a text outside of all braces.
fn has_sum(text: &str) -> bool {
    let mut depth = 0_i32;
    text.chars().any(|c| {
        depth += i32::from(c == '{') - i32::from(c == '}');
        depth == 0 && matches!(c, '+' | '-')
    })
}

/// Takes the derivative from what only stands inside of one, `\frac{d}{dt}\left(\frac12m\dot x^2\right)`: a name of which the paper prints no
/// rate is a constant there, where another one varies, or the variable stands beside it: `\frac{d}{dx}e^{ax}`. Names, and the variable,
/// of which that is taken for granted: where nothing but the variable varies.
pub(super) fn constants_apart(all: &mut [PaperName], evidence: &Evidence, by: &str) -> BTreeSet<(String, String)> {
    let derives = |n: &PaperName| n.derived_by.as_deref() == Some(by);
    let shows_itself = all.iter().any(|n| n.key() == by && derives(n));
    let has_prime = |key: &str| all.iter().any(|n| n.primes > 0 && unprimed(n).key() == key);
    let varies = |n: &PaperName| {
        let key = n.key();
        n.dots > 0
            || n.primes > 0
            || by != "t" && evidence.derived.get(&key).is_some_and(|v| v.contains(by))
            || by == "t" && evidence.moving.contains(&key)
            || evidence.calls.get(&key).is_some_and(|c| c.contains_key(&Some(vec![by.to_owned()])))
            || key == by
            || has_prime(&key)
    };
    // Somewhere in the paper it varies with something.
    let may_vary = |n: &PaperName| {
        let key = n.key();
        let is_called = || evidence.calls.get(&key).is_some_and(|c| c.keys().flatten().any(|places| is_place(places)));
        evidence.derived.contains_key(&key)
            || evidence.partial.contains_key(&key)
            || evidence.moving.contains(&key)
            || evidence.primes.contains_key(&key)
            || is_called()
    };
    let others_vary = all.iter().any(|n| n.key() != by && !n.is_partial && varies(n));
    let is_constant = |n: &PaperName| {
        let is_apart = !n.is_partial && others_vary || shows_itself && n.is_in_group && !may_vary(n);
        derives(n) && !varies(n) && is_apart
    };
    let held: Vec<usize> = (0..all.len()).filter(|&k| is_constant(&all[k])).collect();
    held.iter().for_each(|&k| all[k].derived_by = None);
    let granted = held.into_iter().filter(|_| !others_vary);
    granted.map(|k| (all[k].key(), by.to_owned())).collect()
}
