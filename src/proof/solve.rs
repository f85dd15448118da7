//! Premises as a parametrised set: triangular resolution.
//!
//! **In:** lowered residuals that vanish under the premises. **Out:** [`Resolved`] cases, each with definitions
//! leaf := expression in the remaining leaves. A case covers every common solution at which its pivots are not 0; the pivots
//! are reported as conditions. Equations that are products are split into one case for each factor not known to be ≠ 0.
//!
//! An unknown is solved for when an equation, as a polynomial in it, has degree 1 (x = −b/a) or 2
//! (x = (−b + σ√(b² − 4ac))/2a with a sign σ of its own, so that both roots are covered). Cosine and sine of one argument
//! are unknowns too: an equation in both is reduced by c² + s² = 1, and once one of them is solved for, that relation becomes
//! an equation for the other.
//!
//! Leaving an equation out only enlarges the set on which the conclusion is tested, so redundant equations need not be
//! recognised with certainty.

mod reduce;

use super::generators::{Generator, Generators};
use super::insertion::Insertion;
use super::polynomial::{factors, product};
use super::probe::{InPowers, Probe, Sight};
use super::sign::{Facts, Known};
use super::structure::{Extent, Powers};
use expr::{Expr, Graph, Leaf, Node, Op, Rational};
use expr::{FastMap, FastSet};
use std::collections::BTreeSet;
use std::rc::Rc;

/// One case of the resolution.
#[derive(Clone, Default)]
pub(super) struct Resolved {
    /// In the order of solving; an expression may contain leaves that are solved later.
    pub(super) definitions: Vec<(Leaf, Expr)>,
    /// Must not vanish: divided by while solving; with the number of the definition that it is for.
    pub(super) pivots: Vec<(Expr, Option<usize>)>,
    /// For each definition the earlier ones that were inserted into its equation.
    needs: Vec<BTreeSet<usize>>,
    /// Must not be negative: discriminants.
    pub(super) radicands: Vec<Expr>,
    /// Taken as zero on the strength of a few random points; to be tested with everything else.
    pub(super) taken_as_zero: Vec<Expr>,
    /// Equations without an unknown that can be solved for.
    pub(super) unsolved: Vec<Expr>,
    /// Definitions inserted into these.
    unsolved_needs: BTreeSet<usize>,
    /// Whether the premises cannot hold in this case, where the pivots are not 0.
    pub(super) empty: bool,
    /// A denominator of a premise that vanishes wherever the others hold: the premise has no value then.
    pub(super) void: Option<Expr>,
    /// Whether it is empty because something vanishes that a formula divides by.
    pub(super) no_value: bool,
    /// Factors set to 0, for the description of the case.
    pub(super) split_on: Vec<Expr>,
}

/// Why there is no resolution.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Failed {
    /// What was divided by vanishes identically.
    Degenerate,
    /// More cases than are looked at.
    TooManyCases,
}

/// Which equation is solved next, and for which unknown: where one order runs into choices of signs that the other premises
/// only partly exclude, or into pivots that vanish, another may not.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Strategy {
    /// Equations in the order in which they are given.
    AsGiven,
    /// Pivots known to be ≠ 0 first, even in quadratic equations.
    CertainPivots,
    /// Linear equations first.
    LowDegree,
    /// Pivots known to be ≠ 0 first, unknowns in the opposite order.
    LastFirst,
}

impl Strategy {
    /// In the order of trying.
    pub(super) const ALL: [Strategy; 4] =
        [Strategy::LowDegree, Strategy::AsGiven, Strategy::CertainPivots, Strategy::LastFirst];
}

/// What the resolution works with.
pub(super) struct Solver<'a> {
    pub(super) graph: &'a mut Graph,
    pub(super) generators: &'a mut Generators,
    pub(super) probe: &'a mut Probe,
    pub(super) facts: &'a Facts,
    /// What is given of signs.
    pub(super) given_facts: &'a Facts,
    /// Leaves that must stay free: they stand in arguments of transcendental functions.
    pub(super) frozen: &'a FastSet<Leaf>,
    /// In which order.
    pub(super) strategy: Strategy,
    /// Whether the first equation comes before all others.
    pub(super) special: bool,
    /// Leaves that are solved for only when nothing else can be.
    pub(super) parameters: &'a FastSet<Leaf>,
    /// The size of the graph at which solving is given up.
    pub(super) limit: usize,
}

