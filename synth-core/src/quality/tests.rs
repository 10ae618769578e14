//! Every warning, at its place, and next to it what must not be warned of.

use crate::diagnostic::Diagnostic;
use crate::pipeline::{Options, Timings, play_and_solve, specification, warnings};
use crate::playout::Semantics;
use crate::syntax::{Loaded, load};

fn diagnostics_of(text: &str, semantics: Semantics) -> Vec<Diagnostic> {
    let shared = b"specification Shared { domain { class Spare { unused() } } }".to_vec();
    let loaded: Loaded = load("world.sml", text.as_bytes(), &mut |_| Ok(shared.clone()));
    let spec = specification(&loaded).unwrap_or_else(|failure| panic!("{:#?}", failure.diagnostics()));
    let options = Options { semantics, ..Options::default() };
    let mut timings = Timings::default();
    let mut solved = play_and_solve(&spec, &options, &mut timings).expect("a game");
    warnings(&loaded, &mut solved, true, &mut timings).expect("warnings")
}

/// The text without the lines that mark the line above with `~~~~`; line, column, width and words of each mark, in the
/// order of places.
fn unmark(marked: &str) -> (String, Vec<(u32, u32, u32, String)>) {
    let (mut text, mut marks) = (String::new(), Vec::new());
    let mut line = 0;
    for full in marked.lines() {
        let mark = full.trim_start();
        if mark.starts_with('~') {
            let words = mark.trim_start_matches('~');
            let column = (full.len() - mark.len()) as u32 + 1;
            marks.push((line, column, (mark.len() - words.len()) as u32, words.trim().to_owned()));
        } else {
            text.push_str(full);
            text.push('\n');
            line += 1;
        }
    }
    marks.sort();
    (text, marks)
}

#[track_caller]
fn check_with(semantics: Semantics, code: u16, marked: &str) {
    let (text, marks) = unmark(marked);
    let mut found: Vec<_> = diagnostics_of(&text, semantics)
        .iter()
        .filter(|one| one.code as u16 == code)
        .map(|one| {
            let (start, end) = (one.span.start, one.span.end);
            let words = one.message.clone();
            (start.line, start.column, end.column - start.column, words)
        })
        .collect();
    found.sort();
    assert_eq!(found, marks, "{text}");
}

/// The warnings of this code are exactly the marks of the specification.
#[track_caller]
fn check(code: u16, marked: &str) {
    check_with(Semantics::default(), code, marked);
}

/// The same for the collaboration of a small world.
#[track_caller]
fn check_body(code: u16, body: &str) {
    check(code, &world(body));
}

fn world(body: &str) -> String {
    let non_spontaneous = if body.contains("arm -> ctl.done()") { "Ctl.done" } else { "" };
    format!(
        "specification World {{
  domain {{
    enum Place {{ left, right }}
    class User {{ }}
    class Ctl {{ press() stop() done() at(place: Place) }}
    class Arm {{ go() rest() to(place: Place) }}
  }}
  object ctl: Ctl object arm: Arm object user: User
  controllable {{ Ctl }}
  non-spontaneous events {{ {non_spontaneous} }}
  collaboration C {{\n{body}\n}}
}}"
    )
}

/// The notes of the only warning with this code.
#[track_caller]
fn notes(code: u16, text: &str) -> Vec<String> {
    let found = diagnostics_of(text, Semantics::default());
    let mut found = found.into_iter().filter(|one| one.code as u16 == code);
    let notes = found.next().expect("a warning").notes;
    assert_eq!(found.next(), None);
    notes
}

// 90: an assumption that the system can break.

#[test]
fn an_urgent_message_breaks_a_strict_assumption() {
    check_body(
        90,
        "guarantee scenario G { user -> ctl.press() urgent ctl -> arm.go() }
assumption scenario Done { ctl -> arm.go() strict eventually arm -> ctl.done() }
                    ~~~~ an event of the system can violate assumption `C.Done`",
    );
}

