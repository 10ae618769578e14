//! Several events in one scan: which of them can be pending together, and whether two controllers treat them alike.
//!
//! The game lets the environment send one event and then waits for the controller. A scan does not: while the controller
//! has not yet reacted, the environment goes on as its assumptions allow. So a node here has two sides. One is what has
//! really happened, in the order in which it happened: attributes and the copies of assumption scenarios. The other is the
//! controller: its state and what is pending. Three things can happen, each at any time:
//!
//! - the environment sends an event that violates no assumption and is spontaneous or asked for by an assumption, whoever has the
//!   turn; it becomes pending, if it is not already;
//! - the controller consumes what it can, as at the start of a cycle;
//! - the controller does the super step that is due; its commands happen now.
//!
//! A cycle is the second and then the third, a drain repeats that. Obligations do not matter, only what is possible. Guarantees
//! do not bind the environment; an assumption that a late command violates is gone from then on.

use super::{Refutation, VerifyError};
use crate::controller::{Controller, SuperStep};
use crate::intern::Indexed;
use crate::model::Kind;
use crate::playout::{Config, EventId, Playout, Step};
use rustc_hash::FxHashMap;

const NONE: u32 = u32::MAX;

/// Per state of the controller the events without a row there, ascending, that are looked up there while they are pending: what is
/// left pending now must not be consumed by a smaller controller either.
///
/// # Errors
///
/// [`VerifyError::TooLarge`] beyond so many nodes; [`VerifyError::Play`] if events in another order than that of the game meet a
/// mistake of the specification.
pub fn refused(
    playout: &mut Playout<'_>,
    controller: &Controller,
    most_nodes: usize,
) -> Result<Vec<Vec<u32>>, VerifyError> {
    let mut batches = Batches::new(playout, controller, controller);
    batches.explore(most_nodes)?;
    let events = controller.events.len().max(1);
    let mut refused = vec![Vec::new(); controller.states as usize];
    for (at, _) in batches.missed.iter().enumerate().filter(|(_, missed)| **missed) {
        refused[at / events].push((at % events) as u32);
    }
    Ok(refused)
}

/// Whether `minimized` issues the same commands and leaves the same events pending as `controller`, cycle for cycle and drain for
/// drain, whatever can be pending together. Returns the number of nodes.
///
/// # Errors
///
/// [`VerifyError::Refuted`] if it does not, and as [`refused`].
pub fn agree(
    playout: &mut Playout<'_>,
    controller: &Controller,
    minimized: &Controller,
    most_nodes: usize,
) -> Result<usize, VerifyError> {
    let mut batches = Batches::new(playout, controller, minimized);
    batches.explore(most_nodes)?;
    Ok(batches.nodes.len())
}

/// A controller, made ready for look-ups.
struct Machine<'c> {
    controller: &'c Controller,
    /// Per state and event the row's target, or [`NONE`].
    target: Vec<u32>,
    due: Vec<Option<SuperStep<'c>>>,
}

impl<'c> Machine<'c> {
    fn new(controller: &'c Controller) -> Self {
        let events = controller.events.len();
        let mut target = vec![NONE; controller.states as usize * events];
        for (event, rows) in controller.environment.iter().enumerate() {
            for &(from, to) in rows {
                target[from as usize * events + event] = to;
            }
        }
        let mut due = vec![None; controller.states as usize];
        for step in &controller.super_steps {
            due[step.source as usize] = Some(step);
        }
        Machine { controller, target, due }
    }

    /// Consumes in table order until nothing fits; says which look-ups failed.
    fn consume(&self, mut state: u32, pending: &mut Vec<u32>, mut missed: impl FnMut(usize)) -> u32 {
        let events = self.controller.events.len();
        loop {
            let before = pending.len();
            pending.retain(|&event| {
                let at = state as usize * events + event as usize;
                let target = self.target[at];
                if target == NONE {
                    missed(at);
                } else {
                    state = target;
                }
                target == NONE
            });
            if pending.len() == before {
                return state;
            }
        }
    }
}

