//! What follows from what, drawn: each claim below all that it rests on, in rows that fit a screen.
//!
//! **In:** what hangs on each claim, its fate, and the systems from whose equations first steps are made. **Out:** two SVG drawings with
//! links, one for a wide screen and one for a narrow one, and the same in words for those who do not see it. A claim that does not stand
//! is red, and so are the lines that leave it; conclusions have a thick border; systems have round ends.

use std::collections::BTreeMap;

use maud::{Markup, html};

use super::super::consequence::Consequences;
use super::super::digest::{self, Fate, Whole};
use super::super::graph::{DerivationGraph, Kind};
use super::super::tally::name;
use super::text::plain;
use derivation::Derivation;
use findings::Account;

/// Width and height of a box, and what lies between two of a row and between two rows of a layer.
const BOX: (usize, usize) = (136, 20);
const GAP: (usize, usize) = (10, 8);
/// What lies between two layers: lines need room to turn.
const BETWEEN: usize = 30;
/// Boxes in a row: of a screen of 1280 px, and of one of 390 px.
const ROWS: [(&str, usize); 2] = [("hangs roomy", 8), ("hangs narrow", 2)];
/// Longest name of a box, in letters.
const LETTERS: usize = 21;
/// More claims than this are not drawn: nobody could read it.
const MOST: usize = 150;
/// How often boxes are moved towards their neighbours.
const SWEEPS: usize = 8;

/// What a box stands for.
#[derive(Clone, Copy)]
enum Boxed<'a> {
    Claim(&'a Whole<'a>),
    System(&'a str),
}

impl<'a> Boxed<'a> {
    /// A key that no other box has: a system may have the name of a claim.
    fn key(&self) -> String {
        match self {
            Boxed::Claim(whole) => whole.id.to_owned(),
            Boxed::System(id) => system_key(id),
        }
    }

    fn label(&self) -> &'a str {
        match self {
            Boxed::Claim(whole) => whole.id,
            Boxed::System(id) => id,
        }
    }

    fn is_against(&self) -> bool {
        matches!(self, Boxed::Claim(whole) if whole.fate.is_against())
    }
}

fn system_key(id: &str) -> String {
    format!("/system/{id}")
}

/// What is drawn: boxes, and lines from key to key.
struct Drawn<'a> {
    boxes: Vec<Boxed<'a>>,
    edges: Vec<(String, String)>,
}

/// The claims with a line, and the systems from whose equations the first of them follow; nothing where they are too many.
fn drawn<'a>(derivation: &'a Derivation, account: &Account, wholes: &'a [Whole<'a>]) -> Drawn<'a> {
    let hangs = Consequences::new(derivation);
    let mut edges: Vec<(String, String)> = hangs.edges().map(|(a, b)| (a.to_owned(), b.to_owned())).collect();
    let has_line = |w: &&Whole<'_>| edges.iter().any(|(a, b)| a == w.id || b == w.id);
    let claims: Vec<&'a Whole<'a>> = wholes.iter().filter(has_line).collect();
    if claims.is_empty() || claims.len() > MOST {
        return Drawn { boxes: Vec::new(), edges: Vec::new() };
    }
    // What rests on another claim has its ground; the others are steps from the equations of a system.
    let graph = DerivationGraph::new(derivation, account);
    let mut systems: Vec<&'a str> = Vec::new();
    let mut from_systems = Vec::new();
    for whole in claims.iter().filter(|w| edges.iter().all(|(_, to)| to != w.id)) {
        for id in systems_of(&graph, whole) {
            let Some(system) = derivation.systems.iter().find(|s| s.id == id) else { continue };
            if !systems.contains(&system.id.as_str()) {
                systems.push(&system.id);
            }
            from_systems.push((system_key(&id), whole.id.to_owned()));
        }
    }
    edges.extend(from_systems);
    let boxes = systems.into_iter().map(Boxed::System).chain(claims.into_iter().map(Boxed::Claim)).collect();
    Drawn { boxes, edges }
}

/// The systems from whose equations some reading of a claim is a step.
fn systems_of(graph: &DerivationGraph, whole: &Whole<'_>) -> Vec<String> {
    let mut out: Vec<String> = Vec::new();
    for reading in &whole.readings {
        let id = name(reading.claim);
        let at = graph.nodes.iter().position(|n| n.kind == Kind::Claim && n.id == id);
        for system in at.map(|at| graph.direct(at, Kind::System)).unwrap_or_default() {
            if !out.contains(&system) {
                out.push(system);
            }
        }
    }
    out
}

/// Whether there is a drawing.
pub(super) fn is_drawn(derivation: &Derivation, account: &Account) -> bool {
    !drawn(derivation, account, &digest::wholes(derivation, account)).boxes.is_empty()
}

