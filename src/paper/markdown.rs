//! Markdown: what is printed of it, and where its mathematics stands.
//!
//! **In:** the text of a file. **Out:** a text of the same length with blanks in the place of what is not printed, or not as a formula: code,
//! comments, blocks of HTML that hold code, what stands before the text between `---`, the marks of quotations. Blocks of mathematics
//! become displays. **Guaranteed:** all other places stay; a percent sign begins a comment within mathematics alone.

use std::collections::HashSet;
use std::ops::Range;

/// Elements of HTML in which nothing is a formula.
const CODE: &[&str] = &["pre", "code", "script", "style", "textarea", "noscript"];
/// What opens mathematics within a text, and what closes it.
const MATH: &[(&str, &str)] = &[("$$", "$$"), ("$", "$"), (r"\[", r"\]"), (r"\(", r"\)"), (r"\begin{", r"\end{")];
/// The columns by which code is indented.
const INDENT: usize = 4;
/// The longest name of an environment.
const LONGEST_ENVIRONMENT: usize = 40;
/// The most ticks around code.
const MOST_TICKS: usize = 32;

/// A text in Markdown with blanks in the place of what is printed as no text.
pub(super) fn printed(text: &str) -> String {
    let mut page = Page {
        text,
        out: text.as_bytes().to_vec(),
        items: Vec::new(),
        before: Before::Blank,
        paragraph_end: 0,
        unclosed: HashSet::new(),
    };
    let mut at = page.front_matter();
    while at < text.len() {
        at = page.line(at);
    }
    String::from_utf8(page.out).unwrap_or_default()
}

/// So many kinds of brackets that are not closed are looked for.
const MOST_UNCLOSED: usize = 1_000;

/// What the line before is.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Before {
    Blank,
    Code,
    Text,
}

struct Page<'t> {
    text: &'t str,
    out: Vec<u8>,
    /// The columns from which the items of lists go on that are open here.
    items: Vec<usize>,
    before: Before,
    /// Where the paragraph ends that was looked at last.
    paragraph_end: usize,
    /// What is closed no more before a place: it is not looked for again.
    unclosed: HashSet<(String, usize)>,
}

