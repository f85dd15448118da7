//! One question: does a step hold, given some definitions and equations, for all names or for positive ones?
//!
//! **In:** two sides, what they may rest on. **Out:** an [`Asked`]: the answer of the prover, with the graph that it is about.
//! **Guaranteed:** a proof that leaves out a case that was divided by is none; nor is one from equations that no real point was seen to
//! satisfy, since these would imply anything; nor is one from premises that make both sides zero, where the sides as printed are not:
//! these prove the same step with any factor in it.

use std::collections::BTreeSet;

use expr::{Expr, Graph, Leaf, Node as GraphNode, Op};
use latex::syntax::{Node, NodeKind, RelationKind};
use meter::{Ended, Task};
use paper::PrintedSide;
use proof::{Condition, Identity, Known, Options, Premises, Proof, Wanted, When, identity_test};

use super::desk::{Desk, Given, Unit, pairs_of};
use super::facts::Stated;
use super::notation::Evidence;
use super::numbers::agreement;
use super::refusal::NotRead;

/// The counted work of reading a question, beside what its formulas take.
const OF_A_QUESTION: u64 = 200_000;
/// Points at which a side is looked at before it is proved to be zero.
const ZERO_POINTS: usize = 12;

/// Names that are taken to be positive.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Positive {
    /// Those that the paper says to be.
    Named(BTreeSet<String>),
    /// All that do not depend on the time.
    Parameters,
}

/// What a step may rest on.
#[derive(Clone, Debug)]
pub struct Rests {
    /// Definitions and rates.
    pub given: Vec<Given>,
    /// Equations.
    pub stated: Vec<Stated>,
    /// Signs.
    pub positive: Positive,
}

impl Rests {
    /// Whether there is any definition, rate or equation.
    pub fn are_some(&self) -> bool {
        !self.given.is_empty() || !self.stated.is_empty()
    }

    /// Whether both rest on the same relations.
    pub fn rests_on_the_same(&self, other: &Rests) -> bool {
        let given = |r: &Rests| r.given.iter().map(|g| (g.relation, g.is_rate)).collect::<Vec<_>>();
        let stated = |r: &Rests| r.stated.iter().map(|s| (s.relation, s.left.span.clone())).collect::<Vec<_>>();
        given(self) == given(other) && stated(self) == stated(other)
    }
}

/// A question, and its answer.
pub struct Asked {
    /// The graph and the scope.
    pub desk: Desk,
    /// What was given.
    pub premises: Premises,
    /// The pairs of scalars that are asked to be equal.
    pub equations: Vec<(Expr, Expr)>,
    /// The answer.
    pub identity: Identity,
    /// Whether what is given makes both sides zero: it proves the step, and the step with any factor.
    pub is_vacuous: bool,
    /// The relation that was read.
    pub text: String,
}

impl Asked {
    /// Whether it is proved.
    pub fn is_proved(&self) -> bool {
        matches!(self.identity, Identity::Proved(_))
    }
}

/// A question as the prover takes it.
struct Put {
    desk: Desk,
    equations: Vec<(Expr, Expr)>,
    premises: Premises,
    /// The relation that was read.
    text: String,
}

impl Put {
    fn of(
        sides: [&PrintedSide; 2],
        rests: &Rests,
        evidence: &Evidence,
        free: &BTreeSet<char>,
        unit: Unit,
    ) -> Result<Put, NotRead> {
        meter::piece(Task::Step, evidence.limits(), || {
            meter::charge(OF_A_QUESTION);
            Put::read(sides, rests, evidence, free, unit)
        })
        .map_err(NotRead::ended)?
    }

    fn read(
        sides: [&PrintedSide; 2],
        rests: &Rests,
        evidence: &Evidence,
        free: &BTreeSet<char>,
        unit: Unit,
    ) -> Result<Put, NotRead> {
        let list: Vec<&Given> = rests.given.iter().collect();
        let mut all: Vec<&PrintedSide> = sides.to_vec();
        all.extend(rests.stated.iter().flat_map(|s| [&s.left, &s.right]));
        let mut desk = Desk::with_unit(&all, &list, evidence, free, unit)?;
        let read = desk.read(sides, evidence)?;
        let statement = &read.statement;
        if statement.relations.iter().any(|r| r.kind != RelationKind::Equal || r.has_branches || r.limit.is_some()) {
            return Err(NotRead::of("a sign of two branches, or a limit"));
        }
        let equations = pairs_of(statement);
        let mut premises = Premises { time: desk.time, moving: desk.moving.clone(), ..Premises::default() };
        let rates = rests.given.iter().filter(|g| g.is_rate).map(|g| [&g.left, &g.right]);
        for [left, right] in rates.chain(rests.stated.iter().map(|s| [&s.left, &s.right])) {
            let pairs = desk.pairs([left, right], evidence)?;
            premises.equations.extend(pairs.into_iter().map(|pair| Known::of(pair, When::Always)));
        }
        if !desk.is_complex {
            let positive = |key: &String, is_parameter: bool| match &rests.positive {
                Positive::Named(keys) => keys.contains(key),
                Positive::Parameters => is_parameter,
            };
            let chosen = desk.scalars.iter().filter(|(key, _, parameter)| positive(key, *parameter));
            let leaves: Vec<Leaf> = chosen.map(|(_, symbol, _)| Leaf::now(*symbol, 0)).collect();
            premises.positive = leaves.into_iter().map(|l| desk.graph.leaf(l)).collect();
        }
        Ok(Put { desk, equations, premises, text: read.text })
    }

