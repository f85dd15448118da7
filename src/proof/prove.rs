//! The procedure: premises prepared, lowered and solved; every case tested over finite fields and at real points.

mod cases;
mod one_case;

use super::apart::by_domain;
use super::conditions::{conditions, raised};
use super::generators::TooLarge;
use super::insertion::Insertion;
use super::memory::{Asked, Memory};
use super::newton::{Example, example};
use super::outcome::{Identity, Options, Premises, Proof, Reason, Wanted};
use super::prepare::{Premise, Solutions, explicit, with_rates};
use super::probe::Probe;
use super::rates::mark_partial;
use super::relate::{FEW_POINTS, settle};
use super::sign::Facts;
use super::solve::{Failed, Resolved, Solver, Strategy};
use super::witness::vanishing;
use cases::{Outcome, Pivots, Stop, merge};
use expr::domain::Sign;
use expr::{Expr, Graph, Leaf, Node, Op, Rational};
use expr::{FastMap, FastSet};

pub(super) use super::lowering::{Lowered, lower};
use number::Draws;
use std::cell::Cell;
use std::rc::Rc;

type Pairs = Vec<(Expr, Expr)>;

/// Orders of derivatives beyond what is asked for in which hidden constraints are looked for.
pub(super) const MOST_FURTHER: u8 = 5;

/// Whether the equations hold wherever the premises do and both sides have a value.
///
/// See the [module](self::super) for the procedure, the theorem behind the bound, and what is not decided.
///
/// `given` may name derivatives by time; definitions among it are inserted. The graph gets new nodes and, once, one hidden
/// symbol.
pub fn identity_test(graph: &mut Graph, equations: &[(Expr, Expr)], given: &Premises, options: &Options) -> Identity {
    identity_test_after(&mut Memory::default(), graph, equations, given, options)
}

/// The premises with what must be so where the places and the fixed times that are named have values; nothing where these always have one.
pub fn with_values_of_places(graph: &mut Graph, equations: &[(Expr, Expr)], given: &Premises) -> Option<Premises> {
    let sides = equations.iter().flat_map(|&(l, r)| [l, r]).chain(given.sides()).chain(given.signs());
    let placed = graph.placed_below(sides.collect::<Vec<_>>());
    if placed.is_empty() {
        return None;
    }
    let mut out = given.clone();
    for need in graph.needs_below(placed) {
        // What divides where nearly all places are is of no place.
        let is_of_places = graph.leaves_within([need.value]).into_iter().any(|leaf| graph.coordinate(leaf).is_some());
        let signs = match need.sign {
            Sign::NotZero if is_of_places => continue,
            Sign::NotZero => &mut out.nonzero,
            Sign::Positive => &mut out.positive,
            Sign::NotNegative => &mut out.not_negative,
        };
        if !signs.contains(&need.value) {
            signs.push(need.value);
        }
    }
    Some(out)
}

/// The same, after other questions about the same graph.
pub fn identity_test_after(
    memory: &mut Memory,
    graph: &mut Graph,
    equations: &[(Expr, Expr)],
    given: &Premises,
    options: &Options,
) -> Identity {
    let with_places = with_values_of_places(graph, equations, given);
    let given = with_places.as_ref().unwrap_or(given);
    let together = identity_at(memory, graph, equations, given, options, 0);
    if matches!(together, Identity::Refuted(_)) {
        return together;
    }
    // One may fail where another has no value.
    let groups = by_domain(graph, equations, given);
    let mut out = together;
    for group in groups.iter().filter(|_| groups.len() > 1) {
        let own: Pairs = group.iter().map(|&number| equations[number]).collect();
        match (identity_at(memory, graph, &own, given, options, 0), &mut out) {
            (Identity::Refuted(mut refutation), _) => {
                refutation.equation = group[refutation.equation];
                return Identity::Refuted(refutation);
            }
            (Identity::Proved(proof), Identity::Proved(all)) => {
                // A point at which one of them has a value is none at which all have.
                let example = all.example.take();
                all.absorb(proof);
                all.example = example;
            }
            (open @ Identity::Undecided(_), Identity::Proved(_)) => out = open,
            (Identity::Proved(_) | Identity::Undecided(_), _) => {}
        }
    }
    out
}

