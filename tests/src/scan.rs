//! Programs of rungs, at random, and what they mean.

mod station;

use crate::tables::Random;
pub use station::{plant, station, with_memory};
use synth_core::controller::tables::Provenance;
use synth_core::emit::scan::Source;
use synth_core::logic::{Expr, Literal, Var};
use synth_core::plant::{Coil, Drive, Event, Program, Rung, Use, Variable};
use synth_core::syntax::Span;

/// A program and the events that its rungs cause.
#[derive(Debug)]
pub struct Plan {
    /// The rungs.
    pub program: Program,
    /// Of the plant.
    pub events: Vec<Event>,
    provenance: Provenance,
}

impl Plan {
    /// A program of a plant with these events.
    #[must_use]
    pub fn new(program: Program, events: Vec<Event>) -> Plan {
        let provenance =
            Provenance { file: "a.plant".to_owned(), hash: "0".repeat(16), ..Provenance::default() };
        Plan { program, events, provenance }
    }

    /// What back ends take.
    #[must_use]
    pub fn source(&self) -> Source<'_> {
        Source { program: &self.program, events: &self.events, provenance: &self.provenance }
    }

    /// Positions of the variables that are of one sort, in their order.
    pub fn variables(&self, wanted: fn(Use) -> bool) -> impl Iterator<Item = usize> {
        let variables = self.program.variables.iter().enumerate();
        variables.filter(move |(_, variable)| wanted(variable.usage)).map(|(index, _)| index)
    }

    /// What is known before a scan: inputs, outputs and memory, as last written or initially.
    #[must_use]
    pub fn initial(&self) -> State {
        let value = |variable: &Variable| variable.usage == Use::Memory(true);
        State {
            values: self.program.variables.iter().map(value).collect(),
            analogues: vec![0; self.program.analogues.len()],
        }
    }

    /// The scans that a back end is tried with, each with the outputs and memory that it begins with: every vector of up
    /// to 12 bits, or else as many as asked for, one after the other, with random inputs.
    #[must_use]
    pub fn scans(&self, random: &mut Random, many: usize) -> Vec<State> {
        let bits: Vec<usize> = self.variables(is_external).collect();
        let mut scans = Vec::new();
        if bits.len() <= 12 {
            for vector in 0..1u32 << bits.len() {
                let mut state = self.initial();
                self.measure(&mut state, random);
                for (place, &bit) in bits.iter().enumerate() {
                    state.values[bit] = vector >> place & 1 == 1;
                }
                scans.push(state);
            }
            return scans;
        }
        let mut state = self.initial();
        for _ in 0..many {
            self.measure(&mut state, random);
            for input in self.variables(|usage| usage == Use::Input) {
                state.values[input] = random.below(2) == 1;
            }
            scans.push(state.clone());
            let _ = state.scan(&self.program);
        }
        scans
    }

    /// Analogue inputs at and around the ends of ranges.
    fn measure(&self, state: &mut State, random: &mut Random) {
        for variable in &self.program.variables {
            if let Use::Range(analogue, low, high) = variable.usage {
                let analogue = &mut state.analogues[analogue as usize];
                match random.below(6) {
                    0 => *analogue = low,
                    1 => *analogue = high,
                    2 => *analogue = low - 1,
                    3 => *analogue = high + 1,
                    _ => {}
                }
            }
        }
    }
}

/// Whether a variable has a value before a scan.
#[must_use]
pub fn is_external(usage: Use) -> bool {
    matches!(usage, Use::Input | Use::Output | Use::Memory(_))
}

/// Whether a variable keeps what a scan wrote.
#[must_use]
pub fn is_kept(usage: Use) -> bool {
    matches!(usage, Use::Output | Use::Memory(_))
}

/// Values of all variables.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct State {
    /// Per variable.
    pub values: Vec<bool>,
    /// Per analogue input.
    pub analogues: Vec<i64>,
}

impl State {
    /// Does a scan as the type of programs tells, and returns which events were caused.
    pub fn scan(&mut self, program: &Program) -> Vec<u32> {
        for (value, variable) in self.values.iter_mut().zip(&program.variables) {
            if let Use::Range(analogue, low, high) = variable.usage {
                *value = (low..=high).contains(&self.analogues[analogue as usize]);
            }
        }
        let mut caused = Vec::new();
        for rung in &program.rungs {
            let holds = rung.condition.eval(&|variable| self.values[variable as usize]);
            for coil in &rung.coils {
                self.drive(coil, holds);
            }
            caused.extend(rung.event.filter(|_| holds));
        }
        caused.sort_unstable();
        caused.dedup();
        caused
    }

    fn drive(&mut self, coil: &Coil, holds: bool) {
        let value = &mut self.values[coil.variable as usize];
        match coil.drive {
            Drive::Set => *value |= holds,
            Drive::Reset => *value &= !holds,
            Drive::Out => *value = holds,
        }
    }
}

/// How large a random program is.
#[derive(Clone, Copy, Debug)]
pub struct Size {
    /// Inputs, outputs, memory bits, scratch variables, ranges.
    pub variables: [u32; 5],
    /// Rungs beside those of scratch variables.
    pub rungs: u32,
    /// How deep conditions are nested.
    pub depth: u32,
}

