//! `sml play` of plants.

use crate::support::{Run, plant, scratch, sml, sml_reading};
use serde_json::{Value, json};
use std::fs;

fn talk(lines: &str, options: &str) -> Run {
    sml_reading(&format!("play {} {options}", plant("distribution_station")), lines.as_bytes())
}

fn script(test: &str, lines: &str, options: &str) -> Run {
    let path = scratch(test).join("station.play");
    fs::write(&path, lines).expect("a file");
    sml(&format!("play {} --script {} {options}", plant("distribution_station"), path.display()))
}

fn documents(run: &Run) -> Vec<Value> {
    run.stdout.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect()
}

#[test]
fn a_state_shows_what_is_enabled_and_inhibited() {
    let run = talk("filled\n", "");
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    for part in [
        "Injector.I2B Barrel.BE Boom.B2D Hook.HF\n   1  filled  by itself\n",
        "   -  right   inhibited: `RoomToSwing` forbids it\n",
        "environment: filled\nInjector.I2B Barrel.BF Boom.B2D Hook.HF\n   1  right    enabled\n",
    ] {
        assert!(run.stdout.contains(part), "{}", run.stdout);
    }
}

#[test]
fn why_an_event_is_inhibited() {
    let run = talk("why right\nwhy left\nwhy filled\nwhy grabbed\n", "");
    for part in [
        "`right` is inhibited: `RoomToSwing` forbids it\n",
        "`left` is on no edge of `Boom.B2D`\n",
        "`filled` can happen by itself\n",
        "`grabbed` is on no edge of `Hook.HF`\n",
    ] {
        assert!(run.stdout.contains(part), "{}", run.stdout);
    }
    let found = documents(&talk("why right\n", "--format json"));
    let why = "`right` is inhibited: `RoomToSwing` forbids it";
    assert_eq!(found, [json!({ "event": "right", "can_happen": false, "inhibited": true, "why": why })]);
}

/// What a constraint asks for only later is a reason, too.
#[test]
fn why_something_is_inhibited_because_of_what_follows() {
    let run = sml_reading(&format!("play {}", plant("philosophers")), b"left1\nleft2\nwhy left3\n");
    assert!(run.stdout.contains("`left3` is inhibited: no marked state of `Philosopher"), "{}", run.stdout);
}

#[test]
fn events_as_json() {
    let run =
        script("events_as_json", "filled\n# to the testing station\nright\nwhy left\n", "--format json");
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    let found = documents(&run);
    assert_eq!(
        found[0],
        json!({ "event": "filled", "turn": "environment", "violated": [], "enabled": ["right", "emptied"], "inhibited": ["inject", "grab"] })
    );
    assert_eq!((&found[1]["event"], &found[1]["turn"]), (&json!("right"), &json!("system")));
    assert_eq!((&found[2]["event"], &found[2]["can_happen"]), (&json!("left"), &json!(false)));
    assert_eq!(found.len(), 3);
}

#[test]
fn the_state_as_json() {
    let found = documents(&talk("filled\nstate\n", "--format json"));
    assert_eq!(found[1]["state"]["Barrel"], "BF");
    assert_eq!(found[1]["enabled"], json!(["right", "emptied"]));
    assert_eq!(found[1]["inhibited"][0]["event"], "inject");
}

#[test]
fn expectations_that_hold() {
    let run = script(
        "expectations_of_plants",
        "expect only filled
         expect state Injector.I2B; Barrel.BE
         expect not state Barrel.BF
         expect inhibited inject; right; grab
         expect not inhibited left; filled
         filled
         expect enabled right
         expect not enabled inject; left
         expect not only right\n",
        "",
    );
    assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{}", run.stdout);
}

#[test]
fn expectations_that_do_not_hold() {
    for (line, found) in [
        ("expect enabled right", "can happen: filled"),
        ("expect not only filled", "can happen: filled"),
        ("expect inhibited left", "inhibited: inject, right, grab"),
        ("expect not inhibited left; right", "inhibited: inject, right, grab"),
        ("expect state Boom.B2T", "the state: Injector.I2B, Barrel.BE, Boom.B2D, Hook.HF"),
    ] {
        let run = script("expectations_that_do_not_hold", &format!("{line}\nfilled\n"), "");
        assert_eq!(run.code, 1, "{line}");
        assert!(run.stdout.contains("environment: filled"), "the play goes on: {}", run.stdout);
        for part in ["error[SML0109]", "station.play:1:1", found] {
            assert!(run.stderr.contains(part), "{line}: {}", run.stderr);
        }
        assert_eq!(talk(&format!("{line}\n"), "--format json").diagnostic_at_the_end(), "SML0109");
    }
}

impl Run {
    /// The code of the diagnostic in the last line.
    fn diagnostic_at_the_end(&self) -> String {
        let last = documents(self).pop().expect("a line");
        last["diagnostics"][0]["code"].as_str().expect("a code").to_owned()
    }
}

#[test]
fn an_event_that_cannot_happen_ends_a_script() {
    let run = script("an_event_of_a_plant_that_cannot_happen", "filled\n  inject\nemptied\n", "");
    assert_eq!(run.code, 1);
    assert_eq!(run.stdout, "environment: filled\n");
    for part in ["error[SML0106]", "station.play:2:3", "`ClearDock` forbids it"] {
        assert!(run.stderr.contains(part), "{}", run.stderr);
    }
}

#[test]
fn a_script_that_means_nothing_is_refused_before_it_is_played() {
    for line in
        ["fill", "expect enabled fill", "expect state Boom.Up", "expect", "expect rain x", "why", "back", "7"]
    {
        let run = script("a_script_of_a_plant_that_means_nothing", &format!("filled\n{line}\n"), "");
        assert_eq!((run.code, run.stdout.as_str()), (2, ""), "{line}");
        assert!(
            run.stderr.contains("error[SML0110]") && run.stderr.contains("station.play:2:1"),
            "{}",
            run.stderr
        );
    }
}

#[test]
fn events_are_taken_back_and_saved() {
    let path = scratch("events_of_plants_are_saved").join("a.play");
    let file = path.display();
    let run =
        talk(&format!("filled\n1\nback\nexpect enabled right\nemptied\nsave {file}\nquit\nnonsense\n"), "");
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    let saved = fs::read_to_string(&path).expect("it is written");
    assert_eq!(saved, "# a play of DistributionStation\nfilled\nemptied\n");
    assert_eq!(sml(&format!("play {} --script {file}", plant("distribution_station"))).code, 0);
    assert_eq!(talk(&format!("save {file}\n"), "").code, 2);
    assert_eq!(talk(&format!("save! {file}\n"), "").code, 0);
    for wrong in ["back\n", "back x\n", "9\n", "save\n", "rain\n"] {
        let run = talk(wrong, "");
        assert!(run.code == 2 && run.stderr.contains("type `help`"), "{wrong}{}", run.stderr);
    }
    assert!(talk("help\n", "").stdout.contains("why EVENT"));
}
