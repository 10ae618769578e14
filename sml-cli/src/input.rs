//! What is read: files by the names that the user gave them, `-` for stdin.

use crate::failure::Failure;
use std::io::Read as _;
use std::path::{Path, PathBuf};
use synth_core::controller::json::{from_json, level_of};
use synth_core::controller::{Controller, Level};
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

/// A controller as `sml synth` writes it, and how it says to be minimised.
pub(crate) fn controller(path: &Path) -> Result<(Controller, Level), Failure> {
    let text = text(path, Code::MalformedController)?;
    let read = from_json(&text).and_then(|controller| Ok((controller, level_of(&text)?)));
    read.map_err(|why| {
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

/// A specification or a plant, of which only this is known so far.
pub(crate) struct Given {
    pub(crate) name: String,
    pub(crate) bytes: Vec<u8>,
    /// By the extension of the file, or the first word of what comes from stdin.
    pub(crate) is_plant: bool,
}

/// What a subcommand is about.
pub(crate) fn given(path: &Path) -> Result<Given, Failure> {
    let bytes = if is_stdin(path) { read_bounded(std::io::stdin().lock()) } else { file(path) };
    let bytes = bytes.map_err(|error| Failure::unreadable(&name(path), &error))?;
    let extension_says = !is_stdin(path) && path.extension().is_some_and(|extension| extension == "plant");
    let is_plant = extension_says || is_stdin(path) && begins_a_plant(&bytes);
    Ok(Given { name: name(path), bytes, is_plant })
}

impl Given {
    /// Whether it is a plant by the extension of the file, or by its first word.
    pub(crate) fn begins_a_plant(&self) -> bool {
        self.is_plant || begins_a_plant(&self.bytes)
    }
}

fn begins_a_plant(bytes: &[u8]) -> bool {
    std::str::from_utf8(bytes).is_ok_and(|text| first_word(text) == "plant")
}

/// The letters behind blanks and comments.
fn first_word(text: &str) -> &str {
    let mut rest = text.trim_start_matches('\u{feff}').trim_start();
    while let Some(behind) = behind_comment(rest) {
        rest = behind.trim_start();
    }
    let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len());
    &rest[..end]
}

/// What follows the comment that begins here.
fn behind_comment(text: &str) -> Option<&str> {
    if text.starts_with("//") {
        return Some(text.split_once('\n').map_or("", |(_, behind)| behind));
    }
    let mut rest = text.strip_prefix("/*")?;
    let mut open = 1;
    while open > 0 {
        let mark = rest.find(['*', '/'])?;
        rest = &rest[mark..];
        let delta = if rest.starts_with("/*") { 1 } else { -i32::from(rest.starts_with("*/")) };
        open += delta;
        rest = &rest[if delta == 0 { 1 } else { 2 }..];
    }
    Some(rest)
}

/// A specification with everything that it imports, mistakes included. What comes from stdin imports relative to
/// the working directory.
pub(crate) fn specification(given: &Given) -> Loaded {
    let mut imported = |import: &str| file(Path::new(import)).map_err(|error| error.to_string());
    load(&given.name, &given.bytes, &mut imported)
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

#[cfg(test)]
mod tests {
    use super::first_word;

    #[track_caller]
    fn check(text: &str, word: &str) {
        assert_eq!(first_word(text), word, "{text:?}");
    }

    #[test]
    fn the_first_word_tells_the_language() {
        check("plant P { }", "plant");
        check("\u{feff}\n  /// About it.\n// plant\nplant{", "plant");
        check("/* a /* nested */ comment */ plant P", "plant");
        check("/**/plant", "plant");
        check("plants", "plants");
        check("specification X { }", "specification");
        for nothing in ["", "//", "/* /* */ plant", "/*/ plant", "{", "é"] {
            check(nothing, if nothing == "é" { "é" } else { "" });
        }
    }
}
