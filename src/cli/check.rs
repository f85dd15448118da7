//! `rederive check`.

use std::path::PathBuf;

use rederive::check::Recalled;
use rederive::config::Config;
use rederive::derivation::Derivation;
use rederive::files::{named, write};
use rederive::paper;
use rederive::{Ask, Demand, Detail, Document, Ending, Failure, Format, Run, report};

use super::arguments::{LimitArguments, RigorArgument, ThreadArguments, number};
use super::ending::{Stop, answer, complain, concluded, defect};
use super::outputs::Targets;
use super::records::RecordArguments;
use super::{files, progress};

#[derive(clap::Args)]
pub struct CheckArguments {
    /// Derivation files, or folders that contain them
    #[arg(value_name = "FILE|FOLDER", default_value = "derivations")]
    paths: Vec<PathBuf>,
    /// Only this claim (its id, or id/reading); may be repeated. No report is written then
    #[arg(long, value_name = "ID")]
    claim: Vec<String>,
    /// Only this trajectory; may be repeated. No report is written then
    #[arg(long, value_name = "ID")]
    trajectory: Vec<String>,
    #[command(flatten)]
    targets: Targets,
    /// The LaTeX source of the paper: formulas that name a label are compared with what is printed under it
    #[arg(long, value_name = "PAPER.TEX")]
    source: Option<PathBuf>,
    #[command(flatten)]
    rigor: RigorArgument,
    /// Find the verdicts alone: no altered formulas, no corrections, nothing that separates the trajectories, no pictures
    #[arg(long, conflicts_with = "min_discrimination")]
    only_verdicts: bool,
    #[command(flatten)]
    limits: LimitArguments,
    #[command(flatten)]
    pub threads: ThreadArguments,
    #[command(flatten)]
    records: RecordArguments,
    /// Print only what differs from what is expected, and what is undecided
    #[arg(long, short)]
    quiet: bool,
    /// Print the first page alone: the verdict, what does not stand, and what hangs on it
    #[arg(long, conflicts_with_all = ["quiet", "matrix"])]
    summary: bool,
    /// Print the matrix of verdicts, every failure, and all that was found beside the verdicts
    #[arg(long, conflicts_with = "quiet")]
    matrix: bool,
    /// Exit with 1 if a claim applies to no motion, if nothing is decided, or if a proof rests on a refuted premise
    #[arg(long)]
    strict: bool,
    /// Exit with 1 if of some claim that holds less than this share of the altered formulas is rejected, 0 … 1
    #[arg(long, value_name = "FRACTION", value_parser = fraction)]
    min_discrimination: Option<f64>,
    /// The folder for reports: each derivation has a folder of its own in it
    #[arg(long, value_name = "DIR", default_value = "reports")]
    reports: PathBuf,
    /// Write no reports
    #[arg(long, conflicts_with = "reports")]
    no_reports: bool,
}

/// A number from 0 to 1.
fn fraction(text: &str) -> Result<f64, String> {
    number(text, |x| (0.0..=1.0).contains(&x), "a number from 0 to 1 is expected")
}

impl CheckArguments {
    /// How much the text for people says.
    fn detail(&self) -> Detail {
        match (self.quiet, self.summary, self.matrix) {
            (true, ..) => Detail::Exceptions,
            (_, true, _) => Detail::FirstPage,
            (.., true) => Detail::Whole,
            _ => Detail::Usual,
        }
    }

    /// What is asked of all files together.
    fn ask(&self) -> Ask {
        Ask {
            claims: self.claim.clone(),
            trajectories: self.trajectory.clone(),
            rigor: self.rigor.rigor,
            only_verdicts: self.only_verdicts,
            limits: self.limits.begun(),
        }
    }

    /// Takes what the command line does not say from the configuration.
    pub fn configure(&mut self, config: &Config, paths: bool, rigor: bool) {
        if paths && !config.files.is_empty() {
            self.paths.clone_from(&config.files);
        }
        if let (true, Some(named)) = (rigor, config.rigor) {
            self.rigor.rigor = named;
        }
    }

