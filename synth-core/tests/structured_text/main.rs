//! The Structured Text back end, seen from outside: what stands in the text is what stood in the tables.

mod fixture;
mod reader;

use fixture::{any_options, any_tables, event, lamp};
use std::collections::BTreeSet;

use proptest::prelude::*;
use reader::{Arrays, arrays, lint, tokens, without_comments};
use synth_core::controller::Event;
use synth_core::controller::tables::{EventTable, Mapping, Requirement, Tables};
use synth_core::emit::st::{self, Encoding, Integers, Options, Target, Trigger, Unexpected, Unfit};

fn written(tables: &Tables, options: &Options) -> String {
    st::text(tables, options).expect("the fixture fits")
}

/// Takes an array out of those that were found; its upper bound is the last index.
#[track_caller]
fn take(found: &mut Arrays, name: &str) -> Vec<u32> {
    let (bound, values) = found.remove(name).unwrap_or_else(|| panic!("no array {name}"));
    assert_eq!(bound + 1, values.len(), "upper bound of {name}");
    values
}

/// Every array of the text is one of the tables and holds its numbers, and none is missing.
#[track_caller]
fn check_arrays(tables: &Tables, text: &str, options: &Options) {
    let mut found: Arrays = arrays(text);
    match options.encoding {
        Encoding::Rows => check_rows(tables, &mut found, &st::names(tables, options)),
        Encoding::Runs => check_runs(tables, text, &mut found),
    }
    assert!(found.is_empty(), "left over: {found:?}");
}

#[track_caller]
fn check_rows(tables: &Tables, found: &mut Arrays, names: &st::NameMap) {
    for (table, (_, input)) in tables.events.iter().zip(&names.events) {
        if !table.mapping.source.is_empty() {
            assert_eq!(take(found, &format!("{input}_source")), table.mapping.source);
            assert_eq!(take(found, &format!("{input}_target")), table.mapping.target);
        }
    }
    if !tables.super_steps.source.is_empty() {
        assert_eq!(take(found, "source"), tables.super_steps.source);
        assert_eq!(take(found, "target"), tables.super_steps.target);
        for component in &tables.components {
            assert_eq!(take(found, &format!("{}Target", component.object)), component.codes);
        }
    }
}

/// Runs, written out row by row, give the tables.
#[track_caller]
fn check_runs(tables: &Tables, text: &str, found: &mut Arrays) {
    let has_rows = tables.events.iter().any(|table| !table.mapping.source.is_empty());
    if !has_rows && tables.super_steps.source.is_empty() {
        return;
    }
    let (state, row, target) = (take(found, "run_state"), take(found, "run_row"), take(found, "target"));
    let written_out = |runs: std::ops::Range<u32>, base: u32| {
        let mut mapping = Mapping::default();
        for run in runs.start as usize..runs.end as usize {
            for at in row[run]..row[run + 1] {
                mapping.source.push(state[run] + at - row[run]);
                mapping.target.push(base + target[at as usize]);
            }
        }
        mapping
    };
    let mut super_steps = 0;
    if has_rows {
        let (first, base) = (take(found, "event_run"), take(found, "event_base"));
        for (event, table) in tables.events.iter().enumerate() {
            assert_eq!(written_out(first[event]..first[event + 1], base[event]), table.mapping);
        }
        super_steps = first[tables.events.len()];
    }
    let base = text.split("state := ").find_map(|rest| rest.split_once(" + ")?.0.parse().ok());
    let end = state.len() as u32;
    assert_eq!(written_out(super_steps..end, base.unwrap_or(0)), tables.super_steps);
    if super_steps < end {
        for component in &tables.components {
            let codes = take(found, &format!("{}Target", component.object)).into_iter();
            let lengths = (super_steps as usize..end as usize).map(|run| row[run + 1] - row[run]);
            let codes = codes.zip(lengths).flat_map(|(code, rows)| vec![code; rows as usize]);
            assert_eq!(codes.collect::<Vec<_>>(), component.codes);
        }
    }
}

