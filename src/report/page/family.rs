//! A claim on families of motions: counts, and the members that a reader wants to see, each as a trajectory to paste.

use maud::{Markup, html};

use super::super::family;
use super::super::tally::name;
use super::map;
use super::text::prose;
use crate::latex::Scope;
use findings::ClaimAccount;

/// The blocks of a claim, one for each family.
pub(super) fn blocks(claim: &ClaimAccount, scope: &Scope) -> Markup {
    html! {
        @for of in &claim.families {
            div class={ "region " (of.verdict.outcome().word()) } {
                p {
                    b { (family::heading(of)) " " (of.family) }
                    @if of.title != of.family { " (" (prose(&of.title, scope)) ")" }
                    @if of.is_unexpected() { strong.alarm { (family::expected(of)) } }
                    ". " (prose(&family::sentence(&family::counts(of)), scope))
                }
                @for text in family::remarks(of) { p.quiet { (prose(&family::sentence(&text), scope)) } }
                @if let Some(map) = &of.map { (map::figure(map, &name(claim), scope)) }
                @for shown in family::shown(of) {
                    details {
                        summary { (prose(&shown.named(), scope)) }
                        @if let Some(text) = &shown.seen { p { (prose(&family::sentence(text), scope)) } }
                        p.quiet { "The same motion for the derivation file:" }
                        pre tabindex="0" { (shown.member.toml) }
                    }
                }
            }
        }
    }
}
