//! The rate of a quantity that is said to be constant, and is not.
//!
//! **In:** an expression that fails to keep its value, and points of the motions on which it should. **Out:** equations that say its
//! rate by one term: that of an energy with friction is -2γẋ². They are guesses, from the values at the points; what is told is
//! proved first.

use super::battery::Value;
use super::completion::{Points, fits};
use super::gap::monomial;
use super::generate::{self, Formula};
use crate::derivation::{Claim, Derivation, Form, Written};
use crate::expr::tape::Tape;
use crate::expr::{Expr, Graph, Leaf, Rational, Tensor};
use crate::latex::syntax::{Chain, Node, NodeKind, SymbolNode, to_latex};
use crate::latex::{self, Role};
use crate::number::{Bounded, NoValue};
use claim::comparison::traced;

/// What a form says to be constant.
fn constant(form: &Form) -> Option<&Written<Tensor>> {
    if let Form::FirstIntegral(written) = form { Some(written) } else { None }
}

/// The rate of a scalar that is said to be constant.
#[derive(Clone, Debug)]
pub(super) struct Rate {
    /// In rates of the states.
    pub value: Expr,
    /// Rates of what the claim names, which say it as a formula would.
    pub named: Vec<Leaf>,
}

impl Rate {
    /// That of an expression of a claim; `None` where it has none.
    pub fn of(graph: &mut Graph, claim: &Claim, e: Expr) -> Option<Rate> {
        let scope = &claim.scope;
        let time = scope.time()?;
        let moves = |leaf: Leaf| matches!(scope.role(leaf.symbol), Some(Role::State | Role::Observable));
        let basic = traced(graph, scope, e);
        let value = graph.time_derivative(basic, time, moves).ok()?;
        let written = claim.forms.iter().filter_map(constant).map(|w| &w.value.components);
        let named = graph.leaves(written.flatten().copied()).into_iter();
        let named = named.filter(|leaf| leaf.instant.is_none() && moves(*leaf));
        Some(Rate { value, named: named.map(|leaf| Leaf { rate: leaf.rate + 1, ..leaf }).collect() })
    }
}

/// Equations that say the rate of a quantity by one term, the simplest first; none where it has no rate at the points.
pub(super) fn rates(
    derivation: &Derivation,
    claim: &Claim,
    graph: &mut Graph,
    formula: &Formula,
    (nodes, values): (&[Node], &[Vec<f64>]),
    points: &Points,
) -> Vec<Chain> {
    let wanted = formula.rate.as_ref().and_then(|rate| valued(graph, rate.value, points));
    let Some(wanted) = wanted else { return Vec::new() };
    let Some(left) = named(derivation, claim, formula) else { return Vec::new() };
    // What does not change stands first.
    let mut steady = |node: &Node| {
        let value = latex::elaborate_expression(node, &claim.scope, graph);
        value.is_ok_and(|value| {
            graph.leaves(value.components).iter().all(|l| claim.scope.role(l.symbol) == Some(Role::Parameter))
        })
    };
    let moves: Vec<bool> = nodes.iter().map(|node| !steady(node)).collect();
    let chain = |(coefficient, mut powers): (Rational, Vec<(usize, i32)>)| {
        powers.sort_by_key(|&(a, _)| moves[a]);
        let factors: Vec<(&Node, i32)> = powers.iter().map(|&(a, n)| (&nodes[a], n)).collect();
        generate::tree(&format!("{left}={}", to_latex_of(monomial(&coefficient, &factors))), &claim.scope)
    };
    fits(values, &wanted).into_iter().filter_map(chain).collect()
}

/// The values of an expression at points; `None` where it is not known at one, or vanishes.
fn valued(graph: &Graph, e: Expr, points: &Points) -> Option<Vec<f64>> {
    let leaves = graph.leaves([e]);
    let tape = Tape::compile(graph, &leaves, &[e]).ok()?;
    let mut slots = tape.slots::<Bounded>(&());
    let at = |point: &&Vec<Value>| {
        let known = |l| points.known.binary_search(l).map_or(Err(NoValue::Indeterminate), |i| point[i]);
        let inputs: Vec<Value> = leaves.iter().map(known).collect();
        let value = tape.evaluate(&(), &inputs, &mut slots).into_iter().next()?.ok()?;
        (value.value.abs() > 1e3 * value.error).then_some(value.value)
    };
    points.points.iter().map(at).collect()
}

fn to_latex_of(node: Node) -> String {
    let span = node.span.clone();
    to_latex(&Chain { sides: vec![node], relations: Vec::new(), span, time: None })
}

/// How the rate of the quantity of a formula is written: by a dot where the claim names it by a symbol.
fn named(derivation: &Derivation, claim: &Claim, formula: &Formula) -> Option<String> {
    let is_it = |w: &&Written<_>| {
        let named = generate::defined_as(derivation, claim, &w.text);
        w.text.trim() == formula.text || named.is_some_and(|text| text.trim() == formula.text)
    };
    let written = claim.forms.iter().filter_map(constant).find(is_it)?;
    let written = generate::tree(&written.text, &claim.scope)?;
    let [side] = written.sides.as_slice() else { return None };
    if let NodeKind::Symbol(symbol) = &side.kind
        && symbol.dots == 0
        && symbol.sup.is_none()
        && symbol.arguments.is_none()
    {
        let dotted = SymbolNode { dots: 1, ..symbol.clone() };
        return Some(to_latex_of(Node::new(NodeKind::Symbol(dotted), side.span.clone())));
    }
    let time = claim.scope.time()?;
    let time = derivation.symbols.iter().find(|entry| entry.symbol == time.symbol)?;
    Some(format!(r"\frac{{d}}{{d{}}}\left({}\right)", time.name, to_latex(&written)))
}
