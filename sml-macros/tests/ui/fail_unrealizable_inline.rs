//! What one scenario makes urgent, another forbids.

sml_macros::sml! {
    specification Clash {
      domain press { class Motor { start() } class Button { } class Control { pressed() released() } }
      object control: Control
      object motor: Motor
      object button: Button
      controllable { Control }
      collaboration Clash {
        guarantee scenario StartsWhenPressed {
          button -> control.pressed()
          urgent control -> motor.start()
        }
        guarantee scenario NotWhileHeld {
          button -> control.pressed()
          button -> control.released()
        } constraints [ forbidden control -> motor.start() ignore button -> control.pressed() ]
      }
    }
}

fn main() {}
