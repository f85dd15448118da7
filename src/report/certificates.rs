//! `certificates/`: the exact proofs of a report, one file for each claim, for a reader who wants to check them.
//!
//! A file is a text and a program: `python proof-t8.py` prints one 0 for each equation, if SymPy is installed. The polynomials are
//! those that were verified; nothing is computed here.

use super::tally::name;
use derivation::Derivation;
use diag::escape::in_one_line;
use findings::{Account, Certificate, ClaimAccount, IdentityAccount, Origin};
use reason::Premises;

/// The folder of the certificates in that of a report, and the endings of their names.
pub const CERTIFICATES: (&str, &[&str]) = ("certificates", &["py", "lean"]);

/// The ending of a program for SymPy.
const SYMPY: &str = "py";

/// The certificate's file of a claim, below the folder of the report; `None` where it has none.
pub(super) fn file_name(claim: &ClaimAccount) -> Option<String> {
    let identity = claim.identity.as_ref().filter(|i| is_certified(i))?;
    let (folder, ending) = (CERTIFICATES.0, SYMPY);
    (!identity.evidence.certificates.is_empty()).then(|| format!("{folder}/{}.{ending}", file_stem(claim)))
}

/// A name of a file for each claim and reading. A hyphen stands in each: no module of Python has one in its name, so that the folder of the
/// file, which is looked through for modules, has none for another file. No id has an `@`, but one may have two hyphens; where letters are capitals, a number says which, as
/// some systems do not tell case.
fn file_stem(claim: &ClaimAccount) -> String {
    let stem = match claim.id.contains("--") {
        true => format!("{}@{}", claim.id, claim.reading.as_deref().unwrap_or_default()),
        false => name(claim).replace('/', "--"),
    };
    let places = stem.chars().zip(1_u64..).filter(|(c, _)| c.is_uppercase()).map(|(_, place)| place);
    match places.fold(0_u64, |sum, place| sum.wrapping_mul(1_000_003).wrapping_add(place)) {
        0 => format!("proof-{stem}"),
        capitals => format!("proof-{stem}@{capitals:x}"),
    }
}

/// Whether a proof has certificates for all of its equations.
pub(super) fn is_certified(identity: &IdentityAccount) -> bool {
    identity.finding.is_proved_in_part() && !identity.evidence.certificates.is_empty()
}

/// Path and text of every certificate of a report.
pub fn certificates(derivation: &Derivation, account: &Account) -> Vec<(String, String)> {
    let one = |claim: &ClaimAccount| {
        let identity = claim.identity.as_ref()?;
        let title = format!("{} / {}: {}", derivation.id, name(claim), claim.says);
        let (file, found) = (file_name(claim)?, &identity.evidence.certificates);
        let lean = found
            .iter()
            .any(says_something)
            .then(|| (file.replace(&format!(".{SYMPY}"), ".lean"), lean_text(&title, &identity.from, found)));
        Some([(file, certificate_text(&title, &identity.from, found))].into_iter().chain(lean))
    };
    account.claims.iter().filter_map(one).flatten().collect()
}

/// The program that every file begins with: it knows nothing of any claim.
const CHECK: &str = include_str!("certificate.py");
/// Why a relation holds that is none of those that are given.
const STANDS_FOR: &str = "what the variables stand for";

/// The text of a file.
pub fn certificate_text(title: &str, given: &[String], certificates: &[Certificate]) -> String {
    // What says in the first line or the second how a file of Python is encoded is obeyed: no text of a stranger shall.
    let mut out = "# -*- coding: utf-8 -*-\n".to_owned();
    head(&mut out, "#", title, given);
    out.push_str(
        "#\n\
         # Each equation below is proved by an identity of polynomials, d*N = q1*p1 + q2*p2 + ...\n\
         # N is the difference of its sides, without its denominator. Every p is 0 where what is given holds,\n\
         # and d is not 0 there, where the formulas have a value. So N is 0 there, and the equation holds.\n\
         # The program computes N from the sides and every p from what is given, as they are written below, and prints\n\
         # one 0 for each equation. It needs Python and SymPy. Whoever changes a side gets another number, and exit code 1.\n\
         # A function is replaced by polynomials in variables that stand for cosines, sines, exponentials, roots; that\n\
         # each replacement is right is looked up at random numbers, to 40 digits.\n\
         \n",
    );
    out.push_str(CHECK);
    for certificate in certificates {
        one_equation(&mut out, certificate);
    }
    // Of many claims all are kept until they are written.
    out.shrink_to_fit();
    out
}

/// What is proved, and from what.
fn head(out: &mut String, mark: &str, title: &str, given: &[String]) {
    for line in [title.to_owned(), String::new(), format!("Given: {}.", Premises(given.to_vec()))] {
        let line = in_one_line(&line);
        out.push_str(format!("{mark} {line}").trim_end());
        out.push('\n');
    }
}

/// A comment of one line.
fn comment(out: &mut String, text: &str) {
    out.push_str(&format!("# {}\n", in_one_line(text)));
}

