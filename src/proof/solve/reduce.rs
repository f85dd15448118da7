//! Equations that say more, or less, than they show: sums whose terms vanish one by one, cosine and sine of one argument,
//! products that are not written as such.

use std::collections::BTreeSet;

use super::{Candidate, Case, Next, Solver};
use crate::linear::{Monomial, expression};
use crate::polynomial::{factors, product};
use crate::probe::Sight;
use expr::{Expr, Leaf, Node, Op, Rational};

impl Solver<'_> {
    /// The terms of a sum of squares without their squares: over the real numbers each of them vanishes with the sum.
    pub(super) fn squares(&mut self, e: Expr) -> Option<Vec<Expr>> {
        if let Some(known) = self.probe.squares.get(&e) {
            return known.clone();
        }
        if let Some(terms) = self.written_squares(e).or_else(|| self.terms_of_one_sign(e)) {
            self.probe.squares.insert(e, Some(terms.clone()));
            return Some(terms);
        }
        // A sum of squares has one sign wherever it has a value.
        if self.probe.structure.borrow_mut().has_both_signs(self.graph, e) {
            self.probe.squares.insert(e, None);
            return None;
        }
        let sum = self.probe.structure.borrow_mut().combinations.of(self.graph, e);
        let positive = sum.values().next().is_some_and(|q| *q > Rational::ZERO);
        let even = |(m, q): (&Monomial, &Rational)| {
            (*q > Rational::ZERO) == positive && m.iter().all(|&(_, k)| k > 0 && k % 2 == 0)
        };
        let found = (sum.len() > 1 && sum.iter().all(even)).then(|| {
            let root = |m: &Monomial| m.iter().map(|&(base, k)| (base, k / 2)).collect();
            let roots: Vec<Monomial> = sum.keys().map(root).collect();
            roots.iter().map(|m| expression(self.graph, m, &Rational::ONE)).collect::<Vec<_>>()
        });
        self.probe.squares.insert(e, found.clone());
        found
    }

    /// The same for a sum of terms that are known to have one sign.
    fn terms_of_one_sign(&mut self, e: Expr) -> Option<Vec<Expr>> {
        let (mut open, mut terms) = (vec![(e, false)], Vec::new());
        while let Some((e, minus)) = open.pop() {
            match *self.graph.node(e) {
                Node::Binary(Op::Add, a, b) => open.extend([(b, minus), (a, minus)]),
                Node::Binary(Op::Sub, a, b) => open.extend([(b, !minus), (a, minus)]),
                Node::Unary(Op::Neg, a) => open.push((a, !minus)),
                _ if self.graph.is_zero(e) => {}
                _ => terms.push((e, minus)),
            }
        }
        if terms.len() < 2 {
            return None;
        }
        let signs: Vec<(bool, bool)> = terms
            .iter()
            .map(|&(e, minus)| {
                let known = self.sign(e);
                let pair = (known.not_negative, known.not_positive);
                if minus { (pair.1, pair.0) } else { pair }
            })
            .collect();
        let one_sign = signs.iter().all(|s| s.0) || signs.iter().all(|s| s.1);
        one_sign.then(|| terms.into_iter().map(|(e, _)| e).collect())
    }

    /// The same for a sum that is written as one of squares.
    fn written_squares(&mut self, e: Expr) -> Option<Vec<Expr>> {
        let mut open = vec![(e, false)];
        let mut terms: Vec<(bool, Vec<(Expr, i32)>)> = Vec::new();
        while let Some((e, minus)) = open.pop() {
            match *self.graph.node(e) {
                Node::Binary(Op::Add, a, b) => open.extend([(b, minus), (a, minus)]),
                Node::Binary(Op::Sub, a, b) => open.extend([(b, !minus), (a, minus)]),
                Node::Unary(Op::Neg, a) => open.push((a, !minus)),
                _ if self.graph.is_zero(e) => {}
                _ => {
                    let (q, parts) = factors(self.graph, e);
                    if !parts.iter().all(|&(_, k)| k > 0 && k % 2 == 0) {
                        return None;
                    }
                    terms.push(((q > Rational::ZERO) != minus, parts));
                }
            }
        }
        let sign = terms.first()?.0;
        if terms.len() < 2 || terms.iter().any(|(s, _)| *s != sign) {
            return None;
        }
        let root = |parts: &Vec<(Expr, i32)>| parts.iter().map(|&(base, k)| (base, k / 2)).collect::<Vec<_>>();
        let roots: Vec<Vec<(Expr, i32)>> = terms.iter().map(|(_, parts)| root(parts)).collect();
        Some(roots.iter().map(|parts| product(self.graph, &Rational::ONE, parts)).collect())
    }

    /// An equation in cosine and sine of one argument, reduced to one of them where that is possible.
    pub(super) fn on_circle(&mut self, case: &mut Case, e: Expr) -> Expr {
        let pairs: BTreeSet<(Leaf, Leaf)> =
            self.extent(e).leaves.iter().filter_map(|&l| self.generators.circle(l)).collect();
        let mut e = e;
        for (c, s) in pairs {
            let extent = self.extent(e);
            if !(extent.leaves.contains(&c) && extent.leaves.contains(&s)) {
                continue;
            }
            let mut kept = None;
            for (keep, reduce) in [(c, s), (s, c)] {
                let Some(all) = self.written_in_powers(e, reduce) else { continue };
                if all.len() < 3 {
                    continue;
                }
                let (even, odd) = self.halves(&all, keep);
                let flat = |this: &mut Self, e| this.probe.sight(this.graph, this.generators, e) == Sight::Zero;
                if flat(self, odd) {
                    case.out.taken_as_zero.push(odd);
                    e = even;
                    kept = None;
                    break;
                }
                let root = self.graph.leaf(reduce);
                let term = self.graph.mul(root, odd);
                if flat(self, even) {
                    case.out.taken_as_zero.push(even);
                    e = term;
                    kept = None;
                    break;
                }
                kept.get_or_insert(self.graph.add(even, term));
            }
            if let Some(reduced) = kept {
                e = reduced;
            }
        }
        e
    }

    /// Even and odd part of a polynomial in one of the pair, with its square replaced by 1 − keep².
    fn halves(&mut self, all: &[Expr], keep: Leaf) -> (Expr, Expr) {
        let g = &mut *self.graph;
        let keep = g.leaf(keep);
        let (one, square) = (g.integer(1), g.powi(keep, 2));
        let other = g.sub(one, square);
        let mut parts = [g.integer(0), g.integer(0)];
        for (k, &coefficient) in all.iter().enumerate() {
            let power = g.powi(other, (k / 2) as i32);
            let factor = if k / 2 == 0 { one } else { power };
            let term = g.mul_structural(coefficient, factor);
            parts[k % 2] = g.add(parts[k % 2], term);
        }
        (parts[0], parts[1])
    }

    /// x and q where an equation is x·q = 0 with more than two powers of x: it can be solved for x no other way.
    pub(super) fn without_leaf(&mut self, e: Expr) -> Option<Vec<Expr>> {
        let extent = self.extent(e);
        if extent.size > 40 {
            return None;
        }
        for &leaf in &extent.leaves {
            if self.class(leaf).is_none() {
                continue;
            }
            let Some(all) = self.written_in_powers(e, leaf).filter(|all| all.len() > 3) else { continue };
            if !self.graph.is_zero(all[0]) {
                continue;
            }
            let x = self.graph.leaf(leaf);
            let quotient = self.sum_of_powers(&all[1..], x);
            return Some([x, quotient].into_iter().filter(|&e| !self.is_known(e)).collect());
        }
        None
    }

    /// Σ cₖ·xᵏ.
    fn sum_of_powers(&mut self, all: &[Expr], x: Expr) -> Expr {
        let mut out = self.graph.integer(0);
        for &c in all.iter().rev() {
            let raised = self.graph.mul_structural(out, x);
            out = self.graph.add(raised, c);
        }
        out
    }

    /// An equation x·q(x) = 0, seen as such only by random points, is two cases.
    pub(super) fn zero_root(&mut self, case: &mut Case, candidate: &Candidate) -> Option<Next> {
        let (all, vanishing) = &*candidate.powers;
        let lowest = *all.first()?;
        let e = case.pending[candidate.equation].e;
        let x = self.graph.leaf(candidate.unknown);
        if e == x || self.probe.sight(self.graph, self.generators, lowest) != Sight::Zero {
            return None;
        }
        case.out.taken_as_zero.extend(vanishing.iter().copied());
        if !self.graph.is_zero(lowest) {
            case.out.taken_as_zero.push(lowest);
        }
        let quotient = self.sum_of_powers(&all[1..], x);
        let parts = [x, quotient].into_iter().filter(|&e| !self.is_known(e)).collect();
        Some(Next::Split(candidate.equation, parts))
    }
}
