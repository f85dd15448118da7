//! `rederive schema`.

use rederive::{Ending, derivation, report};
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
    print(&format!("{:#}\n", (arguments.of)()))?;
    Ok(Ending::Good)
}
