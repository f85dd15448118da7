//! Signs of sums, by those of other sums: found again by their polynomials up to a factor.

use super::super::exact::rational_root;
use super::super::linear::{Combinations, Monomial, expression};
use super::super::polynomial::primitive;
use super::{MOST_NESTED, Roots};
use expr::{Expr, Graph, Node, Op, Rational};

impl Roots<'_> {
    /// Whether a sum is ≥ 0 (or ≤ 0), by the sums of which that is known.
    pub(super) fn sign_of_sum(&mut self, e: Expr) -> Option<bool> {
        if self.sums.is_empty() || !matches!(self.graph.node(e), Node::Binary(Op::Add | Op::Sub, ..)) {
            return None;
        }
        let (q, parts) = primitive(self.graph, e);
        if let Some(sign) = self.sign_of_product(&q, &parts, None) {
            return Some(sign);
        }
        // a² − b² = (a − b)(a + b).
        let (a, b) = difference_of_squares(self.graph, e)?;
        let mut up = true;
        for factor in [self.graph.sub(a, b), self.graph.add(a, b)] {
            let (q, parts) = primitive(self.graph, factor);
            up ^= !self.sign_of_product(&q, &parts, None)?;
        }
        Some(up)
    }

    /// The sign of a product, one of its factors apart.
    pub(super) fn sign_of_product(&self, q: &Rational, parts: &[(Expr, i32)], but: Option<Expr>) -> Option<bool> {
        let mut up = *q > Rational::ZERO;
        for &(base, _) in parts.iter().filter(|&&(base, k)| k % 2 != 0 && Some(base) != but) {
            let known = self.facts.sign(self.graph, self.generators, base);
            let (positive, negative) = (known.not_negative, known.not_positive);
            up ^= match self.sums.get(&base) {
                _ if positive => false,
                _ if negative => true,
                Some(sign) => !sign,
                None => return None,
            };
        }
        Some(up)
    }

    /// Brings what is known of signs of sums to a form in which it is found again. From a² − b² ≥ 0 and a ≥ 0 follows a ± b ≥ 0.
    pub(super) fn note_sums(&mut self) {
        let facts = self.facts.positive.iter().chain(&self.facts.not_negative).copied();
        let mut facts: Vec<Expr> = facts.filter(|e| self.graph.reachable([*e]).len() <= MOST_NESTED).collect();
        facts.sort_unstable();
        facts.dedup();
        for e in facts {
            let (q, parts) = primitive(self.graph, e);
            let is_sum = |graph: &Graph, e: Expr| matches!(graph.node(e), Node::Binary(Op::Add | Op::Sub, ..));
            let odd: Vec<Expr> = parts.iter().filter(|(_, k)| k % 2 != 0).map(|&(base, _)| base).collect();
            let sums: Vec<Expr> = odd.into_iter().filter(|&base| is_sum(self.graph, base)).collect();
            let &[base] = sums.as_slice() else { continue };
            // Where another factor vanishes nothing is said of this one.
            let others = parts.iter().filter(|&&(other, k)| other != base && k > 0);
            if !others.into_iter().all(|&(other, _)| self.facts.sign(self.graph, self.generators, other).nonzero) {
                continue;
            }
            let Some(up) = self.sign_of_product(&q, &parts, Some(base)) else { continue };
            self.sums.insert(base, up);
            let signed = if up { base } else { self.graph.neg(base) };
            let Some((a, b)) = difference_of_squares(self.graph, signed) else { continue };
            if self.facts.sign(self.graph, self.generators, a).not_negative {
                for e in [self.graph.add(a, b), self.graph.sub(a, b)] {
                    let (q, parts) = primitive(self.graph, e);
                    if let &[(base, 1)] = parts.as_slice() {
                        self.sums.insert(base, q > Rational::ZERO);
                    }
                }
            }
        }
    }

    /// ≥ 0 or ≤ 0, by the terms: a root with its sign is not negative.
    pub(super) fn sign_of_terms(&mut self, e: Expr) -> Option<bool> {
        let all = Combinations::default().of(self.graph, e);
        let mut sign = None;
        for (m, q) in &all {
            let mut m = m.clone();
            for &(mark, root) in &self.pairs {
                let odd = |m: &Monomial, e: Expr| m.iter().any(|&(base, k)| base == e && k % 2 != 0);
                if odd(&m, mark) && odd(&m, root) {
                    m.retain(|&(base, _)| base != mark && base != root);
                }
            }
            let q = if *q > Rational::ZERO { Rational::ONE } else { -Rational::ONE };
            let own = self.sign_of_product(&q, &m, None)?;
            if sign.is_some_and(|s| s != own) {
                return None;
            }
            sign = Some(own);
        }
        sign
    }
}

/// (a, b) with e = a² − b², for two terms.
fn difference_of_squares(graph: &mut Graph, e: Expr) -> Option<(Expr, Expr)> {
    let all = Combinations::default().of(graph, e);
    let mut terms = all.iter();
    let (Some((m, p)), Some((n, r)), None) = (terms.next(), terms.next(), terms.next()) else { return None };
    // The positive term first.
    let (first, second) = match (*p > Rational::ZERO, *r > Rational::ZERO) {
        (true, false) => ((m, p), (n, r)),
        (false, true) => ((n, r), (m, p)),
        _ => return None,
    };
    let mut root = |(m, c): (&Monomial, &Rational)| {
        let c = if *c < Rational::ZERO { -c.clone() } else { c.clone() };
        let c = rational_root(&c)?;
        let halves: Option<Monomial> = m.iter().map(|&(b, k)| (k % 2 == 0).then_some((b, k / 2))).collect();
        Some(expression(graph, &halves?, &c))
    };
    Some((root(first)?, root(second)?))
}
