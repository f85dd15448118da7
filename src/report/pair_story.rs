//! What was found of a claim on motions: where it holds, where it fails, with the motion that tells most.
//!
//! **In:** the pairs of a claim. **Out:** blocks: a line for each verdict, and a witness; the table of all pairs is for the page alone.

use super::card;
use super::numbers::{count, six, size, time};
use super::refuting;
use super::shape::VerdictShape;
use super::story::{Elsewhere, StoryBlock, StoryFold, StorySpan, Tone, embedded, on_page, prose, strong, words};
use super::tally::{Group, groups, in_order};
use super::wording::{label, slack_sentence};
use derivation::Derivation;
use findings::{Account, ClaimAccount, Outcome, PairAccount, Strength, Witness};
use latex::Scope;

/// Most motions that are named beside a verdict that is as expected; the matrix shows the others.
const NAMED: usize = 3;
/// So many values of a witness are written out.
const FEW: usize = 3;

/// All verdicts of a claim; what fails comes first.
pub(super) fn blocks<'a>(
    derivation: &'a Derivation,
    account: &'a Account,
    claim: &'a ClaimAccount,
    scope: &'a Scope,
) -> Vec<StoryBlock<'a>> {
    let mut groups = groups(claim);
    in_order(&mut groups);
    let is_one = groups.len() == 1;
    let mut out = Vec::new();
    for (at, group) in groups.iter().enumerate() {
        // What does not apply, as it should not, is seen in the matrix; how many fail is said above, and where in the witness.
        let is_counted = group.word == "fails" && (group.pairs.len() == 1 || group.pairs.len() > NAMED);
        let is_told =
            group.unexpected || is_one && group.word != "fails" || group.word != "not-applicable" && !is_counted;
        let line = if is_told { line(account, claim, group, scope) } else { Vec::new() };
        let class = format!("verdicts {}{}", group.word, if group.unexpected { " x" } else { "" });
        let shape = group.pairs.first().map(|p| StorySpan::Shape(shape(p.verdict.outcome())));
        let mut title: Vec<StorySpan<'a>> = shape.into_iter().chain([words(" "), strong(word(group.word))]).collect();
        title.push(words(
            on_all(account, claim, group).unwrap_or_else(|| format!(" on {}", count(group.pairs.len(), "motion"))),
        ));
        title.extend(expected(group));
        let table = embedded(move || super::page::pairs::table(account, claim, at, scope));
        let blocks = vec![table];
        out.push(StoryBlock::Fold(StoryFold { title, class, elsewhere: Elsewhere::Line(line), blocks }));
        let failing = group.telling().filter(|_| group.word == "fails").map(|p| p.trajectory.as_str());
        if let Some(pair) = failing.and_then(|id| claim.on(id)) {
            out.extend(witness(derivation, claim, pair, scope));
        }
    }
    out
}

/// The symbol of a verdict.
fn shape(outcome: Outcome) -> VerdictShape {
    match outcome {
        Outcome::Holds(Strength::Proved) => VerdictShape::Proved,
        Outcome::Holds(Strength::Enclosed) => VerdictShape::Enclosed,
        Outcome::Holds(Strength::Sampled) => VerdictShape::Sampled,
        Outcome::Fails(Strength::Sampled) => VerdictShape::Fails,
        Outcome::Fails(_) => VerdictShape::Certified,
        Outcome::NotApplicable(_) => VerdictShape::NotApplicable,
        Outcome::Undecided => VerdictShape::Undecided,
    }
}

fn word(of: &str) -> &'static str {
    match of {
        "holds" => "Holds",
        "fails" => "Fails",
        "undecided" => "Undecided",
        _ => "Does not apply",
    }
}

/// `on all 5 motions`, where it is so.
fn on_all(account: &Account, claim: &ClaimAccount, group: &Group<'_>) -> Option<String> {
    let (n, of) = (group.pairs.len(), account.trajectories.len());
    let tried = if n < of { " on which it is tried" } else { "" };
    (n == claim.results.len() && n > 1).then(|| format!(" on all {}{tried}", count(n, "motion")))
}

/// What was expected, where it is not so.
fn expected<'a>(group: &Group<'_>) -> Vec<StorySpan<'a>> {
    let text = match (group.unexpected, group.expected) {
        (true, Some(word)) => format!("expected: {word}"),
        (true, None) => "not expected".to_owned(),
        (false, _) => return Vec::new(),
    };
    vec![words(", "), StorySpan::Words(text, Tone::Alarm)]
}

