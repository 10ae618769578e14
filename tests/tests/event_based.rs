//! Controllers that follow the events of a plant, beside that plant.

use std::collections::{BTreeMap, BTreeSet};

use sml_tests::beside::{Inputs, Running, compiled};
use sml_tests::plant_builder::PlantBuilder;
use sml_tests::plant_families::{philosophers, transfer_line};
use sml_tests::random_plant;
use sml_tests::reference::Reference;
use sml_tests::tables::Random;
use synth_core::controller::cycle::Machine;
use synth_core::controller::json::{from_json, to_json};
use synth_core::controller::tables::{Provenance, Tables};
use synth_core::controller::{Level, minimize, number};
use synth_core::emit::rust;
use synth_core::emit::st::{self, Target};
use synth_core::explore::Limits;
use synth_core::plant::event_based::{choose, controller, never_given, races, tables};
use synth_core::plant::{ClosedLoop, EventId, Plant, read, supervise};
use synth_core::syntax::FileId;

/// A plant, its closed loop and its controller.
struct Controlled {
    plant: Plant,
    closed: ClosedLoop,
    tables: Tables,
}

/// A controller and the plant under it, between two scans.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
struct Node {
    entry: u32,
    state: u32,
}

/// What a scan does: what happened before it, the command if there was one.
struct Scan {
    /// The entry before the command.
    middle: u32,
    batch: BTreeSet<EventId>,
    command: Option<EventId>,
    next: Node,
}

impl Controlled {
    fn new(plant: Plant) -> Option<Self> {
        let closed = supervise(&plant, &Limits::default()).ok()?;
        let tables = tables(&plant, &closed, Level::Exact, Provenance::default());
        Some(Controlled { plant, closed, tables })
    }

    fn start(&self) -> Node {
        Node { entry: self.closed.initial, state: self.tables.initial }
    }

    fn id(&self, operation: &str) -> EventId {
        self.plant.events.iter().position(|event| event.name == operation).expect("an event") as EventId
    }

    fn index(&self, event: EventId) -> usize {
        let name = &self.plant.events[event as usize].name;
        self.tables.events.iter().position(|table| table.event.operation == *name).expect("an event")
    }

    fn names(&self, events: &[EventId]) -> String {
        events.iter().map(|&event| &*self.plant.events[event as usize].name).collect::<Vec<_>>().join(" ")
    }

    /// Where the plant goes, if the feedback allows it.
    fn after(&self, entry: u32, event: EventId) -> Option<u32> {
        self.closed.edges(entry as usize).iter().find(|edge| edge.0 == event).map(|edge| edge.1)
    }

    fn marked(&self, entry: u32) -> bool {
        let states = self.closed.entry(entry as usize).iter().zip(&self.plant.automata);
        states.into_iter().all(|(&state, automaton)| {
            automaton.states.iter().all(|state| !state.marked) || automaton.states[state as usize].marked
        })
    }

    /// The batches that can happen: which events, and the entry after them.
    fn batches(&self, entry: u32) -> BTreeSet<(BTreeSet<EventId>, u32)> {
        let mut all = BTreeSet::from([(BTreeSet::new(), entry)]);
        let mut work = vec![(BTreeSet::new(), entry)];
        while let Some((events, entry)) = work.pop() {
            for &(event, target) in self.closed.edges(entry as usize) {
                let mut more = events.clone();
                if !self.plant.events[event as usize].controllable
                    && more.insert(event)
                    && all.insert((more.clone(), target))
                {
                    work.push((more, target));
                }
            }
        }
        all
    }

