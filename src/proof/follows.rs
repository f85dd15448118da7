//! Signs that follow from what is given: a condition that is met wherever the premises hold need not be told.
//!
//! **In:** premises, an expression, and the sign that it is to have. **Out:** whether it has this sign wherever the premises hold and it has
//! a value. **How:** explicit definitions are put in; of a fraction each factor has a sign. A sum has one if it is written as
//! Σ μᵢ·fᵢ + Σ qⱼ·mⱼ with facts fᵢ that are given, with their products, with bounds of functions that they name, and with multipliers μᵢ and terms qⱼ·mⱼ that are not
//! negative by their factors: c² − v² is (c − v)·(c + v). **Guaranteed:** a yes is such a sum, whose terms are added up exactly; the search is bounded, and
//! a no says nothing.

use super::linear::{Combination, Combinations, Monomial, add_to, product, times};
use super::outcome::Premises;
use super::polynomial::{fraction, primitive};
use expr::domain::Sign;
use expr::{Expr, FastMap, FastSet, Graph, Leaf, Node, Op, Rational};
use std::collections::BTreeMap;

/// Rounds in which definitions are put in.
const MOST_ROUNDS: usize = 6;
/// Largest formula that is looked at, in nodes, with its definitions put in.
const MOST_NODES: usize = 200;
/// Most facts, with their products.
const MOST_FACTS: usize = 64;
/// Most facts that are added up.
const MOST_TERMS: usize = 3;
/// Most sums that are looked at for one expression and number of facts.
const MOST_SUMS: usize = 1_000;

/// How far something is known from below 0.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Least {
    Zero,
    AboveZero,
}

/// What is known not to be negative.
struct Fact {
    sum: Combination,
    least: Least,
}

/// The multipliers by which a term of a fact is a term, or half of it: c² + vw is half of (c + v)·(c + w) and of (c − v)·(c − w).
fn multiples(fact: &Combination, (monomial, coefficient): (&Monomial, &Rational)) -> Vec<(Monomial, Rational)> {
    let mut out = Vec::new();
    for (m, q) in fact {
        let inverse: Monomial = m.iter().map(|&(base, n)| (base, -n)).collect();
        let factor = coefficient / q;
        if factor > Rational::ZERO
            && let Some(multiplier) = times(monomial, &inverse)
        {
            let half = &factor / Rational::from(2);
            out.extend([(multiplier.clone(), factor), (multiplier, half)]);
        }
    }
    out
}

/// Whether an expression has a sign wherever the premises hold and it has a value.
pub fn follows(graph: &mut Graph, given: &Premises, value: Expr, sign: Sign) -> bool {
    let mut search = Search::of(graph, given);
    let Some(value) = search.put_in(graph, value) else { return false };
    search.add_bounds(graph, value);
    search.add_products();
    search.has(graph, value, sign)
}

/// A number and the factors of an expression; of each how often it stands there, and whether something is divided by it: it is not 0 where
/// there is a value.
fn factors_of(graph: &mut Graph, value: Expr) -> (Rational, BTreeMap<Expr, (i32, bool)>) {
    let (top, under) = fraction(graph, value);
    let (mut number, mut out) = (Rational::ONE, BTreeMap::new());
    for (of, outer) in [(top, 1), (under, -1)] {
        let (q, factors) = primitive(graph, of);
        number *= q;
        for (base, k) in factors {
            let (n, divides) = out.entry(base).or_insert((0i32, false));
            *n = n.saturating_add(k.saturating_mul(outer));
            *divides |= (k < 0) != (outer < 0);
        }
    }
    (number, out)
}

struct Search {
    definitions: FastMap<Leaf, Expr>,
    facts: Vec<Fact>,
    /// Expressions of known sign.
    known: FastMap<Expr, Least>,
    nonzero: FastSet<Expr>,
    sums: usize,
}

impl Search {
    fn of(graph: &mut Graph, given: &Premises) -> Search {
        let mut definitions = FastMap::default();
        for (left, right) in given.pairs() {
            if let Node::Leaf(leaf) = *graph.node(left) {
                definitions.entry(leaf).or_insert(right);
            }
        }
        let empty = (FastMap::default(), FastSet::default());
        let mut out = Search { definitions, facts: Vec::new(), known: empty.0, nonzero: empty.1, sums: 0 };
        let each = given.positive.iter().map(|e| (e, Least::AboveZero));
        for (&e, least) in each.chain(given.not_negative.iter().map(|e| (e, Least::Zero))) {
            if let Some(e) = out.put_in(graph, e) {
                out.learn(graph, e, least);
            }
        }
        for &e in &given.nonzero {
            out.nonzero.extend(out.put_in(graph, e));
        }
        out
    }

