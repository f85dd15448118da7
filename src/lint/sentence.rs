//! The words around a display: which equations its sentence names, whether it concludes, approximates or renames.
//!
//! **In:** the source text before and behind a display. **Out:** a [`Sentence`]. **Guaranteed:** words only ever choose which
//! equations a step is tried with, or keep *wrong* from being said; no word makes a formula hold. The tables are short: what is not
//! in them is text.

use std::collections::BTreeSet;
use std::ops::Range;

use diag::next_character;
use paper::{Opening, Paper, PrintedRelation, PrintedSide, is_markdown, opening, squeezed};

use super::headings::headings;
use super::markdown::{without_closing, without_opening};
use super::vocabulary::{AIMS, CHANGES, CONCLUDES, LINKS, LOOSENS, SOLVES, WHERE};

/// The longest text before a display that is looked at, in bytes.
const BEFORE: usize = 500;
/// The longest text behind it.
const BEHIND: usize = 200;

/// What the words around a display say.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Sentence {
    /// Labels, and numbers given with `\tag`, of the equations that the sentence names.
    pub names: Vec<String>,
    /// It concludes from what stands before it.
    pub concludes: bool,
    /// Its equations need not be exact.
    pub loosens: bool,
    /// It gives a name another meaning, or treats another case.
    pub changes: bool,
    /// Its equation is to be solved.
    pub solves: bool,
    /// The name for which an equation before is solved: "solving for $g$".
    pub solved_for: Option<String>,
    /// It says that something is held fixed.
    pub fixes: bool,
    /// It says what is to be shown: nothing follows from that.
    pub aims: bool,
}

impl Sentence {
    /// The sentence of a relation; `earlier` is the place of the display before it.
    pub fn of(paper: &Paper, place: &Range<usize>, earlier: Option<&Range<usize>>) -> Sentence {
        let (file, span) = paper.locate(place);
        let from = match earlier.map(|e| paper.locate(e)) {
            Some((other, e)) if std::sync::Arc::ptr_eq(other, file) && e.end <= span.start => e.end,
            _ => 0,
        };
        let before = window(&file.text, from.max(span.start.saturating_sub(BEFORE)), span.start);
        let behind = window(&file.text, span.end, (span.end + BEHIND).min(file.text.len()));
        let (before, behind) = match is_markdown(&file.path) {
            true => (without_opening(before), without_closing(behind)),
            false => (before, behind),
        };
        let before = uncommented(before.rsplit("\n\n").next().unwrap_or(""));
        let behind = uncommented(behind.split("\n\n").next().unwrap_or(""));
        let lower = before.to_lowercase();
        let last = last_sentence(&lower);
        let words = |text: &'_ str| text.split(|c: char| !c.is_alphabetic()).map(str::to_owned).collect::<Vec<_>>();
        let tail = last.rsplit(['$', ')']).next().unwrap_or_default();
        let loose = |text: &str| LOOSENS.iter().any(|w| text.contains(w));
        Sentence {
            names: named(&before),
            concludes: CONCLUDES.iter().any(|w| last.contains(w)),
            changes: words(&without_for_of_solving(last)).iter().any(|w| CHANGES.contains(&w.as_str()))
                || words(tail).iter().any(|w| LINKS.contains(&w.as_str())),
            aims: AIMS.iter().any(|w| last.contains(w)),
            fixes: ["constant", "fixed", "held"].iter().any(|w| last.contains(w)),
            solves: SOLVES.iter().any(|w| last.contains(w)),
            solved_for: solved_for(last_sentence(&before)),
            loosens: loose(&lower) || loose(&first_sentence(&behind.to_lowercase())),
        }
    }
}

impl Sentence {
    /// The sentence as it is said of a relation that begins with a side: what an equation before is solved for follows from that.
    pub fn of_side(mut self, side: &PrintedSide) -> Sentence {
        if self.solved_for.as_deref() == Some(&squeezed(&side.text)) {
            (self.solves, self.concludes) = (false, true);
        }
        self
    }
}

