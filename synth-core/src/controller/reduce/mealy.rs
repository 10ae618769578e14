//! A controller as an incompletely specified Mealy machine, and back.

use crate::controller::{Controller, Lists, SuperStep, SuperSteps};
use hashbrown::HashMap;
use rustc_hash::FxBuildHasher;

/// No state: what follows a refusal.
pub(super) const NOWHERE: u32 = u32::MAX;

/// The answer "refused": the event must have no row.
pub(super) const REFUSED: u32 = 0;

/// An answer that does not matter: any but [`REFUSED`].
const ANY: u32 = 1;

/// What is specified for an event in a state.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Row {
    pub(super) event: u32,
    /// [`REFUSED`], or the number of a list of super steps.
    pub(super) answer: u32,
    /// The state after the answer; [`NOWHERE`] after a refusal.
    pub(super) next: u32,
}

/// States are those in which the controller waits; an answer is everything that it does until it waits again. An event
/// without a row is a don't-care.
#[derive(Clone, Debug)]
pub(crate) struct Mealy {
    /// Per state where its rows begin; one more entry ends the last.
    pub(super) first: Vec<u32>,
    /// By state, then by event.
    pub(super) rows: Vec<Row>,
    /// Number of events.
    pub(super) events: u32,
    /// The state after the initial answer.
    pub(super) initial: u32,
    /// What is done before anything happens.
    initial_answer: u32,
    /// Per answer its super steps, as indices into those of the controller. The first stands for [`REFUSED`].
    answers: Vec<Vec<u32>>,
    /// Per state those of the controller that it stands for.
    origins: Vec<Vec<u32>>,
}

/// The super steps of a controller, followed to the states in which it waits.
struct Chains<'a> {
    controller: &'a Controller,
    /// Per state its super step.
    due: Vec<u32>,
    /// Per list of commands the first super step that has it.
    first: Vec<u32>,
    answers: Vec<Vec<u32>>,
    numbers: HashMap<Vec<u32>, u32, FxBuildHasher>,
}

impl<'a> Chains<'a> {
    fn new(controller: &'a Controller) -> Self {
        let mut due = vec![NOWHERE; controller.states as usize];
        let mut first = vec![NOWHERE; controller.super_steps.events.distinct()];
        for (row, step) in (0..).zip(&controller.super_steps) {
            due[step.source as usize] = row;
            let first = &mut first[controller.super_steps.events.number(row as usize) as usize];
            *first = row.min(*first);
        }
        Chains { controller, due, first, answers: vec![Vec::new()], numbers: HashMap::default() }
    }

    /// The answer that begins in a state, and the state in which it ends; `None` if it never does.
    fn follow(&mut self, mut state: u32) -> Option<(u32, u32)> {
        let mut answer = Vec::new();
        while self.due[state as usize] != NOWHERE {
            let row = self.due[state as usize] as usize;
            if answer.len() > self.controller.super_steps.len() {
                return None;
            }
            let steps = &self.controller.super_steps;
            answer.push(self.first[steps.events.number(row) as usize]);
            state = steps.target[row];
        }
        let fresh = self.answers.len() as u32;
        let number = *self.numbers.entry(answer).or_insert_with_key(|answer| {
            self.answers.push(answer.clone());
            fresh
        });
        Some((number, state))
    }
}

