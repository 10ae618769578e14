//! Suggested assumptions, pasted into the text of the specification, make it realizable, and not because the environment
//! could not do as it is said to. The naive implementation says so, too.

use sml_tests::random::{Options, specification};
use sml_tests::{corpus, fast, naive};
use std::collections::BTreeSet;
use synth_core::explain::{Suggestion, explain};
use synth_core::explore::Limits;
use synth_core::pipeline::{Failure, Timings, synthesize};

/// The text with `scenario` as the last of its collaboration.
fn pasted(text: &str, collaboration: &str, scenario: &str) -> String {
    let start = text.find(&format!("collaboration {collaboration} {{")).expect("the collaboration");
    let open = start + text[start..].find('{').expect("a brace");
    let mut depth = 0;
    for (at, letter) in text[open..].char_indices() {
        match letter {
            '{' => depth += 1,
            '}' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return format!("{}{scenario}\n{}", &text[..open + at], &text[open + at..]);
        }
    }
    panic!("a collaboration without an end: {text}");
}

/// Whether the naive implementation finds the text realizable; none if there are too many states.
fn naively(text: &str, classic: bool) -> Option<bool> {
    let spec = naive::Spec::new(&corpus::parse(text).expect("a syntax tree")).expect("tables");
    let semantics = if classic { naive::Semantics::Classic } else { naive::Semantics::Default };
    let graph = naive::explore(&spec, semantics, 400).ok()?;
    Some(naive::solve(&graph)[0])
}

fn try_out(text: &str, suggestion: &Suggestion, classic: bool) -> Result<(), String> {
    let Suggestion { collaboration, text: scenario } = suggestion;
    let with = pasted(text, collaboration, scenario);
    let spec = fast::resolved(&with)?;
    let options = fast::options(classic, 20_000);
    let mut solved = fast::solved(&spec, &options).map_err(|failure| format!("{failure:?}"))?;
    if !solved.solution.wins(solved.explored.game.initial) || naively(&with, classic) == Some(false) {
        return Err(format!("still unrealizable:\n{with}"));
    }
    match synthesize(&mut solved, &options, &mut Timings::default()) {
        Ok(_) => {}
        Err(failure) if fast::is_endless(&failure) => {}
        Err(failure) => return Err(format!("{failure:?}\n{with}")),
    }
    // If the system could keep the environment from meeting its assumptions, it could meet what cannot be met.
    let impossible = "guarantee scenario NobodyCanMeetThis { wait eventually [false] }";
    let with_impossible = pasted(&with, collaboration, impossible);
    if naively(&with_impossible, classic) == Some(true) {
        return Err(format!("realizable whatever is wanted:\n{with}"));
    }
    Ok(())
}

/// How many assumptions are suggested, all of which work.
fn check(text: &str, classic: bool, most: usize) -> Result<usize, String> {
    let spec = fast::resolved(text)?;
    let solved = match fast::solved(&spec, &fast::options(classic, most)) {
        Ok(solved) => solved,
        Err(Failure::Limit(_) | Failure::Wrong(_)) => return Ok(0),
        Err(failure) => return Err(format!("{failure:?}")),
    };
    let Some(explanation) = explain(&solved, &Limits::default()) else { return Ok(0) };
    for suggestion in &explanation.suggestions {
        try_out(text, suggestion, classic)?;
    }
    Ok(explanation.suggestions.len())
}

#[test]
fn suggestions_for_the_corpus_work() {
    let mut helped = BTreeSet::new();
    for entry in corpus::all() {
        for classic in [false, true] {
            match check(&entry.text, classic, 20_000) {
                Ok(0) => {}
                Ok(_) => _ = helped.insert((entry.name.clone(), classic)),
                Err(message) => panic!("{}, classic {classic}: {message}", entry.name),
            }
        }
    }
    for name in [
        "answer_withheld",
        "breaks_assumption",
        "conflict_in_the_long_run",
        "core_of_three",
        "forbidden_constraint",
        "pc_no_a1_safe_strict",
        "unreal_clash",
        "wait_strict",
    ] {
        assert!(helped.contains(&(name.to_owned(), false)), "{name}: {helped:?}");
    }
}

#[test]
fn suggestions_for_random_specifications_work() {
    let mut helped = 0;
    for seed in 0..150 {
        let text = specification(seed, Options::default());
        for classic in [false, true] {
            match check(&text, classic, 300) {
                Ok(suggestions) => helped += usize::from(suggestions > 0),
                Err(message) => panic!("seed {seed}, classic {classic}: {message}"),
            }
        }
    }
    assert!(helped > 10, "{helped}");
}
