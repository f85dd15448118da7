//! `rederive check`.

use std::io::IsTerminal;
use std::path::{Path, PathBuf};
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use rederive::check::{Account, CheckError, ClaimAccount, Options, Summary};
use rederive::derivation::Derivation;
use rederive::diag::Diagnostic;
use rederive::files::{named, write};
use rederive::paper::{self, Comparison};
use rederive::report;

use super::outputs::{Detail, Found, json, standard, summary};
use super::{CheckArguments, Exit, Format, Stop, complain, files, print, say};

pub fn check(arguments: &CheckArguments) -> Result<Exit, Stop> {
    let mut found = Found::default();
    let detail = Detail::of(arguments);
    let told = |found: &Found, problems: Vec<Diagnostic>| {
        found.write(&arguments.targets, detail)?;
        Err(Stop::Diagnostics(problems))
    };
    let source = arguments.source.as_ref().map(|path| named(path)).transpose()?;
    let inputs: Vec<PathBuf> = files::find(&arguments.paths)?;
    let outputs: Vec<PathBuf> = arguments.targets.iter().filter_map(|t| t.output.clone()).collect();
    let all_inputs: Vec<PathBuf> = inputs.iter().chain(&source).cloned().collect();
    write::check_outputs(&outputs, &all_inputs, &[])?;
    let mut derivations = match files::load_all(&inputs) {
        Ok(derivations) => derivations,
        Err(Stop::Diagnostics(problems)) => {
            found.problems(&problems);
            return told(&found, problems);
        }
        Err(stop) => return Err(stop),
    };
    let paper = match source.as_ref().map(|path| paper::read(path)).transpose() {
        Ok(paper) => paper,
        Err(problem) => {
            found.problems(&[*problem.clone()]);
            return told(&found, vec![*problem]);
        }
    };
    let about = paper.as_ref().map(|_| of_the_paper(&derivations)).transpose()?;
    let format = standard(&arguments.targets);
    files::known(&derivations, &arguments.claim, &arguments.trajectory)?;
    derivations.retain(|d| files::concerns(d, &arguments.claim, &arguments.trajectory));
    let (claims, trajectories) = (&arguments.claim, &arguments.trajectory);
    let filtered = !claims.is_empty() || !trajectories.is_empty();

    let folder = |d: &Derivation| (!filtered && !arguments.no_reports).then(|| arguments.reports.join(&d.id));
    let folders: Vec<PathBuf> = derivations.iter().filter_map(folder).collect();
    write::check_outputs(&outputs, &all_inputs, &folders)?;

    let (limits, plain, rigor) = (arguments.limits.begun(), arguments.only_verdicts, arguments.rigor.into());
    let options = Options { rigor, plain, limits, ..Options::default() };
    let mut exit = if derivations.is_empty() { Exit::Undecided } else { Exit::Good };
    let mut problems = Vec::new();
    for (i, mut derivation) in derivations.into_iter().enumerate() {
        let account = match account(&mut derivation, claims, trajectories, &options) {
            Ok(account) => account,
            // The other files may have problems, too, or be good.
            Err(CheckError::Problems(noted)) => {
                found.problems(&noted);
                problems.extend(noted);
                continue;
            }
            Err(defect) => return Err(defect.into()),
        };
        let compared = paper.as_ref().filter(|_| about.as_ref() == Some(&derivation.id));
        let compared = compared.map(|paper| paper::compare(&derivation, paper));
        let folder = folder(&derivation);
        if let Some(folder) = &folder {
            write_reports(folder, &derivation, &account, compared.as_ref())?;
        }
        let mut text = match (format, arguments.quiet) {
            (Format::Json, _) => json(&derivation, &account, compared.as_ref()),
            (Format::Tex, _) if arguments.summary => report::tex_summary(&derivation, &account),
            (Format::Tex, _) => report::tex(&derivation, &account),
            (Format::Text, true) => report::exceptions(&derivation, &account, true),
            (Format::Text, false) => summary(&derivation, &account, compared.as_ref(), detail, true),
            _ => String::new(),
        };
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
        if let Some(compared) = &compared
            && compared.differences.len() + compared.unknown.len() > 0
        {
            complain(&format!("{}: what it says is not what the paper prints\n", derivation.file.path));
            exit = exit.and(Exit::Different);
        }
        exit = exit.and(ending(&derivation, &account));
        if arguments.strict {
            for alarm in report::alarms(&derivation, &account) {
                complain(&format!("{}: {alarm}\n", derivation.file.path));
                exit = exit.and(Exit::Different);
            }
        }
        for (claim, rejected, of) in account.discriminating_less_than(arguments.min_discrimination.unwrap_or(0.0)) {
            complain(&format!("{claim}: only {rejected} of {of} altered formulas are rejected by any motion\n"));
            exit = exit.and(Exit::Different);
        }
        found.account(derivation, account, compared);
    }
    found.write(&arguments.targets, detail)?;
    if !problems.is_empty() {
        return Err(Stop::Diagnostics(problems));
    }
    if filtered && !arguments.no_reports && !arguments.quiet {
        complain("no report was written: only a part was checked\n");
    }
    Ok(exit)
}

