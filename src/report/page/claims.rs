//! The claims, one by one: what is claimed, for all values, and on every trajectory.

use std::collections::BTreeSet;

use maud::{Markup, html};

use super::super::card;
use super::super::digest::{self, Reading};
use super::super::discrimination::is_weak;
use super::super::drawn;
use super::super::form::{Heading, heading};
use super::super::graph::{DerivationGraph, ProofStanding};
use super::super::letters::{LEGEND, letters};
use super::super::markdown::whose;
use super::super::numbers::{count, size, time};
use super::super::refuting;
use super::super::tally::{Group, Standing, declared, groups, name};
use super::super::wording::slack_sentence;
use super::matrix::{anchors, class};
use super::reasons::{Told, told};
use super::text::{display, formula, identifier, label, prose, reason};
use super::{family, region, support};
use crate::derivation::{ClaimRole, DEFAULT_PRECISION, Derivation};
use crate::latex::Scope;
use findings::{Account, ClaimAccount, IdentityAccount, PairAccount, Witness};

/// What the claims are shown with.
struct Claims<'a> {
    derivation: &'a Derivation,
    account: &'a Account,
    graph: &'a DerivationGraph,
    /// The names of those whose evidence is seen whatever became of them.
    open: BTreeSet<String>,
}

/// The first claims that are not as expected, or fail on motions that were drawn.
fn open(account: &Account) -> BTreeSet<String> {
    let is_open = |claim: &&ClaimAccount| groups(claim).iter().any(|g| g.unexpected) || drawn::table(claim).is_some();
    account.claims.iter().filter(is_open).take(MANY).map(name).collect()
}

/// All claims.
pub(super) fn section(derivation: &Derivation, account: &Account) -> Markup {
    let claims = Claims { derivation, account, graph: &DerivationGraph::new(derivation, account), open: open(account) };
    let mut families: Vec<Vec<&ClaimAccount>> = Vec::new();
    for claim in &account.claims {
        match families.last_mut() {
            Some(family) if family.iter().any(|c| c.id == claim.id) => family.push(claim),
            _ => families.push(vec![claim]),
        }
    }
    html! {
        section.claims id="/claims" {
            h2 { "Claims" }
            @for family in &families {
                @match family.as_slice() {
                    [one] if one.reading.is_none() => { (article(&claims, one)) },
                    several => { (readings(&claims, several)) },
                }
            }
        }
    }
}

/// A claim that can be understood in several ways: the readings side by side, then each by itself.
fn readings(claims: &Claims<'_>, family: &[&ClaimAccount]) -> Markup {
    let &Claims { derivation, account, .. } = claims;
    let Some(first) = family.first() else { return html! {} };
    let parent = declared(derivation, first).and_then(|d| d.parent_says.clone());
    let tally = |claim: &ClaimAccount| {
        let n = |word: &str| claim.verdicts().filter(|j| j.verdict.outcome().word() == word).count();
        let words =
            [("holds", "holds"), ("fails", "fails"), ("not-applicable", "does not apply"), ("undecided", "undecided")];
        let told = words.iter().filter(|(word, _)| n(word) > 0).map(|(word, said)| format!("{said} on {}", n(word)));
        told.collect::<Vec<_>>().join(", ")
    };
    let own = family.iter().any(|c| c.reading.is_none());
    html! {
        div.family {
            @if let Some(parent) = parent.filter(|_| !own) {
                h3 id=(first.id) { (first.id) ": " (prose(&parent, scope_of(derivation, first))) }
            }
            // Among many claims each reading has its verdict beside its name, and that is enough.
            @if account.claims.len() <= MANY { div.scroll tabindex="0" role="group" aria-label={ "Readings of " (first.id) } {
                table.readings {
                    caption { "Readings of " (first.id) ", side by side" }
                    thead {
                        tr {
                            th { "reading" }
                            th { "whose" }
                            th { "verdicts" }
                        }
                    }
                    tbody {
                        @for claim in family {
                            tr {
                                th scope="row" {
                                    a href={ "#" (name(claim)) } { (claim.reading.as_deref().unwrap_or("the claim itself")) }
                                }
                                td { (declared(derivation, claim).map(|d| d.role).unwrap_or_default().word()) }
                                td.number { (tally(claim)) }
                            }
                        }
                    }
                }
            } }
            @for claim in family { (article(claims, claim)) }
        }
    }
}

