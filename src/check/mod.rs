//! Claims against trajectories: the only room that can make a [`Verdict`].
//!
//! **In:** a [`Derivation`]. **Out:** an [`Account`]: one verdict for every claim on every trajectory, with its evidence.
//!
//! The order of work: `program` turns every form of claim into comparisons; `stage` turns trajectories into motions;
//! `trial` measures the comparisons at the points of a motion; `weigh` makes the verdict; `step` asks what holds for all
//! values, see [`identity`]. Motions are independent of one another
//! and are tried in parallel; the result does not depend on how many threads there are.
//!
//! **Guaranteed:** a residual is judged against its own propagated error bound, never against a tolerance alone; values
//! computed with dual numbers must lie within the bounds that were propagated separately, or the run stops as defective.

mod account;
mod comparison;
mod describe;
pub mod identity;
mod independence;
mod limit;
mod measure;
mod occurrence;
mod program;
mod same_motion;
#[cfg(test)]
pub(crate) mod sample;
mod stage;
mod step;
mod trial;
mod variant;
mod verdict;
mod weigh;

pub use account::{Account, ClaimAccount, IdentityAccount, Measurement, PairAccount, Summary, TrajectoryAccount};
pub use variant::{
    AlteredFormula, ClassCount, Correction, Discrimination, EditClass, Erratum, SEED, Survivor, VariantAccount, WEAK,
    altered_formulas, says_the_same,
};
pub use verdict::{Evidence, Exclusion, Outcome, Residual, Strength, Verdict, Witness};

use crate::derivation::{Claim, Derivation, Form};
use crate::diag::Diagnostic;
use crate::expr::Rational;
use crate::latex::RelationKind;
use independence::Gradients;
use program::Program;
use rayon::prelude::*;
use stage::{Fields, Requests, Stage};
use step::Step;
use trial::{Course, Events};
use variant::{Altered, Found, Places, Weighed};

/// What to check.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct Options {
    /// Only claims with these ids; all when empty.
    pub claims: Vec<String>,
    /// Only trajectories with these ids; all when empty.
    pub trajectories: Vec<String>,
    /// No variants: the verdicts alone.
    pub plain: bool,
}

/// Why a check could not be made.
#[derive(Clone, Debug, PartialEq)]
pub enum CheckError {
    /// Problems in the derivation file.
    Problems(Vec<Diagnostic>),
    /// The program contradicts itself: a defect to be reported.
    Defect(String),
}

/// A claim with everything that is compiled for it.
struct Prepared<'a> {
    claim: &'a Claim,
    program: Program,
    gradients: Option<Result<Gradients, String>>,
}

