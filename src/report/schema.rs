//! The JSON Schema of `report.json`.
//!
//! Every field that [`json`](super::json) writes is listed, and a test holds each report that the project has against the
//! list. Readers should pass over fields that they do not know: within one value of `schema` fields are only added.

use serde_json::{Map, Value, json};

fn text(says: &str) -> Value {
    json!({ "type": "string", "description": says })
}

fn text_or_null(says: &str) -> Value {
    json!({ "type": ["string", "null"], "description": says })
}

fn texts(says: &str) -> Value {
    json!({ "type": "array", "items": { "type": "string" }, "description": says })
}

fn number(says: &str) -> Value {
    json!({ "type": ["number", "null"], "description": format!("{says}; null where it is no number") })
}

fn numbers(says: &str) -> Value {
    json!({ "type": "array", "items": { "type": ["number", "null"] }, "description": says })
}

fn whole(says: &str) -> Value {
    json!({ "type": "integer", "minimum": 0, "description": says })
}

fn flag(says: &str) -> Value {
    json!({ "type": "boolean", "description": says })
}

/// An object in which every field is there.
fn object(fields: &[(&str, Value)]) -> Value {
    let required: Vec<&str> = fields.iter().map(|(name, _)| *name).collect();
    let properties: Map<String, Value> = fields.iter().map(|(n, v)| ((*n).to_owned(), v.clone())).collect();
    json!({ "type": "object", "properties": properties, "required": required })
}

fn or_null(value: Value) -> Value {
    json!({ "anyOf": [value, { "type": "null" }] })
}

fn list(value: Value) -> Value {
    json!({ "type": "array", "items": value })
}

/// Fields that may be missing.
fn with_optional(mut object: Value, fields: &[(&str, Value)]) -> Value {
    for (name, value) in fields {
        object["properties"][*name] = value.clone();
    }
    object
}

