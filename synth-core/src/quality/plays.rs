//! Shortest plays of the game, and how plays are shown.

use crate::explore::Explored;
use crate::game::ShortestPaths;
use crate::playout::EventId;

/// A shortest play to a state, and then an event: their texts.
pub(super) fn play_to(explored: &Explored<'_>, state: u32, last: EventId) -> Vec<String> {
    let game = &explored.game;
    let path = ShortestPaths::new(game.states(), &game.first, &game.target).to(state);
    let texts = path.into_iter().map(|edge| explored.text(edge)).chain([explored.playout.text(Some(last))]);
    texts.map(str::to_owned).collect()
}

/// A play as a note.
pub(super) fn note(play: &[String]) -> String {
    match play {
        [] => "this is so from the start".to_owned(),
        _ => format!("the shortest play that leads there:\n  {}", play.join("\n  ")),
    }
}
