//! Papers, looked through formula by formula.
//!
//! **In:** the path of a paper, or a text. **Out:** what was found as JSON, each formula as markup, the page.

use std::path::Path;

use pyo3::prelude::*;
use rederive::diag::{Diagnostic, escape};
use rederive::{files, lint, paper, report};

use super::{Limits, Wait, problems};

fn read(name: &str, text: Option<String>) -> Result<paper::Paper, Box<Diagnostic>> {
    if let Some(text) = text {
        return paper::parse_pasted(name, &text);
    }
    let unreadable = |e: files::FileError| Box::new(Diagnostic::of_file(name, "paper::unreadable", e.to_string()));
    paper::read(&files::named(Path::new(name)).map_err(unreadable)?)
}

/// Looks through the paper `name`, or through a text of that name.
#[pyfunction]
#[pyo3(signature = (name, text=None, deadline=None))]
pub(super) fn lint_paper(
    py: Python<'_>,
    name: String,
    text: Option<String>,
    deadline: Option<f64>,
) -> PyResult<(String, Vec<String>, String)> {
    let limits = Limits { deadline: Limits::after(deadline), ..Limits::default() };
    let found = Wait { until: limits.deadline, ..Wait::default() }.compute(py, move || {
        let paper = read(&name, text)?;
        let found = lint::lint(&paper, &limits);
        let document = escape::in_json(&report::lint_document(&paper, &found).to_string());
        Ok::<_, Box<Diagnostic>>((document, report::lint_formulas(&paper, &found), report::lint_page(&paper, &found)))
    })?;
    found.map_err(|problem| problems(py, vec![*problem]))
}
