//! What became of each claim as a whole: its readings taken together.
//!
//! **In:** the account. **Out:** one [`Whole`] for each claim of the file, with its [`Fate`], and the sentence that counts them.
//! A reader asks which claims stand; thousands of verdicts do not say it. Nothing is judged here: a fate follows from the
//! verdicts of the readings by the table of [`Fate`].
//!
//! What the file adds for comparison is no claim of the paper: such a reading says nothing on the fate of its claim, and a claim
//! that is added as a whole is told by itself.

use super::numbers::count;
use super::tally::{Standing, declared};
use crate::check::separation::{ConditionName, Explanation, Join};
use crate::check::{Account, ClaimAccount};
use crate::derivation::Derivation;

/// What became of a claim. S is the set of the standings of its readings; those that apply to no trajectory do not count.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Fate {
    /// None holds throughout or in part, one fails.
    Fails,
    /// None holds throughout, one holds on some trajectories and fails on others.
    Partly,
    /// One holds throughout, another fails somewhere.
    Reading,
    /// None fails anywhere, one is undecided somewhere.
    Open,
    /// None applies to any trajectory.
    Nowhere,
    /// All hold wherever they apply.
    Stands,
    /// The paper does not say it.
    Added,
}

impl Fate {
    /// In the order in which they are told: what does not stand comes first.
    pub const ALL: [Fate; 7] =
        [Fate::Fails, Fate::Partly, Fate::Reading, Fate::Open, Fate::Nowhere, Fate::Stands, Fate::Added];
    /// In the order of the sentence that counts them, without what is added.
    pub const TOLD: [Fate; 6] = [Fate::Stands, Fate::Reading, Fate::Partly, Fate::Fails, Fate::Open, Fate::Nowhere];

    fn of(readings: &[Reading<'_>]) -> Fate {
        if !readings.is_empty() && readings.iter().all(|r| r.added) {
            return Fate::Added;
        }
        let any = |standing: Standing| readings.iter().any(|r| !r.added && r.standing == standing);
        match (any(Standing::Holds), any(Standing::Mixed), any(Standing::Fails), any(Standing::Open)) {
            (true, true, _, _) | (true, _, true, _) => Fate::Reading,
            (false, true, _, _) => Fate::Partly,
            (false, false, true, _) => Fate::Fails,
            (_, false, false, true) => Fate::Open,
            (true, false, false, false) => Fate::Stands,
            (false, false, false, false) => Fate::Nowhere,
        }
    }

    /// A name for links.
    pub fn key(self) -> &'static str {
        match self {
            Fate::Fails => "fail",
            Fate::Partly => "partly",
            Fate::Reading => "reading",
            Fate::Open => "open",
            Fate::Nowhere => "nowhere",
            Fate::Stands => "stand",
            Fate::Added => "added",
        }
    }

    /// The verb of a heading, for so many claims.
    pub fn words(self, n: usize) -> &'static str {
        match (self, n) {
            (Fate::Fails, 1) => "does not hold",
            (Fate::Fails, _) => "do not hold",
            (Fate::Partly, 1) => "holds on some motions and fails on others",
            (Fate::Partly, _) => "hold on some motions and fail on others",
            (Fate::Reading, 1) => "depends on how it is read",
            (Fate::Reading, _) => "depend on how they are read",
            (Fate::Open, 1) => "is not settled",
            (Fate::Open, _) => "are not settled",
            (Fate::Nowhere, 1) => "applies to none of the motions",
            (Fate::Nowhere, _) => "apply to none of the motions",
            (Fate::Stands, 1) => "stands",
            (Fate::Stands, _) => "stand",
            (Fate::Added, 1) => "was added for comparison",
            (Fate::Added, _) => "were added for comparison",
        }
    }

    /// What the words mean.
    pub fn meaning(self) -> &'static str {
        match self {
            Fate::Fails => "In no reading does it hold on any motion to which it applies.",
            Fate::Partly => "What separates the motions is said beside each.",
            Fate::Reading => "One reading holds wherever it applies, another fails somewhere.",
            Fate::Open => "The evidence settles no failure, and not everything.",
            Fate::Nowhere => "No motion meets what they assume.",
            Fate::Stands => "They hold on every motion to which they apply, in every reading that was tried.",
            Fate::Added => "The paper does not say it. It is checked like the rest, to compare with.",
        }
    }
}

/// One reading of a claim, or the claim itself.
pub(super) struct Reading<'a> {
    pub claim: &'a ClaimAccount,
    pub standing: Standing,
    /// Whether the paper does not say it.
    pub added: bool,
}

/// A claim with all its readings.
pub(super) struct Whole<'a> {
    pub id: &'a str,
    /// What it says, in the words of the file.
    pub says: String,
    pub place: Option<&'a str>,
    pub readings: Vec<Reading<'a>>,
    pub fate: Fate,
}

