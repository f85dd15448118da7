//! Trajectories of a derivation file → motions.
//!
//! **In:** systems, trajectories and observables as declared. **Out:** [`Stage`]: one [`Motion`] for each trajectory, with
//! everything compiled that claims will ask for. A leaf that a motion does not know (a parameter it was not given, a state
//! of another system) has no value there, which makes claims that need it not applicable rather than wrong.

use std::collections::HashMap;
use std::sync::Arc;

use super::account::TrajectoryAccount;
use super::program::{Program, Use};
use super::trial::{Course, Events, Values};
use crate::derivation::{Derivation, Motion as Given, SymbolEntry};
use crate::diag::Diagnostic;
use crate::expr::{Expr, Graph, Leaf, Symbol};
use crate::flow::{FlowError, Motion, Observable, Setup, Source, VectorField, Zeros};
use crate::latex::Role;
use crate::number::{Bounded, NoValue};

/// Chebyshev points in each step of an integration.
const DENSITY: usize = 6;
/// Most sample times of a motion: a long one is sampled more thinly, at every n-th time.
const MOST_SAMPLES: usize = 4_000;
/// Every how many samples dual numbers are compared with the bounds.
const CROSS_CHECK: usize = 8;

/// The motions of a derivation.
pub(super) struct Stage {
    motions: Vec<Arc<Motion>>,
    known: Vec<Vec<Symbol>>,
    places: Vec<Vec<Option<usize>>>,
    state_leaves: Vec<Leaf>,
    /// Values of the parameters of each trajectory.
    given: Vec<Vec<(Symbol, Vec<Bounded>)>>,
}

/// The leaves of all components of a symbol.
fn leaves_of(graph: &Graph, symbol: Symbol) -> Vec<Leaf> {
    let count = graph.component_count(symbol);
    (0..count).map(|c| Leaf { symbol, component: c as u16, rate: 0, instant: None }).collect()
}

fn paired(graph: &Graph, symbol: Symbol, rate: u8, values: &[Expr]) -> Vec<(Leaf, Expr)> {
    leaves_of(graph, symbol).into_iter().map(|l| Leaf { rate, ..l }).zip(values.iter().copied()).collect()
}