/// Tries every claim on every trajectory.
///
/// `progress` is told how many of how many trajectories are done.
///
/// # Errors
/// [`CheckError::Problems`] for systems that cannot be solved for their rates and trajectories that cannot be built;
/// [`CheckError::Defect`] when two independent computations of the same value disagree.
pub fn check(
    derivation: &mut Derivation,
    options: &Options,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Result<Account, CheckError> {
    let chosen = |list: &[String], id: &str| list.is_empty() || list.iter().any(|x| x == id);
    let fields = Fields::solve(derivation).map_err(CheckError::Problems)?;

    // One program per claim and initial time: the value "at the start" is part of what a first integral says.
    let mut starts: Vec<Rational> = Vec::new();
    let start_of: Vec<usize> = derivation
        .trajectories
        .iter()
        .map(|t| {
            let start = Rational::try_from(t.initial_time).unwrap_or(Rational::ZERO);
            starts.iter().position(|s| *s == start).unwrap_or_else(|| {
                starts.push(start);
                starts.len() - 1
            })
        })
        .collect();
    let claimed: Vec<usize> =
        (0..derivation.claims.len()).filter(|&c| chosen(&options.claims, &derivation.claims[c].id)).collect();
    let mut programs: Vec<Vec<Program>> = Vec::new();
    let mut gradients = Vec::new();
    for &c in &claimed {
        programs.push(starts.iter().map(|s| Program::new(derivation, c, s)).collect());
        let variables = fields.state_leaves.clone();
        let claim = derivation.claims[c].clone();
        gradients.push(claim.forms.iter().find_map(|form| {
            match form {
                Form::Independent { functions, subject_to } => Some(
                    Gradients::new(&mut derivation.graph, &claim.scope, &variables, functions, subject_to)
                        .map_err(|e| e.to_string()),
                ),
                _ => None,
            }
        }));
    }
    let measures = measure::compile(derivation, options.claims.is_empty());
    let sign = derivation.scope.branch_sign();
    let mut altered = (!options.plain).then(|| Altered::new(derivation, &claimed, &starts));

    let mut wanted: Vec<_> = programs.iter().flatten().flat_map(|p| p.leaves(&derivation.graph)).collect();
    wanted.extend(gradients.iter().flatten().flatten().flat_map(|g| g.leaves(&derivation.graph)));
    wanted.extend(measures.iter().flat_map(|m| m.leaves(&derivation.graph)));
    wanted.extend(same_motion::leaves(derivation));
    wanted.extend(altered.iter().flat_map(|a| a.leaves(starts.len(), sign)));
    wanted.sort_unstable();
    wanted.dedup();
    for program in programs.iter_mut().flatten() {
        if let Err(leaf) = program.compile(&mut derivation.graph, &wanted) {
            let name = derivation.graph.leaf_latex(leaf);
            return Err(CheckError::Defect(format!("{name} is needed by a claim, but was not asked for")));
        }
    }
    if let Some(altered) = &mut altered {
        altered.compile(starts.len(), sign, &wanted);
    }
    let tried: Vec<usize> = (0..derivation.trajectories.len())
        .filter(|&t| chosen(&options.trajectories, &derivation.trajectories[t].id))
        .collect();
    let measures: Vec<_> = measures.into_iter().map(|m| m.tape(&mut derivation.graph, &wanted)).collect();
    let derivation: &Derivation = derivation;
    let requests = Requests {
        wanted: &wanted,
        tried: &tried,
        claimed: &claimed,
        programs: &programs,
        start_of: &start_of,
        measures: &measures,
    };
    let stage = Stage::build(derivation, &fields, &requests)?;
    let mut prepared: Vec<Vec<Prepared>> = Vec::new();
    for (k, per_start) in programs.into_iter().enumerate() {
        let claim = &derivation.claims[claimed[k]];
        let one = |program| Prepared { claim, program, gradients: gradients[k].clone() };
        prepared.push(per_start.into_iter().map(one).collect());
    }
    let done = std::sync::atomic::AtomicUsize::new(0);
    let columns: Vec<Result<(Column, Option<Weighed>), String>> = tried
        .par_iter()
        .map(|&t| {
            let course = stage.course(&derivation.graph, t, &wanted)?;
            let verdict = |k: usize| {
                let Prepared { claim, program, gradients } = &prepared[k][start_of[t]];
                claim.trajectories.contains(&t).then(|| {
                    let none = Events::default();
                    let events = stage.events(k, t).unwrap_or(&none);
                    one_pair(derivation, claim, program, gradients.as_ref(), &course, events)
                })
            };
            let verdicts: Vec<Option<Verdict>> = (0..prepared.len()).map(verdict).collect();
            let found = |(k, verdict): (usize, &'_ Option<Verdict>)| {
                let Prepared { claim, program, .. } = &prepared[k][start_of[t]];
                let events = stage.events(k, t).unwrap_or(const { &Events { at: None, occurrences: Vec::new() } });
                verdict.clone().map(|verdict| Found { claim, program, events, verdict })
            };
            let weighed = altered.as_ref().map(|altered| {
                let found: Vec<Option<Found>> = verdicts.iter().enumerate().map(found).collect();
                altered.weigh(start_of[t], &course, &found)
            });
            let measured = measures.iter().filter_map(|m| m.take(derivation, &course)).collect();
            progress(done.fetch_add(1, std::sync::atomic::Ordering::Relaxed) + 1, tried.len());
            Ok(((verdicts, measured), weighed))
        })
        .collect();
    let columns = columns.into_iter().collect::<Result<Vec<_>, String>>().map_err(CheckError::Defect)?;
    let (columns, weighed): (Vec<Column>, Vec<Option<Weighed>>) = columns.into_iter().unzip();
    let identities: Vec<Option<IdentityAccount>> = (0..claimed.len())
        .into_par_iter()
        .map(|k| {
            let claim = &derivation.claims[claimed[k]];
            let step = Step::of(derivation, claim)?;
            match counterexample(derivation, claim, k, &claimed, &tried, &columns) {
                Some((t, witness)) => Some(step.refuted_by(&derivation.trajectories[t].id, witness)),
                None => step.decide(),
            }
        })
        .collect();
    let mut account = assemble(derivation, &stage, &claimed, &tried, columns, identities);
    strengthen(derivation, &mut account.claims, &claimed, &tried).map_err(CheckError::Defect)?;
    if let Some(altered) = &altered {
        let weighed: Vec<Weighed> = weighed.into_iter().flatten().collect();
        let places = Places { claimed: &claimed, tried: &tried, starts: &starts, start_of: &start_of };
        altered.conclude(derivation, &mut account.claims, &weighed, &places)?;
    }
    Ok(account)
}

/// A motion on which everything holds that a claim is said to follow from, and the claim fails.
fn counterexample<'a>(
    derivation: &Derivation,
    claim: &Claim,
    k: usize,
    claimed: &[usize],
    tried: &[usize],
    columns: &'a [Column],
) -> Option<(usize, &'a Witness)> {
    let given = Step::given(derivation, claim);
    columns.iter().zip(tried).find_map(|((verdicts, _), &t)| {
        let verdict = verdicts[k].as_ref().filter(|v| matches!(v.outcome(), Outcome::Fails(_)))?;
        let holds = |name: &String| match derivation.systems.iter().position(|s| s.id == *name) {
            Some(system) => is_integrated_from(derivation, t, system),
            None => claimed.iter().zip(verdicts).any(|(&c, v)| {
                let other = &derivation.claims[c];
                (other.id == *name || other.name() == *name)
                    && v.as_ref().is_some_and(|v| matches!(v.outcome(), Outcome::Holds(_)))
            }),
        };
        if given.iter().all(holds) { Some((t, verdict.evidence().witness.as_ref()?)) } else { None }
    })
}