const MOST_CASES: usize = 16;

/// An equation that is not yet used.
#[derive(Clone, Copy)]
struct Pending {
    /// A numerator that must vanish.
    e: Expr,
    /// The residual it comes from: the test of signs wants its value, without what it was multiplied by.
    plain: Expr,
    /// Whether it is a derivative by time of others.
    derived: bool,
    /// A number for what was inserted into it, see [`Case::inserted`].
    from: usize,
}

#[derive(Clone, Default)]
struct Case {
    out: Resolved,
    pending: Vec<Pending>,
    /// For each equation the definitions that were inserted into it.
    inserted: Vec<BTreeSet<usize>>,
    on_circle: BTreeSet<Leaf>,
}

struct Candidate {
    class: u8,
    rank: (u8, u8, usize, u8, u8, usize, usize),
    equation: usize,
    unknown: Leaf,
    /// Coefficients, and those above that vanish.
    powers: Rc<InPowers>,
}

/// The expression with all definitions inserted.
pub(super) fn insert_definitions(graph: &mut Graph, map: &FastMap<Leaf, Expr>, e: Expr) -> Expr {
    Insertion::new(map).put_into(graph, e)
}

/// Definitions with later ones inserted into earlier ones.
pub(super) fn closed(graph: &mut Graph, definitions: &[(Leaf, Expr)]) -> FastMap<Leaf, Expr> {
    let mut map = FastMap::default();
    for &(leaf, e) in definitions.iter().rev() {
        let e = insert_definitions(graph, &map, e);
        map.insert(leaf, e);
    }
    map
}

impl Resolved {
    /// One value for a sign.
    pub(super) fn define_sign(&mut self, leaf: Leaf, value: Expr) {
        self.definitions.push((leaf, value));
        self.needs.push(BTreeSet::new());
    }

    /// The pivots of the definitions that expressions depend on. The equations that the other definitions come from could
    /// have been left out: so could what was divided by for them.
    pub(super) fn pivots_for(&self, graph: &Graph, exprs: impl IntoIterator<Item = Expr>) -> Vec<Expr> {
        let mut needed: BTreeSet<usize> = BTreeSet::new();
        let of = |leaf: Leaf| self.definitions.iter().position(|&(l, _)| l == leaf);
        let roots = exprs.into_iter().chain(self.unsolved.iter().copied());
        let mut open: Vec<usize> = graph.leaves(roots).into_iter().filter_map(of).collect();
        open.extend(&self.unsolved_needs);
        while let Some(number) = open.pop() {
            if needed.insert(number) {
                open.extend(graph.leaves([self.definitions[number].1]).into_iter().filter_map(of));
                open.extend(&self.needs[number]);
            }
        }
        let mut out: Vec<Expr> = Vec::new();
        for &(pivot, number) in &self.pivots {
            if (self.empty || number.is_none_or(|n| needed.contains(&n))) && !out.contains(&pivot) {
                out.push(pivot);
            }
        }
        out
    }
}

