//! A folder in which a program keeps what it need not compute again.
//!
//! **In:** names and bytes. **Out:** the bytes, if they are those that this very program wrote under that name for this user.
//!
//! **Guaranteed:** every record begins with the SHA-256 sum of a secret of the user and of the sum of the program, of the name and of all
//! that follows. What another version or another user wrote, what is damaged, half written or renamed has another sum, and is taken for
//! nothing: who can write into the folder, but cannot read the secret, can make no record. The sum within the sum has a fixed length, so
//! that a record cannot be made longer, either. A record takes its name by one rename, so
//! that runs side by side leave one or the other. A folder that cannot be read or written is an empty one: what is kept saves time, and
//! changes nothing else. Of many records the oldest are removed. What is found again in a moment is not kept: see [`QUICK`].

use std::fs::{self, File, Metadata};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, OnceLock};
use std::time::{Duration, Instant, SystemTime};

use sha2::{Digest, Sha256};

use super::write::write_file;

/// The ending of the name of a record.
const ENDING: &str = "record";
/// The largest record, in bytes: what is read takes several times as much memory, also where a file has become a small one. Those of the
/// first paper have up to 70 million.
pub const LARGEST: u64 = 1 << 27;
/// The largest index of a repository that is looked into.
const LARGEST_INDEX: u64 = 1 << 28;
/// The records of a folder have so many bytes together.
const MOST: u64 = 1 << 30;
/// Length of a sum.
const SUM: usize = 32;
/// The name of the file with the secret, in the folder of the user, and its length.
const SECRET: (&str, usize) = ("secret", 32);

/// What was found faster than this, after a record was asked for in vain, is not kept.
pub const QUICK: Duration = Duration::from_millis(300);

/// Where records are kept: a folder, a database, nothing. One that is lost, or cannot be written, costs time and nothing else.
pub trait Store: Sync {
    /// The record with this name, if it is there and is what was written.
    fn read(&self, name: &str) -> Option<Vec<u8>>;

    /// Keeps a record in place of what has the name.
    fn write(&self, name: &str, record: &[u8]);
}

/// The folder, with the program whose records they are.
#[derive(Debug)]
pub struct Records {
    folder: PathBuf,
    program: PathBuf,
    secret: [u8; SECRET.1],
    /// When a record was asked for last, and what is too quick to be kept.
    asked: Mutex<Instant>,
    quick: Duration,
    /// The sum of the program, once it was needed.
    of_program: Arc<OnceLock<Option<[u8; SUM]>>>,
}

/// The file of the code that runs, where that is a library which another program has loaded.
static LIBRARY: OnceLock<PathBuf> = OnceLock::new();

/// Says that the code that runs is that of a library: records are of its file then, not of the program that has loaded it.
pub fn are_of_library(file: PathBuf) {
    // A process has one; it cannot become another.
    let _ = LIBRARY.set(file);
}

/// The sum of the code that runs, once for all records that it is needed for.
fn of_this_program() -> Arc<OnceLock<Option<[u8; SUM]>>> {
    static SUM_OF_IT: OnceLock<Arc<OnceLock<Option<[u8; SUM]>>>> = OnceLock::new();
    Arc::clone(SUM_OF_IT.get_or_init(Arc::default))
}

impl Records {
    /// A folder, which need not exist, the file of the program, and the secret of who uses it.
    pub fn new(folder: PathBuf, program: PathBuf, secret: [u8; 32]) -> Records {
        Records { folder, program, secret, asked: Mutex::new(Instant::now()), quick: QUICK, of_program: Arc::default() }
    }

    /// Those of the program that runs, in a folder that is named; else in the one that a variable of its environment names, none where it
    /// is empty; else in that of the user for such things, where a folder has the `name`. `None` where nothing is kept, and where there is
    /// no folder of the user, in which the secret is.
    pub fn of_user(named: Option<PathBuf>, variable: &str, name: &str) -> Option<Records> {
        let of_user = Records::usual_folder(name);
        let usual = || match std::env::var_os(variable) {
            Some(folder) => (!folder.is_empty()).then(|| folder.into()),
            None => of_user.clone(),
        };
        let folder = named.or_else(usual)?;
        let of_user = of_user.filter(|folder| !is_tracked(folder))?;
        if folder != of_user && is_tracked(&folder) {
            return None;
        }
        let program = LIBRARY.get().cloned().or_else(|| std::env::current_exe().ok())?;
        let secret = secret(&of_user)?;
        Some(Records { of_program: of_this_program(), ..Records::new(folder, program, secret) })
    }

