//! Modular supervisors beside the supervisor of the whole plant.

use sml_tests::plant_builder::PlantBuilder;
use sml_tests::plant_families::transfer_line;
use sml_tests::random_plant;
use sml_tests::scan::Plan;
use sml_tests::tables::Random;
use synth_core::diagnostic::Code;
use synth_core::explore::Limits;
use synth_core::pipeline::Timings;
use synth_core::plant::pipeline::{feedback, program_of};
use synth_core::plant::{
    ClosedLoop, Command, Condition, Modular, ModularError, Options, Plant, Signal, SignalKind, StateFeedback,
    SuperviseError, Use, modular, supervise,
};
use synth_core::syntax::Span;

fn modules(plant: &Plant) -> Result<Modular, ModularError> {
    modular(plant, &Limits::default())
}

/// Both inhibit the same, wherever the plant can come.
#[track_caller]
fn check_equal(plant: &Plant, modular: &Modular) {
    let closed = supervise(plant, &Limits::default()).expect("a feedback of the whole");
    for entry in 0..closed.len() {
        let states = closed.entry(entry);
        for event in closed.inhibited(entry) {
            assert!(modular.inhibits(states, *event), "{states:?}: {event} is enabled");
        }
        for (event, _) in closed.edges(entry) {
            assert!(!modular.inhibits(states, *event), "{states:?}: {event} is inhibited");
        }
    }
}

#[test]
fn transfer_lines() {
    for machines in 2..=6 {
        let plant = transfer_line(machines);
        let modular = modules(&plant).expect("modules");
        assert_eq!(modular.modules.len() as u32, machines - 1);
        check_equal(&plant, &modular);
    }
}

/// Of the line of 20 machines the whole feedback would have `2 * 5^19` entries, more than 3 * 10^13.
#[test]
fn long_transfer_lines_take_a_module_a_buffer() {
    for machines in [9, 20, 50] {
        let plant = transfer_line(machines);
        let modular = modules(&plant).expect("modules");
        assert_eq!(modular.modules.len() as u32, machines - 1);
        for module in &modular.modules {
            assert_eq!((module.part.automata.len(), module.closed.len()), (3, 10));
        }
        // Two parts in the buffer behind machine 1, one behind machine 2: the first must wait.
        let mut states = vec![0; plant.automata.len()];
        states[machines as usize] = 2;
        states[machines as usize + 1] = 1;
        let start = |machine: u32| 2 * (machine - 1);
        assert!(modular.inhibits(&states, start(1)));
        assert!(!modular.inhibits(&states, start(2)));
        assert!(!modular.inhibits(&states, start(3)));
        assert!(modular.inhibits(&states, start(4)));
    }
}

#[test]
fn random_plants() {
    let (mut equal, mut conflicts, mut refused, mut several) = (0, 0, 0, 0);
    for seed in 0..4000 {
        let plant = random_plant::plant(seed);
        match modules(&plant) {
            Ok(modular) => {
                check_equal(&plant, &modular);
                equal += 1;
                several += u32::from(modular.modules.len() > 1);
            }
            Err(ModularError::Module(_, SuperviseError::Refused(_))) => {
                assert!(supervise(&plant, &Limits::default()).is_err(), "seed {seed}");
                refused += 1;
            }
            Err(ModularError::Conflict(_)) => conflicts += 1,
            Err(error) => panic!("{error:?}"),
        }
    }
    assert!(
        equal > 1000 && several > 300 && conflicts > 10 && refused > 100,
        "{equal} equal, {several} of them with several modules, {conflicts} conflicts, {refused} refused"
    );
}