fn scope_of<'d>(derivation: &'d Derivation, claim: &ClaimAccount) -> &'d Scope {
    declared(derivation, claim).map_or(&derivation.scope, |d| &d.scope)
}

fn article(claims: &Claims<'_>, claim: &ClaimAccount) -> Markup {
    let scope = scope_of(claims.derivation, claim);
    html! {
        article.claim id=(name(claim)) {
            @if claim.reading.is_some() {
                h4 { (name(claim)) ": " (prose(&claim.says, scope)) }
            } @else {
                h3 { (name(claim)) ": " (prose(&claim.says, scope)) }
            }
            (found(claims, claim))
        }
    }
}

/// What a claim says, and where: all but its verdict.
fn stated(derivation: &Derivation, account: &Account, claim: &ClaimAccount) -> Markup {
    let declared = declared(derivation, claim);
    let scope = scope_of(derivation, claim);
    html! {
        p.quiet {
            @if let Some(whose) = declared.and_then(|d| whose(d.role)) { (whose) " " }
            @if let Some(place) = &claim.place { (prose(place, scope)) ". " }
            @if let Some(label) = declared.and_then(|d| d.label.as_ref()) { "Label " code { (label) } ". " }
            @if let Some(from) = declared.map(|d| &d.follows_from).filter(|f| !f.is_empty()) {
                "Said to follow from " (from.join(", ")) ". "
            }
            @if let Some(p) = declared.map(|d| d.precision).filter(|p| *p != DEFAULT_PRECISION) {
                "Precision asked for: " (size(p)) "."
            }
        }
        (formulas(derivation, claim))
        @if !claim.assumptions.is_empty() {
            p {
                "Assuming "
                @for (i, a) in claim.assumptions.iter().enumerate() {
                    @if i > 0 { ", " }
                    (formula(a, scope))
                }
                "."
            }
        }
        @if let Some(at) = declared.and_then(|d| d.at.as_ref()) {
            p { "Tried when " (formula(&at.equation.text, scope)) (at.occasion.words()) "." }
        }
        (support::units_of(account, claim, scope))
    }
}

/// On a page of more claims than this, each is a sentence and its verdict, until it is unfolded.
const MANY: usize = 40;

/// What a claim says, and what was found of it. Of one that stands, and of what is no reading of the paper's, a sentence is read,
/// and the rest is folded: few ask how it is known. Among many claims that of the others is folded, too: what is wrong stands above, with
/// its witness. What is not as expected is not folded, up to so many claims.
fn found(claims: &Claims<'_>, claim: &ClaimAccount) -> Markup {
    let &Claims { derivation, account, graph, .. } = claims;
    let scope = scope_of(derivation, claim);
    let reading = Reading::of(derivation, graph, claim);
    let groups = groups(claim);
    let stated = stated(derivation, account, claim);
    let evidence = html! {
        @if let Some(remark) = &claim.remark {
            p.remark { span.quiet { "Remark of the file: " } (prose(remark, scope)) }
        }
        @if let Some(identity) = &claim.identity { (for_all_values(claim, identity, &reading.proof, scope)) }
        (support::separation(claim, scope))
        (support::erratum(claim, scope))
        (support::behind(graph, claim, scope))
        @for group in &groups { (verdicts(derivation, account, claim, group)) }
        (family::blocks(claim, scope))
        (region::block(claim, scope))
        @if let Some(text) = drawn::plain(derivation, claim) { p { (prose(&text, scope)) } }
        @if let Some(table) = drawn::table(claim) {
            details { summary { "The motion, to be put into the file" } pre.toml tabindex="0" { (table) } }
        }
    };
    let many = account.claims.len() > MANY;
    let beside = claim.reading.is_some() && !reading.role.decides() && reading.role != ClaimRole::Needs;
    let is_told = reading.standing != Standing::Holds && !beside;
    if claims.open.contains(&name(claim)) || is_told && !many {
        return html! { (stated) (evidence) };
    }
    let verdict = digest::verdict(&reading);
    let seen = !many;
    html! {
        @if seen { (stated) }
        details.evidence {
            summary { span class={ "mark " (reading.shape().class()) } aria-hidden="true" {} " " (prose(&verdict, scope)) }
            @if !seen { (stated) }
            (evidence)
        }
    }
}

