//! The counted work of a file: one total, of which all its pieces take theirs.
//!
//! **In:** how much a file may take ([`Limits::of_file`]); work that is done side by side ([`each`]). **Out:** what a piece may still take.
//!
//! **How:** what is done one after the other takes from the total as it comes. What is done side by side is a *row* of items in an order:
//! an item may take what those before it in the row leave. While these are still at work that is not known; only that it is not more than
//! what they have left so far. So an item that is refused too late or too early for that reason is done once more, after all of the row,
//! when it is known.
//!
//! **Guaranteed:** which pieces are refused, and where, is as if all had been done one after the other in the order of the row, whatever
//! the number of threads. What is done twice is at most as much as there are threads, and what is refused takes no time.

use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use rayon::prelude::*;

use crate::{Limits, SECOND};

/// The units of work that a file may take, from its first formula to the last verdict.
pub const OF_A_FILE: u64 = 33 * SECOND;

/// What is left of the work of a file; without end, where there is none. Copies are the same.
#[derive(Clone, Debug, Default)]
pub struct Total(Option<Arc<Account>>);

impl PartialEq for Total {
    fn eq(&self, other: &Total) -> bool {
        match (&self.0, &other.0) {
            (Some(a), Some(b)) => Arc::ptr_eq(a, b),
            (a, b) => a.is_none() && b.is_none(),
        }
    }
}

impl Eq for Total {}

#[derive(Debug)]
enum Account {
    /// That of a whole file.
    Whole { most: u64, used: AtomicU64 },
    /// That of an item of a row.
    Item { row: Arc<Row>, at: usize },
}

/// Items that are done side by side.
#[derive(Debug)]
struct Row {
    /// What was left when they were begun.
    most: u64,
    state: Mutex<State>,
}

#[derive(Debug)]
struct State {
    /// What each has used, as a tree of sums (Fenwick): the sum of the first n takes log n steps.
    sums: Vec<u64>,
    used: Vec<u64>,
    /// For an item that was refused, what those before it had used then.
    refused: Vec<Option<u64>>,
}

impl State {
    /// What the first n have used.
    fn before(&self, n: usize) -> u64 {
        let (mut at, mut sum) = (n, 0u64);
        while at > 0 {
            sum = sum.saturating_add(self.sums[at - 1]);
            at &= at - 1;
        }
        sum
    }

    fn add(&mut self, item: usize, units: u64) {
        self.used[item] = self.used[item].saturating_add(units);
        self.change(item, |sum| sum.saturating_add(units));
    }

    /// As if it had not been done.
    fn forget(&mut self, item: usize) {
        let units = std::mem::take(&mut self.used[item]);
        self.refused[item] = None;
        self.change(item, |sum| sum.saturating_sub(units));
    }

    fn change(&mut self, item: usize, new: impl Fn(u64) -> u64) {
        let mut at = item + 1;
        while let Some(sum) = self.sums.get_mut(at - 1) {
            *sum = new(*sum);
            at += at & at.wrapping_neg();
        }
    }
}

impl Row {
    fn new(most: u64, items: usize) -> Row {
        let state = State { sums: vec![0; items], used: vec![0; items], refused: vec![None; items] };
        Row { most, state: Mutex::new(state) }
    }

    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Whether an item was done as it would have been after all those before it. These are.
    fn is_settled(&self, item: usize) -> bool {
        let state = self.state();
        let before = state.before(item);
        let used = before.saturating_add(state.used[item]);
        match state.refused[item] {
            None => used <= self.most,
            Some(then) => then == before && used <= self.most,
        }
    }
}

impl Total {
    fn of(account: Account) -> Total {
        Total(Some(Arc::new(account)))
    }

    /// The units that are left.
    pub fn left(&self) -> u64 {
        match self.0.as_deref() {
            None => u64::MAX,
            Some(Account::Whole { most, used }) => most.saturating_sub(used.load(Ordering::Relaxed)),
            Some(Account::Item { row, at }) => row.most.saturating_sub(row.state().before(at + 1)),
        }
    }

    /// The units that a whole file has used.
    pub fn used(&self) -> u64 {
        match self.0.as_deref() {
            Some(Account::Whole { used, .. }) => used.load(Ordering::Relaxed),
            None | Some(Account::Item { .. }) => 0,
        }
    }