impl Page<'_> {
    fn blank(&mut self, range: Range<usize>) {
        self.out[range].iter_mut().filter(|b| **b != b'\n' && **b != b'\r').for_each(|b| *b = b' ');
    }

    /// Where the line ends that a place is in, its break included.
    fn end_of_line(&self, at: usize) -> usize {
        self.end_of_line_within(at..self.text.len())
    }

    /// The same, not beyond the end of a range.
    fn end_of_line_within(&self, range: Range<usize>) -> usize {
        let break_at = self.text.as_bytes()[range.clone()].iter().position(|b| *b == b'\n');
        break_at.map_or(range.end, |i| range.start + i + 1)
    }

    /// Passes over what a file says of itself before its text.
    fn front_matter(&mut self) -> usize {
        let is = |line: &str, mark: &str| line.trim_end() == mark;
        let mut at = self.end_of_line(0);
        let Some(mark) = ["---", "+++"].into_iter().find(|mark| is(&self.text[..at], mark)) else { return 0 };
        if self.text[at..self.end_of_line(at)].trim().is_empty() {
            // A line that is drawn.
            return 0;
        }
        while at < self.text.len() {
            let end = self.end_of_line(at);
            let line = &self.text[at..end];
            if is(line, mark) || mark == "---" && is(line, "...") {
                self.blank(0..end);
                return end;
            }
            at = end;
        }
        0
    }

    /// Where the marks of a quotation end that stand at a place, at most so many; and how many there are.
    fn quoted(&self, from: usize, most: usize) -> (usize, usize) {
        let (mut at, mut depth) = (from, 0);
        while depth < most {
            let rest = &self.text[at..];
            let spaces = rest.len() - rest.trim_start_matches(' ').len();
            if spaces >= INDENT || !rest[spaces..].starts_with('>') {
                break;
            }
            at += spaces + 1;
            depth += 1;
        }
        // A space behind the mark belongs to it.
        let space = usize::from(depth > 0 && self.text[at..].starts_with(' '));
        (at + space, depth)
    }

    /// Reads the line that begins here, and what it opens; gives the place behind that.
    fn line(&mut self, from: usize) -> usize {
        let (at, depth) = self.quoted(from, usize::MAX);
        self.blank(from..at);
        let end = self.end_of_line(at);
        let line = &self.text[at..end];
        let bare = line.trim_start();
        if bare.is_empty() {
            self.before = if self.before == Before::Code { Before::Code } else { Before::Blank };
            return end;
        }
        let indent = columns(&line[..line.len() - bare.len()]);
        let is_apart = self.before != Before::Text;
        if is_apart {
            self.items.retain(|column| *column <= indent);
        }
        let own = self.items.iter().rev().find(|column| **column <= indent).copied().unwrap_or_default();
        if is_apart && indent >= own + INDENT {
            self.blank(at..end);
            self.before = Before::Code;
            return end;
        }
        self.before = Before::Text;
        if let Some(column) = item(bare) {
            self.items.retain(|other| *other <= indent);
            self.items.push(indent + column);
        }
        if let Some((mark, count, math)) = fence(bare) {
            self.before = Before::Blank;
            return self.fenced(at..end, depth, (mark, count, math));
        }
        if bare.starts_with('#') {
            self.before = Before::Blank;
        }
        self.inline(at, end, depth)
    }

    /// A block between fences.
    fn fenced(&mut self, first: Range<usize>, depth: usize, (mark, count, math): (u8, usize, bool)) -> usize {
        self.fence_line(first.clone(), math);
        let mut at = first.end;
        // Whether the options of a block of mathematics may stand here, `:label: energy`.
        let mut options = math;
        while at < self.text.len() {
            let (begin, _) = self.quoted(at, depth);
            self.blank(at..begin);
            let end = self.end_of_line(begin);
            let bare = self.text[begin..end].trim_start();
            let closes = bare.bytes().take_while(|b| *b == mark).count();
            if closes >= count && bare[closes..].trim().is_empty() {
                self.fence_line(begin..end, math);
                return end;
            }
            if options && bare.starts_with(':') {
                self.option(begin..end);
            } else if math {
                options = false;
                self.without_comment(begin..end);
            } else {
                self.blank(begin..end);
            }
            at = end;
        }
        at
    }

    /// A line that opens or closes a block of code; of mathematics it is `$$`.
    fn fence_line(&mut self, line: Range<usize>, math: bool) {
        let text = &self.text[line.clone()];
        let begin = line.start + text.len() - text.trim_start().len();
        self.blank(line);
        if math {
            self.out[begin..begin + 2].copy_from_slice(b"$$");
        }
    }

    /// A line with an option of a block of mathematics: its label is that of a display in LaTeX, where there is room for it.
    fn option(&mut self, line: Range<usize>) {
        let text = self.text[line.clone()].trim_end();
        let from = line.start + text.len() - text.trim_start().len();
        let label = text.trim().strip_prefix(":label:").map(str::trim).filter(|l| !l.is_empty());
        self.blank(line.clone());
        let Some(label) = label.filter(|label| !label.contains(['{', '}', '\\', '%'])) else { return };
        // `\label{x}` is as long as `:label: x`, spaces around it apart.
        let shown = format!("\\label{{{label}}}");
        if shown.len() <= line.start + text.len() - from {
            self.out[from..from + shown.len()].copy_from_slice(shown.as_bytes());
        }
    }

    /// What stands in a line; what is opened there may reach over several, and the rest of the line where it ends is read with it.
    fn inline(&mut self, from: usize, line_end: usize, depth: usize) -> usize {
        let (mut at, mut end) = (from, line_end);
        let mut is_first = true;
        while at < end {
            let rest = &self.text[at..];
            let after = match rest.as_bytes()[0] {
                b'`' => self.code_span(at),
                b'<' => self.html(at, is_first),
                b'$' | b'\\' => self.mathematics(at, depth),
                b'%' => {
                    self.out[at] = b' ';
                    at + 1
                }
                _ => at + rest.chars().next().map_or(1, char::len_utf8),
            };
            is_first &= self.text[at..after].trim().is_empty();
            if after > end {
                end = self.end_of_line(after - 1);
            }
            at = after;
        }
        end
    }

    /// Where the paragraph ends that a place is in.
    fn end_of_paragraph(&mut self, from: usize) -> usize {
        if from < self.paragraph_end {
            return self.paragraph_end;
        }
        self.paragraph_end = self.end_of_paragraph_from(from);
        self.paragraph_end
    }

    fn end_of_paragraph_from(&self, from: usize) -> usize {
        let mut at = self.end_of_line(from);
        while at < self.text.len() {
            let end = self.end_of_line(at);
            if self.text[at..end].trim_matches(|c: char| c.is_whitespace() || c == '>').is_empty() {
                return at;
            }
            at = end;
        }
        at
    }

    /// Code between ticks.
    fn code_span(&mut self, at: usize) -> usize {
        let end = self.end_of_paragraph(at);
        let rest = &self.text[at..end];
        let count = rest.bytes().take_while(|b| *b == b'`').count();
        let mut from = if count > MOST_TICKS { rest.len() } else { count };
        while let Some(found) = rest[from..].find('`') {
            let begin = from + found;
            let ticks = rest[begin..].bytes().take_while(|b| *b == b'`').count();
            if ticks == count {
                self.blank(at..at + begin + ticks);
                return at + begin + ticks;
            }
            from = begin + ticks;
        }
        at + count
    }

    /// A comment, or an element that holds code.
    fn html(&mut self, at: usize, begins_line: bool) -> usize {
        let rest = &self.text[at..];
        let is_element = |name: &str| {
            let behind =
                rest.get(1..=name.len()).filter(|n| n.eq_ignore_ascii_case(name)).map(|_| &rest[1 + name.len()..]);
            behind.is_some_and(|b| b.starts_with(|c: char| c == '>' || c.is_whitespace()))
        };
        let closing = match CODE.iter().find(|name| is_element(name)) {
            _ if rest.starts_with("<!--") => "-->".to_owned(),
            Some(name) => format!("</{name}>"),
            None => return at + 1,
        };
        let all = &self.text.as_bytes()[at..];
        let is_here = |w: &[u8]| w.eq_ignore_ascii_case(closing.as_bytes());
        let key = (closing.clone(), self.text.len());
        let found = if self.unclosed.contains(&key) { None } else { all.windows(closing.len()).position(is_here) };
        let end = match found {
            Some(found) => found + closing.len(),
            // What begins a line and is not closed hides all behind it.
            None if begins_line && closing != "</code>" => all.len(),
            None => {
                self.unclosed.insert(key);
                return at + 1;
            }
        };
        self.blank(at..at + end);
        at + end
    }

    /// What opens mathematics, or a sign behind a backslash.
    fn mathematics(&mut self, at: usize, depth: usize) -> usize {
        let rest = &self.text[at..];
        let Some((open, close)) = MATH.iter().find(|(open, _)| rest.starts_with(open)) else {
            // A percent sign is none of a comment, and a break ends the line.
            let escaped = rest.chars().nth(1).filter(|c| !matches!(c, '%' | '\n'));
            return at + 1 + escaped.map_or(0, char::len_utf8);
        };
        let from = at + open.len();
        // GitHub writes formulas as $`…`$: only the ticks go.
        let ticks = *open == "$" && self.text[from..].starts_with('`');
        let most = if *open == "$" || *open == r"\(" { self.end_of_paragraph(at) } else { self.text.len() };
        let name_end = self.text.as_bytes()[from..most].iter().take(LONGEST_ENVIRONMENT).position(|b| *b == b'}');
        let close = match name_end {
            Some(length) if *open == r"\begin{" => format!("{close}{}}}", &self.text[from..from + length]),
            _ => (*close).to_owned(),
        };
        let key = (close.clone(), most);
        // A page with so many that are not closed has no more that are looked for.
        let is_in_vain = self.unclosed.contains(&key) || self.unclosed.len() > MOST_UNCLOSED;
        let end = if is_in_vain { None } else { self.closing(from, most, &close) };
        let Some(end) = end else {
            self.unclosed.insert(key);
            return from;
        };
        let inside = &self.text[from..end];
        let is_money = *open == "$"
            && inside.starts_with(|c: char| c.is_ascii_digit())
            && (inside.ends_with(char::is_whitespace)
                || self.text[end + 1..].starts_with(|c: char| c.is_ascii_digit()));
        if inside.is_empty() || is_money {
            return from;
        }
        if ticks && inside.ends_with('`') && inside.len() > 1 {
            self.blank(from..from + 1);
            self.blank(end - 1..end);
        }
        let mut line = from;
        while line < end {
            let next = self.end_of_line_within(line..end);
            self.without_comment(line..next);
            if next < end {
                let (begin, _) = self.quoted(next, depth);
                self.blank(next..begin.min(end));
            }
            line = next;
        }
        end + close.len()
    }

    /// Where mathematics is closed.
    fn closing(&self, from: usize, most: usize, close: &str) -> Option<usize> {
        let bytes = self.text.as_bytes();
        let mut at = from;
        while at < most {
            if self.text[at..most].starts_with(close) {
                return Some(at);
            }
            at += if bytes[at] == b'\\' { 2 } else { 1 };
            while at < most && !self.text.is_char_boundary(at) {
                at += 1;
            }
        }
        None
    }

    /// A line of mathematics without the comment at its end.
    fn without_comment(&mut self, line: Range<usize>) {
        let bytes = self.text[line.clone()].as_bytes();
        let mut at = 0;
        while let Some(byte) = bytes.get(at) {
            if *byte == b'%' {
                return self.blank(line.start + at..line.end);
            }
            at += if *byte == b'\\' { 2 } else { 1 };
        }
    }
}

