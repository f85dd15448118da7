//! `report.md`: the report for people, as a forge renders it.

use super::graph::DerivationGraph;
use super::markup::prose;
use super::story::{self, StoryBlock, words};
use super::{sections, whole};
use derivation::Derivation;
use findings::Account;
use std::collections::HashSet;

/// The report.
pub fn markdown(derivation: &Derivation, account: &Account) -> String {
    let mut blocks = sections::concerns(derivation);
    blocks.push(StoryBlock::Paragraph(vec![words(
        "Pictures, curves and every pair: index.html. All numbers: report.json.",
    )]));
    blocks.extend(whole::report(derivation, account, DerivationGraph::new(derivation, account).section()));
    let text = format!("# {}\n\n{}", prose(&derivation.title), story::markdown(&blocks, &link_to));
    without_idle_anchors(text.trim_end()) + "\n"
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

/// A link to the section on a claim.
fn link_to(name: &str, words: Option<&str>) -> String {
    format!("[{}](#{})", words.unwrap_or(name), story::anchor(name))
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