    /// One scan after a batch that brought the plant into `middle`.
    fn scan(&self, state: u32, batch: BTreeSet<EventId>, middle: u32) -> Result<Scan, String> {
        let mut machine = Reference::new(&self.tables);
        machine.state = state;
        machine.pending = batch.iter().map(|&event| self.index(event)).collect();
        let codes = machine.cycle();
        let told = || self.names(&batch.iter().copied().collect::<Vec<_>>());
        if !machine.pending.is_empty() {
            return Err(format!("of `{}` something was lost", told()));
        }
        let issued: Vec<_> = self
            .tables
            .components
            .iter()
            .zip(&codes)
            .filter(|(_, code)| **code != 0)
            .map(|(component, &code)| self.id(&component.commands[code as usize - 1].operation))
            .collect();
        let next = |entry| Node { entry, state: machine.state };
        match issued[..] {
            [] => Ok(Scan { middle, batch, command: None, next: next(middle) }),
            [command] => match self.after(middle, command) {
                Some(entry) => Ok(Scan { middle, batch, command: Some(command), next: next(entry) }),
                None => Err(format!("`{}` is not allowed after `{}`", self.names(&issued), told())),
            },
            _ => Err(format!("`{}` at once", self.names(&issued))),
        }
    }

    /// Everything that can happen, with every batch in every scan.
    fn explore(&self) -> Result<BTreeMap<Node, Vec<Scan>>, String> {
        let mut scans = BTreeMap::new();
        let mut work = vec![self.start()];
        while let Some(node) = work.pop() {
            if scans.contains_key(&node) {
                continue;
            }
            let batches = self.batches(node.entry).into_iter();
            let found: Vec<Scan> = batches
                .map(|(batch, middle)| self.scan(node.state, batch, middle))
                .collect::<Result<_, _>>()?;
            work.extend(found.iter().map(|scan| scan.next));
            scans.insert(node, found);
        }
        Ok(scans)
    }

    /// From everywhere a marked state can be reached, and nothing stands still that need not.
    fn check_progress(&self, scans: &BTreeMap<Node, Vec<Scan>>) {
        let mut good: BTreeSet<Node> = BTreeSet::new();
        loop {
            let before = good.len();
            for (node, scans) in scans {
                let leads = |scan: &Scan| self.marked(scan.middle) || good.contains(&scan.next);
                if self.marked(node.entry) || scans.iter().any(leads) {
                    good.insert(*node);
                }
            }
            if good.len() == before {
                break;
            }
        }
        assert_eq!(good.len(), scans.len(), "blocked");
        for (node, scans) in scans {
            let still = scans.iter().all(|scan| scan.batch.is_empty() && scan.command.is_none());
            let nothing_possible = self.closed.edges(node.entry as usize).is_empty();
            assert!(!still || nothing_possible || self.marked(node.entry), "stands still for nothing");
        }
    }

    /// What is said to be never given is given in no scan, and enabled somewhere; returns how many there are. What only a plant
    /// leads to that does something twice between two scans is not said.
    fn check_never_given(&self, scans: &BTreeMap<Node, Vec<Scan>>) -> usize {
        let given: BTreeSet<EventId> = scans.values().flatten().filter_map(|scan| scan.command).collect();
        let enabled: BTreeSet<EventId> = self.closed.edges.iter().map(|edge| edge.0).collect();
        let never = enabled.difference(&given).filter(|&&id| self.plant.events[id as usize].controllable);
        let expected: Vec<String> =
            never.map(|&id| format!("`{}` is never given", self.plant.events[id as usize].name)).collect();
        let told = never_given(&self.plant, &self.closed);
        for one in &told {
            assert!(expected.contains(&one.message), "{} of {expected:?}", one.message);
        }
        told.len()
    }

    /// Chains of commands end.
    fn check_chains(&self) {
        let chosen = choose(&self.plant, &self.closed);
        for entry in 0..self.closed.len() {
            let mut at = entry;
            let mut steps = 0;
            while let Some((event, target)) = chosen[at] {
                assert!(self.plant.events[event as usize].controllable);
                assert_eq!(self.after(at as u32, event), Some(target));
                (at, steps) = (target as usize, steps + 1);
                assert!(steps <= self.closed.len(), "an endless chain");
            }
        }
    }
}

#[track_caller]
fn controlled(plant: Plant) -> Controlled {
    Controlled::new(plant).expect("a feedback")
}

