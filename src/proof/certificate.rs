//! Certificates: identities of polynomials that prove an equation, and that anyone can expand.
//!
//! The conclusion, with its fractions cleared, is a polynomial N in the leaves, in cosines, sines and exponentials, and in one
//! variable for each root and each |·|. The premises, with their fractions cleared, and the relations c² + s² − 1,
//! r²·d − n (r = √(n/d)), a² − u² (a = |u|) are polynomials pᵢ. A certificate is an identity of polynomials with integer
//! coefficients
//!
//! > d·N = Σ qᵢ·pᵢ
//!
//! with d a product of things that are not 0 (denominators, premises ≠ 0): wherever the formulas have a value and the premises
//! hold, N = 0. [`certify`] looks for one, see `membership`; [`Certificate::sympy`] is the text for a reader who wants to
//! check it in a computer algebra system. How it was found does not matter for that.

use super::outcome::{Premises, Reason};
use expr::{Expr, Graph};
use serde::{Deserialize, Serialize};

/// A certificate for one equation. Polynomials are written as in Python.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Certificate {
    /// Number of the equation among those tested.
    pub equation: usize,
    /// The equation, in LaTeX.
    pub formula: String,
    /// Definitions that were put in for what the equation names, in LaTeX.
    pub definitions: Vec<String>,
    /// What was divided by when a premise was solved for something to put in, in LaTeX: the certificate says nothing of points
    /// where one of these is 0.
    pub divided_by: Vec<String>,
    /// The variables of the polynomials, and what they stand for, in LaTeX.
    pub variables: Vec<(String, String)>,
    /// d: not 0 where the formulas have a value and the premises hold.
    pub multiplier: String,
    /// The things that are not 0 of which d is a product, in LaTeX; empty where d is a number.
    pub not_zero: Vec<String>,
    /// N: the conclusion's numerator.
    pub conclusion: String,
    /// D: the conclusion's denominator.
    pub under: String,
    /// The relations that are used.
    pub terms: Vec<Cofactor>,
    /// The same for a program, which computes N and every p from what is claimed and given.
    pub program: Program,
}

/// A claim as a reader's program has it: texts in the notation of Python, see `written`.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Program {
    /// Names of everything that a number can be put in for.
    pub names: Vec<String>,
    /// Left and right side of the claim.
    pub sides: (String, String),
    /// Names with what they are by what is given, or parts of long texts.
    pub definitions: Vec<(String, String)>,
    /// Calls of functions, each with the quotient of polynomials that stands for it.
    pub functions: Vec<(String, String)>,
    /// Variables that stand for functions.
    pub variables: Vec<(String, String)>,
    /// For each of the relations that are used, what is equal.
    pub relations: Vec<(String, String)>,
}

/// A relation with its cofactor.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Cofactor {
    /// Where the relation comes from.
    pub origin: Origin,
    /// p: vanishes where what is given holds.
    pub relation: String,
    /// q.
    pub cofactor: String,
}

/// Where a relation of a certificate comes from.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Origin {
    /// An equation that is given, definitions inserted, in LaTeX.
    Premise(String),
    /// The derivative by time of one.
    Rate(String),
    /// Two variables are the cosine and the sine of one angle: c² + s² = 1.
    Circle,
    /// A variable is a root, which is squared.
    Root,
    /// A variable is an absolute value, which is squared.
    AbsoluteValue,
}

/// Why there is no certificate.
#[derive(Clone, Debug, PartialEq)]
pub enum NoCertificate {
    /// Given up: too many terms, or too much work. This says nothing about the identity.
    TooLarge,
    /// The conclusion is not in the ideal of the premises and relations. They may still imply it: over the reals only, or for
    /// roots that are not negative.
    NotMember {
        /// Number of the equation.
        equation: usize,
    },
    /// An exact normal form shows that the equation is no identity: nothing is given but c² + s² = 1, and the numerator,
    /// reduced by it, is not 0.
    Refuted {
        /// Number of the equation.
        equation: usize,
    },
    /// The formulas could not be brought to polynomials.
    NotPolynomial(Reason),
    /// The program was built without the feature `certificates`.
    NotBuilt,
}

impl std::fmt::Display for NoCertificate {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            NoCertificate::TooLarge => f.write_str("the polynomials are too large for the work that is allowed"),
            NoCertificate::NotMember { .. } => f.write_str(
                "the conclusion is no combination of the premises with polynomials as coefficients; signs of roots, or \
                 real numbers, are needed",
            ),
            NoCertificate::Refuted { .. } => f.write_str("the exact normal form of the difference is not 0"),
            NoCertificate::NotPolynomial(reason) => write!(f, "there are no polynomials: {reason}"),
            NoCertificate::NotBuilt => f.write_str("this program was built without certificates"),
        }
    }
}

/// How much is done to find a certificate. All limits are counts, so that the outcome depends on nothing else.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// Largest number of terms of a polynomial.
    pub terms: usize,
    /// Arithmetic with coefficients: one unit for each operation, and for each product of words in it.
    pub work: u64,
}

impl Effort {
    /// Milliseconds.
    pub const QUICK: Effort = Effort { terms: 1000, work: 20_000 };
    /// Seconds.
    pub const THOROUGH: Effort = Effort { terms: 4000, work: 20_000_000 };
}

impl Certificate {
    /// One line for SymPy that prints 0.
    pub fn sympy(&self) -> String {
        let names: Vec<&str> = self.variables.iter().map(|(n, _)| n.as_str()).collect();
        let sum: Vec<String> = self.terms.iter().map(|t| format!("({})*({})", t.cofactor, t.relation)).collect();
        let sum = if sum.is_empty() { "0".to_owned() } else { sum.join(" + ") };
        // `symbols` gives a tuple for a name with a comma after it, whether there are others or not.
        let symbols = match names.as_slice() {
            [] => String::new(),
            names => format!("{}, = symbols('{},'); ", names.join(", "), names.join(", ")),
        };
        let left = format!("({})*({})", self.multiplier, self.conclusion);
        format!("from sympy import expand, symbols; {symbols}print(expand({left} - ({sum})))")
    }
}

/// Certificates for all equations.
///
/// # Errors
/// [`NoCertificate`]; an identity without a certificate may still hold, unless it is [`NoCertificate::Refuted`].
#[cfg(feature = "certificates")]
pub fn certify(
    graph: &mut Graph,
    equations: &[(Expr, Expr)],
    given: &Premises,
    effort: Effort,
) -> Result<Vec<Certificate>, NoCertificate> {
    // It says what is so wherever the formulas have values: what restricts them does not matter.
    let mut plain = |&(l, r): &(Expr, Expr)| (graph.unrestricted(l), graph.unrestricted(r));
    let equations: Vec<(Expr, Expr)> = equations.iter().map(&mut plain).collect();
    let equations_given = given.equations.iter().map(|k| k.with(plain(&k.sides()))).collect();
    let given = Premises { equations: equations_given, ..given.clone() };
    super::membership::certify(graph, &equations, &given, effort)
}

/// No certificates: the program was built without them.
///
/// # Errors
/// Always.
#[cfg(not(feature = "certificates"))]
pub fn certify(_: &mut Graph, _: &[(Expr, Expr)], _: &Premises, _: Effort) -> Result<Vec<Certificate>, NoCertificate> {
    Err(NoCertificate::NotBuilt)
}
