//! `docs/comparison.md` and its plots, made from the figures.

use super::figures::{Figures, Outcome, Report};
use super::machines;
use super::verdict::verdict;
use crate::bare_metal::folders::Folders;
use crate::failure::{At, Failure, Result};
use crate::plot::{Series, grouped, plot};
use std::fmt::Write as _;
use std::fs;
use std::path::PathBuf;

const BEGIN: &str = "<!-- figures: `cargo xtask compare` writes them -->\n";
const END: &str = "<!-- end of figures -->\n";

/// Crates whose versions matter.
const CRATES: [&str; 2] = ["smlang", "statig"];

/// A file, its title, the name of its values, and which they are.
type Plot = (&'static str, &'static str, &'static str, fn(Figures) -> u64);

const PLOTS: [Plot; 3] = [
    ("flash", "Flash of the machine", "bytes", |figures| figures.flash),
    ("instructions", "Instructions of a step, worst case", "instructions", |figures| figures.most),
    ("compile", "Time to compile the machine, release", "milliseconds", |figures| figures.compile),
];

/// The file of the figures.
pub(super) fn figures(folders: &Folders) -> PathBuf {
    folders.docs().join("comparison.txt")
}

/// Versions of the compiler, and of the crates in the firmware's lock file.
pub(super) fn versions(folders: &Folders, compiler: &str) -> Result<String> {
    let path = folders.firmware().join("Cargo.lock");
    let lock = fs::read_to_string(&path).doing(format_args!("read `{}`", path.display()))?;
    let mut all = vec![compiler.to_owned()];
    for name in CRATES {
        let rest = lock.split_once(&format!("name = \"{name}\"\nversion = \"")).map(|(_, rest)| rest);
        let version = rest.and_then(|rest| rest.split('"').next());
        let version = version.ok_or_else(|| Failure::new(format!("`{}` has no `{name}`", path.display())))?;
        all.push(format!("{name} {version}"));
    }
    Ok(all.join(", "))
}

/// All files that are made from the figures, with their text.
pub(super) fn files(folders: &Folders, report: &Report) -> Result<Vec<(PathBuf, String)>> {
    let path = folders.docs().join("comparison.md");
    let old = fs::read_to_string(&path).doing(format_args!("read `{}`", path.display()))?;
    let parts = old.split_once(BEGIN).and_then(|(before, rest)| Some((before, rest.split_once(END)?.1)));
    let (before, behind) =
        parts.ok_or_else(|| Failure::new("`docs/comparison.md` has no place for figures"))?;
    let page = format!("{before}{BEGIN}{}{END}{behind}", tables(report));
    let plots = PLOTS.iter().map(|&(name, title, y, of)| {
        let svg = plot(title, "transitions", y, &series(report, of));
        (folders.docs().join(format!("comparison-{name}.svg")), svg)
    });
    Ok(plots.chain([(path, page)]).collect())
}

fn series(report: &Report, of: fn(Figures) -> u64) -> Vec<Series> {
    let points = |machine| {
        let point = |size| Some((u64::from(size), of(report.get(size, machine)?.figures()?)));
        report.sizes().into_iter().filter_map(point).collect()
    };
    machines::ALL
        .map(|machine| Series { name: machine.name(), own: machine.is_own(), points: points(machine) })
        .into()
}

/// What stands between the marks.
fn tables(report: &Report) -> String {
    let mut text = format!("\nMeasured with {}.\n\n{}\n", report.versions, verdict(report));
    for (name, title, ..) in PLOTS {
        let _ = writeln!(text, "![{title}](comparison-{name}.svg)");
    }
    text.push_str(
        "\n| transitions | machine | flash | bytes a transition | RAM | min | mean | max | compile, ms |\n\
         |--:|---|--:|--:|--:|--:|--:|--:|--:|\n",
    );
    for size in report.sizes() {
        for (machine, outcome) in report.of_size(size) {
            let (transitions, name) = (grouped(size.into()), machine.name());
            let _ = write!(text, "| {transitions} | `{name}` | ");
            let _ = match outcome {
                Outcome::Measured(Figures { flash, ram, least, mean, most, compile }) => writeln!(
                    text,
                    "{} | {:.1} | {ram} | {least} | {mean} | {most} | {} |",
                    grouped(flash),
                    flash as f64 / f64::from(size),
                    grouped(compile)
                ),
                Outcome::TooSlow(seconds) => {
                    writeln!(text, "does not compile in {seconds} s | | | | | | |")
                }
            };
        }
    }
    text.push('\n');
    text
}

#[cfg(test)]
mod tests {
    use super::super::figures::tests::report;
    use super::{Folders, Report, figures, files, tables};

    #[test]
    fn the_page_has_the_figures() {
        let folders = Folders::new();
        let report = Report::read(&figures(&folders)).unwrap();
        for (path, text) in files(&folders, &report).unwrap() {
            if std::env::var_os("SML_BLESS").is_some() {
                std::fs::write(&path, &text).unwrap();
            }
            let old = std::fs::read_to_string(&path).unwrap();
            assert!(old == text, "`SML_BLESS=1 cargo test -p xtask` writes `{}`", path.display());
        }
    }

    #[test]
    fn a_machine_that_does_not_compile_has_its_row() {
        let text = tables(&report(
            "50 comb flash 125 ram 4 min 8 mean 20 max 40 compile 1200\n50 smlang stopped 120\n",
        ));
        assert!(text.contains("| 50 | `comb` | 125 | 2.5 | 4 | 8 | 20 | 40 | 1,200 |\n"));
        assert!(text.contains("| 50 | `smlang` | does not compile in 120 s | | | | | | |\n"));
    }
}
