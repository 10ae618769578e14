// Not realizable: the guarantee waits for an event that the environment may keep to itself.
specification AnswerWithheld {
  domain d { class Ctl { press() release() tick() } class Lamp { on() off() blink() } class User { } }
  object ctl: Ctl
  object lamp: Lamp
  object user: User
  controllable { Ctl }
  collaboration C {
    guarantee scenario Releases {
      user -> ctl.press()
      urgent ctl -> lamp.on()
      monitored eventually user -> ctl.release()
      urgent ctl -> lamp.off()
    }
  }
}
