//! Tables for tests of back ends: made by hand for one point each, or at random.

use synth_core::controller::tables::{ComponentTable, EventTable, Mapping, Provenance, Requirement, Tables};
use synth_core::controller::{Component, Controller, Event, SuperStep, SuperSteps};

/// A reproducible source of numbers (splitmix64).
pub struct Random(u64);

impl Random {
    /// From a seed.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Random(seed)
    }

    /// A number below `bound`, which must not be 0.
    pub fn below(&mut self, bound: u32) -> u32 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut mixed = self.0;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((mixed ^ (mixed >> 31)) % u64::from(bound)) as u32
    }
}

/// An event from `sender -> receiver.operation(arguments)`.
///
/// # Panics
///
/// If the text has another form.
#[must_use]
pub fn event(text: &str) -> Event {
    let parts = text.split_once(" -> ").and_then(|(sender, rest)| {
        let (receiver, rest) = rest.split_once('.')?;
        let (operation, arguments) = rest.strip_suffix(')')?.split_once('(')?;
        Some((sender, receiver, operation, arguments))
    });
    let (sender, receiver, operation, arguments) = parts.expect("an event text");
    Event {
        text: text.to_owned(),
        sender: sender.to_owned(),
        receiver: receiver.to_owned(),
        operation: operation.to_owned(),
        arguments: arguments.split(", ").filter(|a| !a.is_empty()).map(str::to_owned).collect(),
    }
}

fn mapping(rows: &[(u32, u32)]) -> Mapping {
    let (source, target) = rows.iter().copied().unzip();
    Mapping { source, target }
}

fn event_table(text: &str, rows: &[(u32, u32)]) -> EventTable {
    EventTable { event: event(text), mapping: mapping(rows) }
}

fn component(object: &str, commands: &[&str], codes: &[u32]) -> ComponentTable {
    ComponentTable {
        object: object.to_owned(),
        commands: commands.iter().map(|text| event(text)).collect(),
        codes: codes.to_vec(),
    }
}

fn tables(specification: &str, states: u32) -> Tables {
    Tables {
        specification: specification.to_owned(),
        states,
        initial: 0,
        events: Vec::new(),
        super_steps: Mapping::default(),
        components: Vec::new(),
        owed: vec![Vec::new(); states as usize],
        provenance: Provenance {
            file: format!("specs/{}.sml", specification.to_lowercase()),
            hash: "00000000000000ff".to_owned(),
            options: String::new(),
            level: synth_core::controller::Level::Exact,
            monitor: false,
            requirements: Vec::new(),
        },
    }
}

/// An arm and a press: super steps with two commands, a split one (states 4 and 5), an event without rows, owed
/// events, and one consumed only after another of the same scan.
#[must_use]
pub fn cell() -> Tables {
    let mut cell = tables("SmallCell", 7);
    cell.events = vec![
        event_table("arm -> ctl.arrived(-1)", &[(2, 3)]),
        event_table("arm -> ctl.arrived(1)", &[]),
        event_table("arm -> ctl.held()", &[(6, 4)]),
        event_table("belt -> ctl.blankArrived()", &[(0, 1), (3, 0)]),
    ];
    cell.super_steps = mapping(&[(1, 2), (4, 5), (5, 0)]);
    cell.components = vec![
        component(
            "arm",
            &["ctl -> arm.hold()", "ctl -> arm.moveTo(-1)", "ctl -> arm.moveTo(belt)"],
            &[1, 2, 3],
        ),
        component("press", &["ctl -> press.press()"], &[0, 1, 0]),
    ];
    cell.events[0].mapping = mapping(&[(2, 3), (3, 6)]);
    cell.owed[2] = vec![0];
    cell.owed[3] = vec![0, 3];
    cell.owed[6] = vec![2];
    cell.provenance.requirements = vec![Requirement {
        scenario: "Cell.Deliver".to_owned(),
        kind: "guarantee",
        text: vec![
            " Every <blank> [1] is *pressed*,".to_owned(),
            " see http://example.org/blank_press.".to_owned(),
        ],
        file: "specs/smallcell.sml".to_owned(),
        line: 12,
    }];
    cell
}

/// One state and nothing else.
#[must_use]
pub fn empty() -> Tables {
    tables("Empty", 1)
}

/// Super steps from the initial state on, a chain of them, but no events and no components.
#[must_use]
pub fn inner() -> Tables {
    let mut inner = tables("Inner", 3);
    inner.super_steps = mapping(&[(0, 1), (1, 2)]);
    inner
}

