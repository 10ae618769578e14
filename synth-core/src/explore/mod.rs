//! Exploration: every state that executable events and yields can reach, breadth first, as a [`Game`].
//!
//! Nothing is pruned. States are taken in batches (`batch`), which do not depend on the number of threads. They are numbered in order of discovery, edges ordered by the events' texts, so the result
//! depends on the specification alone. The losing state (and with classic semantics the won state) come last.

mod batch;
mod game_sets;
#[cfg(feature = "json")]
mod json;

pub use crate::successors::{StateId, StateStore};
#[cfg(feature = "json")]
pub use json::write_json;

use crate::diagnostic::counted;
use crate::game::{ActionsBuilder, Game, KeySets, ShortestPaths, Turn, YIELD};
use crate::model::{Kind, Spec};
use crate::playout::{EventId, KeyId, PlayError, Playout, Semantics};
use crate::successors::{
    Block, Found, Head, InOrder, Known, Learned, PackedMoves, Reader, next_batch, reserve,
};
use batch::{LOST, WON};
pub(crate) use game_sets::GameSets;
use std::fmt;
use std::ops::Range;

impl Explored<'_> {
    /// Bytes held for states: their rows and index, their part of the graph, and what is remembered of steps.
    #[must_use]
    pub fn memory_of_states(&self) -> usize {
        let game = &self.game;
        self.store.memory()
            + self.playout.memory()
            + game.key_sets.memory()
            + game.turn.capacity() * PER_STATE
    }

    /// Bytes held for edges.
    #[must_use]
    pub fn memory_of_edges(&self) -> usize {
        self.game.target.capacity() * PER_EDGE
    }

    /// The text of an edge of the game.
    #[must_use]
    pub fn text(&self, edge: usize) -> &str {
        self.playout.text(event_of(self.game.label(edge)))
    }
}

/// Bytes of the graph for each state, and for each edge.
const PER_STATE: usize = 2 * size_of::<u32>() + 2;
const PER_EDGE: usize = 2 * size_of::<u32>();

/// The event of a label, none for a yield.
fn event_of(label: u32) -> Option<EventId> {
    (label != YIELD).then_some(label)
}

/// When to stop.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Limits {
    /// Most states.
    pub states: usize,
    /// Most bytes for states, edges and what was remembered.
    pub memory: usize,
    /// Most threads; 0 is as many as the machine runs at once. Results do not depend on it.
    pub threads: usize,
}

impl Default for Limits {
    fn default() -> Self {
        Limits { states: u32::MAX as usize - 2, memory: usize::MAX, threads: 0 }
    }
}

/// Why exploration stopped early.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum ExploreError {
    /// A mistake of the specification that a play reaches, with the texts of its events.
    Play(PlayError, Vec<String>),
    /// A limit was reached.
    Limit(LimitReached),
}

/// Which limit was reached, and how far exploration came.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct LimitReached {
    /// `states`, `memory` or `edges`.
    pub what: &'static str,
    /// The limit.
    pub limit: usize,
    /// States found so far.
    pub states: usize,
    /// States of these whose moves are known.
    pub explored: usize,
    /// Edges found so far.
    pub edges: usize,
    /// Bytes in use.
    pub memory: usize,
}

impl LimitReached {
    /// What the limit counts, one of it.
    #[must_use]
    pub fn unit(&self) -> &'static str {
        match self.what {
            "memory" => "byte",
            "edges" => "transition",
            _ => "state",
        }
    }
}

impl fmt::Display for LimitReached {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let LimitReached { states, explored, edges, memory, .. } = self;
        let states = counted(*states, "state");
        let (edges, memory) = (counted(*edges, "transition"), counted(*memory, "byte"));
        write!(f, "found {states}, {explored} of them explored, {edges}, {memory}")
    }
}

/// The explored specification.
#[derive(Debug)]
pub struct Explored<'s> {
    /// The play-out with everything that it interned.
    pub playout: Playout<'s>,
    /// The packed states; ids are those of the game, except for the losing and the won state, which are not here.
    pub store: StateStore,
    /// The graph.
    pub game: Game,
}

/// Explores a specification.
///
/// # Errors
/// A mistake that only a play shows, or a limit.
pub fn explore<'s>(
    spec: &'s Spec,
    semantics: Semantics,
    limits: &Limits,
) -> Result<Explored<'s>, ExploreError> {
    let mut playout = Playout::new(spec, semantics).map_err(|error| ExploreError::Play(error, Vec::new()))?;
    let (store, game) = explore_with(&mut playout, limits)?;
    Ok(Explored { playout, store, game })
}

