//! State feedback needs states that inputs and outputs show.

use proptest::prelude::*;

use super::corpus;
use crate::diagnostic::{Code, Severity};
use crate::plant::{Condition, Plant, SignalId, SignalKind, read, unreadable};
use crate::syntax::FileId;
use crate::syntax::tests::unmark;

/// What cannot be read in the plant of these items is marked, each `~~~~ CODE message` under the place.
#[track_caller]
fn check(marked: &str) {
    let (text, marks) = unmark(&format!(
        "plant X {{ input A, B, C range L = V in 0..=9 range M = V in 5..=20 range H = V in 21..=30\n{marked}\n}}"
    ));
    let (plant, _) = read(&text, FileId(0)).expect("a plant");
    let found = unreadable(&plant);
    let shown: Vec<_> = found.iter().map(|d| (d.span, format!("{} {}", d.code as u16, d.message))).collect();
    assert_eq!(shown, marks, "{text}\n{found:#?}");
    assert!(found.iter().all(|d| d.severity == Severity::Error && d.help.is_some()), "{found:#?}");
}

/// The note of the only thing that is found.
#[track_caller]
fn note(first: &str, second: &str, expect: &str) {
    let text = format!(
        "plant X {{ input A, B, C range L = V in 0..=9 range M = V in 5..=20 uncontrollable e automaton Y {{ initial state S [{first}] {{ e -> T }} state T [{second}] }} }}"
    );
    let (plant, _) = read(&text, FileId(0)).expect("a plant");
    let found = unreadable(&plant);
    assert_eq!(found.len(), 1, "{found:#?}");
    assert_eq!(found[0].labels.len(), 1);
    assert_eq!(found[0].notes, [format!("both formulas hold where {expect}")]);
}

#[test]
fn formulas_are_due_where_there_is_a_choice() {
    check("automaton Y { initial state S }");
    check("automaton Y { initial state S } constraint automaton Z { initial state S state T }");
    check(
        "automaton Y { initial state S [A]\nstate T }\n      ~ 133 inputs and outputs do not show when `Y` is in `T`",
    );
}

#[test]
fn contradictions() {
    check("automaton Y {\ninitial state S [A && !A]\n              ~ 134 the formula of `S` never holds\n}");
    check(
        "automaton Y {\ninitial state S [A && (B || C) && !(A && B) && !C]\n              ~ 134 the formula of `S` never holds\n}",
    );
    check("automaton Y {\ninitial state S [L && H]\n              ~ 134 the formula of `S` never holds\n}");
    check("automaton Y { initial state S [A || !A] }");
    check("automaton Y { initial state S [L && M] }");
    check("automaton Y { initial state S [!L && !M && !H] }");
}

#[test]
fn overlaps() {
    check("automaton Y { initial state S [A]\nstate T [B]\n      ~ 135 `T` cannot be told from `S`\n}");
    check("automaton Y { initial state S [A] state T [!A] }");
    check("automaton Y { initial state S [A && B] state T [!A || !B] }");
    check("automaton Y { initial state S [L] state T [M && !L] state U [H] state V [!L && !M && !H] }");
    check("automaton Y { initial state S [L]\nstate T [M]\n      ~ 135 `T` cannot be told from `S`\n}");
    check(
        "automaton Y { initial state S [A]\nstate T [A || B]\n      ~ 135 `T` cannot be told from `S`\nstate U [B]\n      ~ 135 `U` cannot be told from `S`\n}",
    );
    // Two components may look as they like.
    check("automaton Y { initial state S [A] } automaton Z { initial state S [A] }");
}

#[test]
fn the_values_are_shown() {
    note("A", "!B", "`A && !B`");
    note("L", "M", "`V` is 5");
    note("L && !C", "!L || B", "`B && !C` and `V` is 0");
}

/// A conjunction of many literals takes no search, and no stack.
#[test]
fn long_formulas() {
    let inputs: Vec<String> = (0..20_000).map(|i| format!("X{i}")).collect();
    let text = format!(
        "plant X {{ input {} automaton Y {{ initial state S [{}] state T [!{}] }} }}",
        inputs.join(", "),
        inputs.join(" && "),
        inputs.join(" || !"),
    );
    let (plant, _) = read(&text, FileId(0)).expect("a plant");
    assert_eq!(unreadable(&plant), []);
}

#[test]
fn the_corpus() {
    let readable = |text: &str| unreadable(&read(text, FileId(0)).expect("a plant").0);
    for (path, text) in corpus() {
        let found = readable(&text);
        if text.contains('[') {
            assert_eq!(found, [], "{path}");
        } else {
            assert!(found.iter().all(|d| d.code == Code::NoFormula), "{path}");
        }
    }
}

fn formula() -> impl Strategy<Value = Condition<SignalId>> {
    let leaf = (0..6u32).prop_map(Condition::Atom);
    leaf.prop_recursive(4, 12, 3, |inner| {
        prop_oneof![
            inner.clone().prop_map(|inner| Condition::Not(Box::new(inner))),
            prop::collection::vec(inner.clone(), 2..4).prop_map(Condition::And),
            prop::collection::vec(inner, 2..4).prop_map(Condition::Or),
        ]
    })
}

/// Three inputs and three ranges.
fn two_states(formulas: [Condition<SignalId>; 2]) -> Plant {
    let text = "plant X { input A, B, C range L = V in 0..=9 range M = V in 5..=20 range H = V in 21..=30 automaton Y \
                { initial state S state T } }";
    let (mut plant, _) = read(text, FileId(0)).expect("a plant");
    for (state, formula) in plant.automata[0].states.iter_mut().zip(formulas) {
        state.formula = Some(formula);
    }
    plant
}

/// Whether all formulas hold for one of all values.
fn naive(plant: &Plant, formulas: &[&Condition<SignalId>]) -> bool {
    (0..8).any(|booleans| {
        (-1..=31).any(|value| {
            formulas.iter().all(|formula| {
                formula.eval(&|&signal| match plant.signals[signal as usize].kind {
                    SignalKind::Range { low, high, .. } => (low..=high).contains(&value),
                    _ => booleans >> signal & 1 == 1,
                })
            })
        })
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 500, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_search_finds_what_there_is(first in formula(), second in formula()) {
        let plant = two_states([first.clone(), second.clone()]);
        let codes: Vec<Code> = unreadable(&plant).iter().map(|d| d.code).collect();
        let mut expect = Vec::new();
        expect.extend((!naive(&plant, &[&first])).then_some(Code::NeverHolds));
        expect.extend((!naive(&plant, &[&second])).then_some(Code::NeverHolds));
        expect.extend(naive(&plant, &[&first, &second]).then_some(Code::Overlap));
        prop_assert_eq!(codes, expect);
    }
}
