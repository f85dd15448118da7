//! `rederive manual`.

use std::path::PathBuf;

use clap::Command;
use rederive::files::write;
use rederive::{Ending, Failure};

use super::ending::{Stop, print};

#[derive(clap::Args)]
pub struct ManualArguments {
    /// The folder for the pages of all commands
    #[arg(long, short, value_name = "DIR")]
    output: Option<PathBuf>,
}

pub fn manual(arguments: &ManualArguments, mut command: Command) -> Result<Ending, Stop> {
    command.build();
    let pages = pages(&command, None)?;
    match &arguments.output {
        Some(folder) => write::write_files(folder, &pages)?,
        None => print(pages.first().map_or("", |(_, text)| text))?,
    }
    Ok(Ending::Good)
}

/// The page of a command, then those of its subcommands, each with the name of its file.
fn pages(command: &Command, parent: Option<&str>) -> Result<Vec<(String, String)>, Stop> {
    let name = match parent {
        Some(parent) => format!("{parent}-{}", command.get_name()),
        None => command.get_name().to_owned(),
    };
    let mut text = Vec::new();
    let page = clap_mangen::Man::new(command.clone()).title(name.to_uppercase());
    page.render(&mut text).map_err(|e| Failure::Defect(format!("a page of the manual cannot be written: {e}")))?;
    let mut out = vec![(format!("{name}.1"), String::from_utf8_lossy(&text).into_owned())];
    for inner in command.get_subcommands().filter(|c| c.get_name() != "help" && !c.is_hide_set()) {
        out.extend(pages(inner, Some(&name))?);
    }
    Ok(out)
}
