//! What the steps of a paper use and its claims do not say: conditions of proofs, what separates motions, conventions; and how far
//! what stands stands.
//!
//! **In:** the account of each claim. **Out:** a bounded list, what most claims use first. Nothing is judged: what a claim assumes by its
//! own words is not among it.

use std::collections::BTreeMap;

use super::card::RefutingMotion;
use super::consequence::Consequences;
use super::digest::{self, Fate, Whole};
use super::headline::CountedFate;
use super::numbers::count;
use super::points::{self, NeededReading};
use super::story::{StoryBlock, StoryItem, StorySpan, Tone, joined, quiet, words};
use super::tally::{Standing, declared, name};
use super::wording::dense;
use crate::derivation::{ClaimRole, Derivation};
use crate::latex::Scope;
use findings::conditions::Need;
use findings::{Account, ClaimAccount};
use reason::{Bounded, Proviso, Term};

/// Most hypotheses that are told on page one; more are folded.
const MOST: usize = 5;
/// Longest hypothesis that comes first, in bytes.
const LONGEST_SHOWN: usize = 70;
/// Most that are told at all.
const MOST_FOLDED: usize = 60;
/// Most claims that are named of each.
const MOST_NAMED: usize = 3;
/// Most conventions on page one.
const MOST_CONVENTIONS: usize = 2;
/// Longest convention on page one, in bytes.
const LONGEST_CONVENTION: usize = 90;

/// How well a hypothesis is read: what has words comes first.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Readable {
    /// The words of the file, or an order of letters.
    Words,
    /// A short formula.
    Formula,
    /// What is too long for a line of page one.
    Long,
}

/// Something that steps use.
struct Hypothesis<'a> {
    says: Vec<StorySpan<'a>>,
    readable: Readable,
    /// The claims that use it.
    used: Vec<String>,
}

/// The list of hypotheses, and of conventions.
pub(super) fn blocks<'a>(
    derivation: &'a Derivation,
    account: &'a Account,
    wholes: &[Whole<'a>],
) -> Vec<StoryBlock<'a>> {
    let mut all = gathered(derivation, account, wholes);
    // What has words comes first, then what most claims use.
    all.sort_by_key(|h| (h.readable, std::cmp::Reverse(h.used.len())));
    let mut out = vec![StoryBlock::Heading("Used and not said".to_owned())];
    let short = all.iter().take_while(|h| h.readable != Readable::Long).count();
    let shown = all.len().min(MOST).min(short.max(1));
    if all.is_empty() {
        out.push(StoryBlock::Paragraph(vec![quiet("No step uses a condition that its claim does not say.")]));
        out.extend(conventions(derivation));
        return out;
    }
    let counted = all[..shown].iter().enumerate().map(|(at, of)| {
        let unit = if at == 0 { count(of.used.len(), "claim") } else { of.used.len().to_string() };
        of.says.iter().cloned().chain([quiet(format!(" ({unit})"))]).collect()
    });
    let mut line = joined(counted, "; ");
    let more = all.len() - shown;
    line.push(quiet(if more > 0 { format!("; {more} more on the page.") } else { ".".to_owned() }));
    out.push(StoryBlock::Paragraph(line));
    out.extend(conventions(derivation));
    let told = &all[..all.len().min(MOST_FOLDED)];
    let mut folded = vec![StoryBlock::List(told.iter().map(item).collect())];
    if all.len() > told.len() {
        folded.push(StoryBlock::Paragraph(vec![quiet(format!("{} more are not listed.", all.len() - told.len()))]));
    }
    out.push(StoryBlock::Fold {
        title: "Which claims use what".to_owned(),
        unfolded: Some(String::new()),
        blocks: folded,
    });
    out
}

fn item<'a>(of: &Hypothesis<'a>) -> StoryItem<'a> {
    let mut line = of.says.clone();
    line.push(quiet(" ("));
    let named = of.used.iter().take(MOST_NAMED).map(|id| vec![StorySpan::Claim(id.clone(), Tone::Quiet)]);
    line.extend(joined(named, ", "));
    let more = of.used.len().saturating_sub(MOST_NAMED);
    line.push(quiet(if more > 0 { format!(" and {more} more)") } else { ")".to_owned() }));
    StoryItem { mark: String::new(), line, below: Vec::new() }
}

