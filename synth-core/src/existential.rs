//! Existential scenarios: examples of what the system should make possible.
//!
//! They are no part of the game: their copies are followed beside the state, in a play-out of their own for each
//! scenario, and never violated; one that is interrupted or meets a message out of order just ends. An existential scenario is
//!
//! * *reachable* if some copy comes to its end in a play of controller and environment,
//! * *possible* if some copy comes to its end in a play through winning states only. Such a play can be continued so
//!   that the system wins it, and some controller that meets the specification allows it. A play that the system
//!   wins only because the environment spares it in a losing state does not count, so nothing is possible in a
//!   specification that is not realizable.
//!
//! Both are searched breadth first: a play that is found is a shortest one.

use crate::controller::{Controller, SuperStep};
use crate::explore::{LimitReached, Limits, StateId, StateStore};
use crate::game::{Turn, YIELD};
use crate::model::{Kind, Spec};
use crate::pipeline::{Failure, Options, Solved};
use crate::playout::{EventId, PlayError, Playout};
use crate::successors::PackedMoves;
use rustc_hash::FxHashMap;
use std::collections::BTreeMap;

/// What is known of one existential scenario.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Existential {
    /// `Collaboration.Scenario`.
    pub scenario: String,
    /// Some copy can be completed while the controller is in charge.
    pub reachable: bool,
    /// Some copy can be completed in a winning play; true if it is reachable.
    pub possible: bool,
    /// Event texts (a yield is `yield`) of a shortest play that completes a copy: of the controller if it can be
    /// reached there, else of the winning states. Empty if there is none, or none is needed.
    pub witness: Vec<String>,
}

/// Looks at every existential scenario, in textual order. Without a controller none is reachable. Costs nothing if
/// there are none, and otherwise about as much as exploring the specification once more for each.
///
/// # Errors
/// A mistake in an existential scenario that a play reaches, or a limit.
pub fn existential(
    spec: &Spec,
    options: &Options,
    solved: &Solved<'_>,
    controller: Option<&Controller>,
) -> Result<Vec<Existential>, Failure> {
    let scenarios = spec.scenarios.iter().enumerate();
    let existential = scenarios.filter(|(_, scenario)| scenario.kind == Kind::Existential);
    existential
        .map(|(index, scenario)| {
            let mut witness = None;
            if let Some(controller) = controller {
                let guide = Controlled::new(controller);
                witness = search(spec, options, index, &guide)?;
            }
            let reachable = witness.is_some();
            if !reachable && solved.solution.wins(solved.explored.game.initial) {
                witness = search(spec, options, index, &Winning { solved })?;
            }
            let (scenario, possible) = (scenario.name.clone(), witness.is_some());
            Ok(Existential { scenario, reachable, possible, witness: witness.unwrap_or_default() })
        })
        .collect()
}

/// Where a guide is: for a game its state and 0, for a controller its state and how far its super step has come.
type Place = (u32, u32);

/// Says which moves of a state are looked at.
trait Guide {
    fn start(&self) -> Place;

    /// Appends the moves to be followed, each with the place that it leads to.
    fn follow(
        &self,
        playout: &Playout<'_>,
        place: Place,
        moves: &PackedMoves,
        followed: &mut Vec<(usize, Place)>,
    );
}

/// All moves between winning states.
struct Winning<'a, 's> {
    solved: &'a Solved<'s>,
}

impl Guide for Winning<'_, '_> {
    fn start(&self) -> Place {
        (self.solved.explored.game.initial, 0)
    }

    fn follow(
        &self,
        _: &Playout<'_>,
        (state, _): Place,
        _: &PackedMoves,
        followed: &mut Vec<(usize, Place)>,
    ) {
        // Moves come in the same order as the edges of the game.
        let game = &self.solved.explored.game;
        let targets = game.edges_of(state).map(|edge| game.target[edge]).enumerate();
        let winning = targets.filter(|&(_, target)| self.solved.solution.wins(target));
        followed.extend(winning.map(|(index, target)| (index, (target, 0))));
    }
}

/// The controller's moves, and those of the environment that it accepts.
struct Controlled<'a> {
    controller: &'a Controller,
    due: Vec<Option<SuperStep<'a>>>,
    /// Environment events by their texts.
    events: BTreeMap<&'a str, usize>,
}

impl<'a> Controlled<'a> {
    fn new(controller: &'a Controller) -> Self {
        let mut due = vec![None; controller.states as usize];
        for step in &controller.super_steps {
            due[step.source as usize] = Some(step);
        }
        let events = controller.events.iter().enumerate();
        let events = events.map(|(index, event)| (event.text.as_str(), index)).collect();
        Controlled { controller, due, events }
    }

    fn target(&self, text: &str, state: u32) -> Option<u32> {
        let rows = &self.controller.environment[*self.events.get(text)?];
        let row = rows.binary_search_by_key(&state, |&(source, _)| source).ok()?;
        Some(rows[row].1)
    }
}

