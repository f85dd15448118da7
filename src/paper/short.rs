//! Short texts: what a token or a mark says, nearly always one letter or one command.
//!
//! **In:** a text. **Out:** [`Short`], which is read like a `str`. **Why:** a paper has millions of tokens, and a `String` takes memory of its
//! own beside its place in the token; a text of up to 22 bytes takes none here.

use std::fmt;
use std::ops::Deref;

/// The longest text that stands in its place.
const INLINE: usize = 22;

/// A text, short in nearly all cases.
#[derive(Clone)]
pub(super) struct Short(Stored);

#[derive(Clone)]
enum Stored {
    Inline { length: u8, bytes: [u8; INLINE] },
    Long(Box<str>),
}

impl Short {
    /// The text.
    pub fn as_str(&self) -> &str {
        match &self.0 {
            // What was put there is the beginning of nothing: a whole text.
            Stored::Inline { length, bytes } => std::str::from_utf8(&bytes[..usize::from(*length)]).unwrap_or_default(),
            Stored::Long(text) => text,
        }
    }
}

impl From<&str> for Short {
    fn from(text: &str) -> Short {
        if text.len() > INLINE {
            return Short(Stored::Long(text.into()));
        }
        let mut bytes = [0; INLINE];
        bytes[..text.len()].copy_from_slice(text.as_bytes());
        Short(Stored::Inline { length: text.len() as u8, bytes })
    }
}

impl From<char> for Short {
    fn from(c: char) -> Short {
        Short::from(&*c.encode_utf8(&mut [0; 4]))
    }
}

impl From<String> for Short {
    fn from(text: String) -> Short {
        Short::from(text.as_str())
    }
}

impl From<Short> for String {
    fn from(text: Short) -> String {
        text.as_str().to_owned()
    }
}

impl Deref for Short {
    type Target = str;

    fn deref(&self) -> &str {
        self.as_str()
    }
}

impl PartialEq for Short {
    fn eq(&self, other: &Short) -> bool {
        self.as_str() == other.as_str()
    }
}

impl Eq for Short {}

impl PartialEq<str> for Short {
    fn eq(&self, other: &str) -> bool {
        self.as_str() == other
    }
}

impl PartialEq<&str> for Short {
    fn eq(&self, other: &&str) -> bool {
        self.as_str() == *other
    }
}

impl PartialEq<Short> for &str {
    fn eq(&self, other: &Short) -> bool {
        other == self
    }
}

impl PartialEq<Short> for str {
    fn eq(&self, other: &Short) -> bool {
        other == self
    }
}

impl PartialEq<Short> for String {
    fn eq(&self, other: &Short) -> bool {
        other == self.as_str()
    }
}

impl fmt::Debug for Short {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(self.as_str(), f)
    }
}

impl fmt::Display for Short {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_text_comes_back() {
        assert_eq!(size_of::<Short>(), 24);
        for text in
            ["", "x", "−", "a command of 22 bytes.", "a command of 23 bytes..", &"ü".repeat(11), &"ü".repeat(400)]
        {
            let short = Short::from(text);
            assert_eq!((short.as_str(), short == *text, String::from(short.clone())), (text, true, text.to_owned()));
        }
        assert_eq!(Short::from('é').as_str(), "é");
    }
}
