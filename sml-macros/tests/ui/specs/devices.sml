specification Devices {
  domain lamp { class Bulb { on() } class Button { } class Control { pressed() } }
  object control: Control
  object bulb: Bulb
  object button: Button
}
