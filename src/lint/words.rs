//! Words with which a text takes back the formula beside them: it denies, supposes, poses, restricts it, or makes it inexact.
//!
//! **In:** the text of a file, and the place of a formula or a display in it. **Out:** whether the words of its sentence, or words that are printed
//! in its row, do so. **Guaranteed:** words only keep *wrong* from being said. A word counts where it begins like one of the tables; formulas
//! and commands are no words.

use std::ops::Range;

use diag::next_character;

use super::markdown::{without_closing, without_opening};

use super::vocabulary::*;

/// The longest text before a formula that is looked at, and behind it.
const BEFORE: usize = 400;
const BEHIND: usize = 200;
/// Words right behind a formula that may restrict it.
const RIGHT_BEHIND: usize = 8;

/// What the words of a sentence do with the formula that stands in it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Taken {
    /// They deny it, suppose it, pose or restrict it.
    pub back: bool,
    /// They deny it, or say it of others.
    pub denied: bool,
    /// They make it inexact, or say that its letters are no numbers.
    pub loosely: bool,
}

/// What the words of the sentence around a place do with what stands there; in a display the sentence goes on over blank lines.
pub(super) fn taken(text: &str, place: &Range<usize>, is_display: bool) -> Taken {
    let near = |at: usize| next_character(text, at.min(text.len()));
    let (from, to) = (near(place.start), near(place.end));
    let before = text.get(near(from.saturating_sub(BEFORE))..from).unwrap_or_default();
    let behind = text.get(to..near(to + BEHIND)).unwrap_or_default();
    let before = if is_display { without_opening(before) } else { before };
    let (behind, is_ended) = if is_display { behind_display(behind) } else { behind_formula(behind) };
    let before = last_sentence(before);
    let is_perpendicular = before.contains(r"\perp");
    let posed = words(behind_conclusion(before));
    let before = words(before);
    let (first, next) = sentences(behind);
    let raw = if is_ended { "" } else { first };
    let (own, next) = (words(raw), words(if is_ended { first } else { next }));
    let right_behind: String = own.split_inclusive(' ').take(RIGHT_BEHIND + 1).collect();
    let begins = |all: &str| entries(all).any(|w| own.trim_start().starts_with(w));
    // "This is wrong." behind the full stop.
    let is_of_it = entries(LINKING).any(|w| next.trim_start().starts_with(w));
    let denied = [&before, &own].iter().any(|text| has_word(text, DENY))
        || denies_at_end(&before)
        || is_of_it && (has_word(&next, DENY) || next.contains(" not ") || next.contains("n't "));
    let back = denied
        || [&posed, &own].iter().any(|text| has_word(text, SUPPOSE) || has_condition(text))
        || supposes_case(&before)
        || is_of_place(&before)
        || is_posed(&before)
        || chooses(&before)
        || has_word(&right_behind, RESTRICT_ANYWHERE)
        || begins(RESTRICT)
        || begins(RESTRICT_ANYWHERE)
        || begins(SUBJECT)
        || raw.trim_start().starts_with("as $");
    let is_loose =
        |text: &String| has_word(text, LOOSEN) || LOOSENS.iter().any(|w| text.contains(w)) || has_order(text);
    Taken { back, denied, loosely: is_perpendicular || is_loose(&before) || is_loose(&own) || raw.contains("a.e.") }
}

