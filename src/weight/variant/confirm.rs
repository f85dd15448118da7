//! Which candidates hold on every motion on which the print should have, and how strongly.
//!
//! **In:** formulas that pass at a few points. **Out:** corrections, written into the accounts, the closest to the print first.
//!
//! Each candidate is a claim of its own, read from what is printed of it: what is offered means what it shows. It is tried on the motions
//! of the check as any claim is, and enclosed where that is asked of the claims of the file, too: what an enclosure does not leave
//! standing is not offered.

use super::erratum::{Candidate, MOST_OFFERED, Search, as_claim, is_inequality};
use crate::derivation::{Claim, Derivation};
use crate::expr::Rational;
use crate::findings::standing::Decision;
use crate::findings::{ClaimAccount, Correction};
use crate::verdict::{Outcome, Strength, Verdict};
use claim::error::CheckError;
use claim::program::Program;
use meter::{Ended, Limits, Task};
use proved::step::Step;
use sampled::claim_program::Prepared;
use sampled::trace::{Trace, Trial};
use sampled::trial::try_claim;

/// Strengthens the verdicts that samples gave of claims beside those of the file.
pub trait Encloses: Sync {
    /// One claim, compiled for each initial time, and its verdicts, each with the position of its trajectory in the file. `derivation` is
    /// the file with a graph that has all that the claims say.
    fn enclose(&self, derivation: &Derivation, claims: Vec<Beside>) -> Vec<Vec<Verdict>>;
}

/// A claim that the file does not make, with what samples say of it.
pub struct Beside<'a> {
    /// The claim, compiled for each initial time.
    pub prepared: Vec<Prepared<'a>>,
    /// Positions of trajectories in the file, each with the verdict.
    pub verdicts: Vec<(usize, Verdict)>,
}

/// A candidate that was read again.
struct Read {
    candidate: Candidate,
    claim: Claim,
    /// One for each initial time.
    programs: Vec<Program>,
    /// Of each motion on which it must hold: its column, and the verdict; none where it was not tried.
    verdicts: Vec<(usize, Option<Verdict>)>,
}

impl Read {
    /// The weakest strength with which it holds on the motions; none where it does not hold on all.
    fn holds(&self) -> Option<Strength> {
        let strength = |verdict: &Option<Verdict>| match verdict.as_ref()?.outcome() {
            Outcome::Holds(strength) => Some(strength),
            Outcome::Fails(_) | Outcome::NotApplicable(_) | Outcome::Undecided => None,
        };
        let all: Option<Vec<Strength>> = self.verdicts.iter().map(|(_, verdict)| strength(verdict)).collect();
        all?.into_iter().min()
    }
}