/// The width of spaces.
fn columns(spaces: &str) -> usize {
    spaces.chars().fold(0, |width, c| if c == '\t' { (width / INDENT + 1) * INDENT } else { width + 1 })
}

/// Whether a line begins an item of a list, or a block whose lines are indented: where its text goes on, from its beginning.
fn item(bare: &str) -> Option<usize> {
    let digits = bare.len() - bare.trim_start_matches(|c: char| c.is_ascii_digit()).len();
    let mark = match digits {
        0 if bare.starts_with(['-', '*', '+']) => 1,
        1..=9 if bare[digits..].starts_with(['.', ')']) => digits + 1,
        _ => 0,
    };
    let behind = &bare[mark..];
    let spaces = behind.len() - behind.trim_start_matches(' ').len();
    match mark {
        0 => {
            let is_note = bare.starts_with("[^") && bare.contains("]:");
            let is_block = ["!!! ", "??? ", "???+ ", "=== ", ": "].iter().any(|mark| bare.starts_with(mark));
            (is_note || is_block).then_some(INDENT)
        }
        _ if behind.trim().is_empty() => Some(mark + 1),
        _ if spaces == 0 => None,
        _ => Some(mark + if spaces > INDENT { 1 } else { spaces }),
    }
}

/// The mark of a fence, how many there are, and whether mathematics stands behind it. What stands in other blocks of colons is text: a note, a
/// card.
fn fence(bare: &str) -> Option<(u8, usize, bool)> {
    let mark = bare.bytes().next().filter(|b| matches!(b, b'`' | b'~' | b':'))?;
    let count = bare.bytes().take_while(|b| *b == mark).count();
    let behind = &bare[count..];
    // Of MyST: `{math}`.
    let math = behind.trim().trim_matches(['{', '}', '`']) == "math";
    let is_span = mark == b'`' && behind.contains('`');
    (count >= 3 && !is_span && (mark != b':' || math)).then_some((mark, count, math))
}

