//! The file of a part of a family: what one machine counted, for the one that joins them.
//!
//! **In:** a [`Swept`], or the text of one or several files. **Out:** the text, or the parts in it. **Guaranteed:** the same part has the
//! same bytes on every machine; what is read is what was written, to the last bit of every number, or is refused: the last line of a
//! part has a hash of the lines before it, so that half a part is none. Files can be put together by writing one behind the other.
//!
//! A part is a few hundred bytes for each claim, however many members it has: counts, and numbers of members. No verdict and no
//! sentence of a part reaches a report: the members that are shown are tried again by the program that joins the parts.

use serde_json::{Value, json};
use sha2::{Digest, Sha256};

use derivation::Derivation;
use findings::family::{Counts, Distribution, Part, Ranked, Slopes, Swept, SweptClaim, SweptMeasure, Tally};

/// A hash in hexadecimal digits.
fn digits(hash: Sha256) -> String {
    hash.finalize().iter().map(|b| format!("{b:02x}")).collect()
}

/// A number as text, from which the same number is read: JSON has no infinity.
fn ranked(of: Option<Ranked>) -> Value {
    of.map_or(Value::Null, |r| json!({ "number": r.number, "measure": format!("{:?}", r.measure) }))
}

/// Whole numbers that are too long for JSON are texts, as numbers are that need all their bits.
fn slopes(of: &Slopes) -> Value {
    let whole = |sums: &[i128]| sums.iter().map(i128::to_string).collect::<Vec<_>>();
    let cell =
        |cell: &Option<(f64, f64)>| cell.map(|(least, greatest)| [format!("{least:?}"), format!("{greatest:?}")]);
    json!({
        "pairs": of.pairs,
        "sums": whole(&of.sums),
        "errors": whole(&of.errors),
        "cells": of.cells.iter().map(cell).collect::<Vec<_>>(),
    })
}

/// The file of a part: a head, a line for each claim, and a last line that closes it.
pub fn part_text(derivation: &Derivation, swept: &Swept) -> String {
    let head = json!({
        "rederive": swept.version,
        "derivation": derivation.id,
        "sha256": swept.sha256,
        "family": swept.family,
        "part": swept.part.number(),
        "of": swept.part.of(),
    });
    let claim = |c: &SweptClaim| {
        let mut line = json!({
            "claim": c.id,
            "reading": c.reading,
            "members": c.tally.counts.members,
            "rejected": c.tally.counts.rejected,
            "holds": c.tally.counts.holds,
            "fails": c.tally.counts.fails,
            "not_applicable": c.tally.counts.not_applicable,
            "undecided": c.tally.counts.undecided,
            "first_failing": c.tally.first_failing,
            "clearest_failing": ranked(c.tally.clearest_failing),
            "closest_call": ranked(c.tally.closest_call),
            "first_undecided": c.tally.first_undecided,
            "first_defect": c.tally.first_defect,
        });
        if !c.tally.map.is_empty() {
            line["map"] = json!(c.tally.map);
        }
        if c.tally.slopes != Slopes::default() {
            line["slopes"] = slopes(&c.tally.slopes);
        }
        line
    };
    let measure = |m: &SweptMeasure| {
        let of = &m.distribution;
        json!({
            "measure": m.id,
            "members": of.members,
            "rejected": of.rejected,
            "without": of.without,
            "partial": of.partial,
            "least": ranked(of.least),
            "greatest": ranked(of.greatest),
            "bound": format!("{:?}", of.bound),
            "bins": of.bins.iter().collect::<Vec<_>>(),
        })
    };
    let lines = std::iter::once(head).chain(swept.claims.iter().map(claim)).chain(swept.measures.iter().map(measure));
    let mut out: String = lines.map(|line| format!("{line}\n")).collect();
    let end = json!({ "end": digits(Sha256::new_with_prefix(&out)) });
    out.push_str(&format!("{end}\n"));
    out
}

/// Lines, as they are put together to parts.
struct Reader {
    head: Option<Swept>,
    hash: Sha256,
}

fn text(of: &Value, key: &str) -> Option<String> {
    of.get(key)?.as_str().map(str::to_owned)
}

fn count(of: &Value, key: &str) -> Option<u64> {
    of.get(key)?.as_u64()
}

