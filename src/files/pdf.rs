//! PDF files of documents that a program at hand prints: LaTeX source, or a page.
//!
//! **In:** a document as LaTeX source (`report.tex`) and as a page (`index.html`). **Out:** the bytes of a whole PDF file, and which
//! program made them; or why each program failed. Nothing is written but in a temporary folder.
//!
//! A LaTeX engine sets the source, for it breaks pages where a reader expects it; where there is none, a browser without a
//! window prints the page. Whatever fails, the next program that is found is tried, and all failures are told if none succeeds.

use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use crate::{read, write};

/// How a program makes a PDF file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Way {
    /// It runs LaTeX as often as needed.
    LatexMake,
    /// It is to be run until references are settled.
    Latex,
    /// A LaTeX engine with packages of its own.
    Tectonic,
    /// It prints a page.
    Browser,
}

/// What is looked for, in this order: LaTeX breaks pages where a reader expects it.
const PROGRAMS: [(&str, Way); 9] = [
    ("latexmk", Way::LatexMake),
    ("pdflatex", Way::Latex),
    ("tectonic", Way::Tectonic),
    ("chromium", Way::Browser),
    ("chromium-browser", Way::Browser),
    ("google-chrome", Way::Browser),
    ("google-chrome-stable", Way::Browser),
    ("chrome", Way::Browser),
    ("msedge", Way::Browser),
];

/// Largest PDF file, in bytes.
const LARGEST_PDF: u64 = 256 << 20;
/// How often LaTeX is run: the second time it knows the widths of its tables, and where its pages are.
const RUNS: usize = 2;
/// How long a program may take.
const PATIENCE: Duration = Duration::from_secs(300);
/// Between two looks at whether it has ended.
const PAUSE: Duration = Duration::from_millis(20);

/// Why there is no PDF file.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    /// None of these programs is on the PATH.
    #[error("a PDF file needs a LaTeX engine or a browser, and none of these programs is on the PATH: {0}")]
    NoProgram(String),
    /// Each program that is there failed.
    #[error("no PDF file was made: {0}")]
    AllFailed(String),
}

