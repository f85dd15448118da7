//! SARIF 2.1.0, for code scanning.
//!
//! A rule for each kind of problem; a location in the derivation file and, as a related location, in the paper. The
//! fingerprint of a result names the claim and what was expected of it, not its line: an alert stays the same alert when the
//! file above it is edited. `primaryLocationLineHash` is the one that code scanning reads.
//!
//! # Source
//! Static Analysis Results Interchange Format (SARIF) Version 2.1.0, OASIS Standard, 2020.

use std::collections::BTreeMap;

use serde_json::{Map, Value, json};

use diag::shown::in_json;

use super::finding::{Finding, Level, Place, rule_says};

/// A log with one run, as text.
pub fn sarif(findings: &[Finding]) -> String {
    let mut rules: Vec<&'static str> = findings.iter().map(|f| f.rule).collect();
    rules.sort_unstable();
    rules.dedup();
    let mut seen: BTreeMap<String, usize> = BTreeMap::new();
    let results: Vec<Value> = findings
        .iter()
        .map(|f| {
            let fingerprint = f.fingerprint();
            let nth = seen.entry(fingerprint.clone()).or_insert(0);
            *nth += 1;
            result(f, &rules, &fingerprint, *nth)
        })
        .collect();
    let log = json!({
        "$schema": "https://json.schemastore.org/sarif-2.1.0.json",
        "version": "2.1.0",
        "runs": [{
            "tool": { "driver": {
                "name": crate::PROGRAM,
                "semanticVersion": env!("CARGO_PKG_VERSION"),
                "rules": rules.iter().map(|rule| descriptor(rule)).collect::<Vec<_>>(),
            }},
            "columnKind": "utf16CodeUnits",
            "results": results,
        }],
    });
    let mut text = serde_json::to_string_pretty(&log).unwrap_or_default();
    text.push('\n');
    in_json(&text)
}

fn descriptor(rule: &str) -> Value {
    let level = match rule {
        "verdict::undecided" | "verdict::nothing-decided" => Level::Warning,
        "paper::not-covered" => Level::Note,
        _ => Level::Error,
    };
    // The name of a rule is written without colons and hyphens.
    let name: String = rule.split([':', '-']).map(capitalized).collect();
    json!({
        "id": rule,
        "name": name,
        "shortDescription": { "text": rule_says(rule) },
        "fullDescription": { "text": rule_says(rule) },
        "help": { "text": format!("{} The page on continuous integration lists every rule.", rule_says(rule)) },
        "defaultConfiguration": { "level": level.word() },
    })
}

fn capitalized(word: &str) -> String {
    let mut chars = word.chars();
    chars.next().map(|c| c.to_ascii_uppercase()).into_iter().chain(chars).collect()
}

fn result(finding: &Finding, rules: &[&str], fingerprint: &str, nth: usize) -> Value {
    let mut related = Vec::new();
    let mut message = escaped(&finding.message);
    for (i, (place, words)) in finding.related.iter().enumerate() {
        let mut location = location(place);
        location.insert("id".to_owned(), json!(i + 1));
        location.insert("message".to_owned(), json!({ "text": escaped(words) }));
        related.push(Value::Object(location));
        message.push_str(&format!(" [{}]({}).", escaped(words), i + 1));
    }
    let mut out = json!({
        "ruleId": finding.rule,
        "ruleIndex": rules.iter().position(|r| *r == finding.rule),
        "level": finding.level.word(),
        "message": { "text": message },
        "locations": [Value::Object(location(&finding.place))],
        "partialFingerprints": {
            "primaryLocationLineHash": format!("{fingerprint}:{nth}"),
            "rederive/v1": format!("{fingerprint}:{nth}"),
        },
    });
    if !related.is_empty() {
        out["relatedLocations"] = Value::Array(related);
    }
    out
}

/// Plain text in a message: brackets would begin a link, and braces a placeholder.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '\\' | '[' | ']' => {
                out.push('\\');
                out.push(c);
            }
            '{' => out.push_str("{{"),
            '}' => out.push_str("}}"),
            _ => out.push(c),
        }
    }
    out
}

fn location(place: &Place) -> Map<String, Value> {
    let path = &place.source.path;
    let inside = !path.starts_with('/') && !path.starts_with("..");
    let mut artifact = Map::new();
    artifact.insert("uri".to_owned(), Value::String(uri(path)));
    if inside {
        artifact.insert("uriBaseId".to_owned(), Value::String("%SRCROOT%".to_owned()));
    }
    let mut physical = Map::new();
    physical.insert("artifactLocation".to_owned(), Value::Object(artifact));
    // Code scanning needs a line: that of a file as a whole is the first.
    physical.insert(
        "region".to_owned(),
        match place.region() {
            Some(r) => json!({
                "startLine": r.line, "startColumn": r.column, "endLine": r.end_line, "endColumn": r.end_column,
            }),
            None => json!({ "startLine": 1 }),
        },
    );
    let mut out = Map::new();
    out.insert("physicalLocation".to_owned(), Value::Object(physical));
    out
}

/// A path as a URI reference: a relative one stays relative.
fn uri(path: &str) -> String {
    let path = path.replace('\\', "/");
    let mut out = String::new();
    if path.starts_with('/') {
        out.push_str("file://");
    }
    for byte in path.bytes() {
        match byte {
            b'A'..=b'Z' | b'a'..=b'z' | b'0'..=b'9' | b'-' | b'.' | b'_' | b'~' | b'/' => out.push(char::from(byte)),
            other => out.push_str(&format!("%{other:02X}")),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_survive_in_messages() {
        assert_eq!(escaped(r"[a,b] \frac{1}{2}"), r"\[a,b\] \\frac{{1}}{{2}}");
    }

    #[test]
    fn paths_become_uris() {
        assert_eq!(uri("derivations/a b#c.toml"), "derivations/a%20b%23c.toml");
        assert_eq!(uri("/tmp/é"), "file:///tmp/%C3%A9");
        assert_eq!(uri("a:b"), "a%3Ab", "no scheme comes into being");
    }
}