impl Search<'_> {
    /// Tries the candidates on the motions of the check, and writes those that hold everywhere into the accounts. `motions` are the columns
    /// on which those of each claim must hold.
    pub(super) fn confirm(
        &self,
        accounts: &mut [ClaimAccount],
        candidates: Vec<Candidate>,
        motions: &[Vec<usize>],
        traces: &[Trace],
    ) -> Result<(), CheckError> {
        let mut grown = self.derivation.clone();
        let mut held = self.read(&mut grown, candidates, motions);
        self.sample(&grown, &mut held, traces);
        held.retain(|of| of.holds().is_some());
        // What is refuted makes room for others, which nothing was asked yet.
        let (mut strengths, mut enclosed) = (vec![None; held.len()], vec![false; held.len()]);
        loop {
            let shown = may_be_offered(&held.iter().map(|of| &of.candidate).collect::<Vec<_>>());
            let asked: Vec<usize> = (0..held.len()).filter(|&n| shown[n] && !enclosed[n]).collect();
            if asked.is_empty() {
                break;
            }
            asked.iter().for_each(|&n| enclosed[n] = true);
            let claims: Vec<&Claim> = asked.iter().map(|&n| &held[n].claim).collect();
            let decided = self.decided(&grown, &claims)?;
            // What is proved without an exception is so on every motion.
            let open: Vec<usize> =
                asked.iter().zip(&decided).filter(|(_, d)| **d != Decision::Proved).map(|(&n, _)| n).collect();
            self.enclose(&grown, &mut held, &open);
            for (&n, decided) in asked.iter().zip(decided) {
                let proved = [Decision::Proved, Decision::ProvedExcept].contains(&decided);
                strengths[n] = held[n].holds().map(|found| if proved { Strength::Proved } else { found });
            }
            let stands: Vec<bool> = held.iter().map(|of| of.holds().is_some()).collect();
            retain(&mut strengths, &stands);
            retain(&mut enclosed, &stands);
            retain(&mut held, &stands);
        }
        let held: Vec<(Read, Strength)> =
            held.into_iter().zip(strengths).filter_map(|(of, s)| Some((of, s?))).collect();
        self.write(accounts, held);
        Ok(())
    }

    /// The candidates as claims of their own, in a graph that grows.
    fn read(&self, grown: &mut Derivation, candidates: Vec<Candidate>, motions: &[Vec<usize>]) -> Vec<Read> {
        let mut out = Vec::new();
        for (n, candidate) in candidates.into_iter().enumerate() {
            if candidate.text.split_once('=').is_some_and(|(left, right)| left.trim() == right.trim()) {
                continue;
            }
            let columns = &motions[candidate.claim];
            let trajectories: Vec<usize> = columns.iter().map(|&t| self.selection.tried[t]).collect();
            let claim = &self.derivation.claims[self.selection.claims[candidate.claim]];
            let manner = self.altered.claims[candidate.claim].formulas[candidate.formula].manner;
            let id = format!("correction {n}");
            let claim = as_claim(&mut grown.graph, claim, &id, &candidate, manner, trajectories);
            let Some(claim) = claim.filter(|_| !columns.is_empty()) else { continue };
            let (graph, derivation) = (&mut grown.graph, self.derivation);
            let starts = self.selection.starts.iter().zip(&self.selection.shared);
            let program =
                |(s, shared): (&Rational, &Vec<_>)| Program::new(graph, derivation.into(), &claim, s).sharing(shared);
            let mut programs: Vec<Program> = starts.map(program).collect();
            if programs.iter_mut().all(|p| p.compile(graph, &self.altered.known).is_ok()) {
                let verdicts = columns.iter().map(|&t| (t, None)).collect();
                out.push(Read { candidate, claim, programs, verdicts });
            }
        }
        out
    }

    /// Tries candidates at samples.
    fn sample(&self, grown: &Derivation, all: &mut [Read], traces: &[Trace]) {
        let start = |t: usize| self.selection.start_of[self.selection.tried[t]];
        let on_one = |&t: &usize, limits: &Limits| -> Vec<Option<Verdict>> {
            let here = |of: &&Read| of.verdicts.iter().any(|(column, _)| *column == t);
            let asked = || all.iter().filter(here);
            let try_all = || {
                let inputs = asked().filter_map(|of| of.programs.get(start(t))).flat_map(Program::inputs);
                let trace = &traces[t].again(inputs.copied().collect());
                let tried = |of: &Read| {
                    let program = of.programs.get(start(t))?;
                    let trial = Trial { graph: &grown.graph, claim: &of.claim, program, trace, shown: false };
                    Some(try_claim(grown, &trial, None))
                };
                asked().map(tried).collect()
            };
            // What was not tried on a motion on which it must hold is not offered.
            meter::piece(Task::Weighing, limits, try_all).unwrap_or_else(|_| asked().map(|_| None).collect())
        };
        let columns: Vec<usize> = (0..traces.len()).collect();
        let found = meter::each(self.limits, &columns, on_one);
        let mut found: Vec<_> = found.into_iter().map(Vec::into_iter).collect();
        for (t, verdict) in all.iter_mut().flat_map(|of| &mut of.verdicts) {
            *verdict = found.get_mut(*t).and_then(Iterator::next).flatten();
        }
    }

    /// Encloses some of the candidates, where that is asked.
    fn enclose(&self, grown: &Derivation, held: &mut [Read], asked: &[usize]) {
        let Some(encloses) = self.encloses.filter(|_| !asked.is_empty()) else { return };
        let beside = |&n: &usize| {
            let Read { claim, programs, verdicts, .. } = &held[n];
            let one = |program: &Program| Prepared { claim, program: program.clone(), gradients: None };
            let verdict = |(t, verdict): &(usize, Option<Verdict>)| Some((self.selection.tried[*t], verdict.clone()?));
            Beside {
                prepared: programs.iter().map(one).collect(),
                verdicts: verdicts.iter().filter_map(verdict).collect(),
            }
        };
        let found = encloses.enclose(grown, asked.iter().map(beside).collect());
        for (&n, verdicts) in asked.iter().zip(found) {
            for ((_, verdict), stronger) in held[n].verdicts.iter_mut().zip(verdicts) {
                *verdict = Some(stronger);
            }
        }
    }

    /// What some claims come to for all values. All that is wanted is whether there is a proof: no assumption that it could do without, and no
    /// point where there is none.
    fn decided(&self, grown: &Derivation, claims: &[&Claim]) -> Result<Vec<Decision>, CheckError> {
        let decided = |claim: &&Claim, limits: &Limits| {
            let step =
                || Step::of(grown, claim).and_then(|step| step.with(true).with_few_points().decide()).transpose();
            match meter::piece(Task::Proving, limits, step) {
                Ok(Ok(identity)) => Ok(identity.map_or(Decision::Undecided, |i| {
                    proved::replay::replayed(grown, claim, i, limits, &|_, find| find()).finding.decision()
                })),
                Ok(Err(defect)) | Err(Ended::Defect(defect)) => Err(CheckError::Defect(defect)),
                Err(_) => Ok(Decision::Undecided),
            }
        };
        meter::each(self.limits, claims, decided).into_iter().collect()
    }

    /// Writes what holds into the accounts; where nothing does, why.
    fn write(&self, accounts: &mut [ClaimAccount], mut held: Vec<(Read, Strength)>) {
        held.sort_by(|(a, x), (b, y)| {
            let (a, b) = (&a.candidate, &b.candidate);
            let (x, y) = (*x == Strength::Proved, *y == Strength::Proved);
            (a.claim, a.formula).cmp(&(b.claim, b.formula)).then_with(|| a.nearness.than(x, &b.nearness, y))
        });
        for (Read { candidate, verdicts, .. }, strength) in held {
            let printed = &self.altered.claims[candidate.claim].formulas[candidate.formula].text;
            let correction = Correction {
                printed: printed.clone(),
                formula: candidate.text,
                difference: candidate.difference,
                classes: candidate.classes,
                strength,
                holds_on: verdicts.len(),
            };
            let erratum = accounts[candidate.claim].variants.as_mut().and_then(|v| v.erratum.as_mut());
            if let Some(erratum) = erratum.filter(|e| e.corrections.len() < MOST_OFFERED) {
                erratum.corrections.push(correction);
            }
        }
        for (k, account) in accounts.iter_mut().enumerate() {
            let Some(erratum) = account.variants.as_mut().and_then(|v| v.erratum.as_mut()) else { continue };
            if erratum.corrections.is_empty() && erratum.remark.is_none() {
                let formulas = &self.altered.claims[k].formulas;
                erratum.remark = Some(match formulas.is_empty() {
                    true => "the claim has no formula that could be altered".to_owned(),
                    false if formulas.iter().all(is_inequality) => {
                        "inequalities are not corrected: near any print there are some that hold".to_owned()
                    }
                    false => {
                        "of the altered formulas that were tried none holds on all motions to which the claim applies"
                            .to_owned()
                    }
                });
            }
        }
    }
}

/// Keeps what stands.
fn retain<T>(all: &mut Vec<T>, stands: &[bool]) {
    let mut stands = stands.iter();
    all.retain(|_| stands.next().is_some_and(|stands| *stands));
}

/// For each of some candidates, whether it may be among those that are offered for its claim, whatever is proved.
fn may_be_offered(held: &[&Candidate]) -> Vec<bool> {
    let key = |c: &Candidate| (c.claim, c.formula, c.nearness.before_proofs());
    let nearer = |c: &Candidate| held.iter().filter(|other| other.claim == c.claim && key(other) < key(c)).count();
    held.iter().map(|c| nearer(c) < MOST_OFFERED).collect()
}