/// The programs that can make a PDF file, and are on the PATH, in the order in which they are tried.
#[derive(Debug)]
pub struct Makers(Vec<(&'static str, PathBuf, Way)>);

impl Makers {
    /// Looks for them.
    ///
    /// # Errors
    /// There is none.
    pub fn find() -> Result<Makers, Failure> {
        let found = programs();
        if found.is_empty() {
            let names: Vec<&str> = PROGRAMS.iter().map(|(name, _)| *name).collect();
            return Err(Failure::NoProgram(names.join(", ")));
        }
        Ok(Makers(found))
    }

    /// The PDF file of a document, and the name of the program that made it. `note` is told what a user should know.
    ///
    /// # Errors
    /// No program makes one: which failed, and why.
    pub fn make(&self, tex: String, page: String, note: &dyn Fn(&str)) -> Result<(Vec<u8>, &'static str), Failure> {
        let sources = [("report.tex", tex), ("index.html", page)];
        let mut failures = Vec::new();
        for (name, program, way) in &self.0 {
            match made(program, *way, &sources, note) {
                Ok(pdf) => return Ok((pdf, name)),
                Err(why) => failures.push(format!("{name} {why}")),
            }
        }
        Err(Failure::AllFailed(failures.join("; ")))
    }
}

/// The programs that are on the PATH, in the order in which they are tried.
fn programs() -> Vec<(&'static str, PathBuf, Way)> {
    let folders: Vec<PathBuf> =
        std::env::var_os("PATH").map(|p| std::env::split_paths(&p).collect()).unwrap_or_default();
    // What is named relative to the place where one stands is not looked up.
    let find = |name: &str| {
        let file = format!("{name}{}", std::env::consts::EXE_SUFFIX);
        folders.iter().filter(|f| f.is_absolute()).map(|f| f.join(&file)).find(|p| is_program(p))
    };
    PROGRAMS.iter().filter_map(|(name, way)| Some((*name, find(name)?, *way))).collect()
}

#[cfg(unix)]
fn is_program(path: &Path) -> bool {
    use std::os::unix::fs::PermissionsExt;
    path.metadata().is_ok_and(|m| m.is_file() && m.permissions().mode() & 0o111 != 0)
}

#[cfg(not(unix))]
fn is_program(path: &Path) -> bool {
    path.is_file()
}

/// What a program makes of the sources, in a folder of its own; or why it makes nothing, in words that follow its name.
fn made(program: &Path, way: Way, sources: &[(&str, String)], note: &dyn Fn(&str)) -> Result<Vec<u8>, String> {
    let room = tempfile::tempdir().map_err(|e| format!("was not run, since there is no room for its files: {e}"))?;
    write::write_files(room.path(), sources).map_err(|e| format!("was not run: {e}"))?;
    let folder = room.path();
    let latex = ["-interaction=nonstopmode", "-halt-on-error", "-no-shell-escape"];
    let mut commands = Vec::new();
    match way {
        Way::LatexMake => commands.push(command(program, folder, &[&["-pdf"], &latex[..], &["report.tex"]].concat())),
        Way::Latex => {
            commands.extend((0..RUNS).map(|_| command(program, folder, &[&latex[..], &["report.tex"]].concat())));
        }
        Way::Tectonic => commands.push(command(program, folder, &["--untrusted", "report.tex"])),
        Way::Browser => {
            let mut browser = command(program, folder, &["--headless", "--disable-gpu", "--no-pdf-header-footer"]);
            if is_privileged(folder) {
                // It refuses to build its sandbox then. The page fetches nothing, and its only script is ours.
                note("the browser runs without its sandbox, since this is the administrator's account");
                browser.arg("--no-sandbox");
            }
            browser.arg(format!("--user-data-dir={}", folder.join("profile").display()));
            browser.arg(format!("--print-to-pdf={}", folder.join("report.pdf").display()));
            browser.arg(format!("file://{}", folder.join("index.html").display()));
            commands.push(browser);
        }
    }
    for mut command in commands {
        run(&mut command, folder)?;
    }
    let pdf =
        read(&folder.join("report.pdf"), LARGEST_PDF).map_err(|_| "ended well, but wrote no PDF file".to_owned())?;
    // A file that breaks off is none.
    let tail = &pdf[pdf.len().saturating_sub(1024)..];
    if !pdf.starts_with(b"%PDF-") || !tail.windows(5).any(|w| w == b"%%EOF") {
        return Err("wrote something that is no whole PDF file".to_owned());
    }
    Ok(pdf)
}

fn command(program: &Path, folder: &Path, arguments: &[&str]) -> Command {
    let mut out = Command::new(program);
    out.current_dir(folder).args(arguments).stdin(Stdio::null()).stderr(Stdio::null());
    out
}

/// Whether files that this process makes belong to the administrator.
#[cfg(unix)]
fn is_privileged(folder: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    folder.metadata().is_ok_and(|m| m.uid() == 0)
}

#[cfg(not(unix))]
fn is_privileged(_: &Path) -> bool {
    false
}

/// Runs a program to its end.
fn run(command: &mut Command, folder: &Path) -> Result<(), String> {
    let output = folder.join("output");
    let file = File::create(&output).map_err(|e| format!("was not run: {e}"))?;
    let mut child = command.stdout(file).spawn().map_err(|e| format!("could not be run: {e}"))?;
    let started = Instant::now();
    let status = loop {
        match child.try_wait() {
            Ok(Some(status)) => break status,
            Ok(None) if started.elapsed() < PATIENCE => std::thread::sleep(PAUSE),
            Ok(None) => {
                let _ = child.kill();
                let _ = child.wait();
                return Err(format!("was stopped after {} seconds", PATIENCE.as_secs()));
            }
            Err(e) => return Err(format!("could not be waited for: {e}")),
        }
    };
    if status.success() {
        return Ok(());
    }
    let mut text = Vec::new();
    let _ = File::open(&output).and_then(|mut file| file.read_to_end(&mut text));
    let text = String::from_utf8_lossy(&text);
    // LaTeX marks an error so.
    let why = text.lines().find(|line| line.starts_with('!')).map(|line| format!(": {line}")).unwrap_or_default();
    Err(format!("failed{why}"))
}