/// After this time a run says what it does.
const PATIENCE: Duration = Duration::from_millis(400);
/// How often it shows that it goes on.
const TICK: Duration = Duration::from_millis(200);

/// Checks one derivation, with a progress bar on a terminal if it takes long.
///
/// `claims` are ids, or `id/reading` for one reading; all if empty, as for trajectories.
pub fn account(
    derivation: &mut Derivation,
    claims: &[String],
    trajectories: &[String],
    options: &Options,
) -> Result<Account, CheckError> {
    let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden());
    if std::io::stderr().is_terminal()
        && let Ok(style) = ProgressStyle::with_template("{spinner} {prefix}: {msg}  {wide_bar}  {pos}/{len}")
    {
        bar.set_style(style);
        bar.set_prefix(derivation.id.clone());
        bar.set_message("motions are built");
        // What takes long says so by itself, also while nothing is done yet.
        let bar = bar.clone();
        std::thread::spawn(move || {
            std::thread::sleep(PATIENCE);
            if !bar.is_finished() {
                bar.set_draw_target(ProgressDrawTarget::stderr());
                bar.enable_steady_tick(TICK);
            }
        });
    }
    let progress = |done: usize, of: usize| {
        bar.set_length(of as u64);
        bar.set_position(done as u64);
        bar.set_message(if done < of { "claims are tried on motions" } else { "proofs, enclosures, altered formulas" });
    };
    let ids = claims.iter().map(|c| c.split('/').next().unwrap_or(c).to_owned()).collect();
    let options = Options { claims: ids, trajectories: trajectories.to_vec(), ..options.clone() };
    let account = rederive::check::check(derivation, &options, &progress);
    bar.finish_and_clear();
    account.map(|mut account| {
        let wanted = |c: &ClaimAccount| {
            let reading = c.reading.as_ref().map(|r| format!("{}/{r}", c.id));
            claims.is_empty() || claims.contains(&c.id) || reading.is_some_and(|name| claims.contains(&name))
        };
        account.claims.retain(wanted);
        account
    })
}

/// The derivation that a paper is compared with: the only one, or the only one that names labels.
fn of_the_paper(derivations: &[Derivation]) -> Result<String, Stop> {
    let labels =
        |d: &&Derivation| d.claims.iter().any(|c| c.label.is_some()) || d.systems.iter().any(|s| s.label.is_some());
    let named: Vec<&Derivation> = derivations.iter().filter(labels).collect();
    match (derivations, named.as_slice()) {
        ([one], _) => Ok(one.id.clone()),
        (_, [one]) => Ok(one.id.clone()),
        (_, []) => {
            Err(Stop::Message("no derivation file names a label, so that none can be compared with a paper".to_owned()))
        }
        (_, many) => {
            let names: Vec<&str> = many.iter().map(|d| d.id.as_str()).collect();
            let message =
                format!("`--source` is the paper of one derivation file, but {} name labels", names.join(", "));
            Err(Stop::Message(message))
        }
    }
}

/// What the verdicts of a file end a run with; what is not to be seen in them is said.
pub fn ending(derivation: &Derivation, account: &Account) -> Exit {
    let summary = account.summary();
    let mut exit = exit_of(&summary);
    if summary.holds + summary.fails == 0 {
        complain(&format!("{}: no claim was decided\n", derivation.file.path));
        exit = exit.and(Exit::Undecided);
    }
    if let Some((claim, on, why)) = account.defects().next() {
        let more = account.defects().count() - 1;
        let more = if more > 0 { format!(" (and {more} more)") } else { String::new() };
        exit = exit.and(super::defect(&format!("{claim} on {on}{more} has no verdict: {why}")));
    }
    if account.units.unexpected() > 0 { exit.and(Exit::Different) } else { exit }
}

fn exit_of(summary: &Summary) -> Exit {
    if summary.unexpected > 0 {
        Exit::Different
    } else if summary.open > 0 {
        Exit::Undecided
    } else {
        Exit::Good
    }
}

fn write_reports(
    folder: &Path,
    derivation: &Derivation,
    account: &Account,
    paper: Option<&Comparison>,
) -> Result<(), Stop> {
    let data = || (json(derivation, account, paper), report::certificates(derivation, account));
    let read = || rayon::join(|| report::page(derivation, account), || report::markdown(derivation, account));
    let ((data, certificates), (page, markdown)) = rayon::join(data, read);
    let files = [("report.json", data), ("report.md", markdown), ("index.html", page)];
    let certificates = certificates.iter().map(|(name, text)| (name.as_str(), text.clone()));
    let files: Vec<(&str, String)> = files.into_iter().chain(certificates).collect();
    Ok(write::write_report(folder, &files, &[report::CERTIFICATES])?)
}
