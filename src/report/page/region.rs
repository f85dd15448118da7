//! A claim over ranges of values: its verdict, and the picture of two ranges.
//!
//! The picture is written by hand: a board of squares, one path for each part. Parts differ by pattern and by colour: proved is
//! full, refuted is hatched, undecided is chequered, and where the claim does not apply the paper is left as it is.

use maud::{Markup, PreEscaped, html};

use super::super::numbers::value;
use super::super::region;
use super::super::tally::name;
use super::text::{plain, prose, unit};
use crate::check::ClaimAccount;
use crate::check::region::{Part, RangeAccount, RegionAccount, RegionMap};
use crate::latex::Scope;

/// The board in units of the picture: left, top, and the length of a side.
const BOARD: (f64, f64, f64) = (84.0, 12.0, 384.0);

/// The block of a claim.
pub(super) fn block(claim: &ClaimAccount, scope: &Scope) -> Markup {
    let Some(of) = &claim.region else { return html! {} };
    let word = of.verdict.outcome().word();
    html! {
        div class={ "region " (word) } {
            @if let Some(ranges) = region::ranges(of) { p { (prose(&ranges, scope)) } }
            p {
                (prose(&region::verdict(of), scope))
                @if of.is_unexpected() { strong.alarm { (region::expected(of)) } }
                "."
            }
            @for note in region::notes(of) { p.quiet { (prose(&note, scope)) "." } }
            @if let Some(map) = &of.map { (figure(claim, of, map)) }
        }
    }
}

/// The parts that are told apart, with a class of the page and what they are called.
const PARTS: [(&[Part], &str, &str); 4] = [
    (&[Part::Proved, Part::Border], "rp", "proved"),
    (&[Part::Refuted], "rf", "refuted"),
    (&[Part::NotApplicable], "rn", "does not apply"),
    (&[Part::Undecided], "ru", "undecided"),
];

fn label(of: &RangeAccount) -> String {
    let name = plain(&of.name);
    match of.unit.as_deref().filter(|u| *u != "1") {
        Some(u) => format!("{name} in {}", unit(u)),
        None => name,
    }
}

/// A number at an end or in the middle of an axis.
fn tick(of: &RangeAccount, share: f64) -> String {
    let (from, to) = of.values.unwrap_or((0.0, 1.0));
    let x = from + share * (to - from);
    let rounded: f64 = format!("{x:.5e}").parse().unwrap_or(x);
    value(rounded).replace('-', "−")
}

fn figure(claim: &ClaimAccount, of: &RegionAccount, map: &RegionMap) -> Markup {
    let (Some(across), Some(up)) = (of.ranges.get(map.axes.0), of.ranges.get(map.axes.1)) else { return html! {} };
    let name = name(claim);
    // Every picture has its own patterns: a page may show one claim alone.
    let id = |class: &str| format!("/{class}/{name}");
    let (left, top, side) = BOARD;
    let (right, bottom) = (left + side, top + side);
    let scale = side / f64::from(map.squares);
    let shown: Vec<&(&[Part], &str, &str)> =
        PARTS.iter().filter(|(parts, ..)| map.patches.iter().any(|p| parts.contains(&p.part))).collect();
    let path = |parts: &[Part]| -> String {
        let of_part = map.patches.iter().filter(|p| parts.contains(&p.part));
        of_part.map(|p| format!("M{} {}h{}v{}h-{}z", p.column, p.row, p.width, p.height, p.width)).collect()
    };
    let more = if of.varying > 2 { "; refuted means for some values of the others" } else { "" };
    let say = |(parts, _, word): &&(&[Part], &str, &str)| {
        let squares: u32 = map.patches.iter().filter(|p| parts.contains(&p.part)).map(|p| p.width * p.height).sum();
        let share = 100.0 * f64::from(squares) / f64::from(map.squares * map.squares);
        format!("{word} on {} of 100 parts", (10.0 * share).round() / 10.0)
    };
    let describe = format!(
        "{} from {} to {} to the right, {} from {} to {} upwards: {}{more}.",
        label(across),
        tick(across, 0.0),
        tick(across, 1.0),
        label(up),
        tick(up, 0.0),
        tick(up, 1.0),
        shown.iter().map(say).collect::<Vec<_>>().join(", "),
    );
    let pattern = |class: &str, d: &str| {
        html! {
            pattern id=(id(class)) class=(class) width="6" height="6" patternUnits="userSpaceOnUse"
                patternTransform=(format!("scale({})", 1.0 / scale)) { path d=(d); }
        }
    };
    let fill = |class: &str| match class {
        "rf" | "ru" => format!("fill:url(#{})", id(class)),
        _ => String::new(),
    };
    let text = |x: f64, y: f64, anchor: &str, words: String| {
        html! { text x=(x) y=(y) text-anchor=(anchor) { (words) } }
    };
    html! {
        figure.map {
            svg role="img" viewBox="0 0 480 470" {
                title { "Where " (name) " is proved" }
                desc { (describe) }
                defs {
                    (pattern("rf", "M0 6L6 0M-1 1L1 -1M5 7L7 5"))
                    (pattern("ru", "M0 0h3v3h-3zM3 3h3v3h-3z"))
                }
                g transform=(format!("translate({left} {bottom}) scale({scale} -{scale})")) {
                    @for (parts, class, _) in &shown {
                        path class=(class) style=[Some(fill(class)).filter(|f| !f.is_empty())] d=(path(parts));
                    }
                }
                path.axis d=(format!("M{left} {top}h{side}v{side}h-{side}z"));
                @for (share, anchor) in [(0.0, "start"), (0.5, "middle"), (1.0, "end")] {
                    (text(left + share * side, bottom + 18.0, anchor, tick(across, share)))
                    (text(left - 6.0, bottom - share * side + if share == 1.0 { 12.0 } else { 0.0 }, "end", tick(up, share)))
                }
                (text(0.5 * (left + right), bottom + 38.0, "middle", label(across)))
                text transform=(format!("translate(16 {}) rotate(-90)", top + 0.5 * side)) text-anchor="middle" { (label(up)) }
                @for (i, (_, class, word)) in shown.iter().enumerate() {
                    @let x = left + 104.0 * i as f64 - 60.0;
                    g transform=(format!("translate({x} 452) scale({scale})")) {
                        rect class=(class) style=[Some(fill(class)).filter(|f| !f.is_empty())] width="2" height="2" {}
                    }
                    (text(x + 16.0, 463.0, "start", (*word).to_owned()))
                }
            }
            figcaption { (PreEscaped(super::super::mathml::escaped(&describe))) }
        }
    }
}
