//! What the evidence is worth, as reports show it: how many altered formulas each motion rejects, which survive, and what a
//! claim that fails should have said.

use super::numbers::count;
use super::story::{StoryBlock, StorySpan, list, prose, strong, words};
use super::tally::name;
use findings::{Account, ClaimAccount, Correction, EditClass, Erratum, Outcome, PairAccount, Strength, VariantAccount};
use latex::Scope;

/// Whether a verdict says little. What is proved says what it says, whatever else holds there.
pub(super) fn is_weak(pair: &PairAccount) -> bool {
    let is_proved = matches!(pair.verdict.outcome(), Outcome::Holds(Strength::Proved));
    pair.discrimination.as_ref().is_some_and(|d| d.is_weak()) && !is_proved
}

/// Kinds of slips in words: `a wrong sign, a wrong index`.
fn slips(classes: &[EditClass]) -> String {
    classes.iter().map(|c| c.says()).collect::<Vec<_>>().join(", ")
}

/// The pairs of a claim that say little.
fn weak_pairs(claim: &ClaimAccount) -> Vec<&PairAccount> {
    claim.results.iter().filter(|p| is_weak(p)).collect()
}

/// What no motion, or none of the weak ones, would notice, in a sentence; empty where there is nothing to say.
pub(super) fn sentence(claim: &ClaimAccount, variants: &VariantAccount) -> String {
    let everywhere = variants.survivors.iter().enumerate().filter(|(_, s)| s.everywhere).map(|(i, _)| i);
    let never = variants.unnoticed(everywhere);
    let weak = weak_pairs(claim);
    let mut out = String::new();
    if !never.is_empty() {
        let nothing = if claim.region.is_some() { "Nothing that was tried" } else { "No motion here" };
        out.push_str(&format!("{nothing} notices every slip of these kinds: {}. ", slips(&never)));
    }
    if let Some(weakest) = weak.iter().min_by_key(|p| p.discrimination.as_ref().map_or(0, |d| d.rejected))
        && let Some(d) = &weakest.discrimination
    {
        let unnoticed = slips(&variants.unnoticed(d.survivors.iter().copied()));
        out.push_str(&format!(
            "The weakest is {}: it rejects {} of {}, and misses some of these: {unnoticed}.",
            weakest.trajectory, d.rejected, d.of
        ));
    }
    out.trim_end().to_owned()
}

/// Where variants were tried, in words.
pub(super) fn tried_where(claim: &ClaimAccount, variants: &VariantAccount) -> String {
    match &claim.region {
        Some(region) if region.is_of_fields() => "by solutions of what is given".to_owned(),
        Some(_) => "at points of the ranges".to_owned(),
        None => format!("on {}", count(variants.tried_on, "motion")),
    }
}

/// The motions that suffice, in words.
pub(super) fn smallest(variants: &VariantAccount) -> String {
    let how = if variants.cover_is_least { "the fewest" } else { "a small set" };
    match variants.cover.as_slice() {
        [] => String::new(),
        [one] => format!("; `{one}` alone rejects as many"),
        more => {
            let names: Vec<String> = more.iter().map(|t| format!("`{t}`")).collect();
            format!("; {how} that reject as many: {}", names.join(", "))
        }
    }
}

/// What a claim that fails should have said; nothing where nothing can be altered.
pub(super) fn corrections<'a>(erratum: &'a Erratum, scope: &'a Scope) -> Vec<StoryBlock<'a>> {
    let (single, completions, pairs) = erratum.tried;
    if single + completions + pairs == 0 && erratum.corrections.is_empty() {
        return Vec::new();
    }
    let tried = format!("{single} single edits, {completions} completions and {pairs} pairs of edits were tried");
    let mut blocks = Vec::new();
    if erratum.corrections.is_empty() {
        let remark = erratum.remark.as_deref().unwrap_or("no correction was found");
        blocks.push(StoryBlock::Paragraph(vec![
            strong("No correction: "),
            prose(format!("{remark}. ({tried}.)"), scope),
        ]));
    } else {
        let lead = [
            strong("Altered formulas that hold instead"),
            words(format!(", the closest to the print first; which one was meant is for the reader to say ({tried}):")),
        ];
        blocks.push(StoryBlock::Paragraph(lead.into()));
        blocks.push(list(erratum.corrections.iter().map(|c| {
            let formula = c.formula.clone();
            let right = StorySpan::Marked { formula, beside: c.printed.clone(), scope, wrong: false };
            vec![words(format!("{}: ", standing(c))), right, StorySpan::Difference(c.difference.clone())]
        })));
        let remark = erratum.remark.as_ref();
        blocks.extend(
            remark.map(|text| StoryBlock::Group("page", vec![StoryBlock::Paragraph(vec![prose(text, scope)])])),
        );
    }
    blocks.extend(
        erratum
            .rate
            .as_ref()
            .map(|rate| StoryBlock::Paragraph(vec![strong("Its rate"), prose(format!(", proved: ${rate}$."), scope)])),
    );
    vec![StoryBlock::Group("erratum", blocks)]
}

