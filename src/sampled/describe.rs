//! Points in words and numbers, for witnesses and reasons.

use std::cell::RefCell;
use std::sync::Arc;

use crate::derivation::Claim;
use crate::expr::tape::{Fault, Slots};
use crate::expr::{Expr, Graph, Leaf};
use crate::flow::{Incomplete, Points};
use crate::number::{Bounded, NoValue};
use crate::trace::{Trace, Trial};
use claim::comparison::Comparison;
use claim::program::{Program, SIDES};
use reason::{Gap, Reason, Sampling};

/// Why a point does not count.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Left {
    /// It counts.
    In,
    /// It is left out, for this reason.
    Out(Arc<Reason>),
    /// Whether it counts is not known, for this reason.
    Open(Arc<Reason>),
}

/// What is known of each time before the claim itself is looked at, and how to describe a point.
pub(super) struct Setting<'a> {
    /// The times, increasing.
    pub times: &'a [f64],
    /// Which of them count.
    pub left: Vec<Left>,
    /// The precision that the claim asks for.
    pub precision: f64,
    /// Whether the first failure is told, and not the clearest.
    pub first: bool,
    /// Whether a reader is shown both sides along the motion.
    pub shown: bool,
    /// What describes the points.
    pub describer: &'a Describer<'a>,
}

/// Describes points in words and numbers, for witnesses and reasons.
pub(super) struct Describer<'a> {
    graph: &'a Graph,
    claim: &'a Claim,
    program: &'a Program,
    trace: &'a Trace<'a>,
    /// The times of the points.
    pub times: &'a [f64],
    points: &'a Points,
    shown: bool,
    slots: RefCell<Option<Slots<Bounded>>>,
    /// What was said of inputs without a value, by their position and the reason.
    said: RefCell<Said>,
}

/// Reasons, by the position of an input and why it has no value.
type Said = Vec<((usize, NoValue), Arc<Reason>)>;

impl<'a> Describer<'a> {
    /// A describer of these points.
    pub fn new(trial: &Trial<'a>, times: &'a [f64], points: &'a Points) -> Describer<'a> {
        let Trial { graph, claim, program, trace, shown } = *trial;
        Describer {
            graph,
            claim,
            program,
            trace,
            times,
            points,
            shown,
            slots: RefCell::default(),
            said: RefCell::default(),
        }
    }

    /// How the claim is weighed at the points, of which those count that are left.
    pub fn setting(&'a self, left: Vec<Left>) -> Setting<'a> {
        Setting {
            times: self.times,
            left,
            precision: self.claim.precision,
            first: false,
            shown: self.shown,
            describer: self,
        }
    }

    /// Values of the leaves that both sides depend on.
    pub fn values(&self, comparison: &Comparison, time: usize) -> Vec<(String, f64)> {
        let value = |leaf: Leaf| {
            let at = self.trace.leaves.iter().position(|&l| l == leaf)?;
            self.points.get(time, at).ok().map(|v| v.value)
        };
        named(self.graph, [comparison.left, comparison.right], value)
    }

    /// Why a comparison has no value.
    pub fn fault(&self, comparison: &Comparison, time: usize, reason: NoValue) -> Arc<Reason> {
        let mut slots = self.slots.borrow_mut();
        let bare = || Arc::new(reason.into());
        let Some((tape, slots)) = self.program.evaluated(self.points.sample(time), &mut slots) else { return bare() };
        let position = self.program.position(comparison);
        let fault = position.and_then(|k| (0..2).find_map(|side| tape.fault(SIDES * k + side, slots)));
        match fault {
            Some(Fault::Input(i)) => {
                let mut said = self.said.borrow_mut();
                if let Some((_, why)) = said.iter().find(|(of, _)| *of == (i, reason)) {
                    return Arc::clone(why);
                }
                let input = self.program.input(i).and_then(|at| Some((at, *self.trace.leaves.get(at)?)));
                let why = input.map_or_else(bare, |(at, leaf)| {
                    let name = self.graph.leaf_latex(leaf).into();
                    let known = self.trace.knows(at);
                    Arc::new(if known { Sampling::NoValue(name, reason) } else { Sampling::NotKnown(name) }.into())
                });
                said.push(((i, reason), Arc::clone(&why)));
                why
            }
            Some(Fault::Instruction(step)) => {
                let value = |slot: u32| slots.value(slot as usize).value;
                let (operation, first) = (step.op.spelling().into(), value(step.a));
                let second = (step.op.arity() != 1).then(|| value(step.b));
                Arc::new(Sampling::OperationHasNoValue { operation, first, second, why: reason }.into())
            }
            Some(Fault::Constant) | None => bare(),
        }
    }
}

/// Why a search for events is incomplete.
pub(super) fn incomplete(problem: &Incomplete) -> Gap {
    match *problem {
        Incomplete::NoValue { start, end, reason } => Gap::NoValue { from: start, to: end, why: reason },
        Incomplete::Vanishing { start, end } => Gap::Vanishing(start, end),
        Incomplete::Unresolved { start, end } => Gap::Unresolved(start, end),
    }
}

/// What is added to the name of a symbol of the file where a claim has one of the same name.
const OF_THE_FILE: &str = " (of the file)";

/// Named values, in an order that does not depend on what was written before. Of two symbols with one name the first declared is
/// that of the file.
pub(super) fn named(
    graph: &Graph,
    of: impl IntoIterator<Item = Expr>,
    value: impl Fn(Leaf) -> Option<f64>,
) -> Vec<(String, f64)> {
    let mut leaves = graph.leaves(of);
    leaves.sort_by_cached_key(|l| (l.instant.is_some(), l.symbol, l.component, l.rate, graph.leaf_latex(*l)));
    let names: Vec<String> = leaves.iter().map(|&l| graph.leaf_latex(l)).collect();
    let own = |leaf: &Leaf, name: &str| leaves.iter().zip(&names).all(|(l, n)| n != name || l.symbol <= leaf.symbol);
    let shown = leaves.iter().zip(&names).filter_map(|(leaf, name)| {
        let name = if own(leaf, name) { name.clone() } else { format!("{name}{OF_THE_FILE}") };
        Some((name, value(*leaf)?))
    });
    shown.collect()
}
