//! Trajectories of a derivation file → motions.
//!
//! **In:** systems, trajectories and observables as declared. **Out:** [`Stage`]: one [`Motion`] for each trajectory, with
//! everything compiled that claims will ask for. A leaf that a motion does not know (a parameter it was not given, a state
//! of another system) has no value there, which makes claims that need it not applicable rather than wrong.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::{Arc, OnceLock};

use rayon::prelude::*;

use super::CheckError;
use super::account::TrajectoryAccount;
use super::comparison::traced_now;
use super::kept::Family;
use super::limits::Limits;
use super::measure::Compiled;
use super::memory::Recall;
use super::program::Program;
use super::trial::{Course, Values};
use crate::derivation::{Claim, Derivation, Form, Motion as Given, SymbolEntry, Trajectory};
use crate::diag::Diagnostic;
use crate::expr::{Expr, Graph, Leaf, Shape, Symbol};
use crate::flow::{
    Draft, FlowError, Guess, Motion, Observable, Points, Search, Setup, Source, Start, VectorField, Zeros,
};
use crate::latex::Role;
use crate::number::{Bounded, NoValue};

/// Chebyshev points in each step of an integration.
const DENSITY: usize = 6;
/// Most sample times of a motion: a long one is sampled more thinly, at every n-th time.
const MOST_SAMPLES: usize = 1_500;
/// Every how many samples dual numbers are compared with the bounds.
const CROSS_CHECK: usize = 8;

/// So many motions are integrated together: as many as there are lanes.
const TOGETHER: usize = 8;

/// The motions of a derivation, by the position of their trajectories; only those that are needed are there.
pub(super) struct Stage {
    motions: Vec<Option<Built>>,
    /// Whether samples are kept for a later state of the file.
    keeping: bool,
}

/// The leaves of all components of a symbol.
fn leaves_of(graph: &Graph, symbol: Symbol) -> Vec<Leaf> {
    let count = graph.component_count(symbol);
    (0..count).map(|c| Leaf::now(symbol, c as u16)).collect()
}

fn paired(graph: &Graph, symbol: Symbol, rate: u8, values: &[Expr]) -> Vec<(Leaf, Expr)> {
    leaves_of(graph, symbol).into_iter().map(|l| Leaf { rate, ..l }).zip(values.iter().copied()).collect()
}

/// The systems of a derivation, solved for their rates.
pub(super) struct Fields {
    time: Leaf,
    fields: Vec<VectorField>,
    /// The state variables of all systems, and the states of motions given by formulas.
    pub state_leaves: Vec<Leaf>,
}

/// The numbers that the motions of a file may keep together.
const MOST_NUMBERS: usize = 300_000_000;
/// The numbers that a motion keeps of a state for every step: its polynomial, and its error.
const NUMBERS_OF_A_STEP: usize = 23;
/// So many steps are allowed in any case.
const LEAST_STEPS: usize = 100;

impl Fields {
    /// The field of every system, in the order of the file.
    pub fn all(&self) -> &[VectorField] {
        &self.fields
    }

