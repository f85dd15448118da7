//! Which candidates hold on every motion on which the print should have, and how strongly.
//!
//! **In:** formulas that pass at a few points. **Out:** corrections, written into the accounts, the closest to the print first.
//!
//! Each candidate is a claim of its own, read from what is printed of it: what is offered means what it shows. It is tried on the motions
//! of the check as any claim is, and enclosed where that is asked of the claims of the file, too: what an enclosure does not leave
//! standing is not offered.

use super::erratum::{MOST_OFFERED, Search, as_claim, is_inequality};
use super::generate::Manner;
use super::ranked::Candidate;
use crate::derivation::{Claim, Derivation};
use crate::expr::Rational;
use crate::findings::standing::Decision;
use crate::findings::{ClaimAccount, Correction};
use crate::latex::RelationKind;
use crate::latex::syntax::{Node, NodeKind, to_latex};
use crate::verdict::{Outcome, Strength, Verdict};
use claim::error::CheckError;
use claim::program::Program;
use meter::{Limits, Task};
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

/// Motions on which a candidate is tried before all others.
const FIRST: usize = 3;
/// Most candidates of a formula for which a proof is looked for.
const MOST_PROVED: usize = 8;

/// A candidate that was read again.
struct Read {
    candidate: Candidate,
    claim: Claim,
    /// One for each initial time.
    programs: Vec<Program>,
    /// Of each motion on which it must hold: its column, and the verdict; none where it was not tried.
    verdicts: Vec<(usize, Option<Verdict>)>,
    /// Whether it is proved; without an exception, it needs no enclosure.
    proved: Decision,
    /// Whether it was enclosed.
    enclosed: bool,
}

/// Which motions are meant.
#[derive(Clone, Copy, PartialEq, Eq)]
enum On {
    First,
    Others,
}

impl Read {
    /// The weakest strength with which it holds on the motions; none where it does not hold on all. What is proved holds, too, where a
    /// motion runs so far away that samples leave it open.
    fn holds(&self) -> Option<Strength> {
        let strength = |verdict: &Option<Verdict>| match verdict.as_ref()?.outcome() {
            Outcome::Holds(strength) => Some(strength),
            Outcome::Undecided if self.proved == Decision::Proved => Some(Strength::Proved),
            Outcome::Fails(_) | Outcome::NotApplicable(_) | Outcome::Undecided => None,
        };
        let all: Option<Vec<Strength>> = self.verdicts.iter().map(|(_, verdict)| strength(verdict)).collect();
        let weakest = all?.into_iter().min()?;
        Some(if self.is_proved() { Strength::Proved } else { weakest })
    }

    fn is_proved(&self) -> bool {
        [Decision::Proved, Decision::ProvedExcept].contains(&self.proved)
    }

    /// Whether no motion speaks against it.
    fn may_hold(&self) -> bool {
        let may = |verdict: &Verdict| matches!(verdict.outcome(), Outcome::Holds(_) | Outcome::Undecided);
        self.verdicts.iter().all(|(_, verdict)| verdict.as_ref().is_none_or(may))
    }

    /// Whether it is one of these motions on which it must hold, by its position.
    fn is_on(&self, at: usize, on: On) -> bool {
        let step = self.verdicts.len().div_ceil(FIRST).max(1);
        at.is_multiple_of(step) == (on == On::First)
    }
}

/// A correction that holds.
pub(super) struct Held {
    candidate: Candidate,
    strength: Strength,
    holds_on: usize,
}

impl Held {
    /// Whether nothing more is looked for in place of this formula of this claim.
    pub fn settles(&self, claim: usize, formula: usize) -> bool {
        let of = &self.candidate;
        (of.claim, of.formula) == (claim, formula) && self.strength == Strength::Proved && of.nearness.settles()
    }
}

