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

mod ask;
mod assumptions;
mod candidates;
mod explain;

pub use crate::findings::conditions::{
    AssumptionAccount, ConditionName, ConditionsAccount, Explanation, Join, Need, Rival, Separation,
};

use std::collections::BTreeSet;

use crate::derivation::{Claim, Derivation};
use crate::expr::{Graph, Rational};
use crate::findings::{Account, PairAccount};
use crate::verdict::Verdict;
use ask::{Ask, Sides};
use assumptions::Dropped;
use candidates::Candidate;
use claim::program::Program;
use meter::Limits;
use sampled::claim_program::Prepared;
use sampled::recall::Recall;
use sampled::selection::Selection;
use sampled::trace::{Trace, Trial};
use sampled::trial::try_claim;
use std::sync::atomic::{AtomicBool, Ordering};

/// How a condition stands on every trajectory that was tried: met throughout, not met, or undecided.
type Truth = Vec<Option<bool>>;

/// Conditions by their names, each as the claim that it is met at every time; `None` for one that the file does not give rise to.
pub fn as_claims(derivation: &Derivation, graph: &mut Graph, names: &[ConditionName]) -> Vec<Option<Claim>> {
    let all = candidates::candidates(derivation, graph);
    let is_it = |known: &ConditionName, name: &ConditionName| {
        (&known.id, &known.formula, &known.says) == (&name.id, &name.formula, &name.says)
    };
    names.iter().map(|name| all.iter().find(|c| is_it(&c.name, name)).map(|c| c.claim.clone())).collect()
}

/// Everything that may be asked once the verdicts are known: conditions, and claims without one of their assumptions.
///
/// It is compiled before the motions are built, and tried on the same samples of the same motions. It gets verdicts and
/// nothing else: no identities, no variants.
#[derive(Default)]
pub struct Probes {
    candidates: Vec<Candidate>,
    dropped: Vec<Dropped>,
    /// One for each of the candidates, then of the others, and initial time.
    programs: Vec<Vec<Program>>,
}

/// One motion, with what is known of it.
pub struct OneMotion<'a> {
    /// The claims that are checked.
    pub prepared: &'a [Vec<Prepared<'a>>],
    /// The position of its initial time.
    pub start: usize,
    pub trace: &'a Trace<'a>,
    /// The verdicts of the claims.
    pub verdicts: &'a [Option<Verdict>],
    /// Which claims have failed, on this motion or another.
    pub failed: &'a [AtomicBool],
}

/// The motions of an account, in its order.
pub struct Motions<'a> {
    /// What [`Probes::without_each`] found on each.
    pub without: &'a [Vec<Option<Verdict>>],
    pub traces: &'a [Trace<'a>],
    /// For each trajectory of the file the position of its initial time.
    pub start_of: &'a [usize],
}

