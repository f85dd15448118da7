//! What is said of units: nothing in the terminal unless something is wrong, a section of `report.md`.

use super::markup::{math, prose};
use super::numbers::count;
use super::text::{Paint, paragraph};
use ::units::{Term, UnitAccount, UnitVerdict, UnitsAccount};

/// For the terminal: formulas whose units do not agree, and those that were expected and are not there.
pub(super) fn terminal(units: &UnitsAccount, paint: Paint) -> String {
    let mut body = String::new();
    for formula in &units.formulas {
        if let UnitVerdict::Inconsistent { relation, terms } = &formula.verdict {
            let expected = if formula.expected { ", as expected" } else { "" };
            body.push_str(&format!("  {}{expected}\n", paint.bold(&format!("{} {}", formula.kind, formula.of))));
            body.push_str(&paragraph(&formula.formula, 4));
            let [a, b] = terms.as_ref();
            body.push_str(&format!("    these {relation}:\n"));
            for Term { latex, unit } in [a, b] {
                body.push_str(&format!("      {latex}   [{unit}]\n"));
            }
            body.push('\n');
        }
    }
    for claim in &units.missed {
        body.push_str(&paragraph(&format!("{claim}: inconsistent units are expected, and its units agree"), 2));
        body.push('\n');
    }
    let number = units.count("inconsistent") + units.missed.len();
    if body.is_empty() { body } else { format!("{} ({number})\n\n{body}", paint.bold("Units that do not agree")) }
}

/// The section of `report.md`; empty where nothing has a unit.
pub(super) fn section(units: &UnitsAccount) -> String {
    if units.formulas.is_empty() {
        return String::new();
    }
    let (good, bad, open) = (units.count("consistent"), units.count("inconsistent"), units.count("not-checked"));
    let mut out = format!(
        "## Units\n\nThe units of {} agree, those of {} do not, and {} could not be checked.\n\n",
        count(good, "formula"),
        count(bad, "formula"),
        count(open, "formula")
    );
    for formula in units.formulas.iter().filter(|f| f.verdict.word() == "inconsistent") {
        let expected = if formula.expected { " (as expected)" } else { "" };
        out.push_str(&format!(
            "- **{} `{}`**{expected}, {}: {}\n",
            formula.kind,
            formula.of,
            math(&formula.formula),
            words(formula)
        ));
    }
    for claim in &units.missed {
        out.push_str(&format!("- **claim `{claim}`**: inconsistent units are expected, and its units agree\n"));
    }
    if bad + units.missed.len() > 0 {
        out.push('\n');
    }
    out
}

/// The verdict in words, for Markdown.
fn words(formula: &UnitAccount) -> String {
    match &formula.verdict {
        UnitVerdict::Consistent => String::new(),
        UnitVerdict::Inconsistent { relation, terms } => {
            let [a, b] = terms.as_ref();
            let shown = |t: &Term| format!("{} in {}", math(&t.latex), prose(&t.unit));
            format!("{} and {} {relation}", shown(a), shown(b), relation = prose(relation))
        }
        UnitVerdict::NotChecked { reason } => prose(reason),
    }
}