    fn decided(&mut self, wanted: Wanted) -> Result<Identity, NotRead> {
        tested(&mut self.desk, &self.equations, &self.premises, wanted).map_err(NotRead::ended)
    }
}

/// Asks whether two sides are equal.
///
/// # Errors
/// The feature that is not understood.
pub fn ask(
    sides: [&PrintedSide; 2],
    rests: &Rests,
    evidence: &Evidence,
    free: &BTreeSet<char>,
) -> Result<Asked, NotRead> {
    let mut put = Put::of(sides, rests, evidence, free, Unit::Imaginary)?;
    let identity = put.decided(Wanted::Answer)?;
    // Equations between numbers that may be complex do not hold part by part.
    let is_apart = put.desk.is_complex && !rests.stated.is_empty() && matches!(identity, Identity::Proved(_));
    let is_proved_whole = || {
        let mut whole = Put::of(sides, rests, evidence, free, Unit::Number)?;
        Ok::<bool, NotRead>(matches!(whole.decided(Wanted::Proof)?, Identity::Proved(_)))
    };
    let identity = match is_apart && !is_proved_whole().unwrap_or(false) {
        true => Identity::Undecided(proof::Reason::Degenerate),
        false => identity,
    };
    let Put { mut desk, equations, premises, text } = put;
    // What nothing satisfies implies everything, and what has no real value is equal to anything.
    let identity = match identity {
        Identity::Proved(proof) if proof.example.is_none() => Identity::Undecided(proof::Reason::NoValue),
        other => other,
    };
    if matches!(identity, Identity::Proved(_))
        && !rests.are_some()
        && only_reorders(&text, &desk, evidence.is_quantum())
    {
        return Err(NotRead::of("products whose order may count: matrices, or operators"));
    }
    let is_vacuous = matches!(identity, Identity::Proved(_))
        && rests.are_some()
        && vanishes(&mut desk, &equations, &premises)
        && !sides.iter().any(|side| is_zero_by_itself(side, evidence, free));
    let identity = if is_vacuous { Identity::Undecided(proof::Reason::Degenerate) } else { identity };
    Ok(Asked { desk, premises, equations, identity, is_vacuous, text })
}

/// Whether both sides are the same but for the order of factors: those of operators, or of fields that anticommute, do not change places. Where
/// vectors may be operators, too, theirs counts, and a vector times itself need not be zero.
fn only_reorders(text: &str, desk: &Desk, of_vectors: bool) -> bool {
    let Ok(chains) = latex::parse(text, &desk.scope) else { return false };
    let [chain] = chains.as_slice() else { return false };
    let [left, right] = chain.sides.as_slice() else { return false };
    let sorted = if of_vectors { Order::OfAll } else { Order::OfNumbers };
    let is_other_order = in_print(left, Order::AsPrinted) != in_print(right, Order::AsPrinted)
        && in_print(left, sorted) == in_print(right, sorted);
    let is_cross = |node: &Node| matches!(node.kind, NodeKind::Cross { .. });
    is_other_order || of_vectors && (is_cross(left) && right.is_zero() || is_cross(right) && left.is_zero())
}

/// How the factors of a product stand in a text that is compared.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Order {
    AsPrinted,
    /// Those of products of numbers are sorted.
    OfNumbers,
    /// Those of all products are.
    OfAll,
}