#[test]
fn the_play_ends_with_the_event() {
    let text = world(
        "guarantee scenario G { user -> ctl.press() urgent ctl -> arm.go() }
         assumption scenario Done { ctl -> arm.go() strict eventually arm -> ctl.done() }",
    );
    let play = "user -> ctl.press()\n  ctl -> arm.go()\n  user -> ctl.press()\n  ctl -> arm.go()";
    assert_eq!(notes(90, &text)[1], format!("the shortest play that leads there:\n  {play}"));
}

#[test]
fn the_places_are_those_of_the_event() {
    let text = world(
        "guarantee scenario G {
  user -> ctl.press()
  parallel { ctl -> arm.to(left) } and { urgent ctl -> arm.to(right) }
}
assumption scenario A {
  user -> ctl.press()
  user -> ctl.stop()
} constraints [
  forbidden ctl -> arm.to(left)
  forbidden ctl -> arm.to(right)
]",
    );
    let found = diagnostics_of(&text, Semantics::default());
    let warning = found.iter().find(|one| one.code as u16 == 90).expect("a warning");
    let labels: Vec<(&str, &str)> = warning
        .labels
        .iter()
        .map(|(span, says)| {
            let line = text.lines().nth(span.start.line as usize - 1).expect("a line");
            (&line[span.start.column as usize - 1..span.end.column as usize - 1], says.as_str())
        })
        .collect();
    assert_eq!(
        labels,
        [
            ("ctl -> arm.to(right)", "forbidden here"),
            ("urgent ctl -> arm.to(right)", "a guarantee asks for it here")
        ]
    );
}

#[test]
fn with_classic_the_system_wins_by_it() {
    check_with(
        Semantics { classic: true },
        90,
        &world(
            "guarantee scenario G { user -> ctl.press() urgent ctl -> arm.go() }
assumption scenario Done { ctl -> arm.go() strict eventually arm -> ctl.done() }
                    ~~~~ an event of the system can violate assumption `C.Done`",
        ),
    );
}

#[test]
fn a_guarantee_that_waits_breaks_nothing() {
    check_body(
        90,
        "guarantee scenario G {
  while { user -> ctl.press() urgent ctl -> arm.go() arm -> ctl.done() }
} constraints [ ignore user -> ctl.press() ]
assumption scenario Done { ctl -> arm.go() strict eventually arm -> ctl.done() }",
    );
}

#[test]
fn what_a_guarantee_forbids_is_no_breach() {
    check_body(
        90,
        "guarantee scenario G { user -> ctl.press() eventually ctl -> arm.go() }
guarantee scenario Once { ctl -> arm.go() arm -> ctl.done() } constraints [ forbidden ctl -> arm.go() ]
assumption scenario Done { ctl -> arm.go() strict eventually arm -> ctl.done() }",
    );
}

// 91: a wait that only the system ends.

const LAMP: &str = "specification World {
  domain { class User { } class Ctl { press() } class Lamp { on: bool light() } }
  object user: User object ctl: Ctl object lamp: Lamp controllable { Ctl }
EFFECTS
  collaboration C {
    guarantee scenario G { user -> ctl.press() eventually ctl -> lamp.light() MORE }
    assumption scenario A {
      user -> ctl.press()
      wait eventually [lamp.on]
MARK
    } constraints [ ignore user -> ctl.press() ]
  }
}";

#[track_caller]
fn check_wait(effects: &str, more: &str, mark: &str) {
    let text = LAMP.replace("EFFECTS", effects).replace("MORE", more).replace("MARK\n", mark);
    let (text, marks) = unmark(&text);
    let found = diagnostics_of(&text, Semantics::default());
    let found: Vec<_> = found.iter().filter(|one| one.code as u16 == 91).collect();
    assert_eq!(found.len(), marks.len(), "{found:#?}");
    for (found, (line, column, width, words)) in found.iter().zip(marks) {
        assert_eq!((found.span.start.line, found.span.start.column), (line, column));
        assert_eq!(found.span.end.column - column, width);
        assert_eq!(found.label, words);
    }
}

