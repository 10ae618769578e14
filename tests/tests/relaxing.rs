//! Relaxed scenarios: the real play-out, which is used for one exploration after the other, and the naive one find the
//! same games; and relaxing has the direction that it should have.

use sml_tests::random::{Options, specification};
use sml_tests::{corpus, fast, naive, same};
use std::collections::BTreeSet;
use synth_core::explore::{ExploreError, Limits, explore_with};
use synth_core::game::solve;
use synth_core::model::{Kind, Spec};
use synth_core::playout::{Config, Moves, Playout, Semantics, Step};

type Set = BTreeSet<usize>;

/// A small generator, so that each seed gives the same subsets everywhere.
struct Dice(u64);

impl Dice {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % n
    }

    fn shuffled(&mut self, mut all: Vec<usize>) -> Vec<usize> {
        for last in (1..all.len()).rev() {
            all.swap(last, self.below(last + 1));
        }
        all
    }
}

fn of_kind(spec: &Spec, kind: Kind) -> Vec<usize> {
    (0..spec.scenarios.len()).filter(|&scenario| spec.scenarios[scenario].kind == kind).collect()
}

/// One specification as both implementations have it.
struct Both<'s> {
    naive: naive::Spec,
    playout: Playout<'s>,
    classic: bool,
    most: usize,
}

impl<'s> Both<'s> {
    fn new(text: &str, spec: &'s Spec, classic: bool, most: usize) -> Option<Self> {
        let naive = naive::Spec::new(&corpus::parse(text).expect("a syntax tree")).expect("tables");
        let playout = Playout::new(spec, Semantics { classic }).ok()?;
        Some(Both { naive, playout, classic, most })
    }

    /// Who wins, if both say so; none if the play-out meets a mistake or there are too many states.
    fn agree(&mut self, relaxed: &Set) -> Result<Option<bool>, String> {
        self.naive.relaxed.clone_from(relaxed);
        self.playout.relax(relaxed.iter().copied());
        let semantics = if self.classic { naive::Semantics::Classic } else { naive::Semantics::Default };
        let limits = Limits { states: self.most, ..Limits::default() };
        let naive = naive::explore(&self.naive, semantics, self.most);
        match (naive, explore_with(&mut self.playout, &limits)) {
            (Err(naive::ExploreError::TooManyStates), Err(ExploreError::Limit(_)))
            | (Err(_), Err(ExploreError::Play(..))) => Ok(None),
            // The naive one counts the losing and the won state against its limit.
            (Err(naive::ExploreError::TooManyStates), Ok((_, game))) if game.states() > self.most => Ok(None),
            (Ok(graph), Ok((_, game))) => {
                let solution = solve(&game);
                same::game(&graph, &naive::solve(&graph), &self.playout, &game, &solution)?;
                Ok(Some(solution.wins(game.initial)))
            }
            (naive, real) => {
                Err(format!("naive {:?}, real {:?}", naive.map(|_| "fine"), real.map(|_| "fine")))
            }
        }
    }
}

#[derive(Default, Debug)]
struct Tally {
    games: usize,
    /// Relaxing has made a difference.
    turned: usize,
}

/// Compares the games of some sets of relaxed scenarios: none, each alone, chains of either kind.
fn agree(text: &str, classic: bool, most: usize, dice: &mut Dice, tally: &mut Tally) -> Result<(), String> {
    let spec = fast::resolved(text)?;
    let Some(mut both) = Both::new(text, &spec, classic, most) else { return Ok(()) };
    let mut sets: Vec<Set> = vec![Set::new()];
    for kind in [Kind::Guarantee, Kind::Assumption] {
        let mut set = Set::new();
        for scenario in dice.shuffled(of_kind(&spec, kind)) {
            set.insert(scenario);
            sets.push(Set::from([scenario]));
            sets.push(set.clone());
        }
    }
    sets.push((0..spec.scenarios.len()).filter(|_| dice.below(2) == 0).collect());
    // At last once more nothing: nothing that was remembered may spoil it.
    sets.push(Set::new());
    let mut verdicts = Vec::new();
    for set in &sets {
        let verdict = both.agree(set).map_err(|difference| format!("relaxed {set:?}: {difference}"))?;
        verdicts.push(verdict);
        tally.games += usize::from(verdict.is_some());
    }
    tally.turned += usize::from(verdicts.contains(&Some(true)) && verdicts.contains(&Some(false)));
    Ok(())
}

