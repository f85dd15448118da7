//! Derivation files of this project, each checked once for all tests that only look at what is found.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, LazyLock, Mutex, OnceLock};

use rederive::check::{Account, Options, check};
use rederive::derivation::{Derivation, load};
use rederive::diag::render;

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
