//! The command line: arguments, streams, exit codes.

mod check;
mod completions;
mod diff;
mod explain;
mod files;
mod init;
mod list;
mod manual;
mod merge;
mod outputs;
mod prove;
mod report;
mod schema;
mod search;
mod sweep;
mod watch;

use std::io::Write;
use std::panic::AssertUnwindSafe;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use clap::error::ErrorKind;
use clap::{CommandFactory, FromArgMatches, Parser, Subcommand, ValueEnum};
use rederive::Failure;
use rederive::check::{CheckError, Limits, Rigor};
use rederive::diag::shown::{in_one_line, spoken};
use rederive::diag::{Diagnostic, render, sort};
use rederive::files::FileError;

/// How a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Exit {
    /// Every verdict is as expected, and at least one claim was decided.
    Good,
    /// Some verdict differs from what is expected.
    Different,
    /// The command line or a file could not be read, or a report could not be written.
    BadInput,
    /// Nothing differs, but some verdict is undecided without being expected so, or nothing was checked.
    Undecided,
    /// A defect of the program.
    Defect,
}

impl Exit {
    fn code(self) -> u8 {
        match self {
            Exit::Good => 0,
            Exit::Different => 1,
            Exit::BadInput => 2,
            Exit::Undecided => 3,
            Exit::Defect => 70,
        }
    }

    /// The more serious of two.
    fn and(self, other: Exit) -> Exit {
        let rank = |e: Exit| match e {
            Exit::Good => 0,
            Exit::Undecided => 1,
            Exit::Different => 2,
            Exit::BadInput => 3,
            Exit::Defect => 4,
        };
        if rank(other) > rank(self) { other } else { self }
    }
}

const EXIT_CODES: &str = "\
Exit codes:
  0   every verdict is as expected, and at least one claim was decided
  1   some verdict differs from what is expected (without an expectation: some
      claim fails), the units of a formula do not agree, what --strict asks for
      is not met, or --min-discrimination is not reached
  2   the command line or a file could not be read, or a report could not be
      written
  3   nothing differs, but some verdict is undecided that the file does not
      expect to be
  70  a defect of rederive itself";

/// Checks derivations: which claims of a paper hold along which motions, and how strongly.
#[derive(Parser)]
#[command(name = "rederive", version, about, after_help = EXIT_CODES, max_term_width = 100)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Checks derivation files, prints a summary and writes reports
    #[command(after_help = EXIT_CODES)]
    Check(CheckArguments),
    /// Shows how the verdict on one claim came about
    Explain(ExplainArguments),
    /// Lists claims, trajectories and measures of a derivation file
    List(ListArguments),
    /// Decides an equation for all values of its symbols
    #[command(after_help = prove::AFTER_HELP)]
    Prove(prove::ProveArguments),
    /// Searches for a motion on which a claim fails, and prints it as a table of a derivation file
    #[command(after_help = search::EXIT_CODES)]
    Search(search::SearchArguments),
    /// Counts one part of the members of a family, for `merge`: many machines can do one part each
    #[command(after_help = sweep::EXIT_CODES)]
    Sweep(sweep::SweepArguments),
    /// Joins the parts of a family that `sweep` wrote: prints the verdicts, the same as `check` on one machine
    #[command(after_help = EXIT_CODES)]
    Merge(merge::MergeArguments),
    /// Drafts a derivation file from a paper's LaTeX source
    Init(InitArguments),
    /// Makes a PDF file of a report, with LaTeX or a browser, whichever is at hand
    Report(ReportArguments),
    /// Compares two reports: which verdicts changed, and whether for the worse
    Diff(DiffArguments),
    /// Checks a derivation file again whenever it is saved: only what the change concerns
    Watch(WatchArguments),
    /// Prints the JSON Schema of derivation files or of reports
    Schema(SchemaArguments),
    /// Prints completions for a shell
    Completions(CompletionsArguments),
    /// Prints the manual page, or writes all of them
    Manual(ManualArguments),
}

/// How results are printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Format {
    /// A summary for people
    Text,
    /// The report as JSON, one document for each derivation file
    Json,
    /// The report as LaTeX source, for an appendix or a letter; pdflatex compiles it
    Tex,
    /// JUnit XML: a test case for each claim on each trajectory
    Junit,
    /// SARIF 2.1.0, for code scanning: what is not as expected, with its place
    Sarif,
    /// Annotations of a GitHub workflow
    Github,
}

impl Format {
    /// Whether it is printed as soon as a derivation file is checked, and not at the end.
    fn is_printed_by_file(self) -> bool {
        matches!(self, Format::Text | Format::Json | Format::Tex)
    }
}