#[test]
fn both_implementations_agree_on_the_corpus() {
    let mut tally = Tally::default();
    for entry in corpus::all() {
        for classic in [false, true] {
            if let Err(difference) = agree(&entry.text, classic, 300, &mut Dice(1), &mut tally) {
                panic!("{}, classic {classic}: {difference}", entry.name);
            }
        }
    }
    assert!(tally.games > 200 && tally.turned > 5, "{tally:?}");
}

#[test]
fn both_implementations_agree_on_random_specifications() {
    let mut tally = Tally::default();
    for seed in 0..100 {
        let text = specification(seed, Options::default());
        for classic in [false, true] {
            if let Err(difference) = agree(&text, classic, 150, &mut Dice(seed), &mut tally) {
                panic!("seed {seed}, classic {classic}: {difference}\n{text}");
            }
        }
    }
    assert!(tally.games > 1000 && tally.turned > 20, "{tally:?}");
}

/// Who wins with these scenarios relaxed; none if the play-out meets a mistake or there are too many states.
fn wins(playout: &mut Playout<'_>, relaxed: &Set) -> Option<bool> {
    playout.relax(relaxed.iter().copied());
    let (_, game) = explore_with(playout, &Limits { states: 1_000, ..Limits::default() }).ok()?;
    Some(solve(&game).wins(game.initial))
}

/// Whether some event that the system can send is executable only because an assumption is relaxed.
fn system_breaks_relaxed(playout: &mut Playout<'_>) -> bool {
    let limits = Limits { states: 1_000, ..Limits::default() };
    let Ok((store, _)) = explore_with(playout, &limits) else { return false };
    let (mut config, mut moves, mut step) = (Config::default(), Moves::default(), Step::default());
    (0..store.len() as u32).any(|state| {
        store.load(playout, state, &mut config);
        playout.moves(&config, &mut moves).is_ok()
            && moves.turn.is_system()
            && moves.moves.iter().filter_map(|one| one.event).any(|event| {
                playout.step(&config, event, &mut step);
                !step.excused.is_empty()
            })
    })
}

#[test]
fn relaxing_a_guarantee_does_not_make_it_unrealizable() {
    let mut turned = 0;
    for seed in 0..300 {
        let text = specification(seed, Options::default());
        let spec = fast::resolved(&text).expect("a specification");
        for classic in [false, true] {
            let Ok(mut playout) = Playout::new(&spec, Semantics { classic }) else { continue };
            let mut relaxed = Set::new();
            let mut before = wins(&mut playout, &relaxed);
            for scenario in Dice(seed).shuffled(of_kind(&spec, Kind::Guarantee)) {
                relaxed.insert(scenario);
                let now = wins(&mut playout, &relaxed);
                assert!(
                    before != Some(true) || now != Some(false),
                    "seed {seed}, classic {classic}, relaxed {relaxed:?}\n{text}"
                );
                turned += usize::from(before == Some(false) && now == Some(true));
                before = now.or(before);
            }
        }
    }
    assert!(turned > 100, "{turned}");
}

/// With an exception that lies in the meaning: where the assumption keeps the *system* from sending an event, relaxing it
/// gives the system a move.
#[test]
fn relaxing_an_assumption_does_not_make_it_realizable() {
    let (mut turned, mut exceptions) = (0, 0);
    for seed in 0..300 {
        let text = specification(seed, Options::default());
        let spec = fast::resolved(&text).expect("a specification");
        let Ok(mut playout) = Playout::new(&spec, Semantics::default()) else { continue };
        let mut relaxed = Set::new();
        let mut before = wins(&mut playout, &relaxed);
        for scenario in Dice(seed).shuffled(of_kind(&spec, Kind::Assumption)) {
            relaxed.insert(scenario);
            let now = wins(&mut playout, &relaxed);
            if before == Some(false) && now == Some(true) {
                assert!(system_breaks_relaxed(&mut playout), "seed {seed}, relaxed {relaxed:?}\n{text}");
                exceptions += 1;
            }
            turned += usize::from(before == Some(true) && now == Some(false));
            before = now.or(before);
        }
    }
    assert!(turned > 0 && exceptions > 0, "{turned}, {exceptions}");
}
