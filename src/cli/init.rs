//! `rederive init`.

use std::path::PathBuf;

use rederive::{paper, report};

use super::{Exit, InitArguments, Stop, complain, files, print};

pub fn init(arguments: &InitArguments) -> Result<Exit, Stop> {
    let path = files::within_project(&arguments.paper);
    let paper = paper::read(&path).map_err(|problem| Stop::Diagnostics(vec![*problem]))?;
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
        return Ok(Exit::Good);
    }
    if output.exists() {
        return Err(Stop::Message(format!("`{}` is there already, and is not replaced", output.display())));
    }
    let folder =
        output.parent().filter(|f| !f.as_os_str().is_empty()).map_or_else(|| PathBuf::from("."), PathBuf::from);
    let file = output.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
    report::write_files(&folder, &[(&file, draft.text)]).map_err(|e| Stop::Message(e.to_string()))?;
    complain(&format!(
        "{}: {} equations, {} formulas, {} more that cannot be read yet, {} symbols guessed\n\
         Look for `confirm` in it; then add a system and a motion.\n",
        output.display(),
        paper.equations.len(),
        draft.formulas,
        draft.refused,
        draft.symbols,
    ));
    Ok(Exit::Good)
}
