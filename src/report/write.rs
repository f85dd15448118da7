//! Files of a report: all of them, or none.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Writes the files into a folder, which is made if it is missing.
///
/// Every file is first written in full beside its place; only when all are there do they take their names. If that fails
/// half way, what was there before is put back.
///
/// # Errors
/// The first failure, with the path that it concerns.
pub fn write_files(folder: &Path, files: &[(&str, String)]) -> Result<(), WriteError> {
    let failed = |path: &Path| {
        let path = path.to_path_buf();
        move |source: io::Error| WriteError { path, source }
    };
    let new = !folder.exists();
    fs::create_dir_all(folder).map_err(failed(folder))?;
    let result = replace_all(folder, files);
    if result.is_err() && new {
        // Nothing was kept, so neither is the folder; if that fails too, the first failure is the one to tell.
        let _ = fs::remove_dir(folder);
    }
    result
}

fn replace_all(folder: &Path, files: &[(&str, String)]) -> Result<(), WriteError> {
    let mut staged = Vec::new();
    for (name, text) in files {
        let path = folder.join(name);
        let failed = |source: io::Error| WriteError { path: path.clone(), source };
        if path.is_dir() {
            return Err(failed(io::Error::new(io::ErrorKind::IsADirectory, "there is a folder of this name")));
        }
        let before = if path.exists() { Some(fs::read(&path).map_err(failed)?) } else { None };
        if before.as_deref() != Some(text.as_bytes()) {
            staged.push((stage(folder, text.as_bytes()).map_err(failed)?, path, before));
        }
    }
    let mut done: Vec<(PathBuf, Option<Vec<u8>>)> = Vec::new();
    for (file, path, before) in staged {
        if let Err(error) = file.persist(&path) {
            for (path, before) in done {
                let _ = match before {
                    Some(bytes) => stage(folder, &bytes).and_then(|f| f.persist(&path).map(drop).map_err(|e| e.error)),
                    None => fs::remove_file(&path),
                };
            }
            return Err(WriteError { path, source: error.error });
        }
        done.push((path, before));
    }
    Ok(())
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
