//! What was found of claims on motions that were drawn beside those of the file, as people read it.
//!
//! **In:** a claim that holds on every motion of the file, with what others show of it. **Out:** a sentence; the motion on which it fails, in
//! words and as a table for the file; for page one a bounded list of such claims. That they hold on the motions of the file stays said.

use super::card::kind_at;
use super::digest::Whole;
use super::numbers::{ascii_six, count, six};
use super::refuting;
use super::story::{StoryBlock, StorySpan, Tone, quiet, words};
use super::tally::{declared, name};
use super::wording::label;
use derivation::{ClaimRole, Derivation};
use findings::ClaimAccount;
use findings::search::{DrawnAccount, FailingMotion};

/// Most claims of which page one tells the motion; the others are named.
const MOST_TOLD: usize = 3;
/// Those of them that a terminal has room for.
const MOST_ON_TERMINAL: usize = 1;
/// Most claims that are named.
const MOST_NAMED: usize = 12;

/// How the claim fares on the motions that were drawn, in a sentence: `On 24 further motions to which it applies, drawn at random with
/// seed 1: holds on all.`
pub(super) fn counted(drawn: &DrawnAccount) -> String {
    let t = drawn.tries;
    let all = t.holds + t.fails + t.undecided;
    let told = |(n, says): &(usize, &str)| match (*n == all, *n) {
        (_, 0) => None,
        (true, _) if all > 1 => Some(format!("{says} on all")),
        (_, n) => Some(format!("{says} on {n}")),
    };
    let parts = [(t.holds, "holds"), (t.fails, "fails"), (t.undecided, "is undecided")];
    let told: Vec<String> = parts.iter().filter_map(told).collect();
    match all {
        0 => format!(
            "It applies to none of {}, drawn at random with seed {}.",
            count(t.all(), "further motion"),
            drawn.seed
        ),
        _ => format!(
            "On {} to which it applies, drawn at random with seed {}: {}.",
            count(all, "further motion"),
            drawn.seed,
            told.join(", ")
        ),
    }
}

/// The motion on which the claim fails: the one that it was made from, what is other there, the time, and both sides.
pub(super) fn motion(derivation: &Derivation, claim: &ClaimAccount, found: &FailingMotion) -> String {
    let changed: Vec<String> =
        found.changed.iter().map(|c| format!("${}$ = {} in place of {}", c.name, six(c.now), six(c.then))).collect();
    let mut out = format!("It fails on {} with {}", found.from, changed.join(", "));
    if let Some(w) = &found.verdict.evidence().witness {
        let said = refuting::bare_values(claim, kind_at(derivation, claim, Some(w)), w, &|text| text.to_owned());
        let label = label(&w.formula);
        let of = match label.component {
            Some(component) => format!("${}$, component {component}", label.formula),
            None => format!("${}$", label.formula),
        };
        out.push_str(&format!(" at t = {}: {of}: {said}", ascii_six(w.t)));
    }
    out.push('.');
    out
}

/// All of it, for the section on a claim: without formulas set.
pub(super) fn plain(derivation: &Derivation, claim: &ClaimAccount) -> Option<String> {
    let drawn = claim.drawn.as_ref()?;
    let motion = drawn.found.as_ref().map(|found| format!(" {}", motion(derivation, claim, found))).unwrap_or_default();
    Some(counted(drawn) + &motion)
}

/// The table of the motion on which the claim fails, to be put into the file.
pub(super) fn table(claim: &ClaimAccount) -> Option<&str> {
    claim.drawn.as_ref()?.found.as_ref().map(|found| found.table.as_str())
}

/// What to do about it.
pub(super) const ADVICE: &str =
    "Either the claim means such motions, and is false; or it does not, and should say what it assumes.";

/// The claims that hold on every motion of the file and fail on others: those of the paper first.
fn refuted<'a>(derivation: &Derivation, wholes: &[Whole<'a>]) -> Vec<(&'a ClaimAccount, &'a FailingMotion)> {
    let all = wholes.iter().flat_map(|w| &w.readings);
    let mut found: Vec<(ClaimRole, &'a ClaimAccount, &'a FailingMotion)> =
        all.filter_map(|r| Some((r.role, r.claim, r.claim.drawn.as_ref()?.found.as_deref()?))).collect();
    let is_beside = |(role, claim, _): &(ClaimRole, &ClaimAccount, &FailingMotion)| {
        *role == ClaimRole::Added || declared(derivation, claim).is_none()
    };
    found.sort_by_key(is_beside);
    found.into_iter().map(|(_, claim, motion)| (claim, motion)).collect()
}

