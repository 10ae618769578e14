//! One play: where it stands, what can happen next, and why something cannot.

use synth_core::diagnostic::{Code, Diagnostic};
use synth_core::explain::{Mention, refusal};
use synth_core::game::Turn;
use synth_core::model::Spec;
use synth_core::playout::{
    Config, CopyId, EventId, Moves, Objection, PlayError, Playout, Semantics, Stake, turn_reason,
};

/// A play under way.
pub(super) struct Player<'s> {
    playout: Playout<'s>,
    initial: Config,
    config: Config,
    /// What can happen now; nothing once the play is over.
    moves: Moves,
    /// Why the play has ended.
    over: Option<String>,
    /// Event texts so far.
    history: Vec<String>,
}

/// What an event did.
#[derive(Clone)]
pub(super) struct Happened {
    /// Its text.
    pub(super) event: String,
    /// Whose turn it was.
    pub(super) turn: Side,
    /// Names of the scenarios that it violated, sorted.
    pub(super) violated: Vec<String>,
    /// How it violated them.
    pub(super) breaches: Vec<Mention>,
    /// What can happen next.
    pub(super) enabled: Vec<String>,
    /// How the play has ended with this.
    pub(super) outcome: Option<String>,
}

/// Whose turn it is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Side {
    System,
    Environment,
}

impl Side {
    pub(super) fn name(self) -> &'static str {
        match self {
            Side::System => "system",
            Side::Environment => "environment",
        }
    }
}

/// An event, and what the active copies have to do with it.
pub(super) struct Choice {
    pub(super) event: String,
    /// It can happen now.
    pub(super) enabled: bool,
    pub(super) wanted_by: Vec<Mention>,
    pub(super) awaited_by: Vec<Mention>,
    /// Names of the copies that it would start.
    pub(super) starts: Vec<String>,
    /// What does not let it happen.
    pub(super) refused_by: Vec<Mention>,
    /// What it would violate all the same: the other side's scenarios.
    pub(super) violates: Vec<Mention>,
    /// There is no link for its channel.
    pub(super) unlinked: bool,
}

/// Why an event does not happen.
pub(super) enum Trouble {
    /// It cannot happen now; another one may.
    NotExecutable(Vec<String>),
    /// The play has reached a mistake of the specification.
    Mistake(Box<Diagnostic>),
}

impl<'s> Player<'s> {
    /// In the initial state.
    pub(super) fn new(spec: &'s Spec, semantics: Semantics) -> Result<Self, Box<Diagnostic>> {
        let initially = |mistake: PlayError| Box::new(mistake.diagnostic(&[]));
        let mut playout = Playout::new(spec, semantics).map_err(initially)?;
        let initial = playout.initial().map_err(initially)?;
        let config = initial.clone();
        let (moves, history) = (Moves::default(), Vec::new());
        let mut player = Player { playout, initial, config, moves, over: None, history };
        player.look()?;
        Ok(player)
    }

    /// Back to the initial state.
    pub(super) fn restart(&mut self) -> Result<(), Box<Diagnostic>> {
        self.config.clone_from(&self.initial);
        self.over = None;
        self.history.clear();
        self.look()
    }

