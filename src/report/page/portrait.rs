//! Fields over two ranges: a map of a number, arrows of a vector, and where an equation fails.
//!
//! A number is a square of ink, the larger the farther it is from 0; what is below 0 is the frame of a square, so that signs are told
//! apart in print, and by those who do not see colours. Where there is no value, there is a dash. A cross marks the witness. All that
//! is seen is said in the description.

use maud::{Markup, html};

use super::super::numbers::value;
use super::board::{BOARD, axes, label};
use super::text::{plain, prose};
use findings::region::{ARROWS, Drawn, Portrait, RegionAccount, SQUARES};
use latex::Scope;

fn number(x: f64) -> String {
    let rounded: f64 = format!("{x:.2e}").parse().unwrap_or(x);
    value(rounded).replace('-', "−")
}

/// A coordinate on the board, to a hundredth of a square: what is finer is not seen.
fn place(x: f64) -> String {
    let rounded = (100.0 * x).round() / 100.0;
    format!("{}", if rounded == 0.0 { 0.0 } else { rounded })
}

/// Positive numbers, negative ones, and what has no value, as paths on a board of squares.
fn squares(values: &[Option<f64>], largest: f64) -> [String; 3] {
    let mut out = [String::new(), String::new(), String::new()];
    for (i, v) in values.iter().enumerate() {
        let (column, row) = ((i % SQUARES) as f64, (i / SQUARES) as f64);
        // Its area is the size of the number.
        let side =
            v.map(|v| if largest > 0.0 { (0.95 * (v.abs() / largest).sqrt() * 20.0).round() / 20.0 } else { 0.0 });
        let (kind, path) = match (v, side) {
            (Some(_), Some(0.0)) => continue,
            (Some(v), Some(side)) => {
                let (x, y, s) = (place(column + 0.5 - side / 2.0), place(row + 0.5 - side / 2.0), place(side));
                (usize::from(*v < 0.0), format!("M{x} {y}h{s}v{s}h-{s}z"))
            }
            _ => (2, format!("M{} {}h.4", place(column + 0.3), place(row + 0.5))),
        };
        out[kind].push_str(&path);
    }
    out
}

/// Arrows from the middles of squares, the longest as long as a square.
fn arrows(values: &[Option<(f64, f64)>], longest: f64) -> String {
    let mut out = String::new();
    for (i, v) in values.iter().enumerate() {
        let Some((dx, dy)) = v.filter(|_| longest > 0.0) else { continue };
        let (dx, dy) = (0.9 * dx / longest, 0.9 * dy / longest);
        let (x, y) = ((i % ARROWS) as f64 + 0.5 - dx / 2.0, (i / ARROWS) as f64 + 0.5 - dy / 2.0);
        // Two strokes back from the head.
        let head = |turn: f64| (-0.35 * (dx - turn * dy), -0.35 * (dy + turn * dx));
        let ((ax, ay), (bx, by)) = (head(0.6), head(-0.6));
        let [x, y, dx, dy] = [x, y, dx, dy].map(place);
        let back = |x: f64| place(-x);
        let [ax1, ay1, bx1, by1] = [ax, ay, bx, by].map(place);
        out.push_str(&format!("M{x} {y}l{dx} {dy}l{ax1} {ay1}m{} {}l{bx1} {by1}", back(ax), back(ay)));
    }
    out
}

/// The picture; nothing where the ranges are not there.
pub(super) fn figure(of: &RegionAccount, portrait: &Portrait, scope: &Scope) -> Markup {
    let [across, up, ..] = &of.ranges[..] else { return html! {} };
    let (left, top, side) = BOARD;
    let bottom = top + side;
    let what = if portrait.residual { "The left side minus the right side of" } else { "The field" };
    let witness = of.witness.as_ref().and_then(|w| {
        let at = |name: &str, ends: Option<(f64, f64)>| {
            let (from, to) = ends?;
            let x = w.values.iter().find(|(n, _)| n == name)?.1;
            Some((x - from) / (to - from))
        };
        Some((left + side * at(&across.name, across.values)?, bottom - side * at(&up.name, up.values)?))
    });
    let (count, drawn, says) = match &portrait.drawn {
        Drawn::Shades(values) => {
            let known = || values.iter().copied().flatten();
            let (low, high) = known().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
            let [above, below, none] = squares(values, low.abs().max(high.abs()));
            let missing = values.iter().filter(|v| v.is_none()).count();
            let gaps = if missing > 0 {
                format!("; no value in {missing} of {} squares", values.len())
            } else {
                String::new()
            };
            let drawn = html! {
                @if !above.is_empty() { path.fp d=(above) {} }
                @if !below.is_empty() { path.fm d=(below) {} }
                @if !none.is_empty() { path.rd d=(none) {} }
            };
            (SQUARES, drawn, format!("between {} and {}{gaps}", number(low), number(high)))
        }
        Drawn::Arrows(values) => {
            let longest = values.iter().copied().flatten().fold(0.0, |l: f64, (a, b)| l.max(a.hypot(b)));
            let drawn = html! { path.fa d=(arrows(values, longest)) {} };
            (ARROWS, drawn, format!("arrows, the longest of length {}", number(longest)))
        }
    };
    let marked = if witness.is_some() { " The cross marks the point at which the claim fails." } else { "" };
    let others = if of.varying > 2 { " Everything else is in the middle of its range." } else { "" };
    let describe = format!("{} to the right, {} upwards: {says}.{marked}{others}", label(across), label(up));
    let full = match portrait.drawn {
        Drawn::Shades(_) => " Full squares are positive, frames negative; the area is the size.",
        Drawn::Arrows(_) => "",
    };
    let caption = format!("{what} ${}$: {says}.{full}{marked}{others}", portrait.shows);
    let scale = side / count as f64;
    html! {
        figure.map {
            svg role="img" viewBox="0 0 480 446" {
                title { (what) " " (plain(&portrait.shows)) }
                desc { (describe) }
                g transform=(format!("translate({left} {bottom}) scale({scale} -{scale})")) { (drawn) }
                (axes(across, up))
                @if let Some((x, y)) = witness {
                    path.fx d=(format!("M{} {}l12 12m-12 0l12-12", place(x - 6.0), place(y - 6.0))) {}
                }
            }
            figcaption { (prose(&caption, scope)) }
        }
    }
}