/// The drawings; nothing where nothing rests on anything.
pub(super) fn section(derivation: &Derivation, account: &Account) -> Markup {
    let wholes = digest::wholes(derivation, account);
    let drawn = drawn(derivation, account, &wholes);
    if drawn.boxes.is_empty() {
        return html! {};
    }
    let layers = layers(&drawn);
    html! {
        section id="/graph" {
            h2 { "What follows from what" }
            p {
                "A line leads down from a claim to what rests on it: what is said to follow from it, or what the paper's argument takes \
                 it for. Red does not stand; what a red line reaches has lost a ground. Conclusions of the paper have a thick border; \
                 a box with round ends is a system, from whose equations steps follow."
            }
            @for (class, columns) in ROWS { (drawing(account, &drawn, &layers, class, columns)) }
        }
    }
}

/// One drawing, of rows of so many boxes.
fn drawing(account: &Account, drawn: &Drawn<'_>, layers: &[Vec<Boxed<'_>>], class: &str, columns: usize) -> Markup {
    let width = columns * (BOX.0 + GAP.0) - GAP.0 + 4;
    let (places, height) = placed(layers, columns);
    let path = |(x0, y0): (usize, usize), (x1, y1): (usize, usize)| {
        let (x0, y0, x1) = (x0 + BOX.0 / 2, y0 + BOX.1, x1 + BOX.0 / 2);
        let bend = BETWEEN.max(y1.saturating_sub(y0) / 2);
        format!("M{x0} {y0}C{x0} {} {x1} {} {x1} {y1}", y0 + bend, y1 as i64 - bend as i64)
    };
    html! {
        svg class=(class) viewBox={ "0 0 " (width) " " (height) } width=(width) role="group" aria-label="Graph of the claims" {
            title { "What follows from what" }
            desc { (count(drawn)) }
            @for (from, to) in &drawn.edges {
                @if let (Some(a), Some(b)) = (places.get(from), places.get(to)) {
                    @let against = drawn.boxes.iter().any(|of| of.is_against() && of.key() == *from);
                    path class=@if against { "edge f" } @else { "edge" } d=(path(*a, *b)) {}
                }
            }
            @for of in &drawn.boxes {
                @if let Some((x, y)) = places.get(&of.key()) {
                    a href={ "#" (of.key()) } {
                        title { (hover(account, of)) }
                        rect class={ "node " (box_class(of)) } x=(x) y=(y) width=(BOX.0) height=(BOX.1)
                            rx=@if matches!(of, Boxed::System(_)) { "10" } @else { "4" } {}
                        text x=(x + BOX.0 / 2) y=(y + 14) text-anchor="middle" font-size="11" { (short(of.label())) }
                    }
                }
            }
        }
    }
}

/// A name that fits into a box.
fn short(label: &str) -> String {
    match label.chars().count() > LETTERS {
        true => label.chars().take(LETTERS - 1).chain(['…']).collect(),
        false => label.to_owned(),
    }
}

fn count(drawn: &Drawn<'_>) -> String {
    let against = drawn.boxes.iter().filter(|of| of.is_against()).count();
    let systems = drawn.boxes.iter().filter(|of| matches!(of, Boxed::System(_))).count();
    let claims = drawn.boxes.len() - systems;
    format!(
        "{claims} claims, of which {against} do not stand, {systems} systems, and {} lines between them.",
        drawn.edges.len()
    )
}

