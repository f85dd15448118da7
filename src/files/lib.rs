//! What may be read and written, and how.
//!
//! **In:** paths that a user named, and what lies at them, which a stranger may have written. **Out:** bytes of regular files,
//! the derivation files of a folder, and files and reports on disk, whole or not at all ([`mod@write`]).
//!
//! A check in continuous integration runs in a folder that somebody else filled. Three rules keep what lies there from
//! reaching further than its own text; nothing else in the program opens a file (`tests/files.rs` looks).
//!
//! 1. **Read: regular files, up to a size.** No folder, device, pipe or socket is opened: some of them never end. What is
//!    named inside the current folder must lie in it, links resolved; a path that begins elsewhere is the user's own business.
//! 2. **A search follows no link**, whether to a file or to a folder. So it ends, and reads nothing but what is there.
//! 3. **Write: no link on the way**, from the current folder on; nothing but a regular file or a report is replaced, and no
//!    file that was read. See [`mod@write`].
//!
//! Paths that differ in spelling only are one: [`named`] gives all of them the same name, so that reports have the same bytes.

#![forbid(unsafe_code)]

#[cfg(feature = "temporary")]
pub mod lines;
#[cfg(feature = "temporary")]
pub mod pdf;
pub mod records;
pub mod write;

use std::ffi::OsString;
use std::fs::{self, File, FileType};
use std::io::{self, Read};
use std::path::{Component, Path, PathBuf};
use std::time::Duration;

/// Most entries of folders that one search looks at.
const MOST_ENTRIES: usize = 100_000;
/// Deepest folder below the one that is searched, or that a paper lies in.
pub const DEEPEST: usize = 64;

/// A file that is not read, or not written.
#[derive(Debug, thiserror::Error)]
#[error("`{}` {why}", path.display())]
pub struct FileError {
    /// Which.
    pub path: PathBuf,
    /// Why.
    pub why: Why,
}

