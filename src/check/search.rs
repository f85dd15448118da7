//! A motion on which a claim fails.
//!
//! **In:** a derivation, a claim, a seed and a number of tries. **Out:** a trajectory as text of a derivation file, on which
//! the claim fails with its assumptions met; or how the tries ended. **Guaranteed:** what is found was checked from the very
//! text that is handed out. The same seed gives the same text on any number of threads: every try has its own draws, and the
//! first try that fails is taken.
//!
//! **How:** numbers of the file's trajectories are changed, see `draft.rs`. What is found is then made simple: numbers go back
//! to those of the file, or to fewer digits, as long as the claim still fails.

use super::draft::{Draft, draw, rounded};
use super::on_drafts::{Asked, name, verdicts};
use super::run::Run;
use crate::derivation::{Claim, Derivation, parse};
use crate::diag::{Diagnostic, Source};
use crate::verdict::{Finding, Outcome, Verdict};
use claim::error::CheckError;
use claim::limits::Limits;
use claim::options::Options;
use findings::search::{FailingMotion, SearchAccount, Tries};
use reason::Plain;

/// Tries that are checked together. Part of what a seed means: it must not depend on the machine.
pub(super) const BATCH: usize = 24;
/// Rounds in which numbers are made simpler.
const ROUNDS: usize = 3;

/// What is looked for.
#[derive(Clone, Debug)]
pub struct SearchOptions {
    /// The claim: its id, for any of its readings, or `id/reading`.
    pub claim: String,
    /// The seed of all draws.
    pub seed: u64,
    /// How many motions are tried at most.
    pub tries: usize,
    /// Not the claim shall fail but one of its altered formulas, while the claim holds: its number among those that some motion
    /// does not reject, as reports list them.
    pub variant: Option<usize>,
}

/// A file with more trajectories, on which the claim alone is checked.
struct Trial<'d> {
    derivation: &'d Derivation,
    names: Vec<String>,
    id: String,
    /// All tries have the counted work of one file together.
    limits: Limits,
    /// The same claims as the file has them, where they are altered: these must hold.
    printed: Option<Box<Trial<'d>>>,
}

impl Trial<'_> {
    /// The verdicts on drafts: for each the first claim that fails, else the first verdict of all. Where an altered claim
    /// fails and the claim itself does not hold, nothing is told apart: the verdict is then that of the claim, or undecided.
    fn verdicts(&self, drafts: &[Draft]) -> Result<Vec<Option<(String, Verdict)>>, CheckError> {
        let mut out = self.verdicts_here(drafts)?;
        let Some(printed) = &self.printed else { return Ok(out) };
        let fails =
            |v: &Option<(String, Verdict)>| v.as_ref().is_some_and(|(_, v)| matches!(v.outcome(), Outcome::Fails(_)));
        let at: Vec<usize> = (0..out.len()).filter(|&i| fails(&out[i])).collect();
        let those: Vec<Draft> = at.iter().filter_map(|&i| drafts.get(i).cloned()).collect();
        for (i, own) in at.into_iter().zip(printed.verdicts_here(&those)?) {
            match own {
                Some((_, verdict)) if matches!(verdict.outcome(), Outcome::Holds(_)) => {}
                Some((name, verdict)) if matches!(verdict.outcome(), Outcome::Fails(_)) => {
                    out[i] = Some((name, Verdict::of(Finding::open(Plain::ClaimItselfFails))));
                }
                other => out[i] = other,
            }
        }
        Ok(out)
    }

    fn verdicts_here(&self, drafts: &[Draft]) -> Result<Vec<Option<(String, Verdict)>>, CheckError> {
        let named: Vec<(String, Draft)> =
            drafts.iter().enumerate().map(|(i, draft)| (format!("{}-{i}", self.id), draft.clone())).collect();
        let asked = |name: &String| Asked { name: name.clone(), on: (0..drafts.len()).collect() };
        let asked: Vec<Asked> = self.names.iter().map(asked).collect();
        let of_claims = verdicts(self.derivation, &named, &asked, (|run| run.account(), &self.limits))?;
        let of = |i: usize| {
            let all = self.names.iter().zip(&of_claims);
            let mut found: Vec<(String, Verdict)> =
                all.filter_map(|(name, of)| Some((name.clone(), of.get(i)?.clone()?))).collect();
            let at = found.iter().position(|(_, v)| matches!(v.outcome(), Outcome::Fails(_))).unwrap_or(0);
            (at < found.len()).then(|| found.swap_remove(at))
        };
        Ok((0..drafts.len()).map(of).collect())
    }

    fn fails(&self, draft: &Draft) -> Result<Option<(String, Verdict)>, CheckError> {
        let verdict = self.verdicts(std::slice::from_ref(draft))?.pop().flatten();
        Ok(verdict.filter(|(_, v)| matches!(v.outcome(), Outcome::Fails(_))))
    }

    /// The simplest of some drafts on which the claim fails; the first that does.
    fn first_failing(&self, drafts: &[Draft]) -> Result<Option<Draft>, CheckError> {
        let verdicts = self.verdicts(drafts)?;
        let failing =
            |v: &Option<(String, Verdict)>| v.as_ref().is_some_and(|(_, v)| matches!(v.outcome(), Outcome::Fails(_)));
        Ok(verdicts.iter().position(failing).and_then(|i| drafts.get(i).cloned()))
    }

    /// The same with simpler numbers, as long as the claim fails.
    fn simpler(&self, found: Draft, family: &Draft) -> Result<Draft, CheckError> {
        let mut best = found;
        // All at once first: it may be that digits do not matter at all.
        let mut coarse = Vec::new();
        for digits in [1, 2] {
            let mut all = best.clone();
            for at in best.entries() {
                let own = best.get(at);
                all.set(at, if own == family.get(at) { own } else { rounded(own, digits) });
            }
            coarse.push(all);
        }
        best = self.first_failing(&coarse)?.unwrap_or(best);
        for _ in 0..ROUNDS {
            let before = best.clone();
            for at in best.entries() {
                let (own, original) = (best.get(at), family.get(at));
                let mut values = vec![original, 0.0, 1.0];
                values.extend((1..4).map(|digits| rounded(own, digits)));
                // In the order of their digits, but the file's own number is the simplest.
                let tried: Vec<Draft> = values
                    .into_iter()
                    .take_while(|v| *v != own)
                    .map(|v| {
                        let mut draft = best.clone();
                        draft.set(at, v);
                        draft
                    })
                    .collect();
                best = self.first_failing(&tried)?.unwrap_or(best);
            }
            let (start, end) = (best.initial_time, best.span.1);
            let shorter = [1.0, 2.0, 5.0, 10.0, 20.0].into_iter().filter(|d| best.span.0 == start && start + d < end);
            let tried: Vec<Draft> = shorter.map(|d| Draft { span: (start, start + d), ..best.clone() }).collect();
            best = self.first_failing(&tried)?.unwrap_or(best);
            if best == before {
                break;
            }
        }
        Ok(best)
    }
}

