//! `report.md`: the report for people, as a forge renders it.

use super::form::{Heading, heading};
use super::graph::DerivationGraph;
use super::letters::{LEGEND, letters};
use super::markup::display;
pub(super) use super::markup::{code, fenced, math, prose, table};
use super::numbers::{both, count, six, size, time};
use super::tally::{Group, declared, groups, name};
use super::wording::slack_sentence;
use super::{discrimination, family};
use crate::derivation::{ClaimRole, DEFAULT_PRECISION, Derivation};
use findings::{Account, ClaimAccount, Grounds, Measurement, PairAccount, Recorded};

/// The report.
pub fn markdown(derivation: &Derivation, account: &Account) -> String {
    let mut out = format!("# {}\n\n", prose(&derivation.title));
    out.push_str(&format!("What is checked: {}\n\n", prose(&derivation.concerns)));
    if let Some(source) = &derivation.source {
        out.push_str(&format!("{}\n\n", prose(source)));
    }
    out.push_str("Pictures, curves and every pair: `index.html`. All numbers: `report.json`.\n\n");
    out.push_str(&super::overview::section(derivation, account));
    out.push_str(&matrix(account));
    let graph = DerivationGraph::new(derivation, account);
    out.push_str(&graph.section());
    out.push_str(&conventions(derivation));
    out.push_str(&symbols(derivation));
    out.push_str(&systems(derivation));
    out.push_str(&trajectories(account));
    out.push_str(&claims(derivation, account, &graph));
    out.push_str(&measures(derivation, account));
    out.push_str(&super::units::section(&account.units));
    out.push_str(&repeat(derivation));
    without_idle_anchors(&out)
}

/// The text without the anchors to which no link leads.
fn without_idle_anchors(text: &str) -> String {
    const OPEN: &str = "<a id=\"";
    const CLOSE: &str = "\"></a>\n\n";
    let mut parts = text.split(OPEN);
    let mut out = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        match part.split_once(CLOSE) {
            Some((name, rest)) if !text.contains(&format!("](#{name})")) => out.push_str(rest),
            _ => out.extend([OPEN, part]),
        }
    }
    out
}

/// A link target: the name of a claim as a forge makes an anchor of it is not the same everywhere, so it is given.
fn anchor(name: &str) -> String {
    format!("claim-{}", name.replace('/', "--"))
}

/// A link to the section on a claim.
pub(super) fn link_to(name: &str) -> String {
    format!("[{name}](#{})", anchor(name))
}

/// Something that is unfolded on request.
fn folded(summary: &str, body: &str) -> String {
    if body.is_empty() {
        String::new()
    } else {
        format!("<details><summary>{summary}</summary>\n\n{body}</details>\n\n")
    }
}

/// One letter for each pair: the whole matrix in a few kilobytes.
fn matrix(account: &Account) -> String {
    let Some(body) = letters(account) else { return String::new() };
    format!(
        "## Claims and trajectories\n\n{LEGEND} Columns are the [trajectories](#trajectories) by number.\n\n{}",
        fenced("text", body.trim_end())
    )
}

fn conventions(derivation: &Derivation) -> String {
    if derivation.conventions.is_empty() {
        return String::new();
    }
    let rows = derivation.conventions.iter().map(|(k, v)| vec![prose(k), prose(v)]);
    format!("## Conventions\n\n{}", table(&["convention", "as used here"], rows))
}

fn symbols(derivation: &Derivation) -> String {
    let rows = derivation.symbols.iter().map(|s| {
        let shape = derivation.graph.shape(s.symbol);
        let shape =
            if derivation.graph.is_diagonal(s.symbol) { format!("diagonal {shape}") } else { shape.to_string() };
        let mut notes: Vec<String> = s.says.iter().map(|t| prose(t)).collect();
        notes.extend(s.positive.then(|| "positive".to_owned()));
        notes.extend(s.angle.then(|| "angle, continued without jumps".to_owned()));
        let formula = s.formula.as_deref().map(math).unwrap_or_default();
        let unit = s.unit.as_deref().map(prose).unwrap_or_default();
        vec![math(&s.name), s.role_word().to_owned(), shape, unit, formula, notes.join("; ")]
    });
    let number = count(derivation.symbols.len(), "symbol");
    let table = table(&["symbol", "role", "shape", "unit", "definition", "notes"], rows);
    format!("## Symbols\n\n{}", folded(&number, &table))
}