/// What was chosen: of the conventions of the file, the first.
fn conventions<'a>(derivation: &'a Derivation) -> Option<StoryBlock<'a>> {
    if derivation.conventions.is_empty() {
        return None;
    }
    let is_short = |(_, text): &&(String, String)| text.len() <= LONGEST_CONVENTION;
    let told: Vec<_> = derivation.conventions.iter().filter(is_short).take(MOST_CONVENTIONS).collect();
    let more = derivation.conventions.len() - told.len();
    let told = told.into_iter().map(|(key, text)| {
        let text = format!("{}: {}", key.replace('-', " "), text.trim_end_matches('.'));
        vec![StorySpan::Prose(text, &derivation.scope, Tone::Quiet)]
    });
    let mut out = vec![quiet("Conventions: ")];
    out.extend(joined(told, "; "));
    out.push(quiet(if more > 0 { format!("; {more} more.") } else { ".".to_owned() }));
    Some(StoryBlock::Group("roomy", vec![StoryBlock::Paragraph(out)]))
}

/// Letters that are said to differ, or to be no values between others: what a condition says of them.
struct Sides {
    letters: Vec<String>,
    between: Option<bool>,
}

/// The letters of a condition that is `a ≠ b`, or `(a-b)(a-c)` with a sign.
fn sides(key: &str) -> Option<Sides> {
    let text = canonical(key);
    let is_letter = |of: &str| {
        of == "0" || of.starts_with(|c: char| c.is_alphabetic() || c == '\\') && !of.contains(['+', '-', '(', '^'])
    };
    if let Some((a, b)) = text.split_once('≠') {
        // What is zero is said last.
        let (a, b) = if a == "0" { (b, a) } else { (a, b) };
        let letters = vec![a.to_owned(), b.to_owned()];
        return letters.iter().all(|l| is_letter(l)).then_some(Sides { letters, between: None });
    }
    let (product, at_least) = match (text.strip_suffix("≥0"), text.strip_suffix("≤0")) {
        (Some(product), _) => (product, true),
        (_, Some(product)) => (product, false),
        (None, None) => return None,
    };
    let (one, other) = product.split_once("\\cdot")?;
    let difference = |of: &'_ str| -> Option<(String, String)> {
        let (a, b) = of.strip_prefix('(')?.strip_suffix(')')?.split_once('-')?;
        (is_letter(a) && is_letter(b)).then(|| (a.to_owned(), b.to_owned()))
    };
    let ((a, b), (c, d)) = (difference(one)?, difference(other)?);
    let (middle, left, right, same) = match () {
        () if a == c => (a, b, d, true),
        () if b == d => (b, a, c, true),
        () if a == d => (a, b, c, false),
        () if b == c => (b, a, d, false),
        () => return None,
    };
    let (left, right) = if right < left { (right, left) } else { (left, right) };
    Some(Sides { letters: vec![middle, left, right], between: Some(same != at_least) })
}

/// A condition on the order of letters, in words.
fn ordered<'a>(key: &str, scope: &'a Scope) -> Option<Vec<StorySpan<'a>>> {
    let of = sides(key)?;
    let letter = |at: usize| StorySpan::Math(of.letters[at].clone(), scope);
    Some(match of.between {
        None => vec![letter(0), words(" ≠ "), letter(1)],
        Some(true) => {
            vec![letter(0), words(" between "), letter(1), words(" and "), letter(2), words(", or one of them")]
        }
        Some(false) => vec![letter(0), words(" not strictly between "), letter(1), words(" and "), letter(2)],
    })
}

/// What a proof needs, as it is shown, and by which equals are found.
fn of_proviso<'a>(of: &Proviso, scope: &'a Scope) -> (Vec<StorySpan<'a>>, String) {
    let key = of.to_string();
    let says = match of {
        Proviso::Where { formula, is } => ordered(&key, scope).unwrap_or_else(|| {
            let (left, rest) = is.parts(formula);
            vec![StorySpan::Math(left.into_owned(), scope), words(rest)]
        }),
        Proviso::Written(formula) => {
            ordered(&key, scope).unwrap_or_else(|| vec![StorySpan::Math(formula.to_string(), scope)])
        }
        Proviso::Leap(formula) => {
            vec![StorySpan::Math(formula.to_string(), scope), words(" neither leaps nor has an edge")]
        }
        Proviso::Pole(formula) => vec![
            StorySpan::Math(formula.to_string(), scope),
            words(" ≠ 0, or the motion is analytic where it vanishes"),
        ],
        Proviso::Orders(_) | Proviso::OtherSign => vec![StorySpan::Prose(key.clone(), scope, Tone::Plain)],
    };
    (says, key)
}

