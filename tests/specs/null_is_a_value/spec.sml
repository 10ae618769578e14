// A variable that holds `null` has a value: no event equals it, so the first scenario forbids nothing and the second
// everything.
//
// 0: met twice to 0, start to 1. 1 turn 3, `other` is null and forbids no met: one to 2. 2: met would break the assumption, in
// which `other` has no value; start ends both copies and starts the first again, to 1.
specification NullIsAValue {
  domain d { class Ctl { start() met(dev: Dev) } class Dev { peer: Dev  one() } class User { } }
  object ctl: Ctl
  object left: Dev
  object right: Dev { peer: left }
  object user: User
  controllable { Ctl }
  collaboration C {
    guarantee scenario Holds {
      var Dev other = left.peer
      user -> ctl.start()
      urgent ctl -> left.one()
      user -> ctl.start()
    } constraints [ forbidden user -> ctl.met(other) ]
    assumption scenario Unset {
      var Dev other
      ctl -> left.one()
      user -> ctl.start()
    } constraints [ forbidden user -> ctl.met(other) ]
  }
}