/// The counted work of a question beside that of its terms: what is given is put in order.
const OF_A_QUESTION: u64 = 60_000;

/// The same, for a question that another one led to: `depth` counts them.
pub(super) fn identity_at(
    memory: &mut Memory,
    graph: &mut Graph,
    equations: &[(Expr, Expr)],
    given: &Premises,
    options: &Options,
    depth: u32,
) -> Identity {
    if !memory.may_ask(depth, graph.len()) {
        return Identity::Undecided(Reason::TooLarge);
    }
    meter::charge(OF_A_QUESTION);
    let mut decided = decide(memory, graph, equations, given, options, 0);
    for further in 1..=MOST_FURTHER {
        // A point was found, but perhaps no motion passes through it.
        if options.wanted != Wanted::Answer || !matches!(decided, Err(Stop::Undecided(Reason::Unextended))) {
            break;
        }
        match decide(memory, graph, equations, given, options, further) {
            Err(Stop::Undecided(reason)) if reason != Reason::Unextended => break,
            again => decided = again,
        }
    }
    match decided {
        Ok(proof) => Identity::Proved(proof),
        Err(Stop::Refuted(mut refutation)) => {
            let sides = equations.get(refutation.equation).map(|&(l, r)| [l, r]);
            refutation.named = graph.leaves(sides.into_iter().flatten());
            Identity::Refuted(refutation)
        }
        Err(Stop::Undecided(reason) | Stop::Empty(reason, _)) => {
            let settled = settle(memory, graph, equations, given, (options, depth), &reason);
            settled.unwrap_or(Identity::Undecided(reason))
        }
    }
}

/// Whether no motion, and no field, satisfies what is given: it contradicts itself, perhaps only in its derivatives. That x = 5 + t and
/// x = 5 is so at one time, and on no interval.
///
/// Derivatives of higher order come first: a point over a finite field at which all of these hold satisfies those of lower order, too,
/// and nothing contradicts them.
pub fn excludes_motions(memory: &mut Memory, graph: &mut Graph, given: &Premises) -> bool {
    let nothing = [(graph.integer(0), graph.integer(1))];
    let options = Options { attempts: 0, special_cases: 4, wanted: Wanted::Fault, ..Options::default() };
    let mut further = MOST_TRIED;
    loop {
        match decide(memory, graph, &nothing, given, &options, further) {
            Err(Stop::Undecided(Reason::Contradiction) | Stop::Empty(Reason::Contradiction, _)) => return true,
            Err(Stop::Undecided(Reason::OnlyWhere(e)) | Stop::Empty(Reason::OnlyWhere(e), _))
                if are_single_times(graph, e, given) =>
            {
                return true;
            }
            Err(Stop::Undecided(Reason::Branches { .. })) => return false,
            // No further derivative tells more.
            Err(Stop::Undecided(Reason::Unextended)) if further > 0 => further = 0,
            _ if further == 0 => return false,
            _ => further -= 1,
        }
    }
}

/// Whether something vanishes at single times alone, and what is given is so on intervals: an analytic function of the time that is not 0
/// at some time.
fn are_single_times(graph: &mut Graph, e: Expr, given: &Premises) -> bool {
    let Some(time) = given.time else { return false };
    if graph.leaves_within([e]) != [time] || !graph.is_analytic_in(e, time) {
        return false;
    }
    let is_lasting = given.equations.iter().all(|k| k.when.is_on_intervals());
    // What is given has values at all times.
    if !is_lasting || !graph.needs_below(given.sides()).is_empty() {
        return false;
    }
    let mut at = |n: i64| {
        let n = graph.integer(n);
        let there = graph.substitute(e, |_, leaf| (leaf == time).then_some(n));
        graph.as_constant(there).is_some_and(|value| *value != Rational::ZERO)
    };
    at(2) || at(3)
}

/// Orders of derivatives in which contradictions of what is given are looked for.
const MOST_TRIED: u8 = 2;

