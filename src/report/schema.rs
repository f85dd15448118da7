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

fn number_or_null(says: &str) -> Value {
    json!({ "type": ["number", "null"], "description": says })
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
        ("encoded_by", text_or_null("Who wrote the file")),
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
        (
            "standing",
            json!({
                "enum": ["proved", "proved except", "proved given", "refuted", "undecided"],
                "description": "The verdict in full: whether a proof leaves cases out, or follows from what is not proved",
            }),
        ),
        (
            "conditional_on",
            list(object(&[
                ("id", text("A claim that it follows from, through all steps, and that is not proved")),
                (
                    "standing",
                    text_or_null("What that claim's own step came to; null where it is no question for all values"),
                ),
            ])),
        ),
        ("log2_error", number("log2 of the bound for the probability that a proof is wrong")),
        ("from", texts("What was given: ids of claims and systems")),
        ("conditions", texts("What has to hold for the formulas to have values")),
        ("exceptions", texts("What the proof does not reach")),
        ("given_only_where", texts("Where alone what is given can hold, special cases aside")),
        (
            "assumptions",
            or_null(object(&[
                ("used", texts("Assumptions of the claim that the proof needs")),
                ("unused", texts("Assumptions of the claim that it does not need")),
            ])),
        ),
        ("presupposed", texts("Assumptions of what is given that the claim does not make itself")),
        ("generic", flag("Whether the proof leaves out special cases of what is given")),
        ("reason", text_or_null("Why undecided; a remark on a proof")),
        ("witness", text_or_null("A point at which everything given holds and the claim does not")),
        ("branch", text_or_null("For ±: the sign it holds for")),
        ("trials", or_null(trials())),
        ("certificate", text_or_null("The file in `certificates` that proves it exactly")),
        ("no_certificate", text_or_null("Why there is none, where one was looked for")),
    ]);
    let residual = object(&[
        ("max", number("|left − right| at the worst point")),
        ("bound", number("Its error bound there")),
        ("at", number("The time")),
    ]);
    let witness = object(&[
        ("t", number("The time")),
        ("formula", text("What is compared")),
        ("left", number_or_null("Value of the left side; null where it has none")),
        ("right", number_or_null("Value of the right side; null where it has none")),
        ("difference", number_or_null("|left − right|, of these numbers")),
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
        ("weak", flag("Whether so few are rejected that the verdict says little")),
        ("survivors", text("Numbers in `variants.survivors`, in ranges, such as 0-3,7")),
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
        ("witness", or_null(witness.clone())),
    ]);
    let kinds = json!({ "type": ["array", "null"], "items": { "type": "string" } });
    let claim = object(&[
        ("id", text("Its id")),
        ("reading", text_or_null("Id of the reading")),
        ("says", text("The claim in words")),
        ("formulas", texts("As written")),
        ("kinds", kinds),
        ("role", text("What it is to the paper: says, may-mean, needs, against, added, lemma or choice")),
        ("added", flag("Whether the paper does not say it: it was added for comparison")),
        ("conclusion", flag("Whether the paper concludes it")),
        ("rests_on", texts("Claims on which the paper's argument for it rests")),
        ("place", text_or_null("Where it stands in the paper")),
        ("label", text_or_null("The label of its equation")),
        ("assumptions", texts("As written")),
        ("follows_from", json!({ "type": ["array", "null"], "items": { "type": "string" } })),
        ("precision", number("The relative precision that was asked for")),
        ("remark", text_or_null("What a reader should know")),
        ("identity", or_null(identity)),
        ("variants", or_null(variants())),
        ("conditions", conditions()),
        ("results", list(result)),
    ]);
    let of_families = list(family(&verdicts, &expected, &witness));
    let claim = with_optional(claim, &[("region", or_null(region(&verdicts, &expected))), ("families", of_families)]);
    let measured = object(&[("t", number("Time")), ("value", number("Value")), ("bound", number("Error bound"))]);
    let measurement = object(&[
        ("measure", text("Id of the measure")),
        ("trajectory", text("Id of the trajectory")),
        ("values", list(measured)),
        ("reason", text_or_null("Why there is none, or not all")),
    ]);
    let extreme = object(&[
        ("number", whole("The number of the member")),
        ("values", json!({ "type": "object", "additionalProperties": number("Value of what varies") })),
        ("value", number("The value")),
        ("trajectory", text("The member as a [[trajectory]] of a derivation file")),
    ]);
    let quantile = object(&[
        ("share", number("So much of all values is at most the quantile")),
        ("from", number("It is at least this")),
        ("to", number("It is at most this")),
    ]);
    let distribution = object(&[
        ("measure", text("Id of the measure")),
        ("family", text("Id of the family")),
        ("members", whole("Members on which it was taken")),
        ("without", whole("Of these, how many have no value")),
        ("partial", whole("How many may have others than those that were found")),
        ("values", whole("How many values there are")),
        ("bound", number("The largest error bound of a value")),
        ("least", or_null(extreme.clone())),
        ("greatest", or_null(extreme)),
        ("quantiles", list(quantile)),
        ("stopped", text_or_null("Why not all members were tried")),
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
        ("units", units()),
        ("graph", graph()),
        ("digest", digest()),
        ("summary", summary),
    ]);
    let report =
        with_optional(report, &[("paper", paper()), ("alone", list(alone())), ("distributions", list(distribution))]);
    let mut out = Map::new();
    out.insert("$schema".to_owned(), json!("http://json-schema.org/draft-07/schema#"));
    out.insert("title".to_owned(), json!("A report of rederive"));
    if let Value::Object(mut fields) = report {
        out.append(&mut fields);
    }
    Value::Object(out)
}

