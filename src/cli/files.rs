//! Which derivation files are meant.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use rederive::derivation::{Derivation, load};
use rederive::diag::{Diagnostic, nearest};

use super::Stop;

/// Deepest folder inside a folder that is searched: links may lead in circles.
const DEEPEST: usize = 16;

/// The derivation files that the paths name: files as they are, folders searched for `*.toml`, each once, in order.
pub fn find(paths: &[PathBuf]) -> Result<Vec<PathBuf>, Stop> {
    let mut found = Vec::new();
    for path in paths {
        let path = within_project(path);
        if !path.exists() && path == Path::new("derivations") {
            let message = "there is no folder `derivations` here: name a derivation file or a folder with some, or draft one with \
                           `rederive init PAPER.tex`";
            return Err(Stop::Message(message.to_owned()));
        }
        if !path.is_dir() {
            found.push(path);
            continue;
        }
        let before = found.len();
        let mut inside = Vec::new();
        search(&path, 0, &mut inside)?;
        inside.sort();
        found.extend(inside);
        if found.len() == before {
            return Err(Stop::Message(format!("there is no derivation file (*.toml) in `{}`", path.display())));
        }
    }
    let mut seen = BTreeSet::new();
    found.retain(|p| seen.insert(p.clone()));
    Ok(found)
}

fn search(folder: &Path, depth: usize, out: &mut Vec<PathBuf>) -> Result<(), Stop> {
    let failed = |e: std::io::Error| Stop::Message(format!("`{}` cannot be read: {e}", folder.display()));
    for entry in std::fs::read_dir(folder).map_err(failed)? {
        let path = entry.map_err(failed)?.path();
        let hidden = path.file_name().is_some_and(|n| n.to_string_lossy().starts_with('.'));
        if hidden {
            continue;
        }
        if path.is_dir() {
            if depth < DEEPEST {
                search(&path, depth + 1, out)?;
            }
        } else if path.extension().is_some_and(|e| e == "toml") {
            out.push(path);
        }
    }
    Ok(())
}

/// The path from the current folder, where it leads inside it.
pub fn within_project(path: &Path) -> PathBuf {
    let here = std::env::current_dir().ok();
    let inside = here.and_then(|here| path.strip_prefix(here).ok().map(Path::to_path_buf));
    let path = inside.unwrap_or_else(|| path.to_path_buf());
    match path.strip_prefix(".") {
        Ok(rest) if !rest.as_os_str().is_empty() => rest.to_path_buf(),
        _ if path.as_os_str().is_empty() => PathBuf::from("."),
        _ => path,
    }
}

/// Reads every file; all problems of all files together.
pub fn load_all(paths: &[PathBuf]) -> Result<Vec<Derivation>, Stop> {
    let mut derivations: Vec<Derivation> = Vec::new();
    let mut problems = Vec::new();
    for path in paths {
        match load(path) {
            Ok(derivation) => {
                if let Some(first) = derivations.iter().find(|d| d.id == derivation.id) {
                    let message = format!("`{}` has the same id, `{}`", first.file.path, derivation.id);
                    let d = Diagnostic::of_file(&derivation.file.path, "derivation::duplicate-id", message);
                    problems.push(d.hint("give one of them another id, in its table [derivation]"));
                }
                derivations.push(derivation);
            }
            Err(found) => problems.extend(found),
        }
    }
    if problems.is_empty() { Ok(derivations) } else { Err(Stop::Diagnostics(problems)) }
}

/// Notes a filter that names nothing.
pub fn known(derivations: &[Derivation], claims: &[String], trajectories: &[String]) -> Result<(), Stop> {
    let all_claims: Vec<String> = derivations.iter().flat_map(claim_names).collect();
    let all_trajectories: Vec<String> =
        derivations.iter().flat_map(|d| d.trajectories.iter().map(|t| t.id.clone())).collect();
    for (what, wanted, all) in [("claim", claims, all_claims), ("trajectory", trajectories, all_trajectories)] {
        if let Some(name) = wanted.iter().find(|w| !all.contains(w)) {
            let near = nearest(name, all.iter().map(String::as_str));
            let hint = near.map(|n| format!("; did you mean `{n}`?")).unwrap_or_default();
            return Err(Stop::Message(format!("there is no {what} `{name}`{hint}")));
        }
    }
    Ok(())
}

/// Every name by which claims can be called: `id`, and `id/reading`.
fn claim_names(derivation: &Derivation) -> Vec<String> {
    let mut names: Vec<String> = derivation.claims.iter().flat_map(|c| [c.id.clone(), c.name()]).collect();
    names.dedup();
    names
}

/// Whether a derivation has something for these filters.
pub fn concerns(derivation: &Derivation, claims: &[String], trajectories: &[String]) -> bool {
    let names = claim_names(derivation);
    let claim = claims.is_empty() || claims.iter().any(|c| names.contains(c));
    let trajectory =
        trajectories.is_empty() || trajectories.iter().any(|t| derivation.trajectories.iter().any(|d| d.id == *t));
    claim && trajectory
}
