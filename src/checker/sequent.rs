//! Sequents: what is given, each as it is quantified, and what is claimed.
//!
//! **In:** declarations, definitions and relations of a file. **Out:** [`Sequent`], which a proof is about, and its words.
//!
//! **What a proof of it says.** A *motion* is an interval T of more than one time that contains the fixed times which formulas name; a number
//! for each constant, of its sign; and for each symbol that moves a function on T, as often continuously differentiable as it is
//! declared to be (one-sided at the ends). *Proved* means: on every motion on which all that is given is true as it is quantified, the
//! claim is not false at any time of S₀, the times at which all selectors are true and all assumed equations have values. A relation
//! of which a side has no value is not false. **Fields.** Where coordinates are declared, T is an open connected set of values of the time and the coordinates, and a time of T is a point of it; there are no
//! fixed times, and no rule that goes along an interval of times. A relation
//! of which a side has no value is not false. Whether there is such a motion is another question, see [`Shown::model`](super::Shown).
//!
//! **Traps.** (1) A symbol that is declared n times differentiable has n rates: a motion with a kink in the nth is not meant. Who
//! says that a motion of a file satisfies a sequent must see to that. (2) A definition is its formula, at every time. An angle
//! that is continued over the cut of its formula is no definition here: declare a symbol that moves, with its rate as a premise.
//! (3) A claim of the file with assumptions of its own is given by [`Claimed`], not as a premise; and its symbols must not have more
//! rates where it is shown than here.

use super::term::{Relation, Term};
use serde::{Deserialize, Serialize};

/// The sign of a constant.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ConstantSign {
    /// It is any real number.
    Any,
    /// It is greater than 0.
    Positive,
    /// It is 0 or greater.
    NotNegative,
    /// It is not 0.
    NotZero,
}

/// The kind of a symbol.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SymbolKind {
    /// The independent variable.
    Time,
    /// A number.
    Constant(ConstantSign),
    /// A function of time that has so many continuous rates.
    Moves(u8),
    /// A coordinate of places.
    Coordinate,
    /// A function of the time and the coordinates, whose derivatives up to this order are continuous.
    Field(u8),
    /// A formula, see [`Definition`].
    Defined,
}

/// A symbol.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Declared {
    /// Its name, in LaTeX; no other symbol has it.
    pub name: String,
    /// The number of its components: 1 for a scalar.
    pub components: u16,
    /// Its kind.
    pub kind: SymbolKind,
}

/// A component of a defined symbol is a formula, which may name defined symbols of definitions before it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Definition {
    /// The symbol.
    pub name: String,
    /// The component.
    pub component: u16,
    /// The formula.
    pub formula: Term,
}

/// Another claim, with what it assumes: at all times at which its selectors are true, if its hypotheses are true at all of those.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Claimed {
    /// Its name in the file.
    pub name: String,
    /// The inequalities that choose its times.
    pub selectors: Vec<Relation>,
    /// The equations that it assumes.
    pub hypotheses: Vec<Relation>,
    /// The relation that it claims.
    pub says: Relation,
}

/// Definitions, equations and relations that are given, and a claim.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Sequent {
    /// All symbols.
    pub symbols: Vec<Declared>,
    /// The formulas of defined symbols, at all times.
    pub definitions: Vec<Definition>,
    /// The fixed times: terms of constants. T contains each of them that has a value.
    pub instants: Vec<Term>,
    /// Equations of systems: true at all times, at which both sides have values.
    pub systems: Vec<Relation>,
    /// Typed premises and values at fixed times: not false at any time.
    pub premises: Vec<Relation>,
    /// Other claims.
    pub claims: Vec<Claimed>,
    /// Inequalities among the assumptions: they choose the times of S₀.
    pub selectors: Vec<Relation>,
    /// The other assumptions: true at all times of S₀.
    pub assumed: Vec<Relation>,
    /// The claim.
    pub claim: Relation,
}

impl Sequent {
    /// A sequent in which nothing is given.
    pub fn of(symbols: Vec<Declared>, claim: Relation) -> Sequent {
        Sequent {
            symbols,
            definitions: Vec::new(),
            instants: Vec::new(),
            systems: Vec::new(),
            premises: Vec::new(),
            claims: Vec::new(),
            selectors: Vec::new(),
            assumed: Vec::new(),
            claim,
        }
    }
}
