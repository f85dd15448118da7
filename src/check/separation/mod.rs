//! Under which condition a claim holds, and which of its assumptions it needs.
//!
//! **In:** the verdicts of every claim on every trajectory. **Out:** a [`ConditionsAccount`] for each claim: for one that holds
//! on some trajectories and fails on others, the weakest condition that is met exactly where it holds; for each assumption,
//! whether the claim fails without it.
//!
//! **How:** a condition is a claim of its own, and is judged on every trajectory as claims are; an assumption
//! is left out, and the claim is tried where it did not apply before. A condition that is undecided on a trajectory counts
//! there neither as met nor as unmet, and so can never separate anything. **Weakest** means: met on most of the trajectories at
//! hand, by inclusion. Trajectories are all the evidence that there is: what they cannot tell apart is said to be so.

mod account;
mod assumptions;
mod candidates;
mod explain;

pub use account::{AssumptionAccount, ConditionName, ConditionsAccount, Explanation, Join, Need, Rival, Separation};

use super::account::{Account, PairAccount};
use super::independence::Gradients;
use super::one_pair;
use super::program::Program;
use super::trial::{Course, Trial};
use super::verdict::{Outcome, Verdict};
use crate::derivation::{Claim, Derivation};
use crate::expr::Rational;
use assumptions::Dropped;
use candidates::Candidate;
use rayon::prelude::*;

/// What the ids of claims begin with that are made here: no id of a file can.
const PROBE: char = '~';

/// How a condition stands on every trajectory that was tried: met throughout, not met, or undecided.
type Truth = Vec<Option<bool>>;

/// Everything that may be asked once the verdicts are known: conditions, and claims without one of their assumptions.
///
/// It is compiled before the motions are built, and tried on the same samples of the same motions. It gets verdicts and
/// nothing else: no identities, no variants.
#[derive(Default)]
pub(super) struct Probes {
    candidates: Vec<Candidate>,
    dropped: Vec<Dropped>,
    /// One for each of the candidates, then of the others, and initial time.
    programs: Vec<Vec<Program>>,
}

impl Probes {
    /// Everything that may be asked of the claims at the positions `claimed` on the trajectories `tried`.
    pub fn new(derivation: &mut Derivation, claimed: &[usize], tried: &[usize], starts: &[Rational]) -> Probes {
        let several = |c: &usize| derivation.claims[*c].trajectories.iter().filter(|t| tried.contains(t)).count() > 1;
        // What is tried on one trajectory does not separate any.
        let may_split = claimed.iter().any(several);
        let candidates = if may_split { candidates::candidates(derivation) } else { Vec::new() };
        let dropped = assumptions::without_one(derivation, claimed);
        let own = derivation.claims.len();
        derivation.claims.extend(candidates.iter().map(|c| c.claim.clone()));
        derivation.claims.extend(dropped.iter().map(|d| d.claim.clone()));
        let programs = (own..derivation.claims.len())
            .map(|c| starts.iter().map(|s| Program::new(derivation, c, s)).collect())
            .collect();
        derivation.claims.truncate(own);
        Probes { candidates, dropped, programs }
    }

    /// Whether nothing can be asked.
    pub fn is_empty(&self) -> bool {
        self.programs.is_empty()
    }

    /// What is compiled.
    pub fn programs(&self) -> impl Iterator<Item = &Program> {
        self.programs.iter().flatten()
    }

    /// What is compiled, to be completed.
    pub fn programs_mut(&mut self) -> impl Iterator<Item = &mut Program> {
        self.programs.iter_mut().flatten()
    }

    /// What may be asked, with its programs, one for each initial time.
    pub fn asked(&self) -> impl Iterator<Item = (&Claim, &[Program])> {
        let claims = self.candidates.iter().map(|c| &c.claim).chain(self.dropped.iter().map(|d| &d.claim));
        claims.zip(self.programs.iter().map(Vec::as_slice))
    }

    /// Adds to every claim of an account what separates its trajectories, and which of its assumptions it needs.
    ///
    /// `gradients` belong to the claims of the account, `start_of` names the initial time of every trajectory; the courses are
    /// those of the trajectories of the account.
    pub fn separate(
        &self,
        derivation: &Derivation,
        gradients: &[Option<Result<Gradients, String>>],
        start_of: &[usize],
        courses: &mut [Course],
        account: &mut Account,
    ) {
        let split = account.claims.iter().any(explain::is_split);
        let open = |d: &Dropped, t: usize| {
            let whole = account.claims.get(d.of).filter(|c| assumptions::is_asked(c));
            whole.is_some_and(|c| assumptions::is_open(c, &derivation.trajectories[t].id, d.selects))
        };
        let count = self.candidates.len();
        let asked: Vec<(&Claim, &[Program])> = self.asked().collect();
        let on_one = |course: &mut Course| -> (String, Vec<Option<Verdict>>) {
            let t = course.trajectory;
            let verdict = |(k, (claim, programs)): (usize, &(&Claim, &[Program]))| {
                let dropped = k.checked_sub(count).and_then(|d| self.dropped.get(d));
                let wanted = dropped.map_or(split, |d| open(d, t));
                let program = programs.get(start_of[t]).filter(|_| wanted && claim.trajectories.contains(&t))?;
                let gradients = dropped.and_then(|d| gradients.get(d.of)).and_then(Option::as_ref);
                let trial = Trial { graph: &derivation.graph, claim, program, course };
                Some(one_pair(derivation, &trial, gradients))
            };
            (derivation.trajectories[t].id.clone(), asked.iter().enumerate().map(verdict).collect())
        };
        let columns: Vec<(String, Vec<Option<Verdict>>)> =
            courses.par_iter_mut().with_max_len(1).map(on_one).collect();

        let ids: Vec<String> = account.trajectories.iter().map(|t| t.id.clone()).collect();
        let truth = |k: usize| -> Truth {
            let on = |id: &String| columns.iter().find(|(of, _)| of == id)?.1.get(k)?.as_ref();
            let standing = |id: &String| match on(id)?.outcome() {
                // Times without a value are not times at which it is met.
                Outcome::Holds(_) => on(id)?.evidence().excluded.is_empty().then_some(true),
                Outcome::Fails(_) => Some(false),
                Outcome::NotApplicable | Outcome::Undecided => None,
            };
            ids.iter().map(standing).collect()
        };
        let judged: Vec<(&Candidate, Truth)> = self.candidates.iter().enumerate().map(|(k, c)| (c, truth(k))).collect();
        for claim in account.claims.iter_mut().filter(|c| explain::is_split(c)) {
            // A claim explains nothing about itself.
            let said =
                derivation.claims.iter().find(|c| c.id == claim.id && c.reading == claim.reading).map(candidates::said);
            let others: Vec<(&Candidate, &Truth)> =
                judged.iter().filter(|(c, _)| Some(candidates::said(&c.claim)) != said).map(|(c, t)| (*c, t)).collect();
            claim.conditions.separation = Some(explain::separation(claim, &ids, &others));
        }
        for (d, drop) in self.dropped.iter().enumerate() {
            let Some(claim) = account.claims.get_mut(drop.of).filter(|c| assumptions::is_asked(c)) else { continue };
            let pair = |(trajectory, verdicts): &(String, Vec<Option<Verdict>>)| {
                let verdict = verdicts.get(count + d)?.clone()?;
                Some(PairAccount { trajectory: trajectory.clone(), verdict, expected: None, discrimination: None })
            };
            let without: Vec<PairAccount> = columns.iter().filter_map(pair).collect();
            let need = assumptions::need(claim, &without, &drop.text);
            claim.conditions.assumptions.push(need);
        }
    }
}
