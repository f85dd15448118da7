//! What `rederive check` prints: the matrix of verdicts, what differs, what fails, and the counts.

use super::finding::{self, Finding};
use super::numbers::{both, count, retold, six, size, time, value};
use super::refuting::Refutes;
use super::story::{StoryBlock, terminal};
use super::tally::{Group, glyph, groups, name, says};
use super::text::{Paint, fitted, paragraph, width, wrapped};
use super::{discrimination, family, region};
use derivation::Derivation;
use findings::{Account, ClaimAccount, FamilyAccount, PairAccount, Summary, Witness};
use std::time::Duration;

/// Widest name of a claim in the matrix.
const NAME_WIDTH: usize = 60;
/// Most groups of pairs that are told of a kind, unless everything is asked for.
const MOST_BLOCKS: usize = 8;
/// The most values that are shown beside a witness.
const VALUES_SHOWN: usize = 12;
/// The most places of a measurement that are shown.
const TIMES_SHOWN: usize = 4;
/// The most trajectories that are named beside the telling one.
const OTHERS_SHOWN: usize = 6;
/// The most trajectories of which a measurement is shown; with one more, that one is shown, too.
const MEASURED_SHOWN: usize = 6;

/// The summary of one derivation, with escape codes if `colour`: page one, what differs, what is open, and the counts.
/// With `whole` the matrix of all verdicts, every failure, and all that was found beside the verdicts.
pub fn summary(derivation: &Derivation, account: &Account, colour: bool, whole: bool) -> String {
    let (paint, scope) = (Paint(colour), &derivation.scope);
    let mut out = super::page_one::front_page(derivation, account, colour);
    out.push('\n');
    let most = if whole { usize::MAX } else { MOST_BLOCKS };
    let blocks = |title: &str, wanted: &dyn Fn(&Group<'_>) -> bool, most: usize| {
        blocks(derivation, account, paint, title, most, wanted)
    };
    let known = |word: &'static str| move |g: &Group<'_>| g.word == word && !g.unexpected;
    if whole {
        out.push_str(&matrix(account, paint));
    }
    let told = if whole { Told::All } else { Told::Unexpected };
    out.push_str(&region::summary(derivation, account, paint, whole || account.claims.len() <= MOST_BLOCKS));
    out.push_str(&families(derivation, account, paint, told));
    out.push_str(&blocks("Differs from what is expected", &|g| g.unexpected, usize::MAX));
    out.push_str(&alone(derivation, account, paint));
    if whole {
        out.push_str(&blocks("Fails, as expected", &known("fails"), most));
    }
    match whole {
        true => out.push_str(&blocks("Undecided", &known("undecided"), most)),
        false => {
            out.push_str(&blocks("Undecided", &|g| g.word == "undecided" && g.expected.is_none(), most));
            out.push_str(&left_open(account, paint));
        }
    }
    out.push_str(&spaced(&super::units::problems(&account.units, scope), paint));
    out.push_str(&problems(account, paint));
    if whole {
        out.push_str(&spaced(&super::conditions::summary(account, scope), paint));
        out.push_str(&spaced(&discrimination::summary(account, scope), paint));
        out.push_str(&measurements(derivation, account, paint));
    }
    out.push_str(&counts(account, paint));
    out.push_str(&super::recorded::count(account));
    if !whole {
        out.push_str("--matrix prints the matrix of verdicts and all that was found\n");
    }
    out
}

/// What `--quiet` prints: nothing, unless something differs or is undecided.
pub fn exceptions(derivation: &Derivation, account: &Account, colour: bool) -> String {
    let (paint, scope) = (Paint(colour), &derivation.scope);
    let all = usize::MAX;
    let mut out = blocks(derivation, account, paint, "Differs from what is expected", all, |g| g.unexpected);
    out.push_str(&alone(derivation, account, paint));
    out.push_str(&blocks(derivation, account, paint, "Undecided", all, |g| g.word == "undecided" && !g.unexpected));
    out.push_str(&region::summary(derivation, account, paint, false));
    out.push_str(&families(derivation, account, paint, Told::Unexpected));
    out.push_str(&spaced(&super::units::problems(&account.units, scope), paint));
    out.push_str(&problems(account, paint));
    out
}

