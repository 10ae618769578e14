//! The production line of the corpus with any number of presses.

use std::fmt::Write as _;

const TWO_PRESSES: &str = include_str!("../../specs/line_2/spec.sml");

/// The specification of two presses with other objects. Its state space grows by a factor of about 14 with each press.
///
/// # Panics
///
/// If the specification of two presses has no objects and effects any more.
#[must_use]
pub fn line(presses: u32) -> String {
    let find = |text: &str| TWO_PRESSES.find(text).expect("the specification of two presses has it");
    let (first, behind) = (find("  object feedBelt"), find("  effects {"));
    let mut text = TWO_PRESSES[..first].to_owned();
    let place = |i: u32| match i {
        0 => "feedBelt".to_owned(),
        i if i > presses => "depositBelt".to_owned(),
        i => format!("press{i}"),
    };
    for i in 0..=presses {
        let _ =
            writeln!(text, "  object {}: Location {{ keeps: {}, unloader: arm{} }}", place(i), i > 0, i + 1);
    }
    text.push_str("  object depositBelt: Location { keeps: false }\n");
    for i in 0..=presses {
        let (from, to) = (place(i), place(i + 1));
        let arm = i + 1;
        let _ = writeln!(
            text,
            "  object arm{arm}: RobotArm {{ source: {from}, target: {to}, location: {from} }}"
        );
    }
    text.push_str(&TWO_PRESSES[behind..]);
    text
}
