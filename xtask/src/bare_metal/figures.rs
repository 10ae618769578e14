//! The figures of the golden files as tables in `docs/firmware.md`.

use super::folders::Folders;
use super::programs::{self, Program, Steps};
use super::target::{self, Target};
use crate::failure::{At, Failure, Result};
use std::fmt::Write as _;
use std::fs;

const BEGIN: &str = "<!-- figures: `cargo xtask bare-metal test --bless` writes them -->\n";
const END: &str = "<!-- end of figures -->\n";

/// Writes the tables into the page, unless they are there already.
pub(crate) fn write(folders: &Folders) -> Result<()> {
    let path = page(folders);
    let old = fs::read_to_string(&path).doing(format_args!("read `{}`", path.display()))?;
    let new = replaced(&old, &tables(folders)?)?;
    if new == old {
        return Ok(());
    }
    fs::write(&path, new).doing(format_args!("write `{}`", path.display()))
}

fn page(folders: &Folders) -> std::path::PathBuf {
    folders.repository.join("docs/firmware.md")
}

fn replaced(page: &str, tables: &str) -> Result<String> {
    let parts = page.split_once(BEGIN).and_then(|(before, rest)| Some((before, rest.split_once(END)?.1)));
    let (before, behind) =
        parts.ok_or_else(|| Failure::new("`docs/firmware.md` has no place for figures"))?;
    Ok(format!("{before}{BEGIN}{tables}{END}{behind}"))
}

/// Tables of look-ups, operations and sizes, of all golden files that are there.
fn tables(folders: &Folders) -> Result<String> {
    let (sizes, versions) = sizes(folders)?;
    let (look_ups, operations) = (look_ups(folders)?, operations(folders)?);
    Ok(format!("\nCompiled by {}.\n\n{look_ups}\n{operations}\n{sizes}\n", versions.join(" and ")))
}

/// The table, and the versions of compilers.
fn sizes(folders: &Folders) -> Result<(String, Vec<String>)> {
    let mut sizes = String::from("| program | target | text | data | bss |\n|---|---|---|---|---|\n");
    let mut versions = Vec::new();
    for program in programs::ALL {
        for target in target::ALL.iter().filter(|target| program.is_for(target)) {
            let text = golden(folders, target, program, "size")?;
            let (name, architecture) = (program.name, architecture(target.triple));
            versions.extend(text.lines().next().map(str::to_owned));
            let numbers: Vec<&str> =
                text.lines().skip(1).filter_map(|line| line.split_whitespace().nth(1)).collect();
            let _ = writeln!(sizes, "| `{name}` | {architecture} | {} |", numbers.join(" | "));
        }
    }
    versions.sort();
    versions.dedup();
    Ok((sizes, versions))
}

/// By controller, engine and target, with the bytes of tables.
fn look_ups(folders: &Folders) -> Result<String> {
    let mut table = String::from(
        "| controller | engine | tables | target | code | min | mean | max |\n|---|---|---|---|---|---|---|---|\n",
    );
    for program in programs::ALL.iter().filter(|program| matches!(program.steps, Steps::LookUps)) {
        for [label, target, figures] in steps(folders, program)? {
            let run = golden(folders, &target::ALL[0], program, "run")?;
            // `rows_search: tables 1222, states …`
            let of_label = run.lines().find_map(|line| line.strip_prefix(&*label)?.strip_prefix(": tables "));
            let tables = of_label.and_then(|rest| rest.split(',').next()).unwrap_or("?");
            let (controller, engine) = label.split_once('_').unwrap_or((&label, "?"));
            let _ = writeln!(table, "| `{controller}` | `{engine}` | {tables} | {target} | {figures} |");
        }
    }
    Ok(table)
}

/// By controller, operation and target.
fn operations(folders: &Folders) -> Result<String> {
    let mut table = String::from(
        "| controller | operation | target | code | min | mean | max |\n|---|---|---|---|---|---|---|\n",
    );
    for program in programs::ALL.iter().filter(|program| matches!(program.steps, Steps::Operations(_))) {
        for [label, target, figures] in steps(folders, program)? {
            let _ = writeln!(table, "| `{}` | `{label}` | {target} | {figures} |", program.name);
        }
    }
    Ok(table)
}

/// Of every function its label, the target, and code, least, mean and most instructions; targets beside each other.
fn steps(folders: &Folders, program: &Program) -> Result<Vec<[String; 3]>> {
    let mut steps = Vec::new();
    for (order, target) in target::ALL.iter().enumerate() {
        for line in golden(folders, target, program, "steps")?.lines().skip(1) {
            let words: Vec<&str> = line.split_whitespace().collect();
            let [label, _, code, _, _, _, min, _, mean, _, max] = words[..] else { continue };
            steps.push((label.to_owned(), order, [code, min, mean, max].join(" | ")));
        }
    }
    steps.sort();
    let row = |(label, order, figures): (String, usize, String)| {
        [label, architecture(target::ALL[order].triple).to_owned(), figures]
    };
    Ok(steps.into_iter().map(row).collect())
}

/// The text of a golden file.
fn golden(folders: &Folders, target: &Target, program: &Program, what: &str) -> Result<String> {
    let path = folders.expected().join(target.triple).join(format!("{}.{what}", program.name));
    fs::read_to_string(&path).doing(format_args!("read `{}`", path.display()))
}

/// The target without what all have in common.
fn architecture(triple: &str) -> &str {
    triple.split('-').next().unwrap_or(triple)
}

#[cfg(test)]
mod tests {
    use super::{Folders, page, replaced, tables};

    #[test]
    fn the_page_has_the_figures_of_the_golden_files() {
        let folders = Folders::new();
        let old = std::fs::read_to_string(page(&folders)).unwrap();
        let new = replaced(&old, &tables(&folders).unwrap()).unwrap();
        assert!(old == new, "`cargo xtask bare-metal test --bless` writes the figures into docs/firmware.md");
    }
}
