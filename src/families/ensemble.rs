//! A family with the claims that are tried on it: made once, for all members.
//!
//! **In:** a derivation as it was read, a family, its claims and measures. **Out:** what is counted over a run of numbers, members
//! tried again, and the boundaries on the maps. **Guaranteed:** a member is the trajectory that its text says, alone with these
//! claims: nothing that another member left behind changes it.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::RangeInclusive;
use std::sync::{Mutex, PoisonError};

use meter::{Limits, Task};
use rayon::prelude::*;

use super::account::Otherwise;
use super::beside::{Beside, compared_with};
use super::boundary::{self, Found, Width};
use super::budget::{Budget, MOST_BETWEEN, TOGETHER, WAVE};
use super::map::Scale;
use super::member::{Law, MOST_DRAWS, Member, Members};
use super::robustness::{WELL_WITHIN, are_plain, is_settled};
use crate::derivation::{Claim, Derivation, Form, Measure, NoOther, Spread, Trajectory};
use crate::diag::Diagnostic;
use crate::expr::{Leaf, Rational, Symbol};
use crate::findings::family::{Boundary, Distribution, Row, Slopes, Sums, Tally};
use crate::findings::{ClaimAccount, Measurement, PairAccount};
use crate::flow::{Estimation, Motion};
use crate::latex::RelationKind;
use crate::verdict::Verdict;
use claim::error::{CANCELLED, CheckError};
use claim::options::Options;
use claim::program::{Part, Program, What};
use proved::by_formula;
use reason::{Plain, Reason};
use sampled::claim_program::Prepared;
use sampled::independence::Gradients;
use sampled::measure::Compiled;
use sampled::pattern::Pattern;
use sampled::screen::Screens;
use sampled::setup::idle_angles;
use sampled::stage::{Requests, Stage};
use sampled::systems::Fields;
use sampled::trace::Trial;
use sampled::{measure, same_motion, trial, witness};

/// The counted work of a member beside that of its steps: its numbers, its motion.
const OF_A_MEMBER: u64 = 30_000;
/// The same of a step that is looked at again beside others, to tell its error.
const OF_A_STEP: u64 = 4_000;
/// The same of a step that tells its error itself.
const OF_A_STEP_ALONE: u64 = 1_000;
/// The same of what is measured on a member.
const OF_A_MEASURE: u64 = 1_000;
/// The same of one verdict beside what is evaluated for it.
const OF_A_VERDICT: u64 = 20_000;

/// A family with the claims that are tried on it, compiled once for all members.
pub struct Ensemble<'a> {
    members: &'a Members,
    /// The derivation with these claims alone, and one more trajectory: the member.
    derivation: Derivation,
    fields: Fields,
    programs: Vec<Vec<Program>>,
    /// What is measured on each member.
    measures: Vec<Compiled>,
    gradients: Vec<Option<Result<Gradients, Reason>>>,
    wanted: Vec<Leaf>,
    start_of: Vec<usize>,
    /// The position of the member among the trajectories.
    slot: usize,
    /// The motions that it is compared with, which follow it: the position of what varies, and which.
    beside: Vec<(usize, Beside)>,
    /// How the errors of members are estimated at first.
    estimation: Estimation,
    /// The angles that members need not be followed for.
    idle: Vec<Symbol>,
    /// What members are made after.
    pattern: Option<Pattern>,
    /// Why there is none, where that is what one member takes.
    too_much: Option<Reason>,
    /// The claims, as members are tried that nobody is shown.
    screens: Option<Screens>,
    /// Copies of the derivation in which members were, to be used again.
    spare: Mutex<Vec<Derivation>>,
}

/// Of so many members one has the values along its motion computed on both routes, and so have those that are shown: what is compared
/// is the program with itself, on a motion of the same system with other numbers.
const CROSS_CHECK: u64 = 64;

/// A derivation with a member, and whether the two routes to its values are compared.
type OfMember<'d> = (&'d Derivation, bool);

