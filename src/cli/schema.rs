//! `rederive schema`.

use clap::ValueEnum;
use rederive::{derivation, report};

use super::ending::{Exit, Stop, print};

#[derive(clap::Args)]
pub struct SchemaArguments {
    /// Of what
    #[arg(value_enum)]
    of: Schema,
}

/// What has a schema.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Schema {
    /// Derivation files
    Derivation,
    /// report.json
    Report,
}

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
