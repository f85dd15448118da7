//! Standing: whether a relation is stated, says when another one holds, or holds only then.
//!
//! **In:** the relations of a paper, with the words before and behind them. **Out:** a [`Standing`] for each. **Guaranteed:** an equation that
//! stands beside a case, "if x = y", before or behind it, in one row of a display or one sentence, is stated nowhere else; nor is the case.

use std::collections::BTreeMap;
use std::ops::Range;

use paper::{Call, Opening, Paper, PrintedRelation, PrintedSide, names, opening};

use super::lone::lone_name;
use super::sentence::word_before;
use super::signs::{COMPARES, EQUALS, is_about, is_one_of};

/// Relations before one of which a case in the same sentence may be.
const BEFORE: usize = 3;
/// The longest text between a case and what holds in it.
const LONGEST: usize = 240;

/// How a relation is said.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Standing {
    /// By itself: others may rest on it.
    Stated,
    /// It says when another one holds, or what is meant.
    Condition,
    /// It holds only where the condition beside it does.
    Conditional,
}

/// The standing of each relation of a paper.
pub(super) fn standings(paper: &Paper) -> Vec<Standing> {
    let all = &paper.printed;
    let mut out: Vec<Standing> = all.iter().map(own).collect();
    let mut displays: BTreeMap<usize, Range<usize>> = BTreeMap::new();
    for (at, display) in all.iter().enumerate().filter_map(|(at, r)| r.display.map(|d| (at, d))) {
        displays.entry(display).or_insert(at..at).end = at + 1;
    }
    for range in displays.into_values() {
        under_cases_of_display(all, range, &mut out);
    }
    for (at, standing) in out.iter_mut().enumerate() {
        if *standing == Standing::Stated && is_in_case_of_sentence(paper, at) {
            *standing = Standing::Conditional;
        }
    }
    out
}

/// The standing that the words right before a relation give it.
fn own(relation: &PrintedRelation) -> Standing {
    match relation.opening {
        None if relation.remark.as_deref().and_then(opening) == Some(Opening::Otherwise) => Standing::Conditional,
        None | Some(Opening::Link) => Standing::Stated,
        Some(Opening::Meaning) if gives_meaning(relation) => Standing::Stated,
        Some(Opening::Case | Opening::Remark | Opening::Meaning) => Standing::Condition,
        Some(Opening::Otherwise) => Standing::Conditional,
    }
}

/// Whether a relation says what a name stands for: not which value it has, or that it is another one.
fn gives_meaning(relation: &PrintedRelation) -> bool {
    let [left, right] = relation.sides.as_slice() else { return false };
    is_one_of(EQUALS, &relation.signs[0])
        && lone_name(left).is_some()
        && lone_name(right).is_none()
        && !names(right).is_empty()
        && !right.is_list
}

/// Whether a relation is one that holds at some values only: an equation, or a limit, and no range or list of values.
pub(super) fn is_equation(relation: &PrintedRelation) -> bool {
    let dots = [r"\dots", r"\ldots", r"\cdots", "…", "..."];
    let is_list = |s: &PrintedSide| s.is_list || dots.iter().any(|d| s.text.contains(d));
    let limits = [r"\to", r"\rightarrow", r"\longrightarrow"];
    relation.sides.len() > 1
        && !relation.sides.iter().any(is_list)
        && relation.signs.iter().any(|s| is_one_of(EQUALS, s) || is_about(s) || limits.contains(&s.as_str()))
}

/// Whether a relation of a display is a case for those beside it.
fn is_case(relation: &PrintedRelation) -> bool {
    let is_value = || {
        lone_name(&relation.sides[0]).is_some()
            && relation.sides.last().is_some_and(|s| names(s).is_empty() || lone_name(s).is_some())
    };
    is_equation(relation)
        && match relation.opening {
            Some(Opening::Case) => true,
            Some(Opening::Remark) => !relation.signs.iter().any(|s| is_one_of(EQUALS, s)),
            Some(Opening::Meaning) => is_value(),
            Some(Opening::Otherwise | Opening::Link) | None => false,
        }
}

