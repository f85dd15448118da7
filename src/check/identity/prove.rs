//! The procedure: premises prepared, lowered and solved; every case tested over finite fields and at real points.

use super::absolute::AbsoluteValues;
use super::conditions::{conditions, raised};
use super::field::{Bound, Question, Trials, sum_log2, trials};
use super::lower::{Generator, Generators, Lowering, TooLarge};
use super::memory::{Asked, Memory};
use super::orthogonal::{Orthogonal, orthogonal};
use super::outcome::{Condition, Identity, Options, Premises, Proof, Reason, Refutation};
use super::polynomial::factors;
use super::prepare::{Premise, argument_leaves, explicit, with_rates};
use super::probe::Probe;
use super::roots::Roots;
use super::sign::Facts;
use super::solve::{Failed, Resolved, Solver, Strategy, closed, insert_definitions};
use super::witness::{Found, Scene, refutation, targets, vanishing};
use crate::expr::{Expr, Graph, Leaf, Node, Op};
use crate::expr::{FastMap, FastSet};
use crate::number::Draws;

type Pairs = Vec<(Expr, Expr)>;

/// The problem after lowering.
pub(super) struct Lowered {
    pub(super) generators: Generators,
    /// Residuals of the premises that are not definitions, and whether they are derivatives of others.
    pub(super) premises: Vec<(Expr, bool)>,
    pub(super) claim: Pairs,
    pub(super) facts: Facts,
    /// The same without what only the formulas' having a value implies.
    pub(super) given_facts: Facts,
    pub(super) denominators: Vec<Expr>,
    /// Given as ≠ 0.
    pub(super) assumed: Vec<Expr>,
    frozen: FastSet<Leaf>,
    /// Orthogonal matrices among the premises.
    orthogonal: Orthogonal,
}

/// Whether the equations hold wherever the premises do and both sides have a value.
///
/// See the [module](self::super) for the procedure, the theorem behind the bound, and what is not decided.
///
/// `given` may name derivatives by time; definitions among it are inserted. The graph gets new nodes and, once, one hidden
/// symbol.
pub fn identity_test(graph: &mut Graph, equations: &[(Expr, Expr)], given: &Premises, options: &Options) -> Identity {
    identity_test_after(&mut Memory::default(), graph, equations, given, options)
}

/// The same, after other questions about the same graph.
pub(in crate::check) fn identity_test_after(
    memory: &mut Memory,
    graph: &mut Graph,
    equations: &[(Expr, Expr)],
    given: &Premises,
    options: &Options,
) -> Identity {
    match decide(memory, graph, equations, given, options) {
        Ok(proof) => Identity::Proved(proof),
        Err(Stop::Refuted(refutation)) => Identity::Refuted(refutation),
        Err(Stop::Undecided(reason) | Stop::Empty(reason, _)) => Identity::Undecided(reason),
    }
}

/// The answer for a family of branches: a formula with ±, one list of equations for each choice.
#[derive(Clone, Debug, PartialEq)]
pub struct Branches {
    /// For each branch: whether it holds by itself, at every point.
    pub throughout: Vec<Identity>,
    /// Whether at every point some branch holds (which one may change from point to point).
    pub pointwise: Identity,
}

/// Tests a family of branches, as a whole and each by itself.
///
/// "Some branch at each point" is one identity: of the residuals f of the branches, ∏ f = 0; for systems, every product that
/// takes one residual of each branch.
pub fn branches_test(
    graph: &mut Graph,
    branches: &[Vec<(Expr, Expr)>],
    given: &Premises,
    options: &Options,
) -> Branches {
    branches_test_after(&mut Memory::default(), graph, branches, given, options)
}

/// The same, after other questions about the same graph.
pub(in crate::check) fn branches_test_after(
    memory: &mut Memory,
    graph: &mut Graph,
    branches: &[Vec<(Expr, Expr)>],
    given: &Premises,
    options: &Options,
) -> Branches {
    let throughout = branches.iter().map(|b| identity_test_after(memory, graph, b, given, options)).collect();
    let zero = graph.integer(0);
    let mut products = vec![graph.integer(1)];
    for branch in branches {
        let mut next = Vec::new();
        for &p in &products {
            for &(l, r) in branch {
                let residual = graph.sub(l, r);
                next.push(graph.mul(p, residual));
            }
        }
        if next.len() > 256 {
            return Branches { throughout, pointwise: Identity::Undecided(Reason::TooLarge) };
        }
        products = next;
    }
    let equations: Pairs = products.into_iter().map(|p| (p, zero)).collect();
    Branches { throughout, pointwise: identity_test_after(memory, graph, &equations, given, options) }
}

