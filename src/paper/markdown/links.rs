//! Links and pictures: of a link its text is printed, of a picture nothing that is a formula; of a definition nothing at all.
//!
//! **In:** the places of brackets. **Out:** blanks in the place of addresses, titles, and what is said in the place of a picture. **Guaranteed:**
//! brackets that are no link stay: an address has no space, and a title stands between quotes, but for what is written as a comment.

use std::collections::HashMap;

use super::Page;

/// The longest address, and the longest title, in bytes.
const LONGEST: usize = 2_000;
/// The most parentheses in each other in an address, as in the standard.
const DEEPEST: usize = 32;

impl Page<'_> {
    /// `![…](…)` or `![…][…]`: what is said of a picture is not printed beside it.
    pub(super) fn image(&mut self, at: usize) -> usize {
        let Some(close) = self.bracket_end(at + 1) else { return at + 2 };
        let behind = close + 1;
        let end = match self.text.as_bytes().get(behind) {
            Some(b'(') => self.link_end(behind),
            Some(b'[') => self.bracket_end(behind).map(|end| end + 1),
            _ => None,
        };
        let Some(end) = end else { return at + 2 };
        self.blank(at..end);
        end
    }

    /// `](…)`: where a link leads is not printed.
    pub(super) fn destination(&mut self, at: usize) -> usize {
        let Some(end) = self.link_end(at + 1) else { return at + 1 };
        self.blank(at + 1..end);
        end
    }

    /// `[name]: address "title"`, which is not printed: the place behind its line.
    pub(super) fn definition(&self, at: usize, depth: usize) -> Option<usize> {
        let text = self.text;
        let label = text[at..].strip_prefix('[').filter(|rest| !rest.starts_with('^'))?;
        let close = label.bytes().take(LONGEST).position(|b| matches!(b, b']' | b'[' | b'\n'))?;
        let behind = label[close..].strip_prefix("]:").filter(|_| !label[..close].trim().is_empty())?;
        let from = text.len() - behind.len();
        // What goes on in the next line does so in quotations, too, behind a mark.
        let goes_on = |at: usize| self.behind_spaces(at, depth == 0);
        let address = goes_on(from);
        let end = address_end(text, address).filter(|end| *end > address)?;
        let ends_line = |at: usize| {
            let rest = self.behind_spaces(at, false);
            (rest == text.len() || text[rest..].starts_with(['\n', '\r'])).then(|| self.end_of_line(rest))
        };
        let title = goes_on(end);
        let titled = title_end(text, title).filter(|_| title > end).and_then(ends_line);
        titled.or_else(|| ends_line(end))
    }

    /// `[//]: # (…)`, `[comment]: <> (…)`: what is written in the place of a comment, which no Markdown has, to the parenthesis that closes it,
    /// or to the end of the line. The place behind its line.
    pub(super) fn comment(&self, at: usize) -> Option<usize> {
        let rest = &self.text[at..];
        let rest = ["[//]:", "[comment]:", "[Comment]:", "[_]:"].iter().find_map(|label| rest.strip_prefix(label))?;
        let rest = rest.trim_start_matches([' ', '\t']);
        let rest = ["#", "<>"].iter().find_map(|address| rest.strip_prefix(address))?;
        let open = self.text.len() - rest.trim_start_matches([' ', '\t']).len();
        let line = self.end_of_line(open);
        let mut depth = 0usize;
        let signs = self.text[open..].bytes().take(LONGEST).enumerate();
        let begins = self.text[open..].starts_with('(');
        let close = signs.filter(|_| begins).find_map(|(i, byte)| {
            match byte {
                b'(' => depth += 1,
                b')' => depth = depth.saturating_sub(1),
                _ => {}
            }
            (depth == 0).then_some(open + i)
        });
        Some(close.map_or(line, |close| self.end_of_line(close)))
    }

    /// The place behind spaces, and behind the end of one line where that may be.
    fn behind_spaces(&self, at: usize, over_line: bool) -> usize {
        let blank = |at: usize| self.text.len() - self.text[at..].trim_start_matches([' ', '\t', '\r']).len();
        let here = blank(at);
        match self.text[here..].strip_prefix('\n').filter(|_| over_line) {
            Some(next) => blank(self.text.len() - next.len()),
            None => here,
        }
    }

    /// Where `(address "title")` ends.
    fn link_end(&mut self, open: usize) -> Option<usize> {
        let most = self.end_of_paragraph(open);
        let address = self.behind_spaces(open + 1, true);
        let after = address_end(self.text, address)?;
        let title = self.behind_spaces(after, true);
        let titled = title_end(self.text, title).filter(|_| title > after);
        let close = self.behind_spaces(titled.unwrap_or(after), true);
        (close < most && self.text[close..].starts_with(')')).then_some(close + 1)
    }

    /// The bracket that closes the one at a place, in its paragraph.
    fn bracket_end(&mut self, open: usize) -> Option<usize> {
        let end = self.end_of_paragraph(open);
        if open >= self.brackets.0 {
            self.brackets = (end, brackets(&self.text[open..end], open));
        }
        self.brackets.1.get(&open).copied()
    }
}

