//! `sml check` and `sml supervise` of plants.

use crate::support::{Run, plant, plant_text, scratch, sml, sml_reading};
use serde_json::{Value, json};
use std::fs;

/// The distribution station.
fn station() -> String {
    plant("distribution_station")
}

/// The feedback where the boom is at the dock, as published: injector, barrel and hook, then what is inhibited.
const AT_THE_DOCK: [(&str, &str); 14] = [
    ("I2B BE HF", "inject right grab"),
    ("I2B BF HF", "inject grab"),
    ("I2B BF HH", "inject rls"),
    ("I2B BE HH", "inject right rls"),
    ("I2D BF HF", "reset right"),
    ("I2D BE HF", "reset right"),
    ("I2D BF HG", "reset right"),
    ("I2D BE HG", "reset right"),
    ("I2D BF HH", "right rls"),
    ("I2D BE HH", "right rls"),
    ("IMB BF HF", "grab"),
    ("IMB BE HF", "grab"),
    ("IMB BF HH", "rls"),
    ("IMB BE HH", "rls"),
];

fn sorted(words: &str) -> Vec<&str> {
    let mut words: Vec<&str> = words.split(' ').collect();
    words.sort_unstable();
    words
}

#[test]
fn the_published_feedback() {
    let run = sml(&format!("supervise {} --format json", station()));
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    let found = run.json();
    for (figure, value) in
        [("version", 1), ("plant_states", 128), ("plant_transitions", 512), ("entries", 52)]
    {
        assert_eq!(found[figure], value, "{figure}");
    }
    let feedback = found["feedback"].as_array().expect("entries");
    assert_eq!(feedback.len(), 52);
    let mut rows = 0;
    for entry in feedback.iter().filter(|entry| entry["state"]["Boom"] == "B2D") {
        let state =
            ["Injector", "Barrel", "Hook"].map(|name| entry["state"][name].as_str().expect("a state"));
        let row = AT_THE_DOCK.iter().find(|row| row.0 == state.join(" ")).expect("a row");
        let mut inhibited: Vec<&str> =
            entry["inhibited"].as_array().expect("events").iter().filter_map(Value::as_str).collect();
        inhibited.sort_unstable();
        assert_eq!(inhibited, sorted(row.1), "{}", row.0);
        rows += 1;
    }
    assert_eq!(rows, 14);
}

/// Rungs, instructions, and the depth of the stack.
fn size(options: &str) -> [u64; 3] {
    let found = sml(&format!("supervise {} --format json {options}", station())).json();
    ["rungs", "instructions", "stack_depth"].map(|name| found[name].as_u64().expect("a number"))
}

#[test]
fn the_program_is_no_larger_than_the_published_one() {
    let [rungs, instructions, depth] = size("");
    assert!(rungs == 6 && instructions <= 92 && depth <= 3, "{instructions}, {depth}");
    let [rungs, two_level, depth] = size("--two-level");
    assert!(rungs == 6 && instructions < two_level && two_level <= 116 && depth <= 2, "{two_level}, {depth}");
    let free = size("--dont-care all")[1];
    let decodable = size("--dont-care decodable")[1];
    assert!(free < decodable && decodable <= instructions, "{free}, {decodable}");
    assert_eq!(size("--dont-care none"), size(""));
    assert!(size("--share")[1] <= instructions);
    assert!(size("--extract")[1] > instructions);
}

/// Whether a formula without parentheses holds for what is on.
fn holds(formula: &str, is_on: &dyn Fn(&str) -> bool) -> bool {
    let literal =
        |literal: &str| literal.strip_prefix('!').map_or_else(|| is_on(literal), |name| !is_on(name));
    formula.split(" || ").any(|term| term.split(" && ").all(literal))
}

