//! What is missing or no longer right among the files of earlier runs.

use crate::failure::{Exit, Failure, nowhere};
use std::io::ErrorKind;
use std::path::Path;
use synth_core::diagnostic::{Code, Diagnostic};
use synth_core::syntax::{Pos, Sources, Span};

/// Diagnostics about files that are no specifications; their texts are not shown.
#[derive(Default)]
pub(in crate::commands) struct Found {
    pub(super) diagnostics: Vec<Diagnostic>,
    pub(super) sources: Sources,
}

impl Found {
    /// Something is wrong with a file, in a line of it.
    pub(super) fn add(&mut self, path: &Path, line: usize, diagnostic: Diagnostic) {
        let file = self.sources.add(path.display().to_string(), "");
        let start = Pos { line: u32::try_from(line).unwrap_or(u32::MAX), column: 1 };
        self.diagnostics.push(Diagnostic { span: Span { file, start, end: start }, ..diagnostic });
    }

    /// Nothing, or why `--check` fails.
    pub(in crate::commands) fn failure(self) -> Result<(), Failure> {
        if self.diagnostics.is_empty() {
            return Ok(());
        }
        Err(Failure::all(Exit::No, self.diagnostics, self.sources))
    }
}

/// Whether a file holds `text`. Version control may have changed the ends of its lines; they do not count.
pub(super) fn compare(
    found: &mut Found,
    path: &Path,
    text: &str,
    help: impl FnOnce() -> String,
) -> Result<(), Failure> {
    let shown = path.display().to_string();
    let stale = |what: &str| nowhere(Code::Stale, format!("`{shown}` {what}")).help(help());
    match std::fs::read(path) {
        Ok(bytes) => {
            if let Some(difference) = Difference::between(&String::from_utf8_lossy(&bytes), text) {
                let Difference { line, found: is, expected } = difference;
                let diagnostic = stale("is stale").note(format!("line {line} is: {is}"));
                found.add(path, line, diagnostic.note(format!("it would be: {expected}")));
            }
        }
        Err(error) if error.kind() == ErrorKind::NotFound => found.add(path, 1, stale("is missing")),
        Err(error) => return Err(Failure::unreadable(&shown, &error)),
    }
    Ok(())
}

/// The first line that differs.
#[derive(PartialEq, Eq, Debug)]
struct Difference {
    /// From 1.
    line: usize,
    found: String,
    expected: String,
}

impl Difference {
    fn between(found: &str, expected: &str) -> Option<Difference> {
        let mut lines = [found, expected]
            .map(|text| text.split('\n').map(|line| line.strip_suffix('\r').unwrap_or(line)));
        for line in 1.. {
            match lines.each_mut().map(Iterator::next) {
                [None, None] => return None,
                [found, expected] if found != expected => {
                    let [found, expected] = excerpts(found, expected);
                    return Some(Difference { line, found, expected });
                }
                _ => {}
            }
        }
        None
    }
}

/// Characters that an excerpt shows.
const EXCERPT: usize = 60;

/// What stands around the first difference of two lines.
fn excerpts(a: Option<&str>, b: Option<&str>) -> [String; 2] {
    let pairs = a.unwrap_or_default().chars().zip(b.unwrap_or_default().chars());
    let skipped = pairs.take_while(|(a, b)| a == b).count().saturating_sub(EXCERPT / 2);
    [a, b].map(|line| {
        let Some(line) = line else { return "no line".to_owned() };
        let mut rest = line.chars().skip(skipped);
        let shown: String = rest.by_ref().take(EXCERPT).collect();
        let [before, behind] = [skipped > 0, rest.next().is_some()].map(|cut| if cut { "…" } else { "" });
        format!("`{before}{shown}{behind}`")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(found: &str, expected: &str, difference: Option<(usize, &str, &str)>) {
        let difference = difference.map(|(line, found, expected)| Difference {
            line,
            found: found.to_owned(),
            expected: expected.to_owned(),
        });
        assert_eq!(Difference::between(found, expected), difference);
    }

    #[test]
    fn lines_are_compared_without_their_ends() {
        check("a\nb\n", "a\nb\n", None);
        check("a\r\nb\r\n", "a\nb\n", None);
        check("a\nb\n", "a\nc\n", Some((2, "`b`", "`c`")));
        check("a\n", "a\nc\n", Some((2, "``", "`c`")));
        check("a", "a\n", Some((2, "no line", "``")));
        check("", "x", Some((1, "``", "`x`")));
        check("a\rb", "ab", Some((1, "`a\rb`", "`ab`")));
    }

    #[test]
    fn long_lines_are_shortened_around_the_difference() {
        let [x, y] = ["x", "y"].map(|last| format!("{}{last}{}", "ü".repeat(100), "z".repeat(100)));
        let [found, expected] =
            ["x", "y"].map(|last| format!("`…{}{last}{}…`", "ü".repeat(30), "z".repeat(29)));
        check(&x, &y, Some((1, &found, &expected)));
    }
}
