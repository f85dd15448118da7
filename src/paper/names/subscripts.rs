//! What stands below a letter, all over a paper.
//!
//! **In:** the subscripts of one letter, one after the other. **Out:** what they may be. **Guaranteed:** a question takes the same time
//! however many there are.

use super::super::mark::group_text;
use super::super::token::{Kind, Token};

/// The letters over which the sums and products of a formula run: those before the first sign below, `i` and `j` of `\sum_{i<j}`.
pub(super) fn index_letters_of_sums(tokens: &[Token]) -> impl Iterator<Item = char> + '_ {
    let is_sum = |t: &Token| t.is("sum") || t.is("prod");
    (0..tokens.len()).filter(move |&at| is_sum(&tokens[at])).flat_map(move |at| {
        let limits = usize::from(tokens.get(at + 1).is_some_and(|t| t.is("limits")));
        let below = tokens.get(at + 1 + limits).is_some_and(|t| t.is_char("_"));
        let one = tokens.get(at + 2 + limits).filter(|t| !matches!(t.kind, Kind::Open | Kind::Command));
        let text = match one {
            _ if !below => String::new(),
            Some(letter) => letter.text.to_string(),
            None => group_text(tokens, at + 2 + limits).0,
        };
        let lone = |part: &str| part.trim().chars().next().filter(|_| part.trim().chars().count() == 1);
        text.split(['=', ',', '<', '\\']).filter_map(lone).collect::<Vec<_>>()
    })
}

/// Letters below that are indices or coordinates, for most readers.
const INDICES: &str = "ijklmnpqsabcdαβμνxyz";

/// Subscripts of one letter, as counts of what they may be.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Subscripts {
    all: usize,
    components: usize,
    of_indices: usize,
    labels: usize,
    pairs: usize,
    named: usize,
}

impl Subscripts {
    /// Takes note of a subscript.
    pub(super) fn note(&mut self, text: &str) {
        let length = text.chars().take(3).count();
        let each = |is: &dyn Fn(char) -> bool| text.chars().all(is);
        let short = (1..=2).contains(&length);
        let could_be_named = match text.strip_prefix('\\') {
            Some(letter) => letter.chars().all(char::is_alphabetic),
            None => short && each(&char::is_alphanumeric),
        };
        self.all += 1;
        self.components += usize::from(short && each(&|c| "ijklmnpqrs123".contains(c)));
        self.of_indices += usize::from(text.chars().any(|c| "ijkl".contains(c)));
        self.labels += usize::from(length == 1 && each(&|c| c.is_alphabetic() && !INDICES.contains(c)));
        self.pairs += usize::from(length == 2);
        self.named += usize::from(could_be_named);
    }

    /// Whether they are indices of components: all could be, and one is a letter that is used so.
    pub fn are_indices(&self) -> bool {
        self.components == self.all && self.of_indices > 0
    }

    /// Whether one is a label that is no index, for most readers: beside `E_r` and `E_t` that of `E_i` is a label, too.
    pub fn have_label(&self) -> bool {
        self.labels > 0
    }

    /// Whether one has two letters or digits.
    pub fn have_pair(&self) -> bool {
        self.pairs > 0
    }

    /// Whether one could be that of a component, or the name of one.
    pub fn have_named(&self) -> bool {
        self.named > 0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(all: &[&str]) -> Subscripts {
        let mut out = Subscripts::default();
        all.iter().for_each(|s| out.note(s));
        out
    }

    #[test]
    fn subscripts_are_indices_only_together() {
        assert!(of(&["i", "1", "ij"]).are_indices());
        assert!(!of(&["1", "2"]).are_indices(), "no letter is used as an index");
        assert!(!of(&["i", "0"]).are_indices());
        assert!(!of(&[]).are_indices());
        assert!(of(&["r", "t"]).have_label() && !of(&["i", "rt", "0"]).have_label());
        assert!(of(&["i", "ij"]).have_pair() && !of(&["ijk", "i"]).have_pair());
        assert!(of(&[r"\mu"]).have_named() && !of(&["abc", ""]).have_named());
    }
}
