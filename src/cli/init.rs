//! `rederive init`.

use std::path::PathBuf;

use rederive::files::{self, write};
use rederive::{Ending, Failure, paper};

use super::ending::{Stop, complain, print_json, say};

#[derive(clap::Args)]
pub struct InitArguments {
    /// The LaTeX source of the paper
    #[arg(value_name = "PAPER.TEX")]
    paper: PathBuf,
    /// The derivation file, `-` for standard output; without it derivations/PAPER.toml. No file is replaced
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,
    /// `json` prints what was found and guessed on standard output, and the draft in it where no file is named
    #[arg(long, value_name = "FORMAT", default_value = "text")]
    format: InitFormat,
}

/// How `init` says what it found.
#[derive(Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum InitFormat {
    /// Lines on standard error.
    Text,
    /// An object on standard output.
    Json,
}

pub fn init(arguments: &InitArguments) -> Result<Ending, Stop> {
    let path = files::named(&arguments.paper)?;
    let paper = paper::read(&path).map_err(Failure::from)?;
    if paper.equations.is_empty() {
        return Err(format!("`{}` displays no equation", path.display()).into());
    }
    let draft = paper::draft(&paper, &path.file_name().unwrap_or_default().to_string_lossy());
    let usual = || PathBuf::from("derivations").join(path.with_extension("toml").file_name().unwrap_or_default());
    // As an object, with no file named, the draft stands in it.
    let shown = || if arguments.format == InitFormat::Json { PathBuf::from("-") } else { usual() };
    let output = arguments.output.clone().unwrap_or_else(shown);
    let is_printed = output.as_os_str() == "-";
    if !is_printed {
        write::write_new(&output, draft.text.as_bytes())?;
    }
    if arguments.format == InitFormat::Json {
        let paper::Draft { equations, formulas, refused, expressions, symbols, guesses, text } = &draft;
        let file = (!is_printed).then(|| output.display().to_string());
        let found = serde_json::json!({
            "file": file, "equations": equations, "formulas": formulas, "refused": refused, "expressions": expressions,
            "symbols": symbols, "guesses": guesses, "draft": is_printed.then_some(text),
        });
        print_json(&found)?;
    } else if is_printed {
        say(&draft.text)?;
    } else {
        for guess in &draft.guesses {
            complain(guess);
        }
        complain(&format!("{}: {}", output.display(), draft.summary()));
    }
    Ok(Ending::Good)
}
