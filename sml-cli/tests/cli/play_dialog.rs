//! `sml play` by commands, from a pipe as from a terminal.

use crate::support::{Run, scratch, sml, sml_reading};

#[track_caller]
fn play(name: &str, commands: &str) -> Run {
    sml_reading(&format!("play {name}/spec.sml"), commands.as_bytes())
}

/// What is shown last, from the empty line before the state on.
fn last_state(run: &Run) -> &str {
    run.stdout.rsplit("\n\n").next().unwrap_or_default().trim_start()
}

#[test]
fn the_state_is_shown_with_reasons() {
    let run = play("memory", "control -> lamp.red()\n");
    assert_eq!(run.code, 0, "{}", run.stderr);
    let expect = "\
active:
  Memory.ClockTicks
    memory/spec.sml:10 | assumption scenario ClockTicks { while { eventually clock -> control.tick() } }
                       |                                          ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
  Memory.RedAgainAndAgain
    memory/spec.sml:12 | while { eventually control -> lamp.red()  clock -> control.tick() }
                       |                                           ^^^^^^^^^^^^^^^^^^^^^^^
  Memory.GreenAgainAndAgain
    memory/spec.sml:15 | while { eventually control -> lamp.green()  clock -> control.tick() }
                       |         ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
  Memory.OneAtATick
    memory/spec.sml:20 | strict clock -> control.tick()
                       | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
turn of the environment, case 6: the system has nothing to send
   1  clock -> control.tick()   wanted by Memory.ClockTicks (memory/spec.sml:10); awaited by \
Memory.RedAgainAndAgain (memory/spec.sml:12), Memory.OneAtATick (memory/spec.sml:20)
   -  control -> lamp.green()   wanted by Memory.GreenAgainAndAgain (memory/spec.sml:15); would violate \
Memory.OneAtATick (memory/spec.sml:20): this is due first
";
    assert_eq!(last_state(&run), expect);
}

#[test]
fn places_of_one_line_are_marked_together() {
    let run = play("memory", "");
    let line = "alternative { control -> lamp.red() } or { control -> lamp.green() }";
    let mark = "              ^^^^^^^^^^^^^^^^^^^^^        ^^^^^^^^^^^^^^^^^^^^^^^";
    assert!(run.stdout.contains(&format!("{line}\n                       | {mark}\n")), "{}", run.stdout);
}

#[test]
fn a_number_is_a_choice() {
    let run = play("memory", "2\n1\n3\n");
    assert_eq!(run.code, 0, "{}", run.stderr);
    let events: Vec<&str> =
        run.stdout.lines().filter(|line| line.starts_with("system:") || line.starts_with("env")).collect();
    assert_eq!(
        events,
        ["system: control -> lamp.red()", "environment: clock -> control.tick()", "system: yield"]
    );
    for wrong in ["0\n", "4\n", "99999999999999999999\n"] {
        let run = play("memory", wrong);
        assert_eq!(run.code, 1, "{wrong}");
        assert!(run.stderr.contains("SML0106"), "{}", run.stderr);
    }
}

#[test]
fn changed_attributes_say_what_they_were() {
    let run = play("set_attribute", "1\n");
    let was: Vec<&str> = run.stdout.lines().filter(|line| line.contains("(was ")).collect();
    assert_eq!(was.len(), 1, "{}", run.stdout);
    let initial = run.stdout.split("turn of").next().unwrap_or_default();
    assert!(initial.contains("attributes:") && !initial.contains("(was "), "{initial}");
    let run = sml_reading("play set_attribute/spec.sml --color always", b"1\n");
    assert!(run.stdout.contains("\u{1b}[1m"), "{}", run.stdout);
}

#[test]
fn back_leads_to_the_state_before() {
    let forth = play("memory", "1\n1\n");
    let there_and_back = play("memory", "1\n1\n2\n1\nback 2\n");
    assert_eq!(last_state(&forth), last_state(&there_and_back));
    let to_the_start = play("memory", "1\n1\nback 17\n");
    assert_eq!(last_state(&to_the_start), last_state(&play("memory", "")));
    assert_eq!(play("memory", "back x\n").code, 2);
}

