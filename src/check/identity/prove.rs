//! The procedure: premises prepared, lowered and solved; every case tested over finite fields and at real points.

use super::field::{Question, Trials, trials};
use super::lower::{Generator, Generators, Lowering, TooLarge};
use super::outcome::{Condition, Identity, Options, Premises, Proof, Reason, Refutation};
use super::polynomial::factors;
use super::prepare::{Premise, argument_leaves, explicit, with_rates};
use super::probe::Probe;
use super::roots::Roots;
use super::sign::Facts;
use super::solve::{Failed, Resolved, Solver, Strategy, closed, insert_definitions, unmarked};
use super::witness::{Found, Scene, domains, refutation};
use crate::expr::{Expr, Graph, Leaf, Node, Op};
use crate::number::Draws;
use std::collections::{HashMap, HashSet};

type Pairs = Vec<(Expr, Expr)>;

/// The problem after lowering.
struct Lowered {
    generators: Generators,
    /// Residuals of the premises that are not definitions, and whether they are derivatives of others.
    premises: Vec<(Expr, bool)>,
    claim: Pairs,
    facts: Facts,
    denominators: Vec<Expr>,
    /// Given as ≠ 0.
    assumed: Vec<Expr>,
    frozen: HashSet<Leaf>,
}

/// Whether the equations hold wherever the premises do and both sides have a value.
pub fn identity_test(graph: &mut Graph, equations: &[(Expr, Expr)], given: &Premises, options: &Options) -> Identity {
    match decide(graph, equations, given, options) {
        Ok(proof) => Identity::Proved(proof),
        Err(Stop::Refuted(refutation)) => Identity::Refuted(refutation),
        Err(Stop::Undecided(reason)) => Identity::Undecided(reason),
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

fn decide(graph: &mut Graph, equations: &[(Expr, Expr)], given: &Premises, options: &Options) -> Result<Proof, Stop> {
    let mut draws = Draws::new(options.seed);
    let premises = with_rates(graph, given, equations)?;
    let solved = explicit(graph, &premises, equations, given);
    let premises: Pairs = premises.iter().map(|p| (p.left, p.right)).collect();
    let insert = |graph: &mut Graph, e: Expr| insert_definitions(graph, &solved.definitions, e);
    let claim: Pairs = equations.iter().map(|&(l, r)| (insert(graph, l), insert(graph, r))).collect();
    let nonzero: Vec<Expr> = given.nonzero.iter().map(|&e| insert(graph, e)).collect();
    let positive: Vec<Expr> = given.positive.iter().map(|&e| insert(graph, e)).collect();
    let definitions: Vec<Expr> = solved.definitions.values().copied().collect();
    let mut lowered = lower(graph, &solved.rest, &claim, (&nonzero, &positive), &definitions)?;
    let probe = Probe::new(&mut draws);
    let parameters: HashSet<Leaf> =
        given.parameters.iter().copied().chain(given.positive.iter().filter_map(|&e| leaf_of(graph, e))).collect();
    lowered.frozen.extend(given.time);
    let mut examination = Examination {
        graph,
        probe,
        draws,
        lowered,
        parameters,
        claim: equations,
        premises: &premises,
        given,
        explicit: &solved.definitions,
        options,
        examples: options.attempts,
        strategy: Strategy::AsGiven,
    };
    let own = examination.lowered.premises.clone();
    let (mut proof, resolved) = examination.generic(&own)?;
    // Where a pivot vanishes, the premises may leave more open: looked at by themselves.
    let mut pivots = Pivots::of(&examination, &resolved);
    examination.examples = if proof.example.is_some() { 6 } else { options.attempts };
    for at in 0..pivots.list.len().min(options.special_cases as usize) {
        if !is_simple(examination.graph, pivots.list[at]) {
            continue;
        }
        let mut with_pivot = vec![(pivots.list[at], false)];
        with_pivot.extend(&own);
        let Ok(outcomes) = examination.run(&with_pivot) else { continue };
        match merge(outcomes) {
            Ok((special, resolved)) => {
                proof.absorb(special);
                pivots.nested[at] = Some(Pivots::of(&examination, &resolved).list);
            }
            Err(Stop::Refuted(refutation)) => return Err(Stop::Refuted(refutation)),
            Err(Stop::Undecided(Reason::Contradiction)) => pivots.nested[at] = Some(Vec::new()),
            Err(Stop::Undecided(defect @ Reason::Defect(_))) => return Err(defect.into()),
            Err(Stop::Undecided(_)) => {}
        }
    }
    let needed = pivots.needed();
    let Examination { graph, lowered, .. } = examination;
    let mut all: Vec<Expr> = equations.iter().chain(&premises).flat_map(|&(l, r)| [l, r]).collect();
    all.dedup();
    proof.conditions = conditions(graph, &lowered, given, &resolved, &all, &solved.pivots, &needed);
    Ok(proof)
}

/// Whether it is worth while to look at the case that a pivot vanishes: it can be solved for something.
fn is_simple(graph: &Graph, pivot: Expr) -> bool {
    let nodes = graph.reachable([pivot]);
    nodes.len() <= 48 && !nodes.iter().any(|&e| matches!(graph.node(e), Node::Unary(Op::Sqrt, _)))
}

/// What becomes of one case.
enum Outcome {
    Holds(Box<Proof>),
    Refuted(Box<Refutation>),
    Open(Reason),
    /// The premises or the formulas rule the case out.
    Empty(Reason),
}

/// Why a list of cases does not amount to a proof.
enum Stop {
    Refuted(Box<Refutation>),
    Undecided(Reason),
}

impl From<Reason> for Stop {
    fn from(reason: Reason) -> Stop {
        Stop::Undecided(reason)
    }
}

/// One proof from all cases, with the resolutions it rests on.
fn merge(outcomes: Vec<(Resolved, Outcome)>) -> Result<(Proof, Vec<Resolved>), Stop> {
    let mut proof: Option<Proof> = None;
    let (mut open, mut empty, mut resolved) = (None, None, Vec::new());
    for (case, outcome) in outcomes {
        match outcome {
            Outcome::Refuted(refutation) => return Err(Stop::Refuted(refutation)),
            Outcome::Open(reason) => drop(open.get_or_insert(reason)),
            Outcome::Empty(reason) => drop(empty.get_or_insert(reason)),
            Outcome::Holds(one) => {
                resolved.push(case);
                match &mut proof {
                    None => proof = Some(*one),
                    Some(all) => all.absorb(*one),
                }
            }
        }
    }
    match (open, proof) {
        (Some(reason), _) => Err(Stop::Undecided(reason)),
        (None, Some(proof)) => Ok((proof, resolved)),
        (None, None) => Err(Stop::Undecided(empty.unwrap_or(Reason::Contradiction))),
    }
}

impl Proof {
    /// Both proofs together.
    fn absorb(&mut self, other: Proof) {
        self.log2_error = self.log2_error.max(other.log2_error) + 1.0;
        self.degree_bound = self.degree_bound.max(other.degree_bound);
        self.height_bound = self.height_bound.max(other.height_bound);
        self.trials = self.trials.max(other.trials);
        self.primes.extend(other.primes);
        self.signs = self.signs.max(other.signs);
        self.cases += other.cases;
        self.example = self.example.take().or(other.example);
    }
}

/// What was divided by, and which of it a special case has dealt with.
struct Pivots {
    list: Vec<Expr>,
    /// The pivots of the proof for the case that this one vanishes; `None` when there is no such proof.
    nested: Vec<Option<Vec<Expr>>>,
}

impl Pivots {
    /// The factors of the pivots that are not known to be ≠ 0.
    fn of(examination: &Examination<'_>, cases: &[Resolved]) -> Pivots {
        let Examination { graph, lowered, .. } = examination;
        let mut list: Vec<Expr> = Vec::new();
        for &pivot in cases.iter().flat_map(|c| &c.pivots) {
            for (base, _) in factors(graph, pivot).1 {
                if !lowered.facts.sign(graph, &lowered.generators, base).nonzero && !list.contains(&base) {
                    list.push(base);
                }
            }
        }
        let nested = vec![None; list.len()];
        Pivots { list, nested }
    }

    /// Pivots that must not vanish: all but those whose special case is proved from the remaining ones.
    fn needed(&self) -> Vec<Expr> {
        let mut needed = self.list.clone();
        let mut relied_on: Vec<Expr> = Vec::new();
        for (pivot, nested) in self.list.iter().zip(&self.nested) {
            let Some(nested) = nested else { continue };
            if !relied_on.contains(pivot) && nested.iter().all(|n| n != pivot && needed.contains(n)) {
                needed.retain(|n| n != pivot);
                relied_on.extend(nested);
            }
        }
        needed
    }
}

/// Everything that the cases of one test share.
struct Examination<'a> {
    graph: &'a mut Graph,
    probe: Probe,
    draws: Draws,
    lowered: Lowered,
    parameters: HashSet<Leaf>,
    claim: &'a [(Expr, Expr)],
    premises: &'a [(Expr, Expr)],
    given: &'a Premises,
    explicit: &'a HashMap<Leaf, Expr>,
    options: &'a Options,
    /// Real points tried for an example of something proved.
    examples: u32,
    strategy: Strategy,
}

impl Examination<'_> {
    /// The first order of solving that settles the question.
    fn generic(&mut self, premises: &[(Expr, bool)]) -> Result<(Proof, Vec<Resolved>), Stop> {
        let mut first = None;
        for strategy in Strategy::ALL {
            self.strategy = strategy;
            match self.run(premises).map_err(Stop::from).and_then(merge) {
                Err(Stop::Undecided(
                    reason @ (Reason::Unsolved(_) | Reason::NoValue | Reason::TooLarge | Reason::TooManyRoots(_)),
                )) => drop(first.get_or_insert(reason)),
                settled => return settled,
            }
        }
        Err(Stop::Undecided(first.unwrap_or(Reason::NoValue)))
    }

    /// All cases of the given lowered premises.
    fn run(&mut self, premises: &[(Expr, bool)]) -> Result<Vec<(Resolved, Outcome)>, Reason> {
        let cases = Solver {
            graph: self.graph,
            generators: &mut self.lowered.generators,
            probe: &mut self.probe,
            facts: &self.lowered.facts,
            frozen: &self.lowered.frozen,
            parameters: &self.parameters,
            strategy: self.strategy,
        }
        .solve(premises)?;
        // Room for as many cases and special cases as there may be.
        let target_log2_error = self.options.target_log2_error - 8.0;
        let each = Options { target_log2_error, ..*self.options };
        let mut out = Vec::new();
        for case in cases {
            let outcome = self.case(&case, &each);
            out.push((case, outcome));
        }
        Ok(out)
    }

    fn case(&mut self, case: &Resolved, options: &Options) -> Outcome {
        let map = closed(self.graph, &case.definitions);
        if self.clashes(&map) {
            return Outcome::Empty(Reason::Contradiction);
        }
        let question = question(self.graph, &mut self.lowered, &mut self.probe, case, &map);
        let outcome = trials(self.graph, &self.lowered.generators, &question, options, &mut self.draws);
        let mut sides = Pairs::new();
        for &(l, r) in &self.lowered.claim {
            sides.push((insert_definitions(self.graph, &map, l), insert_definitions(self.graph, &map, r)));
        }
        let scene = Scene {
            graph: self.graph,
            generators: &self.lowered.generators,
            claim: self.claim,
            lowered: &sides,
            premises: self.premises,
            nonzero: &self.given.nonzero,
            positive: &self.given.positive,
            explicit: self.explicit,
            defined: &map,
        };
        match outcome {
            Trials::Vanish(bound) => {
                let found = look(&scene, &mut self.draws, self.examples, |f| !f.is_empty());
                if let Some(f) = found.iter().find(|f| f.differs.is_some()) {
                    let sides = f.differs.map(|at| format!("{:?}", f.sides[at])).unwrap_or_default();
                    let what = format!("proved over finite fields, but at a real point: {sides}");
                    return Outcome::Open(Reason::Defect(what));
                }
                Outcome::Holds(Box::new(Proof {
                    log2_error: bound.log2_error,
                    degree_bound: bound.degree,
                    height_bound: bound.height,
                    trials: bound.primes.len(),
                    primes: bound.primes,
                    signs: bound.signs,
                    cases: 1,
                    conditions: Vec::new(),
                    example: found.into_iter().next().map(|f| f.point),
                }))
            }
            Trials::Fail { failing, of } => {
                let enough = |f: &[Found]| {
                    f.len() > 12
                        || refutation(f)
                            .is_some_and(|r| r.left.exact.is_some() && r.right.exact.is_some() && r.second.is_some())
                };
                match refutation(&look(&scene, &mut self.draws, options.attempts, enough)) {
                    Some(refutation) => Outcome::Refuted(Box::new(refutation)),
                    None => Outcome::Open(Reason::Branches { failing, of }),
                }
            }
            Trials::Contradiction => Outcome::Empty(Reason::Contradiction),
            Trials::NoValue => Outcome::Empty(Reason::NoValue),
            Trials::Unsettled(reason) => Outcome::Open(reason),
        }
    }

    /// Whether something given as positive is not, by its structure, once the definitions are inserted.
    fn clashes(&mut self, map: &HashMap<Leaf, Expr>) -> bool {
        let positive = self.lowered.facts.positive.clone();
        positive.iter().any(|&e| {
            let image = insert_definitions(self.graph, map, e);
            let mut others = self.lowered.facts.clone();
            others.positive.remove(&image);
            others.nonzero.remove(&image);
            others.sign(self.graph, &self.lowered.generators, image).not_positive
        })
    }
}

