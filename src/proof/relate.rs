//! Values of functions that are related, and numbers: what is looked at where the field leaves a question open.
//!
//! **In:** equations that were neither proved nor refuted. **Out:** a proof, or a refutation, if one of these ways ends in one:
//!
//! * **Numbers.** Without leaves and premises, algebraic numbers are compared exactly (`algebraic`).
//! * **Premises** of high degree are written with lower ones (`simpler`), and points that satisfy them are found by Newton's
//!   method (`newton`).
//! * **Logarithms.** A sum Σ qᵢ ln uᵢ + r is 0 exactly where its exponential ∏ uᵢ^{qᵢ}·eʳ is 1.
//! * **Powers.** Products of powers of what is positive are equal where their logarithms are (`powers`).
//! * **Squares.** What is not negative is equal where its squares are (`squares`).
//! * **Angles.** A sum θ of angles (arcsin, arctan, …, π) is 0 if cos θ = 1 and its range, by the signs that are given, lies
//!   between −2π and 2π. In place of a derivative and one value: no path in the domain is needed.
//! * **Arguments.** f(u) and f(v) are one value where u = v, and for even and odd functions where u = −v.
//!
//! The last three end in an equation between algebraic functions, or in shorter arguments: a question of its own, with the same
//! premises. It is proved like any other; its bound, its conditions and its example count. **Guaranteed:** a proof here rests on
//! proofs there, and on the rules above, which hold wherever the formulas have values.

use super::algebraic;
use super::apart::undeclared;
use super::jets::names_fields;
use super::linear::{Combination, Combinations, Monomial, expression};
use super::memory::Memory;
use super::newton::{example, refutes};
use super::outcome::{Identity, Options, Point, PointValue, Premises, Proof, Reason, Refutation, Side, Wanted};
use super::polynomial::{fraction, replaced};
use super::powers::by_logarithms;
use super::prove::identity_at;
use super::range::Ranges;
use super::simpler::{numbers_given, simpler, with_numbers};
use super::squares::squared;
use super::witness::{decimals, values_at};
use expr::domain::{Nature, Parity, row};
use expr::{Expr, FastMap, FastSet, Graph, Leaf, Node, Op, Rational};
use number::Bounded;
use std::cmp::Ordering;
use std::collections::BTreeMap;

type Pairs = Vec<(Expr, Expr)>;

/// Points that are tried for a question of which only a proof is wanted.
pub(super) const FEW_POINTS: u32 = 12;
/// Questions within questions.
pub(super) const DEEPEST: u32 = 4;
/// Pairs of arguments that are compared.
const MOST_PAIRS: usize = 24;
/// Twice the multiples of a sum of angles that are looked at.
const MULTIPLES: [i64; 8] = [1, 2, 4, 6, 8, 10, 12, 24];
/// Cosines of multiples of π divided by this are known.
const PARTS_OF_PI: i64 = 60;
/// Larger problems, premises included, are left: each way asks several questions.
const MOST_NODES: usize = 250;
/// The same where a proof is one of many that are tried aside, without premises.
const MOST_ASIDE: usize = 64;
/// With more premises nothing is asked again.
const MOST_PREMISES: usize = 12;

