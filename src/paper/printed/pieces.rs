//! Rows → pieces: what stands between commas, wide spaces and words.

use super::super::mark::group_text;
use super::super::opening::{WordAt, is_link, is_opening, is_printed_space, opening, word_at};
use super::super::token::{Kind, Token};
use super::by_hand::{ByHand, numbered_by_hand};
use super::spaces::Spaces;
use super::{BETWEEN_STATEMENTS, Nesting, WIDE_WORDS, WORDS, is_operator, is_relation, is_space, is_wide, relates};

/// A part of a row: what stands between commas, wide spaces and words.
#[derive(Default)]
pub(super) struct Piece {
    pub tokens: Vec<Token>,
    /// Words before it.
    pub words: Option<String>,
    /// A sign between statements stands before it.
    pub implied: bool,
    /// What separates it from the one before is a comma.
    pub comma: bool,
    /// What separates it is a wide space, or words.
    pub wide: bool,
    /// It ends with a comma, a semicolon or a full stop.
    pub ended: bool,
    /// It stood in parentheses, behind a wide space: a remark.
    pub in_parentheses: bool,
    /// What stood behind it in parentheses: its number, or a factor.
    pub by_hand: Option<ByHand>,
    /// A word before it, or behind it, that may be a product of letters.
    pub word_in_doubt: Option<String>,
}

impl Piece {
    pub fn is_empty(&self) -> bool {
        self.tokens.iter().all(|t| is_space(t) || t.is_char("&"))
    }

    pub fn relates(&self) -> bool {
        relates(&self.tokens)
    }

    /// Takes the parentheses away that stand around all of it, where it relates something.
    fn without_parentheses(&mut self) {
        let printed: Vec<usize> = (0..self.tokens.len()).filter(|&i| !is_space(&self.tokens[i])).collect();
        let (Some(&first), Some(&last)) = (printed.first(), printed.last()) else { return };
        if !self.tokens[first].is_char("(") || !self.tokens[last].is_char(")") {
            return;
        }
        let inside = Piece { tokens: self.tokens[first + 1..last].to_vec(), ..Piece::default() };
        let mut depth = 0i32;
        let closes = inside.tokens.iter().any(|t| {
            depth += i32::from(t.is_char("(")) - i32::from(t.is_char(")"));
            depth < 0
        });
        if inside.relates() && !closes {
            (self.tokens, self.in_parentheses) = (inside.tokens, true);
        }
    }

    /// Takes what a separator right behind another one says: two in a row are one.
    fn join(&mut self, next: Piece) {
        self.words = match (self.words.take(), next.words) {
            (Some(a), Some(b)) => Some(format!("{a} {b}")),
            (a, b) => a.or(b),
        };
        self.word_in_doubt = self.word_in_doubt.take().or(next.word_in_doubt);
        self.implied |= next.implied;
        self.comma |= next.comma;
        self.wide |= next.wide;
    }

    pub fn first(&self) -> Option<&Token> {
        self.tokens.iter().find(|t| !is_space(t))
    }
}

