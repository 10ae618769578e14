//! Gives `cache` a fingerprint of this crate's sources, so that a change of the tool makes what it cached before useless
//! even where the version stays the same.

use std::path::{Path, PathBuf};
use std::{fs, io};

fn main() -> io::Result<()> {
    let mut files = Vec::new();
    collect(Path::new("src"), &mut files)?;
    files.sort();
    let mut hash = 0xcbf2_9ce4_8422_2325;
    for file in &files {
        println!("cargo::rerun-if-changed={}", file.display());
        for byte in fs::read(file)? {
            hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }
    println!("cargo::rustc-env=SYNTH_CORE_FINGERPRINT={hash:016x}");
    Ok(())
}

/// All sources but those of tests. Files are watched, not folders: a new one matters once another names it.
fn collect(folder: &Path, files: &mut Vec<PathBuf>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        let of_tests =
            ["tests", "testing"].iter().any(|name| path.file_stem().is_some_and(|stem| stem == *name));
        if of_tests {
            continue;
        }
        if path.is_dir() {
            collect(&path, files)?;
        } else {
            files.push(path);
        }
    }
    Ok(())
}