/// A claim over ranges of values.
fn region(verdicts: &[&str], expected: &[Value]) -> Value {
    let range = object(&[
        ("name", text("In LaTeX")),
        ("unit", text_or_null("Its unit")),
        ("from", number("First value")),
        ("to", number("Last value, the same for a single value")),
        ("formula", text_or_null("Its formula, for a value that depends on others")),
    ]);
    let shares = object(&[
        ("proved", number("Part of the volume on which the claim holds wherever it applies")),
        ("refuted", number("Part on which it fails at every point")),
        ("not_applicable", number("Part on which it applies nowhere")),
        ("undecided", number("Part that is not known")),
    ]);
    let ends = json!({ "type": ["array", "null"], "items": { "type": ["number", "null"] } });
    let witness = object(&[
        ("values", json!({ "type": "object", "additionalProperties": number("Value of a range") })),
        ("formula", text_or_null("What fails, as written")),
        ("left", ends.clone()),
        ("right", ends.clone()),
        ("says", text("What is wrong there")),
    ]);
    let map = object(&[
        ("across", whole("Position among `ranges` of what goes to the right")),
        ("up", whole("Position among `ranges` of what goes up")),
        ("squares", whole("Squares along each side of the board")),
        (
            "patches",
            texts(
                "p proved, b proved where it applies, r refuted, n not applicable, u undecided; column, row, width, height",
            ),
        ),
    ]);
    object(&[
        ("verdict", json!({ "enum": verdicts })),
        ("strength", json!({ "enum": ["enclosed", "certified", "proved", null] })),
        ("expected", json!({ "enum": expected })),
        ("unexpected", flag("Whether the verdict is not as expected")),
        ("reason", text_or_null("How it came about")),
        ("ranges", list(range.clone())),
        ("varying", whole("How many of the ranges vary; they come first")),
        ("unknowns", list(range)),
        ("unique", flag("Whether one solution only was asked for")),
        ("shares", shares),
        ("cells", whole("Cells that were judged")),
        ("depth", whole("Most bisections of a cell that is undecided")),
        ("witness", or_null(witness)),
        ("solutions", list(json!({ "type": "object", "additionalProperties": ends }))),
        ("remarks", texts("What else is to be known")),
        ("map", or_null(map)),
    ])
}

