//! The explicit game: all states that are reachable by executable events and yields, breadth first.

use super::settle::SettleError;
use super::spec::Spec;
use super::state::{Key, State};
use super::turn::{Case, Semantics};
use super::value::Event;
use std::collections::{BTreeMap, BTreeSet};
use synth_core::syntax::ast::ScenarioKind;

/// Who owns a node.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Owner {
    /// Whoever has the turn.
    Turn(Case),
    /// Nobody: the environment has violated a guarantee.
    Lost,
    /// Nobody: the system has violated an assumption, with classic semantics.
    Won,
}

/// A state of the game.
#[derive(Clone, Debug)]
pub struct Node {
    /// What it looks like; the lost and the won one do not look like anything.
    pub state: Option<State>,
    /// Who owns it.
    pub owner: Owner,
    /// The environment may stay here for ever.
    pub silent: bool,
    /// Keys that are open, as indices into [`Graph::keys`].
    pub open: BTreeSet<usize>,
}

/// An event or a yield.
#[derive(Clone, Debug)]
pub struct Edge {
    /// Index of the node that it leaves.
    pub from: usize,
    /// The event; `None` is a yield.
    pub event: Option<Event>,
    /// Index of the node that it leads to.
    pub to: usize,
    /// Keys that are discharged, as indices into [`Graph::keys`].
    pub discharged: BTreeSet<usize>,
}

/// The game.
#[derive(Clone, Debug)]
pub struct Graph {
    /// States; the first is the initial one.
    pub nodes: Vec<Node>,
    /// Edges, ordered by the node they leave, then by text, a yield last.
    pub edges: Vec<Edge>,
    /// Keys that are open somewhere, with the kind of their scenario.
    pub keys: Vec<(ScenarioKind, Key)>,
}

/// Why there is no graph.
#[derive(Clone, Debug)]
pub enum ExploreError {
    /// There is no initial state.
    Initial(String),
    /// An event that can happen has no step.
    Play {
        /// Events that lead there.
        play: Vec<String>,
        /// The event.
        event: String,
        /// What is wrong with it.
        cause: SettleError,
    },
    /// There are more states than asked for.
    TooManyStates,
}

/// The figures of a graph, named as in the output of `sml check`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Figures {
    /// The initial state is winning.
    pub realizable: bool,
    /// All states, the lost and the won one too.
    pub states: usize,
    /// Events and yields.
    pub transitions: usize,
    /// Those of turns 1, 3 and 5.
    pub system_states: usize,
    /// Those of turns 2, 4 and 6.
    pub environment_states: usize,
    /// Those with the flag.
    pub yielded_states: usize,
    /// Those in which the environment has the turn and no event.
    pub idle_states: usize,
    /// Those from which the system wins.
    pub winning_states: usize,
    /// Keys of assumptions.
    pub assumption_sets: usize,
    /// Keys of guarantees, and the one for super steps.
    pub guarantee_sets: usize,
}

impl Figures {
    /// Names and values in the order of the declaration, verdict as 0 or 1.
    #[must_use]
    pub fn named(&self) -> [(&'static str, usize); 10] {
        [
            ("realizable", usize::from(self.realizable)),
            ("states", self.states),
            ("transitions", self.transitions),
            ("system_states", self.system_states),
            ("environment_states", self.environment_states),
            ("yielded_states", self.yielded_states),
            ("idle_states", self.idle_states),
            ("winning_states", self.winning_states),
            ("assumption_sets", self.assumption_sets),
            ("guarantee_sets", self.guarantee_sets),
        ]
    }
}

/// Nodes and edges with keys instead of their indices, as they are found.
#[derive(Default)]
struct Search {
    nodes: Vec<(Option<State>, Owner, bool)>,
    index: BTreeMap<State, usize>,
    lost: Option<usize>,
    won: Option<usize>,
    edges: Vec<(usize, Option<Event>, usize, BTreeSet<Key>)>,
}

impl Search {
    fn add(&mut self, state: State) -> usize {
        if let Some(&index) = self.index.get(&state) {
            return index;
        }
        let index = self.nodes.len();
        self.index.insert(state.clone(), index);
        // The owner is known when the node is expanded.
        self.nodes.push((Some(state), Owner::Lost, false));
        index
    }

    fn add_end(&mut self, owner: Owner) -> usize {
        let known = if owner == Owner::Lost { &mut self.lost } else { &mut self.won };
        let nodes = &mut self.nodes;
        *known.get_or_insert_with(|| {
            nodes.push((None, owner, false));
            nodes.len() - 1
        })
    }

