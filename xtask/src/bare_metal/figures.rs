//! The figures of the golden files as tables in `docs/firmware.md`.

use super::folders::Folders;
use super::programs;
use super::target;
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

/// One table of sizes and one of steps, of all golden files that are there.
fn tables(folders: &Folders) -> Result<String> {
    let mut sizes = String::from("| program | target | text | data | bss |\n|---|---|---|---|---|\n");
    let mut steps = String::from(
        "| controller | operation | target | code | min | mean | max |\n|---|---|---|---|---|---|---|\n",
    );
    let mut versions = Vec::new();
    for program in programs::ALL {
        for target in target::ALL.iter().filter(|target| program.is_for(target)) {
            let folder = folders.expected().join(target.triple);
            let path = folder.join(format!("{}.size", program.name));
            let text = fs::read_to_string(&path).doing(format_args!("read `{}`", path.display()))?;
            let (name, architecture) = (program.name, architecture(target.triple));
            versions.extend(text.lines().next().map(str::to_owned));
            let numbers: Vec<&str> =
                text.lines().skip(1).filter_map(|line| line.split_whitespace().nth(1)).collect();
            let _ = writeln!(sizes, "| `{name}` | {architecture} | {} |", numbers.join(" | "));
        }
    }
    for program in programs::ALL.iter().filter(|program| program.steps.is_some()) {
        for operation in 0.. {
            let mut any = false;
            for target in &target::ALL {
                let path = folders.expected().join(target.triple).join(format!("{}.steps", program.name));
                let text = fs::read_to_string(&path).doing(format_args!("read `{}`", path.display()))?;
                let Some(line) = text.lines().nth(operation + 1) else { continue };
                let words: Vec<&str> = line.split_whitespace().collect();
                let [operation, _, code, _, _, _, min, _, mean, _, max] = words[..] else { continue };
                let (name, architecture) = (program.name, architecture(target.triple));
                let _ = writeln!(
                    steps,
                    "| `{name}` | `{operation}` | {architecture} | {code} | {min} | {mean} | {max} |"
                );
                any = true;
            }
            if !any {
                break;
            }
        }
    }
    versions.sort();
    versions.dedup();
    Ok(format!("\nCompiled by {}.\n\n{steps}\n{sizes}\n", versions.join(" and ")))
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