impl From<TooLarge> for Reason {
    fn from(_: TooLarge) -> Reason {
        Reason::TooLarge
    }
}

impl From<Failed> for Reason {
    fn from(failed: Failed) -> Reason {
        match failed {
            Failed::Degenerate => Reason::Degenerate,
            Failed::TooManyCases => Reason::TooLarge,
        }
    }
}

fn decide(
    memory: &mut Memory,
    graph: &mut Graph,
    equations: &[(Expr, Expr)],
    given: &Premises,
    options: &Options,
) -> Result<Proof, Stop> {
    let mut draws = Draws::new(options.seed);
    let premises = with_rates(graph, given, equations)?;
    let solved = explicit(graph, &premises, equations, given);
    let premises: Pairs = premises.iter().map(|p| (p.left, p.right)).collect();
    let insert = |graph: &mut Graph, e: Expr| insert_definitions(graph, &solved.definitions, e);
    let claim: Pairs = equations.iter().map(|&(l, r)| (insert(graph, l), insert(graph, r))).collect();
    let nonzero: Vec<Expr> = given.nonzero.iter().map(|&e| insert(graph, e)).collect();
    let positive: Vec<Expr> = given.positive.iter().map(|&e| insert(graph, e)).collect();
    let not_negative: Vec<Expr> = given.not_negative.iter().map(|&e| insert(graph, e)).collect();
    let definitions: Vec<Expr> = solved.definitions.values().copied().collect();
    let facts = [nonzero.as_slice(), &positive, &not_negative];
    let mut lowered = lower(graph, &solved.rest, &claim, facts, &definitions, true)?;
    let asked = Asked::new(&lowered, options.most_nodes);
    if let Some(reason) = memory.why_open(&asked) {
        return Err(reason.into());
    }
    let probe = Probe::new(&mut draws);
    let parameters: FastSet<Leaf> =
        given.parameters.iter().copied().chain(given.positive.iter().filter_map(|&e| leaf_of(graph, e))).collect();
    lowered.frozen.extend(given.time);
    let limit = graph.len() + options.most_nodes;
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
        seeded: true,
        limit,
    };
    let own = examination.lowered.premises.clone();
    let (mut proof, resolved) = examination.generic(&own).inspect_err(|stop| {
        if let Stop::Undecided(reason) = stop {
            memory.keep(asked, reason);
        }
    })?;
    // Where a pivot vanishes, the premises may leave more open: looked at by themselves.
    let mut pivots = Pivots::of(&examination, &resolved);
    let limit = examination.graph.len() + MOST_SPECIAL_NODES;
    examination.examples = if proof.example.is_some() { 6 } else { options.attempts };
    for at in 0..pivots.list.len().min(options.special_cases as usize) {
        if !is_simple(examination.graph, pivots.list[at]) || examination.graph.len() > limit {
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
            Err(Stop::Empty(Reason::Contradiction, cases)) => {
                pivots.nested[at] = Some(Pivots::of(&examination, &cases).list);
            }
            Err(Stop::Undecided(defect @ Reason::Defect(_))) => return Err(defect.into()),
            Err(Stop::Undecided(_) | Stop::Empty(..)) => {}
        }
    }
    if proof.log2_error > options.target_log2_error {
        return Err(Reason::Bound(proof.log2_error).into());
    }
    let needed = pivots.needed();
    let Examination { graph, lowered, .. } = examination;
    let mut all: Vec<Expr> = equations.iter().chain(&premises).flat_map(|&(l, r)| [l, r]).collect();
    all.dedup();
    proof.conditions = conditions(graph, &lowered, given, &resolved, &all, &solved.pivots, &needed);
    // An example is one only if it is reached: nothing vanishes there that was divided by.
    let divided = proof.conditions.iter().filter_map(|c| match *c {
        Condition::Pivot(e) => Some(e),
        _ => None,
    });
    let divided: Vec<Expr> = divided.collect();
    proof.example = proof.example.take().filter(|point| vanishing(graph, &divided, point).is_none());
    Ok(proof)
}

