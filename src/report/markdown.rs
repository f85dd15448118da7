//! `report.md`: the report for people, as a forge renders it.

use super::family;
use super::graph::DerivationGraph;
use super::letters::{LEGEND, letters};
use super::markup::{display, fenced, math, prose, table};
use super::numbers::{count, six, size, time};
use crate::derivation::{ClaimRole, DEFAULT_PRECISION, Derivation};
use findings::{Account, Measurement};
use std::collections::HashSet;

/// The report.
pub fn markdown(derivation: &Derivation, account: &Account) -> String {
    let mut out = format!("# {}\n\n", prose(&derivation.title));
    out.push_str(&format!("What is checked: {}\n\n", prose(&derivation.concerns)));
    if let Some(source) = &derivation.source {
        out.push_str(&format!("{}\n\n", prose(source)));
    }
    out.push_str("Pictures, curves and every pair: `index.html`. All numbers: `report.json`.\n\n");
    out.push_str(&super::overview::section(derivation, account));
    let graph = DerivationGraph::new(derivation, account);
    out.push_str(&super::claim_rows::section(derivation, account, &graph));
    out.push_str(&matrix(account));
    out.push_str(&graph.section());
    out.push_str(&conventions(derivation));
    out.push_str(&symbols(derivation));
    out.push_str(&systems(derivation));
    out.push_str(&trajectories(account));
    out.push_str(&measures(derivation, account));
    out.push_str(&super::units::section(&account.units));
    out.push_str(&repeat(derivation));
    without_idle_anchors(&out)
}

/// The text without the anchors to which no link leads.
fn without_idle_anchors(text: &str) -> String {
    const OPEN: &str = "<a id=\"";
    const CLOSE: &str = "\"></a>";
    let linked: HashSet<&str> =
        text.split("](#").skip(1).filter_map(|link| link.split_once(')')).map(|(name, _)| name).collect();
    let mut parts = text.split(OPEN);
    let mut out = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        match part.split_once(CLOSE) {
            Some((name, rest)) if !linked.contains(name) => out.push_str(rest.trim_start_matches('\n')),
            _ => out.extend([OPEN, part]),
        }
    }
    out
}

/// A link target: the name of a claim as a forge makes an anchor of it is not the same everywhere, so it is given.
pub(super) fn anchor(name: &str) -> String {
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
        "## Claims and motions\n\n{LEGEND} Columns are the [motions](#motions) by number.\n\n{}",
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
    let mut out = String::from("## Motions\n\n");
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
    let summary = count(account.trajectories.len(), "motion");
    out.push_str(&folded(&summary, &table(&head, rows)));
    out.push_str("Parameters and initial values are in the derivation file and in `report.json`.\n\n");
    for t in &account.trajectories {
        if let Some(problem) = &t.problem {
            out.push_str(&format!("`{}`: {}\n\n", t.id, prose(problem)));
        }
    }
    out
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
        format!("{} ± {} (`{}`, t = {})", six(v), size(b), m.trajectory, six(t))
    };
    let on = count(found.iter().filter(|m| !m.values.is_empty()).count(), "motion");
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
         the motion and from rounding. A bound that is larger than the precision asked for leaves the claim undecided.\n",
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
