//! The module `_rederive`: the library as Python calls it.
//!
//! **In:** texts, names, numbers. **Out:** documents in JSON, which `package/rederive` makes typed values of; problems as
//! exceptions of `rederive.errors`.
//!
//! **Guaranteed:** while something is computed, other threads of Python run. A signal ends a call within the time of a tick;
//! what it had begun ends by the flag of the library, and nobody waits for it.

#![forbid(unsafe_code)]

mod papers;
mod parts;

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{RecvTimeoutError, sync_channel};
use std::time::{Duration, Instant};

use pyo3::exceptions::PyRuntimeWarning;
use pyo3::prelude::*;
use rederive::check::{Cancel, Defects, Limits, Proposition};
use rederive::diag::{Diagnostic, sort};
use rederive::files::records::{Records, are_of_library};
use rederive::threads::Kept;
use rederive::{Ask, Failure, Question, Rigor};

/// How often a call looks for signals, and says how far it is.
const TICK: Duration = Duration::from_millis(20);

static POOL: Kept = Kept::new();

/// An exception of the package, made by its class.
fn raised(made: PyResult<Bound<'_, PyAny>>) -> PyErr {
    made.map_or_else(|e| e, PyErr::from_value)
}

fn class<'py>(py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
    py.import("rederive.errors")?.getattr(name)
}

fn defect(py: Python<'_>, what: &str) -> PyErr {
    raised(class(py, "Defect").and_then(|c| c.call1((what,))))
}

/// Warns that a piece of the work ended in a defect: all else was done.
fn warned(py: Python<'_>, what: &str) -> PyResult<()> {
    let text = format!("a defect of rederive, please report it: {what}");
    let text = std::ffi::CString::new(text.replace('\0', " ")).unwrap_or_default();
    PyErr::warn(py, &py.get_type::<PyRuntimeWarning>(), &text, 1)
}

fn problems(py: Python<'_>, mut found: Vec<Diagnostic>) -> PyErr {
    sort(&mut found);
    let one = |d: &Diagnostic| {
        let (line, column) = d.line_and_column().unzip();
        (d.code, d.message.clone(), d.source.path.clone(), line, column, d.hint.clone(), d.to_string())
    };
    let all: Vec<_> = found.iter().map(one).collect();
    raised(class(py, "DerivationError").and_then(|c| c.call_method1("of", (all,))))
}

fn failure(py: Python<'_>, failure: Failure) -> PyErr {
    match failure {
        Failure::Problems(found) => problems(py, found),
        Failure::Unknown(unknown) => raised(class(py, "UnknownName").and_then(|c| c.call1((unknown.name,)))),
        Failure::Parts(why) => raised(class(py, "PartError").and_then(|c| c.call1((why,)))),
        Failure::Cancelled => raised(class(py, "Cancelled").and_then(|c| c.call0())),
        Failure::Defect(what) => defect(py, &what),
    }
}

/// How a call is waited for.
#[derive(Default)]
struct Wait<'a> {
    cancel: Cancel,
    /// How many of how many motions are done.
    reached: Arc<(AtomicUsize, AtomicUsize)>,
    progress: Option<&'a Bound<'a, PyAny>>,
    /// After this nobody waits.
    until: Option<Instant>,
}

impl Wait<'_> {
    /// Computes something on the threads of the library.
    fn compute<T: Send + 'static>(self, py: Python<'_>, work: impl FnOnce() -> T + Send + 'static) -> PyResult<T> {
        let before = Defects::so_far();
        let (sender, mut receiver) = sync_channel(1);
        let pool = POOL.threads().map_err(|e| defect(py, &format!("no threads can be started: {e}")))?;
        pool.spawn(move || drop(sender.send(work())));
        let mut told = (0, 0);
        loop {
            let waiting = &mut receiver;
            let left = self.until.map_or(TICK, |until| TICK.min(until.saturating_duration_since(Instant::now())));
            match py.detach(move || waiting.recv_timeout(left)) {
                Ok(value) => {
                    before.since().map_or(Ok(()), |what| warned(py, &what))?;
                    return Ok(value);
                }
                Err(RecvTimeoutError::Disconnected) => return Err(defect(py, "it has stopped in its work")),
                Err(RecvTimeoutError::Timeout) => {}
            }
            let late = self.until.is_some_and(|until| Instant::now() >= until);
            let late = if late { Err(raised(class(py, "DeadlineReached").and_then(|c| c.call0()))) } else { Ok(()) };
            let now = (self.reached.0.load(Ordering::Relaxed), self.reached.1.load(Ordering::Relaxed));
            let tell = || self.progress.filter(|_| now != told).map_or(Ok(()), |p| p.call1(now).map(drop));
            if let Err(stop) = py.check_signals().and_then(|()| tell()).and(late) {
                self.cancel.raise();
                POOL.leave();
                return Err(stop);
            }
            told = now;
        }
    }
}

#[pyclass(frozen)]
struct Session(Arc<rederive::Session>);

#[pymethods]
impl Session {
    /// Reads the text of a derivation file, which says what `\log` is; without one, nothing is declared.
    #[new]
    #[pyo3(signature = (name=String::new(), text=None, log=None))]
    fn new(py: Python<'_>, name: String, text: Option<String>, log: Option<String>) -> PyResult<Session> {
        let Some(text) = text else {
            let logarithm = papers::logarithm(py, log.as_deref())?;
            let blank = rederive::Session::blank();
            return Ok(Session(Arc::new(logarithm.into_iter().fold(blank, rederive::Session::with_logarithm))));
        };
        let read = Wait::default().compute(py, move || rederive::Session::open(&name, text))?;
        read.map(|s| Session(Arc::new(s))).map_err(|found| problems(py, found))
    }

