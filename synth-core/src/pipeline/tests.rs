use super::*;
use crate::diagnostic::Code;
use crate::testing::{loaded, spec, world};

/// The super steps of the controller, or the code, the line and the notes of the mistake.
fn synthesized(body: &str) -> String {
    let spec = spec(&world(body));
    let mut timings = Timings::default();
    let options = Options::default();
    let mut solved = play_and_solve(&spec, &options, &mut timings).expect("a game");
    let lines = match synthesize(&mut solved, &options, &mut timings) {
        Ok(Verified { controller, .. }) => {
            let text = |&event: &u32| controller.commands[event as usize].text.as_str();
            let steps = controller.super_steps.iter();
            steps.map(|step| step.events.iter().map(text).collect::<Vec<_>>().join(", ")).collect()
        }
        Err(Failure::Wrong(diagnostics)) => {
            let of = |d: &Diagnostic| {
                [vec![format!("{} in line {}", d.code, d.span.start.line)], d.notes.clone()].concat()
            };
            diagnostics.iter().flat_map(of).collect::<Vec<_>>()
        }
        Err(failure) => panic!("{failure:?}"),
    };
    lines.join("\n")
}

#[track_caller]
fn check(body: &str, expect: &str) {
    let trim = |text: &str| text.lines().map(str::trim).collect::<Vec<_>>().join("\n");
    assert_eq!(trim(&synthesized(body)), trim(expect));
}

#[test]
fn a_super_step_that_never_ends_is_no_controller() {
    // If the environment ever gets the turn, it keeps the assumption and is silent for ever.
    check(
        "assumption scenario A { user -> control.press() eventually user -> control.release() }
         guarantee scenario G { user -> control.press() while { eventually control -> lamp.on() } }",
        "SML0072 in line 13
         it keeps the environment from ever meeting an assumption that is still open; no controller can do that
         the shortest play that leads there:
           user -> control.press()
         and then, for ever:
           control -> lamp.on()",
    );
}

#[test]
fn committed_messages_without_end_are_no_controller() {
    check(
        "assumption scenario A { user -> control.press() eventually user -> control.release() }
         guarantee scenario G { user -> control.press() while {
           committed control -> lamp.on()
           committed control -> lamp.off()
         } }",
        "SML0072 in line 14
         it keeps the environment from ever meeting an assumption that is still open; no controller can do that
         the shortest play that leads there:
           user -> control.press()
         and then, for ever:
           control -> lamp.on()
           control -> lamp.off()",
    );
}

#[test]
fn a_loop_that_waits_for_the_environment_ends_its_super_steps() {
    check(
        "assumption scenario A { user -> control.press() eventually user -> control.release() }
         guarantee scenario G { while { user -> control.press() eventually control -> lamp.on() } }",
        "control -> lamp.on()",
    );
}

#[test]
fn the_play_ends_where_the_loop_begins() {
    check(
        "assumption scenario A { user -> control.press() eventually user -> control.release() }
         guarantee scenario G { user -> control.press() urgent control -> lamp.off()
           while { urgent control -> lamp.on() } }",
        "SML0072 in line 14
         it keeps the environment from ever meeting an assumption that is still open; no controller can do that
         the shortest play that leads there:
           user -> control.press()
           control -> lamp.off()
         and then, for ever:
           control -> lamp.on()",
    );
}

#[test]
fn cases_without_fragments_count_as_nodes() {
    let scenario = |cases: usize| {
        let cases = "{ } or ".repeat(cases);
        let body = format!("guarantee scenario S {{ user -> control.press() alternative {cases} {{ }} }}");
        specification(&loaded(&world(&body))).err().map(|failure| failure.diagnostics())
    };
    // Beside the cases: the scenario's body, the message, the `alternative`, and the last case.
    assert_eq!(scenario(65_532), None);
    let codes: Vec<Code> = scenario(65_533).expect("errors").iter().map(|d| d.code).collect();
    assert_eq!(codes, [Code::TooLarge]);
}

/// The code of the mistake that a specification of one operation with this parameter runs into.
#[track_caller]
fn check_parameter(ty: &str, sections: &str, argument: &str, expect: Option<Code>) {
    let text = format!(
        "specification S {{
           domain d {{ class C {{ }} class E {{ go(x: {ty}) }} class U {{ start() }} }}
           object c: C  object e: E  object u: U
           controllable {{ C }} {sections}
           collaboration K {{ guarantee scenario G {{ e -> u.start() urgent c -> e.go({argument}) }} }}
         }}"
    );
    let loaded = loaded(&text);
    let run =
        || play_and_solve(&specification(&loaded)?, &Options::default(), &mut Timings::default()).map(drop);
    let code = run().err().map(|failure| failure.diagnostics()[0].code);
    assert_eq!(code, expect);
}

#[test]
fn types_too_large_to_expand_are_refused() {
    check_parameter("0..=9", "", "*", None);
    check_parameter("0..=4294967294", "", "7", None);
    check_parameter("0..=4294967294", "", "*", Some(Code::LimitReached));
    let few = "parameter ranges { E.go(x = [0..=3]) }";
    check_parameter("0..=4294967294", few, "*", None);
    let many = "parameter ranges { E.go(x = [0..=4294967294]) }";
    check_parameter("0..=4294967294", many, "7", Some(Code::OutOfRange));
}

#[test]
fn a_long_loop_within_one_step_settles() {
    check(
        "guarantee scenario G {
           user -> control.press()
           var 0..=100000 n = 0
           while [n < 30000] { wait [true] n = n + 1 }
           urgent control -> lamp.on()
         }",
        "control -> lamp.on()",
    );
}

#[test]
fn a_loop_that_comes_round_to_itself_is_a_mistake() {
    let body = "guarantee scenario G {
                  user -> control.press()
                  var 0..=9 n = 0
                  while { wait [true] alternative [n < 9] { n = n + 1 } or [n == 9] { n = 3 } }
                }";
    let spec = spec(&world(body));
    let failure = play_and_solve(&spec, &Options::default(), &mut Timings::default()).expect_err("a mistake");
    assert_eq!(failure.diagnostics()[0].code, Code::PlayOutLoop);
}
