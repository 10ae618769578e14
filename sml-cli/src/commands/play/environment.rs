//! The environment as a player: it wins an unrealizable specification whatever the system does.

use super::player::Player;
use std::collections::BTreeMap;
use synth_core::game::{CounterStrategy, Loss, Standing};
use synth_core::pipeline::Solved;
use synth_core::syntax::Sources;

/// The counter-strategy at work in a play.
pub(super) struct Adversary<'a> {
    solved: &'a Solved<'a>,
    strategy: CounterStrategy<'a>,
    at: Standing,
    /// When the play came to a place where something starves.
    visited: BTreeMap<Standing, usize>,
}

/// What the environment does.
pub(super) enum Answer {
    /// It lets this event happen.
    Event(String),
    /// It waits for the system.
    Waits,
    /// It need not do anything more: the play has come round to where it was, after so many events, or nothing happens
    /// any more.
    Starves(Loss, Option<usize>),
}

impl<'a> Adversary<'a> {
    /// `None` if the system wins.
    pub(super) fn new(solved: &'a Solved<'a>) -> Option<Self> {
        let strategy = CounterStrategy::new(&solved.explored.game, &solved.solution)?;
        let at = strategy.begin();
        Some(Adversary { solved, strategy, at, visited: BTreeMap::new() })
    }

    pub(super) fn restart(&mut self) {
        self.at = self.strategy.begin();
        self.visited.clear();
    }

    /// An event happened, or a yield, whoever chose it.
    pub(super) fn see(&mut self, text: &str) {
        let game = &self.solved.explored.game;
        let edge = game.edges_of(self.at.state).find(|&edge| self.solved.explored.text(edge) == text);
        if let Some(edge) = edge {
            self.at = self.strategy.follow(self.at, edge as u32);
        }
    }

    /// What comes next, after the play so far.
    pub(super) fn answer(&mut self, player: &Player<'_>) -> Answer {
        let Some(turn) = player.turn() else { return Answer::Waits };
        let starved = self.strategy.starves(self.at);
        if let Some(loss) = starved
            && let Some(first) = self.visited.insert(self.at, player.history().len())
        {
            return Answer::Starves(loss, Some(first));
        }
        if turn.is_system() {
            return Answer::Waits;
        }
        match (self.strategy.choose(self.at), starved) {
            (Some(edge), _) => Answer::Event(self.solved.explored.text(edge as usize).to_owned()),
            (None, Some(loss)) => Answer::Starves(loss, None),
            (None, None) => Answer::Waits,
        }
    }

    /// What it means that something starves: `repeated` is what happens again and again.
    pub(super) fn describe(&self, loss: Loss, repeated: &[String], sources: &Sources) -> String {
        let playout = &self.solved.explored.playout;
        let what = match loss {
            Loss::Starvation(key) => {
                let key = playout.key(key);
                let scenario = &playout.spec().scenarios[key.scenario];
                let place = sources.place(scenario.nodes[usize::from(key.node)].span);
                format!("you cannot meet {} ({place})", scenario.name)
            }
            Loss::Endless => "your super step never ends".to_owned(),
            Loss::Violation => "the environment violates a guarantee".to_owned(),
        };
        if repeated.is_empty() {
            format!("{what}: the environment stays silent for ever")
        } else {
            format!("{what}: this loop repeats for ever:\n  {}", repeated.join("\n  "))
        }
    }
}