/// Names that clash with keywords, with what every module has, and with one another.
#[must_use]
pub fn names() -> Tables {
    let mut names = tables("match", 2);
    names.events = [
        "Self -> self.fn()",
        "a -> b.c(1, 2)",
        "a -> b.c(12)",
        "a -> b.c_1(2)",
        "aB -> c.d()",
        "a_b -> c.d()",
        "super -> b.super()",
        "tables -> events.owed()",
    ]
    .map(|text| event_table(text, &[(0, 1)]))
    .to_vec();
    names.super_steps = mapping(&[(1, 0)]);
    let objects = [
        "Commands",
        "Controller",
        "Event",
        "Option",
        "Self",
        "Some",
        "Tables",
        "commands",
        "controller",
        "core",
        "default",
        "event",
        "foo",
        "fooCommand",
        "iterator",
        "move",
        "owed",
        "owed_set",
        "super_steps",
        "u8",
    ];
    names.components = objects
        .map(|object| {
            let texts =
                ["apply()", "clone()", "fn()", "into_self()", "move()", "move(1)", "self()", "toNull(-1)"]
                    .map(|operation| format!("x -> {object}.{operation}"));
            component(object, &texts.each_ref().map(String::as_str), &[8])
        })
        .to_vec();
    names
}

/// Size of [`random`] tables.
#[derive(Clone, Copy, Debug)]
pub struct Size {
    /// Number of states.
    pub states: u32,
    /// Number of environment events.
    pub events: u32,
    /// Of 100 environment states, how many have a row of an event.
    pub rows: u32,
    /// Number of components, of three commands each.
    pub components: u32,
}

/// Tables at random that keep what a controller promises: every chain of super steps ends. Some states have environment
/// rows and a super step, as in controllers of plants.
#[must_use]
pub fn random(specification: &str, size: Size, seed: u64) -> Tables {
    let random = &mut Random::new(seed);
    let mut random_tables = tables(specification, size.states);
    let stepping: Vec<bool> = (0..size.states).map(|s| s + 1 < size.states && random.below(5) < 2).collect();
    let waiting: Vec<bool> = stepping.iter().map(|&stepping| !stepping || random.below(4) == 0).collect();
    random_tables.initial = random.below(size.states);
    random_tables.events = (0..size.events)
        .map(|e| {
            let mut rows = Vec::new();
            for source in (0..size.states).filter(|&state| waiting[state as usize]) {
                if random.below(100) < size.rows {
                    rows.push((source, random.below(size.states)));
                }
            }
            event_table(&format!("env -> ctl.e{e:04}()"), &rows)
        })
        .collect();
    let steps: Vec<(u32, u32)> = (0..size.states)
        .filter(|&s| stepping[s as usize])
        .map(|s| (s, s + 1 + random.below(size.states - s - 1)))
        .collect();
    random_tables.super_steps = mapping(&steps);
    random_tables.components = (0..size.components)
        .map(|c| {
            let texts = ["go()", "stop()", "turn(1)"].map(|operation| format!("ctl -> c{c}.{operation}"));
            let codes: Vec<u32> = steps.iter().map(|_| random.below(8).saturating_sub(4)).collect();
            component(&format!("c{c}"), &texts.each_ref().map(String::as_str), &codes)
        })
        .collect();
    random_tables.owed =
        (0..size.states).map(|_| (0..size.events).filter(|_| random.below(10) == 0).collect()).collect();
    random_tables
}

/// What tables are the layout of. A super step that commands nothing has an event between controllable objects.
#[must_use]
pub fn controller(tables: &Tables) -> Controller {
    let mut commands: Vec<_> = tables.components.iter().flat_map(|c| c.commands.iter().cloned()).collect();
    let inner = commands.len() as u32;
    commands.push(event("ctl -> other.inner()"));
    let mut first = 0;
    let mut firsts = Vec::new();
    let mut components = Vec::new();
    for component in &tables.components {
        let count = component.commands.len() as u32;
        components
            .push(Component { object: component.object.clone(), commands: (first..first + count).collect() });
        firsts.push(first);
        first += count;
    }
    let rows = tables.super_steps.source.iter().zip(&tables.super_steps.target).enumerate();
    let mut super_steps = SuperSteps::default();
    for (row, (&source, &target)) in rows {
        let codes = tables.components.iter().zip(&firsts).filter(|(c, _)| c.codes[row] != 0);
        let events: Vec<u32> =
            codes.map(|(component, first)| first + component.codes[row] - 1).chain([inner]).collect();
        super_steps.push(SuperStep { source, target, events: &events });
    }
    let rows = tables
        .events
        .iter()
        .map(|e| e.mapping.source.iter().copied().zip(e.mapping.target.iter().copied()).collect());
    Controller {
        states: tables.states,
        initial: tables.initial,
        events: tables.events.iter().map(|table| table.event.clone()).collect(),
        environment: rows.collect(),
        super_steps,
        commands,
        components,
        owed: tables.owed.iter().collect(),
    }
}