impl Whole<'_> {
    /// Whether it has readings of which the file names each.
    pub fn is_read(&self) -> bool {
        self.readings.iter().any(|r| r.claim.reading.is_some())
    }

    /// Whether every reading of the paper is proved for all values.
    pub fn is_proved(&self) -> bool {
        let of_the_paper = |r: &&Reading<'_>| !r.added || self.fate == Fate::Added;
        self.readings
            .iter()
            .filter(of_the_paper)
            .all(|r| r.claim.identity.as_ref().is_some_and(crate::check::IdentityAccount::is_proved))
    }
}

/// The claims of an account, in the order of the file.
pub(super) fn wholes<'a>(derivation: &'a Derivation, account: &'a Account) -> Vec<Whole<'a>> {
    let mut out: Vec<Whole<'a>> = Vec::new();
    for claim in &account.claims {
        let added = declared(derivation, claim).is_some_and(|d| d.added);
        let reading = Reading { claim, standing: Standing::of(claim), added };
        match out.last_mut() {
            Some(whole) if whole.id == claim.id => whole.readings.push(reading),
            _ => {
                let parent = declared(derivation, claim).and_then(|d| d.parent_says.clone());
                let says = parent.unwrap_or_else(|| claim.says.clone());
                let place = claim.place.as_deref();
                out.push(Whole { id: &claim.id, says, place, readings: vec![reading], fate: Fate::Nowhere });
            }
        }
    }
    for whole in &mut out {
        whole.fate = Fate::of(&whole.readings);
    }
    out
}

/// The sentence that counts: `Of 61 claims 33 stand, 24 depend on how they are read, …`.
pub(super) fn headline(wholes: &[Whole<'_>]) -> String {
    let of = |fate: Fate| wholes.iter().filter(|w| w.fate == fate).count();
    let mut parts: Vec<String> = Vec::new();
    for fate in Fate::TOLD {
        let n = of(fate);
        if n > 0 {
            parts.push(format!("{n} {}", fate.words(n)));
        }
    }
    let added = of(Fate::Added);
    let all = count(wholes.len() - added, "claim");
    let sentence = match parts.as_slice() {
        [] => format!("{all}."),
        [one] => match wholes.iter().find(|w| w.fate != Fate::Added).map(|w| w.fate) {
            Some(fate) if wholes.len() - added > 1 => format!("All {all} {}.", fate.words(2)),
            _ => format!("Of {all} {one}."),
        },
        [one, last] => format!("Of {all} {one} and {last}."),
        [more @ .., last] => format!("Of {all} {}, and {last}.", more.join(", ")),
    };
    match added {
        0 => sentence,
        n => format!("{sentence} {n} more {}.", Fate::Added.words(n)),
    }
}

/// A condition under which claims hold that fail without it.
pub(super) struct Unsaid<'a> {
    pub explanation: &'a Explanation,
    /// The claims and readings that it separates, in the order of the file.
    pub claims: Vec<&'a ClaimAccount>,
}

/// Every condition that separates the motions of some claim of the paper: those of most claims first.
pub(super) fn unsaid<'a>(derivation: &Derivation, account: &'a Account) -> Vec<Unsaid<'a>> {
    let mut out: Vec<Unsaid<'a>> = Vec::new();
    for claim in account.claims.iter().filter(|c| declared(derivation, c).is_none_or(|d| !d.added)) {
        let Some(explanation) = claim.conditions.separation.as_ref().and_then(|s| s.explanation.as_ref()) else {
            continue;
        };
        match out.iter_mut().find(|u| u.explanation == explanation) {
            Some(known) => known.claims.push(claim),
            None => out.push(Unsaid { explanation, claims: vec![claim] }),
        }
    }
    out.sort_by_key(|u| std::cmp::Reverse(u.claims.len()));
    out
}

/// A condition in the words of the file; its formula, between dollar signs, where it has none.
pub(super) fn condition(c: &ConditionName) -> String {
    let text = match (&c.id, &c.says) {
        (Some(_), Some(says)) => says.trim_end_matches('.').to_owned(),
        (None, Some(says)) => format!("${}$ {says}", c.formula),
        (_, None) => format!("${}$", c.formula),
    };
    if c.negated { format!("it is not so that {text}") } else { text }
}

/// Conditions put together: `A, and B`.
pub(super) fn explanation(e: &Explanation) -> String {
    let parts: Vec<String> = e.conditions.iter().map(condition).collect();
    match e.join {
        Join::And => parts.join(", and "),
        Join::Or => parts.join(", or "),
    }
}

