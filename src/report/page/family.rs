//! A claim on families of motions: counts, and the members that a reader wants to see, each as a trajectory to paste.

use maud::{Markup, PreEscaped, html};

use super::super::family;
use super::super::numbers::value;
use super::super::plot::{Scale, Words, plane};
use super::super::tally::name;
use super::map;
use super::text::{plain, prose};
use crate::latex::Scope;
use findings::ClaimAccount;
use findings::family::{SlopeAccount, SlopeCell};
use findings::{Line, LineKind};

/// The slopes of a scaling law: those of single pairs, that of all, and how far the claimed power may be off.
fn slopes(of: &SlopeAccount, claim: &str, scope: &Scope) -> Markup {
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

/// The blocks of a claim, one for each family.
pub(super) fn blocks(claim: &ClaimAccount, scope: &Scope) -> Markup {
    html! {
        @for of in &claim.families {
            div class={ "region " (of.verdict.outcome().word()) } {
                p {
                    b { (family::heading(of)) " " (of.family) }
                    @if of.title != of.family { " (" (prose(&of.title, scope)) ")" }
                    @if of.is_unexpected() { strong.alarm { (family::expected(of)) } }
                    ". " (prose(&family::sentence(&family::counts(of)), scope))
                }
                @for text in family::remarks(of) { p.quiet { (prose(&family::sentence(&text), scope)) } }
                @if let Some(map) = &of.map { (map::figure(map, &name(claim), scope)) }
                @if let Some(slope) = &of.slope { (slopes(slope, &name(claim), scope)) }
                @for shown in family::shown(of) {
                    details {
                        summary { (prose(&shown.named(), scope)) }
                        @if let Some(text) = &shown.seen { p { (prose(&family::sentence(text), scope)) } }
                        p.quiet { "The same motion for the derivation file:" }
                        pre tabindex="0" { (shown.member.toml) }
                    }
                }
            }
        }
    }
}