    /// Solves the systems.
    ///
    /// # Errors
    /// A diagnostic for every system that cannot be solved.
    pub fn solve(derivation: &mut Derivation) -> Result<Fields, Vec<Diagnostic>> {
        let mut problems = Vec::new();
        let Derivation { graph, scope, systems, symbols, file, .. } = derivation;
        let motionless = derivation.trajectories.is_empty() && systems.iter().all(|s| s.states.is_empty());
        let absent = |graph: &mut Graph| motionless.then(|| Leaf::now(graph.declare("t", Shape::scalar(), false), 0));
        let Some(time) = scope.time().or_else(|| absent(graph)) else {
            return Err(vec![
                Diagnostic::at(file, "derivation::no-time", 0..0, "no symbol has the role `time`")
                    .hint("add `'t' = { role = \"time\" }` to [symbols]"),
            ]);
        };
        let mut fields = Vec::new();
        // The motions share the memory.
        let each = MOST_NUMBERS / derivation.trajectories.len().max(1);
        for system in systems.iter() {
            // Observables on the right side are part of the system: it is closed in its states.
            let mut closed: Vec<(Expr, Expr)> = Vec::new();
            // Equations of fields have no motions.
            let of_states = system.equations.iter().filter(|_| !system.states.is_empty());
            for relation in of_states.flat_map(|w| &w.value.relations) {
                for (&l, &r) in relation.left.components.iter().zip(&relation.right.components) {
                    closed.push((traced_now(graph, scope, l), traced_now(graph, scope, r)));
                }
            }
            match VectorField::solve(graph, Some(time), &system.states, &closed) {
                Ok(field) => {
                    let most = (each / (NUMBERS_OF_A_STEP * field.states().len().max(1))).max(LEAST_STEPS);
                    fields.push(field.with_most_steps(most));
                }
                Err(error) => {
                    let message = format!("the system `{}` cannot be solved for its rates: {error}", system.id);
                    problems.push(Diagnostic::at(file, "flow::system", system.span.clone(), message));
                }
            }
        }
        if !problems.is_empty() {
            return Err(problems);
        }
        let mut state_leaves: Vec<Leaf> = fields.iter().flat_map(|f| f.states().to_vec()).collect();
        let of_formulas = symbols.iter().filter(|s| s.role == Role::State).flat_map(|s| leaves_of(graph, s.symbol));
        state_leaves.extend(of_formulas);
        state_leaves.sort_unstable();
        state_leaves.dedup();
        Ok(Fields { time, fields, state_leaves })
    }
}

/// What has to be known of motions before claims can be tried on them.
pub(super) struct Requests<'a> {
    /// Whether other claims of the file are not asked about.
    pub part: bool,
    /// The leaves that points have values of.
    pub wanted: &'a [Leaf],
    /// The trajectories on which claims are tried.
    pub tried: &'a [usize],
    /// The claims that are tried.
    pub claims: &'a [&'a Claim],
    /// Their programs, one for each initial time.
    pub programs: &'a [&'a [Program]],
    /// Which program belongs to a trajectory.
    pub start_of: &'a [usize],
    /// What is measured.
    pub measures: &'a [Compiled],
    /// When the run must end: looked at between steps of integration.
    pub limits: &'a Limits,
}

/// A motion with everything that was asked of it.
#[derive(Clone, Debug)]
pub(super) struct Built {
    pub motion: Arc<Motion>,
    pub known: Vec<Symbol>,
    /// The leaves of a point of the motion.
    pub asked: Vec<Leaf>,
    /// Position of every wanted leaf in a point of the motion.
    pub places: Vec<Option<usize>>,
    /// The part of its span that is asked for, as far as the motion reaches.
    pub span: (f64, f64),
    /// The time at which initial values are given.
    pub initial_time: f64,
    /// Values of the parameters.
    pub given: Vec<(Symbol, Vec<Bounded>)>,
    /// Searches for the zeros of expressions that claims and measures ask for.
    pub searches: BTreeMap<Expr, Arc<Search>>,
    /// Sample times, and the leaves there, where motions are kept from one state of a file to the next.
    pub samples: Arc<OnceLock<(Vec<f64>, Points)>>,
}

/// The trajectories that are tried, and those that they are derived from or compared with: each motion that is not derived, with
/// those that come from it.
fn needed_families(derivation: &Derivation, requests: &Requests) -> Vec<Vec<usize>> {
    let count = derivation.trajectories.len();
    let source = |t: usize| match derivation.trajectories[t].motion {
        Given::Derived { from, .. } => Some(from),
        _ => None,
    };
    let mut needed: Vec<bool> = (0..count).map(|t| requests.tried.contains(&t)).collect();
    for form in requests.claims.iter().flat_map(|c| &c.forms) {
        if let Form::SameMotion { other, .. } = form {
            needed[*other] = true;
        }
        if let Form::Across(across) = form {
            across.others.iter().for_each(|other| needed[*other] = true);
        }
    }
    for t in 0..count {
        let mut at = t;
        while let (true, Some(from)) = (needed[at], source(at)) {
            if std::mem::replace(&mut needed[from], true) {
                break;
            }
            at = from;
        }
    }
    let root = |t: usize| {
        let mut at = t;
        // No motion comes from itself; the loader has seen to that.
        while let Some(from) = source(at) {
            at = from;
        }
        at
    };
    let mut families: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for t in (0..count).filter(|&t| needed[t]) {
        families.entry(root(t)).or_default().push(t);
    }
    families.into_values().collect()
}

