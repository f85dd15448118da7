//! The JSON Schema of `report.json`, made from the types of [`document`](super::document).
//!
//! Readers should pass over fields that they do not know: within one value of `schema` fields are only added.

use schemars::generate::SchemaSettings;
use schemars::transform::RecursiveTransform;
use schemars::{JsonSchema, Schema};
use serde_json::Value;

use super::document::Report;

/// The schema, in draft 7 of JSON Schema.
pub fn schema() -> Value {
    of::<Report>()
}

fn of<T: JsonSchema>() -> Value {
    let settings = SchemaSettings::draft07().for_serialize().with_transform(RecursiveTransform(plain));
    settings.into_generator().into_root_schema_for::<T>().to_value()
}

/// Without the formats of Rust's numbers, which say nothing to others; a number that JSON does not have is `null`.
fn plain(schema: &mut Schema) {
    if schema.remove("format").is_some_and(|format| format == "double") && schema.get("type") == Some(&"number".into())
    {
        schema.insert("type".to_owned(), vec!["number", "null"].into());
    }
}
