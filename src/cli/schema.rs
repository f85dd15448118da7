//! `rederive schema`.

use rederive::{derivation, report};

use super::{Exit, Schema, SchemaArguments, Stop, print};

pub fn schema(arguments: &SchemaArguments) -> Result<Exit, Stop> {
    let schema = match arguments.of {
        Schema::Derivation => derivation::schema(),
        Schema::Report => report::schema(),
    };
    let mut text = serde_json::to_string_pretty(&schema).map_err(|e| Stop::Defect(e.to_string()))?;
    text.push('\n');
    print(&text)?;
    Ok(Exit::Good)
}
