//! Shapes of verdicts: one symbol for each strength and each fate, the same everywhere.
//!
//! **In:** nothing. **Out:** a [`VerdictShape`] with its symbol for every kind of print, and the [`Tone`] of words. It lies below the story, its
//! printers and its drawings, all of which show it.

/// The weight or the colour of words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Tone {
    Plain,
    Strong,
    /// Beside the matter.
    Quiet,
    /// What stands.
    Good,
    /// What does not.
    Bad,
    /// What is open.
    Open,
    /// What asks for attention.
    Alarm,
}

/// A symbol for a verdict or a fate, readable without colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum VerdictShape {
    Proved,
    ProvedGiven,
    ProvedExcept,
    Unreplayed,
    Enclosed,
    Sampled,
    Weak,
    Fails,
    Certified,
    Mixed,
    Meaning,
    NoIdentity,
    NotApplicable,
    Undecided,
}

impl VerdictShape {
    /// All, in the order of the legend.
    pub const ALL: [VerdictShape; 14] = [
        VerdictShape::Proved,
        VerdictShape::ProvedGiven,
        VerdictShape::ProvedExcept,
        VerdictShape::Unreplayed,
        VerdictShape::Enclosed,
        VerdictShape::Sampled,
        VerdictShape::Weak,
        VerdictShape::Fails,
        VerdictShape::Certified,
        VerdictShape::Mixed,
        VerdictShape::Meaning,
        VerdictShape::NoIdentity,
        VerdictShape::NotApplicable,
        VerdictShape::Undecided,
    ];

    /// The symbol, its name in the style of the page, its command in LaTeX, and what it means.
    pub fn row(self) -> (&'static str, &'static str, &'static str, &'static str) {
        match self {
            VerdictShape::Proved => ("◆", "h p", r"$\blacklozenge$", "proved"),
            VerdictShape::ProvedGiven => ("◈", "h g", r"$\lozenge$", "proved from others"),
            VerdictShape::ProvedExcept => ("⬖", "h c", r"$\blacklozenge^{-}$", "proved, special cases apart"),
            VerdictShape::Unreplayed => ("⬗", "h o", r"$\Diamond^{+}$", "proved, not replayed"),
            VerdictShape::Enclosed => ("■", "h e", r"$\blacksquare$", "every time or point"),
            VerdictShape::Sampled => ("●", "h", r"$\bullet$", "at all samples"),
            VerdictShape::Weak => ("○", "h w", r"$\circ$", "holds, but so would altered formulas"),
            VerdictShape::Fails => ("✕", "f", r"$\times$", "fails at samples"),
            VerdictShape::Certified => ("✖", "f e", r"$\boldsymbol{\times}$", "refuted"),
            VerdictShape::Mixed => ("◐", "m", r"$\oslash$", "on some"),
            VerdictShape::Meaning => ("◇", "r", r"$\Diamond$", "by reading"),
            VerdictShape::NoIdentity => ("≢", "i", r"$\not\equiv$", "no identity: motions decide"),
            VerdictShape::NotApplicable => ("–", "n", "--", "does not apply"),
            VerdictShape::Undecided => ("?", "u", "?", "open"),
        }
    }

    /// The symbol.
    pub fn sign(self) -> &'static str {
        self.row().0
    }

    /// Its name in the style of the page.
    pub fn class(self) -> &'static str {
        self.row().1
    }

    /// Its meaning.
    pub fn says(self) -> &'static str {
        self.row().3
    }

    /// The colour of its words.
    pub fn tone(self) -> Tone {
        match self.class().as_bytes().first() {
            Some(b'h') => Tone::Good,
            Some(b'f' | b'm') => Tone::Bad,
            Some(b'u' | b'r') => Tone::Open,
            _ => Tone::Quiet,
        }
    }
}