/// Special cases are given up when they have made this many nodes: their pivots stay conditions.
const MOST_SPECIAL_NODES: usize = 2000;

/// Signs by which one case is taken apart.
const MOST_SIGNS_SPLIT: usize = 3;

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
    /// The premises rule the case out, or it was not reached.
    Empty(Reason),
    /// Some formula has no value wherever the premises hold.
    Void(Bound),
}

/// Why a list of cases does not amount to a proof.
enum Stop {
    Refuted(Box<Refutation>),
    /// No case is possible, where the pivots of these are not 0.
    Empty(Reason, Vec<Resolved>),
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
    let (mut open, mut resolved) = (None, Vec::new());
    let (mut void, mut empty): (Option<Bound>, Option<Reason>) = (None, None);
    for (mut case, outcome) in outcomes {
        match outcome {
            Outcome::Refuted(refutation) => return Err(Stop::Refuted(refutation)),
            Outcome::Open(reason) => drop(open.get_or_insert(reason)),
            Outcome::Empty(reason) => {
                // Only where all cases contradict themselves the premises do.
                let weight = |r: &Reason| match r {
                    Reason::Contradiction => 0,
                    Reason::NoValue => 1,
                    _ => 2,
                };
                if empty.as_ref().is_none_or(|e| weight(e) < weight(&reason)) {
                    empty = Some(reason);
                }
                case.empty = true;
                resolved.push(case);
            }
            Outcome::Void(bound) => {
                case.empty = true;
                resolved.push(case);
                match &mut void {
                    None => void = Some(bound),
                    Some(all) => all.absorb(bound),
                }
            }
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
        (None, Some(mut proof)) => {
            if let Some(bound) = void {
                proof.log2_error = sum_log2(proof.log2_error, bound.log2_error);
                proof.degree_bound = proof.degree_bound.max(bound.degree);
                proof.height_bound = proof.height_bound.max(bound.height);
                proof.primes.extend(bound.primes);
            }
            Ok((proof, resolved))
        }
        (None, None) => {
            let reason = match (empty, void) {
                (Some(Reason::Degenerate), _) => Reason::Degenerate,
                (_, Some(_)) => Reason::NoValue,
                (empty, None) => empty.unwrap_or(Reason::Contradiction),
            };
            Err(Stop::Empty(reason, resolved))
        }
    }
}

impl Proof {
    /// Both proofs together.
    pub(in crate::check) fn absorb(&mut self, other: Proof) {
        self.log2_error = sum_log2(self.log2_error, other.log2_error);
        self.degree_bound = self.degree_bound.max(other.degree_bound);
        self.height_bound = self.height_bound.max(other.height_bound);
        self.trials = self.trials.max(other.trials);
        self.primes.extend(other.primes);
        self.signs = self.signs.max(other.signs);
        self.cases += other.cases;
        for condition in other.conditions {
            if !self.conditions.contains(&condition) {
                self.conditions.push(condition);
            }
        }
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
        let claim = lowered.claim.iter().flat_map(|&(l, r)| [l, r]);
        let roots: Vec<Expr> = claim.chain(lowered.assumed.iter().copied()).collect();
        for pivot in cases.iter().flat_map(|c| c.pivots_for(graph, roots.iter().copied())) {
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
    parameters: FastSet<Leaf>,
    claim: &'a [(Expr, Expr)],
    premises: &'a [(Expr, Expr)],
    given: &'a Premises,
    explicit: &'a FastMap<Leaf, Expr>,
    options: &'a Options,
    /// Real points tried for an example of something proved.
    examples: u32,
    strategy: Strategy,
    /// Whether orthogonal matrices are parametrised.
    seeded: bool,
    /// The size of the graph at which solving is given up.
    limit: usize,
}

impl Examination<'_> {
    /// The first order of solving that settles the question.
    fn generic(&mut self, premises: &[(Expr, bool)]) -> Result<(Proof, Vec<Resolved>), Stop> {
        let mut first = None;
        let matrices = !self.lowered.orthogonal.definitions.is_empty();
        for (seeded, strategy) in Strategy::ALL.map(|s| (true, s)).into_iter().chain(Strategy::ALL.map(|s| (false, s)))
        {
            if !seeded && !matrices {
                break;
            }
            (self.strategy, self.seeded) = (strategy, seeded);
            match self.run(premises).map_err(Stop::from).and_then(merge).map_err(|s| self.emptiness(premises, s)) {
                Err(Stop::Undecided(reason)) if reason.is_about_solving() => drop(first.get_or_insert(reason)),
                Err(Stop::Undecided(reason @ Reason::Branches { .. })) if matrices && seeded => {
                    first.get_or_insert(reason);
                }
                settled => return settled,
            }
        }
        Err(Stop::Undecided(first.unwrap_or(Reason::Degenerate)))
    }

    /// A contradiction is one only if the premises cannot hold where a pivot vanishes, either.
    fn emptiness(&mut self, premises: &[(Expr, bool)], stop: Stop) -> Stop {
        let Stop::Empty(mut reason, cases) = stop else { return stop };
        let is_empty = |r: &Reason| matches!(r, Reason::Contradiction | Reason::NoValue);
        if !is_empty(&reason) {
            return Stop::Undecided(reason);
        }
        let mut open = None;
        for pivot in Pivots::of(self, &cases).list {
            let mut special = vec![(pivot, false)];
            special.extend(premises);
            match self.run(&special).map_err(Stop::from).and_then(merge) {
                // A point that satisfies all premises refutes, wherever it was found.
                Err(refuted @ Stop::Refuted(_)) => return refuted,
                Err(Stop::Empty(special, cases)) if is_empty(&special) && Pivots::of(self, &cases).list.is_empty() => {
                    if special == Reason::NoValue {
                        reason = special;
                    }
                }
                _ => drop(open.get_or_insert(pivot)),
            }
        }
        if let Some(pivot) = open {
            return Stop::Undecided(Reason::OnlyWhere(raised(self.graph, &self.lowered.generators, pivot)));
        }
        Stop::Undecided(match self.boundary() {
            Some(base) if reason == Reason::Contradiction => Reason::Boundary(base),
            _ => reason,
        })
    }

    /// The base of a power in the premises that is not known to be positive: where it is 0, the power has a value, and is
    /// not what it was taken for.
    fn boundary(&mut self) -> Option<Expr> {
        let mut facts = Facts::default();
        self.given.positive.iter().for_each(|&e| facts.note_positive(self.graph, e));
        let roots = self.premises.iter().flat_map(|&(l, r)| [l, r]);
        let bases = self.graph.reachable(roots).into_iter().filter_map(|e| match *self.graph.node(e) {
            Node::Binary(Op::Pow, a, _) => Some(a),
            _ => None,
        });
        let bases: Vec<Expr> = bases.collect();
        bases.into_iter().find(|&a| {
            let known = facts.sign(self.graph, &self.lowered.generators, a);
            !(known.not_negative && known.nonzero)
        })
    }

    /// All cases of the given lowered premises.
    fn run(&mut self, premises: &[(Expr, bool)]) -> Result<Vec<(Resolved, Outcome)>, Reason> {
        let seeds: &[(Leaf, Expr)] = if self.seeded { &self.lowered.orthogonal.definitions } else { &[] };
        let cases = Solver {
            graph: self.graph,
            generators: &mut self.lowered.generators,
            probe: &mut self.probe,
            facts: &self.lowered.facts,
            given_facts: &self.lowered.given_facts,
            frozen: &self.lowered.frozen,
            parameters: &self.parameters,
            strategy: self.strategy,
            limit: self.limit,
        }
        .solve(premises, seeds)?;
        // Room for as many cases and special cases as there may be.
        let target_log2_error = self.options.target_log2_error - 8.0;
        let each = Options { target_log2_error, ..*self.options };
        let mut out = Vec::new();
        for case in cases {
            let outcome = match case.empty {
                true if case.no_value => Outcome::Empty(Reason::NoValue),
                true => Outcome::Empty(Reason::Contradiction),
                false => self.case(&case, &each),
            };
            out.push((case, outcome));
        }
        Ok(out)
    }

    fn case(&mut self, case: &Resolved, options: &Options) -> Outcome {
        let map = closed(self.graph, &case.definitions);
        if self.clashes(&map) {
            return Outcome::Empty(Reason::Contradiction);
        }
        let claim = self.lowered.claim.clone();
        let residuals: Vec<Expr> = match case.void {
            // That it divides by 0 is tested like a claim.
            Some(denominator) => vec![denominator],
            None => claim.iter().map(|&(l, r)| self.graph.sub(l, r)).collect(),
        };
        let mut outcome = self.trials(case, &map, residuals.clone(), options, false);
        if case.void.is_some() {
            return match outcome {
                Trials::Vanish(bound) => Outcome::Void(bound),
                Trials::Contradiction => Outcome::Empty(Reason::Contradiction),
                _ => Outcome::Empty(Reason::Degenerate),
            };
        }
        if outcome == Trials::NoValue {
            outcome = self.trials(case, &map, residuals, options, true);
        }
        let mut sides = Pairs::new();
        for &(l, r) in &self.lowered.claim {
            sides.push((insert_definitions(self.graph, &map, l), insert_definitions(self.graph, &map, r)));
        }
        let scene = Scene {
            targets: targets(self.graph, &self.lowered.generators, &map),
            graph: self.graph,
            generators: &self.lowered.generators,
            claim: self.claim,
            lowered: &sides,
            premises: self.premises,
            nonzero: &self.given.nonzero,
            positive: &self.given.positive,
            not_negative: &self.given.not_negative,
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
                // An exact point is looked for beyond the first that refutes, for a while.
                let enough = |f: &[Found]| {
                    refutation(f).is_some_and(|r| {
                        f.len() > 12 || r.left.exact.is_some() && r.right.exact.is_some() && r.second.is_some()
                    })
                };
                match refutation(&look(&scene, &mut self.draws, options.attempts, enough)) {
                    Some(refutation) => Outcome::Refuted(Box::new(refutation)),
                    None => {
                        let split = if failing < of { self.split_by_sign(case, options) } else { None };
                        split.unwrap_or(Outcome::Open(Reason::Branches { failing, of }))
                    }
                }
            }
            Trials::Contradiction => Outcome::Empty(Reason::Contradiction),
            Trials::Void(bound) => Outcome::Void(bound),
            Trials::NoValue => Outcome::Empty(Reason::Degenerate),
            Trials::Unsettled(reason) => Outcome::Open(reason),
        }
    }

