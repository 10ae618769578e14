//! An attribute chooses how rows are found, in front of a path or of a specification.
#![deny(warnings, missing_docs, unused)]

sml_macros::sml! { #![engine = "runs"] "specs/lamp.sml" }

fn main() {
    let mut controller = lamp::Controller::new();
    let commands = controller.react(lamp::Event::ButtonControlPressed).expect("it fits");
    assert_eq!(commands.bulb, Some(lamp::BulbCommand::On));
}
