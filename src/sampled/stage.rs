//! Trajectories of a derivation file → motions.
//!
//! **In:** systems, trajectories and observables as declared. **Out:** [`Stage`]: one [`Motion`] for each trajectory, with
//! everything compiled that claims will ask for. A leaf that a motion does not know (a parameter it was not given, a state
//! of another system) has no value there, which makes claims that need it not applicable rather than wrong.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::{Arc, OnceLock};

use crate::derivation::{Claim, Derivation, Form, Motion as Given, Trajectory};
use crate::diag::Diagnostic;
use crate::expr::{Expr, Graph, Leaf, Symbol};
use crate::findings::TrajectoryAccount;
use crate::flow::{Draft, Estimation, FlowError, Motion, Points, Rapid, RapidSearch, Search, Zeros};
use crate::number::{Bounded, NoValue};
use crate::pattern::Pattern;
use crate::recall::{Nothing, Recall};
use crate::setup::{is_known, setup};
use crate::systems::Fields;
use claim::error::CheckError;
use claim::limits::Limits;
use claim::program::{Program, Values};
use meter::Ended;

/// Chebyshev points in each step of an integration.
pub const DENSITY: usize = 6;
/// Most sample times of a motion: a long one is sampled more thinly, at every n-th time.
const MOST_SAMPLES: usize = 1_500;

/// So many motions are integrated together: as many as there are lanes.
const TOGETHER: usize = 8;
/// So many tasks there are at least, where there are as many motions: enough for a few processors. The counted work depends on it, so it
/// is the same on every machine.
const FEWEST_TASKS: usize = 8;

/// The motions of a derivation, by the position of their trajectories; only those that are needed are there.
pub struct Stage {
    motions: Vec<Option<Built>>,
    /// Why motions are not there, whose work was used up.
    ended: Vec<Option<Ended>>,
    /// Whether samples are kept for a later state of the file.
    pub keeping: bool,
}

/// What has to be known of motions before claims can be tried on them.
pub struct Requests<'a> {
    /// Whether other claims of the file are not asked about.
    pub part: bool,
    /// Angles that motions need not be followed for: see [`idle_angles`](crate::setup::idle_angles).
    pub idle: &'a [Symbol],
    /// What the motions that are tried are made after, where they are alike.
    pub pattern: Option<&'a Pattern>,
    /// The leaves that points have values of.
    pub wanted: &'a [Leaf],
    /// The trajectories on which claims are tried.
    pub tried: &'a [usize],
    /// The claims that are tried.
    pub claims: &'a [&'a Claim],
    /// Their programs, one for each initial time.
    pub programs: &'a [Vec<&'a Program>],
    /// Which program belongs to a trajectory.
    pub start_of: &'a [usize],
    /// What is searched for on a motion beside what claims need.
    pub measured: &'a (dyn Fn(&Derivation, usize) -> Searched + Sync),
    /// When the run must end: looked at between steps of integration.
    pub limits: &'a Limits,
}

/// What is searched for along a motion, by what vanishes, or varies.
#[derive(Default)]
pub struct Searched {
    /// For the zeros of these.
    pub zeros: Vec<Expr>,
    /// For where these vary rapidly.
    pub rapid: Vec<Expr>,
}

/// A motion with everything that was asked of it.
#[derive(Clone, Debug)]
pub struct Built {
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
    /// Expressions that may vary more rapidly than the motion is sampled, and the search for where they do, in their order.
    pub rapid: (Vec<Expr>, Arc<RapidSearch>),
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
    let mut needed: Vec<bool> = (0..count).map(|t| requests.tried.binary_search(&t).is_ok()).collect();
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
pub fn sample_times(motion: &Motion) -> Vec<f64> {
    thinned(motion.sample_times(DENSITY))
}

/// Times, at most about `MOST_SAMPLES` of them, the last one among them.
pub fn thinned(times: Vec<f64>) -> Vec<f64> {
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
        recall: &dyn Recall,
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
        let tasks = families.len().div_ceil(TOGETHER).max(families.len().min(FEWEST_TASKS));
        let mut dealt: Vec<Vec<&[usize]>> = vec![Vec::new(); tasks];
        families.iter().enumerate().for_each(|(i, members)| dealt[i % tasks].push(members));
        let some = |task: &[&[usize]], limits: &Limits| {
            let families = task.iter().map(|of| (derivation, *of));
            let build = || together(families, fields, requests, recall, Estimation::Companions);
            meter::piece(meter::Task::Motion, limits, build)
        };
        let one = |task: &Vec<&[usize]>, limits: &Limits| match (some(task, limits), task.as_slice()) {
            (Ok(built), _) => vec![(Vec::new(), Ok(built))],
            (Err(ended), [alone]) => vec![(alone.to_vec(), Err(ended))],
            // One of them takes all the work: each by itself. What ends does so whatever it was dealt with.
            (Err(_), several) => several.iter().map(|of| (of.to_vec(), some(&[of], limits))).collect(),
        };
        let results = meter::each(requests.limits, &dealt, one);
        let mut motions: Vec<Option<Built>> = derivation.trajectories.iter().map(|_| None).collect();
        let mut ended: Vec<Option<Ended>> = derivation.trajectories.iter().map(|_| None).collect();
        let mut problems = Vec::new();
        for (members, results) in results.into_iter().flatten() {
            let results = results.unwrap_or_else(|why| {
                members.iter().for_each(|&t| ended[t] = Some(why.clone()));
                Vec::new()
            });
            for result in results {
                match result {
                    Ok(built) => built.into_iter().flatten().for_each(|(t, b)| motions[t] = Some(b)),
                    Err(CheckError::Problems(found)) => problems.extend(found),
                    Err(defect) => return Err(defect),
                }
            }
        }
        if !problems.is_empty() {
            crate::diag::sort(&mut problems);
            return Err(CheckError::Problems(problems));
        }
        Ok(Stage { motions, ended, keeping: recall.is_known() })
    }

