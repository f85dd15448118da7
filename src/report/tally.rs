//! What a row of verdicts amounts to, in words.

use derivation::{Claim, Derivation};
use findings::{ClaimAccount, Outcome, PairAccount};

/// How a claim fares as a whole.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Standing {
    /// It holds wherever it applies.
    Holds,
    /// It holds on some trajectories and fails on others.
    Mixed,
    /// It fails wherever it applies.
    Fails,
    /// It fails nowhere, but is undecided somewhere.
    Open,
    /// It applies nowhere.
    Nowhere,
}

impl Standing {
    /// The standing of a claim.
    pub fn of(claim: &ClaimAccount) -> Standing {
        // A family that fails may hold on some of its members.
        let member = |word: &str| claim.families.iter().any(|f| super::family::with(f, word) > 0);
        let any = |word: &str| claim.verdicts().any(|j| j.verdict.outcome().word() == word) || member(word);
        match claim.verdict_alone() {
            Some("holds") => return Standing::Holds,
            Some("fails") => return Standing::Fails,
            Some(_) => return Standing::Open,
            None => {}
        }
        match (any("holds"), any("fails"), any("undecided")) {
            (true, true, _) => Standing::Mixed,
            (false, true, _) => Standing::Fails,
            (_, false, true) => Standing::Open,
            (true, false, false) => Standing::Holds,
            (false, false, false) => Standing::Nowhere,
        }
    }
}

/// Pairs of one claim with the same outcome and the same expectation.
pub(super) struct Group<'a> {
    pub word: &'static str,
    pub expected: Option<&'static str>,
    pub unexpected: bool,
    pub pairs: Vec<&'a PairAccount>,
}

impl Group<'_> {
    /// The pair that tells most: the largest residual, otherwise the first.
    pub fn telling(&self) -> Option<&PairAccount> {
        let residual = |p: &PairAccount| p.verdict.evidence().residual.as_ref().map_or(-1.0, |r| r.max);
        self.pairs.iter().copied().reduce(|a, b| if residual(b) > residual(a) { b } else { a })
    }
}

/// The groups of a claim: where it holds, where it fails, what is undecided, where it does not apply.
pub(super) fn groups(claim: &ClaimAccount) -> Vec<Group<'_>> {
    let mut out: Vec<Group<'_>> = Vec::new();
    for pair in &claim.results {
        let word = pair.verdict.outcome().word();
        match out.iter_mut().find(|g| g.word == word && g.expected == pair.expected) {
            Some(group) => group.pairs.push(pair),
            None => {
                let unexpected = pair.is_unexpected();
                out.push(Group { word, expected: pair.expected, unexpected, pairs: vec![pair] });
            }
        }
    }
    let order = ["holds", "fails", "undecided"];
    out.sort_by_key(|g| order.iter().position(|w| *w == g.word).unwrap_or(order.len()));
    out
}

/// What fails first: the order in which the groups of a claim are told.
pub(super) fn in_order(groups: &mut [Group<'_>]) {
    groups.sort_by_key(|g| ["fails", "holds", "undecided"].iter().position(|w| *w == g.word).unwrap_or(3));
}

/// One letter for a verdict, readable without colour.
pub(super) fn glyph(outcome: Outcome) -> char {
    match outcome {
        Outcome::Holds(_) => 'H',
        Outcome::Fails(_) => 'F',
        Outcome::NotApplicable(_) => '-',
        Outcome::Undecided => '?',
    }
}

/// `id`, or `id/reading`.
pub(super) fn name(claim: &ClaimAccount) -> String {
    match &claim.reading {
        Some(reading) => format!("{}/{reading}", claim.id),
        None => claim.id.clone(),
    }
}

/// What a claim says; for a reading, first what its claim says.
pub(super) fn says(derivation: &Derivation, claim: &ClaimAccount) -> String {
    match declared(derivation, claim).and_then(|d| d.parent_says.as_ref()) {
        Some(parent) => format!("{}: {}", parent.trim_end_matches('.'), claim.says),
        None => claim.says.clone(),
    }
}

/// The claim of the file that an account is of.
pub(super) fn declared<'d>(derivation: &'d Derivation, claim: &ClaimAccount) -> Option<&'d Claim> {
    derivation.claim(&claim.id, claim.reading.as_deref())
}

/// The title of a motion up to its first stop, where it is at most so many letters long and says more than the name.
pub(super) fn motion_title<'a>(derivation: &'a Derivation, id: &str, longest: usize) -> Option<&'a str> {
    let title = derivation.trajectories.iter().find(|t| t.id == id)?.title.split([':', ',', ';']).next()?;
    let bare = ["a ", "an ", "the "].iter().find_map(|article| title.strip_prefix(article)).unwrap_or(title);
    (bare != id && title.chars().count() <= longest).then_some(title)
}