/// Two users take two tools in different order. Each tool alone never blocks them, both together do; the whole plant
/// has a feedback.
#[test]
fn conflicts_are_found() {
    let plant = PlantBuilder::new()
        .controllable("saw1 drill1 done1 saw2 drill2 done2")
        .component("User1", "0* saw1 1, 1 drill1 2, 2 done1 0")
        .component("User2", "0* drill2 1, 1 saw2 2, 2 done2 0")
        .constraint("Saw", "F* saw1 T, F saw2 T, T done1 F, T done2 F")
        .constraint("Drill", "F* drill1 T, F drill2 T, T done1 F, T done2 F")
        .build();
    assert_eq!(modules(&plant), Err(ModularError::Conflict(vec![1, 1, 1, 1])));
    assert!(supervise(&plant, &Limits::default()).is_ok());
}

#[test]
fn what_cannot_be_checked_is_told() {
    let limits = Limits { states: 20, ..Limits::default() };
    let mut plant = transfer_line(6);
    // All buffers are to be empty some time.
    for buffer in &mut plant.automata[6..] {
        buffer.states[1..].iter_mut().for_each(|state| state.marked = false);
    }
    let outcome = modular(&plant, &limits).expect("modules");
    assert!(outcome.unknown.is_some());
    assert_eq!(outcome.warnings().last().map(|one| one.code), Some(Code::ConflictUnknown));
    check_equal(&plant, &outcome);
    let known = modules(&plant).expect("modules");
    assert_eq!((known.unknown, known.modules), (None, outcome.modules));
    assert_eq!(modular(&transfer_line(6), &limits).expect("modules").unknown, None);
}

/// Modules that share no automaton cannot conflict, however many there are.
#[test]
fn what_moves_independently_is_not_multiplied() {
    let mut builder = PlantBuilder::new();
    for i in 0..200 {
        builder = builder
            .controllable(&format!("on{i} off{i}"))
            .uncontrollable(&format!("up{i}"))
            .component(&format!("A{i}"), &format!("0* on{i} 1, 1 up{i} 2, 2 off{i} 0"))
            .component(&format!("B{i}"), &format!("0* up{i} 1, 1 off{i} 0"));
    }
    let found = modules(&builder.build()).expect("modules");
    assert_eq!((found.modules.len(), found.unknown), (200, None));
}

/// With inputs that number the states of every component, and an output for every event that the controller causes.
fn readable(mut plant: Plant) -> Plant {
    let signal = |name: String, kind| Signal { name, kind, doc: Vec::new(), span: Span::default() };
    for component in 0..plant.components {
        let states = plant.automata[component].states.len() as u32;
        let first = plant.signals.len() as u32;
        let bits = u32::BITS - (states - 1).leading_zeros();
        plant.signals.extend((0..bits).map(|bit| signal(format!("I{component}_{bit}"), SignalKind::Input)));
        for (state, number) in plant.automata[component].states.iter_mut().zip(0_u32..) {
            let mut literals = (0..bits).map(|bit| {
                let atom = Condition::Atom(first + bit);
                if number >> bit & 1 == 1 { atom } else { Condition::Not(Box::new(atom)) }
            });
            state.formula = match bits {
                0 => None,
                1 => literals.next(),
                _ => Some(Condition::And(literals.collect())),
            };
        }
    }
    for event in plant.events.iter_mut().filter(|event| event.controllable) {
        event.commands = vec![Command { signal: plant.signals.len() as u32, set: true }];
        plant.signals.push(signal(format!("do_{}", event.name), SignalKind::Output));
    }
    plant
}

/// Runs the program of all modules with one event a scan: always the first that the whole feedback enables.
fn check_program(plant: &Plant, closed: &ClosedLoop, feedback: &StateFeedback, seed: u64) {
    let mut random = Random::new(seed);
    let plan = Plan::new(feedback.program.clone(), plant.events.clone());
    let mut state = plan.initial();
    let mut entry = closed.initial as usize;
    for _ in 0..150 {
        for (signal, value) in plant.signals.iter().zip(&mut state.values) {
            *value = match signal.name.strip_prefix('I').and_then(|name| name.split_once('_')) {
                Some((component, bit)) => {
                    let component: usize = component.parse().expect("a number");
                    closed.entry(entry)[component] >> bit.parse::<u32>().expect("a number") & 1 == 1
                }
                None => false,
            };
        }
        let fired = state.scan(&feedback.program);
        let first = closed.edges(entry).iter().find(|edge| plant.events[edge.0 as usize].controllable);
        assert_eq!(fired, first.iter().map(|edge| edge.0).collect::<Vec<_>>(), "{:?}", closed.entry(entry));
        if let Some(&(_, target)) = first {
            entry = target as usize;
            continue;
        }
        let edges = closed.edges(entry);
        if edges.is_empty() {
            return;
        }
        entry = edges[random.below(edges.len() as u32) as usize].1 as usize;
    }
}

