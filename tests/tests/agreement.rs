//! The real implementation and the naive one, which share only the parser, find the same game with the same winner
//! in every state; and whatever is synthesised passes verification.

use sml_tests::naive::explore::Owner;
use sml_tests::naive::{self, Graph};
use sml_tests::random::{Features, Options, specification};
use sml_tests::{corpus, fast};
use synth_core::game::{Turn, YIELD};
use synth_core::pipeline::{Failure, Solved, Timings, synthesize};

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

/// Walks both graphs at once; they must be the same up to the numbers of the losing and the won state.
fn compare(naive: &Graph, winning: &[bool], solved: &Solved<'_>) -> Result<(), String> {
    let game = &solved.explored.game;
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
        if naive.nodes[node].open.len() != game.key_sets.members(game.open[state as usize]).len() {
            return fail("open keys differ".to_owned());
        }
        if winning[node] != solved.solution.wins(state) {
            return fail(format!("naive winner {}, real {}", winning[node], solved.solution.wins(state)));
        }
        let edges = game.edges_of(state);
        let mine = naive.edges[first[node]..].iter().take_while(|edge| edge.from == node);
        let mine: Vec<_> = mine.collect();
        if mine.len() != edges.len() {
            return fail(format!("naive {} moves, real {}", mine.len(), edges.len()));
        }
        for (edge, naive_edge) in edges.zip(mine) {
            let label = game.label[edge];
            let text = if label == YIELD {
                "yield".to_owned()
            } else {
                solved.explored.playout.event(label).text.clone()
            };
            let naive_text = naive_edge.event.as_ref().map_or("yield".to_owned(), ToString::to_string);
            if text != naive_text {
                return fail(format!("naive move `{naive_text}`, real `{text}`"));
            }
            let discharged = game.key_sets.members(game.discharged[edge]).len();
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
            compare(&graph, &winning, &solved)?;
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
