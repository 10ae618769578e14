//! Every kind of mistake, at its place.

use super::{found, parse_text, world};
use crate::diagnostic::{Code, Severity};
use crate::plant::parse_tokens;
use crate::syntax::FileId;
use crate::syntax::tests::unmark;

/// The errors of the text are exactly its marks, each `~~~~ CODE message` under the place.
#[track_caller]
fn check(marked: &str) {
    let (text, marks) = unmark(marked);
    let errors = found(&text);
    let shown: Vec<_> = errors.iter().map(|d| (d.span, format!("{} {}", d.code as u16, d.message))).collect();
    assert_eq!(shown, marks, "{text}\n{errors:#?}");
    assert!(errors.iter().all(|d| d.severity == Severity::Error), "{errors:#?}");
}

/// As [`check`] for items behind those of the world.
#[track_caller]
fn check_item(marked: &str) {
    check(&world(&format!("\n{marked}\n")));
}

#[test]
fn nothing() {
    for text in ["", "\u{feff}", "  \r\n", "// only\n/* a /* comment */ */", "/// and text"] {
        let (tree, errors) = parse_text(text, FileId(0));
        assert!(tree.is_none());
        assert_eq!(errors.len(), 1, "{text}");
        assert_eq!((errors[0].code, errors[0].span.start.column), (Code::Empty, 1));
    }
    let (_, errors) = parse_tokens(proc_macro2::TokenStream::new(), FileId(0));
    assert_eq!(errors[0].message, "the file contains no plant");
}

#[test]
fn header() {
    check("plant\n{ }\n~ 4 expected the name of the plant, found `{`");
    check("specification X { }\n~~~~~~~~~~~~~ 4 expected `plant`, found `specification`");
    check("plant input { }\n      ~~~~~ 5 expected the name of the plant, found the keyword `input`");
    check(
        "plant X\n{ automaton A { initial state B } } input C\n                                    ~~~~~ 4 expected the end of the file, found the keyword `input`",
    );
    check("plant X { automaton A { initial state B }\n        ~ 2 unclosed `{`");
    check(
        "plant X { input A € automaton B { initial state C [A] } }\n                  ~ 1 stray character `€`",
    );
}

#[test]
fn items_out_of_place() {
    check_item(
        "state A\n~~~~~ 4 expected an input, an output, an event, an automaton or a constraint, found `state`",
    );
    check_item("input A B\n        ~ 4 expected `,` or the next declaration, found `B`");
    check_item("input\noutput A\n~~~~~~ 5 expected the name of an input, found the keyword `output`");
    check_item("memory 1\n       ~ 4 expected the name of a memory bit, found `1`");
    check_item("output _a\n       ~~ 6 `_a` is not a name");
    check_item("range A in 0..=1\n        ~~ 4 expected `=` and an analogue input, found `in`");
    check_item("range A = B of 0..=1\n            ~~ 4 expected `in`, found `of`");
    check_item("range A = B in 0..1\n                ~~ 4 expected `..=` and the greatest value, found `..`");
    check_item("range A = B in C\n               ~ 4 expected the least value of the range, found `C`");
    check_item(
        "range A = B in 0..=99999999999999999999\n                   ~~~~~~~~~~~~~~~~~~~~ 8 `99999999999999999999` is no 64-bit integer",
    );
    check_item("controllable { }\n             ~ 4 expected the name of the event, found `{`");
    check_item("controllable a { Motor }\n                 ~~~~~ 4 expected `set` or `reset`, found `Motor`");
    check_item(
        "controllable a { set }\n                     ~ 4 expected the output or memory bit to set, found `}`",
    );
    check_item("automaton A [ ]\n            ~ 4 expected `{` and the states of the automaton, found `[`");
}

#[test]
fn states_out_of_place() {
    check_item("automaton A { initial B }\n                      ~ 4 expected `state`, found `B`");
    check_item(
        "automaton A { marked initial state B }\n                     ~~~~~~~ 4 expected `state`, found `initial`",
    );
    check_item(
        "automaton A { initial state B (Closed) }\n                              ~ 4 expected `[` and what inputs and outputs are in the state, found `(`",
    );
    check_item(
        "automaton A { initial state B [] }\n                               ~ 4 expected an input or output, found `]`",
    );
    check_item(
        "automaton A { initial state B { open } }\n                                     ~ 4 expected `->` and the next state, found `}`",
    );
    check_item(
        "automaton A { initial state B { -> B } }\n                                ~~ 4 expected an event, found `->`",
    );
    check_item(
        "automaton A { initial state B { open -> B open opens -> B } }\n                                               ~~~~~ 4 expected `->` and the next state, found `opens`",
    );
}

