//! What the steps of a paper use and its claims do not say: conditions of proofs, what separates motions, conventions; and how far
//! what stands stands.
//!
//! **In:** the account of each claim. **Out:** a bounded list, what most claims use first. Nothing is judged: what a claim assumes by its
//! own words is not among it.

use std::collections::BTreeMap;

use super::card::RefutingMotion;
use super::consequence::Consequences;
use super::digest::{self, Fate, Reading, Whole};
use super::headline::CountedFate;
use super::numbers::count;
use super::points::{self, NeededReading};
use super::story::{StoryBlock, StoryItem, StorySpan, Tone, joined, quiet, words};
use super::tally::{Standing, declared, name};
use super::wording::dense;
use crate::derivation::{ClaimRole, Derivation, FormKind};
use crate::latex::Scope;
use findings::Account;
use findings::conditions::Need;
use reason::{Bounded, Proviso, Term};

/// Most hypotheses that are told on page one; more are folded.
const MOST: usize = 4;
/// Longest hypothesis that comes first, in bytes.
const LONGEST_SHOWN: usize = 70;
/// Most that are told at all.
const MOST_FOLDED: usize = 60;
/// Most claims that are named of each.
const MOST_NAMED: usize = 3;
/// Most equations and claims that are named of each on page one.
const MOST_PLACES: usize = 2;
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
    /// By which equals are found.
    key: String,
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
    let (said, unsaid): (Vec<_>, Vec<_>) =
        gathered(derivation, account, wholes).into_iter().partition(|h| is_stated(derivation, wholes, &h.key));
    let mut all = with_intermediate(unsaid, &derivation.scope);
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
    let counted = all[..shown]
        .iter()
        .map(|of| of.says.iter().cloned().chain([quiet(format!(" ({})", places(derivation, &of.used)))]).collect());
    let mut line = joined(counted, "; ");
    let more = all.len() - shown;
    line.push(quiet(if more > 0 { format!("; {more} more on the page.") } else { ".".to_owned() }));
    out.push(StoryBlock::Paragraph(line));
    out.extend(said_elsewhere(derivation, &said));
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

/// What claims use without saying so that the paper says in another place.
fn said_elsewhere<'a>(derivation: &'a Derivation, said: &[Hypothesis<'a>]) -> Option<StoryBlock<'a>> {
    if said.is_empty() {
        return None;
    }
    let mut out = vec![quiet("Said by the paper in one place, and used in others: ")];
    let one = |of: &Hypothesis<'a>| {
        of.says.iter().cloned().chain([quiet(format!(" ({})", places(derivation, &of.used)))]).collect()
    };
    out.extend(joined(said.iter().take(MOST).map(one), "; "));
    out.push(quiet("."));
    Some(StoryBlock::Group("roomy", vec![StoryBlock::Paragraph(out)]))
}

/// Whether the paper itself states a condition, or chooses it: then it is not unsaid.
fn is_stated(derivation: &Derivation, wholes: &[Whole<'_>], key: &str) -> bool {
    let named = derivation.conditions.iter().find(|c| c.says.trim_end_matches('.') == key);
    let wanted: Vec<String> = match named {
        Some(condition) => condition.holds.iter().map(|f| canonical(&f.text)).collect(),
        None => vec![canonical(key.trim_matches('$'))],
    };
    let states = |r: &&Reading<'_>| matches!(r.role, ClaimRole::Says | ClaimRole::Choice);
    let always = |r: &Reading<'_>| {
        declared(derivation, r.claim).is_none_or(|d| d.formulas.iter().all(|f| f.kind == FormKind::Always))
    };
    wholes.iter().flat_map(|w| &w.readings).filter(states).filter(|r| always(r)).any(|r| {
        let stated: Vec<String> = r.claim.formulas.iter().map(|f| canonical(f)).collect();
        wanted.iter().all(|w| stated.contains(w))
    })
}

/// Of three letters two that are not strictly between the others leave the third there, or these two are equal: both conditions are put
/// together for the claims that use both.
fn with_intermediate<'a>(all: Vec<Hypothesis<'a>>, scope: &'a Scope) -> Vec<Hypothesis<'a>> {
    let mut out: Vec<Hypothesis<'a>> = all;
    let outer = |h: &Hypothesis<'_>| sides(&h.key).filter(|s| s.between == Some(false)).map(|s| s.letters);
    let found: Vec<(usize, Vec<String>)> = out.iter().enumerate().filter_map(|(at, h)| Some((at, outer(h)?))).collect();
    let mut merged = Vec::new();
    for (i, (one, a)) in found.iter().enumerate() {
        for (other, b) in &found[i + 1..] {
            let is_twin = a[0] != b[0] && a[1..].contains(&b[0]) && b[1..].contains(&a[0]);
            let Some(third) = a[1..].iter().find(|l| **l != b[0] && b[1..].contains(l)).filter(|_| is_twin) else {
                continue;
            };
            let both: Vec<String> = out[*one].used.iter().filter(|c| out[*other].used.contains(c)).cloned().collect();
            if both.is_empty() {
                continue;
            }
            for at in [*one, *other] {
                out[at].used.retain(|claim| !both.contains(claim));
            }
            let differ = canonical(&format!("{}≠{}", a[0], b[0]));
            let known = out.iter().find(|h| canonical(&h.key) == differ);
            let exact = known.is_some_and(|h| both.iter().all(|claim| h.used.contains(claim)));
            let letter = |of: &String| StorySpan::Math(of.clone(), scope);
            let (a, b) = if b[0] < a[0] { (b, a) } else { (a, b) };
            let mut says = vec![letter(third), words(" between "), letter(&a[0]), words(" and "), letter(&b[0])];
            says.push(words(", or equal to one"));
            if !exact {
                says.extend([words(", or "), letter(&a[0]), words(" = "), letter(&b[0])]);
            }
            let key = format!("{third} between {} and {}", a[0], b[0]);
            merged.push(Hypothesis { says, key, readable: Readable::Words, used: both });
        }
    }
    out.retain(|h| !h.used.is_empty());
    out.extend(merged);
    out
}

