//! Whose a claim is, and what it is for.
//!
//! A derivation file holds more than what a paper says: what the paper needs, what would be true instead, lemmas without which
//! nothing could be proved. What becomes of a sentence follows from what the paper says, and from nothing else; so each claim
//! and each reading says which of these it is.

/// What a claim, or a reading of it, is to the paper.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum ClaimRole {
    /// The paper says it, literally or in its context. All readings of this kind are parts of what is said.
    #[default]
    Says,
    /// One of several things that the sentence may mean.
    MayMean,
    /// The paper needs it: it uses more than it says, or it presupposes something.
    Needs,
    /// The contrary of the sentence.
    Against,
    /// The paper does not say it: it was added to compare.
    Added,
    /// A lemma of the file, which proofs use.
    Lemma,
    /// A choice that the paper makes, of a convention or a laboratory, say: it is neither true nor false.
    Choice,
}

impl ClaimRole {
    /// Every role, in the order of the documentation.
    pub const ALL: [ClaimRole; 7] = [
        ClaimRole::Says,
        ClaimRole::MayMean,
        ClaimRole::Needs,
        ClaimRole::Against,
        ClaimRole::Added,
        ClaimRole::Lemma,
        ClaimRole::Choice,
    ];

    /// Its word in the file and in reports.
    pub fn word(self) -> &'static str {
        match self {
            ClaimRole::Says => "says",
            ClaimRole::MayMean => "may-mean",
            ClaimRole::Needs => "needs",
            ClaimRole::Against => "against",
            ClaimRole::Added => "added",
            ClaimRole::Lemma => "lemma",
            ClaimRole::Choice => "choice",
        }
    }

    /// The role with this word.
    pub fn of(word: &str) -> Option<ClaimRole> {
        ClaimRole::ALL.into_iter().find(|r| r.word() == word)
    }

    /// Whether the fate of the sentence follows from it.
    pub fn decides(self) -> bool {
        match self {
            ClaimRole::Says | ClaimRole::MayMean => true,
            ClaimRole::Needs | ClaimRole::Against | ClaimRole::Added | ClaimRole::Lemma | ClaimRole::Choice => false,
        }
    }

    /// Whether it is about a sentence of the paper at all.
    pub fn is_of_the_paper(self) -> bool {
        match self {
            ClaimRole::Says | ClaimRole::MayMean | ClaimRole::Needs | ClaimRole::Against => true,
            ClaimRole::Added | ClaimRole::Lemma | ClaimRole::Choice => false,
        }
    }
}