/// Whether an expression is 0 wherever it has a value, by premises that need not be solved.
pub(super) fn vanishes(graph: &mut Graph, e: Expr, given: &Premises) -> bool {
    let zero = graph.integer(0);
    let options = Options { attempts: 0, special_cases: 0, ..Options::default() };
    match identity_test(graph, &[(e, zero)], given, &options) {
        Identity::Proved(proof) => proof.conditions.iter().all(|c| c.leaves_out().is_none()),
        Identity::Refuted(_) | Identity::Undecided(_) => false,
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
    further: u8,
) -> Result<Proof, Stop> {
    let (mut premises, solutions) = with_rates(graph, given, equations, vanishes, further)?;
    if further > 0 && !solutions.may_hide_constraints() {
        return Err(Reason::Unextended.into());
    }
    let partial = mark_partial(graph, equations, &mut premises, given);
    if partial.is_empty() {
        return decide_with(memory, graph, equations, (given, premises, &solutions, &[]), options);
    }
    // Perhaps the rates that may have no value are not needed.
    let whole: Vec<Premise> = premises.iter().filter(|p| !p.partial).copied().collect();
    let without = Options { wanted: Wanted::Proof, ..*options };
    let left_out = |proof: &Proof| proof.conditions.iter().filter(|c| c.leaves_out().is_some()).count();
    let mut before: Option<Proof> = None;
    match decide_with(memory, graph, equations, (given, whole, &solutions, &[]), &without) {
        Ok(proof) if left_out(&proof) > 0 => before = Some(proof),
        settled @ (Ok(_) | Err(Stop::Undecided(Reason::Contradiction) | Stop::Empty(Reason::Contradiction, _))) => {
            return settled;
        }
        Err(Stop::Refuted(_) | Stop::Undecided(_) | Stop::Empty(..)) => {}
    }
    match (decide_with(memory, graph, equations, (given, premises, &solutions, &partial), options), before) {
        (Ok(proof), Some(before)) => Ok(if left_out(&proof) < left_out(&before) { proof } else { before }),
        (Err(Stop::Undecided(_) | Stop::Empty(..)), Some(before)) => Ok(before),
        // Where a rate has no value, nothing contradicts anything.
        (Err(Stop::Undecided(Reason::Contradiction | Reason::NoValue) | Stop::Empty(..)), None) => {
            let product = partial.into_iter().reduce(|all, e| graph.mul(all, e));
            Err(product.map_or(Reason::Degenerate, Reason::OnlyWhere).into())
        }
        (settled, _) => settled,
    }
}

/// The same, with premises that are derived as far as is needed; `rates`: what must not vanish so that all of them have values.
fn decide_with(
    memory: &mut Memory,
    graph: &mut Graph,
    equations: &[(Expr, Expr)],
    (given, mut premises, solutions, rates): (&Premises, Vec<Premise>, &Solutions, &[Expr]),
    options: &Options,
) -> Result<Proof, Stop> {
    let mut draws = Draws::new(options.seed);
    // What is proved is proved where the formulas have values: what rates are restricted to asks for conditions only.
    let whole: Pairs = premises.iter().map(|p| (p.left, p.right)).collect();
    let is_partial: Vec<bool> = premises.iter().map(|p| p.partial).collect();
    for p in &mut premises {
        (p.left, p.right) = (graph.unrestricted(p.left), graph.unrestricted(p.right));
    }
    let solved = explicit(graph, &premises, equations, given);
    let premises = whole;
    let mut insertion = Insertion::new(&solved.definitions);
    let mut insert = |graph: &mut Graph, e: Expr| insertion.put_into(graph, e);
    let claim: Pairs = equations.iter().map(|&(l, r)| (insert(graph, l), insert(graph, r))).collect();
    let claim: Pairs = claim.into_iter().map(|(l, r)| (graph.unrestricted(l), graph.unrestricted(r))).collect();
    let nonzero: Vec<Expr> = given.nonzero.iter().map(|&e| insert(graph, e)).collect();
    let positive: Vec<Expr> = given.positive.iter().map(|&e| insert(graph, e)).collect();
    let not_negative: Vec<Expr> = given.not_negative.iter().map(|&e| insert(graph, e)).collect();
    let definitions: Vec<Expr> = solved.definitions.values().copied().collect();
    let facts = [nonzero.as_slice(), &positive, &not_negative];
    let mut lowered = lower(
        graph,
        &solved.rest,
        &claim,
        facts,
        &definitions,
        [true, options.further],
        &mut memory.structure.borrow_mut().combinations,
    )?;
    let asked = Asked::new(&lowered, options.most_nodes, options.further);
    if let Some(reason) = memory.why_open(&asked) {
        return Err(reason.into());
    }
    let probe = Probe::new(&mut draws, Rc::clone(&memory.structure));
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
        examples: options.attempts.min(MOST_EXAMPLES),
        strategy: Strategy::AsGiven,
        special: false,
        seeded: true,
        limit,
        shortened: false,
        solutions,
        closings: Rc::clone(&memory.closings),
    };
    let own = examination.lowered.premises.clone();
    let settled = examination.generic(&own);
    if let (Err(Stop::Undecided(reason)), false) = (&settled, examination.shortened) {
        memory.keep(asked, reason);
    }
    let (mut proof, resolved) = settled?;
    // Where a pivot vanishes, the premises may leave more open: looked at by themselves.
    let mut pivots = Pivots::of(&mut examination, &resolved);
    let limit = examination.graph.len() + MOST_SPECIAL_NODES;
    examination.examples = if proof.example.is_some() { 6 } else { options.attempts.min(MOST_EXAMPLES) };
    for at in 0..pivots.list.len().min(options.special_cases as usize) {
        // Where an equation of motion loses its highest rate, a point need not belong to a motion.
        let singular = own.iter().any(|&(_, derived)| derived) && pivots.rooted.contains(&pivots.list[at]);
        if singular || !is_simple(examination.graph, pivots.list[at]) || examination.graph.len() > limit {
            continue;
        }
        let mut with_pivot = vec![(pivots.list[at], false)];
        with_pivot.extend(&own);
        examination.special = true;
        let outcomes = examination.run(&with_pivot);
        examination.special = false;
        let Ok(outcomes) = outcomes else { continue };
        match merge(outcomes) {
            Ok((special, resolved)) => {
                proof.absorb(special);
                pivots.nested[at] = Some(Pivots::of(&mut examination, &resolved).list);
            }
            Err(Stop::Refuted(refutation)) => return Err(Stop::Refuted(refutation)),
            Err(Stop::Empty(Reason::Contradiction, cases)) => {
                pivots.nested[at] = Some(Pivots::of(&mut examination, &cases).list);
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
    let whole = equations.iter().chain(premises.iter().zip(&is_partial).filter(|(_, p)| !**p).map(|(pair, _)| pair));
    let mut all: Vec<Expr> = whole.flat_map(|&(l, r)| [l, r]).collect();
    all.dedup();
    proof.conditions = conditions(graph, &lowered, given, &resolved, &all, &solved.pivots, (&needed, rates));
    // An example is one only if it is reached: nothing vanishes there that was divided by.
    let divided: Vec<Expr> = proof.conditions.iter().filter_map(|c| c.leaves_out()).collect();
    proof.example = proof.example.take().filter(|point| vanishing(graph, &divided, point).is_none());
    if proof.example.is_none() && options.attempts > FEW_POINTS {
        proof.example = match example(graph, equations, &premises, given, &divided, options) {
            Some(Example { differs: Some(at), .. }) => {
                let what = format!("proved over finite fields, but equation {at} fails at a real point");
                return Err(Reason::Defect(what).into());
            }
            found => found.map(|f| f.point),
        };
    }
    Ok(proof)
}

/// Points that are tried for an example of what is proved. What fails is refuted by one, which is looked for longer.
const MOST_EXAMPLES: u32 = 48;

/// Special cases are given up when they have made this many nodes: their pivots stay conditions.
const MOST_SPECIAL_NODES: usize = 2000;

/// Whether it is worth while to look at the case that a pivot vanishes: it can be solved for something.
fn is_simple(graph: &Graph, pivot: Expr) -> bool {
    let nodes = graph.reachable([pivot]);
    nodes.len() <= 48 && !nodes.iter().any(|&e| matches!(graph.node(e), Node::Unary(Op::Sqrt, _)))
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
    /// Whether the first premise says that something was divided by is 0: it is solved first.
    special: bool,
    /// Whether orthogonal matrices are parametrised.
    seeded: bool,
    /// The size of the graph at which solving is given up.
    limit: usize,
    /// Whether a reason was given that looks at a part of the pivots only.
    shortened: bool,
    /// Which points belong to motions, and to fields.
    solutions: &'a Solutions,
    /// So many points may still be looked at as formulas of numbers.
    closings: Rc<Cell<u32>>,
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
            match self.run(premises).map_err(Stop::from).and_then(merge).or_else(|s| self.emptiness(premises, s)) {
                Err(Stop::Undecided(reason)) if reason.is_about_solving() => drop(first.get_or_insert(reason)),
                Err(Stop::Undecided(reason @ Reason::Branches { .. })) if matrices && seeded => {
                    first.get_or_insert(reason);
                }
                settled => return settled,
            }
        }
        Err(Stop::Undecided(first.unwrap_or(Reason::Degenerate)))
    }

    /// A contradiction is one only if the premises cannot hold where a pivot vanishes, either. If they can, everything is
    /// decided there.
    fn emptiness(&mut self, premises: &[(Expr, bool)], stop: Stop) -> Result<(Proof, Vec<Resolved>), Stop> {
        let Stop::Empty(mut reason, cases) = stop else { return Err(stop) };
        let is_empty = |r: &Reason| matches!(r, Reason::Contradiction | Reason::NoValue);
        if !is_empty(&reason) {
            return Err(Stop::Undecided(reason));
        }
        let (mut open, mut proof): (Option<Expr>, Option<(Proof, Vec<Resolved>)>) = (None, None);
        // Once a pivot is open, nothing is proved or contradictory any more, and what holds derivatives is not refuted.
        let idle = match self.options.wanted {
            Wanted::Answer => false,
            Wanted::Proof => true,
            Wanted::Fault => premises.iter().any(|&(_, derived)| derived),
        };
        let pivots = Pivots::of(self, &cases).list;
        let before = self.graph.len();
        for (at, &pivot) in pivots.iter().enumerate() {
            if idle && open.is_some() {
                // What is not looked at counts as if it had been: other orders of solving get no more room for it.
                let each = (self.graph.len() - before) / at.max(1);
                self.limit = self.limit.saturating_sub(each.saturating_mul(pivots.len() - at));
                self.shortened = true;
                break;
            }
            let mut special = vec![(pivot, false)];
            special.extend(premises);
            self.special = true;
            let found = self.run(&special).map_err(Stop::from).and_then(merge);
            self.special = false;
            match found {
                // A point that satisfies all premises refutes, wherever it was found.
                Err(refuted @ Stop::Refuted(_)) if !premises.iter().any(|&(_, derived)| derived) => {
                    return Err(refuted);
                }
                Ok((one, cases)) => match &mut proof {
                    None => proof = Some((one, cases)),
                    Some((all, list)) => {
                        all.absorb(one);
                        list.extend(cases);
                    }
                },
                Err(Stop::Empty(special, cases)) if is_empty(&special) && Pivots::of(self, &cases).list.is_empty() => {
                    if special == Reason::NoValue {
                        reason = special;
                    }
                }
                _ => open = Some(open.map_or(pivot, |all| self.graph.mul(all, pivot))),
            }
        }
        match (open, proof) {
            (Some(pivots), _) => {
                Err(Stop::Undecided(Reason::OnlyWhere(raised(self.graph, &self.lowered.generators, pivots))))
            }
            (None, Some(proof)) => Ok(proof),
            (None, None) => Err(Stop::Undecided(match self.boundary() {
                Some(base) if reason == Reason::Contradiction => Reason::Boundary(base),
                _ => reason,
            })),
        }
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
            special: self.special,
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
}

fn leaf_of(graph: &Graph, e: Expr) -> Option<Leaf> {
    match graph.node(e) {
        Node::Leaf(leaf) => Some(*leaf),
        _ => None,
    }
}
