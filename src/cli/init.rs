//! `rederive init`.

use std::path::PathBuf;

use rederive::files::{self, write};
use rederive::{Ending, Failure, paper};

use super::ending::{Stop, complain, print};

#[derive(clap::Args)]
pub struct InitArguments {
    /// The LaTeX source of the paper
    #[arg(value_name = "PAPER.TEX")]
    paper: PathBuf,
    /// The derivation file, `-` for standard output; without it derivations/PAPER.toml. No file is replaced
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,
}

pub fn init(arguments: &InitArguments) -> Result<Ending, Stop> {
    let path = files::named(&arguments.paper)?;
    let paper = paper::read(&path).map_err(Failure::from)?;
    if paper.equations.is_empty() {
        return Err(format!("`{}` displays no equation", path.display()).into());
    }
    let draft = paper::draft(&paper, &path.file_name().unwrap_or_default().to_string_lossy());
    let usual = || PathBuf::from("derivations").join(path.with_extension("toml").file_name().unwrap_or_default());
    let output = arguments.output.clone().unwrap_or_else(usual);
    if output.as_os_str() == "-" {
        print(&draft.text)?;
    } else {
        write::write_new(&output, draft.text.as_bytes())?;
        complain(&format!("{}: {}", output.display(), draft.summary()));
    }
    Ok(Ending::Good)
}
