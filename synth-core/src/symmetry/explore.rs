//! Exploration up to symmetry, breadth first: moves are those of play-out, and where they lead is replaced by what stands for it.

use super::canonical::{Canonical, Canonizer};
use super::interchangeable::Interchangeable;
use super::orbit::orbit_size;
use super::quotient::{MET, Quotient};
use crate::explore::{ExploreError, LimitReached, Limits};
use crate::game::Turn;
use crate::model::{Kind, Permutation};
use crate::playout::{Config, EventId, Goal, KeyId, Moves, PlayError, Playout};
use rustc_hash::FxHashMap;
use std::collections::BTreeSet;

/// Memory is counted once in so many states.
const MEMORY_PERIOD: usize = 64;

/// Edges have `u32` offsets; one state adds fewer than the rest.
const MOST_EDGES: usize = (u32::MAX - (1 << 24)) as usize;

/// In place of states that are numbered last.
const LOST: u32 = u32::MAX;
const WON: u32 = u32::MAX - 1;

/// In place of the goal that the super step ends, which is the last one where the system has the turn and else met.
const END_OF_SUPER_STEP: u32 = u32::MAX - 1;

/// A state that stands for others.
#[derive(Debug)]
pub(super) struct Representative {
    pub(super) config: Config,
    /// How many it stands for; `None` if nobody knows.
    pub(super) orbit: Option<u128>,
    /// Keys of guarantees and of assumptions that are open, ascending.
    goals: Vec<KeyId>,
    promises: Vec<KeyId>,
    /// The move that led here first, and what makes the representative of what it led to.
    found: Option<(u32, Option<EventId>, Permutation)>,
}

impl Representative {
    /// Keys that are open.
    fn open(&self, of_guarantees: bool) -> &[KeyId] {
        if of_guarantees { &self.goals } else { &self.promises }
    }
}

/// What exploration found. The losing and the won state, if there are such, come last in the game and are not among the
/// representatives.
#[derive(Debug)]
pub(super) struct Explored {
    pub(super) representatives: Vec<Representative>,
    pub(super) game: Quotient,
    /// Keys of guarantees, and of assumptions, that are open in some state of the whole game.
    pub(super) guarantee_keys: usize,
    pub(super) assumption_keys: usize,
    /// Bytes that the representatives and play-out held.
    pub(super) memory: usize,
}

/// Explores what stands for all states.
///
/// # Errors
/// A mistake that only a play shows, or a limit.
pub(super) fn explore(
    playout: &mut Playout<'_>,
    interchangeable: &Interchangeable,
    limits: &Limits,
) -> Result<Explored, ExploreError> {
    let initial = playout.initial().map_err(|error| ExploreError::Play(error, Vec::new()))?;
    let canonizer = Canonizer::new(&playout.spec().domain, interchangeable);
    let game = Quotient { first: vec![0], named: vec![0], ..Quotient::default() };
    let mut explorer = Explorer {
        playout,
        interchangeable,
        canonizer,
        ids: FxHashMap::default(),
        representatives: Vec::new(),
        game,
    };
    // Every permutation maps the initial state onto itself.
    let canonical = explorer.canonizer.of(explorer.playout, &initial);
    explorer.add(&canonical, None);
    explorer.run(limits)?;
    Ok(explorer.finish())
}

struct Explorer<'p, 's, 'i> {
    playout: &'p mut Playout<'s>,
    interchangeable: &'i Interchangeable,
    canonizer: Canonizer<'i>,
    ids: FxHashMap<Config, u32>,
    representatives: Vec<Representative>,
    game: Quotient,
}