/// The times at which a motion is sampled.
pub(super) fn sample_times(motion: &Motion) -> Vec<f64> {
    thinned(motion.sample_times(DENSITY))
}

/// Times, at most about [`MOST_SAMPLES`] of them, the last one among them.
fn thinned(times: Vec<f64>) -> Vec<f64> {
    if times.len() <= MOST_SAMPLES {
        return times;
    }
    let (step, last) = (times.len().div_ceil(MOST_SAMPLES), times.last().copied());
    let mut some: Vec<f64> = times.into_iter().step_by(step).collect();
    some.extend(last.filter(|t| some.last() != Some(t)));
    some
}

impl Stage {
    /// Builds the motions that are tried, and those that they are derived from or compared with.
    ///
    /// A motion and those derived from it share a copy of the graph, so that families can be built in parallel. Motions that are
    /// not built before a limit of the run is reached are not there.
    ///
    /// # Errors
    /// A diagnostic for every trajectory that cannot be built.
    pub fn build(
        derivation: &Derivation,
        fields: &Fields,
        requests: &Requests,
        recall: Recall,
    ) -> Result<Stage, CheckError> {
        let mut families = needed_families(derivation, requests);
        // Long motions first: what is left at the end is short.
        let length = |&t: &usize| {
            let (from, to) = derivation.trajectories[t].span;
            (to - from).abs()
        };
        let longest = |members: &Vec<usize>| members.iter().map(length).fold(0.0, f64::max);
        families.sort_by(|a, b| longest(b).total_cmp(&longest(a)));
        // Some of them are integrated together, each task with long ones and short ones.
        let tasks = families.len().div_ceil(TOGETHER).max(families.len().min(4 * rayon::current_num_threads()));
        let mut dealt: Vec<Vec<&[usize]>> = vec![Vec::new(); tasks];
        families.iter().enumerate().for_each(|(i, members)| dealt[i % tasks].push(members));
        let one = |task: &Vec<&[usize]>| together(task.iter().map(|of| (derivation, *of)), fields, requests, recall);
        let results: Vec<_> = dealt.par_iter().with_max_len(1).map(one).collect();
        let results = results.into_iter().flatten();
        let mut motions: Vec<Option<Built>> = derivation.trajectories.iter().map(|_| None).collect();
        let mut problems = Vec::new();
        for result in results {
            match result {
                Ok(built) => built.into_iter().flatten().for_each(|(t, b)| motions[t] = Some(b)),
                Err(CheckError::Problems(found)) => problems.extend(found),
                Err(defect) => return Err(defect),
            }
        }
        if !problems.is_empty() {
            crate::diag::sort(&mut problems);
            return Err(CheckError::Problems(problems));
        }
        Ok(Stage { motions, keeping: recall.is_known() })
    }

    /// A stage for each of several derivations that differ in a trajectory; nothing where a limit of the run was reached before.
    ///
    /// # Errors
    /// As [`Stage::build`], for each of them.
    pub fn build_each(
        derivations: &[Derivation],
        fields: &Fields,
        requests: &Requests,
    ) -> Vec<Result<Option<Stage>, CheckError>> {
        let families: Vec<_> = derivations.iter().map(|d| needed_families(d, requests)).collect();
        let tasks = derivations.iter().zip(&families);
        let tasks = tasks.flat_map(|(d, families)| families.iter().map(move |members| (d, members.as_slice())));
        let mut built = together(tasks, fields, requests, Recall::default()).into_iter();
        let mut stage = |(derivation, families): (&Derivation, &Vec<Vec<usize>>)| {
            let own: Vec<_> = built.by_ref().take(families.len()).collect();
            let mut motions: Vec<Option<Built>> = derivation.trajectories.iter().map(|_| None).collect();
            for of_family in own {
                let Some(of_family) = of_family? else { return Ok(None) };
                of_family.into_iter().for_each(|(t, b)| motions[t] = Some(b));
            }
            Ok(Some(Stage { motions, keeping: false }))
        };
        derivations.iter().zip(&families).map(&mut stage).collect()
    }