#[test]
fn a_wait_for_what_only_the_system_changes() {
    let mark = "      ~~~~~~~~~~~~~~~~~~~~~~~~~ only the system changes this\n";
    check_wait("effects { Ctl -> Lamp.light() { receiver.on = true } }", "", mark);
    check_wait("", "urgent ctl -> lamp.setOn(true)", mark);
}

#[test]
fn a_wait_for_what_nothing_changes() {
    check_wait("", "", "      ~~~~~~~~~~~~~~~~~~~~~~~~~ this is false and never changes\n");
}

#[test]
fn a_wait_that_the_environment_can_end() {
    check_wait("effects { User -> Ctl.press() { lamp.on = true } }", "", "");
    check_wait("", "lamp -> lamp.setOn(*)", "");
}

// 92: an environment without a move.

#[test]
fn an_assumption_that_another_one_blocks() {
    check_body(
        92,
        "guarantee scenario G { user -> ctl.press() urgent ctl -> arm.go() }
assumption scenario Done { ctl -> arm.go() eventually arm -> ctl.done() }
                                           ~~~~~~~~~~~~~~~~~~~~~~~~~~~~ the controller can leave its environment without a move
assumption scenario Never { ctl -> arm.go() wait [false] } constraints [ forbidden arm -> ctl.done() forbidden user -> ctl.press() ]",
    );
}

#[test]
fn an_environment_that_moves_in_vain() {
    check_body(
        92,
        "guarantee scenario G { user -> ctl.press() urgent ctl -> arm.go() }
assumption scenario Done { ctl -> arm.go() eventually arm -> ctl.done() }
                                           ~~~~~~~~~~~~~~~~~~~~~~~~~~~~ the controller can leave its environment no way to keep its assumptions
assumption scenario Never { ctl -> arm.go() wait [false] } constraints [ forbidden arm -> ctl.done() ignore ctl -> arm.go() ]",
    );
}

#[test]
fn an_environment_that_can_wait_is_not_trapped() {
    check_body(92, "guarantee scenario G { user -> ctl.press() urgent ctl -> arm.go() }");
}

// 93: a scenario that never starts.

#[test]
fn a_message_that_nobody_sends() {
    check_body(
        93,
        "guarantee scenario G { user -> ctl.press() urgent ctl -> arm.go() }
guarantee scenario Never { ctl -> arm.rest() urgent ctl -> arm.go() }
                   ~~~~~ scenario `C.Never` can never start",
    );
}

#[test]
fn a_message_that_is_never_caused() {
    check(
        93,
        "specification World {
  domain { class User { } class Ctl { press() done() } class Arm { go() rest() } }
  object user: User object ctl: Ctl object arm: Arm controllable { Ctl }
  non-spontaneous events { Ctl.done }
  collaboration C {
    guarantee scenario G { user -> ctl.press() urgent ctl -> arm.go() }
    guarantee scenario After { arm -> ctl.done() urgent ctl -> arm.rest() }
                       ~~~~~ scenario `C.After` can never start
  }
}",
    );
}

#[test]
fn a_message_without_a_channel() {
    check(
        93,
        "specification World {
  domain { class User { ctl: Ctl } class Ctl { press() } class Arm { go() } }
  object user: User object ctl: Ctl object arm: Arm controllable { Ctl }
  channels { Ctl.press over User.ctl }
  collaboration C {
    guarantee scenario G { user -> ctl.press() urgent ctl -> arm.go() }
                       ~ scenario `C.G` can never start
  }
}",
    );
}

#[test]
fn a_value_outside_its_range() {
    check(
        93,
        "specification World {
  domain { class User { } class Ctl { press(floor: 1..=5) } class Arm { go() } }
  object user: User object ctl: Ctl object arm: Arm controllable { Ctl }
  parameter ranges { Ctl.press(floor = [1..3]) }
  collaboration C {
    guarantee scenario G { user -> ctl.press(3) urgent ctl -> arm.go() }
    guarantee scenario H { user -> ctl.press(4) urgent ctl -> arm.go() }
                       ~ scenario `C.H` can never start
  }
}",
    );
}

