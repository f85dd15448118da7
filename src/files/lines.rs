//! Lines that come one by one, and are a file only once all are there.
//!
//! **In:** text, while something is computed. **Out:** a file with all of it, or none. **Guaranteed:** until then the text is in a
//! temporary file without a name, so that nothing is left of what was not finished, and memory does not grow with it.

use std::io::{self, BufWriter, Seek, Write};
use std::path::{Path, PathBuf};

use super::write::write_from;
use super::{FileError, Why};

/// The lines of a file to be.
#[derive(Debug)]
pub struct Lines {
    place: PathBuf,
    waiting: BufWriter<std::fs::File>,
    failed: Option<io::Error>,
}

impl Lines {
    /// No lines yet.
    ///
    /// # Errors
    /// There is no room for temporary files.
    pub fn of(place: &Path) -> Result<Lines, FileError> {
        let waiting = tempfile::tempfile().map_err(|e| FileError::new(place, Why::Waiting(e)))?;
        Ok(Lines { place: place.to_owned(), waiting: BufWriter::new(waiting), failed: None })
    }

    /// Adds text. That it cannot be kept is told at the end.
    pub fn add(&mut self, text: &str) {
        if self.failed.is_none() {
            self.failed = self.waiting.write_all(text.as_bytes()).err();
        }
    }

    /// Writes the file, as [`write_from`] does.
    ///
    /// # Errors
    /// Text that could not be kept; those of [`write_from`].
    pub fn write(self) -> Result<(), FileError> {
        let lost = |e| FileError::new(&self.place, Why::Waiting(e));
        self.failed.map_or(Ok(()), Err).map_err(lost)?;
        let mut text = self.waiting.into_inner().map_err(|e| lost(e.into_error()))?;
        text.rewind().map_err(lost)?;
        write_from(&self.place, &mut text)
    }
}
