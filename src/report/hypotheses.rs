//! What the steps of a paper use and its claims do not say: conditions of proofs, what separates motions, conventions.
//!
//! **In:** the account of each claim. **Out:** a bounded list, what most claims use first. Nothing is judged: what a claim assumes by its
//! own words is not among it.

use std::collections::{BTreeMap, BTreeSet};

use super::condition_spelling::{canonical, lowered_first, places_of, sides, upright};
use super::digest::{self, Reading, Whole};
use super::numbers::count;
use super::plain::plain;
use super::points;
use super::story::{PartLevel, StoryBlock, StoryItem, StorySpan, Tone, joined, on_page, part, quiet, words};
use super::tally::{Standing, declared, name};
use derivation::{ClaimRole, Derivation, FormKind};
use findings::conditions::Need;
use findings::{Account, ClaimAccount};
use latex::Scope;
use reason::{Bounded, Proviso, Term};

/// Most hypotheses that are told on page one; more are folded.
const MOST: usize = 3;
/// Most that the paper says in another place.
const MOST_ELSEWHERE: usize = 1;
/// Longest hypothesis that comes first, in bytes.
const LONGEST_SHOWN: usize = 70;
/// Most that are told at all.
const MOST_FOLDED: usize = 60;
/// Most claims that are named of each.
const MOST_NAMED: usize = 1;
/// Most equations that are named of each on page one.
const MOST_PLACES: usize = 2;
/// Most conventions on page one.
const MOST_CONVENTIONS: usize = 3;
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

/// What kind of thing is used.
#[derive(Clone, Copy, PartialEq, Eq)]
enum HypothesisKind {
    /// A condition of the paper's subject: moments that differ, a laboratory.
    OfPaper,
    /// Which sign of ± is meant.
    Sign,
    /// What a proof divides by, and where a function has a value.
    Technical,
}

/// Something that steps use.
struct Hypothesis<'a> {
    says: Vec<StorySpan<'a>>,
    /// By which equals are found.
    key: String,
    readable: Readable,
    kind: HypothesisKind,
    /// The claims that use it.
    used: Vec<String>,
}

/// The list of hypotheses, and of conventions.
pub(super) fn blocks<'a>(
    derivation: &'a Derivation,
    account: &'a Account,
    wholes: &[Whole<'a>],
) -> Vec<StoryBlock<'a>> {
    let Unsaid { unsaid: all, said, technical, signs } = Unsaid::of(derivation, account, wholes);
    // What proofs divide by is told where nothing else is.
    let first = if all.is_empty() { &technical } else { &all };
    let is_short = |h: &&Hypothesis<'_>| h.readable != Readable::Long;
    let shown: Vec<&Hypothesis<'a>> = first.iter().filter(is_short).take(MOST).collect();
    let more = all.len() + technical.len() - shown.len();
    let is_none = shown.is_empty();
    let together = shown.chunk_by(|a, b| is_used_alike(a, b)).map(|of| {
        let mut says = joined(of.iter().map(|h| h.says.clone()), ", ");
        says.extend(of.first().map(|h| quiet(format!(" ({})", places(derivation, &h.used)))));
        says
    });
    let shown: Vec<_> = together.collect();
    let mut line = joined(shown, "; ");
    line.extend(match (is_none, more) {
        (true, 0) => vec![quiet("nothing.")],
        (true, n) => {
            let what = if all.is_empty() { "nothing but what proofs divide by, in " } else { "" };
            vec![quiet(what), StorySpan::Section(count(n, "long condition"), UNSAID.to_owned()), quiet(", below.")]
        }
        (false, 0) => vec![quiet(".")],
        (false, n) => vec![quiet("; "), StorySpan::Section(format!("+{n}"), UNSAID.to_owned()), quiet(".")],
    });
    line.extend(said_elsewhere(derivation, &said));
    let mut out = vec![StoryBlock::Heading(TITLE.to_owned()), StoryBlock::Paragraph(line)];
    out.extend(conventions(derivation, &signs));
    out
}

/// The heading of the list, of which page one has the beginning.
const TITLE: &str = "Used and not said";

