use super::*;
use crate::pipeline::{Failure, Options, Timings, play_and_solve, synthesize};
use crate::testing::{spec, world};

/// The explanation, one line for each part that says something.
fn explained(body: &str) -> String {
    let spec = spec(&world(body));
    let mut timings = Timings::default();
    let options = Options::default();
    let mut solved = play_and_solve(&spec, &options, &mut timings).expect("a game");
    let explanation = explain(&solved, &Limits::default());
    match synthesize(&mut solved, &options, &mut timings) {
        Ok(_) => assert_eq!(explanation, None),
        Err(Failure::Unrealizable(unrealizable)) => {
            assert_eq!(Some(&unrealizable.explanation), explanation.as_ref());
        }
        Err(failure) => panic!("{failure:?}"),
    }
    let Some(explanation) = explanation else {
        return "realizable".to_owned();
    };
    assert!(explanation.is_minimal);
    let Explanation { cause, scenarios, involved, play, cycle, starved, blocked, .. } = explanation;
    let mut lines = vec![format!("{} {}", cause.as_str(), scenarios.join(", "))];
    if !involved.is_empty() {
        lines.push(format!("involved {}", involved.join(", ")));
    }
    lines.push(format!("play {}", play.join(", ")));
    if !cycle.is_empty() {
        lines.push(format!("loop {}", cycle.join(", ")));
    }
    if let Some(Starved { scenario, fragment }) = starved {
        lines.push(format!(
            "starved {scenario} {}",
            world(body).lines().nth(fragment.start.line as usize - 1).unwrap()
        ));
    }
    lines.extend(
        blocked.iter().map(|blocked| format!("blocked {} by {}", blocked.event, blocked.by.join(", "))),
    );
    let lines: Vec<String> =
        lines.iter().map(|line| line.split_whitespace().collect::<Vec<_>>().join(" ")).collect();
    lines.join("\n")
}

#[track_caller]
fn check(body: &str, expect: &str) {
    let expect: Vec<&str> = expect.lines().map(str::trim).collect();
    assert_eq!(explained(body), expect.join("\n"));
}

#[test]
fn nothing_is_explained_where_the_system_wins() {
    check("guarantee scenario G { user -> control.press() urgent control -> lamp.on() }", "realizable");
}

#[test]
fn an_event_that_must_not_come_comes() {
    check(
        "guarantee scenario G { user -> control.press() user -> control.release() }
           constraints [ forbidden user -> control.tick() ]",
        "environment_violates C.G
         play user -> control.press(), user -> control.tick()",
    );
}

#[test]
fn an_assumption_that_rules_it_out_helps() {
    check(
        "guarantee scenario G { user -> control.press() user -> control.release() }
           constraints [ forbidden user -> control.tick() ]
         assumption scenario A { user -> control.press() strict user -> control.release() }
           constraints [ consider user -> control.tick() ]",
        "realizable",
    );
}

#[test]
fn what_keeps_the_system_from_being_in_time_is_involved() {
    check(
        "guarantee scenario G { user -> control.press() strict urgent control -> lamp.on() }
         guarantee scenario H { user -> control.press() user -> control.release() }
           constraints [ forbidden control -> lamp.on() ignore user -> control.press() ]",
        "environment_violates C.G, C.H
         play user -> control.press(), user -> control.press()
         blocked control -> lamp.on() by C.H",
    );
}

#[test]
fn a_message_is_blocked_for_ever() {
    check(
        "guarantee scenario G { user -> control.press() eventually control -> lamp.on() }
         guarantee scenario H { user -> control.press() user -> control.release() }
           constraints [ forbidden control -> lamp.on() ignore user -> control.press() ]",
        "urgent_blocked C.G, C.H
         play user -> control.press()
         loop silence
         starved C.G guarantee scenario G { user -> control.press() eventually control -> lamp.on() }
         blocked control -> lamp.on() by C.H",
    );
}

#[test]
fn a_message_that_would_break_an_assumption_is_blocked() {
    check(
        "guarantee scenario G { user -> control.press() urgent control -> lamp.on() }
         assumption scenario A { user -> control.press() user -> control.release() }
           constraints [ forbidden control -> lamp.on() ]",
        "urgent_blocked C.G
         involved C.A
         play user -> control.press()
         loop silence
         starved C.G guarantee scenario G { user -> control.press() urgent control -> lamp.on() }
         blocked control -> lamp.on() by C.A",
    );
}

#[test]
fn one_of_two_guarantees_can_be_met_at_a_time() {
    check(
        "guarantee scenario G { user -> control.press() eventually control -> lamp.on() }
         guarantee scenario H { user -> control.press() eventually control -> lamp.off() }
         guarantee scenario OnIsFinal { control -> lamp.on() user -> control.release() }
           constraints [ forbidden control -> lamp.off() ]
         guarantee scenario OffIsFinal { control -> lamp.off() user -> control.release() }
           constraints [ forbidden control -> lamp.on() ]
         guarantee scenario Bystander { user -> control.press() eventually control -> lamp.blink() }",
        "guarantees_conflict C.H, C.OnIsFinal, C.G
         play user -> control.press(), control -> lamp.blink(), control -> lamp.on()
         loop silence
         starved C.H guarantee scenario H { user -> control.press() eventually control -> lamp.off() }
         blocked control -> lamp.off() by C.OnIsFinal",
    );
}