/// The claims as they are printed. What is folded on a screen is shown; the verdicts of pairs are in the [matrix](printed_matrix),
/// and their numbers in `report.json`.
pub(super) fn printed(derivation: &Derivation, account: &Account) -> Markup {
    let graph = DerivationGraph::new(derivation, account);
    let mut last = "";
    html! {
        section.claims id="/claims" {
            h2 { "Claims" }
            @for claim in &account.claims {
                @let declared = declared(derivation, claim);
                @let scope = scope_of(derivation, claim);
                @let parent = declared.and_then(|d| d.parent_says.as_ref());
                @if let Some(parent) = parent.filter(|_| std::mem::replace(&mut last, &claim.id) != claim.id) {
                    h3 { (claim.id) ": " (prose(parent, scope)) }
                }
                article.claim {
                    h4 { (name(claim)) ": " (prose(&claim.says, scope)) }
                    p.quiet {
                        @if let Some(whose) = declared.and_then(|d| whose(d.role)) { (whose) " " }
                        @if let Some(place) = &claim.place { (prose(place, scope)) "." }
                    }
                    (formulas(derivation, claim))
                    @if !claim.assumptions.is_empty() {
                        p {
                            "Assuming "
                            @for (i, a) in claim.assumptions.iter().enumerate() { @if i > 0 { ", " } (formula(a, scope)) }
                            "."
                        }
                    }
                    @if let Some(identity) = &claim.identity {
                        p { b { "For all values: " } (sentence(identity, &graph.proof_of(claim), scope)) }
                    }
                    p { @for group in groups(claim) { (printed_group(&group)) " " } }
                    @for group in groups(claim).iter().filter(|g| g.word == "fails") {
                        @if let Some(pair) = group.telling() { (witness(derivation, claim, pair, scope)) }
                    }
                    (support::separation(claim, scope))
                    (support::erratum(claim, scope))
                    (support::behind_in_print(&graph, claim, scope))
                    (family::blocks(claim, scope))
                    (region::block(claim, scope))
                    @if let Some(text) = drawn::plain(derivation, claim) { p { (prose(&text, scope)) } }
                }
            }
        }
    }
}

/// Where a claim has one verdict: few motions by name, the others are in the matrix.
fn printed_group(group: &Group<'_>) -> Markup {
    const FEW: usize = 4;
    html! {
        b { (group_word(group.word)) } " on "
        @if group.pairs.len() > FEW && !group.unexpected { (count(group.pairs.len(), "motion")) }
        @else { @for (i, pair) in group.pairs.iter().enumerate() { @if i > 0 { ", " } (pair.trajectory) } }
        @if group.unexpected {
            ", " strong.alarm { @match group.expected { Some(word) => { "expected: " (word) }, None => { "not expected" } } }
        }
        "."
    }
}

/// The matrix of verdicts as it is printed: a letter for each pair.
pub(super) fn printed_matrix(account: &Account) -> Markup {
    html! {
        @if let Some(letters) = letters(account) {
            section id="/matrix" {
                h2 { "Claims and motions" }
                p { (LEGEND) " Columns are the motions by number." }
                pre.letters { (letters) }
            }
        }
    }
}

fn group_word(word: &str) -> &'static str {
    match word {
        "holds" => "Holds",
        "fails" => "Fails",
        "undecided" => "Undecided",
        _ => "Does not apply",
    }
}

/// Whether it is an identity, with its bound.
fn for_all_values(claim: &ClaimAccount, identity: &IdentityAccount, proof: &ProofStanding, scope: &Scope) -> Markup {
    let class =
        if *proof == ProofStanding::Proved || identity.verdict() != "proved" { identity.verdict() } else { "given" };
    html! {
        div class={ "identity " (class) } {
            p {
                b { "For all values: " }
                (sentence(identity, proof, scope))
                (support::certificate(claim, identity, scope))
            }
        }
    }
}

/// The sentence on an identity, its power of two as one.
fn sentence(identity: &IdentityAccount, proof: &ProofStanding, scope: &Scope) -> Markup {
    let text = super::super::graph::sentence(identity, proof);
    match (identity.log2_error, text.split_once("2^")) {
        (Some(_), Some((before, after))) => {
            let end = after.find(|c: char| c != '-' && !c.is_ascii_digit()).unwrap_or(after.len());
            html! { (reason(before, scope)) "2" sup { (after[..end].replace('-', "−")) } (&after[end..]) }
        }
        _ => reason(&text, scope),
    }
}

