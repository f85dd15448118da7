//! Guesses of all formulas → symbols of the file, and of single claims.
//!
//! **In:** formulas with what they need. **Out:** what the whole file declares: for each name the guess that most formulas need. **Guaranteed:**
//! a formula that needs another guess has it in its own claim; only what a claim cannot declare, the time, states and coordinates, is
//! refused there.

use std::collections::{BTreeMap, BTreeSet};

use super::formula::{Formula, Printed, load};
use super::formulas;
use super::guess::{Guess, Reading, SPACE};
use super::write;
use diag::Diagnostic;

/// The most coordinates of a file, beside the time.
const MOST_COORDINATES: usize = 4;

/// Guesses in the order in which a file declares them, each once.
#[derive(Clone, Debug, Default)]
pub(super) struct Symbols {
    order: Vec<Guess>,
    known: BTreeSet<Guess>,
}

impl Symbols {
    fn of(order: Vec<Guess>) -> Symbols {
        Symbols { known: order.iter().cloned().collect(), order }
    }

    /// Whether the file declares just this.
    pub fn contains(&self, guess: &Guess) -> bool {
        self.known.contains(guess)
    }

    /// All, in order.
    pub fn iter(&self) -> std::slice::Iter<'_, Guess> {
        self.order.iter()
    }

    fn remove(&mut self, at: usize) -> Guess {
        let guess = self.order.remove(at);
        self.known.remove(&guess);
        guess
    }
}

/// What the whole file declares.
#[derive(Clone, Debug, Default)]
pub(super) struct Settled {
    /// Its symbols, but the time.
    pub symbols: Symbols,
    /// What was taken back, and why.
    pub clashes: Vec<String>,
}

impl Settled {
    /// Of guesses on one name the one that most formulas need is the file's.
    pub fn of(all: &mut [Printed]) -> Settled {
        let mut counts: BTreeMap<Guess, usize> = BTreeMap::new();
        let mut order: Vec<Guess> = Vec::new();
        for guess in formulas(all).filter(|f| f.refused.is_none()).flat_map(|f| f.needs.symbols.clone()) {
            let n = counts.entry(guess.clone()).or_insert(0);
            if *n == 0 {
                order.push(guess);
            }
            *n += 1;
        }
        let mut out = Settled::default();
        let mut coordinates = most_coordinates(&order, &counts);
        // Where ∇ stands, the coordinates are those of space: formulas with others can be read with numbers in their place.
        let is_of_space =
            formulas(all).any(|f| f.refused.is_none() && f.needs.has_space() && f.text.contains(r"\nabla"));
        if is_of_space {
            coordinates = SPACE.iter().map(|c| (*c).to_owned()).collect();
        }
        let parted = parted(&order);
        // Beside `[X]`, which is a name, X is declared where it stands.
        let inside = |g: &Guess| Some(g.bare().strip_prefix('[')?.split_once(']')?.0.to_owned());
        let bracketed: BTreeSet<String> = order.iter().filter_map(inside).collect();
        let able = |g: &Guess| {
            (g.role != "coordinate" || coordinates.contains(&g.name))
                && !g.is_of_its_formula()
                && !bracketed.contains(g.bare())
                && (g.is_of_the_file() && g.shape.is_none() || !parted.contains(&family(g)) || g.is_labelled)
        };
        // What only the file can declare goes before the rest; then what most formulas need, the first of several.
        let count = |g: &Guess| counts.get(g).copied().unwrap_or(0);
        // ∇ needs the coordinates of space; what moves can be a function of the time.
        let of_space = |g: &Guess| is_of_space && g.role == "coordinate";
        let weight = |g: &Guess| (g.is_of_the_file(), of_space(g), count(g));
        let mut best: BTreeMap<&str, &Guess> = BTreeMap::new();
        for guess in order.iter().filter(|g| able(g)) {
            let known = best.entry(guess.bare()).or_insert(guess);
            if weight(guess) > weight(known) {
                *known = guess;
            }
        }
        let mut symbols: Vec<Guess> = order.iter().filter(|g| best.get(g.bare()) == Some(g)).cloned().collect();
        symbols.sort_by_key(|g| (g.role == "field", g.role != "coordinate", g.shape.is_none()));
        out.symbols = Symbols::of(symbols);
        out.withdraw(all);
        out
    }

