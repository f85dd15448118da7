//! A claim, compiled: groups of comparisons and the tape that measures them.
//!
//! **In:** the forms and assumptions of a claim. **Out:** a [`Program`] that measures every comparison at a point of any
//! motion. **Guaranteed:** what is measured is what was written: each form becomes comparisons here and nowhere else.

use super::comparison::{Comparison, Group, at_instant, traced};
use super::steep::exponents;
use super::weigh::{Measured, Series};
use crate::derivation::{Derivation, Form, Written};
use crate::expr::{Expr, Graph, Leaf, Node, Op, Shape, Tensor};
use crate::flow::{Points, Sample};
use crate::latex::{LimitPoint, Relation, RelationKind, Role, Scope, Statement};
use crate::number::{Bounded, BoundedLanes, NoValue, Rational};
use crate::tape::{Slots, Tape};

/// Points that are evaluated at once.
const BLOCK: usize = 8;
/// After so many blocks in a row with points without a value, points are evaluated one by one.
const PATIENCE: usize = 3;

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

impl Use {
    /// What vanishes where a group may change between two samples, and the relation that it belongs to.
    pub fn boundaries<'g>(&self, group: &'g Group) -> impl Iterator<Item = (RelationKind, Expr)> + use<'g> {
        let vanishing = match self {
            Use::Never(e) | Use::Eventually(e) => *e,
            Use::Always | Use::Defined | Use::Limit(_) => None,
        };
        let inequalities = match self {
            Use::Limit(_) => &[][..],
            _ => &group.comparisons[..],
        };
        let each = |c: &'g Comparison| c.boundaries.iter().map(|&e| (c.kind, e));
        vanishing.map(|e| (RelationKind::Equal, e)).into_iter().chain(inequalities.iter().flat_map(each))
    }
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
    /// Exponents in what it says of every time: see `steep`.
    pub steep: Vec<Expr>,
    tape: Option<Tape>,
    /// Where the inputs of the tape stand among the leaves of a point.
    inputs: Vec<usize>,
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

/// The relation that holds where another does not.
fn opposite(kind: RelationKind) -> Option<RelationKind> {
    Some(match kind {
        RelationKind::Equal => RelationKind::NotEqual,
        RelationKind::NotEqual => RelationKind::Equal,
        RelationKind::Less => RelationKind::GreaterEqual,
        RelationKind::LessEqual => RelationKind::Greater,
        RelationKind::Greater => RelationKind::LessEqual,
        RelationKind::GreaterEqual => RelationKind::Less,
    })
}

/// Whether both sides are the same at every time: parameters, and values at fixed times.
fn is_constant(graph: &Graph, scope: &Scope, relation: &Relation) -> bool {
    let all = relation.left.components.iter().chain(&relation.right.components).copied();
    graph.leaves(all).iter().all(|l| l.instant.is_some() || scope.role(l.symbol) == Some(Role::Parameter))
}

