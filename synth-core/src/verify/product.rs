//! The product of controller and specification, breadth first.

use super::{Refutation, VerifyError};
use crate::controller::{Controller, SuperStep};
use crate::game::Turn;
use crate::intern::Indexed;
use crate::model::{Kind, Spec};
use crate::playout::{Config, EventId, KeyId, Move, Moves, PlayError, Playout, Semantics};
use rustc_hash::FxHashMap;

/// A node: a state of the specification, one of the controller, and the next event of its due super step.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub(super) struct Node {
    config: Config,
    state: u32,
    position: u32,
}

/// An edge of the product.
#[derive(Clone, Debug)]
pub(super) struct Edge {
    pub(super) target: u32,
    /// `None` is a yield.
    event: Option<EventId>,
    /// Keys that it discharges, ascending.
    pub(super) discharged: Box<[KeyId]>,
}

/// The product so far. Node 0 is the initial one.
pub(super) struct Product<'a> {
    playout: Playout<'a>,
    nodes: Indexed<Node>,
    /// Per node: the edge on a shortest play into it.
    parent: Vec<Option<(u32, Option<EventId>)>>,
    /// Per explored node.
    pub(super) edges: Vec<Vec<Edge>>,
    /// Per explored node: its open keys, ascending.
    pub(super) open: Vec<Box<[KeyId]>>,
    /// Per explored node: the environment has the turn.
    pub(super) environment: Vec<bool>,
    /// Per explored node: the environment may stay silent.
    pub(super) silent: Vec<bool>,
}

/// The controller, made ready for look-ups.
struct Machine<'a> {
    controller: &'a Controller,
    rows: FxHashMap<(&'a str, u32), u32>,
    /// Per state: the first event that it accepts.
    accepted: Vec<Option<&'a str>>,
    due: Vec<Option<&'a SuperStep>>,
}

