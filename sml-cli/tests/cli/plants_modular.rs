//! Supervisors of single constraints: `--modular`.

use crate::support::{plant, sml, sml_reading};
use serde_json::json;
use std::fmt::Write as _;

/// Drives that must not run up together with their neighbours: `4^count` states.
fn drives(count: usize, marked: &str) -> String {
    let mut text = String::from("plant Drives {\n");
    for i in 0..count {
        let _ = writeln!(
            text,
            "output Y{i} input X{i} controllable on{i} {{ set Y{i} }} controllable off{i} {{ reset Y{i} }} \
             uncontrollable up{i} uncontrollable down{i} automaton D{i} {{ initial {marked} state Off [!Y{i} && !X{i}] \
             {{ on{i} -> Rise }} state Rise [Y{i} && !X{i}] {{ up{i} -> On }} state On [Y{i} && X{i}] {{ off{i} -> Fall }} \
             state Fall [!Y{i} && X{i}] {{ down{i} -> Off }} }}"
        );
    }
    for i in 1..count {
        let _ = writeln!(text, "constraint C{i}: never D{}.Rise && D{i}.Rise", i - 1);
    }
    text + "}\n"
}

#[test]
fn modules_are_told_with_their_figures() {
    let text = drives(20, "");
    let run = sml_reading("supervise - --modular --format json", text.as_bytes());
    let found = run.json();
    assert_eq!((run.code, &found["conflict_free"], &found["rungs"]), (0, &json!(true), &json!(40)));
    let modules = found["modules"].as_array().expect("modules");
    assert_eq!(modules.len(), 19);
    assert_eq!(modules[3]["constraints"], json!(["C4"]));
    assert_eq!(modules[3]["components"], json!(["D3", "D4"]));
    assert_eq!(modules[3]["supervisor"]["entries"], 15);
    assert_eq!(found["formulas"]["off7"], "Y7 && X7");
    let run = sml_reading("supervise - --modular", text.as_bytes());
    assert!(run.stdout.starts_with("19 modules, which do not conflict\n"), "{}", run.stdout);
}

#[test]
fn programs_of_modules_are_written() {
    let text = drives(20, "");
    for target in ["ladder", "il", "iec", "codesys", "twincat", "siemens", "plcopen", "rust", "json"] {
        let run = sml_reading(&format!("export - --modular --target {target}"), text.as_bytes());
        assert!(run.code == 0 && run.stdout.contains("on19"), "{target}: {}", run.stderr);
        assert!(target == "json" || run.stdout.replace(" *)\n(* ", " ").contains("--modular"), "{target}");
    }
    for target in ["dot", "mermaid", "svg"] {
        assert_eq!(sml_reading(&format!("export - --modular --target {target}"), text.as_bytes()).code, 2);
    }
}

/// The product is beyond the limit, and the message names the way out.
#[test]
fn a_product_that_is_too_large_is_refused_with_advice() {
    let run = sml_reading("supervise - --max-states 1000", drives(20, "").as_bytes());
    assert!(run.code == 3 && run.stderr.contains("--modular"), "{}", run.stderr);
    let apart = drives(500, "").replace("constraint", "//");
    let run = sml_reading("check -", apart.as_bytes());
    assert!(run.code == 3 && run.stderr.contains("500 independent parts"), "{}", run.stderr);
    assert_eq!(sml_reading("export - --modular --target il", apart.as_bytes()).code, 0);
}

/// With marked states conflicts are possible, and the product of all modules is too large to look for them.
#[test]
fn what_is_not_known_is_a_warning() {
    let text = drives(20, "marked");
    let arguments = "supervise - --modular --max-states 1000";
    let run = sml_reading(arguments, text.as_bytes());
    assert!(run.code == 0 && run.stderr.contains("warning[SML0147]"), "{}", run.stderr);
    assert!(run.stdout.contains("whether they conflict is not known"), "{}", run.stdout);
    let json = sml_reading(&format!("{arguments} --format json"), text.as_bytes()).json();
    assert!(json["conflict_free"].is_null());
    assert_eq!(sml_reading(&format!("{arguments} --deny 147"), text.as_bytes()).code, 1);
}

#[test]
fn conflicts_and_refusals_are_1() {
    let tools = "plant Tools { controllable saw1 controllable drill1 controllable done1 controllable saw2 controllable drill2 \
        controllable done2 \
        automaton User1 { initial marked state Idle { saw1 -> A } state A { drill1 -> B } state B { done1 -> Idle } } \
        automaton User2 { initial marked state Idle { drill2 -> A } state A { saw2 -> B } state B { done2 -> Idle } } \
        constraint automaton Saw { initial marked state Free { saw1 -> Taken saw2 -> Taken } \
        state Taken { done1 -> Free done2 -> Free } } \
        constraint automaton Drill { initial marked state Free { drill1 -> Taken drill2 -> Taken } \
        state Taken { done1 -> Free done2 -> Free } } }";
    assert_eq!(sml_reading("supervise -", tools.as_bytes()).code, 0);
    let run = sml_reading("supervise - --modular", tools.as_bytes());
    assert!(run.code == 1 && run.stderr.contains("error[SML0146]: the modules conflict"), "{}", run.stderr);
    assert!(run.stderr.contains("User1.A, User2.A, Saw.Taken, Drill.Taken"), "{}", run.stderr);
    let wrong = tools.replace("controllable", "uncontrollable");
    assert_eq!(sml_reading("supervise - --modular", wrong.as_bytes()).code, 1);
}

/// What one module can do is done as without modules.
#[test]
fn a_plant_of_one_module_has_the_same_program() {
    for name in ["distribution_station", "chute"] {
        let whole = sml(&format!("supervise {} --format json", plant(name))).json();
        let run = sml(&format!("supervise {} --modular --format json", plant(name)));
        let found = run.json();
        if found["modules"].as_array().map(Vec::len) == Some(1) {
            assert_eq!(found["formulas"], whole["formulas"], "{name}");
        }
        assert!(found["rungs"].as_u64() >= whole["rungs"].as_u64(), "{}", run.stderr);
    }
    assert_eq!(sml(&format!("supervise {} --modular", plant("cat_and_mouse"))).code, 0);
    assert_eq!(sml(&format!("supervise {} --modular --share", plant("tank"))).code, 2);
}