fn gathered<'a>(derivation: &'a Derivation, account: &'a Account, wholes: &[Whole<'a>]) -> Vec<Hypothesis<'a>> {
    let mut out: Vec<Hypothesis<'a>> = Vec::new();
    let mut places: BTreeMap<String, usize> = BTreeMap::new();
    let mut add = |says: Vec<StorySpan<'a>>, key: String, claim: String| {
        let at = *places.entry(canonical(&key)).or_insert(out.len());
        match out.get_mut(at) {
            Some(known) if known.used.contains(&claim) => {}
            Some(known) => known.used.push(claim),
            None => {
                let readable = match says.as_slice() {
                    _ if key.len() > LONGEST_SHOWN => Readable::Long,
                    [StorySpan::Prose(text, ..) | StorySpan::Words(text, _)] if !text.contains('$') => Readable::Words,
                    _ if places_of(&key, "\\cdot").len() < 2 && sides(&key).is_some() => Readable::Words,
                    _ => Readable::Formula,
                };
                out.push(Hypothesis { says, readable, used: vec![claim] });
            }
        }
    };
    for unsaid in digest::unsaid(derivation, account) {
        let text = digest::explanation(unsaid.explanation);
        let says = || vec![StorySpan::Prose(text.clone(), &derivation.scope, Tone::Plain)];
        for claim in &unsaid.claims {
            add(says(), text.clone(), name(claim));
        }
    }
    let argued = |role: ClaimRole| matches!(role, ClaimRole::Says | ClaimRole::MayMean | ClaimRole::Lemma);
    for reading in wholes.iter().flat_map(|w| &w.readings).filter(|r| argued(r.role)) {
        let claim = reading.claim;
        let scope = declared(derivation, claim).map_or(&derivation.scope, |d| &d.scope);
        let own: Vec<String> = claim.assumptions.iter().map(|a| canonical(a)).collect();
        let Some(identity) = claim.identity.as_ref().filter(|i| i.finding.is_proved_in_part()) else { continue };
        for (term, provisos) in identity.terms().iter().filter(|(term, _)| uses(*term)) {
            for proviso in provisos {
                let (says, key) = match term {
                    Term::Exception => of_proviso(&excluded(proviso), scope),
                    Term::Condition | Term::GivenOnlyWhere | Term::Presupposed | Term::Used | Term::Unused => {
                        of_proviso(proviso, scope)
                    }
                };
                if !own.contains(&canonical(&key)) {
                    add(says, key, name(claim));
                }
            }
        }
        if let Some(branch) = &identity.evidence.branch {
            let text = format!("of ±: it holds {branch}");
            add(vec![StorySpan::Prose(text.clone(), scope, Tone::Plain)], text, name(claim));
        }
    }
    for reading in wholes.iter().flat_map(|w| &w.readings).filter(|r| argued(r.role) && r.standing == Standing::Holds) {
        let mut left_out = reading.claim.results.iter().flat_map(|p| &p.verdict.evidence().excluded);
        if left_out.any(|e| e.reason.is_no_value()) {
            let text = "times at which a side has no value are left out";
            add(vec![words(text)], text.to_owned(), name(reading.claim));
        }
    }
    for reading in wholes.iter().flat_map(|w| &w.readings).filter(|r| r.role == ClaimRole::MayMean) {
        let claim = reading.claim;
        for needed in claim.conditions.assumptions.iter().filter(|a| a.need == Need::Needed) {
            let says = points::in_words(derivation, &needed.text, claim);
            let key = if let StorySpan::Prose(text, ..) = &says { text.clone() } else { needed.text.clone() };
            add(vec![says], key, name(claim));
        }
    }
    out
}