/// Whether the words before a display say what stands in it, by the last of them: "we get", "so that", "we use the identity"; and where no word
/// leads to it. What is denied, or said of others, has many words of its own; those that say something are few.
pub(super) fn asserts(text: &str, from: usize) -> bool {
    let from = next_character(text, from.min(text.len()));
    let before = text.get(next_character(text, from.saturating_sub(BEFORE))..from).unwrap_or_default();
    let before = without_opening(before);
    let own = before.trim_end();
    if own.strip_suffix(['.', '?', '!']).is_some_and(|rest| !is_abbreviated(rest)) {
        return true;
    }
    let before = last_sentence(before);
    // What an earlier display of the sentence led to is said.
    let closes = [r"\]", "$$"].iter().filter_map(|c| before.rfind(c).map(|at| at + c.len()));
    // Behind the marks of a fence stands what it is of.
    let fence = before.rfind("```").and_then(|at| Some(at + before[at..].find('\n')?));
    let closes = closes.chain(fence);
    let ends = before.rfind(r"\end{").and_then(|at| Some(at + before[at..].find('}')? + 1));
    let before = &before[closes.chain(ends).max().unwrap_or_default()..];
    let said = words(&without_arguments(before));
    let all: Vec<&str> = said.split_whitespace().filter(|w| w.chars().any(char::is_alphabetic)).collect();
    let is_one_of = |word: &str, list: &str| entries(list).any(|w| w == word);
    // "Expanding the square", "since x is real": who reckons says what comes of it.
    let reckons = |w: &&str| entries(ACTS).any(|act| w.starts_with(act.trim_end())) || is_one_of(w, REASONS);
    if all.first().is_some_and(reckons) {
        return true;
    }
    let mut rest = all.iter().rev().copied();
    match rest.next() {
        None => true,
        Some("that" | "dass" | "daß" | "que" | "che") => rest.next().is_none_or(|w| is_one_of(w, SAYS_THAT)),
        Some(last) if is_one_of(last, ASSERTED) => {
            rest.find(|w| !is_one_of(w, OF_THESE)).is_none_or(|w| is_one_of(w, USES))
        }
        // A letter names something, and a number an equation.
        Some(last) => last.chars().count() == 1 || is_one_of(last, ASSERTING),
    }
}

/// A text without the formulas between its dollars, and without the names of environments and other arguments that are no words.
fn without_arguments(text: &str) -> String {
    let text: String = text.split('$').step_by(2).collect::<Vec<_>>().join(" x ");
    let mut out = String::new();
    // Marks of a page in HTML are no words either.
    let shown = text
        .split('<')
        .enumerate()
        .map(|(k, part)| if k == 0 { part } else { part.split_once('>').map_or(part, |p| p.1) });
    let text = shown.collect::<String>();
    let mut rest = text.as_str();
    while let Some(at) = rest.find('\\') {
        out.push_str(&rest[..at]);
        rest = &rest[at + 1..];
        let name = rest.chars().take_while(char::is_ascii_alphabetic).count();
        let is_text =
            matches!(&rest[..name], "emph" | "textbf" | "textit" | "textsl" | "text" | "textrm" | "em" | "it" | "bf");
        rest = &rest[name..];
        let group = rest.starts_with('{') && !is_text;
        // A group that is still open holds the formula itself.
        if let Some(end) = rest.find('}').filter(|_| group) {
            rest = &rest[end + 1..];
        }
        out.push(' ');
    }
    out + rest
}

/// What stands behind the last formula of a sentence where words there conclude from that: what was said of it is not said of what follows.
fn behind_conclusion(before: &str) -> &str {
    let own = before.trim_end_matches(|c: char| c.is_whitespace() || matches!(c, '$' | '(' | '\\'));
    let closes = ["$", r"\)", r"\]", r"\end{"].iter().filter_map(|close| own.rfind(close)).max();
    let behind = closes.map(|at| &before[at..]).filter(|_| !chooses(&words(before)));
    behind.filter(|rest| has_word(&words(rest), CONCLUDE)).unwrap_or(before)
}

/// Whether a text speaks of several things, or of another one: "the second train", and not "both sides".
pub(super) fn of_several(text: &str) -> bool {
    let said = words(text);
    let is_free = |at: usize, word: &str| {
        let behind = said[at + word.len()..].trim_start();
        said[..at].ends_with(' ')
            && !entries(OF_FORMULAS).any(|w| behind.starts_with(w))
            && !said[..at].ends_with("on the ")
    };
    entries(SEVERAL).any(|word| said.match_indices(word).any(|(at, _)| is_free(at, word)))
}

/// Whether each sentence of a text goes on with what was spoken of: "hence", "we get", "its rate". "Neutrons have" speaks of something else.
pub(super) fn goes_on(text: &str) -> bool {
    let text = without_arguments(text);
    let mut sentences = text.split(". ").flat_map(|s| s.split(".\n")).flat_map(|s| s.split("? ")).map(words);
    sentences.all(|said| {
        let mut all = said.split_whitespace().filter(|w| w.chars().any(char::is_alphabetic) && w.chars().count() > 1);
        let is_one_of = |word: &str, list: &str| entries(list).any(|w| w == word);
        let Some(first) = all.next() else { return true };
        let reckons = |w: &str| entries(ACTS).any(|act| w.starts_with(act.trim_end())) || is_one_of(w, GOES_ON);
        let is_of_these = |w: &str| is_one_of(w, OF_THESE);
        reckons(first) || is_of_these(first) && all.find(|w| !is_of_these(w)).is_none_or(|w| is_one_of(w, OPERATIONS))
    })
}