fn systems(derivation: &Derivation) -> String {
    let mut out = String::new();
    for system in &derivation.systems {
        let says = system.says.as_ref().map(|s| format!(": {}", prose(s))).unwrap_or_default();
        out.push_str(&format!("**{}**{says}\n\n", system.id));
        for equation in &system.equations {
            out.push_str(&display(&equation.text));
        }
    }
    if out.is_empty() { out } else { format!("## Systems\n\n{out}") }
}

fn trajectories(account: &Account) -> String {
    let mut out = String::from("## Trajectories\n\n");
    let rows = account.trajectories.iter().enumerate().map(|(i, t)| {
        let steps = if t.steps > 0 { t.steps.to_string() } else { String::new() };
        vec![
            (i + 1).to_string(),
            format!("`{}`", t.id),
            if t.title == t.id { String::new() } else { prose(&t.title) },
            format!("{} … {}", time(t.span.0), time(t.span.1)),
            t.source.to_owned(),
            steps,
            size(t.error),
        ]
    });
    let head = ["no.", "id", "title", "t", "source", "steps", "error at most"];
    let summary = count(account.trajectories.len(), "trajectory");
    out.push_str(&folded(&summary, &table(&head, rows)));
    out.push_str("Parameters and initial values are in the derivation file and in `report.json`.\n\n");
    for t in &account.trajectories {
        if let Some(problem) = &t.problem {
            out.push_str(&format!("`{}`: {}\n\n", t.id, prose(problem)));
        }
    }
    out
}

fn claims(derivation: &Derivation, account: &Account, graph: &DerivationGraph) -> String {
    let mut out = format!("## Claims\n\n{}", roles_told(derivation));
    let mut last = "";
    for claim in &account.claims {
        let declared = declared(derivation, claim);
        let parent = declared.and_then(|d| d.parent_says.as_ref());
        let place = claim.place.as_ref().map(|p| format!("Place: {}.", prose(p)));
        // The place is that of all readings, and stands where the claim is named first.
        let first = last != claim.id;
        if let Some(parent) = parent.filter(|_| first) {
            out.push_str(&format!("<a id=\"{}\"></a>\n\n### {}: {}\n\n", anchor(&claim.id), claim.id, prose(parent)));
            out.push_str(&place.as_ref().map(|p| format!("{p}\n\n")).unwrap_or_default());
        }
        last = &claim.id;
        let level = if claim.reading.is_some() { "####" } else { "###" };
        out.push_str(&format!("<a id=\"{}\"></a>\n\n", anchor(&name(claim))));
        let role = declared.map(|d| d.role).filter(|r| *r != ClaimRole::Says);
        let role = role.map(|r| format!(" ({})", r.word())).unwrap_or_default();
        out.push_str(&format!("{level} {}{role}: {}\n\n", name(claim), prose(&claim.says)));
        let mut notes: Vec<String> = place.filter(|_| first && parent.is_none()).into_iter().collect();
        // A place that names the label says enough.
        let is_told = |label: &str| claim.place.as_ref().is_some_and(|p| p.contains(label));
        if let Some(label) = declared.and_then(|d| d.label.as_ref()).filter(|l| !is_told(l)) {
            notes.push(format!("Label: {}.", prose(label)));
        }
        // What is said of all values names what it follows from.
        let from = declared.map(|d| &d.follows_from).filter(|f| !f.is_empty() && claim.identity.is_none());
        if let Some(from) = from {
            notes.push(format!("Follows from: {}.", from.iter().map(|f| prose(f)).collect::<Vec<_>>().join(", ")));
        }
        if let Some(precision) = declared.map(|d| d.precision).filter(|p| *p != DEFAULT_PRECISION) {
            notes.push(format!("Precision asked for: {}.", size(precision)));
        }
        if !notes.is_empty() {
            out.push_str(&format!("{}\n\n", notes.join(" ")));
        }
        out.push_str(&formulas(derivation, claim));
        if !claim.assumptions.is_empty() {
            let all: Vec<String> = claim.assumptions.iter().map(|a| math(a)).collect();
            out.push_str(&format!("Assuming {}.\n\n", all.join(", ")));
        }
        if let Some(identity) = &claim.identity {
            let certificate = super::certificates::file_name(claim).map(|f| format!(" [Certificate]({f})."));
            // Why others are not is in the page.
            let recorded = identity.recorded.as_ref().map(steps_told).unwrap_or_default();
            let sentence = prose(&(super::graph::brief(identity, &graph.proof_of(claim)) + &recorded));
            out.push_str(&format!("**For all values:** {sentence}{}\n\n", certificate.unwrap_or_default()));
        }
        out.push_str(&super::region::section(claim));
        out.push_str(&super::conditions::separation(&claim.conditions));
        let mut groups = groups(claim);
        groups.sort_by_key(|g| ["fails", "holds", "undecided"].iter().position(|w| *w == g.word).unwrap_or(3));
        for group in groups {
            out.push_str(&group_section(claim, &group, account.trajectories.len()));
        }
        out.push_str(&on_families(claim));
        if let Some(erratum) = claim.variants.as_ref().and_then(|v| v.erratum.as_ref()) {
            out.push_str(&discrimination::corrections_markdown(erratum));
        }
    }
    out
}

