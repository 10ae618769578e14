//! Tokens of Rust that SML has not.

sml_macros::sml! {
    specification Lamp {
      domain lamp { class Bulb { on() } class Button { } class Control { pressed() } }
      object control: Control
      object r#bulb: Bulb { lit: 0x1F }
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

fn main() {}
