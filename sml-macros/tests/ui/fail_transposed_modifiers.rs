//! The modality before `strict`.

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
          eventually strict control -> bulb.on()
        }
      }
    }
}

fn main() {}
