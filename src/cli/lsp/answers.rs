//! Answers to what an editor asks of a place.

use std::ops::Range;

use rederive::diag::escape::in_one_line;
use rederive::look::{Looked, Remark};
use rederive::report::{Finding, Fix, Level, Place};
use serde_json::{Value, json};

use super::positions::{bytes, offset, range};

/// A finding as an editor shows it; `None` where it has no place in the text.
pub(super) fn diagnostic(of: &Finding) -> Option<Value> {
    let region = of.place.region().or_else(|| Place::new(&of.place.source, 0..0).region())?;
    let severity = match of.level {
        Level::Error => 1,
        Level::Warning => 2,
        Level::Note => 4,
    };
    Some(
        json!({ "range": range(region), "severity": severity, "code": of.rule, "source": "rederive", "message": of.message }),
    )
}

fn at(of: &Looked, params: &Value) -> usize {
    params.get("position").map_or(0, |place| offset(&of.source.text, place))
}

/// What stands at a place, and what was found of it.
pub(super) fn hover(of: &Looked, params: &Value) -> Option<Value> {
    let said = of.said_at(at(of, params))?;
    Some(json!({ "contents": { "kind": "markdown", "value": said } }))
}

/// The place where the name at a place is declared.
pub(super) fn definition(of: &Looked, params: &Value) -> Option<Value> {
    let declared = of.declared_at(at(of, params))?;
    let region = Place::new(&of.source, declared.span.clone()).region()?;
    let uri = params.pointer("/textDocument/uri")?;
    Some(json!({ "uri": uri, "range": range(region) }))
}

/// Every name that the text declares.
pub(super) fn completion(of: &Looked) -> Value {
    of.declared.iter().map(|d| json!({ "label": d.name, "kind": 6, "detail": d.says })).collect()
}

/// The changes that may be made at a place: the text that is right there, or an assumption.
pub(super) fn actions(of: &Looked, params: &Value) -> Value {
    let uri = params.pointer("/textDocument/uri").and_then(Value::as_str).unwrap_or_default();
    let action = |fix: &Fix| {
        let edit = json!({ "range": range(fix.place.region()?), "newText": fix.text });
        let title = format!("{}: {}", fix.says, in_one_line(fix.text.trim_end()));
        Some(json!({ "title": title, "kind": "quickfix", "edit": { "changes": { uri: [edit] } } }))
    };
    of.fixes(&bytes(&of.source.text, params)).into_iter().filter_map(action).collect()
}

/// A word behind each formula or claim within a range.
pub(super) fn hints(of: &Looked, params: &Value) -> Value {
    let Range { start, end } = bytes(&of.source.text, params);
    let within = of.remarks.iter().filter(|r| start <= r.span.end && r.span.start <= end);
    let hint = |r: &Remark| {
        let region = Place::new(&of.source, r.span.clone()).region()?;
        let position = json!({ "line": region.end_line - 1, "character": region.end_column - 1 });
        Some(json!({ "position": position, "label": r.word, "paddingLeft": true }))
    };
    within.filter_map(hint).collect()
}
