//! The map of a family: a board of cells over two of the symbols that vary, each with the worst verdict of its members.
//!
//! Cells differ by pattern and by colour, as the pictures of ranges do, so that they are told apart in print and by those who do not
//! see colours: holds is full, fails is hatched, undecided is ruled, does not apply is a dash; a cell without members is empty. All
//! that is seen is said in the description of the picture, and is in `report.json` as counts.

use std::collections::BTreeMap;

use maud::{Markup, html};

use super::super::numbers::value;
use super::text::{plain, prose};
use findings::family::{Axis, Boundary, FamilyMap};
use latex::Scope;

/// The board in units of the picture: left, top, and the length of its longer side.
const BOARD: (f64, f64, f64) = (84.0, 12.0, 384.0);

/// Verdicts by the position of their count: a class of the page, what they are called, and the pattern of a sample of two cells.
const KINDS: [(&str, &str, &str); 4] = [
    ("rp", "holds", "M0 0h2v2h-2z"),
    ("rf", "fails", "M0 1l1-1M0 2l2-2M1 2l1-1"),
    ("rd", "does not apply", "M.6 1h.8"),
    ("ru", "undecided", "M0 .5h2M0 1.5h2"),
];
/// The order in which the verdicts of several members are shown, the first that there is.
const WORST: [usize; 4] = [1, 3, 0, 2];

/// What a cell shows: the position of a verdict; nothing without members.
fn shown(counts: &[u64; 4]) -> Option<usize> {
    WORST.into_iter().find(|kind| counts[*kind] > 0)
}

/// The value of an end, or of the middle, of an axis.
fn tick(axis: &Axis, share: f64) -> String {
    let cells = &axis.cells;
    let (Some(first), Some(last)) = (cells.first(), cells.last()) else { return String::new() };
    let x = match share {
        0.0 => first.0,
        1.0 => last.1,
        // The middle of a cell, or what lies between two.
        _ => 0.5 * (cells[(cells.len() - 1) / 2].1 + cells[cells.len() / 2].0),
    };
    let rounded: f64 = format!("{x:.4e}").parse().unwrap_or(x);
    value(rounded).replace('-', "−")
}

/// The path of all cells that show one verdict, row by row: runs of cells where they are full or ruled.
fn path(map: &FamilyMap, kind: usize) -> String {
    let columns = map.across.cells.len().max(1);
    let mut out = String::new();
    for (row, cells) in map.cells.chunks(columns).enumerate() {
        let mut column = 0;
        while column < cells.len() {
            let run = cells[column..].iter().take_while(|c| shown(c) == Some(kind)).count();
            match kind {
                _ if run == 0 => {}
                0 => out.push_str(&format!("M{column} {row}h{run}v1h-{run}z")),
                3 => out.push_str(&format!("M{column} {row}.5h{run}")),
                1 => (column..column + run).for_each(|c| out.push_str(&format!("M{c} {}l1-1", row + 1))),
                _ => (column..column + run).for_each(|c| out.push_str(&format!("M{c}.3 {row}.5h.4"))),
            }
            column += run.max(1);
        }
    }
    out
}

/// Where a value stands on an axis, in cells: each value in the middle of its own.
fn place(axis: &Axis, x: f64) -> f64 {
    let next = axis.cells.partition_point(|cell| cell.0 <= x);
    let Some(before) = next.checked_sub(1) else { return 0.5 };
    let share = match (axis.cells.get(before), axis.cells.get(next)) {
        (Some(a), Some(b)) => (x - a.0) / (b.0 - a.0),
        _ => 0.0,
    };
    // Four digits are finer than what is seen.
    ((before as f64 + 0.5 + share) * 1e4).round() / 1e4
}

/// The boundary: a point at each crossing, and a line between those two that lie on the sides of one square of neighbours.
fn edge(map: &FamilyMap, boundary: &Boundary) -> String {
    let middle = |axis: &Axis, (a, b): (f64, f64)| place(axis, 0.5 * (a + b));
    let points: Vec<(usize, f64, f64)> =
        boundary.crossings.iter().map(|c| (c.along, middle(&map.across, c.across), middle(&map.up, c.up))).collect();
    let mut out = String::new();
    let mut squares: BTreeMap<(usize, usize), Vec<(f64, f64)>> = BTreeMap::new();
    for &(along, x, y) in &points {
        out.push_str(&format!("M{x} {y}h0"));
        // The square that is named by the cell of its lower left member, and the one before it.
        let (column, row) = ((x - 0.5).floor().max(0.0) as usize, (y - 0.5).floor().max(0.0) as usize);
        let before =
            if along == 0 { row.checked_sub(1).map(|r| (column, r)) } else { column.checked_sub(1).map(|c| (c, row)) };
        for square in before.into_iter().chain([(column, row)]) {
            squares.entry(square).or_default().push((x, y));
        }
    }
    for points in squares.values() {
        if let [(x, y), (to_x, to_y)] = points[..] {
            out.push_str(&format!("M{x} {y}L{to_x} {to_y}"));
        }
    }
    out
}

