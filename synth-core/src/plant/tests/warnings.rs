//! What is odd, at its place; nothing else is.

use super::{found, world};
use crate::diagnostic::Severity;
use crate::syntax::tests::unmark;

/// The warnings about the text are exactly its marks, each `~~~~ CODE message` under the place.
#[track_caller]
fn check_whole(marked: &str) {
    let (text, marks) = unmark(marked);
    let found = found(&text);
    let shown: Vec<_> = found.iter().map(|d| (d.span, format!("{} {}", d.code as u16, d.message))).collect();
    assert_eq!(shown, marks, "{text}\n{found:#?}");
    assert!(found.iter().all(|d| d.severity == Severity::Warning && d.help.is_some()), "{found:#?}");
}

/// As [`check_whole`] for items behind those of the world.
#[track_caller]
fn check(marked: &str) {
    check_whole(&world(&format!("\n{marked}\n")));
}

#[test]
fn events() {
    check("uncontrollable a\n               ~ 97 no automaton names the event `a`");
    check(
        "controllable a\n             ~ 130 the controllable event `a` has no commands\nautomaton A { initial state B { a -> B } }",
    );
    check_whole("plant X { controllable a automaton A { initial state B { a -> B } } }");
}

#[test]
fn signals() {
    check("input A\n      ~ 97 nothing uses the input `A`");
    check("range A = B in 0..=1\n      ~ 97 nothing uses the range `A`");
    check(
        "output A\n       ~ 132 no event sets or resets the output `A`\nautomaton A { initial state B [A] }",
    );
    check(
        "memory A\n       ~ 132 no event sets or resets the memory bit `A`\nautomaton A { initial state B [A] }",
    );
    check(
        "output A\ncontrollable a { set A set A }\n                       ~~~~~ 97 `A` is set twice by one event\nautomaton A { initial state B { a -> B } }",
    );
}

#[test]
fn states() {
    check(
        "automaton A { initial state B state C { open -> B } }\n                                    ~ 131 no edges lead to the state `C`",
    );
    check(
        "constraint automaton A { initial state B { open -> B } state C }\n                                                             ~ 131 no edges lead to the state `C`",
    );
}

#[test]
fn names_that_differ_by_case_only() {
    check(
        "uncontrollable Open\n               ~~~~ 127 `Open` and `open` differ by case only\nautomaton A { initial state B { Open -> B } }",
    );
    check("automaton DOOR { initial state B }\n          ~~~~ 127 `DOOR` and `Door` differ by case only");
    check("constraint EYE: never Door.Open\n           ~~~ 127 `EYE` and `Eye` differ by case only");
    check(
        "automaton A { initial state B { open -> b } state b }\n                                                  ~ 127 `b` and `B` differ by case only",
    );
}
