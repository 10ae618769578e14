// Not realizable: each switching asks for the other at once, so no super step ends after the first press.
specification EndlessPair {
  domain d { class Ctl { press() release() tick() } class Lamp { on() off() blink() } class User { } }
  object ctl: Ctl
  object lamp: Lamp
  object user: User
  controllable { Ctl }
  collaboration C {
    guarantee scenario OnAfterOff {
      ctl -> lamp.off()
      urgent ctl -> lamp.on()
    }
    guarantee scenario OffAfterOn {
      ctl -> lamp.on()
      urgent ctl -> lamp.off()
    }
    guarantee scenario Starts {
      user -> ctl.press()
      urgent ctl -> lamp.on()
    }
  }
}