/// The pieces of a row.
pub(super) fn pieces(tokens: &[Token]) -> Vec<Piece> {
    let mut out = vec![Piece::default()];
    let mut nesting = Nesting::default();
    let mut at = 0;
    let mut seen = Seen::default();
    while let Some(token) = tokens.get(at) {
        let outside = nesting.is_outside();
        let mut next = None;
        if outside && (token.is_char(",") || token.is_char(";") || token.is_char(".") && ends_sentence(tokens, at)) {
            if let Some(piece) = out.last_mut() {
                piece.ended = true;
            }
            next = Some((Piece { comma: !token.is_char("."), ..Piece::default() }, at + 1));
        } else if outside && (token.is("qc") || token.is("qcomma")) {
            if let Some(piece) = out.last_mut() {
                piece.ended = true;
            }
            next = Some((Piece { comma: true, wide: true, ..Piece::default() }, at + 1));
        } else if outside
            && token.kind == Kind::Command
            && let Some(word) = token.text.strip_prefix('q').filter(|w| WIDE_WORDS.contains(w))
        {
            next = Some((Piece { words: Some(word.to_owned()), wide: true, ..Piece::default() }, at + 1));
        } else if outside
            && let Some(after) = seen.gap(tokens, at)
            && seen.relates
            && seen.relates_next(tokens, after)
        {
            // Between two relations any wide space parts them.
            next = Some((Piece { wide: true, ..Piece::default() }, after));
        } else if outside && is_wide(token) {
            next = Some((Piece { wide: true, ..Piece::default() }, at + 1));
        } else if outside && token.kind == Kind::Command && BETWEEN_STATEMENTS.contains(&token.text.as_str()) {
            next = Some((Piece { implied: true, wide: true, ..Piece::default() }, at + 1));
        } else if outside && token.kind == Kind::Command && WORDS.contains(&token.text.as_str()) {
            let star = usize::from(token.text.starts_with("qq") && tokens.get(at + 1).is_some_and(|t| t.is_char("*")));
            let (words, after) = group_text(tokens, at + 1 + star);
            let is_operand = is_operand(tokens, at, after, &words)
                || !prints_space(token) && goes_on_in_words(tokens, after, &words, &mut seen);
            if after > at + 1 + star && !is_operand {
                next = Some((Piece { words: Some(words.trim().to_owned()), wide: true, ..Piece::default() }, after));
            }
        }
        if next.is_none() && outside {
            next = word_piece(tokens, at, &mut out, &mut seen);
        }
        match next {
            Some((piece, after)) => {
                match out.last_mut().filter(|last| last.is_empty()) {
                    Some(last) => last.join(piece),
                    None => {
                        out.push(piece);
                        seen.relates = false;
                    }
                }
                at = after;
            }
            None => {
                seen.relates |= outside && is_relation(token);
                let more = nesting.take(token, &tokens[at + 1..]);
                let end = (at + 1 + more).min(tokens.len());
                if let Some(piece) = out.last_mut() {
                    piece.tokens.extend_from_slice(&tokens[at..end]);
                }
                at = end;
            }
        }
    }
    for (k, piece) in out.iter_mut().enumerate() {
        if k > 0 && piece.wide && piece.words.is_none() {
            piece.without_parentheses();
        }
        if let Some((end, number)) = numbered_by_hand(&piece.tokens, relates) {
            piece.tokens.truncate(end);
            piece.by_hand = number;
        }
    }
    out
}

/// The piece that a word begins which stands in the letters of a formula, and the place behind the word. Where these may be factors, neither it nor
/// what stands before it is read.
fn word_piece(tokens: &[Token], at: usize, before: &mut [Piece], seen: &mut Seen) -> Option<(Piece, usize)> {
    let WordAt { word, end, may_be_product } = word_at(tokens, at)?;
    let behind = end + tokens[end..].iter().take_while(|t| is_space(t)).count();
    let is_first = before.last().is_none_or(Piece::is_empty);
    if !may_begin_word(tokens, at, is_first, &word) || !seen.relates_next(tokens, behind) {
        return None;
    }
    // Between wide spaces it is no factor of anything.
    let is_apart = || Spaces::before(tokens, at).is_wide && Spaces::behind(tokens, end).is_wide;
    let word_in_doubt = (may_be_product && !is_apart()).then(|| word.clone());
    if word_in_doubt.is_some()
        && let Some(last) = before.iter_mut().rev().find(|p| !p.is_empty())
    {
        last.word_in_doubt.clone_from(&word_in_doubt);
    }
    Some((Piece { words: Some(word), wide: true, word_in_doubt, ..Piece::default() }, end))
}

/// Whether a word may begin at a place of a formula: at its beginning, or behind a space, where no sign wants an operand; a short one only behind
/// a space that is printed.
fn may_begin_word(tokens: &[Token], at: usize, is_first: bool, word: &str) -> bool {
    let before = at.checked_sub(1).and_then(|k| tokens.get(k));
    let wants = |t: &Token| is_relation(t) || is_operator(t) || t.is_char("_") || t.is_char("^");
    let is_wanted = tokens[..at].iter().rev().find(|t| !is_space(t)).is_some_and(wants);
    let is_long = word.chars().count() > 3;
    is_first || !is_wanted && before.is_some_and(|t| is_printed_space(t) || is_long && t.kind == Kind::Space)
}

