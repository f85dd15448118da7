//! What single sections and chapters show of their names, where the whole paper shows several things.
//!
//! **In:** printed relations. **Out:** in which sections something is derived, and by what; in which there are matrices; in which chapters `e` is a factor; which names a chapter sets equal to a matrix. **Guaranteed:** nothing is decided here.

use std::collections::BTreeSet;

use super::super::printed::{PrintedRelation, PrintedSide};
use super::super::token::{Kind, Token};
use super::letters::{BOLD, STYLES, is_letter_command};
use super::{Call, PaperName, unprimed};

/// What shows that a section derives, or integrates.
const OF_CALCULUS: &[&str] = &[r"\int", r"\nabla", r"\partial", r"\lim", r"\mathrm{d}", r"\oint"];

/// What single sections and chapters show.
#[derive(Clone, Debug, Default)]
pub struct Local {
    /// Sections in which something is derived or integrated.
    calculus: BTreeSet<usize>,
    /// Names with something in parentheses behind them, by section.
    called: BTreeSet<(usize, String)>,
    /// Chapters in which an italic `e` is raised to something else than a number.
    exponentials: BTreeSet<usize>,
    /// Chapters in which an italic `e` stands beside another factor.
    factors_e: BTreeSet<usize>,
    /// Sections in which a matrix is written out, or a letter is bold.
    matrices: BTreeSet<usize>,
    /// Names by which something is derived in a section, and not partially.
    derived_by: BTreeSet<(usize, String)>,
    /// Names by which something is derived in a chapter, or at which a function is taken, `y(x)`.
    variables: BTreeSet<(usize, String)>,
    /// Names with a rate, or a prime, by section.
    moving: BTreeSet<(usize, String)>,
    /// Names that are equal to a matrix, by chapter.
    sized: BTreeSet<(usize, String)>,
}

impl Local {
    /// Takes note of a side.
    pub(super) fn note_side(&mut self, relation: &PrintedRelation, side: &PrintedSide) {
        if OF_CALCULUS.iter().any(|sign| side.text.contains(sign)) {
            self.calculus.insert(relation.section);
        }
        if side.text.contains("matrix}") || side.text.contains("array}") || side.text.contains(r"\det") {
            self.matrices.insert(relation.section);
        }
        let all: Vec<&Token> = side.tokens.iter().filter(|t| t.kind != Kind::Space).collect();
        for at in (0..all.len()).filter(|&i| is_italic_e(&all, i)) {
            let closed = usize::from(is_kind(&all, at + 1, Kind::Close));
            let power = at + 1 + closed;
            if all.get(power).is_some_and(|t| t.is_char("^")) {
                let braced = is_kind(&all, power + 1, Kind::Open);
                let raised = all[(power + 1 + usize::from(braced)).min(all.len())..].iter();
                let end = |t: &&&Token| if braced { t.kind != Kind::Close } else { true };
                let most = if braced { usize::MAX } else { 1 };
                if !raised.take_while(end).take(most).all(|t| t.text.bytes().all(|b| b.is_ascii_digit())) {
                    self.exponentials.insert(relation.chapter);
                }
            } else if at > 0 && is_factor(all[at - 1]) || all.get(at + 1).is_some_and(|t| is_factor(t)) {
                self.factors_e.insert(relation.chapter);
            }
        }
    }

    /// Takes note of a name.
    pub(super) fn note_name(&mut self, relation: &PrintedRelation, name: &PaperName) {
        let called = name.primes > 0 && matches!(name.call, Call::Places(_));
        if matches!(name.call, Call::Places(_)) {
            self.called.insert((relation.section, unprimed(name)));
        }
        let by = name.derived_by.as_ref().filter(|_| !name.is_partial);
        let place = match &name.call {
            Call::Places(places) if places.len() == 1 => places.first(),
            _ => None,
        };
        self.derived_by.extend(by.map(|v| (relation.section, v.clone())));
        self.variables.extend(by.into_iter().chain(place).map(|v| (relation.chapter, v.clone())));
        if name.primes + name.dots > 0 || by.is_some_and(|by| by == "t") {
            self.moving.insert((relation.section, unprimed(name)));
        }
        if name.is_bold {
            self.matrices.insert(relation.section);
        }
        let differs = name.is_difference && name.letter == "d";
        if name.dots > 0 || name.derived_by.is_some() || name.primes > 1 || called || differs {
            self.calculus.insert(relation.section);
        }
    }