    fn built(&self, trajectory: usize) -> Option<&Built> {
        self.motions.get(trajectory).and_then(Option::as_ref)
    }

    /// The times on which a motion is tried.
    pub fn span(&self, trajectory: usize) -> (f64, f64) {
        self.built(trajectory).map_or((f64::INFINITY, f64::NEG_INFINITY), |b| b.span)
    }

    /// The time at which the initial values of a motion are given.
    pub fn initial_time(&self, trajectory: usize) -> f64 {
        self.built(trajectory).map_or(f64::NAN, |b| b.initial_time)
    }

    /// A motion, by the position of its trajectory.
    pub fn motion(&self, trajectory: usize) -> Option<&Motion> {
        self.built(trajectory).map(|b| b.motion.as_ref())
    }

    /// A motion that others come from, and the symbols that it knows.
    pub fn source(&self, trajectory: usize) -> Option<(Arc<Motion>, &[Symbol])> {
        self.built(trajectory).map(|b| (Arc::clone(&b.motion), b.known.as_slice()))
    }

    /// The values of the wanted leaves on a motion at a time.
    pub fn values(&self, trajectory: usize, t: f64) -> Values {
        let Some(built) = self.built(trajectory) else { return Values::new() };
        let point = built.motion.at(t);
        let place = |p: &Option<usize>| p.and_then(|i| point.get(i).copied()).unwrap_or(Err(NoValue::OutOfDomain));
        built.places.iter().map(place).collect()
    }

    /// The values of some of the wanted leaves, by their positions, on a motion at times; the others have none.
    pub fn points(&self, trajectory: usize, times: &[f64], leaves: &[usize]) -> Points {
        let Some(built) = self.built(trajectory) else { return Points::default() };
        let mut here: Vec<usize> = leaves.iter().filter_map(|&l| built.places.get(l).copied().flatten()).collect();
        here.sort_unstable();
        here.dedup();
        built.motion.along_some(times, &here).arranged(&built.places)
    }

    /// The zeros along a motion of an expression that was asked for; `None` where it has no meaning.
    pub fn zeros(&self, trajectory: usize, e: Expr) -> Option<&Zeros> {
        self.built(trajectory)?.searches.get(&e).map(|search| search.zeros())
    }

