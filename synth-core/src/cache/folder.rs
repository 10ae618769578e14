//! A store on disk.

use super::{Key, Store, entry, hash};
use std::fs::{self, File};
use std::io::{self, Read as _, Write as _};
use std::path::{Path, PathBuf};
use std::process;
use std::sync::atomic::{AtomicU32, Ordering};
use std::time::SystemTime;

/// Names of files here begin like this and end like one of these two, so that nobody else's are ever removed.
const PREFIX: &str = "sml-";
const WHOLE: &str = ".entry";
const UNFINISHED: &str = ".unfinished";

/// A folder with a file for each entry.
///
/// It may be shared by any number of processes, of any versions. It is made when something is put there, and bounded: a
/// new entry drives out the oldest ones. Whatever goes wrong with files is a miss, or nothing that is kept.
#[derive(Clone, Debug)]
pub struct Folder {
    path: PathBuf,
    bound: Bound,
}

#[derive(Clone, Copy, Debug)]
struct Bound {
    entries: usize,
    bytes: u64,
}

impl Folder {
    /// The one at `path`; it need not exist. At most 128 entries and 128 MiB are left there.
    #[must_use]
    pub fn at(path: impl Into<PathBuf>) -> Folder {
        Folder { path: path.into(), bound: Bound { entries: 128, bytes: 128 << 20 } }
    }

    fn file(&self, key: &Key) -> PathBuf {
        self.path.join(format!("{PREFIX}{:016x}{WHOLE}", hash(key.bytes())))
    }

    fn read(&self, key: &Key) -> io::Result<Vec<u8>> {
        let mut bytes = Vec::new();
        File::open(self.file(key))?.take(self.bound.bytes).read_to_end(&mut bytes)?;
        Ok(bytes)
    }

    /// Writes a file aside and renames it: other processes see the whole entry or none.
    fn write(&self, key: &Key, texts: &[String]) -> io::Result<()> {
        /// Tells threads of this process apart.
        static WRITES: AtomicU32 = AtomicU32::new(0);
        let bytes = entry::encode(key, texts);
        if bytes.len() as u64 > self.bound.bytes {
            return Ok(());
        }
        fs::create_dir_all(&self.path)?;
        let target = self.file(key);
        let (process, write) = (process::id(), WRITES.fetch_add(1, Ordering::Relaxed));
        let unfinished = target.with_extension(format!("{process}-{write}{UNFINISHED}"));
        let mut file = File::create_new(&unfinished)?;
        let written = file.write_all(&bytes);
        drop(file);
        let written = written.and_then(|()| fs::rename(&unfinished, &target));
        if written.is_err() {
            fs::remove_file(&unfinished)?;
        }
        written?;
        self.prune()
    }

    /// Removes the oldest files beyond the bound; of two of the same time the one whose name comes first. What another
    /// process has just removed is as good as removed.
    fn prune(&self) -> io::Result<()> {
        let mut files: Vec<(SystemTime, PathBuf, u64)> = fs::read_dir(&self.path)?
            .filter_map(|file| {
                let path = file.ok()?.path();
                let metadata = fs::symlink_metadata(&path).ok()?;
                let ours = is_ours(&path) && metadata.is_file();
                ours.then_some((metadata.modified().ok()?, path, metadata.len()))
            })
            .collect();
        files.sort_unstable_by(|a, b| b.cmp(a));
        let mut bytes = 0;
        for (count, (_, path, length)) in files.iter().enumerate() {
            bytes += length;
            if count >= self.bound.entries || bytes > self.bound.bytes {
                let _ = fs::remove_file(path);
            }
        }
        Ok(())
    }
}

fn is_ours(path: &Path) -> bool {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    name.starts_with(PREFIX) && (name.ends_with(WHOLE) || name.ends_with(UNFINISHED))
}

impl Store for Folder {
    fn get(&self, key: &Key) -> Option<Vec<String>> {
        entry::decode(&self.read(key).ok()?, key)
    }

    fn put(&self, key: &Key, texts: &[String]) {
        // Without a cache it goes on as well.
        let _ = self.write(key, texts);
    }
}

#[cfg(test)]
mod tests;
