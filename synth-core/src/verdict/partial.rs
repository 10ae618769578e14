//! A game that is known in part: of some states all moves, of others only that they exist.

use crate::explore::{ExploreError, GameSets, LimitReached, Limits, open_somewhere};
use crate::game::{ActionsBuilder, Game, Turn, YIELD};
use crate::model::Kind;
use crate::playout::{EventId, KeyId, PlayError, Playout};
use crate::successors::{PackedMoves, StateId, StateStore, reserve};

/// Edges have `u32` offsets; one state adds fewer than the rest.
const MOST_EDGES: usize = (u32::MAX - (1 << 24)) as usize;

/// Memory is counted once in so many states: counting looks at everything that was remembered.
const MEMORY_PERIOD: usize = 256;

/// Stand for the losing and the won state among targets.
pub(super) const LOST: StateId = StateId::MAX;
pub(super) const WON: StateId = StateId::MAX - 1;

/// A state whose moves are not known has no place.
const NOWHERE: u32 = u32::MAX;

/// The states that were explored, with all their edges, in the order of exploration: a state's number in this order is its
/// *place*. The initial state is explored first.
#[derive(Debug)]
pub(super) struct Partial<'p, 's> {
    playout: &'p mut Playout<'s>,
    store: StateStore,
    /// Per state found: its place, or [`NOWHERE`].
    place: Vec<u32>,
    /// Per place: the state.
    state: Vec<StateId>,
    turn: Vec<Turn>,
    silent: Vec<bool>,
    open: Vec<u32>,
    first: Vec<u32>,
    action: Vec<u32>,
    /// Per edge: a state, [`LOST`] or [`WON`].
    target: Vec<StateId>,
    sets: GameSets,
    actions: ActionsBuilder,
    moves: PackedMoves,
}

impl<'p, 's> Partial<'p, 's> {
    /// Only the initial state is known.
    pub(super) fn new(playout: &'p mut Playout<'s>) -> Result<Self, ExploreError> {
        let initial = playout.initial().map_err(|error| ExploreError::Play(error, Vec::new()))?;
        Ok(Partial {
            store: StateStore::new(playout, &initial),
            playout,
            place: Vec::new(),
            state: Vec::new(),
            turn: Vec::new(),
            silent: Vec::new(),
            open: Vec::new(),
            first: vec![0],
            action: Vec::new(),
            target: Vec::new(),
            sets: GameSets::default(),
            actions: ActionsBuilder::default(),
            moves: PackedMoves::default(),
        })
    }

    /// How many states are known to exist.
    pub(super) fn found(&self) -> usize {
        self.store.len()
    }

    /// Of how many of these all moves are known.
    pub(super) fn explored(&self) -> usize {
        self.state.len()
    }

    /// How many edges these have.
    pub(super) fn edges(&self) -> usize {
        self.target.len()
    }

    /// The place of a state, if its moves are known.
    pub(super) fn place(&self, state: StateId) -> Option<usize> {
        self.place.get(state as usize).filter(|&&place| place != NOWHERE).map(|&place| place as usize)
    }

    /// Whose turn it is at a place.
    pub(super) fn turn(&self, place: usize) -> Turn {
        self.turn[place]
    }

    /// Where the moves at a place lead, in the order of the events' texts, a yield last.
    pub(super) fn targets(&self, place: usize) -> &[StateId] {
        &self.target[self.first[place] as usize..self.first[place + 1] as usize]
    }

    /// Finds the moves of a state that has no place yet, and gives it the next one.
    pub(super) fn explore(&mut self, state: StateId, limits: &Limits) -> Result<usize, ExploreError> {
        self.check(limits)?;
        let mut moves = std::mem::take(&mut self.moves);
        if let Err((event, mistake)) = self.store.moves(self.playout, state, &mut moves) {
            return Err(self.mistake(state, event, mistake));
        }
        for edge in moves.edges() {
            let target = match edge.end {
                None => self.store.intern(moves.target(edge)),
                Some(Turn::Won) => WON,
                Some(_) => LOST,
            };
            let discharged = self.sets.of(edge.discharged, &self.store);
            push(&mut self.action, self.actions.intern(edge.event, discharged));
            push(&mut self.target, target);
        }
        let place = self.explored();
        if self.place.len() < self.store.len() {
            let new = self.store.len() - self.place.len();
            reserve(&mut self.place, new);
            self.place.resize(self.store.len(), NOWHERE);
        }
        self.place[state as usize] = place as u32;
        push(&mut self.state, state);
        push(&mut self.turn, moves.turn);
        push(&mut self.silent, moves.silent);
        push(&mut self.open, self.sets.builder.intern_bits(moves.open_keys()));
        push(&mut self.first, self.target.len() as u32);
        self.moves = moves;
        Ok(place)
    }

