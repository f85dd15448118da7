//! The command line: which commands there are, and how they are run.
//!
//! A command has a file of its own, with its arguments, and imports no other; what they share is in `ending`, `arguments`, `files`,
//! `progress`, `records` and `outputs`. Questions about a derivation go through [`Session`](rederive::Session).

mod arguments;
mod audit;
mod check;
mod completions;
mod diff;
mod ending;
mod explain;
mod files;
mod init;
mod lint;
mod list;
mod lsp;
mod manual;
mod mcp;
mod merge;
mod outputs;
mod progress;
mod prove;
mod records;
mod report;
mod schema;
mod search;
mod sweep;
mod watch;
mod wire;

use clap::parser::ValueSource;
use clap::{ArgMatches, CommandFactory, FromArgMatches, Parser, Subcommand};
use ending::{EXIT_CODES, Stop, complain, guarded};
use rederive::Ending;

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
    Check(check::CheckArguments),
    /// Shows how the verdict on one claim came about
    Explain(explain::ExplainArguments),
    /// Lists claims, trajectories and measures of a derivation file
    List(list::ListArguments),
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
    /// Says of every formula that a paper prints whether it follows, is wrong, or was not followed
    #[command(after_help = lint::AFTER_HELP)]
    Lint(lint::LintArguments),
    /// Drafts a derivation file from a paper's LaTeX source
    Init(init::InitArguments),
    /// Makes a PDF file of a report, with LaTeX or a browser, whichever is at hand
    Report(report::ReportArguments),
    /// Replays the recorded proofs of reports with the checker, without the prover
    Audit(audit::AuditArguments),
    /// Compares two reports: which verdicts changed, and whether for the worse
    Diff(diff::DiffArguments),
    /// Checks a derivation file again whenever it is saved: only what the change concerns
    Watch(watch::WatchArguments),
    /// Serves an editor: problems and verdicts while a paper or a derivation file is written
    Lsp(lsp::LspArguments),
    /// Serves agents by the model context protocol: tools that prove, look papers through, check
    Mcp(mcp::McpArguments),
    /// Prints the JSON Schema of derivation files or of reports
    Schema(schema::SchemaArguments),
    /// Prints completions for a shell
    Completions(completions::CompletionsArguments),
    /// Prints the manual page, or writes all of them
    Manual(manual::ManualArguments),
}

/// The columns of a terminal of which the size is not known, or is told as 0.
const USUAL_COLUMNS: usize = 80;

/// The width of the terminal that is written to: as `COLUMNS` says, else as the terminal itself does, else the usual one; `None` where it
/// is none.
fn terminal_width() -> Option<usize> {
    let out = std::io::stdout();
    if !std::io::IsTerminal::is_terminal(&out) {
        return None;
    }
    let told = std::env::var("COLUMNS").ok().and_then(|text| text.trim().parse().ok());
    let of_terminal = terminal_size::terminal_size_of(out).map(|(width, _)| usize::from(width.0));
    Some(columns(told, of_terminal))
}

/// The first of two widths that is known: 0 is none.
fn columns(told: Option<usize>, of_terminal: Option<usize>) -> usize {
    let is_known = |columns: &usize| *columns > 0;
    told.filter(is_known).or(of_terminal.filter(is_known)).unwrap_or(USUAL_COLUMNS)
}