/// A formula as a text, with the factors of every product in an order of their own where that is wanted. Products of vectors keep theirs.
fn in_print(node: &Node, order: Order) -> String {
    let children = |parts: Vec<&Node>| parts.into_iter().map(|n| in_print(n, order)).collect::<Vec<_>>();
    let is_vector =
        |n: &Node| matches!(&n.kind, NodeKind::Symbol(s) if s.name.starts_with("bf:") || s.name.starts_with("vec:"));
    match &node.kind {
        NodeKind::Group(inner, _) => in_print(inner, order),
        // A sign of multiplication before parentheses was put there.
        NodeKind::Product(parts) | NodeKind::Dot(parts) if order == Order::OfAll || !parts.iter().any(is_vector) => {
            let mut all: Vec<String> = Vec::new();
            for part in parts {
                let inner = match &part.kind {
                    NodeKind::Group(inner, _) => inner,
                    _ => part,
                };
                match &inner.kind {
                    NodeKind::Product(more) => all.extend(children(more.iter().collect())),
                    _ => all.push(in_print(inner, order)),
                }
            }
            if order != Order::AsPrinted {
                all.sort();
            }
            all.join("*")
        }
        NodeKind::Symbol(s) => {
            let above = s.sup.as_ref().map(|n| in_print(n, order)).unwrap_or_default();
            let places = s.arguments.as_ref().map(|a| children(a.iter().collect()).join(",")).unwrap_or_default();
            format!("{}{:?}{}^({above})({places})", s.name, s.sub, s.dots)
        }
        NodeKind::Sum(terms) => {
            terms.iter().map(|(sign, n)| format!("{sign:?}{}", in_print(n, order))).collect::<Vec<_>>().join(" ")
        }
        kind => {
            let name = format!("{:?}", std::mem::discriminant(kind));
            let own = if node.children().is_empty() { format!("{kind:?}") } else { name };
            format!("{own}[{}]", children(node.children()).join(";"))
        }
    }
}

/// Whether the premises prove that the left sides of all pairs are zero.
pub fn vanishes(desk: &mut Desk, equations: &[(Expr, Expr)], premises: &Premises) -> bool {
    let zero = desk.graph.integer(0);
    let zeros: Vec<(Expr, Expr)> = equations.iter().map(|&(left, _)| (left, zero)).collect();
    // Premises that are equations are no part of the graph: points do not satisfy them.
    if premises.equations.is_empty() && !agreement(&desk.graph, &zeros, ZERO_POINTS).is_some_and(|(_, all)| all) {
        return false;
    }
    matches!(tested(desk, &zeros, premises, Wanted::Proof), Ok(Identity::Proved(_)))
}

/// Whether a side is zero as it is printed, with no premise: the number 0, or what is 0 for all values of its names.
fn is_zero_by_itself(side: &PrintedSide, evidence: &Evidence, free: &BTreeSet<char>) -> bool {
    let Ok(mut desk) = Desk::new(&[side], &[], evidence, free) else { return false };
    let Ok(equations) = desk.pairs([side, side], evidence) else { return false };
    let zero = desk.graph.integer(0);
    let zeros: Vec<(Expr, Expr)> = equations.into_iter().map(|(value, _)| (value, zero)).collect();
    agreement(&desk.graph, &zeros, ZERO_POINTS).is_some_and(|(valid, all)| all && valid > 0)
}

/// How many premises say what the square of a name is.
fn squares_of_names(graph: &mut Graph, premises: &Premises) -> usize {
    let mut is_square = |e: Expr| {
        let [leaf] = graph.leaves([e])[..] else { return false };
        let name = graph.leaf(leaf);
        graph.powi(name, 2) == e
    };
    premises.pairs().filter(|&(l, r)| is_square(l) || is_square(r)).count()
}

/// How many angles stand in premises: one that is solved for a cosine has a sine with a root, whose square is a number.
fn angles(graph: &Graph, premises: &Premises) -> usize {
    let sides: Vec<Expr> = premises.pairs().flat_map(|(l, r)| [l, r]).collect();
    let of = |e: Expr| match graph.node(e) {
        GraphNode::Unary(Op::Sin | Op::Cos | Op::Tan, angle) => Some(*angle),
        _ => None,
    };
    graph.reachable(sides).into_iter().filter_map(of).collect::<BTreeSet<Expr>>().len()
}

/// Whether a proof is none of what is printed: a case that was divided by is left out; or a root was taken of what may be a vector, but where
/// the square of a name is what is given, `\gamma^2=\ldots`.
fn is_of_less(graph: &mut Graph, premises: &Premises, proof: &Proof) -> bool {
    let count = |is: fn(&Condition) -> bool| proof.conditions.iter().filter(|c| is(c)).count();
    count(|c| matches!(c, Condition::Pivot(_))) > 0
        || count(|c| matches!(c, Condition::Discriminant(_)))
            > squares_of_names(graph, premises) + angles(graph, premises)
}

/// The answer, with a bound on the work, and on that of the whole paper.
///
/// # Errors
/// The work was used up before there was an answer.
pub fn tested(
    desk: &mut Desk,
    equations: &[(Expr, Expr)],
    premises: &Premises,
    wanted: Wanted,
) -> Result<Identity, Ended> {
    let Desk { graph, limits, .. } = desk;
    let proof = wanted == Wanted::Proof;
    let options = Options {
        attempts: if proof { 0 } else { 60 },
        special_cases: 0,
        most_signs: 6,
        most_nodes: 4000,
        wanted,
        ..Options::default()
    };
    let answer = meter::piece(Task::Step, limits, || identity_test(graph, equations, premises, &options))?;
    Ok(match answer {
        Identity::Proved(proof) if is_of_less(graph, premises, &proof) => {
            Identity::Undecided(proof::Reason::Degenerate)
        }
        other => other,
    })
}
