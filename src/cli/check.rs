//! `rederive check`.

use std::path::{Path, PathBuf};

use rederive::derivation::Derivation;
use rederive::diag::Diagnostic;
use rederive::files::{named, write};
use rederive::paper;
use rederive::{Ask, Detail, Document, Failure, Format, Run, Session, report};

use super::arguments::{LimitArguments, RigorArgument};
use super::ending::{Exit, Stop, complain, print, say};
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
    /// How much is asked of a verdict
    #[arg(long, value_enum, default_value = "enclosed")]
    rigor: RigorArgument,
    /// Find the verdicts alone: no altered formulas, no corrections, nothing that separates the trajectories, no pictures
    #[arg(long, conflicts_with = "min_discrimination")]
    only_verdicts: bool,
    #[command(flatten)]
    pub limits: LimitArguments,
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
    let number = text.parse::<f64>().ok().filter(|x| (0.0..=1.0).contains(x));
    number.ok_or_else(|| "a number from 0 to 1 is expected".to_owned())
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
}

pub fn check(arguments: &CheckArguments) -> Result<Exit, Stop> {
    let mut run = Run::default();
    let detail = arguments.detail();
    let told = |mut run: Run, problems: Vec<Diagnostic>| {
        run.add_problems(&problems);
        arguments.targets.write(&run, detail)?;
        Err(Stop::Diagnostics(problems))
    };
    let source = arguments.source.as_ref().map(|path| named(path)).transpose()?;
    let inputs: Vec<PathBuf> = files::find(&arguments.paths)?;
    let outputs = arguments.targets.files();
    let all_inputs: Vec<PathBuf> = inputs.iter().chain(&source).cloned().collect();
    write::check_outputs(&outputs, &all_inputs, &[])?;
    let sessions = match files::load_all(&inputs) {
        Ok(sessions) => sessions,
        Err(Stop::Diagnostics(problems)) => return told(run, problems),
        Err(stop) => return Err(stop),
    };
    let paper = match source.as_ref().map(|path| paper::read(path)).transpose() {
        Ok(paper) => paper,
        Err(problem) => return told(run, vec![*problem]),
    };
    let subject = || paper::subject(sessions.iter().map(Session::derivation)).map(|d| d.id.clone());
    let about = paper.as_ref().map(|_| subject()).transpose().map_err(Stop::Message)?;
    let format = arguments.targets.standard();
    let asked = files::asked(sessions, &arguments.claim, &arguments.trajectory)?;
    let filtered = !arguments.claim.is_empty() || !arguments.trajectory.is_empty();

    let folder = |d: &Derivation| (!filtered && !arguments.no_reports).then(|| arguments.reports.join(&d.id));
    let folders: Vec<PathBuf> = asked.iter().filter_map(|(session, _)| folder(session.derivation())).collect();
    write::check_outputs(&outputs, &all_inputs, &folders)?;

    let (limits, only_verdicts, rigor) = (arguments.limits.begun(), arguments.only_verdicts, arguments.rigor.into());
    let store = arguments.records.store();
    let mut exit = if asked.is_empty() { Exit::Undecided } else { Exit::Good };
    let mut problems = Vec::new();
    for (i, (session, asked)) in asked.into_iter().enumerate() {
        let ask = Ask { rigor, only_verdicts, limits: limits.clone(), ..asked };
        let findings = match progress::check(&session, &ask, store.as_ref()) {
            Ok(findings) => findings,
            // The other files may have problems, too, or be good.
            Err(Failure::Problems(noted)) => {
                run.add_problems(&noted);
                problems.extend(noted);
                continue;
            }
            Err(other) => return Err(other.into()),
        };
        let is_of_paper = about.as_ref() == Some(&findings.derivation().id);
        let paper = paper.as_ref().filter(|_| is_of_paper).map(|paper| paper::compare(findings.derivation(), paper));
        let document = Document { findings, paper };
        let (derivation, account) = (document.findings.derivation(), document.findings.account());
        let folder = folder(derivation);
        if let Some(folder) = &folder {
            write_reports(folder, &document)?;
        }
        let mut text = document.text(format, detail, true);
        if format == Format::Text && !arguments.quiet {
            text.insert_str(0, if i > 0 { "\n" } else { "" });
            let written = folder.map(|f| format!("report: {}\n", f.join("report.md").display()));
            text.push_str(&written.unwrap_or_default());
        }
        if format == Format::Text {
            say(&text)?
        } else {
            print(&text)?
        }
        if let Some(compared) = &document.paper
            && compared.differences.len() + compared.unknown.len() > 0
        {
            complain(&format!("{}: what it says is not what the paper prints\n", derivation.file.path));
            exit = exit.and(Exit::Different);
        }
        exit = exit.and(Exit::of(&document.findings));
        if arguments.strict {
            for alarm in report::alarms(derivation, account) {
                complain(&format!("{}: {alarm}\n", derivation.file.path));
                exit = exit.and(Exit::Different);
            }
        }
        for (claim, rejected, of) in account.discriminating_less_than(arguments.min_discrimination.unwrap_or(0.0)) {
            complain(&format!("{claim}: only {rejected} of {of} altered formulas are rejected by any motion\n"));
            exit = exit.and(Exit::Different);
        }
        run.add(document);
    }
    arguments.targets.write(&run, detail)?;
    if !problems.is_empty() {
        return Err(Stop::Diagnostics(problems));
    }
    if filtered && !arguments.no_reports && !arguments.quiet {
        complain("no report was written: only a part was checked\n");
    }
    Ok(exit)
}

fn write_reports(folder: &Path, document: &Document) -> Result<(), Stop> {
    let found = &document.findings;
    let data = || {
        let json = document.text(Format::Json, Detail::Usual, false);
        (json, report::certificates(found.derivation(), found.account()))
    };
    let read = || rayon::join(|| found.page(), || found.markdown());
    let ((data, certificates), (page, markdown)) = rayon::join(data, read);
    let files = [("report.json", data), ("report.md", markdown), ("index.html", page)];
    let certificates = certificates.iter().map(|(name, text)| (name.as_str(), text.clone()));
    let files: Vec<(&str, String)> = files.into_iter().chain(certificates).collect();
    Ok(write::write_report(folder, &files, &[report::CERTIFICATES])?)
}
