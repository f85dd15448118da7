//! A claim, compiled: groups of comparisons and the tape that measures them.
//!
//! **In:** the forms and assumptions of a claim. **Out:** a [`Program`] that measures every comparison at a point of any
//! motion. **Guaranteed:** what is measured is what was written: each form becomes comparisons here and nowhere else.

use super::comparison::{Comparison, Group, at_instant};
use super::trial::{Course, slack};
use super::weigh::Measured;
use crate::derivation::{Derivation, Form, Written};
use crate::expr::{Expr, Graph, Leaf, Shape, Tensor};
use crate::latex::{LimitPoint, Relation, RelationKind, Scope, Statement};
use crate::number::{Bounded, NoValue, Rational};
use crate::tape::{Slots, Tape};

/// What a group is measured for.
#[derive(Clone, Debug)]
pub(super) enum Use {
    /// The group must hold at every time.
    Always,
    /// Its left sides must have values at every time.
    Defined,
    /// It must hold at no time. The expression vanishes where it holds, for an equation.
    Never(Option<Expr>),
    /// It must hold at some time; the expression as above.
    Eventually(Option<Expr>),
    /// It must hold in the limit.
    Limit(LimitPoint),
}

/// An assumption: an equation must hold throughout, anything else selects the times at which it does.
#[derive(Clone, Debug)]
pub(super) struct Assumption {
    /// As written.
    pub text: String,
    /// Its comparisons.
    pub group: Group,
    /// Whether it is an equation.
    pub throughout: bool,
}

/// A claim ready to be measured.
#[derive(Clone, Debug)]
pub(super) struct Program {
    /// What it presupposes.
    pub assumptions: Vec<Assumption>,
    /// What it says.
    pub groups: Vec<(Use, Group)>,
    /// A scalar that vanishes at the times at which the claim is to be tried.
    pub at: Option<Expr>,
    tape: Option<Tape>,
    event: Option<Tape>,
    sign: Leaf,
}

/// Name of a component: the formula, and the values of its free indices.
fn label(text: &str, indices: &[String], shape: &Shape, component: usize) -> String {
    if shape.rank() == 0 {
        return text.to_owned();
    }
    let values = shape.indices(component);
    let named: Vec<String> = values
        .iter()
        .enumerate()
        .map(|(axis, value)| match indices.get(axis) {
            Some(name) => format!("{name} = {value}"),
            None => value.to_string(),
        })
        .collect();
    format!("{text}   [{}]", named.join(", "))
}

/// The comparisons of a relation, one for each component; the same component twice (as in a symmetric equation) once.
fn relation_group(graph: &mut Graph, scope: &Scope, text: &str, relation: &Relation) -> Group {
    let sides = relation.left.components.iter().zip(&relation.right.components).map(|(&l, &r)| (l, r));
    let sides: Vec<(Expr, Expr)> = sides.collect();
    let mut comparisons = Vec::new();
    for (component, &(left, right)) in sides.iter().enumerate() {
        if sides[..component].contains(&(left, right)) {
            continue;
        }
        let label = label(text, &relation.indices, &relation.left.shape, component);
        comparisons.push(Comparison::new(graph, scope, label, relation.kind, left, right));
    }
    Group { comparisons, branching: relation.has_branches }
}

/// The sum of squares of left − right, which vanishes where an equation holds; left − right itself for a scalar.
fn vanishing(graph: &mut Graph, relation: &Relation) -> Option<Expr> {
    if relation.kind != RelationKind::Equal {
        return None;
    }
    let pairs = relation.left.components.iter().zip(&relation.right.components);
    let differences: Vec<Expr> = pairs.map(|(&l, &r)| graph.sub(l, r)).collect();
    if let [single] = differences.as_slice() {
        return Some(*single);
    }
    let mut sum = graph.integer(0);
    for d in differences {
        let square = graph.powi(d, 2);
        sum = graph.add(sum, square);
    }
    Some(sum)
}

/// What vanishes where the first relation of a statement holds, for events.
pub(super) fn at_event(graph: &mut Graph, statement: &Statement) -> Option<Expr> {
    statement.relations.first().and_then(|r| vanishing(graph, r))
}

