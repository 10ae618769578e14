//! What is written: products to stdout or, whole or not at all, to a file; notes for people to stderr.

use crate::failure::Failure;
use crate::options::Format;
use std::ffi::OsString;
use std::fs::{self, File, OpenOptions};
use std::io::{self, ErrorKind, Read, Write};
use std::path::{Path, PathBuf};
use std::process;
use std::sync::{Mutex, MutexGuard, PoisonError};
use synth_core::emit::template;

/// Held while something is written, so that nobody ends the process halfway: whether something was.
static WRITING: Mutex<bool> = Mutex::new(false);

fn writing() -> MutexGuard<'static, bool> {
    WRITING.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Ends the process with a failure, whatever others do in it. Who has written something has its result already and may come to
/// an end.
pub(crate) fn end(failure: &Failure, format: Format, color: bool) {
    let written = writing();
    if !*written {
        process::exit(failure.report_by(put, format, color) as i32);
    }
}

/// Writes a product to `path`, or to stdout if there is none or it is `-`.
pub(crate) fn product(path: Option<&Path>, text: &str) -> Result<(), Failure> {
    product_by(path, |out| out.write_all(text.as_bytes()))
}

/// The same with a product that `write` writes piece by piece.
pub(crate) fn product_by(
    path: Option<&Path>,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), Failure> {
    match path.filter(|path| path.as_os_str() != "-") {
        None => stream(write),
        Some(path) => {
            replace(path, write).map_err(|error| Failure::unwritable(&path.display().to_string(), &error))
        }
    }
}

/// Refuses to write the product over what people wrote: the specification, or a secondary that was a template.
pub(crate) fn refuse(output: Option<&Path>, input: &Path) -> Result<(), Failure> {
    let Some(output) = output.filter(|path| path.is_file()) else { return Ok(()) };
    let is_input =
        fs::canonicalize(output).is_ok_and(|output| fs::canonicalize(input).is_ok_and(|i| i == output));
    if is_input || is_template(output) { Err(overwritten(output)) } else { Ok(()) }
}

/// Whether a file is a secondary that was a template, which its head says; products can be very long.
fn is_template(path: &Path) -> bool {
    const HEAD: u64 = 1 << 18;
    let mut head = Vec::new();
    let read = File::open(path).and_then(|file| file.take(HEAD).read_to_end(&mut head));
    read.is_ok() && template::is_template(&String::from_utf8_lossy(&head))
}

/// What would be lost.
pub(crate) fn overwritten(path: &Path) -> Failure {
    Failure::usage(format!("`{}` would be overwritten with the product", path.display()))
}

/// Whether two paths name the same file, which need not be there.
pub(crate) fn same(a: &Path, b: &Path) -> bool {
    resolved(a) == resolved(b)
}

/// Without links, `.` and `..`, as far as there are such folders.
fn resolved(path: &Path) -> PathBuf {
    let path = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
    fs::canonicalize(&path).unwrap_or_else(|_| match (path.parent(), path.file_name()) {
        (Some(folder), Some(name)) => resolved(folder).join(name),
        _ => path,
    })
}

/// Prints to stdout.
pub(crate) fn print(text: &str) -> Result<(), Failure> {
    stream(|out| out.write_all(text.as_bytes()))
}

/// Prints to stdout piece by piece. A reader that has seen enough and closes the pipe is no failure.
pub(crate) fn stream(write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), Failure> {
    let mut written = writing();
    *written = true;
    put_by(write)
}

/// Prints to stdout while [`WRITING`] is held.
fn put(text: &str) -> Result<(), Failure> {
    put_by(|out| out.write_all(text.as_bytes()))
}

fn put_by(write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), Failure> {
    let mut out = io::BufWriter::with_capacity(1 << 16, io::stdout().lock());
    let written = write(&mut out).and_then(|()| out.flush());
    match written {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(Failure::unwritable("<stdout>", &error)),
        _ => Ok(()),
    }
}

/// Prints a line for people to stderr; if nobody listens, nobody is told.
pub(crate) fn note(line: &str) {
    let _ = writeln!(io::stderr().lock(), "{line}");
}

/// Replaces the content of a file, or creates it.
fn replace(path: &Path, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
    let mut written = writing();
    *written = true;
    let existing = match fs::metadata(path) {
        Ok(metadata) if metadata.is_dir() => return Err(io::Error::other("it is a directory")),
        // A device or a pipe cannot be replaced, and nothing in it can be lost.
        Ok(metadata) if !metadata.is_file() => {
            return write(&mut OpenOptions::new().write(true).open(path)?);
        }
        Ok(metadata) => Some(metadata),
        Err(error) if error.kind() == ErrorKind::NotFound => None,
        Err(error) => return Err(error),
    };
    // A link stays a link: what it points at is replaced.
    let target = if existing.is_some() { fs::canonicalize(path)? } else { path.to_owned() };
    let (mut file, temporary) = temporary_beside(&target)?;
    let result = write(&mut file)
        .and_then(|()| existing.map_or(Ok(()), |metadata| file.set_permissions(metadata.permissions())))
        .and_then(|()| fs::rename(&temporary, &target));
    if result.is_err() {
        // The first error is the one to report.
        let _ = fs::remove_file(&temporary);
    }
    result
}

/// Creates a file, whole or not at all, unless there is one already.
pub(crate) fn create(path: &Path, text: &str) -> io::Result<()> {
    let mut written = writing();
    *written = true;
    let (mut file, temporary) = temporary_beside(path)?;
    let result = file.write_all(text.as_bytes()).and_then(|()| match fs::hard_link(&temporary, path) {
        // Some file systems have no links: then a reader may see half of it.
        Err(error) if error.kind() != ErrorKind::AlreadyExists => create_in_place(path, text),
        linked => linked,
    });
    // What counts is what became of `path`.
    let _ = fs::remove_file(&temporary);
    match result {
        // Somebody was faster; what they wrote is theirs.
        Err(error) if error.kind() == ErrorKind::AlreadyExists => Ok(()),
        result => result,
    }
}

fn create_in_place(path: &Path, text: &str) -> io::Result<()> {
    let mut file = OpenOptions::new().write(true).create_new(true).open(path)?;
    let result = file.write_all(text.as_bytes());
    if result.is_err() {
        let _ = fs::remove_file(path);
    }
    result
}

/// A new file in the folder of `target`, from where it can be renamed.
fn temporary_beside(target: &Path) -> io::Result<(File, PathBuf)> {
    let name = target.file_name().ok_or_else(|| io::Error::other("it has no file name"))?;
    let mut attempt = 0;
    loop {
        let mut hidden = OsString::from(".");
        hidden.push(name);
        hidden.push(format!(".{}-{attempt}.tmp", std::process::id()));
        let path = target.with_file_name(hidden);
        match OpenOptions::new().write(true).create_new(true).open(&path) {
            Err(error) if error.kind() == ErrorKind::AlreadyExists && attempt < 100 => attempt += 1,
            opened => return opened.map(|file| (file, path)),
        }
    }
}
