//! The board of a picture over two ranges: its frame, the ends of the ranges, their names.

use maud::{Markup, html};

use super::super::numbers::value;
use super::text::{plain, unit};
use findings::region::RangeAccount;

/// The board in units of the picture: left, top, and the length of a side.
pub(super) const BOARD: (f64, f64, f64) = (84.0, 12.0, 384.0);

/// The name of a range, with its unit.
pub(super) fn label(of: &RangeAccount) -> String {
    let name = plain(&of.name);
    match of.unit.as_deref().filter(|u| *u != "1") {
        Some(u) => format!("{name} in {}", unit(u)),
        None => name,
    }
}

/// A number at an end or in the middle of an axis.
pub(super) fn tick(of: &RangeAccount, share: f64) -> String {
    let (from, to) = of.values.unwrap_or((0.0, 1.0));
    let x = from + share * (to - from);
    let rounded: f64 = format!("{x:.5e}").parse().unwrap_or(x);
    value(rounded).replace('-', "−")
}

/// The frame of a board, with the ends of its ranges and their names.
pub(super) fn axes(across: &RangeAccount, up: &RangeAccount) -> Markup {
    let (left, top, side) = BOARD;
    let bottom = top + side;
    let text = |x: f64, y: f64, anchor: &str, words: String| {
        html! { text x=(x) y=(y) text-anchor=(anchor) { (words) } }
    };
    html! {
        path.axis d=(format!("M{left} {top}h{side}v{side}h-{side}z")) {}
        @for (share, anchor) in [(0.0, "start"), (0.5, "middle"), (1.0, "end")] {
            (text(left + share * side, bottom + 18.0, anchor, tick(across, share)))
            (text(left - 6.0, bottom - share * side + if share == 1.0 { 12.0 } else { 0.0 }, "end", tick(up, share)))
        }
        (text(left + 0.5 * side, bottom + 38.0, "middle", label(across)))
        text transform=(format!("translate(16 {}) rotate(-90)", top + 0.5 * side)) text-anchor="middle" { (label(up)) }
    }
}
