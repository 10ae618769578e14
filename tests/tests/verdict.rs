//! The verdict that is found without exploring everything is that of the whole game, and often found early. So are strategies.

use sml_tests::families::{arbiter, cabins, lift, line};
use sml_tests::random::{Features, Options as RandomOptions, specification};
use sml_tests::{corpus, fast};
use synth_core::controller::{Controller, Level};
use synth_core::explain::SILENCE;
use synth_core::explore::{ExploreError, Limits, explore};
use synth_core::game::Turn;
use synth_core::model::Spec;
use synth_core::pipeline::{Failure, Options, Solved, Timings, Verified, play_and_solve_early, synthesize};
use synth_core::verdict::{Forced, Verdict, verdict};

/// How many specifications of a kind there were, and how many of these were decided early.
#[derive(Default, Debug)]
struct Count {
    all: usize,
    early: usize,
}

/// Realizable and unrealizable ones.
#[derive(Default, Debug)]
struct Counts([Count; 2]);

impl Counts {
    /// Decides a specification in both ways.
    #[track_caller]
    fn check(&mut self, name: &str, text: &str) {
        let Ok(spec) = fast::resolved(text) else { return };
        for classic in [false, true] {
            let options = fast::options(classic, 50_000);
            let decided = verdict(&spec, options.semantics, &options.limits);
            let solved = match fast::solved(&spec, &options) {
                Ok(solved) => solved,
                Err(Failure::Wrong(_)) => continue,
                Err(Failure::Limit(_)) if decided.is_err() => continue,
                Err(failure) => panic!("{name}: {failure:?}"),
            };
            let decided = decided.unwrap_or_else(|error| panic!("{name}: {error:?}"));
            let figures = solved.figures();
            assert_eq!(decided.realizable, figures.realizable, "{name}, classic: {classic}\n{text}");
            let store = solved.explored.store.len();
            assert!(decided.explored <= decided.found && decided.found <= store, "{name}: {decided:?}");
            assert_eq!(decided.forced.is_some(), !decided.realizable, "{name}");
            if let Some(forced) = &decided.forced {
                assert!(is_won_by_environment(&solved, forced), "{name}, {classic}: {forced:?}\n{text}");
            }
            let count = &mut self.0[usize::from(!decided.realizable)];
            count.all += 1;
            count.early += usize::from(decided.explored < store);
        }
    }
}

/// Whether a play can be played in the whole game, never leaves what the environment wins, and ends as it should.
fn is_won_by_environment(solved: &Solved<'_>, forced: &Forced) -> bool {
    let game = &solved.explored.game;
    let follow = |mut state: u32, events: &[String]| -> Option<u32> {
        for event in events {
            if *event == SILENCE {
                return game.silent[state as usize].then_some(state);
            }
            let edge = game.edges_of(state).find(|&edge| solved.explored.text(edge) == event)?;
            state = game.target[edge];
            if solved.solution.wins(state) {
                return None;
            }
        }
        Some(state)
    };
    let Some(end) = follow(game.initial, &forced.play) else { return false };
    if forced.cycle.is_empty() {
        game.turn[end as usize] == Turn::Lost
    } else {
        follow(end, &forced.cycle) == Some(end)
    }
}

#[test]
fn on_the_corpus() {
    let mut counts = Counts::default();
    for entry in corpus::all() {
        counts.check(&entry.name, &entry.text);
    }
    let [realizable, unrealizable] = &counts.0;
    assert!(realizable.early >= 15 && unrealizable.early >= 8, "{counts:?}");
}

/// A quarter of both kinds at least is decided early.
#[track_caller]
fn on_random_specifications(seeds: std::ops::Range<u64>, options: RandomOptions) {
    let mut counts = Counts::default();
    for seed in seeds {
        counts.check(&format!("seed {seed}"), &specification(seed, options));
    }
    for Count { all, early } in &counts.0 {
        assert!(*early > 0 && early * 5 > *all, "{counts:?}");
    }
}

