//! What follows from what, drawn: claims from left to right, each to the right of all that it rests on.
//!
//! **In:** what hangs on each claim, and its fate. **Out:** one SVG drawing with links, and the same in words for those who do not
//! see it. A claim that does not stand is red, and so are the arrows that leave it; conclusions have a thick border.

use std::collections::BTreeMap;

use maud::{Markup, html};

use super::super::consequence::Consequences;
use super::super::digest::{self, Fate, Whole};
use super::text::plain;
use crate::derivation::Derivation;
use findings::Account;

/// Width and height of a box, and what lies between two.
const BOX: (usize, usize) = (136, 20);
const GAP: (usize, usize) = (44, 8);
/// More claims than this are not drawn: nobody could read it.
const MOST: usize = 150;
/// How often boxes are moved towards their neighbours.
const SWEEPS: usize = 8;

/// A claim in its place.
struct Node<'a> {
    whole: &'a Whole<'a>,
    layer: usize,
    row: usize,
}

/// The claims that are drawn: those with an edge; none where they are too many.
fn drawn<'a>(wholes: &'a [Whole<'a>], edges: &[(&str, &str)]) -> Vec<&'a Whole<'a>> {
    let drawn: Vec<&Whole> = wholes.iter().filter(|w| edges.iter().any(|(a, b)| *a == w.id || *b == w.id)).collect();
    if drawn.len() > MOST { Vec::new() } else { drawn }
}

/// Whether there is a drawing.
pub(super) fn is_drawn(derivation: &Derivation, account: &Account) -> bool {
    let hangs = Consequences::new(derivation);
    !drawn(&digest::wholes(derivation, account), &hangs.edges().collect::<Vec<_>>()).is_empty()
}

/// The drawing; nothing where nothing rests on anything.
pub(super) fn section(derivation: &Derivation, account: &Account) -> Markup {
    let wholes = digest::wholes(derivation, account);
    let hangs = Consequences::new(derivation);
    let edges: Vec<(&str, &str)> = hangs.edges().collect();
    let drawn = drawn(&wholes, &edges);
    if drawn.is_empty() {
        return html! {};
    }
    let nodes = placed(&drawn, &edges);
    let of = |id: &str| nodes.iter().find(|n| n.whole.id == id);
    let x = |n: &Node<'_>| n.layer * (BOX.0 + GAP.0) + 2;
    let y = |n: &Node<'_>| n.row * (BOX.1 + GAP.1) + 2;
    let layers = nodes.iter().map(|n| n.layer).max().unwrap_or(0) + 1;
    let rows = nodes.iter().map(|n| n.row).max().unwrap_or(0) + 1;
    let (width, height) = (layers * (BOX.0 + GAP.0) - GAP.0 + 4, rows * (BOX.1 + GAP.1) - GAP.1 + 4);
    let path = |a: &Node<'_>, b: &Node<'_>| {
        let (x0, y0, x1, y1) = (x(a) + BOX.0, y(a) + BOX.1 / 2, x(b), y(b) + BOX.1 / 2);
        let bend = GAP.0.max(x1.saturating_sub(x0) / 2);
        format!("M{x0} {y0}C{} {y0} {} {y1} {x1} {y1}", x0 + bend, x1 as i64 - bend as i64)
    };
    html! {
        section id="/graph" {
            h2 { "What follows from what" }
            p {
                "A line leads from a claim to what rests on it: what is said to follow from it, or what the paper's argument takes \
                 it for. Red does not stand; what a red line reaches has lost a ground. Conclusions of the paper have a thick border."
            }
            div.scroll.wide tabindex="0" role="group" aria-label="Graph of the claims" {
                svg.hangs viewBox={ "0 0 " (width) " " (height) } width=(width) role="group" {
                    title { "What follows from what" }
                    desc { (count(&drawn, &edges)) }
                    @for (from, to) in &edges {
                        @if let (Some(a), Some(b)) = (of(from), of(to)) {
                            path class=@if a.whole.fate.is_against() { "edge f" } @else { "edge" } d=(path(a, b)) {}
                        }
                    }
                    @for n in &nodes {
                        a href={ "#" (n.whole.id) } {
                            title { (hover(account, n.whole)) }
                            rect class={ "node " (class(n.whole)) @if n.whole.conclusion { " concluded" } }
                                x=(x(n)) y=(y(n)) width=(BOX.0) height=(BOX.1) rx="4" {}
                            text x=(x(n) + BOX.0 / 2) y=(y(n) + 14) text-anchor="middle" font-size="11" { (n.whole.id) }
                        }
                    }
                }
            }
        }
    }
}