/// The brackets of a text that begins at a place, each with the one that closes it; those in code and in formulas are none.
fn brackets(text: &str, base: usize) -> HashMap<usize, usize> {
    let (mut out, mut open) = (HashMap::new(), Vec::new());
    let bytes = text.as_bytes();
    // Signs behind which none of the same follows.
    let (mut has_tick, mut has_dollar) = (true, true);
    let mut at = 0;
    while let Some(byte) = bytes.get(at) {
        match byte {
            b'\\' => at += 1,
            b'`' | b'$' => {
                let left = if *byte == b'$' { &mut has_dollar } else { &mut has_tick };
                let next = bytes[at + 1..].iter().position(|b| b == byte).filter(|_| *left);
                *left &= next.is_some();
                at += next.map_or(0, |next| next + 1);
            }
            b'[' => open.push(at),
            b']' => out.extend(open.pop().map(|from| (base + from, base + at))),
            _ => {}
        }
        at += 1;
    }
    out
}

/// Where an address ends that begins at a place; there, where none does.
fn address_end(text: &str, at: usize) -> Option<usize> {
    let rest = &text.as_bytes()[at..];
    if rest.first() == Some(&b'<') {
        let close = rest.iter().skip(1).take(LONGEST).position(|b| matches!(b, b'>' | b'<' | b'\n'))? + 1;
        return (rest[close] == b'>').then_some(at + close + 1);
    }
    let (mut depth, mut escaped) = (0usize, false);
    for (i, byte) in rest.iter().enumerate().take(LONGEST) {
        match byte {
            b if b.is_ascii_whitespace() => return Some(at + i),
            _ if escaped => escaped = false,
            b'\\' => escaped = true,
            b'(' if depth >= DEEPEST => return None,
            b'(' => depth += 1,
            b')' if depth == 0 => return Some(at + i),
            b')' => depth -= 1,
            _ => {}
        }
    }
    (rest.len() <= LONGEST).then_some(at + rest.len())
}

/// Where a title ends that begins at a place, in its paragraph.
fn title_end(text: &str, at: usize) -> Option<usize> {
    let rest = &text.as_bytes()[at..];
    let close = match rest.first()? {
        b'"' => b'"',
        b'\'' => b'\'',
        b'(' => b')',
        _ => return None,
    };
    let (mut escaped, mut line_is_empty) = (false, false);
    for (i, byte) in rest.iter().enumerate().skip(1).take(LONGEST) {
        match byte {
            b'\n' if line_is_empty => return None,
            _ if escaped => escaped = false,
            b'\\' => escaped = true,
            b'(' if close == b')' => return None,
            b if *b == close => return Some(at + i + 1),
            _ => {}
        }
        line_is_empty = *byte == b'\n' || line_is_empty && byte.is_ascii_whitespace();
    }
    None
}
