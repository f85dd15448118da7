//! `rederive audit`.

use std::path::{Path, PathBuf};

use rederive::files::{self, Kind};
use rederive::{Ending, Format, report};

use super::arguments::printed_as;
use super::ending::{Stop, print_json, say};

/// Largest size of a proofs.json, in bytes.
const LARGEST_FILE: u64 = 256 << 20;

#[derive(clap::Args)]
pub struct AuditArguments {
    /// A proofs.json, or a folder with reports
    #[arg(value_name = "REPORT", default_value = "reports")]
    paths: Vec<PathBuf>,
    /// How the audit is printed
    #[arg(long, value_parser = printed_as(&[Format::Text, Format::Json]), default_value = "text")]
    format: Format,
}

pub fn audit(arguments: &AuditArguments) -> Result<Ending, Stop> {
    let (mut ending, mut documents) = (Ending::Good, Vec::new());
    for path in &arguments.paths {
        for (name, bytes) in proofs(path)? {
            let found = report::audit(&bytes).map_err(|why| format!("{name}: {why}"))?;
            if !found.is_replayed() {
                ending = Ending::Different;
            }
            match arguments.format {
                Format::Json => documents.push(found.json()),
                _ => say(&found.text())?,
            }
        }
    }
    if arguments.format == Format::Json {
        print_json(&documents.into())?;
    }
    Ok(ending)
}

/// The proofs that a path names: a file, or every `proofs.json` below a folder.
fn proofs(path: &Path) -> Result<Vec<(String, Vec<u8>)>, Stop> {
    let kind = Kind { what: report::PROOFS, is_one: |path| path.file_name().is_some_and(|n| n == report::PROOFS) };
    let read = |file: PathBuf| Ok((file.display().to_string(), files::read(&file, LARGEST_FILE)?));
    files::meant(&[path.to_owned()], kind)?.found.into_iter().map(read).collect()
}