/// Whether a trajectory was integrated from a system: then its equations hold on it.
fn is_integrated_from(derivation: &Derivation, trajectory: usize, system: usize) -> bool {
    let motion = &derivation.trajectories[trajectory].motion;
    matches!(motion, crate::derivation::Motion::Integrated { system: of, .. } if *of == system)
}

/// What was found on one motion: a verdict for every claim that is tried on it, and measurements.
type Column = (Vec<Option<Verdict>>, Vec<Measurement>);

/// The verdict of one claim on one motion.
fn one_pair(
    derivation: &Derivation,
    claim: &Claim,
    program: &Program,
    gradients: Option<&Result<Gradients, String>>,
    course: &Course,
    events: &Events,
) -> Verdict {
    let mut verdicts = Vec::new();
    if !program.groups.is_empty() {
        verdicts.push(trial::try_claim(&derivation.graph, claim, program, course, events));
    }
    for form in &claim.forms {
        match form {
            Form::SameMotion { other, of } => {
                verdicts.push(same_motion::try_on(derivation, claim, program, course, *other, of));
            }
            Form::Independent { .. } => verdicts.push(match gradients {
                Some(Ok(g)) => g.try_on(&derivation.graph, claim, program, course),
                Some(Err(reason)) => undecided(reason.clone()),
                None => undecided("no gradients were computed".to_owned()),
            }),
            _ => {}
        }
    }
    let verdict = trial::all_of(verdicts);
    // What was not reached was not tried.
    match (course.motion.problem(), verdict.outcome()) {
        (Some(problem), Outcome::Holds(_)) => {
            let evidence = Evidence { reason: Some(format!("{problem}")), ..verdict.evidence().clone() };
            Verdict::new(Outcome::Undecided, evidence)
        }
        _ => verdict,
    }
}

