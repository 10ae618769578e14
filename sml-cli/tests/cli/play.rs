//! `sml play`.

use crate::support::{Run, scratch, sml, sml_reading};
use serde_json::{Value, json};

#[track_caller]
fn play(name: &str, options: &str, script: &str) -> Run {
    sml_reading(
        &format!("play {name}/spec.sml --format json --script /dev/stdin {options}"),
        script.as_bytes(),
    )
}

fn lines(run: &Run) -> Vec<Value> {
    run.stdout.lines().map(|line| serde_json::from_str(line).expect("an object a line")).collect()
}

#[test]
fn both_sides_by_script() {
    let run = play("memory", "", "# first\n\n control -> lamp.red()\nclock->control.tick()\n yield\n");
    assert_eq!(run.code, 0, "{}", run.stderr);
    let tick = "clock -> control.tick()";
    let choices = json!(["control -> lamp.green()", "control -> lamp.red()", "yield"]);
    assert_eq!(
        lines(&run),
        [
            json!({ "event": "control -> lamp.red()", "turn": "system", "violated": [], "enabled": [tick] }),
            json!({ "event": tick, "turn": "environment", "violated": [], "enabled": choices }),
            json!({ "event": "yield", "turn": "system", "violated": [], "enabled": [tick] }),
        ]
    );
}

#[test]
fn an_event_out_of_turn_is_1_and_says_what_is_enabled() {
    let run = play("memory", "", "control -> lamp.red()\ncontrol -> lamp.green()\n");
    assert_eq!(run.code, 1);
    let found = lines(&run);
    assert_eq!(found.len(), 2, "{}", run.stdout);
    let diagnostic = &found[1]["diagnostics"][0];
    assert_eq!(diagnostic["code"], "SML0106");
    assert!(diagnostic["notes"].to_string().contains("clock -> control.tick()"), "{diagnostic}");
    let text = sml_reading("play memory/spec.sml", b"nonsense\n");
    assert_eq!(text.code, 1);
    assert!(text.stderr.contains("control -> lamp.green()"), "{}", text.stderr);
}

#[test]
fn the_controller_answers() {
    let tick = "clock -> control.tick()";
    let run = play("memory", "--strategy", &format!("{tick}\n{tick}\n"));
    assert_eq!(run.code, 0, "{}", run.stderr);
    let found: Vec<Value> = lines(&run).iter().map(|line| json!([line["turn"], line["event"]])).collect();
    let expected = [
        json!(["system", "control -> lamp.red()"]),
        json!(["environment", tick]),
        json!(["system", "control -> lamp.green()"]),
        json!(["environment", tick]),
        json!(["system", "control -> lamp.red()"]),
    ];
    assert_eq!(found, expected);
    assert_eq!(play("memory", "--strategy", "yield\n").code, 1);
}

#[test]
fn what_the_controller_plays_is_a_script() {
    for name in crate::support::realizable() {
        let mut script = String::new();
        let mut last = play(&name, "--strategy", "");
        // Twelve events, always the last that is enabled.
        for _ in 0..12 {
            let all = lines(&last);
            let enabled = match all.last() {
                Some(line) => line["enabled"].clone(),
                None => json!([first_event(&name)]),
            };
            let Some(event) = enabled.as_array().and_then(|events| events.last()) else { break };
            script = format!("{script}{}\n", event.as_str().expect("a text"));
            last = play(&name, "--strategy", &script);
            assert_eq!(last.code, 0, "{name}: {}{}", last.stdout, last.stderr);
        }
        let by_hand: String = lines(&last)
            .iter()
            .map(|line| format!("{}\n", line["event"].as_str().expect("a text")))
            .collect();
        let again = play(&name, "", &by_hand);
        assert_eq!((again.code, again.stdout), (0, last.stdout), "{name}");
    }
}

/// An event of the environment that is enabled initially.
fn first_event(name: &str) -> String {
    let state = sml_reading(&format!("play {name}/spec.sml --format json"), b"state\n").json();
    state["enabled"][0].as_str().expect("an enabled event").to_owned()
}

#[test]
fn a_violation_ends_the_play() {
    let text = "specification Touchy {
      domain d { class Env { } class Ctl { a() b() } }
      object env: Env  object ctl: Ctl
      controllable { Ctl }
      collaboration C { guarantee scenario S { env -> ctl.a() strict env -> ctl.b() } }
    }";
    let path = scratch("a_violation_ends_the_play").join("touchy.sml");
    std::fs::write(&path, text).expect("a file");
    let arguments = format!("play {} --format json", path.display());
    let run = sml_reading(&arguments, b"env -> ctl.a()\nenv -> ctl.a()\n");
    assert_eq!(run.code, 0, "{}", run.stderr);
    let last = lines(&run).pop().expect("a line");
    assert_eq!((&last["violated"], &last["enabled"]), (&json!(["C.S"]), &json!([])));
    let run = sml_reading(&arguments, b"env -> ctl.a()\nenv -> ctl.a()\nenv -> ctl.b()\n");
    assert_eq!(run.code, 1);
    assert!(sml(&format!("check {}", path.display())).stdout.contains("not realizable"));
}