/// The whole list, with the claims that use each; nothing where nothing is used.
pub(super) fn section<'a>(
    derivation: &'a Derivation,
    account: &'a Account,
    wholes: &[Whole<'a>],
) -> Option<StoryBlock<'a>> {
    let Unsaid { unsaid, said, technical, .. } = Unsaid::of(derivation, account, wholes);
    let mut blocks = listed(&unsaid);
    if !said.is_empty() {
        blocks.push(StoryBlock::Paragraph(vec![quiet("Said by the paper in one place, and used in others:")]));
        blocks.extend(listed(&said));
    }
    if !technical.is_empty() {
        let title = "What proofs divide by, and where their functions have values";
        let line = format!("{title}: {}, on the page.", count(technical.len(), "condition"));
        blocks.push(on_page(format!("{title}:"), &line, listed(&technical)));
    }
    (!blocks.is_empty()).then(|| part(UNSAID, PartLevel::Subsection, vec![words(TITLE)], blocks))
}

/// Where the whole list stands.
const UNSAID: &str = "/found/unsaid";

/// What is used: what nothing says, what the paper says in another place, what tells nothing of the paper, and which signs are meant.
struct Unsaid<'a> {
    unsaid: Vec<Hypothesis<'a>>,
    said: Vec<Hypothesis<'a>>,
    technical: Vec<Hypothesis<'a>>,
    signs: Vec<String>,
}

impl<'a> Unsaid<'a> {
    fn of(derivation: &'a Derivation, account: &'a Account, wholes: &[Whole<'a>]) -> Unsaid<'a> {
        let found = gathered(derivation, account, wholes);
        let (signs, found): (Vec<_>, Vec<_>) = found.into_iter().partition(|h| h.kind == HypothesisKind::Sign);
        let (said, rest): (Vec<_>, Vec<_>) = found.into_iter().partition(|h| is_stated(derivation, wholes, &h.key));
        let (technical, rest): (Vec<_>, Vec<_>) = rest.into_iter().partition(|h| h.kind == HypothesisKind::Technical);
        let mut unsaid = with_intermediate(rest, &derivation.scope);
        // What has words comes first, then what most claims use.
        unsaid.sort_by_key(|h| (h.readable, std::cmp::Reverse(h.used.len())));
        Unsaid { unsaid, said, technical, signs: signs.iter().map(|h| sign(derivation, h)).collect() }
    }
}

/// The claims and readings that use a condition of the paper's subject that nothing says.
pub(super) fn claims_with_unsaid(derivation: &Derivation, account: &Account, wholes: &[Whole<'_>]) -> BTreeSet<String> {
    Unsaid::of(derivation, account, wholes).unsaid.into_iter().flat_map(|h| h.used).collect()
}

/// A hypothesis, and where it is used.
fn with_places<'a>(derivation: &Derivation, of: &Hypothesis<'a>) -> Vec<StorySpan<'a>> {
    of.says.iter().cloned().chain([quiet(format!(" ({})", places(derivation, &of.used)))]).collect()
}

/// Hypotheses as a list, bounded.
fn listed<'a>(all: &[Hypothesis<'a>]) -> Vec<StoryBlock<'a>> {
    let told = &all[..all.len().min(MOST_FOLDED)];
    let mut out = Vec::new();
    if !told.is_empty() {
        out.push(StoryBlock::List(told.chunk_by(is_used_alike).map(item).collect()));
    }
    if all.len() > told.len() {
        out.push(StoryBlock::Paragraph(vec![quiet(format!("{} more are not listed.", all.len() - told.len()))]));
    }
    out
}

/// Which sign of ± is meant, and in which equations.
fn sign(derivation: &Derivation, of: &Hypothesis<'_>) -> String {
    format!("sign in {}: {}", places(derivation, &of.used), of.key)
}

