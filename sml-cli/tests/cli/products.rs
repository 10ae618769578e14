//! `sml synth`, `verify`, `export` and `names`.

use crate::support::{corpus, realizable, scratch, sml, sml_reading};
use serde_json::{Value, json};

#[test]
fn what_synth_makes_verify_accepts() {
    let folder = scratch("what_synth_makes");
    for name in realizable() {
        for minimize in ["--minimize none", "--no-minimize", "--minimize exact", ""] {
            let path = folder.join("c.json");
            let run = sml(&format!("synth {name}/spec.sml {minimize} -o {}", path.display()));
            assert_eq!(run.code, 0, "{name}: {}", run.stderr);
            let run = sml(&format!("verify {name}/spec.sml {} --format json", path.display()));
            let expected = json!({ "version": 1, "verified": true, "reason": "", "play": [], "loop": [] });
            assert_eq!((run.code, run.json()), (0, expected), "{name} {minimize}");
        }
    }
}

#[test]
fn verify_refuses_with_a_play() {
    let controller = sml("synth memory/spec.sml").stdout;
    let mut broken: Value = serde_json::from_str(&controller).expect("JSON");
    broken["environment"]["clock -> control.tick()"] = json!([[1, 2]]);
    let path = scratch("verify_refuses").join("c.json");
    std::fs::write(&path, broken.to_string()).expect("a file");
    let run = sml(&format!("verify memory/spec.sml {} --format json", path.display()));
    let found = run.json();
    assert_eq!((run.code, &found["verified"]), (1, &json!(false)));
    let play = found["play"].as_array().expect("a play");
    assert_eq!(play.last(), Some(&json!("clock -> control.tick()")), "{found}");
    assert!(!found["reason"].as_str().expect("a reason").is_empty());
    let run = sml(&format!("verify memory/spec.sml {}", path.display()));
    assert_eq!(run.code, 1);
    assert!(run.stdout.starts_with("not verified: "), "{}", run.stdout);
}

#[test]
fn verify_finds_what_starves() {
    // Red for ever: green never comes again.
    let controller = json!({
        "version": 1, "states": 2, "initial": 0,
        "environment": { "clock -> control.tick()": [[1, 0]] },
        "supersteps": [[0, 1, ["control -> lamp.red()"]]],
        "components": { "lamp": { "control -> lamp.red()": 1 } },
    });
    let run = sml_reading("verify memory/spec.sml - --format json", controller.to_string().as_bytes());
    let found = run.json();
    assert_eq!((run.code, &found["verified"]), (1, &json!(false)));
    assert!(!found["loop"].as_array().expect("a loop").is_empty(), "{found}");
}

const BLANK_ARRIVED: &str = "feedBelt -> controller.blankArrived()";

/// Where `BLANK_ARRIVED` leads from the initial state.
fn first_due(controller: &Value) -> &Value {
    let rows = controller["environment"][BLANK_ARRIVED].as_array().expect("rows");
    let row = rows.iter().find(|row| row[0] == controller["initial"]);
    &row.expect("it is the first event")[1]
}

#[test]
fn verify_refuses_an_event_accepted_before_a_due_super_step() {
    let mut broken = sml("synth production_cell/spec.sml").json();
    let due = first_due(&broken).clone();
    let event = BLANK_ARRIVED;
    broken["environment"][event].as_array_mut().expect("rows").push(json!([due, 0]));
    let run = sml_reading("verify production_cell/spec.sml - --format json", broken.to_string().as_bytes());
    let found = run.json();
    assert_eq!((run.code, &found["verified"], &found["play"]), (1, &json!(false), &json!([event])));
}

#[test]
fn verify_shows_the_play_to_a_command_that_nobody_knows() {
    let mut broken = sml("synth production_cell/spec.sml").json();
    let due = first_due(&broken).clone();
    let steps = broken["supersteps"].as_array_mut().expect("rows");
    let step = steps.iter_mut().find(|step| step[0] == due).expect("it is due");
    step[2] = json!(["controller -> feedArm.dance()"]);
    broken["components"]["feedArm"]["controller -> feedArm.dance()"] = json!(5);
    for components in [broken["components"].clone(), json!({})] {
        broken["components"] = components;
        let run =
            sml_reading("verify production_cell/spec.sml - --format json", broken.to_string().as_bytes());
        let found = run.json();
        assert_eq!((run.code, &found["verified"]), (1, &json!(false)));
        assert_eq!(found["play"], json!([BLANK_ARRIVED]), "{found}");
    }
}