proptest! {
    #[test]
    fn arrays_hold_the_tables(tables in any_tables(), options in any_options()) {
        match st::text(&tables, &options) {
            Ok(text) => {
                lint(&text);
                if options.target != Target::Case {
                    check_arrays(&tables, &text, &options);
                }
            }
            Err(unfit) => prop_assert!(options.drain && matches!(unfit, Unfit::EndlessDrain { .. }), "{unfit}"),
        }
    }

    #[test]
    fn names_are_unique_identifiers(texts in prop::collection::btree_set("[a-c_]{1,2} -> [a-c]{1,2}\\.(x|END_IF|X)\\((-?[0-9]|a{70})?\\)", 0..20)) {
        let mut tables = lamp();
        tables.events = texts.iter().map(|text| fixture::table(text, &[], &[])).collect();
        let names = st::names(&tables, &Options::default());
        let inputs: std::collections::BTreeSet<_> = names.events.iter().map(|(_, input)| input.to_uppercase()).collect();
        prop_assert_eq!(inputs.len(), texts.len());
        for (_, input) in &names.events {
            let characters = input.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
            let underscores = !input.contains("__") && !input.starts_with('_') && !input.ends_with('_');
            prop_assert!(characters && underscores && input.len() <= 63, "{}", input);
        }
    }
}

#[test]
fn deterministic() {
    assert_eq!(written(&lamp(), &Options::default()), written(&lamp(), &Options::default()));
}

/// The text is the one in `snapshots`, but for lines with the version. `SML_BLESS=1` writes it anew.
#[track_caller]
fn check_snapshot(name: &str, text: &str) {
    let with_version = |line: &str| {
        ["Generator: ", "Generated by ", "Written once "]
            .iter()
            .any(|start| line.trim_start().strip_prefix("(* ").is_some_and(|line| line.starts_with(start)))
    };
    let lines: Vec<&str> = text.lines().filter(|line| !with_version(line)).collect();
    let found = lines.join("\n") + "\n";
    let path = format!("{}/tests/structured_text/snapshots/{name}.st", env!("CARGO_MANIFEST_DIR"));
    if std::env::var_os("SML_BLESS").is_some() {
        std::fs::write(&path, &found).expect("the snapshot can be written");
    }
    let expected = std::fs::read_to_string(&path).expect("the snapshot exists");
    assert!(found == expected, "differs from {path}:\n{found}");
}

/// The whole text for every target.
#[test]
fn snapshots() {
    for target in Target::ALL {
        check_snapshot(target.name(), &written(&lamp(), &Options { target, ..Options::default() }));
    }
}

/// The lamp says when it is lit, after it was commanded to, and when it is broken, which nobody promises.
fn talking_lamp() -> Tables {
    let mut tables = lamp();
    for text in ["lamp -> control.broken()", "lamp -> control.lit()"] {
        let event = Event::from_text(text).expect("an event");
        tables.events.push(EventTable { event, mapping: Mapping::default() });
    }
    tables.owed = vec![vec![0], vec![], vec![1, 3], vec![]];
    tables
}

/// All that can be asked for, and the template of a secondary, in both ways to write blocks.
#[test]
fn snapshots_of_options_and_templates() {
    for target in [Target::Iec, Target::Siemens] {
        let unexpected = Unexpected::Fault;
        let options = Options { target, owed: true, retain: true, unexpected, ..Options::default() };
        check_snapshot(&format!("{}_owed_retain", target.name()), &written(&talking_lamp(), &options));
        let templates = st::templates(&talking_lamp(), &options).expect("it fits");
        let [template] = &templates[..] else { panic!("{templates:?}") };
        lint(&template.text);
        check_snapshot(&format!("{}_secondary", target.name()), &template.text);
    }
}

#[test]
fn what_retaining_takes_is_said_where_it_is_asked_for() {
    for target in Target::ALL {
        for retain in [false, true] {
            let text = written(&lamp(), &Options { target, retain, ..Options::default() });
            let says = text.contains("the whole instance in retained memory");
            assert_eq!(says, retain && matches!(target, Target::Codesys | Target::Twincat), "{text}");
        }
    }
}

/// TIA Portal takes a text without a byte order mark for one in the code page of Windows.
#[test]
fn only_scl_with_other_characters_than_ascii_has_a_byte_order_mark() {
    let mut tables = lamp();
    for plain in [true, false] {
        for target in Target::ALL {
            let options = Options { target, ..Options::default() };
            let mut texts = vec![written(&tables, &options)];
            texts.extend(st::templates(&tables, &options).expect("it fits").into_iter().map(|one| one.text));
            for text in texts {
                assert_eq!(text.starts_with('\u{feff}'), target == Target::Siemens && !plain, "{text}");
            }
        }
        tables.provenance.file = "über.sml".to_owned();
        tables.provenance.requirements.clear();
    }
}

