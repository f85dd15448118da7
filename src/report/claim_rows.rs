//! The claims of `report.md`: a row of a table for each of which no more is to be said than that it holds wherever it applies, and
//! a section for each of the others.
//!
//! **In:** a derivation, its account and its graph. **Out:** Markdown. **Guaranteed:** what is not as expected, fails, is open, or is
//! tried over ranges or families has a section, with the motion that tells most; every claim and reading is named once.
//! What is left out, and stands in `index.html`, is said at the top: whoever reads on a forge wants to see what does not stand.

use super::digest::{self, Fate, Reading, Whole};
use super::form::{Heading, heading};
use super::graph::{DerivationGraph, ProofStanding};
use super::headline;
use super::markdown::{anchor, whose};
use super::markup::{display, math, prose, table};
use super::numbers::{count, six, size, time};
use super::refuting;
use super::tally::{Group, Standing, declared, groups, name};
use super::text::uncapital;
use super::wording::{label, slack_sentence};
use super::{discrimination, family};
use crate::derivation::{ClaimRole, DEFAULT_PRECISION, Derivation, FormKind};
use findings::{Account, ClaimAccount, Grounds, PairAccount};

/// The section.
pub(super) fn section(derivation: &Derivation, account: &Account, graph: &DerivationGraph) -> String {
    let mut out = format!("## Claims\n\n{}", roles_told(derivation));
    out.push_str(LEFT_OUT);
    let wholes = digest::wholes(derivation, account);
    for fate in Fate::ALL {
        let found: Vec<&Whole<'_>> = wholes.iter().filter(|w| w.fate == fate).collect();
        if found.is_empty() {
            continue;
        }
        out.push_str(&format!("### {}\n\n{}\n\n", headline::heading(fate, &found), fate.meaning()));
        let has_row = |whole: &&Whole<'_>| whole.readings.iter().all(|r| is_short(r)) && !fate.is_against();
        let (plain, others): (Vec<&Whole<'_>>, Vec<&Whole<'_>>) = found.into_iter().partition(has_row);
        others
            .iter()
            .for_each(|whole| out.push_str(&whole_section(derivation, graph, whole, account.trajectories.len())));
        if !plain.is_empty() {
            let rows = plain.iter().flat_map(|w| rows(derivation, w));
            out.push_str(&table(&["claim", "what it says", "formula", "how it fares"], rows));
        }
    }
    out
}

/// What a reader finds elsewhere.
const LEFT_OUT: &str = "Formulas are said of every time, where nothing else is said. ◆ proved for all values, ◈ proved given claims \
                        that are not, ⬖ special cases apart, ■ holds at every time, ● at all samples, ◐ holds on some and fails on others, ✕ fails, ? open, – applies nowhere; † has a certificate, \
                        `certificates/NAME.py`, with two hyphens for the stroke in a name. Not here, but in `index.html` and \
                        `report.json`: the steps of proofs, residuals and bounds, curves, members of families to look at, points that refute what is for \
                        comparison, the worth of assumptions, remarks on what holds.\n\n";

/// Whether no more is to be said of it than that it holds wherever it applies, and how that is known.
fn is_plain(reading: &Reading<'_>) -> bool {
    let claim = reading.claim;
    let along = |p: &PairAccount| slack_sentence(p).is_none();
    reading.standing == Standing::Holds
        && is_expected(claim)
        && claim.conditions.separation.is_none()
        && claim.variants.as_ref().is_none_or(|v| v.erratum.is_none())
        && super::drawn::table(claim).is_none()
        && claim.results.iter().all(along)
}

/// Whether all is as the file expects, and is about motions or all values.
fn is_expected(claim: &ClaimAccount) -> bool {
    claim.region.is_none()
        && claim.families.is_empty()
        && !claim.is_unexpected_alone()
        && !claim.results.iter().any(PairAccount::is_unexpected)
}

/// Whether a few words tell how it fares: it is plain, or there to compare with.
fn is_short(reading: &Reading<'_>) -> bool {
    let compared = reading.role == ClaimRole::Added && reading.standing != Standing::Open;
    is_plain(reading) || compared && is_expected(reading.claim)
}

