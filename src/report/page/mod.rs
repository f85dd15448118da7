//! `index.html`: the report as one page that needs nothing beside itself.
//!
//! **In:** a derivation and its account. **Out:** HTML with its style, a small script, and all data inside.
//!
//! **Guaranteed:** nothing is fetched from anywhere; everything essential is there without the script: the summary, the
//! matrix, every verdict in a sentence, formulas (MathML), pictures (SVG). On a page of many claims the script unfolds the evidence of those
//! that stand, which is packed, and makes the cells of the matrix from its runs; everywhere it adds filters, keys in the matrix, and the
//! curves of a pair on demand: five thousand drawings would not fit. Every text of the file is escaped.
//!
//! Places of the page itself begin with a slash (`#/matrix`), which no claim can: the others are names of claims.
//!
//! **Why a template in code:** `maud` escapes what it is given, and is checked by the compiler; there is no template
//! language to learn, and no file to find at run time.

mod board;
mod claims;
mod compression;
mod data;
mod details;
mod family;
mod findings;
mod graph;
mod map;
mod matrix;
mod motions;
mod portrait;
mod reasons;
mod region;
mod reuse;
mod support;
pub(super) mod text;
mod tight;

use maud::{DOCTYPE, Markup, PreEscaped, html};

use super::numbers::{size, time};
use crate::derivation::Derivation;
use ::findings::Account;
use text::{formula, prose, unit};

const STYLE: &str = include_str!("style.css");
/// The letters of formulas: without them dots sit in the letters where no font for mathematics is installed.
pub(super) const FONT: &str = include_str!("../font/formulas.css");
const SCRIPT: &str = include_str!("script.js");

/// Pages with more pairs are large.
const MOST_PAIRS: usize = 1_000;
/// So are pages of which what may be folded has more bytes.
const MOST_FOLDED: usize = 400_000;

/// Whether there are more than [`MOST_PAIRS`] verdicts of claims on motions.
fn has_many_pairs(account: &Account) -> bool {
    account.claims.iter().map(|c| c.results.len()).sum::<usize>() > MOST_PAIRS
}

/// The page.
pub fn page(derivation: &Derivation, account: &Account) -> String {
    let large = || rayon::join(|| claims::section(derivation, account), || motions::section(derivation, account));
    let (listed, (claims, motions)) = rayon::join(|| findings::listed(derivation, account), large);
    let folding = html! { (claims) (motions) (measures(derivation, account)) };
    let mut folding = reuse::drawn_once(&tight::tight(&folding.into_string()));
    let mut listed = tight::tight(&listed.into_string());
    let mut units = tight::tight(&support::units(account, &derivation.scope).into_string());
    // A large page keeps what is folded out of the document until it is unfolded.
    let is_large = has_many_pairs(account) || folding.len() > MOST_FOLDED;
    let mut folds = Vec::new();
    if is_large {
        listed = details::taken_out(&listed, &mut folds);
        folding = details::taken_out(&folding, &mut folds);
        units = details::taken_out(&units, &mut folds);
    }
    let findings = findings::section(derivation, account, &PreEscaped(listed));
    let data = compression::packed(&data::json(derivation, account, &folds));
    let rest = html! {
        (PreEscaped(folding))
        (conventions(derivation))
        (symbols(derivation))
        (systems(derivation))
        (PreEscaped(units))
        (making(derivation))
    };
    let body = html! {
        (header(derivation, Some(account)))
        main id="/main" { (findings) (graph::section(derivation, account)) (matrix::section(account)) (rest) }
    };
    framed(derivation, &body, Some(&data))
}

/// The report as it is printed: what is folded on a screen is shown, what only a screen can show is left out.
pub fn printed_page(derivation: &Derivation, account: &Account) -> String {
    let body = html! {
        (header(derivation, None))
        main id="/main" {
            (findings::section(derivation, account, &findings::listed(derivation, account)))
            (graph::section(derivation, account))
            (claims::printed_matrix(account))
            (motions::listed(derivation, account))
            (claims::printed(derivation, account))
            (conventions(derivation))
            (symbols(derivation))
            (systems(derivation))
            (support::units(account, &derivation.scope))
            (making(derivation))
        }
    };
    framed(derivation, &body, None).replace("<details", "<details open")
}

