//! Answers to what an editor asks of a place.

use rederive::diag::escape::in_one_line;
use rederive::report::{Finding, Level, Place};
use serde_json::{Value, json};

use super::looked::{Looked, Remark};
use super::positions::{is_named, offset, range};

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

/// The smallest remark around a place, or else the last one before it in the same table of a derivation file.
fn remark_at(of: &Looked, at: usize) -> Option<&Remark> {
    let around = of.remarks.iter().filter(|r| r.span.start <= at && at <= r.span.end);
    let before = || {
        let last = of.remarks.iter().filter(|r| r.span.end <= at).max_by_key(|r| r.span.end)?;
        let between = of.source.text.get(last.span.end..at)?;
        (!of.declared.is_empty() && !between.contains("\n[")).then_some(last)
    };
    around.min_by_key(|r| r.span.len()).or_else(before)
}

/// The declaration of the name at a place.
fn declaration(of: &Looked, at: usize) -> Option<&super::looked::Declared> {
    of.declared.iter().filter(|d| is_named(&of.source.text, at, &d.name)).max_by_key(|d| d.name.len())
}

/// What stands at a place, and what was found of it.
pub(super) fn hover(of: &Looked, params: &Value) -> Option<Value> {
    let at = at(of, params);
    let named =
        declaration(of, at).map(|d| format!("`{}`: {}", in_one_line(&d.name).replace('`', "'"), in_one_line(&d.says)));
    let parts: Vec<String> = named.into_iter().chain(remark_at(of, at).map(|r| r.more.clone())).collect();
    (!parts.is_empty()).then(|| json!({ "contents": { "kind": "markdown", "value": parts.join("\n\n") } }))
}

/// The place where the name at a place is declared.
pub(super) fn definition(of: &Looked, params: &Value) -> Option<Value> {
    let declared = declaration(of, at(of, params))?;
    let region = Place::new(&of.source, declared.span.clone()).region()?;
    let uri = params.pointer("/textDocument/uri")?;
    Some(json!({ "uri": uri, "range": range(region) }))
}

/// Every name that the text declares.
pub(super) fn completion(of: &Looked) -> Value {
    of.declared.iter().map(|d| json!({ "label": d.name, "kind": 6, "detail": d.says })).collect()
}

/// What could be done about a place: the formula that is right there, the declaration of a name that has none.
pub(super) fn actions(of: &Looked, params: &Value) -> Value {
    let uri = params.pointer("/textDocument/uri").and_then(Value::as_str).unwrap_or_default();
    let place = |key: &str| params.pointer(&format!("/range/{key}")).map_or(0, |p| offset(&of.source.text, p));
    let (from, to) = (place("start"), place("end"));
    let touches = |span: &std::ops::Range<usize>| span.start <= to && from <= span.end;
    let action = |title: String, span: std::ops::Range<usize>, text: &str| {
        let region = Place::new(&of.source, span).region()?;
        let edit = json!({ "range": range(region), "newText": text });
        Some(json!({ "title": title, "kind": "quickfix", "edit": { "changes": { uri: [edit] } } }))
    };
    let right = of.findings.iter().filter_map(|f| f.fix.as_ref()).filter_map(|fix| {
        let span = fix.place.span.clone().filter(touches)?;
        action(format!("{}: {}", fix.says, in_one_line(&fix.text)), span, &fix.text)
    });
    let undeclared = of.findings.iter().filter(|f| f.rule == "latex::unknown-symbol").filter_map(|f| {
        let span = f.place.span.clone().filter(touches)?;
        let name = of.source.text.get(span)?;
        let table = of.source.text.find("[symbols]\n")? + "[symbols]\n".len();
        let fits = !name.contains(['\'', '\n']);
        let title = format!("Declare {} as a parameter", in_one_line(name));
        fits.then(|| action(title, table..table, &format!("'{name}' = {{ role = 'parameter' }}\n"))).flatten()
    });
    right.chain(undeclared).collect()
}

/// A word behind each formula or claim within a range.
pub(super) fn hints(of: &Looked, params: &Value) -> Value {
    let place =
        |key: &str, none: usize| params.pointer(&format!("/range/{key}")).map_or(none, |p| offset(&of.source.text, p));
    let (from, to) = (place("start", 0), place("end", of.source.text.len()));
    let within = of.remarks.iter().filter(|r| from <= r.span.end && r.span.start <= to);
    let hint = |r: &Remark| {
        let region = Place::new(&of.source, r.span.clone()).region()?;
        let position = json!({ "line": region.end_line - 1, "character": region.end_column - 1 });
        Some(json!({ "position": position, "label": r.word, "paddingLeft": true }))
    };
    within.filter_map(hint).collect()
}
