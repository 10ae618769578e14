//! Scripts as regression tests: `expect` lines.

use crate::support::{Run, scratch, sml, sml_reading};

/// A belt with two sides, an attribute of each type, and a role.
const CELL: &str = "specification Cell {
  domain d {
    enum Light { red, green }
    class Env { }
    class Part { }
    class Ctl { light: Light  level: 0..=3 = 1  busy: bool  last: Part  take(p: Part) stop() }
    class Arm { go(p: Part) }
  }
  object env: Env  object ctl: Ctl  object arm: Arm  object a: Part  object b: Part
  controllable { Ctl }
  effects {
    env -> ctl.take(p) { ctl.busy = true  ctl.last = p  ctl.light = green }
    ctl -> arm.go(p) { ctl.busy = false  ctl.level = 2 }
  }
  collaboration C {
    dynamic role Part r
    guarantee scenario Take { var Part p  env -> ctl.take(bind p)  urgent ctl -> arm.go(p) }
    guarantee scenario Follow bindings [ r = ctl.last ] { env -> ctl.take(*)  env -> ctl.stop() }
    guarantee scenario Once { ctl -> arm.go(a) strict env -> ctl.stop()  env -> ctl.take(b) }
  }
}";

#[track_caller]
fn play(test: &str, script: &str) -> Run {
    let folder = scratch(test);
    std::fs::write(folder.join("cell.sml"), CELL).expect("a file");
    std::fs::write(folder.join("cell.play"), script).expect("a file");
    let path = folder.display();
    sml(&format!("play {path}/cell.sml --script {path}/cell.play"))
}

/// A script in which everything holds.
#[track_caller]
fn holds(test: &str, script: &str) {
    let run = play(test, script);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{}", run.stdout);
}

/// A script in which exactly one line does not hold, and the lines that show the difference.
#[track_caller]
fn fails(test: &str, script: &str, line: usize, difference: &str) {
    let run = play(test, script);
    assert_eq!(run.code, 1, "{}{}", run.stdout, run.stderr);
    assert_eq!(run.stderr.matches("error[SML0109]").count(), 1, "{}", run.stderr);
    assert!(run.stderr.contains(&format!("cell.play:{line}:1")), "{}", run.stderr);
    let shown: Vec<&str> = run.stderr.lines().skip_while(|line| !line.contains("(+)")).skip(1).collect();
    let shown: Vec<&str> = shown.iter().map(|line| line.strip_prefix("          ").unwrap_or(line)).collect();
    assert_eq!(shown.join("\n"), difference, "{}", run.stderr);
}

/// A script that is refused before anything is played.
#[track_caller]
fn refused(test: &str, line: &str, message: &str) {
    let run = play(test, &format!("env -> ctl.take(a)\n{line}\n"));
    assert_eq!((run.code, run.stdout.as_str()), (2, ""), "{}", run.stderr);
    assert!(run.stderr.contains(&format!("error[SML0110]: {message}")), "{}", run.stderr);
    assert!(run.stderr.contains("cell.play:2:1"), "{}", run.stderr);
}

const TAKEN: &str = "env -> ctl.take(a)\n";

#[test]
fn everything_that_can_be_expected() {
    holds(
        "everything_that_can_be_expected",
        "expect turn environment
         expect enabled env->ctl.take( b ); env -> ctl.stop()
         expect only env -> ctl.take(b); env -> ctl.stop(); env -> ctl.take(a)
         expect not enabled ctl -> arm.go(a)
         expect ctl.light = red
         expect ctl.light = Light:red
         expect ctl.last == null
         expect ctl.busy = false
         expect not ctl.level = 2
         # a part comes
         env -> ctl.take(a)
         expect turn system
         expect not turn environment
         expect only ctl -> arm.go(a)
         expect ctl.last = a
         expect active C.Take
         expect active Follow[r=a]
         expect active C.Follow
         expect not active C.Follow[r=b]
         expect not active Once
         expect not violated Take; Follow
         ctl -> arm.go(a)
         expect ctl.level = 2
         expect active Once
         env -> ctl.take(b)
         expect violated Once
         expect turn nobody
         expect only
        ",
    );
}

#[test]
fn an_event_that_is_not_enabled() {
    let script = format!("{TAKEN}expect enabled env -> ctl.stop(); ctl -> arm.go(a)\n");
    fails("an_event_that_is_not_enabled", &script, 2, "- env -> ctl.stop()\n  ctl -> arm.go(a)");
}

#[test]
fn an_event_that_is_enabled() {
    let script = format!("{TAKEN}expect not enabled ctl -> arm.go(a)\n");
    fails("an_event_that_is_enabled", &script, 2, "+ ctl -> arm.go(a)");
}

#[test]
fn one_event_too_many() {
    let script = "expect only env -> ctl.stop(); env -> ctl.take(a)\n";
    let difference = "  env -> ctl.stop()\n  env -> ctl.take(a)\n+ env -> ctl.take(b)";
    fails("one_event_too_many", script, 1, difference);
}