#[test]
fn a_controller_of_another_specification_is_refused() {
    let controller = sml("synth memory/spec.sml").stdout;
    assert_eq!(sml_reading("verify line_2/spec.sml -", controller.as_bytes()).code, 1);
}

#[test]
fn exact_is_the_default_and_no_larger_than_none() {
    for name in realizable() {
        let states =
            |options: &str| sml(&format!("synth {name}/spec.sml {options}")).json()["states"].as_u64();
        let exact = states("--minimize exact");
        assert_eq!(states(""), exact);
        assert_eq!(states("--no-minimize"), states("--minimize none"));
        assert!(exact <= states("--minimize none"), "{name}");
    }
}

#[test]
fn summary_for_people_on_stderr() {
    let run = sml("synth production_cell/spec.sml");
    assert!(run.stderr.contains("before minimisation"), "{}", run.stderr);
    assert_eq!(run.stdout.lines().count(), 1);
}

#[test]
fn every_target_writes_something_plausible() {
    for name in realizable() {
        for (target, part) in [
            ("rust", "pub mod "),
            ("iec", "END_FUNCTION_BLOCK"),
            ("codesys", "POINTER TO"),
            ("twincat", "POINTER TO"),
            ("siemens", "ORGANIZATION_BLOCK"),
            ("case", "END_CASE;"),
            ("plcopen", "</project>"),
            ("plcopen --dialect codesys", "<pointer>"),
            ("dot", "digraph "),
            ("mermaid", "stateDiagram-v2"),
            ("json", "\"supersteps\""),
        ] {
            let run = sml(&format!("export {name}/spec.sml --target {target}"));
            assert_eq!(run.code, 0, "{name}: {}", run.stderr);
            assert!(run.stdout.contains(part) && run.stdout.ends_with('\n'), "{name}, {target}");
        }
        assert_eq!(
            sml(&format!("export {name}/spec.sml --target json")).stdout,
            sml(&format!("synth {name}/spec.sml")).stdout
        );
    }
}

#[test]
fn options_of_structured_text_reach_it() {
    let plain = sml("export memory/spec.sml --target iec").stdout;
    let edge = "export memory/spec.sml --target iec --trigger edge --unexpected keep --integers unsigned";
    assert_eq!(sml(edge).stdout, plain);
    for (option, part) in [
        ("--trigger level", "trigger: level"),
        ("--unexpected drop", "unexpected: drop"),
        ("--unexpected fault", "unexpected: fault"),
        ("--integers signed", "integers: signed"),
        ("--drain", "(drain)"),
        ("--owed", "owed : Memory_Events;"),
        ("--retain", "VAR RETAIN"),
        ("--no-minimize", "--target iec --minimize none *)"),
        ("--classic", "--target iec --classic *)"),
    ] {
        let text = sml(&format!("export memory/spec.sml --target iec {option}")).stdout;
        assert!(text.contains(part) && !plain.contains(part), "{option}");
    }
}

#[test]
fn figures_of_an_output_are_its_own() {
    let folder = scratch("figures_of_an_output");
    for target in ["iec", "codesys", "twincat", "siemens", "case", "plcopen", "rust"] {
        let path = folder.join(target);
        let export = format!("export memory/spec.sml --target {target}");
        let figures = sml(&format!("{export} -o {} --format json", path.display())).json();
        let text = std::fs::read_to_string(&path).expect("it is written");
        assert_eq!(sml(&format!("{export} --format json")).stdout, text, "no figures beside the product");
        assert_eq!(figures["version"], 1);
        assert_eq!(figures["target"], target);
        assert_eq!(figures["bytes"], text.len());
        assert_eq!(figures["lines"], text.lines().count());
        let transitions = figures["transitions"].as_f64().expect("a number");
        let each = figures["bytes_per_transition"].as_f64().expect("a number");
        assert!(transitions > 0.0 && (each * transitions - text.len() as f64).abs() <= 0.051 * transitions);
        let line = format!(
            "{}: {} lines, {} bytes, {each:.1} bytes per transition\n",
            path.display(),
            figures["lines"],
            figures["bytes"]
        );
        assert_eq!(sml(&format!("{export} -o {}", path.display())).stderr, line);
        assert_eq!(sml(&format!("{export} -o {} --check", path.display())).stderr, "");
        if target == "rust" {
            assert!(figures["bounds"].is_null());
            continue;
        }
        for (mode, option) in [("cycle", ""), ("drain", "--drain")] {
            let bound = &figures["bounds"][mode];
            let expected = format!(
                "A call takes at most {} statements, {} loop iterations and {} probes",
                bound["statements"], bound["iterations"], bound["probes"]
            );
            let text = sml(&format!("{export} {option}")).stdout;
            assert!(text.contains(&expected), "{target} {option}: {expected}");
        }
    }
}