#[test]
fn on_random_specifications_of_the_full_language() {
    on_random_specifications(0..1_000, RandomOptions::default());
}

#[test]
fn on_random_specifications_of_the_core() {
    on_random_specifications(
        1_000..1_400,
        RandomOptions { features: Features::CORE, ..RandomOptions::default() },
    );
}

#[test]
fn on_large_random_specifications() {
    on_random_specifications(2_000..2_200, RandomOptions { size: 6, ..RandomOptions::default() });
}

/// Whoever meets a mistake has found one that is there.
#[test]
fn on_wrong_specifications() {
    let features = Features { errors: true, ..Features::FULL };
    let (mut met, mut passed) = (0, 0);
    for seed in 0..300 {
        let text = specification(seed, RandomOptions { features, ..RandomOptions::default() });
        let Ok(spec) = fast::resolved(&text) else { continue };
        let options = fast::options(false, 20_000);
        match verdict(&spec, options.semantics, &options.limits) {
            Err(ExploreError::Play(_, play)) => {
                met += 1;
                let Err(Failure::Wrong(found)) = fast::solved(&spec, &options) else {
                    panic!("seed {seed}: there is none after {play:?}\n{text}")
                };
                assert_eq!(found.len(), 1, "seed {seed}");
            }
            _ => passed += 1,
        }
    }
    assert!(met > 10 && passed > 100, "{met} {passed}");
}

#[test]
fn on_families() {
    let mut counts = Counts::default();
    for size in 1..=5 {
        counts.check(&format!("arbiter {size}"), &arbiter(size));
        counts.check(&format!("lift {size}"), &lift(size + 1));
    }
    counts.check("two lifts", &cabins(3, 2));
    for presses in 1..=2 {
        counts.check(&format!("line {presses}"), &line(presses));
        counts.check(&format!("slow line {presses}"), &slow_line(presses));
    }
    assert!(counts.0[0].early > 8, "{counts:?}");
}

/// The production line whose controller may take its time.
fn slow_line(presses: u32) -> String {
    line(presses).replace("urgent controller", "eventually controller")
}

/// Nobody promises that the lift comes down.
fn stuck_lift(floors: u32) -> String {
    lift(floors)
        .lines()
        .filter(|line| !line.contains("scenario GoesDown"))
        .map(|line| format!("{line}\n"))
        .collect()
}

/// With at most so many states.
#[track_caller]
fn decide(text: &str, states: usize) -> Verdict {
    let spec = fast::resolved(text).unwrap_or_else(|wrong| panic!("{wrong}"));
    let options = fast::options(false, states);
    verdict(&spec, options.semantics, &options.limits).expect("within the limit")
}

#[test]
fn a_system_that_may_wait_wins_at_once() {
    let found = decide(&slow_line(2), 8_000);
    assert!(found.realizable && !found.is_complete(), "{found:?}");
    let spec = fast::resolved(&slow_line(2)).expect("a specification");
    let all = explore(&spec, Options::default().semantics, &Limits::default()).expect("a game");
    assert!(found.explored * 4 < all.game.states(), "{found:?}");
}

#[test]
fn a_large_space_need_not_be_seen() {
    let text = stuck_lift(15);
    let found = decide(&text, 10_000);
    assert!(!found.realizable && found.explored < 3_000, "{found:?}");
    let spec = fast::resolved(&text).expect("a specification");
    let limits = fast::options(false, 10_000).limits;
    let all = explore(&spec, Options::default().semantics, &limits);
    assert!(matches!(all, Err(ExploreError::Limit(_))));
}

#[test]
fn limits_are_kept() {
    let spec = fast::resolved(&line(3)).expect("a specification");
    let semantics = Options::default().semantics;
    let reached = |limits: Limits| match verdict(&spec, semantics, &limits) {
        Err(ExploreError::Limit(limit)) => (limit.what, limit.states),
        other => panic!("{other:?}"),
    };
    let (what, states) = reached(Limits { states: 500, ..Limits::default() });
    assert!(what == "states" && (501..520).contains(&states), "{states}");
    let (what, states) = reached(Limits { memory: 200_000, ..Limits::default() });
    assert!(what == "memory" && states < 5_000, "{states}");
}