/// Names that some target takes for something else.
const NAMES: &[&str] = &[
    "if",
    "Ton",
    "enable",
    "controller",
    "STR",
    "not",
    "type",
    "self",
    "inputs",
    "events",
    "holds",
    "condition",
    "main0",
    "Memory",
    "a_rather_long_name_of_a_sensor_at_the_end_of_the_belt",
    "x1",
    "X_1",
    "loop",
    "inputVar",
    "scan",
    "core",
    "std",
    "Option",
    "Default",
    "memory_2",
    "END_IF",
    "EN",
    "ENO",
    "R",
    "TO_INT",
    "raw",
    "async",
    "gen",
];

/// A random program.
#[must_use]
pub fn random(name: &str, size: Size, seed: u64) -> Plan {
    let mut random = Random::new(seed);
    let [inputs, outputs, memory, scratch, ranges] = size.variables;
    let analogues: Vec<String> = (0..ranges.div_ceil(2)).map(|index| format!("level{index}")).collect();
    let mut variables = Vec::new();
    let mut add = |random: &mut Random, usage| {
        let number = variables.len();
        let name = match NAMES.get(number).filter(|_| seed.is_multiple_of(3)) {
            Some(name) => (*name).to_owned(),
            None => format!("{}{number}", ["s", "Sensor", "valveOf_"][random.below(3) as usize]),
        };
        variables.push(Variable { name, usage, doc: vec![" What it is (* for *).".to_owned()] });
    };
    for _ in 0..inputs {
        add(&mut random, Use::Input);
    }
    for _ in 0..outputs {
        add(&mut random, Use::Output);
    }
    for _ in 0..memory {
        let initial = random.below(2) == 1;
        add(&mut random, Use::Memory(initial));
    }
    for index in 0..ranges {
        let low = i64::from(random.below(60)) - 30;
        let wide = i64::from(random.below(20)) + if index == 1 { 40_000 } else { 0 };
        add(&mut random, Use::Range(index / 2, low, low + wide));
    }
    let first_scratch = variables.len() as u32;
    let mut add = |usage| {
        let name = format!("step{}", variables.len());
        variables.push(Variable { name, usage, doc: vec![] });
    };
    (0..scratch).for_each(|_| add(Use::Scratch));
    let events = events(size.rungs.min(5));
    let mut rungs = Vec::new();
    let mut known = first_scratch;
    for number in 0..size.rungs + scratch {
        // Scratch variables are written before they are read.
        let is_scratch = known < first_scratch + scratch && random.below(3) == 0;
        let condition = match random.below(20) {
            0 => Expr::Constant(random.below(2) == 1),
            _ => expr(&mut random, known, size.depth, number % 2 == 0),
        };
        let coils = if is_scratch {
            known += 1;
            vec![Coil { variable: known - 1, drive: Drive::Out }]
        } else {
            coils(&mut random, inputs, outputs + memory)
        };
        let event =
            (!events.is_empty() && random.below(2) == 0).then(|| 2 * random.below(events.len() as u32 / 2));
        rungs.push(Rung {
            event,
            comment: vec![format!("Why it is so: number {number} *) here.")],
            condition,
            coils,
        });
    }
    let program =
        Program { name: name.to_owned(), doc: vec![" A plant.".to_owned()], variables, analogues, rungs };
    Plan::new(program, events)
}

/// Every other one is controllable.
fn events(count: u32) -> Vec<Event> {
    let event = |number| Event {
        name: format!("event{number}"),
        controllable: number % 2 == 0,
        commands: vec![],
        doc: vec![],
        span: Span::default(),
    };
    (0..2 * count).map(event).collect()
}

/// None, one, or some.
fn coils(random: &mut Random, first: u32, count: u32) -> Vec<Coil> {
    let drives = [Drive::Set, Drive::Reset, Drive::Out];
    let coil = |random: &mut Random| Coil {
        variable: first + random.below(count),
        drive: drives[random.below(3) as usize],
    };
    let many = [0, 1, 1, 2, 2, 3][random.below(6) as usize];
    (0..if count == 0 { 0 } else { many }).map(|_| coil(random)).collect()
}

/// An expression over variables below `known`, in which no term has terms of its own kind.
fn expr(random: &mut Random, known: Var, depth: u32, and: bool) -> Expr {
    if known == 0 {
        return Expr::Constant(true);
    }
    let literal = |random: &mut Random| {
        Expr::Literal(Literal { variable: random.below(known), negated: random.below(2) == 1 })
    };
    if depth == 0 || random.below(4) == 0 {
        return literal(random);
    }
    let mut terms: Vec<Expr> = Vec::new();
    for _ in 0..2 + random.below(3) {
        let term = expr(random, known, depth - 1, !and);
        // Synthesis says nothing twice, and linters would object.
        if !terms.contains(&term) {
            terms.push(term);
        }
    }
    match terms.len() {
        1 => literal(random),
        _ if and => Expr::And(terms),
        _ => Expr::Or(terms),
    }
}