/// Where a reading holds, in a few words; the beginning of a sentence.
pub(super) fn verdict(reading: &Reading<'_>) -> String {
    if let Some(region) = &reading.claim.region {
        let (word, rest) = match region.verdict.outcome().word() {
            "holds" => ("Holds", " over the ranges"),
            "fails" => ("Fails", " over the ranges"),
            "undecided" => ("Undecided", " over the ranges"),
            _ => ("Applies", " nowhere in the ranges"),
        };
        return format!("{word}{rest}");
    }
    let n = |word: &str| reading.claim.results.iter().filter(|r| r.verdict.outcome().word() == word).count();
    match reading.standing {
        Standing::Holds if reading.claim.identity.as_ref().is_some_and(crate::check::IdentityAccount::is_proved) => {
            "Holds, proved for all values".to_owned()
        }
        Standing::Holds => match n("holds") {
            1 => "Holds on the one motion to which it applies".to_owned(),
            2 => "Holds on both motions to which it applies".to_owned(),
            n => format!("Holds on all {n} motions to which it applies"),
        },
        Standing::Fails => match n("fails") {
            1 => "Fails on the one motion to which it applies".to_owned(),
            n if reading.claim.results.iter().any(|r| r.verdict.outcome().word() == "undecided") => {
                format!("Fails on {}, undecided on others", count(n, "motion"))
            }
            2 => "Fails on both motions to which it applies".to_owned(),
            n => format!("Fails on all {n} motions to which it applies"),
        },
        Standing::Mixed => format!("Holds on {}, fails on {}", count(n("holds"), "motion"), n("fails")),
        Standing::Open if n("holds") > 0 => {
            format!("Holds on {}, undecided on {}", count(n("holds"), "motion"), n("undecided"))
        }
        Standing::Open => format!("Undecided on {}", count(n("undecided"), "motion")),
        Standing::Nowhere => "Applies to none of the motions".to_owned(),
    }
}

/// What a mixed reading needs: `here it holds exactly where …`, with a word on rivals.
pub(super) fn condition_of(claim: &ClaimAccount) -> Option<String> {
    let s = claim.conditions.separation.as_ref()?;
    let Some(e) = &s.explanation else {
        return Some("no condition that was tried separates them".to_owned());
    };
    let rivals = match s.rivals.len() + s.more_rivals {
        0 => "",
        1 => " (one other condition would separate them, too)",
        _ => " (other conditions would separate them, too)",
    };
    Some(format!("it holds exactly where {}{rivals}", explanation(e)))
}

#[cfg(all(test, debug_assertions))]
mod tests {
    use super::super::tests::derivation;
    use super::*;
    use crate::check::sample;

    fn fate(standings: &[Standing]) -> Fate {
        let account = sample::account();
        let readings: Vec<Reading<'_>> =
            standings.iter().map(|&standing| Reading { claim: &account.claims[0], standing, added: false }).collect();
        Fate::of(&readings)
    }

    #[test]
    fn a_claim_stands_only_if_all_of_it_does() {
        use Standing::{Fails, Holds, Mixed, Nowhere, Open};
        for (standings, expected) in [
            (&[Holds][..], Fate::Stands),
            (&[Holds, Nowhere], Fate::Stands),
            (&[Holds, Open], Fate::Open),
            (&[Holds, Mixed], Fate::Reading),
            (&[Holds, Fails, Open], Fate::Reading),
            (&[Mixed], Fate::Partly),
            (&[Mixed, Fails, Open], Fate::Partly),
            (&[Fails, Open], Fate::Fails),
            (&[Fails, Nowhere], Fate::Fails),
            (&[Nowhere], Fate::Nowhere),
            (&[], Fate::Nowhere),
        ] {
            assert_eq!(fate(standings), expected, "{standings:?}");
        }
    }

    #[test]
    fn what_is_added_does_not_count() {
        let account = sample::account();
        let reading = |standing, added| Reading { claim: &account.claims[0], standing, added };
        let fate = |readings: &[Reading<'_>]| Fate::of(readings);
        assert_eq!(fate(&[reading(Standing::Holds, false), reading(Standing::Fails, true)]), Fate::Stands);
        assert_eq!(fate(&[reading(Standing::Fails, false), reading(Standing::Holds, true)]), Fate::Fails);
        assert_eq!(fate(&[reading(Standing::Holds, false), reading(Standing::Fails, false)]), Fate::Reading);
        assert_eq!(fate(&[reading(Standing::Holds, true), reading(Standing::Fails, true)]), Fate::Added);
    }

    #[test]
    fn every_claim_is_counted_once() {
        let (derivation, account) = (derivation(), sample::account());
        let wholes = wholes(&derivation, &account);
        let readings: usize = wholes.iter().map(|w| w.readings.len()).sum();
        assert_eq!(readings, account.claims.len());
        let told: usize = Fate::ALL.iter().map(|f| wholes.iter().filter(|w| w.fate == *f).count()).sum();
        assert_eq!(told, wholes.len());
        let sentence = headline(&wholes);
        assert!(sentence.starts_with(['O', 'A']) && sentence.ends_with('.'), "{sentence}");
    }
}
