//! Controllers of the published size: Gritzner and Greenyer (2018, section 4) generated code from a strategy of 3017
//! states and 5958 transitions, 1001 of them super steps; its largest event had 653 rows, and its commands went to
//! three robots. The strategy itself was not published. These have its figures exactly, and stand on either side of it:
//!
//! - [`machine`] has the structure of real strategies. It is explored, breadth first, from a line of three robots that
//!   share a table, a rack and a rail ([`line`]), and then trimmed to the figures: a state has few events, one for
//!   every robot that is busy, an event moves one robot, and many states accept the same events.
//! - [`random`] has no structure: sources and targets are uniformly random. Nothing can be saved on its targets, so
//!   it is the worst case of every encoding.
//!
//! Neither comes from a specification. What does, and is of nearly that size, is the corpus's `line_2` without
//! minimisation: 2784 states, 5520 transitions.

mod line;

use std::collections::{BTreeMap, BTreeSet};

use crate::tables::{Random, event};
use line::Line;
use synth_core::controller::{Component, Controller, SuperStep, SuperSteps};

/// States of all kinds.
pub const STATES: u32 = 3017;
/// Super steps, each with a state of its own.
pub const SUPER_STEPS: u32 = 1001;
/// Rows of all events, and super steps.
pub const TRANSITIONS: u32 = 5958;
/// Rows of the event that has most, `feedBelt -> controller.blankArrived()`.
pub const LARGEST: u32 = 653;

/// States in which the controller waits for the environment.
const WAITING: u32 = STATES - SUPER_STEPS;
/// Rows of all events.
const ROWS: u32 = TRANSITIONS - SUPER_STEPS;

/// A transition between waiting states, with what is commanded on the way.
#[derive(Clone, Debug)]
struct Row {
    source: u32,
    event: u32,
    target: u32,
    /// The super step on the way: rows that have the same one share its state.
    step: Option<u32>,
    /// Without it, a state would not be reached.
    tree: bool,
}

/// The structure of a line of robots, trimmed to the published figures.
///
/// The line has a little more of everything. The 2016 waiting states nearest to the initial one are kept; rows that lead
/// beyond them go to the state that differs only in the number of items delivered so far (odd or even). Rows that
/// are too many are dropped at random, as if an assumption excluded the event there; super steps that are too many
/// become plain transitions.
///
/// # Panics
///
/// If the line has less than the published figures, which does not depend on the seed.
#[must_use]
pub fn machine(seed: u64) -> Controller {
    let random = &mut Random::new(seed);
    let (mut rows, mut steps) = explore();
    let blank =
        line::EVENTS.iter().position(|text| text.ends_with(".blankArrived()")).expect("an event") as u32;
    drop_rows(&mut rows, |row| row.event == blank, LARGEST, random);
    drop_rows(&mut rows, |row| row.event != blank, ROWS - LARGEST, random);
    let used: BTreeSet<u32> = rows.iter().filter_map(|row| row.step).collect();
    let mut kept: Vec<u32> = used.into_iter().collect();
    assert!(kept.len() >= SUPER_STEPS as usize, "only {} super steps", kept.len());
    while kept.len() > SUPER_STEPS as usize {
        kept.swap_remove(random.below(kept.len() as u32) as usize);
    }
    kept.sort_unstable();
    for row in &mut rows {
        row.step = row.step.and_then(|step| kept.binary_search(&step).ok()).map(|step| step as u32);
    }
    steps = kept.iter().map(|&step| std::mem::take(&mut steps[step as usize])).collect();
    number(&rows, &steps)
}