/// What answers a question that was left open; `None` where nothing does.
pub(super) fn settle(
    memory: &mut Memory,
    graph: &mut Graph,
    equations: &[(Expr, Expr)],
    given: &Premises,
    (options, depth): (&Options, u32),
    reason: &Reason,
) -> Option<Identity> {
    let open = match reason {
        Reason::Branches { .. } | Reason::TooManyRoots(_) | Reason::NoPoint | Reason::Coincidence => true,
        Reason::Unsolved(_) | Reason::TooLarge | Reason::Bound(_) => true,
        Reason::Contradiction | Reason::NoValue | Reason::Degenerate | Reason::Boundary(_) | Reason::OnlyWhere(_) => {
            false
        }
        Reason::NoDerivative | Reason::Unextended | Reason::EachSign | Reason::Defect(_) => false,
    };
    if !open || depth >= DEEPEST {
        return None;
    }
    let sides = |equations: &[(Expr, Expr)]| -> Vec<Expr> { equations.iter().flat_map(|&(l, r)| [l, r]).collect() };
    let all: Vec<Expr> = sides(equations).into_iter().chain(given.sides()).collect();
    let count = given.equations.len();
    let most = match options.wanted {
        Wanted::Answer if count <= MOST_PREMISES => MOST_NODES,
        Wanted::Proof if count == 0 => MOST_ASIDE,
        Wanted::Answer | Wanted::Proof | Wanted::Fault => return None,
    };
    if graph.reachable(all).len() > most {
        return None;
    }
    if !options.further {
        return match identity_at(memory, graph, equations, given, &Options { further: true, ..*options }, depth) {
            Identity::Undecided(_) => None,
            settled @ (Identity::Proved(_) | Identity::Refuted(_)) => Some(settled),
        };
    }
    // Where they have values is asked of them as they are.
    let whole = equations;
    let equations: Pairs = equations.iter().map(|&(l, r)| (graph.unrestricted(l), graph.unrestricted(r))).collect();
    if let Some(found) = numbers(graph, &equations, whole, given) {
        return Some(found);
    }
    let known = numbers_given(graph, given);
    if let Some(put) = with_numbers(graph, whole, &known)
        && let Identity::Proved(mut proof) = identity_at(memory, graph, &put, &Premises::default(), options, depth + 1)
    {
        proof.example = None;
        let mut proof = finished(graph, whole, given, proof);
        proof.example = match known.len() == given.equations.len() && !has_signs(given) {
            true => point_of(graph, &known),
            false => seen(graph, whole, given, &proof, options),
        };
        return Some(Identity::Proved(proof));
    }
    // What else could be solved for is, now.
    let restricted = !given.equations.is_empty();
    if restricted && !given.parameters.is_empty() {
        let free = Premises { parameters: Vec::new(), ..given.clone() };
        match identity_at(memory, graph, whole, &free, options, depth + 1) {
            Identity::Proved(proof) => return Some(Identity::Proved(finished(graph, whole, given, proof))),
            refuted @ Identity::Refuted(_) => return Some(refuted),
            Identity::Undecided(_) => {}
        }
    }
    let mut related = Related { memory, graph, given, options, depth, proof: None };
    if related.all(&equations) {
        let proof = related.proof?;
        return Some(Identity::Proved(finished(graph, whole, given, proof)));
    }
    if let Some(of) = by_logarithms(graph, &equations, given)
        && let Identity::Proved(mut proof) = identity_at(memory, graph, &of.equations, &of.given, options, depth + 1)
    {
        proof.conditions = std::mem::take(&mut proof.conditions).into_iter().map(|c| of.said(graph, c)).collect();
        proof.example = None;
        let mut proof = finished(graph, whole, given, proof);
        proof.example = seen(graph, whole, given, &proof, options);
        return Some(Identity::Proved(proof));
    }
    if let Some(squares) = squared(graph, &equations, given)
        && let Identity::Proved(proof) = identity_at(memory, graph, &squares, given, options, depth + 1)
    {
        return Some(Identity::Proved(finished(graph, whole, given, proof)));
    }
    if let Some(simpler) = simpler(graph, given) {
        match identity_at(memory, graph, whole, &simpler, options, depth + 1) {
            Identity::Proved(proof) => return Some(Identity::Proved(proof)),
            refuted @ Identity::Refuted(_) => return Some(refuted),
            Identity::Undecided(_) => {}
        }
    }
    if let Some(refutation) = refutes(graph, whole, given, options) {
        return Some(Identity::Refuted(Box::new(refutation)));
    }
    let mut related = Related { memory, graph, given, options, depth, proof: None };
    let rewritten = related.with_equal_arguments(&equations)?;
    let so_far = related.proof;
    match identity_at(memory, graph, &rewritten, given, options, depth + 1) {
        Identity::Proved(mut proof) => {
            if let Some(other) = so_far {
                proof.absorb(other);
            }
            Some(Identity::Proved(finished(graph, whole, given, proof)))
        }
        // The formulas as given need not have values at the point.
        Identity::Refuted(_) | Identity::Undecided(_) => None,
    }
}