/// Blocks, and a line below them.
fn spaced(blocks: &[StoryBlock<'_>], paint: Paint) -> String {
    if blocks.is_empty() { String::new() } else { terminal(blocks, 0, paint) + "\n" }
}

fn bare(text: &str) -> String {
    text.replace('$', "")
}

/// One claim on one family, in the terminal; `pasted` gives the members as trajectories.
pub(super) fn on_family(
    derivation: &Derivation,
    claim: &ClaimAccount,
    family: &FamilyAccount,
    paint: Paint,
    pasted: bool,
) -> String {
    let outcome = family.verdict.outcome();
    let strength = outcome.strength().map(|s| format!(" ({s})")).unwrap_or_default();
    let head =
        format!("{}  {}{strength} on {}{}", glyph(outcome), outcome.word(), family.family, family::expected(family));
    let head = if family.is_unexpected() { paint.alarm(&head) } else { paint.verdict(outcome, &head) };
    let mut out = format!("  {}  {head}\n", paint.bold(&name(claim)));
    out.push_str(&paragraph(&bare(&says(derivation, claim)), 4));
    out.push_str(&terminal(&[family::told(family, &derivation.scope)], 4, paint));
    for of in family::shown(family) {
        out.push_str(&paragraph(&bare(&of.named()), 4));
        match &of.member.verdict.evidence().witness {
            Some(witness) => {
                out.push_str(&format!("      at t = {}:  {}\n", time(witness.t), witness.formula));
                out.push_str(&sides(witness, 6, Digits::Six));
            }
            None => out.extend(of.seen.iter().map(|text| paragraph(&bare(text), 6))),
        }
        if pasted {
            out.push('\n');
            out.extend(of.member.toml.lines().map(|line| format!("    {line}\n")));
            out.push('\n');
        }
    }
    out.push('\n');
    out
}

/// Which families the terminal shows.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Told {
    /// All.
    All,
    /// Those that differ from what is expected, or are open without being expected to.
    Unexpected,
}

/// The families in the terminal. Where one differs, or is open without being expected to, its members are given to paste.
fn families(derivation: &Derivation, account: &Account, paint: Paint, told: Told) -> String {
    let open = |f: &FamilyAccount| f.verdict.outcome().word() == "undecided" && f.expected.is_none();
    let wanted = |f: &&FamilyAccount| told == Told::All || f.is_unexpected() || open(f);
    let mut body = String::new();
    let mut number = 0;
    for claim in &account.claims {
        for family in claim.families.iter().filter(wanted) {
            number += 1;
            body.push_str(&on_family(derivation, claim, family, paint, family.is_unexpected() || open(family)));
        }
    }
    if body.is_empty() { body } else { format!("{} ({number})\n\n{body}", paint.bold("On families of motions")) }
}

/// The matrix of verdicts, in as many parts as its columns need, with its legend.
fn matrix(account: &Account, paint: Paint) -> String {
    // What is about ranges has no cells.
    let rows: Vec<&ClaimAccount> = account.claims.iter().filter(|c| !c.results.is_empty()).collect();
    if rows.is_empty() {
        return String::new();
    }
    let names: Vec<String> = rows.iter().map(|c| name(c)).collect();
    let wide = names.iter().map(|n| n.chars().count()).max().unwrap_or(0).clamp(8, NAME_WIDTH);
    let columns = width().saturating_sub(4 + wide).max(2) / 2;
    let numbered: Vec<(String, &str)> =
        account.trajectories.iter().enumerate().map(|(i, t)| ((i + 1).to_string(), t.id.as_str())).collect();
    let digits = numbered.last().map_or(1, |(n, _)| n.len());
    let mut out = String::new();
    for part in numbered.chunks(columns) {
        for digit in 0..digits {
            let at = |n: &str| fitted("", digits - n.len()) + n;
            let row: String = part.iter().map(|(n, _)| format!("{} ", &at(n)[digit..=digit])).collect();
            out.push_str(&paint.faint(format!("  {}  {row}", " ".repeat(wide)).trim_end()));
            out.push('\n');
        }
        for (claim, name) in rows.iter().zip(&names) {
            let cells: String = part.iter().map(|(_, id)| cell(claim, id, paint)).collect();
            out.push_str(format!("  {}  {cells}", fitted(name, wide)).trim_end());
            out.push('\n');
        }
        out.push('\n');
    }
    let legend = "H holds   h holds, but weakly   F fails   - does not apply   ? undecided   ! not as expected";
    out.push_str(&format!("  {legend}\n\n"));
    out.push_str(&wrapped(numbered.iter().map(|(n, id)| format!("{n}\u{a0}{id} ")), 2));
    out.push('\n');
    out.replace('\u{a0}', " ").replace(" \n", "\n")
}

