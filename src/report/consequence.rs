//! What hangs on a claim: which claims, and which conclusions of the paper, lose their ground if it falls.
//!
//! **In:** what the file says of each claim: what it follows from, what the paper's argument for it rests on, and whether it is
//! a conclusion. **Out:** for every claim what it carries, through all steps, and the order of their weight.
//!
//! A claim that falls takes away the ground of what rests on it; it does not make it false. Readings that were added to compare
//! are no part of the paper's argument, and carry nothing.

use std::collections::{BTreeMap, BTreeSet, VecDeque};

use derivation::{ClaimRole, Derivation};

/// Which claim rests on which. Claims are whole ones, by their positions in the order of the file.
#[derive(Default)]
pub(super) struct Consequences<'a> {
    ids: Vec<&'a str>,
    at: BTreeMap<&'a str, usize>,
    /// What rests directly on each claim.
    carried: Vec<BTreeSet<usize>>,
    /// What each claim rests on directly.
    grounds: Vec<Vec<usize>>,
    /// The conclusions, in the order of the file, and their positions.
    conclusions: Vec<&'a str>,
    concludes: BTreeSet<usize>,
}

/// So many conclusions are told of each claim.
const MOST_CONCLUSIONS: usize = 16;

/// So many claims that fall with another are counted, for all together take the square of a long chain.
const MOST_WEIGHED: usize = 300;

/// Conclusions that rest on a claim.
#[derive(Clone, Default)]
pub(super) struct Concluded<'a> {
    /// The first of them, in the order of the file.
    pub told: Vec<&'a str>,
    /// How many were found; not all, where they are more than are told.
    found: usize,
}

impl Concluded<'_> {
    /// Whether there are more than are told.
    pub fn has_more(&self) -> bool {
        self.found > self.told.len()
    }
}

impl<'a> Consequences<'a> {
    /// What the file says.
    pub fn new(derivation: &'a Derivation) -> Consequences<'a> {
        let mut out = Consequences::default();
        let mut named: BTreeMap<String, &str> = BTreeMap::new();
        for claim in &derivation.claims {
            out.add(&claim.id);
            named.entry(claim.id.clone()).or_insert(&claim.id);
            named.entry(claim.name()).or_insert(&claim.id);
            if claim.conclusion {
                out.conclude(&claim.id);
            }
        }
        for claim in &derivation.claims {
            let argued = match claim.role {
                ClaimRole::Says | ClaimRole::MayMean | ClaimRole::Needs | ClaimRole::Lemma | ClaimRole::Choice => true,
                ClaimRole::Against | ClaimRole::Added => false,
            };
            let follows = claim.follows_from.iter().filter(|_| argued);
            for from in follows.chain(&claim.rests_on).filter_map(|name| named.get(name.as_str())) {
                out.carry(from, &claim.id);
            }
        }
        out
    }

    /// The position of a claim, which is added where it is not there yet.
    fn add(&mut self, id: &'a str) -> usize {
        let at = *self.at.entry(id).or_insert(self.ids.len());
        if at == self.ids.len() {
            self.ids.push(id);
            self.carried.push(BTreeSet::new());
            self.grounds.push(Vec::new());
        }
        at
    }

    /// Takes down that a claim is a conclusion.
    fn conclude(&mut self, id: &'a str) {
        let at = self.add(id);
        if self.concludes.insert(at) {
            self.conclusions.push(id);
        }
    }

    /// Takes down that one claim rests on another.
    fn carry(&mut self, from: &'a str, to: &'a str) {
        let (from, to) = (self.add(from), self.add(to));
        if from != to && self.carried[from].insert(to) {
            self.grounds[to].push(from);
        }
    }

    fn names(&self, of: impl IntoIterator<Item = usize>) -> Vec<&'a str> {
        of.into_iter().map(|at| self.ids[at]).collect()
    }

    /// What rests directly on what, from and to, by the alphabet.
    pub fn edges(&self) -> impl Iterator<Item = (&'a str, &'a str)> {
        self.at.iter().flat_map(|(from, at)| {
            let to: BTreeSet<&str> = self.carried[*at].iter().map(|to| self.ids[*to]).collect();
            to.into_iter().map(|to| (*from, to))
        })
    }

