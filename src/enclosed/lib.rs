//! Verdicts for every time of a span, with rounding accounted for.
//!
//! **In:** the verdicts that samples gave, and the derivation. **Out:** the same verdicts, of which some are stronger:
//! `holds` becomes *enclosed*, `fails` becomes *certified*, and `undecided` is decided where only an enclosure could. A verdict
//! that stays as it was says why.
//!
//! **Guaranteed.** The motion is enclosed by validated integration, with the numbers of the file as they are written (not
//! rounded). What is then shown is:
//!
//! | comparison | *enclosed* means: at every time of the span that counts |
//! |---|---|
//! | left = right | \|left − right\| ≤ precision · scale, and no stretch of time is found on which left ≠ right for certain |
//! | <, >, ≠ | the relation holds |
//! | ≤, ≥ | the relation holds, or is missed by at most precision · scale |
//! | has a value | every operation has a value |
//!
//! The allowances count only where equations are claimed of every time: not under `eventually`, in selectors, at what must not be.
//! `scale` is the median size of the terms along the motion. Hypotheses are enclosed as claims are.
//! *Certified* means that there is a time, in the span, at which the assumptions hold and the relation does not.
//!
//! An enclosure may find what lies between samples, and refute what held on all of them. Where the two contradict each other
//! at one and the same time, the enclosure stands: the sampled motion is withdrawn for all claims, and that is said.

#![forbid(unsafe_code)]

use ::{derivation, expr, findings, flow, latex, number, verdict};

mod cover;
mod event;
mod integral;
mod limit;
mod pair;
mod rank;
mod ready;
mod request;
mod same;
mod span;
#[cfg(test)]
mod tests;

use crate::derivation::Motion as Given;
use crate::expr::{Expr, Graph, Leaf};
use crate::findings::{ClaimAccount, by_trajectory};
use crate::flow::{Enclosure, Motion, Source};
use crate::verdict::Verdict;
use claim::comparison::Comparison;
use cover::Along;
use meter::{Ended, Limits, Task};
use reason::{Enclosing, Reason};
pub use request::{Answer, Question, Recall, Request};
use sampled::claim_program::Prepared;
use sampled::setup::setup;

/// A verdict that is stronger now, or says why it is not: claim, position among its results, verdict.
type Change = (usize, usize, Verdict);

/// Strengthens the verdicts that are not proved.
pub fn strengthen(request: &Request, claims: &mut [ClaimAccount]) {
    let mut graph = request.derivation.graph.clone();
    let integrals = integral::of_systems(request, &mut graph);
    let by: Vec<String> = integrals
        .iter()
        .map(|of| format!("{:?}\n", of.iter().map(|&e| graph.to_latex(e)).collect::<Vec<_>>()))
        .collect();
    let (known, by) = ((&graph, integrals.as_slice()), by.concat());
    // Long motions first: what is left at the end is short.
    let mut order = request.selection.tried.clone();
    order.sort_by_key(|&t| std::cmp::Reverse(request.stage.motion(t).map_or(0, Motion::steps)));
    let results = by_trajectory(claims);
    let one = |&t: &usize, limits: &Limits| {
        let here = results.get(request.derivation.trajectories[t].id.as_str());
        one_motion((request, limits), (known, &by), t, (claims, here.map_or(&[], Vec::as_slice)))
    };
    let changes: Vec<Vec<Change>> = meter::each(request.limits, &order, one);
    for (k, at, verdict) in changes.into_iter().flatten() {
        claims[k].results[at].verdict = verdict;
    }
}

