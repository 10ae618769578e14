//! What the author meant, said as an edit.

use super::{found, world};
use crate::syntax::tests::unmark;

/// The marks of the items are their diagnostics, each `~~~~ help` under the place.
#[track_caller]
fn check(marked: &str) {
    let (text, marks) = unmark(&world(&format!("\n{marked}\n")));
    let errors = found(&text);
    let shown: Vec<_> = errors.iter().map(|d| (d.span, d.help.clone().unwrap_or_default())).collect();
    assert_eq!(shown, marks, "{text}\n{errors:#?}");
}

#[test]
fn misspelt_words() {
    check("inputs A\n~~~~~~ write `input`");
    check("controlable a\n~~~~~~~~~~~ write `controllable`");
    check("event a\n~~~~~ write `controllable` or `uncontrollable`");
    check("controllable event a\n             ~~~~~ remove it");
    check("state A\n~~~~~ put states into `automaton Name { … }`");
    check("automaton A { intial state B }\n              ~~~~~~ write `initial`");
    check(
        "automaton A { marked initial state B }\n                     ~~~~~~~ write `initial marked state`",
    );
    check("controllable a { sett Motor }\n                 ~~~~ write `set`");
    check(
        "controllable a { set Motor, Lamp }\n                            ~~~~ write `set Lamp` or `reset Lamp`",
    );
    check("constraint A: open when Door.Open\n                   ~~~~ write `only when` or `not when`");
    check("constraint A: open onyl when Door.Open\n                   ~~~~ write `only`");
}

#[test]
fn misspelt_separators() {
    check("input A B\n        ~ write `,` before `B`");
    check("input A otput B\n        ~~~~~ write `output`");
    check(
        "automaton A { initial state B { open => B } }\n                                     ~~ write `->` instead of `=>`",
    );
    check(
        "automaton A { initial state B { open.B } }\n                                    ~ write `->` instead of `.`",
    );
    check(
        "automaton A { initial state B (Closed) }\n                              ~ write `[ … ]` instead of `( … )`",
    );
    check("range A = B in 0..1\n                ~~ write `..=`: both ends of a range belong to it");
    check("range A = Heat in 3..=-3\n                  ~~~~~~ write `-3..=3`");
}

#[test]
fn operators() {
    check(
        "automaton A { initial state B [Closed and Opened] }\n                                      ~~~ write `&&` instead",
    );
    check(
        "automaton A { initial state B [Closed = 1] }\n                                      ~ write the name alone, or `!` before it: it is a Boolean",
    );
    check(
        "automaton A { initial state B [Heat > 1] }\n                                    ~ declare a `range` of the analogue input, and write its name",
    );
    check(
        "automaton A { initial state B [true] }\n                               ~~~~ leave it out: a condition is about names alone",
    );
}

#[test]
fn unknown_names() {
    check(
        "automaton A { initial state B [Closde] }\n                               ~~~~~~ write `Closed`, which is declared",
    );
    check(
        "automaton A { initial state B [Xyz] }\n                               ~~~ declare `Xyz`, or write a name that is declared",
    );
    check(
        "automaton A { initial state B [open] }\n                               ~~~~ write a name of one: `open` is an event",
    );
    check(
        "automaton A { initial state B { open -> Sees } }\n                                        ~~~~ write a state of `A`: an edge stays in its automaton",
    );
    check(
        "constraint A: open only when Rest.Open\n                             ~~~~ write the name of an automaton: `Rest` is a condition",
    );
}

#[test]
fn bare_states() {
    check("constraint A: never Sees\n                    ~~~~ write `Eye.Sees`");
    check(
        "automaton A { initial state Sees }\nconstraint B: never Sees\n                    ~~~~ write `Eye.Sees` or `A.Sees`",
    );
    check("constraint A: never Door\n                    ~~~~ write which of its states: `Door.State`");
    check(
        "constraint A: never Closed\n                    ~~~~~~ write the state in which it is so: `Automaton.State`",
    );
    check("constraint A: never Foo\n                    ~~~ write `Automaton.State`");
}

#[test]
fn initial_states() {
    check("automaton A { state B state C }\n          ~ write `initial state B`, or another one");
}
