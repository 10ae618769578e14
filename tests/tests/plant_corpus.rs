//! The plants of the corpus have the sizes that are known of them.

use synth_core::explore::Limits;
use synth_core::plant::{Plant, read, supervise, unreadable};
use synth_core::syntax::FileId;

#[track_caller]
fn plant(name: &str) -> Plant {
    let path = format!("{}/plants/{name}.plant", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).expect("the corpus is readable");
    let (plant, warnings) = read(&text, FileId(0)).expect("a plant");
    assert_eq!(warnings, []);
    plant
}

/// States and transitions of the plant, and of the closed loop.
#[track_caller]
fn check(name: &str, components: (u64, u64), closed: (usize, usize)) {
    let plant = plant(name);
    let feedback = supervise(&plant, &Limits::default()).expect("a feedback");
    assert_eq!(feedback.plant, Some(components), "{name}");
    assert_eq!((feedback.len(), feedback.edges.len()), closed, "{name}");
}

/// Ramadge and Wonham, 1989: with the buffer empty all nine states of the machines, with it full the three in which the
/// first one rests.
#[test]
fn workcell() {
    check("workcell", (9, 24), (12, 24));
}

/// Ramadge and Wonham, 1989.
#[test]
fn cat_and_mouse() {
    check("cat_and_mouse", (25, 70), (6, 9));
}

/// 2·5^(n-1) states with n machines.
#[test]
fn transfer_line() {
    check("transfer_line", (8, 24), (50, 112));
}

/// All but the two states in which everyone holds one fork.
#[test]
fn philosophers() {
    check("philosophers", (27, 63), (25, 57));
}

/// Côté, St-Denis and Kerjean, 2005.
#[test]
fn distribution_station() {
    check("distribution_station", (128, 512), (52, 123));
}

/// All but the eight in which the heater is on, and the tank nearly empty or being drained.
#[test]
fn tank() {
    check("tank", (24, 88), (16, 42));
}

/// All but the four in which the feeder pushes against a full chute.
#[test]
fn chute() {
    check("chute", (16, 32), (44, 80));
}

/// A vessel under two constraint automata, which relays and sensors do not show.
#[test]
fn mixer() {
    check("mixer", (1152, 4160), (144, 252));
}

#[test]
fn those_with_formulas_are_readable() {
    for name in ["distribution_station", "tank", "chute", "mixer"] {
        assert_eq!(unreadable(&plant(name)), [], "{name}");
    }
}