/// Whether all words of a text reckon and conclude, and those between them; the subject of a sentence may have two words of its own, "the escape
/// velocity is".
pub(super) fn only_reckons(text: &str) -> bool {
    let (mut plain, mut depth) = (String::new(), 0_i32);
    let mut all = text.chars().peekable();
    while let Some(c) = all.next() {
        match c {
            '\\' => while all.next_if(char::is_ascii_alphabetic).is_some() {},
            '{' => depth += 1,
            '}' => depth -= 1,
            c if depth == 0 => plain.push(c),
            _ => {}
        }
        if !matches!(c, '{' | '}') && depth > 0 {
            plain.push(' ');
        }
    }
    let said = words(&plain);
    // Letters are formulas.
    let all: Vec<&str> = said.split_whitespace().filter(|w| w.chars().count() > 1).collect();
    let is_known = |w: &str| entries(RECKONING).any(|known| known == w) || !w.chars().any(char::is_alphabetic);
    let is_of_subject = |at: usize| {
        let begins = (1..=2).filter_map(|n| at.checked_sub(n)).find(|&k| is_known(all[k]));
        let ends = (at + 1..=at + 2).find(|&k| all.get(k).is_none_or(|w| is_known(w)));
        begins.is_some_and(|k| matches!(all[k], "the" | "its"))
            && ends.is_some_and(|k| all.get(k).is_some_and(|w| matches!(*w, "is" | "are" | "becomes" | "reads")))
    };
    (0..all.len()).all(|at| is_known(all[at]) || is_of_subject(at))
}

/// Whether words that are printed in a row take back what stands beside them.
pub(super) fn take_back_in_row(remark: &str) -> bool {
    let said = words(remark);
    let has = |all: &str| has_word(&said, all);
    has(DENY) || has(SUPPOSE) || has(LOOSEN) || has_order(&said) || has(RESTRICT_ANYWHERE) || {
        remark.contains("a.e.")
            || remark.contains(['?', '!'])
            || said.split(' ').any(|w| matches!(w, "not" | "nicht" | "pas" | "non"))
            || ["on ", "in ", "at ", "near "].iter().any(|w| said.trim_start().starts_with(w))
    }
}

/// The words of a table.
fn entries(table: &str) -> impl Iterator<Item = &str> {
    table.split(';').map(str::trim_start)
}

/// Whether a word of a list begins somewhere among words.
fn has_word(words: &str, list: &str) -> bool {
    entries(list).any(|w| words.match_indices(w).any(|(at, _)| words[..at].ends_with(' ')))
}

/// A text as its words, in small letters, with one space between them and around; commands are none, formulas between dollars are one sign.
fn words(text: &str) -> String {
    let mut out = String::from(" ");
    let mut all = text.chars().peekable();
    while let Some(c) = all.next() {
        if c == '\\' {
            while all.next_if(|c| c.is_ascii_alphabetic()).is_some() {}
        } else if c == '%' {
            // A comment.
            while all.next_if(|c| *c != '\n').is_some() {}
        } else if c.is_alphanumeric() || c == '\'' {
            out.extend(c.to_lowercase());
            continue;
        } else if c == ',' || c == ':' {
            out.push_str(if out.ends_with(' ') { ", " } else { " , " });
            continue;
        }
        if !out.ends_with(' ') {
            out.push(' ');
        }
    }
    if !out.ends_with(' ') {
        out.push(' ');
    }
    // Signs of punctuation part phrases, and are no words.
    out
}

/// Where sentences end, beside full stops.
const STOPS: &[&str] = &[
    ". ", ".\n", ".\r", "? ", "?\n", "! ", "!\n", "\n\n", "\n\r\n", ".$", r".\]", r".\)", r".\end", "。", r"\item",
    r"\par ",
];

