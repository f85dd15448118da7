//! Places of a text as an editor counts them: lines from 0, columns in UTF-16 code units from 0.

use std::ops::Range;

use rederive::report::Region;
use serde_json::{Value, json};

/// The place of a region.
pub(super) fn range(of: Region) -> Value {
    json!({
        "start": { "line": of.line - 1, "character": of.column - 1 },
        "end": { "line": of.end_line - 1, "character": of.end_column - 1 },
    })
}

/// The bytes of the range that is asked about; the whole text where none is.
pub(super) fn bytes(text: &str, params: &Value) -> Range<usize> {
    let place = |key: &str, none: usize| params.pointer(key).map_or(none, |place| offset(text, place));
    place("/range/start", 0)..place("/range/end", text.len())
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
}
