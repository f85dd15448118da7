//! The families of a derivation: which claims are tried on them in a run, and what is found, put into the accounts of these claims.
//!
//! **In:** a derivation as it was read, what is chosen of it, and where it was counted elsewhere, the counts. **Out:** an account of each
//! claim on each family, and of each measure. **Guaranteed:** a family is compiled once ([`Ensemble`]); the members that are shown are those
//! that were counted, tried again.

use super::account::{Counted, Otherwise, Spreading};
use super::budget::Budget;
use super::ensemble::{Ensemble, One, cells, too_rare};
use super::member::{Member, Members};
use super::separate::{Checker, separations};
use crate::derivation::{Claim, Derivation, Measure};
use crate::findings::ClaimAccount;
use crate::findings::family::{Joined, MeasureAccount, Tally};
use crate::verdict::Outcome;
use claim::error::CheckError;
use claim::options::Options;
use std::collections::{BTreeMap, BTreeSet};
use std::hash::{BuildHasher, RandomState};

/// Whether a claim is tried on a family in this run.
fn is_chosen(options: &Options, claim: &Claim, id: &str) -> bool {
    let in_list = |list: &[String], id: &str| list.is_empty() || list.iter().any(|x| x == id);
    in_list(&options.claims, &claim.id) && in_list(&options.trajectories, id)
}

/// What is measured on the members of a family in this run. As on trajectories, nothing is where only some claims are asked for.
pub fn measured<'d>(derivation: &'d Derivation, at: usize, options: &Options) -> Vec<&'d Measure> {
    let of_family = derivation.measures.iter().filter(|m| m.families.contains(&at));
    let is_asked = || {
        let id = &derivation.families[at].id;
        options.claims.is_empty() && (options.trajectories.is_empty() || options.trajectories.contains(id))
    };
    of_family.filter(|_| is_asked()).collect()
}

/// So many members of a family that was counted elsewhere are tried here, beside those that its parts name: all, where it has no more.
const TRIED_AGAIN: u64 = 1000;

/// Members of a family: all of a small one. Of a large one some, by chance: what parts, the file and the program say tells nobody which, or
/// who makes a part up would change it until none of them tells. What is found does not depend on them, unless a part is not what it says.
fn picked(size: u64) -> BTreeSet<u64> {
    if size <= TRIED_AGAIN {
        return (1..=size).collect();
    }
    let chance = RandomState::new();
    (0..TRIED_AGAIN).map(|k| 1 + chance.hash_one(k) % size.max(1)).collect()
}

/// A member that was tried here and is not among those that were counted of the n-th claim: of its outcome there are more here than there,
/// or it comes before the first of them.
fn miscounted(tally: &Tally, n: usize, again: &BTreeMap<u64, One>) -> Option<u64> {
    let (mut holds, mut fails, mut not_applicable, mut undecided) = (0u64, 0u64, 0u64, 0u64);
    let is_before = |number: u64, first: Option<u64>| first.is_none_or(|first| number < first);
    again.iter().filter(|(_, one)| one.values.is_some()).find_map(|(&number, one)| {
        let (here, there, before) = match one.verdicts.get(n)?.outcome() {
            Outcome::Holds(_) => (&mut holds, tally.counts.holds, false),
            Outcome::Fails(_) => (&mut fails, tally.counts.fails, is_before(number, tally.first_failing)),
            Outcome::NotApplicable(_) => (&mut not_applicable, tally.counts.not_applicable, false),
            Outcome::Undecided => (&mut undecided, tally.counts.undecided, is_before(number, tally.first_undecided)),
        };
        *here += 1;
        (*here > there || before).then_some(number)
    })
}

/// A derivation whose claims name families, as it was read: what is found of the motions of the file is not in its graph yet.
pub struct Families {
    pub derivation: Derivation,
    pub(crate) members: Vec<Option<Members>>,
}

impl Families {
    /// The families of a derivation; `None` where no claim is tried on one.
    ///
    /// # Errors
    /// What is wrong with their numbers; a family without members.
    pub fn of(derivation: &Derivation, options: &Options) -> Result<Option<Families>, CheckError> {
        let mut problems = Vec::new();
        let mut members = Vec::new();
        for (at, family) in derivation.families.iter().enumerate() {
            let asked = |c: &Claim| c.families.contains(&at) && is_chosen(options, c, &family.id);
            if !derivation.claims.iter().any(asked) && measured(derivation, at, options).is_empty() {
                members.push(None);
                continue;
            }
            match Members::new(derivation, family) {
                Ok(of) => {
                    // What is drawn shows at once whether there is anything to draw.
                    if let Member::TooRare = of.member(1) {
                        problems.push(too_rare(derivation, &of, 1));
                    }
                    members.push(Some(of));
                }
                Err(found) => problems.extend(found),
            }
        }
        if !problems.is_empty() {
            return Err(CheckError::Problems(problems));
        }
        let any = members.iter().any(Option::is_some);
        Ok(any.then(|| Families { derivation: derivation.clone(), members }))
    }

