//! Gröbner bases, as far as they are wanted: the algorithm of Buchberger, in which each polynomial knows of which it is a sum of multiples.
//!
//! **In:** polynomials that vanish, and targets. **Out:** a target as a sum of multiples of polynomials, each of which is a sum of multiples of two before it; or nothing. **Bounded:** so many terms are
//! looked at, of so high a degree. **How:** pairs with the smallest common multiple first; a pair is left out where another polynomial takes its place (both criteria of Buchberger).

use crate::ring::{MOST_VARIABLES, Monomial, Polynomial, Ring, add, divides, ratio};
use checker::FactId;
use expr::{Expr, Rational};
use std::collections::BTreeSet;

/// Most terms that are looked at in one search.
pub(crate) const MOST_WORK: usize = 180_000;
/// Most terms of what is to vanish.
const LARGEST_GOAL: usize = 6_000;
/// Most polynomials.
const MOST_ELEMENTS: usize = 400;
/// Most terms of a polynomial that is kept.
pub(crate) const MOST_TERMS: usize = 400;

/// A multiple of an element.
pub(crate) type Multiple = (usize, Monomial, Rational);

/// Why an element vanishes.
pub(crate) enum Origin {
    /// It is a number times the numerator of a fact, whose denominator is the expression.
    Fact(FactId, Expr, Rational),
    /// It is a sum of multiples of elements.
    Sum(Vec<Multiple>),
}

/// A polynomial that vanishes, with the number 1 before its first monomial.
pub(crate) struct Element {
    pub(crate) terms: Vec<(Monomial, Rational)>,
    pub(crate) origin: Origin,
    /// Whether it is divided by.
    active: bool,
}

impl Element {
    fn lead(&self) -> &Monomial {
        &self.terms[0].0
    }
}

/// What is left of a polynomial, and what was taken away.
pub(crate) struct Remainder {
    left: Polynomial,
    done: Polynomial,
    pub(crate) taken: Vec<Multiple>,
}

pub(crate) struct Completion {
    pub(crate) ring: Ring,
    pub(crate) elements: Vec<Element>,
    /// Pairs of elements, those with the smallest common multiple first.
    pairs: BTreeSet<(u8, Monomial, usize, usize)>,
    pub(crate) work: usize,
    highest: u8,
}

impl Remainder {
    /// All of it is left.
    pub(crate) fn of(p: Polynomial) -> Remainder {
        Remainder { left: p, done: Polynomial::new(), taken: Vec::new() }
    }
}

impl Completion {
    /// Takes multiples of elements away until nothing can be taken.
    fn reduce(&mut self, of: &mut Remainder) -> Option<()> {
        while let Some((m, r)) = of.left.pop_last() {
            let found = self.elements.iter().enumerate().find(|(_, e)| e.active && divides(e.lead(), &m));
            let Some((at, element)) = found else {
                self.work = self.work.checked_sub(1)?;
                of.done.insert(m, r);
                continue;
            };
            let factor = ratio(&m, element.lead());
            self.work = self.work.checked_sub(element.terms.len() + 2)?;
            for (n, s) in &element.terms[1..] {
                let product = self.ring.product(n, &factor)?;
                add(&mut of.left, product, -(&r * s));
            }
            if of.left.len() + of.done.len() > LARGEST_GOAL {
                return None;
            }
            of.taken.push((at, factor, r));
        }
        Some(())
    }

    /// Adds a polynomial, which is a sum of multiples, without multiples of others; whether something is left of it.
    fn insert(&mut self, p: Polynomial, mut taken: Vec<Multiple>) -> Option<bool> {
        let mut rest = Remainder { left: p, done: Polynomial::new(), taken: Vec::new() };
        self.reduce(&mut rest)?;
        taken.extend(rest.taken.into_iter().map(|(at, m, r)| (at, m, -r)));
        let Some((_, lead)) = rest.done.last_key_value() else { return Some(false) };
        let inverse = Rational::ONE / lead.clone();
        if rest.done.len() > MOST_TERMS {
            return Some(false);
        }
        let terms = rest.done.into_iter().rev().map(|(m, r)| (m, r * inverse.clone())).collect();
        let taken = taken.into_iter().map(|(at, m, r)| (at, m, r * inverse.clone())).collect();
        self.activate(Element { terms, origin: Origin::Sum(taken), active: true });
        Some(true)
    }