#[test]
fn constraints_out_of_place() {
    check_item(
        "constraint A open only when Door.Open\n             ~~~~ 4 expected `:` and what the constraint says, found `open`",
    );
    check_item(
        "constraint A: open when Door.Open\n                   ~~~~ 4 expected `only when` or `not when`, found `when`",
    );
    check_item(
        "constraint A: open only Door.Open\n                        ~~~~ 4 expected `when`, found `Door`",
    );
    check_item(
        "constraint A: never\ninput B\n~~~~~ 5 expected a state such as `Boom.Left`, found the keyword `input`",
    );
    check_item(
        "constraint A: never Door.Open.Wide\n                             ~ 4 expected an input, an output, an event, an automaton or a constraint, found `.`",
    );
}

#[test]
fn operators_of_other_languages() {
    #[track_caller]
    fn check(condition: &str, operator: &str) {
        let column = condition.find(operator).expect("the operator");
        let marks = format!("{}{}", " ".repeat(column), "~".repeat(operator.len()));
        check_item(&format!(
            "automaton A {{ initial state B [\n{condition}\n{marks} 4 `{operator}` is no operator of conditions\n] }}"
        ));
    }
    check("Closed and Opened", "and");
    check("Closed OR Opened", "OR");
    check("Closed xor Opened", "xor");
    check("Closed & Opened", "&");
    check("Closed * !Opened", "*");
    check("Closed + Opened", "+");
    check("Closed == Opened", "==");
    check("Closed != Opened", "!=");
    check("Heat > 3", ">");
    check("Closed && (Opened | Motor)", "|");
    check("not Closed", "not");
    check("Closed && NOT (Opened)", "not".to_uppercase().as_str());
}

#[test]
fn unknown_names() {
    check_item(
        "controllable a { set Moter }\n                     ~~~~~ 20 unknown output or memory bit `Moter`",
    );
    check_item(
        "automaton A { initial state B [Closde] }\n                               ~~~~~~ 20 unknown input or output `Closde`",
    );
    check_item(
        "automaton A { initial state B { opn -> B } }\n                                ~~~ 20 unknown event `opn`",
    );
    check_item(
        "automaton A { initial state B { open -> C } }\n                                        ~ 20 unknown state of `A`: `C`",
    );
    check_item("constraint A: opn only when Door.Open\n              ~~~ 20 unknown event `opn`");
    check_item(
        "constraint A: open only when Dor.Open\n                             ~~~ 20 unknown automaton `Dor`",
    );
    check_item(
        "constraint A: open only when Rest.Open\n                             ~~~~ 20 unknown automaton `Rest`",
    );
    check_item(
        "constraint A: open only when Door.Opn && Eye.Opn\n                                  ~~~ 20 unknown state of `Door`: `Opn`\n                                             ~~~ 20 unknown state of `Eye`: `Opn`",
    );
}

#[test]
fn an_unknown_name_is_told_once() {
    let errors =
        found(&world("automaton A { initial state B [Foo] { foo -> B } state C [!Foo] { foo -> B } }"));
    assert_eq!(errors.len(), 2, "{errors:#?}");
    for error in errors {
        assert_eq!(error.labels.len(), 1, "{error:#?}");
    }
}

#[test]
fn duplicates() {
    check_item("input Motor\n      ~~~~~ 21 input `Motor` is declared a second time");
    check_item("memory A, A\n          ~ 21 memory bit `A` is declared a second time");
    check_item("range Closed = Heat in 0..=1\n      ~~~~~~ 21 range `Closed` is declared a second time");
    check_item("input Heat, Heat\n            ~~~~ 21 input `Heat` is declared a second time");
    check_item("uncontrollable open\n               ~~~~ 21 event `open` is declared a second time");
    check_item(
        "automaton Eye { initial state B }\n          ~~~ 21 automaton `Eye` is declared a second time",
    );
    check_item(
        "constraint Eye: never Door.Open\n           ~~~ 21 constraint `Eye` is declared a second time",
    );
    check_item(
        "constraint automaton Door { initial state B }\n                     ~~~~ 21 constraint `Door` is declared a second time",
    );
    check_item(
        "automaton A { initial state B state B }\n                                    ~ 21 state `B` is declared a second time",
    );
}

#[test]
fn initial_states() {
    check_item("automaton A { state B state C }\n          ~ 120 the automaton `A` has no initial state");
    check_item(
        "automaton A { initial state B initial state C }\n                              ~~~~~~~ 120 the automaton `A` has a second initial state `C`",
    );
}

#[test]
fn no_states() {
    check_item("automaton A { }\n          ~ 126 the automaton `A` has no states");
    check_item("constraint automaton A { }\n                     ~ 126 the automaton `A` has no states");
    check("plant X { }\n      ~ 126 the plant `X` has no component");
    check(
        "plant X { constraint automaton A { initial state B } }\n      ~ 126 the plant `X` has no component",
    );
}

