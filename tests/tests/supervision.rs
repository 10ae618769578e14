//! Feedback of plants equals the definition: on random plants against explicit sets of tuples.

use std::collections::BTreeSet;

use sml_tests::plant_naive::{self as naive, Constrained, Tuple};
use sml_tests::random_plant;
use synth_core::explore::Limits;
use synth_core::plant::{
    ClosedLoop, EventId, Plant, Reason, SuperviseError, Synthesis, Unavoidable, Why, supervise,
};

/// How many seeds; `SML_SEEDS` asks for a longer run.
fn seeds(usual: u64) -> std::ops::Range<u64> {
    0..std::env::var("SML_SEEDS").ok().and_then(|n| n.parse().ok()).unwrap_or(usual)
}

fn tuple(states: &[u16]) -> Tuple {
    states.iter().copied().map(u32::from).collect()
}

/// The feedback, and its states by the definition; or why there is none, if the definition agrees.
fn agreed(plant: &Plant, seed: u64) -> Result<(ClosedLoop, Constrained, BTreeSet<Tuple>), Unavoidable> {
    let start = naive::initial(plant);
    let all = naive::constrained(plant, start.clone());
    let set = naive::supremal(plant, &all);
    match supervise(plant, &Limits::default()) {
        Ok(closed) => {
            assert!(set.contains(&start), "seed {seed}: there is no feedback");
            let reached = naive::reachable(&all, &set, start);
            Ok((closed, all, reached))
        }
        Err(SuperviseError::Refused(refusal)) => {
            assert!(!set.contains(&start), "seed {seed}: there is a feedback");
            check_unavoidable(plant, &all, &start, &refusal, seed);
            Err(*refusal)
        }
        Err(error) => panic!("seed {seed}: {error:?}"),
    }
}

/// The play is one of the plant, no longer than need be, and what is said of its end is true.
fn check_unavoidable(plant: &Plant, all: &Constrained, start: &Tuple, shown: &Unavoidable, seed: u64) {
    let end = naive::play(all, start, &shown.play).unwrap_or_else(|| panic!("seed {seed}: no play"));
    assert_eq!(end, tuple(&shown.states), "seed {seed}");
    assert_eq!(Some(shown.play.len()), naive::shortest_play(plant, all, start), "seed {seed}");
    check_end(plant, all, shown, &end, seed);
}

fn check_end(plant: &Plant, all: &Constrained, shown: &Unavoidable, end: &Tuple, seed: u64) {
    let controllable = |event: &EventId| plant.events[*event as usize].controllable;
    let (before, forced) = shown.play.split_at(shown.play.len() - shown.forced);
    assert!(!forced.iter().any(controllable) && before.last().is_none_or(controllable), "seed {seed}");
    assert_eq!(all.bad.contains(end), !matches!(shown.reason, Reason::Blocked { .. }), "seed {seed}");
    match &shown.reason {
        Reason::Never(_) => {}
        Reason::Forbidden(event, _) => {
            assert!(!controllable(event) && naive::possible(plant, end).contains(event), "seed {seed}");
        }
        Reason::Blocked { unmarked, .. } => {
            assert!(naive::hopeless(plant, all).contains(end), "seed {seed}");
            assert_eq!(*unmarked, naive::never_marked(plant, all, end), "seed {seed}");
        }
    }
}

/// Entries, edges and inhibited events are those of the definition, and in order.
fn check_equal(plant: &Plant, closed: &ClosedLoop, all: &Constrained, reached: &BTreeSet<Tuple>, seed: u64) {
    let entries: Vec<Tuple> = (0..closed.len()).map(|entry| tuple(closed.entry(entry))).collect();
    // A set of tuples is in lexicographic order.
    assert_eq!(entries, reached.iter().cloned().collect::<Vec<_>>(), "seed {seed}");
    assert_eq!(entries[closed.initial as usize], naive::initial(plant), "seed {seed}");
    assert_eq!(closed.plant, Some(naive::plant_size(plant)), "seed {seed}");
    let transitions = all.states.values().map(|edges| edges.len() as u64).sum();
    assert_eq!(closed.constrained, (all.states.len() as u64, transitions), "seed {seed}");
    for (entry, states) in entries.iter().enumerate() {
        let edges: Vec<(EventId, Tuple)> = all.states[states]
            .iter()
            .filter(|(_, next)| reached.contains(*next))
            .map(|(&event, next)| (event, next.clone()))
            .collect();
        let found: Vec<(EventId, Tuple)> = closed
            .edges(entry)
            .iter()
            .map(|&(event, target)| (event, entries[target as usize].clone()))
            .collect();
        assert_eq!(found, edges, "seed {seed}, {states:?}");
        let inhibited: Vec<EventId> = naive::possible(plant, states)
            .into_iter()
            .filter(|event| !edges.iter().any(|edge| edge.0 == *event))
            .collect();
        assert_eq!(closed.inhibited(entry), inhibited, "seed {seed}, {states:?}");
    }
}

