//! The matrix of verdicts.

use maud::{Markup, html};

use super::super::discrimination::is_weak;
use super::super::tally::name;
use findings::{Account, ClaimAccount, Outcome, PairAccount, Strength};

/// The class of a pair: its verdict, and `s`, `e`, `p` for the strength of one that holds or fails.
pub(super) fn class(pair: &PairAccount) -> &'static str {
    match (pair.verdict.outcome(), pair.is_unexpected()) {
        (Outcome::Holds(Strength::Sampled), false) => "h",
        (Outcome::Holds(Strength::Sampled), true) => "h x",
        (Outcome::Holds(Strength::Enclosed), false) => "h e",
        (Outcome::Holds(Strength::Enclosed), true) => "h e x",
        (Outcome::Holds(Strength::Proved), false) => "h p",
        (Outcome::Holds(Strength::Proved), true) => "h p x",
        (Outcome::Fails(Strength::Sampled), false) => "f",
        (Outcome::Fails(Strength::Sampled), true) => "f x",
        (Outcome::Fails(_), false) => "f e",
        (Outcome::Fails(_), true) => "f e x",
        (Outcome::NotApplicable(_), false) => "n",
        (Outcome::NotApplicable(_), true) => "n x",
        (Outcome::Undecided, false) => "u",
        (Outcome::Undecided, true) => "u x",
    }
}

/// Whether a pair is marked as weak: many altered formulas would hold as well. A proof needs no motion that tells.
fn is_marked(pair: &PairAccount) -> bool {
    is_weak(pair) && matches!(pair.verdict.outcome(), Outcome::Holds(Strength::Sampled | Strength::Enclosed))
}

/// The class of a cell: that of the pair, and `w` where it is weak.
fn cell(pair: &PairAccount) -> String {
    if is_marked(pair) { format!("{} w", class(pair)) } else { class(pair).to_owned() }
}

/// Where the pairs of a claim stand on the page: `/p`, row and column of the matrix. Short, since there are thousands; the script
/// writes the address of a pair as `claim@trajectory`, which stays when claims are added.
pub(super) fn anchors<'a>(account: &'a Account, claim: &ClaimAccount) -> impl Fn(&PairAccount) -> String + use<'a> {
    // Claims over ranges, and on families alone, have no row.
    let mut rows = account.claims.iter().filter(|c| !c.results.is_empty());
    let row = rows.position(|c| c.id == claim.id && c.reading == claim.reading);
    let (row, columns) = (row.unwrap_or_default(), account.columns());
    move |pair| format!("/p{row}-{}", columns.get(pair.trajectory.as_str()).copied().unwrap_or_default())
}

/// The letters of a pair, for those who do not see its shape, and what they mean: there are thousands, and words would be a tenth
/// of the page. The script makes words of them where a pair is told.
const LETTERS: [(&str, &str); 9] = [
    ("HP", "holds, proved"),
    ("HE", "holds, enclosed"),
    ("H", "holds"),
    ("FC", "fails, certified"),
    ("F", "fails"),
    ("N", "does not apply"),
    ("U", "undecided"),
    ("w", "weak"),
    ("x", "not as expected"),
];

fn letters(pair: &PairAccount) -> &'static str {
    match pair.verdict.outcome() {
        Outcome::Holds(Strength::Proved) => "HP",
        Outcome::Holds(Strength::Enclosed) => "HE",
        Outcome::Holds(Strength::Sampled) => "H",
        Outcome::Fails(Strength::Enclosed | Strength::Proved) => "FC",
        Outcome::Fails(Strength::Sampled) => "F",
        Outcome::NotApplicable(_) => "N",
        Outcome::Undecided => "U",
    }
}

/// Pages with more pairs are large.
const MOST_PAIRS: usize = 1_000;

/// Whether there are more than [`MOST_PAIRS`] verdicts of claims on motions.
pub(super) fn has_many_pairs(account: &Account) -> bool {
    account.claims.iter().map(|c| c.results.len()).sum::<usize>() > MOST_PAIRS
}

/// Whether any claim was tried on a motion; a file about fields and ranges alone has none.
pub(super) fn has_pairs(account: &Account) -> bool {
    account.claims.iter().any(|claim| !claim.results.is_empty())
}

