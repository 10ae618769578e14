//! A raw string is a path too, and a module may hold the module; braces do as well as parentheses.
#![deny(warnings)]

mod generated {
    sml_macros::sml! { r"specs/lamp.sml" }
    pub mod again {
        sml_macros::sml![r#"specs/../specs/lamp.sml"#];
    }
}

use generated::lamp;

fn main() {
    let mut controller = lamp::Controller::new();
    let commands = controller.react(lamp::Event::ButtonControlPressed).expect("it fits");
    assert_eq!(commands.bulb, Some(lamp::BulbCommand::On));
    let _: generated::again::lamp::Event = generated::again::lamp::Event::ButtonControlPressed;
}