/// A sentence without the word "for" of "solving for": it opens no case.
fn without_for_of_solving(sentence: &str) -> String {
    let all: Vec<&str> = sentence.split_whitespace().collect();
    let is_of_solving = |at: usize| all[at.saturating_sub(2)..at].iter().any(|w| w.starts_with("solv"));
    let kept = (0..all.len()).filter(|&at| all[at] != "for" || !is_of_solving(at));
    kept.map(|at| all[at]).collect::<Vec<_>>().join(" ")
}

/// What stands between the dollars behind "solve", or a word made of it, and "for".
fn solved_for(sentence: &str) -> Option<String> {
    let (before, name) = sentence.rsplit_once(" for $")?;
    let solves = before.to_lowercase().split_whitespace().rev().take(3).any(|w| w.starts_with("solv"));
    name.split_once('$').filter(|_| solves).map(|(name, _)| squeezed(name))
}

/// Whether a relation of the running text says what a name of the display before it stands for: "where $k=2\pi/\lambda$".
pub fn explains(paper: &Paper, display: &PrintedRelation, relation: &PrintedRelation) -> bool {
    let (file, first) = paper.locate(&display.span());
    let (other, second) = paper.locate(&relation.span());
    if !std::sync::Arc::ptr_eq(file, other) || second.start < first.end || second.start > first.end + BEFORE {
        return false;
    }
    let between = uncommented(window(&file.text, first.end, second.start));
    let own = if is_markdown(&file.path) { without_closing(&between) } else { &between };
    if own.contains("\n\n") {
        return false;
    }
    let words = between.to_lowercase();
    // Up to the first word: the end of the display, and signs.
    let text = words.replace(r"\end{", " \\").replace(r"\]", " ").replace("$$", " ");
    let stops = text.trim_start().starts_with('.');
    if text.trim_start().trim_start_matches('.').contains(". ") {
        return false;
    }
    let all = text.split(|c: char| c.is_whitespace() || matches!(c, ',' | '.' | '}' | '{' | '~' | '*'));
    let ends = ["equation", "align", "gather", "multline", "eqnarray", "displaymath", "split", "aligned", "nonumber"];
    let mut plain = all.filter(|w| {
        let bare = w.trim_start_matches('\\');
        !bare.is_empty() && !ends.contains(&bare) && !w.starts_with('\\')
    });
    // Behind a full stop "With" begins another thought.
    plain.next().is_some_and(|w| WHERE.contains(&w) && !(stops && w == "with")) && !words.contains(" if ")
}

/// Words right before a formula of the running text that make it a case, not a definition, beside those of the table of openings.
const SUPPOSES: &[&str] = &[
    "as",
    "about",
    "around",
    "through",
    "along",
    "unless",
    "until",
    "than",
    "case",
    "condition",
    "limit",
    "from",
    "to",
    "between",
    "only",
    "like",
    "e.g.",
    "choose",
    "choosing",
    "suppose",
    "supposing",
    "assume",
    "take",
    "taking",
    "setting",
    "try",
    "solve",
    "solving",
    "trying",
    "guess",
    "guessing",
    "ansatz",
    "form",
    "putting",
    "consider",
    "pick",
    "say",
    r"\item",
    "not",
    "nicht",
    "pas",
    "con",
    "mit",
    "avec",
    "在",
    "取",
];

/// The word right before a formula of the running text, in small letters.
pub(super) fn word_before(paper: &Paper, relation: &PrintedRelation) -> String {
    let (file, span) = paper.locate(&relation.span());
    let before = uncommented(window(&file.text, span.start.saturating_sub(60), span.start)).to_lowercase();
    let words = before.trim_end_matches(|c: char| c.is_whitespace() || matches!(c, '$' | '(' | '\\' | '~'));
    words.rsplit(|c: char| c.is_whitespace() || c == '~' || c == '(').next().unwrap_or("").to_owned()
}

