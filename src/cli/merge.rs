//! `rederive merge`.

use std::path::PathBuf;

use clap::ValueEnum;
use rederive::check::Limits;
use rederive::derivation::load;
use rederive::files::{named, read, search, write};
use rederive::{Session, report};

use super::ending::{Exit, Stop, print, say};
use super::files::LARGEST_PARTS;

#[derive(clap::Args)]
pub struct MergeArguments {
    /// The derivation file
    file: PathBuf,
    /// Files of parts, in any order, or folders that contain them (*.jsonl)
    #[arg(value_name = "PART|FOLDER", required = true)]
    parts: Vec<PathBuf>,
    /// What is printed: the same bytes as `rederive check FILE --trajectory FAMILY --only-verdicts`
    #[arg(long, value_enum, default_value = "text")]
    format: MergeFormat,
    /// Write it to a file
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// How what was joined is printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum MergeFormat {
    /// A summary for people
    Text,
    /// The report as JSON
    Json,
}

pub fn merge(arguments: &MergeArguments) -> Result<Exit, Stop> {
    let file = named(&arguments.file)?;
    let mut parts = Vec::new();
    for path in &arguments.parts {
        let path = named(path)?;
        match path.is_dir() {
            true => parts.extend(search(&path, &|p| p.extension().is_some_and(|e| e == "jsonl"))?.found),
            false => parts.push(path),
        }
    }
    let outputs: Vec<PathBuf> = arguments.output.iter().cloned().collect();
    let inputs: Vec<PathBuf> = parts.iter().chain([&file]).cloned().collect();
    write::check_outputs(&outputs, &inputs, &[])?;
    let session = Session::of(load(&file).map_err(Stop::Diagnostics)?);
    let texts = parts.iter().map(|path| {
        let name = path.display().to_string();
        let bytes = read(path, LARGEST_PARTS).map_err(|error| error.to_string())?;
        let text = String::from_utf8(bytes).map_err(|_| format!("`{name}`: it is no text"))?;
        Ok((name, text))
    });
    let found = session.join(texts, &Limits::default(), &|_, _| {})?;
    let (derivation, account) = (found.derivation(), found.account());
    let text = |colour| match arguments.format {
        MergeFormat::Text => report::summary(derivation, account, colour, false),
        MergeFormat::Json => found.json(),
    };
    match (&arguments.output, arguments.format) {
        (Some(output), _) => write::write_file(output, text(false).as_bytes())?,
        (None, MergeFormat::Text) => say(&text(true))?,
        (None, MergeFormat::Json) => print(&text(false))?,
    }
    Ok(Exit::of(&found))
}
