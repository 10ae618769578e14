//! Crates written by a test and built by `cargo`, as a user's crate would be.

use std::fs;
use std::io::{self, Write as _};
use std::path::PathBuf;
use std::process::{Command, Output, Stdio};

/// A crate in a directory of its own, outside of any workspace, that depends on `controller-template` only.
#[derive(Debug)]
pub struct Scratch {
    directory: PathBuf,
}

impl Scratch {
    /// Creates or empties it; `features` are those of `controller-template`, `rest` ends the manifest.
    ///
    /// # Errors
    ///
    /// When files cannot be written.
    pub fn new(parent: &str, name: &str, features: &[&str], rest: &str) -> io::Result<Self> {
        let directory = PathBuf::from(parent).join(name);
        let source = directory.join("src");
        if source.exists() {
            fs::remove_dir_all(&source)?;
        }
        fs::create_dir_all(&source)?;
        let runtime = concat!(env!("CARGO_MANIFEST_DIR"), "/../controller-template");
        let manifest = format!(
            "[package]\nname = {name:?}\nversion = \"0.0.0\"\nedition = \"2021\"\nrust-version = \"1.85\"\n\
             description = \"Written by a test\"\nlicense = \"MIT\"\n\n[workspace]\n\n[dependencies]\n\
             controller-template = {{ path = {runtime:?}, features = {features:?} }}\n\n{rest}"
        );
        let scratch = Scratch { directory };
        scratch.write("Cargo.toml", &manifest)?;
        Ok(scratch)
    }

    /// Writes a file, its path relative to the crate.
    ///
    /// # Errors
    ///
    /// When it cannot be written.
    pub fn write(&self, path: &str, content: &str) -> io::Result<()> {
        let path = self.directory.join(path);
        path.parent().map_or(Ok(()), fs::create_dir_all)?;
        fs::write(path, content)
    }

    /// Runs `cargo`, offline, in the crate with something on its input.
    ///
    /// # Errors
    ///
    /// When `cargo` cannot be run or does not take its input.
    pub fn cargo(&self, arguments: &[&str], input: &str) -> io::Result<Output> {
        let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
        cargo.current_dir(&self.directory).env("CARGO_NET_OFFLINE", "true").args(arguments);
        // What surrounds the test run is not the user's.
        for variable in
            ["CARGO_TARGET_DIR", "RUSTFLAGS", "CARGO_ENCODED_RUSTFLAGS", "CARGO_BUILD_TARGET", "SML_CACHE"]
        {
            cargo.env_remove(variable);
        }
        let mut child = cargo.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn()?;
        let stdin = child.stdin.take();
        // Both pipes may fill up, so the input is written while the output is read.
        std::thread::scope(|scope| {
            let writer = scope.spawn(|| stdin.map_or(Ok(()), |mut stdin| stdin.write_all(input.as_bytes())));
            let output = child.wait_with_output();
            writer.join().map_err(|_| io::Error::other("the writer panicked"))??;
            output
        })
    }
}