#[test]
fn back_takes_the_answers_back_too() {
    let there = sml_reading("play memory/spec.sml --strategy", b"1\n1\nback\n");
    let here = sml_reading("play memory/spec.sml --strategy", b"1\n");
    assert_eq!((there.code, last_state(&there)), (0, last_state(&here)));
}

#[test]
fn why_an_event_cannot_happen() {
    let run = play("memory", "1\nwhy control->lamp.red()\nwhy clock -> control.tick()\nwhy yield\n");
    assert_eq!(run.code, 0, "{}", run.stderr);
    let expect = "\
control -> lamp.red() cannot happen now
  wanted by Memory.RedAgainAndAgain (memory/spec.sml:12)
  would violate Memory.OneAtATick (memory/spec.sml:20): this is due first
clock -> control.tick() can happen now
  wanted by Memory.ClockTicks (memory/spec.sml:10)
  awaited by Memory.GreenAgainAndAgain (memory/spec.sml:15), Memory.OneAtATick (memory/spec.sml:20)
yield cannot happen now
  no active scenario wants it
  it is the turn of the environment, case 6: the system has nothing to send
";
    assert!(run.stdout.ends_with(expect), "{}", run.stdout);
    assert_eq!(play("memory", "why nobody -> knows.this()\n").code, 1);
    assert_eq!(play("memory", "why\n").code, 2);
}

#[test]
fn what_is_saved_replays() {
    let folder = scratch("what_is_saved_replays");
    let path = folder.join("red.play");
    let path = path.display();
    let saved = play("memory", &format!("2\n1\nyield\nsave {path}\n"));
    assert_eq!(saved.code, 0, "{}", saved.stderr);
    let text = std::fs::read_to_string(folder.join("red.play")).expect("a script");
    assert_eq!(text, "# a play of Memory\ncontrol -> lamp.red()\nclock -> control.tick()\nyield\n");
    let replayed = play("memory", &format!("1\nreplay {path}\n"));
    assert_eq!((replayed.code, last_state(&replayed)), (0, last_state(&saved)));
    assert_eq!(sml(&format!("play memory/spec.sml --script {path}")).code, 0);
    // What is there is not overwritten by mistake.
    assert_eq!(play("memory", &format!("save {path}\n")).code, 2);
    assert_eq!(std::fs::read_to_string(folder.join("red.play")).expect("a script"), text);
    assert_eq!(play("memory", &format!("save! {path}\n")).code, 0);
    assert_eq!(std::fs::read_to_string(folder.join("red.play")).expect("a script"), "# a play of Memory\n");
    assert_eq!(play("memory", &format!("save {}/no/where\n", folder.display())).code, 4);
    assert_eq!(play("memory", "save\n").code, 2);
}

#[test]
fn what_is_saved_against_the_controller_replays_against_it() {
    let folder = scratch("what_is_saved_against_the_controller");
    let path = folder.join("ticks.play");
    let path = path.display();
    let saved = sml_reading("play memory/spec.sml --strategy", format!("1\n1\nsave {path}\n").as_bytes());
    let replayed = sml(&format!("play memory/spec.sml --strategy --script {path}"));
    assert_eq!((saved.code, replayed.code), (0, 0), "{}", replayed.stderr);
    let events = |run: &Run| -> Vec<String> {
        let lines = run.stdout.lines();
        lines
            .filter(|line| line.starts_with("system:") || line.starts_with("env"))
            .map(str::to_owned)
            .collect()
    };
    assert_eq!(events(&saved), events(&replayed));
}

