//! What the decision on an equation for all values rests on: random tests, certificates, a point that refutes.

use proof::Certificate;
use serde::{Deserialize, Serialize};

/// What the verdict on an identity rests on.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct IdentityEvidence {
    /// The random test, where it proved.
    pub trials: Option<Trials>,
    /// One for each equation, where all have one: then it is proved outright.
    pub certificates: Vec<Certificate>,
    /// Why there is no certificate, where one was looked for.
    pub no_certificate: Option<String>,
    /// The point that refutes, where there is one.
    pub counterexample: Option<Counterexample>,
    /// For formulas with ±: which sign it holds for.
    pub branch: Option<reason::SignsProved>,
    /// What is given cannot hold together.
    pub contradiction: bool,
}

/// The random test: how much was tried, and what bounds the probability of an error.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Trials {
    /// Independent trials, each with a prime and points of its own.
    pub count: usize,
    /// The primes p; the points are from GF(p²).
    pub primes: Vec<u64>,
    /// Bound for the degree of the polynomials whose vanishing was tested.
    pub degree: f64,
    /// Bound for log₂ of their coefficients.
    pub height: f64,
    /// Independent signs of roots and |·|; all choices were tested.
    pub signs: usize,
    /// Cases into which products among the premises were split.
    pub cases: usize,
}

/// A point at which everything given holds, and an equation does not.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Counterexample {
    /// Number of the equation.
    pub equation: usize,
    /// The point, and the sides there.
    pub first: Place,
    /// Another point, with another difference of the sides: what is given does not fix it.
    pub second: Option<Place>,
}

/// A point at which everything given holds, and the sides of an equation there.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Place {
    /// The left side: a rational number where it is one, otherwise decimals.
    pub left: String,
    /// The right side.
    pub right: String,
    /// LaTeX name and value of everything that the sides name; `\cos x` and `\sin x` where these are rational and x is not.
    pub point: Vec<(String, String)>,
    /// The same of what the premises ask for beyond that.
    pub beyond: Vec<(String, String)>,
}

/// What is asked.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Proposition {
    /// Equations, in LaTeX.
    pub formula: String,
    /// Premises: relations in LaTeX, or names of claims and systems of the derivation.
    pub given: Vec<String>,
    /// For formulas with ±: one sign must serve all points; otherwise at each point one or the other.
    pub throughout: bool,
}
