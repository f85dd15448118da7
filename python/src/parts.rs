//! Parts of a family, for programs that share its members among machines.
//!
//! **In:** a session, and which part, or the texts of all of them. **Out:** the text of a part, or what they say together.

use std::sync::Arc;
use std::sync::atomic::Ordering;

use pyo3::prelude::*;
use rederive::Failure;
use rederive::check::Limits;
use rederive::check::family::{MOST_PARTS, Part};

use super::{Findings, Session, Wait, failure};

impl Wait<'_> {
    /// What the library is to tell how far it is.
    pub(super) fn teller(&self) -> impl Fn(usize, usize) + Send + Sync + 'static {
        let reached = Arc::clone(&self.reached);
        move |done, of| {
            reached.0.fetch_max(done, Ordering::Relaxed);
            reached.1.store(of, Ordering::Relaxed);
        }
    }
}

/// The text of one part of a family.
#[pyfunction]
#[pyo3(signature = (session, family, number, of, progress=None))]
pub(super) fn sweep(
    py: Python<'_>,
    session: &Session,
    family: String,
    number: u64,
    of: u64,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<String> {
    let Some(part) = Part::new(number, of) else {
        let message = format!("there is no part {number} of {of}, at most {MOST_PARTS}");
        return Err(failure(py, Failure::Parts(message)));
    };
    let wait = Wait { progress, ..Wait::default() };
    let limits = Limits { cancel: Some(wait.cancel.clone()), ..Limits::default() };
    let (session, tell) = (Arc::clone(&session.0), wait.teller());
    let found = wait.compute(py, move || session.sweep(&family, part, &limits, &tell))?;
    found.map_err(|e| failure(py, e))
}

/// What the texts of all parts of a family say together.
#[pyfunction]
pub(super) fn join(py: Python<'_>, session: &Session, parts: Vec<String>) -> PyResult<Findings> {
    let wait = Wait::default();
    let limits = Limits { cancel: Some(wait.cancel.clone()), ..Limits::default() };
    let session = Arc::clone(&session.0);
    let named = parts.into_iter().enumerate().map(|(n, text)| Ok((format!("text {}", n + 1), text)));
    let found = wait.compute(py, move || session.join(named, &limits, &|_, _| {}))?;
    found.map(|f| Findings(Arc::new(f))).map_err(|e| failure(py, e))
}