    /// Samples a motion, and compares the two routes to its values: with a description of a value for which dual numbers and
    /// propagated bounds disagree.
    ///
    /// # Errors
    /// That the trajectory was not built.
    pub fn course<'a>(
        &'a self,
        graph: &Graph,
        trajectory: usize,
        leaves: &'a [Leaf],
    ) -> Result<(Course<'a>, Option<String>), String> {
        let Some(built) = self.built(trajectory) else { return Err("a trajectory was not built".to_owned()) };
        let motion = built.motion.as_ref();
        if let Some((times, points)) = built.samples.get().cloned() {
            let points = points.arranged(&built.places);
            return Ok((Course { stage: self, trajectory, motion, leaves, times, points: points.into() }, None));
        }
        let mut times = motion.sample_times(DENSITY);
        // A derived motion may be tried on a part of the span of its source.
        let (from, to) = built.span;
        times.retain(|t| (from..=to).contains(t));
        for end in [from, to] {
            if let Err(at) = times.binary_search_by(|t| t.total_cmp(&end)) {
                times.insert(at, end);
            }
        }
        let times = thinned(times);
        let points = motion.along(&times);
        let kept = self.keeping.then(|| (times.clone(), points.clone()));
        let points = points.arranged(&built.places);
        let mut contradiction = None;
        for (i, &t) in times.iter().enumerate().step_by(CROSS_CHECK) {
            let duals = motion.dual_at(t);
            for (k, place) in built.places.iter().enumerate() {
                let (Some(place), Ok(bounded)) = (place, points.get(i, k)) else { continue };
                let Some(Ok(dual)) = duals.get(*place) else { continue };
                let gap = (dual.re - bounded.value).abs();
                // Both routes round on their own way: the bound of one covers its distance from the truth.
                let room = 2.0 * bounded.error + 1e-12 * bounded.value.abs() + f64::MIN_POSITIVE;
                if gap > room.max(1e-14) && gap > 1e3 * bounded.error {
                    contradiction.get_or_insert_with(|| {
                        format!(
                            "{} at t = {t}: {} by dual numbers, {} ± {:e} by series",
                            graph.leaf_latex(leaves[k]),
                            dual.re,
                            bounded.value,
                            bounded.error
                        )
                    });
                }
            }
        }
        if let Some(kept) = kept {
            // Another thread can only have found the same.
            let _ = built.samples.set(kept);
        }
        Ok((Course { stage: self, trajectory, motion, leaves, times, points: points.into() }, contradiction))
    }

    /// The value of an expression in parameters on a motion.
    pub fn constant(&self, graph: &Graph, trajectory: usize, e: Expr) -> Option<Bounded> {
        let leaves = graph.leaves([e]);
        let tape = expr::tape::Tape::compile(graph, &leaves, &[e]).ok()?;
        let mut slots = tape.slots::<Bounded>(&());
        let values: Vec<_> = leaves.iter().map(|&l| self.parameter(trajectory, l)).collect();
        tape.evaluate(&(), &values, &mut slots).pop()?.ok()
    }

    fn parameter(&self, trajectory: usize, leaf: Leaf) -> Result<Bounded, NoValue> {
        let given = self.built(trajectory).and_then(|b| b.given.iter().find(|(s, _)| *s == leaf.symbol));
        given.and_then(|(_, v)| v.get(usize::from(leaf.component)).copied()).ok_or(NoValue::OutOfDomain)
    }

    /// A trajectory for the reports.
    pub fn account(&self, derivation: &Derivation, trajectory: usize) -> Option<TrajectoryAccount> {
        let given = derivation.trajectories.get(trajectory)?;
        let Some(built) = self.built(trajectory) else {
            return Some(TrajectoryAccount {
                id: given.id.clone(),
                title: given.title.clone(),
                span: given.span,
                source: given.source(),
                given: Vec::new(),
                steps: 0,
                error: 0.0,
                problem: Some("the run was over before the motion was known".to_owned()),
            });
        };
        let motion = &built.motion;
        let mut values = Vec::new();
        for (symbol, numbers) in &built.given {
            if !numbers.is_empty() {
                let numbers = numbers.iter().map(|v| v.value).collect();
                values.push((derivation.graph.name(*symbol).to_owned(), numbers));
            }
        }
        if let Given::Integrated { initial, .. } = &given.motion {
            let start = motion.state(motion.initial_time());
            let mut at = 0;
            for (symbol, rate, w) in initial {
                let count = w.value.len();
                let numbers: Vec<f64> = start.iter().skip(at).take(count).map(|b| b.value).collect();
                at += count;
                let dots = [r"", r"\dot ", r"\ddot "][usize::from(*rate).min(2)];
                values.push((format!("{dots}{}(t_0)", derivation.graph.name(*symbol)), numbers));
            }
        }
        Some(TrajectoryAccount {
            id: given.id.clone(),
            title: given.title.clone(),
            span: built.span,
            source: given.source(),
            given: values,
            steps: motion.steps(),
            error: motion.error().into_iter().fold(0.0, f64::max),
            problem: motion.problem().map(ToString::to_string),
        })
    }
}

/// A motion and those derived from it, of which the first is set up.
struct Begun<'a> {
    derivation: &'a Derivation,
    members: &'a [usize],
    graph: Graph,
    /// Which it is, and the symbols that it knows.
    first: usize,
    known: Vec<Symbol>,
    draft: Draft,
}

/// The motions of a family, by the positions of their trajectories.
type Together = Vec<(usize, Built)>;