impl Program {
    /// Compiles the claim at position `claim`; `initial_time` is that of the motion at hand.
    pub fn new(derivation: &mut Derivation, claim: usize, initial_time: &Rational) -> Program {
        let Derivation { graph, claims, systems, .. } = derivation;
        let claim = &claims[claim];
        let start = graph.constant(initial_time.clone());
        let mut assumptions = Vec::new();
        for written in &claim.assuming {
            for relation in &written.value.relations {
                let group = relation_group(graph, &claim.scope, &written.text, relation);
                let throughout = relation.kind == RelationKind::Equal;
                assumptions.push(Assumption { text: written.text.clone(), group, throughout });
            }
        }
        let mut groups = Vec::new();
        let mut each = |graph: &mut Graph, w: &Written<Statement>, how: fn(Option<Expr>) -> Use| {
            for relation in &w.value.relations {
                let vanishing = vanishing(graph, relation);
                groups.push((how(vanishing), relation_group(graph, &claim.scope, &w.text, relation)));
                if let (Some(limit), Some(last)) = (&relation.limit, groups.last_mut()) {
                    last.0 = Use::Limit(limit.approaches.clone());
                }
            }
        };
        for form in &claim.forms {
            match form {
                Form::Always(w) => each(graph, w, |_| Use::Always),
                Form::Never(w) => each(graph, w, Use::Never),
                Form::Eventually(w) => each(graph, w, Use::Eventually),
                Form::Solves { system } => {
                    for w in &systems[*system].equations {
                        each(graph, w, |_| Use::Always);
                    }
                }
                Form::FirstIntegral(_) | Form::Defined(_) | Form::SameMotion { .. } | Form::Independent { .. } => {}
            }
        }
        for form in &claim.forms {
            let (w, how): (&Written<Tensor>, Use) = match form {
                Form::FirstIntegral(w) => (w, Use::Always),
                Form::Defined(w) => (w, Use::Defined),
                _ => continue,
            };
            let mut comparisons = Vec::new();
            for (component, &e) in w.value.components.iter().enumerate() {
                let (right, text) = match how {
                    Use::Defined => (e, format!("{} has a value", w.text)),
                    _ => (at_instant(graph, &claim.scope, e, start), format!("{} is constant", w.text)),
                };
                let label = label(&text, &[], &w.value.shape, component);
                comparisons.push(Comparison::new(graph, &claim.scope, label, RelationKind::Equal, e, right));
            }
            groups.push((how, Group { comparisons, branching: false }));
        }
        let at = claim.at.as_ref().and_then(|w| at_event(graph, &w.value));
        Program { assumptions, groups, at, tape: None, event: None, sign: claim.scope.branch_sign() }
    }

    /// Every comparison, assumptions first, in the order in which [`Program::measure`] yields them.
    fn comparisons(&self) -> impl Iterator<Item = &Comparison> {
        let claimed = self.groups.iter().flat_map(|(_, g)| &g.comparisons);
        self.assumptions.iter().flat_map(|a| &a.group.comparisons).chain(claimed)
    }

    /// The position of a comparison in what [`Program::measure`] yields.
    pub fn position(&self, comparison: &Comparison) -> Option<usize> {
        self.comparisons().position(|c| std::ptr::eq(c, comparison))
    }

    /// Whether a ± occurs anywhere.
    pub fn is_branching(&self) -> bool {
        self.assumptions.iter().any(|a| a.group.branching) || self.groups.iter().any(|(_, g)| g.branching)
    }

    /// The leaves that must be known to measure it, the sign of ± apart.
    pub fn leaves(&self, graph: &Graph) -> Vec<Leaf> {
        let roots = self.comparisons().flat_map(|c| [c.left, c.right, c.magnitude]);
        let roots = roots.chain(self.at).collect::<Vec<_>>();
        graph.leaves(roots).into_iter().filter(|&l| l != self.sign).collect()
    }

    /// Makes the tape. `known` are the leaves of a point, in its order.
    pub fn compile(&mut self, graph: &mut Graph, known: &[Leaf]) -> Result<(), Leaf> {
        let mut roots = Vec::new();
        for c in self.comparisons() {
            roots.push((c.left, c.right, c.magnitude));
        }
        let roots: Vec<Expr> = roots.into_iter().flat_map(|(l, r, m)| [l, r, graph.sub(l, r), m]).collect();
        let inputs: Vec<Leaf> = known.iter().copied().chain([self.sign]).collect();
        self.tape = Some(Tape::compile(graph, &inputs, &roots)?);
        self.event = self.at.map(|e| Tape::compile(graph, known, &[e])).transpose()?;
        Ok(())
    }

    /// How well the time of an event of this claim is known.
    pub fn event_slack(&self, course: &Course, t: f64) -> f64 {
        match &self.event {
            Some(tape) => slack(tape, 0, course, t, &mut tape.slots(&())),
            None => 0.0,
        }
    }

    /// The tape, once compiled.
    pub fn tape(&self) -> Option<&Tape> {
        self.tape.as_ref()
    }

    /// Measures every comparison at a point, for one sign of ±.
    pub fn measure(
        &self,
        values: &[Result<Bounded, NoValue>],
        sign: f64,
        slots: &mut Option<Slots<Bounded>>,
    ) -> Vec<Result<Measured, NoValue>> {
        let Some(tape) = &self.tape else { return Vec::new() };
        let slots = slots.get_or_insert_with(|| tape.slots(&()));
        for (i, v) in values.iter().enumerate() {
            slots.set(i, *v);
        }
        slots.set(values.len(), Ok(Bounded { value: sign, error: 0.0 }));
        tape.run(&(), slots);
        let comparison = |k: usize| {
            Ok(Measured {
                left: *tape.output(4 * k, slots)?,
                right: *tape.output(4 * k + 1, slots)?,
                difference: *tape.output(4 * k + 2, slots)?,
                magnitude: tape.output(4 * k + 3, slots)?.value,
            })
        };
        (0..tape.output_count() / 4).map(comparison).collect()
    }
}
