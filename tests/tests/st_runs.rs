//! The Structured Text runs, and does in every call what the interpreter of controllers does.
//!
//! `SML_CYCLES` asks for more than 1000 calls of each text.

use sml_tests::reference::Reference;
use sml_tests::tables::{self, Random, Size};
use sml_tests::{corpus, fast};
use st_evaluator::{Dialect, Instance, Unit};
use synth_core::controller::cycle::Machine;
use synth_core::controller::tables::{Mapping, Provenance, Tables};
use synth_core::controller::{Component, Controller, SuperStep};
use synth_core::emit::st::{self, Cost, Encoding, Integers, NameMap, Options, Target, Trigger, Unexpected};
use synth_core::pipeline::{Timings, synthesize};

const CALLS: usize = 1000;

fn calls() -> usize {
    std::env::var("SML_CYCLES").ok().and_then(|text| text.parse().ok()).unwrap_or(CALLS)
}

/// The controller of every realizable specification of the corpus.
fn corpus_controllers() -> Vec<(String, Controller)> {
    let mut controllers = Vec::new();
    for entry in corpus::all() {
        let spec = fast::resolved(&entry.text).expect("the corpus is right");
        let options = fast::options(false, 20_000);
        let Ok(mut solved) = fast::solved(&spec, &options) else { continue };
        if let Ok(verified) = synthesize(&mut solved, &options, &mut Timings::default()) {
            controllers.push((entry.name, verified.controller));
        }
    }
    assert!(controllers.len() > 20, "only {}", controllers.len());
    controllers
}

/// What tables are the layout of. A super step that commands nothing has an event between controllable objects.
fn controller(tables: &Tables) -> Controller {
    let mut commands: Vec<_> = tables.components.iter().flat_map(|c| c.commands.iter().cloned()).collect();
    let inner = commands.len() as u32;
    commands.push(tables::event("ctl -> other.inner()"));
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
    let super_steps = rows.map(|(row, (&source, &target))| {
        let codes = tables.components.iter().zip(&firsts).filter(|(c, _)| c.codes[row] != 0);
        let events =
            codes.map(|(component, first)| first + component.codes[row] - 1).chain([inner]).collect();
        SuperStep { source, target, events }
    });
    let rows = tables
        .events
        .iter()
        .map(|e| e.mapping.source.iter().copied().zip(e.mapping.target.iter().copied()).collect());
    Controller {
        states: tables.states,
        initial: tables.initial,
        events: tables.events.iter().map(|table| table.event.clone()).collect(),
        environment: rows.collect(),
        super_steps: super_steps.collect(),
        commands,
        components,
        owed: tables.owed.clone(),
    }
}

/// The inputs of a call.
struct Inputs {
    enable: bool,
    reset: bool,
    events: Vec<bool>,
}

/// The outputs of a call.
#[derive(Clone, PartialEq, Eq, Debug)]
struct Outputs {
    commands: Vec<u32>,
    state: u32,
    pending: Vec<bool>,
    unexpected: bool,
    overrun: bool,
}

/// The interface of the function block over the interpreter, as `docs/controller.md` tells it.
struct Model<'a> {
    options: Options,
    machine: Machine<'a>,
    /// Follows the machine, but can forget single events.
    reference: Reference<'a>,
    previous: Vec<bool>,
    unexpected: bool,
}

impl<'a> Model<'a> {
    fn new(tables: &'a Tables, controller: &'a Controller, options: Options) -> Model<'a> {
        let previous = vec![false; tables.events.len()];
        let (machine, reference) = (Machine::new(controller), Reference::new(tables));
        Model { options, machine, reference, previous, unexpected: false }
    }

    fn call(&mut self, inputs: &Inputs) -> Outputs {
        let tables = self.reference.tables();
        let fault = self.options.unexpected == Unexpected::Fault;
        self.unexpected &= fault;
        let mut overrun = false;
        let mut commands = vec![0; tables.components.len()];
        if inputs.reset {
            self.unexpected = false;
            self.machine.reset();
            self.reference = Reference::new(tables);
        } else if inputs.enable && !self.unexpected {
            for (event, &now) in inputs.events.iter().enumerate() {
                if now && !(self.options.trigger == Trigger::Edge && self.previous[event]) {
                    overrun |= !self.raise(event);
                }
            }
            commands = self.run();
        }
        self.previous.clone_from(&inputs.events);
        let state = self.reference.state;
        let pending = (0..tables.events.len()).map(|event| self.reference.pending.contains(&event)).collect();
        Outputs { commands, state, pending, unexpected: self.unexpected, overrun }
    }

    fn raise(&mut self, event: usize) -> bool {
        let raised = self.reference.raise(event);
        if self.options.unexpected != Unexpected::Drop {
            assert_eq!(self.machine.raise(event as u32), raised);
        }
        raised
    }

    fn run(&mut self) -> Vec<u32> {
        let steps = self.reference.log.len();
        let commands = if self.options.drain { self.reference.drain() } else { self.reference.cycle() };
        let waits = if self.options.drain {
            self.machine_waits()
        } else {
            self.reference.log[steps..].iter().all(|(event, ..)| event.is_some())
        };
        if self.options.unexpected != Unexpected::Drop {
            let issued = if self.options.drain { self.machine.drain() } else { self.machine.cycle() };
            assert_eq!(issued.codes, commands);
            assert_eq!(self.machine.state(), self.reference.state);
        }
        self.unexpected = waits && !self.reference.pending.is_empty();
        if self.unexpected && self.options.unexpected == Unexpected::Drop {
            self.reference.pending.clear();
        }
        self.reference.log.clear();
        commands
    }

    /// Whether no super step is due.
    fn machine_waits(&self) -> bool {
        let tables = self.reference.tables();
        tables.super_steps.source.binary_search(&self.reference.state).is_err()
    }
}

