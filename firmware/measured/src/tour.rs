//! Every event in every state in which the environment is awaited.

use core::fmt;

use crate::play::Steps;

/// States of the largest controller that is toured.
const STATES: usize = 512;

/// What a tour came to.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Tour {
    /// Bytes of all tables but what is owed.
    pub tables: usize,
    /// States that are met between the calls.
    pub states: u32,
    /// Look-ups: every event in each of them.
    pub look_ups: u32,
    /// Those that found a row.
    pub rows: u32,
}

impl fmt::Display for Tour {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Tour { tables, states, look_ups, rows } = self;
        write!(f, "tables {tables}, states {states}, look-ups {look_ups}, rows {rows}")
    }
}

/// Visits every state that calls of a new controller lead to, and looks up every event there.
pub fn tour<C: Steps + Clone>(tables: usize) -> Tour {
    let mut tour = Tour { tables, states: 0, look_ups: 0, rows: 0 };
    let mut seen = [0_u32; STATES / 32];
    let mut open = [const { None::<C> }; STATES];
    let mut count = 0;
    let mut visit = |controller: C, open: &mut [Option<C>; STATES], count: &mut usize| {
        let state = controller.state();
        let Some(word) = seen.get_mut(state as usize / 32) else { return };
        if *word >> (state % 32) & 1 == 0 {
            *word |= 1 << (state % 32);
            if let Some(place) = open.get_mut(*count) {
                *place = Some(controller);
                *count += 1;
            }
        }
    };
    visit(C::start(), &mut open, &mut count);
    while count > 0 {
        count -= 1;
        let Some(controller) = open.get_mut(count).and_then(Option::take) else { break };
        tour.states += 1;
        for &event in C::EVENTS {
            tour.look_ups += 1;
            if controller.accepts(event) {
                tour.rows += 1;
                let mut next = controller.clone();
                next.react(event);
                visit(next, &mut open, &mut count);
            }
        }
        // A super step that is due: the initial one, or the rest of one that is split.
        let mut next = controller;
        next.cycle();
        visit(next, &mut open, &mut count);
    }
    tour
}
