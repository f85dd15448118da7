//! What a check found, kept for a later process.
//!
//! **In:** a derivation, what is asked of it, and where an earlier check may have left its record. **Out:** the account, and a record for
//! later ones.
//!
//! Where the file says what it said in one of its last states, the account is the one that was kept, with the words of today. Where it says something else, it is
//! checked, and every answer that is known by its content is recalled ([`Answers`]), as [`Cache`](super::Cache) does it within one process:
//! proofs with the assumptions that they need, what was counted on families, verdicts on motions, what was enclosed. Motions are made again;
//! they are enclosed from the validated steps that are known ([`KnownSteps`](flow::KnownSteps)). These have a record of their own, which is written only
//! where some are new.
//!
//! **Guaranteed:** the account is the one that [`check()`](super::check()) would give, but for places in the text of the file. Verdicts that are read back are decided again from
//! their evidence. Bytes that are no record are ignored. Whether they are those that this program wrote is for whoever keeps them to know:
//! evidence is believed.

use std::fmt;

use serde::{Deserialize, Serialize};

use super::answers::{AGES, Answers, in_digits, key};
use super::cache::{Cache, contents, describe};
use super::memory::{Contents, Known, Memory, Names};
use super::{check, check_recalling};
use crate::derivation::Derivation;
use claim::error::CheckError;
use claim::options::{Options, Rigor};
use files::records::{LARGEST, Store};
use findings::Account;

/// The record that has the account of one state of a file.
const ACCOUNT: &str = "account";
/// The record that has the names of those that are kept of a file.
const STATES: &str = "states";
/// The record that has the answers to all questions.
const ANSWERS: &str = "answers";

/// The record that has the validated steps of the motions: large, and written only where some are new.
const STEPS: &str = "steps";

/// The name of a record of a file, by its id and by what is asked: of one file many may be kept.
fn name(derivation: &Derivation, options: &Options, of: &str) -> String {
    let asked = format!("{:?} {} {:?}", options.rigor, options.plain, options.limits.work);
    let parts = [env!("CARGO_PKG_VERSION"), of, &derivation.id, &asked].map(str::as_bytes);
    in_digits(&key(&parts))
}

/// The share of an account that earlier checks found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Recalled {
    /// Nothing.
    Nothing,
    /// So many of all answers that were asked for.
    Answers {
        /// Those that were known.
        known: usize,
        /// All of them.
        all: usize,
    },
    /// All of it: the file says what it said.
    Whole,
}

impl fmt::Display for Recalled {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Recalled::Nothing => f.write_str("nothing is recalled from an earlier run"),
            Recalled::Answers { known, all } => write!(f, "{known} of {all} answers are recalled from earlier runs"),
            Recalled::Whole => f.write_str("all verdicts are recalled from an earlier run"),
        }
    }
}

/// Bytes up to the largest record: what would not be kept is not written out.
struct Bounded(Vec<u8>);

impl postcard::ser_flavors::Flavor for Bounded {
    type Output = Vec<u8>;

    fn try_push(&mut self, byte: u8) -> postcard::Result<()> {
        self.try_extend(&[byte])
    }

    fn try_extend(&mut self, bytes: &[u8]) -> postcard::Result<()> {
        if (self.0.len() + bytes.len()) as u64 > LARGEST {
            return Err(postcard::Error::SerializeBufferFull);
        }
        self.0.extend_from_slice(bytes);
        Ok(())
    }

    fn finalize(self) -> postcard::Result<Vec<u8>> {
        Ok(self.0)
    }
}

/// What is kept of one file.
#[derive(Serialize, Deserialize)]
struct Record {
    contents: Contents,
    account: Account,
}

