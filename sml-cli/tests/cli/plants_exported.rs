//! `sml export` and `sml names` of plants.

use crate::support::{listing, plant, plant_text, scratch, sml, sml_reading};
use serde_json::Value;
use std::fs;

/// Targets, and a part of each text for the distribution station.
const TARGETS: [(&str, &str); 15] = [
    ("ladder", "|----|/|----"),
    ("il", "STR    NOT "),
    ("iec", "END_FUNCTION_BLOCK"),
    ("codesys", "END_FUNCTION_BLOCK"),
    ("twincat", "END_FUNCTION_BLOCK"),
    ("siemens", "ORGANIZATION_BLOCK"),
    ("plcopen", "<LD>"),
    ("plcopen --dialect codesys", "<LD>"),
    ("rust", "pub fn scan("),
    ("dot", "digraph "),
    ("mermaid", "stateDiagram-v2"),
    ("svg", "<svg "),
    ("svg --of loop", "closed loop"),
    ("svg --of ladder", "Rung 3: right"),
    ("json", "\"formulas\""),
];

fn export(target: &str) -> String {
    let run = sml(&format!("export {} --target {target}", plant("distribution_station")));
    assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{target}");
    run.stdout
}

#[test]
fn every_target_writes_something_plausible() {
    for (target, part) in TARGETS {
        let text = export(target);
        assert!(text.contains(part) && text.ends_with('\n'), "{target}: {text}");
    }
    assert_eq!(
        export("json"),
        sml(&format!("supervise {} --format json", plant("distribution_station"))).stdout
    );
    assert!(!export("svg").contains("closed loop"));
}

#[test]
fn texts_say_how_to_generate_them_again() {
    for target in
        ["ladder", "il", "iec", "siemens", "plcopen", "plcopen --dialect codesys", "rust", "svg --of ladder"]
    {
        for options in ["", " --dont-care all --two-level", " --dont-care decodable --share --extract"] {
            let command = format!("sml export {} --target {target}{options}", plant("distribution_station"));
            // Lines are not too long.
            let text = export(&format!("{target}{options}")).replace(" *)\n(* ", " ");
            assert!(text.contains(&command), "{command}");
        }
        assert!(!export(&format!("{target} --dont-care none")).contains("--dont-care"));
    }
}

/// The instruction list has as many instructions as are told of it.
#[test]
fn instructions_are_counted() {
    for (name, options) in
        [("distribution_station", ""), ("distribution_station", "--two-level"), ("chute", "")]
    {
        let found = sml(&format!("supervise {} --format json {options}", plant(name))).json();
        let text = sml(&format!("export {} --target il {options}", plant(name))).stdout;
        let is_instruction = |line: &&str| !line.is_empty() && !line.starts_with("(*");
        assert_eq!(text.lines().filter(is_instruction).count() as u64, found["instructions"], "{name}");
        let says = format!("{} rungs; at most {} on the stack", found["rungs"], found["stack_depth"]);
        assert!(text.contains(&says), "{text}");
    }
}

#[test]
fn a_file_is_checked_against_what_would_be_written() {
    let folder = scratch("a_plant_is_exported");
    let path = folder.join("out");
    for (target, _) in TARGETS {
        let arguments =
            format!("export {} --target {target} -o {}", plant("distribution_station"), path.display());
        let run = sml(&format!("{arguments} --check --format json"));
        assert_eq!((run.code, run.diagnostic().as_str()), (1, "SML0107"), "{target}");
        let run = sml(&format!("{arguments} --format json"));
        let figures = run.json();
        let text = fs::read_to_string(&path).expect("it is written");
        assert_eq!((run.code, &text), (0, &export(target)), "{target}");
        assert_eq!(
            (figures["lines"].as_u64(), figures["bytes"].as_u64()),
            (Some(text.lines().count() as u64), Some(text.len() as u64))
        );
        let is_diagram = ["dot", "mermaid", "svg", "svg --of loop"].contains(&target);
        assert_eq!(figures["instructions"].is_null(), is_diagram, "{target}");
        assert_eq!(sml(&format!("{arguments} --check")).code, 0, "{target}");
        fs::write(&path, text.replacen('t', "T", 1)).expect("a file");
        assert_eq!(sml(&format!("{arguments} --check")).code, 1, "{target}");
        assert_eq!(listing(&folder), ["out"]);
        fs::remove_file(&path).expect("it is there");
    }
}

#[test]
fn names_are_those_in_the_text() {
    for name in ["distribution_station", "chute"] {
        for target in ["rust", "iec", "codesys", "twincat", "siemens", "plcopen", "il"] {
            let names = sml(&format!("names {} --target {target}", plant(name))).json();
            let text = sml(&format!("export {} --target {target}", plant(name))).stdout;
            assert_eq!((&names["version"], names["target"].as_str()), (&1.into(), Some(target)));
            let identifiers = |member: &str| -> Vec<String> {
                let all = names[member].as_array().expect("names").iter();
                all.filter_map(|one| one["identifier"].as_str()).map(str::to_owned).collect()
            };
            let signals = identifiers("signals");
            assert!(signals.len() >= 6, "{names}");
            for identifier in signals.iter().chain(&identifiers("events")) {
                assert!(text.contains(identifier.as_str()), "{name}, {target}: {identifier}");
            }
            assert_eq!(names["events"].as_array().map(Vec::is_empty), Some(target != "rust"), "{names}");
            let units = ["function_block", "program"].map(|unit| names[unit].as_str().expect("a name"));
            assert!(units.iter().all(|unit| target == "rust" || text.contains(unit)), "{units:?}");
        }
    }
}

#[test]
fn a_closed_loop_that_is_too_large_is_not_drawn() {
    let text = plant_text("transfer_line");
    let run = sml_reading("export - --target dot --of loop", text.as_bytes());
    assert!(run.code == 0 && run.stdout.contains("closed loop"), "{}", run.stderr);
    let more = text.replacen('{', "{ uncontrollable x uncontrollable y automaton More { initial state A { x -> B } state B { y -> A } }", 1);
    let run = sml_reading("export - --target dot --of loop --format json", more.as_bytes());
    assert_eq!((run.code, run.diagnostic().as_str()), (2, "SML0108"), "{}", run.stdout);
    assert!(
        run.json()["diagnostics"][0]["message"]
            .as_str()
            .is_some_and(|text: &str| text.contains("100 entries"))
    );
    let whole: Value = sml_reading("export - --target json", more.as_bytes()).json();
    assert_eq!(whole["entries"], 100);
}