/// How much is asked of a verdict.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum RigorArgument {
    /// At finitely many times
    Sampled,
    /// At every time of the span where it is possible, with rounding accounted for
    Enclosed,
}

impl From<RigorArgument> for Rigor {
    fn from(argument: RigorArgument) -> Rigor {
        match argument {
            RigorArgument::Sampled => Rigor::Sampled,
            RigorArgument::Enclosed => Rigor::Enclosed,
        }
    }
}

#[derive(clap::Args)]
struct CheckArguments {
    /// Derivation files, or folders that contain them
    #[arg(value_name = "FILE|FOLDER", default_value = "derivations")]
    paths: Vec<PathBuf>,
    /// Only this claim (its id, or id/reading); may be repeated. No report is written then
    #[arg(long, value_name = "ID")]
    claim: Vec<String>,
    /// Only this trajectory; may be repeated. No report is written then
    #[arg(long, value_name = "ID")]
    trajectory: Vec<String>,
    /// What is printed; may be repeated, each with an --output. The summary, unless another format is printed
    #[arg(long, value_enum)]
    format: Vec<Format>,
    /// The file for the --format before it
    #[arg(long, value_name = "FILE")]
    output: Vec<PathBuf>,
    /// The LaTeX source of the paper: formulas that name a label are compared with what is printed under it
    #[arg(long, value_name = "PAPER.TEX")]
    source: Option<PathBuf>,
    /// The two together.
    #[arg(skip)]
    targets: Vec<outputs::Target>,
    /// How much is asked of a verdict
    #[arg(long, value_enum, default_value = "enclosed")]
    rigor: RigorArgument,
    /// Find the verdicts alone: no altered formulas, no corrections, nothing that separates the trajectories, no pictures
    #[arg(long, conflicts_with = "min_discrimination")]
    only_verdicts: bool,
    #[command(flatten)]
    limits: LimitArguments,
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

/// What a run may take.
#[derive(clap::Args)]
struct LimitArguments {
    /// Begin nothing after so many seconds: what is left is undecided. Results may then differ from run to run
    #[arg(long, value_name = "SECONDS", value_parser = seconds)]
    deadline: Option<Duration>,
    /// Begin nothing while so many megabytes are in use: what is left is undecided (on Linux)
    #[arg(long, value_name = "MEGABYTES")]
    memory: Option<u64>,
    /// Use so many threads; as many as there are processors, unless given
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    jobs: Option<u16>,
}

impl LimitArguments {
    /// The limits, counted from now.
    fn begun(&self) -> Limits {
        let deadline = self.deadline.and_then(|after| Instant::now().checked_add(after));
        let memory = self.memory.map(|megabytes| megabytes.saturating_mul(1_000_000));
        Limits { deadline, memory, cancel: None }
    }
}

/// A number of seconds that is not negative.
fn seconds(text: &str) -> Result<Duration, String> {
    let number = text.parse::<f64>().ok().and_then(|x| Duration::try_from_secs_f64(x).ok());
    number.ok_or_else(|| "a number of seconds is expected".to_owned())
}

/// A number from 0 to 1.
fn fraction(text: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok().filter(|x| (0.0..=1.0).contains(x));
    number.ok_or_else(|| "a number from 0 to 1 is expected".to_owned())
}

#[derive(clap::Args)]
struct ExplainArguments {
    /// The claim: its id, or id/reading
    claim: String,
    /// Only on this trajectory; may be repeated
    #[arg(long, value_name = "TRAJECTORY")]
    on: Vec<String>,
    /// Derivation file, or a folder that contains them
    #[arg(value_name = "FILE", default_value = "derivations")]
    path: PathBuf,
    /// How much is asked of a verdict
    #[arg(long, value_enum, default_value = "enclosed")]
    rigor: RigorArgument,
}

#[derive(clap::Args)]
struct ListArguments {
    /// Derivation file, or a folder that contains them
    #[arg(value_name = "FILE", default_value = "derivations")]
    path: PathBuf,
}

#[derive(clap::Args)]
struct InitArguments {
    /// The LaTeX source of the paper
    #[arg(value_name = "PAPER.TEX")]
    paper: PathBuf,
    /// The derivation file, `-` for standard output; without it derivations/PAPER.toml. No file is replaced
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,
}

#[derive(clap::Args)]
struct ReportArguments {
    /// The derivation file
    file: PathBuf,
    /// The PDF file. It is made by latexmk, pdflatex or tectonic; without them, by Chromium, Chrome or Edge
    #[arg(long, value_name = "OUT.PDF", required_unless_present = "summary")]
    pdf: Option<PathBuf>,
    /// The first page alone: printed, or, with --pdf, as a PDF file
    #[arg(long)]
    summary: bool,
    /// How the first page is printed
    #[arg(long, value_enum, default_value = "text", requires = "summary", conflicts_with = "pdf")]
    format: SummaryFormat,
    /// How much is asked of a verdict
    #[arg(long, value_enum, default_value = "enclosed")]
    rigor: RigorArgument,
}

/// How the first page of a report is printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum SummaryFormat {
    /// For a terminal
    Text,
    /// As LaTeX source, for a letter
    Tex,
    /// As Markdown
    Markdown,
}

