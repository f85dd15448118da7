//! The schemas of derivation files and reports: published as printed, complete, and true of every file of this project.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::checked::checked;
use crate::schema_support::Validator;
use rederive::derivation::{self, load};
use rederive::diag::render;
use rederive::{paper, report};
use serde_json::{Value, json};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// A TOML text as JSON.
fn toml_value(text: &str) -> Value {
    toml::from_str(text).unwrap_or_else(|e| panic!("{e}"))
}

fn files(folder: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(root().join(folder)).expect("the folder is there");
    let mut out: Vec<PathBuf> = entries.map(|e| e.expect("an entry").path()).collect();
    out.retain(|p| p.extension().is_some_and(|e| e == "toml"));
    out.sort();
    out
}

#[test]
fn the_published_schemas_are_those_that_the_program_prints() {
    for of in ["derivation", "report"] {
        let run = Command::new(env!("CARGO_BIN_EXE_rederive")).args(["schema", of]).output().expect("it runs");
        assert!(run.status.success());
        let path = root().join(format!("docs/schema/{of}.schema.json"));
        let published = fs::read(&path).unwrap_or_default();
        let how = format!("rederive schema {of} > docs/schema/{of}.schema.json");
        assert!(published == run.stdout, "the published schema is not that of this version: {how}");
    }
}

#[test]
fn every_field_is_described() {
    fn described(schema: &Value, at: &str) -> usize {
        let fields = schema["properties"].as_object();
        for (key, value) in fields.into_iter().flatten() {
            assert!(value["description"].as_str().is_some_and(|d| !d.is_empty()), "{at}/{key} has no description");
        }
        fields.map_or(0, |f| f.len())
    }
    for schema in [derivation::schema(), report::schema()] {
        let inner = schema["definitions"].as_object().expect("definitions");
        let fields: usize = inner.iter().map(|(name, value)| described(value, name)).sum();
        assert!(fields + described(&schema, "") > 100, "{fields}");
    }
}

/// The fields of a report that a reader can rely on are not made optional, or null, by the way.
#[test]
fn what_a_report_always_has_is_required() {
    let schema = report::schema();
    let seldom = [
        "alone",
        "distributions",
        "drawn",
        "found",
        "paper",
        "families",
        "map",
        "separation",
        "slope",
        "boundary",
        "enclosed",
        "unmet",
        "obstacle",
        "identities",
        "slack",
        "conditional_on_more",
        "more_conclusions",
        "recorded",
        "proofs",
    ];
    let objects = schema["definitions"].as_object().expect("definitions").values().chain([&schema]);
    for object in objects {
        let required: Vec<&str> =
            object["required"].as_array().expect("all have some").iter().filter_map(Value::as_str).collect();
        for key in object["properties"].as_object().expect("fields").keys() {
            let optional = seldom.contains(&key.as_str()) && !required.contains(&key.as_str());
            assert!(required.contains(&key.as_str()) || optional, "{key} of {object} is not required");
        }
    }
    let result = &schema["definitions"]["TrajectoryResult"]["properties"];
    assert_eq!(result["verdict"]["enum"], json!(["holds", "fails", "not-applicable", "undecided"]));
    assert_eq!(result["strength"]["enum"], json!(["sampled", "enclosed", "certified", "proved", null]));
    assert_eq!(result["unexpected"]["type"], json!("boolean"));
    assert_eq!(schema["definitions"]["Witness"]["properties"]["left"]["type"], json!(["number", "null"]));
    assert_eq!(schema["definitions"]["Axis"]["properties"]["cells"]["items"]["items"]["type"], json!("number"));
}

#[test]
fn every_derivation_file_validates() {
    let schema = derivation::schema();
    let validator = Validator { root: &schema, strict: true };
    let mut seen = 0;
    for path in files("derivations").into_iter().chain(files("tests/corpus")) {
        let text = fs::read_to_string(&path).expect("it is read");
        let found = validator.check(&toml_value(&text));
        assert!(found.is_empty(), "{}: {}", path.display(), found.join("\n"));
        // Round trip: what TOML writes of the file is the same data, and validates. The loader wants formulas in single
        // quotes, which no writer of TOML promises: so the text itself is not loaded again.
        let value: toml::Table = toml::from_str(&text).unwrap_or_else(|e| panic!("{e}"));
        let again = toml_value(&toml::to_string(&value).expect("it is written"));
        assert_eq!(again, toml_value(&text), "{}", path.display());
        assert!(validator.check(&again).is_empty(), "{}", path.display());
        let loaded = load(&path).unwrap_or_else(|found| panic!("{}", render(&found, false)));
        let claims = again["claim"].as_array().map_or(0, Vec::len);
        let mut ids: Vec<&str> = loaded.claims.iter().map(|c| c.id.as_str()).collect();
        ids.dedup();
        assert_eq!(ids.len(), claims, "{}: claims are lost", path.display());
        seen += 1;
    }
    assert!(seen >= 8, "{seen}");
}

