//! `certificates/`: the exact proofs of a report, one file for each claim, for a reader who wants to check them.
//!
//! A file is a text and a program: `python t8.py` prints one 0 for each equation, if SymPy is installed. The polynomials are
//! those that were verified; nothing is computed here.

use super::tally::name;
use crate::check::{Account, Certificate, ClaimAccount, IdentityAccount, Origin};
use crate::derivation::Derivation;

/// The folder of the certificates in that of a report, and the ending of their names.
pub const CERTIFICATES: (&str, &str) = ("certificates", "py");

/// The certificate's file of a claim, below the folder of the report; `None` where it has none.
pub(super) fn file_name(claim: &ClaimAccount) -> Option<String> {
    let identity = claim.identity.as_ref().filter(|i| is_certified(i))?;
    let (folder, ending) = CERTIFICATES;
    (!identity.evidence.certificates.is_empty())
        .then(|| format!("{folder}/{}.{ending}", name(claim).replace('/', "--")))
}

/// Whether a proof has certificates for all of its equations.
pub(super) fn is_certified(identity: &IdentityAccount) -> bool {
    identity.verdict == "proved" && !identity.evidence.certificates.is_empty()
}

/// Path and text of every certificate of a report.
pub fn certificates(derivation: &Derivation, account: &Account) -> Vec<(String, String)> {
    let one = |claim: &ClaimAccount| {
        let identity = claim.identity.as_ref()?;
        let title = format!("{} / {}: {}", derivation.id, name(claim), claim.says);
        Some((file_name(claim)?, certificate_text(&title, &identity.from, &identity.evidence.certificates)))
    };
    account.claims.iter().filter_map(one).collect()
}

/// The text of a file.
pub fn certificate_text(title: &str, given: &[String], certificates: &[Certificate]) -> String {
    let mut out = String::new();
    comment(&mut out, title);
    out.push_str("#\n");
    let beside = match given {
        [] => "the definitions and assumptions".to_owned(),
        given => format!("the definitions, the assumptions and {}", given.join(", ")),
    };
    comment(&mut out, &format!("Given: {beside}."));
    out.push_str(
        "#\n\
         # Each equation below is proved by an identity of polynomials, d*N = q1*p1 + q2*p2 + ...\n\
         # N is the difference of its sides, without its denominator. Every p is 0 where what is given holds,\n\
         # and d is not 0 there, where the formulas have a value. So N is 0 there, and the equation holds.\n\
         # Run with Python and SymPy, this file prints one 0 for each equation.\n\
         \n\
         from sympy import expand, symbols\n",
    );
    for certificate in certificates {
        one_equation(&mut out, certificate);
    }
    out
}

/// A comment of one line.
fn comment(out: &mut String, text: &str) {
    let line = text.split_whitespace().collect::<Vec<_>>().join(" ");
    out.push_str(&format!("# {line}\n"));
}

fn one_equation(out: &mut String, certificate: &Certificate) {
    out.push('\n');
    comment(out, &format!("Equation {}: {}", certificate.equation + 1, certificate.formula));
    for definition in &certificate.definitions {
        comment(out, &format!("where {definition}"));
    }
    for divisor in &certificate.divided_by {
        comment(out, &format!("where {divisor} is not 0"));
    }
    if !certificate.variables.is_empty() {
        comment(out, "Variables:");
        for (name, meaning) in &certificate.variables {
            comment(out, &format!("  {name} stands for {meaning}"));
        }
        let names: Vec<&str> = certificate.variables.iter().map(|(name, _)| name.as_str()).collect();
        let names = names.join(", ");
        out.push_str(&format!("{names}, = symbols(\"{names},\")\n"));
    }
    let mut products = Vec::new();
    for (at, term) in certificate.terms.iter().enumerate() {
        let number = at + 1;
        let (origin, words) = &term.meaning;
        comment(
            out,
            &match origin {
                Origin::Premise => format!("p{number} = 0 because of what is given: {words}"),
                Origin::Rate => format!("p{number} = 0 because of the derivative of what is given: {words}"),
                Origin::Variable => format!("p{number} = 0 because of what the variables stand for: {words}"),
            },
        );
        out.push_str(&format!("p{number} = {}\nq{number} = {}\n", term.relation, term.cofactor));
        products.push(format!("q{number}*p{number}"));
    }
    if !certificate.not_zero.is_empty() {
        comment(out, "d is a product of these, which are not 0:");
        for factor in &certificate.not_zero {
            comment(out, &format!("  {factor}"));
        }
    }
    out.push_str(&format!("d = {}\nN = {}\n", certificate.multiplier, certificate.conclusion));
    let sum = if products.is_empty() { "0".to_owned() } else { products.join(" + ") };
    out.push_str(&format!("print(expand(d*N - ({sum})))\n"));
}
