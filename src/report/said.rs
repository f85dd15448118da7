//! What a claim is called on page one: what it says, in a few words, which lead to it.
//!
//! **In:** claims of a file with their readings. **Out:** for each one span: its sentence, shortened at a word; its formula, where it has no sentence
//! and the formula is short; else its id. An id is a name for links and for commands: a reader of page one does not know it.

use super::digest::Whole;
use super::numbers::count;
use super::story::{StorySpan, Tone, joined, words};
use super::wording::{Part, parts};
use derivation::Derivation;

/// Words that end no shortened sentence: what they belong to is left out.
const NO_END: [&str; 6] = ["a", "an", "the", "of", "to", "in"];

/// The claim in at most so many letters.
pub(super) fn said<'a>(derivation: &'a Derivation, whole: &Whole<'a>, tone: Tone, most: usize) -> StorySpan<'a> {
    let formula = || {
        let mut all = whole.readings.iter().flat_map(|r| &r.claim.formulas);
        all.next().filter(|f| f.len() <= most && !f.contains('$')).map(|f| format!("${}$", f.trim()))
    };
    match shortened(&whole.says, most).or_else(formula) {
        Some(text) => StorySpan::Said { claim: whole.id.to_owned(), text, scope: &derivation.scope, tone },
        None => StorySpan::Claim(whole.id.to_owned(), tone),
    }
}

/// The claim between quotes, in at most so many letters; its id, where it has no words.
pub(super) fn quoted(whole: &Whole<'_>, most: usize) -> String {
    format!("“{}”", shortened(&whole.says, most).unwrap_or_else(|| whole.id.to_owned()))
}

/// The first of some claims in words, between quotes, and how many there are beside them: those that are not shown, and `beside`.
pub(super) fn list<'a>(
    derivation: &'a Derivation,
    wholes: &[&Whole<'a>],
    (most, longest): (usize, usize),
    beside: usize,
) -> Vec<StorySpan<'a>> {
    let one = |whole: &&Whole<'a>| vec![words("“"), said(derivation, whole, Tone::Plain, longest), words("”")];
    let mut out = joined(wholes.iter().take(most).map(one), ", ");
    match wholes.len().saturating_sub(most) + beside {
        0 => {}
        more => out.push(words(format!(", and {}", count(more, "more claim")))),
    }
    out
}

/// A sentence without its full stop, in at most so many letters and cut between words, not in a formula; `None` where nothing is left.
fn shortened(text: &str, most: usize) -> Option<String> {
    let text = text.trim().trim_end_matches('.');
    if text.is_empty() || letters(text) <= most {
        return (!text.is_empty()).then(|| text.to_owned());
    }
    let is_whole = |end: &usize| text[..*end].matches(['$', '`']).count().is_multiple_of(2);
    let ends = text.match_indices(' ').map(|(at, _)| at).filter(is_whole);
    let fits = ends.take_while(|end| letters(&text[..*end]) < most).last()?;
    let mut kept = text[..fits].trim_end();
    while let Some((before, _)) = kept.rsplit_once(' ').filter(|(_, last)| NO_END.contains(last)) {
        kept = before.trim_end();
    }
    Some(format!("{}…", kept.trim_end_matches([',', ':', ';', '.', '(', ' '])))
}

/// How many letters a text has, about: of formulas their LaTeX counts.
fn letters(text: &str) -> usize {
    let of = |part: &Part<'_>| match part {
        Part::Words(text) | Part::Formula(text) => text.chars().count(),
    };
    parts(text).iter().map(of).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sentence_is_cut_between_words_and_never_in_a_formula() {
        let text = "R(t) applied to the position of a point at t = 0 gives its position at time t.";
        assert_eq!(shortened(text, 32).as_deref(), Some("R(t) applied to the position…"));
        assert_eq!(shortened("Energy is conserved.", 32).as_deref(), Some("Energy is conserved"));
        assert_eq!(shortened("The rate $a + b + c + d$ grows", 14).as_deref(), Some("The rate…"));
        assert_eq!(shortened("Energy and momentum: 2E is more", 22).as_deref(), Some("Energy and momentum…"));
        assert_eq!(shortened("$a + b + c + d + e + f$ grows", 8), None);
        assert_eq!(shortened("averylongwordwithoutaspace", 8), None);
        assert_eq!(shortened(" . ", 8), None);
        assert_eq!(shortened("a cost of 5$ and of much more than that", 12).as_deref(), Some("a cost…"));
    }
}
