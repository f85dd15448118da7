//! What begins a block: marks of lists, fences, lines that are drawn.
//!
//! **In:** a line without the spaces before it. **Out:** what it begins. **Guaranteed:** lengths are in bytes, and columns those in which a page is
//! shown, a tab as wide as up to the next multiple of four.

use super::INDENT;

/// Directives of MyST in which text is printed.
const TEXT: &[&str] = &[
    "note",
    "warning",
    "tip",
    "important",
    "hint",
    "attention",
    "caution",
    "danger",
    "error",
    "seealso",
    "admonition",
    "topic",
    "sidebar",
    "margin",
    "aside",
    "epigraph",
    "pull-quote",
    "blockquote",
    "quote",
    "highlights",
    "figure",
    "subfigure",
    "table",
    "list-table",
    "csv-table",
    "grid",
    "grid-item",
    "grid-item-card",
    "card",
    "tab-set",
    "tab-item",
    "dropdown",
    "details",
    "div",
    "container",
    "compound",
    "rubric",
    "versionadded",
    "versionchanged",
    "deprecated",
    "todo",
    "abstract",
    "glossary",
    "exercise",
    "exercise-start",
    "solution",
    "solution-start",
    "proof",
    "theorem",
    "lemma",
    "axiom",
    "definition",
    "corollary",
    "conjecture",
    "criterion",
    "example",
    "property",
    "proposition",
    "algorithm",
    "remark",
    "observation",
    "assumption",
    "question",
    "answer",
];

/// Directives between colons in which no text is printed as text.
const CODE: &[&str] = &[
    "code",
    "code-block",
    "code-cell",
    "sourcecode",
    "literalinclude",
    "raw",
    "raw-cell",
    "parsed-literal",
    "doctest",
    "testcode",
    "testoutput",
    "mermaid",
    "graphviz",
    "plot",
    "image",
    "iframe",
    "toctree",
    "bibliography",
    "eval-rst",
    "include",
    "comment",
];

/// The marks of a fence.
#[derive(Clone, Copy)]
pub(super) struct Fence {
    pub mark: u8,
    count: usize,
}

impl Fence {
    /// Whether a line closes what this one opens.
    pub fn is_closed_by(self, bare: &str) -> bool {
        let count = bare.bytes().take_while(|b| *b == self.mark).count();
        count >= self.count && bare[count..].trim().is_empty()
    }
}

/// What stands between fences.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Fenced {
    /// Nothing that is a formula.
    Code,
    /// A display.
    Math,
    /// Text; the marks and the name have so many bytes.
    Text { length: usize },
}

/// The fence that a line is, and what stands behind it. A block between colons is text where its name does not say otherwise.
pub(super) fn fence(bare: &str) -> Option<(Fence, Fenced)> {
    let mark = bare.bytes().next().filter(|b| matches!(b, b'`' | b'~' | b':'))?;
    let count = bare.bytes().take_while(|b| *b == mark).count();
    let behind = &bare[count..];
    let word = behind.split_whitespace().next().unwrap_or_default();
    let is_math = word.trim_matches(['{', '}', '`']) == "math";
    if count < 3 || mark == b'`' && behind.contains('`') && !is_math {
        return None;
    }
    let name = word.strip_prefix('{').and_then(|rest| rest.split_once('}')).map(|(name, _)| name);
    let is_text = |name: &str| match mark {
        b':' => !CODE.contains(&name),
        _ => TEXT.contains(&name) || name.starts_with("prf:"),
    };
    let what = match name {
        _ if is_math => Fenced::Math,
        Some(name) if is_text(name) => Fenced::Text { length: bare.find('}').map_or(count, |at| at + 1) },
        // `::: note`, `:::`
        None if mark == b':' => return None,
        _ => Fenced::Code,
    };
    Some((Fence { mark, count }, what))
}

/// A mark that begins an item of a list, or a block whose lines are indented.
pub(super) struct Item {
    /// Where its text goes on.
    pub column: usize,
    /// The bytes of the mark and of the spaces behind it; none where what follows is no block of its own.
    pub length: usize,
    /// The line has code behind the mark.
    pub is_code: bool,
}

/// The item that begins with a line, of which the first letter stands in a column.
pub(super) fn item(bare: &str, column: usize) -> Option<Item> {
    let digits = bare.len() - bare.trim_start_matches(|c: char| c.is_ascii_digit()).len();
    let mark = match digits {
        0 if bare.starts_with(['-', '*', '+']) => 1,
        1..=9 if bare[digits..].starts_with(['.', ')']) => digits + 1,
        _ => 0,
    };
    if mark == 0 {
        let is_note = bare.starts_with("[^") && bare.contains("]:");
        let is_block = ["!!! ", "??? ", "???+ ", "=== ", ": "].iter().any(|mark| bare.starts_with(mark));
        return (is_note || is_block).then_some(Item { column: column + INDENT, length: 0, is_code: false });
    }
    let (behind, end) = (&bare[mark..], column + mark);
    let spaces = behind.len() - behind.trim_start_matches([' ', '\t']).len();
    let width = columns_from(end, &behind[..spaces]);
    match width {
        _ if behind.trim().is_empty() => Some(Item { column: end + 1, length: 0, is_code: false }),
        0 => None,
        1..=INDENT => Some(Item { column: end + width, length: mark + spaces, is_code: false }),
        _ => Some(Item { column: end + 1, length: mark + spaces, is_code: true }),
    }
}

/// The width of spaces that begin in a column.
pub(super) fn columns_from(column: usize, spaces: &str) -> usize {
    let end = spaces.chars().fold(column, |at, c| if c == '\t' { (at / INDENT + 1) * INDENT } else { at + 1 });
    end - column
}

/// Whether a line is one that is drawn: `---`, `* * *`.
pub(super) fn is_drawn_line(bare: &str) -> bool {
    ['-', '*', '_'].iter().any(|mark| {
        let is_all = bare.chars().all(|c| c == *mark || c.is_whitespace());
        is_all && bare.matches(*mark).count() >= 3
    })
}