#[test]
fn names_cover_events_and_commands_whatever_the_verdict() {
    for (name, _) in corpus() {
        for target in ["iec", "codesys", "twincat", "siemens", "case", "plcopen", "rust"] {
            let run = sml(&format!("names {name}/spec.sml --target {target}"));
            let names = run.json();
            assert_eq!(
                (run.code, &names["version"], &names["target"]),
                (0, &json!(1), &json!(target)),
                "{name}"
            );
            for field in ["function_block", "program", "state"] {
                assert!(names[field].is_string(), "{name}: {field}");
            }
        }
    }
}

/// The document holds the Structured Text of its dialect, with the options and the names of that.
#[test]
fn plcopen_xml_has_a_dialect() {
    let plain = sml("export memory/spec.sml --target plcopen").stdout;
    assert_eq!(sml("export memory/spec.sml --target plcopen --dialect iec").stdout, plain);
    let pointers = sml("export memory/spec.sml --target plcopen --dialect codesys --drain").stdout;
    assert!(pointers.contains("<pointer>") && !plain.contains("<pointer>"));
    assert!(pointers.contains("--target plcopen --dialect codesys --drain\n"), "{pointers}");
    for (dialect, target) in [("", "iec"), ("--dialect iec", "iec"), ("--dialect codesys", "codesys")] {
        let mut names = sml(&format!("names memory/spec.sml --target plcopen {dialect}")).json();
        assert_eq!(names["target"], "plcopen");
        names["target"] = json!(target);
        assert_eq!(names, sml(&format!("names memory/spec.sml --target {target}")).json());
    }
}

#[test]
fn names_are_those_in_the_text() {
    for name in realizable() {
        let controller = sml(&format!("synth {name}/spec.sml")).json();
        for target in ["iec", "codesys", "twincat", "siemens", "case", "plcopen", "rust"] {
            let names = sml(&format!("names {name}/spec.sml --target {target}")).json();
            let text = sml(&format!("export {name}/spec.sml --target {target}")).stdout;
            let events = names["events"].as_array().expect("events");
            let texts: Vec<&str> = events.iter().filter_map(|event| event["event"].as_str()).collect();
            let known: Vec<&String> = controller["environment"].as_object().expect("rows").keys().collect();
            assert_eq!(texts, known, "{name}");
            for event in events {
                assert!(text.contains(event["input"].as_str().expect("a name")), "{name}: {event}");
            }
            for component in names["components"].as_array().expect("components") {
                assert!(text.contains(component["output"].as_str().expect("a name")), "{name}: {component}");
                let object = component["object"].as_str().expect("a name");
                assert_eq!(component["codes"], controller["components"][object], "{name}");
            }
        }
    }
}

#[test]
fn an_engine_of_rust_is_chosen() {
    let text = |engine: &str| sml(&format!("export memory/spec.sml --target rust --engine {engine}")).stdout;
    let (search, runs, comb) = (text("search"), text("runs"), text("comb"));
    assert!(search.contains("controller_template::Mappings<") && !search.contains("static COMB"));
    assert!(runs.contains(" --target rust --engine runs` again"), "{runs}");
    assert!(runs.contains("static RUNS: ") && comb.contains("static COMB: "));
    for (arguments, code) in [("--target rust --engine steam", 2), ("--target iec --engine comb", 2)] {
        assert_eq!(sml(&format!("export memory/spec.sml {arguments}")).code, code, "{arguments}");
    }
}

#[test]
fn what_synth_makes_early_verify_accepts() {
    let path = scratch("early").join("c.json");
    for name in realizable() {
        let run = sml(&format!("synth {name}/spec.sml --early -o {}", path.display()));
        assert_eq!(run.code, 0, "{name}: {}", run.stderr);
        assert!(run.stderr.contains(" of these explored"), "{name}: {}", run.stderr);
        assert_eq!(sml(&format!("verify {name}/spec.sml {}", path.display())).code, 0, "{name}");
    }
    assert_eq!(sml("synth unreal_clash/spec.sml --early").code, 1);
    assert_eq!(sml("synth memory/spec.sml --early --deny 97").code, 2);
}