/// The enclosure of a motion, and of those that it comes from; beside it the parameters and initial states as they are given.
fn enclosure(
    request: &Request,
    integrals: &[Vec<Expr>],
    graph: &mut Graph,
    t: usize,
) -> Result<(Enclosure, Vec<(Leaf, Expr)>), Reason> {
    let trajectory = &request.derivation.trajectories[t];
    let (from, source) = match trajectory.motion {
        Given::Derived { from, .. } => {
            (Some(enclosure(request, integrals, graph, from)?.0), request.stage.source(from))
        }
        _ => (None, None),
    };
    let (setup, _) = setup(request.derivation, request.fields, graph, trajectory, source, true, &[]);
    let mut start = setup.parameters.clone();
    if let Source::Integrated { initial, .. } = &setup.source {
        start.extend(initial);
    }
    let known = request.recall.steps();
    let mut enclosed = Enclosure::recalling(graph, &setup, from.as_ref(), known).map_err(Reason::quoted)?;
    if let Given::Integrated { system, .. } = trajectory.motion {
        enclosed.conserve(graph, &integrals[system]);
    }
    Ok((enclosed, start))
}

/// What the systems conserve, in a graph that knows it.
type Known<'a> = (&'a Graph, &'a [Vec<Expr>]);

/// `here` are the results on the motion, by the positions of the claim and of the result.
fn one_motion(
    (request, limits): (&Request, &Limits),
    (known, integrals): (Known, &str),
    motion: usize,
    (claims, here): (&[ClaimAccount], &[(usize, usize)]),
) -> Vec<Change> {
    let found = |&(k, at): &(usize, usize)| (k, at, &claims[k].results[at].verdict);
    let open = here.iter().map(found).filter(|(.., verdict)| !pair::is_rigorous(verdict.outcome()));
    let open: Vec<(usize, usize, &Verdict)> = open.collect();
    let question = |at: usize| {
        let (k, _, before) = open[at];
        Question { claim: request.prepared[k][request.selection.start_of[motion]].claim, motion, before, integrals }
    };
    let mut answers: Vec<Option<Answer>> = (0..open.len()).map(|at| request.recall.known(&question(at))).collect();
    let left: Vec<usize> = (0..open.len()).filter(|&at| answers[at].is_none()).collect();
    let asked: Vec<(usize, &Verdict)> = left.iter().map(|&at| (open[at].0, open[at].2)).collect();
    if !asked.is_empty() {
        let found = meter::piece(Task::Enclosing, limits, || enclose(request, known, motion, &asked));
        let found = found.unwrap_or_else(|ended| asked.iter().map(|(_, verdict)| ended_by(verdict, &ended)).collect());
        for (at, answer) in left.into_iter().zip(found) {
            request.recall.keep(&question(at), &answer);
            answers[at] = Some(answer);
        }
    }
    // What is rigorous stands; the sampled motion is not what its error bounds say.
    let withdrawn = answers.iter().flatten().find_map(|answer| answer.contradiction.clone());
    let withdrawn = withdrawn.map(|reason| Reason::from(Enclosing::Withdrawn(std::sync::Arc::new(reason))));
    let change = |((k, at, _), answer): ((usize, usize, &Verdict), Option<Answer>)| {
        let mut verdict = answer?.verdict;
        withdrawn.iter().for_each(|reason| verdict.withdraw_samples(reason));
        Some((k, at, verdict))
    };
    open.iter().copied().zip(answers).filter_map(change).collect()
}

/// An answer where the enclosure ended before it was done.
fn ended_by(verdict: &Verdict, ended: &Ended) -> Answer {
    let (mut verdict, reason) = (verdict.clone(), Reason::from(ended.clone()));
    match ended {
        Ended::Defect(_) => verdict.contradict(reason),
        _ => pair::remark(&mut verdict, &reason),
    }
    Answer { verdict, contradiction: None }
}

/// The states of an integrated motion that claims ask for: where each stands among its leaves, and among the sides of its enclosure.
fn states(request: &Request, t: usize, along: &mut Along) -> Vec<(usize, usize)> {
    let (Given::Integrated { initial, .. }, Some(built)) =
        (&request.derivation.trajectories[t].motion, request.stage.built(t))
    else {
        return Vec::new();
    };
    let is_state =
        |leaf: &Leaf| leaf.rate == 0 && leaf.instant.is_none() && initial.iter().any(|(s, ..)| *s == leaf.symbol);
    let each = built.asked.iter().enumerate().filter(|(_, leaf)| is_state(leaf));
    each.filter_map(|(at, leaf)| {
        let e = along.graph.leaf(*leaf);
        Some((at, along.side(e).ok()?))
    })
    .collect()
}

