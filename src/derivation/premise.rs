//! What the names under `follows-from` mean, in one place: everything that asks for the premises of a claim asks here.
//!
//! **Guaranteed:** a name means one thing, and no claim of a [`Derivation`] follows from itself, not even through others.
//! A circle of claims would prove them all from nothing.

use std::borrow::Cow;
use std::collections::{HashMap, HashSet};
use std::ops::Range;

use super::load::Loader;
use super::model::{Claim, Derivation, Motion, SymbolEntry};
use expr::{Symbol, Tensor};
use latex::Role;

/// What a name under `follows-from` means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Premise {
    /// The equations of a system: its position in [`Derivation::systems`].
    System(usize),
    /// What a claim, or one reading of it, says: its position in [`Derivation::claims`].
    Claim(usize),
    /// The definition of a symbol, which is always given.
    Definition,
}

impl Premise {
    /// The position of the claim, if it is one.
    pub fn claim(self) -> Option<usize> {
        match self {
            Premise::Claim(at) => Some(at),
            Premise::System(_) | Premise::Definition => None,
        }
    }
}

/// The names of claims and systems, and what is said of symbols. A file may have as many as it likes, and each claim asks.
#[derive(Clone, Debug, Default)]
pub struct Index {
    names: HashMap<String, Premise>,
    angles: HashSet<Symbol>,
    /// The positive symbols, each with its role.
    positive: HashMap<Symbol, Role>,
    /// The first claim that declares a symbol.
    declared: HashMap<Symbol, usize>,
    /// How many claims and symbols there were. Where more are put beside them, these are asked.
    claims: usize,
    symbols: usize,
}

impl Claim {
    /// Whether a name is that of this claim: `id`, or `id/reading`.
    pub fn is_called(&self, name: &str) -> bool {
        is_called(name, &self.id, self.reading.as_deref())
    }
}

/// Whether a name is that of a claim with this id and reading: `id`, or `id/reading`.
pub fn is_called(name: &str, id: &str, reading: Option<&str>) -> bool {
    match name.split_once('/') {
        None => id == name,
        Some((of, own)) => id == of && reading == Some(own),
    }
}

impl Derivation {
    /// What a name under `follows-from` means: a system, or else a claim, or else a symbol.
    ///
    /// Of a claim with readings, its id alone means the claim itself where it says something, otherwise the first reading.
    pub fn premise(&self, name: &str) -> Premise {
        if !self.index.names.is_empty() {
            return self.index.names.get(name).copied().unwrap_or(Premise::Definition);
        }
        if let Some(system) = self.systems.iter().position(|s| s.id == name) {
            return Premise::System(system);
        }
        self.claims.iter().position(|c| c.is_called(name)).map_or(Premise::Definition, Premise::Claim)
    }

    /// The claims among some names under `follows-from`, by their positions.
    pub fn claims_among<'a>(&'a self, names: &'a [String]) -> impl Iterator<Item = usize> + use<'a> {
        names.iter().filter_map(|name| self.premise(name).claim())
    }

    /// The claim with an id and a reading, in whose place in the index another may stand: what has the name of a system, or was put
    /// beside the claims of the file.
    pub fn claim(&self, id: &str, reading: Option<&str>) -> Option<&Claim> {
        self.claims.get(self.claim_at(id, reading)?)
    }

    /// The position of that claim.
    pub fn claim_at(&self, id: &str, reading: Option<&str>) -> Option<usize> {
        let is = |c: &Claim| c.id == id && c.reading.as_deref() == reading;
        let name = reading.map_or(Cow::Borrowed(id), |reading| format!("{id}/{reading}").into());
        let known = match self.index.names.get(name.as_ref()) {
            Some(Premise::Claim(at)) => self.claims.get(*at).is_some_and(is).then_some(*at),
            Some(Premise::System(_) | Premise::Definition) | None => None,
        };
        known.or_else(|| self.claims.iter().position(is))
    }

    /// The definition of a symbol, wherever it is declared.
    pub fn definition(&self, symbol: Symbol) -> Option<&Tensor> {
        self.scope.definition(symbol).or_else(|| self.declaring(symbol)?.scope.definition(symbol))
    }

    /// The role of a symbol, wherever it is declared.
    pub fn role(&self, symbol: Symbol) -> Option<Role> {
        self.scope.role(symbol).or_else(|| self.declaring(symbol)?.scope.role(symbol))
    }

    /// The claim that declares a symbol.
    fn declaring(&self, symbol: Symbol) -> Option<&Claim> {
        let declares = |c: &&Claim| c.scope.role(symbol).is_some();
        if self.claims.len() < self.index.claims {
            // Some were taken out, and the others have other places.
            return self.claims.iter().find(declares);
        }
        let first = self.index.declared.get(&symbol).and_then(|at| self.claims.get(*at));
        first.into_iter().chain(self.claims.iter().skip(self.index.claims)).find(declares)
    }

    /// The symbols that the file and its claims declare.
    fn declared(&self) -> impl Iterator<Item = &SymbolEntry> {
        self.symbols.iter().chain(self.claims.iter().flat_map(|c| &c.symbols))
    }