/// The formula of `right` holds exactly in the rows that do not inhibit it.
#[test]
fn a_formula_is_true_where_its_event_is_enabled() {
    let found = sml(&format!("supervise {} --format json", station())).json();
    let formula = found["formulas"]["right"].as_str().expect("a formula");
    let on = |state: &str| match state {
        "I2B" => "X0",
        "I2D" => "Y2 X1",
        "BE" => "X6",
        "HG" => "Y4",
        "HH" => "X5",
        _ => "",
    };
    for (state, inhibited) in AT_THE_DOCK {
        let on: Vec<&str> = state.split(' ').flat_map(|state| on(state).split(' ')).chain(["X2"]).collect();
        let expected = !inhibited.contains("right");
        assert_eq!(holds(formula, &|name| on.contains(&name)), expected, "{state}: {formula}");
    }
}

#[test]
fn an_equivalent_constraint_gives_the_same_feedback() {
    let text = plant_text("distribution_station");
    let other =
        text.replace(" && !Injector.IMD\n", "\n    constraint Away: never Injector.IMD && !Boom.B2T\n");
    assert_ne!(text, other);
    let feedback =
        |text: &str| sml_reading("supervise - --format json", text.as_bytes()).json()["feedback"].clone();
    assert_eq!(feedback(&text), feedback(&other));
}

#[test]
fn figures_of_a_check() {
    let run = sml(&format!("check {} --format json", station()));
    let expected = json!({
        "version": 1, "realizable": true, "plant_states": 128, "plant_transitions": 512,
        "constrained_states": 52, "constrained_transitions": 123, "entries": 52, "diagnostics": [],
    });
    assert_eq!((run.code, run.json()), (0, expected));
    let run = sml(&format!("check {}", station()));
    assert!(run.stdout.starts_with("DistributionStation: realizable\n"), "{}", run.stdout);
    assert!(sml(&format!("check {} --timings", station())).stderr.contains("supervise"));
}

#[test]
fn the_same_from_stdin() {
    let text = format!("// A plant.\n/* plant */\n{}", plant_text("cat_and_mouse"));
    let [from_file, from_stdin] = [
        sml(&format!("supervise {} --format json", plant("cat_and_mouse"))),
        sml_reading("supervise - --format json", text.as_bytes()),
    ];
    assert_eq!((from_stdin.code, from_stdin.stdout), (0, from_file.stdout));
    assert_eq!(sml_reading("check - --format json", text.as_bytes()).json()["entries"], 6);
}

#[test]
fn an_output_is_written_whole_or_not_at_all() {
    let folder = scratch("an_output_of_supervise");
    let path = folder.join("out");
    let out = path.display();
    for format in ["text", "json"] {
        let run = sml(&format!("supervise {} --format {format} -o {out}", station()));
        assert_eq!((run.code, run.stdout.as_str()), (0, ""), "{}", run.stderr);
        let printed = sml(&format!("supervise {} --format {format}", station())).stdout;
        assert_eq!(fs::read_to_string(&path).expect("it is written"), printed);
    }
    fs::write(&path, "old").expect("a file");
    assert_eq!(sml(&format!("supervise {} -o {out} --max-states 10", station())).code, 3);
    assert_eq!(
        sml(&format!("supervise {} -o {out} --deny-warnings", folder.join("no.plant").display())).code,
        4
    );
    assert_eq!(fs::read_to_string(&path).expect("a file"), "old");
    let copy = folder.join("own.plant");
    fs::copy(crate::support::specs().join(station()), &copy).expect("a copy");
    assert_eq!(sml(&format!("supervise {0} -o {0}", copy.display())).code, 2);
}

/// A press that may break while it works, and must not; `burst` is what breaks it.
fn press(burst: &str) -> String {
    format!(
        "plant Oven {{
  output Close input Closed, Cracked
  controllable press {{ set Close }}
  {burst} burst
  automaton Press {{
    initial state Open [!Close && !Cracked] {{ press -> Works }}
    marked state Works [Close && !Cracked] {{ burst -> Broken }}
    state Broken [Cracked]
  }}
  constraint Whole: never Press.Broken
}}
"
    )
}

