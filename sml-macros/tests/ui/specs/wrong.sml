// Two mistakes: a name and a type.
specification Lamp {
  domain lamp { class Bulb { lit: bool on() } class Button { } class Control { pressed() } }
  object control: Control
  object bulb: Bulb { lit: 1 }
  object button: Button
  controllable { Control }
  collaboration Lamp {
    guarantee scenario Answers {
      button -> control.pressed()
      urgent control -> bulp.on()
    }
  }
}