impl Search<'_> {
    /// Tries candidates on the motions of the check: those that hold everywhere. `motions` are the columns on which those of each claim
    /// must hold. Of those of one formula, none that comes after one which is proved and settles the matter.
    pub(super) fn confirm(
        &self,
        candidates: Vec<Candidate>,
        motions: &[Vec<usize>],
        traces: &[Trace],
    ) -> Result<Vec<Held>, CheckError> {
        if candidates.is_empty() {
            return Ok(Vec::new());
        }
        let mut grown = self.derivation.clone();
        let mut all = self.read(&mut grown, candidates, motions);
        self.sample(&grown, &mut all, traces, On::First);
        all.retain(Read::may_hold);
        self.leave_out_nothing(&mut grown, &mut all, traces);
        self.prove(&grown, &mut all);
        self.sample(&grown, &mut all, traces, On::Others);
        all.retain(|of| of.holds().is_some());
        // What is refuted makes room for others, which nothing was asked yet.
        loop {
            let shown = may_be_offered(&all.iter().map(|of| &of.candidate).collect::<Vec<_>>());
            let open = |of: &Read| !of.enclosed && of.proved != Decision::Proved;
            let asked: Vec<usize> = (0..all.len()).filter(|&n| shown[n] && open(&all[n])).collect();
            if asked.is_empty() {
                break;
            }
            self.enclose(&grown, &mut all, &asked, On::First);
            let asked: Vec<usize> = asked.into_iter().filter(|&n| all[n].holds().is_some()).collect();
            self.enclose(&grown, &mut all, &asked, On::Others);
            asked.iter().for_each(|&n| all[n].enclosed = true);
            all.retain(|of| of.holds().is_some());
        }
        let held = |of: Read| {
            let (strength, holds_on) = (of.holds()?, of.verdicts.len());
            Some(Held { candidate: of.candidate, strength, holds_on })
        };
        Ok(all.into_iter().filter_map(held).collect())
    }

    /// Of equations that may say the rate of a quantity, those that are proved, each with its claim.
    pub(super) fn proved_rates(
        &self,
        candidates: Vec<Candidate>,
        motions: &[Vec<usize>],
        traces: &[Trace],
    ) -> Result<Vec<(usize, String)>, CheckError> {
        if candidates.is_empty() {
            return Ok(Vec::new());
        }
        let mut grown = self.derivation.clone();
        let mut all = Vec::new();
        for (n, candidate) in candidates.into_iter().enumerate() {
            let columns = motions[candidate.claim].iter().map(|&t| (t, None)).collect();
            all.extend(self.read_one(&mut grown, (n, candidate), Manner::Relation, columns));
        }
        self.sample(&grown, &mut all, traces, On::First);
        all.retain(Read::may_hold);
        self.prove(&grown, &mut all);
        let proved = |of: Read| (of.proved == Decision::Proved).then_some((of.candidate.claim, of.candidate.text));
        Ok(all.into_iter().filter_map(proved).collect())
    }

    /// The candidates as claims of their own, in a graph that grows.
    fn read(&self, grown: &mut Derivation, candidates: Vec<Candidate>, motions: &[Vec<usize>]) -> Vec<Read> {
        let mut out = Vec::new();
        for (n, candidate) in candidates.into_iter().enumerate() {
            if candidate.text.split_once('=').is_some_and(|(left, right)| left.trim() == right.trim()) {
                continue;
            }
            let manner = self.altered.claims[candidate.claim].formulas[candidate.formula].manner;
            let columns = motions[candidate.claim].iter().map(|&t| (t, None)).collect();
            out.extend(self.read_one(grown, (n, candidate), manner, columns));
        }
        out
    }

    fn read_one(
        &self,
        grown: &mut Derivation,
        (n, candidate): (usize, Candidate),
        manner: Manner,
        verdicts: Vec<(usize, Option<Verdict>)>,
    ) -> Option<Read> {
        let trajectories: Vec<usize> = verdicts.iter().map(|&(t, _)| self.selection.tried[t]).collect();
        let claim = &self.derivation.claims[self.selection.claims[candidate.claim]];
        let id = format!("correction {n}");
        let claim = as_claim(&mut grown.graph, claim, &id, &candidate, manner, trajectories);
        let claim = claim.filter(|_| !verdicts.is_empty())?;
        let (graph, derivation) = (&mut grown.graph, self.derivation);
        let starts = self.selection.starts.iter().zip(&self.selection.shared);
        let program =
            |(s, shared): (&Rational, &Vec<_>)| Program::new(graph, derivation.into(), &claim, s).sharing(shared);
        let mut programs: Vec<Program> = starts.map(program).collect();
        let compiled = programs.iter_mut().all(|p| p.compile(graph, &self.altered.known).is_ok());
        let (proved, enclosed) = (Decision::Undecided, false);
        compiled.then_some(Read { candidate, claim, programs, verdicts, proved, enclosed })
    }

    /// Leaves out what is constant because it is nothing: what is 0 on the first motions.
    fn leave_out_nothing(&self, grown: &mut Derivation, all: &mut Vec<Read>, traces: &[Trace]) {
        let is_constant = |of: &Read| {
            self.altered.claims[of.candidate.claim].formulas[of.candidate.formula].manner == Manner::Constant
        };
        let (mut zeros, mut of_which) = (Vec::new(), Vec::new());
        for (n, of) in all.iter().enumerate().filter(|(_, of)| is_constant(of)) {
            let mut candidate = of.candidate.clone();
            candidate.tree.sides.push(Node::new(NodeKind::Number(Rational::ZERO), 0..0));
            candidate.tree.relations.push(RelationKind::Equal);
            candidate.text = to_latex(&candidate.tree);
            let first = of.verdicts.iter().enumerate().filter(|(at, _)| of.is_on(*at, On::First));
            let first = first.map(|(_, (t, _))| (*t, None)).collect();
            if let Some(zero) = self.read_one(grown, (n, candidate), Manner::Relation, first) {
                zeros.push(zero);
                of_which.push(n);
            }
        }
        self.sample(grown, &mut zeros, traces, On::First);
        let nothing: Vec<usize> =
            of_which.into_iter().zip(&zeros).filter(|(_, zero)| zero.holds().is_some()).map(|(n, _)| n).collect();
        let mut at = 0..;
        all.retain(|_| at.next().is_none_or(|n| !nothing.contains(&n)));
    }

    /// Tries candidates at samples, on some of the motions on which they must hold.
    fn sample(&self, grown: &Derivation, all: &mut [Read], traces: &[Trace], on: On) {
        let start = |t: usize| self.selection.start_of[self.selection.tried[t]];
        let on_one = |&t: &usize, limits: &Limits| -> Vec<Option<Verdict>> {
            let here = |of: &&Read| of.verdicts.iter().enumerate().any(|(n, (c, _))| *c == t && of.is_on(n, on));
            let asked = || all.iter().filter(here);
            if asked().next().is_none() {
                return Vec::new();
            }
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
        for of in all {
            for at in (0..of.verdicts.len()).filter(|&at| of.is_on(at, on)).collect::<Vec<_>>() {
                let (t, verdict) = &mut of.verdicts[at];
                *verdict = found.get_mut(*t).and_then(Iterator::next).flatten();
            }
        }
    }

    /// Encloses some of the candidates, where that is asked, on some of the motions.
    fn enclose(&self, grown: &Derivation, all: &mut [Read], asked: &[usize], on: On) {
        let Some(encloses) = self.encloses.filter(|_| !asked.is_empty()) else { return };
        let places = |of: &Read| -> Vec<usize> { (0..of.verdicts.len()).filter(|&at| of.is_on(at, on)).collect() };
        let beside = |&n: &usize| {
            let Read { claim, programs, verdicts, .. } = &all[n];
            let one = |program: &Program| Prepared { claim, program: program.clone(), gradients: None };
            let verdict = |&at: &usize| Some((self.selection.tried[verdicts[at].0], verdicts[at].1.clone()?));
            Beside {
                prepared: programs.iter().map(one).collect(),
                verdicts: places(&all[n]).iter().filter_map(verdict).collect(),
            }
        };
        let found = encloses.enclose(grown, asked.iter().map(beside).collect());
        for (&n, verdicts) in asked.iter().zip(found) {
            for (at, stronger) in places(&all[n]).into_iter().zip(verdicts) {
                all[n].verdicts[at].1 = Some(stronger);
            }
        }
    }

    /// Looks for proofs: of those of one formula one after the other, until one is proved that settles the matter. Those after it are
    /// left out.
    fn prove(&self, grown: &Derivation, all: &mut Vec<Read>) {
        let of = |read: &Read| (read.candidate.claim, read.candidate.formula);
        let groups: Vec<&[Read]> = all.chunk_by(|a, b| of(a) == of(b)).collect();
        let one = |group: &&[Read], limits: &Limits| -> Vec<Option<Decision>> {
            let mut out: Vec<Option<Decision>> = Vec::new();
            let mut settled = false;
            for (n, read) in group.iter().enumerate() {
                let asked = n < MOST_PROVED && !settled;
                let decision = if asked { decided(grown, &read.claim, limits) } else { Decision::Undecided };
                out.push((!settled).then_some(decision));
                settled |= decision == Decision::Proved && read.candidate.nearness.settles();
            }
            out
        };
        let found = meter::each(self.limits, &groups, one);
        let mut found = found.into_iter().flatten();
        all.retain_mut(|of| {
            let decision = found.next().flatten();
            of.proved = decision.unwrap_or(Decision::Undecided);
            decision.is_some()
        });
    }

    /// Writes what holds into the accounts; where nothing does, why.
    pub(super) fn write(&self, accounts: &mut [ClaimAccount], mut held: Vec<Held>) {
        held.sort_by(|one, other| {
            let (a, b) = (&one.candidate, &other.candidate);
            let (x, y) = (one.strength == Strength::Proved, other.strength == Strength::Proved);
            (a.claim, a.formula).cmp(&(b.claim, b.formula)).then_with(|| a.nearness.than(x, &b.nearness, y))
        });
        for Held { candidate, strength, holds_on } in held {
            let printed = &self.altered.claims[candidate.claim].formulas[candidate.formula].text;
            let correction = Correction {
                printed: printed.clone(),
                formula: candidate.text,
                difference: candidate.difference,
                classes: candidate.classes,
                strength,
                holds_on,
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

/// What a claim comes to for all values. All that is wanted is whether there is a proof: no assumption that it could do without, and no
/// point where there is none.
fn decided(grown: &Derivation, claim: &Claim, limits: &Limits) -> Decision {
    let step = || Step::of(grown, claim).and_then(|step| step.with(true).with_few_points().decide()).transpose();
    match meter::piece(Task::Proving, limits, step) {
        Ok(Ok(identity)) => identity.map_or(Decision::Undecided, |i| {
            proved::replay::replayed(
                grown,
                claim,
                i,
                proved::replay::has_motions(grown, claim),
                (limits, &|_, find| find()),
            )
            .finding
            .decision()
        }),
        Ok(Err(defect)) => {
            meter::Defects::note(&defect);
            Decision::Undecided
        }
        Err(_) => Decision::Undecided,
    }
}

/// For each of some candidates, whether it may be among those that are offered for its claim, whatever is proved.
fn may_be_offered(held: &[&Candidate]) -> Vec<bool> {
    let key = |c: &Candidate| (c.claim, c.formula, c.nearness.before_proofs());
    let nearer = |c: &Candidate| held.iter().filter(|other| other.claim == c.claim && key(other) < key(c)).count();
    held.iter().map(|c| nearer(c) < MOST_OFFERED).collect()
}
