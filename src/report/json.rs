//! `report.json`: the [`Report`] as text.

use serde::Serialize;
use serde_json::Value;

use super::document::Report;
use crate::derivation::Derivation;
use ::paper::Comparison;
use diag::escape::in_json;
use findings::Account;

/// The contract, as text: stable order, one line for each pair of claim and trajectory.
pub fn json(derivation: &Derivation, account: &Account) -> String {
    in_json(&text(&Report::of(derivation, account, None)))
}

/// The same with the comparison with the paper, as `paper`.
pub fn json_with_paper(derivation: &Derivation, account: &Account, paper: &Comparison) -> String {
    in_json(&text(&Report::of(derivation, account, Some(paper))))
}

/// Plain data as text.
pub(super) fn text(document: &impl Serialize) -> String {
    let value = serde_json::to_value(document).expect("its keys are texts, and none of its parts refuses");
    let mut out = String::new();
    write(&value, 0, &mut out);
    out.push('\n');
    out
}

/// Below this depth a value stands on one line: pairs of claim and trajectory do.
const INLINE_DEPTH: usize = 4;

fn write(value: &Value, depth: usize, out: &mut String) {
    let line = |out: &mut String, depth: usize| {
        out.push('\n');
        out.extend(std::iter::repeat_n("  ", depth));
    };
    let nested = |v: &Value| v.is_object() || v.is_array();
    match value {
        Value::Object(map) if depth < INLINE_DEPTH && !map.is_empty() => {
            out.push('{');
            for (i, (key, value)) in map.iter().enumerate() {
                out.push_str(if i == 0 { "" } else { "," });
                line(out, depth + 1);
                out.push_str(&Value::String(key.clone()).to_string());
                out.push_str(": ");
                write(value, depth + 1, out);
            }
            line(out, depth);
            out.push('}');
        }
        Value::Array(items) if depth < INLINE_DEPTH && items.iter().any(nested) => {
            out.push('[');
            for (i, item) in items.iter().enumerate() {
                out.push_str(if i == 0 { "" } else { "," });
                line(out, depth + 1);
                write(item, depth + 1, out);
            }
            line(out, depth);
            out.push(']');
        }
        other => out.push_str(&other.to_string()),
    }
}

#[cfg(all(test, debug_assertions))]
mod tests {
    use super::super::tests::derivation;
    use super::*;
    use findings::sample;

    #[test]
    fn the_contract_is_kept() {
        let text = json(&derivation(), &sample::account());
        let value: Value = serde_json::from_str(&text).expect("this is JSON");
        let written = serde_json::to_value(Report::of(&derivation(), &sample::account(), None));
        assert_eq!(Some(value), written.ok());
        insta::assert_snapshot!(text);
    }
}