/// A claim on a family of motions.
fn family(verdicts: &[&str], expected: &[Value], witness: &Value) -> Value {
    let strengths = json!({ "enum": ["sampled", "certified", "enclosed", "proved", null] });
    let member = object(&[
        ("number", whole("Its number, the first of which is 1")),
        ("values", json!({ "type": "object", "additionalProperties": number("Value of what varies") })),
        ("verdict", json!({ "enum": verdicts })),
        ("strength", strengths),
        ("reason", text_or_null("Why it is undecided")),
        ("witness", or_null(witness.clone())),
        ("trajectory", text("The member as a [[trajectory]] of a derivation file")),
    ]);
    let share = object(&[
        (
            "at_most",
            number("At most this share of all members that could be drawn, and to which the claim applies, fails"),
        ),
        ("confidence", number("With this confidence")),
        ("failures", whole("Of those that were drawn, how many fail or are undecided")),
        ("draws", whole("To how many of those that were drawn the claim applies, or may apply")),
    ]);
    let pair = json!({ "type": "array", "items": { "type": "number" }, "minItems": 2, "maxItems": 2 });
    let axis = object(&[("name", text("The symbol that varies")), ("cells", list(pair.clone()))]);
    let four = json!({ "type": "array", "items": { "type": "integer", "minimum": 0 }, "minItems": 4, "maxItems": 4 });
    let crossing = object(&[
        ("across", pair.clone()),
        ("up", pair.clone()),
        (
            "first",
            json!({ "enum": ["holds", "fails"], "description": "The verdict at the first end; the other is at the second" }),
        ),
        ("narrow", flag("Whether the ends are as near as was asked for")),
    ]);
    let width = json!({ "type": ["number", "null"], "description": "How near the two ends shall be" });
    let boundary = object(&[
        ("widths", object(&[("across", width.clone()), ("up", width)])),
        ("crossings", list(crossing)),
        ("members", whole("Motions that were tried to find it, which are no members of the family")),
        ("stopped", text_or_null("Why no more were tried")),
    ]);
    let map = object(&[
        ("across", axis.clone()),
        ("up", axis),
        ("counts", json!({ "const": ["holds", "fails", "not_applicable", "undecided"] })),
        ("rows", list(list(four))),
    ]);
    let map = with_optional(map, &[("boundary", boundary)]);
    let family = object(&[
        ("family", text("Its id")),
        ("verdict", json!({ "enum": verdicts })),
        ("strength", json!({ "enum": ["sampled", null] })),
        ("expected", json!({ "enum": expected })),
        ("unexpected", flag("Whether the verdict is not as expected")),
        ("reason", text_or_null("How it came about")),
        ("size", whole("Members before constraints")),
        ("members", whole("Members that were tried")),
        ("rejected", whole("Points of a grid, or draws, that did not satisfy the constraints")),
        ("holds", whole("Members on which it holds")),
        ("fails", whole("Members on which it fails")),
        ("not_applicable", whole("Members to which it does not apply")),
        ("undecided", whole("Members on which it is undecided")),
        ("stopped", text_or_null("Why not all members were tried")),
        ("failing_share", or_null(share)),
        ("first_failing", or_null(member.clone())),
        ("clearest_failing", or_null(member.clone())),
        ("first_undecided", or_null(member.clone())),
        ("closest_call", or_null(member)),
        (
            "closest_gap",
            json!({ "type": ["number", "null"], "description": "How near the sides of an inequality come in it, against the size of their terms" }),
        ),
    ]);
    let values = json!({ "type": "object", "additionalProperties": number("Value of what varies") });
    let exception = object(&[
        ("values", values),
        ("holds", flag("Whether the claim holds on it")),
        ("trajectory", text("It as a [[trajectory]] of a derivation file")),
    ]);
    let fresh = object(&[
        ("right", whole("Fresh members on which the condition is met just where the claim holds")),
        ("wrong", whole("Fresh members on which it is not so")),
        ("undecided", whole("Fresh members on which one of the two is undecided")),
    ]);
    let separation = object(&[
        ("explanation", or_null(explanation().0)),
        ("holds", whole("Members that were looked at on which the claim holds")),
        ("fails", whole("Members that were looked at on which it fails")),
        ("fresh", fresh),
        ("exception", or_null(exception)),
    ]);
    let error = json!({ "type": ["number", "null"], "description": "Its standard error; null of one pair" });
    let slope = object(&[
        ("with", text("What varies")),
        ("pairs", whole("Pairs of members that follow one another")),
        ("slope", number("The slope of the logarithms that fits all pairs best, by least squares")),
        ("standard_error", error),
        ("bound", number("By how much errors of the quantities may have moved it")),
        ("least", number("The least slope of a pair")),
        ("greatest", number("The greatest slope of a pair")),
        ("power", number("The power that is claimed")),
        ("to", number("How far it may be off")),
        ("contains_power", flag("Whether the claimed power is nearer than two standard errors and the bound")),
        (
            "cells",
            list(json!({
                "type": "array", "items": { "type": "number" }, "minItems": 3, "maxItems": 3,
                "description": "What varies, in the middle of a cell, and the least and the greatest slope of pairs that begin there"
            })),
        ),
    ]);
    with_optional(family, &[("map", map), ("separation", separation), ("slope", slope)])
}