    /// The claims, and the trajectories and families that they are tried on.
    fn pairs(&self) -> Vec<(String, Option<String>, Vec<String>)> {
        self.0.pairs().into_iter().map(|(c, on)| (c.id, c.reading, on)).collect()
    }

    /// `cache`: whether records are kept, and the folder; that of the command line, unless one is given.
    #[pyo3(signature = (claims, trajectories, sampled, only_verdicts, deadline=None, memory=None, cache=(true, None), progress=None))]
    #[expect(clippy::too_many_arguments, reason = "they are named in Python")]
    fn check(
        &self,
        py: Python<'_>,
        claims: Vec<String>,
        trajectories: Vec<String>,
        sampled: bool,
        only_verdicts: bool,
        deadline: Option<f64>,
        memory: Option<u64>,
        cache: (bool, Option<std::path::PathBuf>),
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Findings> {
        let wait = Wait { progress, ..Wait::default() };
        let cancel = Some(wait.cancel.clone());
        let limits = Limits { deadline: Limits::after(deadline), memory, cancel, ..Limits::default() };
        let rigor = if sampled { Rigor::Sampled } else { Rigor::Enclosed };
        let ask = Ask { claims, trajectories, rigor, only_verdicts, limits };
        let (session, tell) = (Arc::clone(&self.0), wait.teller());
        let store = cache.0.then(|| Records::of_user(cache.1, "REDERIVE_CACHE", "rederive")).flatten();
        let found = wait.compute(py, move || match &store {
            Some(store) => session.check_recorded(&ask, store, &tell),
            None => session.check(&ask, &tell),
        })?;
        found.map(|f| Findings(Arc::new(f))).map_err(|e| failure(py, e))
    }

    /// The answer as JSON, and as a person reads it; the formula as MathML.
    #[pyo3(signature = (formula, symbols, given, throughout, scope=None, deadline=None))]
    #[expect(clippy::too_many_arguments, reason = "they are named in Python")]
    fn prove(
        &self,
        py: Python<'_>,
        formula: String,
        symbols: Vec<String>,
        given: Vec<String>,
        throughout: bool,
        scope: Option<String>,
        deadline: Option<f64>,
    ) -> PyResult<(String, String, Option<String>)> {
        let question = Question { proposition: Proposition { formula, given, throughout }, symbols, scope };
        let (session, until) = (Arc::clone(&self.0), Limits::after(deadline));
        let answer = Wait { until, ..Wait::default() }.compute(py, move || session.prove(&question))?;
        answer
            .map(|a| (a.json(), a.text(false, false), a.mathml()))
            .map_err(|e| failure(py, e.where_symbols_are_declared("declare it in `symbols=`")))
    }
}

#[pyclass(frozen)]
struct Findings(Arc<rederive::Findings>);

#[pymethods]
impl Findings {
    /// The document of `report.json`, the page for a browser, or the report in Markdown or LaTeX.
    fn document(&self, py: Python<'_>, format: &str) -> PyResult<String> {
        let found = Arc::clone(&self.0);
        let write = match format {
            "page" => rederive::Findings::page,
            "markdown" => rederive::Findings::markdown,
            "latex" => rederive::Findings::latex,
            _ => rederive::Findings::json,
        };
        Wait::default().compute(py, move || write(&found))
    }

    /// How the verdicts on a claim came about, for a person.
    fn explanation(&self, py: Python<'_>, claim: String) -> PyResult<Option<String>> {
        let found = Arc::clone(&self.0);
        Wait::default().compute(py, move || found.explanation(&claim, &[], false))
    }

    /// The formula that is compared, and (t, left, right, residual, bound, limit) at each time that is kept.
    fn curve(&self, claim: &str, reading: Option<&str>, trajectory: &str) -> Option<(String, Vec<[f64; 6]>)> {
        let series = self.0.curve(claim, reading, trajectory)?;
        let row = |p: &rederive::verdict::ResidualPoint| [p.t, p.left, p.right, p.residual, p.bound, p.limit];
        Some((series.formula.clone(), series.points.iter().map(row).collect()))
    }
}

/// Runs the command `rederive`, its name first; the exit code.
#[pyfunction]
fn command(py: Python<'_>, line: Vec<std::ffi::OsString>) -> u8 {
    py.detach(|| rederive::cli::run(line))
}

#[pymodule]
fn _rederive(module: &Bound<'_, PyModule>) -> PyResult<()> {
    // Whatever Python has loaded it.
    are_of_library(module.getattr("__file__")?.extract()?);
    module.add_class::<Session>()?;
    module.add_class::<Findings>()?;
    module.add_function(wrap_pyfunction!(command, module)?)?;
    module.add_function(wrap_pyfunction!(parts::sweep, module)?)?;
    module.add_function(wrap_pyfunction!(parts::join, module)?)?;
    module.add_function(wrap_pyfunction!(papers::lint_paper, module)?)?;
    module.add("__version__", env!("CARGO_PKG_VERSION"))
}