#[derive(clap::Args)]
struct DiffArguments {
    /// The report as it was: a report.json, or a folder with reports
    old: PathBuf,
    /// The report as it is
    new: PathBuf,
    /// How the changes are printed
    #[arg(long, value_enum, default_value = "text")]
    format: DiffFormat,
}

/// How changes are printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum DiffFormat {
    /// For people
    Text,
    /// For a comment on a pull request
    Markdown,
}

#[derive(clap::Args)]
struct WatchArguments {
    /// The derivation file
    file: PathBuf,
    /// Stop after so many checks
    #[arg(long, value_name = "N")]
    checks: Option<usize>,
}

#[derive(clap::Args)]
struct SchemaArguments {
    /// Of what
    #[arg(value_enum)]
    of: Schema,
}

/// What has a schema.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Schema {
    /// Derivation files
    Derivation,
    /// report.json
    Report,
}

#[derive(clap::Args)]
struct CompletionsArguments {
    /// The shell
    #[arg(value_enum)]
    shell: clap_complete::Shell,
}

#[derive(clap::Args)]
struct ManualArguments {
    /// The folder for the pages of all commands
    #[arg(long, short, value_name = "DIR")]
    output: Option<PathBuf>,
}

/// Why a command stops before its end.
enum Stop {
    /// Problems in files.
    Diagnostics(Vec<Diagnostic>),
    /// Anything else that the user can change, in a sentence.
    Message(String),
    /// The program contradicts itself.
    Defect(String),
}

impl From<FileError> for Stop {
    fn from(error: FileError) -> Stop {
        Stop::Message(error.to_string())
    }
}

impl From<CheckError> for Stop {
    fn from(error: CheckError) -> Stop {
        match error {
            CheckError::Problems(found) => Stop::Diagnostics(found),
            CheckError::Defect(message) => Stop::Defect(message),
        }
    }
}

impl From<Failure> for Stop {
    fn from(failure: Failure) -> Stop {
        match failure {
            Failure::Problems(found) => Stop::Diagnostics(found),
            Failure::Defect(message) => Stop::Defect(message),
            Failure::Unknown(_) | Failure::Parts(_) | Failure::Cancelled => Stop::Message(failure.to_string()),
        }
    }
}

/// Reads a command line.
fn parse(line: impl IntoIterator<Item = std::ffi::OsString>) -> Result<Arguments, clap::Error> {
    let mut command = Arguments::command();
    let matches = command.try_get_matches_from_mut(line)?;
    let mut arguments = Arguments::from_arg_matches(&matches)?;
    if let (Command::Check(check), Some(matches)) = (&mut arguments.command, matches.subcommand_matches("check")) {
        check.targets = outputs::targets(matches, &check.format, &check.output)
            .map_err(|message| command.error(ErrorKind::ArgumentConflict, message))?;
    }
    Ok(arguments)
}

/// Runs a command line, the name of the program first; the exit code.
pub fn run(line: impl IntoIterator<Item = std::ffi::OsString>) -> u8 {
    let arguments = match parse(line) {
        Ok(arguments) => arguments,
        Err(error) => {
            // Help and version come here too, with exit code 0. If they cannot be printed, nobody reads them.
            let _ = error.print();
            return if error.use_stderr() { Exit::BadInput.code() } else { Exit::Good.code() };
        }
    };
    with_threads(&arguments, || guarded(|| command(&arguments))).code()
}

/// Memory for the calls of one thread: formulas, tables and proofs may be nested as deep as their readers allow.
const STACK: usize = 64 << 20;

