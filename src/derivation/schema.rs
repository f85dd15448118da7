//! The JSON Schema of derivation files, for editors that complete and check TOML.
//!
//! Its keys are those of [`keys`], from which the loader reads, so the two cannot drift apart: a key without a description
//! here is allowed with any value, and [`undescribed`] names it, which a test forbids.

use serde_json::{Map, Value, json};

use super::keys;
use super::role::ClaimRole;

/// What a key may have as its value, and what it means. `table` is a name of [`keys::ALL`].
fn describe(table: &str, key: &str) -> Option<Value> {
    let text = |says: &str| json!({ "type": "string", "description": says });
    let formula = |says: &str| json!({ "$ref": "#/definitions/formula", "description": says });
    let formulas = |says: &str| json!({ "$ref": "#/definitions/formulas", "description": says });
    let id = |says: &str| json!({ "$ref": "#/definitions/id", "description": says });
    let ids = |says: &str| json!({ "type": "array", "items": { "type": "string" }, "description": says });
    let flag = |says: &str| json!({ "type": "boolean", "description": says });
    let value = |says: &str| json!({ "$ref": "#/definitions/value", "description": says });
    let values = |says: &str| json!({ "type": "object", "additionalProperties": { "$ref": "#/definitions/value" }, "description": says });
    let part = |name: &str, says: &str| json!({ "$ref": format!("#/definitions/{name}"), "description": says });
    let many = |name: &str, says: &str| json!({ "type": "array", "items": { "$ref": format!("#/definitions/{name}") }, "description": says });
    let named = |name: &str, says: &str| {
        let of = json!({ "$ref": format!("#/definitions/{name}") });
        json!({ "type": "object", "additionalProperties": of, "description": says })
    };
    Some(match (table, key) {
        ("file", "derivation") => part("derivation", "What is checked"),
        ("file", "conventions") => json!({
            "type": "object", "additionalProperties": { "type": "string" },
            "description": "Any names with any texts: the report shows them",
        }),
        ("file", "symbols") => named("symbol", "Every symbol of the formulas, under its LaTeX name in single quotes"),
        ("file", "system") => named("system", "Systems of differential equations, each under its id"),
        ("file", "trajectory") => many("trajectory", "Motions on which claims are tried"),
        ("file", "family") => many("family", "Many motions from one, by values that vary"),
        ("file", "domain") => many("domain", "Boxes of values, with formulas for fields, that claims share"),
        ("file", "claim") => many("claim", "What the paper claims"),
        ("file", "condition") => many("condition", "Conditions that may explain where a claim holds"),
        ("file", "picture") => many("picture", "Pictures of the motions for the report"),
        ("file", "measure") => many("measure", "Quantities to be measured"),
        ("[derivation]", "id") => id("Name of the report's folder; without it, the file's name without .toml"),
        ("[derivation]", "title") => text("What the report is called"),
        ("[derivation]", "concerns") => text("The citation of what is checked"),
        ("[derivation]", "source") => text("Where the paper can be found"),
        ("[derivation]", "remark") => text("What a reader of the report should know"),
        ("[derivation]", "encoded-by") => text("Who wrote the file: sentences and remarks are theirs"),
        ("[symbols]", "role") => json!({
            "enum": ["time", "state", "parameter", "observable", "abbreviation", "coordinate", "field", "constant"], "description": "What the symbol is",
        }),
        ("[symbols]", "shape") => json!({
            "type": ["string", "integer"],
            "description": "\"3\" for a vector, \"3x3\" for a matrix, \"diagonal 3\" for a diagonal matrix; nothing for a scalar",
        }),
        ("[symbols]", "unit") => text("Its unit"),
        ("[symbols]", "positive") => flag("Every component is positive"),
        ("[symbols]", "complex") => flag("Its values are complex numbers"),
        ("[symbols]", "angle") => flag("Its values along a motion are continued without jumps by 2π"),
        ("[symbols]", "formula") => formula("The definition of an observable or abbreviation"),
        ("[symbols]", "scale") => formula("The scale factor of a coordinate that is not Cartesian"),
        ("[symbols]", "momentum-of") => formula("The coordinate to which this momentum belongs"),
        ("[symbols]", "velocity") => flag("The field with which the derivative D/Dt moves"),
        ("[symbols]", "arguments") => formulas("Names of arguments: the abbreviation is then a function"),
        ("[symbols]", "says") => text("What it stands for"),
        ("[system.…]", "says") => text("What the system is"),
        ("[system.…]", "label") => text("The label of its equations in the paper's source"),
        ("[system.…]", "states") => ids("The unknowns of equations of motion"),
        ("[system.…]", "fields") => ids("The unknowns of partial differential equations"),
        ("[system.…]", "equations") => formulas("The equations, one or several in a string; only plain ="),
        ("[[trajectory]]", "id") => id("Its id"),
        ("[[trajectory]]", "title") => text("For the reader"),
        ("[[trajectory]]", "says") => text("For the reader"),
        ("[[trajectory]]", "system") => text("Integrated: the id of the system"),
        ("[[trajectory]]", "initial") => json!({
            "type": "object", "additionalProperties": { "$ref": "#/definitions/initial" },
            "description": "Integrated: the value of every state at the initial time",
        }),
        ("[[trajectory]]", "constraints") => {
            formulas("Equations between the initial values: those that are guessed are solved for")
        }
        ("initial", "near") => value("A guess: the value is the solution of the constraints near to it"),
        ("initial", "within") => value("How far it may be from the guess; half of it unless given"),
        ("[[trajectory]]", "formula") => values("Given by formulas: every state, in terms of time and parameters"),
        ("[[trajectory]]", "from") => text("Computed from another trajectory: its id"),
        ("[[trajectory]]", "map") => values("With `from`: states in terms of those of the other trajectory"),
        ("[[trajectory]]", "parameters") => values("Values of parameters"),
        ("[[trajectory]]", "span") => json!({
            "type": "array", "items": { "$ref": "#/definitions/value" }, "minItems": 2, "maxItems": 2,
            "description": "First and last time",
        }),
        ("[[trajectory]]", "initial-time") => value("The time of the initial values"),
        ("[[family]]", "id") => id("Its id; no trajectory has it"),
        ("[[family]]", "title") => text("Its title"),
        ("[[family]]", "says") => text("For the reader"),
        ("[[family]]", "of") => text("The trajectory whose values are varied: its id"),
        ("[[family]]", "vary") => named("varied", "Parameters and initial values, each with how it varies"),
        ("[[family]]", "draws") => json!({
            "type": "integer", "minimum": 1, "description": "How many members are drawn, for each point of the grid",
        }),
        ("[[family]]", "seed") => json!({
            "type": "integer", "minimum": 0, "description": "Which draws: the same seed gives the same members everywhere",
        }),
        ("[[family]]", "sequence") => json!({
            "enum": ["random", "low-discrepancy"],
            "description": "How values are drawn: at random, which is so unless given, or from a sequence that fills space evenly",
        }),
        ("[[family]]", "where") => {
            formulas("Inequalities that every member satisfies; others are rejected and counted")
        }
        ("[[family]]", "map") => json!({
            "type": "array", "items": { "type": "string" }, "minItems": 2, "maxItems": 2,
            "description": "Two symbols of `vary`, to the right and upwards: the report shows where over these a claim holds",
        }),
        ("[[family]]", "boundary") => json!({
            "type": "object", "additionalProperties": { "type": "number", "exclusiveMinimum": 0 },
            "description": "Symbols of the map, each with the width to which the edge of where a claim holds is found along it",
        }),
        ("[[domain]]", "id") => id("Its id"),
        ("[[domain]]", "says") => text("For the reader"),
        ("[[domain]]", "ranges") => {
            values("[from, to] for a range, one number or formula for a fixed value or a field")
        }
        ("vary", "from") => value("The first of several values in a row"),
        ("vary", "to") => value("The last of them"),
        ("vary", "count") => json!({ "type": "integer", "minimum": 2, "description": "How many there are" }),
        ("vary", "spacing") => json!({
            "enum": ["linear", "logarithmic"],
            "description": "Whether neighbours have the same difference, which is so unless given, or the same ratio",
        }),
        ("vary", "values") => json!({
            "type": "array", "items": { "$ref": "#/definitions/value" }, "minItems": 1, "description": "These values",
        }),
        ("vary", "uniform" | "log-uniform" | "polar" | "normal") => json!({
            "type": "array", "items": { "$ref": "#/definitions/value" }, "minItems": 2, "maxItems": 2,
            "description": match key {
                "uniform" => "Drawn: the ends of a range in which all values are equally likely",
                "log-uniform" => "Drawn: the ends of a range in which all logarithms are equally likely",
                "polar" => "Drawn: the ends of a range of angles from a pole of a sphere, whose cosines are equally likely",
                _ => "Drawn from a normal distribution: mean and standard deviation",
            },
        }),
        ("[[claim]] and [[claim.reading]]", key) => match key {
            "id" => id("Its id"),
            "says" => text("The claim in your own words; $…$ around a formula"),
            "remark" => text("What a reader should know, for instance why it fails"),
            "printed" => flag("false: the formulas are a variant of what the paper prints under the label"),
            "role" => json!({
                "enum": ClaimRole::ALL.map(ClaimRole::word),
                "description": "What it is to the paper: what the paper says (unless given), may mean or needs, what is against \
                    it, what was added to compare, a lemma of the file, or a choice of the paper",
            }),
            "added" => flag("true: short for role = \"added\": the paper does not say it; it was added for comparison"),
            "symbols" => named("symbol", "Symbols for this claim only"),
            "assuming" => formulas("Relations without which the claim does not apply"),
            "follows-from" => ids("Claims, systems and symbols from which it follows"),
            "precision" => json!({
                "type": "number", "exclusiveMinimum": 0, "exclusiveMaximum": 1,
                "description": "The relative precision that is asked for, 1e-9 unless given",
            }),
            "branches" => json!({
                "enum": ["pointwise", "throughout"],
                "description": "For ±: some sign at each time, or one sign for the whole motion",
            }),
            "trajectories" => ids("Where it is tried; all unless given"),
            "families" => ids("Families of motions on which it is tried"),
            "always" => formulas("These relations hold at every time"),
            "never" => formulas("These relations hold at no time"),
            "eventually" => formulas("These relations hold at some time"),
            "first-integral" => formulas("These expressions are constant along the motion"),
            "defined" => formulas("These expressions have a real value at every time"),
            "solves" => text("The motion solves this system: its id"),
            "same-motion" => part("same-motion", "The motion is that of another trajectory"),
            "independent" => part("independent", "Functions of the states are independent of one another"),
            "exists" => part("exists", "Equations have a solution in a box"),
            "independent-of" => {
                part("independent-of", "A quantity is the same for members of a family that differ in a symbol")
            }
            "scales-as" => part("scales-as", "A quantity is a power of a symbol that a family varies"),
            "monotone" => part("monotone", "A quantity grows, or falls, with a symbol that a family varies"),
            "extremum" => {
                part("extremum", "A quantity is largest, or smallest, at a value of a symbol that a family varies")
            }
            "limit" => part("limit", "A quantity tends to a value as a symbol that a family varies tends to one"),
            "domain" => text("The claim is about the values of this domain: its id"),
            "ranges" => values(
                "The claim is about all these values, and no motion: [from, to] for a range, one number or formula for a fixed value",
            ),
            "at" => part(
                "at",
                "When the claim is tried: an equation between scalars, or which of the times at which it holds",
            ),
            "expect-units" => json!({
                "enum": ["inconsistent"], "description": "The units of its formulas are expected not to agree",
            }),
            "expect" => part("expect", "The expected verdict: one word, or trajectories for each verdict"),
            _ => return None,
        },
        ("[[claim]]", "place") => text("Where it stands in the paper"),
        ("[[claim]]", "label") => text("The label of its equation in the paper's source"),
        ("[[claim]]", "conclusion") => flag("true: it is something that the paper concludes"),
        ("[[claim]]", "rests-on") => {
            ids("Claims on which the paper's argument for it rests; nothing is proved from them")
        }
        ("[[claim]]", "reading") => many("reading", "The ways in which the claim can be understood"),
        ("same-motion", "as") => text("The id of the other trajectory"),
        ("same-motion", "of") => ids("The states that are compared"),
        ("independent-of" | "scales-as" | "monotone" | "extremum" | "limit", "of") => {
            formula("The quantity, one number of each member")
        }
        ("independent-of" | "scales-as" | "monotone" | "extremum" | "limit", "with") => {
            text("The symbol that the family varies")
        }
        ("scales-as", "power") => json!({ "type": "number", "description": "The slope of the logarithms" }),
        ("scales-as", "to") => json!({
            "type": "number", "exclusiveMinimum": 0, "description": "How far the slope may be off",
        }),
        ("monotone", "direction") => json!({
            "enum": ["increasing", "decreasing"], "description": "With larger values of the symbol the quantity is larger, or smaller",
        }),
        ("extremum", "kind") => {
            json!({ "enum": ["maximum", "minimum"], "description": "Whether it is largest or smallest" })
        }
        ("extremum", "at") => {
            json!({ "$ref": "#/definitions/value", "description": "The value of the symbol at which it is" })
        }
        ("extremum", "to") => json!({
            "type": "number", "exclusiveMinimum": 0, "description": "From which distance on other values of the symbol are compared",
        }),
        ("limit", "tends-to") => json!({
            "$ref": "#/definitions/value", "description": "What the symbol tends to: a number, '\\infty' or '-\\infty'",
        }),
        ("limit", "value") => json!({ "$ref": "#/definitions/value", "description": "The limit" }),
        ("limit", "to") => json!({
            "type": "number", "exclusiveMinimum": 0, "description": "How far the limit may be off",
        }),
        ("independent", "functions") => formulas("The functions"),
        ("independent", "subject-to") => formulas("Equations that hold between the states anyway"),
        ("exists", "unknowns") => {
            values("The unknowns, each with the range [from, to] in which a solution is looked for")
        }
        ("exists", "such-that") => {
            formulas("As many equations as unknowns, and other relations that a solution satisfies")
        }
        ("exists", "unique") => flag("There is one solution only"),
        ("expect", "holds" | "fails" | "not-applicable" | "undecided") => json!({
            "anyOf": [{ "enum": ["all", "others"] }, { "type": "array", "items": { "type": "string" } }],
            "description": "Trajectories and families on which this verdict is expected",
        }),
        ("[[measure]]", "id") => id("Its id"),
        ("[[measure]]", "says") => text("What it is"),
        ("[[measure]]", "formula") => formula("A scalar"),
        ("[[measure]]", "at") => part("at", "When it is taken; without it, at the initial time"),
        ("at", "when") => formula("An equation between scalars"),
        ("at", "direction") => json!({
            "enum": ["up", "down"], "description": "The times at which left − right changes its sign, from − to + or from + to −",
        }),
        ("at", "count") => json!({
            "type": "integer", "minimum": 1, "description": "The n-th of them after the start of the span",
        }),
        ("[[measure]]", "since") => {
            part("at", "Another event: what is taken is taken between the last of it before `at`, and `at`")
        }
        ("[[measure]]", "take") => json!({
            "enum": ["change", "mean"],
            "description": "With `since`: the change of the quantity, which is so unless given, or its mean over the time between",
        }),
        ("[[measure]]", "trajectories") => ids("Where it is measured; all unless given"),
        ("[[measure]]", "families") => ids("Families on whose members it is measured, too"),
        ("[[measure]]", "unit") => text("Its unit"),
        ("[[condition]]", "id") => id("Its id"),
        ("[[condition]]", "says") => text("What it is, in words"),
        ("[[condition]]", "holds") => formulas("It is met where all of these hold at every time"),
        ("[[picture]]", "id") => id("Its id"),
        ("[[picture]]", "says") => text("What it shows"),
        ("[[picture]]", "kind") => json!({
            "enum": ["time", "curve", "sphere"],
            "description": "Quantities against time, one against another, or three of constant length",
        }),
        ("[[picture]]", "show") => formulas("The quantities"),
        ("[[picture]]", "slopes") => formulas("For a curve: slopes that are claimed of it"),
        ("[[picture]]", "levels") => formula("For a sphere: a function whose level sets are drawn"),
        ("[[picture]]", "trajectories") => ids("Of which it is drawn; all unless given"),
        _ => return None,
    })
}

