//! A stop in the middle of the work that tests ask for, to see what each way into the program makes of it.
//!
//! **In:** `REDERIVE_FAULT`, the name of a task as the page of limits has it. **Out:** the first piece of that task panics. It is there in every
//! build with debug assertions, and in no other.

use super::Task;
#[cfg(debug_assertions)]
use std::sync::atomic::{AtomicBool, Ordering};

/// Stops in a piece of this task, if that is asked for and was not done.
#[cfg(debug_assertions)]
pub(super) fn stop(task: Task) {
    static DONE: AtomicBool = AtomicBool::new(false);
    let is_asked = || std::env::var_os("REDERIVE_FAULT").is_some_and(|named| named == task.words());
    if !DONE.load(Ordering::Relaxed) && is_asked() && !DONE.swap(true, Ordering::Relaxed) {
        panic!("a stop that was asked for");
    }
}

/// Stops nowhere.
#[cfg(not(debug_assertions))]
#[inline(always)]
pub(super) fn stop(_: Task) {}
