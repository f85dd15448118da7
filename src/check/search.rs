//! A motion on which a claim fails.
//!
//! **In:** a derivation, a claim, a seed and a number of tries. **Out:** a trajectory as text of a derivation file, on which
//! the claim fails with its assumptions met; or how the tries ended. **Guaranteed:** what is found was checked from the very
//! text that is handed out. The same seed gives the same text on any number of threads: every try has its own draws, and the
//! first try that fails is taken.
//!
//! **How:** the trajectories of the file are families: numbers in them are changed, formulas kept, so that what the formulas
//! build in (a rotation matrix, a momentum along an axis, the relation of a closed solution) stays true. Numbers of matrices
//! are kept, since they are seldom free. Each try changes some numbers of one trajectory: to something else, to 0, to the
//! opposite, to another number of the same symbol, or by little; so equations between them are met by many tries and broken
//! by many. What is found is then made simple: numbers go back to those of the file, or to fewer digits, as long as the claim
//! still fails.

use super::run::Run;
use crate::derivation::{Claim, Derivation, GivenValue, Motion, Trajectory, parse};
use crate::diag::{Diagnostic, Source};
use crate::latex::Role;
use crate::number::Draws;
use crate::verdict::{Finding, Outcome, Verdict};
use claim::error::CheckError;
use claim::options::Options;
use findings::search::{FailingMotion, SearchAccount, Tries};
use reason::Plain;

/// Tries that are checked together. Part of what a seed means: it must not depend on the machine.
const BATCH: usize = 24;
/// The longest stretch of time that is tried, unless a trajectory of the file is shorter.
const LONGEST: f64 = 40.0;
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

/// A value of a trajectory.
#[derive(Clone, Debug, PartialEq)]
enum Value {
    /// As the file has it.
    Kept(String),
    /// One number.
    Number(f64),
    /// A row of numbers.
    Row(Vec<f64>),
}

impl Value {
    fn numbers(&self) -> &[f64] {
        match self {
            Value::Kept(_) => &[],
            Value::Number(x) => std::slice::from_ref(x),
            Value::Row(row) => row,
        }
    }

    fn numbers_mut(&mut self) -> &mut [f64] {
        match self {
            Value::Kept(_) => &mut [],
            Value::Number(x) => std::slice::from_mut(x),
            Value::Row(row) => row,
        }
    }

    fn text(&self) -> String {
        match self {
            Value::Kept(text) => text.clone(),
            Value::Number(x) => number(*x),
            Value::Row(row) => format!("[{}]", row.iter().map(|x| number(*x)).collect::<Vec<_>>().join(", ")),
        }
    }
}

/// A number as the loader reads it back, exactly.
fn number(x: f64) -> String {
    let x = if x == 0.0 { 0.0 } else { x };
    if x.abs() >= 1e-5 && x.abs() < 1e15 || x == 0.0 { format!("{x}") } else { format!("{x:e}") }
}

/// What has a value.
#[derive(Clone, Debug, PartialEq)]
struct Slot {
    key: String,
    parameter: bool,
    positive: bool,
    /// A number without unit may be an angle: it is drawn from one turn.
    angle: bool,
    value: Value,
}

/// A trajectory that can be written down.
#[derive(Clone, Debug, PartialEq)]
struct Draft {
    /// The trajectory that it was made from.
    from: String,
    /// The system that it is integrated from; formulas otherwise.
    system: Option<String>,
    slots: Vec<Slot>,
    span: (f64, f64),
    initial_time: f64,
}

/// A key of a table.
fn key(name: &str) -> String {
    if name.contains('\'') { format!("\"{name}\"") } else { format!("'{name}'") }
}

impl Draft {
    /// The family of a trajectory of the file; `None` for one that is derived from another.
    fn of(derivation: &Derivation, trajectory: &Trajectory) -> Option<Draft> {
        let system = match &trajectory.motion {
            // What is solved for has no number that could be changed.
            Motion::Integrated { .. } if trajectory.motion.start().is_some() => return None,
            Motion::Integrated { system, .. } => Some(derivation.systems.get(*system)?.id.clone()),
            Motion::Formula { .. } => None,
            Motion::Derived { .. } => return None,
        };
        let given = derivation.given.iter().filter(|g| g.trajectory == trajectory.id);
        let slots = given.map(|g| slot(derivation, g)).collect::<Option<Vec<Slot>>>()?;
        let (from, to) = trajectory.span;
        let start = trajectory.initial_time;
        let span = (from.max(start - LONGEST / 2.0), to.min(start + LONGEST));
        Some(Draft { from: trajectory.id.clone(), system, slots, span, initial_time: start })
    }

