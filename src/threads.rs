//! Threads on which sessions are asked.
//!
//! **Guaranteed:** each has the memory that its calls need. What is found does not depend on how many there are.

use std::sync::{Arc, Mutex, PoisonError};

use rayon::{ThreadPool, ThreadPoolBuildError, ThreadPoolBuilder};

/// Memory that a thread needs for the calls of a session: formulas, tables and proofs may be nested as deep as their readers allow.
const STACK: usize = 64 << 20;

/// Threads on which a session can be asked: each has the memory that its calls need. There are as many as processors, unless a number is
/// set.
///
/// ```
/// let threads = rederive::threads().num_threads(2).build().expect("two threads");
/// let opened = threads.install(|| rederive::Session::open("empty.toml", ""));
/// assert!(opened.is_err());
/// ```
pub fn threads() -> ThreadPoolBuilder {
    ThreadPoolBuilder::new().stack_size(STACK)
}

/// Threads that are kept between calls, and the process that they belong to: a fork has none of them.
#[derive(Default)]
pub struct Kept(Mutex<Option<(u32, Arc<ThreadPool>)>>);

impl Kept {
    /// None are there before they are asked for.
    pub const fn new() -> Kept {
        Kept(Mutex::new(None))
    }

    /// The threads of this process. Where a call panics on them, it gives no result.
    ///
    /// # Errors
    /// No threads can be started.
    pub fn threads(&self) -> Result<Arc<ThreadPool>, ThreadPoolBuildError> {
        let process = std::process::id();
        let kept = self.0.lock().unwrap_or_else(PoisonError::into_inner).clone();
        if let Some((_, pool)) = kept.filter(|(of, _)| *of == process) {
            return Ok(pool);
        }
        // A panic is printed, and its caller sees that no result comes.
        let pool = Arc::new(threads().panic_handler(|_| {}).build()?);
        self.exchange(Some((process, Arc::clone(&pool))));
        Ok(pool)
    }

    /// Leaves the threads to what was begun on them: the next call gets others.
    pub fn leave(&self) {
        self.exchange(None);
    }

    fn exchange(&self, new: Option<(u32, Arc<ThreadPool>)>) {
        let old = std::mem::replace(&mut *self.0.lock().unwrap_or_else(PoisonError::into_inner), new);
        // The threads of a parent process are not here to be ended.
        if old.as_ref().is_some_and(|(process, _)| *process != std::process::id()) {
            std::mem::forget(old);
        }
    }
}
