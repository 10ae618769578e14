//! Bits for what constraints remember: followed through the closed loop, they always are what they have to be.

use std::collections::BTreeMap;

use sml_tests::memory_naive;
use sml_tests::plant_builder::PlantBuilder;
use sml_tests::random_plant;
use sml_tests::tables::Random;
use synth_core::explore::Limits;
use synth_core::plant::remember::{Remembered, remember};
use synth_core::plant::{ClosedLoop, EventId, Plant, supervise};

/// Bits after an event, the way a controller changes them: by itself, or by what it sees next.
fn follow(plant: &Plant, closed: &ClosedLoop, bits: &Remembered, entry: usize, edge: (EventId, u32)) -> u32 {
    let sight = |entry: usize| -> Vec<u16> {
        bits.components.iter().map(|&c| closed.entry(entry)[c as usize]).collect()
    };
    let old = bits.codes[entry];
    let (event, target) = edge;
    let caused = if plant.events[event as usize].controllable {
        let before = sight(entry);
        let mut changes =
            bits.caused.iter().filter(|(e, c)| *e == event && c.states == before && c.old == old);
        let change = changes.next();
        assert!(changes.next().is_none(), "two changes of one event");
        change.map_or(old, |(_, change)| change.new)
    } else {
        old
    };
    let after = sight(target as usize);
    let mut changes = bits.seen.iter().filter(|c| c.states == after && c.old == caused);
    let change = changes.next();
    assert!(changes.next().is_none(), "two conclusions");
    change.map_or(caused, |change| change.new)
}

/// Follows every edge; then looks whether states of components and bits say what is enabled.
fn check(plant: &Plant, closed: &ClosedLoop, all: &[Remembered]) {
    for bits in all {
        assert_eq!(bits.codes[closed.initial as usize], bits.initial);
        assert!(bits.codes.iter().all(|&code| code < 1 << bits.bits));
        for entry in 0..closed.len() {
            for &edge in closed.edges(entry) {
                let followed = follow(plant, closed, bits, entry, edge);
                assert_eq!(followed, bits.codes[edge.1 as usize], "{:?} {edge:?}", closed.entry(entry));
            }
        }
    }
    let mut enabled = BTreeMap::new();
    for entry in 0..closed.len() {
        let states = closed.entry(entry)[..plant.components].to_vec();
        let codes: Vec<u32> = all.iter().map(|bits| bits.codes[entry]).collect();
        let events: Vec<EventId> = closed.enabled(plant, entry).collect();
        let before = enabled.entry((states, codes)).or_insert_with(|| events.clone());
        assert_eq!(*before, events, "{:?}", closed.entry(entry));
    }
}

#[track_caller]
fn bits(plant: &Plant) -> Vec<(String, u32)> {
    let closed = supervise(plant, &Limits::default()).expect("there is a feedback");
    let all = remember(plant, &closed).expect("it can be followed");
    check(plant, &closed, &all);
    all.iter().map(|bits| (bits.name(plant), bits.bits)).collect()
}

fn named(all: &[(&str, u32)]) -> Vec<(String, u32)> {
    all.iter().map(|&(name, bits)| (name.to_owned(), bits)).collect()
}

fn line(machines: usize, places: usize) -> Plant {
    let mut builder = PlantBuilder::new();
    for i in 1..=machines {
        builder = builder
            .controllable(&format!("start{i}"))
            .uncontrollable(&format!("done{i}"))
            .component(&format!("M{i}"), &format!("I* start{i} W, W done{i} I"));
    }
    for i in 1..machines {
        let next = i + 1;
        let edges: Vec<String> =
            (0..places).map(|n| format!("S{n} done{i} S{}, S{} start{next} S{n}", n + 1, n + 1)).collect();
        builder = builder.constraint(&format!("B{i}"), &edges.join(", ").replacen("S0", "S0*", 1));
    }
    builder.build()
}

/// A place in the buffer counts as taken from the start of the machine that fills it: three codes for two places, where a
/// count of places and a bit for "was working" would take three bits.
#[test]
fn buffers_of_a_line() {
    assert_eq!(bits(&line(2, 1)), named(&[("B1", 1)]));
    assert_eq!(bits(&line(2, 2)), named(&[("B1", 2)]));
    assert_eq!(bits(&line(3, 3)), named(&[("B1", 2), ("B2", 2)]));
    assert_eq!(bits(&line(4, 2)), named(&[("B1", 2), ("B2", 2), ("B3", 2)]));
}

/// A constraint whose state is that of a component remembers nothing.
#[test]
fn what_components_show_takes_no_bits() {
    let plant = PlantBuilder::new()
        .controllable("start stop")
        .uncontrollable("jam")
        .component("M", "Off* start On, On stop Off, On jam Jammed, Jammed stop Off")
        .constraint("Mirror", "Off* start On, On stop Off, On jam On")
        .build();
    assert_eq!(bits(&plant), []);
}