#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
struct Node {
    /// What has really happened.
    real: u32,
    /// What is pending.
    pending: u32,
    /// The states of both controllers.
    state: u32,
    other: u32,
}

/// Events, and the `real` after each.
type Sendable = Box<[(EventId, u32)]>;

/// Why a node is there.
#[derive(Clone, Copy, Debug)]
enum Cause {
    Sent(EventId),
    Consumed,
    Acted,
}

struct Batches<'a, 's> {
    playout: &'a mut Playout<'s>,
    machine: Machine<'a>,
    other: Machine<'a>,
    /// Per event of the play-out its index in the controllers.
    index: FxHashMap<EventId, u32>,
    /// Per command its event of the play-out.
    commands: Vec<Option<EventId>>,
    real: Indexed<Config>,
    /// Per `real`: what the environment can send, and what that leads to.
    sent: Vec<Option<Sendable>>,
    pending: Indexed<Box<[u32]>>,
    nodes: Indexed<Node>,
    parent: Vec<Option<(u32, Cause)>>,
    /// Per state and event of the first controller whether it was looked up in vain.
    missed: Vec<bool>,
}

impl<'a, 's> Batches<'a, 's> {
    fn new(playout: &'a mut Playout<'s>, controller: &'a Controller, other: &'a Controller) -> Self {
        let events = (0..).zip(&controller.events);
        let index = events.filter_map(|(i, event)| Some((playout.find_event(&event.text)?, i))).collect();
        let commands = controller.commands.iter().map(|command| playout.find_event(&command.text)).collect();
        let machine = Machine::new(controller);
        Batches {
            missed: vec![false; machine.target.len()],
            playout,
            machine,
            other: Machine::new(other),
            index,
            commands,
            real: Indexed::default(),
            sent: Vec::new(),
            pending: Indexed::default(),
            nodes: Indexed::default(),
            parent: Vec::new(),
        }
    }

    fn explore(&mut self, most_nodes: usize) -> Result<(), VerifyError> {
        let initial = self.playout.initial().map_err(|error| VerifyError::Play(error, Vec::new()))?;
        let real = self.intern_real(&initial);
        let (pending, _) = self.pending.intern(Box::default());
        let (state, other) = (self.machine.controller.initial, self.other.controller.initial);
        self.visit(Node { real, pending, state, other }, None);
        for id in 0.. {
            if id as usize == self.nodes.len() {
                break;
            }
            if self.nodes.len() > most_nodes {
                return Err(VerifyError::TooLarge(most_nodes));
            }
            let node = *self.nodes.get(id);
            self.send(id, node)?;
            self.consume(id, node)?;
            self.act(id, node)?;
        }
        Ok(())
    }

    /// The environment sends something.
    fn send(&mut self, id: u32, node: Node) -> Result<(), VerifyError> {
        if self.sent[node.real as usize].is_none() {
            let config = self.real.get(node.real).clone();
            let sendable = self.playout.sendable(&config);
            let sendable = sendable.map_err(|(event, mistake)| {
                let mut play = self.play(id);
                play.push(self.playout.text(Some(event)).to_owned());
                VerifyError::Play(mistake, play)
            })?;
            let sendable = sendable.into_iter().map(|(event, config)| (event, self.intern_real(&config)));
            let sendable: Sendable = sendable.collect();
            self.sent[node.real as usize] = Some(sendable);
        }
        let count = self.sent[node.real as usize].as_ref().map_or(0, |sendable| sendable.len());
        for i in 0..count {
            let Some(&(event, real)) = self.sent[node.real as usize].as_ref().and_then(|s| s.get(i)) else {
                continue;
            };
            let mut pending = node.pending;
            // An event of no edge of the game is no input of any controller.
            if let Some(&index) = self.index.get(&event) {
                let now = self.pending.get(pending);
                if let Err(place) = now.binary_search(&index) {
                    let mut more = now.to_vec();
                    more.insert(place, index);
                    pending = self.pending.intern(more.into()).0;
                }
            }
            self.visit(Node { real, pending, ..node }, Some((id, Cause::Sent(event))));
        }
        Ok(())
    }

