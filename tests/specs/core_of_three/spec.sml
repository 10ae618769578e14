// Not realizable because of three guarantees, any two of which can be met; the fourth has nothing to do with it.
//
// After a press the lamp must go on and off, but being on is final until a release that nobody promises. Off first and
// then on does not help for ever: the user presses once more.
specification CoreOfThree {
  domain d { class Ctl { press() release() tick() } class Lamp { on() off() blink() } class User { } }
  object ctl: Ctl
  object lamp: Lamp
  object user: User
  controllable { Ctl }
  collaboration C {
    guarantee scenario GoesOn {
      user -> ctl.press()
      eventually ctl -> lamp.on()
    }
    guarantee scenario GoesOff {
      user -> ctl.press()
      eventually ctl -> lamp.off()
    }
    guarantee scenario OnIsFinal {
      ctl -> lamp.on()
      user -> ctl.release()
    } constraints [ forbidden ctl -> lamp.off() ]
    guarantee scenario Blinks {
      user -> ctl.tick()
      eventually ctl -> lamp.blink()
    }
  }
}