/// The states of the line nearest to the initial one, and the commands of each super step.
fn explore() -> (Vec<Row>, Vec<Vec<u32>>) {
    let mut states = vec![Line::default()];
    let mut numbers = BTreeMap::from([(Line::default(), 0)]);
    let mut step_numbers = BTreeMap::new();
    let (mut rows, mut steps) = (Vec::new(), Vec::new());
    let mut source = 0;
    while let Some(&line) = states.get(source as usize) {
        for (text, after) in line.events() {
            let event = line::EVENTS.binary_search(&text).expect("a known event") as u32;
            let (target, commands) = after.react();
            let tree = !numbers.contains_key(&target) && states.len() < WAITING as usize;
            if tree {
                numbers.insert(target, states.len() as u32);
                states.push(target);
            }
            let known = numbers.get(&target).or_else(|| numbers.get(&target.twin()));
            let Some(&target) = known else { continue };
            let step = (!commands.is_empty()).then(|| {
                *step_numbers.entry((after, target)).or_insert_with(|| {
                    let index =
                        |text: &&str| line::COMMANDS.binary_search(text).expect("a known command") as u32;
                    steps.push(commands.iter().map(index).collect());
                    steps.len() as u32 - 1
                })
            });
            rows.push(Row { source, event, target, step, tree });
        }
        source += 1;
    }
    assert_eq!(states.len(), WAITING as usize);
    (rows, steps)
}

/// Leaves so many of these rows, those that reach a state among them.
fn drop_rows(rows: &mut Vec<Row>, which: impl Fn(&Row) -> bool, left: u32, random: &mut Random) {
    let mut dropped: Vec<usize> = (0..rows.len()).filter(|&row| which(&rows[row])).collect();
    let too_many = dropped.len().checked_sub(left as usize).expect("too few rows");
    dropped.retain(|&row| !rows[row].tree);
    shuffle(&mut dropped, random);
    assert!(dropped.len() >= too_many, "too few rows that can be dropped");
    dropped.truncate(too_many);
    dropped.sort_unstable();
    let mut row = 0;
    rows.retain(|_| {
        row += 1;
        dropped.binary_search(&(row - 1)).is_err()
    });
}

fn shuffle<T>(list: &mut [T], random: &mut Random) {
    for last in (1..list.len()).rev() {
        list.swap(last, random.below(last as u32 + 1) as usize);
    }
}

/// Numbers waiting states and those of super steps in one order, breadth first, as the pipeline does.
fn number(rows: &[Row], steps: &[Vec<u32>]) -> Controller {
    let mut of_state = vec![Vec::new(); WAITING as usize];
    for row in rows {
        of_state[row.source as usize].push(row);
    }
    let (mut waiting, mut stepping) = (vec![None; WAITING as usize], vec![None; steps.len()]);
    waiting[0] = Some(0);
    let mut queue = vec![0];
    let mut next = 1;
    let mut fresh = |place: &mut Option<u32>| {
        let known = place.is_some();
        let number = *place.get_or_insert(next);
        next += u32::from(!known);
        (number, !known)
    };
    let mut environment = vec![Vec::new(); line::EVENTS.len()];
    let mut super_steps = SuperSteps::default();
    let mut at = 0;
    while let Some(&state) = queue.get(at) {
        at += 1;
        let source = waiting[state as usize].expect("numbered before it is visited");
        for row in &of_state[state as usize] {
            let through = row.step.map(|step| fresh(&mut stepping[step as usize]));
            let (target, first) = fresh(&mut waiting[row.target as usize]);
            if first {
                queue.push(row.target);
            }
            if let (Some((source, true)), Some(step)) = (through, row.step) {
                super_steps.push(SuperStep { source, target, events: &steps[step as usize] });
            }
            let leads_to = through.map_or(target, |(state, _)| state);
            environment[row.event as usize].push((source, leads_to));
        }
    }
    controller(environment, super_steps)
}