/// What claims use without saying so that the paper says in another place.
fn said_elsewhere<'a>(derivation: &'a Derivation, said: &[Hypothesis<'a>]) -> Vec<StorySpan<'a>> {
    if said.is_empty() {
        return Vec::new();
    }
    let mut out = vec![quiet(" Said once, used elsewhere: ")];
    out.extend(joined(said.iter().take(MOST_ELSEWHERE).map(|of| with_places(derivation, of)), "; "));
    let more = said.len().saturating_sub(MOST_ELSEWHERE);
    out.push(quiet(if more > 0 { format!("; +{more}.") } else { ".".to_owned() }));
    out
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
            for at in [*one, *other] {
                out[at].used.retain(|claim| !both.contains(claim));
            }
            // Where the two may be equal, the third may be anything.
            let differ = canonical(&format!("{}≠{}", a[0], b[0]));
            let known = out.iter().find(|h| canonical(&h.key) == differ);
            let (apart, other): (Vec<String>, Vec<String>) =
                both.into_iter().partition(|claim| known.is_some_and(|h| h.used.contains(claim)));
            let letter = |of: &String| StorySpan::Math(of.clone(), scope);
            let (a, b) = if b[0] < a[0] { (b, a) } else { (a, b) };
            let mut says = vec![letter(third), words(" between "), letter(&a[0]), words(" and "), letter(&b[0])];
            says.push(words(", or equal to one of them"));
            let equal = [words("; or "), letter(&a[0]), words(" = "), letter(&b[0])];
            let loose = says.iter().cloned().chain(equal).collect();
            let key = format!("{third} between {} and {}", a[0], b[0]);
            for (says, key, used) in [(says, key.clone(), apart), (loose, format!("{key} or equal"), other)] {
                if !used.is_empty() {
                    merged.push(Hypothesis {
                        says,
                        key,
                        readable: Readable::Words,
                        kind: HypothesisKind::OfPaper,
                        used,
                    });
                }
            }
        }
    }
    out.retain(|h| !h.used.is_empty());
    out.extend(merged);
    out
}

/// Where a hypothesis is used: the labels of the first equations, and in how many claims more.
fn places(derivation: &Derivation, used: &[String]) -> String {
    let label = |name: &String| derivation.claims.iter().find(|c| c.name() == *name)?.label.as_deref();
    let mut labels: Vec<&str> = Vec::new();
    for of in used.iter().filter_map(label) {
        if !labels.contains(&of) {
            labels.push(of);
        }
    }
    labels.truncate(MOST_PLACES);
    let others = used.iter().filter(|name| label(name).is_none_or(|l| !labels.contains(&l))).count();
    match (labels.is_empty(), others) {
        (true, n) => count(n, "claim"),
        (false, 0) => labels.join(", "),
        (false, n) => format!("{}, +{n}", labels.join(", ")),
    }
}

/// Whether the same claims use both: then they are told together.
fn is_used_alike(a: &Hypothesis<'_>, b: &Hypothesis<'_>) -> bool {
    a.used.len() == b.used.len() && a.used.iter().all(|claim| b.used.contains(claim))
}

/// What the same claims use.
fn item<'a>(all: &[Hypothesis<'a>]) -> StoryItem<'a> {
    let mut line = joined(all.iter().map(|h| h.says.clone()), ", ");
    line.push(quiet(" ("));
    let Some(of) = all.first() else { return StoryItem { mark: String::new(), line, below: Vec::new() } };
    let named = of.used.iter().take(MOST_NAMED).map(|id| vec![StorySpan::Claim(id.clone(), Tone::Quiet)]);
    line.extend(joined(named, ", "));
    let more = of.used.len().saturating_sub(MOST_NAMED);
    line.push(quiet(if more > 0 { format!(" and {more} more)") } else { ")".to_owned() }));
    StoryItem { mark: String::new(), line, below: Vec::new() }
}

/// What was chosen: of the conventions of the file those that a printed formula uses, then the others; and which signs are meant.
fn conventions<'a>(derivation: &'a Derivation, signs: &[String]) -> Option<StoryBlock<'a>> {
    let mut all: Vec<&(String, String)> = derivation.conventions.iter().collect();
    all.sort_by_key(|(_, text)| !is_of_notation(text));
    let mut told: Vec<String> = all.iter().map(|(key, text)| convention(key, text)).collect();
    let of_notation = all.iter().filter(|(_, text)| is_of_notation(text)).count();
    // A sign stands before what is no notation.
    told.splice(of_notation..of_notation, signs.iter().cloned());
    told.retain(|text| text.len() <= LONGEST_CONVENTION);
    told.truncate(MOST_CONVENTIONS);
    let more = (all.len() + signs.len()).saturating_sub(told.len());
    if told.is_empty() {
        return None;
    }
    let told = told.into_iter().map(|text| vec![StorySpan::Prose(text, &derivation.scope, Tone::Quiet)]);
    let mut out = vec![quiet("Conventions: ")];
    out.extend(joined(told, "; "));
    out.push(quiet(if more > 0 { format!("; {more} more.") } else { ".".to_owned() }));
    Some(StoryBlock::Group("roomy", vec![StoryBlock::Paragraph(out)]))
}

