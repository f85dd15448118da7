//! Words with which a text takes back the formula beside them: it denies, supposes, poses, restricts it, or makes it inexact.
//!
//! **In:** the text of a file, and the place of a formula or a display in it. **Out:** whether the words of its sentence, or words that are printed
//! in its row, do so. **Guaranteed:** words only keep *wrong* from being said. A word counts where it begins like one of the tables; formulas
//! and commands are no words.

use std::ops::Range;

use diag::next_character;

use super::markdown::{without_closing, without_opening};

/// The longest text before a formula that is looked at, and behind it.
const BEFORE: usize = 400;
const BEHIND: usize = 200;
/// Words right behind a formula that may restrict it.
const RIGHT_BEHIND: usize = 8;

/// Words that deny: of others, of an older version, or outright.
const DENY: &[&str] = &[
    "instead of", "rather than", "contrary", "contradict", "unlike", "as opposed", "cannot", "can not ", "can't", "impossib", "untrue",
    "not true", "is false", "are false", "false ", "wrong", "incorrect", "erroneous", "mistak", "fallac", "absurd", "nonsense", "no longer",
    "never", "neither", "violat", "fails", "fail ", "failed", "breaks down", "break down", "not hold", "not valid", "not equal", "not the case",
    "not in general", "not satisf", "nobody", "no one ", "few believe", "there is no ", "there are no ", "there isn't", "would", "student",
    "beginner", "author", "claim", "believ", "it is said", "they write", "people write", "often written", "sometimes written", "erratum",
    "errata", "corrig", "misprint", "typo ", "typos", "typographical", "should read", "should be", "should have", "version", "used to read",
    "used to be", "anstatt", "statt ", "behaupte", "gilt nicht", "gelten nicht", "fehler", "falsch", "niemand", "wäre", "au lieu", "erreur",
    "faux", "n'est pas", "prétend", "invece di", "errore", "falso", "nessuno", "en lugar", "en vez", "nadie",
];

/// Words that suppose, or pose what is to be solved or demanded.
const SUPPOSE: &[&str] = &[
    "suppos", "assum", "presum", "hypothe", "conject", "ansatz", "postulat", "imagin", "pretend", "might", "perhaps", "tempt", "naiv",
    "guess", "we expect", "one expects", "we hope", "we want", "we wish", "trial", "seek", "look for", "looking for", "search for",
    "searching for", "such that", "there exist", "for some ", "were true", "were the case", "were to hold",
    "it were", "condition for", "condition that", "condition is", "condition of", "the condition ", "conditions for", "criterion", "criteria", "constrain", "require", "demand", "impose", "imposing", "enforc", "must ", "equality of",
    "be equal", "are equal", "set equal", "set both", "both equal", "equal to each other", "equate ", "equates", "equating", "equated",
    "balanc", "equilib", "stationar", "vanish", "resonan", "satisf", "obey", "fulfil", "is solved", "are solved", "solutions", "coincid",
    "intersect", "meet ", "meets ", "crosses", "cross at", "cross where", "cross when", "cross if", "they cross", "two cross", "curves cross",
    "lines cross", "cross each", "equidistant", "same distance", "equal distance", "locus", "loci", "curve", "the set of", "the line ",
    "the plane ", "the surface", "the circle", "the sphere", "the points", "points ", "point where", "points where", "unless", "provided",
    "as long as", "in case ", "only if", "only when", "only for", "only where", "only at", "only in", "holds for", "hold for", "holds in",
    "holds on", "holds at", "holds only", "holds if", "holds when", "for which", "at which", "where both", "angenommen", "annahme",
    "nehmen wir an", "bedingung", "fordern", "verlang", "gleichgewicht", "erfüll", "gesucht", "supposons", "hypoth", "condizione",
    "équilibre", "exige", "satisf", "supponiamo", "ipotesi", "equilibrio", "richied", "imponiamo", "supongamos", "condición", "exig",
];