/// Runs it with text and with JSON.
#[track_caller]
fn refused(arguments: &str, text: &str, code: i32, diagnostic: &str) -> Run {
    let run = sml_reading(arguments, text.as_bytes());
    assert_eq!(run.code, code, "{}{}", run.stdout, run.stderr);
    let json = sml_reading(&format!("{arguments} --format json"), text.as_bytes());
    assert_eq!((json.code, json.diagnostic().as_str()), (code, diagnostic), "{}", json.stdout);
    run
}

#[test]
fn without_a_feedback_it_is_1_with_the_play() {
    let text = press("uncontrollable");
    for arguments in ["supervise -", "export - --target il", "export - --target dot", "supervise - --modular"]
    {
        let run = refused(arguments, &text, 1, "SML0140");
        assert!(run.stdout.is_empty() && run.stderr.contains("press  (the controller)"), "{}", run.stderr);
    }
    let run = refused("check -", &text, 1, "SML0140");
    assert!(run.stdout.contains("burst  (the plant, and nobody can prevent it)"), "{}", run.stdout);
    assert!(run.stdout.ends_with("Oven: not realizable\n"), "{}", run.stdout);
    let found = sml_reading("check - --format json", text.as_bytes()).json();
    assert_eq!((&found["realizable"], &found["entries"]), (&json!(false), &Value::Null));
    let explanation = &found["explanation"];
    let expected = json!({
        "cause": "never", "constraints": ["Whole"], "unmarked": [], "play": ["press", "burst"],
        "steps": [
            { "event": "press", "side": "system", "forced": false },
            { "event": "burst", "side": "environment", "forced": true },
        ],
        "state": { "Press": "Broken" },
    });
    assert_eq!(*explanation, expected);
    assert_eq!(
        (&found["diagnostics"][0]["line"], &found["diagnostics"][0]["column"]),
        (&json!(10), &json!(14))
    );
}

#[test]
fn wrong_plants_are_2_at_their_place() {
    for (text, code) in [
        ("plant P {", "SML0002"),
        ("plant P { output A controllable on { set B } automaton X { initial state S } }", "SML0020"),
        ("plant P { output A input B automaton X { initial state S [A] state T [B] } }", "SML0135"),
        ("plant P { output A automaton X { initial state S [A] state T } }", "SML0133"),
    ] {
        for arguments in ["check -", "supervise -", "export - --target ladder"] {
            refused(arguments, text, 2, code);
        }
    }
    let run = sml_reading(
        "check - --format json",
        b"plant P {\n  controllable on { set B } automaton X { initial state S }\n}",
    );
    let found = &run.json()["diagnostics"][0];
    assert_eq!(
        (&found["file"], &found["line"], &found["column"]),
        (&json!("<stdin>"), &json!(2), &json!(25))
    );
}

#[test]
fn files_that_are_no_text_or_not_there() {
    let folder = scratch("plants_that_are_no_text");
    for (bytes, code, diagnostic) in
        [(&b""[..], 2, "SML0010"), (b"plant \xff", 2, "SML0012"), (b"p\0l\0", 2, "SML0012")]
    {
        let path = folder.join("p.plant");
        fs::write(&path, bytes).expect("a file");
        for subcommand in ["check", "supervise", "play", "export --target il", "names --target rust"] {
            let run = sml(&format!("{subcommand} {} --format json", path.display()));
            assert_eq!((run.code, run.diagnostic().as_str()), (code, diagnostic), "{subcommand}");
        }
    }
    for subcommand in ["check", "supervise", "play", "export --target il", "names --target rust"] {
        let run = sml(&format!("{subcommand} no_such.plant --format json"));
        assert_eq!((run.code, run.diagnostic().as_str()), (4, "SML0102"), "{subcommand}");
        let run = sml(&format!("{subcommand} {} --format json --max-states 10", station()));
        assert_eq!((run.code, run.diagnostic().as_str()), (3, "SML0054"), "{subcommand}");
    }
}