/// Whether a formula of the running text says when something holds, and not what a name stands for.
pub fn is_supposed(paper: &Paper, relation: &PrintedRelation) -> bool {
    let (file, span) = paper.locate(&relation.span());
    let last = word_before(paper, relation);
    let is_east_asian = |w: &str| w.chars().all(|c| c >= '\u{2e80}');
    relation.is_condition()
        || SUPPOSES.iter().any(|w| last == *w || is_east_asian(w) && last.ends_with(w))
        || is_assumed(paper, relation)
        || is_aside(&file.text, span.start)
        || window(&file.text, span.start.saturating_sub(60), span.start).to_lowercase().contains("compare")
}

/// Whether the sentence of a formula of the running text supposes it.
pub fn is_assumed(paper: &Paper, relation: &PrintedRelation) -> bool {
    let (file, span) = paper.locate(&relation.span());
    opening(&word_before(paper, relation)) == Some(Opening::Case)
        || is_in_supposition(window(&file.text, span.start.saturating_sub(BEFORE), span.start))
}

/// Words with which a sentence supposes something.
const IFS: &[&str] = &["if", "suppose", "wenn", "falls", "si", "supposons", "se", "supponiamo", "supongamos"];

/// Whether what stands before a formula begins a sentence that supposes something, and does not end the supposition: "If we consider the
/// system $x'=y$, $y'=-x$" does so before both formulas, "If $a=b$, then" not.
fn is_in_supposition(before: &str) -> bool {
    let before = uncommented(before);
    let start = before.rfind("\n\n").map_or(0, |at| at + 2);
    let start =
        [". ", ".\n", "? ", "; "].iter().filter_map(|end| before.rfind(end)).fold(start, |all, at| all.max(at + 2));
    // Formulas stand between dollars; the last dollar is that of the formula itself.
    let words: String = before[start..].split('$').step_by(2).collect::<Vec<_>>().join(" ");
    let mut all = words.split_whitespace();
    let begins = all.next().is_some_and(|word| IFS.contains(&word.to_lowercase().as_str()));
    let rest: Vec<&str> = all.collect();
    let ends = rest.iter().position(|word| word.ends_with(',') || *word == "then" || *word == "and");
    begins
        && rest.len() > 1
        && ends.is_none_or(|at| rest[at..].iter().all(|word| !word.chars().any(char::is_alphabetic)))
}

/// Commands whose argument stands beside the text.
const ASIDES: &[&str] = &[
    r"\caption{",
    r"\footnote{",
    r"\marginpar{",
    r"\marginnote{",
    r"\sidenote{",
    r"\todo{",
    r"\footnotetext{",
    r"\node",
    r"\text{",
];
/// Environments beside the text.
const ASIDE: &[&str] = &["tabular", "figure", "quote", "quotation", "table", "wrapfigure", "tikzpicture", "longtable"];

/// Whether a place stands in a caption, a footnote, a table or a figure, or in a parenthesis: what it says is said beside the text.
pub(super) fn is_aside(text: &str, at: usize) -> bool {
    let before = window(text, at.saturating_sub(BEFORE), at);
    let is_open = |from: usize, [open, close]: [char; 2]| {
        let depth: i32 = before[from..].chars().map(|c| i32::from(c == open) - i32::from(c == close)).sum();
        depth > 0
    };
    let command = ASIDES.iter().any(|c| before.rfind(c).is_some_and(|from| is_open(from, ['{', '}'])));
    let environment = ASIDE.iter().any(|e| ends_inside(before, e));
    // "(the ring has $I=mr^2$)"; `\(` opens a formula.
    let line = before.rsplit("\n\n").next().unwrap_or_default();
    let from = before.len() - line.len();
    let parenthesis = line.rfind('(').is_some_and(|k| {
        let words = &line[k + 1..];
        !line[..k].ends_with('\\')
            && !words.contains(')')
            && words.split_whitespace().count() < 12
            && is_open(from + k, ['(', ')'])
            && words.trim_start().starts_with(char::is_alphabetic)
            && !words.trim_start().starts_with("with")
            && !words.trim_start().starts_with("where")
    });
    command || environment || parenthesis
}

/// Whether a text ends inside of an environment whose name begins so.
pub(super) fn ends_inside(text: &str, environment: &str) -> bool {
    let last = |what: &str| text.rfind(&format!("\\{what}{{{environment}"));
    last("begin").is_some_and(|begin| last("end").is_none_or(|end| end < begin))
}

