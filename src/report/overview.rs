//! The first part of `report.md`: which claims stand, why the others do not, and what was left unsaid.
//!
//! **In:** the [`digest`](super::digest) of an account. **Out:** Markdown. Each claim is told in a few lines; a link leads to
//! the section on it.

use super::digest::{self, Fate, Reading, Whole};
use super::markdown::{link_to, prose, table};
use super::numbers::count;
use super::tally::{Standing, name};
use crate::derivation::{ClaimRole, Derivation};
use findings::{Account, ClaimAccount};

/// The section.
pub(super) fn section(derivation: &Derivation, account: &Account) -> String {
    let wholes = digest::wholes(derivation, account);
    let of = |fate: Fate| -> Vec<&Whole<'_>> { wholes.iter().filter(|w| w.fate == fate).collect() };
    let page_one = super::story::markdown(&super::page_one::blocks(derivation, account), &link_to);
    let mut out = format!("## What was found\n\n{page_one}");
    if let Some(remark) = &derivation.remark {
        out.push_str(&format!("> Remark of the file: {}\n\n", prose(remark)));
    }
    out.push_str(&counted(account));
    for fate in Fate::ALL {
        let found = of(fate);
        if found.is_empty() {
            continue;
        }
        out.push_str(&format!("### {} {}\n\n", count(found.len(), "claim"), fate.words(found.len())));
        out.push_str(&format!("{}\n\n", fate.meaning()));
        if fate == Fate::Stands {
            out.push_str(&standing(&found));
        }
        for whole in found.into_iter().filter(|_| fate != Fate::Stands) {
            // What is no claim of the paper is told in its own section.
            out.push_str(&if fate.is_of_the_paper() { reasons(whole) } else { beside(whole) });
        }
        out.push('\n');
    }
    out.push_str(&unsaid(derivation, account));
    out
}

/// The counts of all pairs.
fn counted(account: &Account) -> String {
    let s = account.summary();
    let cell = |n: usize| vec![n.to_string()];
    let all = [s.holds, s.fails, s.not_applicable, s.undecided, s.unexpected].into_iter().flat_map(cell).collect();
    let mut out = format!(
        "Readings counted one by one, these are {} on {}. Of the pairs:\n\n",
        count(account.claims.len(), "claim"),
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

fn mark(standing: Standing) -> &'static str {
    match standing {
        Standing::Holds => "●",
        Standing::Mixed => "◐",
        Standing::Fails => "✕",
        Standing::Open => "?",
        Standing::Nowhere => "–",
    }
}

/// Where a claim stands in the paper, in brackets with a link to it.
fn place(whole: &Whole<'_>) -> String {
    let place = whole.place.map(|p| format!("{}, ", prose(p))).unwrap_or_default();
    format!("({place}{})", link_to(whole.id))
}

/// What stands, by how it is known; what each says is said in its section.
fn standing(found: &[&Whole<'_>]) -> String {
    let mut by_basis: Vec<(String, Vec<String>)> = Vec::new();
    for whole in found {
        let mark = if whole.is_proved() { "◆" } else { "●" };
        let basis = whole.basis().map(|b| format!(" {}", prose(&b.words()))).unwrap_or_default();
        let head = format!("{mark}{basis}");
        match by_basis.iter_mut().find(|(known, _)| *known == head) {
            Some((_, links)) => links.push(link_to(whole.id)),
            None => by_basis.push((head, vec![link_to(whole.id)])),
        }
    }
    by_basis.iter().map(|(head, links)| format!("- {head}: {}\n", links.join(", "))).collect()
}

/// The shape of every reading; what the claim says is said in its section.
fn beside(whole: &Whole<'_>) -> String {
    let marks: String = whole.readings.iter().map(|r| mark(r.standing)).collect();
    format!("- {marks} {}\n", link_to(whole.id))
}

fn reasons(whole: &Whole<'_>) -> String {
    let mut out = format!("- **{}** {}\n", prose(&whole.says), place(whole));
    let mut remark = None;
    // What is there to compare with is told in the section on the claim.
    for reading in whole.readings.iter().filter(|r| r.role != ClaimRole::Added) {
        // A remark on the whole claim is every reading's, and is told once.
        let again = reading.claim.remark.is_some() && reading.claim.remark == remark;
        remark.clone_from(&reading.claim.remark);
        out.push_str(&format!("  - {} {}\n", mark(reading.standing), told(whole, reading, !again)));
    }
    out
}

fn told(whole: &Whole<'_>, reading: &Reading<'_>, with_remark: bool) -> String {
    let mut parts = Vec::new();
    let whose = reading.whose(whole);
    if !whose.is_empty() {
        parts.push(format!("({whose})"));
    }
    if whole.is_read() {
        parts.push(if reading.claim.reading.is_some() {
            prose(&reading.claim.says)
        } else {
            "As it stands.".to_owned()
        });
    }
    let condition = digest::condition_of(reading.claim).map(|c| format!("; {}", prose(&c))).unwrap_or_default();
    parts.push(format!("{}{condition}.", digest::verdict(reading)));
    if let Some(remark) = reading.claim.remark.as_ref().filter(|_| with_remark) {
        parts.push(format!("Remark of the file: *{}*", prose(remark).trim()));
    }
    parts.join(" ")
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