/// The pairs with one verdict in a line: where, and what the one shows that tells most.
fn line<'a>(account: &Account, claim: &ClaimAccount, group: &Group<'_>, scope: &'a Scope) -> Vec<StorySpan<'a>> {
    let names: Vec<&str> = group.pairs.iter().map(|p| p.trajectory.as_str()).collect();
    let on = match on_all(account, claim, group).filter(|_| names.len() > NAMED) {
        Some(all) => all,
        None if names.len() > NAMED && !group.unexpected => format!(" on {}", names.len()),
        None => format!(" on {}", names.join(", ")),
    };
    let mut out = vec![strong(word(group.word)), words(on)];
    out.extend(expected(group));
    let Some(pair) = group.telling() else { return out };
    let is_good = group.word == "holds";
    let strength = pair.verdict.outcome().strength().filter(|s| is_good && *s != "sampled");
    out.push(words(strength.map(|s| format!(" ({s}).")).unwrap_or_else(|| ".".to_owned())));
    if group.word == "holds" || group.word == "undecided" || group.unexpected {
        out.extend(told(pair, is_good, group.pairs.len() == 1, scope));
    }
    out
}

/// The pair that tells most of those that do not fail.
fn told<'a>(pair: &PairAccount, is_good: bool, is_alone: bool, scope: &'a Scope) -> Vec<StorySpan<'a>> {
    let evidence = pair.verdict.evidence();
    let mut out = Vec::new();
    // Of what is known at every time the samples tell nothing more: the page and `report.json` have them.
    let is_sampled = pair.verdict.outcome().strength() == Some("sampled");
    if let Some(r) = evidence.residual.as_ref().filter(|_| is_good && is_sampled) {
        out.push(words(format!(" Largest residual {}, bound {} (sampled).", size(r.max), size(r.bound))));
    }
    out.extend(slack_sentence(pair).map(|slack| words(format!(" {slack}."))));
    if let Some(reason) = evidence.reason.as_ref().filter(|_| !is_good && evidence.witness.is_none()) {
        let on = if is_alone { " ".to_owned() } else { format!(" On {}: ", pair.trajectory) };
        out.extend([words(on), StorySpan::Reason(format!("{reason}."), scope)]);
    }
    if let Some(e) = evidence.excluded.first() {
        let more = if evidence.excluded.len() > 1 { ", and more." } else { "." };
        let on = if is_alone { String::new() } else { format!(" on {}", pair.trajectory) };
        out.push(words(format!(" Left out{on}: {} … {}, ", time(e.from), time(e.to))));
        out.push(StorySpan::Reason(format!("{}{more}", e.reason), scope));
    }
    out
}

/// A refuting point: both sides, and what they depend on.
fn witness<'a>(
    derivation: &'a Derivation,
    claim: &'a ClaimAccount,
    pair: &'a PairAccount,
    scope: &'a Scope,
) -> Option<StoryBlock<'a>> {
    let w = pair.verdict.evidence().witness.as_ref()?;
    let mut line = vec![words(format!("On {} at t = {}", pair.trajectory, six(w.t)))];
    // The only formula of a claim stands above.
    let of = label(&w.formula);
    if !matches!(claim.formulas.as_slice(), [one] if one == of.formula && of.component.is_none()) {
        line.extend([words(", for "), StorySpan::Comparison(w.formula.clone(), scope)]);
    }
    let kind = card::kind_at(derivation, claim, Some(w));
    line.push(words(format!(": {}.", refuting::bare_values(claim, kind, w, &|text| text.to_owned()))));
    // Values that would fill a page are in `report.json`, to be recomputed.
    if (1..=FEW).contains(&w.values.len()) {
        let values: Vec<String> = w.values.iter().map(|(n, v)| format!("${n}$ = {}", six(*v))).collect();
        line.push(prose(format!(" There {}.", values.join(", ")), scope));
    }
    let sides = format!("# {}\n", refuting::values(claim, kind, w, &|text| text.to_owned()));
    let lines = StoryBlock::Lines(sides + &pasted(w), "");
    let blocks = vec![StoryBlock::Paragraph(line), on_page("Values there", "", vec![lines])];
    Some(StoryBlock::Group("witness", blocks))
}

/// The values of a witness as assignments, which most languages read.
fn pasted(w: &Witness) -> String {
    assigned(w).into_iter().map(|(name, v)| format!("{name} = {v:?}\n")).collect()
}

/// The values of a witness, each with a name that no other has; the time is the first.
pub(super) fn assigned(w: &Witness) -> Vec<(String, f64)> {
    let mut out: Vec<(String, f64)> = vec![("t".to_owned(), w.t)];
    for (name, v) in w.values.iter().filter(|(name, _)| name != "t") {
        let mut word = super::wording::identifier(name);
        while out.iter().any(|(known, _)| *known == word) {
            word.push('_');
        }
        out.push((word, *v));
    }
    out
}