    /// The folder for such things on this system, for a program with this name, by the variables of its environment: that of the
    /// user. `None` where there is none.
    fn usual_folder(program: &str) -> Option<PathBuf> {
        let of = |name: &str| std::env::var_os(name).map(PathBuf::from).filter(|path| path.is_absolute());
        let folder = if cfg!(windows) {
            of("LOCALAPPDATA")
        } else if cfg!(target_os = "macos") {
            of("HOME").map(|home| home.join("Library").join("Caches"))
        } else {
            of("XDG_CACHE_HOME").or_else(|| of("HOME").map(|home| home.join(".cache")))
        };
        folder.map(|folder| folder.join(program))
    }

    fn path(&self, name: &str) -> Option<PathBuf> {
        let is_plain = !name.is_empty() && name.bytes().all(|byte| byte.is_ascii_alphanumeric());
        is_plain.then(|| self.folder.join(format!("{name}.{ENDING}")))
    }

    /// `None` where the program cannot be read.
    fn sum(&self, name: &str, record: &[u8]) -> Option<[u8; SUM]> {
        let of_program = || {
            let mut sum = Sha256::new();
            std::io::copy(&mut File::open(&self.program).ok()?, &mut sum).ok()?;
            Some(sum.finalize().into())
        };
        let mut sum = Sha256::new();
        sum.update((*self.of_program.get_or_init(of_program))?);
        sum.update((name.len() as u64).to_le_bytes());
        sum.update(name);
        sum.update(record);
        let inner = sum.finalize();
        Some(Sha256::new().chain_update(self.secret).chain_update(inner).finalize().into())
    }

    /// Removes the oldest records but one, where all are too large together.
    fn sweep(&self, newest: &Path) {
        let Ok(entries) = fs::read_dir(&self.folder) else { return };
        let record = |path: PathBuf| -> Option<(SystemTime, u64, PathBuf)> {
            let is_record = path.extension().is_some_and(|ending| ending == ENDING);
            let found: Metadata = fs::symlink_metadata(&path).ok().filter(|m| is_record && m.is_file())?;
            Some((found.modified().ok()?, found.len(), path))
        };
        let mut all: Vec<_> = entries.filter_map(|entry| record(entry.ok()?.path())).collect();
        all.sort();
        let mut size: u64 = all.iter().map(|(_, size, _)| size).sum();
        for (_, of, path) in all {
            if size <= MOST {
                return;
            }
            if path != newest && fs::remove_file(&path).is_ok() {
                size -= of;
            }
        }
    }
}

/// Whether the repository that the folder lies in keeps something of it: whoever wrote the repository could have written records.
fn is_tracked(folder: &Path) -> bool {
    let named = || std::path::absolute(folder).ok();
    let Some(folder) = folder.canonicalize().ok().or_else(named) else { return true };
    let Some(top) = folder.ancestors().find(|above| above.join(".git").exists()) else { return false };
    let Ok(within) = folder.strip_prefix(top) else { return true };
    let git = top.join(".git");
    // Of a further work tree, `.git` is a file that names the folder.
    let named = || fs::read_to_string(&git).ok().and_then(|text| Some(top.join(text.strip_prefix("gitdir:")?.trim())));
    let Some(git) = git.is_dir().then(|| git.clone()).or_else(named) else { return true };
    let Ok(index) = super::read(&git.join("index"), LARGEST_INDEX) else { return git.join("index").exists() };
    // Names are written out up to version 3 of the index; what is written otherwise is not looked into.
    let is_written_out = index.starts_with(b"DIRC\0\0\0\x02") || index.starts_with(b"DIRC\0\0\0\x03");
    let mut name: Vec<u8> =
        within.components().map(|part| part.as_os_str().to_string_lossy()).collect::<Vec<_>>().join("/").into();
    name.push(b'/');
    !is_written_out || within.as_os_str().is_empty() || index.windows(name.len()).any(|part| part == name)
}

