//! Families of specifications and plants have the sizes that counting gives.

use sml_tests::families::{ALL, arbiter, cabins, lift, line};
use sml_tests::naive::{self, Semantics};
use sml_tests::{corpus, fast, plant_families};
use synth_core::explore::{Limits, explore};
use synth_core::pipeline::{Options, Timings, synthesize};
use synth_core::plant::{self, supervise};
use synth_core::syntax::FileId;

/// States and transitions of the game.
#[track_caller]
fn size(text: &str) -> (u64, u64) {
    let spec = fast::resolved(text).unwrap_or_else(|wrong| panic!("{wrong}"));
    let explored = explore(&spec, Options::default().semantics, &Limits::default()).expect("a game");
    (explored.game.states() as u64, explored.game.edges() as u64)
}

/// The same as the naive implementation counts them.
#[track_caller]
fn naive_size(text: &str) -> (u64, u64) {
    let spec = naive::Spec::new(&corpus::parse(text).expect("a specification")).expect("a specification");
    let graph = naive::explore(&spec, Semantics::Default, 100_000).expect("a game");
    let figures = graph.figures(&naive::solve(&graph));
    (figures.states as u64, figures.transitions as u64)
}

#[test]
fn production_lines() {
    assert_eq!(size(&line(2)), (3_216, 6_192));
    assert_eq!(size(&line(3)), (45_792, 96_768));
}

/// Unoptimised it takes a minute.
#[cfg(not(debug_assertions))]
#[test]
fn a_production_line_of_four_presses() {
    assert_eq!(size(&line(4)), (635_904, 1_430_784));
}

#[test]
fn lifts() {
    for floors in 2..=7 {
        assert_eq!(size(&lift(floors)), (lift::states(floors), lift::transitions(floors)), "{floors} floors");
    }
    assert_eq!((lift::states(12), lift::transitions(12)), (163_840, 884_736));
}

#[test]
fn arbiters() {
    for clients in 1..=8 {
        let counted = (arbiter::states(clients), arbiter::transitions(clients));
        assert_eq!(size(&arbiter(clients)), counted, "{clients} clients");
    }
}

#[test]
fn lifts_of_two_cabins() {
    for floors in 2..=3 {
        let text = cabins(floors, 2);
        assert_eq!(size(&text), naive_size(&text), "{floors} floors");
    }
}

/// With two numbers the families are the specifications of the corpus, but for their words.
#[test]
fn the_corpus_has_members() {
    for (name, text) in [("line_2", line(2)), ("elevator_3", lift(3)), ("arbiter_2", arbiter(2))] {
        let entry = corpus::all().into_iter().find(|entry| entry.name == name).expect("it is in the corpus");
        assert_eq!(size(&text), size(&entry.text), "{name}");
    }
    assert_eq!(lift(3), include_str!("../specs/elevator_3/spec.sml"));
    assert_eq!(arbiter(2), include_str!("../specs/arbiter_2/spec.sml"));
}

#[test]
fn small_members_have_controllers() {
    for text in [line(1), lift(4), cabins(2, 2), arbiter(3)] {
        let spec = fast::resolved(&text).unwrap_or_else(|wrong| panic!("{wrong}"));
        let options = Options::default();
        let mut solved = fast::solved(&spec, &options).expect("a game");
        synthesize(&mut solved, &options, &mut Timings::default()).expect("a controller");
    }
}

/// Texts of plants are the plants that they are written from.
#[test]
fn plants() {
    for (name, number, plant) in [
        ("transfer-line", 4, plant_families::transfer_line(4)),
        ("philosophers", 3, plant_families::philosophers(3)),
    ] {
        let family = ALL.iter().find(|family| family.name == name).expect("a family");
        let (read, _) = plant::read(&(family.text)(number), FileId(0)).expect("a plant");
        let feedback = |plant| supervise(plant, &Limits::default()).expect("a feedback");
        assert_eq!(feedback(&read), feedback(&plant), "{name}");
    }
    assert_eq!(
        supervise(&plant_families::transfer_line(4), &Limits::default()).expect("a feedback").len(),
        250
    );
}

#[test]
fn every_family_has_small_members() {
    for family in ALL {
        for number in family.least..family.least + 3 {
            let text = (family.text)(number);
            let is_plant = text.starts_with("plant");
            assert!(
                if is_plant { plant::read(&text, FileId(0)).is_ok() } else { corpus::parse(&text).is_ok() },
                "{} {number}",
                family.name
            );
        }
    }
}