fn cell(claim: &ClaimAccount, trajectory: &str, paint: Paint) -> String {
    match claim.on(trajectory) {
        None => "  ".to_owned(),
        Some(pair) => {
            let outcome = pair.verdict.outcome();
            let mark = if pair.is_unexpected() { paint.alarm("!") } else { " ".to_owned() };
            let glyph = if discrimination::is_weak(pair) { 'h' } else { glyph(outcome) };
            paint.verdict(outcome, &glyph.to_string()) + &mark
        }
    }
}

/// What is undecided as the file expects, a line for each claim.
fn left_open(account: &Account, paint: Paint) -> String {
    let mut lines = Vec::new();
    for claim in &account.claims {
        for group in groups(claim).iter().filter(|g| g.word == "undecided" && g.expected == Some("undecided")) {
            let first = group.pairs.first().map_or("", |p| p.trajectory.as_str());
            let of = format!("{} of {}", group.pairs.len(), count(claim.results.len(), "motion"));
            lines.push(format!("  {}  on {of}, e.g. {first}\n", name(claim)));
        }
    }
    let more = lines.len().saturating_sub(MOST_BLOCKS);
    let body = lines.iter().take(MOST_BLOCKS).map(String::as_str).collect::<String>();
    let rest = if more > 0 { format!("  and {more} more, in the report\n") } else { String::new() };
    let title = paint.bold("Undecided, as expected");
    if body.is_empty() { body } else { format!("{title} ({})\n\n{body}{rest}\n", lines.len()) }
}

