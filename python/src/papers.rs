//! Papers, looked through formula by formula.
//!
//! **In:** the path of a paper, or a text. **Out:** what was found as JSON, each formula as markup, the page.

use std::path::PathBuf;
use std::sync::Arc;

use pyo3::prelude::*;
use rederive::check::Limits;
use rederive::diag::{Diagnostic, Source, escape};
use rederive::{files, lint, paper, report};

use super::{Wait, problems};

type Looked = (String, Vec<String>, String);

fn read(name: &str, text: Option<String>) -> Result<paper::Paper, Box<Diagnostic>> {
    let Some(text) = text else {
        let path = files::named(&PathBuf::from(name));
        let path = path.map_err(|e| Box::new(Diagnostic::of_file(name, "paper::unreadable", e.to_string())))?;
        return paper::read(&path);
    };
    let text = paper::in_displays(&text).into_owned();
    paper::parse_in(Arc::new(Source { path: name.to_owned(), text }), None)
}

/// Looks through the paper `name`, or through a text of that name.
#[pyfunction]
#[pyo3(signature = (name, text=None, deadline=None))]
fn lint_paper(py: Python<'_>, name: String, text: Option<String>, deadline: Option<f64>) -> PyResult<Looked> {
    let until = Limits::after(deadline);
    let found = Wait { until, ..Wait::default() }.compute(py, move || {
        let paper = read(&name, text)?;
        let found = lint::lint(&paper);
        let document = escape::in_json(&report::lint_document(&paper, &found).to_string());
        Ok::<_, Box<Diagnostic>>((document, report::lint_formulas(&paper, &found), report::lint_page(&paper, &found)))
    })?;
    found.map_err(|problem| problems(py, vec![*problem]))
}

pub(super) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(lint_paper, module)?)
}
