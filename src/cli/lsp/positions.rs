//! Places of a text as an editor counts them: lines from 0, columns in UTF-16 code units from 0.

use rederive::report::Region;
use serde_json::{Value, json};

/// The place of a region.
pub(super) fn range(of: Region) -> Value {
    json!({
        "start": { "line": of.line - 1, "character": of.column - 1 },
        "end": { "line": of.end_line - 1, "character": of.end_column - 1 },
    })
}

/// The byte at which a place lies; the end of its line where it has fewer columns, the end of the text where it has fewer lines.
pub(super) fn offset(text: &str, place: &Value) -> usize {
    let number = |key: &str| place.get(key).and_then(Value::as_u64).and_then(|n| usize::try_from(n).ok()).unwrap_or(0);
    let (line, column) = (number("line"), number("character"));
    let start = match line.checked_sub(1) {
        None => 0,
        Some(before) => text.match_indices('\n').nth(before).map_or(text.len(), |(at, _)| at + 1),
    };
    let mut units = 0;
    let of_line = text[start..].split('\n').next().unwrap_or_default();
    let within = of_line.char_indices().find(|(_, c)| {
        let here = units >= column;
        units += c.len_utf16();
        here
    });
    start + within.map_or(of_line.len(), |(at, _)| at)
}

/// Whether a name stands in a text around a byte, and is not a part of a command.
pub(super) fn is_named(text: &str, at: usize, name: &str) -> bool {
    let line = text[..at].rfind('\n').map_or(0, |n| n + 1);
    let of_line = text[line..].split('\n').next().unwrap_or_default();
    let letters = |c: char| c.is_ascii_alphabetic();
    let whole = |start: usize| {
        let (before, after) = (&of_line[..start], &of_line[start + name.len()..]);
        // A letter that follows letters after a backslash is one of a command; a command ends where no letter follows.
        let in_command = name.starts_with(letters) && before.trim_end_matches(letters).ends_with('\\');
        let goes_on = name.starts_with('\\') && name.ends_with(letters) && after.starts_with(letters);
        !in_command && !goes_on
    };
    of_line.match_indices(name).any(|(start, _)| (start..=start + name.len()).contains(&(at - line)) && whole(start))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_counted_in_units_of_utf_16() {
        let text = "a\n𝛚x\n";
        let at = |line, character| offset(text, &json!({ "line": line, "character": character }));
        assert_eq!(at(1, 2), 2 + '𝛚'.len_utf8());
        assert_eq!(at(1, 9), text.len() - 1);
        assert_eq!(at(7, 0), text.len());
        assert_eq!(at(0, 0), 0);
    }

    #[test]
    fn a_name_is_no_part_of_a_command() {
        let text = r"a=\omega_{12}o\sin x^2";
        let named: Vec<&str> =
            [r"\omega_{12}", r"\omega", "o", "x", r"\si", "n"].into_iter().filter(|n| is_named(text, 4, n)).collect();
        assert_eq!(named, [r"\omega_{12}", r"\omega"]);
        assert!(is_named(text, 14, "o") && is_named(text, 19, "x") && !is_named(text, 17, "n"));
        assert!(!is_named(text, 16, r"\si") && !is_named("", 0, "x"));
    }
}