/// What a proof rests on, in few words: `explain` says it in a sentence.
fn steps_told(recorded: &Recorded) -> String {
    let steps = recorded.steps().unwrap_or(0);
    match recorded.grounds() {
        Grounds::Checker => format!(" Replayed: {}.", count(steps, "step")),
        Grounds::CheckerBut(n) => format!(" Replayed: {}, but for {}.", count(steps, "step"), count(n, "case")),
        Grounds::Prover => " Prover alone.".to_owned(),
    }
}

/// What the words behind the names of claims mean, of those that occur.
fn roles_told(derivation: &Derivation) -> String {
    let told = |role: &ClaimRole| Some(format!("({}) {}", role.word(), whose(*role)?));
    let roles = ClaimRole::ALL.into_iter().filter(|r| derivation.claims.iter().any(|c| c.role == *r));
    let told: Vec<String> = roles.filter_map(|r| told(&r)).collect();
    if told.is_empty() { String::new() } else { format!("{}\n\n", told.join(" ")) }
}

/// What a claim is to the paper, where the paper does not simply say it.
pub(super) fn whose(role: ClaimRole) -> Option<&'static str> {
    match role {
        ClaimRole::Says => None,
        ClaimRole::MayMean => Some("One of several things that the sentence may mean."),
        ClaimRole::Needs => Some("The paper needs it; it is more, or other, than it says."),
        ClaimRole::Against => Some("Against the sentence: the contrary of what the paper says."),
        ClaimRole::Added => Some("For comparison: the paper does not say it."),
        ClaimRole::Lemma => Some("A lemma of the file, which proofs use: the paper does not print it."),
        ClaimRole::Choice => Some("A choice of the paper: neither true nor false."),
    }
}

fn formulas(derivation: &Derivation, claim: &ClaimAccount) -> String {
    let mut out = String::new();
    let declared = declared(derivation, claim);
    let (mut last, mut is_open) = (None, false);
    for (i, formula) in claim.formulas.iter().enumerate() {
        let (kind, said) = heading(claim, declared, i);
        let words = match said {
            Heading::Words(words) => prose(&format!("{words}:")),
            Heading::System => {
                out.push_str(&format!("The motion solves the system `{formula}`.\n\n"));
                continue;
            }
            Heading::Trajectory => {
                out.push_str(&format!("The motion is that of the trajectory `{formula}`.\n\n"));
                continue;
            }
        };
        let kind = Some(kind);
        // Short formulas of a kind stand in one line.
        let short = formula.len() <= SHORT && !formula.contains('\n');
        match (kind == last, short && is_open) {
            (true, true) => out.truncate(out.trim_end().len()),
            (true, false) => {}
            (false, _) => out.push_str(&format!("{words}{}", if short { "" } else { "\n\n" })),
        }
        let between = match (kind == last, is_open) {
            (true, true) => ", ",
            (true, false) => "",
            (false, _) => " ",
        };
        out.push_str(&if short { format!("{between}{}\n\n", math(formula)) } else { display(formula) });
        (last, is_open) = (kind, short);
    }
    out
}

