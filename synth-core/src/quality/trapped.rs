//! A controller that leaves its environment no way to keep its assumptions.

use super::plays::note;
use crate::diagnostic::{Code, Diagnostic};
use crate::explore::Explored;
use crate::game::{Strategy, trapped};
use crate::playout::{Config, KeyId, Step};
use std::collections::BTreeSet;

/// Looks for a place in the controlled system from which no play of the environment is fair to all assumptions.
pub(super) fn environment(explored: &mut Explored<'_>, strategy: &Strategy) -> Option<Diagnostic> {
    let game = &explored.game;
    let trapped = trapped(game, strategy);
    let state = |node: u32| strategy.state[node as usize];
    let is_open = |node: u32, key: &KeyId| game.key_sets.contains(game.open[state(node) as usize], *key);
    // Where the environment has the turn and owes something: it shows there.
    let owes = |&node: &u32| {
        game.turn[state(node) as usize].is_environment()
            && game.assumptions.iter().any(|key| is_open(node, key))
    };
    let candidates = || (0..strategy.nodes() as u32).filter(|&node| trapped[node as usize]);
    let node = candidates().find(owes).or_else(|| candidates().next())?;
    let key = unmet(explored, strategy, node)?;
    let game = &explored.game;
    let is_idle = game.turn[state(node) as usize].is_environment() && game.edges_of(state(node)).is_empty();
    let play: Vec<String> = strategy
        .play_to(node)
        .into_iter()
        .map(|edge| explored.text(strategy.edge[edge] as usize).to_owned())
        .collect();
    let spec = explored.playout.spec();
    let key = explored.playout.key(key).clone();
    let scenario = &spec.scenarios[key.scenario];
    let message = if is_idle {
        "the controller can leave its environment without a move"
    } else {
        "the controller can leave its environment no way to keep its assumptions"
    };
    let place = scenario.nodes[usize::from(key.node)].span;
    let mut warning = Diagnostic::warning(Code::Trapped, place, message)
        .label(format!("assumption `{}` waits for this, and it can never happen", scenario.name))
        .note("a play in which an assumption is not kept counts as won: from there on the controller owes nothing")
        .note(note(&play));
    for blocked in blocked(explored, state(node)) {
        warning = warning.note(blocked);
    }
    Some(
        warning.help(
            "let the assumption promise less, or let a guarantee keep the controller from getting there",
        ),
    )
}

/// An assumption that is open in `node` and, if there is such a one, is never met in any play from there.
fn unmet(explored: &Explored<'_>, strategy: &Strategy, node: u32) -> Option<KeyId> {
    let game = &explored.game;
    let is_open = |node: u32, key: KeyId| {
        game.key_sets.contains(game.open[strategy.state[node as usize] as usize], key)
    };
    let mut unmet = game.assumptions.clone();
    unmet.retain(|&key| is_open(node, key));
    let first = unmet.first().copied();
    let mut seen = BTreeSet::from([node]);
    let mut ahead = vec![node];
    while let Some(node) = ahead.pop() {
        unmet.retain(|&key| is_open(node, key));
        for edge in strategy.edges_of(node) {
            let discharged = game.discharged(strategy.edge[edge] as usize);
            unmet.retain(|&key| !game.key_sets.contains(discharged, key));
            if seen.insert(strategy.target[edge]) {
                ahead.push(strategy.target[edge]);
            }
        }
    }
    unmet.first().copied().or(first).or_else(|| game.assumptions.first().copied())
}

/// What keeps the events from happening that the environment owes in a state.
fn blocked(explored: &mut Explored<'_>, state: u32) -> Vec<String> {
    let Explored { playout, store, .. } = explored;
    let spec = playout.spec();
    if state as usize >= store.len() {
        return Vec::new();
    }
    let mut config = Config::default();
    store.load(playout, state, &mut config);
    let mut step = Step::default();
    let mut blocked = Vec::new();
    for event in playout.owed(&config) {
        playout.step(&config, event, &mut step);
        let names: Vec<&str> = step.violated.iter().map(|&s| spec.scenarios[s].name.as_str()).collect();
        if !names.is_empty() {
            blocked.push(format!(
                "`{}` would violate `{}` there",
                playout.event(event).text,
                names.join("`, `")
            ));
        }
    }
    blocked
}
