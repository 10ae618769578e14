//! Names that are keywords in Rust need no `r#` here.

sml_macros::sml! {
    specification Lamp {
      domain lamp { class Bulb { on() } class Button { } class Control { pressed() } }
      object control: Control
      object r#bulb: Bulb { lit: true }
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