/// What was seen of a row, so that nothing of it is looked at for each of many spaces.
#[derive(Default)]
struct Seen {
    /// Whether a sign of relation stands in the piece.
    relates: bool,
    /// Where the spaces end that were looked at last.
    spaces: usize,
    /// Before this no sign of relation stands, nor a separator.
    without_sign: usize,
}

impl Seen {
    /// The position after a [`gap`]; of spaces in a row it is told once.
    fn gap(&mut self, tokens: &[Token], at: usize) -> Option<usize> {
        if at < self.spaces {
            return None;
        }
        let (is_gap, end) = gap(tokens, at);
        self.spaces = end;
        is_gap.then_some(end)
    }

    /// Whether a sign of relation stands before the next separator, outside of all brackets.
    fn relates_next(&mut self, tokens: &[Token], from: usize) -> bool {
        if from < self.without_sign {
            return false;
        }
        let (relates, end) = relates_next(tokens, from);
        self.without_sign = if relates { from } else { end };
        relates
    }
}

/// Whether a wide space begins here: a length, a fill, a break, three small ones in a row; and where it ends.
fn gap(tokens: &[Token], at: usize) -> (bool, usize) {
    let Spaces { small, is_wide, breaks, end } = Spaces::at(tokens, at);
    // A line that begins with a sign goes on from the one before.
    let goes_on = tokens.get(end).is_some_and(|t| is_relation(t) || is_operator(t));
    (is_wide || breaks && !goes_on || small > 2, end)
}

/// Whether a sign of relation stands before the next separator, and where that, or the end, is.
fn relates_next(tokens: &[Token], from: usize) -> (bool, usize) {
    let mut nesting = Nesting::default();
    let mut at = from;
    while let Some(token) = tokens.get(at) {
        if nesting.is_outside() {
            if is_relation(token) {
                return (true, at);
            }
            if is_wide(token) || token.is_char(",") || token.is_char(";") {
                return (false, at);
            }
        }
        at += 1 + nesting.take(token, &tokens[at + 1..]);
    }
    (false, tokens.len())
}

/// Whether a full stop ends a formula: it is no decimal point, belongs to no bracket, and touches no letter or full stop, as those of `h.c.`, `F.s` and
/// `\ldots` in letters do.
fn ends_sentence(tokens: &[Token], at: usize) -> bool {
    let next = tokens.get(at + 1);
    let before = at.checked_sub(1).and_then(|k| tokens.get(k));
    let goes_on = next.is_some_and(|t| {
        t.kind == Kind::Other && t.text.starts_with(char::is_alphanumeric)
            || t.is_char(".")
            || t.kind == Kind::Command && is_letter(&t.text)
    });
    !goes_on && !before.is_some_and(|t| t.is("right") || t.is("left") || t.is_char("."))
}

/// Whether a command prints a letter, or a sign above or a style of one.
fn is_letter(command: &str) -> bool {
    const LETTERS: &str = "alpha beta gamma delta epsilon varepsilon zeta eta theta vartheta iota kappa lambda mu nu xi pi rho sigma tau upsilon phi \
         varphi chi psi omega Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega hbar ell partial nabla vec hat bar dot ddot tilde mathbf \
         mathrm boldsymbol bm mathcal frac sqrt";
    LETTERS.split_whitespace().any(|letter| letter == command)
}