    fn activate(&mut self, element: Element) {
        let (new, lead) = (self.elements.len(), *element.lead());
        for (at, other) in self.elements.iter_mut().enumerate() {
            if !other.active {
                continue;
            }
            let multiple = self.ring.multiple(&lead, other.lead());
            let degree = self.ring.degree(&multiple);
            if !self.ring.coprime(&lead, other.lead()) && degree <= self.highest {
                self.pairs.insert((degree, multiple, at, new));
            }
            other.active = !divides(&lead, other.lead());
        }
        self.elements.push(element);
    }

    /// The next pair, as the difference of multiples in which the first monomials cancel.
    fn next_pair(&mut self) -> Option<(Polynomial, Vec<Multiple>)> {
        while let Some((_, multiple, i, j)) = self.pairs.pop_first() {
            self.work = self.work.checked_sub(1 + self.elements.len() / 8)?;
            let is_covered = self.elements.iter().enumerate().any(|(k, e)| {
                let waits = |a: usize, b: usize| {
                    let both = self.ring.multiple(self.elements[a].lead(), self.elements[b].lead());
                    self.pairs.contains(&(self.ring.degree(&both), both, a.min(b), a.max(b)))
                };
                e.active && k != i && k != j && divides(e.lead(), &multiple) && !waits(i, k) && !waits(j, k)
            });
            let [a, b] = [&self.elements[i], &self.elements[j]];
            // What another one divides is replaced by what is left of it, and then by no pair with a third.
            let replaces = divides(a.lead(), b.lead()) || divides(b.lead(), a.lead());
            if !replaces && (is_covered || !a.active || !b.active) {
                continue;
            }
            let mut p = Polynomial::new();
            let mut taken = Vec::new();
            for (at, sign) in [(i, Rational::ONE), (j, -Rational::ONE)] {
                let factor = ratio(&multiple, self.elements[at].lead());
                self.work = self.work.checked_sub(self.elements[at].terms.len())?;
                for (m, r) in &self.elements[at].terms {
                    add(&mut p, self.ring.product(m, &factor)?, r * &sign);
                }
                taken.push((at, factor, sign));
            }
            return Some((p, taken));
        }
        None
    }
}

impl Completion {
    /// No polynomials, in a ring; pairs up to a degree are looked at, and so many terms.
    pub(crate) fn new(ring: Ring, highest: u8, work: usize) -> Completion {
        Completion { ring, elements: Vec::new(), pairs: BTreeSet::new(), work, highest }
    }

    /// Adds the numerator of a fact.
    pub(crate) fn give(&mut self, p: Polynomial, fact: FactId, under: Expr) -> Option<()> {
        let inverse = Rational::ONE / p.last_key_value()?.1.clone();
        let terms = p.iter().rev().map(|(m, r)| (*m, r * &inverse)).collect();
        let raw = Element { terms, origin: Origin::Fact(fact, under, inverse.clone()), active: false };
        let at = self.elements.len();
        if p.keys().any(|m| self.elements.iter().any(|e| e.active && divides(e.lead(), m))) {
            self.elements.push(raw);
            let p = p.into_iter().map(|(m, r)| (m, r * &inverse)).collect();
            self.insert(p, vec![(at, [0; MOST_VARIABLES + 1], Rational::ONE)])?;
        } else {
            self.activate(Element { active: true, ..raw });
        }
        Some(())
    }

    /// Adds differences of multiples until nothing of a target is left: which one.
    pub(crate) fn search(&mut self, targets: &mut [Remainder]) -> Option<usize> {
        for target in targets.iter_mut() {
            self.reduce(target)?;
        }
        loop {
            if let Some(found) = targets.iter().position(|target| target.done.is_empty()) {
                return Some(found);
            }
            let (p, taken) = self.next_pair()?;
            if !self.insert(p, taken)? {
                continue;
            }
            if self.elements.len() > MOST_ELEMENTS {
                return None;
            }
            let lead = *self.elements.last()?.lead();
            for target in targets.iter_mut() {
                if target.done.keys().any(|m| divides(&lead, m)) {
                    target.left = std::mem::take(&mut target.done);
                    self.reduce(target)?;
                }
            }
        }
    }
}
