//! How a draft spells texts, and a paper the places of a function: `\dot q`, `\mathbf{x}`, `0`.
//!
//! **In:** a place as it is printed. **Out:** what stands under its dots, and whether it is a name, or a vector by its style; a text
//! in the quotes of TOML.

use super::super::names::letters::BOLD;

/// What stands under the dots of a place.
pub(super) fn bare(place: &str) -> &str {
    let Some(inside) = place.strip_prefix(r"\ddot").or_else(|| place.strip_prefix(r"\dot")) else { return place };
    let inside = inside.trim();
    inside.strip_prefix('{').and_then(|s| s.strip_suffix('}')).unwrap_or(inside)
}

/// A name that may stand in the place of a function.
pub(super) fn is_name(place: &str) -> bool {
    !place.is_empty() && !place.chars().all(|c| c.is_ascii_digit())
}

/// Whether the style of a place is that of vectors.
pub(super) fn is_vector(place: &str) -> bool {
    BOLD.iter().any(|style| place.contains(&format!("\\{style}")))
}

/// A text in double quotes.
pub(super) fn quoted(text: &str) -> String {
    let mut out = String::from('"');
    for c in text.chars() {
        match c {
            '"' | '\\' => {
                out.push('\\');
                out.push(c);
            }
            c if c.is_control() => out.push(' '),
            c => out.push(c),
        }
    }
    out.push('"');
    out
}
