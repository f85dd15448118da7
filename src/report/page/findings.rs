//! What a reader wants first: which claims stand, and why the others do not.

use maud::{Markup, html};

use super::super::digest::{self, Fate, Whole};
use super::super::headline::{self, CountedFate};
use super::super::numbers::count;
use super::super::page_one;
use super::super::shape::VerdictShape;
use super::super::story;
use super::super::tally::name;
use super::text::prose;
use crate::derivation::Derivation;
use crate::latex::Scope;
use findings::{Account, ClaimAccount};

/// Most claims that are named of those that are not as expected.
const MOST_UNEXPECTED: usize = 8;

/// Page one, and below it what is [listed].
pub(super) fn section<M: maud::Render>(derivation: &Derivation, account: &Account, listed: &M) -> Markup {
    html! {
        section id="/findings" {
            h2 { "What was found" }
            (front(derivation, account))
            (listed)
        }
    }
}

/// The counts, and every claim with its fate.
pub(super) fn listed(derivation: &Derivation, account: &Account) -> Markup {
    let wholes = digest::wholes(derivation, account);
    let of = |fate: Fate| -> Vec<&Whole<'_>> { wholes.iter().filter(|w| w.fate == fate).collect() };
    html! {
            ul.counts aria-label="What became of the claims" {
                @for counted in CountedFate::told() {
                    @let n = wholes.iter().filter(|w| w.counted_as() == counted).count();
                    @let key = counted.fate().key();
                    @if n > 0 {
                        li class=(key) { a href={ "#/found/" (key) } { b { (n) } " " (counted.words(n)) } }
                    }
                }
            }
            (counted(account))
            (in_order(&wholes, &derivation.scope))
            @for fate in Fate::ALL {
                @let found = of(fate);
                @if !found.is_empty() {
                    h3 id={ "/found/" (fate.key()) } { (headline::heading(fate, &found)) }
                    p.quiet { (fate.meaning()) }
                    details {
                        summary { "All of them" }
                        @if fate == Fate::Stands { (standing(&found, &derivation.scope)) } @else { (reasons(derivation, &found)) }
                    }
                }
            }
            (unsaid(derivation, account))
    }
}

/// Page one: it is printed by itself.
pub(super) fn front(derivation: &Derivation, account: &Account) -> Markup {
    html! { div.front id="/front" { (story::html(&page_one::blocks(derivation, account))) } }
}

/// The counts of all pairs, in sentences; what is not as expected is named.
fn counted(account: &Account) -> Markup {
    let unexpected = headline::unexpected(account);
    html! {
        p.quiet {
            (headline::tried(account)) " "
            @match unexpected.as_slice() {
                [] => { "Every verdict is as the derivation file expects." },
                some => {
                    strong.alarm { "Not as the derivation file expects: " }
                    @for (at, claim) in some.iter().take(MOST_UNEXPECTED).enumerate() { @if at > 0 { ", " } (link(claim)) }
                    @if some.len() > MOST_UNEXPECTED { ", and " (count(some.len() - MOST_UNEXPECTED, "more claim")) }
                    "."
                },
            }
        }
    }
}

/// Every claim of the paper in its order, with the shape of its fate: a map of the paper, at one glance.
fn in_order(wholes: &[Whole<'_>], scope: &Scope) -> Markup {
    let told: Vec<&Whole<'_>> = wholes.iter().filter(|w| w.fate.is_of_the_paper()).collect();
    html! {
        h3 id="/order" { "The claims in their order" }
        details { summary { "All of them" }
        ul.legend aria-label="Shapes" {
            @for shape in VerdictShape::ALL.into_iter().filter(|s| told.iter().any(|w| w.shape() == *s)) {
                li { span class={ "mark " (shape.class()) } aria-hidden="true" {} " " (shape.says()) }
            }
        }
        ol.order {
            @for whole in told {
                @let stands = whole.fate == Fate::Stands;
                li {
                    span class={ "mark " (whole.shape().class()) } aria-hidden="true" {}
                    @let target = if stands { format!("#{}", whole.id) } else { format!("#/why/{}", whole.id) };
                    a href=(target) { (prose(&whole.says, scope)) }
                    span.unseen { ", " (whole.fate.words(1)) }
                }
            }
        } }
    }
}

fn link(claim: &ClaimAccount) -> Markup {
    let full = name(claim);
    html! { a href={ "#" (full) } { (full) } }
}

/// Claims that stand: a line for each.
fn standing(found: &[&Whole<'_>], scope: &Scope) -> Markup {
    let proved = found.iter().filter(|w| w.is_proved()).count();
    html! {
        @if proved > 0 {
            p.quiet { "Proved for all values, given nothing that is not proved: " (proved) " (" span class="mark h p" aria-hidden="true" {} ")." }
        }
        ul.stands {
            @for whole in found {
                li {
                    span class={ "mark " (whole.shape().class()) } aria-hidden="true" {} " "
                    a href={ "#" (whole.id) } { (whole.id) } " " (prose(&whole.says, scope))
                    @if let Some(place) = whole.place { span.quiet { " (" (prose(place, scope)) ")" } }
                    @if let Some(basis) = whole.basis() { span.outcome { ": " (prose(&basis.words(), scope)) "." } }
                }
            }
        }
    }
}

/// Claims that do not stand, or not in every reading: each with what holds, where, and why the rest does not.
fn reasons(derivation: &Derivation, found: &[&Whole<'_>]) -> Markup {
    let scope = &derivation.scope;
    html! {
        @for whole in found {
            div.whole id={ "/why/" (whole.id) } {
                p {
                    b { (prose(&whole.says, scope)) } " "
                    span.quiet {
                        @if let Some(place) = whole.place { (prose(place, scope)) "; " }
                        a href={ "#" (whole.id) } { (whole.id) }
                    }
                }
                ul {
                    @for reading in &whole.readings {
                        li {
                            span class={ "mark " (reading.shape().class()) } aria-hidden="true" {} " "
                            @let whose = reading.whose(whole);
                            @if !whose.is_empty() { span.added { (whose) } " " }
                            @if whole.is_read() {
                                @if reading.claim.reading.is_some() { (prose(&reading.claim.says, scope)) }
                                @else { "As it stands:" }
                                " "
                            }
                            span.outcome {
                                (digest::verdict(reading))
                                @if let Some(c) = digest::condition_of(reading.claim) { "; " (prose(&c, scope)) }
                                "."
                            }
                            @if let Some(remark) = &reading.claim.remark {
                                " " span.quiet { "Remark of the file: " } span.why { (prose(remark, scope)) }
                            }
                        }
                    }
                }
            }
        }
    }
}

/// The conditions that claims do not name and need.
fn unsaid(derivation: &Derivation, account: &Account) -> Markup {
    let unsaid = digest::unsaid(derivation, account);
    html! {
        @if !unsaid.is_empty() {
            h3 id="/found/unsaid" { "What was left unsaid" }
            p.quiet {
                "What separates the motions on which a claim or reading holds from those on which it fails, as far as these motions "
                "can tell. Claims under one condition stand or fall together."
            }
            ul.unsaid {
                @for u in &unsaid {
                    li {
                        b { (prose(&digest::explanation(u.explanation), &derivation.scope)) } ": "
                        @for (i, claim) in u.claims.iter().enumerate() { @if i > 0 { ", " } (link(claim)) }
                    }
                }
            }
        }
    }
}