/// Words that make a formula inexact, or say that its letters are no numbers, or that another one is meant with something changed.
const LOOSEN: &[&str] = &[
    "up to ", "roughly", "nearly", "almost", "small", "tiny", "negligib", "weak", "modulo", "mod ", "limit", "leading", "lowest", "estimat",
    "crude", "in the mean", "average", "expectation", "rounded", "far away", "far from", "grassmann", "anticommut", "anti commut",
    "commut", "clifford", "quaternion", "nilpotent", "idempotent", "fermion", "orthogonal", "orthonormal", "perpendicular", "right angle",
    "uncorrelated", "incoheren", "disjoint", "boolean", "characteristic", "tropical", "replac", "interchang", "exchang", "swap",
    "opposite sign", "other sign", "sign flip", "bis auf", "näherung", "senkrecht", "ordnung", "ersetz", "petit", "à l'ordre", "ordre",
    "remplaç", "piccol", "ordine", "sostitu", "pequeñ", "orden",
];

/// Words that restrict what stands before them, right behind a formula.
const RESTRICT: &[&str] = &[
    "if ", "iff ", "when ", "whenever", "unless", "provided", "assuming", "as long", "only", "except", "modulo", "mod ", "near ", "along",
    "inside", "outside", "within ", "on ", "at ", "wenn ", "falls ", "nur ", "auf ", "quand ", "lorsqu", "quando ", "cuando ",
];
/// Words behind a formula with which it is the subject of a sentence, that says what it is.
const SUBJECT: &[&str] = &[
    "is a ", "is an ", "is the equation", "is the condition", "is one ", "is what", "is not", "are the ", "describes", "represents", "defines",
    "determines", "has ", "holds ", "can be ", "could ", "may ", "does not", "doesn't", "implies", "means ", "forces", "not ", "ist ein",
    "est un", "è un", "es un", "ist nicht", "non ", "no es",
];

/// Words that open a case; behind the last of them the case may be one of reckoning, "if we square".
const IFS: &[&str] = &[" if ", " iff ", " when ", " whenever ", " wenn ", " falls ", " sofern ", " quand ", " lorsque ", " quando ", " cuando "];
/// What somebody does who reckons: no case.
const ACTS: &[&str] = &[
    "insert", "substitut", "plug", "put ", "square", "expand", "multipl", "divid", "add", "subtract", "different", "deriv", "integrat", "use ",
    "apply", "rewrite", "write", "rearrang", "solve", "combin", "factor", "collect", "compare", "now ", "look", "sum ", "comput", "calculat",
    "work", "simplif", "einsetz",
];
/// Words that begin a sentence about a place.
const PLACES: &[&str] = &["on", "at", "along", "near", "inside", "outside", "within", "auf", "bei", "sur", "sul", "sulla", "where"];
/// Words behind them, of what is none.
const NO_PLACES: &[&str] =
    &["hand", "side", "contrary", "first", "last", "same", "other", "end", "one", "stage", "time", "left", "right", "this point", "top", "basis"];
/// Words that link a sentence to the one before it.
const LINKING: &[&str] = &["this ", "that ", "it ", "these ", "but ", "of course", "clearly", "which ", "dies ", "das ", "cela ", "ceci ", "questo ", "esto "];

/// Words that conclude from the formula before them.
const CONCLUDE: &[&str] = &[
    "so ", "hence", "thus", "then ", "therefore", "gives ", "yields", "implies", "it follows", "we get", "we obtain", "we find", "we have",
    "also ", "daraus", "donc", "quindi", "luego",
];

/// What the words of a sentence do with the formula that stands in it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Taken {
    /// They deny it, suppose it, pose or restrict it.
    pub back: bool,
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
    let posed = words(behind_conclusion(before));
    let before = words(before);
    let (first, next) = sentences(behind);
    let raw = if is_ended { "" } else { first };
    let (own, next) = (words(raw), words(if is_ended { first } else { next }));
    let right_behind: String = own.split_inclusive(' ').take(RIGHT_BEHIND + 1).collect();
    let begins = |all: &[&str]| all.iter().any(|w| own.trim_start().starts_with(w));
    // "This is wrong." behind the full stop.
    let is_of_it = LINKING.iter().any(|w| next.trim_start().starts_with(w));
    let back = [&before, &own].iter().any(|text| has_word(text, DENY))
        || [&posed, &own].iter().any(|text| has_word(text, SUPPOSE))
        || supposes_case(&before)
        || is_of_place(&before)
        || denies_at_end(&before)
        || has_word(&right_behind, &RESTRICT[..RESTRICT_ANYWHERE])
        || begins(RESTRICT)
        || begins(SUBJECT)
        || raw.trim_start().starts_with("as $")
        || is_of_it && (has_word(&next, DENY) || next.contains(" not ") || next.contains("n't "));
    let is_loose = |text: &String| has_word(text, LOOSEN) || has_order(text);
    Taken { back, loosely: is_loose(&before) || is_loose(&own) || raw.contains("a.e.") }
}

