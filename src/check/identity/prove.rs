//! The procedure: premises prepared, lowered and solved; every case tested over finite fields and at real points.

use super::field::{Question, Trials, trials};
use super::lower::{Generator, Generators, Lowering, TooLarge};
use super::outcome::{Condition, Identity, Options, Premises, Proof, Reason};
use super::polynomial::factors;
use super::prepare::{argument_leaves, explicit, with_rates};
use super::probe::Probe;
use super::roots::Roots;
use super::sign::Facts;
use super::solve::{Failed, Resolved, Solver, closed, insert_definitions};
use super::witness::{Found, Scene, domains, refutation};
use crate::expr::{Expr, Graph, Leaf, Node, Op};
use crate::number::Draws;
use std::collections::{HashMap, HashSet};

type Pairs = Vec<(Expr, Expr)>;

/// The problem after lowering.
struct Lowered {
    generators: Generators,
    /// Residuals of the premises that are not definitions.
    premises: Vec<Expr>,
    claim: Pairs,
    facts: Facts,
    denominators: Vec<Expr>,
    /// Given as ≠ 0.
    assumed: Vec<Expr>,
    frozen: HashSet<Leaf>,
}

/// Whether the equations hold wherever the premises do and both sides have a value.
pub fn identity_test(
    graph: &mut Graph,
    equations: &[(Expr, Expr)],
    given: &Premises,
    options: &Options,
) -> Identity {
    match decide(graph, equations, given, options) {
        Ok(identity) => identity,
        Err(reason) => Identity::Undecided(reason),
    }
}

impl From<TooLarge> for Reason {
    fn from(_: TooLarge) -> Reason {
        Reason::TooLarge
    }
}

impl From<Failed> for Reason {
    fn from(failed: Failed) -> Reason {
        match failed {
            Failed::NoValue => Reason::NoValue,
            Failed::TooManyCases => Reason::TooLarge,
        }
    }
}