/// Runs a script: each line a scan with the events that it sees, in the order in which they happened, and behind `:` the
/// command that answers. Every event must be possible, nothing may stay pending.
#[track_caller]
fn check(plant: PlantBuilder, script: &str) {
    let controlled = controlled(plant.build());
    let mut node = controlled.start();
    for line in script.lines().map(str::trim).filter(|line| !line.is_empty()) {
        let (events, command) = line.split_once(':').expect("a colon");
        let mut middle = node.entry;
        let mut batch = BTreeSet::new();
        for name in events.split_whitespace() {
            let event = controlled.id(name);
            middle = controlled.after(middle, event).expect("it can happen");
            batch.insert(event);
        }
        let scan = controlled.scan(node.state, batch, middle).expect(line);
        let issued: Vec<EventId> = scan.command.into_iter().collect();
        assert_eq!(controlled.names(&issued), command.trim(), "{line}");
        node = scan.next;
    }
}

/// The races of a plant, with the entry left out.
#[track_caller]
fn check_races(plant: PlantBuilder, expected: &[&str]) {
    let controlled = controlled(plant.build());
    let races = races(&controlled.plant, &controlled.closed);
    assert_eq!(races.untried, None);
    let found: Vec<_> = races.found.iter().map(|race| controlled.names(&race.events)).collect();
    assert_eq!(found, expected);
}

fn two_machines() -> PlantBuilder {
    PlantBuilder::new()
        .controllable("start1 start2")
        .uncontrollable("done1 done2")
        .component("A", "I start1 W, W done1 I")
        .component("B", "I start2 W, W done2 I")
}

/// The simple schema: two sensors change between two scans.
#[test]
fn simultaneous_events_are_all_taken() {
    check(two_machines(), ": start1 \n : start2 \n done1 done2: start1 \n : start2 \n done2 done1: start1");
}

/// The simple schema: the block of the next state stands upstream, and its event is gone when it gets its turn.
#[test]
fn an_event_for_a_state_upstream_is_not_lost() {
    let plant = PlantBuilder::new()
        .controllable("go")
        .uncontrollable("first second")
        .component("A", "Home first Away, Away second Home")
        .component("B", "Rest first Ready, Ready go Rest")
        .only("go", "A.Home");
    check(plant, "first: \n second: go \n first second: go");
}

/// The same with both events in another scan each, while a command is due.
#[test]
fn an_event_is_taken_although_a_command_is_due() {
    let plant = PlantBuilder::new()
        .controllable("inject draw")
        .uncontrollable("filled emptied out back")
        .component("Barrel", "Empty filled Full, Full emptied Empty")
        .component("Injector", "In inject Moves, Moves out Out, Out draw Returns, Returns back In")
        .only("inject", "Barrel.Full");
    // The barrel is full and empty again within a scan: nothing to inject.
    check(plant.clone(), "filled emptied: \n filled: inject \n out emptied: draw \n back:");
    // It is emptied in the very scan in which the injector comes home and would inject again.
    check(plant, "filled: inject \n out: draw \n back emptied: \n filled: inject");
}

/// Several controllable events: one is chosen, the first in the file, and the next scan does the next.
#[test]
fn of_several_commands_exactly_one_is_given() {
    check(two_machines(), ": start1 \n : start2 \n :");
    // They exclude each other: the second must not be given.
    let one_at_a_time = two_machines().constraint("One", "N start1 Y, N start2 Y, Y done1 N, Y done2 N");
    check(one_at_a_time, ": start1 \n : \n done1: start1 \n :");
}

/// The hierarchical schema: consecutive occurrences of one event are counted, one a scan, and each once.
#[test]
fn consecutive_occurrences_are_counted() {
    let plant = PlantBuilder::new()
        .controllable("pack")
        .uncontrollable("part")
        .component("Belt", "B part B")
        .component("Packer", "P pack P")
        .constraint("Count", "0* part 1, 1 part 2, 2 part 3, 3 part 3, 3 pack 0");
    check(plant, "part: \n part: \n : \n part: pack \n part: \n part: \n part: pack \n :");
}

/// The avalanche: one occurrence of an event makes one transition, although the next state has one of it, too, and one
/// command is given a scan.
#[test]
fn one_occurrence_makes_one_transition() {
    let plant = PlantBuilder::new()
        .controllable("a b")
        .uncontrollable("tick")
        .component("Clock", "0 tick 1, 1 tick 2, 2 tick 3, 3 a 4, 4 b 0");
    check(plant, "tick: \n : \n tick: \n : \n tick: a \n : b \n :");
}