/// A convention in a few words: its first part.
fn convention(key: &str, text: &str) -> String {
    let text = text.split_once("; ").map_or(text, |(first, _)| first);
    format!("{}: {}", key.replace('-', " "), text.trim_end_matches('.'))
}

/// Whether a convention says what a sign of a formula means.
fn is_of_notation(text: &str) -> bool {
    let first = text.split_once("; ").map_or(text, |(first, _)| first);
    ["=", "×", "index", "indices", "summed"].iter().any(|sign| first.contains(sign))
}

/// A condition on the order of letters, in words.
fn ordered<'a>(key: &str, scope: &'a Scope) -> Option<Vec<StorySpan<'a>>> {
    let of = sides(key)?;
    let letter = |at: usize| StorySpan::Math(of.letters[at].clone(), scope);
    Some(match of.between {
        None => vec![letter(0), words(" ≠ "), letter(1)],
        Some(true) => {
            vec![
                letter(0),
                words(" between "),
                letter(1),
                words(" and "),
                letter(2),
                words(", or equal to one of them"),
            ]
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
            match left.strip_prefix("(an expression in ").and_then(|of| of.strip_suffix(", too long to print)")) {
                Some(letters) => vec![words(format!("a long expression in {}{rest}", plain(letters)))],
                None => vec![StorySpan::Math(left.into_owned(), scope), words(rest)],
            }
        }),
        // What the steps leave out is a sentence.
        Proviso::Written(text) if text.starts_with("where ") => vec![words(plain(text))],
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
    let mut add = |says: Vec<StorySpan<'a>>, key: String, claim: String, kind: HypothesisKind| {
        let at = *places.entry(one_spelling(derivation, &key)).or_insert(out.len());
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
                out.push(Hypothesis { says, key, readable, kind, used: vec![claim] });
            }
        }
    };
    for unsaid in digest::unsaid(derivation, account) {
        let text = digest::explanation(unsaid.explanation);
        let says = || vec![StorySpan::Prose(text.clone(), &derivation.scope, Tone::Plain)];
        for claim in unsaid.claims.iter().filter(|c| !is_assumed_as_stated(wholes, c)) {
            add(says(), text.clone(), name(claim), HypothesisKind::OfPaper);
        }
    }
    let argued = |role: ClaimRole| matches!(role, ClaimRole::Says | ClaimRole::MayMean | ClaimRole::Lemma);
    for reading in wholes.iter().flat_map(|w| &w.readings).filter(|r| argued(r.role)) {
        let claim = reading.claim;
        let scope = declared(derivation, claim).map_or(&derivation.scope, |d| &d.scope);
        let own: Vec<String> = claim.assumptions.iter().map(|a| canonical(a)).collect();
        let Some(identity) = claim.identity.as_ref().filter(|i| i.finding.is_proved_in_part()) else { continue };
        for (term, provisos) in identity.terms().iter().filter(|(term, _)| uses(*term)) {
            // That the orders of letters say the same again tells nothing more.
            for proviso in provisos.iter().filter(|p| provisos.len() == 1 || !matches!(p, Proviso::Orders(_))) {
                let (says, key) = match term {
                    Term::Exception => of_proviso(&excluded(proviso), scope),
                    Term::Condition | Term::GivenOnlyWhere | Term::Presupposed | Term::Used | Term::Unused => {
                        of_proviso(proviso, scope)
                    }
                };
                if !own.contains(&canonical(&key)) {
                    let kind = if is_technical(&key) { HypothesisKind::Technical } else { HypothesisKind::OfPaper };
                    add(says, key, name(claim), kind);
                }
            }
        }
        if let Some(branch) = &identity.evidence.branch {
            let text = branch.to_string();
            let says = vec![StorySpan::Prose(text.clone(), scope, Tone::Plain)];
            add(says, text, name(claim), HypothesisKind::Sign);
        }
    }
    for reading in wholes.iter().flat_map(|w| &w.readings).filter(|r| argued(r.role) && r.standing == Standing::Holds) {
        let mut left_out = reading.claim.results.iter().flat_map(|p| &p.verdict.evidence().excluded);
        if left_out.any(|e| e.reason.is_no_value()) {
            let text = "times at which a side has no value are left out";
            add(vec![words(text)], text.to_owned(), name(reading.claim), HypothesisKind::Technical);
        }
    }
    for reading in wholes.iter().flat_map(|w| &w.readings).filter(|r| r.role == ClaimRole::MayMean) {
        let claim = reading.claim;
        for needed in claim.conditions.assumptions.iter().filter(|a| a.need == Need::Needed) {
            let says = points::in_words(derivation, &needed.text, claim);
            let key = if let StorySpan::Prose(text, ..) = &says { text.clone() } else { needed.text.clone() };
            add(vec![says], key, name(claim), HypothesisKind::OfPaper);
        }
    }
    out
}

