//! Which events can happen in a state, and whose turn it is (language reference, section 4).

use super::events::EventId;
use super::keys::KeyId;
use super::{Config, PlayError, Playout, Step};
use crate::game::Turn;
use crate::model::{Kind, Modality};

/// Where a move leads.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Goal<'m> {
    /// To this state.
    State(&'m Config),
    /// The environment has violated a guarantee.
    Lost,
    /// Classic semantics: the system has violated an assumption.
    Won,
}

/// One move: an event, or a yield.
#[derive(Clone, Debug)]
pub struct Move {
    /// `None` is a yield.
    pub event: Option<EventId>,
    /// The state after it; where the game ends, what the violating step leads to.
    pub config: Config,
    /// The game ends with this move: [`Turn::Lost`] or [`Turn::Won`].
    pub end: Option<Turn>,
    /// Keys that it discharges, ascending.
    pub discharged: Vec<KeyId>,
    /// A copy of the existential scenario that is followed comes to its end.
    pub completed: bool,
}

/// Whose turn it is in a state, and all moves in the order of the events' texts, a yield last.
#[derive(Clone, Debug)]
pub struct Moves {
    /// Cases 1 to 6.
    pub turn: Turn,
    /// The environment may do nothing.
    pub silent: bool,
    /// The moves.
    pub moves: Vec<Move>,
}

impl Default for Moves {
    fn default() -> Self {
        Moves { turn: Turn::EnvironmentAny, silent: true, moves: Vec::new() }
    }
}

/// How urgently an event is asked for.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) enum Urgency {
    Committed,
    Urgent,
    Eventually,
}

impl From<Modality> for Urgency {
    fn from(modality: Modality) -> Self {
        match modality {
            Modality::Committed => Urgency::Committed,
            Modality::Urgent | Modality::Requested => Urgency::Urgent,
            Modality::Eventually => Urgency::Eventually,
        }
    }
}

/// What the active copies ask for.
#[derive(Default)]
pub(super) struct Wishes {
    pub(super) system: Vec<(Urgency, EventId)>,
    /// What relaxed guarantees ask of the system.
    relaxed: Vec<(Urgency, EventId)>,
    /// Messages of the system that cannot be formed.
    broken: Vec<(Urgency, PlayError)>,
    /// What assumptions say the environment sends; no urgency for monitored messages.
    environment: Vec<(Option<Urgency>, EventId)>,
}