/// Runs a command line, the name of the program first; the exit code.
pub fn run(line: impl IntoIterator<Item = std::ffi::OsString>) -> u8 {
    if let Some(columns) = terminal_width() {
        rederive::report::fit_terminal(columns);
    }
    let mut line: Vec<std::ffi::OsString> = line.into_iter().collect();
    // A paper in the place of a command is looked through.
    if line.get(1).is_some_and(|word| lint::is_paper(word)) {
        line.insert(1, "lint".into());
    }
    let (mut arguments, matches) = match parsed(&line) {
        Ok(arguments) => arguments,
        Err(error)
            if error.kind() == clap::error::ErrorKind::InvalidSubcommand
                && let Some(what) = line.get(1).and_then(|word| lint::instead_of_command(word)) =>
        {
            complain(&format!("error: {what}"));
            return Ending::BadInput.code();
        }
        Err(error) if let Some(what) = page_as_format(&line, &error) => {
            complain(&format!("error: {what}"));
            return Ending::BadInput.code();
        }
        Err(error) => {
            // Help and version come here too, with exit code 0. If they cannot be printed, nobody reads them. Words of the line
            // are quoted: what would act in them is a sign.
            let seen: Vec<_> =
                line.iter().map(|word| rederive::diag::escape::in_signs(&word.to_string_lossy()).into()).collect();
            let _ = parsed(&seen).err().unwrap_or_else(|| clap::Error::new(error.kind())).print();
            return if error.use_stderr() { Ending::BadInput.code() } else { Ending::Good.code() };
        }
    };
    // What the command line does not say, the configuration does.
    if let (Command::Check(check), Some(("check", given))) = (&mut arguments.command, matches.subcommand()) {
        let is_default = |id: &str| given.value_source(id) == Some(ValueSource::DefaultValue);
        let configured = guarded(|| {
            check.configure(&rederive::config::Config::find()?, is_default("paths"), is_default("rigor"));
            Ok(Ending::Good)
        });
        if configured != Ending::Good {
            return configured.code();
        }
    }
    with_threads(&arguments, || guarded(|| command(&arguments))).code()
}

/// What to write where a page is asked for as a format.
fn page_as_format(line: &[std::ffi::OsString], error: &clap::Error) -> Option<String> {
    let value = error.get(clap::error::ContextKind::InvalidValue).map(ToString::to_string);
    let is_page = error.kind() == clap::error::ErrorKind::InvalidValue && value.as_deref() == Some("html");
    let instead = match line.get(1).and_then(|word| word.to_str()) {
        Some("lint") => "`rederive lint PAPER.TEX --html FILE` writes the page",
        Some("check") => "`rederive check` writes the page index.html into the folder of the report, see --reports",
        _ => return None,
    };
    is_page.then(|| format!("`html` is no --format: {instead}"))
}

/// What a command line asks for.
fn parsed(line: &[std::ffi::OsString]) -> Result<(Arguments, ArgMatches), clap::Error> {
    let matches = Arguments::command().try_get_matches_from(line)?;
    Ok((Arguments::from_arg_matches(&matches)?, matches))
}

/// Runs something on as many threads as were asked for.
fn with_threads(arguments: &Arguments, run: impl FnOnce() -> Ending + Send) -> Ending {
    let jobs = match &arguments.command {
        Command::Check(check) => check.threads.jobs,
        Command::Sweep(sweep) => sweep.threads.jobs,
        _ => None,
    };
    match rederive::threads().num_threads(jobs.map_or(0, usize::from)).build() {
        Ok(threads) => threads.install(run),
        Err(error) => {
            complain(&format!("error: no thread can be started: {error}"));
            Ending::BadInput
        }
    }
}

/// Runs a command.
fn command(arguments: &Arguments) -> Result<Ending, Stop> {
    match &arguments.command {
        Command::Check(a) => check::check(a),
        Command::Explain(a) => explain::explain(a),
        Command::List(a) => list::list(a),
        Command::Prove(a) => prove::prove(a),
        Command::Search(a) => search::search(a),
        Command::Sweep(a) => sweep::sweep(a),
        Command::Merge(a) => merge::merge(a),
        Command::Lint(a) => lint::lint(a),
        Command::Init(a) => init::init(a),
        Command::Report(a) => report::report(a),
        Command::Audit(a) => audit::audit(a),
        Command::Diff(a) => diff::diff(a),
        Command::Watch(a) => watch::watch(a),
        Command::Lsp(a) => lsp::lsp(a),
        Command::Mcp(a) => mcp::mcp(a),
        Command::Schema(a) => schema::schema(a),
        Command::Completions(a) => completions::completions(a, Arguments::command()),
        Command::Manual(a) => manual::manual(a, Arguments::command()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_arguments_are_consistent() {
        Arguments::command().debug_assert();
    }

    #[test]
    fn a_terminal_without_a_size_has_eighty_columns() {
        assert_eq!(columns(None, None), 80);
        assert_eq!(columns(None, Some(0)), 80);
        assert_eq!(columns(Some(0), Some(120)), 120);
        assert_eq!(columns(Some(90), Some(120)), 90);
    }
}
