//! Whether a proof is recorded, and its steps: for people.
//!
//! **In:** [`Recorded`], or what a replay came to. **Out:** a sentence, and blocks: the sequents in words, the numbered steps.

use super::story::{StoryBlock, StoryItem, prose};
use super::tally::name;
use super::text::paragraph;
use checker::{Shown, Told};
use findings::{Account, ClaimAccount, Grounds, Recorded, ReplayedRecord};
use latex::Scope;

/// Most claims that a sentence names.
const MOST_NAMED: usize = 12;

/// The claims that are proved, by what the word rests on; nothing where no proofs were looked for.
pub(super) fn by_grounds(account: &Account, wanted: impl Fn(Grounds) -> bool) -> Vec<String> {
    let of = |claim: &ClaimAccount| claim.identity.as_ref()?.recorded.as_ref().map(Recorded::grounds);
    account.claims.iter().filter(|claim| of(claim).is_some_and(&wanted)).map(name).collect()
}

/// What the proofs of an account rest on: a sentence that names those that the checker did not replay; nothing where none were looked for.
pub(super) fn rests(account: &Account) -> Option<String> {
    let all = by_grounds(account, |_| true).len();
    let prover = by_grounds(account, |grounds| grounds == Grounds::Prover);
    let in_part = by_grounds(account, |grounds| matches!(grounds, Grounds::CheckerBut(_))).len();
    let whole = all - prover.len() - in_part;
    let but = match in_part {
        0 => String::new(),
        1 => ", 1 of them but for cases that its steps leave out".to_owned(),
        n => format!(", {n} of them but for cases that their steps leave out"),
    };
    match prover.as_slice() {
        _ if all == 0 => None,
        [] => {
            let proofs = if all == 1 { "the one proof".to_owned() } else { format!("all {all} proofs") };
            Some(format!("The checker replayed {proofs}{but}."))
        }
        named => {
            let first = named.iter().take(MOST_NAMED).cloned().collect::<Vec<_>>().join(", ");
            let more = match named.len().saturating_sub(MOST_NAMED) {
                0 => String::new(),
                n => format!(" and {n} more"),
            };
            let verb = if named.len() == 1 { "rests" } else { "rest" };
            let replayed = whole + in_part;
            Some(format!(
                "The checker replayed {replayed} of {all} proofs{but}; {} {verb} on the prover alone: {first}{more}.",
                named.len()
            ))
        }
    }
}

/// The same, for a terminal.
pub(super) fn count(account: &Account) -> String {
    rests(account).map(|sentence| paragraph(&sentence, 0)).unwrap_or_default()
}

/// Longest sequent that the page prints in full, in characters: `explain` and `audit` print all of it.
const LONGEST_ON_PAGE: usize = 700;

/// How a replay ended, in words.
pub(super) fn shown_words(shown: &Shown) -> String {
    let mut out = format!("{} steps, from {}", shown.steps(), shown.rests_on());
    if shown.log2_error() > f64::NEG_INFINITY {
        let error = shown.log2_error().ceil();
        out += &format!("; an identity was tried at random, with an error probability of at most 2^{error:.0}");
    }
    match shown.leaves_out_words() {
        [] => {}
        all => out += &format!("; where it is not so that {}, it says nothing", all.join(", ")),
    }
    out
}

/// The relations that are shown, each with the number of its steps that are shown. No others are told, for that takes a replay.
fn first(replayed: &ReplayedRecord, most: usize) -> Vec<(Told, usize)> {
    let mut left = most;
    let mut shown = Vec::new();
    for told in replayed.told() {
        let count = told.steps.len().min(left);
        left -= count;
        shown.push((told, count));
        if left == 0 {
            break;
        }
    }
    shown
}

/// The beginning of a sequent, if it is long: up to the end of a formula.
fn beginning(sequent: &str) -> String {
    let long = sequent.chars().count();
    if long <= LONGEST_ON_PAGE {
        return sequent.to_owned();
    }
    let start: String = sequent.chars().take(LONGEST_ON_PAGE).collect();
    // Formulas stand between backquotes.
    let whole = match start.matches('`').count() % 2 {
        0 => start.as_str(),
        _ => start.rsplit_once('`').map_or("", |(before, _)| before),
    };
    format!("{whole} \u{2026} ({long} characters, all of which `explain` and `audit` print)")
}

/// The sequents in words and the steps of each, all together up to so many.
pub(super) fn blocks<'a>(recorded: &Recorded, scope: &'a Scope, most: usize) -> Vec<StoryBlock<'a>> {
    let Some(replayed) = recorded.replayed() else { return Vec::new() };
    let shown = first(replayed, most);
    let more = replayed.steps() - shown.iter().map(|(_, count)| count).sum::<usize>();
    let says = |text: String| StoryBlock::Paragraph(vec![prose(text, scope)]);
    let mut out = Vec::new();
    for (told, count) in shown {
        out.push(says(beginning(&told.sequent)));
        let numbered = told.steps.iter().take(count).enumerate().map(|(at, step)| StoryItem {
            mark: format!("{}.", at + 1),
            line: vec![prose(step, scope)],
            below: Vec::new(),
        });
        out.push(StoryBlock::List(numbered.collect()));
        out.push(says(format!("Replayed: {}.", beginning(&shown_words(&told.shown)))));
    }
    if more > 0 {
        let relations = replayed.relations();
        out.push(says(format!("And {more} steps more, of {relations} relations in all, which are in proofs.json.")));
    }
    out
}