#[test]
fn one_that_ends_at_once_has_started() {
    check_body(
        93,
        "guarantee scenario G { user -> ctl.press() urgent ctl -> arm.go() }
guarantee scenario Short { ctl -> arm.go() interrupt [true] urgent ctl -> arm.go() }",
    );
}

// 94: a guarantee that is never exercised.

#[test]
fn a_guarantee_that_the_controller_avoids() {
    check_body(
        94,
        "guarantee scenario G { user -> ctl.press() alternative { urgent ctl -> arm.go() } or { urgent ctl -> arm.rest() } }
guarantee scenario Dead { ctl -> arm.rest() user -> ctl.stop() violation [true] }
                   ~~~~ guarantee `C.Dead` is never exercised in the controlled system
guarantee scenario Idle { ctl -> arm.rest() urgent ctl -> arm.rest() }
                   ~~~~ guarantee `C.Idle` is never exercised in the controlled system
guarantee scenario Seen { ctl -> arm.go() violation [false] }",
    );
}

#[test]
fn a_guarantee_whose_demand_is_never_reached() {
    check_body(
        94,
        "guarantee scenario G { user -> ctl.press() urgent ctl -> arm.go() }
guarantee scenario Late { user -> ctl.press() wait [false] urgent ctl -> arm.go() }
                   ~~~~ guarantee `C.Late` is never exercised in the controlled system",
    );
}

// 95: the order of two events.

#[test]
fn the_last_of_two_wins() {
    check_body(
        95,
        "guarantee scenario G { user -> ctl.press() interrupt [false] urgent ctl -> arm.go() }
                       ~~~~~~~~~~~~~~~~~~~ the order of `user -> ctl.press()` and `user -> ctl.stop()` makes a difference
guarantee scenario S { user -> ctl.press() user -> ctl.stop() urgent ctl -> arm.rest() }",
    );
}

#[test]
fn independent_events_commute() {
    check_body(
        95,
        "guarantee scenario G { user -> ctl.press() urgent ctl -> arm.go() }
guarantee scenario S { user -> ctl.stop() urgent ctl -> arm.go() }",
    );
}

#[test]
fn events_that_exclude_each_other_never_meet() {
    check_body(
        95,
        "guarantee scenario G { user -> ctl.press() urgent ctl -> arm.go() }
guarantee scenario S { user -> ctl.stop() urgent ctl -> arm.rest() }
assumption scenario Either {
  alternative { user -> ctl.press() } or { user -> ctl.stop() }
  wait [false]
} constraints [ forbidden user -> ctl.press() forbidden user -> ctl.stop() ]
",
    );
}

#[test]
fn one_order_is_excluded() {
    let text = world(
        "guarantee scenario G { user -> ctl.press() urgent ctl -> arm.go() }
         guarantee scenario S { user -> ctl.stop() urgent ctl -> arm.go() }
         assumption scenario Ordered { user -> ctl.press() wait [false] } constraints [ forbidden user -> ctl.stop() ]",
    );
    assert_eq!(
        notes(95, &text)[0],
        "after `user -> ctl.stop()` the controller takes `user -> ctl.press()`, but not the other way round"
    );
}

// 96: a message with `bind`.

const MOVES: &str = "guarantee scenario Left { user -> ctl.press() urgent ctl -> arm.to(left) }
guarantee scenario Right { user -> ctl.stop() urgent ctl -> arm.to(right) }
guarantee scenario Moving {
  var Place target
  ctl -> arm.to(bind target)
MARK
  strict arm -> ctl.at(target)
}CONSTRAINTS";

#[track_caller]
fn count_covered(constraints: &str, expect: usize) {
    let text = world(&MOVES.replace("MARK\n", "").replace("CONSTRAINTS", constraints));
    let found = diagnostics_of(&text, Semantics::default());
    let covered: Vec<_> = found.iter().filter(|one| one.code as u16 == 96).collect();
    assert_eq!(covered.len(), expect, "{found:#?}");
    for warning in covered {
        assert_eq!(
            text.lines().nth(warning.span.start.line as usize - 1),
            Some("  ctl -> arm.to(bind target)")
        );
        let violates = "`ctl -> arm.to(right)` violates `C.Moving`, although it has another argument";
        assert_eq!(warning.message, violates);
        assert_eq!(warning.labels[0].1, "while this is due, any other `to` is a violation");
    }
}