impl Mealy {
    /// The machine of a controller; `refused` adds what must stay refused: per state of the controller, events.
    ///
    /// `None` if it is none: some state waits and acts, or an answer never ends.
    pub(crate) fn new(controller: &Controller, refused: &[Vec<u32>]) -> Option<Mealy> {
        let mut chains = Chains::new(controller);
        let acts = |chains: &Chains<'_>, state: u32| chains.due[state as usize] != NOWHERE;
        if controller.environment.iter().flatten().any(|row| acts(&chains, row.0)) {
            return None;
        }
        let origin: Vec<u32> = (0..controller.states).filter(|&state| !acts(&chains, state)).collect();
        let mut number = vec![NOWHERE; controller.states as usize];
        for (new, &old) in (0..).zip(&origin) {
            number[old as usize] = new;
        }
        let mut rows: Vec<(u32, Row)> = Vec::new();
        for (event, mapping) in (0..).zip(&controller.environment) {
            for &(source, target) in mapping {
                let (answer, end) = chains.follow(target)?;
                rows.push((number[source as usize], Row { event, answer, next: number[end as usize] }));
            }
        }
        for (state, events) in refused.iter().enumerate().filter(|(state, _)| number[*state] != NOWHERE) {
            let row = |&event| (number[state], Row { event, answer: REFUSED, next: NOWHERE });
            rows.extend(events.iter().map(row));
        }
        rows.sort_unstable_by_key(|(state, row)| (*state, row.event));
        let mut first = vec![0; origin.len() + 1];
        for (state, _) in &rows {
            first[*state as usize + 1] += 1;
        }
        for state in 1..first.len() {
            first[state] += first[state - 1];
        }
        let (initial_answer, initial) = chains.follow(controller.initial)?;
        Some(Mealy {
            first,
            rows: rows.into_iter().map(|(_, row)| row).collect(),
            events: controller.events.len() as u32,
            initial: number[initial as usize],
            initial_answer,
            answers: chains.answers,
            origins: origin.into_iter().map(|state| vec![state]).collect(),
        })
    }

    pub(crate) fn states(&self) -> usize {
        self.origins.len()
    }

    pub(super) fn rows_of(&self, state: u32) -> &[Row] {
        &self.rows[self.first[state as usize] as usize..self.first[state as usize + 1] as usize]
    }

    /// What is specified for an event in a state.
    pub(super) fn row(&self, state: u32, event: u32) -> Option<Row> {
        let rows = self.rows_of(state);
        rows.binary_search_by_key(&event, |row| row.event).ok().map(|row| rows[row])
    }

    /// States breadth first from the initial one, at most so many; ascending.
    pub(super) fn nearest(&self, most: usize) -> Vec<u32> {
        let mut met = vec![false; self.states()];
        met[self.initial as usize] = true;
        let mut order = vec![self.initial];
        let mut head = 0;
        while let Some(&state) = order.get(head) {
            head += 1;
            for row in self.rows_of(state).iter().filter(|row| row.next != NOWHERE) {
                if order.len() < most && !std::mem::replace(&mut met[row.next as usize], true) {
                    order.push(row.next);
                }
            }
        }
        order.sort_unstable();
        order
    }

    /// The machine of some states, ascending, the initial one among them, that need only answer `events` right; to others all have the same
    /// answer, and what must be refused is free.
    pub(super) fn part(&self, inside: &[u32], events: &[bool]) -> Mealy {
        let mut number = vec![NOWHERE; self.states()];
        for (new, &old) in (0..).zip(inside) {
            number[old as usize] = new;
        }
        let mut part = Mealy {
            first: vec![0],
            rows: Vec::new(),
            events: self.events,
            initial: number[self.initial as usize],
            initial_answer: 0,
            answers: vec![Vec::new(); self.answers.len()],
            origins: vec![Vec::new(); inside.len()],
        };
        for &state in inside {
            for row in self.rows_of(state) {
                let next = if row.next == NOWHERE { NOWHERE } else { number[row.next as usize] };
                let known = next != NOWHERE;
                if events[row.event as usize] && (known || row.next == NOWHERE) {
                    part.rows.push(Row { next, ..*row });
                } else if known && !events[row.event as usize] {
                    part.rows.push(Row { next, answer: ANY, event: row.event });
                }
            }
            part.first.push(part.rows.len() as u32);
        }
        part
    }

    /// The state after an event, where that is specified and not refused.
    pub(super) fn next(&self, state: u32, event: u32) -> Option<u32> {
        let rows = self.rows_of(state);
        let row = rows.binary_search_by_key(&event, |row| row.event).ok()?;
        (rows[row].next != NOWHERE).then_some(rows[row].next)
    }

