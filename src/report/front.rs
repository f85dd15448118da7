//! The sentences of page one: the verdict in one sentence, and what does not stand, the heaviest first.
//!
//! **In:** the derivation and its account. **Out:** [`Front`], of which [`page_one`](super::page_one) makes a story. Its texts are those of
//! the file and of [`digest`](super::digest); formulas stand between dollar signs.
//!
//! **Guaranteed:** so many claims are told, the rest is counted.

use std::collections::BTreeSet;

use super::basis::Basis;
use super::consequence::Consequences;
use super::digest::{self, Fate, Reading, Whole};
use super::headline::{self, CountedFate};
use super::numbers::count;
use super::tally::{Standing, name};
use super::text::{capital, uncapital};
use derivation::Derivation;
use findings::conditions::Separation;
use findings::standing::Decision;
use findings::{Account, ClaimAccount, FamilyAccount, IdentityAccount};

/// Most claims that are told; the rest is counted.
const MOST: usize = 14;
/// Most claims that were added and are refuted, of which more is told than the name.
const MOST_COMPARED: usize = 2;
/// Most ids that are named in one line.
const MOST_NAMED: usize = 4;

/// A claim that does not stand.
pub(super) struct Line {
    pub id: String,
    pub says: String,
    pub place: Option<String>,
    /// Why: a sentence.
    pub reason: String,
    /// The same without the name of a motion, for what names one with its numbers.
    pub brief: String,
    /// What falls with it: a sentence, or nothing.
    pub consequence: Option<String>,
    /// Whether a terminal has little room for it: conclusions are told, too.
    pub is_brief: bool,
}

/// The first page.
pub(super) struct Front {
    /// One sentence.
    pub verdict: String,
    /// With what strength the others stand: a sentence.
    pub strength: Option<String>,
    /// What proofs rest on: a sentence, which names those that the checker did not replay.
    pub proofs: Option<String>,
    /// The heaviest first.
    pub lines: Vec<Line>,
    /// How many more do not stand.
    pub more: usize,
    /// What was added for comparison, and is refuted: the first of it.
    pub compared: Vec<Line>,
    /// What asks for attention: what was not checked, and what rests on nothing.
    pub alarms: Vec<String>,
    /// What is in the file beside the paper's claims.
    pub beside: Option<String>,
    /// Who encoded the paper.
    pub author: String,
    /// What is needed to repeat it: a sentence, and the command.
    pub version: String,
    pub command: String,
}

impl Front {
    /// The sentences on an account.
    pub fn new(derivation: &Derivation, account: &Account) -> Front {
        Front::of(derivation, account, &digest::wholes(derivation, account), &Consequences::new(derivation))
    }

    /// The same, of claims that were taken together already.
    pub fn of(derivation: &Derivation, account: &Account, wholes: &[Whole<'_>], hangs: &Consequences<'_>) -> Front {
        let mut against: Vec<&Whole<'_>> = wholes.iter().filter(|w| w.fate.is_against()).collect();
        // What falls with it comes first, then how far it is off. The sort is stable: equals stay in the order of the paper.
        let decades = |w: &Whole<'_>| w.failing().map_or(0, |r| super::card::error_decades(r.claim));
        against.sort_by_cached_key(|w| (std::cmp::Reverse(hangs.weight(w.id)), w.fate, decades(w)));
        let more = against.len().saturating_sub(MOST);
        let line = |whole: &Whole<'_>| Line {
            id: whole.id.to_owned(),
            says: whole.says.clone(),
            place: whole.place.map(str::to_owned),
            reason: reason(whole, MotionName::Said),
            brief: reason(whole, MotionName::Left),
            consequence: consequence(whole, hangs),
            is_brief: !hangs.conclusions().is_empty(),
        };
        let compared = refuted_beside(wholes);
        let file = project_path(&derivation.file.path);
        Front {
            verdict: verdict(wholes, hangs),
            strength: strength(wholes),
            proofs: super::recorded::rests(account),
            lines: against.iter().copied().take(MOST).map(line).collect(),
            more,
            compared: compared.take(MOST_COMPARED).map(line).collect(),
            alarms: alarms(derivation, account),
            beside: headline::beside(wholes),
            author: match &derivation.encoded_by {
                Some(author) => format!("Encoded by {}.", author.trim_end_matches('.')),
                None => "Who encoded it is not said in the file.".to_owned(),
            },
            version: format!(
                "{} {}, SHA-256 {}",
                crate::PROGRAM,
                env!("CARGO_PKG_VERSION"),
                derivation.sha256.get(..16).unwrap_or_default(),
            ),
            command: format!("{} check {file}", crate::PROGRAM),
        }
    }
}

