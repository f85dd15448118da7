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
mod compression;
mod data;
mod details;
mod graph;
pub(super) mod map;
mod matrix;
mod motions;
pub(super) mod pairs;
mod portrait;
mod reasons;
pub(super) mod region;
mod reuse;
pub(super) mod slopes;
pub(super) mod text;
mod tight;

use maud::{DOCTYPE, Markup, PreEscaped, html};

use super::story::{self, Medium, StoryBlock};
use super::{claim_story, whole};
use ::findings::Account;
use derivation::Derivation;
use text::prose;

const STYLE: &str = include_str!("style.css");
/// The letters of formulas: without them dots sit in the letters where no font for mathematics is installed.
pub(super) const FONT: &str = include_str!("../font/formulas.css");
const SCRIPT: &str = include_str!("script.js");

/// Pages of which what may be folded has more bytes are large.
const MOST_FOLDED: usize = 400_000;

/// The page.
pub fn page(derivation: &Derivation, account: &Account) -> String {
    let shown = |blocks: &[StoryBlock<'_>]| story::html(blocks, Medium::Screen);
    let claims = || shown(&[claim_story::claims(derivation, account)]);
    let (claims, motions) = rayon::join(claims, || motions::section(derivation, account));
    let rest = whole::rest(derivation, account);
    let mut listed = tight::tight(&shown(&whole::listed(derivation, account)).into_string());
    let folding = html! { (claims) (motions) (shown(&rest)) };
    let mut folding = reuse::drawn_once(&tight::tight(&folding.into_string()));
    // A large page keeps what is folded out of the document until it is unfolded.
    let is_large = matrix::has_many_pairs(account) || folding.len() > MOST_FOLDED;
    let mut folds = Vec::new();
    if is_large {
        listed = details::taken_out(&listed, &mut folds);
        folding = details::taken_out(&folding, &mut folds);
    }
    let data = compression::packed(&data::json(derivation, account, &folds));
    let body = html! {
        (header(derivation, Some(account)))
        main id="/main" {
            section id=(whole::FOUND.0) {
                h2 { (whole::FOUND.1) }
                (shown(&whole::front(derivation, account))) (PreEscaped(listed))
            }
            (graph::section(derivation, account)) (matrix::section(account)) (PreEscaped(folding))
        }
    };
    framed(derivation, &body, Some(&data))
}

/// The report as it is printed: what is folded on a screen is shown, what only a screen can show is left out.
pub fn printed_page(derivation: &Derivation, account: &Account) -> String {
    let graph = story::embedded(|| graph::section(derivation, account));
    let body = html! {
        (header(derivation, None))
        main id="/main" { (story::html(&whole::report(derivation, account, Some(graph)), Medium::Paper)) }
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
                // A screen has it where the making is told.
                @if let Some(source) = derivation.source.as_ref().filter(|_| contents_of.is_none()) {
                    " " span.quiet { "Source: " (prose(source, scope)) }
                }
            }
            @if let Some(account) = contents_of { (contents(derivation, account)) }
        }
    }
}

/// The first page alone, to be printed.
pub fn first_page(derivation: &Derivation, account: &Account) -> String {
    let mut front = whole::front(derivation, account);
    // What has no room on a screen has none on a sheet.
    front.truncate(1);
    let body = html! {
        (header(derivation, None))
        main id="/main" { (story::html(&front, Medium::Screen)) }
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
