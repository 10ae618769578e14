//! Running the command.

use serde_json::Value;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// What one run of the command gave.
pub(crate) struct Run {
    pub(crate) code: i32,
    pub(crate) stdout: String,
    pub(crate) stderr: String,
}

impl Run {
    /// The JSON document on stdout.
    #[track_caller]
    pub(crate) fn json(&self) -> Value {
        serde_json::from_str(&self.stdout).unwrap_or_else(|error| panic!("{error}: {}", self.stdout))
    }

    /// The code of the first diagnostic of a JSON failure.
    #[track_caller]
    pub(crate) fn diagnostic(&self) -> String {
        let document = self.json();
        assert_eq!(document["version"], 1);
        document["diagnostics"][0]["code"].as_str().expect("a diagnostic").to_owned()
    }
}

/// The command with these arguments, separated by spaces.
pub(crate) fn command(arguments: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_sml"));
    command.args(arguments.split_whitespace()).current_dir(specs()).env_remove("NO_COLOR");
    command
}

/// Runs the command in the folder of the corpus.
#[track_caller]
pub(crate) fn sml(arguments: &str) -> Run {
    finish(command(arguments).stdin(Stdio::null()))
}

/// Runs the command with something on stdin.
#[track_caller]
pub(crate) fn sml_reading(arguments: &str, stdin: &[u8]) -> Run {
    let mut command = command(arguments);
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().expect("the command runs");
    // A command that never reads closes the pipe.
    let _ = child.stdin.take().expect("a pipe").write_all(stdin);
    run(child.wait_with_output().expect("the command ends"))
}

#[track_caller]
pub(crate) fn finish(command: &mut Command) -> Run {
    run(command.output().expect("the command runs"))
}

#[track_caller]
fn run(output: std::process::Output) -> Run {
    let text = |bytes| String::from_utf8(bytes).expect("output is UTF-8");
    let run = Run {
        code: output.status.code().expect("no signal"),
        stdout: text(output.stdout),
        stderr: text(output.stderr),
    };
    assert!(!run.stderr.contains("panicked") && !run.stderr.contains("bug in sml"), "{}", run.stderr);
    run
}

/// The corpus.
pub(crate) fn specs() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/specs")
}

/// Folder and expected figures of every specification of the corpus.
pub(crate) fn corpus() -> Vec<(String, Value)> {
    let folders = std::fs::read_dir(specs()).expect("the corpus exists");
    let mut names: Vec<String> = folders
        .map(|entry| entry.expect("the corpus is readable"))
        .filter(|entry| entry.path().join("spec.sml").exists())
        .map(|entry| entry.file_name().into_string().expect("names are UTF-8"))
        .collect();
    names.sort();
    assert!(names.len() >= 9);
    let expected = |name: &String| {
        let text = std::fs::read_to_string(specs().join(name).join("expected.json")).expect("figures");
        serde_json::from_str(&text).expect("JSON")
    };
    names.iter().map(|name| (name.clone(), expected(name))).collect()
}

/// The realizable ones.
pub(crate) fn realizable() -> Vec<String> {
    let all = corpus().into_iter();
    all.filter(|(_, expected)| expected["default"]["realizable"] == true).map(|(name, _)| name).collect()
}

/// An empty folder for one test.
pub(crate) fn scratch(test: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(test);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).expect("a scratch folder");
    folder
}

/// The names of all files in a folder.
pub(crate) fn listing(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).expect("a folder");
    let mut names: Vec<String> =
        entries.map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

/// A plant of the corpus, as seen from the folder in which the command runs.
pub(crate) fn plant(name: &str) -> String {
    format!("../plants/{name}.plant")
}

/// Its text.
pub(crate) fn plant_text(name: &str) -> String {
    std::fs::read_to_string(specs().join(plant(name))).expect("a plant")
}

/// A file with so many switches that can be turned at any time, on its own folder.
pub(crate) fn switches(test: &str, count: usize) -> PathBuf {
    let objects: String = (1..=count).map(|n| format!("  object switch{n}: Switch\n")).collect();
    let text = format!(
        "specification Switches {{
  domain d {{ class Control {{ turned() }} class Switch {{ on: bool  confirm() }} }}
  object control: Control
{objects}  controllable {{ Control }}
  effects {{ Switch -> Control.turned() {{ sender.on = !sender.on }} }}
  collaboration C {{
    dynamic role Switch switch
    guarantee scenario G {{ switch -> control.turned() urgent control -> switch.confirm() }}
  }}
}}"
    );
    let file = scratch(test).join("switches.sml");
    std::fs::write(&file, text).expect("a file");
    file
}