/// What a correction of a claim was tried on, where that is one motion, or the fields that the file puts in, and no more: ` on the motion
/// X alone`. What is proved otherwise is for all that the claim follows from.
pub(super) fn alone(claim: &ClaimAccount, c: &Correction) -> Option<String> {
    if claim.region.as_ref().is_some_and(|r| r.ranges.iter().any(|range| range.is_field())) {
        return Some(" for the fields of its ranges alone".to_owned());
    }
    let applies = |p: &&PairAccount| !matches!(p.verdict.outcome(), Outcome::NotApplicable(_));
    let mut on = claim.results.iter().filter(applies);
    match (c.strength, c.holds_on, on.next()) {
        (verdict::Strength::Enclosed | verdict::Strength::Sampled, 1, Some(pair)) => {
            Some(format!(" on the motion {} alone", pair.trajectory))
        }
        _ => None,
    }
}

/// How far a correction was examined.
pub(super) fn standing(c: &Correction) -> String {
    let proved = match c.strength {
        verdict::Strength::Proved => "proved, ",
        verdict::Strength::Enclosed => "enclosed, ",
        verdict::Strength::Sampled => "",
    };
    let classes: Vec<&str> = c.classes.iter().map(|c| c.word()).collect();
    match c.holds_on {
        // Over ranges, or for all fields.
        0 => format!("{proved}holds ({})", classes.join(", ")),
        n => format!("{proved}holds on {} ({})", count(n, "motion"), classes.join(", ")),
    }
}

/// Claims that no motion tests well, and corrections: a line for each.
pub(super) fn summary<'a>(account: &'a Account, scope: &'a Scope) -> Vec<StoryBlock<'a>> {
    let holds = |p: &&PairAccount| matches!(p.verdict.outcome(), Outcome::Holds(_)) && p.discrimination.is_some();
    let all = account.claims.iter().flat_map(|c| &c.results).filter(holds).count();
    let weak: usize = account.claims.iter().map(|c| weak_pairs(c).len()).sum();
    let mut out = Vec::new();
    let untested = account.claims.iter().filter(|c| c.results.iter().filter(holds).all(is_weak)).filter_map(|claim| {
        let (rejected, of) = claim.variants.as_ref()?.together()?;
        Some(vec![strong(name(claim)), words(format!(": all together reject {rejected} of {of}"))])
    });
    if weak > 0 {
        out.push(StoryBlock::Heading(format!(
            "Holds, but many altered formulas would hold there, too ({weak} of {all} verdicts, marked h)"
        )));
        out.push(StoryBlock::Paragraph(vec![words("On every motion, for these claims:")]));
        out.push(list(untested));
    }
    let errata = || account.claims.iter().filter_map(|c| Some((c, c.variants.as_ref()?.erratum.as_ref()?)));
    let mut offered: Vec<Vec<StorySpan<'a>>> = Vec::new();
    for (claim, erratum) in errata() {
        let Some(first) = erratum.corrections.first() else { continue };
        let more = erratum.corrections.len() - 1;
        let more = if more > 0 { format!("; {more} more in the report") } else { String::new() };
        let formula = StorySpan::Math(first.formula.clone(), scope);
        offered.push(vec![strong(name(claim)), words(format!(": {}{more}: ", standing(first))), formula]);
    }
    let without = errata().filter(|(_, e)| e.corrections.is_empty()).count();
    if without > 0 {
        offered.push(vec![words(format!("None was found for {}.", count(without, "failing claim")))]);
    }
    if !offered.is_empty() {
        out.push(StoryBlock::Heading("Altered formulas that hold where the printed one fails".to_owned()));
        out.push(list(offered));
    }
    out
}
