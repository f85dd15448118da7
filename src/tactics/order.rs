//! Order: relations <, ≤ and ≠ by the rules of signs, once a difference is written so that they see its sign.
//!
//! **In:** a difference v, and facts of which the signs are known. **Out:** v < 0, v ≤ 0 or v ≠ 0 as a fact; or nothing. **How:** v = −F, where F is a product of what is known to have a sign and of a
//! sum of squares (squares are completed, one indeterminate after the other); or a multiple of such a product and a sum of squares. A difference of two sizes a − b is that of their squares, over a + b. Whether F has the
//! sign, the checker says; and whether v = −F.

use crate::fraction::fraction;
use crate::prove::Attempt;
use crate::ring::{Monomial, Polynomial, Ring, add, divides, ratio};
use checker::{FactId, Law, Relation, Sense, Step, Term};
use expr::{Expr, Graph, Node, Op, Rational};

/// Most differences of known sign that are looked at.
const MOST_KNOWN: usize = 10;
/// Most terms of a polynomial that is looked at, and most products of terms in all.
const MOST_TERMS: usize = 200;
const MOST_PRODUCTS: usize = 60_000;
/// Most forms of one difference.
const MOST_FORMS: usize = 60;
/// Largest difference, in nodes.
const LARGEST: usize = 200;

/// p/w, where w divides p.
fn quotient(ring: &Ring, p: &Polynomial, w: &Polynomial) -> Option<Polynomial> {
    let (lead, before) = w.last_key_value()?;
    let (mut rest, mut out) = (p.clone(), Polynomial::new());
    for _ in 0..MOST_TERMS {
        let Some((m, r)) = rest.last_key_value().map(|(m, r)| (*m, r.clone())) else { return Some(out) };
        if !divides(lead, &m) {
            return None;
        }
        let (factor, r) = (ratio(&m, lead), r / before.clone());
        for (n, s) in w {
            add(&mut rest, ring.product(&factor, n)?, -(r.clone() * s.clone()));
        }
        add(&mut out, factor, r);
    }
    None
}

/// A difference that is written anew: −v, and the multiples of laws by which it is so.
struct Form {
    opposite: Expr,
    laws: Vec<(FactId, Expr)>,
}