/// For page one; nothing where no claim fails.
pub(super) fn blocks<'a>(derivation: &'a Derivation, wholes: &[Whole<'a>]) -> Vec<StoryBlock<'a>> {
    let found = refuted(derivation, wholes);
    if found.is_empty() {
        return Vec::new();
    }
    let title = match found.len() {
        1 => "One claim fails on a motion drawn at random".to_owned(),
        n => format!("{n} claims fail on motions drawn at random"),
    };
    let told = found.iter().take(MOST_TOLD).map(|(claim, motion)| one(derivation, claim, motion));
    let mut told: Vec<StoryBlock<'a>> = told.collect();
    let roomy = told.split_off(told.len().min(MOST_ON_TERMINAL));
    let mut out = vec![StoryBlock::Heading(title)];
    out.extend(told);
    if !roomy.is_empty() {
        out.push(StoryBlock::Group("roomy", roomy));
    }
    let named = |from: usize| -> Option<String> {
        let rest = found.get(from..)?;
        let names: Vec<String> = rest.iter().take(MOST_NAMED).map(|(claim, _)| name(claim)).collect();
        let more = rest.len() - names.len();
        let more = if more > 0 { format!(", and {more} more") } else { String::new() };
        (!names.is_empty())
            .then(|| format!("So {}: {}{more}.", if rest.len() == 1 { "does" } else { "do" }, names.join(", ")))
    };
    out.extend(named(MOST_TOLD).map(|text| StoryBlock::Paragraph(vec![quiet(text)])));
    let first = found.first().map(|(claim, _)| name(claim)).unwrap_or_default();
    out.push(StoryBlock::Paragraph(vec![
        quiet(format!("{ADVICE} The motion, to be put into the file: ")),
        StorySpan::Code(format!("{} explain {first}", crate::PROGRAM)),
        quiet("."),
    ]));
    out.extend(rests_on(wholes, &first).map(|text| StoryBlock::Paragraph(vec![quiet(text)])));
    vec![StoryBlock::Group("drawn", out)]
}

/// That what is proved given a claim says nothing of the motions on which this fails.
fn rests_on(wholes: &[Whole<'_>], of: &str) -> Option<String> {
    let given = |claim: &&ClaimAccount| {
        claim.identity.as_ref().is_some_and(|i| i.conditional_on.iter().any(|given| given.name == of))
    };
    let readings = wholes.iter().flat_map(|w| &w.readings);
    let names: Vec<String> = readings.map(|r| r.claim).filter(given).map(name).collect();
    let more = match names.len().saturating_sub(MOST_NAMED) {
        0 => String::new(),
        n => format!(", and {n} more"),
    };
    let named = names.iter().take(MOST_NAMED).cloned().collect::<Vec<_>>().join(", ");
    (!names.is_empty())
        .then(|| format!("Of motions on which {of} fails nothing is said by what is proved given it: {named}{more}."))
}

fn one<'a>(derivation: &'a Derivation, claim: &'a ClaimAccount, found: &'a FailingMotion) -> StoryBlock<'a> {
    let scope = declared(derivation, claim).map_or(&derivation.scope, |d| &d.scope);
    let t = claim.drawn.as_ref().map(|d| d.tries).unwrap_or_default();
    let holds = claim.results.iter().filter(|p| p.verdict.outcome().word() == "holds").count();
    let all = t.holds + t.fails + t.undecided;
    let of = match holds {
        1 => " holds on the one motion of the file".to_owned(),
        n => format!(" holds on all {} of the file", count(n, "motion")),
    };
    let applies = if holds < claim.results.len() { " to which it applies" } else { "" };
    let of = format!("{of}{applies}, and fails on {} of {all} drawn ones. ", t.fails);
    StoryBlock::Paragraph(vec![
        StorySpan::Claim(name(claim), Tone::Strong),
        words(of),
        StorySpan::Prose(motion(derivation, claim, found), scope, Tone::Plain),
    ])
}
