//! Three mistakes in three scenarios, each at its own token.

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
        guarantee scenario Answers {
          button -> control.pressed()
          urgent control -> bulb.dim(4)
        }
        guarantee scenario Waits {
          button -> control.pressed()
          wait [bulb.level]
        }
        assumption scenario Promises {
          button -> control.pressed()
          urgent control -> bulb.on()
        }
      }
    }
}

fn main() {}