/// What was found on a member.
struct OnMember {
    verdicts: Vec<Verdict>,
    measured: Vec<Measurement>,
    steps: u64,
    /// Whether another estimate of its errors might change that.
    unsettled: bool,
}

/// What one number gave.
#[derive(Clone, Debug, Default)]
pub struct One {
    pub values: Option<Vec<f64>>,
    rejected: u64,
    steps: u64,
    pub verdicts: Vec<Verdict>,
    /// What was measured, in the order of the measures.
    pub measured: Vec<Measurement>,
}

impl<'a> Ensemble<'a> {
    pub fn new(
        derivation: &Derivation,
        members: &'a Members,
        asked: &[&Claim],
        measured: &[&Measure],
        limits: &Limits,
    ) -> Result<Ensemble<'a>, CheckError> {
        let base = derivation.trajectories[members.family.of].clone();
        let slot = derivation.trajectories.len();
        // What no member needs would be copied for each of them.
        let mut derivation = derivation.clone();
        derivation.families = <_>::default();
        let here = |m: &&Measure| Measure { trajectories: vec![slot], families: Vec::new(), ..(*m).clone() };
        derivation.measures = measured.iter().map(here).collect();
        derivation.conditions.clear();
        derivation.given.clear();
        derivation.pictures.clear();
        let start = Rational::try_from(base.initial_time).unwrap_or(Rational::ZERO);
        derivation.trajectories.push(base.clone());
        let mut beside: Vec<(usize, Beside)> = Vec::new();
        let compared = compared_with(&derivation, members, asked)?;
        let here = |claim: &&Claim| Claim { trajectories: vec![slot], expect: vec![None], ..(*claim).clone() };
        derivation.claims = asked.iter().map(here).collect();
        for (claim, compared) in derivation.claims.iter_mut().zip(compared) {
            let Some(Form::Across(across)) = claim.forms.first_mut() else { continue };
            for which in compared {
                let at = beside.iter().position(|b| *b == which).unwrap_or_else(|| {
                    beside.push(which);
                    beside.len() - 1
                });
                across.others.push(slot + 1 + at);
                claim.trajectories.push(slot + 1 + at);
                claim.expect.push(None);
            }
        }
        derivation.trajectories.extend(beside.iter().map(|_| base.clone()));
        // As in the file with the member pasted into it: the motions share the memory.
        let mut graph = derivation.graph.clone();
        let fields = Fields::solve(&mut graph, &derivation).map_err(CheckError::Problems)?;
        let Derivation { claims, trajectories, .. } = &derivation;
        // What varies is told apart in each member, whose motion knows what is equal there.
        let varied: Vec<Leaf> = members.family.vary.iter().map(|v| v.leaf).collect();
        let mut shared = derivation.shared_parameters(&base);
        shared.retain(|(leaf, other)| !varied.contains(leaf) && !varied.contains(other));
        let mut programs: Vec<Vec<Program>> = claims
            .iter()
            .map(|c| vec![Program::new(&mut graph, (&derivation).into(), c, &start).sharing(&shared)])
            .collect();
        let gradients: Vec<_> =
            claims.iter().map(|c| Gradients::of_claim(&mut graph, trajectories, c, &fields)).collect();
        let measures = measure::compile(&mut graph, &derivation);
        derivation.graph = graph;
        let graph = &derivation.graph;
        let mut wanted: Vec<Leaf> = programs.iter().flatten().flat_map(|p| p.leaves(graph)).collect();
        wanted.extend(gradients.iter().flatten().flatten().flat_map(|g| g.leaves(graph)));
        wanted.extend(measures.iter().flat_map(|m| m.leaves(graph)));
        wanted.extend(same_motion::leaves(&derivation));
        wanted.sort_unstable();
        wanted.dedup();
        for program in programs.iter_mut().flatten() {
            if let Err(leaf) = program.compile(&mut derivation.graph, &wanted) {
                let name = derivation.graph.leaf_latex(leaf);
                return Err(CheckError::Defect(format!("{name} is needed by a claim, but was not asked for")));
            }
        }
        let measures: Vec<Compiled> = measures.into_iter().map(|m| m.on(&derivation.graph, &wanted)).collect();
        let start_of = vec![0; derivation.trajectories.len()];
        // What is measured is shown with its error.
        let plain = measures.is_empty() && are_plain(&programs);
        let estimation = if plain { Estimation::Steps } else { Estimation::Companions };
        let idle = idle_angles(&derivation, &[slot], &wanted);
        let mut ensemble = Ensemble {
            members,
            derivation,
            fields,
            programs,
            measures,
            gradients,
            wanted,
            start_of,
            slot,
            beside,
            estimation,
            idle,
            pattern: None,
            too_much: None,
            screens: None,
            spare: Mutex::default(),
        };
        let mut graph = ensemble.derivation.graph.clone();
        let of_one =
            |requests: &Requests| Pattern::of(&ensemble.derivation, &ensemble.fields, requests, slot, &mut graph);
        ensemble.pattern = match meter::piece(Task::Members, limits, || ensemble.asking(limits, of_one)) {
            Ok(pattern) => pattern,
            // What is too much for one is too much for each.
            Err(ended) => {
                ensemble.too_much = Some(ended.into());
                None
            }
        };
        // What is told of a verdict that is not sampled alone, or measured, is not seen by such a look.
        let alone = ensemble.beside.is_empty() && ensemble.estimation == Estimation::Steps;
        ensemble.screens = ensemble.pattern.as_ref().filter(|_| alone).and_then(|pattern| {
            let Ensemble { derivation, programs, wanted, .. } = &ensemble;
            let claims = derivation.claims.iter().zip(programs.iter().map(Vec::as_slice));
            Screens::of(&graph, pattern, claims, wanted, WELL_WITHIN)
        });
        // Each member begins with a copy of it.
        graph.share();
        ensemble.derivation.graph = graph;
        Ok(ensemble)
    }

    /// The claims with what is compiled for them.
    fn prepared(&self) -> Vec<Vec<Prepared<'_>>> {
        let compiled = self.programs.iter().zip(&self.gradients);
        let each = self.derivation.claims.iter().zip(compiled).map(|(claim, (programs, gradients))| {
            let one = |program: &Program| Prepared { claim, program: program.clone(), gradients: gradients.clone() };
            programs.iter().map(one).collect()
        });
        each.collect()
    }

    /// Tries the members with some numbers, as far as the limits allow: what was counted of each claim, and why it stopped before
    /// the last. `each` is handed every member, in the order of their numbers.
    pub fn try_all(
        &self,
        numbers: RangeInclusive<u64>,
        options: &Options,
        budget: &mut Budget,
        progress: &(dyn Fn(usize, usize) + Sync),
        each: &mut dyn FnMut(&Row),
    ) -> Result<(Sums, Option<Reason>), CheckError> {
        let prepared = self.prepared();
        let claims = &self.derivation.claims;
        let scales = self.members.scales();
        let laws: Vec<Option<Law>> = claims.iter().map(|claim| self.members.law(claim)).collect();
        let map = vec![[0; 4]; scales.as_ref().map_or(0, cells)];
        let empty = |law: &Option<Law>| Tally {
            map: map.clone(),
            slopes: Slopes::empty(law.as_ref().map_or(0, |law| law.scale.axis.cells.len())),
            ..Tally::default()
        };
        let distributions = vec![Distribution::default(); self.derivation.measures.len()];
        let mut sums = Sums { tallies: laws.iter().map(empty).collect(), distributions };
        let (first, last) = numbers.into_inner();
        let mut next = first;
        while next <= last {
            let reached = || options.limits.reached().map(Reason::from);
            let stopped = self.too_much.clone().or_else(reached).or_else(|| budget.reached().map(Reason::from));
            if options.limits.is_cancelled() {
                return Err(CheckError::Defect(CANCELLED.to_owned()));
            }
            if stopped.is_some() {
                return Ok((sums, stopped));
            }
            let end = (next + WAVE.min(budget.members)).min(last + 1);
            let numbers: Vec<u64> = (next..end).collect();
            // Those that are integrated together, whatever the number of threads.
            let chunks: Vec<&[u64]> = numbers.chunks(TOGETHER).collect();
            let found = meter::each(&options.limits, &chunks, |some: &&[u64], limits: &Limits| {
                let found = meter::piece(Task::Members, limits, || self.some(some, &prepared, limits));
                found.map_err(|ended| (ended, some.len()))
            });
            let (mut late, mut ended) = (false, None);
            let found = found.into_iter().flat_map(|some| {
                some.unwrap_or_else(|(why, count)| {
                    ended.get_or_insert(why);
                    (0..count).map(|_| Ok(None)).collect()
                })
            });
            let found: Vec<_> = found.collect();
            for (&number, one) in numbers.iter().zip(found) {
                let Some(One { values, rejected, steps, verdicts, measured }) = one? else {
                    late = true;
                    break;
                };
                budget.numbers = budget.numbers.saturating_sub(rejected);
                budget.steps = budget.steps.saturating_sub(steps);
                sums.tallies.iter_mut().for_each(|t| t.counts.rejected += rejected);
                sums.distributions.iter_mut().for_each(|d| d.rejected += rejected);
                if let Some(values) = values {
                    let cell = scales.as_ref().and_then(|scales| self.members.cell(scales, number, &values));
                    budget.members = budget.members.saturating_sub(1);
                    for (distribution, of) in sums.distributions.iter_mut().zip(&measured) {
                        let found = of.values.iter().map(|(_, value, bound)| (*value, *bound));
                        distribution.count(number, found, of.reason.is_some());
                    }
                    each(&Row { number, values: &values, verdicts: &verdicts, measured: &measured });
                    let of_claims = sums.tallies.iter_mut().zip(claims).zip(&laws).zip(&verdicts);
                    for (((tally, claim), law), verdict) in of_claims {
                        tally.count(number, verdict, claim.precision);
                        cell.iter().for_each(|cell| tally.locate(*cell, verdict));
                        if let (Some(law), Some(rise)) = (law, &verdict.evidence().rise) {
                            let cell = self.members.place(&law.scale, law.varied, number, &values);
                            cell.iter().for_each(|cell| tally.slopes.count(*cell, rise));
                        }
                    }
                }
            }
            match ended {
                Some(ended) => return Ok((sums, Some(ended.into()))),
                // The time is over, which the next look tells.
                None if late => continue,
                None => {}
            }
            next = end;
            let told = |n: u64| usize::try_from(n).unwrap_or(usize::MAX);
            progress(told(next - first), told(last + 1 - first));
        }
        Ok((sums, None))
    }

    /// For each claim the edge of where it holds, where the family asks for that.
    pub fn boundaries(
        &self,
        tallies: &[Tally],
        scales: Option<&[Scale; 2]>,
        options: &Options,
    ) -> Result<Vec<Option<Boundary>>, CheckError> {
        let family = &self.members.family;
        let (Some(scales), Some(map)) = (scales, family.map) else { return Ok(vec![None; tallies.len()]) };
        if family.boundary.is_empty() {
            return Ok(vec![None; tallies.len()]);
        }
        let widths = map.map(|n| {
            let width = family.boundary.iter().find(|(at, _)| *at == n)?.1;
            let logarithmic = matches!(family.vary[n].spread, Spread::Grid { logarithmic: true, .. });
            Some(Width { width, logarithmic })
        });
        let prepared = self.prepared();
        let mut left = Budget { members: MOST_BETWEEN, ..Budget::default() };
        let mut one = |(n, tally): (usize, &Tally)| {
            // Members that are compared with one another are those of the family alone.
            if self.derivation.claims[n].forms.iter().any(|f| matches!(f, Form::Across(_))) {
                return Ok(None);
            }
            let mut tried = |points: &[[f64; 2]]| -> Result<Found, CheckError> {
                let mut out = Vec::new();
                for wave in points.chunks(WAVE as usize) {
                    if options.limits.is_cancelled() {
                        return Err(CheckError::Defect(CANCELLED.to_owned()));
                    }
                    let stopped = (left.members == 0 || left.steps == 0).then(|| Plain::MotionsTried.into());
                    if let Some(reason) = options.limits.reached().map(Reason::from).or(stopped) {
                        return Ok(Err(reason));
                    }
                    let members: Vec<Member> = wave.iter().map(|point| self.members.at(*point)).collect();
                    let chunks: Vec<&[Member]> = members.chunks(TOGETHER).collect();
                    let found = meter::each(&options.limits, &chunks, |some: &&[Member], limits: &Limits| {
                        let some = some.iter().map(|member| (1, member.clone())).collect();
                        meter::piece(Task::Members, limits, || self.tried(some, &prepared, limits, false))
                    });
                    let mut all = Vec::new();
                    for some in found {
                        match some {
                            Ok(some) => all.extend(some),
                            Err(ended) => return Ok(Err(ended.into())),
                        }
                    }
                    for one in all {
                        let Some(One { steps, verdicts, .. }) = one? else {
                            let reason = options.limits.reached().map_or(Plain::Ended.into(), Reason::from);
                            return Ok(Err(reason));
                        };
                        left.steps = left.steps.saturating_sub(steps);
                        let found = verdicts.get(n).filter(|v| v.defect().is_none());
                        out.push(found.and_then(|v| v.outcome().truth()));
                    }
                    left.members = left.members.saturating_sub(wave.len() as u64);
                }
                Ok(Ok(out))
            };
            boundary::find(&tally.map, [&scales[0].axis, &scales[1].axis], widths, &mut tried).map(Some)
        };
        tallies.iter().enumerate().map(&mut one).collect()
    }

    /// Members that were counted, once more: their values and their verdicts.
    pub fn again(&self, numbers: BTreeSet<u64>) -> Result<BTreeMap<u64, One>, CheckError> {
        let prepared = self.prepared();
        let numbers: Vec<u64> = numbers.into_iter().collect();
        let found: Vec<Result<One, CheckError>> =
            numbers.par_iter().with_max_len(1).map(|number| self.one(*number, &prepared)).collect();
        numbers.into_iter().zip(found).map(|(number, one)| Ok((number, one?))).collect()
    }

    /// That a member is not what it was counted as: of what this program counted itself, that is a defect.
    pub fn otherwise(&self, Otherwise(number): Otherwise, elsewhere: bool) -> CheckError {
        let family = &self.members.family;
        if !elsewhere {
            let message = format!("member {number} of {} has another verdict when it is tried again", family.id);
            return CheckError::Defect(message);
        }
        let message =
            format!("member {number} of the family `{}` has another verdict here than its part says", family.id);
        let problem = Diagnostic::at(&self.derivation.file, "sweep::foreign-part", family.span.clone(), message);
        CheckError::Problems(vec![problem.hint("parts are made by the program that joins them: make them again")])
    }

    /// That no number gives a member.
    pub fn empty(&self) -> Diagnostic {
        let family = &self.members.family;
        let place = family.where_span.clone().unwrap_or(family.span.clone());
        let message = format!("the family `{}` has no members: all {} are rejected", family.id, family.size());
        Diagnostic::at(&self.derivation.file, "derivation::bad-family", place, message)
            .hint("a member satisfies every constraint under `where`, and what is declared positive is positive")
    }

    /// Some numbers: the member of each, if it gives one, and the verdicts on it; nothing for those that a limit of the run leaves
    /// out. Every member begins with the same graph: what others left behind cannot change it.
    fn some(
        &self,
        numbers: &[u64],
        prepared: &[Vec<Prepared>],
        limits: &Limits,
    ) -> Vec<Result<Option<One>, CheckError>> {
        let members = numbers.iter().map(|number| (*number, self.members.member(*number))).collect();
        self.tried(members, prepared, limits, false)
    }

    /// The same for members at hand; `shown` says that a reader sees them, so that both routes to their values are compared.
    fn tried(
        &self,
        members: Vec<(u64, Member)>,
        prepared: &[Vec<Prepared>],
        limits: &Limits,
        shown: bool,
    ) -> Vec<Result<Option<One>, CheckError>> {
        let told = OF_A_VERDICT * prepared.len() as u64 + OF_A_MEASURE * self.measures.len() as u64;
        meter::charge(members.len() as u64 * (OF_A_MEMBER + told));
        let mut found = Vec::new();
        let mut derivations = Vec::new();
        for (number, member) in members {
            found.push(match member {
                Member::Rejected => Ok(Some(One { rejected: 1, ..One::default() })),
                Member::TooRare => Err(CheckError::Problems(vec![too_rare(&self.derivation, self.members, number)])),
                Member::Found(values, rejected) => self.with_member(number, &values).map(|derivation| {
                    derivations.push((derivation, number % CROSS_CHECK == 1 || shown));
                    Some(One { values: Some(values), rejected, ..One::default() })
                }),
            });
        }
        let all: Vec<OfMember> = derivations.iter().map(|(derivation, checked)| (derivation, *checked)).collect();
        let mut on_members = self.asking(limits, |requests| {
            let mut on_members = self.on_members(&all, prepared, requests, self.estimation);
            let unsettled = |one: &Result<Option<OnMember>, CheckError>| matches!(one, Ok(Some(one)) if one.unsettled);
            let places: Vec<usize> = (0..all.len()).filter(|n| unsettled(&on_members[*n])).collect();
            let again: Vec<OfMember> = places.iter().map(|n| all[*n]).collect();
            let settled = match again.is_empty() {
                true => Vec::new(),
                false => self.on_members(&again, prepared, requests, Estimation::Companions),
            };
            places.into_iter().zip(settled).for_each(|(place, settled)| on_members[place] = settled);
            on_members
        });
        let used = derivations.into_iter().map(|(derivation, _)| derivation);
        self.spare.lock().unwrap_or_else(PoisonError::into_inner).extend(used);
        let mut on_members = on_members.drain(..);
        let with_verdicts = |one: Result<Option<One>, CheckError>| {
            let Some(one) = one? else { return Ok(None) };
            let Some(values) = &one.values else { return Ok(Some(one)) };
            let Some(found) = on_members.next() else { return Ok(None) };
            let found = found.map_err(|error| self.not_built(error, values))?;
            Ok(found.map(|OnMember { verdicts, measured, steps, .. }| One { verdicts, measured, steps, ..one }))
        };
        found.into_iter().map(with_verdicts).collect()
    }

    /// Says what is asked of the motions of members.
    fn asking<T>(&self, limits: &Limits, then: impl FnOnce(&Requests) -> T) -> T {
        let tried: Vec<usize> = (self.slot..=self.slot + self.beside.len()).collect();
        let claims: Vec<&Claim> = self.derivation.claims.iter().collect();
        let programs: Vec<Vec<&Program>> = self.programs.iter().map(|of| of.iter().collect()).collect();
        then(&Requests {
            idle: &self.idle,
            pattern: self.pattern.as_ref(),
            part: false,
            wanted: &self.wanted,
            tried: &tried,
            claims: &claims,
            programs: &programs,
            start_of: &self.start_of,
            measured: &|derivation, t| measure::searched(&self.measures, derivation, t),
            limits,
        })
    }

    /// What is found on each of several members; nothing for those that a limit of the run leaves out.
    fn on_members(
        &self,
        members: &[OfMember],
        prepared: &[Vec<Prepared>],
        requests: &Requests,
        estimation: Estimation,
    ) -> Vec<Result<Option<OnMember>, CheckError>> {
        let derivations: Vec<&Derivation> = members.iter().map(|(derivation, _)| *derivation).collect();
        let stages = Stage::build_each(&derivations, &self.fields, requests, estimation);
        let mut screens = self.screens.clone();
        let one = |(member, stage): (&OfMember, Result<Option<Stage>, CheckError>)| {
            let Some(stage) = stage? else { return Ok(None) };
            let screens = screens.as_mut().filter(|_| !member.1);
            if let Some(verdicts) = screens.and_then(|screens| screens.verdicts(&stage, self.slot)) {
                let steps = stage.motion(self.slot).map_or(0, Motion::steps) as u64;
                // By the long way it is the same.
                debug_assert!(self.verdicts(*member, &stage, prepared, requests.limits).is_ok_and(|(weighed, _)| {
                    let mut both = weighed.iter().zip(&verdicts).zip(&self.programs);
                    both.all(|((long, short), of)| long.outcome() == short.outcome() && is_settled(long, of))
                }));
                return Ok(Some(OnMember { verdicts, measured: Vec::new(), steps, unsettled: false }));
            }
            let motions = || requests.tried.iter().filter_map(|t| stage.motion(*t));
            let steps = motions().map(Motion::steps).sum::<usize>() as u64;
            meter::charge(if estimation == Estimation::Companions { OF_A_STEP } else { OF_A_STEP_ALONE } * steps);
            let (verdicts, measured) = self.verdicts(*member, &stage, prepared, requests.limits)?;
            let settled = || verdicts.iter().zip(&self.programs).all(|(verdict, of)| is_settled(verdict, of));
            let unsettled = motions().any(Motion::is_by_steps) && !settled();
            Ok(Some(OnMember { verdicts, measured, steps, unsettled }))
        };
        members.iter().zip(stages).map(one).collect()
    }

    /// One number, without limits.
    fn one(&self, number: u64, prepared: &[Vec<Prepared>]) -> Result<One, CheckError> {
        let member = vec![(number, self.members.member(number))];
        let found = self.tried(member, prepared, &Limits::default(), true).into_iter().next();
        let missing = || CheckError::Defect(format!("member {number} was not built"));
        found.and_then(Result::transpose).unwrap_or_else(|| Err(missing()))
    }

    /// The derivation with a member, and with those that it is compared with: the same member again where there is none.
    fn with_member(&self, number: u64, values: &[f64]) -> Result<Derivation, CheckError> {
        let (slot, family) = (self.slot, &self.members.family);
        let spare = self.spare.lock().unwrap_or_else(PoisonError::into_inner).pop();
        let mut derivation = spare.unwrap_or_else(|| self.derivation.clone());
        // What a member changes of it: this, and the motions.
        derivation.graph = self.derivation.graph.clone();
        if !self.beside.is_empty() {
            derivation.claims.clone_from(&self.derivation.claims);
        }
        let made = |derivation: &mut Derivation, values: &[f64]| {
            let member = family.member(&mut derivation.graph, &self.derivation.trajectories[slot], number, values);
            let defect =
                || CheckError::Defect(format!("the values of member {number} of {} are no numbers", family.id));
            member.ok_or_else(defect)
        };
        let member = made(&mut derivation, values)?;
        let id = member.id.clone();
        derivation.trajectories[slot] = member.clone();
        // Of each motion beside it the value of what varies, or why there is none.
        let mut others: Vec<Result<f64, NoOther>> = Vec::new();
        for (n, &(varied, which)) in self.beside.iter().enumerate() {
            let other = self.members.beside(number, values, varied, which);
            let motion = match &other {
                Ok(other) => made(&mut derivation, other)?,
                Err(_) => member.clone(),
            };
            derivation.trajectories[slot + 1 + n] = Trajectory { id: format!("{id}-other-{n}"), ..motion };
            others.push(other.map(|other| other[varied]));
        }
        for form in derivation.claims.iter_mut().flat_map(|c| &mut c.forms) {
            let Form::Across(across) = form else { continue };
            let Some(&(varied, _)) = across.others.first().and_then(|at| self.beside.get(at - slot - 1)) else {
                continue;
            };
            let of = |at: &usize| (*at, self.beside[at - slot - 1].1, others[at - slot - 1]);
            let is_there =
                |(_, which, other): &(usize, Beside, Result<f64, NoOther>)| other.is_ok() || !which.may_be_missing();
            let (at, found): (Vec<usize>, Vec<Result<f64, NoOther>>) =
                across.others.iter().map(of).filter(is_there).map(|(at, _, other)| (at, other)).unzip();
            let found: Result<Vec<f64>, NoOther> = std::iter::once(Ok(values[varied])).chain(found).collect();
            across.others = if found.is_ok() { at } else { Vec::new() };
            across.values = found;
        }
        Ok(derivation)
    }

    /// The verdicts of all claims on a member, and what is measured.
    fn verdicts(
        &self,
        (derivation, checked): OfMember,
        stage: &Stage,
        prepared: &[Vec<Prepared>],
        limits: &Limits,
    ) -> Result<(Vec<Verdict>, Vec<Measurement>), CheckError> {
        let slot = self.slot;
        let trace = stage.sampled(slot, &self.wanted).map_err(CheckError::Defect)?;
        let contradiction = checked.then(|| stage.contradiction(&derivation.graph, &trace)).flatten();
        let mut accounts: Vec<ClaimAccount> = Vec::new();
        for of in prepared {
            let Prepared { claim, program, gradients } = &of[0];
            let shown = checked || !says_equations(program);
            let trial = Trial { graph: &derivation.graph, claim, program, trace: &trace, shown };
            let mut verdict = trial::try_claim(derivation, &trial, gradients.as_ref());
            if let Some(contradiction) = &contradiction {
                verdict.contradict(contradiction.clone());
            }
            let trajectory = derivation.trajectories[slot].id.clone();
            let pair = PairAccount { trajectory, verdict, expected: None, discrimination: None };
            accounts.push(ClaimAccount::of(claim, vec![pair]));
        }
        let claimed: Vec<usize> = (0..accounts.len()).collect();
        by_formula::settle(derivation, &mut accounts, (&claimed, &[slot]), limits, &|_, _, _, find| find());
        let points = witness::Points {
            derivation,
            stage,
            prepared,
            start_of: &self.start_of,
            tried: &[slot],
            wanted: &self.wanted,
        };
        witness::complete(&points, &mut accounts);
        let measured = self.measures.iter().filter_map(|m| m.take(derivation, &trace)).collect();
        Ok((accounts.into_iter().flat_map(|a| a.results).map(|pair| pair.verdict).collect(), measured))
    }

    /// Problems of a member have the place of its family: nobody wrote it.
    fn not_built(&self, error: CheckError, values: &[f64]) -> CheckError {
        let CheckError::Problems(found) = error else { return error };
        let family = &self.members.family;
        let given: Vec<String> = family.vary.iter().zip(values).map(|(v, x)| format!("{} = {x:?}", v.name)).collect();
        let told = |d: Diagnostic| {
            let message =
                format!("a member of the family `{}` is no motion, {}: {}", family.id, given.join(", "), d.message);
            Diagnostic::at(&self.derivation.file, d.code, family.span.clone(), message)
                .hint("exclude such members by `where`")
        };
        CheckError::Problems(found.into_iter().take(1).map(told).collect())
    }
}

/// How many cells a map has.
pub fn cells([across, up]: &[Scale; 2]) -> usize {
    across.axis.cells.len() * up.axis.cells.len()
}

/// That hardly any draw satisfies the constraints.
pub fn too_rare(derivation: &Derivation, members: &Members, number: u64) -> Diagnostic {
    let family = &members.family;
    let place = family.where_span.clone().unwrap_or(family.span.clone());
    let message = format!(
        "work limit: of {MOST_DRAWS} draws for member {number} of the family `{}` none satisfies its constraints",
        family.id
    );
    Diagnostic::at(&derivation.file, "derivation::bad-family", place, message)
        .hint("draw from narrower ranges: the constraints leave hardly anything of these")
}

/// Whether what a claim says are equations at times of one motion: of these nothing is counted that is seen in both of their sides along
/// the motion, which only those who look at a member are shown.
fn says_equations(program: &Program) -> bool {
    let of_times = |part: &Part| matches!(part.what, What::Every | What::Constant | What::Value);
    program.parts.iter().all(of_times) && program.comparisons().all(|c| c.kind == RelationKind::Equal)
}
