//! Which files are meant, and what is in them.

use std::path::{Path, PathBuf};

use meter::Limits;
use rederive::derivation::{self, load, load_all};
use rederive::{Ask, Failure, Session, files};

use super::arguments::FileArguments;
use super::ending::{Stop, complain};

/// Most bytes of a file with parts of a family.
pub const LARGEST_PARTS: u64 = 256 << 20;

/// The derivation files that the paths mean.
pub fn find(paths: &[PathBuf]) -> Result<Vec<PathBuf>, Stop> {
    if paths.iter().any(|path| path == Path::new("derivations") && !path.exists()) {
        let message = "there is no folder `derivations` here: name a derivation file or a folder with some, or draft one with \
                       `rederive init PAPER.tex`";
        return Err(message.into());
    }
    let meant = derivation::meant(paths)?;
    for link in &meant.links {
        complain(&format!("`{}` is a link, and a search follows none: name it to check it", link.display()));
    }
    Ok(meant.found)
}

/// The derivation in a file.
pub fn session(path: &Path) -> Result<Session, Stop> {
    Ok(Session::of(load(&files::named(path)?).map_err(Failure::from)?))
}

/// The derivations in several files, read as far as the limits of a run allow.
pub fn sessions(paths: &[PathBuf], limits: &Limits) -> Result<Vec<Session>, Failure> {
    // What is read is bounded by its work; what is over before anything is found leaves a report all the same.
    let limits = &Limits { deadline: None, memory: None, ..limits.clone() };
    let read = meter::under(limits, || load_all(paths)).map_err(|ended| Failure::Defect(ended.to_string()))?;
    Ok(read?.into_iter().map(Session::of).collect())
}

impl FileArguments {
    /// The derivations that are meant.
    pub fn sessions(&self) -> Result<Vec<Session>, Stop> {
        Ok(sessions(&find(std::slice::from_ref(&self.path))?, &Limits::default())?)
    }

    /// Those that have a claim, each with what is asked of it.
    pub fn sessions_with(&self, claim: &str, trajectories: &[String]) -> Result<Vec<(Session, Ask)>, Stop> {
        let claims = vec![claim.to_owned()];
        let ask = Ask { claims, trajectories: trajectories.to_vec(), ..Ask::default() };
        Ok(ask.of_each(self.sessions()?)?)
    }
}