/// Why a file is not read, or not written; words that follow its name.
#[derive(Debug, thiserror::Error)]
pub enum Why {
    /// The operating system says so.
    #[error("cannot be read: {0}")]
    Unreadable(io::Error),
    /// The operating system says so.
    #[error("cannot be written: {0}")]
    Unwritable(io::Error),
    /// What is to be written cannot be kept until it is finished.
    #[error("cannot be written: its lines cannot be kept in the folder for temporary files: {0}")]
    Waiting(io::Error),
    /// A folder, a device, a pipe, a socket.
    #[error("is {0}, not a file")]
    NotAFile(&'static str),
    /// What is to be replaced is no regular file.
    #[error("cannot be written: there is {0} of this name, and only a file is replaced")]
    InTheWay(&'static str),
    /// Its bytes are not UTF-8.
    #[error("is no text")]
    NoText,
    /// More bytes than are read, in MiB.
    #[error("is larger than {0} MiB")]
    TooLarge(u64),
    /// A link leads from the current folder to somewhere else.
    #[error("is a link that leads out of the current folder, and is not followed")]
    LeadsOut,
    /// On the way to an output.
    #[error("is a link, and nothing is written through a link")]
    Link,
    /// Something that is not to be replaced.
    #[error("is there already, and is not replaced")]
    Exists,
    /// Two outputs.
    #[error("is the output of two formats or options")]
    Twice,
    /// An output that was read.
    #[error("is read in this run, and is not replaced by its output")]
    IsInput,
    /// An output inside the folder of a report.
    #[error("lies in the folder of a report, which is exchanged as a whole: name another place")]
    InReport,
    /// No name of a file.
    #[error("is not the name of a file")]
    NoName,
    /// A folder without what is looked for.
    #[error("has no {0} in it")]
    Lacks(&'static str),
    /// A search that does not end.
    #[error("has more than {0} entries below it: name the files, or a smaller folder")]
    TooMany(usize),
    /// A search that goes too deep.
    #[error("lies more than {0} folders deep")]
    TooDeep(usize),
    /// Somebody else writes.
    #[error("is in use: another run has been writing there for {0} seconds")]
    Busy(u64),
}

impl FileError {
    fn new(path: &Path, why: Why) -> FileError {
        FileError { path: path.to_path_buf(), why }
    }
}

/// What something is that is no regular file.
fn kind(of: FileType) -> &'static str {
    #[cfg(unix)]
    {
        use std::os::unix::fs::FileTypeExt;
        if of.is_fifo() {
            return "a pipe";
        }
        if of.is_socket() {
            return "a socket";
        }
        if of.is_block_device() || of.is_char_device() {
            return "a device";
        }
    }
    if of.is_dir() {
        "a folder"
    } else if of.is_symlink() {
        "a link"
    } else {
        "something else"
    }
}

/// The bytes of a regular file, at most `largest` of them.
///
/// # Errors
/// It is no regular file, is larger, or the operating system refuses.
pub fn read(path: &Path, largest: u64) -> Result<Vec<u8>, FileError> {
    let failed = |why| FileError::new(path, why);
    let unreadable = |e| FileError::new(path, Why::Unreadable(e));
    // Asked before it is opened: to open a pipe is to wait for whoever writes to it. Asked again of what was opened.
    let regular =
        |kind_of: FileType| if kind_of.is_file() { Ok(()) } else { Err(failed(Why::NotAFile(kind(kind_of)))) };
    regular(fs::metadata(path).map_err(unreadable)?.file_type())?;
    let file = File::open(path).map_err(unreadable)?;
    regular(file.metadata().map_err(unreadable)?.file_type())?;
    let mut bytes = Vec::new();
    file.take(largest + 1).read_to_end(&mut bytes).map_err(unreadable)?;
    // What is said to have no bytes may have some (/proc), so they are counted.
    if bytes.len() as u64 > largest { Err(failed(Why::TooLarge(largest >> 20))) } else { Ok(bytes) }
}

/// The text of a regular file, at most `largest` bytes of UTF-8.
///
/// # Errors
/// As for [`read`]; it is no text.
pub fn read_text(path: &Path, largest: u64) -> Result<String, FileError> {
    String::from_utf8(read(path, largest)?).map_err(|_| FileError::new(path, Why::NoText))
}

/// Between two looks at a file for its [`changes`].
const PAUSE: Duration = Duration::from_millis(25);

/// Waits for changes of a file that others write: an item at once, then one whenever it is there and is not what it was. It is looked at
/// forty times a second. This needs no service of the operating system, and works on every file system and with editors that replace a
/// file instead of writing to it: one that is being replaced may be missing for a moment.
pub fn changes(path: &Path, largest: u64) -> impl Iterator<Item = ()> {
    let mut last = None;
    std::iter::from_fn(move || {
        loop {
            let now = read(path, largest).ok();
            if last.as_ref().is_none_or(|last| now.is_some() && now != *last) {
                last = Some(now);
                return Some(());
            }
            std::thread::sleep(PAUSE);
        }
    })
}

/// The one name of what the path leads to: from the current folder where it lies in it, with links resolved.
///
/// A path that lies elsewhere is given as it is, without `.` and without what `..` takes back. So is one where nothing is.
///
/// # Errors
/// [`Why::LeadsOut`]: it begins in the current folder, and a link on the way leads out of it.
pub fn named(path: &Path) -> Result<PathBuf, FileError> {
    let Ok(here) = std::env::current_dir().and_then(|here| here.canonicalize()) else { return Ok(path.to_path_buf()) };
    let absolute = here.join(path);
    let Ok(real) = absolute.canonicalize() else {
        let plain = plain(&absolute);
        return Ok(inside(&plain, &here).unwrap_or(plain));
    };
    match inside(&real, &here) {
        Some(inner) => Ok(inner),
        None if plain(&absolute).starts_with(&here) => Err(FileError::new(path, Why::LeadsOut)),
        None if path.is_absolute() => Ok(plain(&absolute)),
        None => Ok(path.to_path_buf()),
    }
}

/// Whether a file lies in a folder, links resolved; what is not there lies in none, nor does what is deeper than [`DEEPEST`].
pub fn lies_inside(path: &Path, folder: &Path) -> bool {
    // A system walks a path folder by folder, again for each of them that may be a link.
    if path.components().count() > folder.components().count() + DEEPEST {
        return false;
    }
    match (path.canonicalize(), folder.canonicalize()) {
        (Ok(path), Ok(folder)) => path.starts_with(folder),
        _ => false,
    }
}

/// A path with its links resolved; none where nothing is there.
pub fn real(path: &Path) -> Option<PathBuf> {
    path.canonicalize().ok()
}

/// The files of a folder with this ending, sorted, links resolved, at most so many; those that lie elsewhere are left out.
pub fn listed(folder: &Path, ending: &str, most: usize) -> Vec<PathBuf> {
    let Ok(folder) = folder.canonicalize() else { return Vec::new() };
    let entries = fs::read_dir(&folder).into_iter().flatten().filter_map(|e| Some(e.ok()?.path()));
    let mut all: Vec<PathBuf> = entries.filter(|p| p.extension().is_some_and(|e| e == ending)).collect();
    all.sort();
    all.truncate(most);
    all.iter().filter_map(|p| p.canonicalize().ok()).filter(|p| p.parent() == Some(&folder)).collect()
}

/// The rest of a path below a folder; `.` for the folder itself.
fn inside(path: &Path, folder: &Path) -> Option<PathBuf> {
    let rest = path.strip_prefix(folder).ok()?;
    Some(if rest.as_os_str().is_empty() { PathBuf::from(".") } else { rest.to_path_buf() })
}

/// The path without `.`, and without what `..` takes back: what it means where no link is on the way.
fn plain(path: &Path) -> PathBuf {
    let mut out = PathBuf::new();
    for part in path.components() {
        match part {
            Component::CurDir => {}
            Component::ParentDir => {
                out.pop();
            }
            other => out.push(other),
        }
    }
    out
}

/// A kind of file, as a search knows it.
#[derive(Clone, Copy)]
pub struct Kind {
    /// What it is called.
    pub what: &'static str,
    /// Whether a path has the name of one.
    pub is_one: fn(&Path) -> bool,
}

/// The files that paths mean, as they are [`named`]: a file is itself, a folder all those of a kind below it.
///
/// # Errors
/// A folder that has none, or cannot be searched; a link that leads out of the current folder.
pub fn meant(paths: &[PathBuf], kind: Kind) -> Result<Search, FileError> {
    let mut out = Search::default();
    for path in paths {
        let path = named(path)?;
        if !path.is_dir() {
            out.found.push(path);
            continue;
        }
        let inside = search(&path, &kind.is_one)?;
        if inside.found.is_empty() {
            return Err(FileError::new(&path, Why::Lacks(kind.what)));
        }
        out.found.extend(inside.found);
        out.links.extend(inside.links);
    }
    Ok(out)
}

/// What a search found.
#[derive(Debug, Default)]
pub struct Search {
    /// The files, in order.
    pub found: Vec<PathBuf>,
    /// Links that might have led to more, and were not followed.
    pub links: Vec<PathBuf>,
}

/// Every regular file below a folder whose name is `wanted`. What begins with a dot is passed by; no link is followed.
///
/// # Errors
/// A folder that cannot be read, more than can be meant.
pub fn search(folder: &Path, wanted: &dyn Fn(&Path) -> bool) -> Result<Search, FileError> {
    let mut out = Search::default();
    let mut open = vec![(folder.to_path_buf(), 0)];
    let mut entries = 0;
    while let Some((at, depth)) = open.pop() {
        let failed = |e| FileError::new(&at, Why::Unreadable(e));
        if depth > DEEPEST {
            return Err(FileError::new(&at, Why::TooDeep(DEEPEST)));
        }
        for entry in fs::read_dir(&at).map_err(failed)? {
            let entry = entry.map_err(failed)?;
            entries += 1;
            if entries > MOST_ENTRIES {
                return Err(FileError::new(folder, Why::TooMany(MOST_ENTRIES)));
            }
            let name: OsString = entry.file_name();
            if name.to_string_lossy().starts_with('.') {
                continue;
            }
            // Without following: a link is a link here.
            let kind = entry.file_type().map_err(failed)?;
            let path = if at == Path::new(".") { PathBuf::from(name) } else { entry.path() };
            if kind.is_symlink() {
                if wanted(&path) || fs::metadata(entry.path()).is_ok_and(|m| m.is_dir()) {
                    out.links.push(path);
                }
            } else if kind.is_dir() {
                open.push((path, depth + 1));
            } else if kind.is_file() && wanted(&path) {
                out.found.push(path);
            }
        }
    }
    out.found.sort();
    out.links.sort();
    Ok(out)
}

/// Whether two paths lead to the same file.
fn same(a: &Path, b: &Path) -> bool {
    let (Ok(one), Ok(other)) = (fs::metadata(a), fs::metadata(b)) else {
        return plain(&absolute(a)) == plain(&absolute(b));
    };
    #[cfg(unix)]
    {
        use std::os::unix::fs::MetadataExt;
        // Two names of one file, too.
        (one.dev(), one.ino()) == (other.dev(), other.ino())
    }
    #[cfg(not(unix))]
    {
        let _ = (one, other);
        a.canonicalize().ok() == b.canonicalize().ok()
    }
}

fn absolute(path: &Path) -> PathBuf {
    std::path::absolute(path).unwrap_or_else(|_| path.to_path_buf())
}

/// Refuses a link on the way to an output: every part of the path below the current folder, and in any case the last.
fn no_link_on(path: &Path) -> Result<(), FileError> {
    let here = std::env::current_dir().and_then(|here| here.canonicalize()).ok();
    let path = absolute(path);
    // From where the path reaches the current folder; what is above it is not for the files in it to decide.
    let reached = |at: &&Path| here.as_deref().is_some_and(|here| at.exists() && same(at, here));
    let above = path.ancestors().filter(|at| reached(at)).map(|at| at.components().count()).min();
    let all = path.components().count();
    let from = above.unwrap_or(all.saturating_sub(1));
    let mut at = PathBuf::new();
    for (i, part) in path.components().enumerate() {
        at.push(part);
        if i >= from && fs::symlink_metadata(&at).is_ok_and(|m| m.file_type().is_symlink()) {
            let shown = here.as_deref().and_then(|here| inside(&at, here)).unwrap_or(at);
            return Err(FileError { path: shown, why: Why::Link });
        }
    }
    Ok(())
}

/// Names that Windows gives a meaning of its own, whatever follows a dot.
const RESERVED: &[&str] = &["con", "prn", "aux", "nul", "conin$", "conout$", "clock$"];

/// Whether a word can be the name of a file on every system: Windows has devices everywhere, and drops dots at the end.
pub fn is_portable(name: &str) -> bool {
    let stem = name.split('.').next().unwrap_or_default().trim_end().to_ascii_lowercase();
    let numbered = ["com", "lpt"].iter().any(|port| {
        let mut rest = stem.strip_prefix(port).unwrap_or_default().chars();
        rest.next().is_some_and(|c| c.is_ascii_digit() || "¹²³".contains(c)) && rest.next().is_none()
    });
    !RESERVED.contains(&stem.as_str()) && !numbered && !name.is_empty() && !name.ends_with(['.', ' '])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_devices_are_not_portable() {
        for bad in ["CON", "con.x", "Aux", "nul.tar.gz", "COM1", "lpt9.md", "com¹", "a..", "a.", "a ", ""] {
            assert!(!is_portable(bad), "{bad}");
        }
        for good in ["conic", "com", "com10", "lpt", "auxiliary", "a.b", "t8", "nullcline"] {
            assert!(is_portable(good), "{good}");
        }
    }

    #[test]
    fn a_text_is_utf8_and_replaces_nothing() {
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("a");
        write::write_new(&file, "é".as_bytes()).expect("written");
        assert_eq!(read_text(&file, 2).expect("read"), "é");
        assert!(matches!(write::write_new(&file, b"b").expect_err("it is there").why, Why::Exists));
        fs::write(&file, b"\xff").expect("written");
        assert!(matches!(read_text(&file, 2).expect_err("no text").why, Why::NoText));
    }

    #[test]
    fn a_file_is_told_at_once_and_when_it_is_another() {
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("a");
        let mut changes = changes(&file, 5);
        assert!(changes.next().is_some(), "it is missing, and is told once");
        for text in ["1", "2"] {
            fs::write(&file, text).expect("written");
            assert!(changes.next().is_some(), "{text}");
        }
        // That it is gone for a moment is no change.
        std::thread::scope(|scope| {
            scope.spawn(|| {
                fs::remove_file(&file).expect("removed");
                std::thread::sleep(3 * PAUSE);
                write::write_file(&file, b"3").expect("written");
            });
            changes.next();
            assert_eq!(read(&file, 5).expect("read"), b"3");
        });
    }

    #[test]
    fn what_is_no_file_is_not_read() {
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("a");
        fs::write(&file, "12345").expect("written");
        assert_eq!(read(&file, 5).expect("read"), b"12345");
        assert!(matches!(read(&file, 4).expect_err("too large").why, Why::TooLarge(0)));
        assert!(matches!(read(folder.path(), 5).expect_err("a folder").why, Why::NotAFile("a folder")));
        assert!(matches!(read(&folder.path().join("b"), 5).expect_err("nothing").why, Why::Unreadable(_)));
        #[cfg(unix)]
        {
            assert!(matches!(read(Path::new("/dev/zero"), 5).expect_err("a device").why, Why::NotAFile("a device")));
            let link = folder.path().join("link");
            std::os::unix::fs::symlink("/dev/zero", &link).expect("a link");
            assert!(matches!(read(&link, 5).expect_err("a device").why, Why::NotAFile("a device")));
        }
    }

    #[cfg(unix)]
    #[test]
    fn a_search_ends_and_follows_nothing() {
        use std::os::unix::fs::symlink;
        let folder = tempfile::tempdir().expect("a folder");
        let (inner, outer) = (folder.path().join("in"), folder.path().join("out"));
        fs::create_dir_all(inner.join("deep/er")).expect("made");
        fs::create_dir(&outer).expect("made");
        for file in [inner.join("a.toml"), inner.join("deep/er/b.toml"), outer.join("c.toml"), inner.join(".d.toml")] {
            fs::write(file, "").expect("written");
        }
        for name in ["x", "y", "z"] {
            symlink(".", inner.join(name)).expect("a link");
        }
        symlink("../out", inner.join("h")).expect("a link");
        symlink("../out/c.toml", inner.join("c.toml")).expect("a link");
        symlink("nowhere", inner.join("w")).expect("a link");
        let toml = |p: &Path| p.extension().is_some_and(|e| e == "toml");
        let found = search(&inner, &toml).expect("searched");
        assert_eq!(found.found, [inner.join("a.toml"), inner.join("deep/er/b.toml")]);
        assert_eq!(found.links, ["c.toml", "h", "x", "y", "z"].map(|n| inner.join(n)));
    }

    #[test]
    fn a_path_without_detours() {
        assert_eq!(plain(Path::new("/a/./b/../c//d/..")), Path::new("/a/c"));
        assert_eq!(plain(Path::new("/../a")), Path::new("/a"));
    }
}
