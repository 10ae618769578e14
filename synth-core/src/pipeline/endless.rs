//! The message for a specification that only an endless super step wins.

use crate::controller::EndlessSuperStep;
use crate::diagnostic::{Code, Diagnostic};
use crate::explore::Explored;
use crate::game::Strategy;
use crate::syntax::{FileId, Pos, Span};

/// Says that the system wins only by a super step that never ends.
pub(super) fn diagnostic(
    explored: &Explored<'_>,
    strategy: &Strategy,
    endless: EndlessSuperStep,
) -> Diagnostic {
    let Explored { playout, game, .. } = explored;
    let texts = |edges: &[usize]| -> String {
        edges.iter().map(|&edge| format!("\n  {}", explored.text(strategy.edge[edge] as usize))).collect()
    };
    let play = strategy.play_to(endless.node);
    let (mut node, mut cycle) = (endless.node, Vec::new());
    while let Some(edge) = strategy.edges_of(node).next() {
        cycle.push(edge);
        node = strategy.target[edge];
        if node == endless.node {
            break;
        }
    }
    // What the system sends there is asked for by a guarantee.
    let mut open = game.key_sets.members(game.open[strategy.state[endless.node as usize] as usize]);
    let asked = open.find(|key| game.guarantees.contains(key)).map(|key| playout.key(key));
    let spec = playout.spec();
    let place = asked
        .map_or_else(start_of_file, |key| spec.scenarios[key.scenario].nodes[usize::from(key.node)].span);
    let message = "the system wins only by a super step that never ends";
    let mut diagnostic = Diagnostic::error(Code::EndlessSuperStep, place, message)
        .note("it keeps the environment from ever meeting an assumption that is still open; no controller can do that");
    if !play.is_empty() {
        diagnostic = diagnostic.note(format!("the shortest play that leads there:{}", texts(&play)));
    }
    diagnostic
        .note(format!("and then, for ever:{}", texts(&cycle)))
        .help("let the loop wait for an event of the environment, or relax a guarantee")
}

fn start_of_file() -> Span {
    let start = Pos { line: 1, column: 1 };
    Span { file: FileId(0), start, end: start }
}
