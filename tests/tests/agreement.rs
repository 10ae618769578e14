//! The real implementation and the naive one, which share only the parser, find the same game with the same winner
//! in every state; and whatever is synthesised passes verification.

use sml_tests::naive;
use sml_tests::random::{Features, Options, specification};
use sml_tests::{corpus, fast, same};
use synth_core::pipeline::{Failure, Timings, synthesize};

/// What became of a specification.
#[derive(Default, Debug)]
struct Tally {
    realizable: usize,
    unrealizable: usize,
    /// The system wins, but only by a super step that never ends.
    endless: usize,
    mistakes: usize,
    too_large: usize,
}

/// Compares both implementations on one text.
fn agree(text: &str, classic: bool, most: usize, tally: &mut Tally) -> Result<(), String> {
    let file = corpus::parse(text)?;
    let naive_spec = naive::Spec::new(&file)?;
    let semantics = if classic { naive::Semantics::Classic } else { naive::Semantics::Default };
    let naive = naive::explore(&naive_spec, semantics, most);
    let spec = fast::resolved(text)?;
    let options = fast::options(classic, most);
    let mut solved = match (naive, fast::solved(&spec, &options)) {
        (Err(naive::ExploreError::TooManyStates), Err(Failure::Limit(_))) => {
            tally.too_large += 1;
            return Ok(());
        }
        // Which of several mistakes is met first is left open.
        (Err(_), Err(Failure::Wrong(_))) => {
            tally.mistakes += 1;
            return Ok(());
        }
        (Ok(graph), Ok(solved)) => {
            let winning = naive::solve(&graph);
            same::game(&graph, &winning, &solved.explored.playout, &solved.explored.game, &solved.solution)?;
            let (naive, real) = (graph.figures(&winning), solved.figures());
            if format!("{naive:?}") != format!("{real:?}") {
                return Err(format!("naive {naive:?}, real {real:?}"));
            }
            solved
        }
        (naive, real) => {
            return Err(format!("naive {:?}, real {:?}", naive.map(|_| "fine"), real.map(|_| "fine")));
        }
    };
    match synthesize(&mut solved, &options, &mut Timings::default()) {
        Ok(_) => tally.realizable += 1,
        Err(Failure::Unrealizable(_)) if !solved.solution.wins(0) => tally.unrealizable += 1,
        Err(failure) if fast::is_endless(&failure) && solved.solution.wins(0) => tally.endless += 1,
        Err(failure) => return Err(format!("synthesis: {failure:?}")),
    }
    Ok(())
}

#[track_caller]
fn check(seeds: std::ops::Range<u64>, options: Options) -> Tally {
    let mut tally = Tally::default();
    for seed in seeds {
        let text = specification(seed, options);
        for classic in [false, true] {
            if let Err(difference) = agree(&text, classic, 300, &mut tally) {
                panic!("seed {seed}, classic {classic}: {difference}\n{text}");
            }
        }
    }
    tally
}

/// How many seeds; `SML_SEEDS` asks for a longer run.
fn seeds(default: u64) -> std::ops::Range<u64> {
    0..std::env::var("SML_SEEDS").ok().and_then(|n| n.parse().ok()).unwrap_or(default)
}

#[test]
fn on_the_corpus() {
    let mut tally = Tally::default();
    for entry in corpus::all() {
        for classic in [false, true] {
            if let Err(difference) = agree(&entry.text, classic, 20_000, &mut tally) {
                panic!("{}, classic {classic}: {difference}", entry.name);
            }
        }
    }
    assert!(tally.realizable > 20 && tally.unrealizable > 5, "{tally:?}");
}

#[test]
fn on_the_core_language() {
    let tally = check(seeds(150), Options { features: Features::CORE, ..Options::default() });
    assert!(tally.realizable > 50 && tally.unrealizable > 30, "{tally:?}");
}

#[test]
fn on_the_full_language() {
    let tally = check(seeds(150), Options::default());
    assert!(tally.realizable > 50 && tally.unrealizable > 30, "{tally:?}");
}

#[test]
fn on_specifications_with_mistakes() {
    let features = Features { errors: true, ..Features::FULL };
    let tally = check(seeds(100), Options { features, ..Options::default() });
    assert!(tally.mistakes > 5, "{tally:?}");
}