/// A proof from others: it holds where the formulas have values, and its example is one only where they do.
fn finished(graph: &mut Graph, equations: &[(Expr, Expr)], given: &Premises, mut proof: Proof) -> Proof {
    let sides: Vec<Expr> = equations.iter().flat_map(|&(l, r)| [l, r]).collect();
    proof.conditions.extend(undeclared(graph, &sides, given));
    proof.conditions.sort_unstable();
    proof.conditions.dedup();
    proof.example = proof.example.take().and_then(|mut point| {
        // What the questions that it rests on do not name is free.
        let free = given.equations.is_empty();
        let facts: Vec<Expr> = given.positive.iter().chain(&given.not_negative).copied().collect();
        for leaf in graph.leaves(sides.iter().chain(&facts).copied()).into_iter().filter(|_| free) {
            if !point.values.iter().any(|(l, _)| *l == leaf) {
                let half = Rational::ONE / Rational::from(2);
                point.values.push((leaf, PointValue { exact: Some(half), circle: None, decimal: 0.5, error: 0.0 }));
            }
        }
        let holds = decimals(graph, &facts, &values_at(&point)).iter().all(|v| v.is_some_and(|v| v.value > v.error));
        holds.then_some(point)
    });
    proof.example = proof.example.take().filter(|point| {
        let at = decimals(graph, &sides, &values_at(point));
        at.as_chunks().0.iter().all(|&[l, r]| match (l, r) {
            (Some(l), Some(r)) => (l.value - r.value).abs() <= 4.0 * (l.error + r.error),
            _ => false,
        })
    });
    proof
}

fn has_signs(given: &Premises) -> bool {
    !(given.nonzero.is_empty() && given.positive.is_empty() && given.not_negative.is_empty())
}

/// The point at which leaves have values that are given.
fn point_of(graph: &Graph, known: &[(Leaf, Expr)]) -> Option<Point> {
    let numbers: Vec<Expr> = known.iter().map(|(_, number)| *number).collect();
    let value = |((leaf, _), value): (&(Leaf, Expr), Option<Bounded>)| {
        let value = value?;
        Some((*leaf, PointValue { exact: None, circle: None, decimal: value.value, error: value.error }))
    };
    let decimals = decimals(graph, &numbers, &FastMap::default());
    Some(Point { values: known.iter().zip(decimals).map(value).collect::<Option<Vec<_>>>()? })
}

/// A point that satisfies what is given, where nothing of it moves and no field is named, outside of the special cases of a proof.
fn seen(
    graph: &mut Graph,
    equations: &[(Expr, Expr)],
    given: &Premises,
    proof: &Proof,
    options: &Options,
) -> Option<Point> {
    let premises: Pairs = given.pairs().collect();
    if !given.moving.is_empty() || premises.iter().any(|&pair| names_fields(graph, pair)) {
        return None;
    }
    let divided: Vec<Expr> = proof.conditions.iter().filter_map(|c| c.leaves_out()).collect();
    example(graph, equations, &premises, given, &divided, options).filter(|e| e.differs.is_none()).map(|e| e.point)
}

/// Numbers without premises; `whole` are the equations with what their sides are restricted to, which must have values.
fn numbers(
    graph: &mut Graph,
    equations: &[(Expr, Expr)],
    whole: &[(Expr, Expr)],
    given: &Premises,
) -> Option<Identity> {
    let sides: Vec<Expr> = equations.iter().flat_map(|&(l, r)| [l, r]).collect();
    let leaf = |&e: &Expr| matches!(graph.node(e), Node::Leaf(_));
    let free = given.equations.is_empty() && given.nonzero.is_empty();
    if !graph.leaves(sides.iter().copied()).is_empty()
        || !free
        || !given.positive.iter().all(leaf)
        || !given.not_negative.iter().all(leaf)
    {
        return None;
    }
    let mut open = false;
    for (at, (&(l, r), &(left, right))) in equations.iter().zip(whole).enumerate() {
        if decimals(graph, &[left, right], &FastMap::default()).iter().any(Option::is_none) {
            open = true;
            continue;
        }
        let difference = graph.sub(l, r);
        match algebraic::sign(graph, difference) {
            Some(Ordering::Equal) => {}
            Some(Ordering::Less | Ordering::Greater) => {
                let values = decimals(graph, &[l, r], &FastMap::default());
                let side = |at: usize| values[at].map(|v| Side { exact: None, decimal: v.value });
                let refutation = Refutation {
                    equation: at,
                    point: Point { values: Vec::new() },
                    named: Vec::new(),
                    left: side(0)?,
                    right: side(1)?,
                    second: None,
                };
                return Some(Identity::Refuted(Box::new(refutation)));
            }
            None => open = true,
        }
    }
    (!open).then(|| Identity::Proved(certain()))
}

