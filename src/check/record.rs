//! What a check found, kept for a later process.
//!
//! **In:** a derivation, what is asked of it, and where an earlier check may have left its record. **Out:** the account, and a record for
//! later ones.
//!
//! Where the file says what it said, the account is the one that was kept, with the words of today. Where it says something else, it is
//! checked, and every answer that is known by its content is recalled ([`Found`]), as [`Cache`](super::Cache) does it within one process:
//! proofs with the assumptions that they need, what was counted on families, verdicts on motions, what was enclosed. Motions are made again.
//!
//! **Guaranteed:** the account is the one that [`check()`](super::check()) would give, but for places in the text of the file. Verdicts that are read back are decided again from
//! their evidence. Bytes that are no record are ignored. Whether they are those that this program wrote is for whoever keeps them to know:
//! evidence is believed.

use serde::{Deserialize, Serialize};

use super::cache::{Cache, contents, describe};
use super::memory::{Contents, Found, Known, Memory, Names, key};
use super::{check, check_recalling};
use crate::derivation::Derivation;
use claim::error::CheckError;
use claim::options::Options;
use files::records::Store;
use findings::Account;

/// The record that has the account of a file.
const ACCOUNT: &str = "account";
/// The record that has the answers to all questions.
const ANSWERS: &str = "answers";

/// The name of a record of a file, by its id and by what is asked: of one file many may be kept.
fn name(derivation: &Derivation, options: &Options, of: &str) -> String {
    let asked = format!("{:?} {} {:?}", options.rigor, options.plain, options.limits.work);
    let parts = [env!("CARGO_PKG_VERSION"), of, &derivation.id, &asked].map(str::as_bytes);
    key(&parts).iter().map(|byte| format!("{byte:02x}")).collect()
}

/// The answers to questions about a file, and the counted work of finding them, at most.
#[derive(Default, Serialize, Deserialize)]
struct Answers {
    work: u64,
    found: Found,
}

/// What is kept of one file.
#[derive(Serialize, Deserialize)]
struct Record {
    contents: Contents,
    account: Account,
}

/// [`check()`](super::check()), with what was kept of an earlier check of the whole file. What is found is kept, unless a limit of the run was
/// reached.
///
/// # Errors
/// Those of [`check()`](super::check()).
pub fn check_recorded(
    derivation: &Derivation,
    options: &Options,
    store: &dyn Store,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Result<Account, CheckError> {
    let whole = options.claims.is_empty() && options.trajectories.is_empty();
    let Some(contents) = contents(derivation).filter(|_| whole) else {
        return check(derivation, options, progress);
    };
    let name = |of: &str| name(derivation, options, of);
    if let Some(account) = recalled(derivation, &contents, &name(ACCOUNT), store) {
        return Ok(account);
    }
    let found = store.read(&name(ANSWERS)).and_then(|bytes| postcard::from_bytes::<Answers>(&bytes).ok());
    let Answers { mut work, found } = found.unwrap_or_default();
    let names = Names::of(&contents);
    let mut memory = Memory::of(found);
    let mut account = check_recalling(derivation, options, Known::new(&memory, &names), None, progress)?;
    let mut total = options.limits.total.clone();
    if work > total.left() {
        // With the work of all that was recalled, the file might have come to its end: then it does.
        let anew = Options { limits: options.limits.of_file(derivation.work), ..options.clone() };
        (work, memory, total) = (0, Memory::of(Found::default()), anew.limits.total.clone());
        account = check_recalling(derivation, &anew, Known::new(&memory, &names), None, progress)?;
    }
    describe(derivation, &mut account);
    // What the use of memory has ended is not to be seen any more, and what comes too late in a file may come earlier in another.
    if options.limits.memory.is_some() || options.limits.reached().is_some() || total.left() == 0 {
        return Ok(account);
    }
    let answers = Answers { work: work.saturating_add(total.used()), found: memory.found() };
    let record = Record { contents, account };
    for (of, bytes) in [(ACCOUNT, postcard::to_allocvec(&record)), (ANSWERS, postcard::to_allocvec(&answers))] {
        if let Ok(bytes) = bytes {
            store.write(&name(of), &bytes);
        }
    }
    Ok(record.account)
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
    let Some(contents) = contents(derivation) else { return cache.check(derivation) };
    let name = name(derivation, &Options::default(), ACCOUNT);
    if let Some(account) = recalled(derivation, &contents, &name, store) {
        return Ok((account, Vec::new()));
    }
    let (account, checked) = cache.check(derivation)?;
    let record = Record { contents, account };
    if let Ok(bytes) = postcard::to_allocvec(&record) {
        store.write(&name, &bytes);
    }
    Ok((record.account, checked))
}
