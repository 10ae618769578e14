//! Templates of secondaries compile beside their primary, and once they are filled in, both work together.

use std::fmt::Write as _;
use std::time::Duration;

use sml_tests::beside::compiled;
use sml_tests::{corpus, fast, tables};
use st_evaluator::Instance;
use synth_core::controller::tables::{Provenance, Tables};
use synth_core::emit::st::{self, Options, Target};
use synth_core::emit::template::Template;
use synth_core::pipeline::{Timings, synthesize};

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
    let mut primary = vec![format!("enable := {mark}enable"), format!("reset := {mark}reset")];
    let mut variables = format!("primary : {quote}{}{quote};\n", names.function_block);
    for (template, component) in templates(tables, options).iter().zip(&names.components) {
        text += &filled_in(template, except);
        let lines = template.text.lines().rev().take_while(|line| line.starts_with("(*"));
        let mut lines: Vec<&str> =
            lines.map(|line| line.trim_start_matches("(*").trim_end_matches("*)").trim()).collect();
        lines.reverse();
        let wiring = lines.join(" ");
        let (of_secondary, of_primary) = wiring.split_once(&format!("{mark}primary(")).expect("two calls");
        calls.push_str(of_secondary);
        calls.push('\n');
        // What every template says of the primary, and its own events.
        let arguments = of_primary.trim_end_matches(");").split(", ").map(str::to_owned);
        let (common, own): (Vec<String>, Vec<String>) = arguments.partition(|one| primary[..2].contains(one));
        assert_eq!(common, primary[..2]);
        primary.extend(own);
        let _ = writeln!(variables, "{} : {quote}{}{quote};", component.object, component.secondary);
    }
    let mut inputs = String::from("enable : BOOL := TRUE;\nreset : BOOL;\n");
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
         {calls}{mark}primary({});\nEND_FUNCTION_BLOCK\n",
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

/// The template of the press of the production cell with a sensor `ready` as `done`.
fn press(options: &Options) -> String {
    let template = templates(&production_cell(), options).pop().expect("three of them");
    assert_eq!(template.object, "press");
    let mark = if options.target == Target::Siemens { "#" } else { "" };
    let filled = template.text.replace("  done : BOOL;", "  done : BOOL;\n  ready : BOOL;");
    let position = filled.rfind("done := FALSE;").expect("a branch");
    format!("{}done := {mark}ready;{}", &filled[..position], &filled[position + "done := FALSE;".len()..])
}

const FINISHED: &str = "press_controller_pressingFinished";

#[test]
fn an_event_that_is_owed_again_at_once_has_not_stalled() {
    for options in options() {
        let unit = compiled(&press(&options), options.target);
        let mut press = unit.instance("production_cell_press").expect("it is there");
        press.set(&format!("{FINISHED}_owed"), true).expect("an input");
        // It comes every three seconds for half a minute, then no more.
        for scan in 0..500 {
            press.set("command", i64::from(scan % 30 == 0 && scan < 300)).expect("an input");
            press.set("ready", scan % 30 == 29).expect("a variable");
            press.call().expect("it runs");
            let came = press.bool(FINISHED).expect("an output");
            assert_eq!(came, scan % 30 == 29 && scan < 300, "{scan}");
            // From call 300 on it is missing; a timer that starts in one call is 0 there.
            let stalled = press.bool(&format!("{FINISHED}_stalled")).expect("an output");
            assert_eq!(stalled, scan >= 400, "{scan}, {}", options.target.name());
            press.advance(Duration::from_millis(100));
        }
    }
}

/// What is disabled does nothing, reports nothing and waits for nothing, but forgets no command.
#[test]
fn a_disabled_secondary_holds_still() {
    for options in options() {
        let unit = compiled(&press(&options), options.target);
        let mut press = unit.instance("production_cell_press").expect("it is there");
        press.set(&format!("{FINISHED}_owed"), true).expect("an input");
        press.set("ready", true).expect("a variable");
        press.set("enable", false).expect("an input");
        for scan in 0..300 {
            press.set("command", i64::from(scan == 0)).expect("an input");
            press.call().expect("it runs");
            press.advance(Duration::from_millis(100));
            for output in [FINISHED.to_owned(), format!("{FINISHED}_stalled")] {
                assert_eq!(press.bool(&output), Ok(false), "{output}");
            }
        }
        press.set("enable", true).expect("an input");
        press.call().expect("it runs");
        assert_eq!(press.bool(FINISHED), Ok(true), "{}", options.target.name());
    }
}

