//! Exploration: every state that executable events and yields can reach, breadth first, as a [`Game`].
//!
//! Nothing is pruned. States are numbered in order of discovery, edges ordered by the events' texts, so the result
//! depends on the specification alone. The losing state (and with classic semantics the won state) come last.

#[cfg(feature = "json")]
mod json;
mod store;

#[cfg(feature = "json")]
pub use json::write_json;
pub use store::{StateId, StateStore};

use crate::diagnostic::counted;
use crate::game::{ActionsBuilder, Game, KeySets, KeySetsBuilder, ShortestPaths, Turn, YIELD};
use crate::model::{Kind, Spec};
use crate::playout::{Config, EventId, KeyId, Move, Moves, PlayError, Playout, Semantics};
use std::fmt;

impl Explored<'_> {
    /// The text of an edge of the game.
    #[must_use]
    pub fn text(&self, edge: usize) -> &str {
        self.playout.text(event_of(self.game.label(edge)))
    }
}

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
}

impl Default for Limits {
    fn default() -> Self {
        Limits { states: u32::MAX as usize - 2, memory: usize::MAX }
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
        playout,
        store: StateStore::default(),
        graph: Graph { first: vec![0], ..Graph::default() },
        sets: KeySetsBuilder::default(),
        actions: ActionsBuilder::default(),
    };
    explorer.store.intern(explorer.playout, &initial);
    explorer.run(limits)?;
    Ok(explorer.finish())
}

/// Stands for the losing and the won state until all others have their numbers.
const LOST: u32 = u32::MAX;
const WON: u32 = u32::MAX - 1;

/// Edges have `u32` offsets; one state adds fewer than the rest.
const MOST_EDGES: usize = (u32::MAX - (1 << 24)) as usize;

/// Memory is counted once in so many states: counting looks at everything that was remembered.
const MEMORY_PERIOD: StateId = 256;

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
    sets: KeySetsBuilder,
    actions: ActionsBuilder,
}

impl Explorer<'_, '_> {
    fn run(&mut self, limits: &Limits) -> Result<(), ExploreError> {
        let mut config = Config::default();
        let mut moves = Moves::default();
        let mut open: Vec<KeyId> = Vec::new();
        let mut state = 0;
        while (state as usize) < self.store.len() {
            self.check_size(limits)?;
            if state % MEMORY_PERIOD == 0 {
                self.check_memory(limits)?;
            }
            self.store.load(state, &mut config);
            if let Err((event, mistake)) = self.playout.moves(&config, &mut moves) {
                return Err(ExploreError::Play(mistake, self.play_to(state, event)));
            }
            open.clear();
            self.playout.open_keys(&config, &mut open);
            self.graph.turn.push(moves.turn);
            self.graph.silent.push(moves.silent);
            self.graph.open.push(self.sets.intern(&open));
            for one in &moves.moves {
                self.edge(one);
            }
            self.graph.first.push(self.graph.target.len() as u32);
            state += 1;
        }
        self.check_memory(limits)
    }

    fn edge(&mut self, one: &Move) {
        let target = match one.end {
            None => self.store.intern(self.playout, &one.config),
            Some(Turn::Won) => WON,
            Some(_) => LOST,
        };
        let discharged = self.sets.intern(&one.discharged);
        self.graph.action.push(self.actions.intern(one.event.unwrap_or(YIELD), discharged));
        self.graph.target.push(target);
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
        let per_edge = 2 * size_of::<u32>();
        let per_state = 2 * size_of::<u32>() + 2;
        self.store.memory()
            + self.playout.memory()
            + graph.target.capacity() * per_edge
            + graph.turn.capacity() * per_state
    }

    /// The shortest play to a state, and then the event that met a mistake there.
    fn play_to(&self, state: StateId, event: Option<EventId>) -> Vec<String> {
        let Graph { first, action, target, .. } = &self.graph;
        let path = ShortestPaths::new(self.store.len(), first, target).to(state);
        let labels = path.into_iter().map(|edge| self.actions.label(action[edge])).chain(event);
        labels.map(|label| self.playout.text(event_of(label)).to_owned()).collect()
    }

    fn finish(self) -> (StateStore, Game) {
        let Explorer { playout, store, graph, sets, actions } = self;
        let Graph { mut turn, mut silent, mut open, mut first, action, mut target } = graph;
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
        let key_sets = sets.finish();
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

/// Per key: whether it is open in some state. Others belong to copies that only events that cannot happen lead to.
fn open_somewhere(open: &[u32], key_sets: &KeySets, keys: usize) -> Vec<bool> {
    let mut used = vec![false; key_sets.len()];
    for &set in open {
        used[set as usize] = true;
    }
    let mut is_open = vec![false; keys];
    for set in (0..key_sets.len() as u32).filter(|&set| used[set as usize]) {
        for &key in key_sets.members(set) {
            is_open[key as usize] = true;
        }
    }
    is_open
}
