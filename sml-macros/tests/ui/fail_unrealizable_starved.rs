//! What the system owes, it can never send.

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
        guarantee scenario Lights {
          button -> control.pressed()
          eventually control -> bulb.on()
        }
        guarantee scenario AfterRelease {
          button -> control.pressed()
          button -> control.released()
        } constraints [ forbidden control -> bulb.on() ignore button -> control.pressed() ]
      }
    }
}

fn main() {}
