//! Every published exit code, and the JSON that comes with it.

use crate::support::{command, finish, scratch, sml, sml_reading};
use std::process::Stdio;

/// Runs with text and with JSON; `diagnostic` is the code of the first JSON diagnostic.
#[track_caller]
fn check(arguments: &str, code: i32, diagnostic: &str) {
    let run = sml(arguments);
    assert_eq!(run.code, code, "{}{}", run.stdout, run.stderr);
    assert!(run.stdout.is_empty(), "{}", run.stdout);
    assert!(run.stderr.contains("error"), "{}", run.stderr);
    let run = sml(&format!("{arguments} --format json"));
    assert_eq!((run.code, run.diagnostic().as_str()), (code, diagnostic), "{}", run.stdout);
}

/// The same for a specification on stdin.
#[track_caller]
fn check_text(text: &[u8], code: i32, diagnostic: &str) {
    for subcommand in ["check", "synth", "graph", "export --target rust", "names --target iec"] {
        let run = sml_reading(&format!("{subcommand} -"), text);
        assert_eq!(run.code, code, "{subcommand}: {}", run.stderr);
        assert!(run.stdout.is_empty(), "{subcommand}: {}", run.stdout);
        let run = sml_reading(&format!("{subcommand} - --format=json"), text);
        assert_eq!((run.code, run.diagnostic().as_str()), (code, diagnostic), "{subcommand}");
    }
}

#[test]
fn unrealizable_is_1() {
    check("synth unreal_clash/spec.sml", 1, "SML0070");
    check("export unreal_clash/spec.sml --target iec", 1, "SML0070");
    assert_eq!(sml("check unreal_clash/spec.sml").code, 1);
}

#[test]
fn some_commands_do_not_ask_who_wins() {
    assert_eq!(sml("graph unreal_clash/spec.sml").code, 0);
    assert_eq!(sml("names unreal_clash/spec.sml --target iec").code, 0);
    assert_eq!(sml("names unreal_clash/spec.sml --target rust").code, 0);
    assert_eq!(sml_reading("play unreal_clash/spec.sml", b"").code, 0);
    assert_eq!(sml("play unreal_clash/spec.sml --strategy --script /dev/null").code, 0);
}

#[test]
fn wrong_texts_are_2() {
    check_text(b"", 2, "SML0010");
    check_text(b"// nothing\n", 2, "SML0010");
    check_text(b"{", 2, "SML0002");
    check_text(b"}", 2, "SML0002");
    check_text(b"\xff\xfe\x00", 2, "SML0012");
    check_text(b"import \"no_such.sml\" specification X { }", 2, "SML0033");
    check_text(b"specification X { }", 2, "SML0026");
}

#[test]
fn the_place_of_a_mistake() {
    let run = sml_reading("check - --format json", b"specification X {\n  controllable { A }\n}");
    let diagnostic = &run.json()["diagnostics"][0];
    let place = (&diagnostic["file"], &diagnostic["line"], &diagnostic["column"]);
    assert_eq!(place, (&"<stdin>".into(), &2.into(), &18.into()));
}

#[test]
fn mistakes_of_a_play_are_2() {
    let text = "specification Counter {
      domain d { class Env { } class Ctl { n: 0..=1 go() } }
      object env: Env  object ctl: Ctl
      controllable { Ctl }
      effects { env -> ctl.go() { ctl.n = ctl.n + 1 } }
      collaboration C { guarantee scenario S { env -> ctl.go() env -> ctl.go() } }
    }";
    check_text(text.as_bytes(), 2, "SML0050");
    let run = sml_reading("verify - memory/spec.sml --format json", text.as_bytes());
    assert_eq!((run.code, run.diagnostic().as_str()), (2, "SML0104"));
    let file = scratch("mistakes_of_a_play").join("counter.sml");
    std::fs::write(&file, text).expect("a file");
    let script = b"env -> ctl.go()\n";
    let run = sml_reading(&format!("play {}", file.display()), script);
    assert_eq!(run.code, 2, "{}", run.stderr);
    assert!(run.stderr.contains("SML0050") && run.stderr.contains("after this play"), "{}", run.stderr);
}

