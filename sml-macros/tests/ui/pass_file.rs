//! A file, its path relative to the package.
#![deny(warnings, missing_docs, unused)]

sml_macros::sml!("specs/lamp.sml");

fn main() {
    let mut controller = lamp::Controller::new();
    let commands = controller.react(lamp::Event::ButtonControlPressed).expect("it fits");
    assert_eq!(commands.bulb, Some(lamp::BulbCommand::On));
}
