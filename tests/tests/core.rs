//! Minimal cores are cores, and minimal: judged by the naive implementation, which has no part in finding them.

use sml_tests::random::{Options, specification};
use sml_tests::{corpus, fast, naive};
use std::collections::{BTreeMap, BTreeSet};
use synth_core::explain::explain;
use synth_core::explore::Limits;
use synth_core::pipeline::Failure;
use synth_core::syntax::ast::ScenarioKind;

/// Whether the specification is realizable when all guarantees except these are relaxed; none if there is no answer.
fn realizable(spec: &mut naive::Spec, in_force: &BTreeSet<&str>, classic: bool, most: usize) -> Option<bool> {
    let all = spec.scenarios.iter().enumerate();
    let others = all.filter(|(_, scenario)| {
        scenario.kind == ScenarioKind::Guarantee && !in_force.contains(scenario.name.as_str())
    });
    spec.relaxed = others.map(|(index, _)| index).collect();
    let semantics = if classic { naive::Semantics::Classic } else { naive::Semantics::Default };
    let graph = naive::explore(spec, semantics, most).ok()?;
    Some(naive::solve(&graph)[0])
}

/// The size of the core, if the specification is unrealizable; none if it has no verdict.
fn check(text: &str, classic: bool, most: usize) -> Result<Option<usize>, String> {
    let spec = fast::resolved(text)?;
    let solved = match fast::solved(&spec, &fast::options(classic, most)) {
        Ok(solved) => solved,
        Err(Failure::Limit(_) | Failure::Wrong(_)) => return Ok(None),
        Err(failure) => return Err(format!("{failure:?}")),
    };
    let Some(explanation) = explain(&solved, &Limits::default()) else { return Ok(None) };
    let mut naive = naive::Spec::new(&corpus::parse(text)?)?;
    let core: BTreeSet<&str> = explanation.scenarios.iter().map(String::as_str).collect();
    if core.len() != explanation.scenarios.len() || core.is_empty() {
        return Err(format!("no set: {:?}", explanation.scenarios));
    }
    // Relaxing can lead to more states.
    let most = 4 * most.max(2_500);
    if realizable(&mut naive, &core, classic, most) == Some(true) {
        return Err(format!("with {core:?} in force it is realizable"));
    }
    if explanation.is_minimal {
        for left_out in &core {
            let mut rest = core.clone();
            rest.remove(left_out);
            if realizable(&mut naive, &rest, classic, most) != Some(true) {
                return Err(format!("without {left_out} it is still unrealizable: {core:?}"));
            }
        }
    }
    Ok(explanation.is_minimal.then_some(core.len()))
}

#[test]
fn cores_of_the_corpus() {
    let mut sizes: BTreeMap<String, usize> = BTreeMap::new();
    for entry in corpus::all() {
        for classic in [false, true] {
            match check(&entry.text, classic, 3_000) {
                Ok(Some(size)) if !classic => _ = sizes.insert(entry.name.clone(), size),
                Ok(_) => {}
                Err(message) => panic!("{}, classic {classic}: {message}", entry.name),
            }
        }
    }
    for (name, size) in [
        ("answer_withheld", 1),
        ("conflict_in_the_long_run", 2),
        ("core_of_three", 3),
        ("endless_pair", 3),
        ("forbidden_constraint", 1),
        ("livelock", 1),
        ("unreal_clash", 2),
    ] {
        assert_eq!(sizes.get(name), Some(&size), "{name}: {sizes:?}");
    }
}

#[test]
fn cores_of_random_specifications() {
    let mut sizes: BTreeMap<usize, usize> = BTreeMap::new();
    for seed in 0..150 {
        let text = specification(seed, Options::default());
        for classic in [false, true] {
            match check(&text, classic, 150) {
                Ok(Some(size)) => *sizes.entry(size).or_default() += 1,
                Ok(None) => {}
                Err(message) => panic!("seed {seed}, classic {classic}: {message}\n{text}"),
            }
        }
    }
    assert!(sizes.get(&1) > Some(&20) && sizes.get(&2) > Some(&5), "{sizes:?}");
}