#[test]
fn a_replay_that_fails_says_where() {
    let folder = scratch("a_replay_that_fails");
    std::fs::write(folder.join("bad.play"), "control -> lamp.red()\nexpect turn system\n").expect("a file");
    let run = play("memory", &format!("replay {}/bad.play\n", folder.display()));
    assert_eq!(run.code, 1);
    assert!(run.stderr.contains("bad.play:2:1"), "{}", run.stderr);
    assert_eq!(play("memory", "replay no/such/file\n").code, 4);
    assert_eq!(play("memory", "replay -\n").code, 2);
}

#[test]
fn expectations_from_a_pipe() {
    assert_eq!(play("memory", "1\nexpect turn environment\n").code, 0);
    let run = play("memory", "1\nexpect turn system\n");
    assert_eq!(run.code, 1);
    assert!(run.stderr.contains("SML0109") && run.stderr.contains("+ turn environment"), "{}", run.stderr);
    assert_eq!(play("memory", "expect nonsense\n").code, 2);
}

#[test]
fn quit_ends_it_and_help_helps() {
    let run = play("memory", "help\nquit\nnonsense\n");
    assert_eq!(run.code, 0);
    for command in ["back", "save", "replay", "state", "why", "expect", "help", "quit"] {
        assert!(run.stdout.contains(&format!("\n  {command} ")), "{command}: {}", run.stdout);
    }
}

#[test]
fn objects_may_have_the_names_of_commands() {
    let text = "specification S {
      domain d { class Env { } class Ctl { go() } }
      object back: Env  object state: Ctl
      controllable { Ctl }
      collaboration C { guarantee scenario G { back -> state.go()  back -> state.go() } }
    }";
    let folder = scratch("objects_may_have_the_names_of_commands");
    std::fs::write(folder.join("s.sml"), text).expect("a file");
    let run =
        sml_reading(&format!("play {}/s.sml", folder.display()), b"back -> state.go()\nback->state.go()\n");
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert_eq!(run.stdout.matches("environment: back -> state.go()").count(), 2, "{}", run.stdout);
}

#[test]
fn commands_for_programs() {
    let run = sml_reading("play memory/spec.sml --format json", b"2\nstate\nwhy control -> lamp.green()\n");
    assert_eq!(run.code, 0, "{}", run.stderr);
    let lines: Vec<serde_json::Value> =
        run.stdout.lines().map(|line| serde_json::from_str(line).expect("an object a line")).collect();
    assert_eq!(lines.len(), 3);
    assert_eq!((&lines[1]["turn"], &lines[1]["case"]), (&"environment".into(), &6.into()));
    assert_eq!(lines[1]["copies"].as_array().expect("copies").len(), 4);
    let refused = &lines[2]["refused_by"][0];
    assert_eq!((&lines[2]["can_happen"], &refused["scenario"]), (&false.into(), &"Memory.OneAtATick".into()));
    assert_eq!(refused["line"], 20);
}

#[test]
fn why_takes_a_number() {
    let by_text = play("memory", "why control -> lamp.green()\n");
    let by_number = play("memory", "why 1\n");
    assert_eq!((by_number.code, &by_number.stdout), (0, &by_text.stdout), "{}", by_number.stderr);
    let run = play("memory", "why 9\n");
    assert_eq!(run.code, 1);
    assert!(run.stderr.contains("`9` is no event"), "{}", run.stderr);
}

#[test]
fn help_is_a_table_and_no_product() {
    let run = play("memory", "help\n");
    let lines: Vec<&str> = run.stdout.lines().rev().take(10).collect();
    assert!(lines.iter().all(|line| line.starts_with("  ") && !line.starts_with("   ")), "{lines:#?}");
    let run = sml_reading("play memory/spec.sml --format json", b"help\n");
    assert_eq!((run.code, run.stdout.as_str()), (0, ""));
    assert!(run.stderr.starts_with("  NUMBER"), "{}", run.stderr);
}

#[test]
fn expecting_nothing_is_a_mistake() {
    let run = play("memory", "expect\n");
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("or an attribute, found nothing"), "{}", run.stderr);
}