/// Where a hypothesis is used: the labels of the first equations, or the names of claims without one, and how many claims more.
fn places(derivation: &Derivation, used: &[String]) -> String {
    let label = |name: &String| derivation.claims.iter().find(|c| c.name() == *name)?.label.clone();
    let mut labels: Vec<(String, usize)> = Vec::new();
    let mut others = Vec::new();
    for name in used {
        match label(name) {
            Some(label) => match labels.iter_mut().find(|(known, _)| *known == label) {
                Some((_, n)) => *n += 1,
                None => labels.push((label, 1)),
            },
            None => others.push((name.split('/').next().unwrap_or(name).to_owned(), 1)),
        }
    }
    let named: Vec<(String, usize)> = labels.into_iter().chain(others).take(MOST_PLACES).collect();
    let told: usize = named.iter().map(|(_, n)| n).sum();
    let list = named.into_iter().map(|(name, _)| name).collect::<Vec<_>>().join(", ");
    match used.len() - told {
        0 => list,
        more => format!("{list}, {more} more"),
    }
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
        Proviso::Hole(formula) => {
            vec![StorySpan::Math(formula.to_string(), scope), words(" has a value other than 0 throughout")]
        }
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
                out.push(Hypothesis { says, key, readable, used: vec![claim] });
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

/// Most claims that fail as they are used, that are unfolded.
const MOST_AS_NEEDED: usize = 12;

/// A claim that stands as it is stated, and fails as the paper uses it.
pub(super) struct Limited<'w, 'a> {
    pub whole: &'w Whole<'a>,
    /// The reading that the paper uses.
    pub used: &'w Reading<'a>,
    /// How many readings assume it.
    pub assumed: usize,
}

/// All of them: what other claims assume comes first, then the heaviest; equals stay in the order of the paper.
pub(super) fn limited<'w, 'a>(
    derivation: &Derivation,
    wholes: &'w [Whole<'a>],
    hangs: &Consequences<'_>,
) -> Vec<Limited<'w, 'a>> {
    let refuted = |r: &Reading<'a>| RefutingMotion::of(derivation, r.claim).is_some_and(|m| m.witness().is_some());
    let assumed = |r: &Reading<'a>| {
        let all = wholes.iter().flat_map(|w| &w.readings);
        all.filter(|other| other.claim.assumptions.iter().any(|a| r.claim.formulas.contains(a))).count()
    };
    let standing = wholes.iter().filter(|w| w.fate == Fate::Stands);
    let with_use = standing.filter_map(|whole| Some((whole, whole.failing_need()?)));
    let mut out: Vec<Limited<'w, 'a>> =
        with_use.map(|(whole, used)| Limited { whole, used, assumed: assumed(used) }).collect();
    out.sort_by_cached_key(|l| std::cmp::Reverse((l.assumed, refuted(l.used), hangs.weight(l.whole.id))));
    out
}

/// How far what stands stands: the claims that hold as they are stated, but fail where the paper uses them. Bounded: one claim with its
/// numbers, the one that most others assume, and the others folded.
pub(super) fn limits<'a>(
    derivation: &'a Derivation,
    wholes: &[Whole<'a>],
    hangs: &Consequences<'a>,
) -> Vec<StoryBlock<'a>> {
    let limited = limited(derivation, wholes, hangs);
    let Some((first, rest)) = limited.split_first() else { return Vec::new() };
    let mut card = as_used(derivation, first);
    if let Some(StoryBlock::Paragraph(line)) = card.first_mut() {
        line.insert(0, StorySpan::Words("Stated and used differently: ".to_owned(), Tone::Strong));
        line.push(quiet(match rest.len() {
            0 => ".".to_owned(),
            n => format!(", and {}.", count(n, "more claim")),
        }));
    }
    let sketch = RefutingMotion::of(derivation, first.used.claim).and_then(|motion| motion.sketch());
    if let Some(sketch) = sketch {
        card.insert(1, StoryBlock::Group("roomy", vec![StoryBlock::Figure(sketch, Vec::new())]));
    }
    let mut blocks = vec![StoryBlock::Group("card", card)];
    if !rest.is_empty() {
        let items = rest.iter().take(MOST_AS_NEEDED).flat_map(|l| as_used(derivation, l)).collect();
        let n = rest.len();
        let verb = CountedFate::AsSaid.words(n);
        let title = format!("{n} more {} {verb}", if n == 1 { "claim" } else { "claims" });
        blocks.push(StoryBlock::Fold { title, unfolded: Some(String::new()), blocks: items });
    }
    blocks
}

/// What such a claim says, in what sense it stands, and where it fails as it is used.
fn as_used<'a>(derivation: &'a Derivation, of: &Limited<'_, 'a>) -> Vec<StoryBlock<'a>> {
    let mut line = vec![StorySpan::Claim(of.whole.id.to_owned(), Tone::Strong)];
    line.push(quiet(match of.assumed {
        0 => String::new(),
        n => format!(" ({} {} it)", count(n, "reading"), if n == 1 { "assumes" } else { "assume" }),
    }));
    let mut out = vec![StoryBlock::Paragraph(line)];
    // A terminal has the first sentences for it.
    out.extend(points::as_stated(derivation, of.whole).map(|line| StoryBlock::Group("roomy", vec![line])));
    out.extend(points::lines(derivation, of.whole, NeededReading::Shown));
    out
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
