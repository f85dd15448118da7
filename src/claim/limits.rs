//! Limits of a run that its user sets: a time, memory, and a flag that ends it.
//!
//! **In:** when a run must end, how much memory it may take, and what ends it from outside. **Out:** whether that is reached, asked between one piece of work
//! and the next. What is not begun then is undecided, for this reason.
//!
//! These depend on the machine, so that two runs that reach them may differ. The limits of each piece of work are not these:
//! they count operations, are always there, and give the same on every machine (see `docs/limits.md`).

use reason::Plain;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

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

/// When a run must end, and how much memory it may take.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct Limits {
    /// Nothing is begun after this.
    pub deadline: Option<Instant>,
    /// Nothing is begun while the process holds more than so many bytes; known on Linux only.
    pub memory: Option<u64>,
    /// Nothing is begun once this is raised.
    pub cancel: Option<Cancel>,
}

impl Limits {
    /// The deadline so long from now; none, where that is beyond the clock.
    pub fn after(seconds: Option<f64>) -> Option<Instant> {
        seconds.and_then(|s| Duration::try_from_secs_f64(s).ok()).and_then(|d| Instant::now().checked_add(d))
    }

    /// The limit that is reached.
    pub fn reached(&self) -> Option<Plain> {
        if self.is_cancelled() {
            return Some(Plain::Cancelled);
        }
        if self.is_over() {
            return Some(Plain::TimeOver);
        }
        if self.memory.is_some_and(|most| resident().is_some_and(|now| now > most)) {
            return Some(Plain::MemoryUsedUp);
        }
        None
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_limit_is_reached_when_it_is() {
        assert_eq!(Limits::default().reached(), None);
        let past = Limits { deadline: Some(Instant::now()), ..Limits::default() };
        assert!(past.reached() == Some(Plain::TimeOver));
        let later = Limits { deadline: Limits::after(Some(3600.0)), ..Limits::default() };
        assert!(later.deadline.is_some() && later.reached().is_none());
        assert_eq!([None, Some(-1.0), Some(f64::NAN), Some(f64::MAX)].map(Limits::after), [None; 4]);
        let flag = Cancel::default();
        let ended = Limits { cancel: Some(flag.clone()), ..Limits::default() };
        assert!(!ended.is_cancelled() && ended.reached().is_none());
        flag.raise();
        assert!(ended.is_cancelled() && ended.reached() == Some(Plain::Cancelled));
        assert_ne!(flag, Cancel::default());
        if cfg!(target_os = "linux") {
            assert!(resident().is_some_and(|bytes| bytes > 1 << 20));
            assert!(Limits { memory: Some(1), ..Limits::default() }.reached().is_some());
            assert_eq!(Limits { memory: Some(1 << 50), ..Limits::default() }.reached(), None);
        }
    }
}
