// Arguments are those before the effects of the event, bindings those after them.
//
// Place of ctl: none in 0, left in 1, 3, 5, right in 2, 4, 6, 7. 0, 3, 4: start(left) or start(right); `After` is bound to the
// new place, `Before` starts if it is the old one. 1, 2: `After` alone, turn 3: one to 3, 4. 3: start(left) to 5, start(right)
// to 2. 4: start(left) to 1, start(right) to 6. 5: one of left to 3, and the `wait` of `Before` stays shut: it is ended as by
// another message. 6 both: to 2 or 7. 7: to 4.
specification ArgumentsBeforeEffects {
  domain d { class Ctl { at: Dev  start(dev: Dev) } class Dev { one() } class User { } }
  object ctl: Ctl
  object left: Dev
  object right: Dev
  object user: User
  effects { User -> Ctl.start(dev) { receiver.at = dev } }
  controllable { Ctl }
  collaboration C {
    dynamic role Dev dev
    guarantee scenario After bindings [ dev = ctl.at ] {
      user -> ctl.start(*)
      urgent ctl -> dev.one()
    }
    guarantee scenario Before {
      user -> ctl.start(ctl.at)
      wait [ctl.at == right]
      urgent ctl -> left.one()
    }
  }
}
