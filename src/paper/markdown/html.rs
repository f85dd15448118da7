//! HTML in a page: comments, elements that are not printed, tags.
//!
//! **In:** the place of a sign `<`. **Out:** blanks in the place of what is not printed. **Guaranteed:** what is no tag stays as it is; what begins a
//! line and is not closed hides all behind it, as in browsers.

use std::ops::Range;

use super::Page;

/// Elements in which nothing is a formula, and no element stands.
const CODE: &[&str] =
    &["pre", "code", "script", "style", "textarea", "noscript", "title", "iframe", "xmp", "noembed", "noframes"];
/// Elements that are not printed as text, or struck out, with all that stands in them.
const NOT_PRINTED: &[&str] =
    &["template", "svg", "head", "object", "canvas", "audio", "video", "datalist", "del", "s", "strike"];
/// Elements that have no end.
const VOID: &[&str] =
    &["area", "base", "br", "col", "embed", "hr", "img", "input", "link", "meta", "source", "track", "wbr"];
/// The longest tag, in bytes.
const LONGEST: usize = 10_000;

/// A tag.
struct Tag {
    name: String,
    /// Its bytes.
    length: usize,
    /// What stands in it is not printed: it is hidden, or ends with itself.
    is_hidden: bool,
    is_closed: bool,
}

/// Signs that are written in mathematics as in HTML, and what they are in LaTeX, which is no longer.
const ENTITIES: &[(&str, &str)] = &[
    ("&lt;", "<"),
    ("&gt;", ">"),
    ("&amp;", "&"),
    ("&equals;", "="),
    ("&plus;", "+"),
    ("&minus;", "-"),
    ("&nbsp;", " "),
    ("&le;", r"\le "),
    ("&ge;", r"\ge "),
    ("&ne;", r"\ne "),
    ("&times;", r"\times "),
    ("&middot;", r"\cdot "),
    ("&lpar;", "("),
    ("&rpar;", ")"),
    ("&lowbar;", "_"),
    ("&Hat;", "^"),
    ("&bsol;", r"\"),
    ("&#39;", "'"),
    ("&#42;", "*"),
    ("&#95;", "_"),
    ("&#60;", "<"),
    ("&#61;", "="),
    ("&#62;", ">"),
];

/// Where these stand in a text.
pub(super) fn entities(text: &str) -> Vec<(usize, &'static str, &'static str)> {
    let at =
        |i: usize| ENTITIES.iter().find(|(name, _)| text[i..].starts_with(name)).map(|(name, sign)| (i, *name, *sign));
    text.match_indices('&').filter_map(|(i, _)| at(i)).collect()
}

impl Page<'_> {
    /// A comment, an element that is not printed, or a tag.
    pub(super) fn html(&mut self, at: usize, begins_line: bool) -> usize {
        let rest = &self.text[at..];
        let is_element = |name: &&&str| {
            let behind =
                rest.get(1..=name.len()).filter(|n| n.eq_ignore_ascii_case(name)).map(|_| &rest[1 + name.len()..]);
            behind.is_some_and(|b| b.starts_with(|c: char| c == '>' || c.is_whitespace()))
        };
        let raw = [("<!--", "-->"), ("<?", "?>"), ("<![CDATA[", "]]>")];
        let closing = match CODE.iter().find(is_element) {
            Some(name) => format!("</{name}>"),
            None => match raw.iter().find(|(open, _)| rest.starts_with(open)) {
                Some((_, close)) => (*close).to_owned(),
                None => return self.tag(at, begins_line),
            },
        };
        let all = &self.text.as_bytes()[at..];
        let is_here = |w: &[u8]| w.eq_ignore_ascii_case(closing.as_bytes());
        let key = (closing.clone(), self.text.len());
        let found = if self.unclosed.contains(&key) { None } else { all.windows(closing.len()).position(is_here) };
        let end = match found {
            Some(found) => found + closing.len(),
            None if begins_line && closing != "</code>" => all.len(),
            None => {
                self.unclosed.insert(key);
                return at + 1;
            }
        };
        self.blank(at..at + end);
        if found.is_some() && closing == "</script>" {
            self.formula_of_script(at..at + end, closing.len());
        }
        at + end
    }

    /// `<script type="math/tex; mode=display">…</script>`: a formula, as between dollars.
    fn formula_of_script(&mut self, place: Range<usize>, closing: usize) {
        let element = &self.text[place.clone()];
        let Some(tag) = tag(element) else { return };
        let attributes = element[..tag.length].to_ascii_lowercase();
        let (from, to) = (place.start + tag.length, place.end - closing);
        if !attributes.contains("math/tex")
            || self.text[from..to].contains('$')
            || self.text[from..to].trim().is_empty()
        {
            return;
        }
        let sign: &[u8] = if attributes.contains("mode=display") { b"$$" } else { b"$" };
        self.out[from - sign.len()..from].copy_from_slice(sign);
        self.out[from..to].copy_from_slice(&self.text.as_bytes()[from..to]);
        self.out[to..to + sign.len()].copy_from_slice(sign);
        let mut line = from;
        while line < to {
            let next = self.end_of_line_within(line..to);
            self.without_comment(line..next);
            line = next;
        }
    }

    /// A tag, of which nothing is printed; or an element that is not printed.
    fn tag(&mut self, at: usize, begins_line: bool) -> usize {
        let most = self.end_of_paragraph(at);
        if let Some(length) = address(&self.text[at..most]) {
            self.blank(at..at + length);
            return at + length;
        }
        let Some(tag) = tag(&self.text[at..most]) else { return at + 1 };
        let behind = at + tag.length;
        let is_void = tag.is_closed || VOID.contains(&tag.name.as_str());
        if (tag.is_hidden || NOT_PRINTED.contains(&tag.name.as_str())) && !is_void {
            let key = (format!("</{}", tag.name), self.text.len());
            let end = if self.unclosed.contains(&key) { None } else { self.element_end(behind, &tag.name) };
            match end {
                Some(end) => {
                    self.blank(at..end);
                    return end;
                }
                None if begins_line => {
                    self.blank(at..self.text.len());
                    return self.text.len();
                }
                None => drop(self.unclosed.insert(key)),
            }
        }
        if self.text[at..behind].contains(['$', '\\', '`']) {
            self.blank(at..behind);
        }
        behind
    }

    /// Where the element ends whose content begins at a place; elements of its name may stand in it.
    fn element_end(&self, from: usize, name: &str) -> Option<usize> {
        let (mut depth, mut at) = (1usize, from);
        while let Some(found) = self.text[at..].find('<') {
            let begin = at + found + 1;
            let rest = &self.text[begin..];
            let (closes, rest) = rest.strip_prefix('/').map_or((false, rest), |rest| (true, rest));
            at = begin;
            let is_it = rest.get(..name.len()).is_some_and(|n| n.eq_ignore_ascii_case(name))
                && rest[name.len()..].starts_with(|c: char| matches!(c, '>' | '/') || c.is_whitespace());
            if is_it {
                let end = rest.find('>').map_or(rest.len(), |i| i + 1);
                at = self.text.len() - rest.len() + end;
                match closes {
                    true => depth -= 1,
                    false => depth += usize::from(!rest[..end].ends_with("/>")),
                }
            }
            if depth == 0 {
                return Some(at);
            }
        }
        None
    }
}

