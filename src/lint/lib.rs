//! What follows, and what is wrong, of the formulas that a paper prints.
//!
//! **In:** a [`Paper`]. **Out:** for every printed relation one [`Word`], with its place: what is proved from what stands before
//! it, what a point refutes and a single slip away holds, what defines, what is a condition, and what was not read, with the name of the
//! feature.
//!
//! **Guaranteed:** *follows* is a proof, of the formula as it is read here, with the definitions that are named. *Wrong* is said only where a
//! point refutes a step, every name in it is defined or free there, and a formula that differs in one place is proved: that
//! is shown beside it. The same paper gives the same words.
//!
//! **Why this way:** a paper says more than its formulas, so what cannot be proved is nearly never wrong. Of a step that is a slip
//! away from an identity, that is another matter.

#![forbid(unsafe_code)]

mod bases;
mod blame;
mod branches;
mod cases;
mod chain;
mod defining;
mod desk;
mod doubt;
mod excuse;
mod facts;
mod headings;
mod held;
mod judge;
mod kinds;
mod letters;
mod lone;
mod markdown;
mod measured;
mod nearest;
mod notation;
mod numbers;
mod obstacle;
mod primes;
mod question;
mod refusal;
mod relation;
mod root;
mod sentence;
mod setting;
mod shown;
mod signs;
mod slips;
mod space;
mod standing;
mod step;
#[cfg(test)]
mod tests;
mod typeset;
mod vocabulary;
mod words;

use std::ops::Range;

use paper::Paper;

pub use judge::lint;
pub use refusal::NotRead;
pub use shown::{
    at_a_point, decimal, diagnostic, explained, is_listed, lint_text, nothing_tested, summary, tested, unlisted,
};
pub use typeset::{Typeset, typesetting};

/// What is said of a printed relation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Word {
    /// Proved, from what stands before it or outright.
    Follows,
    /// Not proved, and true at all random points that were tried.
    Numbers,
    /// A point refutes it, and a formula one slip away is proved.
    Wrong,
    /// A name is defined, one slip away from how it was defined before in the same part.
    Differs,
    /// A name is defined.
    Defines,
    /// It says what holds, or when.
    Condition,
    /// About equal, proportional, of this order.
    Approximates,
    /// Read, and nothing that stands before it decides it.
    NotFollowed,
    /// Not read.
    NotRead,
}

impl Word {
    /// All words.
    pub const ALL: [Word; 9] = [
        Word::Wrong,
        Word::Follows,
        Word::Numbers,
        Word::Differs,
        Word::Defines,
        Word::Condition,
        Word::Approximates,
        Word::NotFollowed,
        Word::NotRead,
    ];

    /// The word as it is printed.
    pub fn text(self) -> &'static str {
        match self {
            Word::Follows => "follows",
            Word::Numbers => "holds in numbers",
            Word::Wrong => "wrong",
            Word::Differs => "differs",
            Word::Defines => "defines",
            Word::Condition => "condition",
            Word::Approximates => "approximates",
            Word::NotFollowed => "not followed",
            Word::NotRead => "not read",
        }
    }
}

/// The word on a printed relation, and why.
#[derive(Clone, Debug, PartialEq)]
pub struct Judgement {
    /// The relation, by its number in [`Paper::printed`].
    pub relation: usize,
    /// The word.
    pub word: Word,
    /// Where: of a wrong step the side that was altered.
    pub span: Range<usize>,
    /// Why, in a few words; may be empty.
    pub why: String,
    /// Of a wrong step: what refutes it.
    pub witness: Option<LintWitness>,
    /// Of a wrong step: the altered side as it should be.
    pub instead: Option<String>,
    /// Of a wrong step: both sides along one name.
    pub picture: Option<LintPicture>,
    /// The relations that it follows from, or that define its name otherwise.
    pub with: Vec<usize>,
    /// How many of its steps are proved, and how many it has.
    pub steps: (usize, usize),
    /// Its steps in their order, where they were looked at.
    pub chain: Vec<LintStep>,
}

/// A step from one side of a relation to the next, with its own word.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LintStep {
    /// The place of its later side.
    pub span: Range<usize>,
    /// Its word.
    pub word: Word,
}

/// A point at which two sides differ.
#[derive(Clone, Debug, PartialEq)]
pub struct LintWitness {
    /// The values of the names, in decimals or as fractions.
    pub values: Vec<(String, String)>,
    /// The earlier side.
    pub left: f64,
    /// The later side.
    pub right: f64,
}

/// A value of the name, and both sides there, where they have a value.
pub type PicturePoint = (f64, Option<f64>, Option<f64>);

/// Two sides along one name, all others being as in the witness.
#[derive(Clone, Debug, PartialEq)]
pub struct LintPicture {
    /// The name, in LaTeX.
    pub name: String,
    /// Its values, in their order, with both sides where they have a value.
    pub points: Vec<PicturePoint>,
}

/// What was found of a paper.
#[derive(Clone, Debug)]
pub struct Lint {
    /// One for each printed relation, in their order; words that stand alone in a display are none.
    pub judgements: Vec<Judgement>,
}

impl Lint {
    /// How often a word is said.
    pub fn count(&self, word: Word) -> usize {
        self.judgements.iter().filter(|j| j.word == word).count()
    }

    /// Steps from one side to the next that were proved.
    pub fn proved_steps(&self) -> usize {
        self.judgements.iter().map(|j| j.steps.0).sum()
    }
}

/// The line of a judgement in its file.
pub fn line(paper: &Paper, judgement: &Judgement) -> usize {
    paper.line(&judgement.span)
}