/// Whether words are a part of a formula: `F = \text{const}`.
fn is_operand(tokens: &[Token], at: usize, after: usize, words: &str) -> bool {
    let before = tokens[..at].iter().rev().find(|t| !is_space(t));
    let behind = tokens[after..].iter().find(|t| !is_space(t));
    let word = words.trim().trim_end_matches([',', '.', ':']).to_lowercase();
    let script = |t: &&Token| t.is_char("_") || t.is_char("^");
    if !before.is_some_and(|t| script(&t)) && (is_opening(&word) || matches!(word.as_str(), "and" | "or" | "")) {
        return false;
    }
    // `\qq` prints a wide space on both sides.
    let is_name = is_name(words) && tokens[at].text.starts_with(['t', 'm', 'h']);
    if is_name && behind.is_some_and(is_argument) || matches!(word.as_str(), "mod" | "modulo" | "div") {
        return true;
    }
    let begins = before.is_some_and(|t| is_relation(t) || is_operator(t) || script(&t));
    let goes_on = behind.is_some_and(|t| is_relation(t) || is_operator(t) || script(&t));
    begins || goes_on || (before.is_some_and(|t| t.kind == Kind::Open))
}

/// Whether a command prints a wide space around its words, or a line of its own.
fn prints_space(command: &Token) -> bool {
    command.text.starts_with("qq") || command.text.ends_with("intertext")
}

/// Words that say something of what stands behind them, so that it is no formula by itself: `\text{twice }x`, `\text{the mean of }x`.
const OF_WHAT_FOLLOWS: &[&str] = &[
    "of", "per", "times", "minus", "plus", "by", "over", "to", "on", "twice", "half", "double", "negative", "non",
    "not",
];

/// Words that end what leads to a formula: `\text{the energy is }E=T+V`.
const LEADING: &[&str] = &[
    "is",
    "are",
    "be",
    "get",
    "have",
    "find",
    "obtain",
    "gives",
    "give",
    "yields",
    "implies",
    "becomes",
    "that",
    "so",
    "then",
    "thus",
    "hence",
    "since",
    "because",
    "let",
    "set",
    "therefore",
    "using",
    "from",
    "but",
];

/// Whether a formula goes on in words: in a number or a sign that is written as a text, or in what is said of the name right behind them, as
/// `\text{Tr }A=2ab`, `\text{minus }x=y`. Words that open a condition, link formulas or lead to one do not; nor do those between two relations.
fn goes_on_in_words(tokens: &[Token], after: usize, words: &str, seen: &mut Seen) -> bool {
    let words = words.trim();
    let is_sign = |c: char| "+-−±∓*/=<>×·".contains(c);
    if words.starts_with(is_sign) || words.ends_with(is_sign) {
        return true;
    }
    if !words.contains(char::is_alphabetic) {
        return words.contains(|c: char| c.is_ascii_digit()) && !words.starts_with(['(', '[']);
    }
    let touches = tokens[after..].iter().find(|t| t.kind != Kind::Space).is_some_and(is_argument);
    if !touches || !words.ends_with(char::is_alphabetic) || is_link(words) {
        return false;
    }
    let small = words.to_lowercase();
    let last = small.rsplit(|c: char| !c.is_alphabetic()).next().unwrap_or_default();
    let stands_alone = seen.relates && seen.relates_next(tokens, after);
    match opening(words) {
        // `v=s\text{ per }t`; in Italian it opens a condition, which relates something.
        Some(_) => last == "per" && !seen.relates_next(tokens, after),
        None => OF_WHAT_FOLLOWS.contains(&last) || !LEADING.contains(&last) && !stands_alone,
    }
}

/// Whether words are the name of a function, or of a differential, as far as they tell: one word, without a space around it.
fn is_name(words: &str) -> bool {
    !words.is_empty() && words.chars().all(char::is_alphabetic)
}

/// Whether what stands behind a name may be its argument: a bracket, or a name.
fn is_argument(token: &Token) -> bool {
    let named = match token.kind {
        Kind::Command => !is_space(token) && !is_wide(token) && !WORDS.contains(&token.text.as_str()),
        Kind::Open => true,
        _ => token.text.starts_with(char::is_alphanumeric) || matches!(token.text.as_str(), "(" | "[" | "|"),
    };
    named && !is_printed_space(token) && !BETWEEN_STATEMENTS.contains(&token.text.as_str())
}