fn leaf_of(graph: &Graph, e: Expr) -> Option<Leaf> {
    match graph.node(e) {
        Node::Leaf(leaf) => Some(*leaf),
        _ => None,
    }
}

fn lower(
    graph: &mut Graph,
    premises: &[Premise],
    claim: &[(Expr, Expr)],
    (nonzero, positive): (&[Expr], &[Expr]),
    definitions: &[Expr],
) -> Result<Lowered, Reason> {
    let residuals: Vec<Expr> = premises.iter().map(|p| graph.sub(p.left, p.right)).collect();
    let mut roots: Vec<Expr> = claim.iter().flat_map(|&(l, r)| [l, r]).collect();
    roots.extend(residuals.iter().chain(nonzero).chain(positive).chain(definitions));
    let frozen = argument_leaves(graph, roots.iter().copied());
    let mut lowering = Lowering::new(graph, &roots);
    let mut images = Vec::new();
    for (&e, premise) in residuals.iter().zip(premises) {
        images.push((lowering.lower(e)?, premise.derived));
    }
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
    let mut lowered_roots: Vec<Expr> = images.iter().map(|&(e, _)| e).collect();
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
    Ok(Lowered { generators, premises: images, claim: sides, facts, denominators, assumed: not_zero, frozen })
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

/// (σ√d)² written as d.
fn without_signs(graph: &mut Graph, generators: &Generators, e: Expr) -> Expr {
    let mut image: HashMap<Expr, Expr> = HashMap::new();
    for node in graph.reachable([e]) {
        let mut new = match *graph.node(node) {
            Node::Unary(op, a) => graph.unary(op, image[&a]),
            Node::Binary(op, a, b) => graph.binary(op, image[&a], image[&b]),
            _ => node,
        };
        if let Node::Unary(Op::Powi(2), a) = *graph.node(new)
            && let Node::Binary(Op::Mul, p, q) = *graph.node(a)
        {
            for root in [p, q] {
                if let Node::Unary(Op::Sqrt, radicand) = *graph.node(root)
                    && let Some(plain) = unmarked(graph, generators, radicand)
                {
                    new = plain;
                }
            }
        }
        image.insert(node, new);
    }
    image[&e]
}

/// Conditions that are not among the facts, in words of the formulas as given.
fn conditions(
    graph: &mut Graph,
    lowered: &Lowered,
    given: &Premises,
    cases: &[Resolved],
    formulas: &[Expr],
    explicit: &[Expr],
    pivots: &[Expr],
) -> Vec<Condition> {
    let generators = &lowered.generators;
    let raise = |graph: &mut Graph, e: Expr| {
        let e = without_signs(graph, generators, e);
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
    let mut from_cases: Vec<Condition> = pivots.iter().map(|&e| Condition::Pivot(e)).collect();
    for case in cases {
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
    out.extend(explicit.iter().map(|&e| Condition::Pivot(e)));
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