#[test]
fn a_bound_argument_covers_its_siblings() {
    count_covered("", 1);
}

#[test]
fn what_a_constraint_says_is_meant() {
    count_covered(" constraints [ ignore ctl -> arm.to(*) ]", 0);
    count_covered(" constraints [ forbidden ctl -> arm.to(*) ]", 0);
}

#[test]
fn a_bound_argument_of_the_environment_covers_its_siblings() {
    let text = |strict: &str| {
        let mark = if strict.is_empty() {
            ""
        } else {
            "  ~~~~~~~~~~~~~~~~~~~~~~~~~ `arm -> ctl.at(right)` violates `C.A`, although it has another argument\n"
        };
        format!(
            "guarantee scenario G {{ arm -> ctl.at(*) urgent ctl -> arm.go() }}
assumption scenario A {{
  var Place place
  arm -> ctl.at(bind place)
{mark}  {strict} user -> ctl.press()
}}"
        )
    };
    check_body(96, &text("strict"));
    check_body(96, &text(""));
}

// 97: declarations.

#[test]
fn unused_declarations() {
    check(
        97,
        "import \"shared.sml\"
specification World {
  domain {
    enum Color { red, green }
         ~~~~~ enum `Color` is never used
    class Nothing { also() }
          ~~~~~~~ class `Nothing` is never used
    class User { }
    class Ctl { press(level: 1..=3) }
    class Arm { on: bool  spare: 0..=3  written: bool  go()  rest() }
                          ~~~~~ attribute `spare` is never read
                                        ~~~~~~~ attribute `written` is never read
                                                             ~~~~ no scenario mentions operation `rest`
  }
  object user: User
  object other: User
         ~~~~~ object `other` is never used
  object ctl: Ctl
  object arm: Arm
  effects {
    Ctl -> Arm.go() { receiver.written = true }
    User -> Arm.go() { arm.on = true }
    ~~~~~~~~~~~~~~ no scenario has a message `User -> Arm.go` with this effect
  }
  controllable { Ctl }
  collaboration C {
    static role Ctl ctl
    dynamic role Arm someone
                     ~~~~~~~ no scenario of the collaboration mentions role `someone`
    guarantee scenario G {
      var 1..=3 level
                ~~~~~ variable `level` is bound, but never read
      var bool never
               ~~~~~ variable `never` is never read
      user -> ctl.press(bind level)
      wait [!arm.on]
      urgent ctl -> arm.go()
    }
  }
}",
    );
}

#[test]
fn entries_about_events_that_do_not_occur() {
    check(
        97,
        "specification World {
  domain {
    class User { } class Base { press(n: 1..=2) } class Ctl : Base { } class Other : Base { }
                                                                             ~~~~~ class `Other` is never used
    class Arm { go() rest() }
                     ~~~~ no scenario mentions operation `rest`
  }
  object user: User object ctl: Ctl object arm: Arm
  controllable { Ctl }
  non-spontaneous events { Arm.rest }
  collaboration C { guarantee scenario G { user -> ctl.press(*) urgent ctl -> arm.go() } }
}",
    );
}