fn is_abbreviated(before: &str) -> bool {
    let word = before.rsplit(|c: char| c.is_whitespace() || matches!(c, '(' | '~')).next().unwrap_or_default();
    entries(ABBREVIATED).any(|w| w == word.to_lowercase())
}

/// What stands behind the last full stop.
fn last_sentence(text: &str) -> &str {
    let stop = |w: &&str| {
        let ends = |at: &usize| w.starts_with('.') && is_abbreviated(&text[..*at]);
        text.rmatch_indices(*w).map(|(at, _)| at).find(|at| !ends(at)).map(|at| at + w.len())
    };
    let from = STOPS.iter().filter_map(stop).max().unwrap_or_default();
    &text[from..]
}

/// The text up to the first full stop, and that from there to the next.
fn sentences(text: &str) -> (&str, &str) {
    let end = |text: &str| {
        let stop = |w: &&str| {
            let ends = |at: &usize| w.starts_with('.') && is_abbreviated(&text[..*at]);
            text.match_indices(*w).map(|(at, _)| at).find(|at| !ends(at)).map(|at| (at, at + w.len()))
        };
        STOPS.iter().filter_map(stop).min().unwrap_or((text.len(), text.len()))
    };
    let (stop, behind) = end(text);
    let rest = &text[behind..];
    (&text[..stop], &rest[..end(rest).0])
}

/// What stands behind the display whose last formula ends at the beginning of a text, and whether a full stop ended its sentence.
fn behind_display(text: &str) -> (&str, bool) {
    let rest = without_closing(text);
    let closing = &text[..text.len() - rest.len()];
    (rest, closing.split("\n\n").next().is_some_and(ends))
}

/// The same of a formula in the running text.
fn behind_formula(text: &str) -> (&str, bool) {
    let line = text.split("\n\n").next().unwrap_or_default();
    let close = [line.find('$').map(|at| at + 1), line.find(r"\)").map(|at| at + 2)];
    match close.into_iter().flatten().min() {
        Some(at) => (&text[at..], ends(&text[..at])),
        None => (text, false),
    }
}

/// Whether a full stop stands in what closes a formula.
fn ends(closing: &str) -> bool {
    let bytes = closing.as_bytes();
    let is_stop = |at: usize| bytes[at] == b'.' && !bytes.get(at + 1).is_some_and(u8::is_ascii_digit);
    (0..bytes.len()).any(is_stop) && !closing.contains(r"\right.") && !closing.contains("...")
}

/// Whether a condition is named that is none at the beginning or the border: these are inserted.
fn has_condition(words: &str) -> bool {
    words
        .match_indices(" condition")
        .any(|(at, _)| !["initial", "boundary", "these"].iter().any(|w| words[..at].ends_with(w)))
}

/// Whether the order up to which something holds is named: "to second order", and not "in order to".
fn has_order(words: &str) -> bool {
    ["order ", "orders "].iter().any(|w| {
        words.match_indices(&format!(" {w}")).any(|(at, _)| {
            let before: Vec<&str> = words[..at].split_whitespace().rev().take(3).collect();
            let behind = words[at + w.len() + 1..].trim_start();
            before
                .iter()
                .any(|w| matches!(*w, "to" | "at" | "of" | "up" | "through" | "first" | "second" | "third" | "linear"))
                || behind.starts_with("of ")
                || behind.starts_with("in ") && before.first() != Some(&"in")
        })
    })
}

/// Whether a sentence supposes a case that is no act of reckoning: "the forces balance when", "if the two are far apart, then".
fn supposes_case(before: &str) -> bool {
    let is_if = |w: &str| before.rfind(&format!(" {w} ")).map(|at| at + w.len() + 1);
    let found = entries(IFS).filter_map(is_if).max();
    let begins = |w: &str| before.trim_start().starts_with(w);
    let found = found.or_else(|| ["si ", "se "].iter().any(|w| begins(w)).then_some(3));
    let ends_with = [" where ", " wo ", " où ", " dove ", " donde "].iter().any(|w| before.ends_with(w));
    ends_with
        || found.is_some_and(|at| {
            let clause = before[at..].split(" , ").next().unwrap_or_default();
            let clause = clause.split(" then ").next().unwrap_or_default();
            let by_somebody = [" we ", " one ", " you ", " wir ", " man "].iter().any(|w| clause.contains(w));
            let is_participle = clause.split_whitespace().next().is_some_and(|w| w.ends_with("ing"));
            !((by_somebody || is_participle) && has_word(clause, ACTS))
        })
}