/// [`check()`](super::check()), with what was kept of an earlier check of the whole file, and how much of it that was. What is found is kept,
/// unless a limit of the run was reached.
///
/// # Errors
/// Those of [`check()`](super::check()).
pub fn check_recorded(
    derivation: &Derivation,
    options: &Options,
    store: &dyn Store,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Result<(Account, Recalled), CheckError> {
    let whole = options.claims.is_empty() && options.trajectories.is_empty();
    let Some(contents) = contents(derivation).filter(|_| whole) else {
        return Ok((check(derivation, options, progress)?, Recalled::Nothing));
    };
    let of_account = name_of_account(derivation, options, &contents);
    if let Some(account) = recalled(derivation, &contents, &of_account, store) {
        return Ok((account, Recalled::Whole));
    }
    let states = States::of(derivation, options, store);
    let of_answers = name(derivation, options, ANSWERS);
    let read = |name: &String| store.read(name).and_then(|bytes| Answers::read(&bytes)).unwrap_or_default();
    let of_steps = name(derivation, options, STEPS);
    let steps = if options.rigor == Rigor::Enclosed { read(&of_steps) } else { Answers::default() };
    let names = Names::of(&contents);
    let mut memory = Memory::of(read(&of_answers), steps);
    let mut account = check_recalling(derivation, options, Known::new(&memory, &names), None, progress)?;
    let mut total = options.limits.total.clone();
    if memory.recalled() > total.left() {
        // With the work of all that was recalled, the file might have come to its end: then it does.
        let anew = Options { limits: options.limits.of_file(derivation.work), ..options.clone() };
        (memory, total) = (Memory::of(Answers::default(), Answers::default()), anew.limits.total.clone());
        account = check_recalling(derivation, &anew, Known::new(&memory, &names), None, progress)?;
    }
    describe(derivation, &mut account);
    let recalled = match memory.counts() {
        [0, _] => Recalled::Nothing,
        [known, found] => Recalled::Answers { known, all: known + found },
    };
    // What the use of memory has ended is not to be seen any more, and what comes too late in a file may come earlier in another.
    if options.limits.memory.is_some() || options.limits.reached().is_some() || total.left() == 0 {
        return Ok((account, recalled));
    }
    let record = Record { contents, account };
    states.keep(&of_account, &record, store);
    let (answers, steps) = memory.answers(total.used());
    let has_new_steps = steps.counts()[1] > 0;
    for (name, kept, is_new) in [(&of_answers, answers, true), (&of_steps, steps, has_new_steps)] {
        if is_new && !kept.are_too_large() {
            store.write(name, &kept.written());
        }
    }
    Ok((record.account, recalled))
}

/// The name of the record of the account of this state of a file.
fn name_of_account(derivation: &Derivation, options: &Options, contents: &Contents) -> String {
    let state = postcard::to_allocvec(contents).unwrap_or_default();
    let state = in_digits(&key(&[&state]));
    name(derivation, options, &format!("{ACCOUNT} {state}"))
}

/// The names of the accounts that are kept of a file, the oldest first.
struct States {
    name: String,
    known: Vec<String>,
}

impl States {
    /// What is kept; asked before anything is found.
    fn of(derivation: &Derivation, options: &Options, store: &dyn Store) -> States {
        let name = name(derivation, options, STATES);
        let known = store.read(&name).and_then(|bytes| postcard::from_bytes(&bytes).ok());
        States { name, known: known.unwrap_or_default() }
    }

    /// Keeps the account of one more state, in place of that of the oldest where there are too many.
    fn keep(mut self, of_account: &str, record: &Record, store: &dyn Store) {
        let Ok(bytes) = postcard::serialize_with_flavor::<_, Bounded, Vec<u8>>(record, Bounded(Vec::new())) else {
            return;
        };
        self.known.retain(|state| state != of_account);
        self.known.push(of_account.to_owned());
        for oldest in self.known.drain(..self.known.len().saturating_sub(AGES as usize)) {
            store.write(&oldest, &[]);
        }
        store.write(of_account, &bytes);
        if let Ok(states) = postcard::to_allocvec(&self.known) {
            store.write(&self.name, &states);
        }
    }
}

/// The account that was kept of a file which says what this one says, with the words of this one.
fn recalled(derivation: &Derivation, contents: &Contents, name: &str, store: &dyn Store) -> Option<Account> {
    let record: Record = postcard::from_bytes(&store.read(name)?).ok()?;
    let mut account = Some(record).filter(|record| record.contents == *contents)?.account;
    describe(derivation, &mut account);
    Some(account)
}

/// [`Cache::check`], where a state of the file that was checked before, also in another process, is not checked again.
///
/// # Errors
/// Those of [`Cache::check`].
pub fn check_again_recorded(
    cache: &mut Cache,
    derivation: &Derivation,
    store: &dyn Store,
) -> Result<(Account, Vec<String>), CheckError> {
    let Some(contents) = contents(derivation) else { return cache.check(derivation, None) };
    let options = Options::default();
    let of_account = name_of_account(derivation, &options, &contents);
    if let Some(account) = recalled(derivation, &contents, &of_account, store) {
        return Ok((account, Vec::new()));
    }
    let states = States::of(derivation, &options, store);
    let (account, checked) = cache.check(derivation, None)?;
    let record = Record { contents, account };
    states.keep(&of_account, &record, store);
    Ok((record.account, checked))
}
