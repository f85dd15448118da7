//! `rederive merge`.

use std::path::PathBuf;

use rederive::check::Limits;
use rederive::files::{self, Kind, write};
use rederive::{Demand, Detail, Document, Ending, Format};

use super::arguments::printed_as;
use super::ending::{Stop, answer, concluded};
use super::files::{LARGEST_PARTS, session};

#[derive(clap::Args)]
pub struct MergeArguments {
    /// The derivation file
    file: PathBuf,
    /// Files of parts, in any order, or folders that contain them (*.jsonl)
    #[arg(value_name = "PART|FOLDER", required = true)]
    parts: Vec<PathBuf>,
    /// What is printed: the same bytes as `rederive check FILE --trajectory FAMILY --only-verdicts`
    #[arg(long, value_parser = printed_as(&[Format::Text, Format::Json]), default_value = "text")]
    format: Format,
    /// Write it to a file
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,
}

pub fn merge(arguments: &MergeArguments) -> Result<Ending, Stop> {
    let part = Kind { what: "part (*.jsonl)", is_one: |path| path.extension().is_some_and(|e| e == "jsonl") };
    let parts = files::meant(&arguments.parts, part)?.found;
    let inputs: Vec<PathBuf> = parts.iter().chain([&arguments.file]).cloned().collect();
    write::check_outputs(arguments.output.as_slice(), &inputs, &[])?;
    let texts = parts.iter().map(|path| {
        let text = files::read_text(path, LARGEST_PARTS).map_err(|error| error.to_string())?;
        Ok((path.display().to_string(), text))
    });
    let findings = session(&arguments.file)?.join(texts, &Limits::default(), &|_, _| {})?;
    let document = Document::from(findings);
    let text = |colour| document.text(arguments.format, Detail::Usual, colour);
    match &arguments.output {
        Some(output) => write::write_file(output, text(false).as_bytes())?,
        None => answer(arguments.format, &text(true))?,
    }
    Ok(concluded(&document, &Demand::default()))
}
