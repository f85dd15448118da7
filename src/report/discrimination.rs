//! What the evidence is worth, as reports show it: how many altered formulas each motion rejects, which survive, and what a
//! claim that fails should have said.

use super::markup::{math, prose};
use super::numbers::count;
use super::tally::name;
use super::text::{Paint, paragraph};
use findings::{Account, ClaimAccount, Correction, EditClass, Erratum, Outcome, PairAccount, VariantAccount};

/// Whether a verdict says little.
pub(super) fn is_weak(pair: &PairAccount) -> bool {
    pair.discrimination.as_ref().is_some_and(|d| d.is_weak())
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

/// The part of `report.md` on what a claim that fails should have said.
pub(super) fn corrections_markdown(erratum: &Erratum) -> String {
    let (single, completions, pairs) = erratum.tried;
    if single + completions + pairs == 0 && erratum.corrections.is_empty() {
        return String::new();
    }
    let tried = format!("{single} single edits, {completions} completions and {pairs} pairs of edits were tried");
    let rate =
        erratum.rate.as_ref().map_or_else(String::new, |rate| format!("**Its rate**, proved: {}.\n\n", math(rate)));
    if erratum.corrections.is_empty() {
        let remark = erratum.remark.as_deref().unwrap_or("no correction was found");
        return format!("**No correction:** {}. ({tried}.)\n\n{rate}", prose(remark));
    }
    let mut out = format!(
        "**Altered formulas that hold instead**, the closest to the print first; which one was meant is for the reader to \
         say ({tried}):\n\n"
    );
    for c in &erratum.corrections {
        out.push_str(&format!("- {}: {}", standing(c), math(&c.formula)));
        out.push_str(&format!("  \n  `{}`\n", c.difference.replace('`', "'")));
    }
    out.push('\n');
    out.push_str(&rate);
    out
}

/// How far a correction was examined.
pub(super) fn standing(c: &Correction) -> String {
    let proved = match c.strength {
        verdict::Strength::Proved => "**proved**, ",
        verdict::Strength::Enclosed => "**enclosed**, ",
        verdict::Strength::Sampled => "",
    };
    let classes: Vec<&str> = c.classes.iter().map(|c| c.word()).collect();
    match c.holds_on {
        // Over ranges, or for all fields.
        0 => format!("{proved}holds ({})", classes.join(", ")),
        n => format!("{proved}holds on {} ({})", count(n, "motion"), classes.join(", ")),
    }
}

/// The part of the summary for a terminal: claims that no motion tests well, and corrections, a line or two for each.
pub(super) fn summary(account: &Account, paint: Paint) -> String {
    let mut out = String::new();
    let holds = |p: &&PairAccount| matches!(p.verdict.outcome(), Outcome::Holds(_)) && p.discrimination.is_some();
    let all = account.claims.iter().flat_map(|c| &c.results).filter(holds).count();
    let weak: usize = account.claims.iter().map(|c| weak_pairs(c).len()).sum();
    let mut lines = String::new();
    for claim in &account.claims {
        let Some((_, (rejected, of))) = claim.variants.as_ref().and_then(|v| Some((v, v.together()?))) else {
            continue;
        };
        if claim.results.iter().filter(holds).all(is_weak) {
            lines.push_str(&format!("  {}: all together reject {rejected} of {of}\n", paint.bold(&name(claim))));
        }
    }
    if weak > 0 {
        out.push_str(&format!(
            "{} ({weak} of {all} verdicts, marked h)\n",
            paint.bold("Holds, but many altered formulas would hold there, too")
        ));
        if !lines.is_empty() {
            out.push_str(&format!("\n  On every motion, for these claims:\n{lines}"));
        }
        out.push('\n');
    }
    let mut offered = String::new();
    let mut without = 0;
    for claim in &account.claims {
        let Some(erratum) = claim.variants.as_ref().and_then(|v| v.erratum.as_ref()) else { continue };
        let Some(first) = erratum.corrections.first() else {
            without += 1;
            continue;
        };
        offered.push_str(&format!("  {}: {}", paint.bold(&name(claim)), standing(first).replace("**", "")));
        offered.push_str(&match erratum.corrections.len() - 1 {
            0 => "\n".to_owned(),
            n => format!("; {n} more in the report\n"),
        });
        offered.push_str(&paragraph(&first.formula, 4));
    }
    if without > 0 {
        offered.push_str(&format!("  None was found for {}.\n", count(without, "failing claim")));
    }
    if !offered.is_empty() {
        let title = paint.bold("Altered formulas that hold where the printed one fails");
        out.push_str(&format!("{title}\n\n{offered}\n"));
    }
    out
}