    /// A case that fails for some choice of signs, and at no real point, taken apart by the first sign in its definitions:
    /// what is given may exclude one of the two. `None` where that does not settle it.
    fn split_by_sign(&mut self, case: &Resolved, options: &Options) -> Option<Outcome> {
        let values: Vec<Expr> = case.definitions.iter().map(|&(_, e)| e).collect();
        let defined = |l: &Leaf| case.definitions.iter().any(|(d, _)| d == l);
        let generators = &self.lowered.generators;
        let is_sign = |l: &Leaf| generators.get(*l) == Some(&Generator::Sign) && !defined(l);
        let split = case.definitions.iter().filter(|(l, _)| generators.get(*l) == Some(&Generator::Sign)).count();
        let leaf = self.graph.leaves(values).into_iter().find(is_sign).filter(|_| split < MOST_SIGNS_SPLIT)?;
        let mut outcomes = Vec::new();
        for value in [1, -1] {
            let mut one = case.clone();
            one.define_sign(leaf, self.graph.integer(value));
            let outcome = self.case(&one, options);
            if let Outcome::Open(_) = outcome {
                return None;
            }
            outcomes.push((one, outcome));
        }
        match merge(outcomes) {
            Ok((proof, _)) => Some(Outcome::Holds(Box::new(proof))),
            Err(Stop::Refuted(refutation)) => Some(Outcome::Refuted(refutation)),
            Err(Stop::Empty(reason, _)) => Some(Outcome::Empty(reason)),
            Err(Stop::Undecided(_)) => None,
        }
    }

