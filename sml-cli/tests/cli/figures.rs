//! `sml check`.

use crate::support::{corpus, sml, sml_reading};
use serde_json::Value;

#[test]
fn every_figure_of_the_corpus() {
    for (name, expected) in corpus() {
        for (semantics, figures) in expected.as_object().expect("figures by semantics") {
            let classic = if semantics == "classic" { "--classic" } else { "" };
            let run = sml(&format!("check {name}/spec.sml --format json {classic}"));
            let found = run.json();
            for (figure, value) in figures.as_object().expect("figures") {
                assert_eq!(&found[figure], value, "{name}, {semantics}: {figure}");
            }
            let realizable = figures["realizable"] == true;
            assert_eq!(run.code, i32::from(!realizable), "{name}, {semantics}");
            assert_eq!(found.get("explanation").is_some(), !realizable, "{name}, {semantics}");
            assert!(found["existential"].is_array() && found["diagnostics"].is_array());
            assert_eq!(found["version"], 1);
        }
    }
}

#[test]
fn explanations_have_a_cause_and_a_play() {
    for (name, expected) in corpus() {
        if expected["default"]["realizable"] == true {
            continue;
        }
        let explanation = &sml(&format!("check {name}/spec.sml --format json")).json()["explanation"];
        let causes = ["environment_violates", "urgent_blocked", "guarantees_conflict", "obligation_starved"]
            .map(Value::from);
        assert!(causes.contains(&explanation["cause"]), "{name}: {explanation}");
        for list in ["scenarios", "involved", "play", "loop"] {
            assert!(explanation[list].is_array(), "{name}: {explanation}");
        }
        assert_eq!(explanation["minimal"], true, "{name}: {explanation}");
    }
}

#[test]
fn text_for_people() {
    let run = sml("check memory/spec.sml");
    assert_eq!(run.code, 0);
    assert!(run.stdout.starts_with("Memory: realizable\n"), "{}", run.stdout);
    assert!(run.stdout.contains("states                      4\n"), "{}", run.stdout);
    let run = sml("check unreal_clash/spec.sml");
    assert_eq!(run.code, 1);
    assert!(run.stdout.contains(": not realizable\n"), "{}", run.stdout);
}

#[test]
fn from_stdin() {
    let text = std::fs::read(crate::support::specs().join("memory/spec.sml")).expect("the corpus");
    let run = sml_reading("check - --format json", &text);
    assert_eq!((run.code, &run.json()["states"]), (0, &Value::from(4)));
    let run = sml_reading("check -", b"specification");
    assert!(run.stderr.contains("<stdin>:1:"), "{}", run.stderr);
}

#[test]
fn imports_of_stdin_are_relative_to_the_working_directory() {
    let run = sml_reading("check -", b"import \"memory/spec.sml\" specification Whole { }");
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(run.stdout.starts_with("Whole: realizable"), "{}", run.stdout);
}

#[test]
fn timings_name_the_stages() {
    let run = sml("synth memory/spec.sml --timings");
    for stage in ["parse", "explore", "solve", "minimise", "verify", "write", "total"] {
        assert!(run.stderr.lines().any(|line| line.starts_with(stage)), "{stage}: {}", run.stderr);
    }
    let last = run.stderr.lines().last().unwrap_or_default();
    let bytes = last.strip_prefix("4 states, 6 transitions: ").unwrap_or_else(|| panic!("{}", run.stderr));
    let (of_states, of_transitions) = bytes.split_once(" bytes for a state, ").expect("two numbers");
    let number = |text: &str| text.split(' ').next().and_then(|number| number.parse::<f64>().ok());
    assert!(number(of_states) > Some(0.0) && number(of_transitions) >= Some(8.0), "{last}");
}

#[test]
fn timings_for_programs() {
    let run = sml("synth memory/spec.sml --timings --format json");
    let timings: Value = serde_json::from_str(run.stderr.lines().last().unwrap_or_default()).expect("a line");
    let stages = timings["timings"].as_array().expect("stages");
    let named = |name: &str| stages.iter().find(|stage| stage["stage"] == name).expect("a stage");
    assert_eq!(timings["version"], 1);
    let total: f64 = stages.iter().filter_map(|stage| stage["milliseconds"].as_f64()).sum();
    assert!((total - timings["milliseconds"].as_f64().unwrap_or_default()).abs() < 1e-3, "{timings}");
    let explore = named("explore");
    assert_eq!((&explore["states"], &explore["transitions"]), (&4.into(), &6.into()));
    assert!(
        explore["bytes_of_states"].as_u64() > Some(0) && explore["bytes_of_transitions"].as_u64() >= Some(48)
    );
    // Two rows for events and two super steps.
    assert_eq!((&named("minimise")["states"], &named("minimise")["transitions"]), (&4.into(), &4.into()));
    assert_eq!(named("parse").get("states"), None);
    // Nothing is said of what nobody counts.
    assert!(named("verify")["states"].as_u64() > Some(0) && named("verify").get("transitions").is_none());
    assert_eq!(named("parse")["peak_bytes"].is_u64(), cfg!(target_os = "linux"));
}

#[test]
fn colors_on_demand() {
    let escapes = |arguments: &str| sml(arguments).stderr.contains('\u{1b}');
    assert!(escapes("check no_such.sml --color always"));
    assert!(!escapes("check no_such.sml --color never"));
    assert!(!escapes("check no_such.sml"));
}