/// The length of an address between angle brackets, `<https://…>`.
fn address(text: &str) -> Option<usize> {
    let inside = &text.get(1..)?;
    let end = inside.bytes().take(LONGEST).position(|b| b == b'>' || b == b'<' || b.is_ascii_whitespace())?;
    let (scheme, _) = inside.get(..end)?.split_once(':')?;
    let is_scheme = (2..=32).contains(&scheme.len())
        && scheme.starts_with(|c: char| c.is_ascii_alphabetic())
        && scheme.chars().all(|c| c.is_ascii_alphanumeric() || matches!(c, '+' | '.' | '-'));
    (is_scheme && inside[end..].starts_with('>')).then_some(end + 2)
}

/// The tag with which a text begins.
fn tag(text: &str) -> Option<Tag> {
    let text = text.get(..LONGEST).unwrap_or(text);
    let behind = text.strip_prefix('<')?;
    let behind = behind.strip_prefix('/').unwrap_or(behind);
    let length = behind.bytes().take_while(|b| b.is_ascii_alphanumeric() || *b == b'-').count();
    if !behind.starts_with(|c: char| c.is_ascii_alphabetic()) {
        return None;
    }
    let name = behind[..length].to_ascii_lowercase();
    let mut rest = &behind[length..];
    let mut is_hidden = false;
    loop {
        let next = rest.trim_start();
        if let Some(after) = next.strip_prefix('>').or_else(|| next.strip_prefix("/>")) {
            let is_closed = next.starts_with('/') || text.starts_with("</");
            return Some(Tag { name, length: text.len() - after.len(), is_hidden, is_closed });
        }
        let is_key = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | ':' | '.' | '-' | '@');
        let key = &next[..next.len() - next.trim_start_matches(is_key).len()];
        // Attributes stand behind spaces.
        if key.is_empty() || next.len() == rest.len() {
            return None;
        }
        let (value, after) = value(&next[key.len()..])?;
        let style = value.replace(|c: char| c.is_whitespace(), "").to_ascii_lowercase();
        is_hidden |= key.eq_ignore_ascii_case("hidden");
        let hides = ["display:none", "visibility:hidden"].iter().any(|style_of| style.contains(style_of));
        is_hidden |= key.eq_ignore_ascii_case("style") && hides;
        rest = after;
    }
}

/// The value of an attribute, empty where it has none, and what follows it; `None` where it is none.
fn value(text: &str) -> Option<(&str, &str)> {
    let Some(behind) = text.trim_start().strip_prefix('=').map(str::trim_start) else { return Some(("", text)) };
    if let Some(quote) = behind.chars().next().filter(|c| matches!(c, '"' | '\'')) {
        return behind[1..].split_once(quote);
    }
    let length = behind.find(|c: char| c.is_whitespace() || "\"'=<>`".contains(c)).unwrap_or(behind.len());
    (length > 0).then(|| behind.split_at(length))
}
