//! The fast implementation and the naive one see the same game: state by state, edge by edge.

use crate::corpus;
use crate::naive::explore::Owner;
use crate::naive::{self, ExploreError, Spec};
use std::collections::BTreeSet;
use synth_core::explore::{self, Explored, Limits};
use synth_core::game::{Game, Turn, YIELD};
use synth_core::model::resolve::resolve;
use synth_core::playout::Semantics;

/// What both must agree about.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Outcome {
    /// The specification runs into an error of play-out. Which of several is found first is left open.
    Mistake,
    /// There are too many states.
    TooLarge,
    /// One line a state, ordered breadth first, events by their text; the lost and the won one come last.
    Game(Vec<String>),
}

/// A state in words: turn (7 lost, 8 won), silence, number of open keys, winner, and edges with their numbers of discharged keys.
fn line(turn: u8, silent: bool, open: usize, wins: bool, edges: &[String]) -> String {
    let silent = if silent { ", silent" } else { "" };
    let winner = if wins { "system" } else { "environment" };
    format!("turn {turn}{silent}, {open} open, {winner} wins: {}", edges.join("; "))
}

/// As the naive implementation sees it.
///
/// # Errors
/// The specification is not well formed.
pub fn naive(text: &str, classic: bool, max_states: usize) -> Result<Outcome, String> {
    let spec = Spec::new(&corpus::parse(text)?)?;
    let semantics = if classic { naive::Semantics::Classic } else { naive::Semantics::Default };
    let graph = match naive::explore(&spec, semantics, max_states) {
        Ok(graph) => graph,
        Err(ExploreError::TooManyStates) => return Ok(Outcome::TooLarge),
        Err(ExploreError::Initial(_) | ExploreError::Play { .. }) => return Ok(Outcome::Mistake),
    };
    let winning = naive::solve(&graph);
    let turn = |owner| match owner {
        Owner::Turn(case) => case as u8,
        Owner::Lost => Turn::Lost as u8,
        Owner::Won => Turn::Won as u8,
    };
    // The fast implementation numbers the lost and the won state last.
    let mut order: Vec<usize> = (0..graph.nodes.len()).collect();
    order.sort_by_key(|&node| (turn(graph.nodes[node].owner).max(6), node));
    let mut number = vec![0; order.len()];
    for (index, &node) in order.iter().enumerate() {
        number[node] = index;
    }
    let describe = |&node: &usize| {
        let edges = graph.edges.iter().filter(|edge| edge.from == node);
        let edges: Vec<String> = edges
            .map(|edge| {
                let event = edge.event.as_ref().map_or("yield".into(), ToString::to_string);
                format!("{event} to {} ({})", number[edge.to], edge.discharged.len())
            })
            .collect();
        let state = &graph.nodes[node];
        line(turn(state.owner), state.silent, state.open.len(), winning[node], &edges)
    };
    Ok(Outcome::Game(order.iter().map(describe).collect()))
}

/// As the fast implementation sees it.
///
/// # Errors
/// It finds an error without playing.
pub fn fast(text: &str, classic: bool, max_states: usize) -> Result<Outcome, String> {
    let file = corpus::parse(text)?;
    let (spec, diagnostics) = resolve(&[file]);
    let Some(spec) = spec else {
        return Err(diagnostics.iter().map(|each| each.message.as_str()).collect::<Vec<_>>().join("\n"));
    };
    let limits = Limits { states: max_states, ..Limits::default() };
    match explore::explore(&spec, Semantics { classic }, &limits) {
        Ok(explored) => Ok(Outcome::Game(lines(&explored))),
        Err(explore::ExploreError::Play(..)) => Ok(Outcome::Mistake),
        Err(explore::ExploreError::Limit(_)) => Ok(Outcome::TooLarge),
    }
}

fn lines(Explored { playout, game, .. }: &Explored<'_>) -> Vec<String> {
    let solution = synth_core::game::solve(game);
    // Keys that are never open are not counted.
    let real: BTreeSet<u32> = game.assumptions.iter().chain(&game.guarantees).copied().collect();
    let keys =
        |game: &Game, set: u32| game.key_sets.members(set).iter().filter(|key| real.contains(key)).count();
    let describe = |state: u32| {
        let edges: Vec<String> = game
            .edges_of(state)
            .map(|edge| {
                let label = game.label[edge];
                let event = if label == YIELD { "yield" } else { playout.event(label).text.as_str() };
                format!("{event} to {} ({})", game.target[edge], keys(game, game.discharged[edge]))
            })
            .collect();
        let index = state as usize;
        let open = keys(game, game.open[index]);
        line(game.turn[index] as u8, game.silent[index], open, solution.wins(state), &edges)
    };
    (0..game.states() as u32).map(describe).collect()
}

/// Compares both.
///
/// # Errors
/// Where they differ, in words.
pub fn compare(text: &str, classic: bool, max_states: usize) -> Result<Outcome, String> {
    let (naive, fast) = (naive(text, classic, max_states)?, fast(text, classic, max_states)?);
    if naive == fast {
        return Ok(fast);
    }
    let (Outcome::Game(naive), Outcome::Game(fast)) = (&naive, &fast) else {
        return Err(format!("naive: {naive:?}\nfast: {fast:?}"));
    };
    let first = naive.iter().zip(fast).position(|(naive, fast)| naive != fast);
    Err(match first {
        Some(state) => format!("state {state}\nnaive: {}\nfast:  {}", naive[state], fast[state]),
        None => format!("naive has {} states, fast has {}", naive.len(), fast.len()),
    })
}