    /// A stage for each of several derivations that differ in a trajectory; nothing where a limit of the run was reached before.
    ///
    /// # Errors
    /// As [`Stage::build`], for each of them.
    pub fn build_each(
        derivations: &[&Derivation],
        fields: &Fields,
        requests: &Requests,
        estimation: Estimation,
    ) -> Vec<Result<Option<Stage>, CheckError>> {
        let families: Vec<_> = derivations.iter().map(|d| needed_families(d, requests)).collect();
        let tasks = derivations.iter().copied().zip(&families);
        let tasks = tasks.flat_map(|(d, families)| families.iter().map(move |members| (d, members.as_slice())));
        let mut built = together(tasks, fields, requests, &Nothing, estimation).into_iter();
        let mut stage = |(derivation, families): (&&Derivation, &Vec<Vec<usize>>)| {
            let own: Vec<_> = built.by_ref().take(families.len()).collect();
            let mut motions: Vec<Option<Built>> = derivation.trajectories.iter().map(|_| None).collect();
            for of_family in own {
                let Some(of_family) = of_family? else { return Ok(None) };
                of_family.into_iter().for_each(|(t, b)| motions[t] = Some(b));
            }
            Ok(Some(Stage { motions, ended: Vec::new(), keeping: false }))
        };
        derivations.iter().zip(&families).map(&mut stage).collect()
    }

    /// Why a motion is not there whose work was used up.
    pub fn ended(&self, trajectory: usize) -> Option<&Ended> {
        self.ended.get(trajectory).and_then(Option::as_ref)
    }

