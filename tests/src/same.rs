//! Whether the real implementation and the naive one have found the same game, with the same winner everywhere.

use crate::naive::Graph;
use crate::naive::explore::Owner;
use synth_core::game::{Game, Solution, Turn, YIELD};
use synth_core::playout::Playout;

/// Walks both graphs at once; they must be the same up to the numbers of the losing and the won state.
///
/// # Errors
/// The first difference.
///
/// # Panics
/// The naive graph has a state that no edge leads to.
pub fn game(
    naive: &Graph,
    winning: &[bool],
    playout: &Playout<'_>,
    game: &Game,
    solution: &Solution,
) -> Result<(), String> {
    if naive.nodes.len() != game.states() || naive.edges.len() != game.edges() {
        return Err(format!(
            "naive {} states {} edges, real {} and {}",
            naive.nodes.len(),
            naive.edges.len(),
            game.states(),
            game.edges()
        ));
    }
    let mut first = vec![naive.edges.len(); naive.nodes.len() + 1];
    for (index, edge) in naive.edges.iter().enumerate().rev() {
        first[edge.from] = index;
    }
    let mut twin = vec![None; naive.nodes.len()];
    twin[0] = Some(game.initial);
    let mut stack = vec![0];
    while let Some(node) = stack.pop() {
        let state = twin[node].expect("paired before it is visited");
        let fail = |what: String| Err(format!("state {state} (naive {node}): {what}"));
        let turn = game.turn[state as usize];
        let same_owner = match naive.nodes[node].owner {
            Owner::Lost => turn == Turn::Lost,
            Owner::Won => turn == Turn::Won,
            Owner::Turn(case) => case as u8 == turn as u8,
        };
        if !same_owner {
            return fail(format!("naive owner {:?}, real turn {turn:?}", naive.nodes[node].owner));
        }
        if naive.nodes[node].silent != game.silent[state as usize] {
            return fail("silence differs".to_owned());
        }
        if naive.nodes[node].open.len() != game.key_sets.members(game.open[state as usize]).count() {
            return fail("open keys differ".to_owned());
        }
        if winning[node] != solution.wins(state) {
            return fail(format!("naive winner {}, real {}", winning[node], solution.wins(state)));
        }
        let edges = game.edges_of(state);
        let mine = naive.edges[first[node]..].iter().take_while(|edge| edge.from == node);
        let mine: Vec<_> = mine.collect();
        if mine.len() != edges.len() {
            return fail(format!("naive {} moves, real {}", mine.len(), edges.len()));
        }
        for (edge, naive_edge) in edges.zip(mine) {
            let label = game.label(edge);
            let text = if label == YIELD { "yield".to_owned() } else { playout.event(label).text.clone() };
            let naive_text = naive_edge.event.as_ref().map_or("yield".to_owned(), ToString::to_string);
            if text != naive_text {
                return fail(format!("naive move `{naive_text}`, real `{text}`"));
            }
            let discharged = game.key_sets.members(game.discharged(edge)).count();
            if naive_edge.discharged.len() != discharged {
                return fail(format!("`{text}` discharges {:?}, real {discharged}", naive_edge.discharged));
            }
            match twin[naive_edge.to] {
                None => {
                    twin[naive_edge.to] = Some(game.target[edge]);
                    stack.push(naive_edge.to);
                }
                Some(target) if target != game.target[edge] => {
                    return fail(format!("`{text}` leads to different states"));
                }
                Some(_) => {}
            }
        }
    }
    Ok(())
}
