//! `rederive.toml`: what a project is checked with, when the command line does not say.
//!
//! **In:** a folder: that in which the program runs, or that of a paper. **Out:** a [`Config`]: the nearest `rederive.toml`, or table
//! `[tool.rederive]` of a `pyproject.toml`, in it or in a folder above it. **Guaranteed:** a key that is not known, and a value of another
//! kind, is a problem with its place; what the command line, or a call of Python, says wins.

use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

use crate::Failure;
use crate::check::Rigor;
use crate::diag::{Diagnostic, Source};
use crate::files;
use crate::latex::Logarithm;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Largest size of a configuration, in bytes.
const LARGEST: u64 = 1 << 20;

/// Longest path of a configuration, in bytes: no system opens longer ones.
const LONGEST: usize = 4096;

/// What a project is checked with.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Config {
    /// The papers that `rederive lint` looks through.
    pub sources: Vec<PathBuf>,
    /// The derivation files, or folders of them, that `rederive check` checks.
    pub files: Vec<PathBuf>,
    /// How much is asked of a verdict.
    pub rigor: Option<Rigor>,
    /// What `\log` is in papers, and in what is proved without a file.
    pub log: Option<Logarithm>,
}

impl Config {
    /// The configuration of the folder in which the program runs; nothing is set where there is none.
    ///
    /// # Errors
    /// A file that cannot be read, and problems of what is in it, with their places.
    pub fn find() -> Result<Config, Failure> {
        std::env::current_dir().map_or_else(|_| Ok(Config::default()), |here| Config::of(&here))
    }

    /// The configuration of a folder, of which the whole path is given.
    ///
    /// # Errors
    /// As for [`find`](Config::find).
    pub fn of(here: &Path) -> Result<Config, Failure> {
        for folder in here.ancestors() {
            for (name, table) in [("rederive.toml", &[][..]), ("pyproject.toml", &["tool", "rederive"][..])] {
                let path = folder.join(name);
                // A link may lead to what is none of the repository's; so it is no configuration.
                if !path.symlink_metadata().is_ok_and(|found| found.is_file()) {
                    continue;
                }
                let shown = path.display().to_string();
                let unreadable = |e: files::FileError| Diagnostic::of_file(&shown, "config::unreadable", e.to_string());
                let text = files::read_text(&path, LARGEST).map_err(|e| Failure::Problems(vec![unreadable(e)]))?;
                if let Some(config) = read(&path, text, table, relative(folder, here).as_deref())? {
                    return Ok(config);
                }
            }
        }
        Ok(Config::default())
    }
}

/// How a folder above another one is written from there.
fn relative(folder: &Path, here: &Path) -> Option<PathBuf> {
    let below = here.strip_prefix(folder).ok()?;
    Some(below.components().map(|_| "..").collect())
}

/// Reads a configuration; `None` where the file does not have the table.
fn read(path: &Path, text: String, table: &[&str], folder: Option<&Path>) -> Result<Option<Config>, Failure> {
    let source = Arc::new(Source { path: path.display().to_string(), text });
    let problem = |span: std::ops::Range<usize>, message: String| -> Failure {
        Failure::Problems(vec![Diagnostic::at(&source, "config::unreadable", span, message)])
    };
    let parsed =
        DeTable::parse(&source.text).map_err(|e| problem(e.span().unwrap_or_default(), e.message().to_owned()))?;
    let mut at = parsed.get_ref();
    for key in table {
        match at.get(*key).map(Spanned::get_ref) {
            Some(DeValue::Table(inner)) => at = inner,
            _ => return Ok(None),
        }
    }
    let mut config = Config::default();
    for (key, value) in at {
        let span = value.span();
        match key.get_ref().as_ref() {
            "sources" => config.sources = paths(value, folder).map_err(|(s, m)| problem(s, m))?,
            "files" => config.files = paths(value, folder).map_err(|(s, m)| problem(s, m))?,
            "rigor" => {
                let named = |r: &Rigor| value.get_ref().as_str() == Some(r.words().0);
                let names: Vec<&str> = Rigor::ALL.iter().map(|r| r.words().0).collect();
                let found = Rigor::ALL.into_iter().find(named);
                config.rigor =
                    Some(found.ok_or_else(|| problem(span, format!("`rigor` is one of {}", names.join(", "))))?);
            }
            "log" => {
                let found = value.get_ref().as_str().and_then(Logarithm::named);
                let names = Logarithm::ALL.map(|(name, ..)| name).join(", ");
                config.log = Some(found.ok_or_else(|| problem(span, format!("`log` is one of {names}")))?);
            }
            other => {
                let other = crate::diag::escape::in_one_line(other);
                let message = format!("the key `{other}` is not known; there are `sources`, `files`, `rigor`, `log`");
                return Err(problem(key.span(), message));
            }
        }
    }
    Ok(Some(config))
}

/// A list of paths, or one; they are those of the folder of the configuration.
fn paths(
    value: &Spanned<DeValue<'_>>,
    folder: Option<&Path>,
) -> Result<Vec<PathBuf>, (std::ops::Range<usize>, String)> {
    let one = |v: &Spanned<DeValue<'_>>| {
        let text = v.get_ref().as_str().ok_or((v.span(), "a path is a text".to_owned()))?;
        if text.len() > LONGEST {
            return Err((v.span(), format!("a path has at most {LONGEST} bytes")));
        }
        // A repository says what it is checked with, and nothing outside of it is looked at for that.
        if !Path::new(text).components().all(|part| matches!(part, Component::Normal(_) | Component::CurDir)) {
            return Err((v.span(), "a path of a configuration stays in its folder".to_owned()));
        }
        let mut path = folder.map_or_else(PathBuf::new, Path::to_path_buf);
        for part in Path::new(text).components() {
            path.push(part);
            if path.symlink_metadata().is_ok_and(|found| found.is_symlink()) {
                return Err((v.span(), "a path of a configuration goes through no link".to_owned()));
            }
        }
        Ok(path)
    };
    match value.get_ref() {
        DeValue::Array(all) => all.iter().map(one).collect(),
        DeValue::String(_) => Ok(vec![one(value)?]),
        _ => Err((value.span(), "this is a list of paths".to_owned())),
    }
}
