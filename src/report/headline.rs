//! The sentence that counts the claims of a paper by what became of them.
//!
//! **In:** the claims, each with all its readings. **Out:** `Of 54 claims 33 stand, 4 do not hold, …`, and what is in the file beside
//! the paper's claims. A claim is counted once: what stands in its words, and fails in the sense in which the paper's argument uses
//! it, has a number of its own; so has what stands on the motions of the file, and fails on one that was drawn at random. Sentence, strip,
//! matrix, cards and chains take from [`CountedFate`] what they say of a claim that stands.

use super::digest::{Fate, Whole, listed};
use super::numbers::count;
use super::shape::VerdictShape;
use findings::{Account, ClaimAccount};

/// What a claim is counted as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum CountedFate {
    Fate(Fate),
    /// It stands as it is said, and a reading that the paper needs fails.
    AsSaid,
    /// It stands on the motions of the file, and fails on another that was drawn at random.
    OnFile,
}

impl CountedFate {
    /// In the order of the sentence.
    pub fn told() -> impl Iterator<Item = CountedFate> {
        let standing = [CountedFate::AsSaid, CountedFate::OnFile];
        let of_fate = move |fate| {
            let others = standing.into_iter().filter(move |_| fate == Fate::Stands);
            std::iter::once(CountedFate::Fate(fate)).chain(others)
        };
        Fate::TOLD.into_iter().flat_map(of_fate)
    }

    /// The fate.
    pub fn fate(self) -> Fate {
        match self {
            CountedFate::Fate(fate) => fate,
            CountedFate::AsSaid | CountedFate::OnFile => Fate::Stands,
        }
    }

    /// Whether it stands, and nothing that was tried is against it.
    pub fn stands(self) -> bool {
        self == CountedFate::Fate(Fate::Stands)
    }

    /// The symbol in the strip of all claims, where it is not that of the verdicts.
    pub fn shape(self) -> Option<VerdictShape> {
        match self {
            CountedFate::Fate(_) => None,
            CountedFate::AsSaid => Some(VerdictShape::Meaning),
            CountedFate::OnFile => Some(VerdictShape::Mixed),
        }
    }

    /// The verb, for so many claims.
    pub fn words(self, n: usize) -> &'static str {
        match (self, n) {
            (CountedFate::Fate(fate), n) => fate.words(n),
            (CountedFate::AsSaid, 1) => "stands as stated, but fails as the paper uses it",
            (CountedFate::AsSaid, _) => "stand as stated, but fail as the paper uses them",
            (CountedFate::OnFile, 1) => "stands on the motions of the file, but fails on another, drawn at random",
            (CountedFate::OnFile, _) => "stand on the motions of the file, but fail on others, drawn at random",
        }
    }
}