/// The matrix with its legend and filters; unseen where it would be empty.
pub(super) fn section(account: &Account) -> Markup {
    let is_large = has_many_pairs(account);
    html! {
        section id="/matrix" hidden[!has_pairs(account)] {
            h2 { "Claims and motions" }
            p.quiet { "Each cell leads to the verdict of a claim on a motion, with its evidence; so does each name to its claim." }
            (legend())
            (filters(account))
            div.scroll.wide tabindex="0" role="group" aria-label="Matrix of verdicts" {
                table.matrix {
                    caption {
                        "Rows are claims, columns are motions."
                        @if is_large { span.unseen { " Where the script does not run, equal neighbours are told once, with their number." } }
                        span.unseen { @for (letter, words) in LETTERS { " " span data-l=(letter) { (letter) ": " (words) } "." } }
                    }
                    thead {
                        tr {
                            th scope="col" { "claim" }
                            @for t in &account.trajectories {
                                th scope="col" { a href={ "#/trajectory/" (t.id) } { (t.id) } }
                            }
                        }
                    }
                    tbody {
                        // What is about ranges, or families alone, has no cells.
                        @for claim in account.claims.iter().filter(|c| !c.results.is_empty()) { (row(account, claim, is_large)) }
                    }
                }
            }
            p id="/none" hidden { "No verdict is left by these filters." }
        }
    }
}

/// The letters of a cell; of no pair a point.
fn told(pair: Option<&&PairAccount>) -> String {
    let Some(pair) = pair else { return ".".to_owned() };
    let (weak, unexpected) = (is_marked(pair), pair.is_unexpected());
    format!("{}{}{}", letters(pair), if weak { "w" } else { "" }, if unexpected { "x" } else { "" })
}

/// A row of a large matrix: runs of equal cells, as `HE*12`. The script makes cells of them.
fn runs(account: &Account, claim: &ClaimAccount) -> String {
    let on = claim.on_each();
    let mut runs: Vec<(String, usize)> = Vec::new();
    for t in &account.trajectories {
        let cell = told(on.get(t.id.as_str()));
        match runs.last_mut() {
            Some((last, n)) if *last == cell => *n += 1,
            _ => runs.push((cell, 1)),
        }
    }
    let run = |(cell, n): (String, usize)| if n == 1 { cell } else { format!("{cell}*{n}") };
    runs.into_iter().map(run).collect::<Vec<_>>().join(" ")
}

fn row(account: &Account, claim: &ClaimAccount, is_large: bool) -> Markup {
    if is_large {
        return html! {
            tr {
                th scope="row" { a href={ "#" (name(claim)) } { (name(claim)) } }
                td.runs colspan=(account.trajectories.len()) { (runs(account, claim)) }
            }
        };
    }
    let on = claim.on_each();
    html! {
        tr {
            th scope="row" { a href={ "#" (name(claim)) } { (name(claim)) } }
            @for t in &account.trajectories {
                @match on.get(t.id.as_str()) {
                    Some(pair) => {
                        td class=(cell(pair)) { (told(Some(pair))) }
                    },
                    None => { td {} },
                }
            }
        }
    }
}

fn legend() -> Markup {
    let all = [
        ("h p", "holds, proved for all values"),
        ("h e", "holds, enclosed at every time"),
        ("h", "holds at all samples"),
        ("h w", "holds, but many altered formulas would, too"),
        ("f", "fails"),
        ("f e", "fails, certified"),
        ("n", "does not apply"),
        ("u", "undecided"),
        ("f x", "not as expected"),
    ];
    html! {
        ul.legend aria-label="Legend" {
            @for (class, text) in all { li { span class={ "mark " (class) } aria-hidden="true" {} " " (text) } }
        }
    }
}

/// Shown by the script, which makes them work, and offers the names of the matrix.
fn filters(account: &Account) -> Markup {
    let verdicts =
        [("h", "holds"), ("f", "fails"), ("n", "does not apply"), ("u", "undecided"), ("x", "not as expected")];
    html! {
        form.filters id="/filters" hidden aria-label="Filters" {
            fieldset {
                legend { "Verdict" }
                @for (value, text) in verdicts {
                    label { input type="checkbox" name="verdict" value=(value); " " (text) }
                }
            }
            label {
                "Claim "
                input type="search" name="claim" list="/claim-names" autocomplete="off" placeholder="part of a name";
            }
            datalist id="/claim-names" { @for c in account.claims.iter().filter(|c| c.results.is_empty()) { option value=(name(c)) {} } }
            label {
                "Motion "
                input type="search" name="trajectory" list="/trajectory-names" autocomplete="off" placeholder="part of a name";
            }
            datalist id="/trajectory-names" {}
            button type="reset" { "Show all" }
            output id="/shown" role="status" {}
        }
    }
}