/// Commands follow each other without end only where they must not: a chain ends where the plant has the turn.
#[test]
fn chains_of_commands_are_cut_where_the_plant_has_the_turn() {
    let valve = PlantBuilder::new()
        .controllable("open close light dark")
        .uncontrollable("full drained")
        .component("Valve", "Shut open Open, Open close Shut, Open full Open")
        .component("Lamp", "Dark light Light, Light dark Dark")
        .component("Tank", "Low full High, High drained Low");
    check(valve, ": open \n : \n full: \n drained: \n :");
    // Nothing but the lamp: it is left as it is.
    let lamp = PlantBuilder::new()
        .controllable("light dark")
        .component("Lamp", "Dark light Light*, Light dark Dark");
    check(lamp, ": light \n : \n :");
}

/// What is never given, with the reason.
#[track_caller]
fn check_never_given(plant: PlantBuilder, expected: &[(&str, &str)]) {
    let controlled = controlled(plant.build());
    controlled.check_never_given(&controlled.explore().expect("nothing is lost"));
    let found = never_given(&controlled.plant, &controlled.closed);
    let found: Vec<_> = found.iter().map(|one| (&*one.message, &*one.notes[0])).collect();
    assert_eq!(found, expected);
}

#[test]
fn commands_that_are_never_given() {
    check_never_given(two_machines(), &[]);
    let first = PlantBuilder::new()
        .controllable("go walk")
        .uncontrollable("back")
        .component("A", "Home go Away, Home walk Away, Away back Home");
    let reason = "where it is possible, `go` is given instead: for example in A.Home";
    check_never_given(first, &[("`walk` is never given", reason)]);
    let wait = PlantBuilder::new()
        .controllable("open close")
        .uncontrollable("full")
        .component("Valve", "Shut open Open, Open close Shut, Open full Open");
    let reason = "where it is possible, nothing is given: for example in Valve.Open";
    check_never_given(wait, &[("`close` is never given", reason)]);
    let behind = PlantBuilder::new()
        .controllable("go walk rest")
        .uncontrollable("back")
        .component("A", "Home go Away, Home walk Lost, Lost rest Home, Away back Home");
    check_never_given(
        behind,
        &[
            ("`walk` is never given", "where it is possible, `go` is given instead: for example in A.Home"),
            (
                "`rest` is never given",
                "the controller never comes to where it is possible: for example in A.Lost",
            ),
        ],
    );
}

/// `first` stands in front of `second` in the file, but leads round and round.
#[test]
fn commands_lead_to_marked_states() {
    let plant = PlantBuilder::new().controllable("first second").uncontrollable("back done").component(
        "A",
        "Start first Round, Round back Start, Start second Work, Work done Good*, Good back Start",
    );
    check(plant, ": second \n done: \n back: second");
}

/// Of what the plant allows in both orders, both orders are followed; of what only one order explains, that one.
#[test]
fn events_in_another_order_than_they_happened() {
    let diamond =
        || PlantBuilder::new().uncontrollable("a b").component("D", "0 a 1, 0 b 2, 1 b 3, 2 a 3, 3 a 0");
    check(diamond(), "b a: \n a:");
    check_races(diamond(), &[]);
}

#[test]
fn what_a_scan_cannot_tell_is_found() {
    let order = PlantBuilder::new().uncontrollable("a b").component("D", "0 a 1, 0 b 2, 1 b 3, 2 a 4");
    check_races(order, &["b a"]);
    // `a` is taken first, and then nothing explains `b`.
    let only_behind = PlantBuilder::new().uncontrollable("a b").component("D", "0 a 1, 0 b 2, 2 a 3");
    check_races(only_behind, &["b a"]);
    let level = PlantBuilder::new()
        .uncontrollable("covered topped sank uncovered")
        .component("Level", "L covered E, E topped M, E uncovered L, M sank E");
    check_races(level, &["uncovered covered topped"]);
    let command = PlantBuilder::new()
        .controllable("stop")
        .uncontrollable("jam done")
        .component("A", "0 stop 1, 0 jam 2, 2 done 0, 1 done 0");
    check_races(command, &["jam stop"]);
}

