// A parallel in an alternative in a loop: a message of one branch decides the case, and the loop asks again when both branches
// are over.
//
// 0: ok to 1, start to 2, stop to 0 by the other case. 1 waits for start: start to 3. 2 turn 3, ok still to come: one to 4. 3
// turn 3: one to 0, both branches are over and the loop begins again. 4 waits for ok: ok to 0. What is ignored stays.
specification NestedAllWays {
  domain d { class Ctl { start() ok() stop() } class Dev { one() two() } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  controllable { Ctl }
  collaboration C {
    guarantee scenario Serve {
      while {
        alternative {
          parallel { user -> ctl.start()  urgent ctl -> dev.one() } and { user -> ctl.ok() }
        } or {
          user -> ctl.stop()
        }
      }
    } constraints [ ignore user -> ctl.start()  ignore user -> ctl.ok()  ignore user -> ctl.stop() ]
  }
}