/// A proof without random numbers.
fn certain() -> Proof {
    Proof {
        log2_error: Proof::CERTAIN,
        degree_bound: 0.0,
        height_bound: 0.0,
        trials: 0,
        primes: Vec::new(),
        signs: 0,
        cases: 1,
        conditions: Vec::new(),
        example: Some(Point { values: Vec::new() }),
    }
}

/// Of a function whose arguments are compared; what is algebraic is computed with.
fn parity(op: Op) -> Option<Parity> {
    match row(op).nature {
        Nature::Transcendental { parity, .. } => Some(parity),
        Nature::Algebraic(_) => None,
    }
}

/// What a factor of a term is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Angle,
    Logarithm,
    Other,
}

fn kind(graph: &Graph, e: Expr) -> Kind {
    match *graph.node(e) {
        Node::Pi | Node::Unary(Op::Arcsin | Op::Arccos | Op::Arctan, _) | Node::Binary(Op::Arctan2, ..) => Kind::Angle,
        Node::Unary(Op::Ln, _) => Kind::Logarithm,
        Node::Constant(_) | Node::Leaf(_) | Node::Unary(..) | Node::Binary(..) => Kind::Other,
    }
}

struct Related<'a> {
    memory: &'a mut Memory,
    graph: &'a mut Graph,
    given: &'a Premises,
    options: &'a Options,
    depth: u32,
    /// All that was proved on the way.
    proof: Option<Proof>,
}