/// Environments whose names are their own.
const OWN_NAMES: &[&str] = &[
    "example",
    "examples",
    "exercise",
    "exercises",
    "problem",
    "question",
    "theorem",
    "lemma",
    "proposition",
    "corollary",
    "remark",
    "definition",
    "ex",
    "exer",
    "thm",
    "prob",
    "task",
    "myexample",
    "exbox",
];
/// Environments that go on from the one before.
const GOES_ON: &[&str] =
    &["solution", "proof", "answer", "sol", "soln", "pf", "beweis", "preuve", "dimostrazione", "demostracion"];

/// For each printed relation the number of the part in which its names mean the same: its section, or an example or a theorem with its
/// solution or proof. What steps a counter of the paper's own begins another one, too.
pub fn parts(paper: &Paper) -> Vec<usize> {
    let mut out = Vec::with_capacity(paper.printed.len());
    // The borders of the file that is looked at.
    let mut known: Option<(std::sync::Arc<diag::Source>, Vec<usize>)> = None;
    for relation in &paper.printed {
        let (file, span) = paper.locate(&relation.span());
        if known.as_ref().is_none_or(|(f, _)| !std::sync::Arc::ptr_eq(f, file)) {
            let mut all = borders(&file.text, &paper.borders.theorems);
            if is_markdown(&file.path) {
                all.extend(headings(&file.text));
                all.sort_unstable();
            }
            known = Some((file.clone(), all));
        }
        let passed = known.as_ref().map_or(0, |(_, b)| b.partition_point(|at| *at <= span.start));
        let numbered = paper.borders.numbered.partition_point(|at| *at <= relation.span().start);
        out.push(relation.section * BORDERS + passed + numbered);
    }
    out
}

/// More borders than that are not told apart.
const BORDERS: usize = 1 << 24;

/// Where environments with names of their own begin and end.
fn borders(text: &str, theorems: &BTreeSet<String>) -> Vec<usize> {
    let mut out = Vec::new();
    for (at, command) in text.match_indices(r"\begin{").chain(text.match_indices(r"\end{")) {
        let name = text[at + command.len()..].split('}').next().unwrap_or("").trim_end_matches('*').to_lowercase();
        let goes_on = |name: &str| GOES_ON.contains(&name);
        let own = OWN_NAMES.contains(&name.as_str()) || theorems.contains(&name) && !goes_on(&name);
        let ends = command == r"\end{" && (own || goes_on(&name));
        // A solution goes on from its example.
        let after = text[at + command.len()..].split_once('}').map_or("", |(_, rest)| rest.trim_start());
        let next = after.strip_prefix(r"\begin{").and_then(|r| r.split('}').next()).unwrap_or("").to_lowercase();
        if command == r"\begin{" && own || ends && !goes_on(&next) {
            out.push(at);
        }
    }
    out.sort_unstable();
    out
}

pub(super) fn window(text: &str, from: usize, to: usize) -> &str {
    text.get(next_character(text, from)..next_character(text, to)).unwrap_or("")
}

/// A text without the comments of LaTeX.
fn uncommented(text: &str) -> String {
    let line = |l: &str| {
        let mut end = l.len();
        for (i, _) in l.match_indices('%') {
            if !l[..i].ends_with('\\') {
                end = i;
                break;
            }
        }
        l[..end].to_owned()
    };
    text.lines().map(line).collect::<Vec<_>>().join("\n")
}

/// What stands behind the last full stop before a capital letter.
fn last_sentence(lower: &str) -> &str {
    let abbreviated = ["eq", "eqs", "fig", "ref", "refs", "sec", "e.g", "i.e", "cf", "eqn", "eqns"];
    let stop = lower.rmatch_indices(". ").find(|(i, _)| {
        let word = lower[..*i].rsplit(|c: char| c.is_whitespace() || c == '(' || c == '~').next().unwrap_or("");
        !abbreviated.contains(&word)
    });
    stop.map_or(lower, |(i, _)| &lower[i + 2..])
}

