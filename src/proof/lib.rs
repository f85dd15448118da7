//! Identities, for all values of all symbols.
//!
//! **In:** equations, and premises: equations, things that are not 0, things that are positive. **Out:** [`Identity`]:
//! *proved*, with a bound for the probability that this is wrong; *refuted*, with a real point that a reader can check;
//! or *undecided*, with the reason.
//!
//! # Procedure
//!
//! 1. Premises are differentiated by time as far as the claim and hidden constraints ask for (`closing`); explicit definitions
//!    are inserted (`prepare`).
//! 2. Logarithms are taken apart by factors (`logarithm`). Transcendental functions become rational functions of generators (`lower`), arguments being compared as rational
//!    combinations of monomials (`linear`), and these as rational functions (`fractions`).
//! 3. |a| in a premise is written σ·a with a sign σ (`absolute`). Orthogonal matrices among the premises are recognised and parametrised (`orthogonal`); a sum of squares that vanishes
//!    is several equations, since all leaves are real. The other premises are solved, equation by equation, for unknowns in
//!    which they have degree 1 or 2 (`solve`): the common solutions are parametrised by the leaves that stay free. Products
//!    are split into cases.
//! 4. Roots and |·| are brought to a normal form (`roots`): σ·√b, with one sign σ = ±1 for each distinct b.
//! 5. Every case is evaluated at random points over GF(p²), p drawn, for **all** choices of the signs (`field`).
//!    All residuals 0: the case is proved. Some not 0: not an identity on that choice of signs. A choice of signs on which a
//!    denominator of a formula vanishes and no pivot of step 3 does is void, since the formulas have no value there; its
//!    denominators are then counted in the bound, because it must be told from a choice on which they vanish by chance.
//! 6. In the second case real points decide (`witness`): one that satisfies every premise as given, and at which the two
//!    sides differ by more than their error bounds, refutes, if a motion passes through it (`closing`). None found: the case is taken apart by the signs in its
//!    definitions, of which what is given may exclude one; or it is undecided.
//! 7. What was divided by in step 3 is looked at by itself: the case that it vanishes is solved and tested in the same way.
//!    What cannot be settled so is reported as a condition, [`Condition::Pivot`]. Pivots of definitions on which neither the
//!    conclusion nor a choice of cases depends do not count: those premises could have been left out. A contradiction counts
//!    as one only if it remains where pivots vanish, and where bases of powers are 0. Conditions are restated briefly
//!    (`restate`).
//!
//! # The bound
//!
//! Let x be the free leaves, r = (r₁ … r_k) the roots of a case with rⱼ² = ρⱼ(x, r₁ … rⱼ₋₁), V the set of all (x, r), and
//! N/D a residual as the tape computes it, N and D polynomials in x and r with integer coefficients. (A division rewrites a
//! root √(n/d) as √(nd)/d, so that every r is integral over ℤ\[x\].)
//!
//! **Theorem.** If N does not vanish on an irreducible component C of V on which the premises hold, the probability that one
//! trial does not show it is at most h/61 · 2⁻⁵⁴ + 64·33·d · 2⁻⁶¹, with d and h the degree and the height (log₂ of the largest
//! coefficient) of the norm of N.
//!
//! *Proof.* V is finite over the space of x and no component lies over a proper subset of it, as ℤ\[x, r\] is free over ℤ\[x\].
//! So the norm N_C of N from the function field of C to ℚ(x) is not 0; it is a polynomial with integer coefficients, because
//! N is integral over ℤ\[x\], which is integrally closed. It is a product of at most 2ᵏ conjugates of N, each of degree at most
//! deg N (counting a root as half the degree of its square) and, for |xᵢ| = 1, of absolute value at most 2^{bits N}; so its
//! degree is at most d = 2ᵏ·deg N, and its coefficients are at most 2ʰ with h = 2ᵏ·bits N, by Cauchy's estimate. These two
//! numbers are propagated through the tape (`growth`), fractions never being reduced. Now let p be a prime and x a point over
//! GF(p). C is integral over ℤ\[x\], so some point (x, r) of C lies over x (lying over), with r in GF(p²) or the draw is
//! discarded. At it the premises hold, so this choice of signs is among those admitted; and if N = 0 there, N_C(x) = 0 mod p,
//! since N is a zero of its characteristic polynomial, whose last coefficient is ±N_C. So a trial that sees only zeros has
//! drawn a prime that divides all coefficients of N_C, or a zero of N_C mod p. At most h/61 primes above 2⁶¹ divide
//! a nonzero coefficient, of more than 2⁵⁴ primes that are drawn from
//! ([`FiniteField::LOG2_PRIMES`](number::FiniteField::LOG2_PRIMES)). A nonzero polynomial of degree d has at most
//! d·pⁿ⁻¹ zeros (Schwartz 1980, lemma 1; Zippel 1979, theorem 1): probability d/p for one point. A trial may discard a point,
//! where no root exists or a denominator vanishes, at most 64 times: the sum over all points covers that, whatever is
//! discarded. A premise that is not solved for excludes a choice of signs only where it takes one of at most 32 constant
//! values, or depends on no free leaf: 33 events in place of one. ∎
//!
//! Trials are independent in prime and points; their number is chosen so that the product of the bounds is below the target,
//! 2⁻¹⁰⁰ by default. What `solve` and `roots` took as zero on the strength of a few points is tested with the residuals and
//! counted in d and h. The idea is that of Gonnet (1984) and of Maple's `testeq`; a fixed prime or an assumed degree would not
//! do, as a false identity can be built for either.
//!
//! A proof over all choices of signs holds for the real roots, whichever they are. Leaving out a premise, or missing a
//! relation between generators, enlarges V: it can lose a proof, not forge one. The random numbers come from a seeded
//! generator; the probability is over its seed.
//!
//! # What a proof does not say
//!
//! * It holds where all denominators are not 0 and all formulas have real values: [`Proof::conditions`].
//! * Common solutions of the premises at which a [`Condition::Pivot`] vanishes were not reached, unless they are limits of
//!   others: a triangular resolution describes the generic components only. Where all solutions are of that kind, a formula
//!   divides by 0 identically, and the answer is [`Reason::NoValue`].
//! * Premises that have no real solution at all imply everything, and so do those whose real solutions all lie where a pivot
//!   vanishes. A proof shows [`Proof::example`], a real point that satisfies them and at which no pivot vanishes, or says
//!   that none was found. Steps of derivations take a proof with pivots and without an example for none.
//!
//! # What is not decided
//!
//! Relations between functions beyond those of `logarithm`, `roots` and `relate`; arguments that are equal, but by no proof of
//! their own; premises of degree above 2 in every unknown, where the claim holds; identities that depend on signs of roots
//! which neither the normal form nor a real point settles; more than [`Options::most_signs`] independent roots. A false
//! equation of that kind is still refuted when a real point shows it.
//!
//! # What is looked at when the field leaves a question open
//!
//! `relate` has the ways, each of which ends in another question or in certainty: algebraic numbers are compared exactly
//! (`algebraic`), logarithms by exponentials, products of powers by logarithms (`powers`), roots by their squares (`squares`), angles by their cosine and range (`range`), functions by their arguments; premises
//! are written with lower degrees (`simpler`), and real points that satisfy them are found by Newton's method (`newton`): to refute, or as
//! an example of a proof.
//!
//! # The second route
//!
//! `certify` (feature `certificates`) looks for an exact certificate, d·conclusion = Σ qᵢ·premiseᵢ, that any
//! computer algebra system can expand. It shares the reading of the formulas (steps 1 and 2) with the first, nothing else.
//!
//! # Positive parameters
//!
//! [`order`] decides the signs of expressions in positive parameters by themselves, for every order of their sizes.
//!
//! # Sources
//!
//! J. T. Schwartz, *J. ACM* 27 (1980) 701; R. Zippel, EUROSAM 1979, LNCS 72, 216; G. H. Gonnet, STOC 1984, 334;
//! J. Ax, *Ann. Math.* 93 (1971) 252; O. Ramaré & R. Rumely, *Math. Comp.* 65 (1996) 397.

