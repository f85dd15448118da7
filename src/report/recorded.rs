//! Whether a proof is recorded, and its steps: for people.
//!
//! **In:** [`Recorded`], or what a replay came to. **Out:** a sentence, the sequents in words and the numbered steps; text for a terminal, or a fold of the page.

use super::page::text::prose;
use super::text::paragraph;
use checker::{Shown, Told};
use findings::{Account, Recorded};
use latex::Scope;
use maud::{Markup, html};

/// How many proofs of an account are recorded; nothing where none were looked for.
pub(super) fn count(account: &Account) -> String {
    let all: Vec<&Recorded> =
        account.claims.iter().filter_map(|claim| claim.identity.as_ref()?.recorded.as_ref()).collect();
    let recorded = all.iter().filter(|r| r.steps().is_some()).count();
    match all.len() - recorded {
        _ if all.is_empty() => String::new(),
        0 => format!("proofs: all {recorded} are recorded, and replayed by the checker\n"),
        others => format!(
            "proofs: {recorded} of {} are recorded, and replayed by the checker; {others} rest on the prover alone\n",
            all.len()
        ),
    }
}

/// Most steps of one relation that are printed; all are in `proofs.json`.
const MOST_STEPS: usize = 60;

/// How a replay ended, in words.
pub(super) fn shown_words(shown: &Shown) -> String {
    let mut out = format!("{} steps, from {}", shown.steps(), shown.rests_on());
    if shown.log2_error() > f64::NEG_INFINITY {
        let error = shown.log2_error().ceil();
        out += &format!("; an identity was tried at random, with an error probability of at most 2^{error:.0}");
    }
    match shown.leaves_out().len() {
        0 => {}
        1 => out += "; a case is left out",
        n => out += &format!("; {n} cases are left out"),
    }
    out
}

/// The steps that are printed, and how many are not.
fn printed(told: &Told) -> (&[String], usize) {
    let count = told.steps.len().min(MOST_STEPS);
    (&told.steps[..count], told.steps.len() - count)
}

/// The sentence, the sequents and the steps, indented.
pub(super) fn text(recorded: &Recorded) -> String {
    let mut out = paragraph(&recorded.sentence(), 2);
    for told in recorded.told() {
        out += &format!("\n{}", paragraph(&told.sequent, 4));
        let (steps, more) = printed(told);
        for (at, step) in steps.iter().enumerate() {
            out += &paragraph(&format!("{}. {step}", at + 1), 6);
        }
        if more > 0 {
            out += &paragraph(&format!("and {more} steps more, which are in proofs.json of the report"), 6);
        }
        out += &paragraph(&format!("Replayed: {}.", shown_words(&told.shown)), 4);
    }
    out
}

/// The same in a fold of the page.
pub(super) fn fold(recorded: &Recorded, scope: &Scope) -> Markup {
    html! {
        @if recorded.steps().is_some() {
            details.steps {
                summary { "The proof, step by step" }
                @for told in recorded.told() {
                    p { (prose(&told.sequent, scope)) }
                    @let (steps, more) = printed(told);
                    ol { @for step in steps { li { (prose(step, scope)) } } }
                    @if more > 0 { p { "And " (more) " steps more, which are in proofs.json." } }
                    p { "Replayed: " (shown_words(&told.shown)) "." }
                }
            }
        }
    }
}
