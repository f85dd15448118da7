//! What is said of units: which formulas have terms whose units do not agree.

use super::numbers::count;
use super::story::{StoryBlock, StorySpan, Tone, list, on_page, prose, section, words};
use super::wording::unit;
use ::units::{Term, UnitAccount, UnitVerdict, UnitsAccount};
use latex::Scope;

/// So many formulas whose units do not agree are seen; the others are folded.
const MOST: usize = 40;

/// A formula whose units do not agree, and how.
pub(super) fn disagreement<'a>(of: &'a UnitAccount, scope: &'a Scope) -> Vec<StorySpan<'a>> {
    let mut out = vec![StorySpan::Math(of.formula.clone(), scope)];
    if let UnitVerdict::Inconsistent { relation, terms } = &of.verdict {
        for (Term { latex, unit: of }, before) in terms.iter().zip([": ", " and "]) {
            out.extend([words(before), StorySpan::Math(latex.clone(), scope), words(format!(" in {}", unit(of)))]);
        }
        out.push(prose(format!(" {relation}"), scope));
    }
    out.push(words(if of.expected { " (as expected)." } else { "." }));
    out
}

/// The formulas whose units do not agree.
pub(super) fn inconsistent(units: &UnitsAccount) -> impl Iterator<Item = &UnitAccount> {
    units.formulas.iter().filter(|f| matches!(f.verdict, UnitVerdict::Inconsistent { .. }))
}

/// What is wrong: formulas whose units do not agree, and those that were expected and are not there.
fn wrong<'a>(units: &'a UnitsAccount, scope: &'a Scope) -> Vec<Vec<StorySpan<'a>>> {
    let named = |of: &'a UnitAccount| {
        let lead = StorySpan::Words(format!("{} {}: ", of.kind, of.of), Tone::Strong);
        std::iter::once(lead).chain(disagreement(of, scope)).collect()
    };
    let missed = |claim: &'a String| {
        vec![StorySpan::Words(format!("{claim}: inconsistent units are expected, and its units agree."), Tone::Strong)]
    };
    inconsistent(units).map(named).chain(units.missed.iter().map(missed)).collect()
}

/// For the terminal: what is wrong, under a heading.
pub(super) fn problems<'a>(units: &'a UnitsAccount, scope: &'a Scope) -> Vec<StoryBlock<'a>> {
    let all = wrong(units, scope);
    if all.is_empty() {
        return Vec::new();
    }
    vec![StoryBlock::Heading(format!("Units that do not agree ({})", all.len())), list(all)]
}

/// The section; nothing where nothing has a unit.
pub(super) fn units<'a>(units: &'a UnitsAccount, scope: &'a Scope) -> Option<StoryBlock<'a>> {
    let n = |word: &str| count(units.count(word), "formula");
    let counts = format!(
        "The units of {} agree, those of {} do not, and {} could not be checked.",
        n("consistent"),
        n("inconsistent"),
        n("not-checked")
    );
    let mut seen = wrong(units, scope);
    let more = seen.split_off(seen.len().min(MOST));
    let mut blocks = vec![StoryBlock::Paragraph(vec![words(counts)])];
    if !seen.is_empty() {
        blocks.push(list(seen));
    }
    if !more.is_empty() {
        blocks.push(on_page(
            format!("{} more", more.len()),
            &format!("{} more are on the page.", more.len()),
            vec![list(more)],
        ));
    }
    (!units.formulas.is_empty()).then(|| section("/units", "Units", blocks))
}
