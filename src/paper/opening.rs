//! Opening words: what the words before a formula make of it, in the languages of the papers.
//!
//! **In:** words, as `\text{for all }`, or a word that stands in the formula in letters, `se\,\, x=0`. **Out:** an [`Opening`]. **Guaranteed:** the
//! table is the only one of such words: displays, running text and `cases` share it.

use super::mark::group_text;
use super::token::{Kind, Token};

/// What the words before a formula make of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Opening {
    /// A case: what stands beside it holds only there. "if x = y".
    Case,
    /// A remark on when something holds, or a reason for it: "as", "in", "unless".
    Remark,
    /// The meaning of a name: "where k = 2π/λ".
    Meaning,
    /// All other cases: "otherwise".
    Otherwise,
    /// Nothing: "and" parts two formulas.
    Link,
}

/// The words, in small letters.
const WORDS: &[(Opening, &[&str])] = &[
    (
        Opening::Case,
        &[
            "if",
            "iff",
            "for",
            "for all",
            "when",
            "whenever",
            "only if",
            "only when",
            "provided",
            "assuming",
            "given",
            "at",
            "near",
            "wenn",
            "falls",
            "für",
            "bei",
            "sofern",
            "si",
            "pour",
            "quand",
            "lorsque",
            "lorsqu",
            "dès que",
            "se",
            "per",
            "quando",
            "qualora",
            "allorché",
            "cuando",
            "siempre que",
            "para",
            "caso",
            "om",
            "hvis",
            "gdy",
            "jeśli",
            "dla",
            "при",
            "если",
            "когда",
            "для",
            "若",
            "当",
            "當",
            "如果",
            "假如",
            "对于",
            "對於",
        ],
    ),
    (Opening::Remark, &["as", "on", "in", "unless", "在", "取"]),
    (
        Opening::Meaning,
        &[
            "where",
            "wherein",
            "with",
            "wobei",
            "worin",
            "mit",
            "où",
            "avec",
            "dove",
            "con",
            "donde",
            "onde",
            "com",
            "где",
            "waar",
            "其中",
            "这里",
            "ここで",
        ],
    ),
    (Opening::Link, &["and", "und", "et", "och", "og", "oraz", "且", "和", "及"]),
    (
        Opening::Otherwise,
        &[
            "otherwise",
            "else",
            "sonst",
            "andernfalls",
            "sinon",
            "altrimenti",
            "en otro caso",
            "caso contrário",
            "иначе",
            "否则",
            "其他",
        ],
    ),
];

/// More bytes than a word of the table has.
const LONGEST_WORD: usize = 40;

/// Words between two formulas of one kind, as two values of a name: `x=1 \text{ or } {-1}`.
const LINKS: &[&str] = &[
    "and", "or", "und", "oder", "et", "ou", "e", "o", "ed", "y", "och", "eller", "og", "oraz", "lub", "и", "или", "或",
    "和",
];

/// Words behind a formula that make a case of it: 当 x = 0 时.
const BEHIND: &[&str] = &["时", "時", "のとき", "の場合", "일 때", "이면"];

fn is_of_east_asia(word: &str) -> bool {
    word.chars().all(|c| c >= '\u{2e80}')
}

/// What words before a formula make of it. The first word counts, or else the last.
pub fn opening(words: &str) -> Option<Opening> {
    let words = words.to_lowercase();
    let words = words.trim_matches(|c: char| !c.is_alphabetic());
    let ends_word = |rest: &str| !rest.starts_with(char::is_alphanumeric);
    let begins = |w: &str| words.strip_prefix(w).is_some_and(|rest| ends_word(rest) || is_of_east_asia(w));
    let ends = |w: &str| {
        words.strip_suffix(w).is_some_and(|rest| !rest.ends_with(char::is_alphanumeric) || is_of_east_asia(w))
    };
    let first = WORDS.iter().find(|(_, all)| all.iter().any(|w| begins(w))).map(|(opening, _)| *opening);
    if first == Some(Opening::Link) {
        let rest = words.trim_start_matches(char::is_alphabetic);
        return if is_of_east_asia(words) { first } else { opening(rest).or(first) };
    }
    let last = || WORDS.iter().find(|(o, all)| *o == Opening::Case && all.iter().any(|w| ends(w))).map(|(o, _)| *o);
    first.or_else(last)
}

/// Whether words are one of the table, and nothing more.
pub(super) fn is_opening(words: &str) -> bool {
    WORDS.iter().any(|(_, all)| all.contains(&words.trim().to_lowercase().as_str()))
}

/// Whether words link two formulas, and say nothing more.
pub(super) fn is_link(words: &str) -> bool {
    LINKS.contains(&words.trim().to_lowercase().as_str())
}

/// Whether words make a case of the formula before them.
pub(super) fn closes_case(words: &str) -> bool {
    BEHIND.iter().any(|w| words.trim_start().starts_with(w))
}

/// Commands that print letters upright, with which words are written in formulas.
const UPRIGHT: &[&str] = &["mathrm", "textsf", "mathsf", "textup", "operatorname", "mathit", "mathbf"];

/// Whether a token is a space that is printed in a formula.
pub(super) fn is_printed_space(token: &Token) -> bool {
    let spaces = [",", ";", ":", ">", " ", "quad", "qquad", "enspace", "thinspace", "medspace", "thickspace", "hspace"];
    token.is_char("~") || token.kind == Kind::Command && spaces.contains(&token.text.as_str())
}

/// A word of a formula.
pub(super) struct WordAt {
    pub word: String,
    /// The place behind it.
    pub end: usize,
    /// It is set in so few letters of mathematics that it may be their product.
    pub may_be_product: bool,
}

/// The most letters of a word that may be meant as factors.
const MOST_FACTORS: usize = 3;

/// A word of the table that begins at a place of a formula: in letters, `se\,`, or upright, `\mathrm{if}`. What is set in letters of mathematics is a
/// word only between spaces: `if` is a product, too.
pub(super) fn word_at(tokens: &[Token], at: usize) -> Option<WordAt> {
    let plain = |word: String, end| WordAt { word, end, may_be_product: false };
    let token = tokens.get(at)?;
    if token.kind == Kind::Command && UPRIGHT.contains(&token.text.as_str()) {
        let (word, after) = group_text(tokens, at + 1);
        return is_opening(&word).then(|| plain(word.trim().to_owned(), after));
    }
    let is_letter = |t: &Token| t.kind == Kind::Other && !t.text.is_empty() && t.text.chars().all(char::is_alphabetic);
    let mut end = at;
    let mut word = String::new();
    while let Some(next) = tokens.get(end).filter(|t| is_letter(t)) {
        if end > at && next.span.start != tokens[end - 1].span.end {
            break;
        }
        word.push_str(&next.text);
        end += 1;
        // No word of the table is so long. A run of letters is looked at from each of them.
        if word.len() > LONGEST_WORD {
            return None;
        }
        if is_opening(&word) && is_of_east_asia(&word) {
            return Some(plain(word, end));
        }
    }
    let printed = tokens[end..].iter().find(|t| t.kind != Kind::Space).is_some_and(is_printed_space);
    let written = tokens.get(end).is_some_and(|t| t.kind == Kind::Space);
    let long = word.chars().count();
    let is_word = is_opening(&word) && long > 1 && (printed || written && long > MOST_FACTORS);
    is_word.then_some(WordAt { word, end, may_be_product: long <= MOST_FACTORS })
}
