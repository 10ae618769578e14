//! What is read: trees, comments, names; and that it is read again as it is printed.

use proptest::prelude::*;

use super::{corpus, found, tree, world};
use crate::plant::ast::{
    Automaton, Command, Constraint, Edge, Event, File, Item, Range, Rule, Signals, State,
};
use crate::plant::{Condition, SignalKind, parse_tokens, print, read};
use crate::syntax::ast::{Name, Path};
use crate::syntax::{FileId, Span};

/// The tree without its places.
pub(super) fn shape(file: &File) -> String {
    let text = format!("{file:?}");
    let mut pieces = text.split("Span {");
    let mut shape = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        shape.push_str(piece.split_once("} }").expect("the end of a place").1);
    }
    shape
}

#[test]
fn the_corpus_round_trips() {
    for (path, text) in corpus() {
        let first = tree(&text);
        let printed = print(&first);
        assert_eq!(shape(&tree(&printed)), shape(&first), "{path}");
        assert_eq!(print(&tree(&printed)), printed, "{path}");
    }
}

#[test]
fn tokens_mean_the_same_as_text() {
    for (path, text) in corpus() {
        let (from_tokens, errors) = parse_tokens(text.parse().expect("tokens"), FileId(0));
        assert_eq!(errors, [], "{path}");
        assert_eq!(from_tokens, Some(tree(&text)), "{path}");
    }
}

/// Words that are told from names by their place.
#[test]
fn words_are_names() {
    let text = "plant plant {
        output set, reset, never, initial
        controllable reset { reset reset set set }
        controllable never { set never, set initial }
        controllable only { reset set }
        uncontrollable state
        uncontrollable event
        automaton state {
            initial marked state initial [set && !never] { reset -> marked, state -> state, event -> state }
            state marked [not] { never -> state only -> state }
            state state [when || initial]
        }
        input not, when
        constraint never: never only when state.state
        constraint only: only only when state.marked
        constraint not: never state.state && !state.marked
        constraint in: reset not when state.initial
    }";
    assert_eq!(found(text), []);
    assert_eq!(shape(&tree(&print(&tree(text)))), shape(&tree(text)));
}

#[test]
fn separators_are_optional() {
    let text = "plant X { input A, B, output C; controllable a { set C; }; automaton D { initial state E [A && B] { a -> E; }; };
        constraint F: a only when D.E; };";
    assert_eq!(found(text), []);
    let plain = "plant X { input A, B output C controllable a { set C } automaton D { initial state E [A && B] { a -> E } }
        constraint F: a only when D.E }";
    assert_eq!(shape(&tree(text)), shape(&tree(plain)));
}

#[test]
fn comments_are_carried() {
    let text = "//! Not part of it.
/// A plant.
///
/// Its second paragraph.
plant X {
    /// Both.
    input
        /// One.
        A,
        /// Two.
        B
    /// A range.
    range R = V in 0..=1
    // Not this.
    /* Nor this. */
    /// An event.
    uncontrollable e { /// nothing
    }
    /// An automaton.
    automaton C {
        /// A state.
        initial state S [A && /// nowhere
            B && /// nor here
            (R)] { /// no edge
            e -> S }
        /// The end is no state.
    }
    /// A constraint.
    constraint D: /// nowhere
        never /// nowhere
        C.S
    /// Another.
    constraint automaton E { initial state S }
}";
    let (plant, _) = read(text, FileId(0)).expect("a plant");
    let lines = |doc: &[String]| doc.join("|");
    assert_eq!(lines(&plant.doc), "A plant.||Its second paragraph.");
    let signals: Vec<String> = plant.signals.iter().map(|signal| lines(&signal.doc)).collect();
    assert_eq!(signals, ["Both.|One.", "Both.|Two.", "A range."]);
    assert_eq!(lines(&plant.events[0].doc), "An event.");
    assert_eq!(lines(&plant.automata[0].doc), "An automaton.");
    assert_eq!(lines(&plant.automata[0].states[0].doc), "A state.");
    assert_eq!(lines(&plant.automata[1].doc), "Another.");
    assert_eq!(lines(&plant.constraints[0].doc), "A constraint.");
}

/// Components stand before constraint automata; a comment above a trailing comma belongs to the next item.
#[test]
fn order() {
    let text = "plant X { constraint automaton A { initial state S } automaton B { state T initial state U { e -> T } }
        input C,
        /// An event.
        uncontrollable e
        automaton D { initial state S [C] } constraint automaton E { initial state S { e -> S } } }";
    let (plant, _) = read(text, FileId(0)).expect("a plant");
    let names: Vec<&str> = plant.automata.iter().map(|automaton| automaton.name.as_str()).collect();
    assert_eq!((names.as_slice(), plant.components), (["B", "D", "A", "E"].as_slice(), 2));
    assert_eq!((plant.automata[0].initial, plant.automata[0].alphabet.as_slice()), (1, [0].as_slice()));
    assert!(plant.automata[2].alphabet.is_empty());
    assert_eq!(plant.events[0].doc, ["An event."]);
}

