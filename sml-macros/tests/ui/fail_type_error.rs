//! An integer where a truth value is due.

sml_macros::sml! {
    specification Lamp {
      domain lamp { class Bulb { lit: bool = 3 on() } class Button { } class Control { pressed() } }
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

fn main() {}
