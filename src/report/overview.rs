//! The first part of `report.md`: which claims stand, why the others do not, and what was left unsaid.
//!
//! **In:** the [`digest`](super::digest) of an account. **Out:** Markdown. Each claim is told in a few lines; a link leads to
//! the section on it.

use super::digest;
use super::markdown::link_to;
use super::markup::{prose, table};
use super::numbers::count;
use super::tally::name;
use crate::derivation::Derivation;
use findings::{Account, ClaimAccount};

/// The section.
pub(super) fn section(derivation: &Derivation, account: &Account) -> String {
    let page_one = super::story::markdown(&super::page_one::blocks(derivation, account), &link_to);
    let mut out = format!("## What was found\n\n{page_one}");
    out.push_str(&counted(account));
    out.push_str(&unsaid(derivation, account));
    out
}

/// The counts of all pairs.
fn counted(account: &Account) -> String {
    let s = account.summary();
    let cell = |n: usize| vec![n.to_string()];
    let all = [s.holds, s.fails, s.not_applicable, s.undecided, s.unexpected].into_iter().flat_map(cell).collect();
    let mut out = format!(
        "Reading by reading, what is added for comparison among them, there are {} on {}. Of the pairs of a reading and a motion:\n\n",
        account.claims.len(),
        count(account.trajectories.len(), "motion"),
    );
    out.push_str(&table(&["hold", "fail", "do not apply", "undecided", "not as expected"], [all]));
    out.push_str(&match s.unexpected {
        0 => "Every verdict is as the derivation file expects.\n\n".to_owned(),
        1 => "**One verdict is not as the derivation file expects.**\n\n".to_owned(),
        n => format!("**{n} verdicts are not as the derivation file expects.**\n\n"),
    });
    out
}

fn unsaid(derivation: &Derivation, account: &Account) -> String {
    let found = digest::unsaid(derivation, account);
    if found.is_empty() {
        return String::new();
    }
    let mut out = String::from(
        "### What was left unsaid\n\nWhat separates the motions on which a claim or reading holds from those on which it \
         fails, as far as these motions can tell.\n\n",
    );
    for u in &found {
        let claims: Vec<String> = u.claims.iter().map(|c: &&ClaimAccount| link_to(&name(c))).collect();
        out.push_str(&format!("- **{}**: {}\n", prose(&digest::explanation(u.explanation)), claims.join(", ")));
    }
    out.push('\n');
    out
}
