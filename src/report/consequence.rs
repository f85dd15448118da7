//! What hangs on a claim: which claims, and which conclusions of the paper, lose their ground if it falls.
//!
//! **In:** what the file says of each claim: what it follows from, what the paper's argument for it rests on, and whether it is
//! a conclusion. **Out:** for every claim what it carries, through all steps, and the order of their weight.
//!
//! A claim that falls takes away the ground of what rests on it; it does not make it false. Readings that were added to compare
//! are no part of the paper's argument, and carry nothing.

use std::collections::{BTreeMap, BTreeSet};

use super::digest::Whole;
use crate::derivation::{ClaimRole, Derivation};

/// Which claim rests on which, by ids of whole claims.
pub(super) struct Consequences<'a> {
    /// What rests directly on a claim.
    carried: BTreeMap<&'a str, BTreeSet<&'a str>>,
    /// The conclusions, in the order of the file.
    conclusions: Vec<&'a str>,
}

impl<'a> Consequences<'a> {
    /// What the file says.
    pub fn new(derivation: &'a Derivation) -> Consequences<'a> {
        let mut carried: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
        let mut conclusions: Vec<&str> = Vec::new();
        let id_of =
            |name: &str| derivation.claims.iter().find(|c| c.name() == name || c.id == name).map(|c| c.id.as_str());
        for claim in &derivation.claims {
            if claim.conclusion && !conclusions.contains(&claim.id.as_str()) {
                conclusions.push(&claim.id);
            }
            let argued = match claim.role {
                ClaimRole::Says | ClaimRole::MayMean | ClaimRole::Needs | ClaimRole::Lemma | ClaimRole::Choice => true,
                ClaimRole::Against | ClaimRole::Added => false,
            };
            let follows = claim.follows_from.iter().filter(|_| argued);
            for name in follows.chain(&claim.rests_on) {
                if let Some(from) = id_of(name).filter(|from| *from != claim.id) {
                    carried.entry(from).or_default().insert(&claim.id);
                }
            }
        }
        Consequences { carried, conclusions }
    }

    /// What rests directly on what: from, to.
    pub fn edges(&self) -> impl Iterator<Item = (&'a str, &'a str)> {
        self.carried.iter().flat_map(|(from, to)| to.iter().map(|to| (*from, *to)))
    }

    /// Everything that rests on a claim, directly or through others, in the order of the file.
    pub fn carried_by(&self, id: &str, wholes: &[Whole<'_>]) -> Vec<String> {
        let reached = self.reached(id);
        wholes.iter().map(|w| w.id).filter(|w| reached.contains(w)).map(str::to_owned).collect()
    }

    fn reached(&self, id: &str) -> BTreeSet<&'a str> {
        let mut seen: BTreeSet<&str> = BTreeSet::new();
        let mut open: Vec<&str> = self.carried.get(id).into_iter().flatten().copied().collect();
        while let Some(next) = open.pop() {
            if next != id && seen.insert(next) {
                open.extend(self.carried.get(next).into_iter().flatten());
            }
        }
        seen
    }

    /// The conclusions that rest on a claim, itself apart.
    pub fn conclusions_of(&self, id: &str) -> Vec<&'a str> {
        let reached = self.reached(id);
        self.conclusions.iter().copied().filter(|c| reached.contains(c)).collect()
    }

    /// All conclusions of the paper.
    pub fn conclusions(&self) -> &[&'a str] {
        &self.conclusions
    }

    /// How much falls with a claim: conclusions, itself among them, then claims. Larger is heavier.
    pub fn weight(&self, id: &str) -> (usize, usize) {
        let itself = usize::from(self.conclusions.contains(&id));
        (self.conclusions_of(id).len() + itself, self.reached(id).len())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chain() -> Consequences<'static> {
        // a carries b, b carries c and d, d is a conclusion; e stands alone, and is one, too.
        let carried = [("a", vec!["b"]), ("b", vec!["c", "d"]), ("d", vec!["b"])];
        Consequences {
            carried: carried.into_iter().map(|(k, v)| (k, v.into_iter().collect())).collect(),
            conclusions: vec!["d", "e"],
        }
    }

    #[test]
    fn what_falls_is_found_through_all_steps_and_circles_end() {
        let chain = chain();
        assert_eq!(chain.conclusions_of("a"), ["d"]);
        assert_eq!(chain.weight("a"), (1, 3));
        assert_eq!(chain.weight("b"), (1, 2));
        assert_eq!(chain.weight("c"), (0, 0));
        assert_eq!(chain.weight("e"), (1, 0));
        // In a circle a claim does not carry itself.
        assert_eq!(chain.weight("d"), (1, 2));
    }
}
