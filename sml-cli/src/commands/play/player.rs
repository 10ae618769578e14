//! One play: where it stands, what can happen next, and why something cannot.

use crate::failure::{Failure, nowhere};
use synth_core::diagnostic::{Code, Diagnostic};
use synth_core::game::Turn;
use synth_core::model::Spec;
use synth_core::playout::{Config, EventId, Move, Moves, PlayError, Playout, Semantics, Step};

/// A play under way.
pub(super) struct Player<'s> {
    playout: Playout<'s>,
    config: Config,
    /// What can happen now; nothing once the play is over.
    moves: Moves,
    /// The play has ended: one side has violated a scenario of its own.
    over: bool,
    /// Event texts so far.
    history: Vec<String>,
}

/// What an event did.
pub(super) struct Happened {
    /// Its text.
    pub(super) event: String,
    /// Whose turn it was.
    pub(super) turn: Side,
    /// Names of the scenarios that it violated, sorted.
    pub(super) violated: Vec<String>,
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

/// Why a play does not go on.
pub(super) enum Trouble {
    /// The event cannot happen now; another one may.
    NotExecutable(Box<Diagnostic>),
    /// The play has reached a mistake of the specification.
    Mistake(Box<Diagnostic>),
    /// What happened cannot be shown.
    Unshown(Failure),
}

impl From<Failure> for Trouble {
    fn from(failure: Failure) -> Self {
        Trouble::Unshown(failure)
    }
}

impl<'s> Player<'s> {
    /// In the initial state.
    pub(super) fn new(spec: &'s Spec, semantics: Semantics) -> Result<Self, Box<Diagnostic>> {
        let initially = |mistake: PlayError| Box::new(mistake.diagnostic(&[]));
        let mut playout = Playout::new(spec, semantics).map_err(initially)?;
        let config = playout.initial().map_err(initially)?;
        let mut player =
            Player { playout, config, moves: Moves::default(), over: false, history: Vec::new() };
        player.look()?;
        Ok(player)
    }

    /// Whose turn it is; the environment's when the play is over.
    pub(super) fn turn(&self) -> Side {
        if !self.over && self.moves.turn.is_system() { Side::System } else { Side::Environment }
    }

    /// Whether the system may yield.
    pub(super) fn may_yield(&self) -> bool {
        !self.over && self.moves.turn == Turn::SystemEventually
    }

    /// The events that can happen now, in order, `yield` last.
    pub(super) fn enabled(&self) -> Vec<&str> {
        self.moves.moves.iter().map(|one| self.text(one.event)).collect()
    }

    /// The text of the enabled event that is written like this, spaces apart.
    pub(super) fn find(&self, text: &str) -> Option<String> {
        let wanted = squeezed(text);
        self.enabled().into_iter().find(|enabled| squeezed(enabled) == wanted).map(str::to_owned)
    }

    /// Lets an event happen.
    pub(super) fn play(&mut self, text: &str) -> Result<Happened, Trouble> {
        let Some(text) = self.find(text) else {
            return Err(Trouble::NotExecutable(self.why_not(text)));
        };
        let one = self.moves.moves.iter().find(|one| self.text(one.event) == text);
        let Some(Move { event, config, end, .. }) = one.cloned() else {
            return Err(Trouble::NotExecutable(self.why_not(&text)));
        };
        let happened = Happened {
            turn: self.turn(),
            violated: event.map_or(Vec::new(), |event| self.violated_by(event)),
            event: text.clone(),
        };
        self.history.push(text);
        self.config = config;
        self.over = end.is_some();
        self.look().map_err(Trouble::Mistake)?;
        Ok(happened)
    }

    /// Finds out what can happen next.
    fn look(&mut self) -> Result<(), Box<Diagnostic>> {
        if self.over {
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

    fn why_not(&mut self, text: &str) -> Box<Diagnostic> {
        let text = text.trim();
        let diagnostic = nowhere(Code::NotExecutable, format!("`{text}` cannot happen now"));
        if self.over {
            return Box::new(diagnostic.note("the play is over: a scenario was violated"));
        }
        let violated = self.playout.find_event(text).map_or(Vec::new(), |event| self.violated_by(event));
        let enabled = self.enabled();
        let mut diagnostic = diagnostic.note(if enabled.is_empty() {
            format!("it is the turn of the {}, and nothing is enabled", self.turn().name())
        } else {
            format!("it is the turn of the {}; enabled:\n  {}", self.turn().name(), enabled.join("\n  "))
        });
        if !violated.is_empty() {
            diagnostic = diagnostic.note(format!("it would violate `{}`", violated.join("`, `")));
        }
        Box::new(diagnostic)
    }

    fn violated_by(&mut self, event: EventId) -> Vec<String> {
        let mut step = Step::default();
        self.playout.step(&self.config, event, &mut step);
        let scenarios = &self.playout.spec().scenarios;
        let mut names: Vec<String> =
            step.violated.iter().map(|&scenario| scenarios[scenario].name.clone()).collect();
        names.sort_unstable();
        names
    }

    fn text(&self, event: Option<EventId>) -> &str {
        event.map_or("yield", |event| &self.playout.event(event).text)
    }
}

fn squeezed(text: &str) -> String {
    text.chars().filter(|c| !c.is_whitespace()).collect()
}