#[test]
fn wrong_usage_is_2() {
    for arguments in [
        "",
        "frobnicate",
        "check",
        "check --no-such-option memory/spec.sml",
        "check memory/spec.sml --threads 0",
        "check memory/spec.sml --max-states many",
        "check memory/spec.sml --max-memory 1X",
        "check memory/spec.sml --format yaml",
        "export memory/spec.sml",
        "export memory/spec.sml --target cobol",
        "export memory/spec.sml --target iec --check",
        "synth memory/spec.sml --minimize none --no-minimize",
        "cycle memory/spec.sml",
    ] {
        let run = sml(arguments);
        assert_eq!(run.code, 2, "{arguments}: {}", run.stderr);
        assert!(run.stdout.is_empty() && !run.stderr.is_empty(), "{arguments}");
    }
    check("check", 2, "SML0100");
    check("check --no-such-option memory/spec.sml", 2, "SML0100");
    check("check memory/spec.sml --threads 0", 2, "SML0100");
    check("explain SML9999", 2, "SML0100");
    check("verify - -", 2, "SML0100");
    check("play -", 2, "SML0100");
    check("export memory/spec.sml --target rust --drain", 2, "SML0100");
    check("names memory/spec.sml --target dot", 2, "SML0100");
    check("export memory/spec.sml --target dot --templates d", 2, "SML0100");
    check("export memory/spec.sml --target rust --retain", 2, "SML0100");
    check("export memory/spec.sml --target rust --check", 2, "SML0100");
    check("export memory/spec.sml --target iec --dialect iec", 2, "SML0100");
    check("export memory/spec.sml --target rust --dialect iec", 2, "SML0100");
    check("names memory/spec.sml --target codesys --dialect codesys", 2, "SML0100");
    check("cycle memory/spec.sml --stimulus /dev/null --minimize ordered", 2, "SML0100");
    check("export memory/spec.sml --target iec --minimize ordered", 2, "SML0100");
    check("export memory/spec.sml --target plcopen --minimize ordered", 2, "SML0100");
    check("export memory/spec.sml --target iec --monitor --owed", 2, "SML0100");
    for others in ["--minimize ordered", "--no-minimize", "--templates d"] {
        check(&format!("export memory/spec.sml --target rust --monitor {others}"), 2, "SML0100");
    }
    for command in ["export", "export --follow events", "names --follow events"] {
        check(&format!("{command} ../plants/tank.plant --target iec --monitor"), 2, "SML0100");
    }
}

#[test]
fn what_is_not_there_yet_is_2() {
    for target in ["ladder", "il", "svg", "html"] {
        check(&format!("export memory/spec.sml --target {target}"), 2, "SML0101");
        check(&format!("names memory/spec.sml --target {target}"), 2, "SML0101");
    }
}

#[test]
fn malformed_inputs_are_2() {
    check("verify memory/spec.sml memory/spec.sml", 2, "SML0104");
    check("verify memory/spec.sml /dev/null", 2, "SML0104");
    check("cycle memory/spec.sml --stimulus memory/spec.sml", 2, "SML0105");
    check("cycle memory/spec.sml --stimulus /dev/null --controller memory/spec.sml", 2, "SML0104");
}

#[test]
fn malformed_controllers_have_a_place() {
    let run = sml_reading("verify memory/spec.sml - --format json", b"{\n  \"version\": \"1\"\n}");
    let found = &run.json()["diagnostics"][0];
    assert_eq!(
        (&found["file"], &found["line"], &found["column"]),
        (&"<stdin>".into(), &2.into(), &16.into())
    );
    assert_eq!(found["message"], "`<stdin>`: invalid type: string \"1\", expected u32");
    let run = sml_reading("verify memory/spec.sml -", b"{\n  \"version\": \"1\"\n}");
    assert!(run.stderr.contains("--> <stdin>:2:16"), "{}", run.stderr);
}

#[test]
fn what_has_no_end_is_no_specification() {
    let run = sml("check /dev/zero");
    assert_eq!(run.code, 4);
    assert!(run.stderr.contains("larger than 16 MiB"), "{}", run.stderr);
    let run = sml_reading("check -", b"import \"/dev/zero\" import \"/\" specification X { }");
    assert_eq!(run.code, 2);
    for part in ["larger than 16 MiB", "Is a directory"] {
        assert!(run.stderr.contains(part), "{}", run.stderr);
    }
}

#[test]
fn limits_are_3() {
    for subcommand in ["check", "synth", "graph", "names --target iec", "export --target dot"] {
        check(&format!("{subcommand} production_cell/spec.sml --max-states 10"), 3, "SML0054");
    }
    check("check production_cell/spec.sml --max-memory 1K", 3, "SML0054");
    let run = sml("check production_cell/spec.sml --max-states 10");
    for part in ["the limit of 10 states", "states, ", "`--max-states`"] {
        assert!(run.stderr.contains(part), "{}", run.stderr);
    }
}

