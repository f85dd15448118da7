//! Which derivation files are meant.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use rederive::derivation::{Derivation, load};
use rederive::diag::{Diagnostic, nearest};
use rederive::files;

use super::{Stop, complain};

/// The derivation files that the paths name: files as they are, folders searched for `*.toml`, each once, in order.
pub fn find(paths: &[PathBuf]) -> Result<Vec<PathBuf>, Stop> {
    let mut found = Vec::new();
    for path in paths {
        if !path.exists() && path == Path::new("derivations") {
            let message = "there is no folder `derivations` here: name a derivation file or a folder with some, or draft one with \
                           `rederive init PAPER.tex`";
            return Err(Stop::Message(message.to_owned()));
        }
        let path = files::named(path)?;
        if !path.is_dir() {
            found.push(path);
            continue;
        }
        let inside = files::search(&path, &|p| p.extension().is_some_and(|e| e == "toml"))?;
        for link in &inside.links {
            complain(&format!("`{}` is a link, and a search follows none: name it to check it\n", link.display()));
        }
        if inside.found.is_empty() {
            return Err(Stop::Message(format!("there is no derivation file (*.toml) in `{}`", path.display())));
        }
        found.extend(inside.found);
    }
    let mut seen = BTreeSet::new();
    found.retain(|p| seen.insert(p.clone()));
    Ok(found)
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
    let all_trajectories: Vec<String> = derivations.iter().flat_map(motions).map(str::to_owned).collect();
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

/// The ids of trajectories and families.
fn motions(derivation: &Derivation) -> impl Iterator<Item = &str> {
    let families = derivation.families.iter().map(|f| f.id.as_str());
    derivation.trajectories.iter().map(|t| t.id.as_str()).chain(families)
}

/// Whether a derivation has something for these filters.
pub fn concerns(derivation: &Derivation, claims: &[String], trajectories: &[String]) -> bool {
    let names = claim_names(derivation);
    let claim = claims.is_empty() || claims.iter().any(|c| names.contains(c));
    let trajectory = trajectories.is_empty() || trajectories.iter().any(|t| motions(derivation).any(|id| id == t));
    claim && trajectory
}
