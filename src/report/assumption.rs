//! What a claim could say that it assumes: what its proof uses, and what separates the motions on which it holds.
//!
//! **In:** a file, and the account of a claim. **Out:** texts that can be put into the file, each with its place. **Guaranteed:** an assumption is
//! offered, and nothing is judged; what the claim assumes by its own words is not offered again.

use super::finding::{Fix, Place};
use super::hypotheses::{excluded, uses};
use super::tally::declared;
use super::wording::dense;
use derivation::{Claim, Derivation};
use findings::ClaimAccount;
use findings::conditions::Need;
use reason::{Bounded, Proviso, Term};

/// Most assumptions that are offered of a claim.
const MOST: usize = 4;

/// The assumptions that a claim could make, each as a change of its file.
pub fn assumptions(derivation: &Derivation, claim: &ClaimAccount) -> Vec<Fix> {
    let Some(own) = declared(derivation, claim) else { return Vec::new() };
    let known: Vec<String> = claim.assumptions.iter().map(|a| dense(a)).collect();
    let mut formulas: Vec<String> = Vec::new();
    let terms = claim.identity.as_ref().filter(|i| i.finding.is_proved_in_part()).map(|i| i.terms());
    for (term, provisos) in terms.unwrap_or_default().into_iter().filter(|(term, _)| uses(*term)) {
        let is_left_out = term == Term::Exception;
        formulas.extend(provisos.iter().filter_map(|p| if is_left_out { written(&excluded(p)) } else { written(p) }));
    }
    let needed = claim.conditions.assumptions.iter().filter(|a| a.need == Need::Needed);
    formulas.extend(needed.map(|a| a.text.clone()));
    let mut offered: Vec<Fix> = Vec::new();
    for formula in formulas.into_iter().filter(|f| !known.contains(&dense(f)) && !f.contains(['\'', '\n'])) {
        let fix = put(derivation, own, &formula);
        offered.extend(fix.filter(|fix| offered.iter().all(|other| other.text != fix.text)));
    }
    offered.truncate(MOST);
    offered
}

/// A condition as a formula of a file; `None` for what is no formula.
fn written(of: &Proviso) -> Option<String> {
    match of {
        Proviso::Where { formula, is } => Some(match is {
            Bounded::NotZero => format!(r"{formula}\ne0"),
            Bounded::Zero => format!("{formula}=0"),
            Bounded::NotNegative => format!(r"{formula}\ge0"),
            Bounded::Positive => format!("{formula}>0"),
            Bounded::Negative => format!("{formula}<0"),
            Bounded::NotPositive => format!(r"{formula}\le0"),
            Bounded::ByOne => format!(r"|{formula}|\le1"),
        }),
        Proviso::Written(formula) => Some(formula.to_string()),
        Proviso::Orders(_) | Proviso::Leap(_) | Proviso::Pole(_) | Proviso::Hole(_) | Proviso::OtherSign => None,
    }
}

/// The change: behind the assumptions that there are, or in a line of its own below the name of the claim.
fn put(derivation: &Derivation, claim: &Claim, formula: &str) -> Option<Fix> {
    let text = &derivation.file.text;
    let says = "Assume what is used".to_owned();
    if let Some(last) = claim.assuming.last() {
        let quote = text[last.span.end..].chars().next().filter(|c| matches!(c, '\'' | '"'))?;
        let at = last.span.end + quote.len_utf8();
        let is_one = text.get(at..at + 2) != Some(&format!("{quote}{quote}"));
        return is_one.then(|| Fix {
            place: Place::new(&derivation.file, at..at),
            text: format!(", '{formula}'"),
            says,
        });
    }
    let start = text[..claim.span.start].rfind('\n').map_or(0, |at| at + 1);
    let at = text[claim.span.end..].find('\n').map(|at| claim.span.end + at + 1)?;
    let is_own_line = text[start..].trim_start().starts_with("id") && text[claim.span.end..at].trim().len() <= 1;
    is_own_line.then(|| Fix {
        place: Place::new(&derivation.file, at..at),
        text: format!("assuming = ['{formula}']\n"),
        says,
    })
}
