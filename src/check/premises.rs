//! What follows from what: motions that refute a step, and verdicts that a proof lends its strength.
//!
//! **In:** the verdicts on motions, and what was proved for all values. **Out:** a motion on which everything holds that a claim is said
//! to follow from, and the claim fails; or the same verdicts, some of them *proved*.
//!
//! **Guaranteed:** a verdict gets the strength of a proof only on a motion on which all holds that the proof rests on.

use std::collections::HashMap;

use super::memory::{Known, Question};
use claim::comparison;
use claim::limits::Limits;
use derivation::{Claim, Derivation, Form, Premise};
use expr::FastMap;
use findings::{ClaimAccount, IdentityAccount};
use latex::RelationKind;
use meter::{Ended, Task};
use proved::conditional::premises_first;
use proved::step::Step;
use reason::{Plain, Refuting};
use sampled::selection::Selection;
use verdict::{Outcome, Proof, Strength, Verdict, Witness};

/// What was found on one motion: a verdict for every claim that is tried on it.
pub(super) type Column = Vec<Option<Verdict>>;

/// A motion on which everything holds that the `k`-th of the chosen claims is said to follow from, and the claim fails.
pub(super) fn counterexample<'a>(
    derivation: &Derivation,
    selection: &Selection,
    k: usize,
    known: &Accounts,
    columns: &'a [Column],
) -> Option<(usize, &'a Witness)> {
    let claim = &derivation.claims[selection.claims[k]];
    let given = Step::given(derivation, claim);
    let counted = std::cell::OnceCell::new();
    let counts = |t: usize| {
        let all = counted.get_or_init(|| proved::existence::motions_of_file(derivation, claim));
        all.contains(&t)
    };
    columns.iter().zip(&selection.tried).find_map(|(verdicts, &t)| {
        let verdict = verdicts[k].as_ref().filter(|v| matches!(v.outcome(), Outcome::Fails(_)))?;
        let holds = |name: &String| match derivation.premise(name) {
            Premise::System(system) => is_integrated_from(derivation, t, system),
            Premise::Claim(premise) => {
                let of_this_run = selection.claims.binary_search(&premise).ok().and_then(|k| verdicts[k].as_ref());
                let verdict = of_this_run.or_else(|| known.verdict(derivation, premise, t));
                // Where a premise was left out, nothing is given.
                verdict.and_then(Verdict::is_met) == Some(true)
            }
            Premise::Definition => true,
        };
        if given.iter().all(holds) && counts(t) { Some((t, verdict.evidence().witness.as_ref()?)) } else { None }
    })
}

/// The answer of a step that a motion refutes, the `k`-th of the chosen claims: on others it may be seen to hold, however false it is.
///
/// # Errors
/// A description of the contradiction, if the two routes disagree.
pub(super) fn refuted_on(
    step: &Step,
    (trajectory, witness): (&str, &Witness),
    k: usize,
    columns: &[Column],
) -> Result<IdentityAccount, String> {
    let account = step.refuted_by(trajectory, witness);
    let is_open = |verdict: &Verdict| !matches!(verdict.outcome(), Outcome::Fails(_) | Outcome::NotApplicable(_));
    match columns.iter().any(|verdicts| verdicts[k].as_ref().is_some_and(is_open)) {
        true => step.excluding(account),
        false => Ok(account),
    }
}

/// Accounts by the ids and readings of their claims: each claim asks for others, and to look for one takes as long as there are many.
pub(super) struct Accounts<'a>(FastMap<(&'a str, Option<&'a str>), &'a ClaimAccount>);

impl<'a> Accounts<'a> {
    /// The index; of two accounts of one claim the first counts.
    pub(super) fn of(all: impl IntoIterator<Item = &'a ClaimAccount>) -> Accounts<'a> {
        let mut index = FastMap::default();
        for account in all {
            index.entry((account.id.as_str(), account.reading.as_deref())).or_insert(account);
        }
        Accounts(index)
    }

    /// The account of a claim.
    pub(super) fn get(&self, claim: &Claim) -> Option<&'a ClaimAccount> {
        self.0.get(&(claim.id.as_str(), claim.reading.as_deref())).copied()
    }

    /// The verdict on a claim, by its position, on a trajectory.
    fn verdict(&self, derivation: &Derivation, claim: usize, trajectory: usize) -> Option<&'a Verdict> {
        let (claim, trajectory) = (derivation.claims.get(claim)?, derivation.trajectories.get(trajectory)?);
        self.get(claim)?.on(&trajectory.id).map(|r| &r.verdict)
    }
}

