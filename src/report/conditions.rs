//! What is said of conditions: which one separates the trajectories of a claim, and which assumptions it needs.

use super::markup::{math, prose};
use super::numbers::count;
use super::tally::name;
use super::text::{Paint, paragraph};
use findings::Account;
use findings::conditions::{AssumptionAccount, ConditionName, ConditionsAccount, Explanation, Need, Rival, Separation};

/// Most trajectories that are named in one line.
const NAMED: usize = 4;

/// How formulas and names are written.
struct Style {
    formula: fn(&str) -> String,
    id: fn(&str) -> String,
    text: fn(&str) -> String,
    /// Conditions of the file by their words, without their ids.
    in_words: bool,
}

const TERMINAL: Style =
    Style { formula: |f| f.to_owned(), id: |i| i.to_owned(), text: |t| t.to_owned(), in_words: false };
const MARKDOWN: Style = Style { formula: math, id: |i| format!("`{i}`"), text: prose, in_words: true };

/// For sentences that every kind of report has.
const DOLLARS: Style =
    Style { formula: |f| format!("${f}$"), id: |i| i.to_owned(), text: |t| t.to_owned(), in_words: true };

/// For the page, which typesets what stands between backticks.
const PAGE: Style =
    Style { formula: |f| format!("`{f}`"), id: |i| i.to_owned(), text: |t| t.to_owned(), in_words: true };

/// The sentences on what separates the trajectories of a claim, formulas between backticks.
pub(super) fn separation_in_words(s: &Separation) -> Vec<String> {
    sentences(s, &PAGE)
}

/// What an assumption is worth, formulas between backticks.
pub(super) fn worth_in_words(a: &AssumptionAccount) -> String {
    worth(a, &PAGE)
}

fn condition(c: &ConditionName, style: &Style) -> String {
    let formula = (style.formula)(&c.formula);
    let text = match (&c.id, &c.says) {
        (Some(_), Some(says)) if style.in_words => format!("{} ({formula})", (style.text)(says)),
        (Some(id), Some(says)) => format!("{} ({}: {formula})", (style.id)(id), (style.text)(says)),
        (_, Some(says)) => format!("{formula} {}", (style.text)(says)),
        (Some(id), None) => format!("{} ({formula})", (style.id)(id)),
        (None, None) => formula,
    };
    if c.negated { format!("not {text}") } else { text }
}

fn explanation(e: &Explanation, style: &Style) -> String {
    let parts: Vec<String> = e.conditions.iter().map(|c| condition(c, style)).collect();
    parts.join(&format!(" {} ", e.join.word()))
}

fn listed(names: &[String], style: &Style) -> String {
    let shown: Vec<String> = names.iter().take(NAMED).map(|n| (style.id)(n)).collect();
    let more = names.len().saturating_sub(NAMED);
    if more > 0 { format!("{} and {more} more", shown.join(", ")) } else { shown.join(", ") }
}

/// A rival, and where it differs.
fn rival(r: &Rival, style: &Style) -> String {
    let name = explanation(&r.explanation, style);
    match r.differ_on.as_slice() {
        [] => name,
        some => format!("{name} (they differ on {}, to which the claim does not apply)", listed(some, style)),
    }
}

/// The sentences on what separates the trajectories of a claim.
fn sentences(s: &Separation, style: &Style) -> Vec<String> {
    let mut out = Vec::new();
    let sides = format!(
        "met on the {} where it holds ({}), unmet on the {} where it fails ({})",
        s.holds.len(),
        listed(&s.holds, style),
        s.fails.len(),
        listed(&s.fails, style)
    );
    let tried = count(s.tried, "condition");
    let tried = format!("{tried} tried, {} that might explain it undecided somewhere", s.undecided);
    match &s.explanation {
        Some(e) => {
            out.push(format!("On the motions tried, it holds just where {}.", explanation(e, style)));
            out.push(format!("This is {sides}; {tried}."));
            if !s.rivals.is_empty() {
                let all: Vec<String> = s.rivals.iter().map(|r| rival(r, style)).collect();
                let more = if s.more_rivals > 0 { format!("; and {} more", s.more_rivals) } else { String::new() };
                out.push(format!(
                    "The motions to which it applies cannot tell this from: {}{more}. To tell them apart takes a \
                     motion that meets the claim's assumptions and only one of the two conditions.",
                    all.join("; ")
                ));
            }
        }
        None => {
            out.push(format!(
                "It holds on {} and fails on {}, and no condition, nor three together, separates them ({tried}).",
                s.holds.len(),
                s.fails.len()
            ));
            let of = |parts: &[(ConditionName, usize)]| -> String {
                parts.iter().map(|(c, n)| format!("{} ({n})", condition(c, style))).collect::<Vec<_>>().join("; ")
            };
            if !s.sufficient.is_empty() {
                out.push(format!("Met only where it holds, and on how many of those: {}.", of(&s.sufficient)));
            }
            if !s.necessary.is_empty() {
                out.push(format!("Met wherever it holds, and on how many where it fails: {}.", of(&s.necessary)));
            }
            if !s.possible.is_empty() {
                let one = |(c, on): &(ConditionName, Vec<String>)| {
                    format!("{} (undecided on {})", condition(c, style), listed(on, style))
                };
                let all: Vec<String> = s.possible.iter().map(one).collect();
                out.push(format!("May be what separates them, as far as it is decided: {}.", all.join("; ")));
            }
        }
    }
    out
}