/// The secret in a folder; made there, where there is none. `None` where it can be neither read nor made, or could be read by others.
fn secret(folder: &Path) -> Option<[u8; SECRET.1]> {
    let path = folder.join(SECRET.0);
    let read = || super::read(&path, SECRET.1 as u64).ok()?.try_into().ok();
    if let Some(secret) = read() {
        return is_private(&path).then_some(secret);
    }
    let made = drawn()?;
    fs::create_dir_all(folder).ok()?;
    // One that is too short was left by a run that was killed.
    let _ = fs::remove_file(&path);
    let mut options = File::options();
    options.write(true).create_new(true);
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::mode(&mut options, 0o600);
    // Where another run was first, its secret counts.
    let _ = options.open(&path).and_then(|mut file| file.write_all(&made));
    read()
}

/// Bytes that nobody can guess.
fn drawn() -> Option<[u8; SECRET.1]> {
    #[cfg(target_family = "wasm")]
    return None;
    #[cfg(not(target_family = "wasm"))]
    {
        let mut made = [0; SECRET.1];
        getrandom::fill(&mut made).ok().map(|()| made)
    }
}

/// Whether nobody else may read or write a file; on systems without such rights, folders of users have them.
fn is_private(path: &Path) -> bool {
    #[cfg(unix)]
    return fs::symlink_metadata(path)
        .is_ok_and(|of| std::os::unix::fs::PermissionsExt::mode(&of.permissions()) & 0o077 == 0);
    #[cfg(not(unix))]
    path.exists()
}

impl Store for Records {
    /// The record with a name, of letters and digits.
    fn read(&self, name: &str) -> Option<Vec<u8>> {
        *self.asked.lock().ok()? = Instant::now();
        let path = self.path(name)?;
        let mut bytes = super::read(&path, LARGEST).ok()?;
        let rest = bytes.get(SUM..)?;
        if bytes[..SUM] != self.sum(name, rest)? {
            return None;
        }
        bytes.drain(..SUM);
        // So that what is used is not the oldest.
        let _ = File::options().append(true).open(&path).and_then(|file| file.set_modified(SystemTime::now()));
        Some(bytes)
    }

