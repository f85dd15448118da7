//! `rederive diff`.

use std::path::{Path, PathBuf};

use rederive::files::{self, Kind};
use rederive::{Ending, Format, report};

use super::arguments::printed_as;
use super::ending::{Stop, complain, say};

/// Largest size of a report.json, in bytes.
const LARGEST_REPORT: u64 = 256 << 20;

#[derive(clap::Args)]
pub struct DiffArguments {
    /// The report as it was: a report.json, or a folder with reports
    old: PathBuf,
    /// The report as it is
    new: PathBuf,
    /// How the changes are printed
    #[arg(long, value_parser = printed_as(&[Format::Text, Format::Markdown]), default_value = "text")]
    format: Format,
}

pub fn diff(arguments: &DiffArguments) -> Result<Ending, Stop> {
    let (changes, other) = report::diff_files(&reports(&arguments.old)?, &reports(&arguments.new)?)?;
    if let Some((a, b)) = other {
        complain(&format!("`{a}` is compared with `{b}`: the derivations have different ids"));
    }
    say(&report::diff_text(&changes, arguments.format == Format::Markdown))?;
    Ok(if report::is_worse(&changes) { Ending::Different } else { Ending::Good })
}

/// The reports that a path names: a file, or every `report.json` below a folder.
fn reports(path: &Path) -> Result<Vec<(String, Vec<u8>)>, Stop> {
    let report = Kind { what: "report.json", is_one: |path| path.file_name().is_some_and(|n| n == "report.json") };
    let read = |file: PathBuf| Ok((file.display().to_string(), files::read(&file, LARGEST_REPORT)?));
    files::meant(&[path.to_owned()], report)?.found.into_iter().map(read).collect()
}