    /// Refuses formulas that need what a claim cannot declare.
    fn withdraw(&mut self, all: &mut [Printed]) {
        for formula in formulas(all).filter(|f| f.refused.is_none()) {
            let lost =
                |r: &Reading| r.symbols.iter().find(|g| g.is_of_the_file() && !self.symbols.contains(g)).cloned();
            let Some(first) = lost(&formula.needs) else { continue };
            let text = formula.text.clone();
            let loads = |r: &Reading| lost(r).is_none() && load(&write::single(&text, r)).is_ok();
            if let Some(other) = formula.others.iter().position(loads) {
                formula.needs = formula.others.remove(other);
                continue;
            }
            let why = match first.role {
                "coordinate" => "a coordinate of the file, which has others",
                _ => "a state, which is something else in most formulas",
            };
            formula.refused = Some(format!("`{}` would be {why}", first.name));
        }
    }

    /// The symbols that a formula needs and the file declares otherwise.
    pub fn own_symbols(&self, formula: &Formula) -> Vec<Guess> {
        let all = &formula.needs.symbols;
        let mut own: Vec<bool> = all.iter().map(|g| !self.symbols.contains(g)).collect();
        // A function of what the claim declares is its own, too, even if the file has one of that name.
        for (i, guess) in all.iter().enumerate().filter(|(_, g)| g.role == "field") {
            let places = guess.places();
            own[i] |= all.iter().enumerate().any(|(k, g)| k != i && own[k] && places.contains(&g.bare()));
        }
        all.iter().zip(&own).filter(|(_, own)| **own).map(|(g, _)| g.clone()).collect()
    }

    /// Takes back what the whole file cannot have: the guess, or the formula, at which a problem stands. Whether there was any.
    pub fn taken_back(&mut self, found: &[Diagnostic], all: &mut [Printed]) -> bool {
        let mut done = false;
        for problem in found {
            let Some(span) = problem.place.as_ref().map(|l| l.span.clone()) else { continue };
            let start =
                problem.source.text[..span.start.min(problem.source.text.len())].rfind('\n').map_or(0, |i| i + 1);
            let line = problem.source.text[start..].lines().next().unwrap_or_default();
            let at = |f: &&mut Formula| f.refused.is_none() && f.place.contains(&span.start);
            if let Some(formula) = formulas(all).find(at) {
                formula.refused = Some(format!("beside the other names: {}", problem.message));
                done = true;
                continue;
            }
            // A symbol of the file that has the name of a component here is declared where it is needed.
            let named: Vec<&str> = problem.message.split('`').skip(1).step_by(2).take(2).collect();
            let clash = self.symbols.iter().position(|s| named.contains(&s.name.as_str()) && !s.is_of_the_file());
            if let Some(at) = clash.filter(|_| problem.code == "latex::bad-name") {
                self.symbols.remove(at);
                return true;
            }
            let mut own = false;
            for formula in formulas(all).filter(|f| f.refused.is_none() && f.symbols.contains(&span.start)) {
                if formula.needs.symbols.iter().any(|g| line.starts_with(&g.key())) {
                    formula.refused = Some(format!("beside the other names: {}", problem.message));
                    own = true;
                }
            }
            done |= own;
            if own {
                continue;
            }
            if let Some(at) = self.symbols.iter().position(|s| line.starts_with(&format!("{} =", s.key()))) {
                let guess = self.symbols.remove(at);
                self.clashes.push(format!("{}: {}: {}", guess.name, guess.role, problem.message));
                self.withdraw(all);
                // Other places may mean other things now.
                return true;
            }
        }
        done
    }
}

/// The coordinates that most formulas need, as many as a file may have beside the time.
fn most_coordinates(order: &[Guess], counts: &BTreeMap<Guess, usize>) -> BTreeSet<String> {
    let mut all: Vec<(&Guess, usize)> =
        order.iter().filter(|g| g.role == "coordinate").map(|g| (g, counts.get(g).copied().unwrap_or(0))).collect();
    all.sort_by_key(|(g, n)| (std::cmp::Reverse(*n), g.name.clone()));
    all.into_iter().take(MOST_COORDINATES).map(|(g, _)| g.name.clone()).collect()
}

/// The letter of a guess, without styles and labels.
fn family(guess: &Guess) -> String {
    let bare = guess.bare().split(['_', '^']).next().unwrap_or_default();
    let plain =
        ["mathbf", "boldsymbol", "vec", "bm"].iter().fold(bare.to_owned(), |t, s| t.replace(&format!("\\{s}"), ""));
    plain.chars().filter(|c| !matches!(c, '{' | '}' | ' ' | '\'')).collect()
}

/// Letters of vectors or matrices of which a component, or a vector that is called like one, stands beside them: each is declared where it
/// is needed.
fn parted(order: &[Guess]) -> BTreeSet<String> {
    let whole: BTreeSet<String> =
        order.iter().filter(|g| g.shape.is_some() && !g.name.contains('_')).map(family).collect();
    order.iter().filter(|g| g.name.contains('_')).map(family).filter(|f| whole.contains(f)).collect()
}
