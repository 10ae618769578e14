//! The production cell in Structured Text, on the plant and before the monitor of the example: neither knows a table.
//!
//! Every text drives a cell of its own. Beside it runs the generated Rust, which must be in the same state, issue the
//! same commands and leave the same events pending in every cycle, and which tells the monitor in what order the
//! events of a cycle were consumed. `SML_ITEMS` asks for more than 10,000 items.

use controller_template::Observer;
use production_cell::production_cell::{Commands, Controller, Event};
use production_cell::random::Random;
use production_cell::{Controls, Report, run};
use sml_tests::beside::{Inputs, Running, compiled};
use sml_tests::fast;
use synth_core::controller::tables::Tables;
use synth_core::emit::st::{self, Encoding, Options, Target};
use synth_core::pipeline::{Timings, compile};

const SPECIFICATION: &str = include_str!("../../examples/production-cell/specs/production_cell.sml");

fn items() -> u64 {
    std::env::var("SML_ITEMS").ok().and_then(|text| text.parse().ok()).unwrap_or(10_000)
}

/// A function block and the generated Rust.
struct Both<'u> {
    block: Running<'u>,
    rust: Controller,
    /// Events in table order.
    events: Vec<Event>,
    inputs: Inputs,
}

impl Controls for Both<'_> {
    fn raise(&mut self, event: Event) -> bool {
        let index = self.events.iter().position(|&each| each == event).expect("an event of the tables");
        assert!(!std::mem::replace(&mut self.inputs.events[index], true), "a sensor changes once a cycle");
        self.rust.raise(event)
    }

    fn cycle<O: Observer<Event, Commands>>(&mut self, observer: &mut O) -> Commands {
        let commands = self.rust.cycle_observed(observer);
        let outputs = self.block.call(&self.inputs).expect("it runs");
        assert_eq!(outputs.commands, codes(commands));
        assert_eq!(outputs.state, self.rust.state());
        let pending = self.events.iter().map(|&event| self.rust.is_pending(event));
        assert!(outputs.pending.iter().copied().eq(pending));
        assert!(!outputs.unexpected, "the plant does what the assumptions promise");
        assert!(!outputs.overrun, "the plant waits until an event is consumed");
        self.inputs.events.fill(false);
        commands
    }
}

/// In order of the components' names, as the tables have them.
fn codes(commands: Commands) -> Vec<u32> {
    let Commands { deposit_arm, feed_arm, press } = commands;
    vec![
        deposit_arm.map_or(0, |command| command.code().into()),
        feed_arm.map_or(0, |command| command.code().into()),
        press.map_or(0, |command| command.code().into()),
    ]
}

fn tables() -> Tables {
    compile(&fast::loaded(SPECIFICATION), &Default::default(), &mut Timings::default())
        .expect("it is realizable")
}

/// What happens in the plant; an input is TRUE in the call in which its sensor has changed.
fn delivered(text: &str, tables: &Tables, options: &Options, items: u64) -> Report {
    let unit = compiled(text, options.target);
    let events: Vec<Event> =
        tables.events.iter().map(|table| Event::from_text(&table.event.text).expect("its event")).collect();
    let inputs = Inputs { enable: true, reset: false, events: vec![false; events.len()] };
    let block = Running::new(&unit, tables, options);
    let mut both = Both { block, rust: Controller::new(), events, inputs };
    run(&mut both, items, Random::new(7), &mut |_| {})
}

#[track_caller]
fn check(options: Options) {
    let tables = tables();
    let text = st::text(&tables, &options).expect("it fits");
    let report = delivered(&text, &tables, &options, items());
    println!("{options:?}: {report}");
    assert_eq!(report.violations, Vec::<String>::new());
    assert_eq!(report.items, items());
    assert!(report.together > items() / 10, "the plant must try the controller");
}

#[test]
fn iec() {
    check(Options { target: Target::Iec, ..Options::default() });
}

#[test]
fn iec_in_the_published_layout() {
    check(Options { encoding: Encoding::Rows, ..Options::default() });
}

#[test]
fn codesys() {
    check(Options { target: Target::Codesys, ..Options::default() });
}

#[test]
fn twincat() {
    check(Options { target: Target::Twincat, ..Options::default() });
}

#[test]
fn siemens() {
    check(Options { target: Target::Siemens, ..Options::default() });
}

#[test]
fn case() {
    check(Options { target: Target::Case, ..Options::default() });
}

/// The press works when the feed arm picks up, and not when it has released an item.
#[test]
#[should_panic(expected = "assertion `left == right` failed")]
fn a_wrong_command_is_noticed() {
    let tables = tables();
    let mut wrong = tables.clone();
    let codes = wrong.components[2].codes.iter_mut().zip(&tables.components[1].codes);
    codes.for_each(|(press, feed_arm)| *press = u32::from(*feed_arm == 3));
    let options = Options::default();
    let text = st::text(&wrong, &options).expect("it fits");
    delivered(&text, &tables, &options, 10);
}
