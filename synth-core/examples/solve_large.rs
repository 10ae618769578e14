//! Times the solver on a large game: `cargo run --release --example solve_large -- 9`.
//!
//! As many jobs as the argument says run side by side. Each is started by the environment, accepted by the system,
//! performed by the environment (an assumption), and closed by the system (a guarantee); the system may yield before
//! it acts. A switch that the environment may flip at any time keeps it from being forced by silence alone. That makes
//! `4 · 4^jobs` states, numbered by the phases of the jobs, the switch, and whether the system has yielded.

use std::time::Instant;
use synth_core::game::{Actions, ActionsBuilder, Game, KeySetsBuilder, Turn, YIELD, extract, solve};

const IDLE: usize = 0;
const STARTED: usize = 1;
const ACCEPTED: usize = 2;
const PERFORMED: usize = 3;

fn main() {
    let jobs = std::env::args().nth(1).and_then(|jobs| jobs.parse().ok()).unwrap_or(9);
    let start = Instant::now();
    let game = jobs_game(jobs);
    println!("{} states, {} edges: built in {:?}", game.states(), game.edges(), start.elapsed());
    let start = Instant::now();
    let solution = solve(&game);
    println!("{} winning states: solved in {:?}", solution.winning_states(), start.elapsed());
    let start = Instant::now();
    match extract(&game, &solution) {
        Ok(strategy) => println!("{} nodes: extracted in {:?}", strategy.nodes(), start.elapsed()),
        Err(error) => println!("{error}"),
    }
}

/// Keys `0..jobs` are the assumptions that accepted jobs are performed, the next ones the guarantees that started
/// jobs are closed.
fn jobs_game(jobs: u32) -> Game {
    let phase = |state: usize, job: u32| state >> (2 * job) & 3;
    let mut sets = KeySetsBuilder::default();
    let mut actions = ActionsBuilder::default();
    let switch = 1 << (2 * jobs);
    let yielded = 2 * switch;
    let mut game = Game {
        initial: 0,
        turn: Vec::new(),
        silent: Vec::new(),
        open: Vec::new(),
        first: vec![0],
        action: Vec::new(),
        actions: Actions::default(),
        target: Vec::new(),
        key_sets: KeySetsBuilder::default().finish(),
        assumptions: (0..jobs).collect(),
        guarantees: (jobs..2 * jobs).collect(),
    };
    for state in 0..2 * yielded {
        let in_phase =
            |wanted: &'static [usize]| (0..jobs).filter(move |&job| wanted.contains(&phase(state, job)));
        let accepted = in_phase(&[ACCEPTED]);
        let unclosed = in_phase(&[STARTED, ACCEPTED, PERFORMED]).map(|job| jobs + job);
        game.open.push(sets.intern(&accepted.chain(unclosed).collect::<Vec<_>>()));
        let system = state < yielded && in_phase(&[STARTED, PERFORMED]).next().is_some();
        game.turn.push(if system { Turn::SystemEventually } else { Turn::EnvironmentAny });
        game.silent.push(!system);
        for job in in_phase(if system { &[STARTED, PERFORMED] } else { &[IDLE, ACCEPTED] }) {
            let phase = phase(state, job);
            let discharged = match phase {
                ACCEPTED => sets.intern(&[job]),
                PERFORMED => sets.intern(&[jobs + job]),
                _ => 0,
            };
            let next = (state & (yielded - 1)) - (phase << (2 * job)) + (((phase + 1) & 3) << (2 * job));
            game.action.push(actions.intern(job, discharged));
            game.target.push(next as u32);
        }
        if !system {
            game.action.push(actions.intern(jobs, 0));
            game.target.push((state & (yielded - 1) ^ switch) as u32);
        }
        if system {
            game.action.push(actions.intern(YIELD, 0));
            game.target.push((state + yielded) as u32);
        }
        game.first.push(game.target.len() as u32);
    }
    game.key_sets = sets.finish();
    game.actions = actions.finish();
    game
}