fn header(derivation: &Derivation, contents_of: Option<&Account>) -> Markup {
    let scope = &derivation.scope;
    html! {
        header {
            @if contents_of.is_some() { a.skip href="#/main" { "Skip to the report" } }
            p.kind { "A check of a derivation" }
            h1 { (prose(&derivation.title, scope)) }
            p {
                (prose(&derivation.concerns, scope))
                @if let Some(source) = &derivation.source { " " span.quiet { "Source: " (prose(source, scope)) } }
            }
            @if let Some(account) = contents_of { (contents(derivation, account)) }
        }
    }
}

/// The first page alone, to be printed.
pub fn first_page(derivation: &Derivation, account: &Account) -> String {
    let body = html! {
        (header(derivation, None))
        main id="/main" { (findings::front(derivation, account)) }
    };
    framed(derivation, &body, None)
}

fn framed(derivation: &Derivation, body: &Markup, data: Option<&str>) -> String {
    let body = PreEscaped(tight::tight(&body.0));
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                // Whatever a file says, the page loads nothing and sends nothing.
                meta http-equiv="Content-Security-Policy"
                    content="default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:; font-src data:";
                title { (derivation.title) }
                style { (PreEscaped(FONT)) (PreEscaped(STYLE)) }
            }
            body {
                (body)
                @if let Some(data) = data {
                    script type="text/plain" id="/data" { (PreEscaped(data)) }
                    script { (PreEscaped(SCRIPT)) }
                }
            }
        }
    };
    page.into_string() + "\n"
}

fn contents(derivation: &Derivation, account: &Account) -> Markup {
    html! {
        nav aria-label="Contents" {
            ul {
                li { a href="#/findings" { "What was found" } }
                @if graph::is_drawn(derivation, account) { li { a href="#/graph" { "What follows from what" } } }
                @if matrix::has_pairs(account) { li { a href="#/matrix" { "Claims and motions" } } }
                li { a href="#/claims" { "Claims" } }
                @if !account.trajectories.is_empty() { li { a href="#/trajectories" { "Motions" } } }
                @if !derivation.conventions.is_empty() { li { a href="#/conventions" { "Conventions" } } }
                li { a href="#/symbols" { "Symbols" } }
                @if !derivation.systems.is_empty() { li { a href="#/systems" { "Systems" } } }
                @if !account.units.formulas.is_empty() { li { a href="#/units" { "Units" } } }
                @if !account.measurements.is_empty() || !account.distributions.is_empty() { li { a href="#/measures" { "Measured" } } }
                li { a href="#/making" { "How it was made" } }
            }
        }
    }
}

fn conventions(derivation: &Derivation) -> Markup {
    if derivation.conventions.is_empty() {
        return html! {};
    }
    html! {
        section id="/conventions" {
            h2 { "Conventions" }
            dl {
                @for (key, text) in &derivation.conventions {
                    dt { (key.replace('-', " ")) }
                    dd { (prose(text, &derivation.scope)) }
                }
            }
        }
    }
}

fn symbols(derivation: &Derivation) -> Markup {
    let scope = &derivation.scope;
    html! {
        section id="/symbols" {
            h2 { "Symbols" }
            div.scroll tabindex="0" role="group" aria-label="Table of symbols" {
                table {
                    thead { tr { @for head in ["symbol", "role", "shape", "unit", "definition", "notes"] { th scope="col" { (head) } } } }
                    tbody {
                        @for s in &derivation.symbols {
                            tr {
                                td { (formula(&s.name, scope)) }
                                td { (s.role_word()) }
                                td {
                                    @if derivation.graph.is_diagonal(s.symbol) { "diagonal " }
                                    (derivation.graph.shape(s.symbol))
                                }
                                td { (s.unit.as_deref().map(unit).unwrap_or_default()) }
                                td { @if let Some(f) = &s.formula { (formula(f, scope)) } }
                                td {
                                    @if let Some(says) = &s.says { (prose(says, scope)) }
                                    @if let Some(scale) = &s.scale { " (scale factor " (formula(scale, scope)) ")" }
                                    @if s.positive { " (positive)" }
                                    @if s.angle { " (angle, continued without jumps)" }
                                }
                            }
                        }
                    }
                }
            }
        }
    }
}