/// Whether a trajectory was integrated from a system: then its equations hold on it.
fn is_integrated_from(derivation: &Derivation, trajectory: usize, system: usize) -> bool {
    let motion = &derivation.trajectories[trajectory].motion;
    matches!(motion, derivation::Motion::Integrated { system: of, .. } if *of == system)
}

/// Whether the states of a motion may leap, as formulas may: a proof that goes from one time to others, or to rates, takes them
/// to be smooth.
fn may_leap(derivation: &Derivation, trajectory: usize) -> bool {
    let leaps = |of: &[(expr::Symbol, derivation::Written<Vec<expr::Expr>>)]| {
        let analytic = |&e: &_| derivation.scope.time().is_some_and(|time| derivation.graph.is_analytic_in(e, time));
        !of.iter().flat_map(|(_, w)| &w.value).all(analytic)
    };
    match &derivation.trajectories[trajectory].motion {
        derivation::Motion::Integrated { .. } => false,
        derivation::Motion::Formula { states } => leaps(states),
        derivation::Motion::Derived { from, map } => {
            let mut graph = derivation.graph.clone();
            let mut leaps = |&e: &_| comparison::leaps_behind(&mut graph, &derivation.scope, e).0;
            may_leap(derivation, *from) || map.iter().flat_map(|(_, w)| &w.value).any(&mut leaps)
        }
    }
}

/// Whether a claim applies to a motion of its file on which, at some times of it, all that it follows from is so. What a run leaves out may be
/// so: a claim that is checked alone has the proof that it has beside the others.
fn has_motion(derivation: &Derivation, declared: &Claim, claim: &ClaimAccount, accounts: &Accounts) -> bool {
    let account = |of: &Claim| accounts.get(of);
    let mut all: Vec<(&Claim, Option<&ClaimAccount>)> = vec![(declared, Some(claim))];
    let premises = derivation.claims_among(&declared.follows_from).map(|at| &derivation.claims[at]);
    all.extend(premises.map(|of| (of, account(of))));
    let named = all.len();
    // What these follow from in turn may choose times, too.
    let inherited = claim.identity.as_ref().map_or(&[][..], |identity| &identity.presupposed);
    for at in proved::existence::assumed_behind(derivation, declared, inherited) {
        let of = &derivation.claims[at];
        if !all.iter().any(|(known, _)| std::ptr::eq(*known, of)) {
            all.push((of, account(of)));
        }
    }
    // Where it is undecided, the motion may not come so far. What fails applies.
    let is_met = |at: usize, outcome: Outcome| match outcome {
        Outcome::Holds(_) => true,
        Outcome::Fails(_) => at == 0 || at >= named,
        Outcome::NotApplicable(_) | Outcome::Undecided => false,
    };
    let may_be_so = proved::existence::motions_of_file(derivation, declared);
    let on_motion = |at: usize| {
        let motion = &derivation.trajectories[at];
        let mut verdicts: Vec<&Verdict> = Vec::new();
        all.iter().enumerate().all(|(k, (of, account))| match account.map(|account| account.on(&motion.id)) {
            Some(Some(pair)) => {
                verdicts.push(&pair.verdict);
                is_met(k, pair.verdict.outcome())
            }
            Some(None) => of.trajectories.contains(&at),
            None => true,
        }) && share_times(motion.span, &verdicts)
    };
    // Members are tried after this; what a family says is known where it is recalled. At which times is not told.
    let on_family = |at: usize| {
        let family = &derivation.families[at];
        let found = |of: &ClaimAccount| Some(of.families.iter().find(|f| f.family == family.id)?.verdict.outcome());
        may_be_so.contains(&family.of)
            && all.iter().enumerate().all(|(k, (of, account))| {
                let is_so = |account| found(account).is_some_and(|outcome| is_met(k, outcome));
                account.is_none_or(is_so) && proved::existence::is_of_all_times(derivation, of)
            })
    };
    let tried = may_be_so.iter().filter(|at| declared.trajectories.contains(at));
    tried.copied().any(on_motion) || declared.families.iter().copied().any(on_family)
}

/// So many samples in a row show that there are times which none of some verdicts leaves out.
const SHARED: f64 = 4.0;

/// Whether there is a stretch of a motion that none of some verdicts on it leaves out. Premises that speak of other times each hold at
/// theirs: that says nothing of one time.
fn share_times((from, to): (f64, f64), verdicts: &[&Verdict]) -> bool {
    let partial = || verdicts.iter().filter(|v| v.exclusions().next().is_some());
    let Some(samples) = partial().map(|v| v.evidence().samples).min() else { return true };
    if partial().count() == 1 {
        return samples > 0;
    }
    let mut out: Vec<(f64, f64)> = partial().flat_map(|v| v.exclusions()).map(|e| (e.from, e.to)).collect();
    out.push((to, to));
    out.sort_by(|a, b| a.0.total_cmp(&b.0));
    let least = SHARED * (to - from) / samples as f64;
    let mut end = from;
    out.into_iter().any(|(start, stop)| {
        let is_free = start - end > least;
        end = end.max(stop);
        is_free
    })
}