    /// The trials of one case; `with_pivots`, choices of signs without a value are left out, where that can be told.
    fn trials(
        &mut self,
        case: &Resolved,
        map: &FastMap<Leaf, Expr>,
        residuals: Vec<Expr>,
        options: &Options,
        with_pivots: bool,
    ) -> Trials {
        let question = question(self.graph, &mut self.lowered, &mut self.probe, (case, map), residuals, with_pivots);
        trials(self.graph, &self.lowered.generators, &question, options, &mut self.draws)
    }

    /// Whether something given as positive is not, by its structure, once the definitions are inserted.
    fn clashes(&mut self, map: &FastMap<Leaf, Expr>) -> bool {
        let Facts { positive, not_negative, .. } = self.lowered.given_facts.clone();
        let mut facts: Vec<(Expr, bool)> = positive.into_iter().map(|e| (e, true)).collect();
        facts.extend(not_negative.into_iter().map(|e| (e, false)));
        facts.sort_unstable();
        facts.into_iter().any(|(e, strict)| {
            let image = insert_definitions(self.graph, map, e);
            let mut others = self.lowered.facts.clone();
            others.positive.remove(&image);
            others.not_negative.remove(&image);
            others.nonzero.remove(&image);
            let known = others.sign(self.graph, &self.lowered.generators, image);
            known.not_positive && (strict || known.nonzero)
        })
    }
}

fn leaf_of(graph: &Graph, e: Expr) -> Option<Leaf> {
    match graph.node(e) {
        Node::Leaf(leaf) => Some(*leaf),
        _ => None,
    }
}

/// Premises and claim, definitions inserted, without transcendental functions; `with_signs`, absolute values in premises become
/// [`AbsoluteValues`].
pub(super) fn lower(
    graph: &mut Graph,
    premises: &[Premise],
    claim: &[(Expr, Expr)],
    [nonzero, positive, not_negative]: [&[Expr]; 3],
    definitions: &[Expr],
    with_signs: bool,
) -> Result<Lowered, Reason> {
    let residuals: Vec<Expr> = premises.iter().map(|p| graph.sub(p.left, p.right)).collect();
    let mut roots: Vec<Expr> = claim.iter().flat_map(|&(l, r)| [l, r]).collect();
    roots.extend(residuals.iter().chain(nonzero).chain(positive).chain(not_negative).chain(definitions));
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
        facts.note_positive(lowering.graph, image);
    }
    for &e in not_negative {
        let image = lowering.lower(e)?;
        facts.note_not_negative(lowering.graph, image);
    }
    let mut not_zero = Vec::new();
    for &e in nonzero {
        not_zero.push(lowering.lower(e)?);
    }
    // Nor are their radicands negative.
    let formulas: Vec<Expr> = premises.iter().flat_map(|p| [p.left, p.right]).collect();
    for node in lowering.graph.reachable(formulas) {
        if let Node::Unary(Op::Sqrt, a) = *lowering.graph.node(node) {
            let image = lowering.lower(a)?;
            facts.note_not_negative(lowering.graph, image);
        }
    }
    let mut of_definitions = Vec::new();
    for &e in definitions {
        of_definitions.push(lowering.lower(e)?);
    }
    let (graph, mut generators) = (&mut *lowering.graph, lowering.generators);
    let premises: Vec<Expr> = images.iter().filter(|_| with_signs).map(|&(e, _)| e).collect();
    let mut absolute = AbsoluteValues::of(graph, &mut generators, &mut facts, &premises)?;
    let mut put = |e: &mut Expr| *e = absolute.put_into(graph, *e);
    images.iter_mut().for_each(|(e, _)| put(e));
    sides.iter_mut().for_each(|(l, r)| [l, r].into_iter().for_each(&mut put));
    not_zero.iter_mut().chain(&mut of_definitions).for_each(&mut put);
    // Formulas are claimed where they have a value, so their denominators are not 0 there.
    let mut lowered_roots: Vec<Expr> = images.iter().map(|&(e, _)| e).collect();
    lowered_roots.extend(sides.iter().flat_map(|&(l, r)| [l, r]));
    lowered_roots.extend(&of_definitions);
    let mut denominators = Vec::new();
    for node in graph.reachable(lowered_roots) {
        match *graph.node(node) {
            Node::Binary(Op::Div, _, b) => denominators.push(b),
            Node::Unary(Op::Powi(n), a) if n < 0 => denominators.push(a),
            _ => {}
        }
    }
    denominators.retain(|&e| graph.as_constant(e).is_none());
    let note = |facts: &mut Facts, e: Expr| {
        facts.nonzero.insert(e);
        facts.nonzero.extend(factors(graph, e).1.into_iter().map(|(base, _)| base));
    };
    not_zero.iter().for_each(|&e| note(&mut facts, e));
    let mut given_facts = facts.clone();
    denominators.iter().for_each(|&e| note(&mut facts, e));
    // What still stands in arguments after lowering must stay free.
    let arguments: Vec<Expr> = generators.list.iter().filter_map(Generator::argument).collect();
    let frozen = argument_leaves(graph, arguments.iter().copied()).into_iter().chain(graph.leaves(arguments)).collect();
    let given: Vec<Expr> = images.iter().filter(|(_, derived)| !derived).map(|&(e, _)| e).collect();
    let all = images.iter().map(|&(e, _)| e).chain(sides.iter().flat_map(|&(l, r)| [l, r]));
    let occurring = graph.leaves(all);
    let orthogonal = orthogonal(graph, &mut generators, &given, &occurring);
    facts.positive.extend(orthogonal.norms.iter().copied());
    given_facts.positive.extend(orthogonal.norms.iter().copied());
    Ok(Lowered {
        given_facts,
        orthogonal,
        generators,
        premises: images,
        claim: sides,
        facts,
        denominators,
        assumed: not_zero,
        frozen,
    })
}

