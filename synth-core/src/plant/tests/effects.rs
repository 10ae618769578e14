//! What is read after commands; and events that are never enabled.

use super::corpus;
use crate::diagnostic::{Diagnostic, Severity};
use crate::explore::Limits;
use crate::plant::{read, supervise, unreadable, warnings};
use crate::syntax::FileId;
use crate::syntax::tests::unmark;

const SIGNALS: &str =
    "output Y, Z input A, B range L = V in 0..=9 range H = V in 21..=30 uncontrollable a uncontrollable b";

/// Errors about readable states; if there are none, the warnings about the plant under its feedback.
fn found(text: &str) -> Vec<Diagnostic> {
    let (plant, _) = read(text, FileId(0)).expect("a plant");
    let errors = unreadable(&plant);
    if !errors.is_empty() {
        return errors;
    }
    warnings(&plant, &supervise(&plant, &Limits::default()).expect("a feedback"))
}

/// What is found in the plant of these items is marked, each `~~~~ CODE message` under the place.
#[track_caller]
fn check(marked: &str) {
    let (text, marks) = unmark(&format!("plant X {{ {SIGNALS}\n{marked}\n}}"));
    let found = found(&text);
    let shown: Vec<_> = found.iter().map(|d| (d.span, format!("{} {}", d.code as u16, d.message))).collect();
    assert_eq!(shown, marks, "{text}\n{found:#?}");
    for one in &found {
        let is_warning = matches!(one.code as u16, 138 | 139 | 144 | 148);
        assert_eq!(one.severity == Severity::Warning, is_warning);
        assert!(one.help.is_some(), "{one:#?}");
    }
}

/// The texts below the message of the only thing that is found: labels, notes, help.
#[track_caller]
fn below(items: &str, expect: &[&str]) {
    let found = found(&format!("plant X {{ {SIGNALS} {items} }}"));
    assert_eq!(found.len(), 1, "{found:#?}");
    let Diagnostic { labels, notes, help, .. } = &found[0];
    let labels = labels.iter().map(|(_, label)| label.as_str());
    let shown: Vec<&str> =
        labels.chain(notes.iter().map(String::as_str)).chain(help.iter().map(String::as_str)).collect();
    assert_eq!(shown, expect);
}

#[test]
fn the_target_contradicts() {
    check(
        "controllable e { set Y } automaton M { initial state S [A]\n{ e -> T }\n  ~~~~~~ 136 `e` leads to `T`, and `set Y` makes its formula false\nstate T [!A && !Y] }",
    );
    check(
        "controllable e { reset Y } automaton M { initial state S [!Y]\n{ e -> T }\n  ~~~~~~ 136 `e` leads to `T`, and `reset Y` makes its formula false\nstate T [Y] }",
    );
    check(
        "controllable e { set Y set Z } automaton M { initial state S [!Y && !Z]\n{ e -> T }\n  ~~~~~~ 136 `e` leads to `T`, and what it commands makes its formula false\nstate T [Y && !Z || !Y && Z] }",
    );
    // A state that is kept is read, too.
    check(
        "controllable e { reset Y } automaton M { initial state S [Y]\n{ e -> S }\n  ~~~~~~ 136 `e` leads to `S`, and `reset Y` makes its formula false\nstate T [!Y] }",
    );
    below(
        "controllable e { set Y } automaton M { initial state S [A] { e -> T } state T [!A && !Y] }",
        &["never read after it", "commands this", "write `reset Y` in `e`, or `Y` in the formula of `T`"],
    );
}

#[test]
fn the_source_is_still_read() {
    // A sensor that answers later.
    check(
        "controllable e { set Y } automaton M { initial state S [!A]\n{ e -> T }\n  ~~~~~~ 137 `e` has fired, and `M` is still read as `S`\nstate T [A] }",
    );
    check(
        "controllable e { set Y } automaton M { initial state S [!A || !Y]\n{ e -> T }\n  ~~~~~~ 137 `e` has fired, and `M` is still read as `S`\nstate T [A && Y] }",
    );
    // A command that another component has already been given.
    check(
        "controllable e { set Y } automaton M { initial state S [L]\n{ e -> T }\n  ~~~~~~ 137 `e` has fired, and `M` is still read as `S`\nstate T [H] }",
    );
    below(
        "controllable e { set Y } automaton M { initial state S [!A] { e -> T } state T [A] }",
        &[
            "read before it",
            "its formula holds with all commands given, where `!A`",
            "whatever may happen in `S` could follow in the same scan, even if it must not in `T`",
            "add `!Y` to the formula of `S`, and let that of `T` hold as soon as `Y` is set",
        ],
    );
}