/// No structure at all: rows of every event as many as those of [`machine`], in random states, with random targets.
/// Every super step commands a random robot, often others too.
///
/// # Panics
///
/// Never.
#[must_use]
pub fn random(seed: u64) -> Controller {
    let random = &mut Random::new(seed);
    let mut states: Vec<u32> = (1..STATES).collect();
    shuffle(&mut states, random);
    let mut stepping = states.split_off(WAITING as usize - 1);
    stepping.sort_unstable();
    states.push(0);
    let mut rows = Vec::new();
    for (event, like) in machine(seed).environment.iter().enumerate() {
        shuffle(&mut states, random);
        rows.extend(states.iter().take(like.len()).map(|&source| (source, event as u32)));
    }
    let targets = random_targets(&rows, random);
    let mut environment = vec![Vec::new(); line::EVENTS.len()];
    for (&(source, event), &target) in rows.iter().zip(&targets) {
        environment[event as usize].push((source, target));
    }
    let mut super_steps = SuperSteps::default();
    for &source in &stepping {
        // No circle of super steps: they end in a waiting state, or in one of a higher number.
        let target = loop {
            let target = random.below(STATES);
            if target > source || stepping.binary_search(&target).is_err() {
                break target;
            }
        };
        super_steps.push(SuperStep { source, target, events: &random_commands(random) });
    }
    controller(environment, super_steps)
}

/// A target for every row `(source, event)`, so that every state is reached from the state 0: first a random tree of
/// all states, then anything.
fn random_targets(rows: &[(u32, u32)], random: &mut Random) -> Vec<u32> {
    let mut of_state = vec![Vec::new(); STATES as usize];
    for (row, &(source, _)) in rows.iter().enumerate() {
        of_state[source as usize].push(row);
    }
    let mut targets = vec![None; rows.len()];
    let mut left: Vec<u32> = (1..STATES).collect();
    shuffle(&mut left, random);
    // The rows of states that are in the tree.
    let mut open = of_state[0].clone();
    while !left.is_empty() {
        // One that has two rows at least, lest the tree ends with its last row.
        let needed = if open.len() == 1 && left.len() > 1 { 2 } else { 0 };
        let state = left.iter().rposition(|&state| of_state[state as usize].len() >= needed);
        let state = left.swap_remove(state.expect("most states have two rows"));
        let row = open.swap_remove(random.below(open.len() as u32) as usize);
        targets[row] = Some(state);
        open.extend(&of_state[state as usize]);
    }
    targets.into_iter().map(|target| target.unwrap_or_else(|| random.below(STATES))).collect()
}

/// At most one command for each robot, and one at least.
fn random_commands(random: &mut Random) -> Vec<u32> {
    let components = components();
    let first = random.below(components.len() as u32) as usize;
    let mut events = Vec::new();
    for (index, component) in components.iter().enumerate() {
        if index == first || random.below(3) == 0 {
            events.push(component.commands[random.below(component.commands.len() as u32) as usize]);
        }
    }
    events
}

/// The robots.
fn components() -> Vec<Component> {
    let mut components: Vec<Component> = Vec::new();
    for (command, text) in (0..).zip(line::COMMANDS) {
        let object = event(text).receiver;
        match components.last_mut().filter(|last| last.object == object) {
            Some(last) => last.commands.push(command),
            None => components.push(Component { object, commands: vec![command] }),
        }
    }
    components
}

/// Owed is what a busy robot reports.
fn controller(mut environment: Vec<Vec<(u32, u32)>>, mut super_steps: SuperSteps) -> Controller {
    super_steps.sort();
    let mut owed = vec![Vec::new(); STATES as usize];
    for ((event, rows), text) in (0..).zip(&mut environment).zip(line::EVENTS) {
        rows.sort_unstable();
        if !text.starts_with("feedBelt") {
            for &(source, _) in rows.iter() {
                owed[source as usize].push(event);
            }
        }
    }
    Controller {
        states: STATES,
        initial: 0,
        events: line::EVENTS.map(event).into(),
        commands: line::COMMANDS.map(event).into(),
        components: components(),
        environment,
        super_steps,
        owed: owed.iter().collect(),
    }
}
