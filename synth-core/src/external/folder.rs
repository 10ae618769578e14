//! The folder: names of files, writing them and sweeping up.

use super::error::{ExternalError, Result};
use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

/// Names of files of rows begin and end like this, so that nobody else's are ever removed.
const PREFIX: &str = "sml-";
const SUFFIX: &str = ".rows";
const CHECKPOINT: &str = "sml.checkpoint";
const UNFINISHED: &str = "sml.checkpoint.unfinished";

/// A folder that one exploration has for itself.
#[derive(Debug)]
pub(super) struct Folder {
    path: PathBuf,
}

impl Folder {
    /// Makes the folder unless it is there.
    pub(super) fn open(path: &Path) -> Result<Folder> {
        fs::create_dir_all(path).map_err(|error| ExternalError::Write(path.to_owned(), error))?;
        Ok(Folder { path: path.to_owned() })
    }

    /// The file of rows with this number.
    pub(super) fn rows(&self, number: u64) -> PathBuf {
        self.path.join(format!("{PREFIX}{number:08}{SUFFIX}"))
    }

    pub(super) fn checkpoint(&self) -> PathBuf {
        self.path.join(CHECKPOINT)
    }

    /// The checkpoint's bytes, if there is one.
    pub(super) fn read_checkpoint(&self) -> Result<Option<Vec<u8>>> {
        match fs::read(self.checkpoint()) {
            Ok(bytes) => Ok(Some(bytes)),
            Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
            Err(error) => Err(ExternalError::Read(self.checkpoint(), error)),
        }
    }

    /// Replaces the checkpoint, once the files that it names are safe on disk.
    pub(super) fn write_checkpoint(&self, bytes: &[u8], files: &[u64]) -> Result<()> {
        for &number in files {
            let path = self.rows(number);
            File::open(&path)
                .and_then(|file| file.sync_all())
                .map_err(|error| ExternalError::Write(path, error))?;
        }
        let unfinished = self.path.join(UNFINISHED);
        let written = File::create(&unfinished)
            .and_then(|mut file| file.write_all(bytes).and_then(|()| file.sync_all()))
            .and_then(|()| fs::rename(&unfinished, self.checkpoint()));
        if let Err(error) = written {
            // The first error is the one to report.
            let _ = fs::remove_file(&unfinished);
            return Err(ExternalError::Write(self.checkpoint(), error));
        }
        // Not every system can open a folder; then the name may be lost with the power, and the checkpoint before counts.
        let _ = File::open(&self.path).and_then(|folder| folder.sync_all());
        Ok(())
    }

    /// Removes a file of rows. One that stays is swept up next time.
    pub(super) fn remove(&self, number: u64) {
        let _ = fs::remove_file(self.rows(number));
    }

    /// Removes what a run left that was ended from outside: files of rows that the checkpoint does not name.
    pub(super) fn sweep(&self, named: &BTreeSet<u64>) -> Result<()> {
        let read = |error| ExternalError::Read(self.path.clone(), error);
        for entry in fs::read_dir(&self.path).map_err(read)? {
            let name = entry.map_err(read)?.file_name();
            if let Some(number) = number_of(&name.to_string_lossy())
                && !named.contains(&number)
            {
                self.remove(number);
            }
        }
        Ok(())
    }
}

fn number_of(name: &str) -> Option<u64> {
    let digits = name.strip_prefix(PREFIX)?.strip_suffix(SUFFIX)?;
    digits.bytes().all(|byte| byte.is_ascii_digit()).then(|| digits.parse().ok())?
}