/// Names of events that are those of a template's own variables. Two events are only watched.
#[test]
fn templates_keep_names_apart() {
    let mut tables = talking_lamp();
    for name in
        ["command", "doing", "done", "reset", "timeout", "lamp_control_lit_owed", "lamp_control_lit_timer"]
    {
        let mut event = event(name);
        event.sender = "lamp".to_owned();
        tables.events.push(EventTable { event, mapping: Mapping::default() });
    }
    let template = &st::templates(&tables, &Options::default()).expect("it fits")[0];
    lint(&template.text);
    let text = without_comments(&template.text);
    let mut declared: Vec<String> =
        text.lines().filter_map(|line| Some(line.split_once(" : ")?.0.trim().to_ascii_uppercase())).collect();
    declared.sort();
    let count = declared.len();
    declared.dedup();
    assert_eq!((declared.len(), count), (6 + 4 * 9 + 5 * 2, count), "{}", template.text);
    for (_, input) in &st::names(&tables, &Options::default()).events[2..] {
        assert!(text.contains(&format!("  {input} : BOOL;")), "{input}");
    }
}

/// The wiring calls the controller `primary`.
#[test]
fn a_secondary_called_primary_is_not_the_primary() {
    let mut tables = talking_lamp();
    tables.components[0].object = "primary".to_owned();
    let template = &st::templates(&tables, &Options::default()).expect("it fits")[0];
    assert!(template.text.contains("  primary : Lamp_Controller;"), "{}", template.text);
    assert!(template.text.contains("  primary_2 : Lamp_primary;"), "{}", template.text);
}

#[test]
fn to_generate_again_the_options_are_named() {
    let (trigger, integers, unexpected) = (Trigger::Level, Integers::Signed, Unexpected::Fault);
    let encoding = Encoding::Rows;
    let (target, drain, owed, retain) = (Target::Siemens, true, true, true);
    let options = Options { target, trigger, integers, drain, unexpected, encoding, owed, retain };
    let mut tables = lamp();
    tables.provenance.options = " --minimize none".to_owned();
    assert!(written(&tables, &options).replace(" *)\n(* ", " ").contains(
        "sml export specs/lamp.sml --target siemens --trigger level --integers signed --drain --unexpected fault \
         --encoding rows --owed --retain --minimize none"
    ));
    assert!(written(&lamp(), &Options::default()).contains("sml export specs/lamp.sml --target iec *)"));
}

#[test]
fn long_names_make_no_long_lines() {
    let mut tables = talking_lamp();
    tables.specification = "Specification".repeat(8);
    tables.components[0].object = "component".repeat(8);
    tables.events[3].event.sender = "component".repeat(8);
    tables.events[3].event.text = "component".repeat(20);
    tables.events[0].event = event(&"eventOfTheEnvironment".repeat(8));
    for target in Target::ALL {
        for drain in [false, true] {
            let options = Options { target, drain, owed: true, retain: true, ..Options::default() };
            lint(&written(&tables, &options));
            for template in st::templates(&tables, &options).expect("it fits") {
                lint(&template.text);
                assert!(template.file.len() <= 63 + ".scl".len());
                assert_eq!(template.stale(&template.text), None);
            }
        }
    }
}

#[test]
fn interface() {
    let text = without_comments(&written(&lamp(), &Options::default()));
    let flat = text.split_whitespace().collect::<Vec<_>>().join(" ");
    for part in [
        "TYPE Lamp_Events : ARRAY [0..1] OF BOOL; END_TYPE FUNCTION_BLOCK Lamp_Controller VAR_INPUT enable : BOOL := TRUE; \
         reset : BOOL; button_control_press : BOOL; clock_control_tick_m1 : BOOL; END_VAR VAR_OUTPUT lamp_cmd : INT; \
         state_no : UDINT := 0; pending : Lamp_Events; unexpected : BOOL; overrun : BOOL; END_VAR VAR CONSTANT",
        "END_FUNCTION_BLOCK PROGRAM Lamp_Main VAR_INPUT enable : BOOL := TRUE; reset : BOOL; button_control_press : BOOL; \
         clock_control_tick_m1 : BOOL; END_VAR VAR_OUTPUT lamp_cmd : INT; state_no : UDINT; pending : Lamp_Events; \
         unexpected : BOOL; overrun : BOOL; END_VAR VAR controller : Lamp_Controller; END_VAR controller( enable := enable, \
         reset := reset, button_control_press := button_control_press, clock_control_tick_m1 := clock_control_tick_m1); \
         lamp_cmd := controller.lamp_cmd; state_no := controller.state_no; pending := controller.pending; \
         unexpected := controller.unexpected; overrun := controller.overrun; END_PROGRAM CONFIGURATION Config0 \
         RESOURCE Res0 ON PLC TASK Cyclic(INTERVAL := T#10ms, PRIORITY := 1); PROGRAM Main0 WITH Cyclic : Lamp_Main; \
         END_RESOURCE END_CONFIGURATION",
    ] {
        assert!(flat.contains(part), "{part}\n---\n{flat}");
    }
}

