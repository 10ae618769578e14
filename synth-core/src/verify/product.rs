//! The product of controller and specification, breadth first.

use super::machine::Machine;
use super::{Refutation, VerifyError};
use crate::controller::{Controller, SuperStep};
use crate::game::{Turn, YIELD};
use crate::intern::Indexed;
use crate::model::{Kind, Spec};
use crate::playout::{EventId, KeyId, PlayError, Playout, Semantics};
use crate::successors::{Edge, PackedMoves, SetId, StateId, StateStore, reserve};

/// A node: a state of the specification, one of the controller, and the next event of its due super step.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
struct Node {
    state: StateId,
    control: u32,
    position: u32,
}

/// The product so far. Node 0 is the initial one.
pub(super) struct Product<'a> {
    playout: Playout<'a>,
    store: StateStore,
    nodes: Indexed<Node>,
    /// Per node: the one before it on a shortest play into it, and the event or [`YIELD`]. Nothing of the kind for node 0.
    parent: Vec<(u32, EventId)>,
    /// Per explored node: the keys that are open.
    pub(super) open: Vec<SetId>,
    /// Per explored node: the environment has the turn.
    pub(super) environment: Vec<bool>,
    /// Per explored node: the environment may stay silent.
    pub(super) silent: Vec<bool>,
    /// Offsets into the edges, one more than there are explored nodes.
    first: Vec<u32>,
    /// Per edge: where it leads.
    pub(super) target: Vec<u32>,
    /// Per edge: its event or [`YIELD`].
    event: Vec<EventId>,
    /// Per edge: the keys that it discharges.
    pub(super) discharged: Vec<SetId>,
}

impl<'a> Product<'a> {
    /// Explores everything, or stops at the first thing that must not happen.
    pub(super) fn explore(
        spec: &'a Spec,
        semantics: Semantics,
        controller: &Controller,
        most_nodes: usize,
    ) -> Result<Self, VerifyError> {
        let unplayed = |error| VerifyError::Play(error, Vec::new());
        let mut playout = Playout::new(spec, semantics).map_err(unplayed)?;
        let config = playout.initial().map_err(unplayed)?;
        let mut product = Product {
            store: StateStore::new(&playout, &config),
            playout,
            nodes: Indexed::default(),
            parent: Vec::new(),
            open: Vec::new(),
            environment: Vec::new(),
            silent: Vec::new(),
            first: vec![0],
            target: Vec::new(),
            event: Vec::new(),
            discharged: Vec::new(),
        };
        let mut machine = Machine::new(controller);
        product.intern(Node { state: 0, control: controller.initial, position: 0 }, (0, YIELD));
        let mut moves = PackedMoves::default();
        for id in 0.. {
            if id as usize >= product.nodes.len() {
                break;
            }
            // Edges have `u32` offsets, too; one node adds fewer than the rest.
            if product.nodes.len() > most_nodes || product.target.len() > u32::MAX as usize - (1 << 24) {
                return Err(VerifyError::TooLarge(most_nodes));
            }
            let node = *product.nodes.get(id);
            if let Err((event, mistake)) = product.store.moves(&mut product.playout, node.state, &mut moves) {
                return Err(product.broken(id, event, mistake));
            }
            machine.keep_up(&product.playout);
            push(&mut product.open, moves.open);
            push(&mut product.environment, moves.turn.is_environment());
            push(&mut product.silent, moves.silent);
            match machine.due(node.control) {
                Some(step) => product.command(id, node, step, &machine, &moves)?,
                None => product.rest(id, node, &machine, &moves)?,
            }
            push(&mut product.first, product.target.len() as u32);
        }
        // Last, because what the play itself shows says more.
        check_components(spec, controller)?;
        Ok(product)
    }

    pub(super) fn nodes(&self) -> usize {
        self.nodes.len()
    }

    /// The controller sends the next event of its super step.
    fn command(
        &mut self,
        id: u32,
        node: Node,
        step: &SuperStep,
        machine: &Machine<'_>,
        moves: &PackedMoves,
    ) -> Result<(), VerifyError> {
        if let (0, Some(event)) = (node.position, machine.accepted(node.control)) {
            let reason = format!("the controller accepts `{event}` while its super step is due");
            return Err(self.refuted(id, None, reason));
        }
        let command = step.events[node.position as usize];
        let text = machine.command_text(command);
        if !moves.turn.is_system() {
            let reason = format!("the controller sends `{text}` in the environment's turn");
            return Err(self.refuted(id, None, reason));
        }
        let sent = moves.edges().iter().find(|edge| machine.is_command(edge.event, command));
        let Some(sent) = sent else {
            let reason = format!("the controller sends `{text}`, which is not allowed here");
            return Err(self.refuted(id, None, reason));
        };
        let last = node.position as usize + 1 == step.events.len();
        let (control, position) = if last { (step.target, 0) } else { (node.control, node.position + 1) };
        self.follow(id, moves, sent, control, position);
        Ok(())
    }