    /// Counts units that were used.
    pub fn spend(&self, units: u64) {
        match self.0.as_deref() {
            None => {}
            Some(Account::Whole { used, .. }) => {
                // Nothing else changes it at this time: what is done side by side has accounts of its own.
                used.store(used.load(Ordering::Relaxed).saturating_add(units), Ordering::Relaxed);
            }
            Some(Account::Item { row, at }) => row.state().add(*at, units),
        }
    }

    /// Notes that something was refused, since nothing is left.
    pub(crate) fn refuse(&self) {
        if let Some(Account::Item { row, at }) = self.0.as_deref() {
            let mut state = row.state();
            let before = state.before(*at);
            state.refused[*at].get_or_insert(before);
        }
    }
}

impl Limits {
    /// The same for one file, of whose work so much is used already.
    #[must_use]
    pub fn of_file(&self, used: u64) -> Limits {
        self.of_most(self.work.of(OF_A_FILE), used)
    }

    /// The same for one of so many equal parts of the work of a file, of which nothing is used yet.
    #[must_use]
    pub fn of_part(&self, parts: u64) -> Limits {
        self.of_most(self.work.of(OF_A_FILE) / parts.max(1), 0)
    }

    fn of_most(&self, most: u64, used: u64) -> Limits {
        let total = Total::of(Account::Whole { most, used: AtomicU64::new(used.min(most)) });
        Limits { total, ..self.clone() }
    }
}

/// Does something with each item, side by side, in order: each obeys the limits that it is handed. What an item gives when nothing is left
/// of the work of the file is its own to say: a piece of it is refused then.
///
/// Inside of an item, and where there is no total, this is a loop like any other.
pub fn each<T: Sync, R: Send>(limits: &Limits, items: &[T], work: impl Fn(&T, &Limits) -> R + Sync) -> Vec<R> {
    let left = match limits.total.0.as_deref() {
        None => return items.par_iter().with_max_len(1).map(|item| work(item, limits)).collect(),
        // Of a row within a row nobody knows the order.
        Some(Account::Item { .. }) => return items.iter().map(|item| work(item, limits)).collect(),
        Some(Account::Whole { .. }) => limits.total.left(),
    };
    let row = Arc::new(Row::new(left, items.len()));
    let one = |(at, item): (usize, &T)| {
        let total = Total::of(Account::Item { row: Arc::clone(&row), at });
        work(item, &Limits { total, ..limits.clone() })
    };
    let mut found: Vec<R> = items.par_iter().enumerate().with_max_len(1).map(one).collect();
    for (at, found) in found.iter_mut().enumerate() {
        if !row.is_settled(at) {
            row.state().forget(at);
            *found = one((at, &items[at]));
        }
    }
    limits.total.spend(row.state().before(items.len()));
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Ended, Task, WorkFactor, charge, piece};

    /// How far each of some items of so many seconds in tenths comes.
    fn walk(items: &[u64], threads: usize) -> (Vec<Result<(), Ended>>, u64) {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        let limits = Limits::default().of_file(OF_A_FILE - 20 * SECOND);
        let found = pool.install(|| {
            each(&limits, items, |&tenths, limits| {
                piece(Task::Motion, limits, || (0..tenths * 100).for_each(|_| charge(1_000_000)))
            })
        });
        (found, limits.total.left())
    }

    #[test]
    fn the_same_items_are_refused_whatever_the_number_of_threads() {
        let refused = || Err(Ended::File(Task::Motion, WorkFactor::default()));
        let cases: [(&[u64], usize); 4] = [
            (&[10; 30], 20),
            // The first is slow: those behind it are ahead of it, and are taken back.
            (&[150, 49, 2, 50, 1], 2),
            (&[0, 0, 199, 2, 0], 3),
            (&[100, 101], 1),
        ];
        for (items, done) in cases {
            for threads in [1, 2, 5] {
                let (found, _) = walk(items, threads);
                assert!(found[..done].iter().all(Result::is_ok), "{items:?} {threads}: {found:?}");
                assert_eq!(found[done], refused(), "{items:?} {threads}");
                assert_eq!(walk(items, threads), walk(items, 1), "{items:?} {threads}");
            }
        }
        assert_eq!(walk(&[50; 4], 2), (vec![Ok(()); 4], 0));
        assert_eq!(walk(&[], 2), (Vec::new(), 20 * SECOND));
    }

    #[test]
    fn without_a_total_nothing_is_refused() {
        let found =
            each(&Limits::default(), &[1u64; 9], |_, limits| piece(Task::Motion, limits, || charge(8 * SECOND)));
        assert_eq!(found, vec![Ok(()); 9]);
    }
}
