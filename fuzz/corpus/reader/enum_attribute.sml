// Cases by the literals of an enum; a single offered case is decided at once.
//
// For each of three colours: press, then turn 3: the next colour. One key for each case.
specification EnumAttribute {
  domain d { enum Colour { red, green, yellow } class Ctl { press() } class Light { colour: Colour = yellow } class User { } }
  object ctl: Ctl
  object light: Light
  object user: User
  controllable { Ctl }
  collaboration C {
    guarantee scenario Next {
      user -> ctl.press()
      alternative [light.colour == red] { urgent ctl -> light.setColour(green) }
      or [light.colour == green] { urgent ctl -> light.setColour(yellow) }
      or [light.colour == Colour:yellow] { urgent ctl -> light.setColour(red) }
    }
  }
}
