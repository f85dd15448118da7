//! `rederive manual`.

use std::path::PathBuf;

use clap::Command;
use rederive::Ending;
use rederive::files::write;

use super::ending::{Stop, print};

#[derive(clap::Args)]
pub struct ManualArguments {
    /// The folder for the pages of all commands
    #[arg(long, short, value_name = "DIR")]
    output: Option<PathBuf>,
}

pub fn manual(arguments: &ManualArguments, mut command: Command) -> Result<Ending, Stop> {
    command.build();
    match &arguments.output {
        None => print(&page(&command)?.1)?,
        Some(folder) => {
            let inner = command.get_subcommands().filter(|c| c.get_name() != "help" && !c.is_hide_set());
            let pages = std::iter::once(&command).chain(inner).map(page).collect::<Result<Vec<_>, Stop>>()?;
            write::write_files(folder, &pages)?;
        }
    }
    Ok(Ending::Good)
}

/// The page of a command, with the name of its file.
fn page(command: &Command) -> Result<(String, String), Stop> {
    let page = clap_mangen::Man::new(command.clone());
    let (file, title) = (page.get_filename(), command.get_display_name().unwrap_or_else(|| command.get_name()));
    let mut text = Vec::new();
    page.title(title.to_uppercase()).render(&mut text)?;
    Ok((file, String::from_utf8_lossy(&text).into_owned()))
}
