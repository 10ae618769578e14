// Constraints of a nested body hold while the cut is in it, and no longer.
//
// 0: start to 1, ok and stop to 0. 1 turn 3: one to 2. 2 in the nested body: start ends the copy and starts another, to 1; ok to 3;
// stop violates, to the lost state. 3 behind it, turn 3: two to 0.
specification NestedConstraints {
  domain d { class Ctl { start() ok() stop() } class Dev { one() two() } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  controllable { Ctl }
  collaboration C {
    guarantee scenario NoStopInside {
      user -> ctl.start()
      { urgent ctl -> dev.one()  user -> ctl.ok() } constraints [ forbidden user -> ctl.stop() ]
      urgent ctl -> dev.two()
    }
  }
}
