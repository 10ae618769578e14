// Turns 1, 2 and 3 in this order.
//
// 0: start to 1. 1 turn 1: lock to 2. 2 turn 2, since the environment's committed event comes before the system's urgent one:
// confirm to 3. 3 turn 3: go to 0.
specification CommittedBothSides {
  domain d { class Ctl { start() confirm() } class Dev { lock() go() } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  controllable { Ctl }
  non-spontaneous events { Ctl.confirm }
  collaboration C {
    assumption scenario Confirms { user -> ctl.start()  committed user -> ctl.confirm() }
    guarantee scenario LocksThenGoes {
      user -> ctl.start()
      committed ctl -> dev.lock()
      urgent ctl -> dev.go()
    }
  }
}
