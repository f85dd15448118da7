//! Propositions: what a claim says, as a tree over atoms.
//!
//! **In:** numbers of atoms. **Out:** [`Proposition`], and its value for given values of its atoms.
//!
//! **Guaranteed.** Connectives are evaluated here and nowhere else. A method decides atoms, and never sees a proposition.
//!
//! The same type serves at a point (atoms are comparisons, there may be a sign of ±), and for a claim as a whole (atoms are
//! its parts, each of which speaks of all times that count).

use super::truth::{Possible, Truth};
use serde::{Deserialize, Serialize};

/// How many of the instances: every one, or some one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Quantifier {
    /// Every instance that is not void; void if all are.
    Every,
    /// Some instance; void if all are.
    Some,
}

impl Quantifier {
    /// The join of what is known of two instances.
    #[inline]
    pub fn join(self, a: Possible, b: Possible) -> Possible {
        match self {
            Quantifier::Every => a.every(b),
            Quantifier::Some => a.some(b),
        }
    }

    /// The quantifier of the negation.
    #[must_use]
    pub fn dual(self) -> Quantifier {
        match self {
            Quantifier::Every => Quantifier::Some,
            Quantifier::Some => Quantifier::Every,
        }
    }
}

/// What is said, of atoms that are known by their numbers.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Proposition {
    /// The atom with this number.
    Atom(usize),
    /// It is not so.
    Not(Box<Proposition>),
    /// All of them; nothing to say is true.
    And(Vec<Proposition>),
    /// One of them at least.
    Or(Vec<Proposition>),
    /// The first, where the second is true.
    Given(Box<Proposition>, Box<Proposition>),
    /// It is so, and has a value.
    Assert(Box<Proposition>),
    /// Each of them is an instance: what is void is not counted.
    Each(Quantifier, Vec<Proposition>),
}

impl Proposition {
    /// Its negation.
    #[must_use]
    pub fn negated(self) -> Proposition {
        match self {
            Proposition::Not(inner) => *inner,
            other => Proposition::Not(Box::new(other)),
        }
    }

    /// The first where the second is true; the first alone where nothing is presupposed.
    #[must_use]
    pub fn given(self, condition: Proposition) -> Proposition {
        match condition {
            Proposition::And(all) if all.is_empty() => self,
            condition => Proposition::Given(Box::new(self), Box::new(condition)),
        }
    }

    /// Its value, where `atom` tells what is known of each atom.
    pub fn value(&self, atom: &mut impl FnMut(usize) -> Possible) -> Possible {
        match self {
            Proposition::Atom(number) => atom(*number),
            Proposition::Not(inner) => inner.value(atom).not(),
            Proposition::And(all) => all.iter().fold(Possible::TRUE, |value, p| value.and(p.value(atom))),
            Proposition::Or(all) => all.iter().fold(Possible::FALSE, |value, p| value.or(p.value(atom))),
            Proposition::Given(then, condition) => then.value(atom).given(condition.value(atom)),
            Proposition::Assert(inner) => inner.value(atom).asserted(),
            Proposition::Each(quantifier, all) => {
                all.iter().fold(Possible::VOID, |value, p| quantifier.join(value, p.value(atom)))
            }
        }
    }

    /// The numbers of its atoms, in their order.
    pub fn atoms(&self) -> Vec<usize> {
        let mut out = Vec::new();
        self.visit(&mut |n| out.push(n));
        out
    }

    /// The numbers of the atoms that are said, in their order: not those that are presupposed, or denied.
    pub fn said(&self) -> Vec<usize> {
        match self {
            Proposition::Atom(number) => vec![*number],
            Proposition::Not(_) | Proposition::Or(_) => Vec::new(),
            Proposition::And(all) | Proposition::Each(Quantifier::Every, all) => {
                all.iter().flat_map(Proposition::said).collect()
            }
            Proposition::Each(Quantifier::Some, _) => Vec::new(),
            Proposition::Given(then, _) => then.said(),
            Proposition::Assert(inner) => inner.said(),
        }
    }

    /// Whether something that is presupposed of what is said may be false, as far as atoms are known.
    pub fn may_not_apply(&self, atom: &mut impl FnMut(usize) -> Possible) -> bool {
        match self {
            Proposition::Atom(_) | Proposition::Not(_) | Proposition::Or(_) => false,
            Proposition::And(all) | Proposition::Each(_, all) => all.iter().any(|p| p.may_not_apply(atom)),
            Proposition::Given(then, condition) => {
                condition.value(atom).may_be(Truth::False) || then.may_not_apply(atom)
            }
            Proposition::Assert(inner) => inner.may_not_apply(atom),
        }
    }

    fn visit(&self, see: &mut impl FnMut(usize)) {
        match self {
            Proposition::Atom(number) => see(*number),
            Proposition::Not(inner) | Proposition::Assert(inner) => inner.visit(see),
            Proposition::And(all) | Proposition::Or(all) | Proposition::Each(_, all) => {
                all.iter().for_each(|p| p.visit(see))
            }
            Proposition::Given(then, condition) => {
                then.visit(see);
                condition.visit(see);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Proposition::{And, Atom, Each, Or};
    use super::*;

    #[test]
    fn never_is_not_eventually_and_always_not() {
        // Three instances: true, void, open.
        let known = [Possible::TRUE, Possible::VOID, Possible::OPEN];
        let mut atom = |n: usize| known[n];
        let all = || (0..3).map(Atom).collect::<Vec<_>>();
        let denied = || (0..3).map(|n| Atom(n).negated()).collect::<Vec<_>>();
        let eventually = Each(Quantifier::Some, all());
        let never = Each(Quantifier::Every, denied());
        assert_eq!(eventually.value(&mut atom).not(), never.value(&mut atom));
        assert_eq!(eventually.value(&mut atom), Possible::TRUE);
    }

    #[test]
    fn a_conjunction_with_a_false_member_is_false_whatever_the_others_are() {
        let known = [Possible::VOID, Possible::FALSE, Possible::ANY];
        let mut atom = |n: usize| known[n];
        assert_eq!(And(vec![Atom(0), Atom(1), Atom(2)]).value(&mut atom), Possible::FALSE);
        assert_eq!(Or(vec![Atom(0), Atom(1)]).value(&mut atom), Possible::VOID);
        assert_eq!(Atom(1).given(Atom(0)).value(&mut atom), Possible::VOID);
        assert_eq!(Atom(1).given(And(vec![])).value(&mut atom), Possible::FALSE);
        assert_eq!(Proposition::Assert(Box::new(Atom(0))).value(&mut atom), Possible::FALSE);
        assert_eq!(Each(Quantifier::Every, vec![]).value(&mut atom), Possible::VOID, "no instance says nothing");
    }
}
