//! Programs of rungs beside plants that answer late: after a command inputs are as before, often for many scans. Whatever
//! fires must be enabled where the plant is by the events that have happened.

use std::collections::{BTreeMap, VecDeque};

use sml_tests::random_plant;
use sml_tests::random_signals::with_signals;
use sml_tests::tables::Random;
use synth_core::diagnostic::Code;
use synth_core::explore::Limits;
use synth_core::plant::{
    ClosedLoop, Drive, Options, Plant, SignalKind, StateFeedback, Use, read, remember, state_feedback,
    supervise, unreadable, warnings,
};
use synth_core::syntax::FileId;

/// A plant, its program, and where it is.
struct Play<'a> {
    plant: &'a Plant,
    closed: &'a ClosedLoop,
    feedback: &'a StateFeedback,
    random: Random,
    /// Of all variables of the program.
    values: Vec<bool>,
    entry: usize,
    fired: usize,
}

impl<'a> Play<'a> {
    fn new(plant: &'a Plant, closed: &'a ClosedLoop, feedback: &'a StateFeedback, seed: u64) -> Option<Self> {
        let values = vec![false; feedback.program.variables.len()];
        let entry = closed.initial as usize;
        let mut play = Play { plant, closed, feedback, random: Random::new(seed), values, entry, fired: 0 };
        play.show(entry, true).then_some(play)
    }

    /// The state of a component that is read.
    fn state(&self, values: &[bool], component: usize) -> Option<u16> {
        let states = &self.plant.automata[component].states;
        let holds =
            |formula: &synth_core::plant::Condition<u32>| formula.eval(&|&signal| values[signal as usize]);
        states.iter().position(|state| state.formula.as_ref().is_none_or(holds)).map(|state| state as u16)
    }

    /// Whether nothing that is read contradicts an entry.
    fn fits(&self, entry: usize) -> bool {
        let states = self.closed.entry(entry);
        (0..self.plant.components).all(|component| {
            self.state(&self.values, component).is_none_or(|state| state == states[component])
        })
    }

    /// Gives inputs, and outputs if asked for, random values that show an entry, if there are any.
    fn show(&mut self, entry: usize, outputs: bool) -> bool {
        let mut values = self.values.clone();
        for component in 0..self.plant.components {
            let wanted = self.closed.entry(entry)[component];
            // Those of the component.
            let mut own: Vec<u32> = Vec::new();
            for formula in
                self.plant.automata[component].states.iter().filter_map(|state| state.formula.as_ref())
            {
                formula.atoms(&mut |&signal| own.push(signal));
            }
            own.retain(|&signal| outputs || self.plant.signals[signal as usize].kind == SignalKind::Input);
            own.sort_unstable();
            own.dedup();
            let first = self.random.below(1 << own.len());
            let found = (0..1u32 << own.len()).find(|row| {
                for (place, &signal) in own.iter().enumerate() {
                    values[signal as usize] = (row ^ first) >> place & 1 == 1;
                }
                self.state(&values, component) == Some(wanted)
            });
            if found.is_none() {
                return false;
            }
        }
        let before = std::mem::replace(&mut self.values, values);
        // Components may share an output.
        let fits = self.fits(entry);
        if !fits {
            self.values = before;
        }
        fits
    }

    /// Something happens by itself, or inputs change that mean nothing; or nothing happens.
    fn plant_moves(&mut self) {
        let own: Vec<usize> = self.by_itself(self.entry).collect();
        if own.is_empty() || self.random.below(3) == 0 {
            self.show(self.entry, false);
        } else {
            let next = own[self.random.below(own.len() as u32) as usize];
            if self.show(next, false) {
                self.entry = next;
            }
        }
    }

    fn by_itself(&self, entry: usize) -> impl Iterator<Item = usize> {
        let edges = self.closed.edges(entry).iter();
        edges.filter(|edge| !self.plant.events[edge.0 as usize].controllable).map(|edge| edge.1 as usize)
    }

    /// What is read is where the plant is, or what it has come to by itself.
    fn follow(&mut self) -> Result<(), String> {
        let mut reached = BTreeMap::from([(self.entry, ())]);
        let mut queue = VecDeque::from([self.entry]);
        while let Some(entry) = queue.pop_front() {
            if self.fits(entry) {
                self.entry = entry;
                return Ok(());
            }
            queue.extend(self.by_itself(entry).filter(|&next| reached.insert(next, ()).is_none()));
        }
        Err(format!("in {:?} something else is read", self.closed.entry(self.entry)))
    }

    fn scan(&mut self) -> Result<(), String> {
        for rung in &self.feedback.program.rungs {
            let holds = rung.condition.eval(&|variable| self.values[variable as usize]);
            for coil in &rung.coils {
                let value = &mut self.values[coil.variable as usize];
                match coil.drive {
                    Drive::Set => *value |= holds,
                    Drive::Reset => *value &= !holds,
                    Drive::Out => *value = holds,
                }
            }
            let Some(event) = rung.event.filter(|_| holds) else { continue };
            let edges = self.closed.edges(self.entry);
            let Some(edge) = edges.iter().find(|edge| edge.0 == event) else {
                let name = &self.plant.events[event as usize].name;
                return Err(format!("`{name}` fires in {:?}", self.closed.entry(self.entry)));
            };
            self.entry = edge.1 as usize;
            self.fired += 1;
            self.follow()?;
        }
        Ok(())
    }
}

