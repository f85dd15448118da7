//! `rederive diff`.

use std::path::{Path, PathBuf};

use clap::ValueEnum;
use rederive::{files, report};
use serde_json::Value;

use super::ending::{Exit, Stop, complain, say};

/// Largest size of a report.json, in bytes.
const LARGEST_REPORT: u64 = 256 << 20;

#[derive(clap::Args)]
pub struct DiffArguments {
    /// The report as it was: a report.json, or a folder with reports
    old: PathBuf,
    /// The report as it is
    new: PathBuf,
    /// How the changes are printed
    #[arg(long, value_enum, default_value = "text")]
    format: DiffFormat,
}

/// How changes are printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum DiffFormat {
    /// For people
    Text,
    /// For a comment on a pull request
    Markdown,
}

pub fn diff(arguments: &DiffArguments) -> Result<Exit, Stop> {
    let (mut old, new) = (reports(&arguments.old)?, reports(&arguments.new)?);
    if let ([(_, before)], [(_, after)]) = (old.as_mut_slice(), new.as_slice()) {
        // Two files are meant to be compared, whatever the derivations are called.
        let id = |report: &Value| report["derivation"]["id"].as_str().map(str::to_owned);
        if let (Some(a), Some(b)) = (id(before), id(after))
            && a != b
        {
            complain(&format!("`{a}` is compared with `{b}`: the derivations have different ids\n"));
            before["derivation"]["id"] = b.into();
        }
    }
    let named = |values: &[(PathBuf, Value)]| values.iter().map(|(_, v)| v.clone()).collect::<Vec<_>>();
    for (path, value) in old.iter().chain(&new) {
        // One at a time, so that the message names the file.
        report::diff(std::slice::from_ref(value), &[])
            .map_err(|e| Stop::Message(format!("`{}` cannot be compared: {e}", path.display())))?;
    }
    let changes = report::diff(&named(&old), &named(&new)).map_err(Stop::Message)?;
    say(&report::diff_text(&changes, arguments.format == DiffFormat::Markdown))?;
    Ok(if report::is_worse(&changes) { Exit::Different } else { Exit::Good })
}

/// The reports that a path names: a file, or every `report.json` below a folder.
fn reports(path: &Path) -> Result<Vec<(PathBuf, Value)>, Stop> {
    let mut files = Vec::new();
    if path.is_dir() {
        files = files::search(path, &|p| p.file_name().is_some_and(|n| n == "report.json"))?.found;
    } else {
        files.push(path.to_path_buf())
    }
    if files.is_empty() {
        return Err(Stop::Message(format!("there is no report.json in `{}`", path.display())));
    }
    let read = |file: PathBuf| {
        let bytes = files::read(&file, LARGEST_REPORT)?;
        let value = serde_json::from_slice(&bytes)
            .map_err(|e| Stop::Message(format!("`{}` is not JSON: {e}", file.display())))?;
        Ok((file, value))
    };
    files.into_iter().map(read).collect()
}