    /// The controller waits for the environment.
    fn rest(
        &mut self,
        id: u32,
        node: Node,
        machine: &Machine<'_>,
        moves: &PackedMoves,
    ) -> Result<(), VerifyError> {
        match moves.turn {
            Turn::SystemEventually => {
                if let Some(pass) = moves.edges().iter().find(|edge| edge.event == YIELD) {
                    self.follow(id, moves, pass, node.control, 0);
                }
            }
            Turn::SystemCommitted | Turn::SystemUrgent => {
                let reason = "the controller sends nothing where it must send a committed or urgent message";
                return Err(self.refuted(id, None, reason.to_owned()));
            }
            _ => {
                for edge in moves.edges() {
                    if edge.end == Some(Turn::Lost) {
                        let reason = "the environment violates a guarantee";
                        return Err(self.refuted(id, Some(edge.event), reason.to_owned()));
                    }
                    match machine.target(node.control, edge.event) {
                        Some(control) => self.follow(id, moves, edge, control, 0),
                        None => {
                            let text = &self.playout.event(edge.event).text;
                            let reason = format!("the controller does not accept `{text}`");
                            return Err(self.refuted(id, Some(edge.event), reason));
                        }
                    }
                }
            }
        }
        Ok(())
    }

    fn follow(&mut self, id: u32, moves: &PackedMoves, edge: &Edge, control: u32, position: u32) {
        // A move that wins the game at once (classic semantics) leads nowhere.
        if edge.end.is_none() {
            let state = self.store.intern(moves.target(edge));
            let target = self.intern(Node { state, control, position }, (id, edge.event));
            push(&mut self.target, target);
            push(&mut self.event, edge.event);
            push(&mut self.discharged, edge.discharged);
        }
    }

    fn intern(&mut self, node: Node, parent: (u32, EventId)) -> u32 {
        let (id, new) = self.nodes.intern(node);
        if new {
            push(&mut self.parent, parent);
        }
        id
    }

    /// The edges that leave a node.
    pub(super) fn edges_of(&self, node: u32) -> std::ops::Range<u32> {
        self.first[node as usize]..self.first[node as usize + 1]
    }

    /// Per set of keys: whether this one is in it.
    pub(super) fn containing(&self, key: KeyId) -> Vec<bool> {
        (0..self.store.sets()).map(|set| self.store.keys(set).binary_search(&key).is_ok()).collect()
    }

    /// Texts of a shortest play into a node.
    pub(super) fn play(&self, id: u32) -> Vec<String> {
        let mut play = Vec::new();
        let mut here = id;
        while here != 0 {
            let (parent, event) = self.parent[here as usize];
            play.push(self.text(event));
            here = parent;
        }
        play.reverse();
        play
    }

    /// The text of an edge.
    pub(super) fn edge_text(&self, edge: u32) -> String {
        self.text(self.event[edge as usize])
    }

    fn text(&self, event: EventId) -> String {
        self.playout.text((event != YIELD).then_some(event)).to_owned()
    }

    fn refuted(&self, id: u32, last: Option<EventId>, reason: String) -> VerifyError {
        let mut play = self.play(id);
        play.extend(last.map(|event| self.text(event)));
        VerifyError::Refuted(Refutation { reason, play, cycle: Vec::new() })
    }

    fn broken(&self, id: u32, event: Option<EventId>, mistake: PlayError) -> VerifyError {
        let mut play = self.play(id);
        play.extend(event.map(|event| self.text(event)));
        VerifyError::Play(mistake, play)
    }

    /// Whether a key belongs to an assumption.
    pub(super) fn is_assumed(&self, key: KeyId) -> bool {
        self.playout.spec().scenarios[self.playout.key(key).scenario].kind == Kind::Assumption
    }

    /// The keys that are open in some node, ascending.
    pub(super) fn open_keys(&self) -> Vec<KeyId> {
        let mut used = vec![false; self.store.sets() as usize];
        self.open.iter().for_each(|&set| used[set as usize] = true);
        let used = (0..self.store.sets()).filter(|&set| used[set as usize]);
        let mut keys: Vec<KeyId> = Vec::new();
        let mut seen = vec![false; self.playout.key_count()];
        for &key in used.flat_map(|set| self.store.keys(set)) {
            if !std::mem::replace(&mut seen[key as usize], true) {
                keys.push(key);
            }
        }
        keys.sort_unstable();
        keys
    }

    /// The name of the scenario that a key belongs to.
    pub(super) fn scenario_of(&self, key: KeyId) -> &str {
        &self.playout.spec().scenarios[self.playout.key(key).scenario].name
    }
}

fn push<T>(values: &mut Vec<T>, value: T) {
    reserve(values, 1);
    values.push(value);
}
/// Every command of a super step must have a code at the component that receives it.
fn check_components(spec: &Spec, controller: &Controller) -> Result<(), VerifyError> {
    let is_controllable = |name: &str| {
        let object = spec.domain.objects.iter().position(|object| object.name == name);
        object.is_some_and(|object| spec.controllable[object])
    };
    for &command in controller.super_steps.iter().flat_map(|step| &step.events) {
        let event = &controller.commands[command as usize];
        let component = controller.components.iter().find(|component| component.object == event.receiver);
        let has_code = component.is_some_and(|component| component.commands.contains(&command));
        if !has_code && !is_controllable(&event.receiver) {
            let reason = format!("`{}` has no command code at `{}`", event.text, event.receiver);
            return Err(VerifyError::Refuted(Refutation { reason, play: Vec::new(), cycle: Vec::new() }));
        }
    }
    Ok(())
}