/// Runs something on threads with enough memory for their calls, and as many of them as were asked for.
fn with_threads(arguments: &Arguments, run: impl FnOnce() -> Exit + Send) -> Exit {
    let jobs = match &arguments.command {
        Command::Check(check) => check.limits.jobs,
        Command::Sweep(sweep) => sweep.jobs,
        _ => None,
    };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(jobs.map_or(0, usize::from)).stack_size(STACK);
    if let Err(error) = pool.build_global() {
        return defect(&format!("its threads cannot be started: {error}"));
    }
    std::thread::scope(|scope| {
        let thread = std::thread::Builder::new().stack_size(STACK).spawn_scoped(scope, run);
        match thread.map(std::thread::ScopedJoinHandle::join) {
            Ok(Ok(exit)) => exit,
            Ok(Err(_)) => defect("it has stopped in the middle of its work"),
            Err(error) => {
                complain(&format!("error: no thread can be started: {error}\n"));
                Exit::BadInput
            }
        }
    })
}

/// Runs a command.
fn command(arguments: &Arguments) -> Result<Exit, Stop> {
    match &arguments.command {
        Command::Check(a) => check::check(a),
        Command::Explain(a) => explain::explain(a),
        Command::List(a) => list::list(a),
        Command::Prove(a) => prove::prove(a),
        Command::Search(a) => search::search(a),
        Command::Sweep(a) => sweep::sweep(a),
        Command::Merge(a) => merge::merge(a),
        Command::Init(a) => init::init(a),
        Command::Report(a) => report::report(a),
        Command::Diff(a) => diff::diff(a),
        Command::Watch(a) => watch::watch(a),
        Command::Schema(a) => schema::schema(a),
        Command::Completions(a) => completions::completions(a),
        Command::Manual(a) => manual::manual(a),
    }
}

/// Runs a command; problems are printed, and a panic is a defect of the program.
fn guarded(command: impl FnOnce() -> Result<Exit, Stop>) -> Exit {
    match std::panic::catch_unwind(AssertUnwindSafe(command)) {
        Ok(Ok(exit)) => exit,
        Ok(Err(Stop::Diagnostics(mut found))) => {
            sort(&mut found);
            complain(&render(&found, true));
            Exit::BadInput
        }
        Ok(Err(Stop::Message(message))) => {
            complain(&format!("error: {}\n", in_one_line(&message)));
            Exit::BadInput
        }
        Ok(Err(Stop::Defect(message))) => defect(&message),
        // The panic itself has been printed.
        Err(_) => defect("it has stopped in the middle of its work"),
    }
}

/// Asks for a report of a defect.
fn defect(message: &str) -> Exit {
    let version = env!("CARGO_PKG_VERSION");
    complain(&format!(
        "\nThis is a defect of rederive {version}, not of your file: {message}.\n\
         Please report it, with the file and what is printed above.\n"
    ));
    Exit::Defect
}

/// Writes to standard error what people read, see [`spoken`]; colours are removed where they are not wanted.
fn complain(text: &str) {
    // If standard error is closed, there is no place left to say so.
    let _ = anstream::stderr().write_all(spoken(text).as_bytes());
}

/// Writes to standard output what people read, see [`spoken`].
fn say(text: &str) -> Result<(), Stop> {
    print(&spoken(text))
}

/// Writes to standard output what programs read, as it is; colours are removed where they are not wanted.
///
/// A reader who has seen enough and closed the pipe is no failure, and does not keep the rest of the work from being done.
fn print(text: &str) -> Result<(), Stop> {
    let mut out = anstream::stdout();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(e) if e.kind() != std::io::ErrorKind::BrokenPipe => {
            Err(Stop::Message(format!("standard output cannot be written: {e}")))
        }
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_is_a_defect() {
        assert_eq!(guarded(|| panic!("on purpose")), Exit::Defect);
        assert_eq!(guarded(|| Err(CheckError::Defect("1 = 2".into()).into())), Exit::Defect);
        assert_eq!(guarded(|| Err(Stop::Message("wrong".into()))), Exit::BadInput);
        assert_eq!(guarded(|| Ok(Exit::Different)), Exit::Different);
    }

    #[test]
    fn the_most_serious_ending_counts() {
        use Exit::{BadInput, Defect, Different, Good, Undecided};
        let order = [Good, Undecided, Different, BadInput, Defect];
        for (i, a) in order.iter().enumerate() {
            for (j, b) in order.iter().enumerate() {
                assert_eq!(a.and(*b), order[i.max(j)]);
            }
        }
        assert_eq!(order.map(Exit::code), [0, 3, 1, 2, 70]);
    }

    #[test]
    fn the_arguments_are_consistent() {
        use clap::CommandFactory;
        Arguments::command().debug_assert();
    }
}
