//! Claims on families: every member is a motion like others, tried like others, and dropped.
//!
//! **In:** a derivation as it was read, and the claims that name families. **Out:** a [`FamilyAccount`] for each claim on each
//! family: how many members hold, fail, are undecided, and the members that a reader wants to see, as trajectories to paste.
//!
//! **Guaranteed:** a member's verdict is what `trial` finds for the same trajectory, at samples; where a motion is given by formulas,
//! what these decide exactly counts, as for trajectories. A family is never said to hold more strongly than *sampled*. Members
//! are made from their numbers, a few at a time, so memory does not grow with how many there are. What is counted is a [`Tally`],
//! which is the same in whatever order members come, so neither threads nor machines change anything; the few members that are
//! shown are made again from their numbers.

mod account;
mod confidence;
mod map;
mod member;
mod parts;
mod sweep;
mod tally;

use std::collections::{BTreeMap, BTreeSet};
use std::ops::RangeInclusive;

use rayon::prelude::*;

pub use account::{FailingShare, FamilyAccount, MemberAccount};
pub use confidence::{CONFIDENCE, failing_share};
pub use map::{Axis, FamilyMap};
pub use parts::{Join, Joined, MOST_PARTS, Part, PartFault, Swept, SweptClaim};
pub use sweep::sweep;
pub use tally::{Ranked, Tally};

use super::account::{ClaimAccount, PairAccount};
use super::independence::Gradients;
use super::limits::Limits;
use super::program::Program;
use super::stage::{Fields, Requests, Stage};
use super::trial::{self, Trial};
use super::{CANCELLED, CheckError, Options, Prepared, by_formula, same_motion, witness};
use crate::derivation::{Claim, Derivation, Form, Trajectory};
use crate::diag::Diagnostic;
use crate::expr::{Leaf, Rational};
use crate::flow::Motion;
use crate::verdict::Verdict;
use account::{Counted, Otherwise};
use map::Scale;
use member::{MOST_DRAWS, Member, Members};

/// So many numbers are looked at between two looks at the limits. It does not depend on the machine.
const WAVE: u64 = 256;
/// So many members are integrated together.
const TOGETHER: usize = 8;
/// The most members of the families of a file that are tried.
const MOST_MEMBERS: u64 = 1_000_000;
/// The most numbers of members that are looked at, rejected ones counted.
const MOST_NUMBERS: u64 = 100_000_000;
/// The most steps of integration of all members of the families of a file.
const MOST_STEPS: u64 = 300_000_000;

/// What is left of the work that the families of a file may take.
struct Budget {
    members: u64,
    numbers: u64,
    steps: u64,
}

impl Default for Budget {
    fn default() -> Budget {
        Budget { members: MOST_MEMBERS, numbers: MOST_NUMBERS, steps: MOST_STEPS }
    }
}

impl Budget {
    /// Why no more is begun.
    fn reached(&self) -> Option<&'static str> {
        match (self.members, self.numbers, self.steps) {
            (0, ..) => Some("work limit: the families of a file try a million members"),
            (_, 0, _) => Some("work limit: the families of a file reject 100 million members"),
            (.., 0) => Some("work limit: the members of a file's families take 300 million steps"),
            _ => None,
        }
    }
}

/// Whether a claim is tried on a family in this run.
fn is_chosen(options: &Options, claim: &Claim, id: &str) -> bool {
    let in_list = |list: &[String], id: &str| list.is_empty() || list.iter().any(|x| x == id);
    in_list(&options.claims, &claim.id) && in_list(&options.trajectories, id)
}

