// The condition of a case is asked when the cut reaches it, and not again while the copy stands before it.
//
// Dev is busy from 2 on. 0: start to 1, ok and stop to 0. 1 turn 3: two cases, set busy to 2. 2: ok to 3, still offered; stop
// to 4. 3 turn 3: one to 5. 4: start to 6, where stop alone is offered. 5: no start before a stop: stop to 4, ok to 5. 6 turn
// 3: to 7. 7: stop to 4; ok, another message, ends the copy, to 5.
specification ConditionWhenReached {
  domain d { class Ctl { start() ok() stop() } class Dev { busy: bool  one() two() } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  controllable { Ctl }
  collaboration C {
    guarantee scenario Choose {
      user -> ctl.start()
      alternative [!dev.busy] { user -> ctl.ok()  urgent ctl -> dev.one() } or { user -> ctl.stop() }
    }
    guarantee scenario Busy { user -> ctl.start()  urgent ctl -> dev.setBusy(true) }
    assumption scenario Once { user -> ctl.start()  user -> ctl.stop() } constraints [ forbidden user -> ctl.start() ]
  }
}
