//! Two objects of one name.

sml_macros::sml! {
    specification Lamp {
      domain lamp { class Bulb { on() } class Button { } class Control { pressed() } }
      object control: Control
      object bulb: Bulb
      object bulb: Button
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