/// A text, and its function block at work.
struct Running<'u> {
    names: NameMap,
    instance: Instance<'u>,
    /// What no call may exceed.
    bound: Cost,
}

impl Running<'_> {
    /// Outputs, or what is wrong with the call itself.
    fn call(&mut self, inputs: &Inputs) -> Result<Outputs, String> {
        let block = &mut self.instance;
        block.set("enable", inputs.enable).expect("an input");
        block.set("reset", inputs.reset).expect("an input");
        for ((_, name), value) in self.names.events.iter().zip(&inputs.events) {
            block.set(name, *value).expect("an input");
        }
        let stats = block.call().map_err(|error| error.to_string())?;
        let Cost { statements, iterations, .. } = self.bound;
        if stats.wrapped > 0 || stats.statements > statements || stats.iterations > iterations {
            return Err(format!(
                "integers are too narrow or the bound is too small: {stats:?}, {:?}",
                self.bound
            ));
        }
        for ((_, name), value) in self.names.events.iter().zip(&inputs.events) {
            assert_eq!(block.bool(name), Ok(*value), "inputs are not written");
        }
        let number = |name: &str| u32::try_from(block.int(name).expect("an output")).expect("not negative");
        let mut pending = block.bools("pending").expect("an output");
        pending.truncate(self.names.events.len());
        Ok(Outputs {
            commands: self.names.components.iter().map(|c| number(&c.output)).collect(),
            state: number("state_no"),
            pending,
            unexpected: block.bool("unexpected").expect("an output"),
            overrun: block.bool("overrun").expect("an output"),
        })
    }
}

/// Several events at once, mostly ones that fit; now and then a reset or a pause.
fn inputs(reference: &Reference<'_>, previous: &[bool], random: &mut Random) -> Inputs {
    let count = previous.len() as u32;
    let mut events: Vec<bool> = previous.iter().map(|&held| held && random.below(4) == 0).collect();
    if count > 0 {
        for _ in 0..random.below(4) {
            events[random.below(count) as usize] = true;
        }
        let fitting: Vec<usize> = (0..previous.len()).filter(|&e| reference.accepts(e).is_some()).collect();
        if !fitting.is_empty() && random.below(4) != 0 {
            events[fitting[random.below(fitting.len() as u32) as usize]] = true;
        }
    }
    Inputs { enable: random.below(20) != 0, reset: random.below(60) == 0, events }
}

/// Whose Structured Text a target's is.
fn dialect(target: Target) -> Dialect {
    match target {
        Target::Iec | Target::Case => Dialect::Edition2,
        Target::Codesys => Dialect::Codesys,
        Target::Twincat => Dialect::TwinCat,
        Target::Siemens => Dialect::Siemens,
    }
}

/// The first call in which a text and the interpreter differ.
fn difference(
    text: &str,
    names: NameMap,
    tables: &Tables,
    controller: &Controller,
    options: Options,
    calls: usize,
) -> Option<String> {
    let unit = Unit::parse(text, dialect(options.target)).unwrap_or_else(|errors| {
        let errors: Vec<String> = errors.iter().map(ToString::to_string).collect();
        panic!("{}\n{text}", errors.join("\n"));
    });
    let instance = unit.instance(&names.function_block).expect("the function block is there");
    let bound = st::bound(tables, &options).expect("it fits");
    let mut running = Running { names, instance, bound };
    let mut model = Model::new(tables, controller, options);
    let random = &mut Random::new(0x5EED);
    for call in 0..calls {
        let inputs = inputs(&model.reference, &model.previous, random);
        let expected = model.call(&inputs);
        let found = running.call(&inputs);
        if found.as_ref() != Ok(&expected) {
            return Some(format!("call {call}: {found:?} instead of {expected:?}"));
        }
    }
    None
}

