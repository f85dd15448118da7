//! The values that a refuting point is recomputed from.
//!
//! **In:** the witnesses of all verdicts, as whatever found them left them: a sample, an enclosure, exact arithmetic. **Out:** the
//! same witnesses, each with the value of everything that *its own* comparison depends on, at *its own* time.
//!
//! **Guaranteed.** What stands beside a witness belongs to the component that fails: it is looked up by the label of the
//! witness, after all methods are done, so that no method can hand over the values of another one. A side that has no value is
//! no number.

use std::sync::Arc;

use crate::claim_program::Prepared;
use crate::derivation::{Derivation, Form};
use crate::describe::named;
use crate::expr::{Expr, FastMap, Leaf};
use crate::findings::ClaimAccount;
use crate::latex::RelationKind;
use crate::same_motion;
use crate::stage::Stage;
use crate::verdict::{ResidualPoint, Residuals, Witness};
use claim::program::{Part, Program};

/// What the witness of a limit at infinity is called beside its formula.
const IN_THE_LIMIT: &str = ", in the limit";

/// What is needed to find the values at a point of a motion.
pub struct Points<'a> {
    pub derivation: &'a Derivation,
    pub stage: &'a Stage,
    pub prepared: &'a [Vec<Prepared<'a>>],
    pub start_of: &'a [usize],
    pub tried: &'a [usize],
    /// The leaves that motions have values of, increasing.
    pub wanted: &'a [Leaf],
}

/// Gives every witness the values of its own comparison. The claims are in the order of what was prepared.
pub fn complete(points: &Points, claims: &mut [ClaimAccount]) {
    let trajectories = &points.derivation.trajectories;
    let known: FastMap<&str, usize> = points.tried.iter().map(|&t| (trajectories[t].id.as_str(), t)).collect();
    for (k, claim) in claims.iter_mut().enumerate() {
        for pair in &mut claim.results {
            let Some(witness) = pair.verdict.evidence().witness.as_ref() else { continue };
            let Some(&t) = known.get(pair.trajectory.as_str()) else { continue };
            let prepared = &points.prepared[k][points.start_of[t]];
            let complete = of_point(points, prepared, t, witness.clone());
            let series = pair.verdict.evidence().series.as_ref().filter(|s| s.formula != complete.formula);
            let series = series.and_then(|s| drawn(points, prepared, t, &complete, s));
            pair.verdict.show(complete, series);
        }
    }
}

fn of_point(points: &Points, prepared: &Prepared, t: usize, mut witness: Witness) -> Witness {
    let graph = &points.derivation.graph;
    let values = points.stage.values(t, witness.t);
    let value = |leaf: Leaf| {
        let at = points.wanted.binary_search(&leaf).ok()?;
        values.get(at)?.as_ref().ok().map(|v| v.value)
    };
    if let Some(state) = witness.formula.strip_suffix(" of both motions") {
        witness.values = both(points, prepared, state, &witness);
        return witness;
    }
    if let Some(Ok(gradients)) = prepared.gradients.as_ref().filter(|_| witness.formula.starts_with("rank of")) {
        let (_, rows) = gradients.rows();
        witness.values = named(graph, rows.into_iter().flatten().copied(), value);
        return witness;
    }
    let label = witness.formula.trim_end_matches(IN_THE_LIMIT);
    let (sides, undefined) = sides(&prepared.program, label);
    if sides.is_empty() {
        return witness;
    }
    if label.len() < witness.formula.len() {
        // At infinity only what is itself a quantity of the motion has a value: the limit that was found.
        let limit = sides.first().filter(|e| matches!(graph.node(**e), crate::expr::Node::Leaf(_)));
        witness.values = named(graph, limit.copied(), |_| Some(witness.left));
        return witness;
    }
    if undefined {
        (witness.left, witness.right) = (f64::NAN, f64::NAN);
    }
    witness.values = named(graph, sides, value);
    witness
}

/// The sides of what has this label, the links of a chain among them; and whether it is that something has a value.
fn sides(program: &Program, label: &str) -> (Vec<Expr>, bool) {
    let mut out = Vec::new();
    let mut undefined = false;
    // The conditions under which a vector has a value are those of all its components.
    let whole = label.split("   [").next().unwrap_or(label);
    for part in &program.parts {
        let named = |other: &str| other == label || part.is_definedness() && other == whole;
        for c in part.group.comparisons.iter().filter(|c| named(&c.label)) {
            out.extend([c.left, c.right]);
            undefined |= part.is_definedness();
        }
    }
    (out, undefined)
}

/// The curve of the comparison that the witness is of, at the times of the one that was drawn, and at that of the witness. For ±
/// no sign is that of all times: then there is none.
fn drawn(
    points: &Points,
    prepared: &Prepared,
    t: usize,
    witness: &Witness,
    before: &Residuals,
) -> Option<Arc<Residuals>> {
    let compared = |p: &&Part| p.is_compared() && !p.is_definedness() && !p.group.branching;
    let parts = prepared.program.parts.iter().filter(compared);
    let comparison = parts.flat_map(|p| &p.group.comparisons).find(|c| c.label == witness.formula)?;
    let at = prepared.program.position(comparison)?;
    let mut times: Vec<(f64, f64)> = before.points.iter().map(|p| (p.t, p.limit)).collect();
    let limit = times.first().map_or(0.0, |(_, limit)| *limit);
    if !times.iter().any(|(time, _)| *time == witness.t) {
        times.push((witness.t, limit));
    }
    times.sort_by(|a, b| a.0.total_cmp(&b.0));
    let at_times: Vec<f64> = times.iter().map(|(time, _)| *time).collect();
    let values = points.stage.points(t, &at_times, prepared.program.inputs());
    let series = prepared.program.measure((&values, times.len()), 1.0);
    let measured = times.iter().enumerate().filter_map(|(i, &(t, limit))| {
        let m = series.get(at)?.get(i).ok()?;
        let (residual, bound) = (m.difference.value.abs(), m.difference.error);
        Some(ResidualPoint { t, left: m.left, right: m.right, residual, bound, limit })
    });
    let points: Vec<ResidualPoint> = measured.collect();
    let equation = comparison.kind == RelationKind::Equal;
    Some(Arc::new(Residuals { formula: comparison.label.clone(), equation, points, ..before.clone() }))
}

/// A state of a motion and of the one that it is compared with.
fn both(points: &Points, prepared: &Prepared, state: &str, witness: &Witness) -> Vec<(String, f64)> {
    let other = prepared.claim.forms.iter().find_map(|form| match form {
        Form::SameMotion { other, .. } => points.derivation.trajectories.get(*other),
        _ => None,
    });
    let known =
        same_motion::leaves(points.derivation).into_iter().any(|l| points.derivation.graph.leaf_latex(l) == state);
    match other.filter(|_| known) {
        Some(other) => {
            vec![(state.to_owned(), witness.left), (format!("{state} on {}", other.id), witness.right)]
        }
        None => Vec::new(),
    }
}
