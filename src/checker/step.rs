//! Steps of a recorded proof.
//!
//! **In:** nothing. **Out:** [`Step`], plain data: a rule, the facts that it uses by their numbers, and terms where the rule does not compute
//! its result. **Guaranteed:** a step says nothing by itself; [`replay`](super::replay) makes facts of steps, or refuses.
//!
//! Each step but those that say so makes one fact; facts are numbered from 0 in the order in which they are made.

use super::law::Law;
use super::term::{Relation, Term};
use super::when::{CaseId, Instant, When};
use serde::{Deserialize, Serialize};

/// A fact: its number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
pub struct FactId(pub u32);

/// A place in the sequent: a list, and a position in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Given {
    /// An equation of a system.
    System(u32),
    /// A premise.
    Premise(u32),
    /// An assumption that chooses no times.
    Assumed(u32),
    /// An inequality that chooses the times.
    Selector(u32),
    /// Another claim.
    Claimed(u32),
}

/// Which times of a case are meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Manner {
    /// The times at which the supposition is true.
    AtTimes,
    /// The times that have a neighbourhood in T, all times of which belong to the set that the case is taken in, and at all of which it is
    /// true: the interior of those of [`Manner::AtTimes`].
    OnIntervals,
}

/// Why cases leave out no time, or none but the ends and limits of intervals.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Split {
    /// A fact p = 0 or 0 = p: one of the factors of p is 0.
    Product(FactId),
    /// Two numbers are equal, or one of them is less.
    Order(Term, Term),
}

/// A step of a proof.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Step {
    /// What is given; `because` shows the assumptions of another claim.
    Given { given: Given, because: Vec<FactId> },
    /// What a system, an assumption or a selector needs, since it has a value: the need of a number.
    HasValue { given: Given, need: u32 },
    /// What the claim needs, in the case that it has a value.
    ClaimHasValue { need: u32, within: When },
    /// Opens a case. Makes no fact.
    Suppose { says: Relation, manner: Manner },
    /// The supposition of a case, as a fact in it.
    Supposition { case: CaseId, within: When },
    /// The same at fewer times; `because` shows that a fixed time is among the chosen ones.
    Restrict { fact: FactId, to: When, because: Vec<FactId> },
    /// Shows that the chosen times are an open set. Makes no fact.
    Open { because: Vec<FactId> },
    /// Shows that all times are chosen. Makes no fact.
    Everywhere { because: Vec<FactId> },
    /// The derivative by time of an equation.
    Rate { fact: FactId },
    /// The derivative by a coordinate of an equation.
    Partial { fact: FactId, by: String, component: u16 },
    /// An equation l = r with d·(l − r) = Σ qᵢ·(lᵢ − rᵢ), where lᵢ = rᵢ are facts, as soon as the right side of each fact of `insert`, in
    /// their order, is put for its left side; and as soon as multiples of facts of `modulo` are taken away.
    Zero {
        says: Relation,
        multiplier: Term,
        terms: Vec<(FactId, Term)>,
        insert: Vec<FactId>,
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        modulo: Vec<FactId>,
    },
    /// The same with fewer needs.
    Discharge { fact: FactId, because: Vec<FactId> },
    /// What is so in each of the cases.
    Close { within: When, split: Split, branches: Vec<FactId>, because: Vec<FactId> },
    /// e = e(c), since the rate of e is 0.
    Conserved { of: Term, at: Instant, rate: FactId, because: Vec<FactId> },
    /// eᵢ = 0 for all i, since ėᵢ = Σ gᵢⱼ·eⱼ and eᵢ(c) = 0. The fact is about the first of them.
    Vanishes {
        of: Vec<Term>,
        matrix: Vec<Vec<Term>>,
        at: Instant,
        rates: Vec<FactId>,
        starts: Vec<FactId>,
        because: Vec<FactId>,
    },
    /// A relation in which equals are put for equals; without `from`, l = r whose sides become the same.
    Congruence { says: Relation, from: Option<FactId>, equal: Vec<FactId> },
    /// An identity of the list of laws.
    Law { law: Law, of: Vec<Term> },
    /// A relation, by the rules of signs.
    Sign { says: Relation, from: Vec<FactId> },
    /// A term of a sum of terms that are not negative is 0, since the sum is.
    Summand { sum: FactId, term: Term, from: Vec<FactId> },
    /// Arguments are equal, since the values of an injective operation are.
    Injective { fact: FactId, from: Vec<FactId> },
    /// A symbol has a further continuous rate, since its highest one is a function that has. Makes no fact.
    Smooth { fact: FactId, because: Vec<FactId> },
    /// Symbols are analytic, since they solve a system with analytic right sides. Makes no fact.
    Analytic { equations: Vec<FactId>, because: Vec<FactId> },
    /// An equation between analytic functions holds at all times, since it holds on an open set.
    Continue { fact: FactId, because: Vec<FactId> },
    /// A motion on which all that is given is true, and so is the claim at the time `at`, which is chosen: rational functions of time for
    /// the symbols that move, by name and component, and numbers for the constants. Makes no fact.
    Model { values: Vec<(String, u16, Term)>, at: String },
    /// The last step: the fact is the claim. Makes no fact.
    Conclude { fact: FactId },
}
