//! A derivation, checked: the methods in their order, and what is known from before.
//!
//! **In:** a [`Derivation`]. **Out:** an [`Account`]: one verdict for every claim on every trajectory, with its evidence.
//!
//! The order of work: claims are compiled (`claim`), all that they will ask of motions is collected, and the motions are built and
//! sampled (`sampled`); each claim is tried on each; what claims say for all values is proved (`proved`), and lends its strength
//! (`premises`); verdicts are enclosed (`enclosed`) and weighed (`weight`). Claims over ranges (`boxes`) and on families (`families`) go
//! beside. Motions are independent of one another and are tried in parallel; the result does not depend on how many threads there are.
//!
//! **Guaranteed:** no evidence is found here, and no method calls another. What is known from before, by content, is asked at one seam,
//! [`Recall`](sampled::recall::Recall).

#![forbid(unsafe_code)]

use ::{derivation, diag, expr, findings, flow, latex, number, verdict};

mod cache;
mod follow;
mod memory;
mod motions;
mod picture;
mod premises;
pub mod search;

pub use ::proof as identity;
pub use ::units;
pub use cache::Cache;
pub use claim::error::CheckError;
pub use claim::limits::{Cancel, Limits};
pub use claim::options::{Options, Rigor};
pub use families as family;
use families::{Checker, Families, Joined};
use findings::conditions::ConditionName;
#[cfg(debug_assertions)]
#[doc(hidden)]
pub use findings::sample;
pub use findings::{
    Account, Alone, Certificate, ClaimAccount, ClassCount, Cofactor, Correction, Counterexample, Discrimination,
    EditClass, Erratum, IdentityAccount, IdentityEvidence, Judged, Line, LineKind, Measurement, Origin, PairAccount,
    PictureAccount, Place, Proposition, SEED, Summary, Survivor, TrajectoryAccount, Trials, VariantAccount, WEAK,
    family::{FailingShare, FamilyAccount, MemberAccount},
    standing,
};
pub use proved::agreement::agree;
pub use proved::proposition::{prove, with_symbols_of};
use sampled::prepared::Prepared;
pub use verdict::{
    Enclosed, Evidence, Exclusion, Finding, Outcome, Possible, Proof, Residual, ResidualPoint, Residuals, Strength,
    Verdict, Witness,
};
pub use weight::separation;
pub use weight::variant::{AlteredFormula, Sameness, altered_formulas, says_the_same};

use claim::error::CANCELLED;
use claim::program::Program;
use derivation::{Claim, Derivation};
use expr::Rational;
use flow::Motion;
use memory::Known;
use premises::{Column, counterexample, strengthen};
use proved::step::Step;
use rayon::prelude::*;
use sampled::course::{Course, Trial};
use sampled::independence::Gradients;
use sampled::stage::{Requests, Stage};
use sampled::systems::Fields;
use sampled::trial::try_claim;
use sampled::{measure, same_motion, witness};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use weight::separation::Probes;
use weight::variant::{self, Altered, Found, Places, Weighed};

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
    check_recalling(derivation, options, Known::default(), None, progress)
}