/// A race that is told happens: the controller loses an event or believes in another entry.
#[test]
fn races_are_none_for_nothing() {
    let (mut with, mut without, mut never) = (0, 0, 0);
    for seed in 0..3000 {
        let Some(controlled) = Controlled::new(random_plant::plant(seed)) else { continue };
        let chosen = choose(&controlled.plant, &controlled.closed);
        let races = races(&controlled.plant, &controlled.closed);
        assert_eq!(races.untried, None);
        controlled.check_chains();
        // All entries are states, in this order.
        let all = tables(&controlled.plant, &controlled.closed, Level::None, Provenance::default());
        assert_eq!(all.states as usize, controlled.closed.len());
        let mut of_events = 0;
        for race in &races.found {
            let (&last, others) = race.events.split_last().expect("an event");
            if controlled.plant.events[last as usize].controllable {
                let (_, target) = chosen[race.entry as usize].expect("a command");
                assert_eq!(controlled.after(target, others[0]), None, "seed {seed}");
                continue;
            }
            of_events += 1;
            let real = race.events.iter().try_fold(race.entry, |at, &event| controlled.after(at, event));
            let real = real.expect("it can happen");
            assert_ne!(taken(&controlled, race.entry, &race.events), Some(real), "seed {seed}");
        }
        if of_events == 0 {
            without += 1;
            let scans = controlled.explore().unwrap_or_else(|error| panic!("seed {seed}: {error}"));
            controlled.check_progress(&scans);
            never += controlled.check_never_given(&scans);
        } else {
            with += 1;
        }
    }
    assert!(with > 20 && without > 500, "{with} with races, {without} without");
    assert!(never > 100, "{never} commands that are never given");
}

/// Where the closed loop comes to with pending events, round by round in table order, if it takes them all.
fn taken(controlled: &Controlled, mut entry: u32, events: &[EventId]) -> Option<u32> {
    let mut pending = events.to_vec();
    pending.sort_by_key(|&event| controlled.index(event));
    loop {
        let before = pending.len();
        pending.retain(|&event| match controlled.after(entry, event) {
            Some(target) => {
                entry = target;
                false
            }
            None => true,
        });
        if pending.len() == before {
            return pending.is_empty().then_some(entry);
        }
    }
}

#[track_caller]
fn follows(plant: Plant) -> Tables {
    let controlled = controlled(plant);
    let races = races(&controlled.plant, &controlled.closed);
    let found: Vec<_> = races.found.iter().map(|race| controlled.names(&race.events)).collect();
    assert_eq!((found, races.untried), (Vec::<String>::new(), None));
    controlled.check_chains();
    controlled.check_progress(&controlled.explore().expect("nothing is lost"));
    controlled.tables
}

/// A plant of the corpus.
#[track_caller]
fn corpus(name: &str) -> Plant {
    let path = format!("{}/plants/{name}.plant", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).expect("the corpus is readable");
    read(&text, FileId(0)).expect("a plant").0
}

#[test]
fn the_corpus_is_followed() {
    for name in ["chute", "distribution_station", "philosophers", "transfer_line", "workcell"] {
        follows(corpus(name));
    }
}

#[track_caller]
fn check_races_of(name: &str, expected: &[&str]) {
    let controlled = controlled(corpus(name));
    let races = races(&controlled.plant, &controlled.closed);
    let found: Vec<_> = races.found.iter().map(|race| controlled.names(&race.events)).collect();
    assert_eq!(found, expected, "{name}");
}

/// A plant with an automaton that is called as the other side of all events.
#[test]
fn back_ends_take_the_tables() {
    let named = PlantBuilder::new()
        .controllable("go")
        .uncontrollable("done")
        .component("controller", "I go W, W done I");
    for plant in [corpus("distribution_station"), corpus("tank"), named.build()] {
        let controlled = controlled(plant);
        let controller = number(minimize(controller(&controlled.plant, &controlled.closed), Level::Exact));
        assert_eq!(from_json(&to_json(&controller)), Ok(controller));
        for target in [Target::Iec, Target::Codesys, Target::Twincat, Target::Siemens, Target::Case] {
            let options = st::Options { target, ..st::Options::default() };
            let text = st::text(&controlled.tables, &options).expect("it fits");
            assert!(text.contains(&format!("{}_Controller", controlled.plant.name)));
        }
        let text = rust::text(&controlled.tables, &rust::Options::default());
        assert!(text.contains("pub struct Commands"));
    }
}

