//! Templates of secondaries compile beside their primary, and once they are filled in, both work together.

use std::fmt::Write as _;
use std::time::Duration;

use sml_tests::beside::compiled;
use sml_tests::{corpus, tables};
use st_evaluator::Instance;
use synth_core::controller::tables::{Provenance, Tables};
use synth_core::emit::st::{self, Options, Target};
use synth_core::emit::template::Template;

/// The tables of every realizable specification of the corpus.
fn corpus_tables() -> impl Iterator<Item = (String, Tables)> {
    corpus::controllers().into_iter().map(|(name, controller)| {
        let tables = Tables::new(&name, &controller, Provenance::default());
        (name, tables)
    })
}

fn options() -> impl Iterator<Item = Options> {
    Target::ALL.into_iter().map(|target| Options { target, owed: true, ..Options::default() })
}

#[track_caller]
fn templates(tables: &Tables, options: &Options) -> Vec<Template> {
    let templates = st::templates(tables, options).expect("it fits");
    let names = st::names(tables, options);
    assert_eq!(templates.len(), names.components.len());
    for (template, component) in templates.iter().zip(&names.components) {
        assert_eq!((&template.object, &template.file), (&component.object, &component.file));
        assert!(template.text.contains(&component.secondary), "{}", template.text);
        assert!(template.text.lines().all(|line| line.chars().count() <= 120), "{}", template.text);
        assert_eq!(template.stale(&template.text), None);
    }
    templates
}

#[test]
fn templates_compile_beside_their_primary() {
    let by_hand =
        [tables::cell(), tables::empty(), tables::inner(), tables::names()].map(|t| ("by hand".into(), t));
    for (name, tables) in corpus_tables().chain(by_hand) {
        for options in options() {
            let mut text = st::text(&tables, &options).expect("it fits");
            for template in templates(&tables, &options) {
                // Each alone, and all together.
                let _ = compiled(&template.text, options.target);
                text = format!("{}\n{text}", template.text);
            }
            let unit = compiled(&text, options.target);
            for component in &st::names(&tables, &options).components {
                let mut secondary = unit.instance(&component.secondary).expect("it is there");
                for code in 0..3 {
                    secondary.set("command", code).expect("an input");
                    secondary.call().unwrap_or_else(|error| panic!("{name}: {error}"));
                }
            }
        }
    }
}

/// The head of a template knows every command and event of its component.
#[test]
fn interfaces_are_those_of_the_components() {
    for (name, tables) in corpus_tables() {
        for (options, secondary) in
            options().flat_map(|o| templates(&tables, &o).into_iter().map(move |t| (o, t)))
        {
            let names = st::names(&tables, &options);
            let component =
                names.components.iter().find(|c| c.object == secondary.object).expect("it is there");
            let commands = component.codes.iter().map(|(text, code)| format!("- command {code}: {text}"));
            let events = tables.events.iter().zip(&names.events);
            let sent = events.filter(|(table, _)| table.event.sender == secondary.object);
            let events = sent.map(|(_, (text, input))| format!("- event {input}: {text}"));
            let block = format!("- function block {}", component.secondary);
            let expected: Vec<String> = std::iter::once(block).chain(commands).chain(events).collect();
            let comments = secondary.text.replace(" *)\n", "\n").replace("(* ", "");
            let found: Vec<&str> = comments.lines().filter(|line| line.starts_with("- ")).collect();
            assert_eq!(found, expected, "{name}");
        }
    }
}

fn production_cell() -> Tables {
    let (_, tables) = corpus_tables().find(|(name, _)| name == "production_cell").expect("it is there");
    tables
}

/// A template whose commands are done at once, except for one.
fn filled_in(template: &Template, except: &str) -> String {
    let mut text = String::new();
    let mut is_excepted = false;
    for line in template.text.lines() {
        is_excepted = (is_excepted || line.contains(except)) && !line.trim().ends_with(':');
        let done = if is_excepted { "FALSE" } else { "TRUE" };
        let line = if line.trim_start().starts_with(['d', '#']) && line.starts_with("      ") {
            line.replace("done := FALSE;", &format!("done := {done};"))
        } else {
            line.to_owned()
        };
        let _ = writeln!(text, "{line}");
    }
    text
}

