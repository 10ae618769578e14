//! Figures of the published experiment, programs beside the closed loop, and what is refused.

use super::{Options, StateFeedback, state_feedback};
use crate::explore::Limits;
use crate::logic::{Expr, Words, run};
use crate::plant::remember::{Remembered, remember};
use crate::plant::{
    ClosedLoop, DontCare, Drive, EventId, FormulaError, Plant, SignalKind, Use, read, supervise,
};
use crate::syntax::FileId;

const EXACT: Options = Options { dont_care: DontCare::None, two_level: false, share: false, extract: false };

#[track_caller]
fn plant(text: &str) -> Plant {
    read(text, FileId(0)).expect("a plant").0
}

/// Festo's distribution station.
fn station() -> Plant {
    plant(include_str!("../../../../tests/plants/distribution_station.plant"))
}

fn closed_loop(plant: &Plant) -> ClosedLoop {
    supervise(plant, &Limits::default()).expect("a feedback")
}

/// All combinations of options.
fn all_options() -> impl Iterator<Item = Options> {
    let policies = [DontCare::None, DontCare::Decodable, DontCare::All];
    policies.into_iter().flat_map(|dont_care| {
        (0..8).map(move |bits| Options {
            dont_care,
            two_level: bits & 1 != 0,
            share: bits & 2 != 0,
            extract: bits & 4 != 0,
        })
    })
}

fn event(plant: &Plant, name: &str) -> EventId {
    plant.events.iter().position(|event| event.name == name).expect("an event") as EventId
}

fn state_of(plant: &Plant, entry: &[u16], component: usize) -> String {
    plant.automata[component].states[entry[component] as usize].name.clone()
}

/// The states of components that a row of signals shows, if it shows one of each.
fn decode(plant: &Plant, holds: impl Fn(u32) -> bool) -> Option<Vec<u16>> {
    plant.automata[..plant.components]
        .iter()
        .map(|component| {
            let shown = component.states.iter().position(|state| {
                state.formula.as_ref().is_none_or(|formula| formula.eval(&|&signal| holds(signal)))
            });
            shown.map(|state| state as u16)
        })
        .collect()
}

fn find(closed: &ClosedLoop, states: &[u16]) -> Option<usize> {
    (0..closed.len()).find(|&entry| closed.entry(entry) == states)
}

#[test]
fn the_station_takes_few_instructions() {
    let plant = station();
    let closed = closed_loop(&plant);
    assert_eq!(closed.len(), 52);
    let figures = |options| {
        let figures = state_feedback(&plant, &closed, &[], options).unwrap().program.figures();
        (figures.instructions, figures.stack_depth, figures.rungs, figures.literals)
    };
    let two_level = Options { two_level: true, ..EXACT };
    assert_eq!(figures(two_level), (116, 2, 6, 99));
    assert_eq!(figures(EXACT), (69, 2, 6, 55));
    assert_eq!(figures(Options { share: true, ..EXACT }), (68, 2, 7, 54));
    assert_eq!(figures(Options { extract: true, ..EXACT }), (80, 2, 6, 60));
    assert_eq!(figures(Options { dont_care: DontCare::Decodable, ..EXACT }), (64, 2, 6, 50));
    assert_eq!(figures(Options { dont_care: DontCare::Decodable, ..two_level }), (107, 2, 6, 90));
    assert_eq!(figures(Options { dont_care: DontCare::All, ..EXACT }), (38, 2, 6, 27));
    assert_eq!(figures(Options { dont_care: DontCare::All, ..two_level }), (45, 2, 6, 33));
}

