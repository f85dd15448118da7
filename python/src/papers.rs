//! Papers, looked through formula by formula.
//!
//! **In:** the path of a paper, or a text. **Out:** what was found as JSON, each formula as markup, the page.

use std::path::Path;

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use rederive::config::Config;
use rederive::diag::{Diagnostic, escape};
use rederive::latex::Logarithm;
use rederive::{files, lint, paper, report};

use super::{Limits, Wait, failure, problems};

fn read(name: &str, text: Option<String>) -> Result<paper::Paper, Box<Diagnostic>> {
    if let Some(text) = text {
        return paper::parse_pasted(name, &text);
    }
    let unreadable = |e: files::FileError| Box::new(Diagnostic::of_file(name, "paper::unreadable", e.to_string()));
    paper::read(&files::named(Path::new(name)).map_err(unreadable)?)
}

/// What `\log` is, by its name; unless there is one, what `rederive.toml` says, as on the command line.
pub(super) fn logarithm(py: Python<'_>, name: Option<&str>) -> PyResult<Option<Logarithm>> {
    let unknown = || PyValueError::new_err("`log` is \"natural\" or \"decimal\"");
    match name {
        Some(name) => Logarithm::named(name).ok_or_else(unknown).map(Some),
        None => Config::find().map(|config| config.log).map_err(|e| failure(py, e)),
    }
}

/// Looks through the paper `name`, or through a text of that name.
#[pyfunction]
#[pyo3(signature = (name, text=None, deadline=None, log=None))]
pub(super) fn lint_paper(
    py: Python<'_>,
    name: String,
    text: Option<String>,
    deadline: Option<f64>,
    log: Option<String>,
) -> PyResult<(String, Vec<String>, String)> {
    let logarithm = logarithm(py, log.as_deref())?;
    let limits = Limits { deadline: Limits::after(deadline), ..Limits::default() };
    let found = Wait { until: limits.deadline, ..Wait::default() }.compute(py, move || {
        let mut paper = read(&name, text)?;
        paper.logarithm = logarithm;
        let found = lint::lint(&paper, &limits);
        let document = escape::in_json(report::lint_document(&paper, &found).to_string());
        Ok::<_, Box<Diagnostic>>((document, report::lint_formulas(&paper, &found), report::lint_page(&paper, &found)))
    })?;
    found.map_err(|problem| problems(py, vec![*problem]))
}