/// Explores what a play-out plays: its specification, where some scenarios may be relaxed. What it remembers serves the
/// next exploration, too.
///
/// # Errors
/// A mistake that only a play shows, or a limit.
pub fn explore_with(playout: &mut Playout<'_>, limits: &Limits) -> Result<(StateStore, Game), ExploreError> {
    let initial = playout.initial().map_err(|error| ExploreError::Play(error, Vec::new()))?;
    let mut explorer = Explorer {
        store: StateStore::new(playout, &initial),
        playout,
        graph: Graph { first: vec![0], ..Graph::default() },
        sets: GameSets::default(),
        actions: ActionsBuilder::default(),
        action_of: Vec::new(),
        blocks: Vec::new(),
        learned: Block::default(),
        buffers: 0,
    };
    explorer.run(limits)?;
    Ok(explorer.finish())
}

/// Edges have `u32` offsets; one state adds fewer than the rest.
const MOST_EDGES: usize = (u32::MAX - (1 << 24)) as usize;

/// Memory is counted once in so many states: counting looks at everything that was remembered.
const MEMORY_PERIOD: usize = 256;

/// The growing arrays of the game.
#[derive(Debug, Default)]
struct Graph {
    turn: Vec<Turn>,
    silent: Vec<bool>,
    open: Vec<u32>,
    first: Vec<u32>,
    action: Vec<u32>,
    target: Vec<u32>,
}

struct Explorer<'p, 's> {
    playout: &'p mut Playout<'s>,
    store: StateStore,
    graph: Graph,
    sets: GameSets,
    actions: ActionsBuilder,
    /// Per event, from 1 on, and for a yield: what it discharged last, and the action that this is.
    action_of: Vec<Option<(u32, u32)>>,
    /// The batch: what the tables gave, and what had to be learned.
    blocks: Vec<Block>,
    learned: Block,
    /// Bytes that these hold.
    buffers: usize,
}

/// A mistake in the moves of a state, and the event that met it.
type Mistake = (StateId, Option<EventId>, PlayError);

impl Explorer<'_, '_> {
    fn run(&mut self, limits: &Limits) -> Result<(), ExploreError> {
        while self.graph.turn.len() < self.store.len() {
            let Graph { turn, target, .. } = &self.graph;
            let states = next_batch(turn.len(), self.store.len(), target.len());
            let (filled, mistake) = self.find(&states, limits.threads);
            self.buffers = self.blocks[..filled].iter().chain([&self.learned]).map(Block::memory).sum();
            let blocks = std::mem::take(&mut self.blocks);
            let merged = self.merge(&blocks[..filled], mistake.as_ref().map(|one| one.0), limits);
            self.blocks = blocks;
            merged?;
            if let Some((state, event, mistake)) = mistake {
                self.check(limits)?;
                return Err(ExploreError::Play(mistake, self.play_to(state, event)));
            }
        }
        self.check_memory(limits)
    }

    /// Finds the moves of a batch, up to the first mistake; how many blocks have been filled.
    fn find(&mut self, states: &Range<StateId>, threads: usize) -> (usize, Option<Mistake>) {
        let mut moves = PackedMoves::default();
        loop {
            let filled =
                batch::fill(&mut self.blocks, &self.store, &self.sets.builder, states.clone(), threads);
            self.learned.clear(Known { rows: &self.store.rows, sets: &self.sets.builder });
            let mut narrow = Vec::new();
            let mut mistake = None;
            let heads = self.blocks[..filled].iter().flat_map(Block::heads);
            for (state, _) in states.clone().zip(heads).filter(|(_, head)| head.missed) {
                match self.store.learn(self.playout, state, &mut narrow, &mut moves) {
                    Ok(Learned::Moves) => {
                        let known = Known { rows: &self.store.rows, sets: &self.sets.builder };
                        batch::add(&mut self.learned, known, &moves);
                    }
                    Ok(Learned::Narrow) => {}
                    Err((event, error)) => {
                        mistake = Some((state, event, error));
                        break;
                    }
                }
            }
            if narrow.is_empty() {
                self.learned.look_up(Known { rows: &self.store.rows, sets: &self.sets.builder });
                return (filled, mistake);
            }
            self.store.widen(&narrow);
        }
    }

    /// Numbers what was found and adds it to the graph, up to a state.
    fn merge(&mut self, blocks: &[Block], end: Option<StateId>, limits: &Limits) -> Result<(), ExploreError> {
        let learned = std::mem::take(&mut self.learned);
        let mut states = InOrder::new(blocks, &learned);
        while let Some((head, edges, reader)) = states.next() {
            if end == Some(self.graph.turn.len() as StateId) {
                break;
            }
            self.check(limits)?;
            self.add(head, edges, reader);
        }
        self.learned = learned;
        Ok(())
    }

    fn add(&mut self, head: Head, edges: &[Found], reader: &mut Reader<'_>) {
        let open = reader.open(head, &mut self.sets.builder);
        for edge in edges {
            let target = reader.target(&mut self.store.rows);
            let discharged = self.sets.of(edge.discharged, &self.store);
            let action = self.action(edge.event, discharged);
            push(&mut self.graph.action, action);
            push(&mut self.graph.target, target);
        }
        let graph = &mut self.graph;
        push(&mut graph.turn, head.turn);
        push(&mut graph.silent, head.silent);
        push(&mut graph.open, open);
        push(&mut graph.first, graph.target.len() as u32);
    }