#[test]
fn right_is_enabled_in_six_of_fourteen_rows() {
    let plant = station();
    let closed = closed_loop(&plant);
    let feedback = state_feedback(&plant, &closed, &[], EXACT).unwrap();
    let right = event(&plant, "right");
    let formula = feedback.formulas.iter().find(|formula| formula.event == right).unwrap();
    let mut enabled = Vec::new();
    let mut rows = 0;
    for entry in (0..closed.len()).map(|entry| closed.entry(entry)) {
        if state_of(&plant, entry, 2) != "B2D" {
            continue;
        }
        rows += 1;
        let shown = (0..1u32 << plant.signals.len()).filter(|row| {
            decode(&plant, |signal| row >> signal & 1 == 1).is_some_and(|states| states == entry)
        });
        let values: Vec<bool> =
            shown.map(|row| formula.factored.eval(&|signal| row >> signal & 1 == 1)).collect();
        assert!(!values.is_empty() && values.iter().all(|value| *value == values[0]));
        if values[0] {
            enabled.push([0, 1, 3].map(|component| state_of(&plant, entry, component)).join(" "));
        }
    }
    assert_eq!(rows, 14);
    assert_eq!(enabled, ["I2B BF HF", "I2B BF HH", "IMB BE HF", "IMB BE HH", "IMB BF HF", "IMB BF HH"]);
}

#[test]
fn formulas_hold_where_the_feedback_enables() {
    let plant = station();
    let closed = closed_loop(&plant);
    for dont_care in [DontCare::None, DontCare::Decodable, DontCare::All] {
        let options = Options { dont_care, ..EXACT };
        let feedback = state_feedback(&plant, &closed, &[], options).unwrap();
        for row in 0..1u32 << plant.signals.len() {
            let holds = |signal: u32| row >> signal & 1 == 1;
            let states = decode(&plant, holds);
            let entry = states.as_ref().and_then(|states| find(&closed, states));
            for formula in &feedback.formulas {
                let cover = formula.terms.as_ref().unwrap().cover.expr();
                let free = match dont_care {
                    DontCare::None => false,
                    DontCare::Decodable => states.is_some(),
                    DontCare::All => true,
                };
                if entry.is_none() && free {
                    continue;
                }
                let enabled = entry.is_some_and(|entry| {
                    closed.edges(entry).iter().any(|(event, _)| *event == formula.event)
                });
                assert_eq!(formula.factored.eval(&holds), enabled, "{options:?} {row:b}");
                assert_eq!(cover.eval(&holds), enabled, "{options:?} {row:b}");
            }
        }
    }
}

/// Runs the program beside the closed loop: uncontrollable events happen in between, some scans see several. `signals` says
/// what inputs are in an entry with these outputs; returns how often each event was caused.
#[track_caller]
fn beside(plant: &Plant, closed: &ClosedLoop, feedback: &StateFeedback, options: Options) -> Vec<usize> {
    let program = &feedback.program;
    let mut values: Vec<u64> = program
        .variables
        .iter()
        .map(|variable| match variable.usage {
            // What a relay holds before it is written must not matter.
            Use::Memory(true) | Use::Scratch => 1,
            _ => 0,
        })
        .collect();
    let mut entry = closed.initial as usize;
    let mut random = 0x2545_f491_4f6c_dd1d_u64;
    let mut next = |below: usize| {
        random ^= random << 13;
        random ^= random >> 7;
        random ^= random << 17;
        (random >> 32) as usize % below
    };
    // Outputs may be anything that the initial states allow.
    let mut first = true;
    let mut caused = vec![0; plant.events.len()];
    for _ in 0..1_000 {
        for _ in 0..next(4) {
            let own: Vec<u32> = closed
                .edges(entry)
                .iter()
                .filter(|(event, _)| !plant.events[*event as usize].controllable)
                .map(|(_, target)| *target)
                .collect();
            if !own.is_empty() {
                entry = own[next(own.len())] as usize;
            }
        }
        show(plant, closed.entry(entry), &mut values, first);
        first = false;
        let mut fired = 0;
        for rung in &program.rungs {
            let list = rung.instructions();
            let condition =
                run(&mut Words, &list[..list.len() - rung.coils.len()], &mut values).unwrap().unwrap();
            if let (Some(event), 1) = (rung.event, condition & 1) {
                let edge = closed.edges(entry).iter().find(|(other, _)| *other == event);
                entry = edge.unwrap_or_else(|| panic!("{options:?} {event} in {entry}")).1 as usize;
                caused[event as usize] += 1;
                fired += 1;
            } else if let Some(event) = rung.event
                && !(options.extract && fired > 0)
            {
                let enabled = closed.edges(entry).iter().any(|(other, _)| *other == event);
                assert!(!enabled, "{options:?} {event} not fired in {entry}");
            }
            run(&mut Words, &list, &mut values).unwrap();
        }
        assert!(!options.extract || fired < 2);
    }
    caused
}