#[test]
fn what_means_nothing_to_plants_is_2() {
    let station = station();
    for arguments in [
        format!("synth {station}"),
        format!("graph {station}"),
        format!("verify {station} x.json"),
        format!("cycle {station} --stimulus x.csv"),
        format!("check {station} --classic"),
        format!("check {station} --sequence -"),
        format!("play {station} --strategy"),
        format!("export {station} --target iec --trigger level"),
        format!("export {station} --target rust --engine comb"),
        format!("export {station} --target il --no-minimize"),
        format!("export {station} --target il --of loop"),
        format!("export {station} --target dot --of ladder"),
        format!("export {station} --target case"),
        format!("export {station} --target iec --check"),
        format!("names {station} --target svg"),
        "export memory/spec.sml --target dot --of loop".to_owned(),
        "export memory/spec.sml --target rust --share".to_owned(),
        "export memory/spec.sml --target rust --dont-care none".to_owned(),
    ] {
        let run = sml(&format!("{arguments} --format json"));
        assert_eq!((run.code, run.diagnostic().as_str()), (2, "SML0100"), "{arguments}");
    }
    assert_eq!(sml(&format!("export {station} --target html --format json")).diagnostic(), "SML0101");
}

#[test]
fn warnings_are_shown_denied_and_allowed() {
    let text = plant_text("distribution_station").replacen("X6\n", "X6, Spare\n", 1);
    let run = sml_reading("check - --format json", text.as_bytes());
    let code = run.diagnostic();
    assert_eq!((run.code, run.json()["diagnostics"][0]["severity"].as_str()), (0, Some("warning")));
    for arguments in ["check -", "supervise -", "export - --target il"] {
        let run = sml_reading(arguments, text.as_bytes());
        assert!(run.code == 0 && format!("{}{}", run.stdout, run.stderr).contains("Spare"), "{}", run.stderr);
        for denied in [format!("--deny {code}"), "--deny-warnings".to_owned()] {
            assert_eq!(sml_reading(&format!("{arguments} {denied}"), text.as_bytes()).code, 1, "{arguments}");
        }
        let run = sml_reading(&format!("{arguments} --deny-warnings --allow {code}"), text.as_bytes());
        assert!(run.code == 0 && !run.stderr.contains("warning"), "{}", run.stderr);
    }
}

/// Controllers that only follow events need no signals.
#[test]
fn a_plant_without_signals_has_a_feedback_and_no_formulas() {
    let found = sml(&format!("supervise {} --format json", plant("cat_and_mouse"))).json();
    assert_eq!((&found["entries"], &found["formulas"]), (&json!(6), &json!({})));
    for figure in ["instructions", "stack_depth", "rungs"] {
        assert!(found[figure].is_null(), "{figure}");
    }
    assert_eq!(sml(&format!("export {} --target svg", plant("cat_and_mouse"))).code, 0);
    for target in ["ladder", "il", "iec", "rust", "plcopen", "svg --of ladder"] {
        let run = sml(&format!("export {} --target {target} --format json", plant("cat_and_mouse")));
        assert_eq!((run.code, run.diagnostic().as_str()), (2, "SML0108"), "{target}");
    }
}

#[test]
fn memory_has_rungs_of_its_own() {
    let found = sml(&format!("supervise {} --format json", plant("chute"))).json();
    assert!(found["rungs"].as_u64() > Some(4), "{found}");
    assert!(found["formulas"]["fetch"].as_str().expect("a formula").contains("Content_"));
}