#[test]
fn analogue_inputs_are_no_signals() {
    let (plant, _) = read(&world("range More = Other in 0..=5 input Heat"), FileId(0)).expect("a plant");
    assert_eq!(plant.analogues, ["Heat", "Other"]);
    assert!(plant.signals.iter().all(|signal| signal.name != "Heat" && signal.name != "Other"));
    let last = plant.signals.last().expect("a signal");
    assert_eq!(last.kind, SignalKind::Range { analogue: 1, low: 0, high: 5 });
}

#[test]
fn marked_states() {
    let (plant, _) = read(
        "plant X { uncontrollable e automaton A { initial state B { e -> C } marked state C } automaton D { initial state E } }",
        FileId(0),
    )
    .expect("a plant");
    let marked: Vec<bool> = plant.automata.iter().flat_map(|a| &a.states).map(|state| state.marked).collect();
    assert_eq!(marked, [false, true, true]);
}

fn name() -> impl Strategy<Value = Name> {
    let words =
        ["a", "B2", "state", "set", "reset", "never", "only", "not", "initial", "when", "plant", "x_y"];
    prop::sample::select(words.to_vec())
        .prop_map(|text| Name { text: text.to_owned(), span: Span::default() })
}

fn doc() -> impl Strategy<Value = Vec<String>> {
    prop::collection::vec(prop::sample::select(vec!["", "a line", "  indented", "*/ \"", "`ä`"]), 0..3)
        .prop_map(|lines| lines.into_iter().map(str::to_owned).collect())
}

fn condition(length: usize) -> impl Strategy<Value = Condition<Path>> {
    let path = prop::collection::vec(name(), length).prop_map(|names| Path { names, span: Span::default() });
    path.prop_map(Condition::Atom).prop_recursive(4, 16, 3, |inner| {
        prop_oneof![
            inner.clone().prop_map(|inner| Condition::Not(Box::new(inner))),
            prop::collection::vec(inner.clone(), 2..4).prop_map(Condition::And),
            prop::collection::vec(inner, 2..4).prop_map(Condition::Or),
        ]
    })
}

fn automaton() -> impl Strategy<Value = Automaton> {
    let edge = (name(), name()).prop_map(|(event, target)| Edge { event, target });
    let edges = prop::collection::vec(edge, 0..3);
    let initial = any::<bool>().prop_map(|initial| initial.then(Span::default));
    let state = (doc(), initial, any::<bool>(), name(), prop::option::of(condition(1)), edges).prop_map(
        |(doc, initial, marked, name, formula, edges)| State { doc, initial, marked, name, formula, edges },
    );
    (doc(), name(), prop::collection::vec(state, 0..4)).prop_map(|(doc, name, states)| Automaton {
        doc,
        name,
        states,
    })
}

fn item() -> impl Strategy<Value = Item> {
    let kinds = vec![SignalKind::Input, SignalKind::Output, SignalKind::Memory];
    let signals = (doc(), prop::sample::select(kinds), prop::collection::vec((doc(), name()), 1..4))
        .prop_map(|(doc, kind, names)| Item::Signals(Signals { doc, kind, names }));
    let range =
        (doc(), name(), name(), any::<i64>(), any::<i64>()).prop_map(|(doc, name, analogue, low, high)| {
            Item::Range(Range { doc, name, analogue, low, high, span: Span::default() })
        });
    let command =
        (any::<bool>(), name()).prop_map(|(set, signal)| Command { set, signal, span: Span::default() });
    let event = (doc(), any::<bool>(), name(), prop::collection::vec(command, 0..3)).prop_map(
        |(doc, controllable, name, commands)| Item::Event(Event { doc, controllable, name, commands }),
    );
    let rule = prop_oneof![
        (name(), condition(2)).prop_map(|(event, when)| Rule::Only(event, when)),
        (name(), condition(2)).prop_map(|(event, when)| Rule::Not(event, when)),
        condition(2).prop_map(Rule::Never),
    ];
    prop_oneof![
        signals,
        range,
        event,
        automaton().prop_map(Item::Component),
        automaton().prop_map(Item::ConstraintAutomaton),
        (doc(), name(), rule).prop_map(|(doc, name, rule)| Item::Constraint(Constraint { doc, name, rule })),
    ]
}

fn file() -> impl Strategy<Value = File> {
    (doc(), name(), prop::collection::vec(item(), 0..8)).prop_map(|(doc, name, items)| File {
        doc,
        name,
        items,
        declares_all: true,
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 500, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_trees_round_trip(file in file()) {
        let printed = print(&file);
        let again = tree(&printed);
        prop_assert_eq!(shape(&again), shape(&file), "{}", printed);
        // Whatever it means, something is said about it, or it is a plant.
        let _ = found(&printed);
    }
}
