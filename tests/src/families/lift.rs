//! The elevator of the corpus with any number of floors and cabins.

use std::fmt::Write as _;

const THREE_FLOORS: &str = include_str!("../../specs/elevator_3/spec.sml");

/// One cabin. The game has [`states`] states and [`transitions`] transitions.
#[must_use]
pub fn lift(floors: u32) -> String {
    cabins(floors, 1)
}

/// So many cabins, any of which serves a call.
///
/// # Panics
///
/// If the specification of three floors is written differently.
#[must_use]
pub fn cabins(floors: u32, cabins: u32) -> String {
    let numbers = 1..=cabins;
    let mut objects = String::new();
    for floor in 1..=floors {
        let _ = writeln!(objects, "  object floor{floor}: Floor {{ level: {floor} }}");
    }
    for cabin in numbers.clone() {
        let _ = writeln!(objects, "  object lift{cabin}: Lift");
    }
    let here = |cabin| format!("(lift{cabin}.level == floor.level && !lift{cabin}.moving)");
    let some_is_here = numbers.clone().map(here).collect::<Vec<_>>().join(" || ");
    let (before, first, behind) = between(THREE_FLOORS, "  object floor1", "  effects {");
    assert!(first.lines().count() == 4, "three floors and a cabin");
    let mut text = format!("{before}{objects}{behind}");
    let (before, moves, behind) =
        between(&text, "    guarantee scenario Move_", "    assumption scenario GoesUp");
    let moves: String = numbers.map(|cabin| moves.replace("lift1", &format!("lift{cabin}"))).collect();
    text = format!("{before}{moves}{behind}");
    for (old, new) in [
        ("3 floors and 1 cabin(s)", &*format!("{floors} floors and {cabins} cabin(s)")),
        ("1..=3", &format!("1..={floors}")),
        ("level < 3", &format!("level < {floors}")),
        ("(lift1.level == floor.level && !lift1.moving)", &some_is_here),
    ] {
        assert!(text.contains(old), "`{old}`");
        text = text.replace(old, new);
    }
    text
}

/// What stands before `begin`, from there to before `end`, and from there on.
fn between<'t>(text: &'t str, begin: &str, end: &str) -> (&'t str, &'t str, &'t str) {
    let find = |what: &str| text.find(what).unwrap_or_else(|| panic!("`{what}`"));
    let (begin, end) = (find(begin), find(end));
    (&text[..begin], &text[begin..end], &text[end..])
}

/// States of the game of one cabin.
#[must_use]
pub fn states(floors: u32) -> u64 {
    let (floors, sets) = (u64::from(floors), 1 << floors);
    2 * (floors - 1) * sets + 3 * floors * sets / 2
}

/// Transitions of the game of one cabin.
#[must_use]
pub fn transitions(floors: u32) -> u64 {
    let (floors, sets) = (u64::from(floors), 1 << floors);
    (5 * floors * floors + 13 * floors - 12) * sets / 4
}
