//! What is counted of a family: a tally for each claim, a distribution for each measure.
//!
//! **Guaranteed:** both are sums over members, in any order, so this is, too.

use std::collections::BTreeSet;

use super::distribution::Distribution;
use super::tally::Tally;

/// What is counted of all claims and measures.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sums {
    /// Of each claim.
    pub tallies: Vec<Tally>,
    /// Of each measure.
    pub distributions: Vec<Distribution>,
}

impl Sums {
    /// The numbers of the members that are kept.
    pub fn kept(&self) -> BTreeSet<u64> {
        let of_claims = self.tallies.iter().flat_map(Tally::kept);
        of_claims.chain(self.distributions.iter().flat_map(Distribution::kept)).collect()
    }

    /// Whether no member was tried.
    pub fn is_empty(&self) -> bool {
        let tried = self.tallies.iter().map(|t| t.counts.members).chain(self.distributions.iter().map(|d| d.members));
        tried.max() == Some(0)
    }

    /// Adds what was counted elsewhere.
    pub fn join<'a>(
        &mut self,
        tallies: impl ExactSizeIterator<Item = &'a Tally>,
        distributions: impl ExactSizeIterator<Item = &'a Distribution>,
    ) {
        self.tallies.resize(tallies.len(), Tally::default());
        self.distributions.resize(distributions.len(), Distribution::default());
        self.tallies.iter_mut().zip(tallies).for_each(|(here, there)| here.join(there));
        self.distributions.iter_mut().zip(distributions).for_each(|(here, there)| here.join(there));
    }
}
