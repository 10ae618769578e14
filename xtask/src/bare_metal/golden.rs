//! Files of what is expected, `firmware/expected/TARGET/PROGRAM.{run,size,steps}`.
//!
//! Output, and how often something was called, must be equal, whatever compiled the program. Of other figures, none may be larger by more than a tenth: they vary a
//! little with the compiler, and by some bytes even with the folder that is built in. Files say which compiler they are of.

use super::folders::Folders;
use crate::failure::{At, Failure, Result};
use std::fs;
use std::path::PathBuf;

/// How much larger figures may be, in percent.
const TOLERANCE: u64 = 10;

/// The files of one target.
pub(crate) struct Golden<'v> {
    folder: PathBuf,
    version: &'v str,
    bless: bool,
}

impl<'v> Golden<'v> {
    /// Compares with what is there, or makes it what comes out.
    pub(crate) fn new(folders: &Folders, target: &str, version: &'v str, bless: bool) -> Self {
        Golden { folder: folders.expected().join(target), version, bless }
    }

    /// Compares what a program wrote.
    pub(crate) fn output(&self, program: &str, output: &str) -> Result<()> {
        self.compare(&format!("{program}.run"), output, |expected| {
            if expected == output { Ok(()) } else { Err("its output has changed".to_owned()) }
        })
    }

    /// Compares lines of names and numbers. `kind` is the file's extension.
    pub(crate) fn figures(&self, program: &str, kind: &str, figures: &str) -> Result<()> {
        let text = format!("{}\n{figures}", self.version);
        self.compare(&format!("{program}.{kind}"), &text, |expected| compare_figures(expected, &text))
    }

    fn compare(
        &self,
        file: &str,
        now: &str,
        compare: impl FnOnce(&str) -> std::result::Result<(), String>,
    ) -> Result<()> {
        let path = self.folder.join(file);
        let expected = fs::read_to_string(&path).ok();
        if self.bless {
            fs::create_dir_all(&self.folder).doing(format_args!("create `{}`", self.folder.display()))?;
            if expected.as_deref() != Some(now) {
                fs::write(&path, now).doing(format_args!("write `{}`", path.display()))?;
            }
            return Ok(());
        }
        let Some(expected) = expected else {
            return Err(
                Failure::new(format!("`{}` is not there", path.display())).help("make it with `--bless`")
            );
        };
        compare(&expected).map_err(|why| {
            let (mine, theirs) = (indent(now), indent(&expected));
            Failure::new(format!("`{}`: {why}\nexpected:\n{theirs}now:\n{mine}", path.display()))
                .help("look at the difference, then make it what is expected with `--bless`")
        })
    }
}

fn indent(text: &str) -> String {
    text.lines().map(|line| format!("    {line}\n")).collect()
}

/// The first line is the compiler's version.
fn compare_figures(expected: &str, now: &str) -> std::result::Result<(), String> {
    let of = expected.lines().next().unwrap_or_default();
    let (expected, now) = (words(expected), words(now));
    let is_other = |(expected, now): (&Word<'_>, &Word<'_>)| match (expected, now) {
        (Ok(_), Ok(_)) => false,
        _ => expected != now,
    };
    if expected.len() != now.len() || expected.iter().zip(&now).any(is_other) {
        return Err("it has other lines".to_owned());
    }
    // How often a program calls something follows from the program, not from its compiler.
    if calls(&expected) != calls(&now) {
        return Err("other calls were counted".to_owned());
    }
    let larger = |(expected, now): (&Word<'_>, &Word<'_>)| match (expected, now) {
        (Ok(expected), Ok(now)) if now * 100 > expected * (100 + TOLERANCE) => Some((*expected, *now)),
        _ => None,
    };
    match expected.iter().zip(&now).find_map(larger) {
        Some((expected, now)) => {
            Err(format!("{now} is more than {TOLERANCE} percent above {expected}, the figure of {of}"))
        }
        None => Ok(()),
    }
}

/// The numbers behind the word `calls`.
fn calls<'t>(words: &[Word<'t>]) -> Vec<Word<'t>> {
    words.windows(2).filter(|pair| pair[0] == Err("calls")).map(|pair| pair[1]).collect()
}

/// A number, or a word that is none.
type Word<'t> = std::result::Result<u64, &'t str>;

/// All but the first line.
fn words(text: &str) -> Vec<Word<'_>> {
    let lines = text.lines().skip(1).flat_map(str::split_whitespace);
    lines.map(|word| word.parse().map_err(|_| word)).collect()
}

#[cfg(test)]
mod tests {
    use super::compare_figures;

    #[track_caller]
    fn check(expected: &str, now: &str, why: Result<(), &str>) {
        assert_eq!(compare_figures(expected, now), why.map_err(str::to_owned));
    }

    #[test]
    fn figures_are_near() {
        check("rustc 1\ntext 100\n", "rustc 1\ntext 100\n", Ok(()));
        check("rustc 1\ntext 100\n", "rustc 2\ntext 110\n", Ok(()));
        check("rustc 1\ntext 100\n", "rustc 2\ntext 1\n", Ok(()));
        let why = "111 is more than 10 percent above 100, the figure of rustc 1";
        check("rustc 1\ntext 100\n", "rustc 2\ntext 111\n", Err(why));
        check(
            "rustc 1\ndata 0\n",
            "rustc 2\ndata 1\n",
            Err("1 is more than 10 percent above 0, the figure of rustc 1"),
        );
        check("rustc 1\nstep calls 100 min 7\n", "rustc 2\nstep calls 100 min 6\n", Ok(()));
        check(
            "rustc 1\nstep calls 100 min 7\n",
            "rustc 2\nstep calls 99 min 7\n",
            Err("other calls were counted"),
        );
        check("rustc 1\ntext 100\n", "rustc 2\ndata 100\n", Err("it has other lines"));
        check("rustc 1\na 1\nb 1\n", "rustc 2\na 1\n", Err("it has other lines"));
    }
}
