//! `rederive init`.

use std::path::PathBuf;

use rederive::files::{self, write};
use rederive::{Ending, paper};

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
    let paper = paper::read(&path).map_err(|problem| vec![*problem])?;
    let name = path.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
    if paper.equations.is_empty() {
        return Err(Stop::Message(format!("`{}` displays no equation", path.display())));
    }
    let draft = paper::draft(&paper, &name);
    let output = arguments.output.clone().unwrap_or_else(|| {
        let stem = path.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
        PathBuf::from("derivations").join(format!("{stem}.toml"))
    });
    if output.as_os_str() == "-" {
        print(&draft.text)?;
        return Ok(Ending::Good);
    }
    // A link that leads nowhere is something, too.
    if output.symlink_metadata().is_ok() {
        return Err(Stop::Message(format!("`{}` is there already, and is not replaced", output.display())));
    }
    write::write_file(&output, draft.text.as_bytes())?;
    complain(&format!(
        "{}: {} equations, {} formulas, {} more that cannot be read yet, {} symbols guessed\n\
         Look for `confirm` in it; then add a system and a motion.\n",
        output.display(),
        paper.equations.len(),
        draft.formulas,
        draft.refused,
        draft.symbols,
    ));
    Ok(Ending::Good)
}