/// The schema, in draft 7 of JSON Schema.
pub fn schema() -> Value {
    let verdicts = ["holds", "fails", "not-applicable", "undecided"];
    let mut expected: Vec<Value> = verdicts.iter().map(|v| json!(v)).collect();
    expected.push(Value::Null);
    let derivation = object(&[
        ("id", text("Short name")),
        ("title", text("Title")),
        ("sha256", text("SHA-256 of the derivation file")),
        ("concerns", text("The citation of what is checked")),
        ("source", text_or_null("Where the paper can be found")),
        ("remark", text_or_null("What a reader should know")),
        ("conventions", json!({ "type": "object", "additionalProperties": { "type": "string" } })),
    ]);
    let trajectory = object(&[
        ("id", text("Its id")),
        ("title", text("Its title; the id where none is given")),
        ("span", numbers("First and last time")),
        ("source", json!({ "enum": ["integrated", "formula", "derived"] })),
        ("given", json!({ "type": "object", "additionalProperties": numbers("Components") })),
        ("steps", whole("Steps of the integrator, 0 for formulas")),
        ("error", number("Largest error estimate of a state component over the span")),
        ("problem", text_or_null("Why it ends early or could not be computed")),
    ]);
    let identity = object(&[
        ("verdict", json!({ "enum": ["proved", "refuted", "undecided"] })),
        ("log2_error", number("log2 of the bound for the probability that a proof is wrong")),
        ("from", texts("What was given: ids of claims and systems")),
        ("conditions", texts("What has to hold for the formulas to have values")),
        ("generic", flag("Whether the proof leaves out special cases of what is given")),
        ("reason", text_or_null("Why undecided; a remark on a proof")),
        ("witness", text_or_null("A point at which everything given holds and the claim does not")),
    ]);
    let residual = object(&[
        ("max", number("|left − right| at the worst point")),
        ("bound", number("Its error bound there")),
        ("at", number("The time")),
    ]);
    let witness = object(&[
        ("t", number("The time")),
        ("formula", text("What is compared")),
        ("left", number("Value of the left side")),
        ("right", number("Value of the right side")),
        ("bound", number("Error bound of their difference")),
        ("values", json!({ "type": "object", "additionalProperties": number("What the sides depend on") })),
    ]);
    let excluded = object(&[
        ("from", number("First time left out")),
        ("to", number("Last time left out")),
        ("reason", text("Why")),
    ]);
    let discrimination = object(&[
        ("rejected", whole("Variants of the claim that the same evidence rejects")),
        ("of", whole("Variants that were tried")),
    ]);
    let result = object(&[
        ("trajectory", text("Id of the trajectory")),
        ("verdict", json!({ "enum": verdicts })),
        ("strength", json!({ "enum": ["sampled", "enclosed", "certified", "proved", null] })),
        ("expected", json!({ "enum": expected })),
        ("unexpected", flag("Whether the verdict is not as expected")),
        ("residual", or_null(residual)),
        ("samples", whole("Times at which the claim was compared")),
        ("reason", text_or_null("Why not applicable or undecided; a remark otherwise")),
        ("branch", text_or_null("For ±: which sign")),
        ("excluded", list(excluded)),
        ("discrimination", or_null(discrimination)),
        ("witness", or_null(witness)),
    ]);
    let kinds = json!({ "type": ["array", "null"], "items": { "type": "string" } });
    let claim = object(&[
        ("id", text("Its id")),
        ("reading", text_or_null("Id of the reading")),
        ("says", text("The claim in words")),
        ("formulas", texts("As written")),
        ("kinds", kinds),
        ("place", text_or_null("Where it stands in the paper")),
        ("label", text_or_null("The label of its equation")),
        ("assumptions", texts("As written")),
        ("follows_from", json!({ "type": ["array", "null"], "items": { "type": "string" } })),
        ("precision", number("The relative precision that was asked for")),
        ("remark", text_or_null("What a reader should know")),
        ("identity", or_null(identity)),
        ("results", list(result)),
    ]);
    let measured = object(&[("t", number("Time")), ("value", number("Value")), ("bound", number("Error bound"))]);
    let measurement = object(&[
        ("measure", text("Id of the measure")),
        ("trajectory", text("Id of the trajectory")),
        ("values", list(measured)),
        ("reason", text_or_null("Why there is none, or not all")),
    ]);
    let summary = object(&[
        ("holds", whole("Pairs of claim and trajectory that hold")),
        ("fails", whole("Pairs that fail")),
        ("not_applicable", whole("Pairs to which the claim does not apply")),
        ("undecided", whole("Pairs that stay undecided")),
        ("unexpected", whole("Pairs that are not as expected")),
    ]);
    let report = object(&[
        ("schema", json!({ "const": 1 })),
        ("tool", object(&[("name", text("rederive")), ("version", text("Its version"))])),
        ("derivation", derivation),
        ("trajectories", list(trajectory)),
        ("claims", list(claim)),
        ("measurements", list(measurement)),
        ("summary", summary),
    ]);
    let report = with_optional(report, &[("paper", paper())]);
    let mut out = Map::new();
    out.insert("$schema".to_owned(), json!("http://json-schema.org/draft-07/schema#"));
    out.insert("title".to_owned(), json!("A report of rederive"));
    if let Value::Object(mut fields) = report {
        out.append(&mut fields);
    }
    Value::Object(out)
}

/// The comparison with the paper, there if `--source` was given.
fn paper() -> Value {
    let difference = object(&[
        ("claim", text("Who has the formula")),
        ("label", text("The label that it names")),
        ("formula", text("As the derivation file has it")),
        ("printed", text("What the paper prints")),
        ("line", whole("Line of the paper")),
    ]);
    let equation = object(&[
        ("label", text_or_null("Its label")),
        ("line", whole("Line of the paper")),
        ("parts", whole("How many parts it has")),
        ("printed", whole("How many of them the derivation file has as printed")),
        ("claims", texts("Claims and systems that are about it")),
    ]);
    object(&[
        ("sha256", text("SHA-256 of the paper's source")),
        ("compared", whole("Formulas that were compared")),
        ("differences", list(difference)),
        ("unknown_labels", list(object(&[("claim", text("Who names it")), ("label", text("The label"))]))),
        ("equations", list(equation)),
        (
            "coverage",
            object(&[
                ("equations", whole("Displayed equations")),
                ("covered", whole("Of these, covered")),
                ("parts", whole("Parts of the displayed equations")),
                ("printed", whole("Of these, in the derivation file as printed")),
                ("relations", whole("Relations of the running text")),
                ("found", whole("Of these, in the derivation file word for word")),
            ]),
        ),
    ])
}
