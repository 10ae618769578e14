//! The function block of a text beside the interpreter of controllers, call for call.

use crate::reference::Reference;
use crate::tables::Random;
use st_evaluator::{Dialect, Instance, Slot, Unit};
use synth_core::controller::Controller;
use synth_core::controller::cycle::Machine;
use synth_core::controller::tables::Tables;
use synth_core::emit::st::{self, Cost, NameMap, Options, Target, Trigger, Unexpected};

/// The inputs of a call.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Inputs {
    /// FALSE is a pause.
    pub enable: bool,
    /// Back to the initial state.
    pub reset: bool,
    /// In table order.
    pub events: Vec<bool>,
}

/// The outputs of a call.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Outputs {
    /// Per component its code, 0 for none.
    pub commands: Vec<u32>,
    /// The state after the call.
    pub state: u32,
    /// In table order.
    pub pending: Vec<bool>,
    /// Whether something pending fits nowhere.
    pub unexpected: bool,
    /// Whether something was raised that was pending.
    pub overrun: bool,
    /// In table order which events are owed, where that is an output.
    pub owed: Option<Vec<bool>>,
}

/// The interface of the function block over the interpreter, as `docs/controller.md` tells it.
#[derive(Debug)]
pub struct Model<'a> {
    options: Options,
    machine: Machine<'a>,
    /// Follows the machine, but can forget single events.
    reference: Reference<'a>,
    previous: Vec<bool>,
    unexpected: bool,
}

impl<'a> Model<'a> {
    /// In the initial state. Tables and controller are the same thing.
    #[must_use]
    pub fn new(tables: &'a Tables, controller: &'a Controller, options: Options) -> Model<'a> {
        let previous = vec![false; tables.events.len()];
        let (machine, reference) = (Machine::new(controller), Reference::new(tables));
        Model { options, machine, reference, previous, unexpected: false }
    }

    /// What one call of the function block outputs.
    ///
    /// # Panics
    ///
    /// If the interpreters of tables and of controllers differ.
    pub fn call(&mut self, inputs: &Inputs) -> Outputs {
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
        let owed = self.options.owed.then(|| self.owed());
        Outputs { commands, state, pending, unexpected: self.unexpected, overrun, owed }
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

    /// Per event whether the environment owes it.
    fn owed(&self) -> Vec<bool> {
        let tables = self.reference.tables();
        let owed = &tables.owed[self.reference.state as usize];
        if self.options.unexpected != Unexpected::Drop {
            assert_eq!(self.machine.owed(), owed);
        }
        (0..tables.events.len() as u32).map(|event| owed.contains(&event)).collect()
    }

    /// Whether no super step is due.
    fn machine_waits(&self) -> bool {
        let tables = self.reference.tables();
        tables.super_steps.source.binary_search(&self.reference.state).is_err()
    }
}

/// A function block at work.
#[derive(Debug)]
pub struct Running<'u> {
    instance: Instance<'u>,
    /// `enable` and `reset`.
    control: [Slot; 2],
    /// Inputs in table order.
    events: Vec<Slot>,
    /// Outputs of the components.
    commands: Vec<Slot>,
    state: Slot,
    pending: Slot,
    owed: Option<Slot>,
    /// `unexpected` and `overrun`.
    flags: [Slot; 2],
    /// What no call may exceed.
    bound: Cost,
}

