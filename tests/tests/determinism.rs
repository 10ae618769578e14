//! The same specification gives the same bytes: again in the same process, in another one, and from the macro's
//! tokens instead of a file's text.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;

use proc_macro2::{Span, TokenStream};
use sml_tests::{corpus, fast};
use synth_core::controller::json::to_json;
use synth_core::controller::tables::{Provenance, Tables};
use synth_core::diagnostic;
use synth_core::embed::{self, Choices, Expander};
use synth_core::emit::{dot, mermaid, rust, st};
use synth_core::pipeline::{Failure, Options, Timings, compile, specification, synthesize};
use synth_core::syntax::{FileId, load_imports, parse_tokens};

/// All outputs of a specification by name; those of an unrealizable one are its diagnostics and its game.
fn outputs(text: &str) -> BTreeMap<&'static str, String> {
    let loaded = fast::loaded(text);
    let options = Options::default();
    let mut outputs = BTreeMap::new();
    match compile(&loaded, &options, &mut Timings::default()) {
        Ok(tables) => {
            outputs.insert("rust", rust::text(&tables, &rust::Options::default()));
            outputs.insert("module", rust::module(&tables, &rust::Options::default()).to_string());
            outputs.insert("st", st::text(&tables, &st::Options::default()).expect("it fits"));
            outputs.insert("names", format!("{:?}", st::names(&tables, &st::Options::default())));
            outputs.insert("dot", dot::text(&tables));
            outputs.insert("mermaid", mermaid::text(&tables));
        }
        Err(failure) => {
            let shown = diagnostic::render(&failure.diagnostics(), &loaded.sources, false);
            outputs.insert("diagnostics", shown);
        }
    }
    let spec = specification(&loaded).expect("the corpus is well-formed");
    let mut solved = fast::solved(&spec, &options).expect("the corpus is small");
    let mut graph = Vec::new();
    synth_core::explore::write_json(&solved.explored, &mut graph).expect("memory takes all");
    outputs.insert("graph", String::from_utf8(graph).expect("JSON is text"));
    outputs.insert("figures", format!("{:?}", solved.figures()));
    if let Ok(verified) = synthesize(&mut solved, &options, &mut Timings::default()) {
        outputs.insert("json", to_json(&verified.controller));
    }
    outputs
}

/// Outputs of the whole corpus as one text.
fn of_the_corpus() -> String {
    let mut all = String::new();
    for entry in corpus::all() {
        for (output, text) in outputs(&entry.text) {
            let _ = writeln!(all, "==== {} {output}\n{text}", entry.name);
        }
    }
    all
}

/// Two texts of megabytes, told apart by their first line that differs.
#[track_caller]
fn assert_same(one: &str, other: &str) {
    let differing = one.lines().zip(other.lines()).position(|(one, other)| one != other);
    if let Some(line) = differing {
        panic!("line {line}: {:?} and {:?}", one.lines().nth(line), other.lines().nth(line));
    }
    assert_eq!(one.len(), other.len());
}

/// Where a process started by [`in_one_process_and_in_another`] leaves its outputs.
const LEAVE: &str = "SML_TESTS_LEAVE_OUTPUTS";

#[test]
fn in_one_process_and_in_another() {
    let all = of_the_corpus();
    for output in ["rust", "st", "dot", "mermaid", "json", "graph", "diagnostics"] {
        assert!(all.contains(&format!(" {output}\n")), "no {output}");
    }
    if let Some(path) = std::env::var_os(LEAVE) {
        return std::fs::write(path, all).expect("the file can be written");
    }
    assert_same(&all, &of_the_corpus());
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("outputs-of-another-process.txt");
    let process = std::env::current_exe().expect("this test is a program");
    let status = Command::new(process)
        .args(["--exact", "in_one_process_and_in_another"])
        .env(LEAVE, &path)
        .status()
        .expect("it starts");
    assert!(status.success());
    assert_same(&all, &std::fs::read_to_string(&path).expect("it left a text"));
}

fn from_tokens(tokens: &TokenStream) -> Result<Tables, Failure> {
    let (file, diagnostics) = parse_tokens(tokens.clone(), FileId(0));
    assert_eq!(diagnostics, []);
    let file = file.expect("the corpus is well-formed");
    let loaded = load_imports("sml!", file, &mut |path| Err(format!("{path}: the corpus imports nothing")));
    compile(&loaded, &Options::default(), &mut Timings::default())
}

/// The module of a macro in place does not say in which lines requirements stand.
fn without_lines(module: &str) -> String {
    let mut parts = module.split(", line ");
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |text, part| text + part.trim_start_matches(|digit: char| digit.is_ascii_digit()))
}

#[test]
fn from_tokens_and_from_a_file() {
    let mut compared = 0;
    for entry in corpus::all() {
        let tokens: TokenStream = entry.text.parse().expect("specifications are tokens of Rust");
        let from_file = compile(&fast::loaded(&entry.text), &Options::default(), &mut Timings::default());
        let (Ok(file), Ok(inline)) = (from_file, from_tokens(&tokens)) else { continue };
        assert_eq!(inline.provenance.file, "sml!");
        assert_eq!(file.provenance.file, "spec.sml");
        // Requirements with their lines included.
        let mut requirements = inline.provenance.requirements.clone();
        requirements.iter_mut().for_each(|requirement| requirement.file.replace_range(.., "spec.sml"));
        let provenance = Provenance { requirements, ..file.provenance.clone() };
        assert_eq!(Tables { provenance, ..inline }, file, "{}", entry.name);

        let mut read = |path: &str| Err(format!("{path}: the corpus imports nothing"));
        let inline =
            embed::inline(&tokens, Choices::default(), Expander::Compiler, None, &mut read).to_string();
        let bytes = entry.text.as_bytes();
        let file = embed::file(
            "spec.sml",
            bytes,
            Span::call_site(),
            Choices::default(),
            Expander::Compiler,
            None,
            &mut read,
        )
        .to_string();
        assert_eq!(inline, without_lines(&file), "{}", entry.name);
        compared += 1;
    }
    assert!(compared > 20, "only {compared}");
}
