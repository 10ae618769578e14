//! Controllers that follow the events of plants: `--follow events`.

use crate::support::{plant, scratch, sml, sml_reading};
use serde_json::Value;
use std::fs;

fn export(name: &str, target: &str) -> String {
    let run = sml(&format!("export {} --follow events --target {target}", plant(name)));
    assert_eq!(run.code, 0, "{target}: {}", run.stderr);
    run.stdout
}

#[test]
fn every_target_of_tables_is_written() {
    for (target, part) in [
        ("rust", "pub struct Commands"),
        ("rust --engine search", "pub struct Commands"),
        ("iec", "END_FUNCTION_BLOCK"),
        ("iec --trigger level --drain", "END_FUNCTION_BLOCK"),
        ("codesys", "END_FUNCTION_BLOCK"),
        ("twincat --encoding rows", "END_FUNCTION_BLOCK"),
        ("siemens", "ORGANIZATION_BLOCK"),
        ("case", "CASE "),
        ("plcopen", "<ST>"),
        ("plcopen --dialect codesys", "<ST>"),
        ("dot", "digraph "),
        ("mermaid", "stateDiagram-v2"),
        ("json", "\"supersteps\""),
    ] {
        for name in ["distribution_station", "cat_and_mouse", "transfer_line"] {
            let text = export(name, target);
            assert!(text.contains(part), "{target}: {text}");
        }
    }
}

#[test]
fn texts_say_how_to_generate_them_again_and_what_constrains() {
    for target in ["rust", "iec", "case", "siemens"] {
        let text = export("distribution_station", target).replace(" *)\n(* ", " ");
        let command =
            format!("sml export {} --target {target} --follow events", plant("distribution_station"));
        assert!(text.contains(&command), "{command}");
        assert!(text.contains("ClearDock"), "{text}");
    }
    let text = export("tank", "rust --no-minimize");
    assert!(text.contains("--follow events --minimize none"), "{text}");
}

#[test]
fn races_are_warnings() {
    let arguments = format!("export {} --follow events --target json", plant("tank"));
    let run = sml(&arguments);
    assert!(run.code == 0 && run.stderr.contains("warning[SML0145]: `uncovered`, `covered`, `topped` in"));
    assert_eq!(sml(&format!("{arguments} --allow 145,149")).stderr, "");
    for denied in ["--deny SML0145", "--deny-warnings"] {
        let run = sml(&format!("{arguments} {denied}"));
        assert_eq!((run.code, run.stdout.as_str()), (1, ""), "{denied}");
        let run = sml(&format!("check {} --follow events {denied}", plant("tank")));
        assert_eq!(run.code, 1, "{denied}");
    }
    let found = sml(&format!("check {} --follow events --format json", plant("tank"))).json();
    assert_eq!(
        codes_and_lines(&found),
        [("SML0149", 11), ("SML0149", 13), ("SML0149", 14), ("SML0149", 15), ("SML0145", 17)]
    );
    assert_eq!((found["realizable"].as_bool(), found["entries"].as_u64()), (Some(true), Some(16)));
    let found = sml(&format!("check {} --format json", plant("tank"))).json();
    assert_eq!(codes_and_lines(&found), [("SML0148", 10), ("SML0148", 12), ("SML0148", 14)]);
}

fn codes_and_lines(report: &Value) -> Vec<(&str, u64)> {
    let all = report["diagnostics"].as_array().expect("diagnostics").iter();
    all.map(|one| (one["code"].as_str().expect("a code"), one["line"].as_u64().expect("a line"))).collect()
}

/// Names are those in the text, and there are some whether or not something keeps the constraints.
#[test]
fn names_are_those_in_the_text() {
    for target in ["rust", "iec", "siemens", "case"] {
        let names = sml(&format!("names {} --follow events --target {target}", plant("tank"))).json();
        let text = export("tank", target);
        for (list, member) in [("events", "input"), ("components", "output")] {
            let all = names[list].as_array().expect("names");
            assert!(all.len() >= 3, "{names}");
            for one in all {
                assert!(text.contains(one[member].as_str().expect("a name")), "{target}: {one}");
            }
        }
    }
    let refused = b"plant P { uncontrollable rise constraint Dry: never Tank.Over input X \
        automaton Tank { initial state Low [!X] { rise -> Over } state Over [X] } }";
    assert_eq!(sml_reading("export - --follow events --target json", refused).code, 1);
    for follow in ["events", "states"] {
        let run = sml_reading(&format!("names - --target iec --follow {follow}"), refused);
        assert!(run.code == 0 && run.json()["function_block"] == "P_Controller", "{}", run.stderr);
    }
}

#[test]
fn a_file_is_written_with_its_templates_and_checked() {
    let folder = scratch("a_plant_is_followed");
    let out = folder.join("tank.st");
    let arguments = format!(
        "export {} --follow events --target iec -o {} --templates {}",
        plant("tank"),
        out.display(),
        folder.join("parts").display()
    );
    assert_eq!(sml(&format!("{arguments} --check")).code, 1);
    let run = sml(&format!("{arguments} --format json"));
    assert!(
        run.code == 0 && run.json()["bounds"]["cycle"]["statements"].as_u64() > Some(0),
        "{}",
        run.stdout
    );
    assert!(folder.join("parts/Tank_InletValve.st").exists());
    assert_eq!(sml(&format!("{arguments} --check")).code, 0);
    let text = fs::read_to_string(&out).expect("it is written");
    fs::write(&out, text.replacen('t', "T", 1)).expect("a file");
    assert_eq!(sml(&format!("{arguments} --check")).code, 1);
}

#[test]
fn a_controller_runs_cycle_by_cycle() {
    let folder = scratch("a_plant_is_cycled");
    let csv = folder.join("stimulus.csv");
    fs::write(&csv, "Content -> controller.covered(),Content -> controller.topped()\n0,0\n1,1\n")
        .expect("a file");
    let run = sml(&format!("cycle {} --follow events --stimulus {}", plant("tank"), csv.display()));
    let rows: Vec<&str> = run.stdout.lines().collect();
    // The inlet is opened, and when the tank is full the outlet.
    assert_eq!(rows[0], "state,HeaterRelay,InletValve,OutletValve", "{}", run.stderr);
    assert_eq!(rows[1].split_once(',').map(|row| row.1), Some("0,2,0"));
    assert_eq!(rows[2].split_once(',').map(|row| row.1), Some("0,0,1"));
}

#[test]
fn what_makes_no_sense_is_2() {
    let tank = plant("tank");
    for arguments in [
        format!("export {tank} --follow events --target ladder"),
        format!("export {tank} --follow events --target il"),
        format!("export {tank} --follow events --target svg"),
        format!("export {tank} --follow events --target iec --share"),
        format!("export {tank} --follow events --target iec --dont-care all"),
        format!("export {tank} --follow events --target iec --modular"),
        format!("export {tank} --follow events --target dot --of loop"),
        format!("export {tank} --follow events --target dot --drain"),
        format!("export {tank} --follow events --target case --encoding rows"),
        format!("export {tank} --follow states --target case"),
        format!("names {tank} --follow events --target ladder"),
        format!("cycle {tank} --follow states --stimulus x.csv"),
        "export memory/spec.sml --target rust --follow events".to_owned(),
        "check memory/spec.sml --follow events".to_owned(),
        "names memory/spec.sml --target rust --follow events".to_owned(),
        "cycle memory/spec.sml --stimulus x.csv --follow events".to_owned(),
    ] {
        let run = sml(&format!("{arguments} --format json"));
        assert_eq!((run.code, run.diagnostic().as_str()), (2, "SML0100"), "{arguments}");
    }
}
