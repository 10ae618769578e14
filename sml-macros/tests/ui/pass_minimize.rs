//! A controller for one event at a time, beside another choice.
#![deny(warnings, missing_docs, unused)]

sml_macros::sml! { #![minimize = "ordered"] #![engine = "search"] "specs/lamp.sml" }
// The other half: which events are expected.
sml_macros::sml! { #![monitor] "specs/lamp.sml" }

fn main() {
    let mut monitor = lamp_monitor::Controller::new();
    assert_eq!(monitor.react(lamp_monitor::Event::ButtonControlPressed), Some(lamp_monitor::Commands {}));
    let mut controller = lamp::Controller::new();
    let commands = controller.react(lamp::Event::ButtonControlPressed).expect("it fits");
    assert_eq!(commands.bulb, Some(lamp::BulbCommand::On));
}