impl Explorer<'_, '_, '_> {
    fn run(&mut self, limits: &Limits) -> Result<(), ExploreError> {
        let mut moves = Moves::default();
        while self.game.turn.len() < self.representatives.len() {
            self.check(limits)?;
            let state = self.game.turn.len();
            let config = self.representatives[state].config.clone();
            if let Err((event, mistake)) = self.playout.moves(&config, &mut moves) {
                return Err(self.mistake(state, event, mistake));
            }
            self.expand(state, &moves);
        }
        self.check_memory(limits)
    }

    fn expand(&mut self, state: usize, moves: &Moves) {
        let is_system = moves.turn.is_system();
        for one in &moves.moves {
            let canonical = match one.goal() {
                Goal::State(config) => Ok(self.canonizer.of(self.playout, config)),
                Goal::Lost => Err(LOST),
                Goal::Won => Err(WON),
            };
            let target = match &canonical {
                Ok(canonical) => self
                    .ids
                    .get(&canonical.config)
                    .copied()
                    .unwrap_or_else(|| self.add(canonical, Some((state as u32, one.event)))),
                Err(end) => *end,
            };
            self.game.target.push(target);
            let permutation = canonical.as_ref().ok().map(|canonical| &canonical.permutation);
            self.name_keys(state, target, permutation, &one.discharged, is_system);
            self.game.named.push(self.game.names.len());
        }
        let Representative { goals, promises, .. } = &self.representatives[state];
        self.game.open.push((goals.len() as u32 + u32::from(is_system), promises.len() as u32));
        self.game.turn.push(moves.turn);
        self.game.silent.push(moves.silent);
        self.game.first.push(self.game.target.len() as u32);
    }

    /// Says what the keys that are open in the source of an edge are in its target, which may be a placeholder.
    fn name_keys(
        &mut self,
        source: usize,
        target: u32,
        permutation: Option<&Permutation>,
        discharged: &[KeyId],
        is_system: bool,
    ) {
        for of_guarantees in [true, false] {
            for index in 0..self.representatives[source].open(of_guarantees).len() {
                let key = self.representatives[source].open(of_guarantees)[index];
                let name = match permutation {
                    Some(permutation) if discharged.binary_search(&key).is_err() => {
                        let key = self.playout.permuted_key(key, permutation);
                        let names = self.representatives[target as usize].open(of_guarantees);
                        names.binary_search(&key).map_or(MET, |name| name as u32)
                    }
                    _ => MET,
                };
                self.game.names.push(name);
            }
            if of_guarantees && is_system {
                self.game.names.push(END_OF_SUPER_STEP);
            }
        }
    }

    fn add(&mut self, canonical: &Canonical, found: Option<(u32, Option<EventId>)>) -> u32 {
        let id = self.representatives.len() as u32;
        let mut open = Vec::new();
        self.playout.open_keys(&canonical.config, &mut open);
        let spec = self.playout.spec();
        let of_guarantee =
            |key: &KeyId| spec.scenarios[self.playout.key(*key).scenario].kind == Kind::Guarantee;
        let (goals, promises) = open.into_iter().partition(of_guarantee);
        let stabiliser = canonical.stabiliser.as_ref();
        let orbit = stabiliser.and_then(|stabiliser| orbit_size(self.interchangeable, stabiliser));
        self.representatives.push(Representative {
            config: canonical.config.clone(),
            orbit,
            goals,
            promises,
            found: found.map(|(state, event)| (state, event, canonical.permutation.clone())),
        });
        self.ids.insert(canonical.config.clone(), id);
        id
    }

    /// A mistake with the shortest play that leads to it. In the play objects do not change places.
    fn mistake(&mut self, state: usize, event: Option<EventId>, mistake: PlayError) -> ExploreError {
        let mut path = Vec::new();
        let mut next = state;
        while let Some((source, event, permutation)) = &self.representatives[next].found {
            path.push((*event, permutation.inverse()));
            next = *source as usize;
        }
        let identity =
            Permutation::identity(self.interchangeable.group_of.len(), self.interchangeable.orbits.len());
        let mut play = Vec::new();
        let mut back = identity;
        for (event, inverse) in path.into_iter().rev() {
            let event = event.map(|event| self.playout.permuted_event(event, &back));
            play.push(self.playout.text(event).to_owned());
            back = inverse.then(&back);
        }
        let config = self.playout.permuted(&self.representatives[state].config, &back);
        let played = self.playout.moves(&config, &mut Moves::default());
        let (event, mistake) = played.err().unwrap_or((event, mistake));
        play.extend(event.map(|event| self.playout.text(Some(event)).to_owned()));
        ExploreError::Play(mistake, play)
    }

    fn check(&self, limits: &Limits) -> Result<(), ExploreError> {
        if self.representatives.len() > limits.states {
            return Err(self.limit("states", limits.states));
        }
        if self.game.target.len() > MOST_EDGES {
            return Err(self.limit("edges", MOST_EDGES));
        }
        if self.game.turn.len().is_multiple_of(MEMORY_PERIOD) { self.check_memory(limits) } else { Ok(()) }
    }

    fn check_memory(&self, limits: &Limits) -> Result<(), ExploreError> {
        if self.memory() > limits.memory { Err(self.limit("memory", limits.memory)) } else { Ok(()) }
    }

    fn memory(&self) -> usize {
        self.game.memory() + self.memory_of_states()
    }

    /// An estimate: each representative is there twice, with about as many copies as the last one.
    fn memory_of_states(&self) -> usize {
        let last = self.representatives.last().map_or(0, |last| {
            let Representative { config, goals, promises, found, .. } = last;
            let permutation = found.as_ref().map_or(0, |(_, _, permutation)| {
                (permutation.objects.len() + permutation.scenarios.len()) * size_of::<usize>()
            });
            2 * (config.copies.len() * 4 + size_of::<Config>())
                + (goals.len() + promises.len()) * 4
                + permutation
        });
        self.representatives.len() * (last + size_of::<Representative>()) + self.playout.memory()
    }

    fn limit(&self, what: &'static str, limit: usize) -> ExploreError {
        ExploreError::Limit(LimitReached {
            what,
            limit,
            states: self.representatives.len(),
            explored: self.game.turn.len(),
            edges: self.game.target.len(),
            memory: self.memory(),
        })
    }

    fn finish(mut self) -> Explored {
        let guarantee_keys = self.count_keys(true);
        let assumption_keys = self.count_keys(false);
        let memory = self.memory_of_states();
        let Explorer { representatives, mut game, .. } = self;
        for (placeholder, turn) in [(LOST, Turn::Lost), (WON, Turn::Won)] {
            if game.target.contains(&placeholder) {
                let id = game.states() as u32;
                game.target
                    .iter_mut()
                    .filter(|target| **target == placeholder)
                    .for_each(|target| *target = id);
                game.turn.push(turn);
                game.silent.push(false);
                game.open.push((0, 0));
                game.first.push(game.target.len() as u32);
            }
        }
        for edge in 0..game.target.len() {
            let target = game.target[edge] as usize;
            let end = if game.turn[target].is_system() { game.open[target].0 - 1 } else { MET };
            let names = &mut game.names[game.named[edge]..game.named[edge + 1]];
            names.iter_mut().filter(|name| **name == END_OF_SUPER_STEP).for_each(|name| *name = end);
        }
        Explored { representatives, game, guarantee_keys, assumption_keys, memory }
    }

    /// The keys that are open in some state: those of the representatives, under whatever names.
    fn count_keys(&mut self, of_guarantees: bool) -> usize {
        let open = self.representatives.iter().flat_map(|one| one.open(of_guarantees).iter().copied());
        let mut found: BTreeSet<KeyId> = open.collect();
        let mut agenda: Vec<KeyId> = found.iter().copied().collect();
        let generators = self.interchangeable.generators();
        while let Some(key) = agenda.pop() {
            for generator in &generators {
                let image = self.playout.permuted_key(key, generator);
                if found.insert(image) {
                    agenda.push(image);
                }
            }
        }
        found.len()
    }
}