    pub fn built(&self, trajectory: usize) -> Option<&Built> {
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

    /// Whether a motion knows a wanted leaf, by its position.
    pub fn knows(&self, trajectory: usize, leaf: usize) -> bool {
        self.built(trajectory).is_some_and(|built| built.places.get(leaf).is_some_and(Option::is_some))
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

    /// Where expressions that were asked for vary more rapidly than a motion is sampled.
    pub fn rapid(&self, trajectory: usize, expressions: &[Expr], samples: &[f64]) -> Rapid {
        let Some(Built { rapid: (known, search), .. }) = self.built(trajectory) else { return Rapid::default() };
        search.rapid(expressions.iter().filter_map(|e| known.binary_search(e).ok()), samples)
    }

    /// All times at which some expression that was asked for varies more rapidly than a motion is sampled.
    pub(crate) fn all_rapid(&self, trajectory: usize, samples: &[f64]) -> Vec<f64> {
        let Some(Built { rapid: (known, search), .. }) = self.built(trajectory) else { return Vec::new() };
        let Rapid { mut times, singular, .. } = search.rapid(0..known.len(), samples);
        times.extend(singular);
        times.sort_by(f64::total_cmp);
        times.dedup();
        times
    }

    /// The value of an expression in parameters on a motion.
    pub fn constant(&self, graph: &Graph, trajectory: usize, e: Expr) -> Option<Bounded> {
        let leaves = graph.leaves([e]);
        let tape = expr::tape::Tape::compile(graph, &leaves, &[e]).ok()?;
        let values: Vec<_> = leaves.iter().map(|&l| self.parameter(trajectory, l)).collect();
        tape.determined(&values).pop()?.ok()
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
    /// What it is made after.
    pattern: Option<&'a Pattern>,
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
    requests: &Requests<'a>,
    recall: &dyn Recall,
    estimation: Estimation,
) -> Vec<Result<Option<Together>, CheckError>> {
    let late = || requests.limits.is_over();
    let begin = |(derivation, members)| begin(derivation, fields, requests, members, recall);
    let mut begun: Vec<Progress> = families.map(begin).collect();
    let drafts = begun.iter_mut().filter_map(|progress| match progress {
        Progress::Begun(begun) => Some(&mut begun.draft),
        Progress::Done(_) => None,
    });
    let integrated = Draft::integrate(drafts, estimation, &late);
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
    requests: &Requests<'a>,
    members: &'a [usize],
    recall: &dyn Recall,
) -> Progress<'a> {
    if let Some(known) = recall.motions(derivation, requests, members) {
        return Progress::Done(Ok(known));
    }
    let is_first = |t: &&usize| !matches!(derivation.trajectories[**t].motion, Given::Derived { .. });
    let Some(&first) = members.iter().find(is_first) else { return Progress::Done(Ok(Vec::new())) };
    let mut graph = derivation.graph.clone();
    let trajectory = &derivation.trajectories[first];
    let pattern = requests.pattern.filter(|_| members.len() == 1 && requests.tried.binary_search(&first).is_ok());
    if let Some(draft) = pattern.and_then(|pattern| pattern.draft(derivation, fields, &mut graph, first)) {
        let known = Vec::new();
        return Progress::Begun(Box::new(Begun { derivation, members, graph, first, known, pattern, draft }));
    }
    let (setup, known) = setup(derivation, fields, &mut graph, trajectory, None, false, requests.idle);
    match Draft::new(&mut graph, setup) {
        Ok(draft) => {
            Progress::Begun(Box::new(Begun { derivation, members, graph, first, known, pattern: None, draft }))
        }
        Err(error) => Progress::Done(Err(CheckError::Problems(vec![unbuilt(derivation, trajectory, &error)]))),
    }
}

impl Begun<'_> {
    /// The motions, in the order of the file as far as sources come first.
    fn finish(
        self,
        fields: &Fields,
        requests: &Requests,
        recall: &dyn Recall,
    ) -> Result<Vec<(usize, Built)>, CheckError> {
        let Begun { derivation, members, mut graph, first, known, pattern, draft } = self;
        let told = |t: usize, error: &FlowError| {
            CheckError::Problems(vec![unbuilt(derivation, &derivation.trajectories[t], error)])
        };
        if let Some(pattern) = pattern {
            let built = pattern.finish(derivation, &graph, first, draft).map_err(|error| told(first, &error))?;
            return Ok(vec![(first, built)]);
        }
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
                let (setup, known) = setup(derivation, fields, &mut graph, trajectory, from, false, requests.idle);
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
        recall.keep(derivation, members, graph, &done);
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

/// Compiles what points need, and finds the events.
pub(crate) fn prepare(
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
    let (searched, rapid) = searched(derivation, requests, trajectory);
    let searches = motion.searches(graph, (&searched, &rapid), span).map_err(|e| CheckError::Defect(e.to_string()))?;
    let rapid = (rapid, searches.rapid);
    // What a motion does not know is not searched for.
    let searches = searched.into_iter().zip(searches.zeros).filter_map(|(e, s)| Some((e, s.ok()?))).collect();
    let of = &derivation.trajectories[trajectory].parameters;
    let given = of.iter().map(|(s, w)| (*s, closed_values(graph, &w.value))).collect();
    let initial_time = derivation.trajectories[trajectory].initial_time;
    let (motion, samples) = (Arc::new(motion), Arc::default());
    Ok(Built { motion, known, asked, places, span, initial_time, given, searches, rapid, samples })
}

/// What zeros are searched for of on a motion, each once, since claims and measures ask for the same again and again; and what may
/// vary more rapidly than it is sampled.
pub fn searched(derivation: &Derivation, requests: &Requests, trajectory: usize) -> (Vec<Expr>, Vec<Expr>) {
    let (mut searched, mut rapid): (BTreeSet<Expr>, BTreeSet<Expr>) = Default::default();
    if requests.tried.binary_search(&trajectory).is_ok() {
        for (claim, programs) in requests.claims.iter().zip(requests.programs) {
            if claim.trajectories.binary_search(&trajectory).is_ok() {
                let program = &programs[requests.start_of[trajectory]];
                searched.extend(program.searched());
                rapid.extend(&program.rapid);
            }
        }
        let measured = (requests.measured)(derivation, trajectory);
        searched.extend(measured.zeros);
        rapid.extend(measured.rapid);
    }
    (searched.into_iter().collect(), rapid.into_iter().collect())
}

/// The values of expressions without leaves; those before the first that has none.
pub(crate) fn closed_values(graph: &Graph, exprs: &[Expr]) -> Vec<Bounded> {
    let Ok(tape) = expr::tape::Tape::compile(graph, &[], exprs) else { return Vec::new() };
    tape.determined(&[]).into_iter().map_while(Result::ok).collect()
}