/// However often the plant is disabled, no event and no command gets lost between primary and secondaries.
#[test]
fn a_plant_that_is_disabled_now_and_then_goes_on() {
    let tables = production_cell();
    for options in options() {
        let unit = compiled(&plant(&tables, &options, "nothing"), options.target);
        let mut plant = unit.instance("Plant").expect("it is there");
        let mut pressed = 0;
        for scan in 0..4000 {
            // Blanks come while it listens.
            plant.set("feedBelt_controller_blankArrived", scan % 80 == 0).expect("an input");
            plant.set("enable", scan % 80 == 0 || scan % 3 != scan / 80 % 3).expect("an input");
            plant.call().expect("it runs");
            plant.advance(Duration::from_millis(100));
            pressed += u32::from(plant.int("primary.press_cmd") == Ok(1));
        }
        assert!((49..=50).contains(&pressed), "{pressed}, {}", options.target.name());
        assert_eq!(stalled(&plant, &tables, &options), [""; 0]);
    }
}

/// A switch that no command goes to says that a motor has arrived.
const GATE: &str = "
specification Gate {
  domain gate {
    class Controller { pressed() atTop() }
    class Motor { up() stop() }
    class Switch { }
    class Button { }
  }
  object controller: Controller
  object motor: Motor
  object top: Switch
  object button: Button
  controllable { Controller }
  non-spontaneous events { Controller.atTop }
  collaboration Opening {
    guarantee scenario Opens {
      button -> controller.pressed()
      urgent controller -> motor.up()
      top -> controller.atTop()
      urgent controller -> motor.stop()
    }
    assumption scenario Rises {
      controller -> motor.up()
      strict eventually top -> controller.atTop()
    }
    assumption scenario Waits {
      button -> controller.pressed()
      top -> controller.atTop()
    } constraints [ forbidden button -> controller.pressed() ]
  }
}";

#[test]
fn an_event_of_an_object_without_commands_has_a_watchdog() {
    let spec = fast::resolved(GATE).expect("it is right");
    let pipeline = fast::options(false, 1000);
    let mut solved = fast::solved(&spec, &pipeline).expect("it is small");
    let verified = synthesize(&mut solved, &pipeline, &mut Timings::default()).expect("it is realizable");
    let tables = Tables::new("Gate", &verified.controller, Provenance::default());
    for options in options() {
        let [template] = &templates(&tables, &options)[..] else { panic!("the motor alone has commands") };
        assert!(template.text.contains("(* the primary then waits for top -> controller.atTop() *)"));
        assert!(template.text.contains("(* - awaited top_controller_atTop: top -> controller.atTop() *)"));
        assert!(!template.text.contains("top_controller_atTop := FALSE"), "who raises it is another");
        let unit = compiled(&template.text, options.target);
        let mut motor = unit.instance("Gate_motor").expect("it is there");
        motor.set("top_controller_atTop_owed", true).expect("an input");
        // The switch stays TRUE for long each time: its edges count. The last one is in call 200.
        for scan in 0..500 {
            motor.set("top_controller_atTop", scan % 50 < 20 && scan < 250 || scan > 200).expect("an input");
            motor.call().expect("it runs");
            let stalled = motor.bool("top_controller_atTop_stalled").expect("an output");
            assert_eq!(stalled, scan > 300, "{scan}, {}", options.target.name());
            motor.advance(Duration::from_millis(100));
        }
    }
}

/// Every event that is owed after a command has a watchdog.
#[test]
fn no_event_that_follows_a_command_is_without_a_watchdog() {
    for (name, tables) in corpus_tables() {
        let names = st::names(&tables, &Options::default());
        let templates: String =
            templates(&tables, &Options::default()).into_iter().map(|template| template.text).collect();
        let steps = tables.super_steps.source.iter().zip(&tables.super_steps.target).enumerate();
        let commanding =
            steps.filter(|(row, _)| tables.components.iter().any(|component| component.codes[*row] != 0));
        for (_, (&source, &target)) in commanding {
            for event in &tables.owed[target as usize] {
                let stalled = format!("{}_stalled", names.events[*event as usize].1);
                let is_new = !tables.owed[source as usize].contains(event);
                assert!(!is_new || templates.contains(&stalled), "{name}: {stalled}");
            }
        }
    }
}
