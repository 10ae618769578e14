// A message that is enabled in two branches moves the textually first only; it takes two events to pass both.
//
// 0: start to 1, ok to 0. 1: ok to 2 by the first branch. 2: ok to 3 by the second. 3 turn 3: one to 4. 4 turn 3: two to 0. In
// 1 and 2 start ends the copy and starts another, to 1.
specification MessageInTwoBranches {
  domain d { class Ctl { start() ok() stop() } class Dev { one() two() } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  controllable { Ctl }
  collaboration C {
    guarantee scenario Twice {
      user -> ctl.start()
      parallel { user -> ctl.ok() } and { user -> ctl.ok()  urgent ctl -> dev.one() }
      urgent ctl -> dev.two()
    }
  }
}