    /// The action of the game. Most events always discharge the same.
    fn action(&mut self, event: EventId, discharged: u32) -> u32 {
        let index = event.wrapping_add(1) as usize;
        if index >= self.action_of.len() {
            self.action_of.resize(index + 1, None);
        }
        match self.action_of[index] {
            Some((set, action)) if set == discharged => action,
            _ => {
                let action = self.actions.intern(event, discharged);
                self.action_of[index] = Some((discharged, action));
                action
            }
        }
    }

    /// Whether the next state may be looked at.
    fn check(&self, limits: &Limits) -> Result<(), ExploreError> {
        self.check_size(limits)?;
        if self.graph.turn.len().is_multiple_of(MEMORY_PERIOD) { self.check_memory(limits) } else { Ok(()) }
    }

    fn check_size(&self, limits: &Limits) -> Result<(), ExploreError> {
        if self.store.len() > limits.states {
            return Err(self.limit("states", limits.states));
        }
        if self.graph.target.len() > MOST_EDGES {
            return Err(self.limit("edges", MOST_EDGES));
        }
        Ok(())
    }

    fn check_memory(&self, limits: &Limits) -> Result<(), ExploreError> {
        if self.memory() > limits.memory { Err(self.limit("memory", limits.memory)) } else { Ok(()) }
    }

    fn limit(&self, what: &'static str, limit: usize) -> ExploreError {
        ExploreError::Limit(LimitReached {
            what,
            limit,
            states: self.store.len(),
            explored: self.graph.turn.len(),
            edges: self.graph.target.len(),
            memory: self.memory(),
        })
    }

    fn memory(&self) -> usize {
        let graph = &self.graph;
        self.store.memory()
            + self.playout.memory()
            + self.sets.builder.memory()
            + self.buffers
            + graph.target.capacity() * PER_EDGE
            + graph.turn.capacity() * PER_STATE
    }

    /// The shortest play to a state, and then the event that met a mistake there.
    fn play_to(&self, state: StateId, event: Option<EventId>) -> Vec<String> {
        let Graph { first, action, target, .. } = &self.graph;
        let path = ShortestPaths::new(self.store.len(), first, target).to(state);
        let labels = path.into_iter().map(|edge| self.actions.label(action[edge])).chain(event);
        labels.map(|label| self.playout.text(event_of(label)).to_owned()).collect()
    }

    fn finish(self) -> (StateStore, Game) {
        let Explorer { playout, mut store, graph, sets, actions, .. } = self;
        store.close();
        let Graph { mut turn, mut silent, mut open, mut first, mut action, mut target } = graph;
        for (placeholder, end) in [(LOST, Turn::Lost), (WON, Turn::Won)] {
            if target.contains(&placeholder) {
                let id = turn.len() as u32;
                target.iter_mut().filter(|target| **target == placeholder).for_each(|target| *target = id);
                turn.push(end);
                silent.push(false);
                open.push(0);
                first.push(action.len() as u32);
            }
        }
        for numbers in [&mut open, &mut first, &mut action, &mut target] {
            numbers.shrink_to_fit();
        }
        turn.shrink_to_fit();
        silent.shrink_to_fit();
        let key_sets = sets.builder.finish();
        let is_open = open_somewhere(&open, &key_sets, playout.key_count());
        let of_kind = |kind: Kind| -> Vec<u32> {
            let spec = playout.spec();
            let keys = (0..playout.key_count() as KeyId).filter(|&key| is_open[key as usize]);
            keys.filter(|&key| spec.scenarios[playout.key(key).scenario].kind == kind).collect()
        };
        let (assumptions, guarantees) = (of_kind(Kind::Assumption), of_kind(Kind::Guarantee));
        let game = Game {
            initial: 0,
            turn,
            silent,
            open,
            first,
            action,
            target,
            actions: actions.finish(),
            key_sets,
            assumptions,
            guarantees,
        };
        (store, game)
    }
}

fn push<T>(values: &mut Vec<T>, value: T) {
    reserve(values, 1);
    values.push(value);
}

/// Per key: whether it is open in some state. Others belong to copies that only events that cannot happen lead to.
pub(crate) fn open_somewhere(open: &[u32], key_sets: &KeySets, keys: usize) -> Vec<bool> {
    let mut used = vec![false; key_sets.len()];
    for &set in open {
        used[set as usize] = true;
    }
    let mut is_open = vec![false; keys];
    for set in (0..key_sets.len() as u32).filter(|&set| used[set as usize]) {
        for key in key_sets.members(set) {
            is_open[key as usize] = true;
        }
    }
    is_open
}
