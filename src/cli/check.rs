//! `rederive check`.

use std::io::IsTerminal;
use std::path::Path;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use rederive::check::{Account, CheckError, ClaimAccount, Options, Rigor, Summary};
use rederive::derivation::Derivation;
use rederive::report;

use super::outputs::{Found, standard};
use super::{CheckArguments, Exit, Format, Stop, complain, files, print};

pub fn check(arguments: &CheckArguments) -> Result<Exit, Stop> {
    let mut found = Found::default();
    let mut derivations = match files::load_all(&files::find(&arguments.paths)?) {
        Ok(derivations) => derivations,
        Err(Stop::Diagnostics(problems)) => {
            found.problems(&problems);
            found.write(&arguments.targets, arguments.quiet)?;
            return Err(Stop::Diagnostics(problems));
        }
        Err(stop) => return Err(stop),
    };
    let format = standard(&arguments.targets);
    files::known(&derivations, &arguments.claim, &arguments.trajectory)?;
    derivations.retain(|d| files::concerns(d, &arguments.claim, &arguments.trajectory));
    let (claims, trajectories) = (&arguments.claim, &arguments.trajectory);
    let filtered = !claims.is_empty() || !trajectories.is_empty();

    let mut exit = if derivations.is_empty() { Exit::Undecided } else { Exit::Good };
    let mut problems = Vec::new();
    for (i, mut derivation) in derivations.into_iter().enumerate() {
        let account = match account(&mut derivation, claims, trajectories, arguments.rigor.into()) {
            Ok(account) => account,
            // The other files may have problems, too, or be good.
            Err(CheckError::Problems(noted)) => {
                found.problems(&noted);
                problems.extend(noted);
                continue;
            }
            Err(defect) => return Err(defect.into()),
        };
        let folder = (!filtered && !arguments.no_reports).then(|| arguments.reports.join(&derivation.id));
        if let Some(folder) = &folder {
            write_reports(folder, &derivation, &account)?;
        }
        let mut text = match (format, arguments.quiet) {
            (Format::Json, _) => report::json(&derivation, &account),
            (Format::Tex, _) => report::tex(&derivation, &account),
            (Format::Text, true) => report::exceptions(&derivation, &account, true),
            (Format::Text, false) => report::summary(&derivation, &account, true),
            _ => String::new(),
        };
        if format == Format::Text && !arguments.quiet {
            text.insert_str(0, if i > 0 { "\n" } else { "" });
            let written = folder.map(|f| format!("report: {}\n", f.join("report.md").display()));
            text.push_str(&written.unwrap_or_default());
        }
        print(&text)?;
        let summary = account.summary();
        if summary.holds + summary.fails == 0 {
            complain(&format!("{}: no claim was decided\n", derivation.file.path));
            exit = exit.and(Exit::Undecided);
        }
        exit = exit.and(exit_of(&summary));
        if account.units.unexpected() > 0 {
            exit = exit.and(Exit::Different);
        }
        for (claim, rejected, of) in account.discriminating_less_than(arguments.min_discrimination.unwrap_or(0.0)) {
            complain(&format!("{claim}: only {rejected} of {of} altered formulas are rejected by any motion\n"));
            exit = exit.and(Exit::Different);
        }
        found.findings.extend(report::findings(&derivation, &account));
        found.checked.push((derivation, account));
    }
    found.write(&arguments.targets, arguments.quiet)?;
    if !problems.is_empty() {
        return Err(Stop::Diagnostics(problems));
    }
    if filtered && !arguments.no_reports && !arguments.quiet {
        complain("no report was written: only a part was checked\n");
    }
    Ok(exit)
}

/// Checks one derivation, with a progress bar on a terminal if it takes long.
///
/// `claims` are ids, or `id/reading` for one reading; all if empty, as for trajectories.
pub fn account(
    derivation: &mut Derivation,
    claims: &[String],
    trajectories: &[String],
    rigor: Rigor,
) -> Result<Account, CheckError> {
    let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden());
    if std::io::stderr().is_terminal()
        && let Ok(style) = ProgressStyle::with_template("{prefix}  {wide_bar}  {pos}/{len}")
    {
        bar.set_style(style);
        bar.set_prefix(derivation.id.clone());
    }
    let started = std::time::Instant::now();
    let progress = |done: usize, of: usize| {
        let long = started.elapsed() > Duration::from_millis(500);
        if long && bar.is_hidden() && std::io::stderr().is_terminal() {
            bar.set_draw_target(ProgressDrawTarget::stderr());
        }
        bar.set_length(of as u64);
        bar.set_position(done as u64);
    };
    let ids = claims.iter().map(|c| c.split('/').next().unwrap_or(c).to_owned()).collect();
    let options = Options { claims: ids, trajectories: trajectories.to_vec(), rigor, ..Options::default() };
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

fn exit_of(summary: &Summary) -> Exit {
    if summary.unexpected > 0 {
        Exit::Different
    } else if summary.open > 0 {
        Exit::Undecided
    } else {
        Exit::Good
    }
}

fn write_reports(folder: &Path, derivation: &Derivation, account: &Account) -> Result<(), Stop> {
    let files = [
        ("report.json", report::json(derivation, account)),
        ("report.md", report::markdown(derivation, account)),
        ("index.html", report::page(derivation, account)),
    ];
    let certificates = report::certificates(derivation, account);
    let certificates = certificates.iter().map(|(name, text)| (name.as_str(), text.clone()));
    let files: Vec<(&str, String)> = files.into_iter().chain(certificates).collect();
    report::write_report(folder, &files, &[report::CERTIFICATES]).map_err(|e| Stop::Message(e.to_string()))
}