/// Where the paper says it, and its label there, in brackets.
fn told_place(derivation: &Derivation, whole: &Whole<'_>) -> String {
    let label = whole.readings.iter().find_map(|r| declared(derivation, r.claim)?.label.as_deref());
    // A place that names the label says enough.
    let label = label.filter(|l| !whole.place.is_some_and(|p| p.contains(l)));
    let parts: Vec<String> = whole.place.into_iter().chain(label).map(prose).collect();
    if parts.is_empty() { String::new() } else { format!(" ({})", parts.join(", ")) }
}

/// What the word behind a name is: nothing for what the paper says.
fn role_of(reading: &Reading<'_>) -> String {
    if reading.role == ClaimRole::Says { String::new() } else { format!(" ({})", reading.role.word()) }
}

/// A row for a claim; with readings, one for each below it.
fn rows(derivation: &Derivation, whole: &Whole<'_>) -> Vec<Vec<String>> {
    let target = |id: &str| format!("<a id=\"{}\"></a>", anchor(id));
    let mut out = Vec::new();
    let place = told_place(derivation, whole);
    if whole.is_read() {
        let head = format!("{}**{}**", target(whole.id), whole.id);
        out.push(vec![head, format!("{}{place}", prose(&whole.says)), String::new(), String::new()]);
    }
    for reading in &whole.readings {
        let claim = reading.claim;
        let shown = claim.reading.as_ref().map_or_else(|| format!("**{}**", whole.id), |r| format!("/{r}"));
        let place = if whole.is_read() { "" } else { &place };
        out.push(vec![
            format!("{}{shown}{}", target(&name(claim)), role_of(reading)),
            format!("{}{place}", prose(&claim.says)),
            said_in_a_row(derivation, reading),
            format!("{} {}", reading.shape().sign(), fares(derivation, reading)),
        ]);
    }
    out
}

/// How it fares, and how that is known, in a few words.
fn fares(derivation: &Derivation, reading: &Reading<'_>) -> String {
    let (claim, identity) = (reading.claim, reading.claim.identity.as_ref());
    let mut out = match reading.standing {
        Standing::Holds => prose(&reading.basis().words()),
        _ => {
            let condition = digest::condition_of(claim).map(|c| format!("; {}", prose(&c))).unwrap_or_default();
            format!("{}{condition}", uncapital(&digest::verdict(reading)))
        }
    };
    let holds = reading.standing == Standing::Holds;
    out.push_str(match (&reading.proof, identity) {
        (ProofStanding::None, Some(identity)) if holds && identity.verdict() == "refuted" => "; not for all values",
        (ProofStanding::None | ProofStanding::Circular, _) | (_, None) => "",
        // That the checker made the steps again is told on page one.
        (_, Some(identity)) => match identity.recorded.as_ref().map(|r| r.grounds()) {
            Some(Grounds::Prover) => "; prover alone",
            Some(Grounds::CheckerBut(_)) => "; some cases by the prover alone",
            Some(Grounds::Checker) | None => "",
        },
    });
    if let Some(asked) = declared(derivation, claim).map(|d| d.precision).filter(|p| *p != DEFAULT_PRECISION) {
        out.push_str(&format!("; to {}", size(asked)));
    }
    let left_out = claim.results.iter().filter(|p| !p.verdict.evidence().excluded.is_empty()).count();
    if holds && left_out > 0 {
        out.push_str(&format!("; on {} some times are left out", count(left_out, "motion")));
    }
    out + if super::certificates::file_name(claim).is_some() { " †" } else { "" }
}

/// What is said of a claim of which there is something to say.
fn whole_section(derivation: &Derivation, graph: &DerivationGraph, whole: &Whole<'_>, of: usize) -> String {
    let place = told_place(derivation, whole);
    let mut out = format!("<a id=\"{}\"></a>\n\n", anchor(whole.id));
    out.push_str(&format!("#### {}: {}{place}\n\n", whole.id, prose(&whole.says)));
    let mut remark = None;
    for reading in &whole.readings {
        out.push_str(&reading_section(derivation, graph, reading, of));
        // A remark on the whole claim is every reading's, and is told once.
        let said = reading.claim.remark.as_ref();
        let shown = whole.fate.is_against() && reading.role != ClaimRole::Added && said != remark;
        if let Some(text) = said.filter(|_| shown) {
            out.push_str(&format!("Remark of the file: *{}*\n\n", prose(text).trim()));
        }
        remark = said;
    }
    out
}