/// A derivation whose claims name families, as it was read: what is found of the motions of the file is not in its graph yet.
pub(super) struct Families {
    derivation: Derivation,
    members: Vec<Option<Members>>,
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
            if !derivation.claims.iter().any(asked) {
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

    /// Tries the claims, and puts what is found into their accounts. What was counted elsewhere is not tried here.
    ///
    /// # Errors
    /// Members that cannot be built, families without members, and defects of the program.
    pub fn try_all(
        &self,
        options: &Options,
        claims: &mut [ClaimAccount],
        joined: Option<&Joined>,
        progress: &(dyn Fn(usize, usize) + Sync),
    ) -> Result<(), CheckError> {
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
            if asked.is_empty() {
                continue;
            }
            let troupe = Troupe::new(derivation, members, &asked)?;
            let joined = joined.filter(|j| j.family == at && j.tallies.len() == asked.len());
            let (tallies, stopped) = match joined {
                Some(joined) => (joined.tallies.clone(), None),
                None => troupe.try_all(1..=members.family.size(), options, &mut budget, &progress)?,
            };
            if tallies.iter().any(|t| t.members == 0) && stopped.is_none() {
                return Err(CheckError::Problems(vec![troupe.empty()]));
            }
            let scales = members.scales();
            let again = troupe.again(tallies.iter().flat_map(Tally::kept).collect())?;
            for (place, (n, (tally, claim))) in places.into_iter().zip(tallies.iter().zip(&asked).enumerate()) {
                let expected = claim.families.iter().position(|f| *f == at).and_then(|i| claim.expect_of_families[i]);
                let (size, precision) = (members.family.size(), claim.precision);
                // A map of another size is none of this family.
                if tally.map.len() != scales.as_ref().map_or(0, cells) {
                    return Err(troupe.otherwise(Otherwise(1), joined.is_some()));
                }
                let scales = scales.as_ref();
                let counted = Counted { size, precision, tally, scales, stopped: stopped.as_deref() };
                let member = |number: u64| {
                    let one: &One = again.get(&number)?;
                    Some((one.values.as_deref()?, one.verdicts.get(n)?))
                };
                let account = counted.account(derivation, &members.family, expected, &member);
                claims[place].families.push(account.map_err(|other| troupe.otherwise(other, joined.is_some()))?);
            }
        }
        Ok(())
    }
}

/// A family with the claims that are tried on it, compiled once for all members.
struct Troupe<'a> {
    members: &'a Members,
    /// The derivation with these claims alone, and one more trajectory: the member.
    derivation: Derivation,
    fields: Fields,
    programs: Vec<Vec<Program>>,
    gradients: Vec<Option<Result<Gradients, String>>>,
    wanted: Vec<Leaf>,
    start_of: Vec<usize>,
    /// The position of the member among the trajectories.
    slot: usize,
    /// The members that it is compared with, which follow it: the position of what varies, and whether it is the next of the row.
    beside: Vec<(usize, bool)>,
}

/// What one number gave.
struct One {
    values: Option<Vec<f64>>,
    rejected: u64,
    steps: u64,
    verdicts: Vec<Verdict>,
}

