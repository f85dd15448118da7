//! Files and reports on disk: the old or the new, never a part.
//!
//! **In:** a place that the user named, and bytes. **Out:** the bytes at that place.
//!
//! **Guaranteed:** whenever the program is killed or the power fails, a reader finds what was there before or what is there
//! now. A file is written in full beside its place, brought to the disk, and takes its name by one rename. A report, which is
//! a folder, is exchanged as a whole: the new folder is made beside the old, one rename puts it in its place, the old one is
//! removed. What a run left behind that was killed is swept by the next one that writes there; the folder above is locked
//! meanwhile, so that two runs do not sweep each other's work.
//!
//! **Refused:** links from the current folder on, whatever is no regular file, files that were read. A file in the folder of
//! a report that no report has is the user's, and is carried over.

use std::collections::HashSet;
use std::ffi::OsStr;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use super::{FileError, Why, kind, no_link_on, plain, same};

/// How the names of folders and files begin that are not in their place yet.
const NEW: &str = ".rederive-new-";
/// The same of a report that has left its place.
const OLD: &str = ".rederive-old-";
/// How long another run is waited for.
const PATIENCE: Duration = Duration::from_secs(20);
/// Deepest folder inside that of a report.
const DEEPEST: usize = 16;

/// Refuses outputs that cannot be meant, before anything is computed for them: see the module.
///
/// `inputs` are the files that the run reads, `reports` the folders of its reports.
///
/// # Errors
/// The first output that is refused.
pub fn check_outputs(outputs: &[PathBuf], inputs: &[PathBuf], reports: &[PathBuf]) -> Result<(), FileError> {
    for (at, output) in outputs.iter().enumerate() {
        let refuse = |why| Err(FileError::new(output, why));
        may_be_replaced(output)?;
        if outputs[..at].iter().any(|other| same(other, output)) {
            return refuse(Why::Twice);
        }
        if inputs.iter().any(|input| same(input, output)) {
            return refuse(Why::IsInput);
        }
        let place = plain(&super::absolute(output));
        if reports.iter().any(|report| place.starts_with(plain(&super::absolute(report)))) {
            return refuse(Why::InReport);
        }
    }
    for report in reports {
        no_link_on(report)?;
        // A report is exchanged as a whole: what is read must not lie in it.
        let place = plain(&super::absolute(report));
        if let Some(input) = inputs.iter().find(|input| plain(&super::absolute(input)).starts_with(&place)) {
            return Err(FileError::new(input, Why::InReport));
        }
    }
    Ok(())
}

/// Refuses a place that has no name, lies behind a link, or is taken by something that is no regular file.
fn may_be_replaced(path: &Path) -> Result<&OsStr, FileError> {
    let name = path.file_name().ok_or_else(|| FileError::new(path, Why::NoName))?;
    no_link_on(path)?;
    match fs::symlink_metadata(path) {
        Ok(found) if !found.is_file() => Err(FileError::new(path, Why::InTheWay(kind(found.file_type())))),
        _ => Ok(name),
    }
}

