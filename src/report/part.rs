//! The file of a part of a family: what one machine counted, for the one that joins them.
//!
//! **In:** a [`Swept`], or the text of one or several files. **Out:** the text, or the parts in it. **Guaranteed:** the same part has the
//! same bytes on every machine; what is read is what was written, to the last bit of every number, or is refused: the last line of a
//! part has a hash of the lines before it, so that half a part is none. Files can be put together by writing one behind the other.
//!
//! A part is a few hundred bytes for each claim, however many members it has: counts, and numbers of members. No verdict and no
//! sentence of a part reaches a report: the members that are shown are tried again by the program that joins the parts.

use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use derivation::Derivation;
use diag::values::{MOST_VALUES, bounded};
use findings::family::{Part, Swept, SweptClaim, SweptMeasure};

/// The first line of a part.
#[derive(Serialize, Deserialize)]
struct Head {
    /// The version of the program.
    rederive: String,
    derivation: String,
    sha256: String,
    family: String,
    part: u64,
    of: u64,
}

/// The last one.
#[derive(Serialize, Deserialize)]
struct End {
    /// The hash of those before it, in hexadecimal digits.
    end: String,
}

/// A line of a part.
#[derive(Serialize, Deserialize)]
#[serde(untagged)]
enum Line {
    Head(Head),
    Claim(SweptClaim),
    Measure(SweptMeasure),
    End(End),
}

impl End {
    fn of(hash: Sha256) -> End {
        End { end: hash.finalize().iter().map(|b| format!("{b:02x}")).collect() }
    }
}

/// The file of a part: a head, a line for each claim, and a last line that closes it.
pub fn part_text(derivation: &Derivation, swept: &Swept) -> String {
    let head = Head {
        rederive: swept.version.clone(),
        derivation: derivation.id.clone(),
        sha256: swept.sha256.clone(),
        family: swept.family.clone(),
        part: swept.part.number(),
        of: swept.part.of(),
    };
    let claims = swept.claims.iter().cloned().map(Line::Claim);
    let lines = std::iter::once(Line::Head(head)).chain(claims);
    let lines = lines.chain(swept.measures.iter().cloned().map(Line::Measure));
    let text = |line: &Line| serde_json::to_string(line).unwrap_or_default() + "\n";
    let out: String = lines.map(|line| text(&line)).collect();
    let end = text(&Line::End(End::of(Sha256::new_with_prefix(&out))));
    out + &end
}

/// Lines, as they are put together to parts.
struct Reader {
    head: Option<Swept>,
    hash: Sha256,
}

impl Reader {
    /// Takes a line; a part, once its last line has come.
    fn line(&mut self, text: &str) -> Option<Option<Swept>> {
        bounded(text.as_bytes(), MOST_VALUES).ok()?;
        match (serde_json::from_str(text).ok()?, &mut self.head) {
            (Line::End(End { end }), _) => {
                let hash = End::of(std::mem::take(&mut self.hash)).end;
                return Some(Some(self.head.take().filter(|_| end == hash)?));
            }
            (Line::Head(of), head @ None) => {
                let part = Part::new(of.part, of.of)?;
                let (claims, measures) = (Vec::new(), Vec::new());
                let Head { rederive: version, sha256, family, .. } = of;
                *head = Some(Swept { version, sha256, family, part, claims, measures });
            }
            (Line::Claim(claim), Some(part)) => part.claims.push(claim),
            (Line::Measure(measure), Some(part)) => part.measures.push(measure),
            _ => return None,
        }
        self.hash.update(text);
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
    use findings::family::{Counts, Distribution, Ranked, Slopes, Tally};

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
