//! Truth, and what is known of it.
//!
//! **In:** nothing. **Out:** [`Truth`], the three values that a proposition can have at a point; [`Possible`], the set of
//! values that no evidence excludes; the connectives and the joins of quantifiers on both.
//!
//! **Guaranteed.** A connective on sets yields every value that the connective on truths yields for members of the sets, and
//! no other ([`Possible`] is the lift of [`Truth`], value by value), so that nothing is ever concluded that some member
//! contradicts. The tests compare all 49 pairs of sets with the tables of truths.
//!
//! **Why these tables.** Connectives are those of strong Kleene logic: a value is decided when nothing that is missing could
//! change it. What is void is not counted by quantifiers: "E = … always" speaks of the times at which E means something.
//! `given` is de Finetti's conditional: where the condition is not true, nothing was said. See `docs/semantics.md`.

use serde::{Deserialize, Serialize};
use std::fmt;

/// What a proposition is at a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Truth {
    /// It is so.
    True,
    /// It is not so.
    False,
    /// It says nothing there: a formula in it has no value.
    Void,
}

impl Truth {
    /// Every value.
    pub const ALL: [Truth; 3] = [Truth::True, Truth::False, Truth::Void];

    const fn bit(self) -> u8 {
        match self {
            Truth::True => 1,
            Truth::False => 2,
            Truth::Void => 4,
        }
    }
}

/// The values that are not excluded: a set of [`Truth`]s with at least one member.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(try_from = "u8", into = "u8")]
pub struct Possible(u8);

impl Possible {
    /// It is true.
    pub const TRUE: Possible = Possible(1);
    /// It is false.
    pub const FALSE: Possible = Possible(2);
    /// It has no value.
    pub const VOID: Possible = Possible(4);
    /// It has a value; which is not known.
    pub const OPEN: Possible = Possible(3);
    /// It is true wherever it has a value.
    pub const TRUE_OR_VOID: Possible = Possible(5);
    /// It is false wherever it has a value.
    pub const FALSE_OR_VOID: Possible = Possible(6);
    /// Nothing is known.
    pub const ANY: Possible = Possible(7);

    /// Exactly this value.
    pub const fn only(truth: Truth) -> Possible {
        Possible(truth.bit())
    }

    /// Whether a value is not excluded.
    #[inline]
    pub const fn may_be(self, truth: Truth) -> bool {
        self.0 & truth.bit() != 0
    }

    /// The value, if only one is left.
    pub const fn decided(self) -> Option<Truth> {
        match self.0 {
            1 => Some(Truth::True),
            2 => Some(Truth::False),
            4 => Some(Truth::Void),
            _ => None,
        }
    }

    /// What is possible for one or the other.
    #[inline]
    #[must_use]
    pub const fn or_else(self, other: Possible) -> Possible {
        Possible(self.0 | other.0)
    }

    /// What neither of two pieces of evidence excludes; `None` where they contradict each other.
    pub const fn agreed(self, other: Possible) -> Option<Possible> {
        match self.0 & other.0 {
            0 => None,
            both => Some(Possible(both)),
        }
    }

    /// Not this.
    #[must_use]
    pub const fn not(self) -> Possible {
        Possible((self.0 & 1) << 1 | (self.0 & 2) >> 1 | self.0 & 4)
    }

    /// Both (strong Kleene: false wins, then void).
    #[inline]
    #[must_use]
    pub const fn and(self, other: Possible) -> Possible {
        let (a, b) = (self.0, other.0);
        // False with anything; true with true; void with what is not false.
        let no = (a | b) & 2;
        let yes = a & b & 1;
        let void = (a & 4 != 0 && b & 5 != 0) || (b & 4 != 0 && a & 5 != 0);
        Possible(no | yes | (void as u8) << 2)
    }

    /// One at least (strong Kleene: true wins, then void).
    #[inline]
    #[must_use]
    pub const fn or(self, other: Possible) -> Possible {
        self.not().and(other.not()).not()
    }

    /// This, where a condition is true; void elsewhere.
    #[must_use]
    pub const fn given(self, condition: Possible) -> Possible {
        let here = if condition.0 & 1 != 0 { self.0 } else { 0 };
        let elsewhere = if condition.0 & 6 != 0 { 4 } else { 0 };
        Possible(here | elsewhere)
    }

    /// This, and that it has a value: false where it has none.
    #[must_use]
    pub const fn asserted(self) -> Possible {
        Possible(self.0 & 3 | (self.0 & 4) >> 1)
    }

