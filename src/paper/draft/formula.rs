//! Displays → formulas, each with what it needs.
//!
//! **In:** the printed relations of a paper. **Out:** for each display, or each label of one, its formulas: a chain as a whole where it can
//! be read so, else step by step. **Guaranteed:** what is drafted was loaded by itself, with these guesses and no others.

use std::ops::Range;
use std::path::Path;

use super::super::names::evidence::is_alone;
use super::super::names::{Call, Evidence, Notation, names_apart};
use super::super::printed::{PrintedRelation, PrintedSide};
use super::super::{Paper, token};
use super::average;
use super::guess::{Place, Reading};
use super::readings::readings;
use super::write;
use derivation::{Derivation, parse};
use diag::{Diagnostic, Source};

/// A formula of the draft.
#[derive(Clone, Debug, Default)]
pub(super) struct Formula {
    /// Its text.
    pub text: String,
    /// What was written otherwise than it is printed, and how that is.
    pub printed: Option<(&'static str, String)>,
    /// How many relations between two sides it has.
    pub steps: usize,
    /// Whether it says when another holds.
    pub is_condition: bool,
    /// Why it stands in a comment.
    pub refused: Option<String>,
    /// What it needs.
    pub needs: Reading,
    /// Other readings, for where the file cannot have what it needs; not yet tried.
    pub others: Vec<Reading>,
    /// The state whose rate it gives, and the order of the rate: `\ddot q=…`.
    pub rate: Option<(String, usize)>,
    /// Its place in the text of the last round.
    pub place: Range<usize>,
    /// The place of the symbols of its claim there.
    pub symbols: Range<usize>,
}

/// What a paper prints under one number.
#[derive(Clone, Debug)]
pub(super) struct Printed {
    /// The id of its claim.
    pub id: String,
    /// Its label.
    pub label: Option<String>,
    /// Its line.
    pub line: usize,
    /// The file that it stands in, from the folder of the paper, where that is not the paper's own.
    pub file: Option<String>,
    /// Its formulas.
    pub formulas: Vec<Formula>,
    /// What relates nothing.
    pub expressions: Vec<String>,
    /// What stands beside it in words.
    pub remarks: Vec<String>,
    /// Whether it is one of several cases: nothing of it is said where its condition is not read.
    pub is_case: bool,
    relations: Vec<PrintedRelation>,
}

/// The file of a relation that stands in another one than the paper's own, from its folder.
fn included(paper: &Paper, relation: &PrintedRelation) -> Option<String> {
    let (source, _) = paper.locate(&relation.span());
    let folder = Path::new(&paper.file.path).parent().unwrap_or(Path::new(""));
    let path = Path::new(&source.path);
    (source.path != paper.file.path).then(|| path.strip_prefix(folder).unwrap_or(path).display().to_string())
}

/// The displays of a paper, in its order, those with several labels in parts.
pub(super) fn displays(paper: &Paper) -> Vec<Printed> {
    let mut out: Vec<Printed> = Vec::new();
    let mut ids = write::Ids::default();
    let mut last = None;
    for relation in paper.printed.iter().filter(|r| r.display.is_some()) {
        let mut begin = |out: &mut Vec<Printed>, is_case: bool, relations: Vec<PrintedRelation>| {
            let number = out.len() + 1;
            out.push(Printed {
                id: ids.next(relation.label.as_deref(), number),
                label: relation.label.clone(),
                line: paper.line(&relation.span()),
                file: included(paper, relation),
                formulas: Vec::new(),
                expressions: Vec::new(),
                remarks: Vec::new(),
                is_case,
                relations,
            });
        };
        if let Some(cases) = relation.cases() {
            cases.into_iter().for_each(|case| begin(&mut out, true, case));
            last = None;
            continue;
        }
        let own = (relation.display, relation.label.clone());
        if last.as_ref() != Some(&own) {
            begin(&mut out, false, Vec::new());
            last = Some(own);
        }
        if let Some(printed) = out.last_mut() {
            printed.remarks.extend(relation.remark.clone().filter(|r| !r.is_empty()));
            match relation.sides.as_slice() {
                [one] if one.text.is_empty() => {}
                _ if is_range(relation) => {
                    let sides: Vec<&PrintedSide> = relation.sides.iter().collect();
                    printed.remarks.push(text_of(&sides, &relation.signs));
                }
                [one] => printed.expressions.push(one.text.clone()),
                _ => printed.relations.push(relation.clone()),
            }
        }
    }
    out
}

/// Whether a relation says over what indices run, and nothing else: `i=1,2,\ldots,n`.
fn is_range(relation: &PrintedRelation) -> bool {
    let Some((last, before)) = relation.sides.split_last() else { return false };
    let goes_on = [r"\ldots", r"\cdots", r"\dots"].iter().any(|dots| last.text.contains(dots));
    let letters = |s: &PrintedSide| s.tokens.iter().all(|t| !matches!(t.text.as_str(), "+" | "-" | "(" | "frac"));
    goes_on
        && last.is_list
        && !before.is_empty()
        && before.iter().all(letters)
        && relation.signs.iter().all(|s| s == "=")
}

impl Printed {
    /// Reads its relations: each as a whole, or step by step.
    pub fn read(
        &mut self,
        notation: &Notation,
        read: &mut impl FnMut(&[&PrintedSide], &str, Place) -> Result<Vec<Reading>, String>,
    ) {
        for relation in &self.relations {
            let mut take = |sides: &[&PrintedSide], signs: &[String]| {
                let (mut text, mut printed) = (text_of(sides, signs), None);
                let place = Place { section: relation.section, chapter: relation.chapter };
                let mut found = match &relation.unread {
                    Some(why) => Err(why.clone()),
                    None => read(sides, &text, place),
                };
                if relation.unread.is_none()
                    && let Err(why) = &found
                    && let Some(other) = written_otherwise(sides, (&text, signs), why, notation)
                    && let Ok(readings) = read(&other.sides.iter().collect::<Vec<_>>(), &other.text, place)
                {
                    found = Ok(readings);
                    printed = Some((other.what, std::mem::replace(&mut text, other.text)));
                }
                let (mut others, refused) = match found {
                    Ok(readings) => (readings, None),
                    Err(why) => (Vec::new(), Some(why)),
                };
                let needs = if others.is_empty() { Reading::default() } else { others.remove(0) };
                let (steps, is_condition) = (signs.len(), relation.is_condition());
                let rate = rate_of(sides, signs);
                Formula { text, printed, steps, is_condition, refused, needs, others, rate, ..Formula::default() }
            };
            let sides: Vec<&PrintedSide> = relation.sides.iter().collect();
            let whole = take(&sides, &relation.signs);
            if whole.refused.is_none() || relation.signs.len() < 2 {
                self.formulas.push(whole);
                continue;
            }
            for (pair, sign) in sides.windows(2).zip(relation.signs.chunks(1)) {
                self.formulas.push(take(pair, sign));
            }
        }
        self.relations = Vec::new();
        if self.is_case && self.formulas.iter().any(|f| f.is_condition && f.refused.is_some()) {
            for formula in self.formulas.iter_mut().filter(|f| f.refused.is_none()) {
                formula.refused = Some("a case whose condition is not read".to_owned());
            }
        }
    }
}

/// The state whose rate a formula gives, and the order: that of which the left side is a rate and nothing else, or that whose second
/// rate stands once in an equation of motion, `m\ddot x+kx=0`.
fn rate_of(sides: &[&PrintedSide], signs: &[String]) -> Option<(String, usize)> {
    let left = sides.first().filter(|_| signs.len() == 1 && signs[0] == "=")?;
    if let Some(key) = moved_by(sides) {
        return Some((key, 2));
    }
    let all = names_apart(left);
    let plain = |factor: &str| left.text.contains(factor);
    let name = all.first().filter(|n| n.primes == 0 && n.call == Call::None && !plain("+") && !plain("-"))?;
    // A rate on the right could be its own, or that of another: only the first rate beside a second one is none of these.
    let right = sides.get(1).map(|s| names_apart(s)).unwrap_or_default();
    let most = usize::from(name.dots == 2);
    if right.iter().any(|n| n.derived_by.is_some() || n.dots > most) {
        return None;
    }
    match all.len() {
        1 if matches!(name.dots, 1 | 2) && is_alone(left) => Some((name.key(), name.dots)),
        2 if all[1].is_variable && name.derived_by.as_deref() == Some("t") && !name.is_partial && name.dots == 0 => {
            let order = if plain("^2") || plain("^{2}") { 2 } else { 1 };
            let bare = left.text.trim_start().starts_with(r"\frac") && !plain("(") && !plain(r"\cdot");
            bare.then(|| (name.key(), order))
        }
        _ => None,
    }
}

/// The name whose second rate stands in an equation, once and to no power; other rates in it are first ones.
fn moved_by(sides: &[&PrintedSide]) -> Option<String> {
    let all: Vec<_> = sides.iter().flat_map(|s| names_apart(s)).collect();
    let mut twice = all.iter().filter(|n| n.dots > 1);
    let name = twice.next().filter(|n| n.dots == 2 && twice.next().is_none())?;
    let text: String = sides.iter().map(|s| s.text.as_str()).collect::<Vec<_>>().join(" = ");
    let (_, behind) = text.split_once(r"\ddot").filter(|(_, rest)| !rest.contains(r"\ddot"))?;
    let letter = behind.trim_start().trim_start_matches('{').trim_start();
    let rest = letter.trim_start_matches('\\').trim_start_matches(char::is_alphabetic);
    let is_plain =
        all.iter().all(|n| n.derived_by.is_none() && n.primes == 0 && n.call == Call::None && !n.is_in_group);
    let is_power = rest.trim_start().trim_start_matches('}').trim_start().starts_with('^');
    (is_plain && !is_power).then(|| name.key())
}

/// Sides and signs as one text.
fn text_of(sides: &[&PrintedSide], signs: &[String]) -> String {
    let mut out = String::new();
    for (k, side) in sides.iter().enumerate() {
        if let Some(sign) = k.checked_sub(1).and_then(|k| signs.get(k)) {
            out.push_str(sign);
            let letter = side.text.starts_with(|c: char| c.is_ascii_alphabetic());
            if sign.starts_with('\\') && letter {
                out.push(' ');
            }
        }
        out.push_str(&side.text);
    }
    one_line(&out)
}

/// A text in one line, with single spaces, and no prime at its end or three in a row, which would end a text of TOML: they print the same
/// written above.
fn one_line(text: &str) -> String {
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    let mut out = String::with_capacity(text.len());
    let mut rest = text.as_str();
    while let Some(at) = rest.find('\'') {
        let (before, from) = rest.split_at(at);
        let count = from.bytes().take_while(|b| *b == b'\'').count();
        let after = &from[count..];
        out.push_str(before);
        let raised = after.trim_start().starts_with(['^', '_']);
        if (count > 2 || after.is_empty()) && !raised && !out.is_empty() {
            out.push_str("^{");
            out.push_str(&r"\prime".repeat(count));
            out.push('}');
        } else {
            out.push_str(&from[..count]);
        }
        rest = after;
    }
    out.push_str(rest);
    out
}

/// Words of refusals where a file has no room for the coordinates of a formula.
const OF_ROOM: &[&str] = &["coordinates", "is no place of a function"];
/// Words of refusals where the argument of a function has no clear end.
const OF_ARGUMENTS: &str = "where the argument of";
/// Words of refusals of angle brackets.
const OF_BRACKETS: &str = "`bra-ket`";

/// A formula that is written otherwise than it is printed, and means the same.
struct Otherwise {
    what: &'static str,
    sides: Vec<PrintedSide>,
    text: String,
}

/// A formula in another spelling, where it was refused for one that can be told otherwise.
fn written_otherwise(
    sides: &[&PrintedSide],
    (text, signs): (&str, &[String]),
    why: &str,
    notation: &Notation,
) -> Option<Otherwise> {
    if why.contains(OF_ARGUMENTS) {
        let text = notation.with_ends_of_angles(text)?;
        let what = "arguments of functions end at the angle, as elsewhere in the paper";
        return Some(Otherwise { what, sides: sides.iter().map(|s| (*s).clone()).collect(), text });
    }
    let could_be = why == OF_BRACKETS && !notation.has_operators() && !sides.iter().any(|s| notation.is_algebra(s));
    let sides = could_be.then(|| average::named(sides)).flatten()?;
    let what = "an average is a name";
    let text = text_of(&sides.iter().collect::<Vec<_>>(), signs);
    Some(Otherwise { what, sides, text })
}

/// Longest formula that is read, in bytes.
const LONGEST: usize = 20_000;

/// Reads a formula by itself: a reading with which it was loaded, and others that were not tried; or why it is refused.
pub(super) fn alone(
    sides: &[&PrintedSide],
    text: &str,
    (evidence, notation): (&Evidence, &Notation),
    is_of_indices: bool,
    place: Place,
) -> Result<Vec<Reading>, String> {
    if text.len() > LONGEST {
        return Err("a formula of more than 20000 bytes".to_owned());
    }
    if sides.iter().any(|s| s.is_list) {
        return Err("a list: several formulas where one is read".to_owned());
    }
    if let Some(feature) = feature(sides) {
        return Err(feature);
    }
    if let Some(why) = sides.iter().find_map(|s| notation.not_numbers(s)) {
        return Err(why.to_owned());
    }
    let mut first: Option<String> = None;
    for mut ways in readings(sides, evidence, is_of_indices, place)? {
        let why = match load(&write::single(text, &ways[0])) {
            Ok(_) => return Ok(ways),
            Err(found) => found.first().map_or_else(String::new, |d| d.message.clone()),
        };
        // What a file has no room for may be read with less of it.
        let of_room = OF_ROOM.iter().any(|sign| why.contains(sign));
        first.get_or_insert(why);
        let loads = |r: &Reading| load(&write::single(text, r)).is_ok();
        if of_room && let Some(at) = (1..ways.len()).find(|&at| loads(&ways[at])) {
            ways.drain(..at);
            return Ok(ways);
        }
    }
    Err(first.unwrap_or_default())
}

/// Loads a file.
pub(super) fn load(text: &str) -> Result<Box<Derivation>, Vec<Diagnostic>> {
    parse(Source { path: "draft.toml".to_owned(), text: text.to_owned() }, "draft").map(Box::new)
}

/// What is known and not part of the language, where a command outside of all subscripts shows it.
fn feature(sides: &[&PrintedSide]) -> Option<String> {
    let commands = sides.iter().flat_map(|s| {
        let below = |at: usize| at.checked_sub(1).and_then(|i| s.tokens.get(i)).is_some_and(|t| t.is_char("_"));
        let mut depth = 0usize;
        let mut hidden: Option<usize> = None;
        let mut out = Vec::new();
        for (at, t) in s.tokens.iter().enumerate() {
            match t.kind {
                token::Kind::Open => {
                    depth += 1;
                    if hidden.is_none() && below(at) {
                        hidden = Some(depth);
                    }
                }
                token::Kind::Close => {
                    if hidden == Some(depth) {
                        hidden = None;
                    }
                    depth = depth.saturating_sub(1);
                }
                token::Kind::Command if hidden.is_none() && !below(at) => out.push(t.text.as_str()),
                _ => {}
            }
        }
        out
    });
    commands.filter_map(latex::feature_of).map(|f| format!("`{}`", f.name)).next()
}