/// One block for each group of pairs that is wanted.
fn blocks(
    derivation: &Derivation,
    account: &Account,
    paint: Paint,
    title: &str,
    most: usize,
    wanted: impl Fn(&Group<'_>) -> bool,
) -> String {
    let mut body = String::new();
    let (mut number, mut told, mut more) = (0, 0, 0);
    for claim in &account.claims {
        for group in groups(claim).iter().filter(|g| wanted(g)) {
            number += group.pairs.len();
            if told == most {
                more += 1;
                continue;
            }
            told += 1;
            body.push_str(&block(derivation, claim, group, paint));
        }
    }
    if more > 0 {
        body.push_str(&format!("  and {more} more, in the report\n\n"));
    }
    if body.is_empty() { body } else { format!("{} ({number})\n\n{body}", paint.bold(title)) }
}

fn block(derivation: &Derivation, claim: &ClaimAccount, group: &Group<'_>, paint: Paint) -> String {
    let Some(telling) = group.telling() else { return String::new() };
    let outcome = telling.verdict.outcome();
    let tried = count(claim.results.len(), "motion");
    let expected = match group.expected {
        Some(word) if group.unexpected => format!(", expected: {word}"),
        _ => String::new(),
    };
    let head =
        format!("  {}  {} on {} of {tried}{expected}\n", paint.bold(&name(claim)), group.word, group.pairs.len());
    let mut out = paint.verdict(outcome, &head);
    let place = claim.place.as_ref().map(|p| format!(" ({p})")).unwrap_or_default();
    out.push_str(&paragraph(&format!("{}{place}", says(derivation, claim)), 4));
    out.push_str(&telling_point(telling, 4));
    if let Some(text) = super::card::instead(claim).filter(|_| group.word == "fails") {
        out.push_str(&paragraph(&text, 4));
    }
    let others: Vec<&str> =
        group.pairs.iter().map(|p| p.trajectory.as_str()).filter(|t| *t != telling.trajectory).collect();
    if !others.is_empty() {
        let shown = if others.len() > OTHERS_SHOWN + 1 { OTHERS_SHOWN } else { others.len() };
        let (named, more) = others.split_at(shown);
        let more = if more.is_empty() { String::new() } else { format!(" and {} more", more.len()) };
        out.push_str(&paragraph(&format!("also on {}{more}", named.join(", ")), 4));
    }
    out.push('\n');
    out
}

/// Claims that are tried on nothing, and are not as expected.
fn alone(derivation: &Derivation, account: &Account, paint: Paint) -> String {
    let told: Vec<Finding> = account.claims.iter().filter_map(|claim| finding::alone(derivation, claim)).collect();
    let body: String = told.iter().map(|f| format!("{}\n", paragraph(&bare(&f.message), 2))).collect();
    let title = paint.bold("Differs from what is expected, for all values");
    if body.is_empty() { body } else { format!("{title} ({})\n\n{body}", told.len()) }
}

/// The point, or the reason, that a verdict rests on.
fn telling_point(pair: &PairAccount, indent: usize) -> String {
    let evidence = pair.verdict.evidence();
    let space = " ".repeat(indent);
    let mut out = String::new();
    if let Some(reason) = &evidence.reason {
        out.push_str(&paragraph(&retold(&format!("{}: {reason}", pair.trajectory)), indent));
    }
    match (&evidence.witness, &evidence.residual) {
        (Some(witness), _) => {
            let place = format!("{} at t = {}:", pair.trajectory, time(witness.t));
            if indent + place.chars().count() + 2 + witness.formula.chars().count() > width() {
                out.push_str(&format!("{space}{place}\n{}", paragraph(&witness.formula, indent)));
            } else {
                out.push_str(&format!("{space}{place}  {}\n", witness.formula));
            }
            out.push_str(&sides(witness, indent + 2, Digits::Six));
        }
        (None, Some(r)) if evidence.reason.is_none() => out.push_str(&format!(
            "{space}{}: largest residual {} at t = {}, error bound {}, {}\n",
            pair.trajectory,
            size(r.max),
            time(r.at),
            size(r.bound),
            count(evidence.samples, "sample"),
        )),
        (None, _) => {}
    }
    out
}

/// Both sides of an equation at a witness, and what they depend on: with all digits, or with as many as tell them apart.
pub(super) fn sides(witness: &Witness, indent: usize, digits: Digits) -> String {
    let space = " ".repeat(indent);
    let difference = format!("difference {}, ", size(witness.difference()));
    let (left, right) = match digits {
        Digits::All => (value(witness.left), value(witness.right)),
        Digits::Six => both(witness.left, witness.right),
    };
    let bound = size(witness.bound.max(0.0));
    let mut out = match Refutes::of(witness) {
        Refutes::NoValue => format!("{space}it has no value there\n"),
        Refutes::Same => format!("{space}both sides are {left}, error bound {bound}\n"),
        Refutes::Apart => {
            format!("{space}left   {left}\n{space}right  {right}\n{space}{difference}error bound {bound}\n")
        }
    };
    let shown = |x: f64| if digits == Digits::All { value(x) } else { six(x) };
    if !witness.values.is_empty() {
        let mut words: Vec<String> =
            witness.values.iter().take(VALUES_SHOWN).map(|(n, v)| format!("{n} = {};", shown(*v))).collect();
        if witness.values.len() > VALUES_SHOWN {
            words.push("…".into());
        }
        let line = wrapped(std::iter::once("at".to_owned()).chain(words), indent);
        out.push_str(line.trim_end().trim_end_matches(';'));
        out.push('\n');
    }
    out
}

/// How many digits of a number are printed.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Digits {
    /// Those with which it can be computed again.
    All,
    /// Six, where they tell both sides apart.
    Six,
}

fn measurements(derivation: &Derivation, account: &Account, paint: Paint) -> String {
    let mut out = String::new();
    for measure in &derivation.measures {
        let mut lines = String::new();
        let found: Vec<_> =
            account.measurements.iter().filter(|m| m.measure == measure.id && !m.values.is_empty()).collect();
        let shown = if found.len() > MEASURED_SHOWN + 1 { MEASURED_SHOWN } else { found.len() };
        for m in &found[..shown] {
            let values = m.values.iter().take(TIMES_SHOWN).map(|(t, v, b)| {
                let unit = measure.unit.as_ref().map(|u| format!(" {u}")).unwrap_or_default();
                format!("{}{unit} ± {} (t = {});", time(*v), size(*b), time(*t)).replace(' ', "\u{a0}")
            });
            let more = m.values.len().saturating_sub(TIMES_SHOWN);
            let more = (more > 0).then(|| format!("and\u{a0}{more}\u{a0}more"));
            let line = wrapped(std::iter::once(format!("{}:", m.trajectory)).chain(values).chain(more), 4);
            lines.push_str(line.trim_end().trim_end_matches(';'));
            lines.push('\n');
        }
        if found.len() > shown {
            lines.push_str(&format!("    and on {} more, in the report\n", found.len() - shown));
        }
        for of in account.distributions.iter().filter(|of| of.measure == measure.id) {
            lines.push_str(&paragraph(&format!("{}: {}", of.family, bare(&family::distribution(of))), 4));
        }
        if !lines.is_empty() {
            let head = paragraph(&format!("{}: {}", measure.id, measure.says), 2);
            out.push_str(&head.replacen(&measure.id, &paint.bold(&measure.id), 1));
            out.push_str(&lines);
        }
    }
    let out = out.replace('\u{a0}', " ");
    if out.is_empty() { out } else { format!("{}\n\n{out}\n", paint.bold("Measured")) }
}

