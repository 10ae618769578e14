//! Shortest plays of the game, and how they are shown.

use crate::explore::Explored;
use crate::game::{Game, YIELD};
use crate::playout::{EventId, Playout};

/// One shortest play to every state.
pub(super) struct Plays {
    /// Per state: the edge by which it was found first, and where that begins.
    into: Vec<Option<(u32, u32)>>,
}

impl Plays {
    pub(super) fn of(game: &Game) -> Self {
        // States are numbered breadth first, so the first edge into a state lies on a shortest play.
        let mut into = vec![None; game.states()];
        for source in 0..game.states() as u32 {
            for edge in game.edges_of(source) {
                let entry = &mut into[game.target[edge] as usize];
                if entry.is_none() && game.target[edge] != game.initial {
                    *entry = Some((edge as u32, source));
                }
            }
        }
        Plays { into }
    }

    /// The texts of the events to `state`, and then that of `last`.
    pub(super) fn to(&self, explored: &Explored<'_>, state: u32, last: Option<EventId>) -> Vec<String> {
        let mut labels: Vec<u32> = last.into_iter().collect();
        let mut here = state;
        while let Some((edge, source)) = self.into[here as usize] {
            labels.push(explored.game.label[edge as usize]);
            here = source;
        }
        labels.reverse();
        labels.into_iter().map(|label| text(&explored.playout, label)).collect()
    }
}

/// The text of a label.
pub(super) fn text(playout: &Playout<'_>, label: u32) -> String {
    if label == YIELD { "yield".to_owned() } else { playout.event(label).text.clone() }
}

/// A play as a note.
pub(super) fn note(play: &[String]) -> String {
    match play {
        [] => "this is so from the start".to_owned(),
        _ => format!("the shortest play that leads there:\n  {}", play.join("\n  ")),
    }
}