    /// The events of a shortest play to a node: edges are found breadth first.
    fn play_to(&self, mut node: usize) -> Vec<String> {
        let mut play = Vec::new();
        while node != 0 {
            let Some((from, event, ..)) = self.edges.iter().find(|(_, _, to, _)| *to == node) else { break };
            play.push(event.as_ref().map_or("yield".into(), ToString::to_string));
            node = *from;
        }
        play.reverse();
        play
    }
}

/// Explores the whole game.
///
/// # Errors
/// See [`ExploreError`].
pub fn explore(spec: &Spec, semantics: Semantics, max_states: usize) -> Result<Graph, ExploreError> {
    let alphabet = spec.environment_alphabet();
    let mut search = Search::default();
    search.add(spec.initial().map_err(ExploreError::Initial)?);
    let mut next = 0;
    while next < search.nodes.len() {
        let from = next;
        next += 1;
        if search.nodes.len() > max_states {
            return Err(ExploreError::TooManyStates);
        }
        let Some(state) = search.nodes[from].0.clone() else { continue };
        let turn = spec.turn(&alphabet, &state, semantics).map_err(|error| ExploreError::Play {
            play: search.play_to(from),
            event: error.event,
            cause: error.cause,
        })?;
        search.nodes[from].1 = Owner::Turn(turn.case);
        search.nodes[from].2 = Spec::is_silent(&turn, semantics);
        for (event, step) in turn.events {
            // Among executable events, the environment's violate guarantees at most, the system's assumptions.
            let to = if step.violated.contains(&ScenarioKind::Guarantee) {
                search.add_end(Owner::Lost)
            } else if step.violated.contains(&ScenarioKind::Assumption) {
                search.add_end(Owner::Won)
            } else {
                search.add(step.state)
            };
            search.edges.push((from, Some(event), to, step.discharged));
        }
        if turn.case == Case::SystemEventually {
            let to = search.add(State { yielded: true, ..state });
            search.edges.push((from, None, to, BTreeSet::new()));
        }
    }
    Ok(number_keys(spec, search))
}

/// Replaces keys by numbers, those that are never open by nothing.
fn number_keys(spec: &Spec, search: Search) -> Graph {
    let open: Vec<BTreeSet<Key>> = search
        .nodes
        .iter()
        .map(|(state, ..)| state.as_ref().map(|state| spec.open(state)).unwrap_or_default())
        .collect();
    let keys: Vec<Key> = open.iter().flatten().cloned().collect::<BTreeSet<_>>().into_iter().collect();
    let numbers = |set: &BTreeSet<Key>| {
        set.iter().filter_map(|key| keys.binary_search(key).ok()).collect::<BTreeSet<_>>()
    };
    Graph {
        nodes: search
            .nodes
            .into_iter()
            .zip(&open)
            .map(|((state, owner, silent), open)| Node { state, owner, silent, open: numbers(open) })
            .collect(),
        edges: search
            .edges
            .iter()
            .map(|(from, event, to, discharged)| Edge {
                from: *from,
                event: event.clone(),
                to: *to,
                discharged: numbers(discharged),
            })
            .collect(),
        keys: keys.into_iter().map(|key| (spec.scenarios[key.scenario].kind, key)).collect(),
    }
}

impl Graph {
    /// Keys of one kind of scenario.
    #[must_use]
    pub fn keys_of(&self, kind: ScenarioKind) -> Vec<usize> {
        (0..self.keys.len()).filter(|&key| self.keys[key].0 == kind).collect()
    }

    /// The figures, given which nodes are winning.
    #[must_use]
    pub fn figures(&self, winning: &[bool]) -> Figures {
        let count = |wanted: &dyn Fn(usize, &Node) -> bool| {
            self.nodes.iter().enumerate().filter(|(index, node)| wanted(*index, node)).count()
        };
        let has_edge: BTreeSet<usize> = self.edges.iter().map(|edge| edge.from).collect();
        let is_system = |node: &Node| matches!(node.owner, Owner::Turn(case) if case.is_system());
        let is_environment = |node: &Node| matches!(node.owner, Owner::Turn(case) if !case.is_system());
        Figures {
            realizable: winning[0],
            states: self.nodes.len(),
            transitions: self.edges.len(),
            system_states: count(&|_, node| is_system(node)),
            environment_states: count(&|_, node| is_environment(node)),
            yielded_states: count(&|_, node| node.state.as_ref().is_some_and(|state| state.yielded)),
            idle_states: count(&|index, node| is_environment(node) && !has_edge.contains(&index)),
            winning_states: winning.iter().filter(|winning| **winning).count(),
            assumption_sets: self.keys_of(ScenarioKind::Assumption).len(),
            guarantee_sets: self.keys_of(ScenarioKind::Guarantee).len() + 1,
        }
    }
}