#[track_caller]
fn check(name: &str, tables: &Tables, controller: &Controller, options: Options, calls: usize) {
    let text = st::text(tables, &options).expect("it fits");
    let names = st::names(tables, &options);
    let difference = difference(&text, names, tables, controller, options, calls);
    assert_eq!(difference, None, "{name} with {options:?}");
}

/// The defaults for every target and, where it has tables, every encoding of them.
fn all_targets() -> Vec<Options> {
    let of_target = |target| {
        let rows = (target != Target::Case).then_some(Encoding::Rows);
        let encodings = [Encoding::Runs].into_iter().chain(rows);
        encodings.map(move |encoding| Options { target, encoding, ..Options::default() })
    };
    Target::ALL.into_iter().flat_map(of_target).collect()
}

/// All that the command line can ask for, beside the target.
fn all_options() -> Vec<Options> {
    let mut all = Vec::new();
    for trigger in [Trigger::Edge, Trigger::Level] {
        for integers in [Integers::Unsigned, Integers::Signed] {
            for drain in [false, true] {
                for unexpected in [Unexpected::Keep, Unexpected::Drop, Unexpected::Fault] {
                    all.push(Options { trigger, integers, drain, unexpected, ..Options::default() });
                }
            }
        }
    }
    all
}

/// All that the command line can ask for.
fn everything() -> Vec<Options> {
    let with_all = |Options { target, encoding, .. }| {
        all_options().into_iter().map(move |options| Options { target, encoding, ..options })
    };
    all_targets().into_iter().flat_map(with_all).collect()
}

#[test]
fn corpus() {
    for (name, controller) in corpus_controllers() {
        let tables = Tables::new(&name, &controller, Provenance::default());
        for options in all_targets() {
            check(&name, &tables, &controller, options, calls());
        }
    }
}

/// Every specification with every option, and the targets in turn.
#[test]
fn corpus_with_all_options() {
    let targets = all_targets();
    for (first, (name, controller)) in corpus_controllers().into_iter().enumerate() {
        let tables = Tables::new(&name, &controller, Provenance::default());
        for (turn, options) in all_options().into_iter().enumerate() {
            let Options { target, encoding, .. } = targets[(first + turn) % targets.len()];
            check(&name, &tables, &controller, Options { target, encoding, ..options }, calls() / 20);
        }
    }
}

#[test]
fn at_random() {
    let size = |states, events, rows, components| Size { states, events, rows, components };
    let sizes = [
        size(12, 6, 40, 3),
        size(40, 5, 15, 2),
        size(9, 4, 50, 0),
        size(30, 70, 10, 4),
        size(256, 3, 30, 1),
        size(257, 3, 30, 1),
        size(3017, 5, 40, 3),
    ];
    for (seed, size) in (1..).zip(sizes) {
        let tables = tables::random("Random", size, seed);
        let controller = controller(&tables);
        for options in all_targets() {
            check(&format!("{size:?}"), &tables, &controller, options, calls());
        }
    }
}

#[test]
fn at_random_with_all_options() {
    for seed in 0..4 {
        let size = Size { states: 20, events: 5, rows: 40, components: 2 };
        let tables = tables::random("Random", size, 100 + seed);
        let controller = controller(&tables);
        for options in everything() {
            check(&format!("seed {seed}"), &tables, &controller, options, calls() / 4);
        }
    }
}

#[test]
fn made_by_hand() {
    for tables in [tables::cell(), tables::empty(), tables::inner(), tables::names()] {
        let controller = controller(&tables);
        for options in everything() {
            check(&tables.specification, &tables, &controller, options, calls() / 4);
        }
    }
}

/// The program passes everything through, and the configuration runs it; in SCL, a block that has an instance.
#[test]
fn the_configuration_runs_the_program() {
    let tables = tables::cell();
    for options in all_targets() {
        let text = st::text(&tables, &options).expect("it fits");
        let names = st::names(&tables, &options);
        let unit = Unit::parse(&text, dialect(options.target)).expect("it compiles");
        let (mut program, prefix) = match options.target {
            Target::Siemens => (unit.instance(&names.program).expect("it is there"), ""),
            _ => (unit.configuration().expect("there is one"), "Main0."),
        };
        let mut block = unit.instance(&names.function_block).expect("it is there");
        let random = &mut Random::new(7);
        for _ in 0..200 {
            for (_, input) in &names.events {
                let value = random.below(3) == 0;
                block.set(input, value).expect("an input");
                program.set(&format!("{prefix}{input}"), value).expect("an input");
            }
            block.call().expect("it runs");
            program.call().expect("it runs");
            let outputs = names.components.iter().map(|component| component.output.as_str());
            for output in outputs.chain(["state_no", "pending", "unexpected", "overrun"]) {
                assert_eq!(program.get(&format!("{prefix}{output}")), block.get(output), "{output}");
            }
        }
    }
}

