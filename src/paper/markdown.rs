//! Markdown: what is printed of it, and where its mathematics stands.
//!
//! **In:** the text of a file. **Out:** a text of the same length with blanks in the place of what is not printed, or not as a formula: code,
//! comments, blocks of HTML that hold code, what stands before the text between `---`, the marks of quotations. Blocks of mathematics
//! become displays. **Guaranteed:** all other places stay; a percent sign begins a comment within mathematics alone.

mod blocks;
mod html;
mod links;

use std::collections::{HashMap, HashSet};
use std::ops::Range;

use blocks::{Fence, Fenced, columns_from, fence, is_drawn_line, item};

/// What opens mathematics within a text, and what closes it.
const MATH: &[(&str, &str)] = &[
    ("$$", "$$"),
    ("$", "$"),
    (r"\[", r"\]"),
    (r"\(", r"\)"),
    // Where Markdown takes a backslash away first.
    (r"\\[", r"\\]"),
    (r"\\(", r"\\)"),
    (r"\begin{", r"\end{"),
];
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
        directives: Vec::new(),
        may_have_options: false,
        before: Before::Blank,
        paragraph_end: 0,
        quotation_end: 0,
        brackets: (0, HashMap::new()),
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
    /// The fences of the directives that are open here, whose text is printed.
    directives: Vec<Fence>,
    /// Whether the options of a directive may stand here.
    may_have_options: bool,
    before: Before,
    /// Where the paragraph ends that was looked at last.
    paragraph_end: usize,
    /// The same of a quotation.
    quotation_end: usize,
    /// The end of the paragraph whose brackets are known, and where each is closed.
    brackets: (usize, HashMap<usize, usize>),
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
        let item = self.items.last().copied().unwrap_or_default();
        while depth < most {
            let rest = &self.text[at..];
            let spaces = rest.len() - rest.trim_start_matches(' ').len();
            if spaces >= item + INDENT || !rest[spaces..].starts_with('>') {
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
        if self.takes_option(at..end, bare) {
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
        if is_drawn_line(bare) {
            self.before = Before::Blank;
            return end;
        }
        let begins = end - bare.len();
        let (begin, indent, depth, is_code) = self.marks(begins, end, indent, depth);
        if is_code {
            self.blank(begin..end);
            self.before = Before::Text;
            return end;
        }
        let is_apart = is_apart || begin > begins;
        self.before = Before::Text;
        let bare = &self.text[begin..end];
        if self.directives.last().is_some_and(|open| open.is_closed_by(bare)) {
            self.directives.pop();
            self.blank(begin..end);
            self.before = Before::Blank;
            return end;
        }
        if let Some((fence, what)) = fence(bare) {
            self.before = Before::Blank;
            let column = if begin > begins { indent } else { own };
            return match what {
                Fenced::Text { length } => {
                    self.blank(begin..begin + length);
                    self.may_have_options = true;
                    self.directives.extend((fence.mark != b':').then_some(fence));
                    self.inline(begin + length, end, depth)
                }
                what => self.fenced(begin..end, (depth, column), fence, what == Fenced::Math),
            };
        }
        let comment = self.comment(begin);
        if let Some(after) = comment.or_else(|| self.definition(begin, depth).filter(|_| is_apart)) {
            self.blank(begin..after);
            self.before = Before::Blank;
            return after;
        }
        if bare.starts_with('#') {
            self.before = Before::Blank;
        }
        self.inline(begin, end, depth)
    }

    /// Passes over the marks of items, and of quotations in them, that begin a line: where its text begins, and in which column, how deep it is
    /// quoted, and whether it is code.
    fn marks(&mut self, from: usize, end: usize, indent: usize, depth: usize) -> (usize, usize, usize, bool) {
        let (mut at, mut column, mut depth) = (from, indent, depth);
        loop {
            let bare = &self.text[at..end];
            if at > from && bare.starts_with('>') {
                let (after, more) = self.quoted(at, usize::MAX);
                self.blank(at..after);
                column += after - at;
                (at, depth) = (after, depth + more);
                continue;
            }
            let Some(item) = item(bare, column) else { break };
            self.items.retain(|other| *other <= column);
            self.items.push(item.column);
            if item.is_code {
                return (at + item.length, item.column, depth, true);
            }
            if item.length == 0 {
                break;
            }
            (at, column) = (at + item.length, item.column);
        }
        (at, column, depth, false)
    }

    /// Whether a line is an option of the directive that begins above it, `:class: tip`, or between `---`: nothing of it is printed.
    fn takes_option(&mut self, line: Range<usize>, bare: &str) -> bool {
        if !self.may_have_options {
            return false;
        }
        let is_option = bare.strip_prefix(':').is_some_and(|rest| !rest.starts_with(':') && rest.contains(':'));
        if is_option {
            self.blank(line);
        } else {
            self.may_have_options = false;
        }
        is_option
    }

    /// A block between fences, which ends with the quotation, or the item, in which it stands.
    fn fenced(&mut self, first: Range<usize>, within: (usize, usize), fence: Fence, math: bool) -> usize {
        let (depth, column) = within;
        self.fence_line(first.clone(), math);
        let mut at = first.end;
        // Whether the options of a block of mathematics may stand here, `:label: energy`.
        let mut options = math;
        while at < self.text.len() {
            let (begin, found) = self.quoted(at, depth);
            let end = self.end_of_line(begin);
            let line = &self.text[begin..end];
            let bare = line.trim_start();
            let is_left = !bare.is_empty() && columns(&line[..line.len() - bare.len()]) < column && found == depth;
            if found < depth || is_left && depth == 0 {
                if math {
                    self.ended_by_its_quotation(first, at);
                }
                return at;
            }
            self.blank(at..begin);
            if fence.is_closed_by(bare) {
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

    /// Mathematics whose fence is not closed where what it stands in ends: its display is closed in the place of line breaks, where there is room.
    fn ended_by_its_quotation(&mut self, first: Range<usize>, end: usize) {
        let from = end - 1;
        let room = if self.text[end..].starts_with('\n') { from..end + 1 } else { from - 1..from + 1 };
        let is_free = self.out[room.clone()].iter().all(|b| b.is_ascii_whitespace());
        match is_free && room.start > first.end {
            true => self.out[room].copy_from_slice(b"$$"),
            false => self.blank(first.start..end),
        }
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
                b'{' if rest.starts_with("{math}`") => self.role(at),
                b'{' if rest.starts_with("{%") => self.liquid_comment(at),
                b'~' if rest.starts_with("~~") => self.struck_out(at),
                b'<' => self.html(at, is_first),
                b'!' if rest.starts_with("![") => self.image(at),
                b']' if rest.starts_with("](") => self.destination(at),
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
            let bare = self.text[at..end].trim_matches(|c: char| c.is_whitespace() || c == '>');
            if bare.is_empty() || bare.starts_with("```") || bare.starts_with("~~~") {
                return at;
            }
            at = end;
        }
        at
    }

    /// Where the quotation ends that a place is in: at a line without text and without its mark.
    fn end_of_quotation(&mut self, from: usize) -> usize {
        if from < self.quotation_end {
            return self.quotation_end;
        }
        let mut at = self.end_of_line(from);
        while at < self.text.len() && !self.text[at..self.end_of_line(at)].trim().is_empty() {
            at = self.end_of_line(at);
        }
        self.quotation_end = at;
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

    /// A formula of MyST, {math}`…`: as between dollars.
    fn role(&mut self, at: usize) -> usize {
        let open = at + "{math}".len();
        let end = self.end_of_paragraph(at);
        let close = self.text[open + 1..end].find('`').map(|i| open + 1 + i);
        let Some(close) = close.filter(|close| !self.text[open + 1..*close].trim().is_empty()) else {
            return self.code_span(open);
        };
        if self.text[open + 1..close].contains('$') {
            return self.code_span(open);
        }
        self.blank(at..open);
        (self.out[open], self.out[close]) = (b'$', b'$');
        let mut line = open + 1;
        while line < close {
            let next = self.end_of_line_within(line..close);
            self.without_comment(line..next);
            line = next;
        }
        close + 1
    }

    /// `~~…~~`: what is struck out says nothing. The signs touch what they strike out.
    fn struck_out(&mut self, at: usize) -> usize {
        let end = self.end_of_paragraph(at);
        let rest = &self.text[at..end];
        let signs = rest.bytes().take_while(|b| *b == b'~').count();
        let key = ("~~".to_owned(), end);
        if self.unclosed.contains(&key) {
            return at + signs;
        }
        let touches = |text: &str| !text.is_empty() && !text.ends_with(char::is_whitespace) && !text.ends_with('~');
        let mut all = rest.match_indices("~~").skip(1);
        let close = all.find(|(i, _)| touches(&rest[..*i]) && !rest[i + 2..].starts_with('~')).map(|(i, _)| i);
        let is_open = signs == 2 && rest[2..].starts_with(|c: char| !c.is_whitespace());
        if close.is_none() {
            self.unclosed.insert(key);
        }
        match close.filter(|_| is_open) {
            Some(close) => {
                self.blank(at..at + close + 2);
                at + close + 2
            }
            None => at + signs,
        }
    }

    /// `{% comment %}…{% endcomment %}` of Liquid.
    fn liquid_comment(&mut self, at: usize) -> usize {
        let tag = |text: &str, name: &str| {
            let rest = text.strip_prefix("{%")?.trim_start_matches('-').trim_start();
            let rest = rest.strip_prefix(name)?.trim_start().trim_start_matches('-');
            rest.strip_prefix("%}").map(|rest| text.len() - rest.len())
        };
        let rest = &self.text[at..];
        let Some(begin) = tag(rest, "comment") else { return at + 1 };
        let key = ("endcomment".to_owned(), self.text.len());
        let ends = |(i, _): (usize, &str)| tag(&rest[begin + i..], "endcomment").map(|length| begin + i + length);
        let end = if self.unclosed.contains(&key) { None } else { rest[begin..].match_indices("{%").find_map(ends) };
        let Some(end) = end else {
            self.unclosed.insert(key);
            return at + 1;
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
        let most = match *open {
            "$" | r"\(" | r"\\(" | r"\\[" => self.end_of_paragraph(at),
            _ if depth > 0 => self.end_of_quotation(at),
            _ => self.text.len(),
        };
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
        if is_money {
            // It opens nothing for who reads on.
            self.blank(at..from);
        }
        if inside.is_empty() || is_money {
            return from;
        }
        if open.starts_with(r"\\") {
            self.blank(at..at + 1);
            self.blank(end..end + 1);
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

    /// A line of mathematics without the comment at its end, and with the signs that are written as in HTML.
    fn without_comment(&mut self, line: Range<usize>) {
        for (at, name, sign) in html::entities(&self.text[line.clone()]) {
            let from = line.start + at;
            self.blank(from..from + name.len());
            self.out[from..from + sign.len()].copy_from_slice(sign.as_bytes());
        }
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

/// The width of spaces at the beginning of a line.
fn columns(spaces: &str) -> usize {
    columns_from(0, spaces)
}

#[cfg(test)]
mod tests;