#[test]
fn what_the_loader_refuses_the_schema_refuses_too() {
    let schema = derivation::schema();
    let validator = Validator { root: &schema, strict: false };
    let good = fs::read_to_string(root().join("derivations/pendulum.toml")).expect("it is read");
    assert!(validator.check(&toml_value(&good)).is_empty());
    for (from, to) in [
        ("[symbols]", "[symbol]"),
        ("title = ", "titel = "),
        ("role = \"time\"", "role = \"hour\""),
        ("[[claim]]\nid = ", "[[claim]]\nname = "),
        ("span = [0, 20]", "span = [0, 20, 30]"),
        ("always = [", "allways = ["),
        ("expect = \"holds\"", "expect = \"good\""),
        ("precision = 1e-", "precision = 1e+"),
    ] {
        let bad = good.replacen(from, to, 1);
        if bad == good {
            // The file may be written in another way; at least one of each kind is tried below.
            continue;
        }
        assert!(!validator.check(&toml_value(&bad)).is_empty(), "{to} validates");
        let source = rederive::diag::Source { path: "bad.toml".into(), text: bad };
        assert!(derivation::parse(source, "bad").is_err(), "{to} loads");
    }
    for bad in [
        json!({ "derivation": { "title": "x" }, "symbols": {} }),
        json!({ "derivation": { "title": "x", "concerns": "y" }, "symbols": { "x": {} } }),
        json!({ "derivation": { "title": "x", "concerns": "y" }, "symbols": {}, "claim": {} }),
        json!({ "derivation": { "title": "x", "concerns": "y" }, "symbols": {}, "claim": [{ "id": "-", "says": "z" }] }),
    ] {
        assert!(!validator.check(&bad).is_empty(), "{bad} validates");
    }
}

/// The report on a derivation file.
fn fresh(path: &Path, tex: Option<&str>) -> Value {
    let (derivation, account) = &*checked(path);
    let text = match tex {
        None => report::json(derivation, account),
        Some(tex) => {
            let source = rederive::diag::Source { path: "paper.tex".into(), text: tex.into() };
            let paper = paper::parse(source, "00".into()).unwrap_or_else(|d| panic!("{}", render(&[*d], false)));
            report::json_with_paper(derivation, account, &paper::compare(derivation, &paper))
        }
    };
    serde_json::from_str(&text).expect("this is JSON")
}

#[test]
fn every_report_validates_and_has_no_field_that_is_not_listed() {
    let schema = report::schema();
    let validator = Validator { root: &schema, strict: true };
    let mut reports = vec![fresh(&root().join("derivations/pendulum.toml"), Some(include_str!("source/paper.tex")))];
    reports.push(fresh(&root().join("derivations/kepler.toml"), None));
    reports.extend(files("tests/corpus").iter().map(|p| fresh(p, None)));
    for report in &reports {
        let found = validator.check(report);
        let few: Vec<_> = found.iter().take(10).cloned().collect();
        assert!(
            found.is_empty(),
            "{}:\n{}\nadd it to src/report/document/",
            report["derivation"]["id"],
            few.join("\n")
        );
    }
}

#[test]
fn a_report_that_is_not_whole_does_not_validate() {
    let schema = report::schema();
    let validator = Validator { root: &schema, strict: true };
    let good = fresh(&root().join("derivations/pendulum.toml"), None);
    assert!(validator.check(&good).is_empty());
    let spoiled: [(&str, Value); 6] = [
        ("/schema", json!(2)),
        ("/claims/0/results/0/verdict", json!("true")),
        ("/claims/0/results/0/unexpected", Value::Null),
        ("/summary/holds", json!(-1)),
        ("/trajectories/0/span", json!("all")),
        ("/derivation/conventions", json!({ "a": 1 })),
    ];
    for (place, value) in spoiled {
        let mut bad = good.clone();
        *bad.pointer_mut(place).unwrap_or_else(|| panic!("no {place}")) = value;
        assert!(!validator.check(&bad).is_empty(), "{place}");
    }
    let mut more = good.clone();
    more["claims"][0]["colour"] = json!("red");
    assert_eq!(validator.check(&more), ["/claims/0/colour is not in the schema"]);
    let lenient = Validator { root: &schema, strict: false };
    assert!(lenient.check(&more).is_empty(), "readers pass over fields that they do not know");
    let mut less = good;
    less["claims"][0].as_object_mut().expect("an object").remove("formulas");
    assert_eq!(validator.check(&less), ["/claims/0: `formulas` is missing"]);
}