impl<'a> Machine<'a> {
    fn new(controller: &'a Controller) -> Self {
        let mut rows = FxHashMap::default();
        let mut accepted = vec![None; controller.states as usize];
        for (event, mapping) in controller.events.iter().zip(&controller.environment) {
            for &(source, target) in mapping {
                rows.insert((event.text.as_str(), source), target);
                accepted[source as usize].get_or_insert(event.text.as_str());
            }
        }
        let mut due = vec![None; controller.states as usize];
        for step in &controller.super_steps {
            due[step.source as usize] = Some(step);
        }
        Machine { controller, rows, accepted, due }
    }
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
            playout,
            nodes: Indexed::default(),
            parent: Vec::new(),
            edges: Vec::new(),
            open: Vec::new(),
            environment: Vec::new(),
            silent: Vec::new(),
        };
        let machine = Machine::new(controller);
        product.intern(Node { config, state: controller.initial, position: 0 }, None);
        let mut moves = Moves::default();
        for id in 0.. {
            if id as usize >= product.nodes.len() {
                break;
            }
            if product.nodes.len() > most_nodes {
                return Err(VerifyError::TooLarge(most_nodes));
            }
            let node = product.nodes.get(id).clone();
            if let Err((event, mistake)) = product.playout.moves(&node.config, &mut moves) {
                return Err(product.broken(id, event, mistake));
            }
            let mut open = Vec::new();
            product.playout.open_keys(&node.config, &mut open);
            product.open.push(open.into());
            product.environment.push(moves.turn.is_environment());
            product.silent.push(moves.silent);
            product.edges.push(Vec::new());
            match machine.due[node.state as usize] {
                Some(step) => product.command(id, &node, step, &machine, &moves)?,
                None => product.rest(id, &node, &machine, &moves)?,
            }
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
        node: &Node,
        step: &SuperStep,
        machine: &Machine<'_>,
        moves: &Moves,
    ) -> Result<(), VerifyError> {
        if let (0, Some(event)) = (node.position, machine.accepted[node.state as usize]) {
            let reason = format!("the controller accepts `{event}` while its super step is due");
            return Err(self.refuted(id, None, reason));
        }
        let text = &machine.controller.commands[step.events[node.position as usize] as usize].text;
        if !moves.turn.is_system() {
            return Err(self.refuted(
                id,
                None,
                format!("the controller sends `{text}` in the environment's turn"),
            ));
        }
        let sent =
            moves.moves.iter().find(|one| one.event.is_some_and(|e| self.playout.event(e).text == *text));
        let Some(sent) = sent else {
            return Err(self.refuted(
                id,
                None,
                format!("the controller sends `{text}`, which is not allowed here"),
            ));
        };
        let last = node.position as usize + 1 == step.events.len();
        let (state, position) = if last { (step.target, 0) } else { (node.state, node.position + 1) };
        self.follow(id, sent, state, position);
        Ok(())
    }

    /// The controller waits for the environment.
    fn rest(
        &mut self,
        id: u32,
        node: &Node,
        machine: &Machine<'_>,
        moves: &Moves,
    ) -> Result<(), VerifyError> {
        match moves.turn {
            Turn::SystemEventually => {
                if let Some(pass) = moves.moves.iter().find(|one| one.event.is_none()) {
                    self.follow(id, pass, node.state, 0);
                }
            }
            Turn::SystemCommitted | Turn::SystemUrgent => {
                let reason = "the controller sends nothing where it must send a committed or urgent message";
                return Err(self.refuted(id, None, reason.to_owned()));
            }
            _ => {
                for one in &moves.moves {
                    let Some(event) = one.event else { continue };
                    if one.end == Some(Turn::Lost) {
                        let reason = "the environment violates a guarantee";
                        return Err(self.refuted(id, Some(event), reason.to_owned()));
                    }
                    let text = self.playout.event(event).text.as_str();
                    match machine.rows.get(&(text, node.state)) {
                        Some(&target) => self.follow(id, one, target, 0),
                        None => {
                            let reason = format!("the controller does not accept `{text}`");
                            return Err(self.refuted(id, Some(event), reason));
                        }
                    }
                }
            }
        }
        Ok(())
    }

    fn follow(&mut self, id: u32, one: &Move, state: u32, position: u32) {
        // A move that wins the game at once (classic semantics) leads nowhere.
        if one.end.is_none() {
            let node = Node { config: one.config.clone(), state, position };
            let target = self.intern(node, Some((id, one.event)));
            let discharged = one.discharged.as_slice().into();
            self.edges[id as usize].push(Edge { target, event: one.event, discharged });
        }
    }

    fn intern(&mut self, node: Node, parent: Option<(u32, Option<EventId>)>) -> u32 {
        let (id, new) = self.nodes.intern(node);
        if new {
            self.parent.push(parent);
        }
        id
    }

    /// Texts of a shortest play into a node.
    pub(super) fn play(&self, id: u32) -> Vec<String> {
        let mut play = Vec::new();
        let mut here = id;
        while let Some((parent, event)) = self.parent[here as usize] {
            play.push(self.playout.text(event).to_owned());
            here = parent;
        }
        play.reverse();
        play
    }

    pub(super) fn edge_text(&self, edge: &Edge) -> String {
        self.playout.text(edge.event).to_owned()
    }

    fn refuted(&self, id: u32, last: Option<EventId>, reason: String) -> VerifyError {
        let mut play = self.play(id);
        play.extend(last.map(|event| self.playout.text(Some(event)).to_owned()));
        VerifyError::Refuted(Refutation { reason, play, cycle: Vec::new() })
    }

    fn broken(&self, id: u32, event: Option<EventId>, mistake: PlayError) -> VerifyError {
        let mut play = self.play(id);
        play.extend(event.map(|event| self.playout.text(Some(event)).to_owned()));
        VerifyError::Play(mistake, play)
    }

    /// Whether a key belongs to an assumption.
    pub(super) fn is_assumed(&self, key: KeyId) -> bool {
        self.playout.spec().scenarios[self.playout.key(key).scenario].kind == Kind::Assumption
    }

    pub(super) fn key_count(&self) -> usize {
        self.playout.key_count()
    }

    /// The name of the scenario that a key belongs to.
    pub(super) fn scenario_of(&self, key: KeyId) -> &str {
        &self.playout.spec().scenarios[self.playout.key(key).scenario].name
    }
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
