//! Whether an equation that agrees within its error bound says anything.
//!
//! A residual is compared with the size of the terms. Where huge terms cancel to all digits, the bound is small against
//! them and still larger than everything else in the formula: (x + 10²⁰) − 10²⁰ = 2x then agrees, and so would any other
//! multiple of x.
//!
//! **In:** the terms of both sides of a comparison, at points of a motion. **Out:** which comparisons are *mute*: a term that
//! is known to differ from 0 is nowhere larger than the error of the sum, and the terms that can be seen cancel by
//! themselves, whatever the values of the symbols. The equation without the unseen terms is then 0 = 0, and that it agrees
//! says nothing of them. A small term beside others that say something is no reason: the energy of a motion that hardly
//! moves is still the energy.

use std::sync::{Arc, OnceLock};

use crate::comparison::{Comparison, GUARD};
use crate::program::Program;
use crate::sides::{MeasuredGroup, Measurements};

use crate::expr::tape::{Slots, Tape};
use crate::expr::{Expr, Graph, Leaf, Node, Op};
use crate::flow::{Points, Sample};
use crate::number::{Bounded, NoValue};

/// Points at which the terms are looked at first.
const FEW: usize = 8;
/// The visible terms cancel by themselves if their sum is this small against the largest, at values of no special meaning.
const CANCELLED: f64 = 1e-12;

/// The terms of left − right, with their signs.
#[derive(Clone, Debug)]
pub(crate) struct Terms {
    negative: Vec<bool>,
    tape: Tape,
}

/// The terms of a comparison: they are the same on all motions, and made when one first asks for them.
#[derive(Clone, Debug, Default)]
pub struct Told(OnceLock<Option<Arc<Terms>>>);

impl Told {
    fn terms(&self, graph: &Graph, comparison: &Comparison) -> Option<&Terms> {
        self.0.get_or_init(|| Terms::new(graph, comparison).map(Arc::new)).as_deref()
    }

    /// The terms, to be kept; nothing where no comparison of this kind is mute.
    pub(crate) fn shared(&self, graph: &Graph, comparison: &Comparison) -> Option<Arc<Terms>> {
        self.terms(graph, comparison)?;
        self.0.get().cloned().flatten()
    }
}

/// Appends the terms of a sum.
fn flatten(graph: &Graph, e: Expr, negative: bool, out: &mut Vec<(bool, Expr)>) {
    let mut stack = vec![(e, negative)];
    while let Some((e, negative)) = stack.pop() {
        match *graph.node(e) {
            Node::Binary(Op::Add, a, b) => stack.extend([(b, negative), (a, negative)]),
            Node::Binary(Op::Sub, a, b) => stack.extend([(b, !negative), (a, negative)]),
            Node::Unary(Op::Neg, a) => stack.push((a, !negative)),
            Node::Binary(Op::Restrict, a, _) => stack.push((a, negative)),
            _ if graph.is_zero(e) => {}
            _ => out.push((negative, e)),
        }
    }
}

impl Terms {
    fn new(graph: &Graph, comparison: &Comparison) -> Option<Terms> {
        let mut terms = Vec::new();
        flatten(graph, comparison.left, false, &mut terms);
        flatten(graph, comparison.right, true, &mut terms);
        // A quotient or a power vanishes where what it is made of does.
        while let [(_, single)] = terms.as_slice() {
            let inner = match *graph.node(*single) {
                Node::Binary(Op::Div, a, _) => a,
                Node::Unary(Op::Powi(n), a) if n > 0 => a,
                Node::Unary(Op::Abs | Op::Sqrt, a) => a,
                Node::Binary(Op::Mul, a, b) if graph.leaves([a]).is_empty() => b,
                Node::Binary(Op::Mul, a, b) if graph.leaves([b]).is_empty() => a,
                _ => break,
            };
            terms.clear();
            flatten(graph, inner, false, &mut terms);
        }
        if terms.len() < 2 {
            return None;
        }
        let (negative, roots): (Vec<bool>, Vec<Expr>) = terms.into_iter().unzip();
        let leaves = graph.leaves(roots.iter().copied());
        let tape = Tape::compile(graph, &leaves, &roots).ok()?;
        Some(Terms { negative, tape })
    }

    /// All terms with their signs.
    fn values(
        &self,
        inputs: impl Iterator<Item = Result<Bounded, NoValue>>,
        slots: &mut Slots<Bounded>,
    ) -> Option<Vec<Bounded>> {
        inputs.enumerate().for_each(|(i, x)| slots.set(i, x));
        self.tape.run(&(), slots);
        let signed =
            |(i, &negative): (usize, &bool)| self.tape.output(i, slots).ok().map(|&x| if negative { -x } else { x });
        self.negative.iter().enumerate().map(signed).collect()
    }