impl Related<'_> {
    /// Whether an equation is proved, with these premises. What is false need not be refuted, so few points are tried.
    fn proves(&mut self, equation: (Expr, Expr), given: &Premises) -> bool {
        let options = Options { attempts: self.options.attempts.min(FEW_POINTS), ..*self.options };
        match identity_at(self.memory, self.graph, &[equation], given, &options, self.depth + 1) {
            Identity::Proved(proof) => {
                match &mut self.proof {
                    Some(all) => all.absorb(proof),
                    None => self.proof = Some(proof),
                }
                true
            }
            Identity::Refuted(_) | Identity::Undecided(_) => false,
        }
    }

    /// Whether all equations follow from relations between angles or logarithms.
    fn all(&mut self, equations: &[(Expr, Expr)]) -> bool {
        equations.iter().all(|&(l, r)| {
            let difference = self.graph.sub(l, r);
            let (top, _) = fraction(self.graph, difference);
            let sum = Combinations::default().of(self.graph, top);
            if sum.is_empty() {
                return true;
            }
            let sum = without_common(sum);
            self.vanishes(&sum)
                || groups(self.graph, &sum).is_some_and(|groups| {
                    groups.len() > 1 && groups.into_iter().all(|group| self.vanishes(&without_common(group)))
                })
                || self.proves_apart(l, r)
        })
    }

    /// One equation of several that needs nothing of this.
    fn proves_apart(&mut self, l: Expr, r: Expr) -> bool {
        let kinds = self.graph.reachable([l, r]);
        let plain = !kinds.iter().any(|&e| kind(self.graph, e) != Kind::Other);
        plain && self.depth + 1 < DEEPEST && {
            let given = self.given;
            self.proves((l, r), given)
        }
    }

    /// Whether a sum is 0, by its exponential or its cosine.
    fn vanishes(&mut self, sum: &Combination) -> bool {
        let (mut angles, mut logarithms) = (0, 0);
        for m in sum.keys() {
            if let &[(base, 1)] = m.as_slice() {
                match kind(self.graph, base) {
                    Kind::Angle => angles += 1,
                    Kind::Logarithm => logarithms += 1,
                    Kind::Other => {}
                }
            }
            let inside = m.iter().any(|&(base, _)| kind(self.graph, base) != Kind::Other);
            if inside && !matches!(m.as_slice(), &[(_, 1)]) {
                return false;
            }
        }
        match (angles, logarithms) {
            (0, 0) => false,
            (0, _) => self.by_exponential(sum),
            (_, 0) => self.by_cosine(sum),
            _ => false,
        }
    }

    /// e^{n·sum} = 1, with every uᵢ > 0 as its logarithm has a value.
    fn by_exponential(&mut self, sum: &Combination) -> bool {
        let Some(n) = common_denominator(sum.values()) else { return false };
        let mut given = self.given.clone();
        let one = self.graph.integer(1);
        let (mut above, mut below) = (one, one);
        let mut rest = self.graph.integer(0);
        for (m, q) in sum {
            let q = q * &n;
            let log = match m.as_slice() {
                &[(base, 1)] => match *self.graph.node(base) {
                    Node::Unary(Op::Ln, u) => Some(u),
                    Node::Constant(_) | Node::Pi | Node::Leaf(_) | Node::Unary(..) | Node::Binary(..) => None,
                },
                _ => None,
            };
            match (log, i32::try_from(q.clone())) {
                (Some(u), Ok(k)) if k.unsigned_abs() <= 64 => {
                    if self.graph.as_constant(u).is_none() {
                        given.positive.push(u);
                    }
                    let power = self.graph.powi(u, k.abs());
                    if k > 0 {
                        above = self.graph.mul(above, power);
                    } else {
                        below = self.graph.mul(below, power);
                    }
                }
                (Some(_), _) => return false,
                (None, _) => {
                    let term = expression(self.graph, m, &q);
                    rest = self.graph.add(rest, term);
                }
            }
        }
        let ranges = Ranges::new(self.graph, self.given);
        for e in [above, below] {
            self.note_signs(&ranges, e, &mut given);
        }
        if !self.graph.is_zero(rest) {
            let factor = self.graph.unary(Op::Exp, rest);
            above = self.graph.mul(above, factor);
        }
        self.proves((above, below), &given)
    }

    /// cos θ = 1 and |θ| < 2π, for a multiple θ of the sum.
    fn by_cosine(&mut self, sum: &Combination) -> bool {
        let pi: Monomial = vec![(self.graph.pi(), 1)];
        let Some(n) = common_denominator(sum.iter().filter(|(m, _)| **m != pi).map(|(_, q)| q)) else { return false };
        let common = sum.iter().filter(|(m, _)| **m != pi).fold(0, |common, (_, q)| {
            greatest_common_divisor(common, i64::try_from(q * &n).unwrap_or(1).unsigned_abs())
        });
        if common == 0 {
            return false;
        }
        let ranges = Ranges::new(self.graph, self.given);
        let mut tried = 0;
        // Halves of angles are algebraic, other parts are not; nor are all parts of π.
        for twice in MULTIPLES {
            let factor = &n / Rational::from(common) * Rational::from(twice) / Rational::from(2);
            let turns = sum.get(&pi).map_or(Rational::ZERO, |q| q * &factor);
            if tried == 3 || !(turns * Rational::from(PARTS_OF_PI)).is_int() {
                continue;
            }
            let mut angle = self.graph.integer(0);
            for (m, q) in sum {
                let term = expression(self.graph, m, &(q * &factor));
                angle = self.graph.add(angle, term);
            }
            let range = ranges.of(self.graph, angle).range();
            // A little less than 2π.
            if !(range.lo() > -6.27 && range.hi() < 6.27) {
                return false;
            }
            tried += 1;
            let mut given = self.given.clone();
            self.note_signs(&ranges, angle, &mut given);
            let cosine = self.graph.unary(Op::Cos, angle);
            let one = self.graph.integer(1);
            if self.proves((cosine, one), &given) {
                return true;
            }
        }
        false
    }

    /// The signs of cosines, sines and arguments below an angle, by their ranges.
    fn note_signs(&mut self, ranges: &Ranges, angle: Expr, given: &mut Premises) {
        for node in self.graph.reachable([angle]) {
            let argument = match *self.graph.node(node) {
                Node::Unary(Op::Cos | Op::Tan | Op::Sin, a) => a,
                Node::Unary(Op::Exp | Op::Sinh | Op::Cosh | Op::Tanh, a) => {
                    if ranges.of(self.graph, a).range().lo() >= 0.0 {
                        let (power, one) = (self.graph.unary(Op::Exp, a), self.graph.integer(1));
                        given.not_negative.push(self.graph.sub(power, one));
                    }
                    continue;
                }
                Node::Constant(_) | Node::Pi | Node::Leaf(_) | Node::Unary(..) | Node::Binary(..) => continue,
            };
            let range = ranges.of(self.graph, argument).range();
            // Beside the range, in numbers a little inside of π/2 and π, what is given as it stands: x < π/2.
            let (low, high) = self.in_half_turns(argument);
            let half = Rational::ONE / Rational::from(2);
            let at_least = |lo: f64, q: &Rational| range.lo() >= lo || low.as_ref().is_some_and(|l| l >= q);
            let at_most = |hi: f64, q: &Rational| range.hi() <= hi || high.as_ref().is_some_and(|h| h <= q);
            let known = [
                (Op::Cos, at_least(-1.57, &-half.clone()) && at_most(1.57, &half)),
                (Op::Sin, at_least(0.0, &Rational::ZERO) && at_most(3.13, &Rational::ONE)),
            ];
            for (op, holds) in known {
                if holds {
                    given.not_negative.push(self.graph.unary(op, argument));
                }
            }
        }
    }

    /// Bounds of an angle in multiples of π, where something given says so in these words.
    fn in_half_turns(&mut self, angle: Expr) -> (Option<Rational>, Option<Rational>) {
        let (mut low, mut high): (Option<Rational>, Option<Rational>) = (None, None);
        let own = Combinations::default().of(self.graph, angle);
        let pi: Monomial = vec![(self.graph.pi(), 1)];
        let Some((lead, q)) = own.iter().find(|(m, _)| **m != pi).map(|(m, q)| (m.clone(), q.clone())) else {
            return (low, high);
        };
        for &fact in self.given.positive.iter().chain(&self.given.not_negative) {
            let fact = Combinations::default().of(self.graph, fact);
            let Some(c) = fact.get(&lead) else { continue };
            // fact/|λ| = ±angle + kπ ≥ 0.
            let scale = c / &q;
            let all: FastSet<&Monomial> = fact.keys().chain(own.keys()).filter(|m| **m != pi).collect();
            let at = |sum: &Combination, m: &Monomial| sum.get(m).cloned().unwrap_or(Rational::ZERO);
            if all.into_iter().any(|m| at(&fact, m) != &scale * at(&own, m)) {
                continue;
            }
            let k = (at(&fact, &pi) - &scale * at(&own, &pi)) / &scale;
            if scale > Rational::ZERO {
                // angle + kπ ≥ 0.
                let bound = -k;
                low = Some(low.map_or(bound.clone(), |l| l.max(bound)));
            } else {
                // −(angle + kπ) ≥ 0.
                let bound = -k;
                high = Some(high.map_or(bound.clone(), |h| h.min(bound)));
            }
        }
        (low, high)
    }

    /// The equations with one node for functions of equal arguments; `None` where there are none.
    fn with_equal_arguments(&mut self, equations: &[(Expr, Expr)]) -> Option<Pairs> {
        let equations: &Pairs =
            &equations.iter().map(|&(l, r)| (without_powers(self.graph, l), without_powers(self.graph, r))).collect();
        let sides: Vec<Expr> = equations.iter().flat_map(|&(l, r)| [l, r]).collect();
        let premises: Vec<Expr> = self.given.sides().collect();
        let mut calls: BTreeMap<Op, Vec<(Expr, Expr)>> = BTreeMap::new();
        for node in self.graph.reachable(premises.into_iter().chain(sides.iter().copied())) {
            if let Node::Unary(op, a) = *self.graph.node(node)
                && parity(op).is_some()
            {
                calls.entry(op).or_default().push((node, a));
            }
        }
        let mut replacements: Vec<(Expr, Expr)> = Vec::new();
        let mut tried = 0;
        for (op, list) in calls {
            let parity = parity(op)?;
            for (i, &(later, v)) in list.iter().enumerate().skip(1) {
                let earlier = list[..i].to_vec();
                for (first, u) in earlier {
                    if replacements.iter().any(|&(from, _)| from == first) || tried >= MOST_PAIRS {
                        continue;
                    }
                    let opposite = self.graph.neg(u);
                    let choices = match parity {
                        Parity::Even => vec![(u, false), (opposite, false)],
                        Parity::Odd => vec![(u, false), (opposite, true)],
                        Parity::Neither => vec![(u, false)],
                    };
                    let given = self.given;
                    let equal = choices.into_iter().find(|&(u, _)| {
                        self.may_agree(u, v) && {
                            tried += 1;
                            self.proves((v, u), given)
                        }
                    });
                    let mut sizes = |related: &mut Self| {
                        let (uu, vv) = (related.graph.powi(u, 2), related.graph.powi(v, 2));
                        related.may_agree(uu, vv) && {
                            tried += 1;
                            related.proves((vv, uu), given)
                        }
                    };
                    let new = match equal {
                        Some((_, true)) => self.graph.neg(first),
                        Some((_, false)) => first,
                        None if parity == Parity::Even && sizes(self) => first,
                        None => continue,
                    };
                    replacements.push((later, new));
                    break;
                }
            }
        }
        if replacements.is_empty() {
            return None;
        }
        // Inner ones first: what stands in them is older.
        replacements.sort_unstable();
        let mut out: Pairs = equations.to_vec();
        for (from, to) in replacements.into_iter().rev() {
            for (l, r) in &mut out {
                (*l, *r) = (replaced(self.graph, *l, from, to), replaced(self.graph, *r, from, to));
            }
        }
        Some(out)
    }

    /// Whether two expressions agree at real points: those that certainly differ somewhere are told apart quickly, where no
    /// equation restricts the points.
    fn may_agree(&mut self, u: Expr, v: Expr) -> bool {
        if !self.given.equations.is_empty() {
            return true;
        }
        let leaves = self.graph.leaves([u, v]);
        let positive: FastSet<Expr> = self.given.positive.iter().copied().collect();
        for point in 0..6u32 {
            let mut values = super::witness::Values::default();
            for (i, &leaf) in leaves.iter().enumerate() {
                let e = self.graph.leaf(leaf);
                let steps = [0.375, 1.25, 2.5, 0.625, 1.75, 0.875, 3.25, 0.5];
                let size = steps[(3 * i + 5 * point as usize) % steps.len()] + 0.03125 * i as f64;
                let negative = !positive.contains(&e) && (i as u32 + point) % 3 == 1;
                values.insert(leaf, Bounded::exact(if negative { -size } else { size }));
            }
            let facts: Vec<Expr> = self.given.positive.iter().chain(&self.given.not_negative).copied().collect();
            let admitted = decimals(self.graph, &facts, &values);
            if !admitted.iter().all(|v| v.is_some_and(|v| v.value >= -v.error)) {
                continue;
            }
            if let &[Some(x), Some(y)] = decimals(self.graph, &[u, v], &values).as_slice()
                && (x.value - y.value).abs() > 4.0 * (x.error + y.error)
            {
                return false;
            }
        }
        true
    }
}