    /// Whether only a part is asked for.
    fn is_partial(&self) -> bool {
        !self.claim.is_empty() || !self.trajectory.is_empty()
    }

    /// The folder of a report; `None` where none is written.
    fn folder(&self, of: &Derivation) -> Option<PathBuf> {
        (!self.is_partial() && !self.no_reports).then(|| self.reports.join(&of.id))
    }
}

pub fn check(arguments: &CheckArguments) -> Result<Ending, Stop> {
    let mut run = Run::default();
    let ending = each_file(arguments, &mut run).or_else(|stop| {
        run.add(Err(*stop.downcast()?))?;
        Ok::<Ending, Stop>(Ending::BadInput)
    })?;
    arguments.targets.write(&run, arguments.detail())?;
    if !run.problems().is_empty() {
        return Err(Failure::from(run.problems().to_vec()).into());
    }
    if arguments.is_partial() && !arguments.no_reports && !arguments.quiet {
        complain("no report was written: only a part was checked");
    }
    Ok(ending)
}

/// Checks file by file, prints and writes what was found, and adds it to the run.
fn each_file(arguments: &CheckArguments, run: &mut Run) -> Result<Ending, Stop> {
    let source = arguments.source.as_ref().map(|path| named(path)).transpose()?;
    let derivations = files::find(&arguments.paths)?;
    let inputs: Vec<PathBuf> = derivations.iter().chain(&source).cloned().collect();
    let outputs = arguments.targets.files();
    write::check_outputs(&outputs, &inputs, &[])?;
    let ask = arguments.ask();
    let sessions = files::sessions(&derivations, &ask.limits)?;
    if let Some(path) = &source {
        run.compare(paper::read(path).map_err(Failure::from)?, &sessions)?;
    }
    let asked = ask.of_each(sessions)?;
    let reports: Vec<PathBuf> =
        asked.iter().filter_map(|(session, _)| arguments.folder(session.derivation())).collect();
    write::check_outputs(&outputs, &inputs, &reports)?;

    let demand = Demand { strict: arguments.strict, discrimination: arguments.min_discrimination.unwrap_or(0.0) };
    let store = arguments.records.store();
    let mut ending = if asked.is_empty() { Ending::Undecided } else { Ending::Good };
    for (i, (session, ask)) in asked.into_iter().enumerate() {
        let document = match progress::check(&session, &ask, store.as_ref()) {
            Err(Failure::Defect(what)) => {
                run.add_defect(session.derivation(), &what);
                ending = ending.max(defect(&format!("{}: {what}", session.derivation().file.path)));
                continue;
            }
            found => run.add(found)?,
        };
        let Some(document) = document else { continue };
        show(arguments, document, i == 0)?;
        let recalled = document.findings.recalled();
        if recalled != Recalled::Nothing && !arguments.quiet {
            complain(&format!("{}: {recalled}; --no-cache asks anew", document.findings.derivation().id));
        }
        ending = ending.max(concluded(document, &demand));
    }
    Ok(ending)
}

/// Writes the report of a file, and prints what is printed file by file.
fn show(arguments: &CheckArguments, document: &Document, is_first: bool) -> Result<(), Stop> {
    let folder = arguments.folder(document.findings.derivation());
    if let Some(folder) = &folder {
        write::write_report(folder, &document.files(), &[report::CERTIFICATES])?;
    }
    let format = arguments.targets.standard();
    let mut text = document.text(format, arguments.detail(), true);
    if format == Format::Text && !arguments.quiet {
        let written = folder.map(|f| format!("report: {}\n", f.join("report.md").display()));
        text = format!("{}{text}{}", if is_first { "" } else { "\n" }, written.unwrap_or_default());
    }
    answer(format, &text)
}