    /// The role of a symbol that is declared as positive.
    pub fn role_of_positive(&self, symbol: Symbol) -> Option<Role> {
        let known = self.index.positive.get(&symbol).copied();
        let later = self.symbols.iter().skip(self.index.symbols);
        let own = self.claims.iter().skip(self.index.claims).flat_map(|c| &c.symbols);
        known.or_else(|| later.chain(own).find(|s| s.symbol == symbol && s.positive).map(|s| s.role))
    }

    /// Whether a symbol is a parameter that is declared as positive.
    pub fn is_positive_parameter(&self, symbol: Symbol) -> bool {
        self.role_of_positive(symbol) == Some(Role::Parameter)
    }
}

impl Derivation {
    /// Makes the index, when all claims are there.
    pub(super) fn make_index(&mut self) {
        let mut names = HashMap::new();
        for (at, claim) in self.claims.iter().enumerate() {
            names.entry(claim.id.clone()).or_insert(Premise::Claim(at));
            if let Some(reading) = &claim.reading {
                names.entry(format!("{}/{reading}", claim.id)).or_insert(Premise::Claim(at));
            }
        }
        // Systems go before claims.
        for (at, system) in self.systems.iter().enumerate().rev() {
            names.insert(system.id.clone(), Premise::System(at));
        }
        let angles = self.declared().filter(|s| s.angle).map(|s| s.symbol).collect();
        let positive = self.declared().filter(|s| s.positive).map(|s| (s.symbol, s.role)).collect();
        let mut declared = HashMap::new();
        for (at, claim) in self.claims.iter().enumerate() {
            for symbol in &claim.symbols {
                declared.entry(symbol.symbol).or_insert(at);
            }
        }
        self.index =
            Index { names, angles, positive, declared, claims: self.claims.len(), symbols: self.symbols.len() };
    }

    /// What a claim is said to follow from: the names that it gives, or the one system of its motions.
    pub fn given_to(&self, claim: &Claim) -> Vec<String> {
        if !claim.follows_from.is_empty() {
            return claim.follows_from.clone();
        }
        match self.systems_of_motions(claim).as_slice() {
            // Two systems that move the same states contradict each other, and everything would follow.
            [Some(only)] => vec![self.systems[*only].id.clone()],
            _ => Vec::new(),
        }
    }

    /// The systems of the motions on which a claim is tried, members of families among them; `None` for one that is not written: that
    /// of motions which are computed from those of a system.
    pub fn systems_of_motions(&self, claim: &Claim) -> Vec<Option<usize>> {
        let motion = |t: usize| &self.trajectories[t].motion;
        let of_families = claim.families.iter().map(|&f| self.families[f].of);
        let mut systems: Vec<Option<usize>> = Vec::new();
        let mut computed = false;
        for at in claim.trajectories.iter().copied().chain(of_families) {
            match motion(at) {
                Motion::Integrated { system, .. } => systems.push(Some(*system)),
                Motion::Formula { .. } => {}
                Motion::Derived { from, .. } => {
                    let mut source = *from;
                    while let Motion::Derived { from, .. } = motion(source) {
                        source = *from;
                    }
                    computed |= matches!(motion(source), Motion::Integrated { .. });
                }
            }
        }
        if systems.is_empty() && computed {
            systems.push(None);
        }
        systems.sort_unstable();
        systems.dedup();
        systems
    }

    /// Whether a symbol of the file is an angle, which is continued along a motion.
    pub fn is_angle(&self, symbol: Symbol) -> bool {
        self.index.angles.contains(&symbol)
            || self.index.names.is_empty() && self.declared().any(|s| s.angle && s.symbol == symbol)
    }
}

impl Loader<'_> {
    /// Refuses claims that follow from themselves through others.
    pub fn circles(&mut self) {
        self.out.make_index();
        let claims = &self.out.claims;
        let premises: Vec<Vec<usize>> =
            claims.iter().map(|c| self.out.claims_among(&c.follows_from).collect()).collect();
        let mut found: Vec<(Range<usize>, String)> = Vec::new();
        // 0: not looked at, 1: on the present path, 2: done.
        let mut state = vec![0_u8; claims.len()];
        for start in 0..claims.len() {
            // The path with the next premise of each claim on it.
            let mut path: Vec<(usize, usize)> = Vec::new();
            if state[start] == 0 {
                state[start] = 1;
                path.push((start, 0));
            }
            while let Some((at, next)) = path.last_mut() {
                let Some(&premise) = premises[*at].get(*next) else {
                    state[*at] = 2;
                    path.pop();
                    continue;
                };
                *next += 1;
                match state[premise] {
                    0 => {
                        state[premise] = 1;
                        path.push((premise, 0));
                    }
                    1 => {
                        let first = path.iter().position(|(c, _)| *c == premise).unwrap_or(0);
                        let mut names: Vec<String> =
                            path[first..].iter().map(|(c, _)| format!("`{}`", claims[*c].name())).collect();
                        names.push(format!("`{}`", claims[premise].name()));
                        found.push((claims[premise].span.clone(), names.join(" from ")));
                    }
                    _ => {}
                }
            }
        }
        for (span, circle) in found {
            self.problems
                .note("derivation::circular-claim", span, format!("a claim follows from itself: {circle}"))
                .hint("`follows-from` leads back to what is given: leave out the step that the paper does not make");
        }
    }
}