/// What one motion alone could have decided.
fn alone() -> Value {
    object(&[
        ("trajectory", text("Its id")),
        ("tried", whole("Claims that were tried on it")),
        ("not_applicable", whole("Claims that do not apply to it")),
        ("holds", whole("Claims that hold on it")),
        ("misleading", texts("Claims that hold on it and fail on others")),
        ("weak", whole("Claims that hold on it weakly")),
        ("rejected", whole("Altered formulas of the claims that hold on it which it rejects")),
        ("of", whole("Altered formulas of the claims that hold on it")),
        ("sentence", text("The same in words")),
    ])
}

/// The random test of an identity.
fn trials() -> Value {
    object(&[
        ("count", whole("Independent trials")),
        ("primes", list(json!({ "type": "integer" }))),
        ("degree", number("Bound for the degree of what was tested")),
        ("height", number("Bound for log2 of the coefficients")),
        ("signs", whole("Independent signs of roots")),
        ("cases", whole("Cases into which premises were split")),
    ])
}

/// What single edits of a claim's formulas say of the evidence, and what it should have said.
fn variants() -> Value {
    let share = object(&[("rejected", whole("Rejected by some motion")), ("of", whole("Variants"))]);
    let class = object(&[
        ("class", text("What was edited")),
        ("generated", whole("Edits")),
        ("meaningless", whole("Of these, without a meaning")),
        ("repeated", whole("Of these, the same as one before")),
        ("equivalent", whole("Of these, the same as the print")),
        ("empty", whole("Of these, saying nothing")),
        ("kept", whole("Of these, tried")),
    ]);
    let survivor = object(&[
        ("class", text("What was edited")),
        ("formula", text("In LaTeX")),
        ("everywhere", flag("Whether no motion rejects it")),
    ]);
    let correction = object(&[
        ("printed", text("The formula as printed")),
        ("formula", text("The formula as it would hold")),
        ("difference", text("Both in one: what goes, what comes")),
        ("classes", texts("What was edited")),
        ("proved", flag("Whether it was proved for all values")),
        ("holds_on", whole("Trajectories on which it holds; 0 where it holds over ranges or for all fields")),
    ]);
    let tried = object(&[
        ("single", whole("Single edits")),
        ("completions", whole("Missing factors and terms")),
        ("pairs", whole("Pairs of edits")),
    ]);
    let erratum = object(&[
        ("corrections", list(correction)),
        ("tried", tried),
        ("remark", text_or_null("Why there is none, or not all were tried")),
    ]);
    let set = object(&[("trajectories", texts("Their ids")), ("least", flag("Whether no smaller set does"))]);
    object(&[
        ("seed", json!({ "type": "integer" })),
        ("together", or_null(share)),
        ("smallest_set", set),
        ("classes", list(class)),
        ("skipped", list(object(&[("formula", text("As written")), ("reason", text("Why"))]))),
        ("survivors", list(survivor)),
        ("erratum", or_null(erratum)),
    ])
}

/// Conditions that are put together, and one condition.
fn explanation() -> (Value, Value) {
    let condition = object(&[
        ("id", text_or_null("Its id; null for one that was built")),
        ("formula", text("In LaTeX")),
        ("says", text_or_null("In words")),
        ("negated", flag("Whether it is its opposite")),
    ]);
    (object(&[("join", json!({ "enum": ["and", "or"] })), ("conditions", list(condition.clone()))]), condition)
}

