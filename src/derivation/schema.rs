//! The JSON Schema of derivation files, for editors that complete and check TOML.
//!
//! Its keys are those of [`keys`], from which the loader reads, so the two cannot drift apart.

use serde_json::{Map, Value, json};

use super::keys::{self, Key, Kind};

/// What a key may have as its value, and what it means.
fn described(key: &Key) -> Value {
    let defined = |name: &str| json!({ "$ref": format!("#/definitions/{name}") });
    let many = |of: Value| json!({ "type": "array", "items": of });
    let named = |of: Value| json!({ "type": "object", "additionalProperties": of });
    let mut out = match key.kind {
        Kind::Text => json!({ "type": "string" }),
        Kind::Texts => many(json!({ "type": "string" })),
        Kind::Id => defined("id"),
        Kind::Formula => defined("formula"),
        Kind::Formulas => defined("formulas"),
        Kind::Value => defined("value"),
        Kind::Pair => json!({ "type": "array", "items": defined("value"), "minItems": 2, "maxItems": 2 }),
        Kind::Values => named(defined("value")),
        Kind::Flag => json!({ "type": "boolean" }),
        Kind::Words(words) => json!({ "enum": words }),
        Kind::Positive => json!({ "type": "number", "exclusiveMinimum": 0 }),
        Kind::Whole(least) => json!({ "type": "integer", "minimum": least }),
        Kind::Part(name) => defined(name),
        Kind::Parts(name) => many(defined(name)),
        Kind::Named(name) => named(defined(name)),
        Kind::Other(schema) => schema(),
    };
    out["description"] = key.says.into();
    out
}

/// A table with the keys that the loader knows.
fn object(tables: &[&str], needed: &[&str]) -> Value {
    let mut properties = Map::new();
    for key in keys::TABLES.iter().filter(|(table, _)| tables.contains(table)).flat_map(|(_, keys)| *keys) {
        properties.insert(key.name.to_owned(), described(key));
    }
    json!({ "type": "object", "properties": properties, "required": needed, "additionalProperties": false })
}

/// The schema, in draft 7 of JSON Schema, which editors of TOML know.
pub fn schema() -> Value {
    let reading = "[[claim]] and [[claim.reading]]";
    let mut file = object(&["file"], &["derivation", "symbols"]);
    let expect = object(&["expect"], &[]);
    let definitions = json!({
        "id": {
            "type": "string", "pattern": "^[A-Za-z0-9][A-Za-z0-9._-]*$", "maxLength": 100,
            "description": "Letters, digits, -, _ and ., beginning with a letter or digit",
        },
        "formula": { "type": "string", "description": "LaTeX, in single quotes" },
        "formulas": { "type": "array", "items": { "$ref": "#/definitions/formula" } },
        "value": {
            "description": "A number, a formula in single quotes, or an array of them",
            "anyOf": [
                { "type": "number" },
                { "type": "string" },
                { "type": "array", "items": { "$ref": "#/definitions/value" } },
            ],
        },
        "initial": {
            "description": "A number, a formula in single quotes, a guess of what the constraints determine, or an array of these",
            "anyOf": [
                { "type": "number" },
                { "type": "string" },
                object(&["initial"], &["near"]),
                { "type": "array", "items": { "$ref": "#/definitions/initial" } },
            ],
        },
        "derivation": object(&["[derivation]"], &["title", "concerns"]),
        "symbol": object(&["[symbols]"], &["role"]),
        "system": object(&["[system.…]"], &["equations"]),
        "trajectory": object(&["[[trajectory]]"], &["id"]),
        "family": object(&["[[family]]"], &["id", "of", "vary"]),
        "domain": object(&["[[domain]]"], &["id", "ranges"]),
        "varied": object(&["vary"], &[]),
        "claim": object(&[reading, "[[claim]]"], &["id", "says"]),
        "reading": object(&[reading], &["id", "says"]),
        "at": { "anyOf": [{ "$ref": "#/definitions/formula" }, object(&["at"], &["when"])] },
        "same-motion": object(&["same-motion"], &["as", "of"]),
        "independent": object(&["independent"], &["functions"]),
        "independent-of": object(&["independent-of"], &["of", "with"]),
        "scales-as": object(&["scales-as"], &["of", "with", "power", "to"]),
        "monotone": object(&["monotone"], &["of", "with", "direction"]),
        "extremum": object(&["extremum"], &["of", "with", "kind", "at", "to"]),
        "limit": object(&["limit"], &["of", "with", "tends-to", "value", "to"]),
        "exists": object(&["exists"], &["unknowns", "such-that"]),
        "expect": { "anyOf": [{ "enum": keys::EXPECT }, expect] },
        "measure": object(&["[[measure]]"], &["id", "says", "formula"]),
        "condition": object(&["[[condition]]"], &["id", "says", "holds"]),
        "picture": object(&["[[picture]]"], &["id", "says", "kind", "show"]),
    });
    let mut out = Map::new();
    out.insert("$schema".to_owned(), json!("http://json-schema.org/draft-07/schema#"));
    out.insert("title".to_owned(), json!("A derivation file of rederive"));
    if let Some(file) = file.as_object_mut() {
        out.append(file);
    }
    out.insert("definitions".to_owned(), definitions);
    Value::Object(out)
}
