//! What is left of a formula when everything is taken away that is not set.

use super::lexer::tokens;
use diag::escape::shown;

/// The text without comments, and without commands that leave nothing on the paper but have an argument (`\label{…}`,
/// `\tag{…}`): anything may stand in them, and whoever sets the text anew would read it. `None` if it is no text of the
/// formula language.
pub fn printed(text: &str) -> Option<String> {
    let mut out = String::with_capacity(text.len());
    let mut at = 0;
    for token in tokens(text).ok()? {
        // Between tokens there is what has no meaning: spaces, sizes, and the rest.
        gap(&text[at..token.span.start], &mut out);
        out.push_str(&text[token.span.clone()]);
        at = token.span.end;
    }
    let text = out.trim_start();
    let end = text.trim_end();
    // A space behind a backslash belongs to it.
    let escaped = end.bytes().rev().take_while(|&b| b == b'\\').count() % 2 == 1;
    let space = text[end.len()..].chars().next().filter(|_| escaped).map_or(0, char::len_utf8);
    Some(shown(&text[..end.len() + space]).into_owned())
}

/// What stands between two tokens, without comments and arguments.
pub(super) fn gap(text: &str, out: &mut String) {
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let mut length = c.len_utf8();
        match c {
            '%' => length = rest.find('\n').unwrap_or(rest.len()),
            '\\' => {
                let name = rest[1..].bytes().take_while(u8::is_ascii_alphabetic).count();
                let head = 1 + name.max(rest[1..].chars().next().map_or(0, char::len_utf8));
                let spaces = rest[head..].len() - rest[head..].trim_start().len();
                length = if name > 0 && rest[head + spaces..].starts_with('{') {
                    head + spaces + group(&rest[head + spaces..])
                } else {
                    out.push_str(&rest[..head]);
                    head
                };
            }
            // Any other space (a tab, the half of a line break) is a space: `shown` would make a sign of it.
            c if c.is_whitespace() && c != '\n' => out.push(' '),
            c => out.push(c),
        }
        rest = &rest[length..];
    }
}

/// The length of the group at the beginning of a text.
fn group(text: &str) -> usize {
    let mut depth = 0usize;
    for (at, b) in text.bytes().enumerate() {
        match b {
            b'{' => depth += 1,
            b'}' => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth == 0 {
            return at + 1;
        }
    }
    text.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_not_set_is_gone_and_nothing_else() {
        for (text, left) in [
            (r"x=a\label{\immediate\write18{touch X}\input{y}}", r"x=a"),
            (r"x=x\tag {]]></script>}+1", r"x=x+1"),
            ("x=a % </script>\n +b", "x=a \n +b"),
            (r"\left( x\,\right)\quad y \hspace{1em}\cr z", r"\left( x\,\right)\quad y \cr z"),
            (r"\dot x=-\frac{k}{m}x~", r"\dot x=-\frac{k}{m}x~"),
            ("10^{\r12}=0", "10^{ 12}=0"),
            ("x\n\\ \\ ", "x\n\\ \\ "),
            ("", ""),
        ] {
            assert_eq!(printed(text).as_deref(), Some(left), "{text}");
        }
        assert_eq!(printed("é"), None);
        assert_eq!(printed(r"\label{"), None);
    }
}