/// Has the checker replay the proofs, of the file as it was read: what it does not replay is not called proved.
pub(super) fn replay(
    derivation: &Derivation,
    claims: &mut [ClaimAccount],
    known: &[ClaimAccount],
    (limits, recall): (&Limits, Known),
) {
    // What a proof presupposes, its steps may.
    proved::conditional::conditional(derivation, claims, known);
    let accounts = Accounts::of(claims.iter().chain(known));
    let of = |claim: &ClaimAccount, limits: &Limits| -> Option<IdentityAccount> {
        let declared = derivation.claim(&claim.id, claim.reading.as_deref())?;
        let account = claim.identity.clone().filter(|i| i.finding.is_proved_in_part())?;
        let has_motion = has_motion(derivation, declared, claim, &accounts);
        let steps: proved::replay::RecallSteps = &|asked, find| match recall.is_nothing() {
            true => find(),
            false => recall.answer(derivation, Question::Steps(&asked.content()), find),
        };
        Some(proved::replay::replayed(derivation, declared, account, has_motion, (limits, steps)))
    };
    let found = meter::each(limits, &*claims, |claim, limits| of(claim, limits));
    for (claim, replayed) in claims.iter_mut().zip(found) {
        if replayed.is_some() {
            claim.identity = replayed;
        }
    }
}

/// Gives verdicts the strength of the proofs behind them. Motions that are given by formulas come first, see [`by_formula`](proved::by_formula).
///
/// What a claim says is proved on a motion when it follows for all values from systems that the trajectory was integrated from, or
/// from claims that are themselves `proved` on it. What it presupposes is not proved by that.
pub(super) fn strengthen(
    derivation: &Derivation,
    selection: &Selection,
    claims: &mut [ClaimAccount],
    known: &[ClaimAccount],
    (limits, recall): (&Limits, Known),
) {
    let Selection { claims: claimed, tried, .. } = selection;
    // What is not replayed is open to all that follows from it.
    proved::conditional::conditional(derivation, claims, known);
    for (claim, &at) in claims.iter_mut().zip(claimed) {
        let declared = &derivation.claims[at];
        // What is stated of fields, and not derived, is not asked.
        if let Some(region) = declared.region.as_ref().filter(|_| declared.is_of_fields() && !declared.postulate) {
            claim.region = Some(boxes::of_step(declared, region, claim.identity.as_ref()));
        }
    }
    let by_formula = |t: usize, before: (&Claim, &Verdict), limits: &Limits, find: &mut dyn FnMut() -> Verdict| {
        let (claim, before) = before;
        recall.answer(derivation, Question::ByFormula { claim, motion: t, before }, || {
            match meter::piece(Task::Proving, limits, &mut *find) {
                Ok(found) => found,
                Err(ended @ Ended::Defect(_)) => {
                    let mut none = before.clone();
                    none.contradict(ended.into());
                    none
                }
                Err(_) => before.clone(),
            }
        })
    };
    proved::by_formula::settle(derivation, claims, (claimed, tried), limits, &by_formula);
    let motion: HashMap<&str, usize> = tried.iter().map(|&t| (derivation.trajectories[t].id.as_str(), t)).collect();
    // The motions of the results of each claim.
    let on: Vec<HashMap<usize, usize>> = claims
        .iter()
        .map(|c| {
            c.results.iter().enumerate().filter_map(|(at, p)| Some((*motion.get(p.trajectory.as_str())?, at))).collect()
        })
        .collect();
    let here = |premise: usize| claimed.binary_search(&premise).ok();
    let earlier = Accounts::of(known);
    for k in premises_first(claimed.len(), |k| premises(derivation, claimed, &claims[k], claimed[k])) {
        let Some(identity) = claims[k].identity.as_ref().filter(|i| i.lends_strength() || i.lends_parts()) else {
            continue;
        };
        // Where the sign that is proved has no value, the other one may be false.
        if !identity.conditions.is_empty()
            && derivation.claims[claimed[k]].forms.iter().any(derivation::Form::has_branches)
        {
            continue;
        }
        let from = if identity.lends_parts() { &identity.parts_from } else { &identity.from };
        let mut ready: Vec<usize> = Vec::new();
        for (at, pair) in claims[k].results.iter().enumerate() {
            let Some(&t) = motion.get(pair.trajectory.as_str()) else { continue };
            let declared = &derivation.claims[claimed[k]];
            if !(from.is_empty() && declared.assuming.is_empty()) && may_leap(derivation, t) {
                continue;
            }
            let given = |name: &String| match derivation.premise(name) {
                Premise::System(system) => is_integrated_from(derivation, t, system),
                Premise::Claim(premise) => {
                    let here = here(premise).and_then(|k| Some(&claims[k].results[*on[k].get(&t)?].verdict));
                    let verdict = here.or_else(|| earlier.verdict(derivation, premise, t));
                    verdict.is_some_and(|v| v.outcome() == Outcome::Holds(Strength::Proved))
                }
                Premise::Definition => true,
            };
            // Where something special is left out, only what is seen to hold is given the strength of the proof.
            let open = match pair.verdict.outcome() {
                Outcome::Holds(strength) => strength < Strength::Proved,
                Outcome::Fails(strength) if identity.lends_parts() => strength < Strength::Proved,
                Outcome::Undecided | Outcome::Fails(_) => identity.exceptions.is_empty(),
                Outcome::NotApplicable(_) => false,
            };
            if open && from.iter().all(given) {
                ready.push(at);
            }
        }
        let proof = Proof { from: from.clone(), conditions: Vec::new() };
        let of_parts = identity.lends_parts().then(|| identity.parts.clone());
        for at in ready {
            let verdict = &mut claims[k].results[at].verdict;
            match &of_parts {
                Some(parts) => verdict.prove_parts(parts, &proof),
                None => verdict.prove_claim(&proof),
            }
        }
    }
    take_back(derivation, claims, known);
}

