//! What is read: files by the names that the user gave them, `-` for stdin.

use crate::failure::Failure;
use std::io::Read as _;
use std::path::{Path, PathBuf};
use synth_core::controller::Controller;
use synth_core::controller::json::from_json;
use synth_core::diagnostic::Code;
use synth_core::syntax::{Loaded, Pos, load, read_bounded};

/// The name by which messages speak of an input.
pub(crate) fn name(path: &Path) -> String {
    if is_stdin(path) { "<stdin>".to_owned() } else { path.display().to_string() }
}

/// Whether the path stands for stdin.
pub(crate) fn is_stdin(path: &Path) -> bool {
    path.as_os_str() == "-"
}

/// A controller as `sml synth` writes it.
pub(crate) fn controller(path: &Path) -> Result<Controller, Failure> {
    let text = text(path, Code::MalformedController)?;
    from_json(&text).map_err(|why| {
        let (why, place) = place_of(&why);
        Failure::malformed_at(Code::MalformedController, &name(path), why, place)
    })
}

/// Takes the place out of a message of the JSON reader.
fn place_of(why: &str) -> (&str, Option<Pos>) {
    let place = || {
        let (why, place) = why.rsplit_once(" at line ")?;
        let (line, column) = place.split_once(" column ")?;
        Some((why, Pos { line: line.parse().ok()?, column: column.parse::<u32>().ok()?.max(1) }))
    };
    place().map_or((why, None), |(why, place)| (why, Some(place)))
}

/// Refuses to read stdin for several things.
pub(crate) fn one_stdin<'a>(paths: impl IntoIterator<Item = &'a PathBuf>) -> Result<(), Failure> {
    match paths.into_iter().filter(|path| is_stdin(path)).count() {
        0 | 1 => Ok(()),
        _ => Err(Failure::usage("stdin can be read only once: one `-` is enough")),
    }
}

/// A specification with everything that it imports, mistakes included. What comes from stdin imports relative to
/// the working directory.
pub(crate) fn specification(path: &Path) -> Result<Loaded, Failure> {
    let bytes = if is_stdin(path) { read_bounded(std::io::stdin().lock()) } else { file(path) };
    let bytes = bytes.map_err(|error| Failure::unreadable(&name(path), &error))?;
    let mut imported = |import: &str| file(Path::new(import)).map_err(|error| error.to_string());
    Ok(load(&name(path), &bytes, &mut imported))
}

/// The text of a file that is not a specification; `code` stands for one that is not UTF-8.
pub(crate) fn text(path: &Path, code: Code) -> Result<String, Failure> {
    String::from_utf8(bytes(path)?).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        Failure::malformed(code, &name(path), &format!("not UTF-8 text, byte {at} begins no character"))
    })
}

fn file(path: &Path) -> std::io::Result<Vec<u8>> {
    std::fs::File::open(path).and_then(read_bounded)
}

fn bytes(path: &Path) -> Result<Vec<u8>, Failure> {
    let mut bytes = Vec::new();
    let read = if is_stdin(path) {
        std::io::stdin().lock().read_to_end(&mut bytes).map(|_| bytes)
    } else {
        std::fs::read(path)
    };
    read.map_err(|error| Failure::unreadable(&name(path), &error))
}