impl<'a> Troupe<'a> {
    fn new(derivation: &Derivation, members: &'a Members, asked: &[&Claim]) -> Result<Troupe<'a>, CheckError> {
        let base = derivation.trajectories[members.family.of].clone();
        let slot = derivation.trajectories.len();
        // What no member needs would be copied for each of them.
        let mut derivation = derivation.clone();
        derivation.families.clear();
        derivation.measures.clear();
        derivation.conditions.clear();
        derivation.given.clear();
        derivation.pictures.clear();
        let start = Rational::try_from(base.initial_time).unwrap_or(Rational::ZERO);
        derivation.trajectories.push(base.clone());
        let mut beside: Vec<(usize, bool)> = Vec::new();
        let here = |claim: &&Claim| Claim { trajectories: vec![slot], expect: vec![None], ..(*claim).clone() };
        derivation.claims = asked.iter().map(here).collect();
        for claim in &mut derivation.claims {
            let Some(Form::Across(across)) = claim.forms.first_mut() else { continue };
            let Some(varied) = members.family.vary.iter().position(|v| v.leaf == across.with) else { continue };
            let which = (varied, across.dependence.is_of_neighbours());
            let at = beside.iter().position(|b| *b == which).unwrap_or_else(|| {
                beside.push(which);
                beside.len() - 1
            });
            across.other = Some(slot + 1 + at);
            claim.trajectories.push(slot + 1 + at);
            claim.expect.push(None);
        }
        derivation.trajectories.extend(beside.iter().map(|_| base.clone()));
        // As in the file with the member pasted into it: the motions share the memory.
        let fields = Fields::solve(&mut derivation).map_err(CheckError::Problems)?;
        let count = derivation.claims.len();
        let mut programs: Vec<Vec<Program>> =
            (0..count).map(|c| vec![Program::new(&mut derivation, c, &start)]).collect();
        let gradients: Vec<_> = (0..count).map(|c| Gradients::of_claim(&mut derivation, c, &fields)).collect();
        let graph = &derivation.graph;
        let mut wanted: Vec<Leaf> = programs.iter().flatten().flat_map(|p| p.leaves(graph)).collect();
        wanted.extend(gradients.iter().flatten().flatten().flat_map(|g| g.leaves(graph)));
        wanted.extend(same_motion::leaves(&derivation));
        wanted.sort_unstable();
        wanted.dedup();
        for program in programs.iter_mut().flatten() {
            if let Err(leaf) = program.compile(&mut derivation.graph, &wanted) {
                let name = derivation.graph.leaf_latex(leaf);
                return Err(CheckError::Defect(format!("{name} is needed by a claim, but was not asked for")));
            }
        }
        let start_of = vec![0; derivation.trajectories.len()];
        Ok(Troupe { members, derivation, fields, programs, gradients, wanted, start_of, slot, beside })
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
    /// the last.
    fn try_all(
        &self,
        numbers: RangeInclusive<u64>,
        options: &Options,
        budget: &mut Budget,
        progress: &(dyn Fn(usize, usize) + Sync),
    ) -> Result<(Vec<Tally>, Option<String>), CheckError> {
        let prepared = self.prepared();
        let claims = &self.derivation.claims;
        let scales = self.members.scales();
        let empty = Tally { map: vec![[0; 4]; scales.as_ref().map_or(0, cells)], ..Tally::default() };
        let mut tallies = vec![empty; claims.len()];
        let (first, last) = numbers.into_inner();
        let mut next = first;
        while next <= last {
            let stopped = options.limits.reached().or_else(|| budget.reached());
            if options.limits.is_cancelled() {
                return Err(CheckError::Defect(CANCELLED.to_owned()));
            }
            if let Some(reason) = stopped {
                return Ok((tallies, Some(reason.to_owned())));
            }
            let end = (next + WAVE.min(budget.members)).min(last + 1);
            let numbers: Vec<u64> = (next..end).collect();
            // Those that are integrated together, whatever the number of threads.
            let some = numbers.par_chunks(TOGETHER).with_max_len(1);
            let found = some.flat_map_iter(|some| self.some(some, &prepared, &options.limits)).collect::<Vec<_>>();
            let mut late = false;
            for (number, one) in numbers.into_iter().zip(found) {
                let Some(One { values, rejected, steps, verdicts }) = one? else {
                    late = true;
                    break;
                };
                budget.numbers = budget.numbers.saturating_sub(rejected);
                budget.steps = budget.steps.saturating_sub(steps);
                tallies.iter_mut().for_each(|t| t.rejected += rejected);
                if let Some(values) = values {
                    let cell = scales.as_ref().and_then(|scales| self.members.cell(scales, number, &values));
                    budget.members = budget.members.saturating_sub(1);
                    let of_claims = tallies.iter_mut().zip(claims).zip(&verdicts);
                    for ((tally, claim), verdict) in of_claims {
                        tally.count(number, verdict, claim.precision);
                        cell.iter().for_each(|cell| tally.locate(*cell, verdict));
                    }
                }
            }
            if late {
                // The time is over, which the next look tells.
                continue;
            }
            next = end;
            let told = |n: u64| usize::try_from(n).unwrap_or(usize::MAX);
            progress(told(next - first), told(last + 1 - first));
        }
        Ok((tallies, None))
    }

    /// Members that were counted, once more: their values and their verdicts.
    fn again(&self, numbers: BTreeSet<u64>) -> Result<BTreeMap<u64, One>, CheckError> {
        let prepared = self.prepared();
        let numbers: Vec<u64> = numbers.into_iter().collect();
        let found: Vec<Result<One, CheckError>> =
            numbers.par_iter().with_max_len(1).map(|number| self.one(*number, &prepared)).collect();
        numbers.into_iter().zip(found).map(|(number, one)| Ok((number, one?))).collect()
    }

    /// That a member is not what it was counted as: of what this program counted itself, that is a defect.
    fn otherwise(&self, Otherwise(number): Otherwise, elsewhere: bool) -> CheckError {
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
    fn empty(&self) -> Diagnostic {
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
        let slot = self.slot;
        let mut found = Vec::new();
        let mut derivations = Vec::new();
        for &number in numbers {
            found.push(match self.members.member(number) {
                Member::Rejected => Ok(Some(One { values: None, rejected: 1, steps: 0, verdicts: Vec::new() })),
                Member::TooRare => Err(CheckError::Problems(vec![too_rare(&self.derivation, self.members, number)])),
                Member::Found(values, rejected) => self.with_member(number, &values).map(|derivation| {
                    derivations.push(derivation);
                    Some(One { values: Some(values), rejected, steps: 0, verdicts: Vec::new() })
                }),
            });
        }
        let tried: Vec<usize> = (slot..=slot + self.beside.len()).collect();
        let claims: Vec<&Claim> = self.derivation.claims.iter().collect();
        let programs: Vec<&[Program]> = self.programs.iter().map(Vec::as_slice).collect();
        let requests = Requests {
            part: false,
            wanted: &self.wanted,
            tried: &tried,
            claims: &claims,
            programs: &programs,
            start_of: &self.start_of,
            measures: &[],
            limits,
        };
        let stages = Stage::build_each(&derivations, &self.fields, &requests);
        let mut stages = derivations.iter().zip(stages);
        let with_verdicts = |one: Result<Option<One>, CheckError>| {
            let Some(one) = one? else { return Ok(None) };
            let Some(values) = &one.values else { return Ok(Some(one)) };
            let Some((derivation, stage)) = stages.next() else { return Ok(None) };
            let Some(stage) = stage.map_err(|error| self.not_built(error, values))? else { return Ok(None) };
            let verdicts = self.verdicts(derivation, &stage, prepared, limits)?;
            let steps = tried.iter().filter_map(|t| stage.motion(*t)).map(Motion::steps).sum::<usize>() as u64;
            Ok(Some(One { verdicts, steps, ..one }))
        };
        found.into_iter().map(with_verdicts).collect()
    }

    /// One number, without limits.
    fn one(&self, number: u64, prepared: &[Vec<Prepared>]) -> Result<One, CheckError> {
        let found = self.some(&[number], prepared, &Limits::default()).into_iter().next();
        let missing = || CheckError::Defect(format!("member {number} was not built"));
        found.and_then(Result::transpose).unwrap_or_else(|| Err(missing()))
    }

    /// The derivation with a member, and with those that it is compared with: the same member again where there is none.
    fn with_member(&self, number: u64, values: &[f64]) -> Result<Derivation, CheckError> {
        let (slot, family) = (self.slot, &self.members.family);
        let mut derivation = self.derivation.clone();
        let made = |derivation: &mut Derivation, values: &[f64]| {
            let member = family.member(&mut derivation.graph, &self.derivation.trajectories[slot], number, values);
            let defect =
                || CheckError::Defect(format!("the values of member {number} of {} are no numbers", family.id));
            member.ok_or_else(defect)
        };
        let member = made(&mut derivation, values)?;
        let id = member.id.clone();
        derivation.trajectories[slot] = member.clone();
        for (n, &(varied, next)) in self.beside.iter().enumerate() {
            let at = slot + 1 + n;
            let other = self.members.beside(number, values, varied, next);
            let motion = match &other {
                Ok(other) => made(&mut derivation, other)?,
                Err(_) => member.clone(),
            };
            derivation.trajectories[at] = Trajectory { id: format!("{id}-other-{n}"), ..motion };
            for form in derivation.claims.iter_mut().flat_map(|c| &mut c.forms) {
                if let Form::Across(across) = form
                    && across.other == Some(at)
                {
                    across.other = other.as_ref().ok().map(|_| at);
                    across.values = other.as_ref().map(|o| (values[varied], o[varied])).map_err(|why| *why);
                }
            }
        }
        Ok(derivation)
    }

    /// The verdicts of all claims on a member.
    fn verdicts(
        &self,
        derivation: &Derivation,
        stage: &Stage,
        prepared: &[Vec<Prepared>],
        limits: &Limits,
    ) -> Result<Vec<Verdict>, CheckError> {
        let slot = self.slot;
        let (course, contradiction) =
            stage.course(&derivation.graph, slot, &self.wanted).map_err(CheckError::Defect)?;
        let mut accounts: Vec<ClaimAccount> = Vec::new();
        for of in prepared {
            let Prepared { claim, program, gradients } = &of[0];
            let trial = Trial { graph: &derivation.graph, claim, program, course: &course, shown: true };
            let mut verdict = trial::try_claim(derivation, &trial, gradients.as_ref());
            if let Some(contradiction) = &contradiction {
                verdict.contradict(contradiction.clone());
            }
            let trajectory = derivation.trajectories[slot].id.clone();
            let pair = PairAccount { trajectory, verdict, expected: None, discrimination: None };
            accounts.push(ClaimAccount::of(claim, vec![pair]));
        }
        let claimed: Vec<usize> = (0..accounts.len()).collect();
        by_formula::settle(derivation, &mut accounts, &claimed, &[slot], limits);
        let points = witness::Points {
            derivation,
            stage,
            prepared,
            start_of: &self.start_of,
            tried: &[slot],
            wanted: &self.wanted,
        };
        witness::complete(&points, &mut accounts);
        Ok(accounts.into_iter().flat_map(|a| a.results).map(|pair| pair.verdict).collect())
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
fn cells([across, up]: &[Scale; 2]) -> usize {
    across.axis.cells.len() * up.axis.cells.len()
}

/// That hardly any draw satisfies the constraints.
fn too_rare(derivation: &Derivation, members: &Members, number: u64) -> Diagnostic {
    let family = &members.family;
    let place = family.where_span.clone().unwrap_or(family.span.clone());
    let message = format!(
        "work limit: of {MOST_DRAWS} draws for member {number} of the family `{}` none satisfies its constraints",
        family.id
    );
    Diagnostic::at(&derivation.file, "derivation::bad-family", place, message)
        .hint("draw from narrower ranges: the constraints leave hardly anything of these")
}