    /// An expression with the definitions of what it names.
    fn put_in(&self, graph: &mut Graph, e: Expr) -> Option<Expr> {
        let mut out = e;
        for _ in 0..MOST_ROUNDS {
            let next = graph.rewrite(out, |_, leaf| self.definitions.get(&leaf).copied());
            if graph.reachable([next]).len() > MOST_NODES {
                return None;
            }
            if next == out {
                return Some(out);
            }
            out = next;
        }
        None
    }

    fn learn(&mut self, graph: &Graph, e: Expr, least: Least) {
        let known = self.known.entry(e).or_insert(least);
        *known = (*known).max(least);
        let sum = Combinations::default().of(graph, e);
        // A letter by itself is known as a factor.
        if !matches!(graph.node(e), Node::Leaf(_)) && self.facts.len() < MOST_FACTS {
            self.facts.push(Fact { sum, least });
        }
    }

    /// What functions say of themselves: sizes that are at most 1.
    fn add_bounds(&mut self, graph: &mut Graph, value: Expr) {
        let one = graph.integer(1);
        let facts: Vec<Expr> = self.known.keys().copied().collect();
        for node in graph.reachable(facts.into_iter().chain([value])) {
            if let Node::Unary(Op::Sin | Op::Cos | Op::Tanh, _) = *graph.node(node) {
                for bound in [graph.sub(one, node), graph.add(one, node)] {
                    self.learn(graph, bound, Least::Zero);
                }
            }
        }
    }

    /// Products of two facts.
    fn add_products(&mut self) {
        let own = self.facts.len();
        for i in 0..own {
            for k in i..own {
                if self.facts.len() >= MOST_FACTS {
                    return;
                }
                if let Some(sum) = product(&self.facts[i].sum, &self.facts[k].sum) {
                    let least = self.facts[i].least.min(self.facts[k].least);
                    self.facts.push(Fact { sum, least });
                }
            }
        }
    }

    /// Whether an expression has a sign, by the signs of its factors.
    fn has(&mut self, graph: &mut Graph, value: Expr, sign: Sign) -> bool {
        let (mut is_positive, mut least) = (true, Least::AboveZero);
        let (q, factors) = factors_of(graph, value);
        if q == Rational::ZERO {
            return false;
        }
        is_positive ^= q < Rational::ZERO;
        for (base, (k, divides)) in factors {
            let is_even = k % 2 == 0;
            match self.sign_of(graph, base) {
                Some((up, found)) => {
                    is_positive ^= !up && !is_even;
                    least = least.min(if divides { Least::AboveZero } else { found });
                }
                None if is_even && (divides || self.nonzero.contains(&base)) => {}
                None if is_even => least = Least::Zero,
                None if sign == Sign::NotZero && (divides || self.nonzero.contains(&base)) => {}
                None => return false,
            }
        }
        match sign {
            Sign::NotZero => least == Least::AboveZero,
            Sign::Positive => is_positive && least == Least::AboveZero,
            Sign::NotNegative => is_positive,
        }
    }

    /// Whether an expression is not negative, or its opposite is not; and whether it can be 0.
    fn sign_of(&mut self, graph: &Graph, e: Expr) -> Option<(bool, Least)> {
        if let Some(least) = self.of_factor(graph, e) {
            return Some((true, least));
        }
        let sum = Combinations::default().of(graph, e);
        let opposite: Combination = sum.iter().map(|(m, q)| (m.clone(), -q.clone())).collect();
        let mut found = None;
        // Short sums first.
        for terms in 0..=MOST_TERMS {
            for (is_positive, sum) in [(true, &sum), (false, &opposite)] {
                self.sums = 0;
                if let Some(least) = self.least(graph, sum, Least::Zero, terms) {
                    found = found.max(Some((least, is_positive)));
                }
            }
            if let Some((Least::AboveZero, _)) = found {
                break;
            }
        }
        found.map(|(least, is_positive)| (is_positive, least))
    }

    /// What is known of a sum to which something was added that is at least this; the best of what is found.
    fn least(&mut self, graph: &Graph, sum: &Combination, before: Least, terms: usize) -> Option<Least> {
        self.sums += 1;
        if self.sums > MOST_SUMS {
            return None;
        }
        let of_term = |(m, q): (&Monomial, &Rational)| (*q > Rational::ZERO).then(|| self.of_monomial(graph, m))?;
        let Some((monomial, coefficient)) = sum.iter().find(|&term| of_term(term).is_none()) else {
            return Some(sum.iter().filter_map(of_term).fold(before, Ord::max));
        };
        if terms == 0 {
            return None;
        }
        let mut best = None;
        for at in 0..self.facts.len() {
            let fact = &self.facts[at];
            let multiples = multiples(&fact.sum, (monomial, coefficient));
            for (multiplier, factor) in multiples {
                let Some(of_multiplier) = self.of_monomial(graph, &multiplier) else { continue };
                let fact = &self.facts[at];
                let mut rest = sum.clone();
                let mut is_whole = true;
                for (m, q) in &fact.sum {
                    match times(m, &multiplier) {
                        Some(m) => add_to(&mut rest, m, -(q * &factor)),
                        None => is_whole = false,
                    }
                }
                let with = before.max(fact.least.min(of_multiplier));
                if is_whole && let Some(found) = self.least(graph, &rest, with, terms - 1) {
                    best = best.max(Some(found));
                    if found == Least::AboveZero {
                        return best;
                    }
                }
            }
        }
        best
    }