#[test]
fn programs_of_modules_do_what_the_whole_feedback_says() {
    let options = Options { extract: true, ..Options::default() };
    let (mut several, mut with_memory, mut shared) = (0, 0, 0);
    for seed in 0..1500 {
        let plant = readable(random_plant::plant(seed));
        let Ok(modular) = modules(&plant) else { continue };
        let Ok(feedback) = program_of(&plant, &modular, options, &mut Timings::default()) else { continue };
        let closed = supervise(&plant, &Limits::default()).expect("a feedback of the whole");
        check_program(&plant, &closed, &feedback, seed);
        several += u32::from(modular.modules.len() > 1);
        with_memory +=
            u32::from(feedback.program.variables.iter().any(|one| matches!(one.usage, Use::Memory(_))));
        let knows = |event: u32| modular.modules.iter().filter(|module| module.knows(event)).count();
        shared += u32::from((0..plant.events.len() as u32).any(|event| knows(event) > 1));
    }
    assert!(
        several > 150 && with_memory > 20 && shared > 50,
        "{several} with several modules, {with_memory} with memory, {shared} with shared events"
    );
}

/// Every event of a line but the outermost belongs to two modules, each with bits of its own.
#[test]
fn programs_of_transfer_lines() {
    let options = Options { extract: true, ..Options::default() };
    for machines in 2..=5 {
        let plant = readable(transfer_line(machines));
        let modular = modules(&plant).expect("modules");
        let feedback = program_of(&plant, &modular, options, &mut Timings::default()).expect("a program");
        let closed = supervise(&plant, &Limits::default()).expect("a feedback of the whole");
        for seed in 0..20 {
            check_program(&plant, &closed, &feedback, seed);
        }
    }
}

/// The whole feedback of this line would have more than 3 * 10^13 entries.
#[test]
fn a_long_line_has_a_program() {
    let plant = readable(transfer_line(20));
    let modular = modules(&plant).expect("modules");
    assert_eq!(modular.modules.len(), 19);
    let feedback = program_of(&plant, &modular, Options::default(), &mut Timings::default());
    let rungs = &feedback.expect("a program").program.rungs;
    assert_eq!(rungs.iter().filter(|rung| rung.event.is_some()).count(), 20);
}

/// What multiplies to more than any limit is refused before it is explored.
#[test]
fn a_hopeless_product_is_refused_at_once() {
    let mut builder = PlantBuilder::new();
    for i in 0..500 {
        builder = builder
            .controllable(&format!("on{i} off{i}"))
            .component(&format!("A{i}"), &format!("0 on{i} 1, 1 off{i} 0"));
    }
    let failure = feedback(&builder.build(), &Limits::default(), &mut Timings::default());
    let diagnostic = failure.expect_err("it is too large").diagnostics().remove(0);
    assert_eq!(diagnostic.code, Code::LimitReached);
    assert!(diagnostic.notes[0].contains("500 independent parts, which have at least 10^150 states"));
    // Limits that suffice are not touched.
    let small = PlantBuilder::new()
        .controllable("a b")
        .component("A", "0 a 1, 1 a 0")
        .component("B", "0 b 1, 1 b 0")
        .build();
    for (states, fits) in [(4, true), (3, false)] {
        let limits = Limits { states, ..Limits::default() };
        assert_eq!(feedback(&small, &limits, &mut Timings::default()).is_ok(), fits);
    }
}