#[test]
fn nothing_depends_on_threads() {
    let spec = fast::resolved(&slow_line(1)).expect("a specification");
    let with = |threads| {
        verdict(&spec, Options::default().semantics, &Limits { threads, ..Limits::default() })
            .expect("decided")
    };
    assert_eq!(with(1), with(8));
}

/// A controller from as much of the game as it takes, and the states that were explored if these are not all.
fn early(spec: &Spec, options: &Options) -> (Result<Controller, Failure>, Option<usize>) {
    let timings = &mut Timings::default();
    match play_and_solve_early(spec, options, timings) {
        Ok((mut solved, searched)) => {
            let made = synthesize(&mut solved, options, timings);
            (made.map(|Verified { controller, .. }| controller), searched.map(|verdict| verdict.explored))
        }
        Err(failure) => (Err(failure), None),
    }
}

/// Checks that there is an early controller if there is one at all; it was verified like every other. Whether not everything was
/// explored for it.
#[track_caller]
fn has_early_controller(name: &str, text: &str, options: &Options) -> bool {
    let Ok(spec) = fast::resolved(text) else { return false };
    let (found, explored) = early(&spec, options);
    let mut solved = match fast::solved(&spec, options) {
        Ok(solved) => solved,
        Err(Failure::Wrong(_) | Failure::Limit(_)) => return false,
        Err(failure) => panic!("{name}: {failure:?}"),
    };
    let expected = synthesize(&mut solved, options, &mut Timings::default());
    match (&found, &expected) {
        (Ok(found), Ok(Verified { controller, .. })) => {
            let known = |controller: &Controller| -> Vec<String> {
                controller.events.iter().map(|event| event.text.clone()).collect()
            };
            let all = known(controller);
            assert!(known(found).iter().all(|event| all.contains(event)), "{name}\n{text}");
        }
        (Err(Failure::Unrealizable(found)), Err(Failure::Unrealizable(expected))) => {
            assert_eq!(found, expected, "{name}");
        }
        // Super steps without end; too many events in a scan.
        (Err(Failure::Wrong(_)), Err(Failure::Wrong(_)))
        | (Err(Failure::Limit(_)), Err(Failure::Limit(_))) => {}
        _ => panic!("{name}: {found:?}, but {expected:?}\n{text}"),
    }
    explored.is_some_and(|explored| explored < solved.explored.store.len())
}

#[test]
fn early_controllers_of_the_corpus() {
    for level in [Level::None, Level::Exact, Level::Assume, Level::Ordered] {
        let options = Options { level, ..fast::options(false, 20_000) };
        let all = corpus::all();
        let early =
            all.iter().filter(|entry| has_early_controller(&entry.name, &entry.text, &options)).count();
        assert!(early >= 8, "{early}");
    }
}

#[test]
fn early_controllers_of_random_specifications() {
    let mut count = 0;
    for seed in 3_000..3_300 {
        let text = specification(seed, RandomOptions::default());
        let options = fast::options(seed % 2 == 1, 3_000);
        count += usize::from(has_early_controller(&format!("seed {seed}"), &text, &options));
    }
    assert!(count > 30, "{count}");
}

/// Within a limit that is too low for all of it.
#[test]
fn an_early_controller_of_a_line_that_may_wait() {
    let spec = fast::resolved(&slow_line(2)).expect("a specification");
    let options = fast::options(false, 8_000);
    let (controller, explored) = early(&spec, &options);
    assert!(controller.is_ok() && explored.is_some_and(|states| states < 4_000), "{explored:?}");
    assert!(matches!(fast::solved(&spec, &options), Err(Failure::Limit(_))));
}
