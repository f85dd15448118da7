//! The counted work of a run: how much a piece of it may take, and how a piece ends that takes more.
//!
//! **In:** [`Limits`], which a user sets; the work of loops, told by [`charge`] and [`grow`] where it is done. **Out:** what a
//! [`piece`] gave, or why it [`Ended`]. All pieces of a file have one total, see [`mod@total`].
//!
//! **How:** a piece runs on one thread. Work is counted in units of about a nanosecond on a machine of 2024, memory in bytes of what only
//! grows. Where either is used up, the piece is unwound to its beginning; nothing is printed. The clock, the use of memory and the flag that
//! cancels a run are looked at every `SLICE` units.
//!
//! **Guaranteed:** what is counted depends on the input alone, so that a piece ends in the same place on every machine, whatever the
//! number of threads. A piece that ends takes nothing else with it.

#![forbid(unsafe_code)]

use std::any::Any;
use std::cell::{Cell, RefCell};
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

pub mod factor;
mod faults;
pub mod total;

pub use factor::WorkFactor;
pub use total::{Total, each};

/// So many units pass between two looks at the clock.
const SLICE: u64 = 1 << 24;

macro_rules! tasks {
    ($($(#[$doc:meta])* $name:ident($units:expr, $bytes:expr): $words:literal,)*) => {
        /// What a piece of a run is about.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Task {
            $($(#[$doc])* $name,)*
        }

        impl Task {
            /// All of them.
            pub const ALL: &[Task] = &[$(Task::$name,)*];

            /// Its name in messages and in the table of limits.
            pub fn words(self) -> &'static str {
                match self {
                    $(Task::$name => $words,)*
                }
            }

            /// The units of work that a piece of this task may take.
            pub fn units(self) -> u64 {
                match self {
                    $(Task::$name => $units,)*
                }
            }

            /// The bytes that a piece of this task may let grow.
            pub fn bytes(self) -> u64 {
                match self {
                    $(Task::$name => $bytes,)*
                }
            }
        }
    };
}

const SECOND: u64 = 1_000_000_000;
const MEGABYTE: u64 = 1 << 20;

tasks! {
    /// One file, from its text to formulas.
    Reading(10 * SECOND, 512 * MEGABYTE): "reading a file",
    /// One formula of a file, with all that it calls.
    Formula(SECOND, 64 * MEGABYTE): "reading a formula",
    /// All claims of a file, to comparisons that can be measured.
    Compiling(10 * SECOND, 256 * MEGABYTE): "compiling the claims of a file",
    /// One motion, with those that come from it.
    Motion(20 * SECOND, 256 * MEGABYTE): "computing a motion",
    /// One claim on one motion.
    Sampling(10 * SECOND, 256 * MEGABYTE): "trying a claim on a motion",
    /// One claim, for all values.
    Proving(15 * SECOND, 256 * MEGABYTE): "proving a claim",
    /// One motion, with what all claims ask of it; then each claim.
    Enclosing(15 * SECOND, 256 * MEGABYTE): "enclosing a motion",
    /// One claim over its ranges.
    Ranges(15 * SECOND, 256 * MEGABYTE): "taking ranges apart",
    /// Altered formulas of a claim.
    Weighing(10 * SECOND, 256 * MEGABYTE): "trying altered formulas",
    /// One step of a formula that a paper prints.
    Step(SECOND, 64 * MEGABYTE): "deciding a step of a paper",
    /// Some members of a family, which are integrated together.
    Members(20 * SECOND, 256 * MEGABYTE): "trying members of a family",
}

/// Why a piece ended before it was done.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Ended {
    /// Its counted work is used up, which was so many times the usual.
    Work(Task, WorkFactor),
    /// Its counted memory is used up.
    Bytes(Task, WorkFactor),
    /// The counted work of the file is used up.
    File(Task, WorkFactor),
    /// The deadline of the run has passed.
    Time,
    /// The process holds as much memory as the run may.
    Memory,
    /// The run was cancelled.
    Cancelled,
    /// The program stopped in the middle of it: a defect, in a sentence.
    Defect(String),
}

impl std::fmt::Display for Ended {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Ended::Work(task, times) => {
                let (words, units) = (task.words(), in_thousandths(times.of(task.units()), SECOND));
                write!(f, "work limit: {words} takes more than about {units} s of counted work; {}", more(*times))
            }
            Ended::Bytes(task, times) => {
                let (words, bytes) = (task.words(), in_thousandths(times.of(task.bytes()), MEGABYTE));
                write!(f, "work limit: {words} takes more than {bytes} MB of counted memory; {}", more(*times))
            }
            Ended::File(task, times) => {
                let (words, units) = (task.words(), in_thousandths(times.of(total::OF_A_FILE), SECOND));
                write!(
                    f,
                    "work limit: the file takes more than about {units} s of counted work in all, and {words} comes after that; {}",
                    more(*times)
                )
            }
            Ended::Time => f.write_str("work limit: the time of the run was over before this was done"),
            Ended::Memory => f.write_str("work limit: the memory of the run was used up before this was done"),
            Ended::Cancelled => f.write_str("the run was cancelled"),
            Ended::Defect(what) => write!(f, "a defect of this program: {what}"),
        }
    }
}

