//! Answers, kept by the names of their questions.
//!
//! **In:** the name of a question, and how its answer is found. **Out:** the answer that is known, or the one that is found, and kept.
//! All kinds of questions share one table: a name begins with what kind it is of, and an answer is kept as bytes, which are read when it
//! is asked for. **Guaranteed:** what is not asked for in [`AGES`] states of a file is forgotten.

use std::collections::HashMap;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

use serde::Serialize;
use serde::de::DeserializeOwned;
use sha2::{Digest, Sha256};

use claim::limits::Cancel;
use files::records::LARGEST;

/// For how many states of a file an answer is kept that is not asked for.
pub(super) const AGES: u64 = 8;

/// The name of a question.
pub type Key = [u8; 32];

/// The name of a question with several parts.
pub fn key(parts: &[&[u8]]) -> Key {
    let mut sum = Sha256::new();
    for part in parts {
        sum.update((part.len() as u64).to_le_bytes());
        sum.update(part);
    }
    sum.finalize().into()
}

/// A name in hexadecimal digits, as records have them.
pub fn in_digits(name: &Key) -> String {
    name.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// An answer as bytes.
#[derive(Debug)]
struct Kept {
    /// The last age in which it was asked for.
    age: u64,
    /// The counted work of finding it, in equal parts of what was found with it; `None` until that is over.
    work: Option<u64>,
    answer: Arc<[u8]>,
}

impl Kept {
    /// Its bytes with those of its name, about.
    fn size(&self) -> u64 {
        self.answer.len() as u64 + 128
    }
}

/// Answers by name.
#[derive(Debug, Default)]
pub struct Answers {
    age: u64,
    kept: Mutex<HashMap<Key, Kept>>,
    /// The counted work of finding the answers that were known in this state of the file.
    recalled: AtomicU64,
    /// How many answers were known when they were asked for, and how many were found and kept, since the table is there.
    counts: [AtomicUsize; 2],
    /// The bytes of what is kept.
    bytes: AtomicU64,
    /// Ends the check at hand: what is found once it is raised may not be the answer, and is not kept.
    cancel: Option<Cancel>,
}

impl Answers {
    /// How many answers were known when they were asked for, and how many were found and kept, in this process.
    pub fn counts(&self) -> [usize; 2] {
        self.counts.each_ref().map(|count| count.load(Ordering::Relaxed))
    }

    /// The flag that ends the check that comes next.
    pub fn until(&mut self, cancel: Option<&Cancel>) {
        self.cancel = cancel.cloned();
    }

    /// Whether the check at hand was ended from outside.
    pub fn is_cancelled(&self) -> bool {
        self.cancel.as_ref().is_some_and(Cancel::is_raised)
    }

    /// Whether some were left out, since together they are too large to be kept.
    pub fn are_too_large(&self) -> bool {
        self.bytes.load(Ordering::Relaxed) > LARGEST
    }

    /// A new state of the file begins.
    pub fn grow_older(&mut self) {
        self.age += 1;
        let now = self.age;
        *self.recalled.get_mut() = 0;
        let kept = self.kept.get_mut().unwrap_or_else(PoisonError::into_inner);
        kept.retain(|_, kept| kept.age + AGES >= now);
        *self.bytes.get_mut() = kept.values().map(Kept::size).sum();
    }

    /// How many states of the file there were.
    pub fn age(&self) -> u64 {
        self.age
    }

    /// The counted work that was spared in this state of the file, since answers were known from before.
    pub fn recalled(&self) -> u64 {
        self.recalled.load(Ordering::Relaxed)
    }

    /// The answer to a question, if it is known.
    pub fn known<T: DeserializeOwned>(&self, name: Key) -> Option<T> {
        let bytes = {
            let mut kept = self.kept.lock().unwrap_or_else(PoisonError::into_inner);
            let kept = kept.get_mut(&name)?;
            if std::mem::replace(&mut kept.age, self.age) != self.age {
                self.recalled.fetch_add(kept.work.unwrap_or(0), Ordering::Relaxed);
            }
            Arc::clone(&kept.answer)
        };
        let answer = postcard::from_bytes(&bytes).ok()?;
        self.counts[0].fetch_add(1, Ordering::Relaxed);
        Some(answer)
    }

    /// Keeps an answer; one that cannot be written is found again, and so is one of a check that was ended.
    pub fn keep<T: Serialize>(&self, name: Key, answer: &T) {
        if self.is_cancelled() {
            return;
        }
        self.counts[1].fetch_add(1, Ordering::Relaxed);
        if let Ok(bytes) = postcard::to_allocvec(answer) {
            // What does not fit is found again when it is asked for.
            let kept = Kept { age: self.age, work: None, answer: bytes.into() };
            if self.bytes.fetch_add(kept.size(), Ordering::Relaxed) > LARGEST {
                return;
            }
            self.kept.lock().unwrap_or_else(PoisonError::into_inner).insert(name, kept);
        }
    }

    /// The answer to a question; what has no name is always found anew.
    pub fn answer<T: Serialize + DeserializeOwned>(&self, name: Option<Key>, find: impl FnOnce() -> T) -> T {
        let Some(name) = name else { return find() };
        self.known(name).unwrap_or_else(|| {
            let found = find();
            self.keep(name, &found);
            found
        })
    }

    /// Gives each answer that was found since this was last done its part of the counted work of finding them. What each took by itself
    /// depends on which thread did what; the whole does not.
    pub fn share(&mut self, work: u64) {
        let kept = self.kept.get_mut().unwrap_or_else(PoisonError::into_inner);
        let new: Vec<&mut Kept> = kept.values_mut().filter(|kept| kept.work.is_none()).collect();
        let part = work.div_ceil(new.len().max(1) as u64);
        new.into_iter().for_each(|kept| kept.work = Some(part));
    }

    /// The table as bytes, for another process: the age, then each name with its age, work and answer, by name.
    pub fn written(&self) -> Vec<u8> {
        let kept = self.kept.lock().unwrap_or_else(PoisonError::into_inner);
        let mut all: Vec<_> = kept.iter().collect();
        all.sort_unstable_by_key(|(name, _)| **name);
        let mut out = Vec::with_capacity(all.iter().map(|(_, kept)| kept.answer.len() + 56).sum::<usize>() + 8);
        out.extend(self.age.to_le_bytes());
        for (name, kept) in all {
            out.extend(name);
            [kept.age, kept.work.unwrap_or(0), kept.answer.len() as u64]
                .iter()
                .for_each(|n| out.extend(n.to_le_bytes()));
            out.extend(&*kept.answer);
        }
        out
    }

    /// The table that was written; `None` for other bytes.
    pub fn read(mut bytes: &[u8]) -> Option<Answers> {
        fn number(bytes: &mut &[u8]) -> Option<u64> {
            let (number, rest) = bytes.split_first_chunk()?;
            *bytes = rest;
            Some(u64::from_le_bytes(*number))
        }
        let age = number(&mut bytes)?;
        let mut kept = HashMap::new();
        while !bytes.is_empty() {
            let (name, rest): (&Key, _) = bytes.split_first_chunk()?;
            bytes = rest;
            let [age, work, length] = [number(&mut bytes)?, number(&mut bytes)?, number(&mut bytes)?];
            let (answer, rest) = bytes.split_at_checked(usize::try_from(length).ok()?)?;
            bytes = rest;
            kept.insert(*name, Kept { age, work: Some(work), answer: answer.into() });
        }
        Some(Answers { age, kept: Mutex::new(kept), ..Answers::default() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_read_and_what_is_damaged_is_not() {
        let mut answers = Answers::default();
        answers.grow_older();
        for n in 0..20_u64 {
            answers.keep(key(&[&n.to_le_bytes()]), &vec![n; n as usize]);
        }
        let bytes = answers.written();
        let again = Answers::read(&bytes).expect("a table");
        assert_eq!(again.written(), bytes);
        assert_eq!(again.known::<Vec<u64>>(key(&[&3_u64.to_le_bytes()])), Some(vec![3, 3, 3]));
        assert_eq!(again.known::<Vec<u64>>(key(&[b"other"])), None);
        for end in 1..bytes.len().min(300) {
            let whole = Answers::read(&bytes[..bytes.len() - end]);
            assert!(whole.is_none_or(|found| found.written().len() < bytes.len()));
        }
    }

    #[test]
    fn what_is_not_asked_for_is_forgotten() {
        let mut answers = Answers::default();
        let [asked, idle] = [key(&[b"asked"]), key(&[b"idle"])];
        answers.keep(asked, &1_u8);
        answers.keep(idle, &2_u8);
        answers.share(10);
        for _ in 0..AGES {
            answers.grow_older();
            // Work is spared once in a state of the file, however often the question is asked.
            assert_eq!((answers.known(asked), answers.known(asked)), (Some(1_u8), Some(1_u8)));
            assert_eq!(answers.recalled(), 5);
        }
        assert_eq!(answers.known(idle), Some(2_u8), "it is kept for so many states");
        (0..=AGES).for_each(|_| answers.grow_older());
        assert_eq!((answers.known::<u8>(asked), answers.known::<u8>(idle)), (None, None));
    }
}