    /// What rests on a claim directly, in the order of the file.
    pub fn directly_on(&self, id: &str) -> Vec<&'a str> {
        self.names(self.at.get(id).into_iter().flat_map(|at| self.carried[*at].iter().copied()))
    }

    /// Everything that rests on a claim, directly or through others, in the order of the file.
    pub fn carried_by(&self, id: &str) -> Vec<&'a str> {
        self.names(self.reached(id, usize::MAX, |at| self.carried[at].iter()))
    }

    /// Everything that a claim rests on, in the order of the file.
    pub fn grounds_of(&self, id: &str) -> Vec<&'a str> {
        self.names(self.reached(id, usize::MAX, |at| self.grounds[at].iter()))
    }

    /// What is reached from a claim, itself apart, the nearest first, up to so many. It takes what is reached, not what there is.
    fn reached<'s, I: Iterator<Item = &'s usize>>(
        &'s self,
        id: &str,
        most: usize,
        next: impl Fn(usize) -> I,
    ) -> BTreeSet<usize> {
        let mut seen = BTreeSet::new();
        let Some(&own) = self.at.get(id) else { return seen };
        let mut open: VecDeque<usize> = next(own).copied().collect();
        while let Some(at) = open.pop_front() {
            if seen.len() == most {
                break;
            }
            if at != own && seen.insert(at) {
                open.extend(next(at));
            }
        }
        seen
    }

    /// Everything that rests on one of these claims, in one walk: to ask for each of many takes the square of them.
    pub fn resting_on(&self, ids: impl IntoIterator<Item = &'a str>) -> BTreeSet<&'a str> {
        let own = ids.into_iter().filter_map(|id| self.at.get(id));
        let mut open: Vec<usize> = own.flat_map(|at| self.carried[*at].iter().copied()).collect();
        let mut seen = BTreeSet::new();
        while let Some(at) = open.pop() {
            if seen.insert(at) {
                open.extend(&self.carried[at]);
            }
        }
        self.names(seen).into_iter().collect()
    }

    /// How many claims a claim rests on, of the nearest [`MOST_WEIGHED`].
    pub fn length(&self, id: &str) -> usize {
        self.reached(id, MOST_WEIGHED, |at| self.grounds[at].iter()).len()
    }

    /// The conclusions that rest on a claim, itself apart.
    pub fn conclusions_of(&self, id: &str) -> Vec<&'a str> {
        let reached = self.reached(id, usize::MAX, |at| self.carried[at].iter());
        self.names(reached.intersection(&self.concludes).copied())
    }

    /// The first conclusions that rest on each claim, itself apart.
    ///
    /// From each conclusion it is looked at what it rests on. That goes no further from a claim of which enough are known: all that
    /// this rests on know them, too. (In a circle one of them may be itself, so it is two beyond those that are told.)
    pub fn concluded(&self) -> BTreeMap<&'a str, Concluded<'a>> {
        let mut out = vec![Concluded::default(); self.ids.len()];
        let mut seen = vec![None; self.ids.len()];
        for &conclusion in &self.conclusions {
            let own = self.at[conclusion];
            seen[own] = Some(own);
            let mut open = self.grounds[own].clone();
            while let Some(at) = open.pop() {
                let of: &mut Concluded<'a> = &mut out[at];
                if seen[at].replace(own) == Some(own) || of.found >= MOST_CONCLUSIONS + 2 {
                    continue;
                }
                of.found += 1;
                if of.told.len() < MOST_CONCLUSIONS {
                    of.told.push(conclusion);
                }
                open.extend(&self.grounds[at]);
            }
        }
        self.ids.iter().copied().zip(out).collect()
    }

    /// All conclusions of the paper.
    pub fn conclusions(&self) -> &[&'a str] {
        &self.conclusions
    }

    /// The letter of a conclusion, by which lines refer to it.
    pub fn letter(&self, id: &str) -> Option<char> {
        let at = self.conclusions.iter().position(|c| *c == id)?;
        char::from_u32(u32::from('A') + u32::try_from(at).ok()?)
    }

    /// What a claim rests on directly, in the order in which the file says it.
    pub fn direct_grounds(&self, id: &str) -> Vec<&'a str> {
        self.names(self.at.get(id).into_iter().flat_map(|at| self.grounds[*at].iter().copied()))
    }

    /// A shortest chain of steps that leads from a ground to what rests on it, both among them; empty where there is none.
    pub fn chain(&self, ground: &str, to: &str) -> Vec<&'a str> {
        let (Some(&from), Some(&to)) = (self.at.get(ground), self.at.get(to)) else { return Vec::new() };
        let mut next: Vec<Option<usize>> = vec![None; self.ids.len()];
        let mut open = VecDeque::from([to]);
        while let Some(at) = open.pop_front() {
            if at == from {
                let steps = std::iter::successors(Some(from), |at| next[*at].filter(|_| *at != to));
                return self.names(steps);
            }
            for &ground in &self.grounds[at] {
                if ground != to && next[ground].is_none() {
                    next[ground] = Some(at);
                    open.push_back(ground);
                }
            }
        }
        Vec::new()
    }

    /// How much falls with a claim: conclusions, itself among them, then claims, of the nearest [`MOST_WEIGHED`]. Larger is heavier.
    pub fn weight(&self, id: &str) -> (usize, usize) {
        let itself = self.at.get(id).is_some_and(|at| self.concludes.contains(at));
        let reached = self.reached(id, MOST_WEIGHED, |at| self.carried[at].iter());
        (reached.intersection(&self.concludes).count() + usize::from(itself), reached.len())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(carried: &[(&'static str, &'static str)], conclusions: Vec<&'static str>) -> Consequences<'static> {
        let mut out = Consequences::default();
        conclusions.into_iter().for_each(|id| out.conclude(id));
        for (from, to) in carried {
            out.carry(from, to);
        }
        out
    }

    fn chain() -> Consequences<'static> {
        // a carries b, b carries c and d, d is a conclusion; e stands alone, and is one, too.
        of(&[("a", "b"), ("b", "c"), ("b", "d"), ("d", "b")], vec!["d", "e"])
    }

    /// What is found from the conclusions is what is found from the claims.
    #[test]
    fn conclusions_are_found_from_both_ends() {
        let names: Vec<&'static str> = (0..60).map(|n| &*Box::leak(format!("c{n}").into_boxed_str())).collect();
        let step = |k: usize| move |n: usize| (n * k + n / 7 + 1) % 60;
        for (k, every) in [(1, 1), (3, 1), (7, 2), (11, 5), (13, 20)] {
            // Chains that branch, with circles.
            let carried: Vec<_> =
                (0..60).map(|n| (names[n], names[step(k)(n)])).chain([(names[0], names[9])]).collect();
            let all = of(&carried, names.iter().copied().step_by(every).collect());
            let concluded = all.concluded();
            for id in &names {
                let exact = all.conclusions_of(id);
                let found = &concluded[id];
                assert_eq!(found.told, exact[..exact.len().min(MOST_CONCLUSIONS)], "{id}, {k}, {every}");
                assert_eq!(found.has_more(), exact.len() > MOST_CONCLUSIONS, "{id}, {k}, {every}");
            }
        }
    }

    /// Of a long chain the nearest are counted, and claims are in their order all the same.
    #[test]
    fn what_falls_is_counted_up_to_a_bound() {
        let names: Vec<&'static str> = (0..1000).map(|n| &*Box::leak(format!("c{n}").into_boxed_str())).collect();
        let carried: Vec<_> = names.windows(2).map(|two| (two[0], two[1])).collect();
        let all = of(&carried, vec![names[200]]);
        assert_eq!(all.weight(names[0]), (1, MOST_WEIGHED));
        assert_eq!(all.weight(names[990]), (0, 9));
    }

    #[test]
    fn what_falls_is_found_through_all_steps_and_circles_end() {
        let chain = chain();
        assert_eq!(chain.conclusions_of("a"), ["d"]);
        assert_eq!(chain.weight("a"), (1, 3));
        assert_eq!(chain.weight("b"), (1, 2));
        assert_eq!(chain.weight("c"), (0, 0));
        assert_eq!(chain.weight("e"), (1, 0));
        assert_eq!(chain.chain("a", "d"), ["a", "b", "d"]);
        assert_eq!((chain.chain("a", "a"), chain.chain("c", "a")), (vec!["a"], vec![]));
        assert_eq!((chain.letter("d"), chain.letter("e"), chain.letter("a")), (Some('A'), Some('B'), None));
        // In a circle a claim does not carry itself.
        assert_eq!(chain.weight("d"), (1, 2));
    }
}