fn decide(graph: &mut Graph, equations: &[(Expr, Expr)], given: &Premises, options: &Options) -> Result<Identity, Reason> {
    let mut draws = Draws::new(options.seed);
    let premises = with_rates(graph, given, equations)?;
    let solved = explicit(graph, &premises, equations, given);
    let insert = |graph: &mut Graph, e: Expr| insert_definitions(graph, &solved.definitions, e);
    let claim: Pairs = equations.iter().map(|&(l, r)| (insert(graph, l), insert(graph, r))).collect();
    let nonzero: Vec<Expr> = given.nonzero.iter().map(|&e| insert(graph, e)).collect();
    let positive: Vec<Expr> = given.positive.iter().map(|&e| insert(graph, e)).collect();
    let definitions: Vec<Expr> = solved.definitions.values().copied().collect();
    let mut lowered = lower(graph, &solved.rest, &claim, (&nonzero, &positive), &definitions)?;
    let mut probe = Probe::new(&mut draws);
    let parameters: HashSet<Leaf> =
        given.parameters.iter().copied().chain(given.positive.iter().filter_map(|&e| leaf_of(graph, e))).collect();
    let cases = Solver {
        graph,
        generators: &mut lowered.generators,
        probe: &mut probe,
        facts: &lowered.facts,
        frozen: &lowered.frozen.iter().copied().chain(given.time).collect(),
        parameters: &parameters,
    }
    .solve(&lowered.premises)?;
    if cases.is_empty() {
        return Err(Reason::Contradiction);
    }
    let mut proof = Proof {
        log2_error: f64::NEG_INFINITY,
        degree_bound: 0.0,
        height_bound: 0.0,
        trials: 0,
        primes: Vec::new(),
        signs: 0,
        cases: 0,
        conditions: Vec::new(),
        example: None,
    };
    let mut open: Option<Reason> = None;
    let mut empty: Option<Reason> = None;
    let count = cases.len() as f64;
    let each = Options { target_log2_error: options.target_log2_error - count.log2(), ..*options };
    for case in &cases {
        let map = closed(graph, &case.definitions);
        let question = question(graph, &mut lowered, &mut probe, case, &map);
        let outcome = trials(graph, &lowered.generators, &question, &each, &mut draws);
        let sides: Pairs = lowered
            .claim
            .iter()
            .map(|&(l, r)| (insert_definitions(graph, &map, l), insert_definitions(graph, &map, r)))
            .collect();
        let scene = Scene {
            graph,
            generators: &lowered.generators,
            claim: equations,
            lowered: &sides,
            premises: &premises,
            nonzero: &given.nonzero,
            positive: &given.positive,
            explicit: &solved.definitions,
            defined: &map,
        };
        match outcome {
            Trials::Vanish(bound) => {
                let found = look(&scene, &mut draws, options.attempts, |f| !f.is_empty());
                if let Some(f) = found.iter().find(|f| f.differs.is_some()) {
                    let sides = f.differs.map(|at| format!("{:?}", f.sides[at])).unwrap_or_default();
                    return Err(Reason::Defect(format!("proved over finite fields, but at a real point: {sides}")));
                }
                proof.example = proof.example.take().or_else(|| found.first().map(|f| f.point.clone()));
                proof.trials = proof.trials.max(bound.primes.len());
                proof.primes.extend(bound.primes);
                proof.degree_bound = proof.degree_bound.max(bound.degree);
                proof.height_bound = proof.height_bound.max(bound.height);
                proof.signs = proof.signs.max(bound.signs);
                proof.log2_error = add_log2(proof.log2_error, bound.log2_error);
                proof.cases += 1;
            }
            Trials::Fail { failing, of } => {
                let enough = |f: &[Found]| {
                    refutation(f).is_some_and(|r| {
                        r.left.exact.is_some() && r.right.exact.is_some() && r.second.is_some() || f.len() > 12
                    })
                };
                let found = look(&scene, &mut draws, options.attempts, enough);
                if let Some(refutation) = refutation(&found) {
                    return Ok(Identity::Refuted(Box::new(refutation)));
                }
                open.get_or_insert(Reason::Branches { failing, of });
            }
            Trials::Contradiction => drop(empty.get_or_insert(Reason::Contradiction)),
            Trials::NoValue => drop(empty.get_or_insert(Reason::NoValue)),
            Trials::Unsettled(reason) => drop(open.get_or_insert(reason)),
        }
    }
    if let Some(reason) = open {
        return Err(reason);
    }
    if proof.cases == 0 {
        return Err(empty.unwrap_or(Reason::NoValue));
    }
    let mut all: Vec<Expr> = equations.iter().chain(&premises).flat_map(|&(l, r)| [l, r]).collect();
    all.dedup();
    proof.conditions = conditions(graph, &lowered, given, &cases, &all, &solved.pivots);
    Ok(Identity::Proved(proof))
}

fn leaf_of(graph: &Graph, e: Expr) -> Option<Leaf> {
    match graph.node(e) {
        Node::Leaf(leaf) => Some(*leaf),
        _ => None,
    }
}

/// log₂(2ᵃ + 2ᵇ), from above.
fn add_log2(a: f64, b: f64) -> f64 {
    if a == f64::NEG_INFINITY { b } else { a.max(b) + 1.0 }
}

