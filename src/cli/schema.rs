//! `rederive schema`.

use rederive::{Ending, Failure, derivation, report};
use serde_json::Value;

use super::arguments::one_of;
use super::ending::{Stop, print};

#[derive(clap::Args)]
pub struct SchemaArguments {
    /// Of what
    #[arg(value_parser = one_of([
        ("derivation", "Derivation files", derivation::schema as fn() -> Value),
        ("report", "report.json", report::schema),
    ]))]
    of: fn() -> Value,
}

pub fn schema(arguments: &SchemaArguments) -> Result<Ending, Stop> {
    let text = serde_json::to_string_pretty(&(arguments.of)()).map_err(|e| Failure::Defect(e.to_string()))?;
    print(&format!("{text}\n"))?;
    Ok(Ending::Good)
}
