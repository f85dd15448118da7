//! A claim, compiled: groups of comparisons and the tape that measures them.
//!
//! **In:** the forms and assumptions of a claim. **Out:** a [`Program`] that measures every comparison at a point of any
//! motion. **Guaranteed:** what is measured is what was written: each form becomes comparisons here and nowhere else.

use super::comparison::{Comparison, Group, at_instant, traced};
use super::measured::{Measured, Series};
use super::part::{BLOCK, Evaluation, Part};
use super::steep::exponents;
use crate::derivation::{Derivation, Form, Written};
use crate::expr::{Expr, Graph, Leaf, Node, Op, Shape, Tensor};
use crate::flow::{Points, Sample};
use crate::latex::{LimitPoint, Relation, RelationKind, Role, Scope, Statement};
use crate::number::{Bounded, NoValue, Rational};
use crate::tape::{Slots, Tape};

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
    /// Left, right, and left − right of every comparison.
    sides: Option<Part>,
    /// The size of the terms of every comparison.
    sizes: Option<Part>,
    /// The positions among the leaves of a point of everything that is needed, increasing.
    inputs: Vec<usize>,
    sign: Leaf,
}

/// The longest formula that names each of its comparisons in full: a chain of relations has as many of them as signs.
const LONGEST_LABEL: usize = 4_000;

/// Name of a component: the formula, and the values of its free indices.
fn label(text: &str, indices: &[String], shape: &Shape, component: usize) -> String {
    let end = (0..=80).rev().find(|&n| text.is_char_boundary(n)).unwrap_or(0);
    let short = format!("{} …", &text[..end.min(text.len())]);
    let text = if text.len() > LONGEST_LABEL { short.as_str() } else { text };
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
        Program {
            assumptions,
            groups,
            at,
            steep,
            sides: None,
            sizes: None,
            inputs: Vec::new(),
            sign: claim.scope.branch_sign(),
        }
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

    /// Compiles everything. `known` are the leaves of a point, sorted.
    ///
    /// # Errors
    /// A leaf that is needed, and is not among those of a point.
    pub fn compile(&mut self, graph: &mut Graph, known: &[Leaf]) -> Result<(), Leaf> {
        let compared: Vec<(Expr, Expr)> = self.comparisons().map(|c| (c.left, c.right)).collect();
        let sizes: Vec<Expr> = self.comparisons().map(|c| c.magnitude).collect();
        let sides: Vec<Expr> = compared.into_iter().flat_map(|(l, r)| [l, r, graph.sub(l, r)]).collect();
        let sides = Part::new(graph, known, self.sign, &sides)?;
        let sizes = Part::new(graph, known, self.sign, &sizes)?;
        self.inputs = sides.inputs().iter().chain(sizes.inputs()).copied().collect();
        self.inputs.sort_unstable();
        self.inputs.dedup();
        (self.sides, self.sizes) = (Some(sides), Some(sizes));
        Ok(())
    }

    /// The positions among the leaves of a point of everything that is needed.
    pub fn inputs(&self) -> &[usize] {
        &self.inputs
    }

    /// The position among the leaves of a point of an input of the tape.
    pub fn input(&self, position: usize) -> Option<usize> {
        self.sides.as_ref()?.inputs().get(position).copied()
    }

    /// The leaf that stands for the sign of ±.
    pub fn sign(&self) -> Leaf {
        self.sign
    }

    /// Where the reason lies that a side of a comparison, by its position, has no value at a point: the tape with its
    /// evaluation there.
    pub fn evaluated<'s>(
        &'s self,
        values: Sample,
        slots: &'s mut Option<Slots<Bounded>>,
    ) -> Option<(&'s Tape, &'s Slots<Bounded>)> {
        let sides = self.sides.as_ref()?;
        Some((sides.tape(), sides.run(values, 1.0, slots)))
    }

    /// The sizes of the terms of all comparisons, once compiled.
    pub fn sizes(&self) -> Option<&Part> {
        self.sizes.as_ref()
    }

    /// Measures every comparison at the first `times` of the points, for one sign of ±.
    pub fn measure(&self, (points, times): (&Points, usize), sign: f64) -> Vec<Series> {
        let Some(sides) = &self.sides else { return Vec::new() };
        let count = sides.tape().output_count() / SIDES;
        let mut out: Vec<Series> = (0..count).map(|_| Series::with_capacity(times)).collect();
        let mut evaluation = Evaluation::new(sides, points, sign, 0..sides.tape().output_count());
        let mut failed = 0;
        let mut from = 0;
        while from < times {
            // The last block begins earlier, and yields only what is missing.
            let begin = from.min(times.saturating_sub(BLOCK));
            let end = (begin + BLOCK).min(times);
            if times >= BLOCK && failed < PATIENCE {
                if let Some(slots) = evaluation.at_all(std::array::from_fn(|i| begin + i)) {
                    failed = 0;
                    for (k, series) in out.iter_mut().enumerate() {
                        series.push_block(three(|n| sides.tape().output(SIDES * k + n, slots)), from - begin);
                    }
                    from = end;
                    continue;
                }
                failed += 1;
            }
            for at in from..end {
                let slots = evaluation.at(at);
                for (k, series) in out.iter_mut().enumerate() {
                    let of = |[left, right, difference]: [&Bounded; SIDES]| Measured {
                        left: left.value,
                        right: right.value,
                        difference: *difference,
                    };
                    series.push(three(|n| sides.tape().output(SIDES * k + n, slots)).map(of));
                }
            }
            from = end;
        }
        out
    }
}

/// What is computed of each comparison: left, right, left − right.
pub(super) const SIDES: usize = 3;

/// The outputs of a comparison, or why the first that has no value has none.
fn three<'s, T>(output: impl Fn(usize) -> Result<&'s T, NoValue>) -> Result<[&'s T; SIDES], NoValue> {
    Ok([output(0)?, output(1)?, output(2)?])
}
