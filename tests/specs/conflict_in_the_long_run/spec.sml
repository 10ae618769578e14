// Not realizable though nothing forbids anything: each guarantee can be met, but not both. One wants the lamp on some day
// after each press, the other wants it off for good: a lamp that goes on opens the obligation to tick it off, and nobody
// promises the tick.
specification ConflictInTheLongRun {
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
    guarantee scenario IsAcknowledged {
      ctl -> lamp.on()
      monitored eventually user -> ctl.tick()
    } constraints [ ignore ctl -> lamp.on() ]
  }
}