#[test]
fn races_are_told() {
    let text = |name: &str| {
        let controlled = controlled(corpus(name));
        races(&controlled.plant, &controlled.closed).found[0].text(&controlled.plant)
    };
    assert_eq!(
        text("tank"),
        "`uncovered`, `covered`, `topped` in this order in one scan are taken for something else"
    );
    assert_eq!(text("cat_and_mouse"), "`c7`, seen only after `c2` was given, fits nowhere any more");
}

#[test]
fn races_of_the_corpus() {
    check_races_of("tank", &["uncovered covered topped"]);
    check_races_of("cat_and_mouse", &["c7 c2"]);
}

/// The station for long, a few events a scan in any order, with the interpreter: by cycles and drained.
#[test]
fn the_station_runs() {
    let station = controlled(corpus("distribution_station"));
    let controller = number(minimize(controller(&station.plant, &station.closed), Level::Exact));
    for drain in [false, true] {
        let mut machine = Machine::new(&controller);
        let mut entry = station.closed.initial;
        let mut random = 1_u32;
        let mut times = vec![0; station.plant.events.len()];
        for _ in 0..20_000 {
            let mut seen = BTreeSet::new();
            for _ in 0..4 {
                random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                let event = (random >> 16) % times.len() as u32;
                let controllable = station.plant.events[event as usize].controllable;
                if let Some(next) = station.after(entry, event)
                    && !controllable
                    && seen.insert(event)
                {
                    entry = next;
                    times[event as usize] += 1;
                }
            }
            for &event in seen.iter().rev() {
                assert!(machine.raise(station.index(event) as u32));
            }
            let commands = if drain { machine.drain() } else { machine.cycle() };
            assert!((0..controller.events.len() as u32).all(|event| !machine.is_pending(event)));
            for command in commands.events {
                let command = station.id(&controller.commands[command as usize].operation);
                entry = station.after(entry, command).expect("the feedback allows it");
                times[command as usize] += 1;
            }
        }
        assert!(times.iter().all(|&times| times > 200), "{times:?}");
    }
}

/// Structured Text in the random plant: a few events before each call, of which none races another, and the commands are
/// those of the feedback.
#[test]
fn structured_text_controls_plants() {
    for (name, target) in [
        ("distribution_station", Target::Iec),
        ("transfer_line", Target::Siemens),
        ("workcell", Target::Case),
    ] {
        let controlled = controlled(corpus(name));
        let options = st::Options { target, trigger: st::Trigger::Level, ..st::Options::default() };
        let unit = compiled(&st::text(&controlled.tables, &options).expect("it fits"), target);
        let mut running = Running::new(&unit, &controlled.tables, &options);
        let mut entry = controlled.closed.initial;
        let mut random = Random::new(3);
        let mut given = BTreeSet::new();
        for _ in 0..2000 {
            let mut events = vec![false; controlled.tables.events.len()];
            for _ in 0..random.below(4) {
                let edges = controlled.closed.edges(entry as usize);
                let (event, target) = edges[random.below(edges.len() as u32) as usize];
                if controlled.plant.events[event as usize].controllable || events[controlled.index(event)] {
                    break;
                }
                events[controlled.index(event)] = true;
                entry = target;
            }
            let outputs = running.call(&Inputs { enable: true, reset: false, events });
            let outputs = outputs.expect("it runs");
            assert!(!outputs.unexpected && !outputs.overrun, "{name}");
            for (component, &code) in controlled.tables.components.iter().zip(&outputs.commands) {
                if code != 0 {
                    let command = controlled.id(&component.commands[code as usize - 1].operation);
                    entry = controlled.after(entry, command).expect("the feedback allows it");
                    given.insert(command);
                }
            }
        }
        assert!(given.len() >= 3, "{name}: {given:?}");
    }
}

#[test]
fn known_plants_are_followed() {
    for machines in 2..=4 {
        follows(transfer_line(machines));
    }
    follows(philosophers(3));
}