    /// Takes note that a name is equal to a matrix.
    pub(super) fn note_size(&mut self, relation: &PrintedRelation, key: &str) {
        self.sized.insert((relation.chapter, key.to_owned()));
    }

    /// Whether the primes of a name could derive it in a section: something is derived there, or integrated, or the name is a function.
    pub fn may_derive(&self, section: usize, bare: &str) -> bool {
        self.calculus.contains(&section) || self.called.contains(&(section, bare.to_owned()))
    }

    /// Whether something of a chapter is a function of this, and it is no function itself in a section of it.
    pub fn is_independent(&self, chapter: usize, section: usize, key: &str) -> bool {
        self.variables.contains(&(chapter, key.to_owned())) && !self.moving.contains(&(section, key.to_owned()))
    }

    /// The names of which a section prints a rate, or a prime at them.
    pub fn moving_in(&self, section: usize) -> impl Iterator<Item = &str> {
        let from = (section, String::new())..(section + 1, String::new());
        self.moving.range(from).map(|(_, name)| name.as_str())
    }

    /// Whether a section prints a rate of a name, or a prime at it.
    pub fn moves(&self, section: usize, key: &str) -> bool {
        self.moving.contains(&(section, key.to_owned()))
    }

    /// Whether something is derived by this in a section, in which it has no rate.
    pub fn derives(&self, section: usize, key: &str) -> bool {
        let own = (section, key.to_owned());
        self.derived_by.contains(&own) && !self.moving.contains(&own)
    }

    /// Whether `e` is a name in a chapter: it stands there as a factor, and is raised to numbers alone.
    pub fn is_e_a_name(&self, chapter: usize) -> bool {
        self.factors_e.contains(&chapter) && !self.exponentials.contains(&chapter)
    }

    /// Whether a section prints a matrix, or a letter in bold.
    pub fn has_matrices(&self, section: usize) -> bool {
        self.matrices.contains(&section)
    }

    /// Whether a chapter sets a name equal to a matrix.
    pub fn is_sized(&self, chapter: usize, key: &str) -> bool {
        self.sized.contains(&(chapter, key.to_owned()))
    }
}

fn is_kind(all: &[&Token], at: usize, kind: Kind) -> bool {
    all.get(at).is_some_and(|t| t.kind == kind)
}

/// Whether `e` stands here in the style of a variable, without a label, and not below another letter.
fn is_italic_e(all: &[&Token], at: usize) -> bool {
    let before = |n: usize| at.checked_sub(n).and_then(|i| all.get(i));
    let opened = before(1).is_some_and(|t| t.kind == Kind::Open);
    let outside = if opened { before(2) } else { before(1) };
    let is_style = |t: &&Token| t.kind == Kind::Command && STYLES.contains(&t.text.as_str());
    let is_styled = outside.is_some_and(is_style) || before(1).is_some_and(is_style);
    let is_below = outside.is_some_and(|t| t.is_char("_"));
    all[at].is_char("e") && !is_styled && !is_below && !all.get(at + 1).is_some_and(|t| t.is_char("_"))
}

/// Whether a token begins or ends a factor that is no number.
fn is_factor(token: &Token) -> bool {
    match token.kind {
        Kind::Other => token.text.chars().all(char::is_alphabetic) && token.text != "e",
        Kind::Command => {
            let c = token.text.as_str();
            is_letter_command(c) || BOLD.contains(&c) || latex::is_function(c)
        }
        Kind::Open | Kind::Close | Kind::Dollar | Kind::Space | Kind::Argument => false,
    }
}