fn lower(
    graph: &mut Graph,
    premises: &[(Expr, Expr)],
    claim: &[(Expr, Expr)],
    (nonzero, positive): (&[Expr], &[Expr]),
    definitions: &[Expr],
) -> Result<Lowered, Reason> {
    let residuals: Vec<Expr> = premises.iter().map(|&(l, r)| graph.sub(l, r)).collect();
    let mut roots: Vec<Expr> = claim.iter().flat_map(|&(l, r)| [l, r]).collect();
    roots.extend(residuals.iter().chain(nonzero).chain(positive).chain(definitions));
    let frozen = argument_leaves(graph, roots.iter().copied());
    let mut lowering = Lowering::new(graph, &roots);
    let premises = residuals.iter().map(|&e| lowering.lower(e)).collect::<Result<Vec<_>, _>>()?;
    let mut sides = Vec::new();
    for &(l, r) in claim {
        sides.push((lowering.lower(l)?, lowering.lower(r)?));
    }
    let mut facts = Facts::default();
    for &e in positive {
        let image = lowering.lower(e)?;
        facts.positive.insert(image);
    }
    let mut not_zero = Vec::new();
    for &e in nonzero {
        not_zero.push(lowering.lower(e)?);
    }
    // Formulas are claimed where they have a value, so their denominators are not 0 there.
    let mut lowered_roots = premises.clone();
    lowered_roots.extend(sides.iter().flat_map(|&(l, r)| [l, r]));
    for &e in definitions {
        lowered_roots.push(lowering.lower(e)?);
    }
    let graph = &mut *lowering.graph;
    let mut denominators = Vec::new();
    for node in graph.reachable(lowered_roots) {
        match *graph.node(node) {
            Node::Binary(Op::Div, _, b) => denominators.push(b),
            Node::Unary(Op::Powi(n), a) if n < 0 => denominators.push(a),
            _ => {}
        }
    }
    denominators.retain(|&e| graph.as_constant(e).is_none());
    for &e in not_zero.iter().chain(&denominators) {
        facts.nonzero.insert(e);
        facts.nonzero.extend(factors(graph, e).1.into_iter().map(|(base, _)| base));
    }
    let generators = lowering.generators;
    Ok(Lowered { generators, premises, claim: sides, facts, denominators, assumed: not_zero, frozen })
}

/// What is asked of the field for one case: everything with the case's definitions, in normal form, circles parametrised.
fn question(
    graph: &mut Graph,
    lowered: &mut Lowered,
    probe: &mut Probe,
    case: &Resolved,
    map: &HashMap<Leaf, Expr>,
) -> Question {
    let inserted = |graph: &mut Graph, list: &[Expr]| -> Vec<Expr> {
        list.iter().map(|&e| insert_definitions(graph, map, e)).collect()
    };
    let residuals: Vec<Expr> = lowered.claim.iter().map(|&(l, r)| graph.sub(l, r)).collect();
    let residuals = inserted(graph, &residuals);
    let filters = inserted(graph, &case.unsolved);
    let mut zeros = inserted(graph, &case.taken_as_zero);
    let mut assumed = inserted(graph, &lowered.assumed);
    let mut nonzeros = inserted(graph, &lowered.denominators);
    let mut facts = lowered.facts.clone();
    for set in [&mut facts.positive, &mut facts.not_negative, &mut facts.nonzero] {
        let mut list: Vec<Expr> = set.iter().copied().collect();
        list.sort_unstable();
        set.extend(inserted(graph, &list));
    }
    let mut all = residuals.clone();
    all.extend(filters.iter().chain(&zeros).chain(&assumed).chain(&nonzeros));
    let mut roots = Roots::new(graph, &mut lowered.generators, probe, facts);
    roots.prepare(&all);
    let mut normal = |list: Vec<Expr>| -> Vec<Expr> { list.into_iter().map(|e| roots.normal(e)).collect() };
    let (residuals, filters) = (normal(residuals), normal(filters));
    zeros = normal(zeros);
    assumed = normal(assumed);
    nonzeros = normal(nonzeros);
    let taken = std::mem::take(&mut roots.taken_as_zero);
    zeros.extend(taken.into_iter().map(|e| roots.normal(e)).collect::<Vec<_>>());
    let mut out = Question { residuals, filters, zeros, assumed, nonzeros };
    parametrise(graph, &mut lowered.generators, &mut out);
    out
}