/// Whether a sentence begins with a place: "On the boundary".
fn is_of_place(before: &str) -> bool {
    let mut all = before.split_whitespace();
    let first = all.next().unwrap_or_default();
    let next: Vec<&str> = all.take(4).collect();
    let next = format!(" {} ", next.join(" "));
    entries(PLACES).any(|w| w == first)
        && next.split_whitespace().any(|w| w.chars().count() > 2)
        && !entries(NO_PLACES).any(|w| next.contains(&format!(" {w} ")))
}

/// Whether a sentence leads to its formula as to a set of points, or an equation: "on the plane", but not "this gives the equation".
fn is_posed(before: &str) -> bool {
    let last = before.split_whitespace().rev().find(|w| w.chars().count() > 1).unwrap_or_default();
    let is_right_before = !before.trim_end().ends_with(',');
    (entries(POSED).any(|w| w == last) || is_right_before && entries(POSING).any(|w| w == last))
        && !has_word(before, CONCLUDE)
}

/// Whether a sentence asks for what something has to be: "choose $y$ so that" concludes nothing. What is used "to determine" something is reckoned.
fn chooses(words: &str) -> bool {
    let determines = words.match_indices(" determine ").any(|(at, _)| !words[..at].ends_with(" to"));
    determines || has_word(words, "choose ; pick ; adjust ; tune ; fix ")
}

/// Whether words that deny stand in the last part of a sentence, before its formula.
fn denies_at_end(before: &str) -> bool {
    let tail = before.rsplit(" , ").find(|part| !part.trim().is_empty()).unwrap_or_default();
    let last: Vec<&str> = tail.split_whitespace().rev().take(4).collect();
    let denies = |w: &str| matches!(w, "not" | "no" | "nor" | "nicht" | "kein" | "pas" | "non") || w.ends_with("n't");
    last.into_iter().any(denies)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn are_taken_back(texts: &[&str], wanted: bool) {
        for text in texts {
            let at = text.find('@').expect("a place");
            let found = taken(text, &(at..at + 1), text.contains(r"\["));
            assert_eq!(found.back || found.loosely, wanted, "{text}");
        }
    }

    #[test]
    fn words_that_deny_suppose_or_loosen_are_heard() {
        are_taken_back(
            &[
                r"Suppose \[@\]",
                "Suppose\n\n\\[\n@\n\\]",
                r"Students write \[@.\]",
                r"There is no $y\neq0$ with $@$.",
                "Here $@$ cannot be true.",
                "Here\n\n\\[@\\]\n\ndoes not hold.",
                r"We have \[@.\] This is not so.",
                r"\[@\] when $y$ is small.",
                r"If the two are far apart, \[@\]",
                r"To second order, \[@\]",
                r"On the boundary \[@\]",
                r"They agree where \[@\]",
            ],
            true,
        );
    }

    #[test]
    fn words_that_go_on_take_nothing_back() {
        are_taken_back(
            &[
                r"Then \[@\]",
                r"Suppose so. Then \[@\]",
                r"If we square this, we get \[@\]",
                r"In order to see it, expand: \[@\]",
                r"On the left hand side we have \[@\]",
                r"It does not depend on it, so \[@\]",
                r"Inserting Eq. (3) gives \[@\] where $k$ is the wave number.",
                "We have $@$, and not much follows.",
                r"We have \[@.\] The next is wrong.",
                r"For $x>0$, \[@\]",
                r"They obey $a=b$, so that \[@\]",
            ],
            false,
        );
    }

    #[test]
    fn words_in_a_row_are_heard() {
        for words in ["not:", "Suppose", "(?)", "(modulo 4)", "on", "a.e.", "!", "if"] {
            assert!(take_back_in_row(words), "{words}");
        }
        for words in ["and", "so", "hence", "(3)", "⇒", "where", "for"] {
            assert!(!take_back_in_row(words), "{words}");
        }
    }
}