#[test]
fn what_is_used_in_one_way_or_another() {
    check(
        97,
        "specification World {
  domain {
    enum Color { red, green }
    abstract class Thing { }
    class User : Thing { likes: Color }
    class Ctl { press(what: Thing) }
    class Arm : Thing { partner: Arm  color: Color  go() }
  }
  object user: User { likes: green }
  object ctl: Ctl
  object arm: Arm { partner: arm2 }
  object arm2: Arm
  object spare: User
  controllable { Ctl }
  parameter ranges { Ctl.press(what = [arm]) }
  channels { Arm.go over Ctl.arm Ctl.press over User.ctl }
  collaboration C {
    dynamic role Arm any
    guarantee scenario G bindings [ any = arm.partner ] {
      var Arm only
      user -> ctl.press(bind only)
      wait [user.likes == any.color || only == null]
      urgent ctl -> any.go()
    }
  }
}"
        .replace("class Ctl { ", "class Ctl { arm: Arm ")
        .replace("likes: Color }", "likes: Color ctl: Ctl }")
        .replace("object ctl: Ctl\n", "object ctl: Ctl { arm: arm2 }\n")
        .replace("likes: green }", "likes: green, ctl: ctl }")
        .replace("  object spare: User\n", "")
        .as_str(),
    );
}

// 98: an event without a cause.

#[test]
fn an_event_that_nothing_causes() {
    check(
        98,
        "specification World {
  domain { class User { } class Ctl { press() done() } class Arm { go() done() } }
  object user: User object ctl: Ctl object arm: Arm controllable { Ctl }
  non-spontaneous events { Ctl.done Arm.done }
                           ~~~~~~~~ no assumption causes `Ctl.done`, so the environment never sends it
  collaboration C {
    guarantee scenario G { user -> ctl.press() urgent ctl -> arm.go() arm -> ctl.done() eventually ctl -> arm.done() }
  }
}",
    );
}

#[test]
fn a_cause_needs_a_modality_and_a_place_behind_the_beginning() {
    let text = |assumption: &str| {
        world(&format!(
            "guarantee scenario G {{ user -> ctl.press() urgent ctl -> arm.go() arm -> ctl.done() }}
             assumption scenario A {{ {assumption} }}"
        ))
    };
    let labels = |assumption: &str| -> Vec<String> {
        let found = diagnostics_of(&text(assumption), Semantics::default());
        let uncaused = found.into_iter().filter(|one| one.code as u16 == 98);
        uncaused.flat_map(|one| one.labels.into_iter().map(|label| label.1)).collect()
    };
    assert_eq!(labels("ctl -> arm.go() arm -> ctl.done()"), ["this only waits for it: it has no modality"]);
    assert_eq!(
        labels("eventually arm -> ctl.done() ctl -> arm.go()"),
        ["this only starts the scenario when it happens"]
    );
    assert_eq!(labels("ctl -> arm.go() eventually arm -> ctl.done()"), Vec::<String>::new());
    assert_eq!(labels("ctl -> arm.go() monitored urgent arm -> ctl.done()"), Vec::<String>::new());
}

// 99: an assumption that is not needed.

#[test]
fn an_assumption_that_nothing_relies_on() {
    check_body(
        99,
        "guarantee scenario G { user -> ctl.press() urgent ctl -> arm.go() }
assumption scenario Once { user -> ctl.press() user -> ctl.stop() } constraints [ forbidden user -> ctl.press() ]
                    ~~~~ no guarantee needs assumption `C.Once`",
    );
}

#[test]
fn an_assumption_that_a_guarantee_relies_on() {
    check_body(
        99,
        "guarantee scenario G { user -> ctl.press() user -> ctl.stop() } constraints [ forbidden user -> ctl.press() ]
assumption scenario Once { user -> ctl.press() user -> ctl.stop() } constraints [ forbidden user -> ctl.press() ]",
    );
}

#[test]
fn an_assumption_that_was_to_cause_an_event() {
    let text = |scenario: &str| {
        format!(
            "guarantee scenario G {{ user -> ctl.press() urgent ctl -> arm.go() arm -> ctl.done() }}
{scenario}"
        )
    };
    let constraints = "constraints [ forbidden user -> ctl.press() ]";
    check_body(
        99,
        &text(&format!("assumption scenario A {{ ctl -> arm.go() arm -> ctl.done() }} {constraints}")),
    );
    let unrelated = "assumption scenario A { ctl -> arm.go() strict user -> ctl.stop() user -> ctl.press() }
                    ~ no guarantee needs assumption `C.A`";
    check_body(99, &text(unrelated));
}