impl Solver<'_> {
    /// All cases, also those in which the premises contradict each other.
    ///
    /// `seeds` are definitions to begin with, see [`orthogonal`](super::orthogonal).
    pub(super) fn solve(
        &mut self,
        equations: &[(Expr, bool)],
        seeds: &[(Leaf, Expr)],
    ) -> Result<Vec<Resolved>, Failed> {
        let map = closed(self.graph, seeds);
        let mut insertion = Insertion::new(&map);
        let pending = equations
            .iter()
            .enumerate()
            .map(|(from, &(plain, derived))| Pending { e: insertion.put_into(self.graph, plain), plain, derived, from })
            .collect();
        let needs = vec![BTreeSet::new(); seeds.len()];
        let out = Resolved { definitions: seeds.to_vec(), needs, ..Resolved::default() };
        let inserted = vec![BTreeSet::new(); equations.len()];
        let mut open = vec![Case { pending, out, inserted, ..Case::default() }];
        let mut done = Vec::new();
        while let Some(mut case) = open.pop() {
            if open.len() + done.len() > MOST_CASES {
                return Err(Failed::TooManyCases);
            }
            match self.advance(&mut case)? {
                Next::Done => done.push(case.out),
                Next::Contradiction => done.push(Resolved { empty: true, ..case.out }),
                Next::NoValue => done.push(Resolved { empty: true, no_value: true, ..case.out }),
                Next::Void(denominator) => done.push(Resolved { void: Some(denominator), ..case.out }),
                Next::Sign(sign) => {
                    for value in [-1, 1] {
                        let mut one = case.clone();
                        let number = one.out.definitions.len();
                        let value = self.graph.integer(value);
                        one.out.define_sign(sign, value);
                        self.insert(&mut one, (number, &BTreeSet::new()), (sign, value));
                        open.push(one);
                    }
                }
                Next::Split(equation, parts) => {
                    for part in parts.into_iter().rev() {
                        let mut one = case.clone();
                        one.pending[equation] = Pending { e: part, plain: part, ..one.pending[equation] };
                        one.out.split_on.push(part);
                        open.push(one);
                    }
                }
            }
        }
        Ok(done)
    }

    fn advance(&mut self, case: &mut Case) -> Result<Next, Failed> {
        loop {
            if self.graph.len() > self.limit {
                return Err(Failed::TooManyCases);
            }
            if let Some(next) = self.tidy(case)? {
                return Ok(next);
            }
            let mut best: Option<Candidate> = None;
            for equation in 0..case.pending.len() {
                for candidate in self.candidates(case, equation) {
                    if best.as_ref().is_none_or(|b| candidate.rank < b.rank) {
                        best = Some(candidate);
                    }
                }
            }
            let Some(best) = best else {
                for p in case.pending.drain(..) {
                    case.out.unsolved.push(p.plain);
                    case.out.unsolved_needs.extend(&case.inserted[p.from]);
                }
                return Ok(Next::Done);
            };
            if let Some(next) = self.zero_root(case, &best) {
                return Ok(next);
            }
            if let Some(sign) = self.sign_of_pivot(&best) {
                return Ok(Next::Sign(sign));
            }
            self.define(case, best);
        }
    }

    /// Numerators of the pending equations, without known factors; splits, contradictions.
    fn tidy(&mut self, case: &mut Case) -> Result<Option<Next>, Failed> {
        let mut kept: Vec<Pending> = Vec::new();
        let mut pending = std::mem::take(&mut case.pending);
        pending.reverse();
        let mut split = None;
        let mut seen = FastSet::default();
        while let Some(one) = pending.pop() {
            let (top, _) = self.probe.structure.borrow_mut().fraction(self.graph, one.e);
            if !seen.insert(top) {
                continue;
            }
            match self.probe.sight(self.graph, self.generators, top) {
                Sight::Zero => continue,
                // A rate without a value says nothing.
                Sight::Nowhere if one.derived => continue,
                Sight::Nowhere => {
                    return match self.vanishing_denominator(case, one.plain) {
                        Some(denominator) => Ok(Some(Next::Void(denominator))),
                        None => Err(Failed::Degenerate),
                    };
                }
                Sight::Nonzero => {}
            }
            let (_, parts) = factors(self.graph, top);
            let bases: Vec<Expr> = parts.into_iter().filter(|&(_, k)| k > 0).map(|(base, _)| base).collect();
            let mut parts: Vec<Expr> = bases.iter().copied().filter(|&base| !self.is_known(base)).collect();
            if parts.len() > 1 {
                // A variable that must stay free is not set to 0; that it is not 0 becomes a condition.
                let free = |base: &Expr| match self.graph.node(*base) {
                    Node::Leaf(leaf) => self.frozen.contains(leaf),
                    _ => false,
                };
                case.out.pivots.extend(parts.iter().copied().filter(free).map(|e| (e, None)));
                parts.retain(|base| !free(base));
            }
            match parts.as_slice() {
                // That a formula has a value is not given.
                [] => {
                    let given = bases.into_iter().all(|base| self.is_given(base));
                    return Ok(Some(if given { Next::Contradiction } else { Next::NoValue }));
                }
                &[base] => {
                    if let Some(terms) = self.squares(base) {
                        pending.extend(terms.into_iter().rev().map(|e| Pending { e, plain: e, ..one }));
                        continue;
                    }
                    let reduced = self.on_circle(case, base);
                    let (_, again) = factors(self.graph, reduced);
                    if let Some(parts) = self.without_leaf(reduced) {
                        split.get_or_insert((kept.len(), parts));
                    } else if again.len() > 1 {
                        split.get_or_insert((kept.len(), again.into_iter().map(|(b, _)| b).collect::<Vec<_>>()));
                    }
                    kept.push(Pending { e: reduced, ..one });
                }
                many => {
                    split.get_or_insert((kept.len(), many.to_vec()));
                    kept.push(Pending { e: one_product(self.graph, many), ..one });
                }
            }
        }
        case.pending = kept;
        Ok(split.map(|(equation, parts)| Next::Split(equation, parts)))
    }

    /// Whether an expression is known to be ≠ 0.
    fn is_known(&mut self, e: Expr) -> bool {
        self.sign(e).nonzero
    }

    fn sign(&mut self, e: Expr) -> Known {
        self.facts.sign_after(self.graph, self.generators, e, &mut self.probe.signs)
    }

    /// Whether it is known from what is given.
    fn is_given(&self, e: Expr) -> bool {
        self.given_facts.sign(self.graph, self.generators, e).nonzero
    }

    /// A denominator of a premise that vanishes under the definitions of a case, none of whose pivots vanishes.
    fn vanishing_denominator(&mut self, case: &Case, plain: Expr) -> Option<Expr> {
        let map = closed(self.graph, &case.out.definitions);
        let pivots = case.out.pivots.clone();
        for (pivot, _) in pivots {
            let pivot = insert_definitions(self.graph, &map, pivot);
            if !self.probe.never_vanishes(self.graph, self.generators, pivot) {
                return None;
            }
        }
        let denominators: Vec<Expr> = self
            .graph
            .reachable([plain])
            .iter()
            .filter_map(|&e| match *self.graph.node(e) {
                Node::Binary(Op::Div, _, b) => Some(b),
                Node::Unary(Op::Powi(n), a) if n < 0 => Some(a),
                _ => None,
            })
            .collect();
        denominators.into_iter().find(|&e| {
            let e = insert_definitions(self.graph, &map, e);
            self.probe.sight(self.graph, self.generators, e) == Sight::Zero
        })
    }

    fn class(&self, leaf: Leaf) -> Option<u8> {
        if self.frozen.contains(&leaf) {
            return None;
        }
        match self.generators.get(leaf) {
            Some(Generator::Cosine(_) | Generator::Sine(_) | Generator::Exponential(_)) => Some(2),
            Some(Generator::Opaque(_)) => Some(4),
            Some(Generator::Sign | Generator::Half) => None,
            Some(Generator::Free) => Some(2),
            None if self.parameters.contains(&leaf) => Some(3),
            None if leaf.rate > 0 || !leaf.partials.is_none() => Some(0),
            None => Some(1),
        }
    }

    fn candidates(&mut self, case: &Case, equation: usize) -> Vec<Candidate> {
        let Pending { e, derived, from, .. } = case.pending[equation];
        let mut out = Vec::new();
        let extent = self.extent(e);
        let size = extent.size;
        let mut leaves: Vec<(u8, Leaf)> = extent.leaves.iter().filter_map(|&l| Some((self.class(l)?, l))).collect();
        leaves.sort_by_key(|&(class, leaf)| (class, std::cmp::Reverse((leaf.rate, leaf.partials.order()))));
        for (class, unknown) in leaves {
            if out.iter().any(|c: &Candidate| c.class < class) {
                break;
            }
            let Some(powers) = self.in_powers(e, unknown) else { continue };
            let all = &powers.0;
            let Some(&pivot) = all.last() else { continue };
            let quality = if self.graph.as_constant(pivot).is_some() {
                0
            } else if self.is_known(pivot) {
                1
            } else {
                2
            };
            let degree = all.len() as u8;
            // What holds without rates comes first: a rate must not be divided by something that it makes 0.
            let late = match derived {
                _ if self.special && from == 0 => 0,
                false => 1,
                true if unknown.rate > 0 || !unknown.partials.is_none() => 2,
                true => 3,
            };
            let position = out.len();
            out.push(Candidate {
                class,
                rank: match self.strategy {
                    Strategy::AsGiven => (late, class, equation, degree, quality, size, position),
                    Strategy::CertainPivots => (late, class, 0, quality, degree, size, position),
                    Strategy::LowDegree => (late, class, 0, degree, quality, size, position),
                    Strategy::LastFirst => (late, class, 0, quality, degree, size, usize::MAX - position),
                },
                equation,
                unknown,
                powers,
            });
        }
        out
    }

    /// Coefficients of an equation of degree 1 or 2 in an unknown, and those above that vanish at the random points.
    fn in_powers(&mut self, e: Expr, unknown: Leaf) -> Option<Rc<InPowers>> {
        if let Some(known) = self.probe.solvable.get(&(e, unknown)) {
            return known.clone();
        }
        let mut found = None;
        if let Some(all) = self.written_in_powers(e, unknown) {
            let mut all = all.to_vec();
            let mut vanishing = Vec::new();
            while let Some(&last) = all.last()
                && all.len() > 1
                && self.probe.sight(self.graph, self.generators, last) != Sight::Nonzero
            {
                vanishing.push(last);
                all.pop();
            }
            if all.len() == 2 || all.len() == 3 {
                found = Some(Rc::new((all, vanishing)));
            }
        }
        self.probe.solvable.insert((e, unknown), found.clone());
        found
    }

    fn written_in_powers(&mut self, e: Expr, unknown: Leaf) -> Option<Powers> {
        self.probe.structure.borrow_mut().powers(self.graph, e, unknown)
    }

    fn extent(&mut self, e: Expr) -> Rc<Extent> {
        self.probe.structure.borrow_mut().extent(self.graph, e)
    }

    /// Solves one equation for one unknown and inserts the result everywhere.
    fn define(&mut self, case: &mut Case, candidate: Candidate) {
        let Candidate { equation, unknown, powers, .. } = candidate;
        let (coefficients, vanishing) = &*powers;
        let from = case.pending.remove(equation).from;
        case.out.taken_as_zero.extend(vanishing.iter().copied().filter(|&e| !self.graph.is_zero(e)));
        let value = match *coefficients.as_slice() {
            [b, a] => {
                self.pivot(case, a);
                let quotient = self.graph.div(b, a);
                self.graph.neg(quotient)
            }
            [c, b, a] => {
                self.pivot(case, a);
                self.quadratic(case, c, b, a)
            }
            _ => return,
        };
        let number = case.out.definitions.len();
        case.out.definitions.push((unknown, value));
        let needs = case.inserted[from].clone();
        case.out.needs.push(needs.clone());
        if let Some((c, s)) = self.generators.circle(unknown)
            && case.on_circle.insert(c)
        {
            let g = &mut *self.graph;
            let (c, s, one) = (g.leaf(c), g.leaf(s), g.integer(1));
            let (cc, ss) = (g.powi(c, 2), g.powi(s, 2));
            let sum = g.add(cc, ss);
            let e = g.sub(sum, one);
            case.inserted.push(BTreeSet::new());
            case.pending.push(Pending { e, plain: e, derived: false, from: case.inserted.len() - 1 });
        }
        self.insert(case, (number, &needs), (unknown, value));
    }

    /// Inserts a definition, which has a number and needs others, into the equations that are left.
    fn insert(&mut self, case: &mut Case, (number, needs): (usize, &BTreeSet<usize>), (unknown, value): (Leaf, Expr)) {
        for p in &mut case.pending {
            let mut structure = self.probe.structure.borrow_mut();
            if structure.depends(self.graph, p.e, unknown) {
                case.inserted[p.from].insert(number);
                case.inserted[p.from].extend(needs);
                p.e = structure.replaced(self.graph, p.e, unknown, value);
            }
        }
    }

    /// A sign that says whether the pivot of a candidate is 0: it is made of signs alone, and divided by in the cases of one of them only.
    fn sign_of_pivot(&self, candidate: &Candidate) -> Option<Leaf> {
        let pivot = *candidate.powers.0.last()?;
        let leaves = self.graph.leaves([pivot]);
        let is_sign = |l: &Leaf| self.generators.get(*l) == Some(&Generator::Sign);
        leaves.iter().all(is_sign).then(|| leaves.first().copied())?
    }

    fn pivot(&mut self, case: &mut Case, a: Expr) {
        if self.graph.as_constant(a).is_none() {
            case.out.pivots.push((a, Some(case.out.definitions.len())));
        }
    }

    /// A root of a·x² + b·x + c, with a sign of its own.
    ///
    /// The radicand carries the factor σ², so that this root is never taken for the positive root of the same radicand.
    fn quadratic(&mut self, case: &mut Case, c: Expr, b: Expr, a: Expr) -> Expr {
        let Some(leaf) = self.generators.add(Generator::Sign) else { return c };
        let g = &mut *self.graph;
        let sigma = g.leaf(leaf);
        let mark = g.powi(sigma, 2);
        let two = g.integer(2);
        let flat = g.is_zero(b);
        if flat || self.probe.sight(self.graph, self.generators, b) == Sight::Zero {
            let g = &mut *self.graph;
            if !flat {
                case.out.taken_as_zero.push(b);
            }
            let quotient = g.div(c, a);
            let radicand = g.neg(quotient);
            case.out.radicands.push(radicand);
            let marked = g.mul(radicand, mark);
            let root = g.unary(Op::Sqrt, marked);
            return g.mul(sigma, root);
        }
        let g = &mut *self.graph;
        let four = g.integer(4);
        let (square, ac) = (g.powi(b, 2), g.mul_structural(a, c));
        let four_ac = g.mul(four, ac);
        let radicand = g.sub(square, four_ac);
        case.out.radicands.push(radicand);
        let marked = g.mul(radicand, mark);
        let root = g.unary(Op::Sqrt, marked);
        let signed = g.mul(sigma, root);
        let top = g.sub(signed, b);
        let under = g.mul(two, a);
        g.div(top, under)
    }
}

