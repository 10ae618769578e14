//! An argument too many.

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
          urgent control -> bulb.on(1, 2)
        }
      }
    }
}

fn main() {}