#[cfg(test)]
mod tests {
    use super::printed;

    /// What is left, without blanks.
    fn left(text: &str) -> String {
        let out = printed(text);
        assert_eq!(out.len(), text.len(), "{text}");
        out.split_whitespace().collect::<Vec<_>>().join(" ")
    }

    #[test]
    fn what_is_not_printed_is_blank() {
        assert_eq!(left("a <!-- $$f=x^3$$\n\n$g$ --> b"), "a b");
        assert_eq!(left("Text\n\n    $$f=x^3$$\n\tmore\n\n    more\nb"), "Text b");
        assert_eq!(left("Text\n    $f=x^3$"), "Text $f=x^3$", "code does not interrupt a paragraph");
        for name in ["pre", "code", "script", "STYLE", "textarea"] {
            assert_eq!(left(&format!("a\n<{name} class=\"x\">\n$f$\n\n$g$</{name}>\nb $h$")), "a b $h$", "{name}");
        }
        assert_eq!(left("<preface> $f$"), "<preface> $f$");
        assert_eq!(left("---\ntitle: $f=x^3$\n---\n$g$"), "$g$");
        assert_eq!(left("---\n\n$f$"), "--- $f$", "a line alone");
        assert_eq!(left("a `$f$ x\n$g$` b"), "a b");
        assert_eq!(left("```\n$f$\n````\n$g$"), "$g$");
        assert_eq!(left("<!-- not closed\n\n$f$"), "");
        assert_eq!(left("a < b <!- $f$"), "a < b <!- $f$");
    }