#[test]
fn feedback_is_that_of_the_definition() {
    let (mut some, mut none, mut inhibited, mut attempts) = (0, 0, 0, 0);
    let seeds = seeds(400);
    let count = seeds.end;
    for seed in seeds {
        let plant = random_plant::plant(seed);
        match agreed(&plant, seed) {
            Err(refusal) => {
                none += 1;
                attempts += u64::from(refusal.forced < refusal.play.len());
            }
            Ok((closed, all, reached)) => {
                check_equal(&plant, &closed, &all, &reached, seed);
                assert!(naive::is_safe(&plant, &all, &reached), "seed {seed}");
                some += 1;
                inhibited += u64::from(!closed.inhibited.is_empty());
            }
        }
    }
    assert!(attempts > 0, "no play leads on towards a marked state");
    assert!(none > count / 8 && some > count / 8 && inhibited > count / 8, "{some} {none} {inhibited}");
}

/// No inhibited event can be added: a constraint forbids it, or from where it leads there is no feedback at all; and
/// the reason that is given for it is a play that shows this.
#[test]
fn feedback_is_maximally_permissive() {
    let (mut forbidden, mut bad, mut blocked) = (0, 0, 0);
    for seed in seeds(400) {
        let plant = random_plant::plant(seed);
        let Ok((closed, all, _)) = agreed(&plant, seed) else { continue };
        let synthesis = Synthesis::new(&plant, &Limits::default()).expect("a feedback");
        for entry in 0..closed.len() {
            let states = tuple(closed.entry(entry));
            for &event in closed.inhibited(entry) {
                let reason = synthesis.why(&closed, entry, event).expect("a reason");
                assert!(!reason.text(&plant).is_empty());
                match (all.states[&states].get(&event), reason) {
                    (None, Why::Forbidden(sources)) => {
                        assert!(!sources.is_empty());
                        forbidden += 1;
                    }
                    (Some(target), Why::Unavoidable(shown)) => {
                        let after = naive::constrained(&plant, target.clone());
                        assert!(!naive::supremal(&plant, &after).contains(target), "seed {seed}");
                        let end = naive::play(&after, target, &shown.play).expect("a play");
                        assert_eq!(end, tuple(&shown.states), "seed {seed}");
                        check_end(&plant, &after, &shown, &end, seed);
                        if shown.forced < shown.play.len() || matches!(shown.reason, Reason::Blocked { .. }) {
                            blocked += 1;
                        } else {
                            bad += 1;
                        }
                    }
                    (target, reason) => panic!("seed {seed}, {states:?}: {target:?} {reason:?}"),
                }
            }
            for &(event, _) in closed.edges(entry) {
                assert_eq!(synthesis.why(&closed, entry, event), None);
            }
        }
    }
    assert!(forbidden > 0 && bad > 0 && blocked > 0, "{forbidden} {bad} {blocked}");
}

/// The fixpoint is the union of all sets that a feedback can keep a plant in, each of them tried.
#[test]
fn the_definition_is_the_largest_of_all_sets() {
    let mut tried = 0;
    for seed in seeds(400) {
        let plant = random_plant::plant(seed);
        let all = naive::constrained(&plant, naive::initial(&plant));
        let states: Vec<&Tuple> = all.states.keys().collect();
        if states.len() > 9 {
            continue;
        }
        tried += 1;
        let mut union = BTreeSet::new();
        for bits in 0..1_u32 << states.len() {
            let chosen = states.iter().enumerate().filter(|(bit, _)| bits >> bit & 1 == 1);
            let set: BTreeSet<Tuple> = chosen.map(|(_, &tuple)| tuple.clone()).collect();
            if naive::is_safe(&plant, &all, &set) {
                union.extend(set);
            }
        }
        assert_eq!(union, naive::supremal(&plant, &all), "seed {seed}");
    }
    assert!(tried > 50, "{tried}");
}

#[test]
fn limits_end_exploration() {
    let plants = || (0..100).map(random_plant::plant);
    let limit = |limits: Limits| {
        plants().filter_map(move |plant| match supervise(&plant, &limits) {
            Err(SuperviseError::Limit(reached)) => Some(reached),
            _ => None,
        })
    };
    let states = limit(Limits { states: 2, ..Limits::default() });
    assert!(states.inspect(|reached| assert_eq!((reached.what, reached.limit), ("states", 2))).count() > 20);
    let memory = limit(Limits { memory: 100, ..Limits::default() });
    assert!(
        memory.inspect(|reached| assert_eq!((reached.what, reached.limit), ("memory", 100))).count() > 20
    );
}
