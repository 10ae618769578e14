// Two branches in any order.
//
// 0: start to 1. 1 turn 3: one to 2, two to 3. 2: two to 0. 3: one to 0.
specification ParallelBranches {
  domain d { class Ctl { start() } class Dev { one() two() } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  controllable { Ctl }
  collaboration C {
    guarantee scenario Both {
      user -> ctl.start()
      parallel { urgent ctl -> dev.one() } and { urgent ctl -> dev.two() }
    }
  }
}