/// Each component that takes part has to show it.
#[test]
fn shared_events() {
    check(
        "controllable e { set Y } automaton M { initial state S [!Y] { e -> T } state T [Y] } automaton N { initial state U [!A]\n{ e -> W }\n  ~~~~~~ 137 `e` has fired, and `N` is still read as `U`\nstate W [A] }",
    );
    check(
        "controllable e { set Y set Z } automaton M { initial state S [!Y] { e -> T } state T [Y] } automaton N { initial state U [!Z] { e -> W } state W [Z] }",
    );
}

/// Only constraints can make the program do something about an event without commands.
#[test]
fn events_without_commands() {
    let machine = "controllable e automaton M { initial state S [!A]";
    check(&format!("{machine} {{ e -> T }} state T [A] }}"));
    check(&format!(
        "{machine}\n{{ e -> T }}\n  ~~~~~~ 137 `e` has fired, and `M` is still read as `S`\nstate T [A] }} constraint automaton C {{ initial state K {{ e -> K }} }}"
    ));
    // Nothing changes, and nothing has to be seen.
    check("controllable e automaton M { initial state S [A] { e -> S a -> T } state T [!A] }");
}

#[test]
fn another_state_is_read() {
    check(
        "controllable e { set Y } automaton M { initial state S [!Y && A]\n{ e -> T }\n  ~~~~~~ 137 `e` leads to `T`, but right after it `U` is read\nstate T [Y && !A] { a -> U } state U [Y && A] }",
    );
    check(
        "controllable e { set Y } controllable f { set Z } automaton M { initial state S [!Y && !Z]\n{ e -> T f -> U }\n  ~~~~~~ 138 right after `e`, `U` may be read instead of `T`\nstate T [Y && !Z && !A] state U [Z || Y && A] }",
    );
    // The sensor may have answered already.
    check(
        "controllable e { set Y } automaton M { initial state S [!Y] { e -> T } state T [Y && !A] { a -> U } state U [Y && A] }",
    );
}

#[test]
fn nothing_is_read() {
    check(
        "controllable e { set Y } automaton M { initial state S [!Y && !A]\n{ e -> T }\n  ~~~~~~ 138 after `e`, `T` is not read until the plant moves\nstate T [Y && A] }",
    );
}

/// A component without an edge for an event must not change because of its commands, unless it might do so by itself.
#[test]
fn who_does_not_take_part() {
    let valve = "automaton V { initial state Shut [!Y] { e -> Open } state Open [Y] }";
    check(&format!(
        "controllable\ne\n~ 138 `e` takes `F` from `Dry` to `Wet` as they are read\n{{ set Y }} {valve} automaton F {{ initial state Dry [!Y || !A] state Wet [Y && A] {{ a -> Dry }} }}"
    ));
    check(&format!(
        "controllable e {{ set Y }} {valve} automaton F {{ initial state Dry [!Y || !A] {{ a -> Wet }} state Wet [Y && A] }}"
    ));
    // Where the feedback never enables it, it changes nothing.
    check(&format!(
        "controllable\ne\n~ 144 `e` is never enabled\n{{ set Y }} {valve} automaton F {{ initial state Dry [!Y || !A] state Wet [Y && A] {{ a -> Dry }} }} constraint C: e not when V.Shut"
    ));
}

/// The plant changes inputs only.
#[test]
fn what_the_plant_does_is_seen() {
    check(
        "controllable e { set Y } automaton M { initial state S [!Y] { e -> T } state T [Y]\n{ a -> S }\n  ~~~~~~ 139 nobody sees `a` lead from `T` to `S`\n}",
    );
    check("automaton M { initial state S [A] { a -> T } state T [!A] { b -> S } }");
    check("automaton M { initial state S [L] { a -> T } state T [H] { b -> S } }");
    check("automaton M { initial state S [!Y && A] { a -> T } state T [(Y || B) && !A] { b -> S } }");
    check(
        "controllable e { set Y } automaton M { initial state S [!Y && A]\n{ e -> T a -> U }\n         ~~~~~~ 139 nobody sees `a` lead from `S` to `U`\nstate T [Y && A] state U [Y && !A] }",
    );
}

