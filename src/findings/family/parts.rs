//! Parts of a family: its numbers dealt out to machines, and what they found joined again.
//!
//! **In:** what was counted in each part, in any order. **Out:** [`Joined`], or the first part that does not belong there.
//!
//! **Guaranteed:** what is joined is every number once, of one family of one file, counted by one version of the program. Memory does
//! not grow with the members: a bit for each part, and one tally for each claim. What it rests on is [`Tally::join`]: the order in
//! which parts come changes nothing.

use std::fmt;
use std::ops::RangeInclusive;

use super::distribution::Distribution;
use super::sums::Sums;
use super::tally::Tally;
use derivation::{Claim, Derivation};
use serde::{Deserialize, Serialize};

/// The most parts of a family: more would be smaller than what a machine does in a moment.
pub const MOST_PARTS: u64 = 1_000_000;
/// The most missing parts that are named.
const NAMED: usize = 8;

/// One of so many parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Part {
    number: u64,
    of: u64,
}

impl Part {
    /// The only one.
    pub const WHOLE: Part = Part { number: 1, of: 1 };

    /// The part `number`, the first of which is 1, `of` so many; `None` where there is no such part.
    pub fn new(number: u64, of: u64) -> Option<Part> {
        (1..=of).contains(&number).then_some(Part { number, of }).filter(|_| of <= MOST_PARTS)
    }

    /// Which one it is.
    pub fn number(self) -> u64 {
        self.number
    }

    /// How many there are.
    pub fn of(self) -> u64 {
        self.of
    }

    /// The numbers of members that it has, of `size` in all: as many as every other part has, or one more. `None` where there are
    /// more parts than members.
    pub fn numbers(self, size: u64) -> Option<RangeInclusive<u64>> {
        let before = |parts: u64| (u128::from(parts) * u128::from(size) / u128::from(self.of)) as u64;
        (self.of <= size).then(|| before(self.number - 1) + 1..=before(self.number))
    }
}

impl std::str::FromStr for Part {
    type Err = String;

    /// Reads `K/N`.
    fn from_str(text: &str) -> Result<Part, String> {
        let numbers = text.split_once('/').and_then(|(k, n)| Some((k.trim().parse().ok()?, n.trim().parse().ok()?)));
        let Some((number, of)) = numbers else { return Err("a part is written K/N, for instance 3/20".to_owned()) };
        let none = || format!("parts are numbered from 1/{of} to {of}/{of}, at most {MOST_PARTS}");
        Part::new(number, of).ok_or_else(none)
    }
}

impl fmt::Display for Part {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.number, self.of)
    }
}

/// What was counted of one claim.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SweptClaim {
    /// Its id.
    #[serde(rename = "claim")]
    pub id: String,
    /// Its reading, where it has several.
    pub reading: Option<String>,
    /// The counts.
    #[serde(flatten)]
    pub tally: Tally,
}

/// What was counted of one measure.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SweptMeasure {
    /// Its id.
    #[serde(rename = "measure")]
    pub id: String,
    /// How its values are distributed.
    #[serde(flatten)]
    pub distribution: Distribution,
}

/// What was found in one part, and of what.
#[derive(Clone, Debug, PartialEq)]
pub struct Swept {
    /// The version of the program.
    pub version: String,
    /// SHA-256 of the derivation file, in hexadecimal digits.
    pub sha256: String,
    /// Id of the family.
    pub family: String,
    /// Which part.
    pub part: Part,
    /// The claims that are tried on the family, in the order of the file.
    pub claims: Vec<SweptClaim>,
    /// What is measured on the family, in the order of the file.
    pub measures: Vec<SweptMeasure>,
}

/// Why parts are not joined.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PartFault {
    /// It was made by another version of the program, this one.
    OtherVersion(String),
    /// It is of another file, or of another state of this one.
    OtherFile,
    /// The file has no such family.
    NoFamily(String),
    /// The others are of another family, this one.
    OtherFamily(String),
    /// The others are parts of another division, of so many parts.
    OtherDivision(u64),
    /// It has other claims than the file.
    OtherClaims,
    /// It cannot have been counted so, for this reason.
    Impossible(&'static str),
    /// It came already.
    Double,
    /// Nothing was given.
    Nothing,
    /// So many are missing; the first of them.
    Missing(u64, Vec<u64>),
}

impl fmt::Display for PartFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            PartFault::OtherVersion(version) => {
                write!(f, "it was made by version {version} of the program, and this is {}", env!("CARGO_PKG_VERSION"))
            }
            PartFault::OtherFile => f.write_str("it is of another derivation file, or of another state of this one"),
            PartFault::NoFamily(family) => write!(f, "the derivation file has no family `{family}`"),
            PartFault::OtherFamily(family) => write!(f, "the parts before it are of the family `{family}`"),
            PartFault::OtherDivision(of) => write!(f, "the parts before it are parts of {of}"),
            PartFault::OtherClaims => f.write_str("it has other claims or measures than the derivation file"),
            PartFault::Impossible(why) => write!(f, "{why}: it is damaged"),
            PartFault::Double => f.write_str("this part was given already"),
            PartFault::Nothing => f.write_str("no part was given"),
            PartFault::Missing(count, some) => {
                let some: Vec<String> = some.iter().map(u64::to_string).collect();
                let more = if *count > some.len() as u64 { ", …" } else { "" };
                write!(f, "{count} of the parts are missing: {}{more}", some.join(", "))
            }
        }
    }
}