/// How far the building of a family has come.
enum Progress<'a> {
    Begun(Box<Begun<'a>>),
    /// It is known from an earlier state of the file, or cannot be built.
    Done(Result<Together, CheckError>),
}

/// Builds several families, whose integrations are carried out together; nothing where a limit of the run was reached before.
fn together<'a>(
    families: impl Iterator<Item = (&'a Derivation, &'a [usize])>,
    fields: &Fields,
    requests: &Requests,
    recall: Recall,
) -> Vec<Result<Option<Together>, CheckError>> {
    let late = || requests.limits.is_over();
    let begin = |(derivation, members)| begin(derivation, fields, requests, members, recall);
    let mut begun: Vec<Progress> = families.map(begin).collect();
    let drafts = begun.iter_mut().filter_map(|progress| match progress {
        Progress::Begun(begun) => Some(&mut begun.draft),
        Progress::Done(_) => None,
    });
    let integrated = Draft::integrate(drafts, &late);
    let finish = |progress| match progress {
        Progress::Done(done) => done.map(Some),
        Progress::Begun(_) if !integrated || late() => Ok(None),
        Progress::Begun(begun) => begun.finish(fields, requests, recall).map(Some),
    };
    begun.into_iter().map(finish).collect()
}

/// Sets up the motion that the others of a family come from.
fn begin<'a>(
    derivation: &'a Derivation,
    fields: &Fields,
    requests: &Requests,
    members: &'a [usize],
    recall: Recall,
) -> Progress<'a> {
    if let Some(known) = recall.family(derivation, members, |kept| kept.again(derivation, requests, members)) {
        return Progress::Done(Ok(known));
    }
    let is_first = |t: &&usize| !matches!(derivation.trajectories[**t].motion, Given::Derived { .. });
    let Some(&first) = members.iter().find(is_first) else { return Progress::Done(Ok(Vec::new())) };
    let mut graph = derivation.graph.clone();
    let trajectory = &derivation.trajectories[first];
    let (setup, known) = setup(derivation, fields, &mut graph, trajectory, None, false);
    match Draft::new(&mut graph, setup) {
        Ok(draft) => Progress::Begun(Box::new(Begun { derivation, members, graph, first, known, draft })),
        Err(error) => Progress::Done(Err(CheckError::Problems(vec![unbuilt(derivation, trajectory, &error)]))),
    }
}

impl Begun<'_> {
    /// The motions, in the order of the file as far as sources come first.
    fn finish(self, fields: &Fields, requests: &Requests, recall: Recall) -> Result<Vec<(usize, Built)>, CheckError> {
        let Begun { derivation, members, mut graph, first, known, draft } = self;
        let told = |t: usize, error: &FlowError| {
            CheckError::Problems(vec![unbuilt(derivation, &derivation.trajectories[t], error)])
        };
        let motion = draft.finish(&mut graph).map_err(|error| told(first, &error))?;
        let mut done = vec![(first, prepare(derivation, requests, &mut graph, first, motion, known)?)];
        let mut problems = Vec::new();
        let mut left: Vec<usize> = members.iter().copied().filter(|&t| t != first).collect();
        // Each round builds those whose source is there.
        while !left.is_empty() {
            let before = left.len();
            let mut later = Vec::new();
            for &t in &left {
                let trajectory = &derivation.trajectories[t];
                let Given::Derived { from, .. } = &trajectory.motion else { continue };
                let Some((_, source)) = done.iter().find(|(s, _)| s == from) else {
                    later.push(t);
                    continue;
                };
                let from = Some((Arc::clone(&source.motion), source.known.as_slice()));
                let (setup, known) = setup(derivation, fields, &mut graph, trajectory, from, false);
                match Motion::new(&mut graph, setup) {
                    Ok(motion) => done.push((t, prepare(derivation, requests, &mut graph, t, motion, known)?)),
                    Err(error) => problems.push(unbuilt(derivation, trajectory, &error)),
                }
            }
            if later.len() == before || !problems.is_empty() {
                break;
            }
            left = later;
        }
        if !problems.is_empty() {
            return Err(CheckError::Problems(problems));
        }
        if requests.part {
            recall.builds_for_a_part();
        }
        recall.keep(derivation, members, || Family::new(derivation, graph, members, &done));
        Ok(done)
    }
}

