//! Sums of logarithms, and exponentials of parts of them.
//!
//! **In:** a claim whose sides differ by a sum of whole multiples of logarithms. **Out:** its proof: the logarithm of a product is the sum of those of its factors, and the two products are equal; or nothing.

use crate::fraction::fraction;
use crate::prove::Attempt;
use crate::ring::{Polynomial, Ring, ratio};
use checker::{FactId, Law, Relation, Step};
use expr::{Expr, Node, Op, Rational};

/// Most factors of a product.
const MOST_FACTORS: usize = 12;
/// Most products of terms.
const MOST_PRODUCTS: usize = 4_000;

impl Attempt<'_> {
    /// The claim, if its sides differ by Σ nᵢ·ln aᵢ, and Π aᵢ^nᵢ is 1.
    pub(crate) fn by_logarithms(&mut self, claim: &Relation, goal: Expr) -> Option<FactId> {
        let (mut left, mut right) = (Vec::new(), Vec::new());
        let number = self.parts_of_logarithm(goal, &mut left, &mut right)?;
        self.search.solved.clear();
        let [(first, of_first), (second, of_second)] = [left, right].map(|factors| self.logarithm_of_product(&factors));
        let (first, second) = (first?, second?);
        let says = self.search.reader.equation(first, second)?;
        let equal = self.search.zero(says, None, &[], &[])?;
        let graph = &mut self.search.reader.graph;
        let logarithms = [first, second].map(|e| graph.unary(Op::Ln, e));
        let says = self.search.reader.equation(logarithms[0], logarithms[1])?;
        let same = self.search.push(Step::Congruence { says, from: None, equal: vec![equal] })?;
        // goal = Σ − Σ', ln P − Σ = 0, ln Q − Σ' = 0, ln P − ln Q = 0
        let graph = &mut self.search.reader.graph;
        let [plus, minus] = [number.clone(), -number].map(|r| graph.constant(r));
        let mut terms = vec![(same, plus)];
        terms.extend(of_first.into_iter().map(|fact| (fact, minus)));
        terms.extend(of_second.into_iter().map(|fact| (fact, plus)));
        self.search.zero(claim.clone(), None, &terms, &[])
    }

    /// The arguments of logarithms, as often as they stand in a sum with either sign; what the sum is to be multiplied by to be the expression.
    fn parts_of_logarithm(&mut self, goal: Expr, left: &mut Vec<Expr>, right: &mut Vec<Expr>) -> Option<Rational> {
        let graph = &mut self.search.reader.graph;
        let f = fraction(graph, goal)?;
        let under = f.denominator(graph);
        let under = graph.as_constant(under)?.clone();
        let ring = Ring::of(graph, &[f.numerator])?;
        let mut work = MOST_PRODUCTS;
        let p = ring.read(graph, f.numerator, &mut work).filter(|p| !p.is_empty())?;
        let smallest = p.values().map(|r| if *r < Rational::ZERO { -r.clone() } else { r.clone() }).min()?;
        for (m, r) in p {
            let e = ring.write(graph, &[(m, Rational::ONE)]);
            let Node::Unary(Op::Ln, argument) = *graph.node(e) else { return None };
            let times = r / smallest.clone();
            let side = if times > Rational::ZERO { &mut *left } else { &mut *right };
            let whole = times.denominator().is_one().then(|| i64::try_from(times.numerator()).ok()).flatten()?;
            let count = usize::try_from(whole.unsigned_abs()).ok().filter(|n| *n <= MOST_FACTORS)?;
            side.extend(std::iter::repeat_n(argument, count));
        }
        (left.len() + right.len() <= MOST_FACTORS).then(|| smallest / under)
    }

    /// A product, and that its logarithm is the sum of those of its factors.
    fn logarithm_of_product(&mut self, factors: &[Expr]) -> (Option<Expr>, Vec<FactId>) {
        let Some((&first, others)) = factors.split_first() else {
            return (Some(self.search.reader.graph.integer(1)), Vec::new());
        };
        let (mut product, mut laws) = (first, Vec::new());
        for &factor in others {
            let Some((law, ..)) = self.search.law(Law::LogarithmOfProduct, &[product, factor]) else {
                return (None, Vec::new());
            };
            laws.push(law);
            product = self.search.reader.graph.mul(product, factor);
        }
        (Some(product), laws)
    }

    /// (exp(½·ln u))² = u, of the exponential.
    pub(crate) fn root_of_argument(&mut self, node: Expr) -> Option<FactId> {
        let Node::Unary(Op::Exp, half) = *self.search.reader.graph.node(node) else { return None };
        let (number, unit) = self.multiple(half);
        let Node::Unary(Op::Ln, u) = *self.search.reader.graph.node(unit) else { return None };
        if number.clone() + number != Rational::ONE {
            return None;
        }
        let (of_sum, whole, _) = self.search.law(Law::ExponentialOfSum, &[half, half])?;
        let (of_logarithm, same, _) = self.search.law(Law::ExponentialOfLogarithm, &[u])?;
        // Without what both have, numerator and denominator are divided by further than with it.
        let (top, under) = self.in_lowest_terms(u)?;
        let graph = &mut self.search.reader.graph;
        let square = graph.powi(node, 2);
        let (left, minus) = (graph.mul(square, under), graph.neg(under));
        let says = self.search.reader.equation(left, top)?;
        let mut terms = vec![(of_sum, minus), (of_logarithm, under)];
        if same != whole {
            terms.push((self.same_value(same, whole)?, minus));
        }
        let before = std::mem::take(&mut self.search.solved);
        let found = self.search.zero(says, None, &terms, &[]);
        self.search.solved = before;
        found
    }

    /// Numerator and denominator, without powers that all terms of both have.
    fn in_lowest_terms(&mut self, e: Expr) -> Option<(Expr, Expr)> {
        let graph = &mut self.search.reader.graph;
        let f = fraction(graph, e)?;
        let under = f.denominator(graph);
        let ring = Ring::of(graph, &[f.numerator, under])?;
        let mut work = MOST_PRODUCTS;
        let [top, under] = [ring.read(graph, f.numerator, &mut work)?, ring.read(graph, under, &mut work)?];
        let both: Polynomial = top.iter().chain(&under).map(|(m, _)| (*m, Rational::ONE)).collect();
        let common = ring.content(&both)?;
        let [top, under] = [top, under].map(|p| {
            let terms: Vec<_> = p.into_iter().map(|(m, r)| (ratio(&m, &common), r)).collect();
            ring.write(graph, &terms)
        });
        Some((top, under))
    }
}
