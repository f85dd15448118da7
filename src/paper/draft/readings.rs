//! Formulas → what their names may be, from what the whole paper shows.
//!
//! **In:** the sides of a formula, and the [`Evidence`] of the paper. **Out:** the readings that are tried, in their order, or the feature that
//! keeps it from being read. **Guaranteed:** what could be an operator, a matrix, a function of anything, a sum over indices is not declared
//! as a number: it is refused by its name.

use std::collections::{BTreeMap, BTreeSet};

use super::super::names::letters::BOLD;
use super::super::names::{
    Call, Evidence, PaperName, Primes, Subscripts, evidence, is_variable, names_apart, order_counts, unprimed,
};
use super::super::printed::PrintedSide;
use super::guess::Guess;
use super::index;

/// What a formula is tried with.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Reading {
    /// Its symbols, in the order in which they are declared.
    pub symbols: Vec<Guess>,
    /// Whether `i` is the imaginary unit.
    pub is_complex: bool,
    /// Whether `\log` is the natural logarithm.
    pub has_logarithm: bool,
}

impl Reading {
    /// Whether all coordinates of space are among its symbols.
    pub(super) fn has_space(&self) -> bool {
        SPACE.iter().all(|c| self.symbols.iter().any(|g| g.role == "coordinate" && g.name == *c))
    }
}

/// The most places of a function.
const MOST_PLACES: usize = 4;
/// The coordinates of space.
pub(super) const SPACE: [&str; 3] = ["x", "y", "z"];

/// The readings of a formula, the best first: each with others that mean the same, and need less of the file.
///
/// # Errors
/// The feature that is not understood.
pub(super) fn readings(
    sides: &[&PrintedSide],
    evidence: &Evidence,
    is_of_indices: bool,
) -> Result<Vec<Vec<Reading>>, String> {
    let all: Vec<PaperName> = sides.iter().flat_map(|s| names_apart(s)).collect();
    obstacle(sides, &all, evidence)?;
    let summed = index::summed(sides, evidence);
    let of_indices = all.iter().any(|n| evidence.has_indices(&n.letter));
    let mut ways = Vec::new();
    if of_indices && is_of_indices {
        ways.push(true);
    }
    let mut refused = None;
    if index::has_symbols_of_indices(&all) {
        refused = Some("indices of δ or ε".to_owned());
    } else if let Some(letter) = summed.first() {
        refused = Some(format!("an index that may be summed over, {letter}"));
    } else {
        ways.push(false);
    }
    if of_indices && !is_of_indices {
        ways.push(true);
    }
    if ways.is_empty() {
        return Err(refused.unwrap_or_default());
    }
    let text: String = sides.iter().map(|s| s.text.as_str()).collect::<Vec<_>>().join(" ");
    let mut out: Vec<Vec<Reading>> = Vec::new();
    let has_charge =
        !evidence.has_exponentials && sides.iter().filter_map(|s| raised_e(s)).any(|(number, other)| number && !other);
    let size = sides.iter().find_map(|s| evidence::size(&s.tokens)).map(|(rows, _)| rows).filter(|n| *n > 1);
    for with_indices in ways {
        for (dimension, bold_matrices) in [(3, false), (size.unwrap_or(3), false), (3, true)] {
            let names = Names {
                all: &all,
                evidence,
                text: &text,
                with_indices,
                bold_matrices,
                dimension,
                places_are_numbers: false,
                moving_are_functions: false,
                coordinates_are_numbers: false,
                has_charge,
            };
            let mut tried: Vec<Reading> = Vec::new();
            for (places_are_numbers, moving_are_functions) in
                [(false, false), (true, false), (false, true), (true, true)]
            {
                let reading = Names { places_are_numbers, moving_are_functions, ..names }.reading()?;
                if !tried.contains(&reading) {
                    tried.push(reading);
                }
            }
            let numbers = Names { coordinates_are_numbers: true, ..names };
            if !numbers.has_rate_of_function()
                && let Ok(reading) = numbers.reading()
                && !tried.contains(&reading)
            {
                tried.push(reading);
            }
            if !out.contains(&tried) {
                out.push(tried);
            }
        }
    }
    Ok(out)
}