#![forbid(unsafe_code)]

mod absolute;
mod algebraic;
mod along;
mod apart;
mod bounds;
mod branches;
#[cfg(feature = "certificates")]
mod budget;
mod certificate;
mod closing;
mod conditions;
pub mod exact;
mod field;
mod follows;
mod fractions;
mod generators;
mod growth;
mod implied;
mod insertion;
mod inverse;
mod jets;
mod known;
mod linear;
mod logarithm;
mod lowering;
#[cfg(feature = "certificates")]
mod membership;
mod memory;
#[cfg(feature = "certificates")]
mod names;
mod newton;
#[cfg(feature = "certificates")]
mod notation;
pub mod order;
mod orthogonal;
mod outcome;
mod passive;
mod polynomial;
mod powers;
mod prepare;
mod probe;
mod prove;
mod range;
mod rates;
mod relate;
mod restate;
#[cfg(feature = "certificates")]
mod ring;
mod roots;
mod sign;
mod simpler;
mod solve;
mod squares;
mod structure;
mod values;
mod witness;

pub use along::{Along, Apart, InTime, Refuted, along};
pub use apart::by_domain;
pub use branches::{Branches, Branching, branches_test, branches_test_after};
pub use certificate::{Certificate, Cofactor, Effort, NoCertificate, Origin, Program, certify};
pub use conditions::domains;
pub use follows::follows;
pub use inverse::solve_for_arguments;
pub use known::{Known, When};
pub use memory::Memory;
pub use outcome::{Condition, Identity, Options, Point, PointValue, Premises, Proof, Reason, Refutation, Side, Wanted};
pub use prepare::is_never_negative;
pub use prove::{excludes_motions, identity_test, identity_test_after, with_values_of_places};