    /// Every one of two instances: what is void is not counted.
    #[inline]
    #[must_use]
    pub const fn every(self, other: Possible) -> Possible {
        let (a, b) = (self.0, other.0);
        let no = (a | b) & 2;
        let yes = (a & 1 != 0 && b & 5 != 0) || (b & 1 != 0 && a & 5 != 0);
        let void = a & b & 4;
        Possible(no | yes as u8 | void)
    }

    /// Some one of two instances: what is void is not counted.
    #[inline]
    #[must_use]
    pub const fn some(self, other: Possible) -> Possible {
        self.not().every(other.not()).not()
    }
}

impl From<Possible> for u8 {
    fn from(set: Possible) -> u8 {
        set.0
    }
}

impl TryFrom<u8> for Possible {
    type Error = &'static str;

    fn try_from(bits: u8) -> Result<Possible, Self::Error> {
        if (1..8).contains(&bits) { Ok(Possible(bits)) } else { Err("no set of truths") }
    }
}

impl fmt::Debug for Possible {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_set().entries(Truth::ALL.iter().filter(|t| self.may_be(**t))).finish()
    }
}

#[cfg(test)]
mod tests {
    use super::Truth::{False, True, Void};
    use super::*;

    fn sets() -> impl Iterator<Item = Possible> {
        (1..8).map(Possible)
    }

    /// The lift of a table, by its definition.
    fn lifted(a: Possible, b: Possible, table: impl Fn(Truth, Truth) -> Truth) -> Possible {
        let mut bits = 0;
        for x in Truth::ALL.into_iter().filter(|t| a.may_be(*t)) {
            for y in Truth::ALL.into_iter().filter(|t| b.may_be(*t)) {
                bits |= table(x, y).bit();
            }
        }
        Possible(bits)
    }

    #[test]
    fn connectives_on_sets_are_the_lifts_of_the_tables() {
        let and = |a, b| match (a, b) {
            (False, _) | (_, False) => False,
            (Void, _) | (_, Void) => Void,
            (True, True) => True,
        };
        let or = |a, b| match (a, b) {
            (True, _) | (_, True) => True,
            (Void, _) | (_, Void) => Void,
            (False, False) => False,
        };
        let given = |p, c| if c == True { p } else { Void };
        let every = |a, b| match (a, b) {
            (False, _) | (_, False) => False,
            (Void, x) | (x, Void) => x,
            (True, True) => True,
        };
        let some = |a, b| match (a, b) {
            (True, _) | (_, True) => True,
            (Void, x) | (x, Void) => x,
            (False, False) => False,
        };
        for a in sets() {
            let not = lifted(a, a, |x, _| match x {
                True => False,
                False => True,
                Void => Void,
            });
            // A set with itself would pair different members: one argument is lifted member by member.
            let single = |t: Truth| match t {
                True => False,
                False => True,
                Void => Void,
            };
            let expected = Truth::ALL.into_iter().filter(|t| a.may_be(*t)).map(single).fold(0, |s, t| s | t.bit());
            assert_eq!(a.not(), Possible(expected));
            assert_eq!(a.not(), not);
            let asserted = |t: Truth| if t == Void { False } else { t };
            let expected = Truth::ALL.into_iter().filter(|t| a.may_be(*t)).map(asserted).fold(0, |s, t| s | t.bit());
            assert_eq!(a.asserted(), Possible(expected));
            for b in sets() {
                assert_eq!(a.and(b), lifted(a, b, and), "{a:?} and {b:?}");
                assert_eq!(a.or(b), lifted(a, b, or), "{a:?} or {b:?}");
                assert_eq!(a.given(b), lifted(a, b, given), "{a:?} given {b:?}");
                assert_eq!(a.every(b), lifted(a, b, every), "every {a:?} {b:?}");
                assert_eq!(a.some(b), lifted(a, b, some), "some {a:?} {b:?}");
            }
        }
    }

    #[test]
    fn what_two_pieces_of_evidence_leave_is_never_nothing() {
        assert_eq!(Possible::TRUE.agreed(Possible::FALSE), None);
        assert_eq!(Possible::TRUE_OR_VOID.agreed(Possible::OPEN), Some(Possible::TRUE));
        assert_eq!(Possible::TRUE_OR_VOID.decided(), None);
        assert_eq!(Possible::VOID.decided(), Some(Void));
    }
}
