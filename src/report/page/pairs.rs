//! The motions of one verdict as a table of the page: a row for each, which the script knows, with a reason that many share above them.

use maud::{Markup, html};

use super::super::discrimination::is_weak;
use super::super::numbers::{size, time};
use super::super::tally::{Group, groups, in_order};
use super::super::wording::slack_sentence;
use super::matrix::anchors;
use super::reasons::{Told, told};
use super::text::reason;
use findings::{Account, ClaimAccount, PairAccount};
use latex::Scope;

/// Most motions that are named above a table.
const NAMED: usize = 6;

/// The table of the group at this position, and the motions by name, where they are not all.
pub(in super::super) fn table(account: &Account, claim: &ClaimAccount, at: usize, scope: &Scope) -> Markup {
    let mut all = groups(claim);
    in_order(&mut all);
    let Some(group) = all.get(at) else { return Markup::default() };
    html! {
        @if group.pairs.len() < account.trajectories.len() {
            p.names {
                @for (i, pair) in group.pairs.iter().take(NAMED).enumerate() { @if i > 0 { ", " } (pair.trajectory) }
                @if group.pairs.len() > NAMED { " and " (group.pairs.len() - NAMED) " more" }
                "."
            }
        }
        div.scroll tabindex="0" role="group" aria-label="Motions, one by one" { (rows(account, claim, group, scope)) }
    }
}

fn rows(account: &Account, claim: &ClaimAccount, group: &Group<'_>, scope: &Scope) -> Markup {
    let compared = group.pairs.iter().any(|p| p.verdict.evidence().residual.is_some());
    // A reason that many pairs share is given once, above them.
    let mut parts: Vec<(String, Vec<(&PairAccount, Told)>)> = Vec::new();
    for &pair in &group.pairs {
        let told = pair.verdict.evidence().reason.as_ref().map(told).unwrap_or_default();
        let sentence = told.sentence();
        match parts.iter_mut().find(|(s, _)| *s == sentence) {
            Some((_, pairs)) => pairs.push((pair, told)),
            None => parts.push((sentence, vec![(pair, told)])),
        }
    }
    let any = |some: &dyn Fn(&Told) -> bool| parts.iter().any(|(_, pairs)| pairs.iter().any(|(_, t)| some(t)));
    let tried = group.pairs.iter().any(|p| rejects(p).is_some());
    let (cut, apart) = (any(&|t| t.stretches.is_some()), any(&|t| t.apart.is_some()));
    // Where most reasons are of one motion each, they stand beside it.
    let single = parts.iter().filter(|(_, pairs)| pairs.len() == 1).count() > 4;
    let anchor = anchors(account, claim);
    let columns = 2 + 5 * usize::from(compared) + usize::from(tried) + usize::from(cut) + 2 * usize::from(apart);
    html! {
        table {
            thead {
                tr {
                    th { "motion" }
                    @if compared {
                        @for head in ["strength", "worst residual", "its bound", "at t", "samples"] {
                            th { (head) }
                        }
                    }
                    @if tried { th { "altered rejected" } }
                    @if cut { th { "stretches" } }
                    @if apart { th { "off by at most" } th { "terms" } }
                    th { "notes" }
                }
            }
            @for (sentence, pairs) in &parts {
                @let shared = !(sentence.is_empty() || single && pairs.len() == 1);
                tbody {
                    @if shared {
                        tr { th.shared colspan=(columns) scope="rowgroup" { (reason(sentence, scope)) "." } }
                    }
                    @for (pair, told) in pairs {
                        @let evidence = pair.verdict.evidence();
                        tr id=(anchor(pair)) {
                            th { (pair.trajectory) }
                            @if compared {
                                td { (pair.verdict.outcome().strength().unwrap_or_default()) }
                                @match &evidence.residual {
                                    Some(r) => { td { (size(r.max)) } td { (size(r.bound)) } td { (time(r.at)) } },
                                    None => { td {} td {} td {} },
                                }
                                td { @if evidence.samples > 0 { (evidence.samples) } }
                            }
                            @if tried {
                                @let weak = is_weak(pair);
                                td { @if let Some(text) = rejects(pair) { (text) @if weak { ", weak" } } }
                            }
                            @if cut { td { @if let Some(stretches) = told.stretches { (stretches) } } }
                            @if apart {
                                @match &told.apart {
                                    Some((width, terms)) => { td { (width) } td { (terms) } },
                                    None => { td {} td {} },
                                }
                            }
                            td { (notes(pair, shared.then_some(told.own.as_str()), scope)) }
                        }
                    }
                }
            }
        }
    }
}
/// How many altered formulas a pair rejects.
fn rejects(pair: &PairAccount) -> Option<String> {
    let d = pair.discrimination.as_ref().filter(|d| d.of > 0)?;
    Some(format!("{} of {}", d.rejected, d.of))
}

/// Reason, sign, and times left out. Of a reason that others share, `own` is what it says of this motion alone.
fn notes(pair: &PairAccount, own: Option<&str>, scope: &Scope) -> Markup {
    let evidence = pair.verdict.evidence();
    let words =
        own.map_or_else(|| evidence.reason.as_ref().map(ToString::to_string).unwrap_or_default(), str::to_owned);
    html! {
        @if !words.is_empty() { (reason(&words, scope)) ". " }
        @if let Some(slack) = slack_sentence(pair) { (slack) ". " }
        @if let Some(branch) = &evidence.branch { "Sign: " (branch.to_string()) ". " }
        @for (i, e) in evidence.excluded.iter().enumerate() {
            @if i == 0 { "Left out: " } @else { "; " }
            @if e.from == e.to { "t = " (time(e.from)) } @else { "t from " (time(e.from)) " to " (time(e.to)) }
            " (" (reason(&e.reason.to_string(), scope)) ")"
        }
    }
}
