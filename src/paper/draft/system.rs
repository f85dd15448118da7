//! A first system and a first motion: from the rates that the paper prints.
//!
//! **In:** formulas that give the rate of a state. **Out:** the text of `[system.motion]` and of a trajectory with numbers. **Guaranteed:** every
//! state that the equations name has one equation; the numbers are not 1 and all different, so that no term hides.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

use super::formula::{Formula, Printed};
use super::guess::Guess;
use super::settle::Settled;
use super::write;

/// A system that the paper's rates determine.
#[derive(Clone, Debug, Default)]
pub(super) struct System {
    /// Its states, each with the order of its equation.
    states: BTreeMap<String, usize>,
    equations: Vec<String>,
    parameters: Vec<String>,
    /// What the motion has a value of: its states and parameters.
    known: BTreeSet<String>,
}

/// The most equations of a system that is guessed: one of more is no motion that a person confirms.
const MOST_EQUATIONS: usize = 100;

/// Values of parameters and states: none is 1, and no two are alike.
fn number(at: usize) -> String {
    const FIRST: [&str; 8] = ["0.7", "1.3", "0.4", "1.7", "0.9", "2.3", "0.6", "1.9"];
    match FIRST.get(at) {
        Some(number) => (*number).to_owned(),
        None => format!("{}.{}", 1 + at / 10, 1 + at % 9),
    }
}

impl System {
    /// The system of the first equations that give rates of states which no other equation is needed for.
    pub fn of(all: &[Printed], settled: &Settled) -> Option<System> {
        let states = settled.symbols.iter().filter(|s| s.role == "state" && s.shape.is_none());
        let states: BTreeSet<&str> = states.map(|s| s.name.as_str()).collect();
        let mut rates: BTreeMap<&str, &Formula> = BTreeMap::new();
        for formula in all.iter().flat_map(|p| &p.formulas) {
            if let Some((key, _)) = formula.rate.as_ref().filter(|_| formula.refused.is_none() && formula.steps == 1)
                && states.contains(key.as_str())
                && settled.own_symbols(formula).is_empty()
                && formula
                    .needs
                    .symbols
                    .iter()
                    .all(|g| matches!(g.role, "state" | "parameter") && g.shape.is_none() && !g.is_complex)
                && !formula.needs.is_complex
            {
                rates.entry(key).or_insert(formula);
            }
        }
        if rates.len() > MOST_EQUATIONS {
            return None;
        }
        // What needs a state without an equation has none, again and again.
        loop {
            let known: BTreeSet<&str> = rates.keys().copied().collect();
            let whole =
                |f: &Formula| f.needs.symbols.iter().all(|g| g.role != "state" || known.contains(g.name.as_str()));
            let before = rates.len();
            rates.retain(|_, f| whole(f));
            if rates.len() == before {
                break;
            }
        }
        let mut out = System::default();
        for (key, formula) in &rates {
            out.states.insert((*key).to_owned(), formula.rate.as_ref().map_or(1, |r| r.1));
            out.known.insert((*key).to_owned());
            out.equations.push(formula.text.clone());
            for guess in formula.needs.symbols.iter().filter(|g| g.role == "parameter") {
                if out.known.insert(guess.name.clone()) {
                    out.parameters.push(guess.name.clone());
                }
            }
        }
        (!out.states.is_empty()).then_some(out)
    }

    /// Whether a claim speaks of nothing that the motion has no value of.
    pub fn has(&self, symbols: &[&Guess]) -> bool {
        symbols.iter().all(|g| self.known.contains(&g.name))
    }

    /// Its text.
    pub fn text(&self) -> String {
        let listed =
            |keys: &mut dyn Iterator<Item = &String>| keys.map(|k| write::formula(k)).collect::<Vec<_>>().join(", ");
        let mut out = String::from(
            "\n# confirm: the equations that move the states, as the paper prints them.\n[system.motion]\n",
        );
        let _ = writeln!(out, "states = [{}]", listed(&mut self.states.keys()));
        let _ = writeln!(out, "equations = [{}]", listed(&mut self.equations.iter()));
        out.push_str("\n# confirm: numbers of no meaning, none of them 1.\n[[trajectory]]\nid = \"first\"\nsystem = \"motion\"\n");
        let mut at = 0;
        let mut next = |key: &str| {
            at += 1;
            let key = if key.contains('\'') { super::spelling::quoted(key) } else { format!("'{key}'") };
            format!("{key} = {}", number(at - 1))
        };
        let parameters: Vec<String> = self.parameters.iter().map(|p| next(p)).collect();
        let mut initial = Vec::new();
        for (key, order) in &self.states {
            initial.push(next(key));
            for rate in 1..*order {
                initial.push(next(&format!(r"{} {key}", if rate == 1 { r"\dot" } else { r"\ddot" })));
            }
        }
        let _ = writeln!(out, "parameters = {{ {} }}", parameters.join(", "));
        let _ = writeln!(out, "initial = {{ {} }}\nspan = [0, 1]", initial.join(", "));
        out
    }
}
