//! Where the game is played: whoever plays by hand, and whoever answers.

use super::controller::Controlled;
use super::environment::{Adversary, Answer};
use super::player::{Happened, Player, Side, Trouble};
use synth_core::explain::SILENCE;
use synth_core::syntax::Loaded;

/// Who answers.
pub(super) enum Opponent<'a> {
    /// Both sides are played by hand.
    Nobody,
    /// The controller plays the system.
    Controller(Controlled<'a>),
    /// The counter-strategy plays the environment.
    Environment(Box<Adversary<'a>>),
}

/// A play with what was chosen by hand.
pub(super) struct Table<'a> {
    pub(super) loaded: &'a Loaded,
    pub(super) player: Player<'a>,
    opponent: Opponent<'a>,
    /// The events that were given, as they are written.
    given: Vec<String>,
    /// The attributes before the last event that was given, and its answers.
    before: Vec<(String, String)>,
    /// Scenarios that this event and its answers violated.
    violated: Vec<String>,
}

impl<'a> Table<'a> {
    /// The play before anything happened. What the opponent does first comes with [`Table::restart`].
    pub(super) fn new(loaded: &'a Loaded, player: Player<'a>, opponent: Opponent<'a>) -> Self {
        let before = player.attributes();
        Table { loaded, player, opponent, given: Vec::new(), before, violated: Vec::new() }
    }

    /// Whether somebody answers.
    pub(super) fn is_answered(&self) -> bool {
        !matches!(self.opponent, Opponent::Nobody)
    }

    /// Whose events are given.
    pub(super) fn side(&self) -> Option<Side> {
        match self.opponent {
            Opponent::Nobody => None,
            Opponent::Controller(_) => Some(Side::Environment),
            Opponent::Environment(_) => Some(Side::System),
        }
    }

    /// The events given so far.
    pub(super) fn given(&self) -> &[String] {
        &self.given
    }

    /// The attributes before the last event that was given.
    pub(super) fn before(&self) -> &[(String, String)] {
        &self.before
    }

    /// The scenarios that the last event that was given, or an answer to it, violated.
    pub(super) fn violated(&self) -> &[String] {
        &self.violated
    }

    /// Begins anew. What the opponent does at once is added to `happened`.
    pub(super) fn restart(&mut self, happened: &mut Vec<Happened>) -> Result<(), Trouble> {
        self.player.restart().map_err(Trouble::Mistake)?;
        self.given.clear();
        self.violated.clear();
        self.before = self.player.attributes();
        match &mut self.opponent {
            Opponent::Nobody => Ok(()),
            Opponent::Controller(controller) => {
                let events = controller.begin();
                self.command(&events, happened)
            }
            Opponent::Environment(adversary) => {
                adversary.restart();
                self.suffer(happened)
            }
        }
    }

    /// Plays an event that was given, and the answer. Everything that happens is added to `happened`, also if not
    /// everything goes well.
    pub(super) fn give(&mut self, text: &str, happened: &mut Vec<Happened>) -> Result<(), Trouble> {
        let before = self.player.attributes();
        let first = happened.len();
        let event = self.player.play(text)?;
        let text = event.event.clone();
        happened.push(event);
        self.before = before;
        let answered = match &mut self.opponent {
            Opponent::Nobody => Ok(()),
            Opponent::Controller(controller) => {
                let events = controller.answer(&text);
                self.command(&events, happened)
            }
            Opponent::Environment(adversary) => {
                adversary.see(&text);
                self.suffer(happened)
            }
        };
        self.given.push(text);
        self.violated = happened[first..].iter().flat_map(|one| one.violated.iter().cloned()).collect();
        answered
    }

    /// Takes back the last events that were given, with their answers.
    pub(super) fn back(&mut self, events: usize) -> Result<(), Trouble> {
        let mut given = std::mem::take(&mut self.given);
        given.truncate(given.len().saturating_sub(events));
        let mut unseen = Vec::new();
        self.restart(&mut unseen)?;
        given.iter().try_for_each(|event| self.give(event, &mut unseen))
    }

    /// Plays the controller's events, and yields where it has no more to send.
    fn command(&mut self, events: &[&str], happened: &mut Vec<Happened>) -> Result<(), Trouble> {
        for event in events {
            happened.push(self.player.play(event)?);
        }
        while self.player.may_yield() {
            happened.push(self.player.play("yield")?);
        }
        Ok(())
    }

    /// Lets the environment play until the system has the turn, or has lost.
    fn suffer(&mut self, happened: &mut Vec<Happened>) -> Result<(), Trouble> {
        let Opponent::Environment(adversary) = &mut self.opponent else { return Ok(()) };
        loop {
            match adversary.answer(&self.player) {
                Answer::Waits => return Ok(()),
                Answer::Event(text) => {
                    let event = self.player.play(&text)?;
                    adversary.see(&text);
                    happened.push(event);
                }
                Answer::Starves(loss, first) => {
                    let repeated = first.map_or(&[][..], |first| &self.player.history()[first..]);
                    let outcome = adversary.describe(loss, repeated, &self.loaded.sources);
                    self.player.end(outcome.clone());
                    match happened.last_mut().filter(|_| first.is_some()) {
                        Some(last) => {
                            last.enabled.clear();
                            last.outcome = Some(outcome);
                        }
                        None => happened.push(silence(outcome)),
                    }
                    return Ok(());
                }
            }
        }
    }
}

/// Nothing happens any more.
fn silence(outcome: String) -> Happened {
    Happened {
        event: SILENCE.to_owned(),
        turn: Side::Environment,
        violated: Vec::new(),
        breaches: Vec::new(),
        enabled: Vec::new(),
        outcome: Some(outcome),
    }
}