fn undecided(reason: String) -> Verdict {
    Verdict::new(Outcome::Undecided, Evidence { reason: Some(reason), ..Evidence::default() })
}

/// Gives verdicts the strength of the proofs behind them, and compares the two.
///
/// A verdict is `proved` when the claim follows for all values from systems that the trajectory was integrated from, or from
/// claims that are themselves `proved` on it; equations among its assumptions were only sampled, so that they leave it
/// `sampled`, and so do proofs that leave out special cases.
///
/// # Errors
/// A description of a claim that is proved and fails.
fn strengthen(
    derivation: &Derivation,
    claims: &mut [ClaimAccount],
    claimed: &[usize],
    tried: &[usize],
) -> Result<(), String> {
    // Each round may prove claims that follow from those of the round before.
    loop {
        let mut ready: Vec<(usize, usize)> = Vec::new();
        for (k, &c) in claimed.iter().enumerate() {
            let Some(identity) = claims[k].identity.as_ref().filter(|i| i.verdict == "proved" && !i.generic) else {
                continue;
            };
            let equations = |s: &crate::latex::Statement| s.relations.iter().any(|r| r.kind == RelationKind::Equal);
            if derivation.claims[c].assuming.iter().any(|w| equations(&w.value)) {
                continue;
            }
            for (at, pair) in claims[k].results.iter().enumerate() {
                let Some(&t) = tried.iter().find(|&&t| derivation.trajectories[t].id == pair.trajectory) else {
                    continue;
                };
                let given = |name: &String| {
                    let system = derivation.systems.iter().position(|s| s.id == *name);
                    if let Some(system) = system {
                        return is_integrated_from(derivation, t, system);
                    }
                    claims.iter().filter(|c| c.id == *name).any(|c| {
                        let pair = c.results.iter().find(|p| p.trajectory == pair.trajectory);
                        pair.is_some_and(|p| p.verdict.outcome() == Outcome::Holds(Strength::Proved))
                    })
                };
                if !identity.from.iter().all(given) {
                    continue;
                }
                match pair.verdict.outcome() {
                    Outcome::Holds(Strength::Sampled | Strength::Enclosed) => ready.push((k, at)),
                    Outcome::Fails(_) => {
                        return Err(format!("{} is proved, and fails on {}", claims[k].id, pair.trajectory));
                    }
                    _ => {}
                }
            }
        }
        if ready.is_empty() {
            return Ok(());
        }
        for (k, at) in ready {
            claims[k].results[at].verdict.proved();
        }
    }
}

/// Puts the columns together into the account.
fn assemble(
    derivation: &Derivation,
    stage: &Stage,
    claimed: &[usize],
    tried: &[usize],
    columns: Vec<Column>,
    identities: Vec<Option<IdentityAccount>>,
) -> Account {
    let mut claims = Vec::new();
    for ((k, &c), identity) in claimed.iter().enumerate().zip(identities) {
        let claim = &derivation.claims[c];
        let pair = |(column, &t): (&Column, &usize)| {
            let verdict = column.0[k].clone()?;
            let expected = claim.trajectories.iter().position(|&x| x == t).and_then(|i| claim.expect[i]);
            Some(PairAccount {
                trajectory: derivation.trajectories[t].id.clone(),
                verdict,
                expected,
                discrimination: None,
            })
        };
        claims.push(ClaimAccount {
            id: claim.id.clone(),
            reading: claim.reading.clone(),
            says: claim.says.clone(),
            place: claim.place.clone(),
            formulas: claim.formulas.iter().map(|f| f.text.clone()).collect(),
            assumptions: claim.assuming.iter().map(|w| w.text.clone()).collect(),
            remark: claim.remark.clone(),
            identity,
            results: columns.iter().zip(tried).filter_map(pair).collect(),
            variants: None,
        });
    }
    let trajectories = tried.iter().filter_map(|&t| stage.account(derivation, t)).collect();
    let mut measurements: Vec<Measurement> = columns.into_iter().flat_map(|(_, m)| m).collect();
    let order = |m: &Measurement| derivation.measures.iter().position(|x| x.id == m.measure);
    measurements.sort_by_key(order);
    Account { trajectories, claims, measurements }
}