/// Under which condition a claim holds, and which of its assumptions it needs.
fn conditions() -> Value {
    let (explanation, condition) = explanation();
    let rival = object(&[
        ("explanation", explanation.clone()),
        ("differ_on", texts("Trajectories on which the two differ, without a verdict of the claim")),
    ]);
    let part = object(&[("condition", condition.clone()), ("trajectories", whole("How many it covers"))]);
    let open = texts("Trajectories on which it is undecided");
    let possible = object(&[("condition", condition), ("undecided_on", open)]);
    let separation = object(&[
        ("holds", texts("Trajectories on which the claim holds")),
        ("fails", texts("Trajectories on which it fails")),
        ("explanation", or_null(explanation)),
        ("rivals", list(rival)),
        ("more_rivals", whole("Further ones")),
        ("sufficient", list(part.clone())),
        ("necessary", list(part)),
        ("possible", list(possible)),
        ("tried", whole("Conditions that were tried")),
        ("undecided", whole("Of these, such as might explain it but are undecided somewhere")),
    ]);
    let assumption = object(&[
        ("formula", text("As written")),
        ("need", text("needed, not-needed, or untested")),
        ("on", texts("The trajectories that show it")),
    ]);
    object(&[("separation", or_null(separation)), ("assumptions", list(assumption))])
}

/// Whether the formulas are consistent in their units.
fn units() -> Value {
    let terms = object(&[("latex", text("A term")), ("unit", text("Its unit"))]);
    let formula = object(&[
        ("where", text("Claim, system, definition, …")),
        ("of", text("Its id or name")),
        ("formula", text("As written")),
        ("verdict", json!({ "enum": ["consistent", "inconsistent", "not-checked"] })),
        ("expected", flag("Whether the verdict is as expected")),
        ("relation", text_or_null("What does not agree")),
        ("terms", or_null(list(terms))),
        ("reason", text_or_null("Why it was not checked")),
    ]);
    object(&[
        ("consistent", whole("Formulas that are")),
        ("inconsistent", whole("Formulas that are not")),
        ("not_checked", whole("Formulas without enough units")),
        ("unexpected", whole("Of the inconsistent ones, not expected; and expected ones that are consistent")),
        ("missed", texts("Claims that were expected to be inconsistent, and are not")),
        ("formulas", list(formula)),
    ])
}

/// What follows from what.
fn graph() -> Value {
    let named = |first: &str, second: &str| object(&[(first, text("As written")), (second, text("Whose"))]);
    let rests = object(&[
        ("systems", texts("Ids")),
        ("symbols", texts("Names")),
        ("claims", texts("Ids")),
        ("assumptions", list(named("formula", "of"))),
        ("not_proved", list(object(&[("id", text("Of a claim")), ("verdict", text_or_null("Of its step"))]))),
        ("circular", flag("Whether it rests on itself")),
    ]);
    let node = object(&[
        ("id", text("Id or name")),
        ("kind", text("claim, system or symbol")),
        ("verdict", text_or_null("Of its step")),
        ("standing", text_or_null("What the proof amounts to, with all that it rests on")),
        ("assumptions", texts("Its own")),
        ("rests_on", rests),
    ]);
    let edge = object(&[
        ("from", text("What is given")),
        ("kind", text("What it is")),
        ("to", text("What follows")),
        ("verdict", text_or_null("Of the step")),
    ]);
    object(&[("nodes", list(node)), ("edges", list(edge))])
}

/// What became of each claim as a whole, and what hangs on it.
fn digest() -> Value {
    let claim = object(&[
        ("id", text("Its id")),
        ("says", text("In the file's words")),
        ("place", text_or_null("Where it stands in the paper")),
        ("conclusion", flag("Whether the paper concludes it")),
        ("fate", text("fail, partly, reading, open, untested, nowhere, stand, choice, lemma or added")),
        ("stands", text_or_null("With what strength it stands")),
        ("proved", flag("Whether all that it says is proved for all values")),
        ("reason", text_or_null("Why it does not stand")),
        ("carries", texts("Claims that rest on it")),
        ("conclusions", texts("Conclusions that rest on it")),
    ]);
    object(&[
        ("verdict", text("In one sentence")),
        ("strength", text_or_null("With what strength claims stand")),
        ("beside", text_or_null("What is not counted")),
        ("alarms", texts("What a reader must not overlook")),
        ("claims", list(claim)),
        ("against", texts("Ids of what does not stand, the heaviest first")),
    ])
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