/// What is asked of the field for one case: everything with the case's definitions, in normal form, circles parametrised.
fn question(
    graph: &mut Graph,
    lowered: &mut Lowered,
    probe: &mut Probe,
    (case, map): (&Resolved, &FastMap<Leaf, Expr>),
    residuals: Vec<Expr>,
    with_pivots: bool,
) -> Question {
    let inserted = |graph: &mut Graph, list: &[Expr]| -> Vec<Expr> {
        list.iter().map(|&e| insert_definitions(graph, map, e)).collect()
    };
    let pivots = with_pivots.then(|| {
        let roots: Vec<Expr> = residuals.iter().chain(&lowered.assumed).chain(&lowered.denominators).copied().collect();
        let pivots = case.pivots_for(graph, roots);
        inserted(graph, &pivots)
    });
    let residuals = inserted(graph, &residuals);
    let filters = inserted(graph, &case.unsolved);
    let mut zeros = inserted(graph, &case.taken_as_zero);
    let mut assumed = inserted(graph, &lowered.assumed);
    let mut nonzeros = inserted(graph, &lowered.denominators);
    let mut facts = lowered.facts.clone();
    for set in [&mut facts.positive, &mut facts.not_negative, &mut facts.not_positive, &mut facts.nonzero] {
        let mut list: Vec<Expr> = set.iter().copied().collect();
        list.sort_unstable();
        set.extend(inserted(graph, &list));
    }
    let mut all = residuals.clone();
    all.extend(filters.iter().chain(&zeros).chain(&assumed).chain(&nonzeros).chain(pivots.iter().flatten()));
    let mut roots = Roots::new(graph, &mut lowered.generators, probe, facts);
    roots.prepare(&all);
    let mut normal = |list: Vec<Expr>| -> Vec<Expr> { list.into_iter().map(|e| roots.normal(e)).collect() };
    let (residuals, filters) = (normal(residuals), normal(filters));
    zeros = normal(zeros);
    assumed = normal(assumed);
    nonzeros = normal(nonzeros);
    let pivots = pivots.map(normal);
    let taken = std::mem::take(&mut roots.taken_as_zero);
    zeros.extend(taken.into_iter().map(|e| roots.normal(e)).collect::<Vec<_>>());
    let mut out = Question { residuals, filters, zeros, assumed, nonzeros, pivots };
    parametrise(graph, &mut lowered.generators, &mut out);
    out
}

/// c = (1 − t²)/(1 + t²), s = 2t/(1 + t²) for every pair that is not solved for.
fn parametrise(graph: &mut Graph, generators: &mut Generators, question: &mut Question) {
    let Question { residuals, filters, zeros, assumed, nonzeros, pivots } = question;
    let lists: Vec<&mut Vec<Expr>> =
        [residuals, filters, zeros, assumed, nonzeros].into_iter().chain(pivots).collect();
    let leaves = graph.leaves(lists.iter().flat_map(|l| l.iter().copied()));
    let mut map: FastMap<Leaf, Expr> = FastMap::default();
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
        for e in list {
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