/// Why a motion cannot be built, at its place.
fn unbuilt(derivation: &Derivation, trajectory: &Trajectory, error: &FlowError) -> Diagnostic {
    let message = format!("the trajectory `{}` cannot be built: {error}", trajectory.id);
    let at = |code, place| Diagnostic::at(&derivation.file, code, place, message);
    let constraints = trajectory.motion.start().map(|start| start.span.clone());
    match error.about_constraints() {
        Some(hint) => at("flow::initial", constraints.unwrap_or(trajectory.place.clone())).hint(hint),
        None => at("flow::trajectory", trajectory.place.clone()),
    }
}

/// What a motion is made from, and the symbols that it knows. `from` is the motion that a derived one comes from, with the
/// symbols that that one knows. Parameters are rounded to binary64 unless they shall be `exact`.
pub(super) fn setup<'a>(
    derivation: &Derivation,
    fields: &'a Fields,
    graph: &mut Graph,
    trajectory: &Trajectory,
    from: Option<(Arc<Motion>, &[Symbol])>,
    exact: bool,
) -> (Setup<'a>, Vec<Symbol>) {
    let Derivation { scope, systems, symbols, claims, .. } = derivation;
    let mut parameters: Vec<(Leaf, Expr)> = Vec::new();
    let mut known = vec![fields.time.symbol];
    for (symbol, value) in &trajectory.parameters {
        parameters.retain(|(l, _)| l.symbol != *symbol);
        let mut number = |&e: &Expr| if exact { e } else { rounded(graph, e) };
        let values: Vec<Expr> = value.value.iter().map(&mut number).collect();
        parameters.extend(paired(graph, *symbol, 0, &values));
        known.push(*symbol);
    }
    let source = match (&trajectory.motion, from) {
        (Given::Integrated { system, initial, start }, _) => {
            known.extend(&systems[*system].states);
            let values = initial.iter().flat_map(|(s, rate, w)| paired(graph, *s, *rate, &w.value)).collect();
            let start = start.as_ref().map_or_else(Start::default, |start| Start {
                guesses: start
                    .unknowns
                    .iter()
                    .map(|u| Guess { leaf: u.leaf, name: u.name.clone(), near: u.near, within: u.within })
                    .collect(),
                differences: start.differences.clone(),
            });
            Source::Integrated { field: &fields.fields[*system], initial: values, start }
        }
        (Given::Formula { states }, _) => {
            known.extend(states.iter().map(|(s, _)| *s));
            Source::Formula { states: states.iter().flat_map(|(s, w)| paired(graph, *s, 0, &w.value)).collect() }
        }
        (Given::Derived { map, .. }, from) => {
            let mut states: Vec<(Leaf, Expr)> = Vec::new();
            let kept = from.as_ref().map_or(&[][..], |(_, known)| known);
            for &symbol in kept.iter().filter(|&&s| scope.role(s) == Some(Role::State)) {
                if map.iter().any(|(s, _)| *s == symbol) {
                    continue;
                }
                for leaf in leaves_of(graph, symbol) {
                    let e = graph.leaf(leaf);
                    states.push((leaf, e));
                }
                known.push(symbol);
            }
            for (symbol, w) in map {
                states.extend(paired(graph, *symbol, 0, &w.value));
                known.push(*symbol);
            }
            match from {
                Some((motion, _)) => Source::Derived { from: motion, states },
                None => Source::Formula { states },
            }
        }
    };
    let mut observables = Vec::new();
    let entries: Vec<&SymbolEntry> = symbols.iter().chain(claims.iter().flat_map(|c| &c.symbols)).collect();
    for entry in entries.into_iter().filter(|e| e.role == Role::Observable) {
        let in_claim = || claims.iter().find_map(|c| c.scope.definition(entry.symbol));
        let Some(definition) = scope.definition(entry.symbol).or_else(in_claim) else { continue };
        if known.contains(&entry.symbol) || !all_known(graph, &known, &definition.components) {
            continue;
        }
        known.push(entry.symbol);
        for (leaf, e) in paired(graph, entry.symbol, 0, &definition.components) {
            observables.push(Observable { leaf, definition: e, angle: entry.angle });
        }
    }
    let (span, initial_time) = (trajectory.span, trajectory.initial_time);
    (Setup { time: fields.time, span, initial_time, parameters, source, observables }, known)
}