/// An organization block of SCL calls the program's instance.
#[test]
fn the_organization_block_runs() {
    let options = Options { target: Target::Siemens, ..Options::default() };
    let text = st::text(&tables::cell(), &options).expect("it fits");
    let unit = Unit::parse(&text, Dialect::Siemens).expect("it compiles");
    let mut cyclic = unit.instance("Cyclic").expect("it is there");
    assert!(cyclic.call().expect("it runs").calls >= 2);
}

/// Events that come in the order opposite to that of the tables, so that every round consumes one; each has four rows far
/// apart, so that every search takes two halvings, and one row below, so that no search ends early.
fn slowest(events: u32) -> Tables {
    let mut tables = tables::cell();
    let chain = 2..events + 2;
    tables.states = chain.end + 5;
    tables.initial = chain.start;
    tables.owed = vec![Vec::new(); tables.states as usize];
    let last = tables.events[0].clone();
    tables.events = (0..events)
        .zip(chain.clone().rev())
        .map(|(event, state)| {
            let mut table = last.clone();
            table.event = tables::event(&format!("sensor{event:02} -> ctl.seen()"));
            // In the end, the last state waits for the event that came first.
            let beyond = if state == chain.start { chain.end } else { chain.end + 2 };
            let source = vec![0, state, beyond, beyond + 2];
            table.mapping =
                Mapping { target: source.iter().map(|s| (s + 1).min(chain.end)).collect(), source };
            table
        })
        .collect();
    tables.super_steps = Mapping::default();
    for component in &mut tables.components {
        component.codes.clear();
    }
    tables
}

/// The bound is no estimate: there are controllers that reach it.
#[test]
fn bounds_are_reached() {
    let tables = slowest(7);
    for options in all_targets() {
        let text = st::text(&tables, &options).expect("it fits");
        let names = st::names(&tables, &options);
        let unit = Unit::parse(&text, dialect(options.target)).expect("it compiles");
        let mut block = unit.instance(&names.function_block).expect("it is there");
        for (_, input) in &names.events {
            block.set(input, true).expect("an input");
        }
        let stats = block.call().expect("it runs");
        let bound = st::bound(&tables, &options).expect("it fits");
        assert_eq!((stats.statements, stats.iterations), (bound.statements, bound.iterations), "{options:?}");
    }
}

/// The text with each number that `is_entry` takes for one of the controller's replaced, one at a time.
fn mutations(text: &str, is_entry: impl Fn(&str) -> bool) -> Vec<String> {
    let mut mutations = Vec::new();
    let mut start = 0;
    for line in text.split_inclusive('\n') {
        if is_entry(line.trim()) {
            let mut at = 0;
            for part in line.split_inclusive(|c: char| !c.is_ascii_alphanumeric() && c != '_') {
                let digits = part.trim_end_matches(|c: char| !c.is_ascii_alphanumeric());
                if let Ok(number) = digits.parse::<u32>() {
                    let (from, other) = (start + at, u32::from(number == 0));
                    mutations.push(format!("{}{other}{}", &text[..from], &text[from + digits.len()..]));
                }
                at += part.len();
            }
        }
        start += line.len();
    }
    mutations
}

/// What a target's text says of the controller itself: lines of numbers, or the assignments in branches.
fn entries(target: Target, text: &str) -> Vec<String> {
    let numbers = |line: &str| line.starts_with(|c: char| c.is_ascii_digit()) && !line.ends_with(':');
    let steps = ["state := ", "event := ", "arm_cmd := ", "press_cmd := "];
    match target {
        Target::Case => {
            let machine = text.find("CASE").expect("there are branches");
            let end = text.find("IF NOT due").expect("there are super steps");
            mutations(&text[machine..end], |line| steps.iter().any(|step| line.starts_with(step)))
                .into_iter()
                .map(|mutated| format!("{}{mutated}{}", &text[..machine], &text[end..]))
                .collect()
        }
        _ => mutations(text, numbers),
    }
}