#[test]
fn never_enabled() {
    let lamp = "{ set Y } controllable off { reset Y } automaton M { initial state Off [!Y && !A] { on -> On } state On [Y && !A] { a -> Lit } state Lit [Y && A] { off -> Dim } state Dim [!Y && A] { b -> Off } }";
    check(&format!("controllable on {lamp}"));
    check(&format!("controllable on {lamp} constraint C: off only when M.Lit"));
    check(
        "controllable on { set Y } controllable\noff\n~~~ 144 `off` is never enabled\n{ reset Y } automaton M { initial state Off [!Y] { on -> On } state On [Y] { off -> Off } } constraint C: off only when M.Off",
    );
    below(
        "controllable on { set Y } controllable off { reset Y } automaton M { initial state Off [!Y] { on -> On } state On [Y] { off -> Off } } constraint C: off only when M.Off",
        &[
            "forbids it in 1 of them",
            "it is possible in one entry, and inhibited there",
            "weaken the constraints, or remove the event",
        ],
    );
    // What its components never allow, and what no component names.
    below(
        "controllable on { set Y } automaton M { initial state Off [!Y] state On [Y] { on -> On } }",
        &[
            "never reached",
            "`M` never gets to `On` under the feedback",
            "look at what leads there, or remove the event",
        ],
    );
    below(
        "controllable on { set Y } automaton M { initial state Off [!Y] } constraint automaton C { initial state K { on -> K } }",
        &["no component names it", "add its edges to a component, or remove it"],
    );
    below(
        "controllable on { set Y } automaton M { initial state Off [!Y] { on -> On } state On [Y] } constraint C: never M.On",
        &[
            "it is possible in one entry, and inhibited there",
            "in 1 of them because of what would follow, such as: `C` would be violated",
            "weaken the constraints, or remove the event",
        ],
    );
}

/// A valve that opens and shuts as it is told, and says nothing of it.
const VALVE: &str = "{ set Y } controllable shut { reset Y } automaton V { initial state Shut [!Y] { open -> Open } state Open [Y] { shut -> Shut } }";

#[test]
fn circles() {
    check(&format!("controllable\nopen\n~~~~ 148 `open` and `shut` undo each other without end\n{VALVE}"));
    below(
        &format!("controllable open {VALVE}"),
        &[
            "is given in turn with it",
            "for example from V.Shut",
            "let one of them wait for an input, or forbid it by a constraint",
        ],
    );
    // Something of the plant lies in between, or it is forbidden.
    let sensor = "automaton S { initial state Dry [!A] { a -> Wet } state Wet [A] { b -> Dry } }";
    check(&format!(
        "controllable open {VALVE} {sensor} constraint C: open only when S.Dry constraint D: shut only when S.Wet"
    ));
    // Both while it is wet: this is found wherever it is.
    check(&format!(
        "controllable\nopen\n~~~~ 148 `open` and `shut` undo each other without end\n{VALVE} {sensor} constraint C: open only when S.Wet"
    ));
    // Of three that take turns, all are named; what leads back to where it began is no circle.
    check(
        "controllable\nx\n~ 148 `x`, `y` and `z` undo each other without end\n{ set Y } controllable y { set Z } controllable z { reset Y reset Z } automaton M { initial state S [!Y && !Z] { x -> T } state T [Y && !Z] { x -> T, y -> U } state U [Z] { z -> S } }",
    );
    // Two circles by themselves.
    check(&format!(
        "controllable\nopen\n~~~~ 148 `open` and `shut` undo each other without end\n{VALVE} controllable\nup\n~~ 148 `up` and `down` undo each other without end\n{{ set Z }} controllable down {{ reset Z }} automaton L {{ initial state Low [!Z] {{ up -> High }} state High [Z] {{ down -> Low }} }}"
    ));
}

#[test]
fn the_corpus() {
    for (path, text) in corpus().iter().filter(|(_, text)| text.contains('[')) {
        let shown: Vec<String> = found(text).into_iter().map(|one| one.message).collect();
        // Its valves and its heater are a machine's to switch, and nothing says when.
        let pairs: &[[&str; 2]] = match path.ends_with("tank.plant") {
            true => &[["open", "close"], ["drain", "keep"], ["heat", "cool"]],
            false => &[],
        };
        let expect = pairs.iter().map(|[a, b]| format!("`{a}` and `{b}` undo each other without end"));
        assert_eq!(shown, expect.collect::<Vec<_>>(), "{path}");
    }
}