impl Guide for Controlled<'_> {
    fn start(&self) -> Place {
        (self.controller.initial, 0)
    }

    fn follow(
        &self,
        playout: &Playout<'_>,
        (state, position): Place,
        moves: &PackedMoves,
        followed: &mut Vec<(usize, Place)>,
    ) {
        let text = |event: EventId| playout.event(event).text.as_str();
        let events = moves.edges().iter().map(|edge| (edge.event != YIELD).then_some(edge.event)).enumerate();
        if let Some(step) = self.due[state as usize] {
            let command = self.controller.commands[step.events[position as usize] as usize].text.as_str();
            let last = position as usize + 1 == step.events.len();
            let place = if last { (step.target, 0) } else { (state, position + 1) };
            let sent = events.filter(|&(_, event)| event.is_some_and(|event| text(event) == command));
            followed.extend(sent.map(|(index, _)| (index, place)));
        } else if moves.turn == Turn::SystemEventually {
            followed
                .extend(events.filter(|(_, event)| event.is_none()).map(|(index, _)| (index, (state, 0))));
        } else if moves.turn.is_environment() {
            followed.extend(events.filter_map(|(index, event)| {
                let target = self.target(text(event?), state)?;
                Some((index, (target, 0)))
            }));
        }
    }
}

/// A node of the search, and how it was reached.
struct Node {
    state: StateId,
    place: Place,
    parent: u32,
    event: Option<EventId>,
}

/// Looks for a play that completes a copy.
struct Search<'s> {
    playout: Playout<'s>,
    limits: Limits,
    store: StateStore,
    nodes: Vec<Node>,
    index: FxHashMap<(StateId, Place), u32>,
    edges: usize,
}

/// The shortest play that completes a copy of the scenario, among those that the guide follows.
fn search(
    spec: &Spec,
    options: &Options,
    scenario: usize,
    guide: &dyn Guide,
) -> Result<Option<Vec<String>>, Failure> {
    let wrong = |error: PlayError| broken(&error, &[]);
    let mut playout = Playout::following(spec, options.semantics, scenario).map_err(wrong)?;
    let begin = playout.begin().map_err(wrong)?;
    if begin.completed {
        return Ok(Some(Vec::new()));
    }
    let store = StateStore::new(&playout, &begin.config);
    let (nodes, index) = (Vec::new(), FxHashMap::default());
    let mut search = Search { playout, limits: options.limits, store, nodes, index, edges: 0 };
    search.enter(0, guide.start(), 0, None);
    search.run(guide)
}

impl Search<'_> {
    fn run(&mut self, guide: &dyn Guide) -> Result<Option<Vec<String>>, Failure> {
        let (mut moves, mut followed) = (PackedMoves::default(), Vec::new());
        for id in 0.. {
            let Some(&Node { state, place, .. }) = self.nodes.get(id as usize) else { break };
            self.check(id as usize)?;
            if let Err((event, error)) = self.store.moves(&mut self.playout, state, &mut moves) {
                let last = event.map(|event| self.playout.text(Some(event)).to_owned());
                return Err(broken(&error, &self.play(id, last)));
            }
            followed.clear();
            guide.follow(&self.playout, place, &moves, &mut followed);
            for &(index, place) in &followed {
                let edge = &moves.edges()[index];
                let event = (edge.event != YIELD).then_some(edge.event);
                if edge.completed {
                    let last = self.playout.text(event).to_owned();
                    return Ok(Some(self.play(id, Some(last))));
                }
                if edge.end.is_none() {
                    let target = self.store.intern(moves.target(edge));
                    self.enter(target, place, id, event);
                }
            }
            self.edges += followed.len();
        }
        Ok(None)
    }

    fn enter(&mut self, state: StateId, place: Place, parent: u32, event: Option<EventId>) {
        let id = self.nodes.len() as u32;
        if *self.index.entry((state, place)).or_insert(id) == id {
            self.nodes.push(Node { state, place, parent, event });
        }
    }

    fn check(&self, explored: usize) -> Result<(), Failure> {
        let states = self.nodes.len();
        let per_node = 2 * size_of::<Node>() + size_of::<((StateId, Place), u32)>();
        let memory = self.store.memory() + self.playout.memory() + self.nodes.capacity() * per_node;
        let (what, limit) = if states > self.limits.states {
            ("states", self.limits.states)
        } else if memory > self.limits.memory {
            ("memory", self.limits.memory)
        } else {
            return Ok(());
        };
        Err(Failure::Limit(LimitReached { what, limit, states, explored, edges: self.edges, memory }))
    }

    /// The texts of the play into a node, and then a last one.
    fn play(&self, id: u32, last: Option<String>) -> Vec<String> {
        let mut play: Vec<String> = last.into_iter().collect();
        let mut here = id as usize;
        while here != 0 {
            play.push(self.playout.text(self.nodes[here].event).to_owned());
            here = self.nodes[here].parent as usize;
        }
        play.reverse();
        play
    }
}

fn broken(error: &PlayError, play: &[String]) -> Failure {
    Failure::Wrong(vec![error.diagnostic(play)])
}

#[cfg(test)]
mod tests;
