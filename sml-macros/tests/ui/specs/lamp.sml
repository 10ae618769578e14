// A lamp that answers a button.
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
      urgent control -> bulb.on()
    }
  }
}