impl Stage {
    /// Solves the systems and builds the motions.
    ///
    /// # Errors
    /// A diagnostic for every system that cannot be solved and every trajectory that cannot be built.
    pub fn build(derivation: &mut Derivation) -> Result<Stage, Vec<Diagnostic>> {
        let mut problems = Vec::new();
        let Derivation { graph, scope, systems, trajectories, symbols, file, claims, .. } = derivation;
        let Some(time) = scope.time() else {
            return Err(vec![
                Diagnostic::at(file, "derivation::no-time", 0..0, "no symbol has the role `time`")
                    .hint("add `'t' = { role = \"time\" }` to [symbols]"),
            ]);
        };
        let mut fields: Vec<Option<VectorField>> = Vec::new();
        for system in systems.iter() {
            let mut equations = Vec::new();
            for relation in system.equations.iter().flat_map(|w| &w.value.relations) {
                let sides = relation.left.components.iter().zip(&relation.right.components);
                equations.extend(sides.map(|(&l, &r)| (l, r)));
            }
            // Observables on the right side are part of the system: it is closed in its states.
            let closed: Vec<(Expr, Expr)> = equations
                .into_iter()
                .map(|(l, r)| {
                    (super::independence::expand(graph, scope, l), super::independence::expand(graph, scope, r))
                })
                .collect();
            match VectorField::solve(graph, Some(time), &system.states, &closed) {
                Ok(field) => fields.push(Some(field)),
                Err(error) => {
                    problems.push(Diagnostic::at(
                        file,
                        "flow::system",
                        system.span.clone(),
                        format!("the system `{}` cannot be solved for its rates: {error}", system.id),
                    ));
                    fields.push(None);
                }
            }
        }
        let mut entries: Vec<&SymbolEntry> = symbols.iter().collect();
        entries.extend(claims.iter().flat_map(|c| &c.symbols));

        let mut motions: Vec<Option<Arc<Motion>>> = vec![None; trajectories.len()];
        let mut known: Vec<Vec<Symbol>> = vec![Vec::new(); trajectories.len()];
        // A derived motion may stand before its source in the file.
        for _ in 0..=trajectories.len() {
            for (i, trajectory) in trajectories.iter().enumerate() {
                if motions[i].is_some() {
                    continue;
                }
                let mut parameters = Vec::new();
                let mut knows = vec![time.symbol];
                for (symbol, value) in &trajectory.parameters {
                    parameters.retain(|(l, _): &(Leaf, Expr)| l.symbol != *symbol);
                    parameters.extend(paired(graph, *symbol, 0, &value.value));
                    knows.push(*symbol);
                }
                let source = match &trajectory.motion {
                    Given::Integrated { system, initial } => {
                        let Some(Some(field)) = fields.get(*system) else { continue };
                        knows.extend(&systems[*system].states);
                        let mut values = Vec::new();
                        for (symbol, rate, w) in initial {
                            values.extend(paired(graph, *symbol, *rate, &w.value));
                        }
                        Source::Integrated { field, initial: values }
                    }
                    Given::Formula { states } => {
                        knows.extend(states.iter().map(|(s, _)| *s));
                        let values = states.iter().flat_map(|(s, w)| paired(graph, *s, 0, &w.value)).collect();
                        Source::Formula { states: values }
                    }
                    Given::Derived { from, map } => {
                        let Some(Some(source)) = motions.get(*from).cloned() else { continue };
                        let mut states: Vec<(Leaf, Expr)> = Vec::new();
                        for &symbol in &known[*from] {
                            if scope.role(symbol) == Some(Role::State) && !map.iter().any(|(s, _)| *s == symbol) {
                                for leaf in leaves_of(graph, symbol) {
                                    let e = graph.leaf(leaf);
                                    states.push((leaf, e));
                                }
                                knows.push(symbol);
                            }
                        }
                        for (symbol, w) in map {
                            states.extend(paired(graph, *symbol, 0, &w.value));
                            knows.push(*symbol);
                        }
                        Source::Derived { from: source, states }
                    }
                };
                let mut observables = Vec::new();
                for entry in entries.iter().filter(|e| e.role == Role::Observable) {
                    let definition = scope
                        .definition(entry.symbol)
                        .or_else(|| claims.iter().find_map(|c| c.scope.definition(entry.symbol)));
                    let Some(definition) = definition else { continue };
                    let roots = definition.components.clone();
                    if !all_known(graph, &knows, &roots) {
                        continue;
                    }
                    knows.push(entry.symbol);
                    for (leaf, e) in paired(graph, entry.symbol, 0, &roots) {
                        observables.push(Observable { leaf, definition: e, angle: entry.angle });
                    }
                }
                let setup = Setup {
                    time,
                    span: trajectory.span,
                    initial_time: trajectory.initial_time,
                    parameters,
                    source,
                    observables,
                };
                match Motion::new(graph, setup) {
                    Ok(motion) => {
                        motions[i] = Some(Arc::new(motion));
                        known[i] = knows;
                    }
                    Err(error) => {
                        problems.push(trajectory_problem(file, trajectory.place.clone(), &trajectory.id, &error));
                        known[i] = knows;
                    }
                }
            }
            if !problems.is_empty() || motions.iter().all(Option::is_some) {
                break;
            }
        }
        crate::diag::sort(&mut problems);
        let built: Vec<Arc<Motion>> = motions.into_iter().flatten().collect();
        if !problems.is_empty() || built.len() != trajectories.len() {
            if problems.is_empty() {
                problems.push(Diagnostic::at(file, "flow::trajectory", 0..0, "a trajectory could not be built"));
            }
            return Err(problems);
        }
        let mut state_leaves: Vec<Leaf> = fields.iter().flatten().flat_map(|f| f.states().to_vec()).collect();
        let of_formulas = symbols.iter().filter(|s| s.role == Role::State).flat_map(|s| leaves_of(graph, s.symbol));
        state_leaves.extend(of_formulas);
        state_leaves.sort_unstable();
        state_leaves.dedup();
        let given = trajectories
            .iter()
            .map(|t| t.parameters.iter().map(|(s, w)| (*s, closed_values(graph, &w.value))).collect())
            .collect();
        Ok(Stage { motions: built, known, places: Vec::new(), state_leaves, given })
    }