/// What the map says, for those who do not see it.
fn description(map: &FamilyMap) -> String {
    let end = |axis: &Axis| format!("{} from {} to {}", plain(&axis.name), tick(axis, 0.0), tick(axis, 1.0));
    let cells = |kind: usize| map.cells.iter().filter(|c| shown(c) == Some(kind)).count();
    let with = map.cells.iter().filter(|c| shown(c).is_some()).count();
    let each: Vec<String> = (0..KINDS.len())
        .filter(|kind| cells(*kind) > 0)
        .map(|kind| format!("{} in {} of {with} cells", KINDS[kind].1, cells(kind)))
        .collect();
    format!("{} to the right, {} upwards: {}.", end(&map.across), end(&map.up), each.join(", "))
}

/// The picture; nothing where no member was tried.
pub(in super::super) fn figure(map: &FamilyMap, claim: &str, scope: &Scope) -> Markup {
    let (left, top, side) = BOARD;
    let (columns, rows) = (map.across.cells.len().max(1), map.up.cells.len().max(1));
    let scale = side / columns.max(rows) as f64;
    let (width, height) = (scale * columns as f64, scale * rows as f64);
    let bottom = top + height;
    let kinds: Vec<usize> = (0..KINDS.len()).filter(|k| map.cells.iter().any(|c| shown(c) == Some(*k))).collect();
    if kinds.is_empty() {
        return html! {};
    }
    let several = map.cells.iter().any(|c| c.iter().sum::<u64>() > 1);
    let more =
        if several { " A cell with several members shows the worst of them: fails, undecided, holds." } else { "" };
    let empty = if map.cells.iter().any(|c| shown(c).is_none()) { " An empty cell has no members." } else { "" };
    let line = if map.boundary.is_some() { " The line is the edge of where it holds." } else { "" };
    let caption = format!("${}$ to the right, ${}$ upwards.{more}{empty}{line}", map.across.name, map.up.name);
    let text = |x: f64, y: f64, anchor: &str, words: String| {
        html! { text x=(x) y=(y) text-anchor=(anchor) { (words) } }
    };
    // A sample of each pattern, two cells wide, of one size whatever the cells are.
    let sample = 6.0;
    html! {
        figure.map {
            svg role="img" viewBox=(format!("0 0 480 {}", height + 86.0)) {
                title { "Where " (claim) " holds" }
                desc { (description(map)) }
                g transform=(format!("translate({left} {bottom}) scale({scale} -{scale})")) {
                    @for kind in &kinds { path class=(KINDS[*kind].0) d=(path(map, *kind)) {} }
                    @if let Some(boundary) = &map.boundary { path.rb d=(edge(map, boundary)) {} }
                }
                path.axis d=(format!("M{left} {top}h{width}v{height}h-{width}z")) {}
                @for (share, anchor) in [(0.0, "start"), (0.5, "middle"), (1.0, "end")] {
                    @if columns > 2 || share != 0.5 { (text(left + share * width, bottom + 18.0, anchor, tick(&map.across, share))) }
                    @if rows > 2 || share != 0.5 {
                        (text(left - 6.0, bottom - share * height + if share == 1.0 { 12.0 } else { 0.0 }, "end", tick(&map.up, share)))
                    }
                }
                (text(left + 0.5 * width, bottom + 38.0, "middle", plain(&map.across.name)))
                text transform=(format!("translate(16 {}) rotate(-90)", top + 0.5 * height)) text-anchor="middle" { (plain(&map.up.name)) }
                @for (i, kind) in kinds.iter().enumerate() {
                    @let before: usize = kinds[..i].iter().map(|k| KINDS[*k].1.chars().count()).sum();
                    @let x = 24.0 + 34.0 * i as f64 + 8.0 * before as f64;
                    g transform=(format!("translate({x} {}) scale({sample})", bottom + 52.0)) {
                        path class=(KINDS[*kind].0) d=(KINDS[*kind].2) {}
                        path.rs d="M0 0h2v2h-2z" {}
                    }
                    (text(x + 16.0, bottom + 63.0, "start", KINDS[*kind].1.to_owned()))
                }
            }
            figcaption { (prose(&caption, scope)) }
        }
    }
}
