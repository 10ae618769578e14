// The cases of an initial alternative are asked before the effects of the event that starts the copy.
//
// 0 closed: press to 1, the case for closed. 1 open, turn 3: two to 2. 2 open: press to 3, the case for open. 3 closed, turn 3:
// one to 0.
specification ConditionsBeforeEffects {
  domain d { class Ctl { open: bool  press() } class Dev { one() two() } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  effects { User -> Ctl.press() { receiver.open = !receiver.open } }
  controllable { Ctl }
  collaboration C {
    guarantee scenario Toggle {
      alternative [ctl.open] { user -> ctl.press()  urgent ctl -> dev.one() }
      or [!ctl.open] { user -> ctl.press()  urgent ctl -> dev.two() }
    }
  }
}