/// Whether the paper's own reading of a sentence stands under an assumption that this one leaves out: then the condition is said, and what
/// is tried is what the paper makes of the sentence.
fn is_assumed_as_stated(wholes: &[Whole<'_>], claim: &ClaimAccount) -> bool {
    let Some(whole) = wholes.iter().find(|w| w.id == claim.id) else { return false };
    let is_read_so = |r: &Reading<'_>| r.role == ClaimRole::Needs && r.claim.reading == claim.reading;
    let is_stated = |r: &Reading<'_>| {
        r.role == ClaimRole::Says
            && r.standing == Standing::Holds
            && r.claim.assumptions.len() > claim.assumptions.len()
            && r.claim.formulas == claim.formulas
    };
    whole.readings.iter().any(is_read_so) && whole.readings.iter().any(is_stated)
}

/// Whether a condition of a proof tells nothing of the paper: a division by an expression or a rate, and the domain of a function. That
/// two letters differ, or one is not 0, is of the paper.
fn is_technical(key: &str) -> bool {
    match sides(&upright(key)) {
        // A rate, and a function of a letter, are none.
        Some(of) => of.letters.iter().any(|letter| {
            letter.starts_with("\\dot") || letter.starts_with("\\ddot") || letter.matches('\\').count() > 1
        }),
        None => {
            key.starts_with("where ") || key.contains('≠') || key.contains("|") || key.contains("too long to print")
        }
    }
}

/// What is the same condition has one spelling, in the words of the file or as a formula: letters are not told apart by how they are
/// printed, nor by the order of what is raised and lowered.
fn one_spelling(derivation: &Derivation, key: &str) -> String {
    let named = derivation.conditions.iter().find(|c| c.says.trim_end_matches('.') == key);
    let formula = match named.map(|c| c.holds.as_slice()) {
        Some([one]) => one.text.as_str(),
        _ => key.trim_matches('$'),
    };
    lowered_first(&upright(&canonical(formula)))
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_proofs_divide_by_is_not_of_the_paper() {
        for key in [r"r^2-a ≠ 0", r"\dot{\theta} ≠ 0", r"|-h/(g\ell)| ≤ 1", r"\sin(\theta) ≠ 0"] {
            assert!(is_technical(key), "{key}");
        }
        for key in [r"{\bf m}_3 ≠ 0", r"m_3 ≠ 0", r"I_1\ne I_2", r"(I_2-I_3)\cdot (I_2-I_1) ≥ 0", "R(0) = 1"] {
            assert!(!is_technical(key), "{key}");
        }
        assert!(is_technical(r"\sin\theta\ne 0"));
        assert_eq!(lowered_first("2E=I^{-1}_im_i^2"), "2E=I_i^{-1}m_i^2");
        assert!(is_of_notation("[a,b] = a × b, right-handed") && !is_of_notation("any consistent units; a = b"));
        assert_eq!(convention("euler-angles", "zxz: R = Z; more."), "euler angles: zxz: R = Z");
    }
}
