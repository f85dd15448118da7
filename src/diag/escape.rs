//! Texts that strangers wrote, as people may see them.
//!
//! **In:** any text. **Out:** the same text, in which everything that acts instead of being seen is written as a sign.
//!
//! A title can hold an escape that clears a terminal and prints a verdict of its own, a mark that turns the reading direction,
//! a line break that starts a command in the log of a workflow. [`shown`] turns each of them into something to look at: `␛`,
//! `[U+202E]`. Every text of a file goes through it when the file is read (`derivation`, `paper`), and problems, which quote
//! files as they are, when they are printed (`diag`). So no writer of a format gets to see anything else, and a new one cannot
//! forget it. What is printed goes through [`spoken`] once more, which also keeps lines from being commands of a workflow.

use std::borrow::Cow;

/// Whether a character acts instead of being seen.
fn acts(c: char) -> bool {
    matches!(c,
        // Controls, but for those of texts; the second set of them is understood by terminals, too.
        '\0'..='\u{8}' | '\u{b}'..='\u{1f}' | '\u{7f}'..='\u{9f}'
        // Soft hyphen, marks of direction, embeddings, overrides and isolates.
        | '\u{ad}' | '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{206f}'
        // What has no width and joins no letters, fillers that look like nothing.
        | '\u{200b}' | '\u{2060}'..='\u{2061}' | '\u{2064}'..='\u{2065}' | '\u{feff}' | '\u{115f}' | '\u{1160}' | '\u{3164}'
        | '\u{ffa0}' | '\u{180e}'
        // Separators of lines and paragraphs, anchors, tags, what is no character.
        | '\u{2028}' | '\u{2029}' | '\u{fff9}'..='\u{fffb}' | '\u{fffe}' | '\u{ffff}' | '\u{e0000}'..='\u{e0fff}')
}

/// The sign for a character that acts.
fn sign(c: char, out: &mut String) {
    match u32::from(c) {
        code @ 0..=0x1f => out.extend(char::from_u32(0x2400 + code)),
        0x7f => out.push('␡'),
        code => out.push_str(&format!("[U+{code:04X}]")),
    }
}

/// The text with signs for what would act. Line breaks and tabs stay; the line break of Windows becomes a plain one.
pub fn shown(text: &str) -> Cow<'_, str> {
    if !text.chars().any(acts) {
        return Cow::Borrowed(text);
    }
    let mut out = String::with_capacity(text.len() + 8);
    let mut chars = text.chars().peekable();
    while let Some(c) = chars.next() {
        match c {
            '\r' if chars.peek() == Some(&'\n') => {}
            c if acts(c) => sign(c, &mut out),
            c => out.push(c),
        }
    }
    Cow::Owned(out)
}

/// The same with signs for line breaks and tabs, too: for words that are quoted and not read.
pub fn in_signs(text: &str) -> String {
    shown(text).replace('\n', "␤").replace('\t', "␉")
}