impl std::error::Error for Ended {}

/// So many of a unit, to three places.
fn in_thousandths(of: u64, unit: u64) -> f64 {
    (of as f64 / unit as f64 * 1000.0).round() / 1000.0
}

/// The option that would allow more, in words.
fn more(times: WorkFactor) -> String {
    format!("--work {} would allow ten times as much", times.tenfold())
}

/// Ends a run from another thread: raised once, it stays raised. Copies are the same flag.
#[derive(Clone, Debug, Default)]
pub struct Cancel(Arc<AtomicBool>);

impl Cancel {
    /// Ends the run: nothing is begun after this.
    pub fn raise(&self) {
        self.0.store(true, Ordering::Relaxed);
    }

    /// Whether the run is to end.
    pub fn is_raised(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

impl PartialEq for Cancel {
    fn eq(&self, other: &Cancel) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl Eq for Cancel {}

/// When a run must end, how much memory it may take, and how much counted work.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct Limits {
    /// Nothing is begun after this, and what is under way ends.
    pub deadline: Option<Instant>,
    /// The same while the process holds more than so many bytes; known on Linux only.
    pub memory: Option<u64>,
    /// The same once this is raised.
    pub cancel: Option<Cancel>,
    /// The factor on the usual counted work and memory.
    pub work: WorkFactor,
    /// What is left of the work of the file at hand.
    pub total: Total,
}

impl Limits {
    /// The deadline so long from now; none, where that is beyond the clock.
    pub fn after(seconds: Option<f64>) -> Option<Instant> {
        seconds.and_then(|s| Duration::try_from_secs_f64(s).ok()).and_then(|d| Instant::now().checked_add(d))
    }

    /// The limit of the machine that is reached.
    pub fn reached(&self) -> Option<Ended> {
        if self.is_cancelled() {
            return Some(Ended::Cancelled);
        }
        if self.is_over() {
            return Some(Ended::Time);
        }
        self.memory.is_some_and(|most| resident().is_some_and(|now| now > most)).then_some(Ended::Memory)
    }

    /// Whether the run is over: its time, or since it was ended from outside. What is so stays so, unlike the use of memory.
    pub fn is_over(&self) -> bool {
        self.is_cancelled() || self.deadline.is_some_and(|deadline| Instant::now() >= deadline)
    }

    /// Whether it was ended from outside.
    pub fn is_cancelled(&self) -> bool {
        self.cancel.as_ref().is_some_and(Cancel::is_raised)
    }
}

/// The memory that this process holds, in bytes.
fn resident() -> Option<u64> {
    let text = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = text.lines().find_map(|line| line.strip_prefix("VmRSS:"))?;
    line.trim().trim_end_matches("kB").trim().parse::<u64>().ok().map(|kilobytes| 1024 * kilobytes)
}

/// The piece that a thread is at.
struct UnderWay {
    task: Task,
    limits: Limits,
    /// The units that it began with.
    units: u64,
    /// The units beyond those of the slice at hand.
    rest: u64,
    /// Those of the slice at hand, when it was taken.
    slice: u64,
    /// The bytes that may still grow.
    bytes: u64,
}

thread_local! {
    /// The units of the slice at hand; where no piece is under way, they are begun anew.
    static LEFT: Cell<u64> = const { Cell::new(0) };
    static PIECE: RefCell<Option<UnderWay>> = const { RefCell::new(None) };
}

/// Counts work that is done now, in units. Ends the piece that is under way, where its work is used up.
#[inline]
pub fn charge(units: u64) {
    let left = LEFT.get();
    if units <= left { LEFT.set(left - units) } else { begin_slice(units - left) }
}

/// Counts bytes that are held now, and are not given back before the piece ends.
pub fn grow(bytes: u64) {
    let ended = PIECE.with_borrow_mut(|piece| {
        let piece = piece.as_mut()?;
        match piece.bytes.checked_sub(bytes) {
            Some(left) => piece.bytes = left,
            None => return Some(Ended::Bytes(piece.task, piece.limits.work)),
        }
        None
    });
    ended.into_iter().for_each(end);
}

/// Takes a slice of what the piece may take, of which `units` are used already.
#[cold]
fn begin_slice(units: u64) {
    let ended = PIECE.with_borrow_mut(|piece| {
        let Some(piece) = piece else {
            LEFT.set(SLICE);
            return None;
        };
        LEFT.set(0);
        if let Some(ended) = piece.limits.reached().filter(|_| piece.units < u64::MAX) {
            return Some(ended);
        }
        let Some(rest) = piece.rest.checked_sub(units) else {
            piece.rest = 0;
            return Some(Ended::Work(piece.task, piece.limits.work));
        };
        let total = &piece.limits.total;
        total.spend(std::mem::take(&mut piece.slice).saturating_add(units));
        let left = total.left();
        if left == 0 {
            piece.rest = rest;
            total.refuse();
            return Some(Ended::File(piece.task, piece.limits.work));
        }
        piece.slice = rest.min(SLICE).min(left);
        (piece.rest, _) = (rest - piece.slice, LEFT.set(piece.slice));
        None
    });
    ended.into_iter().for_each(end);
}

fn end(ended: Ended) {
    let words = ended.to_string();
    unwind(ended, &words);
}

/// Whether a piece can end before it is done. It cannot where a panic ends the process, as in a page in a browser: there, what takes too
/// much ends the process, with words and a code of its own.
pub const CAN_END: bool = cfg!(panic = "unwind");

/// The code of a process that ends since a piece of it cannot: as `EX_TEMPFAIL` of BSD's `sysexits.h`, the input is not to blame.
pub const TOO_MUCH: i32 = 75;

/// Leaves the work under way for whoever catches this payload; the words say why. It is no panic: nothing is printed.
pub fn unwind<P: Any + Send>(payload: P, words: &str) -> ! {
    if !CAN_END {
        eprintln!("{words}");
        std::process::exit(TOO_MUCH);
    }
    resume_unwind(Box::new(payload))
}

/// Does a piece of the work of a run, as far as it may go. Pieces within a piece are counted for themselves.
///
/// # Errors
/// Why it ended before it was done. A panic in it is told by the hook of panics, and is a defect.
pub fn piece<R>(task: Task, limits: &Limits, work: impl FnOnce() -> R) -> Result<R, Ended> {
    let (units, bytes) = (limits.work.of(task.units()), limits.work.of(task.bytes()));
    if limits.total.left() == 0 {
        limits.total.refuse();
        return Err(Ended::File(task, limits.work));
    }
    let here = UnderWay { task, limits: limits.clone(), units, rest: units, slice: 0, bytes };
    let work = || {
        faults::stop(task);
        work()
    };
    run(here, work).0.map_err(|payload| ended_by(payload.as_ref()))
}

/// The panics that ended pieces of this process.
static DEFECTS: Mutex<Defects> = Mutex::new(Defects { count: 0, last: String::new() });

/// Panics that ended pieces of the work. Whatever was made of such a piece: a run in which there was one has shown a defect of the program.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Defects {
    /// How many there were.
    pub count: u64,
    /// The last of them, in a sentence.
    pub last: String,
}

impl Defects {
    /// Those of this process so far.
    pub fn so_far() -> Defects {
        DEFECTS.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// The last one since then, if there was one.
    pub fn since(&self) -> Option<String> {
        let now = Defects::so_far();
        (now.count > self.count).then_some(now.last)
    }

    /// Counts one that ended no piece: two computations that disagree, beside the verdicts.
    pub fn note(what: &str) {
        let mut all = DEFECTS.lock().unwrap_or_else(PoisonError::into_inner);
        *all = Defects { count: all.count + 1, last: what.to_owned() };
    }
}

/// Does a part of the piece that is under way on this thread: it may take what a piece of its task may, as far as the piece has that left,
/// and is counted with it. Where none is under way, it is a piece.
///
/// # Errors
/// Why it ended before it was done. A panic goes on.
pub fn part<R>(task: Task, work: impl FnOnce() -> R) -> Result<R, Ended> {
    counted(task, work).0
}

/// The same, with the units that were used.
pub fn counted<R>(task: Task, work: impl FnOnce() -> R) -> (Result<R, Ended>, u64) {
    let outer = PIECE.with_borrow(|outer| outer.as_ref().map(|of| (of.task, of.limits.clone(), of.rest, of.bytes)));
    let (whole, limits, rest, most) = outer.unwrap_or((task, Limits::default(), u64::MAX, u64::MAX));
    // What is used counts for the total when it counts for the piece.
    let limits = Limits { total: Total::default(), ..limits };
    let own = (limits.work.of(task.units()), limits.work.of(task.bytes()));
    let units = own.0.min(rest.saturating_add(LEFT.get()));
    let bytes = own.1.min(most);
    let times = limits.work;
    let (found, used) = run(UnderWay { task, limits, units, rest: units, slice: 0, bytes }, work);
    if used.0 > 0 {
        charge(used.0);
    }
    grow(bytes.saturating_sub(used.1));
    let found = found.map_err(|payload| match payload.downcast_ref::<Ended>() {
        // The piece had less left than the part may take: it is the piece that ends.
        Some(Ended::Work(..)) if units < own.0 => resume_unwind(Box::new(Ended::Work(whole, times))),
        Some(Ended::Bytes(..)) if bytes < own.1 => resume_unwind(Box::new(Ended::Bytes(whole, times))),
        Some(ended) => ended.clone(),
        None => resume_unwind(payload),
    });
    (found, used.0)
}

/// Does work that is counted for itself, whatever is under way on this thread, and gives the units that it used: these are the caller's to
/// [`charge`]. So is counted what several threads do of one piece, each of which may be its own. `None` where it takes more than `most`
/// units, or a limit of the machine is reached. A panic goes on.
pub fn apart<R>(limits: &Limits, most: u64, work: impl FnOnce() -> R) -> (Option<R>, u64) {
    let limits = Limits { total: Total::default(), ..limits.clone() };
    let here = UnderWay { task: Task::Ranges, limits, units: most, rest: most, slice: 0, bytes: u64::MAX };
    let (found, (units, _)) = run(here, work);
    match found {
        Ok(found) => (Some(found), units),
        Err(payload) if payload.is::<Ended>() => (None, units),
        Err(payload) => resume_unwind(payload),
    }
}

/// The limits of the piece that is under way on this thread; the usual ones, where none is.
pub fn limits() -> Limits {
    PIECE.with_borrow(|here| here.as_ref().map(|of| of.limits.clone())).unwrap_or_default()
}

/// Does work whose parts obey the limits of a run; the work itself is not limited.
///
/// # Errors
/// A panic in it, which is a defect.
pub fn under<R>(limits: &Limits, work: impl FnOnce() -> R) -> Result<R, Ended> {
    let limits = Limits { total: Total::default(), ..limits.clone() };
    let here = UnderWay { task: Task::Reading, limits, units: u64::MAX, rest: u64::MAX, slice: 0, bytes: u64::MAX };
    run(here, work).0.map_err(|payload| ended_by(payload.as_ref()))
}

/// What the work gave or was unwound by; the units that it used, and the bytes that are left.
fn run<R>(here: UnderWay, work: impl FnOnce() -> R) -> (std::thread::Result<R>, (u64, u64)) {
    let units = here.units;
    let outer = (LEFT.replace(0), PIECE.replace(Some(here)));
    let found = catch_unwind(AssertUnwindSafe(work));
    let left = LEFT.replace(outer.0);
    let (rest, bytes) = PIECE.replace(outer.1).map_or((0, 0), |piece| {
        piece.limits.total.spend(piece.slice.saturating_sub(left));
        (piece.rest, piece.bytes)
    });
    (found, (units.saturating_sub(rest.saturating_add(left)), bytes))
}

/// Why a piece was unwound.
fn ended_by(payload: &(dyn Any + Send)) -> Ended {
    if let Some(ended) = payload.downcast_ref::<Ended>() {
        return ended.clone();
    }
    let text = payload.downcast_ref::<String>().map(String::as_str).or_else(|| payload.downcast_ref().copied());
    let what = format!("it stopped in the middle of its work: {}", text.unwrap_or("for no reason that is known"));
    Defects::note(&what);
    Ended::Defect(what)
}

#[cfg(test)]
mod tests;