/// A specification in which `tell`, from the environment, and `ask`, from the controller, have a huge parameter.
fn huge(ranges: &str, scenario: &str) -> Vec<u8> {
    format!(
        "specification X {{
          domain {{
            class C {{ tell(x: 0..=4294967295) start() }}
            class E {{ ask(x: 0..=4294967295, y: 0..=4294967295) }}
          }}
          object c: C
          object e: E
          controllable {{ C }}
          {ranges}
          collaboration K {{ guarantee scenario S {{ {scenario} }} }}
        }}"
    )
    .into_bytes()
}

#[test]
fn too_many_events_are_3() {
    let everything = "e -> c.tell(*)";
    check_text(&huge("", everything), 3, "SML0054");
    check_text(&huge("", "e -> c.start() urgent c -> e.ask(*, *)"), 3, "SML0054");
    check_text(&huge("parameter ranges { C.tell(x = [0..4294967295]) }", everything), 2, "SML0028");
    let constant = sml_reading("check -", &huge("", "e -> c.tell(4294967295)"));
    assert_eq!(constant.code, 0, "{}", constant.stderr);
}

#[test]
fn limits_that_suffice_change_nothing() {
    let plain = sml("check memory/spec.sml --format json");
    let run = sml("check memory/spec.sml --format json --max-states 4 --max-memory 1G --threads 7");
    assert_eq!((run.code, run.stdout), (0, plain.stdout));
}

#[test]
fn files_that_cannot_be_opened_are_4() {
    for subcommand in ["check", "synth", "graph", "play", "names --target iec", "export --target rust"] {
        check(&format!("{subcommand} no_such.sml"), 4, "SML0102");
    }
    check("check memory", 4, "SML0102");
    check("verify memory/spec.sml no_such.json", 4, "SML0102");
    check("cycle memory/spec.sml --stimulus no_such.csv", 4, "SML0102");
    check("play memory/spec.sml --script no_such.txt", 4, "SML0102");
    assert!(sml("check ./no_such.sml").stderr.contains("`./no_such.sml`"));
}

#[test]
fn outputs_that_cannot_be_written_are_4() {
    check("synth memory/spec.sml -o no_such_folder/c.json", 4, "SML0103");
    check("export memory/spec.sml --target rust -o memory", 4, "SML0103");
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_device_is_4() {
    let full = std::fs::File::options().write(true).open("/dev/full").expect("Linux has one");
    let run = finish(command("graph memory/spec.sml").stdout(Stdio::from(full)));
    assert_eq!(run.code, 4, "{}", run.stderr);
}

#[test]
fn a_reader_that_has_seen_enough_is_no_failure() {
    for arguments in ["graph production_cell/spec.sml", "check memory/spec.sml", "explain", "--help"] {
        let mut command = command(arguments);
        let mut child = command
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("it runs");
        drop(child.stdout.take());
        let output = child.wait_with_output().expect("it ends");
        assert_eq!(output.status.code(), Some(0), "{arguments}");
        assert!(output.stderr.is_empty(), "{arguments}: {}", String::from_utf8_lossy(&output.stderr));
    }
}

#[test]
fn help_and_version_are_0() {
    for arguments in ["--help", "--version", "help", "check --help", "export -h"] {
        assert_eq!(sml(arguments).code, 0, "{arguments}");
    }
}

#[test]
fn explanations_of_codes() {
    let run = sml("explain sml0007");
    assert_eq!(run.code, 0);
    assert!(run.stdout.starts_with("SML0007: "), "{}", run.stdout);
    assert_eq!(sml("explain SML0007 --format json").json()["code"], "SML0007");
    for name in ["7", "sml7", "0007"] {
        assert_eq!(sml(&format!("explain {name}")).stdout, run.stdout);
    }
    assert!(sml("explain 19").stderr.contains("the nearest is SML0020"), "{}", sml("explain 19").stderr);
    let all = sml("explain").stdout;
    assert!(all.lines().all(|line| line.starts_with("SML")) && all.lines().count() > 20, "{all}");
}

#[test]
fn mistakes_in_names_and_types_come_with_help() {
    let text = include_str!("../../../tests/specs/memory/spec.sml");
    for (from, to, code) in [
        ("control -> lamp.red()", "control -> lamp.extinguish()", "SML0020"),
        ("control -> lamp.red()", "control -> lamp.red(1)", "SML0023"),
        ("while { eventually control", "while [1] { eventually control", "SML0022"),
    ] {
        assert!(text.contains(from));
        let run = sml_reading("check - --format json", text.replacen(from, to, 1).as_bytes());
        assert_eq!((run.code, run.diagnostic()), (2, code.to_owned()), "{to}");
        let notes = run.json()["diagnostics"][0]["notes"].to_string();
        assert!(notes.contains("help: "), "{to}: {notes}");
    }
}