/// One spelling of a condition that is written in several: `A - B ≠ 0` is `A \ne B`, either way round, and factors have no order.
pub(super) fn canonical(text: &str) -> String {
    let text = dense(text).replace("\\neq", "≠").replace("\\ne", "≠");
    if let Some((left, right)) = text.split_once('≠') {
        let minus: Vec<usize> = places_of(left, "-");
        let mut sides = match (right, minus.as_slice()) {
            ("0", &[at]) if at > 0 => [&left[..at], &left[at + 1..]],
            _ => [left, right],
        };
        sides.sort_unstable();
        return sides.join("≠");
    }
    let Some(at) = text.find(['≥', '≤', '<', '>']) else { return text };
    let (left, rest) = text.split_at(at);
    let mut factors = Vec::new();
    let mut from = 0;
    for dot in places_of(left, "\\cdot") {
        factors.push(&left[from..dot]);
        from = dot + "\\cdot".len();
    }
    factors.push(&left[from..]);
    factors.sort_unstable();
    format!("{}{rest}", factors.join("\\cdot"))
}

/// Where a word stands in a formula, outside of all brackets.
fn places_of(formula: &str, word: &str) -> Vec<usize> {
    let mut depth = 0_i32;
    let mut out = Vec::new();
    for (at, c) in formula.char_indices() {
        match c {
            '(' | '{' | '[' => depth += 1,
            ')' | '}' | ']' => depth -= 1,
            _ if depth == 0 && formula[at..].starts_with(word) => out.push(at),
            _ => {}
        }
    }
    out
}

/// What is used where a case is left out: that it is not so.
pub(super) fn excluded(case: &Proviso) -> Proviso {
    match case {
        Proviso::Where { formula, is } => {
            let is = match is {
                Bounded::Zero => Bounded::NotZero,
                Bounded::Negative => Bounded::NotNegative,
                Bounded::NotPositive => Bounded::Positive,
                Bounded::NotZero | Bounded::NotNegative | Bounded::Positive | Bounded::ByOne => *is,
            };
            Proviso::Where { formula: formula.clone(), is }
        }
        other => other.clone(),
    }
}

/// Whether a list of a proof is of what it uses, rather than of what it does without.
pub(super) fn uses(term: Term) -> bool {
    match term {
        Term::Condition | Term::Exception | Term::GivenOnlyWhere | Term::Presupposed => true,
        Term::Used | Term::Unused => false,
    }
}

/// Most claims that stand as said, and fail as needed, that are unfolded.
const MOST_AS_NEEDED: usize = 12;
/// Most labels of equations.
const MOST_LABELS: usize = 12;

/// How far what stands stands: the printed equations that do, and the claims that hold as they are said, but fail where the paper needs
/// more. One paragraph, bounded: one claim with its numbers, the one that most others assume, and how many there are beside it.
pub(super) fn limits<'a>(
    derivation: &'a Derivation,
    wholes: &[Whole<'a>],
    hangs: &Consequences<'a>,
) -> Vec<StoryBlock<'a>> {
    let out = equations(derivation, wholes);
    let mut limited: Vec<(&Whole<'a>, &'a ClaimAccount)> =
        wholes.iter().filter(|w| w.fate == Fate::Stands).filter_map(|w| Some((w, w.failing_need()?.claim))).collect();
    // What other claims assume comes first, then the heaviest; equals stay in the order of the paper.
    let refuted = |claim: &'a ClaimAccount| RefutingMotion::of(derivation, claim).filter(|m| m.witness().is_some());
    let assumed = |claim: &ClaimAccount| {
        let all = wholes.iter().flat_map(|w| &w.readings);
        all.filter(|r| r.claim.assumptions.iter().any(|a| claim.formulas.contains(a))).count()
    };
    limited.sort_by_cached_key(|(w, claim)| {
        std::cmp::Reverse((assumed(claim), refuted(claim).is_some(), hangs.weight(w.id)))
    });
    let Some((first, rest)) = limited.split_first() else {
        return if out.is_empty() { Vec::new() } else { vec![StoryBlock::Paragraph(out)] };
    };
    let item = |(whole, claim): &(&Whole<'a>, &'a ClaimAccount)| as_needed(derivation, whole, assumed(claim));
    let mut told = item(first);
    if let StoryBlock::Paragraph(line) = &mut told[0] {
        if !out.is_empty() {
            line.splice(0..0, out.into_iter().chain([words(" ")]));
        }
        line.push(quiet(" As needed: in the sense in which the argument uses it."));
    }
    let mut blocks = vec![StoryBlock::Group("needed", told)];
    if !rest.is_empty() {
        let items = rest.iter().take(MOST_AS_NEEDED).flat_map(item).collect();
        let title = match rest.len() {
            1 => "1 more claim stands as said, and fails as needed".to_owned(),
            more => format!("{more} more claims stand as said, and fail as needed"),
        };
        blocks.push(StoryBlock::Fold { title, unfolded: Some(String::new()), blocks: items });
    }
    blocks
}

