//! SARIF 2.1.0, for code scanning.
//!
//! A rule for each kind of problem; a location in the derivation file and, as a related location, in the paper. The
//! fingerprint of a result names the claim and what was expected of it, not its line: an alert stays the same alert when the
//! file above it is edited. `primaryLocationLineHash` is the one that code scanning reads.
//!
//! # Source
//! Static Analysis Results Interchange Format (SARIF) Version 2.1.0, OASIS Standard, 2020.

use std::collections::BTreeMap;

use serde::Serialize;

use diag::escape::in_json;

use super::finding::{Finding, Fix, Level, Place, rule_says};

/// What is said, as the standard has every text.
#[derive(Serialize)]
struct Message {
    text: String,
}

impl Message {
    fn new(text: impl Into<String>) -> Message {
        Message { text: text.into() }
    }
}

#[derive(Serialize)]
struct Log {
    #[serde(rename = "$schema")]
    schema: &'static str,
    version: &'static str,
    runs: [Run; 1],
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Run {
    tool: Tool,
    column_kind: &'static str,
    results: Vec<Outcome>,
}

#[derive(Serialize)]
struct Tool {
    driver: Driver,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Driver {
    name: &'static str,
    semantic_version: &'static str,
    rules: Vec<Rule>,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Rule {
    id: &'static str,
    name: String,
    short_description: Message,
    full_description: Message,
    help: Message,
    default_configuration: Configuration,
}

#[derive(Serialize)]
struct Configuration {
    level: &'static str,
}

/// A `result` of the standard.
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Outcome {
    rule_id: &'static str,
    rule_index: Option<usize>,
    level: &'static str,
    message: Message,
    locations: [Location; 1],
    partial_fingerprints: Fingerprints,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    related_locations: Vec<Location>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    fixes: Vec<Mending>,
}

/// A `fix` of the standard.
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Mending {
    description: Message,
    artifact_changes: [ArtifactChange; 1],
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct ArtifactChange {
    artifact_location: ArtifactLocation,
    replacements: [Replacement; 1],
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Replacement {
    deleted_region: Region,
    inserted_content: Message,
}

#[derive(Serialize)]
struct Fingerprints {
    #[serde(rename = "primaryLocationLineHash")]
    line: String,
    #[serde(rename = "rederive/v1")]
    own: String,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Location {
    physical_location: PhysicalLocation,
    /// Of a related one: the message names it by its number, and says what is there.
    #[serde(flatten)]
    related: Option<Related>,
}

#[derive(Serialize)]
struct Related {
    id: usize,
    message: Message,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct PhysicalLocation {
    artifact_location: ArtifactLocation,
    region: Region,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct ArtifactLocation {
    uri: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    uri_base_id: Option<&'static str>,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Region {
    start_line: usize,
    #[serde(flatten)]
    columns: Option<Columns>,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Columns {
    start_column: usize,
    end_line: usize,
    end_column: usize,
}

/// A log with one run, as text.
pub fn sarif(findings: &[Finding]) -> String {
    let mut rules: Vec<&'static str> = findings.iter().map(|f| f.rule).collect();
    rules.sort_unstable();
    rules.dedup();
    let mut seen: BTreeMap<String, usize> = BTreeMap::new();
    let results = findings.iter().map(|f| {
        let fingerprint = f.fingerprint();
        let nth = seen.entry(fingerprint.clone()).or_insert(0);
        *nth += 1;
        outcome(f, &rules, &format!("{fingerprint}:{nth}"))
    });
    let results = results.collect();
    let driver = Driver {
        name: crate::PROGRAM,
        semantic_version: env!("CARGO_PKG_VERSION"),
        rules: rules.into_iter().map(rule).collect(),
    };
    let log = Log {
        schema: "https://json.schemastore.org/sarif-2.1.0.json",
        version: "2.1.0",
        runs: [Run { tool: Tool { driver }, column_kind: "utf16CodeUnits", results }],
    };
    let mut text = serde_json::to_string_pretty(&log).unwrap_or_default();
    text.push('\n');
    in_json(text)
}

fn rule(id: &'static str) -> Rule {
    let level = match id {
        "verdict::undecided" | "verdict::nothing-decided" => Level::Warning,
        "paper::not-covered" | "verdict::drawn" => Level::Note,
        _ => Level::Error,
    };
    let says = rule_says(id);
    Rule {
        id,
        // The name of a rule is written without colons and hyphens.
        name: id.split([':', '-']).map(capitalized).collect(),
        short_description: Message::new(says),
        full_description: Message::new(says),
        help: Message::new(format!("{says} The page on continuous integration lists every rule.")),
        default_configuration: Configuration { level: level.word() },
    }
}

fn capitalized(word: &str) -> String {
    let mut chars = word.chars();
    chars.next().map(|c| c.to_ascii_uppercase()).into_iter().chain(chars).collect()
}

fn outcome(finding: &Finding, rules: &[&str], fingerprint: &str) -> Outcome {
    let mut related = Vec::new();
    let mut message = escaped(&finding.message);
    for (id, (place, words)) in (1..).zip(&finding.related) {
        let words = escaped(words);
        message.push_str(&format!(" [{words}]({id})."));
        related.push(location(place, Some(Related { id, message: Message::new(words) })));
    }
    Outcome {
        rule_id: finding.rule,
        rule_index: rules.iter().position(|r| *r == finding.rule),
        level: finding.level.word(),
        message: Message::new(message),
        locations: [location(&finding.place, None)],
        partial_fingerprints: Fingerprints { line: fingerprint.to_owned(), own: fingerprint.to_owned() },
        related_locations: related,
        fixes: finding.fix.iter().map(mending).collect(),
    }
}

fn mending(fix: &Fix) -> Mending {
    let PhysicalLocation { artifact_location, region } = location(&fix.place, None).physical_location;
    let replacement = Replacement { deleted_region: region, inserted_content: Message::new(fix.text.clone()) };
    Mending {
        description: Message::new(escaped(&format!("{}: {}", fix.says, fix.text))),
        artifact_changes: [ArtifactChange { artifact_location, replacements: [replacement] }],
    }
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

fn location(place: &Place, related: Option<Related>) -> Location {
    let path = &place.source.path;
    let inside = !path.starts_with('/') && !path.starts_with("..");
    let artifact_location = ArtifactLocation { uri: uri(path), uri_base_id: inside.then_some("%SRCROOT%") };
    let region = place.region();
    let columns =
        region.as_ref().map(|r| Columns { start_column: r.column, end_line: r.end_line, end_column: r.end_column });
    // Code scanning needs a line: that of a file as a whole is the first.
    let region = Region { start_line: region.map_or(1, |r| r.line), columns };
    Location { physical_location: PhysicalLocation { artifact_location, region }, related }
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