fn problems(account: &Account, paint: Paint) -> String {
    let mut out = String::new();
    for t in &account.trajectories {
        if let Some(problem) = &t.problem {
            out.push_str(&paint.alarm(&paragraph(&format!("motion {}: {problem}", t.id), 2)));
        }
    }
    if out.is_empty() { out } else { out + "\n" }
}

/// What is printed when a file was checked again, of which `checked` claims had to be: what differs or is open, and the counts.
pub fn checked_again(
    derivation: &Derivation,
    account: &Account,
    checked: usize,
    took: Duration,
    colour: bool,
) -> String {
    let (out, s) = (exceptions(derivation, account, colour), account.summary());
    let (id, took) = (&derivation.id, took.as_millis());
    format!(
        "{out}{id}: {checked} claims checked again in {took} ms; {}, {} not as expected\n",
        verdicts(&s),
        s.unexpected
    )
}

fn verdicts(s: &Summary) -> String {
    format!("{} hold, {} fail, {} do not apply, {} undecided", s.holds, s.fails, s.not_applicable, s.undecided)
}

/// The last lines: how many pairs have which verdict.
fn counts(account: &Account, paint: Paint) -> String {
    let s = account.summary();
    let claims = count(account.claims.len(), "claim");
    let mut trajectories = count(account.trajectories.len(), "motion");
    let mut families: Vec<&str> = account.claims.iter().flat_map(|c| &c.families).map(|f| f.family.as_str()).collect();
    families.sort_unstable();
    families.dedup();
    if !families.is_empty() {
        trajectories.push_str(&format!(" and {}", count(families.len(), "family")));
    }
    let verdicts = verdicts(&s);
    let unexpected = match s.unexpected {
        0 => "as expected".to_owned(),
        n => paint.alarm(&format!("{n} not as expected")),
    };
    format!("{claims} (readings counted) on {trajectories}: {unexpected}\n{verdicts}\n")
}

#[cfg(all(test, debug_assertions))]
mod tests {
    use super::super::tests::derivation;
    use super::*;
    use findings::sample;

    #[test]
    fn the_summary_of_a_small_account() {
        insta::assert_snapshot!(summary(&derivation(), &sample::account(), false, true));
    }

    #[test]
    fn quiet_keeps_what_matters() {
        insta::assert_snapshot!(exceptions(&derivation(), &sample::account(), false));
    }

    #[test]
    fn many_trajectories_and_long_names_fit() {
        let mut account = sample::account();
        account.claims[0].id = "a-claim-with-an-unusually-long-name-that-goes-on".into();
        let first = account.trajectories[0].clone();
        let result = account.claims[1].results[0].clone();
        account.trajectories.clear();
        account.claims[1].results.clear();
        for i in 0..131 {
            let id = format!("trajectory-{i}");
            account.trajectories.push(findings::TrajectoryAccount { id: id.clone(), ..first.clone() });
            account.claims[1].results.push(PairAccount { trajectory: id, ..result.clone() });
        }
        let text = summary(&derivation(), &account, false, true);
        for line in text.lines() {
            assert!(line.chars().count() <= width(), "{line}");
        }
        assert!(text.contains("fails on 131 of 131 motions"));
        assert_eq!(text.matches("left   ").count(), 1, "one witness for all of them");
    }

    #[test]
    fn colour_changes_nothing_but_colour() {
        let plain = summary(&derivation(), &sample::account(), false, true);
        let coloured = summary(&derivation(), &sample::account(), true, true);
        assert_ne!(plain, coloured);
        assert_eq!(anstream::adapter::strip_str(&coloured).to_string(), plain);
    }
}
