//! Data of the page, packed: compressed, and written in characters that need no escape.
//!
//! **In:** a text. **Out:** its zlib stream (RFC 1950) in base 85: four bytes are five digits, the first the most significant;
//! k bytes that are left over at the end are k + 1 digits, with zero bytes in place of those that are missing. The script reads
//! it with `DecompressionStream`, which every browser has had since 2023.
//!
//! **Why `miniz_oxide`:** the curves of some thousand pairs are most of what the script needs, and a page has to stay small enough
//! to be attached to a letter. It is plain Rust, and gives the same bytes on every machine.

use miniz_oxide::deflate::compress_to_vec_zlib;

/// Digits of packed values. None of them ends an element or begins a reference to a character.
pub(super) const DIGITS: &[u8; 85] =
    b"0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz!#$%()*+,-./:;=?@[]^_{|";

/// How hard the compressor tries, of 10: more takes longer and saves less than a hundredth.
const EFFORT: u8 = 7;

/// The text, compressed.
pub(super) fn packed(text: &str) -> String {
    digits(&compress_to_vec_zlib(text.as_bytes(), EFFORT))
}

/// One digit.
pub(super) fn digit(value: usize) -> char {
    DIGITS.get(value).copied().map_or('0', char::from)
}

fn digits(bytes: &[u8]) -> String {
    let mut out = String::with_capacity(bytes.len() / 4 * 5 + 5);
    for chunk in bytes.chunks(4) {
        let word = (0..4).fold(0, |word, i| 256 * word + chunk.get(i).map_or(0, |b| usize::from(*b)));
        let all = [word / 85_usize.pow(4), word / 85_usize.pow(3), word / 85_usize.pow(2), word / 85, word];
        out.extend(all.iter().take(chunk.len() + 1).map(|d| digit(d % 85)));
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What the script does.
    fn undone(text: &str) -> Vec<u8> {
        let value = |c: u8| DIGITS.iter().position(|d| *d == c).expect("a digit") as u64;
        let mut out = Vec::new();
        for chunk in text.as_bytes().chunks(5) {
            let word = (0..5).fold(0, |word, i| 85 * word + chunk.get(i).map_or(84, |c| value(*c)));
            let bytes = u32::try_from(word).expect("four bytes").to_be_bytes();
            out.extend_from_slice(&bytes[..chunk.len() - 1]);
        }
        out
    }

    #[test]
    fn bytes_come_back() {
        for n in 0..40_usize {
            for bytes in [vec![0; n], vec![255; n], (0..n).map(|i| (i * 89) as u8).collect()] {
                assert_eq!(undone(&digits(&bytes)), bytes);
            }
        }
        let text = "</script> & <!-- ' \" \u{2028}".repeat(50);
        let packed = packed(&text);
        assert!(packed.len() < text.len() && !packed.contains(['<', '&', '"', '\'', '\\', '>']));
        let back = miniz_oxide::inflate::decompress_to_vec_zlib(&undone(&packed)).expect("a stream");
        assert_eq!(String::from_utf8(back).expect("text"), text);
    }
}