    /// The state variables of all systems.
    pub fn state_leaves(&self) -> Vec<Leaf> {
        self.state_leaves.clone()
    }

    /// A motion, by the position of its trajectory.
    pub fn motion(&self, trajectory: usize) -> &Motion {
        &self.motions[trajectory]
    }

    /// Compiles everything that points must have values of.
    ///
    /// # Errors
    /// A description of the leaf that could not be compiled.
    pub fn prepare(&mut self, graph: &mut Graph, wanted: &[Leaf]) -> Result<(), String> {
        for (motion, known) in self.motions.iter_mut().zip(&self.known) {
            let mut places = Vec::new();
            let mut asked = Vec::new();
            for &leaf in wanted {
                let node = leaf.instant;
                let here = known.contains(&leaf.symbol) && node.is_none_or(|e| all_known(graph, known, &[e]));
                places.push(here.then_some(asked.len()));
                if here {
                    asked.push(leaf);
                }
            }
            let mut prepared = Motion::clone(motion);
            prepared.prepare(graph, &asked).map_err(|e| e.to_string())?;
            *motion = Arc::new(prepared);
            self.places.push(places);
        }
        Ok(())
    }

    /// The values of the wanted leaves on a motion at a time.
    pub fn values(&self, trajectory: usize, t: f64) -> Values {
        let point = self.motions[trajectory].at(t);
        let place = |p: &Option<usize>| p.and_then(|i| point.get(i).copied()).unwrap_or(Err(NoValue::OutOfDomain));
        self.places[trajectory].iter().map(place).collect()
    }

    /// Samples a motion, and compares the two routes to its values.
    ///
    /// # Errors
    /// A description of a value for which dual numbers and propagated bounds disagree.
    pub fn course<'a>(&'a self, graph: &Graph, trajectory: usize, leaves: &'a [Leaf]) -> Result<Course<'a>, String> {
        let motion = &self.motions[trajectory];
        let mut times = motion.sample_times(DENSITY);
        if times.len() > MOST_SAMPLES {
            let step = times.len().div_ceil(MOST_SAMPLES);
            let last = times.last().copied();
            times = times.into_iter().step_by(step).collect();
            times.extend(last.filter(|t| times.last() != Some(t)));
        }
        let points: Vec<Values> = times.iter().map(|&t| self.values(trajectory, t)).collect();
        for (i, &t) in times.iter().enumerate().step_by(CROSS_CHECK) {
            let duals = motion.dual_at(t);
            for (k, place) in self.places[trajectory].iter().enumerate() {
                let (Some(place), Ok(bounded)) = (place, &points[i][k]) else { continue };
                let Some(Ok(dual)) = duals.get(*place) else { continue };
                let gap = (dual.re - bounded.value).abs();
                // Both routes round on their own way: the bound of one covers its distance from the truth.
                let room = 2.0 * bounded.error + 1e-12 * bounded.value.abs() + f64::MIN_POSITIVE;
                if gap > room.max(1e-14) && gap > 1e3 * bounded.error {
                    return Err(format!(
                        "{} at t = {t}: {} by dual numbers, {} ± {:e} by series",
                        graph.leaf_latex(leaves[k]),
                        dual.re,
                        bounded.value,
                        bounded.error
                    ));
                }
            }
        }
        Ok(Course { stage: self, trajectory, motion, leaves, times, points })
    }