/// Sets inputs, and at first outputs, too, so that the signals show the states.
#[track_caller]
fn show(plant: &Plant, states: &[u16], values: &mut [u64], outputs: bool) {
    let free: Vec<usize> = (0..plant.signals.len())
        .filter(|&signal| match plant.signals[signal].kind {
            SignalKind::Input | SignalKind::Range { .. } => true,
            SignalKind::Output | SignalKind::Memory => outputs,
        })
        .collect();
    for row in 0..1u32 << free.len() {
        for (place, &signal) in free.iter().enumerate() {
            values[signal] = u64::from(row >> place & 1);
        }
        if decode(plant, |signal| values[signal as usize] & 1 == 1)
            .is_some_and(|shown| shown == states[..plant.components])
        {
            return;
        }
    }
    panic!("no inputs show {states:?}");
}

#[test]
fn the_station_runs() {
    let plant = station();
    let closed = closed_loop(&plant);
    for options in all_options() {
        let feedback = state_feedback(&plant, &closed, &[], options).unwrap();
        let caused = beside(&plant, &closed, &feedback, options);
        let names = ["inject", "reset", "right", "left", "grab", "rls"];
        assert!(names.iter().all(|name| caused[event(&plant, name) as usize] > 10), "{options:?} {caused:?}");
    }
}

/// Two machines around a buffer for two, which nothing shows.
const BUFFER: &str = "
plant Line {
    output A, B
    input ReadyA, ReadyB
    controllable startA { set A }
    controllable startB { set B }
    controllable restA { reset A }
    controllable restB { reset B }
    uncontrollable doneA
    uncontrollable doneB
    automaton First {
        initial state Idle [!A && !ReadyA] { startA -> Busy }
        state Busy [A && !ReadyA] { doneA -> Done }
        state Done [A && ReadyA] { restA -> Back }
        state Back [!A && ReadyA] { clearA -> Idle }
    }
    automaton Second {
        initial state Idle [!B && !ReadyB] { startB -> Busy }
        state Busy [B && !ReadyB] { doneB -> Done }
        state Done [B && ReadyB] { restB -> Back }
        state Back [!B && ReadyB] { clearB -> Idle }
    }
    uncontrollable clearA
    uncontrollable clearB
    constraint automaton Buffer {
        initial state Empty { restA -> One }
        state One { restA -> Two startB -> Empty }
        state Two { startB -> One }
    }
}";

fn with_memory(text: &str) -> (Plant, ClosedLoop, Vec<Remembered>) {
    let plant = plant(text);
    let closed = closed_loop(&plant);
    let memory = remember(&plant, &closed).expect("memory");
    (plant, closed, memory)
}

#[test]
fn memory_follows_the_constraint() {
    let (plant, closed, memory) = with_memory(BUFFER);
    assert_eq!(memory.iter().map(|remembered| remembered.bits).sum::<u32>(), 2);
    for options in all_options() {
        let feedback = state_feedback(&plant, &closed, &memory, options).unwrap();
        let caused = beside(&plant, &closed, &feedback, options);
        assert!(caused[event(&plant, "startB") as usize] > 100, "{options:?} {caused:?}");
    }
}