impl Attempt<'_> {
    /// A claim l < r, l ≤ r or l ≠ r.
    pub(crate) fn ordered(&mut self, claim: &Relation) -> Option<FactId> {
        let says = self.search.draft.claim_says()?;
        let (left, right) = self.search.reader.sides(&says)?;
        let known = self.of_known_sign();
        let plain = self.search.push(Step::Sign { says: claim.clone(), from: known.clone() });
        if plain.is_some() {
            return plain;
        }
        let difference = self.search.reader.graph.sub(left, right);
        let fact = self.signed(difference, claim.sense, &known)?;
        self.search.push(Step::Sign { says: claim.clone(), from: vec![fact] })
    }

    /// Facts that say a sign: what is assumed, and what is needed by what has a value.
    pub(crate) fn of_known_sign(&mut self) -> Vec<FactId> {
        let mut out = self.assumptions.clone();
        out.extend(self.values_throughout());
        for at in 0..self.sequent.assumed.len() as u32 {
            out.extend(self.values_of(checker::Given::Assumed(at)));
        }
        let of_claim = 0..self.search.draft.claim_needs().len() as u32;
        for need in of_claim {
            out.extend(self.search.push(Step::ClaimHasValue { need, within: checker::When::Chosen }));
        }
        out.retain(|&id| self.search.draft.says(id).is_some_and(|says| says.sense != Sense::Equal));
        out.truncate(MOST_KNOWN);
        out
    }

    /// v < 0, v ≤ 0 or v ≠ 0.
    pub(crate) fn signed(&mut self, v: Expr, sense: Sense, known: &[FactId]) -> Option<FactId> {
        let relation =
            |this: &Self, e: Expr| Some(Relation { left: this.search.reader.term(e)?, sense, right: Term::integer(0) });
        let says = relation(self, v)?;
        let plain = self.search.push(Step::Sign { says: says.clone(), from: known.to_vec() });
        if plain.is_some() || self.search.reader.graph.reachable([v]).len() > LARGEST {
            return plain;
        }
        for Form { opposite, laws } in self.forms(v, known) {
            let form = self.search.reader.graph.neg(opposite);
            let Some(sign) = self.search.push(Step::Sign { says: relation(self, form)?, from: known.to_vec() }) else {
                continue;
            };
            let equation = self.search.reader.equation(form, v)?;
            let before = std::mem::take(&mut self.search.solved);
            let same = self.search.zero(equation, None, &laws, &[]);
            self.search.solved = before;
            let Some(same) = same else { continue };
            let found = self.search.push(Step::Congruence { says: says.clone(), from: Some(sign), equal: vec![same] });
            if found.is_some() {
                return found;
            }
        }
        None
    }

    /// Ways to write −v.
    fn forms(&mut self, v: Expr, known: &[FactId]) -> Vec<Form> {
        let factors = self.of_positive_sign(known);
        let graph = &mut self.search.reader.graph;
        let opposite = graph.neg(v);
        let plain = over_squares(graph, opposite, &factors).into_iter();
        let mut out: Vec<Form> = plain.map(|opposite| Form { opposite, laws: Vec::new() }).collect();
        // a − b = (a² − b²)/(a + b)
        if let Node::Binary(Op::Sub, b, a) = *self.search.reader.graph.node(v) {
            let [(aa, of_a), (bb, of_b)] = [a, b].map(|e| self.square(e));
            if of_a.is_some() || of_b.is_some() {
                let graph = &mut self.search.reader.graph;
                let (one, squares, sum) = (graph.integer(1), graph.sub(aa, bb), graph.add(a, b));
                let factor = graph.div(one, sum);
                let minus = graph.neg(factor);
                let laws: Vec<_> =
                    of_a.map(|law| (law, factor)).into_iter().chain(of_b.map(|law| (law, minus))).collect();
                for e in over_squares(graph, squares, &factors) {
                    out.push(Form { opposite: graph.div(e, sum), laws: laws.clone() });
                }
            }
        }
        out
    }

    /// The square of an expression; of a size, without it, and the law that says so.
    fn square(&mut self, e: Expr) -> (Expr, Option<FactId>) {
        let node = self.search.reader.graph.node(e);
        let (mut law, mut inner) = (None, e);
        if let Node::Unary(Op::Abs, u) = *node {
            (law, inner) = (Some(Law::SquareOfAbsolute), u);
        }
        if let Node::Unary(Op::Sqrt, u) = *node {
            (law, inner) = (Some(Law::SquareOfRoot), u);
        }
        match law.and_then(|law| self.search.law(law, &[inner])) {
            Some((fact, _, right)) => (right, Some(fact)),
            None => (self.search.reader.graph.powi(e, 2), None),
        }
    }

    /// Differences that facts say to be positive, or not negative, or not 0.
    fn of_positive_sign(&mut self, known: &[FactId]) -> Vec<Factor> {
        let (mut seen, mut out) = (Vec::new(), Vec::new());
        for &id in known {
            let Some(says) = self.search.draft.says(id) else { continue };
            let Some((l, r)) = self.search.reader.sides(&says) else { continue };
            let graph = &mut self.search.reader.graph;
            let difference = match says.sense {
                Sense::Less | Sense::LessOrEqual => graph.sub(r, l),
                Sense::NotEqual => graph.sub(l, r),
                Sense::Equal => continue,
            };
            if seen.contains(&difference) || graph.reachable([difference]).len() > LARGEST {
                continue;
            }
            seen.push(difference);
            out.extend(Factor::of(graph, difference));
        }
        out
    }
}

/// What is known to have a sign, without quotients.
struct Factor {
    /// A difference, times its denominator, or the square of it.
    written: Expr,
    /// The same as a polynomial.
    polynomial: Expr,
}

impl Factor {
    fn of(graph: &mut Graph, difference: Expr) -> Vec<Factor> {
        let Some(f) = fraction(graph, difference) else { return Vec::new() };
        if f.is_whole() {
            return vec![Factor { written: difference, polynomial: f.numerator }];
        }
        let under = f.denominator(graph);
        let square = graph.powi(under, 2);
        let polynomials = [f.numerator, graph.mul(f.numerator, under)];
        let written = [graph.mul(difference, under), graph.mul(difference, square)];
        written.into_iter().zip(polynomials).map(|(written, polynomial)| Factor { written, polynomial }).collect()
    }
}

/// Ways to write a quotient, over its denominator or the square of it.
fn over_squares(graph: &mut Graph, e: Expr, factors: &[Factor]) -> Vec<Expr> {
    let Some(f) = fraction(graph, e) else { return Vec::new() };
    let under = f.denominator(graph);
    let (whole, square) = (graph.mul(f.numerator, under), graph.powi(under, 2));
    let mut out = Vec::new();
    for (top, under) in [(f.numerator, under), (whole, square)] {
        for e in rewritten(graph, top, factors) {
            out.push(graph.div(e, under));
        }
    }
    out
}