/// The formulas of a claim, each with what is claimed of it.
fn formulas(derivation: &Derivation, claim: &ClaimAccount) -> Markup {
    let scope = scope_of(derivation, claim);
    let declared = declared(derivation, claim);
    let mut last = None;
    html! {
        @for (i, text) in claim.formulas.iter().enumerate() {
            @match heading(claim, declared, i) {
                (_, Heading::System) => {
                    p { "The motion solves the system " a href={ "#/system/" (text) } { (text) } "." }
                }
                (_, Heading::Trajectory) => {
                    p { "The motion is that of " a href={ "#/trajectory/" (text) } { (text) } "." }
                }
                (kind, Heading::Words(words)) => {
                    @if last.replace(kind) != Some(kind) {
                        p.kind { (prose(&words, scope)) }
                    }
                    (display(text, scope))
                }
            }
        }
    }
}

/// Most trajectories that are named above a table.
const NAMED: usize = 6;

/// The pairs of a claim with the same verdict: in words, with a witness, and all of them in a table.
fn verdicts(derivation: &Derivation, account: &Account, claim: &ClaimAccount, group: &Group<'_>) -> Markup {
    let scope = scope_of(derivation, claim);
    let of = account.trajectories.len();
    let word = group_word(group.word);
    let on = match group.pairs.len() {
        n if n == claim.results.len() && n == of && n > 1 => format!("on all {}", count(n, "motion")),
        n if n == claim.results.len() && n > 1 => format!("on all {} on which it is tried", count(n, "motion")),
        n => format!("on {}", count(n, "motion")),
    };
    let telling = group.telling().filter(|_| group.word == "fails");
    html! {
        details class={ "verdicts " (group.word) } {
            summary {
                span class={ "mark " (group.pairs.first().map(|p| class(p)).unwrap_or_default()) } aria-hidden="true" {}
                " " b { (word) } " " (on)
                @if group.unexpected {
                    ", " strong.alarm {
                        @match group.expected { Some(word) => { "expected: " (word) }, None => { "not expected" } }
                    }
                }
            }
            @if group.pairs.len() < of {
                p.names {
                    @for (i, pair) in group.pairs.iter().take(NAMED).enumerate() { @if i > 0 { ", " } (pair.trajectory) }
                    @if group.pairs.len() > NAMED { " and " (group.pairs.len() - NAMED) " more" }
                    "."
                }
            }
            div.scroll tabindex="0" role="group" aria-label={ (word) " " (on) } { (table(account, claim, group, scope)) }
        }
        @if let Some(pair) = telling { (witness(derivation, claim, pair, scope)) }
    }
}

fn table(account: &Account, claim: &ClaimAccount, group: &Group<'_>, scope: &Scope) -> Markup {
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

/// A refuting point: both sides, and what they depend on.
fn witness(derivation: &Derivation, claim: &ClaimAccount, pair: &PairAccount, scope: &Scope) -> Markup {
    let Some(w) = &pair.verdict.evidence().witness else { return html! {} };
    let kind = card::kind_at(derivation, claim, Some(w));
    let said = refuting::values(claim, kind, w, &|text| text.to_owned());
    html! {
        div.witness {
            p { "On " b { (pair.trajectory) } " at t = " (time(w.t)) ", for " (label(&w.formula, scope)) ": " (said) "." }
            @if !w.values.is_empty() {
                details { summary { "Values there" } pre tabindex="0" { (pasted(w)) } }
            }
        }
    }
}

/// The values of a witness as assignments, which most languages read.
fn pasted(w: &Witness) -> String {
    assigned(w).into_iter().map(|(name, v)| format!("{name} = {v:?}\n")).collect()
}

/// The values of a witness, each with a name that no other has; the time is the first.
pub(super) fn assigned(w: &Witness) -> Vec<(String, f64)> {
    let mut out: Vec<(String, f64)> = vec![("t".to_owned(), w.t)];
    for (name, v) in w.values.iter().filter(|(name, _)| name != "t") {
        let mut word = identifier(name);
        while out.iter().any(|(known, _)| *known == word) {
            word.push('_');
        }
        out.push((word, *v));
    }
    out
}