#[test]
fn name_map() {
    let names = st::names(&lamp(), &Options::default());
    assert_eq!(
        (names.target, &*names.function_block, &*names.program, &*names.state, &*names.owed),
        ("iec", "Lamp_Controller", "Lamp_Main", "state_no", "owed")
    );
    let text = |name: &str| name.to_owned();
    assert_eq!(
        names.events,
        [
            (text("button -> control.press()"), text("button_control_press")),
            (text("clock -> control.tick(-1)"), text("clock_control_tick_m1")),
        ]
    );
    assert_eq!(
        names.components,
        [st::ComponentNames {
            object: text("lamp"),
            output: text("lamp_cmd"),
            secondary: text("Lamp_lamp"),
            file: text("Lamp_lamp.st"),
            codes: vec![(text("control -> lamp.off()"), 1), (text("control -> lamp.on()"), 2)],
        }]
    );
}

#[track_caller]
fn check_inputs(texts: &[&str], inputs: &[&str]) {
    let mut tables = lamp();
    tables.events = texts.iter().map(|text| fixture::table(text, &[], &[])).collect();
    let names = st::names(&tables, &Options::default());
    assert_eq!(names.events.into_iter().map(|(_, input)| input).collect::<Vec<_>>(), inputs);
}

#[test]
fn reserved_words_and_functions_give_way() {
    check_inputs(&["date -> and.time()", "int -> to.real()"], &["date_and_time_2", "int_to_real_2"]);
}

#[test]
fn clashes_without_case_are_numbered() {
    check_inputs(&["A -> b.c()", "a -> B.c()", "a -> b.C()"], &["A_b_c", "a_B_c_2", "a_b_C_3"]);
}

#[test]
fn interface_and_outputs_keep_their_names() {
    let mut tables = lamp();
    tables.events =
        vec![fixture::table("state -> no", &[0], &[1]), fixture::table("lamp -> cmd", &[0], &[1])];
    let names = st::names(&tables, &Options::default());
    assert_eq!(names.events[0].1, "state_no_2");
    assert_eq!((&*names.events[1].1, &*names.components[0].output), ("lamp_cmd", "lamp_cmd_2"));
}

/// The names between `VAR` and `END_VAR` of the function block.
fn declared(text: &str) -> BTreeSet<String> {
    let block = &text[text.find("FUNCTION_BLOCK").unwrap()..text.find("END_FUNCTION_BLOCK").unwrap()];
    let tokens = tokens(block);
    let names = tokens.windows(2).filter(|pair| pair[1] == ":").map(|pair| pair[0].clone());
    names.filter(|name| name.starts_with(|c: char| c.is_ascii_alphabetic())).collect()
}

/// Whatever the text declares for itself, no event gets that name.
#[test]
fn no_input_has_the_name_of_a_variable() {
    let interface = ["button_control_press", "clock_control_tick_m1", "lamp_cmd"];
    let mut seen = BTreeSet::new();
    for target in Target::ALL {
        for (encoding, drain) in [(Encoding::Runs, true), (Encoding::Rows, false)] {
            let options = Options { target, encoding, drain, owed: true, retain: true, ..Options::default() };
            for name in declared(&written(&lamp(), &options)) {
                if interface.contains(&name.as_str()) || name.contains("_control_") || name == "lampTarget" {
                    continue;
                }
                let mut tables = lamp();
                tables.events = vec![fixture::table(&name, &[], &[])];
                let names = st::names(&tables, &options);
                assert_eq!(names.events[0].1, format!("{name}_2"), "{}", target.name());
                seen.insert(name);
            }
        }
    }
    assert!(seen.len() > 25, "{seen:?}");
}

#[test]
fn internal_arrays_give_way_to_inputs() {
    let mut tables = lamp();
    tables.events =
        vec![fixture::table("a -> b.c()", &[0], &[1]), fixture::table("a -> b.c(source)", &[0], &[1])];
    let names = st::names(&tables, &Options::default());
    assert_eq!(names.events[1].1, "a_b_c_source");
    let found = arrays(&written(&tables, &Options { encoding: Encoding::Rows, ..Options::default() }));
    assert!(found.contains_key("a_b_c_source_2") && found.contains_key("a_b_c_source_source"), "{found:?}");
}