    /// Keeps a record. That it cannot be kept is no error.
    fn write(&self, name: &str, record: &[u8]) {
        let is_quick = self.asked.lock().map_or(true, |asked| asked.elapsed() < self.quick);
        if is_quick || (record.len() + SUM) as u64 > LARGEST {
            return;
        }
        let (Some(path), Some(sum)) = (self.path(name), self.sum(name, record)) else { return };
        let bytes = [&sum, record].concat();
        if fs::create_dir_all(&self.folder).is_ok() && write_file(&path, &bytes).is_ok() {
            self.sweep(&path);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn keeping(folder: PathBuf, program: PathBuf) -> Records {
        Records { quick: Duration::ZERO, ..Records::new(folder, program, [7; 32]) }
    }

    #[test]
    fn a_folder_that_a_repository_keeps_is_not_used() {
        let folder = tempfile::tempdir().expect("a folder");
        let at = |name: &str| folder.path().join(name);
        fs::create_dir_all(at(".git")).expect("made");
        fs::create_dir_all(at("cache/kept")).expect("made");
        let tracked = |name: &str| is_tracked(&at(name));
        assert!(!tracked("cache/kept"), "nothing is tracked yet");
        fs::write(at(".git/index"), b"DIRC\0\0\0\x02 cache/kept/x.record\0 paper.tex\0").expect("written");
        assert!(tracked("cache/kept"));
        assert!(tracked("cache") && tracked(""));
        assert!(!tracked("other") && !tracked("cache/kept/new"));
        fs::write(at(".git/index"), b"DIRC\0\0\0\x04").expect("written");
        assert!(tracked("other"), "it cannot be told");
        let elsewhere = tempfile::tempdir().expect("a folder");
        assert!(!is_tracked(&elsewhere.path().join("kept")));
    }

    #[test]
    fn what_is_found_in_a_moment_is_not_kept() {
        let folder = tempfile::tempdir().expect("a folder");
        let records = Records::new(folder.path().join("kept"), program(folder.path(), "1"), [7; 32]);
        let write = |of: &Records| {
            assert_eq!(of.read("x"), None);
            of.write("x", b"found");
            of.read("x").is_some()
        };
        assert!(!write(&records));
        assert!(write(&Records { quick: Duration::ZERO, ..records }));
    }

    #[test]
    fn a_secret_is_made_once_and_is_private() {
        let folder = tempfile::tempdir().expect("a folder");
        let at = folder.path().join("of/user");
        let first = secret(&at).expect("it is made");
        assert_eq!(secret(&at), Some(first));
        let other = secret(&folder.path().join("of/another")).expect("it is made");
        assert!(first != other && first != [0; 32]);
        let path = at.join(SECRET.0);
        fs::write(&path, [1; 5]).expect("written");
        let again = secret(&at).expect("it is made anew");
        assert!(again != first && fs::read(&path).is_ok_and(|bytes| bytes == again));
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt;
            fs::set_permissions(&path, fs::Permissions::from_mode(0o644)).expect("it is changed");
            assert_eq!(secret(&at), None, "others could read it");
        }
        fs::write(folder.path().join("file"), "x").expect("written");
        assert_eq!(secret(&folder.path().join("file")), None, "there is no folder");
    }

    fn program(folder: &Path, text: &str) -> PathBuf {
        let path = folder.join("program");
        fs::write(&path, text).expect("written");
        path
    }

    #[test]
    fn what_was_written_is_read() {
        let folder = tempfile::tempdir().expect("a folder");
        let records = keeping(folder.path().join("a/b"), program(folder.path(), "1"));
        assert_eq!(records.read("x1"), None);
        records.write("x1", b"what was found");
        records.write("x2", b"");
        assert_eq!(records.read("x1").as_deref(), Some(&b"what was found"[..]));
        assert_eq!(records.read("x2").as_deref(), Some(&b""[..]));
        assert_eq!(records.read("../b/x1"), None, "a name is no path");
    }

    #[test]
    fn what_is_damaged_or_of_another_program_is_nothing() {
        let folder = tempfile::tempdir().expect("a folder");
        let at = folder.path().join("kept");
        let records = keeping(at.clone(), program(folder.path(), "1"));
        records.write("x", b"what was found");
        let path = at.join("x.record");
        let whole = fs::read(&path).expect("written");
        let other = keeping(at.clone(), program(folder.path(), "2"));
        assert_eq!(other.read("x"), None, "of another program");
        let other = Records { secret: [8; 32], ..keeping(at.clone(), program(folder.path(), "1")) };
        assert_eq!(other.read("x"), None, "of another user");
        fs::copy(&path, at.join("y.record")).expect("copied");
        assert_eq!(records.read("y"), None, "under another name");
        for (at, bytes) in (0..whole.len()).map(|at| {
            let mut bytes = whole.clone();
            bytes[at] ^= 1;
            (at, bytes)
        }) {
            fs::write(&path, &bytes).expect("written");
            assert_eq!(records.read("x"), None, "byte {at}");
            fs::write(&path, &whole[..at]).expect("written");
            assert_eq!(records.read("x"), None, "only {at} bytes");
        }
        fs::write(&path, &whole).expect("written");
        assert!(records.read("x").is_some());
    }

    #[test]
    fn where_nothing_can_be_kept_nothing_is() {
        let folder = tempfile::tempdir().expect("a folder");
        let file = program(folder.path(), "1");
        let records = keeping(file.join("no-folder"), file.clone());
        records.write("x", b"found");
        assert_eq!(records.read("x"), None);
        let records = keeping(folder.path().to_owned(), folder.path().join("missing"));
        records.write("x", b"found");
        assert_eq!(records.read("x"), None, "a program that cannot be named");
    }
}
