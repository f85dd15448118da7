//! `report.json`: the [`Report`] as text.

use std::io::{self, Write};

use serde::Serialize;
use serde_json::Serializer;
use serde_json::ser::Formatter;

use super::document::Report;
use ::paper::Comparison;
use derivation::Derivation;
use diag::escape::in_json;
use findings::Account;

/// The contract, as text: stable order, one line for each pair of claim and trajectory.
pub fn json(derivation: &Derivation, account: &Account) -> String {
    in_json(text(&Report::of(derivation, account, None)))
}

/// The same with the comparison with the paper, as `paper`.
pub fn json_with_paper(derivation: &Derivation, account: &Account, paper: &Comparison) -> String {
    in_json(text(&Report::of(derivation, account, Some(paper))))
}

/// Plain data as text.
pub(super) fn text(document: &impl Serialize) -> String {
    let mut out = Vec::new();
    let mut to = Serializer::with_formatter(&mut out, Lines::default());
    document.serialize(&mut to).expect("its keys are texts, and none of its parts refuses");
    out.push(b'\n');
    String::from_utf8(out).expect("JSON is text")
}

/// Below this depth a value stands on one line: pairs of claim and trajectory do.
const INLINE_DEPTH: usize = 4;

/// Writes as it goes, for reports of many claims are large: the parts of an object on lines of their own, those of a list where they
/// are objects or lists.
#[derive(Default)]
struct Lines {
    /// For each value around: whether something of it stands on a line of its own.
    open: Vec<bool>,
    /// Whether a part of a list comes next.
    in_list: bool,
}

impl Lines {
    /// A line of its own for a part of the value around, if it has room for that.
    fn line(&mut self, out: &mut (impl Write + ?Sized)) -> io::Result<()> {
        let depth = self.open.len();
        match self.open.last_mut() {
            Some(parted) if depth <= INLINE_DEPTH => {
                *parted = true;
                write!(out, "\n{:1$}", "", 2 * depth)
            }
            _ => Ok(()),
        }
    }

    fn begin(&mut self, out: &mut (impl Write + ?Sized), bracket: &[u8]) -> io::Result<()> {
        if std::mem::take(&mut self.in_list) {
            self.line(out)?;
        }
        self.open.push(false);
        out.write_all(bracket)
    }

    fn end(&mut self, out: &mut (impl Write + ?Sized), bracket: &[u8]) -> io::Result<()> {
        if self.open.pop() == Some(true) {
            write!(out, "\n{:1$}", "", 2 * self.open.len())?;
        }
        out.write_all(bracket)
    }
}

impl Formatter for Lines {
    fn begin_array<W: Write + ?Sized>(&mut self, out: &mut W) -> io::Result<()> {
        self.begin(out, b"[")
    }

    fn end_array<W: Write + ?Sized>(&mut self, out: &mut W) -> io::Result<()> {
        self.end(out, b"]")
    }

    fn begin_array_value<W: Write + ?Sized>(&mut self, out: &mut W, first: bool) -> io::Result<()> {
        self.in_list = true;
        if first { Ok(()) } else { out.write_all(b",") }
    }

    fn end_array_value<W: Write + ?Sized>(&mut self, _: &mut W) -> io::Result<()> {
        self.in_list = false;
        Ok(())
    }

    fn begin_object<W: Write + ?Sized>(&mut self, out: &mut W) -> io::Result<()> {
        self.begin(out, b"{")
    }

    fn end_object<W: Write + ?Sized>(&mut self, out: &mut W) -> io::Result<()> {
        self.end(out, b"}")
    }

    fn begin_object_key<W: Write + ?Sized>(&mut self, out: &mut W, first: bool) -> io::Result<()> {
        if !first {
            out.write_all(b",")?;
        }
        self.line(out)
    }

    fn begin_object_value<W: Write + ?Sized>(&mut self, out: &mut W) -> io::Result<()> {
        out.write_all(if self.open.len() <= INLINE_DEPTH { b": " } else { b":" })
    }
}

#[cfg(all(test, debug_assertions))]
mod tests {
    use super::super::tests::derivation;
    use super::*;
    use findings::sample;
    use serde_json::Value;

    #[test]
    fn the_contract_is_kept() {
        let text = json(&derivation(), &sample::account());
        let value: Value = serde_json::from_str(&text).expect("this is JSON");
        let written = serde_json::to_value(Report::of(&derivation(), &sample::account(), None));
        assert_eq!(Some(value), written.ok());
        insta::assert_snapshot!(text);
    }
}
