//! Files of a report: all of them, or none.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Writes the files into a folder, which is made if it is missing. A name may have one `/`: a file in a folder inside.
///
/// Every file is first written in full beside its place; only when all are there do they take their names. If that fails
/// half way, what was there before is put back.
///
/// # Errors
/// The first failure, with the path that it concerns.
pub fn write_files(folder: &Path, files: &[(&str, String)]) -> Result<(), WriteError> {
    write_report(folder, files, &[])
}

/// The same, for a report that has folders of its own inside: a file in one of `owned` (a folder's name and the ending of its
/// files) that is not among `files` is left from an earlier report, and is removed. So is such a folder when it is empty.
///
/// # Errors
/// The first failure, with the path that it concerns.
pub fn write_report(folder: &Path, files: &[(&str, String)], owned: &[(&str, &str)]) -> Result<(), WriteError> {
    let mut made = Vec::new();
    let result = replace_all(folder, files, owned, &mut made);
    let inner = owned.iter().map(|(name, _)| folder.join(name));
    // Folders that hold nothing are not kept; what is not empty stays, which is no failure.
    for empty in inner.chain(if result.is_err() { made } else { Vec::new() }) {
        let _ = fs::remove_dir(empty);
    }
    result
}

/// What a file was before it was replaced or removed.
type Before = (PathBuf, Option<Vec<u8>>);

fn replace_all(
    folder: &Path,
    files: &[(&str, String)],
    owned: &[(&str, &str)],
    made: &mut Vec<PathBuf>,
) -> Result<(), WriteError> {
    let mut staged = Vec::new();
    for (name, text) in files {
        let path = folder.join(name);
        let failed = |source: io::Error| WriteError { path: path.clone(), source };
        let parent = path.parent().unwrap_or(folder).to_path_buf();
        // The innermost first, as they are removed.
        let missing: Vec<PathBuf> =
            [&parent, folder].into_iter().filter(|p| !p.exists()).map(Path::to_path_buf).collect();
        fs::create_dir_all(&parent).map_err(|source| WriteError { path: parent.clone(), source })?;
        made.splice(0..0, missing);
        if path.is_dir() {
            return Err(failed(io::Error::new(io::ErrorKind::IsADirectory, "there is a folder of this name")));
        }
        let before = if path.exists() { Some(fs::read(&path).map_err(failed)?) } else { None };
        if before.as_deref() != Some(text.as_bytes()) {
            staged.push((stage(&parent, text.as_bytes()).map_err(failed)?, path, before));
        }
    }
    let mut removed: Vec<Before> = Vec::new();
    for path in stale(folder, files, owned)? {
        let before = fs::read(&path).map_err(|source| WriteError { path: path.clone(), source })?;
        removed.push((path, Some(before)));
    }
    let mut done: Vec<Before> = Vec::new();
    for (file, path, before) in staged {
        if let Err(error) = file.persist(&path) {
            put_back(done);
            return Err(WriteError { path, source: error.error });
        }
        done.push((path, before));
    }
    for (path, before) in removed {
        if let Err(source) = fs::remove_file(&path) {
            put_back(done);
            return Err(WriteError { path, source });
        }
        done.push((path, before));
    }
    Ok(())
}

/// Restores what was there; what cannot be restored is not, as the first failure is the one to tell.
fn put_back(done: Vec<Before>) {
    for (path, before) in done {
        let folder = path.parent().unwrap_or(Path::new("."));
        let _ = match before {
            Some(bytes) => stage(folder, &bytes).and_then(|f| f.persist(&path).map(drop).map_err(|e| e.error)),
            None => fs::remove_file(&path),
        };
    }
}

/// Files in the report's own folders that this report does not have, in order.
fn stale(folder: &Path, files: &[(&str, String)], owned: &[(&str, &str)]) -> Result<Vec<PathBuf>, WriteError> {
    let mut out = Vec::new();
    for (name, ending) in owned {
        let inner = folder.join(name);
        if !inner.is_dir() {
            continue;
        }
        let failed = |source: io::Error| WriteError { path: inner.clone(), source };
        for entry in fs::read_dir(&inner).map_err(failed)? {
            let path = entry.map_err(failed)?.path();
            let ours = path.extension().is_some_and(|e| e == *ending) && path.is_file();
            if ours && !files.iter().any(|(name, _)| folder.join(name) == path) {
                out.push(path);
            }
        }
    }
    out.sort();
    Ok(out)
}