    /// What is known, as a game: its first states are the places, and all states without a place are one with this
    /// turn, [`Turn::Lost`] or [`Turn::Won`].
    pub(super) fn game(&self, unknown: Turn) -> Game {
        let (lost, won) = (self.explored() as u32, self.explored() as u32 + 1);
        let unknown = if unknown == Turn::Won { won } else { lost };
        let node = |&target: &StateId| match target {
            LOST => lost,
            WON => won,
            state => self.place(state).map_or(unknown, |place| place as u32),
        };
        let key_sets = self.sets.builder.sets().clone();
        let is_open = open_somewhere(&self.open, &key_sets, self.playout.key_count());
        let of_kind = |kind: Kind| -> Vec<u32> {
            let scenarios = &self.playout.spec().scenarios;
            let keys = (0..self.playout.key_count() as KeyId).filter(|&key| is_open[key as usize]);
            keys.filter(|&key| scenarios[self.playout.key(key).scenario].kind == kind).collect()
        };
        let ends = [Turn::Lost, Turn::Won];
        Game {
            initial: 0,
            turn: self.turn.iter().copied().chain(ends).collect(),
            silent: self.silent.iter().copied().chain(ends.map(|_| false)).collect(),
            open: self.open.iter().copied().chain(ends.map(|_| 0)).collect(),
            first: self.first.iter().copied().chain(ends.map(|_| self.target.len() as u32)).collect(),
            action: self.action.clone(),
            target: self.target.iter().map(node).collect(),
            actions: self.actions.actions(),
            assumptions: of_kind(Kind::Assumption),
            guarantees: of_kind(Kind::Guarantee),
            key_sets,
        }
    }

    /// The explored states, with their places as numbers.
    pub(super) fn into_store(self) -> StateStore {
        let Partial { mut store, state, .. } = self;
        store.select(&state);
        store
    }

    /// The text of an edge.
    pub(super) fn text(&self, edge: u32) -> &str {
        self.playout.text(event_of(self.actions.label(self.action[edge as usize])))
    }

    /// A mistake of the specification, with a play to it.
    fn mistake(&self, state: StateId, event: Option<EventId>, mistake: PlayError) -> ExploreError {
        let mut found_by = vec![None; self.store.len()];
        for (edge, &target) in self.target.iter().enumerate() {
            if let Some(first @ None) = found_by.get_mut(target as usize) {
                *first = Some(edge as u32);
            }
        }
        let mut play: Vec<String> =
            event.map(|event| self.playout.text(Some(event)).to_owned()).into_iter().collect();
        let mut at = state;
        // A state is found before it is explored, so this goes back in time.
        while at != 0
            && let Some(edge) = found_by[at as usize]
        {
            play.push(self.text(edge).to_owned());
            at = self.state[self.first.partition_point(|&first| first <= edge) - 1];
        }
        play.reverse();
        ExploreError::Play(mistake, play)
    }

    /// Whether one more state may be explored.
    fn check(&self, limits: &Limits) -> Result<(), ExploreError> {
        if self.found() > limits.states {
            return Err(self.limit("states", limits.states));
        }
        if self.edges() > MOST_EDGES {
            return Err(self.limit("edges", MOST_EDGES));
        }
        if self.explored().is_multiple_of(MEMORY_PERIOD) && self.memory() > limits.memory {
            return Err(self.limit("memory", limits.memory));
        }
        Ok(())
    }

    fn limit(&self, what: &'static str, limit: usize) -> ExploreError {
        ExploreError::Limit(LimitReached {
            what,
            limit,
            states: self.found(),
            explored: self.explored(),
            edges: self.edges(),
            memory: self.memory(),
        })
    }

    /// Bytes held.
    fn memory(&self) -> usize {
        self.memory_of_states() + self.memory_of_edges()
    }

    /// Bytes held for states.
    pub(super) fn memory_of_states(&self) -> usize {
        self.store.memory()
            + self.playout.memory()
            + self.sets.builder.memory()
            + self.place.capacity() * size_of::<u32>()
            + self.turn.capacity() * (3 * size_of::<u32>() + 2)
    }

    /// Bytes held for edges.
    pub(super) fn memory_of_edges(&self) -> usize {
        self.target.capacity() * 2 * size_of::<u32>()
    }
}

fn push<T>(values: &mut Vec<T>, value: T) {
    reserve(values, 1);
    values.push(value);
}

/// The event of a label, none for a yield.
fn event_of(label: u32) -> Option<EventId> {
    (label != YIELD).then_some(label)
}