/// Ranges of one analogue input that do not overlap never hold together, so states can be told apart by them.
#[test]
fn ranges_tell_states_apart() {
    let run = sml(&format!("supervise {} --format json", plant("tank")));
    assert_eq!(run.code, 0, "{}", run.stdout);
    let formula = run.json()["formulas"]["open"].as_str().expect("a formula").to_owned();
    let enabled = |on: &[&str]| holds(&formula, &|name| on.contains(&name));
    // The level rises only while the inlet is open.
    assert!(enabled(&["Low"]) && enabled(&[]), "{formula}");
    assert!(!enabled(&["High"]) && !enabled(&["Inlet"]), "{formula}");
    let text = sml(&format!("export {} --target il", plant("tank"))).stdout;
    let is_instruction = |line: &&str| !line.is_empty() && !line.starts_with("(*");
    assert_eq!(text.lines().filter(is_instruction).count() as u64, run.json()["instructions"]);
}

/// A guard that must be down while the saw runs; `rests` and `runs` are how its blade is read.
fn saw(rests: &str, runs: &str, constraint: &str) -> String {
    format!(
        "plant Saw {{
  output Motor, Guard input Running
  controllable start {{ set Motor }}
  controllable lift {{ set Guard }}
  automaton Blade {{
    initial state Rests [{rests}] {{ start -> Runs }}
    state Runs [{runs}]
  }}
  automaton Cover {{ initial state Down [!Guard] {{ lift -> Up }} state Up [Guard] }}
  constraint Safe: {constraint}
}}
"
    )
}

/// Until the sensor answers both events could fire.
#[test]
fn a_command_that_nobody_sees_is_2_at_its_edge() {
    let text = saw("!Running", "Running", "never Blade.Runs && Cover.Up");
    for arguments in ["check -", "supervise -", "export - --target ladder", "names - --target iec"] {
        let run = refused(arguments, &text, 2, "SML0137");
        assert!(run.stderr.contains("add `!Motor` to the formula of `Rests`"), "{}", run.stderr);
    }
    let found = sml_reading("check - --format json", text.as_bytes()).json();
    let place = &found["diagnostics"][0];
    assert_eq!((&place["line"], &place["column"]), (&json!(6), &json!(38)));
    let text = saw("!Motor && !Running", "Motor", "never Blade.Runs && Cover.Up");
    assert_eq!(sml_reading("check - --deny-warnings", text.as_bytes()).code, 0);
}

#[test]
fn an_event_that_is_never_enabled_is_warned_of() {
    let text = saw("!Motor", "Motor", "start only when Blade.Runs");
    for arguments in ["check -", "supervise -", "export - --target il", "export - --target svg"] {
        let run = sml_reading(arguments, text.as_bytes());
        let shown = format!("{}{}", run.stdout, run.stderr);
        assert!(run.code == 0 && shown.contains("`start` is never enabled"), "{shown}");
        assert!(shown.contains("forbids it in 2 of them"), "{shown}");
        assert_eq!(
            sml_reading(&format!("{arguments} --deny SML0144"), text.as_bytes()).code,
            1,
            "{arguments}"
        );
        let run = sml_reading(&format!("{arguments} --deny-warnings --allow 144,97"), text.as_bytes());
        assert!(run.code == 0 && !run.stderr.contains("warning"), "{}", run.stderr);
    }
    let found = sml_reading("check - --allow 97 --format json", text.as_bytes()).json();
    assert_eq!(found["diagnostics"].as_array().map(Vec::len), Some(1));
    let warning = &found["diagnostics"][0];
    assert_eq!(
        (&warning["code"], &warning["line"], &warning["column"]),
        (&json!("SML0144"), &json!(3), &json!(16))
    );
}

#[test]
fn supervise_says_what_takes_specifications() {
    let run = sml("supervise memory/spec.sml");
    assert!(run.code == 2 && run.stderr.contains("`memory/spec.sml` is no plant"), "{}", run.stderr);
    assert!(run.stderr.contains("write `sml check` or `sml synth`"), "{}", run.stderr);
    let run = sml(&format!("synth {}", station()));
    assert!(run.code == 2 && run.stderr.contains("write `sml check`, `sml supervise`"), "{}", run.stderr);
}