    /// What is known of a product by its factors; nothing where it may be negative.
    fn of_monomial(&self, graph: &Graph, monomial: &Monomial) -> Option<Least> {
        let mut least = Least::AboveZero;
        for &(base, n) in monomial {
            let found = match self.of_factor(graph, base) {
                Some(found) => found,
                None if n % 2 == 0 && self.nonzero.contains(&base) => Least::AboveZero,
                None if n % 2 == 0 => Least::Zero,
                None => return None,
            };
            // A multiplier must have a value.
            if n < 0 && found != Least::AboveZero {
                return None;
            }
            least = least.min(found);
        }
        Some(least)
    }

    /// What is known of a factor by itself.
    fn of_factor(&self, graph: &Graph, e: Expr) -> Option<Least> {
        let node = graph.node(e);
        let by_form = if let Node::Constant(q) = node {
            (**q > Rational::ZERO).then_some(Least::AboveZero)
        } else if let Node::Pi | Node::Unary(Op::Exp | Op::Cosh, _) = node {
            Some(Least::AboveZero)
        } else if let Node::Unary(Op::Sqrt | Op::Abs, _) = node {
            Some(Least::Zero)
        } else {
            None
        };
        by_form.max(self.known.get(&e).copied())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use expr::Shape;

    fn letters<const N: usize>(g: &mut Graph, names: [&str; N]) -> [Expr; N] {
        names.map(|name| {
            let symbol = g.declare(name, Shape::scalar(), false);
            g.leaf(Leaf::now(symbol, 0))
        })
    }

    #[test]
    fn a_difference_of_squares_has_the_sign_of_its_factors() {
        let mut g = Graph::new();
        let [v, w, c] = letters(&mut g, ["v", "w", "c"]);
        let [below, above] = [g.sub(c, v), g.add(c, v)];
        let [beyond, over] = [g.sub(c, w), g.add(c, w)];
        let [c2, v2] = [c, v].map(|e| g.powi(e, 2));
        let radicand = g.sub(c2, v2);
        let mut given = Premises { positive: vec![c, below], ..Premises::default() };
        assert!(!follows(&mut g, &given, radicand, Sign::NotNegative), "v may be below -c");
        given.positive.push(above);
        assert!(follows(&mut g, &given, radicand, Sign::Positive));
        let opposite = g.neg(radicand);
        assert!(!follows(&mut g, &given, opposite, Sign::NotNegative));
        assert!(follows(&mut g, &given, opposite, Sign::NotZero));
        given.not_negative.extend([beyond, over]);
        let [vw, sum] = [g.mul(v, w), g.add(v, w)];
        let [ratio, one] = [g.div(vw, c2), g.integer(1)];
        let under = g.add(one, ratio);
        assert!(follows(&mut g, &given, under, Sign::NotNegative));
        let u = g.div(sum, under);
        let share = g.div(u, c);
        let [top, bottom] = [g.add(one, share), g.sub(one, share)];
        let quotient = g.div(top, bottom);
        assert!(!follows(&mut g, &given, top, Sign::Positive), "w may be -c");
        given.positive.extend([beyond, over]);
        assert!(follows(&mut g, &given, under, Sign::Positive));
        assert!(follows(&mut g, &given, quotient, Sign::Positive));
    }

    #[test]
    fn what_is_defined_is_put_in_and_functions_are_bounded() {
        let mut g = Graph::new();
        let [h, m, q, rate] = letters(&mut g, ["h", "m", "q", "r"]);
        let cos = g.unary(Op::Cos, q);
        let [potential, kinetic] = [g.mul(m, cos), g.powi(rate, 2)];
        let energy = g.sub(kinetic, potential);
        let sum = g.add(m, h);
        let mut given = Premises { positive: vec![m], ..Premises::default() };
        assert!(!follows(&mut g, &given, sum, Sign::NotNegative));
        given.give([(h, energy)], super::super::When::Always);
        assert!(follows(&mut g, &given, sum, Sign::NotNegative));
        assert!(!follows(&mut g, &given, sum, Sign::Positive), "at rest, at the lowest place");
        given.positive.clear();
        assert!(!follows(&mut g, &given, sum, Sign::NotNegative));
    }
}