/// Powers as exponentials.
fn without_powers(graph: &mut Graph, e: Expr) -> Expr {
    let mut out = e;
    for node in graph.reachable([e]) {
        if let Node::Binary(Op::Pow, a, b) = *graph.node(node) {
            let log = graph.unary(Op::Ln, a);
            let argument = graph.mul(b, log);
            let power = graph.unary(Op::Exp, argument);
            out = replaced(graph, out, node, power);
        }
    }
    out
}

/// The sum divided by what all its terms have in common: if what is left is 0, so is the sum.
fn without_common(sum: Combination) -> Combination {
    let Some(first) = sum.keys().next() else { return sum };
    let mut common: Monomial = first.clone();
    for m in sum.keys() {
        for (base, power) in &mut common {
            *power = (*power).min(m.iter().find(|(b, _)| b == base).map_or(0, |&(_, n)| n));
        }
    }
    common.retain(|&(_, power)| power > 0);
    if common.is_empty() || sum.len() == 1 {
        return sum;
    }
    let inverse: Monomial = common.iter().map(|&(base, power)| (base, -power)).collect();
    let divided: Option<Combination> =
        sum.iter().map(|(m, q)| Some((super::linear::times(m, &inverse)?, q.clone()))).collect();
    divided.unwrap_or(sum)
}

/// The sum by the factors of its terms that are neither angles nor logarithms; `None` where a term has several of these.
fn groups(graph: &Graph, sum: &Combination) -> Option<Vec<Combination>> {
    let mut out: BTreeMap<Monomial, Combination> = BTreeMap::new();
    for (m, q) in sum {
        let (special, factor): (Monomial, Monomial) =
            m.iter().partition(|&&(base, _)| kind(graph, base) != Kind::Other);
        if special.len() > 1 || special.iter().any(|&(_, k)| k != 1) {
            return None;
        }
        out.entry(factor).or_default().insert(special, q.clone());
    }
    Some(out.into_values().collect())
}

fn greatest_common_divisor(a: u64, b: u64) -> u64 {
    if b == 0 { a } else { greatest_common_divisor(b, a % b) }
}

/// The least common denominator, if it is small.
fn common_denominator<'r>(all: impl Iterator<Item = &'r Rational>) -> Option<Rational> {
    let mut n = Rational::ONE;
    for q in all {
        let mut k = 1;
        while !(q * &n * Rational::from(k)).is_int() {
            k += 1;
            if k > 64 {
                return None;
            }
        }
        n *= Rational::from(k);
    }
    Some(n)
}