fn systems(derivation: &Derivation) -> Markup {
    if derivation.systems.is_empty() {
        return html! {};
    }
    html! {
        section id="/systems" {
            h2 { "Systems" }
            @for system in &derivation.systems {
                h3 id={ "/system/" (system.id) } { (system.id) }
                @if let Some(says) = &system.says { p { (prose(says, &derivation.scope)) } }
                @for equation in &system.equations { (text::display(&equation.text, &derivation.scope)) }
            }
        }
    }
}

/// The most values of a measurement that are shown.
const VALUES_SHOWN: usize = 12;

fn measures(derivation: &Derivation, account: &Account) -> Markup {
    if account.measurements.is_empty() && account.distributions.is_empty() {
        return html! {};
    }
    html! {
        section id="/measures" {
            h2 { "Measured" }
            @for measure in &derivation.measures {
                h3 { (measure.id) }
                p {
                    (prose(&measure.says, &derivation.scope)) ": " (formula(&measure.formula.text, &derivation.scope))
                    @match (&measure.at, &measure.since) {
                        (Some(_), Some(_)) => { ": " (prose(&super::family::taken(measure), &derivation.scope)) }
                        (Some(at), None) => { ", taken when " (formula(&at.equation.text, &derivation.scope)) (at.occasion.words()) }
                        (None, _) => {}
                    }
                }
                @for of in account.distributions.iter().filter(|of| of.measure == measure.id) {
                    p { "On the family " (of.family) ": " (prose(&super::family::distribution(of), &derivation.scope)) "." }
                }
                details {
                    summary { "Values" }
                    div.scroll tabindex="0" role="group" aria-label={ "Values of " (measure.id) } {
                        table {
                            thead { tr { th scope="col" { "motion" } th scope="col" { "value ± error bound (time)" } } }
                            tbody {
                                @for m in account.measurements.iter().filter(|m| m.measure == measure.id) {
                                    tr {
                                        th scope="row" { a href={ "#/trajectory/" (m.trajectory) } { (m.trajectory) } }
                                        td {
                                            @for (i, (t, v, b)) in m.values.iter().take(VALUES_SHOWN).enumerate() {
                                                @if i > 0 { "; " }
                                                (time(*v)) " ± " (size(*b)) " (t = " (time(*t)) ")"
                                            }
                                            @if m.values.len() > VALUES_SHOWN {
                                                "; " (m.values.len() - VALUES_SHOWN) " more in report.json"
                                            }
                                            @if let Some(r) = &m.reason { " " (text::reason(&r.to_string(), &derivation.scope)) }
                                        }
                                    }
                                }
                            }
                        }
                    }
                }
            }
        }
    }
}

fn making(derivation: &Derivation) -> Markup {
    let path = super::project_path(&derivation.file.path);
    html! {
        section id="/making" {
            h2 { "How it was made" }
            dl {
                dt { "program" }
                dd { (crate::PROGRAM) " " (env!("CARGO_PKG_VERSION")) }
                dt { "derivation file" }
                dd { (path) }
                dt { "SHA-256 of the file" }
                dd.hash { (derivation.sha256) }
                dt { "to repeat it" }
                dd { code { (crate::PROGRAM) " check " (path) } }
                dt { "precision asked for" }
                dd { (size(derivation::DEFAULT_PRECISION)) " of the size of the terms, where a claim does not say otherwise" }
                dt { "seeds" }
                dd { "Random points of proofs are drawn from seeds that are fixed by the program and the file: the same input gives the same page, byte by byte." }
            }
            p {
                "The page states no time and no machine, since neither changes a verdict. A verdict is "
                em { "sampled" } " (compared at finitely many times, each residual against its own error bound), "
                em { "enclosed" } " (rigorously, for every time) or " em { "proved" } " (an identity, for all values)."
            }
        }
    }
}
