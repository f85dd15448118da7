//! The problem without transcendental functions, and what is asked of the field for one case of it.

use super::absolute::AbsoluteValues;
use super::field::Question;
use super::generators::{Generator, Generators, Lowering};
use super::implied::{Implied, implied};
use super::insertion::Insertion;
use super::linear::Combinations;
use super::logarithm::Logarithms;
use super::orthogonal::{Orthogonal, orthogonal};
use super::outcome::Reason;
use super::polynomial::factors;
use super::prepare::{Premise, argument_leaves};
use super::probe::Probe;
use super::roots::Roots;
use super::sign::Facts;
use super::solve::{Resolved, insert_definitions};
use expr::{Expr, Graph, Leaf, Node, Op};
use expr::{FastMap, FastSet};

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
    pub(super) frozen: FastSet<Leaf>,
    /// Orthogonal matrices among the premises.
    pub(super) orthogonal: Orthogonal,
    /// [`super::outcome::Options::further`].
    further: bool,
}

/// Premises and claim, definitions inserted, without transcendental functions; `with_signs`, absolute values in premises become
/// [`AbsoluteValues`]. `combinations` are what is known of the graph.
pub(super) fn lower(
    graph: &mut Graph,
    premises: &[Premise],
    claim: &[(Expr, Expr)],
    [nonzero, positive, not_negative]: [&[Expr]; 3],
    definitions: &[Expr],
    [with_signs, further]: [bool; 2],
    combinations: &mut Combinations,
) -> Result<Lowered, Reason> {
    let residuals: Vec<Expr> = premises.iter().map(|p| graph.sub(p.left, p.right)).collect();
    // Nor are the radicands of premises negative.
    let formulas: Vec<Expr> = premises.iter().flat_map(|p| [p.left, p.right]).collect();
    let radicands = graph.reachable(formulas).into_iter().filter_map(|node| match *graph.node(node) {
        Node::Unary(Op::Sqrt, a) => Some(a),
        _ => None,
    });
    let radicands: Vec<Expr> = radicands.collect();
    let mut roots: Vec<Expr> = claim.iter().flat_map(|&(l, r)| [l, r]).collect();
    roots.extend(residuals.iter().chain(nonzero).chain(positive).chain(not_negative).chain(definitions));
    let (mut logarithms, implied) = match further {
        true => (Logarithms::of(graph, &roots, positive), implied(graph, &roots, [positive, not_negative])),
        false => (Logarithms::default(), Implied::default()),
    };
    let mut apart = |graph: &mut Graph, list: &[Expr]| -> Vec<Expr> {
        list.iter().map(|&e| logarithms.put_into(graph, e)).collect()
    };
    let residuals = apart(graph, &residuals);
    let claimed: Vec<Expr> = claim.iter().flat_map(|&(l, r)| [l, r]).collect();
    let claimed = apart(graph, &claimed);
    let [nonzero, positive, not_negative, definitions, radicands, implied, implied_positive] =
        [nonzero, positive, not_negative, definitions, &radicands, &implied.not_negative, &implied.positive]
            .map(|list| apart(graph, list));
    let mut roots = claimed.clone();
    let lists = [&residuals, &nonzero, &positive, &not_negative, &definitions, &radicands, &implied, &implied_positive];
    roots.extend(lists.into_iter().flatten());
    let mut given = Facts::default();
    positive.iter().for_each(|&e| given.note_positive(graph, e));
    not_negative.iter().for_each(|&e| given.note_not_negative(graph, e));
    given.nonzero.extend(&nonzero);
    let mut lowering = Lowering::new(graph, &roots, given);
    let mut images = Vec::new();
    for (&e, premise) in residuals.iter().zip(premises) {
        images.push((lowering.lower(e)?, premise.derived));
    }
    let mut sides = Vec::new();
    for &[left, right] in claimed.as_chunks().0 {
        sides.push((lowering.lower(left)?, lowering.lower(right)?));
    }
    let mut facts = Facts::default();
    for e in positive {
        let image = lowering.lower(e)?;
        facts.note_positive(lowering.graph, image);
    }
    for e in not_negative {
        let image = lowering.lower(e)?;
        facts.note_not_negative(lowering.graph, image);
    }
    let mut not_zero = Vec::new();
    for e in nonzero {
        not_zero.push(lowering.lower(e)?);
    }
    for a in radicands {
        let image = lowering.lower(a)?;
        facts.note_not_negative(lowering.graph, image);
    }
    let mut of_values = Vec::new();
    for a in implied {
        of_values.push(lowering.lower(a)?);
    }
    let mut of_positive = Vec::new();
    for a in implied_positive {
        of_positive.push(lowering.lower(a)?);
    }
    let mut of_definitions = Vec::new();
    for e in definitions {
        of_definitions.push(lowering.lower(e)?);
    }
    // What a root of higher order is of: the root, to its power, is that.
    if further {
        images.extend(lowering.radicals()?.into_iter().map(|radical| (radical, false)));
    }
    let (graph, mut generators) = (&mut *lowering.graph, lowering.generators);
    let premises: Vec<Expr> = images.iter().filter(|_| with_signs).map(|&(e, _)| e).collect();
    let mut absolute = AbsoluteValues::of(graph, &mut generators, &mut facts, &premises)?;
    let mut put = |e: &mut Expr| *e = absolute.put_into(graph, *e);
    images.iter_mut().for_each(|(e, _)| put(e));
    sides.iter_mut().for_each(|(l, r)| [l, r].into_iter().for_each(&mut put));
    not_zero.iter_mut().chain(&mut of_definitions).for_each(&mut put);
    // Formulas are claimed where they have a value, so their denominators are not 0 there; those of rates are told as conditions.
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
    of_values.iter().for_each(|&e| facts.note_not_negative(graph, e));
    of_positive.iter().for_each(|&e| facts.note_positive(graph, e));
    // What still stands in arguments after lowering must stay free.
    let named = |at: &usize| !further || !generators.radicals.iter().any(|r| r.generator == *at);
    let arguments = (0..generators.list.len()).filter(named).filter_map(|at| generators.list[at].argument());
    let arguments: Vec<Expr> = arguments.collect();
    let frozen = argument_leaves(graph, arguments.iter().copied()).into_iter().chain(graph.leaves(arguments)).collect();
    let given: Vec<Expr> = images.iter().filter(|(_, derived)| !derived).map(|&(e, _)| e).collect();
    let all = images.iter().map(|&(e, _)| e).chain(sides.iter().flat_map(|&(l, r)| [l, r]));
    let occurring = graph.leaves(all);
    let orthogonal = orthogonal(graph, &mut generators, combinations, &given, &occurring);
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
        further,
    })
}

/// What is asked of the field for one case: everything with the case's definitions, in normal form, circles parametrised.
pub(super) fn question(
    graph: &mut Graph,
    lowered: &mut Lowered,
    probe: &mut Probe,
    (case, map): (&Resolved, &FastMap<Leaf, Expr>),
    residuals: Vec<Expr>,
    with_pivots: bool,
) -> Question {
    let mut insertion = Insertion::new(map);
    let mut inserted = |graph: &mut Graph, list: &[Expr]| -> Vec<Expr> {
        list.iter().map(|&e| insertion.put_into(graph, e)).collect()
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
    let mut roots = Roots::new(graph, &mut lowered.generators, probe, facts, lowered.further);
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
    let lists: Vec<&mut Vec<Expr>> = [residuals, filters, zeros, assumed, nonzeros].into_iter().chain(pivots).collect();
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