fn reading_section(derivation: &Derivation, graph: &DerivationGraph, reading: &Reading<'_>, of: usize) -> String {
    let claim = reading.claim;
    let role = role_of(reading);
    let mut out = String::new();
    let head = match &claim.reading {
        Some(id) => {
            out.push_str(&format!("<a id=\"{}\"></a>\n\n", anchor(&name(claim))));
            format!("**/{id}**{role}: {} ", prose(&claim.says))
        }
        None if role.is_empty() => String::new(),
        None => format!("{} ", role.trim_start()),
    };
    out.push_str(format!("{} {head}{}", reading.shape().sign(), said(derivation, claim, false)).trim_end());
    if is_short(reading) {
        out.push_str(&format!(" — {}.\n\n", fares(derivation, reading)));
        return out;
    }
    out.push_str("\n\n");
    let asked = declared(derivation, claim).map(|d| d.precision).filter(|p| *p != DEFAULT_PRECISION);
    out.push_str(&asked.map(|p| format!("Precision asked for: {}.\n\n", size(p))).unwrap_or_default());
    if claim.verdict_alone().is_some() {
        out.push_str(&format!("**{}.**\n\n", digest::verdict(reading)));
    }
    out.push_str(&for_all_values(graph, reading));
    out.push_str(&super::region::section(claim));
    out.push_str(&super::conditions::separation(&claim.conditions));
    let mut groups = groups(claim);
    groups.sort_by_key(|g| ["fails", "holds", "undecided"].iter().position(|w| *w == g.word).unwrap_or(3));
    // What does not apply, as it should not, is seen in the matrix.
    let told = groups.iter().filter(|g| g.unexpected || g.word != "not-applicable" || groups.len() == 1);
    let lines: Vec<String> = told.map(|g| group_line(derivation, claim, g, of)).collect();
    if !lines.is_empty() {
        out.push_str(&format!("{}\n\n", lines.join(" ")));
    }
    out.push_str(&on_families(claim));
    if super::drawn::table(claim).is_some() {
        let told = super::drawn::plain(derivation, claim).unwrap_or_default();
        out.push_str(&format!("**On other motions:** {}\n\n", prose(&told)));
    }
    if let Some(erratum) = claim.variants.as_ref().and_then(|v| v.erratum.as_ref()) {
        out.push_str(&discrimination::corrections_markdown(erratum));
    }
    out
}

/// What is known for all values; nothing where a motion says the same.
fn for_all_values(graph: &DerivationGraph, reading: &Reading<'_>) -> String {
    let claim = reading.claim;
    let Some(identity) = &claim.identity else { return String::new() };
    let on_motion = claim.results.iter().any(|p| p.verdict.outcome().word() == "fails");
    if on_motion && reading.proof == ProofStanding::None {
        return String::new();
    }
    let certificate = super::certificates::file_name(claim).map_or("", |_| " †");
    let recorded = identity.recorded.as_ref().map(|r| match (r.grounds(), r.steps().unwrap_or(0)) {
        (Grounds::Checker, steps) => format!(" Replayed: {}.", count(steps, "step")),
        (Grounds::CheckerBut(n), steps) => {
            format!(" Replayed: {}, but for {}.", count(steps, "step"), count(n, "case"))
        }
        (Grounds::Prover, _) => " Prover alone.".to_owned(),
    });
    // Why others are not is in the page.
    let sentence = super::graph::brief(identity, &graph.proof_of(claim)) + &recorded.unwrap_or_default();
    format!("**For all values:** {}{certificate}\n\n", prose(&sentence))
}

