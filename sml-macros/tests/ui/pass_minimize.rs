//! A controller for one event at a time, beside another choice.
#![deny(warnings, missing_docs, unused)]

sml_macros::sml! { #![minimize = "ordered"] #![engine = "search"] "specs/lamp.sml" }

fn main() {
    let mut controller = lamp::Controller::new();
    let commands = controller.react(lamp::Event::ButtonControlPressed).expect("it fits");
    assert_eq!(commands.bulb, Some(lamp::BulbCommand::On));
}