/// Faults of an emitter, each in one place of the text; `#` marks local names, where the target wants it.
fn faults(Options { target, encoding, .. }: Options, text: &str) -> Vec<(&'static str, String)> {
    let of_all = [
        ("a missing latch", "#pending[#index] := TRUE;", "#pending[#index] := FALSE;"),
        ("an input of another event", "#raised[0] := ", "#raised[1] := "),
        ("no edge", " AND NOT #previous[#index]", ""),
        ("no overrun", "#overrun := #overrun OR #pending[#index];", ";"),
        ("a command that stays", "#arm_cmd := 0;", ";"),
        ("a state that is not output", "#state_no := USINT_TO_UDINT(#state);", ";"),
    ];
    let of_runs = [
        ("an event that is not consumed", "#pending[#event] := FALSE;\n", "\n"),
        ("another event", "IF #pending[#event]", "IF #pending[0]"),
        ("a search that ends early", "#first := #middle;", "#first := #middle; #last := #middle;"),
        ("a run that is too long", "#row < #run_row", "#row <= #run_row"),
        ("a run that begins too late", "IF #run_state[#first] <= ", "IF #run_state[#first] < "),
    ];
    let of_rows = [
        ("an event that is not consumed", "#pending[0] := FALSE;\n", "\n"),
        ("another event", "IF #pending[2] THEN", "IF #pending[0] THEN"),
        ("a search that ends early", "#first := #middle;", "#first := #middle; #last := #middle;"),
    ];
    let of_case = [
        ("an event that is not consumed", "pending[event] := FALSE;", ""),
        ("another event", "IF pending[2] AND", "IF pending[0] AND"),
    ];
    let others = match (target, encoding) {
        (Target::Case, _) => &of_case[..],
        (_, Encoding::Runs) => &of_runs,
        (_, Encoding::Rows) => &of_rows,
    };
    of_all
        .iter()
        .chain(others)
        .map(|&(what, from, to)| {
            let spelled =
                |code: &str| if target == Target::Siemens { code.into() } else { code.replace('#', "") };
            let (from, to) = (spelled(from), spelled(to));
            assert!(text.contains(&from), "{from}\n{text}");
            (what, text.replace(&from, &to))
        })
        .collect()
}

#[test]
fn faults_are_noticed() {
    let tables = tables::cell();
    let controller = controller(&tables);
    // What is added to the targets of an event without rows means nothing.
    let without_rows = tables.events.iter().filter(|table| table.mapping.source.is_empty()).count();
    for options in all_targets() {
        let text = st::text(&tables, &options).expect("it fits");
        let names = st::names(&tables, &options);
        let unnoticed = |faulty: &String| {
            assert_ne!(*faulty, text);
            difference(faulty, names.clone(), &tables, &controller, options, CALLS).is_none()
        };
        for (what, faulty) in faults(options, &text) {
            assert!(!unnoticed(&faulty), "{what} goes unnoticed:\n{faulty}");
        }
        let entries = entries(options.target, &text);
        assert!(entries.len() > 15, "only {} of {}", entries.len(), options.target.name());
        let by_runs = options.target != Target::Case && options.encoding == Encoding::Runs;
        let meaningless = if by_runs { without_rows } else { 0 };
        let unnoticed: Vec<String> = entries.into_iter().filter(unnoticed).collect();
        assert_eq!(unnoticed.len(), meaningless, "{}", unnoticed.concat());
    }
}

/// Branches that do not look back at earlier events.
#[test]
fn a_round_that_is_not_started_again_is_noticed() {
    let tables = slowest(3);
    let controller = controller(&tables);
    let options = Options { target: Target::Case, ..Options::default() };
    let text = st::text(&tables, &options).expect("it fits");
    let faulty = text.replacen("ELSIF next > 0 THEN", "ELSIF next > 9 THEN", 1);
    assert_ne!(faulty, text);
    let names = st::names(&tables, &options);
    assert!(difference(&faulty, names, &tables, &controller, options, CALLS).is_some());
}

/// Two targets of a table that are swapped.
#[test]
fn swapped_entries_are_noticed() {
    for (name, controller) in corpus_controllers() {
        let tables = Tables::new(&name, &controller, Provenance::default());
        let mut swapped = tables.clone();
        let targets = &mut swapped.super_steps.target;
        let Some(other) = targets.iter().position(|target| *target != targets[0]) else { continue };
        targets.swap(0, other);
        for options in all_targets() {
            let text = st::text(&swapped, &options).expect("it fits");
            let names = st::names(&tables, &options);
            let found = difference(&text, names, &tables, &controller, options, CALLS);
            assert!(found.is_some(), "{name} with {options:?}");
        }
    }
}
