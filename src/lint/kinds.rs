//! What letters stand for, where the paper says that they are no positive numbers, or no numbers.
//!
//! **In:** a paper, and the words around a relation. **Out:** the names of each part that may be negative or complex, and whether the letters of a
//! relation are of another kind: Grassmann variables, ordinals, segments of a triangle. **Guaranteed:** what is found here only keeps words
//! from being said.

use std::collections::{BTreeSet, HashMap};

use paper::{Paper, PrintedRelation, PrintedSide, names, squeezed};

use super::lone::lone_name;
use super::sentence::window;

/// The longest text before a formula, and behind it, in which its letters are said to be of another kind.
const BEFORE: usize = 500;
const BEHIND: usize = 100;
/// The longest formula that is taken for the name of which a sentence says something, in bytes.
const LONGEST_NAME: usize = 14;

/// Words for values that are not positive; those behind the bar are of numbers that are not real.
const NEGATIVE: &[&str] = &["negativ", "négati", "not positive", "less than zero", "below zero"];
const COMPLEX: &[&str] = &["imaginar", "imaginär", "imaginaire", "immaginari", "complex", "komplex", "compless"];
/// Sets of numbers that need not be positive, and of those that need not be real.
const REAL_SETS: &[&str] = &[r"\mathbbR", r"\mathbbZ", r"\mathbbQ", r"\mathbfR", r"\R", r"\Z", r"\Q"];
const COMPLEX_SETS: &[&str] = &[r"\mathbbC", r"\mathbfC", r"\C"];
/// What a set has beside its letter that makes its numbers positive.
const ABOVE: &[&str] = &["+", ">"];

/// Words that say that letters are no numbers that one reckons with as usual.
const OTHER_KINDS: &[&str] = &[
    "grassmann",
    "anticommut",
    "anti-commut",
    "quaternion",
    "octonion",
    "ordinal number",
    "ordinals",
    "cardinal number",
    "non-abelian",
    "nonabelian",
    "non-commutative ring",
    "noncommutative ring",
    "tropical",
    "max-plus",
    "min-plus",
    "finite field",
    "characteristic two",
    "characteristic 2",
    "boolean algebra",
    "boolean ring",
    "boolean variable",
    "be rotations",
    "are rotations",
    "be reflections",
    "be permutations",
    "are permutations",
    "two rotations",
];
/// Words near which two capitals beside each other are the segment between two points.
const OF_POINTS: &[&str] = &[
    "triangle",
    "segment",
    "quadrilateral",
    "parallelogram",
    "trapez",
    "collinear",
    "ceva",
    "menelaus",
    "chord",
    "dreieck",
    "strecke",
    "triangolo",
    "triángulo",
];

/// Names of a part of the paper that may not be positive.
#[derive(Clone, Debug, Default)]
pub(super) struct Unsigned {
    /// Those that may be negative, or not real.
    pub not_positive: BTreeSet<String>,
    /// Those that may not be real.
    pub not_real: BTreeSet<String>,
}

/// The names that are said not to be positive, by the parts in which that is said.
pub(super) fn unsigned(paper: &Paper, parts: &[usize]) -> HashMap<usize, Unsigned> {
    let mut out: HashMap<usize, Unsigned> = HashMap::new();
    for (relation, part) in paper.printed.iter().zip(parts) {
        let found = out.entry(*part).or_default();
        for (pair, sign) in relation.sides.windows(2).zip(&relation.signs) {
            if let [left, right] = pair {
                found.note(left, sign, right);
            }
        }
        found.note_words(paper, relation);
    }
    out
}

impl Unsigned {
    /// What one relation says of its sides.
    fn note(&mut self, left: &PrintedSide, sign: &str, right: &PrintedSide) {
        let is_not_above = |s: &PrintedSide| s.text.trim() == "0" || is_negative(s);
        let lone = |s: &PrintedSide| lone_name(s).map(|n| n.key());
        match sign {
            r"\in" => {
                let set = squeezed(&right.text).replace(['{', '}', ' '], "");
                let is_above = ABOVE.iter().any(|sign| set.contains(sign));
                let names: Vec<String> = names(left).iter().map(|n| n.key()).collect();
                let is_of = |sets: &[&str]| sets.iter().any(|s| set.starts_with(s));
                if is_of(COMPLEX_SETS) {
                    self.not_real.extend(names.iter().cloned());
                }
                if is_of(COMPLEX_SETS) || is_of(REAL_SETS) && !is_above {
                    self.not_positive.extend(names);
                }
            }
            "<" | r"\lt" | r"\le" | r"\leq" | r"\leqslant" => {
                self.not_positive.extend(lone(left).filter(|_| is_not_above(right)));
                self.not_positive.extend(lone(right).filter(|_| is_negative(left)));
            }
            ">" | r"\gt" | r"\ge" | r"\geq" | r"\geqslant" => {
                self.not_positive.extend(lone(right).filter(|_| is_not_above(left)));
                self.not_positive.extend(lone(left).filter(|_| is_negative(right)));
            }
            "=" => self.not_positive.extend(lone(left).filter(|_| is_negative(right))),
            _ => {}
        }
    }

    /// What the words of its sentence say of a lone name of the running text: "$q$ is negative", "let $k$ be imaginary".
    fn note_words(&mut self, paper: &Paper, relation: &PrintedRelation) {
        let (file, span) = paper.locate(&relation.span());
        let before = window(&file.text, span.start.saturating_sub(BEFORE), span.start);
        let has = |text: &str, words: &[&str]| words.iter().any(|w| text.contains(w));
        for sentence in before.split_inclusive(['.', ';', '?']) {
            let lower = sentence.to_lowercase();
            let (negative, complex) = (has(&lower, NEGATIVE), has(&lower, COMPLEX));
            if !negative && !complex {
                continue;
            }
            let formulas = sentence.split('$').skip(1).step_by(2).filter(|f| f.len() <= LONGEST_NAME);
            for name in formulas.flat_map(|f| f.split(',')).map(squeezed).filter(|name| !name.is_empty()) {
                self.not_positive.insert(name.clone());
                if complex {
                    self.not_real.insert(name);
                }
            }
        }
    }
}

/// Whether a side begins with a minus.
fn is_negative(side: &PrintedSide) -> bool {
    side.text.trim_start().starts_with(['-', '−'])
}

/// Why the letters of a relation may be no numbers.
pub(super) fn other_kind(paper: &Paper, relation: &PrintedRelation) -> Option<String> {
    let (file, span) = paper.locate(&relation.span());
    let text = window(&file.text, span.start.saturating_sub(BEFORE), span.end + BEHIND).to_lowercase();
    if let Some(word) = OTHER_KINDS.iter().find(|w| text.contains(*w)) {
        return Some(format!("near the word “{word}”, so that its letters may be no numbers"));
    }
    let is_of_points = OF_POINTS.iter().any(|w| text.contains(w));
    let segment = relation.sides.iter().filter(|_| is_of_points).find_map(segment)?;
    Some(format!("`{segment}`, which may be the segment between two points"))
}

/// Two capitals right beside each other, as segments are printed.
fn segment(side: &PrintedSide) -> Option<String> {
    let mut letters = String::new();
    let mut previous = ' ';
    for c in side.text.chars().chain([' ']) {
        let is_point = c.is_ascii_uppercase() && previous != '\\' && !previous.is_ascii_lowercase();
        if is_point {
            letters.push(c);
        } else {
            if letters.len() == 2 && c != '_' {
                return Some(letters);
            }
            letters.clear();
        }
        previous = c;
    }
    None
}
