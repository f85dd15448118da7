//! A derivation file beside its paper, as text and as findings.

use std::sync::Arc;

use super::finding::{Finding, Level, Place};
use super::numbers::count;
use ::paper::{Comparison, Difference};
use derivation::Derivation;

/// The most equations and relations that are listed for a terminal.
const SHOWN: usize = 20;

/// What differs, what is not known, and what no claim covers.
pub fn paper_findings(derivation: &Derivation, comparison: &Comparison) -> Vec<Finding> {
    let here = |span: &std::ops::Range<usize>| Place::new(&derivation.file, span.clone());
    let there = |span: &std::ops::Range<usize>| Place::new(&comparison.paper, span.clone());
    let differs = comparison.differences.iter().map(|d| Finding {
        rule: "paper::differs",
        level: Level::Error,
        message: difference(d),
        place: here(&d.here),
        related: vec![(there(&d.there), format!("printed under `{}`", d.label))],
        identity: format!("{}\n{}\n{}", derivation.id, d.owner, d.label),
        fix: None,
    });
    let unknown = comparison.unknown.iter().map(|u| {
        let hint = u.near.as_ref().map(|n| format!(" Did you mean `{n}`?")).unwrap_or_default();
        Finding {
            rule: "paper::unknown-label",
            level: Level::Error,
            message: format!("`{}` names the label `{}`, which the paper does not have.{hint}", u.owner, u.label),
            place: here(&u.span),
            related: Vec::new(),
            identity: format!("{}\n{}\n{}", derivation.id, u.owner, u.label),
            fix: None,
        }
    });
    let open = comparison.equations.iter().filter(|e| !e.is_covered()).map(|e| Finding {
        rule: "paper::not-covered",
        level: Level::Note,
        message: format!("No claim of `{}` covers this equation: {}", derivation.id, e.text),
        place: there(&e.span),
        related: Vec::new(),
        identity: format!("{}\n{}", derivation.id, e.label.as_ref().unwrap_or(&e.text)),
        fix: None,
    });
    differs.chain(unknown).chain(open).collect()
}

fn difference(d: &Difference) -> String {
    let like = if d.is_near { "prints" } else { "has nothing like it; nearest is" };
    format!("`{}` has the formula {}, but the paper under `{}` {like} {}", d.owner, d.formula, d.label, d.printed)
}

/// Puts the places in the paper beside findings on claims that name a label.
pub fn add_paper(findings: &mut [Finding], derivation: &Derivation, comparison: &Comparison) {
    for finding in findings.iter_mut().filter(|f| f.rule.starts_with("verdict::")) {
        let span = finding.place.span.as_ref().filter(|_| Arc::ptr_eq(&finding.place.source, &derivation.file));
        // A finding stands at the id or at a formula of its claim, and the id comes before the formulas.
        let claim = span.and_then(|s| derivation.claims.iter().rfind(|c| c.span.start <= s.start));
        let Some(label) = claim.and_then(|c| c.label.as_deref()) else { continue };
        let printed = comparison.equations.iter().find(|e| e.label.as_deref() == Some(label));
        if let Some(equation) = printed {
            finding
                .related
                .push((Place::new(&comparison.paper, equation.span.clone()), format!("printed as `{label}`")));
        }
    }
}

pub(super) fn line(comparison: &Comparison, span: &std::ops::Range<usize>) -> usize {
    Place::new(&comparison.paper, span.clone()).region().map_or(1, |r| r.line)
}

/// A section for a terminal.
pub fn paper_summary(derivation: &Derivation, comparison: &Comparison) -> String {
    let (covered, printed) = comparison.covered();
    let mut out = format!(
        "\nCompared with {}\n\n  {} compared with what is printed under their labels, {} not the same\n",
        comparison.paper.path,
        count(comparison.compared, "formula"),
        comparison.differences.len(),
    );
    out.push_str(&format!(
        "  displayed: {covered} of {} covered, {printed} of {} as printed\n",
        count(comparison.equations.len(), "equation"),
        count(comparison.parts(), "part"),
    ));
    out.push_str(&format!(
        "  in the running text: {} of {} word for word\n",
        comparison.found(),
        count(comparison.relations.len(), "relation"),
    ));
    for finding in paper_findings(derivation, comparison).iter().filter(|f| f.level == Level::Error) {
        let at = |p: &Place| p.region().map_or(String::new(), |r| format!(":{}:{}", r.line, r.column));
        out.push_str(&format!("\n  {}{}: {}\n", finding.place.source.path, at(&finding.place), finding.message));
        for (place, words) in &finding.related {
            out.push_str(&format!("    {}{}: {words}\n", place.source.path, at(place)));
        }
    }
    let equations = comparison.equations.iter().filter(|e| !e.is_covered()).map(|e| (&e.span, &e.text));
    out.push_str(&listed("Equations that no claim covers", comparison, equations));
    let relations = comparison.relations.iter().filter(|r| !r.is_found).map(|r| (&r.span, &r.text));
    out.push_str(&listed(
        "Relations of the running text that are not in the file word for word",
        comparison,
        relations,
    ));
    out
}

fn listed<'a>(
    title: &str,
    comparison: &Comparison,
    entries: impl Iterator<Item = (&'a std::ops::Range<usize>, &'a String)>,
) -> String {
    let entries: Vec<_> = entries.collect();
    if entries.is_empty() {
        return String::new();
    }
    let mut out = format!("\n  {title}\n");
    for (span, text) in entries.iter().take(SHOWN) {
        out.push_str(&format!("    line {}: {text}\n", line(comparison, span)));
    }
    if entries.len() > SHOWN {
        out.push_str(&format!("    … and {} more\n", entries.len() - SHOWN));
    }
    out
}