/// What the words behind the names of claims mean, of those that occur.
fn roles_told(derivation: &Derivation) -> String {
    let told = |role: &ClaimRole| Some(format!("({}) {}", role.word(), whose(*role)?));
    let roles = ClaimRole::ALL.into_iter().filter(|r| derivation.claims.iter().any(|c| c.role == *r));
    let told: Vec<String> = roles.filter_map(|r| told(&r)).collect();
    if told.is_empty() { String::new() } else { format!("{}\n\n", told.join(" ")) }
}

/// The formulas, and what is assumed.
fn said(derivation: &Derivation, claim: &ClaimAccount, row: bool) -> String {
    let mut out = formulas(derivation, claim, row);
    let all: Vec<String> = claim.assumptions.iter().map(|a| math(a)).collect();
    if !all.is_empty() {
        // After a formula on lines of its own a new paragraph begins.
        let word = if out.is_empty() || out.ends_with('\n') { "Assuming" } else { ", assuming" };
        out.truncate(out.trim_end_matches(' ').len());
        out.push_str(&format!("{word} {}", all.join(", ")));
    }
    out.trim_end().to_owned()
}

/// The same in a row of a table. Long formulas that the paper does not say are on the page.
fn said_in_a_row(derivation: &Derivation, reading: &Reading<'_>) -> String {
    let text = said(derivation, reading.claim, true);
    if reading.role == ClaimRole::Added && text.len() > MOST_ADDED { "on the page".to_owned() } else { text }
}

/// The formulas, each kind with its words, of which what holds at every time needs none; in a row of a table all in one line.
fn formulas(derivation: &Derivation, claim: &ClaimAccount, row: bool) -> String {
    let mut out = String::new();
    let declared = declared(derivation, claim);
    let (mut last, mut is_open) = (None, false);
    for (i, formula) in claim.formulas.iter().enumerate() {
        let (kind, said) = heading(claim, declared, i);
        let words = match said {
            Heading::Words(words) if words == FormKind::Always.heading() => String::new(),
            Heading::Words(words) => prose(&format!("{words}:")),
            Heading::System => {
                out.push_str(&format!("The motion solves the system `{formula}`. "));
                continue;
            }
            Heading::Trajectory => {
                out.push_str(&format!("The motion is that of `{formula}`. "));
                continue;
            }
        };
        let kind = Some(kind);
        // Short formulas of a kind stand in one line.
        let short = row || formula.len() <= SHORT && !formula.contains('\n');
        if kind == last && is_open && short {
            out.truncate(out.trim_end().len());
            out.push_str(", ");
        } else if kind != last {
            out.push_str(&words);
            out.push_str(if short && !words.is_empty() { " " } else { "" });
        }
        out.push_str(&if short { format!("{} ", math(formula)) } else { format!("\n\n{}", display(formula)) });
        (last, is_open) = (kind, short);
    }
    out
}

/// Longest formulas of a claim that is there for comparison, in bytes.
const MOST_ADDED: usize = 200;

/// Longest formula that stands in a line with others, in bytes of LaTeX.
const SHORT: usize = 90;

/// Most trajectories that are named beside a verdict that is as expected; the matrix shows the others.
const NAMED: usize = 3;

/// The pairs of a claim with the same verdict, in one line: where, the largest residual, and a witness or a reason.
fn group_line(derivation: &Derivation, claim: &ClaimAccount, group: &Group<'_>, of: usize) -> String {
    let names: Vec<String> = group.pairs.iter().map(|p| format!("`{}`", p.trajectory)).collect();
    let verdict = match group.word {
        "holds" => "Holds",
        "fails" => "Fails",
        "undecided" => "Undecided",
        _ => "Does not apply",
    };
    let on = if group.pairs.len() == claim.results.len() && names.len() > NAMED {
        let all = count(names.len(), "motion");
        if names.len() < of { format!("on all {all} on which it is tried") } else { format!("on all {all}") }
    } else if names.len() > NAMED && !group.unexpected {
        // The matrix names them.
        format!("on {}", names.len())
    } else {
        format!("on {}", names.join(", "))
    };
    let expected = match (group.unexpected, group.expected) {
        (true, Some(word)) => format!(" — **expected: {word}**"),
        (true, None) => " — **not expected**".to_owned(),
        (false, _) => String::new(),
    };
    let mut out = format!("**{verdict}** {on}{expected}");
    let Some(pair) = group.telling() else { return out + "." };
    let word = group.word;
    let told = match word {
        "fails" => witness(derivation, claim, pair),
        "not-applicable" if !group.unexpected => String::new(),
        word => told(pair, word == "holds"),
    };
    let strength = pair.verdict.outcome().strength().filter(|s| word == "holds" && *s != "sampled");
    out.push_str(&strength.map(|s| format!(" ({s})")).unwrap_or_default());
    format!("{out}.{told}")
}