enum Next {
    Done,
    Contradiction,
    /// Something vanishes that a formula divides by.
    NoValue,
    /// This denominator seems to vanish, as far as random points tell.
    Void(Expr),
    /// What is divided by depends on this sign alone.
    Sign(Leaf),
    /// The equation with this number is a product of these factors.
    Split(usize, Vec<Expr>),
}

fn one_product(graph: &mut Graph, bases: &[Expr]) -> Expr {
    let parts: Vec<(Expr, i32)> = bases.iter().map(|&b| (b, 1)).collect();
    product(graph, &Rational::ONE, &parts)
}

/// The radicand of a root made by [`Solver::quadratic`], without its mark.
pub(super) fn unmarked(graph: &mut Graph, generators: &Generators, radicand: Expr) -> Option<Expr> {
    let is_mark = |graph: &Graph, e: Expr| match *graph.node(e) {
        Node::Unary(Op::Powi(2), s) => match *graph.node(s) {
            Node::Leaf(leaf) => generators.get(leaf) == Some(&Generator::Sign),
            _ => false,
        },
        _ => false,
    };
    if is_mark(graph, radicand) {
        return Some(graph.integer(1));
    }
    let Node::Binary(Op::Mul, a, b) = *graph.node(radicand) else { return None };
    if is_mark(graph, b) {
        Some(a)
    } else if is_mark(graph, a) {
        Some(b)
    } else {
        None
    }
}
