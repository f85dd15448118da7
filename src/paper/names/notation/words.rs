//! Lone names of a text that a word is said of.
//!
//! **In:** the text of a file, and words. **Out:** the names between dollars that stand beside one of them, each with the place of the word.
//! **Guaranteed:** a name is one letter with its scripts; a sentence that ends, or another formula, parts them.

use super::print::{is_letter_token, tokens};
use super::squeezed;
use diag::next_character;

/// How far from a name such a word may stand, in bytes.
const BESIDE: usize = 70;

/// A name that a word is said of.
pub(super) struct Named {
    /// Its key, without spaces and braces.
    pub key: String,
    /// Where the word stands.
    pub at: usize,
}

/// Lone names between dollars that a word is said of: "the operators $x$ and $p$", "let $A$ and $B$ be square matrices".
pub(super) fn named_beside(text: &str, words: &[&str]) -> Vec<Named> {
    let near = |at: usize| next_character(text, at);
    let mut out = Vec::new();
    let mut note = |names: &str, at: usize| {
        let lone = names.split(',').map(str::trim).filter(|p| is_lone(p));
        out.extend(lone.map(|p| Named { key: squeezed(p), at }));
    };
    for word in words {
        // `\operatorname` says nothing of an operator.
        for (at, _) in text.match_indices(word).filter(|(at, _)| !text[..*at].ends_with('\\')) {
            let before = &text[near(at.saturating_sub(BESIDE))..at];
            let behind = &text[at..near(at + BESIDE)];
            // The rest of the word, then names with nothing but "and" between them.
            let behind = behind.trim_start_matches(|c: char| c.is_alphabetic());
            let mut pieces = behind.split('$');
            while let Some(between) = pieces.next()
                && matches!(between.trim().trim_end_matches(','), "" | "and" | "or" | "like" | "such as")
                && let Some(name) = pieces.next()
            {
                note(name, at);
            }
            // Names, then a few words up to this one.
            let mut count = 0;
            for (k, piece) in before.rsplit('$').enumerate() {
                if k % 2 == 1 {
                    note(piece, at);
                    continue;
                }
                count += piece.split_whitespace().count();
                let is_said = k > 0
                    || ["is", "are", "be", "being", "as", "two", "zwei", "due", "deux", "dos", "dois", "sind", "des"]
                        .iter()
                        .any(|w| piece.split_whitespace().any(|p| p == *w));
                if count > MOST_WORDS_BETWEEN || piece.contains(['.', ';', '=']) || !is_said && !piece.trim().is_empty()
                {
                    break;
                }
            }
        }
    }
    out
}

/// So many words may stand between a name and what is said of it.
const MOST_WORDS_BETWEEN: usize = 6;

/// Whether a text is one letter, with scripts and a style, perhaps.
pub(super) fn is_lone(text: &str) -> bool {
    let all = tokens(text);
    let letters = all
        .iter()
        .filter(|t| is_letter_token(t) && !matches!(**t, r"\mathbf" | r"\mathcal" | r"\boldsymbol" | r"\hat" | r"\vec"))
        .count();
    let sub = all.contains(&"_");
    !text.is_empty()
        && text.len() <= 14
        && (letters == 1 || sub && letters <= 2)
        && !text.contains(char::is_whitespace)
        && all
            .iter()
            .all(|t| is_letter_token(t) || matches!(*t, "{" | "}" | "_" | "'") || t.chars().all(|c| c.is_ascii_digit()))
}