#[test]
fn the_wrong_turn() {
    fails("the_wrong_turn", "expect turn system\n", 1, "- turn system\n+ turn environment");
}

#[test]
fn the_wrong_value() {
    let script = format!("{TAKEN}expect ctl.busy = false\n");
    fails("the_wrong_value", &script, 2, "- ctl.busy = false\n+ ctl.busy = true");
}

#[test]
fn no_violation() {
    fails("no_violation", &format!("{TAKEN}expect violated Once\n"), 2, "- C.Once");
}

#[test]
fn a_violation() {
    let script = format!("{TAKEN}ctl -> arm.go(a)\nenv -> ctl.take(b)\nexpect not violated Once\n");
    fails("a_violation", &script, 4, "+ C.Once");
}

#[test]
fn a_copy_that_is_not_there() {
    let script = format!("{TAKEN}expect active Follow[r=b]\n");
    fails("a_copy_that_is_not_there", &script, 2, "- C.Follow[r=b]\n  C.Take\n  C.Follow[r=a]");
}

#[test]
fn all_failures_are_shown_and_the_play_goes_on() {
    let run = play(
        "all_failures_are_shown",
        &format!(
            "expect turn system\n{TAKEN}expect turn environment\nctl -> arm.go(a)\nexpect ctl.level = 3\n"
        ),
    );
    assert_eq!(run.code, 1);
    assert_eq!(run.stderr.matches("error[SML0109]").count(), 3, "{}", run.stderr);
    assert!(run.stdout.contains("system: ctl -> arm.go(a)"), "{}", run.stdout);
}

#[test]
fn an_event_that_cannot_happen_is_shown_in_the_script() {
    let run = play("an_event_that_cannot_happen", &format!("{TAKEN}  ctl -> arm.go(b) # no\n"));
    assert_eq!(run.code, 1);
    assert!(run.stderr.contains("cell.play:2:3"), "{}", run.stderr);
    assert!(run.stderr.contains("error[SML0106]"), "{}", run.stderr);
}

#[test]
fn failures_as_json() {
    let folder = scratch("failures_as_json");
    std::fs::write(folder.join("cell.sml"), CELL).expect("a file");
    let run = sml_reading(
        &format!("play {}/cell.sml --format json --script /dev/stdin", folder.display()),
        b"env -> ctl.take(a)\nexpect turn environment\n",
    );
    assert_eq!(run.code, 1);
    let last = run.stdout.lines().last().expect("a document");
    let document: serde_json::Value = serde_json::from_str(last).expect("JSON");
    let diagnostic = &document["diagnostics"][0];
    assert_eq!((&diagnostic["code"], &diagnostic["line"]), (&"SML0109".into(), &2.into()));
}

#[test]
fn lines_that_mean_nothing() {
    refused("lines_1", "expect enabeld env -> ctl.stop()", "expected `enabled`, `only`, `turn`");
    refused("lines_2", "expect", "expected `enabled`");
    refused("lines_3", "expect enabled", "this expects nothing at all");
    refused("lines_4", "expect enabled env -> ctl.start()", "`ctl` has no operation `start`");
    refused("lines_5", "expect enabled env -> ctl.take(a, b)", "`take` takes 1 arguments, found 2");
    refused(
        "lines_16",
        "expect not enabled env -> ctl.take(arm)",
        "`p` can never be `arm`: its type is `Part`",
    );
    refused("lines_6", "expect enabled en -> ctl.stop()", "there is no object `en`");
    refused("lines_7", "expect enabled stop", "`stop` is no event");
    refused("lines_8", "expect turn nobodys", "expected `system`, `environment` or `nobody`");
    refused("lines_9", "expect ctl.lite = red", "`ctl` has no attribute `lite`");
    refused("lines_10", "expect ctl.light = blue", "`ctl.light` can never be `blue`: its type is `Light`");
    refused("lines_11", "expect ctl.level = 4", "`ctl.level` can never be `4`");
    refused("lines_12", "expect violated Twice", "there is no scenario `Twice`");
    refused("lines_13", "expect active Follow[q=a]", "`C.Follow` has no role `q`");
    refused("lines_14", "expect active Follow[r=c]", "there is no object `c`");
    refused("lines_15", "expect active Follow[r=a", "`Follow[r=a` lacks a `]`");
}

#[test]
fn an_object_may_be_called_expect() {
    let text = "specification S {
      domain d { class Env { } class Ctl { go() } }
      object expect: Env  object ctl: Ctl
      controllable { Ctl }
      collaboration C { guarantee scenario G { expect -> ctl.go()  expect -> ctl.go() } }
    }";
    let folder = scratch("an_object_may_be_called_expect");
    std::fs::write(folder.join("s.sml"), text).expect("a file");
    let script = b"expect -> ctl.go()\nexpect enabled expect -> ctl.go()\n";
    let run = sml_reading(&format!("play {}/s.sml --script /dev/stdin", folder.display()), script);
    assert_eq!(run.code, 0, "{}", run.stderr);
}
