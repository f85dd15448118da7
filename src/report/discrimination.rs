//! What the evidence is worth, as reports show it: how many altered formulas each motion rejects, which survive, and what a
//! claim that fails should have said.

use serde_json::{Value, json};

use crate::check::{ClaimAccount, Erratum, PairAccount};

/// The discrimination of a pair; survivors by their numbers in the list of the claim, in ranges.
pub(super) fn pair_json(pair: &PairAccount) -> Value {
    pair.discrimination.as_ref().map_or(Value::Null, |d| {
        json!({ "rejected": d.rejected, "of": d.of, "weak": d.is_weak(), "survivors": ranges(&d.survivors) })
    })
}

/// The variants of a claim.
pub(super) fn claim_json(claim: &ClaimAccount) -> Value {
    let Some(variants) = &claim.variants else { return Value::Null };
    let classes = variants.classes.iter().map(|c| {
        json!({
            "class": c.class.word(), "generated": c.generated, "meaningless": c.meaningless, "repeated": c.repeated,
            "equivalent": c.equivalent, "empty": c.empty, "kept": c.kept,
        })
    });
    let skipped = variants.skipped.iter().map(|(f, why)| json!({ "formula": f, "reason": why }));
    let survivors = variants.survivors.iter().map(|s| {
        json!({ "class": s.class.word(), "formula": s.formula, "everywhere": s.everywhere })
    });
    let (rejected, of) = variants.together();
    json!({
        "together": { "rejected": rejected, "of": of },
        "smallest_set": { "trajectories": variants.cover, "least": variants.cover_is_least },
        "classes": classes.collect::<Vec<_>>(),
        "skipped": skipped.collect::<Vec<_>>(),
        "survivors": survivors.collect::<Vec<_>>(),
        "erratum": variants.erratum.as_ref().map(erratum_json),
    })
}

fn erratum_json(erratum: &Erratum) -> Value {
    let corrections = erratum.corrections.iter().map(|c| {
        json!({
            "printed": c.printed, "formula": c.formula, "difference": c.difference,
            "classes": c.classes.iter().map(|c| c.word()).collect::<Vec<_>>(),
            "proved": c.proved, "holds_on": c.holds_on,
        })
    });
    json!({
        "corrections": corrections.collect::<Vec<_>>(),
        "tried": { "single": erratum.tried.0, "completions": erratum.tried.1, "pairs": erratum.tried.2 },
        "remark": erratum.remark,
    })
}

/// Increasing numbers as ranges: `0-3,7`.
fn ranges(numbers: &[usize]) -> String {
    let mut out: Vec<String> = Vec::new();
    let mut at = 0;
    while let Some(&from) = numbers.get(at) {
        let mut to = from;
        while numbers.get(at + 1) == Some(&(to + 1)) {
            to += 1;
            at += 1;
        }
        out.push(if from == to { from.to_string() } else { format!("{from}-{to}") });
        at += 1;
    }
    out.join(",")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_in_ranges() {
        assert_eq!(ranges(&[]), "");
        assert_eq!(ranges(&[4]), "4");
        assert_eq!(ranges(&[0, 1, 2, 5, 7, 8]), "0-2,5,7-8");
    }
}
