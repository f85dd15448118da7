//! A small reader of JSON Schema, of the part that the schemas of this project use.
//!
//! A keyword that it does not know is an error, so that nothing is passed over. With `strict`, a property that no schema
//! lists is an error, too: then a new field without a description is found.

use serde_json::Value;

pub struct Validator<'s> {
    pub root: &'s Value,
    pub strict: bool,
}

/// Keywords without a meaning for validation.
const ANNOTATIONS: &[&str] = &["$schema", "title", "description", "definitions"];

impl Validator<'_> {
    /// Every violation, with its place in the value.
    pub fn check(&self, value: &Value) -> Vec<String> {
        let mut out = Vec::new();
        self.one(self.root, value, "", &mut out);
        out
    }

    fn valid(&self, schema: &Value, value: &Value) -> bool {
        let mut out = Vec::new();
        self.one(schema, value, "", &mut out);
        out.is_empty()
    }

    /// What a reference leads to; any other schema itself.
    fn resolved<'a>(&'a self, schema: &'a Value) -> &'a Value {
        let Some(name) = schema["$ref"].as_str() else { return schema };
        let target = name.strip_prefix('#').and_then(|p| self.root.pointer(p));
        target.unwrap_or_else(|| panic!("there is no {name}"))
    }

    fn one(&self, schema: &Value, value: &Value, at: &str, out: &mut Vec<String>) {
        let Some(keywords) = schema.as_object() else {
            out.push(format!("{at}: the schema is no object"));
            return;
        };
        let mut note = |what: String| out.push(format!("{at}: {what}"));
        for (keyword, wanted) in keywords {
            match keyword.as_str() {
                k if ANNOTATIONS.contains(&k) => {}
                "type" => {
                    let types: Vec<&str> = match wanted {
                        Value::Array(many) => many.iter().filter_map(Value::as_str).collect(),
                        one => one.as_str().into_iter().collect(),
                    };
                    if !types.iter().any(|t| is_of(value, t)) {
                        note(format!("{value:.60} is not {}", types.join(" or ")));
                    }
                }
                "enum" => {
                    if !wanted.as_array().is_some_and(|a| a.contains(value)) {
                        note(format!("{value} is not one of {wanted}"));
                    }
                }
                "const" => {
                    if wanted != value {
                        note(format!("{value} is not {wanted}"));
                    }
                }
                "pattern" => {
                    assert_eq!(wanted, "^[A-Za-z0-9][A-Za-z0-9._-]*$", "another pattern is not known here");
                    let text = value.as_str().unwrap_or("x");
                    let good = text.starts_with(|c: char| c.is_ascii_alphanumeric())
                        && text.chars().all(|c| c.is_ascii_alphanumeric() || "._-".contains(c));
                    if !good {
                        note(format!("`{text}` is no id"));
                    }
                }
                "maxLength" => {
                    let length = value.as_str().map_or(0, |t| t.chars().count() as u64);
                    if length > wanted.as_u64().expect("a length") {
                        note("too long".to_owned());
                    }
                }
                "minItems" | "maxItems" => {
                    let n = value.as_array().map(|a| a.len() as u64);
                    let limit = wanted.as_u64().expect("a number");
                    if n.is_some_and(|n| if keyword == "minItems" { n < limit } else { n > limit }) {
                        note(format!("{keyword} {limit}"));
                    }
                }
                "minimum" | "exclusiveMinimum" | "exclusiveMaximum" => {
                    let limit = wanted.as_f64().expect("a number");
                    let good = |x: f64| match keyword.as_str() {
                        "minimum" => x >= limit,
                        "exclusiveMinimum" => x > limit,
                        _ => x < limit,
                    };
                    if value.as_f64().is_some_and(|x| !good(x)) {
                        note(format!("{value}: {keyword} {limit}"));
                    }
                }
                "required" => {
                    for key in wanted.as_array().expect("names").iter().filter_map(Value::as_str) {
                        if value.as_object().is_some_and(|o| !o.contains_key(key)) {
                            note(format!("`{key}` is missing"));
                        }
                    }
                }
                "properties" | "additionalProperties" | "items" | "$ref" | "anyOf" | "allOf" => {}
                other => note(format!("the keyword `{other}` is not known to this test")),
            }
        }
        if schema.get("$ref").is_some() {
            self.one(self.resolved(schema), value, at, out);
        }
        for all in schema["allOf"].as_array().into_iter().flatten() {
            self.one(all, value, at, out);
        }
        if let Some(choices) = schema["anyOf"].as_array()
            && !choices.iter().any(|c| self.valid(c, value))
        {
            // The choice that is meant is that of the same type.
            let near = choices.iter().find(|c| self.resolved(c)["type"].as_str().is_some_and(|t| is_of(value, t)));
            match near {
                Some(near) => self.one(near, value, at, out),
                None => out.push(format!("{at}: {value:.60} is none of the choices")),
            }
        }
        if let (Some(items), Some(values)) = (schema.get("items"), value.as_array()) {
            for (i, value) in values.iter().enumerate() {
                self.one(items, value, &format!("{at}/{i}"), out);
            }
        }
        let Some(object) = value.as_object() else { return };
        let is_described = schema.get("properties").is_some() || schema.get("additionalProperties").is_some();
        for (key, value) in object {
            let at = format!("{at}/{key}");
            match (schema["properties"].get(key), schema.get("additionalProperties")) {
                (Some(schema), _) => self.one(schema, value, &at, out),
                (None, Some(Value::Bool(false))) => out.push(format!("{at} is not in the schema")),
                (None, Some(other)) if other.is_object() => self.one(other, value, &at, out),
                _ if self.strict && is_described => out.push(format!("{at} is not in the schema")),
                _ => {}
            }
        }
    }
}

fn is_of(value: &Value, name: &str) -> bool {
    match name {
        "string" => value.is_string(),
        "integer" => value.is_i64() || value.is_u64(),
        "number" => value.is_number(),
        "boolean" => value.is_boolean(),
        "array" => value.is_array(),
        "object" => value.is_object(),
        "null" => value.is_null(),
        other => panic!("there is no type {other}"),
    }
}