/// Two events of the plant between the same states: which of them it was cannot be seen.
#[test]
fn what_cannot_be_seen_is_refused() {
    let plant = PlantBuilder::new()
        .controllable("go")
        .uncontrollable("good bad")
        .component("M", "Idle go Busy, Busy good Idle, Busy bad Idle")
        .constraint("Once", "Fine good Fine, Fine bad Broken, Fine go Fine, Broken good Broken")
        .build();
    let closed = supervise(&plant, &Limits::default());
    let Ok(closed) = closed else { panic!("there is a feedback") };
    let error = remember(&plant, &closed).expect_err("nobody can know");
    assert_eq!((error.automaton, error.events), (1, [1, 2]));
}

/// What happens by itself cannot be told apart, and changes both automata or none: each alone cannot be followed, but whether
/// they agree can.
#[test]
fn what_two_automata_say_together() {
    let flip = |event: &str| format!("A done A, A broken B, A {event} B, B done B, B broken A, B {event} A");
    let plant = PlantBuilder::new()
        .controllable("go left right")
        .uncontrollable("done broken")
        .component("M", "Idle go Busy, Busy done Idle, Busy broken Idle")
        .component("Levers", "Any left Any, Any right Any")
        .constraint("L", &flip("left"))
        .constraint("R", &flip("right"))
        .only("go", "L.A && R.A || L.B && R.B")
        .build();
    assert_eq!(bits(&plant), named(&[("L_R", 1)]));
}

/// A machine that ends in one of two ways that look the same, and automata that say after which commands it may start.
fn look_alikes(seed: u64) -> Plant {
    let random = &mut Random::new(seed);
    let mut builder = PlantBuilder::new()
        .controllable("go x y")
        .uncontrollable("u v")
        .component("M", "I go W, W u I, W v I")
        .component(
            "Levers",
            ["S x S, S y S", "S x T, T y S", "S x T, T x S, S y S, T y T"][random.below(3) as usize],
        );
    let automata = 2 + random.below(2);
    let states = 2 + random.below(2);
    let total = random.below(4) > 0;
    // Most automata tell the two ends of the machine apart.
    for automaton in 0..automata {
        let mut edges = Vec::new();
        let shift = u32::from(random.below(4) > 0);
        for state in 0..states {
            for event in ["u", "v", "x", "y", "go"] {
                let target = match event {
                    "u" => state,
                    "v" => (state + shift) % states,
                    _ if !total && random.below(2) == 0 => continue,
                    "go" => state,
                    _ => random.below(states),
                };
                edges.push(format!("s{state} {event} s{target}"));
            }
        }
        builder = builder.constraint(&format!("N{automaton}"), &edges.join(", "));
    }
    // Mostly it matters whether two of them agree.
    let (a, b) = (random.below(automata), random.below(automata));
    let agree = random.below(4) > 0;
    let terms: Vec<String> = (0..states)
        .map(|state| {
            let other = if agree { state } else { random.below(states) };
            format!("N{a}.s{state} && N{b}.s{other}")
        })
        .collect();
    let event = ["go", "x"][random.below(2) as usize];
    builder.only(event, &terms.join(" || ")).build()
}

/// Refused is exactly what no observer can follow; and where bits of one automaton are all, and single events all that happens
/// between two scans, there are no fewer.
#[test]
fn random_plants() {
    let [with_bits, _, unseen, fewest] = try_all(1_000, random_plant::plant);
    assert!(with_bits > 50 && unseen > 5 && fewest > 20);
}

#[test]
fn plants_with_events_that_look_alike() {
    let [with_bits, together, unseen, _] = try_all(250, look_alikes);
    assert!(with_bits > 10 && together > 1 && unseen > 50);
}

/// How many plants get bits, bits of several automata together, none since they cannot be followed, and a number of bits that was
/// compared.
#[track_caller]
fn try_all(seeds: u64, plant: impl Fn(u64) -> Plant) -> [u32; 4] {
    let seeds = std::env::var("SML_SEEDS").ok().and_then(|n| n.parse().ok()).unwrap_or(seeds);
    let (mut with_bits, mut together, mut unseen, mut fewest) = (0, 0, 0, 0);
    for seed in 0..seeds {
        let plant = plant(seed);
        let Ok(closed) = supervise(&plant, &Limits::default()) else { continue };
        let known = memory_naive::can_be_followed(&plant, &closed);
        match remember(&plant, &closed) {
            Ok(all) => {
                assert!(known, "seed {seed}");
                check(&plant, &closed, &all);
                with_bits += u32::from(!all.is_empty());
                together += u32::from(all.iter().any(|bits| bits.automata.len() > 1));
                let bits = all.iter().map(|it| it.bits).sum::<u32>();
                if closed.len() <= 12 && memory_naive::waits(&plant, &closed) {
                    assert_eq!(memory_naive::bits_do(&plant, &closed, 0), bits == 0, "seed {seed}");
                    let [one] = all.as_slice() else { continue };
                    assert!(one.fewest, "seed {seed}");
                    if one.components.len() == plant.components {
                        assert!(!memory_naive::bits_do(&plant, &closed, bits - 1), "seed {seed}");
                        fewest += 1;
                    }
                }
            }
            Err(_) => {
                assert!(!known, "seed {seed}");
                unseen += 1;
            }
        }
    }
    println!("{with_bits} with bits, {together} together, {unseen} not followed, {fewest} compared");
    [with_bits, together, unseen, fewest]
}
