//! What a paper has said so far: definitions, equations that it states, signs of its names.
//!
//! **In:** relations, one by one, in the order of the paper. **Out:** for a step, the definitions of its names and of theirs, and
//! the equations that have to do with it. **Guaranteed:** nothing is taken from behind the step, but what a "where" explains; of a
//! name that is defined twice the later definition counts.

use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};

use paper::{PrintedSide, names};

use super::desk::Given;
use super::lone::unprimed;

/// Definitions that a step may need.
const MOST_GIVEN: usize = 14;
/// Equations beside definitions that a step may rest on.
const MOST_STATED: usize = 4;
/// Definitions of one name that are looked at, the latest of them.
const MOST_OF_A_NAME: usize = 50;
/// Relations behind an equation that may conclude from it with a factor less.
const NEXT: usize = 2;
/// Relations since something was said, beyond which it may be another thing that is meant.
pub const NEAR: usize = 25;

/// An equation that a paper states, and that is not proved from what stands before it.
#[derive(Clone, Debug)]
pub struct Stated {
    /// Its left side.
    pub left: PrintedSide,
    /// Its right side.
    pub right: PrintedSide,
    /// The relation that states it.
    pub relation: usize,
    /// The section in which it does.
    pub section: usize,
    /// The keys of its names.
    pub names: BTreeSet<String>,
    /// Whether it stands in the running text: it proves, and refutes nothing.
    pub in_text: bool,
}

/// How far back what was said is used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reach {
    /// Anywhere before: a step of a chain that is proved names the lines.
    Paper,
    /// Some relations back in this section: an equation that stands alone is one that is assumed, it may be, and what is far may be another problem.
    Near {
        /// The number of the section.
        section: usize,
        /// The relation from which is looked back.
        at: usize,
    },
    /// In this section, and near: what refutes must be sure to mean the same names.
    Here {
        /// The number of the section.
        section: usize,
        /// The relation from which is looked back.
        at: usize,
    },
}

impl Reach {
    fn reaches(self, given: &Given) -> bool {
        match self {
            Reach::Paper => true,
            Reach::Near { section, at } | Reach::Here { section, at } => {
                given.section == section && given.relation + NEAR >= at
            }
        }
    }
}

/// Definitions and rates, found by the names that they are of: a paper has thousands, and each relation asks.
#[derive(Clone, Debug, Default)]
pub struct Definitions {
    all: Vec<Given>,
    /// Those that hold still, in order.
    of: HashMap<String, Vec<usize>>,
    /// How many these are, and how many of them are rates.
    live: usize,
    rates: usize,
}

impl Definitions {
    /// The latest of a name, with their numbers, the last one last.
    fn numbered(&self, key: &str) -> impl DoubleEndedIterator<Item = (usize, &Given)> {
        let places = self.of.get(key).map_or(&[][..], |all| &all[all.len().saturating_sub(MOST_OF_A_NAME)..]);
        places.iter().filter_map(|at| Some((*at, self.all.get(*at)?)))
    }

    /// Those of a name, the latest last.
    pub fn of(&self, key: &str) -> impl DoubleEndedIterator<Item = &Given> {
        self.numbered(key).map(|(_, given)| given)
    }

    /// How many were said, whether they hold still or not.
    pub fn len(&self) -> usize {
        self.all.len()
    }

    /// Whether none holds.
    pub fn is_empty(&self) -> bool {
        self.live == 0
    }

    /// Whether one is a rate.
    pub fn has_rates(&self) -> bool {
        self.rates > 0
    }

    /// Adds one.
    pub fn push(&mut self, given: Given) {
        self.live += 1;
        self.rates += usize::from(given.is_rate);
        self.of.entry(given.key.clone()).or_default().push(self.all.len());
        self.all.push(given);
    }

    /// Takes back what was said after the first `length`.
    pub fn truncate(&mut self, length: usize) {
        while self.all.len() > length {
            let Some(given) = self.all.pop() else { return };
            // The last of all is the last of its name, if it holds still.
            let places = self.of.entry(given.key).or_default();
            if places.last() == Some(&self.all.len()) {
                places.pop();
                self.live -= 1;
                self.rates -= usize::from(given.is_rate);
            }
        }
    }

    /// Takes back the definitions, or the rates, of a name.
    pub fn forget(&mut self, key: &str, is_rate: bool) {
        let Some(places) = self.of.get_mut(key) else { return };
        let before = places.len();
        places.retain(|at| self.all.get(*at).is_some_and(|g| g.is_rate != is_rate));
        self.live -= before - places.len();
        self.rates -= if is_rate { before - places.len() } else { 0 };
    }
}

/// What was said so far.
#[derive(Clone, Debug, Default)]
pub struct Facts {
    /// Definitions and rates.
    pub given: Definitions,
    /// Equations that are not definitions.
    pub stated: Vec<Stated>,
    /// The names in these, by their sections.
    named: HashMap<usize, HashSet<String>>,
    /// Names that are positive, by the sections in which this is said.
    positive: HashMap<usize, BTreeSet<String>>,
}

impl Facts {
    /// Adds an equation.
    pub fn state(&mut self, one: Stated) {
        self.named.entry(one.section).or_default().extend(one.names.iter().cloned());
        self.stated.push(one);
    }

    /// Whether an equation in a section has a name in it.
    pub fn is_stated(&self, section: usize, key: &str) -> bool {
        self.named.get(&section).is_some_and(|all| all.contains(key))
    }

    /// The equations that a relation states.
    fn stated_by(&self, relation: usize) -> &[Stated] {
        let from = self.stated.partition_point(|s| s.relation < relation);
        let to = self.stated.partition_point(|s| s.relation <= relation);
        &self.stated[from..to]
    }