fn count(drawn: &[&Whole<'_>], edges: &[(&str, &str)]) -> String {
    let against = drawn.iter().filter(|w| w.fate.is_against()).count();
    format!("{} claims, of which {against} do not stand, and {} lines between them.", drawn.len(), edges.len())
}

/// What a box says to those who point at it: the sentence, and its formulas as they are printed.
fn hover(account: &Account, whole: &Whole<'_>) -> String {
    /// Most formulas of a box.
    const FORMULAS: usize = 3;
    let of = account.claims.iter().find(|c| c.id == whole.id);
    let formulas = of.map_or(&[][..], |c| c.formulas.as_slice());
    let mut out = plain(&whole.says);
    for text in formulas.iter().take(FORMULAS) {
        // A matrix has no plain form.
        let formula = Some(plain(text)).filter(|formula| !formula.contains('\\'));
        out.extend(formula.map(|formula| format!("\n{formula}")));
    }
    out
}

fn class(whole: &Whole<'_>) -> &'static str {
    match whole.fate {
        Fate::Fails | Fate::Partly => "f",
        Fate::Reading | Fate::Open | Fate::Untested | Fate::Nowhere => "u",
        Fate::Stands => "h",
        Fate::Choice | Fate::Lemma | Fate::Added => "n",
    }
}

/// Each claim to the right of what it rests on, near its neighbours.
fn placed<'a>(drawn: &[&'a Whole<'a>], edges: &[(&str, &str)]) -> Vec<Node<'a>> {
    let mut layer: BTreeMap<&str, usize> = drawn.iter().map(|w| (w.id, 0)).collect();
    // No path is longer than the number of claims; a circle is left after so many rounds.
    for _ in 0..drawn.len() {
        let mut moved = false;
        for (from, to) in edges {
            let least = layer.get(from).map_or(0, |l| l + 1);
            if let Some(at) = layer.get_mut(to).filter(|at| **at < least && least < drawn.len()) {
                *at = least;
                moved = true;
            }
        }
        if !moved {
            break;
        }
    }
    let mut used: Vec<usize> = layer.values().copied().collect();
    used.sort_unstable();
    used.dedup();
    let at_layer = |id: &str| used.binary_search(layer.get(id).unwrap_or(&0)).unwrap_or(0);
    let mut columns: Vec<Vec<&'a Whole<'a>>> = vec![Vec::new(); used.len()];
    for whole in drawn {
        columns[at_layer(whole.id)].push(whole);
    }
    for sweep in 0..SWEEPS {
        let place: BTreeMap<&str, usize> =
            columns.iter().flat_map(|c| c.iter().enumerate().map(|(row, w)| (w.id, row))).collect();
        for column in &mut columns {
            column.sort_by_key(|w| {
                let near = edges.iter().filter_map(|(a, b)| match sweep % 2 == 0 {
                    true => (*b == w.id).then(|| place.get(a)),
                    false => (*a == w.id).then(|| place.get(b)),
                });
                let rows: Vec<usize> = near.flatten().copied().collect();
                // The mean of the neighbours, in thousandths; without any it stays.
                let sum: usize = rows.iter().sum();
                (1000 * sum).checked_div(rows.len()).unwrap_or(1000 * place.get(w.id).copied().unwrap_or(0))
            });
        }
    }
    let column = |(layer, wholes): (usize, Vec<&'a Whole<'a>>)| {
        wholes.into_iter().enumerate().map(move |(row, whole)| Node { whole, layer, row })
    };
    columns.into_iter().enumerate().flat_map(column).collect()
}