/// How many events fire; or which fires where it must not. None if the plant has no program without memory.
fn play(plant: &Plant, seed: u64) -> Option<Result<usize, String>> {
    let closed = supervise(plant, &Limits::default()).ok()?;
    let memory = remember::remember(plant, &closed).ok()?;
    if !memory.is_empty() {
        return None;
    }
    let feedback = state_feedback(plant, &closed, &memory, Options::default()).ok()?;
    assert!(
        feedback.program.variables.iter().all(|variable| matches!(variable.usage, Use::Input | Use::Output))
    );
    let mut play = Play::new(plant, &closed, &feedback, seed)?;
    for _ in 0..60 {
        if play.random.below(2) == 0 {
            play.plant_moves();
        }
        if let Err(why) = play.scan() {
            return Some(Err(why));
        }
    }
    Some(Ok(play.fired))
}

/// `start` sets an output that no formula reads, and the sensor answers later: until then, `lower` may fire as well, although a
/// `never` forbids both.
#[test]
fn two_events_against_a_never() {
    let text = |rests: &str, runs: &str| {
        format!(
            "plant Saw {{
                output Motor, Guard input Running
                controllable start {{ set Motor }} controllable lift {{ set Guard }}
                automaton Blade {{ initial state Rests [{rests}] {{ start -> Runs }} state Runs [{runs}] }}
                automaton Cover {{ initial state Down [!Guard] {{ lift -> Up }} state Up [Guard] }}
                constraint Safe: never Blade.Runs && Cover.Up
            }}"
        )
    };
    let (wrong, _) = read(&text("!Running", "Running"), FileId(0)).expect("a plant");
    let found: Vec<_> = unreadable(&wrong).into_iter().map(|one| one.code).collect();
    assert_eq!(found, [Code::Misread]);
    let why = play(&wrong, 1).expect("a program").expect_err("both fire");
    assert!(why.contains("something else is read") || why.contains("`lift` fires"), "{why}");

    let (right, _) = read(&text("!Motor && !Running", "Motor"), FileId(0)).expect("a plant");
    assert_eq!(unreadable(&right), []);
    assert_eq!(play(&right, 1), Some(Ok(1)));
}

/// A command moves a component that knows nothing of it, if its sensor is on: it is warned of, and rightly.
#[test]
fn a_component_that_does_not_take_part() {
    let text = "plant Tap {
        output Open, Lamp input Full
        controllable open { set Open } controllable warn { set Lamp }
        automaton Valve { initial state Shut [!Open] { open -> Opened } state Opened [Open] }
        automaton Basin { initial state Dry [!Open || !Full] state Wet [Open && Full] }
        automaton Panel { initial state Dark [!Lamp] { warn -> Lit } state Lit [Lamp] }
    }";
    let (plant, _) = read(text, FileId(0)).expect("a plant");
    assert_eq!(unreadable(&plant), []);
    let closed = supervise(&plant, &Limits::default()).expect("a feedback");
    assert_eq!(misreadable(&plant, &closed).len(), 1);
    assert!((0..20).any(|seed| matches!(play(&plant, seed), Some(Err(_)))));
}

/// Warnings that a wrong state could be read, or what is meant only later; the second is slow, but sound.
fn misreadable(plant: &Plant, closed: &ClosedLoop) -> Vec<String> {
    let found = warnings(plant, closed).into_iter().filter(|one| one.code == Code::Misreadable);
    found.map(|one| one.message).filter(|message| !message.ends_with("until the plant moves")).collect()
}

/// Whatever is accepted without doubt is sound; of what is not, enough goes wrong that the test can fail.
#[test]
fn random_plants() {
    let seeds = std::env::var("SML_SEEDS").ok().and_then(|n| n.parse().ok()).unwrap_or(8_000);
    let (mut sound, mut events, mut refused, mut doubtful) = (0, 0, [0; 2], 0);
    for seed in 0..seeds {
        let plant = with_signals(random_plant::plant(seed), seed);
        let errors = unreadable(&plant);
        if errors.iter().any(|one| !matches!(one.code, Code::Misread | Code::Contradicted)) {
            continue;
        }
        let Some(result) = play(&plant, seed) else { continue };
        if !errors.is_empty() {
            refused[usize::from(result.is_err())] += 1;
            continue;
        }
        let closed = supervise(&plant, &Limits::default()).expect("a feedback");
        if !misreadable(&plant, &closed).is_empty() {
            doubtful += 1;
            continue;
        }
        events += result.unwrap_or_else(|why| panic!("seed {seed}: {why}\n{plant:#?}"));
        sound += 1;
    }
    println!("{sound} sound, {events} events; {refused:?} refused, {doubtful} doubtful");
    assert!(sound > 50 && events > sound && refused[1] > 50);
}
