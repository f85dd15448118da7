//! `rederive sweep`.

use std::io::IsTerminal;
use std::path::PathBuf;
use std::sync::Mutex;
use std::time::{Duration, Instant};

use rederive::Ending;
use rederive::check::Limits;
use rederive::check::family::Part;
use rederive::files::lines::Lines;
use rederive::files::{named, read_text, write};

use super::arguments::ThreadArguments;
use super::ending::{Stop, complain};
use super::files::{LARGEST_PARTS, session};
use super::progress;

/// What the exit code of a sweep means.
pub const EXIT_CODES: &str = "\
Exit codes:
  0   the part is counted and its file is written, whatever the verdicts
  2   the command line or a file could not be read, or the part could not be
      counted; no file was written
  70  a defect of rederive itself";

/// How often a sweep that nobody watches says how far it is.
const NOTE: Duration = Duration::from_secs(30);

#[derive(clap::Args)]
pub struct SweepArguments {
    /// The derivation file
    file: PathBuf,
    /// The family, all claims on it
    #[arg(long, value_name = "ID")]
    family: String,
    /// Part K of N: the numbers of the members are divided into N runs, as even as possible
    #[arg(long, value_name = "K/N", default_value = "1/1")]
    part: Part,
    /// The file of the part. It appears once it is whole; what was there is replaced then
    #[arg(long, short, value_name = "FILE")]
    output: PathBuf,
    /// Also write the members as a table: comma-separated values, a line for each with its number, the values of what varies,
    /// the verdicts and what is measured
    #[arg(long, value_name = "FILE", conflicts_with = "resume")]
    members: Option<PathBuf>,
    /// Do nothing if the file is there and is this part, whole, of this file, by this version
    #[arg(long)]
    resume: bool,
    #[command(flatten)]
    pub threads: ThreadArguments,
}

pub fn sweep(arguments: &SweepArguments) -> Result<Ending, Stop> {
    let SweepArguments { family, part, output, .. } = arguments;
    let outputs: Vec<PathBuf> = std::iter::once(output).chain(&arguments.members).cloned().collect();
    write::check_outputs(&outputs, &[named(&arguments.file)?], &[])?;
    let session = session(&arguments.file)?;
    if arguments.resume && read_text(output, LARGEST_PARTS).is_ok_and(|text| session.has_part(&text, family, *part)) {
        complain(&format!("`{}` is part {part} of `{family}` already", output.display()));
        return Ok(Ending::Good);
    }
    let mut table = arguments.members.as_deref().map(Lines::of).transpose()?;
    let mut each = |line: &str| table.iter_mut().for_each(|table| table.add(line));
    let text = watched(&format!("{family} {part}"), |progress| {
        session.sweep_each(family, *part, &Limits::default(), progress, &mut each)
    })?;
    table.map_or(Ok(()), Lines::write)?;
    write::write_file(output, text.as_bytes())?;
    complain(&format!("part {part} of `{family}` is in `{}`", output.display()));
    Ok(Ending::Good)
}

/// Says how far a sweep is: by a bar to who watches, by a line now and then to a file.
fn watched<T>(what: &str, sweep: impl FnOnce(&(dyn Fn(usize, usize) + Sync)) -> T) -> T {
    let bar = progress::bar(what, "{prefix}  {wide_bar}  {pos}/{len}  {eta} left");
    let (begun, told) = (Instant::now(), Mutex::new(Instant::now()));
    let note = |done: usize, of: usize| {
        let Ok(mut told) = told.lock() else { return };
        if told.elapsed() >= NOTE && done > 0 && done < of && !std::io::stderr().is_terminal() {
            *told = Instant::now();
            let left = begun.elapsed().as_secs_f64() * (of - done) as f64 / done as f64;
            complain(&format!("{what}: {done} of {of} members, about {left:.0} s left"));
        }
    };
    progress::counted(&bar, |count| {
        sweep(&|done, of| {
            count(done, of);
            note(done, of);
        })
    })
}
