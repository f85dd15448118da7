//! Limits of a run that its user sets: a time, and memory.
//!
//! **In:** when a run must end, and how much memory it may take. **Out:** whether that is reached, asked between one piece of work
//! and the next. What is not begun then is undecided, for this reason.
//!
//! These depend on the machine, so that two runs that reach them may differ. The limits of each piece of work are not these:
//! they count operations, are always there, and give the same on every machine (see `docs/limits.md`).

use std::time::Instant;

/// When a run must end, and how much memory it may take.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct Limits {
    /// Nothing is begun after this.
    pub deadline: Option<Instant>,
    /// Nothing is begun while the process holds more than so many bytes; known on Linux only.
    pub memory: Option<u64>,
}

impl Limits {
    /// The limit that is reached, in words.
    pub fn reached(&self) -> Option<&'static str> {
        if self.deadline.is_some_and(|deadline| Instant::now() >= deadline) {
            return Some("work limit: the time of the run was over before this was begun");
        }
        if self.memory.is_some_and(|most| resident().is_some_and(|now| now > most)) {
            return Some("work limit: the memory of the run was used up before this was begun");
        }
        None
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
        let past = Limits { deadline: Some(Instant::now()), memory: None };
        assert!(past.reached().is_some_and(|words| words.contains("time")));
        let later = Limits { deadline: Instant::now().checked_add(std::time::Duration::from_secs(3600)), memory: None };
        assert_eq!(later.reached(), None);
        if cfg!(target_os = "linux") {
            assert!(resident().is_some_and(|bytes| bytes > 1 << 20));
            assert!(Limits { deadline: None, memory: Some(1) }.reached().is_some());
            assert_eq!(Limits { deadline: None, memory: Some(1 << 50) }.reached(), None);
        }
    }
}
