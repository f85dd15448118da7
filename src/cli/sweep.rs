//! `rederive sweep`.

use std::io::{BufWriter, IsTerminal, Seek, Write};
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::time::{Duration, Instant};

use indicatif::ProgressBar;
use rederive::Session;
use rederive::check::Limits;
use rederive::check::family::{MOST_PARTS, Part};
use rederive::derivation::load;
use rederive::files::{named, read, write};
use rederive::report::read_parts;

use super::ending::{Exit, Stop, complain};
use super::files::LARGEST_PARTS;
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
    #[arg(long, value_name = "K/N", default_value = "1/1", value_parser = part)]
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
    /// Use so many threads; as many as there are processors, unless given
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub jobs: Option<u16>,
}

/// `K/N`.
fn part(text: &str) -> Result<Part, String> {
    let numbers = text.split_once('/').and_then(|(k, n)| Some((k.trim().parse().ok()?, n.trim().parse().ok()?)));
    let Some((number, of)) = numbers else { return Err("a part is written K/N, for instance 3/20".to_owned()) };
    Part::new(number, of).ok_or_else(|| format!("parts are numbered from 1/{of} to {of}/{of}, at most {MOST_PARTS}"))
}

pub fn sweep(arguments: &SweepArguments) -> Result<Exit, Stop> {
    let file = named(&arguments.file)?;
    let output = &arguments.output;
    let outputs: Vec<PathBuf> = std::iter::once(output).chain(&arguments.members).cloned().collect();
    if arguments.members.as_ref().is_some_and(|members| write::same_place(members, output)) {
        return Err(Stop::Message("--members and --output are the same file".to_owned()));
    }
    write::check_outputs(&outputs, std::slice::from_ref(&file), &[])?;
    let derivation = load(&file).map_err(Stop::Diagnostics)?;
    let (family, part) = (&arguments.family, arguments.part);
    if arguments.resume && is_there(output, &derivation.sha256, family, part) {
        complain(&format!("`{}` is part {part} of `{family}` already\n", output.display()));
        return Ok(Exit::Good);
    }
    let session = Session::of(derivation);
    let watch = Watch::begin(format!("{family} {part}"));
    // Lines wait in a file without a name: nothing of them is left if the part is not finished.
    let mut table =
        arguments.members.as_ref().map(|_| tempfile::tempfile().map(BufWriter::new)).transpose().map_err(kept)?;
    let mut failed = None;
    let mut each = |line: &str| {
        if let (Some(table), None) = (&mut table, &failed) {
            failed = table.write_all(line.as_bytes()).err();
        }
    };
    let text = session.sweep_each(family, part, &Limits::default(), &|done, of| watch.reached(done, of), &mut each);
    watch.bar.finish_and_clear();
    let text = text?;
    if let (Some(members), Some(table)) = (&arguments.members, table) {
        failed.map_or(Ok(()), Err).map_err(kept)?;
        let mut table = table.into_inner().map_err(|e| kept(e.into_error()))?;
        table.rewind().map_err(kept)?;
        write::write_from(members, &mut table)?;
    }
    write::write_file(output, text.as_bytes())?;
    complain(&format!("part {part} of `{family}` is in `{}`\n", output.display()));
    Ok(Exit::Good)
}

/// That the lines of members cannot be kept until the part is finished.
fn kept(error: std::io::Error) -> Stop {
    Stop::Message(format!("the members cannot be kept in the folder for temporary files: {error}"))
}

/// Whether a file is this part, whole.
fn is_there(file: &Path, sha256: &str, family: &str, part: Part) -> bool {
    let Some(text) = read(file, LARGEST_PARTS).ok().and_then(|bytes| String::from_utf8(bytes).ok()) else {
        return false;
    };
    let mut found = Vec::new();
    let taken = read_parts(&text, |swept| {
        let same = swept.version == env!("CARGO_PKG_VERSION") && swept.sha256 == sha256;
        found.push(same && swept.family == family && swept.part == part);
        Ok::<(), ()>(())
    });
    taken == Ok(Ok(())) && found == [true]
}

/// Says how far a sweep is: by a bar to who watches, by a line now and then to a file.
struct Watch {
    what: String,
    bar: ProgressBar,
    begun: Instant,
    told: Mutex<Instant>,
}

impl Watch {
    fn begin(what: String) -> Watch {
        let bar = progress::bar(&what, "{prefix}  {wide_bar}  {pos}/{len}  {eta} left");
        let now = Instant::now();
        Watch { what, bar, begun: now, told: Mutex::new(now) }
    }

    fn reached(&self, done: usize, of: usize) {
        self.bar.set_length(of as u64);
        self.bar.set_position(done as u64);
        if std::io::stderr().is_terminal() {
            return;
        }
        let Ok(mut told) = self.told.lock() else { return };
        if told.elapsed() >= NOTE && done > 0 && done < of {
            *told = Instant::now();
            let left = self.begun.elapsed().as_secs_f64() * (of - done) as f64 / done as f64;
            complain(&format!("{}: {done} of {of} members, about {left:.0} s left\n", self.what));
        }
    }
}