    /// The table of the file.
    fn table(&self, id: &str) -> String {
        let part = |wanted: bool| -> String {
            let all = self.slots.iter().filter(|s| s.parameter == wanted);
            all.map(|s| format!("{} = {}", key(&s.key), s.value.text())).collect::<Vec<_>>().join(", ")
        };
        let mut out = format!("[[trajectory]]\nid = \"{id}\"\n");
        if let Some(system) = &self.system {
            out.push_str(&format!("system = \"{system}\"\n"));
        }
        let parameters = part(true);
        if !parameters.is_empty() {
            out.push_str(&format!("parameters = {{ {parameters} }}\n"));
        }
        let states = if self.system.is_some() { "initial" } else { "formula" };
        out.push_str(&format!("{states} = {{ {} }}\n", part(false)));
        out.push_str(&format!("span = [{}, {}]\n", number(self.span.0), number(self.span.1)));
        let usual = if self.span.0 <= 0.0 && self.span.1 >= 0.0 { 0.0 } else { self.span.0 };
        if self.initial_time != usual {
            out.push_str(&format!("initial-time = {}\n", number(self.initial_time)));
        }
        out
    }

    /// Where numbers stand that may be changed: slot and position.
    fn entries(&self) -> Vec<(usize, usize)> {
        let each = |(s, slot): (usize, &Slot)| (0..slot.value.numbers().len()).map(move |i| (s, i)).collect::<Vec<_>>();
        self.slots.iter().enumerate().flat_map(each).collect()
    }

    fn get(&self, (slot, at): (usize, usize)) -> f64 {
        self.slots.get(slot).and_then(|s| s.value.numbers().get(at)).copied().unwrap_or(0.0)
    }

    fn set(&mut self, (slot, at): (usize, usize), x: f64) {
        if let Some(place) = self.slots.get_mut(slot).and_then(|s| s.value.numbers_mut().get_mut(at)) {
            *place = x;
        }
    }
}

/// A value as the file gives it: numbers apart from everything else.
fn slot(derivation: &Derivation, given: &GivenValue) -> Option<Slot> {
    let (graph, source) = (&derivation.graph, &derivation.file.text);
    let entry = derivation.symbols.iter().find(|s| s.symbol == given.symbol)?;
    let quoted = given.value.span.start.checked_sub(1).and_then(|i| source.as_bytes().get(i)) == Some(&b'\'');
    let raw = given.value.text.as_str();
    let constants: Option<Vec<f64>> =
        given.value.value.iter().map(|e| graph.as_constant(*e).map(|r| r.to_f64().value())).collect();
    let rank = if graph.is_diagonal(given.symbol) { 1 } else { graph.shape(given.symbol).rank() };
    let value = match (quoted || raw.contains('\''), rank, constants) {
        (false, 0, Some(numbers)) => Value::Number(*numbers.first()?),
        (false, 1, Some(numbers)) => Value::Row(numbers),
        _ if quoted && raw.contains('\'') => Value::Kept(format!("'''{raw}'''")),
        _ if quoted => Value::Kept(format!("'{raw}'")),
        _ => Value::Kept(raw.to_owned()),
    };
    let dots = match given.rate {
        0 => "",
        1 => r"\dot ",
        _ => r"\ddot ",
    };
    Some(Slot {
        key: format!("{dots}{}", entry.name),
        parameter: entry.role == Role::Parameter,
        positive: entry.positive,
        angle: entry.angle || entry.measured_in.as_ref().is_some_and(|u| u.is_number()),
        value,
    })
}

/// A number in [0, 1).
fn uniform(draws: &mut Draws) -> f64 {
    draws.below(1 << 30) as f64 / (1_u64 << 30) as f64
}

/// A number with this many digits.
fn rounded(x: f64, digits: usize) -> f64 {
    format!("{x:.*e}", digits.saturating_sub(1)).parse().unwrap_or(x)
}

