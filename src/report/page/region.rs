//! The pictures of a claim over ranges of values.
//!
//! The picture is written by hand: a board of squares, one path for each part. Parts differ by pattern and by colour: proved is
//! full, refuted is hatched, undecided is ruled, and where the claim does not apply the paper is left as it is. The lines are
//! lines, not patterns that are referred to: the page refers to nothing.

use maud::{Markup, html};

use super::super::tally::name;
use super::board::{BOARD, axes, label, tick};
use super::portrait;
use super::text::prose;
use findings::ClaimAccount;
use findings::region::{Part, RegionAccount, RegionMap};
use latex::Scope;

/// The pictures of a claim.
pub(in super::super) fn figures(claim: &ClaimAccount, of: &RegionAccount, scope: &Scope) -> Markup {
    html! {
        @if let Some(map) = &of.map { (figure(claim, of, map, scope)) }
        @if !of.portraits.is_empty() {
            div.pictures { @for portrait in &of.portraits { (portrait::figure(of, portrait, scope)) } }
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

/// The path of a part on a board: its squares, diagonals through them, or a line in each row.
fn path(map: &RegionMap, parts: &[Part], class: &str) -> String {
    let n = map.squares as usize;
    let patches = || map.patches.iter().filter(|p| parts.contains(&p.part));
    if class == "rp" || class == "rn" {
        return patches().map(|p| format!("M{} {}h{}v{}h-{}z", p.column, p.row, p.width, p.height, p.width)).collect();
    }
    let mut board = vec![false; n * n];
    for p in patches() {
        for row in p.row..p.row + p.height {
            let from = row as usize * n + p.column as usize;
            board[from..from + p.width as usize].fill(true);
        }
    }
    let mut out = String::new();
    let lines = if class == "rf" { 2 * n - 1 } else { n };
    for line in 0..lines {
        // Squares of a diagonal from the upper left to the lower right, or of a row.
        let square = |c: usize| match class {
            "rf" => line.checked_sub(c).filter(|r| *r < n).is_some_and(|r| board[r * n + c]),
            _ => board[line * n + c],
        };
        let mut column = 0;
        while column < n {
            let run = (column..n).take_while(|c| square(*c)).count();
            if run > 0 {
                out.push_str(&match class {
                    "rf" => format!("M{column} {}l{run}-{run}", line - column + 1),
                    _ => format!("M{column} {line}.5h{run}"),
                });
            }
            column += run.max(1);
        }
    }
    out
}

fn figure(claim: &ClaimAccount, of: &RegionAccount, map: &RegionMap, scope: &Scope) -> Markup {
    let (Some(across), Some(up)) = (of.ranges.get(map.axes.0), of.ranges.get(map.axes.1)) else { return html! {} };
    let name = name(claim);
    let (left, top, side) = BOARD;
    let bottom = top + side;
    let scale = side / f64::from(map.squares);
    let shown: Vec<&(&[Part], &str, &str)> =
        PARTS.iter().filter(|(parts, ..)| map.patches.iter().any(|p| parts.contains(&p.part))).collect();
    let more = if of.varying > 2 { "; refuted means for some values of the others" } else { "" };
    let say = |(parts, _, word): &&(&[Part], &str, &str)| {
        let squares: u32 = map.patches.iter().filter(|p| parts.contains(&p.part)).map(|p| p.width * p.height).sum();
        let share = 100.0 * f64::from(squares) / f64::from(map.squares * map.squares);
        match share {
            s if s < 0.1 => format!("{word} on less than 0.1 % of the squares"),
            s if s > 99.9 => format!("{word} on more than 99.9 % of the squares"),
            s => format!("{word} on {} % of the squares", (10.0 * s).round() / 10.0),
        }
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
    // The shares of the box stand above; those of the squares are for those who do not see them.
    let caption = format!("${}$ to the right, ${}$ upwards{more}.", across.name, up.name);
    let text = |x: f64, y: f64, anchor: &str, words: String| {
        html! { text x=(x) y=(y) text-anchor=(anchor) { (words) } }
    };
    html! {
        figure.map {
            svg role="img" viewBox="0 0 480 470" {
                title { "Where " (name) " is proved" }
                desc { (describe) }
                g transform=(format!("translate({left} {bottom}) scale({scale} -{scale})")) {
                    @for (parts, class, _) in &shown { path class=(class) d=(path(map, parts, class)) {} }
                }
                (axes(across, up))
                @for (i, (_, class, word)) in shown.iter().enumerate() {
                    @let before: usize = shown[..i].iter().map(|(_, _, word)| word.chars().count()).sum();
                    @let x = 24.0 + 34.0 * i as f64 + 8.0 * before as f64;
                    g transform=(format!("translate({x} 452) scale({scale})")) {
                        path class=(class) d=(match *class {
                            "rf" => "M0 1l1-1M0 2l2-2M1 2l1-1",
                            "ru" => "M0 .5h2M0 1.5h2",
                            _ => "M0 0h2v2h-2z",
                        }) {}
                        path.rs d="M0 0h2v2h-2z" {}
                    }
                    (text(x + 16.0, 463.0, "start", (*word).to_owned()))
                }
            }
            figcaption { (prose(&caption, scope)) }
        }
    }
}