    #[test]
    fn what_belongs_to_a_list_is_no_code() {
        assert_eq!(left("- item\n\n    $$f$$\n\n    1. more\n\n        $$g$$"), "- item $$f$$ 1. more $$g$$");
        assert_eq!(left("10. item\n\n    $$f$$"), "10. item $$f$$");
        assert_eq!(left("- item\n\n      $$f$$\n\ntext\n\n    $$g$$"), "- item text");
        for block in ["!!! note", "[^1]: note", ": meaning"] {
            assert_eq!(left(&format!("{block}\n\n    $f$")), format!("{block} $f$"));
        }
        assert_eq!(left("$$\nf\n\n    +g\n$$"), "$$ f +g $$", "within mathematics there is none");
    }

    #[test]
    fn marks_of_quotations_go() {
        assert_eq!(left("> $$\n> f=x^2\n> $$\nb"), "$$ f=x^2 $$ b");
        assert_eq!(left("> > $$\n> > f\n> > > g\n>> $$"), "$$ f > g $$");
        assert_eq!(left("$$\nf\n> g\n$$"), "$$ f > g $$", "a sign of mathematics");
        assert_eq!(left("> ```math\n> f > g\n> ```\n> b"), "$$ f > g $$ b");
        assert_eq!(left(">     $$f$$"), "");
    }

    #[test]
    fn a_percent_sign_is_a_comment_in_mathematics_alone() {
        assert_eq!(left("50% of $f$, $$\nf = x % +1 $\n+2$$ b"), "50 of $f$, $$ f = x +2$$ b");
        assert_eq!(left("$f % x$ and $g$"), "$f $ and $g$");
        assert_eq!(left(r"$f\% x$ \% \$ %"), r"$f\% x$ \ \$");
        assert_eq!(left("$5 and 10% of $6, $f$"), "$5 and 10 of $6, $f$");
        assert_eq!(left("```math\nf % x\n```"), "$$ f $$");
        assert_eq!(left("\\begin{align}\nf % x\n\\end{align} %"), "\\begin{align} f \\end{align}");
        assert_eq!(left("a $`f%x`$ b"), "a $ f $ b");
    }
}