/// Relays that the plant declares, and bits for two constraint automata.
#[test]
fn relays_and_bits_together() {
    let (plant, closed, memory) = with_memory(include_str!("../../../../tests/plants/mixer.plant"));
    assert_eq!(memory.iter().map(|remembered| remembered.bits).collect::<Vec<_>>(), [1, 2]);
    for options in all_options() {
        let feedback = state_feedback(&plant, &closed, &memory, options).unwrap();
        let caused = beside(&plant, &closed, &feedback, options);
        for name in ["left", "right", "rinse", "stopB"] {
            assert!(caused[event(&plant, name) as usize] > 5, "{options:?} {name} {caused:?}");
        }
    }
}

/// Either of two relays may show the initial state, and one output is on: some relay has to be on at first.
#[test]
fn relays_show_the_initial_state() {
    let text = |formula: &str| {
        format!(
            "plant P {{
                output Y memory M, N
                controllable on {{ set Y set M reset N }}
                controllable off {{ reset Y reset M reset N }}
                automaton A {{
                    initial state First [{formula}] {{ off -> Second }}
                    state Second [!Y && !M && !N] {{ on -> First }}
                }}
            }}"
        )
    };
    for (formula, values) in
        [("M || N", [false, true]), ("Y && M && !N", [true, false]), ("M && N || Y && M", [true, true])]
    {
        let plant = plant(&text(formula));
        let feedback = state_feedback(&plant, &closed_loop(&plant), &[], EXACT).unwrap();
        let usage = |name: &str| {
            feedback
                .program
                .variables
                .iter()
                .find(|variable| variable.name == name)
                .map(|variable| variable.usage)
        };
        assert_eq!([usage("M"), usage("N")], values.map(|value| Some(Use::Memory(value))), "{formula}");
    }
}

#[test]
fn without_memory_two_entries_look_the_same() {
    let (plant, closed, _) = with_memory(BUFFER);
    let error = state_feedback(&plant, &closed, &[], EXACT).unwrap_err();
    let FormulaError::Indistinguishable { entries: [a, b], .. } = error else { panic!("{error:?}") };
    assert_eq!(closed.entry(a)[..plant.components], closed.entry(b)[..plant.components]);
    let text = error.text(&plant, &closed);
    let names = [a, b].map(|entry| state_of(&plant, closed.entry(entry), 2));
    assert!(names.iter().all(|name| text.contains(&format!("Buffer.{name}"))), "{text}");
}

#[test]
fn states_that_can_look_the_same_are_found() {
    // Resolution refuses this text; formulas are checked on their own.
    let mut plant = station();
    let closed = closed_loop(&plant);
    // Where the boom is cannot be told any longer.
    let boom = plant.automata.iter_mut().find(|automaton| automaton.name == "Boom").unwrap();
    boom.states.iter_mut().for_each(|state| state.formula = None);
    let error = state_feedback(&plant, &closed, &[], EXACT).unwrap_err();
    let FormulaError::Indistinguishable { event, entries: [a, b] } = error else { panic!("{error:?}") };
    let enables = |entry: usize| closed.edges(entry).iter().any(|(other, _)| *other == event);
    assert_ne!(enables(a), enables(b));
    let differing = (0..4).filter(|&i| closed.entry(a)[i] != closed.entry(b)[i]);
    assert_eq!(differing.collect::<Vec<_>>(), [2]);
}

#[test]
fn an_event_that_never_fires_has_no_rung() {
    let plant = plant(
        "plant P {
            output Y
            controllable on { set Y }
            controllable off { reset Y }
            automaton A {
                initial state Off [!Y] { on -> On }
                state On [Y] { off -> Off }
            }
            constraint Stay: off only when A.Off
        }",
    );
    let feedback = state_feedback(&plant, &closed_loop(&plant), &[], EXACT).unwrap();
    assert_eq!(feedback.program.rungs.len(), 1);
    assert_eq!(feedback.program.doc, ["`off` never fires: no entry enables it"]);
}

