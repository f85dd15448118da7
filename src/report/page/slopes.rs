//! The slopes of a scaling law, drawn against what varies.

use maud::{Markup, PreEscaped, html};

use super::super::numbers::value;
use super::super::plot::{Scale, Words, plane};
use super::text::{plain, prose};
use findings::family::{SlopeAccount, SlopeCell};
use findings::{Line, LineKind};
use latex::Scope;

/// The slopes of a scaling law: those of single pairs, that of all, and how far the claimed power may be off.
pub(in super::super) fn figure(of: &SlopeAccount, claim: &str, scope: &Scope) -> Markup {
    let cells: Vec<&SlopeCell> = of.cells.iter().filter(|c| c.logarithm.is_finite()).collect();
    let (begin, end) = (cells.first().map_or(0.0, |c| c.logarithm), cells.last().map_or(0.0, |c| c.logarithm));
    let of_pairs = |slope: fn(&SlopeCell) -> f64| Line {
        kind: LineKind::Shown(0),
        points: cells.iter().map(|c| (c.logarithm, slope(c))).collect(),
    };
    let level = |kind: LineKind, y: f64| Line { kind, points: vec![(begin, y), (end, y)] };
    let claimed = |y: f64| [level(LineKind::Shown(1), y)];
    let lines: Vec<Line> = [of_pairs(|c| c.least), of_pairs(|c| c.greatest), level(LineKind::Shown(2), of.slope)]
        .into_iter()
        .chain([of.power - of.to, of.power + of.to].into_iter().flat_map(claimed))
        .collect();
    let with = plain(&of.with);
    let describe = format!(
        "Slopes of pairs of members against the logarithm of {with}, from {} to {}; that of all, {}; and the claimed power {}, \
         with what it may be off, {}, to both sides.",
        short(of.least),
        short(of.greatest),
        short(of.slope),
        short(of.power),
        short(of.to),
    );
    let across = format!("ln |{with}|");
    let words = Words { title: claim, describe: &describe, across: &across, up: "slope", axes: &[], scale: Scale::Own };
    let caption = format!(
        "Slopes between neighbours along ${}$; level, that of all by least squares; the two outer level lines, how far the claimed \
         power may be off.",
        of.with
    );
    html! {
        @if let Some(picture) = plane(&lines, &words) {
            div.pictures { figure class="picture time" { (PreEscaped(picture)) figcaption { (prose(&caption, scope)) } } }
        }
    }
}

/// A number with five digits.
fn short(x: f64) -> String {
    value(format!("{x:.4e}").parse().unwrap_or(x)).replace('-', "−")
}
