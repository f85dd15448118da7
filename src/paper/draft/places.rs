//! Functions of a formula and their places, and its coordinates.
//!
//! **In:** the names of a formula, and the evidence of the paper. **Out:** for each function its places, as the paper prints them or by what
//! it derives it; which names are coordinates; by what primes derive. **Guaranteed:** what has a rate here is no coordinate.

use std::collections::{BTreeMap, BTreeSet};

use super::super::names::{Call, PaperName, Primes, is_variable, unprimed};
use super::declared::Names;
use super::guess::SPACE;
use super::spelling::{bare, is_name, is_vector};

/// The most places of a function.
const MOST_PLACES: usize = 4;

impl Names<'_> {
    /// Functions of this formula, each with the names of its places.
    pub fn functions(&self) -> BTreeMap<String, Vec<String>> {
        let mut out: BTreeMap<String, Vec<String>> = BTreeMap::new();
        for name in self.all.iter().filter(|n| !n.is_difference) {
            let key = self.key(name);
            if out.contains_key(&key) || self.is_a_variable_here(&key) {
                continue;
            }
            if let Some(places) = self.places(name, &key) {
                out.insert(key, places);
            }
        }
        out
    }

    /// Whether a function has a rate here: along a motion its places change, too, which numbers do not.
    pub fn has_rate_of_function(&self) -> bool {
        let functions = self.functions();
        let rate = |n: &PaperName| n.dots > 0 || n.derived_by.as_deref() == Some("t") && !n.is_partial;
        self.text.contains(r"\nabla") || self.all.iter().any(|n| rate(n) && functions.contains_key(&self.key(n)))
    }

    /// Whether something is derived by this name here.
    pub fn is_a_variable_here(&self, key: &str) -> bool {
        let derives = |n: &PaperName| n.derived_by.as_deref() == Some(key) && !self.is_quotient_of_rates(n);
        self.all.iter().any(|n| derives(n) || n.is_variable && n.key() == key && !self.moves_here(key))
    }

    /// `\frac{d\psi}{d\theta}` of two that move: a quotient of rates.
    pub fn is_quotient_of_rates(&self, name: &PaperName) -> bool {
        let moves = |key: &str| self.evidence.moving.contains(key) && !self.is_still(key);
        !name.is_partial && name.derived_by.as_deref().is_some_and(|by| by != "t" && moves(by) && moves(&name.key()))
    }

    /// The places of a function: as the paper prints them, or by what it derives it.
    fn places(&self, name: &PaperName, key: &str) -> Option<Vec<String>> {
        let primed = || self.all.iter().any(|n| self.is_prime_of(n) && unprimed(n) == key);
        if let Some(by) = self.prime_variable().filter(|_| primed()) {
            return Some(vec![by]);
        }
        let calls = self.evidence.calls.get(key);
        let is_place = |p: &Vec<String>| p.iter().all(|v| is_name(v));
        let here: Vec<&Vec<String>> = self
            .all
            .iter()
            .filter(|n| self.key(n) == key)
            .filter_map(|n| if let Call::Places(p) = &n.call { Some(p).filter(|p| is_place(p)) } else { None })
            .collect();
        let called = !here.is_empty();
        // `f(x,y)`, where `f(x_0,y_0)` is printed as well: the value at a place.
        let of_variables = |p: &Vec<String>| {
            let alike = |h: &&Vec<String>| {
                h.len() == p.len() && h.iter().zip(p).all(|(a, b)| a != "t" && is_vector(a) == is_vector(b))
            };
            p.iter().all(|v| is_variable(v) || is_vector(v)) && here.iter().any(alike)
        };
        let printed = calls.and_then(|c| {
            let places = c.iter().filter_map(|(p, n)| Some((p.as_ref().filter(|p| is_place(p))?, *n)));
            places.max_by_key(|(p, n)| (of_variables(p), *n, p.len())).map(|(p, _)| p.clone())
        });
        // As it stands here, if it stands so everywhere here.
        let alike = here
            .first()
            .copied()
            .filter(|first| here.iter().all(|p| p == first) && first.iter().all(|p| is_variable(p)));
        let printed = alike.cloned().or(printed);
        let bare = calls.and_then(|c| c.get(&None)).copied().unwrap_or(0);
        let often =
            calls.map_or(0, |c| c.iter().filter(|(p, _)| p.as_ref().is_some_and(is_place)).map(|(_, n)| *n).sum());
        if let Some(places) = printed {
            let only_time = places == ["t"];
            let coordinate = |p: &String| self.is_a_variable_here(p) && p != "t";
            let needed = called || places.iter().any(coordinate) || self.is_prime_of(name);
            // One `x(t)`, and it moves.
            if only_time && !self.is_prime_of(name) && !self.derives_partially() {
                return None;
            }
            if called || needed && (often * 3 >= bare || self.is_prime_of(name)) {
                return Some(places);
            }
        }
        if let Some(places) = self.places_of_values(key) {
            return Some(places);
        }
        // `y(0)=1` of what the paper derives by one variable, by primes or otherwise.
        let is_at_number = |n: &&PaperName| matches!(&n.call, Call::Places(p) if p.len() == 1 && !is_name(&p[0]));
        if key != "t" && self.all.iter().filter(|n| self.key(n) == key).any(|n| is_at_number(&n)) {
            let derived = self.evidence.derived.get(key).filter(|by| by.len() == 1).and_then(|by| by.first().cloned());
            let by = self.evidence.primed_by(key).or(derived).filter(|by| by != "t" && is_variable(by));
            if let Some(by) = by.or_else(|| self.only_place_here(key)) {
                return Some(vec![by]);
            }
        }
        let here: BTreeSet<&str> = self
            .all
            .iter()
            .filter(|n| self.key(n) == key && !n.is_in_group && !self.is_quotient_of_rates(n))
            .filter(|n| n.is_partial || n.derived_by.as_deref().is_some_and(|by| by != "t"))
            .filter_map(|n| n.derived_by.as_deref())
            .collect();
        let wanted = |by: &String| self.is_a_variable_here(by);
        let partial = self.evidence.partial.get(key).into_iter().flatten();
        let total = self.evidence.derived.get(key).into_iter().flatten().filter(|by| *by != "t");
        let paper: BTreeSet<&str> = partial.chain(total).map(String::as_str).filter(|by| *by != key).collect();
        if here.is_empty() && !paper.iter().any(|by| *by != "t" && wanted(&(*by).to_owned())) {
            return None;
        }
        if !here.is_empty() && self.is_of_one_place(key) {
            return Some(here.into_iter().map(str::to_owned).collect());
        }
        // Along a motion everything changes on which it depends; else what nothing is derived by here is held fixed.
        let moves = self.all.iter().any(|n| !n.is_partial && n.derived_by.is_some());
        let most = if moves || here.is_empty() { MOST_PLACES.saturating_sub(here.len()) } else { 0 };
        let paper = paper.difference(&here).take(most);
        let mut places: Vec<String> = here.iter().chain(paper).map(|s| (*s).to_owned()).collect();
        if self.evidence.moving.contains(key) && !places.contains(&"t".to_owned()) {
            places.push("t".to_owned());
        }
        Some(places)
    }

    /// Of the variables at which the paper takes a function, `n(r)`, the only one that stands here: `n=n(0)e^{-r}`.
    fn only_place_here(&self, key: &str) -> Option<String> {
        let printed = self.evidence.calls.get(key)?.keys().flatten().filter(|p| p.len() == 1).flatten();
        let stands = |v: &&String| is_variable(v) && *v != "t" && self.all.iter().any(|n| n.key() == **v);
        let here: BTreeSet<&String> = printed.filter(stands).collect();
        if here.len() == 1 { here.into_iter().next().cloned() } else { None }
    }

    /// Whether a name is derived here by one variable that is not the time, and not partially: `\frac{dy}{dx}` is that of a function of x alone,
    /// whatever moves elsewhere.
    fn is_of_one_place(&self, key: &str) -> bool {
        let own = || self.all.iter().filter(|n| self.key(n) == key);
        let total = |n: &PaperName| !n.is_partial && n.derived_by.as_deref().is_some_and(|by| by != "t");
        let by: BTreeSet<Option<&str>> = own().filter(|n| total(n)).map(|n| n.derived_by.as_deref()).collect();
        by.len() == 1
            && own().all(|n| n.dots == 0 && (n.derived_by.is_none() || total(n)))
            && !self.all.iter().any(|n| n.key() == "t")
    }

    /// The places of a function of several, of which only values stand here, `u(x,0)`: what the paper prints at each place, where that is
    /// one variable alone.
    fn places_of_values(&self, key: &str) -> Option<Vec<String>> {
        let is_value = |p: &str| p.chars().all(|c| c.is_ascii_digit());
        let is_one = |p: &Vec<String>| p.len() > 1 && p.iter().all(|v| is_value(v) || is_variable(v));
        let calls = |n: &PaperName| if let Call::Places(p) = &n.call { Some(p.clone()) } else { None };
        let here = self.all.iter().filter(|n| self.key(n) == key).filter_map(calls).find(is_one)?;
        let printed: Vec<&Vec<String>> = self.evidence.calls.get(key)?.keys().flatten().collect();
        let alike = |p: &&&Vec<String>| p.len() == here.len() && is_one(p);
        let place = |at: usize| {
            let mut seen: BTreeSet<&String> = printed.iter().filter(alike).map(|p| &p[at]).collect();
            seen.retain(|v| !is_value(v));
            if seen.len() == 1 { seen.pop_first().cloned() } else { None }
        };
        let places: Vec<String> = (0..here.len()).map(place).collect::<Option<_>>()?;
        let distinct: BTreeSet<&String> = places.iter().collect();
        (distinct.len() == places.len() && places != here).then_some(places)
    }

    fn derives_partially(&self) -> bool {
        self.all.iter().any(|n| n.is_partial) || self.text.contains(r"\nabla")
    }

    /// What is a coordinate here.
    pub fn coordinates(&self, functions: &BTreeMap<String, Vec<String>>) -> BTreeSet<String> {
        if self.coordinates_are_numbers {
            return BTreeSet::new();
        }
        let mut out: BTreeSet<String> = BTreeSet::new();
        // `\frac{dy}{dx}=f(x,y)`: what depends on a place here is no place itself.
        let still = |p: &String| {
            (!self.moves_here(p) || self.is_of_primes(p)) && (self.is_a_variable_here(p) || !functions.contains_key(p))
        };
        let plain = |p: &&String| bare(p) == p.as_str() && (is_variable(p) || is_vector(p));
        for place in functions.values().flatten().filter(plain).filter(|p| still(p)) {
            if !self.places_are_numbers || self.is_a_variable_here(place) {
                out.insert(place.clone());
            }
        }
        for name in self.all.iter().filter(|n| !self.is_quotient_of_rates(n)) {
            let by = name.derived_by.as_ref().filter(|by| name.is_partial || *by != "t");
            out.extend(by.filter(|by| is_variable(by) && !self.moves_here(by)).cloned());
        }
        // A vector that is a coordinate is the place in space.
        if self.text.contains(r"\nabla") && !out.iter().any(|c| is_vector(c)) {
            out.extend(SPACE.map(str::to_owned));
        }
        out
    }

    /// Whether a name has a rate, and this formula does not take it for a coordinate.
    pub fn moves_here(&self, key: &str) -> bool {
        self.has_rate_here(key) || self.evidence.moving.contains(key) && !self.is_still(key)
    }

    /// Whether what moves elsewhere is a coordinate here: it is tried so, or the section derives by it, and prints no rate of it.
    fn is_still(&self, key: &str) -> bool {
        self.moving_are_coordinates || self.evidence.local.derives(self.place.section, key)
    }

    pub fn has_rate_here(&self, key: &str) -> bool {
        let by_time =
            |n: &PaperName| n.derived_by.as_deref() == Some("t") && !n.is_partial && (n.is_bold || !n.is_in_group);
        // `dE=T\,dS`: what has a differential changes along a motion.
        let differs = |pair: &[PaperName]| pair[0].is_difference && pair[0].letter == "d" && pair[1].key() == key;
        self.all.iter().any(|n| n.key() == key && (n.dots > 0 || by_time(n))) || self.all.windows(2).any(differs)
    }

    /// Whether primes derive by a name here.
    pub fn is_of_primes(&self, key: &str) -> bool {
        !self.has_rate_here(key) && self.prime_variable().as_deref() == Some(key)
    }

    /// Whether a variable stands in the formula, and no function is applied to it.
    pub fn stands_alone(&self, v: &str) -> bool {
        let applied = |n: &PaperName| matches!(&n.call, Call::Places(p) if p.as_slice() == [v]);
        self.all.iter().any(|n| n.key() == v) && !self.all.iter().any(applied)
    }

    /// Whether a variable is the only one of its section that stands here: functions are taken at it there, and no prime is printed of it.
    pub fn is_only_variable(&self, v: &str) -> bool {
        let is_independent =
            |key: &str| self.evidence.local.is_independent(self.place.chapter, self.place.section, key);
        is_independent(v) && !self.all.iter().map(PaperName::key).any(|key| key != v && is_independent(&key))
    }

    /// The variable by which primes derive here, one for all: none of those that are primed themselves.
    pub fn prime_variable(&self) -> Option<String> {
        let primed: Vec<String> = self.all.iter().filter(|n| n.primes > 0).map(unprimed).collect();
        let shown = |n: &String| match self.evidence.primes_in(n, self.place.section) {
            Primes::Derive(by) => Some(by),
            Primes::Usual(_) | Primes::Name | Primes::Unclear => None,
        };
        let mut candidates: BTreeSet<String> = primed.iter().filter_map(shown).collect();
        if candidates.is_empty() {
            candidates = primed.iter().filter_map(|n| self.evidence.primed_by(n)).collect();
        }
        let standing = |v: &&String| self.all.iter().any(|n| n.key() == **v);
        // What a system derives by the time is no place of others there: `x'=-y`, `y'=x`, `z'=z+x^2`.
        let is_primed = |v: &str| primed.iter().any(|p| p == v);
        let by_time = |v: &str| {
            let primes = self.evidence.primes_in(v, self.place.section);
            matches!(primes, Primes::Derive(by) | Primes::Usual(by) if by == "t")
        };
        let is_derived = |v: &String| {
            let mut others = self.evidence.local.moving_in(self.place.section).filter(|o| o != v && !is_primed(o));
            self.evidence.local.moves(self.place.section, v) && by_time(v) && others.any(by_time)
        };
        let mut free: Vec<&String> = candidates.iter().filter(|v| !primed.contains(v) && !is_derived(v)).collect();
        if free.len() > 1 && free.iter().any(&standing) {
            free.retain(standing);
        }
        match free.as_slice() {
            [] if candidates.is_empty() => None,
            [] => Some("t".to_owned()),
            several if several.len() > 1 && several.iter().any(|v| *v == "t") => Some("t".to_owned()),
            [first, ..] => Some((*first).clone()),
        }
    }
}