/// What stands behind the last formula of a sentence where words there conclude from that: what was said of it is not said of what follows.
fn behind_conclusion(before: &str) -> &str {
    let own = before.trim_end_matches(|c: char| c.is_whitespace() || matches!(c, '$' | '(' | '\\'));
    let closes = ["$", r"\)", r"\]", r"\end{"].iter().filter_map(|close| own.rfind(close)).max();
    let behind = closes.map(|at| &before[at..]);
    behind.filter(|rest| has_word(&words(rest), CONCLUDE)).unwrap_or(before)
}

/// So many of the first words of [`RESTRICT`] do so some way behind a formula, too; the others right behind it.
const RESTRICT_ANYWHERE: usize = 12;

/// Whether words that are printed in a row take back what stands beside them.
pub(super) fn take_back_in_row(remark: &str) -> bool {
    let said = words(remark);
    let has = |all: &[&str]| has_word(&said, all);
    has(DENY) || has(SUPPOSE) || has(LOOSEN) || has_order(&said) || has(&RESTRICT[..RESTRICT_ANYWHERE]) || {
        remark.contains("a.e.") || remark.contains(['?', '!'])
            || said.split(' ').any(|w| matches!(w, "not" | "nicht" | "pas" | "non"))
            || ["on ", "in ", "at ", "near "].iter().any(|w| said.trim_start().starts_with(w))
    }
}

/// Whether a word of a list begins somewhere among words.
fn has_word(words: &str, list: &[&str]) -> bool {
    list.iter().any(|w| words.match_indices(w).any(|(at, _)| words[..at].ends_with(' ')))
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
const STOPS: &[&str] = &[". ", ".\n", ".\r", "? ", "?\n", "! ", "!\n", "\n\n", "\n\r\n", ".$", r".\]", r".\)", r".\end", "。", r"\item", r"\par "];
/// Abbreviations, the full stop behind which ends no sentence.
const ABBREVIATED: &[&str] =
    &["eq", "eqs", "fig", "figs", "ref", "refs", "sec", "e.g", "i.e", "cf", "eqn", "eqns", "vs", "prop", "thm", "resp", "z.b", "d.h"];

fn is_abbreviated(before: &str) -> bool {
    let word = before.rsplit(|c: char| c.is_whitespace() || matches!(c, '(' | '~')).next().unwrap_or_default();
    ABBREVIATED.contains(&word.to_lowercase().as_str())
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

/// Whether the order up to which something holds is named: "to second order", and not "in order to".
fn has_order(words: &str) -> bool {
    ["order ", "orders "].iter().any(|w| {
        words.match_indices(&format!(" {w}")).any(|(at, _)| {
            let before: Vec<&str> = words[..at].split_whitespace().rev().take(3).collect();
            let behind = words[at + w.len() + 1..].trim_start();
            before.iter().any(|w| matches!(*w, "to" | "at" | "of" | "up" | "through" | "first" | "second" | "third" | "linear"))
                || behind.starts_with("of ")
                || behind.starts_with("in ") && before.first() != Some(&"in")
        })
    })
}

/// Whether a sentence supposes a case that is no act of reckoning: "the forces balance when", "if the two are far apart, then".
fn supposes_case(before: &str) -> bool {
    let found = IFS.iter().filter_map(|w| before.rfind(w).map(|at| at + w.len() - 1)).max();
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
    PLACES.contains(&first)
        && next.split_whitespace().any(|w| w.chars().count() > 2)
        && !NO_PLACES.iter().any(|w| next.contains(&format!(" {w} ")))
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