    /// What the values of the terms depend on.
    pub(crate) fn inputs(&self) -> &[Leaf] {
        self.tape.inputs()
    }

    /// Memory for their values.
    pub(crate) fn slots(&self) -> Slots<Bounded> {
        self.tape.slots(&())
    }

    /// Whether every term is larger than the error of their sum at a point: then the comparison is not mute.
    pub(crate) fn are_seen(
        &self,
        inputs: impl Iterator<Item = Result<Bounded, NoValue>>,
        slots: &mut Slots<Bounded>,
    ) -> bool {
        let Some(values) = self.values(inputs, slots) else { return false };
        let sum = values.iter().fold(Bounded::exact(0.0), |sum, &x| sum + x);
        values.iter().all(|x| x.value.abs() > sum.error)
    }

    /// Whether the terms that `seen` marks add up to 0 for all values of the symbols: at two points of no special meaning.
    fn cancel(&self, seen: &[bool]) -> bool {
        let count = self.tape.inputs().len();
        // Multiples of the golden ratio, modulo 1.
        let number = |i: usize, at: f64| at + (0.618_033_988_749_894_9 * (i + 1) as f64).fract();
        let mut slots = self.tape.slots::<Bounded>(&());
        let mut at = |at: f64| {
            let values = self.values((0..count).map(|i| Ok(Bounded::exact(number(i, at)))), &mut slots)?;
            let of = || values.iter().zip(seen).filter(|(_, seen)| **seen).map(|(x, _)| x.value);
            let largest = of().fold(0.0, |a: f64, x| a.max(x.abs()));
            Some(of().sum::<f64>().abs() <= CANCELLED * largest)
        };
        match (at(0.25), at(1.75)) {
            (Some(a), Some(b)) => a && b,
            (a, b) => a.or(b).unwrap_or(false),
        }
    }

    /// Whether the comparison is mute at all of these points.
    fn mute<'v>(&self, places: &[Option<usize>], sign: f64, points: impl Iterator<Item = Sample<'v>>) -> bool {
        let mut seen = vec![false; self.negative.len()];
        let mut significant = vec![false; self.negative.len()];
        let mut slots = self.tape.slots::<Bounded>(&());
        for point in points {
            let input = |place: &Option<usize>| match place {
                Some(at) => point.get(*at),
                None => Ok(Bounded::exact(sign)),
            };
            let Some(values) = self.values(places.iter().map(input), &mut slots) else { continue };
            let sum = values.iter().fold(Bounded::exact(0.0), |sum, &x| sum + x);
            for (i, x) in values.iter().enumerate() {
                seen[i] |= x.value.abs() > sum.error;
                significant[i] |= x.value.abs() > GUARD * x.error;
            }
            if seen.iter().all(|&s| s) {
                return false;
            }
        }
        let unseen = seen.iter().zip(&significant).any(|(seen, significant)| !seen && *significant);
        unseen && self.cancel(&seen)
    }
}

/// Marks the comparisons of all groups that are mute at the points at which they were measured.
pub fn silence(graph: &Graph, program: &Program, leaves: &[Leaf], points: &Points, all: &mut Measurements) {
    for group in all.selectors.iter_mut().chain(&mut all.hypotheses).chain(&mut all.parts) {
        let found: Vec<(usize, usize)> = (0..group.signs.len())
            .flat_map(|s| (0..group.signs[s].len()).map(move |c| (s, c)))
            .filter(|&(s, c)| is_mute(graph, program, leaves, points, group, (s, c)))
            .collect();
        for (s, c) in found {
            group.mute[s][c] = true;
        }
    }
}

fn is_mute(
    graph: &Graph,
    program: &Program,
    leaves: &[Leaf],
    points: &Points,
    group: &MeasuredGroup,
    (s, c): (usize, usize),
) -> bool {
    let comparison = &group.group.comparisons[c];
    // Where every residual is clear there is nothing to ask.
    let within = group.signs[s][c].differences().any(|d| d.value.abs() <= GUARD * d.error);
    // An error far below the sides leaves nothing unseen but what is below the last digit of both.
    if group.group.asserted || !within {
        return false;
    }
    let Some(terms) = comparison.told.terms(graph, comparison) else { return false };
    let places: Vec<Option<usize>> = terms
        .tape
        .inputs()
        .iter()
        .map(|leaf| if *leaf == program.sign() { None } else { leaves.binary_search(leaf).ok() })
        .collect();
    let sign = if s == 0 { 1.0 } else { -1.0 };
    let spread = (0..FEW).map(|k| points.sample(k * (points.len() - 1) / (FEW - 1)));
    terms.mute(&places, sign, spread) && terms.mute(&places, sign, points.samples())
}