/// Marks what holds only in the cases of a display.
fn under_cases_of_display(all: &[PrintedRelation], range: Range<usize>, out: &mut [Standing]) {
    let relates = |at: &usize| all[*at].sides.len() > 1;
    // A case before everything is one of all rows, up to the next one.
    let leads = range.clone().find(relates).filter(|&at| is_case(&all[at]));
    let mut leading = leads.is_some();
    for at in range.clone().filter(relates) {
        leading &= Some(at) == leads || all[at].opening != Some(Opening::Case);
        if out[at] != Standing::Stated {
            continue;
        }
        let mut beside = range.clone().filter(|&k| k != at && all[k].row == all[at].row);
        let in_range = || {
            let is_range =
                |k: usize| all[k].opening == Some(Opening::Case) && all[k].signs.iter().any(|s| is_one_of(COMPARES, s));
            let own = |k: usize| all[k].row == all[at].row && is_range(k);
            let again = |k: usize| {
                k != at && out[k] != Standing::Condition && all[k].sides[0].print() == all[at].sides[0].print()
            };
            range.clone().any(own) && range.clone().any(again)
        };
        if leading || beside.any(|k| is_case(&all[k])) || in_range() {
            out[at] = Standing::Conditional;
        }
    }
}

/// The text between two relations of one file, where it is short and no sentence ends in it.
fn between(paper: &Paper, first: usize, second: usize) -> Option<&str> {
    let ((file, from), (other, to)) =
        (paper.locate(&paper.printed[first].span()), paper.locate(&paper.printed[second].span()));
    let text =
        file.text.get(from.end..to.start).filter(|t| std::sync::Arc::ptr_eq(file, other) && t.len() < LONGEST)?;
    let stops = [". ", ".\n", ".$", r".\]", r".\)", r".\end", "\n\n", "? ", "。", r"\item", r"\\ \\"];
    (!stops.iter().any(|s| text.contains(s))).then_some(text)
}

/// Whether a formula of the running text is a case: "for $x=y$".
fn is_case_in_text(paper: &Paper, at: usize) -> bool {
    let relation = &paper.printed[at];
    relation.display.is_none()
        && is_equation(relation)
        && (relation.opening == Some(Opening::Case) || opening(&word_before(paper, relation)) == Some(Opening::Case))
}

/// Whether a relation stands in one sentence with a case of the running text: right behind it, "$a=b$ if $c=d$", or some way before it.
fn is_in_case_of_sentence(paper: &Paper, at: usize) -> bool {
    let behind = (at + 1 < paper.printed.len()).then(|| between(paper, at, at + 1)).flatten();
    let follows = behind.is_some_and(|text| {
        let text = text.replace(r"\end{", " ");
        let mut words = text
            .split(|c: char| {
                c.is_whitespace() || matches!(c, '$' | '~' | ',' | '{' | '}' | '(' | ')' | '[' | ']' | '\\')
            })
            .filter(|w| w.chars().any(char::is_alphabetic))
            .filter(|w| !LAYOUT.contains(w));
        let few = words.clone().count() < 5;
        few && words.next().is_some_and(|w| opening(w) == Some(Opening::Case))
    });
    if follows && is_case_in_text(paper, at + 1) {
        return true;
    }
    // "At $x=3$ the function $f(x)=\ldots$": it is the same elsewhere.
    let is_function = lone_name(&paper.printed[at].sides[0]).is_some_and(|n| n.call != Call::None);
    !is_function
        && (at.saturating_sub(BEFORE)..at).rev().any(|k| is_case_in_text(paper, k) && between(paper, k, at).is_some())
}

/// Words of LaTeX between a formula and the words behind it.
const LAYOUT: &[&str] = &[
    "equation",
    "equation*",
    "align",
    "align*",
    "aligned",
    "gather",
    "gather*",
    "multline",
    "displaymath",
    "text",
    "quad",
    "qquad",
    "mbox",
    "hbox",
    "textrm",
    "mathrm",
    "nonumber",
    "notag",
    "noindent",
];