/// What keeps a formula from being read as numbers, vectors and functions.
fn obstacle(sides: &[&PrintedSide], all: &[PaperName], evidence: &Evidence) -> Result<(), String> {
    for side in sides {
        if side.text.is_empty() {
            return Err("a side that is missing".to_owned());
        }
        if let Some(letter) = index::upper(side) {
            return Err(format!("an upper index, {letter}"));
        }
        let sizes = |n: &PaperName| n.is_bold || evidence.size(&n.key()).is_some();
        if !all.iter().any(sizes) && order_counts(&side.text) {
            return Err("products whose order may count: matrices, or operators".to_owned());
        }
    }
    if let Some(name) = all.iter().find(|n| n.has_hat && !n.is_bold) {
        return Err(format!("a hat, {}: an operator, or a unit vector", name.key()));
    }
    if evidence.has_complex_j && all.iter().any(|n| n.key() == "j") {
        return Err("j, which may be the imaginary unit".to_owned());
    }
    let is_called = |n: &PaperName| matches!(&n.call, Call::Places(p) if p.iter().all(|p| is_name(p)));
    if all.iter().any(|n| unprimed(n) == "t" && (n.primes > 0 && is_called(n) || is_called(n) && n.dots == 0)) {
        return Err("the time as a function of something else".to_owned());
    }
    if all.iter().any(|n| n.key() == "t" && n.derived_by.as_deref().is_some_and(|by| by != "t")) {
        return Err("the time as a function of something else".to_owned());
    }
    let unclear = |n: &&PaperName| n.primes > 0 && evidence.primes_of(&unprimed(n)) == Primes::Unclear;
    if let Some(name) = all.iter().find(unclear) {
        return Err(format!("a prime, {}: a derivative, or another name", name.key()));
    }
    let bare_e = evidence.keys.contains_key("e");
    let raised = |s: &&&PrintedSide, bare: bool| raised_e(s).is_some_and(|(a, b)| if bare { a } else { b });
    // In a paper without exponentials it is a charge, or another name.
    if sides.iter().any(|s| raised(&s, true)) && bare_e && evidence.has_exponentials {
        return Err("e to a number: a charge, or Euler's number".to_owned());
    }
    if all.iter().any(|n| n.key() == "e") && sides.iter().any(|s| raised(&s, false)) {
        return Err("e as a factor, and to a power: a name, or Euler's number".to_owned());
    }
    Ok(())
}

/// Whether `e` stands in a side to a bare number, and to anything else.
fn raised_e(side: &PrintedSide) -> Option<(bool, bool)> {
    let marks = super::super::mark::marks(&side.tokens);
    let text = |i: usize| marks.get(i).map_or("", |m| m.text.as_str());
    let (mut number, mut other) = (false, false);
    for at in (0..marks.len()).filter(|&i| text(i) == "e" && text(i + 1) == "^" && (i == 0 || text(i - 1) != "_")) {
        let end = super::super::mark::unit(&marks, at + 2);
        let digits = (at + 2..end).map(text).filter(|t| !matches!(*t, "{" | "}"));
        let bare = digits.clone().all(|t| t.chars().all(|c| c.is_ascii_digit()));
        number |= bare;
        other |= !bare;
    }
    (number || other).then_some((number, other))
}

/// The names of a formula, and how they are taken.
#[derive(Clone, Copy)]
struct Names<'a> {
    all: &'a [PaperName],
    evidence: &'a Evidence,
    text: &'a str,
    /// Whether subscripts are indices of components, where they can be.
    with_indices: bool,
    /// Whether capital letters in bold are matrices.
    bold_matrices: bool,
    /// Whether what a function is applied to is a number, where nothing is derived by it, and no coordinate.
    places_are_numbers: bool,
    /// Whether what moves is a function of the time, and no state.
    moving_are_functions: bool,
    /// Whether coordinates are numbers, at which functions are taken and by which they are derived: a file has few coordinates.
    coordinates_are_numbers: bool,
    /// Whether `e` is raised to numbers alone in the whole paper.
    has_charge: bool,
    /// How many components a vector has, where the paper does not show it.
    dimension: usize,
}