/// Primary and secondaries in a block `Plant`, wired as the comments in the templates say. Events of everybody else are
/// its inputs.
fn plant(tables: &Tables, options: &Options, except: &str) -> String {
    let names = st::names(tables, options);
    let siemens = options.target == Target::Siemens;
    let (mark, quote) = if siemens { ("#", "\"") } else { ("", "") };
    let mut text = String::new();
    let controller = st::text(tables, options).expect("it fits");
    // What runs the program alone is not wanted.
    let end = controller.find(if siemens { "DATA_BLOCK" } else { "CONFIGURATION Config0" });
    text += &controller[..end.expect("it is there")];
    let mut calls = String::new();
    let mut primary = vec!["enable := TRUE".to_owned()];
    let mut variables = format!("primary : {quote}{}{quote};\n", names.function_block);
    for (template, component) in templates(tables, options).iter().zip(&names.components) {
        text += &filled_in(template, except);
        let lines = template.text.lines().rev().take_while(|line| line.starts_with("(*"));
        let mut lines: Vec<&str> =
            lines.map(|line| line.trim_start_matches("(*").trim_end_matches("*)").trim()).collect();
        lines.reverse();
        let wiring = lines.join(" ");
        let (of_primary, of_secondary) =
            wiring.split_once(&format!("{}(", component.object)).expect("two calls");
        let raised = of_primary.trim().trim_start_matches("primary(").trim_end_matches(");");
        primary
            .push(raised.replace(&format!("{}.", component.object), &format!("{mark}{}.", component.object)));
        let _ = writeln!(
            calls,
            "{mark}{}({}",
            component.object,
            of_secondary.replace("primary.", &format!("{mark}primary."))
        );
        let _ = writeln!(variables, "{} : {quote}{}{quote};", component.object, component.secondary);
    }
    let mut inputs = String::new();
    for (table, (_, input)) in tables.events.iter().zip(&names.events) {
        if names.components.iter().all(|component| component.object != table.event.sender) {
            let _ = writeln!(inputs, "{input} : BOOL;");
            primary.push(format!("{input} := {mark}{input}"));
        }
    }
    let begin = if siemens { "BEGIN" } else { "" };
    let _ = write!(
        text,
        "FUNCTION_BLOCK {quote}Plant{quote}\nVAR_INPUT\n{inputs}END_VAR\nVAR\n{variables}END_VAR\n{begin}\n\
         {mark}primary({});\n{calls}END_FUNCTION_BLOCK\n",
        primary.join(", ")
    );
    text
}

/// Runs the plant for so many seconds, a scan each tenth; every fourth second a blank comes. The number of blanks that
/// were pressed.
fn run(plant: &mut Instance<'_>, seconds: u32) -> u32 {
    let mut pressed = 0;
    for scan in 0..10 * seconds {
        plant.set("feedBelt_controller_blankArrived", scan % 40 == 0).expect("an input");
        plant.call().expect("it runs");
        plant.advance(Duration::from_millis(100));
        pressed += u32::from(plant.int("primary.press_cmd") == Ok(1));
        for output in ["unexpected", "overrun"] {
            assert_eq!(plant.bool(&format!("primary.{output}")), Ok(false), "{output} in scan {scan}");
        }
    }
    pressed
}

/// The events that have stalled.
fn stalled(plant: &Instance<'_>, tables: &Tables, options: &Options) -> Vec<String> {
    let names = st::names(tables, options);
    let events = tables.events.iter().zip(&names.events).filter(|(table, (_, input))| {
        plant.bool(&format!("{}.{input}_stalled", table.event.sender)) == Ok(true)
    });
    events.map(|(_, (text, _))| text.clone()).collect()
}

#[test]
fn filled_in_they_keep_the_cell_going() {
    let tables = production_cell();
    for options in options() {
        let unit = compiled(&plant(&tables, &options, "nothing"), options.target);
        let mut plant = unit.instance("Plant").expect("it is there");
        let pressed = run(&mut plant, 400);
        assert!((99..=100).contains(&pressed), "{pressed}, {}", options.target.name());
        assert_eq!(stalled(&plant, &tables, &options), [""; 0]);
    }
}

#[test]
fn watchdogs_name_the_event_that_stalled() {
    let tables = production_cell();
    for options in options() {
        for (command, event) in [
            ("press.startPressing()", "press -> controller.pressingFinished()"),
            ("feedArm.pickUp()", "feedArm -> controller.pickedUpItem()"),
            ("feedArm.moveTo(press)", "feedArm -> controller.arrivedAt(press)"),
        ] {
            let unit = compiled(&plant(&tables, &options, command), options.target);
            let mut plant = unit.instance("Plant").expect("it is there");
            run(&mut plant, 3);
            assert_eq!(stalled(&plant, &tables, &options), [""; 0], "nobody has waited for long");
            for _ in 0..120 {
                plant.call().expect("it runs");
                plant.advance(Duration::from_millis(100));
            }
            assert_eq!(stalled(&plant, &tables, &options), [event], "{}", options.target.name());
        }
    }
}