/// What was added for comparison, and is refuted.
pub(super) fn refuted_beside<'w, 'a>(wholes: &'w [Whole<'a>]) -> impl Iterator<Item = &'w Whole<'a>> {
    wholes.iter().filter(|w| w.fate == Fate::Added && w.all_failing().next().is_some())
}

/// The verdict in one sentence: of the conclusions first, then of all claims.
fn verdict(wholes: &[Whole<'_>], hangs: &Consequences<'_>) -> String {
    let counted = headline::headline(wholes);
    let conclusions: Vec<&Whole<'_>> = wholes.iter().filter(|w| w.conclusion).collect();
    if conclusions.is_empty() {
        return counted;
    }
    let on = |is: fn(&Whole<'_>) -> bool| hangs.resting_on(wholes.iter().filter(|w| is(w)).map(|w| w.id));
    let against = on(|w| w.fate.is_against());
    let as_needed = on(|w| w.counted_as() == CountedFate::AsSaid);
    let (mut fallen, mut lost, mut unmet) = (0, 0, 0);
    for whole in &conclusions {
        match (whole.fate.is_against(), against.contains(whole.id)) {
            (true, _) => fallen += 1,
            (false, true) => lost += 1,
            (false, false) if as_needed.contains(whole.id) => unmet += 1,
            (false, false) => {}
        }
    }
    let all = count(conclusions.len(), "conclusion");
    let mut parts = Vec::new();
    if fallen > 0 {
        parts.push(format!("{fallen} {} not hold", if fallen == 1 { "does" } else { "do" }));
    }
    for (n, what) in [(lost, "that do not stand"), (unmet, "that fail as the paper uses them")] {
        if n > 0 {
            parts.push(format!("{n} {} on claims {what}", if n == 1 { "rests" } else { "rest" }));
        }
    }
    let of_conclusions = match parts.is_empty() {
        true => format!("of the paper's {all} none rests on a claim that fails"),
        false => format!("of the paper's {all} {}", digest::listed(&parts)),
    };
    format!("{}; {of_conclusions}.", counted.trim_end_matches('.'))
}

/// With what strength claims stand.
fn strength(wholes: &[Whole<'_>]) -> Option<String> {
    let mut found: Vec<Basis> = wholes.iter().filter(|w| w.counted_as().stands()).filter_map(Whole::basis).collect();
    found.sort_by(|a, b| b.cmp(a));
    let mut kinds: Vec<(&str, usize)> = Vec::new();
    for basis in &found {
        match kinds.last_mut() {
            Some((kind, n)) if *kind == basis.kind() => *n += 1,
            _ => kinds.push((basis.kind(), 1)),
        }
    }
    // Some of what is given others leaves out special cases, too.
    let stand = wholes.iter().filter(|w| w.counted_as().stands());
    let given = |w: &&Whole<'_>| matches!(w.basis(), Some(Basis::Given(_))) && leaves_out_cases(w);
    let also = match stand.filter(given).count() {
        0 => String::new(),
        n => format!(" (of these {n} but for special cases)"),
    };
    let of_given = Basis::Given(Vec::new()).kind();
    let part = |(kind, n): &(&str, usize)| format!("{n} {kind}{}", if *kind == of_given { also.as_str() } else { "" });
    let parts: Vec<String> = kinds.iter().map(part).collect();
    let told = wholes.iter().filter(|w| w.fate.is_of_the_paper()).count();
    let lead = if told == found.len() { "How that is known" } else { "Of those that stand" };
    (!parts.is_empty()).then(|| format!("{lead}: {}.", parts.join("; ")))
}

/// Whether the proof of a reading leaves out special cases.
fn leaves_out_cases(whole: &Whole<'_>) -> bool {
    let decision = |r: &Reading<'_>| r.claim.identity.as_ref().map(|i| i.finding.decision());
    whole.deciding().any(|r| r.standing == Standing::Holds && decision(r) == Some(Decision::ProvedExcept))
}

/// Whether a sentence names a motion on which a claim fails.
#[derive(Clone, Copy, PartialEq, Eq)]
enum MotionName {
    Said,
    Left,
}

/// Why a claim does not stand, in a sentence.
fn reason(whole: &Whole<'_>, name: MotionName) -> String {
    let shown = whole.contrary().map(|r| format!("the contrary holds, {}", r.basis().words()));
    let Some(failing) = whole.failing() else {
        return shown.map_or_else(String::new, |s| format!("{}.", capital(&s)));
    };
    let mut out = String::new();
    let several = whole.deciding().count() > 1;
    if several && failing.claim.reading.is_some() {
        let before = if whole.fate == Fate::Reading { "In one reading, “" } else { "“" };
        out.push_str(&format!("{before}{}”: ", failing.claim.says.trim_end_matches('.')));
        out.push_str(&uncapital(&digest::verdict(failing)));
    } else {
        out.push_str(&digest::verdict(failing));
    }
    let pairs = failing.claim.results.iter().filter(|p| p.verdict.outcome().word() == "fails");
    let members = failing.claim.families.iter().filter_map(|f| Some((f, f.first_failing.as_ref()?)));
    let several = pairs.clone().count() > 1 || failing.claim.families.iter().any(|f| f.counts.fails > 1);
    let members = members.map(|(f, member)| format!("member {} of {}", member.number, f.family));
    let mut fails = pairs.map(|pair| pair.trajectory.clone()).chain(members);
    if let Some(named) = fails.next().filter(|_| name == MotionName::Said) {
        let one_of_several = if several || fails.next().is_some() { "e.g. " } else { "" };
        out.push_str(&format!(", {one_of_several}{named}"));
    }
    if let Some(e) = failing.claim.conditions.separation.as_ref().and_then(Separation::told) {
        out.push_str(&format!("; on the motions tried, it holds exactly where {}", digest::explanation(e)));
    }
    out.extend(failing.claim.families.iter().filter_map(threshold));
    if let Some(shown) = shown {
        out.push_str(&format!("; {shown}"));
    }
    format!("{out}.")
}

/// What separates the members of a family on which a claim holds from those on which it fails, and what it says of fresh ones.
fn threshold(family: &FamilyAccount) -> Option<String> {
    let found = family.separation.as_ref()?;
    let condition = super::conditions::explanation(found.explanation.as_ref()?);
    let tried = found.right + found.wrong;
    let fresh = if tried > 0 { format!(" ({} of {tried} fresh members agree)", found.right) } else { String::new() };
    Some(format!("; on the members of {} that were tried it holds exactly where {condition}{fresh}", family.family))
}

/// What falls with a claim, in a sentence.
fn consequence(whole: &Whole<'_>, hangs: &Consequences<'_>) -> Option<String> {
    let letter = |id: &str| hangs.letter(id);
    let conclusions: Vec<String> =
        hangs.conclusions_of(whole.id).iter().filter_map(|c| letter(c)).map(String::from).collect();
    let claims = hangs.carried_by(whole.id);
    let others: Vec<&&str> = claims.iter().filter(|c| letter(c).is_none()).collect();
    let named: Vec<String> = others.iter().take(MOST_NAMED).map(|c| c.to_string()).collect();
    let more = others.len().saturating_sub(MOST_NAMED);
    let mut parts = Vec::new();
    if !conclusions.is_empty() {
        let word = if conclusions.len() == 1 { "conclusion" } else { "conclusions" };
        parts.push(format!("{word} {}", conclusions.join(", ")));
    }
    if more > 0 {
        parts.push(count(others.len(), "claim"));
    } else if !named.is_empty() {
        parts.push(named.join(", "));
    }
    let is_one = conclusions.len() + others.len() == 1;
    let itself = if whole.conclusion { "This is a conclusion of the paper. " } else { "" };
    match (parts.is_empty(), itself) {
        (true, "") => None,
        (true, itself) => Some(itself.trim().to_owned()),
        (false, itself) => {
            let verb = if is_one { "rests" } else { "rest" };
            Some(format!("{itself}{} {verb} on it.", capital(&parts.join(" and "))))
        }
    }
}

/// What to do about a file without motions.
const NO_MOTION: &str = " The file has no motion: add a [[trajectory]], or give the claims `ranges`.";

/// What a reader must not overlook: claims that apply nowhere, premises that are refuted, a file that decides nothing.
pub fn alarms(derivation: &Derivation, account: &Account) -> Vec<String> {
    let mut out = Vec::new();
    let quoted = |names: Vec<String>| {
        let more = names.len().saturating_sub(MOST_NAMED);
        let named = names.into_iter().take(MOST_NAMED).collect::<Vec<_>>().join(", ");
        if more > 0 { format!("{named} and {more} more") } else { named }
    };
    let summary = account.summary();
    if summary.holds + summary.fails == 0 {
        out.push("No claim was decided: a run that checks nothing is no success.".to_owned());
    }
    let nowhere = || account.claims.iter().filter(|c| Standing::of(c) == Standing::Nowhere);
    let without = derivation.trajectories.is_empty() && nowhere().any(|c| c.region.is_none());
    let decided = |c: &ClaimAccount| c.identity.as_ref().map(IdentityAccount::standing).filter(|v| *v != "undecided");
    let (known, unknown): (Vec<_>, Vec<_>) = nowhere().partition(|c| decided(c).is_some());
    for (of, what) in
        [(unknown, "nothing was checked of what is said"), (known, "what is said is decided for all values alone")]
    {
        if !of.is_empty() {
            let verb = if of.len() == 1 { "applies" } else { "apply" };
            let (claims, why) = (count(of.len(), "claim"), if without { NO_MOTION } else { "" });
            let named = |c: &ClaimAccount| decided(c).map_or_else(|| name(c), |word| format!("{} ({word})", name(c)));
            let named = quoted(of.into_iter().map(named).collect());
            out.push(format!("{claims} {verb} to no motion, so that {what}: {named}.{why}"));
        }
    }
    let refuted = refuted_premises(derivation, account);
    if !refuted.is_empty() {
        out.push(format!(
            "Proofs rest on {} that {} refuted: {}.",
            count(refuted.len(), "premise"),
            if refuted.len() == 1 { "is" } else { "are" },
            quoted(refuted)
        ));
    }
    out
}

/// Claims from which another is said to follow although they fail on a motion, or a point refutes them. What holds on every
/// motion that is tried is a condition on motions, not a mistake.
fn refuted_premises(derivation: &Derivation, account: &Account) -> Vec<String> {
    let names: BTreeSet<&String> = derivation.claims.iter().flat_map(|c| &c.follows_from).collect();
    let is_premise = |c: &&ClaimAccount| names.contains(&name(c));
    let is_refuted = |c: &&ClaimAccount| match Standing::of(c) {
        Standing::Fails | Standing::Mixed => true,
        Standing::Holds => false,
        Standing::Open | Standing::Nowhere => c.identity.as_ref().is_some_and(|i| i.verdict() == "refuted"),
    };
    account.claims.iter().filter(is_premise).filter(is_refuted).map(name).collect()
}

/// The path as the project sees it; nothing outside the project is named.
pub(super) fn project_path(path: &str) -> String {
    let path = path.replace('\\', "/");
    let path = path.trim_start_matches("./");
    let outside = path.starts_with('/') || path.split('/').any(|p| p == ".." || p.ends_with(':'));
    if outside { path.rsplit('/').next().unwrap_or_default().to_owned() } else { path.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_path_outside_the_project() {
        assert_eq!(project_path("derivations/a.toml"), "derivations/a.toml");
        assert_eq!(project_path("./derivations/a.toml"), "derivations/a.toml");
        assert_eq!(project_path("/home/someone/a.toml"), "a.toml");
        assert_eq!(project_path("../other/a.toml"), "a.toml");
        assert_eq!(project_path("C:\\Users\\a.toml"), "a.toml");
    }
}