    /// Tries the claims, and puts what is found into their accounts; returns what is measured. What was counted elsewhere is not tried
    /// here.
    ///
    /// # Errors
    /// Members that cannot be built, families without members, and defects of the program.
    pub fn try_all(
        &self,
        checker: &dyn Checker,
        options: &Options,
        claims: &mut [ClaimAccount],
        joined: Option<&Joined>,
        progress: &(dyn Fn(usize, usize) + Sync),
    ) -> Result<Vec<MeasureAccount>, CheckError> {
        let mut out = Vec::new();
        let mut budget = Budget::default();
        let told = |n: u64| usize::try_from(n).unwrap_or(usize::MAX);
        let all = self.members.iter().flatten().fold(0, |sum: u64, m| sum.saturating_add(m.family.size()));
        let mut before = 0u64;
        for (at, members) in self.members.iter().enumerate() {
            let Some(members) = members else { continue };
            // Members of all families are counted as one list.
            let so_far = told(before);
            let progress = |done: usize, _: usize| progress(so_far.saturating_add(done), told(all));
            before = before.saturating_add(members.family.size());
            let derivation = &self.derivation;
            let position = |a: &ClaimAccount| {
                let is_it = |c: &&Claim| c.id == a.id && c.reading == a.reading;
                derivation.claims.iter().find(is_it).filter(|c| c.families.contains(&at))
            };
            let of = |a: &ClaimAccount| position(a).filter(|c| is_chosen(options, c, &members.family.id));
            let (mut asked, mut places) = (Vec::new(), Vec::new());
            for (place, account) in claims.iter().enumerate() {
                if let Some(claim) = of(account) {
                    asked.push(claim);
                    places.push(place);
                }
            }
            let measures = measured(derivation, at, options);
            if asked.is_empty() && measures.is_empty() {
                continue;
            }
            let ensemble = Ensemble::new(derivation, members, &asked, &measures, &options.limits)?;
            let fits =
                |j: &&Joined| j.sums.tallies.len() == asked.len() && j.sums.distributions.len() == measures.len();
            let joined = joined.filter(|j| j.family == at).filter(fits);
            let (sums, stopped) = match joined {
                Some(joined) => (joined.sums.clone(), None),
                None => ensemble.try_all(1..=members.family.size(), options, &mut budget, &progress, &mut |_| {})?,
            };
            let tallies = &sums.tallies;
            if sums.is_empty() && stopped.is_none() {
                return Err(CheckError::Problems(vec![ensemble.empty()]));
            }
            let scales = members.scales();
            let boundaries = ensemble.boundaries(tallies, scales.as_ref(), options)?;
            // What was not tried might separate them otherwise.
            let separations = match stopped {
                Some(_) => vec![None; asked.len()],
                None => separations(checker, derivation, members, &asked, tallies, options)?,
            };
            let picked = joined.map_or_else(BTreeSet::new, |_| picked(members.family.size()));
            let again = ensemble.again(sums.kept().into_iter().chain(picked).collect())?;
            if joined.is_some() {
                let other = tallies.iter().enumerate().find_map(|(n, tally)| miscounted(tally, n, &again));
                other.map_or(Ok(()), |number| Err(ensemble.otherwise(Otherwise(number), true)))?;
            }
            let stopped = stopped.as_ref();
            for (place, (n, (tally, claim))) in places.into_iter().zip(tallies.iter().zip(&asked).enumerate()) {
                let expected = claim.families.iter().position(|f| *f == at).and_then(|i| claim.expect_of_families[i]);
                let (size, precision) = (members.family.size(), claim.precision);
                let law = members.law(claim);
                // A map of another size is none of this family.
                let sizes = (scales.as_ref().map_or(0, cells), law.as_ref().map_or(0, |l| l.scale.axis.cells.len()));
                if (tally.map.len(), tally.slopes.cells.len()) != sizes {
                    return Err(ensemble.otherwise(Otherwise(1), joined.is_some()));
                }
                let scales = scales.as_ref();
                let (boundary, separation) = (boundaries[n].as_ref(), separations[n].as_ref());
                let law = law.as_ref().map(|law| (&law.scale, law.power, law.to));
                let counted = Counted { size, precision, tally, scales, boundary, stopped, separation, law };
                let member = |number: u64| {
                    let one: &One = again.get(&number)?;
                    Some((one.values.as_deref()?, one.verdicts.get(n)?))
                };
                let account = counted.account(derivation, &members.family, expected, &member);
                claims[place].families.push(account.map_err(|other| ensemble.otherwise(other, joined.is_some()))?);
            }
            for (n, (measure, distribution)) in measures.iter().zip(&sums.distributions).enumerate() {
                let of = Spreading { measure, distribution, stopped };
                let member = |number: u64| {
                    let one: &One = again.get(&number)?;
                    Some((one.values.as_deref()?, one.measured.get(n)?.values.as_slice()))
                };
                let account = of.account(derivation, &members.family, &member);
                out.push(account.map_err(|other| ensemble.otherwise(other, joined.is_some()))?);
            }
        }
        Ok(out)
    }
}