/// What an assumption is worth, in words.
fn worth(a: &AssumptionAccount, style: &Style) -> String {
    let formula = (style.formula)(&a.text);
    let on = listed(&a.on, style);
    match a.need {
        Need::Needed => format!("{formula} is needed: without it the claim fails on {on}"),
        Need::NotNeeded => {
            format!("{formula} is not needed as far as these motions show: the claim holds on {on} all the same")
        }
        Need::Undecided => {
            format!("whether {formula} is needed is undecided: without it the claim is undecided on {on}")
        }
        Need::Untested => format!("whether {formula} is needed cannot be told: no motion meets the others without it"),
    }
}

/// What separates the trajectories of a claim, in a few words; the sentences say the rest.
fn brief(s: &Separation, style: &Style) -> String {
    let Some(e) = &s.explanation else {
        return format!(
            "holds on {}, fails on {}; no condition, nor three together, separates them",
            s.holds.len(),
            s.fails.len()
        );
    };
    let short = |c: &ConditionName| {
        let text = match (&c.id, &c.says) {
            (Some(id), _) => (style.id)(id),
            (None, Some(says)) => format!("{} {}", (style.formula)(&c.formula), (style.text)(says)),
            (None, None) => (style.formula)(&c.formula),
        };
        if c.negated { format!("not {text}") } else { text }
    };
    let parts: Vec<String> = e.conditions.iter().map(short).collect();
    let rivals = match s.rivals.len() + s.more_rivals {
        0 => String::new(),
        n => format!("; {} as well", fits(n).to_lowercase()),
    };
    format!("on the motions tried, it holds just where {}{rivals}", parts.join(&format!(" {} ", e.join.word())))
}

fn fits(rivals: usize) -> String {
    if rivals == 1 { "One other condition fits".to_owned() } else { format!("{rivals} other conditions fit") }
}

/// For the terminal: a line for every claim that is split, and for every assumption that is not needed.
pub(super) fn terminal(account: &Account, paint: Paint) -> String {
    let mut split = String::new();
    let mut number = 0;
    let mut idle = String::new();
    for claim in &account.claims {
        if let Some(separation) = &claim.conditions.separation {
            number += 1;
            let text = paragraph(&format!("{}: {}", name(claim), brief(separation, &TERMINAL)), 2);
            split.push_str(&text.replacen(&name(claim), &paint.bold(&name(claim)), 1));
        }
        for assumption in claim.conditions.assumptions.iter().filter(|a| a.need == Need::NotNeeded) {
            let on = match assumption.on.as_slice() {
                [one] => one.clone(),
                more => count(more.len(), "motion"),
            };
            let text = format!("{}: {}; it holds without it on {on}", name(claim), assumption.text);
            idle.push_str(&paragraph(&text, 2));
        }
    }
    let mut out = String::new();
    if !split.is_empty() {
        out.push_str(&format!(
            "{} ({number}; rivals and numbers are in the report)\n\n{split}\n",
            paint.bold("Holds on some motions and fails on others")
        ));
    }
    if !idle.is_empty() {
        out.push_str(&format!(
            "{}\n\n{idle}\n",
            paint.bold("Assumptions that are not needed, as far as these motions show")
        ));
    }
    out
}

/// What separates the trajectories of a claim, for its section in `report.md`.
pub(super) fn separation(conditions: &ConditionsAccount) -> String {
    let Some(separation) = &conditions.separation else { return String::new() };
    let all = sentences(separation, &MARKDOWN);
    let rivals = separation.rivals.len() + separation.more_rivals;
    let rivals = if rivals > 0 { format!(" {} as well.", fits(rivals)) } else { String::new() };
    format!("**What separates:** {}{rivals}\n\n", all.first().map(String::as_str).unwrap_or_default())
}

/// An explanation in words, formulas between dollars.
pub(super) fn explanation_in_words(e: &Explanation) -> String {
    explanation(e, &DOLLARS)
}