/// The verdicts on a family whose members were counted in parts: what [`check()`] finds with the options `trajectories = [FAMILY]` and
/// `plain`.
///
/// # Errors
/// As for [`check()`]; a member that is shown is not what its part says.
pub fn check_joined(
    derivation: &mut Derivation,
    joined: &Joined,
    limits: &Limits,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Result<Account, CheckError> {
    let trajectories = vec![joined.id(derivation).to_owned()];
    let options = Options { trajectories, plain: true, limits: limits.clone(), ..Options::default() };
    check_recalling(derivation, &options, Known::default(), Some(joined), progress)
}

/// [`check()`], with what is known from before.
fn check_recalling(
    derivation: &mut Derivation,
    options: &Options,
    recall: Known,
    joined: Option<&Joined>,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Result<Account, CheckError> {
    let families = Families::of(derivation, options)?;
    let mut account = check_and(derivation, options, &[], !options.plain, recall, progress)?;
    if let Some(families) = families {
        account.distributions = families.try_all(&Trajectories, options, &mut account.claims, joined, progress)?;
    }
    account.units = units::units(derivation);
    account.units.keep(&options.claims);
    Ok(account)
}

/// The accounts of the claims that are asked for, beside others that are known from before: these are premises as if they
/// had been tried again.
fn check_beside(
    derivation: &mut Derivation,
    options: &Options,
    known: &[ClaimAccount],
    recall: Known,
) -> Result<Vec<ClaimAccount>, CheckError> {
    let families = Families::of(derivation, options)?;
    let mut claims = check_and(derivation, options, known, true, recall, &|_, _| {})?.claims;
    if let Some(families) = families {
        families.try_all(&Trajectories, options, &mut claims, None, &|_, _| {})?;
    }
    Ok(claims)
}

/// Members of families, tried as trajectories.
struct Trajectories;

impl Checker for Trajectories {
    fn check(
        &self,
        derivation: &mut Derivation,
        options: &Options,
        separating: bool,
    ) -> Result<Vec<ClaimAccount>, CheckError> {
        check_and(derivation, options, &[], separating, Known::default(), &|_, _| {}).map(|account| account.claims)
    }

    fn conditions(&self, derivation: &mut Derivation, names: &[ConditionName]) -> Vec<Option<Claim>> {
        separation::as_claims(derivation, names)
    }
}

/// The verdicts alone: neither what separates trajectories, nor units.
fn check_claims(
    derivation: &mut Derivation,
    options: &Options,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Result<Account, CheckError> {
    check_and(derivation, options, &[], false, Known::default(), progress)
}

/// The verdicts, and, where that is asked for, what separates the trajectories.
fn check_and(
    derivation: &mut Derivation,
    options: &Options,
    known: &[ClaimAccount],
    separating: bool,
    recall: Known,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Result<Account, CheckError> {
    let unless_cancelled =
        || if options.limits.is_cancelled() { Err(CheckError::Defect(CANCELLED.to_owned())) } else { Ok(()) };
    let chosen = |list: &[String], id: &str| list.is_empty() || list.iter().any(|x| x == id);
    // What is about ranges needs no motion.
    let regions = |derivation: &Derivation| {
        boxes::decide_all(derivation, |c| chosen(&options.claims, &c.id)).map_err(CheckError::Problems)
    };
    let motionless = derivation.trajectories.is_empty() && derivation.systems.is_empty();
    if derivation.scope.time().is_none() && motionless && !derivation.claims.iter().any(Claim::is_of_fields) {
        let mut claims: Vec<ClaimAccount> = regions(derivation)?.into_iter().map(|(_, c)| c).collect();
        if !options.plain {
            variant::weigh_still(derivation, &mut claims, &options.limits);
        }
        return Ok(Account { claims, ..Account::default() });
    }
    let fields = match Fields::solve(derivation) {
        Ok(fields) => fields,
        // Problems of ranges are told first.
        Err(problems) => return Err(regions(derivation).err().unwrap_or(CheckError::Problems(problems))),
    };

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
    let claimed: Vec<usize> = claimed.into_iter().filter(|&c| !derivation.claims[c].is_over_ranges()).collect();
    let mut programs: Vec<Vec<Program>> = Vec::new();
    let mut gradients = Vec::new();
    for &c in &claimed {
        programs.push(starts.iter().map(|s| Program::new(derivation, c, s)).collect());
        gradients.push(Gradients::of_claim(derivation, c, &fields));
    }
    let tried: Vec<usize> = (0..derivation.trajectories.len())
        .filter(|&t| chosen(&options.trajectories, &derivation.trajectories[t].id))
        .collect();
    // What they will be asked on the same motions is known before these are built.
    let mut probes = if separating { Probes::new(derivation, &claimed, &tried, &starts) } else { Probes::default() };
    let measures = measure::compile(derivation, options.claims.is_empty());
    let sign = derivation.scope.branch_sign();
    let altered = || (!options.plain).then(|| Altered::new(derivation, &claimed, &starts));
    let (mut altered, regions) = rayon::join(altered, || regions(derivation));
    let regions = regions?;
    let pictures = if options.claims.is_empty() && !options.plain { picture::leaves(derivation) } else { Vec::new() };

    let mut wanted: Vec<_> = programs.iter().flatten().flat_map(|p| p.leaves(&derivation.graph)).collect();
    wanted.extend(probes.programs().flat_map(|p| p.leaves(&derivation.graph)));
    wanted.extend(gradients.iter().flatten().flatten().flat_map(|g| g.leaves(&derivation.graph)));
    wanted.extend(measures.iter().flat_map(|m| m.leaves(&derivation.graph)));
    wanted.extend(same_motion::leaves(derivation));
    wanted.extend(altered.iter().flat_map(|a| a.leaves(derivation, starts.len(), sign)));
    wanted.extend(&pictures);
    wanted.sort_unstable();
    wanted.dedup();
    recall.asks(derivation, &claimed, |k| {
        let of_claim = programs[k].iter().chain(probes.without(k)).flat_map(|p| p.leaves(&derivation.graph));
        let gradients = gradients[k].iter().flatten().flat_map(|g| g.leaves(&derivation.graph));
        let altered = altered.iter().flat_map(|a| a.leaves_of(k, starts.len()));
        of_claim.chain(gradients).chain(altered).collect()
    });
    for program in programs.iter_mut().flatten().chain(probes.programs_mut()) {
        if let Err(leaf) = program.compile(&mut derivation.graph, &wanted) {
            let name = derivation.graph.leaf_latex(leaf);
            return Err(CheckError::Defect(format!("{name} is needed by a claim, but was not asked for")));
        }
    }
    if let Some(altered) = &mut altered {
        altered.compile(starts.len(), sign, &wanted);
    }
    let measures: Vec<_> = measures.into_iter().map(|m| m.tape(&mut derivation.graph, &wanted)).collect();
    let derivation: &Derivation = derivation;
    let mut claims: Vec<&Claim> = claimed.iter().map(|&c| &derivation.claims[c]).collect();
    let mut compiled: Vec<&[Program]> = programs.iter().map(Vec::as_slice).collect();
    for (claim, programs) in probes.asked() {
        claims.push(claim);
        compiled.push(programs);
    }
    let requests = Requests {
        settled: false,
        part: !options.claims.is_empty(),
        wanted: &wanted,
        tried: &tried,
        claims: &claims,
        programs: &compiled,
        start_of: &start_of,
        measured: &|derivation, t| measure::searched(&measures, derivation, t),
        limits: &options.limits,
    };
    unless_cancelled()?;
    let stage = Stage::build(derivation, &fields, &requests, &recall)?;
    unless_cancelled()?;
    // What is said of all motions together is not said where some are missing.
    let complete = tried.iter().all(|&t| stage.motion(t).is_some());
    let mut prepared: Vec<Vec<Prepared>> = Vec::new();
    for (k, per_start) in programs.into_iter().enumerate() {
        let claim = &derivation.claims[claimed[k]];
        let one = |program| Prepared { claim, program, gradients: gradients[k].clone() };
        prepared.push(per_start.into_iter().map(one).collect());
    }
    let mut kept: Vec<usize> = probes.asked_later().collect();
    kept.extend(same_motion::leaves(derivation).into_iter().filter_map(|leaf| wanted.binary_search(&leaf).ok()));
    kept.sort_unstable();
    kept.dedup();
    let done = AtomicUsize::new(0);
    let failed: Vec<AtomicBool> = prepared.iter().map(|_| AtomicBool::new(false)).collect();
    let column = |t: usize| -> Result<Tried, String> {
        if options.limits.is_cancelled() {
            return Err(CANCELLED.to_owned());
        }
        if let (None, Some(reached)) = (stage.motion(t), options.limits.reached()) {
            let open = |k: &usize| derivation.claims[*k].trajectories.contains(&t);
            let open = claimed.iter().map(|k| open(k).then(|| Verdict::of(Finding::open(reached)))).collect();
            return Ok(((open, Shown::default()), (Vec::new(), (None, None))));
        }
        // Where the two routes to the values of a motion disagree, no claim has a verdict on it; the others have theirs.
        let (mut course, contradiction) = stage.course(&derivation.graph, t, &wanted)?;
        let verdict = |k: usize| {
            let Prepared { claim, program, gradients } = &prepared[k][start_of[t]];
            claim.trajectories.contains(&t).then(|| {
                if let Some(reached) = options.limits.reached() {
                    return Verdict::of(Finding::open(reached));
                }
                let trial = Trial { graph: &derivation.graph, claim, program, course: &course, shown: true };
                let mut verdict =
                    recall.verdict(derivation, claim, t, || try_claim(derivation, &trial, gradients.as_ref()));
                if let Some(contradiction) = &contradiction {
                    verdict.contradict(contradiction.clone());
                }
                verdict
            })
        };
        let verdicts: Vec<Option<Verdict>> = (0..prepared.len()).map(verdict).collect();
        let fails = |v: &Option<Verdict>| v.as_ref().is_some_and(|v| matches!(v.outcome(), Outcome::Fails(_)));
        verdicts.iter().zip(&failed).filter(|(v, _)| fails(v)).for_each(|(_, f)| f.store(true, Ordering::Relaxed));
        // The motion is at hand now. Whether it is asked depends on the others, too: most claims that fail do so on the first.
        let of = (start_of[t], &course);
        let without = probes.without_each(derivation, &gradients, of, &verdicts, (&failed, &recall));
        let found = |(k, verdict): (usize, &'_ Option<Verdict>)| {
            let Prepared { claim, program, .. } = &prepared[k][start_of[t]];
            verdict.clone().map(|verdict| Found { claim, program, verdict })
        };
        let weighed = altered.as_ref().map(|altered| {
            let late = options.limits.reached().is_some();
            let found: Vec<Option<Found>> = verdicts.iter().enumerate().map(|of| found(of).filter(|_| !late)).collect();
            altered.weigh(&derivation.graph, start_of[t], &course, &found)
        });
        let measured = measures.iter().filter_map(|m| m.take(derivation, &course)).collect();
        let drawn = if pictures.is_empty() { Vec::new() } else { picture::draw(derivation, &course) };
        progress(done.fetch_add(1, Ordering::Relaxed) + 1, tried.len());
        // What is asked later needs few of the leaves; those of all motions at once take much memory.
        course.keep(&kept);
        let course = (!probes.is_empty() || altered.is_some()).then_some(course);
        Ok(((verdicts, (measured, drawn)), (without, (weighed, course))))
    };
    // Long motions first: what is left at the end is short.
    let mut order: Vec<usize> = (0..tried.len()).collect();
    order.sort_by_key(|&at| std::cmp::Reverse(stage.motion(tried[at]).map_or(0, Motion::steps)));
    let found = order.par_iter().with_max_len(1).map(|&at| column(tried[at]));
    let mut columns: Vec<_> = order.iter().zip(found.collect::<Vec<_>>()).collect();
    columns.sort_by_key(|(at, _)| **at);
    let columns = columns.into_iter().map(|(_, column)| column);
    let columns = columns.collect::<Result<Vec<_>, String>>().map_err(CheckError::Defect)?;
    let (found, (without, others)): (Vec<_>, (Vec<_>, Vec<_>)) = columns.into_iter().unzip();
    let (weighed, courses): (Vec<Option<Weighed>>, Vec<_>) = others.into_iter().unzip();
    let (columns, shown): (Vec<Column>, Vec<_>) = found.into_iter().unzip();
    unless_cancelled()?;
    let mut account = assemble(derivation, &stage, &claimed, &tried, &columns, shown);
    let courses: Vec<Course> = courses.into_iter().flatten().collect();
    let identity = |k: usize| -> Option<Result<IdentityAccount, String>> {
        let claim = &derivation.claims[claimed[k]];
        if options.limits.reached().is_some() {
            return None;
        }
        let step = Step::of(derivation, claim)?.with(options.plain);
        match counterexample(derivation, claim, k, &claimed, known, &tried, &columns) {
            Some((t, witness)) => Some(Ok(step.refuted_by(&derivation.trajectories[t].id, witness))),
            None => recall.identity(derivation, claim, || step.decide()),
        }
    };
    let identities: Vec<_> = (0..claimed.len()).into_par_iter().with_max_len(1).map(identity).collect();
    for (claim, identity) in account.claims.iter_mut().zip(identities) {
        claim.identity = identity.transpose().map_err(CheckError::Defect)?;
    }
    unless_cancelled()?;
    if complete {
        probes.separate(derivation, &without, &start_of, &recall, &courses, &mut account);
    }
    strengthen(derivation, &mut account.claims, &claimed, known, &tried, &options.limits);
    if options.rigor == Rigor::Enclosed && options.limits.reached().is_none() {
        let (prepared, start_of, tried) = (&prepared, &start_of, &tried);
        let (fields, stage, limits) = (&fields, &stage, &options.limits);
        let request = enclosed::Request { derivation, fields, stage, prepared, start_of, tried, limits };
        enclosed::strengthen(&request, &mut account.claims);
    }
    unless_cancelled()?;
    let (prepared, start_of, tried_on) = (&prepared, &start_of, &tried);
    let altered = altered.filter(|_| complete);
    let points = witness::Points { derivation, stage: &stage, prepared, start_of, tried: tried_on, wanted: &wanted };
    witness::complete(&points, &mut account.claims);
    unless_cancelled()?;
    if let Some(altered) = &altered {
        let weighed: Vec<Weighed> = weighed.into_iter().flatten().collect();
        let places = Places { claimed: &claimed, tried: &tried, starts: &starts, start_of };
        altered.conclude(derivation, &mut account.claims, &weighed, &places, &courses)?;
    }
    // They are large.
    rayon::join(|| drop(altered), || drop(courses));
    // Back to the order of the file.
    for (earlier, (at, of)) in regions.into_iter().enumerate() {
        let before = claimed.iter().filter(|&&c| c < at).count();
        account.claims.insert(before + earlier, of);
    }
    if !options.plain {
        variant::weigh_still(derivation, &mut account.claims, &options.limits);
    }
    Ok(account)
}

/// What was measured and drawn on one motion.
type Shown = (Vec<Measurement>, Vec<PictureAccount>);

/// A column; the verdicts without each assumption; what it says of the variants, and the motion where it is needed again.
type Tried<'a> = ((Column, Shown), (Vec<Option<Verdict>>, (Option<Weighed>, Option<Course<'a>>)));

/// Puts the columns together into the account.
fn assemble(
    derivation: &Derivation,
    stage: &Stage,
    claimed: &[usize],
    tried: &[usize],
    columns: &[Column],
    shown: Vec<Shown>,
) -> Account {
    let mut claims = Vec::new();
    for (k, &c) in claimed.iter().enumerate() {
        let claim = &derivation.claims[c];
        let pair = |(column, &t): (&Column, &usize)| {
            let verdict = column[k].clone()?;
            let expected = claim.trajectories.iter().position(|&x| x == t).and_then(|i| claim.expect[i]);
            Some(PairAccount {
                trajectory: derivation.trajectories[t].id.clone(),
                verdict,
                expected,
                discrimination: None,
            })
        };
        claims.push(ClaimAccount::of(claim, columns.iter().zip(tried).filter_map(pair).collect()));
    }
    let trajectories = tried.iter().filter_map(|&t| stage.account(derivation, t)).collect();
    let (mut measurements, mut pictures) = (Vec::new(), Vec::new());
    for (measured, drawn) in shown {
        measurements.extend(measured);
        pictures.extend(drawn);
    }
    let order = |m: &Measurement| derivation.measures.iter().position(|x| x.id == m.measure);
    measurements.sort_by_key(order);
    let (distributions, units) = Default::default();
    Account { trajectories, claims, measurements, distributions, pictures, units }
}