fn first_sentence(lower: &str) -> String {
    lower.split(". ").next().unwrap_or("").to_owned()
}

/// The labels that a text refers to, and the numbers behind "Eq." or "from".
fn named(text: &str) -> Vec<String> {
    let mut out = Vec::new();
    for command in [r"\eqref{", r"\ref{", r"\cref{", r"\Cref{", r"\autoref{", r"\eqrefs{", r"\Eqref{"] {
        for (i, _) in text.match_indices(command) {
            let inside = text[i + command.len()..].split('}').next().unwrap_or("");
            out.extend(inside.split(',').map(|l| l.trim().to_owned()).filter(|l| !l.is_empty()));
        }
    }
    // "(3)", by hand.
    for (i, _) in text.match_indices('(') {
        let inside = text[i + 1..].split(')').next().unwrap_or("");
        let number = !inside.is_empty()
            && inside.len() <= 6
            && inside.starts_with(|c: char| c.is_ascii_alphanumeric())
            && inside.chars().any(|c| c.is_ascii_digit())
            && inside.chars().all(|c| c.is_ascii_alphanumeric() || matches!(c, '.' | '-'));
        if number {
            out.push(inside.to_owned());
        }
    }
    out.sort();
    out.dedup();
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use diag::Source;

    fn sentence(tex: &str) -> Sentence {
        let paper = paper::parse(Source { path: "p.tex".into(), text: tex.into() }, String::new()).expect("read");
        let shown: Vec<&PrintedRelation> = paper.printed.iter().filter(|r| r.display.is_some()).collect();
        let [.., before, last] = shown.as_slice() else { panic!("two displays") };
        Sentence::of(&paper, &last.span(), Some(&before.span()))
    }

    #[test]
    fn the_words_of_a_sentence_are_found() {
        let found = sentence(r"\[ a=b \] Inserting \eqref{one} into Eq.~(2) we obtain \[ c=d \]");
        assert_eq!(
            found,
            Sentence {
                names: vec!["2".into(), "one".into()],
                concludes: true,
                loosens: false,
                changes: false,
                solves: false,
                solved_for: None,
                fixes: false,
                aims: false
            }
        );
        assert!(sentence(r"\[ a=b \] Neglecting the last term, \[ c=d \]").loosens);
        assert!(sentence(r"\[ a=b \] So we have \[ c=d \] where the constant is absorbed.").loosens);
        assert!(!sentence("\\[ a=b \\] We neglect nothing.\n\nThus % approximately\n\\[ c=d \\]").loosens);
        assert_eq!(sentence(r"\[ a=b/c \] We solve this for $c_1$: \[ c_1=d \]").solved_for.as_deref(), Some("c_1"));
        assert!(!sentence(r"\[ a=b \] Thus it ends. The other one is \[ c=d \]").concludes);
    }

    #[test]
    fn a_supposition_ends_before_what_it_is_for() {
        for (before, wanted) in [
            ("It is so. If we consider the system $", true),
            ("If we consider the system $x'=y$, $", true),
            ("Suppose that a system has $", true),
            ("If we take $a=b$, then $", false),
            ("If we take $a=b$, the energy is $", false),
            ("If we take $a=b$ and solve, $", false),
            ("If it were so. We have $", false),
            ("We ask if it is. Then $", false),
            ("It follows that $", false),
        ] {
            assert_eq!(is_in_supposition(before), wanted, "{before}");
        }
    }

    #[test]
    fn what_stands_behind_where_explains() {
        for (tex, wanted) in [
            (r"\[ a=b \] where $b=2c$", true),
            (r"\begin{equation} a=b, \end{equation} with the width $b=2c$", true),
            ("\\[ a=b \\]\n\nwhere $b=2c$", false),
            (r"\[ a=b \] Then $b=2c$", false),
        ] {
            let paper = paper::parse(Source { path: "p.tex".into(), text: tex.into() }, String::new()).expect("read");
            assert_eq!(explains(&paper, &paper.printed[0], &paper.printed[1]), wanted, "{tex}");
        }
    }
}