    /// Adds names that are positive.
    pub fn be_positive(&mut self, section: usize, keys: Vec<String>) {
        self.positive.entry(section).or_default().extend(keys);
    }

    /// The names that are positive in a section.
    pub fn positive(&self, section: usize) -> BTreeSet<String> {
        self.positive.get(&section).cloned().unwrap_or_default()
    }

    /// The definitions that some sides need: of their names, and of the names of these; and their rates, where these are wanted.
    pub fn definitions(&self, sides: &[&PrintedSide], reach: Reach, rates: bool) -> Vec<Given> {
        // What has a prime may be a derivative.
        let own = sides.iter().flat_map(|s| names(s));
        let mut wanted: Vec<String> = own.flat_map(|n| [n.key(), unprimed(&n).key()]).collect();
        wanted.dedup();
        let mut found: BTreeMap<usize, Given> = BTreeMap::new();
        let mut at = 0;
        while let Some(key) = wanted.get(at).cloned() {
            at += 1;
            for is_rate in [false, true] {
                let fits = |g: &Given| g.is_rate == is_rate && (!is_rate || rates) && reach.reaches(g);
                if let Some((k, given)) = self.given.numbered(&key).rev().find(|(_, g)| fits(g))
                    && found.len() < MOST_GIVEN
                    && found.insert(k, given.clone()).is_none()
                {
                    wanted.extend(names(&given.right).iter().map(|n| n.key()));
                }
            }
        }
        in_order(found.into_values().collect())
    }

    /// The equations that have to do with a step, the nearest first: those of the `named` relations, and those with a name that stands
    /// on one side of the step only, and with none that is foreign to it; a conclusion may come from two with the same foreign name.
    pub fn equations(
        &self,
        sides: [&PrintedSide; 2],
        given: &[Given],
        at: usize,
        section: usize,
        named: &[usize],
        eliminates: bool,
    ) -> Vec<Stated> {
        let own = sides.map(|s| closure(s, given));
        let apart: BTreeSet<&String> = own[0].symmetric_difference(&own[1]).collect();
        let all: BTreeSet<&String> = own[0].union(&own[1]).collect();
        // What is said again proves nothing.
        let prints = sides.map(PrintedSide::print);
        let again = |s: &Stated| [s.left.print(), s.right.print()] == prints;
        let near = |s: &&Stated| s.section == section && s.relation != at;
        // They are in the order of the paper.
        let latest = || self.stated.iter().rev().take_while(|s| s.relation + NEAR >= at).filter(near);
        let foreign = |s: &Stated| s.names.iter().filter(|n| !all.contains(n)).cloned().collect::<Vec<_>>();
        // What two equations have in common, and the step has not, is eliminated.
        let mut between: BTreeMap<String, usize> = BTreeMap::new();
        for one in latest().filter(|_| eliminates) {
            // A quotient of two, `\omega^2=k/m`, is eliminated right behind where it is said.
            let names = foreign(one);
            if names.len() == 1 || names.len() == 2 && one.relation + 2 * NEXT >= at {
                names.into_iter().for_each(|name| *between.entry(name).or_insert(0) += 1);
            }
        }
        let is_known = |n: &String| all.contains(n) || between.get(n).is_some_and(|count| *count > 1);
        // What stands on both sides of the equation right before a conclusion may be divided by.
        let cancels = |s: &Stated, n: &String| {
            let has = |side: &PrintedSide| names(side).iter().any(|name| name.key() == *n);
            eliminates && s.relation + NEXT >= at && has(&s.left) && has(&s.right)
        };
        let fits = |s: &&Stated| {
            let touches = s.names.iter().any(|n| apart.contains(n) || between.get(n).is_some_and(|count| *count > 1));
            (touches || apart.is_empty() && s.names.len() > 1) && s.names.iter().all(|n| is_known(n) || cancels(s, n))
        };
        let mut out: Vec<Stated> = Vec::new();
        let chosen = named.iter().rev().flat_map(|&k| self.stated_by(k).iter().rev()).filter(|s| s.relation != at);
        for one in chosen.chain(latest().filter(fits)) {
            let known = |o: &Stated| o.relation == one.relation && o.left.span == one.left.span;
            if out.len() < MOST_STATED && !out.iter().any(known) && !again(one) {
                out.push(one.clone());
            }
        }
        out
    }
}

/// The keys of a side, and of what its names are defined by.
fn closure(side: &PrintedSide, given: &[Given]) -> BTreeSet<String> {
    let mut out: BTreeSet<String> = names(side).iter().map(|n| n.key()).collect();
    for _ in 0..given.len() {
        let more: Vec<String> = given
            .iter()
            .filter(|g| !g.is_rate && out.contains(&g.key))
            .flat_map(|g| names(&g.right))
            .map(|n| n.key())
            .collect();
        out.extend(more);
    }
    out
}

/// Definitions in an order in which each stands behind those that it needs; those that need each other are left out.
fn in_order(given: Vec<Given>) -> Vec<Given> {
    let (rates, mut rest): (Vec<Given>, Vec<Given>) = given.into_iter().partition(|g| g.is_rate);
    let mut out: Vec<Given> = Vec::new();
    while !rest.is_empty() {
        let keys: BTreeSet<String> = rest.iter().map(|g| g.key.clone()).collect();
        let ready = |g: &Given| !names(&g.right).iter().any(|n| keys.contains(&n.key()));
        let (now, later): (Vec<Given>, Vec<Given>) = rest.into_iter().partition(ready);
        if now.is_empty() {
            break;
        }
        out.extend(now);
        rest = later;
    }
    out.extend(rates);
    out
}