fn stage(folder: &Path, bytes: &[u8]) -> io::Result<tempfile::NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".rederive-");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(fs::Permissions::from_mode(0o644));
    }
    let mut file = builder.tempfile_in(folder)?;
    file.write_all(bytes)?;
    file.as_file().sync_all()?;
    Ok(file)
}

/// A file that could not be written.
#[derive(Debug, thiserror::Error)]
#[error("`{}` cannot be written: {source}", path.display())]
pub struct WriteError {
    /// Which.
    pub path: PathBuf,
    /// Why.
    pub source: io::Error,
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(folder: &Path) -> Vec<String> {
        let entries = fs::read_dir(folder).expect("listed");
        let mut names: Vec<String> =
            entries.map(|e| e.expect("entry").file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }

    #[test]
    fn all_files_are_written_and_nothing_else_is_left() {
        let folder = tempfile::tempdir().expect("folder");
        let target = folder.path().join("reports").join("x");
        let files = [("a.json", "1\n".to_owned()), ("b.md", "2\n".to_owned())];
        write_files(&target, &files).expect("written");
        write_files(&target, &files).expect("written again");
        assert_eq!(names(&target), ["a.json", "b.md"]);
        assert_eq!(fs::read_to_string(target.join("b.md")).expect("read"), "2\n");
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt;
            let mode = fs::metadata(target.join("a.json")).expect("there").permissions().mode();
            assert_eq!(mode & 0o777 & !0o022, 0o644);
        }
    }

    #[test]
    fn what_is_left_from_an_earlier_report_is_removed() {
        let folder = tempfile::tempdir().expect("folder");
        let target = folder.path().join("x");
        let owned = [("c", "py")];
        let file = |name: &'static str| (name, format!("{name}\n"));
        write_report(&target, &[file("a.json"), file("c/1.py"), file("c/2.py")], &owned).expect("written");
        assert_eq!(names(&target), ["a.json", "c"]);
        assert_eq!(names(&target.join("c")), ["1.py", "2.py"]);
        fs::write(target.join("c/notes.txt"), "mine").expect("written");
        write_report(&target, &[file("a.json"), file("c/2.py")], &owned).expect("written");
        assert_eq!(names(&target.join("c")), ["2.py", "notes.txt"]);
        // When something cannot be written, nothing is removed either.
        fs::create_dir(target.join("b.md")).expect("made");
        assert!(write_report(&target, &[file("a.json"), file("b.md")], &owned).is_err());
        assert_eq!(names(&target.join("c")), ["2.py", "notes.txt"]);
        fs::remove_dir(target.join("b.md")).expect("removed");
        fs::remove_file(target.join("c/notes.txt")).expect("removed");
        write_report(&target, &[file("a.json")], &owned).expect("written");
        assert_eq!(names(&target), ["a.json"]);
        // A folder that was made for nothing goes again.
        let other = folder.path().join("y");
        fs::write(folder.path().join("file"), "").expect("written");
        assert!(write_report(&other, &[file("a.json"), ("../file/z", String::new())], &owned).is_err());
        assert!(!other.exists());
    }

    #[test]
    fn nothing_changes_when_one_file_cannot_be_written() {
        let folder = tempfile::tempdir().expect("folder");
        let target = folder.path().join("x");
        write_files(&target, &[("a.json", "old\n".to_owned())]).expect("written");
        fs::create_dir(target.join("b.md")).expect("made");
        let files = [("a.json", "new\n".to_owned()), ("b.md", "2\n".to_owned())];
        let error = write_files(&target, &files).expect_err("b.md is a folder");
        assert!(error.to_string().contains("b.md"));
        assert_eq!(fs::read_to_string(target.join("a.json")).expect("read"), "old\n");
        assert_eq!(names(&target), ["a.json", "b.md"]);

        fs::write(folder.path().join("file"), "").expect("written");
        assert!(write_files(&folder.path().join("file"), &files).is_err());
    }
}