/// Looks for a motion on which a claim fails. `progress` is told how many of how many tries are done.
///
/// The claim is judged as it is written; with `variant`, the motion is one on which it holds and that altered formula fails.
///
/// # Errors
/// See [`check`](super::check()); and [`CheckError::Problems`] where there is no such altered formula.
pub fn search(
    derivation: &Derivation,
    options: &SearchOptions,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Result<SearchAccount, CheckError> {
    let meant = |c: &&Claim| c.id == options.claim || c.name() == options.claim;
    if derivation.claims.iter().any(|c| meant(&c)) && derivation.claims.iter().filter(meant).all(|c| c.region.is_some())
    {
        let text = format!("`{}` is about ranges of values, there is no motion to look for", options.claim);
        let found = Diagnostic::at(&derivation.file, "search::no-motion", 0..0, text);
        let hint = "a point at which it fails is part of its verdict: see `rederive explain`";
        return Err(CheckError::Problems(vec![found.hint(hint)]));
    }
    let Some(number) = options.variant else { return search_in(derivation, None, options, progress) };
    let (altered, formula) = altered(derivation, options, number)?;
    let found = search_in(&altered, Some(derivation), options, progress)?;
    Ok(SearchAccount { variant: Some(formula), ..found })
}

/// The derivation with an altered formula in the place of the printed one, and that formula.
fn altered(
    derivation: &Derivation,
    options: &SearchOptions,
    number: usize,
) -> Result<(Derivation, String), CheckError> {
    let problem = |text: String, hint: &str| {
        let found = Diagnostic::at(&derivation.file, "search::no-variant", 0..0, text);
        CheckError::Problems(vec![found.hint(hint)])
    };
    let meant: Vec<_> =
        derivation.claims.iter().filter(|c| c.id == options.claim || c.name() == options.claim).collect();
    let [claim] = meant.as_slice() else {
        let text = format!("`{}` has several readings", options.claim);
        return Err(problem(text, "altered formulas are numbered for each reading: give `id/reading`"));
    };
    let mut copy = derivation.clone();
    copy.measures.clear();
    let of_claim = Options { claims: vec![claim.id.clone()], ..Options::default() };
    let account = Run { separating: false, ..Run::new(&copy, &of_claim) }.account()?;
    let found = account.claims.iter().find(|c| c.id == claim.id && c.reading == claim.reading);
    let survivors = found.and_then(|c| c.variants.as_ref()).map_or(&[][..], |v| v.survivors.as_slice());
    let Some(survivor) = survivors.get(number) else {
        let text =
            format!("`{}` has {} altered formulas that some motion does not reject", options.claim, survivors.len());
        return Err(problem(text, "they are numbered from 0, in report.md and report.json"));
    };
    let Some(place) = survivor.place.clone() else {
        let text = format!("`{}` stands in a definition, not in the claim", survivor.printed);
        return Err(problem(text, "a definition that is altered would alter every claim that uses it"));
    };
    let mut text = derivation.file.text.clone();
    if text.get(place.clone()).is_some() {
        text.replace_range(place, &survivor.formula);
    }
    let path = derivation.file.path.clone();
    let mut altered = parse(Source { path, text }, &derivation.id).map_err(CheckError::Problems)?;
    // What shares the formula keeps it.
    altered.claims.retain(|c| c.id == claim.id);
    Ok((altered, survivor.formula.clone()))
}

fn search_in(
    derivation: &Derivation,
    printed: Option<&Derivation>,
    options: &SearchOptions,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Result<SearchAccount, CheckError> {
    let meant = derivation.claims.iter().filter(|c| c.id == options.claim || c.name() == options.claim);
    let names: Vec<String> = meant.map(|c| c.name()).collect();
    let id = fresh_id(derivation, &options.claim, options.variant, options.seed);
    let limits = Limits::default().of_file(0);
    let of = |derivation, printed| Trial {
        derivation,
        names: names.clone(),
        id: id.clone(),
        limits: limits.clone(),
        printed,
    };
    let trial = of(derivation, printed.map(|p| Box::new(of(p, None))));
    let families: Vec<Draft> = derivation.trajectories.iter().filter_map(|t| Draft::of(derivation, t)).collect();
    let mut out = SearchAccount {
        claim: options.claim.clone(),
        variant: None,
        seed: options.seed,
        found: None,
        tries: Tries::default(),
        known: known(derivation, printed, options)?,
    };
    let mut next = 0;
    while next < options.tries && limits.total.left() > 0 && !families.is_empty() && !names.is_empty() {
        let numbers: Vec<usize> = (next..options.tries.min(next + BATCH)).collect();
        next += numbers.len();
        let drawn: Vec<Option<Draft>> = numbers.iter().map(|&n| draw(&families, options.seed, n)).collect();
        let drafts: Vec<Draft> = drawn.iter().flatten().cloned().collect();
        let mut verdicts = trial.verdicts(&drafts)?.into_iter();
        for (&number, draft) in numbers.iter().zip(&drawn) {
            let verdict = draft.as_ref().and_then(|_| verdicts.next()).flatten();
            let (Some(draft), Some((_, verdict))) = (draft, verdict) else {
                out.tries.impossible += 1;
                continue;
            };
            match verdict.outcome() {
                Outcome::Holds(_) => out.tries.holds += 1,
                Outcome::NotApplicable(_) => out.tries.not_applicable += 1,
                Outcome::Undecided => out.tries.undecided += 1,
                Outcome::Fails(_) => {
                    out.tries.fails += 1;
                    let family = families.iter().find(|f| f.from == draft.from).unwrap_or(draft);
                    let simple = trial.simpler(draft.clone(), family)?;
                    let Some((claim, verdict)) = trial.fails(&simple)? else {
                        return Err(CheckError::Defect("what was simplified does not fail any more".to_owned()));
                    };
                    let declared = derivation.claims.iter().find(|c| c.name() == claim);
                    let listed = declared.is_some_and(|c| c.names_trajectories);
                    let from = simple.from.clone();
                    let (table, changed) = (simple.table(&id), simple.changed(family));
                    out.found = Some(FailingMotion { number, claim, from, table, id, changed, verdict, listed });
                    return Ok(out);
                }
            }
        }
        progress(next, options.tries);
    }
    Ok(out)
}

/// The trajectories of the file on which the claim fails; of an altered claim, where it does not fail as printed.
fn known(
    derivation: &Derivation,
    printed: Option<&Derivation>,
    options: &SearchOptions,
) -> Result<Vec<String>, CheckError> {
    let own = match printed {
        Some(printed) => known(printed, None, options)?,
        None => Vec::new(),
    };
    let mut copy = derivation.clone();
    copy.measures.clear();
    let claim = options.claim.split('/').next().unwrap_or_default().to_owned();
    let of_claim = Options { claims: vec![claim], plain: true, ..Options::default() };
    let account = Run::new(&copy, &of_claim).account()?;
    let meant = |c: &&findings::ClaimAccount| c.id == options.claim || name(c) == options.claim;
    let mut out: Vec<String> = Vec::new();
    for pair in account.claims.iter().filter(meant).flat_map(|c| &c.results) {
        if matches!(pair.verdict.outcome(), Outcome::Fails(_)) && !out.contains(&pair.trajectory) {
            out.push(pair.trajectory.clone());
        }
    }
    out.retain(|t| !own.contains(t));
    Ok(out)
}

/// An id that the file does not have yet, and that no other begins with.
pub(super) fn fresh_id(derivation: &Derivation, claim: &str, variant: Option<usize>, seed: u64) -> String {
    let claim: String = claim.chars().take(60).map(|c| if c == '/' { '-' } else { c }).collect();
    let variant = variant.map(|n| format!("-variant-{n}")).unwrap_or_default();
    let mut id = format!("against-{claim}{variant}-{seed}");
    while derivation.trajectories.iter().any(|t| t.id.starts_with(&id)) {
        id.push('x');
    }
    id
}