    /// The machine whose states are `members`, sets of compatible states of this one, the first with the initial state.
    /// `target` says into which of them a transition leads: it holds all successors.
    pub(super) fn quotient(&self, members: &[Vec<u32>], target: impl Fn(u32, Row) -> u32) -> Mealy {
        let mut first = vec![0];
        let mut rows: Vec<Row> = Vec::new();
        for (class, members) in (0..).zip(members) {
            let begin = rows.len();
            rows.extend(members.iter().flat_map(|&state| self.rows_of(state)));
            rows[begin..].sort_unstable_by_key(|row| row.event);
            let mut kept = begin;
            for row in begin..rows.len() {
                if kept == begin || rows[kept - 1].event != rows[row].event {
                    rows[kept] = rows[row];
                    kept += 1;
                }
            }
            rows.truncate(kept);
            for row in rows[begin..].iter_mut().filter(|row| row.next != NOWHERE) {
                row.next = target(class, *row);
            }
            first.push(rows.len() as u32);
        }
        let origins = members.iter().map(|members| {
            let mut origins: Vec<u32> =
                members.iter().flat_map(|&state| self.origins[state as usize].iter().copied()).collect();
            origins.sort_unstable();
            origins.dedup();
            origins
        });
        Mealy {
            first,
            rows,
            events: self.events,
            initial: 0,
            initial_answer: self.initial_answer,
            answers: self.answers.clone(),
            origins: origins.collect(),
        }
    }

    /// The states of a controller that does this in the layout of tables: those that wait, and one for each rest of an
    /// answer with the state after it.
    pub(super) fn table_states(&self) -> usize {
        let mut steps: Vec<(&[u32], u32)> = Vec::new();
        let initial = (self.initial_answer, self.initial);
        let answers = self.rows.iter().filter(|row| row.next != NOWHERE).map(|row| (row.answer, row.next));
        for (answer, next) in answers.chain([initial]) {
            let answer = &self.answers[answer as usize];
            steps.extend((0..answer.len()).map(|from| (&answer[from..], next)));
        }
        steps.sort_unstable();
        steps.dedup();
        self.states() + steps.len()
    }

    /// As a controller, with the events, commands and super steps of `source`, of which this machine was made. States are
    /// numbered breadth first from the initial one.
    pub(crate) fn controller(&self, source: &Controller) -> Controller {
        let mut states = States { mealy: self, numbers: HashMap::default(), order: Vec::new() };
        let mut environment = vec![Vec::new(); source.events.len()];
        let mut super_steps = SuperSteps::default();
        let mut owed = Lists::default();
        states.visit(&self.answers[self.initial_answer as usize], self.initial);
        let mut number = 0;
        while let Some(&(answer, state)) = states.order.get(number as usize) {
            if let [step, rest @ ..] = answer {
                let target = states.visit(rest, state);
                let events = &source.super_steps.events[*step as usize];
                super_steps.push(SuperStep { source: number, target, events });
                owed.push(&[]);
            } else {
                for row in self.rows_of(state).iter().filter(|row| row.next != NOWHERE) {
                    let target = states.visit(&self.answers[row.answer as usize], row.next);
                    environment[row.event as usize].push((number, target));
                }
                let origins = &self.origins[state as usize];
                let mut events: Vec<u32> =
                    origins.iter().flat_map(|&origin| source.owed[origin as usize].iter().copied()).collect();
                events.sort_unstable();
                events.dedup();
                owed.push(&events);
            }
            number += 1;
        }
        Controller {
            states: number,
            initial: 0,
            events: source.events.clone(),
            commands: source.commands.clone(),
            components: source.components.clone(),
            environment,
            super_steps,
            owed,
        }
    }
}

/// The states of tables in order of discovery: what is still to be done, and the state after it.
struct States<'a> {
    mealy: &'a Mealy,
    numbers: HashMap<(&'a [u32], u32), u32, FxBuildHasher>,
    order: Vec<(&'a [u32], u32)>,
}

impl<'a> States<'a> {
    fn visit(&mut self, answer: &'a [u32], state: u32) -> u32 {
        debug_assert!((state as usize) < self.mealy.states());
        let fresh = self.order.len() as u32;
        let number = *self.numbers.entry((answer, state)).or_insert(fresh);
        if number == fresh {
            self.order.push((answer, state));
        }
        number
    }
}