/// Compiles what points need, and finds the events.
fn prepare(
    derivation: &Derivation,
    requests: &Requests,
    graph: &mut Graph,
    trajectory: usize,
    mut motion: Motion,
    known: Vec<Symbol>,
) -> Result<Built, CheckError> {
    let mut places = Vec::new();
    let mut asked = Vec::new();
    for &leaf in requests.wanted {
        let here = is_known(graph, &known, leaf);
        places.push(here.then_some(asked.len()));
        if here {
            asked.push(leaf);
        }
    }
    motion.prepare(graph, &asked).map_err(|e| CheckError::Defect(e.to_string()))?;
    let (reached, asked_for) = (motion.span(), derivation.trajectories[trajectory].span);
    let span = (reached.0.max(asked_for.0), reached.1.min(asked_for.1));
    let searched = searched(derivation, requests, trajectory);
    // What a motion does not know is not searched for.
    let searches = motion.searches(graph, &searched, span);
    let searches = searched.into_iter().zip(searches).filter_map(|(e, s)| Some((e, Arc::new(s.ok()?)))).collect();
    let of = &derivation.trajectories[trajectory].parameters;
    let given = of.iter().map(|(s, w)| (*s, closed_values(graph, &w.value))).collect();
    let initial_time = derivation.trajectories[trajectory].initial_time;
    let (motion, samples) = (Arc::new(motion), Arc::default());
    Ok(Built { motion, known, asked, places, span, initial_time, given, searches, samples })
}

/// What is searched for on a motion, each once: claims and measures ask for the same zeros again and again.
pub(super) fn searched(derivation: &Derivation, requests: &Requests, trajectory: usize) -> Vec<Expr> {
    let mut searched: BTreeSet<Expr> = BTreeSet::new();
    if requests.tried.contains(&trajectory) {
        for (claim, programs) in requests.claims.iter().zip(requests.programs) {
            if claim.trajectories.contains(&trajectory) {
                searched.extend(programs[requests.start_of[trajectory]].searched());
            }
        }
        let taken = requests.measures.iter().filter(|m| m.is_taken_on(derivation, trajectory));
        searched.extend(taken.flat_map(Compiled::events));
    }
    searched.into_iter().collect()
}

/// A number rounded to binary64, exactly: the motion that is tried is the one with these parameters, so that what is equal
/// in the file is equal without an error.
fn rounded(graph: &mut Graph, e: Expr) -> Expr {
    let nearest = graph.as_constant(e).map(|r| r.to_f64().value());
    match nearest.and_then(|x| expr::Rational::try_from(x).ok()) {
        Some(r) => graph.constant(r),
        None => e,
    }
}

/// The values of expressions without leaves; those before the first that has none.
fn closed_values(graph: &Graph, exprs: &[Expr]) -> Vec<Bounded> {
    let Ok(tape) = expr::tape::Tape::compile(graph, &[], exprs) else { return Vec::new() };
    let mut slots = tape.slots::<Bounded>(&());
    tape.evaluate(&(), &[], &mut slots).into_iter().map_while(Result::ok).collect()
}

/// Whether a leaf has a meaning on a motion that knows these symbols.
pub(super) fn is_known(graph: &Graph, known: &[Symbol], leaf: Leaf) -> bool {
    known.contains(&leaf.symbol) && leaf.instant.is_none_or(|e| all_known(graph, known, &[e]))
}

/// Whether every leaf of the expressions belongs to a known symbol.
fn all_known(graph: &Graph, known: &[Symbol], roots: &[Expr]) -> bool {
    graph
        .leaves(roots.iter().copied())
        .iter()
        .all(|l| known.contains(&l.symbol) && l.instant.is_none_or(|e| all_known(graph, known, &[e])))
}
