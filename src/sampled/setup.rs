//! What a motion is made from.
//!
//! **In:** a trajectory as it is declared, with the motion that it is derived from. **Out:** a [`Setup`] for `flow`, and the symbols that
//! the motion knows: a leaf of any other has no value on it.

use std::sync::Arc;

use crate::systems::{Fields, leaves_of, paired};
use derivation::{Derivation, Motion as Given, SymbolEntry, Trajectory, Written};
use expr::{Expr, Graph, Leaf, Symbol};
use flow::{Guess, Motion, Observable, Setup, Source, Start};
use latex::Role;

/// What a motion is made from, and the symbols that it knows. `from` is the motion that a derived one comes from, with the
/// symbols that that one knows. Parameters that are ends of the span are what these are in binary64, unless they shall be `exact`. What is `left_out`, and what is made of it, the motion does not know.
pub fn setup<'a>(
    derivation: &Derivation,
    fields: &'a Fields,
    graph: &mut Graph,
    trajectory: &Trajectory,
    from: Option<(Arc<Motion>, &[Symbol])>,
    exact: bool,
    left_out: &[Symbol],
) -> (Setup<'a>, Vec<Symbol>) {
    let Derivation { scope, systems, symbols, claims, .. } = derivation;
    let parameters = parameters(graph, trajectory, exact);
    let mut known = vec![fields.time.symbol];
    known.extend(trajectory.parameters.iter().map(|(symbol, _)| *symbol));
    let source = match (&trajectory.motion, from) {
        (Given::Integrated { system, initial, start }, _) => {
            known.extend(&systems[*system].states);
            let start = start.as_ref().map_or_else(Start::default, |start| Start {
                guesses: start
                    .unknowns
                    .iter()
                    .map(|u| Guess { leaf: u.leaf, name: u.name.clone(), near: u.near, within: u.within })
                    .collect(),
                differences: start.differences.clone(),
            });
            Source::Integrated { field: &fields.fields[*system], initial: initial_values(graph, initial), start }
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
        let Some(definition) = derivation.definition(entry.symbol) else { continue };
        let is_left_out = left_out.contains(&entry.symbol);
        if is_left_out || known.contains(&entry.symbol) || !all_known(graph, &known, &definition.components) {
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

/// The parameters of a trajectory, component by component: what the file says.
pub(crate) fn parameters(graph: &mut Graph, trajectory: &Trajectory, exact: bool) -> Vec<(Leaf, Expr)> {
    let ends = [trajectory.span.0, trajectory.span.1, trajectory.initial_time];
    let mut parameters: Vec<(Leaf, Expr)> = Vec::new();
    for (symbol, value) in &trajectory.parameters {
        parameters.retain(|(l, _)| l.symbol != *symbol);
        let values: Vec<Expr> = value.value.iter().map(|&e| if exact { e } else { as_time(graph, e, &ends) }).collect();
        parameters.extend(paired(graph, *symbol, 0, &values));
    }
    parameters
}

/// A number of the file that is an end of the span, too, is that end: times are numbers of binary64.
fn as_time(graph: &mut Graph, e: Expr, ends: &[f64]) -> Expr {
    let nearest = graph.as_constant(e).map(|r| r.to_f64().value()).filter(|x| *x != 0.0 && ends.contains(x));
    match nearest.and_then(|x| expr::Rational::try_from(x).ok()) {
        Some(r) => graph.constant(r),
        None => e,
    }
}

/// What is given at the initial time, component by component.
pub(crate) fn initial_values(graph: &Graph, initial: &[(Symbol, u8, Written<Vec<Expr>>)]) -> Vec<(Leaf, Expr)> {
    initial.iter().flat_map(|(s, rate, w)| paired(graph, *s, *rate, &w.value)).collect()
}

/// The angles that motions need not be followed for: those that are neither wanted, nor part of what is wanted or of the motions.
pub fn idle_angles(derivation: &Derivation, trajectories: &[usize], wanted: &[Leaf]) -> Vec<Symbol> {
    let Derivation { symbols, claims, graph, .. } = derivation;
    let entries = symbols.iter().chain(claims.iter().flat_map(|c| &c.symbols));
    let mut idle: Vec<Symbol> = entries.filter(|e| e.angle).map(|e| e.symbol).collect();
    if idle.is_empty() {
        return idle;
    }
    let of_motions = trajectories.iter().flat_map(|&t| derivation.trajectories[t].motion.formulas());
    let mut left: Vec<Leaf> = wanted.iter().copied().chain(graph.leaves(of_motions)).collect();
    let mut seen: Vec<Symbol> = Vec::new();
    while let Some(leaf) = left.pop() {
        left.extend(leaf.instant.iter().flat_map(|&instant| graph.leaves([instant])));
        if seen.contains(&leaf.symbol) {
            continue;
        }
        seen.push(leaf.symbol);
        if let Some(definition) = derivation.definition(leaf.symbol) {
            left.extend(graph.leaves(definition.components.iter().copied()));
        }
    }
    idle.retain(|symbol| !seen.contains(symbol));
    idle
}

/// Whether a leaf has a meaning on a motion that knows these symbols.
pub fn is_known(graph: &Graph, known: &[Symbol], leaf: Leaf) -> bool {
    known.contains(&leaf.symbol) && leaf.instant.is_none_or(|e| all_known(graph, known, &[e]))
}

/// Whether every leaf of the expressions belongs to a known symbol.
fn all_known(graph: &Graph, known: &[Symbol], roots: &[Expr]) -> bool {
    graph
        .leaves(roots.iter().copied())
        .iter()
        .all(|l| known.contains(&l.symbol) && l.instant.is_none_or(|e| all_known(graph, known, &[e])))
}