/// The pair that tells most of those that do not fail.
fn told(pair: &PairAccount, holds: bool) -> String {
    let evidence = pair.verdict.evidence();
    let mut out = String::new();
    // Of what is known at every time the samples tell nothing more: the page and `report.json` have them.
    let sampled = pair.verdict.outcome().strength() == Some("sampled");
    if let Some(r) = evidence.residual.as_ref().filter(|_| holds && sampled) {
        out.push_str(&format!(" Largest residual {}, bound {} (sampled).", size(r.max), size(r.bound)));
    }
    if let Some(slack) = slack_sentence(pair) {
        out.push_str(&format!(" {slack}."));
    }
    if let Some(reason) = evidence.reason.as_ref().filter(|_| !holds) {
        out.push_str(&format!(" On `{}`: {}.", pair.trajectory, prose(&reason.to_string())));
    }
    if let Some(e) = evidence.excluded.first() {
        let (from, to, reason) = (time(e.from), time(e.to), prose(&e.reason.to_string()));
        out.push_str(&format!(" Left out on `{}`: {from} … {to}, {reason}", pair.trajectory));
        out.push_str(if evidence.excluded.len() > 1 { ", and more." } else { "." });
    }
    out
}

/// A refuting point: both sides in a line, and what they depend on.
fn witness(derivation: &Derivation, claim: &ClaimAccount, pair: &PairAccount) -> String {
    let Some(w) = &pair.verdict.evidence().witness else { return String::new() };
    // The only formula of a claim stands above.
    let of = label(&w.formula);
    let alone = matches!(claim.formulas.as_slice(), [one] if one == of.formula);
    let formula = if alone { String::new() } else { format!(", for {}{}{}", of.before, math(of.formula), of.after) };
    let component = of.component.map(|c| format!(" (component {})", math(c))).unwrap_or_default();
    let kind = super::card::kind_at(derivation, claim, Some(w));
    let said = refuting::bare_values(claim, kind, w, &|text| format!("**{text}**"));
    let mut out = format!(" On `{}` at t = {}{formula}{component}: {said}.", pair.trajectory, six(w.t));
    // Values that would fill a page are in `report.json`, to be recomputed.
    if (1..=FEW).contains(&w.values.len()) {
        let values: Vec<String> = w.values.iter().map(|(n, v)| format!("{} = {}", math(n), six(*v))).collect();
        out.push_str(&format!(" There {}.", values.join(", ")));
    }
    out
}

/// So many values of a witness are written out.
const FEW: usize = 3;

/// What was found on families of motions, and the member to look at first; its lines for a file, and the others, are in the page.
fn on_families(claim: &ClaimAccount) -> String {
    let mut out = String::new();
    for family in &claim.families {
        let expected = match family::expected(family) {
            text if text.is_empty() => text,
            text => format!(" — **{}**", text.trim_start_matches(", ")),
        };
        out.push_str(&format!("**{}** `{}`{expected}. ", family::heading(family), family.family));
        out.push_str(&prose(&family::sentence(&family::counts(family))));
        for text in family::remarks(family) {
            out.push_str(&format!(" {}", prose(&family::sentence(&text))));
        }
        if let Some(of) = family::shown(family).first() {
            let seen = of.seen.as_ref().map(|text| format!(": {}", prose(text))).unwrap_or_default();
            out.push_str(&format!(" {}{seen}.", prose(&of.named())));
        }
        out.push_str("\n\n");
    }
    out
}
