//! Which derivation files are meant.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use rederive::derivation::{Derivation, load};
use rederive::diag::{Diagnostic, nearest};
use rederive::{Ask, Session, files};

use super::ending::{Stop, complain};

/// Most bytes of a file with parts of a family.
pub const LARGEST_PARTS: u64 = 256 << 20;

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
pub fn load_all(paths: &[PathBuf]) -> Result<Vec<Session>, Stop> {
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
    match problems.is_empty() {
        true => Ok(derivations.into_iter().map(Session::of).collect()),
        false => Err(Stop::Diagnostics(problems)),
    }
}

/// The derivations that have something for these filters, each with what is asked of it.
///
/// # Errors
/// A filter that names nothing.
pub fn asked(sessions: Vec<Session>, claims: &[String], trajectories: &[String]) -> Result<Vec<(Session, Ask)>, Stop> {
    let all = || sessions.iter().map(Session::derivation);
    let all_claims: Vec<String> = all().flat_map(claim_names).collect();
    let all_trajectories: Vec<String> = all().flat_map(motions).map(str::to_owned).collect();
    for (what, wanted, all) in [("claim", claims, all_claims), ("trajectory", trajectories, all_trajectories)] {
        if let Some(name) = wanted.iter().find(|w| !all.contains(w)) {
            let near = nearest(name, all.iter().map(String::as_str));
            let hint = near.map(|n| format!("; did you mean `{n}`?")).unwrap_or_default();
            return Err(Stop::Message(format!("there is no {what} `{name}`{hint}")));
        }
    }
    let of = |session: Session| {
        let names = claim_names(session.derivation());
        let own_claims: Vec<String> = claims.iter().filter(|c| names.contains(c)).cloned().collect();
        let is_own = |t: &&String| motions(session.derivation()).any(|id| id == *t);
        let own_trajectories: Vec<String> = trajectories.iter().filter(is_own).cloned().collect();
        let concerned =
            own_claims.is_empty() == claims.is_empty() && own_trajectories.is_empty() == trajectories.is_empty();
        let ask = Ask { claims: own_claims, trajectories: own_trajectories, ..Ask::default() };
        concerned.then_some((session, ask))
    };
    Ok(sessions.into_iter().filter_map(of).collect())
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