/// A value that may be `null`; `None` where it is neither.
fn or_null<T>(of: &Value, key: &str, read: impl Fn(&Value) -> Option<T>) -> Option<Option<T>> {
    match of.get(key)? {
        Value::Null => Some(None),
        value => read(value).map(Some),
    }
}

fn head(of: &Value) -> Option<Swept> {
    Some(Swept {
        version: text(of, "rederive")?,
        sha256: text(of, "sha256")?,
        family: text(of, "family")?,
        part: Part::new(count(of, "part")?, count(of, "of")?)?,
        claims: Vec::new(),
        measures: Vec::new(),
    })
}

fn cells(of: &Value) -> Option<Vec<[u64; 4]>> {
    let counts =
        |cell: &Value| cell.as_array()?.iter().map(Value::as_u64).collect::<Option<Vec<u64>>>()?.try_into().ok();
    of.as_array()?.iter().map(counts).collect()
}

fn read_slopes(of: &Value) -> Option<Slopes> {
    let texts = |of: &Value| of.as_array()?.iter().map(|t| t.as_str().map(str::to_owned)).collect::<Option<Vec<_>>>();
    let whole = |key: &str| -> Option<Vec<i128>> { texts(of.get(key)?)?.iter().map(|t| t.parse().ok()).collect() };
    let cell = |cell: &Value| match cell {
        Value::Null => Some(None),
        pair => match texts(pair)?.as_slice() {
            [least, greatest] => Some(Some((least.parse().ok()?, greatest.parse().ok()?))),
            _ => None,
        },
    };
    Some(Slopes {
        pairs: count(of, "pairs")?,
        sums: whole("sums")?.try_into().ok()?,
        errors: whole("errors")?.try_into().ok()?,
        cells: of.get("cells")?.as_array()?.iter().map(cell).collect::<Option<_>>()?,
    })
}

fn rank(of: &Value) -> Option<Ranked> {
    Some(Ranked { number: count(of, "number")?, measure: text(of, "measure")?.parse().ok()? })
}

fn measure(of: &Value) -> Option<SweptMeasure> {
    let bin = |pair: &Value| match pair.as_array().map(Vec::as_slice) {
        Some([bin, count]) => Some((bin.as_i64()?, count.as_u64()?)),
        _ => None,
    };
    let bins = of.get("bins")?.as_array()?;
    let distribution = Distribution {
        members: count(of, "members")?,
        rejected: count(of, "rejected")?,
        without: count(of, "without")?,
        partial: count(of, "partial")?,
        least: or_null(of, "least", rank)?,
        greatest: or_null(of, "greatest", rank)?,
        bound: text(of, "bound")?.parse().ok()?,
        bins: bins.iter().map(bin).collect::<Option<_>>()?,
    };
    // A bin that comes twice is one too few.
    (distribution.bins.len() == bins.len()).then_some(SweptMeasure { id: text(of, "measure")?, distribution })
}

fn claim(of: &Value) -> Option<SweptClaim> {
    let tally = Tally {
        counts: Counts {
            members: count(of, "members")?,
            rejected: count(of, "rejected")?,
            holds: count(of, "holds")?,
            fails: count(of, "fails")?,
            not_applicable: count(of, "not_applicable")?,
            undecided: count(of, "undecided")?,
        },
        first_failing: or_null(of, "first_failing", Value::as_u64)?,
        clearest_failing: or_null(of, "clearest_failing", rank)?,
        closest_call: or_null(of, "closest_call", rank)?,
        first_undecided: or_null(of, "first_undecided", Value::as_u64)?,
        first_defect: or_null(of, "first_defect", Value::as_u64)?,
        map: of.get("map").map_or(Some(Vec::new()), cells)?,
        slopes: of.get("slopes").map_or(Some(Slopes::default()), read_slopes)?,
    };
    let reading = or_null(of, "reading", |v| v.as_str().map(str::to_owned))?;
    Some(SweptClaim { id: text(of, "claim")?, reading, tally })
}

impl Reader {
    /// Takes a line; a part, once its last line has come.
    fn line(&mut self, line: &str) -> Option<Option<Swept>> {
        let value: Value = serde_json::from_str(line).ok()?;
        if let Some(end) = value.get("end") {
            let hash = digits(std::mem::take(&mut self.hash));
            let part = self.head.take().filter(|_| end.as_str() == Some(&hash))?;
            return Some(Some(part));
        }
        match &mut self.head {
            None => self.head = Some(head(&value)?),
            Some(part) if value.get("claim").is_some() => part.claims.push(claim(&value)?),
            Some(part) => part.measures.push(measure(&value)?),
        }
        self.hash.update(line);
        self.hash.update("\n");
        Some(None)
    }
}