/// What a box says to those who point at it: the sentence, and its formulas as they are printed.
fn hover(account: &Account, of: &Boxed<'_>) -> String {
    /// Most formulas of a box.
    const FORMULAS: usize = 3;
    let whole = match of {
        Boxed::Claim(whole) => whole,
        Boxed::System(id) => return format!("The system {id}"),
    };
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

fn box_class(of: &Boxed<'_>) -> &'static str {
    let Boxed::Claim(whole) = of else { return "n" };
    match (whole.fate, whole.conclusion) {
        (Fate::Fails | Fate::Partly, false) => "f",
        (Fate::Fails | Fate::Partly, true) => "f concluded",
        (Fate::Reading | Fate::Open | Fate::Untested | Fate::Nowhere, false) => "u",
        (Fate::Reading | Fate::Open | Fate::Untested | Fate::Nowhere, true) => "u concluded",
        (Fate::Stands, false) => "h",
        (Fate::Stands, true) => "h concluded",
        (Fate::Choice | Fate::Lemma | Fate::Added, _) => "n",
    }
}

/// Where each box is, and how high the drawing: a layer has as many rows as it needs.
fn placed(layers: &[Vec<Boxed<'_>>], columns: usize) -> (BTreeMap<String, (usize, usize)>, usize) {
    let (step, mut y) = (BOX.0 + GAP.0, 2);
    let mut out = BTreeMap::new();
    for layer in layers {
        // Rows of one layer have the same number of boxes, as far as that goes.
        let rows = layer.len().div_ceil(columns).max(1);
        for row in layer.chunks(layer.len().div_ceil(rows).max(1)) {
            let left = (columns - row.len()) * step / 2 + 2;
            out.extend(row.iter().enumerate().map(|(at, of)| (of.key(), (left + at * step, y))));
            y += BOX.1 + GAP.1;
        }
        y += BETWEEN - GAP.1;
    }
    (out, y - BETWEEN + 2)
}

/// Each box below what it rests on, near its neighbours.
fn layers<'a>(drawn: &Drawn<'a>) -> Vec<Vec<Boxed<'a>>> {
    let keys: Vec<String> = drawn.boxes.iter().map(Boxed::key).collect();
    let mut layer: BTreeMap<&str, usize> = keys.iter().map(|key| (key.as_str(), 0)).collect();
    // No path is longer than the number of boxes; a circle is left after so many rounds.
    for _ in 0..keys.len() {
        let mut moved = false;
        for (from, to) in &drawn.edges {
            let least = layer.get(from.as_str()).map_or(0, |l| l + 1);
            if let Some(at) = layer.get_mut(to.as_str()).filter(|at| **at < least && least < keys.len()) {
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
    let mut rows: Vec<Vec<usize>> = vec![Vec::new(); used.len()];
    for (at, key) in keys.iter().enumerate() {
        let of = layer.get(key.as_str()).and_then(|l| used.binary_search(l).ok()).unwrap_or(0);
        rows[of].push(at);
    }
    let index: BTreeMap<&str, usize> = keys.iter().enumerate().map(|(at, key)| (key.as_str(), at)).collect();
    let known = |(a, b): &(String, String)| Some((*index.get(a.as_str())?, *index.get(b.as_str())?));
    let edges: Vec<(usize, usize)> = drawn.edges.iter().filter_map(known).collect();
    for sweep in 0..SWEEPS {
        // Places in thousandths of a row: layers have different lengths.
        let place: BTreeMap<usize, usize> = rows
            .iter()
            .flat_map(|row| row.iter().enumerate().map(|(at, of)| (*of, 1000 * (2 * at + 1) / (2 * row.len()))))
            .collect();
        for row in &mut rows {
            row.sort_by_key(|of| {
                let near = edges.iter().filter_map(|(a, b)| match sweep % 2 == 0 {
                    true => (b == of).then(|| place.get(a)),
                    false => (a == of).then(|| place.get(b)),
                });
                let near: Vec<usize> = near.flatten().copied().collect();
                // The mean of the neighbours; without any it stays.
                let sum: usize = near.iter().sum();
                sum.checked_div(near.len()).unwrap_or(place.get(of).copied().unwrap_or(0))
            });
        }
    }
    rows.into_iter().map(|row| row.into_iter().map(|at| drawn.boxes[at]).collect()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_fit_their_screens_and_what_rests_on_a_box_is_below_it() {
        let names: Vec<String> = (0..23).map(|k| format!("s{k}")).collect();
        let boxes: Vec<Boxed<'_>> = names.iter().map(|id| Boxed::System(id)).collect();
        let edge = |a: usize, b: usize| (system_key(&names[a]), system_key(&names[b]));
        // One ground, twenty steps, one that rests on all of them, and a circle.
        let mut edges: Vec<_> = (1..21).flat_map(|k| [edge(0, k), edge(k, 21)]).collect();
        edges.push(edge(21, 22));
        let drawn = Drawn { boxes, edges };
        let layers = layers(&drawn);
        assert_eq!(layers.iter().map(Vec::len).collect::<Vec<_>>(), [1, 20, 1, 1]);
        for (_, columns) in ROWS {
            let width = columns * (BOX.0 + GAP.0) - GAP.0 + 4;
            let (places, height) = placed(&layers, columns);
            assert!(width <= if columns > 2 { 1184 } else { 390 });
            assert!(places.values().all(|(x, y)| x + BOX.0 <= width && y + BOX.1 <= height));
            assert!(drawn.edges.iter().all(|(from, to)| places[from].1 < places[to].1));
            let distinct: std::collections::BTreeSet<_> = places.values().collect();
            assert_eq!(distinct.len(), names.len());
        }
        let circle = Drawn {
            boxes: vec![Boxed::System("a"), Boxed::System("b")],
            edges: vec![(system_key("a"), system_key("b")), (system_key("b"), system_key("a"))],
        };
        assert_eq!(super::layers(&circle).iter().map(Vec::len).sum::<usize>(), 2);
        assert_eq!(short("a-claim-with-a-very-long-name"), "a-claim-with-a-very-…");
    }
}