/// The same in one line.
pub fn in_one_line(text: &str) -> String {
    shown(text).split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The same for a part of a text that is shown with marks under it: where each byte has gone is told, too.
pub(crate) fn shown_with_places(text: &str) -> (String, impl Fn(usize) -> usize) {
    let mut out = String::with_capacity(text.len());
    // Where the text has grown: up to this byte, by so much.
    let mut grown: Vec<(usize, usize, usize)> = Vec::new();
    let mut chars = text.char_indices().peekable();
    while let Some((at, c)) = chars.next() {
        let line_break = c == '\r' && chars.peek().is_some_and(|(_, next)| *next == '\n');
        if line_break || acts(c) {
            let before = out.len();
            if !line_break {
                sign(c, &mut out);
            }
            grown.push((at, at + c.len_utf8(), out.len()));
            debug_assert!(before <= out.len());
        } else {
            out.push(c);
        }
    }
    let place = move |at: usize| match grown.iter().rev().find(|(start, ..)| *start < at) {
        // Inside what was replaced: its end.
        Some(&(_, end, new_end)) => new_end + at.saturating_sub(end),
        None => at,
    };
    (out, place)
}

/// What is printed for people: nothing acts but the colours that the program itself gives, and no line is a command of a
/// workflow, which would begin with `::` or have `##[` in it.
///
/// Colours are `ESC [ digits ; … m`; no text of a file has an escape of its own any more, see [`shown`].
pub fn spoken(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for line in text.split_inclusive('\n') {
        let mut rest = line;
        let mut begins = true;
        while let Some(c) = rest.chars().next() {
            let colour = colour(rest);
            let length = match c {
                _ if colour > 0 => {
                    out.push_str(&rest[..colour]);
                    colour
                }
                ':' if begins && rest.starts_with("::") => {
                    out.push_str(": :");
                    2
                }
                '#' if rest.starts_with("##[") || rest.starts_with("##vso[") => {
                    out.push_str("# #");
                    2
                }
                c => {
                    if acts(c) {
                        sign(c, &mut out);
                    } else {
                        out.push(c);
                    }
                    c.len_utf8()
                }
            };
            begins &= colour > 0 || c.is_whitespace();
            rest = &rest[length..];
        }
    }
    out
}

/// JSON that is the same data, and in which a log of a workflow finds no command.
pub fn in_json(text: String) -> String {
    // Texts are large, and nearly none has any.
    if !text.contains("##[") && !text.contains("##vso[") {
        return text;
    }
    text.replace("##[", r"#\u0023[").replace("##vso[", r"#\u0023vso[")
}

/// The length of the escape for a colour at the beginning of a text; 0 where there is none.
fn colour(text: &str) -> usize {
    let Some(inner) = text.strip_prefix("\u{1b}[") else { return 0 };
    let length = inner.bytes().take_while(|b| b.is_ascii_digit() || *b == b';').count();
    if inner[length..].starts_with('m') { length + 3 } else { 0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_acts_is_seen() {
        assert_eq!(shown("a\u{1b}[2J\u{7}\u{0}\u{7f}b\u{85}"), "a␛[2J␇␀␡b[U+0085]");
        assert_eq!(shown("\u{202e}gnissim\u{2069}"), "[U+202E]gnissim[U+2069]");
        assert_eq!(shown("a\r\nb\rc\n\td"), "a\nb␍c\n\td");
        assert!(matches!(shown("Größe 日本 🎾 x²\n"), Cow::Borrowed(_)));
        assert_eq!(in_one_line(" a\n::error::b\u{2028} c "), "a ::error::b[U+2028] c");
        for c in '\0'..=char::MAX {
            let text = c.to_string();
            let out = shown(&text);
            assert!(!out.chars().any(acts), "{c:?}");
            assert!(!c.is_control() || c == '\n' || c == '\t' || out != text, "{c:?}");
            assert_eq!(shown(&out), out, "{c:?}: twice is once");
        }
    }

    #[test]
    fn places_move_with_the_text() {
        let text = "a\u{1b}b\u{202e}c\r\nd";
        let (out, place) = shown_with_places(text);
        assert_eq!(out, shown(text));
        for (at, c) in text.char_indices().filter(|(_, c)| c.is_ascii_alphabetic()) {
            assert!(out[place(at)..].starts_with(c), "{c}");
        }
        assert_eq!(place(text.len()), out.len());
        for at in 0..=text.len() {
            assert!(out.is_char_boundary(place(at)), "{at}");
        }
    }

    #[test]
    fn no_line_is_a_command_and_only_colours_stay() {
        assert_eq!(spoken("  ::error::x\n\u{1b}[1m::stop::\n"), "  : :error::x\n\u{1b}[1m: :stop::\n");
        assert_eq!(spoken("a ::b ##[c] ##vso[d] # ##"), "a ::b # #[c] # #vso[d] # ##");
        assert_eq!(spoken("\u{1b}[31mred\u{1b}[0m\u{1b}[2J\u{1b}]0;x\u{7}"), "\u{1b}[31mred\u{1b}[0m␛[2J␛]0;x␇");
        assert_eq!(spoken("\u{1b}[\u{1b}[31"), "␛[␛[31");
    }
}