/// The claims that are tried on a family, by its position.
fn asked(derivation: &Derivation, family: usize) -> impl Iterator<Item = &Claim> {
    derivation.claims.iter().filter(move |c| c.families.contains(&family))
}

/// Parts as they come.
pub struct Join<'a> {
    derivation: &'a Derivation,
    /// The position of the family, in how many parts it is divided, and which came: a bit for each.
    open: Option<(usize, u64, Vec<u64>)>,
    sums: Sums,
}

/// All parts of a family.
#[derive(Clone, Debug, PartialEq)]
pub struct Joined {
    /// The position of the family in the file.
    pub family: usize,
    /// What was counted of each claim that is tried on it and of each measure, in the order of the file.
    pub sums: Sums,
}

impl Joined {
    /// The id of the family.
    pub fn id<'d>(&self, derivation: &'d Derivation) -> &'d str {
        derivation.families.get(self.family).map_or("", |f| &f.id)
    }
}

impl<'a> Join<'a> {
    /// Nothing yet.
    pub fn new(derivation: &'a Derivation) -> Join<'a> {
        Join { derivation, open: None, sums: Sums::default() }
    }

    /// Adds a part.
    ///
    /// # Errors
    /// It does not belong to the file, or to those that came before; then nothing has changed.
    pub fn add(&mut self, swept: &Swept) -> Result<(), PartFault> {
        if swept.version != env!("CARGO_PKG_VERSION") {
            return Err(PartFault::OtherVersion(swept.version.clone()));
        }
        if swept.sha256 != self.derivation.sha256 {
            return Err(PartFault::OtherFile);
        }
        let Some(at) = self.derivation.families.iter().position(|f| f.id == swept.family) else {
            return Err(PartFault::NoFamily(swept.family.clone()));
        };
        let family = &self.derivation.families[at];
        if let Some((first, of, _)) = &self.open {
            if *first != at {
                return Err(PartFault::OtherFamily(self.derivation.families[*first].id.clone()));
            }
            if *of != swept.part.of {
                return Err(PartFault::OtherDivision(*of));
            }
        }
        let is_it = |(claim, found): (&Claim, &SweptClaim)| claim.id == found.id && claim.reading == found.reading;
        let claims = asked(self.derivation, at);
        if claims.count() != swept.claims.len() || !asked(self.derivation, at).zip(&swept.claims).all(is_it) {
            return Err(PartFault::OtherClaims);
        }
        let measures = self.derivation.measures.iter().filter(|m| m.families.contains(&at));
        if !measures.map(|m| &m.id).eq(swept.measures.iter().map(|m| &m.id)) {
            return Err(PartFault::OtherClaims);
        }
        let Some(numbers) = swept.part.numbers(family.size()) else {
            return Err(PartFault::Impossible("there are more parts than members"));
        };
        let again = family.is_drawn_again();
        let of_claims = swept.claims.iter().find_map(|c| c.tally.fault(&numbers, again));
        let of_measures = || swept.measures.iter().find_map(|m| m.distribution.fault(&numbers, again));
        if let Some(why) = of_claims.or_else(of_measures) {
            return Err(PartFault::Impossible(why));
        }
        let of = swept.part.of;
        let (_, _, seen) = self.open.get_or_insert_with(|| (at, of, vec![0; of.div_ceil(64) as usize]));
        let place = swept.part.number - 1;
        let (word, bit) = (&mut seen[(place / 64) as usize], 1_u64 << (place % 64));
        if *word & bit != 0 {
            return Err(PartFault::Double);
        }
        *word |= bit;
        let claims = swept.claims.iter().map(|c| &c.tally);
        self.sums.join(claims, swept.measures.iter().map(|m| &m.distribution));
        Ok(())
    }

    /// All of it, once every part has come.
    ///
    /// # Errors
    /// [`PartFault::Missing`], or [`PartFault::Nothing`].
    pub fn finish(self) -> Result<Joined, PartFault> {
        let Some((family, of, seen)) = self.open else { return Err(PartFault::Nothing) };
        let is_missing = |n: &u64| seen[((n - 1) / 64) as usize] & (1 << ((n - 1) % 64)) == 0;
        let missing = (1..=of).filter(is_missing).count() as u64;
        if missing > 0 {
            return Err(PartFault::Missing(missing, (1..=of).filter(is_missing).take(NAMED).collect()));
        }
        Ok(Joined { family, sums: self.sums })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_have_every_number_once() {
        for (size, of) in [(1, 1), (9, 2), (9, 9), (100, 7), (1_000_000_000, 1000), (1_000_000_000, 999_983)] {
            let mut next = 1;
            for number in 1..=of {
                let numbers = Part::new(number, of).and_then(|p| p.numbers(size)).expect("a part");
                assert_eq!(*numbers.start(), next);
                let many = numbers.end() + 1 - numbers.start();
                assert!(many == size / of || many == size.div_ceil(of), "{number}/{of} of {size}");
                next = numbers.end() + 1;
            }
            assert_eq!(next, size + 1);
        }
        assert_eq!(Part::new(0, 4), None);
        assert_eq!(Part::new(5, 4), None);
        assert_eq!(Part::new(1, MOST_PARTS + 1), None);
        assert_eq!(Part::new(3, 4).and_then(|p| p.numbers(3)), None);
    }
}