/// A time at which a state that was computed lies outside of its enclosure, by more than its error bound explains.
fn disagreement(request: &Request, t: usize, along: &mut Along, states: &[(usize, usize)]) -> Option<Reason> {
    let motion = request.stage.motion(t)?;
    ready::spread(along).into_iter().filter(|_| !states.is_empty()).find_map(|piece| {
        let (time, enclosed) = (piece.mid(), along.at_middle(piece));
        let sampled = motion.at(time);
        states.iter().find_map(|&(at, side)| {
            let (Ok(seen), Ok(range)) = (sampled.get(at)?, enclosed.get(side)?) else { return None };
            let gap = (seen.value - range.hi()).max(range.lo() - seen.value);
            let explained = pair::DISAGREEMENT * (seen.error + f64::EPSILON * seen.value.abs());
            let (sampled, enclosed) = ((seen.value, seen.error), (range.mid(), range.width()));
            (gap > explained).then(|| Enclosing::StateApart { t: time, sampled, enclosed }.into())
        })
    })
}

/// What is said of some claims on one motion, by the positions of these claims.
///
/// Each has work of its own, and what they share is found once: so an answer does not depend on what else is asked.
fn enclose(request: &Request, known: Known, t: usize, open: &[(usize, &Verdict)]) -> Vec<Answer> {
    let trajectory = &request.derivation.trajectories[t];
    let remarked = |reason: &Reason| -> Vec<Answer> {
        let remarked = |before: &Verdict| {
            let mut verdict = before.clone();
            pair::remark(&mut verdict, reason);
            Answer { verdict, contradiction: None }
        };
        open.iter().map(|(_, before)| remarked(before)).collect()
    };
    if let Some(reached) = request.limits.reached() {
        return remarked(&reached.into());
    }
    let (mut graph, integrals) = (known.0.clone(), known.1);
    let (mut along, start) = match enclosure(request, integrals, &mut graph, t) {
        Ok((enclosure, start)) => (Along::new(enclosure, graph, trajectory.span), start),
        Err(reason) => return remarked(&reason),
    };
    let program = |k: usize| &request.prepared[k][request.selection.start_of[t]];
    let other = |other: usize, graph: &mut Graph| Ok(enclosure(request, integrals, graph, other)?.0);
    let mut parts = Vec::new();
    for (k, _) in open {
        let Prepared { claim, program, gradients } = program(*k);
        let asked = pair::Asked { claim, program, gradients: gradients.as_ref(), start: &start, other: &other };
        parts.push(pair::prepare(&asked, &mut along));
    }
    let states = states(request, t, &mut along);
    if let Err(reason) = along.compile() {
        return remarked(&reason);
    }
    let disagreement = disagreement(request, t, &mut along, &states);
    let mut one = |(&(k, before), parts): (&(usize, &Verdict), Vec<_>)| {
        let program = &program(k).program;
        let sampled = |comparison: &Comparison, time: f64| {
            let at = program.position(comparison)?;
            let values = request.stage.values(t, time);
            program.measure((&[values].into_iter().collect(), 1), 1.0).get(at)?.difference(0).ok()
        };
        let find = || {
            let mut verdict = before.clone();
            let own = match request.limits.reached() {
                Some(reached) => {
                    pair::remark(&mut verdict, &reached.into());
                    None
                }
                None => pair::strengthen(program, parts, &mut along, &sampled, &mut verdict).err(),
            };
            Answer { verdict, contradiction: disagreement.clone().or(own) }
        };
        meter::piece(Task::Enclosing, request.limits, find).unwrap_or_else(|ended| ended_by(before, &ended))
    };
    open.iter().zip(parts).map(&mut one).collect()
}