impl<'u> Running<'u> {
    /// The function block in a text of these tables.
    ///
    /// # Panics
    ///
    /// If there is no function block of that name, or an input or output is missing.
    #[must_use]
    pub fn new(unit: &'u Unit, tables: &Tables, options: &Options) -> Running<'u> {
        let names = st::names(tables, options);
        let instance = unit.instance(&names.function_block).expect("the function block is there");
        let bound = st::bound(tables, options).expect("it fits");
        Running::of(instance, &names, "", bound)
    }

    /// The program that passes everything through, run by the text's configuration, in SCL by its organization block.
    ///
    /// # Panics
    ///
    /// If there is none, or an input or output is missing.
    #[must_use]
    pub fn program(unit: &'u Unit, tables: &Tables, options: &Options) -> Running<'u> {
        let names = st::names(tables, options);
        let (instance, prefix) = match options.target {
            Target::Siemens => {
                let block = unit.names().find(|name| name.contains("_Cyclic")).expect("something runs it");
                (unit.instance(block), format!("{}_DB.", names.program))
            }
            _ => (unit.configuration(), "Main0.".to_owned()),
        };
        let bound = st::bound(tables, options).expect("it fits");
        // Two calls at most, and an assignment for every output.
        let statements = bound.statements + 2 + names.components.len() as u64 + 4 + u64::from(options.owed);
        let instance = instance.expect("something runs the program");
        Running::of(instance, &names, &prefix, Cost { statements, ..bound })
    }

    /// `prefix` stands before every name.
    fn of(instance: Instance<'u>, names: &NameMap, prefix: &str, bound: Cost) -> Running<'u> {
        let slot = |name: &str| instance.slot(&format!("{prefix}{name}")).expect("an input or output");
        let control = ["enable", "reset"].map(slot);
        let events = names.events.iter().map(|(_, name)| slot(name)).collect();
        let commands = names.components.iter().map(|component| slot(&component.output)).collect();
        let (state, pending) = (slot("state_no"), slot("pending"));
        // Only where it is asked for.
        let owed = instance.slot(&format!("{prefix}owed")).ok();
        let flags = ["unexpected", "overrun"].map(slot);
        Running { instance, control, events, commands, state, pending, owed, flags, bound }
    }

    /// What a power cycle makes of it: `fresh`, with what this one retains. What `fresh` has no place for is lost.
    #[must_use]
    pub fn after_power_cycle<'v>(&self, mut fresh: Running<'v>) -> Running<'v> {
        for (path, value) in self.instance.retained() {
            let _ = fresh.instance.set(&path, value);
        }
        fresh
    }

    /// Whether a power cycle leaves anything.
    #[must_use]
    pub fn retains(&self) -> bool {
        !self.instance.retained().is_empty()
    }

    /// Outputs, or what is wrong with the call itself.
    ///
    /// # Errors
    ///
    /// It fails, wraps integers around, or takes more than its bound.
    ///
    /// # Panics
    ///
    /// If an input is written, or something is of another type than the contract says.
    pub fn call(&mut self, inputs: &Inputs) -> Result<Outputs, String> {
        let block = &mut self.instance;
        for (slot, value) in self.control.into_iter().zip([inputs.enable, inputs.reset]) {
            block.set_at(slot, value).expect("an input");
        }
        for (slot, value) in self.events.iter().zip(&inputs.events) {
            block.set_at(*slot, *value).expect("an input");
        }
        let stats = block.call().map_err(|error| error.to_string())?;
        let Cost { statements, iterations, probes } = self.bound;
        let exceeds =
            stats.statements > statements || stats.iterations > iterations || stats.compared > probes;
        if stats.wrapped > 0 || exceeds {
            return Err(format!(
                "integers are too narrow or the bound is too small: {stats:?}, {:?}",
                self.bound
            ));
        }
        let number = |slot: &Slot| block.get_at(*slot).as_int().and_then(|number| u32::try_from(number).ok());
        let flag = |slot: &Slot| block.get_at(*slot).as_bool().expect("a `BOOL`");
        for (slot, value) in self.events.iter().zip(&inputs.events) {
            assert_eq!(flag(slot), *value, "inputs are not written");
        }
        let bools = |slot: Slot| -> Vec<bool> {
            let array = block.get_at(slot);
            let values = array.as_array().expect("an array").iter().take(inputs.events.len());
            values.map(|value| value.as_bool().expect("a `BOOL`")).collect()
        };
        Ok(Outputs {
            commands: self.commands.iter().map(|slot| number(slot).expect("a code")).collect(),
            state: number(&self.state).expect("a state"),
            pending: bools(self.pending),
            owed: self.owed.map(bools),
            unexpected: flag(&self.flags[0]),
            overrun: flag(&self.flags[1]),
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
#[must_use]
pub fn dialect(target: Target) -> Dialect {
    match target {
        Target::Iec | Target::Case => Dialect::Edition2,
        Target::Codesys => Dialect::Codesys,
        Target::Twincat => Dialect::TwinCat,
        Target::Siemens => Dialect::Siemens,
    }
}

/// The compiled text of a target.
///
/// # Panics
///
/// If it does not compile.
#[must_use]
pub fn compiled(text: &str, target: Target) -> Unit {
    Unit::parse(text, dialect(target)).unwrap_or_else(|errors| {
        let errors: Vec<String> = errors.iter().map(ToString::to_string).collect();
        panic!("{}\n{text}", errors.join("\n"));
    })
}

/// The first of so many calls with random inputs in which a text and the interpreter differ. The tables give the
/// text's names, and are what the controller is laid out as.
#[must_use]
pub fn difference(
    text: &str,
    tables: &Tables,
    controller: &Controller,
    options: Options,
    calls: usize,
) -> Option<String> {
    let unit = compiled(text, options.target);
    first_difference(Running::new(&unit, tables, &options), Model::new(tables, controller, options), calls)
}

/// The first of so many calls with random inputs in which they differ.
#[must_use]
pub fn first_difference(mut running: Running<'_>, model: Model<'_>, calls: usize) -> Option<String> {
    for (call, (inputs, expected)) in stimuli(model).take(calls).enumerate() {
        let found = running.call(&inputs);
        if found.as_ref() != Ok(&expected) {
            return Some(format!("call {call}: {found:?} instead of {expected:?}"));
        }
    }
    None
}

/// Calls with random inputs without end, the same for the same model: what goes in, and what must come out.
pub fn stimuli(mut model: Model<'_>) -> impl Iterator<Item = (Inputs, Outputs)> {
    let mut random = Random::new(0x5EED);
    std::iter::repeat_with(move || {
        let inputs = inputs(&model.reference, &model.previous, &mut random);
        let outputs = model.call(&inputs);
        (inputs, outputs)
    })
}