    /// Finds the events that claims ask for: `[claim][trajectory]`.
    pub fn events(
        &self,
        derivation: &mut Derivation,
        claimed: &[usize],
        tried: &[usize],
        programs: &[Vec<Program>],
        start_of: &[usize],
    ) -> HashMap<(usize, usize), Events> {
        let mut out = HashMap::new();
        for (k, &c) in claimed.iter().enumerate() {
            for t in derivation.claims[c].trajectories.clone() {
                if !tried.contains(&t) {
                    continue;
                }
                let program = &programs[k][start_of[t]];
                let mut events = Events::default();
                events.at = program.at.and_then(|e| self.zeros(&mut derivation.graph, t, e));
                for (position, (how, _)) in program.groups.iter().enumerate() {
                    if let Use::Never(Some(e)) | Use::Eventually(Some(e)) = how
                        && let Some(zeros) = self.zeros(&mut derivation.graph, t, *e)
                    {
                        events.occurrences.push((position, zeros));
                    }
                }
                if events.at.is_some() || !events.occurrences.is_empty() {
                    out.insert((k, t), events);
                }
            }
        }
        out
    }

    /// The value of an expression in parameters on a motion.
    pub fn constant(&self, graph: &Graph, trajectory: usize, e: Expr) -> Option<Bounded> {
        let leaves = graph.leaves([e]);
        let tape = crate::tape::Tape::compile(graph, &leaves, &[e]).ok()?;
        let mut slots = tape.slots::<Bounded>(&());
        let values: Vec<_> = leaves.iter().map(|&l| self.parameter(trajectory, l)).collect();
        tape.evaluate(&(), &values, &mut slots).pop()?.ok()
    }

    fn parameter(&self, trajectory: usize, leaf: Leaf) -> Result<Bounded, NoValue> {
        let given = self.given[trajectory].iter().find(|(s, _)| *s == leaf.symbol);
        given.and_then(|(_, v)| v.get(usize::from(leaf.component)).copied()).ok_or(NoValue::OutOfDomain)
    }

    /// The zeros of an expression on a motion; `None` where the motion does not know what it depends on.
    pub fn zeros(&self, graph: &mut Graph, trajectory: usize, e: Expr) -> Option<Zeros> {
        if !all_known(graph, &self.known[trajectory], &[e]) {
            return None;
        }
        self.motions[trajectory].zeros(graph, e).ok()
    }

    /// A trajectory for the reports.
    pub fn account(&self, derivation: &Derivation, trajectory: usize) -> TrajectoryAccount {
        let given = &derivation.trajectories[trajectory];
        let motion = &self.motions[trajectory];
        let mut values = Vec::new();
        for (symbol, numbers) in &self.given[trajectory] {
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
        TrajectoryAccount {
            id: given.id.clone(),
            title: given.title.clone(),
            span: motion.span(),
            source: given.source(),
            given: values,
            steps: motion.steps(),
            error: motion.error().into_iter().fold(0.0, f64::max),
            problem: motion.problem().map(ToString::to_string),
        }
    }
}

/// The values of expressions without leaves; those before the first that has none.
fn closed_values(graph: &Graph, exprs: &[Expr]) -> Vec<Bounded> {
    let Ok(tape) = crate::tape::Tape::compile(graph, &[], exprs) else { return Vec::new() };
    let mut slots = tape.slots::<Bounded>(&());
    tape.evaluate(&(), &[], &mut slots).into_iter().map_while(Result::ok).collect()
}

/// Whether every leaf of the expressions belongs to a known symbol.
fn all_known(graph: &Graph, known: &[Symbol], roots: &[Expr]) -> bool {
    graph
        .leaves(roots.iter().copied())
        .iter()
        .all(|l| known.contains(&l.symbol) && l.instant.is_none_or(|e| all_known(graph, known, &[e])))
}

fn trajectory_problem(
    file: &Arc<crate::diag::Source>,
    place: std::ops::Range<usize>,
    id: &str,
    error: &FlowError,
) -> Diagnostic {
    Diagnostic::at(file, "flow::trajectory", place, format!("the trajectory `{id}` cannot be built: {error}"))
}