#[test]
fn narrowest_types() {
    let mut tables = lamp();
    for (states, integers, element, conversion) in [
        (255, Integers::Unsigned, "USINT", "USINT_TO_UDINT(state)"),
        (256, Integers::Unsigned, "UINT", "UINT_TO_UDINT(state)"),
        (65_536, Integers::Unsigned, "UDINT", "state_no := state;"),
        (256, Integers::Signed, "INT", "INT_TO_DINT(state)"),
        (32_768, Integers::Signed, "DINT", "state_no := state;"),
    ] {
        tables.states = states;
        let text = written(&tables, &Options { integers, ..Options::default() });
        assert!(text.contains(&format!("target : ARRAY [0..4] OF {element} := [")), "{text}");
        assert!(text.contains(&format!("state : {element} := 0;")), "{text}");
        assert!(text.contains(conversion), "{text}");
    }
}

#[test]
fn signed_text_has_no_unsigned_types() {
    let text = written(&lamp(), &Options { integers: Integers::Signed, ..Options::default() });
    assert!(tokens(&text).iter().all(|token| !token.starts_with("U") || token == "UNTIL"));
}

#[test]
fn comments_hold_any_text() {
    let mut tables = lamp();
    tables.provenance.requirements = vec![Requirement {
        scenario: "Light.On".to_owned(),
        kind: "guarantee",
        text: vec!["a *) b (* c (*) http://x ".repeat(20), "x".repeat(300)],
        file: "specs/lamp.sml".to_owned(),
        line: 7,
    }];
    let text = written(&tables, &Options::default());
    lint(&text);
    assert!(text.contains("guarantee Light.On, specs/lamp.sml:7"));
}

#[test]
fn nothing_at_all() {
    let mut tables = lamp();
    tables.events.clear();
    tables.components.clear();
    tables.super_steps = Default::default();
    for drain in [false, true] {
        let text = written(&tables, &Options { drain, ..Options::default() });
        lint(&text);
        assert!(text.contains("Lamp_Events : ARRAY [0..0] OF BOOL;"));
        assert!(!text.contains("VAR CONSTANT") && !text.contains("REPEAT") && !text.contains("FOR "));
    }
}

#[test]
fn events_without_rows_are_not_searched() {
    let mut tables = lamp();
    tables.events[0].mapping = Default::default();
    let text = written(&tables, &Options::default());
    lint(&text);
    check_arrays(&tables, &text, &Options::default());
    assert!(text.contains("IF pending[event] AND event_run[event] < event_run[event + 1] THEN"));
    let rows = Options { encoding: Encoding::Rows, ..Options::default() };
    let text = written(&tables, &rows);
    check_arrays(&tables, &text, &rows);
    assert!(text.contains("IF pending[1] THEN") && !text.contains("IF pending[0] THEN"));
}

#[test]
fn trigger() {
    let edge = written(&lamp(), &Options::default());
    assert!(edge.contains("IF raised[index] AND NOT previous[index] THEN"));
    assert!(edge.contains("previous := raised;"));
    let level = written(&lamp(), &Options { trigger: Trigger::Level, ..Options::default() });
    assert!(level.contains("IF raised[index] THEN") && !level.contains("previous"));
}

#[test]
fn inputs_are_never_written() {
    let text =
        written(&lamp(), &Options { drain: true, unexpected: Unexpected::Fault, ..Options::default() });
    let block = &text[text.find("FUNCTION_BLOCK").unwrap()..text.find("END_FUNCTION_BLOCK").unwrap()];
    let body = &block[block.rfind("END_VAR").unwrap()..];
    for input in ["enable", "reset", "button_control_press", "clock_control_tick_m1"] {
        assert!(!body.contains(&format!("{input} :=")), "{input}");
    }
}

#[track_caller]
fn check_unfit(tables: &Tables, options: Options, unfit: Unfit) {
    assert_eq!(st::text(tables, &options), Err(unfit));
}

#[test]
fn too_many_commands() {
    let mut tables = lamp();
    tables.components[0].commands = vec![event("control -> lamp.on()"); 32_768];
    let object = "lamp".to_owned();
    check_unfit(&tables, Options::default(), Unfit::TooManyCommands { object, commands: 32_768 });
}

#[test]
fn too_many_states_for_signed() {
    let mut tables = lamp();
    tables.states = 1 << 31;
    let signed = Options { integers: Integers::Signed, ..Options::default() };
    check_unfit(&tables, signed, Unfit::TooLarge { states: 1 << 31 });
}

#[test]
fn silent_super_steps_in_a_circle_cannot_be_drained() {
    let mut tables = lamp();
    tables.super_steps.target = vec![3, 1];
    let drain = Options { drain: true, ..Options::default() };
    assert!(st::text(&tables, &drain).is_ok(), "one of them commands");
    tables.components[0].codes = vec![0, 0];
    assert!(st::text(&tables, &Options::default()).is_ok());
    check_unfit(&tables, drain, Unfit::EndlessDrain { state: 1 });
}