impl Names<'_> {
    fn reading(&self) -> Result<Reading, String> {
        let is_usual =
            |n: &PaperName| n.primes > 0 && matches!(self.evidence.primes_of(&unprimed(n)), Primes::Usual(_));
        let is_shown =
            |n: &PaperName| n.primes > 0 && matches!(self.evidence.primes_of(&unprimed(n)), Primes::Derive(_));
        if self.all.iter().any(is_usual)
            && !self.all.iter().any(is_shown)
            && self.prime_variable().is_some_and(|v| v != "t" && self.stands_alone(&v))
        {
            return Err("a prime: a derivative, by something that the paper does not show".to_owned());
        }
        let functions = self.functions();
        let coordinates = self.coordinates(&functions);
        let mut out: Vec<Guess> = coordinates
            .iter()
            .filter(|c| *c != "t")
            .map(|c| Guess {
                role: "coordinate",
                shape: is_vector(c).then(|| self.dimension.to_string()),
                ..Guess::parameter(c.as_str(), "the paper derives by it, or applies a function to it")
            })
            .collect();
        let is_complex = self.evidence.is_complex && self.all.iter().any(|n| n.key() == "i");
        if self.has_charge {
            push(
                &mut out,
                Guess::parameter("e", "raised to numbers alone in the whole paper: a charge, and not Euler's number"),
            );
        }
        let mut at = 0;
        while let Some(name) = self.all.get(at) {
            at += 1;
            let next = self.all.get(at);
            if name.is_difference {
                if let Some(difference) = self.difference(name, next, &functions)? {
                    at += 1;
                    push(&mut out, difference);
                }
                continue;
            }
            if self.is_known(name, &coordinates, is_complex) {
                continue;
            }
            push(&mut out, self.guess(name, &functions, &coordinates, is_complex)?);
        }
        // What a function is applied to is declared, too, whether it stands in the formula or not.
        for place in functions.values().flatten() {
            let bare = bare(place);
            let known = bare == "t" || coordinates.contains(bare) || out.iter().any(|g| g.bare() == bare);
            if !known {
                let steady = self.places_are_numbers && self.is_of_primes(bare)
                    || self.coordinates_are_numbers && self.is_a_variable_here(bare);
                let moves = self.evidence.moving.contains(bare) && !steady || bare != place;
                let role = if moves { "state" } else { "parameter" };
                let shape = is_vector(bare).then(|| self.dimension.to_string());
                push(&mut out, Guess { role, shape, ..Guess::parameter(bare, "a function is applied to it") });
            }
        }
        if self.moving_are_functions {
            for guess in out.iter_mut().filter(|g| g.role == "state") {
                guess.name.push_str("(t)");
                guess.role = "field";
            }
        }
        // Fields stand behind their coordinates, components behind their vectors.
        let of_time = |g: &Guess| g.name.ends_with("(t)");
        out.sort_by_key(|g| {
            (g.role == "field" && !of_time(g), g.role == "field", g.role != "coordinate", g.shape.is_none())
        });
        let has_logarithm = !self.evidence.has_ln && self.text.contains(r"\log");
        Ok(Reading { symbols: out, is_complex, has_logarithm })
    }

    /// Whether a name needs no declaration.
    fn is_known(&self, name: &PaperName, coordinates: &BTreeSet<String>, is_complex: bool) -> bool {
        let key = name.key();
        key == "t" && !self.is_prime_of(name)
            || coordinates.contains(&key)
            || key == r"\pi"
            || name.letter == "e" && name.base == r"\mathrm{e}"
            || key == "i" && is_complex
            || self.is_component(name)
    }

    /// Whether the primes of a name derive it.
    fn is_prime_of(&self, name: &PaperName) -> bool {
        name.primes > 0 && self.evidence.primed_by(&unprimed(name)).is_some()
    }

    /// The key under which a name is declared: primes that derive are none of it, nor is an order of differentiation above.
    fn key(&self, name: &PaperName) -> String {
        let bare = PaperName { above: None, ..name.clone() };
        let order = name.above.as_deref().is_some_and(|a| a.starts_with('('));
        let name = if order && self.evidence.primed_by(&unprimed(&bare)).is_some() { &bare } else { name };
        if self.is_prime_of(name) { unprimed(name) } else { name.key() }
    }

    /// Functions of this formula, each with the names of its places.
    fn functions(&self) -> BTreeMap<String, Vec<String>> {
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
    fn has_rate_of_function(&self) -> bool {
        let functions = self.functions();
        let rate = |n: &PaperName| n.dots > 0 || n.derived_by.as_deref() == Some("t") && !n.is_partial;
        self.text.contains(r"\nabla") || self.all.iter().any(|n| rate(n) && functions.contains_key(&self.key(n)))
    }

    /// Whether something is derived by this name here.
    fn is_a_variable_here(&self, key: &str) -> bool {
        let derives = |n: &PaperName| n.derived_by.as_deref() == Some(key) && !self.is_quotient_of_rates(n);
        self.all.iter().any(|n| derives(n) || n.is_variable && n.key() == key && !self.moves_here(key))
    }

    /// `\frac{d\psi}{d\theta}` of two that move: a quotient of rates.
    fn is_quotient_of_rates(&self, name: &PaperName) -> bool {
        let moves = |key: &str| self.evidence.moving.contains(key);
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
        let printed = calls.and_then(|c| {
            let places = c.iter().filter_map(|(p, n)| Some((p.as_ref().filter(|p| is_place(p))?, *n)));
            places.max_by_key(|(p, n)| (*n, p.len())).map(|(p, _)| p.clone())
        });
        let here: Vec<&Vec<String>> = self
            .all
            .iter()
            .filter(|n| self.key(n) == key)
            .filter_map(|n| if let Call::Places(p) = &n.call { Some(p).filter(|p| is_place(p)) } else { None })
            .collect();
        let called = !here.is_empty();
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
        // `y(0)=1` of what the paper derives by one variable, by primes or otherwise.
        let is_at_number = |n: &&PaperName| matches!(&n.call, Call::Places(p) if p.len() == 1 && !is_name(&p[0]));
        if key != "t" && self.all.iter().filter(|n| self.key(n) == key).any(|n| is_at_number(&n)) {
            let derived = self.evidence.derived.get(key).filter(|by| by.len() == 1).and_then(|by| by.first().cloned());
            if let Some(by) = self.evidence.primed_by(key).or(derived).filter(|by| by != "t" && is_variable(by)) {
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
        let paper: BTreeSet<&str> = partial.chain(total).map(String::as_str).collect();
        if here.is_empty() && !paper.iter().any(|by| *by != "t" && wanted(&(*by).to_owned())) {
            return None;
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

    fn derives_partially(&self) -> bool {
        self.all.iter().any(|n| n.is_partial) || self.text.contains(r"\nabla")
    }

    /// What is a coordinate here.
    fn coordinates(&self, functions: &BTreeMap<String, Vec<String>>) -> BTreeSet<String> {
        if self.coordinates_are_numbers {
            return BTreeSet::new();
        }
        let mut out: BTreeSet<String> = BTreeSet::new();
        let still = |p: &String| !self.moves_here(p) || self.is_of_primes(p);
        for place in functions.values().flatten().filter(|p| (is_variable(p) || is_vector(p)) && still(p)) {
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
    fn moves_here(&self, key: &str) -> bool {
        self.has_rate_here(key) || self.evidence.moving.contains(key)
    }

    fn has_rate_here(&self, key: &str) -> bool {
        let by_time =
            |n: &PaperName| n.derived_by.as_deref() == Some("t") && !n.is_partial && (n.is_bold || !n.is_in_group);
        // `dE=T\,dS`: what has a differential changes along a motion.
        let differs = |pair: &[PaperName]| pair[0].is_difference && pair[0].letter == "d" && pair[1].key() == key;
        self.all.iter().any(|n| n.key() == key && (n.dots > 0 || by_time(n))) || self.all.windows(2).any(differs)
    }

    /// Whether primes derive by a name here.
    fn is_of_primes(&self, key: &str) -> bool {
        !self.has_rate_here(key) && self.prime_variable().as_deref() == Some(key)
    }

    /// Whether a variable stands in the formula, and no function is applied to it.
    fn stands_alone(&self, v: &str) -> bool {
        let applied = |n: &PaperName| matches!(&n.call, Call::Places(p) if p.as_slice() == [v]);
        self.all.iter().any(|n| n.key() == v) && !self.all.iter().any(applied)
    }

    /// The variable by which primes derive here, one for all: none of those that are primed themselves.
    fn prime_variable(&self) -> Option<String> {
        let primed: Vec<String> = self.all.iter().filter(|n| n.primes > 0).map(unprimed).collect();
        let shown = |n: &String| match self.evidence.primes_of(n) {
            Primes::Derive(by) => Some(by),
            Primes::Usual(_) | Primes::Name | Primes::Unclear => None,
        };
        let mut candidates: BTreeSet<String> = primed.iter().filter_map(shown).collect();
        if candidates.is_empty() {
            candidates = primed.iter().filter_map(|n| self.evidence.primed_by(n)).collect();
        }
        let standing = |v: &&String| self.all.iter().any(|n| n.key() == **v);
        let mut free: Vec<&String> = candidates.iter().filter(|v| !primed.contains(v)).collect();
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

    /// `\Delta x`: one name, unless it is the Laplacian of a field.
    fn difference(
        &self,
        name: &PaperName,
        next: Option<&PaperName>,
        functions: &BTreeMap<String, Vec<String>>,
    ) -> Result<Option<Guess>, String> {
        if name.letter == "d" {
            return Ok(None);
        }
        let Some(next) = next.filter(|n| !functions.contains_key(&self.key(n)) && !n.is_difference) else {
            return Ok(None);
        };
        if next.call != Call::None || next.dots > 0 {
            return Err(format!("a difference, {}", name.letter));
        }
        Ok(Some(Guess {
            shape: self.shape(next),
            ..Guess::parameter(format!("{} {}", name.letter, next.key()), "a difference of its own")
        }))
    }

    fn guess(
        &self,
        name: &PaperName,
        functions: &BTreeMap<String, Vec<String>>,
        coordinates: &BTreeSet<String>,
        is_complex: bool,
    ) -> Result<Guess, String> {
        let key = self.key(name);
        let shape = self.shape(name);
        let complex = is_complex && self.is_complex(name);
        let is_labelled = shape.is_some() && name.subscript.is_none() && self.is_labelled(name);
        if let Some(places) = functions.get(&key) {
            let shown: Vec<&str> = places.iter().map(String::as_str).collect();
            let why = match places.iter().all(|p| coordinates.contains(p)) {
                true => "a function of its coordinates",
                false => "a function of what moves, or of numbers",
            };
            return Ok(Guess {
                name: format!("{key}({})", shown.join(",")),
                role: "field",
                shape,
                is_complex: complex,
                is_labelled,
                why,
            });
        }
        let moves_alone = self.has_rate_here(&key) && !self.evidence.partial.contains_key(&key);
        if self.text.contains(r"\nabla") && !moves_alone && self.is_field_of_space(name, &key) {
            let space = match coordinates.iter().find(|c| is_vector(c)) {
                Some(place) => place.clone(),
                None => SPACE.join(","),
            };
            let time = if self.evidence.partial.get(&key).is_some_and(|by| by.contains("t")) { ",t" } else { "" };
            return Ok(Guess {
                name: format!("{key}({}{time})", space),
                role: "field",
                shape,
                is_complex: complex,
                is_labelled,
                why: "the paper applies ∇",
            });
        }
        if self.with_indices && self.evidence.has_indices(&name.letter) && !name.is_bold {
            let two = self.evidence.subscripts.get(&name.letter).is_some_and(Subscripts::have_pair);
            let shape = Some(if two { "3x3" } else { "3" }.to_owned());
            let moves = self.moves(name, &name.base);
            let (role, why) = if moves {
                ("state", "its subscripts are indices, and it has a rate")
            } else {
                ("parameter", "its subscripts are indices")
            };
            return Ok(Guess { name: name.base.clone(), role, shape, is_complex: false, is_labelled: false, why });
        }
        let (role, why) = match self.moves(name, &key) {
            true => ("state", "the paper prints its rate, or its value at a time"),
            false if name.subscript.is_some() => ("parameter", "a name with a label"),
            false => ("parameter", "the paper prints no rate of it"),
        };
        Ok(Guess { name: key, role, shape, is_complex: complex, is_labelled, why })
    }

    /// Whether the paper prints names that could be components of this vector or matrix, and this formula has none.
    fn is_labelled(&self, name: &PaperName) -> bool {
        self.evidence.subscripts.get(&name.letter).is_some_and(Subscripts::have_named)
            && !self.all.iter().any(|n| self.is_component(n))
    }

    /// Whether a name is a component of a vector of this formula.
    fn is_component(&self, name: &PaperName) -> bool {
        !name.is_bold
            && name.subscript.as_deref().is_some_and(|s| s.len() == 1 && "123ijkl".contains(s))
            && self.all.iter().any(|n| n.is_bold && n.letter == name.letter && n.subscript.is_none())
    }

    /// Whether a name has a rate somewhere, or a value at a time.
    fn moves(&self, name: &PaperName, key: &str) -> bool {
        let calls = self.evidence.calls.get(key);
        let printed = calls.is_some_and(|c| {
            c.keys().flatten().any(|p| p == &["t"] || p == &["t_0"] || p == &["0"] && !self.evidence.moving.is_empty())
        });
        let with_index = || {
            let base = format!("{}_", name.base);
            let first = self.evidence.moving.range(base.clone()..).next();
            name.subscript.is_some() && key == name.base && first.is_some_and(|m| m.starts_with(&base))
        };
        self.evidence.moving.contains(key) || self.has_rate_here(key) || printed || with_index()
    }

    /// Whether ∇ acts on a name.
    fn is_field_of_space(&self, name: &PaperName, key: &str) -> bool {
        let derived = self.evidence.partial.contains_key(key);
        let spelled = name.letter.as_str();
        let after = |op: &str| {
            self.text.match_indices(op).any(|(i, _)| {
                let rest = self.text[i + op.len()..].trim_start_matches(['}', ' ', '{', '^', '2', '(']);
                let rest =
                    rest.trim_start_matches(r"\cdot").trim_start_matches(r"\times").trim_start_matches(r"\left(");
                let rest = rest.trim_start_matches([' ', '{']);
                let rest = ["mathbf", "boldsymbol", "vec", "bm", "bf"]
                    .iter()
                    .fold(rest, |r, s| r.strip_prefix('\\').and_then(|t| t.strip_prefix(s)).unwrap_or(r));
                rest.trim_start_matches(['{', ' ']).starts_with(spelled)
            })
        };
        name.is_bold || derived || after(r"\nabla")
    }

    /// Whether the values of a name are complex numbers: it is what a formula with the imaginary unit defines, or the paper conjugates it.
    fn is_complex(&self, name: &PaperName) -> bool {
        let key = self.key(name);
        let starred = format!("{key}^{{*}}");
        matches!(name.letter.as_str(), r"\psi" | r"\Psi")
            || self.evidence.keys.contains_key(&starred)
            || self.first() == Some(key)
    }

    /// The name with which a formula begins, where its left side is nothing else.
    fn first(&self) -> Option<String> {
        let name = self.all.first()?;
        self.text.trim_start().starts_with(name.base.as_str()).then(|| self.key(name))
    }

    /// The shape of a name: what it is equal to somewhere, or that of its style.
    fn shape(&self, name: &PaperName) -> Option<String> {
        let key = name.key();
        let several =
            self.evidence.sizes.get(&key).is_some_and(|s| s.len() > 1 && s.keys().any(|s| s.0 == self.dimension));
        let one = (
            self.dimension,
            if name.letter.starts_with(|c: char| c.is_ascii_uppercase()) { self.dimension } else { 1 },
        );
        let size = match several {
            true => Some(one),
            false => self.evidence.size(&key).or_else(|| self.evidence.size(&unprimed(name))),
        };
        match size {
            Some((1, 1)) => None,
            Some((rows, 1)) => Some(rows.to_string()),
            Some((rows, columns)) if rows == columns => Some(format!("{rows}x{columns}")),
            Some(_) => None,
            None if name.is_bold => {
                let capital = name.letter.starts_with(|c: char| c.is_ascii_uppercase());
                let n = self.dimension;
                Some(if capital && self.bold_matrices { format!("{n}x{n}") } else { n.to_string() })
            }
            None => None,
        }
    }
}

/// What stands under the dots of a place.
pub(super) fn bare(place: &str) -> &str {
    let Some(inside) = place.strip_prefix(r"\ddot").or_else(|| place.strip_prefix(r"\dot")) else { return place };
    let inside = inside.trim();
    inside.strip_prefix('{').and_then(|s| s.strip_suffix('}')).unwrap_or(inside)
}

/// A name that may stand in the place of a function.
fn is_name(place: &str) -> bool {
    !place.is_empty() && !place.chars().all(|c| c.is_ascii_digit())
}

/// Whether the style of a place is that of vectors.
fn is_vector(place: &str) -> bool {
    BOLD.iter().any(|style| place.contains(&format!("\\{style}")))
}

fn push(out: &mut Vec<Guess>, guess: Guess) {
    if !out.iter().any(|g| g.name == guess.name) {
        out.push(guess);
    }
}
