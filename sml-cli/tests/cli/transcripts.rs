//! The transcripts of `docs/cli.md` are what the command prints.

use crate::support::{finish, scratch};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// A command and what is shown behind it.
struct Entry<'d> {
    command: &'d str,
    shown: Vec<&'d str>,
}

/// The `console` blocks of a page, each as a list of commands.
fn transcripts(page: &str) -> Vec<Vec<Entry<'_>>> {
    let mut all = Vec::new();
    let mut lines = page.lines();
    while lines.any(|line| line == "```console") {
        let mut entries: Vec<Entry<'_>> = Vec::new();
        for line in lines.by_ref().take_while(|&line| line != "```") {
            match (line.strip_prefix("$ "), entries.last_mut()) {
                (Some(command), _) => entries.push(Entry { command, shown: Vec::new() }),
                (None, Some(entry)) => entry.shown.push(line),
                (None, None) => {}
            }
        }
        all.push(entries);
    }
    all
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Runs `sml` in a folder, where the specifications of the project lie under `tests/specs`. At a terminal, stdout and
/// stderr may come in either order.
fn output(folder: &Path, arguments: &str) -> [String; 2] {
    let mut command = Command::new(env!("CARGO_BIN_EXE_sml"));
    command.args(arguments.split_whitespace()).current_dir(folder).stdin(Stdio::null());
    let run = finish(&mut command);
    [format!("{}{}", run.stdout, run.stderr), format!("{}{}", run.stderr, run.stdout)]
}

#[test]
fn of_the_page_about_the_command() {
    let page = std::fs::read_to_string(root().join("docs/cli.md")).expect("the page");
    let folder = scratch("transcripts");
    let specs = folder.join("tests/specs");
    for name in std::fs::read_dir(root().join("tests/specs")).expect("the corpus") {
        let from = name.expect("an entry").path();
        let to = specs.join(from.file_name().expect("a name"));
        std::fs::create_dir_all(&to).expect("a folder");
        if from.join("spec.sml").exists() {
            std::fs::copy(from.join("spec.sml"), to.join("spec.sml")).expect("a copy");
        }
    }
    let plants = folder.join("tests/plants");
    std::fs::create_dir_all(&plants).expect("a folder");
    for plant in std::fs::read_dir(root().join("tests/plants")).expect("the plants") {
        let from = plant.expect("an entry").path();
        std::fs::copy(&from, plants.join(from.file_name().expect("a name"))).expect("a copy");
    }
    let mut checked = 0;
    for entry in transcripts(&page).into_iter().flatten() {
        let shown = entry.shown.join("\n");
        if let Some(file) = entry.command.strip_prefix("cat ") {
            std::fs::write(folder.join(file), shown + "\n").expect("a file");
        } else if let Some(arguments) = entry.command.strip_prefix("sml ").filter(|_| !shown.is_empty()) {
            let found = output(&folder, arguments);
            match shown.strip_suffix("\n...") {
                Some(beginning) => assert!(found[0].starts_with(&format!("{beginning}\n")), "{found:?}"),
                None => assert!(found.iter().any(|one| one.trim_end() == shown), "{found:?}"),
            }
            checked += 1;
        }
    }
    assert!(checked >= 7, "{checked}");
}