#[test]
fn the_environment_withholds_what_is_waited_for() {
    check(
        "guarantee scenario G { user -> control.press() monitored eventually user -> control.release() }",
        "obligation_starved C.G
         play user -> control.press()
         loop silence
         starved C.G guarantee scenario G { user -> control.press() monitored eventually user -> control.release() }",
    );
}

#[test]
fn an_assumption_that_promises_it_helps() {
    check(
        "guarantee scenario G { user -> control.press() monitored eventually user -> control.release() }
         assumption scenario A { user -> control.press() eventually user -> control.release() }",
        "realizable",
    );
}

#[test]
fn two_guarantees_ask_each_other_for_ever() {
    check(
        "guarantee scenario G { control -> lamp.on() urgent control -> lamp.off() }
         guarantee scenario H { control -> lamp.off() urgent control -> lamp.on() }
         guarantee scenario Start { user -> control.press() urgent control -> lamp.on() }",
        "guarantees_conflict C.G, C.H, C.Start
         play user -> control.press(), control -> lamp.on()
         loop control -> lamp.off(), control -> lamp.on()",
    );
}

#[test]
fn one_guarantee_asks_for_ever() {
    check(
        "guarantee scenario G { user -> control.press() while { urgent control -> lamp.on() } }",
        "obligation_starved C.G
         play user -> control.press()
         loop control -> lamp.on()",
    );
}

#[test]
fn a_goal_that_needs_the_other_guarantee_violated_is_in_conflict() {
    check(
        "guarantee scenario G { user -> control.press() eventually control -> lamp.on() }
         guarantee scenario H { control -> lamp.on() user -> control.press() }
           constraints [ forbidden user -> control.tick() ]
         guarantee scenario Bystander { user -> control.press() eventually control -> lamp.blink() }",
        "guarantees_conflict C.G, C.H
         play user -> control.press(), control -> lamp.blink(), yield
         loop silence
         starved C.G guarantee scenario G { user -> control.press() eventually control -> lamp.on() }",
    );
}

/// The texts that are suggested.
#[track_caller]
fn check_suggestions(body: &str, expect: &[&str]) {
    let spec = spec(&world(body));
    let solved = play_and_solve(&spec, &Options::default(), &mut Timings::default()).expect("a game");
    let suggestions = explain(&solved, &Limits::default()).expect("an explanation").suggestions;
    let flat = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert_eq!(suggestions.iter().map(|one| flat(&one.text)).collect::<Vec<_>>(), expect);
}

#[test]
fn an_answer_is_suggested() {
    check_suggestions(
        "guarantee scenario G { user -> control.press() monitored eventually user -> control.release() }",
        &["assumption scenario ReleaseFollowsPress \
           { user -> control.press() eventually user -> control.release() }"],
    );
}

#[test]
fn no_repetition_is_suggested_under_a_name_that_is_free() {
    check_suggestions(
        "guarantee scenario G { user -> control.press() user -> control.release() }
           constraints [ forbidden user -> control.press() ]
         existential scenario NoPressBeforeRelease { user -> control.press() user -> control.release() }",
        &["assumption scenario NoPressBeforeRelease2 { user -> control.press() user -> control.release() } \
           constraints [ forbidden user -> control.press() ]"],
    );
}

#[test]
fn nothing_is_suggested_that_another_assumption_makes_impossible() {
    check_suggestions(
        "guarantee scenario G { user -> control.press() monitored eventually user -> control.release() }
         assumption scenario Never { wait [false] } constraints [ forbidden user -> control.release() ]",
        &[],
    );
}

#[test]
fn nothing_is_suggested_against_a_super_step_without_end() {
    check_suggestions(
        "guarantee scenario G { user -> control.press() while { urgent control -> lamp.on() } }",
        &[],
    );
}

#[test]
fn limits_hold_for_explanations_too() {
    let spec = spec(&world(
        "guarantee scenario G { user -> control.press() urgent control -> lamp.on() }
         guarantee scenario H { user -> control.press() monitored eventually user -> control.release() }",
    ));
    let solved = play_and_solve(&spec, &Options::default(), &mut Timings::default()).expect("a game");
    let of = |limits: Limits| {
        let Explanation { scenarios, is_minimal, suggestions, .. } =
            explain(&solved, &limits).expect("an explanation");
        (scenarios.len(), is_minimal, suggestions.len())
    };
    assert_eq!(of(Limits::default()), (1, true, 1));
    assert_eq!(of(Limits { states: 0, ..Limits::default() }), (2, false, 0));
    assert_eq!(of(Limits { memory: 0, ..Limits::default() }), (2, false, 0));
}