/// The conditions under which every operation of an expression has a value, observables traced back.
fn domain_conditions(graph: &mut Graph, scope: &Scope, w: &Written<Tensor>) -> Vec<Comparison> {
    let traced: Vec<Expr> = w.value.components.iter().map(|&e| traced(graph, scope, e)).collect();
    let (zero, one) = (graph.integer(0), graph.integer(1));
    let mut out = Vec::new();
    for node in graph.reachable(traced) {
        let conditions = match *graph.node(node) {
            Node::Unary(Op::Sqrt, a) => vec![(a, RelationKind::GreaterEqual, zero)],
            Node::Unary(Op::Ln, a) => vec![(a, RelationKind::Greater, zero)],
            Node::Unary(Op::Arcsin | Op::Arccos, a) => {
                let size = graph.unary(Op::Abs, a);
                vec![(size, RelationKind::LessEqual, one)]
            }
            Node::Binary(Op::Div, _, b) => vec![(b, RelationKind::NotEqual, zero)],
            Node::Binary(Op::Arctan2, a, b) => {
                let (aa, bb) = (graph.powi(a, 2), graph.powi(b, 2));
                let length = graph.add(aa, bb);
                vec![(length, RelationKind::NotEqual, zero)]
            }
            _ => continue,
        };
        for (left, kind, right) in conditions {
            // What does not depend on anything is settled by the value itself.
            if graph.leaves([left]).is_empty() {
                continue;
            }
            let label = format!("{} has a value", w.text);
            out.push(Comparison::new(graph, scope, label, kind, left, right));
        }
    }
    out
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
                groups.push((how(None), relation_group(graph, &claim.scope, &w.text, relation)));
                if let (Some(limit), Some(last)) = (&relation.limit, groups.last_mut()) {
                    last.0 = Use::Limit(limit.approaches.clone());
                }
            }
        };
        for form in &claim.forms {
            match form {
                Form::Always(w) => each(graph, w, |_| Use::Always),
                Form::Never(_) | Form::Eventually(_) => {}
                Form::Solves { system } => {
                    for w in &systems[*system].equations {
                        each(graph, w, |_| Use::Always);
                    }
                }
                Form::FirstIntegral(_)
                | Form::Defined(_)
                | Form::SameMotion { .. }
                | Form::Independent { .. }
                | Form::Exists { .. } => {}
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
            if let Use::Defined = how {
                comparisons.extend(domain_conditions(graph, &claim.scope, w));
            }
            groups.push((how, Group { comparisons, branching: false }));
        }
        for form in &claim.forms {
            let (w, how): (_, fn(Option<Expr>) -> Use) = match form {
                Form::Never(w) => (w, Use::Never),
                Form::Eventually(w) => (w, Use::Eventually),
                _ => continue,
            };
            if let ([relation], true) = (w.value.relations.as_slice(), matches!(form, Form::Never(_)))
                && let (Some(limit), Some(kind)) = (&relation.limit, opposite(relation.kind))
            {
                // That a limit is never so is a statement about the limit.
                let group = relation_group(graph, &claim.scope, &w.text, &Relation { kind, ..relation.clone() });
                groups.push((Use::Limit(limit.approaches.clone()), group));
                continue;
            }
            if let ([relation], true) = (w.value.relations.as_slice(), matches!(form, Form::Never(_)))
                && is_constant(graph, &claim.scope, relation)
                && let Some(kind) = opposite(relation.kind)
                && relation.left.shape.rank() == 0
            {
                // What does not move is never so if it is not so at the start.
                let group = relation_group(graph, &claim.scope, &w.text, &Relation { kind, ..relation.clone() });
                groups.push((Use::Always, group));
                continue;
            }
            // A chain happens when all of its relations hold at once.
            let parts: Vec<Group> =
                w.value.relations.iter().map(|r| relation_group(graph, &claim.scope, &w.text, r)).collect();
            let zero = match w.value.relations.as_slice() {
                [single] => vanishing(graph, single),
                _ => None,
            };
            let branching = parts.iter().any(|g| g.branching);
            let comparisons = parts.into_iter().flat_map(|g| g.comparisons).collect();
            groups.push((how(zero), Group { comparisons, branching }));
        }
        let at = claim.at.as_ref().and_then(|w| at_event(graph, &w.value));
        let always = groups.iter().filter(|(how, _)| matches!(how, Use::Always | Use::Defined));
        let compared: Vec<&Comparison> = always.flat_map(|(_, group)| &group.comparisons).collect();
        let steep = exponents(graph, &claim.scope, &compared);
        Program { assumptions, groups, at, steep, tape: None, inputs: Vec::new(), sign: claim.scope.branch_sign() }
    }

    /// The expressions whose zeros along a motion the claim depends on.
    pub fn searched(&self) -> Vec<Expr> {
        let groups = self.groups.iter().flat_map(|(how, group)| how.boundaries(group)).map(|(_, e)| e);
        let groups = groups.chain(self.met().map(|(_, _, e)| e));
        // What is tried at events only is not looked at between them.
        self.at.map_or_else(|| groups.collect(), |e| vec![e])
    }

    /// What vanishes where an inequality among the assumptions may change, with the assumption and the relation.
    pub fn met(&self) -> impl Iterator<Item = (&Assumption, RelationKind, Expr)> {
        let selecting = self.assumptions.iter().filter(|a| !a.throughout);
        let comparisons = selecting.flat_map(|a| a.group.comparisons.iter().map(move |c| (a, c)));
        // What differs from a number does so on all sides of it.
        let inequalities = comparisons.filter(|(_, c)| c.kind != RelationKind::NotEqual);
        inequalities.flat_map(|(a, c)| c.boundaries.iter().map(move |&e| (a, c.kind, e)))
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
        let roots = roots.chain(self.at).chain(self.steep.iter().copied()).collect::<Vec<_>>();
        graph.leaves(roots).into_iter().filter(|&l| l != self.sign).collect()
    }

    /// Makes the tape. `known` are the leaves of a point, sorted.
    pub fn compile(&mut self, graph: &mut Graph, known: &[Leaf]) -> Result<(), Leaf> {
        let mut roots = Vec::new();
        for c in self.comparisons() {
            roots.push((c.left, c.right, c.magnitude));
        }
        let roots: Vec<Expr> = roots.into_iter().flat_map(|(l, r, m)| [l, r, graph.sub(l, r), m]).collect();
        // Only what the claim depends on is copied from a point.
        let mut needed = graph.leaves(roots.iter().copied());
        needed.retain(|&l| l != self.sign);
        self.inputs.clear();
        for leaf in &needed {
            self.inputs.push(known.binary_search(leaf).map_err(|_| *leaf)?);
        }
        needed.push(self.sign);
        self.tape = Some(Tape::compile(graph, &needed, &roots)?);
        Ok(())
    }

    /// The positions among the leaves of a point of everything that is needed.
    pub fn inputs(&self) -> &[usize] {
        &self.inputs
    }

    /// The position among the leaves of a point of an input of the tape.
    pub fn input(&self, position: usize) -> Option<usize> {
        self.inputs.get(position).copied()
    }

    /// The leaf that stands for the sign of ±.
    pub fn sign(&self) -> Leaf {
        self.sign
    }

    /// The tape, once compiled.
    pub fn tape(&self) -> Option<&Tape> {
        self.tape.as_ref()
    }

    /// Evaluates everything at a point, for one sign of ±; what was found stays in the slots.
    pub fn run(&self, values: Sample, sign: f64, slots: &mut Option<Slots<Bounded>>) {
        let Some(tape) = &self.tape else { return };
        let slots = slots.get_or_insert_with(|| tape.slots(&()));
        for (i, &at) in self.inputs.iter().enumerate() {
            slots.set(i, values.get(at));
        }
        slots.set(self.inputs.len(), Ok(Bounded::exact(sign)));
        tape.run(&(), slots);
    }

    /// Evaluates everything at a block of points; `false` where some input has a value at some of the points only.
    fn run_block(
        &self,
        tape: &Tape,
        (points, from): (&Points, usize),
        sign: f64,
        slots: &mut Slots<BoundedLanes<BLOCK>>,
    ) -> bool {
        for (i, &at) in self.inputs.iter().enumerate() {
            let lanes = match points.absent(at) {
                Some(reason) => Err(reason),
                None => match points.lanes(from, at) {
                    Some(lanes) => Ok(lanes),
                    None => return false,
                },
            };
            slots.set(i, lanes);
        }
        slots.set(self.inputs.len(), Ok(BoundedLanes::splat(Bounded::exact(sign))));
        tape.run(&(), slots);
        true
    }

    /// Measures every comparison at the points, for one sign of ±: `[comparison][point]`.
    pub fn measure(&self, points: &Points, sign: f64) -> Vec<Series> {
        let Some(tape) = &self.tape else { return Vec::new() };
        let count = tape.output_count() / 4;
        let mut out: Vec<Series> = (0..count).map(|_| Vec::with_capacity(points.len())).collect();
        let (mut single, mut lanes) = (None, None);
        let mut failed = 0;
        // What depends on something that has no value at any of the points has none either.
        let absent: Vec<bool> = self.inputs.iter().map(|&at| points.absent(at).is_some()).collect();
        let never = tape.depends(&absent);
        for from in (0..points.len()).step_by(BLOCK) {
            if from + BLOCK <= points.len() && failed < PATIENCE {
                let slots = lanes.get_or_insert_with(|| tape.slots::<BoundedLanes<BLOCK>>(&()));
                let valued = |slots: &_| (0..4 * count).all(|o| never[o] || tape.output(o, slots).is_ok());
                if self.run_block(tape, (points, from), sign, slots) && valued(slots) {
                    failed = 0;
                    for (k, series) in out.iter_mut().enumerate() {
                        match four(|n| tape.output(4 * k + n, slots).copied()) {
                            Ok([left, right, difference, magnitude]) => series.extend((0..BLOCK).map(|i| {
                                let (left, right) = (left.lane(i), right.lane(i));
                                let (difference, magnitude) = (difference.lane(i), magnitude.lane(i).value);
                                Ok(Measured { left, right, difference, magnitude })
                            })),
                            Err(reason) => series.extend([Err(reason); BLOCK]),
                        }
                    }
                    continue;
                }
                failed += 1;
            }
            for at in from..(from + BLOCK).min(points.len()) {
                self.run(points.sample(at), sign, &mut single);
                let Some(slots) = &single else { continue };
                for (k, series) in out.iter_mut().enumerate() {
                    let of = |[left, right, difference, magnitude]: [Bounded; 4]| {
                        let magnitude = magnitude.value;
                        Measured { left, right, difference, magnitude }
                    };
                    series.push(four(|n| tape.output(4 * k + n, slots).copied()).map(of));
                }
            }
        }
        out
    }
}

/// The four outputs of a comparison, or why the first that has no value has none.
fn four<T>(output: impl Fn(usize) -> Result<T, NoValue>) -> Result<[T; 4], NoValue> {
    Ok([output(0)?, output(1)?, output(2)?, output(3)?])
}
