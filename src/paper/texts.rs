//! Bytes of a file as the text that is read.
//!
//! **In:** bytes, or a text. **Out:** a text in which each line ends with a line feed. **Guaranteed:** places stay.

/// Largest size of a paper, in bytes.
pub const LARGEST_PAPER: u64 = 16 << 20;

/// What bytes are that are no text in UTF-8, nor in ISO 8859-1.
pub fn no_text(bytes: &[u8]) -> Option<&'static str> {
    if bytes.starts_with(b"%PDF-") {
        Some("a PDF: the LaTeX source of the paper is read")
    } else if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
        Some("in UTF-16: save it in UTF-8")
    } else {
        bytes.contains(&0).then_some("no text: it has bytes that are 0")
    }
}

/// The text of a file: UTF-8, or else ISO 8859-1, as older papers are.
pub(super) fn text_from(bytes: Vec<u8>) -> String {
    let text = String::from_utf8(bytes).unwrap_or_else(|e| e.as_bytes().iter().map(|b| char::from(*b)).collect());
    with_plain_ends(text)
}

/// A text in which each line ends as here: a carriage return alone, as of old Macintoshes, ends one, for TeX and for editors. Places stay.
pub fn with_plain_ends(text: String) -> String {
    if !text.contains('\r') {
        return text;
    }
    let mut bytes = text.into_bytes();
    for at in 0..bytes.len() {
        if bytes.get(at) == Some(&b'\r') && bytes.get(at + 1) != Some(&b'\n') {
            bytes[at] = b'\n';
        }
    }
    // One byte of ASCII stands in the place of another.
    String::from_utf8(bytes).unwrap_or_default()
}