/// Writes one file; its folder is made if it is missing.
///
/// # Errors
/// The place is refused, or the operating system refuses; then what was there is there still.
pub fn write_file(path: &Path, bytes: &[u8]) -> Result<(), FileError> {
    may_be_replaced(path)?;
    let folder = path.parent().filter(|f| !f.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let failed = |e| FileError::new(path, Why::Unwritable(e));
    if fs::read(path).is_ok_and(|before| before == bytes) {
        return Ok(());
    }
    let place = Place::enter(folder)?;
    let new = place.new_name();
    let written = disk::write_new(&new, bytes).and_then(|()| disk::rename(&new, path));
    if written.is_err() {
        let _ = disk::remove(&new);
    }
    written.map_err(failed)?;
    place.settle();
    Ok(())
}

/// The same, where nothing is yet.
///
/// # Errors
/// Something is there; else see [`write_file`].
pub fn write_new(path: &Path, bytes: &[u8]) -> Result<(), FileError> {
    // A link that leads nowhere is something, too.
    match path.symlink_metadata() {
        Ok(_) => Err(FileError::new(path, Why::Exists)),
        Err(_) => write_file(path, bytes),
    }
}

/// Writes one file with all that can be read from somewhere, which need not fit into memory; else as [`write_file`].
///
/// # Errors
/// See [`write_file`].
pub fn write_from(path: &Path, from: &mut dyn io::Read) -> Result<(), FileError> {
    may_be_replaced(path)?;
    let folder = path.parent().filter(|f| !f.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let place = Place::enter(folder)?;
    let new = place.new_name();
    let written = disk::copy_new(&new, from).and_then(|()| disk::rename(&new, path));
    if written.is_err() {
        let _ = disk::remove(&new);
    }
    written.map_err(|e| FileError::new(path, Why::Unwritable(e)))?;
    place.settle();
    Ok(())
}

/// Writes several files into a folder, each whole.
///
/// # Errors
/// See [`write_file`]; those before it have been written then.
pub fn write_files(folder: &Path, files: &[(impl AsRef<Path>, String)]) -> Result<(), FileError> {
    files.iter().try_for_each(|(name, text)| write_file(&folder.join(name), text.as_bytes()))
}

/// Puts a report in its place: `files` by their names, which may have one `/`. In a folder of `owned` (its name, the endings of
/// its files) nothing of an earlier report is left; every other file that is there is carried over.
///
/// # Errors
/// The place is refused, or the operating system refuses; then what was there is there still.
pub fn write_report(folder: &Path, files: &[(String, String)], owned: &[(&str, &[&str])]) -> Result<(), FileError> {
    let name = folder.file_name().ok_or_else(|| FileError::new(folder, Why::NoName))?;
    no_link_on(folder)?;
    let above = folder.parent().filter(|f| !f.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let place = Place::enter(above)?;
    let left = place.old_name(name);
    let failed = |e| FileError::new(folder, Why::Unwritable(e));
    if left.exists() && !folder.exists() {
        // A run was stopped between two renames, on a system that has no exchange.
        disk::rename(&left, folder).map_err(failed)?;
    }
    let named: HashSet<&Path> = files.iter().map(|(name, _)| Path::new(name)).collect();
    let is_ours = |path: &Path| {
        named.contains(path)
            || owned.iter().any(|(inner, endings)| {
                path.parent() == Some(Path::new(inner))
                    && path.extension().is_some_and(|e| endings.iter().any(|ending| e == *ending))
            })
    };
    let mut found = Vec::new();
    survey(folder, Path::new(""), 0, &mut found)?;
    let ours = found.iter().filter(|path| is_ours(path)).count();
    let is_there = |(name, text): &(String, String)| fs::read(folder.join(name)).is_ok_and(|b| b == text.as_bytes());
    if ours == files.len() && files.iter().all(is_there) {
        return Ok(());
    }
    let new = place.new_name();
    let foreign = found.iter().filter(|path| !is_ours(path));
    let made = build(&new, folder, files, foreign).and_then(|()| put(&new, folder, &left));
    if made.is_err() {
        let _ = disk::remove(&new);
    }
    made.map_err(failed)?;
    place.settle();
    // The old report, where it is now. What cannot be removed is swept by the next run.
    for old in [&new, &left] {
        let _ = disk::remove(old);
    }
    Ok(())
}

/// Every regular file below a folder, by its path in it; whatever is neither file nor folder is refused.
fn survey(folder: &Path, inner: &Path, depth: usize, out: &mut Vec<PathBuf>) -> Result<(), FileError> {
    let at = folder.join(inner);
    let failed = |e| FileError::new(&at, Why::Unwritable(e));
    match fs::symlink_metadata(&at) {
        Ok(found) if found.is_dir() => {}
        Ok(found) => return Err(FileError::new(&at, Why::InTheWay(kind(found.file_type())))),
        Err(_) => return Ok(()),
    }
    if depth > DEEPEST {
        return Err(FileError::new(&at, Why::TooDeep(DEEPEST)));
    }
    for entry in fs::read_dir(&at).map_err(failed)? {
        let entry = entry.map_err(failed)?;
        let (kind_of, name) = (entry.file_type().map_err(failed)?, inner.join(entry.file_name()));
        if kind_of.is_symlink() {
            return Err(FileError::new(&folder.join(name), Why::Link));
        } else if kind_of.is_dir() {
            survey(folder, &name, depth + 1, out)?;
        } else if kind_of.is_file() {
            out.push(name);
        } else {
            return Err(FileError::new(&folder.join(name), Why::InTheWay(kind(kind_of))));
        }
    }
    Ok(())
}

/// The new report, whole, in a folder of its own.
fn build<'a>(
    new: &Path,
    old: &Path,
    files: &[(String, String)],
    foreign: impl Iterator<Item = &'a PathBuf>,
) -> io::Result<()> {
    disk::create_folder(new)?;
    for (name, text) in files {
        let path = new.join(name);
        inner_folder(&path)?;
        disk::write_new(&path, text.as_bytes())?;
    }
    for name in foreign {
        // Left by a version that wrote files one by one.
        if name.file_name().is_some_and(|n| n.to_string_lossy().starts_with(".rederive-")) {
            continue;
        }
        let path = new.join(name);
        inner_folder(&path)?;
        disk::carry(&old.join(name), &path)?;
    }
    Ok(())
}

fn inner_folder(path: &Path) -> io::Result<()> {
    match path.parent() {
        Some(folder) if !folder.exists() => fs::create_dir_all(folder),
        _ => Ok(()),
    }
}

/// The new folder takes the place of the old one; the old one takes the new one's name, or `left`.
fn put(new: &Path, folder: &Path, left: &Path) -> io::Result<()> {
    if !folder.exists() {
        return disk::rename(new, folder);
    }
    if disk::exchange(new, folder)? {
        return Ok(());
    }
    disk::rename(folder, left)?;
    disk::rename(new, folder).inspect_err(|_| {
        let _ = disk::rename(left, folder);
    })
}

/// A folder in which something is written: locked, and rid of what stopped runs left.
struct Place {
    folder: PathBuf,
    lock: Option<File>,
}

impl Place {
    fn enter(folder: &Path) -> Result<Place, FileError> {
        fs::create_dir_all(folder).map_err(|e| FileError::new(folder, Why::Unwritable(e)))?;
        let place = Place { folder: folder.to_path_buf(), lock: locked(folder)? };
        if place.lock.is_some() {
            place.sweep();
        }
        Ok(place)
    }

    /// Names of this process: where there are no locks, two runs do not meet.
    fn new_name(&self) -> PathBuf {
        self.folder.join(format!("{NEW}{}", std::process::id()))
    }

    fn old_name(&self, name: &OsStr) -> PathBuf {
        let mut full = std::ffi::OsString::from(OLD);
        full.push(name);
        self.folder.join(full)
    }

    /// Removes what stopped runs left. An old report whose place is empty is no rubbish.
    fn sweep(&self) {
        let Ok(entries) = fs::read_dir(&self.folder) else { return };
        for entry in entries.flatten() {
            let name = entry.file_name();
            let name = name.to_string_lossy();
            let left = name.strip_prefix(OLD).is_some_and(|report| self.folder.join(report).exists());
            if left || name.starts_with(NEW) {
                let _ = disk::remove(&entry.path());
            }
        }
    }

    /// Brings the names to the disk.
    fn settle(&self) {
        if let Some(folder) = &self.lock {
            // Not every file system can; the files themselves are there.
            let _ = folder.sync_all();
        }
    }
}

/// The lock of a folder, held until it is dropped, or until the process ends in whatever way. `None` where a folder cannot be
/// locked.
fn locked(folder: &Path) -> Result<Option<File>, FileError> {
    let Ok(file) = File::open(folder) else { return Ok(None) };
    let started = Instant::now();
    loop {
        match file.try_lock() {
            Ok(()) => return Ok(Some(file)),
            Err(TryLockError::WouldBlock) if started.elapsed() < PATIENCE => {
                std::thread::sleep(Duration::from_millis(20));
            }
            Err(TryLockError::WouldBlock) => return Err(FileError::new(folder, Why::Busy(PATIENCE.as_secs()))),
            Err(TryLockError::Error(_)) => return Ok(None),
        }
    }
}

/// Every step that changes something on the disk. In tests each of them can fail, or be the last.
mod disk {
    use super::{File, OpenOptions, Path, Write, fs, io};

    #[cfg(not(test))]
    fn step() -> io::Result<()> {
        Ok(())
    }
    #[cfg(test)]
    use super::tests::step;

    pub fn create_folder(path: &Path) -> io::Result<()> {
        step()?;
        fs::create_dir(path)
    }

    /// Writes a file that must not be there, and brings it to the disk.
    pub fn write_new(path: &Path, bytes: &[u8]) -> io::Result<()> {
        step()?;
        let mut file: File = OpenOptions::new().write(true).create_new(true).open(path)?;
        let (first, second) = bytes.split_at(bytes.len() / 2);
        file.write_all(first)?;
        step()?;
        file.write_all(second)?;
        step()?;
        file.sync_all()
    }

    /// The same with what is read from somewhere.
    pub fn copy_new(path: &Path, from: &mut dyn io::Read) -> io::Result<()> {
        step()?;
        let mut file: File = OpenOptions::new().write(true).create_new(true).open(path)?;
        io::copy(from, &mut file)?;
        step()?;
        file.sync_all()
    }

    /// Gives a file a second name; where that is not possible, copies it.
    pub fn carry(from: &Path, to: &Path) -> io::Result<()> {
        step()?;
        fs::hard_link(from, to).or_else(|_| fs::copy(from, to).map(|_| ()))
    }

    pub fn rename(from: &Path, to: &Path) -> io::Result<()> {
        step()?;
        fs::rename(from, to)
    }

    /// Two folders take each other's place, at once. Whether this can be done here.
    pub fn exchange(a: &Path, b: &Path) -> io::Result<bool> {
        step()?;
        #[cfg(any(target_os = "linux", target_os = "android", target_vendor = "apple"))]
        {
            use rustix::fs::{CWD, RenameFlags, renameat_with};
            #[cfg(test)]
            if !super::tests::exchanges() {
                return Ok(false);
            }
            match renameat_with(CWD, a, CWD, b, RenameFlags::EXCHANGE) {
                Ok(()) => return Ok(true),
                // Not every file system can.
                Err(rustix::io::Errno::INVAL | rustix::io::Errno::NOSYS | rustix::io::Errno::NOTSUP) => {}
                Err(e) => return Err(e.into()),
            }
        }
        let _ = (a, b);
        Ok(false)
    }

    /// Removes a file, or a folder with what is in it; links in it are removed, not followed.
    pub fn remove(path: &Path) -> io::Result<()> {
        step()?;
        match fs::symlink_metadata(path)?.is_dir() {
            true => fs::remove_dir_all(path),
            false => fs::remove_file(path),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::Cell;
    use std::collections::BTreeMap;

    thread_local! {
        /// Steps until the one that fails, and whether it is the last of all.
        static FAULT: Cell<Option<(usize, bool)>> = const { Cell::new(None) };
        static EXCHANGE: Cell<bool> = const { Cell::new(true) };
    }

    pub(super) fn step() -> io::Result<()> {
        let failed = || Err(io::Error::new(io::ErrorKind::StorageFull, "on purpose"));
        match FAULT.get() {
            None => Ok(()),
            Some((0, true)) => failed(),
            Some((0, false)) => {
                FAULT.set(None);
                failed()
            }
            Some((n, last)) => {
                FAULT.set(Some((n - 1, last)));
                Ok(())
            }
        }
    }

    pub(super) fn exchanges() -> bool {
        EXCHANGE.get()
    }

    /// Every file below a folder, with its bytes.
    fn contents(folder: &Path) -> BTreeMap<String, String> {
        let mut names = Vec::new();
        survey(folder, Path::new(""), 0, &mut names).expect("surveyed");
        names
            .into_iter()
            .map(|n| {
                let text = fs::read_to_string(folder.join(&n)).expect("read");
                (n.display().to_string(), text)
            })
            .collect()
    }

    fn entries(folder: &Path) -> Vec<String> {
        let entries = fs::read_dir(folder).expect("listed");
        let mut names: Vec<String> =
            entries.map(|e| e.expect("entry").file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }

    fn file(name: &str, text: &str) -> (String, String) {
        (name.to_owned(), text.to_owned())
    }

    const OWNED: &[(&str, &[&str])] = &[("c", &["py"])];

    #[test]
    fn a_report_is_exchanged_and_what_is_the_users_is_kept() {
        for exchange in [true, false] {
            EXCHANGE.set(exchange);
            let room = tempfile::tempdir().expect("folder");
            let report = room.path().join("reports").join("x");
            let first = [file("a.json", "1"), file("c/1.py", "p"), file("c/2.py", "q")];
            write_report(&report, &first, OWNED).expect("written");
            assert_eq!(contents(&report).len(), 3);
            fs::write(report.join("c/notes.txt"), "mine").expect("written");
            fs::write(report.join(".rederive-x1y2"), "half").expect("written");
            write_report(&report, &[file("a.json", "2"), file("c/2.py", "q")], OWNED).expect("written");
            let all: Vec<(String, String)> = contents(&report).into_iter().collect();
            let all: Vec<(&str, &str)> = all.iter().map(|(n, t)| (n.as_str(), t.as_str())).collect();
            assert_eq!(all, [("a.json", "2"), ("c/2.py", "q"), ("c/notes.txt", "mine")]);
            assert_eq!(entries(&room.path().join("reports")), ["x"], "nothing else is left");
        }
    }

    #[test]
    fn what_is_read_from_somewhere_is_there_whole_or_not_at_all() {
        struct Broken(u32);
        impl io::Read for Broken {
            fn read(&mut self, to: &mut [u8]) -> io::Result<usize> {
                self.0 += 1;
                to[0] = b'x';
                if self.0 > 3 { Err(io::Error::other("on purpose")) } else { Ok(1) }
            }
        }
        let room = tempfile::tempdir().expect("folder");
        let place = room.path().join("deep").join("t.csv");
        write_from(&place, &mut "first".as_bytes()).expect("written");
        assert_eq!(fs::read_to_string(&place).expect("read"), "first");
        let mut all = 0;
        for step in 0..9 {
            FAULT.set(Some((step, false)));
            let failed = write_from(&place, &mut "second".as_bytes()).is_err();
            FAULT.set(None);
            all += usize::from(failed);
            assert_eq!(fs::read_to_string(&place).expect("read"), if failed { "first" } else { "second" });
            assert_eq!(entries(&room.path().join("deep")), ["t.csv"], "nothing else is left");
            write_from(&place, &mut "first".as_bytes()).expect("written");
        }
        assert_eq!(all, 3);
        assert!(write_from(&place, &mut Broken(0)).is_err());
        assert_eq!(contents(&room.path().join("deep")), BTreeMap::from([("t.csv".to_owned(), "first".to_owned())]));
        assert!(write_from(room.path(), &mut "x".as_bytes()).is_err());
    }

    /// As data bases are tested: every step fails once, and every step is the last one once.
    #[test]
    fn whatever_fails_the_old_or_the_new_is_there() {
        let (mut failures, mut killed) = (0, 0);
        for exchange in [true, false] {
            EXCHANGE.set(exchange);
            for last in [false, true] {
                for n in 0.. {
                    let room = tempfile::tempdir().expect("folder");
                    let report = room.path().join("x");
                    write_report(&report, &[file("a.json", "old"), file("c/1.py", "old")], OWNED).expect("written");
                    fs::write(report.join("notes"), "mine").expect("written");
                    let old = contents(&report);
                    FAULT.set(Some((n, last)));
                    let outcome = write_report(&report, &[file("a.json", "new"), file("b.md", "new")], OWNED);
                    let fired = FAULT.get().is_none_or(|(left, _)| left == 0);
                    FAULT.set(None);
                    let between = last && !exchange && !report.exists();
                    let now = contents(&report);
                    let is_new = now.get("a.json").is_some_and(|t| t == "new");
                    let whole = ["a.json", "b.md", "notes"].iter().all(|n| now.contains_key(*n)) && now.len() == 3;
                    assert!(between || now == old || is_new && whole, "{n}: {now:?}");
                    assert!(outcome.is_err() || is_new, "{n}");
                    if !last {
                        let rest: Vec<String> = entries(room.path()).into_iter().filter(|e| e != "x").collect();
                        // Only removing the old report may fail without a word; the next run does it.
                        assert!(rest.is_empty() || is_new, "{n}: {rest:?}");
                    }
                    failures += usize::from(fired && !last);
                    killed += usize::from(fired && last);
                    // The next run puts everything right.
                    write_report(&report, &[file("a.json", "next")], OWNED).expect("written");
                    assert_eq!(entries(room.path()), ["x"], "{n}");
                    assert_eq!(contents(&report).get("notes").map(String::as_str), Some("mine"), "{n}");
                    if !fired {
                        break;
                    }
                }
            }
        }
        assert!(failures >= 16 && killed >= 16, "{failures} {killed}");
    }

    #[test]
    fn a_file_is_whole_or_as_it_was() {
        for last in [false, true] {
            for n in 0.. {
                let room = tempfile::tempdir().expect("folder");
                let path = room.path().join("a");
                fs::write(&path, "old").expect("written");
                FAULT.set(Some((n, last)));
                let outcome = write_file(&path, b"new");
                let fired = FAULT.get().is_none_or(|(left, _)| left == 0);
                FAULT.set(None);
                let now = fs::read_to_string(&path).expect("read");
                assert_eq!(now, if outcome.is_ok() { "new" } else { "old" }, "{n}");
                write_file(&path, b"next").expect("written");
                assert_eq!(entries(room.path()), ["a"], "{n}");
                if !fired {
                    break;
                }
            }
        }
    }

    #[cfg(unix)]
    #[test]
    fn links_and_devices_are_refused_and_nothing_is_touched() {
        use std::os::unix::fs::symlink;
        let room = tempfile::tempdir().expect("folder");
        let at = |name: &str| room.path().join(name);
        fs::create_dir_all(at("src")).expect("made");
        fs::write(at("src/a.py"), "mine").expect("written");
        fs::create_dir_all(at("r/x")).expect("made");
        symlink("../../src", at("r/x/c")).expect("a link");
        let error = write_report(&at("r/x"), &[file("a.json", "1")], OWNED).expect_err("a link");
        assert!(matches!(error.why, Why::Link), "{error}");
        symlink("../src", at("r/y")).expect("a link");
        let error = write_report(&at("r/y"), &[file("a.json", "1")], OWNED).expect_err("a link");
        assert!(matches!(error.why, Why::Link), "{error}");
        assert_eq!(entries(&at("src")), ["a.py"]);
        symlink("src/a.py", at("out")).expect("a link");
        assert!(matches!(write_file(&at("out"), b"x").expect_err("a link").why, Why::Link));
        let device = write_file(Path::new("/dev/null"), b"x").expect_err("a device");
        assert!(matches!(device.why, Why::InTheWay("a device")), "{device}");
        assert!(matches!(write_file(&at("src"), b"x").expect_err("a folder").why, Why::InTheWay("a folder")));
        let inputs = [at("src/a.py")];
        fs::hard_link(at("src/a.py"), at("b.py")).expect("a second name");
        for name in ["src/a.py", "src/../src/a.py", "b.py"] {
            let error = check_outputs(&[at(name)], &inputs, &[]).expect_err("an input");
            assert!(matches!(error.why, Why::IsInput), "{error}");
        }
        check_outputs(&[at("src/b.py")], &inputs, &[]).expect("another file");
        let error = check_outputs(&[at("r/z/a.json")], &inputs, &[at("r/z")]).expect_err("in a report");
        assert!(matches!(error.why, Why::InReport), "{error}");
        let error = check_outputs(&[], &inputs, &[at("src")]).expect_err("a report over an input");
        assert!(matches!(error.why, Why::InReport), "{error}");
        assert_eq!(fs::read_to_string(at("src/a.py")).expect("read"), "mine");
    }
}