/// Ways to write a polynomial in which its sign may be seen.
fn rewritten(graph: &mut Graph, e: Expr, factors: &[Factor]) -> Vec<Expr> {
    let roots: Vec<Expr> = factors.iter().map(|w| w.polynomial).chain([e]).collect();
    let Some(ring) = Ring::of(graph, &roots) else { return Vec::new() };
    let mut work = MOST_PRODUCTS;
    let Some(p) = ring.read(graph, e, &mut work).filter(|p| !p.is_empty() && p.len() <= MOST_TERMS) else {
        return Vec::new();
    };
    let read = |graph: &Graph, w: &Factor, work: &mut usize| {
        Some((w.written, ring.read(graph, w.polynomial, work).filter(|w| w.len() > 1 && w.len() <= MOST_TERMS)?))
    };
    let known: Vec<(Expr, Polynomial)> = factors.iter().filter_map(|w| read(graph, w, &mut work)).collect();
    let mut out = Vec::new();
    // As a product.
    let (mut product, mut rest) = (graph.integer(1), p.clone());
    for (w, polynomial) in &known {
        while let Some(q) = quotient(&ring, &rest, polynomial) {
            (product, rest) = (graph.mul(product, *w), q);
        }
    }
    let squares = sum_of_squares(graph, &ring, rest, &mut work);
    out.extend(squares.map(|squares| graph.mul(product, squares)));
    let squares = sum_of_squares(graph, &ring, p.clone(), &mut work);
    out.extend(squares);
    // As a product of what all terms have, and the sum of a multiple of what is known and of squares.
    let Some(common) = ring.content(&p) else { return out };
    let p: Polynomial = p.into_iter().map(|(m, r)| (ratio(&m, &common), r)).collect();
    let common = ring.write(graph, &[(common, Rational::ONE)]);
    let mut products = known.clone();
    for (at, (v, of_v)) in known.iter().enumerate() {
        for (w, of_w) in &known[at..] {
            let both = graph.mul(*v, *w);
            products.extend(ring.times(of_v, of_w, &mut work).map(|polynomial| (both, polynomial)));
        }
    }
    for (g, polynomial) in products {
        let mut multiples: Vec<Rational> =
            polynomial.iter().filter_map(|(m, r)| Some(p.get(m)?.clone() / r.clone())).collect();
        multiples.sort();
        multiples.dedup();
        for multiple in multiples.into_iter().filter(|r| *r > Rational::ZERO) {
            let mut rest = p.clone();
            polynomial.iter().for_each(|(m, r)| add(&mut rest, *m, -(multiple.clone() * r.clone())));
            let Some(squares) = sum_of_squares(graph, &ring, rest, &mut work) else { continue };
            let number = graph.constant(multiple);
            let term = graph.mul(number, g);
            let sum = graph.add(term, squares);
            out.push(graph.mul(common, sum));
            if out.len() >= MOST_FORMS {
                return out;
            }
        }
    }
    out
}

/// A polynomial as a sum of squares and of what is left: c·x² + b·x + d = c·(x + b/2c)² + (d − b²/4c) for one indeterminate after the other.
fn sum_of_squares(graph: &mut Graph, ring: &Ring, mut p: Polynomial, work: &mut usize) -> Option<Expr> {
    let mut sum = graph.integer(0);
    for place in ring.places() {
        let of_power = |p: &Polynomial, n: u8| -> Polynomial {
            p.iter().filter(|(m, _)| m[place] == n).map(|(m, r)| (*m, r.clone())).collect()
        };
        let (second, first) = (of_power(&p, 2), of_power(&p, 1));
        let x = ring.variable(place);
        let square = ring.times(&x, &x, work)?;
        let is_square = second.len() == 1 && second.keys().eq(square.keys());
        let Some(c) = second.values().next().filter(|c| is_square && **c > Rational::ZERO).cloned() else { continue };
        if first.is_empty() || p.keys().any(|m| m[place] > 2) {
            continue;
        }
        let b = quotient(ring, &first, &x)?;
        let half = Rational::ONE / (Rational::from(2) * c.clone());
        let mut root = x;
        b.into_iter().for_each(|(m, r)| add(&mut root, m, r * half.clone()));
        for (m, r) in ring.times(&root, &root, work)? {
            add(&mut p, m, -(r * c.clone()));
        }
        let terms: Vec<(Monomial, Rational)> = root.into_iter().collect();
        let (number, root) = (graph.constant(c), ring.write(graph, &terms));
        let root = graph.powi(root, 2);
        let term = graph.mul(number, root);
        sum = graph.add(sum, term);
    }
    let rest: Vec<(Monomial, Rational)> = p.into_iter().collect();
    let rest = ring.write(graph, &rest);
    Some(graph.add(sum, rest))
}