/// The parts of a file, each handed on as it is read.
///
/// # Errors
/// The first line that belongs to no part; that the last part is not closed; what `take` finds.
pub fn read_parts<E>(text: &str, mut take: impl FnMut(&Swept) -> Result<(), E>) -> Result<Result<(), E>, String> {
    let mut reader = Reader { head: None, hash: Sha256::new() };
    for (n, line) in text.lines().enumerate() {
        match reader.line(line) {
            Some(None) => {}
            Some(Some(part)) => {
                if let Err(refused) = take(&part) {
                    return Ok(Err(refused));
                }
            }
            None => return Err(format!("line {} is not a line of a part: it is damaged, or no part", n + 1)),
        }
    }
    match reader.head {
        Some(part) => Err(format!("part {} has no end: it was not written to its last line", part.part)),
        None => Ok(Ok(())),
    }
}

#[cfg(all(test, debug_assertions))]
mod tests {
    use super::*;
    use crate::tests::derivation;

    fn swept() -> Swept {
        let tally = Tally {
            counts: Counts { members: u64::MAX, rejected: 3, holds: 1 << 60, fails: 5, ..Counts::default() },
            first_failing: Some(7),
            clearest_failing: Some(Ranked { number: 9, measure: f64::INFINITY }),
            closest_call: Some(Ranked { number: 1 << 40, measure: 0.1 + 0.2 }),
            map: vec![[0; 4], [1 << 60, 5, 0, u64::MAX]],
            slopes: Slopes {
                pairs: 6,
                sums: [i128::MAX, i128::MIN, 0],
                errors: [1 << 100, 3],
                cells: vec![None, Some((-0.1, 1e-300))],
            },
            ..Tally::default()
        };
        let mut distribution = Distribution { rejected: 3, bound: 0.1, ..Distribution::default() };
        distribution.least = Some(Ranked { number: 2, measure: -0.1 });
        distribution.bins.extend([(-5, 1), (0, u64::MAX)]);
        let measures = vec![SweptMeasure { id: "m".to_owned(), distribution }];
        Swept {
            version: "1.2.3".to_owned(),
            sha256: "ab".to_owned(),
            family: "f".to_owned(),
            part: Part::new(3, 20).expect("a part"),
            claims: vec![
                SweptClaim { id: "a".to_owned(), reading: Some("b\n\"".to_owned()), tally },
                SweptClaim { id: "c".to_owned(), reading: None, tally: Tally::default() },
            ],
            measures,
        }
    }

    fn read(text: &str) -> Result<Vec<Swept>, String> {
        let mut all = Vec::new();
        let found: Result<(), ()> = read_parts(text, |part| {
            all.push(part.clone());
            Ok(())
        })?;
        found.map(|()| all).map_err(|()| String::new())
    }

    #[test]
    fn what_is_read_is_what_was_written() {
        let text = part_text(&derivation(), &swept());
        assert_eq!(read(&text), Ok(vec![swept()]));
        assert_eq!(read(&format!("{text}{text}")).map(|all| all.len()), Ok(2));
        assert_eq!(read(""), Ok(Vec::new()));
        assert_eq!(text.lines().count(), 5);
    }

    #[test]
    fn half_a_part_and_an_altered_one_are_none() {
        let text = part_text(&derivation(), &swept());
        for end in (1..text.len() - 1).filter(|end| text.is_char_boundary(*end)) {
            assert!(read(&text[..end]).is_err(), "{}", &text[..end]);
        }
        for (old, new) in [("\"fails\":5", "\"fails\":6"), ("\"part\":3", "\"part\":4"), ("\"of\":20", "\"of\":2")] {
            assert!(read(&text.replace(old, new)).is_err(), "{new}");
        }
        let without: Vec<&str> = text.lines().enumerate().filter(|(n, _)| *n != 1).map(|(_, line)| line).collect();
        assert!(read(&format!("{}\n", without.join("\n"))).is_err());
    }
}