/// Among the claims of this run, those that one of them follows from, and those that its proof rests on.
fn premises(derivation: &Derivation, claimed: &[usize], claim: &ClaimAccount, at: usize) -> Vec<usize> {
    let of = |name: &String| claimed.binary_search(&derivation.premise(name).claim()?).ok();
    let proved = claim.identity.iter().flat_map(|i| i.from.iter().chain(&i.parts_from));
    derivation.claims[at].follows_from.iter().chain(proved).filter_map(of).collect()
}

/// Takes back what a motion refutes on which that which is given holds only as far as numbers show: sin x is not x.
fn take_back(derivation: &Derivation, claims: &mut [ClaimAccount], known: &[ClaimAccount]) {
    let accounts = Accounts::of(claims.iter().chain(known));
    let is_exact = |name: &String, trajectory: &str| match derivation.premise(name) {
        Premise::System(_) | Premise::Definition => true,
        Premise::Claim(at) => {
            let of = &derivation.claims[at];
            let verdict =
                accounts.get(of).and_then(|account| account.on(trajectory)).map(|pair| pair.verdict.outcome());
            verdict == Some(Outcome::Holds(Strength::Proved)) || is_strict(of)
        }
    };
    let mut rough: Vec<usize> = Vec::new();
    for (at, claim) in claims.iter().enumerate() {
        let Some(identity) = &claim.identity else { continue };
        let Some(Refuting::OnMotion { trajectory, .. }) = &identity.witness else { continue };
        if !identity.from.iter().all(|name| is_exact(name, trajectory)) {
            rough.push(at);
        }
    }
    for at in rough {
        if let Some(identity) = &mut claims[at].identity {
            let from = std::mem::take(&mut identity.from);
            let reason = Some(Plain::RefutedWithinErrors.into());
            *identity = IdentityAccount { from, reason, ..IdentityAccount::default() };
        }
    }
}

/// Whether a claim says only of sides that they differ, or which is the larger one: numbers show anything else only within errors.
fn is_strict(claim: &Claim) -> bool {
    let all = |statement: &derivation::Written<latex::Statement>, kinds: &[RelationKind]| {
        statement.value.relations.iter().all(|relation| kinds.contains(&relation.kind))
    };
    const APART: &[RelationKind] = &[RelationKind::Less, RelationKind::Greater, RelationKind::NotEqual];
    const TOGETHER: &[RelationKind] = &[RelationKind::LessEqual, RelationKind::GreaterEqual, RelationKind::Equal];
    claim.forms.iter().all(|form| match form {
        Form::Always(w) | Form::Eventually(w) => all(w, APART),
        Form::Never(w) => w.value.relations.len() == 1 && all(w, TOGETHER),
        Form::Defined(_) => true,
        Form::FirstIntegral(_) | Form::Solves { .. } | Form::SameMotion { .. } | Form::Independent { .. } => false,
        Form::Exists { .. } | Form::Across(_) | Form::Unread { .. } => false,
    })
}