fn one_equation(out: &mut String, certificate: &Certificate) {
    let program = &certificate.program;
    out.push_str("\n\n");
    comment(out, &format!("Equation {}: {}", certificate.equation + 1, certificate.formula));
    for definition in &certificate.definitions {
        comment(out, &format!("where {definition}"));
    }
    for divisor in &certificate.divided_by {
        comment(out, &format!("where {divisor} is not 0"));
    }
    for (name, meaning) in &certificate.variables {
        comment(out, &format!("{name} stands for {meaning}"));
    }
    if !certificate.not_zero.is_empty() {
        comment(out, "d is a product of these, which are not 0:");
        for factor in &certificate.not_zero {
            comment(out, &format!("  {factor}"));
        }
    }
    let names: Vec<String> = program.names.iter().map(|n| quoted(n)).collect();
    out.push_str("check(\n");
    out.push_str(&format!("    names=[{}],\n", names.join(", ")));
    out.push_str(&format!("    left={},\n    right={},\n", quoted(&program.sides.0), quoted(&program.sides.1)));
    out.push_str("    relations=[\n");
    for (term, (left, right)) in certificate.terms.iter().zip(&program.relations) {
        let (what, formula) = match &term.origin {
            Origin::Premise(formula) => ("what is given", formula.as_str()),
            Origin::Rate(formula) => ("the derivative of what is given", formula.as_str()),
            Origin::Circle => (STANDS_FOR, "c² + s² = 1"),
            Origin::Root => (STANDS_FOR, "a root is squared"),
            Origin::AbsoluteValue => (STANDS_FOR, "an absolute value is squared"),
        };
        let why = format!("because of {what}: {formula}");
        out.push_str(&format!("        # {}\n", in_one_line(&why)));
        out.push_str(&format!("        ({}, {}, {}),\n", quoted(left), quoted(right), quoted(&term.cofactor)));
    }
    out.push_str(&format!("    ],\n    d={},\n", quoted(&certificate.multiplier)));
    for (word, pairs) in
        [("definitions", &program.definitions), ("functions", &program.functions), ("variables", &program.variables)]
    {
        if !pairs.is_empty() {
            out.push_str(&format!("    {word}={{\n"));
            for (name, text) in pairs {
                out.push_str(&format!("        {}: {},\n", quoted(name), quoted(text)));
            }
            out.push_str("    },\n");
        }
    }
    out.push_str(")\n");
}

/// A string of Python. The texts have letters, digits and signs of arithmetic only.
fn quoted(text: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || " _+-*/(),".contains(c);
    format!("\"{}\"", text.chars().filter(|c| plain(*c)).collect::<String>())
}

/// Whether a theorem about real numbers says something of an equation: it has premises, or its sides are fractions of the variables.
/// Where all was in the bringing of sides to N / D, what is left is 0 / D = 0.
fn says_something(certificate: &Certificate) -> bool {
    !certificate.terms.is_empty() || is_of_fractions(certificate)
}

fn is_of_fractions(certificate: &Certificate) -> bool {
    certificate.program.functions.is_empty() && certificate.program.definitions.is_empty()
}

/// The same proofs for Lean 4 with Mathlib: one theorem for each equation, about real numbers.
///
/// The steps are those of the certificate, and each is closed by a tactic that decides it: `linear_combination` expands
/// d·N = Σ qᵢ·pᵢ, `field_simp` and `ring` bring the sides to N/D.
pub fn lean_text(title: &str, given: &[String], certificates: &[Certificate]) -> String {
    let mut out = String::new();
    head(&mut out, "--", title, given);
    out.push_str(
        "--\n\
         -- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says\n\
         -- that the difference of the sides, brought to N / D, is 0.\n\
         \n\
         import Mathlib\n",
    );
    for certificate in certificates.iter().filter(|c| says_something(c)) {
        lean_equation(&mut out, certificate);
    }
    out
}

fn lean_equation(out: &mut String, certificate: &Certificate) {
    let program = &certificate.program;
    let lean = |text: &str| text.replace("**", "^");
    out.push_str(&format!("\n-- {}\n", in_one_line(&certificate.formula)));
    for (name, meaning) in &certificate.variables {
        out.push_str(&format!("-- {} stands for {}\n", name, in_one_line(meaning)));
    }
    let names: Vec<&str> = certificate.variables.iter().map(|(name, _)| name.as_str()).collect();
    let binder = if names.is_empty() { String::new() } else { format!(" ({} : ℝ)", names.join(" ")) };
    out.push_str(&format!("theorem equation_{}{binder}\n", certificate.equation + 1));
    let mut sum = Vec::new();
    for (i, term) in certificate.terms.iter().enumerate() {
        out.push_str(&format!("    (h{} : {} = 0)\n", i + 1, lean(&term.relation)));
        sum.push(format!("({}) * h{}", lean(&term.cofactor), i + 1));
    }
    let (d, n, under) = (lean(&certificate.multiplier), lean(&certificate.conclusion), lean(&certificate.under));
    let combination =
        if sum.is_empty() { "ring".to_owned() } else { format!("linear_combination {}", sum.join(" + ")) };
    out.push_str(&format!("    (hd : ({d} : ℝ) ≠ 0) : ({n} : ℝ) / ({under}) = 0 := by\n"));
    out.push_str(&format!("  have key : ({d} : ℝ) * ({n}) = 0 := by {combination}\n"));
    out.push_str(&format!("  have top : ({n} : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd\n"));
    out.push_str("  rw [top, zero_div]\n");
    if is_of_fractions(certificate) {
        // The sides are polynomials or fractions of the same variables, so Lean can be asked for them as well.
        let (left, right) = (lean(&program.sides.0), lean(&program.sides.1));
        out.push_str(&format!(
            "\nexample ({} : ℝ) (hD : ({under} : ℝ) ≠ 0) : ({left} : ℝ) - ({right}) = ({n}) / ({under}) := by\n  \
             field_simp\n  ring\n",
            if program.names.is_empty() { "unused".to_owned() } else { program.names.join(" ") }
        ));
    }
}
