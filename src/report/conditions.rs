//! What is said of conditions: which one separates the trajectories of a claim, and which assumptions it needs.

use super::numbers::count;
use super::story::{StoryBlock, StorySpan, list, prose, strong};
use super::tally::name;
use super::text::capital;
use findings::conditions::{AssumptionAccount, ConditionName, Explanation, Need, Rival, Separation};
use findings::{Account, ClaimAccount};
use latex::Scope;

/// Most trajectories that are named in one line.
const NAMED: usize = 4;

/// A formula in a text.
fn math(formula: &str) -> String {
    format!("${formula}$")
}

fn condition(c: &ConditionName) -> String {
    let formula = math(&c.formula);
    let text = match (&c.id, &c.says) {
        (Some(_), Some(says)) => format!("{says} ({formula})"),
        (None, Some(says)) => format!("{formula} {says}"),
        (Some(id), None) => format!("{id} ({formula})"),
        (None, None) => formula,
    };
    if c.negated { format!("not {text}") } else { text }
}

/// An explanation in words, formulas between dollars.
pub(super) fn explanation(e: &Explanation) -> String {
    let parts: Vec<String> = e.conditions.iter().map(condition).collect();
    parts.join(&format!(" {} ", e.join.word()))
}

fn listed(names: &[String]) -> String {
    let shown: Vec<&str> = names.iter().take(NAMED).map(String::as_str).collect();
    let more = names.len().saturating_sub(NAMED);
    if more > 0 { format!("{} and {more} more", shown.join(", ")) } else { shown.join(", ") }
}

/// A rival, and where it differs.
fn rival(r: &Rival) -> String {
    let name = explanation(&r.explanation);
    match r.differ_on.as_slice() {
        [] => name,
        some => format!("{name} (they differ on {}, to which the claim does not apply)", listed(some)),
    }
}

/// That there are too few motions to tell what separates them.
fn too_few(s: &Separation) -> String {
    let motions = count(s.holds.len() + s.fails.len(), "motion");
    let tried = count(s.tried, "condition");
    format!(
        "it holds on {} and fails on {}: of {tried} that were tried some separate {motions} by accident, and none is told",
        s.holds.len(),
        s.fails.len()
    )
}

/// The sentences on what separates the motions of a claim, formulas between dollars.
pub(super) fn sentences(s: &Separation) -> Vec<String> {
    let mut out = Vec::new();
    let sides = format!(
        "met on the {} where it holds ({}), unmet on the {} where it fails ({})",
        s.holds.len(),
        listed(&s.holds),
        s.fails.len(),
        listed(&s.fails)
    );
    let tried = count(s.tried, "condition");
    let tried = format!("{tried} tried, {} that might explain it undecided somewhere", s.undecided);
    match s.told() {
        None if s.explanation.is_some() => out.push(format!("{}.", capital(&too_few(s)))),
        Some(e) => {
            out.push(format!("On the motions tried, it holds exactly where {}.", explanation(e)));
            out.push(format!("This is {sides}; {tried}."));
            if !s.rivals.is_empty() {
                let all: Vec<String> = s.rivals.iter().map(rival).collect();
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
                parts.iter().map(|(c, n)| format!("{} ({n})", condition(c))).collect::<Vec<_>>().join("; ")
            };
            if !s.sufficient.is_empty() {
                out.push(format!("Met only where it holds, and on how many of those: {}.", of(&s.sufficient)));
            }
            if !s.necessary.is_empty() {
                out.push(format!("Met wherever it holds, and on how many where it fails: {}.", of(&s.necessary)));
            }
            if !s.possible.is_empty() {
                let one =
                    |(c, on): &(ConditionName, Vec<String>)| format!("{} (undecided on {})", condition(c), listed(on));
                let all: Vec<String> = s.possible.iter().map(one).collect();
                out.push(format!("May be what separates them, as far as it is decided: {}.", all.join("; ")));
            }
        }
    }
    out
}

/// What an assumption is worth, formulas between dollars.
pub(super) fn worth(a: &AssumptionAccount) -> String {
    let formula = math(&a.text);
    let on = listed(&a.on);
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
fn brief(s: &Separation) -> String {
    if s.explanation.is_none() {
        return format!(
            "holds on {}, fails on {}; no condition, nor three together, separates them",
            s.holds.len(),
            s.fails.len()
        );
    }
    let Some(e) = s.told() else { return too_few(s) };
    let short = |c: &ConditionName| {
        let text = match (&c.id, &c.says) {
            (Some(id), _) => id.clone(),
            (None, Some(says)) => format!("{} {}", math(&c.formula), says),
            (None, None) => math(&c.formula),
        };
        if c.negated { format!("not {text}") } else { text }
    };
    let parts: Vec<String> = e.conditions.iter().map(short).collect();
    let rivals = match s.rivals.len() + s.more_rivals {
        0 => String::new(),
        n => format!("; {} as well", fits(n).to_lowercase()),
    };
    format!("on the motions tried, it holds exactly where {}{rivals}", parts.join(&format!(" {} ", e.join.word())))
}

fn fits(rivals: usize) -> String {
    if rivals == 1 { "One other condition fits".to_owned() } else { format!("{rivals} other conditions fit") }
}

/// A line for every claim that is split, and for every assumption that is not needed.
pub(super) fn summary<'a>(account: &Account, scope: &'a Scope) -> Vec<StoryBlock<'a>> {
    let line = |claim: &ClaimAccount, text: String| vec![strong(format!("{}: ", name(claim))), prose(text, scope)];
    let (mut split, mut idle) = (Vec::new(), Vec::new());
    for claim in &account.claims {
        split.extend(claim.conditions.separation.as_ref().map(|s| line(claim, brief(s))));
        for assumption in claim.conditions.assumptions.iter().filter(|a| a.need == Need::NotNeeded) {
            let on = match assumption.on.as_slice() {
                [one] => one.clone(),
                more => count(more.len(), "motion"),
            };
            idle.push(line(claim, format!("{}; it holds without it on {on}", math(&assumption.text))));
        }
    }
    let number = split.len();
    let titled = |title: String, lines: Vec<Vec<StorySpan<'a>>>| match lines.as_slice() {
        [] => Vec::new(),
        _ => vec![StoryBlock::Heading(title), list(lines)],
    };
    let title = format!("Holds on some motions and fails on others ({number}; rivals and numbers are in the report)");
    let mut out = titled(title, split);
    out.extend(titled("Assumptions that are not needed, as far as these motions show".to_owned(), idle));
    out
}
