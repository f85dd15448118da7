//! Derivation files of this project, each checked once for all tests that only look at what is found.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, LazyLock, Mutex, OnceLock};

use rederive::check::{Account, IdentityAccount, Options, check};
use rederive::derivation::{Derivation, load};
use rederive::diag::render;

/// The word for a step, as the prover says: with what the checker has not replayed, and without what its steps leave out.
pub fn said_by_prover(step: &IdentityAccount) -> &'static str {
    if is_found(step) {
        return match (step.exceptions.is_empty(), step.presupposed.is_empty()) {
            (false, _) => "proved except",
            (true, false) => "proved given",
            (true, true) => "proved",
        };
    }
    let is_open = |word: Option<&str>| word.is_none_or(|word| !word.starts_with("proved"));
    let given = step.conditional_on.iter().any(|given| is_open(given.standing)) || !step.presupposed.is_empty();
    match (step.finding.is_proved_in_part(), step.finding.is_whole(), given) {
        (false, ..) => step.standing(),
        (true, false, _) => "proved except",
        (true, true, true) => "proved given",
        (true, true, false) => "proved",
    }
}

/// Whether the prover found a proof that does not count, since the checker does not replay it.
fn is_found(step: &IdentityAccount) -> bool {
    step.reason.as_ref().is_some_and(|why| why.to_string().starts_with("the prover finds a proof"))
}

/// A file, and what is found of it.
pub type Checked = Arc<(Derivation, Account)>;

static KNOWN: LazyLock<Mutex<BTreeMap<PathBuf, Arc<OnceLock<Checked>>>>> = LazyLock::new(Mutex::default);

/// Checks a file anew, all that is asked by default.
pub fn anew(path: &Path) -> (Derivation, Account) {
    let derivation = load(path).unwrap_or_else(|found| panic!("{}", render(&found, false)));
    let account = check(&derivation, &Options::default(), &|_, _| {});
    let account = account.unwrap_or_else(|e| panic!("{}: {e:?}", path.display()));
    (derivation, account)
}

/// What is found of a file, its path below the root of the project; the first who asks waits for it.
pub fn checked(path: impl AsRef<Path>) -> Checked {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(path);
    let cell = Arc::clone(KNOWN.lock().expect("no test stops while it holds this").entry(path.clone()).or_default());
    Arc::clone(cell.get_or_init(|| Arc::new(anew(&path))))
}