/// A table with the keys that the loader knows.
fn object(tables: &[&str], needed: &[&str]) -> Value {
    let mut properties = Map::new();
    for (table, keys) in keys::ALL.iter().filter(|(table, _)| tables.contains(table)) {
        for key in *keys {
            properties.insert((*key).to_owned(), describe(table, key).unwrap_or_else(|| json!({})));
        }
    }
    json!({ "type": "object", "properties": properties, "required": needed, "additionalProperties": false })
}

/// The tables of [`keys::ALL`] that the schema has.
const TABLES: &[&str] = &[
    "file",
    "[derivation]",
    "[symbols]",
    "[system.…]",
    "[[trajectory]]",
    "initial",
    "[[family]]",
    "[[domain]]",
    "vary",
    "[[claim]] and [[claim.reading]]",
    "[[claim]]",
    "at",
    "same-motion",
    "independent",
    "exists",
    "independent-of",
    "scales-as",
    "monotone",
    "extremum",
    "limit",
    "expect",
    "[[measure]]",
    "[[condition]]",
    "[[picture]]",
];

/// Keys that the loader knows and the schema does not describe: table and key. A test wants it empty.
pub fn undescribed() -> Vec<(&'static str, &'static str)> {
    let mut out = Vec::new();
    for (table, keys) in keys::ALL {
        let missing = keys.iter().filter(|key| !TABLES.contains(table) || describe(table, key).is_none());
        out.extend(missing.map(|key| (*table, *key)));
    }
    out
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
