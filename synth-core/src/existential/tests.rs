use super::*;
use crate::pipeline::{Timings, play_and_solve, synthesize};
use crate::testing::{spec, world};

/// One line for each existential scenario.
fn examined(body: &str) -> String {
    let spec = spec(&world(body));
    let mut timings = Timings::default();
    let options = Options::default();
    let mut solved = play_and_solve(&spec, &options, &mut timings).expect("a game");
    let verified = synthesize(&mut solved, &options, &mut timings).ok();
    let controller = verified.as_ref().map(|verified| &verified.controller);
    let lines = existential(&spec, &options, &solved, controller).expect("no mistakes");
    let line = |existential: Existential| {
        let Existential { scenario, reachable, possible, witness } = existential;
        let verdict = match (reachable, possible) {
            (true, true) => "reachable",
            (false, true) => "possible",
            (false, false) => "impossible",
            (true, false) => panic!("{scenario} is reachable, but not possible"),
        };
        let colon = if witness.is_empty() { "" } else { ": " };
        format!("{scenario} {verdict}{colon}{}", witness.join(", "))
    };
    lines.into_iter().map(line).collect::<Vec<_>>().join("\n")
}

#[track_caller]
fn check(body: &str, expect: &str) {
    let expect: Vec<&str> = expect.lines().map(str::trim).collect();
    assert_eq!(examined(body), expect.join("\n"));
}

const LAMP: &str = "guarantee scenario G { user -> control.press() urgent control -> lamp.on() }";

#[test]
fn without_existential_scenarios_there_is_nothing_to_say() {
    check(LAMP, "");
}

#[test]
fn what_the_controller_does_is_reachable() {
    let example = "existential scenario E { user -> control.press() control -> lamp.on() }";
    check(&format!("{LAMP} {example}"), "C.E reachable: user -> control.press(), control -> lamp.on()");
}

#[test]
fn a_message_out_of_order_ends_a_copy_without_completing_it() {
    // Between `press` and `tick` there is always `on`, a message of the scenario.
    let example =
        "existential scenario E { user -> control.press() user -> control.tick() control -> lamp.on() }";
    check(
        &format!(
            "{LAMP} assumption scenario A {{ user -> control.press() strict user -> control.tick() }} {example}"
        ),
        "C.E impossible",
    );
}

#[test]
fn an_interrupted_copy_is_not_completed() {
    let example = "existential scenario E { user -> control.press() interrupt [true] }";
    check(&format!("{LAMP} {example}"), "C.E impossible");
    let example = "existential scenario E { user -> control.press() violation [true] }";
    check(&format!("{LAMP} {example}"), "C.E impossible");
    let example = "existential scenario E { user -> control.press() interrupt [false] }";
    check(&format!("{LAMP} {example}"), "C.E reachable: user -> control.press()");
}

#[test]
fn a_strict_message_out_of_order_violates_nothing() {
    let example =
        "existential scenario E { control -> lamp.on() strict control -> lamp.on() user -> control.press() }";
    check(&format!("{LAMP} {example}"), "C.E impossible");
}

#[test]
fn a_scenario_can_be_completed_from_the_start() {
    check(&format!("{LAMP} existential scenario E {{ wait [true] }}"), "C.E reachable");
}

#[test]
fn a_wait_is_passed_beside_the_state() {
    let example = "existential scenario E { while { user -> control.press() } }";
    check(&format!("{LAMP} {example}"), "C.E impossible");
    let example = "existential scenario E { wait [true] control -> lamp.on() control -> lamp.on() }";
    check(
        &format!("{LAMP} {example}"),
        "C.E reachable: user -> control.press(), control -> lamp.on(), user -> control.press(), control -> lamp.on()",
    );
}

#[test]
fn what_another_controller_could_do_is_possible() {
    // Both are asked for and one is enough, so the controller never sends `on`, which is the larger text.
    check(
        "guarantee scenario G { user -> control.press()
           alternative { urgent control -> lamp.off() } or { urgent control -> lamp.on() } }
         existential scenario Off { control -> lamp.off() user -> control.press() }
         existential scenario On { user -> control.press() control -> lamp.on() }",
        "C.Off reachable: user -> control.press(), control -> lamp.off(), user -> control.press()
         C.On possible: user -> control.press(), control -> lamp.on()",
    );
}

#[test]
fn what_only_a_losing_play_shows_is_impossible() {
    // After `on` the environment can break the guarantee.
    let losing = "guarantee scenario G { user -> control.press()
           alternative { urgent control -> lamp.off() } or { urgent control -> lamp.on() } }
         guarantee scenario H { control -> lamp.on() user -> control.release() }
           constraints [ forbidden user -> control.tick() ]
         existential scenario E { control -> lamp.on() user -> control.release() }";
    check(losing, "C.E impossible");
    let harmless = losing.replace("forbidden user -> control.tick()", "ignore user -> control.tick()");
    check(
        &harmless,
        "C.E possible: user -> control.press(), control -> lamp.on(), user -> control.release()",
    );
}

#[test]
fn nothing_is_possible_where_the_environment_wins() {
    check(
        "guarantee scenario G { user -> control.press() eventually user -> control.release() }
         existential scenario E { user -> control.press() }",
        "C.E impossible",
    );
}

#[test]
fn a_yield_is_part_of_a_witness() {
    check(
        "guarantee scenario G { user -> control.press() eventually control -> lamp.on() }
         assumption scenario A { while { eventually user -> control.press() } }
         existential scenario E { user -> control.press() user -> control.press() }
           constraints [ interrupt control -> lamp.on() ]",
        "C.E possible: user -> control.press(), yield, user -> control.press()",
    );
}

#[test]
fn several_copies_are_followed() {
    check(
        &format!(
            "{LAMP} guarantee scenario Tick {{ user -> control.tick() }}
             existential scenario E {{ user -> control.press() user -> control.press() user -> control.tick() }}
               constraints [ ignore control -> lamp.on() ]"
        ),
        "C.E reachable: user -> control.press(), control -> lamp.on(), user -> control.press(), control -> lamp.on(), user -> control.tick()",
    );
}

#[test]
fn without_a_controller_nothing_is_reachable() {
    let text = world(&format!("{LAMP} existential scenario E {{ user -> control.press() }}"));
    let spec = spec(&text);
    let options = Options::default();
    let solved = play_and_solve(&spec, &options, &mut Timings::default()).expect("a game");
    let found = existential(&spec, &options, &solved, None).expect("no mistakes");
    let expected = Existential {
        scenario: "C.E".to_owned(),
        reachable: false,
        possible: true,
        witness: vec!["user -> control.press()".to_owned()],
    };
    assert_eq!(found, [expected]);
    let tight = Options { limits: Limits { states: 1, ..options.limits }, ..options };
    let text = text.replace("control.press() }\n", "control.tick() user -> control.tick() }\n");
    let spec = crate::testing::spec(&text);
    let solved = play_and_solve(&spec, &options, &mut Timings::default()).expect("a game");
    assert!(matches!(existential(&spec, &tight, &solved, None), Err(Failure::Limit(_))));
}