impl Playout<'_> {
    /// Computes the moves of `config`.
    ///
    /// # Errors
    /// An event that can really happen in this turn meets a mistake of the specification; its id is given unless
    /// the event could not even be formed.
    pub fn moves(&mut self, config: &Config, moves: &mut Moves) -> Result<(), (Option<EventId>, PlayError)> {
        moves.moves.clear();
        moves.silent = false;
        let mut wishes = self.wishes(config);
        for (urgency, by_system, by_environment) in [
            (Urgency::Committed, Turn::SystemCommitted, Turn::EnvironmentCommitted),
            (Urgency::Urgent, Turn::SystemUrgent, Turn::EnvironmentUrgent),
        ] {
            if self.system_moves(config, &mut wishes, urgency, moves)? {
                moves.turn = by_system;
                return Ok(());
            }
            // Moves that do not decide the turn, because of what is relaxed: the system may make one of them.
            let offered = moves.moves.len();
            let wanted: Vec<EventId> =
                wishes.environment.iter().filter(|wish| wish.0 == Some(urgency)).map(|wish| wish.1).collect();
            if self.environment_moves(config, wanted, moves)? {
                if offered > 0 && !config.yielded {
                    moves.moves.truncate(offered);
                    offer_yield(config, moves);
                } else {
                    moves.moves.drain(..offered);
                    moves.turn = by_environment;
                }
                return Ok(());
            }
            moves.moves.truncate(offered);
        }
        if config.yielded {
            moves.moves.clear();
        } else {
            self.system_moves(config, &mut wishes, Urgency::Eventually, moves)?;
            if !moves.moves.is_empty() {
                offer_yield(config, moves);
                return Ok(());
            }
        }
        let caused = wishes.environment.iter().map(|wish| wish.1);
        let spontaneous = self.events.universe().filter(|&event| self.events.get(event).spontaneous);
        let candidates = spontaneous.chain(caused).collect();
        self.environment_moves(config, candidates, moves)?;
        moves.turn = Turn::EnvironmentAny;
        moves.silent = !self.semantics.classic || moves.moves.is_empty();
        Ok(())
    }

    /// What the environment can send in `config` whoever has the turn, in the order of the texts, and the states after it: events that
    /// violate no assumption, and are spontaneous or asked for by one. A guarantee that such an event violates is
    /// dropped.
    ///
    /// # Errors
    ///
    /// One of these meets a mistake of the specification.
    pub fn sendable(&mut self, config: &Config) -> Result<Vec<(EventId, Config)>, (EventId, PlayError)> {
        let spontaneous = self.events.universe().filter(|&event| self.events.get(event).spontaneous);
        let mut candidates: Vec<EventId> = spontaneous.collect();
        candidates.extend(self.wishes(config).environment.iter().map(|wish| wish.1));
        candidates.sort_unstable();
        candidates.dedup();
        let mut sendable = Vec::new();
        for event in candidates {
            if !self.is_linked(config, event) {
                continue;
            }
            let mut step = Step::default();
            self.step(config, event, &mut step);
            if step.violates(self.spec, Kind::Assumption) {
                continue;
            }
            if let Some(mistake) = step.error {
                return Err((event, mistake));
            }
            sendable.push((event, step.config));
        }
        Ok(sendable)
    }

    /// The environment's events that open assumptions ask for in `config`, ascending: what it *owes*.
    pub fn owed(&mut self, config: &Config) -> Vec<EventId> {
        let mut owed: Vec<EventId> = self.wishes(config).environment.into_iter().map(|wish| wish.1).collect();
        owed.sort_unstable();
        owed.dedup();
        owed
    }

    /// The events that active copies want in `config`, executable or not and whoever has the turn: what the system is
    /// asked to send, and what the environment owes. In the order of their texts.
    pub fn wanted(&mut self, config: &Config) -> Vec<EventId> {
        let wishes = self.wishes(config);
        let of_system = wishes.system.into_iter().chain(wishes.relaxed).map(|wish| wish.1);
        let mut wanted = of_system.chain(wishes.environment.into_iter().map(|wish| wish.1)).collect();
        self.sort_by_text(&mut wanted);
        wanted
    }

    pub(super) fn wishes(&mut self, config: &Config) -> Wishes {
        let mut wishes = Wishes::default();
        let relaxes = !self.relaxed.is_clear();
        let valuation = (config.valuation, self.valuations.get(config.valuation));
        for &copy in &config.copies {
            let offers = self.offers.of(self.spec, &mut self.events, &self.copies, copy, valuation);
            let is_relaxed = relaxes && self.relaxed.contains(self.copies.get(copy).scenario);
            let system = if is_relaxed { &mut wishes.relaxed } else { &mut wishes.system };
            for (modality, wanted) in &offers.system {
                match wanted {
                    Ok(event) => system.push(((*modality).into(), *event)),
                    Err(mistake) => wishes.broken.push(((*modality).into(), mistake.clone())),
                }
            }
            let environment = offers.environment.iter();
            wishes.environment.extend(environment.map(|&(m, event)| (m.map(Urgency::from), event)));
        }
        wishes
    }

    /// Adds the system's executable events of one urgency; whether they decide the turn. They do if one is among them
    /// that a guarantee in force asks for and that needs nothing relaxed to be executable.
    fn system_moves(
        &mut self,
        config: &Config,
        wishes: &mut Wishes,
        urgency: Urgency,
        moves: &mut Moves,
    ) -> Result<bool, (Option<EventId>, PlayError)> {
        if let Some(broken) = wishes.broken.iter().position(|(u, _)| *u == urgency) {
            return Err((None, wishes.broken.swap_remove(broken).1));
        }
        let wishes_of_all = wishes.system.iter().chain(&wishes.relaxed);
        let mut wanted: Vec<EventId> =
            wishes_of_all.filter(|(u, _)| *u == urgency).map(|&(_, event)| event).collect();
        self.sort_by_text(&mut wanted);
        let carried = moves.moves.len();
        let mut decides = false;
        for event in wanted {
            if !self.is_linked(config, event) {
                continue;
            }
            let mut step = Step::default();
            self.step(config, event, &mut step);
            if step.violates(self.spec, Kind::Guarantee) {
                continue;
            }
            let breaks_assumption = step.violates(self.spec, Kind::Assumption);
            if breaks_assumption && !self.semantics.classic {
                continue;
            }
            decides = decides || wishes.system.contains(&(urgency, event)) && !self.is_freed(&step, true);
            push(moves, event, step, breaks_assumption.then_some(Turn::Won))?;
        }
        if carried > 0 {
            let text = |one: &Move| one.event.map(|event| &self.events.get(event).text);
            moves.moves.sort_by(|a, b| text(a).cmp(&text(b)));
            moves.moves.dedup_by_key(|one| one.event);
        }
        Ok(decides)
    }

    /// Adds the environment's executable events among `candidates`; whether one of them needs nothing relaxed to be
    /// executable.
    fn environment_moves(
        &mut self,
        config: &Config,
        mut candidates: Vec<EventId>,
        moves: &mut Moves,
    ) -> Result<bool, (Option<EventId>, PlayError)> {
        let mut decides = false;
        // Ids of the environment's events are in the order of their texts.
        candidates.sort_unstable();
        candidates.dedup();
        for event in candidates {
            if !self.is_linked(config, event) {
                continue;
            }
            let mut step = Step::default();
            self.step(config, event, &mut step);
            if step.violates(self.spec, Kind::Assumption) {
                continue;
            }
            decides = decides || !self.is_freed(&step, false);
            let lost = step.violates(self.spec, Kind::Guarantee).then_some(Turn::Lost);
            push(moves, event, step, lost)?;
        }
        Ok(decides)
    }

    fn sort_by_text(&self, events: &mut Vec<EventId>) {
        events.sort_by(|&a, &b| self.events.get(a).text.cmp(&self.events.get(b).text));
        events.dedup();
    }

    /// Whether the sender knows the receiver, where a channel is required.
    pub(super) fn is_linked(&self, config: &Config, event: EventId) -> bool {
        let event = self.events.get(event);
        let values = self.valuations.get(config.valuation);
        event
            .links
            .as_ref()
            .is_none_or(|links| links.iter().any(|&slot| values[slot] == event.receiver as i64))
    }
}

fn push(
    moves: &mut Moves,
    event: EventId,
    step: Step,
    end: Option<Turn>,
) -> Result<(), (Option<EventId>, PlayError)> {
    match step.error {
        Some(mistake) => Err((Some(event), mistake)),
        None => {
            let Step { config, discharged, completed, .. } = step;
            moves.moves.push(Move { event: Some(event), config, end, discharged, completed });
            Ok(())
        }
    }
}

/// Turn 5: the system makes one of the moves that are there, or yields.
fn offer_yield(config: &Config, moves: &mut Moves) {
    let config = Config { yielded: true, ..config.clone() };
    moves.moves.push(Move { event: None, config, end: None, discharged: Vec::new(), completed: false });
    moves.turn = Turn::SystemEventually;
}

impl Move {
    /// Where it leads.
    #[must_use]
    pub fn goal(&self) -> Goal<'_> {
        match self.end {
            None => Goal::State(&self.config),
            Some(Turn::Won) => Goal::Won,
            Some(_) => Goal::Lost,
        }
    }
}
