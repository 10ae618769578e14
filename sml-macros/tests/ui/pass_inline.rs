//! A user's crate that suffers no warnings.
#![deny(warnings, missing_docs, unreachable_pub, missing_debug_implementations, rust_2018_idioms, unused)]
#![forbid(unsafe_code)]

sml_macros::sml! {
    specification Lamp {
      domain lamp { class Bulb { on() } class Button { } class Control { pressed() } }
      object control: Control
      object bulb: Bulb
      object button: Button
      controllable { Control }
      collaboration Lamp {
        /// the lamp answers the button
        guarantee scenario Answers {
          button -> control.pressed()
          urgent control -> bulb.on()
        }
      }
    }
}

fn main() {
    let mut controller = lamp::Controller::new();
    let commands = controller.react(lamp::Event::ButtonControlPressed).expect("it fits");
    assert_eq!(commands.bulb, Some(lamp::BulbCommand::On));
}