/// c = (1 − t²)/(1 + t²), s = 2t/(1 + t²) for every pair that is not solved for.
fn parametrise(graph: &mut Graph, generators: &mut Generators, question: &mut Question) {
    let Question { residuals, filters, zeros, assumed, nonzeros } = question;
    let lists = [residuals, filters, zeros, assumed, nonzeros];
    let leaves = graph.leaves(lists.iter().flat_map(|l| l.iter().copied()));
    let mut map: HashMap<Leaf, Expr> = HashMap::new();
    for leaf in leaves {
        let Some((c, s)) = generators.circle(leaf) else { continue };
        if map.contains_key(&leaf) {
            continue;
        }
        let Some(t) = generators.add(Generator::Half) else { continue };
        let t = graph.leaf(t);
        let (one, two, square) = (graph.integer(1), graph.integer(2), graph.powi(t, 2));
        let (above, below, twice) = (graph.sub(one, square), graph.add(one, square), graph.mul(two, t));
        map.insert(c, graph.div(above, below));
        map.insert(s, graph.div(twice, below));
    }
    for list in lists {
        for e in list.iter_mut() {
            *e = insert_definitions(graph, &map, *e);
        }
    }
}

fn look(scene: &Scene<'_>, draws: &mut Draws, attempts: u32, enough: impl Fn(&[Found]) -> bool) -> Vec<Found> {
    let mut found = Vec::new();
    for number in 0..attempts {
        if let Some(f) = scene.attempt(number, draws) {
            found.push(f);
            if enough(&found) {
                break;
            }
        }
    }
    found
}

/// Conditions that are not among the facts, in words of the formulas as given.
fn conditions(
    graph: &mut Graph,
    lowered: &Lowered,
    given: &Premises,
    cases: &[Resolved],
    formulas: &[Expr],
    pivots: &[Expr],
) -> Vec<Condition> {
    let generators = &lowered.generators;
    let raise = |graph: &mut Graph, e: Expr| {
        graph.substitute(e, |graph, leaf| {
            Some(match *generators.get(leaf)? {
                Generator::Cosine(a) => graph.unary(Op::Cos, a),
                Generator::Sine(a) => graph.unary(Op::Sin, a),
                Generator::Exponential(a) => graph.unary(Op::Exp, a),
                Generator::Opaque(e) => e,
                Generator::Sign | Generator::Half => return None,
            })
        })
    };
    let mut out = domains(graph, formulas);
    let mut from_cases = Vec::new();
    for case in cases {
        from_cases.extend(case.pivots.iter().map(|&e| Condition::Pivot(e)));
        from_cases.extend(case.radicands.iter().map(|&e| Condition::Radicand(e)));
    }
    let unknown = |graph: &Graph, c: &Condition| match *c {
        Condition::Pivot(e) => !lowered.facts.sign(graph, generators, e).nonzero,
        Condition::Radicand(e) => !lowered.facts.sign(graph, generators, e).not_negative,
        _ => true,
    };
    from_cases.retain(|c| unknown(graph, c));
    for c in from_cases {
        out.push(match c {
            Condition::Pivot(e) => Condition::Pivot(raise(graph, e)),
            Condition::Radicand(e) => Condition::Radicand(raise(graph, e)),
            other => other,
        });
    }
    out.extend(pivots.iter().map(|&e| Condition::Pivot(e)));
    // Declared facts need no mention.
    let mut facts = Facts::default();
    facts.positive.extend(given.positive.iter().copied());
    for &e in &given.nonzero {
        facts.nonzero.insert(e);
        facts.nonzero.extend(factors(graph, e).1.into_iter().map(|(base, _)| base));
    }
    let mut seen = HashSet::new();
    out.retain(|c| {
        let known = match *c {
            Condition::Denominator(e) | Condition::Pivot(e) => facts.sign(graph, generators, e).nonzero,
            Condition::Radicand(e) => facts.sign(graph, generators, e).not_negative,
            Condition::Positive(e) => {
                let k = facts.sign(graph, generators, e);
                k.nonzero && k.not_negative
            }
            Condition::Unit(_) => false,
        };
        !known && seen.insert(*c)
    });
    out
}