/// Longest formula that stands in a line with others, in bytes of LaTeX.
const SHORT: usize = 60;

/// Most trajectories that are named beside a verdict that is as expected; the matrix shows the others.
const NAMED: usize = 3;

/// The pairs of a claim with the same verdict, in one line: where, the largest residual, and a witness or a reason.
fn group_section(claim: &ClaimAccount, group: &Group<'_>, of: usize) -> String {
    let names: Vec<String> = group.pairs.iter().map(|p| format!("`{}`", p.trajectory)).collect();
    let verdict = match group.word {
        "holds" => "Holds",
        "fails" => "Fails",
        "undecided" => "Undecided",
        _ => "Does not apply",
    };
    let on = if group.pairs.len() == claim.results.len() && names.len() > NAMED {
        let all = count(names.len(), "trajectory");
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
    let mut out = format!("**{verdict}** {on}{expected}.");
    if let Some(pair) = group.telling() {
        out.push_str(&match group.word {
            "fails" => witness(claim, pair),
            "not-applicable" if !group.unexpected => String::new(),
            word => told(pair, word == "holds"),
        });
    }
    out.push_str("\n\n");
    out
}

/// The pair that tells most of those that do not fail.
fn told(pair: &PairAccount, holds: bool) -> String {
    let evidence = pair.verdict.evidence();
    let mut out = String::new();
    if let Some(r) = evidence.residual.as_ref().filter(|_| holds) {
        let strength = pair.verdict.outcome().strength().unwrap_or_default();
        // Of what is known at every time the samples tell nothing more: the page and `report.json` have them.
        out.push_str(&match strength {
            "sampled" => format!(" Largest residual {}, bound {} (sampled).", size(r.max), size(r.bound)),
            word => format!(" ({word})."),
        });
    }
    if let Some(slack) = slack_sentence(pair) {
        out.push_str(&format!(" {slack}."));
    }
    if let Some(reason) = evidence.reason.as_ref().filter(|_| !holds) {
        out.push_str(&format!(" On `{}`: {}.", pair.trajectory, prose(&reason.to_string())));
    }
    if let Some(e) = evidence.excluded.first() {
        out.push_str(&format!(
            " Left out on `{}`: {} … {}, {}",
            pair.trajectory,
            time(e.from),
            time(e.to),
            prose(&e.reason.to_string())
        ));
        out.push_str(if evidence.excluded.len() > 1 { ", and more." } else { "." });
    }
    out
}

/// A refuting point: both sides in a line, and what they depend on.
fn witness(claim: &ClaimAccount, pair: &PairAccount) -> String {
    let Some(w) = &pair.verdict.evidence().witness else { return String::new() };
    // The only formula of a claim stands above.
    let alone = matches!(claim.formulas.as_slice(), [one] if *one == w.formula);
    let formula = if alone { String::new() } else { format!(", for {}", math(&w.formula)) };
    let (left, right) = both(w.left, w.right);
    let mut out = format!(
        " On `{}` at t = {}{formula}: left side **{left}**, right side **{right}**, error bound {}.",
        pair.trajectory,
        six(w.t),
        size(w.bound)
    );
    // Values that would fill a page are in `report.json`, to be recomputed.
    if (1..=FEW).contains(&w.values.len()) {
        let values: Vec<String> = w.values.iter().map(|(n, v)| format!("{} = {}", math(n), six(*v))).collect();
        out.push_str(&format!(" There {}.", values.join(", ")));
    }
    out
}

/// So many values of a witness are written out.
const FEW: usize = 3;

fn measures(derivation: &Derivation, account: &Account) -> String {
    let mut out = String::new();
    for measure in &derivation.measures {
        out.push_str(&format!("**{}**: {}, {}", measure.id, prose(&measure.says), math(&measure.formula.text)));
        match (&measure.at, &measure.since) {
            (Some(_), Some(_)) => out.push_str(&format!(": {}", prose(&family::taken(measure)))),
            (Some(at), None) => out.push_str(&format!(" where {}{}", math(&at.equation.text), at.occasion.words())),
            (None, _) => {}
        }
        out.push_str(&measure.unit.as_ref().map(|u| format!(", in {}", prose(u))).unwrap_or_default());
        out.push_str(".\n\n");
        out.push_str(&range(account, &measure.id));
        for of in account.distributions.iter().filter(|of| of.measure == measure.id) {
            out.push_str(&format!("On the family `{}`: {}.\n\n", of.family, prose(&family::distribution(of))));
        }
    }
    if out.is_empty() { out } else { format!("## Measured\n\n{out}") }
}

/// The least and the largest value of a measure, and on how many trajectories it has one; all of them are in `report.json`.
fn range(account: &Account, measure: &str) -> String {
    let found: Vec<&Measurement> = account.measurements.iter().filter(|m| m.measure == measure).collect();
    let each = || found.iter().flat_map(|m| m.values.iter().map(move |(t, v, b)| (m, *t, *v, *b)));
    let told = |(m, t, v, b): (&&Measurement, f64, f64, f64)| {
        format!("{} ± {} (`{}`, t = {})", time(v), size(b), m.trajectory, time(t))
    };
    let on = count(found.iter().filter(|m| !m.values.is_empty()).count(), "trajectory");
    let without = found.iter().filter(|m| m.values.is_empty()).count();
    let without = if without > 0 { format!(" No value on {without}.") } else { String::new() };
    let (least, most) = (each().min_by(|a, b| a.2.total_cmp(&b.2)), each().max_by(|a, b| a.2.total_cmp(&b.2)));
    match (least, most) {
        (Some(a), Some(b)) if a.2 == b.2 => format!("On {on}: {}.{without}\n\n", told(a)),
        (Some(a), Some(b)) => format!("On {on}, from {} to {}.{without}\n\n", told(a), told(b)),
        _ => format!("{}\n\n", without.trim()),
    }
}

/// What is needed to repeat the report.
fn repeat(derivation: &Derivation) -> String {
    let path = super::front::project_path(&derivation.file.path);
    format!(
        "## How to repeat this\n\n\
         - {} {}\n\
         - derivation file `{path}`, SHA-256 `{}`\n\
         - command `rederive check {path}`\n\
         - precision asked for, unless a claim says otherwise: {}\n\n\
         A residual, left side minus right side, is compared with its own error bound, which is propagated from the error of \
         the trajectory and from rounding. A bound that is larger than the precision asked for leaves the claim undecided.\n",
        crate::PROGRAM,
        env!("CARGO_PKG_VERSION"),
        derivation.sha256,
        size(DEFAULT_PRECISION),
    )
}

#[cfg(all(test, debug_assertions))]
mod tests {
    use super::super::tests::derivation;
    use super::*;
    use findings::sample;

    #[test]
    fn the_report_of_a_small_account() {
        insta::assert_snapshot!(markdown(&derivation(), &sample::account()));
    }

    #[test]
    fn anchors_stay_where_a_link_leads() {
        let text = "[a](#claim-a)\n\n<a id=\"claim-a\"></a>\n\n### a\n\n<a id=\"claim-a--b\"></a>\n\n### b\n";
        let rest = "[a](#claim-a)\n\n<a id=\"claim-a\"></a>\n\n### a\n\n### b\n";
        assert_eq!(without_idle_anchors(text), rest);
        assert_eq!(without_idle_anchors("<a id=\"x\">"), "<a id=\"x\">");
    }
}

/// What was found on families of motions.
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
        out.push_str("\n\n");
        let mut folded = String::new();
        for of in family::shown(family) {
            let seen = of.seen.as_ref().map(|text| format!(": {}", prose(text))).unwrap_or_default();
            folded.push_str(&format!("{}{seen}.\n\n", prose(&of.named())));
            folded.push_str(&fenced("toml", of.member.toml.trim_end()));
        }
        if !folded.is_empty() {
            out.push_str(&format!("<details><summary>Members to look at</summary>\n\n{folded}</details>\n\n"));
        }
    }
    out
}
