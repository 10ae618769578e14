//! `sml play --strategy` on unrealizable specifications: the environment is played so that it wins.

use crate::support::{Run, corpus, scratch, sml_reading};

#[track_caller]
fn play(name: &str, commands: &str) -> Run {
    let run = sml_reading(&format!("play {name}/spec.sml --strategy"), commands.as_bytes());
    assert!(run.stderr.contains("unrealizable: you play the system"), "{}", run.stderr);
    run
}

#[test]
fn silence_starves_a_guarantee() {
    let run = play("breaks_assumption", "ctl -> dev.go()\n");
    assert_eq!(run.code, 0, "{}", run.stderr);
    let over = "the play is over: you cannot meet C.Goes (breaks_assumption/spec.sml:14): \
                the environment stays silent for ever\n";
    assert!(run.stdout.ends_with(over), "{}", run.stdout);
}

#[test]
fn a_violation_names_scenario_and_line() {
    let run = play("forbidden_constraint", "ctl -> dev.go()\n");
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(run.stdout.contains("  violates C.Once (forbidden_constraint/spec.sml:15): forbidden here\n"));
    assert!(run.stdout.ends_with("the play is over: the environment has violated a guarantee\n"));
}

#[test]
fn a_super_step_without_end_is_announced() {
    let run = play("livelock", "1\n");
    let over =
        "the play is over: your super step never ends: this loop repeats for ever:\n  ctl -> dev.blink()\n";
    assert!(run.stdout.ends_with(over), "{}", run.stdout);
}

#[test]
fn a_loop_of_both_sides_is_announced() {
    let text = "specification Ticks {
      domain d { class Env { } class Ctl { ask() tick() } class Lamp { on() off() } }
      object env: Env  object ctl: Ctl  object lamp: Lamp
      controllable { Ctl }
      collaboration C {
        assumption scenario Clock { while { eventually env -> ctl.tick() } }
        guarantee scenario Wish { env -> ctl.ask() monitored eventually env -> ctl.ask() }
        guarantee scenario Blink { env -> ctl.tick() urgent ctl -> lamp.on() }
      }
    }";
    let folder = scratch("a_loop_of_both_sides");
    std::fs::write(folder.join("ticks.sml"), text).expect("a file");
    let run = sml_reading(&format!("play {}/ticks.sml --strategy", folder.display()), b"1\n1\n");
    assert!(run.stdout.contains("you cannot meet C.Wish"), "{}", run.stdout);
    let over = "this loop repeats for ever:\n  env -> ctl.tick()\n  ctl -> lamp.on()\n";
    assert!(run.stdout.ends_with(over), "{}", run.stdout);
}

#[test]
fn nothing_happens_behind_the_end() {
    let run = play("forbidden_constraint", "ctl -> dev.go()\nctl -> dev.go()\n");
    assert_eq!(run.code, 1);
    assert!(run.stderr.contains("the play is over"), "{}", run.stderr);
    // One step back, it goes on.
    let run = play("forbidden_constraint", "ctl -> dev.go()\nback\nctl -> dev.go()\n");
    assert_eq!(run.code, 0, "{}", run.stderr);
}

#[test]
fn scripts_hold_events_of_the_system_only() {
    let arguments = "play breaks_assumption/spec.sml --strategy --format json --script /dev/stdin";
    let run = sml_reading(arguments, b"ctl -> dev.go()\nexpect turn nobody\n");
    assert_eq!(run.code, 0, "{}", run.stdout);
    let lines: Vec<serde_json::Value> =
        run.stdout.lines().map(|line| serde_json::from_str(line).expect("an object a line")).collect();
    let events: Vec<&str> = lines.iter().filter_map(|line| line["event"].as_str()).collect();
    assert_eq!(events, ["user -> ctl.start()", "ctl -> dev.go()", "user -> ctl.start()", "silence"]);
    assert!(lines[3]["outcome"].as_str().is_some_and(|outcome| outcome.contains("C.Goes")));
    assert!(lines[..3].iter().all(|line| line.get("outcome").is_none()));
    assert_eq!(sml_reading(arguments, b"user -> ctl.start()\n").code, 1);
}

#[test]
fn whoever_always_takes_the_first_choice_loses() {
    for (name, expected) in corpus() {
        for (semantics, figures) in expected.as_object().expect("figures by semantics") {
            if figures["realizable"] == true {
                continue;
            }
            let classic = if semantics == "classic" { " --classic" } else { "" };
            let arguments = format!("play {name}/spec.sml --strategy{classic}");
            // More numbers than the play can need: the one behind its end is refused.
            let run = sml_reading(&arguments, "1\n".repeat(500).as_bytes());
            assert_eq!(run.code, 1, "{name}, {semantics}");
            assert!(run.stdout.contains("the play is over: "), "{name}, {semantics}: {}", run.stdout);
        }
    }
}
