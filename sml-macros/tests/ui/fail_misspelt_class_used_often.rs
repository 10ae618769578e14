//! One cause, one error, however often the name is used.

sml_macros::sml! {
    specification Lamp {
      domain lamp {
        class Bulb { lit: bool next: Bulb level: 0..=3 on() dim(to: 0..=3) }
        class Button { }
        class Control { pressed() released() }
      }
      object control: Control
      object bulb: Bulb
      object button: Button
      controllable { Control }
      collaboration Lamp {
        dynamic role Blub some
        guarantee scenario Answers {
          button -> control.pressed()
          urgent control -> some.on()
          wait [some.lit]
        }
      }
    }
}

fn main() {}