#[test]
fn nondeterminism() {
    check_item(
        "automaton A { initial state B { open -> B open -> C } state C }\n                                          ~~~~~~~~~ 121 `open` leads out of `B` a second time",
    );
    check_item(
        "automaton A { initial state B { open -> B, open -> B } }\n                                           ~~~~~~~~~ 121 `open` leads out of `B` a second time",
    );
}

#[test]
fn both_places_are_shown() {
    let errors = found(&world("automaton A { initial state B { open -> B open -> B } }"));
    assert_eq!(errors[0].labels.len(), 1);
    let errors = found(&world("input Motor"));
    assert_eq!(errors[0].labels[0].1, "first declared here");
}

#[test]
fn commands() {
    check_item(
        "controllable a { set Closed }\n                     ~~~~~~ 122 `Closed` is an input, which nobody can set or reset",
    );
    check_item(
        "controllable a { reset Hot }\n                       ~~~ 122 `Hot` is a range, which nobody can set or reset",
    );
    check_item(
        "controllable a { set Heat }\n                     ~~~~ 122 `Heat` is an analogue input, which nobody can set or reset",
    );
    check_item(
        "controllable a { set Lamp reset Lamp }\n                          ~~~~~~~~~~ 123 `Lamp` is set and reset by one event",
    );
    check_item(
        "uncontrollable a { set Lamp }\n                   ~~~~~~~~ 124 `a` is uncontrollable, so nothing is done to cause it",
    );
}

#[test]
fn analogue_inputs() {
    check_item(
        "automaton A { initial state B [Heat] }\n                               ~~~~ 125 `Heat` is an analogue input, not a Boolean",
    );
    check_item(
        "range A = Motor in 0..=1\n          ~~~~~ 125 `Motor` is an output, and a range is of an analogue input",
    );
    check_item(
        "range A = Hot in 0..=1\n          ~~~ 125 `Hot` is a range, and a range is of an analogue input",
    );
    check_item("range A = A in 0..=1\n          ~ 125 `A` is a range, and a range is of an analogue input");
    check_item("range A = Heat in 3..=-3\n                  ~~~~~~ 28 the range `3..=-3` contains no value");
    // That `Closed` is used as a Boolean is then wrong as well.
    let errors = found(&world("range A = Closed in 0..=1"));
    assert!(errors.iter().all(|d| d.code == Code::NotBoolean), "{errors:#?}");
}

#[test]
fn names_that_differ_by_case_only() {
    check_item("input motor\n      ~~~~~ 127 `motor` and `Motor` differ by case only");
    check_item("range HEAT = Heat in 0..=1\n      ~~~~ 127 `HEAT` and `Heat` differ by case only");
}

#[test]
fn conditions_about_the_wrong_things() {
    check_item(
        "automaton A { initial state B [Door.Open] }\n                               ~~~~~~~~~ 128 the formula of a state is about inputs and outputs, not about states",
    );
    check_item(
        "constraint A: open only when Sees\n                             ~~~~ 128 `Sees` is not a state with the name of its automaton",
    );
    check_item(
        "constraint A: never Closed\n                    ~~~~~~ 128 `Closed` is not a state with the name of its automaton",
    );
}

#[test]
fn a_mistake_hides_no_other() {
    check_item(
        "controllable a { sett Lamp }\n                 ~~~~ 4 expected `set` or `reset`, found `sett`\nautomaton A { initial state B [Closed Opened] { a -> B } }\n                                      ~~~~~~ 4 expected `]`, found `Opened`\nconstraint C: a only if Door.Open\n                     ~~ 4 expected `when`, found `if`\nconstraint D: never Door.Opn\n                         ~~~ 20 unknown state of `Door`: `Opn`",
    );
}

#[test]
fn too_deep() {
    let deep = |open: &str, close: &str| {
        format!("automaton A {{ initial state B [{}Closed{}] }}", open.repeat(200), close.repeat(200))
    };
    for text in [deep("(", ")"), deep("!", "")] {
        let errors = found(&world(&text));
        assert_eq!(errors.len(), 1, "{errors:#?}");
        assert_eq!(errors[0].code, Code::TooDeep);
    }
}

#[test]
fn too_many_states() {
    let states = |count: usize| (0..count).map(|i| format!("state S{i}\n")).collect::<String>();
    let text =
        |count: usize| format!("plant X {{ automaton A {{ initial state I\n{} }} }}", states(count - 1));
    let errors = |count: usize| {
        let mut found = found(&text(count));
        found.retain(|d| d.severity == Severity::Error);
        found
    };
    assert_eq!(errors(1 << 16), []);
    assert_eq!(errors((1 << 16) + 1)[0].code, Code::AutomatonTooLarge);
}