    /// Both controllers consume what they can.
    fn consume(&mut self, id: u32, node: Node) -> Result<(), VerifyError> {
        let now = self.pending.get(node.pending);
        if now.is_empty() {
            return Ok(());
        }
        let (mut left, mut right) = (now.to_vec(), now.to_vec());
        let missed = &mut self.missed;
        let state = self.machine.consume(node.state, &mut left, |at| missed[at] = true);
        let other = self.other.consume(node.other, &mut right, |_| ());
        if left != right {
            let name = |events: &[u32]| {
                let texts =
                    events.iter().map(|&e| format!("`{}`", self.machine.controller.events[e as usize].text));
                if events.is_empty() { "nothing".to_owned() } else { texts.collect::<Vec<_>>().join(", ") }
            };
            let reason = format!(
                "of several events in one scan, the minimised controller leaves {} pending instead of {}",
                name(&right),
                name(&left)
            );
            return Err(self.refuted(id, reason));
        }
        let (pending, _) = self.pending.intern(left.into());
        self.visit(Node { real: node.real, pending, state, other }, Some((id, Cause::Consumed)));
        Ok(())
    }

    /// Both controllers do the super step that is due.
    fn act(&mut self, id: u32, node: Node) -> Result<(), VerifyError> {
        let (due, other) = (self.machine.due[node.state as usize], self.other.due[node.other as usize]);
        let (step, other) = match (due, other) {
            (None, None) => return Ok(()),
            (Some(step), Some(other)) if step.events == other.events => (step, other),
            _ => {
                let reason = "of several events in one scan, the minimised controller makes other commands";
                return Err(self.refuted(id, reason.to_owned()));
            }
        };
        let mut config = self.real.get(node.real).clone();
        let mut after = Step::default();
        for &command in step.events {
            // What play-out never met, no scenario waits for.
            let Some(event) = self.commands[command as usize] else { continue };
            self.playout.step(&config, event, &mut after);
            if let Some(mistake) = after.error.take() {
                return Err(VerifyError::Play(mistake, self.play(id)));
            }
            std::mem::swap(&mut config, &mut after.config);
        }
        let real = self.intern_real(&config);
        let node = Node { real, pending: node.pending, state: step.target, other: other.target };
        self.visit(node, Some((id, Cause::Acted)));
        Ok(())
    }

    /// What counts of a state: who has yielded, and what guarantees wait for, binds no environment.
    fn intern_real(&mut self, config: &Config) -> u32 {
        let spec = self.playout.spec();
        let copies = config.copies.iter().copied();
        let is_assumed =
            |copy: &u32| spec.scenarios[self.playout.copy(*copy).scenario].kind == Kind::Assumption;
        let copies = copies.filter(is_assumed).collect();
        let (id, new) = self.real.intern(Config { valuation: config.valuation, copies, yielded: false });
        if new {
            self.sent.push(None);
        }
        id
    }

    fn visit(&mut self, node: Node, parent: Option<(u32, Cause)>) {
        if self.nodes.intern(node).1 {
            self.parent.push(parent);
        }
    }

    fn play(&self, id: u32) -> Vec<String> {
        let mut play = Vec::new();
        let mut here = id;
        while let Some((parent, cause)) = self.parent[here as usize] {
            match cause {
                Cause::Sent(event) => play.push(self.playout.text(Some(event)).to_owned()),
                Cause::Consumed => play.push("(the controller reads its inputs)".to_owned()),
                Cause::Acted => {
                    let step = self.machine.due[self.nodes.get(parent).state as usize];
                    let events = step.map_or(&[][..], |step| step.events);
                    let commands = &self.machine.controller.commands;
                    play.extend(events.iter().rev().map(|&command| commands[command as usize].text.clone()));
                }
            }
            here = parent;
        }
        play.reverse();
        play
    }

    fn refuted(&self, id: u32, reason: String) -> VerifyError {
        VerifyError::Refuted(Refutation { reason, play: self.play(id), cycle: Vec::new() })
    }
}