    /// What is played.
    pub(super) fn spec(&self) -> &'s Spec {
        self.playout.spec()
    }

    /// The events so far.
    pub(super) fn history(&self) -> &[String] {
        &self.history
    }

    /// Whose turn it is and by which case; `None` when the play is over.
    pub(super) fn turn(&self) -> Option<Turn> {
        self.over.is_none().then_some(self.moves.turn)
    }

    /// Why it is that turn.
    pub(super) fn turn_reason(&self) -> &'static str {
        turn_reason(self.moves.turn, self.config.yielded)
    }

    /// Why the play is over, if it is.
    pub(super) fn over(&self) -> Option<&str> {
        self.over.as_deref()
    }

    /// Whether the system may yield.
    pub(super) fn may_yield(&self) -> bool {
        self.turn() == Some(Turn::SystemEventually)
    }

    /// The events that can happen now, in order, `yield` last.
    pub(super) fn enabled(&self) -> Vec<&str> {
        self.moves.moves.iter().map(|one| self.playout.text(one.event)).collect()
    }

    /// `object.attribute` and value of every attribute.
    pub(super) fn attributes(&self) -> Vec<(String, String)> {
        self.playout.attributes(self.config.valuation)
    }

    /// The active copies; existential scenarios are not followed.
    pub(super) fn copies(&self) -> Vec<CopyId> {
        self.playout.in_text_order(&self.config.copies)
    }

    /// To ask about copies.
    pub(super) fn playout(&self) -> &Playout<'s> {
        &self.playout
    }

    /// Lets an event happen; spaces do not count.
    pub(super) fn play(&mut self, text: &str) -> Result<Happened, Trouble> {
        let wanted = squeezed(text);
        let found = self.moves.moves.iter().find(|one| squeezed(self.playout.text(one.event)) == wanted);
        let Some(one) = found.cloned() else { return Err(Trouble::NotExecutable(self.why_not())) };
        let breaches = one.event.map_or(Vec::new(), |event| self.breaches(event));
        let mut violated: Vec<String> = breaches.iter().map(|(scenario, _)| scenario.clone()).collect();
        violated.sort_unstable();
        violated.dedup();
        let mut happened = Happened {
            event: self.playout.text(one.event).to_owned(),
            turn: if self.moves.turn.is_system() { Side::System } else { Side::Environment },
            violated,
            breaches: breaches.into_iter().map(|(_, mention)| mention).collect(),
            enabled: Vec::new(),
            outcome: None,
        };
        self.history.push(happened.event.clone());
        self.config = one.config;
        if let Some(end) = one.end {
            self.end(turn_reason(end, false).to_owned());
            happened.outcome.clone_from(&self.over);
        }
        self.look().map_err(Trouble::Mistake)?;
        happened.enabled = self.enabled().into_iter().map(str::to_owned).collect();
        Ok(happened)
    }

    /// Nothing happens any more.
    pub(super) fn end(&mut self, why: String) {
        self.over = Some(why);
        self.moves.moves.clear();
    }

    /// What can happen now, in the order of [`Player::enabled`], and then what is wanted but cannot.
    pub(super) fn choices(&mut self) -> Vec<Choice> {
        if self.over.is_some() {
            return Vec::new();
        }
        let enabled: Vec<Option<EventId>> = self.moves.moves.iter().map(|one| one.event).collect();
        let wanted = self.playout.wanted(&self.config);
        let refused = wanted.into_iter().map(Some).filter(|event| !enabled.contains(event));
        let refused: Vec<_> = refused.collect();
        enabled.into_iter().chain(refused).map(|event| self.choice(event)).collect()
    }

    /// The event of this text, if there was any talk of it so far.
    pub(super) fn find(&mut self, text: &str) -> Option<Choice> {
        let wanted = squeezed(text);
        if wanted == "yield" {
            return Some(self.choice(None));
        }
        let mut events = 0..self.playout.event_count() as EventId;
        let event = events.find(|&event| squeezed(&self.playout.event(event).text) == wanted)?;
        Some(self.choice(Some(event)))
    }

    fn choice(&mut self, event: Option<EventId>) -> Choice {
        let mut choice = Choice {
            event: self.playout.text(event).to_owned(),
            enabled: self.moves.moves.iter().any(|one| one.event == event),
            wanted_by: Vec::new(),
            awaited_by: Vec::new(),
            starts: Vec::new(),
            refused_by: Vec::new(),
            violates: Vec::new(),
            unlinked: false,
        };
        let Some(event) = event else { return choice };
        let reasons = self.playout.reasons(&self.config, event);
        let playout = &self.playout;
        let mentions = |stakes: &[Stake], says| {
            let mention = |stake: &Stake| {
                let scenario = playout.copy_name(stake.copy);
                Mention { scenario, place: stake.span, says }
            };
            stakes.iter().map(mention).collect()
        };
        choice.wanted_by = mentions(&reasons.wanted_by, "wanted here");
        choice.awaited_by = mentions(&reasons.awaited_by, "awaited here");
        choice.starts = reasons.starts.iter().map(|&copy| playout.copy_name(copy)).collect();
        choice.unlinked = reasons.unlinked;
        choice.refused_by = refusal(playout, event, &reasons).map_or(Vec::new(), |refusal| refusal.by);
        choice.violates = reasons.objections.iter().map(|one| Mention::of(playout, one)).collect();
        choice.violates.retain(|mention| !choice.refused_by.contains(mention));
        choice
    }

    /// Finds out what can happen next.
    fn look(&mut self) -> Result<(), Box<Diagnostic>> {
        if self.over.is_some() {
            self.moves.moves.clear();
            return Ok(());
        }
        self.playout.moves(&self.config, &mut self.moves).map_err(|(event, mistake)| {
            let diagnostic = Diagnostic::error(mistake.code, mistake.span, mistake.message);
            let event = event.map(|event| self.playout.event(event).text.clone());
            let play: Vec<String> = self.history.iter().cloned().chain(event).collect();
            Box::new(if play.is_empty() {
                diagnostic.note("this happens in the initial state")
            } else {
                diagnostic.note(format!("after this play:\n  {}", play.join("\n  ")))
            })
        })
    }

    /// Whose turn it is instead, and what can happen.
    fn why_not(&self) -> Vec<String> {
        if let Some(why) = &self.over {
            return vec![format!("the play is over: {why}")];
        }
        let side = if self.moves.turn.is_system() { Side::System } else { Side::Environment }.name();
        let enabled = self.enabled();
        vec![if enabled.is_empty() {
            format!("it is the turn of the {side}, and nothing is enabled")
        } else {
            format!("it is the turn of the {side}; enabled:\n  {}", enabled.join("\n  "))
        }]
    }

    /// How an event violates scenarios: the name of each and the place.
    fn breaches(&mut self, event: EventId) -> Vec<(String, Mention)> {
        let reasons = self.playout.reasons(&self.config, event);
        let scenarios = &self.playout.spec().scenarios;
        let breach =
            |one: Objection| (scenarios[one.scenario].name.clone(), Mention::of(&self.playout, &one));
        reasons.objections.into_iter().map(breach).collect()
    }
}

/// Code and message for an event that cannot happen.
pub(super) fn not_executable(text: &str) -> (Code, String) {
    (Code::NotExecutable, format!("`{}` cannot happen now", text.trim()))
}

/// Spaces do not count.
pub(super) fn squeezed(text: &str) -> String {
    text.chars().filter(|c| !c.is_whitespace()).collect()
}
