//! Modular supervisors beside the supervisor of the whole plant.

use sml_tests::plant_builder::PlantBuilder;
use sml_tests::plant_families::transfer_line;
use sml_tests::random_plant;
use synth_core::explore::Limits;
use synth_core::plant::{Modular, ModularError, Plant, SuperviseError, modular, supervise};

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
            assert_eq!((module.automata.len(), module.closed.len()), (3, 10));
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
fn what_cannot_be_checked_is_refused() {
    let limits = Limits { states: 20, ..Limits::default() };
    let mut plant = transfer_line(6);
    // All buffers are to be empty some time.
    for buffer in &mut plant.automata[6..] {
        buffer.states[1..].iter_mut().for_each(|state| state.marked = false);
    }
    let outcome = modular(&plant, &limits);
    assert!(matches!(outcome, Err(ModularError::Unknown(_))), "{outcome:?}");
    check_equal(&plant, &modules(&plant).expect("modules"));
    assert!(modular(&transfer_line(6), &limits).is_ok());
}