impl Probes {
    /// Everything that may be asked of the chosen claims, in a graph that begins as that of the file.
    pub fn new(derivation: &Derivation, graph: &mut Graph, selection: &Selection) -> Probes {
        let on =
            |c: usize| derivation.claims[c].trajectories.iter().filter(|t| selection.tried.binary_search(t).is_ok());
        // What is tried on one trajectory does not separate any.
        let may_split = selection.claims.iter().any(|&c| on(c).count() > 1);
        let candidates = if may_split { candidates::candidates(derivation, graph) } else { Vec::new() };
        let dropped = assumptions::without_one(derivation, &selection.claims);
        let conditions = candidates.iter().map(|c| (&c.claim, true));
        let mut compiled = |(claim, tells_apart): (&Claim, bool)| -> Vec<Program> {
            let one = |(start, shared): (&Rational, &Vec<_>)| {
                let mut program = Program::new(graph, derivation.into(), claim, start).sharing(shared);
                program.tells_apart = tells_apart;
                program
            };
            selection.starts.iter().zip(&selection.shared).map(one).collect()
        };
        let programs = conditions.chain(dropped.iter().map(|d| (&d.claim, false))).map(&mut compiled).collect();
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

    /// What is compiled of a claim without its assumptions, by its position among those that are checked.
    pub fn without(&self, of: usize) -> impl Iterator<Item = &Program> {
        let programs = self.programs.get(self.candidates.len()..).unwrap_or_default();
        self.dropped.iter().zip(programs).filter(move |(d, _)| d.of == of).flat_map(|(_, programs)| programs)
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

    /// The verdicts on one motion of the claims without each of their assumptions, where these may be another than those with
    /// them. A claim that has failed is not asked: see [`Probes::separate`]. What is known from before is not tried again.
    pub fn without_each(
        &self,
        derivation: &Derivation,
        motion: &OneMotion,
        recall: &dyn Recall,
    ) -> Vec<Option<Verdict>> {
        let &OneMotion { prepared, start, trace, verdicts, failed } = motion;
        let t = trace.trajectory;
        let count = self.candidates.len();
        let verdict = |(d, dropped): (usize, &Dropped)| {
            let known = verdicts.get(dropped.of)?.as_ref()?;
            let wanted =
                assumptions::is_open(known, dropped.selects) && dropped.claim.trajectories.binary_search(&t).is_ok();
            let fails = failed.get(dropped.of).is_some_and(|f| f.load(Ordering::Relaxed));
            let program = self.programs.get(count + d)?.get(start).filter(|_| wanted && !fails)?;
            let gradients = prepared.get(dropped.of)?.get(start)?.gradients.as_ref();
            let trial = Trial { graph: &derivation.graph, claim: &dropped.claim, program, trace, shown: false };
            let asked = (&dropped.claim, dropped.whole.as_str(), dropped.place);
            Some(recall.without(derivation, asked, t, &|| try_claim(derivation, &trial, gradients)))
        };
        self.dropped.iter().enumerate().map(verdict).collect()
    }

    /// The same where nothing was tried.
    pub fn without_none(&self) -> Vec<Option<Verdict>> {
        self.dropped.iter().map(|_| None).collect()
    }

    /// The leaves of conditions, by their positions in a point: what is asked once all verdicts are known.
    pub fn asked_later(&self) -> impl Iterator<Item = usize> + '_ {
        let programs = self.programs.get(..self.candidates.len()).unwrap_or_default();
        programs.iter().flatten().flat_map(|p| p.inputs().iter().copied())
    }

    /// Adds to every claim of an account what separates its trajectories, and which of its assumptions it needs. Only claims that fail
    /// nowhere are asked what they need.
    pub fn separate(
        &self,
        derivation: &Derivation,
        motions: &Motions,
        recall: &dyn Recall,
        limits: &Limits,
        account: &mut Account,
    ) {
        let &Motions { without, traces, start_of } = motions;
        if account.claims.iter().any(explain::is_split) {
            self.explain(derivation, (start_of, limits), recall, traces, account);
        }
        for (d, drop) in self.dropped.iter().enumerate() {
            let Some(claim) = account.claims.get_mut(drop.of).filter(|c| assumptions::is_asked(c)) else { continue };
            let pair = |(trace, verdicts): (&Trace, &Vec<Option<Verdict>>)| {
                let (trajectory, verdict) = (&derivation.trajectories[trace.trajectory].id, verdicts.get(d)?.clone()?);
                Some(PairAccount { trajectory: trajectory.clone(), verdict, expected: None, discrimination: None })
            };
            let without: Vec<PairAccount> = traces.iter().zip(without).filter_map(pair).collect();
            let need = assumptions::need(claim, &without, &drop.text);
            claim.conditions.assumptions.push(need);
        }
    }

    /// Adds to every claim that holds on some trajectories and fails on others what separates them.
    fn explain(
        &self,
        derivation: &Derivation,
        (start_of, limits): (&[usize], &Limits),
        recall: &dyn Recall,
        traces: &[Trace],
        account: &mut Account,
    ) {
        let programs = self.programs.get(..self.candidates.len()).unwrap_or_default();
        let ask = Ask { derivation, candidates: &self.candidates, programs, start_of, recall, limits };
        let ids: Vec<String> = traces.iter().map(|c| derivation.trajectories[c.trajectory].id.clone()).collect();
        let split: Vec<usize> = (0..account.claims.len()).filter(|&k| explain::is_split(&account.claims[k])).collect();
        let sides: Vec<Sides> = split.iter().map(|&k| explain::sides(&account.claims[k], &ids)).collect();
        let all = || 0..self.candidates.len();
        let mut stands = ask.first(traces);
        ask.known(&mut stands, traces, account);
        // Those of the file may be used the other way round, too.
        let from_file = |k: &usize| self.candidates[*k].name.id.is_some();
        let mut asked: BTreeSet<(usize, usize)> = all().filter(from_file).flat_map(|k| stands.left(k)).collect();
        loop {
            for sides in &sides {
                asked.extend(all().flat_map(|k| stands.asked(k, sides)));
            }
            if asked.is_empty() {
                break;
            }
            ask.judge(&mut stands, &asked, traces);
            asked.clear();
        }
        // What may explain a claim is compared on all other motions, too: which is the weakest, and where they differ.
        for sides in &sides {
            asked.extend(all().filter(|&k| stands.may_explain(k, sides)).flat_map(|k| stands.left(k)));
        }
        ask.judge(&mut stands, &asked, traces);
        let judged: Vec<(&Candidate, Truth)> = all().map(|k| (&self.candidates[k], stands.truth(k))).collect();
        for (&at, sides) in split.iter().zip(&sides) {
            let claim = &mut account.claims[at];
            // A claim explains nothing about itself, and neither does a part of it.
            let same = |c: &&derivation::Claim| c.id == claim.id && c.reading == claim.reading;
            let said = |c: &derivation::Claim| candidates::said(&derivation.graph, c);
            let own = derivation.claims.iter().find(same).map(said).unwrap_or_default();
            if all().filter(from_file).any(|k| !own.is_empty() && said(&self.candidates[k].claim) == own) {
                // It is a condition of the file itself: where it holds is what it says.
                continue;
            }
            let on: Vec<&Trace> =
                sides.holds.iter().chain(&sides.fails).filter_map(|&column| traces.get(column)).collect();
            let others = all().filter(|&k| {
                let condition = said(&self.candidates[k].claim);
                let is_part = !condition.is_empty() && condition.iter().all(|part| own.contains(part));
                !is_part && !candidates::is_alike(&derivation.graph, (&condition, &own), &on)
            });
            let others: Vec<usize> = others.collect();
            let may = |k: &&usize| from_file(k) || stands.may_explain(**k, sides);
            let useful: Vec<(&Candidate, &Truth)> =
                others.iter().filter(may).map(|&k| (judged[k].0, &judged[k].1)).collect();
            claim.conditions.separation = Some(explain::separation(claim, &ids, &useful, others.len()));
        }
    }
}