/// The sentence that counts.
pub(super) fn headline(wholes: &[Whole<'_>]) -> String {
    let all = CountedFate::told().map(|counted| (counted, wholes.iter().filter(|w| w.counted_as() == counted).count()));
    let found: Vec<(CountedFate, usize)> = all.filter(|(_, n)| *n > 0).collect();
    let told: usize = found.iter().map(|(_, n)| n).sum();
    let claims = count(told, "claim");
    match found.as_slice() {
        [] => format!("{claims}."),
        [(counted, 1)] => format!("The claim {}.", counted.words(1)),
        [(counted, n)] => format!("All {claims} {}.", counted.words(*n)),
        several => {
            let parts: Vec<String> = several.iter().map(|(counted, n)| format!("{n} {}", counted.words(*n))).collect();
            format!("Of {claims} {}.", listed(&parts))
        }
    }
}

/// The heading over the claims of one fate. What stands in its words and fails as it is used is told in it: a page has one count.
pub(super) fn heading(fate: Fate, found: &[&Whole<'_>]) -> String {
    let counted = |counted: CountedFate| found.iter().filter(|w| w.counted_as() == counted).count();
    let others = CountedFate::told().filter(|c| c.fate() == fate && *c != CountedFate::Fate(fate));
    let all = std::iter::once(CountedFate::Fate(fate)).chain(others).map(|c| (c, counted(c))).filter(|(_, n)| *n > 0);
    let part = |(at, (c, n)): (usize, (CountedFate, usize))| match at {
        0 => format!("{} {}", count(n, "claim"), c.words(n)),
        _ => format!("{n} {}", c.words(n)),
    };
    listed(&all.enumerate().map(part).collect::<Vec<_>>())
}

/// How the claims were tried, each meaning and what is added for comparison by itself, in a sentence.
pub(super) fn tried(account: &Account) -> String {
    let s = account.summary();
    let parts = [
        (s.holds, "holds", "hold"),
        (s.fails, "fails", "fail"),
        (s.not_applicable, "does not apply", "do not apply"),
        (s.undecided, "is undecided", "are undecided"),
    ];
    let parts = parts.into_iter().filter(|(n, ..)| *n > 0);
    let parts: Vec<String> = parts.map(|(n, one, more)| format!("{n} {}", if n == 1 { one } else { more })).collect();
    let motions = match account.trajectories.len() {
        0 => "Over ranges and for all values".to_owned(),
        n => format!("On {}", count(n, "motion")),
    };
    let told = if parts.is_empty() { "nothing was decided".to_owned() } else { listed(&parts) };
    format!("{motions}, with every reading and what is added for comparison, one by one: {told}.")
}

/// The claims and meanings of which a verdict is not as the file expects.
pub(super) fn unexpected(account: &Account) -> Vec<&ClaimAccount> {
    let is_unexpected = |c: &&ClaimAccount| c.is_unexpected_alone() || c.verdicts().any(|j| j.unexpected);
    account.claims.iter().filter(is_unexpected).collect()
}

/// What is in the file beside the paper's claims, in a sentence; `None` where there is nothing.
pub(super) fn beside(wholes: &[Whole<'_>]) -> Option<String> {
    let parts: Vec<String> = [Fate::Choice, Fate::Lemma, Fate::Added]
        .into_iter()
        .map(|fate| (fate, wholes.iter().filter(|w| w.fate == fate).count()))
        .filter(|(_, n)| *n > 0)
        .map(|(fate, n)| format!("{n} {}", fate.words(n)))
        .collect();
    (!parts.is_empty()).then(|| format!("Not counted: {}.", listed(&parts)))
}

#[cfg(all(test, debug_assertions))]
mod tests {
    use super::super::digest::wholes;
    use super::super::tests::derivation;
    use super::*;
    use derivation::ClaimRole;
    use findings::sample;

    #[test]
    fn the_sentence_counts_every_claim_of_the_paper_once() {
        let (derivation, account) = (derivation(), sample::account());
        let wholes = wholes(&derivation, &account);
        let told: usize = CountedFate::told().map(|c| wholes.iter().filter(|w| w.counted_as() == c).count()).sum();
        assert_eq!(told, wholes.iter().filter(|w| w.fate.is_of_the_paper()).count());
        let sentence = headline(&wholes);
        assert!(sentence.starts_with(['O', 'A']) && sentence.ends_with('.'), "{sentence}");
    }

    /// A claim of which a needed reading fails is not among those that stand.
    #[test]
    fn what_fails_as_it_is_needed_has_its_own_number() {
        let (derivation, account) = (derivation(), sample::account());
        let mut all = wholes(&derivation, &account);
        let refuted = |w: &Whole<'_>| w.failing().is_some() && w.readings.len() == 1;
        let at = all.iter().position(refuted).expect("a claim that fails");
        let mut needed = all.remove(at).readings;
        needed.iter_mut().for_each(|r| r.role = ClaimRole::Needs);
        let stands = all.iter().position(|w| w.fate == Fate::Stands).expect("a claim that stands");
        let mut one = vec![all.remove(stands)];
        assert_eq!(headline(&one), "The claim stands.");
        one[0].readings.extend(needed);
        assert_eq!(headline(&one), "The claim stands as stated, but fails as the paper uses it.");
    }
}