/// A claim that stands as it is said, and fails as it is needed, with the lines on what is needed.
fn as_needed<'a>(derivation: &'a Derivation, whole: &Whole<'a>, assumed: usize) -> Vec<StoryBlock<'a>> {
    let mut line = vec![StorySpan::Claim(whole.id.to_owned(), Tone::Strong)];
    let says = format!(" {}", CountedFate::AsSaid.words(1));
    line.push(words(match assumed {
        0 => format!("{says}."),
        n => format!("{says} ({} {} it).", count(n, "reading"), if n == 1 { "assumes" } else { "assume" }),
    }));
    let mut out = vec![StoryBlock::Paragraph(line)];
    out.extend(points::lines(derivation, whole, NeededReading::Shown));
    out
}

/// The labels of printed equations of which all claims stand.
fn equations<'a>(derivation: &'a Derivation, wholes: &[Whole<'a>]) -> Vec<StorySpan<'a>> {
    let mut labels: Vec<(&'a str, bool)> = Vec::new();
    for whole in wholes.iter().filter(|w| w.fate.is_of_the_paper()) {
        let label = whole.readings.iter().find_map(|r| declared(derivation, r.claim)?.label.as_deref());
        let Some(label) = label else { continue };
        let stands = whole.fate == Fate::Stands;
        match labels.iter_mut().find(|(l, _)| *l == label) {
            Some((_, all)) => *all &= stands,
            None => labels.push((label, stands)),
        }
    }
    let stand: Vec<&str> = labels.iter().filter(|(_, stands)| *stands).map(|(l, _)| *l).collect();
    if stand.is_empty() {
        return Vec::new();
    }
    let more = stand.len().saturating_sub(MOST_LABELS);
    let more = if more > 0 { format!(" and {more} more") } else { String::new() };
    let word = if stand.len() == 1 { "Equation" } else { "Equations" };
    let verb = if stand.len() == 1 { "stands" } else { "stand" };
    let named = stand.iter().take(MOST_LABELS).copied().collect::<Vec<_>>().join(", ");
    vec![words(format!("{word} {named}{more} {verb}."))]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_order_of_letters_has_words() {
        let of = |key: &str| sides(key).map(|s| (s.letters.join(" "), s.between));
        assert_eq!(of(r"I_2-I_1 ≠ 0"), Some(("I_1 I_2".to_owned(), None)));
        assert_eq!(of(r"m_3 ≠ 0"), Some(("m_3 0".to_owned(), None)));
        assert_eq!(of(r"(I_2-I_3)\cdot (I_2-I_1) ≥ 0"), Some(("I_2 I_1 I_3".to_owned(), Some(false))));
        assert_eq!(of(r"(I_3-I_1)\cdot (I_2-I_3) ≥ 0"), Some(("I_3 I_1 I_2".to_owned(), Some(true))));
        assert_eq!(of(r"(I_3-I_1)\cdot (I_3-I_2) ≤ 0"), Some(("I_3 I_1 I_2".to_owned(), Some(true))));
        assert_eq!(of(r"a+b ≠ 0"), None);
        assert_eq!(of(r"(a-b)\cdot (c-d) ≥ 0"), None);
        assert_eq!(of(r"x ≥ 0"), None);
    }

    #[test]
    fn one_condition_in_several_spellings_is_one() {
        for (one, other) in [
            (r"I_2-I_1 ≠ 0", r"I_1\ne I_2"),
            (r"m_3 ≠ 0", r"m_3\ne 0"),
            (r"(I_3-I_1)\cdot (I_2-I_1) ≥ 0", r"(I_2-I_1)\cdot (I_3-I_1) ≥ 0"),
        ] {
            assert_eq!(canonical(one), canonical(other));
        }
        for (one, other) in [
            (r"I_2-I_1 ≠ 0", r"I_2+I_1 ≠ 0"),
            (r"-x ≠ 0", r"x\ne 0"),
            (r"a-b-c ≠ 0", r"a\ne b-c"),
            (r"(I_2-I_3)\cdot (I_2-I_1) ≥ 0", r"(I_2-I_1)\cdot (I_3-I_1) ≥ 0"),
            (r"x ≥ 0", r"x ≤ 0"),
        ] {
            assert_ne!(canonical(one), canonical(other));
        }
    }
}