/// Another motion of the family.
fn draw(families: &[Draft], seed: u64, number: usize) -> Option<Draft> {
    let mut draws = Draws::new(seed ^ (number as u64).wrapping_mul(0x9E37_79B9_7F4A_7C15));
    draws.bits();
    let mut draft = families.get(draws.below(families.len() as u64) as usize)?.clone();
    let entries = draft.entries();
    if entries.is_empty() {
        return None;
    }
    // Few changes keep what equations ask for; many leave the neighbourhood of what the file has.
    let few = draws.below(3) > 0;
    let count = if few { 1 + draws.below(2) as usize } else { 1 + draws.below(entries.len() as u64) as usize };
    for _ in 0..count {
        let at = entries[draws.below(entries.len() as u64) as usize];
        let old = draft.get(at);
        let slot = draft.slots.get(at.0)?.clone();
        let u = uniform(&mut draws);
        let factor = if draws.below(2) == 0 { 1.0 + 3.0 * u } else { 1.0 / (1.0 + 3.0 * u) };
        let new = match draws.below(8) {
            0 if !slot.positive => 0.0,
            1 if !slot.positive => -old,
            2 | 3 if slot.value.numbers().len() > 1 => {
                draft.get((at.0, draws.below(slot.value.numbers().len() as u64) as usize))
            }
            4 => old * (1.0 + 0.02 * (u - 0.5)),
            5 | 6 if slot.angle && !slot.positive => 6.2 * u - 3.1,
            _ if old == 0.0 => 4.0 * u - 2.0,
            _ => old * factor,
        };
        let new = if slot.positive && new <= 0.0 { 1.0 + u } else { new };
        draft.set(at, rounded(new, 4));
    }
    Some(draft)
}

/// A file with more trajectories, on which the claim alone is checked.
struct Trial<'d> {
    derivation: &'d Derivation,
    names: Vec<String>,
    id: String,
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
        let id = |i: usize| format!("{}-{i}", self.id);
        let mut text = self.derivation.file.text.clone();
        for (i, draft) in drafts.iter().enumerate() {
            text.push_str(&format!("\n{}", draft.table(&id(i))));
        }
        let path = self.derivation.file.path.clone();
        let found = match parse(Source { path, text }, &self.derivation.id) {
            Err(_) => None,
            Ok(mut read) => {
                let first = read.trajectories.len() - drafts.len();
                let added: Vec<usize> = (first..read.trajectories.len()).collect();
                // Other claims cost time: their symbols are computed along every motion.
                read.claims.retain(|c| self.names.contains(&c.name()));
                for claim in &mut read.claims {
                    claim.trajectories.clone_from(&added);
                    claim.expect = vec![None; added.len()];
                    // What a claim follows from is no matter of a motion.
                    claim.follows_from.clear();
                }
                read.measures.clear();
                let claims = self.names.iter().map(|n| n.split('/').next().unwrap_or(n).to_owned()).collect();
                let trajectories = (0..drafts.len()).map(id).collect();
                let options = Options { claims, trajectories, plain: true, ..Options::default() };
                match Run::new(&read, &options).account() {
                    Ok(account) => Some(account),
                    Err(CheckError::Problems(_)) => None,
                    Err(defect) => return Err(defect),
                }
            }
        };
        let Some(account) = found else {
            // One of them cannot be: the others are tried without it.
            return match drafts {
                [] | [_] => Ok(vec![None; drafts.len()]),
                several => {
                    let mut out = Vec::new();
                    for draft in several {
                        out.extend(self.verdicts_here(std::slice::from_ref(draft))?);
                    }
                    Ok(out)
                }
            };
        };
        let of = |i: usize| {
            let name = |c: &findings::ClaimAccount| match &c.reading {
                Some(reading) => format!("{}/{reading}", c.id),
                None => c.id.clone(),
            };
            let wanted = account.claims.iter().filter(|c| self.names.contains(&name(c)));
            let mut verdicts: Vec<(String, Verdict)> = wanted
                .filter_map(|c| {
                    let pair = c.on(&id(i))?;
                    Some((name(c), pair.verdict.clone()))
                })
                .collect();
            let at = verdicts.iter().position(|(_, v)| matches!(v.outcome(), Outcome::Fails(_))).unwrap_or(0);
            (at < verdicts.len()).then(|| verdicts.swap_remove(at))
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
    let id = fresh_id(derivation, options);
    let of = |derivation, printed| Trial { derivation, names: names.clone(), id: id.clone(), printed };
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
    while next < options.tries && !families.is_empty() && !names.is_empty() {
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
                    let table = simple.table(&id);
                    out.found = Some(FailingMotion { number, claim, from, table, id, verdict, listed });
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
    let reading = |c: &findings::ClaimAccount| c.reading.as_ref().map(|r| format!("{}/{r}", c.id));
    let meant = |c: &&findings::ClaimAccount| c.id == options.claim || reading(c).as_deref() == Some(&options.claim);
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
fn fresh_id(derivation: &Derivation, options: &SearchOptions) -> String {
    let claim: String = options.claim.chars().take(60).map(|c| if c == '/' { '-' } else { c }).collect();
    let variant = options.variant.map(|n| format!("-variant-{n}")).unwrap_or_default();
    let mut id = format!("against-{claim}{variant}-{}", options.seed);
    while derivation.trajectories.iter().any(|t| t.id.starts_with(&id)) {
        id.push('x');
    }
    id
}
