//! Three values, and how they are put together: the tables of the page on meaning.

use super::line::{Piece, Q};

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Truth {
    True,
    False,
    Void,
}

use Truth::{False, True, Void};

impl Piece for Truth {
    fn at(&self, _: &Q) -> Truth {
        *self
    }
}

/// Strong Kleene.
pub fn and(a: Truth, b: Truth) -> Truth {
    match (a, b) {
        (False, _) | (_, False) => False,
        (True, True) => True,
        (Void, _) | (_, Void) => Void,
    }
}

pub fn not(a: Truth) -> Truth {
    match a {
        True => False,
        False => True,
        Void => Void,
    }
}

pub fn or(a: Truth, b: Truth) -> Truth {
    not(and(not(a), not(b)))
}

pub fn given(p: Truth, c: Truth) -> Truth {
    if c == True { p } else { Void }
}

pub fn assert(p: Truth) -> Truth {
    if p == Void { False } else { p }
}

/// What is void is not counted.
pub fn all(p: impl IntoIterator<Item = Truth>) -> Truth {
    let mut found = Void;
    for p in p {
        match p {
            False => return False,
            True => found = True,
            Void => {}
        }
    }
    found
}

pub fn some(p: impl IntoIterator<Item = Truth>) -> Truth {
    not(all(p.into_iter().map(not)))
}