#[test]
fn a_condition_that_always_holds_has_contacts() {
    let plant = plant(
        "plant P {
            output Y
            controllable again { set Y }
            automaton A { initial state Any [Y || !Y] { again -> Any } }
        }",
    );
    let feedback = state_feedback(&plant, &closed_loop(&plant), &[], EXACT).unwrap();
    assert_eq!(
        feedback.program.rungs[0].condition,
        Expr::Or(vec![Expr::literal(0, true), Expr::literal(0, false)])
    );
    assert_eq!(feedback.program.figures().instructions, 3);
}

#[test]
fn rungs_say_what_they_are_for() {
    let plant = station();
    let feedback = state_feedback(&plant, &closed_loop(&plant), &[], EXACT).unwrap();
    assert_eq!(
        feedback.program.rungs[2].comment,
        ["possible in Boom.B2D: 6 of 14 entries enable it", "inhibited by RoomToSwing in 8",]
    );
    let drives: Vec<_> =
        feedback.program.rungs[2].coils.iter().map(|coil| (coil.variable, coil.drive)).collect();
    assert_eq!(drives, [(0, Drive::Reset), (1, Drive::Set)]);
}

#[test]
fn a_relay_gets_a_name_of_its_own() {
    let plant = plant(
        "plant P {
            output Fired, fired2
            controllable a { set Fired }
            controllable b { set fired2 }
            automaton A { initial state Off [!Fired] { a -> On } state On [Fired] }
            automaton B { initial state Off [!fired2] { b -> On } state On [fired2] }
        }",
    );
    let options = Options { extract: true, ..EXACT };
    let feedback = state_feedback(&plant, &closed_loop(&plant), &[], options).unwrap();
    assert_eq!(feedback.program.variables[2].name, "fired3");
}

/// A line of machines with buffers for two that are seen, each of which starts when there is something to take and room behind.
fn line(machines: usize) -> (Plant, ClosedLoop) {
    let mut text = String::from("plant Line {\n");
    for i in 0..machines {
        text += &format!("output M{i}\ninput L{i}, H{i}\n");
        text += &format!("controllable start{i} {{ set M{i} }}\nuncontrollable done{i}\n");
    }
    let last = machines - 1;
    for i in 0..machines {
        text += &format!(
            "automaton Machine{i} {{ initial state Idle [!M{i}] {{ start{i} -> Busy }} state Busy [M{i}] {{ done{i} -> Idle }} }}\n"
        );
    }
    for i in 0..last {
        let next = i + 1;
        text += &format!(
            "automaton Buffer{i} {{
                initial state Empty [!L{i} && !H{i}] {{ done{i} -> One }}
                state One [L{i} && !H{i}] {{ done{i} -> Two start{next} -> Empty }}
                state Two [L{i} && H{i}] {{ start{next} -> One done{i} -> Full }}
                state Full [!L{i} && H{i}] {{ start{next} -> Two }}
            }}
            constraint Room{i}: start{i} only when Buffer{i}.Empty || Buffer{i}.One\n"
        );
    }
    text += "}";
    let plant = plant(&text);
    let closed = closed_loop(&plant);
    (plant, closed)
}

#[test]
fn a_line_of_machines_falls_into_parts() {
    let (plant, closed) = line(6);
    assert_eq!(closed.len(), 2 * 5usize.pow(5));
    let feedback = state_feedback(&plant, &closed, &[], EXACT).unwrap();
    // Two parts per buffer, which a disjunction multiplies out.
    let terms = feedback.formulas.iter().map(|formula| {
        let terms = formula.terms.as_ref().unwrap();
        (terms.cover.cubes.len(), terms.proven)
    });
    let middle = (16, true);
    assert_eq!(terms.collect::<Vec<_>>(), [middle, middle, middle, middle, middle, (32, true)]);
    let figures = feedback.program.figures();
    assert_eq!((figures.instructions, figures.stack_depth), (111, 2));
}
