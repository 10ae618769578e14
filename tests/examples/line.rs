//! Prints the production line of the corpus with so many presses: `line PRESSES`. Its state space grows by a factor of
//! about 14 with each.

use std::fmt::Write as _;

const TWO_PRESSES: &str = include_str!("../specs/line_2/spec.sml");

fn main() -> Result<(), String> {
    let presses: usize = std::env::args().nth(1).and_then(|n| n.parse().ok()).ok_or("usage: line PRESSES")?;
    print!("{}", line(presses).ok_or("the specification of two presses has changed")?);
    Ok(())
}

/// The specification of two presses with other objects.
fn line(presses: usize) -> Option<String> {
    let first = TWO_PRESSES.find("  object feedBelt")?;
    let behind = TWO_PRESSES.find("  effects {")?;
    let mut text = TWO_PRESSES[..first].to_owned();
    let place = |i: usize| match i {
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
    Some(text)
}