#[test]
fn existential_scenarios_have_a_witness() {
    let text = std::fs::read_to_string(crate::support::specs().join("memory/spec.sml")).expect("the corpus");
    let scenarios = "existential scenario Blink { control -> lamp.red() control -> lamp.green() }
      existential scenario Twice { control -> lamp.red() control -> lamp.red() } constraints [ interrupt control -> lamp.green() ]
    guarantee scenario OneAtATick";
    let text = text.replace("guarantee scenario OneAtATick", scenarios);
    let run = sml_reading("check - --format json", text.as_bytes());
    let found = run.json();
    assert_eq!(run.code, 0, "{}", run.stderr);
    let (blink, twice) = (&found["existential"][0], &found["existential"][1]);
    assert_eq!((&blink["scenario"], &blink["reachable"]), (&"Memory.Blink".into(), &true.into()), "{found}");
    let witness = ["control -> lamp.red()", "clock -> control.tick()", "control -> lamp.green()"];
    assert_eq!(blink["witness"], Value::from(witness.to_vec()));
    assert_eq!((&twice["reachable"], &twice["possible"]), (&false.into(), &true.into()), "{found}");
    assert_eq!(found["states"], 4);
    assert!(sml_reading("check -", text.as_bytes()).stdout.contains("`Memory.Blink` happens"));
}

#[test]
fn the_verdict_alone() {
    for (name, expected) in corpus() {
        for (semantics, figures) in expected.as_object().expect("figures by semantics") {
            let classic = if semantics == "classic" { "--classic" } else { "" };
            let run = sml(&format!("check {name}/spec.sml --verdict --format json {classic}"));
            let found = run.json();
            assert_eq!(found["realizable"], figures["realizable"], "{name}, {semantics}");
            let realizable = figures["realizable"] == true;
            assert_eq!(run.code, i32::from(!realizable), "{name}, {semantics}");
            assert_eq!(found.get("explanation").is_some(), !realizable, "{name}, {semantics}");
            let of = |count: &Value| count.as_u64().expect("a number");
            let [explored, all] = [&found["explored_states"], &found["found_states"]].map(of);
            assert!(explored <= all && all <= of(&figures["states"]), "{name}, {semantics}");
            assert_eq!(found["complete"], explored == all, "{name}, {semantics}");
        }
    }
}

#[test]
fn the_verdict_alone_for_people() {
    let run = sml("check memory/spec.sml --verdict");
    assert_eq!((run.code, &*run.stdout), (0, "Memory: realizable; all 4 states were explored\n"));
    let run = sml("check unreal_clash/spec.sml --verdict");
    assert_eq!(run.code, 1);
    assert!(run.stdout.contains("the environment can force this play:\n"), "{}", run.stdout);
    let run = sml("check line_2/spec.sml --verdict --max-states 100");
    assert!(run.code == 3 && run.stderr.contains("--max-states"), "{}", run.stderr);
}

#[test]
fn the_verdict_alone_has_nothing_to_warn_of() {
    for option in ["--deny 99", "--deny-warnings", "--allow 99", "--sequence -"] {
        assert_eq!(sml(&format!("check memory/spec.sml --verdict {option}")).code, 2, "{option}");
    }
    let run = sml("check ../plants/tank.plant --verdict --format json");
    assert_eq!((run.code, &*run.diagnostic()), (2, "SML0100"));
}

#[test]
fn figures_up_to_symmetry_are_those_of_the_whole_game() {
    for (name, expected) in corpus() {
        for (semantics, figures) in expected.as_object().expect("figures by semantics") {
            let classic = if semantics == "classic" { "--classic" } else { "" };
            let run = sml(&format!("check {name}/spec.sml --symmetry --format json {classic}"));
            let found = run.json();
            for (figure, value) in figures.as_object().expect("figures") {
                assert_eq!(&found[figure], value, "{name}, {semantics}: {figure}");
            }
            assert_eq!(run.code, i32::from(figures["realizable"] != true), "{name}, {semantics}");
        }
    }
}

#[test]
fn what_symmetry_says_to_people() {
    let run = sml("check arbiter_2/spec.sml --symmetry");
    let explored = "2 objects are interchangeable: `client1`, `client2`\n7 states";
    assert!(run.code == 0 && run.stdout.contains(explored), "{}", run.stdout);
    let run = sml("check unreal_clash/spec.sml --symmetry");
    let alone = "no objects are interchangeable: all states were explored\n\
                 `sml check` without `--symmetry` says why\n";
    assert!(run.code == 1 && run.stdout.ends_with(alone), "{}", run.stdout);
    let run = sml("check arbiter_2/spec.sml --symmetry --max-states 5");
    assert!(run.code == 3 && run.stderr.contains("--max-states"), "{}", run.stderr);
    let run = sml("check arbiter_2/spec.sml --symmetry --timings");
    assert!(
        ["symmetry", "explore", "solve"].iter().all(|stage| run.stderr.contains(stage)),
        "{}",
        run.stderr
    );
}

#[test]
fn symmetry_has_nothing_to_warn_of() {
    for option in ["--deny 99", "--deny-warnings", "--allow 99", "--sequence -", "--verdict", "--spill x"] {
        assert_eq!(sml(&format!("check arbiter_2/spec.sml --symmetry {option}")).code, 2, "{option}");
    }
    let run = sml("check ../plants/tank.plant --symmetry --format json");
    assert_eq!((run.code, &*run.diagnostic()), (2, "SML0100"));
}
