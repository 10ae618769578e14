//! No byte of a result depends on the number of threads.

use sml_tests::random::{Options as RandomOptions, specification};
use sml_tests::{corpus, fast};
use synth_core::explore::write_json;
use synth_core::game::{solve, solve_on};
use synth_core::pipeline::{Timings, synthesize};

/// The game as JSON, and the controller, or why there is none.
fn results(text: &str, classic: bool, threads: usize) -> (Vec<u8>, String) {
    let spec = fast::resolved(text).expect("a specification");
    let mut options = fast::options(classic, 20_000);
    options.limits.threads = threads;
    let mut game = Vec::new();
    let controller = match fast::solved(&spec, &options) {
        Err(failure) => format!("{failure:?}"),
        Ok(mut solved) => {
            write_json(&solved.explored, &mut game).expect("written");
            let verified = synthesize(&mut solved, &options, &mut Timings::default());
            format!("{:?}", verified.map(|verified| verified.controller))
        }
    };
    (game, controller)
}

#[track_caller]
fn check(name: &str, text: &str) {
    for classic in [false, true] {
        let one = results(text, classic, 1);
        for threads in [2, 3, 8] {
            assert!(
                one == results(text, classic, threads),
                "{name}, classic {classic}, {threads} threads\n{text}"
            );
        }
    }
}

#[test]
fn on_the_corpus() {
    for entry in corpus::all() {
        if fast::resolved(&entry.text).is_ok() {
            check(&entry.name, &entry.text);
        }
    }
}

#[test]
fn on_random_specifications() {
    for seed in 0..40 {
        check(&format!("seed {seed}"), &specification(seed, RandomOptions::default()));
    }
}

/// Goals that are pursued ahead, behind one that loses states, count for nothing.
#[test]
fn solutions() {
    let mut lost = 0;
    for seed in 0..400 {
        let spec = fast::resolved(&specification(seed, RandomOptions::default())).expect("a specification");
        let Ok(solved) = fast::solved(&spec, &fast::options(seed % 2 == 0, 3_000)) else { continue };
        let game = &solved.explored.game;
        let one = solve(game);
        lost += usize::from(one.winning_states() < game.states());
        for threads in [2, 3, 8] {
            assert_eq!(solve_on(game, threads), one, "seed {seed}, {threads} threads");
        }
    }
    assert!(lost > 50, "{lost}");
}

/// Batches of this one are large enough for all of them: ten lamps, each on or off.
#[test]
fn on_a_large_space() {
    let objects: String = (1..=10).map(|n| format!("  object lamp{n}: Lamp\n")).collect();
    let text = format!(
        "specification Lamps {{
  domain d {{ class Control {{ toggled() }} class Lamp {{ on: bool  confirm() }} }}
  object control: Control
{objects}  controllable {{ Control }}
  effects {{ Lamp -> Control.toggled() {{ sender.on = !sender.on }} }}
  collaboration C {{
    dynamic role Lamp lamp
    guarantee scenario G {{ lamp -> control.toggled() urgent control -> lamp.confirm() }}
  }}
}}"
    );
    let spec = fast::resolved(&text).expect("a specification");
    let solved = fast::solved(&spec, &fast::options(false, 20_000)).expect("a game");
    assert_eq!(solved.explored.game.states(), 1024 * 11);
    check("lamps", &text);
}
